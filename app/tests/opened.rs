//! Inputs of units as inputs of responses, linear models and FMUs.

use std::fs;

use crate::cli::{answer, assert_refused, text};
use crate::shaken::{self, DAMPING, MASS, STIFFNESS};

const MORE: &str = "[outputs]\nway = \"body.x\"\n[run]\nuntil = 1.0\npoints = 11\n";

#[test]
fn an_input_of_a_unit_excites_whether_it_is_a_number_or_an_expression() {
    let folder = tempfile::tempdir().expect("a folder");
    let forces = [
        ("16 [N]", "shaker.force", 16.0),
        ("-2 [kN]", "shaker.force", -2000.0),
        ("3 [N]*sin(5 [Hz]*t)", "added_to_shaker_force", 0.0),
        ("-5 [N/m]*body.x", "added_to_shaker_force", 0.0),
    ];
    for (force, parameter, value) in forces {
        let [scene, out] = ["a.toml", "a.csv"].map(|name| folder.path().join(name));
        fs::write(&scene, shaken::scene(force, MORE)).expect("written");
        let at = ["--at", "initial"];
        let response = ["response", text(&scene), "--input", "shaker.force", "--output", "way"];
        let range = ["--range", "5..80", "--points", "7", "--out", text(&out)];
        let said = answer(&[&response[..], &range, &at].concat());
        assert!(said.contains(&format!("way answers {parameter}")), "{force}: {said}");
        // The feedback of an expression stays.
        let stiffness = if force.contains("body.x") { STIFFNESS + 5.0 } else { STIFFNESS };
        let rows = fs::read_to_string(&out).expect("a table");
        for row in rows.lines().skip(1) {
            let numbers: Vec<f64> =
                row.split(',').map(|number| number.parse().expect("a number")).collect();
            let [omega, amplitude, ..] = numbers[..] else { panic!("{row}") };
            let exact = 1.0 / (stiffness - MASS * omega * omega).hypot(DAMPING * omega);
            assert!((amplitude / exact - 1.0).abs() < 1e-9, "{force}, {omega}: {amplitude}");
        }
        assert_eq!(rows.lines().count(), 8);
        let linear = ["linearize", text(&scene), "--inputs", "shaker.force", "--outputs", "way"];
        let model = answer(&[&linear[..], &at].concat());
        assert!(model.contains(&format!("B       {parameter}")), "{model}");
        let fmu = folder.path().join("a.fmu");
        let export = ["fmu", text(&scene), "--source", "--inputs", "shaker.force"];
        answer(&[&export[..], &["--out", text(&fmu)]].concat());
        let files = crate::fmu::unpacked(&fs::read(&fmu).expect("an archive"));
        let (_, archive) = files.into_iter().next().expect("a description");
        let archive = String::from_utf8(archive).expect("a text");
        let start = format!("name=\"{parameter}\"");
        let variable = archive.lines().find(|line| line.contains(&start)).expect("a variable");
        assert!(variable.contains("causality=\"input\""), "{variable}");
        assert!(variable.contains(&format!("start=\"{value:?}\"")), "{variable}");
    }
    let scene = folder.path().join("a.toml");
    let wrong = ["response", text(&scene), "--input", "shaker.forc", "--output", "way"];
    assert_refused(&wrong, &["no parameter or coordinate `shaker.forc`"]);
}

//! Improvement of designs, and modes with their derivatives, from the command line.

use std::fs;

use crate::cli::{answer, assert_refused, machinist};
use crate::process::{output, said};

const VARIED: &str = "coupling.stiffness=5e3..1e5,coupling.damping=10..500";

#[test]
fn a_design_is_improved_within_a_limit_and_written_as_a_scene() {
    let folder = tempfile::tempdir().expect("a folder");
    let [out, plot] =
        ["improved.toml", "both.svg"].map(|name| folder.path().join(name).display().to_string());
    let limit = "max(abs(coupling_torque)) <= 950 [N m]";
    let asked = ["improve", "saw_gin", "--until", "0.5", "--minimise", "max(abs(twist))"];
    let asked = [&asked[..], &["--subject-to", limit, "--parameters", VARIED]].concat();
    let text = answer(&[&asked[..], &["--out", &out, "--plot", &plot]].concat());
    assert!(text.contains("converged"), "{text}");
    assert!(text.contains(limit) && text.contains("improved"), "{text}");
    assert!(fs::read_to_string(&plot).expect("a plot").contains("twist, improved"));
    let json = answer(&[&asked[..], &["--json"]].concat());
    let json: serde_json::Value = serde_json::from_str(&json).expect("JSON");
    let found = json["parameters"][0]["value"].as_f64().expect("a number");
    assert_eq!(json["limits"][0]["is_met"], true);
    let objective = &json["objective"];
    assert!(objective["after"].as_f64() < objective["before"].as_f64(), "{json}");
    // The scene written gives the reported result.
    let csv = answer(&["run", &out, "--until", "0.5", "--columns", "twist", "--out", "-"]);
    let twists = csv.lines().skip(1).filter_map(|line| line.split(',').nth(1)?.parse().ok());
    let largest = twists.fold(0.0_f64, |most, twist: f64| most.max(twist.abs()));
    let told = objective["after"].as_f64().expect("a number");
    assert!((largest / told - 1.0).abs() < 1e-3, "{largest} for {told}");
    assert!(fs::read_to_string(&out).expect("a scene").contains("stiffness"), "{found}");
    // The original scene is never overwritten.
    let over = ["improve", &out, "--minimise", "max(twist)", "--parameters", VARIED, "--out", &out];
    assert_refused(&over, &["would overwrite"]);
}

#[test]
fn limits_that_cannot_be_met_are_told_and_the_exit_code_says_so() {
    let asked = ["improve", "saw_gin", "--until", "0.3", "--minimise", "coupling.stiffness"];
    let limit = "max(abs(coupling_torque)) <= 1";
    let more = ["--subject-to", limit, "--parameters", VARIED];
    let output = output(machinist(&[&asked[..], &more].concat()));
    assert_eq!(output.status.code(), Some(1));
    let told = said(&output);
    assert!(told.contains("found no values that satisfy") && told.contains(limit), "{told}");
    assert!(String::from_utf8_lossy(&output.stdout).contains("not met"));
}

#[test]
fn what_is_asked_wrongly_is_refused_with_its_place() {
    let of = |objective: &str, said: &[&str]| {
        let asked = ["improve", "saw_gin", "--parameters", VARIED, "--minimise", objective];
        assert_refused(&asked, said);
    };
    of("max(coupling_torqe)", &["did you mean `coupling_torque`"]);
    of("twist", &["changes over time", "max(twist)"]);
    of("max(twist", &["closing parenthesis"]);
    of("max(twist) + max(coupling_torque)", &["the other operand"]);
    of("sin(coupling.stiffness)", &["dimensionless"]);
    of("maxx(twist)", &["did you mean `max`"]);
    let with = |more: &[&str], said: &[&str]| {
        let asked = ["improve", "saw_gin", "--minimise", "max(twist)"];
        assert_refused(&[&asked[..], more].concat(), said);
    };
    with(&["--parameters", "coupling.stiffness=5..1"], &["invalid bounds"]);
    with(&["--parameters", "coupling.stifness"], &["coupling.stiffness"]);
    let varied = ["--parameters", VARIED];
    let limit = |text: &'static str| [&varied[..], &["--subject-to", text]].concat();
    with(&limit("max(twist) <= 3 [s]"), &["the other operand"]);
    with(&limit("max(twist) <= 3 [rods]"), &["not a unit of measure"]);
    with(&limit("max(twist) = 3"), &["`<=` or `>=`"]);
    with(&[&varied[..], &["--out", "x.csv"]].concat(), &[".toml"]);
    with(&[&varied[..], &["--method", "bdf"]].concat(), &["does not carry"]);
    assert_refused(&["improve", "saw_gin", "--parameters", VARIED], &["--minimise or --maximise"]);
}

/// Mass on a spring, with one position shown in three units.
const SHOWN: &str = r#"
    [scene]
    name = "shown"
    [units.m]
    unit = "mass_on_spring"
    [initial]
    "m.x" = "20 [mm]"
    [outputs]
    x = { expression = "m.x", unit = "mm" }
    y = { expression = "m.x", unit = "cm" }
    si = "m.x"
    [run]
    until = 2
    points = 201
    [define.mass_on_spring.coordinates]
    x = { unit = "m" }
    [define.mass_on_spring.parameters]
    mass = { value = 2.0, unit = "kg" }
    stiffness = { value = 50.0, unit = "N/m" }
    damping = { value = 2.0, unit = "N s/m" }
    [define.mass_on_spring.energy]
    kinetic = "mass*x_dot^2/2"
    potential = "stiffness*x^2/2"
    dissipation = "damping*x_dot^2/2"
"#;

#[test]
fn outputs_shown_in_other_units_are_converted() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("shown.toml");
    fs::write(&file, SHOWN).expect("written");
    let file = file.display().to_string();
    let json = |arguments: &[&str]| -> serde_json::Value {
        serde_json::from_str(&answer(&[arguments, &["--json"]].concat())).expect("JSON")
    };
    let number = |value: &serde_json::Value| value.as_f64().expect("a number");
    // A single quantity stays in its unit. Combinations of several are in SI units.
    let in_si = [("final(si)", 1.0), ("mean((si - 0.003)^2)", 1.0)];
    let shown = [("final(x)", 1e3), ("mean((x - 3 [mm])*(y - 0.3 [cm]))", 1.0)];
    for ((exact, _), (text, factor)) in in_si.iter().zip(shown) {
        let [exact, found] = [exact, text].map(|text| json(&["gradient", &file, "--of", text]));
        let slopes = |json: &serde_json::Value| {
            let rows = json["slopes"].as_array().expect("slopes").iter();
            rows.map(|row| number(&row["slope"]))
                .chain([number(&json["value"])])
                .collect::<Vec<_>>()
        };
        for (exact, found) in slopes(&exact).iter().zip(slopes(&found)) {
            assert!((found / factor / exact - 1.0).abs() < 1e-9, "{text}: {found} for {exact}");
        }
    }
    let improved = |limit: &str| {
        let asked = ["improve", &file, "--minimise", "m.damping", "--parameters"];
        let found = json(&[&asked[..], &["m.damping=0.5..10", "--subject-to", limit]].concat());
        (number(&found["parameters"][0]["value"]), found["limits"][0]["unit"].to_string())
    };
    let (exact, _) = improved("max(-si) <= 0.009");
    for (limit, unit) in [("max(-x) <= 9 [mm]", "mm"), ("0.9 [cm] >= max(-x)", "m")] {
        let (found, of) = improved(limit);
        assert!((found / exact - 1.0).abs() < 1e-6, "{limit}: {found} for {exact}");
        assert_eq!(of, format!("\"{unit}\""));
    }
    // The unit of a bare number beside them is ambiguous.
    let bare = ["gradient", &file, "--of", "final(x) - 3"];
    assert_refused(&bare, &["has no unit", "shown in mm", "5 [mm]"]);
    let varied = ["improve", &file, "--minimise", "m.damping", "--parameters", "m.damping=1..9"];
    assert_refused(&[&varied[..], &["--subject-to", "max(x) <= 9"]].concat(), &["shown in mm"]);
    answer(&[&varied[..], &["--subject-to", "max(x) >= 0"]].concat());
}

#[test]
fn modes_are_told_with_their_derivatives() {
    let asked = ["modes", "two_mass", "--set", "drive_torque=843.72", "--sensitivities"];
    let by = "coupling.stiffness,cylinder.inertia";
    let text = answer(&[&asked[..], &[by]].concat());
    assert!(text.contains("By `coupling.stiffness`, which is 23065.2 N m/rad"), "{text}");
    let json = answer(&[&asked[..], &[by, "--json"]].concat());
    let json: serde_json::Value = serde_json::from_str(&json).expect("JSON");
    let slope = &json["sensitivities"][2]["coupling.stiffness"]["natural_frequency"];
    let natural = (23_065.2_f64 * (1.0 / 4.2 + 1.0 / 1.244)).sqrt();
    let wanted = natural / (2.0 * 23_065.2);
    assert!((slope.as_f64().expect("a number") / wanted - 1.0).abs() < 1e-10, "{slope}");
    assert!(json["sensitivities"][0]["none"].as_str().is_some_and(|why| why.contains("restoring")));
    assert_refused(&[&asked[..], &["coupling.stifness"]].concat(), &["coupling.stiffness"]);
}

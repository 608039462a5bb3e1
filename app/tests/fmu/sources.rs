//! Archives with C99 sources.

use std::fs;
use std::path::Path;

use super::host::{attributes, unpacked};
use crate::process::{REPOSITORY, answer, assert_refused, machinist};

/// Files of an archive with sources.
struct Sources {
    files: Vec<(String, Vec<u8>)>,
    /// Output of the program.
    said: String,
}

impl Sources {
    fn of(scene: &str, options: &[&str]) -> Self {
        let folder = tempfile::tempdir().expect("a folder");
        let file = folder.path().join("unit.fmu");
        let out = file.to_str().expect("a plain path");
        let arguments = [&["fmu", scene, "--source", "-o", out], options].concat();
        let said = answer(machinist(REPOSITORY, &arguments));
        Self { files: unpacked(&fs::read(&file).expect("an archive")), said }
    }

    fn text(&self, name: &str) -> &str {
        let file = self.files.iter().find(|(known, _)| known == name);
        let (_, bytes) = file.unwrap_or_else(|| panic!("no file {name}"));
        std::str::from_utf8(bytes).expect("text")
    }

    fn names(&self) -> Vec<&str> {
        self.files.iter().map(|(name, _)| name.as_str()).collect()
    }
}

#[test]
fn sources_are_listed_for_hosts_that_compile_them() {
    let sources = Sources::of("two_mass", &["--inputs", "drive_torque"]);
    let files =
        ["two_mass.h", "two_mass.c", "two_mass_unit.h", "two_mass_unit.c", "two_mass_fmi3.c"];
    let expected: Vec<String> = files.iter().map(|name| format!("sources/{name}")).collect();
    let names = sources.names();
    assert_eq!(names[0], "modelDescription.xml");
    assert_eq!(names[1..6], expected);
    assert!(
        !names.iter().any(|name| name.starts_with("binaries") || name.starts_with("resources"))
    );
    let build = sources.text("sources/buildDescription.xml");
    assert!(build.contains("<BuildConfiguration modelIdentifier=\"two_mass\">"), "{build}");
    for name in ["two_mass.c", "two_mass_unit.c", "two_mass_fmi3.c"] {
        assert!(build.contains(&format!("<SourceFile name=\"{name}\"/>")), "{build}");
    }
    // The token of the description is the one that the sources compare.
    let description = sources.text("modelDescription.xml");
    let root = description.lines().find(|line| line.starts_with("<fmiModelDescription"));
    let token = &attributes(root.expect("a root"))["instantiationToken"];
    let unit = sources.text("sources/two_mass_unit.h");
    assert!(unit.contains(&format!("#define TWO_MASS_TOKEN \"{token}\"")), "{unit}");
    assert!(unit.contains("#define TWO_MASS_CONTINUOUS_STATES 3u"), "{unit}");
    // Names and units of the spec, and inputs that may be set at any time.
    let table = sources.text("sources/two_mass_unit.c");
    assert!(table.contains("{ \"drive_torque\", PARAMETER, INPUT, offsetof("), "{table}");
    assert!(table.contains("[N m] */"), "{table}");
    assert!(!table.contains("#ifdef"), "{table}");
    // FMI 2.0 lists the same in the model description.
    let sources = Sources::of("two_mass", &["--fmi", "2"]);
    let description = sources.text("modelDescription.xml");
    assert_eq!(description.matches("<File name=\"two_mass_fmi2.c\"/>").count(), 2);
    assert!(!sources.names().contains(&"sources/buildDescription.xml"));
}

#[test]
fn sources_offer_what_they_have_and_no_more() {
    let sources = Sources::of("stick_slip", &[]);
    let description = sources.text("modelDescription.xml");
    let simulation = description.lines().find(|line| line.trim().starts_with("<CoSimulation"));
    let simulation = attributes(simulation.expect("an interface"));
    assert_eq!(simulation["providesDirectionalDerivatives"], "false");
    assert_eq!(simulation["canGetAndSetFMUState"], "true");
    assert!(!simulation.contains_key("hasEventMode"));
    // The step of Co-Simulation is a parameter that says its error.
    let step = description.lines().find(|line| line.contains("name=\"fixed_step\""));
    let step = attributes(step.expect("a step"));
    assert_eq!(
        [&step["causality"], &step["unit"], &step["variability"]],
        ["parameter", "s", "fixed"]
    );
    assert!(step["start"].parse::<f64>().is_ok_and(|step| step > 0.0));
    assert!(step["description"].contains("rk4 with steps of at most"), "{step:?}");
    assert!(step["description"].contains("largest error"), "{step:?}");
    assert!(sources.said.contains("Co-Simulation: rk4 with steps of at most"), "{}", sources.said);
}

#[test]
fn the_same_scene_gives_the_same_sources() {
    let options = ["--step", "ros2", "--step-size", "2ms"];
    let [first, second] = [(), ()].map(|()| Sources::of("saw_gin", &options));
    assert_eq!(first.files, second.files);
    assert!(first.said.contains("ros2 with steps of at most 2e-3 s"), "{}", first.said);
    let command = "machinist fmu saw_gin --out unit.fmu --source --step ros2 --step-size 0.002";
    assert!(first.text("sources/saw_gin.h").contains(command));
    assert!(!first.text("sources/saw_gin.h").contains(REPOSITORY));
    // Another step is another unit, which the token tells.
    let other = Sources::of("saw_gin", &["--step", "ros2", "--step-size", "1ms"]);
    let token = |sources: &Sources| {
        let text = sources.text("sources/saw_gin_unit.h");
        text.lines().find(|line| line.contains("_TOKEN ")).expect("a token").to_owned()
    };
    assert_ne!(token(&first), token(&other));
}

#[test]
fn sources_of_a_scene_with_fields_have_its_nodes_as_states() {
    let sources = Sources::of("saw_gin_shaft", &["--elements", "2", "--order", "3"]);
    let text = sources.text("sources/saw_gin_shaft.h");
    assert!(
        text.contains("machinist fmu saw_gin_shaft --out unit.fmu --source --elements 2 --order 3")
    );
    let description = sources.text("modelDescription.xml");
    for node in 0..7 {
        let is_there = description.contains(&format!("name=\"saws.phi[{node}]\""));
        // Both ends are coordinates of the machine.
        assert_eq!(is_there, (1..6).contains(&node), "node {node}");
    }
}

#[test]
fn a_smaller_step_has_a_smaller_error() {
    let error = |size: &str| {
        let said = Sources::of("two_mass", &["--step-size", size]).said;
        let words = said.split("scene's run ").nth(1).expect("an error");
        words.split(' ').next().expect("a number").parse::<f64>().expect("a number")
    };
    let (coarse, fine) = (error("2ms"), error("1ms"));
    // The method has order four.
    assert!(fine < coarse / 8.0, "{coarse:e} {fine:e}");
}

#[test]
fn what_sources_cannot_do_is_refused() {
    let folder = tempfile::tempdir().expect("a folder");
    let refused = |arguments: &[&str], words: &[&str]| {
        let all = [&["fmu", "-o", "x.fmu"], arguments].concat();
        assert_refused(machinist(folder.path(), &all), words);
        assert!(!Path::new(&folder.path().join("x.fmu")).exists());
    };
    refused(&["saw_gin_shaft", "--source", "--elements", "0"], &["`saws.phi`", "--elements"]);
    refused(&["saw_gin", "--step", "heun"], &["--source"]);
    refused(&["saw_gin", "--source", "--library", "x.so"], &["--library"]);
    refused(&["saw_gin", "--source", "--step", "euler"], &["rk4"]);
    refused(&["saw_gin", "--source", "--elements", "4"], &["has no fields"]);
    refused(&["saw_gin", "--source", "--inputs", "load.maen"], &["did you mean `load.mean`"]);
    refused(&["saw_gin", "--fmi", "1"], &["--fmi"]);
    for size in ["0", "-1ms", "nan", "inf"] {
        refused(&["saw_gin", "--source", "--step-size", size], &["--step-size"]);
    }
    refused(&["saw_gin", "--source", "--step-size", "1e-300"], &["--step-size", "steps"]);
}

#[test]
fn a_step_at_which_the_method_is_unstable_is_refused_with_advice() {
    let folder = tempfile::tempdir().expect("a folder");
    let arguments = ["fmu", "saw_gin", "-o", "x.fmu", "--source", "--step-size", "1"];
    let output = crate::process::output(machinist(folder.path(), &arguments));
    assert_eq!(output.status.code(), Some(1));
    let said = crate::process::said(&output);
    assert!(said.contains("not finite") && said.contains("`--step ros2`"), "{said}");
    assert!(!folder.path().join("x.fmu").exists());
}

//! Derived equations read like the spec they come from.

use std::path::Path;

use machinist_codegen::emit::document::{Document, Notation};
use machinist_codegen::pipeline;

fn scene(name: &str) -> Document {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("../specs/scenes/{name}.toml"));
    let equations = pipeline::derive(&path).expect("the scene is sound");
    Document::new(&equations, Notation::Text)
}

#[test]
fn helpers_come_back_where_derivation_multiplied_them_out() {
    let document = scene("saw_gin");
    let motor = &document.motion[0];
    assert_eq!(motor.left, "motor.inertia*motor.phi_ddot");
    assert_eq!(motor.right, "motor.torque - coupling.torque");
    let current = document.outputs.iter().find(|output| output.subject == "stator_current");
    let current = current.expect("the scene wants this output");
    assert_eq!(current.right, "sqrt(motor.i_sx^2 + motor.i_sy^2)");
}

#[test]
fn every_helper_named_is_defined() {
    for name in ["motor_run_up", "saw_gin", "saw_gin_as_printed", "two_mass"] {
        let document = scene(name);
        let text = document.to_text();
        let defined: Vec<&str> = document.helpers.iter().map(|h| h.left.as_str()).collect();
        for helper in ["motor.torque", "coupling.twist", "coupling.torque"] {
            let used = text.contains(helper);
            assert_eq!(used, defined.contains(&helper), "{helper} in {name}");
        }
        let distinct: std::collections::BTreeSet<&str> = defined.iter().copied().collect();
        assert_eq!(distinct.len(), defined.len(), "no helper is defined twice in {name}");
    }
}

#[test]
fn every_unit_of_the_repository_comes_with_machinist() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../specs/units");
    let (mut folders, mut units) = (vec![(folder, String::new())], Vec::new());
    while let Some((folder, before)) = folders.pop() {
        for file in std::fs::read_dir(folder).expect("the units are there") {
            let path = file.expect("a file").path();
            let stem = path.file_stem().and_then(|stem| stem.to_str()).expect("a name");
            if path.is_dir() {
                folders.push((path.clone(), format!("{before}{stem}/")));
            } else {
                units.push(format!("{before}{stem}"));
            }
        }
    }
    assert!(units.iter().any(|unit| unit == "rotational/gear"), "{units:?}");
    for unit in units {
        let empty = tempfile::tempdir().expect("a folder");
        let scene = empty.path().join("scene.toml");
        let text = format!("[scene]\nname = \"alone\"\n[units.it]\nunit = \"{unit}\"\n");
        std::fs::write(&scene, text).expect("written");
        // The scene lacks much, but the unit must be found.
        if let Err(errors) = pipeline::check(&scene) {
            assert!(!errors.render().contains("there is no unit"), "{unit}: {}", errors.render());
        }
    }
}

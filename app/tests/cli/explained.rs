//! Output of `explain`, and freezing.

use super::*;

#[test]
fn explain_tells_what_is_left_out_and_why() {
    for (scene, states, gone) in [
        ("saw_gin", 7, "cylinder.phi"),
        ("motor_run_up", 5, "motor.phi"),
        ("two_mass", 3, "cylinder.phi"),
    ] {
        let text = answer(&["explain", scene, "--without-times"]);
        assert!(text.contains(gone) && text.contains("cyclic"), "{text}");
        let json = explain_as_json(scene, "plain");
        assert_eq!(json["states"].as_array().map(Vec::len), Some(states), "{scene}");
        assert_eq!(json["left_out"][0]["name"], gone);
        let stages = json["stages"].as_array().expect("stages");
        assert_eq!(stages[0]["size"]["states"], states + 1);
        assert_eq!(stages.last().expect("a stage")["size"]["states"], states);
    }
    let whole = answer(&["explain", "saw_gin", "--keep-all", "--without-times"]);
    assert!(whole.contains("Nothing is left out") && whole.contains("motor.phi, cylinder.phi"));
}

fn explain_as_json(scene: &str, algebra: &str) -> serde_json::Value {
    let json = answer(&["explain", scene, "--json", "--without-times", "--algebra", algebra]);
    serde_json::from_str(&json).expect("JSON")
}

#[test]
fn explain_works_for_every_scene_file_and_its_sums_are_those_of_the_emitted_code() {
    let files = names_in(&Path::new(env!("CARGO_MANIFEST_DIR")).join("../specs/scenes"));
    let is_scene =
        |file: &&String| Path::new(file).extension().is_some_and(|ending| ending == "toml");
    let files: Vec<&String> = files.iter().filter(is_scene).collect();
    assert!(files.len() >= machinist_scenes::scenes::NAMES.len());
    for file in files {
        // With the algebra of emitted code.
        let json = explain_as_json(&format!("specs/scenes/{file}"), "symbolica");
        let scene = json["scene"].as_str().expect("a name");
        let size =
            &json["stages"].as_array().and_then(|stages| stages.last()).expect("a stage")["size"];
        let emitted = format!("generated/src/scenes/{scene}.rs");
        let emitted =
            fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("..").join(emitted));
        let lines = emitted.expect("an emitted file").lines().count();
        assert_eq!(size["lines"], lines, "{scene}");
        let Some(built_in) = machinist_scenes::scenes::find_f64(scene) else {
            // The number of a field's states is chosen at run time.
            assert!(machinist_scenes::scenes::FIELD_NAMES.contains(&scene), "{scene}");
            continue;
        };
        assert_eq!(size["states"], built_in.shape().states(), "{scene}");
        assert_eq!(size["parameters"], built_in.shape().parameters, "{scene}");
        let nonzeros = built_in.rate_jacobian_pattern().entries.len();
        assert_eq!(size["jacobian_nonzeros"], nonzeros, "{scene}");
        assert_eq!(json["structure"]["jacobian_entries"], nonzeros, "{scene}");
        let operations = &json["structure"]["rate_operations"];
        let parts = ["once", "by_time", "by_state"].map(|part| operations[part].as_u64());
        let sum: Option<u64> = parts.into_iter().sum();
        assert_eq!(size["rate_operations"].as_u64(), sum, "{scene}");
    }
}

#[test]
fn explain_divides_the_fields_of_a_scene_into_the_elements_of_its_run() {
    for (scene, nodes, states, is_linear) in [
        // Two states for each node, the reed's angle and its speed.
        ("reed_beat_up", 97, 2 * 97 + 2, true),
        ("reed_beat_up_one_sided", 97, 2 * 97 + 2, false),
        ("shaft_with_rotors", 65, 2 * 65, true),
    ] {
        let json = explain_as_json(scene, "plain");
        let divided = &json["divided"];
        assert_eq!(divided["fields"][0]["nodes"], nodes, "{divided}");
        assert_eq!(divided["states"], states, "{divided}");
        assert_eq!(divided["is_linear"], is_linear, "{divided}");
        assert_eq!(divided["switches"], u64::from(!is_linear), "{divided}");
    }
    let told = answer(&["explain", "shaft_step_torque"]);
    assert!(told.contains("nodes") && told.contains("run of the scene with these elements"));
    assert!(explain_as_json("two_mass", "plain")["divided"].is_null());
}

#[test]
fn explain_measures_what_freezing_the_coupling_would_do() {
    let json = answer(&["explain", "two_mass", "--json"]);
    let json: serde_json::Value = serde_json::from_str(&json).expect("JSON");
    let candidate = &json["freeze_candidates"][0];
    assert_eq!(candidate["instance"], "coupling");
    let errors = candidate["price"]["Ok"]["errors"].as_array().expect("errors");
    assert_eq!(errors[0][0], "twist");
    assert_eq!(errors[0][1], 1.0, "a rigid coupling does not twist");
    assert!(errors[2][1].as_f64().is_some_and(|error| error > 0.0 && error < 0.2), "{errors:?}");
    assert!(json["run"]["ratio"].as_f64().is_some_and(|ratio| ratio > 0.0));
}

#[test]
fn explain_lists_the_coupling_of_the_saw_gin_with_its_price() {
    let folder = tempfile::tempdir().expect("a folder");
    copy_specs(folder.path());
    let path = folder.path().join("scenes/saw_gin.toml");
    let spec = fs::read_to_string(&path).expect("the spec");
    fs::write(&path, spec.replace("until = 2.0", "until = 0.1")).expect("written");
    let json = answer(&["explain", text(&path), "--json"]);
    let json: serde_json::Value = serde_json::from_str(&json).expect("JSON");
    let candidate = &json["freeze_candidates"][0];
    let price = &candidate["price"]["Ok"];
    assert_eq!((&candidate["instance"], &price["states"]), (&"coupling".into(), &5.into()));
    assert!(price["time_ratio"].as_f64().is_some_and(|ratio| ratio > 0.0), "{price}");
    let errors = price["errors"].as_array().expect("errors");
    let error = |output: &str| {
        errors.iter().find(|pair| pair[0] == output).and_then(|pair| pair[1].as_f64())
    };
    assert_eq!(error("twist"), Some(1.0), "a rigid coupling does not twist");
    assert!(error("motor_speed").is_some_and(|error| error > 1e-6 && error < 1.0), "{errors:?}");
    // In the same run, leaving out a position changes outputs only by rounding.
    let difference = json["run"]["milliseconds"]["difference"].as_f64();
    assert!(difference.is_some_and(|difference| difference < 1e-9), "{difference:?}");
}

#[test]
fn a_freeze_beyond_its_tolerance_is_refused_with_the_figure() {
    let folder = tempfile::tempdir().expect("a folder");
    copy_specs(folder.path());
    let path = folder.path().join("scenes/two_mass.toml");
    let spec = fs::read_to_string(&path).expect("the spec");
    let freeze = |tolerance: &str, outputs: &str| {
        let spec = spec.replace(
            "twist = \"coupling.twist\"\ncoupling_torque = \"coupling.torque\"\n",
            outputs,
        );
        let freeze = format!("{spec}\n[freeze]\nrigid = [\"coupling\"]\ntolerance = {tolerance}\n");
        fs::write(&path, freeze).expect("written");
    };
    freeze("0.5", "twist = \"coupling.twist\"\n");
    for arguments in [["run", text(&path)], ["explain", text(&path)]] {
        let output = output(&arguments);
        assert_eq!(output.status.code(), Some(1), "{arguments:?}");
        let said = said(&output);
        assert!(said.contains("`twist` is wrong by 1.00e0") && said.contains("5e-1"), "{said}");
    }
    freeze("0.25", "");
    let run = answer(&["run", text(&path)]);
    assert!(run.contains("driver_speed"), "{run}");
}

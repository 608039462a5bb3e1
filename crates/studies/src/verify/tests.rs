use machinist_scenes::scenes;

use super::*;

/// Returns the checks of the overridden scenes, or of all scenes if there are no overrides.
fn verdicts(overrides: &[(&str, f64)]) -> Vec<Verdict> {
    let scene = |(name, _): &(&str, f64)| name.split('.').next().unwrap_or_default().to_owned();
    let scenes: Vec<String> = overrides.iter().map(scene).collect();
    let overrides = overrides.iter().map(|(name, value)| ((*name).to_owned(), *value)).collect();
    let scenes = (!scenes.is_empty()).then_some(scenes);
    verify_all(&VerifyOptions { overrides, scenes, ..VerifyOptions::default() })
        .expect("the overrides name parameters")
}

fn failed<'v>(verdicts: &'v [Verdict], scene: &str) -> Vec<&'v str> {
    let failed = verdicts.iter().filter(|verdict| !verdict.pass && verdict.scene == scene);
    failed.map(|verdict| verdict.check.as_ref()).collect()
}

#[test]
fn every_check_passes_with_the_published_numbers() {
    let verdicts = verdicts(&[]);
    assert!(verdicts.iter().all(|verdict| verdict.pass), "\n{}", render_table(&verdicts));
}

#[test]
fn every_scene_has_checks_of_its_own() {
    for scene in scenes::NAMES.iter().chain(scenes::FIELD_NAMES) {
        assert!(!own_checks(scene).is_empty(), "{scene}");
    }
}

#[test]
fn a_broken_parameter_makes_the_rows_that_depend_on_it_fail() {
    let verdicts = verdicts(&[
        ("two_mass.coupling.stiffness", 23_065.2 * 1.001),
        ("motor_run_up.motor.alpha_r", 0.0859),
        ("saw_gin.cylinder.inertia", 1.2441),
        ("saw_gin_as_printed.motor.sigma", 0.0897),
        ("motor_stationary_axes.motor.alpha_r", 0.0859),
        ("winder_linear.layer.viscosity", 95.01),
        ("winder_nonlinear.layer.cubic_stiffness", 2.0001e9),
        ("winder_full.pair.friction", 0.18001),
        ("pendulum_chain.chain.m_3", 0.5001),
        ("four_bar.coupler.mass", 0.9001),
    ]);
    assert_eq!(
        failed(&verdicts, "two_mass"),
        [
            "free decay from a twist of 0.01 rad",
            "transient under constant torques",
            "transient under a harmonic load",
            "amplitude of the steady harmonic twist",
            "phase of the steady harmonic twist",
            "static twist under constant torques",
            "natural frequency of the coupling",
            "damping ratio of the coupling",
            "twist at constant speed, by the equilibrium solve",
            "frequency response of the twist to the load",
            "sensitivities of the free decay",
            "sensitivities under a harmonic load",
        ]
    );
    let motor = failed(&verdicts, "motor_run_up");
    for check in [
        "flux transient at standstill",
        "flux transient at 40 rad/s",
        "flux transient at 76.97 rad/s",
        "torque-speed curve at 50 slips",
        "torque at slip 0.02",
        "breakdown slip",
        "starting torque",
        "run-up, state after 1 s",
        "eigenvalues at constant speeds",
    ] {
        assert!(motor.contains(&check), "`{check}` passes with a broken rotor resistance");
    }
    assert!(!motor.contains(&"no-load speed after 3 s"), "it does not depend on resistance");
    let gin = failed(&verdicts, "saw_gin");
    assert_eq!(
        gin,
        ["right-hand side at 1000 random states", "run-up and loading, state after 2 s"]
    );
    let torque = "torque-speed curve, speed for the printed angle";
    assert_eq!(failed(&verdicts, "saw_gin_as_printed"), [torque]);
    assert_eq!(
        failed(&verdicts, "motor_stationary_axes"),
        [
            "torque over the run-up",
            "speed over the run-up",
            "currents of all windings over the run-up",
            "currents switched on at standstill",
            "currents switched on at 76.97 rad/s",
        ]
    );
    let winder = failed(&verdicts, "winder_linear");
    assert_eq!(
        winder.len(),
        6,
        "all motions see the viscosity, mass and mobility do not: {winder:?}"
    );
    // The override takes precedence over the setting of the linear limit.
    assert_eq!(failed(&verdicts, "winder_nonlinear").len(), 5);
    assert_eq!(
        failed(&verdicts, "winder_full"),
        [
            "least pressure that turns packages of 25 to 60 mm, to a millionth",
            "drum that speeds up and brakes, packages of 30 to 60 mm, to a millionth",
            "package that lags behind, over 0.5 s, at half that pressure",
            "elastic slip at constant pressure, of packages of 30 to 60 mm, to its limit and beyond",
        ]
    );
    assert_eq!(
        failed(&verdicts, "four_bar"),
        [
            "speed of the crank over 2 s",
            "frequency of small oscillations about its lowest position",
            "angles of crank, coupler and rocker at rest there",
        ]
    );
    assert_eq!(failed(&verdicts, "pendulum_chain"), ["accelerations at 1000 random states"]);
}

#[test]
fn an_override_of_no_parameter_is_refused() {
    for name in ["two_mass", "two_mass.coupling.stifness", "winder.mass", ""] {
        let options =
            VerifyOptions { overrides: vec![(name.to_owned(), 1.0)], ..VerifyOptions::default() };
        assert_eq!(verify_all(&options), Err(VerifyError::UnknownOverride(name.to_owned())));
    }
    let name = "two_mass.coupling.stiffness".to_owned();
    let options = VerifyOptions { overrides: vec![(name, f64::NAN)], ..VerifyOptions::default() };
    assert!(matches!(verify_all(&options), Err(VerifyError::OverrideNotFinite { .. })));
}

#[test]
fn a_run_that_stops_fails_its_checks_and_says_why() {
    let machine = {
        let mut machine = machine::two_mass();
        machine.override_parameter("driver.inertia", 0.0).expect("the scene has it");
        machine
    };
    let verdict = two_mass::CHECKS[0].verdict(&machine);
    assert!(!verdict.pass);
    assert!(verdict.failure.is_some());
    let line = serde_json::to_value(&verdict).expect("a verdict is plain data");
    assert!(line["error"].is_null());
}

#[test]
fn a_verdict_is_one_json_object_with_the_keys_of_the_report() {
    let check = Check {
        name: "two",
        reference: "1",
        tolerance: 0.5,
        reason: "none",
        measure: |_| Ok(Measured::absolute(2.0, 1.0)),
    };
    let verdict = check.verdict(&machine::two_mass());
    let line = serde_json::to_string(&verdict).expect("a verdict is plain data");
    assert_eq!(
        line,
        r#"{"scene":"two_mass","check":"two","reference":"1","error":1.0,"tolerance":0.5,"reason":"none","pass":false,"value":2.0,"expected":1.0}"#
    );
}

#[test]
fn an_error_that_is_not_a_number_does_not_pass() {
    let check = Check {
        name: "",
        reference: "",
        tolerance: f64::INFINITY,
        reason: "",
        measure: |_| Ok(Measured::error(f64::NAN)),
    };
    assert!(!check.verdict(&machine::two_mass()).pass);
    assert!(worse(f64::NAN, 1.0).is_nan() && worse(1.0, f64::NAN).is_nan());
}

#[test]
fn a_table_has_one_line_a_check_and_counts_failures() {
    let passes = Verdict {
        check: "c".into(),
        reference: "r".into(),
        reason: "because".into(),
        ..Verdict::judged("two_mass", 1e-12, 1e-9, None)
    };
    let fails = Verdict { error: 1.0, pass: false, ..passes.clone() };
    let left_out = Verdict { reason: "".into(), ..Verdict::skipped("two_mass", "none".to_owned()) };
    let open = Verdict {
        check: "the other".into(),
        reason: "".into(),
        ..Verdict::unchecked("two_mass", "it stopped".to_owned())
    };
    assert!(!open.pass);
    let text = render_table(&[passes, fails, left_out, open]);
    assert_eq!(text.lines().filter(|line| line.contains("because")).count(), 3);
    assert_eq!(text.lines().filter(|line| line.contains("skip")).count(), 1);
    assert_eq!(text.lines().filter(|line| line.contains("FAIL")).count(), 1);
    assert_eq!(text.lines().filter(|line| line.contains("open")).count(), 1);
    let last = "2 checks, 1 failed, 1 left out, 1 not checked: the other of two_mass\n";
    assert!(text.ends_with(last), "{text}");
}

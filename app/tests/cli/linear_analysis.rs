//! Modes, orders and responses on the command line.

use super::*;

#[test]
fn modes_of_a_machine_in_balance_are_a_table() {
    let text = answer(&["modes", "two_mass", "--set", "drive_torque=843.72"]);
    let swing = text.lines().find(|line| line.starts_with("oscillation")).expect("a row");
    for part in ["cylinder.phi 77 %,", "155.025", "139.817", "22.2525", "0.431952"] {
        assert!(swing.contains(part), "{text}");
    }
}

#[test]
fn frequencies_over_a_parameter_are_a_table_with_where_orders_meet_them() {
    let folder = tempfile::tempdir().expect("a folder");
    let plot = folder.path().join("gin.svg").display().to_string();
    let range = "coupling.stiffness=1e2..1e5:log";
    let arguments = ["campbell", "saw_gin", "--parameter", range, "--count", "11"];
    let orders = ["--speed", "cylinder.omega", "--orders", "1,2"];
    let text = answer(&[&arguments[..], &orders, &["--plot", &plot]].concat());
    assert!(text.contains("8901.61     77.2046        0.64847"), "{text}");
    assert!(std::fs::read_to_string(&plot).expect("a plot").contains("order 2"));
    let table = answer(&[&arguments[..], &orders, &["--out", "-"]].concat());
    assert_eq!(table.lines().count(), 12, "{table}");
    assert!(table.starts_with("coupling.stiffness [N m/rad],speed [rad/s],1 "), "{table}");
    let json = answer(&[&arguments[..], &["--json"]].concat());
    let json: serde_json::Value = serde_json::from_str(&json).expect("JSON");
    assert_eq!(json["speeds"], serde_json::Value::Null);
    assert_refused(&["campbell", "two_mass", "--parameter", "drive_torque=2..1"], &["increase"]);
    let no_order = ["--parameter", "drive_torque=1..2", "--orders", "0"];
    assert_refused(&[&["campbell", "two_mass"], &no_order[..]].concat(), &["above zero"]);
}

#[test]
fn modes_as_json_hold_shapes_and_matrices() {
    let text = answer(&["modes", "two_mass", "--at", "t=0.1", "--json"]);
    let json: serde_json::Value = serde_json::from_str(&text).expect("JSON");
    assert_eq!(json["modes"][2]["kind"], "oscillation");
    assert_eq!(json["modes"][2]["shape"].as_array().map(Vec::len), Some(4));
    assert_eq!(json["mass"][0][0], 4.2);
    assert_eq!(json["stiffness"][0][1], -23065.2);
    assert_eq!(json["time"], 0.1);
}

#[test]
fn modes_without_an_equilibrium_say_what_changes_and_what_to_do() {
    assert_refused(
        &["modes", "two_mass"],
        &["no equilibrium", "`driver.omega` changes by", "--at initial"],
    );
    assert_refused(&["modes", "two_mass", "--at", "noon"], &["noon", "equilibrium, initial"]);
    let nothing = ["--output", "velocity", "--range=1e-308:1e26"];
    let response = ["response", "stick_slip", "--input", "slider.static_friction"];
    assert_refused(&[&response[..], &nothing].concat(), &["singular"]);
    assert_refused(&["run", "four_bar", "--modes=1"], &["has constraints"]);
    assert_refused(&["modes", "two_mas"], &["did you mean `two_mass`?"]);
    assert_refused(&["modes", "two_mass", "--at", "t=-1"], &["must end after it starts"]);
}

#[test]
fn a_response_is_written_and_drawn() {
    let folder = tempfile::tempdir().expect("a folder");
    let [csv, svg, png] = ["r.csv", "r.svg", "r.png"].map(|name| folder.path().join(name));
    let ask =
        ["response", "two_mass", "--at", "initial", "--input", "load_torque", "--output", "twist"];
    let with = |more: &[&str]| answer(&[&ask[..], more].concat());
    let said =
        with(&["--range", "1:1e4", "--points", "9", "--out", text(&csv), "--plot", text(&svg)]);
    assert!(said.contains("twist answers load_torque"), "{said}");
    let (header, columns) = read_csv(&fs::read_to_string(&csv).expect("a table"));
    assert_eq!(header, ["frequency [rad/s]", "amplitude [rad/(N m)]", "phase [rad]"]);
    assert_eq!((columns[0].len(), columns[0][0], columns[0][8]), (9, 1.0, 1e4));
    assert!((columns[1][0] * 23_065.2 * (4.2 + 1.244) / 4.2 - 1.0).abs() < 1e-3);
    assert!(fs::read_to_string(&svg).expect("a plot").contains("rad/s"));
    with(&["--plot", text(&png)]);
    assert!(fs::read(&png).expect("a plot").starts_with(b"\x89PNG"));
    let plot = ["modes", "saw_gin", "--plot", text(&svg)];
    answer(&plot);
    assert!(fs::read_to_string(&svg).expect("a plot").contains("cylinder.phi"));
    assert_eq!(with(&["--out", "-"]).lines().count(), 402);
}

#[test]
fn a_run_takes_no_more_steps_than_it_may_and_parameters_once() {
    let run = ["run", "two_mass", "--max-steps"];
    answer(&[&run[..], &["1000"]].concat());
    let limited = output(&[&run[..], &["2"]].concat());
    assert_eq!(limited.status.code(), Some(1));
    assert!(said(&limited).contains("the limit of 2 steps is reached"), "{}", said(&limited));
    assert_refused(&[&run[..], &["0"]].concat(), &["--max-steps"]);
    let twice = ["run", "two_mass", "--set", "load_torque=1", "--set", "load_torque=2"];
    assert_refused(&twice, &["`--set load_torque` is given twice"]);
}

#[test]
fn a_response_of_what_falls_over_is_told_to_settle_to_nothing() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("rod.toml");
    let rod = |gravity: &str| {
        format!(
            r#"
            [scene]
            name = "rod"
            [units.rod]
            unit = "rod"
            [run]
            until = 1
            [define.rod.coordinates.phi]
            unit = "rad"
            [define.rod.energy]
            kinetic = "2 [kg m^2]*phi_dot^2/2"
            potential = "{gravity} [N m]*cos(phi)"
            dissipation = "0.1 [N m s]*phi_dot^2/2"
            "#
        )
    };
    for (gravity, falls) in [("8", true), ("-8", false)] {
        fs::write(&file, rod(gravity)).expect("a scene");
        let ask = [
            "response",
            text(&file),
            "--at",
            "initial",
            "--input",
            "rod.phi",
            "--output",
            "rod.phi",
        ];
        // (-0.1 + sqrt(0.1^2 + 4 2 8))/(2 2)
        assert_eq!(answer(&ask).contains("as e^(1.98 1/s t)"), falls);
        let table = output(&[&ask[..], &["--out", "-"]].concat());
        assert_eq!(said(&table).contains("settles to these"), falls);
    }
}

#[test]
fn what_does_not_answer_resounds_without_bound_ends_or_grows_is_told() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("pair.toml");
    let scene = r#"
        [scene]
        name = "pair"
        [units.o]
        unit = "o"
        [outputs]
        a = "o.a"
        b = "o.b"
        jolt = { expression = "o.a_ddot", unit = "m/s^2" }
        [run]
        until = 1
        points = 2
        rtol = 1e-6
        method = "auto"
        [define.o.coordinates]
        a = { unit = "m" }
        b = { unit = "m" }
        [define.o.parameters]
        k = { value = 100, unit = "N/m" }
        d = { value = 0, unit = "N s/m" }
        f = { value = 1, unit = "N" }
        [define.o.energy]
        kinetic = "1 [kg]*(a_dot^2 + b_dot^2)/2"
        potential = "k*a^2/2 + 900 [N/m]*b^2/2"
        dissipation = "d*a_dot^2/2 + 1 [N s/m]*b_dot^2/2"
        [[define.o.forces]]
        coordinate = "a"
        expression = "f"
        "#;
    fs::write(&file, scene).expect("a scene");
    let response =
        |to| ["response", text(&file), "--at", "initial", "--input", "o.f", "--output", to];
    assert!(answer(&response("b")).contains("b does not change with o.f"));
    let said = answer(&response("a"));
    assert!(
        said.lines().any(|line| line.contains(" 10 ") && line.ends_with("without bound")),
        "{said}"
    );
    let force = ["response", text(&file), "--at", "initial", "--input", "o.a", "--output", "jolt"];
    assert!(answer(&force).contains("o.a"));
    let varied = |by| ["campbell", text(&file), "--at", "initial", "--parameter", by];
    // 100 - d^2/4 vanishes at 20.
    let said = answer(&varied("o.d=1..41"));
    assert!(said.contains("Motion 1 ends between o.d = 19.8 and 20.2 N s/m."), "{said}");
    assert!(!said.contains("Unstable"), "{said}");
    let said = answer(&varied("o.d=-1..1"));
    assert!(said.contains("Unstable from o.d = -1 to "), "{said}");
    assert!(said.contains("as e^(0.5 1/s t) at -1 N s/m; o.a most."), "{said}");
}

#[test]
fn a_response_of_unknown_quantities_or_over_a_bad_range_is_refused() {
    let ask = |from, to, range| {
        [
            "response", "two_mass", "--at", "initial", "--input", from, "--output", to, "--range",
            range,
        ]
    };
    assert_refused(&ask("load_torqu", "twist", "1:2"), &["did you mean `load_torque`?"]);
    assert_refused(&ask("load_torque", "twst", "1:2"), &["did you mean `twist`?"]);
    assert_refused(&ask("load_torque", "twist", "2:1"), &["from 2 to 1 rad/s"]);
    assert_refused(&ask("load_torque", "twist", "0:1"), &["above 0"]);
    assert_refused(&ask("load_torque", "twist", "1-2"), &["LOWEST..HIGHEST"]);
    let bad_file = ["--out", "r.txt"];
    assert_refused(&[&ask("load_torque", "twist", "1:2")[..], &bad_file].concat(), &[".csv"]);
}

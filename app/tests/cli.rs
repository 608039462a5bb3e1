//! Command line as seen by users: output, files and exit codes.

use std::fs;
use std::path::Path;
use std::process::{Command, Output, Stdio};

use crate::process::{self, said};

const SAW_GIN: &str = "specs/scenes/saw_gin.toml";

/// Prepares a call of the program in the folder of the repository.
pub fn machinist(arguments: &[&str]) -> Command {
    process::machinist(process::REPOSITORY, arguments)
}

fn output(arguments: &[&str]) -> Output {
    process::output(machinist(arguments))
}

/// Returns standard output of a run that must succeed.
pub fn answer(arguments: &[&str]) -> String {
    process::answer(machinist(arguments))
}

/// Asserts bad input: exit code 2, nothing on standard output, and these words on standard error.
pub fn assert_refused(arguments: &[&str], words: &[&str]) {
    process::assert_refused(machinist(arguments), words);
}

/// Parses header and columns of CSV. Every line must have as many numbers as the header.
fn read_csv(text: &str) -> (Vec<String>, Vec<Vec<f64>>) {
    let mut lines = text.lines();
    let header: Vec<String> =
        lines.next().expect("a header").split(',').map(str::to_owned).collect();
    let mut columns = vec![Vec::new(); header.len()];
    for line in lines {
        let numbers: Vec<f64> =
            line.split(',').map(|cell| cell.parse().expect("a number")).collect();
        assert_eq!(numbers.len(), header.len(), "{line}");
        for (column, number) in columns.iter_mut().zip(numbers) {
            column.push(number);
        }
    }
    (header, columns)
}

/// Copies a folder of specs, one level of folders deep.
pub fn copy_specs(to: &Path) {
    for folder in ["units", "scenes"] {
        fs::create_dir_all(to.join(folder)).expect("a folder");
        let from = Path::new(env!("CARGO_MANIFEST_DIR")).join("../specs").join(folder);
        for entry in fs::read_dir(from).expect("specs") {
            let path = entry.expect("a file").path();
            if path.is_file() {
                let name = path.file_name().expect("a name");
                fs::copy(&path, to.join(folder).join(name)).expect("a copy");
            }
        }
    }
}

pub fn names_in(folder: &Path) -> Vec<String> {
    let Ok(entries) = fs::read_dir(folder) else { return Vec::new() };
    let mut names: Vec<String> = entries
        .map(|entry| entry.expect("a file").file_name().to_string_lossy().into_owned())
        .collect();
    names.sort();
    names
}

pub fn text(path: &Path) -> &str {
    path.to_str().expect("a plain path")
}

#[test]
fn an_unknown_scene_is_refused_with_a_suggestion() {
    for command in ["run", "derive", "check"] {
        assert_refused(&[command, "saw_gni"], &["saw_gni", "did you mean `saw_gin`?"]);
    }
}

#[test]
fn a_scene_file_that_does_not_exist_is_refused_by_name() {
    assert_refused(&["run", "no_such_scene.toml"], &["no_such_scene.toml"]);
    assert_refused(&["derive", "no/such/scene.toml"], &["scene.toml"]);
}

#[test]
fn a_parameter_must_be_known_and_its_value_a_finite_number() {
    let run = |set| ["run", "two_mass", "--set", set];
    assert_refused(&run("coupling.stifness=1"), &["did you mean", "coupling.stiffness"]);
    assert_refused(&run("coupling.stiffness"), &["NAME=VALUE"]);
    assert_refused(&run("coupling.stiffness=stiff"), &["`stiff` is not a number"]);
    assert_refused(&run("coupling.stiffness=inf"), &["not a finite number"]);
}

#[test]
fn a_run_that_makes_no_sense_is_refused_and_writes_nothing() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("run.csv");
    let plot = folder.path().join("run.svg");
    for (wrong, words) in [
        (["--until", "-1"], "must end after it starts"),
        (["--points", "1"], "2 to 10000000"),
        (["--points", "10000001"], "2 to 10000000"),
        (["--rtol", "0"], "must be a finite number above 0"),
        (["--rtol", "-1e-6"], "must be a finite number above 0"),
        (["--method", "bfd"], "did you mean `bdf`?"),
        (["--columns", "twist,twst"], "twst"),
    ] {
        let mut arguments = vec!["run", "two_mass", "--out", text(&file), "--plot", text(&plot)];
        arguments.extend(wrong);
        assert_refused(&arguments, &[words]);
    }
    assert_refused(&["run", "two_mass", "--out", "run.xls"], &[".csv or .json"]);
    assert_refused(&["run", "two_mass", "--plot", "run.pdf"], &[".svg or .png"]);
    assert_eq!(names_in(folder.path()), [""; 0]);
}

#[test]
fn a_run_writes_tables_whose_columns_carry_units_and_plots_beside() {
    let folder = tempfile::tempdir().expect("a folder");
    let [csv, json, svg] = ["run.csv", "run.json", "run.svg"].map(|name| folder.path().join(name));
    let summary = answer(&["run", "two_mass", "--out", text(&csv), "--plot", text(&svg)]);
    assert!(summary.contains("Two rotors") && summary.contains("tsit5"), "{summary}");
    assert!(summary.contains("run.csv") && summary.contains("run.svg"), "{summary}");

    let (header, columns) = read_csv(&fs::read_to_string(&csv).expect("a table"));
    assert_eq!(header[0], "time [s]");
    for name in ["driver.omega [rad/s]", "coupling_torque [N m]", "energy.total [J]"] {
        assert!(header.iter().any(|column| column == name), "{name} is not in {header:?}");
    }
    assert_eq!(columns[0].len(), 1001);
    assert!(fs::read_to_string(&svg).expect("a plot").contains("<svg"));

    answer(&["run", "two_mass", "--points", "5", "--out", text(&json)]);
    let value: serde_json::Value =
        serde_json::from_slice(&fs::read(&json).expect("a file")).expect("JSON");
    assert_eq!(value["scene"], "two_mass");
    assert_eq!(names_in(folder.path()), ["run.csv", "run.json", "run.svg"]);
}

#[test]
fn standard_output_carries_the_table_asked_for_and_nothing_else() {
    let arguments =
        ["run", "saw_gin", "--out", "-", "--columns", "twist,motor.omega", "--points", "11"];
    let (header, columns) = read_csv(&answer(&arguments));
    assert_eq!(header, ["time [s]", "twist [rad]", "motor.omega [rad/s]"]);
    assert_eq!(columns[0].len(), 11);
    assert_eq!((columns[0][0], columns[0][10]), (0.0, 2.0));
}

#[test]
fn settings_change_the_run() {
    let twist = |settings: &[&str]| {
        let arguments = [&["run", "two_mass", "--out", "-", "--columns", "twist"], settings];
        read_csv(&answer(&arguments.concat())).1[1].last().copied().expect("a value")
    };
    let stiffness = ["--set", "coupling.stiffness=46130.4"];
    assert!((twist(&[]) / twist(&stiffness) - 2.0).abs() < 1e-5);
    let twist_by = |method| twist(&["--method", method, "--rtol", "1e-9"]);
    assert!((twist_by("bdf") - twist_by("tsit45")).abs() < 1e-7);
}

#[test]
fn a_run_may_be_asked_for_at_any_times() {
    let times = |arguments: &[&str]| {
        let run = ["run", "two_mass", "--out", "-", "--columns", "twist"];
        read_csv(&answer(&[&run, arguments].concat())).1[0].clone()
    };
    assert_eq!(times(&["--times", "0,0.1,0.25"]), [0.0, 0.1, 0.25]);
    assert_eq!(times(&["--times", "0 [ms],250 [ms]"]), [0.0, 0.25]);
    let ratios = times(&["--times", "1e-3..0.1:log", "--points", "4"]);
    assert_eq!((ratios.len(), ratios[0], ratios[1], ratios[3]), (4, 0.0, 1e-3, 0.1));
    assert!((ratios[2] - 1e-2).abs() < 1e-15);
    let run = ["run", "two_mass", "--times"];
    assert_refused(&[&run[..], &["0,1", "--points", "3"]].concat(), &["leave one of them out"]);
    assert_refused(&[&run[..], &["0 [m],1 [m]"]].concat(), &["a time is in s, and not in m"]);
    assert_refused(&[&run[..], &["0..1:log", "--points", "9"]].concat(), &["logarithmic"]);
    assert_refused(&[&run[..], &["1,2,1.5"]].concat(), &["increase"]);
}

#[test]
fn settings_may_be_in_units_of_measure() {
    let run =
        |set: &str| answer(&["run", "two_mass", "--points", "11", "--set", set, "--out", "-"]);
    assert_eq!(run("coupling.stiffness=18 [kN m/rad]"), run("coupling.stiffness=18000"));
    let sweep = |range: &str| {
        let folder = tempfile::tempdir().expect("a folder");
        let file = folder.path().join("sweep.csv");
        let count = ["--count", "2", "--outputs", "twist", "--out", text(&file)];
        answer(&[&["sweep", "two_mass", "--parameter", range][..], &count].concat());
        fs::read_to_string(&file).expect("a table")
    };
    let in_si = sweep("coupling.stiffness=18000..20000");
    for range in ["18..20 [kN m/rad]", "18 [kN m]..20e3 [N m/rad]"] {
        assert_eq!(sweep(&format!("coupling.stiffness={range}")), in_si, "{range}");
    }
    let length = "coupling.stiffness=18 [kN/m]";
    let words = ["coupling.stiffness is in N m/rad, and not in kN/m"];
    assert_refused(&["run", "two_mass", "--set", length], &words);
    let lengths = "coupling.stiffness=1..2 [mm]";
    let words = ["coupling.stiffness is in N m/rad, and not in mm"];
    let few = ["--count", "3"];
    let sweep = ["sweep", "two_mass", "--parameter", lengths, "--outputs", "twist"];
    assert_refused(&[&sweep[..], &few].concat(), &words);
    assert_refused(&[&["campbell", "two_mass", "--parameter", lengths][..], &few].concat(), &words);
    assert_refused(&["run", "two_mass", "--set", "coupling.stiffness=1 [kn]"], &["kn"]);
    let built_in = ["verify", "--only", "two_mass", "--set", "two_mass.coupling.stiffness=1 [mm]"];
    assert_refused(&built_in, &["name the scene"]);
}

#[test]
fn emitted_and_evaluated_saw_gin_agree_in_every_column() {
    let run = |scene| read_csv(&answer(&["run", scene, "--out", "-", "--points", "201"]));
    let (emitted, evaluated) = (run("saw_gin"), run(SAW_GIN));
    assert_eq!(emitted.0, evaluated.0);
    for ((name, a), b) in emitted.0.iter().zip(&emitted.1).zip(&evaluated.1) {
        let size = a.iter().fold(0.0, |most: f64, value| most.max(value.abs()));
        let distance = a.iter().zip(b).fold(0.0, |most: f64, (a, b)| most.max((a - b).abs()));
        assert!(distance <= 1e-9 * size, "{name} differs by {distance}");
    }
}

#[test]
fn verification_passes_and_fails_with_a_broken_parameter() {
    let passing = answer(&["verify", "--only", "two_mass"]);
    assert!(passing.contains("free decay"), "{passing}");
    let broken = "two_mass.coupling.stiffness=23000";
    let output = output(&["verify", "--only", "two_mass", "--set", broken, "--json"]);
    assert_eq!(output.status.code(), Some(1), "{}", said(&output));
    let rows: serde_json::Value = serde_json::from_slice(&output.stdout).expect("JSON");
    let failed = rows.as_array().expect("rows").iter().filter(|row| row["pass"] == false).count();
    assert!(failed > 0);
    assert!(said(&output).contains(&format!("{failed} of")), "{}", said(&output));
}

#[test]
fn verification_refuses_unknown_parameters_and_checks() {
    assert_refused(&["verify", "--set", "two_mass.stiffness=1"], &["two_mass.stiffness"]);
    assert_refused(&["verify", "--only", "no such check"], &["no such check"]);
}

#[test]
fn emission_is_the_same_twice_and_fresh_until_a_spec_changes() {
    let folder = tempfile::tempdir().expect("a folder");
    let specs = folder.path().join("specs");
    copy_specs(&specs);
    let scenes = specs.join("scenes");
    // One of each kind. Another test checks that all are up to date.
    let kinds = [
        "bouncing_mass",
        "motor_run_up",
        "pendulum_constrained",
        "saw_gin",
        "saw_gin_shaft",
        "two_mass",
    ];
    for name in names_in(&scenes) {
        if !kinds.iter().any(|kind| name == format!("{kind}.toml")) {
            fs::remove_file(scenes.join(name)).expect("a scene less");
        }
    }
    let [first, second] = ["first", "second"].map(|name| folder.path().join(name));
    let generate = |out: &Path| answer(&["gen", "--specs", text(&scenes), "--out", text(out)]);
    generate(&first);
    generate(&second);
    let names = names_in(&first);
    assert!(names.contains(&"saw_gin.rs".to_owned()) && names.contains(&"mod.rs".to_owned()));
    for name in &names {
        let [a, b] = [&first, &second].map(|folder| fs::read(folder.join(name)).expect("a file"));
        assert!(a == b, "{name} differs");
    }

    let check = ["gen", "--check", "--specs", text(&scenes), "--out", text(&first)];
    answer(&check);
    let unit = specs.join("units/coupling.toml");
    let spec = fs::read_to_string(&unit).expect("a spec");
    fs::write(&unit, spec.replace("128.5346", "128.5347")).expect("a changed spec");
    let before = fs::read(first.join("two_mass.rs")).expect("a file");
    let output = output(&check);
    let said = said(&output);
    assert_eq!(output.status.code(), Some(1), "{said}");
    assert!(said.contains("two_mass.rs is out of date"), "{said}");
    assert!(!said.contains("motor_run_up.rs is out of date"), "{said}");
    assert!(said.contains("cargo run --release -- gen"), "{said}");
    assert!(fs::read(first.join("two_mass.rs")).expect("a file") == before, "check wrote");
}

#[test]
fn nothing_is_written_if_one_of_several_specs_is_wrong() {
    let folder = tempfile::tempdir().expect("a folder");
    let specs = folder.path().join("specs");
    copy_specs(&specs);
    let scene = specs.join("scenes/two_mass.toml");
    let spec = fs::read_to_string(&scene).expect("a spec");
    fs::write(&scene, spec.replace("\"coupling.twist\"", "\"coupling.twits\"")).expect("a spec");
    let out = folder.path().join("out");
    let scenes = specs.join("scenes");
    let arguments = ["gen", "--specs", text(&scenes), "--out", text(&out)];
    assert_refused(&arguments, &["two_mass.toml", "coupling.twits"]);
    assert_eq!(names_in(&out), [""; 0]);

    let file = folder.path().join("run.csv");
    assert_refused(&["run", text(&scene), "--out", text(&file)], &["coupling.twits"]);
    assert_refused(&["check", text(&scene), SAW_GIN], &["coupling.twits"]);
    assert!(!file.exists());
}

#[test]
fn equations_are_printed_in_the_names_of_the_spec() {
    let derived = answer(&["derive", "two_mass"]);
    let row = "driver.inertia*driver.phi_ddot = drive_torque - coupling.torque";
    assert!(derived.contains(row), "{derived}");
    assert!(derived.contains("rate_jacobian"), "{derived}");
    assert!(
        answer(&["derive", "two_mass", "--latex"]).contains(r"\ddot{\varphi}_{\mathrm{driver}}")
    );
    let json = answer(&["derive", "two_mass", "--json"]);
    let value: serde_json::Value = serde_json::from_str(&json).expect("JSON");
    assert_eq!(value["motion"].as_array().expect("rows").len(), 2);
}

#[test]
fn two_derivations_at_the_same_time_both_succeed() {
    let start = || {
        let mut command = machinist(&["derive", "saw_gin"]);
        command.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().expect("the program starts")
    };
    let outputs = [start(), start()].map(|child| child.wait_with_output().expect("an end"));
    for output in &outputs {
        assert!(output.status.success(), "{}", said(output));
    }
    assert!(outputs[0].stdout == outputs[1].stdout);
}

#[test]
fn a_measurement_has_a_line_for_each_method_and_tolerance() {
    let table = answer(&["bench", "two_mass", "--methods", "tsit45,bdf", "--rtols", "1e-6,1e-3"]);
    assert!(table.contains("numbers of 31 digits"), "{table}");
    for method in ["tsit45", "bdf"] {
        let lines = table.lines().filter(|line| line.starts_with(&format!("{method} ")));
        let tolerances: Vec<&str> =
            lines.filter_map(|line| line.split_whitespace().nth(1)).collect();
        assert_eq!(tolerances, ["1e-3", "1e-6"], "from loose to tight: {table}");
    }
}

#[test]
fn a_measurement_as_json_holds_errors_that_fall_with_the_tolerance() {
    let arguments = ["bench", "two_mass", "--methods", "tsit45", "--rtols", "1e-3,1e-8", "--json"];
    let json: serde_json::Value = serde_json::from_str(&answer(&arguments)).expect("JSON");
    let curve = &json["curves"][0];
    assert_eq!(curve["method"], "tsit45");
    let error = |point: usize| curve["points"][point]["error"].as_f64().expect("a number");
    assert!(error(1) < error(0) / 100.0, "{json}");
    assert!(curve["points"][1]["work"]["rate_evaluations"].as_u64() > Some(10));
}

#[test]
fn a_measurement_of_nonsense_is_refused() {
    assert_refused(&["bench", "two_mass", "--rtols", "0"], &["tolerance", "above 0"]);
    assert_refused(&["bench", "two_mass", "--rtols", "1e-3,-1"], &["tolerance", "above 0"]);
    assert_refused(&["bench", "two_mass", "--methods", "rk4"], &["no method", "tsit45"]);
    assert_refused(&["stability", "--method", "rk4"], &["no method", "tsit45"]);
    assert_refused(&["stability", "--rtol", "0"], &["tolerance", "above 0"]);
    assert_refused(&["stability", "--only", "nothing such"], &["nothing such"]);
    assert_refused(&["bench", "twomass"], &["no scene", "two_mass"]);
}

#[test]
fn a_scene_that_is_not_built_in_runs_by_its_name() {
    let summary = answer(&["run", "m5", "--until", "0.1"]);
    assert!(summary.contains("winder.q"), "{summary}");
}

#[test]
fn the_list_names_every_scene() {
    let list = answer(&["list"]);
    for name in machinist_scenes::scenes::NAMES {
        assert!(list.contains(name), "{list}");
    }
}

#[test]
fn whatever_simulates_tells_of_a_mass_of_the_wrong_sign() {
    const NOTE: &str = "the inertia of `driver.phi` is negative at the start";
    let set = ["--set", "driver.inertia=-1", "--until", "0.02"];
    let stiffness = ["--parameters", "coupling.stiffness=1e3..1e5"];
    let improve = ["improve", "two_mass", stiffness[0], stiffness[1], "--minimise", "max(twist)"];
    let commands: [&[&str]; 5] = [
        &["run", "two_mass"],
        &["sensitivity", "two_mass", "--outputs", "twist"],
        &["gradient", "two_mass", "--of", "max(abs(twist))"],
        &["spectrum", "two_mass", "--settle", "0"],
        &improve,
    ];
    for command in commands {
        let told = answer(&[command, &set[..]].concat());
        assert!(told.contains(NOTE), "{command:?}: {told}");
        let told = answer(&[command, &["--until", "0.02"]].concat());
        assert!(!told.contains("negative"), "{command:?}: {told}");
    }
    for command in &commands[1..3] {
        let told = answer(&[command, &set[..], &["--json"]].concat());
        let told: serde_json::Value = serde_json::from_str(&told).expect("JSON");
        let notes = told["notes"].as_array().expect("notes");
        assert!(notes.iter().any(|note| note.as_str().expect("text").contains(NOTE)), "{notes:?}");
    }
    for command in [commands[0], commands[3]] {
        let output = output(&[command, &set[..], &["--out", "-"]].concat());
        let [numbers, beside] = [output.stdout, output.stderr].map(String::from_utf8);
        assert!(!numbers.expect("text").contains("negative"), "{command:?}");
        assert!(beside.expect("text").contains(NOTE), "{command:?}");
    }
    let other = ["--compare-set", "driver.inertia=-1", "--until", "0.02"];
    assert!(answer(&[commands[0], &other[..]].concat()).contains(NOTE));
}

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

#[test]
fn extreme_cases_are_a_table_or_json() {
    let arguments =
        ["stability", "--method", "auto,tsit5", "--only", "Prothero-Robinson: lambda = -1e8"];
    let table = answer(&arguments);
    for words in ["tsit5", "lambda = -1e8", "steps", "more steps than are allowed", "WRONG"] {
        assert!(table.contains(words), "`{words}` is not in {table}");
    }
    let json = answer(&[&arguments[..], &["--json"]].concat());
    let study: serde_json::Value = serde_json::from_str(&json).expect("JSON");
    let cells = &study["rows"][0]["cells"];
    assert_eq!(cells[0]["outcome"], "right", "{json}");
    assert_eq!(cells[1]["outcome"], "refused", "{json}");
}

#[test]
fn a_winder_is_walked_and_its_later_stages_are_told() {
    let text = answer(&["studies", "walk", "--speed", "1.5"]);
    assert!(text.contains("Stage 1, linear, is enough"), "{text}");
    for part in ["Stage 2 would have cost", "Stage 3 would have cost", "least pressure", "stable"] {
        assert!(text.contains(part), "{part} in {text}");
    }
    assert!(
        answer(&["studies", "walk", "--speed", "2.2"])
            .contains("Stage 2, stiffening layer, is enough")
    );
    let text = answer(&["studies", "walk", "--speed", "1.5", "--growth", "3800", "--package", "5"]);
    for part in ["of the drum and 5 N of the package", "40 N pressure that grows by 3800 N/m"] {
        assert!(text.contains(part), "{part} in {text}");
    }
    assert_refused(&["studies", "walk", "--growth", "-1"], &["the growth of the pressure is -1"]);
}

#[test]
fn a_walk_as_json_has_stages_and_map_and_a_map_is_drawn() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("map.svg");
    let file = file.to_str().expect("text");
    let text = answer(&["studies", "walk", "--json", "--map", file, "--preload", "100"]);
    let walk: serde_json::Value = serde_json::from_str(&text).expect("JSON");
    assert_eq!(walk["decided"], 3);
    assert_eq!(walk["walk"]["stages"].as_array().map(Vec::len), Some(3));
    let condition = walk["map"]["cells"][0][0]["condition"].as_str();
    assert_eq!(condition, Some("stable"));
    let drawn = fs::read_to_string(file).expect("it was drawn");
    assert!(drawn.starts_with("<svg") && drawn.contains("the yarn may be pressed too hard"));
}

#[test]
fn a_winder_that_makes_no_sense_is_refused() {
    assert_refused(
        &["studies", "walk", "--speed", "-1"],
        &["the speed is -1, but must be above zero"],
    );
    assert_refused(&["studies", "walk", "--radius-max", "0.01"], &["is not below 0.01 m"]);
    assert_refused(&["studies", "walk", "--map", "map.pdf"], &["unknown format"]);
}

#[test]
fn parts_are_listed_searched_and_shown() {
    let all = answer(&["parts"]);
    assert!(all.contains("rotational/gear") && all.contains("translational/rope"), "{all}");
    let clutches = answer(&["parts", "Clutch", "breakaway"]);
    assert!(clutches.contains("rotational/clutch") && !clutches.contains("gear"), "{clutches}");
    let shown = answer(&["parts", "show", "rotational/rack"]);
    for word in ["(radius)*phi", "pitch radius of the pinion", "unit = \"rotational/rack\""] {
        assert!(shown.contains(word), "{word}: {shown}");
    }
    // The last part of a name finds all parts with that ending.
    let springs = answer(&["parts", "show", "spring"]);
    assert!(springs.contains("rotational/spring:") && springs.contains("translational/spring:"));
    assert_refused(&["parts", "show", "rotational/gaer"], &["rotational/gaer", "rotational/gear"]);
    assert_refused(&["parts", "hovercraft"], &["hovercraft", "lists them all"]);
}

#[test]
fn the_page_of_parts_is_fresh() {
    let folder = tempfile::tempdir().expect("a folder");
    let made = folder.path().join("parts.md");
    answer(&["parts", "--page", made.to_str().expect("a plain path")]);
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let page = "docs/book/src/parts.md";
    let kept = fs::read_to_string(root.join(page)).expect(page);
    let made = fs::read_to_string(made).expect("written");
    assert!(kept == made, "{page} is stale: cargo run --release -- parts --page {page}");
}

/// Mass on a spring under its weight, which starts in equilibrium.
const HUNG: &str = r#"
    [scene]
    name = "hung"
    [units.body]
    unit = "translational/mass"
    parameters = { mass = 2 }
    [units.spring]
    unit = "translational/spring"
    parameters = { stiffness = 800 }
    [units.ground]
    unit = "translational/fixed"
    [units.weight]
    unit = "sources/force"
    inputs = { force = "-16 [N]" }
    [[joints]]
    connect = ["body.b", "spring.a"]
    [[joints]]
    connect = ["spring.b", "ground.a"]
    [[joints]]
    connect = ["weight.a", "body.a"]
    [initial]
    from = "equilibrium"
    [outputs]
    x = "body.x"
    [run]
    until = 1.0
    points = 11
    rtol = 1e-9
    method = "dop853"
    "#;

#[test]
fn a_run_starts_in_equilibrium_where_the_scene_or_an_option_says_so() {
    let folder = tempfile::tempdir().expect("a folder");
    let scene = folder.path().join("hung.toml");
    fs::write(&scene, HUNG).expect("written");
    let model = folder.path().join("hung.model");
    answer(&["compile", text(&scene), "-o", text(&model)]);
    let x_of = |arguments: &[&str]| {
        let csv = answer(&[&["run"], arguments, &["--columns", "x", "--out", "-"]].concat());
        read_csv(&csv).1[1].clone()
    };
    for of in [text(&scene), text(&model)] {
        for x in x_of(&[of]) {
            assert!((x + 0.02).abs() < 1e-12, "{x}");
        }
        let swings = x_of(&[of, "--start", "given"]);
        assert!(swings[0] == 0.0 && swings.iter().any(|x| *x < -0.03), "{swings:?}");
    }
    let shown = answer(&["show", text(&scene)]);
    assert!(shown.contains("(guess)"), "{shown}");
    let checked = answer(&["verify", text(&scene)]);
    assert!(checked.contains(" 0 failed"), "{checked}");
    let refused = ["run", "bouncing_mass", "--start", "equilibrium"];
    assert_refused(&refused, &["no start in equilibrium", "`ball.v`", "-9.810e0 m/s a second"]);
}

#[test]
fn runs_are_compared_with_files_scenes_and_other_settings() {
    let folder = tempfile::tempdir().expect("a folder");
    let [scene, csv, plot] = ["hung.toml", "run.csv", "both.svg"].map(|f| folder.path().join(f));
    fs::write(&scene, HUNG).expect("written");
    // For a run that starts at 0, x is 0.02 (cos(w t) - 1), with its minimum at t = pi/w = 0.157.
    let stiff = ["--set", "spring.stiffness=1600", "--start", "given"];
    let out = ["--until", "0.4", "--points", "401", "--out", text(&csv)];
    answer(&[&["run", text(&scene)], &stiff[..2], &out].concat());
    let told = answer(
        &[
            &["run", text(&scene), "--until", "0.4", "--points", "5", "--columns", "x"][..],
            &["--start", "given", "--compare", text(&csv), "--compare", text(&scene)],
            &["--compare-set", "spring.stiffness=1600,body.mass=4", "--plot", text(&plot)],
        ]
        .concat(),
    );
    // The file has x = -0.01 throughout. The largest difference, 0.03, is at this run's minimum.
    let rows: Vec<Vec<&str>> = told
        .lines()
        .filter(|line| line.starts_with("x "))
        .map(|line| line.split_whitespace().collect())
        .collect();
    let [_, of_file, of_scene, of_settings] = &rows[..] else { panic!("{told}") };
    assert_eq!(&of_file[..4], ["x", "m", "0.03", "0.157"], "{told}");
    assert_eq!(of_file[4..], ["75", "%"]);
    // The same scene with the same start.
    assert_eq!(&of_scene[2..3], ["0"], "{told}");
    // Twice as stiff and as heavy: half the displacement at the same frequency.
    let [difference, time] = [of_settings[2], of_settings[3]].map(str::parse::<f64>);
    let (difference, time) = (difference.expect("a number"), time.expect("a number"));
    assert!((difference - 0.02).abs() < 2e-6 && (time - 0.157).abs() < 1e-9, "{told}");
    let drawn = fs::read_to_string(&plot).expect("a plot");
    for name in ["x, spring.stiffness=1600,body.mass=4", "run.csv"] {
        assert!(drawn.contains(name), "{name}");
    }
    let against = |other: &str| ["run", "two_mass", "--compare", other].map(str::to_owned);
    let of = |list: &[String; 4], words: &[&str]| {
        assert_refused(&list.each_ref().map(String::as_str), words);
    };
    let bad = folder.path().join("bad.csv");
    fs::write(&bad, "x,time\n1,2\n").expect("written");
    of(&against(text(&bad)), &["bad.csv", "the first column is `x`, not time"]);
    of(&against(text(&scene)), &["nothing to compare with `two_mass`"]);
    assert_refused(&["run", "two_mass", "--compare-set", "coupling.stif=1"], &["did you mean"]);
}

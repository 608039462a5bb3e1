//! Command line as seen by users: output, files and exit codes.

mod explained;
mod linear_analysis;
mod walks;

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

//! The scripts of a live page in Node, if there is one, compared with the engine: the same motion,
//! and the same events in the same order.

#[path = "../../tests/common/machines.rs"]
mod machines;

use std::io::Write as _;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::{env, fs, thread};

use machinist::trajectory::{Column, ColumnKind, Trajectory};
use machinist::{Discretisation, FieldSimulator, SimulateError, Simulation};
use machinist_algebra::cas::Algebra;
use machinist_app::Headless;
use machinist_codegen::mechanics::reduce::Keep;
use machinist_codegen::pipeline;
use machinist_contract::Simulator;
use machinist_model::{Model, ModelSimulator};
use serde::Deserialize;

use crate::process::REPOSITORY;

/// Runs machines by the scripts, one for each line of input.
const HARNESS: &str = include_str!("conformance/harness.js");

/// Output times of a run, more than enough to see any difference.
const POINTS: usize = 101;

/// Run of a page.
#[derive(Deserialize)]
struct OfPage {
    outputs: Vec<Vec<Option<f64>>>,
    switches: Vec<Switch>,
    stopped: Option<String>,
}

#[derive(Deserialize)]
struct Switch {
    time: f64,
    event: String,
}

/// A machine with its run by the engine, and what a page knows of it.
struct Case {
    name: String,
    run: Trajectory,
    stopped: Option<String>,
    live: Headless,
}

impl Case {
    /// Runs a share of the model's run.
    fn of(name: String, mut model: Model, share: f64) -> Self {
        model.run.until = model.run.from + share * (model.run.until - model.run.from);
        model.run.points = POINTS;
        // Methods differ by more at the looser tolerances of some scenes.
        model.run.rtol = model.run.rtol.min(1e-8);
        model.run.times.clear();
        let simulator = ModelSimulator::new(model.clone());
        let divided = FieldSimulator::new(simulator.with_fields(), Discretisation::default());
        let divided = divided.expect("elements of the spec");
        let simulator: &dyn Simulator<f64> =
            if model.fields.is_empty() { simulator.single() } else { divided.single() };
        let (run, stopped) = match Simulation::new(simulator).run() {
            Ok(run) => (run, None),
            Err(SimulateError::Stopped { kept: Some(kept), cause, .. }) => {
                (*kept, Some(cause.to_string()))
            }
            Err(other) => panic!("{name}: {other}"),
        };
        let live = Headless::of(&model, &run).unwrap_or_else(|why| panic!("{name}: {why}"));
        Self { name, run, stopped, live }
    }

    fn of_file(file: &Path, share: f64) -> Self {
        let name = file.display().to_string();
        let system = pipeline::check(file).unwrap_or_else(|errors| panic!("{}", errors.render()));
        let model = pipeline::compile_by(Algebra::Plain, system, Keep::Needed);
        Self::of(name, model.unwrap_or_else(|errors| panic!("{}", errors.render())), share)
    }

    fn of_text(text: &str) -> Self {
        let folder = tempfile::tempdir().expect("a folder");
        let file = folder.path().join("machine.toml");
        fs::write(&file, text).expect("written");
        Self::of_file(&file, 1.0)
    }

    /// Asserts that a page runs alike, with outputs within a share of their largest values.
    fn assert_alike(&self, page: &OfPage, share: f64) {
        let Self { name, run, stopped, .. } = self;
        assert_eq!(page.stopped.is_some(), stopped.is_some(), "{name}: {:?}", page.stopped);
        let span = run.times[run.times.len() - 1] - run.times[0];
        for (page, engine) in page.switches.iter().zip(&run.switches) {
            let is_same =
                page.event == engine.event && (page.time - engine.time).abs() < share * span;
            let (of_page, of_engine) = ((&page.event, page.time), (&engine.event, engine.time));
            assert!(is_same, "{name}: {of_page:?}, not {of_engine:?}");
        }
        assert_eq!(page.switches.len(), run.switches.len(), "{name}: number of events");
        let outputs: Vec<_> = run.of_kind(ColumnKind::Output).collect();
        let states: Vec<_> = run.of_kind(ColumnKind::State).collect();
        let columns = if outputs.is_empty() { states } else { outputs };
        assert_eq!(page.outputs.len(), columns.len(), "{name}");
        // At an event a mode has either value.
        let is_at_event =
            |time: f64| run.switches.iter().any(|switch| (switch.time - time).abs() < share * span);
        let largest_of = |column: &Column| {
            let sizes = column.values.iter().filter(|value| value.is_finite());
            sizes.fold(f64::MIN_POSITIVE, |most, value| most.max(value.abs()))
        };
        for (column, values) in columns.iter().zip(&page.outputs) {
            // A quantity may be rounding beside others of its unit.
            let of_unit = columns.iter().filter(|other| other.unit == column.unit);
            let beside = of_unit.map(|other| largest_of(other)).fold(0.0, f64::max);
            let largest = largest_of(column).max(1e-7 * beside);
            assert_eq!(values.len(), column.values.len(), "{name}");
            for ((time, engine), page) in run.times.iter().zip(&column.values).zip(values) {
                let page = page.unwrap_or(f64::NAN);
                let off = (page - engine).abs() / largest;
                let is_alike = off <= share || !engine.is_finite() || is_at_event(*time);
                let column = &column.name;
                assert!(is_alike, "{name}: {column} is {page} at {time} s, not {engine}: {off:e}");
            }
        }
    }
}

/// Runs machines by the scripts of pages; `None` without Node.
fn in_node(cases: &[Case]) -> Option<Vec<OfPage>> {
    let folders = env::var_os("PATH")?;
    let places = env::split_paths(&folders).flat_map(|at| [at.join("node"), at.join("nodejs")]);
    let Some(node) = { places }.find(|place: &PathBuf| place.is_file()) else {
        eprintln!("skipped: there is no node to run the scripts of live pages");
        return None;
    };
    let folder = tempfile::tempdir().expect("a folder");
    let script = folder.path().join("engine.js");
    let engine = &cases.first()?.live.engine;
    fs::write(&script, format!("\"use strict\";\n{engine}{HARNESS}")).expect("written");
    let mut command = Command::new(node);
    let command = command.arg(&script).stdin(Stdio::piped()).stdout(Stdio::piped());
    let mut child = command.spawn().expect("node starts");
    let mut input = child.stdin.take().expect("standard input");
    let lines: String = cases.iter().map(|case| case.live.known.clone() + "\n").collect();
    let writer = thread::spawn(move || input.write_all(lines.as_bytes()));
    let output = child.wait_with_output().expect("node ends");
    writer.join().expect("written").expect("written");
    let text = String::from_utf8(output.stdout).expect("text");
    let runs: Vec<OfPage> =
        text.lines().map(|line| serde_json::from_str(line).expect("JSON")).collect();
    assert_eq!(runs.len(), cases.len(), "{}", cases[runs.len().min(cases.len() - 1)].name);
    Some(runs)
}

fn assert_all_alike(cases: &[Case], share: f64) {
    for (case, page) in cases.iter().zip(in_node(cases).unwrap_or_default()) {
        case.assert_alike(&page, share);
    }
}

/// Compares the machines of some seeds. Their tolerance is 1e-8; after many switches a motion is
/// known a thousand times less accurately.
fn assert_random_machines_alike(seeds: std::ops::Range<u64>) {
    let case = |seed| {
        let machine = machines::machine(seed);
        let case = Case::of_text(&machine.spec);
        Case { name: format!("seed {seed}: {}", machine.parts.join(", ")), ..case }
    };
    assert_all_alike(&seeds.map(case).collect::<Vec<_>>(), 1e-5);
}

#[test]
fn machines_at_random_run_alike_in_a_page() {
    assert_random_machines_alike(0..20);
}

#[test]
fn more_machines_at_random_run_alike_in_a_page() {
    assert_random_machines_alike(20..40);
}

#[test]
fn further_machines_at_random_run_alike_in_a_page() {
    assert_random_machines_alike(40..60);
}

#[test]
fn other_machines_at_random_run_alike_in_a_page() {
    assert_random_machines_alike(60..80);
}

/// Compares scenes of a folder.
fn assert_scenes_alike(folder: &str, is_meant: impl Fn(&str) -> bool) {
    // Pages take other methods than some scenes, whose tolerances are looser.
    assert_all_alike(&scenes(folder, is_meant, 1.0), 1e-4);
}

/// Returns scenes of a folder over a share of their runs.
fn scenes(folder: &str, is_meant: impl Fn(&str) -> bool, share: f64) -> Vec<Case> {
    let entries = fs::read_dir(Path::new(REPOSITORY).join(folder)).expect("scenes");
    let mut files: Vec<PathBuf> = entries.map(|entry| entry.expect("a file").path()).collect();
    files.sort();
    files.retain(|file| file.extension().is_some_and(|extension| extension == "toml"));
    let name = |file: &PathBuf| file.file_name().map(|name| name.to_string_lossy().into_owned());
    files.retain(|file| name(file).is_some_and(|name| is_meant(&name)));
    files.iter().map(|file| Case::of_file(file, share)).collect()
}

/// Scenes with fields.
const FIELDS: [&str; 6] = [
    "loom_drive.toml",
    "reed_beat_up.toml",
    "reed_beat_up_one_sided.toml",
    "saw_gin_shaft.toml",
    "shaft_step_torque.toml",
    "shaft_with_rotors.toml",
];

#[test]
fn fields_run_alike_in_a_page() {
    // Slopes at ports oscillate fast, and are known a hundred times less accurately than motions.
    // The wave of one does not reach its wall within this share of the run.
    let is_meant = |name: &str| FIELDS.contains(&name) && name != "shaft_step_torque.toml";
    let cases = scenes("specs/scenes", is_meant, 0.05);
    assert_all_alike(&cases, 1e-3);
}

#[test]
fn built_in_scenes_run_alike_in_a_page() {
    assert_scenes_alike("specs/scenes", |name| {
        !name.starts_with("winder") && !FIELDS.contains(&name)
    });
}

#[test]
fn winders_run_alike_in_a_page() {
    assert_scenes_alike("specs/scenes", |name| name.starts_with("winder"));
}

#[test]
fn drives_and_machines_of_the_standard_library_run_alike_in_a_page() {
    // A page does not project quaternions onto constraints.
    let has_both = ["spatial_revolute_constraint.toml", "spatial_universal_constraint.toml"];
    assert_scenes_alike("specs/scenes/msl", |name| !has_both.contains(&name));
    assert_scenes_alike("specs/scenes/drives", |_| true);
}

/// A rotor that swings, with an encoder that nothing reads but an output.
const ENCODER: &str = r#"
[scene]
name = "encoder"
[define.rotor.coordinates]
turn = { unit = "rad", velocity = "speed" }
[define.rotor.parameters]
inertia = { value = 0.02, unit = "kg m^2" }
stiffness = { value = 0.8, unit = "N m/rad" }
torque = { value = 0.9, unit = "N m" }
pace = { value = 5.1, unit = "rad/s" }
lines = { value = 20000, unit = "1" }
[define.rotor.energy]
kinetic = "inertia*speed^2/2"
potential = "stiffness*turn^2/2"
[[define.rotor.forces]]
coordinate = "turn"
expression = "torque*sin(pace*t)"
[define.rotor.modes.count]
initial = 0
[define.rotor.events.line]
guard = "sin(lines*turn)"
direction = "rising"
set = { count = "count + 1" }
[units.rotor]
unit = "rotor"
[outputs]
turn = "rotor.turn"
count = "rotor.count"
[run]
until = 0.6
points = 101
rtol = 1e-8
method = "dop853"
"#;

/// A mass at rest on a belt by `-friction*sign(v - belt)`, which then jumps in one of several ways.
fn on_belt(belt: &str, more: &str) -> Case {
    let case = Case::of_text(&format!(
        r#"
[scene]
name = "belt"
[define.u.coordinates.x]
unit = "m"
velocity = "v"
[define.u.energy]
kinetic = "1 [kg]*v^2"
[[define.u.forces]]
coordinate = "x"
expression = "0.4 [N] - 1 [N]*sign(v - {belt})"
{more}
[units.u]
unit = "u"
[run]
until = 5
points = 101
rtol = 1e-8
method = "dop853"
"#
    ));
    Case { name: format!("belt at {belt}"), ..case }
}

#[test]
fn a_motion_leaves_surfaces_that_jump_in_a_page_as_by_the_engine() {
    let go = "[define.u.events.go]\nguard = \"t - 1.25 [s]\"\ndirection = \"rising\"";
    let cases = [
        on_belt("0.5 [m/s]*step(t, 1.25 [s])", ""),
        on_belt("0.5 [m/s]*floor(t/(1.25 [s]))", ""),
        on_belt("0.25 [m/s]*(1 + sign(t - 1.25 [s]))", ""),
        on_belt("0.5 [m/s]*on", &format!("[define.u.modes.on]\n{go}\nset = {{ on = 1 }}")),
        on_belt("0 [m/s]", &format!("{go}\nset = {{ v = \"v - 0.5 [m/s]\" }}")),
    ];
    assert_all_alike(&cases, 1e-6);
}

/// A block with declared friction on a belt.
fn rubs_on_belt(speed: &str) -> Case {
    Case::of_text(&format!(
        "[scene]\nname = \"belt\"\n[units.u]\nunit = \"u\"\n[initial]\n\"u.v\" = 1\n\
         [run]\nuntil = 3\npoints = 61\n\
         [define.u.coordinates.x]\nunit = \"m\"\nvelocity = \"v\"\n\
         [define.u.energy]\nkinetic = \"1 [kg]*v^2\"\n\
         [define.u.friction.guide]\nspeed = \"v - ({speed})\"\nsliding = \"3 [N]\"\nunit = \"N\"\n"
    ))
}

#[test]
fn friction_begins_anew_where_belts_jump_in_a_page_as_by_the_engine() {
    let cases = [
        rubs_on_belt("1 [m/s]*(1 + step(t, 0.5 [s]))"),
        rubs_on_belt("1 [m/s]*(1 + step(t, 0.5 [s]) - 2.5*step(t, 0.77 [s]))"),
        rubs_on_belt("1 [m/s]*(1 + floor(t/(0.8 [s])))"),
        rubs_on_belt("piecewise(x < 0.5 [m], 1 [m/s], x < 1.5 [m], 2 [m/s], 0.5 [m/s])"),
    ];
    assert_all_alike(&cases, 1e-6);
}

#[test]
fn an_encoder_of_many_lines_is_counted_in_a_page_as_by_the_engine() {
    let case = Case::of_text(ENCODER);
    assert!(case.run.switches.len() > 5_000, "{} lines", case.run.switches.len());
    // The page and the engine take other steps, which decide of a line at a turning point.
    for page in in_node(std::slice::from_ref(&case)).into_iter().flatten() {
        let (page, engine) = (page.switches.len(), case.run.switches.len());
        assert!(page.abs_diff(engine) <= 1, "{page} lines, not {engine}");
    }
}

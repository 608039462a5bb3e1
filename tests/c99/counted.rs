//! Operations that emitted C executes, counted. The sources are compiled as C++ with a class of
//! numbers that counts what it computes.

use std::fmt::Write as _;
use std::process::{Command, Stdio};

use machinist_codegen::emit::c99::{
    C99File, C99Options, EstimatorOptions, FilterCost, Real, StepCost, emit, filter_cost, step_cost,
};
use machinist_codegen::mechanics::reduce::Keep;
use machinist_contract::fixed_step::StepMethod;
use machinist_model::Model;

use super::{options, options_with};
use crate::own_scene::{model_of_specs, whole_model_of_specs};

const NUMBERS: &str = include_str!("counted/numbers.cpp");

/// Returns the number of operations as which a function counts: one, or two for a sine and a cosine.
fn counts_as(line: &str) -> Option<&'static str> {
    let line = line.strip_prefix("static ")?;
    let name = line.split('(').next()?.split(' ').next_back()?;
    let is_power = name.trim_start_matches("inverse_").strip_prefix("power_");
    let is_power = is_power.is_some_and(|rest| rest.chars().all(|c| c.is_ascii_digit()));
    match name {
        "sine_and_cosine" => Some("2"),
        "sines_and_cosines_of_four" => Some("8"),
        "sine" | "cosine" | "exponential" | "hyperbolic_tangent" | "interpolate" => Some("1"),
        _ => is_power.then_some("1"),
    }
}

/// Returns the source with numbers that count.
fn counting(source: &str) -> String {
    let mut text = String::new();
    let mut open = None;
    for line in source.lines() {
        let _ = writeln!(text, "{line}");
        open = counts_as(line).or(open);
        if line == "{"
            && let Some(count) = open.take()
        {
            let _ = writeln!(text, "    const once here({count});");
        }
    }
    text
}

fn has_compiler() -> bool {
    let quiet = Command::new("g++").arg("--version").stdout(Stdio::null()).status();
    let is_here = quiet.is_ok_and(|status| status.success());
    if !is_here {
        eprintln!("skipped: g++ is not here to count the operations of emitted C");
    }
    is_here
}

/// Returns the numbers that a program writes: bytes of the struct that runs, then for each step
/// its operations, and those of a correction or the number of its events.
fn run(model: &Model, files: &[C99File], real: Real, main: &str) -> (usize, Vec<[f64; 2]>) {
    let folder = tempfile::tempdir().expect("a folder");
    for file in files {
        std::fs::write(folder.path().join(&file.name), counting(&file.text)).expect("written");
    }
    let (name, real) = (&model.name, real.name());
    let defined = if real == "float" { "#define COUNTED_FLOAT\n" } else { "" };
    let program = format!(
        "{defined}{NUMBERS}\n#define {real} counted\n#include \"{name}.c\"\n#undef {real}\n{}",
        main.replace("SCENE", name)
    );
    std::fs::write(folder.path().join("counting.cpp"), program).expect("written");
    let mut command = Command::new("g++");
    command.args(["-std=c++17", "-O0", "-w", "counting.cpp", "-o", "counting"]);
    let output = command.current_dir(folder.path()).output().expect("a compiler");
    let said = String::from_utf8_lossy(&output.stderr);
    let said: String = said.chars().take(4000).collect();
    assert!(output.status.success(), "{name}:\n{said}");
    let output = Command::new(folder.path().join("counting")).output().expect("compiled");
    assert!(output.status.success(), "{name}: the program ended badly");
    let numbers = output.stdout.chunks_exact(8);
    let numbers = numbers.map(|chunk| f64::from_ne_bytes(chunk.try_into().expect("eight")));
    let numbers: Vec<f64> = numbers.collect();
    let rows = numbers[1..].chunks_exact(2).map(|row| [row[0], row[1]]).collect();
    (numbers[0] as usize, rows)
}

fn steps(step: f64, steps: usize) -> String {
    format!(
        "int main()\n{{\n    static SCENE_machine_t machine;\n    long k;\n    \
         SCENE_begin(&machine);\n    put((double)sizeof machine);\n    \
         for (k = 0; k < {steps}; ++k) {{\n        int events;\n        counted_operations = 0;\n        \
         events = SCENE_step(&machine, {step:e});\n        put((double)counted_operations);\n        \
         put((double)events);\n    }}\n    return 0;\n}}\n"
    )
}

/// Scenes with steps in their span: a jump, shared motion, constraints, a table, friction, an
/// impact, brakes and gears with several events, fields, quaternions.
const SCENES: [(&str, usize); 14] = [
    ("saw_gin", 200),
    ("two_mass", 100),
    ("pendulum_chain", 60),
    ("pendulum_constrained", 100),
    ("winder_nonlinear", 100),
    ("parts/sources/fan", 100),
    ("bouncing_mass", 700),
    ("stick_slip", 300),
    ("drives/winch", 4000),
    ("drives/shaft_crank", 400),
    ("saw_gin_shaft", 400),
    ("msl/coupled_clutches", 300),
    ("parts/rotational/lossy_gear", 300),
    ("parts/spatial/revolute_constraint", 300),
];

/// Returns one way for each scene in turn, since each takes a compilation; all if `MACHINIST_C99` is
/// `all`.
fn some<T: Copy>(ways: &[T], scene: usize) -> Vec<T> {
    let is_all = std::env::var("MACHINIST_C99").is_ok_and(|which| which == "all");
    if is_all { ways.to_vec() } else { vec![ways[scene % ways.len()]] }
}

#[test]
fn steps_with_many_events_come_near_the_maximum() {
    if !has_compiler() {
        return;
    }
    // Steps in which a mass rebounds several times, and in which it sticks, slides and sticks.
    for (name, count, factor) in [("bouncing_mass", 12, 2), ("stick_slip", 12, 4)] {
        let model = model_of_specs(name, Keep::Needed);
        let step = (model.run.until - model.run.from) / count as f64;
        let (method, real) = (StepMethod::RungeKutta4, Real::Double);
        let files = emit(&model, &options(real, &model)).expect("emitted");
        let (_, rows) = run(&model, &files, real, &steps(step, count));
        let cost = step_cost(&model, method, real);
        let most = check(name, cost, &rows);
        assert!(factor * most >= cost.most(), "{name}: {most} operations of {}", cost.most());
    }
}

#[test]
fn no_step_takes_more_operations_than_are_printed() {
    if !has_compiler() {
        return;
    }
    let of_double = StepMethod::ALL.map(|method| (method, Real::Double));
    let ways = [&of_double[..], &[(StepMethod::RungeKutta4, Real::Float)]].concat();
    for (place, (name, count)) in SCENES.into_iter().enumerate() {
        let model = whole_model_of_specs(name, Keep::Needed);
        let step = (model.run.until - model.run.from) / count as f64;
        for (method, real) in some(&ways, place) {
            let options = C99Options { method, ..options(real, &model) };
            let files = emit(&model, &options).expect("emitted");
            let (bytes, rows) = run(&model, &files, real, &steps(step, count));
            assert_eq!(rows.len(), count, "{name}");
            let said = format!("{name} by {method:?} in {real:?}");
            let header = &files[0].text;
            assert!(header.contains(&format!(" {bytes} bytes")), "{said}: {bytes} bytes");
            let cost = step_cost(&model, method, real);
            check(&said, cost, &rows);
            // Most steps have no events, and take nearly what is printed for those.
            let mut counts: Vec<usize> = rows.iter().map(|row| row[0] as usize).collect();
            counts.sort_unstable();
            let usual = counts[counts.len() / 2];
            // Eliminations of a projection skip rows that are zero, which the pivots decide.
            let share = if model.constraints.is_empty() { 0.6 } else { 0.45 };
            assert!(
                usual as f64 >= share * cost.usual as f64 && usual <= cost.usual,
                "{said}: {usual} operations of {}",
                cost.usual
            );
        }
    }
}

/// Compares counted operations with those printed, and returns the most of them.
fn check(said: &str, cost: StepCost, rows: &[[f64; 2]]) -> usize {
    let most = |of: &mut dyn Iterator<Item = &[f64; 2]>| -> usize {
        of.map(|row| row[0] as usize).max().unwrap_or(0)
    };
    let usual = most(&mut rows.iter().filter(|row| row[1] == 0.0));
    let any = most(&mut rows.iter());
    println!("{said}: {usual} of {}, {any} of {}", cost.usual, cost.most());
    assert!(any <= cost.most(), "{said}: {any} operations of {}", cost.most());
    any
}

pub fn filter_of(model: &Model) -> EstimatorOptions {
    let states = model.states.iter();
    let is_mode = |kind| kind == machinist_model::StateKind::Mode;
    let start = states.map(|state| if is_mode(state.kind) { 0.0 } else { 1e-3 * state.scale });
    let disturbed = model.parameter_jacobian.pattern.entries.iter().map(|(_, p)| *p as usize);
    let disturbed: Vec<usize> = disturbed.take(1).collect();
    let estimated: Vec<usize> =
        model.parameter_jacobian.pattern.entries.iter().map(|(_, p)| *p as usize).collect();
    let estimated: Vec<usize> =
        estimated.into_iter().filter(|p| !disturbed.contains(p)).take(1).collect();
    let mut start: Vec<f64> = start.collect();
    start.extend(estimated.iter().map(|_| 1e-6));
    let first = model.states.iter().position(|state| !is_mode(state.kind)).expect("a state");
    EstimatorOptions {
        measured: (0..model.wanted.len().min(2)).map(|output| (output, 1e-3)).collect(),
        estimated,
        diffusing: vec![(first, 1e-6)],
        disturbed: disturbed.into_iter().map(|p| (p, 1e-9)).collect(),
        start,
    }
}

fn predictions(step: f64, steps: usize) -> String {
    format!(
        "int main()\n{{\n    static SCENE_estimator_t estimator;\n    long k;\n    \
         SCENE_estimator_begin(&estimator);\n    put((double)sizeof estimator);\n    \
         for (k = 0; k < {steps}; ++k) {{\n        SCENE_outputs_t outputs;\n        \
         SCENE_measured_t measured;\n        counted_operations = 0;\n        \
         (void)SCENE_estimator_predict(&estimator, {step:e});\n        put((double)counted_operations);\n        \
         SCENE_outputs(estimator.machine.time, &estimator.machine.state, &estimator.machine.p,\n                      \
         &estimator.machine.c, &outputs);\n        MEASURED\n        counted_operations = 0;\n        \
         (void)SCENE_estimator_correct(&estimator, &measured);\n        put((double)counted_operations);\n    }}\n    \
         return 0;\n}}\n"
    )
}

#[test]
fn no_filter_takes_more_operations_than_are_printed() {
    if !has_compiler() {
        return;
    }
    for (place, (name, count)) in SCENES.into_iter().enumerate() {
        let model = whole_model_of_specs(name, Keep::Needed);
        let step = (model.run.until - model.run.from) / (4 * count) as f64;
        let filter = filter_of(&model);
        for method in some(&[StepMethod::RungeKutta4, StepMethod::Rosenbrock2], place) {
            let real = Real::Double;
            let options = options_with(real, &model, filter.clone(), method);
            let files = emit(&model, &options).unwrap_or_else(|error| panic!("{name}: {error}"));
            let measured = "(void)memcpy(&measured, &outputs, sizeof measured);";
            let main = predictions(step, count).replace("MEASURED", measured);
            let (bytes, rows) = run(&model, &files, real, &main);
            let said = format!("filter of {name} by {method:?}");
            let header = &files[0].text;
            assert!(header.contains(&format!(" {bytes} bytes")), "{said}: {bytes} bytes");
            let FilterCost { predict, correct } = filter_cost(&model, (method, real), &filter);
            let predictions: Vec<_> = rows.iter().map(|row| [row[0], 0.0]).collect();
            check(&said, predict, &predictions);
            let most = rows.iter().map(|row| row[1] as usize).max().unwrap_or(0);
            println!("{said}: correction {most} of {correct}");
            assert!(most <= correct, "{said}: a correction takes {most} of {correct}");
        }
    }
}

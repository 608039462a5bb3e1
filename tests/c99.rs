//! Emitted C99, compiled and run without warnings or undefined behaviour, gives the same bits as
//! Rust.
//!
//! Without a C compiler the tests report that and pass; `MACHINIST_C99=all` tests every scene of
//! `specs/scenes`.

mod board;
mod compiler;
mod counted;
mod driver;
mod filter;
mod identities;
mod stack;

use machinist::Simulation;
use machinist::linear_analysis::{Place, operating_point};
use machinist_codegen::emit::c99::{C99Options, EstimatorOptions, Real, emit, needs_start};
use machinist_codegen::mechanics::reduce::Keep;
use machinist_contract::Simulator;
use machinist_contract::fixed_step::StepMethod;
use machinist_model::evaluate::{Evaluator, Inputs};
use machinist_model::{Model, ModelSimulator, Tape};

use crate::belts;
use crate::fixed_steps::{adaptive, difference, steps_in_rust};
use crate::own_scene::{model_of_specs, scenes_to_try, whole_model_of_specs};
use crate::wasm::{assert_same, expected};
use compiler::{Compiler, Program};
pub use counted::filter_of;

/// A motor, events and modes, branches, tables, constraints, constraints in modes, a prescribed
/// motion that solves for the Jacobian, fields, forces by constraint forces, and standard parts.
const SCENES: [&str; 25] = [
    "saw_gin",
    "winder_full",
    "stick_slip",
    "bouncing_mass",
    "coulomb_oscillator",
    "pendulum_chain",
    "slider_crank",
    "four_bar",
    "winder_holder_drop",
    "drives/winch",
    "drives/shaft_crank",
    "saw_gin_shaft",
    "parts/control/pid_controller",
    "parts/control/relay",
    "parts/electrical/pmsm",
    "parts/hydraulic/valve",
    "parts/planar/rough_slot",
    "parts/planar/slot",
    "parts/rotational/clutch",
    "parts/rotational/dwell_cam",
    "parts/rotational/table_cam",
    "parts/rotational/one_way_clutch",
    "parts/rotational/rigid_lossy_gear",
    "parts/translational/rope",
    "parts/translational/end_stops",
];

fn options(real: Real, model: &Model) -> C99Options {
    let start = needs_start(model).then(|| {
        let simulator = ModelSimulator::interpreted(model.clone());
        operating_point(&Simulation::new(&simulator), Place::Initial).expect("a start").state
    });
    C99Options { real, command: "a test".to_owned(), start, ..C99Options::default() }
}

fn options_with(
    real: Real,
    model: &Model,
    estimator: EstimatorOptions,
    method: StepMethod,
) -> C99Options {
    C99Options { method, estimator: Some(estimator), ..options(real, model) }
}

/// Returns time, state and parameters that differ from those of the spec.
fn sample(model: &Model, sample: usize) -> (f64, Vec<f64>, Vec<f64>) {
    let value = |index: usize| ((index * 7 + sample) as f64 * 0.37).sin();
    let parameters = model.parameters.iter().enumerate();
    let p = parameters.map(|(index, p)| p.value * (1.0 + 0.1 * value(index))).collect();
    let states = model.states.iter().enumerate();
    let y = states.map(|(index, state)| value(index) * state.scale).collect();
    (0.02 * sample as f64, y, p)
}

/// Compiles the files of a scene with a driver program.
fn compiled(compiler: &Compiler, model: &Model, options: &C99Options) -> Program {
    let files = emit(model, options).unwrap_or_else(|error| panic!("{}: {error}", model.name));
    compiler.build(&model.name, &files, &driver::text(model, options.real))
}

#[test]
fn every_function_of_emitted_c_gives_the_bits_of_the_machine_in_rust() {
    let Some(compiler) = Compiler::found() else { return };
    for name in scenes_to_try("MACHINIST_C99", &SCENES) {
        let model = whole_model_of_specs(&name, Keep::Needed);
        let mut program = compiled(&compiler, &model, &options(Real::Double, &model));
        let simulator = ModelSimulator::interpreted(model.clone());
        for index in 0..6 {
            let (t, y, p) = sample(&model, index);
            program.send(&[&[t], &y[..], &p[..]].concat());
            for row in driver::functions(&model) {
                let count = (row.results)(&model);
                let found = program.receive(count);
                let wanted = expected(&simulator, row.name, (t, &y, &p), count);
                assert_same(&format!("{name}: {}", row.name), &found, &wanted);
            }
        }
    }
}

/// Returns the last row of a run with constant steps, and the number of events.
fn end_of(program: &Program, model: &Model, steps: usize) -> (Vec<f64>, f64) {
    let step = (model.run.until - model.run.from) / steps as f64;
    let rows = program.run(step, steps, model.states.len());
    assert_eq!(rows.len(), steps + 1, "{}", model.name);
    assert!(rows.iter().all(|(.., events)| *events >= 0.0), "{}: too many events", model.name);
    let events = rows.iter().map(|(.., events)| events).sum();
    let (time, state, _) = rows.last().expect("a row");
    let error = (time - model.run.until).abs() / model.run.until;
    assert!(error < 4.0 * f64::EPSILON, "{}: the run ends at {time}", model.name);
    (state.clone(), events)
}

#[test]
fn steps_of_emitted_c_converge_to_the_adaptive_run_with_their_order() {
    let Some(compiler) = Compiler::found().map(Compiler::plain) else { return };
    for (name, steps) in
        [("saw_gin", 4000), ("pendulum_constrained", 2000), ("pendulum_chain", 1000)]
    {
        let model = model_of_specs(name, Keep::Needed);
        let (exact, _) = adaptive(&model);
        for (method, order) in [
            (StepMethod::RungeKutta4, 4.0),
            (StepMethod::Heun, 2.0),
            (StepMethod::Rosenbrock2, 2.0),
        ] {
            let options = C99Options { method, ..options(Real::Double, &model) };
            let program = compiled(&compiler, &model, &options);
            let error = |steps| difference(&model, &end_of(&program, &model, steps).0, &exact);
            let [coarse, fine] = [steps, 2 * steps].map(error);
            let measured = (coarse / fine).log2();
            assert!((measured - order).abs() < 0.1, "{name}, {method:?}: order {measured}");
        }
    }
}

#[test]
fn steps_of_emitted_c_find_the_events_of_the_adaptive_run() {
    let Some(compiler) = Compiler::found().map(Compiler::plain) else { return };
    for (name, steps, allowed) in [
        ("bouncing_mass", 10_000, 1e-9),
        ("stick_slip", 10_000, 1e-8),
        ("coulomb_oscillator", 10_000, 1e-9),
        ("winder_holder_drop", 10_000, 1e-10),
        ("drives/winch", 10_000, 1e-3),
        ("msl/coupled_clutches", 10_000, 1e-7),
        ("parts/rotational/one_way_clutch", 10_000, 1e-10),
        ("parts/translational/brake", 10_000, 1e-10),
        ("parts/control/relay", 10_000, 1e-9),
        ("parts/spatial/revolute_constraint", 10_000, 1e-8),
    ] {
        let model = model_of_specs(name, Keep::Needed);
        let (exact, switches) = adaptive(&model);
        let program = compiled(&compiler, &model, &options(Real::Double, &model));
        let (state, events) = end_of(&program, &model, steps);
        let error = difference(&model, &state, &exact);
        let said = format!("{name}: {events} events of {switches}, off by {error:e}");
        assert!(events.to_bits() == (switches as f64).to_bits() && error < allowed, "{said}");
    }
}

#[test]
fn steps_of_emitted_c_give_the_bits_of_steps_in_rust() {
    let Some(compiler) = Compiler::found().map(Compiler::plain) else { return };
    for (name, steps) in [
        ("saw_gin", 100),
        ("stick_slip", 500),
        ("pendulum_constrained", 100),
        ("drives/winch", 4000),
        ("parts/sources/torque", 200),
        ("drives/shaft_crank", 100),
        ("saw_gin_shaft", 100),
    ] {
        let model = whole_model_of_specs(name, Keep::Needed);
        assert_steps_alike(&compiler, &model, steps);
    }
}

#[test]
fn friction_begins_anew_in_emitted_c_where_its_belt_jumps() {
    let Some(compiler) = Compiler::found().map(Compiler::plain) else { return };
    for steps in [100, 313] {
        assert_steps_alike(&compiler, belts::scene(belts::IN_TIME).model(), steps);
    }
    let at_places = belts::scene(belts::AT_PLACES);
    let error = emit(at_places.model(), &C99Options::default()).expect_err("a place").to_string();
    assert!(error.starts_with("constraint `block.guide_grip`"), "{error}");
}

/// Compares steps of emitted C with those in Rust, bit by bit.
fn assert_steps_alike(compiler: &Compiler, model: &Model, steps: usize) {
    let step = (model.run.until - model.run.from) / steps as f64;
    for method in StepMethod::ALL {
        let options = C99Options { method, ..options(Real::Double, model) };
        let start = options.start.clone().unwrap_or_else(|| {
            let simulator = ModelSimulator::interpreted(model.clone());
            let p: Vec<f64> = model.parameters.iter().map(|p| p.value).collect();
            let mut state = vec![0.0; model.states.len()];
            simulator.initial_state(&p, &mut state);
            state
        });
        let program = compiled(compiler, model, &options);
        let of_c = program.run(step, steps, model.states.len());
        let (of_rust, _) = steps_in_rust(model, method, (&start, step, steps));
        for (index, ((_, found, _), wanted)) in of_c.iter().zip(&of_rust).enumerate() {
            assert_same(&format!("{} by {method:?}: step {index}", model.name), found, wanted);
        }
    }
}

#[test]
fn float_gives_the_operations_of_the_tapes_in_single_precision() {
    let Some(compiler) = Compiler::found() else { return };
    for name in ["saw_gin", "stick_slip", "four_bar", "winder_nonlinear", "parts/sources/fan"] {
        let model = model_of_specs(name, Keep::Needed);
        let live = model.live();
        let mut program = compiled(&compiler, &model, &options(Real::Float, &model));
        for index in 0..4 {
            let (t, y, p) = sample(&model, index);
            program.send(&[&[t], &y[..], &p[..]].concat());
            for row in driver::functions(&model) {
                let found = program.receive((row.results)(&model));
                if model.solve(row.id).is_some() || model.reads_motion(row.id) {
                    continue;
                }
                let wanted = single((row.tape)(&live), &live, (t, &y, &p));
                assert_same(&format!("{name} in float: {}", row.name), &found, &wanted);
            }
        }
    }
}

/// Returns the results of a tape in single precision.
fn single(tape: &Tape, model: &Model, (t, y, p): (f64, &[f64], &[f64])) -> Vec<f64> {
    let narrow = |numbers: &[f64]| numbers.iter().map(|&x| x as f32).collect::<Vec<f32>>();
    let (state, parameters) = (narrow(y), narrow(p));
    let inputs = Inputs {
        time: t as f32,
        state: &state,
        parameters: &parameters,
        handed: &[],
        constants: &[],
        motion: &[],
        tables: &model.tables,
    };
    let evaluator = Evaluator::new(tape);
    let mut results = vec![0.0; evaluator.results()];
    evaluator.evaluate_in(&mut vec![0.0; evaluator.room()], &inputs, &mut results);
    results.into_iter().map(f64::from).collect()
}

#[test]
fn float_steps_follow_double_ones_to_rounding() {
    let Some(compiler) = Compiler::found().map(Compiler::plain) else { return };
    for (name, steps, allowed) in [("saw_gin", 4000, 1e-2), ("bouncing_mass", 1000, 1e-3)] {
        let model = model_of_specs(name, Keep::Needed);
        let program = compiled(&compiler, &model, &options(Real::Float, &model));
        let step = (model.run.until - model.run.from) / steps as f64;
        let rows = program.run(step, steps, model.states.len());
        let (exact, _) = adaptive(&model);
        let error = difference(&model, &rows.last().expect("a row").1, &exact);
        assert!(error < allowed, "{name}: {error:e}");
    }
}

#[test]
fn a_scene_with_fields_that_are_not_divided_is_refused_by_the_name_of_its_field() {
    let model = model_of_specs("shaft_step_torque", Keep::Needed);
    let error = emit(&model, &C99Options::default()).expect_err("fields").to_string();
    let field = &model.fields[0].quantities[0].name.path;
    assert!(error.starts_with(&format!("field `{field}` is not divided")), "{error}");
}

/// Writes a row of the table of microcontrollers.
fn print_row(cells: [&str; 10]) {
    let [scene, processor, numbers, rest @ ..] = cells;
    let rest = rest.map(|cell| format!("{cell:>8}")).join("");
    eprintln!("{scene:<14}{processor:<11}{numbers:<8}{rest}");
}

/// Writes the row of a run, with the error of its state at the end, relative to its typical size.
fn print_run((scene, real): (&str, Real), board: &board::Board, ran: &board::Ran, error: f64) {
    let [mean, most] = ran.instructions;
    let numbers = [ran.code, ran.ram, ran.stack, ran.deepest, mean, most].map(|n| n.to_string());
    let [code, ram, stack, deepest, mean, most] = &numbers;
    let error = format!("{error:.1e}");
    print_row([scene, board.processor, real.name(), code, ram, stack, deepest, mean, most, &error]);
}

#[test]
fn microcontrollers_give_the_bits_of_the_host() {
    let Some(compiler) = Compiler::found().map(Compiler::plain) else { return };
    if !board::are_here() {
        return;
    }
    print_row([
        "scene",
        "processor",
        "numbers",
        "code",
        "ram",
        "stack",
        "bound",
        "a step",
        "at most",
        "error",
    ]);
    for (name, step) in [("saw_gin", 1e-3), ("drives/winch", 5e-4), ("stick_slip", 1e-3)] {
        let model = model_of_specs(name, Keep::Needed);
        let steps = (1.0_f64 / step).round() as usize;
        let mut short = model.clone();
        short.run.until = short.run.from + 1.0;
        let (exact, _) = adaptive(&short);
        for real in [Real::Double, Real::Float] {
            let options = options(real, &model);
            let files = emit(&model, &options).expect("emitted");
            let program = compiler.build(&model.name, &files, &driver::text(&model, real));
            let rows = program.run(step, steps, model.states.len());
            let host = &rows.last().expect("a row").1;
            for board in &board::BOARDS {
                let ran = board.run((&model.name, &files, real), (step, steps), None);
                let what = format!("{name} on {}", board.processor);
                match real {
                    Real::Double => assert_same(&what, &ran.state, host),
                    Real::Float => {
                        let error = difference(&model, &ran.state, host);
                        assert!(error < 1e-3, "{what}: off by {error:e}");
                    }
                }
                let events: f64 = rows.iter().map(|(.., events)| events).sum();
                assert_eq!(ran.events, events as u64, "{what}");
                print_run((name, real), board, &ran, difference(&model, &ran.state, &exact));
            }
        }
    }
}

#[test]
fn a_scene_whose_start_is_searched_for_is_refused_without_a_start() {
    let model = model_of_specs("pendulum_constrained", Keep::Needed);
    let said = |options: &C99Options| emit(&model, options).expect_err("no start").to_string();
    assert!(said(&C99Options::default()).contains("no start is given"));
    let short = C99Options { start: Some(vec![0.0]), ..C99Options::default() };
    assert!(said(&short).contains("the start has 1 entries"), "{}", said(&short));
}

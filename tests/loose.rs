//! `auto` steps at loose tolerances only where a machine forgets errors of steps.

use machinist::field::{Discretisation, FieldSimulator};
use machinist::{Method, Simulation, Sweep, Trajectory};
use machinist_bench_scenes as bench;
use machinist_codegen::mechanics::reduce::Keep;
use machinist_contract::Simulator;
use machinist_scenes::scenes;
use machinist_scenes::scenes::{
    pendulum_constrained, pendulum_relative, saw_gin, stick_slip, winder_full,
};

use crate::common::HardSpring;
use crate::own_scene::{folder_of_specs, of_specs, specs_in};

/// Requested tolerances; the last two are those that steps keep in any case.
const ASKED: [f64; 5] = [1e-2, 1e-3, 1e-4, 1e-5, 1e-6];
/// Number of loosest tolerances; all others are compared with a multiple of the tolerance.
const ANY_CASE: usize = 3;

/// Scenes with ten thousands of steps at 1e-11, of which a tenth of the run is enough.
const LONG: [&str; 2] = ["classics/ring_modulator", "reed_beat_up_one_sided"];

fn by_auto(simulator: &dyn Simulator<f64>, rtol: f64) -> Simulation<'_> {
    Simulation::new(simulator).rtol(rtol).method(Method::Auto)
}

/// Returns the largest difference of a state over its largest value, or its scale if that is
/// larger.
fn error(simulator: &dyn Simulator<f64>, run: &Trajectory, exact: &Trajectory) -> f64 {
    let of_state = |index: usize| {
        let (found, exact) = (&run.columns[index].values, &exact.columns[index].values);
        let size = exact.iter().fold(simulator.state_scale(index), |most, x| most.max(x.abs()));
        let pairs = found.iter().zip(exact);
        pairs.fold(0.0f64, |most, (a, b)| most.max((a - b).abs())) / size
    };
    let states = (0..simulator.shape().states()).filter(|index| !simulator.is_mode(*index));
    states.map(of_state).fold(0.0, f64::max)
}

/// Error of a run over the tolerance.
#[derive(Debug)]
struct Found {
    error: f64,
    steps: u64,
    /// True if the estimate tells an error of hundreds of tolerances, to a factor of ten.
    is_told: bool,
}

/// Returns the errors of a scene over the tolerance.
fn errors(name: &str, simulator: &dyn Simulator<f64>) -> [Found; ASKED.len()] {
    let simulation = |rtol| {
        let run = by_auto(simulator, rtol);
        let defaults = simulator.run_defaults();
        let tenth = defaults.from + 0.1 * (defaults.until - defaults.from);
        if LONG.contains(&name) { run.until(tenth) } else { run }
    };
    let run = |rtol| {
        let run = simulation(rtol).run();
        run.unwrap_or_else(|error| panic!("{name} at {rtol:e}: {error}"))
    };
    let exact = run(1e-11);
    ASKED.map(|rtol| {
        let run = run(rtol);
        let error = error(simulator, &run, &exact);
        let is_told = error > 100.0 * rtol && {
            let estimate = simulation(rtol).error_estimate(&run);
            let told = (0..simulator.shape().states()).map(|index| {
                let column = &exact.columns[index];
                let size = column
                    .values
                    .iter()
                    .fold(simulator.state_scale(index), |most, x| most.max(x.abs()));
                estimate.column(&column.name).map_or(0.0, |told| told.largest) / size
            });
            told.fold(0.0, f64::max) > 0.1 * error
        };
        Found { error: error / rtol, steps: run.work.steps, is_told }
    })
}

/// `cargo test -p machinist-tests --test suite loose:: -- --nocapture` prints all errors.
#[test]
fn errors_of_loose_runs_are_tens_of_tolerances_or_as_those_of_tight_ones_or_told() {
    let root = folder_of_specs();
    let mut rows = Vec::new();
    for path in specs_in(&root) {
        let name = path.strip_prefix(&root).expect("below it").with_extension("");
        let name = name.to_str().expect("a plain path").replace('\\', "/");
        let of_kit = name.strip_prefix("bench/");
        let emitted = of_kit.map_or_else(|| scenes::find_f64(&name), bench::find_f64);
        let field = of_kit.map_or_else(|| scenes::find_field_f64(&name), bench::find_field_f64);
        let errors = match (emitted, field) {
            (Some(simulator), _) => errors(&name, simulator),
            (_, Some(field)) => {
                let cut = FieldSimulator::new(field, Discretisation::default());
                errors(&name, &cut.expect("as its spec says"))
            }
            _ => errors(&name, &of_specs(&name, Keep::Needed)),
        };
        let shown =
            errors.each_ref().map(|it| format!("{:.2} ({})", it.error, it.steps)).join(" | ");
        println!("| {name} | {shown} |");
        rows.push((name, errors));
    }
    for (name, errors) in rows {
        let (loose, tight) = errors.split_at(ANY_CASE);
        let most = tight.iter().fold(100.0f64, |most, it| most.max(2.0 * it.error));
        let is_kept = loose.iter().all(|it| it.error <= most || it.is_told);
        assert!(is_kept, "{name}: {errors:?} tolerances at {ASKED:?}");
    }
}

/// Errors of loose steps add up over many periods of what is nearly undamped, and the estimate says
/// so.
#[test]
fn the_estimate_of_a_long_run_of_loose_steps_tells_its_error() {
    for until in [100.0, 3000.0] {
        let run = |rtol| by_auto(&HardSpring, rtol).until(until).points(101);
        let loose = run(1e-3);
        let found = loose.run().expect("a run");
        let exact = run(1e-12).run().expect("a run");
        let estimate = loose.error_estimate(&found);
        for column in found.columns.iter().take(2) {
            let exact = &exact.column(&column.name).expect("the same columns");
            let off = column.values.iter().zip(*exact).map(|(a, b)| (a - b).abs());
            let off = off.fold(0.0, f64::max);
            let told = estimate.column(&column.name).expect("the same columns").largest;
            assert!(told > 0.1 * off && told < 10.0 * off, "{until}: {told:e} for {off:e}");
        }
    }
}

#[test]
fn machines_that_forget_nothing_and_those_that_switch_are_not_loose_at_all() {
    for simulator in [
        &pendulum_relative::PendulumRelative as &dyn Simulator<f64>,
        &pendulum_constrained::PendulumConstrained,
        &stick_slip::StickSlip,
        &winder_full::WinderFull,
    ] {
        let [loose, tight] = [1e-3, 1e-5].map(|rtol| by_auto(simulator, rtol).run().expect("runs"));
        assert_eq!(loose.work, tight.work, "{}", loose.scene);
    }
}

#[test]
fn variants_in_lanes_keep_to_the_tolerances_of_single_runs() {
    let stiffnesses: Vec<f64> = (0..75).map(|n| 1e4 * 10f64.powf(f64::from(n) / 20.0)).collect();
    for (rtol, max_steps) in [(1e-2, 100_000), (1e-3, 100_000), (1e-4, 300)] {
        let each = move |run: Simulation<'static>| {
            run.points(3).rtol(rtol).method(Method::Auto).max_steps(max_steps)
        };
        let sweep =
            Sweep::new(&saw_gin::SawGin).each(each).vary("coupling.stiffness", &stiffnesses);
        let mut stopped = 0;
        for (found, stiffness) in sweep.expect("a parameter").run().iter().zip(&stiffnesses) {
            let alone = each(Simulation::new(&saw_gin::SawGin))
                .with_small_states_held(false)
                .parameter("coupling.stiffness", *stiffness)
                .and_then(|run| run.run());
            let (found, alone) = match (found, alone) {
                (Ok(found), Ok(alone)) => (found, alone),
                (Err(found), Err(alone)) => {
                    assert_eq!(found.to_string(), alone.to_string());
                    stopped += 1;
                    continue;
                }
                (found, alone) => panic!("{stiffness:e}: {found:?}, alone {alone:?}"),
            };
            assert_eq!(found.steps, alone.work.steps, "{stiffness:e}");
            for (index, value) in found.states[2].iter().enumerate() {
                assert_eq!(value.to_bits(), alone.columns[index].values[2].to_bits());
            }
        }
        assert!(stopped < stiffnesses.len());
        assert_eq!(stopped > 0, max_steps < 1000, "{stopped} stop");
    }
}

//! Estimated errors of runs compared with true ones, for several scenes, random machines and
//! tolerances.
//!
//! `MACHINIST_ERRORS=all` tests every scene of `specs/scenes` and 200 random machines, and counts the
//! rates of the second run; `--nocapture` prints the tables.

#[path = "common/machines.rs"]
mod machines;

use std::sync::atomic::AtomicBool;

use machinist::error::StopCause;
use machinist::error_estimate::ErrorEstimate;
use machinist::trajectory::{Column, Switch, Trajectory};
use machinist::{Discretisation, FieldSimulator, Method, SimulateError, Simulation};
use machinist_codegen::mechanics::reduce::Keep;
use machinist_contract::Simulator;
use machinist_model::ModelSimulator;

use crate::own_scene::{model_of_specs, of_text, scenes_to_try};

/// Smooth and stiff machines, constraints, events, friction that sticks, few steps.
const SCENES: [&str; 11] = [
    "saw_gin",
    "pendulum_chain",
    "pendulum_constrained",
    "winder_full",
    "stick_slip",
    "bouncing_mass",
    "contact_oscillator_smooth",
    "drives/press",
    "parts/rotational/backlash",
    "parts/control/relay",
    "parts/spatial/wheel_set",
];
const TOLERANCES: [f64; 3] = [1e-4, 1e-6, 1e-8];

/// Returns estimated over true errors of the columns of a run whose errors the reference resolves.
fn ratios(
    run: &Trajectory,
    error: &ErrorEstimate,
    (truth, of_truth): &(Trajectory, ErrorEstimate),
) -> Vec<(f64, String)> {
    /// Minimum ratio of an error to that of the reference: the error is then known to a tenth.
    const RESOLVED: f64 = 10.0;
    // Rounding of other columns in the unit is not an error of steps.
    let rounding = |column: &Column| {
        let alike = run.columns.iter().filter(|other| other.unit == column.unit);
        16.0 * f64::EPSILON * alike.map(size).fold(0.0, f64::max)
    };
    let mut ratios = Vec::new();
    for (index, column) in run.columns.iter().enumerate() {
        let off = largest_difference(column, &truth.columns[index]);
        if off > rounding(column) && off > RESOLVED * of_truth.columns[index].largest {
            ratios.push((error.columns[index].largest / off, column.name.clone()));
        }
    }
    ratios
}

fn largest_difference(column: &Column, exact: &Column) -> f64 {
    let off = column.values.iter().zip(&exact.values).map(|(a, b)| (a - b).abs());
    off.fold(0.0, f64::max)
}

fn size(column: &Column) -> f64 {
    column.values.iter().fold(0.0, |most: f64, value| most.max(value.abs()))
}

fn estimated(simulation: &Simulation<'_>) -> Result<(Trajectory, ErrorEstimate), SimulateError> {
    let run = simulation.run()?;
    let error = simulation.error_estimate(&run);
    Ok((run, error))
}

/// Errors found in runs of several machines.
#[derive(Default)]
struct Found {
    /// Estimated over true errors of columns.
    ratios: Vec<(f64, String)>,
    /// True errors over requested accuracies.
    accuracies: Vec<(f64, String)>,
    /// Runs without an estimate, and accuracies that are not met, with the reason.
    unknown: Vec<String>,
    unmet: Vec<String>,
    /// Evaluations of rates by runs and by the second runs for their estimates.
    costs: Vec<[u64; 2]>,
}

impl Found {
    /// Runs a machine at several tolerances and to several accuracies.
    fn add(&mut self, name: &str, simulator: &dyn Simulator<f64>) {
        // No event or jump happens at exactly these times.
        let defaults = simulator.run_defaults();
        let time = |share: f64| defaults.from + share * (defaults.until - defaults.from);
        let shares = (0..100).map(|index| (f64::from(index) * 0.618_034 + 0.1).fract());
        let mut times: Vec<f64> = shares.map(time).collect();
        times.sort_by(f64::total_cmp);
        let run = Simulation::new(simulator).times(&times);
        let Ok(reference) = estimated(&run.clone().rtol(1e-12)) else { return };
        if reference.1.unknown.is_some() {
            return;
        }
        for tolerance in TOLERANCES {
            self.add_run(
                &format!("{name} at {tolerance:e}"),
                &run.clone().rtol(tolerance),
                &reference,
            );
            let name = format!("{name} to {tolerance:e}");
            let found = match run.run_to_accuracy(tolerance) {
                Ok(found) => found,
                Err(error) => {
                    self.unmet.push(format!("{name}: {error}"));
                    continue;
                }
            };
            if let Some(reason) = found.shortfall {
                self.unmet.push(format!("{name}: {reason}"));
            } else if let Some((off, column)) = relative_error(&found.trajectory, &reference) {
                self.accuracies.push((off / tolerance, name + column.as_str()));
            }
        }
    }

    fn add_run(
        &mut self,
        name: &str,
        run: &Simulation<'_>,
        reference: &(Trajectory, ErrorEstimate),
    ) {
        let trajectory = run.run().expect("a run");
        let refined = run.refined().run();
        let rates = |run: &Trajectory| run.work.rate_evaluations;
        self.costs.extend(refined.as_ref().map(|refined| [rates(&trajectory), rates(refined)]));
        let error = ErrorEstimate::of(&trajectory, &refined);
        if let Some(unknown) = &error.unknown {
            self.unknown.push(format!("{name}: {unknown}"));
            return;
        }
        let ratios = ratios(&trajectory, &error, reference).into_iter();
        self.ratios.extend(ratios.map(|(ratio, column)| (ratio, format!("{name}: {column}"))));
    }

    fn print(&self) {
        self.unknown.iter().for_each(|reason| eprintln!("unknown: {reason}"));
        self.unmet.iter().for_each(|reason| eprintln!("not met: {reason}"));
        for least in [0.0, 0.001, 0.01, 0.1, 0.3, 1.0, 3.0, 10.0, 100.0] {
            let count = self.ratios.iter().filter(|(ratio, _)| *ratio >= least).count();
            eprintln!(
                "estimate at least {least} times the error: {count} of {}",
                self.ratios.len()
            );
        }
        let above = |most: f64| self.accuracies.iter().filter(|(off, _)| *off > most).count();
        let [one, three] = [1.0, 3.0].map(above);
        let of = self.accuracies.len();
        eprintln!(
            "error above the accuracy: {one} of {of}, above three times the accuracy: {three}"
        );
        let ratio = |[first, second]: &[u64; 2]| *second as f64 / *first as f64;
        let mut costs: Vec<f64> = self.costs.iter().map(ratio).collect();
        costs.sort_by(f64::total_cmp);
        if let Some(last) = costs.len().checked_sub(1) {
            let [median, most] = [0.5, 0.9].map(|share| costs[(share * last as f64) as usize]);
            eprintln!(
                "rates of the second run over those of the first: median {median:.2}, 9 of 10 below {most:.2}"
            );
        }
    }
}

/// Returns the largest error of a column relative to its largest value, with its name, if the
/// reference resolves it.
fn relative_error(
    run: &Trajectory,
    (truth, of_truth): &(Trajectory, ErrorEstimate),
) -> Option<(f64, String)> {
    let of_column = |(index, column): (usize, &Column)| {
        let exact = &truth.columns[index];
        let alike = truth.columns.iter().filter(|other| other.unit == exact.unit);
        let is_rounding = size(exact) <= 16.0 * f64::EPSILON * alike.map(size).fold(0.0, f64::max);
        let off = (largest_difference(column, exact) - of_truth.columns[index].largest).max(0.0);
        // Such as an energy of zero: the sum of large ones that cancel.
        let is_resolved = of_truth.columns[index].largest <= 0.1 * size(exact);
        (!is_rounding && is_resolved).then(|| (off / size(exact), format!(": {}", column.name)))
    };
    let columns = run.columns.iter().enumerate().filter_map(of_column);
    columns.max_by(|a, b| a.0.total_cmp(&b.0))
}

#[test]
fn estimates_are_within_a_factor_of_ten_of_the_error_and_never_a_hundred_times_too_small() {
    let mut found = Found::default();
    let is_whole = std::env::var("MACHINIST_ERRORS").is_ok_and(|which| which == "all");
    for name in scenes_to_try("MACHINIST_ERRORS", &SCENES) {
        let model = model_of_specs(&name, Keep::Needed);
        let machine = ModelSimulator::new(model.clone());
        let field = (!model.fields.is_empty()).then(|| {
            FieldSimulator::new(machine.with_fields(), Discretisation::default()).expect("cut")
        });
        found.add(&name, field.as_ref().map_or_else(|| machine.single(), FieldSimulator::single));
    }
    for seed in 0..if is_whole { 200 } else { 12 } {
        let machine = of_text(&machines::machine(seed).spec, Keep::Needed);
        found.add(&format!("random machine {seed}"), machine.single());
    }
    found.ratios.sort_by(|a, b| a.0.total_cmp(&b.0));
    found.accuracies.sort_by(|a, b| b.0.total_cmp(&a.0));
    found.print();
    let Found { ratios, accuracies, .. } = found;
    let within = ratios.iter().filter(|(ratio, _)| (0.1..=10.0).contains(ratio)).count();
    let worst = &ratios[..ratios.len().min(8)];
    assert!(ratios.len() > 100, "{} columns", ratios.len());
    assert!(within as f64 >= 0.95 * ratios.len() as f64, "{within} of {}: {worst:?}", ratios.len());
    assert!(ratios[0].0 > 0.01, "{worst:?}");
    let missed = accuracies.iter().filter(|(off, _)| *off > 3.0).count();
    let worst = &accuracies[..accuracies.len().min(8)];
    assert!(accuracies.len() > 30, "{} runs", accuracies.len());
    assert!(missed as f64 <= 0.01 * accuracies.len() as f64, "{missed}: {worst:?}");
}

#[test]
fn a_closed_form_is_off_by_rounding_alone() {
    let model = model_of_specs("two_mass", Keep::Needed);
    let simulator = ModelSimulator::new(model);
    let run = Simulation::new(&simulator).method(Method::Exact);
    let (trajectory, error) = estimated(&run).expect("a run");
    for (column, error) in trajectory.columns.iter().zip(&error.columns) {
        let size = size(column);
        // The closed forms of both runs differ by the rounding of the matrix exponential.
        assert!(error.largest <= 1e-12 * size, "{}: {}", column.name, error.largest);
        assert!(error.largest >= f64::EPSILON * size, "{}: {}", column.name, error.largest);
    }
}

#[test]
fn runs_with_other_events_say_that_their_error_is_unknown() {
    let simulator = ModelSimulator::new(model_of_specs("stick_slip", Keep::Needed));
    let simulation = Simulation::new(&simulator);
    let run = simulation.run().expect("a run");
    let refined = simulation.refined().run().expect("a run");
    assert_eq!(ErrorEstimate::of(&run, &Ok(refined.clone())).unknown, None);
    let last = run.switches.last().expect("it sticks and slips").clone();
    let mut more = refined.clone();
    more.switches.push(Switch { time: last.time + 0.01, ..last.clone() });
    let mut fewer = refined.clone();
    fewer.switches.pop();
    let mut others = refined;
    others.switches.last_mut().expect("it sticks and slips").event = "slider.jumps".to_owned();
    for (refined, time) in [(more, last.time + 0.01), (fewer, last.time), (others, last.time)] {
        let estimate = ErrorEstimate::of(&run, &Ok(refined));
        let reason = estimate.unknown.expect("other events");
        let start = format!("from event `{}` at {time} s on, ", last.event);
        assert!(reason.starts_with(&start), "{reason}");
        assert!(estimate.columns.is_empty());
    }
}

#[test]
fn an_accuracy_is_met_by_the_true_error_or_the_reason_is_said() {
    for name in ["pendulum_chain", "saw_gin", "slider_crank", "stick_slip"] {
        let simulator = ModelSimulator::new(model_of_specs(name, Keep::Needed));
        let run = Simulation::new(&simulator).points(98);
        let truth = run.clone().rtol(1e-13).run().expect("a run");
        for accuracy in [1e-4, 1e-6, 1e-8] {
            let found = run.run_to_accuracy(accuracy).expect("a run");
            assert_eq!(found.shortfall, None, "{name} to {accuracy:e}");
            for (column, exact) in found.trajectory.columns.iter().zip(&truth.columns) {
                let (off, size) = (largest_difference(column, exact), size(exact));
                let is_met = off <= 3.0 * accuracy * size || size < 1e-15;
                assert!(is_met, "{name}: {}: {off:e} of {size:e}", column.name);
            }
        }
        let impossible = run.run_to_accuracy(1e-17).expect("a run").shortfall.expect("a reason");
        assert!(impossible.starts_with("the error of `"), "{impossible}");
    }
    let simulator = ModelSimulator::new(model_of_specs("saw_gin", Keep::Needed));
    for accuracy in [0.0, -1.0, f64::NAN, 2.0] {
        let refused = Simulation::new(&simulator).run_to_accuracy(accuracy);
        assert!(matches!(refused, Err(SimulateError::BadAccuracy(_))), "{accuracy}");
    }
}

/// The limit of steps ends an attempt after others; an interruption ends all.
#[test]
fn an_attempt_that_fails_leaves_the_best_one_before_it() {
    let simulator = ModelSimulator::new(model_of_specs("pendulum_chain", Keep::Needed));
    let run = Simulation::new(&simulator).method(Method::Tsit5).rtol(1e-4);
    let steps = run.clone().rtol(1e-9).run().expect("a run").work.steps as usize;
    let limited = run.clone().max_steps(steps);
    let found = limited.run_to_accuracy(1e-12).expect("the best attempt");
    let reason = found.shortfall.expect("a reason");
    assert!(reason.contains("the attempt at rtol ") && reason.contains("limit of"), "{reason}");
    assert!(found.trajectory.rtol < 1e-4, "{:e}", found.trajectory.rtol);
    let estimate =
        limited.error_estimate(&limited.clone().at_tolerance(1e-4).run().expect("a run"));
    for (first, best) in estimate.columns.iter().zip(&found.error.columns) {
        assert!(best.largest <= first.largest, "{best:?}");
    }
    assert!(run.clone().max_steps(3).run_to_accuracy(1e-3).is_err());
    let mut attempts = 0;
    let interrupted = run.run_to_accuracy_by(1e-12, |simulation| {
        let flag = AtomicBool::new(attempts == 1);
        attempts += 1;
        let run = simulation.clone().until_flagged(&flag).run()?;
        let error = simulation.error_estimate(&run);
        Ok((run, error))
    });
    let Err(SimulateError::Stopped { cause, .. }) = interrupted else { panic!("{interrupted:?}") };
    assert_eq!((attempts, cause), (2, StopCause::Interrupted));
}

//! Consistency of an estimator, over runs with the noise of its design.

use std::borrow::Cow;

use clap::Args;
use machinist::Simulation;
use machinist::estimator::{Consistency, ConsistencyRun, Instant};
use machinist::linear_analysis::{Place, operating_point};
use machinist_contract::fixed_step::StepMethod;
use machinist_model::Elimination;
use machinist_studies::verify::Verdict;

use crate::cli::amount::time;
use crate::cli::arguments::{MachineArgs, RunArgs};
use crate::cli::estimator::EstimatorArgs;
use crate::cli::run::step_method;
use crate::cli::scene::Scene;
use crate::cli::settings::with_parameters;
use crate::failure::Failure;
use crate::number::number;
use crate::progress::during;

/// Number of instants at which errors are compared.
const INSTANTS: usize = 10;

#[derive(Debug, Clone, Args)]
pub struct EstimatorRuns {
    #[command(flatten)]
    pub estimator: EstimatorArgs,
    /// Time between measurements, one fixed step
    #[arg(long, help_heading = "Estimator", value_name = "TIME", value_parser = time)]
    sample: Option<f64>,
    /// Method of the steps, rk4 or heun
    #[arg(long, help_heading = "Estimator", value_name = "NAME", value_parser = step_method)]
    step: Option<StepMethod>,
    /// Time at which the estimator starts, on the scene's run
    #[arg(long, help_heading = "Estimator", value_name = "TIME", value_parser = time)]
    since: Option<f64>,
    /// Number of runs with random noise
    #[arg(long, help_heading = "Estimator", value_name = "COUNT", default_value = "200")]
    draws: usize,
    /// Seed of the noise
    #[arg(long, help_heading = "Estimator", value_name = "NUMBER", default_value = "1")]
    seed: u64,
}

impl EstimatorRuns {
    /// Returns an error for options without an estimator.
    pub fn check(&self, scene: Option<&String>) -> Result<(), Failure> {
        if !self.estimator.is_given() {
            let given = [
                ("--sample", self.sample.is_some()),
                ("--step", self.step.is_some()),
                ("--since", self.since.is_some()),
            ];
            return match given.into_iter().find(|(_, is_given)| *is_given) {
                None => Ok(()),
                Some((option, _)) => {
                    let message = format!("{option} is for an estimator, but none is given");
                    Err(Failure::input(message, "add --estimator ekf --measure OUTPUT=DEVIATION"))
                }
            };
        }
        if scene.is_none() {
            let message = "an estimator is of one scene, but none is given";
            return Err(Failure::input(message, "machinist verify SCENE --estimator ekf ..."));
        }
        if self.draws < 2 {
            return Err(Failure::input(format!("{} draws are too few", self.draws), ""));
        }
        Ok(())
    }

    /// Tests the estimator: one row for its errors and one for its innovations.
    pub fn verdicts(
        &self,
        scene: &str,
        machine: &MachineArgs,
        run: &RunArgs,
    ) -> Result<Vec<Verdict>, Failure> {
        let scene = Scene::load(scene, &machine.loading())?;
        let simulator = scene.simulator();
        let simulation = with_parameters(Simulation::new(simulator), &machine.set)?;
        let simulation = run.apply(machine.with_initial(simulation)?)?;
        let place = self.since.map_or(Place::Initial, Place::Time);
        let pattern = simulator.rate_jacobian_pattern().entries;
        let list = Elimination::new(simulator.shape().states(), pattern);
        let method = self.step.unwrap_or_default().with(list.borrowed());
        let indices = self.estimator.indices(simulator, method)?;
        let point = during("simulating", || operating_point(&simulation, place))?;
        let until = run.span.until.unwrap_or(simulator.run_defaults().until);
        let step = self.sample.ok_or_else(|| {
            Failure::input("an estimator needs the time between measurements", "--sample 1ms")
        })?;
        let steps = ((until - point.time) / step).round();
        if !(step > 0.0 && steps >= INSTANTS as f64) {
            let span = until - point.time;
            let message =
                format!("{span} s have fewer than {INSTANTS} measurements every {step} s");
            return Err(Failure::input(
                message,
                "shorten --sample, or end the run later by --until",
            ));
        }
        let (draws, seed) = (self.draws, self.seed);
        let runs = ConsistencyRun { step, steps: steps as usize, draws, instants: INSTANTS, seed };
        let start = (point.time, &point.state[..], &point.parameters[..]);
        let found = during("estimating", || Consistency::of(simulator, &indices, start, &runs));
        let name = simulator.name();
        let modes = found.other_modes;
        let mut errors = verdict(name, "estimator: errors (NEES)", &found.nees, modes);
        let outputs = found
            .outputs
            .iter()
            .map(|output| format!("{} {} {}", output.name, number(output.error, 3), output.unit));
        let outputs = outputs.collect::<Vec<_>>().join(", ");
        errors.reason =
            format!("{}; root mean square errors at the end: {outputs}", errors.reason).into();
        Ok(vec![errors, verdict(name, "estimator: innovations (NIS)", &found.nis, modes)])
    }
}

/// Judges the mean over the instants by the band of a single instant, which is wider than its own.
fn verdict(scene: &str, check: &'static str, instants: &[Instant], other_modes: usize) -> Verdict {
    let ratio = |value: f64, instant: &Instant| value / instant.freedom.max(1) as f64;
    let mean =
        |of: &dyn Fn(&Instant) -> f64| instants.iter().map(of).sum::<f64>() / instants.len() as f64;
    let found = mean(&|instant| ratio(instant.mean, instant));
    let tolerance = mean(&|instant| 0.5 * ratio(instant.band[1] - instant.band[0], instant));
    let within = instants.iter().filter(|instant| instant.is_within()).count();
    let error = (found - 1.0).abs();
    let worst = instants.iter().map(|instant| (instant, ratio(instant.mean, instant)));
    let worst = worst.max_by(|a, b| (a.1 - 1.0).abs().total_cmp(&(b.1 - 1.0).abs()));
    let failure = (error.is_nan() || error > tolerance).then(|| {
        let worst = worst.map_or_else(String::new, |(instant, ratio)| {
            format!("; {ratio:.3} of the expected value at {} s", instant.time)
        });
        let modes = match other_modes {
            0 => String::new(),
            count => format!("; other modes than the machine's {count} times"),
        };
        let count = instants.len();
        format!(
            "the covariance does not describe the errors: {within} of {count} instants are \
                 within 95 %{worst}{modes}"
        )
    });
    let reason = format!(
        "half the 95 % band of the mean over {} runs; {within} of {} instants are within it",
        instants.iter().map(|instant| instant.draws).min().unwrap_or(0),
        instants.len()
    );
    Verdict {
        scene: scene.to_owned(),
        check: Cow::Borrowed(check),
        reference: Cow::Borrowed("the chi-squared distribution, relative to its mean"),
        error,
        tolerance,
        reason: Cow::Owned(reason),
        pass: failure.is_none(),
        value: Some(found),
        expected: Some(1.0),
        failure,
        skipped: None,
        unchecked: None,
    }
}

//! Run with an error estimate from a second run on another thread.

use std::sync::atomic::{AtomicBool, Ordering};
use std::thread;

use clap::Args;
use machinist::error::StopCause;
use machinist::error_estimate::ErrorEstimate;
use machinist::trajectory::{Column, Trajectory};
use machinist::{SimulateError, Simulation};

use super::{At, RunCommand};
use crate::cli::scene::Scene;
use crate::cli::threads::lender;
use crate::failure::Failure;
use crate::number::number;
use crate::progress::during;

#[derive(Debug, Args)]
pub struct Options {
    /// Do not estimate the error, which takes a second run
    #[arg(long)]
    no_error: bool,
    /// Tighten the tolerance until the estimated error of every column, relative to its largest
    /// value, is at most this
    #[arg(long, value_name = "PART", conflicts_with_all = ["no_error", "fixed"], allow_hyphen_values = true)]
    accuracy: Option<f64>,
}

/// Run, and the reason why it misses the accuracy asked for, if it does.
pub type Estimated = (Trajectory, Option<String>);

impl RunCommand {
    /// Runs the scene. Estimates the error if it is shown or an accuracy is asked for, unless this
    /// is turned off.
    pub(super) fn estimated(
        &self,
        scene: &Scene,
        times: &At<'_>,
        is_shown: bool,
    ) -> Result<Result<Estimated, SimulateError>, Failure> {
        let is_wanted = is_shown && !self.error.no_error || self.error.accuracy.is_some();
        if !is_wanted {
            let run = self.trajectory(scene.simulator(), &self.scene.machine.set, times)?;
            return Ok(run.map(|run| (self.chosen_columns(run), None)));
        }
        self.simulated(scene.simulator(), &self.scene.machine.set, times, |simulation| {
            let both = |simulation: &Simulation<'_>| self.both(scene, times, simulation);
            let Some(accuracy) = self.error.accuracy else {
                let (run, error) = both(simulation)?;
                return Ok((Trajectory { error: Some(error), ..run }, None));
            };
            let found = simulation.run_to_accuracy_by(accuracy, both)?;
            let error = Some(found.error);
            Ok((Trajectory { error, ..found.trajectory }, found.shortfall))
        })
    }

    /// Runs the scene, and in parallel at a tighter tolerance.
    fn both(
        &self,
        scene: &Scene,
        times: &At<'_>,
        simulation: &Simulation<'_>,
    ) -> Result<(Trajectory, ErrorEstimate), SimulateError> {
        let rtol = simulation.relative_tolerance();
        let (lender, is_abandoned) = (lender(scene), AtomicBool::new(false));
        thread::scope(|scope| {
            let refined = scope.spawn(|| {
                let is_over =
                    || is_abandoned.load(Ordering::Relaxed).then_some(StopCause::Interrupted);
                let mut refined = None;
                lender(&mut |simulator| {
                    let run =
                        self.simulated(simulator, &self.scene.machine.set, times, |simulation| {
                            let simulation = simulation.clone().at_tolerance(rtol);
                            simulation.refined().until_told(&is_over).run()
                        });
                    refined = run.ok();
                });
                refined
            });
            let run = during("simulating", || simulation.run());
            is_abandoned.store(run.is_err(), Ordering::Relaxed);
            let run = self.chosen_columns(run?);
            let refined = during("estimating the error", || refined.join());
            // The second run accepts all settings of the first.
            let refined = refined.ok().flatten().expect("a second run like the first");
            let refined = refined.map(|refined| self.chosen_columns(refined));
            let error = ErrorEstimate::of(&run, &refined);
            Ok((run, error))
        })
    }
}

/// Formats the error of a column for people; `None` without an estimate.
pub fn cell(trajectory: &Trajectory, column: &Column) -> Option<String> {
    let estimate = trajectory.error.as_ref()?;
    let error = estimate.column(&column.name);
    Some(error.map_or_else(|| "?".to_owned(), |error| number(error.largest, 1)))
}

/// Formats the reason why errors are unknown, on a line of its own.
pub fn remark(trajectory: &Trajectory) -> String {
    let unknown = trajectory.error.as_ref().and_then(|error| error.unknown.as_ref());
    unknown.map_or_else(String::new, |reason| format!("\nerror unknown: {reason}"))
}

//! Step of Co-Simulation by sources, and its error in the run of the scene.

use machinist::Simulation;
use machinist_codegen::emit::c99::step_cost;
use machinist_contract::fixed_step::StepMethod;
use machinist_fmu::resource::Machine;

use super::source::SourceSettings;
use crate::cli::run::{Fixed, LargestError};
use crate::failure::Failure;
use crate::progress::during;

/// Error of an output, relative to its range, to which the step is halved.
const WANTED: f64 = 1e-4;
/// Operations of the largest run that the search for a step takes: some seconds.
const MOST_OPERATIONS: f64 = 4e9;

/// Step of Co-Simulation.
pub struct FixedStep {
    /// Size \[s\].
    pub size: f64,
    /// Sentence about method, step and error, without a full stop.
    pub statement: String,
}

/// Returns the given step with its error, or else halves the interval of the scene's output until
/// the error is small.
pub fn fixed_step(machine: &Machine, settings: &SourceSettings) -> Result<FixedStep, Failure> {
    let (run, rows) = (&machine.model().run, machine.model().run.points.max(2) - 1);
    let span = run.until - run.from;
    let simulation = Simulation::new(machine.simulator());
    let method = settings.method;
    if let Some(size) = settings.step {
        let steps = Fixed::of(size, method);
        let stepping = during("stepping", || steps.run(&simulation, run.until, rows))?;
        let exact = simulation.clone().times(stepping.times());
        let exact = during("simulating", || exact.run())?;
        let error = stepping.largest_error(&simulation, &exact);
        return Ok(FixedStep { size, statement: statement(method, size, &error) });
    }
    let times: Vec<f64> = (0..=rows).map(|k| run.from + span * k as f64 / rows as f64).collect();
    let exact = during("simulating", || simulation.clone().times(&times).run())?;
    let operations = step_cost(machine.model(), method).usual as f64;
    let mut last = None;
    for halvings in 0..32 {
        let size = span / rows as f64 / f64::from(1_u32 << halvings);
        if last.is_some() && span / size * operations > MOST_OPERATIONS {
            break;
        }
        // A step at which the method is unstable ends in an error, or in numbers that are not finite.
        let steps = Fixed::of(size, method);
        last = match during("stepping", || steps.run(&simulation, run.until, rows)) {
            Ok(stepping) => {
                let error = stepping.largest_error(&simulation, &exact);
                let is_small = error.relative <= WANTED;
                let found = FixedStep { size, statement: statement(method, size, &error) };
                if is_small {
                    return Ok(found);
                }
                Some(Ok(found))
            }
            Err(failure) => Some(Err(failure)),
        };
    }
    // The search takes at least one step.
    last.unwrap_or_else(|| Err(Failure::input("the run has no length", "")))
}

fn statement(method: StepMethod, size: f64, error: &LargestError) -> String {
    let LargestError { relative, name } = error;
    format!(
        "{} with steps of at most {size:e} s: largest error in the scene's run {relative:.1e} of the \
         range of {name}",
        method.name()
    )
}

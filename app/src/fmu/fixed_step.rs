//! Step of Co-Simulation by sources, and its error in the run of the scene.

use machinist::Simulation;
use machinist_codegen::emit::c99::{Real, step_cost};
use machinist_contract::fixed_step::StepMethod;
use machinist_fmu::resource::Machine;

use super::source::SourceSettings;
use crate::cli::run::{Fixed, LargestError};
use crate::failure::Failure;
use crate::progress::during;

/// Error of an output, relative to its range, to which the step is halved.
const WANTED: f64 = 1e-4;
/// Operations of the largest run that the search for a step takes: ten seconds.
const MOST_OPERATIONS: f64 = 5e9;

/// Number of halvings that do not halve the error, after which the search for a step ends.
const IN_VAIN: usize = 6;
/// Largest number of steps in the scene's run.
const MOST_STEPS: f64 = 1e9;
const ADVICE: &str = "use smaller steps, or `--step ros2` for a stiff machine";

/// Step of Co-Simulation.
pub struct FixedStep {
    /// Size \[s\].
    pub size: f64,
    pub method: StepMethod,
    /// Error in the run of the scene.
    error: LargestError,
    /// Reason why the error is not below [`WANTED`].
    reason: Option<Reason>,
}

/// Reason why the search for a step ends above the wanted error.
#[derive(Clone, Copy)]
enum Reason {
    /// Smaller steps do not reduce the error.
    InVain,
    /// Smaller steps would take too many operations.
    TooMany,
}

impl FixedStep {
    /// Returns the given step with its error, or else halves the interval of the scene's output
    /// until the error is small. Without a given method, it is explicit where that is stable.
    pub fn of(machine: &Machine, settings: &SourceSettings) -> Result<Self, Failure> {
        let Some(size) = settings.step else { return searched(machine, settings.method) };
        let method = settings.method.unwrap_or_default();
        let error = error_of(machine, method, size)?;
        Ok(Self { size, method, error, reason: None })
    }

    /// Returns a sentence about method, step and error, without a full stop.
    pub fn statement(&self) -> String {
        let LargestError { relative, name } = &self.error;
        let in_vain = match self.reason {
            None => "",
            Some(Reason::InVain) => ", which smaller steps do not bring below 1e-4",
            Some(Reason::TooMany) => {
                "; smaller steps would take the search too long, `--step-size` sets them"
            }
        };
        format!(
            "{} with steps of at most {:e} s: largest error in the scene's run {relative:.1e} of \
             the range of {name}{in_vain}",
            self.method.name(),
            self.size
        )
    }
}

/// Returns the error of steps of a given size.
fn error_of(machine: &Machine, method: StepMethod, size: f64) -> Result<LargestError, Failure> {
    let (run, rows) = (&machine.model().run, machine.model().run.points.max(2) - 1);
    let wanted = (run.until - run.from) / size;
    if wanted > MOST_STEPS {
        let message =
            format!("--step-size {size:e}: the scene's run would take {wanted:.0e} steps");
        return Err(Failure::input(message, "use larger steps"));
    }
    let simulation = Simulation::new(machine.simulator());
    let steps = Fixed::of(size, method, ADVICE);
    let stepping = during("stepping", || steps.run(&simulation, run.until, rows))?;
    let exact = simulation.clone().times(stepping.times());
    let exact = during("simulating", || exact.run())?;
    let error = stepping.largest_error(&simulation, &exact);
    if error.relative.is_finite() {
        return Ok(error);
    }
    let message =
        format!("{} with steps of {size:e} s: {} is not finite", method.name(), error.name);
    Err(Failure::unsuccessful(message, ADVICE))
}

/// Halves the interval of the output until the error is small, or does not fall any more. Where the
/// explicit method is unstable and none is given, the implicit one is tried too.
fn searched(machine: &Machine, given: Option<StepMethod>) -> Result<FixedStep, Failure> {
    let (run, rows) = (&machine.model().run, machine.model().run.points.max(2) - 1);
    let span = run.until - run.from;
    let simulation = Simulation::new(machine.simulator());
    let times: Vec<f64> = (0..=rows).map(|k| run.from + span * k as f64 / rows as f64).collect();
    let exact = during("simulating", || simulation.clone().times(&times).run())?;
    let both = [StepMethod::RungeKutta4, StepMethod::Rosenbrock2];
    let methods = given.map_or_else(|| both.to_vec(), |method| vec![method]);
    let mut best: Option<FixedStep> = None;
    let (mut failure, mut in_vain) = (None, 0);
    for halvings in 0..32 {
        let size = span / rows as f64 / f64::from(1_u32 << halvings);
        let is_first = best.is_none() && failure.is_none();
        let operations = step_cost(machine.model(), methods[0], Real::Double).usual as f64;
        if in_vain == IN_VAIN {
            break;
        }
        if !is_first && span / size * operations > MOST_OPERATIONS {
            if let Some(reason) = best.as_mut().and_then(|best| best.reason.as_mut()) {
                *reason = Reason::TooMany;
            }
            break;
        }
        let last = best.as_ref().map_or(f64::INFINITY, |best| best.error.relative);
        for &method in &methods {
            let steps = Fixed::of(size, method, ADVICE);
            let stepping = during("stepping", || steps.run(&simulation, run.until, rows));
            match stepping.map(|stepping| stepping.largest_error(&simulation, &exact)) {
                Err(unstable) => failure = Some(unstable),
                // Outputs may be infinite where the state is still finite.
                Ok(error) if !error.relative.is_finite() => {}
                Ok(error) => {
                    let reason = (error.relative > WANTED).then_some(Reason::InVain);
                    if error.relative < last {
                        best = Some(FixedStep { size, method, error, reason });
                    }
                    break;
                }
            }
        }
        let Some(found) = &best else { continue };
        if found.reason.is_none() {
            break;
        }
        in_vain = if found.error.relative < 0.5 * last { 0 } else { in_vain + 1 };
    }
    let missing = || Failure::input("no step has finite outputs in the scene's run", ADVICE);
    best.ok_or_else(|| failure.unwrap_or_else(missing))
}

//! References of errors.

use std::time::Duration;

use serde::{Serialize, Serializer};

use super::{KnownState, distance, precise, run, states};
use crate::double_double::Twin;
use machinist::error::SimulateError;
use machinist::method::Method;
use machinist::simulate::Simulation;
use machinist::trajectory::{ColumnKind, Trajectory};

/// Tolerances of a reference, the tightest first: a method that stops at one may succeed at the
/// next.
const TIGHT: [f64; 3] = [1e-13, 1e-12, 1e-10];
/// Tolerance of the run that determines times and sizes of states.
const PILOT: f64 = 1e-8;
/// Number of runs from which a reference is chosen.
const CONFIRMING: usize = 3;
/// Maximum number of steps of a run for a reference.
const MAX_STEPS: usize = 300_000;

/// States over time that are more accurate than the measured runs.
#[derive(Debug, Clone, PartialEq)]
pub struct Reference {
    /// Description: the way to the reference and its accuracy.
    pub name: String,
    /// Difference between two ways to the reference, in the measure of errors. Smaller errors have
    /// no meaning.
    pub agreement: f64,
    states: Vec<KnownState>,
}

impl Reference {
    /// Computes a run of the same machine in numbers of 31 digits, if there is one with Taylor
    /// series; otherwise a converged run. Each takes no longer than the limit, if there is one.
    ///
    /// # Errors
    /// [`SimulateError`] of the last method tried if none completes the run.
    pub fn of(
        machine: &Simulation<'_>,
        twin: Option<&dyn Twin>,
        time_limit: Option<Duration>,
    ) -> Result<Self, SimulateError> {
        let precise = twin.map(|twin| Self::precise(machine, twin, time_limit)).transpose()?;
        precise.flatten().map_or_else(|| Self::converged(machine, time_limit), Ok)
    }

    /// Computes a reference by Taylor series in numbers of 31 digits; `None` if that fails, or if
    /// two runs differ by more than the last digits of measured values.
    ///
    /// # Errors
    /// [`SimulateError`] if the scene does not run at all.
    pub fn precise(
        machine: &Simulation<'_>,
        twin: &dyn Twin,
        time_limit: Option<Duration>,
    ) -> Result<Option<Self>, SimulateError> {
        let Some(series) = precise::series(twin) else { return Ok(None) };
        let pilot = run(machine, Method::Auto, PILOT, time_limit).run()?;
        let Some(solved) = precise::solve(twin, series, machine.parameter_values(), &pilot) else {
            return Ok(None);
        };
        let agreement = solved.agreement;
        if agreement.is_nan() || agreement > f64::EPSILON {
            return Ok(None);
        }
        let name = format!(
            "Taylor series in numbers of 31 digits, two runs of which differ by {agreement:.1e}"
        );
        let columns = pilot.of_kind(ColumnKind::State).map(|column| column.name.clone());
        let simulator = machine.simulator();
        let scales = (0..simulator.shape().states()).map(|index| simulator.state_scale(index));
        let states = columns.zip(solved.states).zip(scales);
        let states = states.map(|((name, values), scale)| KnownState::new(name, values, scale));
        let states = states.collect();
        Ok(Some(Self { name, agreement, states }))
    }

    /// Takes the three methods of highest order that complete the run at their tightest tolerance,
    /// and of these the two that agree best; the one of higher order is the reference.
    ///
    /// # Errors
    /// As for [`Reference::of`].
    pub fn converged(
        machine: &Simulation<'_>,
        time_limit: Option<Duration>,
    ) -> Result<Self, SimulateError> {
        let simulator = machine.simulator();
        let mut runs: Vec<Trajectory> = Vec::new();
        let mut failure = None;
        // `auto` would confirm its chosen method by itself.
        let candidates = Method::compiled_in().filter(|method| *method != Method::Auto);
        let mut candidates: Vec<Method> =
            candidates.filter(|method| method.suits(simulator)).collect();
        candidates.sort_by_key(|method| std::cmp::Reverse(method.order()));
        for method in candidates {
            if runs.len() == CONFIRMING {
                break;
            }
            match tightest(machine, method, time_limit) {
                Ok(trajectory) => runs.push(trajectory),
                Err(error) => failure = Some(error),
            }
        }
        runs.sort_by_key(|run| std::cmp::Reverse(run.method.order()));
        let pairs = runs.iter().enumerate().flat_map(|(index, first)| {
            let others = runs[index + 1..].iter();
            others.map(move |second| (distance(second, &states(simulator, first)), first, second))
        });
        let best = pairs.min_by(|a, b| a.0.total_cmp(&b.0));
        match (best, runs.first(), failure) {
            (Some((agreement, first, second)), ..) => {
                let name = format!(
                    "a run of {} at rtol {:.0e}, from which one of {} at rtol {:.0e} differs by \
                     {agreement:.1e}",
                    first.method, first.rtol, second.method, second.rtol
                );
                Ok(Self { name, agreement, states: states(simulator, first) })
            }
            (None, Some(only), _) => {
                let name = format!(
                    "a run of {} at rtol {:.0e}, which no other method confirms",
                    only.method, only.rtol
                );
                Ok(Self { name, agreement: f64::NAN, states: states(simulator, only) })
            }
            (None, None, Some(error)) => Err(error),
            (None, None, None) => unreachable!("there are methods"),
        }
    }

    /// Returns max over states of max over time |y - reference|/size of the state: its largest
    /// value, or its scale if that value is only rounding.
    #[must_use]
    pub fn distance(&self, trajectory: &Trajectory) -> f64 {
        distance(trajectory, &self.states)
    }
}

impl Serialize for Reference {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        #[derive(Serialize)]
        struct Shown<'a> {
            name: &'a str,
            agreement: Option<f64>,
        }
        let agreement = self.agreement.is_finite().then_some(self.agreement);
        Shown { name: &self.name, agreement }.serialize(serializer)
    }
}

fn tightest(
    machine: &Simulation<'_>,
    method: Method,
    time_limit: Option<Duration>,
) -> Result<Trajectory, SimulateError> {
    let attempt = |rtol| run(machine, method, rtol, time_limit).max_steps(MAX_STEPS).run();
    let mut result = attempt(TIGHT[0]);
    for rtol in &TIGHT[1..] {
        if result.is_ok() {
            break;
        }
        result = attempt(*rtol);
    }
    result
}

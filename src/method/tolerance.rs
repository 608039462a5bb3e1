//! Tolerances that steps hold.

use machinist_contract::Simulator;
use machinist_contract::taylor::TaylorSeries;

use super::Auto;
use crate::method_table::Method;

/// Ratio of the tolerances of both runs of an error estimate. With methods of order 5 and 8 the second run takes
/// 2^(1/5) = 1.15 and 2^(1/8) = 1.09 times the steps of the first, and an error that is proportional
/// to a power of the tolerance between 0.8 and 1.2 is off by a seventh at most.
pub const REFINEMENT: f64 = 2.0;

/// Tolerances of the steps of a run, made once from those requested. Everything that compares an
/// error uses these: error control, events, relations, projection and notes.
#[derive(Debug, Clone, PartialEq)]
pub struct StepTolerance {
    /// Relative tolerance.
    pub rtol: f64,
    /// Absolute tolerance of every state.
    pub atol: Vec<f64>,
    /// Why these are tighter than requested, if they are.
    pub reason: Option<&'static str>,
    /// True if the first step of every segment is shortened. Lengths of first steps, limits of their
    /// growth and ends of segments do not depend on the tolerance, so two runs could otherwise take the
    /// same steps and have the same error.
    pub shortens: bool,
}

impl StepTolerance {
    /// Returns the tolerances as requested.
    #[must_use]
    pub fn requested(rtol: f64, atol: Vec<f64>) -> Self {
        Self { rtol, atol, reason: None, shortens: false }
    }

    /// Returns the tolerances for the steps of a method. Absolute tolerances change in proportion to
    /// the relative one.
    #[must_use]
    pub fn new(
        (method, auto): (Method, Auto),
        machine: (&dyn Simulator<f64>, &[f64]),
        (requested, mut atol): (f64, Vec<f64>),
    ) -> Self {
        let (rtol, reason) = step_rtol((method, auto), machine, requested);
        if reason.is_some() {
            for atol in &mut atol {
                *atol *= rtol / requested;
            }
        }
        Self { rtol, atol, reason, shortens: false }
    }
}

/// Returns the relative tolerance of steps, and the reason if it is tighter than requested.
pub(crate) fn step_rtol(
    (method, auto): (Method, Auto),
    (simulator, parameters): (&dyn Simulator<f64>, &[f64]),
    requested: f64,
) -> (f64, Option<&'static str>) {
    auto.step_rtol(method, requested, || keeps_errors(simulator, parameters))
}

/// Returns why errors of single steps say little about those of the run, if they do. A machine that
/// conserves energy forgets nothing, and its pace errs with its energy: errors of its motion grow
/// with the square of its steps. A machine that switches does so at another time, or not at all.
fn keeps_errors(simulator: &dyn Simulator<f64>, parameters: &[f64]) -> Option<&'static str> {
    let has_corners = || simulator.taylor().is_some_and(TaylorSeries::has_corners);
    if simulator.constraints() > 0 {
        Some("errors add up in a machine with constraints")
    } else if simulator.events() > 0 || simulator.kinks() > 0 || has_corners() {
        Some("a machine that switches may do so at another time, or not at all")
    } else {
        let conserves = simulator.conserves_energy(parameters).unwrap_or(true);
        conserves.then_some("errors add up in a machine that conserves energy")
    }
}

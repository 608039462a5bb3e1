//! Tolerances that steps hold.

use machinist_contract::Simulator;
use machinist_contract::taylor::{Bends, TaylorSeries};
use serde::{Deserialize, Serialize};

use super::Method;

/// Loosest relative tolerance of the steps of `auto`: a motion that is known to a hundredth is not
/// known.
pub(crate) const LOOSEST: f64 = 1e-3;

/// Loosest relative tolerance of the steps of `auto` where errors add up: over thousands of periods,
/// steps at 1e-3 end anywhere.
pub(crate) const LOOSEST_KEPT: f64 = 1e-5;

/// Tolerances of the steps of a run, made once from those requested. Everything that compares an
/// error uses these: error control, events, relations, projection and notes.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct StepTolerance {
    /// Relative tolerance.
    pub rtol: f64,
    /// Absolute tolerance of every state.
    pub atol: Vec<f64>,
    /// Why these are tighter than requested, if they are.
    pub reason: Option<String>,
}

impl StepTolerance {
    /// Returns the tolerances as requested.
    #[must_use]
    pub fn requested(rtol: f64, atol: Vec<f64>) -> Self {
        Self { rtol, atol, reason: None }
    }

    /// Returns the tolerances for the steps of a method. Absolute tolerances change in proportion to
    /// the relative one.
    #[must_use]
    pub fn new(
        method: Method,
        (simulator, parameters): (&dyn Simulator<f64>, &[f64]),
        (rtol, mut atol): (f64, Vec<f64>),
    ) -> Self {
        if method != Method::Auto || rtol <= LOOSEST_KEPT {
            return Self::requested(rtol, atol);
        }
        let kept = keeps_errors(simulator, parameters);
        let (of_steps, why) = match kept {
            Some(why) => (LOOSEST_KEPT, why),
            None => (rtol.min(LOOSEST), "looser steps show nothing of a motion"),
        };
        if of_steps >= rtol {
            return Self::requested(rtol, atol);
        }
        for atol in &mut atol {
            *atol *= of_steps / rtol;
        }
        let reason = format!(
            "steps keep to a relative tolerance of {of_steps:e} instead of {rtol:e}: {why}"
        );
        Self { rtol: of_steps, atol, reason: Some(reason) }
    }
}

/// Returns why errors of single steps say little about those of the run, if they do. A machine that
/// conserves energy forgets nothing, and its pace errs with its energy: errors of its motion grow
/// with the square of its steps. A machine that switches does so at another time, or not at all.
fn keeps_errors(simulator: &dyn Simulator<f64>, parameters: &[f64]) -> Option<&'static str> {
    let bends = || simulator.taylor().map(TaylorSeries::bends) == Some(Bends::Corners);
    if simulator.constraints() > 0 {
        Some("errors add up in a machine with constraints")
    } else if simulator.events() > 0 || simulator.kinks() > 0 || bends() {
        Some("a machine that switches may do so at another time, or not at all")
    } else {
        let conserves = simulator.conserves_energy(parameters).unwrap_or(true);
        conserves.then_some("errors add up in a machine that conserves energy")
    }
}

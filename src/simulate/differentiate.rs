//! Sensitivities by all parameters and initial values that allow them.

use super::Simulation;
use crate::error::SimulateError;
use crate::trajectory::Trajectory;

/// A run with its sensitivities.
#[derive(Debug, Clone)]
pub struct Differentiated {
    /// The run.
    pub run: Trajectory,
    /// Names of the parameters and states that it has sensitivities by.
    pub by: Vec<String>,
    /// Names of those it has none by, and the reasons.
    pub left_out: Vec<(String, String)>,
}

impl Simulation<'_> {
    /// Runs with sensitivities by those of these parameters and initial values that the run can be
    /// differentiated by.
    ///
    /// # Errors
    /// As for [`Simulation::sensitivities`] and [`Simulation::run`].
    pub fn differentiate(&self, mut by: Vec<String>) -> Result<Differentiated, SimulateError> {
        let mut left_out = Vec::new();
        loop {
            match self.clone().sensitivities(&by)?.run() {
                Err(SimulateError::NotDifferentiable { name, why }) if by.contains(&name) => {
                    by.retain(|other| *other != name);
                    left_out.push((name, why));
                }
                run => return Ok(Differentiated { run: run?, by, left_out }),
            }
        }
    }
}

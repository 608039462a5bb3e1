//! Drift of machines from their constraints over very many steps.

use machinist_scenes::scenes;
use serde::Serialize;

use machinist::error::SimulateError;
use machinist::method::Method;
use machinist::simulate::Simulation;

/// Machines with constraints.
const SCENES: [&str; 2] = ["pendulum_constrained", "four_bar"];
/// End of the pilot run, which determines the time for a number of steps \[s\].
const PILOT: f64 = 20.0;

/// A run of very many steps under constraints.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct LongRun {
    /// The scene.
    pub scene: &'static str,
    /// The method.
    pub method: Method,
    /// End of the run \[s\].
    pub until: f64,
    /// Number of steps taken.
    pub steps: u64,
    /// Largest drift before the projection after a step, relative to the size of the coordinates.
    pub before: f64,
    /// Largest drift after projection.
    pub after: f64,
}

/// Runs about `steps` steps by `auto`; a scene that is absent is left out.
///
/// # Errors
/// [`SimulateError`] of a run that stopped.
pub fn constraint_drift(rtol: f64, steps: usize) -> Result<Vec<LongRun>, SimulateError> {
    SCENES.iter().filter_map(|scene| long_run(scene, rtol, steps).transpose()).collect()
}

fn long_run(
    scene: &'static str,
    rtol: f64,
    steps: usize,
) -> Result<Option<LongRun>, SimulateError> {
    let Some(simulator) = scenes::find_f64(scene) else { return Ok(None) };
    let method = Method::Auto;
    let run = |until: f64| {
        let run = Simulation::new(simulator).method(method).rtol(rtol).points(2).until(until);
        run.max_steps(usize::MAX).run()
    };
    let pilot = run(PILOT)?;
    // The margin allows for a motion without period, which changes along the run.
    let until = (1.05 * PILOT * steps as f64 / pilot.work.steps.max(1) as f64).max(PILOT);
    let long = run(until)?;
    let drift = long.drift.unwrap_or_default();
    let (before, after) = (drift.before, drift.after);
    Ok(Some(LongRun { scene, method, until, steps: long.work.steps, before, after }))
}

//! Scenes with fields, cut into elements for the page.

use machinist::field::{Discretisation, FieldError, FieldSimulator};
use machinist::linear_analysis::LinearError;
use machinist::trajectory::Trajectory;
use machinist::{SimulateError, Simulation};
use machinist_scenes::field::FieldScene;

use super::modes::{self, Modes};
use crate::cli::Failure;

/// Modes are those of so many elements of this order, which a table has room for.
const FEW: Discretisation = Discretisation { elements: Some(8), order: Some(4) };

/// A scene's run and its modes.
type Results = (Result<Trajectory, SimulateError>, Option<Result<Modes, LinearError>>);

/// Runs a scene as its spec cuts it; its modes are those of a coarser cut.
pub fn run(scene: &dyn FieldScene<f64>) -> Result<Results, Failure> {
    let refused = |error: FieldError| Failure::input(error, "");
    let simulator = FieldSimulator::new(scene, Discretisation::default()).map_err(refused)?;
    let trajectory = Simulation::new(&simulator).with_energy_balance(true).run();
    let coarse = FieldSimulator::new(scene, FEW).map_err(refused)?;
    Ok((trajectory, modes::modes(&coarse)))
}

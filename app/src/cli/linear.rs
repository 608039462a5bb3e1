//! Options shared by `modes`, `campbell`, `response` and `linearize`: a scene, its parameters, and the operating
//! point.

use clap::Args;
use machinist::Simulation;
use machinist::linear_analysis::{LinearError, Linearization, Place, operating_point};

use machinist_contract::Simulator;

use super::amount::{Amount, assignment};
use super::scene::Scene;
use super::settings::with_parameters;
use crate::failure::Failure;
use crate::progress::during;

#[derive(Debug, Args)]
pub struct Where {
    /// Name of a built-in scene, or a scene file
    scene: String,
    /// Keep everything, even what no output needs
    #[arg(long)]
    keep_all: bool,
    /// Set a parameter: in its SI unit, or with a unit, `18 [kN m/rad]`
    #[arg(long, value_name = "UNIT.PARAMETER=VALUE", value_parser = assignment)]
    set: Vec<(String, Amount)>,
    /// Operating point: equilibrium (the one near the end of the scene's run, at rest or at
    /// constant speed), initial, or t=SECONDS
    #[arg(long, value_name = "PLACE", default_value = "equilibrium")]
    at: Place,
}

impl Where {
    /// Loads the scene.
    pub fn load(&self) -> Result<Scene, Failure> {
        Scene::load(&self.scene, self.keep_all)
    }

    /// Name or file of the scene.
    pub fn scene(&self) -> &str {
        &self.scene
    }

    /// Place of the linearization.
    pub fn place(&self) -> Place {
        self.at
    }

    /// Prepares a run with the parameters asked for.
    pub fn run<'s>(&self, scene: &'s Scene) -> Result<Simulation<'s>, Failure> {
        with_parameters(Simulation::new(scene.simulator()), &self.set)
    }

    /// Linearizes the scene at the place asked for.
    pub fn linearize<'s>(&self, scene: &'s Scene) -> Result<Linearization<'s>, Failure> {
        let run = self.run(scene)?;
        let point = during("simulating", || operating_point(&run, self.at))?;
        Ok(Linearization::at(scene.simulator(), point)?)
    }

    /// Analyses the scene at the place asked for. If forces on coordinates among the inputs have
    /// direct feedthrough to outputs, or if massless coordinates have no inertia to divide by, the
    /// scene is derived again with a parameter for each of these forces.
    pub fn analyse<T>(
        &self,
        inputs: &[&str],
        analyse: impl Fn(&Scene, &Linearization<'_>) -> Result<T, Failure>,
        tried: impl Fn(&Linearization<'_>) -> Result<(), LinearError>,
    ) -> Result<T, Failure> {
        let scene = self.load()?;
        let linearization = self.linearize(&scene)?;
        let failed = match tried(&linearization) {
            Ok(()) => return analyse(&scene, &linearization),
            Err(error) => error,
        };
        let asks_for_forces =
            matches!(failed, LinearError::AnswersAtOnce { .. } | LinearError::Singular { .. });
        let forces = coordinates_among(scene.simulator(), inputs);
        if !asks_for_forces || forces.is_empty() {
            return Err(failed.into());
        }
        let Some(scene) = Scene::load_with_forces(&self.scene, self.keep_all, forces)? else {
            return Err(failed.into());
        };
        let linearization = self.linearize(&scene)?;
        tried(&linearization)?;
        analyse(&scene, &linearization)
    }

    /// Describes the place for people: `equilibrium with time held at 3 s`.
    pub fn described(&self, linearization: &Linearization<'_>) -> String {
        let time = linearization.point().time;
        match self.at {
            Place::Equilibrium => format!("equilibrium with time held at {time} s"),
            Place::Initial => format!("state at the start, {time} s"),
            Place::Time(_) => format!("state of the run at {time} s"),
        }
    }
}

/// Returns the names that are coordinates and not parameters.
fn coordinates_among(simulator: &dyn Simulator<f64>, names: &[&str]) -> Vec<String> {
    let shape = simulator.shape();
    let is_parameter =
        |name: &str| (0..shape.parameters).any(|index| simulator.parameter(index).name == name);
    let is_coordinate =
        |name: &str| (0..shape.coordinates).any(|index| simulator.coordinate(index).name == name);
    let names = names.iter().copied().filter(|name| !is_parameter(name) && is_coordinate(name));
    names.map(str::to_owned).collect()
}

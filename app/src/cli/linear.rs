//! Options shared by `modes`, `campbell` and `response`: a scene, its parameters, and the operating
//! point.

use clap::Args;
use machinist::Simulation;
use machinist::linear_analysis::{Linearization, Place, operating_point};

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

//! Options shared by `modes`, `campbell`, `response` and `linearize`: a scene, its run, and the
//! operating point.

use clap::Args;
use machinist::Simulation;
use machinist::linear_analysis::{LinearError, Linearization, Place, operating_point};

use machinist_contract::Simulator;

use super::amount::time;
use super::arguments::{RunArgs, SceneArgs};
use super::scene::Scene;
use crate::failure::Failure;
use crate::progress::during;

#[derive(Debug, Args)]
pub struct Where {
    /// Operating point: equilibrium (the one near the end of the scene's run, at rest or at
    /// constant speed), initial, or t=TIME
    #[arg(long, value_name = "PLACE", default_value = "equilibrium", value_parser = place)]
    at: Place,
    #[command(flatten)]
    scene: SceneArgs,
    #[command(flatten)]
    run: RunArgs,
}

/// Parses a place; its time may have a unit.
fn place(text: &str) -> Result<Place, String> {
    match text.strip_prefix("t=") {
        Some(at) => time(at).map(Place::Time),
        None => text.parse(),
    }
}

impl Where {
    /// Loads the scene.
    pub fn load(&self) -> Result<Scene, Failure> {
        self.check()?;
        self.scene.load()
    }

    /// Returns an error for options of a run that the operating point does not need.
    fn check(&self) -> Result<(), Failure> {
        let (given, why) = match self.at {
            Place::Initial => (self.run.given_for_motion(), "is the start of the run"),
            Place::Time(_) => (self.run.span.until.map(|_| "--until"), "is the end of the run"),
            Place::Equilibrium => (None, ""),
        };
        given.map_or(Ok(()), |option| {
            let message = format!("{option} has no effect, because the operating point {why}");
            Err(Failure::input(message, format!("leave `{option}` or `--at` out")))
        })
    }

    /// Name or file of the scene.
    pub fn scene(&self) -> &str {
        &self.scene.scene
    }

    /// Place of the linearization.
    pub fn place(&self) -> Place {
        self.at
    }

    /// Prepares a run with the options asked for.
    pub fn run<'s>(&self, scene: &'s Scene) -> Result<Simulation<'s>, Failure> {
        self.run.apply(self.scene.simulation(scene.simulator())?)
    }

    /// Linearizes the scene at the place asked for.
    pub fn linearize<'s>(&self, scene: &'s Scene) -> Result<Linearization<'s>, Failure> {
        self.linearize_at(scene, self.at)
    }

    fn linearize_at<'s>(
        &self,
        scene: &'s Scene,
        place: Place,
    ) -> Result<Linearization<'s>, Failure> {
        let run = self.run(scene)?;
        let point = during("simulating", || operating_point(&run, place))?;
        Ok(Linearization::at(scene.simulator(), point)?)
    }

    /// Analyses the scene at the place asked for. If forces on coordinates among the inputs have
    /// direct feedthrough to outputs, or if massless coordinates have no inertia to divide by, the
    /// scene is derived again with a parameter for each of these forces. Inputs of units become
    /// parameters; both functions get the names of these in place of the inputs.
    pub fn analyse<T>(
        &self,
        inputs: &[&str],
        analyse: impl Fn(&Scene, &Linearization<'_>, &[String]) -> Result<T, Failure>,
        tried: impl Fn(&Linearization<'_>, &[String]) -> Result<(), LinearError>,
    ) -> Result<T, Failure> {
        self.analyse_at(self.at, inputs, analyse, tried)
    }

    /// As [`Where::analyse`], at a place of the command's own.
    pub fn analyse_at<T>(
        &self,
        place: Place,
        inputs: &[&str],
        analyse: impl Fn(&Scene, &Linearization<'_>, &[String]) -> Result<T, Failure>,
        tried: impl Fn(&Linearization<'_>, &[String]) -> Result<(), LinearError>,
    ) -> Result<T, Failure> {
        let (scene, names) = self.load_with_inputs(inputs)?;
        let linearization = self.linearize_at(&scene, place)?;
        let failed = match tried(&linearization, &names) {
            Ok(()) => return analyse(&scene, &linearization, &names),
            Err(error) => error,
        };
        let asks_for_forces =
            matches!(failed, LinearError::DirectFeedthrough { .. } | LinearError::Singular { .. });
        let forces = coordinates_among(scene.simulator(), inputs);
        if !asks_for_forces || forces.is_empty() {
            return Err(failed.into());
        }
        let loading = self.scene.machine.loading();
        let Some(scene) = Scene::load_with_forces(self.scene(), &loading, forces)? else {
            return Err(failed.into());
        };
        let linearization = self.linearize_at(&scene, place)?;
        tried(&linearization, &names)?;
        analyse(&scene, &linearization, &names)
    }

    /// Loads the scene, with parameters in place of those names that are inputs of units. Returns
    /// the names of the parameters, too.
    fn load_with_inputs(&self, names: &[&str]) -> Result<(Scene, Vec<String>), Failure> {
        let scene = self.load()?;
        let simulator = scene.simulator();
        let shape = simulator.shape();
        let is_known = |name: &&str| {
            (0..shape.parameters).any(|index| simulator.parameter(index).name == *name)
                || (0..shape.coordinates).any(|index| simulator.coordinate(index).name == *name)
        };
        if names.iter().all(is_known) {
            return Ok((scene, names.iter().map(|name| (*name).to_owned()).collect()));
        }
        let loading = self.scene.machine.loading();
        Ok(match Scene::load_opened(self.scene(), &loading, names)? {
            Some(opened) => opened,
            None => (scene, names.iter().map(|name| (*name).to_owned()).collect()),
        })
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

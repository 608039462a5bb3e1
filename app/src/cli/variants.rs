//! Runs of many variants of a scene, on threads and in lanes.

use std::sync::atomic::AtomicBool;

use machinist::sweep::{InLanes, Sweepable, VariantRun, each_on_its_own, one};
use machinist::{FieldSimulator, SimulateError, Simulation, Sweep};
use machinist_contract::Simulator;
use machinist_model::ModelSimulator;

use super::arguments::{RunArgs, SceneArgs};
use super::scene::{Scene, built_in, refused};
use crate::config;
use crate::failure::Failure;

/// Settings of all variants, which threads share. The options were accepted before.
#[derive(Clone, Copy)]
pub struct Variants<'a> {
    pub scene: &'a SceneArgs,
    pub run: &'a RunArgs,
    /// Number of output times, unless that of the scene.
    pub points: Option<usize>,
    /// Number of threads, unless that of the configuration.
    pub threads: Option<usize>,
    /// Flag that interrupts all runs.
    pub flag: Option<&'a AtomicBool>,
}

impl<'a> Variants<'a> {
    /// Applies the settings to a run.
    pub fn adjust<'s>(&self, simulation: Simulation<'s>) -> Simulation<'s>
    where
        'a: 's,
    {
        let simulation = self.points.into_iter().fold(simulation, Simulation::points);
        let adjusted = self.scene.machine.with_initial(simulation);
        let adjusted = adjusted.and_then(|run| self.run.apply(run));
        let adjusted = adjusted.expect("the options were accepted before");
        self.flag.into_iter().fold(adjusted, Simulation::until_flagged)
    }

    /// Runs variants of the loaded scene, each a full list of parameters, in lanes where machine
    /// and method support them.
    pub fn runs(
        &self,
        scene: &Scene,
        variants: &[Vec<f64>],
    ) -> Result<Vec<Result<VariantRun, SimulateError>>, Failure> {
        self.runs_each(scene, variants, |_, run| run)
    }

    /// Like [`Variants::runs`], with what `take` makes of the simulation and the results of each
    /// variant. Only the results of a few variants are in memory at a time, unless there are fields.
    pub fn runs_each<T: Send>(
        &self,
        scene: &Scene,
        variants: &[Vec<f64>],
        take: impl Fn(&Simulation<'_>, Result<VariantRun, SimulateError>) -> T + Sync,
    ) -> Result<Vec<T>, Failure> {
        self.runs_of(scene, variants, |run| run, take)
    }

    /// Like [`Variants::runs_each`], with settings that depend on the parameters of a variant.
    pub fn runs_of<T: Send>(
        &self,
        scene: &Scene,
        variants: &[Vec<f64>],
        of_variant: impl for<'s> Fn(Simulation<'s>) -> Simulation<'s> + Sync,
        take: impl Fn(&Simulation<'_>, Result<VariantRun, SimulateError>) -> T + Sync,
    ) -> Result<Vec<T>, Failure> {
        let threads = self.threads.or_else(config::threads).unwrap_or_default();
        let machine: &dyn Sweepable = match scene {
            Scene::Emitted(_) => &BuiltIn { name: self.scene.scene.clone() },
            Scene::Model(simulator) => &OfModel(simulator),
            Scene::Fields(cut) => {
                let run = |simulator: &FieldSimulator<'_, f64>, parameters: &[f64]| {
                    let run = Simulation::new(simulator.single()).parameters(parameters);
                    one(&of_variant(self.adjust(run)))
                };
                let runs = each_on_its_own(variants, threads, cut.again(), run);
                let runs = runs.map_err(|error| refused(&error))?.into_iter().zip(variants);
                let base = Simulation::new(scene.simulator());
                let taken = runs.map(|(run, parameters)| {
                    take(&of_variant(self.adjust(base.clone().parameters(parameters))), run)
                });
                return Ok(taken.collect());
            }
        };
        let sweep = Sweep::new(machine)
            .each(|run| self.adjust(run))
            .of_variant(of_variant)
            .variants(variants.to_vec())
            .threads(threads);
        Ok(sweep.run_each(take))
    }
}

/// Model that threads share.
struct OfModel<'a>(&'a ModelSimulator);

impl Sweepable for OfModel<'_> {
    fn single(&self) -> &dyn Simulator<f64> {
        self.0.single()
    }
    fn in_lanes(&self) -> Option<InLanes<'_>> {
        Some(InLanes::Two(self.0.in_pairs()))
    }
}

/// Built-in scene by its known name, which threads share.
struct BuiltIn {
    name: String,
}

impl Sweepable for BuiltIn {
    fn single(&self) -> &dyn Simulator<f64> {
        built_in(&self.name).expect("it was found by this name before")
    }
    fn in_lanes(&self) -> Option<InLanes<'_>> {
        machinist_lanes::find(&self.name).map(InLanes::Eight)
    }
}

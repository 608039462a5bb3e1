//! Collection of the data that the page of a machine shows.

use std::cell::LazyCell;
use std::time::Duration;

use machinist::trajectory::Trajectory;
use machinist::{SimulateError, Simulation};
use machinist_codegen::emit::document::Document;
use machinist_codegen::mechanics::dependencies::Dependencies;
use machinist_codegen::pipeline::{Derivation, Outline, Stages};
use machinist_codegen::spec::SceneSpec;
use machinist_contract::Simulator;
use machinist_contract::field::FieldScene;
use machinist_model::{Model, ModelSimulator, Running};
use machinist_scenes::scenes;
use machinist_studies::verify::{Tally, Verdict};
use machinist_studies::work_precision::WorkPrecision;

use super::fields;
use super::gather::Extent;
use super::key::{self, Figure};
use super::live::{Moving, by_run};
use super::modes::{self, Modes, NoModes};
use super::schematic::Schematic;
use crate::explain::Explanation;
use crate::failure::Failure;
use crate::spec_source::SpecSource;

/// Scene after derivation, run and checks.
pub(super) struct Machine {
    /// Argument by which commands find the scene.
    pub(super) argument: String,
    /// Model reduced to what the outputs need.
    pub(super) model: Model,
    /// Description of the scene, without its units.
    pub(super) doc: String,
    pub(super) schematic: Schematic,
    pub(super) moving: Moving,
    pub(super) document: Document,
    /// Reduction of the scene, once known.
    pub(super) explanation: Option<Explanation>,
    pub(super) dependencies: Dependencies,
    pub(super) by: By,
    pub(super) run: Result<Trajectory, SimulateError>,
    /// Modes at the end of the run, once computed.
    pub(super) modes: Option<Result<Modes, NoModes>>,
    /// Fields over time, if there are any.
    pub(super) along: Vec<fields::Along>,
    /// Parameters in the order of their effect on the run, once computed.
    pub(super) order: Option<Vec<usize>>,
    pub(super) verdicts: Vec<Verdict>,
    pub(super) work_precision: Option<WorkPrecision>,
}

/// Simulator by which a scene was run.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum By {
    Emitted,
    Compiled,
    Interpreted,
}

/// Choice of the simulator of a scene.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Ways {
    /// Emitted code if it is built in, else as [`Ways::Compiled`].
    BuiltIn,
    /// Machine code of the model from the first call on.
    Compiled,
    /// The model's tapes, and machine code once that pays.
    Soonest,
}

impl Machine {
    /// Runs and explains the model of a scene file. Checks are not included.
    pub(super) fn new(
        derived: Derivation,
        source: &SpecSource,
        ways: Ways,
        extent: Extent,
    ) -> Result<Self, Failure> {
        let Derivation { stages, latex, dependencies, .. } = derived;
        let outline = Outline { model: stages.needed().clone(), latex, dependencies };
        let mut machine = Self::ran(outline, source, &source.read()?, ways, extent.time_limit)?;
        // A machine that does not run is not timed.
        if machine.model.fields.is_empty() {
            machine.order = machine.trajectory().map(|run| by_run(&machine.model, run));
        }
        machine.explain(source, stages, extent.with_times && machine.run.is_ok())?;
        Ok(machine)
    }

    /// Explains the reduction, with times of runs if wanted.
    pub(super) fn explain(
        &mut self,
        source: &SpecSource,
        stages: Stages,
        with_times: bool,
    ) -> Result<(), Failure> {
        self.explanation = Some(Explanation::new(Some(source), stages, with_times)?);
        Ok(())
    }

    /// Computes the modes unless they are known.
    pub(super) fn find_modes(&mut self, time_limit: Duration) {
        if self.modes.is_none() {
            let simulator = ModelSimulator::new(self.model.clone());
            let run = Simulation::new(simulator.single()).time_limit(time_limit);
            self.modes = Some(modes::modes(&run));
        }
    }

    /// Runs the model of a spec and does nothing else.
    pub(super) fn ran(
        outline: Outline,
        source: &SpecSource,
        spec: &SceneSpec,
        ways: Ways,
        time_limit: Duration,
    ) -> Result<Self, Failure> {
        let Outline { model, latex: document, dependencies } = outline;
        let name = model.name.as_str();
        // Machine code is made only if nothing is built in.
        let own = LazyCell::new(|| match ways {
            Ways::Soonest => ModelSimulator::new(model.clone()),
            Ways::BuiltIn | Ways::Compiled => ModelSimulator::compiled_at_once(model.clone()),
        });
        let may_be_built_in = ways == Ways::BuiltIn;
        let by = |is_built_in| match is_built_in {
            true => By::Emitted,
            false if own.running() == Running::Interpreted => By::Interpreted,
            false => By::Compiled,
        };
        let mut along = Vec::new();
        let (run, modes, by) = if model.fields.is_empty() {
            let built_in = scenes::find_f64(name).filter(|_| may_be_built_in);
            let simulator: &dyn Simulator<f64> = built_in.unwrap_or_else(|| &*own);
            let limited = Simulation::new(simulator).time_limit(time_limit);
            // Modes can wait until after the run.
            let modes = (ways != Ways::Soonest).then(|| modes::modes(&limited));
            (limited.with_energy_balance(true).run(), modes, by(built_in.is_some()))
        } else {
            let built_in = scenes::find_field_f64(name).filter(|_| may_be_built_in);
            let scene: &dyn FieldScene<f64> = built_in.unwrap_or_else(|| &*own);
            let run = fields::run(scene, time_limit)?;
            along = run.along;
            (run.trajectory, Some(run.modes), by(built_in.is_some()))
        };
        let is_built_in = by == By::Emitted;
        let argument = if is_built_in { name.to_owned() } else { source.to_string() };
        Ok(Self {
            argument,
            schematic: Schematic::of(spec),
            moving: Moving::of(spec, &model),
            doc: spec.doc.clone(),
            document,
            explanation: None,
            dependencies,
            by,
            run,
            modes,
            along,
            model,
            order: None,
            verdicts: Vec::new(),
            work_precision: None,
        })
    }

    pub(super) fn name(&self) -> &str {
        &self.model.name
    }

    pub(super) fn title(&self) -> &str {
        &self.model.title
    }

    /// Returns the run, up to where it stopped if it did.
    pub(super) fn trajectory(&self) -> Option<&Trajectory> {
        match &self.run {
            Ok(trajectory) => Some(trajectory),
            Err(SimulateError::Stopped { kept, .. }) => kept.as_deref(),
            Err(_) => None,
        }
    }

    /// Returns the key figures.
    pub(super) fn figures(&self) -> Vec<Figure> {
        let modes = self.modes.as_ref().and_then(|modes| modes.as_ref().ok());
        self.trajectory().map(|run| key::figures(run, modes)).unwrap_or_default()
    }

    /// Returns the tally of the checks.
    pub(super) fn tally(&self) -> Tally {
        Tally::of(&self.verdicts)
    }
}

//! What the page shows, gathered.

use std::path::Path;

use machinist::linear_analysis::LinearError;
use machinist::trajectory::Trajectory;
use machinist::{SimulateError, Simulation};
use machinist_codegen::emit::document::Document;
use machinist_codegen::mechanics::dependencies::Dependencies;
use machinist_codegen::mechanics::reduce::Keep;
use machinist_codegen::pipeline::Derivation;
use machinist_codegen::write::{Mode, Summary, Written, emit_scenes};
use machinist_contract::Simulator;
use machinist_model::Model;
use machinist_model::ModelSimulator;
use machinist_scenes::scenes;
use machinist_studies::double_double::precise;
use machinist_studies::ledger::{LedgerRow, ledger as ledger_rows};
use machinist_studies::stability::{Plan as Strain, Study, study};
use machinist_studies::verify::{Verdict, VerifyOptions, verify_all};
use machinist_studies::work_precision::{self, Plan, WorkPrecision};

use super::modes::Modes;
use super::page::render;
use super::{fields, modes, winder_walk};
use crate::cli::specs;
use crate::deriving;
use crate::explain::Explanation;
use crate::failure::Failure;
use crate::freeze::admit;
use crate::progress::during;
use crate::spec_source::SpecSource;

/// Everything the page shows.
pub(super) struct Report {
    pub(super) scenes: Vec<SceneData>,
    pub(super) emitted: Summary,
    pub(super) verdicts: Vec<Verdict>,
    pub(super) ledger: Result<Vec<LedgerRow>, String>,
    pub(super) winder: Result<winder_walk::Study, String>,
    /// Where a scene has fields.
    pub(super) fields: Option<fields::Study>,
    pub(super) work_precision: Vec<WorkPrecision>,
    /// Takes about a minute, and so is left out with the times.
    pub(super) stability: Option<Study>,
}

/// One scene, derived and run.
pub(super) struct SceneData {
    /// What the outputs need.
    pub(super) model: Model,
    pub(super) document: Document,
    pub(super) explanation: Explanation,
    pub(super) dependencies: Dependencies,
    /// Whether the run is by emitted code; a scene that is new is evaluated.
    pub(super) is_built_in: bool,
    pub(super) run: Result<Trajectory, SimulateError>,
    pub(super) modes: Option<Result<Modes, LinearError>>,
    /// Its fields over time, if it has any.
    pub(super) along: Vec<fields::Along>,
}

/// The page, made.
pub struct Page {
    /// The whole of it.
    pub html: String,
    /// Whether every check passed.
    pub all_passed: bool,
}

/// Makes the page, with measured times or without. Brings emitted scenes up to
/// date on the way.
pub fn page(specs: &Path, emitted: &Path, with_times: bool) -> Result<Page, Failure> {
    let files = specs::scene_files(specs)?;
    let derived = deriving::derivations(&files, Keep::Needed)?;
    for (file, derived) in files.iter().zip(&derived) {
        admit(file, derived.stages.needed())?;
    }
    let models: Vec<_> = derived.iter().map(|derived| derived.stages.needed().clone()).collect();
    let emitted = emit_scenes(emitted, &models, Mode::Write)?;
    let names = models.iter().map(|model| model.name.clone()).collect();
    let has_fields = models.iter().any(|model| !model.fields.is_empty());
    let options = VerifyOptions { scenes: Some(names), ..VerifyOptions::default() };
    let verdicts = during("verifying", || verify_all(&options))
        .map_err(|error| Failure::unsuccessful(error, ""))?;
    let mut scenes: Vec<SceneData> = during("simulating", || {
        let scenes = derived.into_iter().zip(&files);
        scenes
            .map(|(derived, file)| SceneData::new(derived, file, with_times))
            .collect::<Result<_, Failure>>()
    })?;
    // As in the table of checks, which goes from the simple to the whole.
    scenes.sort_by_key(|scene| {
        verdicts.iter().position(|row| row.scene == scene.name()).unwrap_or(usize::MAX)
    });
    let ledger = during("filling the ledger", || ledger_rows().map_err(|e| e.to_string()));
    let winder = during("walking winders", || winder_walk::Study::new(with_times));
    let fields = has_fields.then(|| during("cutting fields", fields::Study::new));
    let work_precision =
        if with_times { during("timing the methods", measure_all)? } else { Vec::new() };
    let strain = || {
        during("straining the methods", || {
            study(&Strain { drift_steps: 100_000, ..Strain::default() })
        })
    };
    let stability = with_times.then(strain).transpose()?;
    let all_passed = verdicts.iter().all(|verdict| verdict.pass);
    let report =
        Report { scenes, emitted, verdicts, ledger, winder, fields, work_precision, stability };
    Ok(Page { html: render(&report), all_passed })
}

/// Error against time of the scenes that are built in; those that only exist to be
/// measured are left to `machinist bench`.
fn measure_all() -> Result<Vec<WorkPrecision>, SimulateError> {
    let found = scenes::NAMES.iter().filter_map(|name| scenes::find_f64(name));
    // Some two thousand points, each as long as it takes to tell its median.
    let plan = Plan { enough: 20.0, ..Plan::default() };
    let measure = |simulator: &dyn Simulator<f64>| {
        work_precision::measure(simulator, precise(simulator.name()), &plan)
    };
    found.map(measure).collect()
}

impl Report {
    /// Emitted files that were not what the specs give.
    pub(super) fn stale(&self) -> impl Iterator<Item = &str> {
        let files = self.emitted.files.iter();
        files.filter(|(_, written)| *written != Written::Unchanged).map(|(file, _)| file.as_str())
    }
}

impl SceneData {
    fn new(derived: Derivation, file: &SpecSource, with_times: bool) -> Result<Self, Failure> {
        let Derivation { stages, latex: document, dependencies, .. } = derived;
        let model = stages.needed().clone();
        let name = &model.name;
        let built_in = scenes::find_f64(name);
        let run = |simulator: &dyn Simulator<f64>| {
            Simulation::new(simulator).with_energy_balance(true).run()
        };
        let both = |simulator: &dyn Simulator<f64>| (run(simulator), modes::modes(simulator));
        let mut along = Vec::new();
        let has_fields = !model.fields.is_empty();
        let (trajectory, modes) = match built_in {
            Some(simulator) => both(simulator),
            None if has_fields => {
                let interpreted = ModelSimulator::new(model.clone());
                let scene = scenes::find_field::<f64>(name).unwrap_or(&interpreted);
                let run = fields::run(scene)?;
                along = run.along;
                (run.trajectory, run.modes)
            }
            None => both(&ModelSimulator::new(model.clone())),
        };
        let is_built_in = built_in.is_some() || scenes::find_field::<f64>(name).is_some();
        Ok(Self {
            document,
            explanation: Explanation::new(Some(file), stages, with_times)?,
            dependencies,
            is_built_in,
            run: trajectory,
            modes,
            along,
            model,
        })
    }

    pub(super) fn name(&self) -> &str {
        &self.model.name
    }

    pub(super) fn title(&self) -> &str {
        &self.model.title
    }
}

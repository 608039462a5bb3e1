//! Collection of the data that the pages show, and rendering of the pages.

use std::path::{Path, PathBuf};
use std::time::Duration;

use machinist::Simulation;
use machinist_codegen::mechanics::reduce::Keep;
use machinist_codegen::write::{Mode, Summary, Written, emit_scenes};
use machinist_contract::Simulator;
use machinist_model::ModelSimulator;
use machinist_scenes::scenes;
use machinist_studies::double_double::{Twin, precise};
use machinist_studies::ledger::{LedgerRow, ledger as ledger_rows};
use machinist_studies::stability::{Plan as Strain, Study, study};
use machinist_studies::verify::{Tally, Verdict, VerifyOptions, verify_all};
use machinist_studies::work_precision::{self, Plan, WorkPrecision};
use maud::{Markup, html};

use super::machine::{Machine, Ways};
use super::{conclusions, fields, index, scene, studies, winder_walk};
use crate::cli::scene::SceneSource;
use crate::cli::specs;
use crate::cli::verify::{Changes, verify_spec};
use crate::deriving::{self, Purpose};
use crate::failure::Failure;
use crate::freeze::admit;
use crate::progress::during;
use crate::spec_source::SpecSource;

/// Returns the path of a machine's page within the report's folder.
pub(super) fn page_of(name: &str) -> String {
    format!("machines/{name}.html")
}

/// Rendered pages.
pub struct Pages {
    /// Pages by their paths within the report's folder.
    pub files: Vec<(PathBuf, String)>,
    /// True if every check passed.
    pub all_passed: bool,
}

/// Data of the report on all scenes.
pub(super) struct Report {
    pub(super) machines: Vec<Machine>,
    /// Summary of the emitted code; `None` if an algebra was named.
    pub(super) emitted: Option<Summary>,
    /// All checks; those of a machine are also with the machine.
    pub(super) verdicts: Vec<Verdict>,
    pub(super) ledger: Result<Vec<LedgerRow>, String>,
    pub(super) conclusions: Result<conclusions::Study, String>,
    pub(super) winder: Result<winder_walk::Study, String>,
    /// Study of fields, if a scene has any.
    pub(super) fields: Option<fields::Study>,
    /// Study of extreme cases. It takes about a minute and is left out together with the times.
    pub(super) stability: Option<Study>,
}

/// Extent of the pages.
#[derive(Debug, Clone, Copy)]
pub struct Extent {
    /// True if error against run time is measured.
    pub with_times: bool,
    /// Time limit of each run.
    pub time_limit: Duration,
}

/// Makes the page of a machine of the user's own.
pub fn own(argument: &str, extent: Extent) -> Result<Pages, Failure> {
    let spec = match SceneSource::of(argument)? {
        SceneSource::Spec(spec) => spec,
        SceneSource::Model(_) => {
            let message = format!("{argument} is a model, which has no equations to show");
            return Err(Failure::input(message, "give the spec it was compiled of"));
        }
    };
    let machine = of_spec(&spec, Purpose::Running, extent)?;
    let all_passed = Tally::of(&machine.verdicts).is_clean();
    Ok(Pages { files: vec![file_of(&machine, false)], all_passed })
}

/// Runs the machine of a spec by its model and applies the checks that exist for any machine.
fn of_spec(spec: &SpecSource, purpose: Purpose, extent: Extent) -> Result<Machine, Failure> {
    let derived = deriving::derivation(spec, Keep::Needed, purpose)?;
    admit(spec, derived.stages.needed())?;
    let mut machine = during("simulating", || Machine::new(derived, spec, Ways::Compiled, extent))?;
    let time_limit = extent.time_limit;
    let changes = Changes::none(time_limit);
    machine.verdicts = verify_spec(spec, &machine.model, &changes)?;
    // A machine whose own run stops is not timed.
    if extent.with_times && machine.model.fields.is_empty() && machine.run.is_ok() {
        let simulator = ModelSimulator::new(machine.model.clone());
        let measured = during("timing the methods", || measure(&simulator, None, time_limit));
        machine.work_precision = measured.ok();
    }
    Ok(machine)
}

/// Renders the page of a machine and returns it with its path.
fn file_of(machine: &Machine, has_index: bool) -> (PathBuf, String) {
    (page_of(machine.name()).into(), scene::page(machine, has_index))
}

/// Makes the pages of all scenes. Updates emitted scenes along the way, unless an algebra was
/// named.
pub fn whole(specs: &Path, emitted: &Path, extent: Extent) -> Result<Pages, Failure> {
    let with_times = extent.with_times;
    let files = specs::scene_files(specs)?;
    let derived = deriving::derivations(&files, Keep::Needed, Purpose::Reading)?;
    for (file, derived) in files.iter().zip(&derived) {
        admit(file, derived.stages.needed())?;
    }
    let models: Vec<_> = derived.iter().map(|derived| derived.stages.needed().clone()).collect();
    // Algebras arrange equations differently, and emitted code must not depend on the options of a
    // report.
    let emitted = (!deriving::is_algebra_named())
        .then(|| emit_scenes(emitted, &models, Mode::Write))
        .transpose()?;
    let names = models.iter().map(|model| model.name.clone()).collect();
    let has_fields = models.iter().any(|model| !model.fields.is_empty());
    let options = VerifyOptions { scenes: Some(names), ..VerifyOptions::default() };
    let verdicts = during("verifying", || verify_all(&options))
        .map_err(|error| Failure::unsuccessful(error, ""))?;
    let mut machines: Vec<Machine> = during("simulating", || {
        let scenes = derived.into_iter().zip(&files);
        scenes
            .map(|(derived, file)| Machine::new(derived, file, Ways::BuiltIn, extent))
            .collect::<Result<_, Failure>>()
    })?;
    for machine in &mut machines {
        let of_machine = |verdict: &&Verdict| verdict.scene == machine.model.name;
        machine.verdicts = verdicts.iter().filter(of_machine).cloned().collect();
    }
    // The order is that of the table of checks, from simple to complete machines.
    machines.sort_by_key(|machine| {
        verdicts.iter().position(|row| row.scene == machine.name()).unwrap_or(usize::MAX)
    });
    if with_times {
        during("timing the methods", || measure_built_in(&mut machines, extent.time_limit))?;
    }
    let ledger = during("filling the ledger", || ledger_rows().map_err(|e| e.to_string()));
    let conclusions = during("drawing conclusions", conclusions::Study::new);
    let winder = during("walking winders", || winder_walk::Study::new(with_times));
    let fields = has_fields.then(|| during("cutting fields", fields::Study::new));
    let strain = || {
        during("straining the methods", || {
            study(&Strain { drift_steps: 100_000, ..Strain::default() })
        })
    };
    let stability = with_times.then(strain).transpose()?;
    let drives = specs::scene_files_below(specs, specs::DRIVES)?;
    let drives = drives.iter().map(|file| of_spec(file, Purpose::Reading, extent));
    let drives = drives.collect::<Result<Vec<_>, Failure>>()?;
    let mut verdicts = verdicts;
    verdicts.extend(drives.iter().flat_map(|drive| drive.verdicts.iter().cloned()));
    machines.extend(drives);
    let all_passed = Tally::of(&verdicts).is_clean();
    let report =
        Report { machines, emitted, verdicts, ledger, conclusions, winder, fields, stability };
    let mut pages = vec![
        (PathBuf::from("index.html"), index::page(&report)),
        (PathBuf::from("studies.html"), studies::page(&report)),
    ];
    pages.extend(report.machines.iter().map(|machine| file_of(machine, true)));
    Ok(Pages { files: pages, all_passed })
}

/// Measures the error against run time of built-in scenes.
fn measure_built_in(machines: &mut [Machine], time_limit: Duration) -> Result<(), Failure> {
    for machine in machines {
        if let Some(simulator) = scenes::find_f64(machine.name()) {
            let twin = precise(simulator.name());
            machine.work_precision = Some(measure(simulator, twin, time_limit)?);
        }
    }
    Ok(())
}

fn measure(
    simulator: &dyn Simulator<f64>,
    twin: Option<&'static dyn Twin>,
    time_limit: Duration,
) -> Result<WorkPrecision, machinist::SimulateError> {
    // A machine has some hundred points, each measured long enough for its median.
    let time_limit = Some(time_limit);
    let plan = Plan { enough: 10.0, longest: 100.0, time_limit, ..Plan::default() };
    work_precision::measure(&Simulation::new(simulator), twin, &plan)
}

impl Report {
    /// Renders the name of a machine, with a link to its page if there is one.
    pub(super) fn named(&self, name: &str) -> Markup {
        let has_page = self.machines.iter().any(|machine| machine.name() == name);
        html! {
            @if has_page { a href=(page_of(name)) { code { (name) } } } @else { code { (name) } }
        }
    }

    /// Returns the emitted files that differed from what the specs give.
    pub(super) fn stale(&self) -> impl Iterator<Item = &str> {
        let files = self.emitted.iter().flat_map(|emitted| &emitted.files);
        files.filter(|(_, written)| *written != Written::Unchanged).map(|(file, _)| file.as_str())
    }
}

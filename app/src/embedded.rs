//! Interface for the Python package: commands run, and models derived, within a process that is
//! not the program.
//!
//! Nothing here reads the configuration, prints, or ends the process, except [`run`], which does
//! as the program does.

mod scatter;

use std::ffi::OsString;
use std::io::Write as _;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::AtomicBool;

use machinist_algebra::interrupt::{Interrupted, interruptible};
use machinist_codegen::mechanics::reduce::Keep;
use machinist_codegen::spec::library::{LibraryScene, MACHINES};
use machinist_model::Model;
use machinist_model::file::Stamped;

use crate::deriving::{Remark, Request, stamped_with};
use crate::failure::{Failure, Trouble};
use crate::freeze::admit_against;
use crate::program;
use crate::spec_source::SpecSource;

pub use crate::cli::scatter::{LinearShare, Linearized};
pub use scatter::{
    ScatterDesign, ScatterResults, Spread, scatter_design, scatter_linear, scatter_paths,
    scatter_results,
};

/// Runs the command that `arguments` ask for, the first of which is the name of the program, and
/// returns the exit code. `again` starts the same program in another process: an executable and its
/// first arguments. Wrong arguments and requests for help end the process.
#[must_use]
pub fn run((executable, first): (OsString, Vec<OsString>), arguments: &[OsString]) -> u8 {
    program::is_started_by(executable, first);
    let code = crate::cli::run(arguments);
    // A program flushes at its end. The errors of a closed pipe were reported by the command.
    let _ = std::io::stdout().flush();
    code
}

/// Returns the names of the machines of standard parts whose specs come with Machinist.
pub fn machine_names() -> impl Iterator<Item = &'static str> {
    MACHINES.iter().map(|machine| machine.name)
}

/// Model of a spec, with warnings.
#[derive(Debug)]
pub struct Derived {
    /// The model and its generator.
    pub stamped: Stamped,
    /// Warnings of the spec and notes on the derivation.
    pub warnings: Vec<Trouble>,
}

/// Spec to derive.
#[derive(Debug, Clone)]
pub enum Spec {
    /// File.
    File(PathBuf),
    /// Spec that comes with Machinist, by name.
    Named(String),
}

/// Reason why there is no model.
#[derive(Debug)]
pub enum Refused {
    /// No spec that comes with Machinist has this name.
    Unknown,
    /// The spec has errors, or its approximations exceed their tolerance.
    Wrong(Vec<Trouble>),
    /// The flag was set.
    Interrupted,
}

/// Derives the model of a spec by Machinist's own algebra, or takes it from the cache. Ends soon
/// after `is_interrupted` is set.
///
/// # Errors
/// [`Refused`].
pub fn derive(
    spec: &Spec,
    keep_all: bool,
    is_interrupted: Arc<AtomicBool>,
) -> Result<Derived, Refused> {
    let source = match spec {
        Spec::File(path) => SpecSource::File(path.clone()),
        Spec::Named(name) if LibraryScene::find(name).is_some() => {
            SpecSource::BuiltIn(name.clone())
        }
        Spec::Named(_) => return Err(Refused::Unknown),
    };
    let mut remarks = Vec::new();
    let remark = &mut |remark| {
        if !remarks.contains(&remark) {
            remarks.push(remark);
        }
    };
    let done = interruptible(is_interrupted, || stamped(&source, keep_all, remark));
    let located = |troubles: Vec<Trouble>| -> Vec<Trouble> {
        troubles.into_iter().map(|one| with_path(one, spec)).collect()
    };
    match done {
        Ok(Ok(stamped)) => {
            let warnings = remarks.iter().map(Trouble::from).collect();
            Ok(Derived { stamped, warnings: located(warnings) })
        }
        Ok(Err(failure)) => Err(Refused::Wrong(located(failure.troubles()))),
        Err(Interrupted) => Err(Refused::Interrupted),
    }
}

fn stamped(
    source: &SpecSource,
    keep_all: bool,
    remark: &mut dyn FnMut(Remark),
) -> Result<Stamped, Failure> {
    let mut model = |keep| stamped_with(&Request::model(source, keep), remark);
    if keep_all {
        return model(Keep::All);
    }
    let stamped = model(Keep::Needed)?;
    let exact = || -> Result<Model, Failure> { Ok(model(Keep::Exact)?.model) };
    admit_against(&stamped.model, exact)?;
    Ok(stamped)
}

/// Returns the same with the path of its file in place of the label.
fn with_path(trouble: Trouble, spec: &Spec) -> Trouble {
    let Spec::File(scene) = spec else { return trouble };
    let path = path_of(&trouble.file, scene);
    Trouble { file: path.map_or(trouble.file, |path| path.display().to_string()), ..trouble }
}

/// Returns the path of a label, which is relative to the parent of the scene's folder.
fn path_of(label: &str, scene: &Path) -> Option<PathBuf> {
    let folder = scene.parent().filter(|folder| !folder.as_os_str().is_empty());
    let folder = folder.unwrap_or(Path::new(".")).canonicalize().ok()?;
    let path = folder.parent().unwrap_or(&folder).join(label);
    if label.is_empty() || path == folder.join(scene.file_name()?) {
        return Some(scene.to_owned());
    }
    path.is_file().then_some(path)
}

//! Emission of scenes by a crate's own `build.rs`.
//!
//! ```no_run
//! // build.rs
//! fn main() -> Result<(), machinist_codegen::BuildError> {
//!     machinist_codegen::Build::new().scene("specs/drive.toml").compile()
//! }
//! ```
//!
//! and in the crate, which depends on `machinist-contract`:
//!
//! ```text
//! mod drive {
//!     machinist_contract::include_scene!("drive");
//! }
//! ```

use std::collections::BTreeMap;
use std::fmt;
use std::path::{Path, PathBuf};

use crate::emit::rust::emit;
use crate::emit::{EmitError, EmitOptions};
use crate::mechanics::reduce::Keep;
use crate::pipeline;
use crate::spec::diagnostic::Diagnostics;
use crate::write::{WriteError, refuse_foreign, write_within};
use machinist_algebra::cas::Algebra;
use machinist_model::Model;

/// Emits scenes to `OUT_DIR` in a build script, one file per scene. They are derived by
/// Machinist's own algebra, or by Symbolica with the feature `symbolica`. Symbolica makes a
/// second build wait for the first.
///
/// ```
/// let folder = std::env::temp_dir().join(format!("emitted-{}", std::process::id()));
/// # std::fs::create_dir_all(&folder).unwrap();
/// machinist_codegen::Build::new()
///     .scene("../specs/scenes/two_mass.toml")
///     .out_dir(&folder)
///     .compile()?;
/// let text = std::fs::read_to_string(folder.join("two_mass.rs")).unwrap();
/// assert!(text.contains("coupling_stiffness"));
/// # std::fs::remove_dir_all(&folder).unwrap();
/// # Ok::<(), machinist_codegen::BuildError>(())
/// ```
///
/// A mistake in a spec ends the build with its file and line, and nothing is written:
///
/// ```
/// # let folder = std::env::temp_dir().join(format!("refused-{}", std::process::id()));
/// # std::fs::create_dir_all(&folder).unwrap();
/// let spec = folder.join("drive.toml");
/// std::fs::write(&spec, "[scene]\nname = \"drive\"\n[units]\nmotor = { unit = \"motr\" }\n").unwrap();
/// let refused = machinist_codegen::Build::new().scene(&spec).out_dir(&folder).compile();
/// assert!(format!("{:?}", refused.unwrap_err()).contains("drive.toml"));
/// assert!(!folder.join("drive.rs").exists());
/// # std::fs::remove_dir_all(&folder).unwrap();
/// ```
#[derive(Debug, Clone, Default)]
#[must_use = "nothing is emitted until `compile`"]
pub struct Build {
    scenes: Vec<PathBuf>,
    out_dir: Option<PathBuf>,
}

impl Build {
    /// Returns a build without scenes.
    pub fn new() -> Self {
        Self::default()
    }

    /// Adds the spec of a scene; its path is relative to the crate.
    pub fn scene(mut self, path: impl Into<PathBuf>) -> Self {
        self.scenes.push(path.into());
        self
    }

    /// Adds the specs of several scenes, likewise.
    pub fn scenes<P: Into<PathBuf>>(mut self, paths: impl IntoIterator<Item = P>) -> Self {
        self.scenes.extend(paths.into_iter().map(Into::into));
        self
    }

    /// Sets the folder to write to, instead of `OUT_DIR`.
    pub fn out_dir(mut self, folder: impl Into<PathBuf>) -> Self {
        self.out_dir = Some(folder.into());
        self
    }

    /// Emits `<scene>.rs` for every scene, named as in its spec, and tells Cargo every file that
    /// was read. Unchanged files are not touched.
    ///
    /// # Errors
    /// [`BuildError`]: a mistake in a spec, two scenes of one name, or a file that cannot be
    /// written. Only in the last case may other files have been written.
    pub fn compile(&self) -> Result<(), BuildError> {
        let folder = self.folder()?;
        let texts = self.texts()?;
        let targets: Vec<PathBuf> =
            texts.keys().map(|name| folder.join(format!("{name}.rs"))).collect();
        let targets = targets.iter().map(PathBuf::as_path);
        refuse_foreign(targets.zip(texts.values().map(String::as_str)))?;
        for (name, text) in &texts {
            write_within(&folder, &format!("{name}.rs"), text)?;
        }
        Ok(())
    }

    fn folder(&self) -> Result<PathBuf, BuildError> {
        let folder = self.out_dir.clone().or_else(|| std::env::var_os("OUT_DIR").map(Into::into));
        folder.ok_or(BuildError::NoFolder)
    }

    /// Returns the text of every scene by its name.
    fn texts(&self) -> Result<BTreeMap<String, String>, BuildError> {
        let options = EmitOptions::for_build_script();
        let mut texts = BTreeMap::new();
        for scene in &self.scenes {
            let model = generate(scene)?;
            let name = model.name.clone();
            let text = emit(&model, &options)
                .map_err(|source| BuildError::Emit { scene: name.clone(), source })?;
            if texts.insert(name.clone(), text).is_some() {
                return Err(BuildError::NamedTwice { scene: name });
            }
        }
        Ok(texts)
    }
}

/// Derives the model of a scene, and tells Cargo the files that were read. If the scene fails,
/// only the spec itself is named: Cargo runs a failed build script again in any case.
fn generate(scene: &Path) -> Result<Model, BuildError> {
    println!("cargo:rerun-if-changed={}", scene.display());
    let system = pipeline::check(scene)?;
    // Units that come with Machinist have no path; they change with the crate.
    for file in system.files.iter().filter(|file| !file.path.as_os_str().is_empty()) {
        println!("cargo:rerun-if-changed={}", file.path.display());
    }
    for warning in &system.warnings {
        let (file, line) = (&warning.file, warning.line);
        println!("cargo:warning={file}:{line}: {}", warning.message);
    }
    let algebra = Algebra::most_simplifying(system.coordinates.len());
    let model = pipeline::compile_by(algebra, system, Keep::Needed)?;
    if !model.freeze.rigid.is_empty() {
        let scene = &model.name;
        println!(
            "cargo:warning=some units of scene {scene} are frozen; `machinist explain` measures \
             the effect on its outputs"
        );
    }
    Ok(model)
}

/// Error of a build script that emits scenes. Its `Debug` form is a readable report, because
/// Cargo shows that when `main` returns it.
#[derive(thiserror::Error, strum::IntoStaticStr, strum::VariantNames)]
#[strum(prefix = "build::", serialize_all = "kebab-case")]
#[non_exhaustive]
pub enum BuildError {
    /// A spec is wrong.
    #[strum(serialize = "")]
    #[error("{}", .0.render())]
    Spec(#[from] Diagnostics),
    /// Two specs give their scene the same name.
    #[error("two scenes are named `{scene}`; they would overwrite each other")]
    NamedTwice {
        /// The name.
        scene: String,
    },
    /// A scene cannot be emitted.
    #[strum(serialize = "")]
    #[error("scene `{scene}`: {source}")]
    Emit {
        /// The scene.
        scene: String,
        /// The reason.
        source: EmitError,
    },
    /// A file cannot be written.
    #[strum(serialize = "")]
    #[error(transparent)]
    Write(#[from] WriteError),
    /// No folder to write to is known.
    #[error("OUT_DIR is not set: call this from a build script, or name a folder with `out_dir`")]
    NoFolder,
}

impl BuildError {
    /// Returns the code of this kind of error, which never changes; the book explains it.
    #[must_use]
    pub fn code(&self) -> &'static str {
        match self {
            Self::Spec(errors) => errors.code(),
            Self::Emit { source, .. } => source.code(),
            Self::Write(error) => error.code(),
            error => error.into(),
        }
    }
}

impl fmt::Debug for BuildError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{self}")
    }
}

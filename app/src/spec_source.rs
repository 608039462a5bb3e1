//! Source of a scene's spec: a file, or this program.

use std::fmt;
use std::path::{Path, PathBuf};

#[cfg(feature = "derive")]
use machinist_codegen::{
    scene::{compose, system::LagrangianSystem},
    spec::code::Code,
    spec::diagnostic::{Diagnostic, Diagnostics},
    spec::library::LibraryScene,
    spec::{self, SceneSpec},
};
use serde::{Deserialize, Serialize};

/// Source of a scene's spec.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub enum SpecSource {
    /// File.
    File(PathBuf),
    /// Spec built into this program, by name.
    BuiltIn(String),
}

#[cfg(feature = "derive")]
impl SpecSource {
    /// Reads the spec with the units it names.
    pub fn read(&self) -> Result<SceneSpec, Diagnostics> {
        match self {
            Self::File(path) => spec::load_scene(path),
            Self::BuiltIn(name) => match LibraryScene::find(name) {
                Some(scene) => spec::load_library_scene(scene),
                None => Err(Diagnostic::of_file(
                    Code::UnknownName,
                    name,
                    "no such scene is built in",
                    "",
                )
                .into()),
            },
        }
    }

    /// Reads and checks the spec, and composes it to one system.
    pub fn system(&self) -> Result<LagrangianSystem, Diagnostics> {
        compose(&self.read()?)
    }
}

impl From<&Path> for SpecSource {
    fn from(path: &Path) -> Self {
        Self::File(path.to_owned())
    }
}

impl fmt::Display for SpecSource {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::File(path) => path.display().fmt(f),
            Self::BuiltIn(name) => f.write_str(name),
        }
    }
}

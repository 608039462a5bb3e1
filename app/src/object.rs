//! Object files of emitted scenes, to measure their sizes and list their names.

use std::fs;
use std::io;
use std::path::Path;
use std::process::Command;

use machinist_codegen::emit::rust::{emit, type_name};
use machinist_codegen::emit::{EmitError, EmitOptions};
use machinist_contract::SOURCES;
use machinist_model::Model;
use tempfile::TempDir;
use thiserror::Error;

/// Reason why there is no object file.
#[derive(Debug, Error, strum::IntoStaticStr, strum::VariantNames)]
#[strum(prefix = "compiler::", serialize_all = "kebab-case")]
pub enum ObjectError {
    /// The program cannot be emitted.
    #[strum(serialize = "")]
    #[error(transparent)]
    Emit(#[from] EmitError),
    /// The compiler cannot be started, or its folder cannot be created.
    #[error("cannot run `{compiler}`: {source}")]
    Run {
        /// Compiler asked for.
        compiler: String,
        /// Error of the operating system.
        source: io::Error,
    },
    /// The compiler rejects the emitted module.
    #[error("the compiler refuses the emitted module: {0}")]
    Refused(String),
}

impl ObjectError {
    /// Returns the code of this kind of error, which never changes; the book explains it.
    #[must_use]
    pub fn code(&self) -> &'static str {
        match self {
            Self::Emit(error) => error.code(),
            error => error.into(),
        }
    }
}

/// The compiler `rustc`, or the one that the environment variable `RUSTC` names, with the contract crate
/// compiled for it.
pub struct Compiler {
    command: String,
    /// Holds the contract crate.
    folder: TempDir,
}

impl Compiler {
    /// Starts the compiler and compiles the contract crate.
    ///
    /// # Errors
    /// [`ObjectError`], also if there is no compiler.
    pub fn new() -> Result<Self, ObjectError> {
        let command = std::env::var("RUSTC").unwrap_or_else(|_| "rustc".to_owned());
        let failed = |source| ObjectError::Run { compiler: command.clone(), source };
        let folder = tempfile::tempdir().map_err(failed)?;
        for (file, text) in SOURCES {
            write(&folder.path().join(file), text).map_err(failed)?;
        }
        let compiler = Self { command, folder };
        compiler.compile(
            compiler.folder.path(),
            "machinist_contract",
            &["--cfg", "feature=\"std\"", "--out-dir", "."],
        )?;
        Ok(compiler)
    }

    /// Compiles everything that a simulator does with `f64` to an object file, optimized for size: to
    /// vectorize, as for speed, takes twice as long. The file holds of the contract crate only what is
    /// generic or inlined.
    ///
    /// # Errors
    /// [`ObjectError`].
    pub fn object(&self, model: &Model) -> Result<Vec<u8>, ObjectError> {
        let text = emit(model, &EmitOptions::for_scenes())?;
        // The name keeps the scene's functions.
        let scene = format!(
            "pub mod machine;\n#[unsafe(no_mangle)]\npub static MACHINE: \
             &(dyn machinist_contract::Simulator<f64> + Sync) = &machine::{};\n",
            type_name(&model.name)
        );
        let failed = |source| ObjectError::Run { compiler: self.command.clone(), source };
        let folder = tempfile::tempdir_in(self.folder.path()).map_err(failed)?;
        write(&folder.path().join("lib.rs"), &scene).map_err(failed)?;
        write(&folder.path().join("machine.rs"), &text).map_err(failed)?;
        let contract = "machinist_contract=../libmachinist_contract.rlib";
        let options = ["--extern", contract, "--emit", "obj", "-o", "machine.o"];
        self.compile(folder.path(), "machine", &options)?;
        fs::read(folder.path().join("machine.o")).map_err(failed)
    }

    /// Compiles the file `lib.rs` of a folder. Relative paths keep the name of the folder out of the result.
    fn compile(&self, folder: &Path, name: &str, options: &[&str]) -> Result<(), ObjectError> {
        let output = Command::new(&self.command)
            .args(["lib.rs", "--crate-name", name, "--crate-type", "lib", "--edition", "2024"])
            .args(["--cap-lints", "allow", "-C", "opt-level=s", "-C", "codegen-units=1"])
            .args(["-C", "panic=abort"])
            .args(options)
            .current_dir(folder)
            .output()
            .map_err(|source| ObjectError::Run { compiler: self.command.clone(), source })?;
        if output.status.success() {
            return Ok(());
        }
        Err(ObjectError::Refused(String::from_utf8_lossy(&output.stderr).into_owned()))
    }
}

fn write(file: &Path, text: &str) -> io::Result<()> {
    file.parent().map_or(Ok(()), fs::create_dir_all)?;
    fs::write(file, text)
}

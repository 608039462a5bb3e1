//! Object file of an emitted scene, to measure its size and list its names.

use std::fs;
use std::io::{self, Write as _};
use std::path::Path;
use std::process::Command;

use machinist_codegen::emit::rust::{emit, type_name};
use machinist_codegen::emit::{EmitError, EmitOptions};
use machinist_contract::SOURCES;
use machinist_model::Model;
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

/// Compiles everything that a simulator does with `f64` to an object file, optimized for size, with
/// `rustc` or the compiler that the environment variable `RUSTC` names. To vectorize, as for speed,
/// takes twice as long.
///
/// # Errors
/// [`ObjectError`], also if there is no compiler.
pub fn object(model: &Model) -> Result<Vec<u8>, ObjectError> {
    let text = emit(model, &EmitOptions::for_scenes())?;
    let compiler = std::env::var("RUSTC").unwrap_or_else(|_| "rustc".to_owned());
    let failed = |source| ObjectError::Run { compiler: compiler.clone(), source };
    let folder = tempfile::tempdir().map_err(failed)?;
    write_crate(folder.path(), &model.name, &text).map_err(failed)?;
    // Relative paths keep the name of the folder out of the object.
    let output = Command::new(&compiler)
        .args(["lib.rs", "--crate-name", "machine", "--crate-type", "lib", "--edition", "2024"])
        .args(["--emit", "obj", "-o", "machine.o", "--cfg", "feature=\"std\"", "--cap-lints"])
        .args(["allow", "-C", "opt-level=s", "-C", "codegen-units=1", "-C", "panic=abort"])
        .current_dir(folder.path())
        .output()
        .map_err(failed)?;
    if !output.status.success() {
        return Err(ObjectError::Refused(String::from_utf8_lossy(&output.stderr).into_owned()));
    }
    fs::read(folder.path().join("machine.o")).map_err(failed)
}

/// Writes the contract crate with the scene in it, and a name that keeps the scene's functions.
fn write_crate(folder: &Path, scene: &str, text: &str) -> io::Result<()> {
    for (file, text) in SOURCES {
        let file = folder.join(file);
        file.parent().map_or(Ok(()), fs::create_dir_all)?;
        fs::write(file, text)?;
    }
    fs::write(folder.join("machine.rs"), text)?;
    // The scene refers to the contract by name, which here is the crate itself.
    let scene = format!(
        "extern crate self as machinist_contract;\npub mod machine;\n#[unsafe(no_mangle)]\n\
         pub static MACHINE: &(dyn Simulator<f64> + Sync) = &machine::{};\n",
        type_name(scene)
    );
    let mut library = fs::OpenOptions::new().append(true).open(folder.join("lib.rs"))?;
    library.write_all(scene.as_bytes())
}

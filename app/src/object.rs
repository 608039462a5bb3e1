//! An emitted scene as machine code: how large it is and which names are in it.

use std::fs;
use std::io::{self, Write as _};
use std::path::Path;
use std::process::Command;

use machinist_codegen::emit::rust::{emit, type_name};
use machinist_codegen::emit::{EmitError, EmitOptions};
use machinist_contract::SOURCES;
use machinist_model::Model;
use thiserror::Error;

/// Why there is no object file.
#[derive(Debug, Error)]
pub enum ObjectError {
    /// The program cannot be emitted.
    #[error(transparent)]
    Emit(#[from] EmitError),
    /// There is no compiler, or no place for its files.
    #[error("cannot run `{compiler}`: {source}")]
    Run {
        /// The compiler asked for.
        compiler: String,
        /// What the operating system says.
        source: io::Error,
    },
    /// The compiler refuses the emitted module.
    #[error("the compiler refuses the emitted module: {0}")]
    Refused(String),
}

/// The object file of everything that a simulator does with `f64`, compiled with
/// optimisation by `rustc`, or by what the environment variable `RUSTC` names.
///
/// # Errors
/// [`ObjectError`], also where there is no compiler.
pub fn object(model: &Model) -> Result<Vec<u8>, ObjectError> {
    let text = emit(model, &EmitOptions::for_scenes())?;
    let compiler = std::env::var("RUSTC").unwrap_or_else(|_| "rustc".to_owned());
    let failed = |source| ObjectError::Run { compiler: compiler.clone(), source };
    let folder = tempfile::tempdir().map_err(failed)?;
    write_crate(folder.path(), &model.name, &text).map_err(failed)?;
    // Paths relative to the folder, so that its name is not within the object.
    let output = Command::new(&compiler)
        .args(["lib.rs", "--crate-name", "machine", "--crate-type", "lib", "--edition", "2024"])
        .args(["--emit", "obj", "-o", "machine.o", "--cfg", "feature=\"std\"", "--cap-lints"])
        .args(["allow", "-C", "opt-level=3", "-C", "codegen-units=1", "-C", "panic=abort"])
        .current_dir(folder.path())
        .output()
        .map_err(failed)?;
    if !output.status.success() {
        return Err(ObjectError::Refused(String::from_utf8_lossy(&output.stderr).into_owned()));
    }
    fs::read(folder.path().join("machine.o")).map_err(failed)
}

/// The contract crate with the scene in it, and a name that keeps its functions in.
fn write_crate(folder: &Path, scene: &str, text: &str) -> io::Result<()> {
    for (file, text) in SOURCES {
        let file = folder.join(file);
        file.parent().map_or(Ok(()), fs::create_dir_all)?;
        fs::write(file, text)?;
    }
    fs::write(folder.join("machine.rs"), text)?;
    // The scene asks for the contract by name, which here is the crate itself.
    let scene = format!(
        "extern crate self as machinist_contract;\npub mod machine;\n#[unsafe(no_mangle)]\n\
         pub static MACHINE: &(dyn Simulator<f64> + Sync) = &machine::{};\n",
        type_name(scene)
    );
    let mut library = fs::OpenOptions::new().append(true).open(folder.join("lib.rs"))?;
    library.write_all(scene.as_bytes())
}

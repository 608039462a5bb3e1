//! Search for the shared library that goes into archives.

use std::env::consts::{ARCH, DLL_PREFIX, DLL_SUFFIX, OS};
use std::env::current_exe;
use std::fs;
use std::path::{Path, PathBuf};

use machinist_codegen::emit::c99::FmiVersion;

use crate::cli::new::sources;
use crate::failure::{ErrorCode, Failure};

/// Shared library for the platform that this program runs on.
pub struct Library {
    /// Content of the file.
    pub bytes: Vec<u8>,
}

impl Library {
    /// Reads the given library, or the one that was built with this program.
    pub fn find(given: Option<&Path>) -> Result<Self, Failure> {
        let path = match given {
            Some(path) => path.to_owned(),
            None => built().ok_or_else(missing)?,
        };
        let bytes = fs::read(&path).map_err(|error| Failure::file(&path, &error))?;
        if !is_library(&bytes) {
            let message = format!("{}: not a shared library of this platform", path.display());
            return Err(Failure::coded(ErrorCode::InvalidData, message, build()));
        }
        Ok(Self { bytes })
    }

    /// Returns an archive's folder for libraries of this platform.
    ///
    /// # Errors
    /// If FMI 2.0 has no name for the platform.
    pub fn platform(version: FmiVersion) -> Result<String, Failure> {
        if version == FmiVersion::Two {
            return platform2();
        }
        let arch = if ARCH == "arm" { "aarch32" } else { ARCH };
        let system = if OS == "macos" { "darwin" } else { OS };
        Ok(format!("{arch}-{system}"))
    }

    /// Returns the name of the library in an archive, for a model with this identifier.
    pub fn file_name(identifier: &str) -> String {
        // Hosts expect no prefix.
        format!("{identifier}{DLL_SUFFIX}")
    }
}

/// Returns the folder of FMI 2.0, which knows two processors.
fn platform2() -> Result<String, Failure> {
    let system = match OS {
        "windows" => "win",
        "macos" => "darwin",
        other => other,
    };
    match ARCH {
        "x86_64" => Ok(format!("{system}64")),
        "x86" => Ok(format!("{system}32")),
        other => {
            let message = format!("FMI 2.0 has no libraries for processors of the kind {other}");
            Err(Failure::input(message, "use `--fmi 3`, or `--source` for hosts that compile"))
        }
    }
}

/// Returns the name under which Cargo builds the library.
fn built_name() -> String {
    format!("{DLL_PREFIX}machinist_fmu{DLL_SUFFIX}")
}

/// Returns the newest library beside the program or its tests, or else the one in the target folder
/// of the program's sources.
fn built() -> Option<PathBuf> {
    let name = built_name();
    let program = current_exe().ok();
    let beside = program
        .as_deref()
        .and_then(Path::parent)
        .map(|folder| [folder.join(&name), folder.join("deps").join(&name)]);
    let changed = |path: &PathBuf| fs::metadata(path).and_then(|file| file.modified()).ok();
    let newest = beside.into_iter().flatten().filter(|path| path.is_file()).max_by_key(changed);
    let in_sources = || sources().map(|folder| folder.join("target").join("release").join(&name));
    newest.or_else(in_sources).filter(|path| path.is_file())
}

fn missing() -> Failure {
    let message = format!("there is no `{}` beside this program", built_name());
    Failure::coded(
        ErrorCode::NotBuiltIn,
        message,
        format!("`--source` exports C99, which needs none; {}", build()),
    )
}

/// Returns the command that builds the library.
fn build() -> String {
    let manifest = match sources() {
        Some(folder) => folder.join("Cargo.toml").display().to_string(),
        None => "Cargo.toml".to_owned(),
    };
    let name = built_name();
    format!(
        "`cargo build --release --package machinist-fmu --manifest-path {manifest}` builds it, as \
         `target/release/{name}` there; `--library FILE` takes one from elsewhere"
    )
}

/// Returns whether bytes begin like a shared library of this platform.
fn is_library(bytes: &[u8]) -> bool {
    let marks: &[&[u8]] = match OS {
        "windows" => &[b"MZ"],
        "macos" => &[b"\xcf\xfa\xed\xfe", b"\xca\xfe\xba\xbe"],
        _ => &[b"\x7fELF"],
    };
    marks.iter().any(|mark| bytes.starts_with(mark))
}

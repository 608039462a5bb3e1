//! Hash of the generator's own source text, which identifies the origin of models, and path of
//! the specs that come with it.

use std::fmt::Write as _;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use sha2::{Digest as _, Sha256};

/// Folders whose source text determines models.
const FOLDERS: [&str; 3] = ["src", "../crates/algebra/src", "../crates/model/src"];

fn main() -> io::Result<()> {
    let mut files = Vec::new();
    // A package alone does not contain all of these folders; versions identify the others.
    for folder in FOLDERS.iter().map(Path::new).filter(|folder| folder.is_dir()) {
        println!("cargo:rerun-if-changed={}", folder.display());
        collect(folder, &mut files)?;
    }
    files.sort();
    let mut hasher = Sha256::new();
    for file in files {
        hasher.update(fs::read(file)?);
    }
    let mut text = String::new();
    for byte in &hasher.finalize()[..8] {
        let _ = write!(text, "{byte:02x}");
    }
    println!("cargo:rustc-env=MACHINIST_GENERATOR={text}");
    println!("cargo:rustc-env=MACHINIST_SPECS={}", specs()?.display());
    Ok(())
}

/// Returns the folder of the specs: beside this package in the source tree, within it once
/// packed. There is a link in the source tree too, which not every system follows.
fn specs() -> io::Result<PathBuf> {
    let beside = Path::new("../specs");
    let place = if beside.is_dir() { beside } else { Path::new("specs") };
    place.canonicalize()
}

fn collect(folder: &Path, files: &mut Vec<PathBuf>) -> io::Result<()> {
    for entry in fs::read_dir(folder)? {
        let path = entry?.path();
        if path.is_dir() {
            collect(&path, files)?;
        } else if path.extension().is_some_and(|ending| ending == "rs") {
            files.push(path);
        }
    }
    Ok(())
}

//! Emitted text to files, or the check that files are what would be emitted.
//!
//! Excluded: what the text says. A file is written only if it changes, whole or
//! not at all, and only within the folder given, but for the manifest of the crate
//! that the folder belongs to; nothing is ever deleted, and nothing overwritten that
//! Machinist has not written itself: all targets are looked at before any is written.

mod features;

use std::ffi::OsStr;
use std::fmt::Write as _;
use std::fs;
use std::io::{self, Write as _};
use std::path::{Component, Path, PathBuf};

use crate::emit::c99::{self, C99Options};
use crate::emit::rust::{MARK, emit, emit_index};
use crate::emit::{EmitError, EmitOptions};
use machinist_model::Model;

/// The command that mends emitted scenes which are not fresh.
pub const MENDING_COMMAND: &str = "cargo run --release -- gen";

/// Whether to write or only to compare.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Mode {
    /// Write what has changed.
    Write,
    /// Write nothing; [`WriteError::NotFresh`] if anything would be written.
    Check,
}

/// What [`write_if_changed`] did.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Written {
    /// The file did not exist.
    Created,
    /// The file said something else.
    Changed,
    /// The file says the same; it has not been touched.
    Unchanged,
}

/// How a file compares with the text it should hold.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Freshness {
    /// It holds the text.
    Fresh,
    /// It holds something else.
    Stale,
    /// There is no such file.
    Missing,
}

/// What [`emit_scenes`] found and did.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Summary {
    /// Names of all files of the scenes, sorted, with what was done.
    pub files: Vec<(String, Written)>,
    /// Emitted files of scenes that are no more; a person may delete them.
    pub orphans: Vec<String>,
}

/// Why emitted files could not be written, or are not as they should be.
#[derive(Debug, thiserror::Error)]
pub enum WriteError {
    /// A model cannot be emitted.
    #[error("scene `{scene}`: {source}")]
    Emit {
        /// The scene.
        scene: String,
        /// What is wrong with it.
        source: EmitError,
    },
    /// A file cannot be read or written.
    #[error("{}: {source}", path.display())]
    Io {
        /// The file.
        path: PathBuf,
        /// What the operating system says.
        source: io::Error,
    },
    /// Files in the way that Machinist has not written. Nothing was written.
    #[error("{}", describe_foreign(.files))]
    Foreign {
        /// Their paths, with what they are.
        files: Vec<(PathBuf, &'static str)>,
    },
    /// A file is missing, not what is emitted, or of a scene that is no more.
    #[error("{}", describe_not_fresh(.files, .orphans))]
    NotFresh {
        /// Names of files, with what is wrong.
        files: Vec<(String, Freshness)>,
        /// Emitted files of scenes that are no more.
        orphans: Vec<String>,
    },
}

/// Emits every model to `<scene>.rs` in `folder`, and `mod.rs` that lists them. If
/// `folder` is `src/scenes` of a crate with a feature `scenes`, its manifest gets one
/// feature for each.
///
/// # Errors
/// [`WriteError`]; in [`Mode::Check`], [`WriteError::NotFresh`] names every file
/// that is not fresh, and the command that mends them.
pub fn emit_scenes(folder: &Path, models: &[Model], mode: Mode) -> Result<Summary, WriteError> {
    let manifest = manifest(folder, models)?;
    let texts = texts(models, manifest.is_some())?;
    let orphans = orphans(folder, &texts)?;
    let mut files = Vec::with_capacity(texts.len() + 1);
    for (file, text) in texts {
        files.push((path_within(folder, &file)?, file, text));
    }
    files.extend(manifest);
    match mode {
        Mode::Write => {
            let emitted = files.iter().filter(|(_, file, _)| file != MANIFEST);
            refuse_foreign(emitted.map(|(path, _, text)| (path.as_path(), text.as_str())))?;
            let files = files.into_iter().map(|(path, file, text)| {
                let failed = |source| WriteError::Io { path: path.clone(), source };
                fs::create_dir_all(folder).map_err(failed)?;
                Ok((file, write_if_changed(&path, &text).map_err(failed)?))
            });
            Ok(Summary { files: files.collect::<Result<_, WriteError>>()?, orphans })
        }
        Mode::Check => check_all(files, orphans),
    }
}

/// Emits a model as C99 to `folder`: `<scene>.h`, `<scene>.c`, `CMakeLists.txt` and an example.
///
/// # Errors
/// As [`emit_scenes`].
pub fn emit_c99(
    folder: &Path,
    model: &Model,
    options: &C99Options,
    mode: Mode,
) -> Result<Summary, WriteError> {
    let refuse = |source| WriteError::Emit { scene: model.name.clone(), source };
    let emitted = c99::emit(model, options).map_err(refuse)?;
    let mut files = Vec::with_capacity(emitted.len());
    for c99::C99File { name, text } in emitted {
        files.push((path_within(folder, &name)?, name, text));
    }
    if mode == Mode::Check {
        return check_all(files, Vec::new());
    }
    refuse_foreign(files.iter().map(|(path, _, text)| (path.as_path(), text.as_str())))?;
    let files = files.into_iter().map(|(path, file, text)| {
        let failed = |source| WriteError::Io { path: path.clone(), source };
        fs::create_dir_all(folder).map_err(failed)?;
        Ok((file, write_if_changed(&path, &text).map_err(failed)?))
    });
    Ok(Summary { files: files.collect::<Result<_, WriteError>>()?, orphans: Vec::new() })
}

/// The manifest of a crate.
const MANIFEST: &str = "Cargo.toml";

/// Refuses to write where something else is than an emitted file.
///
/// # Errors
/// [`WriteError::Foreign`] with every such target.
pub(crate) fn refuse_foreign<'a>(
    targets: impl Iterator<Item = (&'a Path, &'a str)>,
) -> Result<(), WriteError> {
    let mut files = Vec::new();
    for (path, text) in targets {
        let what = match fs::metadata(path) {
            Err(_) if fs::symlink_metadata(path).is_ok() => "is a link to nothing",
            Err(_) => continue,
            Ok(metadata) if metadata.is_dir() => "is a folder",
            Ok(_) if is_emitted(path) || check(path, text).is_ok_and(|f| f == Freshness::Fresh) => {
                continue;
            }
            Ok(_) => "was not emitted by Machinist",
        };
        files.push((path.to_owned(), what));
    }
    if files.is_empty() { Ok(()) } else { Err(WriteError::Foreign { files }) }
}

/// Writes `text` to `file`, a plain file name, in `folder`, which is made if need be.
///
/// # Errors
/// [`WriteError::Io`], also if `file` would lie outside of `folder`.
pub fn write_within(folder: &Path, file: &str, text: &str) -> Result<Written, WriteError> {
    let path = path_within(folder, file)?;
    let failed = |source| WriteError::Io { path: path.clone(), source };
    fs::create_dir_all(folder).map_err(failed)?;
    write_if_changed(&path, text).map_err(failed)
}

/// Writes `text` to `path` unless that is what the file holds. A reader sees the
/// old file or the new one, never a part: the text goes to a file beside it,
/// which then takes its name.
///
/// # Errors
/// What the operating system says; the old file is then as it was.
pub fn write_if_changed(path: &Path, text: &str) -> io::Result<Written> {
    let written = match check(path, text)? {
        Freshness::Fresh => return Ok(Written::Unchanged),
        Freshness::Stale => Written::Changed,
        Freshness::Missing => Written::Created,
    };
    let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty());
    let mut file = new_file_in(folder.unwrap_or(Path::new(".")))?;
    file.write_all(text.as_bytes())?;
    file.flush()?;
    file.persist(path).map_err(|error| error.error)?;
    Ok(written)
}

/// Compares a file with the text it should hold.
///
/// # Errors
/// What the operating system says if the file exists but cannot be read.
pub fn check(path: &Path, text: &str) -> io::Result<Freshness> {
    match fs::read(path) {
        Ok(bytes) if bytes == text.as_bytes() => Ok(Freshness::Fresh),
        Ok(_) => Ok(Freshness::Stale),
        Err(error) if error.kind() == io::ErrorKind::NotFound => Ok(Freshness::Missing),
        Err(error) => Err(error),
    }
}

/// File names and texts of all scenes and their index, sorted by name.
fn texts(models: &[Model], scene_features: bool) -> Result<Vec<(String, String)>, WriteError> {
    let options = EmitOptions { scene_features, ..EmitOptions::for_scenes() };
    let refer = |scene: &str, source| WriteError::Emit { scene: scene.to_owned(), source };
    let mut sorted: Vec<&Model> = models.iter().collect();
    sorted.sort_by(|a, b| a.name.cmp(&b.name));
    let index = emit_index(&sorted, &options).map_err(|source| refer("mod", source))?;
    let mut texts = Vec::with_capacity(models.len() + 1);
    for model in sorted {
        let name = &model.name;
        let text = emit(model, &options).map_err(|source| refer(name, source))?;
        texts.push((format!("{name}.rs"), text));
    }
    texts.push(("mod.rs".to_owned(), index));
    texts.sort();
    Ok(texts)
}

/// The manifest of the crate that `folder` belongs to, with a feature for each scene.
fn manifest(
    folder: &Path,
    models: &[Model],
) -> Result<Option<(PathBuf, String, String)>, WriteError> {
    let Some(path) = features::manifest_of(folder) else { return Ok(None) };
    let scenes: Vec<&str> = models.iter().map(|model| model.name.as_str()).collect();
    let failed = |source| WriteError::Io { path: path.clone(), source };
    let text = fs::read_to_string(&path).map_err(failed)?;
    let text = features::with_scenes(&text, &scenes);
    let text = text.map_err(|error| failed(io::Error::new(io::ErrorKind::InvalidData, error)))?;
    Ok(text.map(|text| (path, MANIFEST.to_owned(), text)))
}

fn check_all(
    files: Vec<(PathBuf, String, String)>,
    orphans: Vec<String>,
) -> Result<Summary, WriteError> {
    let mut summary = Summary { files: Vec::new(), orphans };
    let mut not_fresh = Vec::new();
    for (path, file, text) in files {
        match check(&path, &text).map_err(|source| WriteError::Io { path, source })? {
            Freshness::Fresh => summary.files.push((file, Written::Unchanged)),
            freshness => not_fresh.push((file, freshness)),
        }
    }
    if not_fresh.is_empty() && summary.orphans.is_empty() {
        Ok(summary)
    } else {
        Err(WriteError::NotFresh { files: not_fresh, orphans: summary.orphans })
    }
}

/// Emitted files in `folder` that no model gives any more, sorted.
fn orphans(folder: &Path, texts: &[(String, String)]) -> Result<Vec<String>, WriteError> {
    let failed = |source| WriteError::Io { path: folder.to_owned(), source };
    let entries = match fs::read_dir(folder) {
        Ok(entries) => entries,
        Err(error) if error.kind() == io::ErrorKind::NotFound => return Ok(Vec::new()),
        Err(error) => return Err(failed(error)),
    };
    let mut orphans = Vec::new();
    for entry in entries {
        let path = entry.map_err(failed)?.path();
        let Some(name) = path.file_name().and_then(OsStr::to_str) else { continue };
        let is_rust = path.extension() == Some(OsStr::new("rs"));
        let is_wanted = texts.iter().any(|(file, _)| file == name);
        if is_rust && !is_wanted && is_emitted(&path) {
            orphans.push(name.to_owned());
        }
    }
    orphans.sort();
    Ok(orphans)
}

/// Whether a file begins as emitted files do.
fn is_emitted(path: &Path) -> bool {
    let marks = [MARK.to_owned(), format!("/* {}", c99::MARK), format!("# {}", c99::MARK)];
    fs::read(path).is_ok_and(|bytes| marks.iter().any(|mark| bytes.starts_with(mark.as_bytes())))
}

/// The path of a plain file name in a folder.
fn path_within(folder: &Path, file: &str) -> Result<PathBuf, WriteError> {
    let path = folder.join(file);
    let mut components = Path::new(file).components();
    let is_plain = matches!(components.next(), Some(Component::Normal(name)) if name == file)
        && components.next().is_none()
        && !file.contains(['/', '\\']);
    if is_plain {
        Ok(path)
    } else {
        let message = "only plain file names may be written into the output folder";
        let source = io::Error::new(io::ErrorKind::InvalidInput, message);
        Err(WriteError::Io { path, source })
    }
}

/// A nameless file with the permissions any new file gets.
fn new_file_in(folder: &Path) -> io::Result<tempfile::NamedTempFile> {
    let mut builder = tempfile::Builder::new();
    builder.prefix(".machinist-").suffix(".part");
    #[cfg(unix)]
    {
        use std::os::unix::fs::PermissionsExt as _;
        // The user's mask takes away from this, as it does everywhere else.
        builder.permissions(fs::Permissions::from_mode(0o666));
    }
    builder.tempfile_in(folder)
}

fn describe_foreign(files: &[(PathBuf, &'static str)]) -> String {
    let mut text = String::from("something is in the way of emitted files; nothing was written:");
    for (path, what) in files {
        let _ = write!(text, "\n  {} {what}", path.display());
    }
    text.push_str("\nmove it away, rename the scene, or name another folder");
    text
}

fn describe_not_fresh(files: &[(String, Freshness)], orphans: &[String]) -> String {
    let mut text = String::from("emitted scenes are not what the specs give:");
    for (file, freshness) in files {
        let what = match freshness {
            Freshness::Missing => "is missing",
            Freshness::Stale | Freshness::Fresh => "is out of date",
        };
        let _ = write!(text, "\n  {file} {what}");
    }
    for file in orphans {
        let _ = write!(text, "\n  {file} has no scene any more; delete it");
    }
    let _ = write!(text, "\nrun `{MENDING_COMMAND}`");
    text
}

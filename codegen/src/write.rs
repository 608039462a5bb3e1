//! Writes emitted text to files, or checks that files are up to date.
//!
//! Excluded: the contents of the text. A file is written only if it changes, and then as a whole.
//! All files are within the given folder, except for the manifest of its crate. Nothing is
//! deleted, and no file is overwritten that Machinist has not written itself: all targets are
//! checked before the first is written.

mod features;

use std::ffi::OsStr;
use std::fmt::Write as _;
use std::fs;
use std::io::{self, Write as _};
use std::path::{Component, Path, PathBuf};

use crate::emit::c99::{self, C99Options};
use crate::emit::rust::{MARK, emit, emit_estimator, emit_index};
use crate::emit::{EmitError, EmitOptions};
use machinist_contract::fixed_step::StepMethod;
use machinist_model::Model;

/// The command that updates emitted scenes.
pub const MENDING_COMMAND: &str = "cargo run --release -- gen";

/// Choice between writing and comparing only.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Mode {
    /// Write what has changed.
    Write,
    /// Write nothing; [`WriteError::NotFresh`] if anything would be written.
    Check,
}

/// Result of [`write_if_changed`].
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Written {
    /// The file did not exist.
    Created,
    /// The file had other contents.
    Changed,
    /// The file had the same contents and was not touched.
    Unchanged,
}

/// Result of comparing a file with the text it should contain.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Freshness {
    /// The file contains the text.
    Fresh,
    /// The file has other contents.
    Stale,
    /// There is no such file.
    Missing,
}

/// Result of [`emit_scenes`].
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Summary {
    /// Names of all files of the scenes, sorted, with the action taken.
    pub files: Vec<(String, Written)>,
    /// Emitted files of scenes that no longer exist. They may be deleted by hand.
    pub orphans: Vec<String>,
}

/// Error of writing or comparing emitted files.
#[derive(Debug, thiserror::Error, strum::IntoStaticStr, strum::VariantNames)]
#[strum(prefix = "write::", serialize_all = "kebab-case")]
#[non_exhaustive]
pub enum WriteError {
    /// A model cannot be emitted.
    #[strum(serialize = "")]
    #[error("scene `{scene}`: {source}")]
    Emit {
        /// The scene.
        scene: String,
        /// The reason.
        source: EmitError,
    },
    /// A file cannot be read or written.
    #[error("{}: {source}", path.display())]
    Io {
        /// The file.
        path: PathBuf,
        /// The error of the operating system.
        source: io::Error,
    },
    /// Files in the way that Machinist has not written. Nothing was written.
    #[error("{}", describe_foreign(.files))]
    Foreign {
        /// Their paths, and their kinds.
        files: Vec<(PathBuf, &'static str)>,
    },
    /// A file is missing, out of date, or belongs to a scene that no longer exists.
    #[error("{}", describe_not_fresh(.files, .orphans))]
    NotFresh {
        /// Names of files, with their state.
        files: Vec<(String, Freshness)>,
        /// Emitted files of scenes that no longer exist.
        orphans: Vec<String>,
    },
}

impl WriteError {
    /// Returns the code of this kind of error, which never changes; the book explains it.
    #[must_use]
    pub fn code(&self) -> &'static str {
        match self {
            Self::Emit { source, .. } => source.code(),
            error => error.into(),
        }
    }
}

/// Emits every model to `<scene>.rs` in `folder`, and `mod.rs` that lists them. If `folder` is
/// `src/scenes` of a crate with a feature `scenes`, its manifest gets one feature per scene.
///
/// # Errors
/// [`WriteError`]; in [`Mode::Check`], [`WriteError::NotFresh`] names every file that is out of
/// date, and the command that updates them.
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
/// Returns the stack of its functions, too.
///
/// # Errors
/// As [`emit_scenes`].
pub fn emit_c99(
    folder: &Path,
    model: &Model,
    options: &C99Options,
    mode: Mode,
) -> Result<(Summary, c99::StackBounds), WriteError> {
    let refuse = |source| WriteError::Emit { scene: model.name.clone(), source };
    let emitted = c99::emit(model, options).map_err(refuse)?;
    let stack = c99::StackBounds::of(&emitted[0].text, &emitted[1].text);
    let texts = emitted.into_iter().map(|c99::C99File { name, text }| (name, text));
    Ok((write_all(folder, texts, mode)?, stack))
}

/// Emits a model and a filter for it as Rust to `folder`: `<scene>.rs`, `<scene>_ekf.rs`, and
/// `mod.rs` with both. `start` is the state at the start of its run.
///
/// # Errors
/// As [`emit_scenes`].
pub fn emit_rust_estimator(
    folder: &Path,
    model: &Model,
    (filter, method, start): (&c99::EstimatorOptions, StepMethod, &[f64]),
    command: &str,
    mode: Mode,
) -> Result<Summary, WriteError> {
    let refuse = |source| WriteError::Emit { scene: model.name.clone(), source };
    let options = EmitOptions { command: command.to_owned(), scene_features: false };
    let name = &model.name;
    let index = format!(
        "{MARK} {}; do not edit.\n\npub mod {name};\npub mod {name}_ekf;\n",
        env!("CARGO_PKG_VERSION")
    );
    let scene = emit(model, &options).map_err(refuse)?;
    let own = emit_estimator(model, filter, method, start, &options).map_err(refuse)?;
    let texts = [
        (format!("{name}.rs"), scene),
        (format!("{name}_ekf.rs"), own),
        ("mod.rs".to_owned(), index),
    ];
    write_all(folder, texts, mode)
}

/// Writes or compares files of one scene, by name and text.
fn write_all(
    folder: &Path,
    texts: impl IntoIterator<Item = (String, String)>,
    mode: Mode,
) -> Result<Summary, WriteError> {
    let files = texts.into_iter().map(|(file, text)| Ok((path_within(folder, &file)?, file, text)));
    let files = files.collect::<Result<Vec<_>, WriteError>>()?;
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

/// File name of the manifest of a crate.
const MANIFEST: &str = "Cargo.toml";

/// Rejects targets that exist and are not emitted files.
///
/// # Errors
/// [`WriteError::Foreign`] with all such targets.
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

/// Writes `text` to `file`, a plain file name, in `folder`, which is created if necessary.
///
/// # Errors
/// [`WriteError::Io`], also if `file` would lie outside of `folder`.
pub fn write_within(folder: &Path, file: &str, text: &str) -> Result<Written, WriteError> {
    let path = path_within(folder, file)?;
    let failed = |source| WriteError::Io { path: path.clone(), source };
    fs::create_dir_all(folder).map_err(failed)?;
    write_if_changed(&path, text).map_err(failed)
}

/// Writes `text` to `path` unless the file already contains it. Readers see the old file or the
/// new one, never a part: the text is written to a temporary file, which then replaces the old
/// one.
///
/// # Errors
/// The error of the operating system. The old file is then unchanged.
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

/// Compares a file with the text it should contain.
///
/// # Errors
/// The error of the operating system if the file exists but cannot be read.
pub fn check(path: &Path, text: &str) -> io::Result<Freshness> {
    match fs::read(path) {
        Ok(bytes) if bytes == text.as_bytes() => Ok(Freshness::Fresh),
        Ok(_) => Ok(Freshness::Stale),
        Err(error) if error.kind() == io::ErrorKind::NotFound => Ok(Freshness::Missing),
        Err(error) => Err(error),
    }
}

/// Returns file names and texts of all scenes and of their index, sorted by name.
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

/// Returns the manifest of the crate that contains `folder`, with a feature for each scene.
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

/// Returns the emitted files in `folder` that belong to no model, sorted.
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

/// Reports whether a file begins as emitted files do.
fn is_emitted(path: &Path) -> bool {
    let marks = [MARK.to_owned(), format!("/* {}", c99::MARK), format!("# {}", c99::MARK)];
    fs::read(path).is_ok_and(|bytes| marks.iter().any(|mark| bytes.starts_with(mark.as_bytes())))
}

/// Returns the path of a plain file name in a folder.
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

/// Creates a temporary file with the default permissions of new files.
fn new_file_in(folder: &Path) -> io::Result<tempfile::NamedTempFile> {
    let mut builder = tempfile::Builder::new();
    builder.prefix(".machinist-").suffix(".part");
    #[cfg(unix)]
    {
        use std::os::unix::fs::PermissionsExt as _;
        // The umask of the user is applied to this, as usual.
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
    let mut text = String::from("emitted scenes do not match the specs:");
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

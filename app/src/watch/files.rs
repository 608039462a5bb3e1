//! Files of a watched spec and detection of their changes.

use std::collections::BTreeMap;
use std::ffi::OsStr;
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::mpsc::Sender;

use machinist_codegen::spec::MAX_FILE_BYTES;
use machinist_model::fingerprint::of_bytes;
use notify::event::{AccessKind, AccessMode};
use notify::{Event, EventKind, RecommendedWatcher, RecursiveMode, Watcher as _};

use super::Message;
use crate::failure::Failure;

/// Extensions of files of a spec.
const ENDINGS: [&str; 2] = ["toml", "csv"];

/// Files of a watched spec.
///
/// Folders are watched rather than files, because many editors write a new file and rename it to
/// the old name. Notifications may get lost, as on network drives, so contents are compared, and
/// the owner of this value compares them again from time to time.
pub struct Files {
    scene: PathBuf,
    /// Files of the spec; if it could not be read, those known before.
    known: Vec<PathBuf>,
    /// True if the known files are all files of the spec.
    are_all: bool,
    watcher: RecommendedWatcher,
    folders: Vec<PathBuf>,
    seen: BTreeMap<PathBuf, String>,
}

impl Files {
    /// Watches a scene file and what is beside it.
    pub fn of(scene: &Path, inbox: Sender<Message>) -> Result<Self, Failure> {
        let failed = |error: notify::Error| {
            Failure::unsuccessful(format!("{}: cannot be watched: {error}", scene.display()), "")
        };
        let told = move |event: notify::Result<Event>| {
            // Errors of the watcher may hide changes.
            if event.is_ok_and(|event| !changes(event.kind)) {
                return;
            }
            let _ = inbox.send(Message::Changed);
        };
        let watcher = notify::recommended_watcher(told).map_err(failed)?;
        let mut files = Self {
            scene: scene.to_owned(),
            known: vec![scene.to_owned()],
            are_all: false,
            watcher,
            folders: Vec::new(),
            seen: BTreeMap::new(),
        };
        let folder = folder_of(scene);
        files.watcher.watch(&folder, RecursiveMode::NonRecursive).map_err(failed)?;
        files.folders.push(folder);
        files.watch_folders();
        files.seen = files.look();
        Ok(files)
    }

    /// Sets the files of a spec that was read, with the hashes of what was read. If the spec could
    /// not be read, keeps the known files and adds those in which errors are, by their labels.
    pub fn are<'a>(
        &mut self,
        read: Option<Vec<(PathBuf, String)>>,
        wrong: impl Iterator<Item = &'a str>,
    ) {
        let before = std::mem::take(&mut self.seen);
        self.are_all = read.is_some();
        if let Some(read) = read {
            self.known = read.iter().map(|(path, _)| path.clone()).collect();
            self.seen = read.into_iter().collect();
        } else {
            let wrong = wrong.filter(|label| !label.is_empty()).map(|label| self.labelled(label));
            let wrong: Vec<PathBuf> = wrong.collect();
            self.known.extend(wrong);
            self.known.sort();
            self.known.dedup();
        }
        self.watch_folders();
        // Files watched only from now on count as unchanged.
        for (path, now) in self.look() {
            let then = before.get(&path).cloned();
            self.seen.entry(path).or_insert_with(|| then.unwrap_or(now));
        }
    }

    /// Returns the file of a label, which is its path from the folder above the scene's, or its
    /// name.
    fn labelled(&self, label: &str) -> PathBuf {
        let folder = folder_of(&self.scene);
        let above = fs::canonicalize(&folder).ok().and_then(|f| f.parent().map(Path::to_path_buf));
        let whole = above.map(|above| above.join(label));
        whole.filter(|path| path.is_file()).unwrap_or_else(|| folder.join(label))
    }

    /// True if any content differs from that at the last call.
    pub fn have_changed(&mut self) -> bool {
        let looked = self.look();
        let differ = looked != self.seen;
        self.seen = looked;
        differ
    }

    /// Returns the present content hash of each file.
    fn look(&self) -> BTreeMap<PathBuf, String> {
        let mut paths = self.known.clone();
        paths.push(self.scene.clone());
        if !self.are_all {
            paths.extend(self.folders.iter().flat_map(|folder| of_specs(folder)));
        }
        paths.into_iter().map(|path| (path.clone(), content(&path))).collect()
    }

    /// Watches the folders of all files, and the folder of units beside that of the scene. A
    /// missing folder cannot be watched and is polled instead.
    fn watch_folders(&mut self) {
        let mut wanted: Vec<PathBuf> = self.known.iter().map(|path| folder_of(path)).collect();
        wanted.push(folder_of(&self.scene));
        // A link and its target change independently.
        let targets = self.known.iter().filter_map(|path| fs::canonicalize(path).ok());
        wanted.extend(targets.map(|path| folder_of(&path)));
        wanted.push(folder_of(&self.scene).join("../units"));
        wanted.sort();
        wanted.dedup();
        for folder in wanted {
            let is_new = !self.folders.contains(&folder);
            if is_new && self.watcher.watch(&folder, RecursiveMode::NonRecursive).is_ok() {
                self.folders.push(folder);
            }
        }
    }
}

/// True if such an event may change the content of a file. Reading does not.
fn changes(kind: EventKind) -> bool {
    !matches!(kind, EventKind::Access(access) if access != AccessKind::Close(AccessMode::Write))
}

fn folder_of(path: &Path) -> PathBuf {
    match path.parent() {
        Some(folder) if !folder.as_os_str().is_empty() => folder.to_owned(),
        _ => PathBuf::from("."),
    }
}

/// Lists the files of a folder that may belong to specs.
fn of_specs(folder: &Path) -> Vec<PathBuf> {
    let is_of_specs = |path: &PathBuf| {
        let ending = path.extension().and_then(OsStr::to_str);
        ending.is_some_and(|ending| ENDINGS.contains(&ending))
    };
    let files = fs::read_dir(folder).into_iter().flatten().flatten();
    files.map(|file| file.path()).filter(is_of_specs).collect()
}

/// Returns the SHA-256 of a file in hexadecimal, as specs write it. Empty for a file that cannot be
/// part of a spec.
fn content(path: &Path) -> String {
    let is_of_specs = |data: &fs::Metadata| data.is_file() && data.len() <= MAX_FILE_BYTES;
    let bytes = fs::metadata(path).ok().filter(is_of_specs).and_then(|_| fs::read(path).ok());
    bytes.map(|bytes| of_bytes(&bytes)).unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn reading_a_file_is_no_change_and_writing_it_is() {
        let read = EventKind::Access(AccessKind::Open(AccessMode::Any));
        let closed = EventKind::Access(AccessKind::Close(AccessMode::Read));
        let written = EventKind::Access(AccessKind::Close(AccessMode::Write));
        assert!(!changes(read) && !changes(closed) && changes(written));
        assert!(changes(EventKind::Any));
    }

    #[test]
    fn contents_tell_files_apart_and_not_their_times() {
        let folder = tempfile::tempdir().expect("a folder");
        let file = folder.path().join("a.toml");
        let missing = content(&file);
        fs::write(&file, "a").expect("written");
        let first = content(&file);
        fs::write(&file, "b").expect("written");
        let second = content(&file);
        fs::write(&file, "a").expect("written");
        assert!(missing != first && first != second && content(&file) == first);
    }
}

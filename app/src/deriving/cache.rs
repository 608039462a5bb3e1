//! Cache of derived models and equations, by the content of their specs.
//!
//! The name of an entry is the hash of everything that determines it: the files of the spec, the
//! generator's own text, the request. An entry is therefore never outdated, only unused, and the
//! least recently used ones are deleted when there are too many. Entries are written to a temporary
//! file and renamed, so that concurrent processes see complete ones or none. An entry that cannot
//! be read is derived again. A failure to write one is reported and does not end the command.

use std::fs::{self, File};
use std::io::{self, Write as _};
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::SystemTime;

use machinist_algebra::cas::Algebra;
use machinist_codegen::pipeline::GENERATOR;
use machinist_codegen::spec::SourceFile;
use machinist_model::file::{VERSION, open, seal};
use sha2::{Digest as _, Sha256};

use super::{Derived, Request};

/// First bytes of an entry.
const MARK: &[u8; 16] = b"machinist cache\n";
/// Extension of entries.
const ENDING: &str = "derived";
/// Maximum size of all entries together, in bytes.
const MOST_BYTES: u64 = 256 << 20;

static IS_OFF: AtomicBool = AtomicBool::new(false);

/// Folder of entries.
#[derive(Debug, Clone)]
pub struct Cache {
    folder: Option<PathBuf>,
}

/// Name of an entry.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Key(String);

/// Size of a cache.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Size {
    /// Number of entries.
    pub entries: usize,
    /// Size in bytes.
    pub bytes: u64,
}

/// Turns reading and writing of the cache off in this process.
pub fn turn_off() {
    IS_OFF.store(true, Ordering::Relaxed);
}

/// Returns the key of a request for a spec with these files, derived by an algebra.
pub(super) fn key(request: &Request, algebra: Algebra, files: &[SourceFile]) -> Key {
    let mut hasher = Sha256::new();
    let mut add = |part: &str| {
        hasher.update((part.len() as u64).to_le_bytes());
        hasher.update(part.as_bytes());
    };
    add(&VERSION.to_string());
    add(GENERATOR);
    let Request { wanted, keep, rigid, dropped, test_forces, opened, .. } = request;
    add(&format!("{wanted:?} {keep:?} {rigid:?} {} {dropped:?} {test_forces:?}", algebra.name()));
    if !opened.is_empty() {
        add(&format!("{opened:?}"));
    }
    for file in files {
        add(&file.label);
        add(&file.sha256);
    }
    Key(hex(&hasher.finalize()))
}

fn hex(bytes: &[u8]) -> String {
    use std::fmt::Write as _;
    bytes.iter().fold(String::new(), |mut text, byte| {
        let _ = write!(text, "{byte:02x}");
        text
    })
}

impl Cache {
    /// Returns the user's cache: `machinist` in the system's folder for caches, or the folder named
    /// by `MACHINIST_CACHE`.
    pub fn of_user() -> Self {
        if IS_OFF.load(Ordering::Relaxed) {
            return Self { folder: None };
        }
        let wanted = std::env::var_os("MACHINIST_CACHE").filter(|folder| !folder.is_empty());
        let folder = wanted.map(PathBuf::from);
        Self { folder: folder.or_else(|| Some(dirs::cache_dir()?.join("machinist"))) }
    }

    /// Folder of the cache, if there is one.
    pub fn folder(&self) -> Option<&Path> {
        self.folder.as_deref()
    }

    fn path(&self, key: &Key) -> Option<PathBuf> {
        Some(self.folder.as_ref()?.join(format!("{}.{ENDING}", key.0)))
    }

    /// Reads an entry, if it exists and is complete.
    pub(super) fn get(&self, key: &Key) -> Option<Derived> {
        let path = self.path(key)?;
        let bytes = fs::read(&path).ok()?;
        let derived = open::<Derived>(MARK, &bytes).ok().filter(Derived::is_valid)?;
        // Marks the entry as recently used.
        let _ = File::options()
            .append(true)
            .open(&path)
            .and_then(|f| f.set_modified(SystemTime::now()));
        Some(derived)
    }

    /// Writes an entry, and deletes others if there is no room.
    pub(super) fn put(&self, key: &Key, derived: &Derived) {
        let (Some(folder), Some(path)) = (&self.folder, self.path(key)) else { return };
        if let Err(error) = write(folder, &path, &seal(MARK, derived)) {
            eprintln!("machinist: {}: not cached: {error}", path.display());
        }
        self.keep_within(MOST_BYTES);
    }

    /// Returns the entries with their sizes, the least recently used first.
    fn entries(&self) -> Vec<(SystemTime, u64, PathBuf)> {
        let Some(folder) = &self.folder else { return Vec::new() };
        let Ok(files) = fs::read_dir(folder) else { return Vec::new() };
        let mut entries: Vec<_> = files
            .flatten()
            .filter(|file| file.path().extension().is_some_and(|ending| ending == ENDING))
            .filter_map(|file| {
                let data = file.metadata().ok().filter(fs::Metadata::is_file)?;
                Some((data.modified().ok()?, data.len(), file.path()))
            })
            .collect();
        entries.sort();
        entries
    }

    /// Returns the size of the cache.
    pub fn size(&self) -> Size {
        let entries = self.entries();
        Size { entries: entries.len(), bytes: entries.iter().map(|(_, bytes, _)| bytes).sum() }
    }

    /// Deletes the least recently used entries until the rest has at most `most` bytes. Returns the
    /// size of what was deleted. Another process may delete entries too.
    pub fn keep_within(&self, most: u64) -> Size {
        let mut gone = Size::default();
        let entries = self.entries();
        let mut left: u64 = entries.iter().map(|(_, bytes, _)| bytes).sum();
        for (_, bytes, path) in entries {
            if left <= most {
                break;
            }
            if fs::remove_file(path).is_ok() {
                gone = Size { entries: gone.entries + 1, bytes: gone.bytes + bytes };
            }
            left -= bytes;
        }
        gone
    }
}

fn write(folder: &Path, path: &Path, bytes: &[u8]) -> io::Result<()> {
    fs::create_dir_all(folder)?;
    let mut file = tempfile::Builder::new().prefix(".").tempfile_in(folder)?;
    file.write_all(bytes)?;
    file.persist(path).map_err(|error| error.error)?;
    Ok(())
}

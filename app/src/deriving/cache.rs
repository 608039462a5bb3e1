//! What was derived before, by the content of its spec.
//!
//! An entry's name is the hash of all that decides what is derived: the files of the spec,
//! the generator's own text, what was asked for. So no entry is ever wrong, only unused;
//! the least recently used ones go when there are too many. Entries are written beside
//! their place and then take their name, so that processes at once see whole ones or none.
//! What cannot be read is derived again; what cannot be written is not remembered.

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

/// The first bytes of an entry.
const MARK: &[u8; 16] = b"machinist cache\n";
/// How entries' names end.
const ENDING: &str = "derived";
/// Bytes that all entries together may have.
const MOST_BYTES: u64 = 256 << 20;

static IS_OFF: AtomicBool = AtomicBool::new(false);

/// A folder of entries.
#[derive(Debug, Clone)]
pub struct Cache {
    folder: Option<PathBuf>,
}

/// The name of an entry.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Key(String);

/// What is in a cache.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Size {
    /// Number of entries.
    pub entries: usize,
    /// Their bytes.
    pub bytes: u64,
}

/// Has this process neither read nor write the cache.
pub fn turn_off() {
    IS_OFF.store(true, Ordering::Relaxed);
}

/// The key of a request for a spec of these files, derived by an algebra.
pub(super) fn key(request: &Request, algebra: Algebra, files: &[SourceFile]) -> Key {
    let mut hasher = Sha256::new();
    let mut add = |part: &str| {
        hasher.update((part.len() as u64).to_le_bytes());
        hasher.update(part.as_bytes());
    };
    add(&VERSION.to_string());
    add(GENERATOR);
    let Request { wanted, keep, rigid, dropped, .. } = request;
    add(&format!("{wanted:?} {keep:?} {rigid:?} {} {dropped:?}", algebra.name()));
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
    /// The user's: `machinist` in the folder that the system has for caches, or where
    /// `MACHINIST_CACHE` says.
    pub fn of_user() -> Self {
        if IS_OFF.load(Ordering::Relaxed) {
            return Self { folder: None };
        }
        let wanted = std::env::var_os("MACHINIST_CACHE").filter(|folder| !folder.is_empty());
        let folder = wanted.map(PathBuf::from);
        Self { folder: folder.or_else(|| Some(dirs::cache_dir()?.join("machinist"))) }
    }

    /// Its folder, if there is one.
    pub fn folder(&self) -> Option<&Path> {
        self.folder.as_deref()
    }

    fn path(&self, key: &Key) -> Option<PathBuf> {
        Some(self.folder.as_ref()?.join(format!("{}.{ENDING}", key.0)))
    }

    /// An entry, if it is there and whole.
    pub(super) fn get(&self, key: &Key) -> Option<Derived> {
        let path = self.path(key)?;
        let bytes = fs::read(&path).ok()?;
        let derived = open::<Derived>(MARK, &bytes).ok().filter(Derived::is_valid)?;
        // So that it is not among the least recently used.
        let _ = File::options()
            .append(true)
            .open(&path)
            .and_then(|f| f.set_modified(SystemTime::now()));
        Some(derived)
    }

    /// Writes an entry, and makes room for it.
    pub(super) fn put(&self, key: &Key, derived: &Derived) {
        let (Some(folder), Some(path)) = (&self.folder, self.path(key)) else { return };
        if let Err(error) = write(folder, &path, &seal(MARK, derived)) {
            eprintln!("machinist: {}: not remembered: {error}", path.display());
        }
        self.keep_within(MOST_BYTES);
    }

    /// Entries with their sizes, the least recently used first.
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

    /// What is in it.
    pub fn size(&self) -> Size {
        let entries = self.entries();
        Size { entries: entries.len(), bytes: entries.iter().map(|(_, bytes, _)| bytes).sum() }
    }

    /// Deletes the least recently used entries until the rest has at most so many bytes.
    /// Another process may delete them too.
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

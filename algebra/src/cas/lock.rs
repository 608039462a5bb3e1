//! One process of the machine at a time: an advisory file lock, with word of who holds it.

use std::fs::{File, OpenOptions, TryLockError};
use std::io::{Read as _, Seek as _, SeekFrom, Write as _};
use std::path::{Path, PathBuf};
use std::sync::OnceLock;

use super::CasError;

/// Bytes that the holder's word of itself may have.
const MOST: u64 = 200;

/// Takes the lock, waiting with a message if another process holds it, and keeps
/// it until this process ends; the system releases it then, also after a crash.
pub(super) fn hold_for_this_process(purpose: &str) -> Result<(), CasError> {
    static HELD: OnceLock<File> = OnceLock::new();
    if HELD.get().is_some() {
        return Ok(());
    }
    let path = lock_path();
    let failed = |source| CasError::Lock { path: path.clone(), source };
    let mut file = open(&path).map_err(failed)?;
    match file.try_lock() {
        Ok(()) => {}
        Err(TryLockError::WouldBlock) => {
            eprintln!("machinist: waiting for {}", holder(&mut file));
            file.lock().map_err(failed)?;
        }
        Err(TryLockError::Error(error)) => return Err(failed(error)),
    }
    // Only a courtesy to who waits; another user's file may not be written to.
    let _ = tell(&mut file, purpose);
    let _ = HELD.set(file);
    Ok(())
}

/// The ban is the machine's, so all users share the file, and none owns it: who may not
/// write to it locks it all the same.
fn open(path: &Path) -> std::io::Result<File> {
    if let Some(folder) = path.parent() {
        std::fs::create_dir_all(folder)?;
    }
    let mut options = OpenOptions::new();
    options.read(true).write(true).create(true).truncate(false);
    #[cfg(unix)]
    {
        use std::os::unix::fs::OpenOptionsExt as _;
        // A link that somebody left there would have us write to another file.
        options.mode(0o666).custom_flags(libc::O_NOFOLLOW);
    }
    options.open(path).or_else(|_| File::open(path))
}

/// Who holds the lock, by its own word.
fn holder(file: &mut File) -> String {
    let mut text = String::new();
    let read = file.take(MOST).read_to_string(&mut text);
    let line = text.lines().next().unwrap_or_default();
    match read {
        Ok(_) if !line.is_empty() => line.chars().filter(|c| !c.is_control()).collect(),
        _ => "another process that derives with Symbolica".to_owned(),
    }
}

fn tell(file: &mut File, purpose: &str) -> std::io::Result<()> {
    let text: String = format!("process {}, which derives {purpose}", std::process::id());
    let text: String = text.chars().take(MOST as usize / 4).collect();
    file.set_len(0)?;
    file.seek(SeekFrom::Start(0))?;
    writeln!(file, "{text}")
}

/// The same file for all users of a machine.
fn lock_path() -> PathBuf {
    let folder = if cfg!(unix) { PathBuf::from("/tmp") } else { std::env::temp_dir() };
    folder.join("machinist-symbolica.lock")
}

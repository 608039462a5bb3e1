//! One process at a time: an advisory file lock of the user.

use std::fs::{File, OpenOptions, TryLockError};
use std::path::PathBuf;
use std::sync::OnceLock;

use super::CasError;

/// Takes the lock, waiting with a message if another process holds it, and keeps
/// it until this process ends; the system releases it then, also after a crash.
pub(super) fn hold_for_this_process() -> Result<(), CasError> {
    static HELD: OnceLock<File> = OnceLock::new();
    if HELD.get().is_some() {
        return Ok(());
    }
    let path = lock_path();
    let failed = |source| CasError::Lock { path: path.clone(), source };
    if let Some(folder) = path.parent() {
        std::fs::create_dir_all(folder).map_err(failed)?;
    }
    let file =
        OpenOptions::new().create(true).truncate(false).write(true).open(&path).map_err(failed)?;
    match file.try_lock() {
        Ok(()) => {}
        Err(TryLockError::WouldBlock) => {
            eprintln!("machinist: waiting for another process that derives with Symbolica");
            file.lock().map_err(failed)?;
        }
        Err(TryLockError::Error(error)) => return Err(failed(error)),
    }
    let _ = HELD.set(file);
    Ok(())
}

/// `~/.cache/machinist/symbolica.lock`, or in the system's temporary folder for
/// a user without a home.
fn lock_path() -> PathBuf {
    let folder = match std::env::home_dir() {
        Some(home) if !home.as_os_str().is_empty() => home.join(".cache"),
        _ => std::env::temp_dir(),
    };
    folder.join("machinist").join("symbolica.lock")
}

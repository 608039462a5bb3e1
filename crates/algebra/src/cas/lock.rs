//! An advisory file lock for one process of the machine at a time, with a note by its holder.

use std::fs::{File, OpenOptions, TryLockError};
use std::io::{ErrorKind, Read as _, Seek as _, SeekFrom, Write as _};
use std::net::{Ipv4Addr, TcpListener};
use std::path::{Path, PathBuf};
use std::sync::OnceLock;
use std::time::{Duration, Instant};

use super::CasError;

/// Maximum length of the holder's note in bytes.
const MOST: u64 = 200;

/// Port by which Symbolica detects another process that uses it, unless the environment names
/// another port.
const PORT: u16 = 12011;
/// Longest wait for that port. A process that ends releases it immediately.
const PATIENCE: Duration = Duration::from_secs(10);
/// Time between two attempts.
const PAUSE: Duration = Duration::from_millis(5);

/// Takes the lock and keeps it until this process ends. Waits with a message if another process
/// holds it. The system releases it when the process ends, also after a crash.
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
            eprintln!(
                "machinist: waiting for {}; `--algebra plain` derives without Symbolica, and waits \
                 for nobody",
                holder(&mut file)
            );
            file.lock().map_err(failed)?;
        }
        Err(TryLockError::Error(error)) => return Err(failed(error)),
    }
    wait_until_free(port(), PATIENCE)?;
    // The note only informs waiting processes. A file of another user may not be writable.
    let _ = tell(&mut file, purpose);
    let _ = HELD.set(file);
    Ok(())
}

/// Returns the port that Symbolica will take; `None` if a license key lets it run beside others.
fn port() -> Option<u16> {
    if std::env::var_os("SYMBOLICA_LICENSE").is_some() {
        return None;
    }
    let named = std::env::var("SYMBOLICA_PORT").ok();
    Some(named.and_then(|port| port.parse().ok()).unwrap_or(PORT))
}

/// Waits until Symbolica's port is free. Symbolica aborts its process if the port is taken. A
/// process that ends may release the lock before the port, because the order in which the system
/// closes files is not specified.
fn wait_until_free(port: Option<u16>, patience: Duration) -> Result<(), CasError> {
    let Some(port) = port else { return Ok(()) };
    let start = Instant::now();
    loop {
        match TcpListener::bind((Ipv4Addr::LOCALHOST, port)) {
            Err(error) if error.kind() == ErrorKind::AddrInUse => {}
            // Symbolica reports other errors itself.
            _ => return Ok(()),
        }
        if start.elapsed() >= patience {
            return Err(CasError::InUse { port });
        }
        std::thread::sleep(PAUSE);
    }
}

/// Opens the lock file. The restriction applies to the whole machine, so all users share the file.
/// A user without permission to write to it can lock it nevertheless.
fn open(path: &Path) -> std::io::Result<File> {
    if let Some(folder) = path.parent() {
        std::fs::create_dir_all(folder)?;
    }
    let mut options = OpenOptions::new();
    options.read(true).write(true).create(true).truncate(false);
    #[cfg(unix)]
    {
        use std::os::unix::fs::OpenOptionsExt as _;
        // A symbolic link at this path would redirect our writes to another file.
        options.mode(0o666).custom_flags(libc::O_NOFOLLOW);
    }
    options.open(path).or_else(|_| File::open(path))
}

/// Returns the note of the lock's holder.
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

/// Returns the path, which is the same for all users of a machine.
fn lock_path() -> PathBuf {
    let folder = if cfg!(unix) { PathBuf::from("/tmp") } else { std::env::temp_dir() };
    folder.join("machinist-symbolica.lock")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn symbolica_starts_only_when_its_former_user_has_given_the_port_back() {
        let taken = TcpListener::bind((Ipv4Addr::LOCALHOST, 0)).expect("a port");
        let port = taken.local_addr().expect("an address").port();
        let refused = wait_until_free(Some(port), Duration::from_millis(20));
        assert!(matches!(refused, Err(CasError::InUse { port: named }) if named == port));

        let (start, held) = (Instant::now(), Duration::from_millis(200));
        let holder = std::thread::spawn(move || {
            std::thread::sleep(held);
            drop(taken);
        });
        wait_until_free(Some(port), PATIENCE).expect("it is given back");
        assert!(start.elapsed() >= held);
        holder.join().expect("it ends");
        wait_until_free(None, Duration::ZERO).expect("whoever has a key waits for nobody");
    }
}

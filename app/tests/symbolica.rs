//! Symbolica's lock, held by a test.

use std::fs::File;
use std::path::PathBuf;
use std::process::{Command, Output, Stdio};
use std::time::{Duration, Instant};

/// Lock of processes that derive by Symbolica.
pub struct Lock {
    _file: File,
}

impl Lock {
    /// Waits for the lock.
    pub fn held() -> Self {
        let folder = if cfg!(unix) { PathBuf::from("/tmp") } else { std::env::temp_dir() };
        let path = folder.join("machinist-symbolica.lock");
        let mut options = File::options();
        options.read(true).write(true).create(true).truncate(false);
        // A lock file of another user can only be read.
        let file = options.open(&path).or_else(|_| File::open(&path)).expect("a lock file");
        file.lock().expect("the lock");
        Self { _file: file }
    }
}

/// Returns the output of a command, which must end within a minute whatever is locked.
pub fn assert_ends(mut command: Command) -> Output {
    let what = format!("{:?}", command.get_args());
    let child = command.stdin(Stdio::null()).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn();
    let child = child.expect("the program starts");
    let (process, start) = (child.id(), Instant::now());
    let end = std::thread::spawn(move || child.wait_with_output().expect("it ends"));
    while !end.is_finished() {
        if start.elapsed() > Duration::from_secs(60) {
            let _ = Command::new("kill").arg(process.to_string()).status();
            panic!("{what} does not end");
        }
        std::thread::sleep(Duration::from_millis(10));
    }
    end.join().expect("its words are read")
}

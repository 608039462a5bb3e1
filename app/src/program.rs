//! Command that starts this program again, for work in a process of its own.

use std::ffi::OsString;
use std::io;
use std::process::Command;
use std::sync::OnceLock;

/// Program and first arguments, if it is not the executable of this process.
static AGAIN: OnceLock<(OsString, Vec<OsString>)> = OnceLock::new();

/// Sets the command for a program that runs within another executable. Only the first call has an
/// effect.
pub fn is_started_by(executable: OsString, arguments: Vec<OsString>) {
    let _ = AGAIN.set((executable, arguments));
}

/// Returns the command that starts this program again, without the arguments of its work.
///
/// # Errors
/// If the system does not name the executable of this process.
pub fn again() -> io::Result<Command> {
    let Some((executable, arguments)) = AGAIN.get() else {
        return std::env::current_exe().map(Command::new);
    };
    let mut command = Command::new(executable);
    command.args(arguments);
    Ok(command)
}

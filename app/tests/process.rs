//! The program as a process: calls and their output.

use std::path::Path;
use std::process::{Command, Output};

/// Folder of the repository.
pub const REPOSITORY: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/..");

/// Prepares a call of the program in a folder, without colours.
pub fn machinist(folder: impl AsRef<Path>, arguments: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_machinist"));
    command
        .args(arguments)
        .current_dir(folder)
        .env("MACHINIST_CACHE", concat!(env!("CARGO_TARGET_TMPDIR"), "/cache"))
        .env("NO_COLOR", "1")
        .env("XDG_CONFIG_HOME", concat!(env!("CARGO_TARGET_TMPDIR"), "/config"));
    for key in machinist_app::CONFIGURATION_KEYS {
        command.env_remove(format!("MACHINIST_{}", key.to_uppercase()));
    }
    command.env_remove("COLUMNS");
    command
}

/// Runs a command to its end and returns its output.
pub fn output(mut command: Command) -> Output {
    command.output().expect("the program starts")
}

/// Returns standard error as one line, because it may be wrapped anywhere.
pub fn said(output: &Output) -> String {
    let text = String::from_utf8_lossy(&output.stderr).replace('│', " ");
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

/// Returns standard output of a run that must succeed.
pub fn answer(command: Command) -> String {
    let what = format!("{:?}", command.get_args());
    let output = output(command);
    assert_eq!(output.status.code(), Some(0), "{what}: {}", said(&output));
    String::from_utf8(output.stdout).expect("text")
}

/// Asserts bad input: exit code 2, nothing on standard output, and these words on standard error.
pub fn assert_refused(command: Command, words: &[&str]) {
    let what = format!("{:?}", command.get_args());
    let output = output(command);
    let said = said(&output);
    assert_eq!(output.status.code(), Some(2), "{what}: {said}");
    assert!(output.stdout.is_empty(), "{what} printed an answer");
    for word in words {
        assert!(said.contains(word), "{what} does not say `{word}`: {said}");
    }
}

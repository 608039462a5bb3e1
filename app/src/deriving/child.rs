//! Child process that derives by Symbolica: this program once more, which ends after its answer.
//!
//! It reads requests from standard input and writes answers to standard output. Errors in a spec go
//! to standard error, which it shares with its parent. The parent leaves standard input open until
//! it has the answers. If standard input ends earlier, the parent has ended, and the child ends
//! too, so that it does not keep the lock of the algebra.

use std::io::{ErrorKind, Read as _, Write as _, stdin, stdout};
use std::process::Stdio;
use std::sync::atomic::{AtomicBool, Ordering};

use machinist_algebra::cas::{Algebra, GREETED};
use machinist_model::file::{open, seal};

use super::{Derived, Request, broken};
use crate::failure::{Failure, all};
use crate::program;

/// Command that starts the child.
pub const COMMAND: &str = "derive-for-parent";

const QUESTION: &[u8; 16] = b"machinist asks:\n";
const ANSWER: &[u8; 16] = b"machinist says:\n";

/// True if a child of this process has printed the terms of its algebra.
static GREETED_ONCE: AtomicBool = AtomicBool::new(false);

/// Derives requests in a child, each by its algebra.
pub(super) fn ask(requests: &[(&Request, Algebra)]) -> Result<Vec<Derived>, Failure> {
    let failed = |error: &std::io::Error| {
        Failure::unsuccessful(format!("cannot start the derivation process: {error}"), "")
    };
    let mut command = program::again().map_err(|error| failed(&error))?;
    command.arg(COMMAND).stdin(Stdio::piped()).stdout(Stdio::piped());
    if GREETED_ONCE.swap(true, Ordering::Relaxed) {
        command.env(GREETED, "1");
    }
    let mut child = command.spawn().map_err(|error| failed(&error))?;
    // Open until the child has answered; closed by the system if this process ends earlier.
    let mut input = child.stdin.take();
    if let Some(input) = &mut input {
        let question = seal(QUESTION, &requests);
        // If the child does not read, it has ended, and its exit code is reported.
        let _ = input
            .write_all(&(question.len() as u64).to_le_bytes())
            .and_then(|()| input.write_all(&question))
            .and_then(|()| input.flush());
    }
    let output = child.wait_with_output().map_err(|error| failed(&error))?;
    drop(input);
    match output.status.code() {
        Some(0) => {}
        // The child has printed the errors.
        Some(2) => return Err(Failure::Input(Vec::new())),
        _ => return Err(broken(&format!("{} before it answered", output.status))),
    }
    let answers: Vec<Derived> =
        open(ANSWER, &output.stdout).map_err(|error| broken(&error.to_string()))?;
    if answers.len() == requests.len() {
        Ok(answers)
    } else {
        Err(broken(&format!("{} answers to {} requests", answers.len(), requests.len())))
    }
}

/// Answers the requests of the parent.
pub fn answer_parent() -> Result<(), Failure> {
    let failed = |error: std::io::Error| Failure::unsuccessful(error, "");
    let question = question().map_err(failed)?;
    end_with_parent();
    let requests: Vec<(Request, Algebra)> = open(QUESTION, &question)
        .map_err(|error| Failure::input(error, "this command is internal to the program"))?;
    let answers =
        all(&requests, |(request, algebra)| request.derived_of(request.system()?, *algebra))?;
    let mut out = stdout().lock();
    out.write_all(&seal(ANSWER, &answers)).and_then(|()| out.flush()).map_err(failed)
}

/// Reads the parent's question: its length in eight bytes, then the content. It is shorter if the
/// parent ends early.
fn question() -> std::io::Result<Vec<u8>> {
    let mut input = stdin().lock();
    let mut length = [0; 8];
    let mut bytes = Vec::new();
    match input.read_exact(&mut length) {
        Ok(()) => {
            input.take(u64::from_le_bytes(length)).read_to_end(&mut bytes)?;
        }
        Err(error) if error.kind() == ErrorKind::UnexpectedEof => {}
        Err(error) => return Err(error),
    }
    Ok(bytes)
}

/// Ends this process as soon as its parent has ended. The parent holds standard input open, and the
/// system closes it even for a process that was killed.
pub fn end_with_parent() {
    std::thread::spawn(|| {
        let mut byte = [0];
        while stdin().read(&mut byte).is_ok_and(|count| count > 0) {}
        std::process::exit(1);
    });
}

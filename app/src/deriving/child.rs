//! The process that derives: this program once more, which ends when it has answered.
//!
//! It reads its requests from standard input and writes its answers to standard output;
//! what is wrong with a spec it says on standard error, which it shares with its parent.

use std::io::{Read as _, Write as _, stdin, stdout};
use std::process::{Command, Stdio};
use std::sync::atomic::{AtomicBool, Ordering};

use machinist_algebra::cas::{Algebra, GREETED};
use machinist_codegen::pipeline;
use machinist_codegen::spec::diagnostic::Diagnostics;
use machinist_model::file::{open, seal};

use super::{Derived, Request, Wanted};
use crate::failure::{Failure, all};

/// The command that the child is called with.
pub const COMMAND: &str = "derive-for-parent";

const QUESTION: &[u8; 16] = b"machinist asks:\n";
const ANSWER: &[u8; 16] = b"machinist says:\n";

/// Whether a child of this process has said on whose terms it derives.
static GREETED_ONCE: AtomicBool = AtomicBool::new(false);

/// Has a child derive what is asked for.
pub(super) fn ask(requests: &[&Request]) -> Result<Vec<Derived>, Failure> {
    let failed = |error: &std::io::Error| {
        Failure::unsuccessful(format!("cannot start a process that derives: {error}"), "")
    };
    let program = std::env::current_exe().map_err(|error| failed(&error))?;
    let mut command = Command::new(program);
    command.arg(COMMAND).stdin(Stdio::piped()).stdout(Stdio::piped());
    if GREETED_ONCE.swap(true, Ordering::Relaxed) {
        command.env(GREETED, "1");
    }
    let mut child = command.spawn().map_err(|error| failed(&error))?;
    if let Some(mut input) = child.stdin.take() {
        // A child that does not listen has ended, and its exit code says so.
        let _ = input.write_all(&seal(QUESTION, &requests));
    }
    let output = child.wait_with_output().map_err(|error| failed(&error))?;
    match output.status.code() {
        Some(0) => {}
        // It has said what is wrong.
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

/// The child did not do what it is there for.
pub(super) fn broken(how: &str) -> Failure {
    let help = "what it said is above; `machinist check` finds what is wrong with a spec";
    Failure::unsuccessful(format!("the process that derives ended badly: {how}"), help)
}

/// What the child does.
pub fn answer_parent() -> Result<(), Failure> {
    let mut bytes = Vec::new();
    let failed = |error: std::io::Error| Failure::unsuccessful(error, "");
    stdin().read_to_end(&mut bytes).map_err(failed)?;
    let requests: Vec<Request> = open(QUESTION, &bytes)
        .map_err(|error| Failure::input(error, "this command is for the program's own use"))?;
    let answers = all(&requests, derive)?;
    let mut out = stdout().lock();
    out.write_all(&seal(ANSWER, &answers)).and_then(|()| out.flush()).map_err(failed)
}

fn derive(request: &Request) -> Result<Derived, Diagnostics> {
    let system = request.system()?;
    let algebra = request.algebra.unwrap_or_else(|| Algebra::of(system.coordinates.len()));
    Ok(match request.wanted {
        Wanted::Model => {
            let model = pipeline::compile_by(algebra, system, request.keep)?;
            Derived::Model(Box::new(pipeline::stamped(model, request.keep)))
        }
        Wanted::ModelIfPossible => match pipeline::compile_by(algebra, system, request.keep) {
            Ok(model) => Derived::Model(Box::new(pipeline::stamped(model, request.keep))),
            Err(_) => Derived::Impossible,
        },
        Wanted::Everything => {
            Derived::Everything(Box::new(pipeline::derivation_by(algebra, system, request.keep)?))
        }
    })
}

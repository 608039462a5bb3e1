//! Worker process of `machinist watch`, which checks, derives and runs a machine: this program once
//! more.
//!
//! It is killed whenever the files are saved again. Its memory is freed with it, so the process
//! that serves the page stays small. It writes each answer to standard output on a line of its own.

use std::io::{BufRead as _, BufReader, Read as _, Write as _, stdout};
use std::path::{Path, PathBuf};
use std::process::{Child, ChildStderr, ChildStdout, Stdio};
use std::sync::mpsc::Sender;
use std::thread;
use std::time::Duration;

use clap::Args;
use machinist_algebra::cas::Algebra;
use machinist_codegen::mechanics::reduce::Keep;
use machinist_codegen::pipeline::{derivation_by, outline_by};
use machinist_codegen::scene::compose;
use machinist_codegen::scene::system::LagrangianSystem;
use serde::{Deserialize, Serialize};

use super::Message;
use crate::cli::arguments::TimeArgs;
use crate::cli::check::{counted, found};
use crate::deriving::{Remark, derive_by, end_with_parent, notes, to_drop};
use crate::failure::{Failure, Trouble};
use crate::freeze::admit;
use crate::program;
use crate::report::{Content, Ran};
use crate::spec_source::SpecSource;

/// Command that starts the process.
pub const COMMAND: &str = "run-for-watch";

/// Maximum number of bytes of standard error that are shown if the process fails.
const MOST_SAID: u64 = 4000;

/// Arguments of the process.
#[derive(Debug, Args)]
pub struct Ask {
    /// The scene file
    scene: PathBuf,
    #[command(flatten)]
    time: TimeArgs,
}

/// Result of checking, deriving and running a spec.
#[derive(Debug, Clone, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Answer {
    /// Files of the spec, each with the SHA-256 of its content; `None` if they are not all known.
    pub files: Option<Vec<(PathBuf, String)>>,
    /// Page of the machine if it ran, even if the run stopped early.
    pub page: Option<Content>,
    /// Summary of the spec in a line.
    pub found: String,
    /// Errors, or only warnings.
    pub troubles: Vec<Trouble>,
    /// True if no further answer follows.
    pub is_last: bool,
}

impl Ask {
    /// Answers on standard output: once after the run, and again once everything else is known.
    pub fn execute(&self) -> Result<(), Failure> {
        end_with_parent();
        derive_by(Algebra::Plain);
        let source = SpecSource::File(self.scene.clone());
        let mut answer = Answer::default();
        match ran(&source, self.time.limit_or_default(), &mut answer) {
            Ok((mut ran, system)) => {
                answer.page = Some(ran.content());
                if let Some(why) = ran.stopped() {
                    answer.troubles.extend(Failure::unsuccessful(why, "").troubles());
                } else {
                    tell(&answer)?;
                    let all = complete(&mut ran, &system, &mut answer);
                    // The machine ran all the same.
                    let failed = all.err().map(|failure| failure.troubles()).unwrap_or_default();
                    answer.troubles.extend(failed.into_iter().map(Trouble::into_warning));
                    answer.page = Some(ran.content());
                }
            }
            Err(failure) => answer.troubles.extend(failure.troubles()),
        }
        answer.is_last = true;
        tell(&answer)
    }
}

/// Checks, derives and runs the machine, and fills the answer along the way.
fn ran(
    source: &SpecSource,
    time_limit: Duration,
    answer: &mut Answer,
) -> Result<(Ran, LagrangianSystem), Failure> {
    let spec = source.read()?;
    let mut system = compose(&spec)?;
    // Units that come with Machinist have no path.
    let files = system.files.iter().filter(|file| !file.path.as_os_str().is_empty());
    answer.files = Some(files.map(|file| (file.path.clone(), file.sha256.clone())).collect());
    answer.troubles = system.warnings.iter().map(Trouble::from).collect();
    answer.troubles.extend(notes(&system).map(|note| Trouble::from(&note)));
    answer.found = counted(&system);
    let mut outline = outline_by(Algebra::Plain, system.clone(), Keep::Needed)?;
    let remark = &mut |remark: Remark| answer.troubles.push(Trouble::from(&remark));
    let dropped = to_drop(&outline.model, remark);
    if !dropped.is_empty() {
        for (constraint, needs) in &dropped {
            system.drop_constraint(constraint, needs);
        }
        outline = outline_by(Algebra::Plain, system.clone(), Keep::Needed)?;
    }
    admit(source, &outline.model)?;
    Ok((Ran::new(outline, source, &spec, time_limit)?, system))
}

/// Completes the page with the parts that take longer.
fn complete(ran: &mut Ran, system: &LagrangianSystem, answer: &mut Answer) -> Result<(), Failure> {
    let stages = derivation_by(Algebra::Plain, system.clone(), Keep::Needed)?.stages;
    answer.found = found(system, || Ok(stages.whole.clone()))?;
    ran.complete(stages)
}

fn tell(answer: &Answer) -> Result<(), Failure> {
    let line = serde_json::to_string(answer).map_err(|error| Failure::unsuccessful(error, ""))?;
    let mut out = stdout().lock();
    let written = writeln!(out, "{line}").and_then(|()| out.flush());
    written.map_err(|error| Failure::unsuccessful(error, ""))
}

/// Running process, which is killed when this is dropped.
pub struct Worker {
    child: Child,
}

impl Worker {
    /// Starts a process. Its answers are sent with `number`, followed by a message when it ends.
    pub fn start(
        scene: &Path,
        time_limit: Duration,
        number: u64,
        inbox: &Sender<Message>,
    ) -> Result<Self, Failure> {
        let failed = |error: std::io::Error| {
            Failure::unsuccessful(format!("cannot start the derivation process: {error}"), "")
        };
        let mut child = program::again()
            .map_err(failed)?
            .arg(COMMAND)
            .arg(format!("--time-limit={}", time_limit.as_secs_f64()))
            .arg("--")
            .arg(scene)
            // Left open: closing it tells the process that nobody waits for it any more.
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .map_err(failed)?;
        let (out, says) = (child.stdout.take(), child.stderr.take());
        let inbox = inbox.clone();
        thread::spawn(move || {
            let said = thread::spawn(move || said(says));
            listen(out, number, &inbox);
            let said = said.join().unwrap_or_default();
            // Nobody listens once the program ends.
            let _ = inbox.send(Message::Ended { number, said });
        });
        Ok(Self { child })
    }
}

impl Drop for Worker {
    fn drop(&mut self) {
        // The process may have ended by itself.
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

fn listen(out: Option<ChildStdout>, number: u64, inbox: &Sender<Message>) {
    let lines = out.into_iter().flat_map(|out| BufReader::new(out).lines());
    for line in lines.map_while(Result::ok) {
        let Ok(answer) = serde_json::from_str::<Answer>(&line) else { return };
        if inbox.send(Message::Answer { number, answer: Box::new(answer) }).is_err() {
            return;
        }
    }
}

/// Returns the end of standard error, which is long if many threads panic.
fn said(says: Option<ChildStderr>) -> String {
    let mut bytes = Vec::new();
    if let Some(mut says) = says {
        let _ = says.by_ref().take(MOST_SAID).read_to_end(&mut bytes);
        // The rest is drained so that the process does not block.
        let _ = std::io::copy(&mut says, &mut std::io::sink());
    }
    String::from_utf8_lossy(&bytes).into_owned()
}

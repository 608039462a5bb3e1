//! Page that shows a machine while its spec is written: `machinist watch`.
//!
//! One thread waits for changes of the files and starts a process that checks, derives and runs
//! them ([`worker`]). Other threads serve the result ([`server`], [`site`]). A process that is
//! still at work when the files change again is killed.

mod files;
mod server;
mod site;
pub mod worker;

use std::path::Path;
use std::sync::Arc;
use std::sync::mpsc::{Receiver, RecvTimeoutError, channel};
use std::time::{Duration, Instant};

use files::Files;
use site::Site;
use worker::{Answer, Worker};

use crate::cli::output::print;
use crate::failure::Failure;
use crate::interrupt;

/// Quiet time before files are read, because editors save in several steps.
const QUIET: Duration = Duration::from_millis(15);
/// Maximum delay before files are read, if changes go on.
const LONGEST: Duration = Duration::from_millis(100);
/// Interval at which files are compared even without notifications.
const LOOK: Duration = Duration::from_secs(1);

/// Messages to the main thread.
pub enum Message {
    /// Files may have changed.
    Changed,
    /// A process answers.
    Answer {
        /// Number of the process.
        number: u64,
        /// Its answer.
        answer: Box<Answer>,
    },
    /// A process has ended.
    Ended {
        /// Number of the process.
        number: u64,
        /// Standard error of the process.
        said: String,
    },
}

/// Process at work and its progress.
struct Turn {
    number: u64,
    begun: Instant,
    is_done: bool,
    /// Time until the first answer.
    took: Option<Duration>,
    /// Dropped when the next one begins, which kills the process if it has not ended.
    _worker: Worker,
}

struct Watch<'a> {
    scene: &'a Path,
    files: Files,
    site: Arc<Site>,
    turn: Option<Turn>,
}

/// Serves the page of a scene file until Ctrl-C.
pub fn watch(scene: &Path, port: Option<u16>, time_limit: Duration) -> Result<(), Failure> {
    interrupt::end_at_once();
    let (outbox, inbox) = channel();
    let files = Files::of(scene, outbox.clone())?;
    let name = scene.file_name().unwrap_or(scene.as_os_str()).to_string_lossy().into_owned();
    let site = Arc::new(Site::new(name));
    let port = server::start(&site, port)?;
    print(&format!("{} is at http://127.0.0.1:{port}/ until Ctrl-C\n", scene.display()))?;
    let mut watch = Watch { scene, files, site, turn: None };
    for number in 1.. {
        // The old process ends first, so there is never more than one.
        watch.turn = None;
        watch.site.begin();
        let worker = Worker::start(scene, time_limit, number, &outbox)?;
        let begun = Instant::now();
        let turn = Turn { number, begun, is_done: false, took: None, _worker: worker };
        watch.turn = Some(turn);
        watch.wait(&inbox);
    }
    Ok(())
}

impl Watch<'_> {
    /// Waits until files have changed, and takes answers meanwhile.
    fn wait(&mut self, inbox: &Receiver<Message>) {
        let mut told = None::<Instant>;
        loop {
            let patience = match told {
                None => LOOK,
                Some(first) => QUIET.min(LONGEST.saturating_sub(first.elapsed())),
            };
            match inbox.recv_timeout(patience) {
                Ok(Message::Changed) => {
                    told.get_or_insert_with(Instant::now);
                }
                Ok(Message::Answer { number, answer }) => {
                    self.take(number, *answer);
                    // The answer may be about files that have changed since.
                    told.get_or_insert_with(Instant::now);
                }
                Ok(Message::Ended { number, said }) => self.ended(number, &said),
                // This thread holds a sender itself, so the channel is never closed.
                Err(RecvTimeoutError::Timeout | RecvTimeoutError::Disconnected) => {
                    if self.files.have_changed() {
                        return;
                    }
                    told = None;
                }
            }
        }
    }

    fn take(&mut self, number: u64, answer: Answer) {
        let Some(turn) = self.turn.as_mut().filter(|turn| turn.number == number) else { return };
        turn.is_done = answer.is_last;
        if turn.took.is_none() {
            tell(self.scene, &answer);
        }
        let took = *turn.took.get_or_insert_with(|| turn.begun.elapsed());
        let wrong: Vec<String> = answer.troubles.iter().map(|one| one.file.clone()).collect();
        self.files.are(answer.files.clone(), wrong.iter().map(String::as_str));
        self.site.take(answer, took);
    }

    /// Reports a process that ended without its last answer.
    fn ended(&mut self, number: u64, said: &str) {
        let Some(turn) = &self.turn else { return };
        if turn.number != number || turn.is_done {
            return;
        }
        let message = "the process that derives and runs ended without an answer";
        let failure = Failure::unsuccessful(message, said.trim());
        self.take(
            number,
            Answer { troubles: failure.troubles(), is_last: true, ..Answer::default() },
        );
    }
}

/// Prints the result on standard error, as `machinist check` does.
fn tell(scene: &Path, answer: &Answer) {
    for trouble in &answer.troubles {
        eprintln!("{}", trouble.text);
    }
    if answer.troubles.iter().all(|trouble| trouble.is_warning) {
        eprintln!("{}: {}", scene.display(), answer.found);
    }
}

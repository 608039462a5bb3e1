//! A page that shows a machine while its spec is written: `machinist watch`.
//!
//! One thread waits for changes of the files and has a process of its own check, derive and run what
//! is in them ([`worker`]); others serve what became of it ([`server`], [`site`]). A process that is
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

/// Files are read once nothing was told of them for so long: editors save in several steps.
const QUIET: Duration = Duration::from_millis(15);
/// But not later than this, however much else changes beside them.
const LONGEST: Duration = Duration::from_millis(100);
/// Files are looked at so often even if nothing is told of them.
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
        /// Its number.
        number: u64,
        /// Its standard error.
        said: String,
    },
}

/// The process at work, and what is known of it.
struct Turn {
    number: u64,
    begun: Instant,
    is_done: bool,
    /// Until it first answered.
    took: Option<Duration>,
    /// Kept until the next one begins: then it is killed, if it has not ended.
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
        // Before the next begins: there is never more than one.
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
    /// Waits until files have changed, and takes what became of them meanwhile.
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
                    // It may be of files that have changed since.
                    told.get_or_insert_with(Instant::now);
                }
                Ok(Message::Ended { number, said }) => self.ended(number, &said),
                // This thread has an end of the channel itself, so that it is never closed.
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

    /// A process that ends before it has said all.
    fn ended(&mut self, number: u64, said: &str) {
        let Some(turn) = &self.turn else { return };
        if turn.number != number || turn.is_done {
            return;
        }
        let message = "the process that derives and runs ended before it had answered";
        let failure = Failure::unsuccessful(message, said.trim());
        self.take(
            number,
            Answer { troubles: failure.troubles(), is_last: true, ..Answer::default() },
        );
    }
}

/// Says on standard error what became of the files, as `machinist check` does.
fn tell(scene: &Path, answer: &Answer) {
    for trouble in &answer.troubles {
        eprintln!("{}", trouble.text);
    }
    if answer.troubles.iter().all(|trouble| trouble.is_warning) {
        eprintln!("{}: {}", scene.display(), answer.found);
    }
}

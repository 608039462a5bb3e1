//! State of the page: the last successful run, and errors in the present files.

use std::sync::{Condvar, Mutex, MutexGuard, PoisonError};
use std::time::{Duration, SystemTime, UNIX_EPOCH};

use serde::Serialize;
use serde_json::{Value, json};

use super::worker::Answer;
use crate::failure::Trouble;
use crate::report::{self, Beside, Content};

/// State of the files.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum State {
    /// The present files are being derived and run.
    Working,
    /// The page shows the present files.
    Ready,
    /// The page shows earlier files, if it shows any.
    Failed,
}

/// Page shared by all threads that serve it.
pub struct Site {
    name: String,
    shown: Mutex<Shown>,
    changed: Condvar,
}

struct Shown {
    version: u64,
    state: State,
    status: String,
    troubles: Vec<Trouble>,
    content: Option<Content>,
    /// True if the content comes from a successful run.
    is_good: bool,
    /// True if all pieces of the content are there.
    is_complete: bool,
}

impl Site {
    /// Creates a site of a machine that has not run yet.
    pub fn new(name: String) -> Self {
        // A page left open from an earlier program sees a different version.
        let since = SystemTime::now().duration_since(UNIX_EPOCH).unwrap_or_default();
        let shown = Shown {
            version: since.as_millis() as u64,
            state: State::Working,
            status: WORKING.to_owned(),
            troubles: Vec::new(),
            content: None,
            is_good: false,
            is_complete: false,
        };
        Self { name, shown: Mutex::new(shown), changed: Condvar::new() }
    }

    fn shown(&self) -> MutexGuard<'_, Shown> {
        self.shown.lock().unwrap_or_else(PoisonError::into_inner)
    }

    fn change(&self, change: impl FnOnce(&mut Shown)) {
        let mut shown = self.shown();
        change(&mut shown);
        shown.version += 1;
        self.changed.notify_all();
    }

    /// Marks the files as changed.
    pub fn begin(&self) {
        self.change(|shown| {
            shown.state = State::Working;
            WORKING.clone_into(&mut shown.status);
        });
    }

    /// Takes the result of the changed files. A failure does not replace the page of a good run.
    pub fn take(&self, answer: Answer, took: Duration) {
        let has_failed = answer.troubles.iter().any(|trouble| !trouble.is_warning);
        self.change(|shown| {
            shown.troubles = answer.troubles;
            shown.state = if has_failed { State::Failed } else { State::Ready };
            let is_kept = has_failed && shown.is_good;
            if let Some(content) = answer.page.filter(|_| !is_kept) {
                shown.content = Some(content);
                shown.is_good = !has_failed;
                shown.is_complete = answer.is_last;
            }
            let took = format!("in {:.2} s", took.as_secs_f64());
            shown.status = match (has_failed, shown.content.is_some()) {
                (false, _) => format!("Run {took}: {}", answer.found),
                (true, true) if shown.is_good => {
                    "The files as they are do not run; below is the last good run.".to_owned()
                }
                (true, true) => "The run stopped; below is as far as it went.".to_owned(),
                (true, false) => "The files as they are do not run.".to_owned(),
            };
        });
    }

    /// Returns the whole page.
    pub fn page(&self) -> String {
        let shown = self.shown();
        let Shown { version, status, troubles, content, .. } = &*shown;
        let beside = Beside { version: *version, status, troubles };
        report::page(&self.name, content.as_ref(), &beside)
    }

    /// Returns the content of the page as JSON for its script.
    pub fn content(&self) -> String {
        let shown = self.shown();
        let content = shown.content.as_ref();
        let title = content.map_or_else(|| self.name.clone(), |content| content.title.clone());
        let whole = json!({
            "version": shown.version,
            "state": shown.state,
            "status": shown.status,
            "troubles": report::troubles(&shown.troubles),
            "title": title,
            "is_complete": shown.is_complete,
            "navigation": content.map(Content::navigation).unwrap_or_default(),
            "pieces": content.map(|content| &content.pieces).into_iter().flatten().collect::<Vec<_>>(),
            "known": content.and_then(|content| content.known.as_ref()),
        });
        whole.to_string()
    }

    /// Returns the state as JSON with its version, once it differs from the given version. `None`
    /// if it stays the same for as long as `patience`.
    pub fn changed_since(&self, version: Option<u64>, patience: Duration) -> Option<(u64, String)> {
        let is_same = |shown: &mut Shown| Some(shown.version) == version;
        let waited = self.changed.wait_timeout_while(self.shown(), patience, is_same);
        let (shown, waited) = waited.unwrap_or_else(PoisonError::into_inner);
        (!waited.timed_out()).then(|| (shown.version, shown.word().to_string()))
    }
}

impl Shown {
    fn word(&self) -> Value {
        let place = |trouble: &Trouble| {
            let Trouble { file, line, column, message, is_warning, .. } = trouble;
            json!({
                "file": file,
                "line": line,
                "column": column,
                "message": message,
                "is_warning": is_warning,
            })
        };
        json!({
            "version": self.version,
            "state": self.state,
            "status": self.status,
            "troubles": self.troubles.iter().map(place).collect::<Vec<_>>(),
        })
    }
}

const WORKING: &str = "Deriving and running the files as they are\u{2026}";

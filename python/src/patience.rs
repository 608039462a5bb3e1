//! Runs that are left on Ctrl-C or after a limit of time.

use std::cell::{Cell, RefCell};
use std::time::{Duration, Instant};

use machinist::error::StopCause;
use pyo3::prelude::*;

/// Signals are looked for so often; Python handles them in its main thread alone.
const PERIOD: Duration = Duration::from_millis(100);
/// The clock is looked at once in so many steps.
const STEPS: u32 = 64;

/// Asked after every step whether a run is to go on.
pub struct Patience {
    steps: Cell<u32>,
    /// When to look for signals.
    next: Cell<Option<Instant>>,
    limit: Option<(Instant, Duration)>,
    signal: RefCell<Option<PyErr>>,
}

impl Patience {
    /// From now on, for so long, or until a signal is raised.
    pub fn new(limit: Option<Duration>) -> Self {
        let patience = Self::without_signals(limit);
        patience.next.set(Some(Instant::now() + PERIOD));
        patience
    }

    /// From now on, for so long, in a thread that Python does not know.
    pub fn without_signals(limit: Option<Duration>) -> Self {
        Self {
            steps: Cell::new(0),
            next: Cell::new(None),
            limit: limit.and_then(|limit| Some((Instant::now().checked_add(limit)?, limit))),
            signal: RefCell::new(None),
        }
    }

    /// Why it has come to an end, if it has.
    pub fn end(&self) -> Option<StopCause> {
        let steps = self.steps.get().wrapping_add(1);
        self.steps.set(steps);
        if !steps.is_multiple_of(STEPS) {
            return None;
        }
        let now = Instant::now();
        if self.next.get().is_some_and(|next| next <= now) {
            self.next.set(Some(now + PERIOD));
            let signals = Python::attach(|py: Python<'_>| -> PyResult<()> { py.check_signals() });
            if let Err(signal) = signals {
                self.signal.replace(Some(signal));
                return Some(StopCause::Interrupted);
            }
        }
        let (deadline, limit) = self.limit?;
        (deadline <= now).then_some(StopCause::TooSlow { seconds: limit.as_secs_f64() })
    }

    /// What a handler of a signal raised, such as `KeyboardInterrupt`.
    ///
    /// # Errors
    /// That.
    pub fn require_quiet(&self) -> PyResult<()> {
        self.signal.take().map_or(Ok(()), Err)
    }
}

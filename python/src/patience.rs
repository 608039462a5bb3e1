//! Runs that are left on Ctrl-C.

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
    next: Cell<Instant>,
    signal: RefCell<Option<PyErr>>,
}

impl Patience {
    /// From now on, until a signal is raised.
    pub fn new() -> Self {
        Self {
            steps: Cell::new(0),
            next: Cell::new(Instant::now() + PERIOD),
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
        if now < self.next.get() {
            return None;
        }
        self.next.set(now + PERIOD);
        let signals = Python::attach(|py: Python<'_>| -> PyResult<()> { py.check_signals() });
        self.signal.replace(Some(signals.err()?));
        Some(StopCause::Interrupted)
    }

    /// What a handler of a signal raised, such as `KeyboardInterrupt`.
    ///
    /// # Errors
    /// That.
    pub fn require_quiet(&self) -> PyResult<()> {
        self.signal.take().map_or(Ok(()), Err)
    }
}

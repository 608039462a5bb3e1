//! Interruption of runs by Ctrl-C.

use std::cell::{Cell, RefCell};
use std::time::{Duration, Instant};

use machinist::error::StopCause;
use pyo3::prelude::*;

/// Interval between signal checks; Python handles signals in its main thread only.
pub const PERIOD: Duration = Duration::from_millis(100);
/// Number of steps between readings of the clock.
const STEPS: u32 = 64;

/// Decides after every step whether a run continues.
pub struct Patience {
    steps: Cell<u32>,
    /// Time of the next signal check.
    next: Cell<Instant>,
    signal: RefCell<Option<PyErr>>,
}

impl Patience {
    /// Starts now and lasts until a signal is raised.
    pub fn new() -> Self {
        Self {
            steps: Cell::new(0),
            next: Cell::new(Instant::now() + PERIOD),
            signal: RefCell::new(None),
        }
    }

    /// Reason for the interruption, if any.
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

    /// Passes on an exception of a signal handler.
    ///
    /// # Errors
    /// The exception, such as `KeyboardInterrupt`.
    pub fn require_quiet(&self) -> PyResult<()> {
        self.signal.take().map_or(Ok(()), Err)
    }
}

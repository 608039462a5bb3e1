//! Ends of a run from outside, at any time.

use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Duration;

use crate::error::StopCause;

/// Limits of a run.
#[derive(Clone, Copy, Default)]
pub(crate) struct Patience<'a> {
    /// Until this is set.
    pub(crate) flag: Option<&'a AtomicBool>,
    /// Until this returns a reason to end.
    pub(crate) asked: Option<&'a dyn Fn() -> Option<StopCause>>,
    /// For this long.
    pub(crate) limit: Option<Duration>,
}

impl Patience<'_> {
    /// Returns the reason for a run that has computed for this time to end, if there is one.
    pub(super) fn end(&self, spent: impl FnOnce() -> Duration) -> Option<StopCause> {
        if self.flag.is_some_and(|flag| flag.load(Ordering::Relaxed)) {
            return Some(StopCause::Interrupted);
        }
        if let Some(limit) = self.limit
            && spent() >= limit
        {
            return Some(StopCause::TooSlow { seconds: limit.as_secs_f64() });
        }
        self.asked.and_then(|asked| asked())
    }

    /// Returns whether the end of the run need not be reached.
    pub(super) fn is_limited(&self) -> bool {
        self.limit.is_some() || self.asked.is_some()
    }
}

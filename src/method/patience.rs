//! What ends a run from outside, wherever it is.

use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Duration;

use crate::error::StopCause;

/// How long a run may go on.
#[derive(Clone, Copy, Default)]
pub(crate) struct Patience<'a> {
    /// Until this is set.
    pub(crate) flag: Option<&'a AtomicBool>,
    /// Until this says why it is to end.
    pub(crate) asked: Option<&'a dyn Fn() -> Option<StopCause>>,
    /// For so long.
    pub(crate) limit: Option<Duration>,
}

impl Patience<'_> {
    /// Why a run that has computed for so long is to end, if it is.
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

    /// Whether the end of a run need not be meant to be reached.
    pub(super) fn is_limited(&self) -> bool {
        self.limit.is_some() || self.asked.is_some()
    }
}

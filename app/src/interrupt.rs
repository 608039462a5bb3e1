//! Ctrl-C: the first stops the work and keeps its results so far, the second ends the program.

use std::sync::Arc;
use std::sync::atomic::AtomicBool;

use signal_hook::consts::SIGINT;
use signal_hook::flag::{register, register_conditional_shutdown};

/// Exit code of an interrupted program, as shells have it.
const INTERRUPTED: i32 = 128 + SIGINT;

/// Returns a flag that Ctrl-C sets from now on. If no handler can be installed, Ctrl-C ends the
/// program as usual.
pub fn flag() -> Arc<AtomicBool> {
    let flag = Arc::new(AtomicBool::new(false));
    // This order keeps the signal that sets the flag from ending the program too.
    if register_conditional_shutdown(SIGINT, INTERRUPTED, Arc::clone(&flag)).is_ok() {
        let _ = register(SIGINT, Arc::clone(&flag));
    }
    flag
}

/// Makes Ctrl-C end the program at once, with the exit code that shells use for it.
#[cfg(feature = "derive")]
pub fn end_at_once() {
    // If no handler can be installed, Ctrl-C ends the program as usual.
    let _ = register_conditional_shutdown(SIGINT, INTERRUPTED, Arc::new(AtomicBool::new(true)));
}

//! Ctrl-C: the first ends what is under way and keeps what there is, the second ends the program.

use std::sync::Arc;
use std::sync::atomic::AtomicBool;

use signal_hook::consts::SIGINT;
use signal_hook::flag::{register, register_conditional_shutdown};

/// Exit code of a program that was interrupted, as shells have it.
const INTERRUPTED: i32 = 128 + SIGINT;

/// A flag that Ctrl-C sets from now on; where no handler can be had, Ctrl-C ends the program as
/// it always does.
pub fn flag() -> Arc<AtomicBool> {
    let flag = Arc::new(AtomicBool::new(false));
    // In this order, so that the one that sets the flag does not end the program as well.
    if register_conditional_shutdown(SIGINT, INTERRUPTED, Arc::clone(&flag)).is_ok() {
        let _ = register(SIGINT, Arc::clone(&flag));
    }
    flag
}

/// Has Ctrl-C end the program at once, with the code that shells have for it.
#[cfg(feature = "derive")]
pub fn end_at_once() {
    // Where no handler can be had, Ctrl-C ends the program as it always does.
    let _ = register_conditional_shutdown(SIGINT, INTERRUPTED, Arc::new(AtomicBool::new(true)));
}

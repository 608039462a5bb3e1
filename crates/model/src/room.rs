//! Memory for intermediate values, which calls reuse instead of allocating it.

use std::cell::RefCell;

thread_local! {
    /// Blocks that are not in use.
    static ROOMS: RefCell<Vec<Vec<f64>>> = const { RefCell::new(Vec::new()) };
}

/// Calls `work` with `count` numbers of this thread's memory, with arbitrary values. A nested call
/// has numbers of its own.
pub fn with_room<R>(count: usize, work: impl FnOnce(&mut [f64]) -> R) -> R {
    let mut room = ROOMS.with_borrow_mut(Vec::pop).unwrap_or_default();
    if room.len() < count {
        room.resize(count, 0.0);
    }
    let result = work(&mut room[..count]);
    ROOMS.with_borrow_mut(|rooms| rooms.push(room));
    result
}

//! Room for values between, which calls reuse instead of allocating it.

use std::cell::RefCell;

thread_local! {
    /// Rooms that nobody is in.
    static ROOMS: RefCell<Vec<Vec<f64>>> = const { RefCell::new(Vec::new()) };
}

/// Hands over so many numbers of this thread's, with anything in them. A call within the
/// call has numbers of its own.
pub fn with_room<R>(count: usize, work: impl FnOnce(&mut [f64]) -> R) -> R {
    let mut room = ROOMS.with_borrow_mut(Vec::pop).unwrap_or_default();
    if room.len() < count {
        room.resize(count, 0.0);
    }
    let result = work(&mut room[..count]);
    ROOMS.with_borrow_mut(|rooms| rooms.push(room));
    result
}

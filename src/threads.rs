//! Distribution of work over threads, compiled once for all kinds of work.

use std::sync::{Mutex, PoisonError};

use rayon::ThreadPool;
use rayon::prelude::*;

/// Creates a pool of this many threads, or one per processor if 0; `None` if threads are not
/// available.
pub(crate) fn pool(threads: usize) -> Option<ThreadPool> {
    rayon::ThreadPoolBuilder::new().num_threads(threads).build().ok()
}

/// Returns `work(i)` for each i below `count`, in order; without a pool, rayon's global one is
/// used.
pub(crate) fn each<T: Send>(
    pool: Option<&ThreadPool>,
    count: usize,
    work: impl Fn(usize) -> T + Sync,
) -> Vec<T> {
    let places: Vec<Mutex<Option<T>>> = (0..count).map(|_| Mutex::new(None)).collect();
    on_all(pool, count, &|number| {
        let made = work(number);
        *places[number].lock().unwrap_or_else(PoisonError::into_inner) = Some(made);
    });
    let made = |place: Mutex<Option<T>>| place.into_inner().unwrap_or_else(PoisonError::into_inner);
    places.into_iter().map(|place| made(place).expect("each number is worked on")).collect()
}

fn on_all(pool: Option<&ThreadPool>, count: usize, work: &(dyn Fn(usize) + Sync)) {
    let all = || (0..count).into_par_iter().for_each(work);
    match pool {
        Some(pool) => pool.install(all),
        None => all(),
    }
}

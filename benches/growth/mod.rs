//! Tools shared by benchmarks of cost over size: shortest times, allocated bytes, tables with
//! exponents.

pub mod bytes;
mod table;

use std::cell::RefCell;
use std::time::Instant;

use machinist::Simulation;
use machinist::error::StopCause;

pub use table::{Row, print};

/// Duration of the repetitions of a call \[s\]. The fastest counts, because the machine may be
/// busy.
const PATIENCE: f64 = 0.5;

/// Returns the shortest time in seconds of one operation. `call` does several and returns their
/// number.
pub fn fastest(mut call: impl FnMut() -> f64) -> f64 {
    let start = Instant::now();
    let mut least = f64::INFINITY;
    while least.is_infinite() || start.elapsed().as_secs_f64() < PATIENCE {
        let begin = Instant::now();
        let count = call();
        least = least.min(begin.elapsed().as_secs_f64() / count);
    }
    least
}

/// Returns the shortest time in seconds between the ends of two steps, among some steps of a run.
#[allow(dead_code, reason = "not every benchmark looks at steps")]
pub fn fastest_step(run: &Simulation<'_>) -> f64 {
    const STEPS: usize = 12;
    let ends = RefCell::new(Vec::new());
    let end = || {
        let mut ends = ends.borrow_mut();
        ends.push(Instant::now());
        (ends.len() > STEPS).then_some(StopCause::Interrupted)
    };
    // The run is stopped, unless it has fewer steps.
    let stopped = run.clone().until_told(&end).run();
    let ends = ends.borrow();
    assert!(ends.len() > 3, "{:?}", stopped.err());
    let steps = ends.windows(2).map(|pair| (pair[1] - pair[0]).as_secs_f64());
    steps.fold(f64::INFINITY, f64::min)
}

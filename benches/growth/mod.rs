//! Tools shared by benchmarks of cost over size: shortest times, allocated bytes, tables with
//! exponents.

pub mod bytes;

use std::cell::RefCell;
use std::time::Instant;

use machinist::Simulation;
use machinist::error::StopCause;

/// Duration of the repetitions of a call \[s\]. The fastest counts, because the machine may be
/// busy.
const PATIENCE: f64 = 0.5;

/// Costs of a machine of one size.
pub struct Row<const N: usize> {
    pub size: usize,
    pub costs: [f64; N],
}

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

/// Prints a table in Markdown with the exponents of each column below, over all sizes and over the
/// upper half of them, where fixed costs no longer matter.
pub fn print<const N: usize>(name: &str, size: &str, what: &[&str; N], rows: &[Row<N>]) {
    println!("\n| {name}, {size} | {} |", what.join(" | "));
    println!("| {}--- |", "--- | ".repeat(N));
    for row in rows {
        let costs = row.costs.map(|cost| format!("{cost:.4}"));
        let costs = costs.each_ref().map(|cost| cost.trim_end_matches('0').trim_end_matches('.'));
        println!("| {} | {} |", row.size, costs.join(" | "));
    }
    for (label, rows) in [("all", rows), ("the upper half", &rows[rows.len() / 2..])] {
        let exponents: [String; N] =
            std::array::from_fn(|place| format!("{:.2}", exponent(rows, place)));
        println!("| exponent, {label} | {} |", exponents.join(" | "));
    }
}

/// Returns the slope of a straight line through the logarithms, by least squares.
fn exponent<const N: usize>(rows: &[Row<N>], place: usize) -> f64 {
    let points: Vec<[f64; 2]> =
        rows.iter().map(|row| [(row.size as f64).ln(), row.costs[place].ln()]).collect();
    let count = points.len() as f64;
    let mean = |axis: usize| points.iter().map(|point| point[axis]).sum::<f64>() / count;
    let (x, y) = (mean(0), mean(1));
    let products: f64 = points.iter().map(|[a, b]| (a - x) * (b - y)).sum();
    products / points.iter().map(|[a, _]| (a - x).powi(2)).sum::<f64>()
}

//! How cost grows with the number of elements: a rate, a Jacobian and an implicit step of
//! the saw gin with a distributed shaft, with fitted exponents.
//!
//! `cargo bench --no-default-features --bench fields`

use std::time::Instant;

use machinist::field::{Discretisation, FieldSimulator};
use machinist::{Method, Simulation};
use machinist_contract::{Describe as _, Simulator as _};
use machinist_scenes::scenes::saw_gin_shaft::SawGinShaft;

const NUMBERS: [usize; 4] = [100, 1000, 10_000, 100_000];
/// Each is repeated for so long \[s\], and the fastest counts: the machine may be busy.
const PATIENCE: f64 = 1.0;

fn main() {
    let mut rows: Vec<[f64; 4]> = Vec::new();
    println!("saw_gin_shaft, elements of order 1; fastest of repetitions over {PATIENCE} s");
    println!("{:>9} {:>12} {:>12} {:>14}", "elements", "rate [us]", "Jacobian [us]", "step [us]");
    for elements in NUMBERS {
        let [rate, jacobian, step] = times(elements).map(|time| time * 1e6);
        println!("{elements:>9} {rate:>12.1} {jacobian:>12.1} {step:>14.1}");
        rows.push([elements as f64, rate, jacobian, step]);
    }
    for (place, what) in [(1, "rate"), (2, "Jacobian"), (3, "implicit step")] {
        println!("{what}: time grows with elements to the power {:.3}", exponent(&rows, place));
    }
}

/// Seconds of a rate, of a Jacobian, of a step of Rodas5P.
fn times(elements: usize) -> [f64; 3] {
    let wanted = Discretisation { elements: Some(elements), order: Some(1) };
    let simulator = FieldSimulator::new(&SawGinShaft, wanted).expect("numbers are in range");
    let shape = simulator.shape();
    let p: Vec<f64> = (0..shape.parameters).map(|i| simulator.parameter_default(i)).collect();
    let mut state = vec![0.0; shape.states()];
    simulator.initial_state(&p, &mut state);
    let mut rate = vec![0.0; state.len()];
    let of_rate = fastest(|| {
        simulator.rate(0.5, &state, &p, &mut rate);
        1.0
    });
    let mut values = vec![0.0; simulator.rate_jacobian_pattern().entries.len()];
    let of_jacobian = fastest(|| {
        simulator.rate_jacobian(0.5, &state, &p, &mut values);
        1.0
    });
    let of_step = fastest(|| {
        let run = Simulation::new(&simulator)
            .until(1e-3)
            .points(2)
            .rtol(1e-4)
            .method(Method::Rodas5p)
            .run()
            .expect("the saw gin runs");
        (run.work.steps + run.work.rejected) as f64
    });
    [of_rate, of_jacobian, of_step]
}

/// Least seconds of one of what a call does several of.
fn fastest(mut call: impl FnMut() -> f64) -> f64 {
    let start = Instant::now();
    let mut least = f64::INFINITY;
    while least.is_infinite() || start.elapsed().as_secs_f64() < PATIENCE {
        let begin = Instant::now();
        let count = call();
        least = least.min(begin.elapsed().as_secs_f64() / count);
    }
    least
}

/// Slope of a straight line through the logarithms, by least squares.
fn exponent(rows: &[[f64; 4]], place: usize) -> f64 {
    let points: Vec<[f64; 2]> = rows.iter().map(|row| [row[0].ln(), row[place].ln()]).collect();
    let count = points.len() as f64;
    let mean = |axis: usize| points.iter().map(|point| point[axis]).sum::<f64>() / count;
    let (x, y) = (mean(0), mean(1));
    let products: f64 = points.iter().map(|[a, b]| (a - x) * (b - y)).sum();
    products / points.iter().map(|[a, _]| (a - x).powi(2)).sum::<f64>()
}

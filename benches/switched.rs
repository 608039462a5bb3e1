//! Time of machines that are linear between switches, in closed form and by steps, and the
//! difference from the closed form:
//! `cargo bench -p machinist-tests --features measure --bench switched`.
//!
//! A difference is the largest of a state over time, relative to the state's largest value.
//! `tests/between_switches.rs` compares the same machines with runs in 31 digits.

use std::error::Error;
use std::path::Path;
use std::time::{Duration, Instant};

use machinist::{Method, Simulation, Trajectory};
use machinist_codegen::mechanics::reduce::Keep;
use machinist_codegen::pipeline;
use machinist_model::ModelSimulator;

const MACHINES: [&str; 5] = ["play", "stop", "coulomb", "two_masses", "converter"];
const METHODS: [Method; 5] =
    [Method::Exact, Method::Auto, Method::Taylor, Method::Dop853, Method::Radau];
/// Number of runs, of which the median counts.
const RUNS: usize = 5;

fn main() -> Result<(), Box<dyn Error>> {
    println!(
        "{:<11} {:<7} {:>9} {:>7} {:>8} {:>9}",
        "machine", "method", "ms", "steps", "rates", "off"
    );
    for name in MACHINES {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../benches/switched");
        let simulator = simulator(&folder.join(name).with_extension("toml"))?;
        let closed = Simulation::new(&simulator).method(Method::Exact).run()?;
        for method in METHODS {
            let (took, run) = measured(&simulator, method)?;
            println!(
                "{name:<11} {:<7} {:>9.3} {:>7} {:>8} {:>9.1e}",
                method.name(),
                1e3 * took.as_secs_f64(),
                run.work.steps,
                run.work.rate_evaluations,
                difference(&run, &closed)
            );
        }
    }
    Ok(())
}

fn simulator(file: &Path) -> Result<ModelSimulator, Box<dyn Error>> {
    let model = pipeline::generate(file, Keep::All);
    Ok(ModelSimulator::new(model.map_err(|errors| errors.render())?))
}

/// Returns the median time of some runs, and the last run.
fn measured(
    simulator: &ModelSimulator,
    method: Method,
) -> Result<(Duration, Trajectory), Box<dyn Error>> {
    let simulation = Simulation::new(simulator).method(method);
    let mut times = Vec::new();
    let mut last = simulation.run()?;
    for _ in 0..RUNS {
        let begin = Instant::now();
        last = simulation.run()?;
        times.push(begin.elapsed());
    }
    times.sort_unstable();
    Ok((times[RUNS / 2], last))
}

fn difference(run: &Trajectory, closed: &Trajectory) -> f64 {
    let columns = run.columns.iter().zip(&closed.columns);
    let of_column = columns.map(|(ours, theirs)| {
        let size = theirs.values.iter().fold(f64::MIN_POSITIVE, |size, v| size.max(v.abs()));
        let pairs = ours.values.iter().zip(&theirs.values);
        pairs.map(|(a, b)| (a - b).abs() / size).fold(0.0, f64::max)
    });
    of_column.fold(0.0, f64::max)
}

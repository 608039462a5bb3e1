//! Cost of sensitivities to ten parameters relative to the run alone, for emitted machines and a
//! JIT-compiled one: `cargo bench -p machinist-tests --features measure --bench sensitivities`.
//!
//! Times are medians of many rounds, in turns, with 201 output samples. Errors are the largest of
//! all columns, relative to the largest value of each, against a run at 1e-12. `-- WORDS` selects
//! rows that contain one of the words: `emitted`, `compiled`, the name of another machine or of a
//! method.

use std::collections::BTreeSet;
use std::hint::black_box;
use std::path::Path;
use std::time::Instant;

use machinist::simulate::Pull;
use machinist::{Method, SimulateError, Simulation, Trajectory};
use machinist_algebra::cas::Algebra;
use machinist_codegen::mechanics::reduce::Keep;
use machinist_codegen::pipeline;
use machinist_contract::Simulator;
use machinist_model::ModelSimulator;
use machinist_scenes::scenes;

const BY: [&str; 10] = [
    "coupling.stiffness",
    "coupling.damping",
    "motor.inertia",
    "cylinder.inertia",
    "motor.phase_voltage",
    "motor.supply_frequency",
    "motor.k_s",
    "motor.k_r",
    "motor.x_s",
    "motor.alpha_s",
];
/// Other machines, with up to ten of their parameters.
const OTHERS: [&str; 2] = ["two_mass", "pendulum_chain"];
const METHODS: [Method; 3] = [Method::Tsit5, Method::Dop853, Method::Radau];
const TOLERANCES: [f64; 3] = [1e-4, 1e-6, 1e-9];
const ROUNDS: usize = 41;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let emitted = scenes::find_f64("saw_gin").ok_or("it is built in")?;
    let spec = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../specs/scenes/saw_gin.toml"));
    let system = pipeline::check(spec)?;
    // The same algebra as for emitted code.
    let algebra = Algebra::most_simplifying(system.coordinates.len());
    let model = pipeline::compile_by(algebra, system, Keep::Needed)?;
    let compiled = ModelSimulator::compiled_at_once(model);
    println!(
        "{:24} {:7} {:>6} {:>24} {:>24} {:>18} {:>17}",
        "",
        "method",
        "rtol",
        "alone, ms (steps)",
        "uncontrolled (error)",
        "controlled (error)",
        "ratios"
    );
    rows("saw_gin, emitted", emitted, &BY)?;
    in_reverse("saw_gin, emitted", emitted)?;
    rows("saw_gin, compiled", &compiled, &BY)?;
    for name in OTHERS {
        let simulator = scenes::find_f64(name).ok_or("it is built in")?;
        rows(name, simulator, &moving(simulator))?;
    }
    Ok(())
}

/// Returns the first ten parameters that the rate depends on.
fn moving(simulator: &dyn Simulator<f64>) -> Vec<&str> {
    let entries = simulator.parameter_jacobian_pattern().entries;
    let parameters: BTreeSet<u32> = entries.iter().map(|entry| entry.1).collect();
    parameters.iter().take(10).map(|index| simulator.parameter(*index as usize).name).collect()
}

fn of(simulator: &dyn Simulator<f64>, method: Method, rtol: f64) -> Simulation<'_> {
    Simulation::new(simulator).method(method).rtol(rtol).points(201)
}

fn rows(name: &str, simulator: &dyn Simulator<f64>, by: &[&str]) -> Result<(), SimulateError> {
    let words: Vec<String> = std::env::args().skip(1).filter(|word| word != "--bench").collect();
    let is_kept = |method: &Method| {
        let holds = |word: &String| name.contains(word.as_str()) || method.name() == word;
        words.is_empty() || words.iter().any(holds)
    };
    if !METHODS.iter().any(is_kept) {
        return Ok(());
    }
    let reference = of(simulator, Method::Dop853, 1e-12).sensitivities(by)?.run()?;
    for method in METHODS.into_iter().filter(is_kept) {
        for rtol in TOLERANCES {
            row(name, (simulator, by), (method, rtol), &reference)?;
        }
    }
    Ok(())
}

fn row(
    name: &str,
    (simulator, by): (&dyn Simulator<f64>, &[&str]),
    (method, rtol): (Method, f64),
    reference: &Trajectory,
) -> Result<(), SimulateError> {
    let alone = of(simulator, method, rtol);
    let controlled = alone.clone().sensitivities(by)?;
    let uncontrolled = controlled.clone().with_controlled_sensitivities(false);
    let runs = [alone, uncontrolled, controlled];
    let mut times: [Vec<f64>; 3] = Default::default();
    for _ in 0..ROUNDS {
        for (times, run) in times.iter_mut().zip(&runs) {
            let begin = Instant::now();
            black_box(run.run()?);
            times.push(begin.elapsed().as_secs_f64() * 1e3);
        }
    }
    let times = times.map(|mut times| {
        times.sort_by(f64::total_cmp);
        times[ROUNDS / 2]
    });
    let told: Vec<_> = runs.iter().map(Simulation::run).collect::<Result<_, _>>()?;
    println!(
        "{:24} {:7} {rtol:6.0e} {:17.3} ({:4}) {:14.3} ({:7.1e}) {:8.3} ({:7.1e}) {:8.2} {:8.2}",
        format!("{name}, by {}", by.len()),
        method.name(),
        times[0],
        told[0].work.steps,
        times[1],
        error(&told[1], reference),
        times[2],
        error(&told[2], reference),
        times[1] / times[0],
        times[2] / times[0],
    );
    Ok(())
}

/// Times the gradient of one number by all parameters and initial values.
fn in_reverse(name: &str, simulator: &dyn Simulator<f64>) -> Result<(), SimulateError> {
    for method in [Method::Tsit5, Method::Dop853] {
        for rtol in TOLERANCES {
            let run = of(simulator, method, rtol);
            let pull = |run: &Trajectory| {
                let slopes = vec![1.0; run.times.len()];
                vec![Pull { column: "twist".to_owned(), slopes }]
            };
            let count = run.gradient(pull)?.slopes.len();
            let mut times: [Vec<f64>; 2] = Default::default();
            for _ in 0..ROUNDS {
                let begin = Instant::now();
                black_box(run.run()?);
                times[0].push(begin.elapsed().as_secs_f64() * 1e3);
                let begin = Instant::now();
                black_box(run.gradient(pull)?);
                times[1].push(begin.elapsed().as_secs_f64() * 1e3);
            }
            let [alone, whole] = times.map(|mut times| {
                times.sort_by(f64::total_cmp);
                times[ROUNDS / 2]
            });
            println!(
                "{:24} {:7} {rtol:6.0e} {alone:17.3} {:>7} {whole:14.3} {:>20} {:>18.2}",
                format!("{name}, {count} in reverse"),
                method.name(),
                "",
                "",
                whole / alone
            );
        }
    }
    Ok(())
}

/// Returns the largest error of all sensitivities, relative to the largest value of each.
fn error(run: &Trajectory, reference: &Trajectory) -> f64 {
    let columns = run.columns.iter().zip(&reference.columns);
    let of_column = columns.filter(|(own, _)| own.name.starts_with("d(")).map(|(own, wanted)| {
        let size = wanted.values.iter().fold(0.0_f64, |most, value| most.max(value.abs()));
        let off = own.values.iter().zip(&wanted.values).map(|(a, b)| (a - b).abs());
        if size > 0.0 { off.fold(0.0, f64::max) / size } else { 0.0 }
    });
    of_column.fold(0.0, f64::max)
}

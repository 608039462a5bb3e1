//! Times every method on an emitted machine: wall time and work of one run
//! against its true error.
//!
//!     cargo run --release --no-default-features --example method_times [scene]
//!
//! Only ratios within one run of this program mean anything.

use std::time::Instant;

use machinist::{Method, SimulateError, Simulation, Trajectory};
use machinist_contract::Simulator;
use machinist_scenes::scenes;

fn main() -> Result<(), SimulateError> {
    let wanted = std::env::args().nth(1).unwrap_or_else(|| "saw_gin".to_owned());
    let Some(scene) = scenes::find_f64(&wanted) else {
        eprintln!("there is no scene {wanted}");
        return Ok(());
    };
    let reference = Simulation::new(scene).points(2).method(Method::Dop853).rtol(1e-13).run()?;
    println!("one rate: {:.0} ns", rate_time(scene));
    println!("method     rtol   error    ms       steps rejected  rates  ns a step");
    for rtol in [1e-3, 1e-5, 1e-7, 1e-9, 1e-11] {
        for method in Method::compiled_in() {
            time(scene, method, rtol, &reference);
        }
    }
    Ok(())
}

/// Nanoseconds of one evaluation of the rate, by many at states that differ.
fn rate_time(scene: &dyn Simulator<f64>) -> f64 {
    const TIMES: u32 = 200_000;
    let shape = scene.shape();
    let parameters: Vec<f64> =
        (0..shape.parameters).map(|index| scene.parameter_default(index)).collect();
    let mut state = vec![0.0; shape.states()];
    scene.initial_state(&parameters, &mut state);
    let mut rate = state.clone();
    let start = Instant::now();
    for step in 0..TIMES {
        scene.rate(f64::from(step) * 1e-6, &state, &parameters, &mut rate);
        for (state, rate) in state.iter_mut().zip(&rate) {
            *state += 1e-7 * rate;
        }
    }
    assert!(state.iter().all(|value| value.is_finite()));
    1e9 * start.elapsed().as_secs_f64() / f64::from(TIMES)
}

fn time(scene: &dyn Simulator<f64>, method: Method, rtol: f64, reference: &Trajectory) {
    let simulation = Simulation::new(scene).points(2).method(method).rtol(rtol).max_steps(200_000);
    let mut times = Vec::new();
    let begin = Instant::now();
    let mut last = simulation.run();
    while times.len() < 3 || begin.elapsed().as_millis() < 100 && times.len() < 200 {
        let start = Instant::now();
        last = simulation.run();
        times.push(start.elapsed().as_secs_f64());
    }
    times.sort_by(f64::total_cmp);
    let median = times[times.len() / 2];
    match last {
        Ok(run) => {
            let (error, work) = (distance(scene, &run, reference), run.work);
            println!(
                "{method:<9} {rtol:.0e} {error:8.1e} {:8.4} {:7} {:6} {:8} {:8.0}  {}",
                1e3 * median,
                work.steps,
                work.rejected,
                work.rate_evaluations,
                1e9 * median / work.steps as f64,
                run.notes.get(1).map_or("", String::as_str),
            );
        }
        Err(error) => println!("{method:<9} {rtol:.0e} {error}"),
    }
}

/// Root mean square over the states of the error at the end, each over its size.
fn distance(scene: &dyn Simulator<f64>, run: &Trajectory, reference: &Trajectory) -> f64 {
    let states = scene.shape().states();
    let sum: f64 = (0..states)
        .map(|index| {
            let last = |run: &Trajectory| run.columns[index].values.last().copied().unwrap_or(0.0);
            let exact = last(reference);
            ((last(run) - exact) / exact.abs().max(scene.state_scale(index))).powi(2)
        })
        .sum();
    (sum / states as f64).sqrt()
}

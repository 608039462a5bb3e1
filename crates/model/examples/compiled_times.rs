//! Times to compile models and to run them: interpreted, compiled, and in two lanes.
//!
//! ```text
//! cargo run --release -p machinist-model --example compiled_times -- FILE...
//! ```
//!
//! Files are models as `machinist compile` writes them.

use std::hint::black_box;
use std::time::Instant;

use machinist_contract::taylor::TaylorSeries;
use machinist_contract::{Describe, Simulator};
use machinist_model::functions::FunctionId;
use machinist_model::{F64x2, Lane, Model, ModelSimulator, file, operations};

/// Order of the timed series.
const ORDER: usize = 14;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    for path in std::env::args().skip(1) {
        report(&file::read(&std::fs::read(path)?)?.model);
    }
    Ok(())
}

fn report(model: &Model) {
    let [compiled, interpreted] = [ModelSimulator::compiled_at_once, ModelSimulator::interpreted]
        .map(|new| Box::new(new(model.clone())));
    println!("{}, {:?}", model.name, compiled.running());
    println!(
        "{:20} {:>10} {:>12} ns {:>11} ns {:>9} ns",
        "", "ready, ms", "interpreted", "compiled", "a lane"
    );
    for id in [FunctionId::Rate, FunctionId::RateJacobian, FunctionId::Outputs] {
        let results = match id {
            FunctionId::RateJacobian => compiled.rate_jacobian_pattern().entries.len(),
            _ => model.tape(id).results.len(),
        };
        let work = of_function(id, results);
        let count = operations(model.tape(id));
        row(&format!("{} ({count})", id.row().name), [&*compiled, &*interpreted], work);
    }
    if model.constraints.is_empty() {
        row(&format!("series to order {ORDER}"), [&*compiled, &*interpreted], of_series());
    }
}

/// A function, called on one number and on two lanes.
type Work = (Box<dyn FnMut(&ModelSimulator)>, Box<dyn FnMut(&ModelSimulator)>);

fn row(name: &str, [compiled, interpreted]: [&ModelSimulator; 2], (mut one, mut two): Work) {
    let begin = Instant::now();
    one(compiled);
    let ready = begin.elapsed().as_secs_f64() * 1e3;
    let slow = nanoseconds(|| one(interpreted));
    let fast = nanoseconds(|| one(compiled));
    let lane = nanoseconds(|| two(compiled)) / 2.0;
    println!("{name:20} {ready:10.2} {slow:15.1} {fast:14.1} {lane:12.1}");
}

fn of_function(id: FunctionId, results: usize) -> Work {
    fn work<R: Lane>(id: FunctionId, results: usize) -> Box<dyn FnMut(&ModelSimulator)>
    where
        ModelSimulator: Simulator<R>,
    {
        let mut values = vec![R::literal(0.0); results];
        let mut start = None;
        Box::new(move |simulator| {
            let (state, p) = start.get_or_insert_with(|| begin::<R>(simulator));
            let time = R::literal(0.1);
            let (state, p) = (black_box(&state[..]), black_box(&p[..]));
            match id {
                FunctionId::Rate => simulator.rate(time, state, p, &mut values),
                FunctionId::Outputs => simulator.outputs(time, state, p, &mut values),
                _ => simulator.rate_jacobian(time, state, p, &mut values),
            }
        })
    }
    (work::<f64>(id, results), work::<F64x2>(id, results))
}

fn of_series() -> Work {
    fn work<R: Lane>() -> Box<dyn FnMut(&ModelSimulator)>
    where
        ModelSimulator: Simulator<R> + TaylorSeries<R>,
    {
        let (mut start, mut coefficients, mut workspace) = (None, vec![], vec![]);
        Box::new(move |simulator| {
            let zero = R::literal(0.0);
            let (state, p) = start.get_or_insert_with(|| begin::<R>(simulator));
            coefficients.resize(state.len() * (ORDER + 1), zero);
            workspace.resize(TaylorSeries::<R>::series_workspace(simulator, ORDER), zero);
            simulator.series(zero, black_box(state), p, &mut coefficients, &mut workspace);
        })
    }
    (work::<f64>(), work::<F64x2>())
}

/// Returns the state at the start and the parameters.
fn begin<R: Lane>(simulator: &ModelSimulator) -> (Vec<R>, Vec<R>)
where
    ModelSimulator: Simulator<R>,
{
    let model = simulator.model();
    let parameters: Vec<R> = model.all_parameters().map(|p| R::literal(p.value)).collect();
    let mut state = vec![R::literal(0.0); model.states.len()];
    simulator.initial_state(&parameters, &mut state);
    (state, parameters)
}

/// Returns the shortest of several measurements.
fn nanoseconds(mut work: impl FnMut()) -> f64 {
    let mut measure = |count: u32| {
        let begin = Instant::now();
        (0..count).for_each(|_| work());
        begin.elapsed().as_secs_f64() * 1e9 / f64::from(count)
    };
    let count = (2e6 / measure(10)).clamp(1.0, 1e7) as u32;
    (0..20).map(|_| measure(count)).fold(f64::INFINITY, f64::min)
}

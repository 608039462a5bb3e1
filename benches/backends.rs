//! Emitted code, JIT-compiled models and interpreted models compared in one run:
//! `cargo bench -p machinist-tests --features measure --bench backends`.
//!
//! For each scene: nanoseconds of a rate and of a Jacobian (as methods call them, with constants
//! prepared; for scenes with fields, those of the rest of the machine), milliseconds of the scene's
//! own run by `dop853` or `radau`, and the time until the machine code is ready. Values are minima
//! of several rounds, in turns.

use std::hint::black_box;
use std::path::Path;
use std::time::{Duration, Instant};

use machinist::field::{Discretisation, FieldError, FieldSimulator};
use machinist::{Method, Simulation};
use machinist_algebra::cas::Algebra;
use machinist_bench_scenes as bench;
use machinist_codegen::mechanics::reduce::Keep;
use machinist_codegen::pipeline;
use machinist_contract::Simulator;
use machinist_model::{Model, ModelSimulator};
use machinist_scenes::scenes;

const SCENES: [(&str, Method); 14] = [
    ("saw_gin", Method::Dop853),
    ("pendulum_chain", Method::Dop853),
    ("winder_linkage", Method::Radau),
    ("winder_full", Method::Dop853),
    ("reed_beat_up", Method::Dop853),
    ("saw_gin_shaft", Method::Radau),
    ("bench/m1", Method::Dop853),
    ("bench/m2", Method::Dop853),
    ("bench/m3_10", Method::Radau),
    ("bench/m4_7", Method::Dop853),
    ("bench/m5", Method::Dop853),
    ("bench/m6_2", Method::Dop853),
    ("bench/m6_5", Method::Dop853),
    ("bench/m6_10", Method::Dop853),
];
const ROUNDS: usize = 7;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    println!(
        "{:16} {:>8} | {:>26} | {:>26} | {:>26}",
        "", "ready", "rate, ns", "Jacobian, ns", "run, ms"
    );
    let columns = ["emitted compiled   interp."; 3].join(" | ");
    println!("{:16} {:>8} | {columns}", "scene", "ms");
    for (scene, method) in SCENES {
        let specs = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../specs/scenes"));
        let system = pipeline::check(&specs.join(format!("{scene}.toml")))?;
        // The same algebra as for emitted code.
        let algebra = Algebra::most_simplifying(system.coordinates.len());
        let model = pipeline::compile_by(algebra, system, Keep::Needed)?;
        row(scene, &model, method)?;
    }
    Ok(())
}

fn row(scene: &str, model: &Model, method: Method) -> Result<(), Box<dyn std::error::Error>> {
    let name = scene.trim_start_matches("bench/");
    let emitted = scenes::find_f64(name).or_else(|| bench::find(name));
    let with_fields = scenes::find_field_f64(name);
    let emitted = emitted.or_else(|| with_fields.map(|scene| scene as &dyn Simulator<f64>));
    let emitted = emitted.ok_or_else(|| format!("{name} is not emitted"))?;
    let begin = Instant::now();
    let compiled = ModelSimulator::compiled_at_once(model.clone());
    Inputs::new(&compiled).call(&compiled);
    let ready = begin.elapsed().as_secs_f64() * 1e3;
    let interpreted = ModelSimulator::interpreted(model.clone());
    let simulators: [&dyn Simulator<f64>; 3] = [emitted, &compiled, &interpreted];
    let fields = with_fields.map(|emitted| -> Result<_, FieldError> {
        let scenes = [emitted, compiled.with_fields(), interpreted.with_fields()];
        let cut = |scene| FieldSimulator::new(scene, Discretisation::default());
        let [a, b, c] = scenes.map(cut);
        Ok([a?, b?, c?])
    });
    let fields = fields.transpose()?;
    let mut times = [[f64::INFINITY; 3]; 3];
    for _ in 0..ROUNDS {
        for (column, simulator) in simulators.into_iter().enumerate() {
            let mut inputs = Inputs::new(simulator);
            let [rate, jacobian] = inputs.nanoseconds(simulator);
            let whole = fields.as_ref().map_or(simulator, |fields| fields[column].single());
            let begin = Instant::now();
            Simulation::new(whole).method(method).rtol(1e-8).run()?;
            let run = begin.elapsed().as_secs_f64() * 1e3;
            for (least, time) in times.iter_mut().zip([rate, jacobian, run]) {
                least[column] = least[column].min(time);
            }
        }
    }
    let shown = times.map(|[a, b, c]| format!("{a:>8.3} {b:>8.3} {c:>8.3}"));
    println!("{scene:16} {ready:8.2} | {}", shown.join(" | "));
    Ok(())
}

/// Arguments of a simulator, and memory for its results.
struct Inputs {
    state: Vec<f64>,
    parameters: Vec<f64>,
    constants: Vec<f64>,
    rate: Vec<f64>,
    jacobian: Vec<f64>,
}

impl Inputs {
    fn new(simulator: &dyn Simulator<f64>) -> Self {
        let shape = simulator.shape();
        let parameters: Vec<f64> =
            (0..shape.parameters).map(|index| simulator.parameter_default(index)).collect();
        let mut state = vec![0.0; shape.states()];
        simulator.initial_state(&parameters, &mut state);
        let mut constants = vec![0.0; simulator.constants()];
        simulator.prepare(&parameters, &mut constants);
        Self {
            rate: vec![0.0; state.len()],
            jacobian: vec![0.0; simulator.rate_jacobian_pattern().entries.len()],
            state,
            parameters,
            constants,
        }
    }

    fn rate(&mut self, simulator: &dyn Simulator<f64>) {
        let (y, p) = (black_box(&self.state), &self.parameters);
        simulator.prepared_rate(0.1, y, p, &self.constants, &mut self.rate);
        black_box(&mut self.rate);
    }

    fn jacobian(&mut self, simulator: &dyn Simulator<f64>) {
        let (y, p) = (black_box(&self.state), &self.parameters);
        simulator.prepared_rate_jacobian(0.1, y, p, &self.constants, &mut self.jacobian);
        black_box(&mut self.jacobian);
    }

    fn call(&mut self, simulator: &dyn Simulator<f64>) {
        self.rate(simulator);
        self.jacobian(simulator);
    }

    fn nanoseconds(&mut self, simulator: &dyn Simulator<f64>) -> [f64; 2] {
        [Self::rate, Self::jacobian].map(|function| {
            let (mut count, mut spent) = (64_u32, Duration::ZERO);
            while spent < Duration::from_millis(3) {
                count *= 2;
                let begin = Instant::now();
                (0..count).for_each(|_| function(self, simulator));
                spent = begin.elapsed();
            }
            spent.as_secs_f64() * 1e9 / f64::from(count)
        })
    }
}

//! Growth of cost with the number of elements, from ten to a million, with fitted exponents: a
//! rate, a Jacobian, an implicit step, and memory, for a nonlinear field and two fields of standard
//! parts.
//!
//! `cargo bench -p machinist --bench fields`

mod growth;

use growth::{Row, bytes, fastest, fastest_step, print};
use machinist::field::{Discretisation, FieldSimulator};
use machinist::{Method, Simulation};
use machinist_bench_scenes::{m3::M3, m4::M4};
use machinist_contract::field::FieldScene;
use machinist_contract::{Describe as _, Simulator as _};
use machinist_scenes::scenes::saw_gin_shaft::SawGinShaft;

/// Numbers of elements of order 1.
const NUMBERS: [usize; 6] = [10, 100, 1000, 10_000, 100_000, 1_000_000];
const WHAT: [&str; 5] =
    ["rate [us]", "Jacobian [us]", "implicit step [us]", "held [kB]", "in a run [kB]"];

fn main() {
    let scenes: [(&str, &dyn FieldScene<f64>); 3] =
        [("saw_gin_shaft", &SawGinShaft), ("bench/m3", &M3), ("bench/m4", &M4)];
    println!("fields of elements of order 1: least time of repetitions, memory that is allocated");
    for (name, scene) in scenes {
        let rows = NUMBERS.map(|elements| Row { size: elements, costs: costs(scene, elements) });
        print(name, "elements", &WHAT, &rows);
    }
}

/// Returns microseconds of a rate, of a Jacobian and of a step of Rodas5P; kilobytes that the
/// simulator holds, and the maximum of additional kilobytes in that run.
fn costs(scene: &dyn FieldScene<f64>, elements: usize) -> [f64; 5] {
    let wanted = Discretisation { elements: Some(elements), order: Some(1) };
    let before = bytes::held();
    let simulator = FieldSimulator::new(scene, wanted).expect("numbers are in range");
    let held = bytes::held() - before;
    let shape = simulator.shape();
    let p: Vec<f64> = (0..shape.parameters).map(|i| simulator.parameter_default(i)).collect();
    let mut state = vec![0.0; shape.states()];
    simulator.initial_state(&p, &mut state);
    let mut constants = vec![0.0; simulator.constants()];
    simulator.prepare(&p, &mut constants);
    let mut rate = vec![0.0; state.len()];
    let of_rate = fastest(|| {
        simulator.prepared_rate(0.01, &state, &p, &constants, &mut rate);
        1.0
    });
    let mut values = vec![0.0; simulator.rate_jacobian_pattern().entries.len()];
    let of_jacobian = fastest(|| {
        simulator.prepared_rate_jacobian(0.01, &state, &p, &constants, &mut values);
        1.0
    });
    let run = Simulation::new(&simulator).until(1.0).points(2).rtol(1e-4);
    let run = run.method(Method::Rodas5p);
    let of_step = fastest_step(&run);
    bytes::forget_most();
    let before = bytes::held();
    fastest_step(&run);
    let beside = bytes::most() - before;
    [of_rate * 1e6, of_jacobian * 1e6, of_step * 1e6, held as f64 / 1e3, beside as f64 / 1e3]
}

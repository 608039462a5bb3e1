//! Exact solutions of fields, compared with stepping methods.

use machinist::field::{Discretisation, FieldSimulator};
use machinist::{Method, Simulation, Trajectory};
use machinist_bench_scenes as bench;
use machinist_contract::Simulator;
use machinist_scenes::scenes;

fn cut(name: &str, elements: usize, order: usize) -> FieldSimulator<'static, f64> {
    let scene = bench::find_field(name).or_else(|| scenes::find_field(name)).expect("a scene");
    let discretisation = Discretisation { elements: Some(elements), order: Some(order) };
    FieldSimulator::new(scene, discretisation).expect("elements")
}

fn run(simulator: &dyn Simulator<f64>, method: Method, until: f64, rtol: f64) -> Trajectory {
    let run = Simulation::new(simulator).method(method).until(until).points(6).rtol(rtol);
    run.run().unwrap_or_else(|error| panic!("{}: {error}", method.name()))
}

/// Returns the largest difference of any state, relative to its largest value over the run.
fn distance(simulator: &dyn Simulator<f64>, a: &Trajectory, b: &Trajectory) -> f64 {
    let states = simulator.shape().states();
    let columns = a.columns.iter().zip(&b.columns).take(states);
    let errors = columns.map(|(a, b)| {
        let size = b.values.iter().fold(1e-30, |size: f64, value| size.max(value.abs()));
        let errors = a.values.iter().zip(&b.values).map(|(a, b)| (a - b).abs() / size);
        errors.fold(0.0, f64::max)
    });
    errors.fold(0.0, f64::max)
}

#[test]
fn linear_fields_are_solved_by_their_modes_as_steps_of_tight_tolerance_go() {
    // Undamped and damped chains, and elements of high order.
    let cases = [
        ("m4", 7, 1, 0.02),
        ("m4", 70, 1, 0.001),
        ("shaft_with_rotors", 12, 1, 0.004),
        ("shaft_with_rotors", 3, 5, 0.004),
    ];
    for (name, elements, order, until) in cases {
        let simulator = cut(name, elements, order);
        assert!(simulator.linear().is_some(), "{name}");
        let exact = run(&simulator, Method::Exact, until, 1e-9);
        let stepped = run(&simulator, Method::Radau, until, 1e-13);
        let error = distance(&simulator, &exact, &stepped);
        assert!(error < 1e-9, "{name}, {elements} elements of order {order}: {error:e}");
        assert!(exact.notes.iter().any(|note| note.contains("modes")), "{:?}", exact.notes);
    }
}

#[test]
fn fields_that_are_not_linear_are_not_solved_so() {
    let simulator = cut("saw_gin_shaft", 4, 1);
    assert!(simulator.linear().is_none());
    assert!(!Method::Exact.suits(&simulator));
}

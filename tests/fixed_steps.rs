//! Fixed steps compared with closed forms: orders, also across times at which the rate jumps.
//!
//! Emitted C takes the same steps: see [`crate::c99`].

use machinist::Simulation;
use machinist::linear_analysis::{Place, operating_point};
use machinist_codegen::mechanics::reduce::Keep;
use machinist_contract::fixed_step::{Clock, FixedMethod, FixedSteps, Room, StepMethod, Stepped};
use machinist_contract::{Describe, Simulator};
use machinist_model::{Elimination, Model, ModelSimulator};

use crate::common::{Oscillator, oscillator_state};
use crate::own_scene::model_of_specs;

/// Returns the largest difference of [`Oscillator`] from its closed form after steps over 2 s.
fn error(method: FixedMethod<'_>, steps: usize) -> f64 {
    let parameters: Vec<f64> = (0..5).map(|index| Oscillator.parameter_default(index)).collect();
    let machine = FixedSteps {
        simulator: &Oscillator,
        parameters: &parameters,
        constants: &[],
        method,
        parts_a_step: FixedSteps::<f64>::enough_parts(&Oscillator),
    };
    let [numbers, signs] = machine.room();
    let (mut numbers, mut signs) = (vec![f64::NAN; numbers], vec![0; signs]);
    let mut room = Room { numbers: &mut numbers, signs: &mut signs };
    let mut state = vec![0.0; 2];
    Oscillator.initial_state(&parameters, &mut state);
    let (step, mut clock, mut largest) = (2.0 / steps as f64, Clock::new(0.0), 0.0_f64);
    for _ in 0..steps {
        let stepped = machine.step(clock.time(), step, &mut state, &mut room);
        assert_eq!(stepped, Stepped::Events(0));
        clock.pass(step);
        let exact = oscillator_state(clock.time());
        for (value, exact) in state.iter().zip(exact) {
            largest = largest.max((value - exact).abs());
        }
    }
    assert!((clock.time() - 2.0).abs() < 1e-15, "the clock sums without loss");
    largest
}

#[test]
fn every_method_keeps_its_order_over_a_jump_within_a_step() {
    // The torque steps at 0.7 s, which is no multiple of these steps.
    let elimination = Elimination::new(2, Oscillator.rate_jacobian_pattern().entries);
    let methods = [
        (FixedMethod::RungeKutta4, 4.0),
        (FixedMethod::Heun, 2.0),
        (FixedMethod::Rosenbrock2(elimination.borrowed()), 2.0),
    ];
    for (method, order) in methods {
        let [coarse, fine] = [97, 194].map(|steps| error(method, steps));
        let measured = (coarse / fine).log2();
        assert!((measured - order).abs() < 0.15, "{method:?}: order {measured}");
    }
}

#[test]
fn a_step_with_too_few_parts_says_so() {
    let parameters: Vec<f64> = (0..5).map(|index| Oscillator.parameter_default(index)).collect();
    let machine = FixedSteps {
        simulator: &Oscillator,
        parameters: &parameters,
        constants: &[],
        method: FixedMethod::Heun,
        parts_a_step: 1,
    };
    let [numbers, signs] = machine.room();
    let (mut numbers, mut signs) = (vec![0.0; numbers], vec![0; signs]);
    let mut room = Room { numbers: &mut numbers, signs: &mut signs };
    let mut state = [0.4, 0.0];
    let mut step = |time| machine.step(time, 0.1, &mut state, &mut room);
    assert_eq!(step(0.5), Stepped::Events(0));
    assert_eq!(step(0.65), Stepped::TooManyParts);
}

/// Returns the largest difference of two states, each entry over its typical size.
pub fn difference(model: &Model, a: &[f64], b: &[f64]) -> f64 {
    let entries = model.states.iter().zip(a).zip(b);
    entries.fold(0.0, |most: f64, ((state, a), b)| {
        let off = (a - b).abs() / state.scale;
        if off <= most { most } else { off }
    })
}

/// Returns the state at the end of an adaptive run, and the number of events after its start.
pub fn adaptive(model: &Model) -> (Vec<f64>, usize) {
    let simulator = ModelSimulator::new(model.clone());
    let run = Simulation::new(&simulator).rtol(1e-11).run().expect("a run");
    let last = |column: &machinist::trajectory::Column| *column.values.last().expect("a value");
    let states = run.of_kind(machinist::trajectory::ColumnKind::State).map(last).collect();
    let later = run.switches.iter().filter(|switch| switch.time > model.run.from);
    (states, later.count())
}

/// Returns the state at a start and after each step, and the number of events.
pub fn steps_in_rust(
    model: &Model,
    method: StepMethod,
    (start, step, steps): (&[f64], f64, usize),
) -> (Vec<Vec<f64>>, usize) {
    let simulator = ModelSimulator::interpreted(model.clone());
    let parameters: Vec<f64> = model.parameters.iter().map(|p| p.value).collect();
    let mut constants = vec![0.0; Simulator::<f64>::constants(&simulator)];
    simulator.prepare(&parameters, &mut constants);
    let states = model.states.len();
    let elimination = Elimination::new(states, &model.rate_jacobian.pattern.entries);
    let machine = FixedSteps {
        simulator: &simulator,
        parameters: &parameters,
        constants: &constants,
        method: method.with(elimination.borrowed()),
        parts_a_step: FixedSteps::<f64>::enough_parts(&simulator),
    };
    let [numbers, signs] = machine.room();
    let (mut numbers, mut signs) = (vec![f64::NAN; numbers], vec![0; signs]);
    let mut room = Room { numbers: &mut numbers, signs: &mut signs };
    let mut state = start.to_vec();
    let mut clock = Clock::new(model.run.from);
    machine.settle(clock.time(), &mut state, &mut room);
    let (mut rows, mut events) = (vec![state.clone()], 0);
    for _ in 0..steps {
        if let Stepped::Events(happened) = machine.step(clock.time(), step, &mut state, &mut room) {
            events += happened;
        }
        clock.pass(step);
        rows.push(state.clone());
    }
    (rows, events)
}

#[test]
fn events_of_friction_are_found_at_steps_of_any_length() {
    for (name, fewest, allowed) in [
        ("stick_slip", 1000, 1e-4),
        ("coulomb_oscillator", 1000, 1e-7),
        ("winder_full", 25_000, 1e-11),
        ("drives/winch", 5000, 1e-3),
        ("parts/rotational/clutch", 1000, 1e-12),
        ("parts/translational/brake", 1000, 1e-12),
    ] {
        let model = model_of_specs(name, Keep::Needed);
        let (exact, switches) = adaptive(&model);
        let simulator = ModelSimulator::interpreted(model.clone());
        let start = operating_point(&Simulation::new(&simulator), Place::Initial).expect("a start");
        for more in 0..20 {
            let steps = fewest + fewest * more / 17;
            let step = (model.run.until - model.run.from) / steps as f64;
            let (rows, events) =
                steps_in_rust(&model, StepMethod::RungeKutta4, (&start.state, step, steps));
            let error = difference(&model, rows.last().expect("a row"), &exact);
            let said =
                format!("{name}, {steps} steps: {events} events of {switches}, off by {error:e}");
            println!("{said}");
            // Rounding may let a clutch slip and stick once more at one instant.
            assert!(events >= switches && error < allowed, "{said}");
        }
    }
}

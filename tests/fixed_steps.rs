//! Fixed steps compared with closed forms: orders, also across times at which the rate jumps.
//!
//! Emitted C takes the same steps: see [`crate::c99`].

use machinist_contract::fixed_step::{Clock, FixedMethod, FixedSteps, Room, Stepped};
use machinist_contract::{Describe, Simulator};
use machinist_model::Elimination;

use crate::common::{Oscillator, oscillator_state};

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

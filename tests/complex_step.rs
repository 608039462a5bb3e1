//! Jacobians written by hand against the complex step.

use crate::common::Oscillator;
use machinist::complex_step::{dense, parameter_jacobian, rate_jacobian, time_derivative};
use machinist_contract::{Describe, Simulator};

const PARAMETERS: [f64; 5] = [2.0, 0.8, 50.0, 30.0, 0.7];
const STATE: [f64; 2] = [0.31, -1.7];

#[test]
fn the_state_jacobian_by_hand_is_that_of_the_complex_step() {
    let mut values = [0.0; 3];
    Oscillator.rate_jacobian(1.0, &STATE, &PARAMETERS, &mut values);
    let by_hand = dense(Oscillator.rate_jacobian_pattern(), &values);
    let found = rate_jacobian(&Oscillator, 1.0, &STATE, &PARAMETERS);
    assert!((found - by_hand).amax() < 1e-14);
}

#[test]
fn the_parameter_jacobian_by_hand_is_that_of_the_complex_step() {
    for time in [0.5, 1.0] {
        let mut values = [0.0; 4];
        Oscillator.parameter_jacobian(time, &STATE, &PARAMETERS, &mut values);
        let by_hand = dense(Oscillator.parameter_jacobian_pattern(), &values);
        let found = parameter_jacobian(&Oscillator, time, &STATE, &PARAMETERS);
        assert!((found - by_hand).amax() < 1e-14);
    }
}

#[test]
fn a_wrong_jacobian_is_told_apart() {
    let wrong = dense(Oscillator.rate_jacobian_pattern(), &[1.0, -25.0, -0.4 + 1e-9]);
    let found = rate_jacobian(&Oscillator, 1.0, &STATE, &PARAMETERS);
    let difference = (found - wrong).amax();
    assert!(difference > 0.9e-9 && difference < 1.1e-9);
}

#[test]
fn a_rate_constant_in_time_has_no_time_derivative() {
    let found = time_derivative(&Oscillator, 1.0, &STATE, &PARAMETERS);
    assert_eq!(found.as_slice(), [0.0, 0.0]);
}

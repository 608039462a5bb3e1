//! Comparison of emitted modules, compiled here, with the evaluator: the same bits.

#![allow(clippy::float_cmp, reason = "numbers that are only moved stay the same")]

use crate::support;
use machinist_contract::{Describe, Simulator};
use machinist_model::evaluate::{Evaluator, Inputs};
use machinist_model::{Model, State, Tape};
use proptest::prelude::*;

#[deny(warnings, clippy::pedantic, missing_docs)]
#[allow(
    clippy::doc_markdown,
    clippy::similar_names,
    clippy::struct_field_names,
    dead_code,
    reason = "docs state equations; names are the spec's; tests need not use all"
)]
mod pendulum {
    include!("emitted/pendulum.rs");
}

#[deny(warnings)]
#[allow(
    non_snake_case,
    clippy::similar_names,
    clippy::struct_field_names,
    clippy::too_many_lines,
    dead_code,
    reason = "the spec's own names, in bodies as long as its equations; tests need not use all"
)]
mod oddities {
    include!("emitted/oddities.rs");
}

/// Evaluates `tape` by the evaluator.
fn evaluated(model: &Model, tape: &Tape, (time, state, parameters): &Given) -> Vec<f64> {
    let mut results = vec![f64::NAN; tape.results.len()];
    let inputs =
        Inputs { time: *time, state, parameters, tables: &model.tables, ..Inputs::default() };
    Evaluator::new(tape).evaluate(&inputs, &mut results);
    results
}

/// Returns the `length` numbers that a simulator writes.
fn simulated(length: usize, write: impl FnOnce(&mut [f64])) -> Vec<f64> {
    let mut values = vec![f64::NAN; length];
    write(&mut values);
    values
}

fn assert_same_bits(what: &str, tape: &[f64], emitted: &[f64]) {
    assert_eq!(tape.len(), emitted.len(), "{what}");
    for (index, (tape, emitted)) in tape.iter().zip(emitted).enumerate() {
        let same = tape.to_bits() == emitted.to_bits() || tape.is_nan() && emitted.is_nan();
        assert!(same, "{what}[{index}]: the tape gives {tape:e}, emitted code {emitted:e}");
    }
}

fn assert_simulator_is_model(simulator: &impl Simulator<f64>, model: &Model, inputs: &Given) {
    let (t, y, p) = (inputs.0, &inputs.1[..], &inputs.2[..]);
    let s = simulator;
    let energy = s.energy(t, y, p);
    let balance = s.power_balance(t, y, p);
    let n = |tape: &Tape| tape.results.len();
    let c = simulated(s.constants(), |v| s.prepare(p, v));
    let cases = [
        ("initial_state", &model.initial_state, simulated(3, |v| s.initial_state(p, v))),
        ("discontinuities", &model.discontinuities, simulated(1, |v| s.discontinuities(p, v))),
        ("rate", &model.rate, simulated(3, |v| s.rate(t, y, p, v))),
        ("prepared_rate", &model.rate, simulated(3, |v| s.prepared_rate(t, y, p, &c, v))),
        (
            "prepared_rate_jacobian",
            &model.rate_jacobian.tape,
            simulated(n(&model.rate_jacobian.tape), |v| {
                s.prepared_rate_jacobian(t, y, p, &c, v);
            }),
        ),
        (
            "prepared_parameter_jacobian",
            &model.parameter_jacobian.tape,
            simulated(n(&model.parameter_jacobian.tape), |v| {
                s.prepared_parameter_jacobian(t, y, p, &c, v);
            }),
        ),
        (
            "rate_jacobian",
            &model.rate_jacobian.tape,
            simulated(n(&model.rate_jacobian.tape), |v| s.rate_jacobian(t, y, p, v)),
        ),
        (
            "parameter_jacobian",
            &model.parameter_jacobian.tape,
            simulated(n(&model.parameter_jacobian.tape), |v| s.parameter_jacobian(t, y, p, v)),
        ),
        (
            "time_derivative",
            &model.time_derivative,
            simulated(3, |v| s.time_derivative(t, y, p, v)),
        ),
        ("mass_matrix", &model.mass_matrix.tape, simulated(1, |v| s.mass_matrix(t, y, p, v))),
        ("forcing", &model.forcing, simulated(1, |v| s.forcing(t, y, p, v))),
        ("outputs", &model.outputs, simulated(n(&model.outputs), |v| s.outputs(t, y, p, v))),
        ("energy", &model.energy, vec![energy.kinetic, energy.potential, energy.stored]),
        (
            "power_balance",
            &model.power_balance,
            vec![balance.stored_rate, balance.supplied, balance.dissipated],
        ),
    ];
    for (name, tape, emitted) in cases {
        assert_same_bits(name, &evaluated(model, tape, inputs), &emitted);
    }
    let matrices = [&model.rate_jacobian.tape, &model.parameter_jacobian.tape];
    let apart = matrices.map(|tape| evaluated(model, tape, inputs)).concat();
    let at_once = simulated(apart.len(), |v| s.prepared_jacobians(t, y, p, &c, v));
    assert_same_bits("prepared_jacobians", &apart, &at_once);
}

/// Time, state, parameters.
type Given = (f64, Vec<f64>, Vec<f64>);

fn inputs() -> impl Strategy<Value = Given> {
    let number = -4.0..4.0_f64;
    let state = proptest::collection::vec(number.clone(), 3);
    (number.clone(), state, proptest::collection::vec(number, 6))
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]
    #[test]
    fn emitted_code_and_evaluator_agree_to_the_last_bit(inputs in inputs()) {
        assert_simulator_is_model(&pendulum::Pendulum, &support::pendulum(), &inputs);
        assert_simulator_is_model(&oddities::Oddities, &support::oddities(), &inputs);
    }
}

/// Repeats the pendulum's acceleration by hand.
#[test]
fn the_emitted_rate_is_the_pendulum_of_the_textbook() {
    let p = pendulum::Parameters::<f64>::default();
    let [phi, speed, torque] = [0.3_f64, -1.5, 2.0];
    let rate = pendulum::rate(0.5, &[phi, speed, torque], &p);
    let acceleration = torque / (4.2 * 0.75 * 0.75)
        - 0.128_534_6 * speed / (4.2 * 0.75 * 0.75)
        - 9.80665 / 0.75 * phi.sin();
    let load = 1.25 * 0.5 - 0.25 * 0.5_f64.powi(3);
    for (found, expected) in rate.into_iter().zip([speed, acceleration, (load - torque) / 1e-2]) {
        assert!((found - expected).abs() <= 1e-13 * expected.abs(), "{found} is not {expected}");
    }
}

#[test]
fn emitted_jacobians_are_the_slopes_of_the_emitted_rate() {
    let p = pendulum::Parameters::<f64>::default();
    let y = [0.3, -1.5, 2.0];
    let values = pendulum::rate_jacobian(0.5, &y, &p);
    let pattern = pendulum::RATE_JACOBIAN_PATTERN;
    let step = 1e-6;
    let mut dense = [[0.0; 3]; 3];
    for (&(row, column), value) in pattern.entries.iter().zip(values) {
        dense[row as usize][column as usize] = value;
    }
    for column in 0..3 {
        let (mut above, mut below) = (y, y);
        above[column] += step;
        below[column] -= step;
        let (above, below) = (pendulum::rate(0.5, &above, &p), pendulum::rate(0.5, &below, &p));
        for row in 0..3 {
            let slope = (above[row] - below[row]) / (2.0 * step);
            let error = (slope - dense[row][column]).abs();
            assert!(error < 1e-6, "row {row}, column {column}: {slope} {}", dense[row][column]);
        }
    }
}

#[test]
fn single_precision_runs_the_same_code() {
    let wide = pendulum::rate(0.5, &[0.3, -1.5, 2.0], &pendulum::Parameters::<f64>::default());
    let narrow = pendulum::rate(0.5, &[0.3, -1.5, 2.0], &pendulum::Parameters::<f32>::default());
    for (wide, narrow) in wide.into_iter().zip(narrow) {
        assert!((wide - f64::from(narrow)).abs() <= 1e-5 * wide.abs());
    }
}

#[test]
fn a_simulator_describes_its_spec() {
    let (machine, model) = (oddities::Oddities, support::oddities());
    assert_eq!(machine.name(), model.name);
    assert_eq!(machine.title(), model.title);
    assert_eq!(machine.shape().states(), model.states.len());
    for (index, State { quantity, .. }) in model.states.iter().enumerate() {
        let described = machine.state(index);
        assert_eq!(described.name, quantity.name.path);
        assert_eq!((described.unit, described.doc), (&*quantity.unit, &*quantity.doc));
    }
    for (index, parameter) in model.parameters.iter().enumerate() {
        assert_eq!(machine.parameter_default(index).to_bits(), parameter.value.to_bits());
    }
    assert_eq!(machine.run_defaults().points, model.run.points);
    assert_eq!(machine.run_defaults().times, model.run.times);
    assert_eq!(machine.rate_jacobian_pattern(), oddities::RATE_JACOBIAN_PATTERN);
}

#[test]
fn parameters_and_outputs_keep_their_order() {
    let values = [1.0, 2.0, 3.0, 4.0, 5.0, 6.0];
    assert_eq!(pendulum::Parameters::from_array(values).to_array(), values);
    assert_eq!(pendulum::Parameters::from_array(values).arm_damping, 4.0);
    let outputs = pendulum::outputs(0.0, &[0.5, 0.0, 0.0], &pendulum::Parameters::default());
    assert_eq!(outputs.to_array()[pendulum::state::ARM_PHI + 1], outputs.deflection);
}

#[test]
#[should_panic(expected = "there are as many numbers as the simulator says")]
fn a_state_of_another_length_is_refused() {
    pendulum::Pendulum.rate(0.0, &[0.0; 4], &[1.0; 6], &mut [0.0; 3]);
}

/// Simulators are found at run time, whatever their number type.
#[test]
fn a_simulator_can_be_an_object() {
    fn find<R: machinist_contract::Real>() -> &'static dyn Simulator<R> {
        &pendulum::Pendulum
    }
    assert_eq!(find::<f64>().shape(), find::<f32>().shape());
}

#[test]
fn a_start_in_equilibrium_is_described_as_the_model_has_it() {
    assert!(oddities::Oddities.starts_in_equilibrium());
    assert!(support::oddities().starts_in_equilibrium);
    assert!(!pendulum::Pendulum.starts_in_equilibrium());
}

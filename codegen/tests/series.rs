//! Comparison of Taylor series with the equations they solve, and of emitted series with
//! interpreted ones.

use crate::support;
use machinist_contract::Simulator;
use machinist_model::Model;
use machinist_model::evaluate::{Evaluator, Inputs};
use machinist_model::series::{Recurrence, SeriesEvaluator, recurrences};

#[allow(dead_code, clippy::pedantic, reason = "tests need not use all; bodies are long")]
mod every_recurrence {
    include!("emitted/recurrences.rs");
}

#[allow(dead_code, clippy::pedantic, reason = "tests need not use all; bodies are long")]
mod coupled {
    include!("emitted/coupled.rs");
}

#[allow(dead_code, clippy::pedantic, reason = "tests need not use all; bodies are long")]
mod pendulum {
    include!("emitted/pendulum.rs");
}

const ORDER: usize = 24;
const PARAMETERS: [f64; 6] = [4.2, 0.75, 9.80665, 0.1, 0.2, 0.1];

/// Returns a time and a state away from knots, branches and poles.
fn start(states: usize) -> (f64, Vec<f64>) {
    let mut state: Vec<f64> = (0..states).map(|index| 0.2 + 0.03 * index as f64).collect();
    state[..2].copy_from_slice(&[0.3, 0.4]);
    (0.4, state)
}

fn inputs<'a>(model: &'a Model, time: f64, state: &'a [f64]) -> Inputs<'a> {
    let tables = &model.tables;
    Inputs { time, state, parameters: &PARAMETERS, tables, ..Inputs::default() }
}

fn series(model: &Model, orders: usize) -> Vec<f64> {
    let (time, state) = start(model.states.len());
    let mut coefficients = vec![f64::NAN; orders * state.len()];
    let evaluator = SeriesEvaluator::new(recurrences(model));
    evaluator.evaluate(&inputs(model, time, &state), &mut coefficients);
    coefficients
}

/// Returns value and derivative of the series `step` after its start.
fn sum(coefficients: &[f64], states: usize, step: f64) -> (Vec<f64>, Vec<f64>) {
    let (mut value, mut slope) = (vec![0.0; states], vec![0.0; states]);
    for terms in coefficients.chunks(states).rev() {
        for index in 0..states {
            slope[index] = slope[index] * step + value[index];
            value[index] = value[index] * step + terms[index];
        }
    }
    (value, slope)
}

#[test]
fn series_solve_the_equations_they_come_from() {
    for model in [support::recurrences(), support::coupled(), support::pendulum()] {
        let states = model.states.len();
        let coefficients = series(&model, ORDER + 1);
        for step in [-0.06, -0.01, 0.0, 0.02, 0.06] {
            let (state, slope) = sum(&coefficients, states, step);
            let time = start(states).0 + step;
            let mut rate = vec![f64::NAN; states];
            let evaluator = Evaluator::new(&model.rate);
            evaluator.evaluate(&inputs(&model, time, &state), &mut rate);
            for (index, (slope, rate)) in slope.iter().zip(&rate).enumerate() {
                let error = (slope - rate).abs() / rate.abs().max(1.0);
                let name = &model.name;
                assert!(error < 3e-13, "{name} at {step}, state {index}: {slope:e} for {rate:e}");
            }
        }
    }
}

fn assert_emitted_as_interpreted(simulator: &dyn Simulator<f64>, model: &Model) {
    let states = model.states.len();
    let taylor = simulator.taylor().expect("emitted simulators have series");
    for orders in [1, 2, 3, ORDER + 1, 6] {
        let interpreted = series(model, orders);
        let (time, state) = start(states);
        let mut workspace = vec![f64::NAN; taylor.series_workspace(orders - 1)];
        let mut emitted = vec![f64::NAN; orders * states];
        taylor.series(time, &state, &PARAMETERS, &mut emitted, &mut workspace);
        for (index, (emitted, interpreted)) in emitted.iter().zip(&interpreted).enumerate() {
            let error = (emitted - interpreted).abs();
            let (order, entry) = (index / states, index % states);
            // Sums of many terms that nearly cancel agree to their largest term.
            let size = interpreted.abs().max(1e-3);
            let name = &model.name;
            assert!(
                error <= 1e-11 * size,
                "{name}, order {order} of state {entry}: {emitted:e} emitted, {interpreted:e} interpreted"
            );
        }
    }
}

#[test]
fn emitted_series_are_the_interpreted_ones() {
    assert_emitted_as_interpreted(&every_recurrence::Recurrences, &support::recurrences());
    assert_emitted_as_interpreted(&coupled::Coupled, &support::coupled());
    assert_emitted_as_interpreted(&pendulum::Pendulum, &support::pendulum());
}

#[test]
fn a_mass_matrix_that_couples_and_moves_is_solved_at_every_order() {
    let tape = recurrences(&support::coupled());
    let mass = tape.mass_matrix.expect("the matrix is kept");
    assert_eq!(mass.lower.len(), 3);
    let quotients =
        tape.nodes.iter().filter(|node| matches!(node.recurrence, Recurrence::Quotient(..)));
    assert_eq!(quotients.count(), 0, "nothing is divided by but the matrix");
    assert!(recurrences(&support::pendulum()).mass_matrix.is_none());
}

#[test]
fn functions_of_opposite_differences_are_formed_once() {
    let tape = recurrences(&support::coupled());
    let functions =
        tape.nodes.iter().filter(|node| matches!(node.recurrence, Recurrence::Integral { .. }));
    assert_eq!(functions.count(), 6, "sine and cosine of both angles and of their difference");
}

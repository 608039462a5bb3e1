//! An interpreted program equals the emitted simulator.

#[path = "../codegen/tests/support/mod.rs"]
mod support;

#[allow(dead_code, reason = "tests need not use all")]
mod emitted {
    include!("../codegen/tests/emitted/pendulum.rs");
}

use emitted::Pendulum;
use machinist_contract::{Describe, Simulator};
use machinist_model::ModelSimulator;

/// Returns times, states and parameters between the table's knots and beyond its ends.
fn inputs() -> impl Iterator<Item = (f64, [f64; 3], [f64; 6])> {
    (0..200_u32).map(|index| {
        let x = f64::from(index) * 0.37;
        let state = [x.sin() * 3.0, x.cos() * 20.0, (2.0 * x).sin() * 100.0];
        let parameters = [4.2, 0.75 + x, 9.80665, 0.1 * x, 1e-2 + x, 0.1 * x.cos()];
        (x / 20.0 - 0.5, state, parameters)
    })
}

fn filled(length: usize, write: impl FnOnce(&mut [f64])) -> Vec<u64> {
    let mut values = vec![f64::NAN; length];
    write(&mut values);
    values.into_iter().map(f64::to_bits).collect()
}

/// Returns everything that a simulator computes, as bits.
fn numbers(s: &impl Simulator<f64>, (t, y, p): &(f64, [f64; 3], [f64; 6])) -> Vec<Vec<u64>> {
    let (energy, balance) = (s.energy(*t, y, p), s.power_balance(*t, y, p));
    let energy = [energy.kinetic, energy.potential, energy.stored];
    let balance = [balance.stored_rate, balance.supplied, balance.dissipated];
    let nonzeros = s.rate_jacobian_pattern().entries.len();
    let parameter_nonzeros = s.parameter_jacobian_pattern().entries.len();
    vec![
        filled(3, |values| s.initial_state(p, values)),
        filled(1, |values| s.discontinuities(p, values)),
        filled(3, |values| s.rate(*t, y, p, values)),
        filled(nonzeros, |values| s.rate_jacobian(*t, y, p, values)),
        filled(parameter_nonzeros, |values| s.parameter_jacobian(*t, y, p, values)),
        filled(3, |values| s.time_derivative(*t, y, p, values)),
        filled(1, |values| s.mass_matrix(*t, y, p, values)),
        filled(1, |values| s.forcing(*t, y, p, values)),
        filled(2, |values| s.outputs(*t, y, p, values)),
        energy.map(f64::to_bits).to_vec(),
        balance.map(f64::to_bits).to_vec(),
    ]
}

#[test]
fn an_interpreted_program_computes_what_emitted_code_computes() {
    let interpreted = ModelSimulator::new(support::pendulum());
    for inputs in inputs() {
        assert_eq!(numbers(&interpreted, &inputs), numbers(&Pendulum, &inputs), "{inputs:?}");
    }
}

#[test]
fn an_interpreted_program_describes_itself_as_emitted_code_does() {
    let interpreted = ModelSimulator::new(support::pendulum());
    let shape = Pendulum.shape();
    assert_eq!(interpreted.shape(), shape);
    assert_eq!(interpreted.name(), Pendulum.name());
    assert_eq!(interpreted.title(), Pendulum.title());
    assert_eq!(interpreted.run_defaults(), Pendulum.run_defaults());
    assert_eq!(interpreted.rate_jacobian_pattern(), Pendulum.rate_jacobian_pattern());
    assert_eq!(interpreted.parameter_jacobian_pattern(), Pendulum.parameter_jacobian_pattern());
    assert_eq!(interpreted.mass_matrix_pattern(), Pendulum.mass_matrix_pattern());
    for index in 0..shape.states() {
        assert_eq!(interpreted.state(index), Pendulum.state(index));
        let scales = [interpreted.state_scale(index), Pendulum.state_scale(index)];
        assert_eq!(scales[0].to_bits(), scales[1].to_bits());
    }
    for index in 0..shape.parameters {
        assert_eq!(interpreted.parameter(index), Pendulum.parameter(index));
    }
    for index in 0..shape.outputs {
        assert_eq!(interpreted.output(index), Pendulum.output(index));
    }
}

#[test]
#[should_panic(expected = "length of the state")]
fn a_state_of_another_length_is_refused() {
    let interpreted = ModelSimulator::new(support::pendulum());
    interpreted.rate(0.0, &[0.0; 4], &[1.0; 6], &mut [0.0; 3]);
}

/// Machine code is called again without checking the lengths of its inputs as long as they are
/// unchanged.
#[test]
fn lengths_are_checked_at_later_calls_as_at_the_first() {
    let simulator = ModelSimulator::new(support::pendulum());
    let constants = Simulator::<f64>::constants(&simulator);
    let call = |state: usize, parameters: usize, constants: usize, results: usize| {
        let call = || {
            let (state, parameters) = (vec![0.3; state], vec![1.5; parameters]);
            filled(results, |values| {
                simulator.prepared_rate(0.1, &state, &parameters, &vec![0.7; constants], values);
            })
        };
        std::panic::catch_unwind(std::panic::AssertUnwindSafe(call)).ok()
    };
    let first = call(3, 6, constants, 3);
    assert!(first.is_some());
    for (state, parameters, results) in [(2, 6, 3), (4, 6, 3), (3, 5, 3), (3, 7, 3), (3, 6, 2)] {
        assert_eq!(call(state, parameters, constants, results), None);
        assert_eq!(call(3, 6, constants, 3), first);
    }
    assert_eq!(call(3, 6, constants + 5, 3), first);
    assert_eq!(call(3, 6, 0, 3).is_some(), constants == 0);
}

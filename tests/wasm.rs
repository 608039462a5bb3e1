//! Machines as run by web pages compared with interpreted ones, to the last bit where the host uses
//! our own functions.

#[path = "../crates/model/tests/support/hosted.rs"]
mod hosted;

use hosted::Hosted;
use machinist_codegen::mechanics::reduce::Keep;
use machinist_contract::Simulator;
use machinist_model::ModelSimulator;
use machinist_model::functions::FUNCTIONS;
use machinist_model::wasm::module;

use crate::own_scene::model_of_specs;

/// A motor, events and branches, tables, constraints, constraints in modes, a prescribed motion
/// that solves for the Jacobian, parts of the library.
const SCENES: [&str; 10] = [
    "saw_gin",
    "winder_full",
    "stick_slip",
    "contact_oscillator_smooth",
    "pendulum_chain",
    "slider_crank",
    "winder_linkage",
    "winder_holder_drop",
    "drives/winch",
    "drives/press",
];

#[test]
fn every_function_of_a_machine_gives_the_same_bits() {
    for name in SCENES {
        let model = model_of_specs(name, Keep::Needed);
        let all = FUNCTIONS.map(|row| row.id);
        let mut hosted =
            Hosted::new(module(&model, &all).unwrap_or_else(|e| panic!("{name}: {e}")));
        let simulator = ModelSimulator::interpreted(model.clone());
        for sample in 0..6_usize {
            let value = |index: usize| ((index * 7 + sample) as f64 * 0.37).sin();
            let varied = |(index, parameter): (usize, &machinist_model::Parameter)| {
                parameter.value * (1.0 + 0.1 * value(index))
            };
            let p: Vec<f64> = model.parameters.iter().enumerate().map(varied).collect();
            let state =
                |(index, state): (usize, &machinist_model::State)| value(index) * state.scale;
            let y: Vec<f64> = model.states.iter().enumerate().map(state).collect();
            let t = 0.02 * sample as f64;
            hosted.set(&p);
            for row in model.functions() {
                let count = (row.results)(&model);
                let found = hosted.results(row.name, t, &y, count);
                let expected = expected(&simulator, row.name, (t, &y, &p), count);
                assert_same(&format!("{name}: {}", row.name), &found, &expected);
            }
        }
    }
}

pub(crate) fn assert_same(what: &str, found: &[f64], expected: &[f64]) {
    // Signed zeros count as equal: a substitution may change their signs.
    let bits = |value: f64| (value + 0.0).to_bits();
    for (index, (a, b)) in found.iter().zip(expected).enumerate() {
        let is_same = bits(*a) == bits(*b) || (a.is_nan() && b.is_nan());
        assert!(is_same, "{what}: {index} is {a:e} and should be {b:e}");
    }
}

/// Returns the results of a simulator for a function of the table, by its name.
pub(crate) fn expected(
    s: &dyn Simulator<f64>,
    function: &str,
    (t, y, p): (f64, &[f64], &[f64]),
    count: usize,
) -> Vec<f64> {
    let mut values = vec![0.0; count];
    let v = &mut values[..];
    match function {
        "initial_state" => s.initial_state(p, v),
        "discontinuities" => s.discontinuities(p, v),
        "rate" => s.rate(t, y, p, v),
        "mass_matrix" => s.mass_matrix(t, y, p, v),
        "forcing" => s.forcing(t, y, p, v),
        "rate_jacobian" => s.rate_jacobian(t, y, p, v),
        "parameter_jacobian" => s.parameter_jacobian(t, y, p, v),
        "time_derivative" => s.time_derivative(t, y, p, v),
        "outputs" => s.outputs(t, y, p, v),
        "energy" => {
            let energy = s.energy(t, y, p);
            v.copy_from_slice(&[energy.kinetic, energy.potential, energy.stored]);
        }
        "power_balance" => {
            let power = s.power_balance(t, y, p);
            v.copy_from_slice(&[power.stored_rate, power.supplied, power.dissipated]);
        }
        "guards" => s.guards(t, y, p, v),
        "guard_rates" => s.guard_rates(t, y, p, v),
        "resets" => s.resets(t, y, p, v),
        "constraint_values" => s.constraint_values(t, y, p, v),
        "constraint_rates" => s.constraint_rates(t, y, p, v),
        "constraint_matrix" => s.constraint_matrix(t, y, p, v),
        "kink_guards" => s.kink_guards(t, y, p, v),
        "kink_rates" => s.kink_rates(t, y, p, v),
        "saturating_arguments" => s.saturating_arguments(t, y, p, v),
        other => panic!("a new function: {other}"),
    }
    values
}

//! Hashes that distinguish machines.

use machinist_contract::Simulator;
use sha2::{Digest, Sha256};

/// Returns the SHA-256 of bytes, in hexadecimal.
#[must_use]
pub fn of_bytes(bytes: &[u8]) -> String {
    hex(&Sha256::digest(bytes))
}

/// Returns a hash of a machine's description and behaviour: names, units, defaults, and rates and
/// outputs at the start and some other states, to the last bit.
#[must_use]
pub fn of_behaviour(simulator: &dyn Simulator<f64>) -> String {
    let shape = simulator.shape();
    let mut hash = Sha256::new();
    let mut add = |bytes: &[u8]| {
        hash.update((bytes.len() as u64).to_le_bytes());
        hash.update(bytes);
    };
    add(simulator.name().as_bytes());
    let parameters: Vec<f64> =
        (0..shape.parameters).map(|index| simulator.parameter_default(index)).collect();
    for (index, value) in parameters.iter().enumerate() {
        let quantity = simulator.parameter(index);
        add(quantity.name.as_bytes());
        add(quantity.unit.as_bytes());
        add(&value.to_le_bytes());
    }
    let named = (0..shape.states()).map(|index| simulator.state(index));
    for quantity in named.chain((0..shape.outputs).map(|index| simulator.output(index))) {
        add(quantity.name.as_bytes());
        add(quantity.unit.as_bytes());
    }
    let mut start = vec![0.0; shape.states()];
    simulator.initial_state(&parameters, &mut start);
    for point in 0..8 {
        let shift = |index: usize| {
            let share = f64::from((7 * index as u32 + 5 * point) % 11) / 11.0;
            f64::from(point) * 0.1 * (share - 0.4) * simulator.state_scale(index)
        };
        let state: Vec<f64> = start.iter().enumerate().map(|(k, y)| y + shift(k)).collect();
        let time = simulator.run_defaults().from + 0.3 * f64::from(point);
        let mut values = vec![0.0; shape.states() + shape.outputs];
        let (rate, outputs) = values.split_at_mut(shape.states());
        simulator.rate(time, &state, &parameters, rate);
        simulator.outputs(time, &state, &parameters, outputs);
        for value in values {
            add(&value.to_le_bytes());
        }
    }
    hex(&hash.finalize())
}

fn hex(bytes: &[u8]) -> String {
    let digit = |value: u8| char::from_digit(u32::from(value), 16).unwrap_or_default();
    bytes.iter().flat_map(|byte| [digit(byte >> 4), digit(byte & 15)]).collect()
}

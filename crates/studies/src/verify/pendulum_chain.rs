//! Checks of three pendulums hanging on one another against equations written by hand,
//! and of their energy.

use super::machine::{Point, SplitMix};
use super::sensitivities::{SMOOTH, against_complex_runs};
use super::{Check, CheckFailure, Machine, Measured, worse};
use crate::closed_form::pendulum_chain::CHAIN;

pub(super) const CHECKS: &[Check] = &[
    Check {
        name: "accelerations at 1000 random states",
        reference: "balance of forces across each link, relative to the state's largest",
        tolerance: 1e-12,
        reason: "rounding, grown by a mass matrix that loses up to three of sixteen digits",
        measure: accelerations,
    },
    Check {
        name: "energy over 5 s",
        reference: "its start, relative to the largest in motion",
        tolerance: 1e-9,
        reason: "the run is held to 1e-12 a step",
        measure: energy,
    },
    Check {
        name: "sensitivities over 1 s",
        reference: "runs on numbers that carry derivatives, over the largest of each",
        tolerance: 1e-8,
        reason: SMOOTH,
        measure: |machine| {
            let by = ["chain.m_1", "chain.m_2", "chain.l_1", "chain.l_3", "chain.gravity"];
            against_complex_runs(machine, &by, 1.0)
        },
    },
];

const ANGLES: [&str; 3] = ["chain.th_1", "chain.th_2", "chain.th_3"];
const SPEEDS: [&str; 3] = ["chain.w_1", "chain.w_2", "chain.w_3"];

/// Compares accelerations at any angles, with speeds up to 8 rad/s.
fn accelerations(machine: &Machine) -> Result<Measured, CheckFailure> {
    let parameters = machine.parameters(&[])?;
    let (mut angle_at, mut speed_at) = ([0; 3], [0; 3]);
    for link in 0..3 {
        angle_at[link] = machine.state_index(ANGLES[link])?;
        speed_at[link] = machine.state_index(SPEEDS[link])?;
    }
    let mut random = SplitMix(3);
    let mut error = 0.0;
    for _ in 0..1000 {
        let angles: [f64; 3] = std::array::from_fn(|_| std::f64::consts::PI * random.signed());
        let speeds: [f64; 3] = std::array::from_fn(|_| 8.0 * random.signed());
        let mut state = vec![0.0; machine.real.shape().states()];
        for link in 0..3 {
            state[angle_at[link]] = angles[link];
            state[speed_at[link]] = speeds[link];
        }
        let rate = machine.rate(&Point { time: 0.0, state, parameters: parameters.clone() });
        let hand = CHAIN.accelerations(angles, speeds);
        let largest = hand.iter().fold(0.0, |most, value| worse(most, value.abs()));
        for (place, by_hand) in speed_at.iter().zip(hand) {
            error = worse(error, (rate[*place] - by_hand).abs() / largest);
        }
    }
    Ok(Measured::error(error))
}

fn energy(machine: &Machine) -> Result<Measured, CheckFailure> {
    let run = machine.precise(&[], 5.0)?.with_energy_balance(true).run()?;
    let energy = machine.column(&run, "energy.total")?;
    let drift = energy.iter().fold(0.0, |most, value| worse(most, (value - energy[0]).abs()));
    let active = run.energy_balance.as_ref().map_or(f64::NAN, |balance| balance.largest_active);
    Ok(Measured::error(drift / active))
}

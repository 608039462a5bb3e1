//! Checks of the saw gin against its equations written by hand and against the
//! converged reference of its run.

use super::machine::{Point, SplitMix};
use super::reference::{SAW_GIN, scaled_distance};
use super::sensitivities::{SMOOTH, against_complex_runs};
use super::{Check, CheckFailure, Machine, Measured, worse};
use crate::closed_form::induction_motor::MOTOR_4A280M8;
use crate::closed_form::saw_gin_by_hand::{SawGinByHand, SawGinState};
use machinist::linear_analysis::Place;

pub(super) const CHECKS: &[Check] = &[
    Check {
        name: "right-hand side at 1000 random states",
        reference: "equations written by hand, relative to the largest term of each sum",
        tolerance: 1e-13,
        reason: "terms of some ten factors, summed in another order: some tens of roundings of \
                 1.1e-16",
        measure: right_hand_side,
    },
    Check {
        name: "run-up and loading, state after 2 s",
        reference: "converged reference, root mean square of scaled differences",
        tolerance: 1e-9,
        reason: "the reference is exact to 16 digits; a hundred times the tolerance of a step",
        measure: run,
    },
    Check {
        name: "operating point under load, by the equilibrium solve",
        reference: "torque of the closed form at the slip found, and the coupling's torque; relative",
        tolerance: 1e-10,
        reason: "Newton's method ends at rounding; the slip of 0.02 loses two digits of the speed",
        measure: operating_point,
    },
    Check {
        name: "sensitivities over 0.3 s of run-up",
        reference: "runs on numbers that carry derivatives, over the largest of each",
        tolerance: 1e-8,
        reason: SMOOTH,
        measure: |machine| {
            let by = [
                "coupling.stiffness",
                "coupling.damping",
                "motor.inertia",
                "cylinder.inertia",
                "motor.phase_voltage",
                "motor.supply_frequency",
                "motor.k_s",
                "motor.x_s",
                "motor.alpha_r",
            ];
            against_complex_runs(machine, &by, 0.3)
        },
    },
];

/// States that the emitted equations have in common with those by hand, in the order of
/// [`SawGinByHand::rate`]; the twist is the difference of both angles there.
const SHARED: [(&str, usize); 6] = [
    ("motor.psi_sx", 0),
    ("motor.psi_sy", 1),
    ("motor.psi_rx", 2),
    ("motor.psi_ry", 3),
    ("motor.omega", 5),
    ("cylinder.omega", 7),
];
const TWIST: &str = "coupling.twist";
const ANGLES: [usize; 2] = [4, 6];

fn right_hand_side(machine: &Machine) -> Result<Measured, CheckFailure> {
    let parameters = machine.parameters(&[])?;
    let places = SHARED.map(|(name, by_hand)| Ok((machine.state_index(name)?, by_hand)));
    let places = places.into_iter().collect::<Result<Vec<_>, CheckFailure>>()?;
    let twist = machine.state_index(TWIST)?;
    let mut random = SplitMix(8);
    let mut error = 0.0;
    for number in 0..1000 {
        let (time, hand) = random_state(&mut random, number);
        let mut state = vec![0.0; machine.real.shape().states()];
        let values = [hand.flux.as_slice(), &hand.motor, &hand.cylinder].concat();
        for (place, by_hand) in &places {
            state[*place] = values[*by_hand];
        }
        state[twist] = hand.motor[0] - hand.cylinder[0];
        let rate = machine.rate(&Point { time, state, parameters: parameters.clone() });
        let sums = SawGinByHand.rate(time, &hand);
        for (place, by_hand) in &places {
            let sum = sums[*by_hand];
            error = worse(error, (rate[*place] - sum.value).abs() / sum.largest_term);
        }
        let [driving, driven] = ANGLES.map(|by_hand| sums[by_hand]);
        let largest = driving.largest_term.max(driven.largest_term);
        error = worse(error, (rate[twist] - (driving.value - driven.value)).abs() / largest);
    }
    Ok(Measured::error(error))
}

/// Returns a random state: half of them have a twist as in a run, half have any; every fourth is
/// near standstill, where the load changes its sign.
fn random_state(random: &mut SplitMix, number: usize) -> (f64, SawGinState) {
    let time = 2.0 * random.unit();
    let speed = if number.is_multiple_of(4) { 1.0 } else { 100.0 };
    let twist = if number.is_multiple_of(2) { 0.1 } else { 100.0 };
    let flux = std::array::from_fn(|_| 1.2 * random.signed());
    let motor = [150.0 * random.unit(), speed * random.signed()];
    let cylinder = [motor[0] + twist * random.signed(), speed * random.signed()];
    (time, SawGinState { flux, motor, cylinder })
}

fn run(machine: &Machine) -> Result<Measured, CheckFailure> {
    let trajectory = machine.simulation(&[])?.until(2.0).points(2).rtol(1e-11).run()?;
    Ok(Measured::error(scaled_distance(machine, &trajectory, SAW_GIN)?))
}

/// Checks that motor, coupling and load carry the torque of the motor's curve.
fn operating_point(machine: &Machine) -> Result<Measured, CheckFailure> {
    let point = Machine::point_of(&machine.linearization(&[], Place::Equilibrium)?);
    let speed = point.state[machine.state_index("motor.omega")?];
    let expected = MOTOR_4A280M8.torque(MOTOR_4A280M8.slip(speed));
    let mut error = 0.0;
    for torque in ["motor_torque", "coupling_torque"] {
        error = worse(error, (machine.output(&point, torque)? / expected - 1.0).abs());
    }
    Ok(Measured::error(error))
}

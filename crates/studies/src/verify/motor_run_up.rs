//! Checks of the motor against its exact solution at constant speed, its torque
//! curve, and the converged reference of its run-up.

use num_complex::Complex64;

use super::reference::{MOTOR_RUN_UP, scaled_distance};
use super::sensitivities::{SMOOTH, against_complex_runs};
use super::{Check, CheckFailure, Machine, Measured, relative_distance, worse};
use crate::closed_form::induction_motor::{Flux, MOTOR_4A280M8};
use machinist::linear_analysis::{Mode, Place};

const FLUX: [&str; 4] = ["motor.psi_sx", "motor.psi_sy", "motor.psi_rx", "motor.psi_ry"];
const TWO_EXPONENTIALS: &str = "two complex exponentials, relative to the largest flux linkage";
const HELD_TO_1E_12: &str =
    "the run is held to 1e-12 a step; the inertia of 1e30 kg m^2 lets speed change by 1e-27";
const HALF_A_DIGIT: &str = "half of the last digit stated";

pub(super) const CHECKS: &[Check] = &[
    Check {
        name: "flux transient at standstill",
        reference: TWO_EXPONENTIALS,
        tolerance: 1e-9,
        reason: HELD_TO_1E_12,
        measure: |machine| flux_transient(machine, 0.0),
    },
    Check {
        name: "flux transient at 40 rad/s",
        reference: TWO_EXPONENTIALS,
        tolerance: 1e-9,
        reason: HELD_TO_1E_12,
        measure: |machine| flux_transient(machine, 40.0),
    },
    Check {
        name: "flux transient at 76.97 rad/s",
        reference: TWO_EXPONENTIALS,
        tolerance: 1e-9,
        reason: HELD_TO_1E_12,
        measure: |machine| flux_transient(machine, 76.97),
    },
    Check {
        name: "torque-speed curve at 50 slips",
        reference: "closed form, relative",
        tolerance: 1e-12,
        reason: "both are algebra; solving the flux equations loses less than four of sixteen digits",
        measure: torque_curve,
    },
    Check {
        name: "torque at slip 0.02",
        reference: "954.6866 N m",
        tolerance: 5e-5,
        reason: HALF_A_DIGIT,
        measure: |machine| Ok(Measured::absolute(torque_at_slip(machine, 0.02)?, 954.6866)),
    },
    Check {
        name: "breakdown torque",
        reference: "2034.2546 N m",
        tolerance: 5e-5,
        reason: HALF_A_DIGIT,
        measure: |machine| Ok(Measured::absolute(breakdown(machine)?.1, 2034.2546)),
    },
    Check {
        name: "breakdown slip",
        reference: "0.085243",
        tolerance: 5e-7,
        reason: HALF_A_DIGIT,
        measure: |machine| Ok(Measured::absolute(breakdown(machine)?.0, 0.085_243)),
    },
    Check {
        name: "starting torque",
        reference: "373.5342 N m",
        tolerance: 5e-5,
        reason: HALF_A_DIGIT,
        measure: |machine| Ok(Measured::absolute(torque_at_slip(machine, 1.0)?, 373.5342)),
    },
    Check {
        name: "current, power factor and efficiency at slip 0.02",
        reference: "closed form of the steady fluxes, each relative",
        tolerance: 1e-10,
        reason: "both are algebra",
        measure: rated,
    },
    Check {
        name: "no-load speed after 3 s",
        reference: "2 pi 50/4 rad/s",
        tolerance: 1e-6,
        reason: "without load the speed ends where torque vanishes; after 3 s the slowest \
                 transient has faded well below",
        measure: no_load_speed,
    },
    Check {
        name: "run-up, state after 1 s",
        reference: "converged reference, root mean square of scaled differences",
        tolerance: 1e-9,
        reason: "the reference is exact to 16 digits; a hundred times the tolerance of a step",
        measure: run_up,
    },
    Check {
        name: "operating point without load, by the equilibrium solve",
        reference: "speed and flux linkages where the torque curve crosses zero, each relative",
        tolerance: 1e-10,
        reason: "Newton's method ends at rounding",
        measure: operating_point,
    },
    Check {
        name: "eigenvalues at constant speeds",
        reference: "the two complex eigenvalues of the closed form at 0, 40 and 76.97 rad/s, relative",
        tolerance: 1e-12,
        reason: "emitted Jacobian and dense algebra of six states, near rounding",
        measure: eigenvalues,
    },
    Check {
        name: "sensitivities over 0.4 s of run-up",
        reference: "runs on numbers that carry derivatives, over the largest of each",
        tolerance: 1e-8,
        reason: SMOOTH,
        measure: |machine| {
            let by = ["motor.inertia", "motor.k_r", "motor.x_s", "motor.alpha_s", "motor.alpha_r"];
            against_complex_runs(machine, &by, 0.4)
        },
    },
];

/// Returns the largest distance of the flux linkages from the closed form over 0.3 s after
/// switching on at constant speed.
fn flux_transient(machine: &Machine, speed: f64) -> Result<Measured, CheckFailure> {
    let settings = [("motor.inertia", 1e30), ("initial_speed", speed)];
    let trajectory = machine.precise(&settings, 0.3)?.points(301).run()?;
    let slip = MOTOR_4A280M8.slip(speed);
    let exact: Vec<Flux> = trajectory
        .times
        .iter()
        .map(|time| MOTOR_4A280M8.flux(*time, Flux::default(), slip))
        .collect();
    let parts: [fn(&Flux) -> f64; 4] =
        [|f| f.stator.re, |f| f.stator.im, |f| f.rotor.re, |f| f.rotor.im];
    let mut ours = Vec::new();
    let mut reference = Vec::new();
    for (name, part) in FLUX.iter().zip(parts) {
        ours.extend_from_slice(machine.column(&trajectory, name)?);
        reference.extend(exact.iter().map(part));
    }
    Ok(Measured::error(relative_distance(&ours, &reference)))
}

/// Compares torques at slips from -0.98 to 0.98 in steps of 0.04.
fn torque_curve(machine: &Machine) -> Result<Measured, CheckFailure> {
    let mut error = 0.0;
    for k in 1..=50 {
        let slip = (f64::from(k) - 25.5) / 25.0;
        let expected = MOTOR_4A280M8.torque(slip);
        let ours = torque_at_slip(machine, slip)?;
        error = worse(error, ((ours - expected) / expected).abs());
    }
    Ok(Measured::error(error))
}

/// Returns the steady torque of the emitted equations at a slip \[N m\].
pub(crate) fn torque_at_slip(machine: &Machine, slip: f64) -> Result<f64, CheckFailure> {
    let settings = [("motor.omega", MOTOR_4A280M8.speed(slip))];
    let point = machine.steady_point(&[], &settings, &FLUX)?;
    machine.output(&point, "torque")
}

/// Compares current, cos phi and efficiency from the emitted equations: outputs and the power
/// balance.
fn rated(machine: &Machine) -> Result<Measured, CheckFailure> {
    let exact = MOTOR_4A280M8.load_point(0.02);
    let speed = MOTOR_4A280M8.speed(0.02);
    let point = machine.steady_point(&[], &[("motor.omega", speed)], &FLUX)?;
    let current = machine.output(&point, "stator_current")?;
    let supplied = machine.real.power_balance(point.time, &point.state, &point.parameters).supplied;
    let apparent = 1.5 * 2.0_f64.sqrt() * 220.0 * current;
    let shaft = machine.output(&point, "torque")? * speed;
    let pairs = [
        (current / 2.0_f64.sqrt(), exact.current),
        (supplied / apparent, exact.power_factor),
        (shaft / supplied, exact.efficiency()),
    ];
    Ok(Measured::error(pairs.iter().fold(0.0, |most, (a, b)| worse(most, (a / b - 1.0).abs()))))
}

/// Returns breakdown slip and torque of the emitted equations.
fn breakdown(machine: &Machine) -> Result<(f64, f64), CheckFailure> {
    maximum(0.01, 0.5, |slip| torque_at_slip(machine, slip))
}

/// Returns place and value of the maximum of a function with one maximum between two places, by
/// golden section search until the places differ by 1e-9. The error of the value is of second order
/// in that.
pub(crate) fn maximum<E>(
    mut low: f64,
    mut high: f64,
    function: impl Fn(f64) -> Result<f64, E>,
) -> Result<(f64, f64), E> {
    let golden = (5.0_f64.sqrt() - 1.0) / 2.0;
    while high - low > 1e-9 {
        let (left, right) = (high - golden * (high - low), low + golden * (high - low));
        if function(left)? < function(right)? {
            low = left;
        } else {
            high = right;
        }
    }
    let place = f64::midpoint(low, high);
    Ok((place, function(place)?))
}

fn no_load_speed(machine: &Machine) -> Result<Measured, CheckFailure> {
    let trajectory = machine.simulation(&[])?.until(3.0).points(2).rtol(1e-10).run()?;
    let ours = machine.last(&trajectory, "motor.omega")?;
    Ok(Measured::absolute(ours, MOTOR_4A280M8.synchronous_speed()))
}

fn run_up(machine: &Machine) -> Result<Measured, CheckFailure> {
    let trajectory = machine.simulation(&[])?.until(1.0).points(2).rtol(1e-11).run()?;
    Ok(Measured::error(scaled_distance(machine, &trajectory, MOTOR_RUN_UP)?))
}

fn operating_point(machine: &Machine) -> Result<Measured, CheckFailure> {
    let linearization = machine.linearization(&[], Place::Equilibrium)?;
    let state = &linearization.point().state;
    let flux = MOTOR_4A280M8.steady_flux(0.0);
    let ours = FLUX
        .iter()
        .map(|name| Ok(state[machine.state_index(name)?]))
        .collect::<Result<Vec<f64>, CheckFailure>>()?;
    let exact = [flux.stator.re, flux.stator.im, flux.rotor.re, flux.rotor.im];
    let speed = state[machine.state_index("motor.omega")?] / MOTOR_4A280M8.synchronous_speed();
    Ok(Measured::error(worse(relative_distance(&ours, &exact), (speed - 1.0).abs())))
}

/// Compares eigenvalues. With an inertia of 1e30 kg m^2 those of the fluxes are separate from that
/// of the speed. The four eigenvalues of the real system are those of the complex equations and
/// their conjugates.
fn eigenvalues(machine: &Machine) -> Result<Measured, CheckFailure> {
    let mut error = 0.0;
    for speed in [0.0, 40.0, 76.97] {
        let settings = [("motor.inertia", 1e30), ("initial_speed", speed)];
        let modes = machine.linearization(&settings, Place::Initial)?.modes()?;
        for exact in MOTOR_4A280M8.eigenvalues(MOTOR_4A280M8.slip(speed)) {
            let exact = Complex64::new(exact.re, exact.im.abs());
            let distance = |mode: &Mode| (mode.eigenvalue() - exact).norm() / exact.norm();
            error = worse(error, modes.iter().map(distance).fold(f64::INFINITY, f64::min));
        }
    }
    Ok(Measured::error(error))
}

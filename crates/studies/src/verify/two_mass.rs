//! Checks of two rotors on a coupling against the damped oscillator solved exactly.

use std::f64::consts::PI;

use num_complex::Complex64;

use super::sensitivities::{ClosedForm, SMOOTH, of_closed_form};
use super::{Check, CheckFailure, Machine, Measured, relative_distance, worse};
use crate::closed_form::Number;
use crate::closed_form::two_mass::{Motion, SAW_GIN, Torques};
use machinist::Trajectory;
use machinist::linear_analysis::{Mode, ModeKind, Place, logarithmic_range};

const NEAR_ROUNDING: &str =
    "the run is held to 1e-12 a step; some thousand steps add their errors up";

pub(super) const CHECKS: &[Check] = &[
    Check {
        name: "free decay from a twist of 0.01 rad",
        reference: "closed form of speeds and twist, each relative to its largest",
        tolerance: 1e-9,
        reason: NEAR_ROUNDING,
        measure: free_decay,
    },
    Check {
        name: "transient under constant torques",
        reference: "closed form of speeds and twist, each relative to its largest",
        tolerance: 1e-9,
        reason: NEAR_ROUNDING,
        measure: constant_torques,
    },
    Check {
        name: "transient under a harmonic load",
        reference: "closed form of speeds and twist, each relative to its largest",
        tolerance: 1e-9,
        reason: NEAR_ROUNDING,
        measure: harmonic_transient,
    },
    Check {
        name: "amplitude of the steady harmonic twist",
        reference: "closed form, relative",
        tolerance: 1e-9,
        reason: NEAR_ROUNDING,
        measure: harmonic_amplitude,
    },
    Check {
        name: "phase of the steady harmonic twist",
        reference: "closed form, rad",
        tolerance: 1e-9,
        reason: NEAR_ROUNDING,
        measure: harmonic_phase,
    },
    Check {
        name: "static twist under constant torques",
        reference: "(Md J2 + M Jd)/(c (Jd + J2)), relative",
        tolerance: 1e-9,
        reason: "the transient has faded to e^-67; what is left is the error of the run",
        measure: static_twist,
    },
    Check {
        name: "natural frequency of the coupling",
        reference: "sqrt(c/Jr), 155.03 rad/s, relative",
        tolerance: 1e-10,
        reason: ALGEBRA,
        measure: |machine| {
            let value = swing(machine)?.natural_frequency();
            Ok(Measured::relative(value, SAW_GIN.natural_frequency()))
        },
    },
    Check {
        name: "damping ratio of the coupling",
        reference: "b/(2 sqrt(c Jr)), 0.432, relative",
        tolerance: 1e-10,
        reason: ALGEBRA,
        measure: |machine| {
            let value = swing(machine)?.damping_ratio();
            Ok(Measured::relative(value, SAW_GIN.damping_ratio()))
        },
    },
    Check {
        name: "twist at constant speed, by the equilibrium solve",
        reference: "M/c, relative",
        tolerance: 1e-10,
        reason: ALGEBRA,
        measure: equilibrium_twist,
    },
    Check {
        name: "frequency response of the twist to the load",
        reference: "closed form at 61 frequencies from 1 to 1e4 rad/s, each relative",
        tolerance: 1e-9,
        reason: "one linear solve a frequency; outputs differentiated to about 1e-12",
        measure: frequency_response,
    },
    Check {
        name: "sensitivities of the free decay",
        reference: "derivative of the closed form, over the largest of each",
        tolerance: 1e-8,
        reason: SMOOTH,
        measure: slopes_of_decay,
    },
    Check {
        name: "sensitivities under a harmonic load",
        reference: "derivative of the closed form, over the largest of each",
        tolerance: 1e-8,
        reason: SMOOTH,
        measure: slopes_of_harmonic,
    },
];

const ALGEBRA: &str = "emitted Jacobian and dense algebra of four states, near rounding";
/// Balanced torques, for which an equilibrium exists.
const BALANCED: [(&str, f64); 1] = [("drive_torque", 843.72)];

const LOAD_FREQUENCY: f64 = 241.8051;
const CONSTANT: Torques = Torques {
    driving: 974.4,
    load: 843.72,
    load_amplitude: 0.0,
    load_frequency: LOAD_FREQUENCY,
    load_phase: 0.0,
};

fn free_decay(machine: &Machine) -> Result<Measured, CheckFailure> {
    let settings = [("drive_torque", 0.0), ("load_torque", 0.0), ("initial_twist", 0.01)];
    let start = Motion { driver_angle: 0.01, ..Motion::default() };
    distance(machine, &settings, start, Torques::default())
}

fn constant_torques(machine: &Machine) -> Result<Measured, CheckFailure> {
    distance(machine, &[], Motion::default(), CONSTANT)
}

fn harmonic_transient(machine: &Machine) -> Result<Measured, CheckFailure> {
    let settings = [("load_amplitude", 78.78), ("initial_twist_rate", 1.0)];
    let start = Motion { driver_speed: 1.0, ..Motion::default() };
    distance(machine, &settings, start, Torques { load_amplitude: 78.78, ..CONSTANT })
}

/// Returns the largest distance over 0.2 s of any state from the closed form.
fn distance(
    machine: &Machine,
    settings: &[(&str, f64)],
    start: Motion,
    torques: Torques,
) -> Result<Measured, CheckFailure> {
    type Quantity = (&'static str, fn(&Motion) -> f64);
    let quantities: [Quantity; 3] = [
        ("driver.omega", |motion| motion.driver_speed),
        ("cylinder.omega", |motion| motion.driven_speed),
        ("twist", |motion| motion.twist().angle),
    ];
    let trajectory = machine.precise(settings, 0.2)?.points(401).run()?;
    let exact: Vec<Motion> =
        trajectory.times.iter().map(|time| SAW_GIN.motion(*time, start, torques)).collect();
    let mut error = 0.0;
    for (name, quantity) in quantities {
        let reference: Vec<f64> = exact.iter().map(quantity).collect();
        error = worse(error, relative_distance(machine.column(&trajectory, name)?, &reference));
    }
    Ok(Measured::error(error))
}

fn harmonic_amplitude(machine: &Machine) -> Result<Measured, CheckFailure> {
    let answer = SAW_GIN.harmonic_response(78.78, LOAD_FREQUENCY);
    Ok(Measured::relative(steady_harmonic(machine)?.norm(), answer.amplitude))
}

fn harmonic_phase(machine: &Machine) -> Result<Measured, CheckFailure> {
    let answer = SAW_GIN.harmonic_response(78.78, LOAD_FREQUENCY);
    Ok(Measured::absolute(-steady_harmonic(machine)?.arg(), answer.phase_lag))
}

/// Returns A e^(-j lag) of the twist A sin(w t - lag), by the Fourier sum over one period after 0.5
/// s, when the transient has decayed to e^-33 of its size.
///
/// Driving torque and mean load torque are equal, so speeds stay small.
fn steady_harmonic(machine: &Machine) -> Result<Complex64, CheckFailure> {
    const SAMPLES: u32 = 64;
    let settings = [("drive_torque", 843.72), ("load_amplitude", 78.78)];
    let period = 2.0 * PI / LOAD_FREQUENCY;
    let times: Vec<f64> =
        (0..SAMPLES).map(|k| 0.5 + period * f64::from(k) / f64::from(SAMPLES)).collect();
    let trajectory = machine.precise(&settings, 0.5 + period)?.times(&times).run()?;
    let twist = machine.column(&trajectory, "twist")?;
    let sum: Complex64 = times
        .iter()
        .zip(twist)
        .map(|(time, twist)| Complex64::from_polar(*twist, -LOAD_FREQUENCY * time))
        .sum();
    Ok(Complex64::i() * sum * 2.0 / f64::from(SAMPLES))
}

fn static_twist(machine: &Machine) -> Result<Measured, CheckFailure> {
    let trajectory: Trajectory = machine.precise(&[], 1.0)?.points(2).run()?;
    let expected = SAW_GIN.static_twist(CONSTANT.driving, CONSTANT.load);
    Ok(Measured::relative(machine.last(&trajectory, "twist")?, expected))
}

/// Returns the single oscillation.
fn swing(machine: &Machine) -> Result<Mode, CheckFailure> {
    let modes = machine.linearization(&BALANCED, Place::Equilibrium)?.modes()?;
    let found = modes.into_iter().find(|mode| mode.kind == ModeKind::Oscillation);
    found.ok_or(CheckFailure::NoOscillation)
}

fn equilibrium_twist(machine: &Machine) -> Result<Measured, CheckFailure> {
    let linearization = machine.linearization(&BALANCED, Place::Equilibrium)?;
    let twist = machine.output(&Machine::point_of(&linearization), "twist")?;
    Ok(Measured::relative(twist, SAW_GIN.static_twist(843.72, 843.72)))
}

fn frequency_response(machine: &Machine) -> Result<Measured, CheckFailure> {
    let linearization = machine.linearization(&BALANCED, Place::Equilibrium)?;
    let frequencies = logarithmic_range(1.0, 1e4, 61)?;
    let response = linearization.response("load_torque", "twist", &frequencies)?;
    let mut error = 0.0;
    for (index, frequency) in frequencies.iter().enumerate() {
        let exact = SAW_GIN.harmonic_response(1.0, *frequency);
        let exact = Complex64::from_polar(exact.amplitude, -exact.phase_lag);
        let ours = Complex64::from_polar(response.amplitudes[index], response.phases[index]);
        error = worse(error, (ours - exact).norm() / exact.norm());
    }
    Ok(Measured::error(error))
}

const COUPLED: [(&str, f64); 4] = [
    ("coupling.stiffness", SAW_GIN.stiffness),
    ("coupling.damping", SAW_GIN.damping),
    ("driver.inertia", SAW_GIN.driver_inertia),
    ("cylinder.inertia", SAW_GIN.driven_inertia),
];

fn slopes_of_decay(machine: &Machine) -> Result<Measured, CheckFailure> {
    let [c, b, driver, driven] = COUPLED;
    let form = ClosedForm {
        settings: &[("drive_torque", 0.0), ("load_torque", 0.0), ("initial_twist", 0.01)],
        columns: ["twist", "coupling_torque"],
        by: [c, b, driver, driven, ("initial_twist", 0.01)],
        until: 0.2,
        points: 401,
    };
    of_closed_form(machine, &form, |t, [c, b, driver, driven, twist]| {
        let nothing = Number::literal(0.0);
        twist_and_torque(t, [c, b, driver, driven], twist, [nothing; 4])
    })
}

fn slopes_of_harmonic(machine: &Machine) -> Result<Measured, CheckFailure> {
    let [c, b, driver, driven] = COUPLED;
    let form = ClosedForm {
        settings: &[("load_amplitude", 78.78)],
        columns: ["twist", "coupling_torque"],
        by: [
            c,
            b,
            driver,
            driven,
            ("drive_torque", CONSTANT.driving),
            ("load_torque", CONSTANT.load),
            ("load_amplitude", 78.78),
            ("load_frequency", LOAD_FREQUENCY),
        ],
        until: 0.2,
        points: 401,
    };
    of_closed_form(machine, &form, |t, [c, b, driver, driven, torques @ ..]| {
        twist_and_torque(t, [c, b, driver, driven], Number::literal(0.0), torques)
    })
}

/// Returns twist and torque of the coupling after an initial twist, under the driving torque, and
/// mean, amplitude and frequency of the load torque. This is a second form for any numbers, with
/// the harmonic response as in-phase and quadrature parts.
fn twist_and_torque<N: Number>(
    t: f64,
    [c, b, driver, driven]: [N; 4],
    start: N,
    [drive, load, amplitude, frequency]: [N; 4],
) -> [N; 2] {
    let t = N::literal(t);
    let total = driver + driven;
    let reduced = driver * driven / total;
    let level = (drive * driven + load * driver) / (c * total);
    let (stiff, viscous) = (c - reduced * frequency * frequency, b * frequency);
    let size = amplitude * driver / total / (stiff * stiff + viscous * viscous);
    let (in_phase, quadrature) = (size * stiff, -(size * viscous));
    let decay = b / (N::literal(2.0) * reduced);
    let square = c / reduced;
    let root = (square - decay * decay).sqrt();
    let fade = (-(decay * t)).exp();
    let (sine, cosine) = (root * t).sin_cos();
    let (cosine, sine) = (fade * cosine, fade * sine / root);
    let (left, rate) = (start - level - quadrature, -(frequency * in_phase));
    let (sin, cos) = (frequency * t).sin_cos();
    let angle =
        level + in_phase * sin + quadrature * cos + left * cosine + (rate + decay * left) * sine;
    let speed = frequency * (in_phase * cos - quadrature * sin) + rate * cosine
        - (decay * rate + square * left) * sine;
    [angle, c * angle + b * speed]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_twist_is_written_twice_alike() {
        let torques = Torques { load_amplitude: 78.78, ..CONSTANT };
        let start = Motion { driver_angle: 0.01, ..Motion::default() }.twist();
        for k in 0..40 {
            let t = 0.005 * f64::from(k);
            let once = SAW_GIN.twist(t, start, torques);
            let loads = [torques.driving, torques.load, 78.78, LOAD_FREQUENCY];
            let [angle, torque] = twist_and_torque(t, COUPLED.map(|(_, at)| at), 0.01, loads);
            assert!((angle - once.angle).abs() < 1e-14, "{t}");
            let carried = SAW_GIN.stiffness * once.angle + SAW_GIN.damping * once.rate;
            assert!((torque - carried).abs() < 1e-9, "{t}");
        }
    }
}

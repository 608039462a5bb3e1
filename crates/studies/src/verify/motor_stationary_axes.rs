//! Checks of the motor in charges against the motor in flux linkages: two descriptions of one
//! machine without common equations.

use num_complex::Complex64;

use super::machine::motor_run_up;
use super::sensitivities::{SMOOTH, against_complex_runs};
use super::{Check, CheckFailure, Machine, Measured, relative_distance};
use crate::closed_form::induction_motor::{Flux, MOTOR_4A280M8};
use crate::closed_form::motor_windings::{Currents, MotorWindings};
use machinist::Trajectory;

const RUN_UP: &str = "the scene motor_run_up, relative to its largest";
const BOTH_HELD: &str =
    "both runs are held to 1e-11 a step; ten thousand steps add their errors up";
const TWO_EXPONENTIALS: &str =
    "two complex exponentials turned into the windings' axes, relative to the largest";

pub(super) const CHECKS: &[Check] = &[
    Check {
        name: "torque over the run-up",
        reference: RUN_UP,
        tolerance: 1e-8,
        reason: BOTH_HELD,
        measure: |machine| run_up(machine, "torque"),
    },
    Check {
        name: "speed over the run-up",
        reference: RUN_UP,
        tolerance: 1e-8,
        reason: BOTH_HELD,
        measure: |machine| run_up(machine, "speed"),
    },
    Check {
        name: "currents of all windings over the run-up",
        reference: "those of motor_run_up by Park's transformation, relative to the largest",
        tolerance: 1e-8,
        reason: BOTH_HELD,
        measure: run_up_currents,
    },
    Check {
        name: "currents switched on at standstill",
        reference: TWO_EXPONENTIALS,
        tolerance: 1e-8,
        reason: "the run is held to 1e-11 a step; the inertia of 1e30 kg m^2 keeps the speed",
        measure: |machine| switched_on(machine, 0.0),
    },
    Check {
        name: "currents switched on at 76.97 rad/s",
        reference: TWO_EXPONENTIALS,
        tolerance: 1e-8,
        reason: "the run is held to 1e-11 a step; the inertia of 1e30 kg m^2 keeps the speed",
        measure: |machine| switched_on(machine, 76.97),
    },
    Check {
        name: "sensitivities over 0.2 s of run-up",
        reference: "runs on numbers that carry derivatives, over the largest of each",
        tolerance: 1e-8,
        reason: SMOOTH,
        measure: |machine| {
            let by = ["motor.inertia", "motor.k_r", "motor.x_s", "motor.alpha_s", "motor.alpha_r"];
            against_complex_runs(machine, &by, 0.2)
        },
    },
];

/// Currents of the windings, as outputs of the scene.
const CURRENTS: [&str; 4] = ["stator_alpha", "stator_beta", "rotor_first", "rotor_second"];

/// Speed is steady after 0.8 s.
const UNTIL: f64 = 1.0;

/// Compares a column that both motors have by its largest distance.
fn run_up(machine: &Machine, name: &str) -> Result<Measured, CheckFailure> {
    let reference = motor_run_up();
    let (ours, flux) = (run(machine)?, run(&reference)?);
    let (ours, flux) = (machine.column(&ours, name)?, reference.column(&flux, name)?);
    Ok(Measured::error(relative_distance(ours, flux)))
}

fn run_up_currents(machine: &Machine) -> Result<Measured, CheckFailure> {
    let reference = motor_run_up();
    let (ours, run) = (run(machine)?, run(&reference)?);
    let column = |name| reference.column(&run, name);
    let stator = [column("motor.psi_sx")?, column("motor.psi_sy")?];
    let rotor = [column("motor.psi_rx")?, column("motor.psi_ry")?];
    let flux = (0..run.times.len()).map(|k| Flux {
        stator: Complex64::new(stator[0][k], stator[1][k]),
        rotor: Complex64::new(rotor[0][k], rotor[1][k]),
    });
    currents_against(machine, &ours, flux)
}

/// Compares switching on. The closed form starts without flux, the run without current, which is
/// the same.
fn switched_on(machine: &Machine, speed: f64) -> Result<Measured, CheckFailure> {
    let settings = [("motor.inertia", 1e30), ("initial_speed", speed)];
    let ours = machine.simulation(&settings)?.until(0.3).points(301).rtol(1e-11).run()?;
    let slip = MOTOR_4A280M8.slip(speed);
    let flux = ours.times.iter().map(|time| MOTOR_4A280M8.flux(*time, Flux::default(), slip));
    currents_against(machine, &ours, flux)
}

/// Returns the largest distance of the currents of a run from those of flux linkages in synchronous
/// axes, one for each of its times, relative to the largest current.
fn currents_against(
    machine: &Machine,
    run: &Trajectory,
    flux: impl Iterator<Item = Flux>,
) -> Result<Measured, CheckFailure> {
    let windings = MotorWindings::of(&MOTOR_4A280M8);
    let angle = machine.column(run, "angle")?;
    let points = run.times.iter().zip(angle);
    let turned: Vec<Currents> = flux
        .zip(points)
        .map(|(flux, (time, angle))| {
            let supply = MOTOR_4A280M8.synchronous_frequency() * time;
            windings.currents(flux).in_windings(supply, windings.pole_pairs * angle)
        })
        .collect();
    let parts: [fn(&Currents) -> f64; 4] =
        [|i| i.stator.re, |i| i.stator.im, |i| i.rotor.re, |i| i.rotor.im];
    let (mut ours, mut reference) = (Vec::new(), Vec::new());
    for (name, part) in CURRENTS.iter().zip(parts) {
        ours.extend_from_slice(machine.column(run, name)?);
        reference.extend(turned.iter().map(part));
    }
    Ok(Measured::error(relative_distance(&ours, &reference)))
}

fn run(machine: &Machine) -> Result<Trajectory, CheckFailure> {
    Ok(machine.simulation(&[])?.until(UNTIL).points(1001).rtol(1e-11).run()?)
}

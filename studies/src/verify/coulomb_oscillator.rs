//! Checks of the oscillator braked by dry friction, half cycle by half cycle.

use super::{Check, CheckFailure, Machine, Measured, counted, relative_distance, worse};
use crate::closed_form::CoulombOscillator;
use machinist::{Method, Trajectory};

pub(super) const CHECKS: &[Check] = &[
    Check {
        name: "motion until rest, and rest",
        reference: "exact half cycles, deflection and velocity relative to the largest",
        tolerance: 1e-9,
        reason: "the run is held to 1e-12 a step, its ends to rounding",
        measure: motion,
    },
    Check {
        name: "turns until rest",
        reference: "half cycles, counted",
        tolerance: 0.0,
        reason: "a count",
        measure: turns,
    },
];

const SLIDER: CoulombOscillator =
    CoulombOscillator { mass: 1.0, stiffness: 400.0, kinetic: 2.5, limit: 4.0 };
const START: f64 = 0.097;

fn run(machine: &Machine) -> Result<Trajectory, CheckFailure> {
    let run = machine.simulation(&[])?.until(2.0).points(2001).rtol(1e-12);
    Ok(run.method(Method::Dop853).run()?)
}

fn motion(machine: &Machine) -> Result<Measured, CheckFailure> {
    let run = run(machine)?;
    let exact = run.times.iter().map(|time| SLIDER.motion(*time, START));
    let (values, rates): (Vec<f64>, Vec<f64>) = exact.unzip();
    let deflection = relative_distance(machine.column(&run, "slider.x")?, &values);
    let velocity = relative_distance(machine.column(&run, "slider.v")?, &rates);
    Ok(Measured::error(worse(deflection, velocity)))
}

fn turns(machine: &Machine) -> Result<Measured, CheckFailure> {
    Ok(counted(run(machine)?.work.switches, SLIDER.half_cycles(START)))
}

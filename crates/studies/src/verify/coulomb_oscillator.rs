//! Checks of the oscillator braked by dry friction, half cycle by half cycle.

use super::sensitivities::{ACROSS, ClosedForm, of_closed_form};
use super::{Check, CheckFailure, Machine, Measured, counted, relative_distance, worse};
use crate::closed_form::{CoulombOscillator, Number};
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
    Check {
        name: "sensitivities until rest, and at rest",
        reference: "derivative of the closed form, over the largest of each",
        tolerance: 1e-6,
        reason: ACROSS,
        measure: slopes,
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

fn slopes(machine: &Machine) -> Result<Measured, CheckFailure> {
    let form = ClosedForm {
        settings: &[],
        columns: ["slider.x", "slider.v"],
        by: [
            ("deflection", START),
            ("slider.mass", 1.0),
            ("slider.stiffness", 400.0),
            ("slider.kinetic_friction", 0.25),
        ],
        until: 2.0,
        points: 401,
    };
    of_closed_form(machine, &form, |t, [start, mass, stiffness, friction]| {
        let kinetic = friction * Number::literal(10.0);
        let limit = Number::literal(SLIDER.limit);
        let (x, v) = CoulombOscillator { mass, stiffness, kinetic, limit }.motion(t, start);
        [x, v]
    })
}

//! Checks of the oscillator with a one-sided stop, and of its smooth twin.

use super::sensitivities::{ACROSS, against_differences};
use super::{
    Check, CheckFailure, Machine, Measured, convergence, counted, relative_distance, worse,
};
use crate::closed_form::OneSidedStop;
use machinist::{Method, Trajectory};

pub(super) const CHECKS: &[Check] = &[
    Check {
        name: "motion over 2 s",
        reference: "stitched sinusoids, deflection and velocity relative to the largest",
        tolerance: 1e-9,
        reason: "the run is held to 1e-12 a step, its switches to rounding",
        measure: motion,
    },
    Check {
        name: "touches and departures in 2 s",
        reference: "stitched sinusoids, counted",
        tolerance: 0.0,
        reason: "a count",
        measure: switches,
    },
    Check {
        name: "sensitivities over 0.5 s",
        reference: "central differences of sixth order, over the largest of each",
        tolerance: 1e-6,
        reason: ACROSS,
        measure: |machine| {
            let by = ["deflection", "stop.stiffness", "oscillator.mass"];
            against_differences(machine, &by, (0.5, 97), 1e-5)
        },
    },
];

pub(super) const SMOOTH_CHECKS: &[Check] = &[Check {
    name: "order at which it nears the stop with events, widths 0.1 and 0.05 mm",
    reference: "stitched sinusoids; what lacks to order 1.5",
    tolerance: 0.0,
    reason: "the smoothed force errs by the width squared, but for a logarithm",
    measure: order,
}];

const STOP: OneSidedStop = OneSidedStop { mass: 1.0, stiffness: 400.0, distance: 0.005, stop: 1e4 };
const START: f64 = -0.02;

fn run(machine: &Machine, settings: &[(&str, f64)]) -> Result<Trajectory, CheckFailure> {
    let run = machine.simulation(settings)?.until(2.0).points(2001).rtol(1e-12);
    Ok(run.method(Method::Dop853).run()?)
}

fn distance(machine: &Machine, run: &Trajectory) -> Result<f64, CheckFailure> {
    let exact = run.times.iter().map(|time| STOP.motion(*time, START));
    let (values, rates): (Vec<f64>, Vec<f64>) = exact.map(|now| (now.x, now.v)).unzip();
    let deflection = relative_distance(machine.column(run, "oscillator.x")?, &values);
    let velocity = relative_distance(machine.column(run, "oscillator.v")?, &rates);
    Ok(worse(deflection, velocity))
}

fn motion(machine: &Machine) -> Result<Measured, CheckFailure> {
    Ok(Measured::error(distance(machine, &run(machine, &[])?)?))
}

fn switches(machine: &Machine) -> Result<Measured, CheckFailure> {
    Ok(counted(run(machine, &[])?.work.switches, STOP.motion(2.0, START).switches))
}

fn order(machine: &Machine) -> Result<Measured, CheckFailure> {
    let error = |width| distance(machine, &run(machine, &[("stop.width", width)])?);
    Ok(convergence([error(1e-4)?, error(5e-5)?], 1.5))
}

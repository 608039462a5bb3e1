//! Checks of the mass bouncing on a shaken plate: its stable orbit of one bounce a period.

use super::{Check, CheckFailure, Machine, Measured, counted, relative_distance, worse};
use crate::closed_form::ShakenPlate;
use machinist::{Method, Trajectory};

pub(super) const CHECKS: &[Check] = &[
    Check {
        name: "orbit of one bounce a period over 10 s",
        reference: "closed form, height and velocity relative to the largest",
        tolerance: 1e-9,
        reason: "the run is held to 1e-12 a step, impacts to rounding; the orbit is stable",
        measure: orbit,
    },
    Check {
        name: "bounces in 1000 s",
        reference: "one a period, counted",
        tolerance: 0.0,
        reason: "a count",
        measure: bounces,
    },
];

const PLATE: ShakenPlate = ShakenPlate {
    amplitude: 1.7395e-3,
    frequency: std::f64::consts::TAU * 10.0,
    gravity: 9.81,
    restitution: 0.8,
};

fn run(machine: &Machine, until: f64, rtol: f64) -> Result<Trajectory, CheckFailure> {
    let (height, speed) = PLATE.motion(0.0);
    let settings = [("height", height), ("speed", speed)];
    let run = machine.simulation(&settings)?.until(until).points(1237).rtol(rtol);
    Ok(run.method(Method::Dop853).run()?)
}

fn orbit(machine: &Machine) -> Result<Measured, CheckFailure> {
    let run = run(machine, 10.0, 1e-12)?;
    let (heights, speeds): (Vec<f64>, Vec<f64>) =
        run.times.iter().map(|time| PLATE.motion(*time)).unzip();
    let height = relative_distance(machine.column(&run, "ball.x")?, &heights);
    let speed = relative_distance(machine.column(&run, "ball.v")?, &speeds);
    Ok(Measured::error(worse(height, speed)))
}

fn bounces(machine: &Machine) -> Result<Measured, CheckFailure> {
    let run = run(machine, 1000.0, 1e-8)?;
    Ok(counted(run.work.switches, PLATE.impacts(1000.0)))
}

//! Checks of stick-slip on a belt against the exact cycle without the Stribeck term, and of its
//! smooth twin.

use super::machine;
use super::sensitivities::{ACROSS, ClosedForm, against_differences, of_closed_form};
use super::{
    Check, CheckFailure, Machine, Measured, convergence, counted, relative_distance, worse,
};
use crate::closed_form::{Number, StickSlip};
use machinist::{Method, Trajectory};

pub(super) const CHECKS: &[Check] = &[
    Check {
        name: "cycles over 10 s without the Stribeck term",
        reference: "closed form, deflection and velocity relative to the largest",
        tolerance: 1e-9,
        reason: "the run is held to 1e-12 a step, its switches to rounding",
        measure: cycles,
    },
    Check {
        name: "changes between stick and slip in 1000 s, likewise",
        reference: "closed form, counted",
        tolerance: 0.0,
        reason: "a count",
        measure: switches,
    },
    Check {
        name: "sensitivities over 2 s without the Stribeck term",
        reference: "derivative of the closed form, over the largest of each",
        tolerance: 1e-6,
        reason: ACROSS,
        measure: slopes,
    },
    Check {
        name: "sensitivities over 2 s with it",
        reference: "central differences of sixth order, over the largest of each",
        tolerance: 1e-6,
        reason: ACROSS,
        measure: |machine| {
            let by = ["belt_speed", "slider.static_friction", "slider.stribeck_speed"];
            against_differences(machine, &by, (2.0, 97), 1e-5)
        },
    },
];

pub(super) const SMOOTH_CHECKS: &[Check] = &[Check {
    name: "order at which it nears stick-slip by events, widths 0.04 and 0.02 mm/s",
    reference: "stick_slip with the same friction over 1 s; what lacks to order 0.9",
    tolerance: 0.0,
    reason: "the mass creeps instead of sticking, by a share of the width",
    measure: order,
}];

const BELT: StickSlip =
    StickSlip { mass: 1.0, stiffness: 400.0, belt_speed: 0.1, limit: 4.0, kinetic: 2.5 };

fn run(
    machine: &Machine,
    settings: &[(&str, f64)],
    (until, rtol): (f64, f64),
    method: Method,
) -> Result<Trajectory, CheckFailure> {
    let run = machine.simulation(settings)?.until(until).points(1237).rtol(rtol);
    Ok(run.method(method).run()?)
}

const NO_STRIBECK: [(&str, f64); 1] = [("slider.stribeck_friction", 0.0)];

fn cycles(machine: &Machine) -> Result<Measured, CheckFailure> {
    let run = run(machine, &NO_STRIBECK, (10.0, 1e-12), Method::Dop853)?;
    let exact = run.times.iter().map(|time| BELT.motion(*time));
    let (values, rates): (Vec<f64>, Vec<f64>) = exact.map(|(x, v, _)| (x, v)).unzip();
    let deflection = relative_distance(machine.column(&run, "slider.x")?, &values);
    let velocity = relative_distance(machine.column(&run, "slider.v")?, &rates);
    Ok(Measured::error(worse(deflection, velocity)))
}

fn switches(machine: &Machine) -> Result<Measured, CheckFailure> {
    let run = run(machine, &NO_STRIBECK, (1000.0, 1e-8), Method::Dop853)?;
    Ok(counted(run.work.switches, BELT.motion(1000.0).2))
}

fn order(smooth: &Machine) -> Result<Measured, CheckFailure> {
    let friction =
        smooth.value("slider.kinetic_friction")? + smooth.value("slider.stribeck_friction")?;
    let limit = [("slider.static_friction", friction)];
    let events = run(&machine::stick_slip(), &limit, (1.0, 1e-11), Method::Dop853)?;
    let exact = smooth.column(&events, "slider.x")?;
    let error = |width| {
        let run = run(smooth, &[("slider.width", width)], (1.0, 1e-10), Method::Radau)?;
        Ok::<_, CheckFailure>(relative_distance(smooth.column(&run, "slider.x")?, exact))
    };
    Ok(convergence([error(4e-5)?, error(2e-5)?], 0.9))
}

fn slopes(machine: &Machine) -> Result<Measured, CheckFailure> {
    let form = ClosedForm {
        settings: &NO_STRIBECK,
        columns: ["slider.x", "slider.v"],
        by: [
            ("slider.mass", BELT.mass),
            ("slider.stiffness", BELT.stiffness),
            ("belt_speed", BELT.belt_speed),
            ("slider.static_friction", 0.4),
            ("slider.kinetic_friction", 0.25),
        ],
        until: 2.0,
        points: 397,
    };
    of_closed_form(machine, &form, |t, [mass, stiffness, belt_speed, holds, slides]| {
        let pressed = Number::literal(10.0);
        let (limit, kinetic) = (holds * pressed, slides * pressed);
        let (x, v, _) = StickSlip { mass, stiffness, belt_speed, limit, kinetic }.motion(t);
        [x, v]
    })
}

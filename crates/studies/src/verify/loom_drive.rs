//! Checks of the loom: motor, coupling, shaft and reed in one machine.

use machinist_scenes::scenes::loom_drive::LoomDrive;

use super::{Check, CheckFailure, Machine, Measured};
use crate::closed_form::reed::{REED_STUDY, Reed, ReedShaft};
use machinist::field::{Discretisation, FieldSimulator};
use machinist::{Method, Simulation};

pub(super) const CHECKS: &[Check] = &[Check {
    name: "amplitude of the reed at full speed",
    reference: "harmonic answer of the reed's shaft alone at that speed, relative",
    tolerance: 1e-3,
    reason: "the crank's speed is even to 1e-4; the run-up leaves traces of free vibration",
    measure: amplitude,
}];

fn amplitude(machine: &Machine) -> Result<Measured, CheckFailure> {
    let wanted = Discretisation { elements: Some(5), order: Some(4) };
    let simulator = FieldSimulator::new(&LoomDrive, wanted)?;
    let run = Simulation::new(simulator.single())
        .parameters(&machine.parameters(&[("shaft.damping_time", 1e-5)])?)
        .until(2.0)
        .points(4001)
        .rtol(1e-6)
        .method(Method::Rodas5p)
        .run()?;
    let late = run.times.len() * 19 / 20;
    let largest = |name: &str| -> Result<f64, CheckFailure> {
        let column = &machine.column(&run, name)?[late..];
        Ok(column.iter().fold(0.0, |most, value| value.abs().max(most)))
    };
    let speeds = &machine.column(&run, "crank_speed")?[late..];
    let speed = speeds.iter().sum::<f64>() / speeds.len() as f64;
    let shaft = ReedShaft { contact_stiffness: machine.value("fell.stiffness")?, ..REED_STUDY };
    let known = shaft.harmonic_response(largest("drive_angle")?, speed, Reed::Free).reed_angle();
    Ok(Measured::relative(largest("reed_angle")?, known.abs()))
}

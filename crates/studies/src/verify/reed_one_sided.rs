//! Checks of the reed against a fell that only pushes, by a row of cells with its own integration,
//! which has nothing in common with elements and engine.

use machinist_scenes::scenes::reed_beat_up_one_sided::ReedBeatUpOneSided;

use super::{Check, CheckFailure, Machine, Measured, largest, relative_distance, worse};
use crate::closed_form::reed::{REED_STUDY, ReedShaft};
use crate::reed_cells::{Fell, ReedCells};
use machinist::field::{Discretisation, FieldSimulator};
use machinist::{Method, Simulation, Trajectory};

/// Number of cells of 5 mm; the reed is between the two hundredth and the next.
const CELLS: usize = 350;
/// Period of the drive \[s\].
const UNTIL: f64 = 0.0527;
const POINTS: usize = 501;
const ANGLES: [&str; 2] = ["shaft_angle", "reed_angle"];
const STRESSES: [&str; 2] = ["stress_before", "stress_after"];

pub(super) const CHECKS: &[Check] = &[
    Check {
        name: "angles over a period of the drive, C2 = C1/2 and C1, 24 elements of order 4",
        reference: "350 cells by steps of their own, largest difference, relative",
        tolerance: 2e-4,
        reason: "the cells' own error, which falls with the square of their width",
        measure: |machine| against_cells(machine, ANGLES),
    },
    Check {
        name: "stresses over a period of the drive, C2 = C1/2 and C1, 24 elements of order 4",
        reference: "350 cells by steps of their own, root mean squares, relative",
        tolerance: 2e-2,
        reason: "kinks of waves, which both cut short",
        measure: |machine| against_cells(machine, STRESSES),
    },
    Check {
        name: "largest angles and stress before the reed, C2 = C1/2 and C1",
        reference: "350 cells by steps of their own, relative",
        tolerance: 1e-3,
        reason: "as above; the largest stress lies on a smooth crest",
        measure: extremes,
    },
    Check {
        name: "angles at rtol 1e-8, steps end at the fell's edge, 8 elements of order 4",
        reference: "the same elements at rtol 1e-11, largest difference, relative",
        tolerance: 1e-7,
        reason: "steps of both runs end where the fell begins and ceases to push",
        measure: at_own_tolerance,
    },
];

fn run(
    machine: &Machine,
    [elements, order]: [usize; 2],
    stiffness: f64,
    rtol: f64,
) -> Result<Trajectory, CheckFailure> {
    let wanted = Discretisation { elements: Some(elements), order: Some(order) };
    let simulator = FieldSimulator::new(&ReedBeatUpOneSided, wanted)?;
    let simulation = Simulation::new(simulator.single())
        .parameters(&machine.parameters(&[("fell.stiffness", stiffness)])?)
        .until(UNTIL)
        .points(POINTS)
        .rtol(rtol)
        .method(Method::Dop853);
    Ok(simulation.run()?)
}

/// Returns the angles of shaft and reed, and the stresses on both sides, from the cells.
fn by_cells(stiffness: f64, times: &[f64]) -> [Vec<f64>; 4] {
    let shaft = ReedShaft { contact_stiffness: stiffness, ..REED_STUDY };
    let model = ReedCells { shaft, fell: Fell::OnlyPushes, cells: CELLS };
    let mut columns = [const { Vec::new() }; 4];
    for now in model.motion(times) {
        let values = [now.shaft_angle, now.reed_angle, now.stress[0], now.stress[1]];
        columns.iter_mut().zip(values).for_each(|(column, value)| column.push(value));
    }
    columns
}

fn stiffnesses() -> [f64; 2] {
    [0.5, 1.0].map(|share| share * REED_STUDY.reed_stiffness)
}

fn against_cells(machine: &Machine, names: [&str; 2]) -> Result<Measured, CheckFailure> {
    let mut error = 0.0;
    for stiffness in stiffnesses() {
        let run = run(machine, [24, 4], stiffness, 1e-7)?;
        let [shaft, reed, before, after] = by_cells(stiffness, &run.times);
        let is_stress = names == STRESSES;
        let known = if is_stress { [before, after] } else { [shaft, reed] };
        for (name, known) in names.iter().zip(&known) {
            let ours = machine.column(&run, name)?;
            let off =
                if is_stress { mean_distance(ours, known) } else { relative_distance(ours, known) };
            error = worse(error, off);
        }
    }
    Ok(Measured::error(error))
}

/// Returns the root mean square of the difference over that of the reference.
fn mean_distance(ours: &[f64], reference: &[f64]) -> f64 {
    let pairs = ours.iter().zip(reference);
    let [off, size] = pairs.fold([0.0, 0.0], |[off, size], (ours, reference)| {
        [off + (ours - reference).powi(2), size + reference.powi(2)]
    });
    (off / size).sqrt()
}

fn extremes(machine: &Machine) -> Result<Measured, CheckFailure> {
    let mut error = 0.0;
    for stiffness in stiffnesses() {
        let run = run(machine, [24, 4], stiffness, 1e-7)?;
        let known = by_cells(stiffness, &run.times);
        for (name, known) in ["shaft_angle", "reed_angle", "stress_before"].iter().zip(&known) {
            error =
                worse(error, (largest(machine.column(&run, name)?) / largest(known) - 1.0).abs());
        }
    }
    Ok(Measured::error(error))
}

fn at_own_tolerance(machine: &Machine) -> Result<Measured, CheckFailure> {
    let stiffness = REED_STUDY.reed_stiffness;
    let [loose, tight] = [1e-8, 1e-11].map(|rtol| run(machine, [8, 4], stiffness, rtol));
    let (loose, tight) = (loose?, tight?);
    let mut error = 0.0;
    for name in ANGLES {
        let known = machine.column(&tight, name)?;
        error = worse(error, relative_distance(machine.column(&loose, name)?, known));
    }
    Ok(Measured::error(error))
}

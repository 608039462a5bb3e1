//! Checks of the reed on its driven shaft: frequencies, frequency response, motion from rest.

use machinist_contract::{Describe as _, Simulator as _};
use machinist_scenes::scenes::reed_beat_up::ReedBeatUp;
use nalgebra::DVector;

use super::{Check, CheckFailure, Machine, Measured, relative_distance, worse};
use crate::closed_form::reed::{DRIVE_HALF_PERIOD, REED_STUDY, Reed, ReedShaft, ReedTransient};
use machinist::field::{Discretisation, FieldSimulator, ModalSimulator};
use machinist::linear_analysis::{Linearization, Point};
use machinist::{Method, Simulation};

/// Roots of the frequency equation in 1/T with the reed held, and free without contact.
const HELD: [f64; 3] = [0.773_133_295_9, 2.136_006_785_8, 3.943_522_315_2];
const FREE: [f64; 3] = [0.502_811_117_5, 1.035_664_812_3, 2.136_030_375_7];
/// Arm that makes the reed so heavy that it stays at rest \[m\].
const HEAVY: f64 = 1e4;

const ROUNDING: &str = "ten digits are published; the elements' own error is some 1e-13";

pub(super) const CHECKS: &[Check] = &[
    Check {
        name: "first three frequencies with the reed held, 10 elements of order 8",
        reference: "roots of the frequency equation, in 1/T; absolute",
        tolerance: 1e-9,
        reason: ROUNDING,
        measure: |machine| {
            roots(machine, &[("fell.stiffness", 0.0), ("reed.arm", HEAVY)], 1, &HELD)
        },
    },
    Check {
        name: "first three frequencies with the reed free, 10 elements of order 8",
        reference: "roots of the frequency equation, in 1/T; absolute",
        tolerance: 1e-9,
        reason: ROUNDING,
        measure: |machine| roots(machine, &[("fell.stiffness", 0.0)], 0, &FREE),
    },
    Check {
        name: "first five frequencies in contact, C2 = C1/2 and C1",
        reference: "the frequency equation of the reed in contact, in 1/T; absolute",
        tolerance: 1e-9,
        reason: "the elements' own error is some 1e-13",
        measure: in_contact,
    },
    Check {
        name: "steady answer at 1, 3 and 10 times the drive's frequency, 10 elements of order 8",
        reference: "two matched segments: angles, and stress on both sides; relative",
        tolerance: 1e-8,
        reason: "the elements' own error; slopes lose an order",
        measure: harmonic,
    },
    Check {
        name: "angles from rest over 4 ms, 24 elements of order 4",
        reference: "series of 3000 modes, root mean squares, relative",
        tolerance: 3e-6,
        reason: "waves of the jump of the drive's speed have kinks",
        measure: |machine| Ok(Measured::error(from_rest(machine)?[0])),
    },
    Check {
        name: "stresses from rest over 4 ms, 24 elements of order 4",
        reference: "series of 3000 modes, root mean squares, relative",
        tolerance: 1e-3,
        reason: "as above, but stresses fall with the length of an element only",
        measure: |machine| Ok(Measured::error(from_rest(machine)?[1])),
    },
    Check {
        name: "angles over a period of the drive by equations (6) and (7), 6 elements of order 4",
        reference: "the scene in the consistent scales L and T against SI, largest, relative",
        tolerance: 1e-7,
        reason: "one machine in two systems of units; errors of both runs at rtol 1e-11",
        measure: dimensionless,
    },
    Check {
        name: "angles by 57 of 66 modes against 8 elements of order 8, over 3 ms",
        reference: "the same elements without modes, largest difference, relative",
        tolerance: 1e-6,
        reason: "left out is the fastest branch: one mode an element, and that of a free end",
        measure: |machine| Ok(Measured::error(by_modes(machine)?[0])),
    },
    Check {
        name: "stresses by 57 of 66 modes against 8 elements of order 8, over 3 ms",
        reference: "the same elements without modes, largest difference, relative",
        tolerance: 1e-4,
        reason: "as above",
        measure: |machine| Ok(Measured::error(by_modes(machine)?[1])),
    },
];

fn cut(elements: usize, order: usize) -> Result<FieldSimulator<'static, f64>, CheckFailure> {
    let wanted = Discretisation { elements: Some(elements), order: Some(order) };
    Ok(FieldSimulator::new(&ReedBeatUp, wanted)?)
}

fn at_rest<'a>(
    machine: &Machine,
    simulator: &'a FieldSimulator<'static, f64>,
    settings: &[(&str, f64)],
) -> Result<Linearization<'a>, CheckFailure> {
    let state = vec![0.0; simulator.shape().states()];
    let point = Point { time: 0.0, state, parameters: machine.parameters(settings)? };
    Ok(Linearization::at(simulator.single(), point)?)
}

/// Returns the largest error of the frequencies, except the first few.
fn roots(
    machine: &Machine,
    settings: &[(&str, f64)],
    skip: usize,
    known: &[f64],
) -> Result<Measured, CheckFailure> {
    let simulator = cut(10, 8)?;
    let found = at_rest(machine, &simulator, settings)?.second_order()?.undamped_frequencies()?;
    let time = REED_STUDY.time_scale();
    let errors =
        found.iter().skip(skip).zip(known).map(|(found, root)| (found * time - root).abs());
    Ok(Measured::error(errors.fold(0.0, worse)))
}

fn touching(share: f64) -> ReedShaft {
    ReedShaft { contact_stiffness: share * REED_STUDY.reed_stiffness, ..REED_STUDY }
}

fn in_contact(machine: &Machine) -> Result<Measured, CheckFailure> {
    let mut worst = 0.0;
    for share in [0.5, 1.0] {
        let shaft = touching(share);
        let known: Vec<f64> = (1..=5).map(|k| shaft.frequency(k, Reed::Free)).collect();
        let settings = [("fell.stiffness", shaft.contact_stiffness)];
        worst = worse(worst, roots(machine, &settings, 0, &known)?.error);
    }
    Ok(Measured::error(worst))
}

/// Solves (K - w^2 M) x = F, where F contains the forces at rest when the drive is farthest out.
fn harmonic(machine: &Machine) -> Result<Measured, CheckFailure> {
    let shaft = touching(0.5);
    let simulator = cut(10, 8)?;
    let amplitude = shaft.drive_amplitude();
    let mut worst = 0.0;
    for times in [1.0, 3.0, 10.0] {
        let frequency = times * shaft.drive_frequency();
        let settings =
            [("fell.stiffness", shaft.contact_stiffness), ("drive.frequency", frequency)];
        let parameters = machine.parameters(&settings)?;
        let n = simulator.shape().coordinates;
        let rest = vec![0.0; 2 * n];
        let farthest = std::f64::consts::FRAC_PI_2 / frequency;
        let mut forces = vec![0.0; n];
        simulator.forcing(farthest, &rest, &parameters, &mut forces);
        let system = at_rest(machine, &simulator, &settings)?.second_order()?;
        let matrix = system.stiffness - system.mass * (frequency * frequency);
        let forces = DVector::from_vec(forces);
        let answer = matrix.lu().solve(&forces).ok_or(CheckFailure::Singular)?;
        let mut state = answer.as_slice().to_vec();
        state.resize(2 * n, 0.0);
        let mut outputs = vec![0.0; simulator.shape().outputs];
        simulator.outputs(farthest, &state, &parameters, &mut outputs);
        let known = shaft.harmonic_response(amplitude, frequency, Reed::Free);
        let [before, after] = known.stress_beside_reed();
        for (name, exact) in [
            ("driven_angle", known.angle(0.0)),
            ("shaft_angle", known.angle(shaft.reed_position)),
            ("middle_angle", known.angle(shaft.length)),
            ("reed_angle", known.reed_angle()),
            ("stress_before", before),
            ("stress_after", after),
        ] {
            let found = outputs[machine.output_index(name)?];
            worst = worse(worst, (found / exact - 1.0).abs());
        }
    }
    Ok(Measured::error(worst))
}

/// Returns root mean square errors of angles and of stresses, relative to those of each.
fn from_rest(machine: &Machine) -> Result<[f64; 2], CheckFailure> {
    let shaft = touching(0.5);
    let drive = [shaft.drive_amplitude(), shaft.drive_frequency()];
    let series = ReedTransient::new(&shaft, drive, Reed::Free, 3000);
    let simulator = cut(24, 4)?;
    let run = Simulation::new(simulator.single())
        .parameters(&machine.parameters(&[("fell.stiffness", shaft.contact_stiffness)])?)
        .until(0.004)
        .points(101)
        .rtol(1e-8)
        .method(Method::Dop853)
        .run()?;
    let names = ["shaft_angle", "reed_angle", "stress_before", "stress_after"];
    let mut columns = [&[][..]; 4];
    for (column, name) in columns.iter_mut().zip(names) {
        *column = machine.column(&run, name)?;
    }
    let (mut errors, mut sizes) = ([0.0; 2], [0.0; 2]);
    for (index, time) in run.times.iter().enumerate() {
        let known = series.at(*time);
        let known = [known.shaft_angle, known.reed_angle, known.stress[0], known.stress[1]];
        for (place, (column, known)) in columns.iter().zip(known).enumerate() {
            errors[place / 2] += (column[index] - known).powi(2);
            sizes[place / 2] += known.powi(2);
        }
    }
    Ok([(errors[0] / sizes[0]).sqrt(), (errors[1] / sizes[1]).sqrt()])
}

/// Compares with the dimensionless equations (6), (7), which are those of the scene with G Jp = rho
/// Jp = C0 = 1, C1 = beta, Ir = alpha, C2 = b2, l0 = xi0 and l = xi1; the drive's half period is
/// tau0.
fn dimensionless(machine: &Machine) -> Result<Measured, CheckFailure> {
    let shaft = touching(0.5);
    let simulator = cut(6, 4)?;
    let run = |settings: &[(&str, f64)], until: f64| -> Result<_, CheckFailure> {
        let simulation = Simulation::new(simulator.single())
            .parameters(&machine.parameters(settings)?)
            .until(until)
            .points(201)
            .rtol(1e-11)
            .method(Method::Dop853);
        Ok(simulation.run()?)
    };
    let until = 2.0 * DRIVE_HALF_PERIOD;
    let ours = run(
        &[
            ("shaft.length", shaft.end_place()),
            ("shaft.reed_position", shaft.reed_place()),
            ("shaft.radius", (2.0 / std::f64::consts::PI).powf(0.25)),
            ("shaft.density", 1.0),
            ("shaft.shear_modulus", 1.0),
            ("drive.stiffness", 1.0),
            ("drive.frequency", std::f64::consts::PI / DRIVE_HALF_PERIOD),
            ("reed.stiffness", shaft.beta()),
            ("reed.mass", shaft.alpha()),
            ("reed.arm", 1.0),
            ("fell.stiffness", shaft.contact()),
        ],
        until,
    )?;
    let known = run(&[("fell.stiffness", shaft.contact_stiffness)], until * shaft.time_scale())?;
    let mut error = 0.0;
    for name in ["shaft_angle", "reed_angle"] {
        let off = relative_distance(machine.column(&ours, name)?, machine.column(&known, name)?);
        error = worse(error, off);
    }
    Ok(Measured::error(error))
}

/// Returns the largest differences of angles and of stresses, relative to the largest of each.
fn by_modes(machine: &Machine) -> Result<[f64; 2], CheckFailure> {
    let simulator = cut(8, 8)?;
    let modal = ModalSimulator::new(simulator.single(), &machine.parameters(&[])?, 57)?;
    let run = |simulation: Simulation<'_>| {
        simulation.until(0.003).points(31).rtol(1e-9).method(Method::Dop853).run()
    };
    let (known, ours) = (run(Simulation::new(simulator.single()))?, run(Simulation::new(&modal))?);
    let error = |name: &str| -> Result<f64, CheckFailure> {
        Ok(relative_distance(machine.column(&ours, name)?, machine.column(&known, name)?))
    };
    let angles = worse(error("shaft_angle")?, error("reed_angle")?);
    Ok([angles, worse(error("stress_before")?, error("stress_after")?)])
}

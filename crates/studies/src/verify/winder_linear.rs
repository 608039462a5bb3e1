//! Checks of the bobbin on a linear layer against its exact motion, and of the
//! mobility of its holder.

use std::f64::consts::PI;

use num_complex::Complex64;

use super::sensitivities::{SMOOTH, against_complex_runs};
use super::{Check, CheckFailure, Machine, Measured, relative_distance, worse};
use crate::closed_form::winder::{
    BENCH_BOBBIN, BENCH_FORCE, BENCH_MASS, BENCH_SHAPE, BobbinOscillator, Deflection, Harmonic,
};
use crate::closed_form::winding_pair::{HOLDER_POSITIONS, pressure_over_growth};

const NEAR_ROUNDING: &str = "the run is held to 1e-12 a step; some thousand steps add up";
const TRANSIENT: &str = "closed form of deflection and velocity, each relative to its largest";

pub(super) const CHECKS: &[Check] = &[
    Check {
        name: "free decay from 1 mm",
        reference: TRANSIENT,
        tolerance: 1e-9,
        reason: NEAR_ROUNDING,
        measure: free_decay,
    },
    Check {
        name: "transient under force and drum shape",
        reference: TRANSIENT,
        tolerance: 1e-9,
        reason: NEAR_ROUNDING,
        measure: transient,
    },
    Check {
        name: "amplitude of the steady answer to force",
        reference: "closed form, relative",
        tolerance: 1e-9,
        reason: NEAR_ROUNDING,
        measure: |machine| amplitude(machine, &BENCH_BOBBIN.answer_to_force(&BENCH_FORCE)),
    },
    Check {
        name: "phase of the steady answer to force",
        reference: "closed form, rad",
        tolerance: 1e-9,
        reason: NEAR_ROUNDING,
        measure: |machine| phase(machine, &BENCH_BOBBIN.answer_to_force(&BENCH_FORCE)),
    },
    Check {
        name: "amplitude of the steady answer to drum shape",
        reference: "closed form, relative",
        tolerance: 1e-9,
        reason: NEAR_ROUNDING,
        measure: |machine| amplitude(machine, &BENCH_BOBBIN.answer_to_shape(&BENCH_SHAPE)),
    },
    Check {
        name: "phase of the steady answer to drum shape",
        reference: "closed form, rad",
        tolerance: 1e-9,
        reason: NEAR_ROUNDING,
        measure: |machine| phase(machine, &BENCH_BOBBIN.answer_to_shape(&BENCH_SHAPE)),
    },
    Check {
        name: "reduced mass of a package of 50 mm",
        reference: "m0 + mn (lbc/lab)^2 + pi (R^2 - Rmin^2) H rho, relative",
        tolerance: 1e-14,
        reason: "both are algebra",
        measure: reduced_mass,
    },
    Check {
        name: "contact force at rest of packages of 30 to 60 mm",
        reference: "(15): the spring takes the growth, the package its weight, relative",
        tolerance: 1e-14,
        reason: "both are algebra",
        measure: contact_force_at_rest,
    },
    Check {
        name: "mobility of the bobbin holder in five positions",
        reference: "the study's table 2, 2, 3, 3, 3: positions that differ",
        tolerance: 0.0,
        reason: "integers",
        measure: |_| Ok(Measured::error(positions_that_differ())),
    },
    Check {
        name: "sensitivities over 0.2 s",
        reference: "runs on numbers that carry derivatives, over the largest of each",
        tolerance: 1e-8,
        reason: SMOOTH,
        measure: |machine| {
            let by = [
                "layer.stiffness",
                "layer.viscosity",
                "force_amplitude",
                "ovality",
                "winding_speed",
                "holder.bobbin_mass",
            ];
            against_complex_runs(machine, &by, 0.2)
        },
    },
];

/// Checks of the equation as printed.
pub(super) const PRINTED_CHECKS: &[Check] = &[
    Check {
        name: "transient under force and drum shape, as printed",
        reference: TRANSIENT,
        tolerance: 1e-9,
        reason: NEAR_ROUNDING,
        measure: printed_transient,
    },
    Check {
        name: "reduced mass of a package of 50 mm, as printed",
        reference: "m0 + mn lbc/lab + pi (R^2 - Rmin^2) H rho, relative",
        tolerance: 1e-14,
        reason: "both are algebra",
        measure: |machine| {
            let point = machine.point(&[("holder.package_radius", 0.05)], &[])?;
            Ok(Measured::relative(machine.output(&point, "mass")?, BENCH_MASS.as_printed(0.05)))
        },
    },
    Check {
        name: "contact force at rest of packages of 30 to 60 mm, as printed",
        reference: "(15): the spring takes the growth, the package its weight, relative",
        tolerance: 1e-14,
        reason: "both are algebra",
        measure: contact_force_at_rest,
    },
    Check {
        name: "undamped natural frequency, as printed",
        reference: "sqrt(45800/2.1) = 147.68 rad/s, relative",
        tolerance: 1e-12,
        reason: "both are algebra",
        measure: |machine| {
            let found = natural_frequency(machine)?;
            Ok(Measured::relative(found, (45_800.0_f64 / 2.1).sqrt()))
        },
    },
];

/// Returns sqrt(-dv'/dx) \[rad/s\].
pub(crate) fn natural_frequency(machine: &Machine) -> Result<f64, CheckFailure> {
    let jacobian = machine.rate_jacobian(&machine.point(&[], &[])?);
    let (x, v) = (machine.state_index("holder.x")?, machine.state_index("holder.v")?);
    Ok((-jacobian[(v, x)]).sqrt())
}

/// The study's table of W, in the order of [`HOLDER_POSITIONS`].
pub(crate) const PRINTED_MOBILITY: [i32; 5] = [2, 2, 3, 3, 3];

fn free_decay(machine: &Machine) -> Result<Measured, CheckFailure> {
    let settings = [("force_amplitude", 0.0), ("ovality", 0.0), ("initial_deflection", 1e-3)];
    let start = Deflection { value: 1e-3, rate: 0.0 };
    distance(machine, &settings, |time| BENCH_BOBBIN.motion(time, start, &[], &[]))
}

fn transient(machine: &Machine) -> Result<Measured, CheckFailure> {
    shaken(machine, |t, start, forces, shapes| BENCH_BOBBIN.motion(t, start, forces, shapes))
}

fn printed_transient(machine: &Machine) -> Result<Measured, CheckFailure> {
    let bobbin = BobbinOscillator { mass: BENCH_MASS.as_printed(0.03), ..BENCH_BOBBIN };
    shaken(machine, |t, start, forces, shapes| bobbin.motion_as_printed(t, start, forces, shapes))
}

fn shaken(
    machine: &Machine,
    motion: impl Fn(f64, Deflection, &[Harmonic], &[Harmonic]) -> Deflection,
) -> Result<Measured, CheckFailure> {
    let settings = [
        ("initial_velocity", 0.05),
        ("force_phase", 0.4),
        ("package_force", 10.0),
        ("ovality_phase", -1.1),
        ("eccentricity", 1e-4),
    ];
    let start = Deflection { value: 0.0, rate: 0.05 };
    // The empty bobbin turns with 5.5 m/s over 30 mm, the drum with 110 rad/s.
    let package = Harmonic { amplitude: 10.0, frequency: 5.5 / 0.03, phase: 0.0 };
    let forces = [Harmonic { phase: 0.4, ..BENCH_FORCE }, package];
    let eccentric = Harmonic { amplitude: 1e-4, frequency: 110.0, phase: 0.0 };
    let shapes = [Harmonic { phase: -1.1, ..BENCH_SHAPE }, eccentric];
    distance(machine, &settings, |time| motion(time, start, &forces, &shapes))
}

/// Returns the largest distance over 0.2 s of both states from the closed form.
fn distance(
    machine: &Machine,
    settings: &[(&str, f64)],
    exact: impl Fn(f64) -> Deflection,
) -> Result<Measured, CheckFailure> {
    let run = machine.simulation(settings)?.until(0.2).points(401).rtol(1e-12).run()?;
    let exact = run.times.iter().map(|time| exact(*time));
    let (values, rates): (Vec<f64>, Vec<f64>) = exact.map(|q| (q.value, q.rate)).unzip();
    let deflection = relative_distance(machine.column(&run, "holder.x")?, &values);
    let velocity = relative_distance(machine.column(&run, "holder.v")?, &rates);
    Ok(Measured::error(worse(deflection, velocity)))
}

fn amplitude(machine: &Machine, answer: &Harmonic) -> Result<Measured, CheckFailure> {
    Ok(Measured::relative(steady(machine, answer.frequency)?.norm(), answer.amplitude))
}

fn phase(machine: &Machine, answer: &Harmonic) -> Result<Measured, CheckFailure> {
    Ok(Measured::absolute(steady(machine, answer.frequency)?.arg(), answer.phase))
}

/// Returns A e^(j phase) of the part A cos(p t + phase) of the deflection, by the Fourier sum over
/// one turn of the drum after 1.5 s, when the transient has decayed to e^-33.
fn steady(machine: &Machine, frequency: f64) -> Result<Complex64, CheckFailure> {
    const SAMPLES: u32 = 64;
    let turn = 2.0 * PI / BENCH_FORCE.frequency;
    let times: Vec<f64> =
        (0..SAMPLES).map(|k| 1.5 + turn * f64::from(k) / f64::from(SAMPLES)).collect();
    let run = machine.simulation(&[])?.until(1.5 + turn).times(&times).rtol(1e-12).run()?;
    let deflection = machine.column(&run, "deflection")?;
    let terms = times.iter().zip(deflection);
    let sum: Complex64 =
        terms.map(|(time, value)| Complex64::from_polar(*value, -frequency * time)).sum();
    Ok(sum * 2.0 / f64::from(SAMPLES))
}

pub(super) fn contact_force_at_rest(machine: &Machine) -> Result<Measured, CheckFailure> {
    let mut error = 0.0;
    for radius in [0.03, 0.04, 0.05, 0.06] {
        let settings = [("holder.package_radius", radius), ("ovality", 0.0)];
        let point = machine.point(&settings, &[])?;
        let exact = pressure_over_growth(40.0, 3800.0, &BENCH_MASS, radius);
        error = worse(error, (machine.output(&point, "contact_force")? / exact - 1.0).abs());
    }
    Ok(Measured::error(error))
}

fn reduced_mass(machine: &Machine) -> Result<Measured, CheckFailure> {
    let point = machine.point(&[("holder.package_radius", 0.05)], &[])?;
    Ok(Measured::relative(machine.output(&point, "mass")?, BENCH_MASS.at(0.05)))
}

fn positions_that_differ() -> f64 {
    let pairs = HOLDER_POSITIONS.iter().zip(PRINTED_MOBILITY);
    pairs.filter(|(position, printed)| position.mobility() != *printed).count() as f64
}

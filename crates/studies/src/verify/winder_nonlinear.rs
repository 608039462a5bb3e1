//! Checks of the bobbin on a stiffening layer: without viscosity and disturbances it is the Duffing
//! oscillator, without its cubic term the linear bobbin.

use std::f64::consts::TAU;

use super::sensitivities::{ClosedForm, SMOOTH, of_closed_form};
use super::{Check, CheckFailure, Machine, Measured, relative_distance, worse};
use crate::closed_form::Number;
use crate::closed_form::duffing::Duffing;
use crate::closed_form::winder::{BENCH_BOBBIN, BENCH_FORCE, BENCH_SHAPE, Deflection};
use crate::winder_walk::balance;

const HELD: &str = "the run is held to 1e-12 a step; some thousand steps add up";

pub(super) const CHECKS: &[Check] = &[
    Check {
        name: "free vibration from 2 mm",
        reference: "Jacobi elliptic functions, deflection and velocity relative to the largest",
        tolerance: 1e-9,
        reason: HELD,
        measure: |machine| free_vibration(machine, 2e-3),
    },
    Check {
        name: "free vibration from 8 mm, the cubic term leading",
        reference: "Jacobi elliptic functions, deflection and velocity relative to the largest",
        tolerance: 1e-9,
        reason: HELD,
        measure: |machine| free_vibration(machine, 8e-3),
    },
    Check {
        name: "transient without the cubic term",
        reference: "closed form of the linear bobbin, relative to the largest",
        tolerance: 1e-9,
        reason: HELD,
        measure: linear_limit,
    },
    Check {
        name: "contact force at rest of packages of 30 to 60 mm",
        reference: "(15): the spring takes the growth, the package its weight, relative",
        tolerance: 1e-14,
        reason: "both are algebra",
        measure: super::winder_linear::contact_force_at_rest,
    },
    Check {
        name: "steady motion at the bench speed",
        reference: "harmonic balance with sixteen harmonics, relative to the largest",
        tolerance: 1e-9,
        reason: HELD,
        measure: balanced,
    },
    Check {
        name: "sensitivities of the free vibration from 8 mm",
        reference: "derivatives of Jacobi elliptic functions, over the largest of each",
        tolerance: 1e-8,
        reason: SMOOTH,
        measure: slopes,
    },
];

const LAYER: Duffing =
    Duffing { mass: BENCH_BOBBIN.mass, stiffness: 45_800.0, cubic_stiffness: 2e9 };

fn free_vibration(machine: &Machine, amplitude: f64) -> Result<Measured, CheckFailure> {
    let settings = [
        ("layer.viscosity", 0.0),
        ("force_amplitude", 0.0),
        ("ovality", 0.0),
        ("initial_deflection", amplitude),
    ];
    distance(machine, &settings, |time| LAYER.motion(time, amplitude))
}

fn linear_limit(machine: &Machine) -> Result<Measured, CheckFailure> {
    distance(machine, &[("layer.cubic_stiffness", 0.0)], |time| {
        let now = BENCH_BOBBIN.motion(time, Deflection::default(), &[BENCH_FORCE], &[BENCH_SHAPE]);
        (now.value, now.rate)
    })
}

/// Returns the largest distance over 0.2 s of both states from an exact motion.
fn distance(
    machine: &Machine,
    settings: &[(&str, f64)],
    exact: impl Fn(f64) -> (f64, f64),
) -> Result<Measured, CheckFailure> {
    let run = machine.simulation(settings)?.until(0.2).points(401).rtol(1e-12).run()?;
    let (values, rates): (Vec<f64>, Vec<f64>) = run.times.iter().map(|time| exact(*time)).unzip();
    let deflection = relative_distance(machine.column(&run, "holder.x")?, &values);
    let velocity = relative_distance(machine.column(&run, "holder.v")?, &rates);
    Ok(Measured::error(worse(deflection, velocity)))
}

/// Compares the thirtieth turn of the drum, when the transient has decayed to e^-38.
fn balanced(machine: &Machine) -> Result<Measured, CheckFailure> {
    let turning = BENCH_FORCE.frequency;
    let both = (&BENCH_FORCE, &BENCH_SHAPE);
    let exact = balance::steady(&BENCH_BOBBIN, LAYER.cubic_stiffness, turning, both);
    let exact = exact.ok_or(CheckFailure::Singular)?;
    let time = |k: usize| TAU / turning * (30.0 + k as f64 / balance::SAMPLES as f64);
    let times: Vec<f64> = (0..balance::SAMPLES).map(time).collect();
    let run = machine.simulation(&[])?.until(1.8).times(&times).rtol(1e-12).run()?;
    Ok(Measured::error(relative_distance(machine.column(&run, "holder.x")?, &exact)))
}

fn slopes(machine: &Machine) -> Result<Measured, CheckFailure> {
    let (amplitude, own) = (8e-3, 3800.0);
    let form = ClosedForm {
        settings: &[
            ("layer.viscosity", 0.0),
            ("force_amplitude", 0.0),
            ("ovality", 0.0),
            ("initial_deflection", amplitude),
        ],
        columns: ["holder.x", "holder.v"],
        by: [
            ("layer.stiffness", LAYER.stiffness - own),
            ("layer.cubic_stiffness", LAYER.cubic_stiffness),
            ("initial_deflection", amplitude),
            // The moving mass is 1.9 kg.
            ("holder.bobbin_mass", 1.5),
        ],
        until: 0.1,
        points: 401,
    };
    of_closed_form(machine, &form, |t, [stiffness, cubic_stiffness, amplitude, bobbin]| {
        let mass = bobbin + Number::literal(LAYER.mass - 1.5);
        let stiffness = stiffness + Number::literal(own);
        let (x, v) = Duffing { mass, stiffness, cubic_stiffness }.motion(t, amplitude);
        [x, v]
    })
}

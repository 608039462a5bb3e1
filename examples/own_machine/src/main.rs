//! Runs a simulator emitted from this crate's own spec and compares it with the
//! closed form: once with a fixed step that allocates nothing, as a controller
//! would, and once with the method, tolerance and times the spec asks for.
//!
//! The drive obeys J phi'' + b phi' + c phi = torque from rest. With
//! w0 = sqrt(c/J), zeta = b/(2 sqrt(c J)) < 1 and w = w0 sqrt(1 - zeta^2),
//!
//! ```text
//! phi = torque/c [1 - exp(-zeta w0 t) (cos w t + zeta w0/w sin w t)]
//! ```

mod drive {
    machinist_contract::include_scene!("drive");
}

use std::process::ExitCode;

use drive::{Drive, Parameters, STATES, initial_state, rate, state};
use machinist::{SimulateError, Simulation};

/// Length of a fixed step \[s\]: a 300th of the drive's period.
const STEP: f64 = 1e-3;
/// Fixed steps of the run.
const STEPS: u32 = 2000;
/// Largest deviation of the fixed steps that passes \[rad\].
///
/// The method errs by (w0 STEP)^5/120 of the swing torque/c in a step; summed over
/// a decaying swing that is at most torque/c (w0 STEP)^4/(120 e zeta) = 4e-10.
const TOLERANCE_OF_STEPS: f64 = 1e-9;
/// Largest deviation of the spec's own run that passes \[rad\]: ten times the
/// tolerance 1e-9 that it asks of every step, for a swing of about 0.1 rad.
const TOLERANCE_OF_RUN: f64 = 1e-8;

fn main() -> Result<ExitCode, SimulateError> {
    let parameters = Parameters::<f64>::default();
    let by_steps = deviation_of_fixed_steps(&parameters);
    let by_run = deviation_of_run(&parameters)?;
    println!("largest deviation from the closed form:");
    println!("  fixed steps  {by_steps:.2e} rad, of {TOLERANCE_OF_STEPS:.0e} rad allowed");
    println!("  spec's run   {by_run:.2e} rad, of {TOLERANCE_OF_RUN:.0e} rad allowed");
    let passed = by_steps <= TOLERANCE_OF_STEPS && by_run <= TOLERANCE_OF_RUN;
    Ok(if passed { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}

/// Largest deviation of a run of fixed steps \[rad\]; prints every hundredth step.
fn deviation_of_fixed_steps(parameters: &Parameters<f64>) -> f64 {
    let mut time = 0.0;
    let mut y = initial_state(parameters);
    let mut worst = 0.0;
    println!("{:>6}  {:>12}  {:>12}  {:>10}", "t [s]", "emitted", "closed form", "deviation");
    for step in 1..=STEPS {
        y = runge_kutta_step(time, &y, parameters);
        time = f64::from(step) * STEP;
        let (angle, exact) = (y[state::FLYWHEEL_ANGLE], step_response(time, parameters));
        let deviation = angle - exact;
        worst = larger(worst, deviation.abs());
        if step % 100 == 0 {
            println!("{time:>6.2}  {angle:>12.9}  {exact:>12.9}  {deviation:>10.1e}");
        }
    }
    worst
}

/// One step of the classical Runge-Kutta method of fourth order.
fn runge_kutta_step(time: f64, y: &[f64; STATES], p: &Parameters<f64>) -> [f64; STATES] {
    let along = |slope: &[f64; STATES], step: f64| -> [f64; STATES] {
        std::array::from_fn(|i| y[i] + step * slope[i])
    };
    let k1 = rate(time, y, p);
    let k2 = rate(time + STEP / 2.0, &along(&k1, STEP / 2.0), p);
    let k3 = rate(time + STEP / 2.0, &along(&k2, STEP / 2.0), p);
    let k4 = rate(time + STEP, &along(&k3, STEP), p);
    std::array::from_fn(|i| y[i] + STEP / 6.0 * (k1[i] + 2.0 * k2[i] + 2.0 * k3[i] + k4[i]))
}

/// Largest deviation of the run the spec asks for \[rad\].
fn deviation_of_run(parameters: &Parameters<f64>) -> Result<f64, SimulateError> {
    let trajectory = Simulation::new(&Drive).run()?;
    // A column that is not there deviates from everything.
    let Some(angle) = trajectory.column("flywheel.angle") else { return Ok(f64::INFINITY) };
    let deviations = trajectory
        .times
        .iter()
        .zip(angle)
        .map(|(&time, angle)| (angle - step_response(time, parameters)).abs());
    Ok(deviations.fold(0.0, larger))
}

/// The larger of two deviations; one that is no number stays.
fn larger(a: f64, b: f64) -> f64 {
    if a.is_nan() || b <= a { a } else { b }
}

/// The closed form above \[rad\].
fn step_response(time: f64, p: &Parameters<f64>) -> f64 {
    let natural = (p.mount_stiffness / p.flywheel_inertia).sqrt();
    let ratio = p.mount_damping / (2.0 * (p.mount_stiffness * p.flywheel_inertia).sqrt());
    let damped = natural * (1.0 - ratio * ratio).sqrt();
    let swing = (damped * time).cos() + ratio * natural / damped * (damped * time).sin();
    p.torque / p.mount_stiffness * (1.0 - (-ratio * natural * time).exp() * swing)
}

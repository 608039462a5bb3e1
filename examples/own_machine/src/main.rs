//! Runs a simulator emitted from this crate's own spec, with a fixed step and no
//! allocation, and compares it with the closed form.
//!
//! The drive obeys J phi'' + b phi' + c phi = torque from rest. With
//! w0 = sqrt(c/J), zeta = b/(2 sqrt(c J)) < 1 and w = w0 sqrt(1 - zeta^2),
//!
//! ```text
//! phi = torque/c [1 - exp(-zeta w0 t) (cos w t + zeta w0/w sin w t)]
//! ```

mod drive {
    machinist_scenes::include_scene!("drive");
}

use std::process::ExitCode;

use drive::{Parameters, STATES, initial_state, rate, state};

/// Length of a step \[s\]: a 300th of the drive's period.
const STEP: f64 = 1e-3;
/// Steps of the run.
const STEPS: u32 = 2000;
/// Largest deviation from the closed form that passes \[rad\].
///
/// The method errs by (w0 STEP)^5/120 of the swing torque/c in a step; summed over
/// a decaying swing that is at most torque/c (w0 STEP)^4/(120 e zeta) = 4e-10.
const TOLERANCE: f64 = 1e-9;

fn main() -> ExitCode {
    let parameters = Parameters::<f64>::default();
    let mut time = 0.0;
    let mut y = initial_state(&parameters);
    let mut worst: f64 = 0.0;
    println!("{:>6}  {:>12}  {:>12}  {:>10}", "t [s]", "emitted", "closed form", "deviation");
    for step in 1..=STEPS {
        y = runge_kutta_step(time, &y, &parameters);
        time = f64::from(step) * STEP;
        let exact = step_response(time, &parameters);
        let deviation = y[state::FLYWHEEL_ANGLE] - exact;
        worst = worst.max(deviation.abs());
        if step % 200 == 0 {
            println!("{time:>6.2}  {:>12.9}  {exact:>12.9}  {deviation:>10.1e}", y[state::FLYWHEEL_ANGLE]);
        }
    }
    println!("largest deviation {worst:.2e} rad; {TOLERANCE:.2e} rad is allowed");
    if worst <= TOLERANCE { ExitCode::SUCCESS } else { ExitCode::FAILURE }
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

/// The closed form above \[rad\].
fn step_response(time: f64, p: &Parameters<f64>) -> f64 {
    let natural = (p.mount_stiffness / p.flywheel_inertia).sqrt();
    let ratio = p.mount_damping / (2.0 * (p.mount_stiffness * p.flywheel_inertia).sqrt());
    let damped = natural * (1.0 - ratio * ratio).sqrt();
    let swing = (damped * time).cos() + ratio * natural / damped * (damped * time).sin();
    p.torque / p.mount_stiffness * (1.0 - (-ratio * natural * time).exp() * swing)
}

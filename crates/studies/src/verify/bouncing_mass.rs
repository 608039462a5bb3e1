//! Checks of the mass bouncing on a shaken plate: its stable orbit of one bounce a period.

use super::sensitivities::{ACROSS, against_differences};
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
    Check {
        name: "sensitivities of the first four impacts on a plate at rest",
        reference: "derivatives of time and velocity by restitution, gravity and height, relative",
        tolerance: 1e-6,
        reason: ACROSS,
        measure: slopes_of_impacts,
    },
    Check {
        name: "sensitivities on the shaken plate over 0.5 s",
        reference: "central differences of sixth order, over the largest of each",
        tolerance: 1e-6,
        reason: ACROSS,
        measure: |machine| {
            let by = ["amplitude", "frequency", "height", "speed"];
            against_differences(machine, &by, (0.5, 97), 1e-5)
        },
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

/// Compares falls from rest at h on a plate at rest, with n impacts: with t_0 = sqrt(2 h/g)
///
/// ```text
/// t_n = t_0 (1 + 2 (e + ... + e^(n-1)))     v_n = e^n sqrt(2 g h)
/// ```
///
/// The run determines them: after the n-th impact, u = t - t_n later, x = v_n u - g u^2/2 and v =
/// v_n - g u, so that dt_n = (u dv + u^2 dg/2 - dx)/v_n and dv_n = dv - g dt_n + u dg.
fn slopes_of_impacts(machine: &Machine) -> Result<Measured, CheckFailure> {
    const IMPACTS: i32 = 4;
    let (g, e, h) = (9.81_f64, 0.8_f64, 1.0_f64);
    let fall = (2.0 * h / g).sqrt();
    let powers = |n: i32| (1..n).map(|k| e.powi(k)).sum::<f64>();
    let slopes = |n: i32| (1..n).map(|k| f64::from(k) * e.powi(k - 1)).sum::<f64>();
    let landed = |n: i32| fall * (1.0 + 2.0 * powers(n));
    let leaves = |n: i32| e.powi(n) * (2.0 * g * h).sqrt();
    let by: [(&str, f64); 3] = [("ball.restitution", 0.0), ("ball.gravity", 1.0), ("height", 0.0)];
    let times: Vec<f64> = (1..=IMPACTS).map(|n| f64::midpoint(landed(n), landed(n + 1))).collect();
    let settings = [("amplitude", 0.0), ("height", h), ("speed", 0.0)];
    let run = machine.simulation(&settings)?.until(landed(IMPACTS + 1) - 0.05).times(&times);
    let run = run.rtol(1e-12).method(Method::Dop853).sensitivities(&by.map(|(name, _)| name))?;
    let run = run.run()?;
    let mut error = 0.0;
    for n in 1..=IMPACTS {
        let (row, speed) = (n as usize - 1, leaves(n));
        let u = times[row] - landed(n);
        let exact = [
            (2.0 * fall * slopes(n), f64::from(n) * speed / e),
            (-landed(n) / (2.0 * g), speed / (2.0 * g)),
            (landed(n) / (2.0 * h), speed / (2.0 * h)),
        ];
        for ((name, by_gravity), (time, velocity)) in by.into_iter().zip(exact) {
            let of = |column: &str| run.sensitivity(column, name).map_or(f64::NAN, |all| all[row]);
            let (dx, dv) = (of("ball.x"), of("ball.v"));
            let moved = (u * dv + u * u * by_gravity / 2.0 - dx) / speed;
            let faster = dv - g * moved + u * by_gravity;
            // The first impact does not depend on the restitution.
            error = worse(error, (moved - time).abs() / time.abs().max(landed(n)));
            error = worse(error, ((faster - velocity) / velocity).abs());
        }
    }
    Ok(Measured::error(error))
}

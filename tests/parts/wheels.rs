//! Wheels, gears, bushings and prescribed frames in space.

use machinist_codegen::mechanics::reduce::Keep;
use nalgebra::{Matrix3, Vector3};

use super::{by_small_steps, column, example, off, run};
use crate::own_scene::folder_of_specs;
use crate::spatial::{compared, omega, turned};

const GRAVITY: f64 = 9.81;

fn text_of(part: &str) -> String {
    let path = folder_of_specs().join(format!("parts/spatial/{part}.toml"));
    std::fs::read_to_string(path).expect("an example")
}

/// Moments of inertia of the example's wheel about its axis and across, its mass and its radius.
const WHEEL: [f64; 4] = [0.06, 0.03, 1.0, 0.3];

/// A wheel that leans by a small angle u at rest and rolls straight: with A = inertia across, C =
/// inertia about the axis, s the rate of rolling, and the rate of yaw C s (u - u_0)/A, the lean
/// fulfils (A + m r^2) u'' = m g r u - (C + m r^2) C s^2 (u - u_0)/A. It is stable from
/// s^2 = A m g r/(C (C + m r^2)) on.
#[test]
fn a_rolling_wheel_falls_below_its_limit() {
    let [along, across, mass, radius] = WHEEL;
    let weight = mass * GRAVITY * radius;
    let contact = mass * radius * radius;
    let limit = (across * weight / (along * (along + contact))).sqrt();
    let machine = example("spatial/rolling_wheel", Keep::Needed);
    for share in [0.0, 0.5, 0.9, 1.1, 2.0, 5.0] {
        let (spin, lean) = (share * limit, 1e-6_f64);
        let start = [
            ("flight.turn_w", 1.0),
            ("flight.turn_x", lean / 2.0),
            ("flight.turn_omega_y", spin),
            ("flight.turn_omega_z", 0.0),
        ];
        let found = run_from(&machine, &start, 1.0);
        let fall = weight / (across + contact);
        let hold = along * (along + contact) * spin * spin / (across * (across + contact));
        let (rest, square) = (-hold * lean / (fall - hold), fall - hold);
        let rows = found.times.iter().zip(turns_up(&found));
        for (time, up) in rows {
            let root = square.abs().sqrt() * time;
            let wave = if square > 0.0 { root.cosh() } else { root.cos() };
            let wanted = rest + (lean - rest) * wave;
            assert!((up - wanted).abs() < 2e-4 * lean * wave.abs().max(1.0), "{share} {time} s");
        }
    }
}

/// Vertical component of the wheel's axis.
fn turns_up(found: &machinist::Trajectory) -> Vec<f64> {
    (0..found.times.len()).map(|row| (turned(found, "flight.turn", row) * Vector3::y()).z).collect()
}

fn run_from(
    machine: &machinist_model::ModelSimulator,
    start: &[(&str, f64)],
    until: f64,
) -> machinist::Trajectory {
    let mut simulation = machinist::Simulation::new(machine).until(until).rtol(1e-12);
    for (state, value) in start {
        simulation = simulation.initial_value(state, *value).expect("a state");
    }
    simulation.run().expect("it runs")
}

/// A wheel inclined by theta rolls on a circle: with precession p and the rate s about its axis,
/// (C + m r^2) s p sin = A p^2 sin cos - m g r cos.
#[test]
fn a_rolling_wheel_circles() {
    let [along, across, mass, radius] = WHEEL;
    let machine = example("spatial/rolling_wheel", Keep::Needed);
    for (inclination, precession) in [(1.2_f64, 1.5), (0.7, 3.0), (1.4, -2.0)] {
        let (sin, cos) = inclination.sin_cos();
        let whole = (across * precession * precession * sin * cos - mass * GRAVITY * radius * cos)
            / ((along + mass * radius * radius) * precession * sin);
        // The axis y of the wheel is turned up by a quarter turn less theta about x.
        let up = std::f64::consts::FRAC_PI_2 - inclination;
        // Precession about z, along the axes of the wheel.
        let start = [
            ("flight.turn_w", (up / 2.0).cos()),
            ("flight.turn_x", (up / 2.0).sin()),
            ("flight.turn_omega_x", 0.0),
            ("flight.turn_omega_y", whole),
            ("flight.turn_omega_z", precession * sin),
        ];
        let found = run_from(&machine, &start, 4.0);
        for row in 0..found.times.len() {
            let axis = turned(&found, "flight.turn", row) * Vector3::y();
            assert!((axis.z - cos).abs() < 1e-7, "{inclination}: it leans by {}", axis.z);
            let angle = precession * found.times[row];
            let wanted = Vector3::new(-sin * angle.sin(), sin * angle.cos(), cos);
            assert!((axis - wanted).norm() < 1e-6, "{inclination}");
        }
    }
}

/// (m + 2 m_w + 2 J/r^2) v' = tau/r and (I + 2 I_w + m_w d^2/2 + J d^2/(2 r^2)) w' = -tau d/(2 r),
/// with the torque on the wheel at positive y alone.
#[test]
fn a_wheel_set_is_driven_and_steered_by_one_wheel() {
    for [radius, track, mass] in [[0.3, 1.0, 2.0], [0.2, 0.6, 7.0]] {
        let torque = 0.5;
        let set = [("axle.radius", radius), ("axle.track", track), ("load.mass", mass)];
        let found = run(&example("spatial/wheel_set", Keep::Needed), &set, &[]);
        let (wheel, axis, across, load) = (1.0, 0.06, 0.03, 0.01);
        let rate = torque / radius / (mass + 2.0 * wheel + 2.0 * axis / (radius * radius));
        let inertia =
            load + 2.0 * across + track * track * (wheel / 2.0 + axis / (2.0 * radius * radius));
        let turning = -torque * track / (2.0 * radius) / inertia;
        assert!(off(&found, "speed", |t| rate * t) < 1e-9);
        assert!(off(&found, "axle.omega", |t| turning * t) < 1e-8);
        // x' = v cos phi with phi = w' t^2/2.
        let path = |t: f64, _: &[f64; 2]| {
            let (sin, cos) = (turning * t * t / 2.0).sin_cos();
            [rate * t * cos, rate * t * sin]
        };
        let exact = by_small_steps([0.0; 2], 2.0, 20_000, path);
        for (name, exact) in ["x", "y"].iter().zip(exact) {
            let last = column(&found, name).last().copied().expect("rows");
            assert!((last - exact).abs() < 1e-7, "{name}: {last} instead of {exact}");
        }
    }
}

/// In a housing that floats, the torque between housing and shaft leaves the angular momentum as it
/// is, and supplies tau phi to the energy.
#[test]
fn gears_in_a_floating_housing_keep_the_angular_momentum() {
    for (ratio, angle) in [(-2.0, std::f64::consts::FRAC_PI_2), (3.0, 0.8), (-0.5, 2.0)] {
        let set = [("gear.ratio", ratio), ("gear.angle", angle)];
        let found = run(&example("spatial/bevel_gear", Keep::Needed), &set, &[]);
        let rotor = Matrix3::from_diagonal(&Vector3::new(0.02, 0.012, 0.012));
        let wheel = Matrix3::from_diagonal(&Vector3::new(0.05, 0.03, 0.03));
        let housing = Matrix3::from_diagonal(&Vector3::new(0.2, 0.25, 0.3));
        let turn = nalgebra::Rotation3::from_axis_angle(&Vector3::z_axis(), angle);
        let turn = turn.matrix();
        let whole = housing + rotor + turn * wheel * turn.transpose();
        let spin = Vector3::x() * 0.02 + turn * Vector3::x() * (0.05 / ratio);
        let rate = column(&found, "gear.omega");
        let momentum = |row: usize| {
            let own = whole * omega(&found, "flight.turn", row) + spin * rate[row];
            turned(&found, "flight.turn", row) * own
        };
        let (angle, energy) = (column(&found, "gear.phi"), column(&found, "energy.total"));
        for row in 0..found.times.len() {
            assert!((momentum(row) - momentum(0)).norm() < 1e-8, "{ratio}");
            let supplied = 0.3 * (angle[row] - angle[0]);
            assert!((energy[row] - energy[0] - supplied).abs() < 1e-7, "{ratio}");
        }
    }
}

#[test]
fn wheels_gears_and_bushings_move_as_a_second_derivation_says() {
    for part in ["rolling_wheel", "wheel_set", "spur_gear", "bevel_gear", "bushing", "motion"] {
        compared(&text_of(part));
    }
    let damped = text_of("bushing").replace("damping = 0, turn_damping = 0", "damping = 50");
    compared(&damped);
}

/// (J_b + J_c/ratio^2) phi'' = tau in a housing that is held.
#[test]
fn gears_in_a_fixed_housing_add_their_inertias() {
    for kind in ["spur_gear", "bevel_gear"] {
        let held = text_of(kind)
            .replace("[[joints]]\nconnect = [\"world.frame\", \"flight.a\"]\n\n", "")
            .replace("\"flight.b\"", "\"world.frame\"")
            .replace("[units.flight]\nunit = \"spatial/free\"\n\n", "")
            .replace("\"flight.turn_omega_y\" = 0.4\n", "")
            .replace("turn = \"flight.turn_x\"\n", "");
        let found = crate::spatial::run(&held);
        let rate = 0.3 / (0.02 + 0.05 / 4.0);
        let error = off(&found, "angle", |t| 5.0 * t + rate * t * t / 2.0);
        assert!(error < 1e-8, "{kind}: {error:e}");
    }
}

/// x = v/w sin(w t) with w^2 = c/m, and a turn about y likewise while it is small.
#[test]
fn a_body_on_a_bushing_swings_in_its_frequencies() {
    let found = run(&example("spatial/bushing", Keep::Needed), &[], &[]);
    let rate = (1e5_f64 / 10.0).sqrt();
    assert!(off(&found, "x", |t| 0.1 / rate * (rate * t).sin()) < 1e-8);
    let rate = (1e3_f64 / 0.3).sqrt();
    assert!(off(&found, "turn", |t| 0.2 / rate * (rate * t).sin()) < 1e-4);
    let energy = column(&found, "energy.total");
    assert!(energy.iter().all(|e| (e - energy[0]).abs() < 1e-8));
    // A damper takes c v^2: m x'' = -k x - c x', below its critical damping.
    let damped = run(&example("spatial/bushing", Keep::Needed), &[("mount.damping", 400.0)], &[]);
    let (decay, wave) = (20.0_f64, (1e4_f64 - 400.0).sqrt());
    let exact = |t: f64| 0.1 / wave * (-decay * t).exp() * (wave * t).sin();
    assert!(off(&damped, "x", exact) < 1e-8);
}

/// l phi'' = cos(phi) cos(psi) x'' + l sin(phi) cos(phi) psi'^2 - sin(phi) (g + z'') on a base that
/// moves by x and z and turns by psi.
#[test]
fn a_pendulum_on_a_moving_base_swings_as_its_equation_by_hand() {
    let found = run(&example("spatial/motion", Keep::Needed), &[], &[]);
    let rate = |t: f64, y: &[f64; 2]| {
        let (sin, cos) = y[0].sin_cos();
        let x = -0.9 * (3.0 * t).sin();
        let z = -1.25 * (5.0 * t).cos();
        let turned = 0.5 * sin * cos * 0.16;
        [y[1], (cos * (0.4 * t).cos() * x + turned - sin * (GRAVITY + z)) / 0.5]
    };
    let exact = by_small_steps([0.3, 0.0], 3.0, 60_000, rate);
    let last = column(&found, "angle").last().copied().expect("rows");
    assert!((last - exact[0]).abs() < 1e-7, "{last} instead of {}", exact[0]);
}

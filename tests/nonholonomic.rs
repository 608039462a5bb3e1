//! Bodies that roll in space: the bicycle of the benchmark, and a stone that reverses its spin.

use machinist::Simulation;
use machinist::linear_analysis::{Linearization, Mode, ModeKind, Place, operating_point};
use machinist_codegen::mechanics::reduce::Keep;
use machinist_model::ModelSimulator;
use nalgebra::{Matrix3, Vector3};
use num_complex::Complex64;

use crate::common::column;
use crate::own_scene::of_specs;

/// Returns the eigenvalues of an upright bicycle that runs straight, without those of rolling on.
fn eigenvalues(bicycle: &ModelSimulator, speed: f64) -> Vec<Complex64> {
    let run = [("along.v", speed), ("lean.omega", 0.0)]
        .into_iter()
        .try_fold(Simulation::new(bicycle), |run, (name, value)| run.initial_value(name, value))
        .expect("states");
    let point = operating_point(&run, Place::Initial).expect("a start");
    let modes = Linearization::at(bicycle, point).expect("regular").modes().expect("eigenvalues");
    let moving = modes.iter().filter(|mode| mode.kind != ModeKind::Free);
    moving.map(Mode::eigenvalue).collect()
}

/// Digits of J. P. Meijaard, J. M. Papadopoulos, A. Ruina, A. L. Schwab, Proceedings of the Royal
/// Society A 463 (2007), Table 2 and section 5.
#[test]
fn the_bicycle_of_the_benchmark_has_its_eigenvalues() {
    let bicycle = of_specs("rolling/bicycle", Keep::All);
    let at = |speed: f64, value: Complex64| {
        let found = eigenvalues(&bicycle, speed);
        let off = found.iter().map(|found| (found - value).norm()).fold(f64::MAX, f64::min);
        assert!(off < 1e-9, "{speed} m/s: {value} is not in {found:?}, off by {off:e}");
    };
    at(5.0, Complex64::new(-0.775_341_882_195_85, 4.464_867_713_788_23));
    at(5.0, Complex64::new(-0.322_866_429_004_09, 0.0));
    at(5.0, Complex64::new(-14.078_389_692_798_22, 0.0));
    at(0.0, Complex64::new(3.131_643_247_906_56, 0.0));
    at(0.0, Complex64::new(-3.131_643_247_906_56, 0.0));
    at(0.0, Complex64::new(5.530_943_717_653_93, 0.0));
    at(0.0, Complex64::new(-5.530_943_717_653_93, 0.0));
    let weave = |speed: f64| {
        let found = eigenvalues(&bicycle, speed);
        found.into_iter().find(|value| value.im > 0.0).expect("the weave").re
    };
    let [slower, faster] = [-1e-8, 1e-8].map(|by| weave(4.292_382_536_341_11 + by));
    assert!(slower > 0.0 && faster < 0.0, "{slower:e} {faster:e}");
    // Rounding of the eigenvalues of rolling on, all zero, is far smaller than that of the capsize.
    let capsize = |speed: f64| {
        let found = eigenvalues(&bicycle, speed);
        let slow = found.iter().filter(|value| value.im == 0.0 && value.re.abs() < 1.0);
        slow.map(|value| value.re).max_by(|a, b| a.abs().total_cmp(&b.abs())).expect("the capsize")
    };
    let [slower, faster] = [-1e-3, 1e-3].map(|by| capsize(6.024_262_015_388_37 + by));
    assert!(slower < 0.0 && faster > 0.0, "{slower:e} {faster:e}");
    assert!((slower + faster).abs() < 0.01 * faster, "{slower:e} {faster:e}");
}

#[test]
fn a_bicycle_keeps_its_energy_for_long() {
    let bicycle = of_specs("rolling/bicycle", Keep::All);
    let run = Simulation::new(&bicycle).until(200.0).run().expect("a run");
    let energy = column(&run, "energy.total");
    let off = energy.iter().map(|now| (now - energy[0]).abs()).fold(0.0, f64::max);
    assert!(off < 1e-6 * energy[0], "{off:e}");
}

/// Rates of the upright direction n and of the angular velocity of the stone, along its axes, by
/// Newton's and Euler's laws. With r from the centre of mass to the lowest point, v = r x omega, and
/// the force of the ground is m (v' + omega x v + g n).
fn stone_rates(state: &[f64; 6]) -> [f64; 6] {
    const SQUARES: [f64; 3] = [0.2 * 0.2, 0.03 * 0.03, 0.02 * 0.02];
    const MASS: f64 = 1.0;
    const GRAVITY: f64 = 9.81;
    let n = Vector3::new(state[0], state[1], state[2]);
    let omega = Vector3::new(state[3], state[4], state[5]);
    let squares = Vector3::from(SQUARES);
    let inertia = Matrix3::new(2e-4, -2e-5, 0.0, -2e-5, 1.6e-3, 0.0, 0.0, 0.0, 1.7e-3);
    let n_rate = n.cross(&omega);
    let scaled = squares.component_mul(&n);
    let height = scaled.dot(&n).sqrt();
    let r = -scaled / height + Vector3::new(0.0, 0.0, 0.01);
    let height_rate = scaled.dot(&n_rate) / height;
    let r_rate =
        -squares.component_mul(&n_rate) / height + scaled * (height_rate / (height * height));
    let v = r.cross(&omega);
    let force = MASS * (r_rate.cross(&omega) + omega.cross(&v) + GRAVITY * n);
    let torque = r.cross(&force) - omega.cross(&(inertia * omega));
    let across = r.cross_matrix();
    let omega_rate = (inertia - MASS * across * across).lu().solve(&torque).expect("regular");
    [n_rate.x, n_rate.y, n_rate.z, omega_rate.x, omega_rate.y, omega_rate.z]
}

#[test]
fn a_rattleback_reverses_its_spin_as_the_laws_of_newton_and_euler_say() {
    const STEPS: usize = 300;
    let stone = of_specs("rolling/rattleback", Keep::All);
    let run = Simulation::new(&stone).run().expect("a run");
    let spin = column(&run, "spin");
    assert!(spin[0] < -4.9 && spin.iter().any(|spin| *spin > 4.0), "it does not reverse");
    let energy = column(&run, "energy.total");
    let off = energy.iter().map(|now| (now - energy[0]).abs()).fold(0.0, f64::max);
    assert!(off < 1e-8 * energy[0], "{off:e}");
    // The classical method of Runge and Kutta.
    let tilt = 0.5_f64.to_radians();
    let start = ["turn_omega_x", "turn_omega_y", "turn_omega_z"]
        .map(|name| column(&run, &format!("stone.{name}"))[0]);
    let mut state = [0.0, tilt.sin(), tilt.cos(), start[0], start[1], start[2]];
    let add = |state: &[f64; 6], by: f64, rate: &[f64; 6]| {
        std::array::from_fn::<f64, 6, _>(|index| state[index] + by * rate[index])
    };
    let step = 0.04 / STEPS as f64;
    let mut worst: f64 = 0.0;
    for spin in spin {
        worst = worst.max((state[5] - spin).abs());
        for _ in 0..STEPS {
            let one = stone_rates(&state);
            let two = stone_rates(&add(&state, 0.5 * step, &one));
            let three = stone_rates(&add(&state, 0.5 * step, &two));
            let four = stone_rates(&add(&state, step, &three));
            for index in 0..6 {
                state[index] +=
                    step / 6.0 * (one[index] + 2.0 * (two[index] + three[index]) + four[index]);
            }
        }
    }
    assert!(worst < 1e-5, "{worst:e}");
}

/// Steady motion of a disc of mass m and radius r that leans by a, with Omega about the vertical, from
/// the torque about its centre: (C + m r^2) omega Omega cos a = A Omega^2 sin a cos a - m g r sin a. Its
/// centre runs around a circle of radius omega r/Omega.
#[test]
fn a_disc_rolls_around_a_circle_at_the_rate_of_steady_motion() {
    let disc = of_specs("rolling/disc", Keep::All);
    let (r, m, axis, across, g) = (0.3, 2.0, 0.09, 0.045, 9.81);
    for (lean, precession) in [(0.5, 4.0), (0.2, 1.5), (1.1, 9.0), (0.05, -0.7), (-0.4, 6.0)] {
        let (sine, cosine) = f64::sin_cos(lean);
        let about_axis = sine * (across * precession * precession * cosine - m * g * r)
            / ((axis + m * r * r) * precession * cosine);
        let circle = about_axis * r / precession;
        let values = [("lean", lean), ("precession", precession), ("wobble", 0.0)];
        let run = values
            .into_iter()
            .try_fold(Simulation::new(&disc), |run, (name, value)| run.parameter(name, value))
            .expect("parameters");
        let run = run.rtol(1e-11).until(3.0).run().expect("it rolls");
        let [x, y, leans] = ["x", "y", "leans"].map(|name| column(&run, name));
        for (at, time) in run.times.iter().enumerate() {
            let (sine, cosine) = (precession * time).sin_cos();
            let off = [x[at] - circle * sine, y[at] - circle * (1.0 - cosine), leans[at] - lean];
            let size = off.iter().fold(0.0, |most: f64, off| most.max(off.abs()));
            assert!(size < 1e-7 * (1.0 + circle.abs()), "lean {lean} at {time} s: {off:?}");
        }
    }
}

#[test]
fn a_wobbling_disc_keeps_its_energy() {
    let disc = of_specs("rolling/disc", Keep::All);
    let run = Simulation::new(&disc).rtol(1e-10).until(20.0).run().expect("it rolls");
    let energy = column(&run, "energy.total");
    let most = energy.iter().fold(0.0, |most: f64, now| most.max((now - energy[0]).abs()));
    assert!(most < 1e-7 * energy[0], "{most:e}");
    let leans = column(&run, "leans");
    let [low, high] = [f64::min, f64::max].map(|of| leans.iter().copied().fold(leans[0], of));
    assert!(high - low > 0.05, "it wobbles by {}", high - low);
}

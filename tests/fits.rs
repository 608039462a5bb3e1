//! Parameters from measured runs: comparison with textbook least squares, and coverage of
//! intervals.

use machinist::fit::{
    Bounds, End, Experiment, Fit, Found, Loss, Measured, Plan, Unknown, statistics, students_t,
};
use machinist::{Method, Simulation};
use machinist_scenes::scenes;
use nalgebra::{DMatrix, DVector};

use crate::common::Oscillator;

pub const FREE: (f64, f64) = (f64::NEG_INFINITY, f64::INFINITY);

pub fn unknown(name: &str, start: f64, (low, high): (f64, f64)) -> Unknown {
    Unknown { name: name.to_owned(), start, bounds: Bounds { low, high } }
}

pub fn experiment(times: Vec<f64>, columns: Vec<(String, Vec<f64>)>) -> Experiment {
    Experiment::new("run", Measured { times, columns })
}

/// Returns a normally distributed number of mean 0 and variance 1.
pub fn normal(random: &mut fastrand::Rng) -> f64 {
    let radius = (-2.0 * (1.0 - random.f64()).ln()).sqrt();
    radius * (std::f64::consts::TAU * random.f64()).cos()
}

fn found(fit: &Fit<'_>, scale_of: &(dyn Fn(&str) -> f64 + Sync)) -> Found {
    let found = fit.search(&fit.start(), scale_of, (Loss::Squares, 100), None, &|_| ());
    let found = found.expect("the start can be simulated");
    assert_eq!(found.end, End::Converged);
    found
}

/// Angle = torque b(t) + initial angle c(t) is linear in both, so one system of normal equations
/// gives the solution, with b and c in closed form.
#[test]
fn a_linear_machine_is_fitted_as_the_textbook_does() {
    let times: Vec<f64> = (1..=60).map(|k| 0.05 * f64::from(k)).collect();
    let (decay, spring) = (0.2_f64, 25.0_f64);
    let w = (spring - decay * decay).sqrt();
    let free = |t: f64| (-decay * t).exp() * ((w * t).cos() + decay / w * (w * t).sin());
    let design = DMatrix::from_fn(60, 2, |row, column| match column {
        0 => (1.0 - free((times[row] - 0.7).max(0.0))) / 50.0,
        _ => free(times[row]),
    });
    let mut random = fastrand::Rng::with_seed(7);
    let data = &design * DVector::from_vec(vec![21.0, 0.3])
        + DVector::from_fn(60, |_, _| 0.05 * normal(&mut random));
    let wanted = design.clone().svd(true, true).solve(&data, 1e-14).expect("a solution");

    let simulation = Simulation::new(&Oscillator).method(Method::Dop853).rtol(1e-13);
    let column = ("rotor.angle".to_owned(), data.as_slice().to_vec());
    let experiments = [experiment(times, vec![column])];
    let unknowns = [unknown("torque", 30.0, FREE), unknown("rotor.angle", 0.4, FREE)];
    let fit = Fit::new(&simulation, &unknowns, &experiments);
    let found = found(&fit, &|_| 1.0);
    for (value, wanted) in fit.values(&found.at).iter().zip(wanted.iter()) {
        assert!((value - wanted).abs() <= 1e-9 * wanted.abs(), "{value} for {wanted}");
    }
    // Standard errors follow from the normal equations, in units of the starts.
    let told = statistics(&found.evaluation, Loss::Squares, (&[1.0; 2], 10.0), &[false; 2]);
    let off = &design * &wanted - &data;
    let covariance = (design.tr_mul(&design)).try_inverse().expect("regular");
    let variance = off.norm_squared() / 58.0;
    for (k, size) in [30.0, 0.4].into_iter().enumerate() {
        let wanted = (variance * covariance[(k, k)]).sqrt();
        assert!((told.errors[k] * size / wanted - 1.0).abs() < 1e-8);
    }
}

/// Returns the shares of draws in which the 95 % intervals contain the truth.
fn coverage(
    simulation: &Simulation<'_>,
    unknowns: &[Unknown],
    (output, deviation): (&str, f64),
    times: &[f64],
    draws: usize,
) -> Vec<f64> {
    let truth: Vec<f64> = unknowns.iter().map(|unknown| unknown.start).collect();
    let nothing = [experiment(times.to_vec(), Vec::new())];
    let fit = Fit::new(simulation, unknowns, &nothing);
    let run = fit.run(&nothing[0], &truth, times, false).expect("it runs");
    let exact = &run.column(output).expect("an output")[1..];
    let mut held = vec![0; truth.len()];
    let mut random = fastrand::Rng::with_seed(11);
    for _ in 0..draws {
        let noisy = exact.iter().map(|value| value + deviation * normal(&mut random)).collect();
        let columns = vec![(output.to_owned(), noisy)];
        let experiments = [experiment(times.to_vec(), columns)];
        let fit = Fit::new(simulation, unknowns, &experiments);
        let found = found(&fit, &|_| deviation);
        let (ones, free) = (vec![1.0; truth.len()], vec![false; truth.len()]);
        let told = statistics(&found.evaluation, Loss::Squares, (&ones, 10.0), &free);
        let t = students_t(told.freedom);
        let inner = fit.start();
        for (k, held) in held.iter_mut().enumerate() {
            *held += usize::from((found.at[k] - inner[k]).abs() <= t * told.errors[k]);
        }
    }
    held.iter().map(|held| *held as f64 / draws as f64).collect()
}

#[test]
fn intervals_hold_the_truth_as_often_as_they_say() {
    let simulation = Simulation::new(&Oscillator).method(Method::Dop853);
    let unknowns = [
        unknown("rotor.stiffness", 50.0, (5.0, 500.0)),
        unknown("rotor.damping", 0.8, (0.0, 10.0)),
        unknown("torque_start", 0.7, FREE),
    ];
    let times: Vec<f64> = (1..=40).map(|k| 0.0731 * f64::from(k)).collect();
    let shares = coverage(&simulation, &unknowns, ("rotor.angle", 0.02), &times, 150);
    // 95 % of 150 intervals, with a margin of two and a half standard deviations.
    assert!(shares.iter().all(|share| (0.905..=0.995).contains(share)), "{shares:?}");
}

/// Fits noisy runs of a machine, from a distant start and another one, with scales from the
/// residuals; returns how many of all intervals contain the truth. `cargo bench --bench twins` uses
/// more draws, starts and unknowns.
fn twins(
    scene: &str,
    (until, outputs): (f64, [&str; 2]),
    unknowns: &[(&str, f64)],
    draws: usize,
) -> (usize, usize) {
    let scene = scenes::find_f64(scene).expect("it is built in");
    let simulation = Simulation::new(scene).method(Method::Dop853).rtol(1e-7);
    let truth = |name: &str| {
        let place = (0..scene.shape().parameters).find(|k| scene.parameter(*k).name == name);
        scene.parameter_default(place.expect("a parameter"))
    };
    let truths: Vec<f64> = unknowns.iter().map(|(name, _)| truth(name)).collect();
    let searched: Vec<Unknown> = unknowns
        .iter()
        .zip(&truths)
        .map(|((name, far), at)| unknown(name, far * at, (0.3 * at, 3.0 * at)))
        .collect();
    let times: Vec<f64> = (1..=100).map(|k| 0.01 * until * f64::from(k)).collect();
    let run = simulation.clone().until(until).times(&times).run().expect("it runs");
    let mut random = fastrand::Rng::with_seed(16);
    let plan = Plan { is_robust: false, starts: 2, steps: 100, interrupt: None };
    let (mut held, mut all) = (0, 0);
    for _ in 0..draws {
        let columns = outputs.map(|name| {
            let exact = run.column(name).expect("an output");
            let size = exact.iter().fold(0.0_f64, |most, value| most.max(value.abs()));
            let noisy = exact.iter().map(|value| value + 0.01 * size * normal(&mut random));
            (name.to_owned(), noisy.collect())
        });
        let experiments = [experiment(times.clone(), columns.to_vec())];
        let fit = Fit::new(&simulation, &searched, &experiments);
        let fitted = fit.solve(&plan, &mut |_, _| {}).expect("it can be simulated");
        for (found, truth) in fit.findings(&fitted).parameters.iter().zip(&truths) {
            let holds = |[low, high]: [f64; 2]| low <= *truth && *truth <= high;
            held += usize::from(found.confidence_95.is_some_and(holds));
            all += 1;
        }
    }
    (held, all)
}

/// 95 % of 45 intervals, with a margin of three standard deviations; with errors half as large, 30
/// would contain the truth.
#[test]
fn twins_are_told_apart_from_their_noise() {
    let unknowns = [("coupling.stiffness", 2.5), ("motor.inertia", 1.8), ("motor.alpha_r", 0.6)];
    let (held, all) = twins("saw_gin", (0.5, ["twist", "motor_speed"]), &unknowns, 15);
    assert!(held >= 38 && all == 45, "saw_gin: {held} of {all}");
    let unknowns = [("layer.stiffness", 1.4), ("layer.viscosity", 0.5), ("pair.friction", 0.8)];
    let (held, all) = twins("winder_full", (0.15, ["deflection", "slip"]), &unknowns, 15);
    assert!(held >= 38 && all == 45, "winder_full: {held} of {all}");
}

#[test]
fn what_the_data_cannot_tell_apart_is_named() {
    // Only the product of the coupling factors of stator and rotor has an effect.
    let scene = scenes::find_f64("saw_gin").expect("it is built in");
    let simulation = Simulation::new(scene).method(Method::Tsit5).rtol(1e-6);
    let times: Vec<f64> = (1..=30).map(|k| 0.01 * f64::from(k)).collect();
    let nothing = [experiment(times.clone(), Vec::new())];
    let unknowns = [
        unknown("motor.k_s", 0.956, (0.5, 0.999)),
        unknown("motor.inertia", 4.2, (1.0, 10.0)),
        unknown("motor.k_r", 0.952, (0.5, 0.999)),
    ];
    let start: Vec<f64> = unknowns.iter().map(|unknown| unknown.start).collect();
    let fit = Fit::new(&simulation, &unknowns, &nothing);
    let run = fit.run(&nothing[0], &start, &times, false).expect("it runs");
    let mut random = fastrand::Rng::with_seed(3);
    let noisy = |value: &f64| value + 0.1 * normal(&mut random);
    let data = run.column("motor_speed").expect("an output")[1..].iter().map(noisy).collect();
    let experiments = [experiment(times, vec![("motor_speed".to_owned(), data)])];
    let fit = Fit::new(&simulation, &unknowns, &experiments);
    let found = found(&fit, &|_| 0.1);
    let told = statistics(&found.evaluation, Loss::Squares, (&[1.0; 3], 0.5), &[false; 3]);
    let [direction] = &told.untold[..] else { panic!("{told:?}") };
    let root = std::f64::consts::FRAC_1_SQRT_2;
    assert!((direction.shares[0].abs() - root).abs() < 1e-3 && direction.shares[1].abs() < 1e-3);
    assert!((direction.shares[0] + direction.shares[2]).abs() < 1e-3);
    assert!(told.errors[0].is_infinite() && told.errors[1] < 0.1, "{told:?}");
}

//! Profile likelihood: intervals of linear machines, and of textbook data.

use machinist::fit::{Experiment, Fit, Fitted, Noise, Plan, Profile, Unknown};
use machinist::{Method, Simulation};
use machinist_codegen::mechanics::reduce::Keep;
use machinist_scenes::scenes;

use crate::common::Oscillator;
use crate::fits::{FREE, experiment, normal, unknown};
use crate::own_scene::of_text;

const PLAN: Plan<'_> = Plan { is_robust: false, starts: 1, steps: 100, interrupt: None };

fn solved(fit: &Fit<'_>) -> Fitted {
    fit.solve(&PLAN, &mut |_, _| {}).expect("it can be simulated")
}

fn profiles(fit: &Fit<'_>) -> Vec<Profile> {
    let all: Vec<usize> = (0..fit.unknowns.len()).collect();
    fit.profiles(&solved(fit), &all, &PLAN, &mut |_, _| {})
}

fn ends(profile: &Profile) -> [f64; 2] {
    profile.confidence_95.map(|end| end.unwrap_or_else(|| panic!("{:?}", profile.open)))
}

/// Checks both ends, relative to the size of the interval.
fn assert_interval(profile: &Profile, wanted: [f64; 2], tolerance: f64) {
    let found = ends(profile);
    for (found, end) in found.iter().zip(wanted) {
        let off = (found - end).abs() / (wanted[1] - wanted[0]);
        assert!(off <= tolerance, "{}: {found} for {end}, off by {off:e}", profile.parameter);
    }
}

/// The oscillator is linear in its torque and its initial angle.
#[test]
fn a_linear_machine_has_the_intervals_of_its_standard_errors() {
    let times: Vec<f64> = (1..=60).map(|k| 0.05 * f64::from(k)).collect();
    let mut random = fastrand::Rng::with_seed(7);
    let data = times.iter().map(|t| (-0.2 * t).exp() * (5.0 * t).cos() + 0.1 * normal(&mut random));
    let experiments = [experiment(times.clone(), vec![("rotor.angle".to_owned(), data.collect())])];
    let simulation = Simulation::new(&Oscillator).method(Method::Dop853).rtol(1e-11);
    let unknowns = [unknown("torque", 30.0, FREE), unknown("rotor.angle", 0.4, FREE)];
    let fit = Fit::new(&simulation, &unknowns, &experiments);
    let findings = fit.findings(&solved(&fit));
    for (profile, found) in profiles(&fit).iter().zip(&findings.parameters) {
        let wanted = found.confidence_95.expect("it is told");
        assert_interval(profile, wanted, 1e-6);
        // tau is a straight line with the slope of the standard error.
        let error = found.standard_error.expect("it is told");
        for point in &profile.points {
            let straight = (point.value - found.value) / error;
            assert!((point.tau - straight).abs() < 1e-6 * 2.0, "{point:?}");
            assert!((point.slope * error - 1.0).abs() < 1e-5, "{point:?}");
        }
    }
}

/// Puromycin, treated cells: velocities of a reaction over concentrations (M. Treloar, 1974; D. M.
/// Bates, D. G. Watts, 1988, appendix A1.3). Concentrations stand for times.
const PUROMYCIN: [(f64, f64); 12] = [
    (0.02, 76.0),
    (0.02, 47.0),
    (0.06, 97.0),
    (0.06, 107.0),
    (0.11, 123.0),
    (0.11, 139.0),
    (0.22, 159.0),
    (0.22, 152.0),
    (0.56, 191.0),
    (0.56, 201.0),
    (1.10, 207.0),
    (1.10, 200.0),
];

const MICHAELIS_MENTEN: &str = r#"
[scene]
name = "reaction"
[units.still]
unit = "still"
[parameters.velocity]
value = 200.0
unit = "m/s"
doc = "largest velocity"
[parameters.half]
value = 0.05
unit = "s"
doc = "concentration of half of it"
[run]
until = 1.2
[outputs]
rate = { expression = "velocity*t/(half + t)", unit = "m/s", doc = "velocity" }
x = "still.x"
[define.still.coordinates.x]
unit = "m"
velocity = "v"
[define.still.energy]
kinetic = "1 [kg]*v^2/2"
"#;

/// Returns the sum of squares for a concentration of half velocity, with the best velocity, which
/// is linear.
fn sum_at_half(half: f64) -> f64 {
    let share = |x: f64| x / (half + x);
    let (mut products, mut squares) = (0.0, 0.0);
    for (x, y) in PUROMYCIN {
        products += share(x) * y;
        squares += share(x) * share(x);
    }
    let best = products / squares;
    PUROMYCIN.iter().map(|(x, y)| (y - best * share(*x)).powi(2)).sum()
}

/// Returns the zero of a function between two places.
fn zero(f: impl Fn(f64) -> f64, mut a: f64, mut b: f64) -> f64 {
    for _ in 0..200 {
        let middle = f64::midpoint(a, b);
        if f(middle) * f(a) > 0.0 { a = middle } else { b = middle }
    }
    f64::midpoint(a, b)
}

#[test]
fn intervals_of_puromycin_are_the_published_ones() {
    let machine = of_text(MICHAELIS_MENTEN, Keep::Needed);
    let (times, rates) = PUROMYCIN.iter().copied().unzip();
    let experiments = [experiment(times, vec![("rate".to_owned(), rates)])];
    let simulation = Simulation::new(&machine).method(Method::Dop853);
    let unknowns = [unknown("velocity", 150.0, (10.0, 1000.0)), unknown("half", 0.2, (1e-3, 10.0))];
    let fit = Fit::new(&simulation, &unknowns, &experiments);
    let [velocity, half] = &profiles(&fit)[..] else { panic!("two") };
    // The values are printed by `confint` of R's `nls`, by splines through points of its profiles.
    assert_interval(velocity, [197.302_128_48, 229.290_064_90], 2e-4);
    assert_interval(half, [0.046_925_17, 0.086_159_95], 2e-4);
    // And by elimination: S(half) = S_min + t^2 s^2, with t of 10 degrees of freedom.
    let least = zero(|half| sum_at_half(half + 1e-7) - sum_at_half(half - 1e-7), 0.03, 0.2);
    let (smallest, t) = (sum_at_half(least), 2.228_138_851_964_939);
    let over = |half: f64| sum_at_half(half) - smallest * (1.0 + t * t / 10.0);
    assert_interval(half, [zero(over, 0.01, least), zero(over, 0.3, least)], 1e-6);
    assert!((velocity.value - 212.683_7).abs() < 1e-3 && (half.value - 0.064_121).abs() < 1e-6);
}

#[test]
fn sides_that_do_not_end_say_why() {
    // Only the product of the coupling factors of stator and rotor has an effect.
    let scene = scenes::find_f64("saw_gin").expect("it is built in");
    let simulation = Simulation::new(scene).method(Method::Tsit5).rtol(1e-6);
    let times: Vec<f64> = (1..=30).map(|k| 0.01 * f64::from(k)).collect();
    let truth = experiment(times.clone(), Vec::new());
    let none: [Unknown; 0] = [];
    let fit = Fit::new(&simulation, &none, std::slice::from_ref(&truth));
    let run = fit.run(&truth, &[], &times, false).expect("it runs");
    let mut random = fastrand::Rng::with_seed(3);
    let noisy = |value: &f64| value + 0.1 * normal(&mut random);
    let data = run.column("motor_speed").expect("an output")[1..].iter().map(noisy).collect();
    let experiments = [experiment(times, vec![("motor_speed".to_owned(), data)])];
    let unknowns = [
        unknown("motor.k_s", 0.956, (0.93, 0.98)),
        unknown("motor.k_r", 0.952, (0.93, 0.98)),
        unknown("motor.inertia", 4.2, (1.0, 10.0)),
    ];
    let fit = Fit::new(&simulation, &unknowns, &experiments);
    let found = profiles(&fit);
    for profile in &found[..2] {
        assert_eq!(profile.confidence_95, [None; 2], "{profile:?}");
        let why = profile.open.clone().map(Option::unwrap_or_default);
        assert!(why.iter().all(|why| why.contains("bound")), "{why:?}");
        // The other factor compensates it, within its bounds.
        assert!(profile.points.iter().all(|point| point.tau.abs() < 2.0));
    }
    let [low, high] = ends(&found[2]);
    assert!(low < 4.2 && 4.2 < high && high - low < 2.0, "{low} .. {high}");
}

/// Returns runs with a heavy and a light rotor: the same spring, known noise.
fn two_runs(noise: &Noise) -> [Experiment; 2] {
    let times: Vec<f64> = (1..=40).map(|k| 0.05 * f64::from(k)).collect();
    let mut random = fastrand::Rng::with_seed(5);
    [("heavy", 4.0, 0.3), ("light", 1.0, -0.2)].map(|(name, inertia, angle)| {
        let given = vec![("rotor.inertia".to_owned(), inertia), ("rotor.angle".to_owned(), angle)];
        let plain = Experiment { given, ..experiment(times.clone(), Vec::new()) };
        let simulation = Simulation::new(&Oscillator).method(Method::Dop853);
        let fit = Fit::new(&simulation, &[], std::slice::from_ref(&plain));
        let run = fit.run(&plain, &[], &times, false).expect("it runs");
        let exact = &run.column("rotor.angle").expect("a state")[1..];
        let noisy = exact.iter().enumerate();
        let noisy = noisy.map(|(row, value)| value + noise.at(row, *value) * normal(&mut random));
        let mut measured = plain.measured.clone();
        measured.columns.push(("rotor.angle".to_owned(), noisy.collect()));
        let noise = vec![("rotor.angle".to_owned(), noise.clone())];
        Experiment { name: name.to_owned(), measured, noise, ..plain }
    })
}

#[test]
fn experiments_with_settings_of_their_own_are_fitted_together() {
    let noise = Noise::Of { absolute: 1e-3, share: 0.01 };
    let experiments = two_runs(&noise);
    let simulation = Simulation::new(&Oscillator).method(Method::Dop853);
    let unknowns =
        [unknown("rotor.stiffness", 20.0, (5.0, 500.0)), unknown("rotor.damping", 2.0, FREE)];
    let fit = Fit::new(&simulation, &unknowns, &experiments);
    let findings = fit.findings(&solved(&fit));
    for (found, truth) in findings.parameters.iter().zip([50.0, 0.8]) {
        let [low, high] = found.confidence_95.expect("it is told");
        assert!(low < truth && truth < high && high - low < 0.1 * truth, "{found:?}");
    }
    let names: Vec<&str> = findings.outputs.iter().map(|output| &*output.experiment).collect();
    assert_eq!(names, ["heavy", "light"]);
    // Residuals over the known noise are of size 1, and reported in their unit.
    for output in &findings.outputs {
        assert!((0.7..1.4).contains(&(output.rms / output.scale)), "{output:?}");
    }
    // With the settings of one experiment for both, nothing fits.
    let wrong = experiments.map(|run| Experiment { given: Vec::new(), ..run });
    let fit = Fit::new(&simulation, &unknowns, &wrong);
    let findings = fit.findings(&solved(&fit));
    assert!(findings.outputs.iter().any(|output| output.rms > 5.0 * output.scale));
}

#[test]
fn values_that_are_noisier_count_less() {
    let wild = Noise::Each((0..40).map(|row| if row % 2 == 0 { 0.3 } else { 1e-4 }).collect());
    let simulation = Simulation::new(&Oscillator).method(Method::Dop853);
    let unknowns = [unknown("rotor.stiffness", 40.0, (5.0, 500.0))];
    let error = |experiments: &[Experiment]| {
        let fit = Fit::new(&simulation, &unknowns, experiments);
        (fit.values(&solved(&fit).found.at)[0] - 50.0).abs()
    };
    let known = two_runs(&wild);
    let unknown_noise = known.clone().map(|run| Experiment { noise: Vec::new(), ..run });
    assert!(error(&known) < 0.02, "{}", error(&known));
    assert!(error(&unknown_noise) > 10.0 * error(&known));
}

/// Threads do not change results, to the last bit.
#[test]
fn threads_find_the_same() {
    let experiments = two_runs(&Noise::constant(1e-2));
    let simulation = Simulation::new(&Oscillator).method(Method::Dop853);
    let unknowns = [
        unknown("rotor.stiffness", 20.0, (5.0, 500.0)),
        unknown("rotor.damping", 2.0, (0.01, 10.0)),
    ];
    let lender = |work: &mut dyn FnMut(&dyn machinist_contract::Simulator<f64>)| work(&Oscillator);
    let alone = Fit::new(&simulation, &unknowns, &experiments);
    let all = |fit: &Fit<'_>| {
        let plan = Plan { starts: 4, ..PLAN };
        let mut told = 0;
        let found = fit.solve(&plan, &mut |count, _| told = told.max(count)).expect("found");
        let profiles = fit.profiles(&found, &[0, 1], &plan, &mut |_, _| {});
        let ends: Vec<[u64; 2]> =
            profiles.iter().map(|profile| ends(profile).map(f64::to_bits)).collect();
        let at: Vec<u64> = found.found.at.iter().map(|u| u.to_bits()).collect();
        assert_eq!(told, found.runs);
        (at, ends, found.runs)
    };
    assert_eq!(all(&alone), all(&alone.on_threads(&lender)));
}

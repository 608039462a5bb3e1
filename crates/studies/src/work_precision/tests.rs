use machinist_scenes::scenes::bouncing_mass::BouncingMass;
use machinist_scenes::scenes::four_bar::FourBar;
use machinist_scenes::scenes::saw_gin::SawGin;
use machinist_scenes::scenes::two_mass::TwoMass;

use super::*;
use crate::closed_form::two_mass::{Motion, SAW_GIN, Torques};

fn plan(method: Method, tolerances: &[f64]) -> Plan {
    Plan {
        methods: vec![method],
        tolerances: tolerances.to_vec(),
        runs: 1,
        enough: 1e4,
        longest: 1e4,
        time_limit: None,
    }
}

/// Returns angles and speeds of two rotors under the scene's own torques, from rest.
fn closed_form_of_two_mass(times: &[f64]) -> Vec<KnownState> {
    type Quantity = (&'static str, fn(&Motion) -> f64);
    const TORQUES: Torques = Torques {
        driving: 974.4,
        load: 843.72,
        load_amplitude: 0.0,
        load_frequency: 241.8051,
        load_phase: 0.0,
    };
    let quantities: [Quantity; 3] = [
        ("coupling.twist", |motion| motion.twist().angle),
        ("driver.omega", |motion| motion.driver_speed),
        ("cylinder.omega", |motion| motion.driven_speed),
    ];
    let motions: Vec<Motion> =
        times.iter().map(|time| SAW_GIN.motion(*time, Motion::default(), TORQUES)).collect();
    let values = quantities.iter().map(|(name, quantity)| {
        let values = motions.iter().map(quantity).collect();
        KnownState::new((*name).to_owned(), values, 1.0)
    });
    values.collect()
}

#[test]
fn references_are_as_near_the_truth_as_they_say() {
    let trajectory =
        run(&Simulation::new(&TwoMass), Method::Tsit45, 1e-4, None).run().expect("a run");
    let truth = closed_form_of_two_mass(&trajectory.times);
    let error = distance(&trajectory, &truth);
    assert!(error > 1e-7, "{error:e}");

    let precise =
        Reference::of(&Simulation::new(&TwoMass), Some(&TwoMass), None).expect("a reference");
    assert!(precise.agreement < 1e-20, "{:e}", precise.agreement);
    assert!(precise.name.contains("31 digits"), "{}", precise.name);
    let ours = precise.distance(&trajectory);
    assert!((ours - error).abs() < 1e-13, "{ours:e} instead of {error:e}");

    let converged = Reference::of(&Simulation::new(&TwoMass), None, None).expect("a reference");
    assert!(converged.agreement < 1e-9, "{:e}", converged.agreement);
    assert!(converged.name.contains("differs by"), "{}", converged.name);
    let ours = converged.distance(&trajectory);
    assert!((ours - error).abs() < 1e-9, "{ours:e} instead of {error:e}");
}

#[test]
fn a_reference_in_31_digits_knows_jumps_of_the_load() {
    let precise = Reference::precise(&Simulation::new(&SawGin), &SawGin, None)
        .expect("a run")
        .expect("a reference");
    assert!(precise.agreement < 1e-18, "{:e}", precise.agreement);
    let converged = Reference::converged(&Simulation::new(&SawGin), None).expect("a reference");
    let tight = run(&Simulation::new(&SawGin), Method::Dop853, 1e-12, None).run().expect("a run");
    let (error, other) = (precise.distance(&tight), converged.distance(&tight));
    assert!(error < 1e-9 && other < 1e-9, "{error:e}, {other:e}");
}

#[test]
fn machines_that_turn_unforeseen_have_no_reference_in_31_digits() {
    let bouncing =
        Reference::precise(&Simulation::new(&BouncingMass), &BouncingMass, None).expect("a run");
    let closed_loop =
        Reference::precise(&Simulation::new(&FourBar), &FourBar, None).expect("a run");
    assert_eq!((bouncing, closed_loop), (None, None));
}

#[test]
fn tighter_tolerances_cost_more_and_err_less() {
    let measured =
        measure(&Simulation::new(&SawGin), None, &plan(Method::Tsit45, &[1e-4, 1e-6, 1e-8]))
            .expect("measured");
    let points = &measured.curves[0].points;
    assert_eq!(points.len(), 3);
    for pair in points.windows(2) {
        assert!(pair[1].error < pair[0].error / 10.0, "{pair:?}");
        assert!(pair[1].work.steps > pair[0].work.steps, "{pair:?}");
    }
    assert!((points[0].proportionality() * 1e-4 - points[0].error).abs() <= 1e-15);
}

#[test]
fn a_state_that_is_only_rounding_is_measured_by_its_scale_and_a_small_one_by_itself() {
    let trajectory =
        run(&Simulation::new(&TwoMass), Method::Tsit45, 1e-4, None).run().expect("a run");
    let exact = states(&TwoMass, &trajectory);
    for (size, error) in [(1e-17, 1e-17), (1e-9, 1.0), (1e-5, 1.0), (3.0, 1.0)] {
        let mut noisy = trajectory.clone();
        let mut known = exact.clone();
        let values: Vec<f64> = (0..noisy.times.len()).map(|k| size * (k as f64).sin()).collect();
        let largest = values.iter().fold(0.0_f64, |most, value| most.max(value.abs()));
        known[0] = KnownState::new(known[0].name.clone(), values, 1.0);
        let column = noisy.columns.iter_mut().find(|column| column.name == known[0].name);
        column.expect("a state").values.iter_mut().for_each(|value| *value = 0.0);
        let found = distance(&noisy, &known);
        let expected = if error < 1.0 { largest } else { 1.0 };
        assert!((found / expected - 1.0).abs() < 1e-12, "{size}: {found:e}");
    }
}

#[test]
fn a_tolerance_of_zero_is_refused() {
    let error = measure(&Simulation::new(&TwoMass), None, &plan(Method::Bdf, &[1e-3, 0.0]))
        .expect_err("refused");
    assert_eq!(error, SimulateError::BadTolerance(0.0));
}

#[test]
fn a_value_that_is_no_number_is_no_small_error() {
    let trajectory =
        run(&Simulation::new(&TwoMass), Method::Tsit45, 1e-4, None).run().expect("a run");
    let mut spoilt = trajectory.clone();
    spoilt.columns[1].values[3] = f64::NAN;
    assert!(distance(&spoilt, &states(&TwoMass, &trajectory)).is_nan());
    assert!(distance(&trajectory, &states(&TwoMass, &spoilt)).is_nan());
    let unknown = vec![KnownState::new("nobody".to_owned(), vec![0.0], 1.0)];
    assert!(distance(&trajectory, &unknown).is_nan());
}

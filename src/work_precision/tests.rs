use machinist_scenes::scenes::saw_gin::SawGin;
use machinist_scenes::scenes::two_mass::TwoMass;

use super::*;

fn plan(method: Method, tolerances: &[f64]) -> Plan {
    Plan { methods: vec![method], tolerances: tolerances.to_vec(), runs: 1, longest: 1e4 }
}

#[test]
fn a_reference_without_closed_form_is_as_near_the_truth_as_its_methods_agree() {
    let converged = Reference::converged(&TwoMass).expect("a reference");
    let exact = Reference::of(&TwoMass).expect("a closed form");
    let trajectory = run(&TwoMass, Method::Tsit45, 1e-4).run().expect("a run");
    let (ours, truth) = (converged.distance(&trajectory), exact.distance(&trajectory));
    assert!(truth > 1e-7, "{truth:e}");
    assert!((ours - truth).abs() < 1e-9, "{ours:e} instead of {truth:e}");
    assert!(converged.agreement < 1e-9, "{:e}", converged.agreement);
    assert!(converged.name.contains("differs by"), "{}", converged.name);
}

#[test]
fn tighter_tolerances_cost_more_and_err_less() {
    let measured = measure(&SawGin, &plan(Method::Tsit45, &[1e-4, 1e-6, 1e-8])).expect("measured");
    let points = &measured.curves[0].points;
    assert_eq!(points.len(), 3);
    for pair in points.windows(2) {
        assert!(pair[1].error < pair[0].error / 10.0, "{pair:?}");
        assert!(pair[1].work.steps > pair[0].work.steps, "{pair:?}");
    }
    assert!((points[0].proportionality() * 1e-4 - points[0].error).abs() <= 1e-15);
}

#[test]
fn a_tolerance_of_zero_is_refused() {
    let error = measure(&TwoMass, &plan(Method::Bdf, &[1e-3, 0.0])).expect_err("refused");
    assert_eq!(error, SimulateError::BadTolerance(0.0));
}

#[test]
fn a_value_that_is_no_number_is_no_small_error() {
    let trajectory = run(&TwoMass, Method::Tsit45, 1e-4).run().expect("a run");
    let mut spoilt = trajectory.clone();
    spoilt.columns[1].values[3] = f64::NAN;
    assert!(distance(&spoilt, &states(&trajectory)).is_nan());
    assert!(distance(&trajectory, &states(&spoilt)).is_nan());
    let unknown = vec![("nobody".to_owned(), vec![0.0])];
    assert!(distance(&trajectory, &unknown).is_nan());
}

//! Extreme cases: `auto` is never wrong, no method hangs, and references exist.

use machinist::{Method, SimulateError};
use machinist_studies::stability::{
    ALLOWED, MAX_STEPS, Outcome, Plan, constraint_drift, observed_orders, study,
};

#[test]
fn auto_is_wrong_in_no_extreme_case_and_every_truth_is_known_well_enough() {
    let study = study(&Plan { methods: vec![Method::Auto], ..Plan::default() }).unwrap();
    let mut wrong = Vec::new();
    for (row, outcome) in study.of(Method::Auto) {
        let about = format!("{}: {}: {outcome:?}", row.part, row.case);
        if matches!(outcome, Outcome::Wrong { .. }) {
            wrong.push(about.clone());
        }
        if let Outcome::Right { steps, .. } = outcome {
            assert!(*steps <= MAX_STEPS as u64, "{about}");
        }
        let known = row.agreement <= 0.01 * ALLOWED * study.rtol;
        assert!(known, "{about}, but its truth is {}", row.truth);
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
    let [right, refused, _] = study.counts(Method::Auto);
    assert!(right > 80 && refused < 5, "{right} right, {refused} refused");
}

#[test]
fn an_estimate_that_vanishes_by_chance_misleads_no_explicit_method() {
    // A coupling with fast oscillations: a step once grew by an estimate of nearly zero, and was
    // accepted by another one with an error of 1e5 tolerances.
    let plan = Plan {
        methods: vec![Method::Dop853, Method::Auto],
        rtol: 1e-10,
        only: Some("saw gin: stiffness 1e9, damping 1e2".to_owned()),
        ..Plan::default()
    };
    for cell in &study(&plan).unwrap().rows[0].cells {
        let right = matches!(cell.outcome, Outcome::Right { error, .. } if error < 100.0);
        assert!(right, "{cell:?}");
    }
}

#[test]
fn a_method_that_is_wrong_is_found_out() {
    // States between long steps of diffsol's methods are not controlled.
    let plan = |method, only: &str| Plan {
        methods: vec![method],
        only: Some(only.to_owned()),
        ..Plan::default()
    };
    let found = study(&plan(Method::TrBdf2, "Prothero-Robinson: lambda = -1e8")).unwrap();
    assert_eq!(found.counts(Method::TrBdf2), [0, 0, 1], "{found:?}");
    // An explicit method on a stiff problem runs out of steps and reports that.
    let refused = study(&plan(Method::Tsit5, "Prothero-Robinson: lambda = -1e8")).unwrap();
    match &refused.rows[0].cells[0].outcome {
        Outcome::Refused { word, reason } => {
            assert_eq!(*word, "steps");
            assert!(reason.contains("limit of 50000 steps"), "{reason}");
        }
        other => panic!("{other:?}"),
    }
}

#[test]
fn constraints_stay_kept_over_many_steps() {
    let runs = constraint_drift(1e-6, 3000).unwrap();
    assert_eq!(runs.len(), 2);
    for run in runs {
        println!("{run:?}");
        // Projection removes the drift of steps to rounding, and it does not grow.
        assert!(run.steps >= 2500, "{run:?}");
        assert!(run.before > run.after && run.before < 1e-4 && run.after < 1e-13, "{run:?}");
    }
}

#[test]
fn closed_forms_at_the_limit_of_rounding_beat_steps() {
    // A million periods, and stiff couplings with fast oscillations: `exact` refuses, since
    // rounding exceeds 1e-9, but the errors of steps of any other method would add up to more.
    let plan = |method| Plan {
        methods: vec![method],
        rtol: 1e-9,
        only: Some("undamped oscillation: 1e6 periods".to_owned()),
        ..Plan::default()
    };
    assert_eq!(study(&plan(Method::Exact)).unwrap().counts(Method::Exact), [0, 1, 0]);
    assert_eq!(study(&plan(Method::Auto)).unwrap().counts(Method::Auto), [1, 0, 0]);
}

#[test]
fn a_tolerance_that_makes_no_sense_is_refused() {
    for rtol in [0.0, -1e-6, f64::NAN, 2.0] {
        let refused = study(&Plan { rtol, ..Plan::default() });
        assert!(matches!(refused, Err(SimulateError::BadTolerance(_))), "{rtol}: {refused:?}");
    }
}

#[test]
fn implicit_methods_keep_an_order_on_prothero_and_robinson_however_stiff() {
    for row in observed_orders() {
        println!("{row:?}");
        // Without stiffness the full order shows as far as steps are small enough; for order 13
        // only rounding is left.
        match row.orders[0] {
            Some(plain) => assert!((plain - f64::from(row.nominal)).abs() < 0.2, "{row:?}"),
            None => assert!(row.nominal == 13, "{row:?}"),
        }
        // With any stiffness, errors decrease with the steps, or are rounding.
        let least = row.orders.iter().flatten().fold(f64::INFINITY, |least, o| least.min(*o));
        assert!(least > 2.5, "{row:?}");
        assert!(row.errors.iter().all(|error| *error < 1e-4), "{row:?}");
    }
}

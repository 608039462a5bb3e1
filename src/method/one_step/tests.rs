//! Step sizes from errors, and checks of steps.

use super::{Pace, Trial, end_of_step, first_not_finite, is_too_small, rests, shrink};

#[test]
fn what_stays_where_it_is_rests_wherever_that_is() {
    let atol = [1e-6, 1e-3];
    assert!(rests([(4.0, 4.0), (-2.0, -2.0 + 1e-7)].into_iter(), &atol));
    assert!(!rests([(4.0, 4.0 + 2e-9), (-2.0, -2.0)].into_iter(), &atol));
    assert!(!rests([(4.0, -4.0), (0.0, 0.0)].into_iter(), &atol));
}

#[test]
fn the_last_two_steps_of_a_stretch_are_alike_and_no_sliver_is_left() {
    for (step, expected) in [
        (0.25, (3.25, 0.25, 0.0)),
        (1.25, (4.0, 1.0, 0.0)),
        (1.99, (5.0, 2.0, 1.0)),
        (2.0, (5.0, 2.0, 1.0)),
        (7.0, (5.0, 2.0, 1.0)),
    ] {
        let end = end_of_step(3.0, step, 5.0);
        assert_eq!((end.now, end.tried, end.arrives), expected, "{step}");
    }
}

#[test]
fn steps_are_too_small_by_the_rounding_of_the_clock() {
    for time in [1e3, -1e3] {
        assert!(is_too_small(2.2e-12, time) && !is_too_small(2.3e-12, time), "{time}");
    }
    assert!(is_too_small(0.0, 0.0) && is_too_small(-1.0, 0.0) && is_too_small(f64::NAN, 1.0));
    assert!(!is_too_small(1e-99, 0.0) && is_too_small(1e-101, 0.0));
}

#[test]
fn refused_steps_shrink_by_their_error() {
    let pace =
        Pace { exponent: 0.25, memory: 0.1, safety: 0.8, smallest: 0.1, largest: 5.0, hold: 1.2 };
    let by = |error| shrink(Trial::Error(error), pace);
    assert!((by(16.0) - 0.4).abs() < 1e-15);
    let limits = [by(1e9), by(0.1), by(f64::NAN), by(f64::INFINITY)];
    assert_eq!(limits.map(f64::to_bits), [0.1f64, 0.9, 0.2, 0.2].map(f64::to_bits));
    assert!((shrink(Trial::Unsolved { shrink: 0.3 }, pace) - 0.3).abs() < 1e-15);
    assert!((shrink(Trial::NotFinite { what: "y", index: 0 }, pace) - 0.2).abs() < 1e-15);
    // For accepted steps both errors count: 0.8 / 0.5 * 0.8, within limits.
    let memory = 0.8f64.powf(10.0);
    assert!((pace.factor(0.0625, memory) - 1.28).abs() < 1e-14);
    assert!((pace.factor(0.0625, 1.0) - 1.6).abs() < 1e-14);
    let limits = [pace.factor(0.0, 1.0), pace.factor(1e9, 1.0), pace.factor(0.25, 1.0)];
    assert_eq!(limits.map(f64::to_bits), [5.0f64, 0.1, 1.0].map(f64::to_bits));
}

#[test]
fn the_first_number_that_is_not_finite_is_found_among_others() {
    assert_eq!(first_not_finite(&[0.0, 1e300, -2.0]), None);
    assert_eq!(first_not_finite(&[1.0, f64::NAN, 2.0, f64::INFINITY]), Some(1));
    assert_eq!(first_not_finite(&[f64::NEG_INFINITY]), Some(0));
    assert_eq!(first_not_finite(&[1.0, 1.0, f64::NAN]), Some(2));
}

#[cfg(feature = "implicit")]
#[test]
fn sums_of_squares_of_any_length_are_whole() {
    for length in 0..10 {
        let errors: Vec<f64> = (1..=length).map(f64::from).collect();
        let scales: Vec<f64> = errors.iter().map(|error| 2.0 * error * error).collect();
        let expected: f64 = (1..=length).map(|k| 0.25 / f64::from(k * k)).sum();
        let found = super::sum_of_squares(&errors, &scales);
        assert!((found - expected).abs() < 1e-15, "{length}: {found} {expected}");
    }
}

#[test]
fn an_error_far_below_what_was_foretold_is_not_believed_at_once() {
    let pace =
        Pace { exponent: 0.125, memory: 0.0, safety: 0.9, smallest: 0.2, largest: 8.0, hold: 1.0 };
    // As predicted, or a little better: unchanged.
    assert_eq!(pace.believed(0.2, 1.0, Some((1.0, 0.5))).to_bits(), 0.2f64.to_bits());
    assert_eq!(pace.believed(1e-9, 1.0, None).to_bits(), 1e-9f64.to_bits());
    // Growth at the order of the method, as after a short first step: unchanged.
    let grown = 1e-12 * 8f64.powi(8);
    assert_eq!(pace.believed(grown, 8.0, Some((1.0, 1e-12))).to_bits(), grown.to_bits());
    // Predicted from steps of 2 and 8, the error is 4^8 times the previous one; a hundredth is
    // believed.
    let hundredth = pace.believed(1e-30, 8.0, Some((2.0, 1e-12)));
    assert!((hundredth / (1e-14 * 4f64.powi(8)) - 1.0).abs() < 1e-14);
    // Unpredicted: the step grows less than twofold.
    let believed = pace.believed(1e-9, 1.0, Some((1.0, 0.5)));
    assert!(pace.factor(believed, 0.5) < 2.0 && pace.factor(1e-9, 0.5) > 7.0);
}

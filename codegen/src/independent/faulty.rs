//! Deliberate sign errors in the derivation, each of which the second derivation detects.

use machinist_algebra::cas::Algebra;
use machinist_algebra::faults;
use proptest::strategy::{Strategy as _, ValueTree as _};
use proptest::test_runner::{Config, RngSeed, TestRunner};

use super::systems::recipes;
use super::tests::{LIMIT, deviation};

/// Maximum number of systems until a fault must be detected.
const SYSTEMS: usize = 20;
/// Maximum number of terms of a kind.
const TERMS: usize = 2;

/// Faults that [`machinist_algebra::unless_faulty`] can cause, by their names there.
const FAULTS: [&str; 17] = [
    // `lagrange`.
    "dL/dq",
    "(d2L/dq' dq) q'",
    "(d2L/dq' dz) h",
    "d2L/dq' dt",
    "dD/dq'",
    "M beside its diagonal",
    // `constraint`.
    "gamma",
    "dg/dt",
    "an entry of G",
    // `reduce`.
    "numbers in place of parameters",
    "the rate of a relative position",
    "an output of an absolute position",
    "forces on what is sliced",
    // `fold`.
    "fold a - (-b)",
    "fold (-a) b",
    "fold a/(-b)",
    "fold f(b - a)",
];

#[test]
fn every_wrong_sign_is_found_within_twenty_systems() {
    let mut missed = Vec::new();
    for fault in FAULTS {
        let found = first_found(fault);
        println!("{fault}: found by system {found:?}");
        if found.is_none() {
            missed.push(fault);
        }
    }
    assert!(missed.is_empty(), "not found within {SYSTEMS} systems: {missed:?}");
}

/// Returns the first system that shows a fault.
fn first_found(fault: &'static str) -> Option<usize> {
    let config = Config { rng_seed: RngSeed::Fixed(0xfa01), ..Config::default() };
    let mut runner = TestRunner::new(config);
    (1..=SYSTEMS).find(|_| {
        let recipe = recipes(TERMS).new_tree(&mut runner).expect("a recipe").current();
        faults::with(Some(fault), || deviation(&recipe, Algebra::default())).error > LIMIT
    })
}

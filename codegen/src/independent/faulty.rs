//! Wrong signs where equations are made, each of which the second derivation finds.

use proptest::strategy::{Strategy as _, ValueTree as _};
use proptest::test_runner::{Config, RngSeed, TestRunner};

use super::systems::recipes;
use super::tests::{LIMIT, deviation};
use crate::cas::Algebra;
use crate::faults::{self, Fault};

/// Systems within which a fault is to be found.
const SYSTEMS: usize = 20;
/// Terms of a kind that they have at most.
const TERMS: usize = 2;

#[test]
fn every_wrong_sign_is_found_within_twenty_systems() {
    let mut missed = Vec::new();
    for fault in faults::ALL {
        let found = first_found(fault);
        println!("{fault:?}: found by system {found:?}");
        if found.is_none() {
            missed.push(fault);
        }
    }
    assert!(missed.is_empty(), "not found within {SYSTEMS} systems: {missed:?}");
}

/// Which of the first systems shows a fault.
fn first_found(fault: Fault) -> Option<usize> {
    let config = Config { rng_seed: RngSeed::Fixed(0xfa01), ..Config::default() };
    let mut runner = TestRunner::new(config);
    (1..=SYSTEMS).find(|_| {
        let recipe = recipes(TERMS).new_tree(&mut runner).expect("a recipe").current();
        faults::with(Some(fault), || deviation(&recipe, Algebra::default())).error > LIMIT
    })
}

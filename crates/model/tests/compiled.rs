//! Compiled tapes are compared with interpreted tapes, to the last bit.
#![cfg(feature = "compiled")]

mod support;

use std::sync::Arc;
use std::time::Instant;

use fastrand::Rng;
use machinist_model::compiled::{CompiledTape, is_available};
use machinist_model::evaluate::{Evaluator, Inputs};
use machinist_model::{NodeId, Op, Table, TableId, Tape};

use support::{PARAMETERS, STATES, numbers, random_tape, table, tape};

/// Asserts equal bits; the bits of NaN may differ.
fn assert_same(found: &[f64], expected: &[f64], what: &str) {
    for (index, (a, b)) in found.iter().zip(expected).enumerate() {
        let is_same = a.to_bits() == b.to_bits() || (a.is_nan() && b.is_nan());
        assert!(is_same, "{what}: result {index} is {a:e} and should be {b:e}");
    }
}

fn check(rng: &mut Rng, tape: &Tape, what: &str) {
    let tables: Arc<[Table]> = [table()].into();
    let (interpreted, compiled) = (Evaluator::new(tape), CompiledTape::new(tape, &tables));
    let Some(compiled) = compiled else {
        assert!(!is_available(), "{what} does not compile");
        return;
    };
    for _ in 0..20 {
        let [state, parameters] = [STATES, PARAMETERS].map(|count| numbers(rng, count));
        let [handed, constants] = [4, 4].map(|count| numbers(rng, count));
        let inputs = Inputs {
            time: rng.f64(),
            state: &state,
            parameters: &parameters,
            handed: &handed,
            constants: &constants,
            tables: &tables,
            ..Inputs::default()
        };
        let [mut expected, mut found] = [(); 2].map(|()| vec![0.0; tape.results.len()]);
        interpreted.evaluate(&inputs, &mut expected);
        compiled.evaluate(&inputs, &mut found);
        assert_same(&found, &expected, what);
    }
}

#[test]
fn random_tapes_give_the_same_bits() {
    let mut rng = Rng::with_seed(1);
    for round in 0..300 {
        let length = rng.usize(8..400);
        let calls = [0.0, 0.1, 0.5][round % 3];
        let tape = random_tape(&mut rng, length, calls);
        check(&mut rng, &tape, &format!("round {round}"));
    }
}

#[test]
fn tapes_of_several_pieces_give_the_same_bits() {
    let mut rng = Rng::with_seed(2);
    for calls in [0.0, 0.02, 0.3] {
        let tape = random_tape(&mut rng, 9000, calls);
        check(&mut rng, &tape, "a long tape");
    }
}

#[test]
fn huge_tapes_compile_in_bounded_time() {
    let mut rng = Rng::with_seed(3);
    let tape = random_tape(&mut rng, 100_000, 0.01);
    let begin = Instant::now();
    check(&mut rng, &tape, "a huge tape");
    let seconds = begin.elapsed().as_secs_f64();
    assert!(seconds < 60.0, "{seconds} s, in whatever profile tests are built");
}

#[test]
fn what_breaks_rules_of_models_is_not_compiled() {
    let tables: Arc<[Table]> = [].into();
    let of_table = Op::Table { table: TableId(0), order: 0, argument: NodeId(0) };
    for broken in [
        tape(&[Op::Time, of_table], &[1]),
        tape(&[Op::Neg(NodeId(0))], &[0]),
        tape(&[Op::Time], &[1]),
    ] {
        assert!(CompiledTape::new(&broken, &tables).is_none());
    }
    let empty = CompiledTape::new(&Tape::default(), &tables);
    assert_eq!(empty.is_some(), is_available());
}

#[test]
#[should_panic(expected = "that are read and written")]
fn a_state_that_is_too_short_is_refused() {
    let compiled = CompiledTape::new(&tape(&[Op::State(3)], &[0]), &[].into());
    let inputs = Inputs { state: &[1.0; 3], ..Inputs::default() };
    compiled.expect("that are read and written").evaluate(&inputs, &mut [0.0]);
}

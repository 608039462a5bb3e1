//! Tapes as WebAssembly are compared with interpreted tapes, to the last bit if the host has our
//! own functions.
#![cfg(feature = "wasm")]

#[path = "support/hosted.rs"]
mod hosted;
mod support;

use fastrand::Rng;
use hosted::Hosted;
use machinist_model::evaluate::{Evaluator, Inputs};
use machinist_model::functions::FunctionId;
use machinist_model::wasm::{LONGEST, NotInWasm, module};
use machinist_model::{Model, Op, Parameter, State, StateKind, Tape};

use support::{PARAMETERS, STATES, numbers, random_tape, table, tape};

/// A model with a tape as outputs.
fn model(outputs: Tape) -> Model {
    let name = || machinist_model::Name {
        path: "x".to_owned(),
        ident: "x".to_owned(),
        latex: "x".to_owned(),
    };
    let quantity =
        || machinist_model::Quantity { name: name(), unit: "1".to_owned(), doc: String::new() };
    let state =
        || State { quantity: quantity(), kind: StateKind::FirstOrder, scale: 1.0, is_given: true };
    Model {
        states: (0..STATES).map(|_| state()).collect(),
        parameters: (0..PARAMETERS)
            .map(|_| Parameter { quantity: quantity(), value: 1.0 })
            .collect(),
        wanted: outputs.results.iter().map(|_| quantity()).collect(),
        tables: vec![table()],
        outputs,
        ..Model::default()
    }
}

/// Replaces inputs that need fields or other tapes by parameters.
fn alone(mut tape: Tape) -> Tape {
    for node in &mut tape.nodes {
        if let Op::Handed(entry) | Op::Constant(entry) | Op::Motion(entry) = node.op {
            node.op = Op::Parameter(entry % PARAMETERS as u32);
        }
    }
    tape
}

fn check(rng: &mut Rng, tape: Tape, what: &str) {
    let model = model(alone(tape));
    let evaluator = Evaluator::new(&model.outputs);
    let mut hosted = Hosted::new(module(&model, &[FunctionId::Outputs]).expect("a module"));
    let count = model.wanted.len();
    for _ in 0..10 {
        let [state, parameters] = [STATES, PARAMETERS].map(|count| numbers(rng, count));
        let time = rng.f64();
        let tables = &model.tables;
        let inputs =
            Inputs { time, state: &state, parameters: &parameters, tables, ..Inputs::default() };
        let mut expected = vec![0.0; count];
        evaluator.evaluate(&inputs, &mut expected);
        hosted.set(&parameters);
        let found = hosted.results("outputs", time, &state, count);
        for (index, (a, b)) in found.iter().zip(&expected).enumerate() {
            let is_same = a.to_bits() == b.to_bits() || (a.is_nan() && b.is_nan());
            assert!(is_same, "{what}: result {index} is {a:e} and should be {b:e}");
        }
    }
}

#[test]
fn random_tapes_give_the_same_bits() {
    let mut rng = Rng::with_seed(1);
    for round in 0..100 {
        let length = rng.usize(8..400);
        let calls = [0.0, 0.1, 0.5][round % 3];
        let tape = random_tape(&mut rng, length, calls);
        check(&mut rng, tape, &format!("round {round}"));
    }
}

#[test]
fn long_tapes_give_the_same_bits() {
    let mut rng = Rng::with_seed(2);
    for calls in [0.0, 0.3] {
        let tape = random_tape(&mut rng, 9000, calls);
        check(&mut rng, tape, "a long tape");
    }
}

#[test]
fn chains_deeper_than_any_stack_are_cut() {
    let mut operations = vec![Op::State(0), Op::State(1)];
    for last in 1..20_000 {
        operations.push(Op::Sub(machinist_model::NodeId(last), machinist_model::NodeId(0)));
    }
    check(&mut Rng::with_seed(3), tape(&operations, &[20_000]), "a chain");
}

#[test]
fn what_no_host_takes_is_refused() {
    let mut operations = vec![Op::State(0), Op::State(1)];
    for last in 1..=LONGEST as u32 {
        operations.push(Op::Sub(machinist_model::NodeId(last), machinist_model::NodeId(0)));
    }
    let last = operations.len() as u32 - 1;
    let model = model(tape(&operations, &[last]));
    let refused = module(&model, &[FunctionId::Outputs]).expect_err("too long");
    assert!(matches!(refused, NotInWasm::TooLong { function: "outputs", .. }), "{refused}");
}

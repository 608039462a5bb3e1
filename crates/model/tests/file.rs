//! Model files: the same model gives the same bytes, and every kind of damage is reported.

mod support;

use fastrand::Rng;
use machinist_model::file::{FileError, MARK, Stamped, VERSION, read, seal, write};
use machinist_model::{
    Check, ClosedForm, Model, ModelSimulator, Node, NodeId, Op, Reference, StateKind, TableId, Tape,
};
use support::{matrix, model, random_tape, tape};

/// A machine of one coordinate, with a rate that contains every operation.
fn stamped() -> Stamped {
    let mut rate = random_tape(&mut Rng::with_seed(11), 60, 0.3);
    for node in &mut rate.nodes {
        node.op = match node.op {
            Op::State(entry) => Op::State(entry % 3),
            Op::Handed(_) | Op::Constant(_) => Op::Time,
            op => op,
        };
    }
    rate.results.truncate(3);
    let one = || tape(&[Op::Literal(1.0)], &[0]);
    let mut model = model(1, rate, matrix(1, 1, &[(0, 0)], one()), one());
    model.rate_jacobian = matrix(3, 3, &[(0, 1)], one());
    Stamped { generator: "a test".to_owned(), model }
}

#[test]
fn what_is_written_is_read_and_written_the_same() {
    let stamped = stamped();
    let bytes = write(&stamped);
    let again = read(&bytes).expect("a model");
    assert_eq!(again, stamped);
    assert_eq!(write(&again), bytes);
}

#[test]
fn a_file_cut_off_anywhere_is_refused() {
    let bytes = write(&stamped());
    for length in 0..bytes.len() {
        let error = read(&bytes[..length]).expect_err("cut off");
        let is_named = match error {
            FileError::Foreign => length < MARK.len(),
            FileError::Length { .. } => length >= MARK.len(),
            _ => false,
        };
        assert!(is_named, "{length}: {error}");
    }
    let overfull = [bytes.as_slice(), b"more"].concat();
    assert!(matches!(read(&overfull), Err(FileError::Length { .. })));
}

#[test]
fn ten_thousand_flipped_bits_are_refused() {
    let bytes = write(&stamped());
    let mut rng = Rng::with_seed(5);
    for _ in 0..10_000 {
        let mut damaged = bytes.clone();
        for _ in 0..rng.usize(1..4) {
            let at = rng.usize(0..damaged.len());
            damaged[at] ^= 1 << rng.u32(0..8);
        }
        if damaged != bytes {
            read(&damaged).expect_err("altered");
        }
    }
}

/// Three point masses on links, held level by their start: the links pull along themselves, so all
/// masses fall freely.
#[test]
fn a_model_of_the_previous_version_is_read() {
    let bytes = include_bytes!("models/version_9.model");
    let of_before = read(bytes).expect("a model of version 9");
    let model = &of_before.model;
    assert_eq!((model.name.as_str(), model.constraints.len()), ("pendulum_constrained", 3));
    assert!(model.drawing.is_none() && model.constraints.iter().all(|one| one.friction.is_none()));
    assert_eq!(read(&write(&of_before)).as_ref(), Ok(&of_before), "written in this version");

    let simulator = ModelSimulator::interpreted(model.clone());
    let machine = simulator.single();
    let named = |index: usize| machine.state(index).name.to_owned();
    let state: Vec<f64> = (0..model.states.len())
        .map(|index| match named(index).as_str() {
            "first.x" => 1.0,
            "second.x" => 1.7,
            "third.x" => 2.1,
            _ => 0.0,
        })
        .collect();
    let p: Vec<f64> = model.parameters.iter().map(|parameter| parameter.value).collect();
    let mut rate = vec![0.0; state.len()];
    machine.rate(0.0, &state, &p, &mut rate);
    for (index, rate) in rate.iter().enumerate() {
        let wanted = if named(index).ends_with(".v_y") { -9.81 } else { 0.0 };
        assert!((rate - wanted).abs() < 1e-12, "{}' = {rate}", named(index));
    }

    let mut damaged = bytes.to_vec();
    damaged[100] ^= 1;
    assert_eq!(read(&damaged), Err(FileError::Altered));
}

#[test]
fn another_version_is_refused_by_name() {
    let mut bytes = write(&stamped());
    bytes[16..20].copy_from_slice(&(VERSION + 6).to_le_bytes());
    let error = read(&bytes).expect_err("of another version");
    assert_eq!(error, FileError::Version { found: VERSION + 6 });
    assert!(error.to_string().contains(&format!("version {}", VERSION + 6)), "{error}");
}

/// Files that somebody could write by hand, with a valid hash.
#[test]
fn a_model_that_breaks_a_rule_is_refused_although_its_hash_is_right() {
    type Break = fn(&mut Model);
    let breaks: [(&str, Break); 10] = [
        ("rate", |model| model.rate.results[0] = NodeId(1_000_000)),
        ("rate", |model| model.rate.nodes[0].op = Op::Neg(NodeId(7))),
        ("rate", |model| model.rate.nodes[0].op = Op::State(9)),
        ("rate", |model| model.rate.nodes[0].op = Op::Parameter(u32::MAX)),
        ("rate", |model| model.rate.nodes[0].op = Op::Constant(0)),
        ("rate", |model| {
            let argument = NodeId(0);
            model.rate.nodes[1].op = Op::Table { table: TableId(3), order: 0, argument };
        }),
        ("energy", |model| model.energy.results.clear()),
        ("initial_state", |model| model.initial_state.nodes[0].op = Op::Time),
        ("rate_jacobian", |model| model.rate_jacobian.pattern.entries[0] = (5, 5)),
        ("y_0", |model| model.states[0].kind = StateKind::Position(4)),
    ];
    for (part, damage) in breaks {
        let mut stamped = stamped();
        damage(&mut stamped.model);
        let error = read(&seal(MARK, &stamped)).expect_err(part);
        assert!(matches!(error, FileError::Malformed(_)), "{part}: {error}");
        assert!(error.to_string().contains(part), "{part}: {error}");
    }
}

#[test]
fn a_check_that_reads_the_state_or_tolerates_nothing_is_refused() {
    let values = |tolerance: f64| Check {
        name: "own".to_owned(),
        of: "q_0".to_owned(),
        unit: "1".to_owned(),
        source: String::new(),
        tolerance,
        absolute: None,
        reference: Reference::Values(vec![[0.0, 1.0]]),
    };
    let tape =
        Tape { nodes: vec![Node { op: Op::State(0), name: None }], results: vec![NodeId(0)] };
    let closed = ClosedForm { text: String::new(), tape, tables: vec![] };
    let of_state = Check { reference: Reference::Closed(closed), ..values(1e-6) };
    let unsorted = Reference::Values(vec![[1.0, 0.0], [0.0, 0.0]]);
    let unsorted = Check { reference: unsorted, ..values(1e-6) };
    for check in [values(0.0), values(f64::NAN), of_state, unsorted] {
        let mut stamped = stamped();
        stamped.model.checks = vec![check];
        let error = read(&seal(MARK, &stamped)).expect_err("a rule is broken");
        assert!(matches!(error, FileError::Malformed(_)), "{error}");
    }
    let mut stamped = stamped();
    stamped.model.checks = vec![values(1e-6)];
    assert_eq!(read(&write(&stamped)), Ok(stamped));
}

#[test]
fn content_that_is_no_model_is_refused_although_its_hash_is_right() {
    for content in [vec![0xff_u8; 40], vec![0; 3], (0..200).collect()] {
        let error = read(&seal(MARK, &content)).expect_err("no model");
        assert!(
            matches!(error, FileError::Undecodable { .. } | FileError::Malformed(_)),
            "{error}"
        );
    }
}

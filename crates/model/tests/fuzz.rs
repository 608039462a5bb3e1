//! Model files damaged at random, but with a valid hash, are refused, or they run.
//! `MACHINIST_FUZZ=100000 cargo test -p machinist-model --test fuzz` sets the number of trials.

#[path = "../../../tests/common/damaged_model.rs"]
mod damaged_model;
#[path = "../../../tests/common/mutation.rs"]
mod mutation;
mod support;

use std::sync::Arc;
use std::time::Duration;

use fastrand::Rng;
use machinist_contract::Jumps;
use machinist_contract::field::HANDED;
use machinist_model::file::{Stamped, read, write};
use machinist_model::{
    Attachment, Constraint, Direction, Event, Excitation, FieldModel, Model, NodeId, Op, Place,
    StateKind, Tape,
};

use damaged_model::{damaged, refused_or_run};
use mutation::{Fuzz, Rule};
use support::{matrix, model, name, quantity, random_tape, tape};

/// Returns a random tape with `results` results that reads only existing inputs.
fn random(seed: u64, results: usize, states: u32) -> Tape {
    let mut tape = random_tape(&mut Rng::with_seed(seed), 40, 0.3);
    for node in &mut tape.nodes {
        node.op = match node.op {
            Op::State(entry) if states > 0 => Op::State(entry % states),
            Op::Handed(_) | Op::Constant(_) | Op::State(_) => Op::Parameter(0),
            Op::Time if states == 0 => Op::Parameter(1),
            op => op,
        };
    }
    tape.results = (0..results as u32).map(|k| NodeId(39 - k % 40)).collect();
    tape
}

/// A machine of one coordinate and one first-order state, with all features except fields.
fn machine() -> Model {
    let mut machine =
        model(1, random(1, 3, 3), matrix(1, 1, &[(0, 0)], random(2, 1, 3)), random(3, 1, 3));
    machine.rate_jacobian = matrix(3, 3, &[(0, 1), (1, 0), (2, 2)], random(4, 3, 3));
    machine.time_derivative = random(5, 3, 3);
    machine.initial_state = random(6, 3, 0);
    machine.wanted = vec![quantity("wanted")];
    machine.outputs = random(7, 1, 3);
    machine.states[2].kind = StateKind::Mode;
    machine.events = vec![Event {
        name: name("event"),
        doc: String::new(),
        direction: Direction::Both,
        when: vec![(2, 0.0)],
        sets: vec![1, 2],
    }];
    machine.guards = random(8, 1, 3);
    machine.guard_rates = random(9, 1, 3);
    machine.resets = random(10, 2, 3);
    machine.kink_guards = random(11, 2, 3);
    machine.kink_rates = random(12, 2, 3);
    machine
}

fn constrained() -> Model {
    let mut machine = machine();
    machine.constraints = vec![Constraint {
        name: name("constraint"),
        doc: String::new(),
        unit: "m".to_owned(),
        is_of_positions: true,
        in_modes: false,
        friction: None,
        jumps: Jumps::Nowhere,
    }];
    machine.constraint_values = random(13, 1, 3);
    machine.constraint_rates = random(14, 1, 3);
    machine.constraint_matrix = matrix(1, 1, &[(0, 0)], random(15, 1, 3));
    machine
}

/// A machine with the excitation of linear equations.
fn excited() -> Model {
    let mut machine = machine();
    machine.events.clear();
    for tape in [&mut machine.guards, &mut machine.guard_rates, &mut machine.resets] {
        *tape = Tape::default();
    }
    let values = tape(&[Op::Time, Op::Parameter(0), Op::Mul(NodeId(0), NodeId(1))], &[2, 1, 0, 2]);
    let switches = tape(&[Op::Parameter(0)], &[0]);
    machine.excitation = Some(Excitation { terms: vec![(1, 0)], slopes: vec![], values, switches });
    machine
}

/// A machine with a rod that has one port.
fn distributed() -> Model {
    let mut machine = machine();
    machine.handed = (0..HANDED).map(|_| machine.parameters[0].clone()).collect();
    let states = FieldModel::STATES as u32;
    machine.parameter_jacobian.pattern.columns += HANDED;
    machine.fields = vec![FieldModel {
        quantities: ["u", "u_x", "u_t", "u_xt", "x"].map(quantity),
        attachments: vec![Attachment {
            name: name("end"),
            coordinate: Some(0),
            place: Place::End,
            x: 1.0,
            handed: 0,
        }],
        parameters: vec![0, 1],
        scale: [1.0; 2],
        length: 1.0,
        fixed: [false; 2],
        elements: 4,
        order: 2,
        is_linear: false,
        local: None,
        inertia: random(16, 1, states),
        inertia_gradient: random(17, 3, states),
        force: random(18, 2, states),
        force_jacobian: random(19, 8, states),
        force_gradient: random(20, 8, states),
        energy: random(21, 2, states),
        power: random(22, 3, states),
        places: random(23, 2, states),
        places_gradient: random(24, 4, states),
        initial: random(25, 2, states),
    }];
    machine
}

/// Models found by damaging files: they have a valid hash, and panicked or exhausted the memory
/// when they were run.
#[test]
fn results_too_many_and_powers_too_high_are_refused() {
    type Break = fn(&mut Model);
    let breaks: [(&str, Model, Break); 5] = [
        ("energy", distributed(), |model| model.fields[0].energy.results.push(NodeId(0))),
        ("initial", distributed(), |model| model.fields[0].initial.results.clear()),
        ("inertia", distributed(), |model| model.fields[0].inertia.results.clear()),
        ("finite", distributed(), |model| model.fields[0].length = f64::NAN),
        ("power", excited(), |model| {
            model.excitation.as_mut().expect("an excitation").terms[0].1 = u32::MAX;
        }),
    ];
    for (part, mut model, damage) in breaks {
        damage(&mut model);
        let bytes = write(&Stamped { generator: "a test".to_owned(), model });
        let error = read(&bytes).expect_err(part);
        assert!(error.to_string().contains(part), "{part}: {error}");
    }
}

#[test]
fn damaged_models_are_refused_or_run() {
    let models = [machine(), constrained(), excited(), distributed()];
    let models = models.map(|model| {
        let bytes = write(&Stamped { generator: "a test".to_owned(), model });
        read(&bytes).expect("a model");
        refused_or_run(&bytes).expect("it runs");
        bytes
    });
    let make = move |rng: &mut Rng| {
        let [one, other] = [(); 2].map(|()| &models[rng.usize(0..models.len())]);
        damaged(rng, one, other)
    };
    let rule: Rule = Arc::new(refused_or_run);
    Fuzz { name: "models", few: 400, patience: Duration::from_secs(2) }.run(make, &rule);
}

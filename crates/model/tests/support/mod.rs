//! Tapes and models for tests.

#![allow(dead_code, reason = "every test takes what it needs")]

use fastrand::Rng;
use machinist_model::{
    Coordinate, Freeze, Function, MatrixTape, Model, Name, Node, NodeId, Op, Parameter, Quantity,
    Reduction, RunDefaults, SparsityPattern, State, StateKind, Table, TableId, Tape,
};

pub const STATES: usize = 6;
pub const PARAMETERS: usize = 5;

/// A tape of the given operations.
pub fn tape(ops: &[Op], results: &[u32]) -> Tape {
    let nodes = ops.iter().map(|&op| Node { op, name: None }).collect();
    Tape { nodes, results: results.iter().copied().map(NodeId).collect() }
}

/// A random tape with every operation, on nodes before it, mostly near ones.
pub fn random_tape(rng: &mut Rng, length: usize, calls: f64) -> Tape {
    let mut ops: Vec<Op> = Vec::with_capacity(length);
    for index in 0..length {
        ops.push(if index < 4 || rng.f64() < 0.1 {
            leaf(rng)
        } else {
            operation(rng, index, calls)
        });
    }
    let results: Vec<u32> =
        (0..STATES as u32).map(|k| (length as u32 - 1).saturating_sub(k)).collect();
    let mut tape = tape(&ops, &results);
    // One in the middle, one twice, and a leaf.
    tape.results.extend([NodeId(length as u32 / 2), NodeId(length as u32 - 1), NodeId(0)]);
    tape
}

fn leaf(rng: &mut Rng) -> Op {
    match rng.u32(0..6) {
        0 => Op::Literal([0.0, -0.0, 1.0, -1.25, 1e-3][rng.usize(0..5)]),
        1 => Op::Time,
        2 | 3 => Op::State(rng.u32(0..STATES as u32)),
        4 => Op::Constant(rng.u32(0..4)),
        _ => match rng.u32(0..PARAMETERS as u32 + 4) {
            entry if entry < PARAMETERS as u32 => Op::Parameter(entry),
            entry => Op::Handed(entry - PARAMETERS as u32),
        },
    }
}

fn operation(rng: &mut Rng, index: usize, calls: f64) -> Op {
    let [a, b, c, d] = std::array::from_fn(|_| {
        let back =
            if rng.f64() < 0.8 { rng.usize(1..=index.min(40)) } else { rng.usize(1..=index) };
        NodeId((index - back) as u32)
    });
    if rng.f64() < calls {
        return match rng.u32(0..20) {
            0 => Op::Powf(a, b),
            1 => Op::Table { table: TableId(0), order: rng.u32(0..5), argument: a },
            2..5 => Op::Call(Function::Sin, a),
            5..8 => Op::Call(Function::Cos, a),
            8..10 => Op::Call(Function::Tanh, a),
            _ => Op::Call(Function::ALL[rng.usize(0..Function::ALL.len())].0, a),
        };
    }
    match rng.u32(0..12) {
        0 => Op::Neg(a),
        1..4 => Op::Add(a, b),
        4..6 => Op::Sub(a, b),
        6..9 => Op::Mul(a, b),
        9 => Op::Div(a, b),
        10 => Op::Powi(a, [0, 1, 2, 3, -1, -2, 7, 31][rng.usize(0..8)]),
        _ => Op::SelectLess { lhs: a, rhs: b, then: c, otherwise: d },
    }
}

/// Numbers between -2 and 2, sometimes a special one.
pub fn numbers(rng: &mut Rng, count: usize) -> Vec<f64> {
    let mut number = || match rng.u32(0..40) {
        0 => 0.0,
        1 => -0.0,
        2 => f64::NAN,
        3 => f64::INFINITY,
        4 => 3e8,
        _ => 4.0 * rng.f64() - 2.0,
    };
    (0..count).map(|_| number()).collect()
}

/// The spline through (0, 0), (1, 1), (3, 0).
pub fn table() -> Table {
    Table {
        name: name("table"),
        knots: vec![0.0, 1.0, 3.0],
        coefficients: vec![[0.0, 1.25, 0.0, -0.25], [1.0, 0.5, -0.75, 0.125]],
    }
}

pub fn name(path: &str) -> Name {
    Name { path: path.to_owned(), ident: path.to_owned(), latex: String::new() }
}

pub fn quantity(path: &str) -> Quantity {
    Quantity { name: name(path), unit: "1".to_owned(), doc: String::new() }
}

pub fn matrix(rows: usize, columns: usize, entries: &[(u32, u32)], tape: Tape) -> MatrixTape {
    MatrixTape {
        pattern: SparsityPattern { rows, columns, entries: entries.to_vec() },
        tape,
        solve: None,
    }
}

/// Builder of tapes.
#[derive(Default)]
pub struct Writer(Vec<Op>);

impl Writer {
    pub fn push(&mut self, op: Op) -> NodeId {
        self.0.push(op);
        NodeId(self.0.len() as u32 - 1)
    }

    pub fn finish(self, results: &[NodeId]) -> Tape {
        tape(&self.0, &results.iter().map(|id| id.0).collect::<Vec<_>>())
    }
}

/// A model of `n` coordinates and one first-order state with this rate, mass matrix and forcing;
/// all other functions are zero.
pub fn model(n: usize, rate: Tape, mass: MatrixTape, forcing: Tape) -> Model {
    let states = 2 * n + 1;
    let zeros = |count: usize| tape(&[Op::Literal(0.0)], &vec![0; count]);
    let state = |index: usize| State {
        quantity: quantity(&format!("y_{index}")),
        kind: match index {
            _ if index < n => StateKind::Position(index as u32),
            _ if index < 2 * n => StateKind::Velocity((index - n) as u32),
            _ => StateKind::FirstOrder,
        },
        scale: 1.0,
        is_given: true,
    };
    let coordinate = |index: usize| Coordinate {
        position: quantity(&format!("q_{index}")),
        velocity: quantity(&format!("q_{index}_dot")),
    };
    let parameter =
        |index: usize| Parameter { quantity: quantity(&format!("p_{index}")), value: 1.0 };
    Model {
        drawing: None,
        requirements: Vec::new(),
        required: Tape::default(),
        starts_in_equilibrium: false,
        checks: Vec::new(),
        name: "machine".to_owned(),
        title: String::new(),
        doc: String::new(),
        source: String::new(),
        files: vec![],
        coordinates: (0..n).map(coordinate).collect(),
        states: (0..states).map(state).collect(),
        quadratures: 0,
        parameters: (0..PARAMETERS).map(parameter).collect(),
        handed: vec![],
        motion: None,
        wanted: vec![],
        at_once: vec![],
        tables: vec![table()],
        run: RunDefaults {
            from: 0.0,
            until: 1.0,
            points: 11,
            times: Vec::new(),
            rtol: 1e-6,
            method: "taylor".to_owned(),
        },
        freeze: Freeze::default(),
        reduction: Reduction::default(),
        initial_state: zeros(states),
        discontinuities: Tape::default(),
        rate,
        rate_jacobian: matrix(states, states, &[], Tape::default()),
        parameter_jacobian: matrix(states, PARAMETERS, &[], Tape::default()),
        time_derivative: zeros(states),
        mass_matrix: mass,
        forcing,
        outputs: Tape::default(),
        energy: zeros(3),
        power_balance: zeros(3),
        excitation: None,
        events: vec![],
        guards: Tape::default(),
        guard_rates: Tape::default(),
        kink_guards: Tape::default(),
        kink_rates: Tape::default(),
        saturating_arguments: Tape::default(),
        resets: Tape::default(),
        relations: vec![],
        constraints: vec![],
        constraint_values: Tape::default(),
        constraint_rates: Tape::default(),
        constraint_matrix: matrix(0, n, &[], Tape::default()),
        fields: vec![],
    }
}

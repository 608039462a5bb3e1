//! Handwritten models, made without the usual stages.

#![allow(dead_code, reason = "tests of other crates take what they need")]

pub mod machines;
mod pendulum;

use machinist_algebra::expr::Expr;
use machinist_codegen::scene::system::{
    Coordinate, Definition, FirstOrderState, LagrangianSystem, Parameter,
};
use machinist_model::{
    Function, MatrixTape, Model, Name, Node, NodeId, Op, Quantity, SparsityPattern, State,
    StateKind, TableId, Tape,
};

use pendulum::{GRAVITY, LAG, LENGTH, pendulum_of};
pub use pendulum::{pendulum, pendulum_system};

/// Builds a tape, and writes equal operations once.
#[derive(Default)]
pub struct Builder {
    tape: Tape,
}

impl Builder {
    pub fn push(&mut self, op: Op) -> NodeId {
        if let Some(known) = self.tape.nodes.iter().position(|node| node.op == op) {
            return NodeId(known as u32);
        }
        self.tape.nodes.push(Node { op, name: None });
        NodeId(self.tape.nodes.len() as u32 - 1)
    }

    pub fn named(&mut self, name: &str, id: NodeId) -> NodeId {
        self.tape.nodes[id.0 as usize].name = Some(name.to_owned());
        id
    }

    pub fn number(&mut self, value: f64) -> NodeId {
        self.push(Op::Literal(value))
    }

    pub fn state(&mut self, entry: u32) -> NodeId {
        self.push(Op::State(entry))
    }

    pub fn parameter(&mut self, entry: u32) -> NodeId {
        self.push(Op::Parameter(entry))
    }

    pub fn product(&mut self, factors: &[NodeId]) -> NodeId {
        let product = factors.iter().copied().reduce(|a, b| self.push(Op::Mul(a, b)));
        product.expect("a factor")
    }

    pub fn finish(mut self, results: Vec<NodeId>) -> Tape {
        self.tape.results = results;
        self.tape
    }
}

/// Returns the tape of one closure.
pub fn tape(build: impl FnOnce(&mut Builder) -> Vec<NodeId>) -> Tape {
    let mut builder = Builder::default();
    let results = build(&mut builder);
    builder.finish(results)
}

pub fn quantity(path: &str, unit: &str, doc: &str) -> Quantity {
    let ident = path.replace('.', "_");
    let name = Name { path: path.to_owned(), ident, latex: String::new() };
    Quantity { name, unit: unit.to_owned(), doc: doc.to_owned() }
}

pub fn zero() -> Expr {
    Expr::Sum(vec![])
}

fn parameter(path: &str, unit: &str, value: f64, doc: &str) -> Parameter {
    Parameter { quantity: quantity(path, unit, doc), value, tunable: true }
}

fn pattern(rows: usize, columns: usize, entries: &[(u32, u32)]) -> SparsityPattern {
    SparsityPattern { rows, columns, entries: entries.to_vec() }
}

/// Returns the description of a system with all coordinates in the state, without tapes.
fn described(system: &LagrangianSystem) -> Model {
    let coordinates: Vec<machinist_model::Coordinate> = system
        .coordinates
        .iter()
        .map(|c| machinist_model::Coordinate {
            position: c.position.clone(),
            velocity: c.velocity.clone(),
        })
        .collect();
    let state = |quantity: &Quantity, kind, scale| State {
        quantity: quantity.clone(),
        kind,
        scale,
        is_given: true,
    };
    let of_coordinates = || system.coordinates.iter().zip(0..);
    let positions =
        of_coordinates().map(|(c, id)| state(&c.position, StateKind::Position(id), c.scale[0]));
    let velocities =
        of_coordinates().map(|(c, id)| state(&c.velocity, StateKind::Velocity(id), c.scale[1]));
    let first_order = system.first_order.iter();
    let first_order = first_order.map(|z| state(&z.quantity, StateKind::FirstOrder, z.scale));
    let parameters = system.parameters.iter().map(|parameter| machinist_model::Parameter {
        quantity: parameter.quantity.clone(),
        value: parameter.value,
    });
    let files = system.files.iter().map(|file| machinist_model::SourceFile {
        label: file.label.clone(),
        sha256: file.sha256.clone(),
    });
    Model {
        requirements: Vec::new(),
        required: Tape::default(),
        name: system.name.clone(),
        title: system.title.clone(),
        doc: system.doc.clone(),
        source: system.source.clone(),
        files: files.collect(),
        coordinates,
        states: positions.chain(velocities).chain(first_order).collect(),
        parameters: parameters.collect(),
        wanted: system.outputs.iter().map(|output| output.quantity.clone()).collect(),
        tables: system.tables.clone(),
        run: system.run.clone(),
        constraint_matrix: MatrixTape {
            solve: None,
            pattern: pattern(0, system.coordinates.len(), &[]),
            tape: Tape::default(),
        },
        ..Model::default()
    }
}

/// Text that would be code if it escaped from a comment, a string or a link.
pub const HOSTILE: &str = "*/ } fn main() {} /* ` [main](x) <b> \"; // \\ \u{202e}\r\n    let code = 1;\n# [`x`]\n```\nlet y;";

/// Returns a scene with every operation on its tape of outputs, and with names and texts that
/// need care.
pub fn oddities() -> Model {
    let mut system = pendulum_system();
    system.name = String::from("oddities");
    system.title = HOSTILE.into();
    system.doc = HOSTILE.into();
    system.source = HOSTILE.into();
    system.files[0].label = "scenes/oddities.toml".into();
    (system.run.points, system.run.times) = (3, vec![0.0, 1e-3, 2.0]);
    system.coordinates[0].position = quantity("state", "rad", HOSTILE);
    system.coordinates[0].velocity = quantity("STATES", "rad/s", HOSTILE);
    system.first_order[0].quantity = quantity("p", HOSTILE, HOSTILE);
    system.parameters[0].quantity = quantity("STATES", "kg", HOSTILE);
    system.parameters[1].quantity = quantity("time", "m", HOSTILE);
    let every_output = tape(every_operation);
    let outputs = (0..every_output.results.len()).map(|index| Definition {
        quantity: quantity(&format!("output_{index}"), "1", HOSTILE),
        expr: zero(),
    });
    system.outputs = outputs.collect();
    Model { outputs: every_output, starts_in_equilibrium: true, ..pendulum_of(&system) }
}

fn every_operation(b: &mut Builder) -> Vec<NodeId> {
    let (x, y, z) = (b.state(0), b.state(1), b.state(2));
    let (k, time) = (b.parameter(1), b.push(Op::Time));
    let mut results = calls(b, x);
    // Association and precedence: each pair differs in the last bits.
    let sum = b.push(Op::Add(x, y));
    results.push(b.push(Op::Add(sum, z)));
    let sum = b.push(Op::Add(y, z));
    results.push(b.push(Op::Add(x, sum)));
    let difference = b.push(Op::Sub(y, z));
    results.push(b.push(Op::Sub(x, difference)));
    let product = b.push(Op::Mul(y, z));
    results.push(b.push(Op::Mul(x, product)));
    let quotient = b.push(Op::Div(y, z));
    results.push(b.push(Op::Div(x, quotient)));
    results.push(b.push(Op::Mul(x, quotient)));
    let minus = b.push(Op::Neg(sum));
    results.push(b.push(Op::Mul(minus, k)));
    let minus = b.push(Op::Neg(minus));
    results.push(b.push(Op::Neg(minus)));
    for exponent in [-3, -1, 0, 1, 2, 3, 7] {
        let minus = b.push(Op::Neg(y));
        results.push(b.push(Op::Powi(minus, exponent)));
    }
    let size = b.push(Op::Call(Function::Abs, y));
    let exponent = b.number(-2.5);
    results.push(b.push(Op::Powf(size, exponent)));
    results.push(b.push(Op::SelectLess { lhs: x, rhs: y, then: z, otherwise: time }));
    for order in 0..4 {
        results.push(b.push(Op::Table { table: TableId(0), order, argument: z }));
    }
    results.push(long_sum(b, x, y));
    let tau = b.number(std::f64::consts::TAU);
    results.push(b.push(Op::Mul(tau, time)));
    results
}

fn calls(b: &mut Builder, x: NodeId) -> Vec<NodeId> {
    let size = b.push(Op::Call(Function::Abs, x));
    let one = b.number(1.0);
    let more = b.push(Op::Add(one, size));
    let less = b.push(Op::Div(x, more));
    let positive = [Function::Sqrt, Function::Ln].map(|f| b.push(Op::Call(f, more)));
    let bounded = [Function::Asin, Function::Acos].map(|f| b.push(Op::Call(f, less)));
    let any = [
        Function::Exp,
        Function::Sin,
        Function::Cos,
        Function::Tan,
        Function::Atan,
        Function::Sinh,
        Function::Cosh,
        Function::Tanh,
    ]
    .map(|f| b.push(Op::Call(f, x)));
    [positive.to_vec(), bounded.to_vec(), any.to_vec()].concat()
}

/// Returns a sum of sixty products, which is too long for one expression.
fn long_sum(b: &mut Builder, x: NodeId, y: NodeId) -> NodeId {
    let mut sum = b.push(Op::Mul(x, y));
    for index in 0..60 {
        let weight = b.number(0.1 + 0.37 * f64::from(index));
        let term = b.push(Op::Mul(weight, if index % 2 == 0 { x } else { y }));
        sum = b.push(if index % 3 == 0 { Op::Sub(term, sum) } else { Op::Add(sum, term) });
    }
    sum
}

/// Returns an oscillator, x' = v and v' = -x, and a first-order state for each kind of operation
/// on x, v, time and parameters: z' = operation.
pub fn recurrences() -> Model {
    let rate = tape(|b| {
        let (x, v) = (b.state(0), b.state(1));
        let minus_x = b.push(Op::Neg(x));
        let mut results = vec![v, minus_x];
        results.extend(functions(b, x, v));
        results.extend(arithmetic(b, x, v));
        results.extend(of_time(b, x));
        results
    });
    let states = rate.results.len();
    let mut system = pendulum_system();
    system.first_order = (2..states)
        .map(|index| FirstOrderState {
            quantity: quantity(&format!("z_{index}"), "1", ""),
            rate: zero(),
            initial: zero(),
            scale: 1.0,
            is_mode: false,
        })
        .collect();
    let mut model = bare(system, "recurrences", rate);
    model.mass_matrix = MatrixTape {
        solve: None,
        pattern: pattern(1, 1, &[(0, 0)]),
        tape: tape(|b| vec![b.number(1.0)]),
    };
    model.forcing = tape(|b| {
        let x = b.state(0);
        vec![b.push(Op::Neg(x))]
    });
    model
}

/// Returns two coordinates whose mass matrix varies, like those of a double pendulum:
///
/// ```text
/// [2  c] q_0''   f_0     c = cos(q_0 - q_1)    f_0 = sin(q_1 - q_0) q_1'^2 - 2 g sin q_0
/// [c  1] q_1'' = f_1                           f_1 = sin(q_0 - q_1) q_0'^2 - g sin q_1
/// ```
pub fn coupled() -> Model {
    let rate = tape(|b| {
        let (c, f) = (coupling(b), coupled_forcing(b));
        let (two, c_squared) = (b.number(2.0), b.push(Op::Mul(c, c)));
        let determinant = b.push(Op::Sub(two, c_squared));
        let solved = [(1.0, f[0], f[1]), (2.0, f[1], f[0])].map(|(own, own_f, other_f)| {
            let own = b.number(own);
            let (own, other) = (b.push(Op::Mul(own, own_f)), b.push(Op::Mul(c, other_f)));
            let numerator = b.push(Op::Sub(own, other));
            b.push(Op::Div(numerator, determinant))
        });
        vec![b.state(2), b.state(3), solved[0], solved[1]]
    });
    let mut system = pendulum_system();
    let coordinate = |index: usize| Coordinate {
        position: quantity(&format!("q_{index}"), "rad", ""),
        velocity: quantity(&format!("q_{index}_dot"), "rad/s", ""),
        ..system.coordinates[0].clone()
    };
    system.coordinates = (0..2).map(coordinate).collect();
    system.first_order.clear();
    let mut model = bare(system, "coupled", rate);
    model.mass_matrix = MatrixTape {
        solve: None,
        pattern: pattern(2, 2, &[(0, 0), (0, 1), (1, 0), (1, 1)]),
        tape: tape(|b| {
            let c = coupling(b);
            vec![b.number(2.0), c, c, b.number(1.0)]
        }),
    };
    model.forcing = tape(|b| coupled_forcing(b).to_vec());
    model
}

/// Returns a model without outputs, discontinuities and derivatives, for tests of its rate.
fn bare(mut system: LagrangianSystem, name: &str, rate: Tape) -> Model {
    let states = rate.results.len();
    name.clone_into(&mut system.name);
    system.outputs.clear();
    system.discontinuities.clear();
    let zeros = || tape(|b| vec![b.number(0.0); states]);
    let empty = |columns| MatrixTape {
        solve: None,
        pattern: pattern(states, columns, &[]),
        ..Default::default()
    };
    Model {
        requirements: Vec::new(),
        required: Tape::default(),
        initial_state: zeros(),
        time_derivative: zeros(),
        discontinuities: Tape::default(),
        outputs: Tape::default(),
        rate_jacobian: empty(states),
        parameter_jacobian: empty(6),
        rate,
        ..pendulum_of(&system)
    }
}

/// Returns every function of a number below one in absolute value, and of its negative.
fn functions(b: &mut Builder, x: NodeId, v: NodeId) -> Vec<NodeId> {
    let two = b.number(2.0);
    let more = b.push(Op::Add(two, x));
    let mut results = [Function::Sqrt, Function::Ln].map(|f| b.push(Op::Call(f, more))).to_vec();
    let difference = b.push(Op::Sub(x, v));
    let opposite = b.push(Op::Sub(v, x));
    for function in [
        Function::Abs,
        Function::Exp,
        Function::Sin,
        Function::Cos,
        Function::Tan,
        Function::Asin,
        Function::Acos,
        Function::Atan,
        Function::Sinh,
        Function::Cosh,
        Function::Tanh,
    ] {
        results.extend([difference, opposite].map(|x| b.push(Op::Call(function, x))));
    }
    for order in 0..4 {
        results.push(b.push(Op::Table { table: TableId(0), order, argument: more }));
    }
    results
}

fn arithmetic(b: &mut Builder, x: NodeId, v: NodeId) -> Vec<NodeId> {
    let (two, k) = (b.number(2.0), b.parameter(LENGTH));
    let more = b.push(Op::Add(x, two));
    let mut results = vec![
        b.push(Op::Mul(x, v)),
        b.push(Op::Mul(k, v)),
        b.push(Op::Div(x, k)),
        b.push(Op::Div(x, two)),
        b.push(Op::Div(v, more)),
        b.push(Op::Div(k, more)),
        b.push(Op::Sub(k, x)),
        b.push(Op::Mul(k, two)),
    ];
    for exponent in [-3, -1, 0, 1, 2, 3, 7] {
        results.push(b.push(Op::Powi(more, exponent)));
    }
    let steep = b.number(-2.5);
    for exponent in [k, steep, v] {
        results.push(b.push(Op::Powf(more, exponent)));
    }
    results.push(b.push(Op::SelectLess { lhs: x, rhs: v, then: x, otherwise: more }));
    results.push(b.push(Op::SelectLess { lhs: v, rhs: x, then: k, otherwise: more }));
    results
}

/// Returns expressions linear in time, functions of them, and products with them.
fn of_time(b: &mut Builder, x: NodeId) -> Vec<NodeId> {
    let (time, k, lag) = (b.push(Op::Time), b.parameter(LENGTH), b.parameter(LAG));
    let scaled = b.push(Op::Mul(k, time));
    let shifted = b.push(Op::Sub(scaled, lag));
    let minus = b.push(Op::Neg(shifted));
    let mut results = vec![
        shifted,
        b.push(Op::Mul(time, x)),
        b.push(Op::Mul(shifted, minus)),
        b.push(Op::Add(shifted, x)),
        b.push(Op::Table { table: TableId(0), order: 0, argument: shifted }),
    ];
    for function in [Function::Sin, Function::Cos, Function::Exp, Function::Sinh, Function::Tanh] {
        results.extend([shifted, minus].map(|x| b.push(Op::Call(function, x))));
    }
    results
}

fn coupling(b: &mut Builder) -> NodeId {
    let (first, second) = (b.state(0), b.state(1));
    let angle = b.push(Op::Sub(first, second));
    b.push(Op::Call(Function::Cos, angle))
}

fn coupled_forcing(b: &mut Builder) -> [NodeId; 2] {
    let g = b.parameter(GRAVITY);
    let force = |b: &mut Builder, own: u32, weight: f64| {
        let (own_angle, other_angle) = (b.state(own), b.state(1 - own));
        let other_speed = b.state(3 - own);
        let angle = b.push(Op::Sub(other_angle, own_angle));
        let sine = b.push(Op::Call(Function::Sin, angle));
        let square = b.push(Op::Powi(other_speed, 2));
        let swing = b.push(Op::Mul(sine, square));
        let weight = b.number(weight);
        let weight = b.push(Op::Mul(weight, g));
        let own_sine = b.push(Op::Call(Function::Sin, own_angle));
        let fall = b.push(Op::Mul(weight, own_sine));
        b.push(Op::Sub(swing, fall))
    };
    [force(b, 0, 2.0), force(b, 1, 1.0)]
}

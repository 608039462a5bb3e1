//! The tape: straight-line arithmetic in single-assignment form, as plain data.
//!
//! Excluded: symbols to look up, exact numbers, n-ary sums, duplicate expressions. A node refers
//! only to nodes before it.

use serde::{Deserialize, Serialize};

/// Index of a node on its tape.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
pub struct NodeId(pub u32);

/// Index of an interpolation table of a model.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
pub struct TableId(pub u32);

/// Functions of one argument, by their usual names.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
pub enum Function {
    /// Square root.
    Sqrt,
    /// Absolute value.
    Abs,
    /// The largest integer not above the argument.
    Floor,
    /// Exponential function.
    Exp,
    /// Natural logarithm.
    Ln,
    /// Sine.
    Sin,
    /// Cosine.
    Cos,
    /// Tangent.
    Tan,
    /// Inverse sine.
    Asin,
    /// Inverse cosine.
    Acos,
    /// Inverse tangent.
    Atan,
    /// Hyperbolic sine.
    Sinh,
    /// Hyperbolic cosine.
    Cosh,
    /// Hyperbolic tangent.
    Tanh,
}

impl Function {
    /// All functions with their names, which are those of the methods of
    /// `machinist_contract::Real`.
    pub const ALL: [(Function, &'static str); 14] = [
        (Function::Sqrt, "sqrt"),
        (Function::Abs, "abs"),
        (Function::Floor, "floor"),
        (Function::Exp, "exp"),
        (Function::Ln, "ln"),
        (Function::Sin, "sin"),
        (Function::Cos, "cos"),
        (Function::Tan, "tan"),
        (Function::Asin, "asin"),
        (Function::Acos, "acos"),
        (Function::Atan, "atan"),
        (Function::Sinh, "sinh"),
        (Function::Cosh, "cosh"),
        (Function::Tanh, "tanh"),
    ];

    /// Returns its name.
    #[must_use]
    pub fn name(self) -> &'static str {
        Self::ALL[self as usize].1
    }

    /// Returns true if f(-x) is -f(x), false if it is f(x), to the last bit; `None` if neither.
    #[must_use]
    pub fn is_odd(self) -> Option<bool> {
        match self {
            Self::Sin | Self::Tan | Self::Asin | Self::Atan | Self::Sinh | Self::Tanh => Some(true),
            Self::Cos | Self::Cosh | Self::Abs => Some(false),
            Self::Sqrt | Self::Exp | Self::Ln | Self::Acos | Self::Floor => None,
        }
    }
}

/// One operation.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub enum Op {
    /// A finite literal.
    Literal(f64),
    /// Time t.
    Time,
    /// Entry of the state.
    State(u32),
    /// Entry of the parameters.
    Parameter(u32),
    /// The k-th value that fields hand to the machine at their ports, of which each port has
    /// [`HANDED`](machinist_contract::field::HANDED).
    Handed(u32),
    /// The slot of a relation that steps hold, by its index among the parameters: after the
    /// machine's and those that fields hand over. See [`Relation`](crate::Relation).
    Held(u32),
    /// The k-th result of the tape of constants, which runs before this one: see
    /// [`hoist`](crate::hoist).
    Constant(u32),
    /// The k-th result of the motion's tape: see [`Motion`](crate::Motion).
    Motion(u32),
    /// -a.
    Neg(NodeId),
    /// a + b.
    Add(NodeId, NodeId),
    /// a - b.
    Sub(NodeId, NodeId),
    /// a b.
    Mul(NodeId, NodeId),
    /// a / b.
    Div(NodeId, NodeId),
    /// Integer power.
    Powi(NodeId, i32),
    /// Real power of a positive base.
    Powf(NodeId, NodeId),
    /// A function of one argument.
    Call(Function, NodeId),
    /// `then` where `lhs < rhs`, else `otherwise`.
    SelectLess {
        /// Left side of the comparison.
        lhs: NodeId,
        /// Right side of the comparison.
        rhs: NodeId,
        /// Result if the comparison is true.
        then: NodeId,
        /// Result if it is false.
        otherwise: NodeId,
    },
    /// Cubic table or its derivative.
    Table {
        /// The table.
        table: TableId,
        /// Order of the derivative.
        order: u32,
        /// Argument of the table.
        argument: NodeId,
    },
}

/// A node, with its name in emitted code if the spec gives it one.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Node {
    /// The operation.
    pub op: Op,
    /// A valid Rust identifier, unique on the tape, or `None`.
    pub name: Option<String>,
}

/// Nodes in order of evaluation, and the results among them.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct Tape {
    /// Nodes in order of evaluation.
    pub nodes: Vec<Node>,
    /// Results, in order.
    pub results: Vec<NodeId>,
}

impl std::ops::Index<NodeId> for Tape {
    type Output = Node;
    fn index(&self, id: NodeId) -> &Node {
        &self.nodes[id.0 as usize]
    }
}

impl Op {
    /// Returns the nodes that the operation reads.
    #[must_use]
    pub fn operands(&self) -> Vec<NodeId> {
        match *self {
            Op::Literal(_)
            | Op::Time
            | Op::State(_)
            | Op::Parameter(_)
            | Op::Handed(_)
            | Op::Held(_)
            | Op::Constant(_)
            | Op::Motion(_) => vec![],
            Op::Neg(a) | Op::Powi(a, _) | Op::Call(_, a) | Op::Table { argument: a, .. } => vec![a],
            Op::Add(a, b) | Op::Sub(a, b) | Op::Mul(a, b) | Op::Div(a, b) | Op::Powf(a, b) => {
                vec![a, b]
            }
            Op::SelectLess { lhs, rhs, then, otherwise } => vec![lhs, rhs, then, otherwise],
        }
    }

    /// Returns the same operation on other nodes.
    #[must_use]
    pub fn with_operands(self, mut to: impl FnMut(NodeId) -> NodeId) -> Self {
        match self {
            Op::Literal(_)
            | Op::Time
            | Op::State(_)
            | Op::Parameter(_)
            | Op::Handed(_)
            | Op::Held(_)
            | Op::Constant(_)
            | Op::Motion(_) => self,
            Op::Neg(a) => Op::Neg(to(a)),
            Op::Add(a, b) => Op::Add(to(a), to(b)),
            Op::Sub(a, b) => Op::Sub(to(a), to(b)),
            Op::Mul(a, b) => Op::Mul(to(a), to(b)),
            Op::Div(a, b) => Op::Div(to(a), to(b)),
            Op::Powi(a, exponent) => Op::Powi(to(a), exponent),
            Op::Powf(a, b) => Op::Powf(to(a), to(b)),
            Op::Call(function, a) => Op::Call(function, to(a)),
            Op::SelectLess { lhs, rhs, then, otherwise } => {
                let [lhs, rhs, then, otherwise] = [lhs, rhs, then, otherwise].map(to);
                Op::SelectLess { lhs, rhs, then, otherwise }
            }
            Op::Table { table, order, argument } => {
                Op::Table { table, order, argument: to(argument) }
            }
        }
    }

    /// Returns the approximate cost of the operation, relative to an addition.
    #[must_use]
    pub fn cost(&self) -> u32 {
        match self {
            Op::Div(..) | Op::Call(Function::Sqrt, _) => 4,
            Op::Call(Function::Abs, _) => 1,
            Op::Powf(..) | Op::Call(..) | Op::Table { .. } => 10,
            _ => u32::from(self.is_arithmetic()),
        }
    }

    /// Returns whether the operation costs anything at run time.
    #[must_use]
    pub fn is_arithmetic(&self) -> bool {
        !matches!(
            self,
            Op::Literal(_)
                | Op::Time
                | Op::State(_)
                | Op::Parameter(_)
                | Op::Handed(_)
                | Op::Held(_)
                | Op::Constant(_)
                | Op::Motion(_)
        )
    }

    /// Returns the operation with its operands as a key, in which sums and products commute.
    #[must_use]
    pub fn key(&self) -> OpKey {
        let n = |id: NodeId| u64::from(id.0);
        let both = |a: NodeId, b: NodeId| [n(a.min(b)), n(a.max(b)), 0, 0];
        let (kind, reads) = match *self {
            Op::Literal(value) => (0, [value.to_bits(), 0, 0, 0]),
            Op::Time => (1, [0; 4]),
            Op::State(index) => (2, [u64::from(index), 0, 0, 0]),
            Op::Parameter(index) => (3, [u64::from(index), 0, 0, 0]),
            Op::Handed(index) => (4, [u64::from(index), 0, 0, 0]),
            Op::Constant(index) => (5, [u64::from(index), 0, 0, 0]),
            Op::Neg(a) => (6, [n(a), 0, 0, 0]),
            Op::Add(a, b) => (7, both(a, b)),
            Op::Sub(a, b) => (8, [n(a), n(b), 0, 0]),
            Op::Mul(a, b) => (9, both(a, b)),
            Op::Div(a, b) => (10, [n(a), n(b), 0, 0]),
            Op::Powi(a, exponent) => (11, [n(a), i64::from(exponent) as u64, 0, 0]),
            Op::Powf(a, b) => (12, [n(a), n(b), 0, 0]),
            Op::Call(function, a) => (13, [function as u64, n(a), 0, 0]),
            Op::SelectLess { lhs, rhs, then, otherwise } => {
                (14, [n(lhs), n(rhs), n(then), n(otherwise)])
            }
            Op::Table { table, order, argument } => {
                (15, [u64::from(table.0), u64::from(order), n(argument), 0])
            }
            Op::Motion(index) => (16, [u64::from(index), 0, 0, 0]),
            Op::Held(place) => (17, [u64::from(place), 0, 0, 0]),
        };
        OpKey(kind, reads)
    }
}

/// Two operations with equal keys compute the same value.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct OpKey(u8, [u64; 4]);

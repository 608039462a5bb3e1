//! The tape: straight-line arithmetic in single-assignment form, plain data.
//!
//! Excluded: symbols to look up, exact numbers, n-ary sums, expressions written
//! twice. A node refers only to nodes before it.

use crate::expr::{Function, TableId};

/// Index of a node on its tape.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct NodeId(pub u32);

/// A function of one argument.
pub type Unary = Function;

/// One operation.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Op {
    /// A finite literal.
    Literal(f64),
    /// Time t.
    Time,
    /// Entry of the state \[q, q', z\].
    State(u32),
    /// Entry of the parameters.
    Parameter(u32),
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
    /// A function of one argument; never `SelectLess` nor `Table`.
    Call(Unary, NodeId),
    /// `then` where `lhs < rhs`, else `otherwise`.
    SelectLess {
        /// Left of the comparison.
        lhs: NodeId,
        /// Right of it.
        rhs: NodeId,
        /// Where it holds.
        then: NodeId,
        /// Where it does not.
        otherwise: NodeId,
    },
    /// Cubic table or its derivative.
    Table {
        /// Which table.
        table: TableId,
        /// Order of the derivative.
        order: u32,
        /// Where it is read.
        argument: NodeId,
    },
}

/// A node with the name it bears in emitted code, if the spec gives it one.
#[derive(Debug, Clone, PartialEq)]
pub struct Node {
    /// What it computes.
    pub op: Op,
    /// A valid Rust identifier, unique on the tape, or `None`.
    pub name: Option<String>,
}

/// Nodes in order of evaluation, and which of them are the results.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Tape {
    /// In order of evaluation.
    pub nodes: Vec<Node>,
    /// Which of them are the results.
    pub results: Vec<NodeId>,
}

impl std::ops::Index<NodeId> for Tape {
    type Output = Node;
    fn index(&self, id: NodeId) -> &Node {
        &self.nodes[id.0 as usize]
    }
}

impl Op {
    /// The nodes this operation reads.
    #[must_use]
    pub fn operands(&self) -> Vec<NodeId> {
        match *self {
            Op::Literal(_) | Op::Time | Op::State(_) | Op::Parameter(_) => vec![],
            Op::Neg(a) | Op::Powi(a, _) | Op::Call(_, a) | Op::Table { argument: a, .. } => vec![a],
            Op::Add(a, b) | Op::Sub(a, b) | Op::Mul(a, b) | Op::Div(a, b) | Op::Powf(a, b) => {
                vec![a, b]
            }
            Op::SelectLess { lhs, rhs, then, otherwise } => vec![lhs, rhs, then, otherwise],
        }
    }

    /// The same operation on other nodes.
    #[must_use]
    pub fn with_operands(self, mut to: impl FnMut(NodeId) -> NodeId) -> Self {
        match self {
            Op::Literal(_) | Op::Time | Op::State(_) | Op::Parameter(_) => self,
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

    /// Time that the operation takes, in that of a sum, roughly.
    #[must_use]
    pub fn cost(&self) -> u32 {
        match self {
            Op::Div(..) | Op::Call(Function::Sqrt, _) => 4,
            Op::Call(Function::Abs, _) => 1,
            Op::Powf(..) | Op::Call(..) | Op::Table { .. } => 10,
            _ => u32::from(self.is_arithmetic()),
        }
    }

    /// Whether the operation costs anything at run time.
    #[must_use]
    pub fn is_arithmetic(&self) -> bool {
        !matches!(self, Op::Literal(_) | Op::Time | Op::State(_) | Op::Parameter(_))
    }
}

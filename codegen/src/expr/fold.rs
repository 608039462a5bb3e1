//! What an operation becomes when its operands are known: constants computed,
//! neutral elements dropped, signs moved outward.
//!
//! 0 x is 0 also where x would be infinite: a term with a structural zero is not
//! there.

use machinist_model::{Function, NodeId, Op, evaluate};

use super::Graph;

/// The result of folding.
pub enum Folded {
    /// A node that is there already.
    Node(NodeId),
    /// An operation to be written.
    Op(Op),
}

/// Folds one operation whose operands are on the graph.
pub fn fold(graph: &mut Graph, op: Op) -> Folded {
    if let Some(value) = computed(graph, &op) {
        return Folded::Op(Op::Literal(value));
    }
    match op {
        Op::Neg(a) => match graph.op(a) {
            Op::Neg(b) => Folded::Node(b),
            Op::Sub(x, y) => Folded::Node(graph.sub(y, x)),
            _ => Folded::Op(op),
        },
        Op::Add(a, b) => add(graph, a, b),
        Op::Sub(a, b) => sub(graph, a, b),
        Op::Mul(a, b) => mul(graph, a, b),
        Op::Div(a, b) => div(graph, a, b),
        Op::Call(function, a) => call(graph, function, a),
        Op::SelectLess { then, otherwise, .. } if then == otherwise => Folded::Node(then),
        Op::SelectLess { lhs, rhs, then, otherwise } => {
            match (graph.literal_value(lhs), graph.literal_value(rhs)) {
                (Some(l), Some(r)) => Folded::Node(if l < r { then } else { otherwise }),
                _ => Folded::Op(op),
            }
        }
        _ => Folded::Op(op),
    }
}

fn add(graph: &mut Graph, a: NodeId, b: NodeId) -> Folded {
    match (graph.op(a), graph.op(b)) {
        _ if graph.is_zero(a) => Folded::Node(b),
        _ if graph.is_zero(b) => Folded::Node(a),
        (Op::Neg(x), Op::Neg(y)) => {
            let sum = graph.add(x, y);
            Folded::Node(graph.neg(sum))
        }
        (_, Op::Neg(y)) => Folded::Node(graph.sub(a, y)),
        (Op::Neg(x), _) => Folded::Node(graph.sub(b, x)),
        (_, Op::Literal(value)) if value < 0.0 => {
            let positive = graph.literal(-value);
            Folded::Node(graph.sub(a, positive))
        }
        (Op::Literal(value), _) if value < 0.0 => {
            let positive = graph.literal(-value);
            Folded::Node(graph.sub(b, positive))
        }
        _ => Folded::Op(Op::Add(a, b)),
    }
}

fn sub(graph: &mut Graph, a: NodeId, b: NodeId) -> Folded {
    match (graph.op(a), graph.op(b)) {
        _ if a == b => Folded::Op(Op::Literal(0.0)),
        _ if graph.is_zero(b) => Folded::Node(a),
        _ if graph.is_zero(a) => Folded::Node(graph.neg(b)),
        (_, Op::Neg(y)) => Folded::Node(unless_faulty!(FoldSub, graph.add(a, y), graph.sub(a, y))),
        (_, Op::Literal(value)) if value < 0.0 => {
            let positive = graph.literal(-value);
            Folded::Node(graph.add(a, positive))
        }
        (Op::Neg(x), _) => {
            let sum = graph.add(x, b);
            Folded::Node(graph.neg(sum))
        }
        (Op::Literal(value), _) if value < 0.0 => {
            let positive = graph.literal(-value);
            let sum = graph.add(positive, b);
            Folded::Node(graph.neg(sum))
        }
        _ => Folded::Op(Op::Sub(a, b)),
    }
}

fn mul(graph: &mut Graph, a: NodeId, b: NodeId) -> Folded {
    match (graph.op(a), graph.op(b)) {
        (Op::Literal(0.0), _) | (_, Op::Literal(0.0)) => Folded::Op(Op::Literal(0.0)),
        (Op::Literal(1.0), _) => Folded::Node(b),
        (_, Op::Literal(1.0)) => Folded::Node(a),
        (Op::Literal(-1.0), _) => Folded::Node(graph.neg(b)),
        (_, Op::Literal(-1.0)) => Folded::Node(graph.neg(a)),
        (Op::Neg(x), Op::Neg(y)) => Folded::Node(graph.mul(x, y)),
        (Op::Neg(x), _) => {
            let product = graph.mul(x, b);
            Folded::Node(unless_faulty!(FoldMul, graph.neg(product), product))
        }
        (_, Op::Neg(y)) => {
            let product = graph.mul(a, y);
            Folded::Node(graph.neg(product))
        }
        (Op::Literal(factor), _) => scaled(graph, b, factor).unwrap_or(Folded::Op(Op::Mul(a, b))),
        (_, Op::Literal(factor)) => scaled(graph, a, factor).unwrap_or(Folded::Op(Op::Mul(a, b))),
        _ => Folded::Op(Op::Mul(a, b)),
    }
}

/// A product with a literal times another literal: one product, unless the first has a
/// name, under which it is to be found.
fn scaled(graph: &mut Graph, product: NodeId, factor: f64) -> Option<Folded> {
    let Op::Mul(x, y) = graph.op(product) else { return None };
    let (literal, rest) = match (graph.literal_value(x), graph.literal_value(y)) {
        (Some(literal), _) => (literal, y),
        (_, Some(literal)) => (literal, x),
        _ => return None,
    };
    let both = factor * literal;
    if graph.is_named(product) || !both.is_normal() {
        return None;
    }
    let both = graph.literal(both);
    Some(Folded::Node(graph.mul(both, rest)))
}

fn div(graph: &mut Graph, a: NodeId, b: NodeId) -> Folded {
    match (graph.op(a), graph.op(b)) {
        (Op::Literal(0.0), _) => Folded::Op(Op::Literal(0.0)),
        (_, Op::Literal(1.0)) => Folded::Node(a),
        (Op::Neg(x), Op::Neg(y)) => Folded::Node(graph.div(x, y)),
        (Op::Neg(x), _) => {
            let quotient = graph.div(x, b);
            Folded::Node(graph.neg(quotient))
        }
        (_, Op::Neg(y)) => {
            let quotient = graph.div(a, y);
            Folded::Node(unless_faulty!(FoldDiv, graph.neg(quotient), quotient))
        }
        (Op::Literal(value), _) if value < 0.0 => {
            let positive = graph.literal(-value);
            let quotient = graph.div(positive, b);
            Folded::Node(graph.neg(quotient))
        }
        (_, Op::Literal(value)) if value < 0.0 => {
            let positive = graph.literal(-value);
            let quotient = graph.div(a, positive);
            Folded::Node(graph.neg(quotient))
        }
        _ => Folded::Op(Op::Div(a, b)),
    }
}

/// Odd and even functions of a difference, so that both ways round are one call.
fn call(graph: &mut Graph, function: Function, a: NodeId) -> Folded {
    let Some(is_odd) = function.is_odd() else { return Folded::Op(Op::Call(function, a)) };
    let positive = match graph.op(a) {
        Op::Neg(x) => x,
        Op::Sub(x, y) if y < x => graph.sub(y, x),
        _ => return Folded::Op(Op::Call(function, a)),
    };
    let value = graph.call(function, positive);
    let is_negative = unless_faulty!(FoldOdd, is_odd, !is_odd);
    Folded::Node(if is_negative { graph.neg(value) } else { value })
}

/// The value of an operation on literals, if it is finite.
fn computed(graph: &Graph, op: &Op) -> Option<f64> {
    let value = |id: NodeId| graph.literal_value(id);
    let result = match *op {
        Op::Neg(a) => -value(a)?,
        Op::Add(a, b) => value(a)? + value(b)?,
        Op::Sub(a, b) => value(a)? - value(b)?,
        Op::Mul(a, b) => value(a)? * value(b)?,
        Op::Div(a, b) => value(a)? / value(b)?,
        Op::Powi(a, exponent) => value(a)?.powi(exponent),
        Op::Powf(a, b) => value(a)?.powf(value(b)?),
        Op::Call(function, a) => evaluate::call(function, value(a)?),
        _ => return None,
    };
    // Whatever is not finite stays an operation: it may be in a branch that is
    // never selected.
    result.is_finite().then_some(if result == 0.0 { 0.0 } else { result })
}

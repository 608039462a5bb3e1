//! Simplification of an operation with known operands: constants are computed, neutral elements
//! dropped, signs moved outward.
//!
//! 0 x is 0 even if x would be infinite: a term with a structural zero does not exist.

use machinist_model::{Function, NodeId, Op, evaluate};

use super::Graph;
use crate::unless_faulty;

/// The result of folding.
pub enum Folded {
    /// An existing node.
    Node(NodeId),
    /// An operation to add.
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
        (_, Op::Neg(y)) => {
            Folded::Node(unless_faulty!("fold a - (-b)", graph.add(a, y), graph.sub(a, y)))
        }
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
            Folded::Node(unless_faulty!("fold (-a) b", graph.neg(product), product))
        }
        (_, Op::Neg(y)) => {
            let product = graph.mul(a, y);
            Folded::Node(graph.neg(product))
        }
        (Op::Literal(factor), _) => scaled(graph, b, factor).unwrap_or(Folded::Op(Op::Mul(a, b))),
        (_, Op::Literal(factor)) => scaled(graph, a, factor).unwrap_or(Folded::Op(Op::Mul(a, b))),
        (Op::SelectLess { .. }, Op::Div(..)) => {
            on_branch(graph, a, |graph, branch| graph.mul(branch, b))
                .unwrap_or(Folded::Op(Op::Mul(a, b)))
        }
        (Op::Div(..), Op::SelectLess { .. }) => {
            on_branch(graph, b, |graph, branch| graph.mul(a, branch))
                .unwrap_or(Folded::Op(Op::Mul(a, b)))
        }
        _ => Folded::Op(Op::Mul(a, b)),
    }
}

/// Applies an operation to the branch of a choice that is not zero. The other branch stays zero,
/// even where the result would be infinite, such as the slope of sqrt(max(h, 0)).
fn on_branch(
    graph: &mut Graph,
    choice: NodeId,
    of: impl FnOnce(&mut Graph, NodeId) -> NodeId,
) -> Option<Folded> {
    let Op::SelectLess { lhs, rhs, then, otherwise } = graph.op(choice) else { return None };
    let (is_then, is_otherwise) = (graph.is_zero(then), graph.is_zero(otherwise));
    if is_then == is_otherwise {
        return None;
    }
    let (then, otherwise) =
        if is_then { (then, of(graph, otherwise)) } else { (of(graph, then), otherwise) };
    Some(Folded::Node(graph.select_less(lhs, rhs, then, otherwise)))
}

/// Merges the literal factor of a product with another literal, unless the product has a name,
/// under which it must remain available.
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
        (Op::SelectLess { .. }, _) if !graph.is_constant(b) => {
            on_branch(graph, a, |graph, branch| graph.div(branch, b))
                .unwrap_or(Folded::Op(Op::Div(a, b)))
        }
        (Op::Neg(x), Op::Neg(y)) => Folded::Node(graph.div(x, y)),
        (Op::Neg(x), _) => {
            let quotient = graph.div(x, b);
            Folded::Node(graph.neg(quotient))
        }
        (_, Op::Neg(y)) => {
            let quotient = graph.div(a, y);
            Folded::Node(unless_faulty!("fold a/(-b)", graph.neg(quotient), quotient))
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

/// Folds odd and even functions of a difference, so that both signs share one call.
fn call(graph: &mut Graph, function: Function, a: NodeId) -> Folded {
    let Some(is_odd) = function.is_odd() else { return Folded::Op(Op::Call(function, a)) };
    let positive = match graph.op(a) {
        Op::Neg(x) => x,
        Op::Sub(x, y) if y < x => graph.sub(y, x),
        _ => return Folded::Op(Op::Call(function, a)),
    };
    let value = graph.call(function, positive);
    let is_negative = unless_faulty!("fold f(b - a)", is_odd, !is_odd);
    Folded::Node(if is_negative { graph.neg(value) } else { value })
}

/// Returns the value of an operation on literals, if it is finite.
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
    // A result that is not finite stays an operation: it may be in a branch that is never selected.
    result.is_finite().then_some(if result == 0.0 { 0.0 } else { result })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Returns a graph with two entries of the state.
    fn graph() -> (Graph, NodeId, NodeId) {
        let mut graph = Graph::new();
        let [x, y] = [0, 1].map(|entry| graph.insert(Op::State(entry)));
        (graph, x, y)
    }

    #[test]
    fn signs_move_outward_and_operands_that_change_nothing_go() {
        let (mut g, x, y) = graph();
        let [zero, one, minus, two, less] = [0.0, 1.0, -1.0, 2.0, -2.0].map(|v| g.literal(v));
        let [not_x, not_y] = [x, y].map(|node| g.neg(node));
        let (sum, product, quotient) = (g.add(x, y), g.mul(x, y), g.div(x, y));
        let (difference, opposite) = (g.sub(x, y), g.sub(y, x));
        let [not_sum, not_product, not_quotient] = [sum, product, quotient].map(|id| g.neg(id));
        let (more, fewer, halved, over) =
            (g.add(x, two), g.sub(x, two), g.div(x, two), g.div(two, x));
        let [not_more, not_halved, not_over] = [more, halved, over].map(|id| g.neg(id));
        for (op, expected) in [
            (Op::Neg(not_x), x),
            (Op::Neg(difference), opposite),
            (Op::Add(zero, x), x),
            (Op::Add(x, zero), x),
            (Op::Add(not_x, not_y), not_sum),
            (Op::Add(x, not_y), difference),
            (Op::Add(not_x, y), opposite),
            (Op::Add(x, less), fewer),
            (Op::Add(less, x), fewer),
            (Op::Sub(x, x), zero),
            (Op::Sub(x, zero), x),
            (Op::Sub(zero, x), not_x),
            (Op::Sub(x, not_y), sum),
            (Op::Sub(x, less), more),
            (Op::Sub(not_x, y), not_sum),
            (Op::Sub(less, x), not_more),
            (Op::Mul(zero, x), zero),
            (Op::Mul(x, zero), zero),
            (Op::Mul(one, x), x),
            (Op::Mul(x, one), x),
            (Op::Mul(minus, x), not_x),
            (Op::Mul(x, minus), not_x),
            (Op::Mul(not_x, not_y), product),
            (Op::Mul(not_x, y), not_product),
            (Op::Mul(x, not_y), not_product),
            (Op::Div(zero, x), zero),
            (Op::Div(x, one), x),
            (Op::Div(not_x, not_y), quotient),
            (Op::Div(not_x, y), not_quotient),
            (Op::Div(x, not_y), not_quotient),
            (Op::Div(less, x), not_over),
            (Op::Div(x, less), not_halved),
            (Op::SelectLess { lhs: x, rhs: y, then: sum, otherwise: sum }, sum),
            (Op::SelectLess { lhs: one, rhs: two, then: x, otherwise: y }, x),
            (Op::SelectLess { lhs: two, rhs: one, then: x, otherwise: y }, y),
            (Op::SelectLess { lhs: one, rhs: one, then: x, otherwise: y }, y),
        ] {
            assert_eq!(g.insert(op), expected, "{op:?}");
        }
    }

    #[test]
    fn operations_that_say_something_stay() {
        let (mut g, x, y) = graph();
        let [zero, two] = [0.0, 2.0].map(|v| g.literal(v));
        for op in [
            Op::Neg(x),
            Op::Add(x, y),
            Op::Add(x, two),
            Op::Sub(x, two),
            Op::Sub(two, x),
            Op::Mul(x, x),
            Op::Mul(two, x),
            Op::Div(x, two),
            Op::Div(two, x),
            Op::Div(x, zero),
            Op::Call(Function::Sqrt, x),
            Op::SelectLess { lhs: x, rhs: two, then: x, otherwise: y },
        ] {
            let node = g.insert(op);
            assert_eq!(g.op(node), op);
        }
        // A result that is not finite may be in a branch that is never selected.
        let infinite = g.div(two, zero);
        assert_eq!(g.op(infinite), Op::Div(two, zero));
    }

    #[test]
    fn operations_on_literals_are_computed() {
        let (mut g, ..) = graph();
        let [zero, two, three] = [0.0, 2.0, 3.0].map(|v| g.literal(v));
        for (op, expected) in [
            (Op::Neg(two), -2.0),
            (Op::Neg(zero), 0.0),
            (Op::Add(two, three), 5.0),
            (Op::Sub(two, three), -1.0),
            (Op::Mul(two, three), 6.0),
            (Op::Div(three, two), 1.5),
            (Op::Powi(three, 5), 243.0),
            (Op::Powf(two, three), 8.0),
            (Op::Call(Function::Exp, zero), 1.0),
        ] {
            let node = g.insert(op);
            let found = g.literal_value(node).expect("a literal");
            assert_eq!(found.to_bits(), f64::to_bits(expected), "{op:?}");
        }
    }

    #[test]
    fn literal_factors_become_one_unless_the_product_has_a_name() {
        let (mut g, x, y) = graph();
        let [two, three, six, tiny] = [2.0, 3.0, 6.0, 1e-200].map(|v| g.literal(v));
        let (twice, six_times) = (g.mul(two, x), g.mul(six, x));
        assert_eq!([g.mul(three, twice), g.mul(twice, three)], [six_times; 2]);
        let other_way = g.mul(y, two);
        let expected = g.mul(six, y);
        assert_eq!(g.mul(three, other_way), expected);
        let product = g.mul(x, y);
        for stays in [product, g.add(x, two)] {
            let node = g.mul(three, stays);
            assert_eq!(g.op(node), Op::Mul(three, stays));
        }
        // Two factors whose product underflows are kept separate.
        let little = g.mul(tiny, x);
        let node = g.mul(tiny, little);
        assert_eq!(g.op(node), Op::Mul(tiny, little));
        g.name(six_times, "lever");
        let node = g.mul(three, six_times);
        assert_eq!(g.op(node), Op::Mul(three, six_times));
    }

    #[test]
    fn odd_and_even_functions_are_of_one_way_round() {
        let (mut g, x, y) = graph();
        let (not_x, difference, opposite) = (g.neg(x), g.sub(x, y), g.sub(y, x));
        for function in [Function::Sin, Function::Cos, Function::Tanh, Function::Abs] {
            let is_odd = function.is_odd().expect("one of both");
            for (turned, straight) in [(not_x, x), (opposite, difference)] {
                let value = g.call(function, straight);
                assert_eq!(g.op(value), Op::Call(function, straight));
                let expected = if is_odd { g.neg(value) } else { value };
                assert_eq!(g.call(function, turned), expected, "{function:?}");
            }
        }
        let root = g.call(Function::Exp, not_x);
        assert_eq!(g.op(root), Op::Call(Function::Exp, not_x));
    }
}

//! Quotients of exponentially growing expressions that cancel: slopes of steep functions far from
//! the steep part are zero, not infinity over infinity.

use machinist_model::{Function, NodeId, Op};

use super::graph::{Graph, PlusExponential};

/// In a quotient of products, replaces sinh(u)/cosh(u) by tanh(u), e^v/(a + b e^v) by
/// 1/(a e^-v + b), and their powers likewise.
pub(super) fn avoid(graph: &mut Graph, above: &mut Vec<NodeId>, below: &mut Vec<NodeId>) {
    let mut index = 0;
    while let Some(&factor) = above.get(index) {
        let (base, power) = graph.as_power(factor);
        match graph.op(base) {
            Op::Call(Function::Sinh, u) => {
                let as_often = |graph: &Graph, id, _| {
                    (graph.op(id) == Op::Call(Function::Cosh, u)).then_some(power)
                };
                if let Some((_, taken)) = take(graph, below, as_often) {
                    let tanh = graph.call(Function::Tanh, u);
                    let (tanh, rest) = (graph.powi(tanh, taken), graph.powi(base, power - taken));
                    above[index] = graph.mul(tanh, rest);
                }
            }
            // One of several equal factors at a time.
            Op::Call(Function::Exp, w) if power >= 1 => {
                let as_often = |graph: &Graph, id, most| {
                    let argument = graph.plus_exponential(id)?.argument;
                    multiple(graph, w, argument).filter(|times| *times <= most)
                };
                let sum = take(graph, below, as_often);
                if let Some((PlusExponential { a, b, argument }, times)) =
                    sum.and_then(|(sum, times)| graph.plus_exponential(sum).zip(Some(times)))
                {
                    let opposite = graph.neg(argument);
                    let decaying = graph.call(Function::Exp, opposite);
                    let decaying = graph.mul(a, decaying);
                    let b = b.unwrap_or_else(|| graph.literal(1.0));
                    let bounded = graph.add(b, decaying);
                    below.push(graph.powi(bounded, times));
                    if power == 1 {
                        above.remove(index);
                    } else {
                        above[index] = graph.powi(base, power - 1);
                    }
                    continue;
                }
            }
            _ => {}
        }
        index += 1;
    }
}

/// Removes powers of a divisor. `wanted` returns how many, from its base and its power. Returns the
/// base and the number removed.
fn take(
    graph: &mut Graph,
    below: &mut Vec<NodeId>,
    wanted: impl Fn(&Graph, NodeId, i32) -> Option<i32>,
) -> Option<(NodeId, i32)> {
    let (found, base, power, taken) = below.iter().enumerate().find_map(|(index, id)| {
        let (base, power) = graph.as_power(*id);
        let taken = wanted(graph, base, power)?.min(power);
        Some((index, base, power, taken))
    })?;
    if power > taken {
        below[found] = graph.powi(base, power - taken);
    } else {
        below.remove(found);
    }
    Some((base, taken))
}

/// Returns the ratio of two nodes, if it is a positive whole number up to 8 determined by literals.
fn multiple(graph: &Graph, of: NodeId, one: NodeId) -> Option<i32> {
    let monomial = |id: NodeId| {
        let mut factors = Vec::new();
        let literal = factor(graph, id, 1, &mut factors);
        factors.sort_unstable();
        (literal, factors)
    };
    let ((times, of), (once, one)) = (monomial(of), monomial(one));
    let ratio = times / once;
    let is_whole = ratio.fract() == 0.0 && (1.0..=8.0).contains(&ratio);
    (of == one && is_whole).then_some(ratio as i32)
}

/// Returns the product of the literals of a node, or of its reciprocal if `power` is -1, and
/// collects the other factors.
fn factor(graph: &Graph, id: NodeId, power: i32, factors: &mut Vec<(NodeId, i32)>) -> f64 {
    match graph.op(id) {
        Op::Literal(value) => value.powi(power),
        Op::Neg(a) => -factor(graph, a, power, factors),
        Op::Mul(a, b) => factor(graph, a, power, factors) * factor(graph, b, power, factors),
        Op::Div(a, b) => factor(graph, a, power, factors) * factor(graph, b, -power, factors),
        _ => {
            factors.push((id, power));
            1.0
        }
    }
}

#[cfg(test)]
mod tests {
    use machinist_model::evaluate::{Evaluator, Inputs};

    use super::*;
    use crate::expr::{Expr, Function, Symbol};

    fn call(function: Function, argument: &Expr) -> Expr {
        Expr::Call(function, vec![argument.clone()])
    }

    fn power(base: Expr, exponent: i64) -> Expr {
        Expr::Power(Box::new(base), Box::new(Expr::integer(exponent)))
    }

    fn value(expr: &Expr, at: f64) -> f64 {
        let mut graph = Graph::new();
        let root = graph.lower(expr);
        let mut value = [0.0];
        let inputs = Inputs { time: at, ..Inputs::default() };
        Evaluator::new(&graph.tape(&[root])).evaluate(&inputs, &mut value);
        value[0]
    }

    #[test]
    fn slopes_of_steep_functions_end_far_away() {
        let t = Expr::Symbol(Symbol::Time);
        let exp = call(Function::Exp, &t);
        let double = Expr::Product(vec![Expr::integer(2), exp.clone()]);
        let sum = |terms: [Expr; 2]| Expr::Sum(terms.to_vec());
        let [one, three] = [1, 3].map(Expr::integer);
        let twice = Expr::Product(vec![Expr::integer(2), t.clone()]);
        // Values at 0.5, and for arguments of -1000 and 1000.
        let (e, [s, c]) = (0.5_f64.exp(), [0.5_f64.sinh(), 0.5_f64.cosh()]);
        let quotients = [
            (
                vec![exp.clone(), power(sum([one.clone(), exp.clone()]), -2)],
                [e / (1.0 + e).powi(2), 0.0, 0.0],
            ),
            (vec![exp.clone(), power(sum([three, double]), -1)], [e / (3.0 + 2.0 * e), 0.0, 0.5]),
            (
                vec![call(Function::Sinh, &t), power(call(Function::Cosh, &t), -3)],
                [s / c.powi(3), 0.0, 0.0],
            ),
            (
                vec![call(Function::Sinh, &t), power(call(Function::Cosh, &t), -1)],
                [s / c, -1.0, 1.0],
            ),
            (
                vec![power(call(Function::Sinh, &t), 2), power(call(Function::Cosh, &t), -3)],
                [s * s / c.powi(3), 0.0, 0.0],
            ),
            (
                vec![power(exp.clone(), 2), power(sum([one.clone(), exp.clone()]), -3)],
                [e * e / (1.0 + e).powi(3), 0.0, 0.0],
            ),
            (
                vec![call(Function::Exp, &twice), power(sum([one, exp]), -3)],
                [e * e / (1.0 + e).powi(3), 0.0, 0.0],
            ),
        ];
        for (factors, expected) in quotients {
            let quotient = Expr::Product(factors);
            for (at, expected) in [0.5, -1000.0, 1000.0].into_iter().zip(expected) {
                let found = value(&quotient, at);
                assert!(
                    (found - expected).abs() <= 1e-15 * expected.abs(),
                    "{quotient:?} at {at}: {found}"
                );
            }
        }
    }
}

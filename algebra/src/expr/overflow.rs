//! Quotients of what grows beyond all numbers, of which nothing is left: slopes of steep functions,
//! far away from where they are steep, are zero and not infinity over infinity.

use machinist_model::{Function, NodeId, Op};

use super::graph::Graph;

/// Takes sinh(u)/cosh(u) of a quotient of products for tanh(u), and e^v/(a + b e^v) for
/// 1/(a e^-v + b).
pub(super) fn avoid(graph: &mut Graph, above: &mut Vec<NodeId>, below: &mut Vec<NodeId>) {
    let mut index = 0;
    while let Some(&factor) = above.get(index) {
        match graph.op(factor) {
            Op::Call(Function::Sinh, u) => {
                let cosh = |graph: &Graph, id| graph.op(id) == Op::Call(Function::Cosh, u);
                if take_one(graph, below, cosh).is_some() {
                    above[index] = graph.call(Function::Tanh, u);
                }
            }
            Op::Call(Function::Exp, v) => {
                let has_exp = |graph: &Graph, id| parts(graph, id, factor).is_some();
                let sum = take_one(graph, below, has_exp);
                if let Some((a, b)) = sum.and_then(|sum| parts(graph, sum, factor)) {
                    let opposite = graph.neg(v);
                    let decaying = graph.call(Function::Exp, opposite);
                    let decaying = graph.mul(a, decaying);
                    let b = b.unwrap_or_else(|| graph.literal(1.0));
                    below.push(graph.add(b, decaying));
                    above.remove(index);
                    continue;
                }
            }
            _ => {}
        }
        index += 1;
    }
}

/// Takes one of the divisors that are powers of what is wanted, once; gives it.
fn take_one(
    graph: &mut Graph,
    below: &mut Vec<NodeId>,
    is_wanted: impl Fn(&Graph, NodeId) -> bool,
) -> Option<NodeId> {
    let found = below.iter().position(|id| is_wanted(graph, graph.as_power(*id).0))?;
    let (base, power) = graph.as_power(below[found]);
    if power > 1 {
        below[found] = graph.powi(base, power - 1);
    } else {
        below.remove(found);
    }
    Some(base)
}

/// Of a + b e^v, with a and b of parameters alone, these; no b is 1.
fn parts(graph: &Graph, sum: NodeId, exp: NodeId) -> Option<(NodeId, Option<NodeId>)> {
    let Op::Add(first, second) = graph.op(sum) else { return None };
    [(first, second), (second, first)].into_iter().find_map(|(a, rest)| {
        let b = match graph.op(rest) {
            _ if rest == exp => None,
            Op::Mul(b, e) | Op::Mul(e, b) if e == exp && graph.is_constant(b) => Some(b),
            _ => return None,
        };
        graph.is_constant(a).then_some((a, b))
    })
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
        // Values at 0.5, and where the argument is -1000 and 1000.
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

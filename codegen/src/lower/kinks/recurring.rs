//! Features that last for a small share of a time that need not be known: a pulse in every turn of
//! a crank, say, by `exp((cos(w*t) - 1)/1e-3)`, or of a rotor, by `exp((cos(phi) - 1)/1e-3)`.
//!
//! Between the points at which its argument turns such a function rises or falls, so steps that end
//! there see it.

use machinist_algebra::expr::Graph;
use machinist_model::{Function, NodeId, Op};

use super::extent::{Extents, States};
use super::{By, Given, Search, reached};

/// Change of an exponent below which it makes no pulse that steps would miss: it takes a tenth of a
/// turn.
const MOVES: f64 = 8.0;
/// Ratio of the largest to the least value of a denominator below which it makes none either.
const RATIO: f64 = 50.0;

/// Returns the arguments of a function that may appear and vanish within a small share of its
/// periods, at the values of parameters in the spec. For a polynomial of time the time is known.
pub(super) fn recurring(
    search: &Search<'_>,
    graph: &Graph,
    id: NodeId,
    given: &Given<'_>,
) -> Vec<NodeId> {
    use Function::{Atan, Cosh, Exp, Sinh, Tanh};
    let op = graph.op(id);
    let arguments = match op {
        Op::Call(Exp | Tanh | Sinh | Cosh | Atan, argument) | Op::Powi(argument, _) => {
            vec![argument]
        }
        Op::Div(_, divisor) => factors(graph, divisor),
        _ => return Vec::new(),
    };
    let is_sharp = |argument: &NodeId| is_sharp(search, graph, (op, *argument), given);
    arguments.into_iter().filter(is_sharp).collect()
}

/// Returns the factors of a product, each once: in `1/(a a b)` it is `a` or `b` that vanishes, in
/// whatever form an algebra writes their product.
fn factors(graph: &Graph, product: NodeId) -> Vec<NodeId> {
    let (mut open, mut found) = (vec![product], Vec::new());
    while let Some(id) = open.pop() {
        match graph.op(id) {
            Op::Mul(a, b) => open.extend([a, b]),
            Op::Neg(a) => open.push(a),
            Op::Powi(a, exponent) if exponent > 0 => open.push(a),
            _ if found.contains(&id) => {}
            _ => found.push(id),
        }
    }
    found
}

/// Reports whether an operation changes within a small share of the periods of its argument.
fn is_sharp(
    search: &Search<'_>,
    graph: &Graph,
    (op, argument): (Op, NodeId),
    given: &Given<'_>,
) -> bool {
    if search.by[&argument] == By::Nothing || search.polynomials[&argument].is_some() {
        return false;
    }
    let inside = reached(graph, &[argument]);
    let has = |functions: &[Function]| {
        let is_one =
            |id: &NodeId| matches!(graph.op(*id), Op::Call(of, _) if functions.contains(&of));
        inside.iter().any(is_one)
    };
    if !has(&[Function::Sin, Function::Cos, Function::Floor]) {
        return false;
    }
    match (op, Extents::new(given, States::Unknown).of(graph, argument)) {
        (Op::Powi(_, exponent), Some(_)) => f64::from(exponent.abs()) > MOVES,
        // A sawtooth of an unbounded argument is bounded, but the bounds are not easy to determine.
        (_, None) => has(&[Function::Floor]),
        (Op::Call(..), Some(within)) => within.end() - within.start() > MOVES,
        (_, Some(within)) => {
            let (low, high) = within.into_inner();
            let [least, most] = [low.abs().min(high.abs()), low.abs().max(high.abs())];
            low * high > 0.0 && most > RATIO * least
        }
    }
}

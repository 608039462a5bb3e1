//! What comes and goes for a small share of a time that need not be known: a pulse in every turn of
//! a crank, say, by `exp((cos(w*t) - 1)/1e-3)`, or of a rotor, by `exp((cos(phi) - 1)/1e-3)`.
//!
//! Between the places at which its argument turns such a function rises or falls, and so is seen by
//! steps that end there.

use machinist_algebra::expr::Graph;
use machinist_model::{Function, NodeId, Op};

use super::extent::{Extents, States};
use super::{By, Given, Search, reached};

/// Exponents that move by less make no pulse that steps would not see: it takes a tenth of a turn.
const MOVES: f64 = 8.0;
/// And so do denominators whose largest value is not so many times the least.
const RATIO: f64 = 50.0;

/// The argument of a function that may come and go within a small share of its turns, with the
/// values that parameters have in the spec; of those of a polynomial of time the time is known.
pub(super) fn recurring(
    search: &Search<'_>,
    graph: &Graph,
    id: NodeId,
    given: &Given<'_>,
) -> Option<NodeId> {
    use Function::{Atan, Cosh, Exp, Sinh, Tanh};
    let op = graph.op(id);
    let argument = match op {
        Op::Call(Exp | Tanh | Sinh | Cosh | Atan, argument) | Op::Powi(argument, _) => argument,
        Op::Div(_, divisor) => divisor,
        _ => return None,
    };
    if search.by[&argument] == By::Nothing || search.polynomials[&argument].is_some() {
        return None;
    }
    let inside = reached(graph, &[argument]);
    let has = |functions: &[Function]| {
        let is_one =
            |id: &NodeId| matches!(graph.op(*id), Op::Call(of, _) if functions.contains(&of));
        inside.iter().any(is_one)
    };
    if !has(&[Function::Sin, Function::Cos, Function::Floor]) {
        return None;
    }
    let is_sharp = match (op, Extents::new(given, States::Unknown).of(graph, argument)) {
        (Op::Powi(_, exponent), Some(_)) => f64::from(exponent.abs()) > MOVES,
        // A sawtooth of what has no bounds has some, which are not easily told.
        (_, None) => has(&[Function::Floor]),
        (Op::Call(..), Some(within)) => within.end() - within.start() > MOVES,
        (_, Some(within)) => {
            let (low, high) = within.into_inner();
            let [least, most] = [low.abs().min(high.abs()), low.abs().max(high.abs())];
            low * high > 0.0 && most > RATIO * least
        }
    };
    is_sharp.then_some(argument)
}

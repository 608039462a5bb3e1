//! What comes and goes for a small share of a time that need not be known: a pulse in every turn of
//! a crank, say, by `exp((cos(w*t) - 1)/1e-3)`, or of a rotor, by `exp((cos(phi) - 1)/1e-3)`.
//!
//! Between the places at which its argument turns such a function rises or falls, and so is seen by
//! steps that end there.

use std::collections::HashMap;
use std::ops::RangeInclusive;

use machinist_algebra::expr::Graph;
use machinist_model::{Function, NodeId, Op};

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
    let is_sharp = match (op, bounds(graph, argument, given, &mut HashMap::new())) {
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

/// Between which values a function is; nothing if that is not easily told.
fn bounds(
    graph: &Graph,
    id: NodeId,
    given: &Given<'_>,
    known: &mut HashMap<NodeId, Option<RangeInclusive<f64>>>,
) -> Option<RangeInclusive<f64>> {
    if let Some(known) = known.get(&id) {
        return known.clone();
    }
    let mut of = |id: NodeId| bounds(graph, id, given, known).map(RangeInclusive::into_inner);
    let found = match graph.op(id) {
        Op::Literal(value) => Some((value, value)),
        Op::Parameter(place) => given.parameters.get(place as usize).map(|value| (*value, *value)),
        Op::Time => Some(given.run),
        Op::Neg(a) => of(a).map(|(low, high)| (-high, -low)),
        Op::Add(a, b) => of(a).zip(of(b)).map(|(a, b)| (a.0 + b.0, a.1 + b.1)),
        Op::Sub(a, b) => of(a).zip(of(b)).map(|(a, b)| (a.0 - b.1, a.1 - b.0)),
        // Of a square, what is below zero.
        Op::Mul(a, b) if a == b => of(a).map(|a| monotone(magnitudes(a), |a| a * a)),
        Op::Mul(a, b) => of(a).zip(of(b)).map(|(a, b)| product(a, b)),
        Op::Div(a, b) => of(a).zip(of(b)).and_then(|(a, (low, high))| {
            (low * high > 0.0).then(|| product(a, (1.0 / high, 1.0 / low)))
        }),
        Op::Powi(a, exponent) if exponent > 0 => of(a).map(|a| {
            let a = if exponent % 2 == 0 { magnitudes(a) } else { a };
            monotone(a, |a| a.powi(exponent))
        }),
        Op::SelectLess { then, otherwise, .. } => {
            of(then).zip(of(otherwise)).map(|(a, b)| (a.0.min(b.0), a.1.max(b.1)))
        }
        Op::Call(Function::Sin | Function::Cos, _) => Some((-1.0, 1.0)),
        Op::Call(Function::Sqrt, a) => of(a).map(|a| monotone(a, |a| a.max(0.0).sqrt())),
        Op::Call(Function::Abs, a) => of(a).map(magnitudes),
        Op::Call(Function::Exp, a) => of(a).map(|a| monotone(a, f64::exp)),
        Op::Call(Function::Cosh, a) => of(a).map(|a| monotone(magnitudes(a), f64::cosh)),
        Op::Call(Function::Sinh, a) => of(a).map(|a| monotone(a, f64::sinh)),
        Op::Call(Function::Tanh, a) => of(a).map(|a| monotone(a, f64::tanh)),
        Op::Call(Function::Floor, a) => of(a).map(|a| monotone(a, f64::floor)),
        _ => None,
    };
    let found = found.filter(|(low, high)| low <= high).map(|(low, high)| low..=high);
    known.insert(id, found.clone());
    found
}

fn monotone((low, high): (f64, f64), of: impl Fn(f64) -> f64) -> (f64, f64) {
    (of(low), of(high))
}

/// Between which values the absolute value is.
fn magnitudes((low, high): (f64, f64)) -> (f64, f64) {
    let least = if low <= 0.0 && high >= 0.0 { 0.0 } else { low.abs().min(high.abs()) };
    (least, low.abs().max(high.abs()))
}

fn product(a: (f64, f64), b: (f64, f64)) -> (f64, f64) {
    let corners = [a.0 * b.0, a.0 * b.1, a.1 * b.0, a.1 * b.1];
    let least = corners.iter().fold(f64::INFINITY, |least: f64, corner| least.min(*corner));
    (least, corners.iter().fold(f64::NEG_INFINITY, |most: f64, corner| most.max(*corner)))
}

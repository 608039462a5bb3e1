//! Ranges of values of functions.

use std::collections::HashMap;
use std::ops::RangeInclusive;

use machinist_algebra::expr::Graph;
use machinist_model::{Function, NodeId, Op};

use super::Given;

/// Assumptions on states.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum States {
    /// Nothing is known.
    Unknown,
    /// They may have any values.
    Anywhere,
    /// They have their values at the start.
    AtStart,
}

/// Ranges of the nodes of a graph, with the values of parameters in the spec.
pub(super) struct Extents<'a> {
    given: &'a Given<'a>,
    states: States,
    known: HashMap<NodeId, Option<RangeInclusive<f64>>>,
}

impl<'a> Extents<'a> {
    pub(super) fn new(given: &'a Given<'a>, states: States) -> Self {
        Self { given, states, known: HashMap::new() }
    }

    /// Returns the range of a node; `None` if it is not easy to determine.
    pub(super) fn of(&mut self, graph: &Graph, id: NodeId) -> Option<RangeInclusive<f64>> {
        if let Some(known) = self.known.get(&id) {
            return known.clone();
        }
        let found = self.by_operands(graph, id).filter(|(low, high)| low <= high);
        let found = found.map(|(low, high)| low..=high);
        self.known.insert(id, found.clone());
        found
    }

    fn by_operands(&mut self, graph: &Graph, id: NodeId) -> Option<(f64, f64)> {
        let (given, states) = (self.given, self.states);
        let mut of = |id: NodeId| self.of(graph, id).map(RangeInclusive::into_inner);
        let one = |value: f64| (value, value);
        match graph.op(id) {
            Op::Literal(value) => Some(one(value)),
            Op::Parameter(place) => given.parameters.get(place as usize).copied().map(one),
            Op::Time if states == States::AtStart => Some(one(given.run.0)),
            Op::Time => Some(given.run),
            Op::State(place) => match states {
                States::Unknown => None,
                States::Anywhere => Some((f64::NEG_INFINITY, f64::INFINITY)),
                States::AtStart => given.start.get(place as usize).copied().map(one),
            },
            Op::Neg(a) => of(a).map(|(low, high)| (-high, -low)),
            Op::Add(a, b) => of(a).zip(of(b)).map(|(a, b)| (a.0 + b.0, a.1 + b.1)),
            Op::Sub(a, b) => of(a).zip(of(b)).map(|(a, b)| (a.0 - b.1, a.1 - b.0)),
            // A square is not negative.
            Op::Mul(a, b) if a == b => of(a).map(|a| monotone(magnitudes(a), |a| a * a)),
            Op::Mul(a, b) => of(a).zip(of(b)).map(|(a, b)| product(a, b)),
            Op::Div(a, b) => of(a).zip(of(b)).and_then(|(a, (low, high))| {
                (low * high > 0.0).then(|| product(a, (1.0 / high, 1.0 / low)))
            }),
            Op::Powi(a, exponent) if exponent > 0 => of(a).map(|a| {
                let a = if exponent % 2 == 0 { magnitudes(a) } else { a };
                monotone(a, |a| a.powi(exponent))
            }),
            Op::Powf(a, b) => of(a).zip(of(b)).and_then(|(a, (exponent, most))| {
                let is_power = exponent >= most && exponent > 0.0 && a.0 >= 0.0;
                is_power.then(|| monotone(a, |a| a.powf(exponent)))
            }),
            Op::SelectLess { then, otherwise, .. } => {
                of(then).zip(of(otherwise)).map(|(a, b)| (a.0.min(b.0), a.1.max(b.1)))
            }
            Op::Call(Function::Sin | Function::Cos, _) => Some((-1.0, 1.0)),
            Op::Call(Function::Sqrt, a) => of(a).map(|a| monotone(a, |a| a.max(0.0).sqrt())),
            Op::Call(Function::Abs, a) => of(a).map(magnitudes),
            Op::Call(Function::Exp, a) => of(a).map(|a| monotone(a, f64::exp)),
            Op::Call(Function::Ln, a) => of(a).map(|a| monotone(a, |a| a.max(0.0).ln())),
            Op::Call(Function::Cosh, a) => of(a).map(|a| monotone(magnitudes(a), f64::cosh)),
            Op::Call(Function::Sinh, a) => of(a).map(|a| monotone(a, f64::sinh)),
            Op::Call(Function::Tanh, a) => of(a).map(|a| monotone(a, f64::tanh)),
            Op::Call(Function::Floor, a) => of(a).map(|a| monotone(a, f64::floor)),
            _ => None,
        }
    }
}

fn monotone((low, high): (f64, f64), of: impl Fn(f64) -> f64) -> (f64, f64) {
    (of(low), of(high))
}

/// Returns the range of the absolute value.
fn magnitudes((low, high): (f64, f64)) -> (f64, f64) {
    let least = if low <= 0.0 && high >= 0.0 { 0.0 } else { low.abs().min(high.abs()) };
    (least, low.abs().max(high.abs()))
}

fn product(a: (f64, f64), b: (f64, f64)) -> (f64, f64) {
    let corners = [a.0 * b.0, a.0 * b.1, a.1 * b.0, a.1 * b.1];
    let least = corners.iter().fold(f64::INFINITY, |least: f64, corner| least.min(*corner));
    (least, corners.iter().fold(f64::NEG_INFINITY, |most: f64, corner| most.max(*corner)))
}

//! Detection of operations that are zero although their structure does not show it.
//!
//! The derivative of a solution may cancel as a whole, such as that of a pendulum's acceleration by
//! its mass. Floating-point numbers show rounding errors instead of zero; at random points of a
//! finite field ([`identity`](super::identity)) the value is exactly zero.

use machinist_model::{Node, NodeId, Op};
use num_bigint::BigInt;
use num_rational::BigRational;

use super::Function;
use super::identity::{POINTS, Point, Value};

/// Returns for each node whether it is zero for all states, parameters and times.
#[must_use]
pub(super) fn vanishing(nodes: &[Node]) -> Vec<bool> {
    let mut vanishes = vec![true; nodes.len()];
    for point in 0..POINTS {
        let values = values(&Point { point }, nodes);
        for (vanishes, value) in vanishes.iter_mut().zip(values) {
            *vanishes &= value.is_some_and(Value::is_zero);
        }
    }
    vanishes
}

/// Returns the values of each node at all points; `None` if one of them divides by zero. Nodes are
/// equal for all states, parameters and times where these are.
#[must_use]
pub(super) fn at_points(nodes: &[Node]) -> Vec<Option<Vec<Value>>> {
    let at: Vec<_> = (0..POINTS).map(|point| values(&Point { point }, nodes)).collect();
    (0..nodes.len()).map(|index| at.iter().map(|values| values[index]).collect()).collect()
}

/// Returns the value of each node; `None` if it divides by zero.
fn values(point: &Point, nodes: &[Node]) -> Vec<Option<Value>> {
    let mut values: Vec<Option<Value>> = Vec::with_capacity(nodes.len());
    for node in nodes {
        let of = |id: NodeId| values[id.0 as usize];
        let value = value(point, &node.op, of);
        values.push(value);
    }
    values
}

fn value(point: &Point, op: &Op, of: impl Fn(NodeId) -> Option<Value>) -> Option<Value> {
    Some(match *op {
        Op::Literal(number) => Value::of(&BigRational::from_float(number)?)?,
        Op::Time => point.random(&[1]),
        Op::State(entry) => point.random(&[2, u64::from(entry)]),
        Op::Parameter(entry) => point.random(&[3, u64::from(entry)]),
        Op::Handed(entry) => point.random(&[4, u64::from(entry)]),
        Op::Held(place) => point.random(&[17, u64::from(place)]),
        Op::Constant(entry) => point.random(&[5, u64::from(entry)]),
        Op::Motion(entry) => point.random(&[6, u64::from(entry)]),
        Op::Neg(a) => of(a)?.minus(),
        Op::Add(a, b) => of(a)?.plus(of(b)?),
        Op::Sub(a, b) => of(a)?.plus(of(b)?.minus()),
        Op::Mul(a, b) => of(a)?.times(of(b)?),
        Op::Div(a, b) => of(a)?.times(of(b)?.inverse()?),
        Op::Powi(a, exponent) => of(a)?.power(&BigInt::from(exponent))?,
        Op::Powf(a, b) => point.opaque(100, &[of(a)?, of(b)?]),
        Op::Call(function, a) => point.call(Function::of_unary(function)?, &[of(a)?])?,
        Op::SelectLess { lhs, rhs, then, otherwise } => {
            let arguments = [of(lhs)?, of(rhs)?, of(then)?, of(otherwise)?];
            point.call(Function::SelectLess, &arguments)?
        }
        Op::Table { table, order, argument } => {
            point.call(Function::Table { table, order }, &[of(argument)?])?
        }
    })
}

//! Sums and products in the cheapest order: operands that depend on parameters only come first, so
//! that they are shared and can be computed once; signs become subtractions and negative powers
//! divisions.

use num_rational::BigRational;
use num_traits::{One, Signed, ToPrimitive};

use super::graph::Graph;
use super::overflow;
use machinist_model::{Function as Unary, NodeId};

use super::{Expr, Function, Shared};

/// Adds an expression, after the shared parts within it.
pub(super) fn lower(graph: &mut Graph, expr: &Expr) -> NodeId {
    for part in Shared::within(expr, |part| graph.shared.contains_key(&part.digest())) {
        let node = lower_part(graph, part.definition());
        if let Some(name) = part.name() {
            graph.name(node, name);
        }
        graph.shared.insert(part.digest(), node);
    }
    lower_part(graph, expr)
}

/// Adds an expression whose shared parts are on the graph.
fn lower_part(graph: &mut Graph, expr: &Expr) -> NodeId {
    match expr {
        Expr::Number(value) => {
            let value = to_f64(value);
            graph.literal(value)
        }
        Expr::Symbol(symbol) => graph.symbol(*symbol),
        Expr::Shared(shared) => graph.shared[&shared.digest()],
        Expr::Sum(terms) => sum(graph, terms),
        Expr::Product(factors) => product(graph, factors),
        Expr::Power(base, exponent) => power(graph, base, exponent),
        Expr::Call(Function::SelectLess, arguments) => {
            let sides: Vec<NodeId> = arguments.iter().map(|a| lower_part(graph, a)).collect();
            graph.select_less(sides[0], sides[1], sides[2], sides[3])
        }
        Expr::Call(Function::Table { table, order }, arguments) => {
            let argument = lower_part(graph, &arguments[0]);
            graph.table(*table, *order, argument)
        }
        Expr::Call(function, arguments) => {
            let argument = lower_part(graph, &arguments[0]);
            match function.unary() {
                Some(function) => graph.call(function, argument),
                None => unreachable!("selections and tables are lowered above"),
            }
        }
    }
}

/// Returns the nearest f64 of an exact number.
fn to_f64(value: &BigRational) -> f64 {
    // If numerator and denominator are exact, the quotient is correctly rounded.
    let exact = |n: &num_bigint::BigInt| n.bits() <= 53;
    match (value.numer().to_f64(), value.denom().to_f64()) {
        (Some(n), Some(d)) if exact(value.numer()) && exact(value.denom()) => n / d,
        _ => value.to_f64().unwrap_or(f64::NAN),
    }
}

fn power(graph: &mut Graph, base: &Expr, exponent: &Expr) -> NodeId {
    let node = lower_part(graph, base);
    let Expr::Number(value) = exponent else {
        let exponent = lower_part(graph, exponent);
        return graph.powf(node, exponent);
    };
    let half = *value.denom() == 2.into();
    match value.numer().to_i32() {
        Some(exponent) if value.is_integer() => graph.powi(node, exponent),
        Some(exponent) if half => {
            let root = graph.call(Unary::Sqrt, node);
            graph.powi(root, exponent)
        }
        _ => {
            let exponent = graph.literal(to_f64(value));
            graph.powf(node, exponent)
        }
    }
}

/// Lowers a product as the coefficient, then parameters over parameters, then the rest over the
/// rest.
fn product(graph: &mut Graph, factors: &[Expr]) -> NodeId {
    let mut coefficient = 1.0;
    let mut parts: [Vec<NodeId>; 4] = Default::default();
    for factor in factors {
        if let Expr::Number(value) = factor {
            coefficient *= to_f64(value);
            continue;
        }
        let (node, below) = match factor {
            Expr::Power(base, exponent) => match exponent.as_ref() {
                Expr::Number(value) if value.is_negative() => {
                    let positive = Expr::Number(-value.clone());
                    (power(graph, base, &positive), true)
                }
                _ => (lower_part(graph, factor), false),
            },
            _ => (lower_part(graph, factor), false),
        };
        let varying = !graph.is_constant(node);
        parts[usize::from(below) + 2 * usize::from(varying)].push(node);
    }
    let [parameters, under_parameters, mut varying, mut under_varying] = parts;
    overflow::avoid(graph, &mut varying, &mut under_varying);
    let sign = graph.literal(coefficient.signum());
    let coefficient = graph.literal(coefficient.abs());
    let constant = multiply(graph, coefficient, &parameters);
    let constant = divide(graph, constant, &under_parameters);
    let product = multiply(graph, constant, &varying);
    let product = divide(graph, product, &under_varying);
    graph.mul(sign, product)
}

fn multiply(graph: &mut Graph, first: NodeId, factors: &[NodeId]) -> NodeId {
    factors.iter().fold(first, |product, factor| graph.mul(product, *factor))
}

fn divide(graph: &mut Graph, numerator: NodeId, factors: &[NodeId]) -> NodeId {
    match factors {
        [] => numerator,
        [first, rest @ ..] => {
            let denominator = multiply(graph, *first, rest);
            graph.div(numerator, denominator)
        }
    }
}

/// Lowers a sum: parameters first, then added terms, then subtracted ones.
fn sum(graph: &mut Graph, terms: &[Expr]) -> NodeId {
    let mut nodes: Vec<(NodeId, bool)> = Vec::new();
    for term in terms {
        let (positive, negative) = without_sign(term);
        nodes.push((lower_part(graph, &positive), negative));
    }
    nodes.sort_by_key(|(node, negative)| (!graph.is_constant(*node), *negative));
    // A sum that starts with a subtraction would cost a negation.
    if let Some(first) = nodes.iter().position(|(_, negative)| !negative) {
        let first = nodes.remove(first);
        nodes.insert(0, first);
    }
    let zero = graph.literal(0.0);
    nodes.into_iter().fold(
        zero,
        |sum, (node, negative)| {
            if negative { graph.sub(sum, node) } else { graph.add(sum, node) }
        },
    )
}

/// Returns a term without its sign, and whether it was negative.
fn without_sign(term: &Expr) -> (Expr, bool) {
    match term {
        Expr::Number(value) if value.is_negative() => (Expr::Number(-value.clone()), true),
        Expr::Product(factors) => match factors.first() {
            Some(Expr::Number(value)) if value.is_negative() => {
                let positive = -value.clone();
                let mut factors = factors[1..].to_vec();
                if !positive.is_one() {
                    factors.insert(0, Expr::Number(positive));
                }
                let rest = match <[Expr; 1]>::try_from(factors) {
                    Ok([only]) => only,
                    Err(factors) => Expr::Product(factors),
                };
                (rest, true)
            }
            _ => (term.clone(), false),
        },
        _ => (term.clone(), false),
    }
}

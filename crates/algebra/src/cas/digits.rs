//! Loss of digits by expansion: powers of t - 0.77 are exact near 0.77 s, but the powers of t in
//! their expansion cancel there.

use machinist_model::{NodeId, Op, Tape, evaluate};
use num_traits::{Signed as _, ToPrimitive as _};

use crate::expr::{Expr, Function, Graph, Symbol};

/// Relative distances from the zero of a sum at which both forms are compared.
const NEAR: [f64; 3] = [1e-3, 1e-5, 1e-7];
/// Accepted error, as a multiple of the rounding error in the square of such a sum.
const ROUNDINGS: f64 = 100.0;
/// Maximum number of sums that are examined.
const MOST: usize = 8;

/// Returns whether the expanded expression is less accurate near the zero of a sum of a symbol and
/// a number within it, by more than a square of that sum would be.
pub(super) fn loses(expr: &Expr, multiplied_out: &Expr) -> bool {
    if spreads(expr, multiplied_out) {
        return true;
    }
    let zeros = zeros(expr);
    if zeros.is_empty() || ![expr, multiplied_out].into_iter().all(is_closed) {
        return false;
    }
    let mut graph = Graph::new();
    let mut roots: Vec<NodeId> = [expr, multiplied_out].map(|expr| graph.lower(expr)).to_vec();
    roots.extend(zeros.iter().map(|(symbol, _)| graph.lower(&Expr::Symbol(*symbol))));
    let tape = graph.tape(&roots);
    zeros.iter().zip(&tape.results[2..]).any(|((_, zero), symbol)| {
        NEAR.into_iter().any(|near| {
            let [a, b] = values(&tape, *symbol, zero * (1.0 + near));
            let lost = ROUNDINGS * f64::EPSILON / (near * near);
            (a - b).abs() > lost * a.abs() && a.is_finite()
        })
    })
}

/// Returns whether expansion spreads the power of a distance from a place given by parameters, or
/// of a sum with an exponential. Such a distance is small near the place, but the terms of its
/// expansion are not, and another parameter may be much smaller. Squares of exponentials overflow
/// sooner, and quotients with the sum are no longer recognized.
fn spreads(expr: &Expr, multiplied_out: &Expr) -> bool {
    let powers = |expr: &Expr, is: fn(&Expr) -> bool| {
        let mut bases = Vec::new();
        expr.visit(&mut |part| {
            if let Expr::Power(base, exponent) = part
                && matches!(**exponent, Expr::Number(_))
                && is(base)
            {
                bases.push((**base).clone());
            }
        });
        bases
    };
    let mut kept = powers(expr, |base| is_distance(base) || grows(base));
    // In an exponent or a denominator, where they are the distance to something.
    expr.visit(&mut |part| match part {
        Expr::Call(Function::Exp, arguments) => kept.extend(powers(&arguments[0], is_linear)),
        Expr::Power(base, exponent) if is_below(exponent) => kept.extend(powers(base, is_linear)),
        _ => {}
    });
    if kept.is_empty() {
        return false;
    }
    visit_values(multiplied_out, &mut |part| {
        if matches!(part, Expr::Sum(_)) {
            kept.retain(|kept| kept != part);
        }
    });
    !kept.is_empty()
}

/// Calls `see` with an expression and its parts, without the sides of comparisons: expansion leaves
/// them as they are, and no digits are lost there.
fn visit_values<'a>(expr: &'a Expr, see: &mut impl FnMut(&'a Expr)) {
    see(expr);
    match expr {
        Expr::Number(_) | Expr::Symbol(_) | Expr::Shared(_) => {}
        Expr::Call(Function::SelectLess, parts) => {
            for part in parts.iter().skip(2) {
                visit_values(part, see);
            }
        }
        Expr::Sum(parts) | Expr::Product(parts) | Expr::Call(_, parts) => {
            for part in parts {
                visit_values(part, see);
            }
        }
        Expr::Power(base, exponent) => {
            visit_values(base, see);
            visit_values(exponent, see);
        }
    }
}

fn is_below(exponent: &Expr) -> bool {
    matches!(exponent, Expr::Number(number) if number.is_negative())
}

/// Returns whether an expression is a sum with an exponential.
pub(super) fn grows(expr: &Expr) -> bool {
    let is_exponential = |expr: &Expr| matches!(expr, Expr::Call(Function::Exp, _));
    let has_exponential = |term: &Expr| match term {
        Expr::Product(factors) => factors.iter().any(is_exponential),
        term => is_exponential(term),
    };
    matches!(expr, Expr::Sum(terms) if terms.iter().any(has_exponential))
}

/// Returns whether an expression is a multiple of a state or time, less a product of parameters.
fn is_distance(expr: &Expr) -> bool {
    match expr {
        Expr::Sum(terms) => match &terms[..] {
            [a, b] => (is_of_place(a) && is_place(b)) || (is_place(a) && is_of_place(b)),
            _ => false,
        },
        _ => false,
    }
}

/// Returns whether an expression is a sum of multiples of states and time, and of parameters and
/// numbers.
fn is_linear(expr: &Expr) -> bool {
    let is_term =
        |term: &Expr| is_of_place(term) || is_place(term) || matches!(term, Expr::Number(_));
    matches!(expr, Expr::Sum(terms) if terms.iter().all(is_term) && terms.iter().any(is_of_place))
}

fn is_of_place(expr: &Expr) -> bool {
    is_multiple(expr, |symbol| {
        use Symbol::{Coordinate, FirstOrder, Time, Velocity};
        matches!(symbol, Time | Coordinate(_) | Velocity(_) | FirstOrder(_))
    })
}

fn is_place(expr: &Expr) -> bool {
    is_multiple(expr, |symbol| matches!(symbol, Symbol::Parameter(_)))
}

/// Returns whether an expression is a product of numbers and of symbols for which `is` returns
/// true.
fn is_multiple(expr: &Expr, is: fn(Symbol) -> bool) -> bool {
    let is_one = |factor: &Expr| matches!(factor, Expr::Symbol(symbol) if is(*symbol));
    match expr {
        Expr::Product(factors) => {
            let is_number = |factor: &Expr| matches!(factor, Expr::Number(_));
            factors.iter().all(|factor| is_one(factor) || is_number(factor))
                && factors.iter().any(is_one)
        }
        expr => is_one(expr),
    }
}

/// Returns the zeros of sums of a number and a multiple of one symbol.
fn zeros(expr: &Expr) -> Vec<(Symbol, f64)> {
    let mut zeros = Vec::new();
    expr.visit(&mut |part| {
        if let Expr::Sum(terms) = part
            && let [a, b] = &terms[..]
            && let Some(zero) = zero(a, b).or_else(|| zero(b, a))
            && !zeros.contains(&zero)
            && zeros.len() < MOST
        {
            zeros.push(zero);
        }
    });
    zeros
}

/// Returns the zero of c s + d.
fn zero(linear: &Expr, number: &Expr) -> Option<(Symbol, f64)> {
    let Expr::Number(number) = number else { return None };
    let (symbol, slope) = match linear {
        Expr::Symbol(symbol) => (*symbol, 1.0),
        Expr::Product(factors) => match &factors[..] {
            [Expr::Number(slope), Expr::Symbol(symbol)]
            | [Expr::Symbol(symbol), Expr::Number(slope)] => (*symbol, slope.to_f64()?),
            _ => return None,
        },
        _ => return None,
    };
    let zero = -number.to_f64()? / slope;
    (symbol != Symbol::Pi && zero.is_finite() && zero != 0.0).then_some((symbol, zero))
}

/// Returns whether the expression has a value once time, states and parameters have values.
fn is_closed(expr: &Expr) -> bool {
    let mut is_closed = true;
    expr.visit(&mut |part| {
        is_closed &= match part {
            Expr::Symbol(symbol) => matches!(
                symbol,
                Symbol::Pi
                    | Symbol::Time
                    | Symbol::Coordinate(_)
                    | Symbol::Velocity(_)
                    | Symbol::FirstOrder(_)
                    | Symbol::Parameter(_)
            ),
            Expr::Call(function, _) => !matches!(function, Function::Table { .. }),
            _ => true,
        };
    });
    is_closed
}

/// Returns the first two results with the given value of one symbol and arbitrary values of the
/// others.
fn values(tape: &Tape, symbol: NodeId, value: f64) -> [f64; 2] {
    let mut values: Vec<f64> = Vec::with_capacity(tape.nodes.len());
    for (index, node) in tape.nodes.iter().enumerate() {
        let own = |entry: u32| 0.4 + (0.618 * f64::from(entry)).fract();
        values.push(match node.op {
            _ if index == symbol.0 as usize => value,
            Op::Time => own(0),
            Op::State(entry) | Op::Parameter(entry) => own(entry + 1),
            op => evaluate::operate(op, |id| values[id.0 as usize], &evaluate::Inputs::default()),
        });
    }
    [0, 1].map(|result| values[tape.results[result].0 as usize])
}

#[cfg(test)]
mod tests {
    use super::*;

    fn number(value: i64) -> Expr {
        Expr::integer(value)
    }

    fn power(base: &Expr, exponent: i64) -> Expr {
        Expr::Power(Box::new(base.clone()), Box::new(number(exponent)))
    }

    #[test]
    fn powers_of_a_distance_lose_digits_multiplied_out_and_squares_do_not() {
        let time = Expr::Symbol(Symbol::Time);
        let distance = Expr::Sum(vec![time.clone(), number(-3)]);
        // t^2 - 6 t + 9, t^3 - 9 t^2 + 27 t - 27
        let multiple = |factor, power| Expr::Product(vec![number(factor), power]);
        let square = Expr::Sum(vec![power(&time, 2), multiple(-6, time.clone()), number(9)]);
        let cube = Expr::Sum(vec![
            power(&time, 3),
            multiple(-9, power(&time, 2)),
            multiple(27, time.clone()),
            number(-27),
        ]);
        assert!(!loses(&power(&distance, 2), &square));
        assert!(loses(&power(&distance, 3), &cube));
        // Nothing cancels there.
        let beside = Expr::Sum(vec![power(&distance, 3), number(5)]);
        let same = Expr::Sum(vec![cube, number(5)]);
        assert!(!loses(&beside, &same));
    }

    #[test]
    fn squares_of_a_distance_from_a_parameter_and_of_exponentials_stay() {
        use crate::expr::ParameterId;
        let [x, place] = [Symbol::Time, Symbol::Parameter(ParameterId(0))].map(Expr::Symbol);
        let minus = |expr: &Expr| Expr::Product(vec![number(-1), expr.clone()]);
        let distance = Expr::Sum(vec![x.clone(), minus(&place)]);
        let apart = Expr::Sum(vec![power(&x, 2), power(&place, 2)]);
        assert!(loses(&power(&distance, 2), &apart));
        assert!(!loses(&power(&distance, 2), &Expr::Product(vec![distance.clone(), x.clone()])));
        assert!(!loses(&power(&Expr::Sum(vec![x.clone(), power(&place, 2)]), 2), &apart));
        // The same for numbers in an exponent: x^2 - 6 x + 9.
        let near = power(&Expr::Sum(vec![x.clone(), number(-3)]), 2);
        let middle = Expr::Product(vec![number(-6), x.clone()]);
        let out = Expr::Sum(vec![power(&x, 2), middle, number(9)]);
        let exp = |argument: &Expr| Expr::Call(Function::Exp, vec![argument.clone()]);
        assert!(!loses(&near, &out) && loses(&exp(&near), &exp(&out)));
        let exponential = Expr::Call(Function::Exp, vec![x]);
        let sum = Expr::Sum(vec![number(1), exponential.clone()]);
        assert!(loses(&power(&sum, -2), &power(&exponential, -2)));
    }
}

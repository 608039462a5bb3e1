//! Bounds for the size of an expression after expansion or differentiation, computed before.
//!
//! Sizes are numbers of leaves without sharing. The bounds are computed in time linear in the
//! expression, and in floating point so that none overflows.

use num_bigint::BigInt;
use num_traits::{Signed as _, ToPrimitive as _};

use super::{Expr, Function};

/// Size of an expression after expansion.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Expanded {
    /// Number of terms of the sum.
    pub terms: f64,
    /// Number of leaves of all terms, including those of exact numbers that grow with powers.
    pub leaves: f64,
}

/// Passes through the inside of a denominator for each pass through its surroundings: if nested,
/// these multiply.
const AGAIN: f64 = 2.0;

/// Returns a bound for the size of an expression after expansion, within functions too.
#[must_use]
pub fn expanded(expr: &Expr) -> Expanded {
    match expr {
        Expr::Number(_) | Expr::Symbol(_) | Expr::Shared(_) => Expanded { terms: 1.0, leaves: 1.0 },
        Expr::Sum(parts) => {
            parts.iter().map(expanded).fold(Expanded { terms: 0.0, leaves: 0.0 }, |sum, part| {
                Expanded { terms: sum.terms + part.terms, leaves: sum.leaves + part.leaves }
            })
        }
        Expr::Product(parts) => parts.iter().map(expanded).fold(
            Expanded { terms: 1.0, leaves: 0.0 },
            |product, part| Expanded {
                terms: product.terms * part.terms,
                leaves: product.leaves * part.terms + part.leaves * product.terms,
            },
        ),
        Expr::Power(base, exponent) => {
            let base = expanded(base);
            let Some(exponent) = whole(exponent) else {
                let exponent = expanded(exponent);
                return Expanded { terms: 1.0, leaves: AGAIN * (base.leaves + exponent.leaves) };
            };
            let count = exponent.abs();
            // Number of ways to choose `count` factors from the terms.
            let terms = choose(base.terms + count - 1.0, count.min(base.terms - 1.0));
            let bits = count * base.terms.log2();
            let leaves = terms * (base.leaves / base.terms * count.min(base.terms) + bits / 64.0);
            if exponent < 0.0 {
                Expanded { terms: 1.0, leaves: AGAIN * leaves }
            } else {
                Expanded { terms, leaves }
            }
        }
        Expr::Call(_, parts) => Expanded {
            terms: 1.0,
            leaves: 1.0 + parts.iter().map(|part| expanded(part).leaves).sum::<f64>(),
        },
    }
}

fn whole(exponent: &Expr) -> Option<f64> {
    match exponent {
        Expr::Number(value) if value.is_integer() => value.numer().to_f64(),
        _ => None,
    }
}

/// Returns n over k, up to a large limit.
fn choose(n: f64, k: f64) -> f64 {
    let mut ways = 1.0_f64;
    let mut step = 0.0;
    while step < k && ways < 1e300 {
        ways *= (n - step) / (step + 1.0);
        step += 1.0;
    }
    ways.max(1.0)
}

/// Numbers of leaves of an expression, of a first derivative and of a second, each by one symbol.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Derivatives {
    /// Number for the expression itself.
    pub value: f64,
    /// Number for a first derivative.
    pub first: f64,
    /// Number for a second derivative.
    pub second: f64,
}

/// Returns bounds for the sizes of derivatives by the rules of sums, products and chains.
#[must_use]
pub fn derivatives(expr: &Expr) -> Derivatives {
    match expr {
        Expr::Number(_) => Derivatives { value: 1.0, first: 0.0, second: 0.0 },
        Expr::Symbol(_) => Derivatives { value: 1.0, first: 1.0, second: 0.0 },
        // Its derivatives are shared parts too.
        Expr::Shared(_) => Derivatives { value: 1.0, first: 1.0, second: 1.0 },
        Expr::Sum(parts) => {
            let zero = Derivatives { value: 0.0, first: 0.0, second: 0.0 };
            parts.iter().map(derivatives).fold(zero, |sum, part| Derivatives {
                value: sum.value + part.value,
                first: sum.first + part.first,
                second: sum.second + part.second,
            })
        }
        Expr::Product(parts) => product(parts),
        Expr::Power(base, _) => {
            let base = derivatives(base);
            let value = base.value + 1.0;
            chain(value, base, value + 1.0, value + 2.0)
        }
        Expr::Call(Function::SelectLess, parts) => {
            // Branch by branch.
            let sides: f64 = parts.iter().take(2).map(|part| derivatives(part).value).sum();
            let mut all = Derivatives { value: sides, first: sides, second: sides };
            for part in parts.iter().skip(2).map(derivatives) {
                all.value += part.value;
                all.first += part.first;
                all.second += part.second;
            }
            all
        }
        Expr::Call(_, parts) => {
            let Some(argument) = parts.first().map(derivatives) else {
                return Derivatives { value: 1.0, first: 0.0, second: 0.0 };
            };
            let value = argument.value + 1.0;
            chain(value, argument, value + 1.0, 2.0 * value + 1.0)
        }
    }
}

/// f(g): f' g', and f'' g'^2 + f' g''.
fn chain(value: f64, inner: Derivatives, outer_first: f64, outer_second: f64) -> Derivatives {
    if inner.first == 0.0 {
        return Derivatives { value, first: 0.0, second: 0.0 };
    }
    let bend = if inner.second == 0.0 { 0.0 } else { outer_first + inner.second };
    Derivatives {
        value,
        first: outer_first + inner.first,
        second: outer_second + inner.first + bend,
    }
}

fn product(parts: &[Expr]) -> Derivatives {
    let parts: Vec<Derivatives> = parts.iter().map(derivatives).collect();
    let moving: Vec<&Derivatives> = parts.iter().filter(|part| part.first > 0.0).collect();
    let value: f64 = parts.iter().map(|part| part.value).sum();
    let (count, firsts) =
        moving.iter().fold((0.0, 0.0), |(count, sum), part| (count + 1.0, sum + part.first));
    let values: f64 = moving.iter().map(|part| part.value).sum();
    // Over all i: f_i' and the rest of the product.
    let first = firsts + count * value - values;
    // Over all i: f_i''; over all i and j: f_i' f_j'.
    let bends: f64 = moving
        .iter()
        .filter(|part| part.second > 0.0)
        .map(|part| part.second + value - part.value)
        .sum();
    let pairs = (count - 1.0).max(0.0) * (2.0 * firsts + count * value - 2.0 * values);
    Derivatives { value, first, second: bends + pairs }
}

/// Returns the number of bits of the largest exact number within an expression.
#[must_use]
pub fn bits(expr: &Expr) -> u64 {
    let mut most = 0;
    expr.visit(&mut |part| {
        if let Expr::Number(number) = part {
            let bits = |part: &BigInt| part.abs().bits();
            most = most.max(bits(number.numer()).max(bits(number.denom())));
        }
    });
    most
}

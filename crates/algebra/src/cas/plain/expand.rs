//! Expansion of products.

use num_traits::{One as _, Signed as _, ToPrimitive as _};

use super::normal::{call, power, product, sum};
use crate::expr::Expr;

/// Expands an expression in normal form, within functions too. Callers must check the size of the
/// result before: see [`crate::expr::extent`].
pub(in crate::cas) fn expand(expr: &Expr) -> Expr {
    match expr {
        Expr::Number(_) | Expr::Symbol(_) | Expr::Shared(_) => expr.clone(),
        Expr::Sum(terms) => sum(terms.iter().map(expand)),
        Expr::Product(factors) => {
            // An expanded base may have become a factor, and its power that of a sum.
            let whole = product(factors.iter().map(expand));
            match &whole {
                Expr::Product(factors) => {
                    factors.iter().map(expanded_power).fold(Expr::integer(1), multiplied)
                }
                _ => whole,
            }
        }
        Expr::Power(base, exponent) => expanded_power(&power(expand(base), expand(exponent))),
        Expr::Call(function, arguments) => call(*function, arguments.iter().map(expand).collect()),
    }
}

/// Expands a power of a sum; returns any other expression unchanged.
fn expanded_power(factor: &Expr) -> Expr {
    let Expr::Power(base, exponent) = factor else { return factor.clone() };
    let Expr::Number(exponent) = &**exponent else { return factor.clone() };
    let count = exponent.is_integer().then(|| exponent.numer().to_u32()).flatten();
    match (&**base, count) {
        (Expr::Sum(_), Some(count)) => raised(base, count),
        (Expr::Sum(_), None) if exponent.is_integer() && exponent.is_negative() => {
            let below = (-exponent).numer().to_u32().map(|count| raised(base, count));
            below.map_or_else(|| factor.clone(), |below| power(below, Expr::integer(-1)))
        }
        _ => factor.clone(),
    }
}

fn raised(base: &Expr, count: u32) -> Expr {
    (0..count).fold(Expr::integer(1), |power, _| multiplied(power, base.clone()))
}

/// Returns the product of two sums, term by term.
fn multiplied(left: Expr, right: Expr) -> Expr {
    let terms = |expr| match expr {
        Expr::Sum(terms) => terms,
        other => vec![other],
    };
    if matches!(&left, Expr::Number(value) if value.is_one()) {
        return right;
    }
    let (left, right) = (terms(left), terms(right));
    sum(left.iter().flat_map(|a| right.iter().map(|b| product([a.clone(), b.clone()]))))
}

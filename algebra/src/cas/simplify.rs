//! Which of several equal forms is cheapest.

use num_rational::BigRational;
use num_traits::Signed as _;

use super::{Cas, Form, Kind, digits, plain};
use crate::expr::extent::{self, bits};
use crate::expr::trigonometry::{combine, has_sine};
use crate::expr::{Expr, Function, operations, weigh};

/// Forms larger than this are not multiplied out.
const EXPAND_LIMIT: usize = 2000;

/// Leaves beyond which nothing is multiplied out, by a bound told beforehand: ten sums of
/// ten terms are small before and 10^10 terms after.
const EXPANDED_LIMIT: f64 = 20_000.0;

/// Likewise for common denominators.
const JOINED_LIMIT: f64 = 1500.0;

/// Whether multiplying an expression out has a result of bounded size.
pub(super) fn may_be_expanded(expr: &Expr) -> bool {
    extent::expanded(expr).leaves <= EXPANDED_LIMIT && bits(expr) <= NUMBER_LIMIT
}

/// Whether putting an expression over one denominator does.
pub(super) fn may_be_joined(expr: &Expr) -> bool {
    extent::expanded(expr).leaves <= JOINED_LIMIT
        && bits(expr) <= NUMBER_LIMIT
        && !has_high_degree(expr)
        && !has_growing_denominator(expr)
}

/// Sums with higher powers than this are not put over one denominator.
const HIGHEST_DEGREE: i32 = 16;

/// Bits of exact numbers beyond which algebra with them is not worth its time.
const NUMBER_LIMIT: u64 = 8192;

/// The form whose tape takes the least time: as it is, multiplied out with
/// trigonometric identities applied, or so with common factors collected. Polynomials are not
/// factored: Symbolica's factors save two operations in a thousand of the scenes, and it does
/// not find an end of one polynomial in some thousands.
pub(super) fn cheapest(cas: &mut Cas, form: &Form) -> Expr {
    let own = cas.expr(form);
    let (size, cost) = weigh(&own);
    if size <= 1 {
        return own;
    }
    let is_expanded = size <= EXPAND_LIMIT && may_be_expanded(&own);
    let candidates = if is_expanded {
        let expanded = expanded(cas, form);
        vec![collected(cas, &expanded), cas.expr(&expanded)]
    } else {
        let combined = trigonometric(cas, form);
        vec![cas.expr(&combined)]
    };
    let mut best = (cost, None);
    for candidate in candidates {
        let (_, cost) = weigh(&candidate);
        let is_worse = || {
            is_expanded && digits::loses(&own, &candidate)
                || is_over_what_grows(&candidate) && !is_over_what_grows(&own)
        };
        if cost < best.0 && !is_worse() {
            best = (cost, Some(candidate));
        }
    }
    best.1.unwrap_or(own)
}

/// With factors that terms share before them.
fn collected(cas: &Cas, form: &Form) -> Expr {
    match &form.0 {
        #[cfg(feature = "symbolica")]
        Kind::Symbolica(known) => cas.expr(&known.collect().into()),
        Kind::Plain(_) => plain::collect(&cas.expr(form)),
    }
}

/// The form itself, or multiplied out with trigonometric identities applied if that
/// is shorter, written out without any sharing.
pub(super) fn shorter(cas: &mut Cas, form: &Form) -> Form {
    let expr = cas.expr(form);
    if operations(&expr) > EXPAND_LIMIT || !may_be_expanded(&expr) {
        return form.clone();
    }
    let expanded = expanded(cas, form);
    let is_shorter = size(&expanded) < size(form);
    if is_shorter && !digits::loses(&expr, &cas.expr(&expanded)) { expanded } else { form.clone() }
}

fn size(form: &Form) -> usize {
    match &form.0 {
        #[cfg(feature = "symbolica")]
        Kind::Symbolica(known) => known.size(),
        Kind::Plain(plain) => plain.size(),
    }
}

/// Multiplied out, with trigonometric identities applied.
pub(super) fn expanded(cas: &mut Cas, form: &Form) -> Form {
    trigonometric(cas, &form.expand())
}

/// Whether there is a high power, or an exponential with a number in its argument:
/// exp(50 t + 7) is a power of exp(t) to Symbolica. Polynomials of degree 50 take long to
/// divide, and those with large numbers besides, such as (1000/a)^64 + a, for ever.
fn has_high_degree(expr: &Expr) -> bool {
    let one = BigRational::from_integer(1.into());
    let highest = BigRational::from_integer(HIGHEST_DEGREE.into());
    let mut found = false;
    expr.visit(&mut |part| {
        if let Expr::Power(_, exponent) = part {
            found |= matches!(&**exponent, Expr::Number(number) if number.abs() > highest);
        }
        if let Expr::Call(Function::Exp, arguments) = part {
            for argument in arguments {
                argument.visit(&mut |part| {
                    found |= matches!(part, Expr::Number(number) if number.abs() != one);
                });
            }
        }
    });
    found
}

/// Whether a power of what grows beyond all numbers is a denominator.
fn has_growing_denominator(expr: &Expr) -> bool {
    let mut found = false;
    expr.visit(&mut |part| found |= growing_denominator(part).is_some());
    found
}

/// What grows beyond all numbers, of a power that is a denominator.
fn growing_denominator(expr: &Expr) -> Option<&Expr> {
    let Expr::Power(base, exponent) = expr else { return None };
    let Expr::Number(number) = &**exponent else { return None };
    let two = BigRational::from_integer(2.into());
    let is_cosh = matches!(**base, Expr::Call(Function::Cosh, _));
    let grows = is_cosh || digits::grows(base) && number.abs() >= two;
    (number.is_negative() && grows).then_some(base)
}

/// Whether a sum with what grows beyond all numbers is over that: infinity over infinity, where
/// each term for itself is a number.
fn is_over_what_grows(expr: &Expr) -> bool {
    let mut found = false;
    expr.visit(&mut |part| {
        let Expr::Product(factors) = part else { return };
        for below in factors.iter().filter_map(growing_denominator) {
            let mut sums = factors.iter().filter(|factor| matches!(factor, Expr::Sum(_)));
            found |= sums.any(|sum| {
                let mut is_inside = false;
                sum.visit(&mut |part| is_inside |= part == below);
                is_inside
            });
        }
    });
    found
}

/// Pythagoras and the addition theorems, as often as they apply.
fn trigonometric(cas: &mut Cas, form: &Form) -> Form {
    let mut current = form.clone();
    let mut expr = cas.expr(&current);
    while has_sine(&expr) {
        // The algebra puts what is joined in normal form again.
        current = cas.form(&combine(&expr));
        let joined = cas.expr(&current);
        if joined == expr {
            break;
        }
        expr = joined;
    }
    current
}

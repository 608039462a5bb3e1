//! Choice of the cheapest of several equal forms.

use num_rational::BigRational;
use num_traits::Signed as _;

use super::{Cas, Form, Kind, digits, plain};
use crate::expr::extent::{self, bits};
use crate::expr::trigonometry::{combine, has_sine};
use crate::expr::{Expr, Function, operations, weigh};

/// Maximum number of operations of a form that is expanded.
const EXPAND_LIMIT: usize = 2000;

/// Maximum number of leaves after expansion, by a bound known before: a product of ten sums of ten
/// terms is small, but its expansion has 10^10 terms.
const EXPANDED_LIMIT: f64 = 20_000.0;

/// The same for common denominators.
const JOINED_LIMIT: f64 = 1500.0;

/// Returns whether the expansion of an expression has an acceptable size.
pub(super) fn may_be_expanded(expr: &Expr) -> bool {
    extent::expanded(expr).leaves <= EXPANDED_LIMIT && bits(expr) <= NUMBER_LIMIT
}

/// Returns whether an expression over one denominator has an acceptable size.
pub(super) fn may_be_joined(expr: &Expr) -> bool {
    extent::expanded(expr).leaves <= JOINED_LIMIT
        && bits(expr) <= NUMBER_LIMIT
        && !has_high_degree(expr)
        && !has_growing_denominator(expr)
}

/// Highest power in sums that are put over one denominator.
const HIGHEST_DEGREE: i32 = 16;

/// Maximum number of bits of exact numbers for which algebra is worth its time.
const NUMBER_LIMIT: u64 = 8192;

/// Returns the form whose tape takes the least time: the original, the expansion with trigonometric
/// identities applied, or that with common factors collected. Polynomials are not factored:
/// Symbolica's factors save two operations in a thousand in the scenes, and its factorization of
/// one polynomial in some thousands does not end.
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

/// Returns the form with factors that terms share taken out.
fn collected(cas: &Cas, form: &Form) -> Expr {
    match &form.0 {
        #[cfg(feature = "symbolica")]
        Kind::Symbolica(known) => cas.expr(&known.collect().into()),
        Kind::Plain(_) => plain::collect(&cas.expr(form)),
    }
}

/// Returns the form, or its expansion with trigonometric identities applied if that is shorter,
/// counted without sharing.
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

/// Returns the expansion with trigonometric identities applied.
pub(super) fn expanded(cas: &mut Cas, form: &Form) -> Form {
    trigonometric(cas, &form.expand())
}

/// Returns whether there is a high power, or an exponential with a number in its argument:
/// Symbolica treats exp(50 t + 7) as a power of exp(t). Polynomials of degree 50 take long to
/// divide, and those that also have large numbers, such as (1000/a)^64 + a, do not finish.
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

/// Returns whether a denominator is a power of an exponentially growing expression.
fn has_growing_denominator(expr: &Expr) -> bool {
    let mut found = false;
    expr.visit(&mut |part| found |= growing_denominator(part).is_some());
    found
}

/// Returns the exponentially growing base of a power in a denominator.
fn growing_denominator(expr: &Expr) -> Option<&Expr> {
    let Expr::Power(base, exponent) = expr else { return None };
    let Expr::Number(number) = &**exponent else { return None };
    let two = BigRational::from_integer(2.into());
    let is_cosh = matches!(**base, Expr::Call(Function::Cosh, _));
    let grows = is_cosh || digits::grows(base) && number.abs() >= two;
    (number.is_negative() && grows).then_some(base)
}

/// Returns whether a sum that contains an exponentially growing expression is divided by it: this
/// is infinity over infinity, although each term alone is finite.
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

/// Applies Pythagoras and the addition theorems as often as possible.
fn trigonometric(cas: &mut Cas, form: &Form) -> Form {
    let mut current = form.clone();
    let mut expr = cas.expr(&current);
    while has_sine(&expr) {
        let combined = match (combine(&expr), &current.0) {
            (Some(combined), _) => combined,
            (None, Kind::Plain(_)) => break,
            // An expansion by Symbolica reaches its normal form when it is read again.
            #[cfg(feature = "symbolica")]
            (None, Kind::Symbolica(_)) => expr.clone(),
        };
        // The algebra restores the normal form of the joined terms.
        current = cas.form(&combined);
        let joined = cas.expr(&current);
        if joined == expr {
            break;
        }
        expr = joined;
    }
    current
}

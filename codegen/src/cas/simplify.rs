//! Which of several equal forms is cheapest.

use num_rational::BigRational;
use num_traits::Signed as _;
use symbolica::atom::{Atom, AtomCore};

use super::convert::{to_atom, to_expr};
use super::functions::Vocabulary;
use crate::expr::extent::{bits, expanded};
use crate::expr::trigonometry::{combine, has_sine};
use crate::expr::{Expr, Function, operations, weigh};

/// Forms larger than this are not factored: the cost of factoring grows much
/// faster than what it can save.
const FACTOR_LIMIT: usize = 60;

/// Forms larger than this are not multiplied out.
const EXPAND_LIMIT: usize = 2000;

/// Leaves beyond which nothing is multiplied out, by a bound told beforehand: ten sums of
/// ten terms are small before and 10^10 terms after.
const EXPANDED_LIMIT: f64 = 20_000.0;

/// Likewise for factoring and for common denominators.
const FACTORED_LIMIT: f64 = 1500.0;

/// Whether multiplying an expression out has a result of bounded size.
pub(super) fn may_be_expanded(expr: &Expr) -> bool {
    expanded(expr).leaves <= EXPANDED_LIMIT && bits(expr) <= NUMBER_LIMIT
}

/// Whether putting an expression over one denominator does.
pub(super) fn may_be_factored(expr: &Expr) -> bool {
    expanded(expr).leaves <= FACTORED_LIMIT && bits(expr) <= NUMBER_LIMIT && !has_high_degree(expr)
}

/// Powers higher than this are not factored.
const HIGHEST_DEGREE: i32 = 16;

/// Bits of exact numbers beyond which algebra with them is not worth its time.
const NUMBER_LIMIT: u64 = 8192;

/// The form whose tape takes the least time: as it is, multiplied out with
/// trigonometric identities applied, with common factors collected, or factored.
pub(super) fn cheapest(vocabulary: &mut Vocabulary, atom: &Atom) -> Expr {
    let expr = to_expr(vocabulary, atom.as_view());
    let (size, cost) = weigh(&expr);
    let is_expanded = size <= EXPAND_LIMIT && may_be_expanded(&expr);
    let mut best = (cost, expr);
    if size <= 1 {
        return best.1;
    }
    let mut offer = |candidate: Expr| {
        let (_, cost) = weigh(&candidate);
        if cost < best.0 {
            best = (cost, candidate);
        }
    };
    if is_expanded {
        let expanded = trigonometric(vocabulary, &atom.expand());
        offer(to_expr(vocabulary, expanded.collect_factors().as_view()));
        let as_sum = to_expr(vocabulary, expanded.as_view());
        if size <= FACTOR_LIMIT && may_be_factored(&as_sum) {
            offer(to_expr(vocabulary, expanded.factor().as_view()));
        }
        offer(as_sum);
    } else {
        let combined = trigonometric(vocabulary, atom);
        offer(to_expr(vocabulary, combined.as_view()));
    }
    best.1
}

/// The form itself, or multiplied out with trigonometric identities applied if that
/// is shorter, written out without any sharing.
pub(super) fn shorter(vocabulary: &mut Vocabulary, atom: &Atom) -> Atom {
    let expr = to_expr(vocabulary, atom.as_view());
    if operations(&expr) > EXPAND_LIMIT || !may_be_expanded(&expr) {
        return atom.clone();
    }
    let expanded = trigonometric(vocabulary, &atom.expand());
    let size = |atom: &Atom| atom.as_view().get_byte_size();
    if size(&expanded) < size(atom) { expanded } else { atom.clone() }
}

/// Whether there is a high power, or an exponential with a number in its argument:
/// exp(50 t + 7) is a power of exp(t) to Symbolica. Polynomials of degree 50 take long to
/// factor, and those with large numbers besides, such as (1000/a)^64 + a, for ever.
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

/// Pythagoras and the addition theorems, as often as they apply.
pub(super) fn trigonometric(vocabulary: &mut Vocabulary, atom: &Atom) -> Atom {
    let mut current = atom.clone();
    loop {
        let expr = to_expr(vocabulary, current.as_view());
        if !has_sine(&expr) {
            return current;
        }
        // Symbolica puts what is joined in normal form again.
        let next = to_atom(vocabulary, &combine(&expr));
        if next == current {
            return current;
        }
        current = next;
    }
}

//! Extraction of common factors from sums.

use std::collections::BTreeMap;

use num_rational::BigRational;
use num_traits::{One as _, Signed as _, Zero as _};

use crate::expr::Expr;

/// Maximum number of terms of a sum: each factor needs a pass through the remaining sum.
const MOST_TERMS: usize = 400;

/// Returns an equal expression. From every sum the factor that most of its terms share is taken
/// out, as often as there is one. The result is not in normal form, in which numbers are
/// distributed over sums.
pub(in crate::cas) fn collect(expr: &Expr) -> Expr {
    let all = |parts: &[Expr]| parts.iter().map(collect).collect::<Vec<_>>();
    match expr {
        Expr::Number(_) | Expr::Symbol(_) | Expr::Shared(_) => expr.clone(),
        Expr::Sum(terms) if terms.len() > MOST_TERMS => expr.clone(),
        Expr::Sum(terms) => collected(all(terms).into_iter().map(Term::of).collect()),
        Expr::Product(factors) => Expr::Product(all(factors)),
        Expr::Power(base, exponent) => {
            Expr::Power(Box::new(collect(base)), Box::new(collect(exponent)))
        }
        Expr::Call(function, arguments) => Expr::Call(*function, all(arguments)),
    }
}

/// A number times powers of bases.
struct Term {
    number: BigRational,
    powers: BTreeMap<Expr, BigRational>,
}

impl Term {
    fn of(expr: Expr) -> Self {
        let mut term = Term { number: BigRational::one(), powers: BTreeMap::new() };
        match expr {
            Expr::Product(factors) => factors.into_iter().for_each(|factor| term.take(factor)),
            other => term.take(other),
        }
        term
    }

    fn take(&mut self, factor: Expr) {
        match factor {
            Expr::Number(value) => self.number *= value,
            Expr::Power(base, exponent) => match *exponent {
                Expr::Number(value) => *self.powers.entry(*base).or_default() += value,
                exponent => {
                    let power = Expr::Power(base, Box::new(exponent));
                    *self.powers.entry(power).or_default() += BigRational::one();
                }
            },
            other => *self.powers.entry(other).or_default() += BigRational::one(),
        }
    }

    fn into_expr(self) -> Expr {
        let mut factors = Vec::new();
        if !self.number.is_one() || self.powers.is_empty() {
            factors.push(Expr::Number(self.number));
        }
        for (base, exponent) in self.powers {
            factors.push(if exponent.is_one() {
                base
            } else {
                Expr::Power(Box::new(base), Box::new(Expr::Number(exponent)))
            });
        }
        if factors.len() == 1 { factors.swap_remove(0) } else { Expr::Product(factors) }
    }
}

/// Returns a sum of terms with the most frequent base taken out.
fn collected(terms: Vec<Term>) -> Expr {
    let mut counts: BTreeMap<(&Expr, bool), usize> = BTreeMap::new();
    for (base, exponent) in terms.iter().flat_map(|term| &term.powers) {
        *counts.entry((base, exponent.is_positive())).or_default() += 1;
    }
    let shared = counts.into_iter().filter(|(_, count)| *count > 1);
    // Among equally frequent ones the first in order, so that the result is deterministic.
    let most = shared.max_by(|(a, m), (b, n)| m.cmp(n).then_with(|| b.cmp(a)));
    let Some(((base, is_above), _)) = most else {
        return sum(terms.into_iter().map(Term::into_expr).collect());
    };
    let base = base.clone();
    let (mut with, without): (Vec<Term>, Vec<Term>) = terms.into_iter().partition(|term| {
        term.powers.get(&base).is_some_and(|exponent| exponent.is_positive() == is_above)
    });
    let exponents = with.iter().filter_map(|term| term.powers.get(&base));
    let least = exponents.min_by_key(|exponent| exponent.abs()).cloned();
    let Some(least) = least else { unreachable!("two terms have the base") };
    for term in &mut with {
        if let Some(exponent) = term.powers.get_mut(&base) {
            *exponent -= &least;
        }
        term.powers.retain(|_, exponent| !exponent.is_zero());
    }
    let before = Term { number: BigRational::one(), powers: [(base, least)].into() };
    let mut factors = vec![before.into_expr()];
    match collected(with) {
        Expr::Product(inner) => factors.extend(inner),
        inner => factors.push(inner),
    }
    factors.sort();
    let product = Expr::Product(factors);
    if without.is_empty() {
        return product;
    }
    match collected(without) {
        Expr::Sum(mut terms) => {
            terms.push(product);
            sum(terms)
        }
        other => sum(vec![other, product]),
    }
}

fn sum(mut terms: Vec<Expr>) -> Expr {
    terms.sort();
    if terms.len() == 1 { terms.swap_remove(0) } else { Expr::Sum(terms) }
}

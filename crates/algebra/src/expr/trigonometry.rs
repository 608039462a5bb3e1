//! Pythagoras and the addition theorems on sums of products:
//!
//! ```text
//! c sin^2 x + c cos^2 x             = c
//! c cos x cos y + c sin x sin y     = c cos(x - y)      with -: cos(x + y)
//! c sin x cos y - c cos x sin y     = c sin(x - y)      with +: sin(x + y)
//! ```
//!
//! Every rule removes one term from a sum, so repeated application ends.

use std::borrow::Cow;

use num_rational::BigRational;
use num_traits::One;
use rustc_hash::FxHashMap;

use crate::expr::{Expr, Function};

/// Maximum number of sines and cosines in a term for which partners are searched, because the pairs
/// are many.
const MOST_FACTORS: usize = 16;

/// Applies the rules everywhere, as often as possible; `None` if none applies. Parts in which none
/// applies stay as they are, in their normal form.
#[must_use]
pub fn combine(expr: &Expr) -> Option<Expr> {
    match expr {
        Expr::Number(_) | Expr::Symbol(_) | Expr::Shared(_) => None,
        Expr::Sum(terms) => {
            let combined = combine_all(terms);
            combine_sum(combined.as_deref().unwrap_or(terms)).or(combined.map(Expr::Sum))
        }
        Expr::Product(factors) => combine_all(factors).map(Expr::Product),
        Expr::Power(base, exponent) => {
            let combined = [combine(base), combine(exponent)];
            if combined.iter().all(Option::is_none) {
                return None;
            }
            let [of_base, of_exponent] = combined;
            let base = or_as_it_was((base, of_base));
            Some(Expr::Power(Box::new(base), Box::new(or_as_it_was((exponent, of_exponent)))))
        }
        Expr::Call(function, arguments) => {
            combine_all(arguments).map(|arguments| Expr::Call(*function, arguments))
        }
    }
}

/// Applies the rules to several parts; `None` if none applies.
fn combine_all(parts: &[Expr]) -> Option<Vec<Expr>> {
    let combined: Vec<Option<Expr>> = parts.iter().map(combine).collect();
    if combined.iter().all(Option::is_none) {
        return None;
    }
    Some(parts.iter().zip(combined).map(or_as_it_was).collect())
}

fn or_as_it_was((part, combined): (&Expr, Option<Expr>)) -> Expr {
    combined.unwrap_or_else(|| part.clone())
}

/// Returns whether an expression contains a sine, without which no rule applies.
#[must_use]
pub fn has_sine(expr: &Expr) -> bool {
    match expr {
        Expr::Number(_) | Expr::Symbol(_) | Expr::Shared(_) => false,
        Expr::Call(Function::Sin, _) => true,
        Expr::Sum(parts) | Expr::Product(parts) | Expr::Call(_, parts) => {
            parts.iter().any(has_sine)
        }
        Expr::Power(base, exponent) => has_sine(base) || has_sine(exponent),
    }
}

/// A term as a coefficient and sorted numbers of its factors; powers of sine and cosine are repeated
/// factors.
struct Term {
    coefficient: BigRational,
    factors: Vec<u32>,
}

/// Applies the rules to the terms of a sum; `None` if none applies.
fn combine_sum(terms: &[Expr]) -> Option<Expr> {
    // Only terms with two sines or cosines have a partner.
    terms.iter().filter(|term| sines_and_cosines(term) > 1).nth(1)?;
    let mut known = Factors::default();
    let mut terms: Vec<Option<Term>> = terms.iter().map(|term| Some(known.term(term))).collect();
    let mut places: FxHashMap<Vec<u32>, usize> = FxHashMap::default();
    for (index, term) in terms.iter().flatten().enumerate() {
        places.insert(term.factors.clone(), index);
    }
    let (mut at, mut is_changed) = (0, false);
    while at < terms.len() {
        let merged = terms[at].as_ref().and_then(|term| known.partner(term, &terms, &places, at));
        if let Some((other, merged)) = merged {
            is_changed = true;
            terms[at] = None;
            terms[other] = None;
            // The new term may have a partner itself, or equal a known one.
            let place = places.get(&merged.factors).copied().unwrap_or(terms.len());
            if let Some(Some(known)) = terms.get_mut(place) {
                known.coefficient += merged.coefficient;
                at = at.min(place);
            } else {
                places.insert(merged.factors.clone(), terms.len());
                terms.push(Some(merged));
                at += 1;
            }
        } else {
            at += 1;
        }
    }
    is_changed.then(|| Expr::Sum(terms.iter().flatten().map(|term| known.expr(term)).collect()))
}

/// The factors of a sum's terms, each with a number: terms are compared with many others.
#[derive(Default)]
struct Factors<'a> {
    all: Vec<Cow<'a, Expr>>,
    numbers: FxHashMap<Cow<'a, Expr>, u32>,
    /// Of a sine, the number of the cosine of the same argument and vice versa, if there is one.
    others: Vec<Option<u32>>,
}

impl<'a> Factors<'a> {
    fn number(&mut self, factor: Cow<'a, Expr>) -> u32 {
        if let Some(number) = self.numbers.get(&factor) {
            return *number;
        }
        let number = self.all.len() as u32;
        let other = sine_or_cosine(&factor)
            .and_then(|(function, x)| self.numbers.get(&other_of(function, x)).copied());
        if let Some(other) = other {
            self.others[other as usize] = Some(number);
        }
        self.others.push(other);
        self.all.push(factor.clone());
        self.numbers.insert(factor, number);
        number
    }

    fn term(&mut self, expr: &'a Expr) -> Term {
        let mut term = Term { coefficient: BigRational::one(), factors: Vec::new() };
        let factors = match expr {
            Expr::Product(factors) => factors,
            other => std::slice::from_ref(other),
        };
        for factor in factors {
            match factor {
                Expr::Number(value) => term.coefficient *= value,
                Expr::Power(base, exponent) if sine_or_cosine(base).is_some() => {
                    let count = small_count(exponent);
                    let factor = if count.is_some() { base } else { factor };
                    let number = self.number(Cow::Borrowed(factor));
                    term.factors.extend(std::iter::repeat_n(number, count.unwrap_or(1)));
                }
                other => term.factors.push(self.number(Cow::Borrowed(other))),
            }
        }
        term.factors.sort_unstable();
        term
    }

    fn expr(&self, term: &Term) -> Expr {
        let mut factors = vec![Expr::Number(term.coefficient.clone())];
        factors.extend(term.factors.iter().map(|number| self.of(*number).clone()));
        Expr::Product(factors)
    }

    fn of(&self, number: u32) -> &Expr {
        &self.all[number as usize]
    }

    /// Returns the term that a rule joins with the one at `at`, and the result.
    fn partner(
        &mut self,
        term: &Term,
        terms: &[Option<Term>],
        places: &FxHashMap<Vec<u32>, usize>,
        at: usize,
    ) -> Option<(usize, Term)> {
        let factors = &term.factors;
        let mut trigonometric: Vec<usize> =
            (0..factors.len()).filter(|i| sine_or_cosine(self.of(factors[*i])).is_some()).collect();
        if trigonometric.len() > MOST_FACTORS {
            return None;
        }
        // The first pair found must not depend on the order of terms.
        trigonometric.sort_by(|i, j| self.of(factors[*i]).cmp(self.of(factors[*j])));
        let mut others = Vec::with_capacity(factors.len());
        for (position, i) in trigonometric.iter().enumerate() {
            let Some(of_first) = self.others[factors[*i] as usize] else { continue };
            for j in &trigonometric[position + 1..] {
                let Some(of_second) = self.others[factors[*j] as usize] else { continue };
                others.clear();
                others.extend(rest(factors, *i, *j).chain([of_first, of_second]));
                others.sort_unstable();
                let found = places.get(&others).copied().filter(|place| *place != at);
                let Some((place, Some(found))) = found.map(|place| (place, &terms[place])) else {
                    continue;
                };
                let equal = found.coefficient == term.coefficient;
                let opposite = found.coefficient == -term.coefficient.clone();
                let first = sine_or_cosine(self.of(factors[*i]))?;
                let second = sine_or_cosine(self.of(factors[*j]))?;
                if let Some((sign, joined)) = joined(first, second, equal, opposite) {
                    let mut result: Vec<u32> = rest(factors, *i, *j).collect();
                    result.extend(joined.map(|factor| self.number(Cow::Owned(factor))));
                    result.sort_unstable();
                    let sign = BigRational::from_integer(sign.into());
                    let coefficient = &term.coefficient * sign;
                    return Some((place, Term { coefficient, factors: result }));
                }
            }
        }
        None
    }
}

/// Iterates over the factors without two of them.
fn rest(factors: &[u32], i: usize, j: usize) -> impl Iterator<Item = u32> + '_ {
    let others = factors.iter().enumerate().filter(move |(k, _)| *k != i && *k != j);
    others.map(|(_, factor)| *factor)
}

/// Returns the number of sines and cosines among the factors of a term, squares counted twice.
fn sines_and_cosines(term: &Expr) -> usize {
    let of = |factor: &Expr| match factor {
        Expr::Power(base, exponent) if sine_or_cosine(base).is_some() => {
            small_count(exponent).unwrap_or(0)
        }
        factor => usize::from(sine_or_cosine(factor).is_some()),
    };
    match term {
        Expr::Product(factors) => factors.iter().map(of).sum(),
        other => of(other),
    }
}

/// Returns the result of `f(x) g(y)` plus or minus its partner: a sign and a factor.
fn joined(
    (first, x): (Function, &Expr),
    (second, y): (Function, &Expr),
    equal: bool,
    opposite: bool,
) -> Option<(i64, Option<Expr>)> {
    let call = |function, argument| Some(Expr::Call(function, vec![argument]));
    match (first, second) {
        _ if x == y && first == second => equal.then_some((1, None)),
        _ if x == y => None,
        // sin x sin y + cos x cos y, or its negative.
        (Function::Sin, Function::Sin) | (Function::Cos, Function::Cos) if equal => {
            Some((1, call(Function::Cos, difference(x, y))))
        }
        (Function::Sin, Function::Sin) if opposite => Some((-1, call(Function::Cos, sum(x, y)))),
        (Function::Cos, Function::Cos) if opposite => Some((1, call(Function::Cos, sum(x, y)))),
        // sin x cos y + cos x sin y, and so on.
        (Function::Sin | Function::Cos, _) if equal => Some((1, call(Function::Sin, sum(x, y)))),
        (Function::Sin, _) if opposite => Some((1, call(Function::Sin, difference(x, y)))),
        (Function::Cos, _) if opposite => Some((1, call(Function::Sin, difference(y, x)))),
        _ => None,
    }
}

fn sum(x: &Expr, y: &Expr) -> Expr {
    Expr::Sum(vec![x.clone(), y.clone()])
}

fn difference(x: &Expr, y: &Expr) -> Expr {
    let minus_one = Expr::Number(-BigRational::one());
    Expr::Sum(vec![x.clone(), Expr::Product(vec![minus_one, y.clone()])])
}

fn sine_or_cosine(factor: &Expr) -> Option<(Function, &Expr)> {
    match factor {
        Expr::Call(function @ (Function::Sin | Function::Cos), arguments) => {
            Some((*function, &arguments[0]))
        }
        _ => None,
    }
}

/// Returns the cosine for a sine and vice versa.
fn other_of(function: Function, argument: &Expr) -> Expr {
    let other = if function == Function::Sin { Function::Cos } else { Function::Sin };
    Expr::Call(other, vec![argument.clone()])
}

/// Returns a whole exponent from 2 to 8; larger ones do not occur in practice.
fn small_count(exponent: &Expr) -> Option<usize> {
    (2..=8_usize).find(|count| {
        matches!(exponent, Expr::Number(value) if *value == BigRational::from_integer((*count).into()))
    })
}

//! Pythagoras and the addition theorems on sums of products:
//!
//! ```text
//! c sin^2 x + c cos^2 x             = c
//! c cos x cos y + c sin x sin y     = c cos(x - y)      with -: cos(x + y)
//! c sin x cos y - c cos x sin y     = c sin(x - y)      with +: sin(x + y)
//! ```
//!
//! Every rule removes one term from a sum, so repeated application ends.

use num_rational::BigRational;
use num_traits::One;
use rustc_hash::FxHashMap;

use crate::expr::{Expr, Function};

/// Maximum number of sines and cosines in a term for which partners are searched, because the pairs
/// are many.
const MOST_FACTORS: usize = 16;

/// Applies the rules everywhere, as often as possible.
#[must_use]
pub fn combine(expr: &Expr) -> Expr {
    let all = |parts: &[Expr]| parts.iter().map(combine).collect::<Vec<_>>();
    match expr {
        Expr::Number(_) | Expr::Symbol(_) | Expr::Shared(_) => expr.clone(),
        Expr::Sum(terms) => combine_sum(all(terms)),
        Expr::Product(factors) => Expr::Product(all(factors)),
        Expr::Power(base, exponent) => {
            Expr::Power(Box::new(combine(base)), Box::new(combine(exponent)))
        }
        Expr::Call(function, arguments) => Expr::Call(*function, all(arguments)),
    }
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

/// A term as a coefficient and sorted factors; powers of sine and cosine are repeated factors.
struct Term {
    coefficient: BigRational,
    factors: Vec<Expr>,
}

fn combine_sum(terms: Vec<Expr>) -> Expr {
    let mut terms: Vec<Option<Term>> = terms.into_iter().map(|t| Some(Term::new(t))).collect();
    let mut places: FxHashMap<Vec<Expr>, usize> = FxHashMap::default();
    for (index, term) in terms.iter().flatten().enumerate() {
        places.insert(term.factors.clone(), index);
    }
    let mut at = 0;
    while at < terms.len() {
        let merged = terms[at].as_ref().and_then(|term| partner(term, &terms, &places, at));
        if let Some((other, merged)) = merged {
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
    let terms: Vec<Expr> = terms.into_iter().flatten().map(Term::into_expr).collect();
    Expr::Sum(terms)
}

/// Returns the term that a rule joins with the one at `at`, and the result.
fn partner(
    term: &Term,
    terms: &[Option<Term>],
    places: &FxHashMap<Vec<Expr>, usize>,
    at: usize,
) -> Option<(usize, Term)> {
    let trigonometric: Vec<usize> =
        (0..term.factors.len()).filter(|i| sine_or_cosine(&term.factors[*i]).is_some()).collect();
    if trigonometric.len() > MOST_FACTORS {
        return None;
    }
    for (position, i) in trigonometric.iter().enumerate() {
        for j in &trigonometric[position + 1..] {
            let (first, x) = sine_or_cosine(&term.factors[*i])?;
            let (second, y) = sine_or_cosine(&term.factors[*j])?;
            let rest: Vec<Expr> = (0..term.factors.len())
                .filter(|k| k != i && k != j)
                .map(|k| term.factors[k].clone())
                .collect();
            let with = |more: [Expr; 2]| {
                let mut factors = rest.clone();
                factors.extend(more);
                factors.sort();
                factors
            };
            let other = with([other_of(first, x), other_of(second, y)]);
            let found = places.get(&other).copied().filter(|place| *place != at);
            let Some((place, Some(found))) = found.map(|place| (place, &terms[place])) else {
                continue;
            };
            let equal = found.coefficient == term.coefficient;
            let opposite = found.coefficient == -term.coefficient.clone();
            if let Some((sign, joined)) = joined((first, x), (second, y), equal, opposite) {
                let mut factors = rest.clone();
                factors.extend(joined);
                factors.sort();
                let sign = BigRational::from_integer(sign.into());
                let coefficient = &term.coefficient * sign;
                return Some((place, Term { coefficient, factors }));
            }
        }
    }
    None
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

impl Term {
    fn new(expr: Expr) -> Self {
        let mut term = Term { coefficient: BigRational::one(), factors: Vec::new() };
        match expr {
            Expr::Product(factors) => factors.into_iter().for_each(|f| term.take(f)),
            other => term.take(other),
        }
        term.factors.sort();
        term
    }

    fn take(&mut self, factor: Expr) {
        match factor {
            Expr::Number(value) => self.coefficient *= value,
            Expr::Power(base, exponent) if sine_or_cosine(&base).is_some() => {
                match small_count(&exponent) {
                    Some(count) => self.factors.extend(std::iter::repeat_n(*base, count)),
                    None => self.factors.push(Expr::Power(base, exponent)),
                }
            }
            other => self.factors.push(other),
        }
    }

    fn into_expr(self) -> Expr {
        let mut factors = vec![Expr::Number(self.coefficient)];
        factors.extend(self.factors);
        Expr::Product(factors)
    }
}

/// Returns a whole exponent from 2 to 8; larger ones do not occur in practice.
fn small_count(exponent: &Expr) -> Option<usize> {
    (2..=8_usize).find(|count| {
        matches!(exponent, Expr::Number(value) if *value == BigRational::from_integer((*count).into()))
    })
}

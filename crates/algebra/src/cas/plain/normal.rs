//! Normal forms.
//!
//! - A sum is flat, has no two terms that differ by a number only, and is sorted.
//! - A product is flat, its number is before its other factors, each base occurs once, and the
//!   bases are sorted. A number times a sum is a sum. Beside other factors, and in whole powers,
//!   sums have coefficients without a common factor, the first positive, so that a - b and
//!   2 b - 2 a are one base.
//! - An offset is the sum of a symbol and a number, such as t - 30. Its symbol has no coefficient,
//!   and a number before it is kept separate: 100 (t - 30) is exact near 30, and 100 t - 3000 is
//!   not. Signs and powers of two are multiplied in, because that is exact.
//! - Whole powers of products and of powers are products and powers. A power of half a whole number
//!   is a power of a square root, because (x^2)^(1/2) is not x.
//!
//! Two expressions with the same normal form are equal; equal expressions may have different normal
//! forms.

use num_bigint::BigInt;
use num_integer::Integer as _;
use num_rational::BigRational;
use num_traits::{One as _, Pow as _, Signed as _, ToPrimitive as _, Zero as _};
use rustc_hash::FxHashMap;

use crate::expr::{Expr, Function};

/// Maximum number of bits of evaluated powers of numbers.
const MOST_BITS: u64 = 1 << 16;

/// Returns the normal form of an expression; sets `undefined` if it divides by zero or takes the
/// logarithm of zero.
pub(in crate::cas) fn normal(expr: &Expr, undefined: &mut bool) -> Expr {
    let mut all = |parts: &[Expr]| -> Vec<Expr> {
        parts.iter().map(|part| normal(part, undefined)).collect()
    };
    match expr {
        Expr::Number(_) | Expr::Symbol(_) | Expr::Shared(_) => expr.clone(),
        Expr::Sum(terms) => sum(all(terms)),
        Expr::Product(factors) => product(all(factors)),
        Expr::Power(base, exponent) => {
            let (base, exponent) = (normal(base, undefined), normal(exponent, undefined));
            let is_positive = matches!(&exponent, Expr::Number(value) if value.is_positive());
            if base.is_zero() && !is_positive {
                *undefined = true;
                return Expr::integer(0);
            }
            power(base, exponent)
        }
        Expr::Call(function, arguments) => {
            let arguments = all(arguments);
            if *function == Function::Ln && arguments[0].is_zero() {
                *undefined = true;
                return Expr::integer(0);
            }
            call(*function, arguments)
        }
    }
}

/// Returns a function of arguments in normal form.
pub(in crate::cas) fn call(function: Function, mut arguments: Vec<Expr>) -> Expr {
    let argument = &arguments[0];
    let at_zero = argument.is_zero();
    let at_one = matches!(argument, Expr::Number(value) if value.is_one());
    match function {
        Function::SelectLess if arguments[2] == arguments[3] => arguments.swap_remove(2),
        Function::Sqrt
        | Function::Abs
        | Function::Floor
        | Function::Sin
        | Function::Tan
        | Function::Asin
        | Function::Atan
        | Function::Sinh
        | Function::Tanh
            if at_zero =>
        {
            Expr::integer(0)
        }
        Function::Exp | Function::Cos | Function::Cosh if at_zero => Expr::integer(1),
        Function::Ln if at_one => Expr::integer(0),
        Function::Sqrt if at_one => Expr::integer(1),
        _ => Expr::Call(function, arguments),
    }
}

/// Splits a term into its number and the rest.
fn split(term: Expr) -> (BigRational, Expr) {
    match term {
        Expr::Product(mut factors) if matches!(factors[0], Expr::Number(_)) => {
            let Expr::Number(number) = factors.remove(0) else { unreachable!("it was a number") };
            (number, single(factors, Expr::Product))
        }
        other => (BigRational::one(), other),
    }
}

/// Multiplies an expression by a number. The expression is no number, no sum except an offset, and
/// has no number yet.
fn scaled(number: BigRational, rest: Expr) -> Expr {
    if number.is_one() {
        return rest;
    }
    match rest {
        Expr::Product(mut factors) => {
            factors.insert(0, Expr::Number(number));
            Expr::Product(factors)
        }
        other => Expr::Product(vec![Expr::Number(number), other]),
    }
}

fn single(mut parts: Vec<Expr>, many: impl Fn(Vec<Expr>) -> Expr) -> Expr {
    if parts.len() == 1 { parts.swap_remove(0) } else { many(parts) }
}

/// Returns the sum of terms in normal form.
pub(in crate::cas) fn sum(terms: impl IntoIterator<Item = Expr>) -> Expr {
    let mut all = Terms::default();
    terms.into_iter().for_each(|term| all.take(term));
    all.into_expr()
}

#[derive(Default)]
struct Terms {
    number: BigRational,
    terms: FxHashMap<Expr, BigRational>,
}

impl Terms {
    fn take(&mut self, term: Expr) {
        match term {
            Expr::Sum(terms) => terms.into_iter().for_each(|term| self.take(term)),
            Expr::Number(value) => self.number += value,
            other => {
                let (number, rest) = split(other);
                *self.terms.entry(rest).or_default() += number;
            }
        }
    }

    fn into_expr(self) -> Expr {
        let left = self.terms.into_iter().filter(|(_, number)| !number.is_zero());
        let mut terms: Vec<Expr> = left
            .map(|(rest, number)| match rest {
                Expr::Sum(_) => product([Expr::Number(number), rest]),
                _ => scaled(number, rest),
            })
            .collect();
        if !self.number.is_zero() || terms.is_empty() {
            terms.push(Expr::Number(self.number));
        }
        if terms.len() > 1 && terms.iter().any(|term| matches!(term, Expr::Sum(_))) {
            return sum(terms);
        }
        terms.sort_unstable();
        single(terms, Expr::Sum)
    }
}

/// Returns the product of factors in normal form.
pub(in crate::cas) fn product(factors: impl IntoIterator<Item = Expr>) -> Expr {
    let mut all =
        Factors { number: BigRational::one(), exponents: FxHashMap::default(), powers: Vec::new() };
    factors.into_iter().for_each(|factor| all.take(factor));
    all.into_expr()
}

struct Factors {
    number: BigRational,
    /// Index of the power of each base.
    exponents: FxHashMap<Expr, usize>,
    powers: Vec<(Expr, Expr)>,
}

impl Factors {
    fn take(&mut self, factor: Expr) {
        match factor {
            Expr::Product(factors) => factors.into_iter().for_each(|factor| self.take(factor)),
            Expr::Number(value) => self.number *= value,
            Expr::Power(base, exponent) => self.multiply(*base, *exponent),
            other => self.multiply(other, Expr::integer(1)),
        }
    }

    fn multiply(&mut self, mut base: Expr, exponent: Expr) {
        if let (Expr::Sum(terms), Expr::Number(value)) = (&mut base, &exponent)
            && let Some(content) = content(terms)
            && let Some(number) = worked_out(&content, value)
        {
            divide(terms, &content);
            self.number *= number;
        }
        if let Some(place) = self.exponents.get(&base) {
            let known = &mut self.powers[*place].1;
            let before = std::mem::replace(known, Expr::integer(0));
            *known = sum([before, exponent]);
        } else {
            self.exponents.insert(base.clone(), self.powers.len());
            self.powers.push((base, exponent));
        }
    }

    fn into_expr(self) -> Expr {
        let mut number = self.number;
        if number.is_zero() {
            return Expr::integer(0);
        }
        let mut factors = Vec::new();
        for (base, exponent) in self.powers {
            // A power may have become an integer power, and therefore a product or a number.
            match power(base, exponent) {
                Expr::Number(value) => number *= value,
                Expr::Product(parts) => {
                    let rest = Expr::Product(factors);
                    return product([Expr::Number(number), rest, Expr::Product(parts)]);
                }
                other => factors.push(other),
            }
        }
        factors.sort_unstable();
        match &mut factors[..] {
            [] => Expr::Number(number),
            [Expr::Sum(terms)]
                if !number.is_one() && (offset(terms).is_none() || is_exact(&number)) =>
            {
                let terms = std::mem::take(terms);
                sum(terms.into_iter().map(|term| product([Expr::Number(number.clone()), term])))
            }
            _ => scaled(number, single(factors, Expr::Product)),
        }
    }
}

/// Returns a power of base and exponent in normal form. A power of zero with an exponent that is
/// not positive is left as it is.
pub(super) fn power(base: Expr, exponent: Expr) -> Expr {
    let Expr::Number(value) = &exponent else {
        let is_one = matches!(&base, Expr::Number(value) if value.is_one());
        return if is_one { base } else { Expr::Power(Box::new(base), Box::new(exponent)) };
    };
    if value.is_one() {
        return base;
    }
    if value.is_zero() && !base.is_zero() {
        return Expr::integer(1);
    }
    if *value.denom() == 2.into() {
        let root = call(Function::Sqrt, vec![base]);
        return power(root, Expr::Number(BigRational::from_integer(value.numer().clone())));
    }
    match base {
        Expr::Number(number) => match worked_out(&number, value) {
            Some(number) => Expr::Number(number),
            None => Expr::Power(Box::new(Expr::Number(number)), Box::new(exponent)),
        },
        Expr::Power(base, inner) if value.is_integer() => power(*base, product([*inner, exponent])),
        Expr::Product(factors) if value.is_integer() => {
            product(factors.into_iter().map(|factor| power(factor, exponent.clone())))
        }
        Expr::Sum(mut terms) => {
            let content = content(&terms);
            let outside = content.as_ref().and_then(|content| worked_out(content, value));
            let (Some(content), Some(outside)) = (content, outside) else {
                return Expr::Power(Box::new(Expr::Sum(terms)), Box::new(exponent));
            };
            divide(&mut terms, &content);
            scaled(outside, Expr::Power(Box::new(Expr::Sum(terms)), Box::new(exponent)))
        }
        base => Expr::Power(Box::new(base), Box::new(exponent)),
    }
}

/// Returns whether multiplication of floating-point numbers by a number is exact.
fn is_exact(number: &BigRational) -> bool {
    let is_power = |part: &BigInt| part.magnitude().count_ones() == 1;
    is_power(number.numer()) && is_power(number.denom())
}

/// Returns the coefficient of the symbol, if the sum consists of a symbol and a number.
fn offset(terms: &[Expr]) -> Option<BigRational> {
    let [a, b] = terms else { return None };
    let ((a, first), (b, second)) = (coefficient(a), coefficient(b));
    match (a, b) {
        ([Expr::Symbol(_)], []) => Some(first),
        ([], [Expr::Symbol(_)]) => Some(second),
        _ => None,
    }
}

/// Returns the common factor of the coefficients of a sum. Its sign is that of the first term in
/// the order without coefficients, or of the symbol of an offset. Returns `None` if it is 1.
fn content(terms: &[Expr]) -> Option<BigRational> {
    if let Some(number) = offset(terms) {
        return (!number.is_one()).then_some(number);
    }
    let parts = || terms.iter().map(coefficient);
    let (_, leading) = parts().min_by(|(a, _), (b, _)| a.cmp(b))?;
    let common = parts().map(|(_, number)| number).fold(BigRational::zero(), |common, number| {
        if common.is_zero() {
            return number.abs();
        }
        let numerator = common.numer().gcd(number.numer());
        BigRational::new(numerator, common.denom().lcm(number.denom()))
    });
    let content = if leading.is_negative() { -common } else { common };
    (!content.is_one()).then_some(content)
}

/// Splits a term into its other factors and its number.
fn coefficient(term: &Expr) -> (&[Expr], BigRational) {
    match term {
        Expr::Number(value) => (&[], value.clone()),
        Expr::Product(factors) => match &factors[0] {
            Expr::Number(value) => (&factors[1..], value.clone()),
            _ => (factors, BigRational::one()),
        },
        _ => (std::slice::from_ref(term), BigRational::one()),
    }
}

/// Divides a sum by a number, term by term.
fn divide(terms: &mut [Expr], by: &BigRational) {
    for term in terms.iter_mut() {
        let (number, rest) = split(std::mem::replace(term, Expr::integer(0)));
        *term = match rest {
            Expr::Number(value) => Expr::Number(number * value / by),
            rest => scaled(number / by, rest),
        };
    }
    terms.sort_unstable();
}

/// Returns a whole power of a number, if the exponent is whole and the result not too long.
fn worked_out(number: &BigRational, exponent: &BigRational) -> Option<BigRational> {
    if number.is_one() {
        return Some(number.clone());
    }
    let exponent = exponent.is_integer().then(|| exponent.numer().to_i32()).flatten()?;
    let bits = number.numer().bits().max(number.denom().bits());
    let is_short = bits * u64::from(exponent.unsigned_abs()) <= MOST_BITS;
    (is_short && (exponent > 0 || !number.is_zero())).then(|| number.clone().pow(exponent))
}

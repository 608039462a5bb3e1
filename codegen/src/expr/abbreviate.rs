//! Helpers of the spec found again inside derived expressions.
//!
//! Derivation multiplies everything out of its names. Here the names come back:
//! where a sum holds the terms of a helper, or a product the factors of one (to
//! some power), the helper stands for them. That is what makes emitted code and
//! printed equations read like the spec, and it shares the work.
//!
//! The result holds [`Symbol::Helper`], which the computer algebra never sees.

use num_rational::BigRational;
use num_traits::{One, Pow, Signed, ToPrimitive, Zero};

use crate::expr::{Expr, HelperId, Symbol};

/// Helpers by what they stand for, smallest first; a larger one is written with
/// the smaller ones.
#[derive(Debug, Clone, Default)]
pub struct Abbreviations {
    entries: Vec<(HelperId, Expr)>,
    /// Entries that are sums: their terms, and these with the other sign.
    sums: Vec<(HelperId, [Vec<Expr>; 2])>,
    /// Entries that are products of several bases.
    products: Vec<(HelperId, Powers)>,
}

impl Abbreviations {
    /// From the helpers' full expressions, in the order of their ids.
    #[must_use]
    pub fn new(helpers: &[Expr]) -> Self {
        let mut order: Vec<usize> = (0..helpers.len()).collect();
        order.sort_by_key(|index| size(&helpers[*index]));
        let mut abbreviations = Abbreviations::default();
        for index in order {
            let definition = abbreviations.apply(&helpers[index]);
            if !mentions_acceleration(&definition) {
                abbreviations.add(HelperId(index as u32), definition);
            }
        }
        abbreviations
    }

    fn add(&mut self, id: HelperId, definition: Expr) {
        match &definition {
            Expr::Sum(parts) => {
                let terms = [1, -1].map(|sign| parts.iter().map(|p| scaled(p, sign)).collect());
                self.sums.push((id, terms));
            }
            Expr::Product(parts) => {
                let powers = Powers::of(parts.clone());
                if powers.bases.len() > 1 {
                    self.products.push((id, powers));
                }
            }
            _ => {}
        }
        self.entries.push((id, definition));
    }

    /// What each helper stands for, written with those before it.
    #[must_use]
    pub fn entries(&self) -> &[(HelperId, Expr)] {
        &self.entries
    }

    /// The same value with helpers in place of what they stand for.
    #[must_use]
    pub fn apply(&self, expr: &Expr) -> Expr {
        let all = |parts: &[Expr]| parts.iter().map(|part| self.apply(part)).collect::<Vec<_>>();
        match expr {
            Expr::Number(_) | Expr::Symbol(_) => expr.clone(),
            Expr::Sum(terms) => self.sum(all(terms)),
            Expr::Product(factors) => self.product(all(factors)),
            Expr::Power(base, exponent) => {
                let power = Expr::Power(Box::new(self.apply(base)), Box::new(self.apply(exponent)));
                self.whole(power)
            }
            Expr::Call(function, arguments) => self.whole(Expr::Call(*function, all(arguments))),
        }
    }

    /// An expression that is a helper as it stands.
    fn whole(&self, expr: Expr) -> Expr {
        match self.entries.iter().find(|(_, definition)| *definition == expr) {
            Some((id, _)) => helper(*id),
            None => expr,
        }
    }

    fn sum(&self, mut terms: Vec<Expr>) -> Expr {
        for (id, definitions) in &self.sums {
            for (wanted, sign) in definitions.iter().zip([1, -1]) {
                if wanted.len() <= terms.len() && wanted.iter().all(|part| terms.contains(part)) {
                    terms.retain(|term| !wanted.contains(term));
                    terms.push(scaled(&helper(*id), sign));
                }
            }
        }
        terms.sort();
        single(terms, Expr::Sum)
    }

    fn product(&self, factors: Vec<Expr>) -> Expr {
        let mut powers = Powers::of(factors);
        for (id, part) in &self.products {
            powers.replace(part, *id);
        }
        powers.into_expr()
    }
}

fn helper(id: HelperId) -> Expr {
    Expr::Symbol(Symbol::Helper(id))
}

fn number(n: i64) -> BigRational {
    BigRational::from_integer(n.into())
}

/// A product as coefficient and bases with exponents.
#[derive(Debug, Clone)]
struct Powers {
    coefficient: BigRational,
    bases: Vec<(Expr, BigRational)>,
}

impl Powers {
    fn of(factors: Vec<Expr>) -> Self {
        let mut powers = Powers { coefficient: BigRational::one(), bases: Vec::new() };
        for factor in factors {
            match factor {
                Expr::Number(value) => powers.coefficient *= value,
                Expr::Power(base, exponent) => match *exponent {
                    Expr::Number(value) => powers.multiply(*base, &value),
                    exponent => {
                        powers.multiply(Expr::Power(base, Box::new(exponent)), &number(1));
                    }
                },
                // An abbreviated factor may be a product itself.
                Expr::Product(inner) => {
                    let inner = Powers::of(inner);
                    powers.coefficient *= inner.coefficient;
                    inner.bases.into_iter().for_each(|(base, n)| powers.multiply(base, &n));
                }
                factor => powers.multiply(factor, &number(1)),
            }
        }
        powers
    }

    fn multiply(&mut self, base: Expr, exponent: &BigRational) {
        match self.bases.iter_mut().find(|(known, _)| *known == base) {
            Some((_, known)) => *known += exponent,
            None => self.bases.push((base, exponent.clone())),
        }
    }

    /// Takes out the largest whole power of `part`, if there is one.
    fn replace(&mut self, part: &Powers, id: HelperId) {
        let Some(count) = self.whole_powers_of(part) else { return };
        let Some(scale) = count.to_i32() else { return };
        for (base, exponent) in &part.bases {
            self.multiply(base.clone(), &(-exponent.clone() * &count));
        }
        self.coefficient /= Pow::pow(part.coefficient.clone(), scale);
        self.multiply(helper(id), &count);
        self.bases.retain(|(_, exponent)| !exponent.is_zero());
    }

    /// The whole number n farthest from zero such that part^n is a factor.
    fn whole_powers_of(&self, part: &Powers) -> Option<BigRational> {
        let mut count: Option<BigRational> = None;
        for (base, exponent) in &part.bases {
            let (_, available) = self.bases.iter().find(|(known, _)| known == base)?;
            let possible = (available / exponent).trunc();
            let agrees = count.as_ref().is_none_or(|n| n.is_positive() == possible.is_positive());
            if possible.is_zero() || !agrees {
                return None;
            }
            count = match count {
                Some(known) if known.abs() <= possible.abs() => Some(known),
                _ => Some(possible),
            };
        }
        count
    }

    fn into_expr(self) -> Expr {
        let mut factors = Vec::new();
        if !self.coefficient.is_one() || self.bases.is_empty() {
            factors.push(Expr::Number(self.coefficient));
        }
        for (base, exponent) in self.bases {
            factors.push(if exponent.is_one() {
                base
            } else {
                Expr::Power(Box::new(base), Box::new(Expr::Number(exponent)))
            });
        }
        factors.sort();
        single(factors, Expr::Product)
    }
}

/// A term times 1 or -1, in normal order.
fn scaled(term: &Expr, sign: i64) -> Expr {
    if sign == 1 {
        return term.clone();
    }
    let mut powers = Powers::of(vec![term.clone()]);
    powers.coefficient = -powers.coefficient;
    powers.into_expr()
}

fn single(mut parts: Vec<Expr>, many: impl Fn(Vec<Expr>) -> Expr) -> Expr {
    if parts.len() == 1 { parts.swap_remove(0) } else { many(parts) }
}

fn size(expr: &Expr) -> usize {
    match expr {
        Expr::Number(_) | Expr::Symbol(_) => 1,
        Expr::Sum(parts) | Expr::Product(parts) | Expr::Call(_, parts) => {
            1 + parts.iter().map(size).sum::<usize>()
        }
        Expr::Power(base, exponent) => 1 + size(base) + size(exponent),
    }
}

fn mentions_acceleration(expr: &Expr) -> bool {
    match expr {
        Expr::Number(_) => false,
        Expr::Symbol(symbol) => matches!(symbol, Symbol::Acceleration(_) | Symbol::Multiplier(_)),
        Expr::Sum(parts) | Expr::Product(parts) | Expr::Call(_, parts) => {
            parts.iter().any(mentions_acceleration)
        }
        Expr::Power(base, exponent) => {
            mentions_acceleration(base) || mentions_acceleration(exponent)
        }
    }
}

//! Recognition of the spec's helpers in derived expressions.
//!
//! Derivation replaces helpers by their expressions. Here they are restored: if a sum contains the
//! terms of a helper, or a product its factors (to some power), the helper replaces them. Emitted
//! code and printed equations therefore read like the spec, and the helper is computed once.
//!
//! The result contains [`Symbol::Helper`], which the computer algebra never sees.

use std::collections::BTreeSet;

use num_rational::BigRational;
use num_traits::{One, Pow, Signed, ToPrimitive, Zero};
use rustc_hash::FxHashMap;

use crate::expr::{Expr, HelperId, Symbol};

/// Helpers by their definitions, smallest first; the definitions of larger ones contain smaller
/// ones.
#[derive(Debug, Clone, Default)]
pub struct Abbreviations {
    entries: Vec<(HelperId, Expr)>,
    /// First entry of each definition.
    by_definition: FxHashMap<Expr, HelperId>,
    /// Entries that are sums: their terms, and the terms with opposite sign.
    sums: Vec<(HelperId, [Vec<Expr>; 2])>,
    /// Sums by the first of their terms.
    by_term: Places,
    /// Entries that are products of several bases.
    products: Vec<(HelperId, Powers)>,
    /// Products by the first of their bases.
    by_base: Places,
}

/// Indices of entries, by the expression that they begin with.
type Places = FxHashMap<Expr, Vec<usize>>;

/// Entries that may be found in a sum or product, in order: only those that begin with one of its
/// parts.
struct Candidates<'a> {
    places: &'a Places,
    left: BTreeSet<usize>,
}

impl<'a> Candidates<'a> {
    fn new<'b>(places: &'a Places, parts: impl Iterator<Item = &'b Expr>) -> Self {
        let left = parts.filter_map(|part| places.get(part)).flatten().copied().collect();
        Candidates { places, left }
    }

    fn next(&mut self) -> Option<usize> {
        self.left.pop_first()
    }

    /// Adds the entries of a new part that come after `at`; earlier ones were tried already.
    fn add(&mut self, part: &Expr, at: usize) {
        let more = self.places.get(part).into_iter().flatten();
        self.left.extend(more.copied().filter(|place| *place > at));
    }
}

impl Abbreviations {
    /// Builds the table from the helpers' full expressions, in the order of their ids.
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
                let terms: [Vec<Expr>; 2] =
                    [1, -1].map(|sign| parts.iter().map(|p| scaled(p, sign)).collect());
                for first in terms.iter().filter_map(|terms| terms.first()) {
                    let places = self.by_term.entry(first.clone()).or_default();
                    places.push(self.sums.len());
                }
                self.sums.push((id, terms));
            }
            Expr::Product(parts) => {
                let powers = Powers::of(parts.clone());
                if let [(first, _), _, ..] = &powers.bases[..] {
                    let places = self.by_base.entry(first.clone()).or_default();
                    places.push(self.products.len());
                    self.products.push((id, powers));
                }
            }
            _ => {}
        }
        self.by_definition.entry(definition.clone()).or_insert(id);
        self.entries.push((id, definition));
    }

    /// Returns the definition of each helper, written with those before it.
    #[must_use]
    pub fn entries(&self) -> &[(HelperId, Expr)] {
        &self.entries
    }

    /// Returns an equal expression with helpers in place of their definitions.
    #[must_use]
    pub fn apply(&self, expr: &Expr) -> Expr {
        let all = |parts: &[Expr]| parts.iter().map(|part| self.apply(part)).collect::<Vec<_>>();
        match expr {
            Expr::Number(_) | Expr::Symbol(_) | Expr::Shared(_) => expr.clone(),
            Expr::Sum(terms) => self.sum(all(terms)),
            Expr::Product(factors) => self.product(all(factors)),
            Expr::Power(base, exponent) => {
                let power = Expr::Power(Box::new(self.apply(base)), Box::new(self.apply(exponent)));
                self.whole(power)
            }
            Expr::Call(function, arguments) => self.whole(Expr::Call(*function, all(arguments))),
        }
    }

    /// Returns the helper whose definition is the whole expression, or the expression.
    fn whole(&self, expr: Expr) -> Expr {
        self.by_definition.get(&expr).map_or(expr, |id| helper(*id))
    }

    fn sum(&self, terms: Vec<Expr>) -> Expr {
        let mut candidates = Candidates::new(&self.by_term, terms.iter());
        let mut counts: FxHashMap<Expr, usize> = FxHashMap::default();
        for term in terms {
            *counts.entry(term).or_default() += 1;
        }
        while let Some(at) = candidates.next() {
            let (id, definitions) = &self.sums[at];
            for (wanted, sign) in definitions.iter().zip([1, -1]) {
                if wanted.iter().all(|part| counts.contains_key(part)) {
                    for part in wanted {
                        take_one(&mut counts, part);
                    }
                    let term = scaled(&helper(*id), sign);
                    candidates.add(&term, at);
                    *counts.entry(term).or_default() += 1;
                }
            }
        }
        let terms = counts.into_iter().flat_map(|(term, count)| std::iter::repeat_n(term, count));
        let mut terms: Vec<Expr> = terms.collect();
        terms.sort();
        single(terms, Expr::Sum)
    }

    fn product(&self, factors: Vec<Expr>) -> Expr {
        let mut powers = Powers::of(factors);
        let bases = powers.bases.iter().map(|(base, _)| base);
        let mut candidates = Candidates::new(&self.by_base, bases);
        while let Some(at) = candidates.next() {
            let (id, part) = &self.products[at];
            powers.replace(part, *id);
            candidates.add(&helper(*id), at);
        }
        powers.into_expr()
    }
}

fn take_one(counts: &mut FxHashMap<Expr, usize>, term: &Expr) {
    match counts.get_mut(term) {
        Some(count) if *count > 1 => *count -= 1,
        _ => drop(counts.remove(term)),
    }
}

fn helper(id: HelperId) -> Expr {
    Expr::Symbol(Symbol::Helper(id))
}

fn number(n: i64) -> BigRational {
    BigRational::from_integer(n.into())
}

/// A product as a coefficient and bases with exponents.
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

    /// Replaces the largest whole power of `part`, if there is one.
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

    /// Returns the whole number n farthest from zero such that part^n is a factor.
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

/// Returns a term times 1 or -1, in normal order.
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
        Expr::Number(_) | Expr::Symbol(_) | Expr::Shared(_) => 1,
        Expr::Sum(parts) | Expr::Product(parts) | Expr::Call(_, parts) => {
            1 + parts.iter().map(size).sum::<usize>()
        }
        Expr::Power(base, exponent) => 1 + size(base) + size(exponent),
    }
}

fn mentions_acceleration(expr: &Expr) -> bool {
    match expr {
        Expr::Number(_) => false,
        Expr::Symbol(_) | Expr::Shared(_) => expr.mentions(|symbol| {
            matches!(symbol, Symbol::Acceleration(_) | Symbol::Multiplier(_) | Symbol::Unloaded(_))
        }),
        Expr::Sum(parts) | Expr::Product(parts) | Expr::Call(_, parts) => {
            parts.iter().any(mentions_acceleration)
        }
        Expr::Power(base, exponent) => {
            mentions_acceleration(base) || mentions_acceleration(exponent)
        }
    }
}

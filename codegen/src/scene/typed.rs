//! Resolved expressions with their properties.

use machinist_algebra::expr::{Expr, Function, Symbol};
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One as _, Signed as _, ToPrimitive as _, Zero as _};

use crate::spec::dimension::{Angular, Dimension};
use crate::spec::measure::Factor;

/// Quantities that an expression depends on, besides parameters.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[expect(clippy::struct_excessive_bools, reason = "a set of five")]
pub struct Uses {
    pub time: bool,
    /// Coordinates and first-order states.
    pub position: bool,
    pub velocity: bool,
    pub acceleration: bool,
    /// Constraint forces.
    pub reaction: bool,
}

impl Uses {
    pub const PARAMETERS: Uses = Uses {
        time: false,
        position: false,
        velocity: false,
        acceleration: false,
        reaction: false,
    };
    pub const PLACE: Uses = Uses { time: true, position: true, ..Uses::PARAMETERS };
    pub const MOTION: Uses = Uses { velocity: true, ..Uses::PLACE };
    /// What guards and forces may depend on.
    pub const GUARD: Uses = Uses { reaction: true, ..Uses::MOTION };
    pub const ANYTHING: Uses = Uses { acceleration: true, ..Uses::GUARD };

    pub fn and(self, other: Uses) -> Uses {
        Uses {
            time: self.time || other.time,
            position: self.position || other.position,
            velocity: self.velocity || other.velocity,
            acceleration: self.acceleration || other.acceleration,
            reaction: self.reaction || other.reaction,
        }
    }

    /// Returns the first quantity in use that `allowed` does not contain.
    pub fn beyond(self, allowed: Uses) -> Option<&'static str> {
        [
            (self.acceleration && !allowed.acceleration, "an acceleration"),
            (self.reaction && !allowed.reaction, "the force of a constraint"),
            (self.velocity && !allowed.velocity, "a velocity"),
            (self.position && !allowed.position, "a coordinate or state"),
            (self.time && !allowed.time, "time"),
        ]
        .into_iter()
        .find_map(|(beyond, what)| beyond.then_some(what))
    }

    pub fn moves(self) -> bool {
        self.position || self.velocity || self.acceleration || self.reaction
    }
}

/// An expression, its dimension, and measures of its size.
#[derive(Debug, Clone)]
pub struct Typed {
    pub expr: Expr,
    /// `None` for a bare 0, which has any dimension.
    pub dimension: Option<Dimension>,
    pub angular: Angular,
    pub uses: Uses,
    /// Number of leaves of the tree.
    pub terms: usize,
    /// Depth of the tree.
    pub depth: usize,
    /// Bound on the bits of exact numbers that could result from it.
    pub bits: u64,
    /// Its value, if it is a number.
    pub value: Option<f64>,
}

impl Typed {
    /// Returns a leaf.
    pub fn leaf(expr: Expr, dimension: Dimension, angular: Angular, uses: Uses) -> Self {
        let dimension = Some(dimension);
        Typed { expr, dimension, angular, uses, terms: 1, depth: 0, bits: 1, value: None }
    }

    /// Returns an exact number; 0 without a unit has any dimension.
    pub fn number(number: &BigRational, unit: Option<crate::spec::dimension::Unit>) -> Self {
        let any = number.is_zero() && unit.is_none();
        let unit = unit.unwrap_or_default();
        Typed {
            dimension: (!any).then_some(unit.dimension),
            angular: Angular::of(unit, false),
            uses: Uses::default(),
            terms: 1,
            depth: 0,
            bits: bits(number),
            value: number.to_f64(),
            expr: Expr::Number(number.clone()),
        }
    }

    /// Returns the combined properties of `parts`; `expr` and the rest are still those of an
    /// empty expression.
    pub fn over(parts: &[&Typed]) -> Self {
        Typed {
            expr: integer(0),
            dimension: Some(Dimension::ONE),
            angular: Angular::default(),
            uses: parts.iter().fold(Uses::default(), |uses, part| uses.and(part.uses)),
            terms: parts.iter().map(|part| part.terms).sum(),
            depth: parts.iter().map(|part| part.depth).max().unwrap_or(0) + 1,
            bits: parts.iter().fold(0, |bits, part| bits.saturating_add(part.bits)),
            value: None,
        }
    }
}

/// Returns the number of bits of a number's numerator and denominator.
pub fn bits(number: &BigRational) -> u64 {
    number.numer().bits().saturating_add(number.denom().bits())
}

/// Returns an integer.
pub fn integer(value: i64) -> Expr {
    Expr::Number(BigRational::from_integer(BigInt::from(value)))
}

/// Returns the sum of terms, without zeros.
pub fn sum(terms: Vec<Expr>) -> Expr {
    let mut terms: Vec<Expr> = terms.into_iter().filter(|term| *term != integer(0)).collect();
    match terms.len() {
        0 => integer(0),
        1 => terms.swap_remove(0),
        _ => Expr::Sum(terms),
    }
}

/// Returns the product of factors, their numbers multiplied and put first.
pub fn product(factors: Vec<Expr>) -> Expr {
    let mut coefficient = BigRational::one();
    let mut rest = Vec::with_capacity(factors.len());
    for factor in factors {
        let factors = match factor {
            Expr::Product(factors) => factors,
            factor => vec![factor],
        };
        for factor in factors {
            match factor {
                Expr::Number(number) => coefficient *= number,
                factor => rest.push(factor),
            }
        }
    }
    if coefficient.is_zero() || rest.is_empty() {
        return Expr::Number(coefficient);
    }
    if !coefficient.is_one() {
        rest.insert(0, Expr::Number(coefficient));
    }
    if rest.len() == 1 { rest.swap_remove(0) } else { Expr::Product(rest) }
}

/// Returns the reciprocal of an expression that is not a bare 0.
pub fn reciprocal(of: Expr) -> Expr {
    let minus_one = BigRational::from_integer((-1).into());
    match of {
        Expr::Number(number) if !number.is_zero() => Expr::Number(number.recip()),
        Expr::Power(base, exponent) => match *exponent {
            Expr::Number(number) => power(*base, &-number),
            other => power(Expr::Power(base, Box::new(other)), &minus_one),
        },
        of => power(of, &minus_one),
    }
}

/// Returns a power whose exponent is a number.
pub fn power(base: Expr, exponent: &BigRational) -> Expr {
    if exponent.is_one() {
        return base;
    }
    Expr::Power(Box::new(base), Box::new(Expr::Number(exponent.clone())))
}

/// Converts a quantity from coherent units to units of which one is `factor` coherent ones.
pub fn in_units_of(of: Expr, factor: &Factor) -> Expr {
    if factor.is_one() {
        return of;
    }
    let per = Expr::Number(factor.ratio.recip());
    let pi = Expr::Symbol(Symbol::Pi);
    let pis = power(pi, &BigRational::from_integer((-factor.pis).into()));
    product(if factor.pis == 0 { vec![per, of] } else { vec![per, pis, of] })
}

/// Returns `then` where a < b, else `otherwise`.
pub fn select_less(a: Expr, b: Expr, then: Expr, otherwise: Expr) -> Expr {
    Expr::Call(Function::SelectLess, vec![a, b, then, otherwise])
}

/// Returns numerator and denominator of an exponent, if its absolute value is at most 64 and the
/// denominator is small enough.
pub fn exponent(of: &BigRational) -> Option<(i32, i32)> {
    let limit = BigRational::from_integer(64.into());
    if of.abs() > limit {
        return None;
    }
    Some((of.numer().to_i32()?, of.denom().to_i32()?))
}

//! Numbers of 31 digits, for runs of emitted code without visible rounding.
//!
//! A value is the unevaluated sum of two `f64` (T. J. Dekker, A floating-point technique for
//! extending the available precision, Numerische Mathematik 18, 1971). Arithmetic, roots,
//! exponentials and logarithms are those of the crate `qd`; functions that it lacks are here,
//! accurate to some units of the 30th digit.

use std::f64::consts::FRAC_PI_2;
use std::ops::{Add, Div, Mul, Neg, Sub};

use machinist_contract::taylor::TaylorSeries;
use machinist_contract::{Describe, Real, Simulator};
use machinist_scenes::find_carried;
use qd::Quad;

/// A real number of 31 digits.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DoubleDouble(Quad);

/// pi/2 as a sum of three `f64`.
const HALF_PI: [f64; 3] = [FRAC_PI_2, 6.123_233_995_736_766e-17, -1.497_384_904_859_169_7e-33];

/// Size below which the hyperbolic sine is a power series, since the difference of two exponentials
/// would cancel.
const SMALL: f64 = 0.5;

/// Size above which tanh is one to the last digit.
const SATURATED: f64 = 40.0;

/// Functions of a simulator that a run in 31 digits needs. Every simulator has them. Making `&dyn
/// Twin` of a simulator compiles only these in such numbers.
pub trait Twin: Describe {
    /// See [`Simulator::discontinuities`].
    fn discontinuities(&self, parameters: &[DoubleDouble], times: &mut [DoubleDouble]);
    /// See [`Simulator::taylor`].
    fn taylor(&self) -> Option<&dyn TaylorSeries<DoubleDouble>>;
}

impl<S: Simulator<DoubleDouble>> Twin for S {
    fn discontinuities(&self, parameters: &[DoubleDouble], times: &mut [DoubleDouble]) {
        Simulator::discontinuities(self, parameters, times);
    }
    fn taylor(&self) -> Option<&dyn TaylorSeries<DoubleDouble>> {
        Simulator::taylor(self)
    }
}

/// Returns the emitted scene of this name in these numbers, if it has Taylor series without events
/// and corners.
#[must_use]
pub fn precise(name: &str) -> Option<&'static dyn Twin> {
    find_carried!(name)
}

impl DoubleDouble {
    /// Returns the nearest `f64`.
    #[must_use]
    pub fn to_f64(self) -> f64 {
        self.0.0
    }

    /// Returns the sum `first + term_1 + ...` of a power series with `term_n = term_(n-1)
    /// square/((m + 1)(m + 2))`, where m counts up from `from` by two: sines and cosines, or
    /// hyperbolic ones for a positive square.
    fn factorial_series(first: Self, square: Self, from: u32) -> Self {
        /// 0.8^32/32! is less than 1e-37.
        const TERMS: u32 = 16;
        let terms = (0..TERMS).scan(first, |term, index| {
            let m = f64::from(from + 2 * index);
            *term = *term * square / Self::literal((m + 1.0) * (m + 2.0));
            Some(*term)
        });
        // Small terms are added first.
        terms.collect::<Vec<_>>().into_iter().rev().fold(Self::literal(0.0), Add::add) + first
    }

    /// Returns sine and cosine.
    fn sine_and_cosine(self) -> (Self, Self) {
        let turns = (self.to_f64() / HALF_PI[0]).round();
        if !turns.is_finite() {
            return (Self::literal(f64::NAN), Self::literal(f64::NAN));
        }
        let reduced = HALF_PI
            .iter()
            .fold(self, |rest, part| rest - Self::literal(turns) * Self::literal(*part));
        let square = -(reduced * reduced);
        let sine = Self::factorial_series(reduced, square, 1);
        let cosine = Self::factorial_series(Self::literal(1.0), square, 0);
        match turns.rem_euclid(4.0) as u8 {
            0 => (sine, cosine),
            1 => (cosine, -sine),
            2 => (-sine, -cosine),
            _ => (-cosine, sine),
        }
    }

    /// Returns sqrt(1 - x^2).
    fn complement(self) -> Self {
        let one = Self::literal(1.0);
        ((one - self) * (one + self)).sqrt()
    }
}

impl Add for DoubleDouble {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self(self.0.add_accurate(other.0))
    }
}

impl Sub for DoubleDouble {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Self(self.0.sub_accurate(other.0))
    }
}

impl Mul for DoubleDouble {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        Self(self.0.mul(other.0))
    }
}

impl Div for DoubleDouble {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        Self(self.0.div(other.0))
    }
}

impl Neg for DoubleDouble {
    type Output = Self;
    fn neg(self) -> Self {
        Self(self.0.neg())
    }
}

impl Real for DoubleDouble {
    fn literal(value: f64) -> Self {
        Self(Quad::from_f64(value))
    }

    fn select_less(lhs: Self, rhs: Self, then: Self, otherwise: Self) -> Self {
        if lhs.0.lt(rhs.0) { then } else { otherwise }
    }

    fn powf(self, exponent: Self) -> Self {
        (self.ln() * exponent).exp()
    }

    fn sqrt(self) -> Self {
        Self(self.0.sqrt())
    }

    fn abs(self) -> Self {
        Self(self.0.abs())
    }

    fn floor(self) -> Self {
        // The leading part may have been rounded up to a whole number.
        let whole = Self::literal(self.to_f64().floor());
        Self::select_less(self, whole, whole - Self::literal(1.0), whole)
    }

    fn exp(self) -> Self {
        Self(self.0.exp())
    }

    fn ln(self) -> Self {
        Self(self.0.ln())
    }

    fn sin(self) -> Self {
        self.sine_and_cosine().0
    }

    fn cos(self) -> Self {
        self.sine_and_cosine().1
    }

    fn tan(self) -> Self {
        let (sine, cosine) = self.sine_and_cosine();
        sine / cosine
    }

    /// Uses y near the angle: sin(asin x - y) = x cos y - sqrt(1 - x^2) sin y, which is small
    /// enough to be the difference itself.
    fn asin(self) -> Self {
        let near = Self::literal(self.to_f64().asin());
        let (sine, cosine) = near.sine_and_cosine();
        near + (self * cosine - self.complement() * sine)
    }

    /// Works like [`Real::asin`], by sqrt(1 - x^2) cos y - x sin y.
    fn acos(self) -> Self {
        let near = Self::literal(self.to_f64().acos());
        let (sine, cosine) = near.sine_and_cosine();
        near + (self.complement() * cosine - self * sine)
    }

    /// Uses y near the angle: tan(atan x - y) = (x cos y - sin y)/(cos y + x sin y).
    fn atan(self) -> Self {
        let near = Self::literal(self.to_f64().atan());
        let (sine, cosine) = near.sine_and_cosine();
        near + (self * cosine - sine) / (cosine + self * sine)
    }

    fn sinh(self) -> Self {
        if self.to_f64().abs() < SMALL {
            return Self::factorial_series(self, self * self, 1);
        }
        let grown = self.exp();
        (grown - Self::literal(1.0) / grown) * Self::literal(0.5)
    }

    fn cosh(self) -> Self {
        let grown = self.exp();
        (grown + Self::literal(1.0) / grown) * Self::literal(0.5)
    }

    fn tanh(self) -> Self {
        let size = self.to_f64();
        if size.abs() > SATURATED {
            return Self::literal(size.signum());
        }
        self.sinh() / self.cosh()
    }
}

#[cfg(test)]
mod tests {
    use dashu_float::FBig;
    use dashu_float::round::mode::HalfEven;

    use super::*;

    type Exact = FBig<HalfEven, 2>;
    type Case = (fn(DoubleDouble) -> DoubleDouble, fn(&Exact) -> Exact);

    /// Number of bits of the correctly rounded reference functions.
    const BITS: usize = 200;
    const TOLERANCE: f64 = 2e-30;

    fn exact(value: DoubleDouble) -> Exact {
        let part = |part: f64| Exact::try_from(part).expect("finite").with_precision(BITS).value();
        part(value.0.0) + part(value.0.1)
    }

    /// Returns |ours - truth|/|truth|.
    fn error(ours: DoubleDouble, truth: &Exact) -> f64 {
        let distance = (exact(ours) - truth).to_f64().value().abs();
        distance / truth.to_f64().value().abs()
    }

    /// Returns points all over an interval, none of which is an `f64`.
    fn points(from: f64, to: f64) -> impl Iterator<Item = DoubleDouble> {
        let third = DoubleDouble::literal(1.0) / DoubleDouble::literal(3.0);
        (0..100).map(move |index| {
            let share = (DoubleDouble::literal(f64::from(index)) + third) * third
                / DoubleDouble::literal(34.0);
            DoubleDouble::literal(from) + share * DoubleDouble::literal(to - from)
        })
    }

    #[track_caller]
    fn agree(name: &str, (ours, truth): Case, from: f64, to: f64) {
        for x in points(from, to) {
            let error = error(ours(x), &truth(&exact(x)));
            assert!(error < TOLERANCE, "{name} errs by {error:e} at {}", x.to_f64());
        }
    }

    #[test]
    fn functions_are_right_to_thirty_digits() {
        agree("exp", (Real::exp, FBig::exp), -30.0, 30.0);
        agree("ln", (Real::ln, FBig::ln), 1.5, 1e3);
        agree("sqrt", (Real::sqrt, FBig::sqrt), 1e-3, 1e3);
        agree("sin", (Real::sin, FBig::sin), -40.0, 40.0);
        agree("cos", (Real::cos, FBig::cos), -40.0, 40.0);
        agree("tan", (Real::tan, FBig::tan), -40.0, 40.0);
        agree("asin", (Real::asin, FBig::asin), -0.999, 0.999);
        agree("acos", (Real::acos, FBig::acos), -0.999, 0.999);
        agree("atan", (Real::atan, FBig::atan), -50.0, 50.0);
        agree("sinh", (Real::sinh, FBig::sinh), -3.0, 3.0);
        agree("cosh", (Real::cosh, FBig::cosh), -3.0, 3.0);
        agree("tanh", (Real::tanh, FBig::tanh), -3.0, 3.0);
    }

    #[test]
    fn whole_numbers_below_are_exact_beyond_doubles() {
        let tiny = DoubleDouble::literal(1e-20);
        for (x, floor) in [(2.5, 2.0), (-2.5, -3.0), (3.0, 3.0)] {
            assert_eq!(DoubleDouble::literal(x).floor(), DoubleDouble::literal(floor));
        }
        let three = DoubleDouble::literal(3.0);
        assert_eq!((three - tiny).floor(), DoubleDouble::literal(2.0));
        assert_eq!((three + tiny).floor(), three);
    }

    #[test]
    fn ends_of_domains_are_values() {
        let one = DoubleDouble::literal(1.0);
        assert_eq!(one.acos(), DoubleDouble::literal(0.0));
        assert!((one.asin() - DoubleDouble::literal(FRAC_PI_2)).to_f64().abs() < 1e-16);
        assert_eq!(DoubleDouble::literal(-400.0).tanh(), -one);
        assert_eq!(DoubleDouble::literal(1e3).tanh(), one);
        assert!(DoubleDouble::literal(f64::INFINITY).sin().to_f64().is_nan());
    }
}

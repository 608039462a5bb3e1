//! Numbers with the size of the terms they are computed from. This size is the scale for the
//! rounding errors of any other computation of the same number.
//!
//! ```text
//! size(x + y) = size(x) + size(y)      size(x y) = |x| size(y) + |y| size(x)
//! size(f(x)) = |f| + |f'| size(x)
//! ```
//!
//! This is the running error analysis of J. H. Wilkinson, in units of one rounding.

use std::ops::{Add, Div, Mul, Neg, Sub};

use machinist_contract::{CubicTable, Real};

/// A number, and the size of its terms.
#[derive(Debug, Clone, Copy)]
pub struct Rounded<R> {
    /// The number.
    pub value: R,
    /// At least its absolute value.
    pub size: R,
}

impl<R: Real> Rounded<R> {
    /// Returns a number that is exact.
    pub fn new(value: R) -> Self {
        Self { value, size: value.abs() }
    }

    /// Returns f(x) from f(x) and f'(x), which may be infinite if x is exact.
    fn through(self, f: R, slope: R) -> Self {
        let zero = R::literal(0.0);
        let share = R::select_less(zero, self.size, slope.abs() * self.size, zero);
        Self { value: f, size: f.abs() + share }
    }
}

impl<R: Real> Add for Rounded<R> {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self { value: self.value + other.value, size: self.size + other.size }
    }
}

impl<R: Real> Sub for Rounded<R> {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl<R: Real> Mul for Rounded<R> {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        let size = self.value.abs() * other.size + other.value.abs() * self.size;
        Self { value: self.value * other.value, size }
    }
}

impl<R: Real> Div for Rounded<R> {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        let value = self.value / other.value;
        let size = (self.size + value.abs() * other.size) / other.value.abs();
        Self { value, size }
    }
}

impl<R: Real> Neg for Rounded<R> {
    type Output = Self;
    fn neg(self) -> Self {
        Self { value: -self.value, size: self.size }
    }
}

impl<R: Real> Real for Rounded<R> {
    fn literal(value: f64) -> Self {
        Self::new(R::literal(value))
    }

    fn select_less(lhs: Self, rhs: Self, then: Self, otherwise: Self) -> Self {
        let pick = |then, otherwise| R::select_less(lhs.value, rhs.value, then, otherwise);
        Self { value: pick(then.value, otherwise.value), size: pick(then.size, otherwise.size) }
    }

    fn powf(self, exponent: Self) -> Self {
        let (x, c) = (self.value, exponent.value);
        self.through(x.powf(c), c * x.powf(c - R::literal(1.0)))
    }

    fn sqrt(self) -> Self {
        let root = self.value.sqrt();
        self.through(root, R::literal(0.5) / root)
    }

    fn abs(self) -> Self {
        Self { value: self.value.abs(), size: self.size }
    }

    fn floor(self) -> Self {
        Self::new(self.value.floor())
    }

    fn exp(self) -> Self {
        self.through(self.value.exp(), self.value.exp())
    }

    fn ln(self) -> Self {
        self.through(self.value.ln(), R::literal(1.0) / self.value)
    }

    fn sin(self) -> Self {
        self.through(self.value.sin(), self.value.cos())
    }

    fn cos(self) -> Self {
        self.through(self.value.cos(), self.value.sin())
    }

    fn tan(self) -> Self {
        let f = self.value.tan();
        self.through(f, R::literal(1.0) + f * f)
    }

    fn asin(self) -> Self {
        let x = self.value;
        self.through(x.asin(), R::literal(1.0) / (R::literal(1.0) - x * x).sqrt())
    }

    fn acos(self) -> Self {
        let x = self.value;
        self.through(x.acos(), R::literal(1.0) / (R::literal(1.0) - x * x).sqrt())
    }

    fn atan(self) -> Self {
        let x = self.value;
        self.through(x.atan(), R::literal(1.0) / (R::literal(1.0) + x * x))
    }

    fn sinh(self) -> Self {
        self.through(self.value.sinh(), self.value.cosh())
    }

    fn cosh(self) -> Self {
        self.through(self.value.cosh(), self.value.sinh())
    }

    fn tanh(self) -> Self {
        let f = self.value.tanh();
        self.through(f, R::literal(1.0) - f * f)
    }

    fn interpolate(table: &CubicTable<'_>, order: u32, argument: Self) -> Self {
        let read = |more: u32| table.evaluate(order + more, argument.value);
        argument.through(read(0), read(1))
    }
}

pub fn sum<R: Real>(parts: impl Iterator<Item = Rounded<R>>) -> Rounded<R> {
    parts.fold(Rounded::literal(0.0), |sum, part| sum + part)
}

/// Returns the product of a row and a column.
pub fn product<R: Real>(row: &[R], column: &[Rounded<R>]) -> Rounded<R> {
    sum(row.iter().zip(column).map(|(factor, part)| Rounded {
        value: *factor * part.value,
        size: factor.abs() * part.size,
    }))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_cancels_keeps_its_size() {
        let [x, y] = [3.0, -3.0].map(Rounded::<f64>::literal);
        let sum = x + y;
        assert!(sum.value.abs() < 1e-300 && (sum.size - 6.0).abs() < 1e-15);
        let product = sum * x;
        assert!((product.size - 18.0).abs() < 1e-14);
        let root = Rounded::<f64>::literal(0.0).sqrt();
        assert!(root.size.abs() < 1e-300);
        // sin x at a zero: the rounding error is that of the angle.
        let zero = Rounded::<f64>::literal(std::f64::consts::PI).sin();
        assert!((zero.size - std::f64::consts::PI).abs() < 1e-14);
    }
}

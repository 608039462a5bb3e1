//! Number types of closed forms: `f64`, and types that carry a derivative.

use std::ops::{Add, Div, Mul, Neg, Sub};

/// A number with the functions that closed forms need.
pub trait Number:
    Copy
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
{
    /// Returns a constant.
    fn literal(value: f64) -> Self;
    /// Returns the value alone, which decides between cases.
    fn value(self) -> f64;
    /// Returns the square root.
    #[must_use]
    fn sqrt(self) -> Self;
    /// Returns the exponential.
    #[must_use]
    fn exp(self) -> Self;
    /// Returns sine and cosine.
    fn sin_cos(self) -> (Self, Self);
    /// Returns the arcsine.
    #[must_use]
    fn asin(self) -> Self;
    /// Returns the arctangent.
    #[must_use]
    fn atan(self) -> Self;
}

impl Number for f64 {
    fn literal(value: f64) -> Self {
        value
    }
    fn value(self) -> f64 {
        self
    }
    fn sqrt(self) -> Self {
        f64::sqrt(self)
    }
    fn exp(self) -> Self {
        f64::exp(self)
    }
    fn sin_cos(self) -> (Self, Self) {
        f64::sin_cos(self)
    }
    fn asin(self) -> Self {
        f64::asin(self)
    }
    fn atan(self) -> Self {
        f64::atan(self)
    }
}

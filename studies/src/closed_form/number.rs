//! Numbers that closed forms are of: `f64`, or such that carry a derivative.

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
    /// A constant.
    fn literal(value: f64) -> Self;
    /// Its value alone, by which cases are told apart.
    fn value(self) -> f64;
    /// Square root.
    #[must_use]
    fn sqrt(self) -> Self;
    /// Exponential.
    #[must_use]
    fn exp(self) -> Self;
    /// Sine and cosine.
    fn sin_cos(self) -> (Self, Self);
    /// Arcus sine.
    #[must_use]
    fn asin(self) -> Self;
    /// Arcus tangent.
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

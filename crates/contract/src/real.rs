//! Number types of emitted code.

use core::fmt::Debug;
use core::ops::{Add, Div, Mul, Neg, Sub};

use crate::CubicTable;
use crate::exponential::{NEAR, exponential, exponential_near, hyperbolic_tangent_alone};
use crate::side_by_side::{hyperbolic_tangents, sines_and_cosines};
use crate::sine::{FARTHEST, cosine_near, sine_and_cosine, sine_near};

/// A real number type for emitted code: `f64` and `f32` here, complex-step, lanes or
/// double-double elsewhere.
///
/// Comparisons do not branch; [`Real::select_less`] selects a value, so a type may hold several
/// values at once.
#[allow(clippy::return_self_not_must_use, reason = "functions here read like operators")]
pub trait Real:
    Copy
    + Debug
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
{
    /// Returns the number nearest to a literal.
    fn literal(value: f64) -> Self;
    /// Returns `if lhs < rhs { then } else { otherwise }`.
    fn select_less(lhs: Self, rhs: Self, then: Self, otherwise: Self) -> Self;
    /// Returns `self factor + summand`. It is fused, with one rounding, if the compile target has
    /// the instruction (`-C target-cpu=native`); else it takes two operations.
    #[inline(always)]
    fn mul_add(self, factor: Self, summand: Self) -> Self {
        self * factor + summand
    }
    /// Returns `self + a b`, rounded as by [`Real::mul_add`].
    #[inline(always)]
    fn add_product(self, a: Self, b: Self) -> Self {
        a.mul_add(b, self)
    }
    /// Returns `self - a b`, rounded likewise.
    #[inline(always)]
    fn sub_product(self, a: Self, b: Self) -> Self {
        (-a).mul_add(b, self)
    }
    /// Returns an integer power. Repeated squaring makes it bitwise equal with and without `std`.
    fn powi(self, exponent: i32) -> Self {
        power_by_squaring(self, exponent)
    }
    /// Returns the real power of a positive base.
    fn powf(self, exponent: Self) -> Self;
    /// Returns the square root.
    fn sqrt(self) -> Self;
    /// Returns the absolute value.
    fn abs(self) -> Self;
    /// Returns the largest whole number not above this one.
    fn floor(self) -> Self;
    /// Returns the exponential function.
    fn exp(self) -> Self;
    /// Returns the natural logarithm.
    fn ln(self) -> Self;
    /// Returns the sine.
    fn sin(self) -> Self;
    /// Returns the cosine.
    fn cos(self) -> Self;
    /// Returns sine and cosine.
    #[inline(always)]
    fn sin_cos(self) -> (Self, Self) {
        (self.sin(), self.cos())
    }
    /// Returns sines and cosines, side by side if the type supports it, with the same bits either
    /// way.
    #[inline(always)]
    fn sin_cos_each<const N: usize>(angles: [Self; N]) -> [(Self, Self); N] {
        angles.map(Self::sin_cos)
    }
    /// Returns the tangent.
    fn tan(self) -> Self;
    /// Returns the inverse sine.
    fn asin(self) -> Self;
    /// Returns the inverse cosine.
    fn acos(self) -> Self;
    /// Returns the inverse tangent.
    fn atan(self) -> Self;
    /// Returns the hyperbolic sine.
    fn sinh(self) -> Self;
    /// Returns the hyperbolic cosine.
    fn cosh(self) -> Self;
    /// Returns the hyperbolic tangent.
    fn tanh(self) -> Self;
    /// Returns hyperbolic tangents, likewise side by side.
    #[inline(always)]
    fn tanh_each<const N: usize>(arguments: [Self; N]) -> [Self; N] {
        arguments.map(Self::tanh)
    }
    /// Returns the value (`order` 0) or derivative of a table at `argument`.
    ///
    /// Walks the whole table without a branch, as types with several values require. Types of one
    /// value override it by [`CubicTable::search`], which is bitwise equal.
    fn interpolate(table: &CubicTable<'_>, order: u32, argument: Self) -> Self {
        table.walk(order, argument)
    }
}

macro_rules! implement_real {
    ($float:ty, $($function:ident = $libm:ident),*; $powf:ident; {$($own:item)*}) => {
        impl Real for $float {
            #[inline(always)]
            #[allow(clippy::cast_possible_truncation)]
            fn literal(value: f64) -> Self {
                value as $float
            }
            #[inline(always)]
            fn select_less(lhs: Self, rhs: Self, then: Self, otherwise: Self) -> Self {
                if lhs < rhs { then } else { otherwise }
            }
            #[inline(always)]
            fn mul_add(self, factor: Self, summand: Self) -> Self {
                // Without the instruction, fused multiply-add is a slow emulation.
                #[cfg(all(feature = "std", target_feature = "fma"))]
                { <$float>::mul_add(self, factor, summand) }
                #[cfg(not(all(feature = "std", target_feature = "fma")))]
                { self * factor + summand }
            }
            fn interpolate(table: &CubicTable<'_>, order: u32, argument: Self) -> Self {
                table.search(order, argument)
            }
            $($own)*
            #[inline]
            fn powf(self, exponent: Self) -> Self {
                #[cfg(feature = "std")]
                { <$float>::powf(self, exponent) }
                #[cfg(not(feature = "std"))]
                { libm::$powf(self, exponent) }
            }
            $(
                #[inline]
                fn $function(self) -> Self {
                    #[cfg(feature = "std")]
                    { <$float>::$function(self) }
                    #[cfg(not(feature = "std"))]
                    { libm::$libm(self) }
                }
            )*
        }
    };
}

implement_real!(f64, sqrt = sqrt, abs = fabs, floor = floor, ln = log, tan = tan, asin = asin,
acos = acos, atan = atan, sinh = sinh, cosh = cosh; pow; {
    #[inline]
    fn exp(self) -> Self {
        if self.abs() <= NEAR { exponential_near(self) } else { exponential(self) }
    }
    #[inline]
    fn sin(self) -> Self {
        if self.abs() <= FARTHEST { sine_near(self) } else { sine_and_cosine_far_away(self).0 }
    }
    #[inline]
    fn cos(self) -> Self {
        if self.abs() <= FARTHEST { cosine_near(self) } else { sine_and_cosine_far_away(self).1 }
    }
    #[inline]
    fn sin_cos(self) -> (Self, Self) {
        if self.abs() <= FARTHEST { sine_and_cosine(self) } else { sine_and_cosine_far_away(self) }
    }
    #[inline]
    fn sin_cos_each<const N: usize>(angles: [Self; N]) -> [(Self, Self); N] {
        sines_and_cosines(angles)
    }
    #[inline]
    fn tanh(self) -> Self {
        hyperbolic_tangent_alone(self)
    }
    #[inline]
    fn tanh_each<const N: usize>(arguments: [Self; N]) -> [Self; N] {
        hyperbolic_tangents(arguments)
    }
});
implement_real!(f32, sqrt = sqrtf, abs = fabsf, floor = floorf, exp = expf, ln = logf, sin = sinf, cos = cosf, tan = tanf,
    asin = asinf, acos = acosf, atan = atanf, sinh = sinhf, cosh = coshf, tanh = tanhf; powf; {});

#[cold]
fn sine_and_cosine_far_away(x: f64) -> (f64, f64) {
    #[cfg(feature = "std")]
    {
        (f64::sin(x), f64::cos(x))
    }
    #[cfg(not(feature = "std"))]
    {
        (libm::sin(x), libm::cos(x))
    }
}

/// Returns an integer power by repeated squaring; unrolled if the exponent is known.
#[inline]
fn power_by_squaring<R: Real>(base: R, exponent: i32) -> R {
    let mut power = R::literal(1.0);
    let mut square = base;
    let mut left = exponent.unsigned_abs();
    while left > 0 {
        if left & 1 == 1 {
            power = power * square;
        }
        square = square * square;
        left >>= 1;
    }
    if exponent < 0 { R::literal(1.0) / power } else { power }
}

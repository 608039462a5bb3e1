//! Vectors of numbers for simulators: four or eight variants of a machine at little more than the
//! cost of one.
//!
//! Sums, products, quotients, roots, sines, cosines, exponentials and hyperbolic tangents use the
//! vector instructions of the compilation target (`-C target-cpu=native`). Other functions are
//! computed lane by lane. Both round as `f64` does, so every lane equals a run on `f64` to the last
//! bit.

use std::ops::{Add, Div, Mul, Neg, Sub};

use machinist_contract::digits::{Digits, ROUNDING};
use machinist_contract::exponential::{exponential, hyperbolic_tangent};
use machinist_contract::sine::{FARTHEST, sine_and_cosine};
use machinist_contract::{F64x2, Real};
use wide::bytemuck::cast;

use crate::method::taylor::magnitude::{self, BEHIND, Magnitude};

/// Digits of a number that is this number with those of a small whole one at the end.
const WHOLE: u64 = SHIFT.to_bits();

/// Mask of the lower half of a number's digits.
const LOWER: u64 = 0xffff_ffff;

const SHIFT: f64 = (1_u64 << 52) as f64;

/// Computes log2 from the halves of a number's digits behind [`WHOLE`], by operations that every
/// vector type has. The result equals that of a scalar, whose digits are used as a whole, because
/// every operation but the sum is exact.
#[inline(always)]
fn log2_of_halves<R: Real>(upper: R, lower: R) -> R {
    const ONE: f64 = (1.0_f64.to_bits() >> 32) as f64;
    const UPPER: f64 = 1.0 / (1_u64 << 20) as f64;
    let whole = (upper - R::literal(SHIFT + ONE)) * R::literal(UPPER);
    let part = (lower - R::literal(SHIFT)) * R::literal(1.0 / SHIFT);
    R::literal(BEHIND) + (whole + part)
}

/// Numbers that consist of lanes.
pub trait Lanes: Magnitude {
    /// Number of lanes.
    const COUNT: usize;
    /// Returns a vector with the same number in every lane.
    fn splat(value: f64) -> Self;
    /// Returns the number in a lane.
    ///
    /// # Panics
    /// If there is no such lane; likewise for `set_lane`.
    fn lane(&self, lane: usize) -> f64;
    /// Sets the number in a lane.
    fn set_lane(&mut self, lane: usize, value: f64);
    /// Returns the lanes in which `lhs` is less than `rhs`, as bits from the lowest on.
    fn less(lhs: Self, rhs: Self) -> u32;
}

macro_rules! lanes {
    ($(#[$doc:meta])* $name:ident, $vector:ty, $bits:ty, $count:literal) => {
        $(#[$doc])*
        #[derive(Debug, Clone, Copy, PartialEq)]
        pub struct $name($vector);

        impl $name {
            #[inline]
            fn each(self, function: impl Fn(f64) -> f64) -> Self {
                Self(<$vector>::from(self.0.to_array().map(function)))
            }

            #[cold]
            fn sin_cos_far_away(self) -> (Self, Self) {
                (self.each(Real::sin), self.each(Real::cos))
            }

            /// Returns whether every lane is near enough to zero for sines by arithmetic.
            #[inline]
            fn is_near(self) -> bool {
                self.0.abs().simd_le(<$vector>::splat(FARTHEST)).all()
            }
        }

        impl From<[f64; $count]> for $name {
            #[inline]
            fn from(lanes: [f64; $count]) -> Self {
                Self(<$vector>::from(lanes))
            }
        }

        impl From<$name> for [f64; $count] {
            #[inline]
            fn from(lanes: $name) -> Self {
                lanes.0.to_array()
            }
        }

        impl Lanes for $name {
            const COUNT: usize = $count;
            #[inline]
            fn splat(value: f64) -> Self {
                Self(<$vector>::splat(value))
            }
            #[inline]
            fn lane(&self, lane: usize) -> f64 {
                self.0.as_array()[lane]
            }
            #[inline]
            fn set_lane(&mut self, lane: usize, value: f64) {
                self.0.as_mut_array()[lane] = value;
            }
            #[inline(always)]
            fn less(lhs: Self, rhs: Self) -> u32 {
                lhs.0.simd_lt(rhs.0).to_bitmask()
            }
        }

        impl Magnitude for $name {
            #[inline(always)]
            fn log2(self) -> Self {
                let bits: $bits = cast(self.0);
                let half = |bits: $bits| Self(cast(bits | <$bits>::splat(WHOLE)));
                log2_of_halves(half(bits >> 32_u32), half(bits & <$bits>::splat(LOWER)))
            }
            // The instruction returns its second operand if one is NaN.
            #[cfg(target_arch = "x86_64")]
            #[inline(always)]
            fn larger(self, value: Self) -> Self {
                Self(value.0.fast_max(self.0))
            }
            #[inline(always)]
            fn exp2(self) -> Self {
                magnitude::exp2(self)
            }
        }

        lanes!(@operator $name, Add, add);
        lanes!(@operator $name, Sub, sub);
        lanes!(@operator $name, Mul, mul);
        lanes!(@operator $name, Div, div);

        impl Neg for $name {
            type Output = Self;
            #[inline(always)]
            fn neg(self) -> Self {
                // This negates zero too, as for `f64`.
                Self(self.0 ^ <$vector>::splat(-0.0))
            }
        }

        impl Real for $name {
            #[inline(always)]
            fn literal(value: f64) -> Self {
                Self(<$vector>::splat(value))
            }
            #[inline(always)]
            fn select_less(lhs: Self, rhs: Self, then: Self, otherwise: Self) -> Self {
                Self(lhs.0.simd_lt(rhs.0).bitselect(then.0, otherwise.0))
            }
            #[inline(always)]
            fn mul_add(self, factor: Self, summand: Self) -> Self {
                if cfg!(target_feature = "fma") {
                    Self(self.0.mul_add(factor.0, summand.0))
                } else {
                    self * factor + summand
                }
            }
            fn powf(self, exponent: Self) -> Self {
                let (base, exponent) = (self.0.to_array(), exponent.0.to_array());
                let powers = std::array::from_fn::<f64, $count, _>(|lane| {
                    base[lane].powf(exponent[lane])
                });
                Self(<$vector>::from(powers))
            }
            #[inline(always)]
            fn sqrt(self) -> Self {
                Self(self.0.sqrt())
            }
            #[inline(always)]
            fn abs(self) -> Self {
                Self(self.0.abs())
            }
            #[inline(always)]
            fn exp(self) -> Self {
                exponential(self)
            }
            #[inline(always)]
            fn sin(self) -> Self {
                self.sin_cos().0
            }
            #[inline(always)]
            fn cos(self) -> Self {
                self.sin_cos().1
            }
            #[inline(always)]
            fn sin_cos(self) -> (Self, Self) {
                if self.is_near() { sine_and_cosine(self) } else { self.sin_cos_far_away() }
            }
            #[inline(always)]
            fn sin_cos_each<const N: usize>(angles: [Self; N]) -> [(Self, Self); N] {
                // The loop is written out because moving arrays is slower than computing their
                // entries.
                let zero = Self::literal(0.0);
                let mut pairs = [(zero, zero); N];
                for (pair, angle) in pairs.iter_mut().zip(&angles) {
                    *pair = angle.sin_cos();
                }
                pairs
            }
            #[inline(always)]
            fn tanh(self) -> Self {
                hyperbolic_tangent(self)
            }
            #[inline(always)]
            fn tanh_each<const N: usize>(arguments: [Self; N]) -> [Self; N] {
                let mut tangents = arguments;
                for tangent in &mut tangents {
                    *tangent = hyperbolic_tangent(*tangent);
                }
                tangents
            }
            lanes!(@each floor, ln, tan, asin, acos, atan, sinh, cosh);
        }

        impl Digits for $name {
            #[inline(always)]
            fn power_of_two(n: Self) -> Self {
                let digits: $bits = cast(n.0 + <$vector>::splat(ROUNDING + 1023.0));
                Self(cast(digits << 52_u32))
            }
            #[inline(always)]
            fn with_sign_of(self, other: Self) -> Self {
                Self(self.0 | (other.0 & <$vector>::splat(-0.0)))
            }
            #[inline(always)]
            fn turn(n: Self, sine: Self, cosine: Self) -> (Self, Self) {
                let n: $bits = cast(n.0);
                let (one, two) = (<$bits>::splat(1), <$bits>::splat(2));
                let is_odd: $vector = cast((n & one).simd_eq(one));
                let (s, c) = (is_odd.bitselect(cosine.0, sine.0), is_odd.bitselect(sine.0, cosine.0));
                let sign = |n: $bits| -> $vector { cast((n & two) << 62_u32) };
                (Self(s ^ sign(n)), Self(c ^ sign(n + one)))
            }
        }
    };
    (@operator $name:ident, $operator:ident, $function:ident) => {
        impl $operator for $name {
            type Output = Self;
            #[inline(always)]
            fn $function(self, other: Self) -> Self {
                Self($operator::$function(self.0, other.0))
            }
        }
    };
    (@each $($function:ident),*) => {
        $(
            fn $function(self) -> Self {
                self.each(f64::$function)
            }
        )*
    };
}

lanes! {
    /// Four numbers in lanes.
    F64x4, wide::f64x4, wide::u64x4, 4
}
lanes! {
    /// Eight numbers in lanes.
    F64x8, wide::f64x8, wide::u64x8, 8
}

/// Two numbers in lanes, for JIT-compiled models.
impl Lanes for F64x2 {
    const COUNT: usize = 2;
    #[inline]
    fn splat(value: f64) -> Self {
        Self([value; 2])
    }
    #[inline]
    fn lane(&self, lane: usize) -> f64 {
        self.0[lane]
    }
    #[inline]
    fn set_lane(&mut self, lane: usize, value: f64) {
        self.0[lane] = value;
    }
    #[inline]
    fn less(lhs: Self, rhs: Self) -> u32 {
        u32::from(lhs.0[0] < rhs.0[0]) | u32::from(lhs.0[1] < rhs.0[1]) << 1
    }
}

impl Magnitude for F64x2 {
    #[inline]
    fn log2(self) -> Self {
        Self(self.0.map(Magnitude::log2))
    }
    #[inline]
    fn exp2(self) -> Self {
        Self(self.0.map(Magnitude::exp2))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn logarithms_in_lanes_are_those_of_single_numbers() {
        let mut random = fastrand::Rng::with_seed(11);
        for _ in 0..10_000 {
            let values: [f64; 8] =
                std::array::from_fn(|_| f64::from_bits(random.u64(..) & (u64::MAX >> 1)));
            let logs: [f64; 8] = F64x8::from(values).log2().into();
            let expected = values.map(Magnitude::log2);
            assert_eq!(logs.map(f64::to_bits), expected.map(f64::to_bits), "{values:?}");
        }
    }
}

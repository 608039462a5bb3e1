//! Several numbers side by side, for simulators to run on: four or eight variants
//! of a machine at the cost of little more than one.
//!
//! Sums, products, quotients, roots, sines and cosines are those of the processor's
//! vectors, as wide as the target that the program is compiled for has them
//! (`-C target-cpu=native`); other functions are computed lane by lane. Both round as
//! `f64` does, so every lane holds, to the last bit, what a run on `f64` would hold.

use std::ops::{Add, Div, Mul, Neg, Sub};

use machinist_scenes::Real;
use machinist_scenes::sine::{FARTHEST, sine_and_cosine};

/// Numbers with lanes that can be taken apart.
pub trait Lanes: Real {
    /// How many lanes.
    const COUNT: usize;
    /// The same number in every lane.
    fn splat(value: f64) -> Self;
    /// Number of a lane.
    ///
    /// # Panics
    /// If there is no such lane; likewise below.
    fn lane(&self, lane: usize) -> f64;
    /// Puts a number into a lane.
    fn set_lane(&mut self, lane: usize, value: f64);
}

macro_rules! lanes {
    ($(#[$doc:meta])* $name:ident, $vector:ty, $count:literal) => {
        $(#[$doc])*
        #[derive(Debug, Clone, Copy, PartialEq)]
        pub struct $name($vector);

        impl $name {
            #[inline]
            fn each(self, function: impl Fn(f64) -> f64) -> Self {
                Self(<$vector>::from(self.0.to_array().map(function)))
            }

            /// Whether every lane is near enough to zero for sines by arithmetic.
            #[inline]
            fn is_near(self) -> bool {
                self.0.to_array().iter().all(|lane| lane.abs() <= FARTHEST)
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
        }

        lanes!(@operator $name, Add, add);
        lanes!(@operator $name, Sub, sub);
        lanes!(@operator $name, Mul, mul);
        lanes!(@operator $name, Div, div);

        impl Neg for $name {
            type Output = Self;
            #[inline(always)]
            fn neg(self) -> Self {
                // Of zero too, as for `f64`.
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
            #[inline]
            fn sin(self) -> Self {
                if self.is_near() { sine_and_cosine(self).0 } else { self.each(Real::sin) }
            }
            #[inline]
            fn cos(self) -> Self {
                if self.is_near() { sine_and_cosine(self).1 } else { self.each(Real::cos) }
            }
            lanes!(@each exp, ln, tan, asin, acos, atan, sinh, cosh, tanh);
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
    /// Four numbers.
    F64x4, wide::f64x4, 4
}
lanes! {
    /// Eight numbers.
    F64x8, wide::f64x8, 8
}

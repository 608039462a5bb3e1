//! Two numbers side by side.

use core::ops::{Add, Div, Mul, Neg, Sub};

use crate::Real;

/// Two numbers, each bitwise equal to the result of computing it alone.
#[derive(Debug, Clone, Copy, PartialEq)]
#[repr(transparent)]
pub struct F64x2(pub [f64; 2]);

impl F64x2 {
    #[inline(always)]
    fn each(self, of: impl Fn(f64) -> f64) -> Self {
        Self([of(self.0[0]), of(self.0[1])])
    }

    #[inline(always)]
    fn both(self, other: Self, of: impl Fn(f64, f64) -> f64) -> Self {
        Self([of(self.0[0], other.0[0]), of(self.0[1], other.0[1])])
    }
}

macro_rules! operators {
    ($($operator:ident $function:ident),*) => {
        $(
            impl $operator for F64x2 {
                type Output = Self;
                #[inline(always)]
                fn $function(self, other: Self) -> Self {
                    self.both(other, f64::$function)
                }
            }
        )*
    };
}

operators!(Add add, Sub sub, Mul mul, Div div);

impl Neg for F64x2 {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        self.each(f64::neg)
    }
}

/// Defines functions that apply to each number.
macro_rules! functions {
    ($($function:ident),*) => {
        $(
            #[inline]
            fn $function(self) -> Self {
                self.each(<f64 as Real>::$function)
            }
        )*
    };
}

impl Real for F64x2 {
    #[inline(always)]
    fn literal(value: f64) -> Self {
        Self([value; 2])
    }
    #[inline(always)]
    fn select_less(lhs: Self, rhs: Self, then: Self, otherwise: Self) -> Self {
        let pick = |lane: usize| {
            f64::select_less(lhs.0[lane], rhs.0[lane], then.0[lane], otherwise.0[lane])
        };
        Self([pick(0), pick(1)])
    }
    #[inline(always)]
    fn mul_add(self, factor: Self, summand: Self) -> Self {
        let of = |lane: usize| Real::mul_add(self.0[lane], factor.0[lane], summand.0[lane]);
        Self([of(0), of(1)])
    }
    #[inline]
    fn powf(self, exponent: Self) -> Self {
        self.both(exponent, Real::powf)
    }
    #[inline]
    fn sin_cos(self) -> (Self, Self) {
        let [low, high] = self.0.map(Real::sin_cos);
        (Self([low.0, high.0]), Self([low.1, high.1]))
    }
    functions!(sqrt, abs, floor, exp, ln, sin, cos, tan, asin, acos, atan, sinh, cosh, tanh);
}

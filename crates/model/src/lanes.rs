//! Numbers that run as lanes of one vector.

#![allow(unsafe_code, reason = "numbers side by side are read as numbers one after the other")]

use machinist_contract::Real;

pub use machinist_contract::F64x2;

/// Number type of models: one number, or several in lanes.
pub trait Lane: Real + Send + Sync + sealed::Sealed + 'static {
    /// Number of lanes.
    const COUNT: usize;
    /// Returns the numbers, with those of one place next to each other.
    fn numbers(all: &[Self]) -> &[f64];
    /// Returns the numbers for writing, with those of one place next to each other.
    fn numbers_mut(all: &mut [Self]) -> &mut [f64];
    /// Returns the first number and the last.
    fn ends(self) -> [f64; 2];
}

mod sealed {
    pub trait Sealed {}
    impl Sealed for f64 {}
    impl Sealed for super::F64x2 {}
}

impl Lane for f64 {
    const COUNT: usize = 1;
    #[inline(always)]
    fn numbers(all: &[Self]) -> &[f64] {
        all
    }
    #[inline(always)]
    fn numbers_mut(all: &mut [Self]) -> &mut [f64] {
        all
    }
    #[inline(always)]
    fn ends(self) -> [f64; 2] {
        [self; 2]
    }
}

impl Lane for F64x2 {
    const COUNT: usize = 2;
    #[inline(always)]
    fn numbers(all: &[Self]) -> &[f64] {
        // SAFETY: `F64x2` consists of two numbers and nothing else, so `all` holds twice as many
        // numbers as its length; the slice lives as long as `all`.
        unsafe { std::slice::from_raw_parts(all.as_ptr().cast(), 2 * all.len()) }
    }
    #[inline(always)]
    fn numbers_mut(all: &mut [Self]) -> &mut [f64] {
        // SAFETY: as in `numbers`, and any two numbers are an `F64x2`.
        unsafe { std::slice::from_raw_parts_mut(all.as_mut_ptr().cast(), 2 * all.len()) }
    }
    #[inline(always)]
    fn ends(self) -> [f64; 2] {
        self.0
    }
}

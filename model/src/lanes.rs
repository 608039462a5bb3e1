//! Two numbers side by side, as machine code computes with them.

#![allow(unsafe_code, reason = "numbers side by side are read as numbers one after the other")]

use machinist_contract::Real;

pub use machinist_contract::F64x2;

/// What models are run on: one number, or several side by side.
pub trait Lane: Real + Send + Sync + sealed::Sealed + 'static {
    /// How many.
    const COUNT: usize;
    /// The numbers, those of one place side by side.
    fn numbers(all: &[Self]) -> &[f64];
    /// The numbers, to be written.
    fn numbers_mut(all: &mut [Self]) -> &mut [f64];
    /// The first number and the last.
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
        // SAFETY: `F64x2` is two numbers and nothing else, so `all` holds twice as many as
        // it is long; the slice lives as long as it.
        unsafe { std::slice::from_raw_parts(all.as_ptr().cast(), 2 * all.len()) }
    }
    #[inline(always)]
    fn numbers_mut(all: &mut [Self]) -> &mut [f64] {
        // SAFETY: likewise, and any two numbers are an `F64x2`.
        unsafe { std::slice::from_raw_parts_mut(all.as_mut_ptr().cast(), 2 * all.len()) }
    }
    #[inline(always)]
    fn ends(self) -> [f64; 2] {
        self.0
    }
}

//! The contract's own functions, callable from machine code.

#![allow(unsafe_code, reason = "results are written behind a pointer, as machine code asks")]

use cranelift_codegen::ir::{Type, types};
use machinist_contract::Real;

use crate::evaluate::{call, interpolate};
use crate::{Function, Table};

/// A function that machine code calls.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Thunk {
    /// A function of one number.
    Function(Function),
    /// Real power.
    Powf,
    /// A table, with the order of the derivative and the argument.
    Table,
    /// Sine and cosine of one number; the cosine is written four places after the sine.
    SinCos,
    /// Four sines, then four cosines.
    SinCosOfFour,
    /// Four hyperbolic tangents.
    TanhOfFour,
}

impl Thunk {
    /// Returns the types of its parameters, and whether it returns a number.
    pub fn signature(self, pointer: Type) -> (Vec<Type>, bool) {
        match self {
            Self::Function(_) => (vec![types::F64], true),
            Self::Powf => (vec![types::F64; 2], true),
            Self::Table => (vec![pointer, types::I32, types::F64], true),
            Self::SinCos => (vec![types::F64, pointer], false),
            Self::SinCosOfFour | Self::TanhOfFour => {
                (vec![types::F64, types::F64, types::F64, types::F64, pointer], false)
            }
        }
    }

    /// Returns its address.
    pub fn address(self) -> *const u8 {
        match self {
            Self::Function(function) => of_one(function) as *const u8,
            Self::Powf => powf as *const u8,
            Self::Table => table as *const u8,
            Self::SinCos => sin_cos as *const u8,
            Self::SinCosOfFour => sin_cos_of_four as *const u8,
            Self::TanhOfFour => tanh_of_four as *const u8,
        }
    }
}

macro_rules! of_one {
    ($($function:ident),*) => {
        /// Returns a thunk of a function of one number.
        fn of_one(function: Function) -> extern "C" fn(f64) -> f64 {
            match function {
                $(Function::$function => {
                    extern "C" fn thunk(x: f64) -> f64 {
                        call(Function::$function, x)
                    }
                    thunk
                })*
            }
        }
    };
}

of_one!(Sqrt, Abs, Floor, Exp, Ln, Sin, Cos, Tan, Asin, Acos, Atan, Sinh, Cosh, Tanh);

extern "C" fn powf(base: f64, exponent: f64) -> f64 {
    base.powf(exponent)
}

/// # Safety
/// `table` must be alive.
unsafe extern "C" fn table(table: *const Table, order: u32, x: f64) -> f64 {
    // SAFETY: required of the caller.
    interpolate(unsafe { &*table }, order, x)
}

/// # Safety
/// `results` must have room for five numbers.
unsafe extern "C" fn sin_cos(x: f64, results: *mut f64) {
    let (sine, cosine) = Real::sin_cos(x);
    // SAFETY: required of the caller.
    unsafe {
        results.write(sine);
        results.add(4).write(cosine);
    }
}

/// # Safety
/// `results` must have room for eight numbers.
unsafe extern "C" fn sin_cos_of_four(a: f64, b: f64, c: f64, d: f64, results: *mut [f64; 8]) {
    let pairs = Real::sin_cos_each([a, b, c, d]);
    let mut all = [0.0; 8];
    for (index, (sine, cosine)) in pairs.into_iter().enumerate() {
        (all[index], all[index + 4]) = (sine, cosine);
    }
    // SAFETY: required of the caller; numbers in machine code have the layout of those in Rust.
    unsafe { results.write(all) };
}

/// # Safety
/// `results` must have room for four numbers.
unsafe extern "C" fn tanh_of_four(a: f64, b: f64, c: f64, d: f64, results: *mut [f64; 4]) {
    let tangents = Real::tanh_each([a, b, c, d]);
    // SAFETY: required of the caller.
    unsafe { results.write(tangents) };
}

//! Types of `fmi3PlatformTypes.h` and `fmi3FunctionTypes.h`.
//!
//! A boolean is a byte here, because a host may hand over any value.

use std::ffi::{c_char, c_void};

/// `fmi3Instance`.
pub type Handle = *mut c_void;
/// `fmi3FMUState`.
pub type StateHandle = *mut c_void;
/// `fmi3InstanceEnvironment`.
pub type Environment = *mut c_void;
/// `fmi3ValueReference`.
pub type ValueReference = u32;
/// `fmi3Boolean`, `fmi3Clock`.
pub type Boolean = u8;
/// `fmi3String`.
pub type Text = *const c_char;

/// `fmi3Status`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[repr(i32)]
pub enum Status {
    /// Success.
    Ok = 0,
    /// Success with a warning.
    Warning = 1,
    /// Failure that a shorter step may avoid.
    Discard = 2,
    /// Failure of this call.
    Error = 3,
    /// Failure of the whole process.
    Fatal = 4,
}

/// `fmi3LogMessageCallback`.
pub type LogMessage = unsafe extern "C" fn(Environment, Status, Text, Text);

/// `fmi3IntermediateUpdateCallback`.
pub type IntermediateUpdate = unsafe extern "C" fn(
    Environment,
    f64,
    Boolean,
    Boolean,
    Boolean,
    Boolean,
    *mut Boolean,
    *mut f64,
);

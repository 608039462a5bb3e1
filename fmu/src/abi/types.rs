//! Types of `fmi3PlatformTypes.h` and `fmi3FunctionTypes.h`.
//!
//! A boolean is a byte here: what a host hands over may be any.

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
    /// All is well.
    Ok = 0,
    /// Nearly.
    Warning = 1,
    /// A shorter step may do.
    Discard = 2,
    /// Not so.
    Error = 3,
    /// Nothing will.
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

//! Functions of `fmi3FunctionTypes.h` and `fmi2FunctionTypes.h`, with the C ABI.
//!
//! Each function looks up its instance by the handle, calls the [`Instance`] and returns a status.
//! Errors are always logged to the host, events if the host wants them. A panic is an error too;
//! afterwards the instance can only be reset or freed.
#![allow(unsafe_code, reason = "hosts hand pointers over and call by name")]
#![allow(non_snake_case, reason = "names are those of the standard")]

mod common;
mod derivatives;
mod exchange;
mod fmi2;
mod simulation;
mod states;
mod types;
mod unused;
mod values;

use std::any::Any;
use std::ffi::{CStr, CString, c_char, c_void};
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::slice;
use std::sync::atomic::{AtomicBool, AtomicPtr, Ordering};
use std::sync::{Mutex, PoisonError};

use crate::instance::{Instance, Refusal};
use crate::registry::{Held, Registry};

pub use common::*;
pub use derivatives::*;
pub use exchange::*;
pub use fmi2::*;
pub use simulation::*;
pub use states::*;
pub use types::*;
pub use unused::*;
pub use values::*;

/// All instances of this process.
static INSTANCES: Registry<Host> = Registry::new();

/// Log categories with their descriptions.
pub const CATEGORIES: [(&str, &str); 3] = [
    (ERRORS, "calls that fail, with why"),
    (DISCARDS, "calls that a shorter step may spare"),
    (EVENTS, "events that happen"),
];
const ERRORS: &str = "logStatusError";
const DISCARDS: &str = "logStatusDiscard";
/// Category of events.
pub const EVENTS: &str = "logEvents";

/// Function of the host that logs messages.
#[derive(Clone, Copy)]
enum Log {
    Fmi3(LogMessage),
    Fmi2(Logger),
}

/// Data of the host that belong to an instance.
struct Host {
    environment: AtomicPtr<c_void>,
    log: Option<Log>,
    update: Option<IntermediateUpdate>,
    /// True if the host wants events logged.
    wants_events: AtomicBool,
    is_broken: AtomicBool,
    /// Name of the instance, which begins each message.
    name: Mutex<CString>,
}

impl Host {
    fn new(
        environment: *mut c_void,
        log: Option<Log>,
        update: Option<IntermediateUpdate>,
        name: CString,
    ) -> Self {
        Self {
            environment: AtomicPtr::new(environment),
            log,
            update,
            wants_events: AtomicBool::new(false),
            is_broken: AtomicBool::new(false),
            name: Mutex::new(name),
        }
    }

    fn environment(&self) -> *mut c_void {
        self.environment.load(Ordering::Relaxed)
    }

    /// Logs a message to the host, whatever categories it wants.
    fn tell(&self, status: Status, category: &str, message: &str) {
        let name = self.name.lock().unwrap_or_else(PoisonError::into_inner).clone();
        match self.log {
            None => {}
            Some(Log::Fmi3(log)) => {
                let message = format!("{}: {message}", name.to_string_lossy());
                tell(log, self.environment(), status, category, &message);
            }
            Some(Log::Fmi2(logger)) => {
                let texts = (&c_text(category), &c_text(message));
                log2(logger, (self.environment(), &name), status, texts);
            }
        }
    }

    /// Logs that no instance was made. FMI 3.0 messages have no name then.
    fn refuse(&self, message: &str) {
        let message = format!("not instantiated: {message}");
        match self.log {
            Some(Log::Fmi3(log)) => {
                tell(log, self.environment(), Status::Error, ERRORS, &message);
            }
            _ => self.tell(Status::Error, ERRORS, &message),
        }
    }

    fn tell_of_events(&self, time: f64, events: &[String]) {
        if self.wants_events.load(Ordering::Relaxed) {
            for event in events {
                self.tell(Status::Ok, EVENTS, &format!("{event} at {time} s"));
            }
        }
    }
}

fn tell(log: LogMessage, environment: *mut c_void, status: Status, category: &str, message: &str) {
    let (category, message) = (c_text(category), c_text(message));
    // SAFETY: the host gave this function for these arguments, and the strings live until it
    // returns.
    unsafe { log(environment, status, category.as_ptr(), message.as_ptr()) };
}

/// Returns a text as a C string, which ends at the first zero.
fn c_text(text: &str) -> CString {
    CString::new(text.replace('\0', " ")).unwrap_or_default()
}

/// Returns the message of a panic.
fn message_of(panic: &(dyn Any + Send)) -> &str {
    let text = panic.downcast_ref::<String>().map(String::as_str);
    text.or_else(|| panic.downcast_ref::<&str>().copied()).unwrap_or("a panic")
}

/// Calls a function on an instance that is not locked, and turns its result into a status.
fn with_held(
    instance: Handle,
    call: &str,
    act: impl FnOnce(&Held<Host>) -> Result<(), Refusal>,
) -> Status {
    let Some(held) = INSTANCES.get(instance.addr()) else { return Status::Error };
    if held.host.is_broken.load(Ordering::Relaxed) && !call.ends_with("Reset") {
        let message = format!("{call}: the instance has failed before; it can be reset or freed");
        held.host.tell(Status::Error, ERRORS, &message);
        return Status::Error;
    }
    match catch_unwind(AssertUnwindSafe(|| act(&held))) {
        Ok(Ok(())) => Status::Ok,
        Ok(Err(refusal)) => {
            let (status, category) = if refusal.is_discard() {
                (Status::Discard, DISCARDS)
            } else {
                (Status::Error, ERRORS)
            };
            held.host.tell(status, category, &format!("{call}: {refusal}"));
            status
        }
        Err(panic) => {
            held.host.is_broken.store(true, Ordering::Relaxed);
            let message = format!("{call}: failed within: {}", message_of(&*panic));
            held.host.tell(Status::Error, ERRORS, &message);
            Status::Error
        }
    }
}

/// Calls a function on a locked instance.
fn with(
    instance: Handle,
    call: &str,
    act: impl FnOnce(&mut Instance) -> Result<(), Refusal>,
) -> Status {
    with_held(instance, call, |held| act(&mut held.lock()))
}

/// Borrows values that a host hands over.
///
/// # Safety
/// A pointer that is not null points to `count` values, which do not change during `'a`.
unsafe fn read<'a, T>(from: *const T, count: usize) -> Result<&'a [T], Refusal> {
    require_room(from, count)?;
    // SAFETY: guaranteed by the caller, and not null.
    Ok(if count == 0 { &[] } else { unsafe { slice::from_raw_parts(from, count) } })
}

/// Borrows the memory to which a host wants values written.
///
/// # Safety
/// A pointer that is not null points to `count` values, which nobody else uses during `'a`.
unsafe fn write<'a, T>(to: *mut T, count: usize) -> Result<&'a mut [T], Refusal> {
    require_room(to.cast_const(), count)?;
    // SAFETY: guaranteed by the caller, and not null.
    Ok(if count == 0 { &mut [] } else { unsafe { slice::from_raw_parts_mut(to, count) } })
}

fn require_room<T>(at: *const T, count: usize) -> Result<(), Refusal> {
    let fits =
        count.checked_mul(size_of::<T>()).is_some_and(|bytes| isize::try_from(bytes).is_ok());
    if count > 0 && at.is_null() {
        return Err(Refusal::argument(format!("a null pointer for {count} values")));
    }
    if count > 0 && !(fits && at.is_aligned()) {
        return Err(Refusal::argument(format!("a pointer that is not valid for {count} values")));
    }
    Ok(())
}

/// Writes one value, unless the pointer is null.
///
/// # Safety
/// A pointer that is not null points to one value.
unsafe fn put<T>(to: *mut T, value: T) {
    if !to.is_null() && to.is_aligned() {
        // SAFETY: guaranteed by the caller.
        unsafe { to.write(value) };
    }
}

/// Copies a string of the host; `None` for null.
///
/// # Safety
/// A pointer that is not null points to bytes that end with a zero.
unsafe fn string(from: *const c_char) -> Option<String> {
    if from.is_null() {
        return None;
    }
    // SAFETY: guaranteed by the caller.
    Some(unsafe { CStr::from_ptr(from) }.to_string_lossy().into_owned())
}

/// Defines functions that hosts find by name.
macro_rules! exported {
    ($(fn $name:ident($($argument:ident: $type:ty),* $(,)?) -> $result:ty $body:block)*) => {
        $(
            #[doc = concat!("`", stringify!($name), "` of the standard.")]
            ///
            /// # Safety
            /// Pointers are null, or point to as many values as the standard requires.
            #[unsafe(no_mangle)]
            pub unsafe extern "C" fn $name($($argument: $type),*) -> $result $body
        )*
    };
}
use exported;

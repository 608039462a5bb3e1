//! Functions of FMI 2.0 (`fmi2FunctionTypes.h`), on the same instances as those of FMI 3.0.
//!
//! There are no intermediate updates, and Co-Simulation has no event mode: events happen within
//! steps.

use std::ffi::{CString, c_char, c_int, c_void};
use std::path::PathBuf;
use std::ptr;

use super::common::{create, load, reset, set_logging};
use super::{
    Environment, Handle, Host, Log, StateHandle, Status, Text, ValueReference, exported,
    fmi3FreeFMUState, fmi3FreeInstance, fmi3GetFMUState, fmi3SetFMUState, put, read, string, with,
    with_held, write,
};
use crate::instance::{Experiment, Instance, Interface, Phase, Refusal, Type};

/// `fmi2Boolean`.
pub type Boolean2 = c_int;

/// `fmi2CallbackLogger`. The message is a format, which takes further arguments.
pub type Logger = unsafe extern "C" fn(Environment, Text, Status, Text, Text, ...);

/// `fmi2CallbackFunctions`.
#[derive(Debug, Clone, Copy)]
#[repr(C)]
pub struct CallbackFunctions {
    /// Logs a message.
    pub logger: Option<Logger>,
    /// Allocates memory. Instances use their own.
    pub allocate_memory: Option<unsafe extern "C" fn(usize, usize) -> *mut c_void>,
    /// Frees such memory.
    pub free_memory: Option<unsafe extern "C" fn(*mut c_void)>,
    /// Told when a pending step has ended. Steps are never pending.
    pub step_finished: Option<unsafe extern "C" fn(Environment, Status)>,
    /// Data of the host.
    pub environment: Environment,
}

/// `fmi2EventInfo`.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
#[repr(C)]
pub struct EventInfo {
    /// True if discrete states need another update.
    pub new_discrete_states_needed: Boolean2,
    /// True if the simulation has to end.
    pub terminate_simulation: Boolean2,
    /// True if typical sizes of states have changed.
    pub nominals_changed: Boolean2,
    /// True if continuous states have changed.
    pub values_changed: Boolean2,
    /// True if there is a next time event.
    pub next_event_time_defined: Boolean2,
    /// Time of it \[s\].
    pub next_event_time: f64,
}

/// `fmi2ModelExchange` of `fmi2Type`.
pub const MODEL_EXCHANGE: c_int = 0;
/// `fmi2CoSimulation` of `fmi2Type`.
pub const CO_SIMULATION: c_int = 1;
/// `fmi2LastSuccessfulTime` of `fmi2StatusKind`.
pub const LAST_SUCCESSFUL_TIME: c_int = 2;
/// `fmi2Terminated` of `fmi2StatusKind`.
pub const TERMINATED: c_int = 3;

/// Returns the folder of a resource location, which is a URI of the scheme `file`.
fn folder_of(location: &str) -> Result<PathBuf, String> {
    let scheme = location.get(..5).filter(|scheme| scheme.eq_ignore_ascii_case("file:"));
    let Some(rest) = scheme.map(|_| &location[5..]) else {
        return Err(format!("the resource location {location} is no URI of the scheme file"));
    };
    let path = match rest.strip_prefix("//") {
        // An authority goes up to the path.
        Some(rest) => &rest[rest.find('/').unwrap_or(rest.len())..],
        None => rest,
    };
    let decoded = decoded(path).ok_or_else(|| format!("{location} is no valid URI"))?;
    // `/C:/folder` is `C:/folder`.
    let has_drive = cfg!(windows) && decoded.as_bytes().get(2) == Some(&b':');
    Ok(PathBuf::from(if has_drive { &decoded[1..] } else { &decoded }))
}

/// Decodes `%20` and the like.
fn decoded(text: &str) -> Option<String> {
    let mut bytes = Vec::with_capacity(text.len());
    let mut rest = text.as_bytes();
    while let [first, tail @ ..] = rest {
        if *first == b'%' {
            let digits = std::str::from_utf8(tail.get(..2)?).ok()?;
            bytes.push(u8::from_str_radix(digits, 16).ok()?);
            rest = &tail[2..];
        } else {
            bytes.push(*first);
            rest = tail;
        }
    }
    String::from_utf8(bytes).ok()
}

/// Logs a message to the host.
pub(super) fn log2(
    logger: Logger,
    (environment, name): (Environment, &CString),
    status: Status,
    (category, message): (&CString, &CString),
) {
    // SAFETY: the host gave this function for these arguments, and the strings live until it
    // returns. The format takes the message as it is.
    unsafe {
        let format = c"%s".as_ptr();
        logger(environment, name.as_ptr(), status, category.as_ptr(), format, message.as_ptr());
    }
}

/// Refuses a call about steps that are pending.
fn never_pending(instance: Handle, call: &str) -> Status {
    with(instance, call, |_| Err(Refusal::argument("steps are never pending")))
}

exported! {
    fn fmi2GetTypesPlatform() -> Text {
        c"default".as_ptr()
    }

    fn fmi2GetVersion() -> Text {
        c"2.0".as_ptr()
    }

    fn fmi2Instantiate(
        instanceName: Text,
        fmuType: c_int,
        fmuGUID: Text,
        fmuResourceLocation: Text,
        functions: *const CallbackFunctions,
        _visible: Boolean2,
        loggingOn: Boolean2,
    ) -> Handle {
        if functions.is_null() || !functions.is_aligned() {
            return ptr::null_mut();
        }
        // SAFETY: the host guarantees that its pointers are valid.
        let functions = unsafe { *functions };
        let CallbackFunctions { logger, environment, .. } = functions;
        // SAFETY: the host guarantees that its pointers are valid.
        let [name, token, location] = [instanceName, fmuGUID, fmuResourceLocation]
            .map(|text| unsafe { string(text) });
        let name = CString::new(name.unwrap_or_default()).unwrap_or_default();
        let host = Host::new(environment, logger.map(Log::Fmi2), None, name);
        create(host, loggingOn != 0, || {
            let token = token.ok_or_else(|| "there is no GUID".to_owned())?;
            let location = location.ok_or_else(|| "there is no resource location".to_owned())?;
            let interface = match fmuType {
                MODEL_EXCHANGE => Interface::ModelExchange,
                CO_SIMULATION => Interface::CoSimulation { event_mode: false, early_return: false },
                other => return Err(format!("there is no interface of type {other}")),
            };
            load(&folder_of(&location)?, &token, interface)
        })
    }

    fn fmi2FreeInstance(c: Handle) -> () {
        // SAFETY: the handle is a number.
        unsafe { fmi3FreeInstance(c) };
    }

    fn fmi2SetDebugLogging(
        c: Handle,
        loggingOn: Boolean2,
        nCategories: usize,
        categories: *const Text,
    ) -> Status {
        let categories = (categories, nCategories);
        // SAFETY: the host guarantees that its pointers are valid.
        unsafe { set_logging(c, "fmi2SetDebugLogging", loggingOn != 0, categories) }
    }

    fn fmi2SetupExperiment(
        c: Handle,
        toleranceDefined: Boolean2,
        tolerance: f64,
        startTime: f64,
        stopTimeDefined: Boolean2,
        stopTime: f64,
    ) -> Status {
        with(c, "fmi2SetupExperiment", |instance| {
            let tolerance = (toleranceDefined != 0).then_some(tolerance);
            let until = (stopTimeDefined != 0).then_some(stopTime);
            instance.set_up(tolerance, startTime, until)
        })
    }

    fn fmi2EnterInitializationMode(c: Handle) -> Status {
        with(c, "fmi2EnterInitializationMode", |instance| {
            let Experiment { from, until, rtol } = instance.experiment();
            instance.enter_initialization(Some(rtol), from, Some(until))
        })
    }

    fn fmi2ExitInitializationMode(c: Handle) -> Status {
        with(c, "fmi2ExitInitializationMode", Instance::exit_initialization)
    }

    fn fmi2Terminate(c: Handle) -> Status {
        with(c, "fmi2Terminate", Instance::terminate)
    }

    fn fmi2Reset(c: Handle) -> Status {
        reset(c, "fmi2Reset")
    }

    fn fmi2GetReal(c: Handle, vr: *const ValueReference, nvr: usize, value: *mut f64) -> Status {
        with(c, "fmi2GetReal", |instance| {
            // SAFETY: the host guarantees that its pointers are valid.
            let (references, values) = unsafe { (read(vr, nvr)?, write(value, nvr)?) };
            instance.get(Type::Float64, references, values)
        })
    }

    fn fmi2SetReal(c: Handle, vr: *const ValueReference, nvr: usize, value: *const f64) -> Status {
        with(c, "fmi2SetReal", |instance| {
            // SAFETY: the host guarantees that its pointers are valid.
            let (references, values) = unsafe { (read(vr, nvr)?, read(value, nvr)?) };
            instance.set(Type::Float64, references, values)
        })
    }

    fn fmi2GetInteger(c: Handle, vr: *const ValueReference, nvr: usize, value: *mut c_int) -> Status {
        with(c, "fmi2GetInteger", |instance| {
            // SAFETY: the host guarantees that its pointers are valid.
            let (references, values) = unsafe { (read(vr, nvr)?, write(value, nvr)?) };
            let mut numbers = vec![0.0; values.len()];
            instance.get(Type::Int32, references, &mut numbers)?;
            for (value, number) in values.iter_mut().zip(numbers) {
                *value = number.round() as c_int;
            }
            Ok(())
        })
    }

    fn fmi2SetInteger(
        c: Handle,
        vr: *const ValueReference,
        nvr: usize,
        value: *const c_int,
    ) -> Status {
        with(c, "fmi2SetInteger", |instance| {
            // SAFETY: the host guarantees that its pointers are valid.
            let (references, values) = unsafe { (read(vr, nvr)?, read(value, nvr)?) };
            let numbers: Vec<f64> = values.iter().map(|value| f64::from(*value)).collect();
            instance.set(Type::Int32, references, &numbers)
        })
    }

    fn fmi2GetFMUstate(c: Handle, FMUstate: *mut StateHandle) -> Status {
        // SAFETY: the host guarantees that its pointers are valid.
        unsafe { fmi3GetFMUState(c, FMUstate) }
    }

    fn fmi2SetFMUstate(c: Handle, FMUstate: StateHandle) -> Status {
        // SAFETY: the handle is a number.
        unsafe { fmi3SetFMUState(c, FMUstate) }
    }

    fn fmi2FreeFMUstate(c: Handle, FMUstate: *mut StateHandle) -> Status {
        // SAFETY: the host guarantees that its pointers are valid.
        unsafe { fmi3FreeFMUState(c, FMUstate) }
    }

    fn fmi2SerializedFMUstateSize(c: Handle, FMUstate: StateHandle, size: *mut usize) -> Status {
        // SAFETY: the host guarantees that its pointers are valid.
        unsafe { super::fmi3SerializedFMUStateSize(c, FMUstate, size) }
    }

    fn fmi2SerializeFMUstate(
        c: Handle,
        FMUstate: StateHandle,
        serializedState: *mut c_char,
        size: usize,
    ) -> Status {
        // SAFETY: the host guarantees that its pointers are valid.
        unsafe { super::fmi3SerializeFMUState(c, FMUstate, serializedState.cast(), size) }
    }

    fn fmi2DeSerializeFMUstate(
        c: Handle,
        serializedState: *const c_char,
        size: usize,
        FMUstate: *mut StateHandle,
    ) -> Status {
        // SAFETY: the host guarantees that its pointers are valid.
        unsafe { super::fmi3DeserializeFMUState(c, serializedState.cast(), size, FMUstate) }
    }

    fn fmi2GetDirectionalDerivative(
        c: Handle,
        vUnknown_ref: *const ValueReference,
        nUnknown: usize,
        vKnown_ref: *const ValueReference,
        nKnown: usize,
        dvKnown: *const f64,
        dvUnknown: *mut f64,
    ) -> Status {
        with(c, "fmi2GetDirectionalDerivative", |instance| {
            // SAFETY: the host guarantees that its pointers are valid.
            let (of, seed, sensitivity) = unsafe {
                let of = (read(vUnknown_ref, nUnknown)?, read(vKnown_ref, nKnown)?);
                (of, read(dvKnown, nKnown)?, write(dvUnknown, nUnknown)?)
            };
            instance.directional_derivative(of, seed, sensitivity)
        })
    }

    fn fmi2EnterEventMode(c: Handle) -> Status {
        with(c, "fmi2EnterEventMode", Instance::enter_event_mode)
    }

    fn fmi2NewDiscreteStates(c: Handle, fmi2eventInfo: *mut EventInfo) -> Status {
        with_held(c, "fmi2NewDiscreteStates", |held| {
            let (update, time) = {
                let mut instance = held.lock();
                (instance.update_discrete_states()?, instance.time())
            };
            let info = EventInfo {
                values_changed: update.moves.into(),
                next_event_time_defined: update.next.is_some().into(),
                next_event_time: update.next.unwrap_or(0.0),
                ..EventInfo::default()
            };
            // SAFETY: the host guarantees that its pointers are valid.
            unsafe { put(fmi2eventInfo, info) };
            held.host.tell_of_events(time, &update.events);
            Ok(())
        })
    }

    fn fmi2EnterContinuousTimeMode(c: Handle) -> Status {
        with(c, "fmi2EnterContinuousTimeMode", Instance::enter_continuous_time)
    }

    fn fmi2CompletedIntegratorStep(
        c: Handle,
        _noSetFMUStatePriorToCurrentPoint: Boolean2,
        enterEventMode: *mut Boolean2,
        terminateSimulation: *mut Boolean2,
    ) -> Status {
        with(c, "fmi2CompletedIntegratorStep", |instance| {
            let asks = instance.completed_step()?;
            // SAFETY: the host guarantees that its pointers are valid.
            unsafe {
                put(enterEventMode, asks.into());
                put(terminateSimulation, 0);
            }
            Ok(())
        })
    }

    fn fmi2SetTime(c: Handle, time: f64) -> Status {
        with(c, "fmi2SetTime", |instance| {
            // This version allows it in event mode too, where time stands still.
            if instance.phase() == Phase::Event && instance.time().to_bits() == time.to_bits() {
                return Ok(());
            }
            instance.set_time(time)
        })
    }

    fn fmi2SetContinuousStates(c: Handle, x: *const f64, nx: usize) -> Status {
        with(c, "fmi2SetContinuousStates", |instance| {
            // SAFETY: the host guarantees that its pointers are valid.
            instance.set_continuous_states(unsafe { read(x, nx) }?)
        })
    }

    fn fmi2GetDerivatives(c: Handle, derivatives: *mut f64, nx: usize) -> Status {
        with(c, "fmi2GetDerivatives", |instance| {
            // SAFETY: the host guarantees that its pointers are valid.
            instance.derivatives(unsafe { write(derivatives, nx) }?)
        })
    }

    fn fmi2GetEventIndicators(c: Handle, eventIndicators: *mut f64, ni: usize) -> Status {
        with(c, "fmi2GetEventIndicators", |instance| {
            // SAFETY: the host guarantees that its pointers are valid.
            instance.event_indicators(unsafe { write(eventIndicators, ni) }?)
        })
    }

    fn fmi2GetContinuousStates(c: Handle, x: *mut f64, nx: usize) -> Status {
        with(c, "fmi2GetContinuousStates", |instance| {
            // SAFETY: the host guarantees that its pointers are valid.
            instance.continuous_states(unsafe { write(x, nx) }?)
        })
    }

    fn fmi2GetNominalsOfContinuousStates(c: Handle, x_nominal: *mut f64, nx: usize) -> Status {
        with(c, "fmi2GetNominalsOfContinuousStates", |instance| {
            // SAFETY: the host guarantees that its pointers are valid.
            instance.nominals(unsafe { write(x_nominal, nx) }?)
        })
    }

    fn fmi2DoStep(
        c: Handle,
        currentCommunicationPoint: f64,
        communicationStepSize: f64,
        _noSetFMUStatePriorToCurrentPoint: Boolean2,
    ) -> Status {
        with(c, "fmi2DoStep", |instance| {
            let step = instance.begin_step(currentCommunicationPoint, communicationStepSize)?;
            let stepped = step.take(None);
            instance.end_step(&step, stepped.as_ref().ok());
            stepped.map(|_| ())
        })
    }

    fn fmi2CancelStep(c: Handle) -> Status {
        never_pending(c, "fmi2CancelStep")
    }

    fn fmi2GetStatus(c: Handle, _s: c_int, _value: *mut Status) -> Status {
        never_pending(c, "fmi2GetStatus")
    }

    fn fmi2GetStringStatus(c: Handle, _s: c_int, _value: *mut Text) -> Status {
        never_pending(c, "fmi2GetStringStatus")
    }

    fn fmi2GetIntegerStatus(c: Handle, _s: c_int, _value: *mut c_int) -> Status {
        with(c, "fmi2GetIntegerStatus", |_| Err(Refusal::argument("there is no such status")))
    }

    fn fmi2GetRealStatus(c: Handle, s: c_int, value: *mut f64) -> Status {
        with(c, "fmi2GetRealStatus", |instance| {
            if s != LAST_SUCCESSFUL_TIME {
                return Err(Refusal::argument("there is no such status"));
            }
            // SAFETY: the host guarantees that its pointers are valid.
            unsafe { put(value, instance.time()) };
            Ok(())
        })
    }

    fn fmi2GetBooleanStatus(c: Handle, s: c_int, value: *mut Boolean2) -> Status {
        with(c, "fmi2GetBooleanStatus", |_| {
            if s != TERMINATED {
                return Err(Refusal::argument("there is no such status"));
            }
            // SAFETY: the host guarantees that its pointers are valid.
            unsafe { put(value, 0) };
            Ok(())
        })
    }

    fn fmi2SetRealInputDerivatives(
        c: Handle,
        _vr: *const ValueReference,
        nvr: usize,
        _order: *const c_int,
        _value: *const f64,
    ) -> Status {
        with(c, "fmi2SetRealInputDerivatives", |_| match nvr {
            0 => Ok(()),
            _ => Err(Refusal::argument("inputs are not interpolated")),
        })
    }

    fn fmi2GetRealOutputDerivatives(
        c: Handle,
        vr: *const ValueReference,
        nvr: usize,
        order: *const c_int,
        value: *mut f64,
    ) -> Status {
        with(c, "fmi2GetRealOutputDerivatives", |instance| {
            // SAFETY: the host guarantees that its pointers are valid.
            let (references, orders, values) =
                unsafe { (read(vr, nvr)?, read(order, nvr)?, write(value, nvr)?) };
            instance.output_derivatives(references, orders, values)
        })
    }
}

/// Defines functions for types that no variable has.
macro_rules! none_of_type {
    ($($get:ident $set:ident $type:ty;)*) => {
        exported! {
            $(
                fn $get(
                    c: Handle,
                    _vr: *const ValueReference,
                    nvr: usize,
                    _value: *mut $type,
                ) -> Status {
                    with(c, stringify!($get), |_| super::values::require_none(nvr))
                }

                fn $set(
                    c: Handle,
                    _vr: *const ValueReference,
                    nvr: usize,
                    _value: *const $type,
                ) -> Status {
                    with(c, stringify!($set), |_| super::values::require_none(nvr))
                }
            )*
        }
    };
}

none_of_type! {
    fmi2GetBoolean fmi2SetBoolean Boolean2;
    fmi2GetString fmi2SetString Text;
}

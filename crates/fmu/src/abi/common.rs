//! Functions that create, free and initialize instances and change their modes.

use std::ffi::{CString, c_void};
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::{Path, PathBuf};
use std::ptr;
use std::sync::Arc;
use std::sync::atomic::Ordering;

use super::{
    Boolean, CATEGORIES, EVENTS, Environment, Handle, Host, INSTANCES, IntermediateUpdate, Log,
    LogMessage, Status, Text, ValueReference, exported, message_of, put, read, string, with,
    with_held,
};
use crate::instance::{Instance, Interface, Refusal};
use crate::resource::Machine;

/// Arguments of an instantiation.
struct Asked {
    name: Text,
    token: Text,
    resources: Text,
    logging: Boolean,
    environment: Environment,
    log: Option<LogMessage>,
    update: Option<IntermediateUpdate>,
}

/// Creates an instance. Returns null and logs a message to the host on failure.
///
/// # Safety
/// Strings are null or end with a zero.
unsafe fn instantiate(asked: &Asked, interface: Interface) -> Handle {
    // SAFETY: guaranteed by the caller.
    let [name, token, resources] =
        [asked.name, asked.token, asked.resources].map(|text| unsafe { string(text) });
    let name = CString::new(name.unwrap_or_default()).unwrap_or_default();
    let host = Host::new(asked.environment, asked.log.map(Log::Fmi3), asked.update, name);
    create(host, asked.logging != 0, || {
        let token = token.ok_or_else(|| "there is no instantiation token".to_owned())?;
        let folder = resources.ok_or_else(|| "there is no resource path".to_owned())?;
        load(&PathBuf::from(folder), &token, interface)
    })
}

/// Returns a new instance of the machine of a resource folder.
pub(super) fn load(folder: &Path, token: &str, interface: Interface) -> Result<Instance, String> {
    let machine = Machine::load(folder, token).map_err(|error| error.to_string())?;
    Ok(Instance::new(Arc::new(machine), interface))
}

/// Gives an instance to a host. Returns null and logs a message to the host on failure.
pub(super) fn create(
    host: Host,
    wants_events: bool,
    make: impl FnOnce() -> Result<Instance, String>,
) -> Handle {
    let message = match catch_unwind(AssertUnwindSafe(make)) {
        Ok(Ok(instance)) => {
            host.wants_events.store(wants_events, Ordering::Relaxed);
            return ptr::without_provenance_mut::<c_void>(INSTANCES.hold(instance, host));
        }
        Ok(Err(message)) => message,
        Err(panic) => message_of(&*panic).to_owned(),
    };
    host.refuse(&message);
    ptr::null_mut()
}

/// Sets the categories of messages that the host wants.
///
/// # Safety
/// As [`read`]; strings are null or end with a zero.
pub(super) unsafe fn set_logging(
    instance: Handle,
    call: &str,
    is_on: bool,
    (categories, count): (*const Text, usize),
) -> Status {
    with_held(instance, call, |held| {
        // SAFETY: guaranteed by the caller.
        let names = unsafe { read(categories, count) }?;
        let mut wants_events = names.is_empty();
        for name in names {
            // SAFETY: guaranteed by the caller.
            let name = unsafe { string(*name) }.unwrap_or_default();
            if !CATEGORIES.iter().any(|(known, _)| *known == name) {
                return Err(Refusal::argument(format!("there is no category `{name}`")));
            }
            wants_events |= name == EVENTS;
        }
        held.host.wants_events.store(is_on && wants_events, Ordering::Relaxed);
        Ok(())
    })
}

/// Puts an instance back to its state after instantiation.
pub(super) fn reset(instance: Handle, call: &str) -> Status {
    with_held(instance, call, |held| {
        held.lock().reset()?;
        held.host.is_broken.store(false, Ordering::Relaxed);
        Ok(())
    })
}

exported! {
    fn fmi3GetVersion() -> Text {
        c"3.0".as_ptr()
    }

    fn fmi3InstantiateModelExchange(
        instanceName: Text,
        instantiationToken: Text,
        resourcePath: Text,
        _visible: Boolean,
        loggingOn: Boolean,
        instanceEnvironment: Environment,
        logMessage: Option<LogMessage>,
    ) -> Handle {
        let asked = Asked {
            name: instanceName,
            token: instantiationToken,
            resources: resourcePath,
            logging: loggingOn,
            environment: instanceEnvironment,
            log: logMessage,
            update: None,
        };
        // SAFETY: the host guarantees that its pointers are valid.
        unsafe { instantiate(&asked, Interface::ModelExchange) }
    }

    fn fmi3InstantiateCoSimulation(
        instanceName: Text,
        instantiationToken: Text,
        resourcePath: Text,
        _visible: Boolean,
        loggingOn: Boolean,
        eventModeUsed: Boolean,
        earlyReturnAllowed: Boolean,
        _requiredIntermediateVariables: *const ValueReference,
        _nRequiredIntermediateVariables: usize,
        instanceEnvironment: Environment,
        logMessage: Option<LogMessage>,
        intermediateUpdate: Option<IntermediateUpdate>,
    ) -> Handle {
        let asked = Asked {
            name: instanceName,
            token: instantiationToken,
            resources: resourcePath,
            logging: loggingOn,
            environment: instanceEnvironment,
            log: logMessage,
            update: intermediateUpdate,
        };
        let interface = Interface::CoSimulation {
            event_mode: eventModeUsed != 0,
            early_return: earlyReturnAllowed != 0,
        };
        // SAFETY: the host guarantees that its pointers are valid.
        unsafe { instantiate(&asked, interface) }
    }

    fn fmi3InstantiateScheduledExecution(
        _instanceName: Text,
        _instantiationToken: Text,
        _resourcePath: Text,
        _visible: Boolean,
        _loggingOn: Boolean,
        instanceEnvironment: Environment,
        logMessage: Option<LogMessage>,
        _clockUpdate: *const c_void,
        _lockPreemption: *const c_void,
        _unlockPreemption: *const c_void,
    ) -> Handle {
        let host =
            Host::new(instanceEnvironment, logMessage.map(Log::Fmi3), None, CString::default());
        host.refuse("there is no scheduled execution");
        ptr::null_mut()
    }

    fn fmi3FreeInstance(instance: Handle) -> () {
        INSTANCES.free(instance.addr());
    }

    fn fmi3SetDebugLogging(
        instance: Handle,
        loggingOn: Boolean,
        nCategories: usize,
        categories: *const Text,
    ) -> Status {
        let categories = (categories, nCategories);
        // SAFETY: the host guarantees that its pointers are valid.
        unsafe { set_logging(instance, "fmi3SetDebugLogging", loggingOn != 0, categories) }
    }

    fn fmi3EnterInitializationMode(
        instance: Handle,
        toleranceDefined: Boolean,
        tolerance: f64,
        startTime: f64,
        stopTimeDefined: Boolean,
        stopTime: f64,
    ) -> Status {
        with(instance, "fmi3EnterInitializationMode", |instance| {
            let tolerance = (toleranceDefined != 0).then_some(tolerance);
            let until = (stopTimeDefined != 0).then_some(stopTime);
            instance.enter_initialization(tolerance, startTime, until)
        })
    }

    fn fmi3ExitInitializationMode(instance: Handle) -> Status {
        with(instance, "fmi3ExitInitializationMode", Instance::exit_initialization)
    }

    fn fmi3EnterEventMode(instance: Handle) -> Status {
        with(instance, "fmi3EnterEventMode", Instance::enter_event_mode)
    }

    fn fmi3UpdateDiscreteStates(
        instance: Handle,
        discreteStatesNeedUpdate: *mut Boolean,
        terminateSimulation: *mut Boolean,
        nominalsOfContinuousStatesChanged: *mut Boolean,
        valuesOfContinuousStatesChanged: *mut Boolean,
        nextEventTimeDefined: *mut Boolean,
        nextEventTime: *mut f64,
    ) -> Status {
        with_held(instance, "fmi3UpdateDiscreteStates", |held| {
            let (update, time) = {
                let mut instance = held.lock();
                (instance.update_discrete_states()?, instance.time())
            };
            // SAFETY: the host guarantees that its pointers are valid.
            unsafe {
                put(discreteStatesNeedUpdate, 0);
                put(terminateSimulation, 0);
                put(nominalsOfContinuousStatesChanged, 0);
                put(valuesOfContinuousStatesChanged, update.moves.into());
                put(nextEventTimeDefined, update.next.is_some().into());
                put(nextEventTime, update.next.unwrap_or(0.0));
            }
            held.host.tell_of_events(time, &update.events);
            Ok(())
        })
    }

    fn fmi3Terminate(instance: Handle) -> Status {
        with(instance, "fmi3Terminate", Instance::terminate)
    }

    fn fmi3Reset(instance: Handle) -> Status {
        reset(instance, "fmi3Reset")
    }
}

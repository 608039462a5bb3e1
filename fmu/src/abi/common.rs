//! Functions that create, free and initialize instances and change their modes.

use std::ffi::{CString, c_void};
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::PathBuf;
use std::ptr;
use std::sync::Arc;
use std::sync::atomic::Ordering;

use super::{
    Boolean, CATEGORIES, ERRORS, EVENTS, Environment, Handle, Host, INSTANCES, IntermediateUpdate,
    Log, LogMessage, Status, Text, ValueReference, exported, message_of, put, read, string, tell,
    with, with_held,
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
    let Asked { environment, log, .. } = *asked;
    let made = catch_unwind(AssertUnwindSafe(|| {
        // SAFETY: guaranteed by the caller.
        let [name, token, resources] =
            [asked.name, asked.token, asked.resources].map(|text| unsafe { string(text) });
        let token = token.ok_or_else(|| "there is no instantiation token".to_owned())?;
        let folder = resources.ok_or_else(|| "there is no resource path".to_owned())?;
        let machine = Machine::load(&PathBuf::from(folder), &token).map_err(|e| e.to_string())?;
        let instance = Instance::new(Arc::new(machine), interface);
        let name = CString::new(name.unwrap_or_default()).unwrap_or_default();
        let host = Host::new(environment, log.map(Log::Fmi3), asked.update, name);
        host.wants_events.store(asked.logging != 0, Ordering::Relaxed);
        Ok(INSTANCES.hold(instance, host))
    }));
    let message: String = match made {
        Ok(Ok(handle)) => return ptr::without_provenance_mut::<c_void>(handle),
        Ok(Err(message)) => message,
        Err(panic) => message_of(&*panic).to_owned(),
    };
    if let Some(log) = log {
        tell(log, environment, Status::Error, ERRORS, &format!("not instantiated: {message}"));
    }
    ptr::null_mut()
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
        if let Some(log) = logMessage {
            let message = "not instantiated: there is no scheduled execution";
            tell(log, instanceEnvironment, Status::Error, ERRORS, message);
        }
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
        with_held(instance, "fmi3SetDebugLogging", |held| {
            // SAFETY: the host guarantees that its pointers are valid.
            let names = unsafe { read(categories, nCategories) }?;
            let mut wants_events = names.is_empty();
            for name in names {
                // SAFETY: the host guarantees that its pointers are valid.
                let name = unsafe { string(*name) }.unwrap_or_default();
                if !CATEGORIES.iter().any(|(known, _)| *known == name) {
                    return Err(Refusal::argument(format!("there is no category `{name}`")));
                }
                wants_events |= name == EVENTS;
            }
            held.host.wants_events.store(loggingOn != 0 && wants_events, Ordering::Relaxed);
            Ok(())
        })
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
        with_held(instance, "fmi3Reset", |held| {
            held.lock().reset()?;
            held.host.is_broken.store(false, Ordering::Relaxed);
            Ok(())
        })
    }
}

//! Functions of Model Exchange.

use super::{Boolean, Handle, Status, exported, put, read, with, write};
use crate::instance::Instance;

exported! {
    fn fmi3EnterContinuousTimeMode(instance: Handle) -> Status {
        with(instance, "fmi3EnterContinuousTimeMode", Instance::enter_continuous_time)
    }

    fn fmi3CompletedIntegratorStep(
        instance: Handle,
        _noSetFMUStatePriorToCurrentPoint: Boolean,
        enterEventMode: *mut Boolean,
        terminateSimulation: *mut Boolean,
    ) -> Status {
        with(instance, "fmi3CompletedIntegratorStep", |instance| {
            let asks = instance.completed_step()?;
            // SAFETY: the host guarantees that its pointers are valid.
            unsafe {
                put(enterEventMode, asks.into());
                put(terminateSimulation, 0);
            }
            Ok(())
        })
    }

    fn fmi3SetTime(instance: Handle, time: f64) -> Status {
        with(instance, "fmi3SetTime", |instance| instance.set_time(time))
    }

    fn fmi3SetContinuousStates(
        instance: Handle,
        continuousStates: *const f64,
        nContinuousStates: usize,
    ) -> Status {
        with(instance, "fmi3SetContinuousStates", |instance| {
            // SAFETY: the host guarantees that its pointers are valid.
            instance.set_continuous_states(unsafe { read(continuousStates, nContinuousStates) }?)
        })
    }

    fn fmi3GetContinuousStateDerivatives(
        instance: Handle,
        derivatives: *mut f64,
        nContinuousStates: usize,
    ) -> Status {
        with(instance, "fmi3GetContinuousStateDerivatives", |instance| {
            // SAFETY: the host guarantees that its pointers are valid.
            instance.derivatives(unsafe { write(derivatives, nContinuousStates) }?)
        })
    }

    fn fmi3GetEventIndicators(
        instance: Handle,
        eventIndicators: *mut f64,
        nEventIndicators: usize,
    ) -> Status {
        with(instance, "fmi3GetEventIndicators", |instance| {
            // SAFETY: the host guarantees that its pointers are valid.
            instance.event_indicators(unsafe { write(eventIndicators, nEventIndicators) }?)
        })
    }

    fn fmi3GetContinuousStates(
        instance: Handle,
        continuousStates: *mut f64,
        nContinuousStates: usize,
    ) -> Status {
        with(instance, "fmi3GetContinuousStates", |instance| {
            // SAFETY: the host guarantees that its pointers are valid.
            instance.continuous_states(unsafe { write(continuousStates, nContinuousStates) }?)
        })
    }

    fn fmi3GetNominalsOfContinuousStates(
        instance: Handle,
        nominals: *mut f64,
        nContinuousStates: usize,
    ) -> Status {
        with(instance, "fmi3GetNominalsOfContinuousStates", |instance| {
            // SAFETY: the host guarantees that its pointers are valid.
            instance.nominals(unsafe { write(nominals, nContinuousStates) }?)
        })
    }

    fn fmi3GetNumberOfEventIndicators(instance: Handle, nEventIndicators: *mut usize) -> Status {
        with(instance, "fmi3GetNumberOfEventIndicators", |instance| {
            // SAFETY: the host guarantees that its pointers are valid.
            unsafe { put(nEventIndicators, instance.machine().variables.indicators()) };
            Ok(())
        })
    }

    fn fmi3GetNumberOfContinuousStates(instance: Handle, nContinuousStates: *mut usize) -> Status {
        with(instance, "fmi3GetNumberOfContinuousStates", |instance| {
            // SAFETY: the host guarantees that its pointers are valid.
            unsafe { put(nContinuousStates, instance.machine().variables.states().len()) };
            Ok(())
        })
    }
}

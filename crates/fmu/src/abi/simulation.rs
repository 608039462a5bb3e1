//! Functions of Co-Simulation.

use super::{
    Boolean, Handle, Host, Status, ValueReference, exported, put, read, with, with_held, write,
};
use crate::instance::{Instance, Intermediate, Looks, Reply, Step};
use crate::registry::Held;

exported! {
    fn fmi3EnterStepMode(instance: Handle) -> Status {
        with(instance, "fmi3EnterStepMode", Instance::enter_step_mode)
    }

    fn fmi3GetOutputDerivatives(
        instance: Handle,
        valueReferences: *const ValueReference,
        nValueReferences: usize,
        orders: *const i32,
        values: *mut f64,
        nValues: usize,
    ) -> Status {
        with(instance, "fmi3GetOutputDerivatives", |instance| {
            // SAFETY: the host guarantees that its pointers are valid.
            let (references, orders, values) = unsafe {
                let references = read(valueReferences, nValueReferences)?;
                (references, read(orders, nValueReferences)?, write(values, nValues)?)
            };
            instance.output_derivatives(references, orders, values)
        })
    }

    fn fmi3DoStep(
        instance: Handle,
        currentCommunicationPoint: f64,
        communicationStepSize: f64,
        _noSetFMUStatePriorToCurrentPoint: Boolean,
        eventHandlingNeeded: *mut Boolean,
        terminateSimulation: *mut Boolean,
        earlyReturn: *mut Boolean,
        lastSuccessfulTime: *mut f64,
    ) -> Status {
        with_held(instance, "fmi3DoStep", |held| {
            // SAFETY: the host guarantees that its pointers are valid.
            unsafe {
                put(eventHandlingNeeded, 0);
                put(terminateSimulation, 0);
                put(earlyReturn, 0);
                put(lastSuccessfulTime, held.lock().time());
            }
            let step = {
                let mut instance = held.lock();
                instance.begin_step(currentCommunicationPoint, communicationStepSize)?
            };
            // The instance is not locked during the step, so the host can read it when called back.
            // The guard ends the step however it returns.
            let mut under_way = UnderWay { held, step: &step, stepped: None };
            let looks = |intermediate: &Intermediate<'_>| look(held, &step, intermediate);
            let looks: Option<&Looks<'_>> = match held.host.update {
                Some(_) => Some(&looks),
                None => None,
            };
            let stepped = step.take(looks)?;
            // SAFETY: the host guarantees that its pointers are valid.
            unsafe {
                put(eventHandlingNeeded, stepped.event.into());
                put(earlyReturn, stepped.early.into());
                put(lastSuccessfulTime, stepped.standing.time);
            }
            under_way.stepped = Some(stepped);
            Ok(())
        })
    }
}

/// Guard of a step that is under way, which ends the step when dropped.
struct UnderWay<'a> {
    held: &'a Held<Host>,
    step: &'a Step,
    stepped: Option<crate::instance::Stepped>,
}

impl Drop for UnderWay<'_> {
    fn drop(&mut self) {
        self.held.lock().end_step(self.step, self.stepped.as_ref());
    }
}

/// Shows the host the state within a step and returns its reply.
fn look(held: &Held<Host>, step: &Step, intermediate: &Intermediate<'_>) -> Reply {
    let Some(update) = held.host.update else { return Reply::default() };
    let before = {
        let mut instance = held.lock();
        instance.show(intermediate.standing);
        instance.parameters().to_vec()
    };
    let (mut wants, mut end) = (0, intermediate.time);
    let (sets, may_return) = (step.has_inputs.into(), step.may_return_early.into());
    // SAFETY: the host gave this function for these arguments.
    unsafe {
        update(
            held.host.environment(),
            intermediate.time,
            sets,
            1,
            1,
            may_return,
            &raw mut wants,
            &raw mut end,
        );
    }
    let after = held.lock().parameters().to_vec();
    let is_same = before.iter().zip(&after).all(|(a, b)| a.to_bits() == b.to_bits());
    let end = (wants != 0 && step.may_return_early && end.is_finite()).then_some(end);
    Reply { parameters: (!is_same).then_some(after), end }
}

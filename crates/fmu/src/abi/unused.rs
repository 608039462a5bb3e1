//! Functions for features that no archive of Machinist has: clocks, structural parameters and
//! scheduled execution.

use super::{Handle, Status, ValueReference, exported, with};
use crate::instance::{Instance, Refusal};

/// Defines functions that ask about clocks.
macro_rules! of_clocks {
    ($($name:ident($($argument:ident: $type:ty),*);)*) => {
        exported! {
            $(
                fn $name(
                    instance: Handle,
                    _valueReferences: *const ValueReference,
                    nValueReferences: usize,
                    $($argument: $type),*
                ) -> Status {
                    with(instance, stringify!($name), |_| match nValueReferences {
                        0 => Ok(()),
                        _ => Err(Refusal::argument("there are no clocks")),
                    })
                }
            )*
        }
    };
}

of_clocks! {
    fmi3GetIntervalDecimal(_intervals: *mut f64, _qualifiers: *mut i32);
    fmi3GetIntervalFraction(
        _counters: *mut u64,
        _resolutions: *mut u64,
        _qualifiers: *mut i32
    );
    fmi3GetShiftDecimal(_shifts: *mut f64);
    fmi3GetShiftFraction(_counters: *mut u64, _resolutions: *mut u64);
    fmi3SetIntervalDecimal(_intervals: *const f64);
    fmi3SetIntervalFraction(_counters: *const u64, _resolutions: *const u64);
    fmi3SetShiftDecimal(_shifts: *const f64);
    fmi3SetShiftFraction(_counters: *const u64, _resolutions: *const u64);
}

exported! {
    fn fmi3EnterConfigurationMode(instance: Handle) -> Status {
        with(instance, "fmi3EnterConfigurationMode", no_structure)
    }

    fn fmi3ExitConfigurationMode(instance: Handle) -> Status {
        with(instance, "fmi3ExitConfigurationMode", no_structure)
    }

    fn fmi3EvaluateDiscreteStates(instance: Handle) -> Status {
        with(instance, "fmi3EvaluateDiscreteStates", |_| {
            Err(Refusal::argument("discrete states are not evaluated without being updated"))
        })
    }

    fn fmi3ActivateModelPartition(
        instance: Handle,
        _clockReference: ValueReference,
        _activationTime: f64,
    ) -> Status {
        with(instance, "fmi3ActivateModelPartition", |_| {
            Err(Refusal::argument("there is no scheduled execution"))
        })
    }
}

fn no_structure(_: &mut Instance) -> Result<(), Refusal> {
    Err(Refusal::argument("there are no structural parameters"))
}

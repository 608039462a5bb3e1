//! Functions for partial derivatives and dependencies.

use super::{Handle, Status, ValueReference, exported, read, with, write};
use crate::instance::Refusal;

exported! {
    fn fmi3GetDirectionalDerivative(
        instance: Handle,
        unknowns: *const ValueReference,
        nUnknowns: usize,
        knowns: *const ValueReference,
        nKnowns: usize,
        seed: *const f64,
        nSeed: usize,
        sensitivity: *mut f64,
        nSensitivity: usize,
    ) -> Status {
        with(instance, "fmi3GetDirectionalDerivative", |instance| {
            // SAFETY: the host guarantees that its pointers are valid.
            let (of, seed, sensitivity) = unsafe {
                let of = (read(unknowns, nUnknowns)?, read(knowns, nKnowns)?);
                (of, read(seed, nSeed)?, write(sensitivity, nSensitivity)?)
            };
            instance.directional_derivative(of, seed, sensitivity)
        })
    }

    fn fmi3GetAdjointDerivative(
        instance: Handle,
        unknowns: *const ValueReference,
        nUnknowns: usize,
        knowns: *const ValueReference,
        nKnowns: usize,
        seed: *const f64,
        nSeed: usize,
        sensitivity: *mut f64,
        nSensitivity: usize,
    ) -> Status {
        with(instance, "fmi3GetAdjointDerivative", |instance| {
            // SAFETY: the host guarantees that its pointers are valid.
            let (of, seed, sensitivity) = unsafe {
                let of = (read(unknowns, nUnknowns)?, read(knowns, nKnowns)?);
                (of, read(seed, nSeed)?, write(sensitivity, nSensitivity)?)
            };
            instance.adjoint_derivative(of, seed, sensitivity)
        })
    }

    fn fmi3GetNumberOfVariableDependencies(
        instance: Handle,
        _valueReference: ValueReference,
        _nDependencies: *mut usize,
    ) -> Status {
        with(instance, "fmi3GetNumberOfVariableDependencies", |_| Err(of_description()))
    }

    fn fmi3GetVariableDependencies(
        instance: Handle,
        _dependent: ValueReference,
        _elementIndicesOfDependent: *mut usize,
        _independents: *mut ValueReference,
        _elementIndicesOfIndependents: *mut usize,
        _dependencyKinds: *mut i32,
        _nDependencies: usize,
    ) -> Status {
        with(instance, "fmi3GetVariableDependencies", |_| Err(of_description()))
    }
}

fn of_description() -> Refusal {
    Refusal::argument("dependencies do not change: the description has all of them")
}

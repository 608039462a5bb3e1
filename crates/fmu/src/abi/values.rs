//! Functions that get and set values of variables, by type.

use super::{Boolean, Handle, Status, Text, ValueReference, exported, read, with, write};
use crate::instance::{Refusal, Type};

exported! {
    fn fmi3GetFloat64(
        instance: Handle,
        valueReferences: *const ValueReference,
        nValueReferences: usize,
        values: *mut f64,
        nValues: usize,
    ) -> Status {
        with(instance, "fmi3GetFloat64", |instance| {
            // SAFETY: the host guarantees that its pointers are valid.
            let (references, values) =
                unsafe { (read(valueReferences, nValueReferences)?, write(values, nValues)?) };
            instance.get(Type::Float64, references, values)
        })
    }

    fn fmi3SetFloat64(
        instance: Handle,
        valueReferences: *const ValueReference,
        nValueReferences: usize,
        values: *const f64,
        nValues: usize,
    ) -> Status {
        with(instance, "fmi3SetFloat64", |instance| {
            // SAFETY: the host guarantees that its pointers are valid.
            let (references, values) =
                unsafe { (read(valueReferences, nValueReferences)?, read(values, nValues)?) };
            instance.set(Type::Float64, references, values)
        })
    }

    fn fmi3GetInt32(
        instance: Handle,
        valueReferences: *const ValueReference,
        nValueReferences: usize,
        values: *mut i32,
        nValues: usize,
    ) -> Status {
        with(instance, "fmi3GetInt32", |instance| {
            // SAFETY: the host guarantees that its pointers are valid.
            let (references, values) =
                unsafe { (read(valueReferences, nValueReferences)?, write(values, nValues)?) };
            let mut numbers = vec![0.0; values.len()];
            instance.get(Type::Int32, references, &mut numbers)?;
            for (value, number) in values.iter_mut().zip(numbers) {
                *value = number.round() as i32;
            }
            Ok(())
        })
    }

    fn fmi3SetInt32(
        instance: Handle,
        valueReferences: *const ValueReference,
        nValueReferences: usize,
        values: *const i32,
        nValues: usize,
    ) -> Status {
        with(instance, "fmi3SetInt32", |instance| {
            // SAFETY: the host guarantees that its pointers are valid.
            let (references, values) =
                unsafe { (read(valueReferences, nValueReferences)?, read(values, nValues)?) };
            let numbers: Vec<f64> = values.iter().map(|value| f64::from(*value)).collect();
            instance.set(Type::Int32, references, &numbers)
        })
    }
}

/// Defines functions for types that no variable has.
macro_rules! none_of_type {
    ($($get:ident $set:ident $type:ty;)*) => {
        exported! {
            $(
                fn $get(
                    instance: Handle,
                    _valueReferences: *const ValueReference,
                    nValueReferences: usize,
                    _values: *mut $type,
                    _nValues: usize,
                ) -> Status {
                    with(instance, stringify!($get), |_| require_none(nValueReferences))
                }

                fn $set(
                    instance: Handle,
                    _valueReferences: *const ValueReference,
                    nValueReferences: usize,
                    _values: *const $type,
                    _nValues: usize,
                ) -> Status {
                    with(instance, stringify!($set), |_| require_none(nValueReferences))
                }
            )*
        }
    };
}

none_of_type! {
    fmi3GetFloat32 fmi3SetFloat32 f32;
    fmi3GetInt8 fmi3SetInt8 i8;
    fmi3GetUInt8 fmi3SetUInt8 u8;
    fmi3GetInt16 fmi3SetInt16 i16;
    fmi3GetUInt16 fmi3SetUInt16 u16;
    fmi3GetUInt32 fmi3SetUInt32 u32;
    fmi3GetInt64 fmi3SetInt64 i64;
    fmi3GetUInt64 fmi3SetUInt64 u64;
    fmi3GetBoolean fmi3SetBoolean Boolean;
    fmi3GetString fmi3SetString Text;
}

exported! {
    fn fmi3GetBinary(
        instance: Handle,
        _valueReferences: *const ValueReference,
        nValueReferences: usize,
        _valueSizes: *mut usize,
        _values: *mut *const u8,
        _nValues: usize,
    ) -> Status {
        with(instance, "fmi3GetBinary", |_| require_none(nValueReferences))
    }

    fn fmi3SetBinary(
        instance: Handle,
        _valueReferences: *const ValueReference,
        nValueReferences: usize,
        _valueSizes: *const usize,
        _values: *const *const u8,
        _nValues: usize,
    ) -> Status {
        with(instance, "fmi3SetBinary", |_| require_none(nValueReferences))
    }

    fn fmi3GetClock(
        instance: Handle,
        _valueReferences: *const ValueReference,
        nValueReferences: usize,
        _values: *mut Boolean,
    ) -> Status {
        with(instance, "fmi3GetClock", |_| require_none(nValueReferences))
    }

    fn fmi3SetClock(
        instance: Handle,
        _valueReferences: *const ValueReference,
        nValueReferences: usize,
        _values: *const Boolean,
    ) -> Status {
        with(instance, "fmi3SetClock", |_| require_none(nValueReferences))
    }
}

/// Returns an error unless no variables of the type are asked for.
pub(super) fn require_none(count: usize) -> Result<(), Refusal> {
    if count == 0 { Ok(()) } else { Err(Refusal::argument("there are no variables of this type")) }
}

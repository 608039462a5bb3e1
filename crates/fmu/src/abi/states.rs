//! Functions that keep, restore, serialize and deserialize states of an instance.

use std::ptr;

use super::{Handle, StateHandle, Status, exported, put, read, with, write};
use crate::instance::Refusal;

exported! {
    fn fmi3GetFMUState(instance: Handle, FMUState: *mut StateHandle) -> Status {
        with(instance, "fmi3GetFMUState", |instance| {
            // SAFETY: the host guarantees that its pointers are valid.
            let kept = unsafe { write(FMUState, 1) }?;
            let before = kept[0].addr();
            let handle = instance.keep((before != 0).then_some(before))?;
            kept[0] = ptr::without_provenance_mut(handle);
            Ok(())
        })
    }

    fn fmi3SetFMUState(instance: Handle, FMUState: StateHandle) -> Status {
        with(instance, "fmi3SetFMUState", |instance| instance.return_to(FMUState.addr()))
    }

    fn fmi3FreeFMUState(instance: Handle, FMUState: *mut StateHandle) -> Status {
        with(instance, "fmi3FreeFMUState", |instance| {
            if FMUState.is_null() {
                return Ok(());
            }
            // SAFETY: the host guarantees that its pointers are valid.
            let kept = unsafe { write(FMUState, 1) }?;
            if !kept[0].is_null() {
                instance.forget(kept[0].addr())?;
                kept[0] = ptr::null_mut();
            }
            Ok(())
        })
    }

    fn fmi3SerializedFMUStateSize(
        instance: Handle,
        FMUState: StateHandle,
        size: *mut usize,
    ) -> Status {
        with(instance, "fmi3SerializedFMUStateSize", |instance| {
            let bytes = instance.write(FMUState.addr())?;
            // SAFETY: the host guarantees that its pointers are valid.
            unsafe { put(size, bytes.len()) };
            Ok(())
        })
    }

    fn fmi3SerializeFMUState(
        instance: Handle,
        FMUState: StateHandle,
        serializedState: *mut u8,
        size: usize,
    ) -> Status {
        with(instance, "fmi3SerializeFMUState", |instance| {
            let bytes = instance.write(FMUState.addr())?;
            // SAFETY: the host guarantees that its pointers are valid.
            let into = unsafe { write(serializedState, size) }?;
            if into.len() != bytes.len() {
                let message = format!("the state has {} bytes, not {size}", bytes.len());
                return Err(Refusal::argument(message));
            }
            into.copy_from_slice(&bytes);
            Ok(())
        })
    }

    fn fmi3DeserializeFMUState(
        instance: Handle,
        serializedState: *const u8,
        size: usize,
        FMUState: *mut StateHandle,
    ) -> Status {
        with(instance, "fmi3DeserializeFMUState", |instance| {
            // SAFETY: the host guarantees that its pointers are valid.
            let (bytes, kept) = unsafe { (read(serializedState, size)?, write(FMUState, 1)?) };
            let handle = instance.read(bytes)?;
            kept[0] = ptr::without_provenance_mut(handle);
            Ok(())
        })
    }
}

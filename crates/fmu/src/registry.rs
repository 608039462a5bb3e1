//! Registry of instances by their handles.
//!
//! Hosts hold a number that looks like a pointer. It is looked up and never followed, so a host
//! that calls with a freed or invalid handle gets an error instead of a crash.

use std::collections::HashMap;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Arc, LazyLock, Mutex, MutexGuard, PoisonError, RwLock};

use crate::instance::Instance;

/// Instance and host data of a handle.
pub struct Held<H> {
    /// Instance. It is unlocked while the host is called back.
    pub instance: Mutex<Instance>,
    /// Data of the host.
    pub host: H,
}

impl<H> Held<H> {
    /// Locks the instance for one caller. A poisoned lock is safe to take: a caller that panicked
    /// has left the instance as it was, or has marked it as broken.
    pub fn lock(&self) -> MutexGuard<'_, Instance> {
        self.instance.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

/// Registry of all handles.
pub struct Registry<H> {
    held: LazyLock<RwLock<HashMap<usize, Arc<Held<H>>>>>,
    next: AtomicUsize,
}

impl<H> Registry<H> {
    /// Creates an empty registry.
    #[must_use]
    pub const fn new() -> Self {
        Self { held: LazyLock::new(RwLock::default), next: AtomicUsize::new(1) }
    }

    /// Adds an instance. Returns its handle, which is never 0 and never reused.
    pub fn hold(&self, instance: Instance, host: H) -> usize {
        // Handles are aligned as pointers to allocations, which hosts may rely on.
        let handle = self.next.fetch_add(1, Ordering::Relaxed) << 4;
        let held = Arc::new(Held { instance: Mutex::new(instance), host });
        self.held.write().unwrap_or_else(PoisonError::into_inner).insert(handle, held);
        handle
    }

    /// Returns what belongs to a handle; `None` if the handle is unknown.
    #[must_use]
    pub fn get(&self, handle: usize) -> Option<Arc<Held<H>>> {
        self.held.read().unwrap_or_else(PoisonError::into_inner).get(&handle).cloned()
    }

    /// Removes a handle. Returns whether it was known.
    pub fn free(&self, handle: usize) -> bool {
        self.held.write().unwrap_or_else(PoisonError::into_inner).remove(&handle).is_some()
    }
}

impl<H> Default for Registry<H> {
    fn default() -> Self {
        Self::new()
    }
}

//! Instances by their handles.
//!
//! What a host holds is a number that looks like a pointer. It is looked up and never followed,
//! so that a host that calls with what it has freed, or with anything else, gets an error and
//! not a crash.

use std::collections::HashMap;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Arc, LazyLock, Mutex, MutexGuard, PoisonError, RwLock};

use crate::instance::Instance;

/// What belongs to a handle.
pub struct Held<H> {
    /// The instance. It is free while the host is called back.
    pub instance: Mutex<Instance>,
    /// What of the host belongs to it.
    pub host: H,
}

impl<H> Held<H> {
    /// The instance, for one caller at a time. Who panicked before has left it as it was, or
    /// has said that it is not to be used.
    pub fn lock(&self) -> MutexGuard<'_, Instance> {
        self.instance.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

/// All that is held.
pub struct Registry<H> {
    held: LazyLock<RwLock<HashMap<usize, Arc<Held<H>>>>>,
    next: AtomicUsize,
}

impl<H> Registry<H> {
    /// An empty one.
    #[must_use]
    pub const fn new() -> Self {
        Self { held: LazyLock::new(RwLock::default), next: AtomicUsize::new(1) }
    }

    /// Takes an instance; its handle, which is not 0 and never given again.
    pub fn hold(&self, instance: Instance, host: H) -> usize {
        // As pointers to what is allocated, which hosts may rely on.
        let handle = self.next.fetch_add(1, Ordering::Relaxed) << 4;
        let held = Arc::new(Held { instance: Mutex::new(instance), host });
        self.held.write().unwrap_or_else(PoisonError::into_inner).insert(handle, held);
        handle
    }

    /// What belongs to a handle; nothing if it is none.
    #[must_use]
    pub fn get(&self, handle: usize) -> Option<Arc<Held<H>>> {
        self.held.read().unwrap_or_else(PoisonError::into_inner).get(&handle).cloned()
    }

    /// Lets go of it; whether it was held.
    pub fn free(&self, handle: usize) -> bool {
        self.held.write().unwrap_or_else(PoisonError::into_inner).remove(&handle).is_some()
    }
}

impl<H> Default for Registry<H> {
    fn default() -> Self {
        Self::new()
    }
}

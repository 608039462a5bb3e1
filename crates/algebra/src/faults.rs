//! Wrong signs on request, for tests of the generator, only with the feature `faults`: they show
//! that the second derivation finds such faults where they are made.
//!
//! A fault is identified by its name. Names of faults in this crate begin with `fold`.

/// Evaluates to `$right`; with the feature `faults`, to `$wrong` while a test injects the fault.
#[cfg(not(feature = "faults"))]
#[macro_export]
macro_rules! unless_faulty {
    ($fault:literal, $right:expr, $wrong:expr) => {
        $right
    };
}

/// Evaluates to `$right`, or to `$wrong` while a test injects the fault.
#[cfg(feature = "faults")]
#[macro_export]
macro_rules! unless_faulty {
    ($fault:literal, $right:expr, $wrong:expr) => {
        if $crate::faults::is_injected($fault) { $wrong } else { $right }
    };
}

#[cfg(feature = "faults")]
pub use injection::{carried, is_injected, with};

#[cfg(feature = "faults")]
mod injection {
    use std::cell::Cell;

    thread_local! {
        static INJECTED: Cell<Option<&'static str>> = const { Cell::new(None) };
    }

    /// Returns whether the fault is injected in this thread.
    #[must_use]
    pub fn is_injected(fault: &str) -> bool {
        INJECTED.get() == Some(fault)
    }

    /// Runs `work` with a fault injected in this thread.
    pub fn with<T>(fault: Option<&'static str>, work: impl FnOnce() -> T) -> T {
        struct Before(Option<&'static str>);
        impl Drop for Before {
            fn drop(&mut self) {
                INJECTED.set(self.0);
            }
        }
        let _before = Before(INJECTED.replace(fault));
        work()
    }

    /// Wraps a job for another thread, so that it runs with the fault of this one.
    pub fn carried<C, T>(job: impl FnOnce(&mut C) -> T) -> impl FnOnce(&mut C) -> T {
        let fault = INJECTED.get();
        move |context| with(fault, || job(context))
    }
}

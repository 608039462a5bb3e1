//! Wrong signs on request, for tests of the generator, by the feature `faults` and nowhere else:
//! so that the second derivation is shown to find them where they are made.
//!
//! A fault is known by its name. Those of this crate are named `fold ...`.

/// What is right; with the feature `faults` what is wrong, while a test injects the fault of
/// that name.
#[cfg(not(feature = "faults"))]
#[macro_export]
macro_rules! unless_faulty {
    ($fault:literal, $right:expr, $wrong:expr) => {
        $right
    };
}

/// What is right; what is wrong, while a test injects the fault of that name.
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

    /// Whether this thread makes the fault of that name.
    #[must_use]
    pub fn is_injected(fault: &str) -> bool {
        INJECTED.get() == Some(fault)
    }

    /// Does some work with a fault; others go on without.
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

    /// A job for another thread, with the fault of this one.
    pub fn carried<C, T>(job: impl FnOnce(&mut C) -> T) -> impl FnOnce(&mut C) -> T {
        let fault = INJECTED.get();
        move |context| with(fault, || job(context))
    }
}

//! Interruption of derivations, for programs that must stay responsive: a derivation of a large
//! machine takes minutes.
//!
//! A flag belongs to a piece of work and to the threads that derive for it. Operations of the
//! algebra look at it, and unwind to [`interruptible`] once it is set. Nothing is printed.

use std::cell::RefCell;
use std::panic::{AssertUnwindSafe, catch_unwind, resume_unwind};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

/// Result of work that was interrupted; also the payload with which it unwinds.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[error("the derivation was interrupted")]
pub struct Interrupted;

thread_local! {
    static FLAG: RefCell<Option<Arc<AtomicBool>>> = const { RefCell::new(None) };
}

/// Does `work`, until `flag` is set.
///
/// # Errors
/// [`Interrupted`] if the work ended because of the flag.
///
/// # Panics
/// With the panic of `work`, if it panics.
pub fn interruptible<T>(flag: Arc<AtomicBool>, work: impl FnOnce() -> T) -> Result<T, Interrupted> {
    match catch_unwind(AssertUnwindSafe(|| with(Some(flag), work))) {
        Ok(done) => Ok(done),
        Err(payload) if payload.is::<Interrupted>() => Err(Interrupted),
        Err(panic) => resume_unwind(panic),
    }
}

/// Unwinds if the flag of the work in this thread is set.
pub fn check() {
    let is_set = FLAG.with_borrow(|flag| flag.as_ref().is_some_and(|f| f.load(Ordering::Relaxed)));
    if is_set {
        resume_unwind(Box::new(Interrupted));
    }
}

/// Returns a job for another thread that can be interrupted like the work in this one.
pub fn carried<C, T>(job: impl FnOnce(&mut C) -> T) -> impl FnOnce(&mut C) -> T {
    let flag = FLAG.with_borrow(Clone::clone);
    move |context| with(flag, || job(context))
}

fn with<T>(flag: Option<Arc<AtomicBool>>, work: impl FnOnce() -> T) -> T {
    struct Before(Option<Arc<AtomicBool>>);
    impl Drop for Before {
        fn drop(&mut self) {
            FLAG.set(self.0.take());
        }
    }
    let _before = Before(FLAG.replace(flag));
    work()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cas::{Algebra, session};

    #[test]
    fn work_ends_once_its_flag_is_set() {
        let flag = Arc::new(AtomicBool::new(false));
        let setter = Arc::clone(&flag);
        let endless = || {
            session("endless", Algebra::Plain, move |cas| -> () {
                loop {
                    setter.store(true, Ordering::Relaxed);
                    let zero = cas.zero();
                    let _ = cas.simplify(&zero);
                }
            })
        };
        assert_eq!(interruptible(flag, endless).err(), Some(Interrupted));
    }

    #[test]
    fn other_work_goes_on() {
        let flag = Arc::new(AtomicBool::new(true));
        assert_eq!(interruptible(Arc::clone(&flag), || 1), Ok(1), "nothing looked at the flag");
        assert_eq!(interruptible(Arc::clone(&flag), check), Err(Interrupted));
        // The flag is gone with its work.
        check();
    }
}

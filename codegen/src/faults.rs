//! Wrong signs on request, in unit tests of this crate and nowhere else: so that the second
//! derivation is shown to find them where they are made.

/// What is right; in unit tests what is wrong, while a test injects the fault of that name.
#[cfg(not(test))]
macro_rules! unless_faulty {
    ($fault:ident, $right:expr, $wrong:expr) => {
        $right
    };
}

#[cfg(test)]
macro_rules! unless_faulty {
    ($fault:ident, $right:expr, $wrong:expr) => {
        if crate::faults::is_injected(crate::faults::Fault::$fault) { $wrong } else { $right }
    };
}

#[cfg(test)]
pub use injection::{ALL, Fault, carried, is_injected, with};

#[cfg(test)]
mod injection {
    use std::cell::Cell;

    thread_local! {
        static INJECTED: Cell<Option<Fault>> = const { Cell::new(None) };
    }

    /// A wrong sign, by where it is made.
    #[derive(Debug, Clone, Copy, PartialEq, Eq)]
    pub enum Fault {
        /// `lagrange`: dL/dq.
        Slope,
        /// `lagrange`: (d2L/dq' dq) q'.
        Coupling,
        /// `lagrange`: (d2L/dq' dz) h.
        ByState,
        /// `lagrange`: d2L/dq' dt.
        ByTime,
        /// `lagrange`: dD/dq'.
        Dissipation,
        /// `lagrange`: entries of M beside the diagonal.
        Inertia,
        /// `constraint`: gamma.
        Gamma,
        /// `constraint`: dg/dt.
        Moving,
        /// `constraint`: an entry of G.
        Border,
        /// `reduce`: numbers in place of parameters.
        Fixed,
        /// `reduce`: the rate of a relative position.
        Relative,
        /// `reduce`: an output of a position that others are relative to.
        Absolute,
        /// `reduce`: forces on what is sliced.
        Sliced,
        /// `fold`: a - (-b).
        FoldSub,
        /// `fold`: (-a) b.
        FoldMul,
        /// `fold`: a/(-b).
        FoldDiv,
        /// `fold`: f(b - a) of an odd f.
        FoldOdd,
    }

    /// All of them.
    pub const ALL: [Fault; 17] = [
        Fault::Slope,
        Fault::Coupling,
        Fault::ByState,
        Fault::ByTime,
        Fault::Dissipation,
        Fault::Inertia,
        Fault::Gamma,
        Fault::Moving,
        Fault::Border,
        Fault::Fixed,
        Fault::Relative,
        Fault::Absolute,
        Fault::Sliced,
        Fault::FoldSub,
        Fault::FoldMul,
        Fault::FoldDiv,
        Fault::FoldOdd,
    ];

    /// Whether this thread makes it.
    pub fn is_injected(fault: Fault) -> bool {
        INJECTED.get() == Some(fault)
    }

    /// Does some work with a fault; others go on without.
    pub fn with<T>(fault: Option<Fault>, work: impl FnOnce() -> T) -> T {
        struct Before(Option<Fault>);
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

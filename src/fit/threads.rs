//! Work on a fit side by side: searches from several starts, runs of several experiments,
//! profiles of several parameters.

use super::Fit;
#[cfg(feature = "sweep")]
use crate::threads;

/// Hands a simulator of the fit's machine to whoever is on the calling thread: one that all
/// share, or one that is made for it.
#[cfg(feature = "sweep")]
pub type Lender<'a> = &'a (dyn Fn(&mut dyn FnMut(&dyn machinist_contract::Simulator<f64>)) + Sync);

#[cfg(feature = "sweep")]
impl<'a> Fit<'a> {
    /// The same on threads, each of which is lent a simulator. Results do not depend on how many
    /// there are. Where the simulation is asked by [`Simulation::until_told`] it stays on one.
    ///
    /// [`Simulation::until_told`]: crate::Simulation::until_told
    #[must_use]
    pub fn on_threads(self, lender: Lender<'a>) -> Self {
        Self { lender: Some(lender), ..self }
    }
}

impl Fit<'_> {
    /// What `work` makes of each number below `count`.
    pub(super) fn each<T: Send>(
        &self,
        count: usize,
        work: impl Fn(&Fit<'_>, usize) -> T + Sync,
    ) -> Vec<T> {
        #[cfg(feature = "sweep")]
        if let Some(lender) = self.lender
            && count > 1
            && let Some(settings) = self.simulation.settings()
        {
            let (unknowns, experiments) = (self.unknowns, self.experiments);
            let lent = |number: usize| {
                let mut found = None;
                lender(&mut |simulator| {
                    let simulation = settings.clone().of(simulator);
                    let fit = Fit::new(&simulation, unknowns, experiments).on_threads(lender);
                    found = Some(work(&fit, number));
                });
                found
            };
            // Within work of another `each` it is the same pool.
            let found = threads::each(pool(), count, lent);
            let own =
                |(number, found): (usize, Option<T>)| found.unwrap_or_else(|| work(self, number));
            return found.into_iter().enumerate().map(own).collect();
        }
        (0..count).map(|number| work(self, number)).collect()
    }
}

/// Threads of fits, made once. The pool that rayon makes by itself may be wanted by others, as
/// algebras are, with a size of their own.
#[cfg(feature = "sweep")]
fn pool() -> Option<&'static rayon::ThreadPool> {
    use std::sync::OnceLock;

    static POOL: OnceLock<Option<rayon::ThreadPool>> = OnceLock::new();
    POOL.get_or_init(|| threads::pool(0)).as_ref()
}

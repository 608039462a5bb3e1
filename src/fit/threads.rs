//! Parallel work on a fit: searches from several starts, runs of several experiments, profiles of
//! several parameters.

use super::Fit;
#[cfg(feature = "sweep")]
use crate::threads;

/// Calls its argument with a simulator of the fit's machine for the current thread: a shared one,
/// or one made for it.
#[cfg(feature = "sweep")]
pub type Lender<'a> = &'a (dyn Fn(&mut dyn FnMut(&dyn machinist_contract::Simulator<f64>)) + Sync);

#[cfg(feature = "sweep")]
impl<'a> Fit<'a> {
    /// Returns the same fit on threads, each with a simulator from `lender`. Results do not depend
    /// on the number of threads. If [`Simulation::until_told`] is set, the fit stays on one thread.
    ///
    /// [`Simulation::until_told`]: crate::Simulation::until_told
    #[must_use]
    pub fn on_threads(self, lender: Lender<'a>) -> Self {
        Self { lender: Some(lender), ..self }
    }
}

impl Fit<'_> {
    /// Returns `work(i)` for each i below `count`.
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
            // Work within another `each` uses the same pool.
            let found = threads::each(pool(), count, lent);
            let own =
                |(number, found): (usize, Option<T>)| found.unwrap_or_else(|| work(self, number));
            return found.into_iter().enumerate().map(own).collect();
        }
        (0..count).map(|number| work(self, number)).collect()
    }
}

/// Returns the thread pool of fits, made once. Others, such as algebras, may need rayon's global
/// pool with another size.
#[cfg(feature = "sweep")]
fn pool() -> Option<&'static rayon::ThreadPool> {
    use std::sync::OnceLock;

    static POOL: OnceLock<Option<rayon::ThreadPool>> = OnceLock::new();
    POOL.get_or_init(|| threads::pool(0)).as_ref()
}

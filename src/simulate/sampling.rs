//! Output times of a run.

use machinist_contract::RunDefaults;

/// Output times, as a number of equally spaced ones or a list.
#[derive(Clone)]
pub(super) enum Sampling {
    Points(usize),
    Times(Vec<f64>),
    /// Times listed by the spec, restricted to the run.
    Listed(Vec<f64>),
}

impl Sampling {
    pub(super) fn of(defaults: &RunDefaults<'_>) -> Self {
        match defaults.times {
            [] => Self::Points(defaults.points),
            times => Self::Listed(times.to_vec()),
        }
    }
}

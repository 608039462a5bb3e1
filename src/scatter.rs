//! Scatter of results whose parameters have probability distributions.
//!
//! All of this is pure: samplers return points, [`Distribution`] turns them into parameters, and
//! statistics take the values that any function or machine returned for them.
//!
//! ```
//! use machinist::scatter::{Design, Distribution, Law, Sampler, Summary};
//!
//! let load = Distribution::new(Law::Normal { mean: 10.0, deviation: 0.5 })?;
//! let stiffness = Distribution::new(Law::Uniform { low: 2.0, high: 3.0 })?;
//! let design = Design { sampler: Sampler::Sobol, dimensions: 2, samples: 4096, seed: 1 };
//! let points = design.points()?;
//! let values: Vec<f64> = (0..points.len())
//!     .map(|index| {
//!         let u = points.get(index);
//!         load.quantile(u[0]) / stiffness.quantile(u[1])
//!     })
//!     .collect();
//! let summary = Summary::of(&values, &points.groups(), 0.95)?;
//! // E(load) E(1/stiffness) = 10 ln(3/2)
//! assert!((summary.mean.value - 10.0 * 1.5_f64.ln()).abs() < 1e-3);
//! # Ok::<(), machinist::scatter::ScatterError>(())
//! ```

mod correlation;
mod distribution;
mod evaluate;
mod hash;
mod indices;
mod jackknife;
mod linear;
mod normal;
mod points;
mod screening;
mod sobol;
mod summary;

pub use correlation::Correlation;
pub use distribution::{Distribution, Law};
pub use evaluate::value_over;
pub(crate) use hash::random_unit;
pub use indices::{Index, Saltelli, SobolIndices};
pub use linear::{Propagation, Share, propagate};
pub use normal::{normal_cdf, normal_quantile};
pub use points::{Design, Groups, Points, REPLICATES, Sampler};
pub use screening::{Effect, Morris};
pub use sobol::{MAX_DIMENSIONS, ScrambledSobol, Sobol};
pub use summary::{Estimate, Summary, Tally};

use crate::error::did_you_mean;

/// Error in the settings of a scatter.
#[derive(Debug, Clone, PartialEq, thiserror::Error, strum::IntoStaticStr, strum::VariantNames)]
#[strum(prefix = "scatter::", serialize_all = "kebab-case")]
#[non_exhaustive]
pub enum ScatterError {
    /// A distribution with impossible parameters.
    #[error("{0}")]
    Distribution(String),
    /// A matrix that is not a correlation matrix.
    #[error("{0}")]
    Correlation(String),
    /// A name that no sampler has.
    #[error("there is no sampler `{name}`{hint}")]
    UnknownSampler {
        /// The name.
        name: String,
        /// Nearest known name as a question, or empty.
        hint: String,
    },
    /// More dimensions than Sobol points have.
    #[error("Sobol points have at most {MAX_DIMENSIONS} dimensions, and {0} are needed")]
    Dimensions(usize),
    /// Too few or too many samples.
    #[error("{0}")]
    Samples(String),
}

impl ScatterError {
    /// Returns the code of this kind of error, which never changes; the book explains it.
    #[must_use]
    pub fn code(&self) -> &'static str {
        self.into()
    }
}

impl ScatterError {
    pub(crate) fn unknown_sampler(name: &str) -> Self {
        let known = Sampler::ALL.iter().map(|sampler| sampler.name());
        let hint = did_you_mean(name, known);
        Self::UnknownSampler { name: name.to_owned(), hint }
    }
}

//! Points of the unit cube at which a scatter is sampled.

use super::ScatterError;
use super::hash::{below, hash, unit};
use super::sobol::{ScrambledSobol, Sobol};

/// Number of independent replicates of Sobol points and Latin hypercubes. Their spread gives the
/// confidence of estimates.
pub const REPLICATES: usize = 32;

/// Maximum number of samples.
const MAX_SAMPLES: usize = 1 << 28;

/// Kind of points.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Sampler {
    /// Sobol points in [`REPLICATES`] independent scramblings.
    Sobol,
    /// Independent random points.
    Random,
    /// Latin hypercubes: [`REPLICATES`] independent ones, in each of which every coordinate has
    /// one value in each of equal intervals.
    Latin,
}

impl Sampler {
    /// All samplers.
    pub const ALL: [Self; 3] = [Self::Sobol, Self::Random, Self::Latin];

    /// Returns the name.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Sobol => "sobol",
            Self::Random => "random",
            Self::Latin => "latin",
        }
    }

    /// Returns the sampler of a name.
    ///
    /// # Errors
    /// [`ScatterError::UnknownSampler`], with the nearest known name.
    pub fn from_name(name: &str) -> Result<Self, ScatterError> {
        let known = Self::ALL.into_iter().find(|sampler| sampler.name() == name);
        known.ok_or_else(|| ScatterError::unknown_sampler(name))
    }
}

/// Points to be sampled.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Design {
    /// Kind of points.
    pub sampler: Sampler,
    /// Number of coordinates.
    pub dimensions: usize,
    /// Least number of points. Sobol points are rounded up to [`REPLICATES`] times a power of two,
    /// Latin hypercubes to a multiple of [`REPLICATES`].
    pub samples: usize,
    /// Seed. The same seed gives the same points on any computer.
    pub seed: u64,
}

/// Structure of samples: which of them are independent of each other.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Groups {
    /// All samples are independent.
    Independent,
    /// Sample i belongs to the replicate i modulo this number; replicates are independent.
    Replicates(usize),
}

/// Points of the open unit cube, in the order in which they are to be run.
#[derive(Debug, Clone)]
pub struct Points {
    design: Design,
    count: usize,
    kind: Kind,
}

#[derive(Debug, Clone)]
enum Kind {
    Sobol(Vec<ScrambledSobol>),
    Random,
    /// Permutations of the intervals, for each replicate and dimension.
    Latin(Vec<Vec<u32>>),
}

impl Design {
    /// Creates the points.
    ///
    /// # Errors
    /// [`ScatterError`] for more dimensions than Sobol points have, and for fewer than 2 or too
    /// many samples.
    pub fn points(self) -> Result<Points, ScatterError> {
        let Self { sampler, dimensions, samples, seed } = self;
        if !(2..=MAX_SAMPLES).contains(&samples) {
            let message = format!("{samples} samples: there must be 2 to {MAX_SAMPLES}");
            return Err(ScatterError::Samples(message));
        }
        let of_each = samples.div_ceil(REPLICATES);
        let (count, kind) = match sampler {
            Sampler::Random => (samples, Kind::Random),
            Sampler::Sobol => {
                let sobol = Sobol::new(dimensions)?;
                let scrambled = |replicate: usize| {
                    ScrambledSobol::new(sobol.clone(), hash(&[seed, replicate as u64]))
                };
                let all = (0..REPLICATES).map(scrambled).collect();
                (REPLICATES * of_each.next_power_of_two(), Kind::Sobol(all))
            }
            Sampler::Latin => {
                let all = (0..REPLICATES * dimensions)
                    .map(|number| permutation(of_each, hash(&[seed, number as u64, 0])));
                (REPLICATES * of_each, Kind::Latin(all.collect()))
            }
        };
        Ok(Points { design: self, count, kind })
    }
}

impl Points {
    /// Returns the number of points.
    #[must_use]
    pub fn len(&self) -> usize {
        self.count
    }

    /// Returns whether there are no points, which is never the case.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.count == 0
    }

    /// Returns the design.
    #[must_use]
    pub fn design(&self) -> Design {
        self.design
    }

    /// Returns the coordinates of a point, each between 0 and 1 and never 0 or 1.
    #[must_use]
    pub fn get(&self, index: usize) -> Vec<f64> {
        let (replicate, number) = (index % REPLICATES, index / REPLICATES);
        let Design { dimensions, seed, .. } = self.design;
        let coordinate = |dimension: usize| match &self.kind {
            Kind::Random => unit(hash(&[seed, index as u64, dimension as u64])),
            Kind::Sobol(scrambled) => scrambled[replicate].coordinate(number as u32, dimension),
            Kind::Latin(permutations) => {
                let intervals = &permutations[replicate * dimensions + dimension];
                let key = [seed, replicate as u64, number as u64, dimension as u64];
                let within = f64::from(intervals[number]) + unit(hash(&key));
                // Rounding must not reach 1.
                (within / intervals.len() as f64).min(1.0 - f64::EPSILON / 2.0)
            }
        };
        (0..dimensions).map(coordinate).collect()
    }

    /// Returns which points are independent of each other.
    #[must_use]
    pub fn groups(&self) -> Groups {
        match self.kind {
            Kind::Random => Groups::Independent,
            Kind::Sobol(_) | Kind::Latin(_) => Groups::Replicates(REPLICATES),
        }
    }
}

/// Returns a random permutation of 0..count (Fisher and Yates).
fn permutation(count: usize, key: u64) -> Vec<u32> {
    let mut all: Vec<u32> = (0..count as u32).collect();
    for last in (1..count).rev() {
        all.swap(last, below(hash(&[key, last as u64]), last as u64 + 1) as usize);
    }
    all
}

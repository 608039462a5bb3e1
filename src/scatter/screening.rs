//! Screening of parameters by elementary effects.

use super::ScatterError;
use super::hash::{below, hash};
use super::summary::{half_width, mean};

/// Morris' design: paths of points that each change one coordinate after another.
///
/// Coordinates are the middles of [`Morris::LEVELS`] equal intervals of probability, and a step
/// crosses half of them, so that distributions without bounds have no infinite values.
///
/// Source: M. D. Morris: Factorial sampling plans for preliminary computational experiments.
/// Technometrics 33 (1991), 161-174.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Morris {
    /// Number of parameters.
    pub dimensions: usize,
    /// Number of paths, of `dimensions` + 1 points each.
    pub paths: usize,
    /// Seed.
    pub seed: u64,
}

/// Effects of one parameter: changes of the result per unit of probability.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Effect {
    /// Mean mu.
    pub mean: f64,
    /// Mean of the absolute values, mu* (Campolongo, Cariboni, Saltelli 2007).
    pub mean_absolute: f64,
    /// Half the width of the confidence interval of mu*.
    pub error: f64,
    /// Standard deviation sigma; large for interactions and curvature.
    pub deviation: f64,
    /// Number of effects.
    pub count: usize,
}

/// Step of a path.
struct Step {
    dimension: usize,
    /// 1 for an increase, -1 for a decrease.
    sign: f64,
}

impl Morris {
    /// Number of levels of a coordinate.
    pub const LEVELS: u64 = 4;

    /// Returns the points of a path.
    #[must_use]
    pub fn path(&self, path: usize) -> Vec<Vec<f64>> {
        let (mut point, steps) = self.start(path);
        let mut points = vec![point.clone()];
        for Step { dimension, sign } in steps {
            point[dimension] += 0.5 * sign;
            points.push(point.clone());
        }
        points
    }

    fn start(&self, path: usize) -> (Vec<f64>, Vec<Step>) {
        let half = Self::LEVELS / 2;
        let random = |number: usize, kind: u64, bound: u64| {
            below(hash(&[self.seed, path as u64, number as u64, kind]), bound)
        };
        let levels: Vec<u64> = (0..self.dimensions).map(|k| random(k, 0, Self::LEVELS)).collect();
        let point = levels.iter().map(|level| (*level as f64 + 0.5) / Self::LEVELS as f64);
        let mut order: Vec<usize> = (0..self.dimensions).collect();
        for last in (1..self.dimensions).rev() {
            order.swap(last, random(last, 1, last as u64 + 1) as usize);
        }
        let step = |dimension: usize| {
            let sign = if levels[dimension] < half { 1.0 } else { -1.0 };
            Step { dimension, sign }
        };
        (point.collect(), order.into_iter().map(step).collect())
    }

    /// Computes effects from the values at the points of each path. Steps from or to a value that
    /// is not finite are left out.
    ///
    /// # Errors
    /// [`ScatterError::Samples`] if a path has another number of values than of points, or a
    /// parameter has fewer than 2 effects.
    pub fn effects(
        &self,
        values: &[Vec<f64>],
        confidence: f64,
    ) -> Result<Vec<Effect>, ScatterError> {
        let mut effects = vec![Vec::new(); self.dimensions];
        for (path, values) in values.iter().enumerate() {
            if values.len() != self.dimensions + 1 {
                let message = "a path must have a value for each of its points";
                return Err(ScatterError::Samples(message.to_owned()));
            }
            let (_, steps) = self.start(path);
            for (Step { dimension, sign }, ends) in steps.iter().zip(values.windows(2)) {
                let effect = (ends[1] - ends[0]) / (0.5 * sign);
                if effect.is_finite() {
                    effects[*dimension].push(effect);
                }
            }
        }
        effects.iter().map(|effects| Effect::of(effects, confidence)).collect()
    }
}

impl Effect {
    fn of(effects: &[f64], confidence: f64) -> Result<Self, ScatterError> {
        let count = effects.len();
        if count < 2 {
            let message =
                format!("{count} elementary effects of a parameter: at least 2 are needed");
            return Err(ScatterError::Samples(message));
        }
        let absolute: Vec<f64> = effects.iter().map(|effect| effect.abs()).collect();
        let mean_effect = mean(effects);
        let squares: f64 = effects.iter().map(|effect| (effect - mean_effect).powi(2)).sum();
        Ok(Self {
            mean: mean_effect,
            mean_absolute: mean(&absolute),
            error: half_width(&absolute, confidence),
            deviation: (squares / (count - 1) as f64).sqrt(),
            count,
        })
    }
}

//! Sobol indices of first and total order.
//!
//! ```text
//! S_i = V(E(y | x_i))/V(y)      S_Ti = E(V(y | all x but x_i))/V(y)
//! ```

use super::ScatterError;
use super::hash::{below, hash};
use super::points::{Design, Groups, Points};
use super::summary::{Estimate, student};

/// Saltelli's design: for each row, two independent points A and B, and the points A with one
/// coordinate taken from B.
///
/// Source: A. Saltelli et al.: Variance based sensitivity analysis of model output. Comput. Phys.
/// Commun. 181 (2010), 259-270.
#[derive(Debug, Clone)]
pub struct Saltelli {
    points: Points,
    dimensions: usize,
}

impl Saltelli {
    /// Creates the design. `design.samples` is the number of rows, and each row takes
    /// `design.dimensions` + 2 runs.
    ///
    /// # Errors
    /// As for [`Design::points`], with twice the dimensions.
    pub fn new(design: Design) -> Result<Self, ScatterError> {
        let dimensions = design.dimensions;
        let points = Design { dimensions: 2 * dimensions, ..design }.points()?;
        Ok(Self { points, dimensions })
    }

    /// Returns the number of rows.
    #[must_use]
    pub fn rows(&self) -> usize {
        self.points.len()
    }

    /// Returns the number of points in a row.
    #[must_use]
    pub fn row_length(&self) -> usize {
        self.dimensions + 2
    }

    /// Returns which rows are independent of each other.
    #[must_use]
    pub fn groups(&self) -> Groups {
        self.points.groups()
    }

    /// Returns the points of a row: A, B, then A with coordinate i of B, for each i.
    #[must_use]
    pub fn row(&self, row: usize) -> Vec<Vec<f64>> {
        let both = self.points.get(row);
        let (a, b) = both.split_at(self.dimensions);
        let mixed = (0..self.dimensions).map(|i| {
            let mut point = a.to_vec();
            point[i] = b[i];
            point
        });
        [a.to_vec(), b.to_vec()].into_iter().chain(mixed).collect()
    }
}

/// Indices of one parameter.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Index {
    /// First order, by the estimator of Janon and Monod with a control variate.
    pub first: Estimate,
    /// Total order, by the estimator of Jansen.
    pub total: Estimate,
}

/// Indices of all parameters.
///
/// ```text
/// S_i  = (mean(f_B f_i) - m_i^2 - (1 - S_Ti) c)/(mean((f_B^2 + f_i^2)/2) - m_i^2)
/// S_Ti = mean((f_A - f_i)^2)/(2 V)
/// c    = mean(f_A f_B) - m^2
/// ```
///
/// where f_i is the value at A with coordinate i of B, m_i the mean of all f_B and f_i, and m and V
/// mean and variance of all f_A and f_B. A and B are independent, so c is zero in the mean and does
/// not change that of S_i. Its error is that of f_B f_i as far as f_i agrees with f_A, by their
/// correlation 1 - S_Ti. Without c, small indices have errors as large as those of large ones.
/// Sources: A. Janon et al.: Asymptotic
/// normality and efficiency of two Sobol index estimators, ESAIM Probab. Stat. 18 (2014); M. J. W.
/// Jansen: Analysis of variance designs for model output, Comput. Phys. Commun. 117 (1999).
///
/// Intervals of independent rows are percentiles of a bootstrap over rows; those of replicates are
/// t intervals of a jackknife that leaves out one replicate at a time.
#[derive(Debug, Clone, PartialEq)]
pub struct SobolIndices {
    /// Number of rows that all have values.
    pub rows: usize,
    /// Variance of the values at A and B.
    pub variance: f64,
    /// Indices in the order of the dimensions.
    pub indices: Vec<Index>,
}

/// Number of resamplings of the bootstrap.
const RESAMPLINGS: usize = 1000;

/// Sums over rows from which the indices of one parameter follow.
#[derive(Debug, Clone, Copy, Default)]
struct Sums {
    count: f64,
    /// f_A + f_B, and the sum of their squares.
    both: f64,
    both_squared: f64,
    /// f_B + f_i, and the sum of their squares.
    shared: f64,
    shared_squared: f64,
    /// f_B f_i.
    product: f64,
    /// f_A f_B.
    apart: f64,
    /// (f_A - f_i)^2.
    difference: f64,
}

impl Sums {
    fn of_row(a: f64, b: f64, mixed: f64) -> Self {
        Self {
            count: 1.0,
            both: a + b,
            both_squared: a * a + b * b,
            shared: b + mixed,
            shared_squared: b * b + mixed * mixed,
            product: b * mixed,
            apart: a * b,
            difference: (a - mixed) * (a - mixed),
        }
    }

    fn add(&mut self, other: &Self, factor: f64) {
        self.count += factor * other.count;
        self.both += factor * other.both;
        self.both_squared += factor * other.both_squared;
        self.shared += factor * other.shared;
        self.shared_squared += factor * other.shared_squared;
        self.product += factor * other.product;
        self.apart += factor * other.apart;
        self.difference += factor * other.difference;
    }

    fn variance(&self) -> f64 {
        let mean = self.both / (2.0 * self.count);
        self.both_squared / (2.0 * self.count) - mean * mean
    }

    /// Returns the first-order and the total index.
    fn indices(&self) -> [f64; 2] {
        let total = self.difference / (2.0 * self.count * self.variance());
        let of_both = self.both / (2.0 * self.count);
        let control = self.apart / self.count - of_both * of_both;
        let mean = self.shared / (2.0 * self.count);
        let above = self.product / self.count - mean * mean - (1.0 - total) * control;
        let below = self.shared_squared / (2.0 * self.count) - mean * mean;
        [above / below, total]
    }
}

impl SobolIndices {
    /// Computes indices from the values of each row, in the order of [`Saltelli::row`]. Rows with a
    /// value that is not finite are left out.
    ///
    /// # Errors
    /// [`ScatterError::Samples`] for rows of different lengths, fewer than 2 complete rows, values
    /// that do not vary, or a confidence that is not between 0 and 1.
    pub fn of(values: &[Vec<f64>], groups: &Groups, confidence: f64) -> Result<Self, ScatterError> {
        let refuse = |message: &str| Err(ScatterError::Samples(message.to_owned()));
        let length = values.first().map_or(0, Vec::len);
        if length < 3 || values.iter().any(|row| row.len() != length) {
            return refuse("rows of a Saltelli design must all have a value for each point");
        }
        if !(confidence > 0.0 && confidence < 1.0) {
            return refuse("a confidence must be between 0 and 1");
        }
        let complete = |(_, row): &(usize, &Vec<f64>)| row.iter().all(|value| value.is_finite());
        let rows: Vec<(usize, &Vec<f64>)> = values.iter().enumerate().filter(complete).collect();
        if rows.len() < 2 {
            return refuse("fewer than 2 rows of the design have all their values");
        }
        // Indices do not depend on the origin, and this one loses the fewest digits.
        let centre =
            rows.iter().map(|(_, row)| row[0] + row[1]).sum::<f64>() / (2.0 * rows.len() as f64);
        let sums = |i: usize| -> Vec<(usize, Sums)> {
            let row = |(number, row): &(usize, &Vec<f64>)| {
                let [a, b, mixed] = [row[0], row[1], row[2 + i]].map(|value| value - centre);
                (*number, Sums::of_row(a, b, mixed))
            };
            rows.iter().map(row).collect()
        };
        let variance = total(&sums(0)).variance();
        if variance <= 0.0 {
            return refuse("the values do not vary, so they have no sensitivity indices");
        }
        let indices = (0..length - 2).map(|i| index(&sums(i), groups, confidence));
        Ok(Self { rows: rows.len(), variance, indices: indices.collect() })
    }
}

fn total(rows: &[(usize, Sums)]) -> Sums {
    let mut total = Sums::default();
    for (_, row) in rows {
        total.add(row, 1.0);
    }
    total
}

fn index(rows: &[(usize, Sums)], groups: &Groups, confidence: f64) -> Index {
    let whole = total(rows);
    let [first, total] = whole.indices();
    let intervals = match groups {
        Groups::Independent => bootstrap(rows, confidence),
        Groups::Replicates(count) => jackknife(rows, &whole, *count, confidence),
    };
    let [first, total] = [(first, intervals[0]), (total, intervals[1])]
        .map(|(value, [low, high])| Estimate { value, low, high });
    Index { first, total }
}

/// Returns percentile intervals of both indices.
fn bootstrap(rows: &[(usize, Sums)], confidence: f64) -> [[f64; 2]; 2] {
    let mut found = [Vec::with_capacity(RESAMPLINGS), Vec::with_capacity(RESAMPLINGS)];
    for number in 0..RESAMPLINGS {
        let mut sums = Sums::default();
        for draw in 0..rows.len() {
            let row = below(hash(&[number as u64, draw as u64]), rows.len() as u64);
            sums.add(&rows[row as usize].1, 1.0);
        }
        let values = sums.indices();
        found.iter_mut().zip(values).for_each(|(all, value)| all.push(value));
    }
    let tail = 0.5 * (1.0 - confidence);
    found.map(|mut all| {
        all.sort_unstable_by(f64::total_cmp);
        [tail, 1.0 - tail].map(|p| all[(p * (RESAMPLINGS - 1) as f64).round() as usize])
    })
}

/// Returns t intervals of both indices from leaving out one replicate at a time.
fn jackknife(rows: &[(usize, Sums)], whole: &Sums, count: usize, confidence: f64) -> [[f64; 2]; 2] {
    let mut replicates = vec![Sums::default(); count];
    for (number, row) in rows {
        replicates[number % count].add(row, 1.0);
    }
    replicates.retain(|sums| sums.count > 0.0);
    let count = replicates.len() as f64;
    let without = replicates.iter().map(|sums| {
        let mut rest = *whole;
        rest.add(sums, -1.0);
        rest.indices()
    });
    let without: Vec<[f64; 2]> = without.collect();
    let t = student(0.5 * (1.0 + confidence), replicates.len().saturating_sub(1));
    let values = whole.indices();
    [0, 1].map(|k| {
        let mean = without.iter().map(|both| both[k]).sum::<f64>() / count;
        let squares: f64 = without.iter().map(|both| (both[k] - mean).powi(2)).sum();
        let half = t * (squares * (count - 1.0) / count).sqrt();
        [values[k] - half, values[k] + half]
    })
}

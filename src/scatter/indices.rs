//! Sobol indices of first and total order.
//!
//! ```text
//! S_i = V(E(y | x_i))/V(y)      S_Ti = E(V(y | all x but x_i))/V(y)
//! ```

use super::ScatterError;
use super::jackknife::Jackknife;
use super::points::{Design, Groups, Points};
use super::summary::Estimate;

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
    /// Total order, by the estimator of Jansen with a control variate.
    pub total: Estimate,
}

/// Indices of all parameters.
///
/// ```text
/// S_i  = S - (1 - T) (1 - S^2) c/V_i    S = (mean(f_B f_i) - m_i^2)/V_i
/// S_Ti = T + S T c/V                    T = mean((f_A - f_i)^2)/(2 V)
/// c    = mean(f_A f_B) - m^2
/// ```
///
/// where f_i is the value at A with coordinate i of B, m_i and V_i mean and variance of all f_B and
/// f_i, and m and V those of all f_A and f_B. A and B are independent, so c is zero in the mean. Its
/// coefficients give the least variance if f_A, f_B and f_i are jointly normal. Without c, S has the
/// same error for small indices as for large ones, and T a large error if f_i is nearly f_B.
/// Sources: A. Janon et al.: Asymptotic normality and efficiency of two Sobol index estimators, ESAIM
/// Probab. Stat. 18 (2014); M. J. W. Jansen: Analysis of variance designs for model output, Comput.
/// Phys. Commun. 117 (1999).
///
/// Intervals are t intervals of a jackknife over independent rows or replicates.
#[derive(Debug, Clone, PartialEq)]
pub struct SobolIndices {
    /// Number of rows that all have values.
    pub rows: usize,
    /// Variance of the values at A and B.
    pub variance: f64,
    /// Indices in the order of the dimensions.
    pub indices: Vec<Index>,
}

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
        let count = self.count;
        let mean = self.shared / (2.0 * count);
        let below = self.shared_squared / (2.0 * count) - mean * mean;
        let first = (self.product / count - mean * mean) / below;
        let total = self.difference / (2.0 * count * self.variance());
        let of_both = self.both / (2.0 * count);
        let apart = self.apart / count - of_both * of_both;
        [
            first - (1.0 - total) * (1.0 - first * first) * apart / below,
            total + first * total * apart / self.variance(),
        ]
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
        let parts = |i: usize| {
            let row = |(number, row): &(usize, &Vec<f64>)| {
                let [a, b, mixed] = [row[0], row[1], row[2 + i]].map(|value| value - centre);
                (*number, Sums::of_row(a, b, mixed))
            };
            independent(rows.iter().map(row), *groups)
        };
        let variance = total(&parts(0)).variance();
        if variance <= 0.0 {
            return refuse("the values do not vary, so they have no sensitivity indices");
        }
        let indices = (0..length - 2).map(|i| index(&parts(i), confidence));
        Ok(Self { rows: rows.len(), variance, indices: indices.collect() })
    }
}

/// Returns the sums over each replicate, or of each row if rows are independent.
fn independent(rows: impl Iterator<Item = (usize, Sums)>, groups: Groups) -> Vec<Sums> {
    let Groups::Replicates(count) = groups else { return rows.map(|(_, row)| row).collect() };
    let mut replicates = vec![Sums::default(); count];
    rows.for_each(|(number, row)| replicates[number % count].add(&row, 1.0));
    replicates.retain(|sums| sums.count > 0.0);
    replicates
}

fn total(parts: &[Sums]) -> Sums {
    let mut total = Sums::default();
    for part in parts {
        total.add(part, 1.0);
    }
    total
}

fn index(parts: &[Sums], confidence: f64) -> Index {
    let whole = total(parts);
    let without = parts.iter().map(|part| {
        let mut rest = whole;
        rest.add(part, -1.0);
        rest.indices()
    });
    let without: Vec<[f64; 2]> = without.collect();
    let values = whole.indices();
    let [first, total] = [0, 1].map(|k| {
        let one = without.iter().map(|both| both[k]);
        let [low, high] = Jackknife::of(values[k], one).interval(confidence);
        Estimate { value: values[k], low, high }
    });
    Index { first, total }
}

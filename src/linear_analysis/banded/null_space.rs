//! Null spaces of matrices with short rows whose entries are near each other.

use nalgebra::DVector;

use super::order::parts;
use crate::sorting::sort_ascending;

/// Number of solutions of inverse iteration; the third already changes only the last digits.
const ITERATIONS: usize = 5;

/// Factor above the zero limit from which on a length is certainly not zero.
const DOUBTFUL: f64 = 100.0;
/// Minimum ratio of columns to the band of R.
const SLENDER: usize = 8;

/// Null space of a matrix with short rows.
pub(super) struct NullSpace {
    /// Orthonormal basis.
    pub(super) vectors: Vec<DVector<f64>>,
    /// Columns in the order of R.
    order: Vec<usize>,
    /// R of the matrix, extended by a row with a 1 for an entry of each vector so that it is
    /// regular.
    triangle: Triangle,
}

/// R of A = Q R, upper triangular with `width` entries right of the diagonal.
struct Triangle {
    columns: usize,
    width: usize,
    entries: Vec<f64>,
}

impl NullSpace {
    /// Returns the vectors that a matrix, given by its rows as (column, entry), maps to less than
    /// `limit`. Returns `None` if a vector is mapped to little more, so that rounding would decide,
    /// or if the band is wide.
    ///
    /// Uses Givens rotations, row by row, as George and Heath (Linear Algebra Appl. 34, 1980), and
    /// inverse iteration with R^T R. The largest entry of each vector found is fixed by one more
    /// row before the search for the next.
    pub(super) fn of(columns: usize, rows: &[Vec<(usize, f64)>], limit: f64) -> Option<Self> {
        let mut neighbours = vec![Vec::new(); columns];
        for row in rows {
            if row.len() * SLENDER > columns {
                return None;
            }
            for (column, _) in row {
                let others = row.iter().map(|(other, _)| *other);
                neighbours[*column].extend(others.filter(|other| other != column));
            }
        }
        let order = parts(&neighbours).concat();
        let mut places = vec![0; columns];
        order.iter().enumerate().for_each(|(place, column)| places[*column] = place);
        let placed = |row: &Vec<(usize, f64)>| {
            row.iter().map(|(column, entry)| (places[*column], *entry)).collect::<Vec<_>>()
        };
        let rows: Vec<_> = rows.iter().map(placed).collect();
        let mut triangle = Triangle::new(columns, &rows);
        if triangle.width * SLENDER > columns {
            return None;
        }
        let mut vectors: Vec<DVector<f64>> = Vec::new();
        while vectors.len() < columns {
            let (vector, length) = triangle.least();
            if length > limit * DOUBTFUL {
                break;
            }
            if length.is_nan() || length > limit {
                return None;
            }
            let mut row = vec![0.0; triangle.width + 1];
            row[0] = 1.0;
            triangle.take(vector.icamax(), &mut row);
            let vector = DVector::from_fn(columns, |column, _| vector[places[column]]);
            vectors.push(across(vector, &vectors));
        }
        Some(Self { vectors, order, triangle })
    }

    /// Returns (R^T R)^-1 b.
    pub(super) fn solve(&self, b: &DVector<f64>) -> DVector<f64> {
        let mut solution = b.select_rows(&self.order);
        self.triangle.solve(&mut solution);
        let mut back = DVector::zeros(b.len());
        for (place, column) in self.order.iter().enumerate() {
            back[*column] = solution[place];
        }
        back
    }

    /// Returns a vector without its components in the null space.
    pub(super) fn across(&self, mut vector: DVector<f64>) -> DVector<f64> {
        take_from(&mut vector, &self.vectors);
        vector
    }
}

impl Triangle {
    fn new(columns: usize, rows: &[Vec<(usize, f64)>]) -> Self {
        let ends = |row: &Vec<(usize, f64)>| {
            let places = || row.iter().map(|(column, _)| *column);
            places().max().zip(places().min())
        };
        let reach = rows.iter().filter_map(ends).map(|(last, first)| last - first);
        let width = reach.max().unwrap_or(0);
        let mut triangle = Self { columns, width, entries: vec![0.0; columns * (width + 1)] };
        // Sorted by their first columns, rows meet no more rows of R than the band has.
        let mut order: Vec<_> =
            rows.iter().filter_map(|row| ends(row).map(|(_, first)| (first, row))).collect();
        sort_ascending(&mut order, |(first, _)| *first as f64);
        let mut spread = vec![0.0; width + 1];
        for (first, row) in order {
            spread.fill(0.0);
            for (column, entry) in row {
                spread[column - first] += entry;
            }
            triangle.take(first, &mut spread);
        }
        triangle
    }

    /// Rotates a row that begins at column `first` into R.
    fn take(&mut self, first: usize, row: &mut [f64]) {
        for column in first..self.columns {
            if row.iter().all(|entry| *entry == 0.0) {
                return;
            }
            let own = &mut self.entries[column * (self.width + 1)..][..=self.width];
            let length = own[0].hypot(row[0]);
            if row[0] != 0.0 {
                let (cosine, sine) = (own[0] / length, row[0] / length);
                for (own, other) in own.iter_mut().zip(row.iter_mut()) {
                    (*own, *other) = (cosine * *own + sine * *other, cosine * *other - sine * *own);
                }
            }
            row[0] = 0.0;
            row.rotate_left(1);
        }
    }

    /// Returns the unit vector with the shortest product, and the length of that product.
    fn least(&self) -> (DVector<f64>, f64) {
        let start = |index: usize| 1.0 + (1.7 * index as f64).cos() / 2.0;
        let mut vector = DVector::from_fn(self.columns, |index, _| start(index)).normalize();
        for _ in 0..ITERATIONS {
            self.solve(&mut vector);
            let largest = vector.amax();
            vector /= largest;
            vector.normalize_mut();
        }
        let length = self.times(&vector).norm();
        (vector, length)
    }

    fn row(&self, row: usize) -> &[f64] {
        &self.entries[row * (self.width + 1)..][..=self.width]
    }

    fn times(&self, vector: &DVector<f64>) -> DVector<f64> {
        let row = |row: usize| {
            self.row(row).iter().zip(&vector.as_slice()[row..]).map(|(r, x)| r * x).sum()
        };
        DVector::from_fn(self.columns, |index, _| row(index))
    }

    /// Solves R^T R x = b in place. Pivots below rounding are replaced by rounding.
    fn solve(&self, b: &mut DVector<f64>) {
        let largest = self.entries.iter().fold(f64::MIN_POSITIVE, |most, r| most.max(r.abs()));
        let least = f64::EPSILON * largest;
        let pivot = |row: usize| {
            let pivot = self.row(row)[0];
            if pivot.abs() < least { least } else { pivot }
        };
        let b = b.as_mut_slice();
        for row in 0..self.columns {
            b[row] /= pivot(row);
            let value = b[row];
            for (other, r) in b[row + 1..].iter_mut().zip(&self.row(row)[1..]) {
                *other -= r * value;
            }
        }
        for row in (0..self.columns).rev() {
            let known: f64 = self.row(row)[1..].iter().zip(&b[row + 1..]).map(|(r, x)| r * x).sum();
            b[row] = (b[row] - known) / pivot(row);
        }
    }
}

/// Returns a unit vector without components along others.
fn across(mut vector: DVector<f64>, others: &[DVector<f64>]) -> DVector<f64> {
    take_from(&mut vector, others);
    // A second pass removes what rounding leaves.
    take_from(&mut vector, others);
    vector.normalize()
}

fn take_from(vector: &mut DVector<f64>, others: &[DVector<f64>]) {
    for other in others {
        let along = other.dot(vector);
        vector.axpy(-along, other, 1.0);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Returns differences of neighbours in a chain, with some joints missing.
    fn chain(count: usize, without: &[usize]) -> Vec<Vec<(usize, f64)>> {
        let joined = (1..count).filter(|index| !without.contains(index));
        joined.map(|index| vec![(index - 1, -1.0), (index, 1.0)]).collect()
    }

    #[test]
    fn chains_that_nothing_holds_move_as_one_each() {
        let found = NullSpace::of(300, &chain(300, &[100, 250]), 1e-13).expect("clear").vectors;
        assert_eq!(found.len(), 3);
        for vector in &found {
            for two in [[0, 99], [100, 249], [250, 299]] {
                assert!((vector[two[0]] - vector[two[1]]).abs() < 1e-13);
            }
        }
        let mut held = chain(300, &[]);
        held.push(vec![(7, 1e-6)]);
        assert_eq!(NullSpace::of(300, &held, 1e-13).expect("clear").vectors.len(), 0);
    }

    #[test]
    fn nothing_is_said_where_rounding_would_decide() {
        let mut held = chain(50, &[]);
        held.push(vec![(0, 1e-12)]);
        assert!(NullSpace::of(50, &held, 1e-13).is_none());
    }
}

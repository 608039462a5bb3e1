//! T(s) = s^2 + s A_1 + A_0 of one part, in an order with its nonzeros near the diagonal.

use std::ops::Range;

use nalgebra::DMatrix;
use num_complex::Complex64;

/// Banded matrix T(s) with T(s) x = 0 for a motion e^(s t) x of coordinates and first-order states;
/// velocities are s times their coordinates. The diagonal has s^2 for coordinates and s for
/// first-order states.
pub(super) struct Pencil {
    /// Half-bandwidth of T.
    width: usize,
    /// True for rows that belong to a coordinate; the others belong to first-order states.
    is_coordinate: Vec<bool>,
    /// A_0 and A_1, with 2 width + 1 columns around the diagonal in each row.
    constant: Vec<f64>,
    linear: Vec<f64>,
}

/// A number and its derivative by s.
#[derive(Clone, Copy)]
struct Dual {
    value: Complex64,
    slope: Complex64,
}

const NOTHING: Dual = Dual { value: Complex64::ZERO, slope: Complex64::ZERO };

impl Pencil {
    /// Creates a matrix without entries.
    pub(super) fn new(is_coordinate: Vec<bool>, width: usize) -> Self {
        let places = is_coordinate.len() * (2 * width + 1);
        let [constant, linear] = [vec![0.0; places], vec![0.0; places]];
        Self { width, is_coordinate, constant, linear }
    }

    /// Subtracts the dependence of a rate on a coordinate or state, or on a velocity.
    pub(super) fn subtract(&mut self, row: usize, column: usize, of_velocity: bool, rate: f64) {
        let place = self.place(row, column);
        let entries = if of_velocity { &mut self.linear } else { &mut self.constant };
        entries[place] -= rate;
    }

    /// Returns the number of rows.
    pub(super) fn size(&self) -> usize {
        self.is_coordinate.len()
    }

    /// Returns the number of eigenvalues of some rows, decoupled from others.
    pub(super) fn degree(&self, rows: Range<usize>) -> usize {
        rows.clone().count() + rows.filter(|row| self.is_coordinate[*row]).count()
    }

    /// Returns the index of an entry.
    fn place(&self, row: usize, column: usize) -> usize {
        row * (2 * self.width + 1) + column + self.width - row
    }

    fn entry(&self, row: usize, column: usize, s: Complex64) -> Dual {
        let place = self.place(row, column);
        let linear = self.linear[place];
        let mut value = s * linear + self.constant[place];
        let mut slope = Complex64::from(linear);
        if row == column {
            let is_coordinate = self.is_coordinate[row];
            value += if is_coordinate { s * s } else { s };
            slope += if is_coordinate { s * 2.0 } else { Complex64::ONE };
        }
        Dual { value, slope }
    }

    /// Reads a row from the column at which elimination meets it, without couplings outside `rows`.
    #[inline(always)]
    fn read(&self, row: usize, rows: &Range<usize>, s: Complex64, into: &mut [Dual]) {
        if row >= rows.end {
            into.fill(NOTHING);
            return;
        }
        let (width, length) = (into.len() / 2, into.len());
        let own = row * length..(row + 1) * length;
        let entries = self.constant[own.clone()].iter().zip(&self.linear[own]);
        for (into, (constant, linear)) in into.iter_mut().zip(entries) {
            *into = Dual { value: s * linear + constant, slope: Complex64::from(*linear) };
        }
        let (value, slope) =
            if self.is_coordinate[row] { (s * s, s * 2.0) } else { (s, Complex64::ONE) };
        into[width].value += value;
        into[width].slope += slope;
        let before = (rows.start + width).saturating_sub(row);
        into[..before].fill(NOTHING);
        let beyond = (row + width + 1).saturating_sub(rows.end);
        into[length - beyond..].fill(NOTHING);
    }

    /// Returns (det T)'/det T of some rows and columns, by elimination with derivatives; `None`
    /// where the determinant is zero.
    pub(super) fn logarithmic_slope(&self, rows: Range<usize>, s: Complex64) -> Option<Complex64> {
        // Narrow bands, which are by far the most frequent, have their width as a compile-time
        // constant.
        match self.width {
            1 => self.slope_within(1, &mut [NOTHING; 6], &rows, s),
            2 => self.slope_within(2, &mut [NOTHING; 15], &rows, s),
            width => self.slope_within(
                width,
                &mut vec![NOTHING; (width + 1) * (2 * width + 1)],
                &rows,
                s,
            ),
        }
    }

    /// Does the same, with the width of all rows and memory for waiting rows.
    #[inline(always)]
    fn slope_within(
        &self,
        width: usize,
        waiting: &mut [Dual],
        rows: &Range<usize>,
        s: Complex64,
    ) -> Option<Complex64> {
        let length = 2 * width + 1;
        self.read_first(rows, s, waiting);
        let mut sum = Complex64::ZERO;
        for step in rows.clone() {
            exchange(waiting, length, |_, entry| entry.value.norm_sqr());
            let (pivot_row, others) = waiting.split_at_mut(length);
            let inverse = pivot_row[0].value.inv();
            if !inverse.is_finite() {
                return None;
            }
            let share = pivot_row[0].slope * inverse;
            sum += share;
            for row in others.chunks_exact_mut(length) {
                let value = row[0].value * inverse;
                let slope = row[0].slope * inverse - value * share;
                for column in 1..length {
                    let Dual { value: by, slope: by_slope } = pivot_row[column];
                    row[column - 1] = Dual {
                        value: row[column].value - value * by,
                        slope: row[column].slope - value * by_slope - slope * by,
                    };
                }
                row[length - 1] = NOTHING;
            }
            self.read(step + width + 1, rows, s, pivot_row);
        }
        sum.is_finite().then_some(sum)
    }

    /// Reads the rows with which elimination begins, each from its first column.
    #[inline(always)]
    fn read_first(&self, rows: &Range<usize>, s: Complex64, waiting: &mut [Dual]) {
        let (width, length) = (self.width, 2 * self.width + 1);
        for (index, row) in waiting.chunks_exact_mut(length).enumerate() {
            self.read(rows.start + index, rows, s, row);
            // Its first column is `width - index` further.
            row.rotate_left(width - index);
        }
    }

    /// Returns P T(s) = L U of all rows for inverse iteration. Pivots smaller than rounding of the
    /// largest are replaced by that.
    pub(super) fn factors(&self, s: Complex64) -> Factors {
        let (width, length, size) = (self.width, 2 * self.width + 1, self.size());
        let rows = 0..size;
        let values = |rows: &[Dual]| rows.iter().map(|dual| dual.value).collect::<Vec<_>>();
        let mut waiting = vec![NOTHING; (width + 1) * length];
        self.read_first(&rows, s, &mut waiting);
        let mut waiting = values(&waiting);
        let largest = |row: usize| self.entry(row, row, s).value.norm();
        let least = f64::EPSILON * rows.clone().map(largest).fold(f64::MIN_POSITIVE, f64::max);
        let mut factors = Factors {
            width,
            upper: Vec::with_capacity(size * length),
            lower: Vec::with_capacity(size * width),
            exchanged: Vec::with_capacity(size),
        };
        let mut next = vec![NOTHING; length];
        // Rows beyond the last one are never pivots, even if all others are zero.
        let mut number: Vec<usize> = (0..=width).collect();
        for step in rows.clone() {
            let largest = exchange(&mut waiting, length, |place, entry| {
                if number[place] < size { entry.norm_sqr() } else { -1.0 }
            });
            factors.exchanged.push(largest);
            number[largest] = number[0];
            number[0] = step + width + 1;
            let (pivot_row, others) = waiting.split_at_mut(length);
            if pivot_row[0].norm() < least {
                pivot_row[0] = Complex64::from(least);
            }
            let inverse = pivot_row[0].inv();
            for row in others.chunks_exact_mut(length) {
                let share = row[0] * inverse;
                factors.lower.push(share);
                for column in 1..length {
                    row[column - 1] = row[column] - share * pivot_row[column];
                }
                row[length - 1] = Complex64::ZERO;
            }
            factors.upper.push(inverse);
            factors.upper.extend_from_slice(&pivot_row[1..]);
            self.read(step + width + 1, &rows, s, &mut next);
            pivot_row.iter_mut().zip(&next).for_each(|(into, entry)| *into = entry.value);
        }
        factors
    }

    /// Returns T(s) x and the sizes of its terms.
    pub(super) fn times(&self, s: Complex64, vector: &[Complex64]) -> [Vec<Complex64>; 2] {
        self.products(vector, |row, column| self.entry(row, column, s).value)
    }

    /// Returns T'(s) x and the sizes of its terms.
    pub(super) fn slope_times(&self, s: Complex64, vector: &[Complex64]) -> [Vec<Complex64>; 2] {
        self.products(vector, |row, column| self.entry(row, column, s).slope)
    }

    fn products(
        &self,
        vector: &[Complex64],
        entry: impl Fn(usize, usize) -> Complex64,
    ) -> [Vec<Complex64>; 2] {
        let mut products = [const { Vec::new() }; 2];
        for row in 0..self.size() {
            let [mut sum, mut size] = [Complex64::ZERO; 2];
            for column in self.columns(row) {
                let term = entry(row, column) * vector[column];
                sum += term;
                // Tiny terms may vanish, since sizes are compared with the largest.
                size += term.norm_sqr().sqrt();
            }
            products[0].push(sum);
            products[1].push(size);
        }
        products
    }

    /// Returns the components s u + A_1^T u of a left vector for coordinates, given its components
    /// u for rates.
    pub(super) fn momenta(&self, s: Complex64, left: &[Complex64]) -> Vec<Complex64> {
        let mut momenta: Vec<Complex64> = left.iter().map(|u| u * s).collect();
        for (row, u) in left.iter().enumerate() {
            for column in self.columns(row) {
                momenta[column] += u * self.linear[self.place(row, column)];
            }
        }
        momenta
    }

    /// Returns an upper bound of all undamped frequencies, from the rows of A_0.
    pub(super) fn fastest(&self) -> f64 {
        let row = |row: usize| -> f64 {
            self.columns(row).map(|column| self.constant[self.place(row, column)].abs()).sum()
        };
        (0..self.size()).map(row).fold(0.0, f64::max).sqrt()
    }

    /// Returns the columns of a row.
    fn columns(&self, row: usize) -> Range<usize> {
        row.saturating_sub(self.width)..self.size().min(row + self.width + 1)
    }

    /// Returns the dense A of x' = A x for some rows and their velocities.
    pub(super) fn companion(&self, rows: Range<usize>) -> DMatrix<f64> {
        let size = rows.len();
        let moving: Vec<usize> = rows.clone().filter(|row| self.is_coordinate[*row]).collect();
        let mut matrix = DMatrix::zeros(size + moving.len(), size + moving.len());
        // Rates of velocities and first-order states are rows; velocities come last.
        let velocity = |row: usize| moving.binary_search(&row).ok().map(|index| size + index);
        for row in rows.clone() {
            let rate = velocity(row).unwrap_or(row - rows.start);
            for column in self.columns(row).filter(|column| rows.contains(column)) {
                let place = self.place(row, column);
                matrix[(rate, column - rows.start)] -= self.constant[place];
                if let Some(velocity) = velocity(column) {
                    matrix[(rate, velocity)] -= self.linear[place];
                }
            }
            if let Some(velocity) = velocity(row) {
                matrix[(row - rows.start, velocity)] = 1.0;
            }
        }
        matrix
    }

    /// Returns the sums of all eigenvalues and of their squares: the traces of A and of A A.
    pub(super) fn traces(&self) -> [f64; 2] {
        let [mut first, mut second] = [0.0, 0.0];
        for row in 0..self.size() {
            let rate = |row: usize, column: usize| {
                // The dependence on first-order states is in the constant part, that on velocities
                // in the linear one.
                let place = self.place(row, column);
                if self.is_coordinate[column] { self.linear[place] } else { self.constant[place] }
            };
            first -= rate(row, row);
            second +=
                self.columns(row).map(|column| rate(row, column) * rate(column, row)).sum::<f64>();
            if self.is_coordinate[row] {
                second -= 2.0 * self.constant[self.place(row, row)];
            }
        }
        [first, second]
    }
}

/// Moves the row with the largest first entry to the front, and returns its former place.
#[inline(always)]
fn exchange<T: Copy>(waiting: &mut [T], length: usize, size: impl Fn(usize, &T) -> f64) -> usize {
    let first = |row: usize| size(row, &waiting[row * length]);
    let rows = waiting.len() / length;
    let largest = (1..rows).fold(0, |most, row| if first(row) > first(most) { row } else { most });
    if largest > 0 {
        let (front, others) = waiting.split_at_mut(length);
        front.swap_with_slice(&mut others[(largest - 1) * length..largest * length]);
    }
    largest
}

/// A factored T(s).
///
/// Rows wait for their elimination in `width + 1` places. At each step the pivot row is the first;
/// the next row takes its place.
pub(super) struct Factors {
    width: usize,
    /// Inverse of each pivot, followed by the entries right of it.
    upper: Vec<Complex64>,
    /// Multiples of the pivot row subtracted from others, place after place.
    lower: Vec<Complex64>,
    /// Place of the row that became the pivot row.
    exchanged: Vec<usize>,
}

impl Factors {
    fn row(&self, step: usize) -> &[Complex64] {
        &self.upper[step * (2 * self.width + 1)..(step + 1) * (2 * self.width + 1)]
    }

    fn shares(&self, step: usize) -> &[Complex64] {
        &self.lower[step * self.width..(step + 1) * self.width]
    }

    /// Solves T x = b in place.
    pub(super) fn solve(&self, b: &mut [Complex64]) {
        let at = |b: &[Complex64], index: usize| b.get(index).copied().unwrap_or_default();
        let mut waiting: Vec<Complex64> = (0..=self.width).map(|index| at(b, index)).collect();
        for step in 0..b.len() {
            waiting.swap(0, self.exchanged[step]);
            let value = waiting[0];
            for (other, share) in waiting[1..].iter_mut().zip(self.shares(step)) {
                *other -= share * value;
            }
            waiting[0] = at(b, step + self.width + 1);
            b[step] = value;
        }
        for step in (0..b.len()).rev() {
            let row = self.row(step);
            let known = row[1..].iter().zip(&b[step + 1..]).map(|(entry, x)| entry * x);
            let known: Complex64 = known.sum();
            b[step] = (b[step] - known) * row[0];
        }
    }

    /// Solves T^T x = b in place.
    pub(super) fn solve_transposed(&self, b: &mut [Complex64]) {
        let size = b.len();
        for step in 0..size {
            let row = self.row(step);
            let value = b[step] * row[0];
            b[step] = value;
            for (other, entry) in b[step + 1..].iter_mut().zip(&row[1..]) {
                *other -= entry * value;
            }
        }
        let mut waiting = vec![Complex64::ZERO; self.width + 1];
        for step in (0..size).rev() {
            if let Some(last) = b.get_mut(step + self.width + 1) {
                *last = waiting[0];
            }
            let known = waiting[1..].iter().zip(self.shares(step)).map(|(x, share)| x * share);
            waiting[0] = b[step] - known.sum::<Complex64>();
            waiting.swap(0, self.exchanged[step]);
        }
        b.iter_mut().zip(&waiting).for_each(|(into, value)| *into = *value);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Returns a reproducible matrix with coordinates and states in alternation; every third
    /// diagonal entry is zero, so that rows are exchanged.
    fn pencil(size: usize, width: usize) -> Pencil {
        let mut pencil = Pencil::new((0..size).map(|row| row % 3 != 1).collect(), width);
        for row in 0..size {
            for column in pencil.columns(row).filter(|column| *column != row || row % 3 > 0) {
                let entry = |k: usize| ((7 * row + 3 * column + k) as f64 * 1.3).sin();
                pencil.subtract(row, column, false, entry(0));
                if pencil.is_coordinate[column] {
                    pencil.subtract(row, column, true, entry(1));
                }
            }
        }
        pencil
    }

    #[test]
    fn factors_solve_with_the_matrix_and_with_its_transpose() {
        for (size, width) in [(1, 0), (2, 1), (5, 1), (40, 1), (41, 2), (30, 5), (4, 3)] {
            let pencil = pencil(size, width);
            let s = Complex64::new(0.01, 0.02);
            let factors = pencil.factors(s);
            let wanted: Vec<_> =
                (0..size).map(|k| Complex64::new(1.0 + k as f64, (k as f64).sin())).collect();
            let [mut found, _] = pencil.times(s, &wanted);
            factors.solve(&mut found);
            let mut transposed = vec![Complex64::ZERO; size];
            for (row, wanted) in wanted.iter().enumerate() {
                for column in pencil.columns(row) {
                    transposed[column] += pencil.entry(row, column, s).value * wanted;
                }
            }
            factors.solve_transposed(&mut transposed);
            for ((found, transposed), wanted) in found.iter().zip(&transposed).zip(&wanted) {
                assert!((found - wanted).norm() < 1e-9, "{size} {width}: {found} {wanted}");
                assert!((transposed - wanted).norm() < 1e-9, "{size} {width}: {transposed}");
            }
        }
    }

    #[test]
    fn slopes_of_determinants_are_those_of_the_product_of_their_zeros() {
        let pencil = pencil(23, 2);
        for rows in [0..23, 4..17, 9..10] {
            let matrix = pencil.companion(rows.clone());
            assert_eq!(matrix.nrows(), pencil.degree(rows.clone()));
            let zeros = matrix.complex_eigenvalues();
            for s in [Complex64::new(0.3, 1.1), Complex64::new(-0.7, 0.2)] {
                let expected: Complex64 = zeros.iter().map(|zero| (s - zero).inv()).sum();
                let found = pencil.logarithmic_slope(rows.clone(), s).expect("none is there");
                assert!((found - expected).norm() < 1e-10 * expected.norm(), "{found} {expected}");
            }
            if rows == (0..23) {
                let [sum, squares] = pencil.traces();
                assert!((zeros.sum().re - sum).abs() < 1e-12 * zeros.len() as f64);
                let found: Complex64 = zeros.iter().map(|zero| zero * zero).sum();
                assert!((found.re - squares).abs() < 1e-11 * zeros.len() as f64);
            }
        }
    }

    #[test]
    fn singular_factors_give_the_vector_that_is_taken_to_nothing() {
        // Springs of 1e4 between masses of 1: w = 100 has the shape sin(k pi/3).
        let mut pencil = Pencil::new(vec![true; 50], 1);
        for row in 0..50 {
            for column in pencil.columns(row) {
                pencil.subtract(row, column, false, if row == column { -2e4 } else { 1e4 });
            }
        }
        let s = Complex64::new(0.0, 100.0);
        assert!(pencil.logarithmic_slope(0..50, s).is_none());
        let factors = pencil.factors(s);
        let solves = [Factors::solve, Factors::solve_transposed];
        for solve in solves {
            let mut vector: Vec<_> =
                (0..50).map(|k| Complex64::from((f64::from(k) * 1.7).cos())).collect();
            solve(&factors, &mut vector);
            let first = vector[0];
            for (k, x) in (1..).zip(&vector) {
                let expected = (f64::from(k) * std::f64::consts::PI / 3.0).sin() / 0.75_f64.sqrt();
                assert!((x / first - expected).norm() < 1e-12, "{k}: {}", x / first);
            }
        }
    }
}

//! Factorization of a banded matrix with a border, real and complex: work and room
//! grow with its size times its band.

use nalgebra::ComplexField;

use super::lu::{Lu, Singular};

/// The matrix
///
/// ```text
/// A B     A banded, factored by partial pivoting
/// C D     S = D - C A^-1 B, factored as it is small
/// ```
///
/// with the rows and columns of the border wherever they are.
///
/// Source: Golub, Van Loan, "Matrix computations", 4.3 on bands; block elimination.
pub(super) struct Bordered<S> {
    /// Where each row is: in the band, or in the border.
    places: Vec<Place>,
    band: Band<S>,
    /// Nonzeros of B by columns, and of C: (border, band, value).
    right: Vec<(u32, u32, S)>,
    below: Vec<(u32, u32, S)>,
    /// Columns of A^-1 B that are not zero, with their number.
    solved: Vec<(usize, Vec<S>)>,
    /// Columns of former factorizations, for their room.
    spare: Vec<Vec<S>>,
    corner: Lu<S>,
    /// Parts of a right-hand side.
    of_band: Vec<S>,
    of_border: Vec<S>,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Place {
    Band(u32),
    Border(u32),
}

impl<S: ComplexField<RealField = f64> + Copy> Bordered<S> {
    /// Room for a matrix of `size` with this border, ascending, and these nonzeros.
    pub(super) fn new(
        size: usize,
        border: &[usize],
        entries: impl Iterator<Item = (usize, usize)>,
    ) -> Self {
        let mut places = Vec::with_capacity(size);
        let mut of_border = border.iter().peekable();
        let (mut band, mut edge) = (0, 0);
        for index in 0..size {
            if of_border.next_if(|border| **border == index).is_some() {
                places.push(Place::Border(edge));
                edge += 1;
            } else {
                places.push(Place::Band(band));
                band += 1;
            }
        }
        let distances = entries.map(|(row, column)| match (places[row], places[column]) {
            (Place::Band(row), Place::Band(column)) => row.abs_diff(column) as usize,
            _ => 0,
        });
        let width = distances.max().unwrap_or(0);
        Self {
            band: Band::new(band as usize, width),
            right: Vec::new(),
            below: Vec::new(),
            solved: Vec::new(),
            spare: Vec::new(),
            corner: Lu::new(edge as usize),
            of_band: vec![S::zero(); band as usize],
            of_border: vec![S::zero(); edge as usize],
            places,
        }
    }

    /// Number of rows.
    pub(super) fn size(&self) -> usize {
        self.places.len()
    }

    /// Makes the matrix zero, for [`Bordered::add`].
    pub(super) fn clear(&mut self) {
        self.band.entries.fill(S::zero());
        self.corner.clear();
        self.right.clear();
        self.below.clear();
    }

    /// Adds to an entry of a matrix that is not factored.
    pub(super) fn add(&mut self, row: usize, column: usize, value: S) {
        match (self.places[row], self.places[column]) {
            (Place::Band(row), Place::Band(column)) => {
                *self.band.entry(row as usize, column as usize) += value;
            }
            (Place::Band(row), Place::Border(column)) => self.right.push((column, row, value)),
            (Place::Border(row), Place::Band(column)) => self.below.push((row, column, value)),
            (Place::Border(row), Place::Border(column)) => {
                self.corner.add(row as usize, column as usize, value);
            }
        }
    }

    /// Factors the matrix.
    ///
    /// # Errors
    /// [`Singular`], also where entries are not finite.
    pub(super) fn factor(&mut self) -> Result<(), Singular> {
        self.band.factor()?;
        self.spare.extend(self.solved.drain(..).map(|(_, column)| column));
        self.right.sort_by_key(|(column, row, _)| (*column, *row));
        for entries in self.right.chunk_by(|(a, ..), (b, ..)| a == b) {
            let mut column = self.spare.pop().unwrap_or_default();
            column.clear();
            column.resize(self.band.size, S::zero());
            for (_, row, value) in entries {
                column[*row as usize] += *value;
            }
            self.band.solve(&mut column);
            let number = entries[0].0 as usize;
            for (row, inner, value) in &self.below {
                self.corner.add(*row as usize, number, -*value * column[*inner as usize]);
            }
            self.solved.push((number, column));
        }
        self.corner.factor()
    }

    /// Solves for x; b becomes x.
    pub(super) fn solve(&mut self, b: &mut [S]) {
        for (place, value) in self.places.iter().zip(&*b) {
            match place {
                Place::Band(index) => self.of_band[*index as usize] = *value,
                Place::Border(index) => self.of_border[*index as usize] = *value,
            }
        }
        self.band.solve(&mut self.of_band);
        for (row, inner, value) in &self.below {
            self.of_border[*row as usize] -= *value * self.of_band[*inner as usize];
        }
        self.corner.solve(&mut self.of_border);
        for (number, column) in &self.solved {
            let known = self.of_border[*number];
            for (value, entry) in self.of_band.iter_mut().zip(column) {
                *value -= *entry * known;
            }
        }
        for (place, value) in self.places.iter().zip(b) {
            *value = match place {
                Place::Band(index) => self.of_band[*index as usize],
                Place::Border(index) => self.of_border[*index as usize],
            };
        }
    }
}

/// P A = L U of a matrix with `width` diagonals on each side, stored over A: row i
/// holds the columns from i - width to i + 2 width, as far as exchanges fill it.
struct Band<S> {
    size: usize,
    width: usize,
    entries: Vec<S>,
    pivots: Vec<usize>,
}

impl<S: ComplexField<RealField = f64> + Copy> Band<S> {
    fn new(size: usize, width: usize) -> Self {
        Self {
            size,
            width,
            entries: vec![S::zero(); size * (3 * width + 1)],
            pivots: vec![0; size],
        }
    }

    fn place(&self, row: usize, column: usize) -> usize {
        row * (3 * self.width + 1) + column + self.width - row
    }

    fn entry(&mut self, row: usize, column: usize) -> &mut S {
        let place = self.place(row, column);
        &mut self.entries[place]
    }

    fn factor(&mut self) -> Result<(), Singular> {
        for k in 0..self.size {
            let bottom = (k + self.width + 1).min(self.size);
            let end = (k + 2 * self.width + 1).min(self.size);
            let size_of = |row: usize| self.entries[self.place(row, k)].norm1();
            let mut pivot = (k, size_of(k));
            for row in k + 1..bottom {
                let size = size_of(row);
                if size > pivot.1 {
                    pivot = (row, size);
                }
            }
            if !(pivot.1 > 0.0 && pivot.1.is_finite()) {
                return Err(Singular);
            }
            self.pivots[k] = pivot.0;
            if pivot.0 != k {
                for column in k..end {
                    let (upper, lower) = (self.place(k, column), self.place(pivot.0, column));
                    self.entries.swap(upper, lower);
                }
            }
            let first = self.place(k, k);
            let inverse = self.entries[first].recip();
            for row in k + 1..bottom {
                let start = self.place(row, k);
                if self.entries[start].is_zero() {
                    continue;
                }
                let factor = self.entries[start] * inverse;
                self.entries[start] = factor;
                let (above, below) = self.entries.split_at_mut(start);
                let above = &above[first + 1..first + end - k];
                for (entry, above) in below[1..].iter_mut().zip(above) {
                    *entry -= factor * *above;
                }
            }
        }
        Ok(())
    }

    fn solve(&self, b: &mut [S]) {
        for k in 0..self.size {
            b.swap(k, self.pivots[k]);
            let known = b[k];
            if known.is_zero() {
                continue;
            }
            let bottom = (k + self.width + 1).min(self.size);
            for (row, value) in (k + 1..bottom).zip(&mut b[k + 1..bottom]) {
                *value -= self.entries[self.place(row, k)] * known;
            }
        }
        for row in (0..self.size).rev() {
            let end = (row + 2 * self.width + 1).min(self.size);
            let first = self.place(row, row);
            let entries = &self.entries[first..first + end - row];
            let (unknown, known) = b[row..].split_at_mut(1);
            let mut sum = unknown[0];
            for (entry, value) in entries[1..].iter().zip(known) {
                sum -= *entry * *value;
            }
            unknown[0] = sum / entries[0];
        }
    }
}

#[cfg(test)]
mod tests {
    use num_complex::Complex64;

    use super::*;

    /// Numbers that look random and are the same every time.
    fn number(row: usize, column: usize) -> f64 {
        let value = ((row * 7 + column * 13 + 3) as f64 * 12.9898).sin() * 43758.5453;
        value - value.floor() - 0.5
    }

    fn check<S: ComplexField<RealField = f64> + Copy>(of: impl Fn(f64, f64) -> S) {
        for (size, width, border) in
            [(1, 0, vec![]), (9, 1, vec![0, 4]), (40, 3, vec![0, 1, 20, 39]), (12, 2, vec![])]
        {
            let is_border = |index: usize| border.contains(&index);
            let inner = |index: usize| index - border.iter().filter(|b| **b < index).count();
            let value = |row: usize, column: usize| {
                let near = inner(row).abs_diff(inner(column)) <= width;
                let used = is_border(row) || is_border(column) || near;
                // Small on the diagonal, so that rows are exchanged.
                let scale = if row == column { 0.01 } else { 1.0 };
                used.then(|| of(scale * number(row, column), scale * number(column, row)))
            };
            let places = || (0..size).flat_map(|row| (0..size).map(move |column| (row, column)));
            let nonzeros = places().filter(|(row, column)| value(*row, *column).is_some());
            let mut matrix = Bordered::<S>::new(size, &border, nonzeros);
            assert_eq!(matrix.band.width, width.min(size - border.len() - 1));
            for _ in 0..2 {
                matrix.clear();
                for (row, column) in places() {
                    if let Some(value) = value(row, column) {
                        matrix.add(row, column, value);
                    }
                }
                matrix.factor().unwrap();
            }
            let b: Vec<S> = (0..size).map(|i| of(number(i, 99), number(99, i))).collect();
            let mut x = b.clone();
            matrix.solve(&mut x);
            let norm = x.iter().map(|x| x.norm1()).fold(1.0, f64::max);
            for (row, known) in b.iter().enumerate() {
                let products = (0..size).filter_map(|c| Some(value(row, c)? * x[c]));
                let sum = products.fold(S::zero(), |sum, product| sum + product);
                assert!((sum - *known).norm1() < 1e-11 * norm, "{size}, {width}, {border:?}");
            }
        }
    }

    #[test]
    fn a_solution_satisfies_its_equations_with_band_and_border() {
        check::<f64>(|real, _| real);
        check::<Complex64>(Complex64::new);
    }

    #[test]
    fn a_matrix_without_pivot_is_singular() {
        for value in [0.0, f64::NAN] {
            let mut matrix = Bordered::<f64>::new(3, &[1], [(0, 2)].into_iter());
            matrix.clear();
            matrix.add(0, 0, value);
            matrix.add(1, 1, 1.0);
            matrix.add(2, 2, 1.0);
            assert_eq!(matrix.factor(), Err(Singular));
        }
    }
}

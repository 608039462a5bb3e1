//! Factorization of a banded matrix with a border, real and complex: time and memory grow with its
//! size times its bandwidth.

mod band;

use nalgebra::ComplexField;

use super::lu::{Lu, Singular};
use band::Band;

/// A banded matrix with a border,
///
/// ```text
/// A B     A banded, factored by partial pivoting
/// C D     S = D - C A^-1 B, factored as it is small
/// ```
/// where the rows and columns of the border may be anywhere. Entries are written to places known
/// from the pattern: those of A, the nonzeros of B and of C, then all of D.
///
/// Source: Golub, Van Loan, "Matrix computations", 4.3 on bands; block elimination.
pub(super) struct Bordered<S> {
    values: Vec<S>,
    /// Places of the entries of the pattern, and of the diagonal.
    targets: Vec<u32>,
    diagonal: Vec<u32>,
    /// Neighbouring rows of the band: (first row, first row of the band, count).
    runs: Vec<[usize; 3]>,
    /// Rows of the border.
    border: Vec<usize>,
    band: Band<S>,
    /// Nonzero columns of B.
    right: Vec<Column<S>>,
    /// Nonzeros of C: (border, band, place).
    below: Vec<[u32; 3]>,
    /// First place of D.
    corner_at: usize,
    corner: Lu<S>,
    /// Parts of a right-hand side.
    of_band: Vec<S>,
    of_border: Vec<S>,
}

/// A column of B.
struct Column<S> {
    number: usize,
    /// Nonzeros: (row of the band, place).
    entries: Vec<[u32; 2]>,
    /// Column of A^-1 B.
    solved: Vec<S>,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Place {
    Band(u32),
    Border(u32),
}

impl<S: ComplexField<RealField = f64> + Copy> Bordered<S> {
    /// Creates the structure for a matrix of `size` with this border, ascending, and these
    /// nonzeros.
    pub(super) fn new(size: usize, border: &[usize], entries: &[(usize, usize)]) -> Self {
        let (places, runs) = places(size, border);
        let in_band = size - border.len();
        let of = |(row, column): (usize, usize)| (places[row], places[column]);
        let distances = entries.iter().map(|entry| match of(*entry) {
            (Place::Band(row), Place::Band(column)) => row.abs_diff(column) as usize,
            _ => 0,
        });
        let band = Band::new(in_band, distances.max().unwrap_or(0));
        let mut layout = Layout { band, right: Vec::new(), below: Vec::new() };
        let diagonal = (0..size).map(|index| (index, index));
        let all = entries.iter().copied().chain(diagonal);
        let spots: Vec<Spot> = all.map(|entry| layout.spot(of(entry))).collect();
        let Layout { band, right, below, .. } = layout;
        let right_at = band.places();
        let below_at = right_at + right.len();
        let corner_at = below_at + below.len();
        let target = |spot: &Spot| match *spot {
            Spot::Band(place) => place,
            Spot::Right(index) => right_at + index,
            Spot::Below(index) => below_at + index,
            Spot::Corner(row, column) => corner_at + row * border.len() + column,
        };
        let mut targets: Vec<u32> = spots.iter().map(|spot| target(spot) as u32).collect();
        let diagonal = targets.split_off(entries.len());
        let below = (0..)
            .zip(&below)
            .map(|(index, [row, column])| [*row, *column, (below_at + index) as u32]);
        Self {
            values: vec![S::zero(); corner_at + border.len() * border.len()],
            targets,
            diagonal,
            runs,
            border: border.to_vec(),
            right: columns(&right, right_at, in_band),
            below: below.collect(),
            corner_at,
            corner: Lu::new(border.len()),
            of_band: vec![S::zero(); in_band],
            of_border: vec![S::zero(); border.len()],
            band,
        }
    }

    /// Sets the matrix to `diagonal` times the unit matrix. Returns its entries, to be added to,
    /// and their places in the order of the pattern.
    pub(super) fn start(&mut self, diagonal: S) -> (&mut [S], &[u32]) {
        self.values.fill(S::zero());
        for place in &self.diagonal {
            self.values[*place as usize] = diagonal;
        }
        (&mut self.values, &self.targets)
    }

    /// Factors the matrix.
    ///
    /// # Errors
    /// [`Singular`], also where entries are not finite.
    pub(super) fn factor(&mut self) -> Result<(), Singular> {
        self.band.factor(&mut self.values)?;
        let size = self.border.len();
        for column in &mut self.right {
            column.solved.fill(S::zero());
            for [row, place] in &column.entries {
                column.solved[*row as usize] = self.values[*place as usize];
            }
            self.band.solve(&self.values, &mut column.solved);
            for [row, inner, place] in &self.below {
                let product = self.values[*place as usize] * column.solved[*inner as usize];
                self.values[self.corner_at + *row as usize * size + column.number] -= product;
            }
        }
        self.corner.clear();
        for (index, value) in self.values[self.corner_at..].iter().enumerate() {
            if !value.is_zero() {
                self.corner.add(index / size, index % size, *value);
            }
        }
        self.corner.factor()
    }

    /// Solves for x in place of b.
    pub(super) fn solve(&mut self, b: &mut [S]) {
        for [row, inner, count] in &self.runs {
            self.of_band[*inner..inner + count].copy_from_slice(&b[*row..row + count]);
        }
        for (value, row) in self.of_border.iter_mut().zip(&self.border) {
            *value = b[*row];
        }
        self.band.solve(&self.values, &mut self.of_band);
        for [row, inner, place] in &self.below {
            self.of_border[*row as usize] -=
                self.values[*place as usize] * self.of_band[*inner as usize];
        }
        self.corner.solve(&mut self.of_border);
        for column in &self.right {
            let known = self.of_border[column.number];
            for (value, entry) in self.of_band.iter_mut().zip(&column.solved) {
                *value -= *entry * known;
            }
        }
        for [row, inner, count] in &self.runs {
            b[*row..row + count].copy_from_slice(&self.of_band[*inner..inner + count]);
        }
        for (value, row) in self.of_border.iter().zip(&self.border) {
            b[*row] = *value;
        }
    }
}

/// Returns the place of each row, and the runs of rows in the band.
fn places(size: usize, border: &[usize]) -> (Vec<Place>, Vec<[usize; 3]>) {
    let mut places = Vec::with_capacity(size);
    let mut runs: Vec<[usize; 3]> = Vec::new();
    let mut of_border = border.iter().peekable();
    let (mut band, mut edge) = (0, 0);
    for index in 0..size {
        if of_border.next_if(|border| **border == index).is_some() {
            places.push(Place::Border(edge));
            edge += 1;
            continue;
        }
        match runs.last_mut().filter(|[row, _, count]| row + count == index) {
            Some([_, _, count]) => *count += 1,
            None => runs.push([index, band as usize, 1]),
        }
        places.push(Place::Band(band));
        band += 1;
    }
    (places, runs)
}

/// Nonzeros as they are found, each once.
struct Layout<S> {
    band: Band<S>,
    /// Nonzeros of B as (column, row), of C as (row, column).
    right: Vec<[u32; 2]>,
    below: Vec<[u32; 2]>,
}

/// A nonzero, by its index among those of its kind.
enum Spot {
    Band(usize),
    Right(usize),
    Below(usize),
    Corner(usize, usize),
}

impl<S: ComplexField<RealField = f64> + Copy> Layout<S> {
    fn spot(&mut self, entry: (Place, Place)) -> Spot {
        let number = |list: &mut Vec<[u32; 2]>, entry: [u32; 2]| {
            list.iter().position(|known| *known == entry).unwrap_or_else(|| {
                list.push(entry);
                list.len() - 1
            })
        };
        match entry {
            (Place::Band(row), Place::Band(column)) => {
                Spot::Band(self.band.place(row as usize, column as usize))
            }
            (Place::Band(row), Place::Border(column)) => {
                Spot::Right(number(&mut self.right, [column, row]))
            }
            (Place::Border(row), Place::Band(column)) => {
                Spot::Below(number(&mut self.below, [row, column]))
            }
            (Place::Border(row), Place::Border(column)) => {
                Spot::Corner(row as usize, column as usize)
            }
        }
    }
}

/// Returns the columns of B from its nonzeros.
fn columns<S: ComplexField<RealField = f64> + Copy>(
    entries: &[[u32; 2]],
    first: usize,
    size: usize,
) -> Vec<Column<S>> {
    let mut columns: Vec<Column<S>> = Vec::new();
    for (index, [column, row]) in entries.iter().enumerate() {
        let (number, entry) = (*column as usize, [*row, (first + index) as u32]);
        if let Some(known) = columns.iter_mut().find(|known| known.number == number) {
            known.entries.push(entry);
        } else {
            columns.push(Column { number, entries: vec![entry], solved: vec![S::zero(); size] });
        }
    }
    columns
}

#[cfg(test)]
mod tests {
    use num_complex::Complex64;

    use super::*;

    /// Returns reproducible random numbers.
    fn number(row: usize, column: usize) -> f64 {
        fastrand::Rng::with_seed((row * 1000 + column) as u64).f64() - 0.5
    }

    fn check<S: ComplexField<RealField = f64> + Copy>(of: impl Fn(f64, f64) -> S, diagonal: f64) {
        for (size, width, border) in [
            (1, 0, vec![]),
            (9, 1, vec![0, 4]),
            (30, 1, vec![]),
            (40, 3, vec![0, 1, 20, 39]),
            (12, 2, vec![]),
        ] {
            let is_border = |index: usize| border.contains(&index);
            let inner = |index: usize| index - border.iter().filter(|b| **b < index).count();
            let value = |row: usize, column: usize| {
                let near = inner(row).abs_diff(inner(column)) <= width;
                let used = is_border(row) || is_border(column) || near;
                let scale = if row == column { diagonal } else { 1.0 };
                used.then(|| of(scale * number(row, column), scale * number(column, row)))
            };
            let places = || (0..size).flat_map(|row| (0..size).map(move |column| (row, column)));
            let nonzeros = places().filter(|(row, column)| value(*row, *column).is_some());
            let nonzeros: Vec<(usize, usize)> = nonzeros.collect();
            let mut matrix = Bordered::<S>::new(size, &border, &nonzeros);
            assert_eq!(matrix.band.width(), width.min(size - border.len() - 1));
            for _ in 0..2 {
                let (values, targets) = matrix.start(S::zero());
                for ((row, column), target) in nonzeros.iter().zip(targets) {
                    values[*target as usize] += value(*row, *column).unwrap();
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
        // Small diagonals cause exchanges of rows, large ones do not.
        for diagonal in [0.01, 300.0] {
            check::<f64>(|real, _| real, diagonal);
            check::<Complex64>(Complex64::new, diagonal);
        }
    }

    #[test]
    fn a_matrix_without_pivot_is_singular() {
        for value in [0.0, f64::NAN] {
            let mut matrix = Bordered::<f64>::new(3, &[1], &[(0, 0), (0, 2)]);
            let (values, targets) = matrix.start(1.0);
            values[targets[0] as usize] = value;
            assert_eq!(matrix.factor(), Err(Singular));
        }
    }
}

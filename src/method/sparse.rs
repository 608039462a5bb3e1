//! Factorization of small sparse matrices, real and complex, in an order chosen once from the
//! pattern of nonzeros.

use std::iter;
use std::ops::Range;

use nalgebra::ComplexField;

/// Maximum ratio of a change of a later pivot to that pivot: a larger one would lose too many
/// digits. The ratio does not depend on units, unlike multipliers.
const LARGEST: f64 = 1e4;

/// Error for a pivot that is zero, not finite, or too small beside the entries below and right of
/// it: rows would have to be exchanged.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct NeedsExchange;

/// P A P^T = L D U, stored in place of A's nonzeros and the fill-in. The fill-in and the
/// destinations of all products are known beforehand.
///
/// Pivots are on the diagonal, which is nearly always possible for step matrices.
///
/// Source: minimum degree order, George, Liu, "The evolution of the minimum degree
/// ordering algorithm", SIAM Review 31 (1989).
pub(super) struct Sparse<S> {
    size: usize,
    /// Diagonal by rows, inverted once factored; then the entries below each pivot, and those right
    /// of it, both in the order of the pairs.
    values: Vec<S>,
    /// Places of the entries of the pattern.
    targets: Vec<u32>,
    elimination: Elimination,
    /// Places of products of entries below and right of a pivot, in the order in which these are
    /// subtracted.
    products: Vec<u32>,
}

impl<S: ComplexField<RealField = f64> + Copy> Sparse<S> {
    /// Creates the structure for a matrix of `size` with these nonzeros; `None` if the fill-in is
    /// so large that a dense matrix is no slower.
    pub(super) fn new(size: usize, entries: &[(usize, usize)]) -> Option<Self> {
        let elimination = Elimination::new(size, entries);
        let pairs = elimination.pairs.len();
        let nonzeros = size + 2 * pairs;
        if 2 * nonzeros > size * size {
            return None;
        }
        let mut places = vec![0; size * size];
        for index in 0..size {
            places[index * size + index] = index as u32;
        }
        for (index, [pivot, other]) in elimination.pairs.iter().enumerate() {
            let (pivot, other) = (*pivot as usize, *other as usize);
            places[other * size + pivot] = (size + index) as u32;
            places[pivot * size + other] = (size + pairs + index) as u32;
        }
        let place = |row: usize, column: usize| places[row * size + column];
        let targets = entries.iter().map(|(row, column)| place(*row, *column)).collect();
        let mut products = Vec::with_capacity(nonzeros);
        for (_, range) in elimination.pivots() {
            let around = &elimination.pairs[range];
            for [_, row] in around {
                let columns = around.iter().map(|[_, column]| *column as usize);
                products.extend(columns.map(|column| place(*row as usize, column)));
            }
        }
        Some(Self { size, values: vec![S::zero(); nonzeros], targets, elimination, products })
    }

    /// Returns the number of rows.
    pub(super) fn size(&self) -> usize {
        self.size
    }

    /// Sets the matrix to `diagonal` times the unit matrix. Returns its entries, to be added to,
    /// and their places in the order of the pattern.
    pub(super) fn start(&mut self, diagonal: S) -> (&mut [S], &[u32]) {
        let (on_diagonal, others) = self.values.split_at_mut(self.size);
        on_diagonal.fill(diagonal);
        others.fill(S::zero());
        (&mut self.values, &self.targets)
    }

    /// Factors the matrix.
    ///
    /// # Errors
    /// [`NeedsExchange`]; the matrix is then lost.
    pub(super) fn factor(&mut self) -> Result<(), NeedsExchange> {
        let mut products = self.products.as_slice();
        let first_right = self.size + self.elimination.pairs.len();
        for (row, range) in self.elimination.pivots() {
            let pivot = self.values[row];
            let inverse = pivot.recip();
            if !(pivot.is_finite() && inverse.is_finite()) {
                return Err(NeedsExchange);
            }
            self.values[row] = inverse;
            let right = first_right + range.start..first_right + range.end;
            for pair in range {
                let (places, rest) = products.split_at(right.len());
                products = rest;
                let below = self.values[self.size + pair];
                if below.is_zero() {
                    continue;
                }
                let multiplier = below * inverse;
                self.values[self.size + pair] = multiplier;
                let taken = multiplier * self.values[first_right + pair];
                let later = self.values[self.elimination.pairs[pair][1] as usize];
                // This also rejects NaN.
                let is_sound = taken.norm1() <= LARGEST * later.norm1();
                if !is_sound {
                    return Err(NeedsExchange);
                }
                for (place, entry) in places.iter().zip(right.clone()) {
                    let product = multiplier * self.values[entry];
                    self.values[*place as usize] -= product;
                }
            }
            for entry in &mut self.values[right] {
                *entry *= inverse;
            }
        }
        Ok(())
    }

    /// Solves A x = b in place.
    pub(super) fn solve(&self, b: &mut [S]) {
        let pairs = &self.elimination.pairs;
        let (inverses, others) = self.values.split_at(self.size);
        let (below, right) = others.split_at(pairs.len());
        for ([pivot, other], entry) in pairs.iter().zip(below) {
            let known = b[*pivot as usize];
            b[*other as usize] -= *entry * known;
        }
        for (value, inverse) in b.iter_mut().zip(inverses) {
            *value *= *inverse;
        }
        for ([pivot, other], entry) in pairs.iter().zip(right).rev() {
            let known = b[*other as usize];
            b[*pivot as usize] -= *entry * known;
        }
    }
}

/// Order of elimination of rows and columns, with their neighbours.
struct Elimination {
    /// Row of each pivot, and one past its last pair.
    pivots: Vec<(usize, usize)>,
    /// Each pivot with its later neighbours, as rows below it and columns right of it.
    pairs: Vec<[u32; 2]>,
}

impl Elimination {
    /// Chooses the row with the fewest neighbours next; its neighbours then become neighbours of
    /// each other. Of several rows, it takes the one that has waited longest for a pivot next to
    /// it, so that the next operation of a solution seldom depends on the previous one.
    fn new(size: usize, entries: &[(usize, usize)]) -> Self {
        const BITS: usize = u64::BITS as usize;
        let words = size.div_ceil(BITS).max(1);
        // Neighbours of each row as bits, without itself.
        let mut met = vec![0u64; size * words];
        for &(row, column) in entries.iter().filter(|(row, column)| row != column) {
            met[row * words + column / BITS] |= 1 << (column % BITS);
            met[column * words + row / BITS] |= 1 << (row % BITS);
        }
        let degree = |met: &[u64], row: usize| -> u32 {
            met[row * words..][..words].iter().map(|word| word.count_ones()).sum()
        };
        let mut degrees: Vec<u32> = (0..size).map(|row| degree(&met, row)).collect();
        let mut touched = vec![0; size];
        let mut waiting: Vec<u32> = (0..size as u32).collect();
        let (mut pivots, mut pairs) = (Vec::with_capacity(size), Vec::new());
        while let Some((index, &row)) = waiting
            .iter()
            .enumerate()
            .min_by_key(|(_, row)| (degrees[**row as usize], touched[**row as usize]))
        {
            waiting.remove(index);
            let around: Vec<u64> = met[row as usize * words..][..words].to_vec();
            for &other in &waiting {
                let at = other as usize;
                if around[at / BITS] >> (at % BITS) & 1 == 0 {
                    continue;
                }
                pairs.push([row, other]);
                let its = &mut met[at * words..][..words];
                its.iter_mut().zip(&around).for_each(|(its, around)| *its |= around);
                for gone in [row as usize, at] {
                    its[gone / BITS] &= !(1 << (gone % BITS));
                }
                degrees[at] = degree(&met, at);
                touched[at] = pivots.len() + 1;
            }
            pivots.push((row as usize, pairs.len()));
        }
        Self { pivots, pairs }
    }

    /// Returns the row of each pivot with the range of its pairs.
    fn pivots(&self) -> impl Iterator<Item = (usize, Range<usize>)> {
        let starts = iter::once(0).chain(self.pivots.iter().map(|(_, end)| *end));
        self.pivots.iter().zip(starts).map(|((row, end), start)| (*row, start..*end))
    }
}

impl Sparse<f64> {
    /// Returns whether the determinant of the factored matrix is negative; rows and columns are
    /// permuted alike.
    pub(super) fn is_negative(&self) -> bool {
        self.values[..self.size].iter().filter(|inverse| **inverse < 0.0).count() % 2 == 1
    }
}

#[cfg(test)]
mod tests {
    use num_complex::Complex64;

    use super::*;

    /// Returns reproducible random numbers.
    fn number(row: usize, column: usize) -> f64 {
        fastrand::Rng::with_seed((row * 1000 + column) as u64).f64() - 0.5
    }

    /// Returns a chain whose one end is joined to four nodes that are joined to each other, like a
    /// motor on a shaft; every third link is coupled in one direction only.
    fn chain(size: usize) -> Vec<(usize, usize)> {
        let mut entries = Vec::new();
        for row in 0..size {
            for column in 0..size {
                let in_chain = row >= 4 && column >= 4 && row.abs_diff(column) == 1;
                let one_way = in_chain && row > column && row % 3 == 0;
                let at_end = row.max(column) <= 4;
                if (in_chain && !one_way) || at_end {
                    entries.push((row, column));
                }
            }
        }
        entries
    }

    fn check<S: ComplexField<RealField = f64> + Copy>(of: impl Fn(f64, f64) -> S) {
        for size in [12, 30, 90] {
            let entries = chain(size);
            let mut matrix = Sparse::<S>::new(size, &entries).unwrap();
            let value = |row, column| of(number(row, column), number(column, row));
            let diagonal = of(3.0, 0.5);
            // The second pass shows that nothing is left behind.
            for _ in 0..2 {
                let (values, targets) = matrix.start(diagonal);
                for ((row, column), target) in entries.iter().zip(targets) {
                    values[*target as usize] += value(*row, *column);
                }
                matrix.factor().unwrap();
            }
            let b: Vec<S> = (0..size).map(|index| of(number(index, 99), 1.0)).collect();
            let mut x = b.clone();
            matrix.solve(&mut x);
            for (row, known) in b.iter().enumerate() {
                let of_row = entries.iter().filter(|entry| entry.0 == row);
                let products = of_row.map(|(_, column)| value(row, *column) * x[*column]);
                let sum = products.fold(diagonal * x[row], |sum, product| sum + product);
                assert!((sum - *known).norm1() < 1e-13, "row {row} of {size}");
            }
        }
    }

    #[test]
    fn a_solution_satisfies_its_equations() {
        check::<f64>(|real, _| real);
        check::<Complex64>(Complex64::new);
    }

    #[test]
    fn nothing_comes_in_where_a_chain_is_eliminated_from_its_ends() {
        let tree = Elimination::new(9, &(0..8).map(|k| (k, k + 1)).collect::<Vec<_>>());
        assert_eq!(tree.pairs.len(), 8);
        // A star: its centre is joined to all others, and is eliminated last but one.
        let star = Elimination::new(9, &(1..9).map(|k| (0, k)).collect::<Vec<_>>());
        assert_eq!(star.pairs.len(), 8);
    }

    #[test]
    fn full_matrices_are_left_to_others() {
        let all: Vec<_> = (0..8).flat_map(|row| (0..8).map(move |column| (row, column))).collect();
        assert!(Sparse::<f64>::new(8, &all).is_none());
    }

    #[test]
    fn pivots_that_would_lose_digits_are_refused() {
        for pivot in [0.0, 1e-5, f64::NAN, f64::INFINITY] {
            let entries: Vec<_> = (0..11).map(|k| (k, k + 1)).chain([(1, 0)]).collect();
            let mut matrix = Sparse::<f64>::new(12, &entries).unwrap();
            let (values, targets) = matrix.start(1.0);
            for target in targets {
                values[*target as usize] = 1.0;
            }
            values[0] = pivot;
            assert_eq!(matrix.factor(), Err(NeedsExchange), "{pivot}");
        }
    }
}

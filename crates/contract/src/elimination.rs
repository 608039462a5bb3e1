//! Elimination along the diagonal for linear equations with a known sparsity pattern. The entries
//! to combine are listed in advance, so every real-time step takes the same operations and skips
//! structural zeros.
//!
//! ```text
//! W = L U,  L with ones on its diagonal      W x = b
//! ```
//!
//! Rows are not exchanged. That is sound for `W = I - g h J` if h is small compared with the
//! times in which the motion grows. Nothing checks this: a zero pivot gives numbers that are not
//! finite.

use crate::Real;

/// Elimination of one unknown.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Pivot {
    /// Place of the diagonal entry.
    pub place: u32,
    /// End of its rows in [`Elimination::rows`].
    pub rows_end: u32,
    /// End of its products in [`Elimination::products`].
    pub products_end: u32,
}

/// Substitution of one unknown.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Unknown {
    /// The unknown.
    pub row: u32,
    /// Place of its diagonal entry.
    pub diagonal: u32,
    /// Ends of its terms in [`Elimination::lower`] and [`Elimination::upper`].
    pub terms_end: [u32; 2],
}

/// A list of operations. Places are those of the entries of `W` and of its fill-in.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Elimination<'a> {
    /// Number of places.
    pub places: usize,
    /// Place of each structural nonzero of `J`.
    pub entries: &'a [u32],
    /// Unknowns in the order in which they are eliminated.
    pub pivots: &'a [Pivot],
    /// Places of entries that are divided by the pivot.
    pub rows: &'a [u32],
    /// (place, factor, other factor): the product of the factors is subtracted from the entry at
    /// the place.
    pub products: &'a [(u32, u32, u32)],
    /// Unknowns in the order of elimination.
    pub unknowns: &'a [Unknown],
    /// (place, unknown) of the entries left of the diagonal, unknown by unknown.
    pub lower: &'a [(u32, u32)],
    /// The same right of the diagonal, from the last unknown to the first.
    pub upper: &'a [(u32, u32)],
}

impl Elimination<'_> {
    /// Factors `W = I - scale J`, given the nonzeros of `J`.
    ///
    /// # Panics
    /// If there are fewer places or values than the list refers to.
    #[inline]
    pub fn factor<R: Real>(&self, scale: R, jacobian: &[R], factors: &mut [R]) {
        factors[..self.places].fill(R::literal(0.0));
        for pivot in self.pivots {
            factors[pivot.place as usize] = R::literal(1.0);
        }
        for (&place, &value) in self.entries.iter().zip(jacobian) {
            let place = place as usize;
            factors[place] = factors[place] - scale * value;
        }
        let (mut row, mut product) = (0, 0);
        for pivot in self.pivots {
            let by = R::literal(1.0) / factors[pivot.place as usize];
            // The reciprocal is kept for the substitution, which would divide by the pivot.
            factors[pivot.place as usize] = by;
            while row < pivot.rows_end as usize {
                let place = self.rows[row] as usize;
                factors[place] = factors[place] * by;
                row += 1;
            }
            while product < pivot.products_end as usize {
                let (place, a, b) = self.products[product];
                let place = place as usize;
                factors[place] = factors[place] - factors[a as usize] * factors[b as usize];
                product += 1;
            }
        }
    }

    /// Solves `W x = b` in place.
    ///
    /// # Panics
    /// As [`Elimination::factor`].
    #[inline]
    pub fn solve<R: Real>(&self, factors: &[R], x: &mut [R]) {
        let mut term = 0;
        for unknown in self.unknowns {
            let mut sum = x[unknown.row as usize];
            while term < unknown.terms_end[0] as usize {
                let (place, of) = self.lower[term];
                sum = sum - factors[place as usize] * x[of as usize];
                term += 1;
            }
            x[unknown.row as usize] = sum;
        }
        term = 0;
        for unknown in self.unknowns.iter().rev() {
            let mut sum = x[unknown.row as usize];
            while term < unknown.terms_end[1] as usize {
                let (place, of) = self.upper[term];
                sum = sum - factors[place as usize] * x[of as usize];
                term += 1;
            }
            x[unknown.row as usize] = sum * factors[unknown.diagonal as usize];
        }
    }

    /// Returns the number of operations of [`Elimination::factor`] and of [`Elimination::solve`].
    #[must_use]
    pub fn operations(&self) -> [usize; 2] {
        let factor =
            2 * self.entries.len() + self.pivots.len() + self.rows.len() + 2 * self.products.len();
        let solve = 2 * (self.lower.len() + self.upper.len()) + self.unknowns.len();
        [factor, solve]
    }
}

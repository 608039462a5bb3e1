//! Linear equations with a matrix whose pattern is known beforehand, solved by elimination along
//! the diagonal: which entries to combine is a list that was worked out once, so that a step in
//! real time takes the same operations every time, and nothing that is structurally zero is
//! touched.
//!
//! ```text
//! W = L U,  L with ones on its diagonal      W x = b
//! ```
//!
//! Rows are not exchanged. That is sound for `W = I - g h J` where h is small beside the times in
//! which the motion grows, and is checked by nobody: a pivot of zero gives numbers that are not
//! finite.

use crate::Real;

/// The elimination of one unknown.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Pivot {
    /// Place of the entry on the diagonal.
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
    /// Place of its entry on the diagonal.
    pub diagonal: u32,
    /// Ends of its terms in [`Elimination::lower`] and [`Elimination::upper`].
    pub terms_end: [u32; 2],
}

/// A list of what to do. Places are those of the entries of `W` and of what fills in.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Elimination<'a> {
    /// Number of places.
    pub places: usize,
    /// Place of each structural nonzero of `J`.
    pub entries: &'a [u32],
    /// Unknowns in the order in which they are eliminated.
    pub pivots: &'a [Pivot],
    /// Places that are divided by the pivot.
    pub rows: &'a [u32],
    /// (place, factor, other factor): the first less the product of the others.
    pub products: &'a [(u32, u32, u32)],
    /// Unknowns in the same order.
    pub unknowns: &'a [Unknown],
    /// (place, unknown) of what stands left of the diagonal, unknown after unknown.
    pub lower: &'a [(u32, u32)],
    /// The same right of it, the last unknown first.
    pub upper: &'a [(u32, u32)],
}

impl Elimination<'_> {
    /// Factors `W = I - scale J` of the nonzeros of `J`.
    ///
    /// # Panics
    /// If there are fewer places or values than the list mentions.
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
            // Kept for the substitution, which would divide by it.
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

    /// Operations of [`Elimination::factor`] and of [`Elimination::solve`].
    #[must_use]
    pub fn operations(&self) -> [usize; 2] {
        let factor =
            2 * self.entries.len() + self.pivots.len() + self.rows.len() + 2 * self.products.len();
        let solve = 2 * (self.lower.len() + self.upper.len()) + self.unknowns.len();
        [factor, solve]
    }
}

//! Derivatives of the solution of linear equations, by the factors that solved them.
//!
//! For `K x = b` with known factors of `K`, the derivatives with respect to many numbers `s` are
//!
//! ```text
//! K dx/ds = db/ds - (dK/ds) x
//! ```
//!
//! with one right side for each `s` and the same matrix for all. The factorization is neither
//! differentiated nor repeated: [`substitute`] solves for all columns at once. Its steps are
//! planned when the equations are derived, and skip structural zeros.

use crate::Real;

/// Number of columns that are solved side by side: as many sums as half of the two-number
/// registers hold. Twice as many are taken if there are enough columns, half as many if there are
/// no more.
pub const LANES: usize = 8;

/// One step of a substitution: `x_row = scale x_row - sum of factor x_from`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Step<'a> {
    /// Row that changes.
    pub row: u32,
    /// Index of the factor that scales the row first, if any.
    pub scale: Option<u32>,
    /// (index of the factor, other row) of each product.
    pub terms: &'a [(u32, u32)],
}

impl<'a> Step<'a> {
    /// Returns the step `x_row -= sum of factor x_from`.
    #[must_use]
    pub const fn less(row: u32, terms: &'a [(u32, u32)]) -> Self {
        Self { row, scale: None, terms }
    }

    /// Returns the step `x_row = scale x_row - sum of factor x_from`.
    #[must_use]
    pub const fn scaled(row: u32, scale: u32, terms: &'a [(u32, u32)]) -> Self {
        Self { row, scale: Some(scale), terms }
    }
}

/// Solves for all columns of `x` at once, in place: right sides before, solution after. `factors`
/// are the values that steps refer to.
///
/// The bits of a column do not depend on the other columns.
///
/// # Panics
/// If a step refers to a row or a factor that does not exist.
#[inline]
#[allow(clippy::needless_pass_by_value, reason = "an iterator, cloned for each group of columns")]
pub fn substitute<'s, R: Real, const COLUMNS: usize>(
    steps: impl Iterator<Item = Step<'s>> + Clone,
    factors: &[R],
    x: &mut [[R; COLUMNS]],
) {
    let mut first = 0;
    while first + 2 * LANES <= COLUMNS {
        side_by_side::<R, COLUMNS, { 2 * LANES }>(steps.clone(), factors, x, first);
        first += 2 * LANES;
    }
    while first + LANES <= COLUMNS {
        side_by_side::<R, COLUMNS, LANES>(steps.clone(), factors, x, first);
        first += LANES;
    }
    while first + LANES / 2 <= COLUMNS {
        side_by_side::<R, COLUMNS, { LANES / 2 }>(steps.clone(), factors, x, first);
        first += LANES / 2;
    }
    while first < COLUMNS {
        side_by_side::<R, COLUMNS, 1>(steps.clone(), factors, x, first);
        first += 1;
    }
}

/// Takes all steps in `WIDTH` columns.
#[inline(always)]
fn side_by_side<'s, R: Real, const COLUMNS: usize, const WIDTH: usize>(
    steps: impl Iterator<Item = Step<'s>>,
    factors: &[R],
    x: &mut [[R; COLUMNS]],
    first: usize,
) {
    let part = |row: &[R; COLUMNS]| -> [R; WIDTH] { core::array::from_fn(|k| row[first + k]) };
    for step in steps {
        let mut sums = part(&x[step.row as usize]);
        if let Some(scale) = step.scale {
            let scale = factors[scale as usize];
            for sum in &mut sums {
                *sum = *sum * scale;
            }
        }
        for &(factor, from) in step.terms {
            let (factor, from) = (factors[factor as usize], part(&x[from as usize]));
            for lane in 0..WIDTH {
                sums[lane] = sums[lane].sub_product(factor, from[lane]);
            }
        }
        x[step.row as usize][first..first + WIDTH].copy_from_slice(&sums);
    }
}

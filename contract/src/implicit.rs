//! Derivatives of what solves linear equations, by the factors that solved them.
//!
//! Of `K x = b` with factors of `K` at hand, the derivatives with respect to many
//! numbers `s` are
//!
//! ```text
//! K dx/ds = db/ds - (dK/ds) x
//! ```
//!
//! one right side for each `s` and the same matrix for all, so the factorization is
//! neither differentiated nor repeated: [`substitute`] solves for all columns at once, by
//! steps that were worked out when the equations were derived and touch nothing that is
//! structurally zero.

use crate::Real;

/// Columns that are solved side by side; twice as many where there are so many, as many sums
/// as half the registers of two numbers hold, and half as many where there are no more.
pub const LANES: usize = 8;

/// One step of a substitution: `x_row = scale x_row - sum of factor x_from`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Step<'a> {
    /// The row that changes.
    pub row: u32,
    /// Which factor it is scaled by before, if by any.
    pub scale: Option<u32>,
    /// (which factor, from which other row) of each product.
    pub terms: &'a [(u32, u32)],
}

impl<'a> Step<'a> {
    /// `x_row -= sum of factor x_from`.
    #[must_use]
    pub const fn less(row: u32, terms: &'a [(u32, u32)]) -> Self {
        Self { row, scale: None, terms }
    }

    /// `x_row = scale x_row - sum of factor x_from`.
    #[must_use]
    pub const fn scaled(row: u32, scale: u32, terms: &'a [(u32, u32)]) -> Self {
        Self { row, scale: Some(scale), terms }
    }
}

/// Solves for all columns of `x` at once, in place: right sides before, solution after.
/// `factors` are what steps multiply by.
///
/// A column gets the same bits whatever stands beside it.
///
/// # Panics
/// If a step mentions a row or a factor that is not there.
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

/// All steps in `WIDTH` columns.
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

//! Taylor series of solutions: the contract, and what emitted recurrences are
//! made of.
//!
//! With normalized coefficients `y = sum_k y_k (t - t_0)^k` the k-th coefficient
//! of y' = f is `(k + 1) y_(k+1)`, and every operation within f is a recurrence
//! of its operands' coefficients. What costs is the products,
//!
//! ```text
//! (a b)_k = a_0 b_k + a_k b_0 + sum_(j=1..k-1) a_j b_(k-j)
//! ```
//!
//! The sum reads nothing newer than order k - 1, so the sums of all products of
//! an order are formed at once, side by side in [`Lanes`], before the order's
//! chain of dependent operations begins.

use crate::Real;

/// Series of the solution through a state; an emitted simulator has them, one
/// written by hand need not.
pub trait TaylorSeries<R: Real> {
    /// Numbers of workspace that [`TaylorSeries::series`] asks for.
    fn series_workspace(&self, order: usize) -> usize;

    /// Normalized coefficients of the solution through `state` at `time`, order
    /// after order, each `states` long, beginning with the state itself. The
    /// highest order is what `coefficients` has room for.
    ///
    /// The branch of every `select_less` and the interval of every table are
    /// those at `time`, so the series holds as far as they do.
    ///
    /// # Panics
    /// If `coefficients` is empty or no multiple of the states long, or if
    /// `workspace` is shorter than [`TaylorSeries::series_workspace`] says.
    fn series(
        &self,
        time: R,
        state: &[R],
        parameters: &[R],
        coefficients: &mut [R],
        workspace: &mut [R],
    );

    /// Where the motion may bend unforeseen.
    fn bends(&self) -> Bends {
        Bends::Nowhere
    }
}

/// Where a motion may bend so that no coefficient tells of it from afar: a step by the
/// series may then pass the place unseen.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Bends {
    /// What is near shows in how coefficients grow.
    Nowhere,
    /// Where a function that is flat on both sides, such as tanh, turns from one to the
    /// other: there it is analytic.
    Saturates,
    /// Also at branches that depend on the state and at knots of tables.
    Corners,
}

/// Sums of up to `N` products of series, side by side.
#[derive(Debug)]
pub struct Lanes<'a, R, const N: usize> {
    left: &'a mut [[R; N]],
    right: &'a mut [[R; N]],
}

impl<'a, R: Real, const N: usize> Lanes<'a, R, N> {
    /// Numbers of workspace of lanes up to `order`.
    #[must_use]
    pub const fn workspace(order: usize) -> usize {
        2 * N * order
    }

    /// Lanes up to `order`, and the workspace that is left.
    ///
    /// # Panics
    /// If `workspace` is too short.
    #[must_use]
    #[inline]
    pub fn new(workspace: &'a mut [R], order: usize) -> (Self, &'a mut [R]) {
        let (left, workspace) = workspace.split_at_mut(N * order);
        let (right, workspace) = workspace.split_at_mut(N * order);
        (Self { left: left.as_chunks_mut().0, right: right.as_chunks_mut().0 }, workspace)
    }

    /// Takes the coefficients of one order.
    #[inline(always)]
    pub fn set(&mut self, order: usize, left: [R; N], right: [R; N]) {
        self.left[order] = left;
        self.right[order] = right;
    }

    /// `sum_(j=1..order-1) left_j right_(order-j)` in every lane.
    ///
    /// The newest coefficients come last, so that all the rest of the sum can be
    /// formed while they are still on their way.
    #[must_use]
    #[inline(always)]
    pub fn sums(&self, order: usize) -> [R; N] {
        let mut sums = [R::literal(0.0); N];
        if order < 2 {
            return sums;
        }
        if order > 3 {
            let (left, right) = (&self.left[2..order - 1], &self.right[2..order - 1]);
            for (left, right) in left.iter().zip(right.iter().rev()) {
                add_products(&mut sums, left, right);
            }
        }
        let newest = order - 1;
        add_products(&mut sums, &self.left[1], &self.right[newest]);
        if newest > 1 {
            add_products(&mut sums, &self.left[newest], &self.right[1]);
        }
        sums
    }
}

#[inline(always)]
fn add_products<R: Real, const N: usize>(sums: &mut [R; N], left: &[R; N], right: &[R; N]) {
    for lane in 0..N {
        sums[lane] = left[lane].mul_add(right[lane], sums[lane]);
    }
}

/// `k` and `1/k` for the order k.
#[must_use]
#[inline(always)]
#[allow(clippy::cast_precision_loss, reason = "orders are small")]
pub fn order_and_inverse<R: Real>(order: usize) -> (R, R) {
    let order = R::literal(order as f64);
    (order, R::literal(1.0) / order)
}

/// `L D L^T` of a symmetric matrix, without pivoting: for a mass matrix, which
/// is positive definite.
#[derive(Debug, Clone, Copy)]
pub struct Factored<R, const N: usize> {
    /// L below the diagonal, 1/D on it.
    factors: [[R; N]; N],
}

#[allow(clippy::needless_range_loop, reason = "rows and columns of one matrix")]
impl<R: Real, const N: usize> Factored<R, N> {
    /// Factors a matrix, of which the lower triangle is read.
    #[must_use]
    pub fn new(mut matrix: [[R; N]; N]) -> Self {
        for column in 0..N {
            let inverse = R::literal(1.0) / matrix[column][column];
            for row in column + 1..N {
                let scaled = -(matrix[row][column] * inverse);
                for other in column + 1..=row {
                    matrix[row][other] = scaled.mul_add(matrix[other][column], matrix[row][other]);
                }
            }
            for row in column + 1..N {
                matrix[row][column] = matrix[row][column] * inverse;
            }
            matrix[column][column] = inverse;
        }
        Self { factors: matrix }
    }

    /// The solution of `matrix x = right_side`.
    #[must_use]
    pub fn solve(&self, mut right_side: [R; N]) -> [R; N] {
        for column in 0..N {
            let minus = -right_side[column];
            for row in column + 1..N {
                right_side[row] = self.factors[row][column].mul_add(minus, right_side[row]);
            }
        }
        for row in (0..N).rev() {
            right_side[row] = right_side[row] * self.factors[row][row];
            for other in row + 1..N {
                right_side[row] =
                    self.factors[other][row].mul_add(-right_side[other], right_side[row]);
            }
        }
        right_side
    }
}

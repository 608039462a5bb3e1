//! Taylor series of solutions: the contract, and the building blocks of emitted recurrences.
//!
//! With normalized coefficients `y = sum_k y_k (t - t_0)^k`, the k-th coefficient of y' = f is
//! `(k + 1) y_(k+1)`, and every operation within f is a recurrence of its operands' coefficients.
//! Products dominate the cost:
//!
//! ```text
//! (a b)_k = a_0 b_k + a_k b_0 + sum_(j=1..k-1) a_j b_(k-j)
//! ```
//!
//! The sum reads nothing newer than order k - 1. So the sums of all products of an order are
//! formed at once, side by side in [`Lanes`], before the order's chain of dependent operations
//! begins.

use core::mem::size_of;

use crate::Real;

/// Series of the solution through a state. Emitted simulators may have them; handwritten ones
/// need not.
pub trait TaylorSeries<R: Real> {
    /// Returns the size of the workspace of [`TaylorSeries::series`].
    fn series_workspace(&self, order: usize) -> usize;

    /// Computes the normalized coefficients of the solution through `state` at `time`, order by
    /// order, each `states` long, beginning with the state itself. The length of `coefficients`
    /// determines the highest order.
    ///
    /// The branch of every `select_less` and the interval of every table are those at `time`; the
    /// series is valid as long as they do not change.
    ///
    /// # Panics
    /// If `coefficients` is empty or its length is not a multiple of the number of states, or if
    /// `workspace` is shorter than [`TaylorSeries::series_workspace`] says.
    fn series(
        &self,
        time: R,
        state: &[R],
        parameters: &[R],
        coefficients: &mut [R],
        workspace: &mut [R],
    );

    /// Reports whether the motion bends at branches that depend on the state, or at knots of tables.
    /// No coefficient announces them from afar, so a step by the series may pass one unnoticed.
    /// Functions that saturate are no corners; see
    /// [`saturations`](crate::Describe::saturations).
    fn has_corners(&self) -> bool {
        false
    }
}

/// Sums of `N` products of series, side by side.
///
/// The sums of an order are formed from their middle outwards: values known for long come first,
/// those of the preceding order last. The coefficients of the last two orders are kept at hand
/// too, because they are still being written to memory one by one and cannot yet be read as a
/// block.
#[derive(Debug)]
pub struct Lanes<'a, R, const N: usize> {
    /// Left coefficients, order by order.
    left: &'a mut [R],
    right: &'a mut [R],
    /// Left and right coefficients of the newest order, and of the one before.
    newest: [[R; N]; 2],
    before: [[R; N]; 2],
}

impl<'a, R: Real, const N: usize> Lanes<'a, R, N> {
    /// Returns the size of the workspace of lanes up to `order`.
    #[must_use]
    pub const fn workspace(order: usize) -> usize {
        2 * N * order
    }

    /// Returns lanes up to `order`, and the rest of the workspace.
    ///
    /// # Panics
    /// If `workspace` is too short.
    #[must_use]
    #[inline]
    pub fn new(workspace: &'a mut [R], order: usize) -> (Self, &'a mut [R]) {
        let (left, workspace) = workspace.split_at_mut(N * order);
        let (right, workspace) = workspace.split_at_mut(N * order);
        let none = [[R::literal(0.0); N]; 2];
        (Self { left, right, newest: none, before: none }, workspace)
    }

    /// Sets the coefficients of one order.
    #[allow(clippy::needless_range_loop, reason = "what is stored and where, by one index")]
    #[inline(always)]
    pub fn set(&mut self, order: usize, left: [R; N], right: [R; N]) {
        self.before = self.newest;
        self.newest = [left, right];
        // One by one, each with its own check: compilers that see neighbours being stored compute
        // them as vectors, and the shuffles in the chain of an order cost more than the vectors
        // gain.
        for lane in 0..N {
            self.left[order * N + lane] = left[lane];
        }
        for lane in 0..N {
            self.right[order * N + lane] = right[lane];
        }
    }

    /// Returns `sum_(j=1..order-1) left_j right_(order-j)` of every lane.
    #[must_use]
    #[inline(always)]
    pub fn sums(&self, order: usize) -> [R; N] {
        let (left, right) = (self.left.as_chunks::<N>().0, self.right.as_chunks::<N>().0);
        let mut sums = [[R::literal(0.0); N]; 2];
        if order.is_multiple_of(2) && order > 0 {
            add_products(&mut sums[0], &left[order / 2], &right[order / 2]);
        }
        if order > 6 {
            let low = 3..order.div_ceil(2);
            let high = order / 2 + 1..order - 2;
            let low = left[low.clone()].iter().zip(&right[low]).rev();
            let high = left[high.clone()].iter().zip(&right[high]);
            for (low, high) in low.zip(high) {
                add_pair(&mut sums, [low.0, low.1], [high.0, high.1]);
            }
        }
        let at_hand = |back: usize, [new_left, new_right]: &[[R; N]; 2]| {
            // Numbers that are blocks themselves are read as they were written.
            let is_block = size_of::<R>() > size_of::<f64>();
            if is_block {
                [left[order - back], right[order - back]]
            } else {
                [*new_left, *new_right]
            }
        };
        for (back, kept) in [(2, &self.before), (1, &self.newest)] {
            if order > 2 * back {
                let [high_left, high_right] = at_hand(back, kept);
                add_pair(&mut sums, [&left[back], &right[back]], [&high_left, &high_right]);
            }
        }
        let [mut sums, others] = sums;
        for lane in 0..N {
            sums[lane] = sums[lane] + others[lane];
        }
        sums
    }
}

/// Adds the two products of left and right coefficients of a low and a high order.
#[inline(always)]
fn add_pair<R: Real, const N: usize>(
    [sums, others]: &mut [[R; N]; 2],
    low: [&[R; N]; 2],
    high: [&[R; N]; 2],
) {
    add_products(sums, low[0], high[1]);
    add_products(others, high[0], low[1]);
}

#[inline(always)]
fn add_products<R: Real, const N: usize>(sums: &mut [R; N], left: &[R; N], right: &[R; N]) {
    for lane in 0..N {
        sums[lane] = left[lane].mul_add(right[lane], sums[lane]);
    }
}

/// Returns `k` and `1/k` for the order k.
#[must_use]
#[inline(always)]
#[allow(clippy::cast_precision_loss, reason = "orders are small")]
pub fn order_and_inverse<R: Real>(order: usize) -> (R, R) {
    let order = R::literal(order as f64);
    (order, R::literal(1.0) / order)
}

/// Computes the polynomial at `time` after the start of the step.
pub fn value<R: Real>(coefficients: &[R], time: R, value: &mut [R]) {
    let states = value.len();
    let mut orders = coefficients.chunks_exact(states).rev();
    value.copy_from_slice(orders.next().unwrap_or_default());
    for terms in orders {
        for (value, term) in value.iter_mut().zip(terms) {
            *value = value.mul_add(time, *term);
        }
    }
}

/// Factors `L D L^T` of a symmetric positive definite matrix, such as a mass matrix, without
/// pivoting. For a small matrix the inverse is kept instead: its products have half as long a
/// dependency chain as substitutions.
#[derive(Debug, Clone, Copy)]
pub struct Factored<R, const N: usize> {
    /// L below the diagonal, 1/D on it; or the inverse.
    factors: [[R; N]; N],
}

/// Largest matrix whose inverse is kept.
const MOST_INVERTED: usize = 6;

#[allow(clippy::needless_range_loop, reason = "rows and columns of one matrix")]
impl<R: Real, const N: usize> Factored<R, N> {
    /// Factors a matrix, of which only the lower triangle is read.
    #[must_use]
    #[inline]
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
        if N > MOST_INVERTED {
            return Self { factors: matrix };
        }
        let unit =
            |place| core::array::from_fn(|at| R::literal(if at == place { 1.0 } else { 0.0 }));
        Self { factors: core::array::from_fn(|column| substitute(&matrix, unit(column))) }
    }

    /// Returns the solution of `matrix x = right_side`.
    #[must_use]
    #[inline(always)]
    pub fn solve(&self, right_side: [R; N]) -> [R; N] {
        if N > MOST_INVERTED {
            return substitute(&self.factors, right_side);
        }
        let mut solution = self.factors[0].map(|entry| entry * right_side[0]);
        for column in 1..N {
            for row in 0..N {
                let entry = self.factors[column][row];
                solution[row] = entry.mul_add(right_side[column], solution[row]);
            }
        }
        solution
    }
}

/// Returns the solution of `L D L^T x = right_side`.
#[allow(clippy::needless_range_loop, reason = "rows and columns of one matrix")]
fn substitute<R: Real, const N: usize>(factors: &[[R; N]; N], mut right_side: [R; N]) -> [R; N] {
    for column in 0..N {
        let minus = -right_side[column];
        for row in column + 1..N {
            right_side[row] = factors[row][column].mul_add(minus, right_side[row]);
        }
    }
    for row in (0..N).rev() {
        right_side[row] = right_side[row] * factors[row][row];
        for other in row + 1..N {
            right_side[row] = factors[other][row].mul_add(-right_side[other], right_side[row]);
        }
    }
    right_side
}

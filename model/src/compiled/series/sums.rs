//! The sums of all products of an order, side by side.
//!
//! ```text
//! sum_k = (L_2 R_(k-2) + L_4 R_(k-4) + ..) + (L_3 R_(k-3) + L_5 R_(k-5) + ..)
//!         + (L_1 R_(k-1) + L_(k-1) R_1)
//! ```
//!
//! What the order before has just given comes last, and is added number by number by the
//! program of an order: read back as part of a vector it would be waited for.

/// Which sums there are.
#[derive(Debug, Clone, Copy)]
pub struct Sums {
    /// Sums of products of series.
    pub products: usize,
    /// Products with what is linear in time: `L_1 R_(k-1)`.
    pub lines: usize,
}

impl Sums {
    /// Numbers that factors of one side take in a row.
    pub fn lanes(&self) -> usize {
        self.products + self.lines
    }

    /// Forms the sums of the first two orders; from the third on, their middles: all but
    /// what order one and the order before have to do with. For numbers of so many lanes,
    /// from rows of left and right factors.
    #[inline]
    pub fn form(&self, order: usize, rows: &[f64], row: usize, lanes: usize, sums: &mut [f64]) {
        let all = self.lanes() * lanes;
        if order < 3 {
            return first(order, &rows[order.saturating_sub(1) * row..], &mut sums[..all]);
        }
        let products = self.products * lanes;
        let sums = &mut sums[..products];
        let mut at = 0;
        while at < products {
            at += match products - at {
                8.. => block::<8>(order, (rows, row, all), at, sums),
                4.. => block::<4>(order, (rows, row, all), at, sums),
                2.. => block::<2>(order, (rows, row, all), at, sums),
                _ => block::<1>(order, (rows, row, all), at, sums),
            };
        }
    }
}

/// Of order one there are no products, of order two there is one, of the row of order one.
#[inline(never)]
fn first(order: usize, row: &[f64], sums: &mut [f64]) {
    if order < 2 {
        return sums.fill(0.0);
    }
    let (left, right) = row[..2 * sums.len()].split_at(sums.len());
    for (sum, (left, right)) in sums.iter_mut().zip(left.iter().zip(right)) {
        *sum = left * right;
    }
}

/// The middle of `N` sums from the `at`-th on; how many they are.
#[inline(never)]
fn block<const N: usize>(
    order: usize,
    (rows, row, all): (&[f64], usize, usize),
    at: usize,
    sums: &mut [f64],
) -> usize {
    let mut even = [0.0; N];
    let mut odd = [0.0; N];
    // From order two up, and from two before this order down.
    let (mut left, mut right) = (2 * row + at, (order - 2) * row + all + at);
    let mut count = order - 3;
    while count >= 2 {
        add_products(&mut even, rows, left, right);
        add_products(&mut odd, rows, left + row, right - row);
        (left, right) = (left + 2 * row, right - 2 * row);
        count -= 2;
    }
    if count == 1 {
        add_products(&mut even, rows, left, right);
    }
    for (sum, (even, odd)) in sums[at..at + N].iter_mut().zip(even.into_iter().zip(odd)) {
        *sum = even + odd;
    }
    N
}

#[inline(always)]
fn add_products<const N: usize>(sums: &mut [f64; N], rows: &[f64], left: usize, right: usize) {
    let (left, right) = (&rows[left..left + N], &rows[right..right + N]);
    for lane in 0..N {
        sums[lane] += left[lane] * right[lane];
    }
}

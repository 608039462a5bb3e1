//! The sums of all products of an order, side by side.
//!
//! ```text
//! sum_k = (L_2 R_(k-2) + L_4 R_(k-4) + ..) + (L_3 R_(k-3) + L_5 R_(k-5) + ..)
//!         + (L_1 R_(k-1) + L_(k-1) R_1)
//! ```
//!
//! What the order before has just given comes last, number by number: read back as part of
//! a vector it would be waited for.

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

    /// Forms the sums of an order from rows of left and right factors, for numbers of so
    /// many lanes.
    pub fn form(&self, order: usize, rows: &[f64], row: usize, lanes: usize, sums: &mut [f64]) {
        let all = self.lanes() * lanes;
        let products = self.products * lanes;
        let sums = &mut sums[..all];
        let factors = |order: usize| rows[order * row..][..2 * all].split_at(all);
        if order < 2 {
            sums.fill(0.0);
            return;
        }
        let [first, last] = [factors(1), factors(order - 1)];
        let lines = sums[products..].iter_mut().zip(&first.0[products..]);
        for ((sum, left), right) in lines.zip(&last.1[products..]) {
            *sum = left * right;
        }
        let sums = &mut sums[..products];
        let ends = first.0.iter().zip(first.1).zip(last.0.iter().zip(last.1));
        if order == 2 {
            for (sum, ((left, right), _)) in sums.iter_mut().zip(ends) {
                *sum = left * right;
            }
            return;
        }
        let mut at = 0;
        while at < products {
            let left = products - at;
            at += match left {
                8.. => block::<8>(order, (rows, row, all), at, sums),
                4.. => block::<4>(order, (rows, row, all), at, sums),
                2.. => block::<2>(order, (rows, row, all), at, sums),
                _ => block::<1>(order, (rows, row, all), at, sums),
            };
        }
        for (sum, ((first_left, first_right), (last_left, last_right))) in sums.iter_mut().zip(ends)
        {
            *sum += first_left * last_right + last_left * first_right;
        }
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
    if order > 3 {
        let left = rows[2 * row + at..].chunks(row);
        let right = rows[..(order - 2) * row + all + at + N][all + at..].chunks(row).rev();
        let mut pairs = left.zip(right).take(order - 3);
        loop {
            let Some((left, right)) = pairs.next() else { break };
            add_products(&mut even, left, right);
            let Some((left, right)) = pairs.next() else { break };
            add_products(&mut odd, left, right);
        }
    }
    for (sum, (even, odd)) in sums[at..at + N].iter_mut().zip(even.into_iter().zip(odd)) {
        *sum = even + odd;
    }
    N
}

#[inline(always)]
fn add_products<const N: usize>(sums: &mut [f64; N], left: &[f64], right: &[f64]) {
    let (Some(left), Some(right)) = (left.first_chunk::<N>(), right.first_chunk::<N>()) else {
        return;
    };
    for lane in 0..N {
        sums[lane] += left[lane] * right[lane];
    }
}

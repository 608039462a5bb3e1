//! Weighted sums of stages, in lanes.

use machinist_scenes::Real;

/// Stages are padded to a multiple of so many states, and summed so many at once.
pub(super) const LANES: usize = 4;

/// Weights of stages, as (offset of the stage, weight).
pub(super) type Sum = Vec<(usize, f64)>;

/// The sum of a row of coefficients over stages of `width` padded states each.
pub(super) fn sum(row: &[(usize, f64)], width: usize) -> Sum {
    row.iter().map(|&(stage, weight)| (stage * width, weight)).collect()
}

/// `into` = start + step sum of weight times stage; start 0 if there is none.
/// All in lanes, so that the compiler needs no tail.
pub(super) fn combine(
    sum: &[(usize, f64)],
    stages: &[f64],
    step: f64,
    start: Option<&[f64]>,
    into: &mut [f64],
) {
    // Long states by wide blocks, so that a weight is fetched for many of them.
    let wide = into.len() / WIDE * WIDE;
    let (first, rest) = into.split_at_mut(wide);
    blocks::<WIDE>(sum, stages, step, (start, 0), first);
    blocks::<LANES>(sum, stages, step, (start, wide), rest);
}

/// States summed at once where there are many.
const WIDE: usize = 4 * LANES;

/// The sum over blocks of so many states, of which the first is the `first`-th.
#[inline]
fn blocks<const COUNT: usize>(
    sum: &[(usize, f64)],
    stages: &[f64],
    step: f64,
    (start, first): (Option<&[f64]>, usize),
    into: &mut [f64],
) {
    for (block, into) in into.chunks_exact_mut(COUNT).enumerate() {
        let at = first + block * COUNT;
        let mut total = [0.0; COUNT];
        for &(offset, weight) in sum {
            let stage = &stages[offset + at..][..COUNT];
            for (total, stage) in total.iter_mut().zip(stage) {
                *total = Real::mul_add(weight, *stage, *total);
            }
        }
        match start {
            Some(start) => {
                for ((into, total), start) in into.iter_mut().zip(total).zip(&start[at..]) {
                    *into = Real::mul_add(step, total, *start);
                }
            }
            None => {
                for (into, total) in into.iter_mut().zip(total) {
                    *into = step * total;
                }
            }
        }
    }
}

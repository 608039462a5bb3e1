//! Weighted sums of stages, in lanes.

use machinist_contract::Real;

/// Returns the padded size of a stage: a multiple of what [`combine`] sums at once.
pub(super) fn padded(size: usize) -> usize {
    size.next_multiple_of(if size <= 6 { 2 } else { LANES })
}

/// Returns the padded size of a stage for [`combine_many`].
pub(super) fn padded_many(size: usize) -> usize {
    size.next_multiple_of(LANES)
}

/// Copies a stage. For the few numbers of small machines this takes less time than a call.
#[inline(always)]
pub(super) fn copy(from: &[f64], into: &mut [f64]) {
    #[inline(always)]
    fn chunk<const COUNT: usize>(from: &[f64], into: &mut [f64]) {
        if let (Some(from), Some(into)) = (from.first_chunk(), into.first_chunk_mut::<COUNT>()) {
            *into = *from;
        }
    }
    match into.len() {
        2 => chunk::<2>(from, into),
        4 => chunk::<4>(from, into),
        6 => chunk::<6>(from, into),
        8 => chunk::<8>(from, into),
        _ => into.copy_from_slice(from),
    }
}

/// Number of states to a multiple of which longer stages are padded.
const LANES: usize = 4;

/// Weights of stages, as (offset of the stage, weight).
pub(super) type Sum = Vec<(usize, f64)>;

/// Returns the sum of a row of coefficients over stages of `width` padded states each.
pub(super) fn sum(row: &[(usize, f64)], width: usize) -> Sum {
    row.iter().map(|&(stage, weight)| (stage * width, weight)).collect()
}

/// Computes `into` = start + step sum of weight times stage; start is 0 if there is none.
/// Everything is in lanes, so the compiler needs no tail.
pub(super) fn combine(
    sum: &[(usize, f64)],
    stages: &[f64],
    step: f64,
    start: Option<&[f64]>,
    into: &mut [f64],
) {
    match into.len() {
        2 => blocks::<2, false>(sum, stages, step, (start, 0), into),
        4 => blocks::<4, false>(sum, stages, step, (start, 0), into),
        6 => blocks::<6, true>(sum, stages, step, (start, 0), into),
        8 => blocks::<8, true>(sum, stages, step, (start, 0), into),
        len => {
            // Wide blocks fetch a weight once for many states.
            let (first, rest) = into.split_at_mut(len / WIDE * WIDE);
            blocks::<WIDE, true>(sum, stages, step, (start, 0), first);
            blocks::<LANES, false>(sum, stages, step, (start, first.len()), rest);
        }
    }
}

/// Does the same as [`combine`] for many values, such as sensitivities: all their sums would not
/// fit into registers together with second ones.
#[inline(always)]
pub(super) fn combine_many(
    sum: &[(usize, f64)],
    stages: &[f64],
    step: f64,
    start: Option<&[f64]>,
    into: &mut [f64],
) {
    let (first, rest) = into.split_at_mut(into.len() / WIDEST * WIDEST);
    blocks::<WIDEST, false>(sum, stages, step, (start, 0), first);
    blocks::<LANES, false>(sum, stages, step, (start, first.len()), rest);
}

/// Number of states summed at once where there are many.
const WIDE: usize = 4 * LANES;

/// Number of sensitivities summed at once: as many as registers hold.
const WIDEST: usize = 6 * LANES;

/// Sums blocks of `COUNT` states, the first of which is the `first`-th; with `PAIRED`, in pairs of
/// terms side by side.
#[inline(always)]
fn blocks<const COUNT: usize, const PAIRED: bool>(
    sum: &[(usize, f64)],
    stages: &[f64],
    step: f64,
    (start, first): (Option<&[f64]>, usize),
    into: &mut [f64],
) {
    for (block, into) in into.as_chunks_mut::<COUNT>().0.iter_mut().enumerate() {
        let at = first + block * COUNT;
        let mut total = [0.0; COUNT];
        if PAIRED {
            // With two sums side by side, each term waits for half of the others only.
            let mut other = [0.0; COUNT];
            let (pairs, last) = sum.as_chunks();
            for [first, second] in pairs {
                add(first, stages, at, &mut other);
                add(second, stages, at, &mut total);
            }
            for term in last {
                add(term, stages, at, &mut other);
            }
            for (total, other) in total.iter_mut().zip(other) {
                *total += other;
            }
        } else {
            for term in sum {
                add(term, stages, at, &mut total);
            }
        }
        // Writing whole arrays avoids comparing each number with the end of its slice, and a write
        // before each read.
        *into = match start.map(|start| start[at..].first_chunk::<COUNT>()) {
            Some(Some(start)) => {
                let mut values = *start;
                for (value, total) in values.iter_mut().zip(total) {
                    *value = Real::mul_add(step, total, *value);
                }
                values
            }
            _ => total.map(|total| step * total),
        };
    }
}

/// Adds the term of a stage to its sum.
#[inline(always)]
fn add<const COUNT: usize>(
    &(offset, weight): &(usize, f64),
    stages: &[f64],
    at: usize,
    total: &mut [f64; COUNT],
) {
    let stage = &stages[offset + at..][..COUNT];
    for (total, stage) in total.iter_mut().zip(stage) {
        *total = Real::mul_add(weight, *stage, *total);
    }
}

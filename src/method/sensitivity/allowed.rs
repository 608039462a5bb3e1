//! Errors of S over the tolerances.

use crate::method::vectors::{Work, widest};

/// Tolerances of errors of S:
///
/// ```text
/// atol / |p| + rtol |S|
/// ```
///
/// where |S| is the largest value of an entry so far, its natural size. Where it passes zero, no
/// better tolerance is reasonable.
#[derive(Default)]
pub(super) struct Allowed {
    /// atol / |p| of every entry.
    absolute: Vec<f64>,
    /// Largest values of entries at the ends of steps so far.
    largest: Vec<f64>,
    /// Reciprocals of the tolerances over the step.
    inverse: Vec<f64>,
    /// Sums of (error / allowed)^2 over the states, one for each direction.
    sums: Vec<f64>,
}

impl Allowed {
    /// Returns the tolerances for absolute tolerances of states and sizes of the quantities to
    /// differentiate by.
    pub(super) fn new(atol: &[f64], sizes: &[f64]) -> Self {
        let of_state = |atol: &f64| sizes.iter().map(move |size| atol / size).collect::<Vec<_>>();
        let absolute: Vec<f64> = atol.iter().flat_map(of_state).collect();
        let zeros = vec![0.0; absolute.len()];
        Self { absolute, largest: zeros.clone(), inverse: zeros, sums: vec![0.0; sizes.len()] }
    }

    /// Takes the ends of a step whose errors are to be judged.
    pub(super) fn set(&mut self, rtol: f64, (start, end): (&[f64], &[f64])) {
        widest(Sizes { of: self, rtol, start, end });
    }

    /// Returns the largest error of all directions over the tolerances, each the root mean square
    /// over the states.
    pub(super) fn norm(&mut self, errors: &[f64]) -> f64 {
        widest(Squares { of: self, errors });
        // A NaN is kept.
        let greatest = self.sums.iter().fold(0.0, |a: f64, b| if *b <= a { a } else { *b });
        (greatest / (self.inverse.len() / self.sums.len()) as f64).sqrt()
    }

    /// Takes S at the end of an accepted step.
    pub(super) fn keep(&mut self, tangents: &[f64]) {
        for (largest, value) in self.largest.iter_mut().zip(tangents) {
            *largest = larger(*largest, value.abs());
        }
    }
}

/// Returns the larger of a number and another that may be NaN.
#[inline(always)]
fn larger(number: f64, other: f64) -> f64 {
    if other > number { other } else { number }
}

struct Sizes<'a> {
    of: &'a mut Allowed,
    rtol: f64,
    start: &'a [f64],
    end: &'a [f64],
}

impl Work for Sizes<'_> {
    type Result = ();
    #[inline(always)]
    fn run(self) {
        let Allowed { absolute, largest, inverse, .. } = self.of;
        let ends = self.start.iter().zip(self.end);
        for (((inverse, absolute), largest), (start, end)) in
            inverse.iter_mut().zip(absolute).zip(largest).zip(ends)
        {
            let size = larger(larger(*largest, start.abs()), end.abs());
            *inverse = 1.0 / (*absolute + self.rtol * size);
        }
    }
}

struct Squares<'a> {
    of: &'a mut Allowed,
    errors: &'a [f64],
}

impl Work for Squares<'_> {
    type Result = ();
    #[inline(always)]
    fn run(self) {
        let Allowed { inverse, sums, .. } = self.of;
        sums.fill(0.0);
        let count = sums.len();
        for (errors, inverse) in self.errors.chunks_exact(count).zip(inverse.chunks_exact(count)) {
            for ((sum, error), inverse) in sums.iter_mut().zip(errors).zip(inverse) {
                let ratio = error * inverse;
                *sum += ratio * ratio;
            }
        }
    }
}

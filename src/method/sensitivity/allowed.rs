//! Errors of S over what tolerances allow.

use crate::method::vectors::{Work, widest};

/// What errors of S are allowed:
///
/// ```text
/// atol / |p| + rtol |S|
/// ```
///
/// where |S| is the largest that an entry was until now, its natural size: where it passes
/// zero, nothing is to be held that is better than that.
#[derive(Default)]
pub(super) struct Allowed {
    /// atol / |p| of every entry.
    absolute: Vec<f64>,
    /// The largest that entries were at the ends of steps until now.
    largest: Vec<f64>,
    /// What is allowed over the step.
    total: Vec<f64>,
    /// (error / allowed)^2 of every entry.
    squares: Vec<f64>,
    directions: usize,
}

impl Allowed {
    /// What is allowed by absolute tolerances of states, and sizes of what is differentiated by.
    pub(super) fn new(atol: &[f64], sizes: &[f64]) -> Self {
        let of_state = |atol: &f64| sizes.iter().map(move |size| atol / size).collect::<Vec<_>>();
        let absolute: Vec<f64> = atol.iter().flat_map(of_state).collect();
        let zeros = vec![0.0; absolute.len()];
        let (largest, total, squares) = (zeros.clone(), zeros.clone(), zeros);
        Self { absolute, largest, total, squares, directions: sizes.len() }
    }

    /// Takes the ends of a step, over which errors are to be judged.
    pub(super) fn set(&mut self, rtol: f64, (start, end): (&[f64], &[f64])) {
        widest(Sizes { of: self, rtol, start, end });
    }

    /// The greatest error of all directions over what is allowed, each the root mean square of
    /// those of the states.
    pub(super) fn norm(&mut self, errors: &[f64]) -> f64 {
        widest(Squares { of: self, errors });
        let of_direction = |direction: usize| {
            self.squares[direction..].iter().step_by(self.directions).sum::<f64>()
        };
        let sums = (0..self.directions).map(of_direction);
        // A NaN is kept.
        let greatest = sums.fold(0.0, |a: f64, b| if b <= a { a } else { b });
        (greatest / (self.squares.len() / self.directions) as f64).sqrt()
    }

    /// Takes S at the end of a step that is taken.
    pub(super) fn keep(&mut self, tangents: &[f64]) {
        for (largest, value) in self.largest.iter_mut().zip(tangents) {
            *largest = larger(*largest, value.abs());
        }
    }
}

/// The larger of a number and another that may be none.
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
        let Allowed { absolute, largest, total, .. } = self.of;
        let ends = self.start.iter().zip(self.end);
        for (((total, absolute), largest), (start, end)) in
            total.iter_mut().zip(absolute).zip(largest).zip(ends)
        {
            let size = larger(larger(*largest, start.abs()), end.abs());
            *total = *absolute + self.rtol * size;
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
        let Allowed { total, squares, .. } = self.of;
        for ((square, error), total) in squares.iter_mut().zip(self.errors).zip(total) {
            let ratio = error / *total;
            *square = ratio * ratio;
        }
    }
}

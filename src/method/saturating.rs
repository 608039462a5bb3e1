//! Places within a step at which functions of the rate bend, although they are flat at both ends.
//!
//! Far from a place `tanh` and the like are flat, and their series have lost that place to rounding.
//! If the argument comes near it within a step and turns back, neither the coefficients nor the end
//! of the step show it. The machine tells its arguments
//! ([`machinist_contract::Simulator::saturating_arguments`]), and a step is checked where one of
//! them turns near zero or passes it.

use std::sync::LazyLock;

use super::taylor::magnitude::{Magnitude, smaller};

/// Number of samples of an argument, at equal distances.
const SAMPLES: usize = 5;

/// Number of samples between the ends of an interval.
const BETWEEN: usize = SAMPLES - 2;

/// Number of parts of an interval, between which the polynomial through the samples is searched.
const PARTS: usize = 16;

/// Number of times that the two parts beside a place are searched again. The place is known to 1/16
/// of 1/8^3 of a step then, in which an argument that passes ten thousand widths of its function in
/// a step moves by one.
const AGAIN: u32 = 3;

/// Distance to which a place is known, as a share of the step.
const RESOLVED: f64 = 1.0 / (PARTS * (PARTS / 2).pow(AGAIN)) as f64;

/// Size of an argument from which on a function counts as flat: e^-8 is 3e-4. Up to it, coefficients
/// of series show how near the place is: those of `tanh` grow from e^-16 by factors of 16/k, and so
/// reach 1e-3 at order 7 and 0.1 at order 17 of a step to the place.
pub(super) const FLAT: f64 = 8.0;

/// Change of an argument below which a function bends little.
const WIDTH: f64 = 1.0;

/// Values of the Lagrange polynomials of the samples at the ends of all parts, and of one more on
/// each side.
static LAGRANGE: LazyLock<[[f64; SAMPLES]; PARTS + 3]> = LazyLock::new(|| {
    let node = |index: usize| index as f64 / (SAMPLES - 1) as f64;
    std::array::from_fn(|part| {
        let x = (part as f64 - 1.0) / PARTS as f64;
        std::array::from_fn(|of| {
            let others = (0..SAMPLES).filter(|other| *other != of);
            others.map(|other| (x - node(other)) / (node(of) - node(other))).product()
        })
    })
});

/// Motion of a machine over a step, at times after its start.
pub(super) trait Motion<R> {
    /// Error of the states between the ends of a step, as a share of how far they move.
    const OFF: f64;
    /// Size of an argument at the start of a step up to which the method sees a bend ahead.
    const SEES: f64;
    /// Computes the states at several times, entry by entry.
    fn states<const N: usize>(&mut self, times: [R; N], states: &mut [[R; N]]);
    /// Computes the arguments of functions that saturate.
    fn arguments(&self, time: R, state: &[R], arguments: &mut [R]);
}

/// Arguments over a step, of one run or of several in lanes.
pub(super) struct Saturating<R> {
    /// Samples over the whole step, argument by argument.
    samples: Vec<[R; SAMPLES]>,
    /// States at the samples between the ends of the step, and at all samples of a part of it.
    between: Vec<[R; BETWEEN]>,
    within: Vec<[R; SAMPLES]>,
    arguments: Vec<R>,
    state: Vec<R>,
}

impl<R: Magnitude> Saturating<R> {
    /// Returns `None` for a machine without such arguments.
    pub(super) fn new(arguments: usize, states: usize) -> Option<Self> {
        let zero = R::literal(0.0);
        (arguments > 0).then(|| Self {
            samples: vec![[zero; SAMPLES]; arguments],
            between: vec![[zero; BETWEEN]; states],
            within: vec![[zero; SAMPLES]; states],
            arguments: vec![zero; arguments],
            state: vec![zero; states],
        })
    }

    /// Passes the places of a step from `start` to `end` on, one for each argument that has one: the
    /// time after the start, and 1 in the lanes that have it. `is_any` tells whether some lane of a
    /// number is positive.
    pub(super) fn places<M: Motion<R>>(
        &mut self,
        motion: &mut M,
        (start, step, end): (&[R], R, &[R]),
        is_any: impl Fn(R) -> bool,
        mut pass: impl FnMut(&mut M, R, R),
    ) {
        let (zero, one) = (R::literal(0.0), R::literal(1.0));
        motion.arguments(zero, start, &mut self.arguments);
        self.keep(0);
        let unseen = |samples: &[R; SAMPLES]| samples[0].abs() - R::literal(M::SEES);
        if !self.samples.iter().any(|samples| is_any(unseen(samples))) {
            return;
        }
        let times: [R; BETWEEN] = std::array::from_fn(|index| step * share(index + 1));
        motion.states(times, &mut self.between);
        for (index, time) in times.into_iter().enumerate() {
            take(&self.between, index, &mut self.state);
            motion.arguments(time, &self.state, &mut self.arguments);
            self.keep(index + 1);
        }
        motion.arguments(step, end, &mut self.arguments);
        self.keep(SAMPLES - 1);
        for argument in 0..self.samples.len() {
            let samples = &self.samples[argument];
            // Most arguments rise or fall throughout most steps.
            if !is_any(-least_turn(samples)) {
                continue;
            }
            let place = place(samples, (-one, zero)).0;
            if !is_any(place + R::literal(0.5)) {
                continue;
            }
            let ends = [samples[0].abs(), samples[SAMPLES - 1].abs()];
            let way = samples.windows(2).fold(zero, |way, pair| way + (pair[1] - pair[0]).abs());
            let near = R::literal(FLAT) + R::literal(M::OFF + RESOLVED) * way;
            let (time, size) = self.narrow(motion, argument, step * place, step);
            let is_near = R::select_less(size, near, one, zero);
            // Where the argument hardly moves to an end of the step, that end shows the bend.
            let size = size + R::literal(WIDTH);
            let is_far_from_ends = R::select_less(size, smaller(ends[0], ends[1]), is_near, zero);
            let is_unseen = R::select_less(R::literal(M::SEES), ends[0], is_far_from_ends, zero);
            let is_found = R::select_less(-one, place, is_unseen, zero);
            let is_behind = R::select_less(zero, time, is_found, zero);
            let is_there = R::select_less(time, step, is_behind, zero);
            if is_any(is_there) {
                pass(motion, time, is_there);
            }
        }
    }

    /// Takes the arguments computed last as a sample.
    fn keep(&mut self, sample: usize) {
        for (samples, argument) in self.samples.iter_mut().zip(&self.arguments) {
            samples[sample] = *argument;
        }
    }

    /// Returns the time of a place, which has been found at the end of a part of the step, and the
    /// size of the argument there.
    fn narrow(
        &mut self,
        motion: &mut impl Motion<R>,
        argument: usize,
        place: R,
        step: R,
    ) -> (R, R) {
        let (zero, one) = (R::literal(0.0), R::literal(1.0));
        let part = R::literal(1.0 / PARTS as f64);
        let (mut time, mut half, mut size) = (place, step * part, zero);
        for _ in 0..AGAIN {
            let (from, width) = (time - half, half + half);
            let times: [R; SAMPLES] = std::array::from_fn(|index| from + width * share(index));
            motion.states(times, &mut self.within);
            let mut samples = [zero; SAMPLES];
            for (index, (sample, time)) in samples.iter_mut().zip(times).enumerate() {
                take(&self.within, index, &mut self.state);
                motion.arguments(time, &self.state, &mut self.arguments);
                *sample = self.arguments[argument];
            }
            // The polynomial before may have been a little off.
            let [first, last] = [samples[0].abs(), samples[SAMPLES - 1].abs()];
            let nearer = R::select_less(first, last, zero, one);
            let place;
            (place, size) = self::place(&samples, (nearer, smaller(first, last)));
            time = from + width * place;
            half = width * part;
        }
        (time, size)
    }
}

/// Copies the state at one of several times.
fn take<R: Copy, const N: usize>(states: &[[R; N]], index: usize, state: &mut [R]) {
    for (state, at) in state.iter_mut().zip(states) {
        *state = at[index];
    }
}

/// Returns the position of a sample as a share of the interval.
fn share<R: Magnitude>(sample: usize) -> R {
    R::literal(sample as f64 / (SAMPLES - 1) as f64)
}

/// Returns a negative number if the polynomial through samples turns or passes zero.
fn least_turn<R: Magnitude>(samples: &[R; SAMPLES]) -> R {
    /// Slopes at the first sample, by differences of neighbours, times their distance.
    const FIRST: [f64; SAMPLES - 1] = [25.0 / 12.0, -23.0 / 12.0, 13.0 / 12.0, -0.25];
    let differences: [R; SAMPLES - 1] = std::array::from_fn(|k| samples[k + 1] - samples[k]);
    let slope = |differences: &mut dyn Iterator<Item = &R>| {
        let terms = differences.zip(FIRST);
        terms.fold(R::literal(0.0), |sum, (difference, weight)| {
            sum + R::literal(weight) * *difference
        })
    };
    let [first, .., last] = &differences;
    let first = slope(&mut differences.iter()) * *first;
    let last = slope(&mut differences.iter().rev()) * *last;
    let passes = samples[0] * samples[SAMPLES - 1];
    let turns = differences.windows(2).map(|pair| pair[0] * pair[1]);
    turns.chain([first, last]).fold(passes, smaller)
}

/// Returns where in an interval, as a share, a function turns or passes zero, and its size there: of
/// several such places the one at which it is nearest to zero. Returns `none` if there is none.
fn place<R: Magnitude>(samples: &[R; SAMPLES], none: (R, R)) -> (R, R) {
    let zero = R::literal(0.0);
    let value = |part: usize| {
        let weights = LAGRANGE[part].iter().zip(samples);
        weights.fold(zero, |value, (weight, sample)| value + R::literal(*weight) * *sample)
    };
    let (mut before, mut here) = (value(0), value(1));
    let (mut found, mut least) = (none.0, R::literal(f64::INFINITY));
    for part in 0..=PARTS {
        let after = value(part + 2);
        let turns = (here - before) * (after - here);
        let passes = before * after;
        let is_place = R::select_less(turns, zero, turns, passes);
        let size = R::select_less(is_place, zero, here.abs(), R::literal(f64::INFINITY));
        found = R::select_less(size, least, R::literal(part as f64 / PARTS as f64), found);
        least = R::select_less(size, least, size, least);
        (before, here) = (here, after);
    }
    (found, R::select_less(least, R::literal(f64::INFINITY), least, none.1))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn places_are_where_a_function_turns_or_passes_zero() {
        let assert_at = |function: &dyn Fn(f64) -> f64, parts: f64| {
            let samples = std::array::from_fn(|index| function(share(index)));
            let (found, _) = place(&samples, (-1.0, 0.0));
            assert!(
                (found * PARTS as f64 - parts).abs() < 1e-9,
                "{found} instead of {parts} parts"
            );
        };
        let nowhere = -(PARTS as f64);
        assert_at(&|x| 3.0 + (x - 0.4).powi(2), 6.0);
        assert_at(&|x| -3.0 - (x - 0.4).powi(2), 6.0);
        assert_at(&|x| 100.0 * (x - 0.8), 13.0);
        assert_at(&|x| 1.0 + x, nowhere);
        assert_at(&|_| 1.0, nowhere);
        // It turns twice; the minimum is nearer to zero.
        assert_at(&|x| 20.0 + ((x - 0.25) * (x - 0.75) * (x - 0.5)) * 8.0, 10.0);
    }
}

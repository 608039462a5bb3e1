//! Order, length and error of a step, and evaluation of its polynomial.

use machinist_contract::Real;

use super::super::one_step::{Pace, Trial};
use super::magnitude::{Magnitude, smaller};

/// Fraction of the tolerances that steps aim at: errors add up over a run, and a decade of accuracy
/// costs a series little.
const AIM: f64 = 0.03;

/// Ratio of a step's error to its aim above which the step is rejected.
const LARGEST_ERROR: f64 = 10.0;

/// Log2 of the factor by which a remainder estimated from earlier coefficients than the last two
/// may be larger; the estimate is for steps where those two vanish.
const GUESS: f64 = 3.0;

/// Largest ratio of a step to the previous one.
pub(super) const GROWTH: f64 = 16.0;

/// Number of last coefficients that determine a step. From a symmetric state every other one
/// vanishes, and sometimes three in a row do.
pub(super) const JUDGED: usize = 5;

/// Returns the order for a relative tolerance, a fraction of which is aimed at: 0.85 ln(1/rtol) +
/// 2.
///
/// The classical choice, ln(1/rtol)/2 with steps of rho/e^2 for a radius of convergence rho, is
/// optimal if an order costs as much as all products within it. Here it costs the chain of
/// operations through the machine, so higher orders with longer steps are cheaper, as runs of the
/// machines confirm.
pub(in crate::method) fn order_for(rtol: f64) -> usize {
    ((2.0 - 0.85 * (AIM * rtol).ln()).ceil() as usize).clamp(5, 32)
}

/// Tolerances of the states and derived quantities.
pub(super) struct Tolerance {
    rtol: f64,
    atol: Vec<f64>,
    /// 1/(atol + rtol |y|) for every state.
    inverse_weights: Vec<f64>,
    /// Log2 of the ratio of neighbouring terms of a series that decays from the size of the state
    /// to the tolerance.
    decay: f64,
    /// For an order, coefficients of the step length as a function of the last coefficients.
    judges: (usize, Judges),
}

/// Pairs `(a, b)` for each of the last coefficients, from the last one back: log2 of the step is
/// `a - b log2(size)`.
pub(super) type Judges = [(f64, f64); JUDGED];

impl Tolerance {
    pub(super) fn new(rtol: f64, atol: &[f64], order: usize) -> Self {
        let decay = decay(rtol, order);
        let atol: Vec<f64> = atol.iter().copied().map(aimed_at).collect();
        let judges = (order, judges(order, decay));
        let rtol = aimed_at(rtol);
        Self { rtol, inverse_weights: vec![0.0; atol.len()], atol, decay, judges }
    }

    /// Sets the weights to the tolerances at a state.
    pub(super) fn weigh(&mut self, state: &[f64]) {
        for ((inverse, atol), value) in self.inverse_weights.iter_mut().zip(&self.atol).zip(state) {
            *inverse = 1.0 / (atol + self.rtol * value.abs());
        }
    }

    /// Returns the length of the step at whose end the terms of a series fall below the tolerance;
    /// infinite if the series is finite.
    ///
    /// The remainder is estimated from each of the last coefficients, as `|y_(p-i)| h^(p-i)
    /// theta^(i+1)` with the ratio theta of a series that decays from the size of the state to the
    /// tolerance. The largest estimate counts.
    pub(super) fn step_length(&self, coefficients: &[f64], order: usize) -> f64 {
        self.step_length_by(&coefficients[..(order + 1) * self.atol.len()], order)
    }

    /// Does the same as [`Tolerance::step_length`], given the newest coefficients alone, the last
    /// of which are those of `order`.
    pub(super) fn step_length_by(&self, newest: &[f64], order: usize) -> f64 {
        let mut sizes = [0.0; JUDGED];
        for (size, terms) in sizes.iter_mut().zip(newest.chunks_exact(self.atol.len()).rev()) {
            *size = self.size(terms);
        }
        let judges = match self.judges {
            (known, judges) if known == order => judges,
            _ => judges(order, self.decay),
        };
        step_length(sizes, &judges, order)
    }

    /// Returns the inverse of the allowed error of every state.
    #[cfg(feature = "sweep")]
    pub(super) fn inverse_weights(&mut self) -> &mut [f64] {
        &mut self.inverse_weights
    }

    /// Returns the inverse of the allowed error of every state.
    pub(super) fn weights(&self) -> &[f64] {
        &self.inverse_weights
    }

    /// Returns the largest value in units of its tolerance.
    fn size(&self, values: &[f64]) -> f64 {
        let (blocks, rest) = values.as_chunks::<4>();
        let (weights, rest_weights) = self.inverse_weights.as_chunks::<4>();
        let mut largest = [0.0_f64; 4];
        for (block, weights) in blocks.iter().zip(weights) {
            for lane in 0..4 {
                largest[lane] = largest[lane].larger((block[lane] * weights[lane]).abs());
            }
        }
        for (value, weight) in rest.iter().zip(rest_weights) {
            largest[0] = largest[0].larger((value * weight).abs());
        }
        let [a, b, c, d] = largest;
        a.larger(b).larger(c.larger(d))
    }
}

/// Returns the error that is aimed at for a tolerance.
pub(super) fn aimed_at(tolerance: f64) -> f64 {
    AIM * tolerance
}

/// Returns the decay of terms per order; see [`Tolerance`].
pub(super) fn decay(rtol: f64, order: usize) -> f64 {
    aimed_at(rtol).log2() / (order + 1) as f64
}

/// Returns the length of a step from the sizes of the last coefficients, from the last one back, in
/// units of the tolerance; see [`Tolerance::step_length`].
#[inline(always)]
pub(super) fn step_length<R: Magnitude>(sizes: [R; JUDGED], judges: &Judges, order: usize) -> R {
    // All logarithms are computed side by side before the minimum.
    let mut logs = [R::literal(0.0); JUDGED];
    for ((log, size), (a, b)) in logs.iter_mut().zip(sizes).zip(judges) {
        *log = R::literal(*a) - R::literal(*b) * size.log2();
    }
    logs.into_iter().take(order).fold(R::literal(f64::INFINITY), smaller).exp2()
}

pub(super) fn judges(order: usize, decay: f64) -> Judges {
    std::array::from_fn(|index| {
        let back = index + 1;
        let guessed = if back > 2 { GUESS } else { 0.0 };
        let share = 1.0 / (order + 1).saturating_sub(back).max(1) as f64;
        (share * (guessed - back as f64 * decay), share)
    })
}

/// Returns the result of a step of a length and order. `begin` contains state and rate at its end,
/// `slope` the derivative of its polynomial there.
pub(super) fn trial(
    tolerance: &Tolerance,
    slope: &[f64],
    begin: &[f64],
    (step, order): (f64, usize),
) -> Trial {
    let states = slope.len();
    let defect = defect(slope, &begin[states..], &tolerance.inverse_weights);
    let error = error(defect, step, (order + 1) as f64);
    if (error <= LARGEST_ERROR || !error.is_finite()) && !all_finite(begin) {
        let index = begin.iter().position(|value| !value.is_finite()).unwrap_or_default();
        let what = if index < states { "the state" } else { "the rate of" };
        return Trial::NotFinite { what, index: index % states };
    }
    Trial::Error(over_allowed(error))
}

/// Returns the largest defect y' - f in units of the tolerance over time.
pub(super) fn defect<R: Magnitude>(slope: &[R], rate: &[R], inverse_weights: &[R]) -> R {
    let defects = slope.iter().zip(rate).zip(inverse_weights);
    defects.fold(R::literal(0.0), |largest, ((slope, rate), inverse)| {
        largest.larger(((*slope - *rate) * *inverse).abs())
    })
}

/// Returns the error of a step relative to what is allowed, for a defect in units of the tolerance
/// that lasts for a part of it.
pub(super) fn lasting_error<R: Real>(defect: R, step: R) -> R {
    const PART: f64 = 0.25;
    defect * R::literal(PART) * step / R::literal(LARGEST_ERROR)
}

/// Returns the error of a step in units of the tolerance, with `terms` = p + 1: the defect y' - f
/// at its end is `(p + 1) y_(p+1) h^p`, the error `y_(p+1) h^(p+1)`.
pub(super) fn error<R: Real>(defect: R, step: R, terms: R) -> R {
    defect * step / terms
}

/// Converts an error in units of the tolerance to one relative to what is allowed.
pub(super) fn over_allowed<R: Real>(error: R) -> R {
    error / R::literal(LARGEST_ERROR)
}

/// Returns the upper limit of defect times step for an accepted step with this number of terms. The
/// decision is the same as by [`over_allowed`], to the last bit, without divisions.
///
/// The limit is a whole number, and no quotient between it and the next number rounds down to what
/// is allowed.
#[cfg(feature = "sweep")]
pub(super) fn limit(terms: usize) -> f64 {
    (LARGEST_ERROR * terms as f64).next_up()
}

/// Returns whether coefficients are finite only up to an order far below the requested one.
#[cfg(any(feature = "implicit", feature = "sweep"))]
pub(super) fn is_cut_short(finite: usize, order: usize) -> bool {
    2 * finite < order
}

/// Returns the control of rejected steps; the length of the next step follows from the series.
pub(super) fn pace(order: usize) -> Pace {
    Pace {
        exponent: 1.0 / (order + 1) as f64,
        memory: 0.0,
        safety: 0.8,
        smallest: 0.1,
        largest: GROWTH,
        hold: 1.0,
    }
}

/// Returns whether all values are finite.
pub(super) fn all_finite(values: &[f64]) -> bool {
    // This avoids a branch for every value.
    let (blocks, rest) = values.as_chunks::<8>();
    let mut zeros = [0.0; 8];
    for block in blocks {
        for (zero, value) in zeros.iter_mut().zip(block) {
            *zero += value * 0.0;
        }
    }
    zeros.iter().chain(rest).all(|value| value.is_finite())
}

/// Computes the polynomial at a time after the start of the step, with the roundings of
/// `machinist_contract::taylor::value`. States are summed side by side.
pub(super) fn value(coefficients: &[f64], time: f64, value: &mut [f64]) {
    fn block<const N: usize>(
        coefficients: &[f64],
        states: usize,
        first: usize,
        t: f64,
    ) -> [f64; N] {
        let mut orders = coefficients.chunks_exact(states).rev();
        let of = |terms: &[f64]| std::array::from_fn(|index| terms[first + index]);
        let highest: [f64; N] = orders.next().map_or([0.0; N], of);
        orders.fold(highest, |sums, terms| {
            let terms = &terms[first..first + N];
            std::array::from_fn(|index| Real::mul_add(sums[index], t, terms[index]))
        })
    }
    let states = value.len();
    let mut first = 0;
    while first < states {
        let into = &mut value[first..];
        match states - first {
            1 => into.copy_from_slice(&block::<1>(coefficients, states, first, time)),
            2 => into.copy_from_slice(&block::<2>(coefficients, states, first, time)),
            3 => into.copy_from_slice(&block::<3>(coefficients, states, first, time)),
            _ => into[..4].copy_from_slice(&block::<4>(coefficients, states, first, time)),
        }
        first += 4;
    }
}

/// Computes the polynomial at several times, whose sums do not wait for one another, state by state.
pub(super) fn states_at<R: Real, const N: usize>(
    coefficients: &[R],
    times: [R; N],
    states: &mut [[R; N]],
) {
    states.fill([R::literal(0.0); N]);
    for terms in coefficients.chunks_exact(states.len()).rev() {
        for (sums, term) in states.iter_mut().zip(terms) {
            for (sum, time) in sums.iter_mut().zip(times) {
                *sum = sum.mul_add(time, *term);
            }
        }
    }
}

/// Number of times at which polynomials are computed side by side.
pub(super) const ABREAST: usize = 8;

/// Computes the polynomial at up to [`ABREAST`] times after the start of the step, one state after
/// another, with the roundings of `machinist_contract::taylor::value`.
pub(super) fn values(
    coefficients: &[f64],
    times: impl ExactSizeIterator<Item = f64>,
    values: &mut [f64],
) {
    let states = values.len() / times.len().max(1);
    let mut after = [0.0; ABREAST];
    after.iter_mut().zip(times).for_each(|(after, time)| *after = time);
    for state in 0..states {
        let mut terms = coefficients.iter().skip(state).step_by(states).rev();
        let mut sums = [*terms.next().unwrap_or(&0.0); ABREAST];
        for term in terms {
            for (sum, after) in sums.iter_mut().zip(after) {
                *sum = Real::mul_add(*sum, after, *term);
            }
        }
        for (value, sum) in values.iter_mut().skip(state).step_by(states).zip(sums) {
            *value = sum;
        }
    }
}

/// Computes the polynomial and its derivative at `time` after the start of the step.
pub(super) fn value_and_slope<R: Real>(
    coefficients: &[R],
    time: R,
    value: &mut [R],
    slope: &mut [R],
) {
    /// Width of the target's largest registers in bytes.
    const REGISTER: usize = if cfg!(target_feature = "avx512f") {
        64
    } else if cfg!(target_feature = "avx") {
        32
    } else {
        16
    };
    let mut done = 0;
    if size_of::<R>() <= 2 * size_of::<f64>() {
        done = by_blocks::<R, 4>(coefficients, time, (value, slope), done);
    }
    // If numbers take several registers, the sums of one state fill all of them.
    if size_of::<R>() <= REGISTER {
        done = by_blocks::<R, 2>(coefficients, time, (value, slope), done);
    }
    by_blocks::<R, 1>(coefficients, time, (value, slope), done);
}

/// Sums states from `first` as long as `N` are left, which is as many as fit into registers.
/// Returns how many states are done.
fn by_blocks<R: Real, const N: usize>(
    coefficients: &[R],
    time: R,
    (values, slopes): (&mut [R], &mut [R]),
    first: usize,
) -> usize {
    let states = values.len();
    let done = first + (states - first) / N * N;
    for first in (first..done).step_by(N) {
        let (value, slope) = sum::<R, N>(coefficients, states, first, time);
        values[first..first + N].copy_from_slice(&value);
        slopes[first..first + N].copy_from_slice(&slope);
    }
    done
}

/// Sums `N` neighbouring states from `first`.
///
/// Even and odd powers of the time h are separate, so that half as many operations wait for one
/// another: `E(h^2) + h O(h^2)`, with the derivative `2 h (E' + h O') + O`.
#[inline(always)]
fn sum<R: Real, const N: usize>(
    coefficients: &[R],
    states: usize,
    first: usize,
    time: R,
) -> ([R; N], [R; N]) {
    let square = time * time;
    let [mut even, mut even_slope, mut odd, mut odd_slope] = [[R::literal(0.0); N]; 4];
    let pairs = coefficients.chunks_exact(2 * states);
    if let Some(highest) = pairs.remainder().get(first..first + N) {
        even.copy_from_slice(highest);
    }
    for pair in pairs.rev() {
        let (even_terms, odd_terms) = pair.split_at(states);
        let (even_terms, odd_terms) = (&even_terms[first..first + N], &odd_terms[first..first + N]);
        for index in 0..N {
            odd_slope[index] = odd_slope[index].mul_add(square, odd[index]);
            odd[index] = odd[index].mul_add(square, odd_terms[index]);
            even_slope[index] = even_slope[index].mul_add(square, even[index]);
            even[index] = even[index].mul_add(square, even_terms[index]);
        }
    }
    let twice = time + time;
    for index in 0..N {
        even[index] = odd[index].mul_add(time, even[index]);
        let inner = odd_slope[index].mul_add(time, even_slope[index]);
        even_slope[index] = twice.mul_add(inner, odd[index]);
    }
    (even, even_slope)
}

/// Numbers at one time within a step.
pub(super) struct Between<R> {
    state: Vec<R>,
    slope: Vec<R>,
    rate: Vec<R>,
}

impl<R: Magnitude> Between<R> {
    pub(super) fn new(states: usize) -> Self {
        let zeros = || vec![R::literal(0.0); states];
        Self { state: zeros(), slope: zeros(), rate: zeros() }
    }

    /// Returns the largest defect y' - f of the polynomial in units of the tolerance at `time` after
    /// the start of the step. `rate` computes f from the state there.
    pub(super) fn defect(
        &mut self,
        coefficients: &[R],
        time: R,
        inverse_weights: &[R],
        rate: impl FnOnce(&[R], &mut [R]),
    ) -> R {
        value_and_slope(coefficients, time, &mut self.state, &mut self.slope);
        rate(&self.state, &mut self.rate);
        defect(&self.slope, &self.rate, inverse_weights)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn polynomials_are_summed_with_their_derivatives() {
        for order in 1..9 {
            for states in 1..9 {
                let term = |index: usize| 1.0 / (1.0 + index as f64);
                let coefficients: Vec<f64> = (0..(order + 1) * states).map(term).collect();
                for time in [0.7_f64, 0.35] {
                    let (mut values, mut slopes) = (vec![0.0; states], vec![0.0; states]);
                    value_and_slope(&coefficients, time, &mut values, &mut slopes);
                    for state in 0..states {
                        let terms = coefficients.iter().skip(state).step_by(states).zip(0..);
                        let value: f64 = terms.clone().map(|(c, k)| c * time.powi(k)).sum();
                        let slope: f64 =
                            terms.map(|(c, k)| c * f64::from(k) * time.powi(k - 1)).sum();
                        assert!((values[state] - value).abs() < 1e-14 * value.abs());
                        assert!((slopes[state] - slope).abs() < 1e-14 * slope.abs());
                    }
                }
            }
        }
    }

    #[test]
    fn values_at_several_times_are_those_at_each() {
        for (states, count) in (1..6).flat_map(|states| (1..=ABREAST).map(move |n| (states, n))) {
            let term = |index: usize| (1.0 + index as f64).sin();
            let coefficients: Vec<f64> = (0..9 * states).map(term).collect();
            let times = (0..count).map(|index| 0.1 + 0.07 * index as f64);
            let (mut found, mut one) = (vec![0.0; count * states], vec![0.0; states]);
            values(&coefficients, times.clone(), &mut found);
            for (time, found) in times.zip(found.chunks(states)) {
                machinist_contract::taylor::value(&coefficients, time, &mut one);
                assert_eq!(found, one);
                value(&coefficients, time, &mut one);
                assert_eq!(found, one);
            }
        }
    }

    #[cfg(feature = "sweep")]
    #[test]
    fn steps_pass_below_the_limit_and_nowhere_else() {
        for terms in 2..40 {
            let mut product = LARGEST_ERROR * terms as f64 * (1.0 - 1e-14);
            for _ in 0..200 {
                let passes = over_allowed(error(product, 1.0, terms as f64)) <= 1.0;
                assert_eq!(product < limit(terms), passes, "{product} of {terms}");
                product = product.next_up();
            }
            assert!(product > limit(terms));
        }
    }
}

//! Intervals: ranges that surely contain the values of a function over a box.
//!
//! ```text
//! [a, b] + [c, d] = [a + c, b + d]    [a, b] [c, d] = [min, max] of a c, a d, b c, b d
//! ```
//!
//! Results are rounded outwards, so they contain what exact arithmetic gives. They may be wider
//! than that: each occurrence of a variable counts as a variable of its own. Where a function has
//! no real value, or may be unbounded, the result is [`Interval::WHOLE`].
//!
//! Source: R. E. Moore, R. B. Kearfott, M. J. Cloud: Introduction to Interval Analysis (2009),
//! chapters 2 and 5.

use core::f64::consts::{FRAC_PI_2, PI, TAU};
use core::ops::{Add, Div, Mul, Neg, Sub};

use crate::{Real, Simulator};

/// All numbers from `low` to `high`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Interval {
    /// Lower end.
    pub low: f64,
    /// Upper end, not below the lower one.
    pub high: f64,
}

/// Ranges of the guards of a simulator, which show where none of them can be zero. Every simulator
/// on any [`Real`] has them; [`Simulator::ranges`] returns them.
pub trait Ranges {
    /// Computes ranges of the guards of events, then of those of switching surfaces, over a box of
    /// times and states. Parameters are followed by slots as in other functions.
    ///
    /// # Panics
    /// If a slice has another length than guards and switching surfaces have together, or than the
    /// simulator's functions take.
    fn guard_ranges(
        &self,
        time: Interval,
        state: &[Interval],
        parameters: &[Interval],
        ranges: &mut [Interval],
    );
}

impl<S: Simulator<Interval>> Ranges for S {
    fn guard_ranges(
        &self,
        time: Interval,
        state: &[Interval],
        parameters: &[Interval],
        ranges: &mut [Interval],
    ) {
        let (events, kinks) = ranges.split_at_mut(self.events());
        self.guards(time, state, parameters, events);
        self.kink_guards(time, state, parameters, kinks);
    }
}

impl Interval {
    /// All real numbers.
    pub const WHOLE: Self = Self { low: f64::NEG_INFINITY, high: f64::INFINITY };

    /// Returns the interval of one number, which may be infinite; all numbers for NaN.
    #[must_use]
    pub const fn of(value: f64) -> Self {
        if value.is_nan() { Self::WHOLE } else { Self { low: value, high: value } }
    }

    /// Returns the numbers within a distance of a middle.
    #[must_use]
    pub fn around(middle: f64, distance: f64) -> Self {
        Self::outwards(middle - distance, middle + distance)
    }

    /// Returns the distance from zero of the number nearest to zero on a side (1 or -1); negative if
    /// some numbers are on the other side.
    #[must_use]
    pub fn clearance(self, side: f64) -> f64 {
        if side < 0.0 { -self.high } else { self.low }
    }

    /// Returns the largest absolute value.
    #[must_use]
    pub const fn magnitude(self) -> f64 {
        self.low.abs().max(self.high.abs())
    }

    /// Returns the interval between ends that were rounded to nearest.
    fn outwards(low: f64, high: f64) -> Self {
        if low.is_nan() || high.is_nan() {
            return Self::WHOLE;
        }
        Self { low: low.next_down(), high: high.next_up() }
    }

    /// Returns the interval between ends that are sums rounded to nearest: one that is zero is exact.
    fn between_sums(low: f64, high: f64) -> Self {
        let Self { low: below, high: above } = Self::outwards(low, high);
        Self {
            low: if low == 0.0 { 0.0 } else { below },
            high: if high == 0.0 { 0.0 } else { above },
        }
    }

    /// Returns whether it has finite numbers.
    fn is_real(self) -> bool {
        self.low < f64::INFINITY && self.high > f64::NEG_INFINITY
    }

    /// Returns whether zero is the only number.
    #[must_use]
    pub fn is_zero(self) -> bool {
        self.low == 0.0 && self.high == 0.0
    }

    /// Returns the interval between ends with an error of a few units in the last place.
    fn about(low: f64, high: f64) -> Self {
        const UNITS: f64 = 8.0 * f64::EPSILON;
        Self::outwards(low - UNITS * low.abs(), high + UNITS * high.abs())
    }

    /// Returns the values of an increasing function.
    fn increasing(self, function: impl Fn(f64) -> f64) -> Self {
        Self::about(function(self.low), function(self.high))
    }

    /// Returns the smallest interval with the numbers of both.
    fn hull(self, other: Self) -> Self {
        Self { low: self.low.min(other.low), high: self.high.max(other.high) }
    }

    /// Returns the smallest interval with these numbers; all numbers if one is NaN.
    fn hull_of(values: impl IntoIterator<Item = f64>) -> Self {
        let nothing = Self { low: f64::INFINITY, high: f64::NEG_INFINITY };
        values.into_iter().fold(nothing, |hull, value| hull.hull(Self::of(value)))
    }

    /// Returns cosines of the numbers less a shift.
    fn cosine(self, shift: f64) -> Self {
        const ALL: Interval = Interval { low: -1.0, high: 1.0 };
        /// Argument up to which a turn is resolved to much better than [`ROUND`].
        const FAR: f64 = 1e6;
        /// Share of a turn within which an extremum counts as met.
        const ROUND: f64 = 1e-9;
        let is_resolved = self.magnitude() < FAR;
        if !is_resolved || self.high - self.low >= TAU {
            return ALL;
        }
        let [start, end] = [self.low, self.high].map(|angle| (angle - shift) / PI);
        // Extrema are at whole half turns: maxima at even ones.
        let first = Real::floor(start - ROUND) + 1.0;
        let is_met = |half: f64| half <= end + ROUND;
        let is_even = |half: f64| half - 2.0 * Real::floor(0.5 * half) == 0.0;
        let met = [first, first + 1.0].map(|half| is_met(half).then(|| is_even(half)));
        let ends = [start, end].map(|half| Real::cos(half * PI));
        let low = if met.contains(&Some(false)) { -1.0 } else { ends[0].min(ends[1]) - ROUND };
        let high = if met.contains(&Some(true)) { 1.0 } else { ends[0].max(ends[1]) + ROUND };
        Self { low: low.max(-1.0), high: high.min(1.0) }
    }

    fn is_within(self, low: f64, high: f64) -> bool {
        self.low >= low && self.high <= high
    }
}

impl Neg for Interval {
    type Output = Self;
    fn neg(self) -> Self {
        Self { low: -self.high, high: -self.low }
    }
}

impl Add for Interval {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self::between_sums(self.low + other.low, self.high + other.high)
    }
}

impl Sub for Interval {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Self::between_sums(self.low - other.high, self.high - other.low)
    }
}

impl Mul for Interval {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        if self.is_zero() && other.is_real() || other.is_zero() && self.is_real() {
            return Self::of(0.0);
        }
        let Self { low: a, high: b } = self;
        let Self { low: c, high: d } = other;
        let Self { low, high } = Self::hull_of([a * c, a * d, b * c, b * d]);
        Self::outwards(low, high)
    }
}

impl Div for Interval {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        let Self { low: a, high: b } = self;
        let Self { low: c, high: d } = other;
        if c <= 0.0 && d >= 0.0 {
            return Self::WHOLE;
        }
        if self.is_zero() {
            return self;
        }
        let Self { low, high } = Self::hull_of([a / c, a / d, b / c, b / d]);
        Self::outwards(low, high)
    }
}

impl Real for Interval {
    fn literal(value: f64) -> Self {
        Self::of(value)
    }
    fn select_less(lhs: Self, rhs: Self, then: Self, otherwise: Self) -> Self {
        if lhs.high < rhs.low {
            then
        } else if lhs.low >= rhs.high {
            otherwise
        } else {
            then.hull(otherwise)
        }
    }
    fn powi(self, exponent: i32) -> Self {
        let power = |value: f64| Real::powi(value, exponent);
        let (low, high) = (power(self.low), power(self.high));
        let has_pole = exponent < 0 && self.low <= 0.0 && self.high >= 0.0;
        if has_pole {
            return Self::WHOLE;
        }
        let is_even = exponent % 2 == 0;
        let least = if is_even && self.low < 0.0 && self.high > 0.0 { 0.0 } else { low.min(high) };
        // Each multiplication rounds once.
        let units = 2.0 * f64::EPSILON * f64::from(exponent.unsigned_abs().max(1));
        let most = low.max(high);
        Self::outwards(least - units * least.abs(), most + units * most.abs())
    }
    fn powf(self, exponent: Self) -> Self {
        if self.low <= 0.0 {
            return Self::WHOLE;
        }
        let corners = [self.low, self.high]
            .map(|base| [exponent.low, exponent.high].map(|exponent| Real::powf(base, exponent)));
        let Self { low, high } = Self::hull_of(corners.into_iter().flatten());
        Self::about(low, high)
    }
    fn sqrt(self) -> Self {
        if self.low < 0.0 { Self::WHOLE } else { self.increasing(Real::sqrt) }
    }
    fn abs(self) -> Self {
        let (low, high) = (self.low.abs(), self.high.abs());
        let least = if self.low <= 0.0 && self.high >= 0.0 { 0.0 } else { low.min(high) };
        Self { low: least, high: low.max(high) }
    }
    fn floor(self) -> Self {
        Self { low: Real::floor(self.low), high: Real::floor(self.high) }
    }
    fn exp(self) -> Self {
        self.increasing(Real::exp)
    }
    fn ln(self) -> Self {
        if self.low <= 0.0 { Self::WHOLE } else { self.increasing(Real::ln) }
    }
    fn sin(self) -> Self {
        self.cosine(FRAC_PI_2)
    }
    fn cos(self) -> Self {
        self.cosine(0.0)
    }
    fn tan(self) -> Self {
        let half_turns = |angle: f64| Real::floor((angle + FRAC_PI_2) / PI);
        let is_on_one_branch = half_turns(self.low).to_bits() == half_turns(self.high).to_bits();
        let (low, high) = (Real::tan(self.low), Real::tan(self.high));
        let is_increasing = is_on_one_branch && self.high - self.low < PI && low <= high;
        if is_increasing { Self::about(low, high) } else { Self::WHOLE }
    }
    fn asin(self) -> Self {
        if self.is_within(-1.0, 1.0) { self.increasing(Real::asin) } else { Self::WHOLE }
    }
    fn acos(self) -> Self {
        if self.is_within(-1.0, 1.0) { (-self).increasing(|x| Real::acos(-x)) } else { Self::WHOLE }
    }
    fn atan(self) -> Self {
        self.increasing(Real::atan)
    }
    fn sinh(self) -> Self {
        self.increasing(Real::sinh)
    }
    fn cosh(self) -> Self {
        Real::abs(self).increasing(Real::cosh)
    }
    fn tanh(self) -> Self {
        self.increasing(Real::tanh)
    }
}

#[cfg(test)]
mod tests {
    use super::Interval;
    use crate::{CubicTable, Real};

    /// Ranges of each function, over intervals of many widths and places, contain its values, and
    /// are not much wider where the interval is narrow.
    #[test]
    fn ranges_contain_every_value() {
        type Pair = (&'static str, fn(Interval) -> Interval, fn(f64) -> f64);
        let cases: &[Pair] = &[
            ("powi", |x| x.powi(3), |x| Real::powi(x, 3)),
            ("even powi", |x| x.powi(4), |x| Real::powi(x, 4)),
            ("inverse", |x| x.powi(-1), |x| Real::powi(x, -1)),
            ("inverse square", |x| x.powi(-2), |x| Real::powi(x, -2)),
            ("powf", |x| x.powf(Interval::of(2.5)), |x| Real::powf(x, 2.5)),
            ("falling powf", |x| x.powf(Interval::of(-0.5)), |x| Real::powf(x, -0.5)),
            ("exponent", |x| Interval::of(0.3).powf(x), |x| Real::powf(0.3, x)),
            ("sqrt", Real::sqrt, Real::sqrt),
            ("abs", Real::abs, Real::abs),
            ("floor", Real::floor, Real::floor),
            ("exp", Real::exp, Real::exp),
            ("ln", Real::ln, Real::ln),
            ("sin", Real::sin, Real::sin),
            ("cos", Real::cos, Real::cos),
            ("tan", Real::tan, Real::tan),
            ("asin", Real::asin, Real::asin),
            ("acos", Real::acos, Real::acos),
            ("atan", Real::atan, Real::atan),
            ("sinh", Real::sinh, Real::sinh),
            ("cosh", Real::cosh, Real::cosh),
            ("tanh", Real::tanh, Real::tanh),
            ("sum", |x| x * x - Interval::of(2.0) * x, |x| x * x - 2.0 * x),
            ("quotient", |x| Interval::of(1.0) / (x - Interval::of(3.0)), |x| 1.0 / (x - 3.0)),
            ("negative", |x| -x, |x| -x),
            (
                "branch",
                |x| Interval::select_less(x, Interval::of(0.4), -x, x * x),
                |x| if x < 0.4 { -x } else { x * x },
            ),
        ];
        let middles = [-40.3, -3.0, -1.0, -0.2, 0.0, 0.3, 0.4, 0.99, 1.5, 3.0, 7.7, 300.0];
        for (name, range, value) in cases {
            for middle in middles {
                for width in [0.0, 1e-9, 1e-3, 0.4, 2.0, 7.0] {
                    let found = range(Interval::around(middle, width));
                    for share in -50..=50 {
                        let x = middle + width * f64::from(share) / 50.0;
                        let value = value(x);
                        let is_contained =
                            value.is_nan() || (found.low <= value && value <= found.high);
                        assert!(is_contained, "{name}({x}) = {value} is not in {found:?}");
                    }
                }
                let (narrow, value) = (range(Interval::around(middle, 1e-9)), value(middle));
                let is_narrow = narrow.high - narrow.low <= 1e-6 * (1.0 + value.abs());
                let may_be_wide = !value.is_finite() || value.abs() > 1e8;
                let is_at_an_end = [-3.0, -1.0, 0.0, 0.4, 3.0, 300.0].contains(&middle);
                assert!(is_narrow || may_be_wide || is_at_an_end, "{name} at {middle}: {narrow:?}");
            }
        }
    }

    #[test]
    fn without_a_value_or_a_bound_the_range_is_all_numbers() {
        let over = |low: f64, high: f64| Interval { low, high };
        let ranges = [
            over(-1e-3, 4.0).sqrt(),
            over(0.0, 1.0).ln(),
            over(-1.0, 1.0).powi(-2),
            over(1.0, 2.0) / over(-1.0, 0.0),
            over(1.5, 1.6).tan(),
            over(0.5, 1.01).asin(),
            over(-2.0, 0.5).acos(),
            over(-2.0, 0.5).powf(Interval::of(0.5)),
            Interval::of(f64::NAN),
            Interval::of(f64::INFINITY) * Interval::of(0.0),
        ];
        for (index, range) in ranges.into_iter().enumerate() {
            assert_eq!(range, Interval::WHOLE, "{index}");
        }
    }

    #[test]
    fn what_is_surely_zero_is_exactly_zero() {
        let zero = Interval::of(0.0);
        let ranges = [
            zero * Interval::WHOLE,
            Interval::around(1.0, 2.0) * zero,
            zero / Interval::of(3.0),
            zero + zero * Interval::WHOLE,
            Interval::of(2.5) - Interval::of(2.5),
        ];
        for (index, range) in ranges.into_iter().enumerate() {
            assert!(range.is_zero(), "{index}: {range:?}");
        }
    }

    #[test]
    fn tables_contain_their_values() {
        let table = CubicTable {
            knots: &[0.0, 1.0, 3.0],
            coefficients: &[[0.0, 1.25, 0.0, -0.25], [1.0, 0.5, -0.75, 0.125]],
        };
        for middle in [-1.0, 0.0, 0.4, 1.0, 2.2, 3.0, 5.0] {
            for width in [0.0, 0.1, 1.5] {
                let range: Interval = table.evaluate(0, Interval::around(middle, width));
                for share in -20..=20 {
                    let x = middle + width * f64::from(share) / 20.0;
                    let value: f64 = table.evaluate(0, x);
                    assert!(range.low <= value && value <= range.high, "{x}: {range:?}");
                }
            }
        }
    }
}

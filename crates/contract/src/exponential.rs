//! Exponential function and hyperbolic tangent by arithmetic alone: bitwise equal with and
//! without `std`, and for several numbers side by side.
//!
//! ```text
//! x = n ln 2 + r + tail       n whole, |r| <= ln(2)/2
//! e^x = 2^n (1 + p)           p = r + tail + r^2 q(r) = e^(r + tail) - 1
//! tanh x = E/(E + 2)          E = e^(2 |x|) - 1 = 2^n p + (2^n - 1)
//! ```
//!
//! ln 2 is split into two parts, of which the first has so few digits that its product with n is
//! exact. E is never the difference of close numbers, so small x lose no digits. The error of the
//! exponential is below one unit in the last place, that of the tangent about two at most.
//!
//! Source: the argument reduction is that of fdlibm (Sun Microsystems, 1993), `__ieee754_exp`. q
//! is the minimax polynomial of degree 9 for (e^r - 1 - r)/r^2, by Remez's exchange in fifty
//! digits; its error is 4e-18 of e^r.

use crate::Real;
use crate::digits::{Digits, ROUNDING};

/// ln 2: the first 32 bits, the rest.
const LN_2: [f64; 2] = [6.931_471_803_691_238e-1, 1.908_214_929_270_587_7e-10];

/// e^r = 1 + r + sum of `SERIES[k] r^(k + 2)`.
const SERIES: [f64; 10] = [
    5.000_000_000_000_011e-1,
    1.666_666_666_666_641_3e-1,
    4.166_666_666_653_015_5e-2,
    8.333_333_333_494_461e-3,
    1.388_888_894_363_013_4e-3,
    1.984_126_950_657_872_3e-4,
    2.480_149_309_888_739e-5,
    2.755_758_637_378_518e-6,
    2.763_024_838_532_302e-7,
    2.500_006_162_553_128e-8,
];

/// Bounds: below the first the exponential is zero, above the second it is infinite.
const ENDS: [f64; 2] = [-750.0, 710.0];

/// Argument beyond which the tangent is one to the last bit.
const SATURATED: f64 = 22.0;

/// Largest absolute value that [`exponential_near`] accepts.
pub const NEAR: f64 = 700.0;

/// Computes the exponential function up to [`NEAR`], with fewer operations than [`exponential`]
/// and bitwise equal to it.
#[must_use]
#[inline(always)]
pub fn exponential_near<R: Digits>(x: R) -> R {
    let (n, r, rest) = reduced(x);
    (R::literal(1.0) + (r + rest)) * R::power_of_two(n)
}

/// Computes the exponential function.
#[must_use]
#[inline(always)]
pub fn exponential<R: Digits>(x: R) -> R {
    let l = R::literal;
    let [lowest, highest] = [l(ENDS[0]), l(ENDS[1])];
    // Written so that NaN stays NaN.
    let x = R::select_less(x, lowest, lowest, x);
    let x = R::select_less(highest, x, highest, x);
    let (n, r, rest) = reduced(x);
    // In two steps, because 2^n alone may overflow or underflow.
    let half = round(n * l(0.5));
    let scaled = (l(1.0) + (r + rest)) * R::power_of_two(half);
    scaled * R::power_of_two(n - half)
}

/// Computes the hyperbolic tangent.
#[must_use]
#[inline(always)]
pub fn hyperbolic_tangent<R: Digits>(x: R) -> R {
    let l = R::literal;
    let size = x.abs();
    // Written so that NaN stays NaN.
    let near = R::select_less(l(SATURATED), size, l(SATURATED), size);
    let (n, r, rest) = reduced(near + near);
    let power = R::power_of_two(n);
    let (low, part) = (power - l(1.0), power * r);
    let high = low + part;
    let lost = part - (high - low);
    let e = high + power.mul_add(rest, lost);
    (e / (e + l(2.0))).with_sign_of(x)
}

/// Computes the hyperbolic tangent of one number, bitwise equal to [`hyperbolic_tangent`]. Where it
/// is one, as for friction of machines that run, that is all.
#[must_use]
#[inline(always)]
pub fn hyperbolic_tangent_alone(x: f64) -> f64 {
    if SATURATED < x.abs() { 1.0.with_sign_of(x) } else { hyperbolic_tangent(x) }
}

/// Returns n, r and e^(r + tail) - 1 - r of a number.
#[inline(always)]
fn reduced<R: Digits>(x: R) -> (R, R, R) {
    let l = R::literal;
    let (ln_2, ln_2_rest) = (l(LN_2[0]), l(LN_2[1]));
    // Literals are made one by one, as in `sine`.
    let [c0, c1, c2, c3, c4, c5, c6, c7, c8, c9] = SERIES;
    let n = x.mul_add(l(core::f64::consts::LOG2_E), l(ROUNDING)) - l(ROUNDING);
    let near = (-n).mul_add(ln_2, x);
    let r = (-n).mul_add(ln_2_rest, near);
    let tail = (-n).mul_add(ln_2_rest, near - r);
    // Terms are computed side by side, not one after the other.
    let z = r * r;
    let w = z * z;
    let low = z.mul_add(l(c3).mul_add(r, l(c2)), l(c1).mul_add(r, l(c0)));
    let high = z.mul_add(l(c7).mul_add(r, l(c6)), l(c5).mul_add(r, l(c4)));
    let q = w.mul_add(w.mul_add(l(c9).mul_add(r, l(c8)), high), low);
    (n, r, z.mul_add(q, tail))
}

#[inline(always)]
fn round<R: Real>(x: R) -> R {
    (x + R::literal(ROUNDING)) - R::literal(ROUNDING)
}

#[cfg(all(test, feature = "std"))]
mod tests {
    use core::f64::consts::LN_2 as LN_2_NEAREST;

    use super::*;

    /// Double-double number: the second part is the rounding error of the first; 106 bits.
    #[derive(Debug, Clone, Copy)]
    struct Double(f64, f64);

    impl Double {
        /// Returns the exact sum a + b.
        fn sum(a: f64, b: f64) -> Self {
            let s = a + b;
            let part = s - a;
            Self(s, (a - (s - part)) + (b - part))
        }

        fn plus(self, other: Self) -> Self {
            let Self(s, lost) = Self::sum(self.0, other.0);
            Self::sum(s, lost + self.1 + other.1)
        }

        fn times(self, other: Self) -> Self {
            let p = self.0 * other.0;
            let lost = f64::mul_add(self.0, other.0, -p);
            Self::sum(p, lost + (self.0 * other.1 + self.1 * other.0))
        }

        fn over(self, other: Self) -> Self {
            let first = self.0 / other.0;
            let minus = |q: f64| other.times(Self(-q, 0.0));
            let left = self.plus(minus(first));
            let second = left.0 / other.0;
            let third = left.plus(minus(second)).0 / other.0;
            Self::sum(first, second).plus(Self(third, 0.0))
        }
    }

    /// Returns n and e^r - 1 of x = n ln 2 + r, by the series of the exponential.
    fn by_series(x: f64) -> (f64, Double) {
        let n = f64::round(x / LN_2_NEAREST);
        let ln_2 = Double(LN_2_NEAREST, 2.319_046_813_846_299_6e-17);
        let r = Double(x, 0.0).plus(ln_2.times(Double(-n, 0.0)));
        let mut power = Double(0.0, 0.0);
        for k in (1..=34).rev() {
            // p = r/k (1 + p)
            let divided = r.over(Double(f64::from(k), 0.0));
            power = divided.plus(divided.times(power));
        }
        (n, power)
    }

    /// Returns e^x 2^-n, and n.
    fn exact_exponential(x: f64) -> (Double, f64) {
        let (n, power) = by_series(x);
        (Double(1.0, 0.0).plus(power), n)
    }

    fn exact_tangent(x: f64) -> Double {
        let (n, power) = by_series(2.0 * x.abs());
        let scale = n.exp2();
        let e = power.times(Double(scale, 0.0)).plus(Double(scale - 1.0, 0.0));
        let tangent = e.over(e.plus(Double(2.0, 0.0)));
        if x < 0.0 { Double(-tangent.0, -tangent.1) } else { tangent }
    }

    /// Returns the difference from the exact value in units in the last place.
    fn units(found: f64, exact: Double) -> f64 {
        let unit = exact.0.abs().next_up() - exact.0.abs();
        ((found - exact.0 - exact.1) / unit).abs()
    }

    /// Returns numbers of all sizes and both signs, few of them where the functions are flat.
    fn numbers(largest: f64) -> impl Iterator<Item = f64> {
        let spaced = (0..20_000).map(move |k| largest * (f64::from(k) + 0.377) / 20_000.0);
        let near_one = (0..20_000).map(|k| f64::from(k) * 1.01e-4);
        let small = (1..1000).map(|k| 0.5_f64.powi(k) * 1.37);
        let all = spaced.chain(near_one).chain(small);
        all.flat_map(|x| [x, -x])
    }

    #[test]
    fn the_exponential_is_right_to_a_unit_in_the_last_place() {
        for x in numbers(700.0) {
            let (exact, n) = exact_exponential(x);
            // 2^-n in two steps, because n may be 1010.
            let half = f64::round(0.5 * n);
            let found = exponential(x) * (-half).exp2() * (half - n).exp2();
            assert!(units(found, exact) < 0.9, "e^{x:e}: {found:e} {exact:?}");
            assert_eq!(exponential(x).to_bits(), exponential_near(x).to_bits(), "{x:e}");
        }
    }

    #[test]
    fn the_exponential_keeps_its_digits_to_the_ends_of_the_numbers() {
        for x in [700.5, 705.25, 709.0, 709.78] {
            let (exact, n) = exact_exponential(x);
            let found = exponential(x) * 2.0_f64.powi(-600) * (600.0 - n).exp2();
            assert!(units(found, exact) < 0.9, "e^{x:e}");
        }
        // Below the normal numbers a unit in the last place is that of the smallest normal
        // number.
        for x in [-708.5, -710.3, -720.0, -735.1, -744.0, -745.0] {
            let (exact, n) = exact_exponential(x);
            let unit = f64::from_bits(1);
            let expected = exact.0 * (n + 600.0).exp2() * 2.0_f64.powi(-600);
            assert!((exponential(x) - expected).abs() <= unit, "e^{x:e}");
        }
        assert_eq!(exponential(0.0).to_bits(), 1.0_f64.to_bits());
        assert_eq!(exponential(-0.0).to_bits(), 1.0_f64.to_bits());
        for beyond in [709.8, 1e3, f64::MAX, f64::INFINITY] {
            assert!(exponential(beyond).is_infinite(), "{beyond:e}");
            assert_eq!(exponential(-beyond - 37.0).to_bits(), 0, "{beyond:e}");
        }
        assert!(exponential(f64::NAN).is_nan());
    }

    #[test]
    fn the_tangent_is_right_to_two_units_in_the_last_place() {
        let mut largest: f64 = 0.0;
        for x in numbers(25.0) {
            let error = units(hyperbolic_tangent(x), exact_tangent(x));
            assert!(error < 2.25, "tanh {x:e} is off by {error} units");
            largest = largest.max(error);
        }
        assert!(largest > 1.0, "the bound is near what happens");
    }

    #[test]
    fn the_tangent_is_odd_and_ends_at_one() {
        for x in numbers(50.0).chain([1e3, f64::MAX, f64::INFINITY, 0.0]) {
            let tangents = [hyperbolic_tangent(x), -hyperbolic_tangent(-x)];
            assert_eq!(tangents[0].to_bits(), tangents[1].to_bits(), "{x:e}");
            assert!(tangents[0].abs() <= 1.0, "{x:e}");
            assert_eq!(hyperbolic_tangent_alone(x).to_bits(), tangents[0].to_bits(), "{x:e} alone");
        }
        assert_eq!(hyperbolic_tangent(f64::INFINITY).to_bits(), 1.0_f64.to_bits());
        assert_eq!(hyperbolic_tangent(-0.0).to_bits(), (-0.0_f64).to_bits());
        assert!(
            hyperbolic_tangent(f64::NAN).is_nan() && hyperbolic_tangent_alone(f64::NAN).is_nan()
        );
    }
}

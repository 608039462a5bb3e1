//! Sine and cosine by arithmetic alone: bitwise equal with and without `std`, on every machine,
//! and for several numbers side by side.
//!
//! ```text
//! x = n pi/2 + r + tail      n whole, |r| <= pi/4
//! ```
//!
//! pi/2 is split into three parts, of which the first two have so few digits that their products
//! with n are exact. Sine and cosine of r are polynomials; n decides which is which. The error is
//! below one unit in the last place.
//!
//! Source: the argument reduction and the polynomials are those of fdlibm (Sun Microsystems,
//! 1993), `__ieee754_rem_pio2`, `__kernel_sin` and `__kernel_cos`, without branches and with
//! fused products if the target has them.

use crate::Real;
use crate::digits::{Digits, ROUNDING};

/// Largest absolute argument. Beyond it, n would need more digits than are reserved for it.
pub const FARTHEST: f64 = 1e6;

/// pi/2: 33 bits, the next 33 bits, the rest.
const HALF_PI: [f64; 3] =
    [1.570_796_326_734_125_6, 6.077_100_506_303_966e-11, 2.022_266_248_795_950_6e-21];

/// sin r = r + sum of `SINE[k] r^(2 k + 3)`.
const SINE: [f64; 6] = [
    -1.666_666_666_666_663_2e-1,
    8.333_333_333_322_49e-3,
    -1.984_126_982_985_795e-4,
    2.755_731_370_707_006_8e-6,
    -2.505_076_025_340_686_3e-8,
    1.589_690_995_211_55e-10,
];

/// cos r = 1 - r^2/2 + sum of `COSINE[k] r^(2 k + 4)`.
const COSINE: [f64; 6] = [
    4.166_666_666_666_66e-2,
    -1.388_888_888_887_411e-3,
    2.480_158_728_947_673e-5,
    -2.755_731_435_139_066_3e-7,
    2.087_572_321_298_175e-9,
    -1.135_964_755_778_819_5e-11,
];

/// Returns sine and cosine of a number not farther from zero than [`FARTHEST`].
#[must_use]
#[inline(always)]
pub fn sine_and_cosine<R: Digits>(x: R) -> (R, R) {
    let reduced = Reduced::of(x);
    R::turn(reduced.digits, reduced.sine(), reduced.cosine())
}

/// Returns the sine of a number not farther from zero than [`FARTHEST`], by the polynomial that
/// it needs: angles of motions seldom change their quadrant, so processors predict which.
#[must_use]
#[inline(always)]
pub fn sine_near(x: f64) -> f64 {
    sine_after_turns(x, 0)
}

/// Returns the cosine likewise.
#[must_use]
#[inline(always)]
pub fn cosine_near(x: f64) -> f64 {
    sine_after_turns(x, 1)
}

/// Returns sin(x + turns pi/2).
#[inline(always)]
fn sine_after_turns(x: f64, turns: u64) -> f64 {
    let reduced = Reduced::of(x);
    let turns = reduced.digits.to_bits().wrapping_add(turns);
    let value = if turns & 1 == 0 { reduced.sine() } else { reduced.cosine() };
    // Half a turn changes the sign.
    f64::from_bits(value.to_bits() ^ ((turns & 2) << 62))
}

/// x = n pi/2 + r + tail.
struct Reduced<R> {
    /// Number whose last digits are n.
    digits: R,
    r: R,
    /// -tail.
    minus_tail: R,
    /// r^2.
    z: R,
    /// r^2/2.
    below_one: R,
    /// 1 - r^2/2.
    near: R,
}

// Literals are made one by one: the result of `array::map` is not always inlined and moves lanes
// through memory, and a loop over them prevents vectorization elsewhere.

impl<R: Real> Reduced<R> {
    #[inline(always)]
    fn of(x: R) -> Self {
        let digits = x.mul_add(R::literal(core::f64::consts::FRAC_2_PI), R::literal(ROUNDING));
        let (r, minus_tail) = remainder(x, digits - R::literal(ROUNDING));
        let z = r * r;
        let below_one = R::literal(0.5) * z;
        Self { digits, r, minus_tail, z, below_one, near: R::literal(1.0) - below_one }
    }

    /// Returns sin(r + tail) = sin r + tail cos r.
    #[inline(always)]
    fn sine(&self) -> R {
        let l = R::literal;
        let (r, z) = (self.r, self.z);
        let [s1, s2, s3, s4, s5, s6] = SINE;
        let w = z * z;
        let high = w.mul_add(l(s6).mul_add(z, l(s5)), l(s4).mul_add(z, l(s3)));
        let p = w.mul_add(high, l(s2).mul_add(z, l(s1)));
        // Subtracted, so zero keeps its sign.
        r - (-(z * r)).mul_add(p, self.minus_tail * self.near)
    }

    /// Returns cos(r + tail) = cos r - tail sin r.
    #[inline(always)]
    fn cosine(&self) -> R {
        let l = R::literal;
        let (z, near) = (self.z, self.near);
        let [c1, c2, c3, c4, c5, c6] = COSINE;
        let w = z * z;
        let high = w.mul_add(l(c6).mul_add(z, l(c5)), l(c4).mul_add(z, l(c3)));
        let p = w.mul_add(high, l(c2).mul_add(z, l(c1)));
        let lost = (l(1.0) - near) - self.below_one;
        near + (w.mul_add(p, lost) + self.r * self.minus_tail)
    }
}

/// Returns x - n pi/2 and its rounding error with the opposite sign.
#[inline(always)]
fn remainder<R: Real>(x: R, n: R) -> (R, R) {
    let l = R::literal;
    let [first, second, rest] = HALF_PI;
    let near = (-n).mul_add(l(first), x);
    let r = (-n).mul_add(l(second), near);
    (r, n.mul_add(l(rest), n.mul_add(l(second), r - near)))
}

#[cfg(all(test, feature = "std"))]
mod tests {
    use super::*;

    /// Returns the distance between two numbers in units in the last place.
    fn units(a: f64, b: f64) -> u64 {
        let place = |x: f64| if x < 0.0 { -(x.abs().to_bits() as i64) } else { x.to_bits() as i64 };
        place(a).abs_diff(place(b))
    }

    /// Returns numbers all over the range: equally spaced, and around multiples of pi/4.
    fn numbers() -> impl Iterator<Item = f64> {
        let spaced = (-40_000..=40_000).map(|k| f64::from(k) * 5e-4 * (1.0 + f64::from(k) * 1e-5));
        let eighth = core::f64::consts::FRAC_PI_4;
        let multiples = (-2000..2000).chain((1_000_000..1_002_000).step_by(7));
        let near = multiples.flat_map(move |k| {
            let middle = f64::from(k) * eighth;
            (-20_i64..=20).map(move |step| f64::from_bits((middle.to_bits() as i64 + step) as u64))
        });
        let small = (1..300).map(|k| 0.5_f64.powi(k) * 1.37);
        spaced.chain(near).chain(small).filter(|x| x.abs() <= FARTHEST)
    }

    #[test]
    fn they_are_those_of_the_standard_library_to_a_unit_in_the_last_place() {
        for x in numbers() {
            let (sine, cosine) = sine_and_cosine(x);
            assert!(units(sine, f64::sin(x)) <= 1, "sin {x:e}: {sine:e} {:e}", f64::sin(x));
            assert!(units(cosine, f64::cos(x)) <= 1, "cos {x:e}: {cosine:e} {:e}", f64::cos(x));
            let alone = [sine_near(x), cosine_near(x)].map(f64::to_bits);
            assert_eq!(alone, [sine, cosine].map(f64::to_bits), "{x:e} alone");
        }
    }

    #[test]
    fn sine_is_odd_and_cosine_even_to_the_last_bit() {
        for x in numbers() {
            let ((s, c), (minus_s, also_c)) = (sine_and_cosine(x), sine_and_cosine(-x));
            assert_eq!(
                (s.to_bits(), c.to_bits()),
                ((-minus_s).to_bits(), also_c.to_bits()),
                "{x:e}"
            );
        }
        assert!(sine_and_cosine(-0.0_f64).0.is_sign_negative());
    }

    #[test]
    fn squares_add_up_to_one() {
        for x in numbers() {
            let (s, c) = sine_and_cosine(x);
            assert!((s * s + c * c - 1.0).abs() <= 2.0 * f64::EPSILON, "{x:e}");
        }
    }

    #[test]
    fn far_away_and_beyond_numbers_the_standard_library_answers() {
        for x in [1.1e6, -3e8, 1e22, f64::MAX] {
            assert_eq!((Real::sin(x), Real::cos(x)), (f64::sin(x), f64::cos(x)));
        }
        assert!(Real::sin(f64::INFINITY).is_nan() && Real::cos(f64::NAN).is_nan());
    }
}

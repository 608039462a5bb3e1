//! Approximate logarithms and powers of two, from the digits of a number.

use machinist_contract::Real;
use machinist_contract::digits::{Digits, ROUNDING};

/// Numbers, one or several in lanes, with fast approximate logarithms.
pub trait Magnitude: Real {
    /// Returns log2 with an error of about a twentieth, which is enough for the length of a step,
    /// of a number that is not negative. The result is very small for zero.
    #[must_use]
    fn log2(self) -> Self;
    /// Returns the larger of two numbers; `self` if one is NaN.
    #[must_use]
    fn larger(self, value: Self) -> Self {
        Self::select_less(self, value, value, self)
    }
    /// Returns 2^x with an error of about three thousandths; infinite or zero where it is out of
    /// range.
    #[must_use]
    fn exp2(self) -> Self;
}

impl Magnitude for f64 {
    #[inline(always)]
    fn log2(self) -> Self {
        const ONE: i64 = 1.0_f64.to_bits() as i64;
        const DOUBLING: f64 = 1.0 / (1_u64 << 52) as f64;
        // This equals `log2_of_halves` in fewer operations, since digits of a scalar convert fast.
        BEHIND + (self.to_bits() as i64 - ONE) as f64 * DOUBLING
    }
    #[inline(always)]
    fn exp2(self) -> Self {
        exp2(self)
    }
}

/// Returns the smaller of two numbers; NaN does not count.
#[inline(always)]
pub(crate) fn smaller<R: Real>(length: R, value: R) -> R {
    R::select_less(value, length, value, length)
}

/// Half of the largest difference of log2(1 + m) and m.
pub(crate) const BEHIND: f64 = 0.043;

/// Returns 2^x; see [`Magnitude::exp2`].
#[inline(always)]
pub(crate) fn exp2<R: Digits>(x: R) -> R {
    const BEYOND: f64 = 1024.0_f64.next_down();
    let (one, least) = (R::literal(1.0), R::literal(-1022.0));
    let inside = R::select_less(least, x, x, least);
    let nearest = inside + R::literal(ROUNDING) - R::literal(ROUNDING);
    let whole = R::select_less(inside, nearest, nearest - one, nearest);
    let f = inside - whole;
    // 2^f is nearly 1 + f - 0.337 f (1 - f).
    let power = R::power_of_two(whole) * (one + f - R::literal(0.337) * f * (one - f));
    R::select_less(R::literal(BEYOND), x, R::literal(f64::INFINITY), power)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn logarithms_and_powers_are_good_enough_for_a_step() {
        for x in (-200..200).map(|n| 0.37 * f64::from(n)) {
            assert!((Magnitude::log2(f64::exp2(x)) - x).abs() < 0.05);
            assert!((Magnitude::exp2(x) / f64::exp2(x) - 1.0).abs() < 0.005);
        }
        let powers = [f64::INFINITY, 2000.0, 1024.0].map(Magnitude::exp2);
        assert!(powers.iter().all(|power| power.is_infinite()));
        assert!(Magnitude::exp2(-2000.0) < 1e-300);
    }

    #[test]
    fn powers_are_those_by_rounding_down() {
        let mut bits = 0x3fe5_5555_1234_5678_u64;
        for _ in 0..10_000 {
            // Marsaglia's xorshift.
            bits ^= bits << 13;
            bits ^= bits >> 7;
            bits ^= bits << 17;
            let log = Magnitude::log2(f64::from_bits(bits & (u64::MAX >> 1)));
            let x = 2.5 * (log % 400.0);
            let f = x - x.floor();
            let power = f64::exp2(x.floor().max(-1022.0)) * (1.0 + f - 0.337 * f * (1.0 - f));
            assert!(x < -1022.0 || Magnitude::exp2(x).to_bits() == power.to_bits(), "{x}");
        }
    }
}

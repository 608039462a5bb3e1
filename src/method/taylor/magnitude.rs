//! Rough logarithms and powers of two, by the digits of a number.

use machinist_contract::Real;
use machinist_contract::digits::{Digits, ROUNDING};

/// Numbers, one or several side by side, whose logarithms are near at hand.
pub trait Magnitude: Real {
    /// Log2 to about a twentieth, which is more than a step's length needs, of a number that is
    /// not below zero. Very small for zero.
    #[must_use]
    fn log2(self) -> Self;
    /// The larger of two numbers; `self` if one is NaN.
    #[must_use]
    fn larger(self, value: Self) -> Self {
        Self::select_less(self, value, value, self)
    }
    /// 2^x to about three thousandths; infinite and zero where it is out of range.
    #[must_use]
    fn exp2(self) -> Self;
}

impl Magnitude for f64 {
    #[inline(always)]
    fn log2(self) -> Self {
        let bits = self.to_bits();
        let half = |bits: u64| f64::from_bits(bits | WHOLE);
        log2_of_halves(half(bits >> 32), half(bits & LOWER))
    }
    #[inline(always)]
    fn exp2(self) -> Self {
        exp2(self)
    }
}

/// Digits of a number that is this number with those of a small whole one at the end.
pub(crate) const WHOLE: u64 = SHIFT.to_bits();

/// The lower half of a number's digits.
pub(crate) const LOWER: u64 = 0xffff_ffff;

const SHIFT: f64 = (1_u64 << 52) as f64;

/// Log2 by the halves of a number's digits behind [`WHOLE`]: the digits of a positive number, read
/// as a whole number, are nearly its logarithm.
#[inline(always)]
pub(crate) fn log2_of_halves<R: Real>(upper: R, lower: R) -> R {
    const ONE: f64 = (1.0_f64.to_bits() >> 32) as f64;
    const UPPER: f64 = 1.0 / (1_u64 << 20) as f64;
    // All but the sum is exact.
    let whole = (upper - R::literal(SHIFT + ONE)) * R::literal(UPPER);
    let part = (lower - R::literal(SHIFT)) * R::literal(1.0 / SHIFT);
    // m falls behind log2(1 + m) by 0.086 at most.
    R::literal(0.043) + (whole + part)
}

/// See [`Magnitude::exp2`].
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

    /// The digits as one whole number, and the power by rounding down.
    #[test]
    fn halves_of_digits_add_up_to_all_of_them() {
        let mut bits = 0x3fe5_5555_1234_5678_u64;
        for _ in 0..10_000 {
            // Marsaglia's xorshift.
            bits ^= bits << 13;
            bits ^= bits >> 7;
            bits ^= bits << 17;
            let value = f64::from_bits(bits & (u64::MAX >> 1));
            let whole = value.to_bits().cast_signed() - 1.0_f64.to_bits().cast_signed();
            let log = 0.043 + whole as f64 / SHIFT;
            assert_eq!(Magnitude::log2(value).to_bits(), log.to_bits());
            let x = 2.5 * (log % 400.0);
            let f = x - x.floor();
            let power = f64::exp2(x.floor().max(-1022.0)) * (1.0 + f - 0.337 * f * (1.0 - f));
            assert!(x < -1022.0 || Magnitude::exp2(x).to_bits() == power.to_bits(), "{x}");
        }
    }
}

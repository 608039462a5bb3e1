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
        const ONE: i64 = 1.0_f64.to_bits() as i64;
        const DOUBLING: f64 = 1.0 / (1_u64 << 52) as f64;
        // What `log2_of_halves` gives, in fewer operations: of one number digits are soon a number.
        BEHIND + (self.to_bits() as i64 - ONE) as f64 * DOUBLING
    }
    #[inline(always)]
    fn exp2(self) -> Self {
        exp2(self)
    }
}

/// Half of what m falls behind log2(1 + m) at most.
pub(crate) const BEHIND: f64 = 0.043;

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

//! What arithmetic alone does badly: numbers by their binary digits.

use crate::Real;

/// Adding it leaves the digits of a whole number last, and subtracting it again rounds to
/// that number.
pub const ROUNDING: f64 = 6_755_399_441_055_744.0;

/// Numbers whose digits can be moved, one by one or several side by side.
pub trait Digits: Real {
    /// 2^n for a whole number n from -1022 to 1023; anything else gives anything.
    fn power_of_two(n: Self) -> Self;
    /// A number that is not below zero with the sign of another, of zero too.
    #[must_use]
    fn with_sign_of(self, other: Self) -> Self;
    /// Sine and cosine of n quarters of a turn more, n being the last digits of a number.
    fn turn(n: Self, sine: Self, cosine: Self) -> (Self, Self);
}

impl Digits for f64 {
    #[inline(always)]
    fn power_of_two(n: Self) -> Self {
        // The sum ends in n + 1023, which is moved to where a number has its exponent.
        Self::from_bits((n + (ROUNDING + 1023.0)).to_bits() << 52)
    }

    #[inline(always)]
    fn with_sign_of(self, other: Self) -> Self {
        const SIGN: u64 = 1 << 63;
        Self::from_bits(self.to_bits() | (other.to_bits() & SIGN))
    }

    #[inline(always)]
    fn turn(n: Self, sine: Self, cosine: Self) -> (Self, Self) {
        let n = n.to_bits();
        let is_odd = n & 1 == 1;
        let (s, c) = if is_odd { (cosine, sine) } else { (sine, cosine) };
        // Half a turn changes signs.
        let sign = |n: u64| (n & 2) << 62;
        let signed = |x: f64, n| Self::from_bits(x.to_bits() ^ sign(n));
        (signed(s, n), signed(c, n.wrapping_add(1)))
    }
}

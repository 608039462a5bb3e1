//! Operations on the binary digits of numbers, which arithmetic alone does badly.

use crate::Real;

/// Summand that rounds: after adding it the last digits are those of a whole number, and
/// subtracting it again gives that number.
pub const ROUNDING: f64 = 6_755_399_441_055_744.0;

/// Numbers whose digits can be moved, singly or several side by side.
pub trait Digits: Real {
    /// Returns 2^n for a whole number n from -1022 to 1023; for other arguments the result is
    /// unspecified.
    fn power_of_two(n: Self) -> Self;
    /// Returns a nonnegative number with the sign of another, also of a signed zero.
    #[must_use]
    fn with_sign_of(self, other: Self) -> Self;
    /// Adds n quarter turns to an angle given by its sine and cosine. n is in the last digits of
    /// a number.
    fn turn(n: Self, sine: Self, cosine: Self) -> (Self, Self);
}

impl Digits for f64 {
    #[inline(always)]
    fn power_of_two(n: Self) -> Self {
        // The sum ends in n + 1023, which is shifted to the exponent.
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
        // Half a turn changes the signs.
        let sign = |n: u64| (n & 2) << 62;
        let signed = |x: f64, n| Self::from_bits(x.to_bits() ^ sign(n));
        (signed(s, n), signed(c, n.wrapping_add(1)))
    }
}

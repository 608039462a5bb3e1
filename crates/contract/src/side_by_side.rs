//! Functions of several numbers at once, in groups of four, with the vector width of the target.
//!
//! Every number gets the bits it would get alone. Functions of four are not inlined, because
//! compilers split their loops again within other code. Numbers are passed one by one, in
//! registers: the processor would stall on numbers that are written one by one and read as a
//! vector.

use core::array::from_fn;

use crate::Real;
use crate::exponential::hyperbolic_tangent;
use crate::sine::{FARTHEST, sine_and_cosine};

/// Returns sine and cosine of every number.
#[inline(always)]
pub fn sines_and_cosines<const N: usize>(angles: [f64; N]) -> [(f64, f64); N] {
    let mut pairs = [(0.0, 0.0); N];
    by_fours(&angles, |first, [a, b, c, d]| {
        let (sines, cosines) = sine_and_cosine_of_four(a, b, c, d);
        for (pair, four) in pairs[first..].iter_mut().zip(sines.into_iter().zip(cosines)) {
            *pair = four;
        }
    });
    pairs
}

/// Returns the hyperbolic tangent of every number.
#[inline(always)]
pub fn hyperbolic_tangents<const N: usize>(arguments: [f64; N]) -> [f64; N] {
    let mut tangents = [0.0; N];
    by_fours(&arguments, |first, [a, b, c, d]| {
        let four = hyperbolic_tangent_of_four(a, b, c, d);
        for (tangent, one) in tangents[first..].iter_mut().zip(four) {
            *tangent = one;
        }
    });
    tangents
}

/// Passes the numbers on in groups of four, each with its first index. The last group is filled
/// up with its last number.
#[inline(always)]
fn by_fours<const N: usize>(numbers: &[f64; N], mut take: impl FnMut(usize, [f64; 4])) {
    for first in (0..N).step_by(4) {
        take(first, from_fn(|index| numbers[(first + index).min(N - 1)]));
    }
}

#[inline(never)]
fn sine_and_cosine_of_four(a: f64, b: f64, c: f64, d: f64) -> ([f64; 4], [f64; 4]) {
    let angles = [a, b, c, d];
    let (mut sines, mut cosines) = ([0.0; 4], [0.0; 4]);
    let is_near = angles.iter().fold(true, |is_near, x| is_near & (x.abs() <= FARTHEST));
    for index in 0..4 {
        let x = angles[index];
        let pair = if is_near { sine_and_cosine(x) } else { Real::sin_cos(x) };
        (sines[index], cosines[index]) = pair;
    }
    (sines, cosines)
}

#[inline(never)]
fn hyperbolic_tangent_of_four(a: f64, b: f64, c: f64, d: f64) -> [f64; 4] {
    let mut tangents = [0.0; 4];
    for (tangent, x) in tangents.iter_mut().zip([a, b, c, d]) {
        *tangent = hyperbolic_tangent(x);
    }
    tangents
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Returns angles, of which one may be so large that another algorithm is used.
    fn angles<const N: usize>(far_away: bool) -> [f64; N] {
        from_fn(|index| match index {
            2 if far_away => 3e8,
            _ => 1.7 * index as f64 - 4.0,
        })
    }

    fn assert_same<const N: usize>() {
        for far_away in [false, true] {
            let x = angles::<N>(far_away);
            let (pairs, tangents) = (sines_and_cosines(x), hyperbolic_tangents(x));
            for index in 0..N {
                let alone = [Real::sin(x[index]), Real::cos(x[index]), Real::tanh(x[index])];
                let together = [pairs[index].0, pairs[index].1, tangents[index]];
                assert_eq!(together.map(f64::to_bits), alone.map(f64::to_bits), "{}", x[index]);
            }
        }
    }

    #[test]
    fn every_number_gets_the_bits_it_gets_alone() {
        assert_same::<0>();
        assert_same::<1>();
        assert_same::<3>();
        assert_same::<4>();
        assert_same::<10>();
    }
}

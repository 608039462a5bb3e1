//! Functions of several numbers at once, in groups of four or eight, with the vector width of the
//! target.
//!
//! Every number gets the bits it would get alone. Functions of groups are not inlined, because
//! compilers split their loops again within other code. Numbers are passed one by one, in
//! registers: the processor would stall on numbers that are written one by one and read as a
//! vector. Results are aligned, because vectors that cross lines of the cache are slow to write and
//! read.

use core::array::from_fn;

use crate::Real;
use crate::exponential::hyperbolic_tangent;
use crate::sine::{FARTHEST, sine_and_cosine};

/// Numbers that lie within one line of the cache.
#[repr(align(64))]
struct Group<const N: usize>([f64; N]);

/// Returns sine and cosine of every number.
#[inline(always)]
pub fn sines_and_cosines<const N: usize>(angles: [f64; N]) -> [(f64, f64); N] {
    let mut pairs = [(0.0, 0.0); N];
    for first in (0..N).step_by(8) {
        let at = |index: usize| angles[(first + index).min(N - 1)];
        let pairs = &mut pairs[first..];
        if N - first > 4 {
            let [a, b, c, d, e, f, g, h] = from_fn(at);
            fill(pairs, &sine_and_cosine_of_eight(a, b, c, d, e, f, g, h));
        } else {
            let [a, b, c, d] = from_fn(at);
            fill(pairs, &sine_and_cosine_of_four(a, b, c, d));
        }
    }
    pairs
}

#[inline(always)]
fn fill<const N: usize>(pairs: &mut [(f64, f64)], (sines, cosines): &(Group<N>, Group<N>)) {
    for (pair, (&sine, &cosine)) in pairs.iter_mut().zip(sines.0.iter().zip(&cosines.0)) {
        *pair = (sine, cosine);
    }
}

/// Returns the hyperbolic tangent of every number.
#[inline(always)]
pub fn hyperbolic_tangents<const N: usize>(arguments: [f64; N]) -> [f64; N] {
    let mut tangents = [0.0; N];
    for first in (0..N).step_by(4) {
        let [a, b, c, d] = from_fn(|index| arguments[(first + index).min(N - 1)]);
        let Group(four) = hyperbolic_tangent_of_four(a, b, c, d);
        for (tangent, one) in tangents[first..].iter_mut().zip(four) {
            *tangent = one;
        }
    }
    tangents
}

#[inline(never)]
fn sine_and_cosine_of_four(a: f64, b: f64, c: f64, d: f64) -> (Group<4>, Group<4>) {
    each([a, b, c, d])
}

#[inline(never)]
#[allow(
    clippy::too_many_arguments,
    clippy::many_single_char_names,
    reason = "one for each register"
)]
fn sine_and_cosine_of_eight(
    a: f64,
    b: f64,
    c: f64,
    d: f64,
    e: f64,
    f: f64,
    g: f64,
    h: f64,
) -> (Group<8>, Group<8>) {
    each([a, b, c, d, e, f, g, h])
}

#[inline(always)]
fn each<const N: usize>(angles: [f64; N]) -> (Group<N>, Group<N>) {
    let (mut sines, mut cosines) = ([0.0; N], [0.0; N]);
    let is_near = angles.iter().fold(true, |is_near, x| is_near & (x.abs() <= FARTHEST));
    for index in 0..N {
        let x = angles[index];
        let pair = if is_near { sine_and_cosine(x) } else { Real::sin_cos(x) };
        (sines[index], cosines[index]) = pair;
    }
    (Group(sines), Group(cosines))
}

#[inline(never)]
fn hyperbolic_tangent_of_four(a: f64, b: f64, c: f64, d: f64) -> Group<4> {
    let mut tangents = [0.0; 4];
    for (tangent, x) in tangents.iter_mut().zip([a, b, c, d]) {
        *tangent = hyperbolic_tangent(x);
    }
    Group(tangents)
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
        assert_same::<5>();
        assert_same::<8>();
        assert_same::<10>();
        assert_same::<14>();
    }
}

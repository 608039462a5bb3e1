//! Least constraint forces of all with the same effect.

use machinist_contract::Real;

use super::rounded::{Rounded, product};
use super::solve::inverse;

/// Forces of constraints, and of redundant ones.
type Forces<R> = (Vec<Rounded<R>>, Vec<Rounded<R>>);

/// Returns the forces of constraints and of redundant ones that follow from them, of least sum of
/// squares, given their normals and the forces without redundant ones.
pub fn least<R: Real>(
    own: &[Vec<R>],
    more: &[Vec<R>],
    whole: &[Rounded<R>],
    to_f64: fn(R) -> f64,
) -> Option<Forces<R>> {
    let dot = |a: &[R], b: &[R]| a.iter().zip(b).fold(R::literal(0.0), |sum, (a, b)| sum + *a * *b);
    let gram = own.iter().map(|a| own.iter().map(|b| dot(a, b)).collect()).collect();
    let gram: Vec<Vec<R>> = inverse(gram, to_f64)?;
    // Each redundant normal is a sum of the others with these factors.
    let factors = |line: &Vec<R>| -> Vec<R> {
        let side: Vec<R> = own.iter().map(|own| dot(own, line)).collect();
        gram.iter().map(|row| dot(row, &side)).collect()
    };
    let follows: Vec<Vec<R>> = more.iter().map(factors).collect();
    let entry = |i: usize, j: usize| {
        let one = R::literal(if i == j { 1.0 } else { 0.0 });
        follows.iter().fold(one, |sum, row| sum + row[i] * row[j])
    };
    let all = 0..own.len();
    let matrix = all.clone().map(|i| all.clone().map(|j| entry(i, j)).collect()).collect();
    let matrix: Vec<Vec<R>> = inverse(matrix, to_f64)?;
    let least: Vec<Rounded<R>> = matrix.iter().map(|row| product(row, whole)).collect();
    let others = follows.iter().map(|row| product(row, &least)).collect();
    Some((least, others))
}

//! Compares the solution of many columns by steps with elimination of a dense matrix.

#![allow(clippy::needless_range_loop, reason = "matrices are written as in the formulas")]

use machinist_contract::implicit::{Step, substitute};

/// Pseudorandom numbers between -1 and 1, the same in every run.
struct Numbers(u64);

impl Numbers {
    fn next(&mut self) -> f64 {
        self.0 =
            self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }
}

type Matrix = Vec<Vec<f64>>;

/// A step that owns its terms: row, scale, terms.
type Owned = (u32, Option<u32>, Vec<(u32, u32)>);

/// Returns L D L^T without pivoting, as steps on nonzeros of L, and their factors.
fn factored(matrix: &Matrix) -> (Vec<Owned>, Vec<f64>) {
    let n = matrix.len();
    let (mut lower, mut diagonal) = (vec![vec![0.0; n]; n], vec![0.0; n]);
    for j in 0..n {
        diagonal[j] =
            matrix[j][j] - (0..j).map(|k| lower[j][k] * lower[j][k] * diagonal[k]).sum::<f64>();
        for i in j + 1..n {
            let known: f64 = (0..j).map(|k| lower[i][k] * diagonal[k] * lower[j][k]).sum();
            lower[i][j] = (matrix[i][j] - known) / diagonal[j];
        }
    }
    let (mut steps, mut factors) = (Vec::new(), Vec::new());
    let mut factor = |value: f64| {
        factors.push(value);
        factors.len() as u32 - 1
    };
    for i in 0..n {
        let terms: Vec<(u32, u32)> = (0..i)
            .filter(|k| lower[i][*k] != 0.0)
            .map(|k| (factor(lower[i][k]), k as u32))
            .collect();
        steps.push((i as u32, None, terms));
    }
    for i in (0..n).rev() {
        let scale = factor(1.0 / diagonal[i]);
        let terms = (i + 1..n)
            .filter(|k| lower[*k][i] != 0.0)
            .map(|k| (factor(lower[k][i]), k as u32))
            .collect();
        steps.push((i as u32, Some(scale), terms));
    }
    (steps, factors)
}

/// Solves by Gaussian elimination with pivoting.
fn eliminated(matrix: &Matrix, side: &[f64]) -> Vec<f64> {
    let n = matrix.len();
    let (mut a, mut x) = (matrix.clone(), side.to_vec());
    for j in 0..n {
        let pivot = (j..n).max_by(|i, k| a[*i][j].abs().total_cmp(&a[*k][j].abs())).unwrap_or(j);
        a.swap(j, pivot);
        x.swap(j, pivot);
        for i in j + 1..n {
            let factor = a[i][j] / a[j][j];
            for k in j..n {
                a[i][k] -= factor * a[j][k];
            }
            x[i] -= factor * x[j];
        }
    }
    for i in (0..n).rev() {
        let known: f64 = (i + 1..n).map(|k| a[i][k] * x[k]).sum();
        x[i] = (x[i] - known) / a[i][i];
    }
    x
}

fn solved<const COLUMNS: usize>(matrix: &Matrix, sides: &Matrix) -> Matrix {
    let (steps, factors) = factored(matrix);
    let mut x: Vec<[f64; COLUMNS]> =
        sides.iter().map(|row| std::array::from_fn(|column| row[column])).collect();
    let steps = steps.iter().map(|(row, scale, terms)| Step { row: *row, scale: *scale, terms });
    substitute(steps, &factors, &mut x);
    x.iter().map(|row| row.to_vec()).collect()
}

/// Returns a positive definite matrix, some of its couplings missing.
fn mass(n: usize, density: f64, numbers: &mut Numbers) -> Matrix {
    let mut matrix = vec![vec![0.0; n]; n];
    for i in 0..n {
        for j in 0..i {
            let is_there = numbers.next().abs() < density;
            let value = if is_there { numbers.next() } else { 0.0 };
            (matrix[i][j], matrix[j][i]) = (value, value);
        }
    }
    for (i, row) in matrix.iter_mut().enumerate() {
        row[i] = 1.0 + row.iter().map(|entry| entry.abs()).sum::<f64>();
    }
    matrix
}

/// Returns a mass matrix bordered by constraints on two or three coordinates each.
fn saddle(n: usize, constraints: usize, numbers: &mut Numbers) -> Matrix {
    let mut matrix = mass(n, 0.2, numbers);
    for row in &mut matrix {
        row.resize(n + constraints, 0.0);
    }
    for c in 0..constraints {
        let mut row = vec![0.0; n + constraints];
        row[c] = 1.0 + numbers.next().abs();
        for _ in 0..2 {
            row[((numbers.next().abs() * n as f64) as usize).min(n - 1)] += 0.4 * numbers.next();
        }
        for (k, line) in matrix.iter_mut().enumerate().take(n) {
            line[n + c] = row[k];
        }
        matrix.push(row);
    }
    matrix
}

fn check<const COLUMNS: usize>(matrix: &Matrix, numbers: &mut Numbers) {
    let n = matrix.len();
    let mut side = || (0..COLUMNS).map(|_| numbers.next()).collect::<Vec<f64>>();
    let sides: Matrix = (0..n).map(|_| side()).collect();
    let found = solved::<COLUMNS>(matrix, &sides);
    for column in 0..COLUMNS {
        let side: Vec<f64> = sides.iter().map(|row| row[column]).collect();
        let expected = eliminated(matrix, &side);
        let size = expected.iter().fold(1.0_f64, |size, value| size.max(value.abs()));
        for (row, expected) in found.iter().zip(expected) {
            assert!((row[column] - expected).abs() < 1e-9 * size, "{} {expected}", row[column]);
        }
    }
}

#[test]
fn sparse_and_dense_positive_definite_matrices_are_solved() {
    let mut numbers = Numbers(1);
    for n in 1..14 {
        for density in [0.1, 0.4, 1.0] {
            let matrix = mass(n, density, &mut numbers);
            check::<1>(&matrix, &mut numbers);
            check::<7>(&matrix, &mut numbers);
            check::<20>(&matrix, &mut numbers);
        }
    }
}

#[test]
fn matrices_bordered_by_constraints_are_solved_without_pivots() {
    let mut numbers = Numbers(2);
    for n in 2..12 {
        for constraints in 1..n {
            let matrix = saddle(n, constraints, &mut numbers);
            check::<13>(&matrix, &mut numbers);
        }
    }
}

#[test]
fn a_column_gets_the_same_bits_whatever_stands_beside_it() {
    let mut numbers = Numbers(3);
    let matrix = saddle(9, 5, &mut numbers);
    let sides: Matrix = (0..14).map(|_| (0..23).map(|_| numbers.next()).collect()).collect();
    let all = solved::<23>(&matrix, &sides);
    for column in 0..23 {
        let alone: Matrix = sides.iter().map(|row| vec![row[column]]).collect();
        for (row, alone) in all.iter().zip(solved::<1>(&matrix, &alone)) {
            assert_eq!(row[column].to_bits(), alone[0].to_bits());
        }
    }
}

#[test]
fn what_is_zero_in_all_sides_stays_exactly_zero() {
    let steps = [Step::less(1, &[(0, 0)]), Step::scaled(0, 1, &[(0, 1)])];
    let mut x = [[0.0_f64; 4]; 3];
    substitute(steps.into_iter(), &[0.3, 0.7], &mut x);
    assert_eq!(x, [[0.0; 4]; 3]);
}

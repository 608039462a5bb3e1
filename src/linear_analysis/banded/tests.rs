//! Comparison of chains with closed forms and dense matrices.

use std::f64::consts::PI;

use nalgebra::DMatrix;
use num_complex::Complex64;

use super::super::modes::{Mode, ModeKind, of_bands, of_full_matrices};
use super::super::motions::Motions;
use super::{Found, spectrum};

/// Returns M^-1 K or M^-1 D of a chain with couplings between neighbours and to the ground.
fn chain(masses: &[f64], between: &[f64], ground: &[f64]) -> DMatrix<f64> {
    let n = masses.len();
    let mut matrix = DMatrix::<f64>::zeros(n, n);
    for (index, stiffness) in between.iter().enumerate() {
        for (row, column, sign) in [(0, 0, 1.0), (0, 1, -1.0), (1, 0, -1.0), (1, 1, 1.0)] {
            matrix[(index + row, index + column)] += sign * stiffness;
        }
    }
    for (index, stiffness) in ground.iter().enumerate() {
        matrix[(index, index)] += stiffness;
    }
    DMatrix::from_fn(n, n, |row, column| matrix[(row, column)] / masses[row])
}

/// Returns the motions q'' = -stiffness q - damping q'.
fn motions(stiffness: &DMatrix<f64>, damping: &DMatrix<f64>) -> Motions {
    let n = stiffness.nrows();
    let mut matrix = DMatrix::zeros(2 * n, 2 * n);
    matrix.view_mut((0, n), (n, n)).fill_with_identity();
    matrix.view_mut((n, 0), (n, n)).copy_from(&-stiffness);
    matrix.view_mut((n, n), (n, n)).copy_from(&-damping);
    Motions::alone(&matrix, n, 0)
}

/// Returns reproducible random numbers from 0.5 to 1.5.
fn some(count: usize, seed: f64) -> Vec<f64> {
    (0..count).map(|k| 1.0 + 0.5 * (1e4 * (k as f64 * 0.917 + seed).sin()).sin()).collect()
}

/// Returns eigenvalues with nonnegative imaginary part for a frequency and proportional damping.
fn damped(frequency: f64, [by_mass, by_stiffness]: [f64; 2]) -> Vec<Complex64> {
    let half = f64::midpoint(by_mass, by_stiffness * frequency * frequency);
    let root = Complex64::from(half * half - frequency * frequency).sqrt();
    if root.im > 0.0 {
        return vec![root - half];
    }
    let faster = -half - root;
    vec![faster, faster.inv() * frequency * frequency]
}

/// Returns the largest relative distance of an expected eigenvalue from the nearest one found.
fn worst(modes: &[Mode], expected: impl IntoIterator<Item = Complex64>) -> f64 {
    let distance = |value: Complex64| {
        let nearest = modes.iter().map(|mode| (mode.eigenvalue() - value).norm());
        nearest.fold(f64::INFINITY, f64::min) / value.norm()
    };
    expected.into_iter().map(distance).fold(0.0, f64::max)
}

#[test]
fn uniform_chains_have_the_frequencies_of_the_closed_form() {
    for (n, dampings) in [(50, 4), (100, 4), (300, 2), (1000, 1)] {
        for damping in &[[0.01, 1e-3], [0.0, 0.0], [0.02, 0.0], [0.0, 3e-4]][..dampings] {
            let ones = vec![1.0; n + 1];
            let mut held = chain(&ones[..n], &vec![1e4; n - 1], &[1e4]);
            held[(n - 1, n - 1)] += 1e4;
            let slow = DMatrix::identity(n, n) * damping[0] + &held * damping[1];
            let modes = of_bands(&motions(&held, &slow)).expect("a chain");
            let frequency = |j: usize| 200.0 * (j as f64 * PI / (2.0 * (n + 1) as f64)).sin();
            let off = worst(&modes, (1..=n).flat_map(|j| damped(frequency(j), *damping)));
            // Frequencies far below the highest have the rounding error of its square.
            assert!(off < 1e-15 * (n * n) as f64, "{n} {damping:?}: {off:e}");
            let count = |mode: &Mode| if mode.kind == ModeKind::Oscillation { 2 } else { 1 };
            assert_eq!(modes.iter().map(count).sum::<usize>(), 2 * n);
            let residual = modes.iter().fold(0.0_f64, |most, mode| most.max(mode.residual));
            assert!(residual < 1e-13, "{residual:e}");
        }
    }
}

#[test]
fn chains_that_nothing_holds_turn_freely_and_have_the_frequencies_of_the_closed_form() {
    for (n, dampings) in [(60, 3), (300, 1)] {
        let stiffness = chain(&vec![2.0; n], &vec![5e3; n - 1], &[]);
        for damping in &[[0.0, 0.0], [0.05, 0.0], [0.0, 1e-4]][..dampings] {
            let slow = DMatrix::identity(n, n) * damping[0] + &stiffness * damping[1];
            let modes = of_bands(&motions(&stiffness, &slow)).expect("a chain");
            let frequency = |j: usize| 100.0 * (j as f64 * PI / (2.0 * n as f64)).sin();
            let off = worst(&modes, (1..n).flat_map(|j| damped(frequency(j), *damping)));
            assert!(off < 1e-15 * (n * n) as f64, "{n} {damping:?}: {off:e}");
            let free = modes.iter().filter(|mode| mode.kind == ModeKind::Free).count();
            assert_eq!(free, if damping[0] > 0.0 { 1 } else { 2 });
            let common = damping[0] > 0.0;
            assert!(!common || worst(&modes, [Complex64::from(-damping[0])]) < 1e-9);
            for mode in modes.iter().filter(|mode| mode.kind == ModeKind::Free) {
                assert!(mode.shape[..n].iter().all(|x| (x[0] - 1.0).abs() < 1e-9));
            }
        }
    }
}

/// Compares frequencies, damping, shares and shapes with those of dense matrices.
fn assert_alike(of_bands: &[Mode], full: &[Mode], limit: f64) {
    assert_eq!(of_bands.len(), full.len());
    let largest = full.iter().fold(0.0_f64, |most, mode| most.max(mode.natural_frequency()));
    for mode in full {
        let distance = |other: &&Mode| (other.eigenvalue() - mode.eigenvalue()).norm();
        let nearest = of_bands.iter().min_by(|a, b| distance(a).total_cmp(&distance(b)));
        let nearest = nearest.expect("modes");
        assert!(distance(&nearest) < limit * largest, "{:?}", mode.eigenvalue());
        assert_eq!(nearest.kind, mode.kind);
        let others = full.iter().filter(|other| distance(other) > 0.0);
        let room = others.map(|other| distance(&other)).fold(f64::INFINITY, f64::min) / largest;
        if mode.kind == ModeKind::Free || room < 2e-4 {
            // Dense matrices cannot distinguish these.
            continue;
        }
        for (a, b) in nearest.shares.iter().zip(&mode.shares) {
            // The rounding error of dense matrices is relative to their norm.
            assert!((a - b).abs() < 1e-10 / room, "{:?}: {a} {b}", mode.eigenvalue());
        }
        assert!(nearest.residual < 1e-13, "{:e}", nearest.residual);
    }
}

#[test]
fn chains_of_any_masses_and_dampers_have_the_modes_of_full_matrices() {
    for (seed, n) in [(0.1, 50), (0.2, 77)] {
        // Almost no damping, moderate damping, and strong damping that turns many oscillations into
        // decays.
        for size in [0.0, 0.3, 40.0, 400.0] {
            let masses = some(n, seed);
            let springs: Vec<f64> = some(n - 1, seed + 0.5).iter().map(|x| 1e4 * x).collect();
            let dampers: Vec<f64> = some(n - 1, seed + 0.7).iter().map(|x| size * x).collect();
            let stiffness = chain(&masses, &springs, &[300.0]);
            let damping = chain(&masses, &dampers, &[]);
            let found = of_bands(&motions(&stiffness, &damping)).expect("a chain");
            let full = of_full_matrices(None, motions(&stiffness, &damping)).expect("modes");
            let aperiodic = full.iter().filter(|mode| mode.kind == ModeKind::Aperiodic).count();
            assert_eq!(aperiodic > n, size > 100.0);
            assert_alike(&found, &full, 1e-11);
        }
    }
}

#[test]
fn first_order_states_along_a_chain_are_part_of_its_modes() {
    let n = 60;
    let stiffness = chain(&some(n, 0.4), &vec![1e4; n - 1], &[50.0]);
    let damping = chain(&some(n, 0.4), &vec![0.5; n - 1], &[]);
    let plain = motions(&stiffness, &damping);
    // Every tenth coordinate is braked by a state that follows its velocity.
    let states = n / 10;
    let mut matrix = plain.matrix.full().resize(2 * n + states, 2 * n + states, 0.0);
    for state in 0..states {
        matrix[(n + 10 * state, 2 * n + state)] = -3.0;
        let pace = 20.0 + 7.0 * state as f64;
        matrix[(2 * n + state, n + 10 * state)] = pace;
        matrix[(2 * n + state, 2 * n + state)] = -pace;
    }
    let of = || Motions::alone(&matrix, n, states);
    let found = of_bands(&of()).expect("a chain");
    let full = of_full_matrices(None, of()).expect("modes");
    assert_alike(&found, &full, 1e-11);
    // Vectors must be those of the whole matrix, entry by entry relative to the terms of each.
    let complex = matrix.map(Complex64::from);
    let sizes = matrix.abs();
    for Found { value, right, left } in spectrum(&of()).expect("a chain") {
        let [x, w] = [&right, &left].map(|vector| vector.map(Complex64::norm));
        let terms = [&sizes * &x + &x * value.norm(), sizes.tr_mul(&w) + &w * value.norm()];
        let off = [&complex * &right - &right * value, complex.tr_mul(&left) - &left * value];
        for (off, terms) in off.iter().zip(&terms) {
            assert!(
                off.camax() < 1e-13 * terms.amax(),
                "{value}: {:e}",
                off.camax() / terms.amax()
            );
        }
    }
}

#[test]
fn parts_that_nothing_joins_may_be_alike_and_numbered_anyhow() {
    let n = 120;
    let stiffness = chain(&vec![1.0; n / 2], &vec![1e4; n / 2 - 1], &[10.0]);
    let at = |index: usize| (index * 77) % n;
    let mut mixed = DMatrix::zeros(n, n);
    for row in 0..n / 2 {
        for column in 0..n / 2 {
            for part in [0, n / 2] {
                mixed[(at(part + row), at(part + column))] = stiffness[(row, column)];
            }
        }
    }
    let damping = &mixed * 1e-4;
    let found = of_bands(&motions(&mixed, &damping)).expect("two chains");
    let full = of_full_matrices(None, motions(&mixed, &damping)).expect("modes");
    assert_alike(&found, &full, 1e-11);
}

#[test]
fn what_is_no_chain_or_has_the_same_mode_twice_is_left_to_full_matrices() {
    let none = DMatrix::zeros(60, 60);
    let full = DMatrix::from_fn(60, 60, |row, column| {
        if row == column { 100.0 } else { (row * column + row + column) as f64 * 1e-4 }
    });
    assert!(of_bands(&motions(&full, &none)).is_none());
    // Three equal arms are joined to one mass, so eigenvalues of their relative motions are double.
    let arm = 30;
    let mut star = DMatrix::identity(3 * arm + 1, 3 * arm + 1) * 2e4;
    star[(0, 0)] = 3e4;
    for index in 1..=3 * arm {
        let inner = index.saturating_sub(3);
        star[(index, inner)] = -1e4;
        star[(inner, index)] = -1e4;
    }
    assert!(of_bands(&motions(&star, &DMatrix::zeros(3 * arm + 1, 3 * arm + 1))).is_none());
    let few = chain(&[1.0; 20], &[1.0; 19], &[]);
    assert!(of_bands(&motions(&few, &DMatrix::zeros(20, 20))).is_none());
}

//! Floquet multipliers: eigenvalues of the monodromy matrix.

use nalgebra::linalg::Schur;
use nalgebra::{DMatrix, DVector};
use num_complex::Complex64;
use serde::Serialize;

use super::equations::{Period, Problem};
use super::shot::Shot;

/// Singular value below which the projection onto the constraints removes a direction.
const REMOVED: f64 = 1e-8;
/// Number of solutions per eigenvector.
const ITERATIONS: usize = 4;
/// Maximum number of sweeps of the QR algorithm per state.
const SWEEPS: usize = 1000;

/// A Floquet multiplier: the factor by which a small disturbance grows in a period.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Multiplier {
    /// Real part.
    pub real: f64,
    /// Imaginary part.
    pub imaginary: f64,
    /// Modulus.
    pub modulus: f64,
    /// True for the multiplier 1 of a motion of unknown period, which belongs to its phase.
    pub is_trivial: bool,
    /// Bifurcation at which this multiplier would leave the unit circle.
    pub crossing: Crossing,
    /// Eigenvector: changes of the states at the start, real and imaginary parts, in their units.
    /// The largest change over its scale is 1. Modes do not change.
    pub vector: Vec<[f64; 2]>,
}

/// Bifurcation at which a multiplier leaves the unit circle.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Crossing {
    /// At +1: two motions meet and vanish, or a symmetry breaks.
    Fold,
    /// At -1: the period doubles.
    Flip,
    /// As a complex pair: a second frequency arises.
    NeimarkSacker,
}

impl Crossing {
    /// Returns the usual name.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Fold => "fold",
            Self::Flip => "flip",
            Self::NeimarkSacker => "Neimark-Sacker",
        }
    }
}

/// Stability of a periodic motion, by its multipliers.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Stability {
    /// Small disturbances decay: all moduli are below 1.
    Stable,
    /// Some disturbances grow.
    Unstable,
    /// A modulus is 1 to the accuracy of the runs, and the others are at most 1.
    Neutral,
}

impl Stability {
    /// Judges multipliers that have errors of this size. A double multiplier, such as that of the
    /// phase in a family of motions, has errors of its root.
    pub(super) fn of(multipliers: &[Multiplier], tolerance: f64) -> Self {
        let room = tolerance.sqrt();
        let others = multipliers.iter().filter(|multiplier| !multiplier.is_trivial);
        let largest = others.map(|multiplier| multiplier.modulus).fold(0.0, f64::max);
        if largest > 1.0 + room {
            Self::Unstable
        } else if largest < 1.0 - room {
            Self::Stable
        } else {
            Self::Neutral
        }
    }
}

/// Returns the multipliers in descending order of their moduli. Directions that constraints
/// exclude have none.
pub(super) fn multipliers(problem: &Problem<'_>, shots: &[Shot]) -> Vec<Multiplier> {
    let n = problem.free.len();
    let identity = DMatrix::identity(n, n);
    let whole =
        shots.iter().fold(identity, |product, shot| problem.scaled(&shot.transition) * product);
    let projection = problem.scaled(&shots[0].projection);
    if n == 0 || whole.iter().chain(projection.iter()).any(|entry| !entry.is_finite()) {
        return Vec::new();
    }
    let svd = projection.svd(true, false);
    let Some(directions) = svd.u else { return Vec::new() };
    let kept = (0..n).filter(|column| svd.singular_values[*column] > REMOVED);
    let kept: Vec<usize> = kept.collect();
    let basis = directions.select_columns(&kept);
    let monodromy = basis.tr_mul(&(whole * &basis));
    let Some(schur) = Schur::try_new(monodromy.clone(), f64::EPSILON, SWEEPS * (n + 1)) else {
        return Vec::new();
    };
    let mut values: Vec<Complex64> = schur.complex_eigenvalues().iter().copied().collect();
    values.sort_by(|a, b| b.norm().total_cmp(&a.norm()).then(b.im.total_cmp(&a.im)));
    let off = |value: &Complex64| (value - Complex64::ONE).norm();
    let trivial = (problem.period == Period::Unknown)
        .then(|| (0..values.len()).min_by(|a, b| off(&values[*a]).total_cmp(&off(&values[*b]))))
        .flatten();
    let multiplier = |(index, value): (usize, &Complex64)| Multiplier {
        real: value.re,
        imaginary: value.im,
        modulus: value.norm(),
        is_trivial: trivial == Some(index),
        crossing: match value {
            value if value.im != 0.0 => Crossing::NeimarkSacker,
            value if value.re >= 0.0 => Crossing::Fold,
            _ => Crossing::Flip,
        },
        vector: vector(problem, &basis, eigenvector(&monodromy, *value)),
    };
    values.iter().enumerate().map(multiplier).collect()
}

/// Returns the eigenvector of a value by inverse iteration.
fn eigenvector(matrix: &DMatrix<f64>, value: Complex64) -> DVector<Complex64> {
    let n = matrix.nrows();
    let start = |index: usize| Complex64::from((1.0 + 1.7 * (index + 1) as f64).cos());
    let mut vector = DVector::from_fn(n, |index, _| start(index));
    let norm = matrix.norm();
    // A small shift off the eigenvalue makes the matrix invertible.
    let shift = value + Complex64::from(8.0 * f64::EPSILON * norm.max(f64::MIN_POSITIVE));
    let shifted = DMatrix::from_fn(n, n, |row, column| {
        let entry = Complex64::from(matrix[(row, column)]);
        if row == column { entry - shift } else { entry }
    });
    let factors = shifted.lu();
    for _ in 0..ITERATIONS {
        let Some(next) = factors.solve(&vector) else { break };
        let size = next.norm();
        if !(size.is_finite() && size > 0.0) {
            break;
        }
        vector = next.unscale(size);
    }
    vector
}

/// Returns the changes of all states, the largest over its scale as 1.
fn vector(
    problem: &Problem<'_>,
    basis: &DMatrix<f64>,
    reduced: DVector<Complex64>,
) -> Vec<[f64; 2]> {
    let scaled = basis.map(Complex64::from) * reduced;
    let largest = scaled.iter().copied().max_by(|a, b| a.norm().total_cmp(&b.norm()));
    let largest = largest.filter(|value| value.norm() > 0.0).unwrap_or(Complex64::ONE);
    let mut vector = vec![[0.0; 2]; problem.advance.len()];
    for ((state, scale), value) in problem.free.iter().zip(&problem.scales).zip(&scaled) {
        let change = value / largest * *scale;
        vector[*state] = [change.re, change.im];
    }
    vector
}

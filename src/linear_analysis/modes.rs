//! Eigenvalues of dy'/dy and mode shapes.

use nalgebra::linalg::Schur;
use nalgebra::{DMatrix, DVector};
use num_complex::Complex64;
use serde::Serialize;

use super::banded::{self, Found};
use super::equilibrium::drift_and_rest;
use super::inverse_iteration::InverseIteration;
use super::motions::Motions;
use super::sparse_rows::SparseRows;
use super::turning::turning;
use super::within::Within;
use super::{LinearError, Linearization, require_small};
use crate::dense::balance;
use crate::sorting::sort_ascending;

/// Ratio to the norm of the matrix below which an eigenvalue is zero.
const ZERO: f64 = 1e-11;
/// The same limit about a steady rotation, where turning further and turning faster are a double
/// zero: the square root of the accuracy of a symmetry.
const DOUBLE_ZERO: f64 = 1e-5;
/// Relative distance, likewise, below which eigenvalues share a space of shapes.
const CLUSTER: f64 = 1e-7;
/// Maximum number of iterations for each eigenvalue; two or three are usual.
const ITERATIONS: usize = 100;
/// Number of similar matrices that are tried.
const ATTEMPTS: usize = 4;

/// An eigenmode: dy = Re(shape e^(eigenvalue t)).
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct Mode {
    /// Kind of motion.
    pub kind: ModeKind,
    /// Real part \[1/s\].
    pub real: f64,
    /// Imaginary part \[rad/s\], not negative: the frequency of the damped motion.
    pub imaginary: f64,
    /// Components for \[q, q', z\] in SI units, in the order of [`Linearization::motion_names`], as
    /// real and imaginary part. The coordinate or first-order state with the largest share has 1;
    /// if it is at rest, the largest component has.
    pub shape: Vec<[f64; 2]>,
    /// Shares of each coordinate, with its velocity, and of each first-order state in the motion:
    /// participation factors |w_i x_i| of right and left eigenvectors. They do not depend on units
    /// and have the sum 1.
    pub shares: Vec<f64>,
    /// |A x - eigenvalue x|/(|A| |x|) with states measured by their scales: the error of the shape.
    /// Far above 1e-10, the matrix is defective.
    pub residual: f64,
}

/// Kind of an eigenmode.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum ModeKind {
    /// Eigenvalue zero: a motion without restoring forces, such as common rotation.
    Free,
    /// A real eigenvalue: decay, or growth, without oscillation.
    Aperiodic,
    /// A conjugate pair of eigenvalues.
    Oscillation,
}

impl Mode {
    /// Returns the eigenvalue with nonnegative imaginary part \[1/s\].
    #[must_use]
    pub fn eigenvalue(&self) -> Complex64 {
        Complex64::new(self.real, self.imaginary)
    }

    /// Returns |eigenvalue| \[rad/s\]; for a single oscillator this is the undamped frequency.
    #[must_use]
    pub fn natural_frequency(&self) -> f64 {
        self.eigenvalue().norm()
    }

    /// Returns -Re/|eigenvalue|: 0 for undamped, 1 or -1 for aperiodic, negative for growing
    /// motions; NaN for a free motion.
    #[must_use]
    pub fn damping_ratio(&self) -> f64 {
        -self.real / self.natural_frequency()
    }

    /// Returns whether the motion grows by more than rounding.
    #[must_use]
    pub fn grows(&self) -> bool {
        /// Growth, relative to the frequency of an undamped motion, that counts as rounding.
        const ROUNDING: f64 = 1e-9;
        self.real > ROUNDING * self.natural_frequency()
    }

    /// Returns -1/Re \[s\]: the time in which the motion decays to 1/e; negative if it grows.
    #[must_use]
    pub fn decay_time(&self) -> f64 {
        -1.0 / self.real
    }
}

impl Linearization<'_> {
    /// Returns all eigenmodes: free ones first, then by |eigenvalue|. Each conjugate pair is
    /// represented by the eigenvalue with positive imaginary part.
    ///
    /// States are measured by their scales. Directions of drift, in which nothing depends on the
    /// coordinates, are eigenvectors to eigenvalue zero and are separated first. Otherwise they
    /// would form a defective double zero with the velocity along them, which rounding turns into
    /// eigenvalues of size 1e-8. The rest is balanced and brought to Schur form. Shapes follow by
    /// inverse iteration with the Hessenberg form of the whole matrix. Eigenvalues are improved by
    /// the quotient of left and right eigenvector, w A x/(w x).
    ///
    /// For a large machine whose coordinates each depend on few others, such as a chain, banded
    /// matrices are used instead.
    ///
    /// For a machine with constraints, the matrix is that of the allowed motions in coordinates of
    /// their own; shapes are converted to all coordinates.
    ///
    /// About a steady rotation in coordinates that turn with it, such as the quaternion of a top,
    /// eigenmodes are those seen from a frame that turns with the machine. If several such frames
    /// exist, the one with the least effect on outputs is used.
    ///
    /// # Errors
    /// [`LinearError::Eigenvalues`] if the iteration does not converge, [`LinearError::TooLarge`]
    /// if the machine needs dense matrices and has too many states for them.
    pub fn modes(&self) -> Result<Vec<Mode>, LinearError> {
        if self.simulator.constraints() > 0 {
            require_small(self.simulator)?;
        }
        let motions = Motions::new(self.simulator, &self.matrix);
        if let Some(turns) = turning(self.simulator, &self.point) {
            let within = Within::of(self.simulator, &self.point, &motions);
            let motions = motions.seen_turning(&turns);
            return of_steady_rotation(within.map(Within::seen_turning), motions);
        }
        let within = Within::of(self.simulator, &self.point, &motions);
        if within.is_none()
            && let Some(modes) = of_bands(&motions)
        {
            return Ok(modes);
        }
        require_small(self.simulator)?;
        of_full_matrices(within, motions)
    }
}

/// Computes eigenmodes by dense matrices.
pub(super) fn of_full_matrices(
    within: Option<Within>,
    motions: Motions,
) -> Result<Vec<Mode>, LinearError> {
    let problem = Problem::new(within, motions);
    let (drift, rest) = drift_and_rest(&problem.solved);
    let modes = (0..drift.ncols()).map(|column| problem.drift_mode(&drift, column)).collect();
    let values = problem.eigenvalues(&rest, ZERO)?;
    Ok(with_modes_of(&problem, modes, values))
}

/// Computes eigenmodes in a frame that turns with the machine, where no direction of coordinates
/// alone is a motion.
fn of_steady_rotation(within: Option<Within>, motions: Motions) -> Result<Vec<Mode>, LinearError> {
    let mut problem = Problem::new(within, motions);
    problem.shapes.has_double_zeros = true;
    let n = problem.solved.coordinates;
    let values = problem.eigenvalues(&DMatrix::identity(n, n), DOUBLE_ZERO)?;
    Ok(with_modes_of(&problem, Vec::new(), values))
}

/// Adds the eigenmodes of some eigenvalues.
fn with_modes_of(problem: &Problem, mut modes: Vec<Mode>, mut values: Vec<Complex64>) -> Vec<Mode> {
    values.retain(|value| value.im >= 0.0);
    sort_values(&mut values, |value| *value);
    let mut found: Vec<(Complex64, DVector<Complex64>)> = Vec::new();
    for (number, value) in values.into_iter().enumerate() {
        let (mode, vector) = problem.mode(value, number, &found);
        found.push((value, vector));
        modes.push(mode);
    }
    modes
}

/// Returns H A H with a reflection H.
fn mirrored(matrix: &DMatrix<f64>) -> DMatrix<f64> {
    let size = matrix.nrows();
    let normal = DVector::from_fn(size, |index, _| (1.0 + index as f64).sqrt().cos()).normalize();
    let mirror = DMatrix::identity(size, size) - &normal * normal.transpose() * 2.0;
    &mirror * matrix * &mirror
}

/// Returns the eigenvalues of a matrix.
pub(super) fn eigenvalues(matrix: DMatrix<f64>) -> Result<Vec<Complex64>, LinearError> {
    Ok(balanced_eigenvalues(matrix)?.0)
}

/// Returns the eigenvalues of a matrix, and the norm of the matrix after balancing.
fn balanced_eigenvalues(mut matrix: DMatrix<f64>) -> Result<(Vec<Complex64>, f64), LinearError> {
    if matrix.is_empty() {
        return Ok((Vec::new(), 0.0));
    }
    balance(&mut matrix);
    let norm = matrix.norm();
    // If the iteration cycles, it does not on a similar matrix.
    let iterations = ITERATIONS * matrix.nrows();
    let mirrored = std::iter::successors(Some(matrix), |matrix| Some(mirrored(matrix)));
    let schur =
        mirrored.take(ATTEMPTS).find_map(|matrix| Schur::try_new(matrix, f64::EPSILON, iterations));
    let schur = schur.ok_or(LinearError::Eigenvalues)?;
    Ok((schur.complex_eigenvalues().iter().copied().collect(), norm))
}

/// Computes eigenmodes by banded matrices, if possible.
pub(super) fn of_bands(motions: &Motions) -> Option<Vec<Mode>> {
    let mut found = banded::spectrum(motions)?;
    sort_values(&mut found, |found| found.value);
    let shapes = Shapes::new(motions);
    let mode = |Found { value, right, left }: Found| {
        let shares = shapes.shares(&right, &left);
        shapes.described(value, &right, shares)
    };
    Some(found.into_iter().map(mode).collect())
}

/// Sorts by absolute value, then by real part.
fn sort_values<T>(items: &mut [T], value: impl Fn(&T) -> Complex64) {
    sort_ascending(items, |item| value(item).re);
    sort_ascending(items, |item| value(item).norm());
}

/// A with states measured by their scales, and balanced. Its norm is then that of the fastest
/// motion, and not of its square, so slow motions are found beside fast ones.
struct Problem {
    shapes: Shapes,
    within: Option<Within>,
    /// Motions whose eigenmodes are searched for: all, or those within constraints.
    solved: Motions,
    matrix: DMatrix<f64>,
    /// Scales D of D^-1 A D.
    balance: DVector<f64>,
    /// Balanced matrix D^-1 A D.
    balanced: DMatrix<Complex64>,
    iteration: InverseIteration,
    /// Norm of D^-1 A D.
    norm: f64,
}

impl Problem {
    fn new(within: Option<Within>, motions: Motions) -> Self {
        let shapes = Shapes::new(&motions);
        let solved = match &within {
            Some(within) => within.motions(&motions),
            None => motions,
        };
        let matrix = solved.scaled().full();
        let mut balanced = matrix.clone();
        let balance = if balanced.is_empty() { DVector::zeros(0) } else { balance(&mut balanced) };
        Self {
            shapes,
            within,
            norm: balanced.norm(),
            iteration: InverseIteration::new(&balanced),
            solved,
            matrix,
            balance,
            balanced: balanced.map(Complex64::from),
        }
    }

    /// Converts a right eigenvector of D^-1 A D to one of A, in motions of all coordinates.
    fn right_of_balanced(&self, vector: &DVector<Complex64>) -> DVector<Complex64> {
        self.right(&vector.zip_map(&self.balance, |entry, scale| entry * scale))
    }

    /// Converts a left eigenvector likewise.
    fn left_of_balanced(&self, vector: &DVector<Complex64>) -> DVector<Complex64> {
        self.left(&vector.zip_map(&self.balance, |entry, scale| entry / scale))
    }

    /// Converts a right eigenvector to motions of all coordinates.
    fn right(&self, vector: &DVector<Complex64>) -> DVector<Complex64> {
        match &self.within {
            Some(within) => within.basis().map(Complex64::from) * vector,
            None => vector.clone(),
        }
    }

    /// Converts a left eigenvector likewise.
    fn left(&self, vector: &DVector<Complex64>) -> DVector<Complex64> {
        match &self.within {
            Some(within) => within.dual().transpose().map(Complex64::from) * vector,
            None => vector.clone(),
        }
    }

    /// Returns the eigenvalues except those of drift: of A restricted to the complement of drift,
    /// with orthonormal columns `rest`. Eigenvalues below `zero` times the norm are zero.
    fn eigenvalues(&self, rest: &DMatrix<f64>, zero: f64) -> Result<Vec<Complex64>, LinearError> {
        let (n, size) = (self.solved.coordinates, self.matrix.nrows());
        let kept = rest.ncols();
        let mut basis = DMatrix::zeros(size, kept + size - n);
        basis.view_mut((0, 0), (n, kept)).copy_from(rest);
        basis.view_mut((n, kept), (size - n, size - n)).fill_with_identity();
        let reduced = basis.transpose() * &self.matrix * basis;
        let (values, norm) = balanced_eigenvalues(reduced)?;
        let cleaned = |value: Complex64| {
            if value.norm() <= zero * norm { Complex64::ZERO } else { value }
        };
        Ok(values.into_iter().map(cleaned).collect())
    }

    fn drift_mode(&self, drift: &DMatrix<f64>, column: usize) -> Mode {
        let mut vector = DVector::zeros(self.matrix.nrows());
        for index in 0..self.solved.coordinates {
            vector[index] = Complex64::from(drift[(index, column)]);
        }
        let vector = self.right(&vector);
        let shares = self.shapes.shares(&vector, &vector.conjugate());
        self.shapes.described(Complex64::ZERO, &vector, shares)
    }

    /// Returns the eigenmode of an eigenvalue and its vector of D^-1 A D; `found` contains the
    /// previous ones.
    fn mode(
        &self,
        value: Complex64,
        number: usize,
        found: &[(Complex64, DVector<Complex64>)],
    ) -> (Mode, DVector<Complex64>) {
        let near = |other: &Complex64| (other - value).norm() <= CLUSTER * self.norm;
        let same: Vec<&DVector<Complex64>> =
            found.iter().filter(|(other, _)| near(other)).map(|(_, vector)| vector).collect();
        if value == Complex64::ZERO {
            return self.mode_of_zero(number, &same);
        }
        let [right, left] = self.iteration.vectors(value, number, &same);
        let overlap = left.dot(&right);
        let is_simple = same.is_empty() && overlap.norm() > CLUSTER;
        if is_simple {
            let better = left.dot(&(&self.balanced * &right)) / overlap;
            let value = if value.im == 0.0 { Complex64::from(better.re) } else { better };
            let moved = self.right_of_balanced(&right);
            let shares = self.shapes.shares(&moved, &self.left_of_balanced(&left));
            return (self.shapes.described(value, &moved, shares), right);
        }
        // Left vectors of a repeated eigenvalue do not pair with right ones.
        let moved = self.right_of_balanced(&right);
        let shares = self.shapes.shares(&moved, &moved.conjugate());
        (self.shapes.described(value, &moved, shares), right)
    }
}

impl Problem {
    /// Returns an eigenmode of eigenvalue zero. It uses A itself: its large entries exclude vectors
    /// of motions that belong to a double zero.
    fn mode_of_zero(
        &self,
        number: usize,
        same: &[&DVector<Complex64>],
    ) -> (Mode, DVector<Complex64>) {
        let scaled = |vector: &DVector<Complex64>, back: bool| {
            let scale = |entry: Complex64, scale: f64| {
                if back { entry / scale } else { entry * scale }
            };
            let vector = vector.zip_map(&self.balance, scale);
            let size = vector.norm();
            vector / Complex64::from(size)
        };
        let same: Vec<DVector<Complex64>> =
            same.iter().map(|vector| scaled(vector, false)).collect();
        let same: Vec<&DVector<Complex64>> = same.iter().collect();
        let iteration = InverseIteration::new(&self.matrix);
        let [right, _] = iteration.vectors(Complex64::ZERO, number, &same);
        let moved = self.right(&right);
        let shares = self.shapes.shares(&moved, &moved.conjugate());
        (self.shapes.described(Complex64::ZERO, &moved, shares), scaled(&right, true))
    }
}

/// Data for the description of motions.
struct Shapes {
    coordinates: usize,
    first_order: usize,
    scales: DVector<f64>,
    /// A with states measured by their scales.
    matrix: SparseRows,
    norm: f64,
    /// True if eigenvalue zero may be double, so that A A x is zero instead of A x.
    has_double_zeros: bool,
}

impl Shapes {
    fn new(motions: &Motions) -> Self {
        let matrix = motions.scaled();
        Self {
            coordinates: motions.coordinates,
            first_order: motions.first_order,
            scales: motions.scales.clone(),
            norm: matrix.norm(),
            matrix,
            has_double_zeros: false,
        }
    }

    /// Returns |w_i x_i| of coordinates with their velocities, then of first-order states.
    fn shares(&self, right: &DVector<Complex64>, left: &DVector<Complex64>) -> Vec<f64> {
        let n = self.coordinates;
        let part = |index: usize| (left[index] * right[index]).norm_sqr().sqrt();
        let of_coordinates = (0..n).map(|index| part(index) + part(n + index));
        let of_first_order = (0..self.first_order).map(|index| part(2 * n + index));
        let parts: Vec<f64> = of_coordinates.chain(of_first_order).collect();
        let total: f64 = parts.iter().sum();
        if total > 0.0 { parts.iter().map(|part| part / total).collect() } else { parts }
    }

    fn described(&self, value: Complex64, vector: &DVector<Complex64>, shares: Vec<f64>) -> Mode {
        let kind = if value == Complex64::ZERO {
            ModeKind::Free
        } else if value.im == 0.0 {
            ModeKind::Aperiodic
        } else {
            ModeKind::Oscillation
        };
        let mut distance = self.matrix.times(vector) - vector * value;
        let mut size = self.norm * vector.norm();
        if self.has_double_zeros && kind == ModeKind::Free {
            (distance, size) = (self.matrix.times(&distance), size * self.norm);
        }
        let residual = if size > 0.0 { distance.norm() / size } else { 0.0 };
        let in_units =
            DVector::from_fn(vector.len(), |index, _| vector[index] * self.scales[index]);
        // A motion at constant speed has no own part in the coordinates.
        let leading = self.leading(&shares);
        let is_still =
            in_units[leading].norm() <= f64::EPSILON * in_units[in_units.icamax()].norm();
        let unit = in_units[if is_still { in_units.icamax() } else { leading }];
        let shape = in_units.iter().map(|component| {
            let component = component / unit;
            [component.re, component.im]
        });
        Mode { kind, real: value.re, imaginary: value.im, shape: shape.collect(), shares, residual }
    }

    /// Returns the index of the coordinate or first-order state with the largest share.
    fn leading(&self, shares: &[f64]) -> usize {
        let largest = (0..shares.len()).rev().max_by(|a, b| shares[*a].total_cmp(&shares[*b]));
        let index = largest.unwrap_or(0);
        if index < self.coordinates { index } else { index + self.coordinates }
    }
}

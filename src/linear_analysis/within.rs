//! Small motions within constraints.
//!
//! The emitted accelerations fulfil g'' = 0, so deviations that the constraints allow remain
//! allowed under dy' = A dy. They form a space with coordinates s of positions and u of velocities:
//!
//! ```text
//! dq = N s               N: null space of dg/dq, and of dg'/dv of what holds in modes
//! dv = W s + U u         U: null space of dg'/dv, (dg'/dv) W = -(dg'/dq) N
//! ```
//!
//! A restricted to it has the eigenvalues of the machine, without those that belong to the
//! constraints themselves. Constraints of velocities make s' depend on s through W: a rolling wheel
//! steers, and rolling on a turntable carries along. A constraint of velocities that holds in some
//! modes only, such as sticking friction, fixes its position: that is no direction of motion. A
//! contains the changes of multipliers, and so the geometric stiffness sum lambda d2g/dq2, which a
//! projection of M, D and K of the unconstrained machine would have to add.

use machinist_contract::Simulator;
use nalgebra::{DMatrix, DVector};

use super::Point;
use super::differences::derivative;
use super::equilibrium::split;
use super::motions::Motions;
use crate::constraints::{Constraints, Level};

/// Size of an entry, relative to its terms, below which it is rounding.
const ROUNDING: f64 = 1e-12;

/// Space of deviations that constraints allow; q, q' and z are divided by their scales.
pub(super) struct Within {
    /// N, n by the number of free positions.
    pub positions: DMatrix<f64>,
    /// U, n by the number of free velocities.
    pub velocities: DMatrix<f64>,
    /// T, from \[s, u, z\] to deviations of \[q, q', z\].
    basis: DMatrix<f64>,
    /// L, with L T = 1.
    dual: DMatrix<f64>,
    /// True if there are constraints of velocities.
    steers: bool,
}

impl Within {
    /// Computes the space at a point; `None` if the machine has no constraints.
    pub fn of(simulator: &dyn Simulator<f64>, point: &Point, motions: &Motions) -> Option<Self> {
        let constraints = Constraints::of(simulator, &point.parameters)?;
        let (n, m) = (motions.coordinates, motions.first_order);
        let matrix = constraints.matrix(point.time, &point.state);
        let count = matrix.nrows();
        let holds_positions = |index: &usize| {
            let constraint = simulator.constraint(*index);
            constraint.is_of_positions || constraint.in_modes
        };
        let of_positions: Vec<usize> = (0..count).filter(holds_positions).collect();
        let [of_q, of_v] = [0, n].map(|first| motions.scales.rows(first, n).into_owned());
        let (positions, _) = split(unit_rows(&matrix.select_rows(&of_positions), &of_q).0);
        let (rows, sizes) = unit_rows(&matrix, &of_v);
        let (velocities, _) = split(rows.clone());
        let mut bent = bent(&constraints, point, &positions, &of_q);
        for (mut row, size) in bent.row_iter_mut().zip(&sizes) {
            row /= -size;
        }
        // The shortest W has no component along U.
        let along = rows.svd(true, true).solve(&bent, 1e-10).ok()?;

        let (d, e) = (positions.ncols(), velocities.ncols());
        let mut basis = DMatrix::zeros(2 * n + m, d + e + m);
        basis.view_mut((0, 0), (n, d)).copy_from(&positions);
        basis.view_mut((n, 0), (n, d)).copy_from(&along);
        basis.view_mut((n, d), (n, e)).copy_from(&velocities);
        basis.view_mut((2 * n, d + e), (m, m)).fill_with_identity();
        let mut dual = DMatrix::zeros(d + e + m, 2 * n + m);
        dual.view_mut((0, 0), (d, n)).copy_from(&positions.transpose());
        dual.view_mut((d, n), (e, n)).copy_from(&velocities.transpose());
        dual.view_mut((d + e, 2 * n), (m, m)).fill_with_identity();
        let steers = of_positions.len() < count;
        Some(Self { positions, velocities, basis, dual, steers })
    }

    /// Converts to a frame that turns with the machine, in which N is constant: s' then depends on
    /// s through W.
    pub fn seen_turning(self) -> Self {
        Self { steers: true, ..self }
    }

    /// Returns the equations of \[s, u, z\].
    pub fn motions(&self, whole: &Motions) -> Motions {
        let scaled = whole.scaled().full();
        let mut matrix = &self.dual * &scaled * &self.basis;
        // Terms that cancel except for rounding are zero: no allowed motion changes these rates.
        let terms = self.dual.abs() * scaled.abs() * self.basis.abs();
        let least = f64::EPSILON * scaled.norm();
        matrix.zip_apply(&terms, |value, terms| {
            if value.abs() <= least.max(ROUNDING * terms) {
                *value = 0.0;
            }
        });
        let d = self.positions.ncols();
        if !self.steers {
            // N turns with the positions then, N' = W except along N, and s' = N^T U u.
            matrix.view_mut((0, 0), (d, d)).fill(0.0);
        }
        Motions::alone(&matrix, d, whole.first_order)
    }

    /// Returns the map from \[s, u, z\] to \[q, q', z\] over their scales.
    pub fn basis(&self) -> &DMatrix<f64> {
        &self.basis
    }

    /// Returns the map from \[q, q', z\] over their scales to \[s, u, z\].
    pub fn dual(&self) -> &DMatrix<f64> {
        &self.dual
    }
}

/// Returns dg'/dq N: the change of the constraint matrix along the motion, and the dependence of
/// constraints of velocities on positions, which exists at rest too.
fn bent(
    constraints: &Constraints<'_>,
    point: &Point,
    positions: &DMatrix<f64>,
    scales: &DVector<f64>,
) -> DMatrix<f64> {
    /// Size of differences, relative to the terms of g', that counts as zero.
    const LEFT: f64 = 1e-11;
    let (n, free) = (positions.nrows(), positions.ncols());
    let first = constraints.first(Level::Velocities);
    let rates = |state: &[f64]| constraints.residual(Level::Velocities, point.time, state);
    let matrix = constraints.matrix(point.time, &point.state);
    let velocities = DVector::from_column_slice(&point.state[first..first + n]);
    let terms = matrix.abs() * velocities.abs();
    let mut bent = DMatrix::zeros(matrix.nrows(), free);
    for (column, mut values) in bent.column_iter_mut().enumerate() {
        let found = derivative(1.0, matrix.nrows(), |step| {
            let mut state = point.state.clone();
            let change = positions.column(column).component_mul(scales) * step;
            let moves = constraints.moves(point.time, &point.state, &change);
            state.iter_mut().zip(moves).for_each(|(entry, moved)| *entry += moved);
            rates(&state).as_slice().to_vec()
        });
        let found = found.iter().zip(&terms);
        let found =
            found.map(|(value, terms)| if value.abs() > LEFT * terms { *value } else { 0.0 });
        values.copy_from(&DVector::from_iterator(matrix.nrows(), found));
    }
    bent
}

/// Returns a matrix with columns multiplied by scales and rows then normalized, and the lengths of
/// these rows.
fn unit_rows(matrix: &DMatrix<f64>, scales: &DVector<f64>) -> (DMatrix<f64>, DVector<f64>) {
    let mut rows = DMatrix::from_fn(matrix.nrows(), matrix.ncols(), |row, column| {
        matrix[(row, column)] * scales[column]
    });
    let length = |norm: f64| if norm > 0.0 { norm } else { 1.0 };
    let lengths = DVector::from_iterator(rows.nrows(), rows.row_iter().map(|r| length(r.norm())));
    for (mut row, length) in rows.row_iter_mut().zip(&lengths) {
        row /= *length;
    }
    (rows, lengths)
}

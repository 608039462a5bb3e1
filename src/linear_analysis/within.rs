//! Small motions within constraints.
//!
//! The emitted accelerations fulfil g'' = 0, so that dy' = A dy leaves the deviations that
//! the constraints allow among themselves. These are a space of their own, with coordinates
//! s of positions and u of velocities:
//!
//! ```text
//! dq = N s               N: null space of dg/dq, and of dg'/dv of what holds in modes
//! dv = W s + U u         U: null space of dg'/dv, (dg'/dv) W = -(dg'/dq) N
//! ```
//!
//! A restricted to it has the eigenvalues of the machine, and none that only say that
//! constraints stay fulfilled. W tells that s' depends on s, too, where constraints of velocities
//! do: a wheel that rolls steers, and rolling on a turntable carries along. What a constraint of
//! velocities holds in some modes only, as dry friction that sticks, stays where it is: it is no way of
//! moving. Nothing else is needed: A holds how multipliers change, and so the geometric stiffness sum lambda d2g/dq2, which projecting M, D and K of the machine
//! without constraints would have to add.

use machinist_contract::Simulator;
use nalgebra::{DMatrix, DVector};

use super::Point;
use super::differences::derivative;
use super::equilibrium::split;
use super::motions::Motions;
use crate::constraints::{Constraints, Level};

/// Beside the terms that make it up, an entry below this is rounding.
const ROUNDING: f64 = 1e-12;

/// The space of deviations that constraints allow; q, q' and z divided by their scales.
pub(super) struct Within {
    /// N, n by as many positions as are free.
    pub positions: DMatrix<f64>,
    /// U, n by as many velocities as are free.
    pub velocities: DMatrix<f64>,
    /// T: of \[s, u, z\], deviations of \[q, q', z\].
    basis: DMatrix<f64>,
    /// L, with L T = 1.
    dual: DMatrix<f64>,
    /// Whether there are constraints of velocities.
    steers: bool,
}

impl Within {
    /// At a point; nothing if the machine has no constraints.
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
        // The shortest W; it has nothing of U.
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

    /// Seen from a frame that turns along, in which N stays: s' depends on s as W says.
    pub fn seen_turning(self) -> Self {
        Self { steers: true, ..self }
    }

    /// The motions of \[s, u, z\].
    pub fn motions(&self, whole: &Motions) -> Motions {
        let scaled = whole.scaled().full();
        let mut matrix = &self.dual * &scaled * &self.basis;
        // What cancels but for rounding is nothing: rates that no allowed motion changes.
        let terms = self.dual.abs() * scaled.abs() * self.basis.abs();
        let least = f64::EPSILON * scaled.norm();
        matrix.zip_apply(&terms, |value, terms| {
            if value.abs() <= least.max(ROUNDING * terms) {
                *value = 0.0;
            }
        });
        let d = self.positions.ncols();
        if !self.steers {
            // N turns with the positions then, N' = W but for what is along N, and s' = N^T U u.
            matrix.view_mut((0, 0), (d, d)).fill(0.0);
        }
        Motions::alone(&matrix, d, whole.first_order)
    }

    /// \[q, q', z\] over their scales, of \[s, u, z\].
    pub fn basis(&self) -> &DMatrix<f64> {
        &self.basis
    }

    /// \[s, u, z\] of \[q, q', z\] over their scales.
    pub fn dual(&self) -> &DMatrix<f64> {
        &self.dual
    }
}

/// dg'/dq N: how the matrix of a moving machine's constraints changes, and what a constraint of
/// velocities has of positions, which it has at rest, too.
fn bent(
    constraints: &Constraints<'_>,
    point: &Point,
    positions: &DMatrix<f64>,
    scales: &DVector<f64>,
) -> DMatrix<f64> {
    /// Beside the terms of g', differences leave this much of nothing.
    const LEFT: f64 = 1e-11;
    let (n, free) = (positions.nrows(), positions.ncols());
    let rates = |state: &[f64]| constraints.residual(Level::Velocities, point.time, state);
    let matrix = constraints.matrix(point.time, &point.state);
    let velocities = DVector::from_column_slice(&point.state[n..2 * n]);
    let terms = matrix.abs() * velocities.abs();
    let mut bent = DMatrix::zeros(matrix.nrows(), free);
    for (column, mut values) in bent.column_iter_mut().enumerate() {
        let found = derivative(1.0, matrix.nrows(), |step| {
            let mut state = point.state.clone();
            for index in 0..n {
                state[index] += step * scales[index] * positions[(index, column)];
            }
            rates(&state).as_slice().to_vec()
        });
        let found = found.iter().zip(&terms);
        let found =
            found.map(|(value, terms)| if value.abs() > LEFT * terms { *value } else { 0.0 });
        values.copy_from(&DVector::from_iterator(matrix.nrows(), found));
    }
    bent
}

/// Columns times scales, and then rows divided by their lengths, which come with it.
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

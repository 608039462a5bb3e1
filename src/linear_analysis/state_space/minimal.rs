//! Independent coordinates of a machine with constraints.
//!
//! ```text
//! dq = N s               G_q N = 0, N = 1 in the rows of independent positions s
//! dv = W s + U u         G_v U = 0, U = 1 in the rows of independent velocities u,
//!                        G_v W = -(dg'/dq) N, W = 0 in these rows
//! ```
//!
//! s and u are entries of the state, so x' = L A T x with rows L of the state and T = \[N, 0; W, U\]
//! holds along any motion on the constraints, not only at rest. G_q contains constraints of
//! positions and those of velocities that hold in modes: sticking friction fixes its position.
//! Dependent coordinates are the first pivots of a QR decomposition of G with columns measured by
//! the scales of the velocities, so the matrices of the others are well conditioned.

use machinist_contract::{Dual, DualFunction, Simulator};
use nalgebra::{DMatrix, DVector};

use super::super::differences::derivative;
use super::super::{LinearError, Point, scales};
use crate::constraints::{Constraints, Level};

/// Size of a pivot, for rows of length 1, below which a constraint follows from others.
const RANK: f64 = 1e-10;
/// Size of an entry, relative to its terms, below which it is rounding.
const ROUNDING: f64 = 1e-13;

/// Independent entries of the state.
pub(super) struct Minimal {
    /// x, as entries of the state.
    pub states: Vec<usize>,
    /// Entries that constraints determine.
    dependent: Vec<usize>,
    /// T, from x to the whole state; `None` if there are no constraints.
    basis: Option<DMatrix<f64>>,
}

impl Minimal {
    /// Selects independent entries of the state at a point, without modes.
    pub fn of(simulator: &dyn Simulator<f64>, point: &Point) -> Result<Self, LinearError> {
        let states = point.state.len();
        let moving: Vec<usize> = (0..states).filter(|index| !simulator.is_mode(*index)).collect();
        let Some(constraints) = Constraints::of(simulator, &point.parameters) else {
            return Ok(Self { states: moving, dependent: Vec::new(), basis: None });
        };
        let n = simulator.shape().coordinates;
        if simulator.shape().positions != n {
            return Err(LinearError::Singular {
                what: "the state of orientations within constraints",
            });
        }
        let matrix = constraints.matrix(point.time, &point.state);
        let sizes = scales(simulator).rows(n, n).into_owned();
        let holds_positions = |row: &usize| {
            let constraint = simulator.constraint(*row);
            constraint.is_of_positions || constraint.in_modes
        };
        let of_positions: Vec<usize> = (0..matrix.nrows()).filter(holds_positions).collect();
        let positions = Split::of(&matrix.select_rows(&of_positions), &sizes);
        let velocities = Split::of(&matrix, &sizes);
        let bent = bent(simulator, &constraints, point, &positions.basis);
        let along = velocities.shift(&-bent)?;

        let (d, e) = (positions.free.len(), velocities.free.len());
        let first_order: Vec<usize> =
            moving.iter().copied().filter(|index| *index >= 2 * n).collect();
        let mut basis = DMatrix::zeros(states, d + e + first_order.len());
        basis.view_mut((0, 0), (n, d)).copy_from(&positions.basis);
        basis.view_mut((n, 0), (n, d)).copy_from(&along);
        basis.view_mut((n, d), (n, e)).copy_from(&velocities.basis);
        for (column, row) in first_order.iter().enumerate() {
            basis[(*row, d + e + column)] = 1.0;
        }
        let of_velocities = velocities.free.iter().map(|index| n + index);
        let kept = positions.free.iter().copied().chain(of_velocities).chain(first_order);
        let states: Vec<usize> = kept.collect();
        let dependent = moving.into_iter().filter(|index| !states.contains(index)).collect();
        Ok(Self { states, dependent, basis: Some(basis) })
    }

    /// Returns L A T.
    pub fn reduced(&self, jacobian: &DMatrix<f64>) -> DMatrix<f64> {
        match &self.basis {
            None => jacobian.select_rows(&self.states).select_columns(&self.states),
            Some(basis) => product(&jacobian.select_rows(&self.states), basis),
        }
    }

    /// Returns C T.
    pub fn seen(&self, by_state: &DMatrix<f64>) -> DMatrix<f64> {
        match &self.basis {
            None => by_state.select_columns(&self.states),
            Some(basis) => product(by_state, basis),
        }
    }

    /// Returns the names of the states that constraints determine.
    pub fn eliminated(&self, simulator: &dyn Simulator<f64>) -> Vec<String> {
        self.dependent.iter().map(|index| simulator.state(*index).name.to_owned()).collect()
    }
}

/// Returns a product in which sums that cancel except for rounding are zero.
fn product(left: &DMatrix<f64>, right: &DMatrix<f64>) -> DMatrix<f64> {
    let mut product = left * right;
    product.zip_apply(&(left.abs() * right.abs()), |value, terms| {
        if value.abs() <= ROUNDING * terms {
            *value = 0.0;
        }
    });
    product
}

/// Coordinates separated by the rows of G into dependent and free ones.
struct Split {
    /// Free coordinates, ascending.
    free: Vec<usize>,
    /// Motions of all coordinates, one column for each free one.
    basis: DMatrix<f64>,
    /// Dependent coordinates, in the order of the pivots.
    dependent: Vec<usize>,
    /// Sizes by which G is measured: rows, then columns.
    rows: DVector<f64>,
    columns: DVector<f64>,
    /// Q of the independent rows, and R of the dependent columns.
    q: DMatrix<f64>,
    r: DMatrix<f64>,
}

impl Split {
    fn of(matrix: &DMatrix<f64>, columns: &DVector<f64>) -> Self {
        let (m, n) = matrix.shape();
        let mut scaled =
            DMatrix::from_fn(m, n, |row, column| matrix[(row, column)] * columns[column]);
        let rows = DVector::from_iterator(m, scaled.row_iter().map(|row| row.norm()));
        for (mut row, size) in scaled.row_iter_mut().zip(&rows) {
            if *size > 0.0 {
                row /= *size;
            }
        }
        let qr = scaled.col_piv_qr();
        let (q, r) = (qr.q(), qr.r());
        let rank = (0..m.min(n)).take_while(|index| r[(*index, *index)].abs() > RANK).count();
        let mut order = DMatrix::from_fn(1, n, |_, column| column as f64);
        qr.p().permute_columns(&mut order);
        let order: Vec<usize> = order.iter().map(|column| *column as usize).collect();
        let (dependent, others) = order.split_at(rank);
        let upper = r.view((0, 0), (rank, rank)).into_owned();
        let beside = r.view((0, rank), (rank, n - rank)).into_owned();
        let follow = solved(&upper, -beside);
        let mut free = others.to_vec();
        free.sort_unstable();
        let mut basis = DMatrix::zeros(n, free.len());
        for (place, coordinate) in others.iter().enumerate() {
            let column = free.partition_point(|other| other < coordinate);
            basis[(*coordinate, column)] = 1.0;
            for (row, dependent) in dependent.iter().enumerate() {
                basis[(*dependent, column)] =
                    follow[(row, place)] * columns[*dependent] / columns[*coordinate];
            }
        }
        Self {
            free,
            basis,
            dependent: dependent.to_vec(),
            rows,
            columns: columns.clone(),
            q: q.columns(0, rank).into_owned(),
            r: upper,
        }
    }

    /// Returns the motion of dependent coordinates alone with G dv = `rates`, for each column.
    fn shift(&self, rates: &DMatrix<f64>) -> Result<DMatrix<f64>, LinearError> {
        let mut rates = rates.clone();
        for (mut row, size) in rates.row_iter_mut().zip(&self.rows) {
            row /= if *size > 0.0 { *size } else { 1.0 };
        }
        let found = solved(&self.r, self.q.transpose() * rates);
        if found.iter().any(|value| !value.is_finite()) {
            return Err(LinearError::Singular { what: "the matrix of the constraints" });
        }
        let mut whole = DMatrix::zeros(self.columns.len(), found.ncols());
        for (row, coordinate) in self.dependent.iter().enumerate() {
            whole.row_mut(*coordinate).copy_from(&(found.row(row) * self.columns[*coordinate]));
        }
        Ok(whole)
    }
}

/// Solves R x = b for an upper triangle R without zeros on its diagonal.
fn solved(upper: &DMatrix<f64>, mut right_side: DMatrix<f64>) -> DMatrix<f64> {
    if upper.is_empty() {
        return right_side;
    }
    // False only for a zero on the diagonal, which the rank excludes.
    let _ = upper.solve_upper_triangular_mut(&mut right_side);
    right_side
}

/// Returns (dg'/dq) N: the change of velocities that the constraints ask for along the motion.
fn bent(
    simulator: &dyn Simulator<f64>,
    constraints: &Constraints<'_>,
    point: &Point,
    positions: &DMatrix<f64>,
) -> DMatrix<f64> {
    let (n, free) = positions.shape();
    let count = simulator.constraints();
    let matrix = constraints.matrix(point.time, &point.state);
    let mut bent = DMatrix::zeros(count, free);
    for column in 0..free {
        let along = positions.column(column);
        let found = match simulator.derivatives() {
            Some(duals) => {
                let constants =
                    |values: &[f64]| values.iter().copied().map(Dual::constant).collect::<Vec<_>>();
                let (mut state, parameters) =
                    (constants(&point.state), constants(&point.parameters));
                state[..n].iter_mut().zip(along.iter()).for_each(|(q, by)| q.slopes[0] = *by);
                let mut values = vec![Dual::constant(0.0); count];
                let time = Dual::constant(point.time);
                let function = DualFunction::ConstraintRates;
                duals.on_duals(function, time, &state, &parameters, &mut values);
                values.iter().map(|value| value.slopes[0]).collect()
            }
            None => derivative(size_of(simulator, along.as_slice()), count, |step| {
                let mut state = point.state.clone();
                state[..n].iter_mut().zip(along.iter()).for_each(|(q, by)| *q += step * by);
                let rates = constraints.residual(Level::Velocities, point.time, &state);
                rates.as_slice().to_vec()
            }),
        };
        bent.column_mut(column).copy_from_slice(&found);
    }
    // A constraint that does not hold in these modes asks for nothing.
    for (row, entries) in matrix.row_iter().enumerate() {
        if entries.iter().all(|entry| *entry == 0.0) {
            bent.row_mut(row).fill(0.0);
        }
    }
    bent
}

/// Returns the step along a motion that moves a position by its scale and no other by more.
fn size_of(simulator: &dyn Simulator<f64>, along: &[f64]) -> f64 {
    let scales = scales(simulator);
    let steps = along.iter().zip(&scales).filter(|(by, _)| **by != 0.0);
    let least = steps.map(|(by, scale)| scale / by.abs()).fold(f64::INFINITY, f64::min);
    if least.is_finite() { least } else { 1.0 }
}

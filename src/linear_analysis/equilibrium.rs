//! Equilibrium: rest, or motion at constant speed.

use machinist_contract::Simulator;
use nalgebra::{DMatrix, DVector};

use super::banded;
use super::motions::{Motions, Places};
use super::search::{ACCEPTED, Balance, Equations, newton};
use super::sparse_rows::SparseRows;
use super::{LinearError, Point, Residual, full, jacobian, rate};
use crate::sorting::sort_descending;

/// Change of rates, relative to the sizes of their rows, below which a direction counts as drift.
/// The limit is at rounding, so that a soft spring beside stiff ones is not neglected.
pub(super) const DRIFT: f64 = 1e-13;

/// Finds the equilibrium near a guess by Newton's method, with emitted rates and Jacobian. Time and
/// parameters are those of the guess.
///
/// An equilibrium is a state in which accelerations q'' and first-order rates z' are zero and
/// remain so:
///
/// ```text
/// q''(q, q', z) = 0      z'(q, q', z) = 0      [dq''/dq; dz'/dq] q' = 0
/// ```
///
/// The last equation allows drift of coordinates along directions on which nothing depends, such as
/// the common rotation of a shaft: a machine at constant speed is in equilibrium. All other
/// velocities are zero. Along drift directions the equations do not determine coordinates, which
/// stay those of the guess: each step is the smallest one that solves the linearized equations,
/// with states measured by their scales. A step is halved until the rates decrease.
///
/// A machine with constraints moves as they allow, and is projected onto them after each step. A
/// machine driven by a moving constraint has no equilibrium.
///
/// # Errors
/// [`LinearError::NoEquilibrium`] with the remaining rates, and the errors of
/// [`super::Linearization::at`].
pub fn equilibrium(simulator: &dyn Simulator<f64>, guess: &Point) -> Result<Point, LinearError> {
    if simulator.constraints() > 0 {
        let (balance, point) = super::rest::Solver::new(simulator, guess, &[])?;
        return newton(&balance, point);
    }
    let (balance, point) = Solver::new(simulator, guess, &[])?;
    newton(&balance, point)
}

/// Search for a machine without constraints.
pub(super) struct Solver<'a> {
    simulator: &'a dyn Simulator<f64>,
    /// Indices of the states that are to move least.
    named: &'a [usize],
    /// Indices of positions in the state.
    positions: Vec<usize>,
    /// Number of coordinates n and of first-order states m.
    coordinates: usize,
    first_order: usize,
    /// Indices of q' and of \[q', z\] in the state.
    velocities: Vec<usize>,
    dynamic: Vec<usize>,
    /// Drift directions, n by k, orthonormal in q divided by its scales.
    drift: DMatrix<f64>,
}

/// Motions at a point, and the sizes of the rows of [q'', z'].
pub(super) struct Frame {
    motions: Motions,
    row_sizes: DVector<f64>,
}

impl<'a> Solver<'a> {
    /// Returns a search and its start: the guess without velocities across drift.
    pub(super) fn new(
        simulator: &'a dyn Simulator<f64>,
        guess: &Point,
        named: &'a [usize],
    ) -> Result<(Self, Point), LinearError> {
        let places = Places::of(simulator);
        let coordinates = places.velocities.len();
        let mut solver = Self {
            simulator,
            named,
            coordinates,
            positions: places.positions.clone(),
            first_order: places.first_order.len(),
            dynamic: places.dynamic(),
            velocities: places.velocities,
            drift: DMatrix::zeros(coordinates, 0),
        };
        solver.drift = solver.drift_directions(guess)?;
        let point = solver.with_drift_only(guess)?;
        Ok((solver, point))
    }

    /// Returns the directions in which no rate depends on the coordinates: at the guess and at two
    /// points nearby, so that a slope that happens to be zero does not count.
    fn drift_directions(&self, guess: &Point) -> Result<DMatrix<f64>, LinearError> {
        let (n, rows) = (self.coordinates, self.coordinates + self.first_order);
        let at_guess = self.motions(guess)?;
        let mut stacked = SparseRows::new(n);
        for shift in [0.0, 0.0137, -0.0071] {
            let mut point = guess.clone();
            let size = |index: usize| at_guess.scales[index] * (1.0 + index as f64).sqrt();
            let change =
                DVector::from_fn(
                    n + rows,
                    |index, _| {
                        if index < n { shift * size(index) } else { 0.0 }
                    },
                );
            at_guess.add(&mut point.state, &change);
            for row in slopes(&self.motions(&point)?).iter() {
                stacked.push(row.iter().copied().filter(|(column, _)| *column < n));
            }
        }
        match banded::drift(&stacked) {
            Some(drift) => Ok(drift),
            None => Ok(split(full(self.simulator, &stacked)?).0),
        }
    }

    fn motions(&self, point: &Point) -> Result<Motions, LinearError> {
        Ok(Motions::new(self.simulator, &jacobian(self.simulator, point)?))
    }

    /// Returns q' divided by the scales of q.
    fn velocity(&self, point: &Point, motions: &Motions) -> DVector<f64> {
        let scaled = |i: usize| point.state[self.velocities[i]] / motions.scales[i];
        DVector::from_fn(self.coordinates, |i, _| scaled(i))
    }

    /// Returns the guess without velocities across drift.
    fn with_drift_only(&self, guess: &Point) -> Result<Point, LinearError> {
        let motions = self.motions(guess)?;
        let mut point = guess.clone();
        let drift = &self.drift * (self.drift.transpose() * self.velocity(guess, &motions));
        for (index, place) in self.velocities.iter().enumerate() {
            point.state[*place] = drift[index] * motions.scales[index];
        }
        Ok(point)
    }

    fn residual(&self, point: &Point, row_sizes: &DVector<f64>) -> DVector<f64> {
        let rates = rate(self.simulator, point);
        rates.select_rows(&self.dynamic).component_div(row_sizes)
    }
}

impl Balance for Solver<'_> {
    type Frame = Frame;

    fn simulator(&self) -> &dyn Simulator<f64> {
        self.simulator
    }

    fn equations(&self, point: &Point) -> Result<Equations<Frame>, LinearError> {
        let n = self.coordinates;
        let motions = self.motions(point)?;
        let row_sizes = row_sizes(&motions);
        let residual = self.residual(point, &row_sizes);
        if let Some(index) = residual.iter().position(|value| !value.is_finite()) {
            let what = format!("the rate of `{}`", self.simulator.state(self.dynamic[index]).name);
            return Err(LinearError::NotFinite { what, value: residual[index] });
        }
        let scales = &motions.scales;
        let (k, m) = (self.drift.ncols(), self.first_order);
        let mut jacobian = SparseRows::new(n + k + m);
        for row in slopes(&motions).iter() {
            let of_coordinates = row.iter().copied().filter(|(column, _)| *column < n);
            // Velocities move along drift only: q' = scale * drift * s.
            let of_velocities = row.iter().filter(|(column, _)| (n..2 * n).contains(column));
            let mut of_drift = vec![0.0; k];
            for (column, slope) in of_velocities {
                let by_velocity = slope / scales[*column] * scales[column - n];
                for (sum, drift) in of_drift.iter_mut().zip(&self.drift.row(column - n)) {
                    *sum += by_velocity * drift;
                }
            }
            let of_drift = of_drift.into_iter().enumerate().map(|(index, sum)| (n + index, sum));
            let of_first_order = row.iter().filter(|(column, _)| *column >= 2 * n);
            let of_first_order = of_first_order.map(|(column, slope)| (column + k - n, *slope));
            jacobian.push(of_coordinates.chain(of_drift).chain(of_first_order));
        }
        Ok(Equations { frame: Frame { motions, row_sizes }, residual, jacobian })
    }

    fn length_at(&self, point: &Point, frame: &Frame) -> Result<f64, LinearError> {
        Ok(self.residual(point, &frame.row_sizes).norm())
    }

    fn unfolded(&self, Frame { motions, .. }: &Frame, step: &DVector<f64>) -> DVector<f64> {
        let (n, k, m) = (self.coordinates, self.drift.ncols(), self.first_order);
        let velocity = &self.drift * step.rows(n, k);
        let change = DVector::from_fn(2 * n + m, |index, _| match index {
            index if index < n => motions.scales[index] * step[index],
            index if index < 2 * n => motions.scales[index - n] * velocity[index - n],
            index => motions.scales[index] * step[index + k - n],
        });
        let mut unfolded = DVector::zeros(self.simulator.shape().states());
        motions.add(unfolded.as_mut_slice(), &change);
        unfolded
    }

    fn measured(&self, frame: &Frame, rates: &DVector<f64>) -> DVector<f64> {
        rates.select_rows(&self.dynamic).component_div(&frame.row_sizes)
    }

    fn keep_drift(&self, Frame { motions, .. }: &Frame, change: &mut DVector<f64>) {
        let scales = &motions.scales;
        let speeds = self.velocities.iter().enumerate();
        let speeds = speeds.map(|(index, place)| change[*place] / scales[index]);
        let speeds = DVector::from_iterator(self.coordinates, speeds);
        let drift = &self.drift * (self.drift.transpose() * speeds);
        for (index, place) in self.velocities.iter().enumerate() {
            change[*place] = drift[index] * scales[index];
        }
    }

    fn moved(
        &self,
        point: &Point,
        frame: &Frame,
        step: &DVector<f64>,
    ) -> Result<Point, LinearError> {
        let mut next = point.clone();
        for (value, change) in next.state.iter_mut().zip(&self.unfolded(frame, step)) {
            *value += change;
        }
        Ok(next)
    }

    fn named(&self, Frame { motions, .. }: &Frame) -> DMatrix<f64> {
        let (n, k) = (self.coordinates, self.drift.ncols());
        let scales = &motions.scales;
        let mut named = DMatrix::zeros(self.named.len(), n + k + self.first_order);
        for (mut row, entry) in named.row_iter_mut().zip(self.named) {
            let scale = self.simulator.state_scale(*entry);
            if let Some(place) = self.positions.iter().position(|at| at == entry) {
                for (column, share) in motions.positions_by_coordinates().row(place) {
                    row[*column] = share * scales[*column] / scale;
                }
            } else if let Some(place) = self.velocities.iter().position(|at| at == entry) {
                row.columns_mut(n, k).copy_from(&(self.drift.row(place) * scales[place] / scale));
            }
        }
        named
    }

    fn creep(&self, Frame { motions, row_sizes }: &Frame) -> (DMatrix<f64>, usize) {
        let (n, k, m) = (self.coordinates, self.drift.ncols(), self.first_order);
        let mut across = DMatrix::identity(n, n);
        if !may_meet_something(self.simulator) {
            across -= &self.drift * self.drift.transpose();
        }
        let mut matrix = DMatrix::zeros(n + m, n + k + m);
        matrix.view_mut((0, 0), (n, n)).copy_from(&across);
        matrix.view_mut((0, n), (n, k)).copy_from(&self.drift);
        matrix.view_mut((n, n + k), (m, m)).fill_with_identity();
        for (index, mut row) in matrix.row_iter_mut().enumerate() {
            let scale = motions.scales[if index < n { index } else { n + index }];
            row *= scale / row_sizes[index];
        }
        (matrix, n)
    }

    fn accepted(&self, point: Point) -> Result<Point, LinearError> {
        let equations = self.equations(&point)?;
        let drift = self.velocity(&point, &equations.frame.motions);
        let drift = drift.resize_vertically(equations.jacobian.columns(), 0.0);
        let change = equations.jacobian.times(&drift);
        let still = if change.is_empty() { 0.0 } else { change.amax() };
        if equations.size() <= ACCEPTED && still <= ACCEPTED {
            return Ok(point);
        }
        let worst = |index: &usize| equations.residual[*index].abs().max(change[*index].abs());
        let mut order: Vec<usize> = (0..equations.residual.len()).collect();
        sort_descending(&mut order, worst);
        let residual = |index: usize| {
            let state = self.simulator.state(self.dynamic[index]);
            let rate = equations.residual[index] * equations.frame.row_sizes[index];
            Residual { state: state.name.to_owned(), unit: state.unit.to_owned(), rate }
        };
        Err(LinearError::NoEquilibrium {
            scene: self.simulator.name().to_owned(),
            time: point.time,
            residuals: order.into_iter().map(residual).collect(),
        })
    }
}

/// Returns whether directions of drift may end elsewhere, as at a stop.
pub(super) fn may_meet_something(simulator: &dyn Simulator<f64>) -> bool {
    simulator.events() + simulator.kinks() > 0
}

/// Returns the sizes of the rows of [q'', z']: the change of the rate when every state moves by its
/// scale. If nothing changes the rate, it is the scale of the state per second.
pub(super) fn row_sizes(motions: &Motions) -> DVector<f64> {
    let Motions { matrix, scales, coordinates: from, .. } = motions;
    let size = |row: usize| {
        let squares =
            matrix.row(row).iter().map(|(column, entry)| (entry * scales[*column]).powi(2));
        let square: f64 = squares.sum();
        if square > 0.0 { square.sqrt() } else { scales[row] }
    };
    DVector::from_fn(matrix.rows() - from, |row, _| size(from + row))
}

/// Returns the rows of [q'', z'] of A, with motions measured by scales and rows by sizes.
pub(super) fn slopes(motions: &Motions) -> SparseRows {
    let Motions { matrix, scales, coordinates: from, .. } = motions;
    let sizes = row_sizes(motions);
    let mut slopes = SparseRows::new(matrix.columns());
    for (row, size) in sizes.iter().enumerate() {
        let entries = matrix.row(from + row).iter();
        slopes.push(entries.map(|(column, entry)| (*column, entry * scales[*column] / size)));
    }
    slopes
}

/// Returns drift directions at one point and their complement, both orthonormal in q divided by its
/// scales.
pub(super) fn drift_and_rest(motions: &Motions) -> (DMatrix<f64>, DMatrix<f64>) {
    split(by_positions(motions))
}

/// Returns the derivatives of [q', q'', z'] by q, measured as by [`slopes`]: q' depends on q with
/// constraints of velocities, such as those of wheels that steer.
pub(super) fn by_positions(motions: &Motions) -> DMatrix<f64> {
    let n = motions.coordinates;
    let mut all = slopes(motions).full().columns(0, n).into_owned().insert_rows(0, n, 0.0);
    for row in 0..n {
        let entries = motions.matrix.row(row).iter();
        let scaled = entries.map(|(column, entry)| (*column, entry * motions.scales[*column]));
        let scaled: Vec<(usize, f64)> = scaled.collect();
        let size = scaled.iter().map(|(_, entry)| entry * entry).sum::<f64>().sqrt();
        for (column, entry) in scaled.into_iter().filter(|(column, _)| *column < n) {
            all[(row, column)] = entry / size;
        }
    }
    all
}

/// Returns the null space of a matrix and its orthogonal complement, as columns.
pub(super) fn split(matrix: DMatrix<f64>) -> (DMatrix<f64>, DMatrix<f64>) {
    let columns = matrix.ncols();
    if columns == 0 {
        return (DMatrix::zeros(0, 0), DMatrix::zeros(0, 0));
    }
    // Rows of zeros make as many singular values as columns.
    let rows = matrix.nrows().max(columns);
    let svd = matrix.resize(rows, columns, 0.0).svd(false, true);
    let Some(directions) = svd.v_t else {
        return (DMatrix::zeros(columns, 0), DMatrix::identity(columns, columns));
    };
    let choose = |wanted: bool| {
        let is_wanted = |index: &usize| (svd.singular_values[*index] <= DRIFT) == wanted;
        let chosen: Vec<usize> = (0..columns).filter(is_wanted).collect();
        directions.select_rows(&chosen).transpose()
    };
    (choose(true), choose(false))
}

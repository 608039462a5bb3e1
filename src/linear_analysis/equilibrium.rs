//! Rest, and running at constant speed.

use machinist_contract::Simulator;
use nalgebra::{DMatrix, DVector};

use super::motions::{Motions, Places};
use super::{LinearError, Point, Residual, jacobian, rate};

pub(super) const MAX_ITERATIONS: usize = 100;
pub(super) const MAX_HALVINGS: usize = 40;
/// Relative to the size of its row, a rate below this is zero.
pub(super) const ACCEPTED: f64 = 1e-9;
/// Below this nothing is left to gain.
pub(super) const ROUNDING: f64 = 1e-15;
/// Singular values below this, of matrices with rows of length 1, count as zero.
pub(super) const RANK: f64 = 1e-10;
/// Directions in which rates change by less than that, over the sizes of their rows, are of
/// drift: what rounding makes of nothing, and no soft spring beside stiff ones.
const DRIFT: f64 = 1e-13;

/// The equilibrium near a guess, by Newton's method on the emitted rates and
/// their emitted Jacobian; time and parameters are those of the guess.
///
/// An equilibrium is a state in which accelerations q'' and first-order rates z'
/// are zero, and stay so:
///
/// ```text
/// q''(q, q', z) = 0      z'(q, q', z) = 0      [dq''/dq; dz'/dq] q' = 0
/// ```
///
/// The last equation lets coordinates drift along directions in which nothing
/// depends on them, such as the common rotation of a shaft: a machine at constant
/// speed is in equilibrium. All other velocities are zero. Along drift directions
/// coordinates are not determined by the equations and stay those of the guess:
/// each step is the least one that solves the linearized equations, with states
/// measured by their scales. A step is halved until the rates shrink.
///
/// A machine with constraints moves as they allow, and is put back onto them after each
/// step; one that a moving constraint drives is in no equilibrium.
///
/// # Errors
/// [`LinearError::NoEquilibrium`] with the rates that remain, and the errors of
/// [`super::Linearization::at`].
pub fn equilibrium(simulator: &dyn Simulator<f64>, guess: &Point) -> Result<Point, LinearError> {
    if simulator.constraints() > 0 {
        return super::rest::equilibrium(simulator, guess);
    }
    let solver = Solver::new(simulator, guess)?;
    let mut point = solver.with_drift_only(guess)?;
    for _ in 0..MAX_ITERATIONS {
        let equations = solver.equations(&point)?;
        if equations.residual.amax() <= ROUNDING {
            break;
        }
        match solver.shrinking_step(&point, &equations)? {
            Some(next) => point = next,
            None => break,
        }
    }
    solver.accepted(point)
}

struct Solver<'a> {
    simulator: &'a dyn Simulator<f64>,
    /// n and m.
    coordinates: usize,
    first_order: usize,
    /// Where the state holds q', and where \[q', z\].
    velocities: Vec<usize>,
    dynamic: Vec<usize>,
    /// Directions of drift, n by k, orthonormal once q is divided by its scales.
    drift: DMatrix<f64>,
}

/// [q'', z'] at a point, each divided by the size of its row.
struct Equations {
    motions: Motions,
    residual: DVector<f64>,
    jacobian: DMatrix<f64>,
    row_sizes: DVector<f64>,
}

impl<'a> Solver<'a> {
    fn new(simulator: &'a dyn Simulator<f64>, guess: &Point) -> Result<Self, LinearError> {
        let places = Places::of(simulator);
        let coordinates = places.velocities.len();
        let mut solver = Self {
            simulator,
            coordinates,
            first_order: places.first_order.len(),
            dynamic: places.dynamic(),
            velocities: places.velocities,
            drift: DMatrix::zeros(coordinates, 0),
        };
        solver.drift = solver.drift_directions(guess)?;
        Ok(solver)
    }

    /// Directions in which no rate depends on the coordinates: at the guess, and at
    /// two places nearby, so that a slope that happens to be level is not one.
    fn drift_directions(&self, guess: &Point) -> Result<DMatrix<f64>, LinearError> {
        let (n, rows) = (self.coordinates, self.coordinates + self.first_order);
        let at_guess = self.motions(guess)?;
        let mut stacked = DMatrix::zeros(3 * rows, n);
        for (place, shift) in [0.0, 0.0137, -0.0071].into_iter().enumerate() {
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
            let slopes = slopes(&self.motions(&point)?);
            stacked.view_mut((place * rows, 0), (rows, n)).copy_from(&slopes.columns(0, n));
        }
        Ok(split(stacked).0)
    }

    fn motions(&self, point: &Point) -> Result<Motions, LinearError> {
        Ok(Motions::new(self.simulator, &jacobian(self.simulator, point)?))
    }

    /// q' divided by the scales of q.
    fn velocity(&self, point: &Point, motions: &Motions) -> DVector<f64> {
        let scaled = |i: usize| point.state[self.velocities[i]] / motions.scales[i];
        DVector::from_fn(self.coordinates, |i, _| scaled(i))
    }

    /// The guess without velocities that are no drift.
    fn with_drift_only(&self, guess: &Point) -> Result<Point, LinearError> {
        let motions = self.motions(guess)?;
        let mut point = guess.clone();
        let drift = &self.drift * (self.drift.transpose() * self.velocity(guess, &motions));
        for (index, place) in self.velocities.iter().enumerate() {
            point.state[*place] = drift[index] * motions.scales[index];
        }
        Ok(point)
    }

    fn equations(&self, point: &Point) -> Result<Equations, LinearError> {
        let n = self.coordinates;
        let motions = self.motions(point)?;
        let row_sizes = row_sizes(&motions);
        let residual = self.residual(point, &row_sizes);
        if let Some(index) = residual.iter().position(|value| !value.is_finite()) {
            let what = format!("the rate of `{}`", self.simulator.state(self.dynamic[index]).name);
            return Err(LinearError::NotFinite { what, value: residual[index] });
        }
        let slopes = slopes(&motions);
        let scales = &motions.scales;
        // Velocities move along the drift only: q' = scale * drift * s.
        let by_velocity = DMatrix::from_fn(slopes.nrows(), n, |row, column| {
            slopes[(row, n + column)] / scales[n + column] * scales[column]
        });
        let (k, m) = (self.drift.ncols(), self.first_order);
        let mut jacobian = DMatrix::zeros(n + m, n + k + m);
        jacobian.columns_mut(0, n).copy_from(&slopes.columns(0, n));
        jacobian.columns_mut(n, k).copy_from(&(by_velocity * &self.drift));
        jacobian.columns_mut(n + k, m).copy_from(&slopes.columns(2 * n, m));
        Ok(Equations { motions, residual, jacobian, row_sizes })
    }

    fn residual(&self, point: &Point, row_sizes: &DVector<f64>) -> DVector<f64> {
        let rates = rate(self.simulator, point);
        rates.select_rows(&self.dynamic).component_div(row_sizes)
    }

    /// The point after the longest of the steps 1, 1/2, 1/4, ... that shrinks the
    /// rates; nothing if none does.
    fn shrinking_step(
        &self,
        point: &Point,
        equations: &Equations,
    ) -> Result<Option<Point>, LinearError> {
        let singular = LinearError::Singular { what: "the Jacobian of the equilibrium" };
        let jacobian = equations.jacobian.clone();
        let svd = jacobian.try_svd(true, true, f64::EPSILON, 10_000).ok_or(singular.clone())?;
        let step = svd.solve(&-&equations.residual, RANK).map_err(|_| singular)?;
        let size = equations.residual.norm();
        let mut share = 1.0;
        for _ in 0..MAX_HALVINGS {
            let next = self.moved(point, &equations.motions, &(&step * share));
            // NaN is no less.
            if self.residual(&next, &equations.row_sizes).norm() < size {
                return Ok(Some(next));
            }
            share /= 2.0;
        }
        Ok(None)
    }

    fn moved(&self, point: &Point, motions: &Motions, step: &DVector<f64>) -> Point {
        let (n, k, m) = (self.coordinates, self.drift.ncols(), self.first_order);
        let velocity = &self.drift * step.rows(n, k);
        let change = DVector::from_fn(2 * n + m, |index, _| match index {
            index if index < n => motions.scales[index] * step[index],
            index if index < 2 * n => motions.scales[index - n] * velocity[index - n],
            index => motions.scales[index] * step[index + k - n],
        });
        let mut next = point.clone();
        motions.add(&mut next.state, &change);
        next
    }

    /// The point, if rates are zero there and drift leaves them so.
    fn accepted(&self, point: Point) -> Result<Point, LinearError> {
        let n = self.coordinates;
        let equations = self.equations(&point)?;
        let drift = self.velocity(&point, &equations.motions);
        let change = equations.jacobian.columns(0, n) * drift;
        if equations.residual.amax() <= ACCEPTED && change.amax() <= ACCEPTED {
            return Ok(point);
        }
        let worst = |index: &usize| equations.residual[*index].abs().max(change[*index].abs());
        let mut order: Vec<usize> = (0..equations.residual.len()).collect();
        order.sort_by(|a, b| worst(b).total_cmp(&worst(a)));
        let residual = |index: usize| {
            let state = self.simulator.state(self.dynamic[index]);
            let rate = equations.residual[index] * equations.row_sizes[index];
            Residual { state: state.name.to_owned(), unit: state.unit.to_owned(), rate }
        };
        Err(LinearError::NoEquilibrium {
            scene: self.simulator.name().to_owned(),
            time: point.time,
            residuals: order.into_iter().map(residual).collect(),
        })
    }
}

/// Sizes of the rows of [q'', z']: what the rate changes by when every state moves
/// by its scale; where nothing moves it, the scale of its state a second.
pub(super) fn row_sizes(motions: &Motions) -> DVector<f64> {
    let Motions { matrix, scales, coordinates: from, .. } = motions;
    let size = |row: usize| {
        let moved = matrix.row(row).transpose().component_mul(scales).norm();
        if moved > 0.0 { moved } else { scales[row] }
    };
    DVector::from_fn(matrix.nrows() - from, |row, _| size(from + row))
}

/// Rows of [q'', z'] of A with motions measured by scales and rows by sizes.
pub(super) fn slopes(motions: &Motions) -> DMatrix<f64> {
    let Motions { matrix, scales, coordinates: from, .. } = motions;
    let sizes = row_sizes(motions);
    DMatrix::from_fn(matrix.nrows() - from, matrix.ncols(), |row, column| {
        matrix[(from + row, column)] * scales[column] / sizes[row]
    })
}

/// Drift directions at one point, and those across, both orthonormal in q divided
/// by its scales.
pub(super) fn drift_and_rest(motions: &Motions) -> (DMatrix<f64>, DMatrix<f64>) {
    split(slopes(motions).columns(0, motions.coordinates).into_owned())
}

/// The null space of a matrix and its orthogonal complement, as columns.
pub(super) fn split(matrix: DMatrix<f64>) -> (DMatrix<f64>, DMatrix<f64>) {
    let columns = matrix.ncols();
    if columns == 0 {
        return (DMatrix::zeros(0, 0), DMatrix::zeros(0, 0));
    }
    // Rows of zeros so that there are as many singular values as columns.
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

//! Rest, and running at constant speed, within constraints.

use machinist_contract::Simulator;
use nalgebra::{DMatrix, DVector};

use super::equilibrium::{
    ACCEPTED, MAX_HALVINGS, MAX_ITERATIONS, RANK, ROUNDING, row_sizes, slopes, split,
};
use super::motions::{Motions, Places};
use super::within::Within;
use super::{LinearError, Point, Residual, jacobian, rate};
use crate::constraints::{Constraints, Level, Lost};

/// As [`super::equilibrium`], for machines with constraints.
pub(super) fn equilibrium(
    simulator: &dyn Simulator<f64>,
    guess: &Point,
) -> Result<Point, LinearError> {
    let solver = Solver::new(simulator, guess)?;
    let mut point = solver.with_drift_only(guess)?;
    for _ in 0..MAX_ITERATIONS {
        let equations = solver.equations(&point)?;
        if equations.size() <= ROUNDING {
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
    places: Places,
    /// Directions in which nothing depends on the coordinates, n by k, of q over its scales.
    drift: DMatrix<f64>,
}

/// [u', z'] at a point, each divided by the size of its row.
struct Equations {
    frame: Frame,
    residual: DVector<f64>,
    /// By [s, speeds of drift, z].
    jacobian: DMatrix<f64>,
}

/// What moves at a point, and how.
struct Frame {
    whole: Motions,
    within: Within,
    /// Of [s, u, z].
    free: Motions,
}

impl Equations {
    fn size(&self) -> f64 {
        if self.residual.is_empty() { 0.0 } else { self.residual.amax() }
    }
}

impl<'a> Solver<'a> {
    fn new(simulator: &'a dyn Simulator<f64>, guess: &Point) -> Result<Self, LinearError> {
        let places = Places::of(simulator);
        let drift = DMatrix::zeros(places.velocities.len(), 0);
        let mut solver = Self { simulator, places, drift };
        solver.drift = solver.drift_directions(guess)?;
        Ok(solver)
    }

    fn frame(&self, point: &Point) -> Result<Frame, LinearError> {
        let whole = Motions::new(self.simulator, &jacobian(self.simulator, point)?);
        let singular = LinearError::Singular { what: "the matrix of the constraints" };
        let within = Within::of(self.simulator, point, &whole).ok_or(singular)?;
        let free = within.motions(&whole);
        Ok(Frame { whole, within, free })
    }

    /// Directions that are allowed, and in which no rate depends on the coordinates: at the
    /// guess, and at two places nearby, so that a slope that happens to be level is not one.
    fn drift_directions(&self, guess: &Point) -> Result<DMatrix<f64>, LinearError> {
        let frame = self.frame(guess)?;
        let (n, free) = (frame.whole.coordinates, frame.free.coordinates);
        let mut rows: Vec<DMatrix<f64>> = Vec::new();
        for shift in [0.0, 0.0137, -0.0071] {
            let step = DVector::from_fn(free, |index, _| shift * (1.0 + index as f64).sqrt());
            let point = self.moved(guess, &frame, &step, None)?;
            let Frame { within, free, .. } = self.frame(&point)?;
            let allowed = within.positions.transpose();
            rows.push(slopes(&free).columns(0, free.coordinates) * &allowed);
            rows.push(DMatrix::identity(n, n) - &within.positions * allowed);
        }
        let mut stacked = DMatrix::zeros(rows.iter().map(DMatrix::nrows).sum(), n);
        let mut first = 0;
        for part in rows {
            stacked.rows_mut(first, part.nrows()).copy_from(&part);
            first += part.nrows();
        }
        Ok(split(stacked).0)
    }

    /// The guess without velocities that are no drift.
    fn with_drift_only(&self, guess: &Point) -> Result<Point, LinearError> {
        let mut point = guess.clone();
        let n = self.places.velocities.len();
        let scales = self.frame(guess)?.whole.scales;
        let speed = DVector::from_fn(n, |i, _| point.state[n + i] / scales[i]);
        let drift = &self.drift * (self.drift.transpose() * speed);
        for index in 0..n {
            point.state[n + index] = drift[index] * scales[index];
        }
        self.require_still(&point)?;
        Ok(point)
    }

    /// Refuses constraints that move by themselves.
    fn require_still(&self, point: &Point) -> Result<(), LinearError> {
        let Some(constraints) = Constraints::of(self.simulator, &point.parameters) else {
            return Ok(());
        };
        let rates = constraints.residual(Level::Velocities, point.time, &point.state);
        let matrix = constraints.matrix(point.time, &point.state);
        let off = constraints.relative(Level::Velocities, &matrix, &rates, &point.state);
        let moving =
            (0..rates.len()).filter(|index| off[*index].is_nan() || off[*index] > ACCEPTED);
        let residual = |index: usize| {
            let constraint = self.simulator.constraint(index);
            let (state, unit) = (constraint.name.to_owned(), constraint.unit.to_owned());
            Residual { state, unit, rate: rates[index] }
        };
        let residuals: Vec<Residual> = moving.map(residual).collect();
        if residuals.is_empty() { Ok(()) } else { Err(self.none(point, residuals)) }
    }

    fn equations(&self, point: &Point) -> Result<Equations, LinearError> {
        let frame = self.frame(point)?;
        let (n, d) = (frame.whole.coordinates, frame.free.coordinates);
        let (m, k) = (frame.free.first_order, self.drift.ncols());
        let e = frame.within.velocities.ncols();
        let slopes = slopes(&frame.free);
        let scales = &frame.whole.scales;
        let drift = DMatrix::from_fn(n, k, |row, column| {
            self.drift[(row, column)] * scales[row] / scales[n + row]
        });
        let by_speed = slopes.columns(d, e) * frame.within.velocities.transpose() * drift;
        let mut jacobian = DMatrix::zeros(e + m, d + k + m);
        jacobian.columns_mut(0, d).copy_from(&slopes.columns(0, d));
        jacobian.columns_mut(d, k).copy_from(&by_speed);
        jacobian.columns_mut(d + k, m).copy_from(&slopes.columns(d + e, m));
        let residual = self.residual(point, &frame);
        match residual.iter().find(|value| !value.is_finite()) {
            None => Ok(Equations { frame, residual, jacobian }),
            Some(value) => {
                let what = format!("a rate of `{}`", self.simulator.name());
                Err(LinearError::NotFinite { what, value: *value })
            }
        }
    }

    fn residual(&self, point: &Point, frame: &Frame) -> DVector<f64> {
        let n = frame.whole.coordinates;
        let rates = rate(self.simulator, point).select_rows(&self.places.dynamic());
        let scales = frame.whole.scales.rows(n, rates.len());
        let rates = rates.component_div(&scales);
        let dual = frame.within.dual();
        let first = frame.free.coordinates;
        let dynamic = dual.view((first, n), (dual.nrows() - first, rates.len())) * rates;
        dynamic.component_div(&row_sizes(&frame.free))
    }

    /// The point after the longest of the steps 1, 1/2, 1/4, ... that shrinks the rates;
    /// nothing if none does.
    fn shrinking_step(
        &self,
        point: &Point,
        equations: &Equations,
    ) -> Result<Option<Point>, LinearError> {
        let singular = LinearError::Singular { what: "the Jacobian of the equilibrium" };
        let jacobian = equations.jacobian.clone();
        let svd = jacobian.try_svd(true, true, f64::EPSILON, 10_000).ok_or(singular.clone())?;
        let step = svd.solve(&-&equations.residual, RANK).map_err(|_| singular)?;
        let Equations { frame, residual, .. } = equations;
        let d = frame.free.coordinates;
        let rest = step.rows(d, step.len() - d).into_owned();
        let mut share = 1.0;
        for _ in 0..MAX_HALVINGS {
            let positions = step.rows(0, d) * share;
            let next = self.moved(point, frame, &positions, Some(&(&rest * share)));
            // NaN is no less, and what does not come back is too far.
            if let Ok(next) = next
                && self.residual(&next, &self.frame(&next)?).norm() < residual.norm()
            {
                return Ok(Some(next));
            }
            share /= 2.0;
        }
        Ok(None)
    }

    /// The point with s and [speeds of drift, z] changed, back on the constraints.
    fn moved(
        &self,
        point: &Point,
        frame: &Frame,
        positions: &DVector<f64>,
        rest: Option<&DVector<f64>>,
    ) -> Result<Point, LinearError> {
        let (n, k) = (frame.whole.coordinates, self.drift.ncols());
        let scales = &frame.whole.scales;
        let mut next = point.clone();
        let change = &frame.within.positions * positions;
        for index in 0..n {
            next.state[index] += scales[index] * change[index];
        }
        if let Some(rest) = rest {
            let speeds = &self.drift * rest.rows(0, k);
            for index in 0..n {
                next.state[n + index] += scales[index] * speeds[index];
            }
            for (number, place) in self.places.first_order.iter().enumerate() {
                next.state[*place] += scales[2 * n + number] * rest[k + number];
            }
        }
        let constraints = Constraints::of(self.simulator, &next.parameters);
        let lost = constraints.and_then(|constraints| {
            let levels = [Level::Positions, Level::Velocities];
            let put = |level| constraints.put_back(level, next.time, &mut next.state);
            levels.into_iter().try_for_each(put).err()
        });
        match lost {
            None => Ok(next),
            Some(Lost(index)) => Err(LinearError::Lost {
                scene: self.simulator.name().to_owned(),
                constraint: self.simulator.constraint(index).name.to_owned(),
            }),
        }
    }

    /// The point, if rates are zero there.
    fn accepted(&self, point: Point) -> Result<Point, LinearError> {
        if self.equations(&point)?.size() <= ACCEPTED {
            return Ok(point);
        }
        let dynamic = self.places.dynamic();
        let rates = rate(self.simulator, &point);
        let scale = |index: usize| rates[index].abs() / self.simulator.state_scale(index);
        let mut order = dynamic;
        order.sort_by(|a, b| scale(*b).total_cmp(&scale(*a)));
        let residual = |index: usize| {
            let state = self.simulator.state(index);
            let (name, unit) = (state.name.to_owned(), state.unit.to_owned());
            Residual { state: name, unit, rate: rates[index] }
        };
        Err(self.none(&point, order.into_iter().map(residual).collect()))
    }

    fn none(&self, point: &Point, residuals: Vec<Residual>) -> LinearError {
        let scene = self.simulator.name().to_owned();
        LinearError::NoEquilibrium { scene, time: point.time, residuals }
    }
}

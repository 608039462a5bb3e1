//! Equilibrium within constraints.

use machinist_contract::Simulator;
use nalgebra::{DMatrix, DVector};

use super::equilibrium::{by_positions, may_meet_something, row_sizes, slopes, split};
use super::motions::{Motions, Places};
use super::search::{ACCEPTED, Balance, Equations};
use super::sparse_rows::SparseRows;
use super::within::Within;
use super::{LinearError, Point, Residual, jacobian, rate, require_small};
use crate::constraints::{Constraints, Level, Lost};
use crate::sorting::sort_descending;

/// Search for a machine with constraints.
pub(super) struct Solver<'a> {
    simulator: &'a dyn Simulator<f64>,
    /// Indices of the states that are to move least.
    named: &'a [usize],
    places: Places,
    /// Drift directions, n by k, in q over its scales.
    drift: DMatrix<f64>,
}

/// Motions at a point.
pub(super) struct Frame {
    whole: Motions,
    within: Within,
    /// Equations of [s, u, z].
    free: Motions,
}

impl<'a> Solver<'a> {
    /// Returns a search and its start: the guess without velocities across drift.
    pub(super) fn new(
        simulator: &'a dyn Simulator<f64>,
        guess: &Point,
        named: &'a [usize],
    ) -> Result<(Self, Point), LinearError> {
        require_small(simulator)?;
        let places = Places::of(simulator);
        let drift = DMatrix::zeros(places.velocities.len(), 0);
        let mut solver = Self { simulator, named, places, drift };
        solver.drift = solver.drift_directions(guess)?;
        let point = solver.with_drift_only(guess)?;
        Ok((solver, point))
    }

    fn frame(&self, point: &Point) -> Result<Frame, LinearError> {
        let whole = Motions::new(self.simulator, &jacobian(self.simulator, point)?);
        let singular = LinearError::Singular { what: "the matrix of the constraints" };
        let within = Within::of(self.simulator, point, &whole).ok_or(singular)?;
        let free = within.motions(&whole);
        Ok(Frame { whole, within, free })
    }

    /// Returns the directions that constraints allow, as moves and as velocities, and in which no
    /// rate depends on the coordinates: at the guess and at two points nearby, so that a slope that
    /// happens to be zero does not count.
    fn drift_directions(&self, guess: &Point) -> Result<DMatrix<f64>, LinearError> {
        let frame = self.frame(guess)?;
        let (n, free) = (frame.whole.coordinates, frame.free.coordinates);
        let mut rows: Vec<DMatrix<f64>> = Vec::new();
        for shift in [0.0, 0.0137, -0.0071] {
            let step = DVector::from_fn(free, |index, _| shift * (1.0 + index as f64).sqrt());
            let point = self.moved_by(guess, &frame, &step, None)?;
            let Frame { within, free, whole } = self.frame(&point)?;
            let allowed = within.positions.transpose();
            let mut speeds =
                DMatrix::identity(n, n) - &within.velocities * within.velocities.transpose();
            for (index, mut column) in speeds.column_iter_mut().enumerate() {
                column *= whole.scales[index] / whole.scales[n + index];
            }
            rows.push(speeds);
            rows.push(by_positions(&free) * &allowed);
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

    /// Returns the guess without velocities across drift.
    fn with_drift_only(&self, guess: &Point) -> Result<Point, LinearError> {
        let mut point = guess.clone();
        let n = self.places.velocities.len();
        let velocities = &self.places.velocities;
        let scales = self.frame(guess)?.whole.scales;
        let speed = DVector::from_fn(n, |i, _| point.state[velocities[i]] / scales[i]);
        let drift = &self.drift * (self.drift.transpose() * speed);
        for index in 0..n {
            point.state[velocities[index]] = drift[index] * scales[index];
        }
        self.require_still(&point)?;
        Ok(point)
    }

    /// Refuses constraints that prescribe a motion.
    fn require_still(&self, point: &Point) -> Result<(), LinearError> {
        let Some(constraints) = Constraints::of(self.simulator, &point.parameters) else {
            return Ok(());
        };
        let rates = constraints.residual(Level::Velocities, point.time, &point.state);
        let slopes = constraints.slopes(point.time, &point.state);
        let off = constraints.relative(Level::Velocities, &slopes, &rates, &point.state);
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

    fn residual(&self, point: &Point, frame: &Frame) -> DVector<f64> {
        self.measured(frame, &rate(self.simulator, point))
    }

    /// Returns the point with s and [speeds of drift, z] changed, projected onto the constraints.
    fn moved_by(
        &self,
        point: &Point,
        frame: &Frame,
        positions: &DVector<f64>,
        rest: Option<&DVector<f64>>,
    ) -> Result<Point, LinearError> {
        let (n, k) = (frame.whole.coordinates, self.drift.ncols());
        let scales = &frame.whole.scales;
        let mut next = point.clone();
        let change = (&frame.within.positions * positions).component_mul(&scales.rows(0, n));
        let moves = frame.whole.positions_by_coordinates().times(&change);
        for (place, moved) in self.places.positions.iter().zip(moves.iter()) {
            next.state[*place] += moved;
        }
        if let Some(rest) = rest {
            let speeds = &self.drift * rest.rows(0, k);
            for index in 0..n {
                next.state[self.places.velocities[index]] += scales[index] * speeds[index];
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
            Some(Lost(index)) => Err(LinearError::OffConstraint {
                scene: self.simulator.name().to_owned(),
                constraint: self.simulator.constraint(index).name.to_owned(),
            }),
        }
    }

    fn none(&self, point: &Point, residuals: Vec<Residual>) -> LinearError {
        let scene = self.simulator.name().to_owned();
        LinearError::NoEquilibrium { scene, time: point.time, residuals }
    }
}

impl Balance for Solver<'_> {
    type Frame = Frame;

    fn simulator(&self) -> &dyn Simulator<f64> {
        self.simulator
    }

    fn equations(&self, point: &Point) -> Result<Equations<Frame>, LinearError> {
        let frame = self.frame(point)?;
        let (n, d) = (frame.whole.coordinates, frame.free.coordinates);
        let (m, k) = (frame.free.first_order, self.drift.ncols());
        let e = frame.within.velocities.ncols();
        let slopes = slopes(&frame.free).full();
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
            None => Ok(Equations { frame, residual, jacobian: SparseRows::of(&jacobian) }),
            Some(value) => {
                let what = format!("a rate of `{}`", self.simulator.name());
                Err(LinearError::NotFinite { what, value: *value })
            }
        }
    }

    fn measured(&self, frame: &Frame, rates: &DVector<f64>) -> DVector<f64> {
        let n = frame.whole.coordinates;
        let rates = rates.select_rows(&self.places.dynamic());
        let scales = frame.whole.scales.rows(n, rates.len());
        let rates = rates.component_div(&scales);
        let dual = frame.within.dual();
        let first = frame.free.coordinates;
        let dynamic = dual.view((first, n), (dual.nrows() - first, rates.len())) * rates;
        dynamic.component_div(&row_sizes(&frame.free))
    }

    fn unfolded(&self, frame: &Frame, step: &DVector<f64>) -> DVector<f64> {
        let (n, d, k) = (frame.whole.coordinates, frame.free.coordinates, self.drift.ncols());
        let (e, m) = (frame.within.velocities.ncols(), frame.free.first_order);
        let scales = &frame.whole.scales;
        let mut speeds = &self.drift * step.rows(d, k);
        for (index, mut speed) in speeds.row_iter_mut().enumerate() {
            speed *= scales[index] / scales[n + index];
        }
        let mut free = DVector::zeros(d + e + m);
        free.rows_mut(0, d).copy_from(&step.rows(0, d));
        free.rows_mut(d, e).copy_from(&(frame.within.velocities.transpose() * speeds));
        free.rows_mut(d + e, m).copy_from(&step.rows(d + k, m));
        let motions = (frame.within.basis() * free).component_mul(scales);
        let mut unfolded = DVector::zeros(self.simulator.shape().states());
        let moves = motions.rows(0, n).into_owned();
        let moved = frame.whole.positions_by_coordinates().times(&moves);
        for (place, change) in self.places.positions.iter().zip(moved.iter()) {
            unfolded[*place] = *change;
        }
        for (place, change) in self.places.velocities.iter().zip(motions.rows(n, n).iter()) {
            unfolded[*place] = *change;
        }
        for (place, change) in self.places.first_order.iter().zip(motions.rows(2 * n, m).iter()) {
            unfolded[*place] = *change;
        }
        unfolded
    }

    fn keep_drift(&self, frame: &Frame, change: &mut DVector<f64>) {
        let (n, scales) = (frame.whole.coordinates, &frame.whole.scales);
        let velocities = &self.places.velocities;
        let speeds = DVector::from_fn(n, |index, _| change[velocities[index]] / scales[index]);
        let drift = &self.drift * (self.drift.transpose() * speeds);
        for index in 0..n {
            change[velocities[index]] = drift[index] * scales[index];
        }
    }

    fn length_at(&self, point: &Point, _: &Frame) -> Result<f64, LinearError> {
        Ok(self.residual(point, &self.frame(point)?).norm())
    }

    fn moved(
        &self,
        point: &Point,
        frame: &Frame,
        step: &DVector<f64>,
    ) -> Result<Point, LinearError> {
        let d = frame.free.coordinates;
        let [positions, rest] = [step.rows(0, d), step.rows(d, step.len() - d)];
        self.moved_by(point, frame, &positions.into_owned(), Some(&rest.into_owned()))
    }

    fn named(&self, frame: &Frame) -> DMatrix<f64> {
        let (n, d) = (frame.whole.coordinates, frame.free.coordinates);
        let (k, scales) = (self.drift.ncols(), &frame.whole.scales);
        let mut named = DMatrix::zeros(self.named.len(), d + k + frame.free.first_order);
        for (mut row, entry) in named.row_iter_mut().zip(self.named) {
            let own = |places: &[usize]| places.iter().position(|place| place == entry);
            if let Some(place) = own(&self.places.positions) {
                let scale = self.simulator.state_scale(*entry);
                for (column, share) in frame.whole.positions_by_coordinates().row(place) {
                    let share = share * scales[*column] / scale;
                    let mut part = row.columns_mut(0, d);
                    part += frame.within.positions.row(*column) * share;
                }
            } else if let Some(number) = own(&self.places.velocities) {
                let share = scales[number] / scales[n + number];
                row.columns_mut(d, k).copy_from(&(self.drift.row(number) * share));
            }
        }
        named
    }

    fn creep(&self, frame: &Frame) -> (DMatrix<f64>, usize) {
        let Frame { whole, within, free } = frame;
        let (n, d) = (whole.coordinates, free.coordinates);
        let (k, m, e) = (self.drift.ncols(), free.first_order, within.velocities.ncols());
        let mut across = within.positions.clone();
        if !may_meet_something(self.simulator) {
            across -= &self.drift * (self.drift.transpose() * &within.positions);
        }
        let mut onto = within.velocities.transpose();
        for (index, mut column) in onto.column_iter_mut().enumerate() {
            column *= whole.scales[index] / whole.scales[n + index];
        }
        let mut matrix = DMatrix::zeros(e + m, d + k + m);
        matrix.view_mut((0, 0), (e, d)).copy_from(&(&onto * across));
        matrix.view_mut((0, d), (e, k)).copy_from(&(&onto * &self.drift));
        matrix.view_mut((e, d + k), (m, m)).fill_with_identity();
        for (mut row, size) in matrix.row_iter_mut().zip(&row_sizes(free)) {
            row /= *size;
        }
        (matrix, d)
    }

    fn accepted(&self, point: Point) -> Result<Point, LinearError> {
        if self.equations(&point)?.size() <= ACCEPTED {
            return Ok(point);
        }
        let dynamic = self.places.dynamic();
        let rates = rate(self.simulator, &point);
        let scale = |index: usize| rates[index].abs() / self.simulator.state_scale(index);
        let mut order = dynamic;
        sort_descending(&mut order, |index| scale(*index));
        let residual = |index: usize| {
            let state = self.simulator.state(index);
            let (name, unit) = (state.name.to_owned(), state.unit.to_owned());
            Residual { state: name, unit, rate: rates[index] }
        };
        Err(self.none(&point, order.into_iter().map(residual).collect()))
    }
}

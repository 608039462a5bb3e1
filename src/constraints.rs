//! Constraints at run time: residuals, projection and mobility.
//!
//! The emitted accelerations fulfil G q'' = gamma, so an exact motion that starts on its
//! constraints stays on them. A computed one drifts off by the error of its steps. It is projected
//! back after each step: by the shortest move in the norm of the mass matrix, first in position,
//! then in velocity. A move dq of a machine with quaternions is a small rotation about each axis,
//! by which the quaternion turns.
//!
//! ```text
//! M dq + G^T mu = 0,  G dq = -g      until g vanishes but for rounding
//! M dv + G^T nu = 0,  G dv = -g'     likewise
//! ```

mod energy;
mod lasting;
mod mobility;
mod prescribed;
mod saddle;
mod start;

use std::cell::{Cell, RefCell};

use machinist_contract::Simulator;
use nalgebra::{DMatrix, DVector};

use crate::held::Held;
pub use crate::trajectory::Drift;
pub(crate) use energy::EnergyLevel;
pub use lasting::{Lasting, lasting};

pub use mobility::{Mobility, Redundant, mobility};
use saddle::Saddle;
pub use start::start;
pub(crate) use start::{consistent, free_moves, require_independent};

/// Number of coordinates and constraints from which on the matrix of a projection is factored as a
/// sparse one.
const MANY: usize = 48;

/// Size of a row of G, relative to the largest, that counts as rounding.
const ROUNDING: f64 = 1e-14;

/// Constraints of a simulator at given parameters.
pub struct Constraints<'a> {
    simulator: &'a dyn Simulator<f64>,
    /// Parameters and slots, with relations as a run holds them, or live.
    parameters: Held,
    coordinates: usize,
    count: usize,
    drift: Cell<Drift>,
    sparse: RefCell<Sparse>,
}

/// Sparse matrix of a projection.
enum Sparse {
    NotYet,
    Here(Box<Saddle>),
    /// Not used: rows are few, some hold only in modes, or rows had to be exchanged.
    Never,
}

/// Index of the first constraint onto which projection fails.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Lost(pub usize);

/// Level of constraints: positions or velocities.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Level {
    /// g(q, t) = 0.
    Positions,
    /// g'(q, q', t) = 0.
    Velocities,
}

impl<'a> Constraints<'a> {
    /// Returns the constraints of a simulator, with live relations; `None` if it has none.
    #[must_use]
    pub fn of(simulator: &'a dyn Simulator<f64>, parameters: &[f64]) -> Option<Self> {
        Self::held(simulator, &Held::live(simulator, parameters))
    }

    /// Returns the same with relations as a run holds them.
    pub(crate) fn held(simulator: &'a dyn Simulator<f64>, parameters: &Held) -> Option<Self> {
        let (count, coordinates) = (simulator.constraints(), simulator.shape().coordinates);
        if count == 0 {
            return None;
        }
        let drift = Cell::default();
        let found = Self {
            simulator,
            parameters: parameters.clone(),
            coordinates,
            count,
            drift,
            sparse: RefCell::new(Sparse::NotYet),
        };
        if coordinates + count < MANY || found.holds_in_modes() {
            found.sparse.replace(Sparse::Never);
        }
        Some(found)
    }

    /// Returns the largest drift so far.
    pub(crate) fn drift(&self) -> Drift {
        self.drift.get()
    }

    /// Projects a state of a run onto the constraints.
    ///
    /// # Errors
    /// [`Lost`] if the projection fails.
    pub(crate) fn project(&self, time: f64, state: &mut [f64]) -> Result<(), Lost> {
        let states = self.simulator.shape().states();
        let state = &mut state[..states];
        let before = self.size(time, state);
        self.put_back(Level::Positions, time, state)?;
        self.put_back(Level::Velocities, time, state)?;
        let after = self.size(time, state);
        let Drift { before: worst, after: left } = self.drift.get();
        self.drift.set(Drift { before: worst.max(before), after: left.max(after) });
        Ok(())
    }

    /// Projects one level by Newton's iteration along the shortest way, as long as residuals
    /// decrease.
    ///
    /// # Errors
    /// [`Lost`] if the projection fails.
    pub fn put_back(&self, level: Level, time: f64, state: &mut [f64]) -> Result<(), Lost> {
        self.put_back_but(&[], level, time, state)
    }

    /// Projects like [`Constraints::put_back`], ignoring some rows.
    fn put_back_but(
        &self,
        without: &[usize],
        level: Level,
        time: f64,
        state: &mut [f64],
    ) -> Result<(), Lost> {
        const ROUNDS: usize = 10;
        const ROUNDING: f64 = 1e-12;
        let pattern = self.simulator.constraint_matrix_pattern().entries;
        let linear = |state: &[f64]| {
            let mut slopes = self.slopes(time, state);
            let mut residual = self.residual(level, time, state);
            for row in without {
                let entries = pattern.iter().zip(&mut slopes);
                let of_row = entries.filter(|((of, _), _)| *of as usize == *row);
                of_row.for_each(|(_, slope)| *slope = 0.0);
                residual[*row] = 0.0;
            }
            (slopes, residual)
        };
        let (mut slopes, mut residual) = linear(state);
        let mut off = self.relative(level, &slopes, &residual, state);
        for _ in 0..ROUNDS {
            if off.iter().all(|off| *off <= 4.0 * f64::EPSILON) {
                return Ok(());
            }
            let Some(shift) = self.shortest(time, state, &slopes, &residual) else { break };
            let kept = state.to_vec();
            self.shift(level, time, state, &(-shift));
            (slopes, residual) = linear(state);
            let now = self.relative(level, &slopes, &residual, state);
            let is_nearer = largest_of(&now) < largest_of(&off);
            if !is_nearer {
                state.copy_from_slice(&kept);
                break;
            }
            off = now;
        }
        // The remaining residual is either rounding or a failure.
        match off.iter().position(|off| off.is_nan() || *off > ROUNDING) {
            None => Ok(()),
            Some(constraint) => Err(Lost(constraint)),
        }
    }

    /// Adds a change of one level to a state. Only the first n entries of `change` count.
    pub(crate) fn shift(&self, level: Level, time: f64, state: &mut [f64], change: &DVector<f64>) {
        let first = self.first(level);
        let add = |state: &[f64], share: f64, moves: &[f64]| {
            let mut moved = state.to_vec();
            for (entry, moves) in moved[first..].iter_mut().zip(moves) {
                *entry += share * moves;
            }
            moved
        };
        if level == Level::Velocities || self.simulator.shape().positions == self.coordinates {
            let moved = add(state, 1.0, &change.as_slice()[..self.coordinates]);
            state.copy_from_slice(&moved);
            return;
        }
        // Along the rotation, by one step of the method of Kutta, so that quaternions keep their
        // magnitude.
        let moves = |state: &[f64]| self.moves(time, state, change);
        let one = moves(state);
        let two = moves(&add(state, 0.5, &one));
        let three = moves(&add(state, 0.5, &two));
        let four = moves(&add(state, 1.0, &three));
        let parts = one.iter().zip(&two).zip(&three).zip(&four);
        let whole: Vec<f64> = parts.map(|(((a, b), c), d)| (a + 2.0 * (b + c) + d) / 6.0).collect();
        let moved = add(state, 1.0, &whole);
        state.copy_from_slice(&moved);
    }

    /// Returns the change of all positions with a move of the coordinates. With a quaternion, there
    /// is one position more than velocities. Rates of positions are linear in velocities, so the
    /// change is their difference between velocities of this size and none.
    pub(crate) fn moves(&self, time: f64, state: &[f64], change: &DVector<f64>) -> Vec<f64> {
        let positions = self.simulator.shape().positions;
        if positions == self.coordinates {
            return change.as_slice()[..positions].to_vec();
        }
        let rates = |velocities: &dyn Fn(usize) -> f64| {
            let mut there = state.to_vec();
            for index in 0..self.coordinates {
                there[positions + index] = velocities(index);
            }
            let mut rate = vec![0.0; state.len()];
            self.simulator.rate(time, &there, &self.parameters.all(), &mut rate);
            rate
        };
        let (moving, resting) = (rates(&|index| change[index]), rates(&|_| 0.0));
        (0..positions).map(|index| moving[index] - resting[index]).collect()
    }

    /// Returns dq of M dq + G^T mu = 0, G dq = r.
    fn shortest(
        &self,
        time: f64,
        state: &[f64],
        slopes: &[f64],
        residual: &DVector<f64>,
    ) -> Option<DVector<f64>> {
        let (n, m) = (self.coordinates, self.count);
        let mut right_side = DVector::zeros(n + m);
        right_side.rows_mut(n, m).copy_from(residual);
        let solution = match self.shortest_sparse(time, state, slopes, right_side.as_slice()) {
            Some(solution) => DVector::from_vec(solution),
            None => self.saddle(time, state, &self.filled(slopes)).lu().solve(&right_side)?,
        };
        solution.iter().all(|value| value.is_finite()).then_some(solution)
    }

    /// Does the same with the sparse matrix, if that is worthwhile and stable.
    fn shortest_sparse(
        &self,
        time: f64,
        state: &[f64],
        slopes: &[f64],
        right_side: &[f64],
    ) -> Option<Vec<f64>> {
        let mut sparse = self.sparse.borrow_mut();
        let mass = self.simulator.mass_matrix_pattern().entries;
        let matrix = self.simulator.constraint_matrix_pattern().entries;
        if matches!(*sparse, Sparse::NotYet) {
            let saddle = Saddle::new([self.coordinates, self.count], mass, matrix);
            *sparse = Sparse::Here(Box::new(saddle));
        }
        let Sparse::Here(saddle) = &mut *sparse else { return None };
        let mut values = vec![0.0; mass.len()];
        self.simulator.mass_matrix(time, state, &self.parameters.all(), &mut values);
        if !saddle.factor(mass.iter().zip(&values), matrix.iter().zip(slopes)) {
            *sparse = Sparse::Never;
            return None;
        }
        Some(saddle.solve(right_side))
    }

    /// Does the same as [`Constraints::shortest`] for several residuals: with n rows and one column
    /// for each of them. `residuals` contains them row by row.
    pub(crate) fn shortest_each(
        &self,
        time: f64,
        state: &[f64],
        residuals: &[Vec<f64>],
    ) -> Option<DMatrix<f64>> {
        let n = self.coordinates;
        let columns = residuals.first()?.len();
        let mut right_side = DMatrix::zeros(n + self.count, columns);
        for (row, residuals) in residuals.iter().enumerate() {
            for (column, residual) in residuals.iter().enumerate() {
                right_side[(n + row, column)] = *residual;
            }
        }
        let matrix = self.matrix(time, state);
        let solution = self.saddle(time, state, &matrix).lu().solve(&right_side)?;
        let is_finite = solution.iter().all(|value| value.is_finite());
        is_finite.then(|| solution.rows(0, n).into_owned())
    }

    /// Returns the share of each constraint in the impulse that changes velocities by `moved`, G^T
    /// nu = -M dv; zeros if the shares are not determined.
    pub(crate) fn shares_of_impulse(&self, time: f64, state: &[f64], moved: &[f64]) -> Vec<f64> {
        let (n, m) = (self.coordinates, self.count);
        let matrix = self.matrix(time, state);
        let mut right_side = DVector::zeros(n + m);
        right_side.rows_mut(n, m).copy_from(&(&matrix * DVector::from_column_slice(moved)));
        let solution = self.saddle(time, state, &matrix).lu().solve(&right_side);
        let multipliers = solution.unwrap_or_else(|| DVector::zeros(n + m));
        let parts: Vec<f64> =
            (0..m).map(|row| matrix.row(row).norm() * multipliers[n + row].abs()).collect();
        let all: f64 = parts.iter().sum();
        parts.iter().map(|part| if all > 0.0 { part / all } else { 0.0 }).collect()
    }

    /// Returns the matrix \[M, G^T; G, 0\].
    pub(crate) fn saddle(&self, time: f64, state: &[f64], matrix: &DMatrix<f64>) -> DMatrix<f64> {
        let (n, m) = (self.coordinates, self.count);
        let pattern = self.simulator.mass_matrix_pattern();
        let mut values = vec![0.0; pattern.entries.len()];
        self.simulator.mass_matrix(time, state, &self.parameters.all(), &mut values);
        let mut system = DMatrix::zeros(n + m, n + m);
        for ((row, column), value) in pattern.entries.iter().zip(&values) {
            system[(*row as usize, *column as usize)] = *value;
        }
        system.view_mut((n, 0), (m, n)).copy_from(matrix);
        system.view_mut((0, n), (n, m)).copy_from(&matrix.transpose());
        // A constraint that does not hold in these modes, or that repeats others, has no effect.
        let is_empty = |row: &usize| matrix.row(*row).iter().all(|entry| *entry == 0.0);
        let mut idle: Vec<usize> = (0..m).filter(is_empty).collect();
        if m > idle.len() + 1 && self.holds_in_modes() {
            idle.extend(mobility::repeated_rows(self, matrix));
        }
        for row in idle {
            system.row_mut(n + row).fill(0.0);
            system.column_mut(n + row).fill(0.0);
            system[(n + row, n + row)] = 1.0;
        }
        system
    }

    /// Returns G at a state, m by n.
    pub(crate) fn matrix(&self, time: f64, state: &[f64]) -> DMatrix<f64> {
        self.filled(&self.slopes(time, state))
    }

    /// Returns G at a state for coordinates in units of their typical sizes.
    pub(crate) fn scaled_matrix(&self, time: f64, state: &[f64]) -> DMatrix<f64> {
        let states = self.simulator.shape().states();
        let mut matrix = self.matrix(time, &state[..states]);
        for (column, scale) in self.scales(Level::Positions).into_iter().enumerate() {
            matrix.column_mut(column).scale_mut(scale);
        }
        matrix
    }

    /// Returns the entries of G at a state, in the order of its pattern.
    pub(crate) fn slopes(&self, time: f64, state: &[f64]) -> Vec<f64> {
        let mut values = vec![0.0; self.simulator.constraint_matrix_pattern().entries.len()];
        self.simulator.constraint_matrix(time, state, &self.parameters.all(), &mut values);
        values
    }

    /// Returns G as a full matrix of its entries.
    fn filled(&self, slopes: &[f64]) -> DMatrix<f64> {
        let pattern = self.simulator.constraint_matrix_pattern();
        let mut matrix = DMatrix::zeros(self.count, self.coordinates);
        for ((row, column), value) in pattern.entries.iter().zip(slopes) {
            matrix[(*row as usize, *column as usize)] = *value;
        }
        matrix
    }

    /// Returns g or g', of length m.
    pub(crate) fn residual(&self, level: Level, time: f64, state: &[f64]) -> DVector<f64> {
        let mut values = vec![0.0; self.count];
        match level {
            Level::Positions => {
                self.simulator.constraint_values(time, state, &self.parameters.all(), &mut values);
            }
            Level::Velocities => {
                self.simulator.constraint_rates(time, state, &self.parameters.all(), &mut values);
            }
        }
        DVector::from_vec(values)
    }

    /// Returns each residual divided by the sum of the effects of its coordinates, when each moves
    /// by its typical size or, if larger, by its own value.
    pub(crate) fn relative(
        &self,
        level: Level,
        slopes: &[f64],
        residual: &DVector<f64>,
        state: &[f64],
    ) -> Vec<f64> {
        self.relative_beyond([ROUNDING, 0.0], level, slopes, residual, state)
    }

    /// Returns each residual beyond a rounding, divided likewise. Both bounds, of effects that are
    /// none and of the rounding, are relative to the largest effect.
    fn relative_beyond(
        &self,
        [nothing, rounding]: [f64; 2],
        level: Level,
        slopes: &[f64],
        residual: &DVector<f64>,
        state: &[f64],
    ) -> Vec<f64> {
        let scales = self.scales(level);
        let first = self.first(level);
        let mut sizes = vec![0.0; self.count];
        let pattern = self.simulator.constraint_matrix_pattern();
        for ((row, column), slope) in pattern.entries.iter().zip(slopes) {
            let (row, column) = (*row as usize, *column as usize);
            sizes[row] += slope.abs() * scales[column].max(state[first + column].abs());
        }
        let largest = sizes.iter().copied().fold(0.0, f64::max);
        let off = |(residual, size): (&f64, f64)| {
            let beyond = residual.abs() - rounding * largest;
            // No coordinate changes a constraint of no size.
            let size = if size <= nothing * largest { largest } else { size };
            if beyond <= 0.0 { 0.0 } else { beyond / size }
        };
        residual.iter().zip(sizes).map(off).collect()
    }

    /// Returns the modes of frictions that stick although their speeds differ from zero by more than
    /// velocities are `allowed` to be off, by their entries in the state.
    pub(crate) fn frictions_off(
        &self,
        time: f64,
        state: &[f64],
        allowed: impl Fn(usize) -> f64,
    ) -> Vec<usize> {
        let mode = |row: usize| self.simulator.constraint(row).friction;
        if !(0..self.count).any(|row| mode(row).is_some()) {
            return Vec::new();
        }
        let positions = self.simulator.shape().positions;
        let residual = self.residual(Level::Velocities, time, state);
        let matrix = self.matrix(time, state);
        let is_off = |row: &usize| {
            let slopes = matrix.row(*row);
            let of_entries = slopes.iter().enumerate();
            let zero: f64 = of_entries.map(|(k, slope)| slope.abs() * allowed(positions + k)).sum();
            residual[*row].abs() > zero
        };
        let off = (0..self.count).filter(is_off);
        off.filter_map(|row| mode(row).map(|mode| mode as usize)).collect()
    }

    /// Returns whether some constraints hold only in modes.
    pub(crate) fn holds_in_modes(&self) -> bool {
        (0..self.count).any(|index| self.simulator.constraint(index).in_modes)
    }

    /// Returns the index of the first position or velocity in the state.
    pub(crate) fn first(&self, level: Level) -> usize {
        if level == Level::Positions { 0 } else { self.simulator.shape().positions }
    }

    /// Returns the largest relative residual in position.
    fn size(&self, time: f64, state: &[f64]) -> f64 {
        let slopes = self.slopes(time, state);
        let residual = self.residual(Level::Positions, time, state);
        let off = self.relative(Level::Positions, &slopes, &residual, state);
        largest_of(&off)
    }

    /// Returns the largest relative residual in position or velocity.
    pub(crate) fn off(&self, time: f64, state: &[f64]) -> f64 {
        let slopes = self.slopes(time, state);
        let of = |level: Level| {
            let residual = self.residual(level, time, state);
            largest_of(&self.relative(level, &slopes, &residual, state))
        };
        largest_of(&[of(Level::Positions), of(Level::Velocities)])
    }

    /// Returns the scales of positions or velocities.
    fn scales(&self, level: Level) -> Vec<f64> {
        let first = self.first(level);
        (0..self.coordinates).map(|index| self.simulator.state_scale(first + index)).collect()
    }

    /// Returns the name of a constraint.
    pub(crate) fn name(&self, constraint: usize) -> &'a str {
        self.simulator.constraint(constraint).name
    }
}

/// Returns the largest value; NaN if one is NaN.
fn largest_of(values: &[f64]) -> f64 {
    values.iter().fold(
        0.0,
        |most: f64, value| {
            if most.is_nan() || *value <= most { most } else { *value }
        },
    )
}

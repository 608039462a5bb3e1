//! S at the start: derivatives of the initial state by parameters and by itself.

use machinist_contract::{Dual, DualFunction};
#[cfg(feature = "linear")]
use nalgebra::DMatrix;

use super::{By, Tangents};
use crate::constraints::{Constraints, Level, consistent};
use crate::error::SimulateError;
#[cfg(feature = "linear")]
use crate::linear_analysis::{LinearError, Point, steady_tangents};

/// The start of a run.
pub(crate) struct Start<'s> {
    pub(crate) time: f64,
    pub(crate) state: &'s [f64],
    /// True if the spec gives the state, before constraints moved it; false if the caller has given
    /// one.
    pub(crate) is_of_spec: bool,
    /// Entries that are given otherwise than by the spec.
    pub(crate) set: &'s [usize],
    /// For an equilibrium, the entries that the search was to move least.
    pub(crate) in_equilibrium: Option<&'s [usize]>,
}

impl Tangents<'_> {
    /// Sets S = dy_0/dp. Returns whether the start of an equilibrium follows from its equations
    /// alone, and not from the guess.
    ///
    /// # Errors
    /// Returns an error if a jump at the start moves with a parameter, or if constraints leave open
    /// how the start moves.
    pub(crate) fn begin(&self, start: &Start<'_>) -> Result<bool, SimulateError> {
        self.refuse_jumps_at(start.time)?;
        let count = self.by.len();
        let mut tangents = vec![0.0; self.len()];
        if start.is_of_spec {
            let none = vec![0.0; self.len()];
            let function = DualFunction::InitialState;
            let zeros = vec![0.0; self.states];
            let slopes = self.slopes(function, self.states, start.time, &zeros, &none);
            tangents = slopes.concat();
            for index in start.set {
                tangents[index * count..][..count].fill(0.0);
            }
        }
        for (direction, by) in self.by.iter().enumerate() {
            if let By::Initial(index) = by {
                if start.in_equilibrium.is_none() {
                    self.require_free(start, *index)?;
                }
                tangents[index * count + direction] += 1.0;
            }
        }
        let mut is_determined = true;
        if let Some(named) = start.in_equilibrium {
            is_determined = self.balance(start, named, &mut tangents)?;
        } else if self.simulator.constraints() > 0 {
            let is_given = |index: usize| start.is_of_spec && self.simulator.is_given(index);
            if !self.make_consistent(start, &is_given, &mut tangents)? {
                self.check_start(start, &is_given, &tangents)?;
            }
        }
        self.inner.borrow_mut().start.copy_from_slice(&tangents);
        self.inner.borrow_mut().end.copy_from_slice(&tangents);
        Ok(is_determined)
    }

    /// Maps moves of a guess to those of the equilibrium found from it. Returns whether its
    /// equations determine it.
    #[cfg(feature = "linear")]
    fn balance(
        &self,
        start: &Start<'_>,
        named: &[usize],
        tangents: &mut [f64],
    ) -> Result<bool, SimulateError> {
        let (states, count) = (self.states, self.by.len());
        let (time, state) = (start.time, start.state.to_vec());
        let point = Point { time, state, parameters: self.parameters.to_vec() };
        let first = self.simulator.rate_jacobian_pattern().entries.len();
        let entries = self.simulator.parameter_jacobian_pattern().entries.len();
        // Behind those of dy'/dy, which are not read here.
        let mut values = vec![0.0; first + entries];
        let Point { state, parameters, .. } = &point;
        self.simulator.parameter_jacobian(time, state, parameters, &mut values[first..]);
        let mut rates = vec![0.0; states * count];
        self.equations.drive(&values, &mut rates);
        let rates = DMatrix::from_row_slice(states, count, &rates);
        let guess = DMatrix::from_row_slice(states, count, tangents);
        let onto = |moves: &mut DMatrix<f64>| {
            let mut tangents = moves.transpose().as_slice().to_vec();
            self.make_consistent(start, &|_| false, &mut tangents)?;
            *moves = DMatrix::from_row_slice(states, count, &tangents);
            Ok(())
        };
        let found = steady_tangents(self.simulator, &point, named, (guess, &rates), &onto);
        let found = found.map_err(LinearError::of_start)?;
        tangents.copy_from_slice(found.state.transpose().as_slice());
        Ok(found.is_determined)
    }

    #[cfg(not(feature = "linear"))]
    #[expect(
        clippy::unused_self,
        clippy::unnecessary_wraps,
        reason = "as where it is searched for"
    )]
    fn balance(&self, _: &Start<'_>, _: &[usize], _: &mut [f64]) -> Result<bool, SimulateError> {
        Ok(false)
    }

    /// Refuses the initial value of a state that constraints determine.
    fn require_free(&self, start: &Start<'_>, index: usize) -> Result<(), SimulateError> {
        if !start.is_of_spec || self.simulator.constraints() == 0 || self.simulator.is_given(index)
        {
            return Ok(());
        }
        Err(SimulateError::NotDifferentiable {
            name: self.simulator.state(index).name.to_owned(),
            why: "is not given at the start, but follows from the constraints".to_owned(),
        })
    }

    /// Refuses a moving jump at the very start, which is within the run or before it, as its
    /// parameter moves.
    fn refuse_jumps_at(&self, from: f64) -> Result<(), SimulateError> {
        for (time, shifts) in self.jump_times() {
            if let Some(direction) = shifts.iter().position(|shift| *shift != 0.0)
                && time.to_bits() == from.to_bits()
            {
                let name = self.by[direction].quantity(self.simulator).name.to_owned();
                let why = format!(
                    "moves a jump that is exactly at the start of the run, {from} s, so the \
                     derivative is one-sided"
                );
                return Err(SimulateError::NotDifferentiable { name, why });
            }
        }
        Ok(())
    }

    /// Returns the times of jumps, and their derivatives.
    pub(super) fn jump_times(&self) -> Vec<(f64, Vec<f64>)> {
        let count = self.simulator.shape().discontinuities;
        let mut jumps = vec![(0.0, Vec::with_capacity(self.by.len())); count];
        let mut results = vec![Dual::constant(0.0); count];
        for directions in self.chunks() {
            let parameters = self.parameters_along(&directions);
            let zero = Dual::constant(0.0);
            let state = vec![zero; self.states];
            let function = DualFunction::Discontinuities;
            self.derivatives.on_duals(function, zero, &state, &parameters, &mut results);
            for ((time, shifts), result) in jumps.iter_mut().zip(&results) {
                *time = result.value;
                shifts.extend_from_slice(&result.slopes[..directions.len()]);
            }
        }
        jumps
    }

    /// Moves what is not given, so that the start stays on the constraints:
    ///
    /// ```text
    /// G_f dq_f = -(G dq + dg/dp)      by least squares, moves measured by the states' scales
    /// ```
    ///
    /// Returns whether this determines the moves. If not, the start also depends on the guesses and
    /// on the search, and differences of the search decide.
    fn make_consistent(
        &self,
        start: &Start<'_>,
        is_given: &dyn Fn(usize) -> bool,
        tangents: &mut [f64],
    ) -> Result<bool, SimulateError> {
        if self.simulator.constraints() == 0 {
            return Ok(true);
        }
        let count = self.by.len();
        let mut is_determined = true;
        for level in [Level::Positions, Level::Velocities] {
            let function = match level {
                Level::Positions => DualFunction::ConstraintValues,
                Level::Velocities => DualFunction::ConstraintRates,
            };
            let rows = self.simulator.constraints();
            let slopes = self.slopes(function, rows, start.time, start.state, tangents);
            let sizes: Vec<f64> = slopes.concat().iter().map(|slope| slope.abs()).collect();
            let at = (start.time, start.state);
            let Some(free) = crate::constraints::free_moves(
                self.simulator,
                self.parameters,
                level,
                at,
                is_given,
            ) else {
                self.require_none_left(level, start, &sizes, &slopes.concat())?;
                continue;
            };
            let moves = free.solve(&slopes);
            for (entry, moves) in free.entries.iter().zip(moves.row_iter()) {
                for (direction, by) in moves.iter().enumerate() {
                    tangents[entry * count + direction] -= by;
                }
            }
            is_determined &= free.is_determined;
            let left = self.slopes(function, rows, start.time, start.state, tangents);
            self.require_none_left(level, start, &sizes, &left.concat())?;
        }
        Ok(is_determined)
    }

    /// Refuses a start that leaves the constraints because nothing is left to compensate. `left`
    /// are slopes of the constraints, and `sizes` those before the compensation.
    fn require_none_left(
        &self,
        level: Level,
        start: &Start<'_>,
        sizes: &[f64],
        left: &[f64],
    ) -> Result<(), SimulateError> {
        const SHARE: f64 = 1e-6;
        /// Share of a move of all coordinates by their typical sizes.
        const ROUNDING: f64 = 1e-10;
        let Some(constraints) = Constraints::of(self.simulator, self.parameters) else {
            return Ok(());
        };
        let matrix = constraints.matrix(start.time, start.state);
        let first = if level == Level::Positions { 0 } else { matrix.ncols() };
        let count = self.by.len();
        for (place, (left, size)) in left.iter().zip(sizes).enumerate() {
            let (row, direction) = (place / count, place % count);
            let moves = matrix.row(row).into_owned();
            let moves = moves
                .iter()
                .enumerate()
                .map(|(column, slope)| slope.abs() * self.simulator.state_scale(first + column));
            let usual = moves.sum::<f64>() / self.sizes[direction];
            if left.abs() > SHARE * size && left.abs() > ROUNDING * usual {
                let name = self.by[direction].quantity(self.simulator).name.to_owned();
                let constraint = self.simulator.constraint(row).name;
                let why = format!(
                    "moves the start off constraint `{constraint}`, and no initial value is free \
                     to compensate"
                );
                return Err(SimulateError::NotDifferentiable { name, why });
            }
        }
        Ok(())
    }

    /// Compares S with differences of the search for a start.
    fn check_start(
        &self,
        start: &Start<'_>,
        is_given: &dyn Fn(usize) -> bool,
        tangents: &[f64],
    ) -> Result<(), SimulateError> {
        const NEAR: f64 = 1e-4;
        let count = self.by.len();
        for (direction, by) in self.by.iter().enumerate() {
            let quantity = by.quantity(self.simulator);
            let open = || SimulateError::NotDifferentiable {
                name: quantity.name.to_owned(),
                why:
                    "moves a start that constraints do not determine, so the start depends on the \
                      search from the guesses; give more initial values"
                        .to_owned(),
            };
            let size = match by {
                By::Parameter(index) => self.parameters[*index].abs(),
                By::Initial(index) => self.simulator.state_scale(*index),
            };
            let step = 1e-6 * if size > 0.0 { size } else { 1.0 };
            let at = |by_how_much: f64| {
                let mut parameters = self.parameters.to_vec();
                if let By::Parameter(index) = by {
                    parameters[*index] += by_how_much;
                }
                let mut state = start.state.to_vec();
                if start.is_of_spec {
                    self.simulator.initial_state(&parameters, &mut state);
                    for index in start.set {
                        state[*index] = start.state[*index];
                    }
                }
                if let By::Initial(index) = by {
                    state[*index] += by_how_much;
                }
                consistent(self.simulator, &parameters, start.time, state, is_given)
            };
            let (Ok(ahead), Ok(behind)) = (at(step), at(-step)) else { return Err(open()) };
            for index in 0..self.states {
                let scale = self.simulator.state_scale(index).max(start.state[index].abs());
                let difference = (ahead[index] - behind[index]) / (2.0 * step);
                let off = (difference - tangents[index * count + direction]).abs();
                if off * size.max(step) > NEAR * scale {
                    return Err(open());
                }
            }
        }
        Ok(())
    }
}

//! Projection of positions and of velocities onto constraints, by one step of Newton's method
//! each.

use super::{FixedSteps, Rest, StepNumber};
use crate::{Real, Shape, Simulator};

/// Workspace of the projection.
pub(super) struct Projection<'w, R> {
    /// The matrix of `[M, G^T; G, 0]`, row by row.
    matrix: &'w mut [R],
    pub(super) shift: &'w mut [R],
    pub(super) off: &'w mut [R],
    mass: &'w mut [R],
    slopes: &'w mut [R],
    /// A state and two rates, with quaternions only.
    turned: &'w mut [R],
}

/// Level of the constraints to be fulfilled.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Level {
    Positions,
    Velocities,
}

impl<'w, R: StepNumber> Projection<'w, R> {
    /// Returns the number of numbers that the workspace takes.
    pub(super) fn room(simulator: &dyn Simulator<R>) -> usize {
        let [size, constraints, mass, slopes] = sizes(simulator);
        size * size + size + constraints + mass + slopes + room_to_turn(simulator)
    }

    pub(super) fn new(simulator: &dyn Simulator<R>, rest: &mut Rest<'w, R>) -> Self {
        let [size, constraints, mass, slopes] = sizes(simulator);
        Self {
            matrix: rest.take(size * size),
            shift: rest.take(size),
            off: rest.take(constraints),
            mass: rest.take(mass),
            slopes: rest.take(slopes),
            turned: rest.take(room_to_turn(simulator)),
        }
    }

    pub(super) fn project(&mut self, of: &FixedSteps<'_, R>, time: R, state: &mut [R]) {
        for level in [Level::Positions, Level::Velocities] {
            match level {
                Level::Positions => {
                    of.simulator.constraint_values(time, state, of.parameters, self.off);
                }
                Level::Velocities => {
                    of.simulator.constraint_rates(time, state, of.parameters, self.off);
                }
            }
            self.shortest(of, time, state);
            let Shape { positions, coordinates, .. } = of.simulator.shape();
            if level == Level::Positions && positions != coordinates {
                self.find_turn(of, time, state);
                self.turn(&mut state[..positions]);
                continue;
            }
            let first = if level == Level::Positions { 0 } else { positions };
            self.shift(&mut state[first..first + coordinates]);
        }
    }

    /// Subtracts the shift from coordinates.
    pub(super) fn shift(&self, entries: &mut [R]) {
        for (entry, &shift) in entries.iter_mut().zip(self.shift.iter()) {
            *entry = *entry - shift;
        }
    }

    /// Finds the changes of positions by the shift, which turns quaternions. Rates of positions
    /// are linear in velocities: the changes are their difference between velocities of this size
    /// and none.
    pub(super) fn find_turn(&mut self, of: &FixedSteps<'_, R>, time: R, state: &[R]) {
        let Shape { positions, coordinates, .. } = of.simulator.shape();
        let states = of.simulator.shape().states();
        let (there, rates) = self.turned.split_at_mut(states);
        let (moving, resting) = rates.split_at_mut(states);
        there.copy_from_slice(&state[..states]);
        there[positions..positions + coordinates].copy_from_slice(&self.shift[..coordinates]);
        of.simulator.rate(time, there, of.parameters, moving);
        there[positions..positions + coordinates].fill(R::literal(0.0));
        of.simulator.rate(time, there, of.parameters, resting);
        for (moving, &resting) in moving.iter_mut().zip(resting.iter()) {
            *moving = *moving - resting;
        }
    }

    /// Subtracts the changes that [`Projection::find_turn`] has found from positions.
    pub(super) fn turn(&self, positions: &mut [R]) {
        let states = self.turned.len() / 3;
        for (entry, &change) in positions.iter_mut().zip(&self.turned[states..]) {
            *entry = *entry - change;
        }
    }

    /// Computes the smallest change in the norm of the mass matrix: `M d + G^T mu = 0`, `G d =
    /// off`.
    pub(super) fn shortest(&mut self, of: &FixedSteps<'_, R>, time: R, state: &[R]) {
        let simulator = of.simulator;
        let [size, constraints, ..] = sizes(simulator);
        let coordinates = size - constraints;
        let zero = R::literal(0.0);
        self.matrix.fill(zero);
        self.shift.fill(zero);
        simulator.mass_matrix(time, state, of.parameters, self.mass);
        let entries = simulator.mass_matrix_pattern().entries;
        for (&(row, column), &value) in entries.iter().zip(self.mass.iter()) {
            self.matrix[row as usize * size + column as usize] = value;
        }
        simulator.constraint_matrix(time, state, of.parameters, self.slopes);
        let entries = simulator.constraint_matrix_pattern().entries;
        for (&(row, column), &value) in entries.iter().zip(self.slopes.iter()) {
            let (row, column) = (coordinates + row as usize, column as usize);
            self.matrix[row * size + column] = value;
            self.matrix[column * size + row] = value;
        }
        for constraint in 0..constraints {
            let row = coordinates + constraint;
            let holds = self.matrix[row * size..row * size + coordinates]
                .iter()
                .any(|value| *value < zero || zero < *value);
            if holds {
                self.shift[row] = self.off[constraint];
            } else {
                // The constraint does not hold in these modes.
                self.matrix[row * size + row] = R::literal(1.0);
            }
        }
        eliminate(self.matrix, self.shift);
    }
}

/// Returns the length of the workspace that turns quaternions.
fn room_to_turn<R: Real>(simulator: &dyn Simulator<R>) -> usize {
    let shape = simulator.shape();
    let turns = simulator.constraints() > 0 && shape.positions > shape.coordinates;
    if turns { 3 * shape.states() } else { 0 }
}

/// Returns the numbers of coordinates plus constraints, of constraints, and of nonzeros of M and
/// G.
fn sizes<R: Real>(simulator: &dyn Simulator<R>) -> [usize; 4] {
    let constraints = simulator.constraints();
    if constraints == 0 {
        return [0; 4];
    }
    let [mass, slopes] = [simulator.mass_matrix_pattern(), simulator.constraint_matrix_pattern()];
    [
        simulator.shape().coordinates + constraints,
        constraints,
        mass.entries.len(),
        slopes.entries.len(),
    ]
}

/// Solves `a x = b` in place by elimination with row exchanges. Unknowns of rows that vanish up
/// to rounding, as for redundant constraints, are zero.
fn eliminate<R: StepNumber>(a: &mut [R], b: &mut [R]) {
    let size = b.len();
    let zero = R::literal(0.0);
    let largest = a.iter().fold(zero, |largest, entry| {
        let entry = entry.abs();
        if largest < entry { entry } else { largest }
    });
    let least = largest * R::literal(size as f64) * R::literal(R::EPSILON);
    for column in 0..size {
        let mut pivot = column;
        for row in column + 1..size {
            if a[pivot * size + column].abs() < a[row * size + column].abs() {
                pivot = row;
            }
        }
        let is_sound = least < a[pivot * size + column].abs();
        if !is_sound {
            a[column * size..(column + 1) * size].fill(zero);
            a[column * size + column] = R::literal(1.0);
            b[column] = zero;
            continue;
        }
        if pivot != column {
            b.swap(pivot, column);
            for k in column..size {
                a.swap(pivot * size + k, column * size + k);
            }
        }
        for row in column + 1..size {
            let factor = a[row * size + column] / a[column * size + column];
            if factor < zero || zero < factor {
                for k in column..size {
                    a[row * size + k] = a[row * size + k] - factor * a[column * size + k];
                }
                b[row] = b[row] - factor * b[column];
            }
        }
    }
    for row in (0..size).rev() {
        let mut sum = b[row];
        for k in row + 1..size {
            sum = sum - a[row * size + k] * b[k];
        }
        b[row] = sum / a[row * size + row];
    }
}

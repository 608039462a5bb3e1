//! Steady rotation in coordinates that turn with it: relative equilibria.
//!
//! A sleeping top, described by its quaternion, moves all the time, but looks the same from a frame
//! that turns with it. If the machine has a symmetry q -> q + e (S q + b), under which energies are
//! unchanged and rates turn, then a motion q' = S q + b is steady. Deviations from it, seen from
//! that frame, have constant coefficients: A minus S for positions and velocities (Marsden and
//! Ratiu, Introduction to Mechanics and Symmetry, section 1.7 and chapter 9).
//!
//! Symmetries are not part of the model. They are found from their effects: S and b solve linear
//! equations at points around a state,
//!
//! ```text
//! df(y)/dy (S q + b, S q') = (S q', S q'', 0)     dT, dV along (S q + b, S q') = 0
//! ```

use machinist_contract::Simulator;
use nalgebra::{DMatrix, DVector};

use super::differences::derivative;
use super::{Point, jacobian, rate};
use crate::constraints::{Constraints, Level};
use crate::scales::beside;

/// Maximum number of coordinates for the search for symmetries, with n^2 + n unknowns.
const MOST: usize = 16;
/// Ratio to the largest singular value below which others are zero: gradients of energies have
/// twelve digits.
const NOTHING: f64 = 1e-9;
/// Deviation of rates from the symmetry, relative to the motion, below which the motion is steady.
const STEADY: f64 = 1e-8;
/// Distance of points around a state, in scales of states.
const REACH: f64 = 0.3;
/// Maximum number of steps of Newton's method.
const ROUNDS: usize = 50;
/// Maximum change of coordinates in these, in their scales.
const NEAR: f64 = 0.5;

/// Symmetries around a state.
struct Symmetries<'a> {
    simulator: &'a dyn Simulator<f64>,
    coordinates: usize,
    /// (S, b) of each symmetry.
    all: Vec<(DMatrix<f64>, DVector<f64>)>,
    /// Derivatives of outputs along each symmetry, at some points.
    seen: DMatrix<f64>,
}

/// A motion along a symmetry, by its coefficients.
struct Steady {
    shares: DVector<f64>,
    /// Deviation of rates, relative to the motion.
    off: f64,
}

/// Returns S of the steady rotation at a state, n by n; `None` if the motion is not steady, if
/// nothing turns, or if the machine is too large.
pub(super) fn turning(simulator: &dyn Simulator<f64>, point: &Point) -> Option<DMatrix<f64>> {
    let symmetries = Symmetries::around(simulator, point)?;
    // The fewest combinations of symmetries that explain the motion: an upright top hardly moves
    // by the others.
    let mut fits = (1..=symmetries.all.len()).map(|kept| symmetries.fitted(point, kept));
    let steady = fits.find(|steady| steady.off <= STEADY)?;
    let (turns, _) = symmetries.together(&steady.shares);
    Some(turns)
}

/// Returns the steady rotation near a turning state: at its rate of turning, or else near that
/// rate.
///
/// A slightly tilted top hardly shows how fast it turns about the vertical and how fast about its
/// axis, so its nutation is taken for a fast turn of both against each other. The search therefore
/// begins again without the combinations of symmetries that move the state least.
pub(super) fn steady_rotation(simulator: &dyn Simulator<f64>, guess: &Point) -> Option<Point> {
    let symmetries = Symmetries::around(simulator, guess)?;
    (1..=symmetries.all.len()).rev().find_map(|kept| {
        let shares = symmetries.fitted(guess, kept).shares;
        symmetries
            .steady_near(guess, &shares, false)
            .or_else(|| symmetries.steady_near(guess, &shares, true))
    })
}

impl<'a> Symmetries<'a> {
    /// Finds the symmetries of a machine whose state has accelerations, so that it is not an
    /// equilibrium; `None` if no symmetry turns.
    fn around(simulator: &'a dyn Simulator<f64>, point: &Point) -> Option<Self> {
        let shape = simulator.shape();
        let n = shape.coordinates;
        if !(2..=MOST).contains(&n) || shape.positions != n || is_driven(simulator, point) {
            return None;
        }
        let rates = rate(simulator, point);
        let accelerates =
            (n..2 * n).any(|index| rates[index].abs() > STEADY * simulator.state_scale(index));
        if !accelerates {
            return None;
        }
        let places = places(simulator, point);
        let mut rows = Vec::new();
        for place in &places {
            rows.extend(equations(simulator, place)?);
        }
        let unknowns = n * n + n;
        let mut matrix = DMatrix::zeros(rows.len().max(unknowns), unknowns);
        for (row, entries) in rows.iter().enumerate() {
            let size = entries.norm();
            if size > 0.0 {
                matrix.row_mut(row).copy_from(&(entries / size).transpose());
            }
        }
        let svd = matrix.svd(false, true);
        let (values, directions) = (svd.singular_values, svd.v_t?);
        let least = NOTHING * values.max();
        let scale = |index: usize| simulator.state_scale(index);
        let symmetry = |row: usize| {
            let entry = |at: usize| directions[(row, at)];
            let turns = DMatrix::from_fn(n, n, |i, j| entry(i * n + j) * scale(i) / scale(j));
            (turns, DVector::from_fn(n, |i, _| entry(n * n + i) * scale(i)))
        };
        let open = (0..unknowns).filter(|row| values[*row] <= least);
        let all: Vec<_> = open.map(symmetry).collect();
        if all.iter().all(|(turns, _)| turns.amax() <= NOTHING) {
            return None;
        }
        let mut found = Self { simulator, coordinates: n, all, seen: DMatrix::zeros(0, 0) };
        found.seen = found.seen_by_outputs(&places);
        Some(found)
    }

    /// Searches by Newton's method, which may change the rate of turning or not.
    fn steady_near(
        &self,
        guess: &Point,
        fitted: &DVector<f64>,
        changes_rate: bool,
    ) -> Option<Point> {
        let (mut point, mut shares) = (guess.clone(), fitted.clone());
        for _ in 0..ROUNDS {
            let step = self.step(&point, &shares, changes_rate)?;
            let before = shares.norm();
            self.moved(&mut point, &mut shares, &step)?;
            if step.amax() <= 4.0 * f64::EPSILON * (1.0 + before) {
                break;
            }
        }
        let scale = |index: usize| self.simulator.state_scale(index);
        let far = |index: usize| (point.state[index] - guess.state[index]).abs() / scale(index);
        let is_near = (0..self.coordinates).all(|index| far(index) <= NEAR)
            && (&shares - fitted).norm() <= NEAR * fitted.norm();
        let steady = self.fitted(&point, self.all.len());
        let (turns, _) = self.together(&steady.shares);
        let is_turning = turns.amax() > 0.0;
        (is_near && is_turning && steady.off <= STEADY).then_some(point)
    }

    /// Returns S and b of a linear combination.
    fn together(&self, shares: &DVector<f64>) -> (DMatrix<f64>, DVector<f64>) {
        let n = self.coordinates;
        let none = (DMatrix::zeros(n, n), DVector::zeros(n));
        self.all.iter().zip(shares.iter()).fold(none, |(turns, shifts), ((s, b), share)| {
            (turns + s * *share, shifts + b * *share)
        })
    }

    fn seen_by_outputs(&self, places: &[Point]) -> DMatrix<f64> {
        let outputs = self.simulator.shape().outputs;
        let mut seen = DMatrix::zeros(outputs * places.len(), self.all.len());
        for (at, place) in places.iter().enumerate() {
            for (number, (turns, shifts)) in self.all.iter().enumerate() {
                let along = along(self.coordinates, place, turns, shifts);
                let changes = derivative(1.0, outputs, |step| {
                    let state: Vec<f64> =
                        place.state.iter().zip(&along).map(|(y, way)| y + step * way).collect();
                    let mut values = vec![0.0; outputs];
                    self.simulator.outputs(place.time, &state, &place.parameters, &mut values);
                    values
                });
                for (output, change) in changes.into_iter().enumerate() {
                    let is_finite = change.is_finite();
                    seen[(at * outputs + output, number)] = if is_finite { change } else { 0.0 };
                }
            }
        }
        seen
    }

    /// Returns the motion along a symmetry that is nearest to that of a state. If it is not unique,
    /// outputs change least along it, so that deviations agree with what they show. Of the
    /// combinations of symmetries, only the `kept` ones that move the state most are determined.
    fn fitted(&self, point: &Point, kept: usize) -> Steady {
        let n = self.coordinates;
        let rate = rate(self.simulator, point);
        let scale = |index: usize| self.simulator.state_scale(index);
        let wanted = DVector::from_fn(2 * n, |index, _| rate[index] / scale(index));
        let mut matrix = DMatrix::zeros(2 * n, self.all.len());
        for (number, (turns, shifts)) in self.all.iter().enumerate() {
            let along = along(n, point, turns, shifts);
            for index in 0..2 * n {
                matrix[(index, number)] = along[index] / scale(index);
            }
        }
        let svd = matrix.clone().svd(true, true);
        let values = &svd.singular_values;
        let nothing = NOTHING * values.max().max(f64::MIN_POSITIVE);
        let least = values.get(kept).map_or(nothing, |value| value.max(nothing));
        let nearest = svd.solve(&wanted, least).unwrap_or_else(|_| DVector::zeros(self.all.len()));
        let of_states = (2 * n..rate.len()).map(|index| rate[index] / scale(index));
        let of_states = of_states.map(|rate| rate * rate).sum::<f64>().sqrt();
        let off = (&matrix * &nearest - &wanted).norm().max(of_states) / wanted.norm();
        let shares = self.least_seen(&svd, least, nearest);
        Steady { shares, off }
    }

    fn least_seen(
        &self,
        svd: &nalgebra::SVD<f64, nalgebra::Dyn, nalgebra::Dyn>,
        least: f64,
        nearest: DVector<f64>,
    ) -> DVector<f64> {
        let Some(directions) = &svd.v_t else { return nearest };
        let count = self.all.len();
        let mut decided = DMatrix::zeros(count, count);
        for (row, value) in svd.singular_values.iter().enumerate() {
            if *value > least {
                let direction = directions.row(row);
                decided += direction.transpose() * direction;
            }
        }
        let open = DMatrix::identity(count, count) - decided;
        let seen = &self.seen * &open;
        let size = seen.amax();
        if size.is_nan() || size <= NOTHING * self.seen.amax() {
            return nearest;
        }
        let back = seen.svd(true, true).solve(&(&self.seen * &nearest), NOTHING * size);
        back.map_or(nearest.clone(), |back| &nearest - open * back)
    }

    /// Returns Newton's step of [q, z, shares] for f(q, S q + b, z) = (.., S q', 0) on the
    /// constraints, the least one in the scales of states, and across all symmetries: what they move
    /// is steady as well, but far from the state.
    fn step(
        &self,
        point: &Point,
        shares: &DVector<f64>,
        changes_rate: bool,
    ) -> Option<DVector<f64>> {
        let (n, states) = (self.coordinates, point.state.len());
        let m = states - 2 * n;
        let matrix = jacobian(self.simulator, point).ok()?.full();
        let rates = rate(self.simulator, point);
        let (turns, _) = self.together(shares);
        let speeds = DVector::from_column_slice(&point.state[n..2 * n]);
        let by_q = matrix.view((n, 0), (n + m, n)).into_owned();
        let by_v = matrix.view((n, n), (n + m, n)).into_owned();
        let mut off = rates.rows(n, n + m).into_owned();
        let mut onto = by_v.clone();
        let mut by_position = by_q + &by_v * &turns;
        {
            let mut mechanical = off.rows_mut(0, n);
            mechanical -= &turns * &speeds;
            let mut mechanical = onto.rows_mut(0, n);
            mechanical -= &turns;
            let mut mechanical = by_position.rows_mut(0, n);
            mechanical -= &turns * &turns;
        }
        let constraints = Constraints::of(self.simulator, &point.parameters);
        let held = constraints.map(|constraints| constraints.matrix(point.time, &point.state));
        let count = held.as_ref().map_or(0, DMatrix::nrows);
        let fixed = n + m + count;
        let positions = DVector::from_column_slice(&point.state[..n]);
        let mut system = DMatrix::zeros(fixed + self.all.len(), n + m + self.all.len());
        system.view_mut((0, 0), (n + m, n)).copy_from(&by_position);
        system.view_mut((0, n), (n + m, m)).copy_from(&matrix.view((n, 2 * n), (n + m, m)));
        for (number, (s, b)) in self.all.iter().enumerate() {
            let mut column = &onto * (s * &positions + b);
            let mut mechanical = column.rows_mut(0, n);
            mechanical -= s * &speeds;
            system.view_mut((0, n + m + number), (n + m, 1)).copy_from(&column);
        }
        if let Some(held) = &held {
            system.view_mut((n + m, 0), (count, n)).copy_from(held);
        }
        let mut right_side = DVector::zeros(system.nrows());
        right_side.rows_mut(0, n + m).copy_from(&-off);
        let scale = |entry: usize| self.simulator.state_scale(entry);
        let weight = system.amax();
        for (number, (s, b)) in self.all.iter().enumerate() {
            let along = s * &positions + b;
            for column in 0..n {
                let across = weight * along[column] / scale(column).powi(2);
                system[(fixed + number, column)] = across;
            }
        }
        let size = |column: usize| match column {
            _ if column < n => scale(column),
            _ if column < n + m => scale(column + n),
            _ if changes_rate => shares.amax().max(f64::MIN_POSITIVE),
            _ => 0.0,
        };
        for column in 0..system.ncols() {
            system.column_mut(column).scale_mut(size(column));
        }
        let least = NOTHING * system.amax();
        let mut step = system.svd(true, true).solve(&right_side, least).ok()?;
        for (column, mut entry) in step.row_iter_mut().enumerate() {
            entry *= size(column);
        }
        step.iter().all(|entry| entry.is_finite()).then_some(step)
    }

    fn moved(
        &self,
        point: &mut Point,
        shares: &mut DVector<f64>,
        step: &DVector<f64>,
    ) -> Option<()> {
        let n = self.coordinates;
        let m = point.state.len() - 2 * n;
        for index in 0..n {
            point.state[index] += step[index];
        }
        for index in 0..m {
            point.state[2 * n + index] += step[n + index];
        }
        *shares += step.rows(n + m, self.all.len());
        if let Some(constraints) = Constraints::of(self.simulator, &point.parameters) {
            constraints.put_back(Level::Positions, point.time, &mut point.state).ok()?;
        }
        let (turns, shifts) = self.together(shares);
        let speeds = turns * DVector::from_column_slice(&point.state[..n]) + shifts;
        point.state[n..2 * n].copy_from_slice(speeds.as_slice());
        Some(())
    }
}

/// Returns whether constraints depend on time.
fn is_driven(simulator: &dyn Simulator<f64>, point: &Point) -> bool {
    let n = simulator.shape().coordinates;
    let mut still = point.state.clone();
    still[n..2 * n].fill(0.0);
    Constraints::of(simulator, &point.parameters).is_some_and(|constraints| {
        constraints.residual(Level::Velocities, point.time, &still).iter().any(|rate| *rate != 0.0)
    })
}

/// Returns (S q + b, S q', 0).
fn along(n: usize, point: &Point, turns: &DMatrix<f64>, shifts: &DVector<f64>) -> Vec<f64> {
    let of = |first: usize| turns * DVector::from_column_slice(&point.state[first..first + n]);
    let mut along = vec![0.0; point.state.len()];
    along[..n].copy_from_slice((of(0) + shifts).as_slice());
    along[n..2 * n].copy_from_slice(of(n).as_slice());
    along
}

/// Returns the state and enough others around it for more equations than unknowns.
fn places(simulator: &dyn Simulator<f64>, point: &Point) -> Vec<Point> {
    let n = simulator.shape().coordinates;
    let around = |number: usize| {
        let state = beside(simulator, &point.state, number, REACH);
        Point { state, ..point.clone() }
    };
    (0..n + 6).map(around).collect()
}

/// Returns the coefficients of the unknowns, S row by row and b, in the scales of positions, for
/// each equation at a point.
fn equations(simulator: &dyn Simulator<f64>, place: &Point) -> Option<Vec<DVector<f64>>> {
    let shape = simulator.shape();
    let (n, states) = (shape.coordinates, shape.states());
    let matrix = jacobian(simulator, place).ok()?.full();
    let rates = rate(simulator, place);
    let scale = |index: usize| simulator.state_scale(index);
    // Coefficients of S q + b and S q'.
    let row = |of_q: &dyn Fn(usize) -> f64, of_v: &dyn Fn(usize) -> f64| {
        DVector::from_fn(n * n + n, |at, _| {
            if at >= n * n {
                return of_q(at - n * n) * scale(at - n * n);
            }
            let (i, j) = (at / n, at % n);
            (of_q(i) * place.state[j] + of_v(i) * place.state[n + j]) * scale(i) / scale(j)
        })
    };
    let mut rows: Vec<DVector<f64>> = (n..states)
        .filter(|index| !simulator.is_mode(*index))
        .map(|index| {
            let of = |column: usize| matrix[(index, column)] / scale(index);
            let mut row = row(&of, &|column| of(n + column));
            // The acceleration of a coordinate turns with it.
            if let Some(i) = (index < 2 * n).then(|| index - n) {
                for j in 0..n {
                    row[i * n + j] -= rates[n + j] / scale(index) * scale(i) / scale(j);
                }
            }
            row
        })
        .collect();
    let gradients: Vec<Vec<f64>> = (0..2 * n)
        .map(|index| {
            derivative(scale(index), 3, |step| {
                let mut state = place.state.clone();
                state[index] += step;
                let energy = simulator.energy(place.time, &state, &place.parameters);
                vec![energy.kinetic, energy.potential, energy.stored]
            })
        })
        .collect();
    rows.extend((0..3).map(|kind| {
        let of = |index: usize| gradients[index][kind];
        row(&of, &|column| of(n + column))
    }));
    rows.iter().all(|row| row.iter().all(|entry| entry.is_finite())).then_some(rows)
}

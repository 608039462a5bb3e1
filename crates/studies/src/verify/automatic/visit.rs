//! Points at which a machine is checked: along its own run and around it.

use std::cell::OnceCell;

use machinist::Trajectory;
use machinist::constraints::{Constraints, Level};
use machinist::hosted::branches;
use machinist_contract::Simulator;

use super::runs::References;
use super::{Subject, states};
use crate::verify::machine::{Point, SplitMix};

/// Number of points along the run; the same number lies around them.
const PLACES: usize = 8;
/// Total number of columns of Jacobians that are differentiated, as far as eight points allow.
const COLUMNS: usize = 1500;
/// Distance of points around the run, relative to the size of a state's motion.
const AROUND: f64 = 0.1;
/// Distance of points in time from switches at all output times, as a share of that to the next one.
const ASIDE: f64 = 0.38;

/// A machine, its run, and the points of the checks.
pub(super) struct Visit<'a> {
    pub(super) subject: &'a Subject<'a>,
    pub(super) simulator: &'a dyn Simulator<f64>,
    pub(super) run: &'a Trajectory,
    /// Typical size of each state's motion: its range, and at most its scale.
    pub(super) sizes: Vec<f64>,
    pub(super) points: Vec<Point>,
    references: OnceCell<References>,
}

impl<'a> Visit<'a> {
    pub(super) fn new(subject: &'a Subject<'a>, run: &'a Trajectory) -> Self {
        let simulator = subject.simulation.simulator();
        let columns = states(run);
        // Even a run at a loose tolerance resolves such moves.
        let nothing = run.rtol.min(1e-8);
        let sizes: Vec<f64> =
            (0..columns.len()).map(|k| size(simulator, k, columns[k], nothing)).collect();
        let references = OnceCell::new();
        let mut visit = Self { subject, simulator, run, sizes, points: Vec::new(), references };
        visit.points = visit.along_and_around(&columns);
        visit
    }

    /// Returns about equally spaced states of the run, each followed by one around it. Output times may
    /// be those of switches, beside which there are others.
    fn along_and_around(&self, columns: &[&[f64]]) -> Vec<Point> {
        let parameters = self.subject.simulation.parameter_values();
        let places = (COLUMNS / columns.len().max(1)).clamp(2, PLACES);
        let last = self.run.times.len() - 1;
        let mut random = SplitMix(0x5eed);
        let mut points = Vec::with_capacity(2 * places);
        let at_row = |row: usize| {
            let state = columns.iter().map(|column| column[row]).collect();
            Point { time: self.run.times[row], state, parameters: parameters.to_vec() }
        };
        for place in 0..places {
            let row = place * last / (places - 1);
            let room = last / (2 * (places - 1));
            let rows = (0..=room).flat_map(|by| [row + by, row.saturating_sub(by)]);
            let mut beside = rows.filter(|row| *row <= last).map(at_row);
            let along = beside.find(|point| place == 0 || !self.is_at_kink(point));
            let along = along.unwrap_or_else(|| at_row(row));
            let mut around = along.clone();
            if self.is_at_kink(&along) {
                let next = self.run.times.iter().find(|time| **time > along.time);
                around.time += next.map_or(0.0, |next| ASIDE * (next - along.time));
            }
            for (index, value) in around.state.iter_mut().enumerate() {
                let shift = AROUND * self.sizes[index] * random.signed();
                *value += if self.simulator.is_mode(index) { 0.0 } else { shift };
            }
            let around = on_constraints(self.simulator, around);
            points.push(along);
            points.extend(around.filter(|point| self.is_defined(point)));
        }
        points
    }

    /// Returns whether the rate is finite at a point: points around a state may be beyond a root or
    /// a wall.
    fn is_defined(&self, point: &Point) -> bool {
        self.rate(point).iter().all(|value| value.is_finite())
    }

    /// Returns numbers that differ between points unless the rate is smooth from one to the other:
    /// branches of relations, sides of other switching surfaces and of times at which it is known to
    /// change.
    pub(super) fn branches(&self, point: &Point) -> Vec<f64> {
        let (simulator, Point { time, state, parameters }) = (self.simulator, point);
        let mut guards = vec![0.0; simulator.kinks()];
        if !guards.is_empty() {
            simulator.kink_guards(*time, state, parameters, &mut guards);
        }
        let mut times = vec![0.0; simulator.shape().discontinuities];
        simulator.discontinuities(parameters, &mut times);
        let others = guards.into_iter().skip(simulator.relations());
        let sides = others.chain(times.into_iter().map(|jump| time - jump));
        let side = |value: f64| if value == 0.0 { 0.0 } else { value.signum() };
        let mut branches = branches(simulator, parameters, (*time, state));
        branches.extend(sides.map(side));
        branches
    }

    /// Returns whether a point is at the time of a switching surface, as output times may be:
    /// rounding then decides on which side the rate and its derivatives are evaluated.
    pub(super) fn is_at_kink(&self, point: &Point) -> bool {
        const NEAR: f64 = 1e-9;
        let near = NEAR * self.duration() + 4.0 * f64::EPSILON * point.time.abs();
        let at = |time: f64| self.branches(&Point { time, ..point.clone() });
        at(point.time - near) != at(point.time + near)
    }

    /// Returns y' at a point.
    pub(super) fn rate(&self, point: &Point) -> Vec<f64> {
        let mut rate = vec![0.0; point.state.len()];
        self.simulator.rate(point.time, &point.state, &point.parameters, &mut rate);
        rate
    }

    /// Returns the duration of the run \[s\].
    pub(super) fn duration(&self) -> f64 {
        match self.run.times.as_slice() {
            [first, .., last] => last - first,
            _ => f64::NAN,
        }
    }

    /// Returns converged runs, computed on first use.
    pub(super) fn references(&self) -> &References {
        self.references.get_or_init(|| References::of(self))
    }
}

/// Returns the range of a state in a run, and at most its scale; its scale if it stays, or moves by
/// no more than `nothing` of it.
pub(super) fn size(
    simulator: &dyn Simulator<f64>,
    index: usize,
    values: &[f64],
    nothing: f64,
) -> f64 {
    let scale = simulator.state_scale(index);
    let least = values.iter().copied().fold(f64::INFINITY, f64::min);
    let greatest = values.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    let far = greatest - least;
    // A state that moves by less than the tolerance counts as constant, such as one that a
    // constraint holds at zero, or one that starts at rest.
    let stays = far <= f64::max(1e-9 * greatest.abs().max(least.abs()), nothing * scale);
    if stays { scale } else { far.min(scale) }
}

/// Returns the point projected onto the constraints; `None` if that fails.
fn on_constraints(simulator: &dyn Simulator<f64>, point: Point) -> Option<Point> {
    let Point { time, mut state, parameters } = point;
    if let Some(constraints) = Constraints::of(simulator, &parameters) {
        for level in [Level::Positions, Level::Velocities] {
            constraints.put_back(level, time, &mut state).ok()?;
        }
    }
    Some(Point { time, state, parameters })
}

//! Branches of periodic motions over a parameter, by pseudo-arclength continuation.
//!
//! A step predicts along the tangent of the branch and corrects at right angles to it, so that the
//! parameter may turn back at folds. Lengths are measured with the greatest ranges of the states over
//! the motions so far, the logarithm of the period, and the range of the parameter.
//!
//! H. Keller, Numerical solution of bifurcation and nonlinear eigenvalue problems, 1977; R. Seydel,
//! Practical Bifurcation and Stability Analysis, chapters 4 and 7.

use nalgebra::{DMatrix, DVector};
use serde::Serialize;

use super::equations::{Guess, Problem};
use super::error::CycleError;
use super::locate::Watched;
use super::newton::{Side, Solution, shortest, solve_beside};
use super::{Cycle, CycleSettings, finished, first, problem};
use crate::simulate::Simulation;

/// Maximum number of points of a branch.
pub const MAX_POINTS: usize = 100_000;

/// Cosine of the angle between tangents, or between a tangent and the way to the next place, below
/// which a step is repeated with half its length.
const STRAIGHT: f64 = 0.9;
/// Share of the scale of a state that its range counts at least.
const LEAST_RANGE: f64 = 1e-3;

/// Settings of a continuation.
#[derive(Debug, Clone, PartialEq)]
pub struct BranchSettings {
    /// Search for the first motion, at `from`.
    pub cycle: CycleSettings,
    /// Name of the parameter.
    pub parameter: String,
    /// Value at which the branch begins.
    pub from: f64,
    /// Value up to which it is followed; it also ends where it returns to `from`.
    pub to: f64,
    /// Longest step, as a share of the range from `from` to `to`.
    pub longest_step: f64,
    /// Maximum number of points.
    pub max_points: usize,
}

/// A branch of periodic motions.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Branch {
    /// Name of the parameter.
    pub parameter: String,
    /// Its unit.
    pub unit: String,
    /// Motions in the order of the branch, with the bifurcations among them.
    pub points: Vec<BranchPoint>,
    /// Reason why the branch ends.
    pub end: String,
    /// True if the branch reached an end of the range, or its own start.
    pub is_complete: bool,
}

/// A motion of a branch.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct BranchPoint {
    /// Value of the parameter.
    pub value: f64,
    /// Bifurcation that was located here.
    pub bifurcation: Option<Bifurcation>,
    /// Guard that is grazed here: the name of its event in backticks, or a comparison in the rate.
    pub grazed: Option<String>,
    /// The motion.
    pub cycle: Cycle,
}

/// Bifurcation of periodic motions.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Bifurcation {
    /// The branch turns back: a multiplier passes +1.
    Fold,
    /// A multiplier passes +1 and the branch does not turn: it meets another one, such as where a
    /// symmetry breaks.
    BranchPoint,
    /// The period doubles: a multiplier passes -1.
    Flip,
    /// A second frequency arises: a complex pair of multipliers passes the unit circle.
    NeimarkSacker,
    /// Multipliers jump, and the branch goes on.
    Jump,
    /// The motion touches a guard, so that an event begins or ceases to happen.
    Grazing,
    /// The branch turns back with a corner: modes change, and multipliers jump.
    NonsmoothFold,
    /// Other events happen in a period, or in another order, without grazing: a friction begins to
    /// stick, or two events change places.
    Events,
}

impl Bifurcation {
    /// Returns the usual name.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Fold => "fold",
            Self::BranchPoint => "branch point",
            Self::Flip => "flip",
            Self::NeimarkSacker => "Neimark-Sacker",
            Self::Jump => "jump",
            Self::Grazing => "grazing",
            Self::NonsmoothFold => "nonsmooth fold",
            Self::Events => "other events",
        }
    }
}

impl Branch {
    /// Creates a branch over a parameter without points.
    pub(super) fn empty(run: &Simulation<'_>, index: usize) -> Self {
        let parameter = run.simulator().parameter(index);
        Self {
            parameter: parameter.name.to_owned(),
            unit: parameter.unit.to_owned(),
            points: Vec::new(),
            end: String::new(),
            is_complete: false,
        }
    }

    /// Returns the points at which bifurcations were located.
    pub fn bifurcations(&self) -> impl Iterator<Item = (Bifurcation, &BranchPoint)> {
        self.points.iter().filter_map(|point| Some((point.bifurcation?, point)))
    }
}

/// Point of the branch with its tangent.
pub(super) struct Place {
    pub(super) guess: Guess,
    pub(super) cycle: Cycle,
    pub(super) tangent: Tangent,
    /// Projections onto the constraints at the start of each segment, scaled.
    projections: Vec<DMatrix<f64>>,
    /// Derivatives of the end of each segment by its start, scaled.
    pub(super) transitions: Vec<DMatrix<f64>>,
    pub(super) iterations: usize,
}

impl Place {
    /// Returns the functions whose signs change at bifurcations.
    pub(super) fn watched(&self) -> Watched {
        Watched::of(&self.cycle, self.tangent.value)
    }

    /// Returns the same place with another tangent.
    pub(super) fn turned(&self, tangent: Tangent) -> Self {
        Self {
            guess: self.guess.clone(),
            cycle: self.cycle.clone(),
            tangent,
            projections: self.projections.clone(),
            transitions: self.transitions.clone(),
            iterations: self.iterations,
        }
    }
}

/// Direction of the branch: states over their scales, logarithm of the period, parameter over its
/// range.
///
/// Directions that constraints exclude do not count: initial values along them change nothing, and
/// equations across them would leave the branch where it is.
#[derive(Clone)]
pub(super) struct Tangent {
    pub(super) states: DVector<f64>,
    /// Slopes of a length along the tangent by the states: weighted, on the constraints.
    pub(super) normal: DVector<f64>,
    pub(super) period: f64,
    pub(super) value: f64,
}

impl Tangent {
    pub(super) fn times(&self, factor: f64) -> Self {
        Self {
            states: &self.states * factor,
            normal: &self.normal * factor,
            period: self.period * factor,
            value: self.value * factor,
        }
    }
}

/// A continuation under way.
pub(super) struct Walk<'a> {
    pub(super) problem: Problem<'a>,
    points: usize,
    /// Weights of squares of the states over their scales.
    pub(super) weights: DVector<f64>,
    /// Range of the parameter.
    range: f64,
    most: usize,
}

/// Follows a branch of periodic motions over a parameter.
///
/// A run that is interrupted ends the branch, with the points until then.
///
/// # Errors
/// [`CycleError`] if a setting is invalid or no motion is found at `from`.
pub fn branch(run: &Simulation<'_>, settings: &BranchSettings) -> Result<Branch, CycleError> {
    check(settings)?;
    let index = run.parameter_index(&settings.parameter)?;
    let BranchSettings { from, to, .. } = *settings;
    let run = run.clone().parameter_at(index, from);
    let mut problem = problem(&run, &settings.cycle)?;
    problem.varied = Some(index);
    let solution = first(&problem, &settings.cycle)?;
    let mut walk = Walk::new(problem, settings);
    let start = walk.start(solution, (to - from).signum())?;
    Ok(walk.follow(start, settings, Branch::empty(&run, index)))
}

pub(super) fn check(settings: &BranchSettings) -> Result<(), CycleError> {
    let BranchSettings { from, to, longest_step, max_points, .. } = settings;
    let bad = |what: String| Err(CycleError::BadSetting(what));
    if !(from.is_finite() && to.is_finite()) || from.to_bits() == to.to_bits() {
        return bad(format!("a branch from {from} to {to} has no length"));
    }
    if !(*longest_step > 0.0 && *longest_step <= 1.0) {
        return bad(format!("the longest step is {longest_step}, but must be above 0, at most 1"));
    }
    if !(2..=MAX_POINTS).contains(max_points) {
        return bad(format!("{max_points} points: a branch has 2 to {MAX_POINTS} of them"));
    }
    Ok(())
}

impl<'a> Walk<'a> {
    pub(super) fn new(problem: Problem<'a>, settings: &BranchSettings) -> Self {
        let BranchSettings { from, to, cycle, .. } = settings;
        let count = problem.segments * problem.free.len();
        Self {
            problem,
            points: cycle.points,
            weights: DVector::from_element(count, f64::INFINITY),
            range: (to - from).abs(),
            most: cycle.max_iterations,
        }
    }
}

impl Walk<'_> {
    /// Returns the first place, with a tangent towards the end of the range.
    fn start(&mut self, solution: Solution, sign: f64) -> Result<Place, CycleError> {
        let cycle = self.cycle(&solution)?;
        self.measure(&cycle);
        let zero = || DVector::zeros(self.weights.len());
        let along = Tangent { states: zero(), normal: zero(), period: 0.0, value: sign };
        let tangent = self.tangent(&solution, &along);
        Ok(self.place(solution, cycle, tangent))
    }

    pub(super) fn place(&self, solution: Solution, cycle: Cycle, tangent: Tangent) -> Place {
        let projections = self.projections(&solution);
        let Solution { guess, iterations, shots, .. } = solution;
        let transitions = shots.iter().map(|shot| self.problem.scaled(&shot.transition)).collect();
        Place { guess, cycle, tangent, projections, transitions, iterations }
    }

    /// Widens the measure of lengths to the ranges of a motion.
    pub(super) fn measure(&mut self, cycle: &Cycle) {
        let n = self.problem.free.len();
        let count = self.weights.len();
        let rows = super::rows(&cycle.motion);
        for (at, (state, scale)) in self.problem.free.iter().zip(&self.problem.scales).enumerate() {
            let values = rows.iter().map(|row| row[*state]);
            let (least, greatest) = values
                .fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), value| {
                    (a.min(value), b.max(value))
                });
            // A state that keeps its value within a period, as the speed of a drive, is measured by
            // that value.
            let (range, size) = (greatest - least, greatest.abs().max(least.abs()));
            let moves = range > LEAST_RANGE * scale.max(size);
            let weight = scale / (if moves { range } else { size }).max(LEAST_RANGE * scale);
            for place in (at..count).step_by(n) {
                self.weights[place] = self.weights[place].min(weight * weight / count as f64);
            }
        }
    }

    /// Widens the measure to the motion of a place, whose tangent is scaled to it.
    pub(super) fn remeasure(&mut self, place: &mut Place) {
        self.measure(&place.cycle);
        let tangent = self.scaled(place.tangent.clone(), &place.projections);
        place.tangent = tangent;
    }

    pub(super) fn cycle(&self, solution: &Solution) -> Result<Cycle, CycleError> {
        finished(&self.problem, solution, self.points)
    }

    /// Returns the scalar product of two directions.
    pub(super) fn product(&self, a: &Tangent, b: &Tangent) -> f64 {
        let states = a.states.iter().zip(&b.states).zip(&self.weights);
        let states: f64 = states.map(|((a, b), weight)| a * b * weight).sum();
        states + a.period * b.period + a.value * b.value
    }

    /// Returns whether a step is nearly straight: the tangents at its ends, and the way between them.
    pub(super) fn is_straight(&self, place: &Place, next: &Place, length: f64) -> bool {
        let cosine = self.product(&place.tangent, &next.tangent);
        cosine > STRAIGHT && length > STRAIGHT * self.distance(&place.guess, &next.guess)
    }

    fn distance(&self, a: &Guess, b: &Guess) -> f64 {
        let n = self.problem.free.len();
        let mut square = (a.period / b.period).ln().powi(2);
        square += ((a.value - b.value) / self.range).powi(2);
        for (segment, (node, other)) in a.nodes.iter().zip(&b.nodes).enumerate() {
            for (at, (state, scale)) in
                self.problem.free.iter().zip(&self.problem.scales).enumerate()
            {
                let change = (node[*state] - other[*state]) / scale;
                square += self.weights[segment * n + at] * change * change;
            }
        }
        square.sqrt()
    }

    /// Returns the tangent of the branch that forms an acute angle with another direction.
    pub(super) fn tangent(&self, solution: &Solution, along: &Tangent) -> Tangent {
        let linear = self.problem.linear(&solution.guess, &solution.shots);
        let n = linear.residual.len();
        let has_period = linear.by_period.is_some();
        let size = n + usize::from(has_period) + 1;
        let mut matrix = DMatrix::zeros(size, size);
        matrix.view_mut((0, 0), (n, n)).copy_from(&linear.matrix);
        if let Some((column, phase)) = &linear.by_period {
            matrix.view_mut((0, n), (n, 1)).copy_from(column);
            matrix.view_mut((n, 0), (1, n)).copy_from(&phase.transpose());
        }
        if let Some(column) = &linear.by_parameter {
            matrix.view_mut((0, size - 1), (n, 1)).copy_from(&(column * self.range));
        }
        let projections = self.projections(solution);
        let normal = across(&projections, &along.normal);
        matrix.view_mut((size - 1, 0), (1, n)).copy_from(&normal.transpose());
        if has_period {
            matrix[(size - 1, n)] = along.period;
        }
        matrix[(size - 1, size - 1)] = along.value;
        let mut right = DVector::zeros(size);
        right[size - 1] = 1.0;
        let solved = shortest(matrix, &right, self.problem.run.relative_tolerance());
        let tangent = Tangent {
            states: onto(&projections, &solved.rows(0, n).into_owned()),
            normal: DVector::zeros(n),
            period: if has_period { solved[n] } else { 0.0 },
            value: solved[size - 1],
        };
        let length = self.product(&tangent, &tangent);
        if length.is_finite() && length > 0.0 {
            self.scaled(tangent, &projections)
        } else {
            along.clone()
        }
    }

    /// Scales a tangent to length 1, with its normal.
    pub(super) fn scaled(&self, mut tangent: Tangent, projections: &[DMatrix<f64>]) -> Tangent {
        let length = self.product(&tangent, &tangent).sqrt();
        tangent.states /= length;
        tangent.period /= length;
        tangent.value /= length;
        tangent.normal = across(projections, &tangent.states.component_mul(&self.weights));
        tangent
    }

    pub(super) fn projections(&self, solution: &Solution) -> Vec<DMatrix<f64>> {
        solution.shots.iter().map(|shot| self.problem.scaled(&shot.projection)).collect()
    }

    /// Returns the direction from one guess to another at some length, with the components of a
    /// tangent along period and parameter.
    pub(super) fn direction(
        &self,
        (from, to): (&Guess, &Guess),
        length: f64,
        &Tangent { period, value, .. }: &Tangent,
    ) -> Tangent {
        let n = self.problem.free.len();
        let states = DVector::from_fn(self.weights.len(), |at, _| {
            let (node, state) = (at / n, self.problem.free[at % n]);
            let change = to.nodes[node][state] - from.nodes[node][state];
            change / (self.problem.scales[at % n] * length)
        });
        Tangent { normal: states.component_mul(&self.weights), states, period, value }
    }

    /// Returns the guess at some length along the tangent.
    pub(super) fn predicted(&self, place: &Place, length: f64) -> Guess {
        let Place { guess, tangent, .. } = place;
        let n = self.problem.free.len();
        let mut nodes = guess.nodes.clone();
        for (segment, node) in nodes.iter_mut().enumerate() {
            for (at, (state, scale)) in
                self.problem.free.iter().zip(&self.problem.scales).enumerate()
            {
                node[*state] += length * scale * tangent.states[segment * n + at];
            }
        }
        Guess {
            nodes,
            period: guess.period * (length * tangent.period).exp(),
            skipped: guess.skipped,
            value: guess.value + length * tangent.value * self.range,
        }
    }

    /// Returns the place on the branch at right angles to the tangent, at some length along it.
    pub(super) fn at(&self, place: &Place, length: f64) -> Result<Place, CycleError> {
        let predicted = self.predicted(place, length);
        let side = |guess: &Guess| Some(self.across(&place.tangent, &predicted, guess));
        self.corrected(place, predicted.clone(), &side)
    }

    /// Returns the place on the branch at a value of the parameter.
    pub(super) fn at_value(
        &self,
        place: &Place,
        length: f64,
        value: f64,
    ) -> Result<Place, CycleError> {
        let mut predicted = self.predicted(place, length);
        predicted.value = value;
        let n = self.weights.len();
        let side = |guess: &Guess| {
            Some(Side {
                residual: (guess.value - value) / self.range,
                states: DVector::zeros(n),
                period: 0.0,
                value: 1.0,
                range: self.range,
            })
        };
        self.corrected(place, predicted, &side)
    }

    fn corrected(
        &self,
        place: &Place,
        predicted: Guess,
        side: &dyn Fn(&Guess) -> Option<Side>,
    ) -> Result<Place, CycleError> {
        let solution = solve_beside(&self.problem, predicted, self.most, side)?;
        let tangent = self.tangent(&solution, &place.tangent);
        let cycle = self.cycle(&solution)?;
        Ok(self.place(solution, cycle, tangent))
    }

    /// Returns the equation of the plane across a tangent through a point.
    fn across(&self, tangent: &Tangent, through: &Guess, guess: &Guess) -> Side {
        let n = self.problem.free.len();
        let slopes = tangent.normal.clone();
        let mut residual = tangent.period * (guess.period / through.period).ln();
        residual += tangent.value * (guess.value - through.value) / self.range;
        for (segment, (node, other)) in guess.nodes.iter().zip(&through.nodes).enumerate() {
            for (at, (state, scale)) in
                self.problem.free.iter().zip(&self.problem.scales).enumerate()
            {
                residual += slopes[segment * n + at] * (node[*state] - other[*state]) / scale;
            }
        }
        let Tangent { period, value, .. } = *tangent;
        Side { residual, states: slopes, period, value, range: self.range }
    }
}

/// Projects the states of each segment onto the constraints at its start.
fn onto(projections: &[DMatrix<f64>], states: &DVector<f64>) -> DVector<f64> {
    by_segment(projections, states, |projection, part| projection * part)
}

/// Maps slopes by projected states to slopes by the states of each segment.
fn across(projections: &[DMatrix<f64>], slopes: &DVector<f64>) -> DVector<f64> {
    by_segment(projections, slopes, |projection, part| projection.transpose() * part)
}

fn by_segment(
    projections: &[DMatrix<f64>],
    states: &DVector<f64>,
    map: impl Fn(&DMatrix<f64>, DVector<f64>) -> DVector<f64>,
) -> DVector<f64> {
    let mut mapped = DVector::zeros(states.len());
    for (segment, projection) in projections.iter().enumerate() {
        let n = projection.nrows();
        let part = states.rows(segment * n, n).into_owned();
        mapped.rows_mut(segment * n, n).copy_from(&map(projection, part));
    }
    mapped
}

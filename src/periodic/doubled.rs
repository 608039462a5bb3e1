//! Branches of twice the period, which begin at flips.
//!
//! At a flip a multiplier is -1: a small disturbance along its eigenvector v changes its sign in each
//! period. Motions of twice the period leave the branch along it, `x(t_0) = x_0 + a v` and
//! `x(t_0 + T) = x_0 - a v` to first order. The first step solves for one of them at right angles to
//! v at some distance a, where there is no motion of the single period.
//!
//! R. Seydel, Practical Bifurcation and Stability Analysis, section 7.4.

use nalgebra::DVector;

use super::branch::{
    Bifurcation, Branch, BranchPoint, BranchSettings, Place, Tangent, Walk, branch, check,
};
use super::equations::{Guess, Period};
use super::error::CycleError;
use super::follow::first_lengths;
use super::newton::Solution;
use super::{Crossing, Multiplier, guess, problem};
use crate::simulate::Simulation;

impl BranchSettings {
    /// Returns the settings of the branches of twice the period.
    #[must_use]
    pub fn doubled(&self) -> Self {
        let mut doubled = self.clone();
        // An unknown period is solved for, and doubles by its first guess.
        if !matches!(self.cycle.period, super::Period::Unknown(_)) {
            doubled.cycle.multiple *= 2;
        }
        doubled.cycle.turns.iter_mut().for_each(|(_, turns)| *turns *= 2.0);
        doubled
    }
}

/// Follows the branch of twice the period that begins at a flip, until it leaves the range of the
/// settings, which are those of the branch of the flip. The flip is its first point.
///
/// # Errors
/// [`CycleError`] if the point is no flip, or no motion of twice the period is found beside it.
pub fn doubled(
    run: &Simulation<'_>,
    settings: &BranchSettings,
    flip: &BranchPoint,
) -> Result<Branch, CycleError> {
    check(settings)?;
    let Some(multiplier) = of_flip(flip) else {
        let what = format!("the period does not double at {} = {}", settings.parameter, flip.value);
        return Err(CycleError::BadSetting(what));
    };
    let settings = settings.doubled();
    let index = run.parameter_index(&settings.parameter)?;
    let run = run.clone().parameter_at(index, flip.value);
    let mut problem = problem(&run, &settings.cycle)?;
    problem.varied = Some(index);
    let (start, period) = (flip.cycle.start, 2.0 * flip.cycle.period);
    let guess = Guess {
        nodes: vec![flip.cycle.state.clone()],
        period,
        skipped: if flip.cycle.is_forced { (start - problem.origin) / period } else { 0.0 },
        value: flip.value,
    };
    let guess = guess::moved_by(&problem, guess, 0.0)?;
    let shots = problem.shots(&guess)?;
    let residual = problem.largest_gap(&shots).0;
    let mut walk = Walk::new(problem, &settings);
    let corner = walk.leaving(Solution { guess, shots, residual, iterations: 0 }, multiplier)?;
    let first = walk.first_doubled(&corner, settings.longest_step)?;
    let found = Branch { points: vec![flip.clone()], ..Branch::empty(&run, index) };
    Ok(walk.follow(first, &settings, found))
}

/// Follows a branch, then the branches of twice the period that begin at its flips, and so on,
/// `count` times. Branches of twice the period come in the order of their flips. A flip at which none
/// is found has a branch of itself alone, whose end tells why.
///
/// # Errors
/// As for [`branch`].
pub fn doublings(
    run: &Simulation<'_>,
    settings: &BranchSettings,
    count: u32,
) -> Result<Vec<Branch>, CycleError> {
    let mut found = vec![branch(run, settings)?];
    let (mut settings, mut first) = (settings.clone(), 0);
    for _ in 0..count {
        let flips = found[first..].iter().flat_map(|branch| branch.points.iter().skip(1));
        let flips = flips.filter(|point| point.bifurcation == Some(Bifurcation::Flip));
        let of_flip = |flip: &BranchPoint| {
            doubled(run, &settings, flip).unwrap_or_else(|error| Branch {
                points: vec![flip.clone()],
                end: error.to_string(),
                is_complete: false,
                ..found[0].clone()
            })
        };
        let more: Vec<_> = flips.map(of_flip).collect();
        first = found.len();
        found.extend(more);
        settings = settings.doubled();
    }
    Ok(found)
}

/// Returns the multiplier that is nearest to -1, if the point is a flip.
fn of_flip(point: &BranchPoint) -> Option<&Multiplier> {
    let all = point.cycle.nontrivial().filter(|one| one.crossing == Crossing::Flip);
    let nearest = all.min_by(|a, b| (a.real + 1.0).abs().total_cmp(&(b.real + 1.0).abs()));
    nearest.filter(|_| point.bifurcation == Some(Bifurcation::Flip))
}

impl Walk<'_> {
    /// Returns the place of a flip, with the eigenvector of -1 as its tangent.
    fn leaving(
        &mut self,
        solution: Solution,
        multiplier: &Multiplier,
    ) -> Result<Place, CycleError> {
        let cycle = self.cycle(&solution)?;
        self.measure(&cycle);
        let (free, scales) = (&self.problem.free, &self.problem.scales);
        let parts =
            free.iter().zip(scales).map(|(state, scale)| multiplier.vector[*state][0] / scale);
        let mut part = DVector::from_iterator(free.len(), parts);
        if self.problem.period == Period::Unknown {
            // The phase condition keeps the start across the motion.
            let (start, _) = self.problem.span_of(&solution.guess);
            let rate = self.problem.scaled_rate(&solution.guess, start, &solution.shots[0].start);
            part -= &rate * (rate.dot(&part) / rate.norm_squared());
        }
        let mut states = DVector::zeros(self.weights.len());
        for (segment, shot) in solution.shots.iter().enumerate() {
            states.rows_mut(segment * free.len(), free.len()).copy_from(&part);
            part = self.problem.scaled(&shot.transition) * part;
        }
        let normal = DVector::zeros(states.len());
        let tangent = Tangent { states, normal, period: 0.0, value: 0.0 };
        let tangent = self.scaled(tangent, &self.projections(&solution));
        Ok(self.place(solution, cycle, tangent))
    }

    /// Returns the first motion of twice the period beside a flip.
    fn first_doubled(&self, flip: &Place, longest: f64) -> Result<Place, CycleError> {
        let mut failed = None;
        for length in first_lengths(longest) {
            match self.at(flip, length) {
                Ok(next) if self.is_straight(flip, &next, length) => return Ok(next),
                Ok(_) => {}
                Err(error) if error.is_final() => return Err(error),
                Err(error) => failed = Some(error),
            }
        }
        Err(failed.unwrap_or_else(|| {
            let what =
                format!("no motion of twice the period leaves the flip at {}", flip.guess.value);
            CycleError::BadSetting(what)
        }))
    }
}

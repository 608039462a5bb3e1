//! Corners of a branch: places at which the events of a motion change, or its modes throughout.
//!
//! Beyond a corner the equations are other smooth functions. Their tangent comes from a shooting
//! that starts beyond the corner, along the tangent before it. The branch may leave the corner
//! either way along the new tangent, and only one of them leads beyond.
//!
//! M. di Bernardo, C. Budd, A. Champneys and P. Kowalczyk, Piecewise-smooth Dynamical Systems,
//! chapters 4 and 8.

use nalgebra::DMatrix;

use super::branch::{BranchSettings, Place, Walk};
use super::equations::Guess;
use super::error::CycleError;
use super::follow::{SHORTEST, first_lengths};
use super::newton::Solution;
use super::rows;
use crate::trajectory::Trajectory;

/// Number of times that the interval of a corner is halved after steps have become shortest.
const ROUNDS: usize = 16;
/// Lengths by which a shooting starts beyond a corner, over the longest step: decades from the
/// shortest step on, as a corner nearby may lie within the longer ones.
const OVERSHOOTS: [f64; 4] = [SHORTEST, 1e1 * SHORTEST, 1e2 * SHORTEST, 1e3 * SHORTEST];
/// Maximum number of shootings that determine the tangent beyond a corner. It ends those that
/// alternate between both sides.
const SHOOTINGS: usize = 12;
/// Cosine between two tangents that are taken for equal.
const SETTLED: f64 = 1.0 - 1e-10;
/// Number of times at which guards are sampled over a period.
const SAMPLES: usize = 4001;
/// Extremum of a guard, over its range in a period, that counts as zero. The parabola through three
/// samples h apart misses the extremum of cos(k t) by at most (k h)^4/32, so this is its error for a
/// wave of 85 periods.
const TOUCHES: f64 = 1e-5;

/// Events of a period in their order; those of one instant are one entry, sorted by name.
pub(super) fn events(motion: &Trajectory) -> Vec<Vec<String>> {
    let mut instants: Vec<(f64, Vec<String>)> = Vec::new();
    for switch in &motion.switches {
        match instants.last_mut() {
            Some((time, names)) if time.to_bits() == switch.time.to_bits() => {
                names.push(switch.event.clone());
            }
            _ => instants.push((switch.time, vec![switch.event.clone()])),
        }
    }
    let sorted = |(_, mut names): (f64, Vec<String>)| {
        names.sort_unstable();
        names
    };
    instants.into_iter().map(sorted).collect()
}

/// Returns whether two periods have the same events, from any start.
pub(super) fn same_events(a: &[Vec<String>], b: &[Vec<String>]) -> bool {
    let rotated = |by: usize| a.iter().cycle().skip(by).take(a.len()).eq(b.iter());
    a.len() == b.len() && (a.is_empty() || (0..a.len()).any(rotated))
}

/// Place beyond a corner.
pub(super) struct Beyond {
    pub(super) place: Place,
    /// Length of the step to it from the corner.
    pub(super) length: f64,
    /// True if the parameter turns back at the corner.
    pub(super) turns: bool,
}

impl Walk<'_> {
    /// Returns the last place found before a step fails, which lies at most this length ahead.
    pub(super) fn last_before(&self, place: &Place, length: f64) -> Option<Place> {
        let (mut low, mut high, mut last) = (0.0, length, None);
        for _ in 0..ROUNDS {
            let middle = 0.5 * (low + high);
            match self.at(place, middle) {
                Ok(next) if self.is_straight(place, &next, middle) => {
                    (low, last) = (middle, Some(next));
                }
                Err(error) if error.is_final() => return last,
                _ => high = middle,
            }
        }
        last
    }

    /// Returns the first place beyond a corner, if a branch goes on there within the range.
    ///
    /// # Errors
    /// The work was ended.
    pub(super) fn beyond(
        &self,
        corner: &Place,
        settings: &BranchSettings,
    ) -> Result<Option<Beyond>, CycleError> {
        for overshoot in OVERSHOOTS {
            for sign in [1.0, -1.0] {
                let Some((start, other)) = self.other_side(corner, sign, overshoot, settings)?
                else {
                    continue;
                };
                if let Some(beyond) = self.first_beyond(corner, &start, &other, settings)? {
                    return Ok(Some(beyond));
                }
            }
        }
        Ok(None)
    }

    /// Returns the corner with a tangent of the equations beyond it, and the motion there. The
    /// tangent is that of a shooting from a place along the tangent: the first one lies beyond the
    /// corner along the tangent before it, the next ones along what is found.
    fn other_side(
        &self,
        corner: &Place,
        sign: f64,
        overshoot: f64,
        settings: &BranchSettings,
    ) -> Result<Option<(Place, Other)>, CycleError> {
        let mut start = corner.turned(corner.tangent.times(1.0));
        let mut found = None;
        for round in 0..SHOOTINGS {
            let guess = self.predicted(&start, overshoot * settings.longest_step);
            let shots = match self.problem.shots(&guess) {
                Ok(shots) => shots,
                Err(error) if error.is_final() => return Err(error),
                Err(_) => return Ok(None),
            };
            let events = match self.motion_from(&guess, 2) {
                Ok(motion) => events(&motion),
                Err(error) if error.is_final() => return Err(error),
                Err(_) => return Ok(None),
            };
            let transitions =
                shots.iter().map(|shot| self.problem.scaled(&shot.transition)).collect();
            let started = Solution { guess, shots, residual: 0.0, iterations: 0 };
            let mut tangent = self.tangent(&started, &start.tangent);
            if round == 0 {
                tangent = tangent.times(sign);
            }
            let cosine = self.product(&tangent, &start.tangent);
            start = corner.turned(tangent);
            found = Some(Other { events, transitions });
            if round > 0 && cosine > SETTLED {
                break;
            }
        }
        // Back along the branch.
        let is_back = self.product(&start.tangent, &corner.tangent) < -SETTLED;
        Ok(found.filter(|_| !is_back).map(|other| (start, other)))
    }

    /// Returns the place at the longest possible first step from a corner along a new tangent.
    fn first_beyond(
        &self,
        corner: &Place,
        start: &Place,
        other: &Other,
        settings: &BranchSettings,
    ) -> Result<Option<Beyond>, CycleError> {
        let BranchSettings { from, to, longest_step: longest, .. } = *settings;
        for length in first_lengths(longest) {
            let next = match self.at(start, length) {
                Ok(next) => next,
                Err(error) if error.is_final() => return Err(error),
                Err(_) => continue,
            };
            let is_straight = self.is_straight(start, &next, length);
            let is_inside = (from.min(to)..=from.max(to)).contains(&next.guess.value);
            if is_straight && is_inside && other.has(corner, &next) {
                let turns = corner.tangent.value * next.tangent.value < 0.0;
                return Ok(Some(Beyond { place: next, length, turns }));
            }
        }
        Ok(None)
    }

    /// Returns the motion from a guess, which need not be periodic.
    fn motion_from(&self, guess: &Guess, points: usize) -> Result<Trajectory, CycleError> {
        let (start, period) = self.problem.span_of(guess);
        let run = self.problem.run_at(guess).shot_from(&guess.nodes[0]);
        Ok(run.from(start).until(start + period).points(points).run()?)
    }

    /// Returns the name of a guard that the motion touches without crossing it.
    pub(super) fn grazed(&self, place: &Place) -> Option<String> {
        let motion = self.motion_from(&place.guess, SAMPLES).ok()?;
        let run = self.problem.run_at(&place.guess);
        let (simulator, parameters) = (run.simulator(), run.parameter_values());
        let (events, kinks) = (simulator.events(), simulator.kinks());
        let mut guards: Vec<Vec<f64>> = Vec::with_capacity(motion.times.len());
        for (time, state) in motion.times.iter().zip(rows(&motion)) {
            let mut values = vec![0.0; events + kinks];
            if events > 0 {
                simulator.guards(*time, &state, parameters, &mut values[..events]);
            }
            if kinks > 0 {
                simulator.kink_guards(*time, &state, parameters, &mut values[events..]);
            }
            guards.push(values);
        }
        let touched = (0..events + kinks).find(|index| touches(&guards, *index))?;
        Some(if touched < events {
            format!("`{}`", simulator.event(touched).name)
        } else {
            "a comparison in the rate".to_owned()
        })
    }
}

/// Returns whether a guard has an extremum near zero between samples of one sign.
fn touches(guards: &[Vec<f64>], index: usize) -> bool {
    let values = || guards.iter().map(|row| row[index]);
    let range = values().fold(f64::NEG_INFINITY, f64::max) - values().fold(f64::INFINITY, f64::min);
    guards.windows(3).any(|three| {
        let [a, b, c] = [0, 1, 2].map(|at: usize| three[at][index]);
        let is_extremum = a * b > 0.0 && b * c > 0.0 && b.abs() <= a.abs() && b.abs() <= c.abs();
        if !is_extremum {
            return false;
        }
        // Of the parabola through the samples.
        let (slope, bend) = (0.5 * (c - a), a - 2.0 * b + c);
        let extremum = if bend == 0.0 { b } else { b - 0.5 * slope * slope / bend };
        extremum.abs() <= TOUCHES * range
    })
}

/// Motion from a start beyond a corner.
struct Other {
    events: Vec<Vec<String>>,
    transitions: Vec<DMatrix<f64>>,
}

impl Other {
    /// Returns whether a place lies beyond the corner: by its events, if they differ there, else by
    /// its derivatives, which are continuous on each side.
    fn has(&self, corner: &Place, next: &Place) -> bool {
        let before = events(&corner.cycle.motion);
        let after = events(&next.cycle.motion);
        if !same_events(&before, &self.events) {
            return !same_events(&before, &after);
        }
        let distance = |a: &[DMatrix<f64>], b: &[DMatrix<f64>]| -> f64 {
            a.iter().zip(b).map(|(a, b)| (a - b).norm_squared()).sum()
        };
        distance(&next.transitions, &self.transitions)
            < distance(&next.transitions, &corner.transitions)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn periods_have_the_same_events_from_any_start() {
        let of = |names: &[&str]| -> Vec<Vec<String>> {
            names.iter().map(|name| vec![(*name).to_owned()]).collect()
        };
        assert!(same_events(&of(&["a", "b", "c"]), &of(&["c", "a", "b"])));
        assert!(!same_events(&of(&["a", "b", "c"]), &of(&["c", "b", "a"])));
        assert!(!same_events(&of(&["a"]), &of(&["a", "a"])));
        assert!(same_events(&[], &[]));
    }

    #[test]
    fn a_guard_touches_zero_at_an_extremum_of_one_sign() {
        let around = |offset: f64| -> Vec<Vec<f64>> {
            (-2000..=2000).map(|i| vec![1.0 + offset - (f64::from(i) * 1.57e-3).cos()]).collect()
        };
        assert!(touches(&around(1e-8), 0));
        assert!(!touches(&around(1e-3), 0));
        assert!(!touches(&around(-0.1), 0));
    }
}

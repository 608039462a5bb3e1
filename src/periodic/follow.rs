//! Steps along a branch, and its bifurcations.

use super::branch::{Bifurcation, Branch, BranchPoint, BranchSettings, Place, Walk};
use super::corner::Beyond;
use super::error::CycleError;
use super::locate::{Test, locate};
use super::newton::Solution;
use super::{Stability, guess};

/// First step, as a share of the longest one.
const FIRST: f64 = 0.2;
/// Factor by which a step grows after few of Newton's steps.
const GROWTH: f64 = 1.5;
/// Number of Newton's steps up to which the next step grows, and above which it shrinks.
const FEW: usize = 4;
const MANY: usize = 7;
/// Share of the longest step below which the continuation gives up.
pub(super) const SHORTEST: f64 = 1e-5;

/// Returns the lengths to try for the first step from a place that branches leave, each half of the
/// one before, down to the shortest step.
pub(super) fn first_lengths(longest: f64) -> impl Iterator<Item = f64> {
    let lengths = std::iter::successors(Some(FIRST), |share| Some(0.5 * share));
    lengths.take_while(|share| *share >= SHORTEST).map(move |share| share * longest)
}

impl Walk<'_> {
    /// Takes steps until the branch leaves the range, or a step fails at any length and no branch
    /// goes on beyond the corner there.
    pub(super) fn follow(
        &mut self,
        mut place: Place,
        settings: &BranchSettings,
        mut found: Branch,
    ) -> Branch {
        let BranchSettings { longest_step: longest, max_points, .. } = *settings;
        let mut length = FIRST * longest;
        let (mut is_at_corner, mut is_moved) = (false, false);
        found.points.push(point(&place, None));
        while found.points.len() < max_points {
            let (next, is_last) = match self.step(&place, &mut length, settings) {
                Ok(Some(next)) => next,
                Err(error) if error.is_final() => {
                    found.end = error.to_string();
                    return found;
                }
                failed => {
                    if !is_moved && let Some(moved) = self.moved_from_events(&place, length) {
                        is_moved = true;
                        place = moved;
                        length = FIRST * longest;
                        continue;
                    }
                    let reason = failed.err().map_or_else(
                        || format!("{} = {}: a corner", settings.parameter, place.guess.value),
                        |error| error.to_string(),
                    );
                    if is_at_corner {
                        found.end = reason;
                        return found;
                    }
                    match self.turn(&place, length, settings, &mut found) {
                        Ok(beyond) => {
                            is_at_corner = true;
                            length = beyond.length;
                            place = beyond.place;
                            self.remeasure(&mut place);
                            continue;
                        }
                        Err(graze) => {
                            found.end = graze.unwrap_or(reason);
                            return found;
                        }
                    }
                }
            };
            (is_at_corner, is_moved) = (false, false);
            found.points.extend(self.located(&place, &next, length));
            found.points.push(point(&next, None));
            if is_last {
                found.end = format!("{} = {}", settings.parameter, next.guess.value);
                found.is_complete = true;
                return found;
            }
            if next.iterations <= FEW {
                length = (length * GROWTH).min(longest);
            } else if next.iterations > MANY {
                length /= GROWTH;
            }
            place = next;
            self.remeasure(&mut place);
        }
        found.end = format!("the limit of {max_points} points is reached");
        found
    }

    /// Returns the same motion with a start away from events: one that passes the start, as impacts
    /// do along a branch, would end it. Nothing if the start is away from them. `length` is that of
    /// the last step.
    fn moved_from_events(&self, place: &Place, length: f64) -> Option<Place> {
        /// Share of the last step, back along the tangent to a motion that gives the direction. The
        /// error of the direction is of this order, and it only orients the tangent.
        const BACK: f64 = 0.1;
        let back = BACK * length;
        let share = guess::share_without_events(&self.problem, &place.guess).ok()?;
        if share == 0.0 {
            return None;
        }
        let moved = |guess| guess::moved_by(&self.problem, guess, share).ok();
        let guess = moved(place.guess.clone())?;
        let behind = moved(self.predicted(place, -back))?;
        let along = self.direction((&behind, &guess), back, &place.tangent);
        let shots = self.problem.shots(&guess).ok()?;
        let residual = self.problem.largest_gap(&shots).0;
        let solution = Solution { guess, shots, residual, iterations: place.iterations };
        let tangent = self.tangent(&solution, &along);
        let cycle = self.cycle(&solution).ok()?;
        Some(self.place(solution, cycle, tangent))
    }

    /// Returns the bifurcations in a step.
    fn located(&self, place: &Place, next: &Place, length: f64) -> Vec<BranchPoint> {
        let mut found: Vec<BranchPoint> = Vec::new();
        for test in Test::between(&place.watched(), &next.watched()) {
            let Some((located, kind)) = locate(self, place, length, test) else { continue };
            // Where events change, multipliers may jump.
            let is_known = kind == Bifurcation::Jump
                && found.iter().any(|point| {
                    matches!(point.bifurcation, Some(Bifurcation::Grazing | Bifurcation::Events))
                });
            if !is_known {
                found.push(self.point_of(&located, kind));
            }
        }
        found
    }

    /// Locates the corner at which steps fail, and goes on beyond it.
    ///
    /// # Errors
    /// No branch goes on: the guard that is grazed at the corner, if there is one.
    fn turn(
        &self,
        place: &Place,
        length: f64,
        settings: &BranchSettings,
        found: &mut Branch,
    ) -> Result<Beyond, Option<String>> {
        let last = self.last_before(place, length);
        let corner = last.as_ref().unwrap_or(place);
        let beyond = self.beyond(corner, settings).ok().flatten();
        let kind = match &beyond {
            Some(Beyond { turns: true, .. }) => Bifurcation::NonsmoothFold,
            _ => Bifurcation::Jump,
        };
        let mut located = self.point_of(corner, kind);
        located.grazed = self.grazed(corner);
        if located.grazed.is_some() {
            located.bifurcation = Some(Bifurcation::Grazing);
        }
        let end = located.grazed.as_ref().map(|guard| {
            let BranchSettings { parameter, .. } = settings;
            format!("{parameter} = {}: the motion grazes {guard}", located.value)
        });
        let is_named = beyond.is_some() || located.grazed.is_some();
        if is_named {
            found.points.push(located);
        }
        let beyond = beyond.ok_or(end)?;
        found.points.push(point(&beyond.place, None));
        Ok(beyond)
    }

    /// Returns a point at which a bifurcation was located.
    fn point_of(&self, place: &Place, kind: Bifurcation) -> BranchPoint {
        let mut located = point(place, Some(kind));
        if kind == Bifurcation::Events {
            located.grazed = self.grazed(place);
            if located.grazed.is_some() {
                located.bifurcation = Some(Bifurcation::Grazing);
            }
        }
        located
    }

    /// Takes one step, halved until Newton's method converges and the branch bends little. Returns
    /// the next place, and whether it is at an end of the range; nothing if the branch bends in a
    /// shortest step.
    fn step(
        &self,
        place: &Place,
        length: &mut f64,
        settings: &BranchSettings,
    ) -> Result<Option<(Place, bool)>, CycleError> {
        let BranchSettings { from, to, longest_step: longest, .. } = *settings;
        let shortest = SHORTEST * longest;
        let next = loop {
            match self.at(place, *length) {
                Ok(next) => {
                    if self.is_straight(place, &next, *length) {
                        break next;
                    }
                    if *length <= shortest {
                        return Ok(None);
                    }
                }
                Err(error) if error.is_final() || *length <= shortest => return Err(error),
                Err(_) => {}
            }
            *length *= 0.5;
        };
        if (from.min(to)..=from.max(to)).contains(&next.guess.value) {
            return Ok(Some((next, false)));
        }
        let end = next.guess.value.clamp(from.min(to), from.max(to));
        let share = (end - place.guess.value) / (next.guess.value - place.guess.value);
        *length *= share;
        Ok(Some((self.at_value(place, *length, end)?, true)))
    }
}

fn point(place: &Place, bifurcation: Option<Bifurcation>) -> BranchPoint {
    let mut cycle = place.cycle.clone();
    if bifurcation.is_some() {
        cycle.stability = Stability::Neutral;
    }
    BranchPoint { value: place.guess.value, bifurcation, grazed: None, cycle }
}

//! Location of bifurcations between two points of a branch, by the secant method with bisection.

use super::branch::{Bifurcation, Place, Walk};
use super::corner::{events, same_events};
use super::{Crossing, Cycle};

/// Maximum number of points computed for one bifurcation.
const ROUNDS: usize = 40;
/// Share of a step to which a bifurcation is located, unless its function vanishes before.
const SHARE: f64 = 1e-9;
/// Value of the functions that counts as zero.
const ZERO: f64 = 1e-8;
/// Value above which a change of sign is a jump.
const JUMPS: f64 = 1e-3;

/// Functions of a motion whose signs change at bifurcations.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Watched {
    /// Component of the tangent along the parameter.
    along: f64,
    /// Real multipliers above zero without the trivial one, descending.
    positive: Vec<f64>,
    /// Moduli of real multipliers below zero, descending.
    negative: Vec<f64>,
    /// Moduli of complex pairs, descending.
    complex: Vec<f64>,
    /// Events in a period.
    events: Vec<Vec<String>>,
}

impl Watched {
    pub(super) fn of(cycle: &Cycle, along: f64) -> Self {
        // Descending, as the multipliers are.
        let of = |crossing: Crossing| {
            let those = cycle.nontrivial().filter(move |one| one.crossing == crossing);
            those.filter(|one| one.imaginary >= 0.0).map(|one| one.modulus).collect()
        };
        Self {
            along,
            positive: of(Crossing::Fold),
            negative: of(Crossing::Flip),
            complex: of(Crossing::NeimarkSacker),
            events: events(&cycle.motion),
        }
    }

    fn moduli(&self, crossing: Crossing) -> &[f64] {
        match crossing {
            Crossing::Fold => &self.positive,
            Crossing::Flip => &self.negative,
            Crossing::NeimarkSacker => &self.complex,
        }
    }

    /// Returns the number of multipliers outside the unit circle.
    fn outside(&self, crossing: Crossing) -> usize {
        self.moduli(crossing).iter().filter(|modulus| **modulus > 1.0).count()
    }
}

/// Function whose sign changes between two points.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Test {
    /// The events in a period.
    Events,
    /// The direction of the parameter.
    Turn,
    /// The modulus of the multiplier of this rank among its kind, less 1.
    Leaves { crossing: Crossing, rank: usize },
}

impl Test {
    /// Returns the functions whose signs differ.
    pub(super) fn between(a: &Watched, b: &Watched) -> Vec<Self> {
        let mut tests = Vec::new();
        if !same_events(&a.events, &b.events) {
            tests.push(Self::Events);
        }
        let turns = a.along * b.along < 0.0;
        if turns {
            tests.push(Self::Turn);
        }
        for crossing in [Crossing::Fold, Crossing::Flip, Crossing::NeimarkSacker] {
            let (before, after) = (a.outside(crossing), b.outside(crossing));
            // At a fold a multiplier passes +1.
            let is_known = turns && crossing == Crossing::Fold && before.abs_diff(after) == 1;
            if before != after && !is_known {
                tests.push(Self::Leaves { crossing, rank: before.max(after) - 1 });
            }
        }
        tests
    }

    fn value(self, watched: &Watched) -> Option<f64> {
        match self {
            Self::Events => None,
            Self::Turn => Some(watched.along),
            Self::Leaves { crossing, rank } => {
                watched.moduli(crossing).get(rank).map(|modulus| modulus - 1.0)
            }
        }
    }

    fn kind(self) -> Bifurcation {
        match self {
            Self::Events => Bifurcation::Events,
            Self::Turn => Bifurcation::Fold,
            Self::Leaves { crossing: Crossing::Fold, .. } => Bifurcation::BranchPoint,
            Self::Leaves { crossing: Crossing::Flip, .. } => Bifurcation::Flip,
            Self::Leaves { crossing: Crossing::NeimarkSacker, .. } => Bifurcation::NeimarkSacker,
        }
    }

    /// Returns the kind where the function jumps over zero.
    fn kind_of_jump(self) -> Bifurcation {
        match self {
            Self::Events => Bifurcation::Events,
            Self::Turn => Bifurcation::NonsmoothFold,
            Self::Leaves { .. } => Bifurcation::Jump,
        }
    }

    /// Returns whether the function has not changed its sign. Where there is no such multiplier, it
    /// is inside the circle.
    fn is_same(self, before: &Watched, watched: &Watched) -> bool {
        if self == Self::Events {
            return same_events(&before.events, &watched.events);
        }
        let is_positive = |of: &Watched| self.value(of).is_some_and(|value| value > 0.0);
        is_positive(before) == is_positive(watched)
    }
}

/// Returns the place between the start and the end of a step at which a function changes its sign,
/// and the bifurcation there; `None` if no motion is found in between.
pub(super) fn locate(
    walk: &Walk<'_>,
    place: &Place,
    length: f64,
    test: Test,
) -> Option<(Place, Bifurcation)> {
    let end = walk.at(place, length).ok()?;
    let value = |place: &Place| test.value(&place.watched());
    let before = place.watched();
    let (mut a, mut b) = ((0.0, value(place)), (length, value(&end)));
    let (mut nearest, mut stuck, mut was_before) = (end, 0, None);
    let mut last_before = None;
    for _ in 0..ROUNDS {
        let middle = 0.5 * (a.0 + b.0);
        let secant = match (a.1, b.1) {
            // After two steps on one side the interval is halved.
            (Some(u), Some(v)) if stuck < 2 && u * v < 0.0 => (a.0 * v - b.0 * u) / (v - u),
            _ => middle,
        };
        let at = if secant > a.0 && secant < b.0 { secant } else { middle };
        let next = walk.at(place, at).ok()?;
        let here = value(&next);
        let is_before = test.is_same(&before, &next.watched());
        let is_zero = here.is_some_and(|here| here.abs() <= ZERO);
        if test == Test::Events && is_before {
            last_before = Some(next);
        } else {
            nearest = next;
        }
        stuck = if was_before == Some(is_before) { stuck + 1 } else { 1 };
        was_before = Some(is_before);
        if is_before {
            a = (at, here);
        } else {
            b = (at, here);
        }
        if is_zero || b.0 - a.0 <= SHARE * length {
            break;
        }
    }
    // Before the change, a guard that is grazed has one sign.
    let nearest = last_before.unwrap_or(nearest);
    let is_jump = value(&nearest).is_none_or(|here| here.abs() > JUMPS);
    let kind = if is_jump { test.kind_of_jump() } else { test.kind() };
    Some((nearest, kind))
}

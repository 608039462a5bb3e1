//! Mobility and redundant constraints.

use machinist_contract::Simulator;
use nalgebra::{DMatrix, DVector};

use super::lasting::REACH;
use super::{Constraints, Level, ROUNDING};
use crate::scales::beside;

/// Bound of the remainder of a row of length 1 that counts as rounding.
pub(super) const NOTHING: f64 = 1e-9;

/// Mobility of a constrained machine.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Mobility {
    /// Number of coordinates, n.
    pub coordinates: usize,
    /// Number of constraints that hold in the modes of the state, m.
    pub constraints: usize,
    /// Number of independent constraints: the rank of G.
    pub rank: usize,
    /// Redundant constraints.
    pub redundant: Vec<Redundant>,
}

/// A constraint that follows from others.
#[derive(Debug, Clone, PartialEq, Eq)]
#[expect(clippy::struct_excessive_bools, reason = "independent answers about one constraint")]
pub struct Redundant {
    /// Name of the constraint.
    pub constraint: String,
    /// True if it holds only in modes.
    pub in_modes: bool,
    /// True if it holds only in modes, and the constraints it repeats hold always.
    pub is_led: bool,
    /// Names of the constraints it repeats; none if no coordinate can change it.
    pub repeats: Vec<String>,
    /// True if it is at an extremum: no coordinate changes it at the state, but one does nearby.
    pub is_level: bool,
    /// True if the motion does not depend on the distribution of forces: it holds in modes, and
    /// none of them prescribes a motion. Its force is then 0, and the others carry all of it.
    pub is_shared: bool,
}

impl Mobility {
    /// Returns the mobility n minus the rank of G.
    #[must_use]
    pub fn by_rank(&self) -> usize {
        self.coordinates - self.rank
    }

    /// Returns Gruebler's count, n - m; negative if a machine has more constraints than
    /// coordinates.
    #[must_use]
    pub fn by_count(&self) -> i64 {
        self.coordinates as i64 - self.constraints as i64
    }
}

impl Redundant {
    /// Returns the reason for the redundancy, as a phrase for messages.
    #[must_use]
    pub fn why(&self) -> String {
        if self.is_level {
            return "is at an extremum: all its derivatives by coordinates are zero where it is \
                    fulfilled, so it has no effect"
                .to_owned();
        }
        if self.repeats.is_empty() {
            return "does not change with any coordinate".to_owned();
        }
        format!("says nothing that is new beside {}", quoted(&self.repeats))
    }

    /// Returns a hint on how to mend it.
    #[must_use]
    pub fn hint(&self) -> &'static str {
        match self {
            Self { is_level: true, .. } => {
                "write it so that it crosses zero: `phi` instead of `1 - cos(phi)`"
            }
            Self { repeats, .. } if repeats.is_empty() => "leave it out: nothing can fulfil it",
            _ => "the constraint forces are not unique; leave it out",
        }
    }

    /// Returns a sentence on which constraints carry the force where the motion does not determine
    /// it.
    #[must_use]
    pub fn shares(&self) -> String {
        let names = quoted(&self.repeats);
        let is_one = self.repeats.len() == 1;
        let carries = if is_one { "carries" } else { "carry" };
        format!(
            "`{}` holds what {} already: the motion is the same whoever carries the \
             force; {} {carries} all of it, `{}` none",
            self.constraint,
            if is_one { format!("{names} holds") } else { format!("{names} hold together") },
            names,
            self.constraint
        )
    }
}

/// Returns a list of names for messages.
pub(super) fn quoted(names: &[String]) -> String {
    names.iter().map(|name| format!("`{name}`")).collect::<Vec<_>>().join(", ")
}

/// Returns the mobility of a simulator at a state, \[q, q', z\]; `None` if it has no constraints.
#[must_use]
pub fn mobility(
    simulator: &dyn Simulator<f64>,
    parameters: &[f64],
    time: f64,
    state: &[f64],
) -> Option<Mobility> {
    let constraints = Constraints::of(simulator, parameters)?;
    let matrix = constraints.matrix(time, state);
    let Rows { kept, repeated } = rows(&constraints, &matrix, NOTHING);
    let (rank, all) = (kept.len(), kept.len() + repeated.len());
    let redundant = repeated.into_iter().map(|(row, line)| {
        let sources = sources(&kept, &line);
        let holds_in_modes = |row: usize| constraints.simulator.constraint(row).in_modes;
        let in_modes = holds_in_modes(row);
        let is_led = in_modes && !sources.iter().any(|row| holds_in_modes(*row));
        let is_shared = !sources.is_empty()
            && in_modes
            && sources
                .iter()
                .chain([&row])
                .all(|row| stands_still(&constraints, *row, time, state));
        let repeats = sources.iter().map(|row| constraints.name(*row).to_owned()).collect();
        let constraint = constraints.name(row).to_owned();
        let is_level = sources.is_empty() && changes_beside(&constraints, row, time, state);
        Redundant { constraint, in_modes, is_led, repeats, is_level, is_shared }
    });
    let (redundant, coordinates) = (redundant.collect(), constraints.coordinates);
    Some(Mobility { coordinates, constraints: all, rank, redundant })
}

/// Returns the rows of G that repeat others.
pub(super) fn repeated_rows(constraints: &Constraints<'_>, matrix: &DMatrix<f64>) -> Vec<usize> {
    let Rows { repeated, .. } = rows(constraints, matrix, NOTHING);
    repeated.into_iter().map(|(row, _)| row).collect()
}

/// Independent and redundant rows of G with their directions.
struct Rows {
    kept: Vec<(usize, DVector<f64>)>,
    repeated: Vec<(usize, DVector<f64>)>,
}

/// Returns the names of a constraint and of those it depends on, if a state is a change point: if rows
/// of G that are dependent or zero there are not at positions around it that fulfil all constraints.
pub(super) fn change_point(
    constraints: &Constraints<'_>,
    time: f64,
    state: &[f64],
) -> Option<(String, Vec<String>)> {
    /// Bound of remainders. Positions are solved for to a residual of 1e-13, so a change point, at which
    /// the residual is quadratic, is off by its root.
    const NEARLY: f64 = 1e-5;
    let Rows { kept, repeated: mut here } =
        rows(constraints, &constraints.matrix(time, state), NEARLY);
    here.retain(|(row, _)| !constraints.simulator.constraint(*row).in_modes);
    for place in 1..=2 {
        if here.is_empty() {
            break;
        }
        let near = beside(constraints.simulator, state, place, REACH);
        let there = constraints.fulfilled_but(&[], time, &near)?;
        let [near, there] = [near, there].map(|state| constraints.matrix(time, &state));
        let Rows { kept, .. } = rows(constraints, &there, NEARLY);
        let is_level = |row: usize| there.row(row).norm() <= NEARLY * near.row(row).norm();
        here.retain(|(row, _)| kept.iter().any(|(other, _)| other == row) && !is_level(*row));
    }
    let name = |row: usize| constraints.name(row).to_owned();
    let (row, line) = here.first()?;
    Some((name(*row), sources(&kept, line).into_iter().map(name).collect()))
}

/// Orthogonalizes the rows of G one after another; the number of remaining rows is the rank, and
/// rows without a remainder above `least` are redundant. Constraints that always hold come first,
/// then those that hold in modes, both in the order of the spec.
fn rows(constraints: &Constraints<'_>, matrix: &DMatrix<f64>, least: f64) -> Rows {
    /// The same bound for a constraint that holds in modes, by the accuracy of event times. A
    /// constraint with a smaller remainder would act with a huge force. The factorization for
    /// forces uses the same bound.
    const NEARLY: f64 = 1e-6;
    let scales = constraints.scales(Level::Positions);
    let mut basis: Vec<DVector<f64>> = Vec::new();
    let mut found = Rows { kept: Vec::new(), repeated: Vec::new() };
    let in_modes = |row: &usize| constraints.simulator.constraint(*row).in_modes;
    let (modal, always): (Vec<usize>, Vec<usize>) = (0..constraints.count).partition(in_modes);
    let scaled = |row: usize| DVector::from_fn(scales.len(), |i, _| matrix[(row, i)] * scales[i]);
    let longest = (0..constraints.count).map(|row| scaled(row).norm()).fold(0.0, f64::max);
    for row in always.into_iter().chain(modal) {
        let mut line = scaled(row);
        let mut length = line.norm();
        if length <= longest * if in_modes(&row) { ROUNDING } else { least } {
            line.fill(0.0);
            length = 0.0;
        }
        if length == 0.0 && constraints.simulator.constraint(row).in_modes {
            continue;
        }
        if length > 0.0 {
            line /= length;
        }
        let mut left = line.clone();
        // Two passes are enough (Kahan).
        for _ in 0..2 {
            for direction in &basis {
                left -= direction * direction.dot(&left);
            }
        }
        let rest = left.norm();
        if rest > if in_modes(&row) { NEARLY } else { least } {
            basis.push(left / rest);
            found.kept.push((row, line));
        } else {
            found.repeated.push((row, line));
        }
    }
    found
}

/// Returns whether coordinates change a constraint in positions near a state.
fn changes_beside(constraints: &Constraints<'_>, row: usize, time: f64, state: &[f64]) -> bool {
    let scales = constraints.scales(Level::Positions);
    [0.0137, -0.0071].into_iter().any(|shift| {
        let mut beside = state.to_vec();
        for (index, scale) in scales.iter().enumerate() {
            beside[index] += shift * scale * (1.0 + index as f64).sqrt();
        }
        let matrix = constraints.matrix(time, &beside);
        let least = NOTHING * matrix.amax();
        matrix.row(row).iter().any(|slope| slope.abs() > least)
    })
}

/// Returns whether a constraint is fulfilled at rest, now and at other times.
fn stands_still(constraints: &Constraints<'_>, row: usize, time: f64, state: &[f64]) -> bool {
    const PROBES: usize = 8;
    let simulator = constraints.simulator;
    let mut at_rest = state.to_vec();
    let first = constraints.first(Level::Velocities);
    at_rest[first..first + constraints.coordinates].fill(0.0);
    let run = simulator.run_defaults();
    let spread = |probe: usize| run.from + (run.until - run.from) * (probe as f64 * 0.618).fract();
    let mut times = (0..PROBES).map(spread).chain([time]);
    times.all(|time| constraints.residual(Level::Velocities, time, &at_rest)[row] == 0.0)
}

/// Returns the rows that a row depends on.
fn sources(kept: &[(usize, DVector<f64>)], line: &DVector<f64>) -> Vec<usize> {
    const SHARE: f64 = 1e-6;
    if kept.is_empty() || line.norm() == 0.0 {
        return Vec::new();
    }
    let columns: Vec<DVector<f64>> = kept.iter().map(|(_, row)| row.clone()).collect();
    let matrix = DMatrix::from_columns(&columns);
    let Ok(shares) = matrix.svd(true, true).solve(line, 1e-12) else { return Vec::new() };
    let made_of = kept.iter().zip(shares.iter()).filter(|(_, share)| share.abs() > SHARE);
    made_of.map(|((row, _), _)| *row).collect()
}

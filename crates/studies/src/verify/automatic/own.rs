//! Checks by the author of a machine: outputs or states against closed forms and data.

use machinist::{Simulation, Trajectory};

use super::Subject;
use crate::verify::Verdict;

/// A quantity of the run with its reference.
pub struct OwnCheck<'a> {
    /// Name of the check.
    pub name: &'a str,
    /// Name of the output or state.
    pub of: &'a str,
    /// Source of the reference.
    pub source: &'a str,
    /// Relative tolerance, as a fraction of the largest absolute value of the reference.
    pub tolerance: f64,
    /// Absolute tolerance in addition, in the unit of the quantity.
    pub absolute: Option<f64>,
    /// The reference.
    pub reference: OwnReference<'a>,
}

/// Function that returns values at times.
pub type OfTimes<'a> = Box<dyn Fn(&[f64]) -> Vec<f64> + 'a>;

/// Reference of a quantity.
pub enum OwnReference<'a> {
    /// A function of time with its text, evaluated at the times of the run.
    Function(&'a str, OfTimes<'a>),
    /// Times, increasing \[s\], and values.
    Values(&'a [[f64; 2]]),
}

/// Returns the run of a machine, with the times of all its values added.
pub(super) fn with_times<'a>(subject: &Subject<'a>) -> Simulation<'a> {
    let times = subject.own.iter().flat_map(|check| match &check.reference {
        OwnReference::Function(..) => &[][..],
        OwnReference::Values(rows) => rows,
    });
    let times: Vec<f64> = times.map(|[time, _]| *time).collect();
    subject.simulation.clone().also_at(&times)
}

/// Largest difference, its time, and the largest reference.
#[derive(Default)]
struct Difference {
    largest: f64,
    at: f64,
    value: f64,
    expected: f64,
    reference: f64,
    compared: usize,
}

impl OwnCheck<'_> {
    pub(super) fn verdict(&self, subject: &Subject<'_>, run: &Trajectory) -> Verdict {
        let scene = subject.simulation.simulator().name();
        let judged = match run.column(self.of) {
            None => self.failed(scene, format!("There is no output or state `{}`.", self.of)),
            Some(ours) => {
                let (times, reference) = self.reference_at(&run.times);
                let found = difference(run, ours, &times, &reference);
                self.judge(scene, &Difference { reference: self.size(&reference), ..found })
            }
        };
        Verdict {
            check: self.title().into(),
            reference: self.against().into(),
            tolerance: self.tolerance,
            reason: self.source.to_owned().into(),
            ..judged
        }
    }

    pub(super) fn title(&self) -> String {
        if self.name == self.of {
            self.name.to_owned()
        } else {
            format!("{} of {}", self.name, self.of)
        }
    }

    fn failed(&self, scene: &str, failure: String) -> Verdict {
        Verdict::judged(scene, f64::INFINITY, self.tolerance, Some(failure))
    }

    fn judge(&self, scene: &str, found: &Difference) -> Verdict {
        if found.compared == 0 {
            return Verdict::skipped(scene, "no value is within the run".to_owned());
        }
        if !found.expected.is_finite() {
            let failure = format!("The reference is not a finite number at {} s.", found.at);
            return self.failed(scene, failure);
        }
        let scale = found.reference + self.absolute.unwrap_or(0.0) / self.tolerance;
        if scale == 0.0 {
            let failure = "The reference is zero throughout: give `absolute`, the error that \
                           passes beside the tolerance.";
            return self.failed(scene, failure.to_owned());
        }
        let error = found.largest / scale;
        let passes = error <= self.tolerance;
        let failure = || {
            let (value, expected) = (found.value, found.expected);
            format!(
                "The machine or its reference is wrong, or the run too coarse. Worst at {} s: \
                 {value:.9e} for {expected:.9e}.",
                found.at
            )
        };
        Verdict {
            value: Some(found.value),
            expected: Some(found.expected),
            ..Verdict::judged(scene, error, self.tolerance, (!passes).then(failure))
        }
    }

    /// Returns times and values of the reference within the run.
    fn reference_at(&self, times: &[f64]) -> (Vec<f64>, Vec<f64>) {
        match &self.reference {
            OwnReference::Function(_, values) => (times.to_vec(), values(times)),
            OwnReference::Values(rows) => {
                let (from, until) = (times.first(), times.last());
                let is_within = |[time, _]: &&[f64; 2]| {
                    from.is_some_and(|from| from <= time) && until.is_some_and(|end| time <= end)
                };
                rows.iter().filter(is_within).map(|[time, value]| (*time, *value)).unzip()
            }
        }
    }

    /// Returns the largest absolute value of the reference; data beyond the run count too.
    fn size(&self, within: &[f64]) -> f64 {
        let size = |most: f64, value: &f64| most.max(value.abs());
        match &self.reference {
            OwnReference::Function(..) => within.iter().fold(0.0, size),
            OwnReference::Values(rows) => rows.iter().map(|[_, value]| value).fold(0.0, size),
        }
    }

    fn against(&self) -> String {
        match &self.reference {
            OwnReference::Function(text, _) => (*text).to_owned(),
            OwnReference::Values(rows) => format!("{} values", rows.len()),
        }
    }
}

/// Returns the largest difference, or the first reference that is not finite.
fn difference(run: &Trajectory, ours: &[f64], times: &[f64], reference: &[f64]) -> Difference {
    let mut found = Difference::default();
    for (time, expected) in times.iter().zip(reference) {
        let row = run.times.partition_point(|known| known < time);
        let Some(value) = ours.get(row).copied() else { continue };
        let off = (value - expected).abs();
        let is_first = found.compared == 0;
        found.compared += 1;
        if is_first || !expected.is_finite() || off > found.largest || off.is_nan() {
            found = Difference { largest: off, at: *time, value, expected: *expected, ..found };
        }
        if !expected.is_finite() || off.is_nan() {
            break;
        }
    }
    found
}

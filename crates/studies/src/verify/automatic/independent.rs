//! Comparison of a machine with a second derivation of its spec, which the caller provides, since
//! studies do not read specs.

use super::visit::Visit;
use super::{Found, Outcome, Row};

/// Time, state and parameters of a comparison.
#[derive(Debug, Clone, Copy)]
pub struct Look<'a> {
    /// t \[s\].
    pub time: f64,
    /// y.
    pub state: &'a [f64],
    /// p.
    pub parameters: &'a [f64],
}

/// Largest difference between a machine and its second derivation.
#[derive(Debug, Clone, PartialEq)]
pub struct Difference {
    /// Error relative to the sum of the absolute terms of the number; for an acceleration, these
    /// are the effects of the individual forces.
    pub error: f64,
    /// Quantity with the largest difference, and its time.
    pub place: String,
    /// Number of compared values.
    pub compared: usize,
}

/// Compares a machine with its second derivation, at points along the run and at random ones; or
/// the reason why there is no such derivation.
pub type Independent<'a> = Result<Box<dyn Fn(&[Look<'_>]) -> Difference + 'a>, String>;

pub(super) const INDEPENDENT: Row = Row {
    name: "independent derivation",
    reference: "Euler-Lagrange by numbers that carry derivatives: rate, outputs, events, \
                constraints; relative to the parts they are summed from",
    tolerance: 1e-10,
    reason: "rounding: 2e-15 in what is built in; a wrong sign is off by the part itself",
    matters: "The model is not what its spec says: please report it with the scene.",
    measure,
};

fn measure(visit: &Visit<'_>) -> Outcome {
    let independent = match &visit.subject.independent {
        Ok(independent) => independent,
        Err(why) => return Outcome::Skipped(why.clone()),
    };
    let points = visit.points.iter().filter(|point| !visit.is_at_kink(point));
    let looks = points.map(|point| Look {
        time: point.time,
        state: &point.state,
        parameters: &point.parameters,
    });
    let Difference { error, place, compared } = independent(&looks.collect::<Vec<_>>());
    if compared == 0 {
        return Outcome::Undone("its equations determine no motion at any place".to_owned());
    }
    Outcome::Found(Found { error, place: format!("Worst: {place}.") })
}

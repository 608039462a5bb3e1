//! Operating points of a scene.

use std::str::FromStr;

use super::turning::steady_rotation;
use super::{LinearError, Point, equilibrium};
use crate::simulate::Simulation;
use crate::trajectory::ColumnKind;

/// Choice of an operating point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Place {
    /// The equilibrium near the end of the run, with time held there.
    Equilibrium,
    /// The state at the start.
    Initial,
    /// The state at this time \[s\].
    Time(f64),
}

impl FromStr for Place {
    type Err = String;

    /// Parses `equilibrium`, `initial` or `t=SECONDS`.
    fn from_str(text: &str) -> Result<Self, String> {
        match text {
            "equilibrium" => return Ok(Self::Equilibrium),
            "initial" => return Ok(Self::Initial),
            _ => {}
        }
        let seconds = text.strip_prefix("t=").and_then(|seconds| seconds.trim().parse().ok());
        match seconds {
            Some(seconds) if f64::is_finite(seconds) => Ok(Self::Time(seconds)),
            _ => Err(format!("`{text}` is not one of equilibrium, initial and t=SECONDS")),
        }
    }
}

/// Returns the operating point of a run, with the parameters of the run.
///
/// The search for an equilibrium begins at the end of the run, so that a machine that runs up is
/// found running. At the start and at a given time the state need not be steady; the linearization
/// then holds for times that are short compared with changes of the state.
///
/// # Errors
/// [`LinearError`] if the run is refused or stops, or if there is no equilibrium.
pub fn operating_point(run: &Simulation<'_>, place: Place) -> Result<Point, LinearError> {
    match place {
        Place::Initial => Ok(start(run)?),
        Place::Time(time) if time.to_bits() == run.start_time().to_bits() => Ok(start(run)?),
        Place::Time(time) => Ok(end(&run.clone().until(time))?),
        Place::Equilibrium => {
            let end = end(run)?;
            match steady_rotation(run.simulator(), &end) {
                Some(point) => Ok(point),
                None => equilibrium(run.simulator(), &end),
            }
        }
    }
}

fn start(run: &Simulation<'_>) -> Result<Point, LinearError> {
    let (state, parameters) = run.checked_start()?;
    Ok(Point { time: run.start_time(), state, parameters })
}

fn end(run: &Simulation<'_>) -> Result<Point, LinearError> {
    let (_, parameters) = run.checked_start()?;
    let trajectory = run.clone().points(2).run()?;
    let last = |values: &[f64]| values.last().copied().unwrap_or(f64::NAN);
    let state = trajectory.of_kind(ColumnKind::State).map(|column| last(&column.values));
    Ok(Point { time: last(&trajectory.times), state: state.collect(), parameters })
}

//! Settings of a run from options.

use std::time::Duration;

use machinist::{Method, Simulation};
use machinist_contract::Simulator;

use super::amount::Amount;
use crate::failure::Failure;

/// Sets parameters of a run, as `--set` gives them.
pub fn with_parameters<'a>(
    mut run: Simulation<'a>,
    set: &[(String, Amount)],
) -> Result<Simulation<'a>, Failure> {
    for (index, (name, amount)) in set.iter().enumerate() {
        if set[..index].iter().any(|(earlier, _)| earlier == name) {
            let twice = format!("`--set {name}` is given twice");
            return Err(Failure::input(twice, "leave one of them out"));
        }
        amount.check_of(name, &run)?;
        run = run.parameter(name, amount.value)?;
    }
    Ok(run)
}

/// Options of a run of which single numbers are reported.
pub struct Told<'o> {
    /// `--set`.
    pub set: &'o [(String, Amount)],
    /// `--from`.
    pub from: Option<f64>,
    /// `--until`.
    pub until: Option<f64>,
    /// `--points`; by default that of the scene, and at least [`POINTS`].
    pub points: Option<usize>,
    /// `--rtol`.
    pub rtol: Option<f64>,
    /// `--method`.
    pub method: Option<&'o str>,
}

/// Minimum number of output times of a run of which single numbers are reported.
const POINTS: usize = 2001;

impl Told<'_> {
    /// Prepares the run of a simulator.
    pub fn of<'a>(&self, simulator: &'a dyn Simulator<f64>) -> Result<Simulation<'a>, Failure> {
        let mut simulation = with_parameters(Simulation::new(simulator), self.set)?;
        simulation = self.from.into_iter().fold(simulation, Simulation::from);
        simulation = self.until.into_iter().fold(simulation, Simulation::until);
        simulation = self.rtol.into_iter().fold(simulation, Simulation::rtol);
        let points = self.points.unwrap_or(simulator.run_defaults().points.max(POINTS));
        with_method(simulation.points(points), self.method)
    }
}

/// Default time limit of each run of a check or a page \[s\], as `--time-limit` sets it.
pub const TIME_LIMIT: &str = "30";

/// Parses seconds of computing, as `--time-limit` takes them.
pub fn time_limit(text: &str) -> Result<Duration, String> {
    let seconds: f64 = text.trim().parse().map_err(|_| "write it as seconds, such as 30")?;
    match Duration::try_from_secs_f64(seconds) {
        Ok(limit) if !limit.is_zero() => Ok(limit),
        _ => Err("a time limit must be above 0 s".to_owned()),
    }
}

/// Sets the method of a run from `--method`, if given.
pub fn with_method<'a>(run: Simulation<'a>, name: Option<&str>) -> Result<Simulation<'a>, Failure> {
    let method = name.map(Method::from_name).transpose();
    let method = method.map_err(|error| Failure::input(error, ""))?;
    Ok(method.into_iter().fold(run, Simulation::method))
}

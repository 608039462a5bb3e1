//! Settings of a run from options.

use std::time::Duration;

use machinist::{Method, Simulation};
use machinist_contract::Simulator;

use super::amount::{Amount, time};
use super::arguments::{RunArgs, SceneArgs};
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

/// Prepares the run of a simulator of which single numbers are reported. The number of output times
/// is by default that of the scene, and at least [`POINTS`].
pub fn for_numbers<'a>(
    simulator: &'a dyn Simulator<f64>,
    (scene, run): (&SceneArgs, &RunArgs),
    points: Option<usize>,
) -> Result<Simulation<'a>, Failure> {
    let points = points.unwrap_or(simulator.run_defaults().points.max(POINTS));
    Ok(run.apply(scene.simulation(simulator)?)?.points(points))
}

/// Minimum number of output times of a run of which single numbers are reported.
const POINTS: usize = 2001;

/// Default time limit of each run of a check or a page.
pub const TIME_LIMIT: Duration = Duration::from_secs(30);

/// Parses a computing time, as `--time-limit` takes it.
pub fn time_limit(text: &str) -> Result<Duration, String> {
    match Duration::try_from_secs_f64(time(text)?) {
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

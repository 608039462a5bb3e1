//! A run as options set it.

use std::time::Duration;

use machinist::{Method, Simulation};

use super::amount::Amount;
use crate::failure::Failure;

/// A run of a simulator with other values of some parameters, as `--set` gives them.
pub fn with_parameters<'a>(
    mut run: Simulation<'a>,
    set: &[(String, Amount)],
) -> Result<Simulation<'a>, Failure> {
    for (name, amount) in set {
        amount.check_of(name, &run)?;
        run = run.parameter(name, amount.value)?;
    }
    Ok(run)
}

/// How long each run of a check or a page may compute unless `--time-limit` is given \[s\].
pub const TIME_LIMIT: &str = "30";

/// Seconds of computing, as `--time-limit` takes them.
pub fn time_limit(text: &str) -> Result<Duration, String> {
    let seconds: f64 = text.trim().parse().map_err(|_| "write it as seconds, such as 30")?;
    match Duration::try_from_secs_f64(seconds) {
        Ok(limit) if !limit.is_zero() => Ok(limit),
        _ => Err("a limit is a number of seconds above 0".to_owned()),
    }
}

/// A run by the method of `--method`, if that is given.
pub fn with_method<'a>(run: Simulation<'a>, name: Option<&str>) -> Result<Simulation<'a>, Failure> {
    let method = name.map(Method::from_name).transpose();
    let method = method.map_err(|error| Failure::input(error, ""))?;
    Ok(method.into_iter().fold(run, Simulation::method))
}

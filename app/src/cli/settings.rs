//! A run as options set it.

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

/// A run by the method of `--method`, if that is given.
pub fn with_method<'a>(run: Simulation<'a>, name: Option<&str>) -> Result<Simulation<'a>, Failure> {
    let method = name.map(Method::from_name).transpose();
    let method = method.map_err(|error| Failure::input(error, ""))?;
    Ok(method.into_iter().fold(run, Simulation::method))
}

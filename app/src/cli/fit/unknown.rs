//! Unknowns of a fit, as the command line gives them.

use machinist::fit::{Bounds, Unknown};
use machinist::{SimulateError, Simulation};
use machinist_contract::Simulator;

use crate::cli::amount::Amount;
use crate::cli::range::ends;
use crate::failure::Failure;

/// Name with optional bounds.
#[derive(Debug, Clone, PartialEq)]
pub struct Asked {
    pub name: String,
    pub bounds: Option<[Amount; 2]>,
}

/// Parses `name` or `name=from..to`, as `--parameters` takes it.
pub fn asked(text: &str) -> Result<Asked, String> {
    const EXAMPLE: &str = "write it as NAME or NAME=FROM..TO, such as coupling.damping=10..500";
    let Some((name, values)) = text.split_once('=') else {
        return Ok(Asked { name: text.trim().to_owned(), bounds: None });
    };
    if values.trim() == ".." {
        return Ok(Asked { name: name.trim().to_owned(), bounds: None });
    }
    let bounds = ends(values, EXAMPLE)?;
    let [from, to] = bounds.each_ref().map(|bound| bound.value);
    if from >= to {
        return Err(format!("invalid bounds: {from} is not below {to}"));
    }
    Ok(Asked { name: name.trim().to_owned(), bounds: Some(bounds) })
}

/// Returns the unknowns of a run, and whether each is a parameter.
pub fn unknowns(
    all: &[Asked],
    simulator: &dyn Simulator<f64>,
    simulation: &Simulation<'_>,
    start: &[f64],
) -> Result<Vec<(Unknown, bool)>, Failure> {
    let shape = simulator.shape();
    let parameters = || (0..shape.parameters).map(|index| simulator.parameter(index).name);
    let states = || (0..shape.states()).map(|index| simulator.state(index).name);
    let mut found: Vec<(Unknown, bool)> = Vec::new();
    for asked in all {
        let Asked { name, bounds } = asked;
        if found.iter().any(|(other, _)| other.name == *name) {
            return Err(Failure::input(format!("--parameters {name} is given twice"), ""));
        }
        let parameter = parameters().position(|known| known == name);
        let state = states().position(|known| known == name);
        let value = match (parameter, state) {
            (Some(index), _) => simulation.parameter_values()[index],
            (None, Some(index)) => start[index],
            (None, None) if simulator.is_unused(name) => {
                let (scene, name) = (simulator.name().to_owned(), name.clone());
                return Err(SimulateError::UnusedParameter { scene, name }.into());
            }
            (None, None) => {
                let message = format!(
                    "scene `{}` has no parameter and no state `{}`",
                    simulator.name(),
                    name.escape_debug()
                );
                let known: Vec<&str> = parameters().chain(states()).collect();
                return Err(Failure::unknown(message, name, known.into_iter()));
            }
        };
        if let Some([from, _]) = bounds {
            from.check_of(name, simulation)?;
        }
        let bounds = bounds.as_ref().map(|[from, to]| Bounds { low: from.value, high: to.value });
        found.push((Unknown::from(name, value, bounds), parameter.is_some()));
    }
    Ok(found)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bounds_are_read_and_crossed_ones_refused() {
        let bounds = [10.0, 500.0].map(|value| Amount { value, unit: None });
        let bounded = Asked { name: "a.b".to_owned(), bounds: Some(bounds) };
        assert_eq!(asked("a.b=10..500"), Ok(bounded));
        assert_eq!(asked("a.b").map(|asked| asked.bounds), Ok(None));
        assert_eq!(asked("a.b=..").map(|asked| asked.bounds), Ok(None));
        for (bad, reason) in [
            ("a.b=3", "NAME=FROM..TO"),
            ("a.b=5..1", "invalid bounds"),
            ("a.b=1..inf", "finite"),
            ("a.b=1..x", "not a number"),
        ] {
            assert!(asked(bad).unwrap_err().contains(reason), "{bad}");
        }
    }
}

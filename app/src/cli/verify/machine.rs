//! A machine of the user's own under check: run in both ways, with the checks of its scene.

use machinist::{Discretisation, FieldSimulator, Simulation};
use machinist_contract::Simulator;
use machinist_model::{Check, Model, ModelSimulator, Reference, Running};
use machinist_studies::verify::Verdict;
use machinist_studies::verify::automatic::{OwnCheck, OwnReference, Subject, verify_machine};

use crate::cli::scene::{self, refused};
use crate::failure::Failure;
use crate::progress::during;

/// What is changed of the run.
pub struct Changes<'a> {
    /// Parameters and their values.
    pub parameters: &'a [(String, f64)],
    /// End time, s.
    pub until: Option<f64>,
    /// Relative tolerance of a step.
    pub rtol: Option<f64>,
}

/// Every check of a scene file or a model file.
pub fn verify(argument: &str, changes: &Changes<'_>) -> Result<Vec<Verdict>, Failure> {
    let model = scene::model_of(argument)?;
    let own = ModelSimulator::new(model.clone());
    let interpreted = ModelSimulator::interpreted(model.clone());
    let is_compiled = own.running() == Running::Compiled;
    if model.fields.is_empty() {
        return verify_both(&model, &own, is_compiled.then_some(&interpreted), changes);
    }
    let cut = |scene| FieldSimulator::new(scene, Discretisation::default());
    let [own, interpreted] = [cut(&own), cut(&interpreted)];
    let own = own.map_err(|error| refused(&error))?;
    let interpreted = interpreted.map_err(|error| refused(&error))?;
    let twin: &dyn Simulator<f64> = &interpreted;
    verify_both(&model, &own, is_compiled.then_some(twin), changes)
}

fn verify_both(
    model: &Model,
    simulator: &dyn Simulator<f64>,
    twin: Option<&dyn Simulator<f64>>,
    changes: &Changes<'_>,
) -> Result<Vec<Verdict>, Failure> {
    let mut simulation = Simulation::new(simulator);
    for (name, value) in changes.parameters {
        simulation = simulation.parameter(name, *value)?;
    }
    if let Some(time) = changes.until {
        simulation = simulation.until(time);
    }
    if let Some(rtol) = changes.rtol {
        simulation = simulation.rtol(rtol);
    }
    let parameters = simulation.parameter_values().to_vec();
    let own = model.checks.iter().map(|check| own_check(check, &parameters)).collect();
    let twin = twin.ok_or("models are not compiled on this machine");
    let subject = Subject { simulation, twin, own };
    Ok(during("verifying", || verify_machine(&subject)))
}

fn own_check<'a>(check: &'a Check, parameters: &'a [f64]) -> OwnCheck<'a> {
    let reference = match &check.reference {
        Reference::Closed(closed) => OwnReference::Function(
            &closed.text,
            Box::new(move |times: &[f64]| closed.values(times, parameters)),
        ),
        Reference::Values(rows) => OwnReference::Values(rows),
    };
    OwnCheck {
        name: &check.name,
        of: &check.of,
        source: &check.source,
        tolerance: check.tolerance,
        absolute: check.absolute,
        reference,
    }
}

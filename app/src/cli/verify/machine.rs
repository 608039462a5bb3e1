//! Checks of a machine of the user's own, run in both ways.

use std::time::Duration;

use machinist::{Discretisation, FieldSimulator, Simulation};
use machinist_contract::Simulator;
use machinist_model::{Check, Model, ModelSimulator, Reference, Running};
use machinist_studies::verify::Verdict;
use machinist_studies::verify::automatic::{
    Independent, OwnCheck, OwnReference, Subject, verify_machine,
};

#[cfg(feature = "derive")]
use super::independent::Spec;
use crate::cli::amount::Amount;
use crate::cli::scene::{self, refused};
use crate::cli::settings::with_parameters;
use crate::failure::Failure;
use crate::progress::during;
#[cfg(feature = "derive")]
use crate::spec_source::SpecSource;
#[cfg(not(feature = "derive"))]
use without::Spec;

/// Changes of the run's settings.
pub struct Changes<'a> {
    /// Parameters and their values.
    pub parameters: &'a [(String, Amount)],
    /// End time, s.
    pub until: Option<f64>,
    /// Relative tolerance of a step.
    pub rtol: Option<f64>,
    /// Time limit of each run.
    pub time_limit: Duration,
}

/// Runs all checks of a scene file or a model file.
pub fn verify(argument: &str, changes: &Changes<'_>) -> Result<Vec<Verdict>, Failure> {
    let (model, spec) = given(argument)?;
    verify_model(&model, &spec, changes)
}

/// Runs all checks of a spec and the model derived from it.
#[cfg(feature = "derive")]
pub fn verify_spec(
    source: &SpecSource,
    model: &Model,
    changes: &Changes<'_>,
) -> Result<Vec<Verdict>, Failure> {
    verify_model(model, &Spec::of(source, model)?, changes)
}

/// Runs all checks of a model with its spec, or with the reason why there is none.
fn verify_model(
    model: &Model,
    spec: &Result<Spec, String>,
    changes: &Changes<'_>,
) -> Result<Vec<Verdict>, Failure> {
    let spec = spec.as_ref().map_err(String::clone);
    let own = ModelSimulator::compiled_at_once(model.clone());
    let interpreted = ModelSimulator::interpreted(model.clone());
    let is_compiled = own.running() != Running::Interpreted;
    if model.fields.is_empty() {
        let independent = |parameters: &[f64]| spec.clone()?.against(own.single(), parameters);
        let ways = Ways { simulator: own.single(), twin: interpreted.single(), is_compiled };
        return verify_both(model, &ways, &independent, changes);
    }
    let independent = |parameters: &[f64]| spec.clone()?.against_fields(&own, parameters);
    let cut = |scene| FieldSimulator::new(scene, Discretisation::default());
    let [simulator, twin] = [cut(&own), cut(&interpreted)];
    let simulator = simulator.map_err(|error| refused(&error))?;
    let twin = twin.map_err(|error| refused(&error))?;
    // Trait objects made here would be of code that is not optimized.
    let ways = Ways { simulator: simulator.single(), twin: twin.single(), is_compiled };
    verify_both(model, &ways, &independent, changes)
}

/// Returns the model of an argument and its spec, or the reason why there is none.
#[cfg(feature = "derive")]
fn given(argument: &str) -> Result<(Model, Result<Spec, String>), Failure> {
    match scene::Given::of(argument)? {
        scene::Given::Model(stamped) => Ok((stamped.model, Err(NO_SPEC.to_owned()))),
        scene::Given::Spec(source) => {
            let model = scene::derived(&source, false)?;
            let spec = Spec::of(&source, &model)?;
            Ok((model, spec))
        }
    }
}

/// Returns the model of an argument, without a spec in this build.
#[cfg(not(feature = "derive"))]
fn given(argument: &str) -> Result<(Model, Result<Spec, String>), Failure> {
    match scene::Given::of(argument)? {
        scene::Given::Model(stamped) => Ok((stamped.model, Err(NO_SPEC.to_owned()))),
        scene::Given::Spec(source) => Err(scene::cannot_derive(&source)),
    }
}

const NO_SPEC: &str = "a model file has no spec to derive from again";

/// Machine in both ways of running it.
struct Ways<'a> {
    simulator: &'a dyn Simulator<f64>,
    twin: &'a dyn Simulator<f64>,
    is_compiled: bool,
}

fn verify_both<'a>(
    model: &Model,
    ways: &Ways<'_>,
    independent: &dyn Fn(&[f64]) -> Independent<'a>,
    changes: &Changes<'_>,
) -> Result<Vec<Verdict>, Failure> {
    let simulation = Simulation::new(ways.simulator).time_limit(changes.time_limit);
    let mut simulation = with_parameters(simulation, changes.parameters)?;
    if let Some(time) = changes.until {
        simulation = simulation.until(time);
    }
    if let Some(rtol) = changes.rtol {
        simulation = simulation.rtol(rtol);
    }
    let parameters = simulation.parameter_values().to_vec();
    let own = model.checks.iter().map(|check| own_check(check, &parameters)).collect();
    let twin = ways.is_compiled.then_some(ways.twin);
    let twin = twin.ok_or("models cannot be JIT-compiled on this computer");
    let independent = independent(&parameters);
    let subject = Subject { simulation, twin, independent, own };
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

/// Stand-in for specs in a build without them.
#[cfg(not(feature = "derive"))]
mod without {
    use machinist_contract::Simulator;
    use machinist_model::ModelSimulator;
    use machinist_studies::verify::automatic::Independent;

    #[derive(Clone, Copy)]
    pub enum Spec {}

    impl Spec {
        pub fn against<'a>(self, _: &'a dyn Simulator<f64>, _: &[f64]) -> Independent<'a> {
            match self {}
        }

        pub fn against_fields<'a>(self, _: &'a ModelSimulator, _: &[f64]) -> Independent<'a> {
            match self {}
        }
    }
}

//! Checks of a machine of the user's own, run in both ways.

use std::time::Duration;

use machinist::{Discretisation, FieldSimulator, Simulation};
use machinist_contract::field::{FieldAttachment, FieldPlace, FieldScene};
use machinist_contract::{Describe, Simulator};
use machinist_model::{Check, Model, ModelSimulator, Reference, Running};
use machinist_studies::verify::Verdict;
use machinist_studies::verify::automatic::{
    Independent, OwnCheck, OwnReference, Subject, verify_machine,
};

#[cfg(feature = "derive")]
use super::independent::Spec;
use crate::cli::arguments::{MachineArgs, RunArgs};
use crate::cli::scene::{self, Loading, refused, require_no_cut};
use crate::cli::settings::with_parameters;
use crate::failure::Failure;
use crate::progress::during;
#[cfg(feature = "derive")]
use crate::spec_source::SpecSource;
#[cfg(not(feature = "derive"))]
use without::Spec;

/// Changes of the run's settings.
pub struct Changes {
    /// Parameters, initial values, and the form in which the machine runs.
    pub machine: MachineArgs,
    /// Options of the run.
    pub run: RunArgs,
    /// Time limit of each run.
    pub time_limit: Duration,
    /// Text that `scene: check` must contain, if given.
    pub only: Option<String>,
}

impl Changes {
    /// Returns no changes, with a time limit of each run.
    #[cfg(feature = "derive")]
    pub fn none(time_limit: Duration) -> Self {
        let (machine, run) = (MachineArgs::default(), RunArgs::default());
        Self { machine, run, time_limit, only: None }
    }
}

/// Runs all checks of a scene file or a model file.
pub fn verify(argument: &str, changes: &Changes) -> Result<Vec<Verdict>, Failure> {
    let (model, spec) = given(argument, changes)?;
    verify_model(&model, &spec, changes)
}

/// Runs all checks of a spec and the model derived from it.
#[cfg(feature = "derive")]
pub fn verify_spec(
    source: &SpecSource,
    model: &Model,
    changes: &Changes,
) -> Result<Vec<Verdict>, Failure> {
    verify_model(model, &Spec::of(source, model)?, changes)
}

/// Runs all checks of a model with its spec, or with the reason why there is none.
fn verify_model(
    model: &Model,
    spec: &Result<Spec, String>,
    changes: &Changes,
) -> Result<Vec<Verdict>, Failure> {
    let spec = spec.as_ref().map_err(String::clone);
    let loading = Loading { is_timed: true, ..changes.machine.loading() };
    let own = loading.simulator(model.clone())?;
    let interpreted = ModelSimulator::interpreted(model.clone());
    let twin = match (own.running(), loading.code) {
        (Running::Interpreted, Some(_)) => Err("`--code interpreted` leaves machine code out"),
        (Running::Interpreted, None) => Err("models cannot be JIT-compiled on this computer"),
        _ => Ok(()),
    };
    if model.fields.is_empty() {
        let independent = |parameters: &[f64]| spec.clone()?.against(own.single(), parameters);
        require_no_cut(loading.wanted, &model.name)?;
        let twin = twin.map(|()| interpreted.single() as &dyn Simulator<f64>);
        let ways = Ways { simulator: own.single(), in_few_elements: None, twin };
        return verify_both(model, &ways, &independent, changes);
    }
    let independent = |parameters: &[f64]| spec.clone()?.against_fields(&own, parameters);
    let simulator = cut(&own, loading.wanted)?;
    let few = cut(&own, few_elements(own.with_fields(), loading.wanted))?;
    let interpreted = cut(&interpreted, loading.wanted)?;
    let has_fewer = few.shape().states() < simulator.shape().states();
    // Trait objects made here would be of code that is not optimized.
    let ways = Ways {
        simulator: simulator.single(),
        in_few_elements: has_fewer.then(|| few.single()),
        twin: twin.map(|()| interpreted.single() as &dyn Simulator<f64>),
    };
    verify_both(model, &ways, &independent, changes)
}

fn cut(model: &ModelSimulator, wanted: Discretisation) -> Result<FieldSimulator<'_, f64>, Failure> {
    let cut = FieldSimulator::new(model.with_fields(), wanted).map_err(|error| refused(&error))?;
    Ok(cut.with_derivatives(model.with_fields_on_duals()))
}

/// Returns a division into four elements, or into as many as one for each segment between ports, of
/// order 2 at most. Elements of order 1 remain, whose equations are evaluated otherwise.
fn few_elements(scene: &dyn FieldScene<f64>, wanted: Discretisation) -> Discretisation {
    const FEW: usize = 4;
    const ORDER: usize = 2;
    let fields = || (0..scene.fields()).map(|index| scene.field(index));
    let segments = |ports: &[FieldAttachment]| {
        1 + ports.iter().filter(|at| at.place == FieldPlace::Inside).count()
    };
    let elements = fields().map(|field| segments(field.attachments)).fold(FEW, usize::max);
    let order = wanted.order.or_else(|| fields().map(|field| field.order).min());
    Discretisation { elements: Some(elements), order: order.map(|order| order.min(ORDER)) }
}

/// Returns the model of an argument and its spec, or the reason why there is none.
#[cfg(feature = "derive")]
fn given(argument: &str, changes: &Changes) -> Result<(Model, Result<Spec, String>), Failure> {
    let keep_all = changes.machine.keep.keep_all;
    match scene::SceneSource::of(argument)? {
        scene::SceneSource::Model(_) if keep_all => Err(scene::already_reduced(argument)),
        scene::SceneSource::Model(stamped) => Ok((stamped.model, Err(NO_SPEC.to_owned()))),
        scene::SceneSource::Spec(source) => {
            let model = scene::derived(&source, keep_all)?;
            let spec = Spec::of(&source, &model)?;
            Ok((model, spec))
        }
    }
}

/// Returns the model of an argument, without a spec in this build.
#[cfg(not(feature = "derive"))]
fn given(argument: &str, changes: &Changes) -> Result<(Model, Result<Spec, String>), Failure> {
    let keep_all = changes.machine.keep.keep_all;
    match scene::SceneSource::of(argument)? {
        scene::SceneSource::Model(_) if keep_all => Err(scene::already_reduced(argument)),
        scene::SceneSource::Model(stamped) => Ok((stamped.model, Err(NO_SPEC.to_owned()))),
        scene::SceneSource::Spec(source) => Err(scene::cannot_derive(&source)),
    }
}

const NO_SPEC: &str = "a model file has no spec to derive from again";

/// Machine in both ways of running it.
struct Ways<'a> {
    simulator: &'a dyn Simulator<f64>,
    /// The machine in fewer elements, if its fields have more than few.
    in_few_elements: Option<&'a dyn Simulator<f64>>,
    /// Interpreted machine, or the reason why there is no other way.
    twin: Result<&'a dyn Simulator<f64>, &'static str>,
}

fn verify_both<'a>(
    model: &Model,
    ways: &Ways<'_>,
    independent: &dyn Fn(&[f64]) -> Independent<'a>,
    changes: &Changes,
) -> Result<Vec<Verdict>, Failure> {
    let simulation = with_changes(ways.simulator, changes)?;
    let in_few_elements = ways.in_few_elements.map(|simulator| {
        let why = |_| "the run is given at nodes that few elements do not have".to_owned();
        with_changes(simulator, changes).map_err(why)
    });
    let parameters = simulation.parameter_values().to_vec();
    let own = model.checks.iter().map(|check| own_check(check, &parameters)).collect();
    let independent = independent(&parameters);
    let (twin, only) = (ways.twin, changes.only.clone());
    let subject = Subject { simulation, in_few_elements, twin, independent, own, only };
    Ok(during("verifying", || verify_machine(&subject)))
}

/// Returns the run of a simulator with the requested settings.
fn with_changes<'a>(
    simulator: &'a dyn Simulator<f64>,
    changes: &Changes,
) -> Result<Simulation<'a>, Failure> {
    let Changes { machine, run, time_limit, .. } = changes;
    let simulation = Simulation::new(simulator).time_limit(*time_limit);
    run.apply(machine.with_initial(with_parameters(simulation, &machine.set)?)?)
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

//! Price of approximations: the errors of the outputs and the time saved by freezing, measured by
//! running the scene with and without it.

use machinist::{SimulateError, Trajectory};
use machinist_codegen::mechanics::reduce::Keep;
use machinist_model::Model;
use machinist_model::ModelSimulator;
use serde::Serialize;

use crate::deriving::{self, Request, Wanted};
use crate::explain::{limited, median, relative_differences, timed};
use crate::failure::Failure;
use crate::spec_source::SpecSource;

/// Runs of each model, of which the median counts.
const RUNS: usize = 3;

/// Instance that could be taken as rigid.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Candidate {
    /// Name of the instance.
    pub instance: String,
    /// Price, or the reason why the run stopped.
    pub price: Result<Price, String>,
}

/// Effects of freezing.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Price {
    /// Number of remaining states.
    pub states: usize,
    /// Largest error of each output over the scene's run, relative to its largest value.
    pub errors: Vec<(String, f64)>,
    /// Ratio of the median time of the frozen run to that of the exact one.
    pub time_ratio: f64,
}

impl Price {
    /// Returns the output with the largest error.
    pub fn worst(&self) -> Option<&(String, f64)> {
        self.errors.iter().max_by(|a, b| a.1.total_cmp(&b.1))
    }

    fn measure(exact: Model, frozen: Model) -> Result<Self, SimulateError> {
        let states = frozen.states.len();
        let [exact, frozen] = [exact, frozen].map(ModelSimulator::compiled_at_once);
        let (mut exact_times, mut frozen_times) = (Vec::new(), Vec::new());
        for _ in 0..RUNS {
            exact_times.push(timed(&exact)?.0);
            frozen_times.push(timed(&frozen)?.0);
        }
        let run = |simulator| -> Result<Trajectory, SimulateError> { limited(simulator).run() };
        let errors = relative_differences(&run(&exact)?, &run(&frozen)?);
        Ok(Self { states, errors, time_ratio: median(frozen_times) / median(exact_times) })
    }
}

/// Returns every instance of a scene that can be taken as rigid, with its price.
pub fn candidates(scene: &SpecSource) -> Result<Vec<Candidate>, Failure> {
    let system = scene.system()?;
    let exact = deriving::model(scene, Keep::Exact)?;
    let requests = system.springs.iter().map(|spring| Request {
        rigid: Some(vec![spring.instance.clone()]),
        wanted: Wanted::ModelIfPossible,
        ..Request::model(scene, Keep::Needed)
    });
    let frozen = deriving::possible(&requests.collect::<Vec<_>>())?;
    let candidates = system.springs.iter().zip(frozen).filter_map(|(spring, frozen)| {
        // An instance that cannot be frozen is no candidate.
        let price = Price::measure(exact.clone(), frozen?).map_err(|error| error.to_string());
        Some(Candidate { instance: spring.instance.clone(), price })
    });
    Ok(candidates.collect())
}

/// Returns an error if freezing exceeds the tolerance of the scene.
pub fn admit(scene: &SpecSource, model: &Model) -> Result<(), Failure> {
    admit_against(model, || deriving::model(scene, Keep::Exact))
}

/// Like [`admit`]; `exact` derives the model without freezing.
pub fn admit_against(
    model: &Model,
    exact: impl FnOnce() -> Result<Model, Failure>,
) -> Result<(), Failure> {
    let freeze = &model.freeze;
    if freeze.rigid.is_empty() {
        return Ok(());
    }
    let price = Price::measure(exact()?, model.clone())?;
    match price.worst() {
        // An error that is not a number is never allowed.
        Some((output, error)) if error.is_nan() || *error > freeze.tolerance => {
            let message = format!(
                "scene `{}`: with {} rigid, output `{output}` is wrong by {error:.2e} of its largest \
                 value, but at most {:e} is allowed",
                model.name,
                freeze.rigid.join(", "),
                freeze.tolerance,
            );
            let help = "raise `tolerance` in [freeze], freeze less, or choose other outputs";
            Err(Failure::unsuccessful(message, help))
        }
        _ => Ok(()),
    }
}

//! Designs and results of scatters, as `machinist scatter` has them.

use machinist::Simulation;
use machinist::improve::Expression;
use machinist::scatter::{Design, Distribution, Groups, Morris};
use machinist_codegen::scene::scatter::{Scatter, distributions};
use machinist_codegen::spec::library::LibraryScene;
use machinist_contract::Simulator;

use super::Spec;
use crate::cli::improve::units;
use crate::cli::scatter::{Inputs, Linearized, Plan, Results, Varied, propagated, varied};
use crate::failure::Failure;
use crate::spec_source::SpecSource;

/// Parameters that vary, and their values in all runs.
#[derive(Debug, Clone)]
pub struct ScatterDesign {
    /// Names of the parameters.
    pub names: Vec<String>,
    /// SI units.
    pub units: Vec<String>,
    /// Distributions.
    pub distributions: Vec<Distribution>,
    /// True if the parameters are correlated.
    pub is_correlated: bool,
    /// Parameters of the scene that have a distribution but are not parameters of the model.
    pub left_out: Vec<String>,
    /// Values of the parameters, in the order of runs.
    pub values: Vec<Vec<f64>>,
    /// Number of runs of a row of a Saltelli design.
    pub row_length: Option<usize>,
    /// Samples or rows that are independent of each other.
    pub groups: Groups,
}

/// Results of each run.
#[derive(Debug, Clone)]
pub struct ScatterResults {
    /// Names of the columns: expressions, then both sides of each requirement.
    pub names: Vec<String>,
    /// Units of the columns.
    pub units: Vec<String>,
    /// Expressions of the columns.
    pub expressions: Vec<Expression>,
    /// True for each requirement whose left side must be at most the right one.
    pub is_at_most: Vec<bool>,
    /// True if the first and the last output time suffice.
    pub takes_ends_only: bool,
}

/// Distributions of a scatter: those of a spec and those of `vary`, names with texts such as
/// `normal(5 %)`, which take precedence. Parameters that are `set` must not have any.
#[derive(Debug, Clone, Copy)]
pub struct Spread<'a> {
    /// The spec.
    pub spec: Option<&'a Spec>,
    /// Names and texts.
    pub vary: &'a [(String, String)],
    /// Names of parameters with values.
    pub set: &'a [&'a str],
}

impl Spread<'_> {
    fn inputs(&self, run: &Simulation<'_>) -> Result<Inputs, Failure> {
        let of_scene = of_spec(self.spec)?;
        let vary = self.vary.iter().map(|(name, text)| varied(&format!("{name}={text}")));
        let vary: Result<Vec<Varied>, _> = vary.collect();
        let vary = vary.map_err(|message| Failure::input(message, ""))?;
        Inputs::new(&of_scene, &vary, self.set, run)
    }
}

/// Creates the design of a scatter. `run` has the other parameters; `design.dimensions` is not read.
///
/// # Errors
/// A message for wrong distributions or settings.
pub fn scatter_design(
    spread: Spread<'_>,
    design: Design,
    with_indices: bool,
    run: &Simulation<'_>,
) -> Result<ScatterDesign, String> {
    let inputs = spread.inputs(run)?;
    if with_indices {
        inputs.require_independent("indices")?;
    }
    let design = Design { dimensions: inputs.names.len(), ..design };
    let plan = Plan::new(design, with_indices, &inputs)?;
    let mut values = Vec::with_capacity(plan.len());
    while values.len() < plan.len() {
        values.extend(plan.batch(values.len()).iter().map(|point| inputs.values(point)));
    }
    Ok(ScatterDesign {
        values,
        row_length: plan.row_length(),
        groups: plan.groups(),
        is_correlated: !inputs.correlation.is_none(),
        names: inputs.names,
        units: inputs.units,
        distributions: inputs.distributions,
        left_out: inputs.left_out,
    })
}

/// Returns the values of the parameters on the paths of Morris' design, path after path.
/// `design.dimensions` is not read.
///
/// # Errors
/// A message for wrong distributions, and for correlated parameters.
pub fn scatter_paths(
    spread: Spread<'_>,
    design: &Morris,
    run: &Simulation<'_>,
) -> Result<Vec<Vec<f64>>, String> {
    let inputs = spread.inputs(run)?;
    inputs.require_independent("morris")?;
    let design = Morris { dimensions: inputs.names.len(), ..*design };
    let points = (0..design.paths).flat_map(|path| design.path(path));
    Ok(points.map(|point| inputs.values(&point)).collect())
}

/// Propagates the standard deviations of the parameters to expressions, by the sensitivities of one
/// run at their means.
///
/// # Errors
/// A message for wrong distributions or expressions, and for a run that stops.
pub fn scatter_linear(
    spread: Spread<'_>,
    of: &[String],
    run: &Simulation<'_>,
) -> Result<Vec<Linearized>, String> {
    let inputs = spread.inputs(run)?;
    let results = Results::new(of, &[], run.simulator())?;
    let all = results.of.iter().map(|one| propagated(run, &inputs, one));
    Ok(all.collect::<Result<_, Failure>>()?)
}

/// Reads expressions over a run, such as `max(force)`, and requirements, such as
/// `max(force) < 38 [kN]`. Without any, the results are the final values of outputs.
///
/// # Errors
/// A message for expressions that are wrong or that the machine does not have.
pub fn scatter_results(
    of: &[String],
    limits: &[String],
    simulator: &dyn Simulator<f64>,
) -> Result<ScatterResults, String> {
    let results = Results::new(of, limits, simulator)?;
    let expressions: Vec<Expression> = results.expressions().into_iter().cloned().collect();
    Ok(ScatterResults {
        names: results.names(),
        units: expressions.iter().map(|of| units::of(of, simulator)).collect(),
        expressions,
        is_at_most: results.limits.iter().map(|(_, limit)| limit.is_at_most).collect(),
        takes_ends_only: results.take_ends_only(),
    })
}

fn of_spec(spec: Option<&Spec>) -> Result<Scatter, Failure> {
    let source = match spec {
        Some(Spec::File(path)) => SpecSource::File(path.clone()),
        Some(Spec::Named(name)) if LibraryScene::find(name).is_some() => {
            SpecSource::BuiltIn(name.clone())
        }
        // Models have no distributions.
        None | Some(Spec::Named(_)) => return Ok(Scatter::default()),
    };
    Ok(distributions(&source.read()?)?)
}

/// Messages with their hints, as the Python package raises them.
impl From<Failure> for String {
    fn from(failure: Failure) -> Self {
        let one = |trouble: crate::failure::Trouble| match trouble.help.as_str() {
            "" => trouble.message,
            help => format!("{}. Hint: {help}", trouble.message),
        };
        failure.troubles().into_iter().map(one).collect::<Vec<_>>().join("; ")
    }
}

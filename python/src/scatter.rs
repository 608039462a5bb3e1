//! Scatters: designs, runs of expressions, and statistics.

use machinist::Simulation;
use machinist::scatter::{
    Design, Effect, Estimate, Groups, Morris, Sampler, ScatterError, SobolIndices, Summary, Tally,
    value_over,
};
use machinist_app::embedded::{self, LinearShare, Linearized, ScatterResults, Spec, Spread};
use numpy::{PyReadonlyArray2, PyUntypedArrayMethods};
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyList};

use crate::arrays::array;
use crate::failure::Failure;
use crate::machine::Machine;
use crate::settings::Settings;
use crate::sweep::{Piece, all_runs, piece, prepared, rows};

impl From<ScatterError> for Failure {
    fn from(error: ScatterError) -> Self {
        let class = match error {
            ScatterError::UnknownSampler { .. } => "UnknownNameError",
            _ => "InputError",
        };
        Self::Coded(class, error.code(), error.to_string())
    }
}

/// Source of the distributions: a file (true) or a name, if there is a spec, and texts by parameter.
type Sources = (Option<(bool, String)>, Vec<(String, String)>);

/// Calls a function with the distributions and a run with the settings; releases the GIL.
fn spread<T: Send>(
    py: Python<'_>,
    machine: &Machine,
    settings: &Bound<'_, PyDict>,
    (spec, vary): Sources,
    job: impl FnOnce(Spread<'_>, &Simulation<'_>) -> Result<T, String> + Send,
) -> Result<T, Failure> {
    let settings = Settings::of(settings)?;
    let spec =
        spec.map(|(is_file, of)| if is_file { Spec::File(of.into()) } else { Spec::Named(of) });
    py.detach(|| -> Result<_, Failure> {
        machine.source.with(|simulator| {
            let run = settings.apply(Simulation::new(simulator))?;
            let set: Vec<&str> = settings.parameters.iter().map(|(name, _)| &**name).collect();
            let spread = Spread { spec: spec.as_ref(), vary: &vary, set: &set };
            job(spread, &run).map_err(Failure::input)
        })?
    })
}

/// Returns rows as an array.
fn table<'py>(py: Python<'py>, rows: &[Vec<f64>], width: usize) -> PyResult<Bound<'py, PyAny>> {
    array(py, rows.concat()).call_method1("reshape", ((rows.len(), width),))
}

/// Parameters that vary and their values in all runs, as a dictionary. `design` has sampler, number
/// of samples, seed, and whether there are runs for indices.
#[pyfunction]
pub fn scatter_design<'py>(
    py: Python<'py>,
    machine: &Machine,
    settings: &Bound<'py, PyDict>,
    given: Sources,
    design: (String, usize, u64, bool),
) -> Result<Bound<'py, PyDict>, Failure> {
    let (sampler, samples, seed, with_indices) = design;
    let design = Design { sampler: Sampler::from_name(&sampler)?, dimensions: 0, samples, seed };
    let found = spread(py, machine, settings, given, |spread, run| {
        embedded::scatter_design(spread, design, with_indices, run)
    })?;
    let answer = PyDict::new(py);
    let laws: Vec<_> = found
        .distributions
        .iter()
        .map(|of| (of.name(), of.mean(), of.deviation(), format!("{:?}", of.law())))
        .collect();
    let values = table(py, &found.values, found.names.len())?;
    let replicates = match found.groups {
        Groups::Independent => None,
        Groups::Replicates(count) => Some(count),
    };
    answer.set_item("names", found.names)?;
    answer.set_item("units", found.units)?;
    answer.set_item("laws", laws)?;
    answer.set_item("is_correlated", found.is_correlated)?;
    answer.set_item("left_out", found.left_out)?;
    answer.set_item("values", values)?;
    answer.set_item("row_length", found.row_length)?;
    answer.set_item("replicates", replicates)?;
    Ok(answer)
}

/// Values of the parameters on the paths of Morris' design, path after path.
#[pyfunction]
pub fn scatter_paths<'py>(
    py: Python<'py>,
    machine: &Machine,
    settings: &Bound<'py, PyDict>,
    given: Sources,
    design: (usize, u64),
) -> Result<Bound<'py, PyAny>, Failure> {
    let design = Morris { dimensions: 0, paths: design.0, seed: design.1 };
    let found = spread(py, machine, settings, given, |spread, run| {
        embedded::scatter_paths(spread, &design, run)
    })?;
    Ok(table(py, &found, found.first().map_or(0, Vec::len))?)
}

/// mu*, half the width of its interval, mu, sigma, number.
type EffectRow = (f64, f64, f64, f64, usize);

/// Elementary effects of each parameter. `values` are those of one result on the paths of [`scatter_paths`].
#[pyfunction]
pub fn scatter_effects(
    values: Vec<f64>,
    design: (usize, usize, u64),
    confidence: f64,
) -> Result<Vec<EffectRow>, Failure> {
    let (dimensions, paths, seed) = design;
    let design = Morris { dimensions, paths, seed };
    let values: Vec<Vec<f64>> = values.chunks_exact(dimensions + 1).map(<[f64]>::to_vec).collect();
    let effects = design.effects(&values, confidence)?;
    let told = |of: &Effect| (of.mean_absolute, of.error, of.mean, of.deviation, of.count);
    Ok(effects.iter().map(told).collect())
}

/// Value, deviation, and for each parameter slope, change for one deviation and share; reasons for
/// missing slopes.
type Linear = (f64, f64, Vec<(f64, f64, f64)>, Vec<String>);

/// Linear propagation of deviations to each expression.
#[pyfunction]
pub fn scatter_linear(
    py: Python<'_>,
    machine: &Machine,
    settings: &Bound<'_, PyDict>,
    given: Sources,
    of: Vec<String>,
) -> Result<Vec<Linear>, Failure> {
    let found = spread(py, machine, settings, given, |spread, run| {
        embedded::scatter_linear(spread, &of, run)
    })?;
    let share = |of: &LinearShare| (of.slope, of.contribution, of.share);
    let told = |of: Linearized| {
        (of.value, of.deviation, of.shares.iter().map(share).collect(), of.left_out)
    };
    Ok(found.into_iter().map(told).collect())
}

/// Names and units of columns, whether the ends of a run suffice, and the directions of requirements.
type Read = (Vec<String>, Vec<String>, bool, Vec<bool>);

/// Names, units and whether the ends of a run suffice, of expressions and requirements; and for
/// each requirement whether its left side must be at most the right one.
#[pyfunction]
pub fn scatter_results(
    machine: &Machine,
    of: Vec<String>,
    limits: Vec<String>,
) -> Result<Read, Failure> {
    let read = read(machine, &of, &limits)?;
    Ok((read.names, read.units, read.takes_ends_only, read.is_at_most))
}

fn read(machine: &Machine, of: &[String], limits: &[String]) -> Result<ScatterResults, Failure> {
    let read = machine.source.with(|simulator| embedded::scatter_results(of, limits, simulator));
    read?.map_err(Failure::input)
}

/// Runs variants: a row of `values` contains the parameters called `names`. Results are those of
/// [`scatter_results`] for `results`, expressions and requirements.
#[pyfunction]
pub fn scatter_piece<'py>(
    py: Python<'py>,
    machine: &Machine,
    settings: &Bound<'py, PyDict>,
    names: Vec<String>,
    values: PyReadonlyArray2<'py, f64>,
    results: (Vec<String>, Vec<String>),
    threads: usize,
) -> Result<Piece<'py>, Failure> {
    let settings = Settings::of(settings)?;
    let rows = rows(&values, &names)?;
    let ScatterResults { expressions, .. } = read(machine, &results.0, &results.1)?;
    let found = py.detach(|| -> Result<_, Failure> {
        let (_, variants) = machine
            .source
            .with(|simulator| prepared(simulator, &settings, &names, &rows, &[], false))??;
        let runs = all_runs(machine, &settings, &variants, threads)?;
        machine.source.with(|simulator| {
            let base = settings.apply(Simulation::new(simulator))?;
            let runs = runs.into_iter().zip(&variants).map(|(run, variant)| {
                let run = run.map_err(|error| error.to_string())?;
                let base = base.clone().parameters(variant);
                let values = expressions.iter().map(|of| value_over(of, &base, &run));
                let values: Vec<f64> = values.collect();
                match values.iter().find(|value| !value.is_finite()) {
                    Some(value) => Err(format!("a result is {value}")),
                    None => Ok((values, run.steps)),
                }
            });
            Ok(runs.collect::<Vec<_>>())
        })?
    })?;
    Ok(piece(py, found, expressions.len()))
}

/// Value, lower and upper end of the interval; infinite where the samples do not bound it.
type Interval = (f64, f64, f64);

fn interval(of: Estimate) -> Interval {
    (of.value, of.low, of.high)
}

/// Statistics of results, as a dictionary. `values` has a row for each run, NaN without a result;
/// the columns are those of [`scatter_results`]. `design` is the length of a row of a Saltelli design
/// and the number of replicates; `asked` are the confidence and the probabilities of quantiles.
#[pyfunction]
pub fn scatter_statistics<'py>(
    py: Python<'py>,
    values: PyReadonlyArray2<'py, f64>,
    is_at_most: Vec<bool>,
    design: (Option<usize>, Option<usize>),
    asked: (f64, Vec<f64>),
) -> Result<Bound<'py, PyDict>, Failure> {
    let (row_length, replicates) = design;
    let (confidence, quantiles) = asked;
    let groups = replicates.map_or(Groups::Independent, Groups::Replicates);
    let count = values.shape()[1].saturating_sub(2 * is_at_most.len());
    let values = values.as_array();
    let column = |at: usize| -> Vec<f64> { values.column(at).iter().copied().collect() };
    let results = PyList::empty(py);
    for at in 0..count {
        let all = column(at);
        let summary = Summary::of(&samples(&all, row_length), &groups, confidence)?;
        let of = PyDict::new(py);
        of.set_item("count", summary.count)?;
        of.set_item("mean", interval(summary.mean))?;
        of.set_item("deviation", interval(summary.deviation))?;
        of.set_item("least", summary.least)?;
        of.set_item("greatest", summary.greatest)?;
        let quantiles: Vec<(f64, Interval)> =
            quantiles.iter().map(|p| (*p, interval(summary.quantile(*p)))).collect();
        of.set_item("quantiles", quantiles)?;
        if let Some(length) = row_length {
            let rows: Vec<Vec<f64>> = all.chunks_exact(length).map(<[f64]>::to_vec).collect();
            let found = SobolIndices::of(&rows, &groups, confidence)?;
            let indices: Vec<_> = found
                .indices
                .iter()
                .map(|index| (interval(index.first), interval(index.total)))
                .collect();
            of.set_item("indices", indices)?;
        }
        results.append(of)?;
    }
    let limits = PyList::empty(py);
    for (index, is_at_most) in is_at_most.into_iter().enumerate() {
        let sides = [0, 1].map(|side| column(count + 2 * index + side));
        let missed: Vec<Option<bool>> = sides[0]
            .iter()
            .zip(&sides[1])
            .map(|(left, right)| {
                let holds = if is_at_most { left <= right } else { left >= right };
                left.is_finite().then_some(!holds)
            })
            .collect();
        let tally = Tally::of(&samples(&missed, row_length), &groups, confidence)?;
        limits.append((tally.hits, tally.count, interval(tally.probability)))?;
    }
    let answer = PyDict::new(py);
    answer.set_item("results", results)?;
    answer.set_item("limits", limits)?;
    Ok(answer)
}

/// Samples for statistics: those of all runs, or, of a Saltelli design, those at its points A, then
/// B.
fn samples<T: Copy>(values: &[T], row_length: Option<usize>) -> Vec<T> {
    let Some(length) = row_length else { return values.to_vec() };
    let of = |point: usize| values.chunks_exact(length).map(move |row| row[point]);
    of(0).chain(of(1)).collect()
}

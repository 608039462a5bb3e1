//! Periodic motions and their branches.

use machinist::Simulation;
use machinist::periodic::{
    Branch, BranchSettings, Cycle, CycleError, CycleSettings, Period, Section, Stability,
    cycle as cycle_of, doublings, repeats,
};
use numpy::PyArray2;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyList};

use crate::arrays::array;
use crate::failure::Failure;
use crate::machine::Machine;
use crate::patience::Patience;
use crate::run::Run;
use crate::settings::Settings;
use crate::sweep::{all_runs_of, prepared};

/// Relative tolerance of the runs if none is given, at most.
const RTOL: f64 = 1e-10;

/// Period that is searched for.
#[derive(Debug, FromPyObject)]
pub enum Asked {
    /// Name of the parameter that determines it.
    Parameter(String),
    /// Time \[s\].
    Given(f64),
}

/// Period, guess, turns, time to settle; multiple, segments, points.
type Search = (Option<Asked>, Option<f64>, Vec<(String, f64)>, Option<f64>, (usize, usize, usize));

/// Settings of a search from a run.
fn asked(search: Search, settings: &Settings, run: &Simulation<'_>) -> CycleSettings {
    let (period, guess, turns, settle, (multiple, segments, points)) = search;
    let period = match period {
        Some(Asked::Parameter(name)) => Period::Parameter(name),
        Some(Asked::Given(time)) => Period::Fixed(time),
        None => Period::Unknown(guess),
    };
    let end = settings.end().unwrap_or(run.simulator().run_defaults().until);
    let settle = settle.unwrap_or((end - run.start_time()).max(0.0));
    let more = CycleSettings::default();
    CycleSettings { period, multiple, turns, settle, segments, points, ..more }
}

/// Searches with the settings of a run; releases the GIL.
fn searched<T: Send>(
    py: Python<'_>,
    machine: &Machine,
    settings: &Bound<'_, PyDict>,
    search: Search,
    job: impl FnOnce(&Simulation<'_>, CycleSettings) -> Result<T, CycleError> + Send,
) -> Result<T, Failure> {
    let settings = Settings::of(settings)?;
    let (found, quiet) = py.detach(|| {
        let patience = Patience::new();
        let end = || patience.end();
        let found = machine.source.with(|simulator| -> Result<T, Failure> {
            let mut run = settings.apply(Simulation::new(simulator))?.until_told(&end);
            if !settings.has_tolerance() {
                let rtol = run.relative_tolerance().min(RTOL);
                run = run.rtol(rtol);
            }
            let cycle = asked(search, &settings, &run);
            Ok(job(&run, cycle)?)
        });
        (found, patience.require_quiet())
    });
    quiet?;
    found?
}

/// A periodic motion, as a dictionary.
#[pyfunction]
pub fn cycle<'py>(
    py: Python<'py>,
    machine: &Machine,
    settings: &Bound<'py, PyDict>,
    search: Search,
) -> Result<Bound<'py, PyDict>, Failure> {
    let found = searched(py, machine, settings, search, |run, asked| cycle_of(run, &asked))?;
    Ok(told(py, found)?)
}

/// A branch of periodic motions over a parameter and those of its doublings, as dictionaries.
#[pyfunction]
pub fn branches<'py>(
    py: Python<'py>,
    machine: &Machine,
    settings: &Bound<'py, PyDict>,
    search: Search,
    over: (String, f64, f64),
    steps: (f64, usize, u32),
) -> Result<Bound<'py, PyList>, Failure> {
    let (parameter, from, to) = over;
    let (longest_step, max_points, count) = steps;
    let found = searched(py, machine, settings, search, |run, cycle| {
        let settings = BranchSettings { cycle, parameter, from, to, longest_step, max_points };
        doublings(run, &settings, count)
    })?;
    let all = PyList::empty(py);
    for one in found {
        all.append(told_branch(py, one)?)?;
    }
    Ok(all)
}

fn told_branch(py: Python<'_>, found: Branch) -> PyResult<Bound<'_, PyDict>> {
    let answer = PyDict::new(py);
    answer.set_item("parameter", found.parameter)?;
    answer.set_item("unit", found.unit)?;
    answer.set_item("end", found.end)?;
    answer.set_item("is_complete", found.is_complete)?;
    let points = PyList::empty(py);
    for point in found.points {
        let bifurcation = point.bifurcation.map(machinist::periodic::Bifurcation::name);
        points.append((point.value, bifurcation, point.grazed, told(py, point.cycle)?))?;
    }
    answer.set_item("points", points)?;
    Ok(answer)
}

/// Section of each variant or the reason why there is none, and the periods after which they repeat.
type Sections<'py> =
    (Vec<Option<Bound<'py, PyArray2<f64>>>>, Vec<Option<String>>, Vec<Option<usize>>);

/// Values of columns once in a period, at values of a parameter.
#[pyfunction]
pub fn sections<'py>(
    py: Python<'py>,
    machine: &Machine,
    settings: &Bound<'py, PyDict>,
    search: Search,
    over: (String, Vec<f64>),
    columns: Vec<String>,
    counts: (usize, usize),
) -> Result<Sections<'py>, Failure> {
    let settings = Settings::of(settings)?;
    let ((name, values), (returns, threads)) = (over, counts);
    let found = py.detach(|| -> Result<_, Failure> {
        let (cycle, places, variants, same) = machine.source.with(|simulator| {
            let run = settings.apply(Simulation::new(simulator))?;
            let cycle = asked(search, &settings, &run);
            let rows: Vec<Vec<f64>> = values.iter().map(|value| vec![*value]).collect();
            let names = [name.clone()];
            let (wanted, variants) =
                prepared(simulator, &settings, &names, &rows, &columns, false)?;
            for value in &values {
                let _ = cycle.sectioned(run.clone().parameter(&name, *value)?, returns)?;
            }
            Ok::<_, Failure>((cycle, wanted.places, variants, run.relative_tolerance().sqrt()))
        })??;
        // They were accepted for each value.
        let runs = all_runs_of(machine, &settings, &variants, threads, |run| {
            cycle.sectioned(run.clone(), returns).unwrap_or(run)
        })?;
        let found: Vec<Result<Section, String>> = runs
            .into_iter()
            .map(|run| run.map(|run| run.last(&places, returns)).map_err(|why| why.to_string()))
            .collect();
        let known: Vec<_> = found.iter().map(|section| section.as_ref().ok()).collect();
        let repeats = repeats(&known, same);
        Ok((found, repeats))
    })?;
    let (found, repeats) = found;
    let (mut tables, mut reasons) = (Vec::new(), Vec::new());
    for section in found {
        let (table, reason) = match section {
            Ok(section) => (Some(PyArray2::from_vec2(py, &section).map_err(PyErr::from)?), None),
            Err(reason) => (None, Some(reason)),
        };
        tables.push(table);
        reasons.push(reason);
    }
    Ok((tables, reasons, repeats))
}

fn told(py: Python<'_>, found: Cycle) -> PyResult<Bound<'_, PyDict>> {
    let answer = PyDict::new(py);
    answer.set_item("start", found.start)?;
    answer.set_item("period", found.period)?;
    answer.set_item("is_forced", found.is_forced)?;
    answer.set_item("state", array(py, found.state))?;
    answer.set_item("residual", found.residual)?;
    answer.set_item("iterations", found.iterations)?;
    answer.set_item("notes", found.notes)?;
    let stability = match found.stability {
        Stability::Stable => "stable",
        Stability::Unstable => "unstable",
        Stability::Neutral => "neutral",
    };
    answer.set_item("stability", stability)?;
    let multipliers = PyList::empty(py);
    for one in found.multipliers {
        let (real, imaginary): (Vec<f64>, Vec<f64>) =
            one.vector.iter().map(|[real, imaginary]| (*real, *imaginary)).unzip();
        let vector = (array(py, real), array(py, imaginary));
        let value = (one.real, one.imaginary);
        multipliers.append((value, one.is_trivial, one.crossing.name(), vector))?;
    }
    answer.set_item("multipliers", multipliers)?;
    answer.set_item("motion", Run::new(found.motion).into_pyobject(py)?)?;
    Ok(answer)
}

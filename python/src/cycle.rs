//! Periodic motions and their branches.

use machinist::Simulation;
use machinist::periodic::{
    BranchSettings, Cycle, CycleError, CycleSettings, Period, Stability, branch as branch_of,
    cycle as cycle_of,
};
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyList};

use crate::arrays::array;
use crate::failure::Failure;
use crate::machine::Machine;
use crate::patience::Patience;
use crate::run::Run;
use crate::settings::Settings;

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

/// Searches with the settings of a run; releases the GIL.
fn searched<T: Send>(
    py: Python<'_>,
    machine: &Machine,
    settings: &Bound<'_, PyDict>,
    search: Search,
    job: impl FnOnce(&Simulation<'_>, CycleSettings) -> Result<T, CycleError> + Send,
) -> Result<T, Failure> {
    let settings = Settings::of(settings)?;
    let (period, guess, turns, settle, (multiple, segments, points)) = search;
    let period = match period {
        Some(Asked::Parameter(name)) => Period::Parameter(name),
        Some(Asked::Given(time)) => Period::Given(time),
        None => Period::Unknown(guess),
    };
    let (found, quiet) = py.detach(|| {
        let patience = Patience::new();
        let end = || patience.end();
        let found = machine.source.with(|simulator| -> Result<T, Failure> {
            let mut run = settings.apply(Simulation::new(simulator))?.until_told(&end);
            if !settings.has_tolerance() {
                let rtol = run.relative_tolerance().min(RTOL);
                run = run.rtol(rtol);
            }
            let end = settings.end().unwrap_or(simulator.run_defaults().until);
            let settle = settle.unwrap_or((end - run.start_time()).max(0.0));
            let cycle = CycleSettings {
                period,
                multiple,
                turns,
                settle,
                segments,
                points,
                ..CycleSettings::default()
            };
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

/// A branch of periodic motions over a parameter, as a dictionary.
#[pyfunction]
pub fn branch<'py>(
    py: Python<'py>,
    machine: &Machine,
    settings: &Bound<'py, PyDict>,
    search: Search,
    over: (String, f64, f64),
    steps: (f64, usize),
) -> Result<Bound<'py, PyDict>, Failure> {
    let (parameter, from, to) = over;
    let (longest_step, max_points) = steps;
    let found = searched(py, machine, settings, search, |run, cycle| {
        branch_of(run, &BranchSettings { cycle, parameter, from, to, longest_step, max_points })
    })?;
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

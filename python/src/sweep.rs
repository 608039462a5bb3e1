//! Chunks of sweeps: consecutive variants of a machine, on threads of this process.

use machinist::error::nearest;
use machinist::sweep::{VariantRun, Wanted, each_on_its_own, one};
use machinist::{FieldSimulator, SimulateError, Simulation, Sweep};
use machinist_contract::Simulator;
use numpy::{PyArray1, PyArray2, PyArrayMethods, PyReadonlyArray2, PyUntypedArrayMethods};
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::failure::Failure;
use crate::machine::Machine;
use crate::settings::Settings;

/// Values, steps and reason of failure, if any, of every variant.
pub type Piece<'py> = (Bound<'py, PyArray2<f64>>, Bound<'py, PyArray1<u64>>, Vec<Option<String>>);

/// Runs variants: a row of `values` contains the parameters called `names`.
#[pyfunction]
#[pyo3(signature = (machine, settings, names, values, wanted, extremes, threads))]
#[expect(clippy::too_many_arguments, reason = "called from one place, the package's own")]
pub fn sweep_piece<'py>(
    py: Python<'py>,
    machine: &Machine,
    settings: &Bound<'py, PyDict>,
    names: Vec<String>,
    values: PyReadonlyArray2<'py, f64>,
    wanted: Vec<String>,
    extremes: bool,
    threads: usize,
) -> Result<Piece<'py>, Failure> {
    let settings = Settings::of(settings)?;
    let rows = rows(&values, &names)?;
    let (width, found) = py.detach(|| -> Result<_, Failure> {
        let (wanted, variants) = machine
            .source
            .with(|simulator| prepared(simulator, &settings, &names, &rows, &wanted, extremes))??;
        let each = if extremes { 2 } else { 1 };
        let runs = all_runs(machine, &settings, &variants, threads)?;
        let found: Vec<_> = runs
            .into_iter()
            .map(|run| match run {
                Ok(run) => Ok((wanted.values(&run), run.steps)),
                Err(error) => Err(error.to_string()),
            })
            .collect();
        Ok((each * wanted.places.len(), found))
    })?;
    Ok(piece(py, found, width))
}

/// Arrays of the values and steps of variants.
pub fn piece(
    py: Python<'_>,
    found: Vec<Result<(Vec<f64>, u64), String>>,
    width: usize,
) -> Piece<'_> {
    let table = PyArray2::<f64>::zeros(py, [found.len(), width], false);
    let mut steps = Vec::with_capacity(found.len());
    let mut errors = Vec::with_capacity(found.len());
    {
        let mut filled = table.readwrite();
        let mut filled = filled.as_array_mut();
        for (mut row, found) in filled.rows_mut().into_iter().zip(found) {
            match found {
                Ok((values, count)) => {
                    row.iter_mut().zip(values).for_each(|(place, value)| *place = value);
                    steps.push(count);
                    errors.push(None);
                }
                Err(why) => {
                    row.fill(f64::NAN);
                    steps.push(0);
                    errors.push(Some(why));
                }
            }
        }
    }
    (table, PyArray1::from_vec(py, steps), errors)
}

/// Number of variants with a negative mass, index of the first and the note of its run.
#[pyfunction]
#[expect(clippy::needless_pass_by_value, reason = "as Python hands it over")]
pub fn negative_inertias(
    py: Python<'_>,
    machine: &Machine,
    settings: &Bound<'_, PyDict>,
    names: Vec<String>,
    values: PyReadonlyArray2<'_, f64>,
) -> Result<Option<(usize, usize, String)>, Failure> {
    let settings = Settings::of(settings)?;
    let rows = rows(&values, &names)?;
    py.detach(|| {
        machine.source.with(|simulator| {
            let first = settings.apply(Simulation::new(simulator))?;
            let (_, variants) = prepared(simulator, &settings, &names, &rows, &[], false)?;
            let found = first.negative_inertias(&variants);
            Ok(found.map(|found| (found.count, found.first, found.note)))
        })?
    })
}

/// One row per variant, with one number per name.
pub fn rows(
    values: &PyReadonlyArray2<'_, f64>,
    names: &[String],
) -> Result<Vec<Vec<f64>>, Failure> {
    if values.shape()[1] != names.len() {
        let message = format!("{} columns for {} parameters", values.shape()[1], names.len());
        return Err(Failure::Refused("ShapeError", message));
    }
    Ok(values.as_array().rows().into_iter().map(|row| row.to_vec()).collect())
}

/// Requested columns and all parameters of every variant; rejects settings invalid for all.
pub fn prepared(
    simulator: &dyn Simulator<f64>,
    settings: &Settings,
    names: &[String],
    rows: &[Vec<f64>],
    wanted: &[String],
    extremes: bool,
) -> Result<(Wanted, Vec<Vec<f64>>), Failure> {
    let first = settings.apply(Simulation::new(simulator))?;
    let shape = simulator.shape();
    let mut places = Vec::with_capacity(names.len());
    for name in names {
        // Refuses what is not known.
        let _ = first.clone().parameter(name, 0.0)?;
        places.extend((0..shape.parameters).find(|k| simulator.parameter(*k).name == name));
    }
    match first.clone().max_steps(1).run() {
        Ok(_) | Err(SimulateError::Stopped { .. }) => {}
        Err(error) => {
            // A variant may be what makes sense of it.
            let is_of_values = matches!(
                error,
                SimulateError::ImpossibleStart { .. }
                    | SimulateError::NoEquilibrium(_)
                    | SimulateError::NotFinite { .. }
                    | SimulateError::RefusedParameters { .. }
                    | SimulateError::GuardIsZero { .. }
                    | SimulateError::RedundantConstraint { .. }
                    | SimulateError::SingularInertia { .. }
            );
            if !is_of_values {
                return Err(error.into());
            }
        }
    }
    let base = first.parameter_values().to_vec();
    let variant = |row: &Vec<f64>| {
        let mut all = base.clone();
        places.iter().zip(row).for_each(|(place, value)| all[*place] = *value);
        all
    };
    let outputs = (0..shape.outputs).map(|k| simulator.output(k).name);
    let known: Vec<&str> =
        outputs.chain((0..shape.states()).map(|k| simulator.state(k).name)).collect();
    let place = |name: &String| {
        known.iter().position(|known| known == name).ok_or_else(|| {
            let hint = nearest(name, known.iter().copied());
            let hint = hint.map_or_else(String::new, |name| format!(" (did you mean `{name}`?)"));
            let message =
                format!("scene `{}` has no output or state `{name}`{hint}", simulator.name());
            Failure::Refused("UnknownNameError", message)
        })
    };
    let places = wanted.iter().map(place).collect::<Result<_, _>>()?;
    Ok((Wanted { places, extremes }, rows.iter().map(variant).collect()))
}

/// Runs of all variants, in order.
pub fn all_runs(
    machine: &Machine,
    settings: &Settings,
    variants: &[Vec<f64>],
    threads: usize,
) -> Result<Vec<Result<VariantRun, SimulateError>>, Failure> {
    all_runs_of(machine, settings, variants, threads, |run| run)
}

/// Like [`all_runs`], with settings that depend on the parameters of a variant.
pub fn all_runs_of(
    machine: &Machine,
    settings: &Settings,
    variants: &[Vec<f64>],
    threads: usize,
    of_variant: impl for<'s> Fn(Simulation<'s>) -> Simulation<'s> + Sync,
) -> Result<Vec<Result<VariantRun, SimulateError>>, Failure> {
    let Some(shared) = machine.source.shared() else {
        let run = |simulator: &FieldSimulator<'_, f64>, variant: &[f64]| {
            let run = settings.apply(Simulation::new(simulator.single()))?.parameters(variant);
            one(&of_variant(run))
        };
        return each_on_its_own(variants, threads, || machine.source.cut(), run);
    };
    let sweep = Sweep::new(&shared).variants(variants.to_vec()).threads(threads);
    // Names have been found before.
    let sweep = sweep.each(|run| settings.apply(run.clone()).unwrap_or(run));
    Ok(sweep.of_variant(of_variant).run())
}

//! Fits of parameters to measurements.

use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Instant;

use machinist::error::StopCause;
use machinist::fit::{
    Bounds, End, Experiment, Findings, Fit, Fitted, Measured, Noise, Plan, Unknown, Unsolved,
};
use machinist::{SimulateError, Simulation, constraints};
use machinist_contract::Simulator;
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::arrays::numbers;
use crate::failure::Failure;
use crate::machine::Machine;
use crate::patience::Patience;
use crate::settings::Settings;

/// A name, with optional bounds.
type Asked = (String, Option<(f64, f64)>);
/// Times, and columns by name.
type Run<'py> = (Bound<'py, PyAny>, Vec<(String, Bound<'py, PyAny>)>);

/// Settings of a search.
struct Search {
    sigma: Vec<(String, f64)>,
    is_robust: bool,
    starts: usize,
    steps: usize,
}

/// Fits parameters; returns the findings as JSON and the reason for termination.
#[pyfunction]
#[expect(clippy::too_many_arguments, reason = "called from one place, the package's own")]
pub fn fit<'py>(
    py: Python<'py>,
    machine: &Machine,
    settings: &Bound<'py, PyDict>,
    asked: Vec<Asked>,
    runs: Vec<Run<'py>>,
    sigma: Vec<(String, f64)>,
    is_robust: bool,
    starts: usize,
    steps: usize,
) -> Result<Bound<'py, PyDict>, Failure> {
    let settings = Settings::of(settings)?;
    let measured = runs.into_iter().map(measured).collect::<Result<Vec<_>, _>>()?;
    if starts == 0 || steps == 0 {
        return Err(Failure::input("starts and steps are at least 1"));
    }
    let search = Search { sigma, is_robust, starts, steps };
    let (found, quiet) = py.detach(|| {
        let patience = Patience::new();
        let solve = |simulator: &dyn Simulator<f64>| {
            solved(simulator, &settings, &asked, &measured, &search, &patience)
        };
        (machine.source.with(solve), patience.require_quiet())
    });
    quiet?;
    let (fitted, findings) = found??;
    let answer = PyDict::new(py);
    let json =
        serde_json::to_string(&findings).map_err(|error| Failure::input(error.to_string()))?;
    answer.set_item("findings", json)?;
    let end = match fitted.found.end {
        End::Converged => "converged",
        // Nothing is better than as exact as the runs themselves.
        End::Stuck if findings.outputs.iter().all(|output| output.is_rounding) => "converged",
        End::Steps => "steps",
        End::Interrupted => "interrupted",
        End::Stuck => "stuck",
    };
    answer.set_item("end", end)?;
    answer.set_item("steps", fitted.steps)?;
    answer.set_item("runs", fitted.runs)?;
    answer.set_item("failed", fitted.found.failed.0 + fitted.lost.0)?;
    answer.set_item("why_failed", fitted.found.failed.1.or(fitted.lost.1))?;
    Ok(answer)
}

fn measured((times, columns): Run<'_>) -> Result<Measured, Failure> {
    let times = numbers("times", &times, None)?.as_slice().to_vec();
    let column = |(name, values): (String, Bound<'_, PyAny>)| {
        let values = numbers(&format!("column `{name}`"), &values, Some(times.len()))?;
        Ok((name, values.as_slice().to_vec()))
    };
    let columns = columns.into_iter().map(column).collect::<Result<_, Failure>>()?;
    Ok(Measured { times, columns })
}

fn solved(
    simulator: &dyn Simulator<f64>,
    settings: &Settings,
    asked: &[Asked],
    measured: &[Measured],
    search: &Search,
    patience: &Patience,
) -> Result<(Fitted, Findings), Failure> {
    let flag = AtomicBool::new(false);
    // A fit as a whole has the time that a run would have.
    let deadline = settings.time_limit.and_then(|limit| Instant::now().checked_add(limit));
    let is_late = || deadline.is_some_and(|deadline| deadline <= Instant::now());
    let end = || {
        let late = || is_late().then_some(StopCause::Interrupted);
        patience.end().or_else(late).inspect(|_| flag.store(true, Ordering::Relaxed))
    };
    let run = settings.apply(Simulation::new(simulator))?.until_told(&end);
    let from = settings.start().unwrap_or(simulator.run_defaults().from);
    require_times(measured, from)?;
    let unknowns = unknowns(simulator, &run, asked, from)?;
    let values = measured.iter().flat_map(|run| &run.columns).flat_map(|(_, values)| values);
    let count = values.filter(|value| !value.is_nan()).count();
    if count < unknowns.len() {
        let message = format!("{count} values are too few for {} unknowns", unknowns.len());
        return Err(Failure::input(message));
    }
    let names: Vec<&str> = unknowns.iter().map(|unknown| &*unknown.name).collect();
    // What no variant would do either.
    match run.clone().points(2).max_steps(1).sensitivities(&names)?.run() {
        Ok(_) | Err(SimulateError::Stopped { .. }) => {}
        Err(error) => return Err(error.into()),
    }
    let experiments: Vec<Experiment> =
        measured.iter().enumerate().map(|(number, run)| experiment(number, run, search)).collect();
    let limit = Fit::new(&run, &unknowns, &experiments).step_limit();
    let run = run.max_steps(limit);
    let fit = Fit::new(&run, &unknowns, &experiments);
    let plan = Plan {
        is_robust: search.is_robust,
        starts: search.starts,
        steps: search.steps,
        interrupt: Some(&flag),
    };
    let fitted = fit.solve(&plan, &mut |_, _| {}).map_err(|unsolved| {
        let hint = match unsolved {
            Unsolved::NoStart { .. } => ". Hint: other bounds or parameters may help",
            _ => "",
        };
        Failure::Coded("AnalysisError", unsolved.code(), format!("{unsolved}{hint}"))
    })?;
    let findings = fit.findings(&fitted);
    Ok((fitted, findings))
}

/// A measured run with the known noise.
fn experiment(number: usize, measured: &Measured, search: &Search) -> Experiment {
    let is_measured =
        |(name, _): &&(String, f64)| measured.columns.iter().any(|(column, _)| column == name);
    let noise = search.sigma.iter().filter(is_measured);
    let noise = noise.map(|(name, sigma)| (name.clone(), Noise::constant(*sigma))).collect();
    Experiment { noise, ..Experiment::new(&number.to_string(), measured.clone()) }
}

/// Requires times that ascend from the start of the run and end after it.
fn require_times(measured: &[Measured], from: f64) -> Result<(), Failure> {
    for (number, run) in measured.iter().enumerate() {
        let mut latest = from;
        for (row, time) in run.times.iter().enumerate() {
            if !(latest <= *time && time.is_finite()) {
                let message = format!(
                    "run {number}, row {row}: the time {time} s is before {latest} s. \
                     Hint: times ascend from the start of the run; `start` gives another start"
                );
                return Err(Failure::input(message));
            }
            latest = *time;
        }
        if latest <= from {
            let message = format!("run {number}: nothing is measured after its start, {from} s");
            return Err(Failure::input(message));
        }
        let mut values = run.columns.iter();
        if let Some((name, _)) = values.find(|(_, all)| all.iter().any(|value| value.is_infinite()))
        {
            let message = format!("run {number}: `{name}` is infinite. Hint: NaN is a gap");
            return Err(Failure::input(message));
        }
    }
    Ok(())
}

fn unknowns(
    simulator: &dyn Simulator<f64>,
    run: &Simulation<'_>,
    asked: &[Asked],
    from: f64,
) -> Result<Vec<Unknown>, Failure> {
    let shape = simulator.shape();
    let start = constraints::start(simulator, run.parameter_values(), from)?;
    let mut unknowns: Vec<Unknown> = Vec::new();
    for (name, bounds) in asked {
        if unknowns.iter().any(|other| other.name == *name) {
            return Err(Failure::input(format!("`{name}` is asked for twice")));
        }
        if let Some((low, high)) = bounds
            && (low >= high || low.is_nan() || high.is_nan())
        {
            return Err(Failure::input(format!("bounds of `{name}`: {low} is not below {high}")));
        }
        let parameter = (0..shape.parameters).find(|k| simulator.parameter(*k).name == name);
        let state = (0..shape.states()).find(|k| simulator.state(*k).name == name);
        let value = match (parameter, state) {
            (Some(index), _) => run.parameter_values()[index],
            (None, Some(index)) => start[index],
            (None, None) => {
                // Says what is like it.
                let _ = run.clone().sensitivities(&[name])?;
                continue;
            }
        };
        unknowns.push(Unknown::from(name, value, bounds.map(|(low, high)| Bounds { low, high })));
    }
    Ok(unknowns)
}

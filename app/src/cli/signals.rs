//! Signals of a run that a command analyses: outputs or states over an interval of time.

use machinist::trajectory::{Column, ColumnKind, Trajectory};

use super::arguments::SpanArgs;
use super::scene::Scene;
use crate::failure::Failure;

/// Returns the columns with these names, or all outputs, or all states if there are none. Their
/// values must be finite; `what` names the analysis that needs them.
pub fn finite<'t>(
    run: &'t Trajectory,
    names: &[String],
    what: &str,
) -> Result<Vec<&'t Column>, Failure> {
    let chosen = chosen(run, names)?;
    for column in &chosen {
        let mut values = run.times.iter().zip(&column.values);
        if let Some((time, value)) = values.find(|(_, value)| !value.is_finite()) {
            let message = format!("`{}` is {value} at {time} s", column.name);
            return Err(Failure::unsuccessful(message, format!("{what} needs finite values")));
        }
    }
    Ok(chosen)
}

fn chosen<'t>(run: &'t Trajectory, names: &[String]) -> Result<Vec<&'t Column>, Failure> {
    let of = |kind| run.of_kind(kind);
    if names.is_empty() {
        let outputs: Vec<&Column> = of(ColumnKind::Output).collect();
        let states = || of(ColumnKind::State).collect();
        return Ok(if outputs.is_empty() { states() } else { outputs });
    }
    let known: Vec<&Column> = of(ColumnKind::Output).chain(of(ColumnKind::State)).collect();
    let find = |name: &String| {
        known.iter().copied().find(|column| column.name == *name).ok_or_else(|| {
            let names = known.iter().map(|column| column.name.as_str());
            let message =
                format!("scene `{}` has no output or state `{}`", run.scene, name.escape_debug());
            Failure::unknown(message, name, names)
        })
    };
    names.iter().map(find).collect()
}

/// Returns the interval from `settle` after the start of a run to its end.
pub fn interval(
    span: &SpanArgs,
    settle: Option<f64>,
    scene: &Scene,
) -> Result<(f64, f64), Failure> {
    let simulator = scene.simulator();
    let start = span.start_time(simulator);
    let from = start + settle.unwrap_or(0.0);
    let until = span.until.unwrap_or(simulator.run_defaults().until);
    if from >= start && from < until && until.is_finite() {
        return Ok((from, until));
    }
    let message = format!("the interval from {from} s to {until} s is empty");
    Err(Failure::input(message, format!("the run begins at {start} s")))
}

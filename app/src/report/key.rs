//! Key figures of a run.

use machinist::trajectory::{Column, ColumnKind, Trajectory};
use maud::{Markup, html};

use super::modes::Modes;
use crate::number::number;
use crate::plot::alike;
use crate::rounding::Rounding;

/// Distance from its final value within which an output counts as at rest, relative to its range.
const REST: f64 = 0.02;
/// Fraction of the run before which outputs must have come to rest.
const EARLY: f64 = 0.9;
/// Damping ratios below this are rounding.
const UNDAMPED: f64 = 1e-9;
/// Units of loads and of speeds. The first unit that an output has is used.
const LOADS: [&str; 6] = ["N m", "N", "Pa", "N/m", "V", "A"];
const SPEEDS: [&str; 2] = ["rad/s", "m/s"];

/// Key figure.
pub struct Figure {
    /// Name of the figure.
    pub what: String,
    /// Number with its unit, or words if there is no number.
    pub value: String,
    /// Remark; may be empty.
    pub note: String,
}

impl Figure {
    /// Renders the figure as an entry of a list of terms.
    pub fn entry(&self) -> Markup {
        html! {
            div {
                dt { (self.what) }
                dd { (self.value) }
                @if !self.note.is_empty() { dd.note { (self.note) } }
            }
        }
    }
}

/// Returns the key figures of a run and of the eigenmodes at its end.
pub fn figures(run: &Trajectory, modes: Option<&Modes>) -> Vec<Figure> {
    let mut figures = Vec::new();
    let mut say = |what: &str, value: String, note: String| {
        figures.push(Figure { what: what.to_owned(), value, note });
    };
    for units in [&LOADS[..], &SPEEDS] {
        if let Some((column, value, time)) = units.iter().find_map(|unit| greatest_of(run, unit)) {
            let value = format!("{} {}", number(value, 4), column.unit);
            let what = format!("greatest {}", column.name.replace('_', " "));
            say(&what, value, format!("at {} s", number(time, 3)));
        }
    }
    if let Some((frequency, damping)) = modes.and_then(|modes| modes.slowest) {
        let value = format!("{} Hz", number(frequency / std::f64::consts::TAU, 4));
        let note = match damping {
            ratio if ratio.abs() < UNDAMPED => "undamped".to_owned(),
            ratio => format!("damping ratio {}", number(ratio, 2)),
        };
        say("slowest oscillation", value, note);
    }
    if let Some(time) = rest(run) {
        let value = format!("{} s", number(time, 3));
        let within = format!("outputs within {} % of their range", number(100.0 * REST, 2));
        say("at rest from", value, within);
    }
    if let Some(balance) = &run.energy_balance {
        let last = |values: &[f64]| number(values.last().copied().unwrap_or(f64::NAN), 4);
        let lost = format!("lost {} J", last(&balance.dissipated));
        say("energy supplied", format!("{} J", last(&balance.supplied)), lost);
    }
    figures
}

/// Returns the outputs, or the states if there are no outputs.
pub(super) fn shown(run: &Trajectory) -> impl Iterator<Item = &Column> {
    let has_outputs = run.of_kind(ColumnKind::Output).next().is_some();
    run.of_kind(if has_outputs { ColumnKind::Output } else { ColumnKind::State })
}

/// Returns the curves to show if there is room for one plot: those alike with the greatest load, or
/// with the greatest speed if there are no loads, else the first that move.
pub(super) fn foremost(run: &Trajectory) -> Vec<&Column> {
    let greatest = [&LOADS[..], &SPEEDS].into_iter().flatten();
    let mut greatest = greatest.filter_map(|unit| greatest_of(run, unit));
    let moves = |column: &&Column| {
        let first = column.values.first().copied().unwrap_or(f64::NAN);
        column.values.iter().any(|value| (value - first).abs() > 0.0)
    };
    let named = greatest.find(|(column, ..)| moves(column)).map(|(column, ..)| &column.name);
    let mut groups = alike(shown(run).filter(moves)).into_iter();
    let is_named = |group: &Vec<&Column>| {
        named.is_none_or(|name| group.iter().any(|column| column.name == *name))
    };
    groups.find(is_named).unwrap_or_default()
}

/// Returns the value largest in size among the columns of a unit, with its column and time.
fn greatest_of<'a>(run: &'a Trajectory, unit: &str) -> Option<(&'a Column, f64, f64)> {
    let columns = shown(run).filter(|column| column.unit == unit);
    let all = columns.flat_map(|column| {
        column.values.iter().zip(&run.times).map(move |(value, time)| (column, *value, *time))
    });
    all.filter(|(_, value, _)| value.is_finite()).max_by(|a, b| a.1.abs().total_cmp(&b.1.abs()))
}

/// Returns the time from which all outputs stay near their final values. `None` if no output moves,
/// or if they come to rest only near the end.
fn rest(run: &Trajectory) -> Option<f64> {
    let (first, last) = (*run.times.first()?, *run.times.last()?);
    let mut latest = None;
    for column in shown(run) {
        let low = column.values.iter().copied().fold(f64::INFINITY, f64::min);
        let high = column.values.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        let end = *column.values.last()?;
        let is_far = |value: &f64| (value - end).abs() > REST * (high - low);
        let Some(far) = column.values.iter().rposition(is_far) else { continue };
        let time = run.times.get(far + 1).copied().unwrap_or(last);
        latest = Some(latest.map_or(time, |latest: f64| latest.max(time)));
    }
    latest.filter(|latest| latest - first <= EARLY * (last - first))
}

/// Renders a table of the first, last, least and greatest value of every output.
pub fn table(run: &Trajectory) -> Markup {
    let rounding = Rounding::of(run);
    html! {
        div.scroll {
            table {
                thead { tr {
                    th { "Output" } th.number { "At start" } th.number { "At end" }
                    th.number { "Least" } th.number { "Greatest" } th { "Unit" } th { "Meaning" }
                } }
                tbody { @for column in shown(run) { (row(run, &rounding, column)) } }
            }
        }
    }
}

fn row(run: &Trajectory, rounding: &Rounding<'_>, column: &Column) -> Markup {
    let rid = rounding.rid(column);
    let end = |value: Option<&f64>| number(value.copied().unwrap_or(f64::NAN), 5);
    let values = || rid.iter().zip(&run.times).filter(|(value, _)| value.is_finite());
    let by = |a: &(&f64, &f64), b: &(&f64, &f64)| a.0.total_cmp(b.0);
    let extreme = |found: Option<(&f64, &f64)>| {
        let (value, time) = found.unwrap_or((&f64::NAN, &f64::NAN));
        html! { td.number {
            (number(*value, 5)) div.muted { "at " (number(*time, 4)) " s" }
        } }
    };
    html! {
        tr data-output=(column.name) {
            td { code { (column.name) } }
            td.number { (end(rid.first())) }
            td.number { (end(rid.last())) }
            (extreme(values().min_by(by)))
            (extreme(values().max_by(by)))
            td.unit { (column.unit) }
            td { (column.doc) }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use machinist::Simulation;
    use machinist_scenes::scenes::find_f64;

    fn run(until: f64) -> Trajectory {
        let simulator = find_f64("two_mass").expect("a scene");
        Simulation::new(simulator).until(until).run().expect("a run")
    }

    #[test]
    fn a_machine_that_still_speeds_up_is_not_at_rest() {
        assert_eq!(rest(&run(0.5)), None);
    }

    #[test]
    fn the_greatest_load_is_found_with_its_time() {
        let run = run(0.5);
        let (column, value, time) = greatest_of(&run, "N m").expect("a torque");
        let values = &run.find(&column.name).expect("a column").values;
        let at = run.times.partition_point(|known| *known < time);
        assert!((values[at] - value).abs() < 1e-12 * value.abs());
        assert!(values.iter().all(|other| other.abs() <= value.abs()));
    }
}

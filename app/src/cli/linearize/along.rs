//! `machinist linearize --along`: models along a run.

use std::fmt::Write as _;

use machinist::linear_analysis::{Piece, Signal, StateSpace};
use serde::Serialize;

use crate::failure::Failure;
use crate::matrices::Entry;
use crate::number::number;

/// Models along a run, as data.
#[derive(Serialize)]
pub struct Along<'a> {
    pub scene: &'a str,
    #[serde(skip)]
    pub title: &'a str,
    pub pieces: &'a [Piece],
}

const DIGITS: usize = 6;

impl Along<'_> {
    /// Returns the answer as JSON.
    pub fn json(&self) -> Result<String, Failure> {
        serde_json::to_string_pretty(self).map_err(|error| Failure::unsuccessful(error, ""))
    }

    /// Formats the answer for people.
    pub fn describe(&self) -> String {
        let mut text = format!("{}: {}\nlinear models along the run\n", self.scene, self.title);
        for (index, piece) in self.pieces.iter().enumerate() {
            let first = &piece.models[0];
            let last = piece.models.last().unwrap_or(first);
            let [from, until] = [first.time, last.time].map(|time| number(time, DIGITS));
            let names = |signals: &[Signal]| {
                signals.iter().map(|signal| signal.name.as_str()).collect::<Vec<_>>().join(", ")
            };
            let span = if from == until { from } else { format!("{from} s to {until}") };
            let models = match piece.models.len() {
                1 => "1 model".to_owned(),
                count => format!("{count} models"),
            };
            let _ = write!(
                text,
                "\npiece {}, {span} s: {models} of order {}\n  states: {}\n",
                index + 1,
                first.states.len(),
                names(&first.states)
            );
            if !first.eliminated.is_empty() {
                let names = first.eliminated.join(", ");
                let _ = writeln!(text, "  determined by constraints and left out: {names}");
            }
            if !piece.modes.is_empty() {
                let modes = piece.modes.iter();
                let modes: Vec<String> =
                    modes.map(|(name, value)| format!("{name} {value}")).collect();
                let _ = writeln!(text, "  modes: {}", modes.join(", "));
            }
            text.push_str(&growth(piece));
        }
        text.push_str("\nA, B, C and D at each time: see --json and --out\n");
        text
    }

    /// Returns the named matrices of a `.mat` or `.npz` file: those of piece 1 have names that end
    /// in 1, and their models are stacked row by row.
    pub fn entries(&self) -> Vec<(String, Entry)> {
        let mut entries = vec![
            ("scene".to_owned(), Entry::Text(self.scene.to_owned())),
            ("pieces".to_owned(), Entry::number(self.pieces.len() as f64)),
        ];
        for (index, piece) in self.pieces.iter().enumerate() {
            let number = index + 1;
            let first = &piece.models[0];
            let (n, m) = (first.states.len(), first.inputs.len());
            let stacked = |of: fn(&StateSpace) -> &Vec<Vec<f64>>, width: usize| {
                let rows = piece.models.iter().flat_map(|model| of(model).iter().cloned());
                Entry::Matrix(rows.collect(), width)
            };
            let values = |of: fn(&StateSpace) -> Vec<f64>, width: usize| {
                Entry::Matrix(piece.models.iter().map(of).collect(), width)
            };
            let signals =
                |of: &[Signal]| Entry::Names(of.iter().map(|signal| signal.name.clone()).collect());
            let own = [
                ("A", stacked(|model| &model.a, n)),
                ("B", stacked(|model| &model.b, m)),
                ("C", stacked(|model| &model.c, n)),
                ("D", stacked(|model| &model.d, m)),
                ("t", values(|model| vec![model.time], 1)),
                ("x", values(|model| value(&model.states), n)),
                ("y", values(|model| value(&model.outputs), first.outputs.len())),
                ("drift", values(|model| model.drift.clone(), n)),
                ("states", signals(&first.states)),
                ("inputs", signals(&first.inputs)),
                ("outputs", signals(&first.outputs)),
            ];
            entries.extend(own.map(|(name, entry)| (format!("{name}{number}"), entry)));
        }
        entries
    }
}

fn value(signals: &[Signal]) -> Vec<f64> {
    signals.iter().map(|signal| signal.value).collect()
}

/// Formats the range of the largest real part of the poles. A part that is only rounding is zero.
fn growth(piece: &Piece) -> String {
    const ROUNDING: f64 = 1e-13;
    let largest = |model: &StateSpace| {
        let poles = model.poles().ok()?;
        let size = poles.iter().map(|pole| pole.norm()).fold(0.0, f64::max);
        let most = poles.iter().map(|pole| pole.re).reduce(f64::max)?;
        Some(if most.abs() <= ROUNDING * size { 0.0 } else { most })
    };
    let found: Option<Vec<f64>> = piece.models.iter().map(largest).collect();
    let Some(found) = found.filter(|found| !found.is_empty()) else { return String::new() };
    let [least, most] = [f64::min as fn(f64, f64) -> f64, f64::max]
        .map(|choose| found.iter().copied().reduce(choose).unwrap_or(f64::NAN));
    let [least, most] = [least, most].map(|value| number(value, DIGITS));
    let range = if least == most { least } else { format!("{least} to {most}") };
    format!("  largest real part of a pole: {range} 1/s\n")
}

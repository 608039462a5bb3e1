//! Counted cycles of all outputs, and what is written of them.

use std::io;
use std::path::Path;

use machinist::fatigue::{CountedCycle, Curve, Residue, equivalent_amplitude, rainflow};
use machinist::trajectory::{Column, ColumnKind, Trajectory};
use serde_json::{Value, json};

use super::curve::CurveArgs;
use crate::cli::output::{columns, remarks};
use crate::cli::scene::Scene;
use crate::failure::Failure;
use crate::number::number;
use crate::parquet::{self, Values};

/// Number of places of the plot.
const PLACES: usize = 400;
const HOUR: f64 = 3600.0;

/// Cycles of one output.
pub struct Signal {
    name: String,
    unit: String,
    cycles: Vec<CountedCycle>,
    /// Times of the turning points of each cycle, the earlier one first \[s\].
    times: Vec<[f64; 2]>,
    curve: Option<Curve>,
    told: String,
    /// Constant amplitude with the same damage in the same number of cycles.
    equivalent: f64,
    slope: f64,
}

/// Cycles of all outputs over one interval.
pub struct Loads {
    pub signals: Vec<Signal>,
    pub interval: (f64, f64),
    pub is_repeated: bool,
    pub samples: usize,
    pub gate: f64,
    pub is_coarse: bool,
    pub classes: usize,
}

/// Returns the least and the greatest value.
pub fn ends(values: &[f64]) -> (f64, f64) {
    values.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| {
        (low.min(*value), high.max(*value))
    })
}

/// Returns the difference of the greatest and the least value.
pub fn range(values: &[f64]) -> f64 {
    let (low, high) = ends(values);
    (high - low).max(0.0)
}

impl Signal {
    /// Counts the cycles of a column.
    pub fn of(
        column: &Column,
        times: &[f64],
        gate: f64,
        residue: Residue,
        args: &CurveArgs,
    ) -> Result<Self, Failure> {
        let mut cycles = rainflow(&column.values, gate * range(&column.values), residue);
        cycles.sort_by(|a, b| b.range.total_cmp(&a.range));
        let (slope, mean) = (args.slope, args.mean());
        let equivalent = equivalent_amplitude(&cycles, slope, mean);
        if equivalent.is_infinite() {
            let message = format!("the mean of a cycle of `{}` reaches the strength", column.name);
            return Err(Failure::input(message, "the strength of --mean is in the output's unit"));
        }
        Ok(Self {
            name: column.name.clone(),
            unit: column.unit.clone(),
            times: cycles
                .iter()
                .map(|CountedCycle { samples: [a, b], .. }| [times[*a.min(b)], times[*a.max(b)]])
                .collect(),
            curve: args.of(&column.name),
            told: args.describe(),
            cycles,
            equivalent,
            slope,
        })
    }

    fn number(&self) -> f64 {
        self.cycles.iter().map(|cycle| cycle.count).sum()
    }

    fn damage(&self) -> Option<f64> {
        self.curve.map(|curve| curve.sum(&self.cycles))
    }

    /// Returns the classes that hold cycles, the largest ranges first: bounds of the range, number,
    /// mean of the means, damage.
    fn classes(&self, count: usize) -> Vec<Class> {
        let largest = self.cycles.first().map_or(0.0, |cycle| cycle.range);
        let width = largest / count as f64;
        let index = |cycle: &CountedCycle| ((cycle.range / width) as usize).min(count - 1);
        let class = |at: usize| {
            let those = self.cycles.iter().filter(|cycle| index(cycle) == at);
            let mut class =
                Class { from: width * at as f64, to: width * (at + 1) as f64, ..Class::default() };
            for cycle in those {
                class.count += cycle.count;
                class.mean += cycle.count * cycle.mean;
                class.damage += self.curve.map_or(0.0, |curve| curve.damage(cycle));
            }
            class.mean /= class.count;
            class
        };
        (0..count).rev().map(class).filter(|class| class.count > 0.0).collect()
    }
}

/// Cycles whose ranges lie between bounds.
#[derive(Debug, Clone, Copy, Default)]
struct Class {
    from: f64,
    to: f64,
    count: f64,
    mean: f64,
    damage: f64,
}

impl Loads {
    /// Returns numbers of cycles and, for each output, the amplitude that so many cycles reach.
    pub fn collectives(&self) -> (Vec<f64>, Vec<Column>) {
        let most = self.signals.iter().map(Signal::number).fold(1.0, f64::max);
        let least: f64 = 0.5;
        let place = |at: usize| least * (most / least).powf(at as f64 / (PLACES - 1) as f64);
        let places: Vec<f64> = (0..PLACES).map(place).collect();
        let column = |signal: &Signal| {
            let (mut reached, mut next) = (0.0, 0);
            let value = |place: &f64| {
                // Rounding of the last place must not lose the last cycle.
                while next < signal.cycles.len() && reached < place * (1.0 - 1e-9) {
                    reached += signal.cycles[next].count;
                    next += 1;
                }
                let is_reached = reached >= place * (1.0 - 1e-9) && next > 0;
                if is_reached { signal.cycles[next - 1].amplitude() } else { f64::NAN }
            };
            Column {
                name: signal.name.clone(),
                unit: signal.unit.clone(),
                kind: ColumnKind::Output,
                doc: String::new(),
                values: places.iter().map(value).collect(),
            }
        };
        let columns = self.signals.iter().map(column).collect();
        (places, columns)
    }

    fn rows(&self) -> impl Iterator<Item = (&Signal, &CountedCycle, [f64; 2])> {
        self.signals.iter().flat_map(|signal| {
            let cycles = signal.cycles.iter().zip(&signal.times);
            cycles.map(move |(cycle, times)| (signal, cycle, *times))
        })
    }

    pub fn write_csv(&self, out: impl io::Write) -> io::Result<()> {
        let mut table = csv::Writer::from_writer(out);
        table.write_record([
            "output",
            "unit",
            "range",
            "mean",
            "count",
            "from [s]",
            "until [s]",
            "damage",
        ])?;
        for (signal, cycle, [from, until]) in self.rows() {
            let damage =
                signal.curve.map_or_else(String::new, |curve| format!("{:?}", curve.damage(cycle)));
            let numbers = [cycle.range, cycle.mean, cycle.count, from, until];
            let mut row = vec![signal.name.clone(), signal.unit.clone()];
            row.extend(numbers.map(|value| format!("{value:?}")));
            row.push(damage);
            table.write_record(row)?;
        }
        table.flush()
    }

    pub fn as_columns(&self) -> Vec<parquet::Column> {
        type Row<'r> = (&'r Signal, &'r CountedCycle, [f64; 2]);
        let texts = |name: &str, of: &dyn Fn(&Row<'_>) -> String| parquet::Column {
            name: name.to_owned(),
            unit: None,
            values: Values::Texts(self.rows().map(|row| Some(of(&row))).collect()),
        };
        let numbers = |name: &str, unit: Option<&str>, of: &dyn Fn(&Row<'_>) -> Option<f64>| {
            parquet::Column {
                name: name.to_owned(),
                unit: unit.map(str::to_owned),
                values: Values::Some(self.rows().map(|row| of(&row)).collect()),
            }
        };
        vec![
            texts("output", &|(signal, ..)| signal.name.clone()),
            texts("unit", &|(signal, ..)| signal.unit.clone()),
            numbers("range", None, &|(_, cycle, _)| Some(cycle.range)),
            numbers("mean", None, &|(_, cycle, _)| Some(cycle.mean)),
            numbers("count", Some("1"), &|(_, cycle, _)| Some(cycle.count)),
            numbers("from", Some("s"), &|(.., [from, _])| Some(*from)),
            numbers("until", Some("s"), &|(.., [_, until])| Some(*until)),
            numbers("damage", Some("1"), &|(signal, cycle, _)| {
                signal.curve.map(|curve| curve.damage(cycle))
            }),
        ]
    }

    pub fn json(&self, run: &Trajectory) -> Value {
        let (from, until) = self.interval;
        let output = |signal: &Signal| {
            let cycles = signal.cycles.iter().zip(&signal.times).map(|(cycle, [from, until])| {
                json!({
                    "range": cycle.range,
                    "mean": cycle.mean,
                    "count": cycle.count,
                    "from": from,
                    "until": until,
                    "damage": signal.curve.map(|curve| curve.damage(cycle)),
                })
            });
            let damage = signal.damage();
            let repeats = damage.filter(|damage| *damage > 0.0).map(f64::recip);
            json!({
                "name": signal.name,
                "unit": signal.unit,
                "curve": signal.curve,
                "number": signal.number(),
                "equivalent_amplitude": signal.equivalent,
                "slope": signal.slope,
                "damage": damage,
                "repeats": repeats,
                "life": repeats.map(|repeats| repeats * (until - from)),
                "cycles": cycles.collect::<Vec<_>>(),
            })
        };
        json!({
            "scene": run.scene,
            "from": from,
            "until": until,
            "samples": self.samples,
            "gate": self.gate,
            "repeated": self.is_repeated,
            "outputs": self.signals.iter().map(output).collect::<Vec<_>>(),
            "notes": run.notes,
        })
    }

    pub fn summary(&self, scene: &Scene, run: &Trajectory, files: &[Option<&Path>]) -> String {
        let (from, until) = self.interval;
        let residue = if self.is_repeated { "repeated" } else { "the rest as half cycles" };
        let mut text = format!(
            "{}: {} ({})\nrainflow cycles from {from} s to {until} s (ASTM E1049), {residue}; ranges \
             up to {} of the largest left out{}\n",
            run.scene,
            run.title,
            scene.how(),
            number(self.gate, 4),
            remarks(run, "--json"),
        );
        if self.is_coarse {
            text.push_str("turning points lie between samples: more --samples find them better\n");
        }
        let has_curve = self.signals.iter().any(|signal| signal.curve.is_some());
        if let Some(signal) = self.signals.iter().find(|signal| signal.curve.is_some()) {
            text.extend(["S-N curve: ", &signal.told, "\n"]);
        }
        let mut head = vec!["", "unit", "range from", "to", "cycles", "mean"];
        head.extend(has_curve.then_some("damage"));
        let mut rows = vec![head.into_iter().map(str::to_owned).collect::<Vec<_>>()];
        for signal in &self.signals {
            for (index, class) in signal.classes(self.classes).into_iter().enumerate() {
                let named = |text: &str| if index == 0 { text.to_owned() } else { String::new() };
                let mut row = vec![named(&signal.name), named(&signal.unit)];
                let numbers = [class.from, class.to, class.count, class.mean];
                row.extend(numbers.map(|value| number(value, 6)));
                if has_curve {
                    row.push(signal.curve.map_or_else(String::new, |_| number(class.damage, 4)));
                }
                rows.push(row);
            }
        }
        text.extend(["\n", &columns(&rows, 2), "\n"]);
        let mut heads = vec!["", "unit", "cycles", "largest amplitude", "equivalent amplitude"];
        heads.extend(
            has_curve.then_some(["damage", "runs to failure", "life [h]"]).into_iter().flatten(),
        );
        let mut rows = vec![heads.into_iter().map(str::to_owned).collect::<Vec<_>>()];
        for signal in &self.signals {
            let largest = signal.cycles.first().map_or(0.0, CountedCycle::amplitude);
            let mut row = vec![signal.name.clone(), signal.unit.clone()];
            row.extend([signal.number(), largest, signal.equivalent].map(|value| number(value, 6)));
            match signal.damage() {
                Some(damage) if damage > 0.0 => {
                    let life = (until - from) / damage / HOUR;
                    row.extend([damage, 1.0 / damage, life].map(|value| number(value, 4)));
                }
                Some(_) => row.extend(["0", "unlimited", "unlimited"].map(str::to_owned)),
                None if has_curve => row.extend([(); 3].map(|()| String::new())),
                None => {}
            }
            rows.push(row);
        }
        text.push_str(&columns(&rows, 2));
        for file in files.iter().flatten() {
            text.extend(["\nwrote ", &file.display().to_string()]);
        }
        text.trim_end().to_owned() + "\n"
    }
}

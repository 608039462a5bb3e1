//! `machinist sweep`: runs of many variants of one scene, written to a table.

use std::io;
use std::path::PathBuf;

use clap::Args;
use machinist::simulate::NegativeInertias;
use machinist::sweep::{VariantRun, Wanted};
use machinist::{SimulateError, Simulation};
use machinist_contract::Simulator;
use machinist_model::fingerprint::of_bytes;

use super::amount::as_json;
use super::arguments::{RunArgs, SceneArgs};
use super::output::{print_with, require_table, write_file};
use super::range::{Range, range};
use super::settings::with_parameters;
use super::variants::Variants;
use crate::failure::Failure;
use crate::parquet::{self, Column, Values};
use crate::progress::during;
use serde_json::{Map, Value, json};

/// Maximum number of variants of a sweep.
const MOST_VARIANTS: usize = 1_000_000;

#[derive(Debug, Args)]
pub struct Sweep {
    /// Parameter and its values, equally spaced, or logarithmically with `:log`; repeatable, for
    /// all combinations
    #[arg(long, visible_alias = "over", required = true, value_parser = range,
        value_name = "UNIT.PARAMETER=FROM..TO[:log]")]
    parameter: Vec<Range>,
    /// Number of values of each parameter
    #[arg(long, value_name = "NUMBER")]
    count: usize,
    /// Outputs or states to write
    #[arg(long, value_name = "NAMES", value_delimiter = ',')]
    outputs: Vec<String>,
    /// Write the minimum and the maximum over the output times instead of the final value
    #[arg(long)]
    extremes: bool,
    /// Number of output times, including both ends
    #[arg(long, value_name = "NUMBER")]
    points: Option<usize>,
    /// Number of threads. Default: the number of cores
    #[arg(long, value_name = "NUMBER")]
    threads: Option<usize>,
    /// Write to a .csv or .parquet file instead of standard output
    #[arg(short, long, help_heading = "Output", value_name = "FILE")]
    out: Option<PathBuf>,
    #[command(flatten)]
    scene: SceneArgs,
    #[command(flatten)]
    run: RunArgs,
}

impl Sweep {
    pub fn execute(&self) -> Result<(), Failure> {
        if let Some(file) = &self.out {
            require_table(file, &["csv"])?;
        }
        self.check_numbers()?;
        let scene = self.scene.load()?;
        // Invalid options are refused before any variant runs.
        let _ =
            self.run.apply(self.scene.machine.with_initial(Simulation::new(scene.simulator()))?)?;
        let wanted = self.wanted(scene.simulator())?;
        let variants = self.variants(scene.simulator())?;
        let runs = during("simulating", || self.settings().runs(&scene, &variants))?;
        if let Some(Err(error)) = runs.first()
            && !matches!(error, SimulateError::Stopped { .. })
            && runs.iter().all(|run| run.as_ref().err() == Some(error))
        {
            // The error is the same for all variants.
            return Err(error.clone().into());
        }

        let wanted = Wanted { places: wanted, extremes: self.extremes };
        let table = Table { sweep: self, wanted, variants: &variants, runs: &runs };
        match &self.out {
            Some(file) if parquet::is_named(file) => {
                let of = ("sweep", self.scene.scene.as_str(), &scene);
                let columns = table.columns(scene.simulator());
                let told = self.describe(scene.simulator(), &variants);
                parquet::write_table(file, &columns, of, told)?;
            }
            Some(file) => write_file(file, |out| table.write(scene.simulator(), out))?,
            None => print_with(|out| table.write(scene.simulator(), out))?,
        }
        self.tell_of_negative_inertias(scene.simulator(), &variants);
        let stopped = runs.iter().filter(|run| run.is_err()).count();
        if stopped == 0 {
            return Ok(());
        }
        let message = format!("{stopped} of {} variants stopped", runs.len());
        Err(Failure::unsuccessful(message, "the last column says where and why"))
    }

    /// Warns on standard error about variants with a negative mass.
    fn tell_of_negative_inertias(&self, simulator: &dyn Simulator<f64>, variants: &[Vec<f64>]) {
        let run = self.settings().adjust(Simulation::new(simulator));
        if let Some(NegativeInertias { count, first, note, .. }) = run.negative_inertias(variants) {
            let (all, row) = (variants.len(), first + 1);
            eprintln!("machinist: {count} of {all} variants, the first in row {row}: {note}");
        }
    }

    fn check_numbers(&self) -> Result<(), Failure> {
        if self.count < 2 {
            let message = format!("--count {}: a range has at least 2 values", self.count);
            return Err(Failure::input(message, "`--set` gives a parameter one value"));
        }
        let all =
            (0..self.parameter.len()).try_fold(1, |all: usize, _| all.checked_mul(self.count));
        if all.is_none_or(|all| all > MOST_VARIANTS) {
            let (count, parameters) = (self.count, self.parameter.len());
            let message = format!("{count} values of each of {parameters} parameters are too many");
            return Err(Failure::input(message, format!("at most {MOST_VARIANTS} variants")));
        }
        let names: Vec<&str> = self.parameter.iter().map(|range| range.name.as_str()).collect();
        if let Some(twice) = (1..names.len()).find(|index| names[..*index].contains(&names[*index]))
        {
            return Err(Failure::input(format!("--parameter {} is given twice", names[twice]), ""));
        }
        if self.threads == Some(0) {
            return Err(Failure::input("--threads 0: at least one is needed", ""));
        }
        Ok(())
    }

    /// Returns the indices of the wanted outputs and states: outputs first, then states.
    fn wanted(&self, simulator: &dyn Simulator<f64>) -> Result<Vec<usize>, Failure> {
        let shape = simulator.shape();
        let known: Vec<&str> = columns_of(simulator).collect();
        if self.outputs.is_empty() {
            let all = if shape.outputs > 0 { shape.outputs } else { known.len() };
            return Ok((0..all).collect());
        }
        let place = |name: &String| {
            known.iter().position(|known| known == name).ok_or_else(|| {
                Failure::unknown(
                    format!(
                        "scene `{}` has no output or state `{}`",
                        simulator.name(),
                        name.escape_debug()
                    ),
                    name,
                    known.iter().copied(),
                )
            })
        };
        self.outputs.iter().map(place).collect()
    }

    /// Returns all parameters of every variant. The last range varies fastest.
    fn variants(&self, simulator: &dyn Simulator<f64>) -> Result<Vec<Vec<f64>>, Failure> {
        let mut base = with_parameters(Simulation::new(simulator), &self.scene.machine.set)?;
        let mut variants = vec![base.parameter_values().to_vec()];
        for range in &self.parameter {
            // Unknown names are rejected.
            range.check(&base)?;
            base = base.parameter(&range.name, range.from)?;
            let Some(place) = place_of(simulator, &range.name) else { continue };
            let varied = variants.iter().flat_map(|variant| {
                (0..self.count).map(move |index| {
                    let mut variant = variant.clone();
                    variant[place] = range.value(index, self.count);
                    variant
                })
            });
            variants = varied.collect();
        }
        Ok(variants)
    }

    /// Returns the settings that determine the numbers besides the machine, as the Python package
    /// writes them.
    fn describe(&self, simulator: &dyn Simulator<f64>, variants: &[Vec<f64>]) -> Value {
        let names: Vec<&str> = self.parameter.iter().map(|range| range.name.as_str()).collect();
        let axes = self.parameter.iter().map(|range| {
            (0..self.count).map(|index| range.value(index, self.count)).collect::<Vec<f64>>()
        });
        let [set, initial] =
            [&self.scene.machine.set, &self.scene.machine.initial].map(|s| as_json(s));
        let outputs = if self.outputs.is_empty() {
            let places = self.wanted(simulator).unwrap_or_default();
            let known: Vec<&str> = columns_of(simulator).collect();
            places.into_iter().map(|place| known[place].to_owned()).collect()
        } else {
            self.outputs.clone()
        };
        let settings = [
            ("parameters", (!set.is_empty()).then_some(Value::Object(set))),
            ("points", self.points.or((!self.extremes).then_some(2)).map(Value::from)),
            ("initial", (!initial.is_empty()).then_some(Value::Object(initial))),
        ];
        let settings: Map<String, Value> = settings
            .into_iter()
            .chain(self.run.as_json())
            .filter_map(|(name, value)| Some((name.to_owned(), value?)))
            .collect();
        let places: Vec<usize> =
            names.iter().filter_map(|name| place_of(simulator, name)).collect();
        let numbers = variants.iter().flat_map(|variant| places.iter().map(|at| variant[*at]));
        let bytes: Vec<u8> = numbers.flat_map(f64::to_le_bytes).collect();
        json!({
            "design": {
                "kind": "grid",
                "names": names,
                "axes": axes.collect::<Vec<_>>(),
                "variants": variants.len(),
                "sha256": of_bytes(&bytes),
            },
            "settings": settings,
            "outputs": outputs,
            "extremes": self.extremes,
        })
    }

    fn settings(&self) -> Variants<'_> {
        let points = self.points.or((!self.extremes).then_some(2));
        Variants { scene: &self.scene, run: &self.run, points, threads: self.threads, flag: None }
    }
}

/// Returns the index of a parameter.
fn place_of(simulator: &dyn Simulator<f64>, name: &str) -> Option<usize> {
    (0..simulator.shape().parameters).position(|index| simulator.parameter(index).name == name)
}

/// Returns the names of outputs, then of states.
fn columns_of(simulator: &dyn Simulator<f64>) -> impl Iterator<Item = &str> {
    let shape = simulator.shape();
    let outputs = (0..shape.outputs).map(|index| simulator.output(index).name);
    outputs.chain((0..shape.states()).map(|index| simulator.state(index).name))
}

/// Table of a sweep: parameters, outputs, steps, and the reasons of variants that stopped.
struct Table<'a> {
    sweep: &'a Sweep,
    wanted: Wanted,
    variants: &'a [Vec<f64>],
    runs: &'a [Result<VariantRun, SimulateError>],
}

impl Table<'_> {
    fn write(&self, simulator: &dyn Simulator<f64>, out: &mut dyn io::Write) -> io::Result<()> {
        let mut writer = csv::Writer::from_writer(out);
        let any_stopped = self.runs.iter().any(Result::is_err);
        writer.write_record(self.header(simulator, any_stopped))?;
        let ranges = self.sweep.parameter.iter();
        let places: Vec<usize> =
            ranges.filter_map(|range| place_of(simulator, &range.name)).collect();
        for (variant, run) in self.variants.iter().zip(self.runs) {
            let mut record: Vec<String> =
                places.iter().map(|place| variant[*place].to_string()).collect();
            match run {
                Ok(run) => {
                    record.extend(self.wanted.values(run).iter().map(f64::to_string));
                    record.push(run.steps.to_string());
                    record.extend(any_stopped.then(String::new));
                }
                Err(error) => {
                    let each = if self.wanted.extremes { 2 } else { 1 };
                    record
                        .resize(record.len() + each * self.wanted.places.len() + 1, String::new());
                    record.push(error.to_string());
                }
            }
            writer.write_record(record)?;
        }
        writer.flush()
    }

    /// Returns the columns as the Python package has them, with a row for each variant: number,
    /// parameters, results, steps, and the reason if there are no results.
    fn columns(&self, simulator: &dyn Simulator<f64>) -> Vec<Column> {
        let shape = simulator.shape();
        let mut columns = vec![Column {
            name: "variant".to_owned(),
            unit: None,
            values: Values::Counts((0..self.runs.len() as i64).collect()),
        }];
        let places =
            self.sweep.parameter.iter().filter_map(|range| place_of(simulator, &range.name));
        for place in places {
            let quantity = simulator.parameter(place);
            let values = self.variants.iter().map(|variant| variant[place]).collect();
            columns.push(Column::numbers(quantity.name, quantity.unit, values));
        }
        let rows: Vec<Option<Vec<f64>>> =
            self.runs.iter().map(|run| run.as_ref().ok().map(|r| self.wanted.values(r))).collect();
        let ends: &[&str] = if self.wanted.extremes { &[".least", ".greatest"] } else { &[""] };
        let names = self.wanted.places.iter().flat_map(|place| {
            let quantity = match place.checked_sub(shape.outputs) {
                None => simulator.output(*place),
                Some(state) => simulator.state(state),
            };
            ends.iter().map(move |end| (format!("{}{end}", quantity.name), quantity.unit))
        });
        for (index, (name, unit)) in names.enumerate() {
            let values = rows.iter().map(|row| row.as_ref().map(|row| row[index])).collect();
            columns.push(Column {
                name,
                unit: Some(unit.to_owned()),
                values: Values::Some(values),
            });
        }
        let steps = |run: &Result<VariantRun, _>| run.as_ref().map_or(0, |run| run.steps as i64);
        let steps = Values::Counts(self.runs.iter().map(steps).collect());
        columns.push(Column { name: "steps".to_owned(), unit: None, values: steps });
        let errors = self.runs.iter().map(|run| run.as_ref().err().map(ToString::to_string));
        let errors = Values::Texts(errors.collect());
        columns.push(Column { name: "error".to_owned(), unit: None, values: errors });
        columns
    }

    /// Returns the heads of the columns of the CSV table, which numbers no variants.
    fn header(&self, simulator: &dyn Simulator<f64>, any_stopped: bool) -> Vec<String> {
        let columns = self.columns(simulator);
        let heads = columns.iter().skip(1).map(Column::head);
        heads.filter(|head| any_stopped || head != "error").collect()
    }
}

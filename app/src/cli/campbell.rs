//! `machinist campbell`: natural frequencies over a parameter, and their crossings with excitation
//! orders.

use std::f64::consts::{PI, TAU};
use std::path::{Path, PathBuf};

use clap::Args;
use machinist::Simulation;
use machinist::linear_analysis::{Campbell, Variation, campbell, campbell_over_speeds};

use super::amount::{Amount, is_alike};
use super::linear::Where;
use super::output::{
    columns, draw_file, is_standard_output, print, print_with, require_picture, write_file,
};
use super::range::{Range, ends, equally_spaced, range};
use crate::failure::Failure;
use crate::number::number;
use crate::parquet::{self, Column, Values};
use crate::plot::plot_campbell;
use crate::progress::during;
use serde_json::json;

/// Maximum number of values at which the machine may be linearized.
const MOST_VALUES: usize = 10_000;

#[derive(Debug, Args)]
pub struct CampbellDiagram {
    /// Parameter and its values, equally spaced, or logarithmically with `:log`
    #[arg(
        long,
        visible_alias = "over",
        value_name = "UNIT.PARAMETER=FROM..TO[:log]",
        value_parser = range,
        required_unless_present = "speeds"
    )]
    parameter: Option<Range>,
    /// Speeds for the orders, if the machine does not depend on the speed: in rad/s, or with a
    /// unit, `0..6000rpm`
    #[arg(
        long,
        value_name = "FROM..TO",
        value_parser = speeds,
        conflicts_with_all = ["parameter", "speed"]
    )]
    speeds: Option<[Amount; 2]>,
    /// Number of values, including both ends
    #[arg(long, value_name = "NUMBER", default_value_t = 101)]
    count: usize,
    /// Speed that the orders multiply: a parameter, a state or an output in rad/s. Default: the
    /// varied parameter, if it is in rad/s
    #[arg(long, value_name = "NAME")]
    speed: Option<String>,
    /// Orders of the speed that excite the machine
    #[arg(long, value_name = "ORDERS", value_delimiter = ',', default_value = "1")]
    orders: Vec<f64>,
    /// Write the frequencies to a .csv file; - writes only CSV to standard output
    #[arg(short, long, help_heading = "Output", value_name = "FILE")]
    out: Option<PathBuf>,
    /// Plot the frequencies and the orders to a .svg or .png file
    #[arg(long, help_heading = "Output", value_name = "FILE")]
    plot: Option<PathBuf>,
    /// Show speeds in rpm, except in JSON
    #[arg(long, help_heading = "Output")]
    rpm: bool,
    /// Show frequencies in Hz, except in JSON
    #[arg(long, help_heading = "Output")]
    hz: bool,
    /// Print JSON, in SI units
    #[arg(long, help_heading = "Output")]
    json: bool,
    #[command(flatten)]
    at: Where,
}

/// Parses `from..to`, as `--speeds` takes it.
fn speeds(text: &str) -> Result<[Amount; 2], String> {
    let ends = ends(text, "write it as FROM..TO, such as 0..6000 [rpm]")?;
    match &ends[1].unit {
        Some(unit) if !is_alike(unit, "rad/s") => {
            Err(format!("a speed is in rad/s, not in {unit}"))
        }
        _ => Ok(ends),
    }
}

/// Diagram in the units for display.
struct Shown {
    diagram: Campbell,
    /// Unit of frequencies.
    frequency: &'static str,
    /// Unit of speeds.
    speed: &'static str,
    /// Unit of speed in the unit of frequencies.
    per_speed: f64,
}

impl Shown {
    /// Converts the diagram to rpm and Hz if asked for.
    fn new(mut diagram: Campbell, rpm: bool, hz: bool) -> Self {
        let of_speed = if rpm { 30.0 / PI } else { 1.0 };
        let of_frequency = if hz { 1.0 / TAU } else { 1.0 };
        let scale = |values: &mut [f64], factor: f64| values.iter_mut().for_each(|x| *x *= factor);
        diagram.speeds.iter_mut().for_each(|speeds| scale(speeds, of_speed));
        if diagram.unit == "rad/s" && rpm {
            "rpm".clone_into(&mut diagram.unit);
            scale(&mut diagram.values, of_speed);
            diagram.critical.iter_mut().for_each(|meeting| meeting.value *= of_speed);
            for stretch in &mut diagram.growing {
                for value in [&mut stretch.from, &mut stretch.to, &mut stretch.at] {
                    *value *= of_speed;
                }
            }
        }
        diagram.branches.iter_mut().for_each(|one| scale(&mut one.frequencies, of_frequency));
        diagram.critical.iter_mut().for_each(|meeting| meeting.frequency *= of_frequency);
        Self {
            diagram,
            frequency: if hz { "Hz" } else { "rad/s" },
            speed: if rpm { "rpm" } else { "rad/s" },
            per_speed: of_frequency / of_speed,
        }
    }
}

impl CampbellDiagram {
    pub fn execute(&self) -> Result<(), Failure> {
        let to_standard_output = is_standard_output(self.out.as_deref())?;
        require_picture(self.plot.as_deref(), "--plot")?;
        let values = self.values()?;
        let scene = self.at.load()?;
        let diagram = self.diagram(&self.at.run(&scene)?, &values)?;
        let title = scene.simulator().title();
        let json = self.json.then(|| serde_json::to_string_pretty(&diagram)).transpose();
        let json = json.map_err(|error| Failure::unsuccessful(error, ""))?;
        let given = self.speeds.as_ref().and_then(|[_, to]| to.unit.as_deref());
        let shown = Shown::new(diagram, self.rpm || given == Some("rpm"), self.hz);
        if let Some(file) = &self.plot {
            let units = (shown.frequency, shown.per_speed);
            let draw =
                |path: &Path| plot_campbell(&shown.diagram, &self.orders, units, title, path);
            draw_file(file, draw)?;
        }
        match &self.out {
            Some(_) if to_standard_output => {
                return print_with(|out| parquet::write_csv(&as_columns(&shown), out));
            }
            Some(file) if parquet::is_named(file) => {
                let of = ("campbell", self.at.scene(), &scene);
                let more = json!({ "parameter": shown.diagram.parameter });
                parquet::write_table(file, &as_columns(&shown), of, more)?;
            }
            Some(file) => write_file(file, |out| parquet::write_csv(&as_columns(&shown), out))?,
            None => {}
        }
        if let Some(text) = json {
            return print(&format!("{text}\n"));
        }
        print(&self.summary(&format!("{}: {title}", scene.simulator().name()), &shown))
    }

    /// Computes the diagram over the parameter or over speeds.
    fn diagram(&self, run: &Simulation<'_>, values: &[f64]) -> Result<Campbell, Failure> {
        let (place, orders) = (self.at.place(), &self.orders);
        let Some(parameter) = &self.parameter else {
            let over = || campbell_over_speeds(run, place, values, orders);
            return Ok(during("linearizing", over)?);
        };
        parameter.check(run)?;
        let speed = self.speed.as_deref();
        let variation = Variation { parameter: &parameter.name, values, place, speed, orders };
        Ok(during("linearizing", || campbell(run, &variation))?)
    }

    fn values(&self) -> Result<Vec<f64>, Failure> {
        let (option, from, to) = match (&self.parameter, &self.speeds) {
            (Some(Range { from, to, .. }), _) => ("--parameter", *from, *to),
            (None, Some([from, to])) => ("--speeds", from.value, to.value),
            (None, None) => ("--parameter", f64::NAN, f64::NAN),
        };
        if from < 0.0 && option == "--speeds" {
            return Err(Failure::input("--speeds: speeds must not be negative", ""));
        }
        if !(2..=MOST_VALUES).contains(&self.count) {
            let message = format!("--count {}: a range has 2 to {MOST_VALUES} values", self.count);
            return Err(Failure::input(message, ""));
        }
        if from >= to || from.is_nan() {
            let message = format!("{option}: values must increase from the first to the last");
            return Err(Failure::input(message, "write the smaller value first"));
        }
        if let Some(order) = self.orders.iter().find(|order| !(order.is_finite() && **order > 0.0))
        {
            let message = format!("--orders {order}: an order must be above zero");
            return Err(Failure::input(message, "half an order is 0.5"));
        }
        let value = |index: usize| match &self.parameter {
            Some(parameter) => parameter.value(index, self.count),
            None => equally_spaced([from, to], index, self.count),
        };
        Ok((0..self.count).map(value).collect())
    }

    fn summary(&self, heading: &str, shown: &Shown) -> String {
        let Shown { diagram, frequency: hertz, .. } = shown;
        let Campbell { parameter, unit, values, branches, critical, speeds, .. } = diagram;
        let mut text = format!("{heading}\nfrequencies over {parameter} [{unit}]\n\n");
        if branches.is_empty() {
            text.push_str("Nothing oscillates.\n");
        }
        let ends = [values.first(), values.last()].map(|end| end.copied().unwrap_or(f64::NAN));
        let at = |end: f64| format!("at {} [{hertz}]", number(end, 6));
        let mut rows = vec![[String::new(), "moves".to_owned(), at(ends[0]), at(ends[1])]];
        let cell = |value: Option<&f64>| match value {
            Some(value) if value.is_finite() => number(*value, 6),
            _ => "-".to_owned(),
        };
        for (index, branch) in branches.iter().enumerate() {
            let [first, last] = [branch.frequencies.first(), branch.frequencies.last()].map(cell);
            rows.push([(index + 1).to_string(), branch.moves.clone(), first, last]);
        }
        if !branches.is_empty() {
            text.push_str(&columns(&rows, 2));
        }
        if speeds.is_none() {
            text.push_str(
                "\nNo orders: the parameter is not in rad/s; `--speed NAME` selects a speed.\n",
            );
        } else if critical.is_empty() {
            text.push_str("\nNo order crosses a natural frequency in this range.\n");
        } else {
            let heads = ["order", "motion", "damping ratio"].map(str::to_owned);
            let ([order, branch, ratio], frequency) = (heads, format!("at [{hertz}]"));
            let mut rows = vec![[order, branch, format!("{parameter} [{unit}]"), frequency, ratio]];
            for meeting in critical {
                let numbers = [meeting.value, meeting.frequency, meeting.damping_ratio];
                let [value, frequency, ratio] = numbers.map(|value| number(value, 6));
                let order = number(meeting.order, 6);
                rows.push([order, (meeting.branch + 1).to_string(), value, frequency, ratio]);
            }
            text.push('\n');
            text.push_str(&columns(&rows, 0));
        }
        text.push_str(&vanishing(diagram));
        text.push_str(&growing(diagram));
        for file in [&self.out, &self.plot].into_iter().flatten() {
            text.extend(["\nwrote ", &file.display().to_string()]);
        }
        text.trim_end().to_owned() + "\n"
    }
}

/// Returns lines on oscillations that exist only for some values, and where they begin and end.
fn vanishing(diagram: &Campbell) -> String {
    let Campbell { parameter, unit, values, branches, .. } = diagram;
    let between = |index: usize| {
        let [from, to] = [values[index], values[index + 1]].map(|value| number(value, 6));
        format!("between {parameter} = {from} and {to} {unit}")
    };
    let told = branches.iter().enumerate().filter_map(|(number, branch)| {
        let first = branch.frequencies.iter().position(|value| value.is_finite())?;
        let last = branch.frequencies.iter().rposition(|value| value.is_finite())?;
        let begins = (first > 0).then(|| format!("begins {}", between(first - 1)));
        let ends = (last + 1 < values.len()).then(|| format!("ends {}", between(last)));
        let parts: Vec<String> = [begins, ends].into_iter().flatten().collect();
        let number = number + 1;
        (!parts.is_empty()).then(|| format!("Motion {number} {}.\n", parts.join(" and ")))
    });
    let told: String = told.collect();
    if told.is_empty() { told } else { format!("\n{told}") }
}

/// Returns lines on the ranges with unstable motions.
fn growing(diagram: &Campbell) -> String {
    let Campbell { parameter, unit, growing, .. } = diagram;
    let told = growing.iter().map(|stretch| {
        let numbers = [stretch.from, stretch.to, stretch.at].map(|value| number(value, 6));
        let ([from, to, at], fastest) = (numbers, number(stretch.fastest, 3));
        let moves = stretch.moves.join(", ");
        format!(
            "\nUnstable from {parameter} = {from} to {to} {unit}: disturbances grow, fastest\nas \
             e^({fastest} 1/s t) at {at} {unit}; {moves} most.\n"
        )
    });
    told.collect()
}

/// Returns the parameter, the speed, then frequency and damping ratio of each oscillation, missing if
/// there is none.
fn as_columns(shown: &Shown) -> Vec<Column> {
    let Shown { diagram, frequency, speed, .. } = shown;
    let some = |values: &[f64]| {
        Values::Some(values.iter().copied().map(|x| x.is_finite().then_some(x)).collect())
    };
    let column = |name: String, unit: &str, values: &[f64]| Column {
        name,
        unit: Some(unit.to_owned()),
        values: some(values),
    };
    let mut columns = vec![column(diagram.parameter.clone(), &diagram.unit, &diagram.values)];
    let speeds = diagram.speeds.iter();
    if !diagram.is_over_speed {
        columns.extend(speeds.map(|speeds| column("speed".to_owned(), speed, speeds)));
    }
    for (index, branch) in diagram.branches.iter().enumerate() {
        let name = format!("{} {}", index + 1, branch.moves);
        columns.push(column(name.clone(), frequency, &branch.frequencies));
        columns.push(column(format!("{name} damping ratio"), "1", &branch.damping_ratios));
    }
    columns
}

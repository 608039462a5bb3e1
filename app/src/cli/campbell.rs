//! `machinist campbell`: natural frequencies over a parameter, and where orders meet them.

use std::io;
use std::path::PathBuf;

use clap::Args;
use machinist::linear_analysis::{Campbell, Variation, campbell};

use super::linear::Where;
use super::output::{
    columns, draw_file, is_standard_output, print, print_with, require_picture, write_file,
};
use super::range::{Range, range};
use crate::failure::Failure;
use crate::number::number;
use crate::parquet::{self, Column, Values};
use crate::plot::plot_campbell;
use crate::progress::during;
use serde_json::json;

/// Values at which the machine may be linearized.
const MOST_VALUES: usize = 10_000;

#[derive(Debug, Args)]
pub struct CampbellDiagram {
    #[command(flatten)]
    at: Where,
    /// The parameter and its values, equally spaced, or with `:log` at equal ratios
    #[arg(long, value_name = "UNIT.PARAMETER=FROM..TO[:log]", value_parser = range)]
    parameter: Range,
    /// Number of values, both ends included
    #[arg(long, value_name = "NUMBER", default_value_t = 101)]
    count: usize,
    /// The speed that orders are of: a parameter or a state in rad/s; the parameter that is
    /// varied, if that is in rad/s, unless given
    #[arg(long, value_name = "NAME")]
    speed: Option<String>,
    /// Orders of the speed that excite the machine
    #[arg(long, value_name = "ORDERS", value_delimiter = ',', default_value = "1")]
    orders: Vec<f64>,
    /// Write the frequencies to a file that ends in .csv; - for standard output and nothing
    /// else there
    #[arg(long, value_name = "FILE")]
    out: Option<PathBuf>,
    /// Plot the frequencies, with the orders, to a file that ends in .svg or .png
    #[arg(long, value_name = "FILE")]
    plot: Option<PathBuf>,
    /// As JSON
    #[arg(long)]
    json: bool,
}

impl CampbellDiagram {
    pub fn execute(&self) -> Result<(), Failure> {
        let to_standard_output = is_standard_output(self.out.as_deref())?;
        require_picture(self.plot.as_deref(), "--plot")?;
        let values = self.values()?;
        let scene = self.at.load()?;
        let run = self.at.run(&scene)?;
        self.parameter.check(&run)?;
        let variation = Variation {
            parameter: &self.parameter.name,
            values: &values,
            place: self.at.place(),
            speed: self.speed.as_deref(),
            orders: &self.orders,
        };
        let diagram = during("linearizing", || campbell(&run, &variation))?;
        let title = scene.simulator().title();
        if let Some(file) = &self.plot {
            draw_file(file, |path| plot_campbell(&diagram, &self.orders, title, path))?;
        }
        match &self.out {
            Some(_) if to_standard_output => return print_with(|out| table(&diagram, out)),
            Some(file) if parquet::is_named(file) => {
                let of = ("campbell", self.at.scene(), &scene);
                let more = json!({ "parameter": diagram.parameter });
                parquet::write_table(file, &as_columns(&diagram), of, more)?;
            }
            Some(file) => write_file(file, |out| table(&diagram, out))?,
            None => {}
        }
        if self.json {
            let text = serde_json::to_string_pretty(&diagram)
                .map_err(|error| Failure::unsuccessful(error, ""))?;
            return print(&format!("{text}\n"));
        }
        print(&self.summary(&format!("{}: {title}", scene.simulator().name()), &diagram))
    }

    fn values(&self) -> Result<Vec<f64>, Failure> {
        let Range { from, to, .. } = &self.parameter;
        if !(2..=MOST_VALUES).contains(&self.count) {
            let message = format!("--count {}: a range has 2 to {MOST_VALUES} values", self.count);
            return Err(Failure::input(message, ""));
        }
        if from >= to {
            let message =
                format!("--parameter: the values must grow, but {from} is not below {to}");
            return Err(Failure::input(message, ""));
        }
        if let Some(order) = self.orders.iter().find(|order| !(order.is_finite() && **order > 0.0))
        {
            let message = format!("--orders {order}: an order is a number above zero");
            return Err(Failure::input(message, "half an order is 0.5"));
        }
        Ok((0..self.count).map(|index| self.parameter.value(index, self.count)).collect())
    }

    fn summary(&self, heading: &str, diagram: &Campbell) -> String {
        let Campbell { parameter, unit, values, branches, critical, speeds, .. } = diagram;
        let mut text = format!("{heading}\nfrequencies over {parameter} [{unit}]\n\n");
        if branches.is_empty() {
            text.push_str("Nothing oscillates.\n");
        }
        let ends = [values.first(), values.last()].map(|end| end.copied().unwrap_or(f64::NAN));
        let at = |end: f64| format!("at {} [rad/s]", number(end, 6));
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
                "\nNo orders: the parameter is not in rad/s; `--speed NAME` says what they are of.\n",
            );
        } else if critical.is_empty() {
            text.push_str("\nNo order meets a frequency here.\n");
        } else {
            let heads = ["order", "motion", "at [rad/s]", "damping ratio"].map(str::to_owned);
            let [order, branch, frequency, ratio] = heads;
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

/// Oscillations that are not at all values, and where they begin and end.
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

/// Where motions grow by themselves.
fn growing(diagram: &Campbell) -> String {
    let Campbell { parameter, unit, growing, .. } = diagram;
    let told = growing.iter().map(|stretch| {
        let numbers = [stretch.from, stretch.to, stretch.at].map(|value| number(value, 6));
        let ([from, to, at], fastest) = (numbers, number(stretch.fastest, 3));
        let moves = stretch.moves.join(", ");
        format!(
            "\nUnstable from {parameter} = {from} to {to} {unit}: what is not disturbed grows by \
             itself, fastest\nas e^({fastest} 1/s t) at {at} {unit}; {moves} most.\n"
        )
    });
    told.collect()
}

/// As [`table`] has them.
fn as_columns(diagram: &Campbell) -> Vec<Column> {
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
    columns.extend(speeds.map(|speeds| column("speed".to_owned(), "rad/s", speeds)));
    for (index, branch) in diagram.branches.iter().enumerate() {
        let name = format!("{} {}", index + 1, branch.moves);
        columns.push(column(name.clone(), "rad/s", &branch.frequencies));
        columns.push(column(format!("{name} damping ratio"), "1", &branch.damping_ratios));
    }
    columns
}

/// The parameter, the speed, then frequency and damping ratio of each oscillation; empty where
/// it is none.
fn table(diagram: &Campbell, out: &mut dyn io::Write) -> io::Result<()> {
    let mut writer = csv::Writer::from_writer(out);
    let mut header = vec![format!("{} [{}]", diagram.parameter, diagram.unit)];
    header.extend(diagram.speeds.as_ref().map(|_| "speed [rad/s]".to_owned()));
    for (index, branch) in diagram.branches.iter().enumerate() {
        let name = format!("{} {}", index + 1, branch.moves);
        header.extend([format!("{name} [rad/s]"), format!("{name} damping ratio [1]")]);
    }
    writer.write_record(header)?;
    for (row, value) in diagram.values.iter().enumerate() {
        let cell = |value: f64| if value.is_finite() { value.to_string() } else { String::new() };
        let mut record = vec![cell(*value)];
        record.extend(diagram.speeds.as_ref().map(|speeds| cell(speeds[row])));
        for branch in &diagram.branches {
            record.extend([branch.frequencies[row], branch.damping_ratios[row]].map(cell));
        }
        writer.write_record(record)?;
    }
    writer.flush()
}

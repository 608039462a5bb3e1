//! `machinist spectrum --over SPEED --orders`: amplitudes over the orders of a shaft's speed.

use std::io;
use std::path::{Path, PathBuf};

use clap::Args;
use machinist::Simulation;
use machinist::trajectory::{Column, ColumnKind, Trajectory};
use serde_json::json;

use super::output::{
    columns, draw_file, print, print_with, remark_beside, remarks, require_ending, require_picture,
    write_file,
};
use super::scene::Scene;
use super::spectrum::write_columns;
use crate::failure::Failure;
use crate::number::number;
use crate::orders::{Blocks, Waterfall, integrated, is_angle, times_at};
use crate::plot::{Heat, plot_cuts, plot_heat};
use crate::progress::during;
use crate::spectrum::Window;

/// Samples of the first run, which shows how the shaft turns.
const FIRST_SAMPLES: usize = 20_000;
const MOST_SAMPLES: f64 = 1e7;
/// Share of the largest amplitude from which a line is visible in the waterfall.
const VISIBLE: f64 = 1e-2;
/// Orders shown if none are given.
const STRONGEST: usize = 3;

#[derive(Debug, Args)]
pub struct OrderArgs {
    /// Angle in rad or speed in rad/s of a shaft, an output or a state: the spectrum is over its
    /// orders
    #[arg(long, help_heading = "Orders", value_name = "NAME")]
    over: Option<String>,
    /// Orders to cut out. Default: the three strongest
    #[arg(
        long,
        help_heading = "Orders",
        value_name = "ORDERS",
        value_delimiter = ',',
        num_args = 0..=1,
        require_equals = true,
        requires = "over"
    )]
    orders: Option<Vec<f64>>,
    /// Turns of a block; orders are apart by one over this number
    #[arg(
        long,
        help_heading = "Orders",
        value_name = "NUMBER",
        default_value_t = 8,
        requires = "over",
        value_parser = clap::value_parser!(u32).range(1..=1000)
    )]
    turns: u32,
    /// Samples of a turn; the highest order is half of them
    #[arg(
        long,
        help_heading = "Orders",
        value_name = "NUMBER",
        default_value_t = 64,
        requires = "over",
        value_parser = clap::value_parser!(u32).range(4..=100_000)
    )]
    per_turn: u32,
    /// Plot the orders cut out over the speed to a .svg or .png file
    #[arg(long, help_heading = "Orders", value_name = "FILE", requires = "over")]
    plot_cuts: Option<PathBuf>,
    /// Print JSON, with all orders
    #[arg(long, help_heading = "Output", requires = "over")]
    json: bool,
}

/// Outputs, interval and files that the command shares with spectra over frequency.
pub struct Shared<'a> {
    pub outputs: &'a dyn Fn(&Trajectory) -> Result<Vec<Column>, Failure>,
    pub interval: (f64, f64),
    pub window: Window,
    pub out: Option<&'a Path>,
    pub plot: Option<&'a Path>,
}

/// Waterfalls of several outputs over the same blocks.
struct Orders {
    over: String,
    outputs: Vec<(Column, Waterfall)>,
    /// Lines that are cut out.
    lines: Vec<usize>,
    blocks: Blocks,
}

impl OrderArgs {
    /// Returns whether orders are asked for.
    pub fn are_asked_for(&self) -> bool {
        self.over.is_some()
    }

    fn blocks(&self, window: Window) -> Blocks {
        Blocks { turns: self.turns as usize, samples: self.per_turn as usize, window }
    }

    /// Returns the lines of the given orders.
    fn lines(&self) -> Result<Vec<usize>, Failure> {
        let line = |order: &f64| {
            let line = order * f64::from(self.turns);
            let highest = f64::from(self.per_turn) / 2.0;
            if !(*order > 0.0 && *order <= highest) {
                let message = format!("order {order} is not above 0 and at most {highest}");
                return Err(Failure::input(message, "--per-turn sets the highest order"));
            }
            if (line - line.round()).abs() > 1e-9 * line.max(1.0) {
                let message = format!("order {order} is between the lines, 1/{} apart", self.turns);
                return Err(Failure::input(message, "--turns sets the distance of the lines"));
            }
            Ok(line.round() as usize)
        };
        self.orders.iter().flatten().map(line).collect()
    }

    /// Runs the scene, and prints and writes its orders.
    pub fn execute(
        &self,
        scene: &Scene,
        prepared: &Simulation<'_>,
        shared: &Shared<'_>,
    ) -> Result<(), Failure> {
        let is_standard_output = shared.out == Some(Path::new("-"));
        if let Some(file) = shared.out.filter(|_| !is_standard_output) {
            require_ending(file, &["csv", "json"], "--out")?;
        }
        require_picture(self.plot_cuts.as_deref(), "--plot-cuts")?;
        let mut lines = self.lines()?;
        let Some(over) = &self.over else { return Ok(()) };
        let (from, until) = shared.interval;
        let time = |n: usize| from + (until - from) * n as f64 / FIRST_SAMPLES as f64;
        let times: Vec<f64> = (0..=FIRST_SAMPLES).map(time).collect();
        let first = prepared.clone().until(until).times(&times);
        let first = during("simulating", || first.run())?;
        let blocks = self.blocks(shared.window);
        let times = self.equal_angles(over, &first)?;
        let needed = blocks.turns * blocks.samples;
        if times.len() <= needed {
            let turned = times.len() as f64 / blocks.samples as f64;
            let message = format!("`{over}` makes {} turns, fewer than a block", number(turned, 4));
            return Err(Failure::input(message, "--turns shortens the blocks"));
        }
        let run = prepared.clone().until(until).times(&times);
        let run = during("simulating", || run.run())?;
        let outputs = (shared.outputs)(&run)?;
        let waterfalls = outputs.into_iter().map(|column| {
            let waterfall = blocks.waterfall(&run.times, &column.values);
            (column, waterfall)
        });
        let outputs: Vec<(Column, Waterfall)> = waterfalls.collect();
        if lines.is_empty()
            && let Some((_, waterfall)) = outputs.first()
        {
            lines = waterfall.strongest(STRONGEST);
            lines.sort_unstable();
        }
        let orders = Orders { over: over.clone(), outputs, lines, blocks };
        self.draw(&orders, &run, shared.plot)?;
        match shared.out {
            Some(_) if is_standard_output => {
                remark_beside(&run);
                return print_with(|out| orders.write_csv(out));
            }
            Some(file) if file.extension().is_some_and(|ending| ending == "json") => {
                let whole = orders.json(&run);
                write_file(file, |out| Ok(serde_json::to_writer_pretty(out, &whole)?))?;
            }
            Some(file) => write_file(file, |out| orders.write_csv(out))?,
            None => {}
        }
        if self.json {
            let text = serde_json::to_string_pretty(&orders.json(&run));
            let text = text.map_err(|error| Failure::unsuccessful(error, ""))?;
            return print(&(text + "\n"));
        }
        let files = [shared.out, shared.plot, self.plot_cuts.as_deref()];
        print(&orders.summary(scene, &run, &files))
    }

    /// Returns the times at which the shaft has turned by equal steps.
    fn equal_angles(&self, over: &str, run: &Trajectory) -> Result<Vec<f64>, Failure> {
        let known = || run.of_kind(ColumnKind::Output).chain(run.of_kind(ColumnKind::State));
        let column = known().find(|column| column.name == over).ok_or_else(|| {
            let names: Vec<&str> = known().map(|column| column.name.as_str()).collect();
            let over = over.escape_debug();
            let message = format!("scene `{}` has no output or state `{over}`", run.scene);
            Failure::unknown(message, &over.to_string(), names.into_iter())
        })?;
        let Some(is_angle) = is_angle(column) else {
            let message = format!("`{over}` is in {}, not in rad or rad/s", column.unit);
            return Err(Failure::input(message, "orders are over the angle or speed of a shaft"));
        };
        let step = std::f64::consts::TAU / f64::from(self.per_turn);
        let summed = (!is_angle).then(|| integrated(&run.times, &column.values));
        let angle = summed.as_ref().unwrap_or(&column.values);
        if let [first, .., last] = angle[..]
            && (last - first) / step > MOST_SAMPLES
        {
            let message = format!("{} samples are too many", ((last - first) / step).floor());
            return Err(Failure::input(message, "--per-turn sets the samples of a turn"));
        }
        let rate = summed.as_ref().map(|_| &column.values[..]);
        times_at(step, &run.times, angle, rate).map_err(|time| {
            let message = format!("`{over}` stops increasing at {} s", number(time, 6));
            Failure::unsuccessful(message, "orders need a shaft that turns forward; see --settle")
        })
    }

    fn draw(&self, orders: &Orders, run: &Trajectory, map: Option<&Path>) -> Result<(), Failure> {
        let (places, title) = orders.places();
        let subtitle = format!(
            "{}, orders of {}, blocks of {} turns, window {}",
            run.scene,
            orders.over,
            orders.blocks.turns,
            orders.blocks.window.name()
        );
        let texts = [run.title.as_str(), subtitle.as_str()];
        if let Some(file) = map {
            let maps: Vec<Heat<'_>> = orders
                .outputs
                .iter()
                .map(|(column, waterfall)| Heat {
                    name: format!("{} [{}]", column.name, column.unit),
                    places: (&places, title),
                    orders: &waterfall.orders,
                    amplitudes: &waterfall.amplitudes,
                })
                .collect();
            draw_file(file, |path| plot_heat(&maps, orders.highest(), texts, path))?;
        }
        if let Some(file) = &self.plot_cuts {
            let cuts = orders.cuts();
            draw_file(file, |path| plot_cuts((title, &places), &cuts, texts, path))?;
        }
        Ok(())
    }
}

impl Orders {
    /// Returns the speeds of the blocks if they increase or decrease throughout, else their times,
    /// with a title.
    fn places(&self) -> (Vec<f64>, &'static str) {
        let Some((_, first)) = self.outputs.first() else { return (Vec::new(), "") };
        let rises = |pair: &[f64]| pair[0] < pair[1];
        let falls = |pair: &[f64]| pair[0] > pair[1];
        if first.speeds.windows(2).all(rises) || first.speeds.windows(2).all(falls) {
            (first.speeds.clone(), "speed [rad/s]")
        } else {
            (first.times.clone(), "time [s]")
        }
    }

    /// Returns the highest order worth drawing: beyond the last visible line, and those cut out.
    fn highest(&self) -> f64 {
        let visible = self.outputs.iter().filter_map(|(_, waterfall)| {
            let greatest = waterfall.greatest();
            let largest = greatest.iter().skip(1).copied().fold(0.0, f64::max);
            greatest.iter().rposition(|amplitude| *amplitude > VISIBLE * largest)
        });
        let last = visible.chain(self.lines.iter().copied()).max().unwrap_or(0);
        1.0 + last as f64 / self.blocks.turns as f64
    }

    /// Returns a column for each output and order.
    fn cuts(&self) -> Vec<Column> {
        let cut = |(column, waterfall): &(Column, Waterfall), line: usize| Column {
            name: format!("{} order {}", column.name, waterfall.orders[line]),
            unit: column.unit.clone(),
            kind: ColumnKind::Output,
            doc: String::new(),
            values: waterfall.cut(line),
        };
        let outputs = self.outputs.iter();
        outputs.flat_map(|one| self.lines.iter().map(move |line| cut(one, *line))).collect()
    }

    fn write_csv(&self, out: impl io::Write) -> io::Result<()> {
        let cuts = self.cuts();
        let cuts = cuts.iter().map(|cut| (format!("{} [{}]", cut.name, cut.unit), &*cut.values));
        let first = self.outputs.first().map(|(_, waterfall)| waterfall);
        let times = first.map_or(&[][..], |one| &one.times);
        let speeds = first.map_or(&[][..], |one| &one.speeds);
        let first = [("time [s]".to_owned(), times), ("speed [rad/s]".to_owned(), speeds)];
        write_columns(&first.into_iter().chain(cuts).collect::<Vec<_>>(), out)
    }

    fn json(&self, run: &Trajectory) -> serde_json::Value {
        let first = self.outputs.first().map(|(_, waterfall)| waterfall);
        let outputs: Vec<_> = self
            .outputs
            .iter()
            .map(|(column, waterfall)| {
                json!({
                    "name": column.name,
                    "unit": column.unit,
                    "amplitudes": waterfall.amplitudes,
                })
            })
            .collect();
        json!({
            "scene": run.scene,
            "over": self.over,
            "window": self.blocks.window.name(),
            "turns": self.blocks.turns,
            "per_turn": self.blocks.samples,
            "times": first.map(|one| &one.times),
            "speeds": first.map(|one| &one.speeds),
            "orders": first.map(|one| &one.orders),
            "outputs": outputs,
            "notes": run.notes,
        })
    }

    fn summary(&self, scene: &Scene, run: &Trajectory, files: &[Option<&Path>]) -> String {
        let Some((_, first)) = self.outputs.first() else { return String::new() };
        let Blocks { turns, samples, window } = self.blocks;
        let ends = |values: &[f64]| match (values.first(), values.last()) {
            (Some(first), Some(last)) => format!("{} to {}", number(*first, 6), number(*last, 6)),
            _ => String::new(),
        };
        let mut text = format!(
            "{}: {} ({})\norders of {}: {} blocks of {turns} turns with {samples} samples each, \
             window {}, {} rad/s{}\n\n",
            run.scene,
            run.title,
            scene.how(),
            self.over,
            first.times.len(),
            window.name(),
            ends(&first.speeds),
            remarks(run, "--json"),
        );
        let mut rows =
            vec![["", "unit", "order", "largest amplitude", "speed [rad/s]"].map(str::to_owned)];
        for (column, waterfall) in &self.outputs {
            for (index, line) in self.lines.iter().enumerate() {
                let cut = waterfall.cut(*line);
                let largest = (0..cut.len()).max_by(|a, b| cut[*a].total_cmp(&cut[*b]));
                let Some(row) = largest else { continue };
                let named = |text: &str| if index == 0 { text.to_owned() } else { String::new() };
                rows.push([
                    named(&column.name),
                    named(&column.unit),
                    number(waterfall.orders[*line], 6),
                    number(cut[row], 6),
                    number(waterfall.speeds[row], 6),
                ]);
            }
        }
        text.push_str(&columns(&rows, 2));
        for file in files.iter().flatten() {
            text.extend(["\nwrote ", &file.display().to_string()]);
        }
        text.trim_end().to_owned() + "\n"
    }
}

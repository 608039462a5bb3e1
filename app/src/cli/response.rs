//! `machinist response`: the frequency response of an output.

use std::f64::consts::TAU;
use std::path::PathBuf;

use crate::plot::plot_response;
use clap::Args;
use machinist::linear_analysis::{Largest, Linearization, Response, logarithmic_range};

use super::amount::{Amount, is_alike, is_in_cycles};
use super::linear::Where;
use super::output::{
    columns, draw_file, is_standard_output, print, print_with, require_picture, write_file,
};
use super::range::ends;
use super::scene::Scene;
use crate::failure::Failure;
use crate::number::number;
use crate::parquet::{self, Column};
use serde_json::json;

#[derive(Debug, Args)]
pub struct FrequencyResponse {
    /// Excitation: a parameter or an input of a unit that varies harmonically, or a coordinate on
    /// which a harmonic force acts
    #[arg(long, value_name = "PARAMETER")]
    input: String,
    /// Responding output or state
    #[arg(long, value_name = "OUTPUT", alias = "to")]
    output: String,
    /// Angular frequencies, in rad/s or with a unit, `1..100 Hz`. Default: from a tenth of the
    /// slowest to ten times the fastest motion
    #[arg(long, value_name = "LOWEST..HIGHEST", value_parser = range)]
    range: Option<(f64, f64)>,
    /// Number of frequencies, including both ends
    #[arg(long, value_name = "NUMBER", default_value_t = 401)]
    points: usize,
    /// Write frequency, amplitude and phase to a .csv file; - writes only CSV to standard output
    #[arg(short, long, help_heading = "Output", value_name = "FILE")]
    out: Option<PathBuf>,
    /// Plot amplitude and phase to a .svg or .png file
    #[arg(long, help_heading = "Output", value_name = "FILE")]
    plot: Option<PathBuf>,
    #[command(flatten)]
    at: Where,
}

impl FrequencyResponse {
    pub fn execute(&self) -> Result<(), Failure> {
        let to_standard_output = is_standard_output(self.out.as_deref())?;
        require_picture(self.plot.as_deref(), "--plot")?;
        self.at.analyse(
            &[&self.input],
            |scene, linearization, inputs| {
                self.answer(scene, linearization, &inputs[0], to_standard_output)
            },
            |linearization, inputs| linearization.response(&inputs[0], &self.output, &[]).map(drop),
        )
    }

    /// Computes the response and prints or writes it.
    fn answer(
        &self,
        scene: &Scene,
        linearization: &Linearization<'_>,
        input: &str,
        to_standard_output: bool,
    ) -> Result<(), Failure> {
        let range = match self.range {
            Some((lowest, highest)) => lowest..highest,
            None => linearization.range_of_interest()?,
        };
        let frequencies = logarithmic_range(range.start, range.end, self.points)?;
        let response = linearization.response(input, &self.output, &frequencies)?;
        let remark = linearization.growth().ok().flatten().map(|growth| {
            let growth = number(growth, 3);
            format!(
                "the operating point is unstable: disturbances grow as e^({growth} 1/s t), so no \
                 motion settles to these amplitudes"
            )
        });

        let title = scene.simulator().title();
        let largest = linearization.largest(input, &self.output, &response)?;
        if let Some(file) = &self.plot {
            let mut drawn = response.clone();
            if let Some(largest) = &largest {
                drawn.add(largest);
            }
            draw_file(file, |path| plot_response(&drawn, title, path))?;
        }
        match &self.out {
            Some(_) if to_standard_output => {
                remark.inspect(|remark| eprintln!("machinist: {remark}"));
                return print_with(|out| response.write_csv(out));
            }
            Some(file) if parquet::is_named(file) => {
                let Response { frequencies, amplitudes, phases, from, to, .. } = &response;
                let columns = [
                    Column::numbers("frequency", "rad/s", frequencies.clone()),
                    Column::numbers("amplitude", &response.amplitude_unit(), amplitudes.clone()),
                    Column::numbers("phase", "rad", phases.clone()),
                ];
                let of = ("response", self.at.scene(), scene);
                parquet::write_table(file, &columns, of, json!({ "from": from, "to": to }))?;
            }
            Some(file) => write_file(file, |out| response.write_csv(out))?,
            None => {}
        }
        let place = self.at.described(linearization);
        let mut heading = format!("{}: {title}\n{place}", scene.simulator().name());
        if let Some(remark) = remark {
            heading.extend(["\n", &remark]);
        }
        print(&self.summary(&heading, &response, largest))
    }

    fn summary(&self, heading: &str, response: &Response, largest: Option<Largest>) -> String {
        let Response { from, to, .. } = response;
        let mut text = format!("{heading}\n{to} answers {from}\n\n");
        if response.amplitudes.iter().all(|amplitude| *amplitude == 0.0) {
            text.extend(["No response: at this point ", to, " does not change with ", from, ".\n"]);
        } else {
            text.push_str(&columns(&rows(response, largest), 1));
        }
        for file in [&self.out, &self.plot].into_iter().flatten() {
            text.extend(["\nwrote ", &file.display().to_string()]);
        }
        text.trim_end().to_owned() + "\n"
    }
}

/// Returns the ends of the range, and between them the largest response.
fn rows(response: &Response, largest: Option<Largest>) -> Vec<[String; 4]> {
    let amplitude_heading = format!("amplitude [{}]", response.amplitude_unit());
    let heading = ["", "frequency [rad/s]", &amplitude_heading, "phase [deg]"];
    let end = |index: usize| {
        [response.frequencies[index], response.amplitudes[index], response.phases[index]]
    };
    let top = largest.map(|top| ("largest amplitude", [top.frequency, top.amplitude, top.phase]));
    let points = [Some(("lowest", end(0))), top, Some(("highest", end(response.phases.len() - 1)))];
    let row = |(what, [frequency, amplitude, phase]): (&str, [f64; 3])| {
        let shown = |value: f64| number(value, 6);
        let (amplitude, phase) = if amplitude.is_finite() {
            (shown(amplitude), shown(phase.to_degrees()))
        } else {
            ("without bound".to_owned(), String::new())
        };
        [what.to_owned(), shown(frequency), amplitude, phase]
    };
    let rows = points.into_iter().flatten().map(row);
    std::iter::once(heading.map(str::to_owned)).chain(rows).collect()
}

/// Parses `10..1000`, `10:1000` or `1..100 Hz`. The result is in rad/s.
fn range(text: &str) -> Result<(f64, f64), String> {
    const EXAMPLE: &str =
        "write it as LOWEST..HIGHEST, in rad/s or with a unit, such as 10..1000 or \"1..100 Hz\"";
    let bounds = text.replacen(':', "..", usize::from(!text.contains("..")));
    let bounds = ends(&bounds, EXAMPLE).map_err(|why| match why.as_str() {
        EXAMPLE => why,
        _ => format!("{why}; {EXAMPLE}"),
    })?;
    let in_radians = |bound: Amount| match bound.unit.as_deref() {
        Some(unit) if !is_alike(unit, "rad/s") => Err(format!("{unit} is no unit of frequency")),
        Some(unit) if is_in_cycles(unit) => Ok(TAU * bound.value),
        _ => Ok(bound.value),
    };
    let [lowest, highest] = bounds.map(in_radians);
    Ok((lowest?, highest?))
}

#[cfg(test)]
mod tests {
    use super::{TAU, range};

    #[test]
    fn a_range_is_two_frequencies() {
        assert_eq!(range("10:1e3"), Ok((10.0, 1000.0)));
        assert_eq!(range("10..1e3"), Ok((10.0, 1000.0)));
        for bad in ["", "10", "10:", "a:b", "10-20"] {
            assert!(range(bad).unwrap_err().contains("LOWEST..HIGHEST"), "{bad}");
        }
    }

    #[cfg(feature = "derive")]
    #[test]
    fn a_range_in_hertz_counts_cycles() {
        assert_eq!(range("1..100 Hz"), Ok((TAU, 100.0 * TAU)));
        assert_eq!(range("1..2 rad/s"), Ok((1.0, 2.0)));
        assert_eq!(range("60rpm..1kHz").map(|(_, to)| to), Ok(1000.0 * TAU));
        assert!(range("1..2 m").unwrap_err().contains("no unit of frequency"));
    }
}

//! `machinist linearize`: the state-space model of a scene, with regulators and Kalman filters.

mod along;
mod answer;
mod table;

use std::path::{Path, PathBuf};

use clap::{Args, ValueEnum};
use machinist::linear_analysis::{
    Estimator, Hold, Place, Regulator, Signal, StateSpace, Weight, models_along,
};

use super::amount::{Amount, assignment, in_unit, time};
use super::linear::Where;
use super::output::{print, require_ending, write_file};
use super::scene::Scene;
use crate::failure::Failure;
use crate::matrices::{Entry, mat_file};
use crate::progress::during;
use along::Along;
use answer::Answer;

#[derive(Debug, Args)]
pub struct Linearize {
    /// Inputs, as NAME,NAME: parameters, or coordinates for a force on each
    #[arg(long, value_name = "NAMES", value_delimiter = ',', required = true)]
    inputs: Vec<String>,
    /// Outputs, as NAME,NAME: outputs or states
    #[arg(long, value_name = "NAMES", value_delimiter = ',', required = true)]
    outputs: Vec<String>,
    /// Convert to samples with this period, `1ms`
    #[arg(long, value_name = "TIME", value_parser = time, allow_hyphen_values = true)]
    sample: Option<f64>,
    /// Conversion to samples: zoh (inputs constant between samples, exact) or tustin (bilinear)
    #[arg(long, value_name = "NAME", requires = "sample", default_value = "zoh")]
    hold: HoldName,
    /// Design a linear-quadratic regulator: the deviation of each output and input that costs 1
    #[arg(long, value_name = "NAME=DEVIATION", value_parser = assignment, value_delimiter = ',')]
    lqr: Vec<(String, Amount)>,
    /// Design a steady Kalman filter: the standard deviation of noise on each measured output and
    /// on inputs; per root of hertz if not sampled
    #[arg(long, value_name = "NAME=DEVIATION", value_parser = assignment, value_delimiter = ',')]
    kalman: Vec<(String, Amount)>,
    /// Models along the run: at times with this step, `10ms`, or at several times, `0.1,0.2,0.5`
    #[arg(
        long,
        value_name = "STEP|TIMES",
        value_parser = time,
        value_delimiter = ',',
        conflicts_with_all = ["at", "lqr", "kalman"]
    )]
    along: Vec<f64>,
    /// Print JSON
    #[arg(long, help_heading = "Output")]
    json: bool,
    /// Write the matrices to a .mat file (MATLAB), .npz file (NumPy) or .json file
    #[arg(short, long, help_heading = "Output", value_name = "FILE")]
    out: Option<PathBuf>,
    #[command(flatten)]
    at: Where,
}

/// Name of a conversion to samples.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum HoldName {
    Zoh,
    Tustin,
}

impl From<HoldName> for Hold {
    fn from(name: HoldName) -> Self {
        match name {
            HoldName::Zoh => Self::Zoh,
            HoldName::Tustin => Self::Tustin,
        }
    }
}

/// Designs that were asked for.
struct Designs {
    regulator: Option<Regulator>,
    estimator: Option<Estimator>,
}

impl Linearize {
    pub fn execute(&self) -> Result<(), Failure> {
        if let Some(file) = &self.out {
            require_format(file)?;
        }
        let inputs: Vec<&str> = self.inputs.iter().map(String::as_str).collect();
        if !self.along.is_empty() {
            let text = self.at.analyse_at(
                Place::Initial,
                &inputs,
                |scene, _, inputs| self.told_along(scene, inputs),
                |linearization, inputs| linearization.state_space(inputs, &self.outputs).map(drop),
            )?;
            return print(&text);
        }
        let text = self.at.analyse(
            &inputs,
            |scene, linearization, inputs| {
                let model = linearization.state_space(inputs, &self.outputs)?;
                self.describe(scene, model, self.at.described(linearization))
            },
            |linearization, inputs| linearization.state_space(inputs, &self.outputs).map(drop),
        )?;
        print(&text)
    }

    /// Returns the models along the run, after writing the file.
    fn told_along(&self, scene: &Scene, inputs: &[String]) -> Result<String, Failure> {
        let run = self.at.run(scene)?;
        let simulator = scene.simulator();
        let span = [run.start_time(), run.end_time()];
        let times = times_along(&self.along, span)?;
        let mut pieces =
            during("linearizing", || models_along(&run, &times, inputs, &self.outputs))?;
        if let Some(period) = self.sample {
            for model in pieces.iter_mut().flat_map(|piece| &mut piece.models) {
                *model = model.clone().sampled(period, self.hold.into())?;
            }
        }
        let (scene, title) = (simulator.name(), simulator.title());
        let along = Along { scene, title, pieces: &pieces };
        if let Some(file) = &self.out {
            write_entries(file, || along.entries(), || along.json())?;
        }
        if self.json {
            return Ok(along.json()? + "\n");
        }
        let mut text = along.describe();
        if let Some(file) = &self.out {
            text.extend(["\nwrote ", &file.display().to_string(), "\n"]);
        }
        Ok(text)
    }

    /// Completes the model and returns the answer, after writing the file.
    fn describe(&self, scene: &Scene, model: StateSpace, place: String) -> Result<String, Failure> {
        let model = match self.sample {
            Some(period) => model.sampled(period, self.hold.into())?,
            None => model,
        };
        let designs = Designs {
            regulator: (!self.lqr.is_empty())
                .then(|| model.lqr(&weights(&model, &self.lqr)?).map_err(Failure::from))
                .transpose()?,
            estimator: (!self.kalman.is_empty())
                .then(|| model.kalman(&weights(&model, &self.kalman)?).map_err(Failure::from))
                .transpose()?,
        };
        let answer = Answer::new(scene.simulator(), place, &model, &designs)?;
        if let Some(file) = &self.out {
            write_answer(file, &answer)?;
        }
        if self.json {
            return Ok(answer.json()? + "\n");
        }
        let mut text = table::describe(&answer, &designs);
        if let Some(file) = &self.out {
            text.extend(["\nwrote ", &file.display().to_string(), "\n"]);
        }
        Ok(text)
    }
}

/// Writes the answer in the format of the ending.
fn write_answer(file: &Path, answer: &Answer<'_>) -> Result<(), Failure> {
    write_entries(file, || answer.entries(), || answer.json())
}

/// Writes matrices, or JSON, in the format of the ending.
fn write_entries<N: AsRef<str>>(
    file: &Path,
    entries: impl FnOnce() -> Vec<(N, Entry)>,
    json: impl FnOnce() -> Result<String, Failure>,
) -> Result<(), Failure> {
    let failed = |error: std::io::Error| Failure::file(file, &error);
    let bytes = match ending(file).as_str() {
        "mat" => mat_file(&entries()).map_err(failed)?,
        #[cfg(feature = "derive")]
        "npz" => crate::matrices::npz_file(&entries()).map_err(failed)?,
        _ => (json()? + "\n").into_bytes(),
    };
    write_file(file, |out| out.write_all(&bytes))
}

/// Maximum number of models along a run.
const MOST_MODELS: usize = 100_000;

/// Returns the times of a step over a run, or several times within it.
fn times_along(given: &[f64], [from, until]: [f64; 2]) -> Result<Vec<f64>, Failure> {
    let [step] = given else {
        let mut pairs = given.iter().zip(given.iter().skip(1));
        if let Some((before, after)) = pairs.find(|(before, after)| before >= after) {
            let message = format!("--along: {after} s does not follow {before} s");
            return Err(Failure::input(message, "give the times in order"));
        }
        if let Some(time) = given.iter().find(|time| !(from <= **time && **time <= until)) {
            let message = format!("--along: the run from {from} s to {until} s has no {time} s");
            return Err(Failure::input(message, "`--until` changes the end of the run"));
        }
        return Ok(given.to_vec());
    };
    let count = ((until - from) / step + 1e-9).floor();
    if !(*step > 0.0 && count >= 1.0 && count < MOST_MODELS as f64) {
        let message = format!(
            "--along {step}: a step is above 0, within the run of {} s, and gives at \
                               most {MOST_MODELS} models",
            until - from
        );
        return Err(Failure::input(message, ""));
    }
    Ok((0..=count as usize).map(|index| (from + index as f64 * step).min(until)).collect())
}

/// Refuses files of other formats before anything is computed.
fn require_format(file: &Path) -> Result<(), Failure> {
    let formats: &[&str] =
        if cfg!(feature = "derive") { &["mat", "npz", "json"] } else { &["mat", "json"] };
    require_ending(file, formats, "--out")
}

fn ending(file: &Path) -> String {
    let ending = file.extension().and_then(|ending| ending.to_str()).unwrap_or_default();
    ending.to_ascii_lowercase()
}

/// Returns deviations in the units of the model's signals. Deviations of outputs in other units
/// than SI are converted.
fn weights(model: &StateSpace, given: &[(String, Amount)]) -> Result<Vec<Weight>, Failure> {
    let named = |signals: &[Signal], name: &str| {
        signals
            .iter()
            .find(|signal| {
                signal.name == name || signal.name.strip_prefix("force on ") == Some(name)
            })
            .cloned()
    };
    let weight = |(name, amount): &(String, Amount)| {
        let signal = named(&model.inputs, name).or_else(|| named(&model.outputs, name));
        // Unknown names are refused by the design.
        let Some(signal) = signal else {
            return Ok(Weight { name: name.clone(), deviation: amount.value });
        };
        amount.check(name, &signal.unit)?;
        // Amounts with a unit are in SI units; outputs may be in others.
        let deviation = match amount.unit {
            Some(_) => in_unit(amount.value, &signal.unit),
            None => amount.value,
        };
        Ok(Weight { name: signal.name, deviation })
    };
    given.iter().map(weight).collect()
}

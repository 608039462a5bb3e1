//! `machinist sensitivity`: the relative effect of parameters on outputs.

use std::path::PathBuf;

use clap::Args;
use machinist::error::StopCause;
use machinist::simulate::Differentiated;
use machinist::trajectory::{Column, ColumnKind, Trajectory, sensitivity_name};
use machinist::{Method, SimulateError, Simulation};
use machinist_contract::Simulator;
use serde::Serialize;

use super::arguments::{RunArgs, SceneArgs};
use super::output::{
    columns, draw_file, print, remarks, require_picture, require_table, write_file,
};
use super::scene::Scene;
use crate::failure::Failure;
use crate::interrupt;
use crate::number::number;
use crate::parquet;
use crate::progress::during;
use serde_json::json;

/// Maximum number of curves in a plot.
const DRAWN: usize = 6;

#[derive(Debug, Args)]
pub struct Sensitivity {
    /// Parameters, or states for their initial values. Default: all parameters
    #[arg(long, value_name = "NAMES", value_delimiter = ',')]
    parameters: Vec<String>,
    /// Outputs or states. Default: all outputs
    #[arg(long, value_name = "NAMES", value_delimiter = ',')]
    outputs: Vec<String>,
    /// Number of times in the averages, including both ends
    #[arg(long, value_name = "NUMBER")]
    points: Option<usize>,
    /// Maximum number of rows of the table; 0 shows all
    #[arg(long, help_heading = "Output", value_name = "NUMBER", default_value_t = 20)]
    top: usize,
    /// Print all sensitivities as JSON
    #[arg(long, help_heading = "Output")]
    json: bool,
    /// Write relative sensitivities over time to a .csv file
    #[arg(short, long, help_heading = "Output", value_name = "FILE")]
    out: Option<PathBuf>,
    /// Plot the largest relative sensitivities over time to a .svg or .png file
    #[arg(long, help_heading = "Output", value_name = "FILE")]
    plot: Option<PathBuf>,
    #[command(flatten)]
    scene: SceneArgs,
    #[command(flatten)]
    run: RunArgs,
}

/// Relative difference below which sizes count as equal.
const TIE: f64 = 1e-9;

/// Relative effect of a parameter on an output: (p/scale) d(output)/dp. The scale is the largest
/// size of the output over the run.
#[derive(Debug, Clone, Serialize)]
struct Effect {
    parameter: String,
    output: String,
    /// Root mean square over the run.
    rms: f64,
    /// Value of the largest size, with its sign.
    largest: f64,
    /// Time of the largest value \[s\].
    at: f64,
    /// Value at the end of the run.
    end: f64,
    #[serde(skip)]
    values: Vec<f64>,
}

#[derive(Serialize)]
struct Answer<'a> {
    scene: &'a str,
    method: Method,
    rtol: f64,
    from: f64,
    until: f64,
    effects: &'a [Effect],
    left_out: &'a [String],
    /// Notes of the run.
    notes: &'a [String],
}

impl Sensitivity {
    pub fn execute(&self) -> Result<(), Failure> {
        require_picture(self.plot.as_deref(), "--plot")?;
        if let Some(file) = &self.out {
            require_table(file, &["csv"])?;
        }
        let scene = self.scene.load()?;
        let simulator = scene.simulator();
        let outputs = self.wanted(simulator)?;
        let simulation = self.simulation(simulator)?;
        let (by, mut left_out) = self.directions(simulator, &simulation);
        let nothing = |left_out: &[String]| {
            Failure::input("there are no parameters to differentiate by", left_out.join("; "))
        };
        if by.is_empty() {
            return Err(nothing(&left_out));
        }
        let flag = interrupt::flag();
        let simulation = simulation.until_flagged(&flag);
        let found = during("simulating", || simulation.differentiate(by));
        let Differentiated { run: trajectory, by, left_out: without } =
            found.map_err(|error| self.stopped(error))?;
        left_out.extend(without.into_iter().map(|(name, why)| format!("{name} {why}")));
        if by.is_empty() {
            return Err(nothing(&left_out));
        }
        // An output that is zero or nearly so throughout has no relative change.
        let effects = effects(&simulation, &trajectory, &by, &outputs);
        let (mut effects, endless): (Vec<_>, Vec<_>) =
            effects.into_iter().partition(|effect| effect.rms.is_finite());
        left_out.extend(endless.iter().map(|Effect { parameter, output, .. }| {
            format!("the effect of {parameter} on {output}, which is nearly zero")
        }));
        effects.sort_by(|a, b| b.rms.total_cmp(&a.rms));
        let relative = relative(&trajectory, &effects);
        match &self.out {
            Some(file) if parquet::is_named(file) => {
                let of = ("sensitivity", self.scene.scene.as_str(), &scene);
                parquet::write_table(file, &parquet::of_run(&relative), of, json!({}))?;
            }
            Some(file) => write_file(file, |out| relative.write_csv(out))?,
            None => {}
        }
        if let Some(file) = &self.plot {
            let largest = effects.iter().take(DRAWN).filter(|effect| effect.rms > 0.0);
            let names: Vec<String> = largest.map(Effect::name).collect();
            let names: Vec<&str> = names.iter().map(String::as_str).collect();
            if names.is_empty() {
                return Err(Failure::unsuccessful("no parameter affects any output: no plot", ""));
            }
            draw_file(file, |path| crate::plot::plot(&relative, &names, path))?;
        }
        if self.json {
            let answer = Answer {
                scene: simulator.name(),
                method: trajectory.method,
                rtol: trajectory.rtol,
                from: trajectory.times.first().copied().unwrap_or(f64::NAN),
                until: trajectory.times.last().copied().unwrap_or(f64::NAN),
                effects: &effects,
                left_out: &left_out,
                notes: &trajectory.notes,
            };
            let text = serde_json::to_string_pretty(&answer)
                .map_err(|error| Failure::unsuccessful(error, ""))?;
            return print(&format!("{text}\n"));
        }
        print(&self.summary(&scene, &trajectory, &effects, &left_out))
    }

    fn stopped(&self, error: SimulateError) -> Failure {
        if let SimulateError::Stopped { cause: StopCause::CoincidentEvents { .. }, .. } = &error {
            let help = format!("`--parameters` selects parameters of {}", self.scene.scene);
            return Failure::unsuccessful(error, help);
        }
        error.into()
    }

    fn simulation<'a>(&self, simulator: &'a dyn Simulator<f64>) -> Result<Simulation<'a>, Failure> {
        let simulation = self.run.apply(self.scene.simulation(simulator)?)?;
        Ok(self.points.into_iter().fold(simulation, Simulation::points))
    }

    /// Returns the outputs asked for: all of them by default, or all states of a scene without
    /// outputs.
    fn wanted(&self, simulator: &dyn Simulator<f64>) -> Result<Vec<String>, Failure> {
        let shape = simulator.shape();
        let outputs: Vec<&str> =
            (0..shape.outputs).map(|index| simulator.output(index).name).collect();
        let states = (0..shape.states()).map(|index| simulator.state(index).name);
        let known: Vec<&str> = outputs.iter().copied().chain(states).collect();
        if self.outputs.is_empty() {
            let all = if outputs.is_empty() { known } else { outputs };
            return Ok(all.into_iter().map(str::to_owned).collect());
        }
        match self.outputs.iter().find(|name| !known.contains(&name.as_str())) {
            None => Ok(self.outputs.clone()),
            Some(name) => Err(Failure::unknown(
                format!(
                    "scene `{}` has no output or state `{}`",
                    simulator.name(),
                    name.escape_debug()
                ),
                name,
                known.into_iter(),
            )),
        }
    }

    /// Returns the parameters to differentiate by, and those left out with the reasons.
    fn directions(
        &self,
        simulator: &dyn Simulator<f64>,
        simulation: &Simulation<'_>,
    ) -> (Vec<String>, Vec<String>) {
        if !self.parameters.is_empty() {
            let mut names = Vec::new();
            for name in &self.parameters {
                if !names.contains(name) {
                    names.push(name.clone());
                }
            }
            return (names, Vec::new());
        }
        let all = simulation.parameter_values().iter().enumerate();
        let named = all.map(|(index, value)| (simulator.parameter(index).name.to_owned(), *value));
        let (zero, others): (Vec<_>, Vec<_>) = named.partition(|(_, value)| *value == 0.0);
        let left_out = zero
            .into_iter()
            .map(|(name, _)| format!("{name} is 0, so that no change of it is relative"));
        (others.into_iter().map(|(name, _)| name).collect(), left_out.collect())
    }

    fn summary(
        &self,
        scene: &Scene,
        trajectory: &Trajectory,
        effects: &[Effect],
        left_out: &[String],
    ) -> String {
        let mut text = format!(
            "{}: {} ({})\n{}, rtol {:e}, {} s to {} s{}\n{} steps, {} rate evaluations, \
             {} Jacobians\n\nChange of an output, over its largest size, for a relative change of a \
             parameter:\n\n",
            trajectory.scene,
            trajectory.title,
            scene.how(),
            trajectory.method,
            trajectory.rtol,
            trajectory.times.first().copied().unwrap_or(f64::NAN),
            trajectory.times.last().copied().unwrap_or(f64::NAN),
            remarks(trajectory, "--json"),
            trajectory.work.steps,
            trajectory.work.rate_evaluations,
            trajectory.work.jacobian_evaluations,
        );
        let header = ["parameter", "output", "rms", "largest", "at [s]", "end"].map(str::to_owned);
        let shown = if self.top == 0 { effects.len() } else { self.top };
        let rows = effects.iter().take(shown).map(|effect| {
            let [rms, largest, at, end] =
                [effect.rms, effect.largest, effect.at, effect.end].map(|value| number(value, 4));
            [effect.parameter.clone(), effect.output.clone(), rms, largest, at, end]
        });
        text.push_str(&columns(&std::iter::once(header).chain(rows).collect::<Vec<_>>(), 2));
        if effects.len() > shown {
            text.extend([format!(
                "and {} more, the next of {} rms; --top 0 shows all\n",
                effects.len() - shown,
                number(effects[shown].rms, 4)
            )]);
        }
        if !left_out.is_empty() {
            text.extend(["\nleft out: ", &left_out.join("; "), "\n"]);
        }
        for file in [&self.out, &self.plot].into_iter().flatten() {
            text.extend(["\nwrote ", &file.display().to_string()]);
        }
        text.trim_end().to_owned() + "\n"
    }
}

fn effects(
    simulation: &Simulation<'_>,
    trajectory: &Trajectory,
    by: &[String],
    outputs: &[String],
) -> Vec<Effect> {
    let simulator = simulation.simulator();
    let value_of = |name: &str| {
        let place = (0..simulator.shape().parameters)
            .find(|index| simulator.parameter(*index).name == name);
        let of_start = || trajectory.column(name).and_then(|values| values.first().copied());
        place.map(|index| simulation.parameter_values()[index]).or_else(of_start)
    };
    let mut effects = Vec::new();
    for output in outputs {
        let Some(values) = trajectory.column(output) else { continue };
        let scale = values.iter().fold(0.0_f64, |most, value| most.max(value.abs()));
        for name in by {
            let (Some(value), Some(slopes)) =
                (value_of(name), trajectory.sensitivity(output, name))
            else {
                continue;
            };
            let relative = |slope: &f64| if *slope == 0.0 { 0.0 } else { value / scale * slope };
            let values: Vec<f64> = slopes.iter().map(relative).collect();
            effects.push(Effect::new(name, output, values, &trajectory.times));
        }
    }
    effects
}

impl Effect {
    fn new(parameter: &str, output: &str, values: Vec<f64>, times: &[f64]) -> Self {
        let mean = values.iter().map(|value| value * value).sum::<f64>() / values.len() as f64;
        // Among values that differ only by rounding, the first counts.
        let largest = values.iter().zip(times).fold((0.0_f64, 0.0), |most, (value, time)| {
            if value.abs() > (1.0 + TIE) * most.0.abs() { (*value, *time) } else { most }
        });
        Self {
            parameter: parameter.to_owned(),
            output: output.to_owned(),
            rms: mean.sqrt(),
            largest: largest.0,
            at: largest.1,
            end: values.last().copied().unwrap_or(f64::NAN),
            values,
        }
    }

    fn name(&self) -> String {
        sensitivity_name(&self.output, &self.parameter)
    }
}

/// Returns relative sensitivities over time, the largest first.
fn relative(trajectory: &Trajectory, effects: &[Effect]) -> Trajectory {
    let column = |effect: &Effect| Column {
        name: effect.name(),
        unit: "1".to_owned(),
        kind: ColumnKind::Sensitivity,
        doc: format!("relative effect of `{}` on `{}`", effect.parameter, effect.output),
        values: effect.values.clone(),
    };
    Trajectory { columns: effects.iter().map(column).collect(), ..trajectory.clone() }
}

//! `machinist gradient`: the derivative of one number of a run by parameters and initial values.

use clap::Args;
use machinist::Simulation;
use machinist::improve::{NumberGradient, gradient};
use machinist::simulate::Slope;
use machinist_contract::Simulator;
use serde::Serialize;

use super::arguments::{RunArgs, SceneArgs};
use super::improve::{expression, units};
use super::output::{columns, print, remarks};
use super::scene::Scene;
use super::settings::for_numbers;
use crate::failure::Failure;
use crate::interrupt;
use crate::number::number;
use crate::progress::during;

#[derive(Debug, Args)]
pub struct GradientCommand {
    /// Result to differentiate: an expression as for `improve`, of extremes, means and final values
    /// of outputs, such as max(abs(twist)), and of parameters
    #[arg(long, value_name = "EXPRESSION", allow_hyphen_values = true)]
    of: String,
    /// Number of times at which the run is evaluated. Default: that of the scene, but at least 2001
    #[arg(long, value_name = "NUMBER")]
    points: Option<usize>,
    /// Maximum number of rows of the table; 0 shows all
    #[arg(long, help_heading = "Output", value_name = "NUMBER", default_value_t = 20)]
    top: usize,
    /// Print JSON
    #[arg(long, help_heading = "Output")]
    json: bool,
    #[command(flatten)]
    scene: SceneArgs,
    #[command(flatten)]
    run: RunArgs,
}

/// Derivative with its parameter or state.
#[derive(Debug, Serialize)]
struct Row {
    name: String,
    unit: String,
    /// True for a parameter, false for the initial value of a state.
    is_parameter: bool,
    value: f64,
    /// Derivative, in the unit of the number over that of the parameter or state.
    slope: f64,
    /// Relative change of the number for a relative change of the value; `None` if either is 0.
    relative: Option<f64>,
}

#[derive(Debug, Serialize)]
struct Answer<'a> {
    scene: &'a str,
    of: &'a str,
    value: f64,
    unit: String,
    method: &'static str,
    rtol: f64,
    steps: u64,
    in_reverse: bool,
    slopes: Vec<Row>,
    left_out: Vec<String>,
    /// Notes of the run.
    notes: Vec<String>,
}

impl GradientCommand {
    pub fn execute(&self) -> Result<(), Failure> {
        if self.points.is_some_and(|points| points < 2) {
            return Err(Failure::input("--points must be at least 2", ""));
        }
        let scene = self.scene.load()?;
        let simulator = scene.simulator();
        let of = expression("--of", &self.of, simulator)?;
        let flag = interrupt::flag();
        let simulation = self.simulation(simulator)?.until_flagged(&flag);
        let found = during("simulating", || gradient(&simulation, &of))?;
        let remarks = remarks(&found.gradient.run, "--json");
        let answer = self.answer(found, units::of(&of, simulator), simulator);
        if self.json {
            let text = serde_json::to_string_pretty(&answer)
                .map_err(|error| Failure::unsuccessful(error, ""))?;
            return print(&format!("{text}\n"));
        }
        print(&self.describe(&answer, &scene, &remarks))
    }

    fn simulation<'a>(&self, simulator: &'a dyn Simulator<f64>) -> Result<Simulation<'a>, Failure> {
        for_numbers(simulator, (&self.scene, &self.run), self.points)
    }

    fn answer<'a>(
        &'a self,
        found: NumberGradient,
        unit: String,
        simulator: &'a dyn Simulator<f64>,
    ) -> Answer<'a> {
        let NumberGradient { value, gradient, is_in_reverse, left_out } = found;
        let row = |slope: Slope| {
            let Slope { name, unit, is_parameter, at, value: slope, .. } = slope;
            let relative = (at != 0.0 && value != 0.0).then(|| slope * at / value);
            Row { name, unit, is_parameter, value: at, slope, relative }
        };
        let mut slopes: Vec<Row> = gradient.slopes.into_iter().map(row).collect();
        let size = |row: &Row| row.relative.map_or(0.0, f64::abs);
        slopes.sort_by(|a, b| size(b).total_cmp(&size(a)));
        Answer {
            scene: simulator.name(),
            of: &self.of,
            value,
            unit,
            method: gradient.run.method.name(),
            rtol: gradient.run.rtol,
            steps: gradient.run.work.steps,
            in_reverse: is_in_reverse,
            slopes,
            left_out: left_out.into_iter().map(|(name, why)| format!("{name} {why}")).collect(),
            notes: gradient.run.notes,
        }
    }

    fn describe(&self, answer: &Answer<'_>, scene: &Scene, remarks: &str) -> String {
        let how = if answer.in_reverse { "in reverse" } else { "by sensitivities" };
        let mut text = format!(
            "{}: {} ({})\n{}, rtol {:e}, {} steps; {how}{remarks}\n{} = {} {}\n\n",
            answer.scene,
            scene.simulator().title(),
            scene.how(),
            answer.method,
            answer.rtol,
            answer.steps,
            answer.of,
            number(answer.value, 7),
            answer.unit
        );
        let per_unit = |unit: &str| match (answer.unit.as_str(), unit) {
            (of, "1") => of.to_owned(),
            (of, unit) if unit.contains([' ', '/']) => format!("{of}/({unit})"),
            (of, unit) => format!("{of}/{unit}"),
        };
        let header = ["by", "which is", "", "derivative", "", "% per %"].map(str::to_owned);
        let shown = if self.top == 0 { answer.slopes.len() } else { self.top };
        let rows = answer.slopes.iter().take(shown).map(|row| {
            let start = if row.is_parameter { "" } else { " at the start" };
            [
                format!("{}{start}", row.name),
                number(row.value, 6),
                row.unit.clone(),
                number(row.slope, 6),
                per_unit(&row.unit),
                row.relative.map_or_else(String::new, |relative| number(relative, 4)),
            ]
        });
        text.push_str(&columns(&std::iter::once(header).chain(rows).collect::<Vec<_>>(), 1));
        if let Some(rest) = answer.slopes.len().checked_sub(shown).filter(|rest| *rest > 0) {
            text.extend([format!("and {rest} more; --top 0 shows all\n")]);
        }
        if !answer.left_out.is_empty() {
            text.extend(["\nleft out: ", &answer.left_out.join("; "), "\n"]);
        }
        text
    }
}

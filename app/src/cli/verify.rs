//! `machinist verify`: all checks of every built-in scene, or of one machine of the user's own,
//! with their verdicts.

mod estimator;
#[cfg(feature = "derive")]
mod independent;
mod machine;

use clap::Args;
use machinist_studies::verify::{
    Tally, Verdict, VerifyOptions, because, number, outcome, tally_line, verify_all,
};

use super::amount::in_si;
use super::arguments::{MachineArgs, RunArgs};
use super::output::print;
use super::table::{indented, rows, width};
use crate::failure::{ErrorCode, Failure};
use crate::progress::during;
use estimator::EstimatorRuns;
pub use machine::Changes;
#[cfg(feature = "derive")]
pub use machine::verify_spec;

#[derive(Debug, Args)]
pub struct Verify {
    /// Scene file, model file, or name of a spec. Default: all built-in scenes, of which --set
    /// changes SCENE.UNIT.PARAMETER, with references unchanged
    scene: Option<String>,
    /// Run only checks whose scene or name contains this text
    #[arg(long, value_name = "TEXT")]
    only: Option<String>,
    /// Print JSON
    #[arg(long, help_heading = "Output")]
    json: bool,
    /// Add the reason of each tolerance, and what each check compares with
    #[arg(long, help_heading = "Output", conflicts_with = "json")]
    long: bool,
    #[command(flatten)]
    machine: MachineArgs,
    #[command(flatten)]
    run: RunArgs,
    #[command(flatten)]
    runs: EstimatorRuns,
}

impl Verify {
    pub fn execute(&self) -> Result<(), Failure> {
        self.runs.check(self.scene.as_ref())?;
        let verdicts = match &self.scene {
            Some(scene) => [self.of_machine(scene)?, self.of_estimator(scene)?].concat(),
            None => self.of_built_in()?,
        };
        if verdicts.is_empty() {
            let text = self.only.as_deref().unwrap_or_default();
            let help = "`machinist verify` without `--only` shows all checks";
            return Err(Failure::input(format!("no check has `{text}` in its name"), help));
        }
        if self.json {
            let text = serde_json::to_string_pretty(&verdicts)
                .map_err(|error| Failure::unsuccessful(error, ""))?;
            print(&format!("{text}\n"))?;
        } else {
            print(&self.describe(&verdicts))?;
        }
        let Tally { checked, passed, .. } = Tally::of(&verdicts);
        match checked - passed {
            0 => Ok(()),
            failed => {
                let message = format!("{failed} of {checked} checks failed");
                Err(Failure::ended(ErrorCode::CheckFailed, message, ""))
            }
        }
    }

    /// Formats the verdicts. Reasons of tolerances and references are long and left out unless asked
    /// for, but not the reasons of checks that failed or were not done.
    fn describe(&self, verdicts: &[Verdict]) -> String {
        let (width, space) = (width(), " ".repeat(6));
        let first = verdicts.first().map(|verdict| &verdict.scene);
        let has_scenes = verdicts.iter().any(|verdict| Some(&verdict.scene) != first);
        let row = |cells: [&str; 5]| -> Vec<String> {
            let shown = cells.iter().enumerate().filter(|(at, _)| *at != 1 || has_scenes);
            shown.map(|(_, cell)| (*cell).to_owned()).collect()
        };
        let cells = verdicts.iter().map(|verdict| {
            let [error, tolerance] =
                [verdict.error, verdict.tolerance].map(|value| number(verdict, value));
            row([outcome(verdict), &verdict.scene, &verdict.check, &error, &tolerance])
        });
        let header = row(["", "scene", "check", "error", "tolerance"]);
        let cells: Vec<Vec<String>> = std::iter::once(header).chain(cells).collect();
        let lines = rows(&cells, if has_scenes { 3 } else { 2 }, width);
        let mut text = lines.first().cloned().unwrap_or_default();
        for (verdict, lines) in verdicts.iter().zip(&lines[1..]) {
            text.push_str(lines);
            if self.long || outcome(verdict) != "pass" {
                text.push_str(&indented(because(verdict), &space, width));
            }
            if self.long {
                text.push_str(&indented(&format!("against {}", verdict.reference), &space, width));
            }
        }
        text.push('\n');
        text.push_str(&indented(&tally_line(verdicts), "", width));
        text
    }

    fn of_built_in(&self) -> Result<Vec<Verdict>, Failure> {
        if let Some((name, _)) = self.machine.set.iter().find(|(_, amount)| amount.unit.is_some()) {
            let message = format!("--set {name}: without a scene, numbers are in SI units");
            return Err(Failure::input(message, "leave the unit out, or name the scene"));
        }
        let options = VerifyOptions {
            overrides: in_si(&self.machine.set),
            only: self.only.clone(),
            scenes: None,
        };
        during("verifying", || verify_all(&options)).map_err(|error| Failure::input(error, ""))
    }

    fn of_estimator(&self, scene: &str) -> Result<Vec<Verdict>, Failure> {
        let is_wanted = self.only.as_ref().is_none_or(|text| "estimator:".contains(&**text));
        if !self.runs.estimator.is_given() || !is_wanted {
            return Ok(Vec::new());
        }
        self.runs.verdicts(scene, &self.machine, &self.run)
    }

    fn of_machine(&self, scene: &str) -> Result<Vec<Verdict>, Failure> {
        let changes = Changes {
            machine: self.machine.clone(),
            run: self.run.clone(),
            time_limit: self.run.time.limit_or_default(),
            only: self.only.clone(),
        };
        machine::verify(scene, &changes)
    }
}

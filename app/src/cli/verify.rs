//! `machinist verify`: all checks of every built-in scene, or of one machine of the user's own,
//! with their verdicts.

#[cfg(feature = "derive")]
mod independent;
mod machine;

use std::time::Duration;

use clap::Args;
use machinist_studies::verify::{Tally, Verdict, VerifyOptions, render_table, verify_all};

use super::amount::{Amount, assignment, in_si};
use super::output::print;
use super::settings::{TIME_LIMIT, time_limit};
use crate::failure::Failure;
use crate::progress::during;
pub use machine::Changes;
#[cfg(feature = "derive")]
pub use machine::verify_spec;

#[derive(Debug, Args)]
pub struct Verify {
    /// Scene file, model file, or name of a spec. Default: all built-in scenes
    scene: Option<String>,
    /// Print JSON
    #[arg(long)]
    json: bool,
    /// Set a parameter. Without a scene: SCENE.UNIT.PARAMETER=VALUE, with references unchanged
    #[arg(long, value_name = "UNIT.PARAMETER=VALUE", value_parser = assignment)]
    set: Vec<(String, Amount)>,
    /// Run only checks whose scene or name contains this text
    #[arg(long, value_name = "TEXT")]
    only: Option<String>,
    /// End time of the scene's run, s
    #[arg(long, value_name = "TIME", allow_hyphen_values = true, requires = "scene")]
    until: Option<f64>,
    /// Relative tolerance of the scene's run
    #[arg(long, value_name = "TOLERANCE", allow_hyphen_values = true, requires = "scene")]
    rtol: Option<f64>,
    /// Limit on the computing time of each run of the scene, s
    #[arg(long, value_name = "SECONDS", default_value = TIME_LIMIT, value_parser = time_limit, requires = "scene")]
    time_limit: Duration,
}

impl Verify {
    pub fn execute(&self) -> Result<(), Failure> {
        let verdicts = match &self.scene {
            Some(scene) => self.of_machine(scene)?,
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
            print(&render_table(&verdicts))?;
        }
        let Tally { checked, passed, .. } = Tally::of(&verdicts);
        match checked - passed {
            0 => Ok(()),
            failed => {
                let message = format!("{failed} of {checked} checks failed");
                Err(Failure::unsuccessful(message, ""))
            }
        }
    }

    fn of_built_in(&self) -> Result<Vec<Verdict>, Failure> {
        if let Some((name, _)) = self.set.iter().find(|(_, amount)| amount.unit.is_some()) {
            let message = format!("--set {name}: without a scene, numbers are in SI units");
            return Err(Failure::input(message, "leave the unit out, or name the scene"));
        }
        let options =
            VerifyOptions { overrides: in_si(&self.set), only: self.only.clone(), scenes: None };
        during("verifying", || verify_all(&options)).map_err(|error| Failure::input(error, ""))
    }

    fn of_machine(&self, scene: &str) -> Result<Vec<Verdict>, Failure> {
        let (until, rtol, time_limit) = (self.until, self.rtol, self.time_limit);
        let changes = Changes { parameters: &self.set, until, rtol, time_limit };
        let mut verdicts = machine::verify(scene, &changes)?;
        if let Some(text) = &self.only {
            verdicts.retain(|verdict| {
                format!("{}: {}", verdict.scene, verdict.check).contains(text.as_str())
            });
        }
        Ok(verdicts)
    }
}

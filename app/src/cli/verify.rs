//! `machinist verify`: every check of every scene, and whether it passes.

use clap::Args;
use machinist_studies::verify::{Verdict, VerifyOptions, render_table, verify_all};

use super::assignment;
use super::output::print;
use crate::failure::Failure;
use crate::progress::during;

#[derive(Debug, Args)]
pub struct Verify {
    /// As JSON
    #[arg(long)]
    json: bool,
    /// Give a parameter another value; references stay those of the published one
    #[arg(long, value_name = "SCENE.UNIT.PARAMETER=VALUE", value_parser = assignment)]
    set: Vec<(String, f64)>,
    /// Only checks whose scene or name contains this text
    #[arg(long, value_name = "TEXT")]
    only: Option<String>,
}

impl Verify {
    pub fn execute(&self) -> Result<(), Failure> {
        let options =
            VerifyOptions { overrides: self.set.clone(), only: self.only.clone(), scenes: None };
        let verdicts: Vec<Verdict> = during("verifying", || verify_all(&options))
            .map_err(|error| Failure::input(error, ""))?;
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
        match verdicts.iter().filter(|verdict| !verdict.pass).count() {
            0 => Ok(()),
            failed => {
                let message = format!("{failed} of {} checks failed", verdicts.len());
                Err(Failure::unsuccessful(message, ""))
            }
        }
    }
}

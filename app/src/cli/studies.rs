//! `machinist studies`: studies of the literature, computed again.

use clap::{Args, Subcommand};
use machinist_studies::ledger::{LedgerRow, ledger};

use super::output::{print, print_with};
use super::table::{indented, width};
use super::walk::WalkCommand;
use crate::failure::Failure;
use crate::number::number;
use crate::progress::during;

/// Digits of printed and computed numbers.
const DIGITS: usize = 7;

#[derive(Debug, Args)]
pub struct Studies {
    #[command(subcommand)]
    study: Study,
}

#[derive(Debug, Subcommand)]
enum Study {
    /// Select a sufficient model of a winder, and find where winding is stable
    Walk(WalkCommand),
    /// List the printed equations and figures of the studies, and how well they are reproduced
    Ledger(Ledger),
}

#[derive(Debug, Args)]
struct Ledger {
    /// List only items whose study, place or description contains this text
    #[arg(long, value_name = "TEXT")]
    only: Option<String>,
    /// Add where each item is computed, and the check or test that compares it
    #[arg(long, help_heading = "Output", conflicts_with = "json")]
    long: bool,
    /// Print JSON
    #[arg(long, help_heading = "Output")]
    json: bool,
}

impl Studies {
    pub fn execute(&self) -> Result<(), Failure> {
        match &self.study {
            Study::Walk(walk) => walk.execute(),
            Study::Ledger(ledger) => ledger.execute(),
        }
    }
}

impl Ledger {
    fn execute(&self) -> Result<(), Failure> {
        let rows = during("filling the ledger", ledger);
        let mut rows = rows.map_err(|error| Failure::unsuccessful(error, ""))?;
        if let Some(text) = &self.only {
            let of = |row: &LedgerRow| format!("{} {} {}", row.study.name(), row.at, row.figure);
            rows.retain(|row| of(row).contains(text.as_str()));
            if rows.is_empty() {
                let help = "`machinist studies ledger` without `--only` lists all items";
                return Err(Failure::input(format!("no item contains `{text}`"), help));
            }
        }
        if self.json {
            return print_with(|out| {
                serde_json::to_writer_pretty(&mut *out, &rows)?;
                writeln!(out)
            });
        }
        print(&self.describe(&rows))
    }

    /// Formats the items of each study: the numbers as a table, and verdicts below their items.
    fn describe(&self, rows: &[LedgerRow]) -> String {
        let width = width();
        let mut text = String::new();
        let mut study = "";
        for row in rows {
            if row.study.name() != study {
                study = row.study.name();
                text.extend([if text.is_empty() { "" } else { "\n" }, study, "\n"]);
            }
            let shown = |value: Option<f64>| {
                value.map_or_else(|| "-".to_owned(), |value| number(value, DIGITS))
            };
            let unit = if row.unit.is_empty() { String::new() } else { format!(" [{}]", row.unit) };
            text.push_str(&indented(&format!("{}: {}{unit}", row.at, row.figure), "  ", width));
            let has_numbers =
                [row.printed, row.as_printed, row.consistent].iter().any(Option::is_some);
            if has_numbers {
                let numbers = format!(
                    "printed {}, as printed {}, consistent {}",
                    shown(row.printed),
                    shown(row.as_printed),
                    shown(row.consistent)
                );
                text.push_str(&indented(&numbers, "    ", width));
            }
            text.push_str(&indented(&row.verdict, "    ", width));
            if self.long {
                let place = format!("computed in {}; {}", row.place, row.held.describe());
                text.push_str(&indented(&place, "    ", width));
            }
        }
        text
    }
}

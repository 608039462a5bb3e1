//! `machinist stability`: extreme cases against all methods.

use clap::Args;
use machinist::Method;
use machinist_studies::stability::{self, ObservedOrders, Outcome, POWERS, Plan, Study};

use super::amount::plain;
use super::output::{columns, print, print_with};
use super::table::paragraph;
use crate::failure::Failure;
use crate::progress::during;
use crate::trials::{DRIFT, ORDERS, cell, drift_cells, order, refusals, rule};

#[derive(Debug, Args)]
pub struct Stability {
    /// Methods. Default: all
    #[arg(long, alias = "method", value_name = "NAMES", value_delimiter = ',')]
    methods: Vec<String>,
    /// Run only cases whose part or name contains this text
    #[arg(long, value_name = "TEXT")]
    only: Option<String>,
    /// Relative tolerance of every run
    #[arg(long, value_name = "TOLERANCE", default_value = "1e-6", value_parser = plain,
        allow_hyphen_values = true)]
    rtol: f64,
    /// Number of steps of the runs that measure constraint drift. Default: 1000000 with all cases,
    /// otherwise none
    #[arg(long, value_name = "NUMBER")]
    drift_steps: Option<usize>,
    /// Print JSON, with the reasons of all refusals
    #[arg(long, help_heading = "Output")]
    json: bool,
}

impl Stability {
    pub fn execute(&self) -> Result<(), Failure> {
        let drift_steps = if self.only.is_none() { 1_000_000 } else { 0 };
        let mut plan = Plan {
            rtol: self.rtol,
            only: self.only.clone(),
            drift_steps: self.drift_steps.unwrap_or(drift_steps),
            ..Plan::default()
        };
        if !self.methods.is_empty() {
            let methods = self.methods.iter().map(|name| Method::from_name(name));
            plan.methods =
                methods.collect::<Result<_, _>>().map_err(|error| Failure::input(error, ""))?;
        }
        let study = during("straining the methods", || stability::study(&plan))?;
        if study.rows.is_empty() {
            let text = self.only.as_deref().unwrap_or_default();
            let help = "`machinist stability` without `--only` shows all cases";
            return Err(Failure::input(format!("no case has `{text}` in its name"), help));
        }
        if self.json {
            print_with(|out| {
                serde_json::to_writer_pretty(&mut *out, &study)?;
                writeln!(out)
            })?;
        } else {
            print(&table(&study))?;
        }
        let wrong =
            study.of(Method::Auto).filter(|(_, cell)| matches!(cell, Outcome::Wrong { .. }));
        match wrong.count() {
            0 => Ok(()),
            wrong => Err(Failure::unsuccessful(format!("`auto` is wrong in {wrong} cases"), "")),
        }
    }
}

fn table(study: &Study) -> String {
    let mut lines: Vec<Vec<String>> = Vec::new();
    let mut header = vec![String::new()];
    header.extend(study.methods.iter().map(|method| method.name().to_owned()));
    lines.push(header);
    let mut part = "";
    for row in &study.rows {
        if row.part != part {
            part = row.part;
            lines.push(vec![part.to_owned()]);
        }
        let mut line = vec![format!("  {}", row.case)];
        line.extend(row.cells.iter().map(|found| cell(&found.outcome)));
        lines.push(line);
    }
    for (index, what) in ["right", "refused", "wrong"].into_iter().enumerate() {
        let mut line = vec![what.to_owned()];
        line.extend(study.methods.iter().map(|method| study.counts(*method)[index].to_string()));
        lines.push(line);
    }
    let (rule, refusals) = (paragraph(&rule(study)), paragraph(&refusals(study)));
    let mut text = format!("{}\n{rule}{refusals}", aligned(&lines));
    if !study.orders.is_empty() {
        text.extend(["\n", &paragraph(ORDERS), "\n", &aligned(&order_lines(study))]);
    }
    if !study.long_runs.is_empty() {
        text.extend(["\n", &paragraph(DRIFT), "\n", &aligned(&drift_lines(study))]);
    }
    text
}

fn drift_lines(study: &Study) -> Vec<Vec<String>> {
    let header = ["", "method", "until", "steps", "before", "after"].map(str::to_owned);
    let lines = study.long_runs.iter().map(|run| drift_cells(run).to_vec());
    std::iter::once(header.to_vec()).chain(lines).collect()
}

fn order_lines(study: &Study) -> Vec<Vec<String>> {
    let mut header = vec!["lambda".to_owned(), "order".to_owned()];
    header.extend(POWERS.iter().map(|power| format!("-1e{power}")));
    let line = |row: &ObservedOrders| {
        let mut line = vec![row.method.to_owned(), row.nominal.to_string()];
        line.extend(row.orders.iter().map(|found| order(*found)));
        line
    };
    std::iter::once(header).chain(study.orders.iter().map(line)).collect()
}

/// Aligns lines of cells as columns, the first flush left. A line of one cell is a heading.
fn aligned(lines: &[Vec<String>]) -> String {
    let count = lines.first().map_or(0, Vec::len);
    let mut lines = lines.to_vec();
    for line in &mut lines {
        line.resize(count, String::new());
    }
    columns(&lines, 1)
}

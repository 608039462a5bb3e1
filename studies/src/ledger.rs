//! The reproduction ledger: what the saw-gin, winder and reed studies print, what their equations as
//! printed give, what the consistent reading gives, and what to make of it.
//!
//! Only the printed figures are written down here; every other number is computed
//! from the emitted scenes and the closed forms when the ledger is asked for.

mod motor;
mod reed;
mod run_up;
mod shaft;
mod winder;

use serde::Serialize;

use crate::verify::{CheckFailure, text_table};

/// One printed figure and what became of it.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct LedgerRow {
    /// What the figure is of.
    pub figure: &'static str,
    /// Its unit: SI, and deg where the study has deg.
    pub unit: &'static str,
    /// The figure as printed, if the study prints one.
    pub printed: Option<f64>,
    /// What equations and numbers as printed give, if they give one.
    pub as_printed: Option<f64>,
    /// What the consistent reading gives, if the figure has a meaning there.
    pub consistent: Option<f64>,
    /// One sentence on what to make of it.
    pub verdict: String,
}

/// Computes every row of the ledger.
///
/// # Errors
/// [`CheckFailure`] if a consistent run stops. A run as printed that stops is told
/// in the verdicts of its rows.
pub fn ledger() -> Result<Vec<LedgerRow>, CheckFailure> {
    let runs = run_up::Runs::new()?;
    let mut rows = motor::rows()?;
    rows.extend(run_up::rows(&runs));
    rows.extend(shaft::rows(&runs));
    rows.extend(winder::rows());
    rows.extend(reed::rows());
    Ok(rows)
}

/// The ledger as aligned text, one row a figure.
#[must_use]
pub fn render_ledger(rows: &[LedgerRow]) -> String {
    let number = |value: Option<f64>| value.map_or_else(|| "-".to_owned(), digits);
    let cells = rows.iter().map(|row| {
        [
            row.figure.to_owned(),
            row.unit.to_owned(),
            number(row.printed),
            number(row.as_printed),
            number(row.consistent),
            row.verdict.clone(),
        ]
    });
    text_table(["figure", "unit", "printed", "as printed", "consistent", "verdict"], cells)
}

/// `within 0.3 %` or `1.6 times larger`, of ours against the printed.
fn compare(printed: f64, ours: f64) -> String {
    let ratio = ours / printed;
    let deviation = (ratio - 1.0).abs();
    if deviation < 0.1 {
        format!("within {} %", digits_of(100.0 * deviation, 2))
    } else if ratio >= 1.0 {
        format!("{} times larger", digits_of(ratio, 2))
    } else if ratio > 0.0 {
        format!("{} times smaller", digits_of(1.0 / ratio, 2))
    } else {
        "of the other sign".to_owned()
    }
}

/// Whether ours is the printed figure to half of its last digit, in words.
fn reproduced(printed: f64, ours: f64, half_digit: f64) -> &'static str {
    if (ours - printed).abs() <= half_digit { "reproduced" } else { "not reproduced" }
}

/// Seven significant digits, without trailing zeros.
fn digits(value: f64) -> String {
    digits_of(value, 7)
}

fn digits_of(value: f64, significant: i32) -> String {
    if value == 0.0 || !value.is_finite() {
        return value.to_string();
    }
    let decimals = (significant - 1 - value.abs().log10().floor() as i32).clamp(0, 15);
    let text = format!("{value:.0$}", decimals as usize);
    if text.contains('.') {
        text.trim_end_matches('0').trim_end_matches('.').to_owned()
    } else {
        text
    }
}

#[cfg(test)]
#[path = "ledger/tests.rs"]
mod tests;

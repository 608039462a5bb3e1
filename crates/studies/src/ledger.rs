//! The reproduction ledger: every equation, table, figure and number in the saw-gin, winder and
//! reed studies, with the values of the equations as printed and in the consistent reading, their
//! places here, and their checks.
//!
//! Only the printed figures are written here; every other number is computed from the emitted
//! scenes and the closed forms on request. The report and the book's chapter on the studies show
//! these rows.

mod motor;
mod page;
mod periodic;
mod reed;
mod reed_statements;
mod run_up;
mod saw_gin_statements;
mod shaft;
mod winder;
mod winder_statements;

use serde::Serialize;

pub use page::page_table;

use crate::verify::machine::Machine;
use crate::verify::{CheckFailure, text_table};

/// A study.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Study {
    /// Saw gin: motor, coupling, cylinder, shaft.
    SawGin,
    /// Winding mechanisms.
    Winder,
    /// Reed of the beat-up mechanism.
    Reed,
}

impl Study {
    /// All studies.
    pub const ALL: [Self; 3] = [Self::SawGin, Self::Winder, Self::Reed];

    /// Returns the title in two words.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::SawGin => "Saw gin",
            Self::Winder => "Winder",
            Self::Reed => "Reed",
        }
    }
}

/// The check or test of a row.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Held {
    /// A row of `machinist verify`, as `scene: check`.
    Verify(&'static str),
    /// A test of this name.
    Test(&'static str),
}

impl Held {
    /// Returns a description.
    #[must_use]
    pub fn describe(self) -> String {
        match self {
            Self::Verify(check) => format!("verify `{check}`"),
            Self::Test(name) => format!("test `{name}`"),
        }
    }
}

/// One printed item of a study with its reproduction.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct LedgerRow {
    /// The study.
    pub study: Study,
    /// Its place there: `(16)`, `table 1`, `figure 3`, `section 4.1`.
    pub at: &'static str,
    /// Its description.
    pub figure: &'static str,
    /// Its unit, if it is a number: SI, and deg where the study has deg.
    pub unit: &'static str,
    /// The number as printed, if the study prints one.
    pub printed: Option<f64>,
    /// The number that equations and numbers as printed give, if they give one.
    pub as_printed: Option<f64>,
    /// Its value in the consistent reading, if it is a number there.
    pub consistent: Option<f64>,
    /// Its readings, in a sentence.
    pub verdict: String,
    /// Its place here: scenes, units, modules.
    pub place: &'static str,
    /// Its check or test.
    pub held: Held,
}

impl LedgerRow {
    /// Creates a row without a number or words.
    fn of(study: Study, at: &'static str, place: &'static str, held: Held) -> Self {
        Self {
            study,
            at,
            figure: "",
            unit: "",
            printed: None,
            as_printed: None,
            consistent: None,
            verdict: String::new(),
            place,
            held,
        }
    }
}

/// An equation or a figure without a number.
struct Statement {
    at: &'static str,
    figure: &'static str,
    verdict: &'static str,
    place: &'static str,
    held: Held,
}

impl Statement {
    fn row(&self, study: Study) -> LedgerRow {
        LedgerRow {
            figure: self.figure,
            verdict: self.verdict.to_owned(),
            ..LedgerRow::of(study, self.at, self.place, self.held)
        }
    }
}

/// A printed number that is a parameter of a scene.
struct Parameter {
    at: &'static str,
    figure: &'static str,
    unit: &'static str,
    printed: f64,
    /// Name in the consistent scene.
    name: &'static str,
    place: &'static str,
    held: Held,
}

impl Parameter {
    fn row(&self, study: Study, machine: &Machine) -> Result<LedgerRow, CheckFailure> {
        let ours = machine.value(self.name)?;
        // A number is printed to four digits or more, or rounded.
        let is_same = (ours - self.printed).abs() <= 1e-12 * self.printed.abs();
        let verdict = if is_same { "as printed".to_owned() } else { compare(self.printed, ours) };
        Ok(LedgerRow {
            figure: self.figure,
            unit: self.unit,
            printed: Some(self.printed),
            as_printed: Some(self.printed),
            consistent: Some(ours),
            verdict,
            ..LedgerRow::of(study, self.at, self.place, self.held)
        })
    }
}

/// Computes every row of the ledger, study by study: first its equations, figures and text, then
/// its numbers.
///
/// # Errors
/// [`CheckFailure`] if a consistent run stops. A run as printed that stops is reported in the
/// verdicts of its rows.
pub fn ledger() -> Result<Vec<LedgerRow>, CheckFailure> {
    let runs = run_up::Runs::new()?;
    let mut rows = saw_gin_statements::rows()?;
    rows.extend(motor::rows()?);
    rows.extend(run_up::rows(&runs));
    rows.extend(shaft::rows()?);
    rows.extend(winder_statements::rows()?);
    rows.extend(winder::rows()?);
    rows.extend(reed_statements::rows()?);
    rows.extend(reed::rows()?);
    rows.extend(periodic::rows()?);
    Ok(rows)
}

/// Returns the ledger as aligned text, with one row per item.
#[must_use]
pub fn render_ledger(rows: &[LedgerRow]) -> String {
    let number = |value: Option<f64>| value.map_or_else(|| "-".to_owned(), digits);
    let cells = rows.iter().map(|row| {
        [
            row.study.name().to_owned(),
            row.at.to_owned(),
            row.figure.to_owned(),
            row.unit.to_owned(),
            number(row.printed),
            number(row.as_printed),
            number(row.consistent),
            row.verdict.clone(),
            row.place.to_owned(),
            row.held.describe(),
        ]
    });
    let header = [
        "study",
        "at",
        "figure",
        "unit",
        "printed",
        "as printed",
        "consistent",
        "verdict",
        "where",
        "held by",
    ];
    text_table(header, cells)
}

/// Returns `within 0.3 %` or `1.6 times larger`, from our value and the printed one.
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

/// Returns in words whether our value equals the printed figure to half of its last digit.
fn reproduced(printed: f64, ours: f64, half_digit: f64) -> &'static str {
    if (ours - printed).abs() <= half_digit { "reproduced" } else { "not reproduced" }
}

/// Formats a value with seven significant digits, without trailing zeros.
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

//! Checks of a scene: references for its run.

use crate::spec::array;
use crate::spec::code::Code;
use crate::spec::diagnostic::{Mistake, Span, Spanned};
use crate::spec::expression::Ast;
use crate::spec::fields::{Fields, Findings};
use crate::spec::names::quoted;
use crate::spec::toml::{Entry, Tree};

/// A check as written.
#[derive(Debug, Clone, PartialEq)]
pub struct CheckSpec {
    /// Its name.
    pub name: Spanned<String>,
    /// The output or state that is checked.
    pub of: Spanned<String>,
    /// The reference.
    pub reference: ReferenceSpec,
    /// Tolerance of the error, relative to the largest value of the reference.
    pub tolerance: f64,
    /// Tolerance of the absolute error in addition, in the unit of the checked quantity.
    pub absolute: Option<f64>,
    /// Source of the reference.
    pub source: String,
}

/// Reference of a check.
#[derive(Debug, Clone, PartialEq)]
pub enum ReferenceSpec {
    /// An expression of time and parameters, and its text.
    Closed(Ast, String),
    /// Values at times, in SI units.
    Values(Vec<(Spanned<f64>, f64)>),
    /// A column of a CSV file, as a function of the first column.
    Column {
        /// The file.
        csv: Spanned<String>,
        /// The column.
        column: Spanned<String>,
    },
}

/// Reads a check.
pub fn check(entry: &Entry, found: &mut Findings) -> Option<CheckSpec> {
    let what = format!("check {}", quoted(&entry.key.value));
    let mut fields = Fields::open(&entry.value, what, found);
    let of = fields
        .required_text("of")
        .map(|of| Spanned { value: array::numbered(&of.value), span: of.span });
    let reference = reference(entry.key.span, &mut fields);
    let tolerance = above_zero("tolerance", &mut fields);
    if tolerance.is_none() {
        fields.require("tolerance");
    }
    let absolute = above_zero("absolute", &mut fields);
    let source = source(&mut fields);
    fields.close();
    Some(CheckSpec {
        name: entry.key.clone(),
        of: of?,
        reference: reference?,
        tolerance: tolerance?,
        absolute,
        source: source?,
    })
}

/// Reads the one reference that is given, of three kinds.
fn reference(name: Span, fields: &mut Fields<'_>) -> Option<ReferenceSpec> {
    let [expression, values, csv] = ["expression", "values", "csv"].map(|key| fields.take(key));
    let column = if csv.is_some() { fields.require("column") } else { None };
    match (expression, values, csv) {
        (Some(tree), None, None) => {
            let text = match &tree.value {
                Tree::Text { value, .. } => value.split_whitespace().collect::<Vec<_>>().join(" "),
                _ => String::new(),
            };
            Some(ReferenceSpec::Closed(fields.as_expression(tree, "expression")?, text))
        }
        (None, Some(tree), None) => pairs(tree, fields).map(ReferenceSpec::Values),
        (None, None, Some(tree)) => {
            let csv = fields.as_text(tree, "csv")?;
            fields.found().tables.push(csv.clone());
            let column = fields.as_text(column?, "column")?;
            Some(ReferenceSpec::Column { csv, column })
        }
        _ => {
            let message = "a check needs exactly one of `expression`, `values` and `csv`";
            let label = if expression.or(values).or(csv).is_some() { "several" } else { "none" };
            let help = "write expression = \"...\", values = [[t, value], ...], or \
                        csv = \"file.csv\" with column = \"name\"";
            fields
                .found()
                .mistakes
                .push(Mistake::new(Code::ConflictingKeys, name, message, label).help(help));
            None
        }
    }
}

/// Reads `[[t, value], ...]`, times increasing.
fn pairs(tree: &Spanned<Tree>, fields: &mut Fields<'_>) -> Option<Vec<(Spanned<f64>, f64)>> {
    let Tree::List(rows) = &tree.value else {
        return fields.wrong(tree, "values", "a list of [t, value]");
    };
    let mut pairs: Vec<(Spanned<f64>, f64)> = Vec::with_capacity(rows.len());
    for row in rows {
        let Tree::List(cells) = &row.value else {
            return fields.wrong(row, "values", "a list of [t, value]");
        };
        let [time, value] = cells.as_slice() else {
            let mistake = Mistake::new(
                Code::WrongType,
                row.span,
                "a row of `values` must be [t, value]",
                "here",
            );
            fields.found().mistakes.push(mistake.help("write values = [[t, value], ...]"));
            return None;
        };
        let time = fields.as_number(time, "values")?;
        let value = fields.as_number(value, "values")?.value;
        if pairs.last().is_some_and(|(before, _)| before.value >= time.value) {
            let message = "the times of `values` must increase strictly";
            fields.found().mistakes.push(Mistake::new(
                Code::InvalidTable,
                time.span,
                message,
                "not later",
            ));
            return None;
        }
        pairs.push((time, value));
    }
    if pairs.is_empty() {
        fields.found().mistakes.push(Mistake::new(
            Code::InvalidTable,
            tree.span,
            "`values` is empty",
            "nothing here",
        ));
        return None;
    }
    Some(pairs)
}

/// Reads a finite number above 0, if present.
fn above_zero(key: &'static str, fields: &mut Fields<'_>) -> Option<f64> {
    let number = fields.number(key)?;
    if number.value > 0.0 {
        return Some(number.value);
    }
    let message = format!("`{key}` is the maximum error and must be above 0");
    fields.found().mistakes.push(Mistake::new(
        Code::OutOfRange,
        number.span,
        message,
        "not above 0",
    ));
    None
}

/// Reads the source of the reference, one line.
fn source(fields: &mut Fields<'_>) -> Option<String> {
    let text = fields.required_text("source")?;
    let line = text.value.trim();
    if !line.is_empty() && !line.contains(['\n', '\r']) {
        return Some(line.to_owned());
    }
    let message = "`source` must be one line naming the origin of the reference";
    let label = if line.is_empty() { "empty" } else { "several lines" };
    fields.found().mistakes.push(Mistake::new(Code::WrongType, text.span, message, label));
    None
}

//! Reading of the distributions and correlations of parameters.
//!
//! Excluded: names and units of parameters, which [`crate::scene::scatter`] compares.

use crate::spec::Value;
use crate::spec::code::Code;
use crate::spec::diagnostic::{Mistake, Span, Spanned};
use crate::spec::fields::{Fields, Findings};
use crate::spec::inside::by_path;
use crate::spec::lexer::Text;
use crate::spec::names::did_you_mean;
use crate::spec::spread::{Amount, AmountUnit, COVERAGE, KINDS, Kind, Spread, SpreadError};
use crate::spec::toml::Tree;

/// Correlation of several parameters, as written.
#[derive(Debug, Clone, PartialEq)]
pub struct CorrelationSpec {
    /// Names, `instance.parameter`.
    pub parameters: Vec<Spanned<String>>,
    /// Rows of the matrix.
    pub matrix: Vec<Vec<f64>>,
    /// Source span of the matrix or the coefficient.
    pub span: Span,
}

/// Value of a parameter with the tolerance written behind it, if any.
pub struct Toleranced {
    /// The value.
    pub value: Value,
    /// The tolerance.
    pub tolerance: Option<Spanned<Spread>>,
}

/// Reads the value of a parameter, which may have a tolerance: `"10 +- 0.5 [mm]"`.
pub fn value(fields: &mut Fields<'_>, tree: &Spanned<Tree>, key: &str) -> Option<Toleranced> {
    // An expression such as `a +-b` is left to its own parser.
    let tolerance = Text::of(tree).and_then(|text| Spread::tolerance(text.value));
    let Some(Ok(spread)) = tolerance else {
        return fields.as_value(tree, key).map(|value| Toleranced { value, tolerance: None });
    };
    let Spread::Tolerance { centre: Some(centre), .. } = &spread else {
        let mistake = Mistake::new(
            Code::InvalidDistribution,
            tree.span,
            "this tolerance has no value",
            "here",
        );
        fields.found().mistakes.push(mistake.help("write \"10 +- 0.5\""));
        return None;
    };
    let text = Text::of(tree)?;
    let value = match &centre.unit {
        AmountUnit::OfParameter => Value::Number(centre.number),
        AmountUnit::Percent => {
            let mistake =
                Mistake::new(Code::InvalidMeasure, tree.span, "a value is not in percent", "here");
            fields.found().mistakes.push(mistake);
            return None;
        }
        // A number with a unit is an expression, whose dimension is compared later.
        AmountUnit::Own(_) => {
            let unit = text.value.rsplit_once('[').map_or("", |(_, unit)| unit);
            let before = text.value.split(['\u{b1}']).next().unwrap_or_default();
            let before = before.split("+-").next().unwrap_or_default();
            let whole =
                if before.contains('[') { before.to_owned() } else { format!("{before} [{unit}") };
            let tree = Spanned { value: Tree::Text { value: whole, inner: None }, span: tree.span };
            fields.as_value(&tree, key)?
        }
    };
    let tolerance = Some(Spanned { value: spread, span: tree.span });
    Some(Toleranced { value, tolerance })
}

/// Reads `distribution` and the keys that belong to it, besides the tolerance of the value.
pub fn spread(
    fields: &mut Fields<'_>,
    tolerance: Option<Spanned<Spread>>,
) -> Option<Spanned<Spread>> {
    let named = fields.take("distribution");
    let kind = named.and_then(|tree| kind(tree, fields));
    let mut amount =
        |key: &'static str| fields.take(key).and_then(|tree| self::amount(tree, key, fields));
    let [deviation, relative, low, mode, high] =
        ["deviation", "relative_deviation", "low", "mode", "high"].map(&mut amount);
    let coverage = fields.number("coverage");
    let given: Vec<(&str, Span)> = [
        ("deviation", &deviation),
        ("relative_deviation", &relative),
        ("low", &low),
        ("mode", &mode),
        ("high", &high),
    ]
    .into_iter()
    .filter_map(|(key, amount)| Some((key, amount.as_ref()?.span)))
    .chain(coverage.as_ref().map(|coverage| ("coverage", coverage.span)))
    .collect();
    let mut refuse = |span: Span, message: String, help: &str| {
        let mistake = Mistake::new(Code::InvalidDistribution, span, message, "here").help(help);
        fields.found().mistakes.push(mistake);
    };
    let Some(kind) = kind else {
        if let (None, Some((key, span))) = (named, given.first()) {
            let help =
                "write distribution = \"normal\", \"uniform\", \"triangular\" or \"lognormal\"";
            refuse(*span, format!("`{key}` needs a `distribution`"), help);
        }
        return tolerance;
    };
    let allowed: &[&str] = match (kind.value, &tolerance) {
        (Kind::Normal | Kind::Lognormal, Some(_)) => &["coverage"],
        (Kind::Normal | Kind::Lognormal, None) => &["deviation", "relative_deviation"],
        (Kind::Uniform | Kind::Triangular, Some(_)) => &[],
        (Kind::Uniform, None) => &["low", "high"],
        (Kind::Triangular, None) => &["low", "mode", "high"],
    };
    if let Some((key, span)) = given.iter().find(|(key, _)| !allowed.contains(key)) {
        let what =
            if tolerance.is_some() { "a value with a tolerance" } else { "this distribution" };
        let known = if allowed.is_empty() { "no such key".to_owned() } else { allowed.join(", ") };
        refuse(*span, format!("`{key}` does not belong to {what}"), &format!("it takes {known}"));
        return None;
    }
    let coverage = coverage.map_or(COVERAGE, |coverage| {
        if coverage.value <= 0.0 {
            refuse(coverage.span, "`coverage` must be above 0".to_owned(), "2 is usual");
        }
        coverage.value
    });
    let span = kind.span;
    if let Some(Spanned { value: Spread::Tolerance { centre, half, .. }, span }) = tolerance {
        let value = Spread::Tolerance { kind: kind.value, centre, half, coverage };
        return Some(Spanned { value, span });
    }
    let number = |amount: Spanned<Amount>| amount.value;
    let value = match (kind.value, deviation.or(relative), low, high) {
        (Kind::Normal | Kind::Lognormal, Some(deviation), ..) => Spread::Deviation {
            is_lognormal: kind.value == Kind::Lognormal,
            mean: None,
            deviation: deviation.value,
        },
        (Kind::Uniform | Kind::Triangular, _, Some(low), Some(high)) => Spread::Bounds {
            is_triangular: kind.value == Kind::Triangular,
            low: low.value,
            mode: mode.map(number),
            high: high.value,
        },
        (Kind::Normal | Kind::Lognormal, ..) => {
            let message = "this distribution lacks `deviation` or `relative_deviation`".to_owned();
            refuse(span, message, "or write the value with a tolerance, \"10 +- 0.5\"");
            return None;
        }
        (Kind::Uniform | Kind::Triangular, ..) => {
            let message = "this distribution lacks `low` and `high`".to_owned();
            refuse(span, message, "or write the value with a tolerance, \"10 +- 0.5\"");
            return None;
        }
    };
    Some(Spanned { value, span })
}

fn kind(tree: &Spanned<Tree>, fields: &mut Fields<'_>) -> Option<Spanned<Kind>> {
    let name = fields.as_text(tree, "distribution")?;
    let kind = Kind::of(&name.value);
    if kind.is_none() {
        let mistake =
            Mistake::new(Code::UnknownChoice, name.span, "unknown distribution", "unknown");
        let help = did_you_mean(&name.value, KINDS.into_iter());
        fields.found().mistakes.push(mistake.help(help));
    }
    kind.map(|value| Spanned { value, span: name.span })
}

/// Reads a number in the unit of the parameter, or a string with a unit.
fn amount(tree: &Spanned<Tree>, key: &str, fields: &mut Fields<'_>) -> Option<Spanned<Amount>> {
    let span = tree.span;
    let is_relative = key == "relative_deviation";
    let mut amount = match Text::of(tree) {
        None => {
            Amount { number: fields.as_number(tree, key)?.value, unit: AmountUnit::OfParameter }
        }
        Some(text) => match Amount::parse(text.value, 0) {
            Ok(amount) => amount,
            Err(error) => {
                fields.found().mistakes.push(mistake(&text, error));
                return None;
            }
        },
    };
    if is_relative && amount.unit != AmountUnit::Percent {
        if amount.unit != AmountUnit::OfParameter {
            let mistake = Mistake::new(
                Code::InvalidDistribution,
                span,
                "`relative_deviation` has no unit",
                "here",
            );
            fields.found().mistakes.push(mistake.help("write 0.05 or \"5 %\""));
            return None;
        }
        amount = Amount { number: amount.number * 100.0, unit: AmountUnit::Percent };
    }
    Some(Spanned { value: amount, span })
}

fn mistake(text: &Text<'_>, error: SpreadError) -> Mistake {
    Mistake::new(Code::InvalidMeasure, text.span(error.range), error.message, "here")
        .help(error.help)
}

/// Reads `[scatter]` of a scene: distributions as text, by `instance.parameter`.
pub fn overlay(fields: &mut Fields<'_>) -> Vec<(Spanned<String>, Spanned<Spread>)> {
    let mut all = Vec::new();
    for (name, tree) in by_path(fields.entries("scatter")) {
        let Some(text) = Text::of(tree) else {
            fields.wrong::<()>(tree, &name.value, "a distribution in quotes");
            continue;
        };
        match Spread::parse(text.value) {
            Ok(value) => all.push((name, Spanned { value, span: tree.span })),
            Err(error) => fields.found().mistakes.push(mistake(&text, error)),
        }
    }
    all
}

/// Reads `[[correlations]]` of a scene.
pub fn correlations(fields: &mut Fields<'_>) -> Vec<CorrelationSpec> {
    let all = fields.list("correlations");
    all.iter().filter_map(|tree| correlation(tree, fields.found())).collect()
}

fn correlation(tree: &Spanned<Tree>, found: &mut Findings) -> Option<CorrelationSpec> {
    let mut fields = Fields::open(tree, "[[correlations]]".to_owned(), found);
    let parameters = names(&mut fields);
    let coefficient = fields.number("coefficient");
    let matrix = fields.take("matrix");
    let span = matrix.map_or(fields.span, |tree| tree.span);
    let rows = matrix.map(|tree| rows(tree, &mut fields));
    fields.close();
    let count = parameters.len();
    let mut refuse = |span: Span, message: String, help: &str| {
        found
            .mistakes
            .push(Mistake::new(Code::InvalidDistribution, span, message, "here").help(help));
        None
    };
    let help = "write coefficient = 0.5, or matrix = [[1, 0.5], [0.5, 1]]";
    if count < 2 {
        return refuse(tree.span, "a correlation needs at least 2 parameters".to_owned(), help);
    }
    match (coefficient, rows) {
        (Some(coefficient), None) => {
            let entry = |row: usize, column: usize| {
                if row == column { 1.0 } else { coefficient.value }
            };
            let matrix =
                (0..count).map(|row| (0..count).map(|column| entry(row, column)).collect());
            Some(CorrelationSpec { parameters, matrix: matrix.collect(), span: coefficient.span })
        }
        (None, Some(rows)) => {
            let matrix = rows?;
            if matrix.len() != count || matrix.iter().any(|row| row.len() != count) {
                let message = format!("`matrix` must have {count} rows of {count} numbers");
                return refuse(span, message, "one row and one column for each parameter");
            }
            Some(CorrelationSpec { parameters, matrix, span })
        }
        (Some(_), Some(_)) => {
            refuse(span, "a correlation has `coefficient` or `matrix`, not both".to_owned(), help)
        }
        (None, None) => {
            refuse(span, "[[correlations]] lacks `coefficient` or `matrix`".to_owned(), help)
        }
    }
}

fn names(fields: &mut Fields<'_>) -> Vec<Spanned<String>> {
    let Some(tree) = fields.require("parameters") else { return Vec::new() };
    let Tree::List(items) = &tree.value else {
        return fields.wrong(tree, "parameters", "a list of names").unwrap_or_default();
    };
    let names = items.iter().filter_map(|item| fields.as_text(item, "parameters"));
    names
        .map(|name| Spanned { value: crate::spec::array::numbered(&name.value), span: name.span })
        .collect()
}

fn rows(tree: &Spanned<Tree>, fields: &mut Fields<'_>) -> Option<Vec<Vec<f64>>> {
    let Tree::List(rows) = &tree.value else {
        return fields.wrong(tree, "matrix", "a list of rows");
    };
    let mut matrix = Vec::new();
    for row in rows {
        let Tree::List(entries) = &row.value else {
            return fields.wrong(row, "matrix", "a list of numbers");
        };
        let mut numbers = Vec::new();
        for entry in entries {
            numbers.push(fields.as_number(entry, "matrix")?.value);
        }
        matrix.push(numbers);
    }
    Some(matrix)
}

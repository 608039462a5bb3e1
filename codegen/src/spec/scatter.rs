//! Probability distributions of parameters, as specs and the command line give them.
//!
//! ```text
//! law    = kind "(" amount { "," amount } ")" | [ amount ] "+-" amount
//! kind   = "normal" | "uniform" | "triangular" | "lognormal"
//! amount = number [ "[" unit "]" | "%" ]
//! ```
//!
//! Excluded: names and units of parameters, which [`crate::scene::scatter`] compares.

use std::ops::Range;

use crate::spec::diagnostic::{Mistake, Span, Spanned};
use crate::spec::fields::{Fields, Findings};
use crate::spec::inside::by_path;
use crate::spec::lexer::Text;
use crate::spec::measure::Measure;
use crate::spec::names::did_you_mean;
use crate::spec::toml::Tree;
use crate::spec::{Declared, Value};

/// Kinds of distributions, by name.
pub const KINDS: [&str; 4] = ["normal", "uniform", "triangular", "lognormal"];

/// Kind of a distribution.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// Normal.
    Normal,
    /// Uniform between bounds.
    Uniform,
    /// Triangular between bounds.
    Triangular,
    /// Lognormal.
    Lognormal,
}

impl Kind {
    const ALL: [Self; 4] = [Self::Normal, Self::Uniform, Self::Triangular, Self::Lognormal];

    fn of(name: &str) -> Option<Self> {
        KINDS.iter().position(|known| *known == name).map(|index| Self::ALL[index])
    }
}

/// A number with its unit, as written.
#[derive(Debug, Clone, PartialEq)]
pub struct Amount {
    /// The number.
    pub number: f64,
    /// Its unit.
    pub unit: AmountUnit,
}

/// Unit of an [`Amount`].
#[derive(Debug, Clone, PartialEq)]
pub enum AmountUnit {
    /// The unit of the parameter.
    OfParameter,
    /// Percent of the parameter's value.
    Percent,
    /// A unit of its own.
    Own(Measure),
}

/// Spread of a parameter, as written.
#[derive(Debug, Clone, PartialEq)]
pub enum Spread {
    /// A standard deviation, of a normal or a lognormal distribution with this mean.
    Deviation {
        /// True for a lognormal distribution.
        is_lognormal: bool,
        /// Mean; the parameter's value if absent.
        mean: Option<Amount>,
        /// Standard deviation.
        deviation: Amount,
    },
    /// Bounds, of a uniform or a triangular distribution.
    Bounds {
        /// True for a triangular distribution.
        is_triangular: bool,
        /// Lower bound.
        low: Amount,
        /// Mode of a triangular distribution; the parameter's value if absent.
        mode: Option<Amount>,
        /// Upper bound.
        high: Amount,
    },
    /// A tolerance, `10 +- 0.5`.
    Tolerance {
        /// Shape: uniform or triangular over the tolerance, or normal.
        kind: Kind,
        /// Centre; the parameter's value if absent.
        centre: Option<Amount>,
        /// Half the width.
        half: Amount,
        /// Number of standard deviations in half the width of a normal distribution.
        coverage: f64,
    },
}

/// Distribution of a parameter with all numbers in SI units.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Law {
    /// Normal: mean and standard deviation.
    Normal(f64, f64),
    /// Uniform: bounds.
    Uniform(f64, f64),
    /// Triangular: lower bound, mode, upper bound.
    Triangular(f64, f64, f64),
    /// Lognormal: mean and standard deviation of the parameter itself.
    Lognormal(f64, f64),
}

/// Number of standard deviations in half the width of a normal tolerance, unless given
/// (JCGM 100:2008, 6.3.3).
pub const COVERAGE: f64 = 2.0;

/// Error in the text of a distribution.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct SpreadError {
    /// The reason.
    pub message: String,
    /// Hint; may be empty.
    pub help: String,
    /// Bytes of the text that are wrong.
    pub range: Range<usize>,
}

/// Example in hints.
const EXAMPLE: &str = "write normal(10, 0.5), normal(5 %), uniform(9, 11), triangular(9, 10, 12), \
                       lognormal(10, 1) or 10 +- 0.5";

impl Spread {
    /// Parses a distribution.
    ///
    /// # Errors
    /// The reason, and the bytes that are wrong.
    pub fn parse(text: &str) -> Result<Self, SpreadError> {
        if let Some(tolerance) = Self::tolerance(text) {
            return tolerance;
        }
        let wrong = |message: String, help: String, range: Range<usize>| {
            Err(SpreadError { message, help, range })
        };
        let call = text.trim_end().strip_suffix(')').and_then(|text| text.split_once('('));
        let Some((name, arguments)) = call else {
            let message = "this is not a distribution".to_owned();
            return wrong(message, EXAMPLE.to_owned(), 0..text.len());
        };
        let Some(kind) = Kind::of(name.trim()) else {
            let message = format!("there is no distribution `{}`", name.trim().escape_debug());
            return wrong(message, did_you_mean(name.trim(), KINDS.into_iter()), 0..name.len());
        };
        let mut amounts = Vec::new();
        let mut at = name.len() + 1;
        for argument in arguments.split(',') {
            amounts.push(Amount::parse(argument, at)?);
            at += argument.len() + 1;
        }
        Self::of(kind, amounts).ok_or_else(|| SpreadError {
            message: format!("{} takes other numbers", name.trim()),
            help: match kind {
                Kind::Normal | Kind::Lognormal => {
                    format!("write {0}(MEAN, DEVIATION) or {0}(DEVIATION)", name.trim())
                }
                Kind::Uniform => "write uniform(LOW, HIGH)".to_owned(),
                Kind::Triangular => {
                    "write triangular(LOW, MODE, HIGH) or triangular(LOW, HIGH)".to_owned()
                }
            },
            range: 0..text.len(),
        })
    }

    fn of(kind: Kind, amounts: Vec<Amount>) -> Option<Self> {
        let mut amounts = amounts.into_iter();
        let mut next = || amounts.next();
        let spread = match kind {
            Kind::Normal | Kind::Lognormal => {
                let is_lognormal = kind == Kind::Lognormal;
                match (next()?, next()) {
                    (mean, Some(deviation)) => {
                        Self::Deviation { is_lognormal, mean: Some(mean), deviation }
                    }
                    (deviation, None) => Self::Deviation { is_lognormal, mean: None, deviation },
                }
            }
            Kind::Uniform => {
                let (low, high) = (next()?, next()?);
                Self::Bounds { is_triangular: false, low, mode: None, high }
            }
            Kind::Triangular => match (next()?, next()?, next()) {
                (low, mode, Some(high)) => {
                    Self::Bounds { is_triangular: true, low, mode: Some(mode), high }
                }
                (low, high, None) => Self::Bounds { is_triangular: true, low, mode: None, high },
            },
        };
        amounts.next().is_none().then_some(spread)
    }

    /// Parses `10 +- 0.5` or `+- 5 %`; `None` for any other text. A unit behind the last number
    /// holds for both.
    #[must_use]
    pub fn tolerance(text: &str) -> Option<Result<Self, SpreadError>> {
        let (at, mark) = ["+-", "\u{b1}"].iter().find_map(|mark| Some((text.find(mark)?, mark)))?;
        let (before, after) = (&text[..at], &text[at + mark.len()..]);
        let read = || {
            let half = Amount::parse(after, at + mark.len())?;
            let mut centre = match before.trim() {
                "" => None,
                _ => Some(Amount::parse(before, 0)?),
            };
            if let Some(centre) = &mut centre {
                let shared = matches!(half.unit, AmountUnit::Own(_));
                if centre.unit == AmountUnit::OfParameter && shared {
                    centre.unit = half.unit.clone();
                }
            }
            Ok(Self::Tolerance { kind: Kind::Uniform, centre, half, coverage: COVERAGE })
        };
        Some(read())
    }

    /// Returns the law about a value in SI units, for a parameter of the declared unit.
    ///
    /// # Errors
    /// The reason: a unit of another dimension, or numbers that make no distribution.
    pub fn law(&self, value: f64, unit: &Declared) -> Result<Law, String> {
        let law = match self {
            Self::Deviation { is_lognormal, mean, deviation } => {
                let mean = location(mean.as_ref(), value, unit)?;
                let deviation = deviation.size(mean, unit)?;
                if *is_lognormal {
                    Law::Lognormal(mean, deviation)
                } else {
                    Law::Normal(mean, deviation)
                }
            }
            Self::Bounds { is_triangular: false, low, high, .. } => {
                Law::Uniform(low.place(unit)?, high.place(unit)?)
            }
            Self::Bounds { low, mode, high, .. } => {
                let mode = location(mode.as_ref(), value, unit)?;
                Law::Triangular(low.place(unit)?, mode, high.place(unit)?)
            }
            Self::Tolerance { kind, centre, half, coverage } => {
                let centre = location(centre.as_ref(), value, unit)?;
                let half = half.size(centre, unit)?;
                match kind {
                    Kind::Normal => Law::Normal(centre, half / coverage),
                    Kind::Lognormal => Law::Lognormal(centre, half / coverage),
                    Kind::Triangular => Law::Triangular(centre - half, centre, centre + half),
                    Kind::Uniform => Law::Uniform(centre - half, centre + half),
                }
            }
        };
        law.check().map(|()| law)
    }
}

impl Law {
    /// Returns the reason if the numbers make no distribution.
    fn check(self) -> Result<(), String> {
        let (numbers, is_ordered) = match self {
            Self::Normal(mean, deviation) => ([mean, deviation, 0.0], deviation >= 0.0),
            Self::Lognormal(mean, deviation) => {
                if mean <= 0.0 {
                    return Err("the mean of a lognormal distribution must be above 0".to_owned());
                }
                ([mean, deviation, 0.0], deviation >= 0.0)
            }
            Self::Uniform(low, high) => ([low, high, 0.0], low <= high),
            Self::Triangular(low, mode, high) => ([low, mode, high], low <= mode && mode <= high),
        };
        if numbers.iter().any(|number| !number.is_finite()) {
            return Err("the numbers of a distribution must be finite".to_owned());
        }
        if is_ordered {
            return Ok(());
        }
        Err(match self {
            Self::Normal(..) | Self::Lognormal(..) => {
                "a standard deviation must not be negative".to_owned()
            }
            Self::Uniform(low, high) => {
                format!("the lower bound {low} is above the upper bound {high}")
            }
            Self::Triangular(low, mode, high) => {
                format!("the mode {mode} is not between the bounds {low} and {high}")
            }
        })
    }
}

fn location(amount: Option<&Amount>, value: f64, unit: &Declared) -> Result<f64, String> {
    amount.map_or(Ok(value), |amount| amount.place(unit))
}

impl Amount {
    /// Parses a number with its unit; `at` is its offset in the whole text.
    fn parse(text: &str, at: usize) -> Result<Self, SpreadError> {
        let start = at + text.len() - text.trim_start().len();
        let written = text.trim();
        let range = start..start + written.len().max(1);
        let (number, unit) = if let Some(number) = written.strip_suffix('%') {
            (number, AmountUnit::Percent)
        } else if let Some((number, symbol)) =
            written.strip_suffix(']').and_then(|written| written.split_once('['))
        {
            let offset = start + number.len() + 1;
            let measure = Measure::parse(symbol).map_err(|error| SpreadError {
                message: error.message,
                help: error.help,
                range: offset + error.range.start..offset + error.range.end,
            })?;
            (number, AmountUnit::Own(measure))
        } else {
            (written, AmountUnit::OfParameter)
        };
        match number.trim().parse::<f64>() {
            Ok(number) if number.is_finite() => Ok(Self { number, unit }),
            _ => Err(SpreadError {
                message: format!("`{}` is not a number", written.escape_debug()),
                help: EXAMPLE.to_owned(),
                range,
            }),
        }
    }

    /// Returns a value of the parameter, in SI units.
    fn place(&self, unit: &Declared) -> Result<f64, String> {
        if self.unit == AmountUnit::Percent {
            return Err("percent are for deviations and tolerances, not for values".to_owned());
        }
        self.size(0.0, unit)
    }

    /// Returns a size in SI units; percent refer to `value`.
    fn size(&self, value: f64, unit: &Declared) -> Result<f64, String> {
        match &self.unit {
            AmountUnit::OfParameter => Ok(self.number * unit.factor.to_f64()),
            AmountUnit::Percent => Ok(self.number / 100.0 * value.abs()),
            AmountUnit::Own(measure) if measure.unit.dimension == unit.unit.dimension => {
                Ok(self.number * measure.factor.to_f64())
            }
            AmountUnit::Own(measure) => Err(format!(
                "this is in {}, but the parameter is in {}",
                measure.unit.dimension, unit.unit.dimension
            )),
        }
    }
}

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
        let mistake = Mistake::new(tree.span, "this tolerance has no value", "here");
        fields.found().mistakes.push(mistake.help("write \"10 +- 0.5\""));
        return None;
    };
    let text = Text::of(tree)?;
    let value = match &centre.unit {
        AmountUnit::OfParameter => Value::Number(centre.number),
        AmountUnit::Percent => {
            let mistake = Mistake::new(tree.span, "a value is not in percent", "here");
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
    let kind = fields.take("distribution").and_then(|tree| kind(tree, fields));
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
        let mistake = Mistake::new(span, message, "here").help(help);
        fields.found().mistakes.push(mistake);
    };
    let Some(kind) = kind else {
        if let Some((key, span)) = given.first() {
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
        let mistake = Mistake::new(name.span, "unknown distribution", "unknown");
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
            let mistake = Mistake::new(span, "`relative_deviation` has no unit", "here");
            fields.found().mistakes.push(mistake.help("write 0.05 or \"5 %\""));
            return None;
        }
        amount = Amount { number: amount.number * 100.0, unit: AmountUnit::Percent };
    }
    Some(Spanned { value: amount, span })
}

fn mistake(text: &Text<'_>, error: SpreadError) -> Mistake {
    Mistake::new(text.span(error.range), error.message, "here").help(error.help)
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
        found.mistakes.push(Mistake::new(span, message, "here").help(help));
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

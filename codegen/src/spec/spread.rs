//! Probability distributions as text: laws with their numbers and units.
//!
//! ```text
//! law    = kind "(" amount { "," amount } ")" | [ amount ] "+-" amount
//! kind   = "normal" | "uniform" | "triangular" | "lognormal"
//! amount = number [ "[" unit "]" | "%" ]
//! ```

use std::ops::Range;

use crate::spec::Declared;
use crate::spec::measure::{self, Measure};
use crate::spec::names::did_you_mean;

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

    pub(super) fn of(name: &str) -> Option<Self> {
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
    pub(super) fn parse(text: &str, at: usize) -> Result<Self, SpreadError> {
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
            _ => {
                let numeric = |c: char| c.is_ascii_digit() || "+-.".contains(c);
                let length = written.find(|c| !numeric(c)).unwrap_or(written.len());
                let meant = measure::in_brackets(written, length);
                let meant = meant.filter(|(_, end)| length > 0 && *end == written.len());
                Err(SpreadError {
                    message: format!("`{}` is not a number", written.escape_debug()),
                    help: meant.map_or_else(
                        || EXAMPLE.to_owned(),
                        |(meant, _)| format!("write `{meant}`: a unit must be in brackets"),
                    ),
                    range,
                })
            }
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

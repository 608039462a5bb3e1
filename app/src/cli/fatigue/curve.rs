//! Options of the S-N curve.

use clap::{Args, ValueEnum};
use machinist::fatigue::{Curve, MeanStress, MinerRule};
use machinist::trajectory::Column;

use crate::cli::amount::Amount;
use crate::failure::Failure;

/// S-N curve N = N_k (S/S_k)^-k of amplitudes S with mean zero.
#[derive(Debug, Clone, Args)]
#[command(next_help_heading = "S-N curve")]
pub struct CurveArgs {
    /// Amplitude at the knee of the S-N curve: of all outputs, in their unit, or of one,
    /// `stress=120MPa`. Without it, cycles are only counted
    #[arg(long, value_name = "[OUTPUT=]AMPLITUDE", value_delimiter = ',', value_parser = endurance)]
    endurance: Vec<(Option<String>, Amount)>,
    /// Number of cycles at the knee
    #[arg(long, value_name = "CYCLES", default_value_t = 2e6)]
    knee: f64,
    /// Slope k of the curve above the knee
    #[arg(long, value_name = "SLOPE", default_value_t = 5.0)]
    pub slope: f64,
    /// Curve below the knee
    #[arg(long, value_name = "RULE", value_enum, default_value_t = Rule::Haibach)]
    miner: Rule,
    /// Correction for the mean of a cycle: none, goodman:STRENGTH, gerber:STRENGTH,
    /// soderberg:YIELD, walker:EXPONENT or swt; strengths in the unit of the outputs, or with
    /// another one, `goodman:600MPa`
    #[arg(long, value_name = "CORRECTION", value_parser = mean, default_value = "none")]
    mean: Correction,
}

/// Curve below the knee.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Rule {
    /// Smaller amplitudes do no damage
    Original,
    /// The slope k goes on
    Elementary,
    /// The slope is 2 k - 1
    Haibach,
}

/// A correction with its name.
#[derive(Debug, Clone, PartialEq)]
struct Correction {
    text: String,
    mean: MeanStress,
    /// Strength or yield.
    strength: Option<Amount>,
}

impl CurveArgs {
    /// Returns an error unless all numbers are above zero.
    pub fn check(&self) -> Result<(), Failure> {
        let named = [("--knee", self.knee), ("--slope", self.slope)];
        let endurance = self.endurance.iter().map(|(_, value)| ("--endurance", value.value));
        let mut all = named.into_iter().chain(endurance);
        match all.find(|(_, value)| !(value.is_finite() && *value > 0.0)) {
            Some((option, value)) => {
                Err(Failure::input(format!("{option} {value} is not above zero"), ""))
            }
            None if self.slope < 1.0 => {
                let message = format!("--slope {} is below 1", self.slope);
                Err(Failure::input(message, "S-N curves of metals have slopes from 3 to 15"))
            }
            None => Ok(()),
        }
    }

    /// Returns an error for an amplitude of an output that is not counted, and for units of another
    /// dimension than that of the outputs.
    pub fn check_outputs(&self, counted: &[&Column]) -> Result<(), Failure> {
        for (name, amount) in &self.endurance {
            let is_meant = |column: &&&Column| name.as_ref().is_none_or(|n| *n == column.name);
            let mut meant = counted.iter().filter(is_meant).peekable();
            if let (Some(name), None) = (name, meant.peek()) {
                let message =
                    format!("--endurance: output `{}` is not counted", name.escape_debug());
                let names = counted.iter().map(|column| column.name.as_str());
                return Err(Failure::unknown(message, name, names));
            }
            meant.try_for_each(|column| amount.check(&column.name, &column.unit))?;
        }
        let strength = self.mean.strength.iter();
        let mut strength = strength.flat_map(|one| counted.iter().map(move |column| (one, column)));
        strength.try_for_each(|(one, column)| one.check(&column.name, &column.unit))
    }

    /// Returns the curve of an output, unless its endurance is unknown.
    pub fn of(&self, name: &str) -> Option<Curve> {
        let given = |wanted: Option<&str>| {
            let found = self.endurance.iter().rev().find(|(name, _)| name.as_deref() == wanted);
            found.map(|(_, amount)| amount.value)
        };
        let endurance = given(Some(name)).or_else(|| given(None))?;
        let rule = match self.miner {
            Rule::Original => MinerRule::Original,
            Rule::Elementary => MinerRule::Elementary,
            Rule::Haibach => MinerRule::Haibach,
        };
        let Self { knee, slope, .. } = *self;
        Some(Curve { endurance, knee, slope, rule, mean: self.mean.mean })
    }

    /// Returns the correction for the mean.
    pub fn mean(&self) -> MeanStress {
        self.mean.mean
    }

    /// Describes the curve.
    pub fn describe(&self) -> String {
        let Self { knee, slope, .. } = self;
        let rule = match self.miner {
            Rule::Original => "no damage below",
            Rule::Elementary => "the same slope below",
            Rule::Haibach => "slope 2k - 1 below",
        };
        format!("slope {slope}, knee at {knee:e} cycles, {rule}, mean {}", self.mean.text)
    }
}

fn endurance(text: &str) -> Result<(Option<String>, Amount), String> {
    let (name, value) = match text.rsplit_once('=') {
        Some((name, value)) => (Some(name.trim().to_owned()), value),
        None => (None, text),
    };
    Ok((name, Amount::parse(value)?))
}

fn mean(text: &str) -> Result<Correction, String> {
    let (name, number) = match text.split_once(':') {
        Some((name, number)) => (name.trim(), Some(number.trim())),
        None => (text.trim(), None),
    };
    let above_zero = || {
        let missing = match name {
            "walker" => "an exponent: walker:0.5".to_owned(),
            _ => format!("a strength: {name}:600"),
        };
        let number = number.ok_or_else(|| format!("`{name}` needs {missing}"))?;
        let amount = Amount::parse(number)?;
        if amount.value > 0.0 {
            return Ok(amount);
        }
        Err(format!("{name}:{number} is not above zero"))
    };
    let of_strength = |mean: fn(f64) -> MeanStress| {
        above_zero().map(|strength| (mean(strength.value), Some(strength)))
    };
    let (mean, strength) = match (name, number) {
        ("none", None) => (MeanStress::Ignored, None),
        ("swt", None) => (MeanStress::Walker(0.5), None),
        ("goodman" | "soderberg", _) => of_strength(MeanStress::Goodman)?,
        ("gerber", _) => of_strength(MeanStress::Gerber)?,
        ("walker", _) => match above_zero()? {
            Amount { value, unit: None } if value <= 1.0 => (MeanStress::Walker(value), None),
            Amount { value, unit: None } => {
                return Err(format!("walker:{value}: the exponent is at most 1"));
            }
            Amount { .. } => return Err("the exponent of walker has no unit".to_owned()),
        },
        _ => {
            return Err("one of none, goodman:STRENGTH, gerber:STRENGTH, soderberg:YIELD, \
                        walker:EXPONENT, swt"
                .to_owned());
        }
    };
    Ok(Correction { text: text.trim().to_owned(), mean, strength })
}

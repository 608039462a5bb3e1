//! Noise of a column, as the command line and experiments give it.

use machinist::fit::Noise;
use machinist_contract::Simulator;

use crate::cli::amount::{Amount, in_unit};
use crate::failure::Failure;

/// Standard deviation of measured values: sqrt(absolute^2 + (share value)^2).
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Sigma {
    /// Absolute part; without a unit, it is in that of the column.
    pub absolute: Option<Amount>,
    /// Relative part, as a fraction of the measured value.
    pub share: f64,
}

impl Sigma {
    /// Returns the noise of an output or a state, in its unit.
    pub fn of(&self, name: &str, simulator: &dyn Simulator<f64>) -> Result<Noise, Failure> {
        let shape = simulator.shape();
        let outputs = (0..shape.outputs).map(|index| simulator.output(index));
        let mut all = outputs.chain((0..shape.states()).map(|index| simulator.state(index)));
        let unit = all.find(|quantity| quantity.name == name).map_or("1", |found| found.unit);
        let absolute = match &self.absolute {
            None => 0.0,
            Some(amount) => {
                amount.check(&format!("sigma of {name}"), unit)?;
                // Amounts with a unit are in SI units; outputs may be in others.
                amount.unit.as_ref().map_or(amount.value, |_| in_unit(amount.value, unit))
            }
        };
        Ok(Noise::Of { absolute, share: self.share })
    }
}

/// Parses a standard deviation: `2e-4`, `0.2 mm`, `2 %` of the measured value, or `2e-4 + 2 %`.
pub fn noise(text: &str) -> Result<Sigma, String> {
    const EXAMPLE: &str = "write it as a number in the unit of the column or with a unit, relative \
                           to the measured value, or both: 0.02, 0.2 mm, 1 %, 0.02 + 1 %";
    let mut sigma = Sigma::default();
    for part in text.split(" + ").flat_map(|part| split_plain(part.trim())) {
        let (amount, is_first) = if let Some(number) = part.strip_suffix('%') {
            let percent: f64 = number.trim().parse().map_err(|_| EXAMPLE)?;
            let is_first = sigma.share == 0.0;
            sigma.share = 0.01 * percent;
            (percent, is_first)
        } else {
            let amount = Amount::parse(part).map_err(|why| format!("{why}; {EXAMPLE}"))?;
            let (value, is_first) = (amount.value, sigma.absolute.is_none());
            sigma.absolute = Some(amount);
            (value, is_first)
        };
        if !is_first {
            return Err(EXAMPLE.to_owned());
        }
        if !(amount.is_finite() && amount > 0.0) {
            return Err(format!("{amount} is not above 0"));
        }
    }
    Ok(sigma)
}

/// Splits at each `+` that is not the sign of an exponent.
fn split_plain(text: &str) -> Vec<&str> {
    let is_between = |(at, _): &(usize, &str)| {
        let before = text[..*at].trim_end();
        !before.is_empty() && !before.ends_with(['e', 'E'])
    };
    match text.match_indices('+').find(is_between) {
        None => vec![text],
        Some((at, _)) => vec![text[..at].trim(), text[at + 1..].trim()],
    }
}

/// Parses `output=noise`, as `--sigma` takes it.
pub fn of_output(text: &str) -> Result<(String, Sigma), String> {
    let (name, value) =
        text.split_once('=').ok_or("write it as OUTPUT=VALUE, such as twist=2e-4 or twist=1%")?;
    let noise = noise(value).map_err(|why| format!("{}: {why}", name.trim()))?;
    Ok((name.trim().to_owned(), noise))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn noise_is_absolute_relative_or_both() {
        let of = |absolute: f64, share| {
            let absolute = Some(Amount { value: absolute, unit: None }).filter(|a| a.value > 0.0);
            Ok(Sigma { absolute, share })
        };
        assert_eq!(noise("2e-4"), of(2e-4, 0.0));
        assert_eq!(noise("2 %"), of(0.0, 0.02));
        for both in ["1e+2 + 2 %", "1e+2+2%", "2% + 100"] {
            assert_eq!(noise(both), of(100.0, 0.02), "{both}");
        }
        for bad in ["", "x", "0", "-1", "1 + 2", "1 % + 2 %", "inf", "1 [m", "1+2+3"] {
            assert!(noise(bad).is_err(), "{bad}");
        }
        assert_eq!(of_output("a.b = 3"), Ok(("a.b".to_owned(), noise("3").unwrap())));
        assert!(of_output("a.b").is_err());
    }
    #[cfg(feature = "derive")]
    #[test]
    fn the_absolute_part_may_have_a_unit() {
        let sigma = noise("0.2 mm + 1 %").unwrap();
        assert_eq!(sigma.absolute.map(|amount| amount.value), Some(2e-4));
        assert!(noise("0.2 parsec").unwrap_err().contains("parsec"));
    }
}

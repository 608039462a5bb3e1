//! Options that give a parameter a range of values.

use machinist::Simulation;

use super::amount::{Amount, is_alike};
use crate::failure::Failure;

/// Range of a parameter.
#[derive(Debug, Clone, PartialEq)]
pub struct Range {
    /// Name of the parameter.
    pub name: String,
    /// First value, in SI units.
    pub from: f64,
    /// Last value, in SI units.
    pub to: f64,
    is_log: bool,
    amount: Amount,
}

impl Range {
    /// Returns an error if the unit has another dimension than the parameter.
    pub fn check(&self, run: &Simulation<'_>) -> Result<(), Failure> {
        self.amount.check_of(&self.name, run)
    }

    /// Returns value `index` of `count`. Both ends are met exactly.
    pub fn value(&self, index: usize, count: usize) -> f64 {
        if self.is_log && index > 0 && index + 1 < count {
            return self.from * (self.to / self.from).powf(index as f64 / (count - 1) as f64);
        }
        equally_spaced([self.from, self.to], index, count)
    }
}

/// Returns value `index` of `count` equally spaced values. Both ends are met exactly.
pub fn equally_spaced([from, to]: [f64; 2], index: usize, count: usize) -> f64 {
    match index {
        0 => from,
        _ if index + 1 == count => to,
        _ => from + (to - from) * (index as f64 / (count - 1) as f64),
    }
}

/// Parses `name=from..to`, optionally with `:log`, as `--parameter` takes it.
pub fn range(text: &str) -> Result<Range, String> {
    const EXAMPLE: &str = "write it as NAME=FROM..TO, such as coupling.stiffness=1e3..1e5:log";
    let (name, values) = text.split_once('=').ok_or(EXAMPLE)?;
    let (values, is_log) = match values.split_once(':') {
        None => (values, false),
        Some((values, "log")) => (values, true),
        Some((_, other)) => return Err(format!("`:{other}` is not known, only `:log`")),
    };
    let [first, last] = ends(values, EXAMPLE)?;
    let (from, to) = (first.value, last.value);
    if is_log && from * to <= 0.0 {
        return Err(format!("no logarithmic range leads from {from} to {to}; leave `:log` out"));
    }
    Ok(Range { name: name.trim().to_owned(), from, to, is_log, amount: first })
}

/// Parses `from..to`; errors contain the example. A unit behind the last value applies to both, and
/// both must have the same dimension.
pub fn ends(values: &str, example: &str) -> Result<[Amount; 2], String> {
    let (from, to) = values.split_once("..").ok_or(example)?;
    let last = Amount::parse(to)?;
    let mut first = Amount::parse(from)?;
    if let (None, Some(unit)) = (&first.unit, &last.unit) {
        first = Amount::parse(&format!("{from} [{unit}]"))?;
    }
    match (&first.unit, &last.unit) {
        (Some(unit), None) => Err(format!("`{to}` has no unit, and `{from}` is in {unit}")),
        (Some(unit), Some(other)) if !is_alike(unit, other) => {
            Err(format!("{unit} and {other} have different dimensions"))
        }
        _ => Ok([first, last]),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_range_meets_its_ends_and_keeps_to_equal_steps_or_ratios() {
        let linear = range("a.b = 1..3").unwrap();
        let bits = |values: [f64; 3]| values.map(f64::to_bits);
        assert_eq!(bits([0, 1, 2].map(|index| linear.value(index, 3))), bits([1.0, 2.0, 3.0]));
        let ratios = range("a.b=1e2..1e6:log").unwrap();
        assert_eq!(ratios.value(2, 3).to_bits(), 1e6_f64.to_bits());
        assert!((ratios.value(1, 3) / 1e4 - 1.0).abs() < 1e-12);
    }

    #[cfg(feature = "derive")]
    #[test]
    fn a_range_may_be_in_a_unit() {
        for text in [
            "a.b=1..3 [kN]",
            "a.b=1 [kN]..3000 [N]",
            "a.b=1e3 [N]..3 [kN]:log",
            "a.b=1..3kN",
            "a.b=1kN..3000 N:log",
        ] {
            let range = range(text).unwrap();
            let off = (range.from - 1000.0).abs().max((range.to - 3000.0).abs());
            assert!(off < 1e-9, "{text}: {} to {}", range.from, range.to);
        }
        assert!(range("a.b=1 [kN]..3").unwrap_err().contains("no unit"));
        assert!(range("a.b=1kN..3").unwrap_err().contains("no unit"));
        assert!(range("a.b=1 [kN]..3 [m]").unwrap_err().contains("dimension"));
    }

    #[test]
    fn a_range_that_makes_no_sense_is_refused_with_the_reason() {
        for (bad, reason) in [
            ("a.b", "NAME=FROM..TO"),
            ("a.b=1", "NAME=FROM..TO"),
            ("a.b=1..x", "`x` is not a number"),
            ("a.b=1..inf", "not a finite number"),
            ("a.b=0..1:log", "no logarithmic"),
            ("a.b=1..2:lin", "only `:log`"),
        ] {
            let error = range(bad).unwrap_err();
            assert!(error.contains(reason), "{bad}: {error}");
        }
    }
}

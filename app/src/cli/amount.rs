//! Numbers on the command line, with or without a unit of measure: `23065.2`, `500ms`,
//! `1200 mm`, `18 kN m/rad`. A number without a unit is in SI units.

use machinist::Simulation;
use machinist_contract::{Quantity, Simulator};
use serde_json::{Map, Value};

use crate::failure::Failure;

/// Number in SI units.
#[derive(Debug, Clone, PartialEq)]
pub struct Amount {
    /// Value.
    pub value: f64,
    /// Unit in which the number was written; `None` stands for the unit of the quantity that it is
    /// for.
    pub unit: Option<String>,
}

impl Amount {
    /// Parses a number, with a unit behind it that may stand in brackets, as in specs.
    ///
    /// # Errors
    /// If it is not a finite number, or if its unit is unknown or cannot be read by this build.
    pub fn parse(text: &str) -> Result<Self, String> {
        let text = text.trim();
        if text.parse::<f64>().is_ok_and(|value| !value.is_finite()) {
            return Err(format!("`{text}` is not a finite number"));
        }
        let (number, unit) = split_number(text);
        let value: f64 = number.parse().map_err(|_| format!("`{text}` is not a number"))?;
        let unit = unit.trim();
        let in_brackets = unit.strip_prefix('[').and_then(|unit| unit.strip_suffix(']'));
        let unit = match in_brackets.unwrap_or(unit).trim() {
            "" if in_brackets.is_none() => None,
            unit => Some(unit),
        };
        let factor = unit.map_or(Ok(1.0), factor_of)?;
        // Exact for `ms` and the like, whose inverse factors are whole.
        let value = if factor < 1.0 { value / (1.0 / factor) } else { value * factor };
        if value.is_finite() {
            return Ok(Self { value, unit: unit.map(str::to_owned) });
        }
        Err(format!("`{text}` is not a finite number"))
    }

    /// Returns an error if the unit has another dimension than the wanted one.
    pub fn check(&self, name: &str, wanted: &str) -> Result<(), Failure> {
        let Some(unit) = &self.unit else { return Ok(()) };
        if is_alike(unit, wanted) {
            return Ok(());
        }
        let message = format!("{name} is in {wanted}, and not in {unit}");
        let help = other_capitals(unit, wanted).map_or_else(
            || format!("give it in {wanted}, or in a unit of that dimension"),
            |meant| format!("did you mean `{meant}`?"),
        );
        Err(Failure::input(message, help))
    }

    /// Returns an error if the unit has another dimension than the parameter or state of this name.
    pub fn check_of(&self, name: &str, run: &Simulation<'_>) -> Result<(), Failure> {
        // Unknown names are rejected where the value is set.
        let Some(quantity) = quantity_of(run.simulator(), name) else { return Ok(()) };
        self.check(name, quantity.unit)
    }
}

/// Splits a text behind the number at its start: digits with a sign, a decimal point and an exponent.
/// The exponent needs digits, so that the unit of `5eV` is `eV`.
pub fn split_number(text: &str) -> (&str, &str) {
    let bytes = text.as_bytes();
    let digits = |from: usize| {
        let rest = bytes.get(from..).unwrap_or_default();
        rest.iter().take_while(|byte| byte.is_ascii_digit()).count()
    };
    let is_one_of = |at: usize, known: &[u8]| bytes.get(at).is_some_and(|b| known.contains(b));
    let mut end = usize::from(is_one_of(0, b"+-"));
    end += digits(end);
    if is_one_of(end, b".") {
        end += 1 + digits(end + 1);
    }
    if is_one_of(end, b"eE") {
        let from = end + 1 + usize::from(is_one_of(end + 1, b"+-"));
        if digits(from) > 0 {
            end = from + digits(from);
        }
    }
    text.split_at(end)
}

/// Returns a parser of numbers in this unit or another one of its dimension. Results are in SI
/// units.
pub fn quantity(
    wanted: &'static str,
) -> impl Fn(&str) -> Result<f64, String> + Clone + Send + Sync + 'static {
    move |text| {
        let amount = Amount::parse(text)?;
        match amount.unit {
            Some(unit) if !is_alike(&unit, wanted) => {
                let meant = other_capitals(&unit, wanted);
                let meant =
                    meant.map_or_else(String::new, |meant| format!(": did you mean `{meant}`?"));
                Err(format!("`{text}` is in {unit}, but must be in {wanted}{meant}"))
            }
            _ => Ok(amount.value),
        }
    }
}

/// Parses a time: `5`, `5 s`, `500ms` or `2min`. The result is in seconds.
pub fn time(text: &str) -> Result<f64, String> {
    quantity("s")(text).map_err(|why| format!("{why}; write a time as 5, 500ms or \"2 min\""))
}

/// Parses a number that has no unit.
pub fn plain(text: &str) -> Result<f64, String> {
    let Amount { value, unit } = Amount::parse(text)?;
    unit.map_or(Ok(value), |unit| Err(format!("it has no unit, but `{text}` is in {unit}")))
}

/// Returns the parameter or state of a name.
pub fn quantity_of<'s>(simulator: &'s dyn Simulator<f64>, name: &str) -> Option<Quantity<'s>> {
    let shape = simulator.shape();
    let parameters = (0..shape.parameters).map(|index| simulator.parameter(index));
    let states = (0..shape.states()).map(|index| simulator.state(index));
    parameters.chain(states).find(|quantity| quantity.name == name)
}

#[cfg(feature = "derive")]
fn factor_of(unit: &str) -> Result<f64, String> {
    use machinist_codegen::spec::measure::Measure;

    let read = Measure::parse(unit);
    read.map(|measure| measure.factor.to_f64()).map_err(|error| {
        let help = if error.help.is_empty() { String::new() } else { format!(": {}", error.help) };
        format!("{}{help}", error.message)
    })
}

#[cfg(feature = "derive")]
pub fn is_alike(unit: &str, wanted: &str) -> bool {
    use machinist_codegen::spec::measure::Measure;

    match (Measure::parse(unit), Measure::parse(wanted)) {
        (Ok(unit), Ok(wanted)) => unit.unit.dimension == wanted.unit.dimension,
        _ => false,
    }
}

/// Returns the unit with other capitals that was probably meant, `s` for `S`.
#[cfg(feature = "derive")]
fn other_capitals(unit: &str, wanted: &str) -> Option<&'static str> {
    machinist_codegen::spec::measure::with_other_capitals(unit, wanted)
}

#[cfg(not(feature = "derive"))]
fn other_capitals(_: &str, _: &str) -> Option<&'static str> {
    None
}

/// Returns whether a frequency in this unit is a number of cycles for each time, as in Hz, and not
/// an angle, as in rad/s and rpm.
#[cfg(feature = "derive")]
pub fn is_in_cycles(unit: &str) -> bool {
    use machinist_codegen::spec::measure::Measure;

    Measure::parse(unit).is_ok_and(|measure| measure.unit.rad == 0)
}

#[cfg(not(feature = "derive"))]
pub fn is_in_cycles(_: &str) -> bool {
    false
}

/// Returns the conversion from one unit to another: `f x` or, for f < 1, `x / (1/f)`, which is
/// exact for `ms` to s. `None` if the dimensions differ or a unit is unknown.
#[cfg(feature = "derive")]
pub fn conversion(unit: &str, wanted: &str) -> Option<impl Fn(f64) -> f64 + use<>> {
    use machinist_codegen::spec::measure::Measure;

    let [unit, wanted] = [unit, wanted].map(|unit| Measure::parse(unit).ok());
    let (unit, wanted) = (unit?, wanted?);
    let [of, by] = [&unit, &wanted].map(|measure| measure.factor.to_f64());
    let up = if of < by { by / of } else { 1.0 };
    let down = if of < by { 1.0 } else { of / by };
    (unit.unit.dimension == wanted.unit.dimension).then_some(move |value: f64| value * down / up)
}

#[cfg(not(feature = "derive"))]
pub fn conversion(unit: &str, wanted: &str) -> Option<impl Fn(f64) -> f64 + use<>> {
    (unit == wanted).then_some(|value: f64| value)
}

/// Units are read by the generator. Taking `5 [mm]` for 5 would be silently wrong.
#[cfg(not(feature = "derive"))]
fn factor_of(unit: &str) -> Result<f64, String> {
    Err(format!(
        "this build of the program cannot read the unit `{unit}`; write the number in SI units \
         without its unit, or build the program with its feature `derive`"
    ))
}

#[cfg(not(feature = "derive"))]
pub fn is_alike(_: &str, _: &str) -> bool {
    false
}

/// Converts a number in SI units to a unit.
#[cfg(feature = "derive")]
pub fn in_unit(value: f64, unit: &str) -> f64 {
    use machinist_codegen::spec::measure::Measure;

    Measure::parse(unit).map_or(value, |measure| value / measure.factor.to_f64())
}

#[cfg(not(feature = "derive"))]
pub fn in_unit(value: f64, _: &str) -> f64 {
    value
}

/// Parses `name=value`, as `--set` takes it.
pub fn assignment(text: &str) -> Result<(String, Amount), String> {
    let (name, value) =
        text.split_once('=').ok_or("write it as NAME=VALUE, such as coupling.stiffness=23065.2")?;
    Ok((name.trim().to_owned(), Amount::parse(value)?))
}

/// Returns the values as JSON, for the settings recorded in tables.
pub fn as_json(set: &[(String, Amount)]) -> Map<String, Value> {
    set.iter().map(|(name, amount)| (name.clone(), amount.value.into())).collect()
}

/// Returns names with their values in SI units.
pub fn in_si(set: &[(String, Amount)]) -> Vec<(String, f64)> {
    set.iter().map(|(name, amount)| (name.clone(), amount.value)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_assignment_has_a_name_and_a_finite_number() {
        let amount = Amount { value: 2000.0, unit: None };
        assert_eq!(assignment("a.b = 2e3"), Ok(("a.b".to_owned(), amount)));
        for bad in ["a.b", "a.b=", "a.b=x", "a.b=inf", "a.b=NaN", "a.b=[m]", "a.b=1 [m", "a.b=1 []"]
        {
            assert!(assignment(bad).is_err(), "{bad}");
        }
    }

    #[cfg(feature = "derive")]
    #[test]
    fn numbers_in_units_are_in_si_units() {
        for (text, value) in [
            ("18 [kN m/rad]", 18e3),
            ("-2.5[mm]", -2.5e-3),
            ("90 [deg]", std::f64::consts::FRAC_PI_2),
            ("500ms", 0.5),
            ("1e3 mm", 1.0),
            ("-.5e+1mm", -5e-3),
            ("18 kN m/rad", 18e3),
            ("2.min", 120.0),
        ] {
            assert!((Amount::parse(text).unwrap().value / value - 1.0).abs() < 1e-15, "{text}");
        }
        for bad in ["1 [parsec]", "1parsec", "1e-1parsec"] {
            assert!(Amount::parse(bad).unwrap_err().contains("parsec"), "{bad}");
        }
        assert!(Amount::parse("1e m").unwrap_err().contains("\"e\""), "an exponent has digits");
        let amount = Amount::parse("18 [kN m/rad]").unwrap();
        assert!(amount.check("k", "N m/rad").is_ok() && amount.check("k", "N/m").is_err());
    }

    #[cfg(feature = "derive")]
    #[test]
    fn options_take_the_dimension_that_they_need() {
        assert_eq!(time("2min"), Ok(120.0));
        assert_eq!(time("100us"), Ok(1e-4));
        assert_eq!(time("1.5"), Ok(1.5));
        for (bad, reason) in [
            ("5 m", "must be in s"),
            ("", "not a number"),
            ("soon", "500ms"),
            ("nan", "finite"),
            ("1e308 d", "finite"),
        ] {
            assert!(time(bad).unwrap_err().contains(reason), "{bad}: {:?}", time(bad));
        }
        assert_eq!(plain("1e-6"), Ok(1e-6));
        assert!(plain("1e-6 s").unwrap_err().contains("has no unit"));
    }

    #[cfg(not(feature = "derive"))]
    #[test]
    fn units_are_refused_by_what_cannot_read_them() {
        assert!(Amount::parse("18 [kN m/rad]").unwrap_err().contains("derive"));
    }
}

//! Units of measure, as written in specs.
//!
//! All computations use coherent SI units, which have factor 1. Other units have a factor, an
//! exact number times a power of pi. They are allowed where a number is converted to SI on
//! reading (`5 [mm]`, a parameter's value, a column of a table), and at outputs of scenes, which
//! are shown in them.
//!
//! Excluded: offsets (degrees Celsius).

use std::ops::Range;

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One as _, Pow, ToPrimitive as _};

use super::dimension::{Dimension, Unit};

mod spelling;

pub use spelling::{in_brackets, with_other_capitals};

/// Limit of exponents in a unit of measure.
const MAX_EXPONENT: i32 = 20;
/// Limit of nested parentheses in a unit of measure.
const MAX_NESTING: usize = 20;
/// Maximum number of bits of a factor.
const MAX_BITS: u64 = 900;

/// Symbols of coherent units, with exponents of the base units and of rad.
const COHERENT: &[(&str, [i32; 7], i32)] = &[
    ("kg", [1, 0, 0, 0, 0, 0, 0], 0),
    ("m", [0, 1, 0, 0, 0, 0, 0], 0),
    ("s", [0, 0, 1, 0, 0, 0, 0], 0),
    ("A", [0, 0, 0, 1, 0, 0, 0], 0),
    ("K", [0, 0, 0, 0, 1, 0, 0], 0),
    ("mol", [0, 0, 0, 0, 0, 1, 0], 0),
    ("cd", [0, 0, 0, 0, 0, 0, 1], 0),
    ("rad", [0; 7], 1),
    ("sr", [0; 7], 0),
    ("Hz", [0, 0, -1, 0, 0, 0, 0], 0),
    ("N", [1, 1, -2, 0, 0, 0, 0], 0),
    ("J", [1, 2, -2, 0, 0, 0, 0], 0),
    ("W", [1, 2, -3, 0, 0, 0, 0], 0),
    ("Pa", [1, -1, -2, 0, 0, 0, 0], 0),
    ("V", [1, 2, -3, -1, 0, 0, 0], 0),
    ("ohm", [1, 2, -3, -2, 0, 0, 0], 0),
    ("F", [-1, -2, 4, 2, 0, 0, 0], 0),
    ("H", [1, 2, -2, -2, 0, 0, 0], 0),
    ("S", [-1, -2, 3, 2, 0, 0, 0], 0),
    ("Wb", [1, 2, -2, -1, 0, 0, 0], 0),
    ("T", [1, 0, -2, -1, 0, 0, 0], 0),
    ("C", [0, 0, 1, 1, 0, 0, 0], 0),
];

/// Symbols of other units: (symbol, numerator, denominator, power of pi, coherent unit).
const FACTORED: &[(&str, i64, i64, i32, &str)] = &[
    ("um", 1, 1_000_000, 0, "m"),
    ("mm", 1, 1000, 0, "m"),
    ("cm", 1, 100, 0, "m"),
    ("dm", 1, 10, 0, "m"),
    ("km", 1000, 1, 0, "m"),
    ("inch", 127, 5000, 0, "m"),
    ("l", 1, 1000, 0, "m^3"),
    ("ml", 1, 1_000_000, 0, "m^3"),
    ("us", 1, 1_000_000, 0, "s"),
    ("ms", 1, 1000, 0, "s"),
    ("min", 60, 1, 0, "s"),
    ("h", 3600, 1, 0, "s"),
    ("d", 86400, 1, 0, "s"),
    ("kHz", 1000, 1, 0, "Hz"),
    ("MHz", 1_000_000, 1, 0, "Hz"),
    ("GHz", 1_000_000_000, 1, 0, "Hz"),
    ("urad", 1, 1_000_000, 0, "rad"),
    ("mrad", 1, 1000, 0, "rad"),
    ("deg", 1, 180, 1, "rad"),
    ("rev", 2, 1, 1, "rad"),
    ("rpm", 1, 30, 1, "rad/s"),
    ("ug", 1, 1_000_000_000, 0, "kg"),
    ("mg", 1, 1_000_000, 0, "kg"),
    ("g", 1, 1000, 0, "kg"),
    ("t", 1000, 1, 0, "kg"),
    ("uN", 1, 1_000_000, 0, "N"),
    ("mN", 1, 1000, 0, "N"),
    ("kN", 1000, 1, 0, "N"),
    ("MN", 1_000_000, 1, 0, "N"),
    ("mJ", 1, 1000, 0, "J"),
    ("kJ", 1000, 1, 0, "J"),
    ("MJ", 1_000_000, 1, 0, "J"),
    ("kWh", 3_600_000, 1, 0, "J"),
    ("uW", 1, 1_000_000, 0, "W"),
    ("mW", 1, 1000, 0, "W"),
    ("kW", 1000, 1, 0, "W"),
    ("MW", 1_000_000, 1, 0, "W"),
    ("GW", 1_000_000_000, 1, 0, "W"),
    ("hPa", 100, 1, 0, "Pa"),
    ("kPa", 1000, 1, 0, "Pa"),
    ("MPa", 1_000_000, 1, 0, "Pa"),
    ("GPa", 1_000_000_000, 1, 0, "Pa"),
    ("mPa", 1, 1000, 0, "Pa"),
    ("bar", 100_000, 1, 0, "Pa"),
    ("mbar", 100, 1, 0, "Pa"),
    ("uV", 1, 1_000_000, 0, "V"),
    ("mV", 1, 1000, 0, "V"),
    ("kV", 1000, 1, 0, "V"),
    ("uA", 1, 1_000_000, 0, "A"),
    ("mA", 1, 1000, 0, "A"),
    ("kA", 1000, 1, 0, "A"),
    ("uohm", 1, 1_000_000, 0, "ohm"),
    ("mohm", 1, 1000, 0, "ohm"),
    ("kohm", 1000, 1, 0, "ohm"),
    ("Mohm", 1_000_000, 1, 0, "ohm"),
    ("nH", 1, 1_000_000_000, 0, "H"),
    ("uH", 1, 1_000_000, 0, "H"),
    ("mH", 1, 1000, 0, "H"),
    ("pF", 1, 1_000_000_000_000, 0, "F"),
    ("nF", 1, 1_000_000_000, 0, "F"),
    ("uF", 1, 1_000_000, 0, "F"),
    ("mF", 1, 1000, 0, "F"),
    ("mS", 1, 1000, 0, "S"),
    ("mT", 1, 1000, 0, "T"),
    ("mWb", 1, 1000, 0, "Wb"),
    ("mC", 1, 1000, 0, "C"),
    ("mK", 1, 1000, 0, "K"),
    ("mmol", 1, 1000, 0, "mol"),
];

/// Symbols of temperatures with an offset, which are not units here.
const TEMPERATURES: [&str; 2] = ["degC", "degF"];

/// Iterates over the symbols of all units of measure, those without a factor first.
pub fn symbols() -> impl Iterator<Item = &'static str> {
    COHERENT.iter().map(|(name, ..)| *name).chain(FACTORED.iter().map(|(name, ..)| *name))
}

/// A unit of measure: a coherent unit and a factor.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Measure {
    /// The coherent unit.
    pub unit: Unit,
    /// The factor to the coherent unit.
    pub factor: Factor,
}

/// An exact number times a power of pi.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Factor {
    /// The number, above 0.
    pub ratio: BigRational,
    /// The power of pi.
    pub pis: i32,
}

impl Factor {
    /// Returns the factor 1.
    #[must_use]
    pub fn one() -> Factor {
        Factor { ratio: BigRational::one(), pis: 0 }
    }

    /// Reports whether the factor is 1.
    #[must_use]
    pub fn is_one(&self) -> bool {
        self.pis == 0 && self.ratio.is_one()
    }

    /// Returns the factor, rounded.
    #[must_use]
    pub fn to_f64(&self) -> f64 {
        self.ratio.to_f64().unwrap_or(f64::NAN) * std::f64::consts::PI.powi(self.pis)
    }

    /// Returns the factor times a power of another; `None` if it is too large.
    fn times(&self, other: &Factor, exponent: i32) -> Option<Factor> {
        let bits = |number: &BigRational| number.numer().bits() + number.denom().bits();
        let grown = bits(&other.ratio).checked_mul(u64::from(exponent.unsigned_abs()))?;
        if grown.checked_add(bits(&self.ratio))? > MAX_BITS {
            return None;
        }
        let ratio = &self.ratio * Pow::pow(&other.ratio, exponent);
        let pis = self.pis.checked_add(other.pis.checked_mul(exponent)?)?;
        Some(Factor { ratio, pis })
    }
}

impl Measure {
    /// Reads a unit of measure: `N m/rad`, `kg m^2`, `W/(m K)`, `1`, `rpm`, `kN/mm`.
    ///
    /// # Errors
    /// The wrong bytes of `text`, and the reason.
    pub fn parse(text: &str) -> Result<Measure, UnitError> {
        Self::read(text).map_err(|error| error.with_spelling(text))
    }

    /// Reads the same, without looking for another spelling.
    fn read(text: &str) -> Result<Measure, UnitError> {
        Reader { text, at: 0, factored: None }.whole()
    }

    /// Reads a coherent unit of measure.
    ///
    /// # Errors
    /// As [`Measure::parse`], and at the first symbol that has a factor.
    pub fn coherent(text: &str) -> Result<Unit, UnitError> {
        let mut reader = Reader { text, at: 0, factored: None };
        let measure = reader.whole().map_err(|error| error.with_spelling(text))?;
        let Some(range) = reader.factored else { return Ok(measure.unit) };
        let symbol = &text[range.clone()];
        let instead = FACTORED.iter().find(|(known, ..)| *known == symbol);
        let instead = instead.map_or("", |(.., coherent)| coherent);
        Err(UnitError {
            message: format!("{symbol:?} is not a coherent SI unit, which is required here"),
            help: format!(
                "declare it in {instead}; numbers ({:?}), values of parameters, columns of tables \
                 and outputs of scenes may be in {symbol}",
                format!("5 [{symbol}]")
            ),
            range,
        })
    }

    /// Reads a coherent unit of measure, with factor 1.
    ///
    /// # Errors
    /// As [`Measure::coherent`].
    pub fn parse_coherent(text: &str) -> Result<Measure, UnitError> {
        Ok(Measure { unit: Measure::coherent(text)?, factor: Factor::one() })
    }

    fn times(&self, other: &Measure, exponent: i32) -> Option<Measure> {
        let unit = self.unit.times(other.unit, exponent)?;
        Some(Measure { unit, factor: self.factor.times(&other.factor, exponent)? })
    }

    fn one() -> Measure {
        Measure { unit: Unit::default(), factor: Factor::one() }
    }
}

/// Replaces units that have a factor by coherent ones: `N mm/rpm` becomes `N m/(rad/s)`.
#[must_use]
pub fn in_coherent_units(text: &str) -> String {
    let mut written = String::new();
    let mut rest = text;
    while !rest.is_empty() {
        let length = rest.find(|c: char| !c.is_ascii_alphanumeric()).unwrap_or(rest.len());
        let (word, after) = rest.split_at(length);
        match FACTORED.iter().find(|(symbol, ..)| *symbol == word) {
            Some((.., coherent)) if coherent.contains(['/', '^']) => {
                written.extend(["(", coherent, ")"]);
            }
            Some((.., coherent)) => written.push_str(coherent),
            None => written.push_str(word),
        }
        let next = after.find(|c: char| c.is_ascii_alphanumeric()).unwrap_or(after.len());
        written.push_str(&after[..next]);
        rest = &after[next..];
    }
    // A single replaced unit needs no parentheses.
    match FACTORED.iter().find(|(symbol, ..)| *symbol == text.trim()) {
        Some((.., coherent)) => (*coherent).to_owned(),
        None => written,
    }
}

/// Returns the dimension of a coherent unit by its symbol.
pub(super) fn dimension_of(symbol: &str) -> Option<Dimension> {
    let found = COHERENT.iter().find(|(name, ..)| *name == symbol);
    found.map(|(_, exponents, _)| Dimension::whole(*exponents))
}

/// A mistake in a unit of measure.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct UnitError {
    /// The reason, without a full stop.
    pub message: String,
    /// Hint for mending it; may be empty.
    pub help: String,
    /// The bytes of the text that are wrong.
    pub range: Range<usize>,
}

impl UnitError {
    /// Suggests the unit that the whole text was probably meant for, if its wrong symbol alone has no
    /// suggestion or the text has characters that units do not have.
    fn with_spelling(self, text: &str) -> Self {
        let is_vague = self.help.is_empty() || self.help.starts_with("known are");
        if text.is_ascii() && !is_vague {
            return self;
        }
        match spelling::help_with(text) {
            Some(help) => UnitError { help, ..self },
            None => self,
        }
    }
}

struct Reader<'a> {
    text: &'a str,
    at: usize,
    /// Range of the first symbol that has a factor.
    factored: Option<Range<usize>>,
}

impl Reader<'_> {
    fn whole(&mut self) -> Result<Measure, UnitError> {
        let measure = self.quotient(0)?;
        match self.peek() {
            None => Ok(measure),
            Some(c) => Err(self.error(format!("{c:?} is not expected here"))),
        }
    }

    /// Reads product { "/" product }, where each product divides.
    fn quotient(&mut self, depth: usize) -> Result<Measure, UnitError> {
        if depth > MAX_NESTING {
            return Err(self.error(format!("parentheses nest deeper than {MAX_NESTING}")));
        }
        let mut unit = self.product(depth)?;
        while self.peek() == Some('/') {
            self.at += 1;
            let divisor = self.product(depth)?;
            unit = self.bounded(unit.times(&divisor, -1))?;
        }
        Ok(unit)
    }

    /// Reads factor { \["*"\] factor }.
    fn product(&mut self, depth: usize) -> Result<Measure, UnitError> {
        let mut unit = self.factor(depth)?;
        loop {
            match self.peek() {
                Some('*') => self.at += 1,
                Some(c) if c.is_ascii_alphanumeric() || c == '(' => {}
                _ => return Ok(unit),
            }
            let factor = self.factor(depth)?;
            unit = self.bounded(unit.times(&factor, 1))?;
        }
    }

    /// Reads ("1" | symbol | "(" quotient ")") \["^" integer | "^(" integer "/" integer ")"\].
    fn factor(&mut self, depth: usize) -> Result<Measure, UnitError> {
        let unit = match self.peek() {
            Some('(') => {
                self.at += 1;
                let unit = self.quotient(depth + 1)?;
                if self.peek() != Some(')') {
                    return Err(self.error("a closing parenthesis is missing".to_owned()));
                }
                self.at += 1;
                unit
            }
            Some(c) if c.is_ascii_digit() => self.one()?,
            Some(c) if c.is_ascii_alphabetic() => self.symbol()?,
            Some(c) => return Err(self.error(format!("{c:?} is not expected here"))),
            None => return Err(self.error("a unit symbol is missing".to_owned())),
        };
        if self.peek() != Some('^') {
            return Ok(unit);
        }
        self.at += 1;
        if self.peek() == Some('(') {
            return self.root(&unit);
        }
        let exponent = self.exponent()?;
        self.bounded(Measure::one().times(&unit, exponent))
    }

    /// Reads "(" integer "/" integer ")", of a unit without a factor.
    fn root(&mut self, of: &Measure) -> Result<Measure, UnitError> {
        let start = self.at;
        self.at += 1;
        let numerator = self.exponent()?;
        let mut denominator = 1;
        if self.peek() == Some('/') {
            self.at += 1;
            denominator = self.exponent()?;
        }
        if self.peek() != Some(')') {
            return Err(self.error("a closing parenthesis is missing".to_owned()));
        }
        self.at += 1;
        let raised = of.unit.power(numerator, denominator).filter(|_| of.factor.is_one());
        raised.map(|unit| Measure { unit, ..Measure::one() }).ok_or_else(|| UnitError {
            message: "this power of the unit does not exist".to_owned(),
            help: "fractional exponents must be multiples of 1/840, on coherent units".to_owned(),
            range: start..self.at,
        })
    }

    fn one(&mut self) -> Result<Measure, UnitError> {
        let range = self.word(|c| c.is_ascii_digit() || c == '.');
        if &self.text[range.clone()] == "1" {
            return Ok(Measure::one());
        }
        let message = "the only number allowed in a unit is 1".to_owned();
        Err(UnitError {
            message,
            help: "put the factor into the number before the unit".to_owned(),
            range,
        })
    }

    fn symbol(&mut self) -> Result<Measure, UnitError> {
        let range = self.word(|c| c.is_ascii_alphanumeric());
        let symbol = &self.text[range.clone()];
        if let Some((_, exponents, rad)) = COHERENT.iter().find(|(name, ..)| *name == symbol) {
            let dimension = Dimension::whole(*exponents);
            let unit = Unit { dimension, rad: 2 * rad };
            return Ok(Measure { unit, ..Measure::one() });
        }
        let known = FACTORED.iter().find(|(name, ..)| *name == symbol);
        if let Some((_, numerator, denominator, pis, coherent)) = known {
            self.factored.get_or_insert(range);
            let [numerator, denominator] = [*numerator, *denominator].map(BigInt::from);
            let own = Factor { ratio: BigRational::new(numerator, denominator), pis: *pis };
            let measure = Measure::read(coherent)?;
            return Ok(Measure { factor: own, ..measure });
        }
        let help = if TEMPERATURES.contains(&symbol) {
            "a temperature must be in K: offsets are not supported".to_owned()
        } else {
            spelling::meant(symbol)
        };
        Err(UnitError { message: format!("unknown unit of measure {symbol:?}"), help, range })
    }

    fn exponent(&mut self) -> Result<i32, UnitError> {
        self.peek();
        let start = self.at;
        let negative = self.text[self.at..].starts_with('-');
        self.at += usize::from(negative);
        let digits = self.word(|c| c.is_ascii_digit());
        let value = self.text[digits].parse::<i32>().ok().filter(|e| *e <= MAX_EXPONENT);
        match value {
            Some(value) => Ok(if negative { -value } else { value }),
            None => Err(UnitError {
                message: format!("an exponent is an integer of at most {MAX_EXPONENT}"),
                help: String::new(),
                range: start..self.at.max(start + 1).min(self.text.len()),
            }),
        }
    }

    fn word(&mut self, belongs: impl Fn(char) -> bool) -> Range<usize> {
        let rest = &self.text[self.at..];
        let length = rest.find(|c| !belongs(c)).unwrap_or(rest.len());
        let range = self.at..self.at + length;
        self.at += length;
        range
    }

    /// Returns the next character that is not a space.
    fn peek(&mut self) -> Option<char> {
        let rest = &self.text[self.at..];
        self.at += rest.len() - rest.trim_start_matches(' ').len();
        self.text[self.at..].chars().next()
    }

    fn bounded(&self, measure: Option<Measure>) -> Result<Measure, UnitError> {
        measure.ok_or_else(|| self.error("exponents are too large".to_owned()))
    }

    fn error(&self, message: String) -> UnitError {
        let length = self.text[self.at..].chars().next().map_or(0, char::len_utf8);
        UnitError { message, help: String::new(), range: self.at..self.at + length }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn unit(text: &str) -> Unit {
        Measure::coherent(text).unwrap_or_else(|error| panic!("{text}: {error:?}"))
    }
    fn factor(text: &str) -> f64 {
        Measure::parse(text).unwrap_or_else(|error| panic!("{text}: {error:?}")).factor.to_f64()
    }

    #[test]
    fn a_newton_metre_is_a_joule() {
        assert_eq!(unit("N m"), unit("J"));
        assert_eq!(unit("N m").dimension, Dimension::ENERGY);
    }

    #[test]
    fn a_stroke_divides_by_everything_up_to_the_next() {
        assert_eq!(unit("J/kg K"), unit("J kg^-1 K^-1"));
        assert_eq!(unit("J/kg/K"), unit("J/(kg K)"));
        assert_eq!(unit("N*m*s/rad").rad, -2);
        assert_eq!(unit("1/s").dimension, unit("Hz").dimension);
        assert_eq!(unit("(kg m)^2/s").dimension, unit("kg^2 m^2/s").dimension);
    }

    #[test]
    fn electrical_units_agree_with_mechanical_ones() {
        assert_eq!(unit("V A"), unit("W"));
        assert_eq!(unit("ohm A"), unit("V"));
        assert_eq!(unit("Wb"), unit("V s"));
        assert_eq!(unit("H A"), unit("Wb"));
        assert_eq!(unit("F V"), unit("C"));
        assert_eq!(unit("S V"), unit("A"));
        assert_eq!(unit("T m^2"), unit("Wb"));
        assert_eq!(unit("C").dimension, Dimension::CHARGE);
        assert_eq!(unit("Wb").dimension, Dimension::FLUX);
    }

    #[test]
    fn coherent_units_are_asked_for_where_nothing_is_converted() {
        for text in
            ["mm", "deg", "kN", "min", "rpm", "2 m", "", "m^", "m^99", "m)", "(m", "m;", "é"]
        {
            assert!(Measure::coherent(text).is_err(), "{text}");
        }
        assert_eq!(Measure::coherent("N mm").unwrap_err().range, 2..4);
    }

    #[test]
    fn prefixes_are_powers_of_ten() {
        let prefixes = [
            ('p', -12),
            ('n', -9),
            ('u', -6),
            ('m', -3),
            ('c', -2),
            ('d', -1),
            ('h', 2),
            ('k', 3),
            ('M', 6),
            ('G', 9),
        ];
        let mut prefixed = 0;
        for (symbol, ..) in
            FACTORED.iter().filter(|(symbol, ..)| !["min", "cd", "d"].contains(symbol))
        {
            let (first, rest) = symbol.split_at(1);
            let Ok(base) = Measure::parse(rest) else { continue };
            let prefix = prefixes.iter().find(|(letter, _)| first.starts_with(*letter));
            let Some((_, exponent)) = prefix else { continue };
            let wanted = 10f64.powi(*exponent) * base.factor.to_f64();
            assert!((factor(symbol) / wanted - 1.0).abs() < 1e-14, "{symbol}");
            assert_eq!(Measure::parse(symbol).expect("known").unit, base.unit, "{symbol}");
            prefixed += 1;
        }
        assert!(prefixed > 50, "{prefixed}");
    }

    #[test]
    fn factors_are_those_of_the_units() {
        let pi = std::f64::consts::PI;
        let known = [
            ("m", 1.0),
            ("mm", 1e-3),
            ("mm^2", 1e-6),
            ("N/mm", 1e3),
            ("km/h", 1.0 / 3.6),
            ("rpm", pi / 30.0),
            ("1/min", 1.0 / 60.0),
            ("deg", pi / 180.0),
            ("rev/min", pi / 30.0),
            ("V/(rev/s)", 0.5 / pi),
            ("kN m/deg", 180e3 / pi),
            ("bar l", 100.0),
            ("kWh", 3.6e6),
            ("m^(3/2)", 1.0),
            ("g mm^2", 1e-9),
        ];
        for (text, wanted) in known {
            assert!((factor(text) / wanted - 1.0).abs() < 1e-15, "{text}: {}", factor(text));
        }
        for (_, _, _, _, coherent) in FACTORED {
            assert!(Measure::coherent(coherent).is_ok(), "{coherent}");
        }
        assert!(Measure::parse("((km/m)^20)^20").is_err(), "beyond what a number can hold");
        for text in ["degC", "mm^(1/2)", "m^(1/0)", "m^(1/9)", "m^(1/", "m^(1/2", "m^()"] {
            assert!(Measure::parse(text).is_err(), "{text}");
        }
    }

    #[test]
    fn the_coherent_text_measures_the_same() {
        for (text, coherent) in [
            ("rpm", "rad/s"),
            ("N mm/rpm", "N m/(rad/s)"),
            ("kN/mm^2", "N/m^2"),
            ("1/l", "1/(m^3)"),
            ("kg m^2", "kg m^2"),
        ] {
            assert_eq!(in_coherent_units(text), coherent);
            let [measure, same] = [text, coherent].map(|text| Measure::parse(text).unwrap());
            assert_eq!(measure.unit, same.unit, "{text}");
            assert!(same.factor.is_one());
        }
    }
}

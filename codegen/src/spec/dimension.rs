//! Units of measure and their dimensions: exponents of the SI base units.
//!
//! Excluded: factors (only coherent units are known, so 1 of any unit is 1 of its
//! base units) and offsets.
//!
//! # Angles
//! rad has no dimension, so plain dimensions do not tell a spring's energy
//! `c*phi^2/2` from its torque `c*phi`, with c in N m/rad. [`Unit`] therefore
//! keeps the exponent of rad beside the dimension, and [`Angular`] follows it
//! through products and powers. Demanding equal exponents of all terms would
//! refuse sound specs: `c*phi^2/2` has rad^1, `J*omega^2/2` rad^2,
//! `m*g*l*(1 - cos(phi))` rad^0. One rule is enough to catch a missing square and
//! lets those pass: **a term of an energy is a torque if it holds a stiffness (a
//! factor whose unit is J/rad^p) times an odd power, at most p, of angles, and
//! nothing else that moves.** A pitch in m/rad is no stiffness, and a stiffness
//! times (1 - cos(n phi)) holds no power of an angle.

use std::fmt;
use std::ops::Range;

/// Names of the base units, in the order of [`Dimension`].
const BASES: [&str; 7] = ["kg", "m", "s", "A", "K", "mol", "cd"];
/// Exponents, in halves, beyond which a dimension is refused.
const MAX_HALVES: i32 = 1 << 16;
/// Exponents beyond which a unit of measure is refused.
const MAX_EXPONENT: i32 = 20;
/// Nested parentheses beyond which a unit of measure is refused.
const MAX_NESTING: usize = 20;

/// Exponents of kg, m, s, A, K, mol, cd, counted in halves.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Dimension([i32; 7]);

/// Dimension of a unit of measure and its exponent of rad.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Unit {
    /// Exponents of the base units.
    pub dimension: Dimension,
    /// Exponent of rad, counted in halves; it is no part of the dimension.
    pub rad: i32,
}

/// The symbols a unit of measure may hold, with twice their exponents.
const SYMBOLS: &[(&str, [i32; 7], i32)] = &[
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

/// Symbols that people write and that would need a factor.
const FACTORED: &[&str] = &[
    "min", "h", "d", "deg", "mm", "cm", "km", "um", "g", "t", "kN", "MN", "kW", "MW", "kJ", "MJ",
    "kPa", "MPa", "GPa", "bar", "kHz", "MHz", "kV", "mA", "mH", "uF", "ms", "us", "rpm", "rev",
    "l", "degC", "turn",
];

impl Dimension {
    /// The dimension of a pure number.
    pub const ONE: Dimension = Dimension([0; 7]);
    /// Joule.
    pub const ENERGY: Dimension = Dimension([2, 4, -4, 0, 0, 0, 0]);
    /// Watt.
    pub const POWER: Dimension = Dimension([2, 4, -6, 0, 0, 0, 0]);
    /// Second.
    pub const TIME: Dimension = Dimension([0, 0, 2, 0, 0, 0, 0]);
    /// Metre.
    pub const LENGTH: Dimension = Dimension([0, 2, 0, 0, 0, 0, 0]);
    /// Coulomb.
    pub const CHARGE: Dimension = Dimension([0, 0, 2, 2, 0, 0, 0]);
    /// Weber, volt second.
    pub const FLUX: Dimension = Dimension([2, 4, -4, -2, 0, 0, 0]);

    /// Dimension of a product; `None` if an exponent is beyond all reason.
    #[must_use]
    pub fn times(self, other: Dimension) -> Option<Dimension> {
        let mut product = self;
        for (a, b) in product.0.iter_mut().zip(other.0) {
            *a = bounded(a.checked_add(b)?)?;
        }
        Some(product)
    }

    /// Dimension of the power `numerator/denominator`; `None` if an exponent is
    /// neither an integer nor a half, or beyond all reason.
    #[must_use]
    pub fn power(self, numerator: i32, denominator: i32) -> Option<Dimension> {
        let mut power = self;
        for exponent in &mut power.0 {
            let product = exponent.checked_mul(numerator)?;
            if product.checked_rem(denominator)? != 0 {
                return None;
            }
            *exponent = bounded(product / denominator)?;
        }
        Some(power)
    }

    /// Dimension of a quotient; `None` as for [`Dimension::times`].
    #[must_use]
    pub fn over(self, other: Dimension) -> Option<Dimension> {
        self.times(other.power(-1, 1)?)
    }

    /// As a unit of measure: `N`, `kg m`, `1`.
    #[must_use]
    pub fn as_unit(self) -> String {
        let text = self.to_string();
        match text.split_once(" = ") {
            Some((name, _)) => name.to_owned(),
            None if self == Dimension::ONE => "1".to_owned(),
            None => text,
        }
    }

    /// The base units alone: `kg m^2/s^2`.
    fn base_units(self) -> String {
        let part = |sign: i32| {
            let factors = BASES.iter().zip(self.0).filter(|(_, e)| e * sign > 0);
            let factors = factors.map(|(base, e)| match (e * sign, e * sign % 2) {
                (2, _) => (*base).to_owned(),
                (e, 0) => format!("{base}^{}", e / 2),
                (e, _) => format!("{base}^({e}/2)"),
            });
            factors.collect::<Vec<_>>()
        };
        let (above, below) = (part(1), part(-1));
        let numerator = if above.is_empty() { "1".to_owned() } else { above.join(" ") };
        match below.len() {
            0 => numerator,
            1 => format!("{numerator}/{}", below[0]),
            _ => format!("{numerator}/({})", below.join(" ")),
        }
    }
}

fn bounded(halves: i32) -> Option<i32> {
    (halves.abs() <= MAX_HALVES).then_some(halves)
}

impl fmt::Display for Dimension {
    /// `J = kg m^2/s^2`, or the base units alone, or `a pure number`.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        const NAMED: [&str; 10] = ["N", "J", "W", "Pa", "V", "ohm", "F", "H", "Wb", "C"];
        if *self == Dimension::ONE {
            return f.write_str("a pure number");
        }
        let named = SYMBOLS.iter().find(|(name, exponents, _)| {
            NAMED.contains(name) && exponents.map(|e| 2 * e) == self.0
        });
        match named {
            Some((name, ..)) => write!(f, "{name} = {}", self.base_units()),
            None => f.write_str(&self.base_units()),
        }
    }
}

impl Unit {
    /// The unit per second.
    ///
    /// # Errors
    /// `None` if an exponent is beyond all reason.
    #[must_use]
    pub fn per_second(self, order: i32) -> Option<Unit> {
        let dimension = self.dimension.over(Dimension::TIME.power(order, 1)?)?;
        Some(Unit { dimension, rad: self.rad })
    }

    /// Reads a unit of measure: `N m/rad`, `kg m^2`, `W/(m K)`, `1`.
    ///
    /// # Errors
    /// The bytes of `text` that are wrong, and why.
    pub fn parse(text: &str) -> Result<Unit, UnitError> {
        let mut reader = UnitReader { text, at: 0 };
        let unit = reader.quotient(0)?;
        match reader.peek() {
            None => Ok(unit),
            Some(c) => Err(reader.error(format!("{c:?} is not expected here"))),
        }
    }

    fn times(self, other: Unit, exponent: i32) -> Option<Unit> {
        let dimension = self.dimension.times(other.dimension.power(exponent, 1)?)?;
        let rad = bounded(self.rad.checked_add(other.rad.checked_mul(exponent)?)?)?;
        Some(Unit { dimension, rad })
    }
}

/// What is wrong with a unit of measure.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct UnitError {
    /// The reason, without a full stop.
    pub message: String,
    /// How to mend it; may be empty.
    pub help: String,
    /// Bytes of the text.
    pub range: Range<usize>,
}

struct UnitReader<'a> {
    text: &'a str,
    at: usize,
}

impl UnitReader<'_> {
    /// product { "/" product }, where each product divides.
    fn quotient(&mut self, depth: usize) -> Result<Unit, UnitError> {
        if depth > MAX_NESTING {
            return Err(self.error(format!("parentheses nest deeper than {MAX_NESTING}")));
        }
        let mut unit = self.product(depth)?;
        while self.peek() == Some('/') {
            self.at += 1;
            let divisor = self.product(depth)?;
            unit = self.bounded(unit.times(divisor, -1))?;
        }
        Ok(unit)
    }

    /// factor { \["*"\] factor }.
    fn product(&mut self, depth: usize) -> Result<Unit, UnitError> {
        let mut unit = self.factor(depth)?;
        loop {
            match self.peek() {
                Some('*') => self.at += 1,
                Some(c) if c.is_ascii_alphanumeric() || c == '(' => {}
                _ => return Ok(unit),
            }
            let factor = self.factor(depth)?;
            unit = self.bounded(unit.times(factor, 1))?;
        }
    }

    /// ("1" | symbol | "(" quotient ")") \["^" integer\].
    fn factor(&mut self, depth: usize) -> Result<Unit, UnitError> {
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
        let exponent = self.exponent()?;
        self.bounded(Unit::default().times(unit, exponent))
    }

    fn one(&mut self) -> Result<Unit, UnitError> {
        let range = self.word(|c| c.is_ascii_digit() || c == '.');
        if &self.text[range.clone()] == "1" {
            return Ok(Unit::default());
        }
        let message = "a unit holds no number but 1".to_owned();
        Err(UnitError { message, help: "no factor is ever applied".to_owned(), range })
    }

    fn symbol(&mut self) -> Result<Unit, UnitError> {
        let range = self.word(|c| c.is_ascii_alphanumeric());
        let symbol = &self.text[range.clone()];
        if let Some((_, exponents, rad)) = SYMBOLS.iter().find(|(name, ..)| *name == symbol) {
            return Ok(Unit { dimension: Dimension(exponents.map(|e| 2 * e)), rad: 2 * rad });
        }
        let help = if FACTORED.contains(&symbol) {
            "write the quantity in coherent SI units, because no factor is ever applied".to_owned()
        } else {
            let known: Vec<_> = SYMBOLS.iter().map(|(name, ..)| *name).collect();
            format!("known are {}", known.join(" "))
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

    /// The next character that is no space.
    fn peek(&mut self) -> Option<char> {
        let rest = &self.text[self.at..];
        self.at += rest.len() - rest.trim_start_matches(' ').len();
        self.text[self.at..].chars().next()
    }

    fn bounded(&self, unit: Option<Unit>) -> Result<Unit, UnitError> {
        unit.ok_or_else(|| self.error("exponents beyond all reason".to_owned()))
    }

    fn error(&self, message: String) -> UnitError {
        let length = self.text[self.at..].chars().next().map_or(0, char::len_utf8);
        UnitError { message, help: String::new(), range: self.at..self.at + length }
    }
}

/// Powers of angles in an expression, as far as a product shows them.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Angular {
    /// Exponent of rad from angles and their rates, in halves.
    pub angle: i32,
    /// Exponent of 1/rad from stiffnesses, in halves.
    pub stiffness: i32,
    /// Something else moves: a length, a charge, a function of an angle, or a sum
    /// of unlike terms.
    pub other: bool,
}

impl Angular {
    /// Of a quantity with a declared unit; `moves` for coordinates, velocities,
    /// states and what is made of them.
    #[must_use]
    pub fn of(unit: Unit, moves: bool) -> Angular {
        let stiff = unit.rad < 0 && unit.dimension == Dimension::ENERGY;
        Angular {
            angle: if stiff { 0 } else { unit.rad },
            stiffness: if stiff { -unit.rad } else { 0 },
            other: moves && unit.rad <= 0,
        }
    }

    /// Of a function, whose argument may move.
    #[must_use]
    pub fn of_function(moves: bool) -> Angular {
        Angular { angle: 0, stiffness: 0, other: moves }
    }

    /// Of a product.
    #[must_use]
    pub fn times(self, factor: Angular) -> Angular {
        Angular {
            angle: self.angle.saturating_add(factor.angle),
            stiffness: self.stiffness.saturating_add(factor.stiffness),
            other: self.other || factor.other,
        }
    }

    /// Of a power.
    #[must_use]
    pub fn power(self, numerator: i32, denominator: i32) -> Angular {
        let scaled = |e: i32| e.saturating_mul(numerator).checked_div(denominator).unwrap_or(0);
        let (angle, stiffness) = (scaled(self.angle), scaled(self.stiffness));
        Angular { angle, stiffness, other: self.other }
    }

    /// Of a sum: plain numbers take the exponents of the rest.
    #[must_use]
    pub fn plus(self, term: Angular) -> Angular {
        match (self, term) {
            (a, b) if a == b => a,
            (a, b) if b == Angular::default() => a,
            (a, b) if a == Angular::default() => b,
            _ => Angular { other: true, ..Angular::default() },
        }
    }

    /// Whether a term of an energy is rather a torque; see the module's text.
    #[must_use]
    pub fn is_torque(self) -> bool {
        let odd = self.angle % 4 == 2;
        self.stiffness > 0 && odd && self.angle > 0 && self.angle <= self.stiffness && !self.other
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn unit(text: &str) -> Unit {
        Unit::parse(text).unwrap_or_else(|error| panic!("{text}: {error:?}"))
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
    fn units_that_need_a_factor_are_refused() {
        for text in
            ["mm", "deg", "kN", "min", "rpm", "2 m", "", "m^", "m^99", "m)", "(m", "m;", "é"]
        {
            assert!(Unit::parse(text).is_err(), "{text}");
        }
        assert_eq!(Unit::parse("N mm").unwrap_err().range, 2..4);
    }

    #[test]
    fn a_spring_without_its_square_is_a_torque() {
        let stiffness = Angular::of(unit("N m/rad"), false);
        let angle = Angular::of(unit("rad"), true);
        assert!(stiffness.times(angle).is_torque());
        assert!(!stiffness.times(angle.power(2, 1)).is_torque());
        assert!(!stiffness.times(Angular::of_function(true)).is_torque());
        let cubic = Angular::of(unit("N m/rad^3"), false);
        assert!(cubic.times(angle.power(3, 1)).is_torque());
        assert!(!cubic.times(angle.power(4, 1)).is_torque());
    }

    #[test]
    fn sound_energies_of_angles_are_no_torques() {
        let angle = Angular::of(unit("rad"), true);
        let torque = Angular::of(unit("N m"), false);
        let pitch = Angular::of(unit("m/rad"), false);
        let per_square = Angular::of(unit("N m/rad^2"), false);
        let preload = Angular::of(unit("N m/rad"), false).times(Angular::of(unit("rad"), false));
        assert!(!torque.times(angle).is_torque());
        assert!(!pitch.times(angle).is_torque());
        assert!(!per_square.times(angle.power(2, 1)).is_torque());
        assert!(!preload.times(angle).is_torque());
    }

    #[test]
    fn dimensions_are_written_with_their_names() {
        assert_eq!(Dimension::ENERGY.to_string(), "J = kg m^2/s^2");
        assert_eq!(unit("rad").dimension.to_string(), "a pure number");
        assert_eq!(unit("m/s^2").dimension.to_string(), "m/s^2");
        assert_eq!(
            unit("kg").dimension.power(1, 2).map(|d| d.to_string()),
            Some("kg^(1/2)".into())
        );
        assert_eq!(unit("kg").dimension.power(1, 4), None);
    }
}

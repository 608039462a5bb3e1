//! Dimensions: exponents of the SI base units, and of the coherent units with rad.
//!
//! Excluded: text and factors, see [`measure`](super::measure).
//!
//! # Angles
//! rad has no dimension, so plain dimensions do not distinguish a spring's energy `c*phi^2/2`
//! from its torque `c*phi`, with c in N m/rad. [`Unit`] therefore keeps the exponent of rad
//! beside the dimension, and [`Angular`] follows it through products and powers. Requiring equal
//! exponents of all terms would reject sound specs: `c*phi^2/2` has rad^1, `J*omega^2/2` rad^2,
//! `m*g*l*(1 - cos(phi))` rad^0. One rule catches a missing square and accepts those: **a term of
//! an energy is a torque if it contains a stiffness (a factor whose unit is J/rad^p) times an odd
//! power, at most p, of angles, and nothing else that moves.** A pitch in m/rad is not a
//! stiffness, and a stiffness times (1 - cos(n phi)) contains no power of an angle.

use std::fmt;

use num_rational::Ratio;

use super::measure::dimension_of;

/// Names of the base units, in the order of [`Dimension`].
const BASES: [&str; 7] = ["kg", "m", "s", "A", "K", "mol", "cd"];
/// Denominator of the exponents of a dimension: it allows halves to eighths, and other divisors.
const PARTS: i32 = 840;
/// Limit of exponents, in parts of a dimension or halves of rad. Beyond it a unit is rejected.
const MAX_PARTS: i32 = 1 << 24;

/// Exponents of kg, m, s, A, K, mol, cd, in parts of 840.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Dimension([i32; 7]);

/// Dimension of a unit of measure and its exponent of rad.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Unit {
    /// Exponents of the base units.
    pub dimension: Dimension,
    /// Exponent of rad, counted in halves. It is not part of the dimension.
    pub rad: i32,
}

impl Dimension {
    /// Dimension of a dimensionless number.
    pub const ONE: Dimension = Dimension([0; 7]);
    /// Joule.
    pub const ENERGY: Dimension = Dimension::whole([1, 2, -2, 0, 0, 0, 0]);
    /// Newton.
    pub const FORCE: Dimension = Dimension::whole([1, 1, -2, 0, 0, 0, 0]);
    /// Watt.
    pub const POWER: Dimension = Dimension::whole([1, 2, -3, 0, 0, 0, 0]);
    /// Second.
    pub const TIME: Dimension = Dimension::whole([0, 0, 1, 0, 0, 0, 0]);
    /// Metre.
    pub const LENGTH: Dimension = Dimension::whole([0, 1, 0, 0, 0, 0, 0]);
    /// Coulomb.
    pub const MASS: Dimension = Dimension::whole([1, 0, 0, 0, 0, 0, 0]);
    /// Moment of inertia.
    pub const INERTIA: Dimension = Dimension::whole([1, 2, 0, 0, 0, 0, 0]);
    /// Velocity.
    pub const VELOCITY: Dimension = Dimension::whole([0, 1, -1, 0, 0, 0, 0]);
    /// Acceleration.
    pub const ACCELERATION: Dimension = Dimension::whole([0, 1, -2, 0, 0, 0, 0]);
    /// Inverse time.
    pub const FREQUENCY: Dimension = Dimension::whole([0, 0, -1, 0, 0, 0, 0]);
    /// Electric charge.
    pub const CHARGE: Dimension = Dimension::whole([0, 0, 1, 1, 0, 0, 0]);
    /// Weber, volt second.
    pub const FLUX: Dimension = Dimension::whole([1, 2, -2, -1, 0, 0, 0]);

    /// Returns the dimension of a product; `None` if an exponent is too large.
    #[must_use]
    pub fn times(self, other: Dimension) -> Option<Dimension> {
        let mut product = self;
        for (a, b) in product.0.iter_mut().zip(other.0) {
            *a = bounded(a.checked_add(b)?)?;
        }
        Some(product)
    }

    /// Returns the dimension of the power `numerator/denominator`; `None` if an exponent is not a
    /// multiple of 1/840, or too large.
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

    /// Returns the dimension of a quotient; `None` as for [`Dimension::times`].
    #[must_use]
    pub fn over(self, other: Dimension) -> Option<Dimension> {
        self.times(other.power(-1, 1)?)
    }

    /// Formats the dimension as a unit of measure: `N`, `kg m`, `1`.
    #[must_use]
    pub fn as_unit(self) -> String {
        let text = self.to_string();
        match text.split_once(" = ") {
            Some((name, _)) => name.to_owned(),
            None if self == Dimension::ONE => "1".to_owned(),
            None => text,
        }
    }

    /// Returns the dimension with these whole exponents of the base units.
    pub(super) const fn whole(exponents: [i32; 7]) -> Dimension {
        let [kg, m, s, a, k, mol, cd] = exponents;
        let parts = [kg * PARTS, m * PARTS, s * PARTS, a * PARTS, k * PARTS, mol * PARTS];
        let [kg, m, s, a, k, mol] = parts;
        Dimension([kg, m, s, a, k, mol, cd * PARTS])
    }

    /// Formats the dimension in base units: `kg m^2/s^2`.
    fn base_units(self) -> String {
        let part = |sign: i32| {
            let factors = BASES.iter().zip(self.0).filter(|(_, e)| e * sign > 0);
            let factors = factors.map(|(base, e)| match Ratio::new(e * sign, PARTS).into_raw() {
                (1, 1) => (*base).to_owned(),
                (e, 1) => format!("{base}^{e}"),
                (e, parts) => format!("{base}^({e}/{parts})"),
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

fn bounded(parts: i32) -> Option<i32> {
    (parts.abs() <= MAX_PARTS).then_some(parts)
}

impl fmt::Display for Dimension {
    /// Writes `J = kg m^2/s^2`, or the base units alone, or `1 (dimensionless)`.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        const NAMED: [&str; 10] = ["N", "J", "W", "Pa", "V", "ohm", "F", "H", "Wb", "C"];
        if *self == Dimension::ONE {
            return f.write_str("1 (dimensionless)");
        }
        let named = NAMED.into_iter().find(|name| dimension_of(name) == Some(*self));
        match named {
            Some(name) => write!(f, "{name} = {}", self.base_units()),
            None => f.write_str(&self.base_units()),
        }
    }
}

impl Unit {
    /// Returns the exponents of kg, m, s, A, K, mol, cd and rad; `None` if one is a fraction.
    #[must_use]
    pub fn whole_exponents(self) -> Option<[i32; 8]> {
        let whole = |parts: i32, of: i32| (parts % of == 0).then_some(parts / of);
        let mut exponents = [0; 8];
        for (exponent, parts) in exponents.iter_mut().zip(self.dimension.0) {
            *exponent = whole(parts, PARTS)?;
        }
        exponents[7] = whole(self.rad, 2)?;
        Some(exponents)
    }

    /// Returns the unit divided by `s^order`.
    ///
    /// # Errors
    /// `None` if an exponent is too large.
    #[must_use]
    pub fn per_second(self, order: i32) -> Option<Unit> {
        let dimension = self.dimension.over(Dimension::TIME.power(order, 1)?)?;
        Some(Unit { dimension, rad: self.rad })
    }

    /// Returns the power `numerator/denominator` of the unit; `None` as for [`Dimension::power`].
    #[must_use]
    pub fn power(self, numerator: i32, denominator: i32) -> Option<Unit> {
        let dimension = self.dimension.power(numerator, denominator)?;
        let rad = self.rad.checked_mul(numerator)?;
        let whole = rad.checked_rem(denominator)? == 0;
        Some(Unit { dimension, rad: bounded(rad / denominator)? }).filter(|_| whole)
    }

    /// Returns the unit times a power of another; `None` if an exponent is too large.
    #[must_use]
    pub fn times(self, other: Unit, exponent: i32) -> Option<Unit> {
        let dimension = self.dimension.times(other.dimension.power(exponent, 1)?)?;
        let rad = bounded(self.rad.checked_add(other.rad.checked_mul(exponent)?)?)?;
        Some(Unit { dimension, rad })
    }
}

/// Powers of angles in an expression, as far as products show them.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Angular {
    /// Exponent of rad from angles and their rates, in halves.
    pub angle: i32,
    /// Exponent of 1/rad from stiffnesses, in halves.
    pub stiffness: i32,
    /// True if something else moves: a length, a charge, a function of an angle, or a sum of
    /// unlike terms.
    pub other: bool,
}

impl Angular {
    /// Returns the powers of a quantity with a declared unit. `moves` is true for coordinates,
    /// velocities, states and expressions of them.
    #[must_use]
    pub fn of(unit: Unit, moves: bool) -> Angular {
        let stiff = unit.rad < 0 && unit.dimension == Dimension::ENERGY;
        Angular {
            angle: if stiff { 0 } else { unit.rad },
            stiffness: if stiff { -unit.rad } else { 0 },
            other: moves && unit.rad <= 0,
        }
    }

    /// Returns the powers of a function, whose argument may move.
    #[must_use]
    pub fn of_function(moves: bool) -> Angular {
        Angular { angle: 0, stiffness: 0, other: moves }
    }

    /// Returns the powers of a product.
    #[must_use]
    pub fn times(self, factor: Angular) -> Angular {
        Angular {
            angle: self.angle.saturating_add(factor.angle),
            stiffness: self.stiffness.saturating_add(factor.stiffness),
            other: self.other || factor.other,
        }
    }

    /// Returns the powers of a power.
    #[must_use]
    pub fn power(self, numerator: i32, denominator: i32) -> Angular {
        let scaled = |e: i32| e.saturating_mul(numerator).checked_div(denominator).unwrap_or(0);
        let (angle, stiffness) = (scaled(self.angle), scaled(self.stiffness));
        Angular { angle, stiffness, other: self.other }
    }

    /// Returns the powers of a sum, where plain numbers take the exponents of the other terms.
    #[must_use]
    pub fn plus(self, term: Angular) -> Angular {
        match (self, term) {
            (a, b) if a == b => a,
            (a, b) if b == Angular::default() => a,
            (a, b) if a == Angular::default() => b,
            _ => Angular { other: true, ..Angular::default() },
        }
    }

    /// Reports whether a term of an energy is a torque instead; see the module documentation.
    #[must_use]
    pub fn is_torque(self) -> bool {
        let odd = self.angle % 4 == 2;
        self.stiffness > 0 && odd && self.angle > 0 && self.angle <= self.stiffness && !self.other
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::spec::measure::Measure;

    fn unit(text: &str) -> Unit {
        Measure::coherent(text).unwrap_or_else(|error| panic!("{text}: {error:?}"))
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
        assert_eq!(unit("rad").dimension.to_string(), "1 (dimensionless)");
        assert_eq!(unit("m/s^2").dimension.to_string(), "m/s^2");
        assert_eq!(
            unit("kg").dimension.power(1, 2).map(|d| d.to_string()),
            Some("kg^(1/2)".into())
        );
        assert_eq!(
            unit("m^3").dimension.power(2, 7).map(|d| d.to_string()),
            Some("m^(6/7)".into())
        );
        assert_eq!(unit("kg").dimension.power(1, 9), None);
    }
}

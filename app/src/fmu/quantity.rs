//! Units and types of variables.

use std::collections::BTreeSet;

use machinist_codegen::spec::measure::Measure;
use machinist_fmu::variables::Variables;

use super::xml::Element;
use crate::failure::Failure;

/// Base units by FMI's names.
const BASES: [&str; 8] = ["kg", "m", "s", "A", "K", "mol", "cd", "rad"];

/// Additional units for display, with the number of them per unit.
const DISPLAYED: [(&str, &str, f64); 2] =
    [("rad", "deg", 180.0 / std::f64::consts::PI), ("rad/s", "rpm", 30.0 / std::f64::consts::PI)];

/// Quantities, each with the unit that only it has.
const QUANTITIES: [(&str, &str); 22] = [
    ("A", "ElectricCurrent"),
    ("C", "ElectricCharge"),
    ("H", "Inductance"),
    ("N", "Force"),
    ("N m", "Torque"),
    ("N m s/rad", "RotationalDampingConstant"),
    ("N m/rad", "RotationalSpringConstant"),
    ("N s/m", "TranslationalDampingConstant"),
    ("N/m", "TranslationalSpringConstant"),
    ("Pa", "Pressure"),
    ("V", "ElectricPotential"),
    ("V s", "MagneticFlux"),
    ("W", "Power"),
    ("kg", "Mass"),
    ("kg m^2", "MomentOfInertia"),
    ("m", "Length"),
    ("m/s", "Velocity"),
    ("m/s^2", "Acceleration"),
    ("ohm", "Resistance"),
    ("rad", "Angle"),
    ("rad/s", "AngularVelocity"),
    ("rad/s^2", "AngularAcceleration"),
];

/// Name of the type of modes.
pub const MODE: &str = "Types.Mode";
/// Meaning of that type.
pub const MODE_DOC: &str = "selects the active equations; changed by events";

/// Type of real numbers.
pub struct Type {
    pub name: String,
    pub quantity: &'static str,
    pub unit: &'static str,
}

/// Returns the unit of an attribute; `None` if dimensionless.
pub fn unit_of(unit: &str) -> Option<&str> {
    (unit != "1" && !unit.is_empty()).then_some(unit)
}

/// Returns the type of numbers in a unit, if it has a name.
pub fn type_of(unit: &str) -> Option<String> {
    let (_, quantity) = QUANTITIES.iter().find(|(known, _)| *known == unit)?;
    Some(format!("Types.{quantity}"))
}

/// Returns definitions of all units that variables have.
pub fn units(variables: &Variables) -> Result<Vec<Element>, Failure> {
    let all = variables.all().iter();
    let units: BTreeSet<&str> = all.filter_map(|variable| unit_of(&variable.unit)).collect();
    units.into_iter().map(definition).collect()
}

fn definition(unit: &str) -> Result<Element, Failure> {
    let wrong = |why: &str| Failure::input(format!("unit `{unit}` of the model: {why}"), "");
    let Measure { unit: coherent, factor } =
        Measure::parse(unit).map_err(|error| wrong(&error.message))?;
    let exponents =
        coherent.whole_exponents().ok_or_else(|| wrong("it has fractional exponents"))?;
    let mut base = Element::new("BaseUnit");
    if !factor.is_one() {
        base = base.with_number("factor", factor.to_f64());
    }
    for (name, exponent) in BASES.into_iter().zip(exponents) {
        base = base.with_some(name, (exponent != 0).then_some(exponent));
    }
    let displayed = DISPLAYED.iter().filter(|(of, ..)| *of == unit).map(|(_, name, factor)| {
        Element::new("DisplayUnit").with("name", name).with_number("factor", *factor)
    });
    Ok(Element::new("Unit").with("name", unit).holding([base]).holding(displayed))
}

/// Returns the types that variables have: name, quantity and unit.
pub fn types(variables: &Variables) -> Vec<Type> {
    let is_used = |unit: &str| variables.all().iter().any(|variable| variable.unit == unit);
    let used = QUANTITIES.iter().filter(|(unit, _)| is_used(unit));
    used.map(|&(unit, quantity)| Type { name: format!("Types.{quantity}"), quantity, unit })
        .collect()
}

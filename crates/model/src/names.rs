//! Names, quantities and tables of a model.

use machinist_contract as contract;
use serde::{Deserialize, Serialize};

/// A name in its three spellings.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct Name {
    /// The spec's path, `motor.phi`.
    pub path: String,
    /// A Rust identifier, unique among its kind in the scene: `motor_phi`.
    /// Never a keyword.
    pub ident: String,
    /// LaTeX, `\varphi_{\mathrm{motor}}`.
    pub latex: String,
}

/// A named quantity with unit and meaning.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct Quantity {
    /// Name of the quantity.
    pub name: Name,
    /// SI unit as the spec writes it; `1` if dimensionless.
    pub unit: String,
    /// One sentence of meaning; may be empty.
    pub doc: String,
}

impl Quantity {
    /// Returns the quantity as simulators describe it.
    #[must_use]
    pub fn described(&self) -> contract::Quantity<'_> {
        contract::Quantity { name: &self.name.path, unit: &self.unit, doc: &self.doc }
    }
}

/// Direction in which a guard passes zero.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub enum Direction {
    /// From negative to positive.
    Rising,
    /// From positive to negative.
    Falling,
    /// Either direction.
    Both,
}

impl Direction {
    /// All directions.
    pub const ALL: [Direction; 3] = [Direction::Rising, Direction::Falling, Direction::Both];

    /// Returns the spec's word for it.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Direction::Rising => "rising",
            Direction::Falling => "falling",
            Direction::Both => "both",
        }
    }
}

/// Place of a port on a field.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub enum Place {
    /// At x = 0.
    Start,
    /// Between both ends.
    Inside,
    /// At x = length.
    End,
}

/// A cubic interpolation table, natural spline; see `CubicTable` of the contract.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Table {
    /// Name of the table.
    pub name: Name,
    /// Abscissae, increasing.
    pub knots: Vec<f64>,
    /// Cubic of each interval, in powers of the distance from its first knot.
    pub coefficients: Vec<[f64; 4]>,
}

/// Settings of the run that a scene requests.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct RunDefaults {
    /// Start time \[s\].
    pub from: f64,
    /// End time \[s\].
    pub until: f64,
    /// Number of output times, both ends included; equally spaced unless `times` are given.
    pub points: usize,
    /// Output times \[s\] where they are not equally spaced, increasing; else empty.
    pub times: Vec<f64>,
    /// Relative tolerance.
    pub rtol: f64,
    /// Name of the method.
    pub method: String,
}

/// A source file of the spec.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct SourceFile {
    /// File name relative to the folder of specs, with forward slashes.
    pub label: String,
    /// SHA-256 of its bytes, in hexadecimal.
    pub sha256: String,
}

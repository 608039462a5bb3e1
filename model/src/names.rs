//! Names, quantities, tables: what a model says of itself.

use machinist_contract as contract;
use serde::{Deserialize, Serialize};

/// The name of a thing, in its three spellings.
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
    /// What it is called.
    pub name: Name,
    /// SI unit as the spec writes it; `1` for a pure number.
    pub unit: String,
    /// One sentence of meaning; may be empty.
    pub doc: String,
}

impl Quantity {
    /// As simulators describe it.
    #[must_use]
    pub fn described(&self) -> contract::Quantity<'_> {
        contract::Quantity { name: &self.name.path, unit: &self.unit, doc: &self.doc }
    }
}

/// Which way a guard passes zero.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub enum Direction {
    /// From below to above.
    Rising,
    /// From above to below.
    Falling,
    /// Either way.
    Both,
}

impl Direction {
    /// All of them.
    pub const ALL: [Direction; 3] = [Direction::Rising, Direction::Falling, Direction::Both];

    /// The spec's word for it.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Direction::Rising => "rising",
            Direction::Falling => "falling",
            Direction::Both => "both",
        }
    }
}

/// Where a port on a field is.
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
    /// What it is called.
    pub name: Name,
    /// Abscissae, increasing.
    pub knots: Vec<f64>,
    /// Cubic of each interval, in powers of the distance from its first knot.
    pub coefficients: Vec<[f64; 4]>,
}

/// The run a scene asks for.
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

/// A source file that took part.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct SourceFile {
    /// File name relative to the folder of specs, with forward slashes.
    pub label: String,
    /// SHA-256 of its bytes, in hexadecimal.
    pub sha256: String,
}

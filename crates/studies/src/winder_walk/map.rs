//! Map of stable winding, over radius of the package and winding speed.
//!
//! ```text
//! dN = (1 + delta) sum B c~                        over harmonics of force and shape
//! N > dN                                           contact
//! Pn <= (N - dN) (f - (fa r + k)/R)                adhesion
//! Pn <= 0.9 f (N - dN)                             the rule of practice
//! N + dN <= [Nmax]                                 the yarn
//! ```
//!
//! Together they form the pressure band \[Nmin\] + dN <= N <= \[Nmax\] - dN, with \[Nmin\] from
//! adhesion and practice. B is the amplitude by which a harmonic compresses the layer, c~ its
//! dynamic stiffness |c + j h p|. Phases are the worst possible and the layer is linear, so points
//! that are stable here are stable in any case.
//!
//! Source: winder study.

use serde::Serialize;

use super::Winder;
use super::spectrum::{bobbin, disturbances, package};
use crate::closed_form::WindingPair;
use crate::closed_form::winder::BobbinOscillator;
use crate::closed_form::winding_pair::DESIGN_SHARE;
use crate::verify::CheckFailure;
use crate::verify::machine::{winder_full, winder_linear};

/// First condition that fails, in this order.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Condition {
    /// No condition fails: winding is stable.
    Stable,
    /// The pressure may fall to zero.
    Contact,
    /// Friction may not suffice to turn the package.
    Adhesion,
    /// Friction suffices, but the rule of practice is broken.
    Practice,
    /// The yarn may be pressed too hard.
    Yarn,
}

impl Condition {
    /// All conditions, in the order of evaluation.
    pub const ALL: [Self; 5] =
        [Self::Stable, Self::Contact, Self::Adhesion, Self::Practice, Self::Yarn];

    /// Returns a description in a few words.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Stable => "stable",
            Self::Contact => "contact may be lost",
            Self::Adhesion => "the package may slip",
            Self::Practice => "against the rule of practice",
            Self::Yarn => "the yarn may be pressed too hard",
        }
    }
}

/// One point of the map.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Cell {
    /// dN \[N\].
    pub variation: f64,
    /// (N - dN) (f - (fa r + k)/R) - Pn \[N\]; if it is negative, the package may slip.
    pub margin: f64,
    /// First condition that fails.
    pub condition: Condition,
}

/// Data of the conditions.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Limits {
    /// f, fa r and k.
    #[serde(skip)]
    pub pair: WindingPair,
    /// N \[N\]; for a map, with the empty bobbin.
    pub pressure: f64,
    /// Pn \[N\].
    pub tension: f64,
    /// \[Nmax\], limit of the pressure for the yarn \[N\].
    pub largest: f64,
    /// delta, relative uncertainty of the dynamic stiffness.
    pub spread: f64,
}

impl Limits {
    /// Judges a radius \[m\] at which the pressure varies by dN \[N\].
    #[must_use]
    pub fn judge(&self, radius: f64, variation: f64) -> Cell {
        let Self { pair, pressure, tension, largest, .. } = *self;
        let left = pressure - variation;
        let margin = left * pair.grip(radius) - tension;
        let condition = if left <= 0.0 {
            Condition::Contact
        } else if margin < 0.0 {
            Condition::Adhesion
        } else if tension > DESIGN_SHARE * pair.friction * left {
            Condition::Practice
        } else if pressure + variation > largest {
            Condition::Yarn
        } else {
            Condition::Stable
        };
        Cell { variation, margin, condition }
    }

    /// Returns dN \[N\] of a winder with the bobbin of a package of some radius \[m\], with its
    /// drum turning at `drum` rad/s.
    #[must_use]
    pub fn variation(
        &self,
        bobbin: &BobbinOscillator,
        winder: &Winder,
        [drum, radius]: [f64; 2],
    ) -> f64 {
        let [force, shape] = disturbances(winder, drum);
        let forces = [force, package(winder, radius)];
        (1.0 + self.spread) * bobbin.pressure_variation(&forces, &[shape])
    }
}

/// A stability map.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct StabilityMap {
    /// Data of the conditions.
    pub limits: Limits,
    /// Radii of the package \[m\].
    pub radii: Vec<f64>,
    /// Winding speeds \[m/s\].
    pub speeds: Vec<f64>,
    /// A row for each speed, a cell for each radius.
    pub cells: Vec<Vec<Cell>>,
}

/// Speed up to which maps go if the winder is no faster \[m/s\].
pub const FASTEST: f64 = 14.0;
/// Numbers of radii and speeds of a map.
pub const SIZE: (u32, u32) = (61, 141);
/// Default of \[Nmax\] \[N\].
pub const LARGEST: f64 = 190.0;
/// Default of delta.
pub const SPREAD: f64 = 0.1;

impl StabilityMap {
    /// Computes the map of a winder up to a speed \[m/s\]. Unbalances of drum and package are
    /// proportional to the square of the speed, with the winder's values at its own speed.
    ///
    /// # Errors
    /// [`CheckFailure`] if a scene lacks a required quantity.
    pub fn of(winder: &Winder, fastest: f64) -> Result<Self, CheckFailure> {
        let (linear, full) = (winder_linear(), winder_full());
        let pair = WindingPair {
            friction: full.value("pair.friction")?,
            support_arm: full.value("pair.support_arm")?,
            rolling_arm: full.value("pair.rolling_arm")?,
        };
        let limits = Limits {
            pair,
            pressure: winder.preload,
            tension: winder.tension,
            largest: winder.largest,
            spread: SPREAD,
        };
        let drum_radius = linear.value("drum_radius")?;
        let radii: Vec<f64> = winder.radii(SIZE.0).collect();
        let bobbins: Vec<BobbinOscillator> =
            radii.iter().map(|radius| bobbin(&linear, *radius)).collect::<Result<_, _>>()?;
        let share = |k: u32| f64::from(k + 1) / f64::from(SIZE.1);
        let speeds: Vec<f64> = (0..SIZE.1).map(|k| fastest * share(k)).collect();
        let row = |speed: &f64| {
            let there = winder.winding_at(*speed);
            let cell = |(radius, bobbin): (&f64, &BobbinOscillator)| {
                let limits = Limits { pressure: winder.pressure(*radius), ..limits };
                limits.judge(
                    *radius,
                    limits.variation(bobbin, &there, [speed / drum_radius, *radius]),
                )
            };
            radii.iter().zip(&bobbins).map(cell).collect()
        };
        let cells = speeds.iter().map(row).collect();
        Ok(Self { limits, radii, speeds, cells })
    }

    /// Returns the share of points with a condition.
    #[must_use]
    pub fn share(&self, condition: Condition) -> f64 {
        let cells = self.cells.iter().flatten();
        let count = cells.filter(|cell| cell.condition == condition).count();
        count as f64 / (self.radii.len() * self.speeds.len()) as f64
    }
}

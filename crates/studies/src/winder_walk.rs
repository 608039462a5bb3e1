//! Choice of a sufficient model of a winder: three stages, and the map of stable winding.
//!
//! 1. Linear ([`spectrum`]): sufficient if every operating frequency differs from every resonance
//!    by at least a factor of two while the package grows.
//! 2. Stiffening layer ([`layer`]): its resonances at the actual amplitude of the winder;
//!    sufficient if operating frequencies differ from them by at least 40 %.
//! 3. Full ([`full`]), with loss of contact, friction and growth.
//!
//! A walk ends at the first sufficient stage. The others are run as well, to show their cost and
//! what they would have changed.
//!
//! Source: winder study.

pub mod balance;
pub mod full;
pub mod layer;
pub mod map;
pub mod spectrum;

use std::time::Instant;

use serde::Serialize;

use crate::verify::CheckFailure;
use crate::verify::machine::winder_full;

/// A winder; everything else is as in the scenes.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Winder {
    /// Surface speed of the drum \[m/s\].
    pub speed: f64,
    /// Least and largest radius of the package \[m\].
    pub radii: (f64, f64),
    /// Force at the rotation frequency of the drum \[N\].
    pub force: f64,
    /// Amplitude of the drum's shape at twice its rotation frequency \[m\].
    pub shape: f64,
    /// Force of an irregular package at its rotation frequency \[N\].
    pub package: f64,
    /// Pressure at rest \[N\], with the empty bobbin.
    pub preload: f64,
    /// Growth of the pressure with the radius of the package \[N/m\]: by equation (15) the holder's
    /// reduced stiffness if only a spring presses; 0 if the pressure is kept constant.
    pub growth: f64,
    /// Tension of the thread \[N\].
    pub tension: f64,
    /// nu, greatest elastic slip of the package; 0 if it sticks to the drum. Used only by the last
    /// stage.
    pub elastic_slip: f64,
    /// \[Nmax\], limit of the pressure for the yarn \[N\]; used only by the map.
    pub largest: f64,
}

/// Speeds of three winders, each decided by another stage.
pub const SPEEDS: [f64; 3] = [1.5, 2.2, 5.5];

/// Upper bound of the speed \[m/s\]; the number of steps of a run grows with the speed.
const MOST_SPEED: f64 = 200.0;

impl Winder {
    /// Returns the bench winder at another speed: its unbalance, 25 N at 5.5 m/s, is proportional
    /// to the square of the speed.
    ///
    /// # Errors
    /// [`CheckFailure`] if a scene lacks a required quantity.
    pub fn at_speed(speed: f64) -> Result<Self, CheckFailure> {
        let machine = winder_full();
        let share = speed / machine.value("winding_speed")?;
        Ok(Self {
            speed,
            radii: (machine.value("pair.bobbin_radius")?, 0.06),
            force: machine.value("force_amplitude")? * share * share,
            shape: machine.value("ovality")?,
            package: machine.value("package_force")?,
            preload: machine.value("holder.preload")?,
            growth: 0.0,
            tension: machine.value("pair.tension")?,
            elastic_slip: machine.value("pair.greatest_slip")?,
            largest: map::LARGEST,
        })
    }

    /// Returns this winder at another speed: unbalances of drum and package are proportional to the
    /// square of the speed.
    #[must_use]
    pub fn winding_at(&self, speed: f64) -> Self {
        let square = (speed / self.speed).powi(2);
        Self { speed, force: self.force * square, package: self.package * square, ..*self }
    }

    /// Returns what is wrong with the winder, if anything.
    #[must_use]
    pub fn mistake(&self) -> Option<String> {
        let positive = [
            ("speed", self.speed),
            ("least radius", self.radii.0),
            ("largest radius", self.radii.1),
            ("pressure at rest", self.preload),
            ("largest pressure", self.largest),
        ];
        let others = [
            ("force", self.force),
            ("shape", self.shape),
            ("force of the package", self.package),
            ("tension", self.tension),
            ("growth of the pressure", self.growth),
            ("elastic slip", self.elastic_slip),
        ];
        let bad = positive.iter().find(|(_, value)| !(value.is_finite() && *value > 0.0));
        if let Some((name, value)) = bad {
            return Some(format!("the {name} is {value}, but must be above zero"));
        }
        let bad = others.iter().find(|(_, value)| !(value.is_finite() && *value >= 0.0));
        if let Some((name, value)) = bad {
            return Some(format!("the {name} is {value}, but must not be below zero"));
        }
        if self.elastic_slip >= 1.0 {
            return Some(format!("the elastic slip is {}, but must be below 1", self.elastic_slip));
        }
        if self.speed > MOST_SPEED {
            return Some(format!("the speed is {}, but must not exceed {MOST_SPEED}", self.speed));
        }
        let (least, most) = self.radii;
        (least >= most).then(|| format!("the least radius {least} m is not below {most} m"))
    }

    /// Returns the pressure at rest \[N\] at a radius of the package \[m\].
    #[must_use]
    pub fn pressure(&self, radius: f64) -> f64 {
        self.preload + self.growth * (radius - self.radii.0)
    }

    /// Returns `count` radii from the least to the largest \[m\].
    fn radii(&self, count: u32) -> impl Iterator<Item = f64> + use<> {
        let (from, to) = self.radii;
        (0..count).map(move |k| from + (to - from) * f64::from(k) / f64::from(count - 1))
    }

    /// Returns every operating frequency \[rad/s\] at a radius of the package.
    fn frequencies(&self, drum_radius: f64) -> [Operating; 3] {
        let speed = self.speed;
        let drum = speed / drum_radius;
        [
            ("the drum's unbalance, once a turn", Box::new(move |_| drum)),
            ("the drum's shape, twice a turn", Box::new(move |_| 2.0 * drum)),
            ("the package, once a turn", Box::new(move |radius| speed / radius)),
        ]
    }
}

/// Name of a rotating part, and its frequency \[rad/s\] by radius of the package.
type Operating = (&'static str, Box<dyn Fn(f64) -> f64>);

/// Distance of an operating frequency from the resonance while the package grows.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Clearance {
    /// Name of the part that rotates at this frequency.
    pub name: &'static str,
    /// Frequency with the empty bobbin and with the full package \[rad/s\].
    pub frequency: (f64, f64),
    /// Smallest ratio of the larger to the smaller of both frequencies; 1 where they coincide.
    pub ratio: f64,
}

/// Behaviour of a winder in one of the models: the worst values over the radii.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Running {
    /// Largest deflection of the bobbin \[m\].
    pub amplitude: f64,
    /// Least pressure \[N\]; a negative one means that the model lets the drum pull, which is
    /// impossible.
    pub least_pressure: f64,
    /// Share of time without contact, or in which the drum pulls.
    pub open: f64,
    /// Share of time in which the package slips; elastic slip does not count.
    pub slipping: f64,
    /// Largest slip relative to the drum's speed, elastic slip included.
    pub slip: f64,
}

impl Running {
    /// Initial value before any radius is evaluated.
    const NOTHING: Self =
        Self { amplitude: 0.0, least_pressure: f64::INFINITY, open: 0.0, slipping: 0.0, slip: 0.0 };

    /// Evaluates deflections and pressures at equally spaced times, for a model without slip.
    fn of(deflections: &[f64], pressures: &[f64]) -> Self {
        let pulling = pressures.iter().filter(|pressure| **pressure <= 0.0).count();
        Self {
            amplitude: deflections.iter().fold(0.0, |most, value| value.abs().max(most)),
            least_pressure: pressures.iter().copied().fold(f64::INFINITY, f64::min),
            open: pulling as f64 / pressures.len() as f64,
            ..Self::NOTHING
        }
    }

    fn worse(self, other: Self) -> Self {
        Self {
            amplitude: self.amplitude.max(other.amplitude),
            least_pressure: self.least_pressure.min(other.least_pressure),
            open: self.open.max(other.open),
            slipping: self.slipping.max(other.slipping),
            slip: self.slip.max(other.slip),
        }
    }
}

/// Result of a stage of the walk.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Stage {
    /// Number, 1 to 3.
    pub number: usize,
    /// Name of the model.
    pub name: &'static str,
    /// Ratio of frequencies from which on the stage is sufficient; `None` for the last stage.
    pub enough: Option<f64>,
    /// Resonance with the empty bobbin and with the full package \[rad/s\]; `None` for the last
    /// stage.
    pub resonance: Option<(f64, f64)>,
    /// Distance of every operating frequency from the resonance.
    pub clearances: Vec<Clearance>,
    /// Behaviour of the winder in this model.
    pub running: Running,
    /// Computing time \[s\].
    pub seconds: f64,
}

impl Stage {
    /// Returns the frequency nearest to the resonance.
    #[must_use]
    pub fn nearest(&self) -> Option<&Clearance> {
        self.clearances.iter().min_by(|a, b| a.ratio.total_cmp(&b.ratio))
    }

    /// Returns whether the stage is sufficient.
    #[must_use]
    pub fn decides(&self) -> bool {
        self.enough
            .is_none_or(|enough| self.clearances.iter().all(|clearance| clearance.ratio >= enough))
    }
}

/// Results of all stages for a winder.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Walk {
    /// The winder.
    pub winder: Winder,
    /// Results of the three stages.
    pub stages: [Stage; 3],
}

impl Walk {
    /// Runs all three stages for a winder.
    ///
    /// # Errors
    /// [`CheckFailure`] if a scene lacks a required quantity or a run stops.
    pub fn of(winder: &Winder) -> Result<Self, CheckFailure> {
        let timed = |stage: fn(&Winder) -> Result<Stage, CheckFailure>| {
            let start = Instant::now();
            let stage = stage(winder)?;
            Ok::<_, CheckFailure>(Stage { seconds: start.elapsed().as_secs_f64(), ..stage })
        };
        let stages = [timed(spectrum::stage)?, timed(layer::stage)?, timed(full::stage)?];
        Ok(Self { winder: *winder, stages })
    }

    /// Returns the first sufficient stage.
    #[must_use]
    pub fn decided(&self) -> &Stage {
        let [_, _, last] = &self.stages;
        self.stages.iter().find(|stage| stage.decides()).unwrap_or(last)
    }

    /// Returns why that stage decided: the open questions of previous stages, and its result.
    #[must_use]
    pub fn why(&self) -> Vec<String> {
        let decided = self.decided().number;
        let asked = self.stages.iter().take_while(|stage| stage.number <= decided);
        asked.map(Self::verdict).collect()
    }

    fn verdict(stage: &Stage) -> String {
        let (number, name) = (stage.number, stage.name);
        let (Some(enough), Some(nearest)) = (stage.enough, stage.nearest()) else {
            let running = &stage.running;
            let contact = if running.open > 0.0 {
                format!("contact is lost {:.1} % of the time", 100.0 * running.open)
            } else {
                format!("contact is kept, with {:.2} N at least", running.least_pressure)
            };
            let slip = if running.slipping > 0.0 {
                format!(
                    "the package slips {:.1} % of the time, by {:.2} % at most",
                    100.0 * running.slipping,
                    100.0 * running.slip
                )
            } else if running.slip > 0.0 {
                format!("the package slips elastically, by {:.2} % at most", 100.0 * running.slip)
            } else {
                "the package does not slip".to_owned()
            };
            return format!("Stage {number}, {name}: {contact}, and {slip}.");
        };
        let (what, ratio) = (nearest.name, nearest.ratio);
        if stage.decides() {
            return format!(
                "Stage {number}, {name}, is enough: {what}, comes nearest to the resonance, to a \
                 ratio of {ratio:.2}, and {enough} is asked for."
            );
        }
        let near = if ratio > 1.0 {
            format!("comes to a ratio of {ratio:.2} of the resonance")
        } else {
            "passes through the resonance".to_owned()
        };
        format!("Stage {number}, {name}, is not enough: {what}, {near}, and {enough} is asked for.")
    }

    /// Returns the cost of a later stage, relative to the time of the deciding stage.
    #[must_use]
    pub fn cost(&self, stage: &Stage) -> f64 {
        stage.seconds / self.decided().seconds
    }

    /// Returns what a later stage changes relative to the deciding one.
    #[must_use]
    pub fn change(&self, stage: &Stage) -> String {
        let (by, then) = (&self.decided().running, &stage.running);
        let share = 100.0 * (then.amplitude / by.amplitude - 1.0);
        let change = format!(
            "amplitude {:.4} mm instead of {:.4} mm ({share:+.3} %), least pressure {:.3} N instead \
             of {:.3} N",
            1e3 * then.amplitude,
            1e3 * by.amplitude,
            then.least_pressure,
            by.least_pressure
        );
        if stage.number < 3 {
            return change;
        }
        format!(
            "{change}, without contact {:.1} % of the time, slipping {:.1} % of it by {:.2} % at most",
            100.0 * then.open,
            100.0 * then.slipping,
            100.0 * then.slip
        )
    }

    /// Returns the stages after the deciding one.
    #[must_use]
    pub fn later(&self) -> &[Stage] {
        &self.stages[self.decided().number..]
    }
}

/// Compares the operating frequencies with resonances by radius.
fn clearances(frequencies: &[Operating; 3], spectrum: &[(f64, f64)]) -> Vec<Clearance> {
    let at = |end: Option<&(f64, f64)>, frequency: &dyn Fn(f64) -> f64| {
        end.map_or(f64::NAN, |(radius, _)| frequency(*radius))
    };
    let clearance = |(name, frequency): &Operating| Clearance {
        name,
        frequency: (at(spectrum.first(), frequency), at(spectrum.last(), frequency)),
        ratio: smallest_ratio(spectrum.iter().map(|(radius, w)| frequency(*radius) / w)),
    };
    frequencies.iter().map(clearance).collect()
}

/// Returns the smallest ratio of larger to smaller; 1 if the ratios pass through 1.
fn smallest_ratio(ratios: impl Iterator<Item = f64> + Clone) -> f64 {
    let (below, above) = (ratios.clone().any(|r| r <= 1.0), ratios.clone().any(|r| r >= 1.0));
    if below && above {
        return 1.0;
    }
    ratios.map(|ratio| ratio.max(1.0 / ratio)).fold(f64::INFINITY, f64::min)
}

/// Returns the first and last value.
fn ends(spectrum: &[(f64, f64)]) -> Option<(f64, f64)> {
    Some((spectrum.first()?.1, spectrum.last()?.1))
}

#[cfg(test)]
#[path = "winder_walk/tests.rs"]
mod tests;

//! Which model of a winder is enough: the walk through three stages, its first stage.
//!
//! 1. Linear: if every operating frequency is at least a factor of two from every
//!    resonance while the package grows, stop.
//! 2. Stiffening layer: enough if they stay at least 40 % away.
//! 3. Full, with loss of contact, friction and growth.
//!
//! Here the first stage is walked, and it is said what it leaves to the second.
//! Source: winder study.

use crate::verify::CheckFailure;
use crate::verify::machine::{Machine, winder_linear};

/// How far operating frequencies must stay from resonances for the first stage to be
/// enough.
pub const ENOUGH: f64 = 2.0;

/// An operating frequency against the resonance, while the package grows.
#[derive(Debug, Clone, PartialEq)]
pub struct Clearance {
    /// What turns at this frequency.
    pub name: &'static str,
    /// The frequency with the empty bobbin and with the full package \[rad/s\].
    pub frequency: (f64, f64),
    /// The smallest ratio of the two, the larger over the smaller; 1 where they meet.
    pub ratio: f64,
}

/// What the spectrum says.
#[derive(Debug, Clone, PartialEq)]
pub struct FirstStage {
    /// Radius of the package, least and largest \[m\].
    pub radii: (f64, f64),
    /// Resonance at these \[rad/s\].
    pub resonance: (f64, f64),
    /// Every operating frequency.
    pub clearances: Vec<Clearance>,
}

impl FirstStage {
    /// Walks the scene `winder_linear` from the empty bobbin to a package of 60 mm.
    ///
    /// # Errors
    /// [`CheckFailure`] if the scene lacks what is asked for.
    pub fn of_the_scene() -> Result<Self, CheckFailure> {
        let machine = winder_linear();
        let empty = machine.value("holder.bobbin_radius")?;
        Self::walk(&machine, (empty, 0.06))
    }

    fn walk(machine: &Machine, radii: (f64, f64)) -> Result<Self, CheckFailure> {
        const STEPS: u32 = 60;
        let speed = machine.value("winding_speed")?;
        let drum = speed / machine.value("drum_radius")?;
        let mut spectrum = Vec::new();
        for step in 0..=STEPS {
            let radius = radii.0 + (radii.1 - radii.0) * f64::from(step) / f64::from(STEPS);
            spectrum.push((radius, resonance(machine, radius)?));
        }
        let clearance = |name, frequency: &dyn Fn(f64) -> f64| Clearance {
            name,
            frequency: (frequency(radii.0), frequency(radii.1)),
            ratio: smallest_ratio(spectrum.iter().map(|(radius, w)| frequency(*radius) / w)),
        };
        Ok(Self {
            radii,
            resonance: (spectrum[0].1, spectrum[STEPS as usize].1),
            clearances: vec![
                clearance("the drum's unbalance, once a turn", &|_| drum),
                clearance("the drum's shape, twice a turn", &|_| 2.0 * drum),
                clearance("the package, once a turn", &|radius| speed / radius),
            ],
        })
    }

    /// The frequency that comes nearest to the resonance.
    #[must_use]
    pub fn nearest(&self) -> Option<&Clearance> {
        self.clearances.iter().min_by(|a, b| a.ratio.total_cmp(&b.ratio))
    }

    /// Whether the linear model is enough.
    #[must_use]
    pub fn decides(&self) -> bool {
        self.clearances.iter().all(|clearance| clearance.ratio >= ENOUGH)
    }
}

/// Undamped resonance of the emitted scene, sqrt(-dv'/dx) \[rad/s\].
fn resonance(machine: &Machine, radius: f64) -> Result<f64, CheckFailure> {
    let point = machine.point(&[("holder.package_radius", radius)], &[])?;
    let jacobian = machine.rate_jacobian(&point);
    let (x, v) = (machine.state_index("holder.x")?, machine.state_index("holder.v")?);
    Ok((-jacobian[(v, x)]).sqrt())
}

/// The smallest of larger over smaller, 1 if the ratios pass through 1.
fn smallest_ratio(ratios: impl Iterator<Item = f64> + Clone) -> f64 {
    let (below, above) = (ratios.clone().any(|r| r <= 1.0), ratios.clone().any(|r| r >= 1.0));
    if below && above {
        return 1.0;
    }
    ratios.map(|ratio| ratio.max(1.0 / ratio)).fold(f64::INFINITY, f64::min)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::closed_form::winder::{BENCH_M5, BobbinOscillator, MASS_M5};

    fn machine(speed: f64) -> Machine {
        let mut machine = winder_linear();
        machine.override_parameter("winding_speed", speed).expect("the scene has it");
        machine
    }

    #[test]
    fn resonances_are_those_of_the_growing_mass() {
        let stage = FirstStage::of_the_scene().expect("the scene has what it needs");
        let full = BobbinOscillator { mass: MASS_M5.at(0.06), ..BENCH_M5 };
        assert!((stage.resonance.0 / BENCH_M5.natural_frequency() - 1.0).abs() < 1e-14);
        assert!((stage.resonance.1 / full.natural_frequency() - 1.0).abs() < 1e-14);
    }

    #[test]
    fn the_bench_speed_needs_more_than_the_linear_model() {
        let stage = FirstStage::of_the_scene().expect("the scene has what it needs");
        assert!(!stage.decides());
        // 5.5 m/s over 30 to 60 mm: from 183 to 92 rad/s, through 148 to 139 rad/s.
        let nearest = stage.nearest().expect("there are frequencies");
        assert_eq!((nearest.name, nearest.ratio), ("the package, once a turn", 1.0));
    }

    #[test]
    fn a_slow_winder_needs_no_more_than_the_linear_model() {
        let stage = FirstStage::walk(&machine(1.5), (0.03, 0.06)).expect("it has what it needs");
        assert!(stage.decides());
        // Twice 30 rad/s against the full package's resonance.
        assert!((stage.clearances[1].ratio - stage.resonance.1 / 60.0).abs() < 1e-12);
    }
}

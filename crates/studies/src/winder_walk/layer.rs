//! Second stage: resonances of the stiffening layer at the actual amplitude.

use std::f64::consts::TAU;

use super::{Running, Stage, Winder, clearances, ends};
use crate::closed_form::Duffing;
use crate::verify::machine::{Machine, winder_nonlinear};
use crate::verify::{CheckFailure, largest};

/// Ratio of operating frequencies and resonances from which on this stage is sufficient.
pub const ENOUGH: f64 = 1.4;

/// Number of radii.
pub(super) const RADII: u32 = 7;
/// Time after which transients have decayed to a thousandth \[s\].
pub(super) const SETTLED: f64 = 0.6;
/// Number of turns of the drum that are evaluated afterwards.
pub(super) const TURNS: f64 = 8.0;
const SAMPLES_A_TURN: f64 = 240.0;

/// Runs the scene `winder_nonlinear`, and computes the resonance at the amplitude of compression of
/// each run: the frequency of free oscillation on the layer with that amplitude, by elliptic
/// functions (the backbone curve).
///
/// # Errors
/// [`CheckFailure`] if the scene lacks a required quantity or a run stops.
pub fn stage(winder: &Winder) -> Result<Stage, CheckFailure> {
    let machine = winder_nonlinear();
    let mut spectrum = Vec::new();
    let mut running = Running::NOTHING;
    for radius in winder.radii(RADII) {
        let Steady { deflections, compressions, pressures } = steady(&machine, winder, radius)?;
        let rest = winder.pressure(radius);
        let pressures: Vec<f64> = pressures.iter().map(|beyond| rest + beyond).collect();
        running = running.worse(Running::of(&deflections, &pressures));
        spectrum.push((radius, backbone(&machine, radius, largest(&compressions))?));
    }
    let frequencies = winder.frequencies(machine.value("drum_radius")?);
    Ok(Stage {
        number: 2,
        name: "stiffening layer",
        enough: Some(ENOUGH),
        resonance: ends(&spectrum),
        clearances: clearances(&frequencies, &spectrum),
        running,
        seconds: 0.0,
    })
}

/// Returns 2 pi over the period of free oscillation with an amplitude \[m\], in rad/s.
fn backbone(machine: &Machine, radius: f64, amplitude: f64) -> Result<f64, CheckFailure> {
    let point = machine.point(&[("holder.package_radius", radius)], &[])?;
    let free = Duffing {
        mass: machine.output(&point, "mass")?,
        stiffness: machine.value("layer.stiffness")? + machine.value("holder.stiffness")?,
        cubic_stiffness: machine.value("layer.cubic_stiffness")?,
    };
    Ok(TAU / free.period(amplitude))
}

/// Steady part of a run.
pub(super) struct Steady {
    pub deflections: Vec<f64>,
    pub compressions: Vec<f64>,
    /// Pressures relative to that at rest.
    pub pressures: Vec<f64>,
}

pub(super) fn steady(
    machine: &Machine,
    winder: &Winder,
    radius: f64,
) -> Result<Steady, CheckFailure> {
    let drum = winder.speed / machine.value("drum_radius")?;
    let settings = [
        ("winding_speed", winder.speed),
        ("force_amplitude", winder.force),
        ("ovality", winder.shape),
        ("package_force", winder.package),
        ("holder.package_radius", radius),
    ];
    let times = sampled(drum);
    let until = times.last().copied().unwrap_or(SETTLED);
    let run = machine.simulation(&settings)?.until(until).times(&times).rtol(1e-8);
    let run = run.method(machinist::Method::Dop853).run()?;
    let deflections = machine.column(&run, "deflection")?.to_vec();
    let shapes = machine.column(&run, "shape")?;
    let compressions = shapes.iter().zip(&deflections).map(|(shape, x)| shape - x).collect();
    let pressures = machine.column(&run, "pressure")?.to_vec();
    Ok(Steady { deflections, compressions, pressures })
}

/// Returns equally spaced times \[s\] of the steady motion.
pub(super) fn sampled(drum: f64) -> Vec<f64> {
    let step = TAU / drum / SAMPLES_A_TURN;
    let samples = (TURNS * SAMPLES_A_TURN) as u32;
    (0..samples).map(|k| SETTLED + step * f64::from(k)).collect()
}

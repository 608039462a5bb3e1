//! First stage: the spectrum of the linear winder.

use std::f64::consts::TAU;

use super::layer::TURNS;
use super::{Operating, Running, Stage, Winder, clearances, ends};
use crate::closed_form::winder::{BobbinOscillator, Harmonic};
use crate::verify::CheckFailure;
use crate::verify::machine::{Machine, winder_linear};

/// Ratio of operating frequencies and resonances from which on this stage is sufficient.
pub const ENOUGH: f64 = 2.0;

const RADII: u32 = 61;
/// Number of samples over a turn of the drum, the period of the steady motion of a regular package.
const SAMPLES: u32 = 720;

/// Computes resonances by the emitted scene `winder_linear`, and the motion by the closed form.
///
/// # Errors
/// [`CheckFailure`] if the scene lacks a required quantity.
pub fn stage(winder: &Winder) -> Result<Stage, CheckFailure> {
    let machine = winder_linear();
    let drum_radius = machine.value("drum_radius")?;
    let mut spectrum = Vec::new();
    let mut running = Running::NOTHING;
    for radius in winder.radii(RADII) {
        spectrum.push((radius, resonance(&machine, radius)?));
        let bobbin = bobbin(&machine, radius)?;
        running = running.worse(steady(winder, &bobbin, winder.speed / drum_radius, radius));
    }
    let frequencies: [Operating; 3] = winder.frequencies(drum_radius);
    Ok(Stage {
        number: 1,
        name: "linear",
        enough: Some(ENOUGH),
        resonance: ends(&spectrum),
        clearances: clearances(&frequencies, &spectrum),
        running,
        seconds: 0.0,
    })
}

/// Returns the undamped resonance of the emitted scene, sqrt(-dv'/dx) \[rad/s\].
fn resonance(machine: &Machine, radius: f64) -> Result<f64, CheckFailure> {
    let point = machine.point(&[("holder.package_radius", radius)], &[])?;
    let jacobian = machine.rate_jacobian(&point);
    let (x, v) = (machine.state_index("holder.x")?, machine.state_index("holder.v")?);
    Ok((-jacobian[(v, x)]).sqrt())
}

/// Returns the linear bobbin of the scene at a radius of its package \[m\].
pub(crate) fn bobbin(machine: &Machine, radius: f64) -> Result<BobbinOscillator, CheckFailure> {
    let point = machine.point(&[("holder.package_radius", radius)], &[])?;
    Ok(BobbinOscillator {
        mass: machine.output(&point, "mass")?,
        viscosity: machine.value("layer.viscosity")?,
        layer_stiffness: machine.value("layer.stiffness")?,
        spring_stiffness: machine.value("holder.stiffness")?,
    })
}

/// Returns force and shape of a drum that turns with `drum` rad/s.
pub(crate) fn disturbances(winder: &Winder, drum: f64) -> [Harmonic; 2] {
    [
        Harmonic { amplitude: winder.force, frequency: drum, phase: 0.0 },
        Harmonic { amplitude: winder.shape, frequency: 2.0 * drum, phase: 0.0 },
    ]
}

/// Returns the force of a package of some radius \[m\].
pub(crate) fn package(winder: &Winder, radius: f64) -> Harmonic {
    Harmonic { amplitude: winder.package, frequency: winder.speed / radius, phase: 0.0 }
}

/// Returns the steady motion with a package of some radius \[m\] over a turn of the drum, or over
/// several turns if the package disturbs it too.
fn steady(winder: &Winder, bobbin: &BobbinOscillator, drum: f64, radius: f64) -> Running {
    let rest = winder.pressure(radius);
    let [force, shape] = disturbances(winder, drum);
    let by_package = bobbin.answer_to_force(&package(winder, radius));
    let answers = [bobbin.answer_to_force(&force), bobbin.answer_to_shape(&shape), by_package];
    let turns = if winder.package > 0.0 { TURNS as u32 } else { 1 };
    let times = (0..turns * SAMPLES).map(|k| TAU / drum * f64::from(k) / f64::from(SAMPLES));
    let motion = times.map(|time| {
        let (value, rate) = answers.iter().fold((0.0, 0.0), |(value, rate), answer| {
            let now = answer.at(time);
            (value + now.value, rate + now.rate)
        });
        let drum = shape.at(time);
        let pressure = rest
            + bobbin.layer_stiffness * (drum.value - value)
            + bobbin.viscosity * (drum.rate - rate);
        (value, pressure)
    });
    let (deflections, pressures): (Vec<f64>, Vec<f64>) = motion.unzip();
    Running::of(&deflections, &pressures)
}

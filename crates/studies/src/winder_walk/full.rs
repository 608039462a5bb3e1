//! Third stage: the winder with all nonlinearities.

use super::layer::{RADII, sampled};
use super::{Running, Stage, Winder};
use crate::verify::CheckFailure;
use crate::verify::machine::{Machine, winder_full};
use machinist::Method;

/// Runs the scene `winder_full`.
///
/// # Errors
/// [`CheckFailure`] if the scene lacks a required quantity or a run stops.
pub fn stage(winder: &Winder) -> Result<Stage, CheckFailure> {
    let machine = winder_full();
    let mut running = Running::NOTHING;
    for radius in winder.radii(RADII) {
        running = running.worse(run(&machine, winder, radius)?);
    }
    Ok(Stage {
        number: 3,
        name: "full",
        enough: None,
        resonance: None,
        clearances: Vec::new(),
        running,
        seconds: 0.0,
    })
}

/// Runs at a radius of the package until the motion is steady.
pub(super) fn run(
    machine: &Machine,
    winder: &Winder,
    radius: f64,
) -> Result<Running, CheckFailure> {
    let settings = [
        ("winding_speed", winder.speed),
        ("force_amplitude", winder.force),
        ("ovality", winder.shape),
        ("package_force", winder.package),
        ("holder.preload", winder.preload),
        ("holder.spring_share", winder.growth / machine.value("holder.stiffness")?),
        ("holder.gravity", 0.0),
        ("pair.tension", winder.tension),
        ("pair.greatest_slip", winder.elastic_slip),
        ("pair.bobbin_radius", winder.radii.0),
        ("pair.package_radius", radius),
    ];
    let times = sampled(winder.speed / machine.value("drum_radius")?);
    let until = times.last().copied().unwrap_or(1.0);
    let run = machine.simulation(&settings)?.until(until).times(&times).rtol(1e-8);
    let run = run.method(Method::Dop853).run()?;
    let column = |name: &str| machine.column(&run, name);
    let share = |values: &[f64], of: fn(f64) -> bool| {
        values.iter().filter(|value| of(**value)).count() as f64 / values.len() as f64
    };
    let slip = column("slip")?.iter().fold(0.0, |most: f64, slip| most.max(slip.abs()));
    let is_slipping = share(column("pair.slip")?, |slip| slip.abs() > 0.5);
    Ok(Running {
        open: share(column("layer.closed")?, |closed| closed < 0.5),
        slipping: is_slipping,
        // A sticking package moves with the drum except for errors of the run.
        slip: if is_slipping > 0.0 || winder.elastic_slip > 0.0 { slip } else { 0.0 },
        ..Running::of(column("deflection")?, column("pressure")?)
    })
}

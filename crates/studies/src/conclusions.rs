//! Questions of the studies' authors, answered by runs of the consistent machines:
//! which coupling a saw gin takes, where a winder winds stably, how stiff the cloth fell may be.

use crate::closed_form::winder::Harmonic;
use crate::reed_cells::Fell;
use crate::reed_study::{Beat, beat};
use crate::verify::machine::{Machine, saw_gin, winder_linear};
use crate::verify::{CheckFailure, largest};
use crate::winder_walk::Winder;
use crate::winder_walk::map::{Condition, FASTEST, StabilityMap};
use crate::winder_walk::spectrum::{bobbin, disturbances, package};
use machinist::Method;
use machinist::linear_analysis::{Mode, ModeKind, Place};

/// Largest acceleration of the saw cylinder and torque of its coupling, over the coupling.
#[derive(Debug, Clone, PartialEq)]
pub struct Couplings {
    /// Stiffnesses \[N m/rad\].
    pub stiffnesses: Vec<f64>,
    /// A row for each damping.
    pub rows: Vec<DampedCouplings>,
}

/// Couplings of one damping.
#[derive(Debug, Clone, PartialEq)]
pub struct DampedCouplings {
    /// Dissipation \[N m s/rad\].
    pub damping: f64,
    /// Largest acceleration of the cylinder over run-up and load \[rad/s^2\].
    pub accelerations: Vec<f64>,
    /// Largest torque of the coupling \[N m\].
    pub torques: Vec<f64>,
}

/// Number of stiffnesses per factor of ten, from 3 to 300 kN m/rad.
const TO_A_DECADE: i32 = 12;

impl Couplings {
    /// Runs the gin up and loads it, with half the study's dissipation, with all of it and with
    /// twice as much.
    ///
    /// # Errors
    /// [`CheckFailure`] if a run stops.
    pub fn new() -> Result<Self, CheckFailure> {
        let damping = saw_gin().value("coupling.damping")?;
        let stiffnesses: Vec<f64> = (0..=2 * TO_A_DECADE)
            .map(|k| 3e3 * 10.0_f64.powf(f64::from(k) / f64::from(TO_A_DECADE)))
            .collect();
        let row = |damping| {
            let runs = stiffnesses.iter().map(|stiffness| peaks(*stiffness, damping));
            let runs = runs.collect::<Result<Vec<_>, CheckFailure>>()?;
            let (accelerations, torques) = runs.into_iter().unzip();
            Ok(DampedCouplings { damping, accelerations, torques })
        };
        let rows = [0.5, 1.0, 2.0].map(|share| row(share * damping));
        Ok(Self { rows: rows.into_iter().collect::<Result<_, CheckFailure>>()?, stiffnesses })
    }
}

/// Largest acceleration of the cylinder \[rad/s^2\] and torque of the coupling \[N m\] over run-up
/// and load.
///
/// # Errors
/// [`CheckFailure`] if the run stops.
pub fn peaks(stiffness: f64, damping: f64) -> Result<(f64, f64), CheckFailure> {
    let machine = saw_gin();
    let settings = [("coupling.stiffness", stiffness), ("coupling.damping", damping)];
    // These samples resolve the peak of a vibration of 314 rad/s to a part in a thousand.
    let run = machine.simulation(&settings)?.until(2.0).points(8001).rtol(1e-7);
    let run = run.method(Method::Dop853).run()?;
    let peak = |name| Ok::<_, CheckFailure>(largest(machine.column(&run, name)?));
    Ok((peak("cylinder_acceleration")?, peak("coupling_torque")?))
}

/// Stiffness of the coupling \[N m/rad\] at which the load excites its eigenmode: the damped
/// frequency of the loaded machine, with the motor's fluxes, is that of the load.
///
/// # Errors
/// [`CheckFailure`] if there is no operating point.
pub fn load_resonance(damping: f64) -> Result<f64, CheckFailure> {
    let machine = saw_gin();
    let load = std::f64::consts::PI * machine.value("load.speed")? * std::f64::consts::PI / 30.0;
    let (mut low, mut high) = (3e4, 9e4);
    // To a part in a million.
    for _ in 0..20 {
        let middle = f64::midpoint(low, high);
        if coupling_frequency(&machine, middle, damping)? < load {
            low = middle;
        } else {
            high = middle;
        }
    }
    Ok(f64::midpoint(low, high))
}

/// Damped frequency \[rad/s\] of the eigenmode in which fluxes have the least share.
fn coupling_frequency(
    machine: &Machine,
    stiffness: f64,
    damping: f64,
) -> Result<f64, CheckFailure> {
    let settings = [("coupling.stiffness", stiffness), ("coupling.damping", damping)];
    let linearization = machine.linearization(&settings, Place::Equilibrium)?;
    let modes = linearization.modes()?;
    // Motions are [q, q', z], shares those of [q, z].
    let motions = linearization.motion_names().len();
    let fluxes =
        |mode: &Mode| -> f64 { mode.shares.iter().skip(motions - mode.shares.len()).sum() };
    let oscillations = modes.iter().filter(|mode| mode.kind == ModeKind::Oscillation);
    let coupling = oscillations.min_by(|a, b| fluxes(a).total_cmp(&fluxes(b)));
    Ok(coupling.map_or(f64::NAN, |mode| mode.imaginary))
}

/// Speed limits of stable winding on the bench winder, over its pressure at rest.
#[derive(Debug, Clone, PartialEq)]
pub struct StableSpeeds {
    /// Pressures with the empty bobbin \[N\].
    pub pressures: Vec<f64>,
    /// Limits for a pressure that is kept constant while the package grows.
    pub kept: Vec<Limit>,
    /// Limits if only the holder's spring presses, by equation (15).
    pub growing: Vec<Limit>,
}

/// Limit at which stability ends as the speed rises.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Limit {
    /// Largest speed up to which winding is stable at every radius \[m/s\]; 0 if there is none.
    pub speed: f64,
    /// Radius at which stability ends \[m\].
    pub radius: f64,
    /// Condition that fails there.
    pub condition: Condition,
    /// Disturbance that varies the pressure most there.
    pub disturbance: Disturbance,
}

/// A disturbance of the bobbin.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Disturbance {
    /// The drum's unbalance, once a turn.
    Unbalance,
    /// The drum's shape, twice a turn.
    Shape,
    /// An irregular package, once a turn.
    Package,
}

impl Disturbance {
    /// Returns a description.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Unbalance => "the drum's unbalance, once a turn",
            Self::Shape => "the drum's shape, twice a turn",
            Self::Package => "the package, once a turn",
        }
    }
}

impl StableSpeeds {
    /// Computes limits for pressures from 10 N to the limit of the yarn.
    ///
    /// # Errors
    /// [`CheckFailure`] if a scene lacks a required quantity.
    pub fn new() -> Result<Self, CheckFailure> {
        let bench = Winder::at_speed(winder_linear().value("winding_speed")?)?;
        let growth = winder_linear().value("holder.stiffness")?;
        let count = (bench.largest / 10.0).ceil() as u32;
        let pressures: Vec<f64> = (1..count).map(|k| 10.0 * f64::from(k)).collect();
        let limits = |growth| -> Result<Vec<Limit>, CheckFailure> {
            pressures.iter().map(|n| limit(&Winder { preload: *n, growth, ..bench })).collect()
        };
        Ok(Self { kept: limits(0.0)?, growing: limits(growth)?, pressures })
    }
}

/// Returns the stability limit of a winder with increasing speed.
///
/// # Errors
/// [`CheckFailure`] if a scene lacks a required quantity.
pub fn limit(winder: &Winder) -> Result<Limit, CheckFailure> {
    let map = StabilityMap::of(winder, FASTEST)?;
    let fails = |row: &usize| map.cells[*row].iter().any(|c| c.condition != Condition::Stable);
    let row = (0..map.speeds.len()).find(fails).unwrap_or(map.speeds.len() - 1);
    let cells = &map.cells[row];
    let column = cells.iter().position(|cell| cell.condition != Condition::Stable).unwrap_or(0);
    let (speed, radius) = (map.speeds[row], map.radii[column]);
    let machine = winder_linear();
    let there = winder.winding_at(speed);
    let bobbin = bobbin(&machine, radius)?;
    let [force, shape] = disturbances(&there, speed / machine.value("drum_radius")?);
    let by = |forces: &[Harmonic], shapes: &[Harmonic]| bobbin.pressure_variation(forces, shapes);
    let shares = [
        (by(&[force], &[]), Disturbance::Unbalance),
        (by(&[], &[shape]), Disturbance::Shape),
        (by(&[package(&there, radius)], &[]), Disturbance::Package),
    ];
    let largest = shares.iter().max_by(|a, b| a.0.total_cmp(&b.0));
    Ok(Limit {
        speed: if row == 0 { 0.0 } else { map.speeds[row - 1] },
        radius,
        condition: cells[column].condition,
        disturbance: largest.map_or(Disturbance::Unbalance, |(_, disturbance)| *disturbance),
    })
}

/// Figure 8: the pressure over the radius of the package, and its allowed window.
#[derive(Debug, Clone, PartialEq)]
pub struct PressureWindow {
    /// Winding speed \[m/s\].
    pub speed: f64,
    /// Radii \[m\].
    pub radii: Vec<f64>,
    /// N \[N\].
    pub pressure: Vec<f64>,
    /// \[Nmin\] + dN \[N\].
    pub least: Vec<f64>,
    /// \[Nmax\] - dN \[N\].
    pub most: Vec<f64>,
}

impl PressureWindow {
    /// Computes the window of a winder at its speed.
    ///
    /// # Errors
    /// [`CheckFailure`] if a scene lacks a required quantity.
    pub fn of(winder: &Winder) -> Result<Self, CheckFailure> {
        // The last row of a map that ends at the winder's speed.
        let map = StabilityMap::of(winder, winder.speed)?;
        let cells = map.cells.last().into_iter().flatten();
        let bands = map.radii.iter().zip(cells).map(|(radius, cell)| {
            let radii = (*radius, *radius);
            let limits = &map.limits;
            limits.pair.pressure_band(limits.tension, radii, limits.largest, cell.variation)
        });
        let (least, most) = bands.map(|band| (band.least, band.most)).unzip();
        let pressure = map.radii.iter().map(|radius| winder.pressure(*radius)).collect();
        Ok(Self { speed: winder.speed, radii: map.radii, pressure, least, most })
    }
}

/// Runs the reed against a fell that only pushes, for several stiffnesses.
///
/// # Errors
/// [`CheckFailure`] if a run stops.
pub fn fells() -> Result<Vec<Beat>, CheckFailure> {
    (0..=8).map(|k| beat(Fell::OnlyPushes, 0.25 * f64::from(k))).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_soft_coupling_spares_the_cylinder_and_one_near_the_transient_does_not() {
        let damping = 128.5346;
        let acceleration = |stiffness| peaks(stiffness, damping).expect("it runs").0;
        let [soft, given, near, stiff] = [11e3, 23_065.2, 112e3, 200e3].map(acceleration);
        assert!((soft - 277.0).abs() < 10.0, "{soft}");
        assert!((near - 841.0).abs() < 10.0 && (stiff - 595.0).abs() < 10.0, "{near} {stiff}");
        assert!(given > soft && given < near);
    }

    #[test]
    fn the_load_excites_the_coupling_at_the_stiffness_where_their_frequencies_meet() {
        let stiffness = load_resonance(128.5346).expect("it has an operating point");
        assert!((stiffness / 59.7e3 - 1.0).abs() < 0.01, "{stiffness}");
        // A motor without fluxes would leave Jr ((pi w2)^2 + (b/(2 Jr))^2).
        let (reduced, load) = (4.2 * 1.244 / 5.444_f64, 241.805_f64);
        let alone = reduced * (load * load + (128.5346 / (2.0 * reduced)).powi(2));
        assert!((stiffness / alone - 1.0).abs() < 0.02, "{stiffness} {alone}");
    }

    #[test]
    fn stability_ends_between_the_last_stable_speed_and_the_next() {
        let bench = Winder::at_speed(5.5).expect("it has what it needs");
        for (preload, growth) in [(40.0, 0.0), (100.0, 0.0), (40.0, 3800.0)] {
            let winder = Winder { preload, growth, ..bench };
            let found = limit(&winder).expect("it has what it needs");
            let stable = |speed: f64| {
                let window =
                    PressureWindow::of(&winder.winding_at(speed)).expect("it has what it needs");
                let within =
                    |k: usize| (window.least[k]..=window.most[k]).contains(&window.pressure[k]);
                (0..window.radii.len()).all(within)
            };
            assert!(stable(found.speed), "{found:?}");
            assert!(!stable(found.speed + 1.001 * FASTEST / 141.0), "{found:?}");
        }
    }

    #[test]
    fn a_stiffer_fell_stops_the_reed_earlier_and_stresses_the_shaft_more() {
        let fells = fells().expect("it runs");
        for pair in fells.windows(2) {
            assert!(pair[1].forward() < pair[0].forward());
            assert!(pair[1].largest()[2] > pair[0].largest()[2]);
        }
    }
}

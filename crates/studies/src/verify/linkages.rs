//! Checks of machines held together by constraints, against minimal coordinates,
//! kinematics in closed form, energy and virtual work.

use super::machine;
use super::sensitivities::{SMOOTH, against_differences};
use super::{Check, CheckFailure, Machine, Measured, relative_distance, worse};
use crate::closed_form::four_bar::FOUR_BAR;
use crate::closed_form::pendulum_chain::CHAIN;
use crate::closed_form::slider_crank::{SLIDER_CRANK, SliderCrankState};
use machinist::constraints::start;
use machinist::linear_analysis::{Linearization, Mode, ModeKind, Place, Point, equilibrium};
use machinist::{Method, Trajectory};

const EIGENVALUES: &str = "both are algebra; rounding, grown by eight coordinates solved together";

pub(super) const RELATIVE_CHECKS: &[Check] = &[
    Check {
        name: "motion over 5 s",
        reference: "pendulum_chain, in absolute angles, relative to the largest",
        tolerance: 1e-8,
        reason: "both are held to 1e-12 a step, and errors grow a hundredfold over 5 s",
        measure: minimal,
    },
    Check {
        name: "frequencies of small oscillations about hanging at rest",
        reference: "three eigenvalues in absolute angles by hand, relative",
        tolerance: 1e-11,
        reason: "both are algebra; rounding is left",
        measure: |machine| {
            let names = ["chain.th_1", "chain.th_2", "chain.th_3"];
            let guess = machine.point(&[], &names.map(|name| (name, 0.05)))?;
            let guess = Point { time: 0.0, state: guess.state, parameters: guess.parameters };
            let point = equilibrium(machine.real, &guess)?;
            let modes = Linearization::at(machine.real, point)?.modes()?;
            let found: Vec<f64> = modes.iter().map(Mode::natural_frequency).collect();
            Ok(found_is(&[found.clone(), found], &CHAIN.frequencies()))
        },
    },
];

pub(super) const PENDULUM_CHECKS: &[Check] = &[
    Check {
        name: "motion over 5 s",
        reference: "pendulum_chain, in minimal coordinates, relative to the largest",
        tolerance: 1e-8,
        reason: "both are held to 1e-12 a step, and errors grow a hundredfold over 5 s",
        measure: minimal,
    },
    Check {
        name: "force in the last link over 5 s",
        reference: "its mass times its acceleration by hand, along the link",
        tolerance: 1e-8,
        reason: "as the motion",
        measure: force,
    },
    Check {
        name: "frequencies of small oscillations about hanging at rest",
        reference: "three eigenvalues in minimal coordinates by hand, relative",
        tolerance: 1e-11,
        reason: EIGENVALUES,
        measure: hanging,
    },
];

pub(super) const SLIDER_CRANK_CHECKS: &[Check] = &[
    Check {
        name: "rod angle, stroke, speed and acceleration over 1 s",
        reference: "kinematics, relative to the largest of each",
        tolerance: 1e-9,
        reason: "the run is held to 1e-12 a step",
        measure: kinematics,
    },
    Check {
        name: "torque of the drive over 1 s",
        reference: "virtual work, relative to the largest",
        tolerance: 1e-8,
        reason: "the run is held to 1e-12 a step",
        measure: torque,
    },
    Check {
        name: "motions that the constraints leave at the start",
        reference: "none: the drive prescribes all",
        tolerance: 0.0,
        reason: "a count",
        measure: |machine| {
            let modes = machine.linearization(&[], Place::Initial)?.modes()?;
            Ok(super::counted(modes.len() as u64, 0))
        },
    },
    Check {
        name: "sensitivities over 0.3 s",
        reference: "central differences of sixth order, over the largest of each",
        tolerance: 1e-8,
        reason: SMOOTH,
        measure: |machine| {
            let by = ["rod.length", "speed"];
            against_differences(machine, &by, (0.3, 21), 1e-3)
        },
    },
];

pub(super) const FOUR_BAR_CHECKS: &[Check] = &[
    Check {
        name: "angles of coupler and rocker over 2 s",
        reference: "Freudenstein's equation at the crank's angle, relative to the largest",
        tolerance: 1e-12,
        reason: "every state is put back onto the constraints; rounding is left",
        measure: freudenstein,
    },
    Check {
        name: "speed of the crank over 2 s",
        reference: "energy in one coordinate, at the crank's angle, relative to the largest",
        tolerance: 1e-9,
        reason: "the run is held to 1e-12 a step",
        measure: speed,
    },
    Check {
        name: "frequency of small oscillations about its lowest position",
        reference: "V''/I in the crank's angle by virtual work, relative",
        tolerance: 1e-11,
        reason: EIGENVALUES,
        measure: |machine| {
            let (_, frequency) = FOUR_BAR.small_oscillation(-1.5);
            let found = swings(machine, &[("angle", -1.3), ("speed", 0.0)])?;
            Ok(found_is(&found, &[frequency]))
        },
    },
    Check {
        name: "angles of crank, coupler and rocker at rest there",
        reference: "V' = 0 by virtual work, and Freudenstein's equation; rad",
        tolerance: 1e-12,
        reason: "both are solved to rounding",
        measure: lowest,
    },
    Check {
        name: "sensitivities over 0.3 s",
        reference: "central differences of sixth order, over the largest of each",
        tolerance: 1e-8,
        reason: SMOOTH,
        measure: |machine| {
            let by = ["crank.length", "angle", "coupler.mass"];
            against_differences(machine, &by, (0.3, 21), 1e-3)
        },
    },
];

fn run(machine: &Machine, rtol: f64) -> Result<Trajectory, CheckFailure> {
    Ok(machine.simulation(&[])?.rtol(rtol).method(Method::Dop853).run()?)
}

fn minimal(machine: &Machine) -> Result<Measured, CheckFailure> {
    let (ours, theirs) = (run(machine, 1e-12)?, run(&machine::pendulum_chain(), 1e-12)?);
    let mut error = 0.0;
    for name in ["end_x", "end_y"] {
        let reference = theirs.column(name).unwrap_or_default();
        error = worse(error, relative_distance(machine.column(&ours, name)?, reference));
    }
    Ok(Measured::error(error))
}

/// Compares lambda with m (a + g) e, e along the link outwards, with a from the chain's own
/// equations.
fn force(machine: &Machine) -> Result<Measured, CheckFailure> {
    let (ours, theirs) = (run(machine, 1e-12)?, run(&machine::pendulum_chain(), 1e-12)?);
    let column = |name: &str| theirs.column(name).unwrap_or_default();
    let angles = ["chain.th_1", "chain.th_2", "chain.th_3"].map(column);
    let speeds = ["chain.w_1", "chain.w_2", "chain.w_3"].map(column);
    let forces = (0..theirs.times.len()).map(|sample| {
        let angle = angles.map(|angle| angle.get(sample).copied().unwrap_or(f64::NAN));
        let speed = speeds.map(|speed| speed.get(sample).copied().unwrap_or(f64::NAN));
        let turning = CHAIN.accelerations(angle, speed);
        let (along_x, along_y) = (angle[2].sin(), -angle[2].cos());
        let (mut x, mut y) = (0.0, CHAIN.gravity);
        for link in 0..3 {
            let (sin, cos) = angle[link].sin_cos();
            let square = speed[link] * speed[link];
            x += CHAIN.lengths[link] * (cos * turning[link] - sin * square);
            y += CHAIN.lengths[link] * (sin * turning[link] + cos * square);
        }
        CHAIN.masses[2] * (x * along_x + y * along_y)
    });
    let forces: Vec<f64> = forces.collect();
    Ok(Measured::error(relative_distance(machine.column(&ours, "force_3")?, &forces)))
}

/// A column with its reference.
type Wanted = (&'static str, fn(&SliderCrankState) -> f64);

fn distances(machine: &Machine, wanted: &[Wanted]) -> Result<Measured, CheckFailure> {
    let run = run(machine, 1e-12)?;
    let states: Vec<_> =
        run.times.iter().map(|time| SLIDER_CRANK.at(0.4 + SLIDER_CRANK.speed * time)).collect();
    let mut error = 0.0;
    for (name, of) in wanted {
        let exact: Vec<f64> = states.iter().map(of).collect();
        error = worse(error, relative_distance(machine.column(&run, name)?, &exact));
    }
    Ok(Measured::error(error))
}

fn kinematics(machine: &Machine) -> Result<Measured, CheckFailure> {
    distances(
        machine,
        &[
            ("rod_angle", |state| state.rod_angle),
            ("stroke", |state| state.stroke),
            ("slider_speed", |state| state.slider_speed),
            ("slider_acceleration", |state| state.slider_acceleration),
        ],
    )
}

fn torque(machine: &Machine) -> Result<Measured, CheckFailure> {
    distances(machine, &[("torque", |state| state.torque)])
}

fn freudenstein(machine: &Machine) -> Result<Measured, CheckFailure> {
    let run = run(machine, 1e-10)?;
    let crank = machine.column(&run, "crank_angle")?;
    let (coupler, rocker): (Vec<f64>, Vec<f64>) =
        crank.iter().map(|angle| FOUR_BAR.angles(*angle)).unzip();
    let coupler = relative_distance(machine.column(&run, "coupler_angle")?, &coupler);
    let rocker = relative_distance(machine.column(&run, "rocker_angle")?, &rocker);
    Ok(Measured::error(worse(coupler, rocker)))
}

fn speed(machine: &Machine) -> Result<Measured, CheckFailure> {
    let run = run(machine, 1e-12)?;
    let crank = machine.column(&run, "crank_angle")?;
    let exact: Vec<f64> = crank.iter().map(|angle| FOUR_BAR.speed(*angle, (1.5, 25.0))).collect();
    Ok(Measured::error(relative_distance(machine.column(&run, "crank_speed")?, &exact)))
}

/// Returns the equilibrium near a start with other parameters.
fn rest<'m>(
    machine: &'m Machine,
    settings: &[(&str, f64)],
) -> Result<Linearization<'m>, CheckFailure> {
    let parameters = machine.parameters(settings)?;
    let state = start(machine.real, &parameters, 0.0)?;
    let point = equilibrium(machine.real, &Point { time: 0.0, state, parameters })?;
    Ok(Linearization::at(machine.real, point)?)
}

/// Returns the frequencies \[rad/s\] of oscillations about the equilibrium, ascending, in two ways:
/// from eigenvalues of the rate, and from stiffness and mass. The worse one counts.
fn swings(machine: &Machine, settings: &[(&str, f64)]) -> Result<[Vec<f64>; 2], CheckFailure> {
    let linearization = rest(machine, settings)?;
    let modes = linearization.modes()?;
    let is_swing = |mode: &&Mode| mode.kind == ModeKind::Oscillation;
    let of_rate = modes.iter().filter(is_swing).map(Mode::natural_frequency).collect();
    Ok([of_rate, linearization.second_order()?.undamped_frequencies()?])
}

fn found_is(found: &[Vec<f64>; 2], exact: &[f64]) -> Measured {
    let error = |found: &Vec<f64>| {
        let is_complete = found.len() == exact.len();
        let off = found.iter().zip(exact).map(|(found, exact)| (found / exact - 1.0).abs());
        if is_complete { off.fold(0.0, worse) } else { f64::NAN }
    };
    Measured::error(found.iter().map(error).fold(0.0, worse))
}

/// Starts slightly off the hanging position.
fn hanging(machine: &Machine) -> Result<Measured, CheckFailure> {
    let near = [("th_1", 0.1), ("th_2", -0.05), ("th_3", 0.15)];
    let found = swings(machine, &near)?;
    Ok(found_is(&found, &CHAIN.frequencies()))
}

fn lowest(machine: &Machine) -> Result<Measured, CheckFailure> {
    let linearization = rest(machine, &[("angle", -1.3), ("speed", 0.0)])?;
    let state = &linearization.point().state;
    let (crank, _) = FOUR_BAR.small_oscillation(-1.5);
    let (coupler, rocker) = FOUR_BAR.angles(crank);
    let mut error = 0.0;
    for (name, exact) in [("crank.phi", crank), ("coupler.phi", coupler), ("rocker.phi", rocker)] {
        error = worse(error, (state[machine.state_index(name)?] - exact).abs());
    }
    Ok(Measured::error(error))
}

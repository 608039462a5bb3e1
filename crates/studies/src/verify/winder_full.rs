//! Checks of the bobbin with all nonlinearities: each of them alone against its closed form,
//! and without them the second stage of modelling.

use super::sensitivities::{ACROSS, against_differences};
use super::{Check, CheckFailure, Machine, Measured, counted, machine, relative_distance, worse};
use crate::closed_form::BouncingBobbin;
use crate::closed_form::winder::{BENCH_BOBBIN, BENCH_FORCE, BENCH_MASS, BENCH_SHAPE, ReducedMass};
use crate::closed_form::winding_pair::{
    WindingPair, package_radius, package_speed, pressure_over_growth,
};
use machinist::Method;

const HELD: &str = "the run is held to 1e-12 a step; some thousand steps add up";
const COUNT: &str = "a count";

pub(super) const CHECKS: &[Check] = &[
    Check {
        name: "radius and speed of the package from empty to full, thread as thick as a rope",
        reference: "R^2 = Rmin^2 + V' t/(pi H) and w = v/R, relative",
        tolerance: 1e-10,
        reason: HELD,
        measure: growth,
    },
    Check {
        name: "mass of the full package",
        reference: "m0 + mn (lbc/lab)^2 + density times the volume of thread wound, relative",
        tolerance: 1e-10,
        reason: HELD,
        measure: wound,
    },
    Check {
        name: "pressure on the package from empty to full",
        reference: "(15): the spring takes the growth, the package its weight, relative",
        tolerance: 1e-10,
        reason: HELD,
        measure: pressing,
    },
    Check {
        name: "transient, pressed too hard to lose contact",
        reference: "winder_nonlinear, deflection and velocity relative to the largest",
        tolerance: 1e-10,
        reason: HELD,
        measure: without_loss,
    },
    Check {
        name: "bouncing over 0.4 s on a linear layer",
        reference: "stitched exact motions, deflection, velocity, layer and pressure, relative",
        tolerance: 1e-8,
        reason: "errors of a step grow at each loss of contact",
        measure: bouncing,
    },
    Check {
        name: "losses of contact and touches in that time",
        reference: "stitched exact motions, counted",
        tolerance: 0.0,
        reason: COUNT,
        measure: switches,
    },
    Check {
        name: "least pressure that turns packages of 25 to 60 mm, to a millionth",
        reference: "Pn = N (f - (fa r + k)/R), radii and sides of it that are wrong",
        tolerance: 0.0,
        reason: COUNT,
        measure: adhesion,
    },
    Check {
        name: "drum that speeds up and brakes, packages of 30 to 60 mm, to a millionth",
        reference: "conditions (4) to (6), radii and sides of them that are wrong",
        tolerance: 0.0,
        reason: COUNT,
        measure: speeding,
    },
    Check {
        name: "package that lags behind, over 0.5 s, at half that pressure",
        reference: "w falls by the missing moment over JA, relative",
        tolerance: 1e-12,
        reason: "linear in time; rounding is left",
        measure: lagging,
    },
    Check {
        name: "elastic slip at constant pressure, of packages of 30 to 60 mm, to its limit and beyond",
        reference: "w by the share of f N in use, exponentially, then evenly slower, relative",
        tolerance: 1e-9,
        reason: "some thousand steps add up, and slipping begins within a tolerance",
        measure: elastic_slip,
    },
    Check {
        name: "sensitivities over 0.1 s, the package leaving the drum",
        reference: "central differences of sixth order, over the largest of each",
        tolerance: 1e-6,
        reason: ACROSS,
        measure: |machine| {
            let by = ["layer.stiffness", "force_amplitude", "holder.preload", "pair.friction"];
            against_differences(machine, &by, (0.1, 41), 1e-4)
        },
    },
];

/// Settings without disturbances and growth.
const STEADY: [(&str, f64); 3] =
    [("force_amplitude", 0.0), ("ovality", 0.0), ("pair.thread_area", 0.0)];

/// Settings for a pressure that does not grow with the package.
const KEPT: [(&str, f64); 2] = [("holder.spring_share", 0.0), ("holder.gravity", 0.0)];

const PAIR: WindingPair = WindingPair { friction: 0.18, support_arm: 4e-4, rolling_arm: 6e-4 };
const TENSION: f64 = 0.6;

/// Settings for a whole package of a thread of 57 mm^2 in 4 s.
const ROPE: [(&str, f64); 3] =
    [("force_amplitude", 0.0), ("ovality", 0.0), ("pair.thread_area", 5.7e-5)];

fn growth(machine: &Machine) -> Result<Measured, CheckFailure> {
    let run = machine.simulation(&ROPE)?.until(4.0).points(401).rtol(1e-12).run()?;
    let radii: Vec<f64> =
        run.times.iter().map(|time| package_radius(*time, 0.03, 0.15, 5.7e-5 * 5.5)).collect();
    let speeds: Vec<f64> =
        radii.iter().map(|radius| package_speed(5.5 / 0.05, 0.05, *radius, 0.0)).collect();
    let radius = relative_distance(machine.column(&run, "pair.radius")?, &radii);
    let speed = relative_distance(machine.column(&run, "pair.omega")?, &speeds);
    Ok(Measured::error(worse(radius, speed)))
}

fn wound(machine: &Machine) -> Result<Measured, CheckFailure> {
    let run = machine.simulation(&ROPE)?.until(4.0).points(2).rtol(1e-12).run()?;
    let wound = 350.0 * 5.7e-5 * 5.5 * 4.0;
    Ok(Measured::relative(
        machine.last(&run, "mass")?,
        1.5 + 0.9 * (0.1_f64 / 0.15).powi(2) + wound,
    ))
}

fn pressing(machine: &Machine) -> Result<Measured, CheckFailure> {
    let mut error = 0.0;
    for (share, gravity) in [(1.0, 9.81), (0.25, 9.81), (0.0, 9.81), (1.0, 0.0)] {
        let mut settings = ROPE.to_vec();
        settings.extend([("holder.spring_share", share), ("holder.gravity", gravity)]);
        let run = machine.simulation(&settings)?.until(4.0).points(401).rtol(1e-12).run()?;
        let exact: Vec<f64> = run
            .times
            .iter()
            .map(|time| {
                let radius = package_radius(*time, 0.03, 0.15, 5.7e-5 * 5.5);
                let grown = |spring| pressure_over_growth(0.0, spring, &BENCH_MASS, radius);
                40.0 + grown(3800.0 * share) - (1.0 - gravity / 9.81) * grown(0.0)
            })
            .collect();
        error = worse(error, relative_distance(machine.column(&run, "pressure")?, &exact));
    }
    Ok(Measured::error(error))
}

fn without_loss(machine: &Machine) -> Result<Measured, CheckFailure> {
    let settings = [("holder.preload", 200.0), ("pair.thread_area", 0.0), ("package_force", 10.0)];
    let run = |machine: &Machine, settings: &[(&str, f64)]| {
        let run = machine.simulation(settings)?.until(0.5).points(1001).rtol(1e-12);
        Ok::<_, CheckFailure>(run.method(Method::Dop853).run()?)
    };
    let full = run(machine, &settings)?;
    let second = run(&machine::winder_nonlinear(), &settings[2..])?;
    let mut error = if full.work.switches == 1 { 0.0 } else { f64::NAN };
    for name in ["holder.x", "holder.v"] {
        let exact = machine.column(&second, name)?;
        error = worse(error, relative_distance(machine.column(&full, name)?, exact));
    }
    Ok(Measured::error(error))
}

const LINEAR: [(&str, f64); 2] = [("layer.cubic_stiffness", 0.0), ("pair.thread_area", 0.0)];
const BENCH: BouncingBobbin =
    BouncingBobbin { bobbin: BENCH_BOBBIN, preload: 40.0, force: BENCH_FORCE, shape: BENCH_SHAPE };

fn bouncing(machine: &Machine) -> Result<Measured, CheckFailure> {
    let run = machine.simulation(&LINEAR)?.until(0.4).points(1001).rtol(1e-12);
    let run = run.method(Method::Dop853).run()?;
    let (exact, _) = BENCH.motion(&run.times);
    let mut error = 0.0;
    let of = |of: fn(&crate::closed_form::bouncing_bobbin::Bounced) -> f64| {
        exact.iter().map(of).collect::<Vec<f64>>()
    };
    for (name, exact) in [
        ("holder.x", of(|now| now.deflection.value)),
        ("holder.v", of(|now| now.deflection.rate)),
        ("layer.surface", of(|now| now.surface)),
        ("pressure", of(|now| now.pressure)),
    ] {
        error = worse(error, relative_distance(machine.column(&run, name)?, &exact));
    }
    Ok(Measured::error(error))
}

fn switches(machine: &Machine) -> Result<Measured, CheckFailure> {
    let run = machine.simulation(&LINEAR)?.until(0.4).points(2).rtol(1e-10);
    let run = run.method(Method::Dop853).run()?;
    let of_layer = run.switches.iter().filter(|switch| switch.event.starts_with("layer."));
    let (_, exact) = BENCH.motion(&[0.4]);
    Ok(counted(of_layer.count() as u64, exact))
}

/// Checks that a package sticks from a millionth above the least pressure on, and slips below,
/// whether its growth adds to the pressure or not.
fn adhesion(machine: &Machine) -> Result<Measured, CheckFailure> {
    let mut wrong = 0;
    for radius in [0.025, 0.03, 0.04, 0.05, 0.06] {
        // The rule of practice is not a limit of the machine.
        let least = TENSION / (PAIR.friction - (PAIR.support_arm + PAIR.rolling_arm) / radius);
        let empty = ReducedMass { bobbin_radius: 0.025, ..BENCH_MASS };
        let grown = pressure_over_growth(0.0, 3800.0, &empty, radius);
        let sides = [(1.0 - 1e-6, -1.0), (1.0 + 1e-6, 0.0)];
        let sides =
            sides.iter().flat_map(|side| [(*side, KEPT.as_slice(), 0.0), (*side, &[], grown)]);
        for ((share, slip), growth, grown) in sides {
            let mut settings = STEADY.to_vec();
            settings.extend([("pair.package_radius", radius), ("pair.bobbin_radius", 0.025)]);
            settings.extend(growth);
            settings.push(("holder.preload", share * least - grown));
            let run = machine.simulation(&settings)?.until(0.1).points(2).run()?;
            wrong += u64::from((machine.last(&run, "pair.slip")? - slip).abs() > 0.0);
        }
    }
    Ok(counted(wrong, 0))
}

/// Checks that a package sticks to a drum that speeds up or brakes until N f R is less than |Pn R +
/// N (fa r + k) + JA e|, and slips beyond.
fn speeding(machine: &Machine) -> Result<Measured, CheckFailure> {
    const PRESSURE: f64 = 40.0;
    let mut wrong = 0;
    for radius in [0.03_f64, 0.04, 0.06] {
        let ring = radius.powi(4) - 0.03_f64.powi(4);
        let inertia = 6e-4 + std::f64::consts::PI * ring * 0.15 * 350.0 / 2.0;
        let friction = PRESSURE * PAIR.friction * radius;
        let resisting = TENSION * radius + PRESSURE * (PAIR.support_arm + PAIR.rolling_arm);
        for (moment, side) in [(friction - resisting, -1.0), (-friction - resisting, 1.0)] {
            let limit = moment / inertia * radius;
            for (share, slip) in [(1.0 + 1e-6, side), (1.0 - 1e-6, 0.0)] {
                let mut settings = STEADY.to_vec();
                settings.extend([("pair.package_radius", radius), ("acceleration", share * limit)]);
                settings.extend(KEPT);
                let run = machine.simulation(&settings)?.until(0.01).points(2).run()?;
                wrong += u64::from((machine.last(&run, "pair.slip")? - slip).abs() > 0.0);
            }
        }
    }
    Ok(counted(wrong, 0))
}

/// Compares speeds of a package that slips elastically, J w' = (f N nu/nu_e - resistance) R, with
/// nu = 1 - R w/v: nu tends to nu_e resistance/(f N) exponentially. Where the resistance exceeds f N,
/// it passes nu_e, and then w falls evenly.
fn elastic_slip(machine: &Machine) -> Result<Measured, CheckFailure> {
    const PRESSURE: f64 = 40.0;
    const SPEED: f64 = 5.5;
    let mut error = 0.0;
    for (radius, tension, most) in
        [(0.03_f64, 0.6, 0.04), (0.045, 4.0, 0.04), (0.06, 2.0, 0.01), (0.03, 9.0, 0.04)]
    {
        let mut settings = STEADY.to_vec();
        settings.extend([
            ("pair.package_radius", radius),
            ("pair.tension", tension),
            ("pair.greatest_slip", most),
        ]);
        settings.extend(KEPT);
        let run = machine.simulation(&settings)?.until(0.5).points(101).rtol(1e-12);
        let run = run.method(Method::Dop853).run()?;
        let ring = radius.powi(4) - 0.03_f64.powi(4);
        let inertia = 6e-4 + std::f64::consts::PI * ring * 0.15 * 350.0 / 2.0;
        let limit = PAIR.friction * PRESSURE;
        let resistance = tension + PRESSURE * (PAIR.support_arm + PAIR.rolling_arm) / radius;
        let settled = most * resistance / limit;
        let rate = limit * radius * radius / (inertia * most * SPEED);
        let reached = if settled > most { -(1.0 - most / settled).ln() / rate } else { 1.0 };
        let speeds: Vec<f64> = run
            .times
            .iter()
            .map(|time| {
                let slip = settled * (1.0 - (-rate * time.min(reached)).exp());
                let beyond = (limit - resistance) * radius / inertia * (time - reached).max(0.0);
                SPEED * (1.0 - slip) / radius + beyond
            })
            .collect();
        error = worse(error, relative_distance(machine.column(&run, "pair.omega")?, &speeds));
    }
    Ok(Measured::error(error))
}

fn lagging(machine: &Machine) -> Result<Measured, CheckFailure> {
    let pressure = 0.5 * PAIR.least_pressure(TENSION, 0.03);
    let mut settings = STEADY.to_vec();
    settings.push(("holder.preload", pressure));
    let run = machine.simulation(&settings)?.until(0.5).points(101).rtol(1e-12).run()?;
    let margin = PAIR.adhesion_margin(pressure, TENSION, 0.03, 0.0, 0.0);
    let speeds: Vec<f64> = run.times.iter().map(|time| 5.5 / 0.03 + margin / 6e-4 * time).collect();
    Ok(Measured::error(relative_distance(machine.column(&run, "pair.omega")?, &speeds)))
}

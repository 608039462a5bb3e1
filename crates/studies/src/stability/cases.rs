//! The cases of the study, part by part.

use std::f64::consts::TAU;

use machinist_contract::Simulator;
use machinist_scenes::scenes;

use super::machines::{DAHLQUIST, PROTHERO_ROBINSON, PULSE, PULSE_START, ROBERTSON, VAN_DER_POL};
use super::truth::Truth;
use super::{Case, POWERS, contacts};
use crate::closed_form::two_mass::{Motion, SAW_GIN, Torques, Twist, TwoMass};

/// Returns all cases, without those of absent scenes.
pub(super) fn all() -> Vec<Case> {
    let parts = [
        scalar_tests(),
        stiff_tests(),
        two_masses(),
        scaled_units(),
        many_periods(),
        pulses(),
        saw_gins(),
        contacts::all(),
        conservative(),
    ];
    parts.into_iter().flatten().collect()
}

fn scalar_tests() -> Vec<Case> {
    let dahlquist = POWERS.map(|power| {
        let lambda = -10f64.powi(power);
        Case {
            part: "Dahlquist",
            name: format!("lambda = {lambda:.0e}"),
            simulator: &DAHLQUIST,
            settings: vec![("lambda", lambda)],
            times: vec![0.0, 0.5 / lambda.abs(), 0.5, 2.0],
            truth: Truth::Closed("e^(lambda t)", Box::new(move |t| vec![(lambda * t).exp()])),
        }
    });
    let prothero_robinson = POWERS.map(|power| {
        let lambda = -10f64.powi(power);
        Case {
            part: "Prothero-Robinson",
            name: format!("lambda = {lambda:.0e}"),
            simulator: &PROTHERO_ROBINSON,
            settings: vec![("lambda", lambda)],
            times: vec![0.0, 0.7, 1.9, 3.0],
            truth: Truth::Closed("cos t", Box::new(|t| vec![t.cos()])),
        }
    });
    dahlquist.into_iter().chain(prothero_robinson).collect()
}

fn stiff_tests() -> Vec<Case> {
    // 1/epsilon is the square of van der Pol's mu.
    let van_der_pol = [0, 2, 4, 6, 8, 10, 12].map(|power| Case {
        part: "van der Pol",
        name: format!("mu = {:.0e}", 10f64.powi(power / 2)),
        simulator: &VAN_DER_POL,
        settings: vec![("epsilon", 10f64.powi(-power))],
        times: vec![0.3, 0.6, 1.2, 2.0],
        truth: Truth::Converged,
    });
    let robertson = [40.0, 4e3, 4e5, 4e7, 1e9, 1e11].map(|until| Case {
        part: "Robertson",
        name: format!("until {until:.0e} s"),
        simulator: &ROBERTSON,
        settings: Vec::new(),
        times: vec![0.5 * until, until],
        truth: Truth::Converged,
    });
    van_der_pol.into_iter().chain(robertson).collect()
}

/// Returns a run of the scene `two_mass` from a twist of `start`, under `torques`.
fn two_mass(
    part: &'static str,
    name: String,
    machine: TwoMass,
    (start, torques): (f64, Torques),
    times: Vec<f64>,
) -> Option<Case> {
    let simulator = scenes::find_f64("two_mass")?;
    let settings = vec![
        ("driver.inertia", machine.driver_inertia),
        ("cylinder.inertia", machine.driven_inertia),
        ("coupling.stiffness", machine.stiffness),
        ("coupling.damping", machine.damping),
        ("drive_torque", torques.driving),
        ("load_torque", torques.load),
        ("load_amplitude", torques.load_amplitude),
        ("load_frequency", torques.load_frequency),
        ("initial_twist", start),
    ];
    let closed = move |t| {
        let start = Motion { driver_angle: start, ..Motion::default() };
        // The twist is not a difference of growing angles, since a stiff coupling hardly twists.
        let twist = machine.twist(t, start.twist(), torques);
        let motion = machine.motion(t, start, torques);
        vec![twist.angle, motion.driver_speed, motion.driven_speed]
    };
    let truth = Truth::Closed("closed form of the damped oscillator", Box::new(closed));
    Some(Case { part, name, simulator, settings, times, truth })
}

/// Torques of the scene without its load's harmonic part.
const STEADY: Torques = Torques {
    driving: 974.4,
    load: 843.72,
    load_amplitude: 0.0,
    load_frequency: 241.8051,
    load_phase: 0.0,
};

fn two_masses() -> Vec<Case> {
    let times = || vec![1e-3, 0.01, 0.1, 0.5];
    let loaded = |part, name, machine| two_mass(part, name, machine, (0.0, STEADY), times());
    let mut cases = Vec::new();
    for power in [2, 5, 8, 10, 12, 15] {
        let stiffness = 10f64.powi(power);
        for (damping, what) in [(0.0, "no damping"), (SAW_GIN.damping, "damping 129")] {
            let machine = TwoMass { stiffness, damping, ..SAW_GIN };
            let name = format!("{stiffness:.0e} N m/rad, {what}");
            cases.push(loaded("stiffness of a coupling", name, machine));
        }
        let machine = TwoMass { stiffness, ..SAW_GIN };
        let name = format!("{stiffness:.0e} N m/rad, let go from a twist");
        let start = (1e-2, Torques::default());
        cases.push(two_mass("stiffness of a coupling", name, machine, start, times()));
    }
    for damping in [1.0, 1e3, 1e5, 1e7, 1e9] {
        let machine = TwoMass { damping, ..SAW_GIN };
        let name = format!("{damping:.0e} N m s/rad");
        cases.push(loaded("damping of a coupling", name, machine));
    }
    for (stiffness, damping) in [(1e9, 1e9), (1e15, 1e9), (1e15, 1e5)] {
        let machine = TwoMass { stiffness, damping, ..SAW_GIN };
        let name = format!("{damping:.0e} N m s/rad, stiffness {stiffness:.0e}");
        cases.push(loaded("damping of a coupling", name, machine));
    }
    for ratio in [1e-3, 1e-6, 1e-9, 1e-12] {
        let driven_inertia = ratio * SAW_GIN.driver_inertia;
        for (damping, what) in [(0.0, "no damping"), (SAW_GIN.damping, "damping 129")] {
            let machine = TwoMass { driven_inertia, damping, ..SAW_GIN };
            let name = format!("ratio {ratio:.0e}, {what}");
            cases.push(loaded("ratio of inertias", name, machine));
        }
    }
    cases.into_iter().flatten().collect()
}

/// Returns the same motion in other units of mass, of time, or of both.
fn scaled_units() -> Vec<Case> {
    let units = [(1e12, 1.0), (1e-12, 1.0), (1.0, 1e12), (1.0, 1e-12), (1e12, 1e-12)];
    let cases = units.map(|(mass, time): (f64, f64)| {
        let of_torque = mass / (time * time);
        let machine = TwoMass {
            driver_inertia: mass * SAW_GIN.driver_inertia,
            driven_inertia: mass * SAW_GIN.driven_inertia,
            stiffness: of_torque * SAW_GIN.stiffness,
            damping: mass / time * SAW_GIN.damping,
        };
        let torques = Torques {
            driving: of_torque * STEADY.driving,
            load: of_torque * STEADY.load,
            load_amplitude: of_torque * 78.78,
            load_frequency: STEADY.load_frequency / time,
            load_phase: 0.0,
        };
        let name = format!("masses by {mass:.0e}, times by {time:.0e}");
        let times = [0.01, 0.1, 0.5].map(|at| at * time).to_vec();
        two_mass("huge and tiny units", name, machine, (0.0, torques), times)
    });
    cases.into_iter().flatten().collect()
}

fn many_periods() -> Vec<Case> {
    let undamped = TwoMass { damping: 0.0, ..SAW_GIN };
    let frequency = undamped.natural_frequency();
    let long = [1e2, 1e4, 1e6].map(|periods: f64| {
        let until = periods * TAU / frequency;
        // The times are not only whole periods, at which nothing moves.
        let times = vec![0.123_456_789 * until, 0.771_327_5 * until, until];
        let name = format!("{periods:.0e} periods");
        two_mass("undamped oscillation", name, undamped, (1e-2, Torques::default()), times)
    });
    let beats = [1e-2, 1e-4, 1e-6].map(|detuning: f64| {
        let torques = Torques {
            load_amplitude: 78.78,
            load_frequency: frequency * (1.0 + detuning),
            ..Torques::default()
        };
        let name = format!("load off resonance by {detuning:.0e}");
        let times = vec![1.0, 10.0, 30.0];
        two_mass("beats", name, undamped, (0.0, torques), times)
    });
    long.into_iter().chain(beats).flatten().collect()
}

/// Returns pulses of 1e-4 s and shorter, each with the same momentum.
fn pulses() -> Vec<Case> {
    let widths = [(1e-2, 1e4), (1e-4, 1e4), (1e-6, 1e4), (1e-4, 1e8), (1e-4, 1e2)];
    let cases = widths.map(|(width, stiffness): (f64, f64)| {
        let (damping, torque) = (1.0, 1.0 / width);
        let settings = vec![
            ("stiffness", stiffness),
            ("damping", damping),
            ("torque", torque),
            ("width", width),
        ];
        // Its reduced inertia is 1, and a load of 2 twists it like a torque of 1.
        let rotor = TwoMass { driver_inertia: 2.0, driven_inertia: 2.0, stiffness, damping };
        let since = move |t: f64, start: f64| match t - start {
            past if past > 0.0 => {
                rotor.twist(past, Twist::default(), Torques::constant(0.0, 2.0 * torque))
            }
            _ => Twist::default(),
        };
        let closed = move |t| {
            let (on, off) = (since(t, PULSE_START), since(t, PULSE_START + width));
            vec![on.angle - off.angle, on.rate - off.rate]
        };
        Case {
            part: "pulses of load",
            name: format!("{width:.0e} s, stiffness {stiffness:.0e}"),
            simulator: &PULSE,
            settings,
            times: vec![0.05, 0.1 + 0.5 * width, 0.12, 0.2, 0.5],
            truth: Truth::Closed("two step responses in closed form", Box::new(closed)),
        }
    });
    cases.into_iter().collect()
}

fn saw_gins() -> Vec<Case> {
    let Some(simulator) = scenes::find_f64("saw_gin") else { return Vec::new() };
    let run = |stiffness: f64, damping: f64| Case {
        part: "saw gin",
        name: format!("stiffness {stiffness:.0e}, damping {damping:.0e}"),
        simulator,
        settings: vec![("coupling.stiffness", stiffness), ("coupling.damping", damping)],
        times: vec![0.01, 0.05, 0.1],
        truth: Truth::Converged,
    };
    let extremes = [
        (1e2, 0.0),
        (1e6, 0.0),
        (1e12, 0.0),
        (1e2, 129.0),
        (1e6, 129.0),
        (1e9, 129.0),
        (1e12, 129.0),
        (1e5, 1e6),
        (1e5, 1e9),
        (1e12, 1e9),
    ];
    extremes.into_iter().map(|(stiffness, damping)| run(stiffness, damping)).collect()
}

/// Returns machines without drive and damping.
fn conservative() -> Vec<Case> {
    let case = |simulator: &'static dyn Simulator<f64>, name: String, settings, until: f64| Case {
        part: "conserved energy",
        name,
        simulator,
        settings,
        times: (0..=200).map(|index| f64::from(index) * until / 200.0).collect(),
        truth: Truth::Energy,
    };
    let mut cases = Vec::new();
    if let Some(chain) = scenes::find_f64("pendulum_chain") {
        for until in [10.0, 100.0, 1000.0] {
            let name = format!("chain of three pendulums, {until:.0} s");
            cases.push(case(chain, name, Vec::new(), until));
        }
    }
    if let Some(winder) = scenes::find_f64("winder_nonlinear") {
        for until in [1.0, 100.0] {
            let settings = vec![
                ("layer.viscosity", 0.0),
                ("force_amplitude", 0.0),
                ("ovality", 0.0),
                ("initial_deflection", 8e-3),
            ];
            let name = format!("Duffing's oscillator, {until:.0} s");
            cases.push(case(winder, name, settings, until));
        }
    }
    cases
}

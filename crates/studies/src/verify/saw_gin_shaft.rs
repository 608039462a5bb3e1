//! Checks of the saw gin with a distributed shaft.

use machinist_contract::Simulator as _;
use machinist_scenes::scenes::saw_gin_shaft::SawGinShaft;

use super::{Check, CheckFailure, Machine, Measured, machine, relative_distance, worse};
use crate::closed_form::shaft::{LoadDensity, SAW_GIN_SHAFT};
use machinist::field::{Discretisation, FieldSimulator};
use machinist::{Method, Simulation};

/// Mean load of the study \[N m\].
const LOAD: f64 = 843.72;

pub(super) const CHECKS: &[Check] = &[
    Check {
        name: "integrals of the even and the growing load density",
        reference: "843.72 N m, relative",
        tolerance: 1e-12,
        reason: "elements integrate both exactly; rounding is left",
        measure: load_integrals,
    },
    Check {
        name: "twist of the shaft under both steady loads",
        reference: "static twist under the density, relative",
        tolerance: 1e-5,
        reason: "the machine still settles; the driven end, a hundredth of a second earlier, likewise",
        measure: steady_twist,
    },
    Check {
        name: "speeds and torques over the run-up with a shaft 1e6 times as stiff",
        reference: "the lumped saw gin, relative to the largest",
        tolerance: 1e-5,
        reason: "the stiff shaft's own compliance is 1e-7 of the coupling's; errors of both runs",
        measure: stiff_limit,
    },
];

fn cut(elements: usize, order: usize) -> Result<FieldSimulator<'static, f64>, CheckFailure> {
    let wanted = Discretisation { elements: Some(elements), order: Some(order) };
    Ok(FieldSimulator::new(&SawGinShaft, wanted)?)
}

/// Compares the power that the load takes from a shaft turning as a whole, over its speed.
fn load_integrals(machine: &Machine) -> Result<Measured, CheckFailure> {
    const SPEED: f64 = 78.5;
    let simulator = cut(7, 3)?;
    let mut worst = 0.0;
    for growing in [0.0, 1.0] {
        let settings =
            [("saws.growing", growing), ("saws.amplitude", 0.0), ("saws.engagement_time", -100.0)];
        let parameters = machine.parameters(&settings)?;
        let mut state = vec![0.0; machinist_contract::Describe::shape(&simulator).states()];
        simulator.initial_state(&parameters, &mut state);
        let idle = simulator.power_balance(0.0, &state, &parameters).supplied;
        for (index, value) in state.iter_mut().enumerate() {
            let name = machinist_contract::Describe::state(&simulator, index).name;
            if name.starts_with("saws.") && name.contains("_dot") || name == "coupling.driven_dot" {
                *value = SPEED;
            }
        }
        let taken = idle - simulator.power_balance(0.0, &state, &parameters).supplied;
        worst = worse(worst, (taken / SPEED / LOAD - 1.0).abs());
    }
    Ok(Measured::error(worst))
}

fn steady_twist(machine: &Machine) -> Result<Measured, CheckFailure> {
    let simulator = cut(4, 3)?;
    let mut worst = 0.0;
    for (growing, density) in [(0.0, LoadDensity::Uniform), (1.0, LoadDensity::Linear)] {
        let settings =
            [("saws.growing", growing), ("saws.amplitude", 0.0), ("saws.damping_time", 1e-4)];
        let run = Simulation::new(simulator.single())
            .parameters(&machine.parameters(&settings)?)
            .until(2.5)
            .points(3)
            .rtol(1e-7)
            .method(Method::Rodas5p)
            .run()?;
        let exact = SAW_GIN_SHAFT.static_twist_under(SAW_GIN_SHAFT.length, LOAD, density);
        worst = worse(worst, (machine.last(&run, "twist")? / exact - 1.0).abs());
    }
    Ok(Measured::error(worst))
}

fn stiff_limit(machine: &Machine) -> Result<Measured, CheckFailure> {
    let simulator = cut(3, 2)?;
    let settings = [("saws.shear_modulus", 8e16), ("saws.damping_time", 1e-8)];
    let run = |simulation: Simulation<'_>| {
        simulation.until(1.0).points(101).rtol(1e-8).method(Method::Radau).run()
    };
    let ours =
        run(Simulation::new(simulator.single()).parameters(&machine.parameters(&settings)?))?;
    let lumped = machine::saw_gin();
    let known = run(lumped.simulation(&[])?)?;
    let mut worst = 0.0;
    for (name, other) in [
        ("motor_speed", "motor_speed"),
        ("end_speed", "cylinder_speed"),
        ("motor_torque", "motor_torque"),
        ("coupling_torque", "coupling_torque"),
    ] {
        let (ours, known) = (machine.column(&ours, name)?, lumped.column(&known, other)?);
        worst = worse(worst, relative_distance(ours, known));
    }
    Ok(Measured::error(worst))
}

//! Periodic motions of the studies' machines: the winder over its growth, the gin under load.

use std::f64::consts::{PI, TAU};

use machinist::linear_analysis::{Linearization, Place, operating_point};
use machinist::periodic::{
    BranchSettings, CycleError, CycleSettings, Period, Stability, branch, cycle,
};
use machinist::{Method, Simulation};
use machinist_contract::Simulator;
use machinist_scenes::scenes::saw_gin::SawGin;
use machinist_scenes::scenes::winder_linear::WinderLinear;
use machinist_scenes::scenes::winder_nonlinear::WinderNonlinear;
use num_complex::Complex64;

use super::near;

/// The layer's damping and the mass give exp(-h T/(2 m)), as long as the bobbin oscillates: of a
/// layer of any stiffness, since the product of both multipliers is exp(-h T/m) (Liouville).
#[test]
fn the_winder_decays_over_its_growth_as_its_closed_form() {
    let period = TAU * 0.05 / 5.5;
    let settings = BranchSettings {
        cycle: CycleSettings {
            period: Period::Fixed(period),
            settle: 2.0,
            points: 101,
            ..CycleSettings::default()
        },
        parameter: "holder.package_radius".to_owned(),
        from: 0.03,
        to: 0.06,
        longest_step: 0.1,
        max_points: 100,
    };
    let scenes: [&dyn Simulator<f64>; 2] = [&WinderLinear, &WinderNonlinear];
    for scene in scenes {
        let run = Simulation::new(scene).rtol(1e-11).method(Method::Dop853);
        let found = branch(&run, &settings).expect("a branch");
        assert!(found.is_complete && found.bifurcations().count() == 0, "{}", found.end);
        for point in &found.points {
            // m0 + mn (lbc/lab)^2 + pi (R^2 - Rmin^2) H rho
            let grown = point.value * point.value - 0.03 * 0.03;
            let mass = 1.5 + 0.9 * (0.1_f64 / 0.15).powi(2) + TAU / 2.0 * grown * 0.15 * 350.0;
            let decay = (-95.0 * period / (2.0 * mass)).exp();
            for multiplier in &point.cycle.multipliers {
                near(multiplier.modulus, decay, 1e-8);
            }
            assert_eq!(point.cycle.stability, Stability::Stable);
        }
    }
}

/// Without the harmonic part of the load, the motion in axes that turn is constant, and its
/// multipliers are exp(lambda T). The harmonic part changes them little.
#[test]
fn the_gin_under_load_is_as_stable_as_its_linearization() {
    let period = load_period();
    let settings = CycleSettings {
        period: Period::Fixed(period),
        settle: 3.0,
        points: 101,
        ..CycleSettings::default()
    };
    let run = Simulation::new(&SawGin).rtol(1e-11).method(Method::Dop853).until(6.0);
    let steady = run.clone().parameter("load.amplitude", 0.0).expect("a parameter");
    let found = cycle(&steady, &settings).expect("a cycle");
    let point = operating_point(&steady, Place::Time(6.0)).expect("a state");
    let modes = Linearization::at(&SawGin, point).expect("finite").modes().expect("modes");
    // Angles that no rate depends on are not in the periodic motion, nor in the modes that decay.
    let slowest = modes.iter().map(|mode| mode.real).filter(|real| *real < -1e-6);
    let slowest = slowest.fold(f64::NEG_INFINITY, f64::max);
    near(found.multipliers[0].modulus, (slowest * period).exp(), 1e-7);
    let loaded = cycle(&run, &settings).expect("a cycle");
    assert_eq!(loaded.stability, Stability::Stable);
    near(loaded.multipliers[0].modulus, found.multipliers[0].modulus, 1e-2);
}

/// Period of the load, which varies as sin(pi w2 t) with w2 of 735 rpm.
fn load_period() -> f64 {
    TAU / (PI * (735.0 * PI / 30.0))
}

/// With the harmonics M of the motor's torque and L of the load's, that of the coupling's is K:
///
/// ```text
/// K (1/J1 + 1/J2 - W^2/(c + i W b)) = M/J1 + L/J2
/// ```
#[test]
fn the_loaded_gin_vibrates_as_two_masses_with_the_order_of_its_load() {
    let period = load_period();
    let run = Simulation::new(&SawGin).rtol(1e-11).method(Method::Dop853);
    let settings = CycleSettings {
        period: Period::Fixed(period),
        settle: 3.0,
        points: 201,
        ..CycleSettings::default()
    };
    let motion = cycle(&run, &settings).expect("a cycle").motion;
    let column = |name: &str| &motion.column(name).expect("a column")[1..];
    let harmonic = |name: &str| -> Complex64 {
        let turned = column(name).iter().enumerate().map(|(index, value)| {
            Complex64::from_polar(value / 100.0, -TAU * index as f64 / 200.0)
        });
        turned.sum()
    };
    let (frequency, motor, saws) = (TAU / period, 4.2, 1.244);
    let coupling = Complex64::new(23_065.2, frequency * 128.5346);
    let wanted = (harmonic("motor_torque") / motor + harmonic("load_torque") / saws)
        / (1.0 / motor + 1.0 / saws - frequency * frequency / coupling);
    let off = (harmonic("coupling_torque") - wanted).norm();
    assert!(off < 1e-7 * wanted.norm(), "{off}, {wanted}");
    let mean = column("cylinder_speed").iter().sum::<f64>() / 200.0;
    near(frequency / mean, 3.133, 5e-4);
}

/// A turn of the cylinder is no period of the load.
#[test]
fn a_period_that_the_excitation_does_not_have_is_refused() {
    let run = Simulation::new(&SawGin).rtol(1e-9).method(Method::Dop853);
    let settings = CycleSettings {
        period: Period::Fixed(60.0 / 735.0),
        settle: 2.0,
        ..CycleSettings::default()
    };
    let error = cycle(&run, &settings).expect_err("another period");
    assert!(matches!(error, CycleError::OtherExcitation { .. }), "{error}");
    let multiple = CycleSettings { period: Period::Fixed(load_period()), multiple: 3, ..settings };
    assert!(cycle(&run, &multiple).is_ok());
}

//! Machines with electrical terminals, and what feeds them.

use std::f64::consts::TAU;

use machinist_codegen::mechanics::reduce::Keep;

use super::{by_small_steps, column, example, off, run};

/// Returns the last value of a column.
fn last(run: &machinist::Trajectory, name: &str) -> f64 {
    *column(run, name).last().expect("a value")
}

#[test]
fn a_battery_runs_down_exponentially() {
    let scene = example("electrical/battery", Keep::Needed);
    for load in [0.4, 2.3, 90.0] {
        for capacity in [30.0, 100.0, 1e5] {
            for empty in [0.0, 20.4, 24.0] {
                let set = [
                    ("lamp.resistance", load),
                    ("battery.capacity", capacity),
                    ("battery.empty_voltage", empty),
                ];
                let run = run(&scene, &set, &[]);
                let resistance = load + 0.1;
                let decay = (24.0 - empty) / (resistance * capacity);
                let current = |t: f64| 24.0 / resistance * (-decay * t).exp();
                // The cables' capacitance lags by a microsecond.
                let error =
                    off(&run, "current", current).max(off(&run, "voltage", |t| load * current(t)));
                assert!(error < 3e-6, "{load}, {capacity}, {empty}: {error:e}");
            }
        }
    }
}

#[test]
fn a_machine_at_a_battery_runs_up_as_its_equations_say() {
    let scene = example("electrical/dc_machine", Keep::Needed);
    for constant in [0.2, 0.6, 1.5] {
        for inertia in [0.02, 0.15, 3.0] {
            let set = [
                ("machine.constant", constant),
                ("machine.inertia", inertia),
                ("battery.empty_voltage", 48.0),
            ];
            let run = run(&scene, &set, &[]);
            let [speed, current] = by_small_steps([0.0; 2], 1.0, 100_000, |_, [w, i]| {
                [constant * i / inertia, (48.0 - 0.07 * i - constant * w) / 0.0015]
            });
            let what = format!("{constant}, {inertia}");
            let found = last(&run, "speed");
            assert!((found - speed).abs() < 1e-5 * speed, "{what}: {found} for {speed}");
            let found = last(&run, "current");
            assert!((found - current).abs() < 1e-3, "{what}: {found} A for {current} A");
        }
    }
}

#[test]
fn a_chopper_sets_the_voltage_and_keeps_the_power() {
    let scene = example("electrical/chopper", Keep::Needed);
    for link in [3e-4, 1e-3, 1e-2] {
        for resistance in [0.01, 0.02, 0.2] {
            let set = [("chopper.link_capacitance", link), ("battery.resistance", resistance)];
            let run = run(&scene, &set, &[]);
            let duty = |t: f64| {
                let s = (t / 0.5).clamp(0.0, 1.0);
                0.8 * s.powi(3) * (10.0 - 15.0 * s + 6.0 * s * s)
            };
            let start = [0.0, 0.0, 48.0];
            let [speed, current, voltage] =
                by_small_steps(start, 1.5, 1_000_000, |t, [w, i, u]| {
                    [
                        0.6 * i / 0.15,
                        (duty(t) * u - 0.055 * i - 0.6 * w) / 0.0015,
                        ((48.0 - u) / resistance - duty(t) * i) / link,
                    ]
                });
            let what = format!("{link}, {resistance}");
            let found = last(&run, "speed");
            assert!((found - speed).abs() < 1e-5 * speed, "{what}: {found} for {speed}");
            let found = last(&run, "current");
            assert!((found - current).abs() < 1e-2, "{what}: {found} A for {current} A");
            let found = last(&run, "voltage");
            let voltage = voltage - 0.005 / 0.8 * current;
            assert!((found - 0.8 * voltage).abs() < 1e-4, "{what}: {found} V");
            // i_a = d i_b, once the link no longer charges.
            let drawn = last(&run, "drawn");
            assert!((drawn - 0.8 * current).abs() < 1e-1, "{what}: {drawn} A drawn");
        }
    }
}

#[test]
fn a_rectifier_charges_only_above_the_link() {
    let scene = example("electrical/rectifier", Keep::Needed);
    for capacitance in [1e-4, 1e-3, 1e-2] {
        for resistance in [0.1, 2.0] {
            for load in [10.0, 300.0] {
                let set = [
                    ("rectifier.capacitance", capacitance),
                    ("rectifier.resistance", resistance),
                    ("load.resistance", load),
                ];
                let run = run(&scene, &set, &[]);
                let [voltage] = by_small_steps([0.0], 0.1, 400_000, |t, [u]| {
                    let source = (325.0 * (TAU * 50.0 * t).sin()).abs();
                    let current = (source - 1.6 - u).max(0.0) / resistance;
                    [(current - u / load) / capacitance]
                });
                let found = last(&run, "link");
                let what = format!("{capacitance}, {resistance}, {load}");
                assert!((found - voltage).abs() < 1e-5 * voltage, "{what}: {found} for {voltage}");
                assert!(column(&run, "current").iter().all(|current| *current >= 0.0));
            }
        }
    }
}

/// Three voltages of the rotor's frequency are constant in its axes, so that the machine with
/// terminals runs as the one without.
#[test]
fn a_machine_with_three_phases_runs_as_in_the_axes_of_its_rotor() {
    let phases = example("electrical/pmsm_machine", Keep::Needed);
    let axes = example("electrical/pmsm", Keep::Needed);
    for magnet in [0.05, 0.15, 0.4] {
        for inductance in [0.002, 0.004, 0.02] {
            let set = [("machine.magnet", magnet), ("machine.inductance_d", inductance)];
            let other = [("motor.magnet", magnet), ("motor.inductance_d", inductance)];
            let [of_phases, of_axes] = [run(&phases, &set, &[]), run(&axes, &other, &[])];
            for name in ["speed", "torque", "current_d", "current_q"] {
                let size = column(&of_axes, name).iter().fold(0.0, |a: f64, b| a.max(b.abs()));
                let pairs = column(&of_phases, name).iter().zip(column(&of_axes, name));
                let most = pairs.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
                assert!(most < 1e-6 * size, "{magnet}, {inductance}, {name}: {most:e} of {size}");
            }
        }
    }
}

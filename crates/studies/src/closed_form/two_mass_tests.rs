use super::*;

const UNDER: TwoMass = SAW_GIN;
const OVER: TwoMass = TwoMass { damping: 900.0, ..SAW_GIN };
const TORQUES: Torques = Torques {
    driving: 974.4,
    load: 843.72,
    load_amplitude: 78.78,
    load_frequency: 241.8051,
    load_phase: 0.3,
};
const START: Motion =
    Motion { driver_angle: 0.02, driver_speed: 3.0, driven_angle: -0.01, driven_speed: 1.0 };

/// b = 2 sqrt(c Jr).
fn critical() -> TwoMass {
    let damping = 2.0 * (SAW_GIN.stiffness * SAW_GIN.reduced_inertia()).sqrt();
    TwoMass { damping, ..SAW_GIN }
}

fn assert_close(ours: f64, reference: f64, tolerance: f64) {
    assert!((ours - reference).abs() <= tolerance, "{ours} against {reference}");
}

/// The equations of motion, written once more: accelerations of both masses.
fn accelerations(m: &TwoMass, t: f64, now: Motion, torques: Torques) -> (f64, f64) {
    let carried = m.stiffness * (now.driver_angle - now.driven_angle)
        + m.damping * (now.driver_speed - now.driven_speed);
    let load = torques.load
        + torques.load_amplitude * (torques.load_frequency * t + torques.load_phase).sin();
    ((torques.driving - carried) / m.driver_inertia, (carried - load) / m.driven_inertia)
}

/// Classical Runge-Kutta over 0 to `until`.
fn runge_kutta(m: &TwoMass, until: f64, steps: usize) -> Motion {
    let h = until / steps as f64;
    let add = |y: Motion, k: [f64; 4], f: f64| Motion {
        driver_angle: y.driver_angle + f * k[0],
        driver_speed: y.driver_speed + f * k[1],
        driven_angle: y.driven_angle + f * k[2],
        driven_speed: y.driven_speed + f * k[3],
    };
    let rate = |t: f64, y: Motion| {
        let (a, b) = accelerations(m, t, y, TORQUES);
        [y.driver_speed, a, y.driven_speed, b]
    };
    let mut y = START;
    for step in 0..steps {
        let t = step as f64 * h;
        let k1 = rate(t, y);
        let k2 = rate(t + h / 2.0, add(y, k1, h / 2.0));
        let k3 = rate(t + h / 2.0, add(y, k2, h / 2.0));
        let k4 = rate(t + h, add(y, k3, h));
        for (k, weight) in [(k1, 1.0), (k2, 2.0), (k3, 2.0), (k4, 1.0)] {
            y = add(y, k, h * weight / 6.0);
        }
    }
    y
}

#[test]
fn figures_of_the_saw_gin_are_the_published_ones() {
    assert_close(SAW_GIN.reduced_inertia(), 0.959_735_5, 5e-8);
    assert_close(SAW_GIN.natural_frequency(), 155.03, 5e-3);
    assert_close(SAW_GIN.damping_ratio(), 0.432, 5e-4);
}

#[test]
fn motion_agrees_with_runge_kutta_below_at_and_above_critical_damping() {
    for machine in [UNDER, critical(), OVER] {
        let ours = machine.motion(0.25, START, TORQUES);
        let reference = runge_kutta(&machine, 0.25, 40_000);
        assert_close(ours.driver_angle, reference.driver_angle, 1e-11);
        assert_close(ours.driver_speed, reference.driver_speed, 1e-10);
        assert_close(ours.driven_angle, reference.driven_angle, 1e-11);
        assert_close(ours.driven_speed, reference.driven_speed, 1e-10);
    }
}

#[test]
fn speeds_and_accelerations_are_the_derivatives_of_angles() {
    let h = 1e-6;
    for machine in [UNDER, critical(), OVER] {
        for t in [0.001, 0.01, 0.05, 0.2] {
            let at = |t| machine.motion(t, START, TORQUES);
            let (before, now, after) = (at(t - h), at(t), at(t + h));
            let slope = |a: f64, b: f64| (b - a) / (2.0 * h);
            let (driver, driven) = accelerations(&machine, t, now, TORQUES);
            assert_close(slope(before.driver_angle, after.driver_angle), now.driver_speed, 1e-5);
            assert_close(slope(before.driven_angle, after.driven_angle), now.driven_speed, 1e-5);
            assert_close(slope(before.driver_speed, after.driver_speed), driver, 2e-3);
            assert_close(slope(before.driven_speed, after.driven_speed), driven, 2e-3);
        }
    }
}

#[test]
fn motion_starts_where_it_is_told() {
    let ours = UNDER.motion(0.0, START, TORQUES);
    assert_close(ours.driver_angle, START.driver_angle, 1e-16);
    assert_close(ours.driver_speed, START.driver_speed, 1e-14);
    assert_close(ours.driven_angle, START.driven_angle, 1e-16);
    assert_close(ours.driven_speed, START.driven_speed, 1e-14);
}

#[test]
fn constant_torques_leave_the_static_twist() {
    let torques = Torques::constant(974.4, 843.72);
    for machine in [UNDER, critical(), OVER] {
        let late = machine.twist(20.0, Twist { angle: 0.1, rate: -4.0 }, torques);
        assert_close(late.angle, machine.static_twist(974.4, 843.72), 1e-16);
        assert_close(late.rate, 0.0, 1e-16);
    }
    let by_hand = (974.4 * 1.244 + 843.72 * 4.2) / (23_065.2 * 5.444);
    assert_close(SAW_GIN.static_twist(974.4, 843.72), by_hand, 1e-17);
}

#[test]
fn undamped_free_twist_keeps_its_energy() {
    let machine = TwoMass { damping: 0.0, ..SAW_GIN };
    let energy = |x: Twist| {
        machine.reduced_inertia() * x.rate.powi(2) / 2.0 + machine.stiffness * x.angle.powi(2) / 2.0
    };
    let start = Twist { angle: 0.01, rate: 1.0 };
    for t in [0.003, 0.1, 2.0] {
        assert_close(energy(machine.free_decay(t, start)) / energy(start), 1.0, 1e-13);
    }
}

#[test]
fn damping_near_the_critical_one_changes_the_motion_smoothly() {
    let near = |factor: f64| {
        let machine = TwoMass { damping: critical().damping * factor, ..SAW_GIN };
        machine.free_decay(0.01, Twist { angle: 0.01, rate: 0.5 })
    };
    for delta in [1e-9, 1e-12, 1e-15] {
        assert_close(near(1.0 - delta).angle, near(1.0 + delta).angle, 0.1 * delta + 1e-15);
        assert_close(near(1.0 - delta).rate, near(1.0 + delta).rate, 10.0 * delta + 1e-13);
    }
}

#[test]
fn strong_damping_neither_overflows_nor_loses_the_slow_decay() {
    let machine = TwoMass { damping: 1e7, ..SAW_GIN };
    let late = machine.free_decay(100.0, Twist { angle: 0.01, rate: 0.0 });
    // Inertia is negligible: theta = theta_0 e^(-c t/b).
    assert_close(late.angle / (0.01 * (-23_065.2 * 100.0 / 1e7_f64).exp()), 1.0, 1e-8);
}

#[test]
fn a_vanishing_frequency_is_a_constant_load() {
    let slow = Torques { load_frequency: 0.0, load_phase: 0.3, ..TORQUES };
    let constant = Torques::constant(974.4, 843.72 + 78.78 * 0.3_f64.sin());
    let ours = UNDER.motion(0.4, START, slow);
    let reference = UNDER.motion(0.4, START, constant);
    assert_close(ours.driver_angle, reference.driver_angle, 1e-13);
    assert_close(ours.driven_speed, reference.driven_speed, 1e-13);
}

#[test]
fn integrals_of_the_sine_agree_across_the_switch_of_formulas() {
    for phase in [0.0, 0.7] {
        let (once, twice) = sine_integrals(0.5 - 1e-9, 1.0, phase);
        let (after_once, after_twice) = sine_integrals(0.5 + 1e-9, 1.0, phase);
        assert_close(once, after_once, 3e-9);
        assert_close(twice, after_twice, 3e-9 * once.abs().max(0.2));
        let exact = 0.5 * f64::cos(phase) - (0.5 + phase).sin() + phase.sin();
        assert_close(sine_integrals(0.5 - 1e-16, 1.0, phase).1, exact, 1e-15);
    }
}

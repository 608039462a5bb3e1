#![expect(clippy::float_cmp, reason = "numbers that must come out exactly")]

use super::*;

const SHAFT: Shaft = SAW_GIN_SHAFT;

/// (f(-h) - 2 f(0) + f(h))/h^2.
fn second_difference(h: f64, f: impl Fn(f64) -> f64) -> f64 {
    (f(-h) - 2.0 * f(0.0) + f(h)) / (h * h)
}

fn assert_close(found: f64, expected: f64, tolerance: f64) {
    assert!((found - expected).abs() <= tolerance * expected.abs(), "{found} is not {expected}");
}

#[test]
fn the_shaft_of_the_study_has_its_wave_speed_and_first_frequency() {
    assert_close(SHAFT.stiffness, 785_360.0, 1e-12);
    assert!((SHAFT.density - 0.535_74).abs() < 1e-5);
    assert!((SHAFT.wave_speed() - 1210.8).abs() < 0.05);
    assert!((SHAFT.fixed_free_frequency(1) - 819.1).abs() < 0.05);
    assert_close(SHAFT.free_free_frequency(3), 6.0 * SHAFT.fixed_free_frequency(1), 1e-14);
}

#[test]
fn rotors_at_the_ends_satisfy_the_conditions_there() {
    let c = SHAFT.wave_speed();
    for rotor in [0.01, 1.244, 4.2, 100.0] {
        for k in 1..=12 {
            let w = SHAFT.fixed_rotor_frequency(k, rotor);
            let (sin, cos) = (w * SHAFT.length / c).sin_cos();
            // G I phi_x = J w^2 phi of phi = sin(w x/c).
            let (inner, outer) = (SHAFT.stiffness / c * cos, rotor * w * sin);
            assert!((inner - outer).abs() <= 1e-12 * rotor * w, "{k}: {inner} is not {outer}");

            let w = SHAFT.rotor_ended_frequency(k, [rotor, 4.2]);
            let number = w / c;
            let start = -rotor * w * w / (SHAFT.stiffness * number);
            let (sin, cos) = (number * SHAFT.length).sin_cos();
            let (angle, slope) = (cos + start * sin, number * (start * cos - sin));
            let size = SHAFT.stiffness * number * (1.0 + start.abs());
            let left = SHAFT.stiffness * slope - 4.2 * w * w * angle;
            assert!(left.abs() <= 1e-10 * (size + 4.2 * w * w * (1.0 + start.abs())), "{k}");
        }
    }
}

#[test]
fn frequencies_tend_to_the_known_ones_for_light_and_heavy_rotors() {
    for k in 1..=5 {
        assert_close(SHAFT.fixed_rotor_frequency(k, 0.0), SHAFT.fixed_free_frequency(k), 1e-14);
        assert_close(SHAFT.rotor_ended_frequency(k, [0.0; 2]), SHAFT.free_free_frequency(k), 1e-14);
        let light_and_fixed = SHAFT.rotor_ended_frequency(k, [0.0, 1e12]);
        assert_close(light_and_fixed, SHAFT.fixed_free_frequency(k), 1e-9);
    }
    // A heavy rotor on a light shaft is an oscillator, corrected by a third of the
    // shaft's inertia (Rayleigh).
    let oscillator = (SHAFT.stiffness / SHAFT.length / (400.0 + SHAFT.inertia() / 3.0)).sqrt();
    assert_close(SHAFT.fixed_rotor_frequency(1, 400.0), oscillator, 1e-6);
    // Two heavy rotors are the two-mass coupling.
    let two_mass = (SHAFT.stiffness / SHAFT.length * 2.0 / 1e5).sqrt();
    assert_close(SHAFT.rotor_ended_frequency(1, [1e5; 2]), two_mass, 1e-5);
}

#[test]
fn static_twist_carries_the_load_beyond_each_section() {
    let (torque, l) = (843.72, SHAFT.length);
    for density in [LoadDensity::Uniform, LoadDensity::Linear] {
        let at = |x: f64| SHAFT.static_twist_under(x, torque, density);
        for share in [0.1, 0.4, 0.8] {
            let x = share * l;
            let load = match density {
                LoadDensity::Uniform => torque / l,
                LoadDensity::Linear => 2.0 * torque * x / (l * l),
            };
            let bend = second_difference(1e-2, |dx| at(x + dx));
            assert_close(-SHAFT.stiffness * bend, load, 1e-6);
        }
        let wall = SHAFT.stiffness * (at(1e-6) - at(0.0)) / 1e-6;
        assert_close(wall, torque, 1e-6);
        let end = SHAFT.stiffness * (at(l) - at(l - 1e-5)) / 1e-5;
        assert!(end.abs() < 1e-4 * torque);
    }
    assert_close(SHAFT.static_twist(l, torque), torque * l / SHAFT.stiffness, 1e-15);
}

#[test]
fn after_a_step_of_torque_the_end_turns_in_triangles_and_the_wall_feels_squares() {
    let (torque, l, c) = (843.72, SHAFT.length, SHAFT.wave_speed());
    let tip = 2.0 * torque * l / SHAFT.stiffness;
    for (periods, share) in [(0.125, 0.25), (0.5, 1.0), (0.75, 0.5), (3.5, 1.0), (101.25, 0.5)] {
        let t = periods * 4.0 * l / c;
        assert_close(SHAFT.step_torque(l, t, torque).angle, share * tip, 1e-9);
    }
    for (time, expected) in [(0.5, 0.0), (1.5, 2.0 * torque), (2.5, 2.0 * torque), (3.5, 0.0)] {
        assert_eq!(SHAFT.step_torque(0.0, time * l / c, torque).torque, expected);
    }
    assert_eq!(SHAFT.step_torque(0.0, 0.123, torque).angle, 0.0);
}

#[test]
fn the_wave_of_a_step_is_the_modal_series() {
    let (torque, x) = (843.72, 0.37 * SHAFT.length);
    for t in [0.0004, 0.0017, 0.0063, 0.0201] {
        let mut angle = SHAFT.static_twist(x, torque);
        for k in 1..=20_000 {
            let w = SHAFT.fixed_free_frequency(k);
            let number = w / SHAFT.wave_speed();
            let size = 2.0 * torque * (number * SHAFT.length).sin()
                / (SHAFT.stiffness * SHAFT.length * number * number);
            angle -= size * (number * x).sin() * (w * t).cos();
        }
        let exact = SHAFT.step_torque(x, t, torque).angle;
        assert!((angle - exact).abs() < 1e-7 * SHAFT.static_twist(SHAFT.length, torque), "{t}");
    }
}

#[test]
fn derivatives_of_the_wave_are_its_speed_and_torque() {
    let (torque, h) = (843.72, 1e-7);
    for (share, t) in [(0.2, 0.001), (0.7, 0.003), (0.9, 0.0101), (0.5, 0.02)] {
        let x = share * SHAFT.length;
        let wave = SHAFT.step_torque(x, t, torque);
        let angle = |x: f64, t: f64| SHAFT.step_torque(x, t, torque).angle;
        let speed = (angle(x, t + h) - angle(x, t - h)) / (2.0 * h);
        let inner = SHAFT.stiffness * (angle(x + h, t) - angle(x - h, t)) / (2.0 * h);
        assert!((wave.speed - speed).abs() < 1e-6);
        assert!((wave.torque - inner).abs() < 1e-5 * torque, "{} {inner}", wave.torque);
    }
}

#[test]
fn harmonic_answers_satisfy_the_wave_equation_and_the_ends() {
    let (torque, w, l) = (78.78, 3000.0, SHAFT.length);
    for support in [Support::Fixed, Support::Free] {
        let twist = |x: f64| SHAFT.harmonic_twist(x, torque, w, support);
        let x = 0.3 * l;
        let bend = SHAFT.stiffness * second_difference(1e-3, |dx| twist(x + dx));
        assert_close(bend, -SHAFT.density * w * w * twist(x), 1e-5);
        assert_close(SHAFT.harmonic_torque(l, torque, w, support), torque, 1e-14);
        let slope = (twist(x + 1e-5) - twist(x - 1e-5)) / 2e-5;
        assert_close(SHAFT.harmonic_torque(x, torque, w, support), SHAFT.stiffness * slope, 1e-6);
    }
    assert_eq!(SHAFT.harmonic_twist(0.0, torque, w, Support::Fixed), 0.0);
    assert_eq!(SHAFT.harmonic_torque(0.0, torque, w, Support::Free), 0.0);
    let slow = SHAFT.harmonic_twist(l, torque, 1e-3, Support::Fixed);
    assert_close(slow, SHAFT.static_twist(l, torque), 1e-10);
}

#[test]
fn kelvin_voigt_decay_satisfies_its_equation_below_and_above_critical_damping() {
    let w = SHAFT.fixed_free_frequency(1);
    assert_close(kelvin_voigt_ratio(w, 1e-4), 1e-4 * w / 2.0, 1e-15);
    for d in [1e-4, 2.0 / w, 1e-2] {
        let at = |t: f64| kelvin_voigt_decay(t, w, d);
        let (t, h) = (2e-3, 1e-6);
        let acceleration = second_difference(h, |dt| at(t + dt));
        let speed = (at(t + h) - at(t - h)) / (2.0 * h);
        let left = acceleration + d * w * w * speed + w * w * at(t);
        assert!(left.abs() < 1e-3 * w * w, "{d}: {left}");
        assert_eq!(at(0.0), 1.0);
        assert!((at(1e-7) - 1.0).abs() < 1e-7);
    }
    let peak = kelvin_voigt_decay(2.0 * PI / (w * (1.0 - 0.0016f64).sqrt()), w, 0.08 / w);
    assert_close(peak, (-0.04 * 2.0 * PI / (1.0 - 0.0016f64).sqrt()).exp(), 1e-12);
}

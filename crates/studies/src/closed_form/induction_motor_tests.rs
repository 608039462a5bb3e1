use super::*;

const MOTOR: InductionMotor = MOTOR_4A280M8;

/// The study rounds the leakage factor to 0.0896 in the torque formula; its decays
/// are given as numbers of their own, so the flux linkages do not change.
fn with_rounded_leakage(torque: f64) -> f64 {
    torque * MOTOR.leakage() / 0.0896
}

fn assert_close(ours: f64, reference: f64, tolerance: f64) {
    assert!((ours - reference).abs() <= tolerance, "{ours} against {reference}");
}

/// Returns the right-hand side as four real equations in a second formulation.
fn real_rates(y: [f64; 4], speed: f64) -> [f64; 4] {
    let [x1, y1, x2, y2] = y;
    let w0 = 2.0 * PI * 50.0;
    let um = 220.0 * SQRT_2;
    [
        um - w0 * 0.115 * x1 + w0 * 0.115 * 0.952 * x2 + w0 * y1,
        -w0 * 0.115 * y1 + w0 * 0.115 * 0.952 * y2 - w0 * x1,
        -w0 * 0.0858 * x2 + w0 * 0.0858 * 0.956 * x1 + (w0 - 4.0 * speed) * y2,
        -w0 * 0.0858 * y2 + w0 * 0.0858 * 0.956 * y1 - (w0 - 4.0 * speed) * x2,
    ]
}

fn runge_kutta(start: [f64; 4], speed: f64, until: f64, steps: usize) -> [f64; 4] {
    let h = until / steps as f64;
    let add = |y: [f64; 4], k: [f64; 4], f: f64| std::array::from_fn(|i| y[i] + f * k[i]);
    let mut y = start;
    for _ in 0..steps {
        let k1 = real_rates(y, speed);
        let k2 = real_rates(add(y, k1, h / 2.0), speed);
        let k3 = real_rates(add(y, k2, h / 2.0), speed);
        let k4 = real_rates(add(y, k3, h), speed);
        for (k, weight) in [(k1, 1.0), (k2, 2.0), (k3, 2.0), (k4, 1.0)] {
            y = add(y, k, h * weight / 6.0);
        }
    }
    y
}

#[test]
fn figures_of_the_4a280m8_are_the_published_ones() {
    assert_close(MOTOR.leakage(), 0.089_888, 5e-13);
    assert_close(MOTOR.torque(0.02), 954.6866, 5e-5);
    assert_close(MOTOR.breakdown_torque(), 2034.2546, 5e-5);
    assert_close(MOTOR.breakdown_slip(), 0.085_243, 5e-7);
    assert_close(MOTOR.starting_torque(), 373.5342, 5e-5);
    assert_close(MOTOR.synchronous_speed(), 78.539_816_34, 5e-9);
}

#[test]
fn figures_with_the_rounded_leakage_are_the_published_ones() {
    assert_close(with_rounded_leakage(MOTOR.torque(0.02)), 957.7553, 5e-5);
    assert_close(with_rounded_leakage(MOTOR.breakdown_torque()), 2040.7932, 5e-5);
    assert_close(with_rounded_leakage(MOTOR.starting_torque()), 374.7349, 5e-5);
}

#[test]
fn torque_curve_is_the_torque_of_the_steady_flux() {
    for k in -20..=20 {
        let slip = f64::from(k) / 10.0;
        let ours = MOTOR.torque(slip);
        assert_close(ours, MOTOR.torque_of_flux(MOTOR.steady_flux(slip)), 1e-12 * 2034.0);
    }
}

#[test]
fn steady_flux_satisfies_the_four_real_equations() {
    for speed in [0.0, 40.0, 76.97, 90.0] {
        let flux = MOTOR.steady_flux(MOTOR.slip(speed));
        let state = [flux.stator.re, flux.stator.im, flux.rotor.re, flux.rotor.im];
        for rate in real_rates(state, speed) {
            assert_close(rate, 0.0, 1e-11);
        }
    }
}

#[test]
fn no_torque_exceeds_the_breakdown_torque() {
    let (slip, torque) = (MOTOR.breakdown_slip(), MOTOR.breakdown_torque());
    assert_close(MOTOR.torque(slip), torque, 1e-11);
    for factor in [0.5, 0.99, 0.9999, 1.0001, 1.01, 2.0] {
        assert!(MOTOR.torque(slip * factor) < torque);
    }
}

#[test]
fn transient_agrees_with_runge_kutta() {
    let start = [0.3, -0.2, 0.1, 0.5];
    let flux = Flux {
        stator: Complex64::new(start[0], start[1]),
        rotor: Complex64::new(start[2], start[3]),
    };
    for speed in [0.0, 40.0, 76.97] {
        for until in [2e-4, 0.01, 0.2] {
            let ours = MOTOR.flux(until, flux, MOTOR.slip(speed));
            let reference = runge_kutta(start, speed, until, 40_000);
            assert_close(ours.stator.re, reference[0], 1e-11);
            assert_close(ours.stator.im, reference[1], 1e-11);
            assert_close(ours.rotor.re, reference[2], 1e-11);
            assert_close(ours.rotor.im, reference[3], 1e-11);
        }
    }
}

#[test]
fn equal_eigenvalues_do_not_divide_by_zero() {
    // a_s = a_r, slip 1 and no coupling of the rotor into the stator: d = 0 exactly.
    let motor = InductionMotor { alpha_r: 0.115, k_r: 0.0, ..MOTOR };
    let [first, second] = motor.eigenvalues(1.0);
    assert!((first - second).norm() < 1e-12);
    let start = Flux { stator: Complex64::new(1.0, 0.5), rotor: Complex64::new(0.2, 0.0) };
    let exact = motor.flux(0.05, start, 1.0);
    // A small coupling moves the answer by its first order only.
    let near = InductionMotor { k_r: 1e-12, ..motor }.flux(0.05, start, 1.0);
    assert!((exact.stator - near.stator).norm() < 1e-10);
    assert!((exact.rotor - near.rotor).norm() < 1e-10);
    assert!(exact.rotor.is_finite());
}

#[test]
fn both_formulas_of_the_exponential_agree_where_they_meet() {
    let mean = Complex64::new(-30.0, 5.0);
    let distance = Complex64::new(6.0, -8.0);
    let (below_even, below_odd) = exponential_pair(0.01 * (1.0 - 1e-13), mean, distance);
    let (above_even, above_odd) = exponential_pair(0.01 * (1.0 + 1e-13), mean, distance);
    assert!((below_even - above_even).norm() < 1e-12);
    assert!((below_odd - above_odd).norm() < 1e-14);
}

#[test]
fn transient_fades_to_the_steady_flux() {
    let late = MOTOR.flux(50.0, Flux::default(), 1.0);
    let steady = MOTOR.steady_flux(1.0);
    assert!((late.stator - steady.stator).norm() < 1e-14);
    assert!((late.rotor - steady.rotor).norm() < 1e-14);
}

#[test]
fn energy_supplied_at_standstill_is_stored_or_lost() {
    // d/dt of 3/4 Re(Psi conj I) = 3/2 Re(U conj I_s) - 3/2 (r_s |I_s|^2 + r_r |I_r|^2)
    // at standstill, in stator and rotor currents of the flux linkages.
    let w0 = MOTOR.synchronous_frequency();
    let sigma = MOTOR.leakage();
    let x_r = MOTOR.k_s * MOTOR.x_s / MOTOR.k_r;
    let currents = |f: Flux| {
        (
            (f.stator - f.rotor * MOTOR.k_r) * (w0 / (sigma * MOTOR.x_s)),
            (f.rotor - f.stator * MOTOR.k_s) * (w0 / (sigma * x_r)),
        )
    };
    let at = |t: f64| MOTOR.flux(t, Flux::default(), 1.0);
    let stored = |t: f64| {
        let (i_s, i_r) = currents(at(t));
        0.75 * ((at(t).stator * i_s.conj()).re + (at(t).rotor * i_r.conj()).re)
    };
    for t in [0.005, 0.03, 0.1] {
        let (i_s, i_r) = currents(at(t));
        let supplied = 1.5 * (MOTOR.supply() * i_s.conj()).re;
        let lost = 1.5
            * sigma
            * (MOTOR.alpha_s * MOTOR.x_s * i_s.norm_sqr() + MOTOR.alpha_r * x_r * i_r.norm_sqr());
        let h = 1e-6;
        let slope = (stored(t + h) - stored(t - h)) / (2.0 * h);
        assert_close((slope - supplied + lost) / supplied.abs(), 0.0, 1e-6);
    }
}

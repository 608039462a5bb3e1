use super::*;

/// m q'' + h (q' - Y') + c_p q + c (q - Y) - F by central differences, relative to m q''.
fn residual(forces: &[Harmonic], shapes: &[Harmonic], start: Deflection, t: f64) -> f64 {
    let model = BENCH_M5;
    let h = 1e-5;
    let rate = |t| model.motion(t, start, forces, shapes).rate;
    let acceleration = (rate(t + h) - rate(t - h)) / (2.0 * h);
    let now = model.motion(t, start, forces, shapes);
    let sum = |all: &[Harmonic]| {
        all.iter().map(|one| one.at(t)).fold((0.0, 0.0), |(v, r), d| (v + d.value, r + d.rate))
    };
    let ((force, _), (shape, shape_rate)) = (sum(forces), sum(shapes));
    let left = model.mass * acceleration
        + model.viscosity * (now.rate - shape_rate)
        + model.spring_stiffness * now.value
        + model.layer_stiffness * (now.value - shape)
        - force;
    left / 25.0
}

#[test]
fn the_motion_obeys_its_equation_and_its_start() {
    let start = Deflection { value: 1e-3, rate: -0.2 };
    let (forces, shapes) = ([FORCE_M5], [SHAPE_M5, Harmonic { frequency: 40.0, ..SHAPE_M5 }]);
    for t in [0.01, 0.05, 0.3] {
        assert!(residual(&forces, &shapes, start, t).abs() < 1e-6);
    }
    let first = BENCH_M5.motion(0.0, start, &forces, &shapes);
    assert!((first.value - start.value).abs() < 1e-15 && (first.rate - start.rate).abs() < 1e-13);
}

#[test]
fn rates_are_derivatives_of_deflections() {
    let start = Deflection { value: 1e-3, rate: -0.2 };
    let value = |t| BENCH_M5.motion(t, start, &[FORCE_M5], &[SHAPE_M5]).value;
    let (t, h) = (0.02, 1e-6);
    let rate = BENCH_M5.motion(t, start, &[FORCE_M5], &[SHAPE_M5]).rate;
    assert!(((value(t + h) - value(t - h)) / (2.0 * h) - rate).abs() < 1e-7);
}

#[test]
fn a_slow_force_deflects_by_its_static_share_and_a_slow_shape_by_c_over_c_and_cp() {
    let slow = |amplitude| Harmonic { amplitude, frequency: 1e-6, phase: 0.0 };
    let force = BENCH_M5.answer_to_force(&slow(45_800.0));
    assert!((force.amplitude - 1.0).abs() < 1e-12);
    let shape = BENCH_M5.answer_to_shape(&slow(45_800.0));
    assert!((shape.amplitude - 42_000.0).abs() < 1e-6);
}

#[test]
fn the_printed_amplitude_is_the_consistent_one_for_a_mass_of_one_kilogram_only() {
    let unit = BobbinOscillator { mass: 1.0, ..BENCH_M5 };
    let consistent = |model: BobbinOscillator| model.answer_to_force(&FORCE_M5).amplitude;
    let printed = |model: BobbinOscillator| model.amplitude_as_printed(25.0, FORCE_M5.frequency);
    assert!((consistent(unit) / printed(unit) - 1.0).abs() < 1e-14);
    assert!(consistent(BENCH_M5) / printed(BENCH_M5) > 1.1);
}

#[test]
fn the_layer_s_viscosity_carries_the_shape_s_rate() {
    let consistent = BENCH_M5.answer_to_shape(&SHAPE_M5).amplitude;
    let printed = BENCH_M5.answer_to_shape_as_printed(&SHAPE_M5).amplitude;
    let expected = BENCH_M5.dynamic_layer_stiffness(SHAPE_M5.frequency) / 42_000.0;
    assert!((consistent / printed - expected).abs() < 1e-14 && expected > 1.1);
}

#[test]
fn no_phases_exceed_the_sum_of_amplitudes_and_some_reach_it() {
    let sum = BENCH_M5.amplitude_sum(&[FORCE_M5], &[SHAPE_M5]);
    let mut most: f64 = 0.0;
    for step in 0..2000 {
        let t = f64::from(step) * 1e-4;
        for turn in 0..8 {
            let shape = Harmonic { phase: f64::from(turn) * PI / 4.0, ..SHAPE_M5 };
            let both = BENCH_M5.answer_to_force(&FORCE_M5).at(t).value
                + BENCH_M5.answer_to_shape(&shape).at(t).value;
            most = most.max(both.abs());
        }
    }
    assert!(most <= sum && most > 0.95 * sum, "{most} of {sum}");
}

#[test]
fn mass_grows_by_the_ring_of_yarn() {
    assert!((MASS_M5.at(0.03) - 2.1).abs() < 1e-15);
    // A ring of 3 and 5 cm: 16 pi cm^2.
    assert!((MASS_M5.at(0.05) - 2.1 - 16e-4 * PI * 52.5).abs() < 1e-14);
}

use super::*;

/// m q'' + h (q' - Y') + c_p q + c (q - Y) - F by central differences, relative to m q''.
fn residual(forces: &[Harmonic], shapes: &[Harmonic], start: Deflection, t: f64) -> f64 {
    let model = BENCH_BOBBIN;
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
    let (forces, shapes) =
        ([BENCH_FORCE], [BENCH_SHAPE, Harmonic { frequency: 40.0, ..BENCH_SHAPE }]);
    for t in [0.01, 0.05, 0.3] {
        assert!(residual(&forces, &shapes, start, t).abs() < 1e-6);
    }
    let first = BENCH_BOBBIN.motion(0.0, start, &forces, &shapes);
    assert!((first.value - start.value).abs() < 1e-15 && (first.rate - start.rate).abs() < 1e-13);
}

#[test]
fn rates_are_derivatives_of_deflections() {
    let start = Deflection { value: 1e-3, rate: -0.2 };
    let value = |t| BENCH_BOBBIN.motion(t, start, &[BENCH_FORCE], &[BENCH_SHAPE]).value;
    let (t, h) = (0.02, 1e-6);
    let rate = BENCH_BOBBIN.motion(t, start, &[BENCH_FORCE], &[BENCH_SHAPE]).rate;
    assert!(((value(t + h) - value(t - h)) / (2.0 * h) - rate).abs() < 1e-7);
}

#[test]
fn a_slow_force_deflects_by_its_static_share_and_a_slow_shape_by_c_over_c_and_cp() {
    let slow = |amplitude| Harmonic { amplitude, frequency: 1e-6, phase: 0.0 };
    let force = BENCH_BOBBIN.answer_to_force(&slow(45_800.0));
    assert!((force.amplitude - 1.0).abs() < 1e-12);
    let shape = BENCH_BOBBIN.answer_to_shape(&slow(45_800.0));
    assert!((shape.amplitude - 42_000.0).abs() < 1e-6);
}

#[test]
fn the_printed_amplitude_is_the_consistent_one_for_a_mass_of_one_kilogram_only() {
    let unit = BobbinOscillator { mass: 1.0, ..BENCH_BOBBIN };
    let consistent = |model: BobbinOscillator| model.answer_to_force(&BENCH_FORCE).amplitude;
    let printed = |model: BobbinOscillator| model.amplitude_as_printed(25.0, BENCH_FORCE.frequency);
    assert!((consistent(unit) / printed(unit) - 1.0).abs() < 1e-14);
    assert!(consistent(BENCH_BOBBIN) / printed(BENCH_BOBBIN) > 1.1);
}

#[test]
fn the_layer_s_viscosity_carries_the_shape_s_rate() {
    let consistent = BENCH_BOBBIN.answer_to_shape(&BENCH_SHAPE).amplitude;
    let printed = BENCH_BOBBIN.answer_to_shape_as_printed(&BENCH_SHAPE).amplitude;
    let expected = BENCH_BOBBIN.dynamic_layer_stiffness(BENCH_SHAPE.frequency) / 42_000.0;
    assert!((consistent / printed - expected).abs() < 1e-14 && expected > 1.1);
}

#[test]
fn no_phases_exceed_the_sum_of_amplitudes_and_some_reach_it() {
    let sum = BENCH_BOBBIN.amplitude_sum(&[BENCH_FORCE], &[BENCH_SHAPE]);
    let mut most: f64 = 0.0;
    for step in 0..2000 {
        let t = f64::from(step) * 1e-4;
        for turn in 0..8 {
            let shape = Harmonic { phase: f64::from(turn) * PI / 4.0, ..BENCH_SHAPE };
            let both = BENCH_BOBBIN.answer_to_force(&BENCH_FORCE).at(t).value
                + BENCH_BOBBIN.answer_to_shape(&shape).at(t).value;
            most = most.max(both.abs());
        }
    }
    assert!(most <= sum && most > 0.95 * sum, "{most} of {sum}");
}

#[test]
fn mass_grows_by_the_ring_of_yarn() {
    assert!((BENCH_MASS.at(0.03) - 1.9).abs() < 1e-15);
    // A ring of 3 and 5 cm: 16 pi cm^2.
    assert!((BENCH_MASS.at(0.05) - 1.9 - 16e-4 * PI * 52.5).abs() < 1e-14);
}

#[test]
fn the_mass_by_weights_is_not_the_mass_by_kinetic_energy() {
    // Bobbin at 1 rad/s on its arm of 15 cm: 2 T/v^2 of both masses.
    let (bobbin, links) = (0.15, 0.1);
    let twice_kinetic = 1.5 * bobbin * bobbin + 0.9 * links * links;
    assert!((BENCH_MASS.at(0.03) - twice_kinetic / (bobbin * bobbin)).abs() < 1e-14);
    assert!((BENCH_MASS.as_printed(0.03) - 2.1).abs() < 1e-15);
    let frequency = |mass| BobbinOscillator { mass, ..BENCH_BOBBIN }.natural_frequency();
    assert!((frequency(1.9) - 155.26).abs() < 5e-3 && (frequency(2.1) - 147.68).abs() < 5e-3);
}

#![expect(clippy::float_cmp, reason = "numbers that must come out exactly")]

use super::*;

const STUDY: ReedShaft = REED_STUDY;

fn with_contact(share: f64) -> ReedShaft {
    ReedShaft { contact_stiffness: share * STUDY.reed_stiffness, ..STUDY }
}

/// Simpson's rule on both segments.
fn integral(shaft: &ReedShaft, f: impl Fn(f64) -> f64) -> f64 {
    const HALVES: u32 = 400;
    let simpson = |from: f64, until: f64| {
        let h = (until - from) / f64::from(2 * HALVES);
        let at = |index: u32| f(from + h * f64::from(index));
        let inner: f64 =
            (0..HALVES).map(|half| at(2 * half) + 4.0 * at(2 * half + 1) + at(2 * half + 2)).sum();
        inner * h / 3.0
    };
    simpson(0.0, shaft.reed_place()) + simpson(shaft.reed_place(), shaft.end_place())
}

#[test]
fn scales_are_those_of_the_study() {
    for (found, expected, half_a_digit) in [
        (STUDY.length_scale(), 1.044_23, 5e-6),
        (STUDY.time_scale(), 3.295_00e-4, 5e-10),
        (STUDY.beta(), 0.345_133, 5e-7),
        (STUDY.alpha(), 0.453_398, 5e-7),
        (STUDY.reed_place(), 0.957_639, 5e-7),
        (STUDY.end_place(), 1.675_868, 5e-7),
        (STUDY.drive_amplitude(), 0.251_720, 5e-7),
        (STUDY.drive_frequency(), 119.180, 5e-4),
    ] {
        assert!((found - expected).abs() <= half_a_digit, "{found} is not {expected}");
    }
}

#[test]
fn frequencies_with_the_reed_held_and_free_are_known_to_ten_digits() {
    let held =
        [0.773_133_295_9, 2.136_006_785_8, 3.943_522_315_2, 5.738_231_766_3, 7.588_614_904_7];
    let free = [0.502_811_117_5, 1.035_664_812_3, 2.136_030_375_7, 3.945_769_307_1];
    for (reed, roots) in [(Reed::Held, &held[..]), (Reed::Free, &free[..])] {
        for (k, root) in (1..).zip(roots) {
            let found = STUDY.frequency(k, reed);
            assert!((found - root).abs() < 1e-10, "{reed:?} {k}: {found} is not {root}");
        }
    }
}

#[test]
fn every_frequency_solves_the_equation_and_none_is_missed() {
    for shaft in [STUDY, with_contact(0.5), with_contact(1.0)] {
        for reed in [Reed::Held, Reed::Free] {
            let roots: Vec<f64> = (1..=40).map(|k| shaft.frequency(k, reed)).collect();
            for root in &roots {
                let left = shaft.frequency_equation(*root, reed);
                assert!(left.abs() < 1e-12 * (1.0 + root.powi(2)) * 50.0, "{root}: {left}");
            }
            // Changes of sign, without those through infinity.
            let step = 1e-4;
            let is_crossing = |index: u32| {
                let (low, high) = (step * f64::from(index), step * f64::from(index + 1));
                let [a, b] = [low, high].map(|s| shaft.frequency_equation(s, reed));
                (a > 0.0) != (b > 0.0) && (a - b).abs() < 1.0 + 1e-2 * high * high
            };
            let end = (roots[39] / step) as u32 + 1;
            assert_eq!((1..end).filter(|index| is_crossing(*index)).count(), 40, "{reed:?}");
        }
    }
}

#[test]
fn the_equation_as_printed_has_other_roots() {
    let found = STUDY.printed_frequencies(3);
    for (found, printed) in found.iter().zip([0.7660, 2.1389, 3.8512]) {
        assert!((found - printed).abs() <= 5e-5, "{found} is not {printed}");
    }
    assert_eq!(found.len(), 3);
}

#[test]
fn contact_raises_the_frequencies_of_the_free_reed_towards_those_held() {
    for k in 1..=4 {
        let soft = STUDY.frequency(k, Reed::Free);
        let stiff = with_contact(1.0).frequency(k, Reed::Free);
        let stiffest = with_contact(1e9).frequency(k, Reed::Free);
        assert!(soft < stiff && stiff < stiffest);
        assert!((stiffest - STUDY.frequency(k, Reed::Held)).abs() < 1e-8);
    }
}

#[test]
fn mode_shapes_are_orthogonal() {
    for (shaft, reed) in [(STUDY, Reed::Held), (STUDY, Reed::Free), (with_contact(0.5), Reed::Free)]
    {
        let roots: Vec<f64> = (1..=5).map(|k| shaft.frequency(k, reed)).collect();
        let product = |i: f64, j: f64| {
            let along = integral(&shaft, |xi| {
                shaft.mode_shape(xi, i, reed) * shaft.mode_shape(xi, j, reed)
            });
            along + shaft.alpha() * shaft.mode_reed(i, reed) * shaft.mode_reed(j, reed)
        };
        for (index, i) in roots.iter().enumerate() {
            for j in &roots[..index] {
                let size = (product(*i, *i) * product(*j, *j)).sqrt();
                assert!(product(*i, *j).abs() < 1e-8 * size, "{reed:?} {i} {j}");
            }
        }
    }
}

#[test]
fn mode_shapes_satisfy_the_equations_of_motion() {
    let (reed, s) = (Reed::Free, with_contact(0.5).frequency(3, Reed::Free));
    let shaft = with_contact(0.5);
    let shape = |xi: f64| shaft.mode_shape(xi, s, reed);
    let h = 1e-4;
    for xi in [0.3, 1.2] {
        let bend = (shape(xi - h) - 2.0 * shape(xi) + shape(xi + h)) / (h * h);
        assert!((bend + s * s * shape(xi)).abs() < 1e-5);
    }
    let slope = |xi: f64, h: f64| {
        (-3.0 * shape(xi) + 4.0 * shape(xi + h) - shape(xi + 2.0 * h)) / (2.0 * h)
    };
    assert!((slope(0.0, h) - shape(0.0)).abs() < 1e-6);
    assert!(slope(shaft.end_place(), -h).abs() < 1e-6);
    let place = shaft.reed_place();
    let angle = shaft.mode_reed(s, reed);
    let force = shaft.beta() * (shape(place) - angle);
    // From the right, starting just beside the kink.
    assert!((slope(place, h) - slope(place, -h) - force).abs() < 1e-6);
    assert!((force - (shaft.contact() - shaft.alpha() * s * s) * angle).abs() < 1e-12);
}

#[test]
fn the_harmonic_answer_is_the_sum_over_all_modes() {
    let shaft = with_contact(0.5);
    let (amplitude, frequency) = (shaft.drive_amplitude(), 3.0 * shaft.drive_frequency());
    let answer = shaft.harmonic_response(amplitude, frequency, Reed::Free);
    let w = frequency * shaft.time_scale();
    let (mut reed, mut angle) = (0.0, 0.0);
    for k in 1..=150 {
        let s = shaft.frequency(k, Reed::Free);
        let own = shaft.mode_reed(s, Reed::Free);
        let norm = integral(&shaft, |xi| shaft.mode_shape(xi, s, Reed::Free).powi(2))
            + shaft.alpha() * own * own;
        // The drive acts on u(0) = 1 of each shape.
        let size = amplitude / (norm * (s * s - w * w));
        reed += size * own;
        angle += size * shaft.mode_shape(1.3 / shaft.length_scale(), s, Reed::Free);
    }
    // Tails fall as k^-4 of the reed, and as k^-2 with changing signs of the shaft.
    assert!((reed / answer.reed_angle() - 1.0).abs() < 1e-6, "{reed}");
    assert!((angle / answer.angle(1.3) - 1.0).abs() < 1e-4, "{angle}");
}

#[test]
fn stresses_beside_the_reed_differ_by_the_torque_it_takes() {
    for shaft in [STUDY, with_contact(0.5), with_contact(1.0)] {
        let answer =
            shaft.harmonic_response(shaft.drive_amplitude(), shaft.drive_frequency(), Reed::Free);
        let [toward, away] = answer.stress_beside_reed();
        let twist = answer.angle(shaft.reed_position) - answer.reed_angle();
        let torque = shaft.reed_stiffness * twist;
        let expected = torque * shaft.radius / shaft.polar_moment();
        assert!(((away - toward) / expected - 1.0).abs() < 1e-9);
        assert_eq!(answer.stress(shaft.reed_position), toward);
        // From differences of the angle.
        let (x, h) = (0.5, 1e-6);
        let slope = (answer.angle(x + h) - answer.angle(x - h)) / (2.0 * h);
        let expected = shaft.shear_modulus() * shaft.radius * slope;
        assert!((answer.stress(x) / expected - 1.0).abs() < 1e-6);
        assert!(answer.stress(shaft.length).abs() < 1e-6 * toward.abs());
    }
}

#[test]
fn stiffer_contact_changes_the_motion_little_and_the_stress_markedly() {
    let answer = |shaft: ReedShaft| {
        shaft.harmonic_response(shaft.drive_amplitude(), shaft.drive_frequency(), Reed::Free)
    };
    let (half, whole) = (answer(with_contact(0.5)), answer(with_contact(1.0)));
    let change = |of: fn(&DrivenReed) -> f64| (of(&whole) / of(&half) - 1.0).abs();
    let motion = change(|answer| answer.angle(REED_STUDY.reed_position));
    let stress = change(|answer| answer.stress_beside_reed()[0]);
    assert!(stress > 3.0 * motion, "motion {motion}, stress {stress}");
}

//! Machines of the field: a rotor that rubs, a mass that grazes its stop, an oscillator with many
//! folds.

use std::f64::consts::TAU;

use machinist::Simulation;
use machinist::periodic::{Bifurcation, BranchSettings, CycleSettings, Stability, branch, cycle};
use machinist_codegen::mechanics::reduce::Keep;
use nalgebra::{Matrix2, Matrix4, Vector2, Vector4};

use super::specs::{JEFFCOTT, STOPPED, rotor};
use super::{crest, near, of_period};
use crate::own_scene::of_text;

const DAMPING: f64 = 0.1;
const UNBALANCE: f64 = 0.3;
const PLAY: f64 = 1.0;
const STOP: f64 = 2.0;

/// Returns force over way, and its slope, at a radius.
fn stiffness(radius: f64) -> (f64, f64) {
    if radius > PLAY { (1.0 + STOP * (1.0 - PLAY / radius), 1.0 + STOP) } else { (1.0, 1.0) }
}

/// Returns the squares of the speeds at which the whirl has a radius: of
/// `((K - w^2)^2 + (c w)^2) r^2 = (u w^2)^2`, the smaller first.
fn squares(radius: f64) -> Option<[f64; 2]> {
    let (k, _) = stiffness(radius);
    let a = radius * radius - UNBALANCE * UNBALANCE;
    let b = (DAMPING * DAMPING - 2.0 * k) * radius * radius;
    let c = k * k * radius * radius;
    let root = (b * b - 4.0 * a * c).sqrt();
    let found = [(-b - root) / (2.0 * a), (-b + root) / (2.0 * a)];
    found.iter().all(|square| *square > 0.0).then_some(found)
}

/// Returns the sums of the first four powers of the multipliers: in the turning frame the
/// disturbance has constant coefficients, and turns by a whole turn in a period.
fn sums(radius: f64, speed: f64) -> [f64; 4] {
    let (across, along) = stiffness(radius);
    let square = speed * speed;
    let rate = Matrix4::new(
        0.0,
        0.0,
        1.0,
        0.0,
        0.0,
        0.0,
        0.0,
        1.0,
        square - along,
        DAMPING * speed,
        -DAMPING,
        2.0 * speed,
        -DAMPING * speed,
        square - across,
        -2.0 * speed,
        -DAMPING,
    );
    // exp(A T) as a power of exp(A T/4096), by its series.
    let small = rate * (TAU / speed / 4096.0);
    let (mut term, mut flow) = (Matrix4::identity(), Matrix4::identity());
    for order in 1..12 {
        term = term * small / f64::from(order);
        flow += term;
    }
    for _ in 0..12 {
        flow *= flow;
    }
    let mut power = Matrix4::identity();
    [(); 4].map(|()| {
        power *= flow;
        power.trace()
    })
}

#[test]
fn a_rotor_in_play_whirls_with_the_radius_and_multipliers_of_its_closed_form() {
    let scene = of_text(&rotor(JEFFCOTT), Keep::Needed);
    let mut touches = 0;
    for speed in [0.3, 0.6, 0.95, 1.1, 1.25, 3.0] {
        let run = Simulation::new(scene.single());
        let run = run.parameter("disc.speed", speed).expect("a parameter");
        let found = cycle(&run, &of_period("disc.speed", 400.0)).expect("a cycle");
        let radius = crest(&found, "way");
        let (k, _) = stiffness(radius);
        let left = radius * (k - speed * speed).hypot(DAMPING * speed);
        near(left, UNBALANCE * speed * speed, 1e-8);
        let mut powers = Vector4::zeros();
        for one in &found.multipliers {
            let one = num_complex::Complex64::new(one.real, one.imaginary);
            let power = |n: i32| one.powi(n).re;
            powers += Vector4::new(power(1), power(2), power(3), power(4));
        }
        for (found, wanted) in powers.iter().zip(sums(radius, speed)) {
            assert!((found - wanted).abs() < 1e-8, "{speed}: {found}, not {wanted}");
        }
        touches += usize::from(radius > PLAY);
    }
    assert!((2..=3).contains(&touches), "{touches}");
}

/// The amplitude jumps down where the smaller and the larger speed of a radius meet.
#[test]
fn a_rotor_in_play_leaves_its_stop_at_the_fold_of_its_closed_form() {
    // The largest radius: bisection on the discriminant.
    let (mut low, mut high) = (PLAY, 100.0);
    for _ in 0..200 {
        let middle = 0.5 * (low + high);
        if squares(middle).is_some() { low = middle } else { high = middle }
    }
    let turning = |side: usize| {
        let speed = |radius: f64| squares(radius).map_or(f64::NAN, |s| s[side].sqrt());
        let (mut a, mut b) = (PLAY, low);
        for _ in 0..300 {
            let (c, d) = (a + (b - a) / 3.0, b - (b - a) / 3.0);
            if speed(c) < speed(d) { a = c } else { b = d }
        }
        speed(0.5 * (a + b))
    };
    let wanted = turning(1);
    let scene = of_text(&rotor(JEFFCOTT), Keep::Needed);
    let settings = BranchSettings {
        cycle: CycleSettings { points: 101, ..of_period("disc.speed", 400.0) },
        parameter: "disc.speed".to_owned(),
        from: 0.5,
        to: 3.0,
        longest_step: 0.05,
        max_points: 400,
    };
    let found = branch(&Simulation::new(scene.single()), &settings).expect("a branch");
    assert!(found.is_complete, "{}", found.end);
    // The branch turns back with a corner where the disc leaves the stop.
    let corner = squares(PLAY).expect("a whirl")[1].sqrt();
    let bends: Vec<_> = found.bifurcations().map(|(kind, point)| (kind, point.value)).collect();
    let [(first, touch), (second, fold), (third, turn)] = bends[..] else { panic!("{bends:?}") };
    let kinds = [Bifurcation::Jump, Bifurcation::Fold, Bifurcation::NonsmoothFold];
    assert_eq!([first, second, third], kinds);
    near(touch, squares(PLAY).expect("a whirl")[0].sqrt(), 1e-8);
    near(fold, wanted, 1e-8);
    near(turn, corner, 1e-8);
    // Beyond it the disc turns freely, up to the end of the range.
    let at = found.points.iter().position(|point| point.value.to_bits() == turn.to_bits());
    let free = &found.points[at.expect("the corner") + 1..];
    assert!(free.len() > 3);
    for point in free {
        let speed = point.value;
        let radius = UNBALANCE * speed * speed / (1.0 - speed * speed).hypot(DAMPING * speed);
        near(crest(&point.cycle, "way"), radius, 1e-8);
        assert_eq!(point.cycle.stability, Stability::Stable);
    }
}

/// Relation of the impact at time t of a motion with one impact in a period, which vanishes: with
/// the flow E of the free oscillation over a period T, the steady response p fulfils
///
/// ```text
/// (E - 1) (1 - p(t), -p'(t)) = v (e_2 + r E e_2)
/// ```
///
/// for the speed v and the restitution r. F. Peterka, 1974; S. Shaw and P. Holmes, J. Sound Vib. 90,
/// 1983.
fn of_one_impact(force: f64, frequency: f64, time: f64) -> f64 {
    let (found, per_speed) = sides_of_one_impact(force, frequency, time);
    found[0] * per_speed[1] - found[1] * per_speed[0]
}

const RESTITUTION: f64 = 0.7;

/// Returns (1 - p, -p') at the impact, and (E - 1)^-1 (e_2 + r E e_2): speed times the second is the
/// first.
fn sides_of_one_impact(force: f64, frequency: f64, time: f64) -> (Vector2<f64>, Vector2<f64>) {
    let flow = free_flow(TAU / frequency);
    let across = flow * Vector2::new(0.0, RESTITUTION) + Vector2::new(0.0, 1.0);
    let per_speed = (flow - Matrix2::identity()).try_inverse().expect("no resonance") * across;
    (Vector2::new(1.0, 0.0) - steady(force, frequency, time), per_speed)
}

/// Returns the flow of the free oscillator over a time.
fn free_flow(time: f64) -> Matrix2<f64> {
    let damping = 0.1_f64;
    let own = (1.0 - damping * damping).sqrt();
    let (sine, cosine) = (own * time).sin_cos();
    (-damping * time).exp()
        * Matrix2::new(
            cosine + damping / own * sine,
            sine / own,
            -sine / own,
            cosine - damping / own * sine,
        )
}

/// Returns the steady response and its speed.
fn steady(force: f64, frequency: f64, time: f64) -> Vector2<f64> {
    let amplitude = force / (1.0 - frequency * frequency).hypot(0.2 * frequency);
    let lag = (0.2 * frequency).atan2(1.0 - frequency * frequency);
    let (sine, cosine) = (frequency * time - lag).sin_cos();
    Vector2::new(amplitude * cosine, -frequency * amplitude * sine)
}

/// Returns the greatest way between the impacts of a motion with one of them in a period, away from
/// the impacts.
fn peak_between_impacts(force: f64, frequency: f64, time: f64) -> f64 {
    let (found, per_speed) = sides_of_one_impact(force, frequency, time);
    let speed = found.dot(&per_speed) / per_speed.norm_squared();
    let after = Vector2::new(1.0, -RESTITUTION * speed) - steady(force, frequency, time);
    let way = |share: f64| {
        let since = share * TAU / frequency;
        (free_flow(since) * after + steady(force, frequency, time + since))[0]
    };
    (500..9500).map(|number| way(f64::from(number) * 1e-4)).fold(f64::NEG_INFINITY, f64::max)
}

/// Returns the least force of a motion with one impact in a period: the relation of the impact is
/// affine in the force, which is stationary over the time of the impact. The impact comes before the
/// crest of the steady response that grazes at `answer`.
fn fold_of_one_impact(frequency: f64, answer: f64) -> f64 {
    let force = |time: f64| {
        let [at_rest, at_one] = [0.0, 1.0].map(|force| of_one_impact(force, frequency, time));
        at_rest / (at_rest - at_one)
    };
    let crest = (0.2 * frequency).atan2(1.0 - frequency * frequency) / frequency;
    near(force(crest), answer, 1e-12);
    let (mut low, mut high) = (crest - 0.2 * TAU / frequency, crest);
    for _ in 0..200 {
        let (a, b) = (low + (high - low) / 3.0, high - (high - low) / 3.0);
        if force(a) < force(b) { high = b } else { low = a }
    }
    force(0.5 * (low + high))
}

/// Without impacts the multipliers are those of the free oscillator; the motion grazes the stop
/// where its amplitude is the gap. Beyond, there are motions with an impact in a period.
#[test]
fn an_oscillator_grazes_its_stop_where_its_amplitude_is_the_gap() {
    let scene = of_text(STOPPED, Keep::Needed);
    for frequency in [0.6_f64, 1.3, 2.2] {
        let answer = (1.0 - frequency * frequency).hypot(0.2 * frequency);
        let run = Simulation::new(scene.single());
        let run = run.parameter("block.frequency", frequency).expect("a parameter");
        let settings = BranchSettings {
            cycle: CycleSettings { points: 101, ..of_period("block.frequency", 300.0) },
            parameter: "block.force".to_owned(),
            from: 0.5 * answer,
            to: 1.5 * answer,
            longest_step: 0.1,
            max_points: 200,
        };
        let run = run.parameter("block.force", 0.5 * answer).expect("a parameter");
        let found = branch(&run, &settings).expect("a branch");
        let decay = (-0.1 * TAU / frequency).exp();
        let free = found.points.iter().take_while(|point| point.cycle.motion.switches.is_empty());
        for point in free.filter(|point| point.bifurcation.is_none()) {
            assert_eq!(point.cycle.stability, Stability::Stable);
            near(point.cycle.multipliers[0].modulus, decay, 1e-8);
            near(crest(&point.cycle, "x"), point.value / answer, 1e-2);
        }
        let grazing = found.bifurcations().find(|(kind, _)| *kind == Bifurcation::Grazing);
        let (_, grazing) = grazing.unwrap_or_else(|| panic!("no grazing: {}", found.end));
        near(grazing.value, answer, 1e-8);
        assert_eq!(grazing.grazed.as_deref(), Some("`block.impact`"));
        let mut impacts = 0;
        for point in found.points.iter().filter(|point| point.cycle.motion.switches.len() == 1) {
            let time = point.cycle.motion.switches[0].time;
            let off = of_one_impact(point.value, frequency, time);
            // The time of an impact is the less exact, the slower it is.
            let room = if (point.value / answer - 1.0).abs() > 1e-4 { 1e-7 } else { 1e-5 };
            assert!(off.abs() < room, "{off:e} at {}", point.value);
            impacts += 1;
        }
        assert!(impacts > 10, "{impacts}");
        assert!(found.is_complete, "{frequency}: {}", found.end);
        // Below 2 rad/s the branch leads back to a fold; on its way the impact may pass the start
        // of the period.
        let folds = found.bifurcations().filter(|(kind, _)| *kind == Bifurcation::Fold);
        let folds: Vec<f64> = folds.map(|(_, point)| point.value).collect();
        if frequency < 2.0 {
            let [fold] = folds[..] else { panic!("{folds:?}") };
            near(fold, fold_of_one_impact(frequency, answer), 1e-8);
        } else {
            assert!(folds.is_empty(), "{folds:?}");
        }
        if frequency < 1.0 {
            // Beyond, a second impact in a period begins where the motion touches the stop again.
            let grazings = found.bifurcations().filter(|(kind, _)| *kind == Bifurcation::Grazing);
            let (_, second) = grazings.last().expect("a second grazing");
            assert_eq!(second.grazed.as_deref(), Some("`block.impact`"));
            let time = second.cycle.motion.switches[0].time;
            near(peak_between_impacts(second.value, frequency, time), 1.0, 1e-6);
            let last = found.points.last().expect("a point");
            assert_eq!(last.cycle.motion.switches.len(), 2);
        }
    }
}

/// x'' + 2 zeta x' + x + 0.05 sin(10 x) = F cos t over F: the response turns back again and again.
/// Harmonic balance with 60 odd harmonics gives its folds (`tests/cycles/references.py`).
#[test]
fn a_branch_passes_sixteen_folds() {
    let scene = of_text(
        r#"
        [scene]
        name = "wavy"
        [units.block]
        unit = "block"
        [outputs]
        x = "block.x"
        [run]
        until = 600.0
        points = 2
        rtol = 1e-10
        method = "dop853"
        [define.block.coordinates.x]
        unit = "m"
        velocity = "v"
        [define.block.parameters]
        force = { value = 0.005, unit = "N" }
        [define.block.energy]
        kinetic = "1 [kg]*v^2/2"
        potential = "1 [N/m]*x^2/2 - 0.005 [N m]*cos(10*x/1 [m])"
        dissipation = "0.02 [N s/m]*v^2/2"
        [[define.block.forces]]
        coordinate = "x"
        expression = "force*cos(1 [rad/s]*t)"
        "#,
        Keep::Needed,
    );
    let cycle = CycleSettings {
        period: machinist::periodic::Period::Fixed(TAU),
        settle: 600.0,
        points: 101,
        ..CycleSettings::default()
    };
    let settings = BranchSettings {
        cycle,
        parameter: "block.force".to_owned(),
        from: 0.005,
        to: 0.06,
        longest_step: 0.05,
        max_points: 2000,
    };
    let found = branch(&Simulation::new(scene.single()), &settings).expect("a branch");
    assert!(found.is_complete, "{}", found.end);
    let folds: Vec<f64> = found
        .bifurcations()
        .filter(|(kind, _)| *kind == Bifurcation::Fold)
        .map(|(_, point)| point.value)
        .collect();
    assert_eq!(folds.len(), FOLDS.len(), "{folds:?}");
    for (fold, wanted) in folds.into_iter().zip(FOLDS) {
        near(fold, wanted, 1e-7);
    }
}

const FOLDS: [f64; 16] = [
    0.058_497_853_265_351,
    0.007_687_739_532_470_88,
    0.036_885_331_483_564_6,
    0.013_976_413_358_453_3,
    0.031_875_355_303_514_3,
    0.020_305_298_162_053_6,
    0.033_347_202_176_268_8,
    0.026_520_843_759_781_2,
    0.036_192_715_188_757_4,
    0.032_783_203_723_484,
    0.040_936_012_229_081_1,
    0.038_985_113_917_976_3,
    0.045_941_795_151_591_6,
    0.045_189_269_252_365,
    0.051_684_909_682_359_9,
    0.051_378_123_060_769_8,
];

/// Rotor with unbalance, damping of the bearings and of the shaft itself, which turns with it.
const DAMPED_WITHIN: &str = r#"
    [define.disc.parameters]
    speed = { value = 1.3, unit = "rad/s" }
    outer = { value = 0.1, unit = "N s/m" }
    inner = { value = 0.15, unit = "N s/m" }
    hardening = { value = 0.0, unit = "N/m^3" }
    [define.disc.energy]
    kinetic = "1 [kg]*(x_dot^2 + y_dot^2)/2"
    potential = "1 [N/m]*(x^2 + y^2)/2 + hardening*(x^2 + y^2)^2/4"
    dissipation = "outer*(x_dot^2 + y_dot^2)/2"
    [[define.disc.forces]]
    coordinate = "x"
    expression = "0.3 [kg m]*speed^2*cos(speed*t) - inner*(x_dot + speed*y/1 [rad])"
    [[define.disc.forces]]
    coordinate = "y"
    expression = "0.3 [kg m]*speed^2*sin(speed*t) - inner*(y_dot - speed*x/1 [rad])"
"#;

/// Returns the largest real part of the exponents of the whirl: in the turning frame the disturbance
/// has constant coefficients.
fn largest_exponent(speed: f64, hardening: f64) -> f64 {
    let (outer, inner) = (0.1, 0.15);
    // r^2 ((1 + h r^2 - w^2)^2 + (c w)^2) = (u w^2)^2: above resonance, the smallest radius.
    let square = speed * speed;
    let off = |radius: f64| {
        radius * (1.0 + hardening * radius * radius - square).hypot(outer * speed)
            - UNBALANCE * square
    };
    let (mut low, mut high) = (0.0, 1.0);
    while off(high) < 0.0 {
        high *= 1.01;
    }
    for _ in 0..200 {
        let middle = 0.5 * (low + high);
        if off(middle) < 0.0 { low = middle } else { high = middle }
    }
    let (across, along) =
        (1.0 + hardening * low * low - square, 1.0 + 3.0 * hardening * low * low - square);
    let whole = outer + inner;
    let rate = Matrix4::new(
        0.0,
        0.0,
        1.0,
        0.0, //
        0.0,
        0.0,
        0.0,
        1.0, //
        -along,
        outer * speed,
        -whole,
        2.0 * speed, //
        -outer * speed,
        -across,
        -2.0 * speed,
        -whole,
    );
    rate.complex_eigenvalues().iter().fold(f64::NEG_INFINITY, |most, value| most.max(value.re))
}

/// Damping within a shaft drives its whirl above the speed w (1 + outer/inner) (Smith 1933): a pair
/// of multipliers leaves the unit circle.
#[test]
fn damping_within_a_shaft_drives_a_second_frequency_above_the_speed_of_its_closed_form() {
    let scene = of_text(&rotor(DAMPED_WITHIN), Keep::Needed);
    for hardening in [0.0, 0.05] {
        let run = Simulation::new(scene.single());
        let run = run.parameter("disc.hardening", hardening).expect("a parameter");
        let settings = BranchSettings {
            cycle: CycleSettings { points: 101, ..of_period("disc.speed", 400.0) },
            parameter: "disc.speed".to_owned(),
            from: 1.4,
            to: 2.2,
            longest_step: 0.1,
            max_points: 100,
        };
        let run = run.parameter("disc.speed", 1.4).expect("a parameter");
        let found = branch(&run, &settings).expect("a branch");
        assert!(found.is_complete, "{}", found.end);
        let (mut low, mut high) = (1.4, 2.2);
        for _ in 0..100 {
            let middle = 0.5 * (low + high);
            if largest_exponent(middle, hardening) < 0.0 { low = middle } else { high = middle }
        }
        if hardening == 0.0 {
            near(low, 1.0 + 0.1 / 0.15, 1e-9);
        }
        let all: Vec<_> = found.bifurcations().map(|(kind, point)| (kind, point.value)).collect();
        let [(kind, value)] = all[..] else { panic!("{all:?}") };
        assert_eq!(kind, Bifurcation::NeimarkSacker);
        near(value, low, 1e-7);
        for point in found.points.iter().filter(|point| point.bifurcation.is_none()) {
            let growth = (largest_exponent(point.value, hardening) * TAU / point.value).exp();
            near(point.cycle.multipliers[0].modulus, growth, 1e-7);
        }
    }
}

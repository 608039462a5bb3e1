//! Flips and what is beyond: a mass that bounces on a shaken plate, whose motions of one and two
//! periods have a closed form, and Roessler's equations.

use std::f64::consts::TAU;

use machinist::Simulation;
use machinist::periodic::{
    Bifurcation, BranchPoint, BranchSettings, CycleSettings, Stability, branch, cycle, doubled,
};
use machinist_codegen::mechanics::reduce::Keep;
use machinist_scenes::scenes::bouncing_mass::BouncingMass;

use super::{near, of_period};
use crate::own_scene::of_text;

/// Derivatives of the map from one impact to the next, of time and speed after the impact, in
/// period-1 motion: flight time T, plate speed w and acceleration a at the impact.
fn of_impact_map(period: f64, restitution: f64, gravity: f64, w: f64, a: f64) -> [f64; 2] {
    let down = -gravity * period / 2.0;
    // plate(t') = plate(t) + v (t' - t) - g/2 (t' - t)^2
    let (dt_dt, dt_dv) = (1.0, period / (w - down));
    // v' = w(t') (1 + e) - e (v - g (t' - t))
    let by_end = (1.0 + restitution) * a + restitution * gravity;
    let dv_dt = by_end * dt_dt - restitution * gravity;
    let dv_dv = by_end * dt_dv - restitution;
    [dt_dt + dv_dv, dt_dt * dv_dv - dt_dv * dv_dt]
}

#[test]
fn a_bouncing_mass_has_the_closed_form_of_one_bounce_a_period() {
    let (period, restitution, gravity) = (0.1, 0.8, 9.81);
    for amplitude in [1.6e-3, 1.7395e-3, 1.8e-3] {
        let run = Simulation::new(&BouncingMass).rtol(1e-11);
        let run = run.parameter("amplitude", amplitude).expect("a parameter");
        let found = cycle(&run, &of_period("frequency", 2.0)).expect("a cycle");
        let impacts: Vec<_> = found.motion.switches.iter().collect();
        assert_eq!(impacts.len(), 1);
        let omega = TAU / period;
        let speed = gravity * period / 2.0 * (1.0 - restitution) / (1.0 + restitution);
        let phase = (speed / (amplitude * omega)).acos();
        let at = (omega * impacts[0].time).rem_euclid(TAU);
        assert!((at - phase).abs() < 1e-8 || (at + phase - TAU).abs() < 1e-8, "{at} {phase}");
        let acceleration = -amplitude * omega * omega * at.sin();
        let [trace, determinant] = of_impact_map(period, restitution, gravity, speed, acceleration);
        let [one, two] = &found.multipliers[..] else { panic!("{:?}", found.multipliers) };
        assert!((one.real + two.real - trace).abs() < 1e-8, "{trace}: {one:?}");
        let product = one.real * two.real - one.imaginary * two.imaginary;
        assert!((product - determinant).abs() < 1e-8);
        assert!((determinant - restitution * restitution).abs() < 1e-12);
    }
}

/// Beyond a flip two bounces follow each other in two periods, at plate phases that fulfil the laws
/// of free flight and of the impact; their difference grows as the square root of the way from the
/// flip.
fn assert_two_bounces(run: &Simulation<'_>, settings: &BranchSettings, flip: &BranchPoint) {
    let (omega, restitution, gravity) = (TAU / 0.1, 0.8, 9.81);
    let found = doubled(run, settings, flip).expect("a branch of twice the period");
    assert!(found.is_complete, "{}", found.end);
    let start = found.points.first().expect("the flip").value;
    let of_motion = found.points[1..].iter().filter(|point| point.bifurcation.is_none());
    let mut growth = Vec::new();
    for point in of_motion {
        assert!(point.value > start);
        near(point.cycle.period, 0.2, 1e-12);
        let [first, second] = [0, 1].map(|index| point.cycle.motion.switches[index].time);
        let height = |time: f64| point.value * (omega * time).sin();
        let speed = |time: f64| point.value * omega * (omega * time).cos();
        // Speeds after the impacts from the ways of both flights, then the law of the impact.
        let after = |from: f64, to: f64| {
            (height(to) - height(from)) / (to - from) + gravity * (to - from) / 2.0
        };
        let (one, two) = (after(first, second), after(second, first + 0.2));
        for (after, before, time) in [
            (two, one - gravity * (second - first), second),
            (one, two - gravity * (first + 0.2 - second), first),
        ] {
            let off = after - (speed(time) * (1.0 + restitution) - restitution * before);
            assert!(off.abs() < 1e-7, "{off:e}");
        }
        growth.push(((second - first - 0.1).powi(2), point.value - start));
    }
    let [(a, x), (b, y)] = growth[..2] else { panic!("few points") };
    assert!((a / x / (b / y) - 1.0).abs() < 0.2, "{growth:?}");
    assert_eq!(found.points[1].cycle.stability, Stability::Stable);
}

#[test]
fn a_bouncing_mass_doubles_its_period_where_the_closed_form_says() {
    let (period, restitution, gravity): (f64, f64, f64) = (0.1, 0.8, 9.81);
    let omega = TAU / period;
    let speed = gravity * period / 2.0 * (1.0 - restitution) / (1.0 + restitution);
    // At a flip the trace is -(1 + e^2); it is linear in the acceleration of the plate.
    let trace =
        |acceleration: f64| of_impact_map(period, restitution, gravity, speed, acceleration)[0];
    let slope = trace(1.0) - trace(0.0);
    let acceleration = (-(1.0 + restitution * restitution) - trace(0.0)) / slope;
    let wanted = (speed / omega).hypot(acceleration / (omega * omega));
    let settings = BranchSettings {
        cycle: CycleSettings { points: 101, ..of_period("frequency", 2.0) },
        parameter: "amplitude".to_owned(),
        from: 1.7e-3,
        to: 3.0e-3,
        longest_step: 0.1,
        max_points: 200,
    };
    let run = Simulation::new(&BouncingMass).rtol(1e-11);
    let found = branch(&run, &settings).expect("a branch");
    let flips: Vec<_> =
        found.bifurcations().filter(|(kind, _)| *kind == Bifurcation::Flip).collect();
    assert_eq!(
        flips.len(),
        1,
        "{:?}",
        found.bifurcations().map(|(k, p)| (k, p.value)).collect::<Vec<_>>()
    );
    near(flips[0].1.value, wanted, 1e-8);
    assert_two_bounces(&run, &settings, flips[0].1);
    // Towards smaller amplitudes the motion vanishes where the plate is just fast enough.
    let down = BranchSettings { to: 0.5e-3, ..settings };
    let down = branch(&run, &down).expect("a branch");
    let folds: Vec<_> =
        down.bifurcations().filter(|(kind, _)| *kind == Bifurcation::Fold).collect();
    near(folds[0].1.value, speed / omega, 1e-9);
    // Beyond, two bounces follow each other in two periods.
    let run = run.parameter("amplitude", wanted + 5e-5).expect("a parameter");
    let twice = CycleSettings { multiple: 2, ..of_period("frequency", 20.0) };
    let twice = cycle(&run, &twice).expect("a cycle");
    assert_eq!((twice.stability, twice.motion.switches.len()), (Stability::Stable, 2));
    let gaps = twice.motion.switches[1].time - twice.motion.switches[0].time;
    assert!((gaps - period).abs() > 1e-3, "{gaps}");
}

/// Motions of Roessler's equations, whose period is unknown, double at c = 2.832 (a = b = 0.2).
#[test]
fn a_motion_of_unknown_period_doubles_into_the_one_on_which_runs_settle() {
    let scene = of_text(
        r#"
        [scene]
        name = "roessler"
        [units.r]
        unit = "r"
        [initial]
        "r.x" = 2.0
        [outputs]
        x = "r.x"
        [run]
        until = 400.0
        points = 2
        rtol = 1e-10
        method = "dop853"
        [define.r.states.x]
        unit = "1"
        rate = "-(y + z)/1 [s]"
        [define.r.states.y]
        unit = "1"
        rate = "(x + 0.2*y)/1 [s]"
        [define.r.states.z]
        unit = "1"
        rate = "(0.2 + z*(x - c))/1 [s]"
        [define.r.parameters]
        c = { value = 2.5, unit = "1" }
        "#,
        Keep::Needed,
    );
    let run = Simulation::new(scene.single());
    for segments in [1, 2] {
        let settings = BranchSettings {
            cycle: CycleSettings { settle: 400.0, segments, ..CycleSettings::default() },
            parameter: "r.c".to_owned(),
            from: 2.5,
            to: 3.5,
            longest_step: 0.05,
            max_points: 300,
        };
        let found = branch(&run, &settings).expect("a branch");
        let flips: Vec<_> =
            found.bifurcations().filter(|(kind, _)| *kind == Bifurcation::Flip).collect();
        let [(_, flip)] = flips[..] else { panic!("{} flips", flips.len()) };
        assert!((flip.value - 2.832).abs() < 1e-3, "{}", flip.value);
        let twice = doubled(&run, &settings, flip).expect("a branch of twice the period");
        assert!(twice.is_complete, "{}", twice.end);
        let last = twice.points.last().expect("a point");
        let settled = run.clone().parameter("r.c", 3.5).expect("a parameter");
        let wanted = cycle(&settled, &settings.cycle).expect("a cycle");
        near(last.cycle.period, wanted.period, 1e-8);
        assert!(last.cycle.period > 1.9 * flip.cycle.period);
        let moduli = [&last.cycle, &wanted].map(|of| of.nontrivial().next().expect("one").modulus);
        assert!((moduli[0] - moduli[1]).abs() < 1e-6, "{moduli:?}");
        assert_eq!(last.cycle.stability, Stability::Stable);
    }
}

//! Eigenmodes about steady rotations in coordinates that turn with them, against closed forms.

use machinist::Simulation;
use machinist::linear_analysis::{Linearization, Mode, ModeKind, Place, operating_point};
use machinist_codegen::mechanics::reduce::Keep;
use machinist_contract::Simulator;
use machinist_model::ModelSimulator;

use crate::own_scene::of_text;

const ACROSS: f64 = 0.0012;
const AXIAL: f64 = 0.0005;
const MASS: f64 = 0.5;
const ARM: f64 = 0.04;

/// Returns a heavy top described by its unit quaternion, spinning upright, slightly disturbed.
fn top(spin: f64, push: f64, until: f64) -> ModelSimulator {
    of_text(
        &format!(
            r#"
            [scene]
            name = "top"
            [units.top]
            unit = "top"
            [initial]
            "top.w" = 1.0
            "top.x" = 0.0
            "top.y" = 0.0
            "top.z" = 0.0
            "top.x_dot" = {push:?}
            "top.y_dot" = 0.0
            "top.z_dot" = {:?}
            [outputs]
            height = "top.height"
            ex = "top.ex"
            ey = "top.ey"
            [run]
            until = {until:?}
            points = 3
            rtol = 1e-10
            method = "auto"
            [define.top.coordinates]
            w = {{ unit = "1" }}
            x = {{ unit = "1" }}
            y = {{ unit = "1" }}
            z = {{ unit = "1" }}
            [define.top.parameters]
            a = {{ value = {ACROSS}, unit = "kg m^2" }}
            c = {{ value = {AXIAL}, unit = "kg m^2" }}
            mass = {{ value = {MASS}, unit = "kg" }}
            arm = {{ value = {ARM}, unit = "m" }}
            [define.top.helpers]
            o1 = {{ expression = "2*(w*x_dot - x*w_dot - y*z_dot + z*y_dot)", unit = "rad/s" }}
            o2 = {{ expression = "2*(w*y_dot + x*z_dot - y*w_dot - z*x_dot)", unit = "rad/s" }}
            o3 = {{ expression = "2*(w*z_dot - x*y_dot + y*x_dot - z*w_dot)", unit = "rad/s" }}
            ex = {{ expression = "2*(x*z + w*y)", unit = "1" }}
            ey = {{ expression = "2*(y*z - w*x)", unit = "1" }}
            height = {{ expression = "arm*(w^2 - x^2 - y^2 + z^2)", unit = "m" }}
            [define.top.energy]
            kinetic = "(a*(o1^2 + o2^2) + c*o3^2)/2"
            potential = "mass*9.81 [m/s^2]*height"
            [define.top.constraints.unit_length]
            expression = "w^2 + x^2 + y^2 + z^2 - 1"
            "#,
            spin / 2.0
        ),
        Keep::All,
    )
}

fn modes(simulator: &dyn Simulator<f64>, place: Place) -> Vec<Mode> {
    let point = operating_point(&Simulation::new(simulator), place).expect("a point");
    Linearization::at(simulator, point).expect("finite").modes().expect("modes")
}

fn frequencies(modes: &[Mode]) -> Vec<f64> {
    let oscillations = modes.iter().filter(|mode| mode.kind == ModeKind::Oscillation);
    oscillations.map(|mode| mode.imaginary).collect()
}

/// a l^2 - c w l + m g h = 0 of tilts e^(i l t).
fn whirl(spin: f64) -> [f64; 2] {
    let (half, weight) = (AXIAL * spin / (2.0 * ACROSS), MASS * 9.81 * ARM / ACROSS);
    let fast = half + (half * half - weight).sqrt();
    [weight / fast, fast]
}

#[test]
fn a_sleeping_top_whirls_as_its_closed_form_says() {
    for spin in [80.0, 150.0, 400.0, -150.0] {
        let top = top(spin, 0.0, 1.0);
        for place in [Place::Initial, Place::Equilibrium] {
            let modes = modes(&top, place);
            assert!(modes.iter().all(|mode| !mode.grows()), "{spin}: {modes:?}");
            let found = frequencies(&modes);
            let expected = whirl(spin.abs());
            assert_eq!(found.len(), 2, "{spin}: {modes:?}");
            for (found, expected) in found.iter().zip(expected) {
                assert!((found / expected - 1.0).abs() < 1e-6, "{spin}: {found} {expected}");
            }
        }
    }
}

#[test]
fn a_top_that_is_too_slow_falls_as_its_closed_form_says() {
    // c w < 2 sqrt(a m g h) = 61.4 c rad/s
    for spin in [5.0_f64, 30.0, 60.0] {
        let modes = modes(&top(spin, 0.0, 1.0), Place::Initial);
        let (half, weight) = (AXIAL * spin / (2.0 * ACROSS), MASS * 9.81 * ARM / ACROSS);
        let growth = (weight - half * half).sqrt();
        let fastest = modes.iter().map(|mode| mode.real).fold(0.0, f64::max);
        assert!((fastest / growth - 1.0).abs() < 1e-6, "{spin}: {fastest} {growth}");
    }
}

/// Runs end at all phases of the nutation. A frame that precesses shifts both whirls by its speed,
/// and shows their difference.
#[test]
fn a_top_that_nutates_has_the_whirl_of_the_steady_motion_near() {
    let mut wrong = Vec::new();
    for spin in [100.0, 150.0, 300.0] {
        for push in [1e-3, 1e-2, 5e-2] {
            for until in [0.1, 0.37, 0.4, 0.5, 0.73, 1.0, 1.5, 2.0] {
                let modes = modes(&top(spin, push, until), Place::Equilibrium);
                let found = frequencies(&modes);
                let [slow, fast] = whirl(spin);
                let is = |w: f64| (w / (fast - slow) - 1.0).abs() < 1e-2;
                let shows_whirl = match found[..] {
                    [one] => is(one),
                    [one, other] => is(one + other) || is((one - other).abs()),
                    _ => false,
                };
                if modes.iter().any(Mode::grows) || !shows_whirl {
                    wrong.push(format!("{spin} {push} {until}: {found:?}"));
                }
            }
        }
    }
    assert_eq!(wrong, Vec::<String>::new());
}

/// A mass on a rod that goes round: w^2 = g/(l cos), deviations at W^2 = w^2 (1 + 3 cos^2).
#[test]
fn a_conical_pendulum_wobbles_as_its_closed_form_says() {
    for angle in [0.3_f64, 0.8, 1.2] {
        let (length, gravity) = (0.7, 9.81);
        let turns = (gravity / (length * angle.cos())).sqrt();
        let radius = length * angle.sin();
        let cone = of_text(
            &format!(
                r#"
                [scene]
                name = "cone"
                [units.bob]
                unit = "bob"
                [initial]
                "bob.x" = {radius:?}
                "bob.y" = 0.0
                "bob.z" = {:?}
                "bob.x_dot" = 0.0
                "bob.y_dot" = {:?}
                "bob.z_dot" = 0.0
                [outputs]
                height = "bob.z"
                [run]
                until = 0.5
                points = 3
                rtol = 1e-11
                [define.bob.coordinates]
                x = {{ unit = "m" }}
                y = {{ unit = "m" }}
                z = {{ unit = "m" }}
                [define.bob.parameters]
                mass = {{ value = 2, unit = "kg" }}
                length = {{ value = {length}, unit = "m" }}
                [define.bob.energy]
                kinetic = "mass*(x_dot^2 + y_dot^2 + z_dot^2)/2"
                potential = "mass*{gravity} [m/s^2]*z"
                [define.bob.constraints.rod]
                expression = "x^2 + y^2 + z^2 - length^2"
                "#,
                -length * angle.cos(),
                radius * turns
            ),
            Keep::All,
        );
        let expected = turns * (1.0 + 3.0 * angle.cos().powi(2)).sqrt();
        for place in [Place::Initial, Place::Equilibrium, Place::Time(0.21)] {
            let modes = modes(&cone, place);
            let [found] = frequencies(&modes)[..] else { panic!("{angle}: {modes:?}") };
            assert!((found / expected - 1.0).abs() < 1e-6, "{angle}: {found} {expected}");
            assert!(modes.iter().all(|mode| !mode.grows()), "{modes:?}");
        }
    }
}

/// A machine at rest has no rotation.
#[test]
fn a_machine_at_rest_has_the_modes_of_rest() {
    let top = top(0.0, 0.0, 1.0);
    let modes = modes(&top, Place::Initial);
    let growth = (MASS * 9.81 * ARM / ACROSS).sqrt();
    let fastest = modes.iter().map(|mode| mode.real).fold(0.0, f64::max);
    assert!((fastest / growth - 1.0).abs() < 1e-9, "{modes:?}");
}

//! States that move far less than their absolute tolerance assumes are reported.

use machinist::{Method, Simulation};
use machinist_codegen::mechanics::reduce::Keep;
use machinist_contract::Describe as _;
use machinist_model::ModelSimulator;

use crate::own_scene::of_text;

/// Returns a pendulum, which has no closed form, released at an angle, and a second one at rest.
fn pendulums(start: &str, more: &str) -> ModelSimulator {
    let text = format!(
        r#"
        [scene]
        name = "pendulums"
        [units.s]
        unit = "s"
        [initial]
        "s.a" = {start}
        [outputs]
        a = "s.a"
        b = "s.b"
        [run]
        until = 2.0
        points = 21
        rtol = 1e-8
        method = "auto"
        [define.s.coordinates]
        a = {{ unit = "rad"{more} }}
        b = {{ unit = "rad" }}
        [define.s.energy]
        kinetic = "1 [kg m^2]*(a_dot^2 + b_dot^2)/2"
        potential = "-1 [J]*(cos(a) + cos(b))"
        "#
    );
    of_text(&text, Keep::Needed)
}

fn told(scene: &ModelSimulator, adjust: impl Fn(Simulation<'_>) -> Simulation<'_>) -> Vec<String> {
    let run = adjust(Simulation::new(scene)).run().expect("it swings");
    run.notes.into_iter().filter(|note| note.contains("of the scale")).collect()
}

#[test]
fn a_motion_far_below_its_scale_is_told_of_with_both() {
    let small = told(&pendulums("1e-5", ""), |run| run);
    let [note] = &small[..] else { panic!("{small:?}") };
    assert!(note.contains("`s.a` (at most 1.0e-5 rad, scale 1e0)"), "{note}");
    assert!(note.contains("`s.a_dot`") && !note.contains("`s.b"), "{note}");
}

#[test]
fn nothing_is_told_where_scales_fit_or_tolerances_are_given() {
    assert_eq!(told(&pendulums("0.01", ""), |run| run), [""; 0]);
    let scaled = pendulums("1e-5", ", scale = 1e-5, velocity_scale = 1e-5");
    assert_eq!(told(&scaled, |run| run), [""; 0]);
    assert_eq!(told(&pendulums("1e-5", ""), |run| run.atol(&[1e-12; 4])), [""; 0]);
}

#[test]
fn bristles_are_weighed_by_what_they_do_wherever_they_stand_in_the_state() {
    let block = |more: &str, keep| -> ModelSimulator {
        let text = format!(
            r#"
            [scene]
            name = "block"
            [units.s]
            unit = "s"
            [outputs]
            friction = "s.friction"
            {more}
            [run]
            until = 4.0
            method = "radau"
            [define.s.coordinates.x]
            unit = "m"
            [define.s.states.z]
            unit = "m"
            rate = "x_dot - abs(x_dot)*z*1e5 [N/m]/1 [N]"
            [define.s.helpers.friction]
            expression = "1e5 [N/m]*z + 316 [N s/m]*(x_dot - abs(x_dot)*z*1e5 [N/m]/1 [N])"
            unit = "N"
            [define.s.energy]
            kinetic = "1 [kg]*x_dot^2/2"
            [[define.s.forces]]
            coordinate = "x"
            expression = "2 [N]*sin(2 [1/s]*t) - friction"
            "#
        );
        of_text(&text, keep)
    };
    // The position is left out; only integrated, after the others; before them.
    let cases = [("", Keep::Needed, 0), ("x = \"s.x\"", Keep::Needed, 1), ("", Keep::All, 1)];
    for (more, keep, positions) in cases {
        let scene = block(more, keep);
        assert_eq!(scene.shape().positions, positions, "{more}");
        assert_eq!(told(&scene, |run| run), [""; 0], "{more}");
    }
}

/// Returns an oscillator with a spring that hardens at amplitudes of a size, and a flux that follows
/// it: x = size X(t) with the same X for every size.
fn of_size(size: f64) -> ModelSimulator {
    let text = format!(
        r#"
        [scene]
        name = "hard_spring"
        [units.s]
        unit = "s"
        [initial]
        "s.x" = {size:e}
        [run]
        until = 20.0
        points = 101
        rtol = 1e-6
        method = "auto"
        [define.s.coordinates.x]
        unit = "m"
        [define.s.states.flux]
        unit = "m"
        rate = "(x - flux)/1 [s]"
        [define.s.energy]
        kinetic = "1 [kg]*x_dot^2/2"
        potential = "1 [N/m]*(x^2/2 + x^4/(4*({size:e} [m])^2))"
        [[define.s.forces]]
        coordinate = "x"
        expression = "-0.1 [N/m]*flux"
        "#
    );
    of_text(&text, Keep::All)
}

#[test]
fn errors_are_relative_to_the_size_of_a_state_whatever_its_scale() {
    let exact = Simulation::new(&of_size(1.0)).method(Method::Dop853).rtol(1e-13).run();
    let exact = exact.expect("it swings");
    let error = |size: f64, method: Method| {
        let run = Simulation::new(&of_size(size)).method(method).run().expect("it swings");
        let of = |name: &str| {
            let [found, wanted] = [&run, &exact].map(|run| run.column(name).expect("a state"));
            let off = found.iter().zip(wanted).map(|(a, b)| (a / size - b).abs());
            off.fold(0.0, f64::max) / wanted.iter().map(|value| value.abs()).fold(0.0, f64::max)
        };
        ["s.x", "s.x_dot", "s.flux"].map(of).into_iter().fold(0.0, f64::max)
    };
    let machine = of_size(1.0);
    let is_possible = |method: &&Method| method.is_compiled_in() && method.check(&machine).is_ok();
    let methods: Vec<&Method> = Method::ALL.iter().filter(is_possible).collect();
    assert!(methods.len() >= 6, "{methods:?}");
    for method in methods.into_iter().filter(|method| **method != Method::Exact) {
        let allowed = 20.0 * error(1.0, *method).max(1e-6);
        // Down to a thousandth of its scale, a state may have three digits less.
        for (size, less) in [
            (1e-8, 1.0),
            (1e-6, 1.0),
            (1e-5, 1.0),
            (1e-4, 1.0),
            (1e-2, 1e3),
            (1e2, 1.0),
            (1e4, 1.0),
        ] {
            let (found, allowed) = (error(size, *method), less * allowed);
            assert!(found <= allowed, "{method} {size:e}: {found:e} above {allowed:e}");
        }
    }
}

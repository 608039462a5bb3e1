//! States that move far less than their absolute tolerance assumes are reported.

use machinist::Simulation;
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

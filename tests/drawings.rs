//! Drawings in space: the places that the generator writes are those of closed forms and of outputs.

use machinist::Simulation;
use machinist_codegen::mechanics::reduce::Keep;
use machinist_model::{ElementKind, Model, ModelSimulator};

use crate::own_scene::{model_of_specs, of_text};

/// Column that turns, with an arm that slides, a bar on a hinge, and a rod from its tip to the world.
const ARM: &str = r#"
[scene]
name = "arm"
[units.arm]
unit = "arm"
[initial]
"arm.turn" = 0.3
"arm.turn_dot" = 2.0
"arm.swing" = 0.4
"arm.out_dot" = 0.5
[outputs]
tip_x = "arm.tip_x"
tip_y = "arm.tip_y"
tip_z = "arm.tip_z"
hinge_x = "arm.bar_x"
hinge_y = "arm.bar_y"
hinge_z = "arm.bar_z"
axis_x = { expression = "x_of(y_axis(arm.bar))", unit = "1" }
axis_y = { expression = "y_of(y_axis(arm.bar))", unit = "1" }
axis_z = { expression = "z_of(y_axis(arm.bar))", unit = "1" }
[run]
until = 1.0
points = 41
rtol = 1e-10
[define.arm]
gravity = [0, 0, -9.81]
[define.arm.coordinates]
turn = { unit = "rad" }
out = { unit = "m" }
swing = { unit = "rad" }
[define.arm.parameters]
length = { value = 0.6, unit = "m" }
[define.arm.frames]
column = { revolute = { axis = [0, 0, 1], angle = "turn" } }
slide = { parent = "column", displacement = [0.1, 0, 0.5], prismatic = { axis = [1, 0, 0], displacement = "out" } }
bar = { parent = "slide", revolute = { axis = [0, 1, 0], angle = "swing" } }
tip = { parent = "bar", displacement = ["length", 0, 0] }
[define.arm.bodies]
column = { frame = "column", mass = 3, inertia = { zz = 0.2 } }
slide = { frame = "slide", mass = 2 }
bar = { frame = "bar", mass = 1, centre = ["length/2", 0, 0], inertia = { yy = 0.03, zz = 0.03 } }
[define.arm.shapes]
bar = { frame = "bar", centre = ["length/2", 0, 0], cylinder = { axis = [1, 0, 0], length = "length", diameter = "50 [mm]" } }
ball = { frame = "tip", sphere = 0.08 }
block = { frame = "slide", box = [0.2, 0.1, 0.06], rotation = { axis = [0, 0, 1], angle = "90 [deg]" } }
tie = { frame = "tip", rod = "world" }
"#;

/// Returns the numbers of an element by its kind and name.
fn numbers<'a>(model: &Model, placed: &'a [f64], kind: ElementKind, name: &str) -> &'a [f64] {
    let drawing = model.drawing.as_ref().expect("a drawing");
    let mut next = 0;
    for element in &drawing.elements {
        let count = element.kind.numbers();
        if element.kind == kind && element.name == name {
            return &placed[next..next + count];
        }
        next += count;
    }
    panic!("no {kind:?} {name} among {:?}", drawing.elements)
}

fn assert_near(found: &[f64], expected: &[f64], what: &str) {
    assert_eq!(found.len(), expected.len(), "{what}");
    for (found, expected) in found.iter().zip(expected) {
        assert!((found - expected).abs() < 1e-13, "{what}: {found} instead of {expected}");
    }
}

/// Places the elements at every output time of a run with these parameters.
fn along(scene: &ModelSimulator, check: impl Fn(&[f64], &dyn Fn(&str) -> f64)) {
    let model = scene.model();
    let run = Simulation::new(scene.single()).run().expect("it runs");
    let drawing = model.drawing.as_ref().expect("a drawing");
    let parameters: Vec<f64> = model.parameters.iter().map(|known| known.value).collect();
    for (at, time) in run.times.iter().enumerate() {
        let states = &run.columns[..model.states.len()];
        let state: Vec<f64> = states.iter().map(|column| column.values[at]).collect();
        let placed = drawing.placed(*time, &state, &parameters, model);
        assert_eq!(placed.len(), drawing.numbers());
        let column = |name: &str| {
            let found = run.columns.iter().find(|column| column.name == name);
            found.unwrap_or_else(|| panic!("no {name}")).values[at]
        };
        check(&placed, &column);
    }
}

#[test]
fn places_are_those_of_outputs_and_of_closed_forms() {
    let scene = of_text(ARM, Keep::All);
    let model = scene.model().clone();
    let element = |placed: &[f64], kind, name: &str| numbers(&model, placed, kind, name).to_vec();
    along(&scene, |placed, column| {
        let three = |of: &str| ["x", "y", "z"].map(|axis| column(&format!("{of}_{axis}")));
        let [turn, out, swing] = ["turn", "out", "swing"].map(|q| column(&format!("arm.{q}")));
        let outwards = [turn.cos(), turn.sin(), 0.0];
        let at = |r: f64, z: f64| [r * outwards[0], r * outwards[1], z];
        let (hinge, tip) = (three("hinge"), three("tip"));
        assert_near(&hinge, &at(0.1 + out, 0.5), "closed form of the hinge");
        let bar = element(placed, ElementKind::Hinge, "arm.bar");
        assert_near(&bar, &[hinge, three("axis")].concat(), "hinge");
        let slide = element(placed, ElementKind::Slide, "arm.slide");
        assert_near(&slide, &[at(0.1, 0.5), hinge, outwards].concat(), "slide");
        let ends = element(placed, ElementKind::Cylinder, "arm.bar");
        assert_near(&ends[..6], &[hinge, tip].concat(), "ends of the bar");
        let low = at(0.1 + out + 0.6 * swing.cos(), 0.5 - 0.6 * swing.sin());
        assert_near(&ends[3..6], &low, "closed form of the tip");
        assert_near(&ends[9..], &[0.025], "radius");
        let across: f64 = (0..3).map(|k| ends[6 + k] * (ends[3 + k] - ends[k])).sum();
        assert!(
            across.abs() < 1e-13
                && (ends[6..9].iter().map(|x| x * x).sum::<f64>() - 1.0).abs() < 1e-13
        );
        let ball = element(placed, ElementKind::Sphere, "arm.ball");
        assert_near(&ball[..3], &tip, "ball");
        let block = element(placed, ElementKind::Box, "arm.block");
        // Turned by 90 degrees, its longest edge lies across.
        assert_near(&block[..3], &hinge, "block");
        assert_near(&block[3..6], &[-0.1 * turn.sin(), 0.1 * turn.cos(), 0.0], "edge");
        let tie = element(placed, ElementKind::Rod, "arm.tie");
        assert_near(&tie, &[tip, [0.0; 3]].concat(), "tie");
    });
}

#[test]
fn loops_of_parts_are_drawn_closed_wherever_they_are_cut() {
    for name in ["msl/spatial_four_bar", "iftomm/four_bars", "parts/spatial/rod"] {
        let model = model_of_specs(name, Keep::All);
        let drawing = model.drawing.clone().expect("a drawing");
        let scene = ModelSimulator::new(model);
        // The rod and every bar keep their lengths, and each joint lies on its neighbours.
        let lengths = std::cell::RefCell::new(Vec::new());
        along(&scene, |placed, _| {
            let (mut next, mut all) = (0, Vec::new());
            for element in &drawing.elements {
                let values = &placed[next..next + element.kind.numbers()];
                next += values.len();
                if matches!(
                    element.kind,
                    ElementKind::Rod | ElementKind::Link | ElementKind::Cylinder
                ) {
                    let length = (0..3).map(|k| (values[3 + k] - values[k]).powi(2)).sum::<f64>();
                    all.push((element.name.clone(), length.sqrt()));
                }
            }
            let mut known = lengths.borrow_mut();
            if known.is_empty() {
                *known = all.clone();
            }
            for ((name, before), (_, now)) in known.iter().zip(&all) {
                assert!((before - now).abs() < 1e-7 * (1.0 + before), "{name}: {before} {now}");
            }
        });
    }
}

#[test]
fn bodies_without_shapes_have_the_solids_of_their_inertias() {
    let text = |inertia: &str| {
        format!(
            "[scene]\nname = \"one\"\n[units]\nbody = {{ unit = \"body\" }}\n[run]\nuntil = 0.1\n\
             points = 2\n[define.body.orientations]\nturn = {{}}\n[define.body.frames]\nbody = {{ \
             spherical = \"turn\" }}\n[define.body.bodies]\nbody = {{ frame = \"body\", mass = 2, \
             inertia = {inertia} }}\n"
        )
    };
    let placed = |inertia: &str, kind| {
        let scene = of_text(&text(inertia), Keep::All);
        let model = scene.model();
        let parameters: Vec<f64> = model.parameters.iter().map(|known| known.value).collect();
        let mut state = vec![0.0; model.states.len()];
        scene.single().initial_state(&parameters, &mut state);
        let drawing = model.drawing.as_ref().expect("a drawing");
        numbers(model, &drawing.placed(0.0, &state, &parameters, model), kind, "body.body").to_vec()
    };
    // Sphere of radius 0.1: 2 m r^2/5; disc of radius 0.3 and thickness 0.05; box of edges 1, 2, 3.
    let sphere = placed("{ xx = 0.008, yy = 0.008, zz = 0.008 }", ElementKind::Sphere);
    assert_near(&sphere[9..], &[0.1], "radius");
    let across = 2.0 * (3.0 * 0.09 + 0.0025) / 12.0;
    let disc = format!("{{ xx = {across:.17}, yy = {across:.17}, zz = 0.09 }}");
    let disc = placed(&disc, ElementKind::Cylinder);
    assert!((disc[9] - 0.3).abs() < 1e-13 && (disc[5] - disc[2] - 0.05).abs() < 1e-12, "{disc:?}");
    let edges = [1.0_f64, 2.0, 3.0].map(|edge| edge * edge);
    let [a, b, c] = edges.map(|square| (edges.iter().sum::<f64>() - square) / 6.0);
    let boxed = placed(&format!("{{ xx = {a}, yy = {b}, zz = {c} }}"), ElementKind::Box);
    assert_near(&[boxed[3], boxed[7], boxed[11]], &[0.5, 1.0, 1.5], "half edges");
}

#[test]
fn machines_without_frames_have_no_drawing_in_space() {
    for name in ["slider_crank", "drives/winch", "parts/planar/body"] {
        assert!(model_of_specs(name, Keep::Needed).drawing.is_none(), "{name}");
    }
}

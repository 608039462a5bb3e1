//! Units made of units: each equals the machine with its parts written out.

use machinist::Method;
use machinist_codegen::mechanics::reduce::Keep;
use machinist_model::ModelSimulator;
use machinist_studies::closed_form::slider_crank::{SLIDER_CRANK, SliderCrank};

use super::{METHODS, column, example, off, run};
use crate::own_scene::{of_specs, of_text};

/// The scene of a gearbox, with the ideal gear and the backlash that it is made of.
const BY_HAND: &str = r#"
[scene]
name = "by_hand"

[units]
motor = { unit = "rotational/inertia", parameters = { inertia = 0.02 } }
gear = { unit = "rotational/gear", parameters = { ratio = 5 } }
play = { unit = "rotational/backlash", parameters = { backlash = 0.01, stiffness = 10000, damping = 1 } }
load = { unit = "rotational/inertia", parameters = { inertia = 2 } }
drive = { unit = "sources/torque", inputs = { torque = "3 [N m]" } }

[[joints]]
connect = ["drive.a", "motor.a"]
[[joints]]
connect = ["motor.b", "gear.a"]
[[joints]]
connect = ["gear.b", "play.a"]
[[joints]]
connect = ["play.b", "load.a"]

[outputs]
load = "load.omega"
twist = { expression = "-play.twist", unit = "rad" }
torque = { expression = "-play.torque", unit = "N m" }

[run]
until = 0.5
points = 201
rtol = 1e-8
method = "auto"
"#;

#[test]
fn a_gearbox_is_a_gear_and_a_backlash_bit_for_bit() {
    let whole = run(&example("rotational/gearbox", Keep::Needed), &[], &[]);
    let by_hand = run(&of_text(BY_HAND, Keep::Needed), &[], &[]);
    for name in ["load", "twist", "torque"] {
        assert_eq!(column(&whole, name), column(&by_hand, name), "{name}");
    }
    assert!(column(&whole, "torque").iter().any(|torque| torque.abs() > 40.0));
}

#[test]
fn a_slider_crank_of_one_unit_moves_and_takes_the_torque_of_its_closed_form() {
    let scene = example("planar/slider_crank", Keep::Needed);
    let cases = [
        (0.05, 0.2, 2e-3, 1.1, 0.4),
        (0.05, 0.08, 1e-4, 1.1, 2.9),
        (0.04, 1.0, 0.05, 30.0, -1.6),
        (0.01, 0.2, 2e-3, 1e-3, 4.0),
    ];
    for (number, (crank, rod, rod_inertia, slider_mass, start)) in cases.into_iter().enumerate() {
        let set = [
            ("engine.crank_length", crank),
            ("engine.rod_length", rod),
            ("engine.rod_inertia", rod_inertia),
            ("engine.slider_mass", slider_mass),
            ("engine.start", start),
        ];
        let exact = SliderCrank { crank, rod, rod_inertia, slider_mass, ..SLIDER_CRANK };
        let mut simulation =
            machinist::Simulation::new(&scene).rtol(1e-9).method(METHODS[number % METHODS.len()]);
        for (name, value) in set {
            simulation = simulation.parameter(name, value).expect("a parameter");
        }
        let run = simulation.run().expect("it runs");
        let angle = |t: f64| start + 30.0 * t;
        let errors = [
            off(&run, "stroke", |t| exact.at(angle(t)).stroke),
            off(&run, "acceleration", |t| exact.at(angle(t)).slider_acceleration),
            off(&run, "torque", |t| exact.at(angle(t)).torque),
        ];
        assert!(errors.iter().all(|error| *error < 5e-8), "{set:?}: {errors:?}");
    }
}

fn fine(scene: &ModelSimulator) -> machinist::Trajectory {
    let times: Vec<f64> = (0..=50).map(|k| 0.01 * f64::from(k)).collect();
    let simulation = machinist::Simulation::new(scene).method(Method::Dop853).rtol(1e-11);
    simulation.until(0.5).times(&times).run().expect("it runs")
}

#[test]
fn a_four_bar_of_one_unit_is_that_of_parts() {
    let whole = fine(&example("planar/four_bar", Keep::Needed));
    let of_parts = fine(&of_specs("linkages/four_bar", Keep::Needed));
    let pairs = [
        ("crank", "crank_angle"),
        ("coupler", "coupler_angle"),
        ("rocker", "rocker_angle"),
        ("speed", "crank_speed"),
        ("force_x", "pin_force_x"),
        ("force_y", "pin_force_y"),
    ];
    for (ours, theirs) in pairs {
        let (ours_all, theirs_all) = (column(&whole, ours), column(&of_parts, theirs));
        let size = theirs_all.iter().fold(0.0, |most: f64, value| most.max(value.abs()));
        for (a, b) in ours_all.iter().zip(theirs_all) {
            assert!((a - b).abs() < 1e-8 * size, "{ours}: {a}, {b}");
        }
    }
}

/// Assemblies within assemblies in rows, with values from outside and inside.
const NESTED: &str = r#"
[scene]
name = "nested"

[units.train]
unit = "train"
count = 2
parameters = { unit_inertia = "0.1 [kg m^2]*i", "cell[2].spring.damping" = 0.5 }

[units.ground]
unit = "rotational/fixed"

[[joints]]
connect = ["ground.a", "train[1].left"]
[[joints]]
connect = ["train[i].right", "train[i+1].left"]

[[forces]]
port = "train[2].right"
expression = "load"

[parameters]
load = { value = 2, unit = "N m" }

[initial]
"train[1].cell[2].disc.omega" = 3
train_2.cell_1.disc.omega = "load*1 [1/(kg m^2 s)]*1 [s^2]*0.5"

[outputs]
first = "train[1].cell[1].disc.phi"
last = "train[2].cell[3].disc.phi"
twist = "train[1].twist"
sum = { expression = "train[1].cell[3].disc.phi + train_2.cell_1.spring.torque*1 [1/(N m)]", unit = "rad" }

[tunable]
parameters = ["load", "train[1].stiffness", "train_1.cell_2.spring.damping"]

[run]
until = 2.0
points = 101
rtol = 1e-10
method = "dop853"

[define.train]
ports = { left = "cell[1].left", right = "cell[3].right" }
parameters.unit_inertia = { value = 1, unit = "kg m^2" }
parameters.stiffness = { value = 20, unit = "N m/rad" }
units.cell = { unit = "cell", count = 3, parameters = { inertia = "unit_inertia*i", "spring.stiffness" = "stiffness" } }
joints = [{ connect = ["cell[i].right", "cell[i+1].left"] }]
outputs.twist = { expression = "cell[3].disc.phi - cell[1].disc.phi", unit = "rad" }
initial."cell[1].disc.omega" = 1
initial."cell[2].disc.omega" = 7

[define.cell]
ports = { left = "spring.a", right = "disc.b" }
parameters.inertia = { value = 1, unit = "kg m^2" }
units.disc = { unit = "rotational/inertia", parameters = { inertia = "inertia" } }
units.spring = { unit = "rotational/spring_damper", parameters = { stiffness = 1, damping = 0 } }
joints = [{ connect = ["spring.b", "disc.a"] }]
initial."disc.omega" = 0.25
"#;

/// Returns six discs on six springs in a row.
fn written_out() -> String {
    // What each level says of the speeds: train, scene, cell; then train, train, cell.
    let speeds = [1.0, 3.0, 0.25, 1.0, 7.0, 0.25];
    let of_each = |line: &dyn Fn(usize) -> String| (0..6).map(line).collect::<String>();
    let units = of_each(&|index| {
        let inertia = 0.1 * (index / 3 + 1) as f64 * (index % 3 + 1) as f64;
        let damping = if index % 3 == 1 { 0.5 } else { 0.0 };
        format!(
            "[units.disc_{index}]\nunit = \"rotational/inertia\"\n\
             parameters = {{ inertia = {inertia:?} }}\n\
             [units.spring_{index}]\nunit = \"rotational/spring_damper\"\n\
             parameters = {{ stiffness = 20, damping = {damping:?} }}\n"
        )
    });
    let joints = of_each(&|index| {
        let before = match index {
            0 => "ground.a".to_owned(),
            _ => format!("disc_{}.b", index - 1),
        };
        format!(
            "[[joints]]\nconnect = [\"{before}\", \"spring_{index}.a\"]\n\
             [[joints]]\nconnect = [\"spring_{index}.b\", \"disc_{index}.a\"]\n"
        )
    });
    let initial = of_each(&|index| format!("\"disc_{index}.omega\" = {:?}\n", speeds[index]));
    format!(
        "[scene]\nname = \"written_out\"\n{units}\
         [units.ground]\nunit = \"rotational/fixed\"\n{joints}\
         [[forces]]\nport = \"disc_5.b\"\nexpression = \"2 [N m]\"\n\
         [initial]\n{initial}\
         [outputs]\nfirst = \"disc_0.phi\"\nlast = \"disc_5.phi\"\n\
         twist = {{ expression = \"disc_2.phi - disc_0.phi\", unit = \"rad\" }}\n\
         sum = {{ expression = \"disc_2.phi + spring_3.torque*1 [1/(N m)]\", unit = \"rad\" }}\n\
         [run]\nuntil = 2.0\npoints = 101\nrtol = 1e-10\nmethod = \"dop853\"\n"
    )
}

#[test]
fn assemblies_of_assemblies_in_rows_are_what_they_are_made_of() {
    let nested = of_text(NESTED, Keep::Needed);
    let (ours, theirs) =
        (run(&nested, &[], &[]), run(&of_text(&written_out(), Keep::All), &[], &[]));
    for name in ["first", "last", "twist", "sum"] {
        for (a, b) in column(&ours, name).iter().zip(column(&theirs, name)) {
            assert!((a - b).abs() < 1e-8, "{name}: {a}, {b}");
        }
    }
    // The run may change what the scene lists, by the name on the way there.
    let softer = run(&nested, &[("train_1.stiffness", 10.0)], &[]);
    assert!(column(&softer, "twist") != column(&ours, "twist"));
    let damped = run(&nested, &[("train_1.cell_2.spring.damping", 5.0)], &[]);
    assert!(column(&damped, "twist") != column(&ours, "twist"));
}

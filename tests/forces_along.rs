//! Forces that do work along a length or an angle, by their energies.

use machinist::{Simulation, Trajectory};
use machinist_codegen::mechanics::reduce::Keep;
use machinist_contract::{Describe, Simulator};
use machinist_model::ModelSimulator;

use crate::common::column;
use crate::own_scene::{of_text, refusal};

const RUN: &str = "[run]\nuntil = 1.5\npoints = 151\nrtol = 1e-11\nmethod = \"auto\"\n";

fn run(scene: &ModelSimulator) -> Trajectory {
    Simulation::new(scene).run().expect("it runs")
}

fn apart(a: &[f64], b: &[f64]) -> f64 {
    assert_eq!(a.len(), b.len());
    a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
}

/// Returns a particle that is thrown past a pin, with a force element between them.
fn particle(more: &str) -> String {
    format!(
        "[scene]\nname = \"thrown\"\n[units.bob]\nunit = \"planar/particle\"\n\
         parameters = {{ mass = 2, gravity = 0 }}\n\
         [helpers.distance]\nexpression = \"sqrt((bob.x - 0.1 [m])^2 + bob.y^2)\"\nunit = \"m\"\n\
         [parameters]\npull = {{ value = 25, unit = \"N\" }}\n\
         [initial]\n\"bob.x\" = 0.8\n\"bob.v_y\" = 1.5\n\
         [outputs]\nx = \"bob.x\"\ny = \"bob.y\"\nfar = \"distance\"\n\
         work = {{ expression = \"2 [kg]*(bob.v_x^2 + bob.v_y^2)/2\", unit = \"J\" }}\n{more}\n{RUN}"
    )
}

#[test]
fn a_constant_force_along_a_distance_does_its_work() {
    let text = particle("[[forces]]\nalong = \"distance\"\nexpression = \"-pull\"");
    let scene = of_text(&text, Keep::Needed);
    let run = run(&scene);
    let (kinetic, far) = (column(&run, "work"), column(&run, "far"));
    let whole = kinetic[0] + 25.0 * far[0];
    for (kinetic, far) in kinetic.iter().zip(far) {
        assert!((kinetic + 25.0 * far - whole).abs() < 1e-8, "{}", kinetic + 25.0 * far - whole);
    }
    assert!(far.iter().fold(f64::INFINITY, |least, far| far.min(least)) < 0.5, "it comes nearer");
}

#[test]
fn a_spring_as_a_force_along_its_length_moves_as_one_with_an_energy() {
    let by_force = particle(
        "[[forces]]\nalong = \"distance\"\nexpression = \"-60 [N/m]*(distance - 0.3 [m])\"",
    );
    let by_energy = particle("[energy]\npotential = \"60 [N/m]*(distance - 0.3 [m])^2/2\"");
    let [ours, theirs] = [by_force, by_energy].map(|text| run(&of_text(&text, Keep::Needed)));
    for name in ["x", "y"] {
        let off = apart(column(&ours, name), column(&theirs, name));
        assert!(off < 1e-8, "{name}: {off:e}");
    }
}

/// Returns a damper between a crank and a slide, across a gear, as a force of a unit and of the
/// scene.
fn across_a_gear(more: &str) -> String {
    format!(
        "[scene]\nname = \"across\"\n[units]\n\
         wheel = {{ unit = \"rotational/inertia\", parameters = {{ inertia = 0.3 }} }}\n\
         gear = {{ unit = \"rotational/gear\", parameters = {{ ratio = 4 }} }}\n\
         pinion = {{ unit = \"rotational/rack\", parameters = {{ radius = 0.05 }} }}\n\
         slide = {{ unit = \"translational/mass\", parameters = {{ mass = 6 }} }}\n\
         other = {{ unit = \"translational/mass\", parameters = {{ mass = 3 }} }}\n\
         [[joints]]\nconnect = [\"wheel.b\", \"gear.a\"]\n\
         [[joints]]\nconnect = [\"gear.b\", \"pinion.a\"]\n\
         [[joints]]\nconnect = [\"pinion.b\", \"slide.a\"]\n\
         [initial]\n\"slide.v\" = 2\n\"other.v\" = -1\n\
         [outputs]\nslide = \"slide.x\"\nother = \"other.x\"\nturned = \"wheel.phi\"\n{more}\n{RUN}"
    )
}

#[test]
fn a_force_along_what_follows_by_a_gear_acts_on_what_it_follows() {
    let along = "along = \"slide.x - other.x\"\nexpression = \"-20 [N s/m]*(slide.v - other.v)\"";
    let by_force = of_text(&across_a_gear(&format!("[[forces]]\n{along}")), Keep::Needed);
    let by_energy = across_a_gear("[energy]\ndissipation = \"20 [N s/m]*(slide.v - other.v)^2/2\"");
    let (ours, theirs) = (run(&by_force), run(&of_text(&by_energy, Keep::Needed)));
    for name in ["slide", "other", "turned"] {
        let off = apart(column(&ours, name), column(&theirs, name));
        assert!(off < 1e-8, "{name}: {off:e}");
    }
    // This difference of speeds decays according to 20 N s/m over the reduced mass.
    let first = 6.0 + 0.3 * (4.0_f64 / 0.05).powi(2);
    let decay = 20.0 * (1.0 / first + 1.0 / 3.0);
    let gap = |row: usize| column(&ours, "slide")[row] - column(&ours, "other")[row];
    for (row, t) in ours.times.iter().enumerate() {
        assert!((gap(row) - 3.0 / decay * (1.0 - (-decay * t).exp())).abs() < 1e-8);
    }
}

/// A unit: a force between two of its coordinates along a length that time changes too.
const CYLINDER: &str = r#"
[scene]
name = "cylinder"

[units.s]
unit = "s"

[outputs]
x = "s.x"
y = "s.y"

[initial]
"s.x" = 0.7
"s.y" = 0.4

[run]
until = 1.0
points = 101
rtol = 1e-10
method = "auto"

[define.s]
coordinates.x = { unit = "m" }
coordinates.y = { unit = "m" }
parameters.speed = { value = 0.3, unit = "m/s" }
helpers.length = { expression = "sqrt((x - speed*t)^2 + y^2)", unit = "m" }
energy.kinetic = "1 [kg]*x_dot^2/2 + 2 [kg]*y_dot^2/2"
forces = [{ along = "length", expression = "5 [N]*cos(3 [rad/s]*t) - 8 [N/m]*length" }]
"#;

#[test]
fn a_force_along_a_length_that_time_changes_balances_its_power() {
    let scene = of_text(CYLINDER, Keep::All);
    let simulation = Simulation::new(&scene);
    let parameters = simulation.parameter_values();
    let mut largest = 0.0_f64;
    for number in 0..50 {
        let (t, a) = (0.1 * f64::from(number), f64::from(number));
        let state = [0.5 + 0.3 * a.sin(), 0.6 + 0.2 * a.cos(), 2.0 * (3.0 * a).sin(), a.cos()];
        assert_eq!(scene.shape().states(), 4);
        let at = |name: &str| {
            let found = (0..4).find(|k| scene.state(*k).name == name);
            state[found.unwrap_or_else(|| panic!("no state {name}"))]
        };
        let balance = scene.power_balance(t, &state, parameters);
        assert!(balance.residual().abs() < 1e-12, "{}", balance.residual());
        // Q q' by hand, at fixed time.
        let (x, y) = (at("s.x") - 0.3 * t, at("s.y"));
        let length = x.hypot(y);
        let force = 5.0 * (3.0 * t).cos() - 8.0 * length;
        let power = force * (x * at("s.x_dot") + y * at("s.y_dot")) / length;
        assert!((balance.supplied - power).abs() < 1e-12 * power.abs().max(1.0));
        largest = largest.max(power.abs());
    }
    assert!(largest > 1.0);
}

#[test]
fn forces_along_what_does_not_move_are_refused() {
    let said = |from: &str, to: &str| refusal(&CYLINDER.replace(from, to));
    for (to, message) in [
        ("along = \"speed*t\"", "depends on no coordinate"),
        ("along = \"x_dot\"", "depends on a velocity"),
        ("along = \"x*y\"", "the force"),
        ("along = \"x + t\"", "this term is in s"),
        ("coordinate = \"x\", along = \"length\"", "`coordinate` or `along`, not both"),
        ("along = \"lenght\"", "unknown name `lenght`"),
    ] {
        let answer = said("along = \"length\"", to);
        assert!(answer.contains(message), "{to}: {answer}");
    }
}

#[test]
fn a_row_has_a_force_along_each_gap() {
    let row = |more: &str| {
        format!(
            "[scene]\nname = \"row\"\n[units.disc]\nunit = \"rotational/inertia\"\ncount = 4\n\
             [initial]\n\"disc[1].omega\" = 1\n\
             [outputs]\nlast = \"disc[4].phi\"\nfirst = \"disc[1].phi\"\n{more}\n{RUN}"
        )
    };
    let by_row = row("[[forces]]\nalong = \"disc[i].phi - disc[i+1].phi\"\n\
         expression = \"-30 [N m/rad]*(disc[i].phi - disc[i+1].phi)\"");
    let by_energy = row("[energy]\npotential = \"15 [N m/rad]*((disc[1].phi - disc[2].phi)^2 + \
                        (disc[2].phi - disc[3].phi)^2 + (disc[3].phi - disc[4].phi)^2)\"");
    let [ours, theirs] = [by_row, by_energy].map(|text| run(&of_text(&text, Keep::Needed)));
    for name in ["first", "last"] {
        let off = apart(column(&ours, name), column(&theirs, name));
        assert!(off < 1e-8, "{name}: {off:e}");
    }
}

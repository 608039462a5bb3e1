//! Loops of joints in space, cut by the tool and closed by constraints.
//!
//! Each kind of joint is compared with the same machine as a tree; linkages with closed forms of
//! their positions and with their energies.

use std::fmt::Write as _;

use machinist::constraints::lasting;
use machinist::{Simulation, Trajectory};
use machinist_codegen::mechanics::reduce::Keep;
use machinist_codegen::pipeline;
use machinist_codegen::scene::system::LagrangianSystem;
use machinist_contract::Describe;
use machinist_model::ModelSimulator;

use crate::common::column;
use crate::own_scene::{of_text, system_of};

/// Units by name, with their values.
type Units<'a> = &'a [(&'a str, &'a str, &'a str)];

/// Returns a scene of parts: units with their kind and parameters, pairs of joined ports, and the
/// rest of the text.
fn scene(units: Units<'_>, joints: &str, rest: &str) -> String {
    let mut text = "[scene]\nname = \"machine\"\n[units]\n".to_owned();
    for (name, unit, parameters) in units {
        writeln!(text, "{name} = {{ unit = \"{unit}\", parameters = {{ {parameters} }} }}")
            .expect("text");
    }
    for pair in joints.split_whitespace() {
        let (one, other) = pair.split_once('=').expect("two ports");
        write!(text, "[[joints]]\nconnect = [\"{one}\", \"{other}\"]\n").expect("text");
    }
    text + rest
}

/// Returns a machine without its redundant constraints, their names, and the system.
fn closed(text: &str) -> (ModelSimulator, Vec<String>, LagrangianSystem) {
    let mut system = system_of(text);
    let derived = |system: &LagrangianSystem| {
        let model = pipeline::compile(system.clone(), Keep::Needed);
        ModelSimulator::new(model.unwrap_or_else(|errors| panic!("{}", errors.render())))
    };
    let whole = derived(&system);
    let parameters: Vec<f64> =
        (0..whole.shape().parameters).map(|k| whole.parameter_default(k)).collect();
    let dropped = lasting(&whole, &parameters, 0.0);
    if dropped.is_empty() {
        return (whole, Vec::new(), system);
    }
    for one in &dropped {
        system.drop_constraint(&one.constraint, &one.needs);
    }
    let names = dropped.into_iter().map(|one| one.constraint).collect();
    (derived(&system), names, system)
}

fn run(machine: &ModelSimulator) -> Trajectory {
    Simulation::new(machine).run().unwrap_or_else(|error| panic!("{error}"))
}

fn constraints(system: &LagrangianSystem) -> Vec<&str> {
    system.constraints.iter().map(|constraint| constraint.name.path.as_str()).collect()
}

fn coordinates(system: &LagrangianSystem) -> Vec<&str> {
    system.coordinates.iter().map(|one| one.position.name.path.as_str()).collect()
}

/// Largest difference of two runs in some columns.
fn difference(one: &Trajectory, other: &Trajectory, columns: &[&str]) -> f64 {
    let mut most = 0.0_f64;
    for name in columns {
        let rows = column(one, name).iter().zip(column(other, name));
        most = rows.fold(most, |most, (a, b)| most.max((a - b).abs()));
    }
    most
}

/// A body on a joint between oblique frames, and the same body on a free joint as well: whichever of
/// the two is cut, the motion is that of the tree.
#[test]
fn each_joint_closes_a_loop_as_it_moves_in_a_tree() {
    const OBLIQUE: &str = "n_x = 0.4, n_y = -0.7, n_z = 0.5";
    let joints: [(&str, &str, &[&str], usize); 9] = [
        ("revolute", OBLIQUE, &["phi"], 5),
        ("revolute", "n_x = 1, n_z = 0", &["phi"], 5),
        ("prismatic", OBLIQUE, &["s"], 5),
        ("cylindrical", OBLIQUE, &["phi", "s"], 4),
        ("cylindrical", "", &["phi", "s"], 4),
        ("screw", "n_x = 0.4, n_y = -0.7, n_z = 0.5, pitch = 0.3", &["phi"], 0),
        ("universal", "", &["phi_a", "phi_b"], 4),
        ("planar", "", &["x", "y", "phi"], 3),
        ("spherical", "", &["turn_x", "turn_omega_z"], 3),
    ];
    let units = |kind: &str, parameters: &str, flies: bool| {
        let mut units = vec![
            ("world", "spatial/world".to_owned(), "gravity_x = 2, gravity_y = 3, gravity_z = -9"),
            ("away", "spatial/translation".to_owned(), "x = 0.3, y = -0.2, z = 0.1"),
            ("turned", "spatial/rotation".to_owned(), "n_x = 1, n_y = 2, n_z = -1, angle = 0.7"),
            ("bob", "spatial/body".to_owned(), BOB),
            ("tip", "spatial/translation".to_owned(), "x = 0.2, y = 0.3, z = -0.4"),
        ];
        if flies {
            units.push(("flight", "spatial/free".to_owned(), ""));
        }
        units.push(("joint", format!("spatial/{kind}"), ""));
        units.last_mut().expect("a joint").2 = Box::leak(parameters.to_owned().into_boxed_str());
        units
    };
    let tree = "world.frame=away.a away.b=turned.a turned.b=joint.a joint.b=bob.a bob.a=tip.a";
    let looped = format!("{tree} turned.b=flight.a flight.b=bob.a");
    let of = |kind: &str, parameters: &str, joints: &str, mentions: &[String]| {
        let units = units(kind, parameters, joints.len() > tree.len());
        let units: Vec<(&str, &str, &str)> = units
            .iter()
            .map(|(name, unit, parameters)| (*name, unit.as_str(), *parameters))
            .collect();
        let outputs = mentions.iter().enumerate();
        let outputs: Vec<String> =
            outputs.map(|(index, name)| format!("seen_{index} = \"{name}\"\n")).collect();
        scene(&units, joints, &format!("{TIP}{}{SECOND}", outputs.concat()))
    };
    let own = |names: &[&str]| -> Vec<String> {
        names.iter().map(|name| format!("joint.{name}")).collect()
    };
    let flown = ["flight.x".to_owned(), "flight.turn_x".to_owned()];
    for (kind, parameters, names, count) in joints {
        let (machine, _, _) = closed(&of(kind, parameters, tree, &own(names)));
        let wanted = run(&machine);
        // The free joint is cut, without constraints.
        let (machine, dropped, system) = closed(&of(kind, parameters, &looped, &[]));
        assert!(constraints(&system).is_empty() && dropped.is_empty(), "{kind}");
        assert!(coordinates(&system).iter().all(|name| name.starts_with("joint.")), "{kind}");
        assert!(difference(&run(&machine), &wanted, &COLUMNS) < 1e-9, "{kind}");
        // The joint is cut.
        let (machine, dropped, system) = closed(&of(kind, parameters, &looped, &flown));
        let found = constraints(&system);
        let rigid = usize::from(count == 0) * 6;
        assert_eq!(found.len(), count + rigid, "{kind}: {found:?}");
        assert!(dropped.is_empty(), "{kind}: {dropped:?}");
        assert_eq!(system.notes.len(), 1, "{kind}");
        let error = difference(&run(&machine), &wanted, &COLUMNS);
        assert!(error < 1e-7, "{kind} moves otherwise by {error:e}");
        // Both joints are kept: ports are joined by six constraints.
        let both = [own(names), flown.to_vec()].concat();
        let (machine, dropped, system) = closed(&of(kind, parameters, &looped, &both));
        assert_eq!(constraints(&system).len(), 6, "{kind}");
        assert!(dropped.is_empty(), "{kind}: {dropped:?}");
        let error = difference(&run(&machine), &wanted, &COLUMNS);
        assert!(error < 1e-7, "{kind} in a rigid loop moves otherwise by {error:e}");
    }
}

const BOB: &str = "mass = 2, centre_x = 0.2, centre_y = 0.1, centre_z = -0.3, inertia_xx = 0.03, \
                   inertia_yy = 0.04, inertia_zz = 0.05, inertia_xy = 0.004";
const COLUMNS: [&str; 6] = ["x", "y", "z", "xx", "yz", "zx"];
const TIP: &str = r#"
[outputs]
x = "tip.b_x"
y = "tip.b_y"
z = "tip.b_z"
xx = "tip.b_r_xx"
yz = "tip.b_r_yz"
zx = "tip.b_r_zx"
"#;
const SECOND: &str = "[run]\nuntil = 1\npoints = 21\nrtol = 1e-11\n";

/// A four-bar linkage whose axes point along `n`, in a plane normal to it.
fn four_bar(lengths: [f64; 4], turn: &str, rest: &str) -> String {
    let [crank, coupler, rocker, ground] = lengths;
    let rod = |length: f64| format!("length = {length}, diameter = 0.02");
    let (crank, coupler, rocker) = (rod(crank), rod(coupler), rod(rocker));
    let ground = format!("x = {ground}");
    let y = "n_y = 1, n_z = 0";
    let units = [
        ("world", "spatial/world", ""),
        ("turn", "spatial/rotation", turn),
        ("A", "spatial/revolute", y),
        ("crank", "spatial/cylinder", &crank),
        ("B", "spatial/revolute", y),
        ("coupler", "spatial/cylinder", &coupler),
        ("C", "spatial/revolute", y),
        ("rocker", "spatial/cylinder", &rocker),
        ("D", "spatial/revolute", y),
        ("ground", "spatial/translation", &ground),
    ];
    let joints = "world.frame=turn.a turn.b=A.a A.b=crank.a crank.b=B.a B.b=coupler.a \
                  coupler.b=C.a C.b=rocker.b D.b=rocker.a ground.b=D.a ground.a=turn.b";
    scene(&units, joints, rest)
}

const FOUR_BAR: &str = r#"
[initial]
"A.phi" = -1.2
"A.omega" = 12
[guess]
"D.phi" = -1.7
[outputs]
crank = "A.phi"
rocker = "D.phi"
force = "C.b_hold_x"
[run]
until = 3
points = 101
rtol = 1e-10
"#;

/// The coupler keeps its length (Freudenstein), and the energy stays; planes in any direction.
#[test]
fn a_planar_four_bar_of_spatial_parts_turns_as_its_closed_form_says() {
    let lengths = [[0.2, 0.5, 0.4, 0.5], [0.3, 0.7, 0.6, 0.8], [0.15, 0.4, 0.45, 0.5]];
    let turns = ["angle = 0", "n_x = 1, n_z = 0, angle = 1.1", "n_x = 1, n_y = -2, angle = 0.9"];
    for (lengths, turn) in lengths.into_iter().zip(turns) {
        let [r, coupler, s, ground] = lengths;
        let (machine, dropped, system) = closed(&four_bar(lengths, turn, FOUR_BAR));
        assert_eq!(coordinates(&system), ["A.phi", "B.phi", "D.phi"], "the far joint is cut");
        assert_eq!(constraints(&system).len(), 5);
        assert_eq!(dropped.len(), 3, "two constraints close a plane loop: {dropped:?}");
        let note = &system.notes[0];
        assert!(note.contains("joint `C`") && note.contains("`C.phi`"), "{note}");
        let found = run(&machine);
        for (crank, rocker) in column(&found, "crank").iter().zip(column(&found, "rocker")) {
            // A turn by phi about y lowers points along x.
            let x = ground + s * rocker.cos() - r * crank.cos();
            let z = r * crank.sin() - s * rocker.sin();
            assert!((x * x + z * z - coupler * coupler).abs() < 1e-11, "{turn}");
        }
        let energy = column(&found, "energy.total");
        assert!(energy.iter().all(|e| (e - energy[0]).abs() < 1e-7), "{turn}");
        assert!(column(&found, "crank").last().is_some_and(|angle| *angle > 6.0));
        assert!(column(&found, "force").iter().any(|force| force.abs() > 1.0));
    }
}

/// Joints whose coordinates are mentioned are kept, in whichever way; the motion stays.
#[test]
fn the_motion_of_a_loop_does_not_depend_on_the_cut() {
    let lengths = [0.2, 0.5, 0.4, 0.5];
    let outputs = "force = \"C.b_hold_x\"\n";
    let other = |with: &str| FOUR_BAR.replace(outputs, with);
    let wanted = run(&closed(&four_bar(lengths, "angle = 0.4", FOUR_BAR)).0);
    let all = "b = \"B.phi\"\nc = \"C.omega\"\n";
    for (with, cut) in [("c = \"C.phi\"\n", "joint `B`"), (all, "cut at `")] {
        let (machine, _, system) = closed(&four_bar(lengths, "angle = 0.4", &other(with)));
        assert!(system.notes[0].contains(cut), "{}", system.notes[0]);
        let error = difference(&run(&machine), &wanted, &["crank", "rocker"]);
        assert!(error < 1e-7, "{cut}: {error:e}");
    }
    // A brake on the port of a joint is a mention as well.
    let braked = four_bar(lengths, "angle = 0.4", &other(""))
        .replace("[units]", "[units]\nbrake = { unit = \"rotational/damper\" }\nfloor = { unit = \"rotational/fixed\" }")
        + "[[joints]]\nconnect = [\"brake.a\", \"C.axis\"]\n[[joints]]\nconnect = [\"brake.b\", \"floor.a\"]\n";
    let (_, _, system) = closed(&braked);
    assert!(system.notes[0].contains("joint `B`"), "{:?}", system.notes);
}

/// Bricard's trihedral linkage, whose six hinges along edges of a cube would lock by Gruebler's
/// count: 6 - 6 = 0. Its motion has a threefold symmetry, and neighbouring angles are related by
/// cos a + cos b + cos a cos b = 0.
#[test]
fn a_linkage_of_bricard_moves_although_it_is_overconstrained() {
    let rod = |along: &str| {
        let about = |axis: &str| if along.contains(axis) { "0.01" } else { "0.09" };
        let [x, y, z] = ["x", "y", "z"].map(about);
        (
            along.to_owned(),
            format!("mass = 1, {}, inertia_xx = {x}, inertia_yy = {y}, inertia_zz = {z}", {
                let (axis, value) = along.split_once(" = ").expect("a length");
                format!("centre_{axis} = {}", value.parse::<f64>().expect("a number") / 2.0)
            }),
        )
    };
    let ways = ["x = 1", "y = -1", "z = 1", "x = -1", "y = 1"].map(rod);
    let axes = [
        "n_y = 1, n_z = 0",
        "n_z = 1",
        "n_x = 1, n_z = 0",
        "n_y = 1, n_z = 0",
        "n_z = 1",
        "n_x = 1, n_z = 0",
    ];
    let names: Vec<[String; 3]> =
        (1..=6).map(|n| [format!("j{n}"), format!("way{n}"), format!("rod{n}")]).collect();
    let mut units = vec![
        ("world", "spatial/world", "gravity_x = 1, gravity_y = -9, gravity_z = 0.5"),
        ("top", "spatial/translation", "z = 1"),
    ];
    let mut joints = "world.frame=top.a world.frame=j1.a".to_owned();
    for (n, [joint, way, body]) in names.iter().enumerate() {
        units.push((joint, "spatial/revolute", axes[n]));
        if n < 5 {
            units.push((way, "spatial/translation", &ways[n].0));
            units.push((body, "spatial/body", &ways[n].1));
            write!(joints, " {joint}.b={way}.a {way}.a={body}.a {way}.b={}.a", names[n + 1][0])
                .expect("text");
        }
    }
    joints += " j6.b=top.b";
    // The joint in the middle may not be cut: its start is given.
    for (start, kept) in [(0.3, "j1"), (-0.4, "j3"), (0.9, "j4")] {
        let shown = (1..=6).filter(|n| *n != 4 || kept == "j4");
        let outputs: Vec<String> = shown.map(|n| format!("a{n} = \"j{n}.phi\"\n")).collect();
        let outputs = outputs.concat();
        let rest = format!(
            "[initial]\n\"{kept}.phi\" = {start}\n\"{kept}.omega\" = 2.5\n[outputs]\n{outputs}[run]\nuntil = 4\npoints = 81\nrtol = 1e-10\n"
        );
        let (machine, dropped, system) = closed(&scene(&units, &joints, &rest));
        let count = constraints(&system).len();
        assert_eq!(count - dropped.len() + 1, coordinates(&system).len(), "{dropped:?}");
        let found = run(&machine);
        let energy = column(&found, "energy.total");
        let spread = energy.iter().fold(0.0_f64, |most, e| most.max((e - energy[0]).abs()));
        assert!(spread < 1e-6, "{spread:e} J");
        let mut reach = [f64::MAX, f64::MIN];
        for row in 0..found.times.len() {
            let angle = |n: usize| column(&found, &format!("a{n}"))[row];
            for n in (1..=6).filter(|n| *n != 4 || kept == "j4") {
                let alike = angle(if n % 2 == 0 { 2 } else { 1 });
                assert!((angle(n) - alike).abs() < 1e-9, "angle {n}");
            }
            // The angles of Denavit and Hartenberg are a quarter turn less.
            let [a, b] = [1, 2].map(|n| angle(n).sin());
            assert!((a + b + a * b).abs() < 1e-9, "{a} {b}");
            reach = [reach[0].min(angle(1)), reach[1].max(angle(1))];
        }
        assert!(reach[1] - reach[0] > 2.0, "it turns by {reach:?}");
    }
}

/// A crank about z, a rocker about y, and a slender rod on a universal joint and a ball.
const RSSR: &str = r#"
[initial]
"A.phi" = 0
"A.omega" = 10
[guess]
"B.phi_a" = -0.66
"B.phi_b" = -0.81
"D.phi" = -1.2
[outputs]
crank = "A.phi"
rocker = "D.phi"
[run]
until = 2
points = 41
rtol = 1e-11
"#;

fn rssr() -> String {
    let rod =
        "mass = 0.8, centre_x = 0.225, inertia_xx = 0, inertia_yy = 0.0135, inertia_zz = 0.0135";
    let units = [
        ("world", "spatial/world", ""),
        ("A", "spatial/revolute", ""),
        ("crank", "spatial/body", "mass = 0, inertia_xx = 0, inertia_yy = 0, inertia_zz = 0.02"),
        ("arm", "spatial/translation", "x = 0.1"),
        ("B", "spatial/universal", ""),
        ("rod", "spatial/body", rod),
        ("way", "spatial/translation", "x = 0.45"),
        ("C", "spatial/spherical", ""),
        ("post", "spatial/translation", "x = 0.3, y = 0.2"),
        ("D", "spatial/revolute", "n_y = 1, n_z = 0"),
        ("rocker", "spatial/body", "mass = 0, inertia_xx = 0, inertia_yy = 0.03, inertia_zz = 0"),
        ("lever", "spatial/translation", "x = 0.3"),
    ];
    let joints = "world.frame=A.a A.b=crank.a A.b=arm.a arm.b=B.a B.b=rod.a B.b=way.a way.b=C.a \
                  world.frame=post.a post.b=D.a D.b=rocker.a D.b=lever.a C.b=lever.b";
    scene(&units, joints, RSSR)
}

/// The same linkage in two coordinates, its energies written by hand. Its rocker turns the other way.
const BY_HAND: &str = r#"
[scene]
name = "by_hand"
[units]
l = { unit = "linkage" }
[initial]
"l.a" = 0
"l.a_dot" = 10
[guess]
"l.b" = 1.2
[outputs]
crank = "l.a"
rocker = { expression = "-l.b", unit = "rad" }
[run]
until = 2
points = 41
rtol = 1e-11
[define.linkage.coordinates]
a = { unit = "rad" }
b = { unit = "rad" }
[define.linkage.helpers]
ax = { expression = "0.1 [m]*cos(a)", unit = "m" }
ay = { expression = "0.1 [m]*sin(a)", unit = "m" }
bx = { expression = "0.3 [m] + 0.3 [m]*cos(b)", unit = "m" }
bz = { expression = "0.3 [m]*sin(b)", unit = "m" }
[define.linkage.energy]
kinetic = "0.02 [kg m^2]*a_dot^2/2 + 0.03 [kg m^2]*b_dot^2/2 + 0.8 [kg]*(der(ax)^2 + der(ay)^2 + der(ax)*der(bx) + der(bx)^2 + der(bz)^2)/6"
potential = "0.8 [kg]*9.81 [m/s^2]*bz/2"
[define.linkage.constraints.rod]
expression = "sqrt((ax - bx)^2 + (ay - 0.2 [m])^2 + bz^2) - 0.45 [m]"
"#;

/// Returns this machine.
pub fn by_hand() -> ModelSimulator {
    closed(BY_HAND).0
}

#[test]
fn a_linkage_with_balls_moves_as_its_energies_by_hand_say() {
    let (machine, dropped, system) = closed(&rssr());
    assert_eq!(constraints(&system), ["C.b_hold_x", "C.b_hold_y", "C.b_hold_z"]);
    assert_eq!(coordinates(&system), ["A.phi", "B.phi_a", "B.phi_b", "D.phi"]);
    assert!(dropped.is_empty());
    let (found, wanted) = (run(&machine), run(&closed(BY_HAND).0));
    let error = difference(&found, &wanted, &["crank", "rocker"]);
    assert!(error < 1e-8, "{error:e} rad");
    assert!(column(&found, "crank").last().is_some_and(|angle| *angle > 15.0));
}

/// A linkage on an arm that turns: what closes it depends on its own joints alone, and moves as it does by
/// components of the world's.
#[test]
fn a_loop_that_is_carried_depends_on_its_own_joints_alone() {
    let machine = |gap: &str| {
        let text = format!(
            r#"
            [scene]
            name = "carried"
            [units.m]
            unit = "m"
            [initial]
            "m.arm_dot" = 2.0
            "m.lift" = 0.4
            "m.crank" = 1.1
            [guess]
            "m.rod" = -1.0
            "m.rocker" = 1.3
            [run]
            until = 0.5
            points = 3
            rtol = 1e-10
            [define.m]
            gravity = [0, 0, -9.81]
            [define.m.coordinates]
            arm = {{ unit = "rad" }}
            lift = {{ unit = "rad" }}
            crank = {{ unit = "rad" }}
            rod = {{ unit = "rad" }}
            rocker = {{ unit = "rad" }}
            [define.m.frames]
            arm = {{ revolute = {{ axis = [0, 0, 1], angle = "arm" }} }}
            lift = {{ parent = "arm", displacement = [0.3, 0, 0], revolute = {{ axis = [0, 1, 0], angle = "lift" }} }}
            crank = {{ parent = "lift", revolute = {{ axis = [0, 1, 0], angle = "crank" }} }}
            rod = {{ parent = "crank", displacement = [0.2, 0, 0], revolute = {{ axis = [0, 1, 0], angle = "rod" }} }}
            end = {{ parent = "rod", displacement = [0.5, 0, 0] }}
            rocker = {{ parent = "lift", displacement = [0.5, 0, 0], revolute = {{ axis = [0, 1, 0], angle = "rocker" }} }}
            tip = {{ parent = "rocker", displacement = [0.3, 0, 0] }}
            [define.m.bodies]
            lift = {{ frame = "lift", mass = 2, inertia = {{ xx = 0.1, yy = 0.2, zz = 0.15 }} }}
            crank = {{ frame = "crank", mass = 1, centre = [0.1, 0, 0], inertia = {{ xx = 0.01, yy = 0.02, zz = 0.02 }} }}
            rod = {{ frame = "rod", mass = 1, centre = [0.25, 0, 0], inertia = {{ xx = 0.01, yy = 0.03, zz = 0.03 }} }}
            rocker = {{ frame = "rocker", mass = 1, centre = [0.15, 0, 0], inertia = {{ xx = 0.01, yy = 0.02, zz = 0.02 }} }}
            [define.m.constraints]
            x = {{ expression = "x_of({gap})" }}
            z = {{ expression = "z_of({gap})" }}
            "#
        );
        of_text(&text, Keep::All)
    };
    let carried = machine("in_frame(position(tip) - position(end), end)");
    // A product with a number is not recognised as free of the world.
    let by_world = machine("in_frame(1.0*(position(tip) - position(end)), end)");
    assert_eq!(carried.constraint_matrix_pattern().entries.len(), 6);
    let [one, other] =
        [&carried, &by_world].map(|machine| Simulation::new(machine).run().expect("it moves"));
    for name in ["m.arm", "m.lift", "m.crank", "m.rod", "m.rocker"] {
        let [one, other] = [&one, &other].map(|run| run.last(name).expect("its end"));
        assert!((one - other).abs() < 1e-8, "{name}: {one} instead of {other}");
    }
}

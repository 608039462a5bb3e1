//! Long trees, whose accelerations follow from the articulated-body algorithm.

use std::fmt::Write as _;

use machinist_codegen::mechanics::reduce::Keep;
use machinist_model::operations;

use super::compared;
use crate::own_scene::of_text;

/// Returns a tree that turns, slides and rolls, with branches, rotors, springs and dampers.
fn tree(joints: usize) -> String {
    let mut text = String::from(
        "[scene]\nname = \"tree\"\n[units]\nm = { unit = \"tree\" }\n[run]\nuntil = 1\n\
         [define.tree]\ngravity = [0.5, 0, -9.81]\n",
    );
    let mut kinetic = Vec::new();
    for n in 1..=joints {
        let carrier = if n % 5 == 0 { n - 3 } else { n - 1 };
        let parent = if carrier == 0 { "world".to_owned() } else { format!("f{carrier}") };
        let axis = [[1, 2, -2], [0, 0, 1], [-2, 2, 1]][n % 3];
        let joint = match n % 4 {
            1 => {
                kinetic.push(format!("0.02 [kg m^2]*q{n}_dot^2/2"));
                format!("revolute = {{ axis = {axis:?}, angle = \"q{n}\" }}")
            }
            2 => format!("prismatic = {{ axis = {axis:?}, displacement = \"q{n}\" }}"),
            3 => format!("spherical = \"q{n}\""),
            _ => format!("revolute = {{ axis = {axis:?}, angle = \"-2*q{n} + 0.1 [rad/s]*t\" }}"),
        };
        let kind = if n % 4 == 3 { "orientations" } else { "coordinates" };
        writeln!(text, "[define.tree.{kind}.q{n}]").expect("text");
        if n % 4 != 3 {
            let unit = if n % 4 == 2 { "m" } else { "rad" };
            let of = ["N m", "N"][usize::from(n % 4 == 2)];
            writeln!(text, "unit = \"{unit}\"\n[[define.tree.forces]]\ncoordinate = \"q{n}\"")
                .expect("text");
            writeln!(
                text,
                "expression = \"-0.7 [{of} s/{unit}]*q{n}_dot - 0.3 [{of}/{unit}]*q{n}\""
            )
            .expect("text");
        }
        write!(
            text,
            "[define.tree.frames.f{n}]\nparent = \"{parent}\"\ndisplacement = [0.3, 0.1, -0.2]\n{joint}\n\
             [define.tree.bodies.b{n}]\nframe = \"f{n}\"\nmass = 1.2\ncentre = [0.1, 0.05, -0.1]\n\
             inertia = {{ xx = 0.02, yy = 0.03, zz = 0.04, xy = 0.001, xz = 0.002, yz = 0.003 }}\n"
        )
        .expect("text");
    }
    writeln!(text, "[define.tree.energy]\nkinetic = \"{}\"", kinetic.join(" + ")).expect("text");
    text
}

#[test]
fn long_trees_move_as_their_energies_say_with_operations_in_proportion() {
    compared(&tree(12));
    let [short, long] =
        [12, 24].map(|joints| operations(&of_text(&tree(joints), Keep::All).model().rate));
    assert!(long * 10 < short * 23, "{short} and {long} operations");
}

//! Constraints that close the joints at which loops are cut.
//!
//! With positions p and rotations R of the frames a and b beside the joint, n its axis along both,
//! and u, v two vectors normal to n:
//!
//! ```text
//! origins coincide                p_b - p_a = 0, along the axes of the world
//! origins on the axis             (R_a u) . (p_b - p_a) = (R_a v) . (p_b - p_a) = 0
//! axes parallel                   (R_a u) . (R_b n) = (R_a v) . (R_b n) = 0
//! axes parallel to each other's   (R_a x) . (R_b y) = (R_a y) . (R_b z) = (R_a z) . (R_b x) = 0
//! ```

use machinist_algebra::cas::arithmetic::{negative, normal_form, sum};
use machinist_algebra::expr::{Expr, ParameterId};

use crate::scene::frames::fixed;
use crate::scene::loops::{Closing, Cut, across};
use crate::scene::names::name;
use crate::scene::resolve::Resolver;
use crate::scene::system::Constraint;
use crate::spatial::mechanism::Placed;
use crate::spatial::vector::{Vector, cross, dot, minus, plus, times, transposed};
use crate::spec::diagnostic::Mistake;
use crate::spec::dimension::Dimension;

/// A constraint of a cut joint.
#[derive(Debug, Clone, Copy)]
pub struct Row {
    /// End of its name.
    end: &'static str,
    doc: &'static str,
    /// Dimension of its expression.
    pub dimension: Dimension,
}

impl Row {
    const fn new(end: &'static str, doc: &'static str, dimension: Dimension) -> Self {
        Row { end, doc, dimension }
    }

    /// Returns its name, which starts with that of the joint's frame.
    pub fn name(&self, frame: &str) -> String {
        format!("{frame}_{}", self.end)
    }
}

const HOLD: [Row; 3] = [
    Row::new("hold_x", "origins coincide along x", Dimension::LENGTH),
    Row::new("hold_y", "origins coincide along y", Dimension::LENGTH),
    Row::new("hold_z", "origins coincide along z", Dimension::LENGTH),
];
const SLIDE: [Row; 2] = [
    Row::new("slide_1", "the origin stays on the axis", Dimension::LENGTH),
    Row::new("slide_2", "the origin stays on the axis", Dimension::LENGTH),
];
const LIFT: [Row; 1] = [Row::new("lift", "origins stay in one plane", Dimension::LENGTH)];
const TILT: [Row; 2] = [
    Row::new("tilt_1", "both axes are parallel", Dimension::ONE),
    Row::new("tilt_2", "both axes are parallel", Dimension::ONE),
];
const CROSS: [Row; 1] = [Row::new("cross", "both axes keep their angle", Dimension::ONE)];
const TURN: [Row; 3] = [
    Row::new("turn_x", "no rotation about x", Dimension::ONE),
    Row::new("turn_y", "no rotation about y", Dimension::ONE),
    Row::new("turn_z", "no rotation about z", Dimension::ONE),
];

impl Closing {
    /// Returns the constraints that close the joint, as many as it takes freedoms.
    pub fn rows(&self) -> Vec<Row> {
        let none: &[Row] = &[];
        let [first, second] = match self {
            Self::Rigid => [&HOLD[..], &TURN],
            Self::Revolute(_) => [&HOLD[..], &TILT],
            Self::Prismatic(_) => [&SLIDE[..], &TURN],
            Self::Cylindrical(_) => [&SLIDE[..], &TILT],
            Self::Universal(_) => [&HOLD[..], &CROSS],
            Self::Planar(_) => [&LIFT[..], &TILT],
            Self::Spherical => [&HOLD[..], none],
            Self::Free => [none; 2],
        };
        [first, second].concat()
    }
}

impl Resolver<'_> {
    /// Returns the constraints that close a cut.
    ///
    /// # Errors
    /// The first mistake in the frames.
    pub(super) fn closed(
        &mut self,
        cut: &Cut,
        parameter: &impl Fn(ParameterId) -> f64,
    ) -> Result<Vec<Constraint>, Box<Mistake>> {
        let (instance, frame) = cut.name(self.spec);
        let spatial = self.spatial(instance, cut.span)?;
        let [from, to] = cut.ends.map(|end| spatial.frame(end).clone());
        let a = spatial.mechanism.placed(&fixed(from, &cut.steps[0], true));
        let b = spatial.mechanism.placed(&fixed(to, &cut.steps[1], false));
        let owner = &self.spec.instances[instance].name.value;
        let expressions = expressions(&cut.joint, &a, &b, parameter);
        let closed = cut.joint.rows().into_iter().zip(expressions).map(|(row, expr)| Constraint {
            name: name(Some(owner), &row.name(frame)),
            doc: row.doc.to_owned(),
            unit: row.dimension.as_unit(),
            expr,
            is_of_positions: true,
            when: Vec::new(),
            is_dropped: false,
            friction: None,
        });
        Ok(closed.collect())
    }
}

/// Returns the expressions of the rows, between the frames beside a joint.
fn expressions(
    joint: &Closing,
    a: &Placed,
    b: &Placed,
    parameter: &impl Fn(ParameterId) -> f64,
) -> Vec<Expr> {
    let way = plus(&b.position, &minus(&a.position));
    let normals = |axis: &Vector| {
        let u = across(axis, parameter);
        let v = cross(axis, &u);
        [u, v].map(|normal| times(&a.rotation, &normal))
    };
    let slides = |normals: &[Vector; 2]| normals.each_ref().map(|normal| dot(normal, &way));
    let tilts = |normals: &[Vector; 2], axis: &Vector| {
        let own = times(&b.rotation, axis);
        normals.each_ref().map(|normal| dot(normal, &own))
    };
    match joint {
        Closing::Free => Vec::new(),
        Closing::Spherical => way.to_vec(),
        Closing::Rigid => [way, turns(a, b)].concat(),
        Closing::Revolute(axis) => [&way[..], &tilts(&normals(axis), axis)].concat(),
        Closing::Prismatic(axis) => [&slides(&normals(axis))[..], &turns(a, b)].concat(),
        Closing::Cylindrical(axis) => {
            let normals = normals(axis);
            [slides(&normals), tilts(&normals, axis)].concat()
        }
        Closing::Planar(axis) => {
            let lift = dot(&times(&a.rotation, axis), &way);
            [&[lift][..], &tilts(&normals(axis), axis)].concat()
        }
        Closing::Universal([first, second]) => {
            let between = dot(&times(&a.rotation, first), &times(&b.rotation, second));
            let given = normal_form(&dot(first, second));
            let cross = sum([between, negative(&given)]).shared();
            [&way[..], &[cross]].concat()
        }
    }
}

fn turns(a: &Placed, b: &Placed) -> [Expr; 3] {
    let ([ax, ay, az], [bx, by, bz]) = (transposed(&a.rotation), transposed(&b.rotation));
    [dot(&ay, &bz), dot(&az, &bx), dot(&ax, &by)]
}

//! The drawing of a machine in space: joints, links and bodies with their places in the world.
//!
//! Links and joints follow from the steps between frames, bodies from their shapes. A body without a
//! shape is its centre of mass; one that nothing else shows is the solid with its moments of inertia.

use std::collections::BTreeSet;

use machinist_algebra::cas::arithmetic::{negative, normal_form, product, sum};
use machinist_algebra::expr::{Expr, ParameterId};
use machinist_model::ElementKind;
use num_rational::BigRational;

use crate::scene::bodies::{Spatial, Step};
use crate::scene::evaluate;
use crate::scene::frames::{Node, find, fixed};
use crate::scene::layout::Scope;
use crate::scene::loops::{Closing, Cut, across};
use crate::scene::resolve::{Resolver, Wanted};
use crate::scene::system::Drawn;
use crate::scene::typed::{Uses, select_less};
use crate::spatial::mechanism::{Body, Frame, Mechanism};
use crate::spatial::vector::{
    Matrix3, Vector, identity, minus, multiplied, plus, scaled, times, transposed, zero,
};
use crate::spec::Formula;
use crate::spec::diagnostic::Mistake;
use crate::spec::dimension::Dimension;
use crate::spec::shape::{FormSpec, ShapeSpec};

/// A step that was taken from one frame to the next.
#[derive(Debug)]
pub(super) struct Taken {
    /// Instance and index of the frame whose step it is.
    pub frame: (usize, usize),
    pub step: Step,
    /// Frames before and after it.
    pub between: [Frame; 2],
}

/// A body, with the frame to which it is fixed.
#[derive(Debug)]
pub(super) struct Attached {
    pub instance: usize,
    pub name: String,
    pub frame: Node,
    pub body: Body,
}

/// Relative difference below which two moments of inertia count as equal.
const ALIKE: f64 = 1e-6;

impl Resolver<'_> {
    /// Returns the elements of the drawing of connected instances.
    pub(super) fn drawn(
        &mut self,
        instances: &[usize],
        spatial: &Spatial,
    ) -> Result<Vec<Drawn>, Box<Mistake>> {
        let spec = self.spec;
        let tree = &spatial.mechanism;
        let mut drawn = vec![Drawn::new(ElementKind::Up, String::new(), minus(&tree.gravity))];
        let unit = |instance: usize| &spec.units[spec.instances[instance].unit];
        let name =
            |instance: usize, own: &str| format!("{}.{own}", spec.instances[instance].name.value);
        // Joints whose bodies something shows.
        let mut shown: BTreeSet<Option<usize>> = BTreeSet::new();
        for &instance in instances {
            for shape in &unit(instance).shapes {
                let frame = find(unit(instance), &shape.frame)?.map(|index| (instance, index));
                shown.insert(spatial.frame(frame).joint);
                let path = name(instance, &shape.name.value);
                drawn.push(self.shape(shape, instance, spatial, path)?);
            }
        }
        for taken in spatial.taken() {
            let (instance, index) = taken.frame;
            let path = name(instance, &unit(instance).frames[index].name.value);
            let is_one_of_many = spatial
                .taken()
                .iter()
                .filter(|other| other.frame == taken.frame && matches!(other.step, Step::Slide(..)))
                .nth(1)
                .is_some();
            let covered = !unit(instance).shapes.is_empty();
            if let Some(element) = joint_or_link(tree, taken, path, is_one_of_many, covered) {
                if element.kind == ElementKind::Link {
                    shown.insert(taken.between[0].joint);
                }
                drawn.push(element);
            }
        }
        for cut in self.layout.cuts.iter().filter(|cut| instances.contains(&cut.name(spec).0)) {
            let (instance, frame) = cut.name(spec);
            drawn.extend(closing(spatial, cut, &name(instance, frame)));
        }
        for attached in spatial.attached() {
            let Attached { instance, name: own, frame, body } = attached;
            if unit(*instance).shapes.is_empty() {
                let frame = spatial.frame(*frame);
                let is_shown = shown.contains(&frame.joint);
                drawn.extend(self.bare(tree, frame, body, name(*instance, own), is_shown));
            }
        }
        Ok(drawn)
    }

    /// Returns the element of a shape.
    fn shape(
        &mut self,
        spec: &ShapeSpec,
        instance: usize,
        spatial: &Spatial,
        path: String,
    ) -> Result<Drawn, Box<Mistake>> {
        let scope = Scope::Instance(instance);
        let unit = &self.spec.units[self.spec.instances[instance].unit];
        let of = |name| -> Result<&Frame, Box<Mistake>> {
            let found = find(unit, name)?.map(|index| (instance, index));
            Ok(spatial.frame(found))
        };
        let tree = &spatial.mechanism;
        let frame = of(&spec.frame)?;
        let centre = match &spec.centre {
            Some(centre) => {
                let what = "the centre of a shape";
                self.components(centre, scope, Dimension::LENGTH, what, Uses::PARAMETERS)?
            }
            None => zero(),
        };
        let rotation = self.constant_rotation(&spec.rotations, scope)?;
        let (position, axes) = pose(tree, frame, &centre, &rotation);
        Ok(match &spec.form {
            FormSpec::Box(edges) => {
                let what = "an edge of a box";
                let edges =
                    self.components(edges, scope, Dimension::LENGTH, what, Uses::PARAMETERS)?;
                a_box(path, position, &axes, &edges.map(|edge| product([half(), edge])))
            }
            FormSpec::Cylinder(cylinder) => {
                let axis = match &cylinder.axis {
                    Some(axis) => {
                        let what = "a component of an axis";
                        let allowed = Uses::PARAMETERS;
                        self.components(axis, scope, Dimension::ONE, what, allowed)?
                    }
                    None => identity()[2].clone(),
                };
                let [length, diameter] = [
                    self.length(&cylinder.length, scope)?,
                    self.length(&cylinder.diameter, scope)?,
                ];
                let axis = unit_vector(&axis);
                let values = self.values;
                let side = unit_vector(&across(&axis, &value_of(values)));
                let [axis, side] = [axis, side].map(|vector| times(&axes, &vector));
                a_cylinder(path, &position, [&axis, &side], &length, product([half(), diameter]))
            }
            FormSpec::Sphere(diameter) => {
                let diameter = self.length(diameter, scope)?;
                a_sphere(path, position, &axes, product([half(), diameter]))
            }
            FormSpec::Rod(to) | FormSpec::Spring(to) => {
                let end = pose(tree, of(to)?, &zero(), &identity()).0;
                let is_rod = matches!(spec.form, FormSpec::Rod(_));
                let kind = if is_rod { ElementKind::Rod } else { ElementKind::Spring };
                Drawn::new(kind, path, position.into_iter().chain(end))
            }
        })
    }

    fn length(&mut self, formula: &Formula, scope: Scope) -> Result<Expr, Box<Mistake>> {
        let wanted = Wanted::new(Dimension::LENGTH, "a length").of(Uses::PARAMETERS);
        Ok(normal_form(&self.formula(formula, scope, &wanted)?.expr))
    }

    /// Returns the elements of a body without a shape: its centre of mass with a link to its frame,
    /// or, if nothing else shows the body, a solid with its mass and moments of inertia.
    fn bare(
        &self,
        tree: &Mechanism,
        frame: &Frame,
        body: &Body,
        path: String,
        is_shown: bool,
    ) -> Vec<Drawn> {
        let value = value_of(self.values);
        let (position, axes) = pose(tree, frame, &body.centre, &body.rotation);
        let moments: Vector = std::array::from_fn(|axis| body.tensor[axis][axis].clone());
        let values = moments.each_ref().map(|moment| evaluate(moment, &value));
        let largest = values.iter().copied().fold(0.0, f64::max);
        let has_size = largest > 0.0 && evaluate(&body.mass, &value) > 0.0;
        if is_shown || !has_size {
            let mass = Drawn::new(ElementKind::Mass, path.clone(), position.clone());
            let from = pose(tree, frame, &zero(), &identity()).0;
            let link = (from != position)
                .then(|| Drawn::new(ElementKind::Link, path, from.into_iter().chain(position)));
            return link.into_iter().chain([mass]).collect();
        }
        let per_mass = |factor: (i64, i64), moment: Expr| {
            product([
                number(factor),
                moment,
                Expr::Power(Box::new(body.mass.clone()), Box::new(Expr::integer(-1))),
            ])
        };
        let alike = |a: usize, b: usize| (values[a] - values[b]).abs() <= ALIKE * largest;
        if alike(0, 1) && alike(1, 2) {
            // I = 2 m r^2/5
            let radius = root(per_mass((5, 2), moments[0].clone()));
            return vec![of_inertia(a_sphere(path, position, &axes, radius))];
        }
        if let Some(axis) = (0..3).find(|axis| alike((axis + 1) % 3, (axis + 2) % 3)) {
            // I = m r^2/2 along the axis, m (3 r^2 + l^2)/12 across
            let [along, side] = [axis, (axis + 1) % 3].map(|index| column(&axes, index));
            let square = per_mass((2, 1), moments[axis].clone());
            let across = per_mass((12, 1), moments[(axis + 1) % 3].clone());
            let length = root(sum([across, product([Expr::integer(-3), square.clone()])]));
            return vec![of_inertia(a_cylinder(
                path,
                &position,
                [&along, &side],
                &length,
                root(square),
            ))];
        }
        // I = m (b^2 + c^2)/12 for the edges b and c across
        let halves: Vector = std::array::from_fn(|axis| {
            let [next, last] = [1, 2].map(|by| moments[(axis + by) % 3].clone());
            root(per_mass((3, 2), sum([next, last, negative(&moments[axis])])))
        });
        vec![of_inertia(a_box(path, position, &axes, &halves))]
    }
}

/// Returns the element of a step between frames, if it shows anything. Slides of frames that move
/// along several axes are not shown, nor links that shapes cover.
fn joint_or_link(
    tree: &Mechanism,
    taken: &Taken,
    path: String,
    is_one_of_many: bool,
    is_covered: bool,
) -> Option<Drawn> {
    let [(before, axes), (after, _)] =
        taken.between.each_ref().map(|frame| pose(tree, frame, &zero(), &identity()));
    match &taken.step {
        Step::Move(_) if !is_covered && before != after => {
            Some(Drawn::new(ElementKind::Link, path, before.into_iter().chain(after)))
        }
        Step::Slide(axis, _) if !is_one_of_many => {
            let axis = times(&axes, axis);
            Some(Drawn::new(ElementKind::Slide, path, before.into_iter().chain(after).chain(axis)))
        }
        Step::Revolve(axis, _) => {
            let axis = times(&axes, axis);
            Some(Drawn::new(ElementKind::Hinge, path, before.into_iter().chain(axis)))
        }
        Step::Orient(_) => Some(Drawn::new(ElementKind::Ball, path, before)),
        Step::Move(_) | Step::Turn(_) | Step::Slide(..) => None,
    }
}

/// Returns the elements of a joint at which a loop is cut.
fn closing(spatial: &Spatial, cut: &Cut, path: &str) -> Vec<Drawn> {
    let tree = &spatial.mechanism;
    let ends = cut.ends.map(|end| spatial.frame(end).clone());
    let joints =
        [fixed(ends[0].clone(), &cut.steps[0], true), fixed(ends[1].clone(), &cut.steps[1], false)];
    let place = |frame: &Frame| pose(tree, frame, &zero(), &identity());
    let mut drawn = Vec::new();
    for (end, joint) in ends.iter().zip(&joints) {
        let [from, to] = [place(end).0, place(joint).0];
        if from != to {
            let line = from.into_iter().chain(to);
            drawn.push(Drawn::new(ElementKind::Link, path.to_owned(), line));
        }
    }
    let [(here, axes), (there, other)] = joints.each_ref().map(place);
    let hinge = |axes: &Matrix3, axis: &Vector| {
        let axis = times(axes, axis);
        Drawn::new(ElementKind::Hinge, path.to_owned(), here.clone().into_iter().chain(axis))
    };
    let slide = |axis: &Vector| {
        let line = here.clone().into_iter().chain(there.clone()).chain(times(&axes, axis));
        Drawn::new(ElementKind::Slide, path.to_owned(), line)
    };
    match &cut.joint {
        Closing::Rigid | Closing::Free | Closing::Planar(_) => {}
        Closing::Revolute(axis) => drawn.push(hinge(&axes, axis)),
        Closing::Prismatic(axis) => drawn.push(slide(axis)),
        Closing::Cylindrical(axis) => drawn.extend([hinge(&axes, axis), slide(axis)]),
        Closing::Universal([one, two]) => drawn.extend([hinge(&axes, one), hinge(&other, two)]),
        Closing::Spherical => {
            drawn.push(Drawn::new(ElementKind::Ball, path.to_owned(), here.clone()));
        }
    }
    drawn
}

/// Returns a point and axes, given relative to a frame, as the world sees them.
fn pose(tree: &Mechanism, frame: &Frame, at: &Vector, axes: &Matrix3) -> (Vector, Matrix3) {
    let (position, rotation) = tree.pose(frame);
    (plus(&position, &times(&rotation, at)), multiplied(&rotation, axes))
}

fn column(matrix: &Matrix3, index: usize) -> Vector {
    transposed(matrix)[index].clone()
}

fn a_box(path: String, centre: Vector, axes: &Matrix3, halves: &Vector) -> Drawn {
    let sides =
        halves.iter().enumerate().flat_map(|(axis, half)| scaled(half, &column(axes, axis)));
    Drawn::new(ElementKind::Box, path, centre.into_iter().chain(sides.collect::<Vec<_>>()))
}

fn a_sphere(path: String, centre: Vector, axes: &Matrix3, radius: Expr) -> Drawn {
    let [x, y] = [0, 1].map(|axis| column(axes, axis));
    Drawn::new(ElementKind::Sphere, path, centre.into_iter().chain(x).chain(y).chain([radius]))
}

fn a_cylinder(
    path: String,
    centre: &Vector,
    [axis, side]: [&Vector; 2],
    length: &Expr,
    radius: Expr,
) -> Drawn {
    let way = scaled(&product([half(), length.clone()]), axis);
    let [one, other] = [plus(centre, &minus(&way)), plus(centre, &way)];
    let numbers = one.into_iter().chain(other).chain(side.clone()).chain([radius]);
    Drawn::new(ElementKind::Cylinder, path, numbers)
}

fn of_inertia(drawn: Drawn) -> Drawn {
    Drawn { is_of_inertia: true, ..drawn }
}

fn value_of(values: &[f64]) -> impl Fn(ParameterId) -> f64 + '_ {
    |id| values.get(id.0 as usize).copied().unwrap_or(f64::NAN)
}

fn number((numerator, denominator): (i64, i64)) -> Expr {
    Expr::Number(BigRational::new(numerator.into(), denominator.into()))
}

fn half() -> Expr {
    number((1, 2))
}

/// Returns the square root of x, or 0 for negative x.
fn root(x: Expr) -> Expr {
    let x = x.shared();
    let root = Expr::Power(Box::new(x.clone()), Box::new(half()));
    select_less(x, Expr::integer(0), Expr::integer(0), root).shared()
}

fn unit_vector(vector: &Vector) -> Vector {
    let square = crate::spatial::vector::dot(vector, vector);
    scaled(&Expr::Power(Box::new(square), Box::new(number((-1, 2)))), vector)
}

//! Frames, orientations and rigid bodies of instances.

use std::cell::RefCell;
use std::collections::HashMap;
use std::rc::Rc;

use machinist_algebra::cas::arithmetic::{normal_form, product, sum};
use machinist_algebra::expr::{Expr, Symbol};
use num_rational::BigRational;

use crate::scene::drawing::{Attached, Taken};
use crate::scene::evaluate;
use crate::scene::frames::turn;
use crate::scene::layout::{FramePart, Scope};
use crate::scene::resolve::{Resolved, Resolver, Wanted};
use crate::scene::typed::{Typed, Uses};
use crate::spatial::mechanism::{Body, Frame, Mechanism, Placed};
use crate::spatial::orientation::{Orientation, Orientations};
use crate::spatial::vector::{
    Matrix3, Vector, identity, multiplied, of_quaternion, sine_and_cosine, zero,
};
use crate::spec::body::{AxisSpec, BodySpec, Components, FrameSpec, RotationSpec};
use crate::spec::code::Code;
use crate::spec::diagnostic::{Mistake, Span, Spanned};
use crate::spec::dimension::{Angular, Dimension};
use crate::spec::{CoordinateSpec, Formula, ROUNDED_GYRATION, did_you_mean, quoted};

/// Frames and bodies of connected instances.
#[derive(Debug)]
pub struct Spatial {
    /// The tree of joints, with bodies.
    pub mechanism: Mechanism,
    /// Frames by instance and index; the world by `None`.
    frames: HashMap<Option<(usize, usize)>, Frame>,
    /// The world's view of each frame that has been asked for.
    placed: RefCell<HashMap<(usize, usize), Rc<Placed>>>,
    /// The view of a joint likewise, by frame and joint.
    carried: RefCell<Poses>,
    /// Steps between frames, for drawings.
    taken: Vec<Taken>,
    /// Bodies, for drawings.
    attached: Vec<Attached>,
}

/// Positions of frames and their axes as columns, by frame and the joint that sees them.
type Poses = HashMap<((usize, usize), usize), Rc<(Vector, Matrix3)>>;

/// State of the tree of an instance.
pub(super) enum Tree {
    Pending,
    Done(Rc<Spatial>),
    Failed(Box<Mistake>),
}

/// A step from a frame's parent to the frame.
#[derive(Debug, Clone)]
pub enum Step {
    /// By a fixed way.
    Move(Vector),
    /// By a fixed rotation.
    Turn(Box<Matrix3>),
    /// By a joint along an axis.
    Slide(Vector, Expr),
    /// By a joint about an axis.
    Revolve(Vector, Expr),
    /// By a joint that turns freely.
    Orient(Orientation),
}

impl Step {
    /// Reports whether it does not move.
    pub(super) fn is_fixed(&self) -> bool {
        matches!(self, Step::Move(_) | Step::Turn(_))
    }
}

impl Spatial {
    pub(super) fn new(
        mechanism: Mechanism,
        frames: HashMap<Option<(usize, usize)>, Frame>,
        taken: Vec<Taken>,
        attached: Vec<Attached>,
    ) -> Self {
        let (placed, carried) = (RefCell::default(), RefCell::default());
        Spatial { mechanism, frames, placed, carried, taken, attached }
    }

    /// Returns the bodies with the frames to which they are fixed.
    pub(super) fn attached(&self) -> &[Attached] {
        &self.attached
    }

    /// Returns the steps between frames, from the world outwards.
    pub(super) fn taken(&self) -> &[Taken] {
        &self.taken
    }

    /// Returns a frame; the world for `None`.
    pub(super) fn frame(&self, frame: Option<(usize, usize)>) -> &Frame {
        &self.frames[&frame]
    }

    /// Returns the outermost joint that carries all of some frames; `None` for the world, or if a frame
    /// belongs to another tree.
    pub(super) fn common_carrier(&self, frames: &[(usize, usize)]) -> Option<usize> {
        let frames: Option<Vec<&Frame>> =
            frames.iter().map(|frame| self.frames.get(&Some(*frame))).collect();
        self.mechanism.common_carrier(&frames?)
    }

    /// Returns a component of the position or orientation of a frame, as a joint that carries it sees it.
    fn component_on(&self, carrier: usize, frame: (usize, usize), part: FramePart) -> Option<Expr> {
        let mut all = self.carried.borrow_mut();
        let pose = all
            .entry((frame, carrier))
            .or_insert_with(|| Rc::new(self.mechanism.pose_on(carrier, self.frame(Some(frame)))));
        match part {
            FramePart::Position(axis) => Some(pose.0[axis].clone()),
            FramePart::Rotation(row, column) => Some(pose.1[row][column].clone()),
            FramePart::Velocity(_) | FramePart::Omega(_) => None,
        }
    }

    fn component(&self, frame: (usize, usize), part: FramePart) -> Expr {
        let mut all = self.placed.borrow_mut();
        let placed = all
            .entry(frame)
            .or_insert_with(|| Rc::new(self.mechanism.placed(self.frame(Some(frame)))));
        match part {
            FramePart::Position(axis) => placed.position[axis].clone(),
            FramePart::Velocity(axis) => placed.velocity[axis].clone(),
            FramePart::Omega(axis) => placed.omega[axis].clone(),
            FramePart::Rotation(row, column) => placed.rotation[row][column].clone(),
        }
    }
}

impl Resolver<'_> {
    /// Resolves a component of the motion of a frame.
    pub(super) fn of_frame(
        &mut self,
        instance: usize,
        frame: usize,
        part: FramePart,
        span: Span,
    ) -> Resolved {
        let spatial = self.spatial(instance, span)?;
        self.spend(1, span)?;
        let frame = (instance, frame);
        let seen = self.carrier.and_then(|carrier| spatial.component_on(carrier, frame, part));
        let expr = seen.unwrap_or_else(|| spatial.component(frame, part));
        let uses = uses_of(&expr);
        let unit = part.unit();
        let angular = Angular::of(unit, uses.moves());
        Ok(Typed::leaf(expr, unit.dimension, angular, uses))
    }

    /// Returns the tree of an instance and all that is connected with it, built once.
    ///
    /// # Errors
    /// The first mistake in its frames and bodies.
    pub(super) fn spatial(
        &mut self,
        instance: usize,
        span: Span,
    ) -> Result<Rc<Spatial>, Box<Mistake>> {
        let instances = self.connected(instance);
        let key = instances[0];
        match self.trees.get(&key) {
            Some(Tree::Done(done)) => return Ok(Rc::clone(done)),
            Some(Tree::Failed(mistake)) => return Err(mistake.clone()),
            Some(Tree::Pending) => {
                let message = "the motion of a frame depends on a frame of the same unit";
                let mistake =
                    Mistake::new(Code::ForbiddenDependence, span, message, "back to itself");
                return Err(Box::new(mistake.help("write it with coordinates")));
            }
            None => {}
        }
        self.trees.insert(key, Tree::Pending);
        let (level, spent) = (self.level, self.spent);
        let built = self.build(&instances);
        (self.level, self.spent) = (level, spent);
        let built = built.map(Rc::new);
        let state = match &built {
            Ok(done) => Tree::Done(Rc::clone(done)),
            Err(mistake) => Tree::Failed(mistake.clone()),
        };
        self.trees.insert(key, state);
        built
    }

    /// Returns the acceleration of free fall of connected instances, which one of them gives.
    pub(super) fn gravity(&mut self, instances: &[usize]) -> Result<Vector, Box<Mistake>> {
        let spec = self.spec;
        let unit = |instance: usize| &spec.units[spec.instances[instance].unit];
        let mut given = instances.iter().filter(|instance| unit(**instance).gravity.is_some());
        let Some((first, gravity)) =
            given.next().and_then(|one| Some((*one, unit(*one).gravity.as_ref()?)))
        else {
            return Ok(zero());
        };
        if let Some(other) = given.next() {
            let name = |instance: usize| quoted(&spec.instances[instance].name.value);
            let message = format!(
                "both {} and {} give the gravity of the same machine",
                name(first),
                name(*other)
            );
            let mistake = Mistake::new(
                Code::DuplicateName,
                spec.instances[*other].name.span,
                message,
                "a second",
            );
            return Err(Box::new(mistake.help("leave one of them out")));
        }
        let what = "the acceleration of free fall";
        let scope = Scope::Instance(first);
        self.components(gravity, scope, Dimension::ACCELERATION, what, Uses::PARAMETERS)
    }

    /// Returns the steps from a frame's parent to the frame.
    pub(super) fn steps(
        &mut self,
        frame: &FrameSpec,
        scope: Scope,
    ) -> Result<Vec<Step>, Box<Mistake>> {
        let mut steps = Vec::new();
        if let Some(displacement) = &frame.displacement {
            let what = "a displacement";
            let r = self.components(displacement, scope, Dimension::LENGTH, what, Uses::PLACE)?;
            for (axis, by) in r.iter().enumerate().filter(|(_, by)| moves(by)) {
                steps.push(Step::Slide(unit_vector(axis), by.clone()));
            }
            steps.push(Step::Move(r.map(|by| if moves(&by) { Expr::integer(0) } else { by })));
        }
        for rotation in &frame.rotations {
            steps.extend(self.turns(rotation, scope)?);
        }
        if let Some(joint) = &frame.revolute {
            let (axis, angle) = self.axis(joint, scope, Dimension::ONE)?;
            let is_moving = moves(&angle);
            steps.push(turn(axis, angle, is_moving));
        }
        if let Some(orientation) = &frame.spherical {
            let Scope::Instance(instance) = scope else { return Ok(steps) };
            steps.push(Step::Orient(self.orientation_named(instance, orientation)?));
        }
        if let Some(joint) = &frame.prismatic {
            let (axis, length) = self.axis(joint, scope, Dimension::LENGTH)?;
            steps.push(if moves(&length) {
                Step::Slide(axis, length)
            } else {
                Step::Move(axis.map(|entry| product([entry, length.clone()])))
            });
        }
        Ok(steps)
    }

    /// Returns the steps of a rotation.
    fn turns(&mut self, rotation: &RotationSpec, scope: Scope) -> Result<Vec<Step>, Box<Mistake>> {
        match rotation {
            RotationSpec::Axis(axis) => {
                let (axis, angle) = self.axis(axis, scope, Dimension::ONE)?;
                let is_moving = moves(&angle);
                Ok(vec![turn(axis, angle, is_moving)])
            }
            RotationSpec::Sequence(turns) => {
                let mut steps = Vec::new();
                for (axis, angle) in turns {
                    let angle = self.angle_of(angle, scope)?;
                    let is_moving = moves(&angle);
                    steps.push(turn(unit_vector(*axis), angle, is_moving));
                }
                Ok(steps)
            }
            RotationSpec::Quaternion(parts, span) => {
                Ok(vec![Step::Turn(Box::new(self.quaternion(parts, scope, *span)?))])
            }
        }
    }

    /// Returns the matrix of rotations that do not move.
    pub(super) fn constant_rotation(
        &mut self,
        rotations: &[RotationSpec],
        scope: Scope,
    ) -> Result<Matrix3, Box<Mistake>> {
        let (mut whole, mut is_fixed) = (identity(), true);
        for rotation in rotations {
            for step in self.turns(rotation, scope)? {
                match step {
                    Step::Turn(matrix) => whole = multiplied(&whole, &matrix),
                    _ => is_fixed = false,
                }
            }
        }
        if is_fixed {
            return Ok(whole);
        }
        let span = match rotations.first() {
            Some(RotationSpec::Axis(axis)) => axis.span,
            Some(RotationSpec::Sequence(turns)) if !turns.is_empty() => turns[0].1.span(),
            _ => Span { ..self.spec.name.span },
        };
        let message = "the axes of an inertia do not move relative to their frame";
        let mistake =
            Mistake::new(Code::NoEffect, span, message, "depends on a coordinate or time");
        Err(Box::new(mistake.help("fix the body to a frame that moves")))
    }

    /// Returns the orientations of all instances, in the order of their parts w.
    pub(super) fn orientations(&self) -> Orientations {
        let mut all = Vec::new();
        for (instance, spec) in self.spec.instances.iter().enumerate() {
            let count = self.spec.units[spec.unit].orientations.len();
            let present = (0..count).filter(|index| self.layout.has_orientation(instance, *index));
            all.extend(present.map(|index| self.parts_of(instance, index)));
        }
        Orientations::new(all)
    }

    /// Returns the parts of an orientation of an instance.
    pub(super) fn parts_of(&self, instance: usize, index: usize) -> Orientation {
        let unit = &self.spec.units[self.spec.instances[instance].unit];
        let is_first = |coordinate: &CoordinateSpec| coordinate.orientation == Some(index);
        let first = unit.coordinates.iter().position(is_first).unwrap_or_default();
        self.layout.parts(instance, index, first)
    }

    fn orientation_named(
        &self,
        instance: usize,
        name: &Spanned<String>,
    ) -> Result<Orientation, Box<Mistake>> {
        let unit = &self.spec.units[self.spec.instances[instance].unit];
        let found = unit.orientations.iter().position(|one| one.name.value == name.value);
        let index = found.ok_or_else(|| {
            let message = format!("there is no orientation {}", quoted(&name.value));
            let names = unit.orientations.iter().map(|one| one.name.value.as_str());
            let help = format!(
                "{}declare it by `[orientations]`, `{} = {{}}`",
                did_you_mean(&name.value, names),
                name.value
            );
            Mistake::new(Code::UnknownName, name.span, message, "unknown").help(help)
        })?;
        Ok(self.parts_of(instance, index))
    }

    /// Returns the quaternion of rotations that do not move.
    pub(super) fn quaternion_of(
        &mut self,
        rotations: &[RotationSpec],
        scope: Scope,
    ) -> Result<[Expr; 4], Box<Mistake>> {
        let mut whole = [1, 0, 0, 0].map(Expr::integer);
        for rotation in rotations {
            match rotation {
                RotationSpec::Axis(axis) => {
                    let (direction, angle) = self.axis(axis, scope, Dimension::ONE)?;
                    still(&angle, axis.by.span())?;
                    whole = hamilton(&whole, &half_turned(&direction, &angle));
                }
                RotationSpec::Sequence(turns) => {
                    for (axis, formula) in turns {
                        let angle = self.angle_of(formula, scope)?;
                        still(&angle, formula.span())?;
                        whole = hamilton(&whole, &half_turned(&unit_vector(*axis), &angle));
                    }
                }
                RotationSpec::Quaternion(parts, span) => {
                    let parts = self.parts_of_quaternion(parts, scope, *span)?;
                    whole = hamilton(&whole, &unit_quaternion(&parts));
                }
            }
        }
        Ok(whole)
    }

    fn quaternion(
        &mut self,
        parts: &[Formula; 4],
        scope: Scope,
        span: Span,
    ) -> Result<Matrix3, Box<Mistake>> {
        Ok(of_quaternion(&self.parts_of_quaternion(parts, scope, span)?))
    }

    fn parts_of_quaternion(
        &mut self,
        parts: &[Formula; 4],
        scope: Scope,
        span: Span,
    ) -> Result<[Expr; 4], Box<Mistake>> {
        let wanted = Wanted::new(Dimension::ONE, "a part of a quaternion").of(Uses::PARAMETERS);
        let mut values = [0; 4].map(Expr::integer);
        for (value, part) in values.iter_mut().zip(parts) {
            *value = normal_form(&self.formula(part, scope, &wanted)?.expr);
        }
        let parts = values;
        let norm = sum(parts.iter().map(|part| product([part.clone(), part.clone()])));
        if norm.is_zero() {
            let mistake = Mistake::new(
                Code::UndefinedValue,
                span,
                "a quaternion of magnitude 0 is no rotation",
                "zero",
            );
            return Err(Box::new(mistake.help("no rotation is [1, 0, 0, 0]")));
        }
        Ok(parts)
    }

    fn angle_of(&mut self, angle: &Formula, scope: Scope) -> Result<Expr, Box<Mistake>> {
        let wanted = Wanted::new(Dimension::ONE, "an angle").of(Uses::PLACE);
        let by = normal_form(&self.formula(angle, scope, &wanted)?.expr);
        self.without_orientations(&by, angle.span())?;
        without_states(by, angle.span())
    }

    /// Returns the unit vector of an axis, and the angle or length of a motion about or along it.
    fn axis(
        &mut self,
        spec: &AxisSpec,
        scope: Scope,
        dimension: Dimension,
    ) -> Result<(Vector, Expr), Box<Mistake>> {
        let what = if dimension == Dimension::ONE { "an angle" } else { "a displacement" };
        let wanted = Wanted::new(dimension, what).of(Uses::PLACE);
        let by = normal_form(&self.formula(&spec.by, scope, &wanted)?.expr);
        self.without_orientations(&by, spec.by.span())?;
        let by = without_states(by, spec.by.span())?;
        let what = "a component of an axis";
        let axis = self.components(&spec.axis, scope, Dimension::ONE, what, Uses::PARAMETERS)?;
        let norm = sum(axis.iter().map(|entry| product([entry.clone(), entry.clone()])));
        if norm.is_zero() {
            let mistake = Mistake::new(
                Code::UndefinedValue,
                spec.span,
                "an axis of length 0 has no direction",
                "zero",
            );
            return Err(Box::new(mistake.help("the axis of z is [0, 0, 1]")));
        }
        let half = Expr::Number(BigRational::new((-1).into(), 2.into()));
        let inverse = normal_form(&Expr::Power(Box::new(norm), Box::new(half)));
        Ok((axis.map(|entry| product([entry, inverse.clone()]).shared()), by))
    }

    /// Rejects a motion that follows a part of an orientation, whose rate is not a velocity.
    fn without_orientations(&self, expr: &Expr, span: Span) -> Result<(), Box<Mistake>> {
        let orientations = self.orientations();
        let is_part = |symbol| matches!(symbol, Symbol::Coordinate(id) if orientations.contain(id));
        if orientations.is_empty() || !expr.mentions(is_part) {
            return Ok(());
        }
        let message = "the motion of a frame depends on a part of an orientation";
        let mistake = Mistake::new(Code::ForbiddenDependence, span, message, "of a quaternion");
        Err(Box::new(mistake.help("turn a frame by `spherical`")))
    }

    pub(super) fn components(
        &mut self,
        spec: &Components,
        scope: Scope,
        dimension: Dimension,
        what: &str,
        allowed: Uses,
    ) -> Result<Vector, Box<Mistake>> {
        let wanted = Wanted::new(dimension, what).of(allowed);
        let mut all = zero();
        for (entry, formula) in all.iter_mut().zip(spec) {
            let expr = normal_form(&self.formula(formula, scope, &wanted)?.expr);
            self.without_orientations(&expr, formula.span())?;
            *entry = without_states(expr, formula.span())?;
        }
        Ok(all)
    }

    pub(super) fn body(&mut self, spec: &BodySpec, scope: Scope) -> Result<Body, Box<Mistake>> {
        let wanted = Wanted::new(Dimension::MASS, "a mass").of(Uses::PARAMETERS);
        let mass = normal_form(&self.formula(&spec.mass, scope, &wanted)?.expr);
        let centre = match &spec.centre {
            Some(centre) => {
                let what = "a centre of mass";
                self.components(centre, scope, Dimension::LENGTH, what, Uses::PARAMETERS)?
            }
            None => zero(),
        };
        let wanted = Wanted::new(Dimension::INERTIA, "an inertia").of(Uses::PARAMETERS);
        let mut entries = [0; 6].map(Expr::integer);
        for (entry, formula) in entries.iter_mut().zip(&spec.inertia) {
            if let Some(formula) = formula {
                *entry = normal_form(&self.formula(formula, scope, &wanted)?.expr).shared();
            }
        }
        self.possible(spec, &mass, &entries)?;
        let [xx, yy, zz, xy, xz, yz] = entries;
        let tensor = [[xx, xy.clone(), xz.clone()], [xy, yy, yz.clone()], [xz, yz, zz]];
        let rotation = self.constant_rotation(&spec.rotations, scope)?;
        Ok(Body { mass: mass.shared(), centre, tensor, rotation })
    }

    /// Rejects a negative mass or moment of inertia, and warns of an inertia that no distribution of
    /// mass has. Files of robots have such inertias, of links that turn about one axis only.
    fn possible(
        &mut self,
        spec: &BodySpec,
        mass: &Expr,
        entries: &[Expr; 6],
    ) -> Result<(), Box<Mistake>> {
        let values = self.values;
        let value = |expr: &Expr| {
            evaluate(expr, &|id| values.get(id.0 as usize).copied().unwrap_or(f64::NAN))
        };
        let refuse = |message: String, label: &str| {
            let mistake = Mistake::new(Code::InvalidInertia, spec.name.span, message, label);
            Err(Box::new(mistake.help(
                "the inertia is about the centre of mass, as products J_xy = \
                                       -sum of m x y",
            )))
        };
        let mass = value(mass);
        if mass < 0.0 {
            return refuse(
                format!("the mass of {} is negative", quoted(&spec.name.value)),
                "below 0",
            );
        }
        let [xx, yy, zz, xy, xz, yz] = entries.each_ref().map(value);
        let name = quoted(&spec.name.value);
        if [xx, yy, zz].iter().any(|entry| *entry < -mass * ROUNDED_GYRATION.powi(2)) {
            return refuse(format!("a moment of inertia of {name} is negative"), "below 0");
        }
        let size = xx.abs().max(yy.abs()).max(zz.abs()).max(xy.abs()).max(xz.abs()).max(yz.abs());
        let rounding = 1e-12 * size;
        let minors = [xx * yy - xy * xy, xx * zz - xz * xz, yy * zz - yz * yz];
        let determinant =
            xx * (yy * zz - yz * yz) - xy * (xy * zz - yz * xz) + xz * (xy * yz - yy * xz);
        let is_negative = minors.iter().any(|minor| *minor < -rounding * size)
            || determinant < -rounding * size * size;
        // J_xx + J_yy - J_zz is the second moment of mass along z, times 2.
        let trace = xx + yy + zz;
        let is_unequal = [xx, yy, zz].iter().any(|entry| trace - 2.0 * entry < -1e-9 * size);
        let why = if is_negative {
            "about some axis it is negative"
        } else if is_unequal {
            "one diagonal entry exceeds the sum of the others"
        } else {
            return Ok(());
        };
        let message = format!("no body has the inertia of {name}: {why}");
        let warning = Mistake::new(Code::InvalidInertia, spec.name.span, message, "impossible");
        self.warnings.push(warning.help("check its entries and their unit, kg m^2"));
        Ok(())
    }
}

/// Rejects a motion that follows a first-order state, whose rate may depend on forces.
fn without_states(expr: Expr, span: Span) -> Result<Expr, Box<Mistake>> {
    if !expr.mentions(|symbol| matches!(symbol, Symbol::FirstOrder(_))) {
        return Ok(expr);
    }
    let message = "the motion of a frame depends on a first-order state or mode";
    let mistake = Mistake::new(Code::ForbiddenDependence, span, message, "of a state");
    Err(Box::new(mistake.help("write it with coordinates, time and parameters")))
}

/// Rejects an angle at the start that moves.
fn still(angle: &Expr, span: Span) -> Result<(), Box<Mistake>> {
    if !moves(angle) {
        return Ok(());
    }
    let message = "the rotation at the start depends on a coordinate or time";
    let mistake = Mistake::new(Code::ForbiddenDependence, span, message, "moves");
    Err(Box::new(mistake.help("write it with parameters")))
}

/// Returns the unit quaternion of a rotation by an angle about a unit axis.
fn half_turned(axis: &Vector, angle: &Expr) -> [Expr; 4] {
    let half = Expr::Number(BigRational::new(1.into(), 2.into()));
    let [sine, cosine] = sine_and_cosine(&normal_form(&product([half, angle.clone()])));
    let [x, y, z] = axis.each_ref().map(|entry| product([sine.clone(), entry.clone()]));
    [cosine, x, y, z]
}

fn unit_quaternion(parts: &[Expr; 4]) -> [Expr; 4] {
    let norm = sum(parts.iter().map(|part| product([part.clone(), part.clone()])));
    let half = Expr::Number(BigRational::new((-1).into(), 2.into()));
    let inverse = normal_form(&Expr::Power(Box::new(norm), Box::new(half)));
    parts.each_ref().map(|part| product([part.clone(), inverse.clone()]))
}

/// Returns the product of two quaternions w, x, y, z.
fn hamilton(a: &[Expr; 4], b: &[Expr; 4]) -> [Expr; 4] {
    let part = |terms: [(i64, usize, usize); 4]| {
        sum(terms.map(|(sign, i, j)| product([Expr::integer(sign), a[i].clone(), b[j].clone()])))
    };
    [
        part([(1, 0, 0), (-1, 1, 1), (-1, 2, 2), (-1, 3, 3)]),
        part([(1, 0, 1), (1, 1, 0), (1, 2, 3), (-1, 3, 2)]),
        part([(1, 0, 2), (-1, 1, 3), (1, 2, 0), (1, 3, 1)]),
        part([(1, 0, 3), (1, 1, 2), (-1, 2, 1), (1, 3, 0)]),
    ]
}

fn unit_vector(axis: usize) -> Vector {
    std::array::from_fn(|i| Expr::integer(i64::from(i == axis)))
}

/// Reports whether an expression depends on coordinates or time.
fn moves(expr: &Expr) -> bool {
    !matches!(expr, Expr::Number(_))
        && expr.mentions(|symbol| !matches!(symbol, Symbol::Pi | Symbol::Parameter(_)))
}

fn uses_of(expr: &Expr) -> Uses {
    let mut uses = Uses::default();
    for symbol in expr.symbols() {
        uses.time |= symbol == Symbol::Time;
        uses.position |= matches!(symbol, Symbol::Coordinate(_) | Symbol::FirstOrder(_));
        uses.velocity |= matches!(symbol, Symbol::Velocity(_));
    }
    uses
}

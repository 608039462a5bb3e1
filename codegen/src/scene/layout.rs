//! Layout of a scene: names and their indices, found before any expression is read.

mod find;

use std::cell::RefCell;
use std::collections::{BTreeSet, HashMap};

pub use crate::scene::frame_part::FramePart;
use crate::scene::loops::Cut;
use crate::scene::parameters::numbers;
use crate::scene::system::Required;
use crate::scene::typed::integer;
use crate::spatial::orientation::Orientation;
use crate::spec::code::Code;
use crate::spec::diagnostic::{Mistake, Span, Spanned};
use crate::spec::dimension::Dimension;
use crate::spec::{SceneSpec, UnitSpec, quoted};
use find::check_port;
pub use find::{
    coordinate_spec, find_inside, find_instance, find_port, frame_of_port, unknown_coordinate,
};
use machinist_algebra::expr::{
    ConstraintId, CoordinateId, Expr, FirstOrderId, HandedId, ParameterId,
};
use machinist_contract::field::HANDED;
use machinist_model::Place;

/// Maximum number of named things of all instances together.
const MAX_NAMES: usize = 100_000;

/// Meaning of a name; indices are those of the unit's or the scene's lists.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Local {
    Coordinate(usize),
    Velocity(usize),
    Acceleration(usize),
    Parameter(usize),
    Input(usize),
    State(usize),
    Helper(usize),
    Output(usize),
    /// The multiplier of a constraint.
    Constraint(usize),
    /// The force of dry friction, sliding or sticking.
    Friction(usize),
    /// A field, or its rate.
    Field(usize, FieldPart),
    /// The derivative along the field at a port, before it or after it.
    Slope(usize, Side),
    /// x along the fields.
    Place,
    /// A component of the motion of a frame.
    Frame(usize, FramePart),
    /// The part w of an orientation.
    Scalar(usize),
}

/// Part of a field that a name stands for. The numbers are those of the density's symbols.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FieldPart {
    Value,
    Gradient,
    Rate,
    GradientRate,
}

/// Side of a port: before it, towards x = 0, or after it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Side {
    Before,
    After,
}

/// Scope of the names in an expression.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Scope {
    Scene,
    Instance(usize),
    /// A density of a field: names of its unit, the field and x.
    Density(usize, usize),
    /// The initial values of a field along x: names of the scene, and x.
    Profile,
}

impl Scope {
    /// Returns the scope of an assembly, or else of the scene.
    pub fn within(assembly: Option<usize>) -> Scope {
        assembly.map_or(Scope::Scene, Scope::Instance)
    }

    /// Returns the scope without the names of fields.
    pub fn base(self) -> Scope {
        match self {
            Scope::Density(instance, _) => Scope::Instance(instance),
            Scope::Profile => Scope::Scene,
            other => other,
        }
    }
}

/// A port on a field.
#[derive(Debug, Clone)]
pub struct Attachment {
    pub instance: usize,
    pub field: usize,
    pub port: usize,
    /// x, of parameters.
    pub expr: Expr,
    /// Its value in the spec \[m\].
    pub x: f64,
    pub place: Place,
    /// True if the field is fixed at zero here.
    pub fixed: bool,
}

/// Names of a unit or of the scene, in the order of the spec.
#[derive(Debug, Default)]
pub struct Names {
    order: Vec<String>,
    by_name: HashMap<String, (Local, Span)>,
}

impl Names {
    /// Returns the meaning of a name.
    pub fn get(&self, name: &str) -> Option<Local> {
        self.by_name.get(name).map(|(local, _)| *local)
    }

    /// Iterates over the names, in the order of the spec.
    pub fn iter(&self) -> impl Iterator<Item = &str> {
        self.order.iter().map(String::as_str)
    }

    fn add(&mut self, name: &Spanned<String>, local: Local, mistakes: &mut Vec<Mistake>) {
        if self.by_name.contains_key(&name.value) {
            let message = format!("the name {} is given twice", quoted(&name.value));
            let help = "coordinates, velocities, accelerations, parameters, inputs, states, \
                        helpers, outputs and constraints share their names";
            mistakes.push(
                Mistake::new(Code::DuplicateName, name.span, message, "given again").help(help),
            );
            return;
        }
        self.order.push(name.value.clone());
        self.by_name.insert(name.value.clone(), (local, name.span));
    }
}

/// Relation of a coordinate of an instance to the scene's coordinate that it follows.
#[derive(Debug, Clone)]
pub struct Link {
    pub id: CoordinateId,
    /// `None` for 1.
    pub factor: Option<Expr>,
}

/// Indices of all quantities of a scene.
#[derive(Debug)]
pub struct Layout {
    pub units: Vec<Names>,
    pub scene: Names,
    /// Index of the first coordinate, parameter, state, constraint and orientation of each instance.
    first: Vec<[usize; 5]>,
    /// Ids of the parameters that are numbers, among all parameters of scene and instances.
    parameters: Vec<Option<ParameterId>>,
    /// Numbers of first-order states, and of constraints, of all instances.
    states: usize,
    constraints: usize,
    /// Relation of each coordinate of each instance to one of the scene.
    pub links: Vec<Link>,
    /// For each coordinate of the scene, the one that represents it.
    pub representatives: Vec<usize>,
    /// Ports on fields, in the order of instances, fields and x.
    pub attachments: Vec<Attachment>,
    /// For each coordinate of each instance, its attachment, if any.
    attached: Vec<Option<usize>>,
    /// For each coordinate of each instance, true if it is fixed at zero.
    held: Vec<bool>,
    /// Requirements on ratios, and on lengths and places of fields.
    pub required: Vec<Required>,
    /// Frames that joints make one, each as instance and index, and the place of the joint.
    pub joined_frames: Vec<([(usize, usize); 2], Span)>,
    /// Connections of frames that are cut because they close loops.
    pub cuts: Vec<Cut>,
    /// Slots of coordinates that a cut joint leaves out although something mentions them.
    missed: RefCell<BTreeSet<usize>>,
}

impl Layout {
    /// Returns the indices of a scene before anything is joined.
    pub fn new(spec: &SceneSpec, mistakes: &mut Vec<Mistake>) -> Self {
        let units: Vec<Names> = spec.units.iter().map(|unit| unit_names(unit, mistakes)).collect();
        for (unit, names) in spec.units.iter().zip(&units) {
            unit.ports.iter().for_each(|port| check_port(port, unit, names, mistakes));
        }
        let mut scene = Names::default();
        for (index, parameter) in spec.parameters.iter().enumerate() {
            scene.add(&parameter.name, Local::Parameter(index), mistakes);
        }
        for (index, helper) in spec.helpers.iter().enumerate() {
            scene.add(&helper.name, Local::Helper(index), mistakes);
        }
        for (index, state) in spec.states.iter().enumerate() {
            scene.add(&state.name, Local::State(index), mistakes);
        }
        for (index, constraint) in spec.constraints.iter().enumerate() {
            scene.add(&constraint.name, Local::Constraint(index), mistakes);
        }
        for (index, friction) in spec.frictions.iter().enumerate() {
            scene.add(&friction.force.name, Local::Friction(index), mistakes);
        }
        let mut next = [0, spec.parameters.len(), 0, 0, 0];
        let mut first = Vec::new();
        let mut size = 0;
        for instance in &spec.instances {
            first.push(next);
            let unit = &spec.units[instance.unit];
            next[0] += unit.coordinates.len();
            next[1] += unit.parameters.len();
            next[2] += unit.states.len();
            next[3] += unit.constraints.len();
            next[4] += unit.orientations.len();
            let names = units[instance.unit].order.len();
            if size <= MAX_NAMES && size + names > MAX_NAMES {
                let message = format!("a scene has at most {MAX_NAMES} named things");
                mistakes.push(Mistake::new(
                    Code::TooLarge,
                    instance.name.span,
                    message,
                    "too many from here on",
                ));
            }
            size += names;
        }
        let mut ids = vec![None; next[1]];
        for (id, (scope, index, _)) in (0..).map(ParameterId).zip(numbers(spec)) {
            let first = if let Scope::Instance(instance) = scope { first[instance][1] } else { 0 };
            ids[first + index] = Some(id);
        }
        let slots = next[0];
        let links = (0..slots).map(|slot| Link { id: CoordinateId(slot as u32), factor: None });
        let (links, representatives) = (links.collect(), (0..slots).collect());
        let (attachments, attached) = (Vec::new(), vec![None; slots]);
        let units_of = spec.instances.iter().map(|instance| &spec.units[instance.unit]);
        let held = units_of.flat_map(|unit| &unit.coordinates).map(|one| one.is_fixed).collect();
        Layout {
            units,
            scene,
            first,
            parameters: ids,
            states: next[2],
            constraints: next[3],
            links,
            representatives,
            attachments,
            attached,
            held,
            required: Vec::new(),
            joined_frames: Vec::new(),
            cuts: Vec::new(),
            missed: RefCell::default(),
        }
    }

    /// Reports whether a coordinate is left out because its joint is cut.
    pub fn is_left_out(&self, slot: usize) -> bool {
        self.cuts.iter().any(|cut| cut.slots.contains(&slot))
    }

    /// Returns the slots of coordinates that are left out although something mentions them.
    pub fn missed(&self) -> BTreeSet<usize> {
        self.missed.borrow().clone()
    }

    /// Reports whether an orientation of an instance is part of the scene.
    pub fn has_orientation(&self, instance: usize, index: usize) -> bool {
        let number = self.first[instance][4] + index;
        !self.cuts.iter().any(|cut| cut.orientation == Some(number))
    }

    /// Adds the ports on fields.
    pub fn attach(&mut self, spec: &SceneSpec, attachments: Vec<Attachment>) {
        for (index, attachment) in attachments.iter().enumerate() {
            let unit = spec.instances[attachment.instance].unit;
            let name = &spec.units[unit].ports[attachment.port].coordinate.value;
            if let Some(Local::Coordinate(coordinate)) = self.units[unit].get(name) {
                let slot = self.slot(attachment.instance, coordinate);
                self.attached[slot] = Some(index);
            }
        }
        self.attachments = attachments;
    }

    /// Returns the attachment of a coordinate that is a place on a field.
    pub fn attachment(&self, slot: usize) -> Option<&Attachment> {
        self.attached[slot].map(|index| &self.attachments[index])
    }

    /// Reports whether a coordinate is fixed at zero.
    pub fn is_fixed(&self, slot: usize) -> bool {
        self.is_held(slot) || self.is_fixed_end(slot)
    }

    /// Reports whether a coordinate stands for none of the scene: it is fixed or left out.
    pub fn is_absent(&self, slot: usize) -> bool {
        self.is_fixed(slot) || self.is_left_out(slot)
    }

    /// Reports whether a coordinate is a fixed end of a field.
    fn is_fixed_end(&self, slot: usize) -> bool {
        self.attachment(slot).is_some_and(|attachment| attachment.fixed)
    }

    /// Reports whether a coordinate is fixed by its unit or by the parts it is joined to.
    pub fn is_held(&self, slot: usize) -> bool {
        self.held[slot]
    }

    /// Fixes a coordinate.
    pub fn hold(&mut self, slot: usize) {
        self.held[slot] = true;
    }

    /// Returns the id of a number that a field passes to the machine: inertia of the node, force
    /// on it, slopes before and after it.
    pub fn handed(attachment: usize, which: usize) -> HandedId {
        HandedId((HANDED * attachment + which) as u32)
    }

    /// Returns the attachment of a port.
    pub fn attachment_of(&self, instance: usize, port: usize) -> Option<usize> {
        self.attachments.iter().position(|at| (at.instance, at.port) == (instance, port))
    }

    /// Returns the index of a coordinate of an instance among those of all instances.
    pub fn slot(&self, instance: usize, coordinate: usize) -> usize {
        self.first[instance][0] + coordinate
    }

    /// Returns the id of a parameter; `None` if it is computed from others. Parameters of the
    /// scene come first.
    pub fn parameter(&self, scope: Scope, index: usize) -> Option<ParameterId> {
        let first = match scope.base() {
            Scope::Instance(instance) => self.first[instance][1],
            _ => 0,
        };
        self.parameters[first + index]
    }

    /// Returns the id of a first-order state; those of the scene come last.
    pub fn state(&self, scope: Scope, index: usize) -> FirstOrderId {
        let first = match scope.base() {
            Scope::Instance(instance) => self.first[instance][2],
            _ => self.states,
        };
        FirstOrderId((first + index) as u32)
    }

    /// Returns the index of an orientation of an instance among those of all instances.
    pub fn orientation(&self, instance: usize, index: usize) -> usize {
        let number = self.first[instance][4] + index;
        let left_out = self.cuts.iter().filter_map(|cut| cut.orientation);
        number - left_out.filter(|other| *other < number).count()
    }

    /// Returns the parts of an orientation. The part w is a coordinate without a velocity, after
    /// all others.
    pub fn parts(&self, instance: usize, index: usize, first: usize) -> Orientation {
        let scalar = self.representatives.len() + self.orientation(instance, index);
        let vector = [0, 1, 2].map(|axis| self.link(instance, first + axis).id);
        if !self.has_orientation(instance, index) {
            // Its parts are missed, so that the scene is composed again.
            return Orientation { vector, scalar: vector[0] };
        }
        Orientation { vector, scalar: CoordinateId(scalar as u32) }
    }

    /// Returns the id of a constraint; those of the scene come last.
    pub fn constraint(&self, scope: Scope, index: usize) -> ConstraintId {
        let first = match scope.base() {
            Scope::Instance(instance) => self.first[instance][3],
            _ => self.constraints,
        };
        ConstraintId((first + index) as u32)
    }

    /// Returns the id and the dimension of a constraint that closes a cut, by its name. Their ids
    /// follow those of the scene's constraints.
    pub fn closing(
        &self,
        spec: &SceneSpec,
        instance: usize,
        name: &str,
    ) -> Option<(ConstraintId, Dimension)> {
        let mut id = self.constraints + spec.constraints.len();
        for cut in &self.cuts {
            let (owner, prefix) = cut.name(spec);
            for row in cut.joint.rows() {
                if owner == instance && name == row.name(prefix) {
                    return Some((ConstraintId(id as u32), row.dimension));
                }
                id += 1;
            }
        }
        None
    }

    /// Returns instance and index of a slot.
    pub fn coordinate(&self, slot: usize) -> (usize, usize) {
        let instance = self.first.partition_point(|first| first[0] <= slot).saturating_sub(1);
        (instance, slot - self.first[instance][0])
    }

    /// Returns the relation of a coordinate of an instance to one of the scene.
    pub fn link(&self, instance: usize, coordinate: usize) -> &Link {
        self.link_of(self.slot(instance, coordinate))
    }

    /// Returns the relation of a coordinate to one of the scene, by slot.
    pub fn link_of(&self, slot: usize) -> &Link {
        if self.is_left_out(slot) {
            self.missed.borrow_mut().insert(slot);
        }
        &self.links[slot]
    }

    /// Returns the factor of Q on the scene's coordinate, for Q on an instance's coordinate, by
    /// virtual work.
    pub fn factor(link: &Link) -> Expr {
        link.factor.clone().unwrap_or_else(|| integer(1))
    }
}

fn unit_names(unit: &UnitSpec, mistakes: &mut Vec<Mistake>) -> Names {
    let mut names = Names::default();
    if let Some(field) = unit.fields.first() {
        names.add(
            &Spanned { value: "x".to_owned(), span: field.name.span },
            Local::Place,
            mistakes,
        );
    }
    for (index, field) in unit.fields.iter().enumerate() {
        names.add(&field.name, Local::Field(index, FieldPart::Value), mistakes);
        names.add(&field.gradient, Local::Field(index, FieldPart::Gradient), mistakes);
        names.add(&field.rate, Local::Field(index, FieldPart::Rate), mistakes);
        names.add(&field.gradient_rate, Local::Field(index, FieldPart::GradientRate), mistakes);
        for (number, port) in unit.ports.iter().enumerate() {
            let on = port.attachment.as_ref().is_some_and(|at| at.field.value == field.name.value);
            for (side, word) in [(Side::Before, "before"), (Side::After, "after")] {
                let value = format!("{}_{}_{word}", port.name.value, field.gradient.value);
                let name = Spanned { value, span: port.name.span };
                if on {
                    names.add(&name, Local::Slope(number, side), mistakes);
                }
            }
        }
    }
    for (index, coordinate) in unit.coordinates.iter().enumerate() {
        names.add(&coordinate.name, Local::Coordinate(index), mistakes);
        names.add(&coordinate.velocity, Local::Velocity(index), mistakes);
        names.add(&coordinate.acceleration, Local::Acceleration(index), mistakes);
    }
    for (index, orientation) in unit.orientations.iter().enumerate() {
        names.add(&orientation.scalar(), Local::Scalar(index), mistakes);
    }
    for (index, frame) in unit.frames.iter().enumerate() {
        for (part, end) in FramePart::all() {
            let value = format!("{}_{end}", frame.name.value);
            let name = Spanned { value, span: frame.name.span };
            names.add(&name, Local::Frame(index, part), mistakes);
        }
    }
    for (index, parameter) in unit.parameters.iter().enumerate() {
        names.add(&parameter.name, Local::Parameter(index), mistakes);
    }
    for (index, input) in unit.inputs.iter().enumerate() {
        names.add(&input.name, Local::Input(index), mistakes);
    }
    for (index, state) in unit.states.iter().enumerate() {
        names.add(&state.name, Local::State(index), mistakes);
    }
    for (index, helper) in unit.helpers.iter().enumerate() {
        names.add(&helper.name, Local::Helper(index), mistakes);
    }
    for (index, output) in unit.outputs.iter().enumerate() {
        names.add(&output.name, Local::Output(index), mistakes);
    }
    for (index, constraint) in unit.constraints.iter().enumerate() {
        names.add(&constraint.name, Local::Constraint(index), mistakes);
    }
    for (index, friction) in unit.frictions.iter().enumerate() {
        names.add(&friction.force.name, Local::Friction(index), mistakes);
    }
    names
}

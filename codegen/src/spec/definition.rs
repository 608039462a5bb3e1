//! Definition of a unit, as plain data.

use machinist_model::Direction;

use super::body::{BodySpec, Components, FrameSpec, LoadSpec, OrientationSpec};
use super::diagnostic::{FileId, Spanned};
use super::dimension::{Dimension, Unit};
use super::expression::Ast;
use super::shape::ShapeSpec;
use super::spread::Spread;
use super::{AttachmentSpec, Declared, FieldSpec, Formula, Inside, Symbol, Value};

/// A unit as written.
#[derive(Debug, Clone, PartialEq)]
pub struct UnitSpec {
    /// The name by which it was searched.
    pub name: String,
    /// The file that defines it.
    pub file: FileId,
    /// Title of one line.
    pub title: String,
    /// Description.
    pub doc: String,
    /// Source of the equations.
    pub source: String,
    /// Other words for the part, by which `machinist parts` finds it.
    pub synonyms: Vec<String>,
    /// Its symbol in drawings, if given.
    pub symbol: Option<Symbol>,
    /// Generalized coordinates.
    pub coordinates: Vec<CoordinateSpec>,
    /// Fields, given by their densities.
    pub fields: Vec<FieldSpec>,
    /// Frames in space.
    pub frames: Vec<FrameSpec>,
    /// Orientations, whose parts are coordinates too.
    pub orientations: Vec<OrientationSpec>,
    /// Rigid bodies.
    pub bodies: Vec<BodySpec>,
    /// Shapes of bodies in drawings.
    pub shapes: Vec<ShapeSpec>,
    /// Acceleration of free fall, along the axes of the world.
    pub gravity: Option<Components>,
    /// Ports.
    pub ports: Vec<PortSpec>,
    /// Ports of inner instances that are ports of the unit too.
    pub exposed: Vec<ExposedSpec>,
    /// Connectors, which group several ports.
    pub connectors: Vec<ConnectorSpec>,
    /// Parameters.
    pub parameters: Vec<ParameterSpec>,
    /// Inputs, which the scene binds.
    pub inputs: Vec<InputSpec>,
    /// Named expressions.
    pub helpers: Vec<DefinitionSpec>,
    /// First-order states.
    pub states: Vec<StateSpec>,
    /// Events.
    pub events: Vec<EventSpec>,
    /// Constraints.
    pub constraints: Vec<ConstraintSpec>,
    /// Dry friction.
    pub frictions: Vec<FrictionSpec>,
    /// T, V, D and the energy of the first-order states.
    pub energy: EnergySpec,
    /// Power of the first-order states.
    pub power: PowerSpec,
    /// Generalized forces.
    pub forces: Vec<ForceSpec>,
    /// Forces and torques at frames.
    pub loads: Vec<LoadSpec>,
    /// Outputs that scenes may use.
    pub outputs: Vec<DefinitionSpec>,
    /// Parts of an assembly, and initial values, also of the unit's own states.
    pub inside: Inside,
}

impl UnitSpec {
    /// Reports whether it is made of other units.
    #[must_use]
    pub fn is_assembly(&self) -> bool {
        !self.inside.instances.is_empty()
    }
}

/// A generalized coordinate.
#[derive(Debug, Clone, PartialEq)]
pub struct CoordinateSpec {
    /// Its name.
    pub name: Spanned<String>,
    /// Name of the velocity.
    pub velocity: Spanned<String>,
    /// Name of the acceleration.
    pub acceleration: Spanned<String>,
    /// Unit of the coordinate.
    pub unit: Declared,
    /// The orientation in [`UnitSpec::orientations`] that it is a part of. Its velocity is then a
    /// rate of rotation, not that of the coordinate.
    pub orientation: Option<usize>,
    /// Meaning.
    pub doc: String,
    /// Typical sizes of coordinate and velocity.
    pub scale: [f64; 2],
    /// True if it is fixed at zero, with everything that is joined to it.
    pub is_fixed: bool,
}

impl CoordinateSpec {
    /// Returns the unit of the velocity or, for order 2, the acceleration, as text and checked;
    /// `None` if it has no dimension in SI units.
    #[must_use]
    pub fn unit_of_rate(&self, order: i32) -> Option<(String, Unit)> {
        let per = if order == 1 { "/s".to_owned() } else { format!("/s^{order}") };
        if self.orientation.is_some() {
            let unit = Unit { dimension: Dimension::ONE, rad: 2 }.per_second(order)?;
            return Some((format!("rad{per}"), unit));
        }
        Some((format!("{}{per}", self.unit.text.trim()), self.unit.unit.per_second(order)?))
    }
}

/// A port, to which joints connect.
#[derive(Debug, Clone, PartialEq)]
pub struct PortSpec {
    /// Its name.
    pub name: Spanned<String>,
    /// Kind.
    pub kind: Spanned<PortKind>,
    /// The coordinate it moves with; for a port on a field, one of the port's name. For a frame, that
    /// frame's name.
    pub coordinate: Spanned<String>,
    /// Displacement of the port per displacement of the coordinate; `None` for 1.
    pub ratio: Option<Formula>,
    /// Place on a field, for a port on one.
    pub attachment: Option<AttachmentSpec>,
}

/// A port of an inner instance that is a port of the assembly.
#[derive(Debug, Clone, PartialEq)]
pub struct ExposedSpec {
    /// Its name in the assembly.
    pub name: Spanned<String>,
    /// `part.port`, or a connector.
    pub of: Spanned<String>,
}

/// Several ports that joints connect together, such as a point of a plane or an electrical phase.
#[derive(Debug, Clone, PartialEq)]
pub struct ConnectorSpec {
    /// Its name.
    pub name: Spanned<String>,
    /// Ports of the unit, in the order in which joints pair them.
    pub ports: Vec<Spanned<String>>,
}

/// Kind of a port, given by its coordinate.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PortKind {
    /// An angle.
    Rotational,
    /// A length.
    Translational,
    /// A charge or a flux linkage.
    Electrical,
    /// A frame in space, without a coordinate.
    Frame,
}

impl PortKind {
    /// All kinds by name.
    pub const ALL: [(&'static str, PortKind); 4] = [
        ("rotational", PortKind::Rotational),
        ("translational", PortKind::Translational),
        ("electrical", PortKind::Electrical),
        ("frame", PortKind::Frame),
    ];

    /// Returns the name in specs.
    #[must_use]
    pub fn name(self) -> &'static str {
        Self::ALL[self as usize].0
    }
}

/// A parameter with its value.
#[derive(Debug, Clone, PartialEq)]
pub struct ParameterSpec {
    /// Its name.
    pub name: Spanned<String>,
    /// Its value.
    pub value: Value,
    /// Its unit. Models contain the value in the coherent unit.
    pub unit: Declared,
    /// Meaning.
    pub doc: String,
    /// Its distribution, if it has one.
    pub spread: Option<Spanned<Spread>>,
}

/// A signal that the scene binds.
#[derive(Debug, Clone, PartialEq)]
pub struct InputSpec {
    /// Its name.
    pub name: Spanned<String>,
    /// Its unit.
    pub unit: Declared,
    /// Meaning.
    pub doc: String,
}

/// A named expression: a helper or an output.
#[derive(Debug, Clone, PartialEq)]
pub struct DefinitionSpec {
    /// Its name.
    pub name: Spanned<String>,
    /// The expression.
    pub expression: Ast,
    /// Its unit.
    pub unit: Declared,
    /// Meaning.
    pub doc: String,
}

/// A first-order state, or a mode: a whole number that only events change.
#[derive(Debug, Clone, PartialEq)]
pub struct StateSpec {
    /// Its name.
    pub name: Spanned<String>,
    /// Its unit.
    pub unit: Declared,
    /// Meaning.
    pub doc: String,
    /// Its rate; 0 for a mode.
    pub rate: Ast,
    /// True for a mode.
    pub is_mode: bool,
    /// Its initial value; 0 if absent.
    pub initial: Option<Formula>,
    /// Typical size.
    pub scale: f64,
}

/// An event, triggered by the zero crossing of an expression.
#[derive(Debug, Clone, PartialEq)]
pub struct EventSpec {
    /// Its name.
    pub name: Spanned<String>,
    /// The guard, an expression of any dimension.
    pub guard: Ast,
    /// Direction of the zero crossing.
    pub direction: Direction,
    /// Modes and the values they must have for the event to happen.
    pub when: Vec<(Spanned<String>, i32)>,
    /// Coordinates, velocities, states and modes with their new values.
    pub set: Vec<(Spanned<String>, Formula)>,
    /// Meaning.
    pub doc: String,
}

/// A constraint on coordinates.
#[derive(Debug, Clone, PartialEq)]
pub struct ConstraintSpec {
    /// Its name, also that of its multiplier.
    pub name: Spanned<String>,
    /// The expression that is to be zero, of any dimension.
    pub expression: Ast,
    /// Modes and the values they must have for the constraint to hold.
    pub when: Vec<(Spanned<String>, i32)>,
    /// Meaning.
    pub doc: String,
    /// The friction whose sticking it describes, if any.
    pub friction: Option<Spanned<String>>,
}

/// Dry friction: the data that its mode, constraint, helpers and events do not contain.
#[derive(Debug, Clone, PartialEq)]
pub struct FrictionSpec {
    /// Sliding speed s, linear in velocities.
    pub speed: Ast,
    /// Force F while sliding, else 0: Q_j = F ds/dq'_j.
    pub slide: Ast,
    /// The total force, including that of the constraint while sticking, under its name.
    pub force: DefinitionSpec,
    /// Magnitudes as written, each with the case for which it is.
    pub limits: Vec<(String, Ast)>,
    /// Names of the helpers and events that follow from it.
    pub parts: Vec<String>,
    /// Names of the events by which it sets in and ends as its magnitude changes.
    pub openings: Openings,
}

/// Events of friction whose magnitude may vanish.
#[derive(Debug, Clone, PartialEq)]
pub struct Openings {
    /// Friction sets in.
    pub closes: String,
    /// Friction ends.
    pub opens: Vec<String>,
}

/// Energies of a unit.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct EnergySpec {
    /// T.
    pub kinetic: Option<Ast>,
    /// V.
    pub potential: Option<Ast>,
    /// D.
    pub dissipation: Option<Ast>,
    /// Energy of the first-order states.
    pub stored: Option<Ast>,
}

/// Power of the first-order states.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct PowerSpec {
    /// Power supplied to them.
    pub supplied: Option<Ast>,
    /// Power lost by them.
    pub dissipated: Option<Ast>,
}

/// Target of a force.
#[derive(Debug, Clone, PartialEq)]
pub enum Acts {
    /// A coordinate of a unit, or a port of a scene by `instance.port`.
    On(Spanned<String>),
    /// A length or an angle. Q of each coordinate is the force times the derivative of this
    /// expression by the coordinate.
    Along(Ast),
}

/// A generalized force of a unit.
#[derive(Debug, Clone, PartialEq)]
pub struct ForceSpec {
    /// The coordinate it acts on, or the expression along which it does work.
    pub acts: Acts,
    /// Q.
    pub expression: Ast,
    /// True if it only converts energy of the first-order states.
    pub conversion: bool,
    /// Meaning.
    pub doc: String,
}

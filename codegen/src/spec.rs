//! Reading of spec text into a tree of plain data with source spans.
//!
//! Excluded: meanings. Resolving names, comparing dimensions and following joints is left to
//! [`crate::scene`].

mod array;
pub mod body;
pub mod card;
mod check;
mod connect;
mod constraint;
pub mod diagnostic;
pub mod dimension;
mod distributed;
mod event;
pub mod expression;
mod fields;
pub(crate) mod friction;
mod inside;
mod lexer;
pub mod library;
mod loader;
pub mod measure;
mod names;
mod opened;
pub mod rewrite;
mod scatter;
mod scene;
pub mod schema;
pub mod shape;
mod source;
pub mod spread;
pub(crate) mod stack;
mod symbol;
mod table;
mod toml;
mod unit;

use std::path::Path;

pub use self::check::{CheckSpec, ReferenceSpec};
pub use self::connect::names_of as port_names;
pub use self::distributed::{
    AttachmentSpec, Boundary, DiscretisationSpec, FieldSpec, MAX_ELEMENTS, MAX_ORDER,
};
pub use self::inside::{Inside, InstanceText};
pub use self::names::{FUNCTIONS, did_you_mean, quoted, scene_name_mistake};
pub use self::scatter::CorrelationSpec;
pub use self::scene::METHODS;
pub use self::source::{MAX_FILE_BYTES, SourceFile, SourceText, Sources, one_line};
pub use self::symbol::Symbol;
pub use self::table::{Column, CsvTable};

use self::body::{BodySpec, Components, FrameSpec, LoadSpec, OrientationSpec};
use self::diagnostic::{Diagnostic, Diagnostics, FileId, Span, Spanned};
use self::dimension::{Dimension, Unit};
use self::expression::{Ast, Literal};
use self::library::LibraryScene;
use self::measure::Factor;
use self::shape::ShapeSpec;
use self::spread::Spread;
use machinist_model::Direction;

/// Reads a scene, the units it names, and the tables they name.
///
/// A unit is searched in `[define.NAME]` of the scene, as `NAME.toml` beside it, as
/// `../units/NAME.toml`, and among the units that come with Machinist.
///
/// # Errors
/// All mistakes that the text alone shows: files that are missing, too long or not TOML, unknown
/// keys, wrong types, invalid names, expressions that do not parse, tables that are not sorted.
pub fn load_scene(path: &Path) -> Result<SceneSpec, Diagnostics> {
    stack::with_room(|| loader::load(path)).map_err(|_| Diagnostic::no_thread())?
}

/// Reads a scene that comes with Machinist. No file is opened.
///
/// # Errors
/// As [`load_scene`]; the scenes of the library have no mistakes.
pub fn load_library_scene(scene: &LibraryScene) -> Result<SceneSpec, Diagnostics> {
    stack::with_room(|| loader::load_library(scene)).map_err(|_| Diagnostic::no_thread())?
}

/// A scene as written, with everything it refers to.
#[derive(Debug, Clone, PartialEq)]
pub struct SceneSpec {
    /// All files read.
    pub sources: Sources,
    /// The scene's name.
    pub name: Spanned<String>,
    /// Title of one line.
    pub title: String,
    /// Description of the machine.
    pub doc: String,
    /// Source of the equations.
    pub source: String,
    /// The units in use, in the order of their first mention.
    pub units: Vec<UnitSpec>,
    /// Instances of units, each followed by the instances inside it.
    pub instances: Vec<InstanceSpec>,
    /// Joints between ports. A joint of connectors is one joint for each pair of ports.
    pub joints: Vec<JointSpec>,
    /// The scene's own parameters.
    pub parameters: Vec<ParameterSpec>,
    /// Distributions of parameters, by `instance.parameter`.
    pub scatter: Vec<(Spanned<String>, Spanned<Spread>)>,
    /// Correlations of parameters.
    pub correlations: Vec<CorrelationSpec>,
    /// The scene's own helpers.
    pub helpers: Vec<DefinitionSpec>,
    /// The scene's own first-order states and modes.
    pub states: Vec<StateSpec>,
    /// T, V and D between instances, and energy of the scene's states.
    pub energy: EnergySpec,
    /// Power of the scene's states.
    pub power: PowerSpec,
    /// Generalized forces on ports.
    pub forces: Vec<PortForceSpec>,
    /// Events of the scene, for `instance.name`.
    pub events: Vec<EventSpec>,
    /// Constraints of the scene, for `instance.name`.
    pub constraints: Vec<ConstraintSpec>,
    /// Dry friction of the scene, for `instance.name`.
    pub frictions: Vec<FrictionSpec>,
    /// Initial values, by `instance.name`.
    pub initial: Vec<(Spanned<String>, Formula)>,
    /// True if runs start in the equilibrium near the initial values.
    pub starts_in_equilibrium: bool,
    /// Guesses of the initial values that the constraints determine, by `instance.name`.
    pub guess: Vec<(Spanned<String>, Formula)>,
    /// Wanted outputs.
    pub outputs: Vec<OutputSpec>,
    /// Checks of the run against references.
    pub checks: Vec<CheckSpec>,
    /// Parameters that runs may change; all, if not given.
    pub tunable: Option<Vec<Spanned<String>>>,
    /// Instances that are approximated as rigid.
    pub rigid: Vec<Spanned<String>>,
    /// Largest relative error of an output that this approximation may cause.
    pub freeze_tolerance: f64,
    /// Settings of the run.
    pub run: RunSpec,
    /// Tables read from CSV files.
    pub tables: Vec<CsvTable>,
}

/// A declared unit of measure.
#[derive(Debug, Clone, PartialEq)]
pub struct Declared {
    /// The unit of measure of the values, as written.
    pub text: String,
    /// Dimension and exponent of rad.
    pub unit: Unit,
    /// Conversion factor to the coherent unit.
    pub factor: Factor,
    /// Source span.
    pub span: Span,
}

/// An expression, or a bare number in the unit of its quantity.
#[derive(Debug, Clone, PartialEq)]
pub enum Formula {
    /// A number.
    Number(Spanned<Literal>),
    /// An expression.
    Expression(Ast),
}

/// A parameter's value.
#[derive(Debug, Clone, PartialEq)]
pub enum Value {
    /// A finite number, in the declared unit of the parameter.
    Number(f64),
    /// An expression of parameters, in SI units.
    Expression(Ast),
}

impl Formula {
    /// Returns the source span.
    #[must_use]
    pub fn span(&self) -> Span {
        match self {
            Formula::Number(number) => number.span,
            Formula::Expression(ast) => ast.span,
        }
    }
}

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

/// An instance of a unit.
#[derive(Debug, Clone, PartialEq)]
pub struct InstanceSpec {
    /// Its name, preceded by that of its assembly: `gearbox.gear`.
    pub name: Spanned<String>,
    /// The assembly that contains it and whose names its values refer to; an earlier one of
    /// [`SceneSpec::instances`].
    pub parent: Option<usize>,
    /// Index in [`SceneSpec::units`].
    pub unit: usize,
    /// Values that replace the unit's, also for inner instances: `gear.ratio`.
    pub parameters: Vec<(Spanned<String>, Value)>,
    /// Tolerances of these values.
    pub tolerances: Vec<(Spanned<String>, Spanned<Spread>)>,
    /// Expressions for the inputs.
    pub inputs: Vec<(Spanned<String>, Formula)>,
    /// Division of its fields into elements.
    pub fields: Vec<DiscretisationSpec>,
}

/// Two ports joined with a ratio: the first follows the second.
#[derive(Debug, Clone, PartialEq)]
pub struct JointSpec {
    /// The two ports, each as `instance.port`.
    pub connect: [Spanned<String>; 2],
    /// Ratio, 1 if absent.
    pub ratio: Option<Formula>,
    /// The assembly in [`SceneSpec::instances`] that contains it, if any.
    pub within: Option<usize>,
}

/// A generalized force of the scene.
#[derive(Debug, Clone, PartialEq)]
pub struct PortForceSpec {
    /// The port it acts on, or the expression along which it does work.
    pub acts: Acts,
    /// Q.
    pub expression: Ast,
    /// Meaning.
    pub doc: String,
}

/// A wanted output.
#[derive(Debug, Clone, PartialEq)]
pub enum OutputSpec {
    /// A quantity of an instance under another name.
    Alias {
        /// The output's name.
        name: Spanned<String>,
        /// The quantity.
        of: Ast,
    },
    /// An expression.
    Definition(DefinitionSpec),
}

impl OutputSpec {
    /// Returns the output's name.
    #[must_use]
    pub fn name(&self) -> &Spanned<String> {
        match self {
            OutputSpec::Alias { name, .. } => name,
            OutputSpec::Definition(definition) => &definition.name,
        }
    }
}

/// Output times of a run.
#[derive(Debug, Clone, PartialEq)]
pub enum SamplingSpec {
    /// This number of times, equally spaced, both ends included.
    Even(usize),
    /// This number of times, including the start. The time since the start grows by a constant
    /// ratio, beginning with the given time.
    Ratios(usize, Formula),
    /// The given times.
    Listed(Vec<Formula>),
}

/// Settings of a scene's run, checked for their ranges.
#[derive(Debug, Clone, PartialEq)]
pub struct RunSpec {
    /// Start time \[s\], of parameters; 0 if not given.
    pub from: Option<Formula>,
    /// End time \[s\], likewise; for a list of output times, the last of them.
    pub until: Option<Formula>,
    /// Output times.
    pub sampling: SamplingSpec,
    /// Relative tolerance.
    pub rtol: f64,
    /// One of [`crate::spec::METHODS`].
    pub method: String,
}

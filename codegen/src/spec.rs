//! Spec text to a tree of plain data in which every part knows its place.
//!
//! Excluded: meanings. Names are not looked up, dimensions not compared, joints
//! not followed; [`crate::scene`] does that.

mod array;
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
mod friction;
mod inside;
mod lexer;
pub mod library;
mod loader;
pub mod measure;
mod names;
pub mod rewrite;
mod scene;
pub mod schema;
mod source;
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
pub use self::scene::METHODS;
pub use self::source::{MAX_FILE_BYTES, SourceFile, SourceText, Sources, one_line};
pub use self::symbol::Symbol;
pub use self::table::{Column, CsvTable};

use self::diagnostic::{Diagnostic, Diagnostics, FileId, Span, Spanned};
use self::dimension::Unit;
use self::expression::{Ast, Literal};
use self::library::LibraryScene;
use self::measure::Factor;
use machinist_model::Direction;

/// Reads a scene, the units it names, and the tables they name.
///
/// A unit is looked for in `[define.NAME]` of the scene, as `NAME.toml` beside it,
/// as `../units/NAME.toml`, and among the units that come with Machinist.
///
/// # Errors
/// Everything that can be told from the text alone: files that are missing, too
/// long or no TOML, unknown keys, wrong types, names that are none, expressions
/// that do not parse, tables that are not sorted.
pub fn load_scene(path: &Path) -> Result<SceneSpec, Diagnostics> {
    stack::with_room(|| loader::load(path)).map_err(|_| Diagnostic::no_thread())?
}

/// Reads a scene that comes with Machinist; no file is opened.
///
/// # Errors
/// As [`load_scene`]; nothing is wrong with the scenes of the library.
pub fn load_library_scene(scene: &LibraryScene) -> Result<SceneSpec, Diagnostics> {
    stack::with_room(|| loader::load_library(scene)).map_err(|_| Diagnostic::no_thread())?
}

/// A scene as written, with everything it refers to.
#[derive(Debug, Clone, PartialEq)]
pub struct SceneSpec {
    /// Every file read.
    pub sources: Sources,
    /// The scene's name.
    pub name: Spanned<String>,
    /// One line for people.
    pub title: String,
    /// What the machine is.
    pub doc: String,
    /// Where the equations come from.
    pub source: String,
    /// The units in use, in the order first named.
    pub units: Vec<UnitSpec>,
    /// Instances of units, each followed by what is inside it.
    pub instances: Vec<InstanceSpec>,
    /// Joints between ports; those of connectors are one for each of their ports.
    pub joints: Vec<JointSpec>,
    /// The scene's own parameters.
    pub parameters: Vec<ParameterSpec>,
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
    /// Events of the scene, on `instance.name`.
    pub events: Vec<EventSpec>,
    /// Constraints of the scene, of `instance.name`.
    pub constraints: Vec<ConstraintSpec>,
    /// Dry friction of the scene, of `instance.name`.
    pub frictions: Vec<FrictionSpec>,
    /// Initial values, by `instance.name`.
    pub initial: Vec<(Spanned<String>, Formula)>,
    /// Whether runs start in the equilibrium near these.
    pub starts_in_equilibrium: bool,
    /// Initial values from which those that the constraints give are looked for,
    /// likewise.
    pub guess: Vec<(Spanned<String>, Formula)>,
    /// Wanted outputs.
    pub outputs: Vec<OutputSpec>,
    /// What the run is held against.
    pub checks: Vec<CheckSpec>,
    /// Parameters that runs may change; all, if not given.
    pub tunable: Option<Vec<Spanned<String>>>,
    /// Instances to be taken for rigid.
    pub rigid: Vec<Spanned<String>>,
    /// Largest relative error of an output allowed for it.
    pub freeze_tolerance: f64,
    /// The run asked for.
    pub run: RunSpec,
    /// Tables read from CSV files.
    pub tables: Vec<CsvTable>,
}

/// A declared unit of measure.
#[derive(Debug, Clone, PartialEq)]
pub struct Declared {
    /// The unit that values are in, as written.
    pub text: String,
    /// Its meaning.
    pub unit: Unit,
    /// How much of the coherent unit it is.
    pub factor: Factor,
    /// Where it stands.
    pub span: Span,
}

/// An expression, or a bare number in the unit of what it is for.
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
    /// A finite number, in the unit that the parameter is declared in.
    Number(f64),
    /// An expression of parameters, in SI units.
    Expression(Ast),
}

impl Formula {
    /// Where it stands.
    #[must_use]
    pub fn span(&self) -> Span {
        match self {
            Formula::Number(number) => number.span,
            Formula::Expression(ast) => ast.span,
        }
    }
}

/// A part of a machine as written.
#[derive(Debug, Clone, PartialEq)]
pub struct UnitSpec {
    /// The name it was looked for by.
    pub name: String,
    /// The file it stands in.
    pub file: FileId,
    /// One line for people.
    pub title: String,
    /// What it is.
    pub doc: String,
    /// Where the equations come from.
    pub source: String,
    /// What it is drawn as, if it says so.
    pub symbol: Option<Symbol>,
    /// Generalized coordinates.
    pub coordinates: Vec<CoordinateSpec>,
    /// Fields, by their densities.
    pub fields: Vec<FieldSpec>,
    /// What joints take hold of.
    pub ports: Vec<PortSpec>,
    /// Ports of what is inside that are ports of the unit too.
    pub exposed: Vec<ExposedSpec>,
    /// Several ports that joints take hold of together.
    pub connectors: Vec<ConnectorSpec>,
    /// Parameters.
    pub parameters: Vec<ParameterSpec>,
    /// Signals that the scene binds.
    pub inputs: Vec<InputSpec>,
    /// Named expressions.
    pub helpers: Vec<DefinitionSpec>,
    /// First-order states.
    pub states: Vec<StateSpec>,
    /// What happens where an expression passes zero.
    pub events: Vec<EventSpec>,
    /// What coordinates must fulfil.
    pub constraints: Vec<ConstraintSpec>,
    /// Dry friction.
    pub frictions: Vec<FrictionSpec>,
    /// T, V, D and the energy of the first-order states.
    pub energy: EnergySpec,
    /// Power of the first-order states.
    pub power: PowerSpec,
    /// Generalized forces.
    pub forces: Vec<ForceSpec>,
    /// What it offers to scenes.
    pub outputs: Vec<DefinitionSpec>,
    /// Of an assembly, what it is made of; values at the start of what is its own too.
    pub inside: Inside,
}

impl UnitSpec {
    /// Whether it is made of other units.
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
    /// Name of its velocity.
    pub velocity: Spanned<String>,
    /// Name of its acceleration.
    pub acceleration: Spanned<String>,
    /// Unit of the coordinate.
    pub unit: Declared,
    /// Meaning.
    pub doc: String,
    /// Typical sizes of coordinate and velocity.
    pub scale: [f64; 2],
    /// Whether it is held at zero, with everything that is joined to it.
    pub is_fixed: bool,
}

/// What a joint takes hold of.
#[derive(Debug, Clone, PartialEq)]
pub struct PortSpec {
    /// Its name.
    pub name: Spanned<String>,
    /// What goes through it.
    pub kind: Spanned<PortKind>,
    /// The coordinate it moves with; of a port on a field, one of the port's name.
    pub coordinate: Spanned<String>,
    /// The port moves by so much for one of the coordinate; `None` for 1.
    pub ratio: Option<Formula>,
    /// Where on a field it is, if it is on one.
    pub attachment: Option<AttachmentSpec>,
}

/// A port of what is inside an assembly that is a port of the assembly.
#[derive(Debug, Clone, PartialEq)]
pub struct ExposedSpec {
    /// What the assembly calls it.
    pub name: Spanned<String>,
    /// `part.port`, or a connector.
    pub of: Spanned<String>,
}

/// Several ports that joints take hold of together: a point of a plane, a phase.
#[derive(Debug, Clone, PartialEq)]
pub struct ConnectorSpec {
    /// Its name.
    pub name: Spanned<String>,
    /// The unit's ports that it is, in the order in which joints pair them.
    pub ports: Vec<Spanned<String>>,
}

/// What goes through a port.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PortKind {
    /// An angle.
    Rotational,
    /// A length.
    Translational,
    /// A charge or a flux linkage.
    Electrical,
}

impl PortKind {
    /// The kinds by name.
    pub const ALL: [(&'static str, PortKind); 3] = [
        ("rotational", PortKind::Rotational),
        ("translational", PortKind::Translational),
        ("electrical", PortKind::Electrical),
    ];

    /// The spec's word for it.
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
    /// Its unit; models have it in the coherent one.
    pub unit: Declared,
    /// Meaning.
    pub doc: String,
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
    /// Its rate; that of a mode is 0.
    pub rate: Ast,
    /// Whether it is a mode.
    pub is_mode: bool,
    /// Its initial value, 0 if absent.
    pub initial: Option<Formula>,
    /// Typical size.
    pub scale: f64,
}

/// What happens where an expression passes zero.
#[derive(Debug, Clone, PartialEq)]
pub struct EventSpec {
    /// Its name.
    pub name: Spanned<String>,
    /// The expression, of any dimension.
    pub guard: Ast,
    /// Which way the guard passes zero.
    pub direction: Direction,
    /// Modes with the values that they must have for the event to happen.
    pub when: Vec<(Spanned<String>, i32)>,
    /// Coordinates, velocities, states and modes with their new values.
    pub set: Vec<(Spanned<String>, Formula)>,
    /// Meaning.
    pub doc: String,
}

/// What coordinates must fulfil.
#[derive(Debug, Clone, PartialEq)]
pub struct ConstraintSpec {
    /// Its name, which stands for its multiplier too.
    pub name: Spanned<String>,
    /// What is to be zero, of any dimension.
    pub expression: Ast,
    /// Modes with the values that they must have for it to hold.
    pub when: Vec<(Spanned<String>, i32)>,
    /// Meaning.
    pub doc: String,
    /// The friction that it is of, if it holds while that sticks.
    pub friction: Option<Spanned<String>>,
}

/// Dry friction: what is not said by its mode, constraint, helpers and events.
#[derive(Debug, Clone, PartialEq)]
pub struct FrictionSpec {
    /// How fast it slides, s, linear in velocities.
    pub speed: Ast,
    /// Its force F while it slides, 0 while it does not: Q_j = F ds/dq'_j.
    pub slide: Ast,
    /// All of its force, with that of the constraint while it sticks, under its name.
    pub force: DefinitionSpec,
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
    /// Supplied to them.
    pub supplied: Option<Ast>,
    /// Lost by them.
    pub dissipated: Option<Ast>,
}

/// What a force acts on.
#[derive(Debug, Clone, PartialEq)]
pub enum Acts {
    /// A coordinate of a unit, or a port of a scene by `instance.port`.
    On(Spanned<String>),
    /// A length or an angle: Q of each coordinate is the force times the rate of this by it.
    Along(Ast),
}

/// A generalized force of a unit.
#[derive(Debug, Clone, PartialEq)]
pub struct ForceSpec {
    /// The coordinate it acts on, or what it does work along.
    pub acts: Acts,
    /// Q.
    pub expression: Ast,
    /// Whether it only converts energy of the first-order states.
    pub conversion: bool,
    /// Meaning.
    pub doc: String,
}

/// An instance of a unit.
#[derive(Debug, Clone, PartialEq)]
pub struct InstanceSpec {
    /// Its name, behind that of the assembly that it is inside: `gearbox.gear`.
    pub name: Spanned<String>,
    /// The assembly that it is inside, whose names its values are made of; an earlier one of
    /// [`SceneSpec::instances`].
    pub parent: Option<usize>,
    /// Index in [`SceneSpec::units`].
    pub unit: usize,
    /// Values other than the unit's, also of what is inside it: `gear.ratio`.
    pub parameters: Vec<(Spanned<String>, Value)>,
    /// Expressions for the inputs.
    pub inputs: Vec<(Spanned<String>, Formula)>,
    /// How its fields are cut into elements.
    pub fields: Vec<DiscretisationSpec>,
}

/// Two ports of which the first follows the second by a ratio.
#[derive(Debug, Clone, PartialEq)]
pub struct JointSpec {
    /// `instance.port`, twice.
    pub connect: [Spanned<String>; 2],
    /// Ratio, 1 if absent.
    pub ratio: Option<Formula>,
    /// The assembly in [`SceneSpec::instances`] that it is inside, if it is inside one.
    pub within: Option<usize>,
}

/// A generalized force of the scene.
#[derive(Debug, Clone, PartialEq)]
pub struct PortForceSpec {
    /// The port it acts on, or what it does work along.
    pub acts: Acts,
    /// Q.
    pub expression: Ast,
    /// Meaning.
    pub doc: String,
}

/// A wanted output.
#[derive(Debug, Clone, PartialEq)]
pub enum OutputSpec {
    /// Something of an instance under another name.
    Alias {
        /// The output's name.
        name: Spanned<String>,
        /// What it is.
        of: Ast,
    },
    /// An expression of its own.
    Definition(DefinitionSpec),
}

impl OutputSpec {
    /// The output's name.
    #[must_use]
    pub fn name(&self) -> &Spanned<String> {
        match self {
            OutputSpec::Alias { name, .. } => name,
            OutputSpec::Definition(definition) => &definition.name,
        }
    }
}

/// At which times a run tells what there is.
#[derive(Debug, Clone, PartialEq)]
pub enum SamplingSpec {
    /// So many, equally spaced, both ends included.
    Even(usize),
    /// So many, the start among them; from one to the next, the time since the start grows by one
    /// ratio, from the one given here.
    Ratios(usize, Formula),
    /// These.
    Listed(Vec<Formula>),
}

/// The run a scene asks for, in range.
#[derive(Debug, Clone, PartialEq)]
pub struct RunSpec {
    /// Start time \[s\], of parameters; 0 if not given.
    pub from: Option<Formula>,
    /// End time \[s\], likewise; of a list of output times, the last.
    pub until: Option<Formula>,
    /// Output times.
    pub sampling: SamplingSpec,
    /// Relative tolerance.
    pub rtol: f64,
    /// One of [`crate::spec::METHODS`].
    pub method: String,
}

//! Reading of spec text into a tree of plain data with source spans.
//!
//! Excluded: meanings. Resolving names, comparing dimensions and following joints is left to
//! [`crate::scene`].

mod array;
pub mod body;
pub mod card;
mod check;
pub mod code;
mod connect;
mod constraint;
mod definition;
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

pub use self::body::ROUNDED_GYRATION;
pub use self::check::{CheckSpec, ReferenceSpec};
pub use self::connect::names_of as port_names;
pub use self::definition::{
    Acts, ConnectorSpec, ConstraintSpec, CoordinateSpec, DefinitionSpec, EnergySpec, EventSpec,
    ExposedSpec, ForceSpec, FrictionSpec, InputSpec, Openings, ParameterSpec, PortKind, PortSpec,
    PowerSpec, StateSpec, UnitSpec,
};
pub use self::distributed::{
    AttachmentSpec, Boundary, DiscretisationSpec, FieldSpec, MAX_ELEMENTS, MAX_ORDER,
};
pub use self::inside::{Inside, InstanceText};
pub use self::names::{FUNCTIONS, MAX_NAME, did_you_mean, is_reserved, quoted, scene_name_mistake};
pub use self::scatter::CorrelationSpec;
pub use self::scene::METHODS;
pub use self::source::{MAX_FILE_BYTES, SourceFile, SourceText, Sources, one_line};
pub use self::symbol::Symbol;
pub use self::table::{Column, CsvTable};

use self::diagnostic::{Diagnostic, Diagnostics, Span, Spanned};
use self::dimension::Unit;
use self::expression::{Ast, Literal};
use self::library::LibraryScene;
use self::measure::Factor;
use self::spread::Spread;

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
    /// True if redundant constraints share forces with those from which they follow.
    pub shares_redundant: bool,
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

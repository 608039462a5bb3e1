//! A machine ready to run: one tape for each function.

use machinist_contract::{self as contract, Jumps};
use serde::{Deserialize, Serialize};

use crate::{
    Check, Direction, Drawing, Excitation, FieldModel, Motion, Name, Op, Quantity, Reduction,
    RunDefaults, Solve, SourceFile, Table, Tape,
};

/// Structural nonzeros, sorted by row, then by column.
#[derive(Debug, Clone, PartialEq, Eq, Default, Serialize, Deserialize)]
pub struct SparsityPattern {
    /// Number of rows.
    pub rows: usize,
    /// Number of columns.
    pub columns: usize,
    /// (row, column) of every nonzero.
    pub entries: Vec<(u32, u32)>,
}

impl SparsityPattern {
    /// Returns the pattern as simulators describe it.
    #[must_use]
    pub fn borrowed(&self) -> contract::SparsityPattern<'_> {
        let Self { rows, columns, entries } = self;
        contract::SparsityPattern { rows: *rows, columns: *columns, entries }
    }
}

/// A matrix whose tape gives its structural nonzeros in pattern order, unless some of them are
/// solved for.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct MatrixTape {
    /// Positions of the nonzeros.
    pub pattern: SparsityPattern,
    /// Values of the nonzeros, or the inputs of the solution.
    pub tape: Tape,
    /// Solution for the nonzeros, if some are solved for.
    pub solve: Option<Solve>,
}

impl MatrixTape {
    /// Returns the number of results of the tape.
    #[must_use]
    pub fn inputs(&self) -> usize {
        self.solve.as_ref().map_or(self.pattern.entries.len(), Solve::inputs)
    }
}

/// An event as a simulator describes it; its functions are on tapes.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Event {
    /// Name of the event.
    pub name: Name,
    /// One sentence of meaning; may be empty.
    pub doc: String,
    /// Direction in which the guard passes zero.
    pub direction: Direction,
    /// (entry of the state, value) of the modes in which the guard is watched.
    pub when: Vec<(u32, f64)>,
    /// Entries of the state that the event sets.
    pub sets: Vec<u32>,
}

/// A relation that steps hold, as a simulator describes it. Its comparison is on the tape of guards
/// of kinks; tapes read its slot by [`Op::Held`].
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct Relation {
    /// The way in which it is held.
    #[serde(with = "RelationKindOfFile")]
    pub kind: contract::RelationKind,
    /// Its readers.
    #[serde(with = "readers_of_file")]
    pub readers: Vec<contract::Reader>,
}

#[derive(Serialize, Deserialize)]
#[serde(remote = "contract::RelationKind")]
enum RelationKindOfFile {
    Branch,
    Whole,
    Zone,
}

/// Format of readers in files.
mod readers_of_file {
    use machinist_contract::Reader;
    use serde::{Deserialize, Deserializer, Serialize, Serializer};

    #[derive(Serialize, Deserialize)]
    #[serde(remote = "Reader")]
    enum ReaderOfFile {
        Rate,
        Event(u32),
        Relation(u32),
        Below(u32),
        Above(u32),
    }

    #[derive(Serialize, Deserialize)]
    struct One(#[serde(with = "ReaderOfFile")] Reader);

    pub fn serialize<S: Serializer>(readers: &[Reader], into: S) -> Result<S::Ok, S::Error> {
        into.collect_seq(readers.iter().map(|reader| One(*reader)))
    }

    pub fn deserialize<'a, D: Deserializer<'a>>(from: D) -> Result<Vec<Reader>, D::Error> {
        Ok(Vec::<One>::deserialize(from)?.into_iter().map(|One(reader)| reader).collect())
    }
}

#[derive(Serialize, Deserialize)]
#[serde(remote = "Jumps")]
enum JumpsOfFile {
    Nowhere,
    InTime,
    AtPlaces,
}

/// A constraint as a simulator describes it; its functions are on tapes.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Constraint {
    /// Name of the constraint.
    pub name: Name,
    /// One sentence of meaning; may be empty.
    pub doc: String,
    /// SI unit of the expression that is zero.
    pub unit: String,
    /// True for a constraint on positions, false for one on velocities alone.
    pub is_of_positions: bool,
    /// True if the constraint holds in some modes only.
    pub in_modes: bool,
    /// The mode of the dry friction that sticks by this constraint, as an entry of the state.
    #[serde(default)]
    pub friction: Option<u32>,
    /// Jumps of the speed of its friction.
    #[serde(default, with = "JumpsOfFile")]
    pub jumps: Jumps,
}

/// A generalized coordinate with its velocity, in the state or not.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct Coordinate {
    /// q.
    pub position: Quantity,
    /// q'.
    pub velocity: Quantity,
}

/// Kind of an entry of the state.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub enum StateKind {
    /// A position, or a position relative to another, of a coordinate. Positions beyond the number
    /// of coordinates are the parts w of quaternions: each has the first of the three consecutive
    /// coordinates x, y and z.
    Position(u32),
    /// The velocity of a coordinate; its rate is the acceleration.
    Velocity(u32),
    /// A first-order state z; its rate is h.
    FirstOrder,
    /// A first-order state that is a mode: a whole number, of rate 0, that only events
    /// change.
    Mode,
}

impl StateKind {
    /// Returns the kind as simulators describe it.
    #[must_use]
    pub fn described(self) -> contract::StateKind {
        match self {
            StateKind::Position(_) => contract::StateKind::Position,
            StateKind::Velocity(_) => contract::StateKind::Velocity,
            StateKind::FirstOrder | StateKind::Mode => contract::StateKind::FirstOrder,
        }
    }
}

/// An entry of the state.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct State {
    /// Name, unit and meaning.
    pub quantity: Quantity,
    /// Kind, which determines how the entry changes.
    pub kind: StateKind,
    /// Typical size, for absolute tolerance.
    pub scale: f64,
    /// True if the spec gives the initial value, so that constraints may not change it.
    pub is_given: bool,
}

/// A parameter that runs may set to another value.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Parameter {
    /// Name, unit and meaning.
    pub quantity: Quantity,
    /// Value in SI units.
    pub value: f64,
}

/// A requirement on a value computed from parameters.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct Requirement {
    /// The requirement in words: `the ratio of port \`gear.a\` is a number other than 0`.
    pub rule: String,
    /// Values that fulfil it.
    pub bound: Bound,
}

/// Finite values that fulfil a requirement.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub enum Bound {
    /// All values.
    Finite,
    /// All values but 0.
    NotZero,
    /// Values above 0.
    Positive,
    /// Values of 0 or above.
    NotNegative,
    /// The value 0 only.
    Zero,
}

impl Bound {
    /// Returns whether a value fulfils the bound.
    #[must_use]
    pub fn admits(self, value: f64) -> bool {
        value.is_finite()
            && match self {
                Bound::Finite => true,
                Bound::NotZero => value != 0.0,
                Bound::Positive => value > 0.0,
                Bound::NotNegative => value >= 0.0,
                Bound::Zero => value == 0.0,
            }
    }
}

/// Approximations that the scene requests.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct Freeze {
    /// Instances whose springs are treated as rigid.
    pub rigid: Vec<String>,
    /// Largest error of any output allowed for the approximation, relative to the output's
    /// largest value over the scene's run.
    pub tolerance: f64,
}

/// Everything a simulator offers: names, units, shapes, patterns, and a tape for each
/// function. Lengths of results are those of the contract; the table of functions is
/// [`crate::functions`].
///
/// A model comes from a spec, as a rule. Any program may also make one, such as y' = -y/2:
///
/// ```
/// use machinist_model::{MatrixTape, Model, ModelSimulator, Name, Node, NodeId, Op, Quantity};
/// use machinist_model::{SparsityPattern, State, StateKind, Tape};
///
/// let tape = |ops: &[Op], results: &[u32]| Tape {
///     nodes: ops.iter().map(|op| Node { op: *op, name: None }).collect(),
///     results: results.iter().map(|node| NodeId(*node)).collect(),
/// };
/// let pattern = SparsityPattern { rows: 1, columns: 1, entries: vec![(0, 0)] };
/// let slope = MatrixTape { pattern, tape: tape(&[Op::Literal(-0.5)], &[0]), solve: None };
/// let name = Name { path: "y".into(), ident: "y".into(), latex: "y".into() };
/// let y = Quantity { name, unit: "1".into(), doc: "decays".into() };
/// let zeros = tape(&[Op::Literal(0.0)], &[0, 0, 0]);
/// let decay = Model {
///     name: "decay".into(),
///     states: vec![State { quantity: y, kind: StateKind::FirstOrder, scale: 1.0, is_given: true }],
///     initial_state: tape(&[Op::Literal(3.0)], &[0]),
///     rate: tape(&[Op::State(0), Op::Literal(-0.5), Op::Mul(NodeId(0), NodeId(1))], &[2]),
///     rate_jacobian: slope,
///     time_derivative: tape(&[Op::Literal(0.0)], &[0]),
///     energy: zeros.clone(),
///     power_balance: zeros,
///     ..Model::default()
/// };
///
/// let mut rate = [0.0];
/// ModelSimulator::new(decay).single().rate(0.0, &[3.0], &[], &mut rate);
/// assert_eq!(rate, [-1.5]);
/// ```
///
/// Files of models have a hash, so that a damaged one is refused:
///
/// ```
/// use machinist_model::Model;
/// use machinist_model::file::{FileError, Stamped, read, write};
///
/// let mut bytes = write(&Stamped { generator: "an example".into(), model: Model::default() });
/// *bytes.last_mut().unwrap() ^= 1;
/// assert_eq!(read(&bytes), Err(FileError::Altered));
/// ```
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct Model {
    /// The scene's name, a Rust identifier.
    pub name: String,
    /// One line for readers.
    pub title: String,
    /// Description of the machine, of several lines.
    pub doc: String,
    /// Origin of the equations.
    pub source: String,
    /// Every file of the spec, in the order read.
    pub files: Vec<SourceFile>,
    /// q.
    pub coordinates: Vec<Coordinate>,
    /// The entries of the state, in order.
    pub states: Vec<State>,
    /// Number of states at the end that are only integrated: no rate depends on them, so an
    /// implicit method may leave them out of its iteration.
    pub quadratures: usize,
    /// p.
    pub parameters: Vec<Parameter>,
    /// Values that fields hand to the machine, as parameters behind the parameters;
    /// [`HANDED`](machinist_contract::field::HANDED) for each port on a field.
    pub handed: Vec<Parameter>,
    /// Wanted outputs.
    pub wanted: Vec<Quantity>,
    /// Indices of the wanted outputs that contain accelerations or constraint forces.
    pub at_once: Vec<u32>,
    /// Tables that tapes refer to.
    pub tables: Vec<Table>,
    /// Default settings of the run.
    pub run: RunDefaults,
    /// Approximations.
    pub freeze: Freeze,
    /// Parts of the scene left out by the reduction.
    pub reduction: Reduction,
    /// True if runs start in the equilibrium near the initial state.
    pub starts_in_equilibrium: bool,
    /// `states` results.
    pub initial_state: Tape,
    /// One result for each discontinuity.
    pub discontinuities: Tape,
    /// Computation before the functions that read it, if there is one.
    pub motion: Option<Motion>,
    /// `states` results.
    pub rate: Tape,
    /// dy'/dy.
    pub rate_jacobian: MatrixTape,
    /// dy'/dp.
    pub parameter_jacobian: MatrixTape,
    /// `states` results.
    pub time_derivative: Tape,
    /// M, both triangles.
    pub mass_matrix: MatrixTape,
    /// `coordinates` results.
    pub forcing: Tape,
    /// One result for each wanted output.
    pub outputs: Tape,
    /// Kinetic, potential, stored.
    pub energy: Tape,
    /// Rate of stored energy, power supplied, power dissipated.
    pub power_balance: Tape,
    /// b(t) of linear equations with constant coefficients, without events and constraints.
    pub excitation: Option<Excitation>,
    /// Events at zero crossings of guards.
    pub events: Vec<Event>,
    /// One result for each event.
    pub guards: Tape,
    /// dg/dt along the motion, one result for each event.
    pub guard_rates: Tape,
    /// New values of the entries that events set, event by event.
    pub resets: Tape,
    /// Constraints on the coordinates.
    pub constraints: Vec<Constraint>,
    /// g, one result for each constraint.
    pub constraint_values: Tape,
    /// g', one result for each constraint.
    pub constraint_rates: Tape,
    /// G = dg'/dq'.
    pub constraint_matrix: MatrixTape,
    /// Expressions that pass zero at switching surfaces of the rate, by state or by time.
    pub kink_guards: Tape,
    /// Rates of the `kink_guards` along the motion.
    pub kink_rates: Tape,
    /// Arguments of functions of the rate that saturate, each once.
    pub saturating_arguments: Tape,
    /// The generic element of every field.
    pub fields: Vec<FieldModel>,
    /// Checks on the results of its runs.
    pub checks: Vec<Check>,
    /// Relations that steps hold; their guards come first among those of kinks.
    pub relations: Vec<Relation>,
    /// Requirements on values of parameters.
    pub requirements: Vec<Requirement>,
    /// One result for each requirement, computed from parameters only.
    pub required: Tape,
    /// Drawing in space, if the machine has frames.
    pub drawing: Option<Drawing>,
}

impl Model {
    /// Returns the indices of the slots among the parameters that simulators take.
    #[must_use]
    pub fn slots(&self) -> std::ops::Range<usize> {
        let first = self.parameters.len() + self.handed.len();
        first..first + self.relations.len()
    }

    /// Returns the parameters as simulators take them: the machine's, then those that fields hand
    /// over.
    pub fn all_parameters(&self) -> impl Iterator<Item = &Parameter> + Clone {
        self.parameters.iter().chain(&self.handed)
    }

    /// Returns the number of positions among the entries of the state.
    #[must_use]
    pub fn positions(&self) -> usize {
        let is_position = |state: &&State| matches!(state.kind, StateKind::Position(_));
        self.states.iter().filter(is_position).count()
    }

    /// Returns the number of first-order states, modes included.
    #[must_use]
    pub fn first_order(&self) -> usize {
        let is_first_order =
            |state: &&State| matches!(state.kind, StateKind::FirstOrder | StateKind::Mode);
        self.states.iter().filter(is_first_order).count()
    }

    /// Reports whether the entries of the state are \[q, q', z\], all coordinates in order.
    #[must_use]
    pub fn is_whole(&self) -> bool {
        let n = self.coordinates.len();
        let is_in_place = |(entry, state): (usize, &State)| match state.kind {
            StateKind::Position(id) => {
                id as usize == entry && self.coordinates[entry].position == state.quantity
            }
            StateKind::Velocity(id) => n + id as usize == entry,
            StateKind::FirstOrder | StateKind::Mode => entry >= 2 * n,
        };
        self.positions() == n && self.states.iter().enumerate().all(is_in_place)
    }

    /// Reports whether dy'/dy or the time derivative depends on the forces of fields.
    #[must_use]
    pub fn jacobian_reads_forces(&self) -> bool {
        let attachments = self.fields.iter().flat_map(|field| &field.attachments);
        // The force follows the inertia of the node.
        let forces: Vec<u32> = attachments.map(|at| at.handed + 1).collect();
        let motion = self.motion.as_ref().map(|motion| &motion.tape);
        let tapes = [&self.rate_jacobian.tape, &self.time_derivative];
        tapes
            .into_iter()
            .chain(motion)
            .flat_map(|tape| &tape.nodes)
            .any(|node| matches!(node.op, Op::Handed(number) if forces.contains(&number)))
    }
}

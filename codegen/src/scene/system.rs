//! A composed scene with all names resolved: one Lagrangian system.
//!
//! Excluded: units of the scene as separate things, joints (their coordinates are identified),
//! names to look up, dimensions (they have been checked).

use num_rational::BigRational;

use machinist_algebra::cas::arithmetic;
use machinist_algebra::expr::{
    CoordinateId, Expr, FirstOrderId, Function, HandedId, ParameterId, Symbol,
};
use machinist_contract::Jumps;
use machinist_model::{
    Bound, Direction, ElementKind, Freeze, Name, Place, Quantity, Requirement, RunDefaults, Table,
};

use crate::scene::evaluate;
use crate::spatial::mechanism::Mechanism;
use crate::spatial::orientation::Orientations;
use crate::spec::SourceFile;
use crate::spec::diagnostic::Diagnostic;

/// A generalized coordinate with its velocity.
#[derive(Debug, Clone, PartialEq)]
pub struct Coordinate {
    /// q.
    pub position: Quantity,
    /// q'.
    pub velocity: Quantity,
    /// Names of other port coordinates identified with this one, and the factors by which they
    /// follow it, for documents: (`coupling.input.angle`, factor).
    pub identified: Vec<(String, Expr)>,
    /// Initial position and velocity; of parameters only.
    pub initial: [Expr; 2],
    /// True for position and velocity, respectively, if the spec gives them, so that constraints
    /// may not change them.
    pub is_given: [bool; 2],
    /// Typical sizes of position and velocity, for absolute tolerances.
    pub scale: [f64; 2],
}

/// The part w of a quaternion, a coordinate without a velocity.
#[derive(Debug, Clone, PartialEq)]
pub struct Scalar {
    /// Name, unit and meaning.
    pub quantity: Quantity,
    /// Initial value; of parameters only.
    pub initial: Expr,
    /// True if the spec gives it, so that constraints may not change it.
    pub is_given: bool,
}

/// A first-order state z with z' = rate.
#[derive(Debug, Clone, PartialEq)]
pub struct FirstOrderState {
    /// z.
    pub quantity: Quantity,
    /// h.
    pub rate: Expr,
    /// Initial value; of parameters only.
    pub initial: Expr,
    /// Typical size, for absolute tolerance.
    pub scale: f64,
    /// True for a mode: a whole number, of rate 0, that only events change.
    pub is_mode: bool,
}

/// An event at the zero crossing of a guard.
#[derive(Debug, Clone, PartialEq)]
pub struct Event {
    /// Its name.
    pub name: Name,
    /// One sentence of meaning; may be empty.
    pub doc: String,
    /// The guard.
    pub guard: Expr,
    /// Direction of the zero crossing.
    pub direction: Direction,
    /// Modes and the values they must have for the event to happen.
    pub when: Vec<(FirstOrderId, i32)>,
    /// Coordinates, velocities and first-order states with their new values, which are
    /// expressions of the state before the event.
    pub set: Vec<(Symbol, Expr)>,
}

/// Declared dry friction.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Friction {
    /// Jumps of its speed.
    pub jumps: Jumps,
}

/// A constraint: g(q, t) = 0, or a(q, t) q' + b(q, t) = 0.
#[derive(Debug, Clone, PartialEq)]
pub struct Constraint {
    /// Its name.
    pub name: Name,
    /// One sentence of meaning; may be empty.
    pub doc: String,
    /// SI unit of the expression.
    pub unit: String,
    /// g, or a q' + b.
    pub expr: Expr,
    /// True for g, a constraint on positions.
    pub is_of_positions: bool,
    /// Modes and the values they must have for the constraint to hold; empty if it always holds.
    pub when: Vec<(FirstOrderId, i32)>,
    /// True if the constraint is redundant and the motion is computed without it. Others carry its
    /// force, or share it, unless it is zero in any position.
    pub is_dropped: bool,
    /// The declared friction that holds it, with a limited force.
    pub friction: Option<Friction>,
}

impl Constraint {
    /// Reports whether the constraint holds in all modes.
    #[must_use]
    pub fn holds_always(&self) -> bool {
        self.when.is_empty() && !self.is_dropped
    }

    /// Returns the mode of the friction that holds the constraint.
    #[must_use]
    pub fn friction_mode(&self) -> Option<FirstOrderId> {
        self.friction.and_then(|_| self.when.first()).map(|(mode, _)| *mode)
    }

    /// Returns 1 while the constraint holds, else 0.
    #[must_use]
    pub fn holds(&self) -> Expr {
        if self.is_dropped {
            return Expr::integer(0);
        }
        let half = |doubled: i64| Expr::Number(BigRational::new(doubled.into(), 2.into()));
        self.when.iter().fold(Expr::integer(1), |all, (mode, value)| {
            let less = |bound: i64, then: Expr, otherwise: Expr| {
                let mode = Expr::Symbol(Symbol::FirstOrder(*mode));
                Expr::Call(Function::SelectLess, vec![mode, half(bound), then, otherwise])
            };
            let nearest = 2 * i64::from(*value);
            let not_above = less(nearest + 1, all, Expr::integer(0));
            less(nearest - 1, Expr::integer(0), not_above)
        })
    }
}

/// An element of the drawing in space.
#[derive(Debug, Clone, PartialEq)]
pub struct Drawn {
    /// Kind.
    pub kind: ElementKind,
    /// Path of the frame, body or shape.
    pub name: String,
    /// Its numbers, of coordinates, time and parameters.
    pub numbers: Vec<Expr>,
    /// True for a solid that stands for an inertia.
    pub is_of_inertia: bool,
}

impl Drawn {
    /// Returns an element by its numbers.
    pub fn new(kind: ElementKind, name: String, numbers: impl IntoIterator<Item = Expr>) -> Self {
        Drawn { kind, name, numbers: numbers.into_iter().collect(), is_of_inertia: false }
    }
}

/// A parameter with its value in the spec.
#[derive(Debug, Clone, PartialEq)]
pub struct Parameter {
    /// Name, unit and meaning.
    pub quantity: Quantity,
    /// Its value in SI units.
    pub value: f64,
    /// True if runs may change the value; if not, it becomes a number.
    pub tunable: bool,
}

/// A named expression: a helper of a unit, or an output of the scene.
#[derive(Debug, Clone, PartialEq)]
pub struct Definition {
    /// Name, unit and meaning.
    pub quantity: Quantity,
    /// The expression that the name stands for.
    pub expr: Expr,
}

/// The generalized force on one coordinate.
#[derive(Debug, Clone, PartialEq)]
pub struct GeneralizedForce {
    /// The total force Q.
    pub total: Expr,
    /// The part that only converts energy between the first-order states and the mechanics, such
    /// as a motor's torque. It supplies no energy.
    pub conversion: Expr,
}

/// The potential energy of one instance of a unit.
#[derive(Debug, Clone, PartialEq)]
pub struct Spring {
    /// The instance.
    pub instance: String,
    /// Its contribution to V.
    pub potential: Expr,
}

/// A one-dimensional field u(x, t), given by its densities per length.
///
/// Densities have their own symbols: `Coordinate(0)` is u, `Coordinate(1)` its derivative u_x,
/// `Velocity(0)` and `Velocity(1)` are the rates of both, and `FirstOrder(0)` is x. Parameters
/// and time are those of the scene.
#[derive(Debug, Clone, PartialEq)]
pub struct Field {
    /// u, u_x, u_t, u_xt and x.
    pub quantities: [Quantity; 5],
    /// Typical sizes of u and u_t.
    pub scale: [f64; 2],
    /// T per length; quadratic in u_t.
    pub kinetic: Expr,
    /// V per length.
    pub potential: Expr,
    /// D per length.
    pub dissipation: Expr,
    /// Q per length.
    pub force: Expr,
    /// Initial u and u_t, of x and parameters.
    pub initial: [Expr; 2],
    /// Length; the field extends over 0 <= x <= length.
    pub length: Expr,
    /// Value of the length in the spec \[m\].
    pub length_value: f64,
    /// Places at which the machine is attached to the field, ordered by x.
    pub attachments: Vec<Attachment>,
    /// True for start and end, respectively, if the field is fixed at zero there.
    pub fixed: [bool; 2],
    /// Default number of elements.
    pub elements: usize,
    /// Order of the elements.
    pub order: usize,
}

/// A place on a field whose u is a coordinate of the machine.
///
/// The node is like any other coordinate of the machine. The field computes its inertia and force
/// and passes them as parameters.
#[derive(Debug, Clone, PartialEq)]
pub struct Attachment {
    /// Its name.
    pub name: Name,
    /// The coordinate; `None` where the field is fixed at zero.
    pub coordinate: Option<CoordinateId>,
    /// x, of parameters.
    pub at: Expr,
    /// Location on the field.
    pub place: Place,
    /// x in the spec \[m\].
    pub x: f64,
    /// The first of four numbers that the field passes: inertia of the node, force on it, u_x
    /// before it and after it.
    pub handed: HandedId,
}

/// A check of a run against a reference. It does not take part in the equations: its parameters
/// and tables are its own.
#[derive(Debug, Clone, PartialEq)]
pub struct Check {
    /// Its name.
    pub name: String,
    /// The output or state that is checked.
    pub of: String,
    /// Its unit.
    pub unit: String,
    /// Source of the reference.
    pub source: String,
    /// Tolerance of the error, relative to the largest value of the reference.
    pub tolerance: f64,
    /// Tolerance of the absolute error, in addition to the relative one.
    pub absolute: Option<f64>,
    /// The reference.
    pub reference: Reference,
}

/// Reference of a check.
#[derive(Debug, Clone, PartialEq)]
pub enum Reference {
    /// An expression of time, of `parameters` by their index there, and of `tables`.
    Closed {
        /// The expression as written in the spec.
        text: String,
        /// The expression.
        expr: Expr,
        /// The parameters that it uses.
        parameters: Vec<Parameter>,
        /// The tables of the scene up to the last that it uses.
        tables: Vec<Table>,
    },
    /// Values at increasing times: (time, value).
    Values(Vec<[f64; 2]>),
}

/// A requirement on a value computed from parameters.
#[derive(Debug, Clone, PartialEq)]
pub struct Required {
    /// The value; of parameters only.
    pub expr: Expr,
    /// The requirement, as a bound and in words.
    pub requirement: Requirement,
}

impl Required {
    /// Returns the requirement that a value fulfils a bound, which `rule` describes in words.
    #[must_use]
    pub fn new(expr: &Expr, bound: Bound, rule: impl Into<String>) -> Self {
        Required { expr: expr.clone(), requirement: Requirement { rule: rule.into(), bound } }
    }
}

/// A Lagrangian system: L = T - V, D, Q, and first-order states.
#[derive(Debug, Clone, PartialEq)]
pub struct LagrangianSystem {
    /// The scene's name, a Rust identifier.
    pub name: String,
    /// Title of one line.
    pub title: String,
    /// Description of the machine; several lines.
    pub doc: String,
    /// Source of the equations.
    pub source: String,
    /// True if redundant constraints share forces with those from which they follow.
    pub shares_redundant: bool,
    /// q.
    pub coordinates: Vec<Coordinate>,
    /// z.
    pub first_order: Vec<FirstOrderState>,
    /// p.
    pub parameters: Vec<Parameter>,
    /// Parameters that fields pass to the machine, port by port.
    pub handed: Vec<Parameter>,
    /// T.
    pub kinetic: Expr,
    /// V.
    pub potential: Expr,
    /// Rigid bodies in space, whose energies are not in T and V above.
    pub mechanisms: Vec<Mechanism>,
    /// Elements of the drawing in space.
    pub drawing: Vec<Drawn>,
    /// Quaternions among the coordinates. Other coordinates have their velocities as rates.
    pub orientations: Orientations,
    /// The part w of each of them. Their ids follow those of the coordinates.
    pub scalars: Vec<Scalar>,
    /// V of each instance that has a potential energy.
    pub springs: Vec<Spring>,
    /// D.
    pub dissipation: Expr,
    /// Q of each coordinate.
    pub generalized_force: Vec<GeneralizedForce>,
    /// Energy of the first-order states.
    pub stored_energy: Expr,
    /// Power supplied to the first-order states.
    pub supplied_power: Expr,
    /// Power lost by the first-order states.
    pub dissipated_power: Expr,
    /// Named helper expressions, with inner helpers already substituted. The names are given to
    /// equal subexpressions of the emitted code.
    pub helpers: Vec<Definition>,
    /// Wanted outputs.
    pub outputs: Vec<Definition>,
    /// Checks of runs against references.
    pub checks: Vec<Check>,
    /// Tables that expressions refer to.
    pub tables: Vec<Table>,
    /// Times at which the right-hand side is discontinuous; of parameters only.
    pub discontinuities: Vec<Expr>,
    /// Events.
    pub events: Vec<Event>,
    /// Constraints.
    pub constraints: Vec<Constraint>,
    /// Default settings of the run.
    pub run: RunDefaults,
    /// Approximations of instances as rigid.
    pub freeze: Freeze,
    /// Fields, whose attachments are coordinates of the machine.
    pub fields: Vec<Field>,
    /// True if runs start in the equilibrium near the initial values.
    pub starts_in_equilibrium: bool,
    /// Warnings about the spec.
    pub warnings: Vec<Diagnostic>,
    /// Decisions that the user may want to know: loops that are cut.
    pub notes: Vec<String>,
    /// Requirements on values computed from parameters. Runs with other parameter values are
    /// checked against them too.
    pub requirements: Vec<Required>,
    /// All files read, in the order of reading.
    pub files: Vec<SourceFile>,
}

impl Event {
    /// Iterates over its guard and its new values.
    pub fn exprs(&self) -> impl Iterator<Item = &Expr> {
        std::iter::once(&self.guard).chain(self.set.iter().map(|(_, value)| value))
    }

    /// Iterates over the same, mutably.
    pub fn exprs_mut(&mut self) -> impl Iterator<Item = &mut Expr> {
        std::iter::once(&mut self.guard).chain(self.set.iter_mut().map(|(_, value)| value))
    }
}

impl LagrangianSystem {
    /// Returns the parameter of an id.
    #[must_use]
    pub fn parameter(&self, id: ParameterId) -> &Parameter {
        &self.parameters[id.0 as usize]
    }

    /// Returns T and V, with the energies of rigid bodies.
    #[must_use]
    pub fn energies(&self) -> [Expr; 2] {
        let with = |own: &Expr, of: fn(&Mechanism) -> Expr| {
            arithmetic::sum(std::iter::once(own.clone()).chain(self.mechanisms.iter().map(of)))
        };
        if self.mechanisms.is_empty() {
            return [self.kinetic.clone(), self.potential.clone()];
        }
        [with(&self.kinetic, Mechanism::kinetic), with(&self.potential, Mechanism::potential)]
    }

    /// Evaluates an expression of parameters at their values in the spec. The result is NaN if
    /// the expression depends on anything else.
    #[must_use]
    pub fn value(&self, expr: &Expr) -> f64 {
        evaluate(expr, &|id| self.parameter(id).value)
    }

    /// Drops a redundant constraint, which follows from others as long as the parameters in
    /// `needs` keep their values in the spec.
    pub fn drop_constraint(&mut self, name: &str, needs: &[String]) {
        let found = self.constraints.iter_mut().find(|constraint| constraint.name.path == name);
        let Some(constraint) = found else { return };
        constraint.is_dropped = true;
        for (id, parameter) in (0..).map(ParameterId).zip(&self.parameters) {
            let path = &parameter.quantity.name.path;
            let Some(value) = BigRational::from_float(parameter.value) else { continue };
            if needs.contains(path) {
                let change =
                    Expr::Sum(vec![Expr::Symbol(Symbol::Parameter(id)), Expr::Number(-value)]);
                let rule = format!(
                    "the change of parameter `{path}` is 0, so that constraint `{name}`, which is \
                     dropped, follows from others"
                );
                self.requirements.push(Required::new(&change, Bound::Zero, rule));
            }
        }
    }

    /// Adds a parameter with value 0, named `force on COORDINATE`, and a generalized force of that
    /// size on the coordinate. Linear analysis takes the parameter as an input: effects of the
    /// force on outputs with accelerations and constraint forces are then derivatives like others.
    ///
    /// Returns false if there is no such coordinate.
    pub fn add_test_force(&mut self, coordinate: &str) -> bool {
        let has_name = |one: &Coordinate| one.position.name.path == coordinate;
        let Some(index) = self.coordinates.iter().position(has_name) else { return false };
        let position = &self.coordinates[index].position;
        let unit = match position.unit.as_str() {
            "rad" | "1" => "N m".to_owned(),
            "m" => "N".to_owned(),
            "C" => "V".to_owned(),
            other => format!("J/({other})"),
        };
        let taken =
            |ident: &str| self.parameters.iter().any(|one| one.quantity.name.ident == ident);
        let mut ident = format!("force_on_{}", position.name.ident);
        while taken(&ident) {
            ident.push('_');
        }
        let name = Name {
            path: format!("force on {coordinate}"),
            latex: format!("F_{{{}}}", position.name.latex),
            ident,
        };
        let doc = "test force of a linear analysis".to_owned();
        let force = Symbol::Parameter(ParameterId(self.parameters.len() as u32));
        let quantity = Quantity { name, unit, doc };
        self.parameters.push(Parameter { quantity, value: 0.0, tunable: true });
        let total = &mut self.generalized_force[index].total;
        *total = Expr::Sum(vec![total.clone(), Expr::Symbol(force)]);
        true
    }

    /// Returns an expression without the parameters that the spec sets to zero, such as a mass of
    /// 0.
    #[must_use]
    pub fn given(&self, expr: &Expr) -> Expr {
        without_zeros(expr, |id| self.parameter(id).value)
    }

    /// Returns all expressions of the system.
    pub fn exprs_mut(&mut self) -> Vec<&mut Expr> {
        let mut all = vec![
            &mut self.kinetic,
            &mut self.potential,
            &mut self.dissipation,
            &mut self.stored_energy,
            &mut self.supplied_power,
            &mut self.dissipated_power,
        ];
        for coordinate in &mut self.coordinates {
            all.extend(&mut coordinate.initial);
            all.extend(coordinate.identified.iter_mut().map(|(_, factor)| factor));
        }
        for state in &mut self.first_order {
            all.extend([&mut state.rate, &mut state.initial]);
        }
        for force in &mut self.generalized_force {
            all.extend([&mut force.total, &mut force.conversion]);
        }
        all.extend(self.springs.iter_mut().map(|spring| &mut spring.potential));
        all.extend(self.helpers.iter_mut().map(|helper| &mut helper.expr));
        all.extend(self.outputs.iter_mut().map(|output| &mut output.expr));
        all.extend(&mut self.discontinuities);
        all.extend(self.requirements.iter_mut().map(|required| &mut required.expr));
        all.extend(self.events.iter_mut().flat_map(Event::exprs_mut));
        all.extend(self.constraints.iter_mut().map(|constraint| &mut constraint.expr));
        all.extend(self.drawing.iter_mut().flat_map(|drawn| &mut drawn.numbers));
        all
    }
}

/// Returns an expression with 0 for each parameter whose value is zero.
#[must_use]
pub fn without_zeros(expr: &Expr, value: impl Fn(ParameterId) -> f64) -> Expr {
    expr.replace(&|symbol| match symbol {
        Symbol::Parameter(id) if value(id) == 0.0 => Some(Expr::integer(0)),
        _ => None,
    })
}

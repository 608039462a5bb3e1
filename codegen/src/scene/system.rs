//! A scene composed and resolved: one Lagrangian system.
//!
//! Excluded: units of the scene as separate things, joints (their coordinates
//! are identified), names to look up, dimensions (they have been checked).

use num_rational::BigRational;

use machinist_algebra::expr::{
    CoordinateId, Expr, FirstOrderId, Function, HandedId, ParameterId, Symbol,
};
use machinist_model::{
    Bound, Direction, Freeze, Name, Place, Quantity, Requirement, RunDefaults, Table,
};

use crate::scene::evaluate;
use crate::spec::SourceFile;
use crate::spec::diagnostic::Diagnostic;

/// A generalized coordinate with its velocity.
#[derive(Debug, Clone, PartialEq)]
pub struct Coordinate {
    /// q.
    pub position: Quantity,
    /// q'.
    pub velocity: Quantity,
    /// Names of the other port angles identified with this one, with the factor
    /// by which they follow it, for documents: (`coupling.input.angle`, factor).
    pub identified: Vec<(String, Expr)>,
    /// Initial position and velocity; of parameters only.
    pub initial: [Expr; 2],
    /// Whether the spec gives them, so that constraints may not move them.
    pub is_given: [bool; 2],
    /// Typical sizes of position and velocity, for absolute tolerances.
    pub scale: [f64; 2],
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
    /// Whether it is a mode: a whole number, of rate 0, that only events change.
    pub is_mode: bool,
}

/// What happens where a guard passes zero.
#[derive(Debug, Clone, PartialEq)]
pub struct Event {
    /// What it is called.
    pub name: Name,
    /// One sentence of meaning; may be empty.
    pub doc: String,
    /// The expression that passes zero.
    pub guard: Expr,
    /// Which way.
    pub direction: Direction,
    /// Modes with the values that they must have for it to happen.
    pub when: Vec<(FirstOrderId, i32)>,
    /// Coordinates, velocities and first-order states with their new values, all of
    /// the state before.
    pub set: Vec<(Symbol, Expr)>,
}

/// What coordinates must fulfil: g(q, t) = 0, or a(q, t) q' + b(q, t) = 0.
#[derive(Debug, Clone, PartialEq)]
pub struct Constraint {
    /// What it is called.
    pub name: Name,
    /// One sentence of meaning; may be empty.
    pub doc: String,
    /// SI unit of the expression.
    pub unit: String,
    /// g, or a q' + b.
    pub expr: Expr,
    /// Which of the two.
    pub is_of_positions: bool,
    /// Modes with the values that they must have for it to hold; always, if there are none.
    pub when: Vec<(FirstOrderId, i32)>,
    /// True if it never holds, because it follows from others: these carry its force.
    pub is_dropped: bool,
}

impl Constraint {
    /// True if it holds whatever the modes are.
    #[must_use]
    pub fn holds_always(&self) -> bool {
        self.when.is_empty() && !self.is_dropped
    }

    /// 1 while it holds, else 0.
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

/// A parameter with its value in the spec.
#[derive(Debug, Clone, PartialEq)]
pub struct Parameter {
    /// What it is.
    pub quantity: Quantity,
    /// Its value in SI units.
    pub value: f64,
    /// Whether runs may give it another value; if not, it becomes a number.
    pub tunable: bool,
}

/// A named expression: a helper of a unit, or an output of the scene.
#[derive(Debug, Clone, PartialEq)]
pub struct Definition {
    /// What it is.
    pub quantity: Quantity,
    /// What it stands for.
    pub expr: Expr,
}

/// Generalized force on one coordinate.
#[derive(Debug, Clone, PartialEq)]
pub struct GeneralizedForce {
    /// All of Q.
    pub total: Expr,
    /// The part that only converts energy between the first-order states and the
    /// mechanics (a motor's torque); it supplies nothing.
    pub conversion: Expr,
}

/// The potential energy of one instance of a unit.
#[derive(Debug, Clone, PartialEq)]
pub struct Spring {
    /// The instance.
    pub instance: String,
    /// Its part of V.
    pub potential: Expr,
}

/// A one-dimensional field u(x, t) by its densities a length.
///
/// Densities have symbols of their own: `Coordinate(0)` is u, `Coordinate(1)` its
/// derivative u_x, `Velocity(0)` and `Velocity(1)` are the rates of both, and
/// `FirstOrder(0)` is x. Parameters and time are those of the scene.
#[derive(Debug, Clone, PartialEq)]
pub struct Field {
    /// u, u_x, u_t, u_xt and x.
    pub quantities: [Quantity; 5],
    /// Typical sizes of u and u_t.
    pub scale: [f64; 2],
    /// T a length; quadratic in u_t.
    pub kinetic: Expr,
    /// V a length.
    pub potential: Expr,
    /// D a length.
    pub dissipation: Expr,
    /// Q a length.
    pub force: Expr,
    /// u and u_t at the start, of x and parameters.
    pub initial: [Expr; 2],
    /// The field lies over 0 <= x <= length.
    pub length: Expr,
    /// Its value in the spec \[m\].
    pub length_value: f64,
    /// Places at which the machine takes hold of the field, by x.
    pub attachments: Vec<Attachment>,
    /// Whether the field is held at zero at its start and end.
    pub fixed: [bool; 2],
    /// Elements unless a run says otherwise.
    pub elements: usize,
    /// Order of the elements.
    pub order: usize,
}

/// A place on a field whose u is a coordinate of the machine.
///
/// The machine's part of the node is like any other: it has an inertia and a force,
/// both of which the field computes and hands over as parameters.
#[derive(Debug, Clone, PartialEq)]
pub struct Attachment {
    /// Its name.
    pub name: Name,
    /// The coordinate; none where the field is held at zero.
    pub coordinate: Option<CoordinateId>,
    /// x, of parameters.
    pub at: Expr,
    /// Where that is.
    pub place: Place,
    /// x in the spec \[m\].
    pub x: f64,
    /// The first of four numbers that the field hands over: inertia of the node,
    /// force on it, u_x before it and after it.
    pub handed: HandedId,
}

/// What a run of the scene is held against. It takes no part in the equations: its
/// parameters and tables are its own.
#[derive(Debug, Clone, PartialEq)]
pub struct Check {
    /// Its name.
    pub name: String,
    /// The output or state that is checked.
    pub of: String,
    /// Its unit.
    pub unit: String,
    /// Where the reference is from.
    pub source: String,
    /// Largest error that passes, relative to the largest value of the reference.
    pub tolerance: f64,
    /// Largest error that passes beside that.
    pub absolute: Option<f64>,
    /// What it should be.
    pub reference: Reference,
}

/// What a quantity is held against.
#[derive(Debug, Clone, PartialEq)]
pub enum Reference {
    /// An expression of time, of `parameters` by their place there, and of `tables`.
    Closed {
        /// As the spec writes it.
        text: String,
        /// What it stands for.
        expr: Expr,
        /// Those that it mentions.
        parameters: Vec<Parameter>,
        /// Those of the scene up to the last that it mentions.
        tables: Vec<Table>,
    },
    /// Times, increasing, and values.
    Values(Vec<[f64; 2]>),
}

/// A requirement on a value that is made of parameters.
#[derive(Debug, Clone, PartialEq)]
pub struct Required {
    /// The value; of parameters only.
    pub expr: Expr,
    /// In words, and which values do.
    pub requirement: Requirement,
}

impl Required {
    /// That a value fulfils a bound, for people by `rule`.
    #[must_use]
    pub fn new(expr: &Expr, bound: Bound, rule: impl Into<String>) -> Self {
        Required { expr: expr.clone(), requirement: Requirement { rule: rule.into(), bound } }
    }
}

/// One Lagrangian system: L = T - V, D, Q, and first-order states.
#[derive(Debug, Clone, PartialEq)]
pub struct LagrangianSystem {
    /// The scene's name, a Rust identifier.
    pub name: String,
    /// One line for people.
    pub title: String,
    /// What the machine is; several lines.
    pub doc: String,
    /// Where the equations come from.
    pub source: String,
    /// q.
    pub coordinates: Vec<Coordinate>,
    /// z.
    pub first_order: Vec<FirstOrderState>,
    /// p.
    pub parameters: Vec<Parameter>,
    /// What fields hand to the machine, port by port.
    pub handed: Vec<Parameter>,
    /// T.
    pub kinetic: Expr,
    /// V.
    pub potential: Expr,
    /// V by instances, for those that have one.
    pub springs: Vec<Spring>,
    /// D.
    pub dissipation: Expr,
    /// Q, one for each coordinate.
    pub generalized_force: Vec<GeneralizedForce>,
    /// Energy of the first-order states.
    pub stored_energy: Expr,
    /// Power supplied to the first-order states.
    pub supplied_power: Expr,
    /// Power lost by the first-order states.
    pub dissipated_power: Expr,
    /// Helper expressions by name, helpers within helpers already put in; their
    /// names are given to equal subexpressions of the emitted code.
    pub helpers: Vec<Definition>,
    /// Wanted outputs.
    pub outputs: Vec<Definition>,
    /// What a run is held against.
    pub checks: Vec<Check>,
    /// Tables that expressions refer to.
    pub tables: Vec<Table>,
    /// Times at which the right-hand side jumps; of parameters only.
    pub discontinuities: Vec<Expr>,
    /// What happens where guards pass zero.
    pub events: Vec<Event>,
    /// What coordinates must fulfil.
    pub constraints: Vec<Constraint>,
    /// The run unless told otherwise.
    pub run: RunDefaults,
    /// Approximations wanted.
    pub freeze: Freeze,
    /// Fields, whose places are coordinates of the machine.
    pub fields: Vec<Field>,
    /// Whether runs start in the equilibrium near the initial values.
    pub starts_in_equilibrium: bool,
    /// Warnings about its spec.
    pub warnings: Vec<Diagnostic>,
    /// Requirements on values made of parameters, also at other values than those of the spec.
    pub requirements: Vec<Required>,
    /// Every file read, in the order read.
    pub files: Vec<SourceFile>,
}

impl Event {
    /// Its guard and its new values.
    pub fn exprs(&self) -> impl Iterator<Item = &Expr> {
        std::iter::once(&self.guard).chain(self.set.iter().map(|(_, value)| value))
    }

    /// Likewise.
    pub fn exprs_mut(&mut self) -> impl Iterator<Item = &mut Expr> {
        std::iter::once(&mut self.guard).chain(self.set.iter_mut().map(|(_, value)| value))
    }
}

impl LagrangianSystem {
    /// The parameter of an id.
    #[must_use]
    pub fn parameter(&self, id: ParameterId) -> &Parameter {
        &self.parameters[id.0 as usize]
    }

    /// Value of an expression of parameters at their values in the spec; NaN if it depends
    /// on anything else.
    #[must_use]
    pub fn value(&self, expr: &Expr) -> f64 {
        evaluate(expr, &|id| self.parameter(id).value)
    }

    /// Drops a constraint that follows from others, as long as some parameters are those of the
    /// spec.
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

    /// An expression without the parameters that the spec sets to zero: a mass of 0 is none.
    #[must_use]
    pub fn given(&self, expr: &Expr) -> Expr {
        without_zeros(expr, |id| self.parameter(id).value)
    }

    /// Every expression of the self.
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
        all
    }
}

/// An expression with 0 for each parameter whose value is zero.
#[must_use]
pub fn without_zeros(expr: &Expr, value: impl Fn(ParameterId) -> f64) -> Expr {
    expr.replace(&|symbol| match symbol {
        Symbol::Parameter(id) if value(id) == 0.0 => Some(Expr::integer(0)),
        _ => None,
    })
}

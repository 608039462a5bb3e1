//! Elimination of coordinates without inertia, such as the point between a spring and a damper in
//! series, or a node of a circuit that only resistors join.
//!
//! If T does not depend on q_p', the equation of motion of q_p is a balance of forces,
//!
//! ```text
//! c = dL/dq_p + Q_p - dD/dq_p' = 0
//! ```
//!
//! * If c depends on q_p', and linearly, it gives q_p' = w. The coordinate becomes a first-order
//!   state with the rate w.
//! * If c depends on no velocity, and linearly on q_p, it gives q_p = e, and q_p' = de/dt. The
//!   coordinate is replaced in all energies, and its force acts on the others by virtual work.
//!
//! If T does not depend on a motion n of several coordinates, such as that of both ends of a
//! capacitor, the others move relative to one of them, q_j = u_j + n_j q_p, and T does not depend on
//! q_p'. Motions without dissipation come first: both ends of a damper that hangs on a spring.
//!
//! Both steps keep the account of energy: what D loses at the velocities that are replaced is power
//! dissipated by first-order states.

use std::collections::BTreeSet;

use machinist_algebra::cas::arithmetic::{derivative, normal_form, product, sum};
use machinist_algebra::expr::identity::is_zero;
use machinist_algebra::expr::rank::{Motion, motions_without_energy};
use machinist_algebra::expr::{CoordinateId, Expr, FirstOrderId, Function, ParameterId, Symbol};
use machinist_model::Bound;

use crate::scene::system::{Definition, FirstOrderState, LagrangianSystem, Required};

/// A motion that neither inertia nor a balance of forces determines.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Undetermined {
    /// The coordinates that move, by their index in the scene.
    pub coordinates: Vec<usize>,
    /// The reason why the balance of forces does not determine the motion.
    pub why: Why,
}

/// Reason why the balance of forces does not determine a motion.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Why {
    /// A port that moves is joined to nothing.
    Unjoined,
    /// No force depends on the motion.
    Free,
    /// The forces are not linear in the velocity, or in the position.
    Nonlinear,
    /// The forces depend on the position, and on velocities of others.
    Mixed,
    /// An event sets a coordinate or a velocity that is eliminated.
    Event,
}

impl Why {
    /// Returns the reason in words.
    pub fn text(self) -> &'static str {
        match self {
            Why::Unjoined => "nothing is joined there",
            Why::Free => "no force depends on the motion",
            Why::Nonlinear => "the balance of forces is not linear in the motion",
            Why::Mixed => "the balance of forces contains the position, and velocities of others",
            Why::Event => "an event sets what the balance of forces determines",
        }
    }
}

/// Result of [`eliminate`].
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Remaining {
    /// For each coordinate that is left, its index in the scene.
    pub coordinates: Vec<usize>,
    /// Motions that remain without inertia.
    pub undetermined: Vec<Undetermined>,
}

/// Eliminates the coordinates without inertia, as far as the balance of forces determines them.
/// `is_unjoined` tells which coordinates of the scene are ports joined to nothing.
///
/// Coordinates in constraints are left to these.
pub fn eliminate(system: &mut LagrangianSystem, is_unjoined: &dyn Fn(usize) -> bool) -> Remaining {
    let mut left = Remaining {
        coordinates: (0..system.coordinates.len()).collect(),
        undetermined: Vec::new(),
    };
    // Those of bodies are found once the mass matrix is derived.
    if !system.mechanisms.is_empty() || !system.orientations.is_empty() {
        return left;
    }
    let outputs = system.outputs.len();
    let checked = checked_coordinates(system);
    system.outputs.extend(checked);
    while let Some(balance) = left.balance(system, is_unjoined) {
        left.coordinates.remove(balance.pivot.0 as usize);
        balance.apply(system);
    }
    let coordinates = system.coordinates.iter().flat_map(|one| [&one.position, &one.velocity]);
    let states = coordinates.chain(system.first_order.iter().map(|state| &state.quantity));
    let states: BTreeSet<String> = states.map(|quantity| quantity.name.path.clone()).collect();
    let remains = |output: &Definition| states.contains(&output.quantity.name.path);
    if system.outputs[outputs..].iter().all(remains) {
        system.outputs.truncate(outputs);
    }
    left
}

/// Returns the coordinates and velocities that checks concern, as outputs. They are needed where
/// one of them does not remain a state: a scene with an output keeps no others.
fn checked_coordinates(system: &LagrangianSystem) -> Vec<Definition> {
    let ids = (0..).map(CoordinateId);
    let all = ids.zip(&system.coordinates).flat_map(|(id, coordinate)| {
        [
            (&coordinate.position, Symbol::Coordinate(id)),
            (&coordinate.velocity, Symbol::Velocity(id)),
        ]
    });
    let is_output =
        |name: &str| system.outputs.iter().any(|output| output.quantity.name.path == name);
    let is_checked =
        |name: &str| system.checks.iter().any(|check| check.of == name) && !is_output(name);
    all.filter(|(quantity, _)| is_checked(&quantity.name.path))
        .map(|(quantity, symbol)| Definition {
            quantity: quantity.clone(),
            expr: Expr::Symbol(symbol),
        })
        .collect()
}

impl Remaining {
    /// Returns the first balance of forces that determines a motion, and lists the motions before
    /// it. These may be determined once others are gone.
    fn balance(
        &mut self,
        system: &LagrangianSystem,
        is_unjoined: &dyn Fn(usize) -> bool,
    ) -> Option<Balance> {
        self.undetermined.clear();
        motions(system).into_iter().find_map(|motion| {
            let indices = motion.iter().map(|(id, _)| self.coordinates[id.0 as usize]);
            let coordinates: Vec<usize> = indices.collect();
            let is_alone = coordinates.iter().any(|index| is_unjoined(*index));
            let found = if is_alone { Err(Why::Unjoined) } else { Balance::of(system, &motion) };
            let open = |why| self.undetermined.push(Undetermined { coordinates, why });
            found.map_err(open).ok()
        })
    }
}

/// Returns the motions without kinetic energy that no constraint concerns, first those without
/// dissipation: after these, the dissipation determines the velocities of all others.
fn motions(system: &LagrangianSystem) -> Vec<Motion> {
    let [kinetic, dissipation] =
        [&system.kinetic, &system.dissipation].map(|energy| system.given(energy));
    let count = system.coordinates.len();
    let all = motions_without_energy(&kinetic, count).unwrap_or_default();
    if all.is_empty() {
        return all;
    }
    let rigid = motions_without_energy(&sum([kinetic, dissipation]), count).unwrap_or_default();
    let is_held = |(id, _): &(CoordinateId, _)| {
        let is_its = |symbol| symbol == Symbol::Coordinate(*id) || symbol == Symbol::Velocity(*id);
        system.constraints.iter().any(|constraint| constraint.expr.mentions(is_its))
    };
    rigid.into_iter().chain(all).filter(|motion| !motion.iter().any(is_held)).collect()
}

/// Result of a balance of forces.
enum Solution {
    /// q_p' = w.
    Velocity(Expr),
    /// q_p = e and q_p'.
    Position(Expr, Expr),
}

/// The solution of a balance of forces, and the system in whose coordinates it holds.
struct Balance {
    /// The coordinate that is eliminated.
    pivot: CoordinateId,
    system: LagrangianSystem,
    solution: Solution,
}

impl Balance {
    /// Solves the balance of forces along a motion.
    fn of(system: &LagrangianSystem, motion: &Motion) -> Result<Self, Why> {
        let pivot = motion.last().map_or(CoordinateId(0), |(id, _)| *id);
        let mut system = relative(system, motion, pivot)?;
        let [position, velocity] = [Symbol::Coordinate(pivot), Symbol::Velocity(pivot)];
        let mut force = balance(&system, pivot);
        // Damping and stiffness of zero determine nothing.
        for by in [velocity, position] {
            let slope = derivative(&force, by);
            if !is_zero(&slope) && is_zero(&system.given(&slope)) {
                let zeros = zeros(&system, &slope);
                hold_at_zero(&mut system, &zeros);
                force = balance(&system, pivot);
            }
        }
        let is_velocity = |symbol| matches!(symbol, Symbol::Velocity(_));
        let is_unsolved =
            |symbol| matches!(symbol, Symbol::Acceleration(_) | Symbol::Multiplier(_));
        let solution = if force.mentions(is_unsolved) {
            return Err(Why::Nonlinear);
        } else if !is_zero(&derivative(&force, velocity)) {
            Solution::Velocity(solved(&force, velocity)?)
        } else if is_zero(&derivative(&force, position)) {
            return Err(Why::Free);
        } else if system.dissipation.mentions(|symbol| symbol == velocity) {
            return Err(Why::Mixed);
        } else {
            let place = solved(&force, position)?;
            if place.mentions(is_velocity) {
                return Err(Why::Mixed);
            }
            // Rates of first-order states may contain the velocity.
            let rate = total_derivative(&system, &place);
            let residual = sum([rate, minus(Expr::Symbol(velocity))]);
            Solution::Position(place, solved(&residual, velocity)?)
        };
        let is_set = |symbol: Symbol| match solution {
            Solution::Velocity(_) => symbol == velocity,
            Solution::Position(..) => symbol == velocity || symbol == position,
        };
        if system.events.iter().flat_map(|event| &event.set).any(|(symbol, _)| is_set(*symbol)) {
            return Err(Why::Event);
        }
        Ok(Balance { pivot, system, solution })
    }

    /// Replaces the system by the one without the coordinate.
    fn apply(self, system: &mut LagrangianSystem) {
        let Balance { pivot, system: mut new, solution } = self;
        let coordinate = &new.coordinates[pivot.0 as usize];
        let name = &coordinate.position.name.path;
        let unused = |is_given: bool, what| {
            if is_given { format!("; its initial {what} not used") } else { String::new() }
        };
        let note = match &solution {
            Solution::Velocity(_) => format!(
                "`{name}` has no inertia: its velocity follows from the balance of forces{}",
                unused(coordinate.is_given[1], "velocity is")
            ),
            Solution::Position(..) => format!(
                "`{name}` has no inertia: its position follows from the balance of forces{}",
                unused(coordinate.is_given.contains(&true), "values are")
            ),
        };
        new.notes.push(note);
        match solution {
            Solution::Velocity(rate) => with_rate(&mut new, pivot, &rate),
            Solution::Position(place, rate) => with_place(&mut new, pivot, &place, &rate),
        }
        *system = new;
    }
}

/// Returns the system in coordinates relative to `pivot`: others of the motion follow it, and T
/// does not depend on its velocity.
fn relative(
    system: &LagrangianSystem,
    motion: &Motion,
    pivot: CoordinateId,
) -> Result<LagrangianSystem, Why> {
    let mut new = system.clone();
    let velocities: BTreeSet<Symbol> = motion.iter().map(|(id, _)| Symbol::Velocity(*id)).collect();
    let moving = |symbol| velocities.contains(&symbol);
    if !is_zero_along(&system.kinetic, motion) {
        // Only masses of zero let it move without energy.
        let terms = flat(&system.kinetic).into_iter().filter(|term| term.mentions(moving));
        let zeros = zeros(&new, &sum(terms.cloned()));
        hold_at_zero(&mut new, &zeros);
    }
    let is_rigid = is_zero_along(&new.dissipation, motion);
    let still = |expr: &Expr| {
        let is_pivot = |symbol| symbol == Symbol::Velocity(pivot);
        expr.replace(&|symbol| is_pivot(symbol).then(|| Expr::integer(0)))
    };
    new.kinetic = still(&new.kinetic);
    if is_rigid {
        new.dissipation = still(&new.dissipation);
    }
    let others: Motion = motion.iter().filter(|(id, _)| *id != pivot).cloned().collect();
    if others.is_empty() {
        return Ok(new);
    }
    let rate_of = |id| others.iter().find(|(other, _)| *other == id).map(|(_, rate)| rate);
    let is_set = |symbol: &Symbol| match symbol {
        Symbol::Coordinate(id) | Symbol::Velocity(id) => *id == pivot || rate_of(*id).is_some(),
        _ => false,
    };
    if new.events.iter().flat_map(|event| &event.set).any(|(symbol, _)| is_set(symbol)) {
        return Err(Why::Event);
    }
    let [kinetic, dissipation] = [&new.kinetic, &new.dissipation].map(Expr::clone);
    let shifted = |id, of: fn(CoordinateId) -> Symbol| {
        let part = product([Expr::Number(rate_of(id)?.clone()), Expr::Symbol(of(pivot))]);
        Some(sum([Expr::Symbol(of(id)), part]))
    };
    let with = |symbol| match symbol {
        Symbol::Coordinate(id) => shifted(id, Symbol::Coordinate),
        Symbol::Velocity(id) => shifted(id, Symbol::Velocity),
        Symbol::Acceleration(id) => shifted(id, Symbol::Acceleration),
        _ => None,
    };
    for expr in new.exprs_mut() {
        *expr = expr.replace(&with);
    }
    // Velocities are relative ones already where the motion as a whole changes nothing.
    let places = |symbol| match symbol {
        Symbol::Coordinate(id) => shifted(id, Symbol::Coordinate),
        _ => None,
    };
    new.kinetic = kinetic.replace(&places);
    if is_rigid {
        new.dissipation = dissipation.replace(&places);
    }
    let first = new.coordinates[pivot.0 as usize].clone();
    for (id, rate) in others {
        let index = id.0 as usize;
        let scaled = |expr: &Expr| product([Expr::Number(rate.clone()), expr.clone()]);
        let [of_pivot, own] = [pivot.0 as usize, index].map(|at| new.generalized_force[at].clone());
        let force = &mut new.generalized_force[pivot.0 as usize];
        force.total = sum([of_pivot.total, scaled(&own.total)]);
        force.conversion = sum([of_pivot.conversion, scaled(&own.conversion)]);
        let coordinate = &mut new.coordinates[index];
        for (initial, of_pivot) in coordinate.initial.iter_mut().zip(&first.initial) {
            *initial = sum([initial.clone(), minus(scaled(of_pivot))]);
        }
        coordinate.identified.clear();
        for quantity in [&mut coordinate.position, &mut coordinate.velocity] {
            if quantity.name.path.ends_with("_relative") {
                continue;
            }
            quantity.name.path.push_str("_relative");
            quantity.name.ident.push_str("_relative");
            quantity.name.latex = format!("\\Delta {}", quantity.name.latex);
            let doc = format!("{}, relative", quantity.doc);
            doc.trim_start_matches(", ").clone_into(&mut quantity.doc);
        }
    }
    Ok(new)
}

/// Reports whether an energy does not depend on the rate of a motion.
fn is_zero_along(energy: &Expr, motion: &Motion) -> bool {
    let slopes = motion.iter().map(|(id, rate)| {
        let slope = derivative(energy, Symbol::Velocity(*id));
        product([Expr::Number(rate.clone()), slope])
    });
    is_zero(&sum(slopes))
}

/// Returns dL/dq + Q - dD/dq' of a coordinate whose velocity T does not contain.
fn balance(system: &LagrangianSystem, id: CoordinateId) -> Expr {
    let slope = |of: &Expr, by| derivative(&normal_form(of), by);
    let [kinetic, potential] =
        [&system.kinetic, &system.potential].map(|energy| slope(energy, Symbol::Coordinate(id)));
    let friction = slope(&system.dissipation, Symbol::Velocity(id));
    let force = system.generalized_force[id.0 as usize].total.clone();
    normal_form(&sum([kinetic, minus(potential), force, minus(friction)]))
}

/// Solves `expr = 0` for a symbol that it contains linearly.
fn solved(expr: &Expr, symbol: Symbol) -> Result<Expr, Why> {
    let slope = derivative(expr, symbol);
    let decides = |part: &Expr| part.mentions(|other| other == symbol);
    if decides(&slope) && !is_zero(&derivative(&slope, symbol)) || selects(expr, symbol) {
        return Err(Why::Nonlinear);
    }
    let at_zero = |expr: &Expr| expr.replace(&|other| (other == symbol).then(|| Expr::integer(0)));
    let slope = at_zero(&slope);
    if is_zero(&slope) {
        return Err(Why::Free);
    }
    let over = Expr::Power(Box::new(slope), Box::new(Expr::integer(-1)));
    Ok(normal_form(&product([Expr::integer(-1), at_zero(expr), over])))
}

/// Reports whether a comparison or another function that is not smooth depends on a symbol.
fn selects(expr: &Expr, symbol: Symbol) -> bool {
    let mut selects = false;
    Expr::visit_all([expr], &mut |part| {
        if let Expr::Call(function, arguments) = part {
            let reads = |argument: &Expr| argument.mentions(|other| other == symbol);
            selects |= match function {
                Function::SelectLess => arguments[..2].iter().any(reads),
                _ => arguments.iter().any(reads),
            };
        }
    });
    selects
}

/// Returns the derivative by time of an expression without velocities or with them.
fn total_derivative(system: &LagrangianSystem, expr: &Expr) -> Expr {
    let mut terms = vec![derivative(expr, Symbol::Time)];
    for symbol in expr.symbols() {
        let rate = match symbol {
            Symbol::Coordinate(id) => Expr::Symbol(Symbol::Velocity(id)),
            Symbol::Velocity(id) => Expr::Symbol(Symbol::Acceleration(id)),
            Symbol::FirstOrder(id) => system.first_order[id.0 as usize].rate.clone(),
            _ => continue,
        };
        terms.push(product([derivative(expr, symbol), rate]));
    }
    sum(terms)
}

/// Turns a coordinate into a first-order state of the given rate.
fn with_rate(system: &mut LagrangianSystem, pivot: CoordinateId, rate: &Expr) {
    let velocity = Symbol::Velocity(pivot);
    let (own, others): (Vec<Expr>, Vec<Expr>) = flat(&system.dissipation)
        .into_iter()
        .cloned()
        .partition(|term| term.mentions(|symbol| symbol == velocity));
    let own = normal_form(&sum(own));
    system.dissipation = sum(others);
    let frictions = (0..system.coordinates.len() as u32).map(CoordinateId);
    let frictions: Vec<(CoordinateId, Expr)> = frictions
        .map(|id| (id, derivative(&own, Symbol::Velocity(id))))
        .filter(|(_, friction)| !friction.is_zero())
        .collect();
    let mut dissipated = vec![system.dissipated_power.clone()];
    // Power that changes the energy of the new state counts as supplied, but comes from others.
    let conversion = system.generalized_force[pivot.0 as usize].conversion.clone();
    let mut supplied = vec![system.supplied_power.clone()];
    supplied.push(minus(product([Expr::Symbol(velocity), conversion])));
    for (id, friction) in frictions {
        let power = product([Expr::Symbol(Symbol::Velocity(id)), friction.clone()]);
        if id == pivot {
            supplied.push(power.clone());
        }
        dissipated.push(power);
        let force = &mut system.generalized_force[id.0 as usize];
        force.total = sum([force.total.clone(), minus(friction.clone())]);
        force.conversion = sum([force.conversion.clone(), minus(friction)]);
    }
    system.dissipated_power = sum(dissipated);
    system.supplied_power = sum(supplied);
    let coordinate = system.coordinates[pivot.0 as usize].clone();
    let state = FirstOrderId(system.first_order.len() as u32);
    system.first_order.push(FirstOrderState {
        quantity: coordinate.position,
        rate: Expr::Symbol(velocity),
        initial: coordinate.initial[0].clone(),
        scale: coordinate.scale[0],
        is_mode: false,
    });
    remove(system, pivot, &Expr::Symbol(Symbol::FirstOrder(state)), rate);
}

/// Replaces a coordinate by its place, and its velocity.
fn with_place(system: &mut LagrangianSystem, pivot: CoordinateId, place: &Expr, rate: &Expr) {
    let own = system.generalized_force[pivot.0 as usize].clone();
    let velocities = (0..system.coordinates.len() as u32).map(CoordinateId);
    let carried: Vec<(CoordinateId, Expr)> = velocities
        .map(|id| (id, derivative(place, Symbol::Coordinate(id))))
        .filter(|(_, slope)| !slope.is_zero())
        .collect();
    let mut by_others = vec![Expr::Symbol(Symbol::Velocity(pivot))];
    for (id, slope) in carried {
        let force = &mut system.generalized_force[id.0 as usize];
        force.total = sum([force.total.clone(), product([slope.clone(), own.total.clone()])]);
        let part = product([slope.clone(), own.conversion.clone()]);
        force.conversion = sum([force.conversion.clone(), part]);
        by_others.push(minus(product([slope, Expr::Symbol(Symbol::Velocity(id))])));
    }
    let passed = product([minus(own.conversion), sum(by_others)]);
    system.supplied_power = sum([system.supplied_power.clone(), passed]);
    remove(system, pivot, place, rate);
}

/// Removes a coordinate, whose position and velocity are replaced everywhere.
fn remove(system: &mut LagrangianSystem, pivot: CoordinateId, place: &Expr, rate: &Expr) {
    let at_place = |symbol| (symbol == Symbol::Coordinate(pivot)).then(|| place.clone());
    let rate = &rate.replace(&at_place);
    let moving = |symbol| match symbol {
        Symbol::Velocity(id) if id == pivot => Some(rate.clone()),
        symbol => at_place(symbol),
    };
    // Only outputs contain accelerations.
    let is_its = |symbol| symbol == Symbol::Acceleration(pivot);
    let needs_acceleration = system.exprs_mut().iter().any(|expr| expr.mentions(is_its));
    let acceleration = needs_acceleration.then(|| total_derivative(system, rate).replace(&moving));
    let replaced = |symbol| match symbol {
        Symbol::Acceleration(id) if id == pivot => acceleration.clone(),
        symbol => moving(symbol),
    };
    let shifted = |id: CoordinateId| CoordinateId(id.0 - u32::from(id > pivot));
    let renumbered = |symbol| match symbol {
        Symbol::Coordinate(id) => Symbol::Coordinate(shifted(id)),
        Symbol::Velocity(id) => Symbol::Velocity(shifted(id)),
        Symbol::Acceleration(id) => Symbol::Acceleration(shifted(id)),
        other => other,
    };
    system.generalized_force.remove(pivot.0 as usize);
    system.coordinates.remove(pivot.0 as usize);
    for expr in system.exprs_mut() {
        *expr = expr.replace(&replaced).replace(&|symbol| Some(Expr::Symbol(renumbered(symbol))));
    }
    for (symbol, _) in system.events.iter_mut().flat_map(|event| &mut event.set) {
        *symbol = match (*symbol, place) {
            (Symbol::Coordinate(id), Expr::Symbol(state)) if id == pivot => *state,
            (symbol, _) => renumbered(symbol),
        };
    }
    for attachment in system.fields.iter_mut().flat_map(|field| &mut field.attachments) {
        attachment.coordinate = attachment.coordinate.map(shifted);
    }
}

/// Returns the parameters in an expression whose value in the spec is zero.
fn zeros(system: &LagrangianSystem, expr: &Expr) -> Vec<ParameterId> {
    let parameters = expr.symbols().into_iter().filter_map(|symbol| match symbol {
        Symbol::Parameter(id) => Some(id),
        _ => None,
    });
    parameters.filter(|id| system.parameter(*id).value == 0.0).collect()
}

/// Replaces parameters by zero and requires that runs leave them at zero.
fn hold_at_zero(system: &mut LagrangianSystem, parameters: &[ParameterId]) {
    let mut requirements = std::mem::take(&mut system.requirements);
    for expr in system.exprs_mut() {
        *expr = expr.replace(&|symbol| match symbol {
            Symbol::Parameter(id) if parameters.contains(&id) => Some(Expr::integer(0)),
            _ => None,
        });
    }
    requirements.extend(parameters.iter().map(|id| {
        let name = &system.parameter(*id).quantity.name.path;
        let rule = format!(
            "parameter `{name}` is 0, so that a balance of forces determines what moves without \
             inertia"
        );
        Required::new(&Expr::Symbol(Symbol::Parameter(*id)), Bound::Zero, rule)
    }));
    system.requirements = requirements;
}

/// Returns the terms of a sum, including those of nested sums.
fn flat(expr: &Expr) -> Vec<&Expr> {
    match expr {
        Expr::Sum(terms) => terms.iter().flat_map(flat).collect(),
        expr => vec![expr],
    }
}

fn minus(expr: Expr) -> Expr {
    product([Expr::integer(-1), expr])
}

//! Slicing: removal of states that no output depends on, with their equations.
//!
//! An output needs the symbols it contains. A position needs its velocity. A velocity or an
//! acceleration needs the equations of motion of its block of the mass matrix, and so all symbols
//! in M and f there. A first-order state needs the symbols in h. Coordinates that share a
//! constraint share a block, and its multiplier needs them. Events need everything they depend on
//! and set. All other states are held at their initial values, which does not affect the rest.

use std::collections::BTreeSet;

use super::Step;
use crate::mechanics::lagrange::EquationsOfMotion;
use crate::scene::system::{Event, GeneralizedForce, LagrangianSystem};
use machinist_algebra::cas::Cas;
use machinist_algebra::expr::{ConstraintId, CoordinateId, Expr, FirstOrderId, Symbol};
use machinist_algebra::unless_faulty;
use machinist_model::{What, Why};

/// Returns the equations that the outputs depend on. If the scene has no outputs, all states are
/// kept.
pub(super) fn slice(cas: &mut Cas, equations: EquationsOfMotion) -> Step {
    if equations.outputs.is_empty() {
        return Step::Equations(equations);
    }
    let kept = Kept::new(&equations);
    if kept.is_everything() {
        return Step::Equations(equations);
    }
    let mut reduction = equations.reduction.clone();
    for state in &equations.layout.states {
        if !kept.has(state.motion.symbol()) {
            reduction.add(What::State, &state.quantity.name.path, Why::Unreachable, "");
        }
    }
    let system = kept.part_of(cas, &equations);
    Step::System(system, reduction)
}

/// The coordinates and first-order states that are kept, and their new ids.
struct Kept {
    coordinates: Vec<Option<CoordinateId>>,
    first_order: Vec<Option<FirstOrderId>>,
    constraints: Vec<Option<ConstraintId>>,
}

impl Kept {
    fn new(equations: &EquationsOfMotion) -> Self {
        let needed = needed(equations);
        let mut next = 0..;
        let coordinates = (0..equations.forcing.len() as u32).map(|id| {
            let is_needed = needed.contains(&Symbol::Velocity(CoordinateId(id)));
            is_needed.then(|| next.next().map(CoordinateId)).flatten()
        });
        let coordinates: Vec<Option<CoordinateId>> = coordinates.collect();
        let mut next = 0..;
        let constraints = (0..equations.constraints.len()).map(|constraint| {
            let mut held = equations.constraints.coordinates(constraint);
            let is_needed = held.all(|coordinate| coordinates[coordinate].is_some());
            is_needed.then(|| next.next().map(ConstraintId)).flatten()
        });
        let constraints = constraints.collect();
        let mut next = 0..;
        let first_order = (0..equations.rates.len() as u32).map(|id| {
            let is_needed = needed.contains(&Symbol::FirstOrder(FirstOrderId(id)));
            is_needed.then(|| next.next().map(FirstOrderId)).flatten()
        });
        Kept { coordinates, first_order: first_order.collect(), constraints }
    }

    fn is_everything(&self) -> bool {
        self.coordinates.iter().all(Option::is_some) && self.first_order.iter().all(Option::is_some)
    }

    /// Reports whether a symbol is kept. Symbols that are not states always are.
    fn has(&self, symbol: Symbol) -> bool {
        match symbol {
            Symbol::Coordinate(id) | Symbol::Velocity(id) | Symbol::Acceleration(id) => {
                self.coordinates[id.0 as usize].is_some()
            }
            Symbol::FirstOrder(id) => self.first_order[id.0 as usize].is_some(),
            Symbol::Multiplier(id) | Symbol::Unloaded(id) => {
                self.constraints[id.0 as usize].is_some()
            }
            _ => true,
        }
    }

    /// Reports whether a symbol is a state that is kept.
    fn has_state(&self, symbol: Symbol) -> bool {
        let is_state = matches!(
            symbol,
            Symbol::Coordinate(_)
                | Symbol::Velocity(_)
                | Symbol::Acceleration(_)
                | Symbol::FirstOrder(_)
        );
        is_state && self.has(symbol)
    }

    /// Returns an expression with new ids, and removed states held at their initial values.
    fn held(&self, expr: &Expr, system: &LagrangianSystem) -> Expr {
        let coordinate = |id: CoordinateId| self.coordinates[id.0 as usize];
        expr.replace(&|symbol| match symbol {
            Symbol::Coordinate(id) => Some(match coordinate(id) {
                Some(new) => Expr::Symbol(Symbol::Coordinate(new)),
                None => system.coordinates[id.0 as usize].initial[0].clone(),
            }),
            Symbol::Velocity(id) => Some(moving(coordinate(id).map(Symbol::Velocity))),
            Symbol::Acceleration(id) => Some(moving(coordinate(id).map(Symbol::Acceleration))),
            Symbol::Multiplier(id) => {
                Some(moving(self.constraints[id.0 as usize].map(Symbol::Multiplier)))
            }
            Symbol::Unloaded(id) => {
                Some(moving(self.constraints[id.0 as usize].map(Symbol::Unloaded)))
            }
            Symbol::FirstOrder(id) => Some(match self.first_order[id.0 as usize] {
                Some(new) => Expr::Symbol(Symbol::FirstOrder(new)),
                None => system.first_order[id.0 as usize].initial.clone(),
            }),
            _ => None,
        })
    }

    /// Replaces the ids in an event. All of its states are kept.
    fn renumber(&self, event: &mut Event, system: &LagrangianSystem) {
        for expr in event.exprs_mut() {
            *expr = self.held(expr, system);
        }
        for (id, _) in &mut event.when {
            *id = self.first_order[id.0 as usize].unwrap_or(*id);
        }
        for (symbol, _) in &mut event.set {
            if let Expr::Symbol(new) = self.held(&Expr::Symbol(*symbol), system) {
                *symbol = new;
            }
        }
    }

    /// Returns the part of a system that is kept.
    fn part_of(&self, cas: &mut Cas, equations: &EquationsOfMotion) -> LagrangianSystem {
        let system = &equations.system;
        let held = |expr: &Expr| self.held(expr, system);
        let mechanics = [&system.kinetic, &system.potential, &system.dissipation];
        let [kinetic, potential, dissipation] =
            mechanics.map(|expr| held(&self.own_terms(cas, expr, |_| true)));
        // Energy stored only in removed states is constant here, so it is dropped.
        let is_constant = |term: &Expr| !held(term).mentions(|symbol| symbol == Symbol::Time);
        let stored_energy = held(&self.own_terms(cas, &system.stored_energy, is_constant));
        let passed_on = self.passed_on(cas, equations);
        let negative = Expr::Product(vec![Expr::integer(-1), passed_on]);
        let mut part = LagrangianSystem {
            kinetic,
            potential,
            dissipation,
            stored_energy,
            supplied_power: Expr::Sum(vec![held(&system.supplied_power), negative]),
            dissipated_power: held(&system.dissipated_power),
            ..system.clone()
        };
        retain(&mut part.coordinates, &self.coordinates);
        retain(&mut part.generalized_force, &self.coordinates);
        retain(&mut part.first_order, &self.first_order);
        retain(&mut part.constraints, &self.constraints);
        for constraint in &mut part.constraints {
            constraint.expr = held(&constraint.expr);
            for (id, _) in &mut constraint.when {
                *id = self.first_order[id.0 as usize].unwrap_or(*id);
            }
        }
        for GeneralizedForce { total, conversion } in &mut part.generalized_force {
            (*total, *conversion) = (held(total), held(conversion));
            *total = unless_faulty!("forces on what is sliced", total.clone(), {
                Expr::Product(vec![Expr::integer(-1), total.clone()])
            });
        }
        for state in &mut part.first_order {
            state.rate = held(&state.rate);
        }
        for event in &mut part.events {
            self.renumber(event, system);
        }
        part.helpers.retain(|helper| !helper.expr.mentions(|symbol| !self.has(symbol)));
        for definition in part.helpers.iter_mut().chain(&mut part.outputs) {
            definition.expr = held(&definition.expr);
        }
        part
    }

    /// Returns the terms of a sum that concern what is kept. Terms whose only variables are
    /// removed ones are dropped if `may_go`.
    fn own_terms(&self, cas: &mut Cas, expr: &Expr, may_go: impl Fn(&Expr) -> bool) -> Expr {
        let is_foreign = |term: &Expr| term.mentions(|symbol| !self.has(symbol));
        let is_own = |term: &Expr| term.mentions(|symbol| self.has_state(symbol));
        let mut own = Vec::new();
        for term in terms(expr) {
            if is_foreign(&term) && is_own(&term) {
                let form = cas.form(&term);
                let expanded = cas.expand(&form);
                own.extend(terms(&cas.expr(&expanded)));
            } else {
                own.push(term);
            }
        }
        own.retain(|term| !is_foreign(term) || is_own(term) || !may_go(term));
        Expr::Sum(own)
    }

    /// Returns the power that kept stored energy passes to removed first-order states: dW/dz h
    /// over these, at their initial values.
    fn passed_on(&self, cas: &mut Cas, equations: &EquationsOfMotion) -> Expr {
        let stored = cas.form(&equations.energy[2]);
        let mut sum = Vec::new();
        for (id, rate) in (0..).map(FirstOrderId).zip(&equations.rates) {
            if self.first_order[id.0 as usize].is_none() {
                let slope = cas.derivative(&stored, Symbol::FirstOrder(id));
                let product = Expr::Product(vec![cas.expr(&slope), rate.clone()]);
                sum.push(self.held(&product, &equations.system));
            }
        }
        Expr::Sum(sum)
    }
}

/// Returns all symbols that the outputs need, directly or not.
fn needed(equations: &EquationsOfMotion) -> BTreeSet<Symbol> {
    let constraints = &equations.constraints;
    let blocks = blocks(equations);
    let mut needed = BTreeSet::new();
    let mut found: Vec<Symbol> = equations.outputs.iter().flat_map(Expr::symbols).collect();
    for event in &equations.events {
        found.extend(event.exprs().flat_map(Expr::symbols));
        found.extend(event.set.iter().map(|(symbol, _)| *symbol));
        found.extend(event.when.iter().map(|(id, _)| Symbol::FirstOrder(*id)));
    }
    let mut seen = BTreeSet::new();
    while let Some(symbol) = found.pop() {
        if !needed.insert(symbol) {
            continue;
        }
        match symbol {
            Symbol::Coordinate(id) | Symbol::Acceleration(id) => {
                found.push(Symbol::Velocity(id));
            }
            Symbol::Multiplier(id) | Symbol::Unloaded(id) => {
                let held = constraints.coordinates(id.0 as usize);
                found.extend(held.map(|id| Symbol::Velocity(CoordinateId(id as u32))));
            }
            Symbol::Velocity(id) => {
                let block = blocks[id.0 as usize];
                // If one coordinate of a block is needed, all of them are.
                if !seen.insert(block) {
                    continue;
                }
                for constraint in 0..constraints.len() {
                    if constraints.coordinates(constraint).any(|id| blocks[id] == block) {
                        found.extend(constraints.of(constraint).flat_map(Expr::symbols));
                    }
                }
                for row in (0..blocks.len()).filter(|row| blocks[*row] == block) {
                    found.push(Symbol::Velocity(CoordinateId(row as u32)));
                    let entries = equations.mass_matrix.row(row).iter().map(|(_, entry)| entry);
                    let entries = entries.chain([&equations.forcing[row]]);
                    found.extend(entries.flat_map(Expr::symbols));
                }
            }
            Symbol::FirstOrder(id) => found.extend(equations.rates[id.0 as usize].symbols()),
            _ => {}
        }
    }
    needed
}

/// Returns, for each coordinate, the first one it is coupled to, directly or not, by the mass
/// matrix or by a constraint.
fn blocks(equations: &EquationsOfMotion) -> Vec<usize> {
    let mut block: Vec<usize> = (0..equations.forcing.len()).collect();
    let mut join = |i: usize, j: usize| {
        let (from, to) = (block[i].max(block[j]), block[i].min(block[j]));
        block.iter_mut().filter(|b| **b == from).for_each(|b| *b = to);
    };
    for (i, row) in equations.mass_matrix.rows().enumerate() {
        for (j, entry) in row.iter().take_while(|(j, _)| *j < i) {
            if !entry.is_zero() {
                join(i, *j);
            }
        }
    }
    for constraint in 0..equations.constraints.len() {
        let held: Vec<usize> = equations.constraints.coordinates(constraint).collect();
        held.windows(2).for_each(|pair| join(pair[0], pair[1]));
    }
    block
}

fn moving(symbol: Option<Symbol>) -> Expr {
    symbol.map_or_else(|| Expr::integer(0), Expr::Symbol)
}

fn terms(expr: &Expr) -> Vec<Expr> {
    match expr {
        Expr::Sum(terms) => terms.iter().flat_map(self::terms).collect(),
        expr => vec![expr.clone()],
    }
}

/// Keeps the items that have a new id.
fn retain<T, Id>(items: &mut Vec<T>, kept: &[Option<Id>]) {
    let mut kept = kept.iter();
    items.retain(|_| kept.next().is_some_and(Option::is_some));
}

//! Removal of unused parameters, tables, times of discontinuities and helpers, and of units of
//! which nothing is left.

use std::collections::{BTreeMap, BTreeSet};

use crate::mechanics::constraint::Constraints;
use crate::mechanics::lagrange::EquationsOfMotion;
use crate::scene::system::{Event, LagrangianSystem};
use machinist_algebra::cas::Cas;
use machinist_algebra::expr::{
    CoordinateId, Expr, FirstOrderId, Function, ParameterId, Replacement, Symbol,
};
use machinist_model::{Reduction, TableId, What, Why};

/// Returns the equations with only what they use. `whole` are the original equations.
pub(super) fn drop(
    cas: &mut Cas,
    mut equations: EquationsOfMotion,
    whole: &EquationsOfMotion,
) -> EquationsOfMotion {
    drop_jumps(cas, &mut equations, whole);
    let used = Used::new(&equations);
    let mut reduction = std::mem::take(&mut equations.reduction);
    report(&mut reduction, &equations.system, &used);
    let helpers = equations.system.helpers.drain(..).zip(equations.helpers.drain(..));
    let helpers = helpers.filter(|(_, expr)| used.has_all_of(expr));
    (equations.system.helpers, equations.helpers) = helpers.unzip();
    equations.system.requirements.retain(|required| used.has_all_of(&required.expr));
    consume(&mut equations);
    renumber(&mut equations, &used);
    for unit in units(&whole.system).difference(&units(&equations.system)) {
        reduction.add(What::Unit, unit, Why::Unreachable, "");
    }
    equations.reduction = reduction;
    equations
}

/// Drops times at which nothing is discontinuous any more.
fn drop_jumps(cas: &mut Cas, equations: &mut EquationsOfMotion, whole: &EquationsOfMotion) {
    let (before, left) = (jumps(whole.all()), jumps(equations.all()));
    let times: Vec<Expr> = equations
        .system
        .discontinuities
        .iter()
        .map(|time| {
            let form = cas.form(time);
            cas.expr(&form)
        })
        .collect();
    let whole_times = whole.system.discontinuities.iter().map(|time| {
        let form = cas.form(time);
        cas.expr(&form)
    });
    // A time that was not found originally is not known to be unused.
    let goes: Vec<bool> = times
        .iter()
        .zip(whole_times)
        .map(|(time, whole)| before.contains(&whole) && !left.contains(time))
        .collect();
    let mut goes = goes.iter();
    let reduction = &mut equations.reduction;
    let mut number = 0;
    equations.system.discontinuities.retain(|_| {
        number += 1;
        let goes = goes.next().is_some_and(|goes| *goes);
        if goes {
            reduction.add(What::Jump, &format!("jump {number}"), Why::Unreachable, "");
        }
        !goes
    });
}

/// Returns the expressions that time is compared with.
fn jumps<'a>(exprs: impl Iterator<Item = &'a Expr>) -> BTreeSet<Expr> {
    let mut times = BTreeSet::new();
    Expr::visit_all(exprs, &mut |part| {
        if let Expr::Call(Function::SelectLess, sides) = part
            && sides[0] == Expr::Symbol(Symbol::Time)
        {
            times.insert(sides[1].clone());
        }
    });
    times
}

/// Parameters and tables in use, with their new ids.
struct Used {
    parameters: BTreeMap<ParameterId, ParameterId>,
    tables: BTreeMap<TableId, TableId>,
}

impl Used {
    fn new(equations: &EquationsOfMotion) -> Self {
        let layout = equations.layout.states.iter();
        let states = layout.flat_map(|state| [Some(&state.initial), state.motion.rate()]);
        let all = equations.all().chain(states.flatten());
        let all = all.chain(&equations.system.discontinuities);
        let (mut parameters, mut tables) = (BTreeSet::new(), BTreeSet::new());
        Expr::visit_all(all, &mut |part| match part {
            Expr::Symbol(Symbol::Parameter(id)) => {
                parameters.insert(*id);
            }
            Expr::Call(Function::Table { table, .. }, _) => {
                tables.insert(*table);
            }
            _ => {}
        });
        Used {
            parameters: parameters.into_iter().zip((0..).map(ParameterId)).collect(),
            tables: tables.into_iter().zip((0..).map(TableId)).collect(),
        }
    }

    fn has_all_of(&self, expr: &Expr) -> bool {
        let mut has = true;
        Expr::visit_all([expr], &mut |part| match part {
            Expr::Symbol(Symbol::Parameter(id)) => has &= self.parameters.contains_key(id),
            Expr::Call(Function::Table { table, .. }, _) => has &= self.tables.contains_key(table),
            _ => {}
        });
        has
    }
}

fn report(reduction: &mut Reduction, system: &LagrangianSystem, used: &Used) {
    for (id, parameter) in (0..).map(ParameterId).zip(&system.parameters) {
        if used.parameters.contains_key(&id) {
            continue;
        }
        let name = &parameter.quantity.name.path;
        let (why, instead) = match (parameter.tunable, parameter.value) {
            (true, _) => (Why::Unreachable, String::new()),
            (false, 0.0) => (Why::Zero, "0".to_owned()),
            (false, value) => (Why::Fixed, format!("{value:?} {}", parameter.quantity.unit)),
        };
        reduction.add(What::Parameter, name, why, instead);
    }
    for (id, table) in (0..).map(TableId).zip(&system.tables) {
        if !used.tables.contains_key(&id) {
            reduction.add(What::Table, &table.name.path, Why::Unreachable, "");
        }
    }
}

/// Replaces the expressions of the system by the equations. They are not needed any more, and may
/// contain removed symbols.
fn consume(equations: &mut EquationsOfMotion) {
    let EquationsOfMotion { system, layout, .. } = equations;
    [system.kinetic, system.potential, system.stored_energy] = equations.energy.clone();
    system.dissipation = equations.dissipation.clone();
    system.supplied_power = equations.supplied.clone();
    system.dissipated_power = equations.dissipated.clone();
    system.generalized_force.clear();
    system.springs.clear();
    let initial = |symbol| {
        let state = layout.states.iter().find(|state| state.motion.symbol() == symbol);
        state.map_or_else(|| Expr::integer(0), |state| state.initial.clone())
    };
    for (id, coordinate) in (0..).zip(&mut system.coordinates) {
        coordinate.identified.clear();
        coordinate.initial[0] = initial(Symbol::Coordinate(CoordinateId(id)));
    }
    for ((id, state), rate) in (0..).zip(&mut system.first_order).zip(&equations.rates) {
        state.rate = rate.clone();
        state.initial = initial(Symbol::FirstOrder(FirstOrderId(id)));
    }
    for (output, expr) in system.outputs.iter_mut().zip(&equations.outputs) {
        output.expr = expr.clone();
    }
    system.events.clone_from(&equations.events);
    let Constraints { values, rates, .. } = &equations.constraints;
    for ((constraint, value), rate) in system.constraints.iter_mut().zip(values).zip(rates) {
        constraint.expr = if constraint.is_of_positions { value.clone() } else { rate.clone() };
    }
    for (helper, expr) in system.helpers.iter_mut().zip(&equations.helpers) {
        helper.expr = expr.clone();
    }
}

fn renumber(equations: &mut EquationsOfMotion, used: &Used) {
    let EquationsOfMotion { system, layout, .. } = equations;
    let is_table_gone = used.tables.len() < system.tables.len();
    let mut all: Vec<&mut Expr> = equations.mass_matrix.exprs_mut().collect();
    all.extend(equations.forcing.iter_mut().chain(&mut equations.rates));
    all.extend(equations.energy.iter_mut().chain(&mut equations.helpers));
    all.extend(&mut equations.outputs);
    all.extend(equations.events.iter_mut().flat_map(Event::exprs_mut));
    all.extend(equations.constraints.exprs_mut());
    all.extend([
        &mut equations.dissipation,
        &mut equations.supplied,
        &mut equations.dissipated,
        &mut equations.time_momentum,
    ]);
    for state in &mut layout.states {
        all.push(&mut state.initial);
        all.extend(state.motion.rate_mut());
    }
    all.extend(system.exprs_mut());
    let parameter = |id: ParameterId| used.parameters.get(&id).copied();
    let symbols = |symbol| match symbol {
        Symbol::Parameter(id) => Some(Expr::Symbol(Symbol::Parameter(parameter(id)?))),
        _ => None,
    };
    let functions = |function| match function {
        Function::Table { table, order } => {
            Function::Table { table: *used.tables.get(&table).unwrap_or(&table), order }
        }
        _ => function,
    };
    let mut new = Replacement::new(symbols, is_table_gone.then_some(functions));
    for expr in all {
        *expr = new.of(expr);
    }
    let mut id = 0..;
    let mut next = || ParameterId(id.next().unwrap_or(0));
    system.parameters.retain(|_| used.parameters.contains_key(&next()));
    let mut id = 0..;
    let mut next = || TableId(id.next().unwrap_or(0));
    system.tables.retain(|_| used.tables.contains_key(&next()));
}

/// Returns the names of the instances that remain in a system.
fn units(system: &LagrangianSystem) -> BTreeSet<String> {
    let coordinates = system.coordinates.iter().map(|c| &c.position.name.path);
    let states = system.first_order.iter().map(|z| &z.quantity.name.path);
    let parameters = system.parameters.iter().map(|p| &p.quantity.name.path);
    let all = coordinates.chain(states).chain(parameters);
    all.filter_map(|path| Some(path.rsplit_once('.')?.0.to_owned())).collect()
}

//! Ignorable coordinates: absolute positions that no rate depends on.
//!
//! If M, f and h do not change along a constant direction s of the coordinates, only positions
//! relative to one of them matter (Routh):
//!
//! ```text
//! u_k = q_k - (s_k/s_r) q_r        u_k' = v_k - (s_k/s_r) v_r
//! ```
//!
//! and F(q) = F(u) with q_r = 0 for each such F. The position q_r itself is integrated only if an
//! output needs it, and is then outside of the system that an implicit method solves.

mod direction;

use std::collections::BTreeSet;

use crate::mechanics::lagrange::EquationsOfMotion;
use crate::mechanics::state::{Motion, State};
use direction::{Direction, is_invariant};
use machinist_algebra::cas::Cas;
use machinist_algebra::expr::{CoordinateId, Expr, Symbol};
use machinist_algebra::unless_faulty;
use machinist_model::{What, Why};

/// Returns the equations in relative positions, without those that nothing needs.
pub(super) fn relative(cas: &mut Cas, mut equations: EquationsOfMotion) -> EquationsOfMotion {
    if equations.outputs.is_empty() {
        return equations;
    }
    let mut live: Vec<CoordinateId> =
        (0..equations.forcing.len() as u32).map(CoordinateId).collect();
    let mut changed = Vec::new();
    loop {
        let free = direction::free(&equations, &live);
        live.retain(|id| !free.contains(id));
        leave_free(cas, &mut equations, &free);
        let Some(direction) = direction::find(cas, &equations, &live) else { break };
        live.retain(|id| *id != direction.pivot);
        changed.extend(direction.others.iter().map(|(id, _)| *id));
        apply(cas, &mut equations, &direction);
    }
    changed.sort_unstable();
    changed.dedup();
    for id in changed {
        rename(&mut equations, id);
    }
    move_quadratures_last(&mut equations);
    equations
}

/// Separates positions that no equation contains, or drops them if no output does.
fn leave_free(cas: &mut Cas, equations: &mut EquationsOfMotion, free: &[CoordinateId]) {
    let asked_for: BTreeSet<Symbol> = equations.outputs.iter().flat_map(Expr::symbols).collect();
    let mut gone = BTreeSet::new();
    for id in free {
        let direction = Direction { pivot: *id, others: Vec::new() };
        let symbol = Symbol::Coordinate(*id);
        let is_asked_for = asked_for.contains(&symbol);
        if !is_asked_for {
            if equations
                .energy
                .iter()
                .chain([&equations.time_momentum])
                .any(|e| e.mentions(|s| s == symbol))
            {
                leave_energy(cas, equations, &direction);
            }
            gone.insert(symbol);
            rewrite_helpers(cas, equations, &direction, is_asked_for);
        }
        rewrite_states(equations, &direction, is_asked_for);
    }
    for expr in equations.plain_mut().filter(|expr| expr.mentions(|symbol| gone.contains(&symbol)))
    {
        let held = expr.replace(&|symbol| gone.contains(&symbol).then(|| Expr::integer(0)));
        let form = cas.form(&held);
        *expr = cas.expr(&form);
    }
}

/// Makes the positions of a direction relative to its pivot.
fn apply(cas: &mut Cas, equations: &mut EquationsOfMotion, direction: &Direction) {
    let is_asked_for = equations.outputs.iter().any(|output| !is_invariant(output, direction));
    if !is_asked_for {
        leave_energy(cas, equations, direction);
    }
    let dynamics = equations.mass_matrix.exprs_mut().chain(&mut equations.forcing);
    for expr in dynamics.filter(|expr| direction.is_in(expr)) {
        let form = cas.form(&direction.relative(expr));
        *expr = cas.simplify(&form);
    }
    let mut rewritten = |expr: &Expr| {
        let is_relative = !is_asked_for || is_invariant(expr, direction);
        let expr = if is_relative { direction.relative(expr) } else { direction.absolute(expr) };
        let form = cas.form(&expr);
        cas.expr(&form)
    };
    for expr in equations.plain_mut() {
        *expr = rewritten(expr);
    }
    rewrite_helpers(cas, equations, direction, is_asked_for);
    rewrite_states(equations, direction, is_asked_for);
}

/// Removes the pivot's part from the energy balance: its force along the direction becomes an
/// external one.
fn leave_energy(cas: &mut Cas, equations: &mut EquationsOfMotion, direction: &Direction) {
    let [kinetic, potential, stored] = equations.energy.each_ref().map(|e| cas.form(e));
    let momentum = cas.form(&equations.time_momentum);
    let energy = &(&(&kinetic + &potential) + &stored) - &momentum;
    let mut slope = cas.derivative(&energy, Symbol::Coordinate(direction.pivot));
    for (id, factor) in &direction.others {
        let part = cas.derivative(&energy, Symbol::Coordinate(*id));
        slope = &slope + &(&part * &cas.form(factor));
    }
    let slope = cas.expand(&slope);
    let slope = cas.expr(&slope);
    let velocity = Expr::Symbol(Symbol::Velocity(direction.pivot));
    let power = Expr::Product(vec![Expr::integer(-1), direction.relative(&slope), velocity]);
    let supplied = Expr::Sum(vec![equations.supplied.clone(), power]);
    let form = cas.form(&supplied);
    equations.supplied = cas.expr(&form);
}

/// Removes helpers of absolute positions, which are no longer part of the equations.
fn rewrite_helpers(
    cas: &mut Cas,
    equations: &mut EquationsOfMotion,
    direction: &Direction,
    is_asked_for: bool,
) {
    let helpers = equations.system.helpers.drain(..).zip(equations.helpers.drain(..));
    let mut kept = Vec::new();
    for (helper, expr) in helpers {
        if !direction.is_in(&expr) {
            kept.push((helper, expr));
            continue;
        }
        let expr = if is_invariant(&expr, direction) {
            direction.relative(&expr)
        } else if is_asked_for {
            direction.absolute(&expr)
        } else {
            let name = &helper.quantity.name.path;
            equations.reduction.add(What::Helper, name, Why::Cyclic, "");
            continue;
        };
        let form = cas.form(&expr);
        kept.push((helper, cas.expr(&form)));
    }
    (equations.system.helpers, equations.helpers) = kept.into_iter().unzip();
}

fn rewrite_states(equations: &mut EquationsOfMotion, direction: &Direction, is_asked_for: bool) {
    let EquationsOfMotion { layout, reduction, .. } = equations;
    let place = |states: &[State], id: CoordinateId| {
        let symbol = Symbol::Coordinate(id);
        states.iter().position(|state| state.motion.symbol() == symbol)
    };
    let Some(pivot) = place(&layout.states, direction.pivot) else { return };
    let pivot_state = layout.states[pivot].clone();
    let Motion::Position { rate: pivot_rate, .. } = &pivot_state.motion else { return };
    for (id, factor) in &direction.others {
        let Some(at) = place(&layout.states, *id) else { continue };
        let state = &mut layout.states[at];
        let without = |own: &Expr, pivot: &Expr| {
            let sign = Expr::integer(unless_faulty!("the rate of a relative position", -1, 1));
            let part = Expr::Product(vec![sign, factor.clone(), pivot.clone()]);
            Expr::Sum(vec![own.clone(), part])
        };
        state.initial = without(&state.initial, &pivot_state.initial);
        // Differences are small even of angles that count turns.
        state.scale = state.scale.min(pivot_state.scale).min(1.0);
        if let Motion::Position { rate, .. } = &mut state.motion {
            *rate = without(rate, pivot_rate);
        }
    }
    if !is_asked_for {
        layout.states.remove(pivot);
        let others = direction.others.iter().map(|(id, _)| {
            let coordinate = &equations.system.coordinates[id.0 as usize];
            coordinate.position.name.path.as_str()
        });
        let others: Vec<&str> = others.collect();
        let instead = match others.as_slice() {
            [] => String::new(),
            others => format!("{} relative to it", others.join(", ")),
        };
        let name = &pivot_state.quantity.name.path;
        reduction.add(What::State, name, Why::Cyclic, instead);
    }
}

/// Names a relative position after a helper that equals it, if there is one.
fn rename(equations: &mut EquationsOfMotion, id: CoordinateId) {
    let symbol = Symbol::Coordinate(id);
    let helpers = equations.system.helpers.iter().zip(&equations.helpers);
    let same = helpers.filter(|(_, expr)| **expr == Expr::Symbol(symbol));
    let own = &equations.system.coordinates[id.0 as usize].position;
    let same = same.map(|(helper, _)| &helper.quantity).find(|helper| helper.unit == own.unit);
    let mut quantity = same.unwrap_or(own).clone();
    if same.is_none() {
        quantity.name.path.push_str("_relative");
        quantity.name.ident.push_str("_relative");
        quantity.name.latex = format!("\\Delta {}", quantity.name.latex);
        let doc = format!("{}, relative", quantity.doc);
        doc.trim_start_matches(", ").clone_into(&mut quantity.doc);
    }
    let states = &mut equations.layout.states;
    let taken = |states: &[State], ident: &str| {
        let mut others = states.iter().filter(|state| state.motion.symbol() != symbol);
        others.any(|state| state.quantity.name.ident == ident)
    };
    while taken(states, &quantity.name.ident) {
        quantity.name.path.push('_');
        quantity.name.ident.push('_');
    }
    if let Some(state) = states.iter_mut().find(|state| state.motion.symbol() == symbol) {
        state.quantity = quantity;
    }
}

/// Moves positions and first-order states that no rate depends on to the end.
fn move_quadratures_last(equations: &mut EquationsOfMotion) {
    let rates: std::collections::BTreeSet<Symbol> =
        equations.dynamics().flat_map(Expr::symbols).collect();
    let is_quadrature = |state: &State| {
        !matches!(state.motion, Motion::Velocity(_)) && !rates.contains(&state.motion.symbol())
    };
    let layout = &mut equations.layout;
    let (last, mut first): (Vec<State>, Vec<State>) =
        layout.states.drain(..).partition(is_quadrature);
    layout.quadratures = last.len();
    first.extend(last);
    layout.states = first;
}

//! Euler-Lagrange: one Lagrangian system to its equations of motion.
//!
//! ```text
//! L = T - V
//! M = d2L/dq'2
//! f = dL/dq - (d2L/dq' dq) q' - (d2L/dq' dz) h - d2L/dq' dt - dD/dq' + Q
//! M q'' = f + G^T lambda            z' = h
//! ```

use crate::cas::{Cas, Form};
use crate::expr::{CoordinateId, Expr, FirstOrderId, Symbol};
use crate::mechanics::constraint::Constraints;
use crate::mechanics::state::Layout;
use crate::scene::system::{Event, LagrangianSystem};
use machinist_model::Reduction;

/// M(q, t) q'' = f(q, q', z, t), z' = h(q, q', z, t), the constraints, if any, with
/// their forces, and the power balance.
///
/// Excluded: any way of solving for q''.
#[derive(Debug, Clone, PartialEq)]
pub struct EquationsOfMotion {
    /// What was derived from.
    pub system: LagrangianSystem,
    /// The entries of the state, in order.
    pub layout: Layout,
    /// M, n by n, symmetric.
    pub mass_matrix: Vec<Vec<Expr>>,
    /// f, n long.
    pub forcing: Vec<Expr>,
    /// h, m long.
    pub rates: Vec<Expr>,
    /// T, V and the energy of first-order states, as derived from.
    pub energy: [Expr; 3],
    /// D, in the same form.
    pub dissipation: Expr,
    /// Power supplied, but for `time_momentum`.
    pub supplied: Expr,
    /// Power lost.
    pub dissipated: Expr,
    /// 2 T - q' dT/dq'. Zero unless coordinates are imposed as functions of
    /// time; then its total derivative is supplied power too.
    pub time_momentum: Expr,
    /// Helpers and outputs in the same form as the equations, so that equal
    /// parts are recognised.
    pub helpers: Vec<Expr>,
    /// As `helpers`.
    pub outputs: Vec<Expr>,
    /// Constraints, differentiated.
    pub constraints: Constraints,
    /// Events, guards and new values in the same form.
    pub events: Vec<Event>,
    /// What has been left out of them.
    pub reduction: Reduction,
}

/// Derives the equations of motion.
pub fn derive(cas: &mut Cas, system: &LagrangianSystem) -> EquationsOfMotion {
    let count = system.coordinates.len() as u32;
    let ids: Vec<CoordinateId> = (0..count).map(CoordinateId).collect();
    let whole = cas.form(&system.kinetic);
    let kinetic = cas.shorter(&whole);
    let potential = cas.form(&system.potential);
    let dissipation = cas.form(&system.dissipation);
    let lagrangian = &kinetic - &potential;

    let momenta: Vec<Form> =
        ids.iter().map(|id| cas.derivative(&kinetic, Symbol::Velocity(*id))).collect();
    let mass_matrix = mass_matrix(cas, &momenta, &ids);
    let mut forcing = Vec::new();
    for (row, id) in ids.iter().enumerate() {
        let mut f = cas.derivative(&lagrangian, Symbol::Coordinate(*id));
        for other in &ids {
            let coupling = cas.derivative(&momenta[row], Symbol::Coordinate(*other));
            let velocity = cas.form(&Expr::Symbol(Symbol::Velocity(*other)));
            f = &f - &(&coupling * &velocity);
        }
        f = &f - &by_first_order(cas, system, &momenta[row]);
        f = &f - &cas.derivative(&momenta[row], Symbol::Time);
        f = &f - &cas.derivative(&dissipation, Symbol::Velocity(*id));
        f = &f + &cas.form(&system.generalized_force[row].total);
        forcing.push(cas.simplify(&f));
    }
    let constraints = Constraints::derive(cas, system);
    let power = power(cas, system, &kinetic, (&momenta, &ids), constraints.supplied_power());
    EquationsOfMotion {
        mass_matrix,
        forcing,
        rates: normal_forms(cas, system.first_order.iter().map(|z| &z.rate)),
        energy: [&system.kinetic, &system.potential, &system.stored_energy].map(|energy| {
            let form = cas.form(energy);
            cas.expr(&form)
        }),
        dissipation: cas.expr(&dissipation),
        supplied: power.supplied,
        dissipated: power.dissipated,
        time_momentum: power.time_momentum,
        helpers: normal_forms(cas, system.helpers.iter().map(|helper| &helper.expr)),
        outputs: normal_forms(cas, system.outputs.iter().map(|output| &output.expr)),
        events: events(cas, system),
        constraints,
        layout: Layout::of_all(system),
        reduction: Reduction::default(),
        system: system.clone(),
    }
}

/// (dX/dz) h: how X changes with first-order states, such as the mass of a package that
/// grows. Modes stay between events.
fn by_first_order(cas: &mut Cas, system: &LagrangianSystem, of: &Form) -> Form {
    let mut total = cas.form(&Expr::integer(0));
    for (id, state) in (0..).map(FirstOrderId).zip(&system.first_order) {
        if !state.is_mode {
            let slope = cas.derivative(of, Symbol::FirstOrder(id));
            total = &total + &(&slope * &cas.form(&state.rate));
        }
    }
    total
}

fn normal_forms<'a>(cas: &mut Cas, exprs: impl Iterator<Item = &'a Expr>) -> Vec<Expr> {
    exprs
        .map(|expr| {
            let form = cas.form(expr);
            cas.expr(&form)
        })
        .collect()
}

fn events(cas: &mut Cas, system: &LagrangianSystem) -> Vec<Event> {
    let mut events = system.events.clone();
    for expr in events.iter_mut().flat_map(Event::exprs_mut) {
        let form = cas.form(expr);
        *expr = cas.expr(&form);
    }
    events
}

/// Second derivatives of T; the lower triangle is copied, not derived again.
fn mass_matrix(cas: &mut Cas, momenta: &[Form], ids: &[CoordinateId]) -> Vec<Vec<Expr>> {
    let mut matrix: Vec<Vec<Expr>> = Vec::new();
    for (row, momentum) in momenta.iter().enumerate() {
        let mut line = Vec::new();
        for (column, id) in ids.iter().enumerate() {
            if column < row {
                line.push(matrix[column][row].clone());
            } else {
                let entry = cas.derivative(momentum, Symbol::Velocity(*id));
                line.push(cas.simplify(&entry));
            }
        }
        matrix.push(line);
    }
    matrix
}

struct Power {
    supplied: Expr,
    dissipated: Expr,
    time_momentum: Expr,
}

/// d(T + V)/dt = Q q' - q' dD/dq' - (dL/dz) h - dL/dt + d(2 T - q' dT/dq')/dt along a motion,
/// and the power of moving constraints.
fn power(
    cas: &mut Cas,
    system: &LagrangianSystem,
    kinetic: &Form,
    (momenta, ids): (&[Form], &[CoordinateId]),
    by_constraints: Vec<Expr>,
) -> Power {
    let dissipation = cas.form(&system.dissipation);
    let mut supplied = cas.form(&system.supplied_power);
    for power in by_constraints {
        supplied = &supplied + &cas.form(&power);
    }
    let mut dissipated = cas.form(&system.dissipated_power);
    let potential = cas.form(&system.potential);
    let mut time_momentum = kinetic + kinetic;
    for (row, id) in ids.iter().enumerate() {
        let velocity = cas.form(&Expr::Symbol(Symbol::Velocity(*id)));
        let force = &system.generalized_force[row];
        let external = &cas.form(&force.total) - &cas.form(&force.conversion);
        supplied = &supplied + &(&external * &velocity);
        let friction = cas.derivative(&dissipation, Symbol::Velocity(*id));
        dissipated = &dissipated + &(&friction * &velocity);
        time_momentum = &time_momentum - &(&momenta[row] * &velocity);
    }
    let lagrangian = kinetic - &potential;
    supplied = &supplied - &by_first_order(cas, system, &lagrangian);
    supplied = &supplied - &cas.derivative(&lagrangian, Symbol::Time);
    let time_momentum = cas.expand(&time_momentum);
    Power {
        supplied: cas.expr(&supplied),
        dissipated: cas.expr(&dissipated),
        time_momentum: cas.expr(&time_momentum),
    }
}

//! Euler-Lagrange equations of motion of a Lagrangian system.
//!
//! ```text
//! L = T - V
//! M = d2L/dq'2
//! f = dL/dq - (d2L/dq' dq) q' - (d2L/dq' dz) h - d2L/dq' dt - dD/dq' + Q
//! M q'' = f + G^T lambda            z' = h
//! ```
//!
//! For the rates omega of a quaternion, q'' is omega', dL/dq the derivative by a small rotation, and
//! f has the term -(omega x dL/domega).

use std::collections::BTreeMap;

use crate::mechanics::bodies;
use crate::mechanics::constraint::Constraints;
use crate::mechanics::state::Layout;
use crate::scene::system::{Event, LagrangianSystem};
use crate::spatial::orientation::Orientations;
use machinist_algebra::cas::{Cas, Form, Terms};
use machinist_algebra::expr::{CoordinateId, Expr, FirstOrderId, Function, Matrix, Symbol};
use machinist_algebra::unless_faulty;
use machinist_model::Reduction;

/// Equations of motion: M(q, t) q'' = f(q, q', z, t), z' = h(q, q', z, t), constraints and their
/// forces, if any, and the power balance.
///
/// Excluded: any way of solving for q''.
#[derive(Debug, Clone, PartialEq)]
pub struct EquationsOfMotion {
    /// The system they were derived from.
    pub system: LagrangianSystem,
    /// The entries of the state, in order.
    pub layout: Layout,
    /// M, n by n, symmetric.
    pub mass_matrix: Matrix,
    /// f, n long.
    pub forcing: Vec<Expr>,
    /// M without rigid bodies and f with all their inertial forces -(M q'')_i, for given q'';
    /// `None` without bodies. Their derivatives at fixed q'' are those of M q'' = f, and the
    /// recursion that computes forces from accelerations has fewer operations than the one of M.
    pub at_accelerations: Option<(Matrix, Vec<Expr>)>,
    /// q'' by recursion along trees of bodies, if there is nothing else. It has fewer operations than
    /// factors of M where trees are long.
    pub accelerations: Option<Vec<Expr>>,
    /// h, m long.
    pub rates: Vec<Expr>,
    /// T, V and the energy of first-order states, in the form used for the derivation.
    pub energy: [Expr; 3],
    /// D, in the same form.
    pub dissipation: Expr,
    /// Power supplied, without that of `time_momentum`.
    pub supplied: Expr,
    /// Power dissipated.
    pub dissipated: Expr,
    /// 2 T - q' dT/dq'. It is zero unless coordinates are prescribed as functions of time; its
    /// total derivative is then supplied power too.
    pub time_momentum: Expr,
    /// Helpers and outputs in the same form as the equations, so that equal parts are recognized.
    pub helpers: Vec<Expr>,
    /// Outputs, likewise.
    pub outputs: Vec<Expr>,
    /// Differentiated constraints.
    pub constraints: Constraints,
    /// Events, with guards and resets in the same form.
    pub events: Vec<Event>,
    /// Parts that reduction left out.
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

    let kinetic_terms = cas.terms(&kinetic);
    let momenta: Vec<Form> =
        ids.iter().map(|id| kinetic_terms.derivative(cas, Symbol::Velocity(*id))).collect();
    let momenta: Vec<Terms> = momenta.iter().map(|momentum| cas.terms(momentum)).collect();
    let own_mass_matrix = mass_matrix(cas, &momenta);
    let own_forcing = forcing(cas, system, &lagrangian, &dissipation, &momenta);
    let constraints = Constraints::derive(cas, system);
    let [all_kinetic, all_potential] = system.energies();
    let whole_lagrangian = if system.mechanisms.is_empty() {
        lagrangian
    } else {
        let (kinetic, potential) = (cas.form(&all_kinetic), cas.form(&all_potential));
        &kinetic - &potential
    };
    let energies = Energies {
        time_momentum: time_momentum_of(cas, system, &kinetic, &momenta),
        lagrangian: &whole_lagrangian,
        dissipation: &dissipation,
    };
    let power = power(cas, system, energies, &constraints.supplied_power());
    let bodies::Equations { mass_matrix, forcing, at_accelerations, accelerations } =
        bodies::with_bodies(cas, system, own_mass_matrix, own_forcing);
    EquationsOfMotion {
        mass_matrix,
        forcing,
        at_accelerations,
        accelerations,
        rates: normal_forms(cas, system.first_order.iter().map(|z| &z.rate)),
        energy: [&all_kinetic, &all_potential, &system.stored_energy].map(|energy| {
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

/// Returns f, differentiating each momentum and each energy only by what it depends on.
fn forcing(
    cas: &mut Cas,
    system: &LagrangianSystem,
    lagrangian: &Form,
    dissipation: &Form,
    momenta: &[Terms],
) -> Vec<Expr> {
    let (lagrangian, dissipation) = (cas.terms(lagrangian), cas.terms(dissipation));
    let coordinate = |symbol| match symbol {
        Symbol::Coordinate(id) => Some(id),
        _ => None,
    };
    let ids = (0..).map(CoordinateId);
    let rows = ids.zip(momenta).zip(&system.generalized_force).map(|((id, momentum), force)| {
        let slope = along(cas, system, &lagrangian, id);
        let mut parts = vec![unless_faulty!("dL/dq", slope, -&slope)];
        parts.extend(gyroscopic(cas, system, momenta, id));
        for other in momentum.symbols(coordinate) {
            let coupling = momentum.derivative(cas, Symbol::Coordinate(other));
            let velocity = cas.form(&system.orientations.rate(other));
            let part = &coupling * &velocity;
            parts.push(unless_faulty!("(d2L/dq' dq) q'", -&part, part));
        }
        let by_state = by_first_order(cas, system, momentum);
        parts.extend(
            by_state.iter().map(|part| unless_faulty!("(d2L/dq' dz) h", -part, part.clone())),
        );
        let by_time = momentum.derivative(cas, Symbol::Time);
        parts.push(unless_faulty!("d2L/dq' dt", -&by_time, by_time));
        let friction = dissipation.derivative(cas, Symbol::Velocity(id));
        parts.push(unless_faulty!("dD/dq'", -&friction, friction));
        parts.push(cas.form(&force.total));
        let f = cas.sum(parts);
        cas.simplify(&f)
    });
    rows.collect()
}

/// Returns dX/dq along the motion of a velocity: for a rate of rotation, the derivative by a small
/// rotation.
fn along(cas: &mut Cas, system: &LagrangianSystem, of: &Terms, id: CoordinateId) -> Form {
    along_velocity(cas, &system.orientations, id, &|cas, part| {
        of.derivative(cas, Symbol::Coordinate(part))
    })
}

/// Returns the sum of derivatives by coordinates, which `slope` gives, along the motion that a
/// velocity is the rate of.
pub(super) fn along_velocity(
    cas: &mut Cas,
    orientations: &Orientations,
    id: CoordinateId,
    slope: &dyn Fn(&mut Cas, CoordinateId) -> Form,
) -> Form {
    if !orientations.contain(id) {
        return slope(cas, id);
    }
    let parts = orientations.moves(id).into_iter().map(|(part, share)| {
        let slope = slope(cas, part);
        &cas.form(&share) * &slope
    });
    let parts = parts.collect();
    cas.sum(parts)
}

/// Returns -(omega x dL/domega) for the rates of an orientation, which are not those of coordinates:
/// the equations of Boltzmann and Hamel.
fn gyroscopic(
    cas: &mut Cas,
    system: &LagrangianSystem,
    momenta: &[Terms],
    id: CoordinateId,
) -> Vec<Form> {
    let found = system
        .orientations
        .iter()
        .find_map(|one| Some((one, one.vector.iter().position(|coordinate| *coordinate == id)?)));
    let Some((one, i)) = found else { return Vec::new() };
    let [j, k] = [1, 2].map(|next| one.vector[(i + next) % 3]);
    let mut part = |velocity: CoordinateId, of: CoordinateId| {
        let velocity = cas.form(&Expr::Symbol(Symbol::Velocity(velocity)));
        &velocity * &momenta[of.0 as usize].form(cas)
    };
    let (forward, back) = (part(j, k), part(k, j));
    vec![-&forward, back]
}

/// Returns (dX/dz) h, term by term: the change of X with first-order states, such as the mass of
/// a growing package. Modes do not change between events.
fn by_first_order(cas: &mut Cas, system: &LagrangianSystem, of: &Terms) -> Vec<Form> {
    let state = |symbol| match symbol {
        Symbol::FirstOrder(id) => Some(id),
        _ => None,
    };
    let mut parts = Vec::new();
    for id in of.symbols(state) {
        let FirstOrderId(index) = id;
        let state = &system.first_order[index as usize];
        if !state.is_mode {
            let slope = of.derivative(cas, Symbol::FirstOrder(id));
            parts.push(&slope * &cas.form(&state.rate));
        }
    }
    parts
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
    for event in &mut events {
        event.guard = within_steps(std::mem::replace(&mut event.guard, Expr::integer(0)));
    }
    events
}

/// Strips a guard of odd increasing functions, which keep its sign. A steep `tanh(u)` shows nothing
/// of a coming zero crossing; u itself does.
fn within_steps(guard: Expr) -> Expr {
    match guard {
        Expr::Call(Function::Tanh | Function::Atan | Function::Sinh, mut arguments)
            if arguments.len() == 1 =>
        {
            within_steps(arguments.swap_remove(0))
        }
        guard => guard,
    }
}

/// Returns the second derivatives of T. The lower triangle is copied, not derived again.
fn mass_matrix(cas: &mut Cas, momenta: &[Terms]) -> Matrix {
    let velocity = |symbol| match symbol {
        Symbol::Velocity(CoordinateId(id)) => Some(id as usize),
        _ => None,
    };
    let mut lines: Vec<BTreeMap<usize, Expr>> = vec![BTreeMap::new(); momenta.len()];
    for (row, momentum) in momenta.iter().enumerate() {
        for column in momentum.symbols(velocity).into_iter().filter(|column| *column >= row) {
            let slope = momentum.derivative(cas, Symbol::Velocity(CoordinateId(column as u32)));
            let entry = unless_faulty!(
                "M beside its diagonal",
                slope,
                if row == column { slope } else { -&slope }
            );
            let entry = cas.simplify(&entry);
            lines[column].insert(row, entry.clone());
            lines[row].insert(column, entry);
        }
    }
    lines.into_iter().collect()
}

struct Power {
    supplied: Expr,
    dissipated: Expr,
    time_momentum: Expr,
}

/// T - V and D of the whole system, and 2 T - q' dT/dq'.
struct Energies<'a> {
    time_momentum: Vec<Form>,
    lagrangian: &'a Form,
    dissipation: &'a Form,
}

/// Returns the terms of 2 T - q' dT/dq', given T and the momenta without rigid bodies. For bodies
/// it is zero unless joints are driven.
fn time_momentum_of(
    cas: &mut Cas,
    system: &LagrangianSystem,
    kinetic: &Form,
    momenta: &[Terms],
) -> Vec<Form> {
    let mut terms = vec![kinetic + kinetic];
    for (id, momentum) in (0..).map(CoordinateId).zip(momenta) {
        let velocity = cas.form(&Expr::Symbol(Symbol::Velocity(id)));
        terms.push(-&(&momentum.form(cas) * &velocity));
    }
    for mechanism in system.mechanisms.iter().filter(|mechanism| mechanism.is_driven()) {
        let kinetic = cas.form(&mechanism.kinetic());
        let parts = cas.terms(&kinetic);
        terms.push(&kinetic + &kinetic);
        let velocities = parts.symbols(|symbol| match symbol {
            Symbol::Velocity(id) => Some(id),
            _ => None,
        });
        for id in velocities {
            let momentum = parts.derivative(cas, Symbol::Velocity(id));
            let velocity = cas.form(&Expr::Symbol(Symbol::Velocity(id)));
            terms.push(-&(&momentum * &velocity));
        }
    }
    terms
}

/// Returns the power supplied and dissipated, and the momentum term, given L, D and
/// 2 T - q' dT/dq'. Along a motion
/// d(T + V)/dt = Q q' - q' dD/dq' - (dL/dz) h - dL/dt + d(2 T - q' dT/dq')/dt,
/// plus the power of moving constraints.
fn power(
    cas: &mut Cas,
    system: &LagrangianSystem,
    Energies { time_momentum, lagrangian, dissipation }: Energies<'_>,
    by_constraints: &[Expr],
) -> Power {
    let (lagrangian, dissipation) = (cas.terms(lagrangian), cas.terms(dissipation));
    let mut supplied = vec![cas.form(&system.supplied_power)];
    supplied.extend(by_constraints.iter().map(|power| cas.form(power)));
    let mut dissipated = vec![cas.form(&system.dissipated_power)];
    for (id, force) in (0..).map(CoordinateId).zip(&system.generalized_force) {
        let velocity = cas.form(&Expr::Symbol(Symbol::Velocity(id)));
        let external = &cas.form(&force.total) - &cas.form(&force.conversion);
        supplied.push(&external * &velocity);
        let friction = dissipation.derivative(cas, Symbol::Velocity(id));
        dissipated.push(&friction * &velocity);
    }
    supplied.extend(by_first_order(cas, system, &lagrangian).iter().map(|part| -part));
    supplied.push(-&lagrangian.derivative(cas, Symbol::Time));
    let [supplied, dissipated, time_momentum] =
        [supplied, dissipated, time_momentum].map(|parts| cas.sum(parts));
    let time_momentum =
        if cas.is_zero(&time_momentum) { cas.zero() } else { cas.expand(&time_momentum) };
    Power {
        supplied: cas.expr(&supplied),
        dissipated: cas.expr(&dissipated),
        time_momentum: cas.expr(&time_momentum),
    }
}

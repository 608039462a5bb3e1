//! Approximation on request: a spring between two coordinates becomes rigid.
//!
//! If a unit's potential V(q_a, q_b) does not change along (s_a, s_b), the two coordinates are
//! held at q_a = (s_a/s_b) q_b. Substitution removes V and the associated losses, combines both
//! inertias, and lets forces on either act on both (virtual work).

use std::collections::BTreeSet;

use super::Step;
use crate::mechanics::lagrange::EquationsOfMotion;
use crate::scene::evaluate;
use crate::scene::system::LagrangianSystem;
use machinist_algebra::cas::Cas;
use machinist_algebra::expr::operations;
use machinist_algebra::expr::{CoordinateId, Expr, ParameterId, Symbol};
use machinist_model::{What, Why};

/// Reason why a unit cannot be approximated as rigid.
#[derive(
    Debug, Clone, PartialEq, Eq, thiserror::Error, strum::IntoStaticStr, strum::VariantNames,
)]
#[strum(prefix = "freeze::", serialize_all = "kebab-case")]
#[non_exhaustive]
pub enum FreezeError {
    /// It has no spring.
    #[error("unit `{0}` cannot be frozen: it has no potential energy of two coordinates")]
    NoSpring(String),
    /// Its spring does not hold a ratio.
    #[error(
        "unit `{0}` cannot be frozen: its potential energy does not hold two coordinates at a \
         constant ratio"
    )]
    NoRatio(String),
    /// Events may set the coordinates that it would hold.
    #[error("unit `{0}` cannot be frozen: the scene has events, which might reset its coordinates")]
    Events(String),
    /// Constraints already hold its coordinates.
    #[error("unit `{0}` cannot be frozen: a constraint of the scene might be redundant with it")]
    Constraints(String),
    /// Its coordinates would have to jump at the start.
    #[error("unit `{0}` cannot be frozen: its spring is not at rest at the start")]
    NotAtRest(String),
}

impl FreezeError {
    /// Returns the code of this kind of error, which never changes; the book explains it.
    #[must_use]
    pub fn code(&self) -> &'static str {
        self.into()
    }
}

/// Coordinate `a` follows coordinate `b` by a factor.
struct Follows {
    a: CoordinateId,
    b: CoordinateId,
    factor: Expr,
}

/// Returns the system with the units rigid that its scene freezes.
pub(super) fn freeze(cas: &mut Cas, equations: EquationsOfMotion) -> Result<Step, FreezeError> {
    if equations.system.freeze.rigid.is_empty() {
        return Ok(Step::Equations(equations));
    }
    let EquationsOfMotion { mut system, mut reduction, .. } = equations;
    for unit in system.freeze.rigid.clone() {
        if !system.events.is_empty() {
            return Err(FreezeError::Events(unit));
        }
        if !system.constraints.is_empty() {
            return Err(FreezeError::Constraints(unit));
        }
        let follows = relation(cas, &system, &unit)?;
        let Follows { a, b, .. } = follows;
        let [leader, follower] = [b, a].map(|id| &system.coordinates[id.0 as usize]);
        let instead = format!("{unit} rigid: follows {}", leader.position.name.path);
        for quantity in [&follower.position, &follower.velocity] {
            reduction.add(What::State, &quantity.name.path, Why::Frozen, instead.as_str());
        }
        eliminate(&mut system, &follows);
    }
    Ok(Step::System(system, reduction))
}

/// Returns the ratio at which a unit's spring holds its coordinates.
fn relation(cas: &mut Cas, system: &LagrangianSystem, unit: &str) -> Result<Follows, FreezeError> {
    let no_spring = || FreezeError::NoSpring(unit.to_owned());
    let no_ratio = || FreezeError::NoRatio(unit.to_owned());
    let spring = system.springs.iter().find(|spring| spring.instance == unit);
    let spring = spring.ok_or_else(no_spring)?;
    let coordinates: BTreeSet<CoordinateId> = spring
        .potential
        .symbols()
        .into_iter()
        .filter_map(|symbol| match symbol {
            Symbol::Coordinate(id) => Some(id),
            _ => None,
        })
        .collect();
    let pair: Vec<CoordinateId> = coordinates.into_iter().collect();
    let [first, second] = pair.as_slice() else { return Err(no_spring()) };
    let potential = cas.form(&spring.potential);
    let slopes = [first, second].map(|id| cas.derivative(&potential, Symbol::Coordinate(*id)));
    if slopes.iter().any(|slope| cas.is_zero(slope)) {
        return Err(no_ratio());
    }
    let mut candidates = Vec::new();
    for ((a, own), (b, other)) in [
        ((*first, &slopes[0]), (*second, &slopes[1])),
        ((*second, &slopes[1]), (*first, &slopes[0])),
    ] {
        let ratio = cas.rational(&-&(other / own)).ok_or_else(no_ratio)?;
        candidates.push(Follows { a, b, factor: cas.expr(&ratio) });
    }
    candidates.sort_by_key(|follows| operations(&follows.factor));
    let follows = candidates.swap_remove(0);
    let is_constant = |symbol| matches!(symbol, Symbol::Parameter(_) | Symbol::Pi);
    if follows.factor.mentions(|symbol| !is_constant(symbol)) {
        return Err(no_ratio());
    }
    let held = cas.form(&spring.potential.replace(&|symbol| follows.leader_of(symbol)));
    let slope = cas.derivative(&held, Symbol::Coordinate(follows.b));
    if !cas.is_zero(&slope) {
        return Err(no_ratio());
    }
    if !follows.hold_at_start(system) {
        return Err(FreezeError::NotAtRest(unit.to_owned()));
    }
    Ok(follows)
}

impl Follows {
    fn leader_of(&self, symbol: Symbol) -> Option<Expr> {
        let by_factor = |leader| Expr::Product(vec![self.factor.clone(), Expr::Symbol(leader)]);
        match symbol {
            Symbol::Coordinate(id) if id == self.a => Some(by_factor(Symbol::Coordinate(self.b))),
            Symbol::Velocity(id) if id == self.a => Some(by_factor(Symbol::Velocity(self.b))),
            Symbol::Acceleration(id) if id == self.a => {
                Some(by_factor(Symbol::Acceleration(self.b)))
            }
            _ => None,
        }
    }

    /// Reports whether both coordinates start at the ratio, with the spec's parameters.
    fn hold_at_start(&self, system: &LagrangianSystem) -> bool {
        const ROUNDING: f64 = 1e-12;
        let value = |expr: &Expr| evaluate(expr, &|id: ParameterId| system.parameter(id).value);
        let [a, b] = [self.a, self.b].map(|id| &system.coordinates[id.0 as usize].initial);
        let factor = value(&self.factor);
        a.iter().zip(b).all(|(a, b)| {
            let (a, b) = (value(a), factor * value(b));
            (a - b).abs() <= ROUNDING * a.abs().max(b.abs())
        })
    }
}

/// Replaces the follower by the leader.
fn eliminate(system: &mut LagrangianSystem, follows: &Follows) {
    let (a, b) = (follows.a.0 as usize, follows.b.0 as usize);
    let force = system.generalized_force.remove(a);
    let follower = system.coordinates.remove(a);
    let b = if b > a { b - 1 } else { b };
    let scaled = |expr: Expr| Expr::Product(vec![follows.factor.clone(), expr]);
    let leader = &mut system.generalized_force[b];
    leader.total = Expr::Sum(vec![leader.total.clone(), scaled(force.total)]);
    leader.conversion = Expr::Sum(vec![leader.conversion.clone(), scaled(force.conversion)]);
    let leader = &mut system.coordinates[b].identified;
    leader.push((follower.position.name.path, follows.factor.clone()));
    let moved = follower.identified.into_iter();
    leader.extend(moved.map(|(name, factor)| (name, scaled(factor))));
    let shifted = |id: CoordinateId| CoordinateId(id.0 - u32::from(id > follows.a));
    for expr in system.exprs_mut() {
        let led = expr.replace(&|symbol| follows.leader_of(symbol));
        *expr = led.replace(&|symbol| {
            let symbol = match symbol {
                Symbol::Coordinate(id) => Symbol::Coordinate(shifted(id)),
                Symbol::Velocity(id) => Symbol::Velocity(shifted(id)),
                Symbol::Acceleration(id) => Symbol::Acceleration(shifted(id)),
                _ => return None,
            };
            Some(Expr::Symbol(symbol))
        });
    }
}

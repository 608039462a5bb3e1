//! Dry friction at impacts.
//!
//! The impulse of a finite force over no time is zero, so friction neither stops what an impact
//! throws nor holds it. After an event through which velocities may jump, each friction of the
//! parts that it moves begins anew, from its speed after the impact: its mode becomes undetermined,
//! and its own event determines the mode at the same instant. An event that sets the mode of a
//! friction itself is left as it is.
//!
//! The same holds where prescribed speeds jump, in time or at places, which the constraint of the
//! friction notes.

use std::collections::BTreeSet;

use crate::scene::joints::{join, root};
use crate::scene::system::{Constraint, Event, LagrangianSystem};
use crate::scene::typed::integer;
use crate::spec::friction::OPEN;
use machinist_algebra::expr::{ConstraintId, Expr, FirstOrderId, Function, Symbol};
use machinist_contract::Jumps;

/// Lets frictions begin anew after events through which velocities may jump.
pub(super) fn reopen_frictions(system: &mut LagrangianSystem) {
    if system.constraints.iter().all(|constraint| constraint.friction.is_none()) {
        return;
    }
    let together = moved_together(system);
    where_speeds_jump(system, &together);
    let frictions = system.constraints.iter().filter_map(|constraint| {
        Some((constraint.friction_mode()?, groups(coordinates(&constraint.expr), &together)))
    });
    let frictions: Vec<(FirstOrderId, BTreeSet<usize>)> = frictions.collect();
    let mut events = std::mem::take(&mut system.events);
    for event in &mut events {
        let jumping = groups(jumping(event, system), &together);
        for (slip, speed) in &frictions {
            let slip = Symbol::FirstOrder(*slip);
            let is_set = event.set.iter().any(|(symbol, _)| *symbol == slip);
            if !is_set && !speed.is_disjoint(&jumping) {
                event.set.push((slip, integer(OPEN.into())));
            }
        }
    }
    system.events = events;
}

/// Returns a note for each constraint that may send an impulse and whose force causes friction, or
/// another force: by Coulomb's law for impacts, the friction would send an impulse too.
pub(super) fn impulses_without_friction(system: &LagrangianSystem) -> Vec<String> {
    let forces = system.generalized_force.iter().flat_map(|force| force.total.symbols());
    let read: BTreeSet<ConstraintId> = forces
        .filter_map(|symbol| match symbol {
            Symbol::Multiplier(id) => Some(id),
            _ => None,
        })
        .collect();
    if read.is_empty() {
        return Vec::new();
    }
    let together = moved_together(system);
    let notes = read.into_iter().filter_map(|id| {
        let constraint = &system.constraints[id.0 as usize];
        let moved = groups(coordinates(&constraint.expr), &together);
        let sends = |event: &&Event| !groups(jumping(event, system), &together).is_disjoint(&moved);
        let events = system.events.iter().filter(sends);
        let events: Vec<String> = events.map(|event| format!("`{}`", event.name.path)).collect();
        (!events.is_empty()).then(|| {
            format!(
                "an impulse of constraint `{}`, as at {}, acts without the friction by its force",
                constraint.name.path,
                events.join(", ")
            )
        })
    });
    notes.collect()
}

/// Notes where prescribed speeds jump that frictions follow while they stick.
fn where_speeds_jump(system: &mut LagrangianSystem, together: &[usize]) {
    let moves = |of: &Constraint| groups(coordinates(&of.expr), together);
    let all = system.constraints.iter();
    let all: Vec<_> = all.map(|one| (moves(one), jumps(one), one.friction.is_some())).collect();
    for (index, constraint) in system.constraints.iter_mut().enumerate() {
        let Some(friction) = &mut constraint.friction else { continue };
        let followed = all.iter().enumerate().filter(|(other, (moves, _, is_friction))| {
            *other == index || !is_friction && !moves.is_disjoint(&all[index].0)
        });
        friction.jumps = followed.map(|(_, (_, jumps, _))| *jumps).max().unwrap_or_default();
    }
}

/// Returns where the speed that a constraint prescribes may jump.
fn jumps(constraint: &Constraint) -> Jumps {
    let mut jumps = Jumps::Nowhere;
    Expr::visit_all([&constraint.expr], &mut |part| {
        let found = match part {
            Expr::Call(Function::SelectLess, of) => match &of[..] {
                [Expr::Symbol(Symbol::Time), ..] => Jumps::InTime,
                // min, max: the speed of q jumps there, and not that of q'.
                [a, b, then, otherwise]
                    if [(a, b), (b, a)].contains(&(then, otherwise))
                        && !constraint.is_of_positions =>
                {
                    Jumps::Nowhere
                }
                _ => Jumps::AtPlaces,
            },
            Expr::Call(Function::Floor, _) => Jumps::AtPlaces,
            Expr::Call(Function::Abs, _) if constraint.is_of_positions => Jumps::AtPlaces,
            _ => Jumps::Nowhere,
        };
        jumps = jumps.max(found);
    });
    jumps
}

/// Returns the coordinates through which an event may send an impulse: those whose velocities it
/// sets, those of constraints that may begin to hold, and all if it may change the inertia.
fn jumping(event: &Event, system: &LagrangianSystem) -> BTreeSet<usize> {
    let mut jumping = BTreeSet::new();
    for (symbol, _) in &event.set {
        match symbol {
            Symbol::Velocity(id) => drop(jumping.insert(id.0 as usize)),
            Symbol::FirstOrder(mode) => {
                if inertia_reads(system, *symbol) {
                    jumping.extend(0..system.coordinates.len());
                }
                let begins = |one: &&Constraint| {
                    one.friction.is_none() && one.when.iter().any(|(other, _)| other == mode)
                };
                let begin = system.constraints.iter().filter(begins);
                jumping.extend(begin.flat_map(|constraint| coordinates(&constraint.expr)));
            }
            _ => {}
        }
    }
    jumping
}

/// Returns whether the kinetic energy depends on a mode.
fn inertia_reads(system: &LagrangianSystem, mode: Symbol) -> bool {
    let joints = system.mechanisms.iter().flat_map(|mechanism| &mechanism.joints);
    let inertias = joints.filter_map(|joint| joint.inertia.as_ref());
    let mut of_bodies = inertias.flat_map(|inertia| {
        let rows = inertia.tensor.iter().flatten();
        std::iter::once(&inertia.mass).chain(&inertia.moment).chain(rows)
    });
    let reads = |of: &Expr| of.mentions(|one| one == mode);
    reads(&system.kinetic) || of_bodies.any(reads)
}

/// Returns a common representative for coordinates of which an impulse on one may move the others:
/// those whose velocities are in one term of the kinetic energy, of one tree of bodies, or in one
/// constraint.
fn moved_together(system: &LagrangianSystem) -> Vec<usize> {
    let terms = match &system.kinetic {
        Expr::Sum(terms) => &terms[..],
        alone => std::slice::from_ref(alone),
    };
    let of_terms = terms.iter().map(velocities);
    let of_trees = system.mechanisms.iter().map(|mechanism| {
        let motions = mechanism.joints.iter().map(|joint| &joint.motion);
        motions
            .flat_map(|motion| motion.omega.iter().chain(&motion.velocity))
            .flat_map(velocities)
            .collect()
    });
    let of_constraints = system.constraints.iter().map(|constraint| coordinates(&constraint.expr));
    let of_quaternions =
        system.orientations.iter().map(|one| one.parts().iter().flat_map(coordinates).collect());
    let groups = of_terms.chain(of_trees).chain(of_constraints).chain(of_quaternions);
    let mut roots: Vec<usize> = (0..system.coordinates.len() + system.scalars.len()).collect();
    for group in groups {
        let group: BTreeSet<usize> = group;
        if let Some(&first) = group.first() {
            for one in group {
                join(&mut roots, [first, one]);
            }
        }
    }
    (0..roots.len()).map(|one| root(&mut roots, one)).collect()
}

/// Returns the representatives of coordinates among those that move together.
fn groups(coordinates: BTreeSet<usize>, together: &[usize]) -> BTreeSet<usize> {
    coordinates.into_iter().map(|one| together[one]).collect()
}

/// Returns the coordinates whose velocities an expression mentions.
fn velocities(of: &Expr) -> BTreeSet<usize> {
    let symbols = of.symbols().into_iter();
    coordinates_of(symbols.filter(|symbol| matches!(symbol, Symbol::Velocity(_))))
}

/// Returns the coordinates that an expression mentions, also by their velocities.
fn coordinates(of: &Expr) -> BTreeSet<usize> {
    coordinates_of(of.symbols().into_iter())
}

fn coordinates_of(symbols: impl Iterator<Item = Symbol>) -> BTreeSet<usize> {
    let index = |symbol| match symbol {
        Symbol::Coordinate(id) | Symbol::Velocity(id) => Some(id.0 as usize),
        _ => None,
    };
    symbols.filter_map(index).collect()
}

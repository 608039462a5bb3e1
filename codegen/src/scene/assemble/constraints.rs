//! Constraints: expressions that are zero, of coordinates, or linear in velocities.

use std::collections::BTreeSet;

use crate::scene::assemble::Assembler;
use crate::scene::layout::Scope;
use crate::scene::names::{Flat, name};
use crate::scene::system::{Constraint, Friction};
use crate::scene::typed::Typed;
use crate::spec::code::Code;
use crate::spec::diagnostic::Mistake;
use crate::spec::dimension::Dimension;
use crate::spec::{ConstraintSpec, quoted};
use machinist_algebra::expr::{Expr, Symbol};

impl Assembler<'_> {
    /// Returns all constraints, those of instances first.
    pub(super) fn constraints(&mut self) -> Vec<Constraint> {
        let spec = self.spec;
        let mut constraints = Vec::new();
        let mut names = Flat::default();
        let of_units = self.instances().flat_map(|(index, instance, unit)| {
            let whose = Some(instance.name.value.as_str());
            let all = unit.constraints.iter();
            all.map(move |constraint| (Scope::Instance(index), whose, constraint))
        });
        let own = spec.constraints.iter().map(|constraint| (Scope::Scene, None, constraint));
        for (scope, whose, constraint) in of_units.chain(own) {
            let name = name(whose, &constraint.name.value);
            if let Err(mistake) = names.take(&name, constraint.name.span) {
                self.mistakes.push(*mistake);
            }
            let resolved = self.resolver.expect_motion(&constraint.expression, scope);
            if let Ok(typed) = &resolved
                && let Some(mistake) = unfit(constraint, typed)
            {
                self.mistakes.push(mistake);
            }
            let dimension = resolved.as_ref().ok().and_then(|typed| typed.dimension);
            let is_of_positions = resolved.as_ref().is_ok_and(|typed| !typed.uses.velocity);
            let doc = constraint.doc.split_whitespace().collect::<Vec<_>>().join(" ");
            let unit = dimension.unwrap_or(Dimension::ONE).as_unit();
            let expr = self.note(resolved);
            let is_dropped = constraint.friction.is_none() && expr.is_zero();
            let when = self.modes(&constraint.when, scope);
            constraints.push(Constraint {
                name,
                doc,
                unit,
                expr,
                is_of_positions,
                when,
                is_dropped,
                friction: constraint.friction.is_some().then(Friction::default),
            });
        }
        for cut in &self.layout.cuts {
            let closed = self.resolver.closed(cut, &|id| self.values[id.0 as usize]);
            for constraint in closed.unwrap_or_default() {
                if let Err(mistake) = names.take(&constraint.name, cut.span) {
                    self.mistakes.push(*mistake);
                }
                constraints.push(constraint);
            }
        }
        constraints
    }
}

/// Returns the reason why an expression cannot be a constraint.
fn unfit(constraint: &ConstraintSpec, typed: &Typed) -> Option<Mistake> {
    let what = match &constraint.friction {
        None => format!("constraint {}", quoted(&constraint.name.value)),
        Some(friction) => format!("the speed of friction {}", quoted(&friction.value)),
    };
    let refuse = |message: String, label: &str, help: &str| {
        Some(
            Mistake::new(Code::InvalidConstraint, constraint.expression.span, message, label)
                .help(help),
        )
    };
    let is_state = |symbol| matches!(symbol, Symbol::FirstOrder(_));
    let moves = |symbol| {
        matches!(symbol, Symbol::Coordinate(_) | Symbol::Velocity(_) | Symbol::FirstOrder(_))
    };
    if typed.expr.mentions(is_state) {
        let message = format!("{what} depends on a state or mode");
        let help = "write it with coordinates, velocities, time and parameters";
        return refuse(message, "of a first-order state", help);
    }
    // What is zero in any position, such as the distance of a linkage from its plane, is dropped.
    if constraint.friction.is_none() && typed.expr.is_zero() {
        return None;
    }
    if !typed.expr.mentions(moves) {
        let message = format!("{what} depends on no coordinate");
        let help = "write an expression of coordinates or velocities that must be zero";
        return refuse(message, "no coordinate", help);
    }
    if constraint.friction.is_some() && !has_velocity(&typed.expr) {
        let message = format!("{what} depends on no velocity");
        let help = "write the slip speed: x_dot, v - belt_speed";
        return refuse(message, "no velocity", help);
    }
    if is_bent(&typed.expr) {
        let message = format!("{what} is not linear in velocities");
        let help = "write a sum of velocities, with coefficients that depend on coordinates and \
                    time: v - radius*omega for rolling";
        return refuse(message, "not linear in them", help);
    }
    None
}

fn has_velocity(expr: &Expr) -> bool {
    expr.mentions(|symbol| matches!(symbol, Symbol::Velocity(_)))
}

/// Reports whether the expression is nonlinear in velocities: within functions or powers, or
/// multiplied by each other.
fn is_bent(expr: &Expr) -> bool {
    is_bent_beyond(expr, &mut BTreeSet::new())
}

/// Reports the same; `straight` holds the shared parts that are known to be linear.
fn is_bent_beyond(expr: &Expr, straight: &mut BTreeSet<u128>) -> bool {
    match expr {
        Expr::Number(_) | Expr::Symbol(_) => false,
        Expr::Sum(terms) => terms.iter().any(|term| is_bent_beyond(term, straight)),
        Expr::Product(factors) => {
            factors.iter().filter(|factor| has_velocity(factor)).count() > 1
                || factors.iter().any(|factor| is_bent_beyond(factor, straight))
        }
        Expr::Power(..) | Expr::Call(..) => has_velocity(expr),
        Expr::Shared(shared) => {
            !straight.contains(&shared.digest())
                && has_velocity(expr)
                && (is_bent_beyond(shared.definition(), straight)
                    || !straight.insert(shared.digest()))
        }
    }
}

//! Target and losses of dry friction, which follow from its sliding speed.
//!
//! ```text
//! Q_j = F ds/dq'_j    lost: -F s    supplied: -F s_0
//! ```
//!
//! F is its force while it slides and s(q', q, t) its speed, linear in velocities. s_0 is the
//! prescribed part of the speed, as by a belt: s with all velocities zero.

use crate::scene::along;
use crate::scene::assemble::Assembler;
use crate::scene::layout::Scope;
use crate::scene::resolve::{MAX_TERMS, Wanted, beyond_reason};
use crate::scene::system::GeneralizedForce;
use crate::scene::typed::{integer, product, sum};
use crate::spec::code::Code;
use crate::spec::diagnostic::Mistake;
use crate::spec::dimension::Dimension;
use crate::spec::{FrictionSpec, quoted};
use machinist_algebra::expr::identity::is_zero;
use machinist_algebra::expr::{Expr, Symbol};

impl Assembler<'_> {
    /// Adds all friction to forces, and its supplied and lost power to those powers.
    pub(super) fn friction(
        &mut self,
        forces: &mut [GeneralizedForce],
        powers: [Expr; 2],
    ) -> [Expr; 2] {
        let spec = self.spec;
        let of_units = self.instances().flat_map(|(index, _, unit)| {
            unit.frictions.iter().map(move |friction| (Scope::Instance(index), friction))
        });
        let own = spec.frictions.iter().map(|friction| (Scope::Scene, friction));
        let mut terms = powers.map(|power| vec![power]);
        for (scope, friction) in of_units.chain(own) {
            match self.one_friction(forces, scope, friction) {
                Ok(powers) => {
                    for (terms, power) in terms.iter_mut().zip(powers) {
                        terms.push(power);
                    }
                }
                Err(mistake) => self.mistakes.push(*mistake),
            }
        }
        terms.map(sum)
    }

    /// Returns the power supplied and lost.
    fn one_friction(
        &mut self,
        forces: &mut [GeneralizedForce],
        scope: Scope,
        friction: &FrictionSpec,
    ) -> Result<[Expr; 2], Box<Mistake>> {
        let speed = self.resolver.expect_motion(&friction.speed, scope)?;
        let dimension = speed.dimension.and_then(|speed| Dimension::POWER.over(speed));
        let dimension = dimension.ok_or_else(|| beyond_reason(friction.speed.span))?;
        let unit = &friction.force.unit;
        if unit.unit.dimension != dimension {
            let name = quoted(&friction.force.name.value);
            let message = format!("the force of friction {name} is in {dimension}");
            let label = format!("this is {}", unit.unit.dimension);
            let help = "force times speed is a power: N for m/s, N m for rad/s";
            return Err(Box::new(
                Mistake::new(Code::DimensionMismatch, unit.span, message, label).help(help),
            ));
        }
        let wanted = Wanted::new(dimension, "the force of friction");
        let force = self.resolver.expect_force(&friction.slide, scope, wanted)?.expr;
        let slope = |of: Symbol| {
            let rate = |symbol| Some(integer(i64::from(symbol == of)));
            let slope = along::slope_by(&speed.expr, MAX_TERMS, &rate);
            let what = "the derivative of this by a velocity is not known or too long";
            slope.map_err(|_| {
                Mistake::new(Code::NoDerivative, friction.speed.span, what, "how fast it slides")
            })
        };
        for symbol in speed.expr.symbols() {
            if let Symbol::Velocity(id) = symbol {
                let q = product(vec![slope(symbol)?.0, force.clone()]);
                let on = &mut forces[id.0 as usize];
                for part in [&mut on.total, &mut on.conversion] {
                    *part = sum(vec![std::mem::replace(part, integer(0)), q.clone()]);
                }
            }
        }
        let is_velocity = |symbol| matches!(symbol, Symbol::Velocity(_));
        let imposed = speed.expr.replace(&|symbol| is_velocity(symbol).then(|| integer(0)));
        let power = |speed: Expr| product(vec![integer(-1), force.clone(), speed]);
        let supplied = if is_zero(&imposed) { integer(0) } else { power(imposed) };
        Ok([supplied, power(speed.expr.clone())])
    }
}

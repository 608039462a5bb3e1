//! Leaves out what a scene's outputs do not need, and says what was left out.
//!
//! In this order: parameters that the scene fixes become numbers;
//! states that no output reaches go; positions that nothing depends
//! on, but for their differences, go; what is then not mentioned any
//! more goes. None of it changes what the outputs are. Before all that,
//! and only where the scene asks for it, springs are taken for rigid.
//!
//! Energy and power balance are those of the part that is kept; what is left out
//! acts on it as an outside force, whose power is among the power supplied.

mod cyclic;
mod fixed;
mod frozen;
mod reach;
mod unused;

use crate::mechanics::lagrange::EquationsOfMotion;
use crate::scene::system::LagrangianSystem;
pub use frozen::FreezeError;
use machinist_algebra::cas::Cas;
use machinist_algebra::expr::Expr;
use machinist_model::Reduction;
use serde::{Deserialize, Serialize};

/// How much of a scene is kept. Each leaves out all that the one before it does.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Default, Serialize, Deserialize)]
pub enum Keep {
    /// Everything.
    All,
    /// Parameters that the scene fixes become numbers.
    Tunable,
    /// Only what some output depends on.
    Reachable,
    /// Of positions, only what some output or rate depends on. Exact up to here.
    Exact,
    /// What the scene wants frozen is rigid; the same as [`Keep::Exact`] if it wants
    /// nothing frozen.
    #[default]
    Needed,
}

impl Keep {
    /// Each, in their order.
    pub const STEPS: [Keep; 5] =
        [Keep::All, Keep::Tunable, Keep::Reachable, Keep::Exact, Keep::Needed];

    /// A word or two for people.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Keep::All => "the whole scene",
            Keep::Tunable => "parameters fixed",
            Keep::Reachable => "unreachable left out",
            Keep::Exact => "cyclic left out",
            Keep::Needed => "frozen as wanted",
        }
    }
}

/// What a step of reduction gives.
#[derive(Debug, Clone)]
#[expect(clippy::large_enum_variant, reason = "one at a time, taken apart at once")]
pub enum Step {
    /// Equations with less in them.
    Equations(EquationsOfMotion),
    /// Another system, of which equations are to be derived, and what it left out.
    System(LagrangianSystem, Reduction),
}

impl Keep {
    /// One step: what this one leaves out that the one before it does not.
    ///
    /// # Errors
    /// [`FreezeError`] if the scene wants something frozen that cannot be.
    pub fn step(self, cas: &mut Cas, equations: EquationsOfMotion) -> Result<Step, FreezeError> {
        // An event may be watched on a position, or set one, that no rate depends on; a
        // constraint is kept to by positions.
        let is_plain = equations.events.is_empty() && equations.constraints.is_empty();
        match self {
            Keep::Needed => frozen::freeze(cas, equations),
            Keep::Tunable => Ok(fixed::fix(equations)),
            Keep::Reachable => Ok(reach::slice(cas, equations)),
            Keep::Exact if is_plain => Ok(Step::Equations(cyclic::relative(cas, equations))),
            Keep::Exact | Keep::All => Ok(Step::Equations(equations)),
        }
    }

    /// The steps to be done up to here, in their order: what is frozen is so before all.
    pub fn steps(self) -> impl Iterator<Item = Keep> {
        let order = [Keep::Needed, Keep::Tunable, Keep::Reachable, Keep::Exact];
        order.into_iter().filter(move |step| *step <= self)
    }
}

/// The equations with only what they mention, once all steps are done. `whole` is the scene
/// that all began with.
#[must_use]
pub fn drop_unused(
    cas: &mut Cas,
    equations: EquationsOfMotion,
    whole: &EquationsOfMotion,
) -> EquationsOfMotion {
    unused::drop(cas, equations, whole)
}

impl EquationsOfMotion {
    /// Every expression that motion, outputs, energies and powers are made of.
    fn all(&self) -> impl Iterator<Item = &Expr> {
        let events = self.events.iter().flat_map(crate::scene::system::Event::exprs);
        self.dynamics().chain(events).chain(&self.outputs).chain(&self.energy).chain([
            &self.dissipation,
            &self.supplied,
            &self.dissipated,
            &self.time_momentum,
        ])
    }

    /// h, outputs, energies and powers: what is read as it stands, not solved for.
    fn plain_mut(&mut self) -> impl Iterator<Item = &mut Expr> {
        self.rates.iter_mut().chain(&mut self.outputs).chain(&mut self.energy).chain([
            &mut self.dissipation,
            &mut self.supplied,
            &mut self.dissipated,
            &mut self.time_momentum,
        ])
    }

    /// M, f, h and the constraints.
    fn dynamics(&self) -> impl Iterator<Item = &Expr> {
        let free = self.mass_matrix.exprs().chain(&self.forcing).chain(&self.rates);
        free.chain(self.constraints.exprs())
    }
}

//! Reduction: removal of what a scene's outputs do not need, with a record of what was left out.
//!
//! The order is: parameters that the scene fixes become numbers; states that no output depends on
//! are removed; positions that only matter by their differences are removed; symbols that are
//! then unused are removed. None of this changes the outputs. Before all that, and only if the
//! scene requests it, springs are approximated as rigid.
//!
//! Energy and power balance are those of the part that is kept. The removed part acts on it as an
//! external force, whose power counts as supplied.

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

/// Extent of a reduced scene. Each level leaves out everything that the preceding one does.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Default, Serialize, Deserialize)]
pub enum Keep {
    /// Everything.
    All,
    /// Parameters that the scene fixes are numbers.
    Tunable,
    /// Only states that some output depends on.
    Reachable,
    /// Only positions that some output or rate depends on. Exact up to here.
    Exact,
    /// Units that the scene freezes are rigid; the same as [`Keep::Exact`] if it freezes none.
    #[default]
    Needed,
}

impl Keep {
    /// All levels, in order.
    pub const STEPS: [Keep; 5] =
        [Keep::All, Keep::Tunable, Keep::Reachable, Keep::Exact, Keep::Needed];

    /// Returns a name of a word or two.
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

/// Result of a reduction step.
#[derive(Debug, Clone)]
#[expect(clippy::large_enum_variant, reason = "one at a time, taken apart at once")]
pub enum Step {
    /// Equations with fewer terms.
    Equations(EquationsOfMotion),
    /// Another system, whose equations are to be derived, and what it leaves out.
    System(LagrangianSystem, Reduction),
}

impl Keep {
    /// Takes one step: leaves out what this level adds to the preceding one.
    ///
    /// # Errors
    /// [`FreezeError`] if the scene freezes a unit that cannot be frozen.
    pub fn step(self, cas: &mut Cas, equations: EquationsOfMotion) -> Result<Step, FreezeError> {
        // An event may depend on a position, or set one, that no rate depends on; constraints
        // need positions.
        let is_plain = equations.events.is_empty() && equations.constraints.is_empty();
        match self {
            Keep::Needed => frozen::freeze(cas, equations),
            Keep::Tunable => Ok(fixed::fix(equations)),
            Keep::Reachable => Ok(reach::slice(cas, equations)),
            Keep::Exact if is_plain => Ok(Step::Equations(cyclic::relative(cas, equations))),
            Keep::Exact | Keep::All => Ok(Step::Equations(equations)),
        }
    }

    /// Iterates over the steps up to this level, in order. Freezing comes first.
    pub fn steps(self) -> impl Iterator<Item = Keep> {
        let order = [Keep::Needed, Keep::Tunable, Keep::Reachable, Keep::Exact];
        order.into_iter().filter(move |step| *step <= self)
    }
}

/// Drops whatever the equations do not contain, after all steps. `whole` is the original scene.
#[must_use]
pub fn drop_unused(
    cas: &mut Cas,
    equations: EquationsOfMotion,
    whole: &EquationsOfMotion,
) -> EquationsOfMotion {
    unused::drop(cas, equations, whole)
}

impl EquationsOfMotion {
    /// Iterates over all expressions of motion, outputs, energies and powers.
    fn all(&self) -> impl Iterator<Item = &Expr> {
        let events = self.events.iter().flat_map(crate::scene::system::Event::exprs);
        self.dynamics().chain(events).chain(&self.outputs).chain(&self.energy).chain([
            &self.dissipation,
            &self.supplied,
            &self.dissipated,
            &self.time_momentum,
        ])
    }

    /// Iterates over h, outputs, energies and powers, which are evaluated without solving.
    fn plain_mut(&mut self) -> impl Iterator<Item = &mut Expr> {
        self.rates.iter_mut().chain(&mut self.outputs).chain(&mut self.energy).chain([
            &mut self.dissipation,
            &mut self.supplied,
            &mut self.dissipated,
            &mut self.time_momentum,
        ])
    }

    /// Iterates over M, f, h and the constraints.
    fn dynamics(&self) -> impl Iterator<Item = &Expr> {
        let free = self.mass_matrix.exprs().chain(&self.forcing).chain(&self.rates);
        free.chain(self.constraints.exprs())
    }
}

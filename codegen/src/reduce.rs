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

use crate::cas::Cas;
use crate::lagrange::{EquationsOfMotion, derive};
pub use frozen::FreezeError;

/// How much of a scene is kept. Each leaves out all that the one before it does.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Default)]
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
}

/// The equations of what is kept.
///
/// # Errors
/// [`FreezeError`] if the scene wants something frozen that cannot be.
pub fn reduce(
    cas: &mut Cas,
    whole: &EquationsOfMotion,
    keep: Keep,
) -> Result<EquationsOfMotion, FreezeError> {
    let mut equations = whole.clone();
    if keep >= Keep::Needed && !whole.system.freeze.rigid.is_empty() {
        let mut reduction = Reduction::default();
        let system = frozen::freeze(cas, &whole.system, &mut reduction)?;
        equations = EquationsOfMotion { reduction, ..derive(cas, &system) };
    }
    if keep >= Keep::Tunable {
        equations = fixed::fix(cas, equations);
    }
    if keep >= Keep::Reachable {
        equations = reach::slice(cas, equations);
    }
    // An event may be watched on a position, or set one, that no rate depends on; a
    // constraint is kept to by positions.
    let is_plain = equations.events.is_empty() && equations.constraints.is_empty();
    if keep >= Keep::Exact && is_plain {
        equations = cyclic::relative(cas, equations);
    }
    if keep >= Keep::Tunable {
        equations = unused::drop(cas, equations, whole);
    }
    Ok(equations)
}

impl EquationsOfMotion {
    /// Every expression that motion, outputs, energies and powers are made of.
    fn all(&self) -> impl Iterator<Item = &crate::expr::Expr> {
        let events = self.events.iter().flat_map(crate::system::Event::exprs);
        self.dynamics().chain(events).chain(&self.outputs).chain(&self.energy).chain([
            &self.dissipation,
            &self.supplied,
            &self.dissipated,
            &self.time_momentum,
        ])
    }

    /// M, f, h and the constraints.
    fn dynamics(&self) -> impl Iterator<Item = &crate::expr::Expr> {
        let free = self.mass_matrix.iter().flatten().chain(&self.forcing).chain(&self.rates);
        free.chain(self.constraints.exprs())
    }
}

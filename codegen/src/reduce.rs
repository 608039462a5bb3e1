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

/// What was left out of a scene.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Reduction {
    /// Each thing, in the order in which it was left out.
    pub left_out: Vec<LeftOut>,
}

/// One thing left out.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct LeftOut {
    /// What it is.
    pub what: What,
    /// The spec's name of it.
    pub name: String,
    /// Why it is not needed.
    pub why: Why,
    /// What stands for it, if something does; a sentence or nothing.
    pub instead: String,
}

/// Kinds of things that are left out.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum What {
    /// An instance of a unit, with all that it has.
    Unit,
    /// An entry of the state, with its equation.
    State,
    /// A parameter.
    Parameter,
    /// An interpolation table.
    Table,
    /// A time at which the solver would stop.
    Jump,
    /// A named expression.
    Helper,
}

/// Why something is not needed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Why {
    /// No wanted output depends on it.
    Unreachable,
    /// Only its rate matters, or its difference from another.
    Cyclic,
    /// The scene fixes its value.
    Fixed,
    /// The scene fixes it at zero, and its terms vanish.
    Zero,
    /// The scene wants it frozen: an approximation.
    Frozen,
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

impl Reduction {
    fn add(&mut self, what: What, name: &str, why: Why, instead: impl Into<String>) {
        let (name, instead) = (name.to_owned(), instead.into());
        self.left_out.push(LeftOut { what, name, why, instead });
    }
}

impl What {
    /// One word for people.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            What::Unit => "unit",
            What::State => "state",
            What::Parameter => "parameter",
            What::Table => "table",
            What::Jump => "jump",
            What::Helper => "helper",
        }
    }
}

impl Why {
    /// One word for people.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Why::Unreachable => "unreachable",
            Why::Cyclic => "cyclic",
            Why::Fixed => "fixed",
            Why::Zero => "zero",
            Why::Frozen => "frozen",
        }
    }
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

//! The table of functions: what a model computes, listed once.
//!
//! Emission, interpretation, checks of a model and tables of costs go by it. A new function
//! is a row here, its tape in the [`Model`], and its method in the contract.

use crate::{MatrixTape, Model, Op, Solve, SparsityPattern, Tape};

/// A function of a model.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum FunctionId {
    /// State at the start.
    InitialState,
    /// Times at which the rate jumps.
    Discontinuities,
    /// y'.
    Rate,
    /// M.
    MassMatrix,
    /// f.
    Forcing,
    /// dy'/dy.
    RateJacobian,
    /// dy'/dp.
    ParameterJacobian,
    /// Partial y'/partial t.
    TimeDerivative,
    /// Wanted outputs.
    Outputs,
    /// T, V, stored energy.
    Energy,
    /// dE/dt, power supplied, power dissipated.
    PowerBalance,
    /// What passes zero where events happen.
    Guards,
    /// dg/dt of the guards.
    GuardRates,
    /// What events set entries of the state to.
    Resets,
    /// g.
    ConstraintValues,
    /// g'.
    ConstraintRates,
    /// G.
    ConstraintMatrix,
}

/// What a function reads.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Reads {
    /// Parameters alone.
    Parameters,
    /// Time, state and parameters.
    Motion,
}

/// Which models have a function.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Of {
    /// All of them.
    Every,
    /// Those with events.
    Events,
    /// Those with constraints.
    Constraints,
}

/// A row of the table.
#[derive(Debug, Clone, Copy)]
pub struct FunctionRow {
    /// Which function it is.
    pub id: FunctionId,
    /// Its name, in the contract and in emitted code.
    pub name: &'static str,
    /// What it computes, in a few signs.
    pub meaning: &'static str,
    /// What it reads.
    pub reads: Reads,
    /// Which models have it.
    pub of: Of,
    /// Its tape.
    pub tape: fn(&Model) -> &Tape,
    /// The nonzeros it computes, of functions that give a matrix.
    pub pattern: Option<fn(&Model) -> &SparsityPattern>,
    /// The matrix itself.
    pub matrix: Option<fn(&Model) -> &MatrixTape>,
    /// How many results it has.
    pub results: fn(&Model) -> usize,
}

/// A row of a function that gives numbers, as many as the last column says; or of one that
/// gives the nonzeros of a matrix.
macro_rules! row {
    ($id:ident $name:ident $reads:ident $of:ident $meaning:literal, $results:expr) => {
        FunctionRow {
            id: FunctionId::$id,
            name: stringify!($name),
            meaning: $meaning,
            reads: Reads::$reads,
            of: Of::$of,
            tape: |model| &model.$name,
            pattern: None,
            matrix: None,
            results: $results,
        }
    };
    (matrix $id:ident $name:ident $of:ident $meaning:literal) => {
        FunctionRow {
            id: FunctionId::$id,
            name: stringify!($name),
            meaning: $meaning,
            reads: Reads::Motion,
            of: Of::$of,
            tape: |model| &model.$name.tape,
            pattern: Some(|model| &model.$name.pattern),
            matrix: Some(|model| &model.$name),
            results: |model| model.$name.pattern.entries.len(),
        }
    };
}

/// Number of functions.
pub const COUNT: usize = 17;

/// Every function, in the order of an emitted module.
#[rustfmt::skip]
pub const FUNCTIONS: [FunctionRow; COUNT] = [
    row!(InitialState initial_state Parameters Every "y at the start", |m| m.states.len()),
    row!(Discontinuities discontinuities Parameters Every "times of jumps", |m| m.discontinuities.results.len()),
    row!(Rate rate Motion Every "y' = [q', M^-1 f, z']", |m| m.states.len()),
    row!(matrix MassMatrix mass_matrix Every "M"),
    row!(Forcing forcing Motion Every "f", |m| m.coordinates.len()),
    row!(matrix RateJacobian rate_jacobian Every "dy'/dy"),
    row!(matrix ParameterJacobian parameter_jacobian Every "dy'/dp"),
    row!(TimeDerivative time_derivative Motion Every "partial y'/partial t", |m| m.states.len()),
    row!(Outputs outputs Motion Every "wanted outputs", |m| m.wanted.len()),
    row!(Energy energy Motion Every "T, V, stored", |_| 3),
    row!(PowerBalance power_balance Motion Every "dE/dt, supplied, dissipated", |_| 3),
    row!(Guards guards Motion Events "what passes zero", |m| m.events.len()),
    row!(GuardRates guard_rates Motion Events "rates of the guards", |m| m.events.len()),
    row!(Resets resets Motion Events "new values", |m| m.events.iter().map(|event| event.sets.len()).sum()),
    row!(ConstraintValues constraint_values Motion Constraints "g", |m| m.constraints.len()),
    row!(ConstraintRates constraint_rates Motion Constraints "g'", |m| m.constraints.len()),
    row!(matrix ConstraintMatrix constraint_matrix Constraints "G = dg'/dq'"),
];

impl FunctionId {
    /// Its row.
    #[must_use]
    pub fn row(self) -> &'static FunctionRow {
        &FUNCTIONS[self as usize]
    }
}

impl FunctionRow {
    /// Whether a model has the function.
    #[must_use]
    pub fn is_of(&self, model: &Model) -> bool {
        match self.of {
            Of::Every => true,
            Of::Events => !model.events.is_empty(),
            Of::Constraints => !model.constraints.is_empty(),
        }
    }
}

impl Model {
    /// The functions it has, in the order of the table.
    pub fn functions(&self) -> impl Iterator<Item = &'static FunctionRow> {
        FUNCTIONS.iter().filter(|row| row.is_of(self))
    }

    /// How a function solves for its results, if it does.
    #[must_use]
    pub fn solve(&self, id: FunctionId) -> Option<&Solve> {
        id.row().matrix.and_then(|matrix| matrix(self).solve.as_ref())
    }

    /// Whether a function goes by what the motion's tape computes.
    #[must_use]
    pub fn reads_motion(&self, id: FunctionId) -> bool {
        let is_read = |tape: &Tape| tape.nodes.iter().any(|node| matches!(node.op, Op::Motion(_)));
        self.motion.is_some() && (self.solve(id).is_some() || is_read(self.tape(id)))
    }

    /// The tape of a function.
    #[must_use]
    pub fn tape(&self, id: FunctionId) -> &Tape {
        (id.row().tape)(self)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_function_is_found_by_its_id() {
        for (index, row) in FUNCTIONS.iter().enumerate() {
            assert_eq!(row.id as usize, index, "{}", row.name);
        }
    }
}

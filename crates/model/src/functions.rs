//! The table of functions of a model: [the contract's](machinist_contract::for_each_function), with
//! the tape of each.
//!
//! Emission, interpretation, validation and cost tables all use it. A new function needs a row in
//! the contract's table and its tape in the [`Model`].

use machinist_contract::for_each_function;

use crate::{MatrixTape, Model, Op, Solve, SparsityPattern, Tape};

/// Arguments of a function.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Reads {
    /// Parameters only.
    Parameters,
    /// Time, state and parameters.
    Motion,
}

/// Models that have a function.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Of {
    /// All models.
    Every,
    /// Models with events.
    Events,
    /// Models with constraints.
    Constraints,
    /// Models whose rate has switching surfaces.
    Kinks,
    /// Models whose rate has functions that saturate.
    Saturations,
}

/// Results of a function, and how emitted code calls it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Gives {
    /// Numbers, as many as the constant of this name.
    Numbers(&'static str),
    /// Numbers, as many as the second name says, in emitted code a struct of the first name.
    Record(&'static str, &'static str),
    /// Values of the nonzeros of the pattern of this name.
    Matrix(&'static str),
    /// A struct of the contract, and its fields.
    Structure(&'static str, &'static [&'static str]),
}

/// A row of the table.
#[derive(Debug, Clone, Copy)]
pub struct FunctionRow {
    /// Identifier of the function.
    pub id: FunctionId,
    /// Name in the contract and in emitted code.
    pub name: &'static str,
    /// Meaning of the results, as a short formula.
    pub meaning: &'static str,
    /// Description in Markdown.
    pub doc: &'static str,
    /// Name of the variant that uses constants computed once a run, if there is one.
    pub prepared: Option<&'static str>,
    /// Arguments.
    pub reads: Reads,
    /// Models that have the function.
    pub of: Of,
    /// Results.
    pub gives: Gives,
    /// Returns its tape.
    pub tape: fn(&Model) -> &Tape,
    /// Returns the pattern of its nonzeros, for functions that give a matrix.
    pub pattern: Option<fn(&Model) -> &SparsityPattern>,
    /// Returns the matrix, for functions that give one.
    pub matrix: Option<fn(&Model) -> &MatrixTape>,
    /// Returns the number of results.
    pub results: fn(&Model) -> usize,
}

/// Returns a count of the model by the name of its constant.
macro_rules! count {
    ($model:ident STATES) => {
        $model.states.len()
    };
    ($model:ident COORDINATES) => {
        $model.coordinates.len()
    };
    ($model:ident DISCONTINUITIES) => {
        $model.discontinuities.results.len()
    };
    ($model:ident OUTPUTS) => {
        $model.wanted.len()
    };
    ($model:ident EVENTS) => {
        $model.events.len()
    };
    ($model:ident RESETS) => {
        $model.events.iter().map(|event| event.sets.len()).sum()
    };
    ($model:ident CONSTRAINTS) => {
        $model.constraints.len()
    };
    ($model:ident KINKS) => {
        $model.kink_guards.results.len()
    };
    ($model:ident SATURATIONS) => {
        $model.saturating_arguments.results.len()
    };
}

macro_rules! prepared {
    () => {
        None
    };
    ($name:ident) => {
        Some(stringify!($name))
    };
}

/// Completes a row with its results: their kind, tape, pattern, matrix and number.
macro_rules! with_result {
    ($row:tt $name:ident [numbers $length:ident]) => {
        with_result!(@ $row Gives::Numbers(stringify!($length)), |m| &m.$name, None, None,
            |m| count!(m $length))
    };
    ($row:tt $name:ident [record $structure:ident $length:ident]) => {
        with_result!(@ $row Gives::Record(stringify!($structure), stringify!($length)),
            |m| &m.$name, None, None, |m| count!(m $length))
    };
    ($row:tt $name:ident [matrix $pattern:ident]) => {
        with_result!(@ $row Gives::Matrix(stringify!($pattern)), |m| &m.$name.tape,
            Some(|m| &m.$name.pattern), Some(|m| &m.$name), |m| m.$name.pattern.entries.len())
    };
    ($row:tt $name:ident [structure $structure:ident $($field:ident)*]) => {
        with_result!(@ $row Gives::Structure(stringify!($structure), &[$(stringify!($field)),*]),
            |m| &m.$name, None, None, |_| [$(stringify!($field)),*].len())
    };
    (@ [
        $id:ident $name:ident $reads:ident $of:ident [$($prepared:ident)?] $meaning:literal
        $doc:literal
    ]
        $gives:expr, $tape:expr, $pattern:expr, $matrix:expr, $results:expr) => {
        FunctionRow {
            id: FunctionId::$id,
            name: stringify!($name),
            meaning: $meaning,
            doc: $doc,
            prepared: prepared!($($prepared)?),
            reads: Reads::$reads,
            of: Of::$of,
            gives: $gives,
            tape: $tape,
            pattern: $pattern,
            matrix: $matrix,
            results: $results,
        }
    };
}

macro_rules! rows {
    (
        []
        every { $({ $id:ident $name:ident $reads:ident $result:tt $prepared:tt
            $meaning:literal $doc:literal })* }
        events { $({ $event_id:ident $event_name:ident $event_reads:ident $event_result:tt
            $event_prepared:tt $event_meaning:literal $event_doc:literal })* }
        constraints { $({ $constraint_id:ident $constraint_name:ident $constraint_reads:ident
            $constraint_result:tt $constraint_prepared:tt $constraint_meaning:literal
            $constraint_doc:literal })* }
        kinks { $({ $kink_id:ident $kink_name:ident $kink_reads:ident $kink_result:tt
            $kink_prepared:tt $kink_meaning:literal $kink_doc:literal })* }
        saturations { $({ $flat_id:ident $flat_name:ident $flat_reads:ident $flat_result:tt
            $flat_prepared:tt $flat_meaning:literal $flat_doc:literal })* }
    ) => {
        /// A function of a model.
        #[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
        pub enum FunctionId {
            $(#[doc = $doc] $id,)*
            $(#[doc = $event_doc] $event_id,)*
            $(#[doc = $constraint_doc] $constraint_id,)*
            $(#[doc = $kink_doc] $kink_id,)*
            $(#[doc = $flat_doc] $flat_id,)*
        }

        /// Number of functions.
        pub const COUNT: usize = [
            $(stringify!($name),)* $(stringify!($event_name),)*
            $(stringify!($constraint_name),)* $(stringify!($kink_name),)*
            $(stringify!($flat_name),)*
        ].len();

        /// Every function, in the order of an emitted module.
        pub const FUNCTIONS: [FunctionRow; COUNT] = [
            $(with_result!([$id $name $reads Every $prepared $meaning $doc] $name $result),)*
            $(with_result!(
                [$event_id $event_name $event_reads Events $event_prepared $event_meaning
                    $event_doc]
                $event_name $event_result
            ),)*
            $(with_result!(
                [$constraint_id $constraint_name $constraint_reads Constraints
                    $constraint_prepared $constraint_meaning $constraint_doc]
                $constraint_name $constraint_result
            ),)*
            $(with_result!(
                [$kink_id $kink_name $kink_reads Kinks $kink_prepared $kink_meaning $kink_doc]
                $kink_name $kink_result
            ),)*
            $(with_result!(
                [$flat_id $flat_name $flat_reads Saturations $flat_prepared $flat_meaning $flat_doc]
                $flat_name $flat_result
            ),)*
        ];
    };
}
for_each_function! { [rows] }

impl FunctionId {
    /// Returns its row.
    #[must_use]
    pub fn row(self) -> &'static FunctionRow {
        &FUNCTIONS[self as usize]
    }
}

impl FunctionRow {
    /// Returns whether a model has the function.
    #[must_use]
    pub fn is_of(&self, model: &Model) -> bool {
        match self.of {
            Of::Every => true,
            Of::Events => !model.events.is_empty(),
            Of::Constraints => !model.constraints.is_empty(),
            Of::Kinks => !model.kink_guards.results.is_empty(),
            Of::Saturations => !model.saturating_arguments.results.is_empty(),
        }
    }
}

impl Model {
    /// Returns the functions of the model, in the order of the table.
    pub fn functions(&self) -> impl Iterator<Item = &'static FunctionRow> {
        FUNCTIONS.iter().filter(|row| row.is_of(self))
    }

    /// Returns the solution step of a function that solves for its results.
    #[must_use]
    pub fn solve(&self, id: FunctionId) -> Option<&Solve> {
        id.row().matrix.and_then(|matrix| matrix(self).solve.as_ref())
    }

    /// Returns whether a function reads results of the motion's tape.
    #[must_use]
    pub fn reads_motion(&self, id: FunctionId) -> bool {
        let is_read = |tape: &Tape| tape.nodes.iter().any(|node| matches!(node.op, Op::Motion(_)));
        self.motion.is_some() && (self.solve(id).is_some() || is_read(self.tape(id)))
    }

    /// Returns whether dy'/dy and dy'/dp by constants are one function, which needs a model without
    /// a motion tape and without fields.
    #[must_use]
    pub fn gives_jacobians_at_once(&self) -> bool {
        self.motion.is_none() && self.fields.is_empty()
    }

    /// Returns the tape of a function.
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

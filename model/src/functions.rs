//! The table of functions of a model: [the contract's](machinist_contract::for_each_function),
//! with the tape of each.
//!
//! Emission, interpretation, checks of a model and tables of costs go by it. A new function
//! is a row of the contract's table, and its tape in the [`Model`].

use machinist_contract::for_each_function;

use crate::{MatrixTape, Model, Op, Solve, SparsityPattern, Tape};

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
    /// Those whose rate has kinks.
    Kinks,
}

/// What a function gives, and how emitted code calls it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Gives {
    /// As many numbers as the constant of this name says.
    Numbers(&'static str),
    /// As many numbers as the second says, in emitted code a struct of this name.
    Record(&'static str, &'static str),
    /// Values of the nonzeros of the pattern of this name.
    Matrix(&'static str),
    /// A struct of the contract, and its fields.
    Structure(&'static str, &'static [&'static str]),
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
    /// What it computes, in Markdown.
    pub doc: &'static str,
    /// The name of the same by constants computed once a run, if there is such.
    pub prepared: Option<&'static str>,
    /// What it reads.
    pub reads: Reads,
    /// Which models have it.
    pub of: Of,
    /// What it gives.
    pub gives: Gives,
    /// Its tape.
    pub tape: fn(&Model) -> &Tape,
    /// The nonzeros it computes, of functions that give a matrix.
    pub pattern: Option<fn(&Model) -> &SparsityPattern>,
    /// The matrix itself.
    pub matrix: Option<fn(&Model) -> &MatrixTape>,
    /// How many results it has.
    pub results: fn(&Model) -> usize,
}

/// Numbers of a model by the names of the constants that hold them.
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
}

macro_rules! prepared {
    () => {
        None
    };
    ($name:ident) => {
        Some(stringify!($name))
    };
}

/// What a function gives, its tape, its pattern and the number of its results.
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
    ) => {
        /// A function of a model.
        #[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
        pub enum FunctionId {
            $(#[doc = $doc] $id,)*
            $(#[doc = $event_doc] $event_id,)*
            $(#[doc = $constraint_doc] $constraint_id,)*
            $(#[doc = $kink_doc] $kink_id,)*
        }

        /// Number of functions.
        pub const COUNT: usize = [
            $(stringify!($name),)* $(stringify!($event_name),)*
            $(stringify!($constraint_name),)* $(stringify!($kink_name),)*
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
        ];
    };
}
for_each_function! { [rows] }

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
            Of::Kinks => !model.kink_guards.results.is_empty(),
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

    /// Whether dy'/dy and dy'/dp by constants are one function: where no motion goes before both,
    /// and no fields add to them.
    #[must_use]
    pub fn gives_jacobians_at_once(&self) -> bool {
        self.motion.is_none() && self.fields.is_empty()
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

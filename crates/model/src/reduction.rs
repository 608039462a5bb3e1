//! Parts of a scene that were left out of a model, with the reasons.

use serde::{Deserialize, Serialize};

/// Parts of a scene that were left out.
#[derive(Debug, Clone, PartialEq, Eq, Default, Serialize, Deserialize)]
pub struct Reduction {
    /// The parts, in the order in which they were left out.
    pub left_out: Vec<LeftOut>,
}

/// One part left out.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct LeftOut {
    /// Kind of the part.
    pub what: What,
    /// Name in the spec.
    pub name: String,
    /// Reason why it is not needed.
    pub why: Why,
    /// Sentence about its replacement, or empty.
    pub instead: String,
}

/// Kinds of parts that are left out.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
pub enum What {
    /// An instance of a unit, with everything in it.
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
    /// A constraint.
    Constraint,
}

/// Reason why a part is not needed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
pub enum Why {
    /// No wanted output depends on it.
    Unreachable,
    /// Only its rate matters, or its difference from another state.
    Cyclic,
    /// The scene fixes its value.
    Fixed,
    /// The scene fixes it at zero, and its terms vanish.
    Zero,
    /// The scene freezes it: an approximation.
    Frozen,
    /// It follows from others.
    Redundant,
}

impl Reduction {
    /// Adds a part.
    pub fn add(&mut self, what: What, name: &str, why: Why, instead: impl Into<String>) {
        let (name, instead) = (name.to_owned(), instead.into());
        self.left_out.push(LeftOut { what, name, why, instead });
    }
}

impl What {
    /// Returns one word for messages.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            What::Unit => "unit",
            What::State => "state",
            What::Parameter => "parameter",
            What::Table => "table",
            What::Jump => "jump",
            What::Helper => "helper",
            What::Constraint => "constraint",
        }
    }
}

impl Why {
    /// Returns one word for messages.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Why::Unreachable => "unreachable",
            Why::Cyclic => "cyclic",
            Why::Fixed => "fixed",
            Why::Zero => "zero",
            Why::Frozen => "frozen",
            Why::Redundant => "redundant",
        }
    }
}

//! What was left out of a model, and why.

use serde::{Deserialize, Serialize};

/// What was left out of a scene.
#[derive(Debug, Clone, PartialEq, Eq, Default, Serialize, Deserialize)]
pub struct Reduction {
    /// Each thing, in the order in which it was left out.
    pub left_out: Vec<LeftOut>,
}

/// One thing left out.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
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
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
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
    /// A constraint.
    Constraint,
}

/// Why something is not needed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
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
    /// It follows from others.
    Redundant,
}

impl Reduction {
    /// Notes one more thing.
    pub fn add(&mut self, what: What, name: &str, why: Why, instead: impl Into<String>) {
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
            What::Constraint => "constraint",
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
            Why::Redundant => "redundant",
        }
    }
}

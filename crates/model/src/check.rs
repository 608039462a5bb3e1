//! Checks of the runs of a model against references. They take no part in the machine.

use serde::{Deserialize, Serialize};

use crate::evaluate::{Evaluator, Inputs};
use crate::{Table, Tape};

/// A quantity of a run with its reference.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Check {
    /// Name of the check.
    pub name: String,
    /// The output or state that is checked.
    pub of: String,
    /// SI unit of the quantity.
    pub unit: String,
    /// Origin of the reference, in one line.
    pub source: String,
    /// Largest accepted error, relative to the largest value of the reference.
    pub tolerance: f64,
    /// Largest accepted error in the unit, in addition to the relative one.
    pub absolute: Option<f64>,
    /// Expected values.
    pub reference: Reference,
}

/// Expected values of a quantity.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub enum Reference {
    /// An expression, evaluated at the times of output.
    Closed(ClosedForm),
    /// Times, increasing \[s\], and values.
    Values(Vec<[f64; 2]>),
}

/// An expression of time and parameters.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct ClosedForm {
    /// Text of the expression in the spec.
    pub text: String,
    /// One result.
    pub tape: Tape,
    /// Tables that the tape refers to.
    pub tables: Vec<Table>,
}

impl ClosedForm {
    /// Returns its values at the given times, with the given parameters.
    #[must_use]
    pub fn values(&self, times: &[f64], parameters: &[f64]) -> Vec<f64> {
        let evaluator = Evaluator::new(&self.tape);
        let value = |time: &f64| {
            let mut result = [0.0];
            let tables = &self.tables;
            let inputs = Inputs { time: *time, parameters, tables, ..Inputs::default() };
            evaluator.evaluate(&inputs, &mut result);
            result[0]
        };
        times.iter().map(value).collect()
    }
}

//! What the runs of a model are held against. It takes no part in the machine.

use serde::{Deserialize, Serialize};

use crate::evaluate::{Evaluator, Inputs};
use crate::{Table, Tape};

/// A quantity of a run with what it should be.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Check {
    /// What it is called.
    pub name: String,
    /// The output or state that is checked.
    pub of: String,
    /// Its SI unit.
    pub unit: String,
    /// Where the reference is from, in one line.
    pub source: String,
    /// Largest error that passes, relative to the largest size of the reference.
    pub tolerance: f64,
    /// Largest error that passes beside that, in the unit.
    pub absolute: Option<f64>,
    /// What the quantity should be.
    pub reference: Reference,
}

/// What a quantity should be.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub enum Reference {
    /// An expression, at the times of output.
    Closed(ClosedForm),
    /// Times, increasing \[s\], and values.
    Values(Vec<[f64; 2]>),
}

/// An expression of time and parameters.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct ClosedForm {
    /// As the spec writes it.
    pub text: String,
    /// One result.
    pub tape: Tape,
    /// Tables that the tape refers to.
    pub tables: Vec<Table>,
}

impl ClosedForm {
    /// Its values at these times, with the parameters of the model.
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

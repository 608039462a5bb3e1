//! Tapes run as they are, in `f64`.
//!
//! Excluded: names, compilation. The order of operations is that of the emitted
//! Rust, so that both agree bit for bit.

use machinist_scenes::{CubicTable, Real};

use crate::emit::needed_nodes;
use crate::expr::Function;
use crate::system::Table;
use crate::tape::{NodeId, Op, Tape};

/// A tape with room for its values: evaluating it allocates nothing.
#[derive(Debug, Clone)]
pub struct Evaluator {
    /// The operations results need, each reading values before its own.
    operations: Vec<Op>,
    results: Vec<NodeId>,
    values: Vec<f64>,
}

impl Evaluator {
    /// Prepares a tape; nodes that no result needs are left out.
    #[must_use]
    pub fn new(tape: &Tape) -> Self {
        let mut operations = Vec::new();
        let mut moved = vec![NodeId(0); tape.nodes.len()];
        for (index, needed) in needed_nodes(tape).into_iter().enumerate() {
            if needed {
                moved[index] = NodeId(operations.len() as u32);
                operations.push(tape.nodes[index].op.with_operands(|id| moved[id.0 as usize]));
            }
        }
        let results = tape.results.iter().map(|id| moved[id.0 as usize]).collect();
        let values = vec![0.0; operations.len()];
        Self { operations, results, values }
    }

    /// Number of results.
    #[must_use]
    pub fn results(&self) -> usize {
        self.results.len()
    }

    /// Writes the tape's results.
    ///
    /// # Panics
    /// If `results` is not as long as the tape's results, or if `state`,
    /// `parameters` or `tables` lack an entry the tape reads.
    pub fn evaluate(
        &mut self,
        time: f64,
        state: &[f64],
        parameters: &[f64],
        tables: &[Table],
        results: &mut [f64],
    ) {
        for (index, op) in self.operations.iter().enumerate() {
            let value = |id: NodeId| self.values[id.0 as usize];
            let inputs = Inputs { time, state, parameters, tables };
            self.values[index] = operate(*op, value, &inputs);
        }
        assert_eq!(results.len(), self.results.len(), "one place for each result");
        for (result, id) in results.iter_mut().zip(&self.results) {
            *result = self.values[id.0 as usize];
        }
    }
}

/// What a tape reads from outside.
pub(crate) struct Inputs<'a> {
    pub(crate) time: f64,
    pub(crate) state: &'a [f64],
    pub(crate) parameters: &'a [f64],
    pub(crate) tables: &'a [Table],
}

/// One operation on operands whose values are known.
pub(crate) fn operate(op: Op, value: impl Fn(NodeId) -> f64, inputs: &Inputs<'_>) -> f64 {
    match op {
        Op::Literal(literal) => literal,
        Op::Time => inputs.time,
        Op::State(entry) => inputs.state[entry as usize],
        Op::Parameter(entry) => inputs.parameters[entry as usize],
        Op::Neg(a) => -value(a),
        Op::Add(a, b) => value(a) + value(b),
        Op::Sub(a, b) => value(a) - value(b),
        Op::Mul(a, b) => value(a) * value(b),
        Op::Div(a, b) => value(a) / value(b),
        Op::Powi(base, exponent) => Real::powi(value(base), exponent),
        Op::Powf(base, exponent) => value(base).powf(value(exponent)),
        Op::Call(function, argument) => call(function, value(argument)),
        Op::SelectLess { lhs, rhs, then, otherwise } => {
            if value(lhs) < value(rhs) {
                value(then)
            } else {
                value(otherwise)
            }
        }
        Op::Table { table, order, argument } => {
            interpolate(&inputs.tables[table.0 as usize], order, value(argument))
        }
    }
}

/// A function of one argument; `SelectLess` and `Table` have operations of their
/// own and are not numbers here.
pub(crate) fn call(function: Function, x: f64) -> f64 {
    match function {
        Function::Sqrt => x.sqrt(),
        Function::Abs => x.abs(),
        Function::Exp => Real::exp(x),
        Function::Ln => x.ln(),
        Function::Sin => Real::sin(x),
        Function::Cos => Real::cos(x),
        Function::Tan => x.tan(),
        Function::Asin => x.asin(),
        Function::Acos => x.acos(),
        Function::Atan => x.atan(),
        Function::Sinh => x.sinh(),
        Function::Cosh => x.cosh(),
        Function::Tanh => Real::tanh(x),
        Function::SelectLess | Function::Table { .. } => f64::NAN,
    }
}

/// Value or derivative of a table, constant beyond its ends.
pub(crate) fn interpolate(table: &Table, order: u32, x: f64) -> f64 {
    let Table { knots, coefficients, .. } = table;
    CubicTable { knots, coefficients }.search(order, x)
}

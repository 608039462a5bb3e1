//! Interpretation of tapes, in `f64` or another number type.
//!
//! Excluded: names, compilation. The order of operations is that of the emitted Rust, so that both
//! agree bit for bit.

use machinist_contract::{CubicTable, Real};

use crate::room::with_room;
use crate::{Function, NodeId, Op, Table, Tape, needed_nodes};

/// Inputs of tapes.
#[derive(Debug, Default, Clone, Copy)]
pub struct Inputs<'a, R = f64> {
    /// t.
    pub time: R,
    /// y.
    pub state: &'a [R],
    /// p, followed by the values that fields hand over and the slots if tapes read slots.
    pub parameters: &'a [R],
    /// Values that fields hand over.
    pub handed: &'a [R],
    /// Results of the tape of constants.
    pub constants: &'a [R],
    /// Results of the motion's tape.
    pub motion: &'a [R],
    /// Tables of the model.
    pub tables: &'a [Table],
}

/// A tape to interpret. An evaluation allocates nothing, except for memory that later evaluations
/// of the same thread reuse.
#[derive(Debug, Clone)]
pub struct Evaluator {
    /// Operations that results need, each of which reads earlier values.
    operations: Vec<Op>,
    results: Vec<NodeId>,
}

impl Evaluator {
    /// Prepares a tape, without the nodes that no result needs.
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
        Self { operations, results }
    }

    /// Returns the number of results.
    #[must_use]
    pub fn results(&self) -> usize {
        self.results.len()
    }

    /// Writes the tape's results.
    ///
    /// # Panics
    /// If `results` is not as long as the tape's results, or if `inputs` lack an entry that the
    /// tape reads.
    pub fn evaluate(&self, inputs: &Inputs<'_>, results: &mut [f64]) {
        with_room(self.operations.len(), |values| self.evaluate_in(values, inputs, results));
    }

    /// Returns the number of values that [`Evaluator::evaluate_in`] needs memory for.
    #[must_use]
    pub fn room(&self) -> usize {
        self.operations.len()
    }

    /// Does the same as [`Evaluator::evaluate`] on any number type, in memory of the caller.
    ///
    /// # Panics
    /// As [`Evaluator::evaluate`], and if `values` is shorter than [`Evaluator::room`].
    pub fn evaluate_in<R: Real>(
        &self,
        values: &mut [R],
        inputs: &Inputs<'_, R>,
        results: &mut [R],
    ) {
        for (index, op) in self.operations.iter().enumerate() {
            let value = |id: NodeId| values[id.0 as usize];
            values[index] = operate(*op, value, inputs);
        }
        assert_eq!(results.len(), self.results.len(), "one place for each result");
        for (result, id) in results.iter_mut().zip(&self.results) {
            *result = values[id.0 as usize];
        }
    }
}

/// Computes one operation on operands whose values are known.
#[inline]
#[must_use]
pub fn operate<R: Real>(op: Op, value: impl Fn(NodeId) -> R, inputs: &Inputs<'_, R>) -> R {
    match op {
        Op::Literal(literal) => R::literal(literal),
        Op::Time => inputs.time,
        Op::State(entry) => inputs.state[entry as usize],
        Op::Parameter(entry) | Op::Held(entry) => inputs.parameters[entry as usize],
        Op::Handed(entry) => inputs.handed[entry as usize],
        Op::Constant(entry) => inputs.constants[entry as usize],
        Op::Motion(entry) => inputs.motion[entry as usize],
        Op::Neg(a) => -value(a),
        Op::Add(a, b) => value(a) + value(b),
        Op::Sub(a, b) => value(a) - value(b),
        Op::Mul(a, b) => value(a) * value(b),
        Op::Div(a, b) => value(a) / value(b),
        Op::Powi(base, exponent) => value(base).powi(exponent),
        Op::Powf(base, exponent) => value(base).powf(value(exponent)),
        Op::Call(function, argument) => call(function, value(argument)),
        Op::SelectLess { lhs, rhs, then, otherwise } => {
            R::select_less(value(lhs), value(rhs), value(then), value(otherwise))
        }
        Op::Table { table, order, argument } => {
            interpolate(&inputs.tables[table.0 as usize], order, value(argument))
        }
    }
}

/// Computes a function of one argument, as the contract does.
#[must_use]
pub fn call<R: Real>(function: Function, x: R) -> R {
    match function {
        Function::Sqrt => x.sqrt(),
        Function::Abs => x.abs(),
        Function::Floor => x.floor(),
        Function::Exp => x.exp(),
        Function::Ln => x.ln(),
        Function::Sin => x.sin(),
        Function::Cos => x.cos(),
        Function::Tan => x.tan(),
        Function::Asin => x.asin(),
        Function::Acos => x.acos(),
        Function::Atan => x.atan(),
        Function::Sinh => x.sinh(),
        Function::Cosh => x.cosh(),
        Function::Tanh => x.tanh(),
    }
}

/// Returns the value or a derivative of a table, extended as a constant beyond its ends.
#[must_use]
pub fn interpolate<R: Real>(table: &Table, order: u32, x: R) -> R {
    let Table { knots, coefficients, .. } = table;
    CubicTable { knots, coefficients }.evaluate(order, x)
}

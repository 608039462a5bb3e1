//! Operations of functions on dual numbers, by which the filter in Rust differentiates.

use machinist_contract::Dual;
use machinist_model::functions::FunctionId;
use machinist_model::{Function, Model, Op, Tape, needed_nodes};

use crate::emit::c99::estimator::CarriedFunction;

/// A product or quotient, with the comparison that keeps what does not move at zero, in each
/// direction.
const CHAIN: usize = 2 * Dual::DIRECTIONS;

/// Returns the operations of a function of the machine on dual numbers.
pub(super) fn on_duals(model: &Model, function: CarriedFunction) -> usize {
    let id = match function {
        CarriedFunction::Measured => FunctionId::Outputs,
        CarriedFunction::Guards => FunctionId::Guards,
        CarriedFunction::Resets => FunctionId::Resets,
        CarriedFunction::ConstraintValues => FunctionId::ConstraintValues,
        CarriedFunction::ConstraintRates => FunctionId::ConstraintRates,
        CarriedFunction::RateJacobian => FunctionId::RateJacobian,
        CarriedFunction::TimeDerivative => FunctionId::TimeDerivative,
    };
    let row = model.functions().find(|row| row.id == id);
    let own = row.map_or(0, |row| of_tape((row.tape)(model)));
    let motion = model.motion.as_ref().filter(|_| model.reads_motion(id));
    let solved = model.solve(id).map_or(0, |solve| {
        let of_step = |step: &machinist_model::SolveStep| {
            let scaled = usize::from(step.scale.is_some()) * PRODUCT;
            scaled + step.terms.len() * (PRODUCT + SUM)
        };
        solve.columns as usize * solve.steps.iter().map(of_step).sum::<usize>()
    });
    own + solved + motion.map_or(0, |motion| of_tape(&motion.tape))
}

/// A sum, difference or change of sign.
const SUM: usize = 1 + Dual::DIRECTIONS;
/// A product or quotient: its value, and two products and a sum in each direction.
const PRODUCT: usize = 1 + 3 * Dual::DIRECTIONS;

fn of_tape(tape: &Tape) -> usize {
    let needed = tape.nodes.iter().zip(needed_nodes(tape)).filter(|(_, needed)| *needed);
    needed.map(|(node, _)| of_operation(&node.op)).sum()
}

/// Returns the operations of [`Dual`] for an operation of a tape.
fn of_operation(op: &Op) -> usize {
    match op {
        Op::Neg(_) | Op::Add(..) | Op::Sub(..) => SUM,
        Op::Mul(..) | Op::Div(..) => PRODUCT,
        // Two powers and a factor.
        Op::Powi(..) => 2 + 1 + CHAIN,
        // Two powers, a logarithm, a difference and two products; the sum of both parts.
        Op::Powf(..) => 3 + 3 + 2 * CHAIN + Dual::DIRECTIONS,
        Op::SelectLess { .. } => 1,
        Op::Table { .. } => 2 + CHAIN,
        Op::Call(function, _) => of_function(*function),
        _ => 0,
    }
}

/// Returns the operations of a function: its value, its derivative, and the chain rule.
fn of_function(function: Function) -> usize {
    match function {
        Function::Floor => 1,
        // A comparison, and a change of signs.
        Function::Abs => 1 + SUM,
        Function::Exp => 1 + CHAIN,
        Function::Ln | Function::Sqrt | Function::Sinh | Function::Cosh => 2 + CHAIN,
        // Sine and cosine are computed together, and a sign.
        Function::Sin | Function::Cos => 3 + 2 * CHAIN,
        Function::Tan | Function::Atan | Function::Tanh => 4 + CHAIN,
        Function::Asin | Function::Acos => 6 + CHAIN,
    }
}

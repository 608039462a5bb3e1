//! Names for intermediate values, formed from the names of their operands.

use machinist_model::{NodeId, Op, Tape};

/// Length beyond which a name is no better than a number.
pub(crate) const LONGEST_NAME: usize = 36;

/// Returns a descriptive name for the value of an operation, if its operands have names, which
/// `word` returns.
pub(crate) fn describe(
    tape: &Tape,
    op: &Op,
    word: impl Fn(NodeId) -> Option<String>,
) -> Option<String> {
    let joined = |a, between, b| Some(format!("{}_{between}_{}", word(a)?, word(b)?));
    match *op {
        Op::Call(function, a) => Some(format!("{}_{}", function.name(), word(a)?)),
        Op::Neg(a) => Some(format!("minus_{}", word(a)?)),
        Op::Powi(a, -1) => Some(format!("inverse_{}", word(a)?)),
        Op::Powi(a, 2) => Some(format!("{}_squared", word(a)?)),
        Op::Powi(a, 3) => Some(format!("{}_cubed", word(a)?)),
        Op::Mul(a, b) if a == b => Some(format!("{}_squared", word(a)?)),
        Op::Mul(a, b) => joined(a, "times", b),
        Op::Add(a, b) => joined(a, "plus", b),
        Op::Sub(a, b) => joined(a, "minus", b),
        Op::Div(a, b) if tape[a].op == Op::Literal(1.0) => Some(format!("inverse_{}", word(b)?)),
        Op::Div(a, b) => joined(a, "over", b),
        _ => None,
    }
}

/// Reports whether a name is a numbered one of our own.
pub(crate) fn is_temporary(name: &str) -> bool {
    name.strip_prefix('t').is_some_and(|rest| rest.parse::<u32>().is_ok())
}

//! One operation of a tape as a C expression.

use machinist_model::{Function, NodeId, Op, TableId};

use super::Real;
use super::body::Scope;
use crate::emit::EmitError;

/// Binding strength of an expression, weakest first.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Strength {
    Sum,
    Product,
    Minus,
    Call,
}

/// An expression.
#[derive(Debug, Clone)]
pub(super) struct Written {
    pub(super) text: String,
    pub(super) strength: Strength,
}

impl Written {
    /// Returns a name, a call, or anything else that binds as tightly.
    pub(super) fn call(text: impl Into<String>) -> Self {
        Self { text: text.into(), strength: Strength::Call }
    }

    /// Returns the text, in parentheses if it binds more weakly than `least`.
    pub(super) fn at_least(self, least: Strength) -> String {
        if self.strength < least { format!("({})", self.text) } else { self.text }
    }

    /// Returns `a operator b`. All four operators associate to the left, so the right operand
    /// needs the greater strength.
    fn infix(a: Self, operator: char, b: Self, [left, right]: [Strength; 2]) -> Self {
        let text = format!("{} {operator} {}", a.at_least(left), b.at_least(right));
        Self { text, strength: left }
    }
}

const SUM: [Strength; 2] = [Strength::Sum, Strength::Product];
const PRODUCT: [Strength; 2] = [Strength::Product, Strength::Minus];

/// Returns the expression of an operation, given those of its operands. `scope` names values read
/// from outside.
pub(super) fn operation(
    op: &Op,
    scope: &Scope<'_>,
    operand: &mut dyn FnMut(NodeId) -> Result<Written, EmitError>,
) -> Result<Written, EmitError> {
    Ok(match *op {
        Op::Literal(value) => literal(value, scope.real, scope.function)?,
        Op::Time => Written::call("time"),
        Op::State(entry) => Written::call(&*scope.states[entry as usize]),
        Op::Parameter(entry) => scope.parameters[entry as usize].clone(),
        Op::Constant(entry) => Written::call(format!("c->{}", scope.constants[entry as usize])),
        Op::Motion(entry) => Written::call(&*scope.motion[entry as usize]),
        Op::Handed(_) => return Err(super::fields_are_unsupported(scope.function)),
        Op::Held(_) => unreachable!("emitted C holds no relations"),
        Op::Neg(a) => {
            let text = format!("-{}", operand(a)?.at_least(Strength::Call));
            Written { text, strength: Strength::Minus }
        }
        Op::Add(a, b) => Written::infix(operand(a)?, '+', operand(b)?, SUM),
        Op::Sub(a, b) => Written::infix(operand(a)?, '-', operand(b)?, SUM),
        Op::Mul(a, b) => Written::infix(operand(a)?, '*', operand(b)?, PRODUCT),
        Op::Div(a, b) => Written::infix(operand(a)?, '/', operand(b)?, PRODUCT),
        Op::Powi(base, exponent) => {
            Written::call(format!("{}({})", power_name(exponent), operand(base)?.text))
        }
        Op::Powf(base, exponent) => {
            let name = scope.real.function("pow");
            Written::call(format!("{name}({}, {})", operand(base)?.text, operand(exponent)?.text))
        }
        Op::Call(function, a) => {
            let name = function_name(function, scope.real);
            Written::call(format!("{name}({})", operand(a)?.text))
        }
        Op::SelectLess { lhs, rhs, then, otherwise } => {
            // A conditional binds more weakly than any operator within or around it.
            let [lhs, rhs] =
                [operand(lhs)?, operand(rhs)?].map(|side| side.at_least(Strength::Sum));
            let [then, otherwise] = [operand(then)?, operand(otherwise)?].map(|side| side.text);
            Written::call(format!("(({lhs} < {rhs}) ? ({then}) : ({otherwise}))"))
        }
        Op::Table { table: TableId(table), order, argument } => {
            let table = &scope.tables[table as usize];
            Written::call(format!("interpolate(&{table}, {order}u, {})", operand(argument)?.text))
        }
    })
}

/// Returns a number as a literal that C reads back exactly.
pub(super) fn literal(value: f64, real: Real, place: &str) -> Result<Written, EmitError> {
    let text = real
        .literal(value)
        .ok_or_else(|| EmitError::NotFinite { place: format!("function `{place}`"), value })?;
    let strength = if text.starts_with('-') { Strength::Minus } else { Strength::Call };
    Ok(Written { text, strength })
}

/// Returns the name of the helper that computes an integer power.
pub(super) fn power_name(exponent: i32) -> String {
    let size = exponent.unsigned_abs();
    if exponent < 0 { format!("inverse_power_{size}") } else { format!("power_{size}") }
}

/// Returns the name of a function in emitted C: ours if the contract has its own in double
/// precision, else that of the standard library.
pub(super) fn function_name(function: Function, real: Real) -> String {
    let ours = real == Real::Double;
    match function {
        Function::Sin if ours => "sine".to_owned(),
        Function::Cos if ours => "cosine".to_owned(),
        Function::Exp if ours => "exponential".to_owned(),
        Function::Tanh if ours => "hyperbolic_tangent".to_owned(),
        Function::Abs => real.function("fabs"),
        Function::Ln => real.function("log"),
        other => real.function(other.name()),
    }
}

//! Evaluation of an expression of parameters at their values in the spec.

use machinist_algebra::expr::{Expr, Function, ParameterId, Symbol};
use num_traits::ToPrimitive as _;

use machinist_model::evaluate::call;

/// Evaluates an expression; NaN if it depends on anything but parameters.
pub fn evaluate(expr: &Expr, parameter: &impl Fn(ParameterId) -> f64) -> f64 {
    let value = |expr: &Expr| evaluate(expr, parameter);
    match expr {
        Expr::Number(number) => number.to_f64().unwrap_or(f64::NAN),
        Expr::Symbol(Symbol::Parameter(id)) => parameter(*id),
        Expr::Symbol(Symbol::Pi) => std::f64::consts::PI,
        Expr::Symbol(_) => f64::NAN,
        Expr::Shared(shared) => value(shared.definition()),
        Expr::Sum(terms) => terms.iter().map(value).sum(),
        Expr::Product(factors) => factors.iter().map(value).product(),
        Expr::Power(base, exponent) => value(base).powf(value(exponent)),
        Expr::Call(Function::SelectLess, arguments) => match arguments.as_slice() {
            [a, b, then, otherwise] => value(if value(a) < value(b) { then } else { otherwise }),
            _ => f64::NAN,
        },
        Expr::Call(function, arguments) => match (function.unary(), arguments.as_slice()) {
            (Some(function), [argument]) => call(function, value(argument)),
            _ => f64::NAN,
        },
    }
}

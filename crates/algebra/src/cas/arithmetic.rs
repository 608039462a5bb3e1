//! Arithmetic on expressions in the normal form of our own algebra, without a session.
//!
//! It serves to build shared parts, whose definitions are small: zeros, ones and signs fold away,
//! but nothing is expanded or factored. Arguments that are not in normal form give correct results
//! that fold less.

use super::plain::{derivative_of, normal};
use crate::expr::{Expr, Function, Symbol};

/// Returns the sum of terms.
#[must_use]
pub fn sum(terms: impl IntoIterator<Item = Expr>) -> Expr {
    normal::sum(terms)
}

/// Returns the product of factors.
#[must_use]
pub fn product(factors: impl IntoIterator<Item = Expr>) -> Expr {
    normal::product(factors)
}

/// Returns -x.
#[must_use]
pub fn negative(x: &Expr) -> Expr {
    normal::product([Expr::integer(-1), x.clone()])
}

/// Returns f(x) of a function of one argument.
#[must_use]
pub fn call(function: Function, x: &Expr) -> Expr {
    normal::call(function, vec![x.clone()])
}

/// Returns the normal form of an expression.
#[must_use]
pub fn normal_form(expr: &Expr) -> Expr {
    // Expressions without a value are reported when the equations are derived.
    normal::normal(expr, &mut false)
}

/// Returns the partial derivative by a symbol.
#[must_use]
pub fn derivative(expr: &Expr, by: Symbol) -> Expr {
    derivative_of(expr, by)
}

//! Algebra on our own expressions: normal forms, derivatives, expansion of products, common
//! factors.
//!
//! It needs nothing but this crate, and its cost is nearly linear in the size of the result. Only
//! Symbolica factors polynomials and puts quotients over one denominator.

mod collect;
mod derivative;
mod expand;
pub(super) mod normal;

use num_rational::BigRational;

use super::Form;
use crate::expr::{Expr, Symbol};

pub(super) use collect::collect;
pub(super) use derivative::derivative as derivative_of;
pub(super) use expand::expand;

/// An expression in normal form; see [`normal`].
#[derive(Clone)]
pub(super) struct Plain(pub(super) Expr);

impl Plain {
    /// Converts an expression to normal form; sets `undefined` if a part of it divides by zero or
    /// is the logarithm of zero.
    pub(super) fn of(expr: &Expr, undefined: &mut bool) -> Self {
        Plain(normal::normal(expr, undefined))
    }

    pub(super) fn zero() -> Self {
        Plain(Expr::integer(0))
    }

    pub(super) fn derivative(&self, symbol: Symbol) -> Self {
        Plain(derivative::derivative(&self.0, symbol))
    }

    /// Returns the number of leaves and operations, without sharing.
    pub(super) fn size(&self) -> usize {
        let mut size = 0;
        self.0.visit(&mut |_| size += 1);
        size
    }

    /// Returns the terms of a sum, or the form itself.
    pub(super) fn terms(&self) -> Vec<Form> {
        let terms = match &self.0 {
            Expr::Sum(terms) => terms.as_slice(),
            other => std::slice::from_ref(other),
        };
        terms.iter().map(|term| Form::from(Plain(term.clone()))).collect()
    }

    pub(super) fn sum(parts: impl IntoIterator<Item = Plain>) -> Self {
        Plain(normal::sum(parts.into_iter().map(|part| part.0)))
    }

    pub(super) fn add(&self, other: &Self) -> Self {
        Plain::sum([self.clone(), other.clone()])
    }

    pub(super) fn sub(&self, other: &Self) -> Self {
        self.add(&other.neg())
    }

    pub(super) fn mul(&self, other: &Self) -> Self {
        Plain(normal::product([self.0.clone(), other.0.clone()]))
    }

    pub(super) fn div(&self, other: &Self) -> Self {
        let inverse = normal::power(other.0.clone(), Expr::integer(-1));
        Plain(normal::product([self.0.clone(), inverse]))
    }

    pub(super) fn neg(&self) -> Self {
        let minus_one = BigRational::from_integer((-1).into());
        Plain(normal::product([Expr::Number(minus_one), self.0.clone()]))
    }
}

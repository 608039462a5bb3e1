//! Interface to Symbolica. Only this module and its children name it.

mod convert;
mod functions;

use symbolica::atom::{Atom, AtomCore as _, AtomView};

use super::Form;
use crate::expr::{Expr, Symbol};
pub(in crate::cas) use functions::Vocabulary;

/// An expression of Symbolica.
#[derive(Clone)]
pub(super) struct Known(Atom);

impl Known {
    pub(super) fn of(vocabulary: &mut Vocabulary, expr: &Expr) -> Self {
        Known(convert::to_atom(vocabulary, expr))
    }

    pub(super) fn expr(&self, vocabulary: &Vocabulary) -> Expr {
        convert::to_expr(vocabulary, self.0.as_view())
    }

    pub(super) fn zero() -> Self {
        Known(Atom::new())
    }

    pub(super) fn is_zero(&self) -> bool {
        self.0.is_zero()
    }

    pub(super) fn derivative(&self, vocabulary: &mut Vocabulary, symbol: Symbol) -> Self {
        Known(self.0.derivative(vocabulary.variable(symbol)))
    }

    pub(super) fn expand(&self) -> Self {
        Known(self.0.expand())
    }

    pub(super) fn collect(&self) -> Self {
        Known(self.0.collect_factors())
    }

    /// Returns one quotient of polynomials with common factors cancelled.
    pub(super) fn rational(&self) -> Self {
        Known(self.0.together().cancel())
    }

    pub(super) fn size(&self) -> usize {
        self.0.as_view().get_byte_size()
    }

    /// Returns the terms of a sum, or the form itself.
    pub(super) fn terms(&self) -> Vec<Form> {
        match self.0.as_view() {
            AtomView::Add(sum) => {
                sum.iter().map(|term| Form::from(Known(term.to_owned()))).collect()
            }
            _ => vec![Form::from(self.clone())],
        }
    }

    pub(super) fn sum(parts: impl Iterator<Item = Known>) -> Self {
        Known(convert::sum(parts.map(|part| part.0).collect()))
    }

    pub(super) fn add(&self, other: &Self) -> Self {
        Known(&self.0 + &other.0)
    }

    pub(super) fn sub(&self, other: &Self) -> Self {
        Known(&self.0 - &other.0)
    }

    pub(super) fn mul(&self, other: &Self) -> Self {
        Known(&self.0 * &other.0)
    }

    pub(super) fn div(&self, other: &Self) -> Self {
        Known(&self.0 / &other.0)
    }

    pub(super) fn neg(&self) -> Self {
        Known(-&self.0)
    }
}

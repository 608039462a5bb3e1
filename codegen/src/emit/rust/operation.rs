//! One operation as an expression, shared by bodies and series.

use proc_macro2::{Literal, TokenStream};
use quote::{ToTokens as _, format_ident, quote};

use super::body::{Reads, Scope};
use crate::emit::EmitError;
use crate::emit::literal::constant_or_literal;
use machinist_model::{NodeId, Op, TableId};

/// Binding strength of an expression, weakest first.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Strength {
    Sum,
    Product,
    Minus,
    Call,
}

/// An expression.
pub(super) struct Written {
    pub(super) tokens: TokenStream,
    pub(super) strength: Strength,
}

impl Written {
    /// Returns a name, a call, or anything else that binds as tightly.
    pub(super) fn call(tokens: TokenStream) -> Self {
        Self { tokens, strength: Strength::Call }
    }

    /// Returns the negation of an expression.
    pub(super) fn minus(self) -> Self {
        let a = self.at_least(Strength::Call);
        Self { tokens: quote!(-#a), strength: Strength::Minus }
    }

    /// Returns the tokens, in parentheses if they bind more weakly than `least`.
    pub(super) fn at_least(self, least: Strength) -> TokenStream {
        let tokens = self.tokens;
        if self.strength < least { quote!((#tokens)) } else { tokens }
    }

    /// Returns `a operator b`. The right operand needs the greater strength, because all four
    /// operators associate to the left.
    fn infix(a: Self, operator: &TokenStream, b: Self, left: Strength, right: Strength) -> Self {
        let (a, b) = (a.at_least(left), b.at_least(right));
        Self { tokens: quote!(#a #operator #b), strength: left }
    }

    pub(super) fn plus(self, b: Self) -> Self {
        Self::infix(self, &quote!(+), b, Strength::Sum, Strength::Product)
    }

    pub(super) fn less(self, b: Self) -> Self {
        Self::infix(self, &quote!(-), b, Strength::Sum, Strength::Product)
    }

    pub(super) fn times(self, b: Self) -> Self {
        Self::infix(self, &quote!(*), b, Strength::Product, Strength::Minus)
    }

    pub(super) fn over(self, b: Self) -> Self {
        Self::infix(self, &quote!(/), b, Strength::Product, Strength::Minus)
    }
}

/// A writer of consecutive expressions.
pub(super) trait Expressions {
    /// Returns the expression for a node.
    fn operand(&mut self, id: NodeId) -> Result<Written, EmitError>;
    /// Returns the names that may be used.
    fn scope(&self) -> &Scope<'_>;
    /// Returns the record of names that were used.
    fn reads(&mut self) -> &mut Reads;
    /// Returns the name of the function.
    fn function(&self) -> &'static str;

    /// Returns the expression of an operation, given those of its operands.
    fn operation(&mut self, op: &Op) -> Result<Written, EmitError> {
        let name = match *op {
            Op::Literal(value) => return self.literal(value),
            Op::Time => {
                self.reads().time = true;
                quote!(time)
            }
            Op::State(entry) => {
                self.reads().state.insert(entry as usize);
                self.scope().states[entry as usize].to_token_stream()
            }
            Op::Parameter(_) | Op::Handed(_) | Op::Held(_) => {
                self.reads().parameters = true;
                let name = self.scope().given(op);
                quote!(p.#name)
            }
            Op::Constant(_) if self.scope().is_in_loop => self.scope().given(op).to_token_stream(),
            Op::Constant(_) => {
                self.reads().constants = true;
                let name = self.scope().given(op);
                quote!(c.#name)
            }
            Op::Motion(entry) => {
                self.reads().motion = true;
                self.scope().motion[entry as usize].clone()
            }
            _ => return self.arithmetic(op),
        };
        Ok(Written::call(name))
    }

    /// Returns the expression of an operation that computes a value.
    fn arithmetic(&mut self, op: &Op) -> Result<Written, EmitError> {
        Ok(match *op {
            Op::Neg(a) => self.operand(a)?.minus(),
            Op::Add(a, b) => self.operand(a)?.plus(self.operand(b)?),
            Op::Sub(a, b) => self.operand(a)?.less(self.operand(b)?),
            Op::Mul(a, b) => self.operand(a)?.times(self.operand(b)?),
            Op::Div(a, b) => self.operand(a)?.over(self.operand(b)?),
            Op::Powi(base, exponent) => {
                let base = self.operand(base)?.at_least(Strength::Call);
                let size = Literal::u32_unsuffixed(exponent.unsigned_abs());
                let minus = (exponent < 0).then(|| quote!(-));
                Written::call(quote!(#base.powi(#minus #size)))
            }
            Op::Powf(base, exponent) => {
                let base = self.operand(base)?.at_least(Strength::Call);
                let exponent = self.operand(exponent)?.tokens;
                Written::call(quote!(#base.powf(#exponent)))
            }
            Op::Call(function, argument) => {
                let method = format_ident!("{}", function.name());
                let argument = self.operand(argument)?.at_least(Strength::Call);
                Written::call(quote!(#argument.#method()))
            }
            Op::SelectLess { lhs, rhs, then, otherwise } => {
                let [lhs, rhs] = [self.operand(lhs)?.tokens, self.operand(rhs)?.tokens];
                let [then, otherwise] =
                    [self.operand(then)?.tokens, self.operand(otherwise)?.tokens];
                Written::call(quote!(R::select_less(#lhs, #rhs, #then, #otherwise)))
            }
            Op::Table { table: TableId(table), order, argument } => {
                let argument = self.operand(argument)?.tokens;
                let table = &self.scope().tables[table as usize];
                let order = Literal::u32_unsuffixed(order);
                Written::call(quote!(R::interpolate(&#table, #order, #argument)))
            }
            Op::Literal(_)
            | Op::Time
            | Op::State(_)
            | Op::Parameter(_)
            | Op::Handed(_)
            | Op::Held(_)
            | Op::Constant(_)
            | Op::Motion(_) => self.operation(op)?,
        })
    }

    /// Returns the literal of a number.
    fn literal(&self, value: f64) -> Result<Written, EmitError> {
        let place = || format!("function `{}`", self.function());
        let literal = constant_or_literal(value)
            .map_err(|_| EmitError::NotFinite { place: place(), value })?;
        Ok(Written::call(quote!(R::literal(#literal))))
    }
}

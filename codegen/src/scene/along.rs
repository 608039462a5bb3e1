//! Rate of an expression along a motion: `der(x)` of a spec.
//!
//! ```text
//! dX/dt = sum of dX/dq q' + dX/dq' q'' + X_t
//! ```
//!
//! The expression is differentiated as it stands, function by function and branch by branch, so
//! the result is no larger than necessary. [`machinist_algebra::cas`] simplifies it later.

use machinist_algebra::cas::arithmetic;
use machinist_algebra::expr::{Expr, Function, Symbol};
use num_rational::BigRational;
use num_traits::One as _;

use crate::scene::typed::{integer, power, product, reciprocal, select_less, sum};

/// Reason why an expression has no rate.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum NoRate {
    /// It would exceed the allowed number of leaves.
    TooLarge,
    /// The rate of this symbol is unknown.
    Unknown(Symbol),
}

/// Returns the rate of an expression, and its number of leaves. `of` returns the rates of symbols
/// that are neither time nor constant.
///
/// # Errors
/// [`NoRate`], before more than `most` leaves are created.
pub fn rate(
    expr: &Expr,
    most: usize,
    of: &dyn Fn(Symbol) -> Option<Expr>,
) -> Result<(Expr, usize), NoRate> {
    let mut along = Along { of, time: 1, most, made: 0 };
    let rate = along.rate(expr)?;
    Ok((rate, along.made.max(1)))
}

/// Returns the derivative of an expression by some symbols at fixed time, likewise.
///
/// # Errors
/// [`NoRate`], before more than `most` leaves are created.
pub fn slope_by(
    expr: &Expr,
    most: usize,
    of: &dyn Fn(Symbol) -> Option<Expr>,
) -> Result<(Expr, usize), NoRate> {
    let mut along = Along { of, time: 0, most, made: 0 };
    let slope = along.rate(expr)?;
    Ok((slope, along.made.max(1)))
}

struct Along<'a> {
    of: &'a dyn Fn(Symbol) -> Option<Expr>,
    /// Rate of time.
    time: i64,
    most: usize,
    made: usize,
}

impl Along<'_> {
    fn rate(&mut self, expr: &Expr) -> Result<Expr, NoRate> {
        match expr {
            Expr::Number(_) => Ok(integer(0)),
            Expr::Symbol(symbol) => self.of_symbol(*symbol),
            Expr::Shared(shared) => {
                // By the chain rule over all symbols, so that each slope is a shared part too.
                let mut terms = Vec::new();
                for symbol in shared.symbols() {
                    let slope = arithmetic::derivative(expr, *symbol);
                    if !slope.is_zero() {
                        let rate = self.of_symbol(*symbol)?;
                        terms.push(product(vec![self.kept(&slope)?, rate]));
                    }
                }
                Ok(sum(terms))
            }
            Expr::Sum(terms) => {
                let rates = terms.iter().map(|term| self.rate(term));
                Ok(sum(rates.collect::<Result<_, _>>()?))
            }
            Expr::Product(factors) => {
                let mut terms = Vec::new();
                for (index, factor) in factors.iter().enumerate() {
                    let rate = self.rate(factor)?;
                    if rate.is_zero() {
                        continue;
                    }
                    let others = factors.iter().enumerate().filter(|(other, _)| *other != index);
                    let others = others.map(|(_, other)| self.kept(other));
                    let mut parts = others.collect::<Result<Vec<_>, _>>()?;
                    parts.push(rate);
                    terms.push(product(parts));
                }
                Ok(sum(terms))
            }
            Expr::Power(base, exponent) => {
                let rate = self.rate(base)?;
                // Exponents in specs are numbers.
                let Expr::Number(exponent) = &**exponent else { return Ok(rate) };
                if rate.is_zero() {
                    return Ok(rate);
                }
                let base = self.kept(base)?;
                let lower = power(base, &(exponent - BigRational::one()));
                Ok(product(vec![Expr::Number(exponent.clone()), lower, rate]))
            }
            Expr::Call(Function::SelectLess, arguments) => {
                let [left, right, then, otherwise] = &arguments[..] else { return Ok(integer(0)) };
                let (then, otherwise) = (self.rate(then)?, self.rate(otherwise)?);
                if then.is_zero() && otherwise.is_zero() {
                    return Ok(then);
                }
                Ok(select_less(self.kept(left)?, self.kept(right)?, then, otherwise))
            }
            Expr::Call(function, arguments) => {
                let [x] = &arguments[..] else { return Ok(integer(0)) };
                let rate = self.rate(x)?;
                if rate.is_zero() {
                    return Ok(rate);
                }
                let slope = slope(*function, &self.kept(x)?);
                Ok(product(vec![slope, rate]))
            }
        }
    }

    fn of_symbol(&mut self, symbol: Symbol) -> Result<Expr, NoRate> {
        match symbol {
            Symbol::Pi | Symbol::Parameter(_) => Ok(integer(0)),
            Symbol::Time => Ok(integer(self.time)),
            other => {
                self.spend(1)?;
                (self.of)(other).ok_or(NoRate::Unknown(other))
            }
        }
    }

    /// Returns a part that occurs in the rate unchanged.
    fn kept(&mut self, expr: &Expr) -> Result<Expr, NoRate> {
        let mut leaves = 0;
        expr.visit(&mut |part| {
            leaves += usize::from(matches!(part, Expr::Number(_) | Expr::Symbol(_)));
        });
        self.spend(leaves)?;
        Ok(expr.clone())
    }

    fn spend(&mut self, leaves: usize) -> Result<(), NoRate> {
        self.made = self.made.saturating_add(leaves);
        if self.made > self.most { Err(NoRate::TooLarge) } else { Ok(()) }
    }
}

/// Returns df/dx of a function of one argument.
fn slope(function: Function, x: &Expr) -> Expr {
    let of = |function| Expr::Call(function, vec![x.clone()]);
    let square = |of: Expr| power(of, &BigRational::from_integer(2.into()));
    let negative = |of: Expr| product(vec![integer(-1), of]);
    let beside_one = |of: Expr| sum(vec![integer(1), of]);
    let root = |of: Expr| Expr::Call(Function::Sqrt, vec![of]);
    let arc = || reciprocal(root(beside_one(negative(square(x.clone())))));
    match function {
        Function::Sqrt => reciprocal(product(vec![integer(2), of(Function::Sqrt)])),
        Function::Abs => select_less(x.clone(), integer(0), integer(-1), integer(1)),
        Function::Exp => of(Function::Exp),
        Function::Ln => reciprocal(x.clone()),
        Function::Sin => of(Function::Cos),
        Function::Cos => negative(of(Function::Sin)),
        Function::Tan => beside_one(square(of(Function::Tan))),
        Function::Asin => arc(),
        Function::Acos => negative(arc()),
        Function::Atan => reciprocal(beside_one(square(x.clone()))),
        Function::Sinh => of(Function::Cosh),
        Function::Cosh => of(Function::Sinh),
        Function::Tanh => beside_one(negative(square(of(Function::Tanh)))),
        Function::Table { table, order } => of(Function::Table { table, order: order + 1 }),
        Function::Floor | Function::SelectLess => integer(0),
    }
}

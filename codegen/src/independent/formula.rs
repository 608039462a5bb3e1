//! Evaluation of the expressions of a composed scene on numbers that carry derivatives.
//!
//! Excluded: any change of an expression. A sum is only split into its terms, so that derivatives
//! are computed only of those that contain a given symbol.

use std::collections::{BTreeMap, BTreeSet};

use machinist_algebra::expr::{Expr, Function, Shared, Symbol};
use machinist_contract::{CubicTable, Real};
use machinist_model::{Function as Unary, Table, TableId};
use num_rational::BigRational;
use num_traits::ToPrimitive as _;

use super::hyper::Hyper;

/// A step on a stack of values. Expressions nest hundreds of levels deep, and the size of the
/// caller's stack is unknown.
#[derive(Debug, Clone, Copy)]
enum Step<R> {
    Number(R),
    Symbol(Symbol),
    /// Sum of this number of values.
    Sum(usize),
    Product(usize),
    Integer(i32),
    /// A power of the square root.
    Root(i32),
    Real(R),
    Call(Unary),
    Table(TableId, u32),
    /// Selection from `[lhs, rhs, then, otherwise]`.
    Less,
    /// The value of a shared part, by its place among those of the term.
    Shared(usize),
    /// An operation that no spec can contain; it has no value.
    Unknown,
}

/// A term of a sum, with its symbols.
#[derive(Debug, Clone)]
pub struct Term<R> {
    /// Definitions of shared parts, each after those that it uses.
    shared: Vec<Vec<Step<R>>>,
    steps: Vec<Step<R>>,
    symbols: BTreeSet<Symbol>,
}

/// A sum of terms.
#[derive(Debug, Clone)]
pub struct Formula<R> {
    /// The terms.
    pub terms: Vec<Term<R>>,
}

impl<R: Real> Formula<R> {
    /// Returns the formula of an expression.
    pub fn new(expr: &Expr) -> Self {
        let mut formula = Self { terms: Vec::new() };
        formula.add(expr, 1.0);
        formula
    }

    /// Adds an expression times a factor.
    pub fn add(&mut self, expr: &Expr, factor: f64) {
        if let Expr::Sum(terms) = expr {
            return terms.iter().for_each(|term| self.add(term, factor));
        }
        let mut shared = SharedParts { places: BTreeMap::new(), definitions: Vec::new() };
        for part in Shared::within(expr, |_| false) {
            shared.place(&part);
        }
        let mut steps = shared.steps(expr);
        steps.extend([Step::Number(R::literal(factor)), Step::Product(2)]);
        self.terms.push(Term { shared: shared.definitions, steps, symbols: expr.symbols() });
    }
}

impl<R> Term<R> {
    /// Reports whether it contains a symbol for which `is` holds.
    pub fn mentions(&self, is: impl Fn(Symbol) -> bool) -> bool {
        self.symbols.iter().any(|symbol| is(*symbol))
    }
}

impl<R: Real> Term<R> {
    /// Returns its value.
    pub fn value(&self, tables: &[Table], of: &impl Fn(Symbol) -> Hyper<R>) -> Hyper<R> {
        let mut shared: Vec<Hyper<R>> = Vec::with_capacity(self.shared.len());
        for definition in &self.shared {
            let value = evaluate(definition, &shared, tables, of);
            shared.push(value);
        }
        evaluate(&self.steps, &shared, tables, of)
    }
}

/// Returns the value of steps, given those of shared parts.
fn evaluate<R: Real>(
    steps: &[Step<R>],
    shared: &[Hyper<R>],
    tables: &[Table],
    of: &impl Fn(Symbol) -> Hyper<R>,
) -> Hyper<R> {
    let mut values: Vec<Hyper<R>> = Vec::new();
    for step in steps {
        let value = match step {
            Step::Shared(place) => shared.get(*place).copied(),
            step => step.value(&mut values, tables, of),
        };
        values.push(value.unwrap_or(Hyper::literal(f64::NAN)));
    }
    values.pop().unwrap_or(Hyper::literal(f64::NAN))
}

/// The shared parts of a term.
struct SharedParts<R> {
    places: BTreeMap<Shared, usize>,
    definitions: Vec<Vec<Step<R>>>,
}

impl<R: Real> SharedParts<R> {
    /// Returns the steps of an expression, operands before their operation.
    fn steps(&mut self, expr: &Expr) -> Vec<Step<R>> {
        let mut steps = Vec::new();
        let mut left = vec![expr];
        // Operations, then their operands from the last to the first. In reverse, operands are in
        // order and precede their operation.
        while let Some(expr) = left.pop() {
            let step = match expr {
                Expr::Shared(shared) => Step::Shared(self.place(shared)),
                expr => step(expr),
            };
            steps.push(step);
            if let Step::Unknown = step {
                continue;
            }
            match expr {
                Expr::Number(_) | Expr::Symbol(_) | Expr::Shared(_) => {}
                Expr::Sum(parts) | Expr::Product(parts) | Expr::Call(_, parts) => {
                    left.extend(parts);
                }
                Expr::Power(base, _) => left.push(base),
            }
        }
        steps.reverse();
        steps
    }

    fn place(&mut self, shared: &Shared) -> usize {
        if let Some(place) = self.places.get(shared) {
            return *place;
        }
        let definition = self.steps(shared.definition());
        self.definitions.push(definition);
        let place = self.definitions.len() - 1;
        self.places.insert(shared.clone(), place);
        place
    }
}

fn step<R: Real>(expr: &Expr) -> Step<R> {
    match expr {
        Expr::Number(number) => Step::Number(nearest(number)),
        Expr::Symbol(symbol) => Step::Symbol(*symbol),
        Expr::Sum(terms) => Step::Sum(terms.len()),
        Expr::Product(factors) => Step::Product(factors.len()),
        Expr::Power(_, exponent) => match &**exponent {
            Expr::Number(exponent) => power(exponent),
            _ => Step::Unknown,
        },
        Expr::Call(function, arguments) => match (function, arguments.len()) {
            (Function::SelectLess, 4) => Step::Less,
            (Function::Table { table, order }, 1) => Step::Table(*table, *order),
            (function, 1) => function.unary().map_or(Step::Unknown, Step::Call),
            _ => Step::Unknown,
        },
        Expr::Shared(_) => Step::Unknown,
    }
}

/// Returns a power. Integers and halves are computed by products and roots, which have values for
/// negative bases and for zero; others by logarithms.
fn power<R: Real>(exponent: &BigRational) -> Step<R> {
    let twice = exponent * BigRational::from_integer(2.into());
    let integer = |number: &BigRational| number.is_integer().then(|| number.to_integer().to_i32());
    match (integer(exponent).flatten(), integer(&twice).flatten()) {
        (Some(exponent), _) => Step::Integer(exponent),
        (None, Some(twice)) => Step::Root(twice),
        (None, None) => Step::Real(nearest(exponent)),
    }
}

/// Returns a number as the sum of two `f64`: the nearest, and the one nearest to the remainder.
fn nearest<R: Real>(number: &BigRational) -> R {
    let first = number.to_f64().unwrap_or(f64::NAN);
    let rest = BigRational::from_float(first).map(|first| number - first);
    let rest = rest.and_then(|rest| rest.to_f64()).unwrap_or(0.0);
    R::literal(first) + R::literal(rest)
}

/// Returns pi as the sum of two `f64`.
pub fn pi<R: Real>() -> R {
    R::literal(std::f64::consts::PI) + R::literal(1.224_646_799_147_353_2e-16)
}

impl<R: Real> Step<R> {
    /// Returns the value of a step on the stack; `None` if operands are missing.
    fn value(
        &self,
        values: &mut Vec<Hyper<R>>,
        tables: &[Table],
        of: &impl Fn(Symbol) -> Hyper<R>,
    ) -> Option<Hyper<R>> {
        let last = |values: &mut Vec<Hyper<R>>, count: usize| {
            values.len().checked_sub(count).map(|first| values.split_off(first))
        };
        Some(match *self {
            Step::Number(number) => Hyper::constant(number),
            Step::Symbol(symbol) => of(symbol),
            Step::Sum(count) => {
                last(values, count)?.into_iter().fold(Hyper::literal(0.0), Hyper::plus)
            }
            Step::Product(count) => {
                last(values, count)?.into_iter().fold(Hyper::literal(1.0), Hyper::by)
            }
            Step::Integer(exponent) => values.pop()?.power(exponent),
            Step::Root(exponent) => values.pop()?.call(Unary::Sqrt).power(exponent),
            Step::Real(exponent) => values.pop()?.real_power(exponent),
            Step::Call(function) => values.pop()?.call(function),
            Step::Table(table, order) => {
                let Table { knots, coefficients, .. } = tables.get(table.0 as usize)?;
                let table = CubicTable { knots, coefficients };
                let argument = values.pop()?;
                let read = |more: u32| table.evaluate(order + more, argument.value);
                argument.through(read(0), || read(1), || read(2))
            }
            Step::Less => {
                let (otherwise, then) = (values.pop()?, values.pop()?);
                let (rhs, lhs) = (values.pop()?, values.pop()?);
                Hyper::select_less([lhs.value, rhs.value], then, otherwise)
            }
            Step::Shared(_) | Step::Unknown => return None,
        })
    }
}

//! Expressions of a composed scene, as they stand, on numbers that carry derivatives.
//!
//! Excluded: any change of an expression. A sum is taken apart into its terms, so that only
//! those that mention something are asked for its derivative; nothing else is done to it.

use std::collections::BTreeSet;

use machinist_contract::{CubicTable, Real};
use machinist_model::{Function as Unary, Table, TableId};
use num_rational::BigRational;
use num_traits::ToPrimitive as _;

use super::hyper::Hyper;
use crate::expr::{Expr, Function, Symbol};

/// An expression whose numbers are numbers of a type.
#[derive(Debug, Clone)]
enum Tree<R> {
    Number(R),
    Symbol(Symbol),
    Sum(Vec<Tree<R>>),
    Product(Vec<Tree<R>>),
    /// Base and exponent.
    Integer(Box<Tree<R>>, i32),
    /// The square root to a power.
    Root(Box<Tree<R>>, i32),
    Real(Box<Tree<R>>, R),
    Call(Unary, Box<Tree<R>>),
    Table(TableId, u32, Box<Tree<R>>),
    /// `[lhs, rhs, then, otherwise]`.
    Less(Box<[Tree<R>; 4]>),
    /// What no spec can say; it has no value.
    Unknown,
}

/// A term of a sum, with what it mentions.
#[derive(Debug, Clone)]
pub struct Term<R> {
    tree: Tree<R>,
    symbols: BTreeSet<Symbol>,
}

/// A sum of terms.
#[derive(Debug, Clone)]
pub struct Formula<R> {
    /// Its terms.
    pub terms: Vec<Term<R>>,
}

impl<R: Real> Formula<R> {
    /// Of an expression.
    pub fn new(expr: &Expr) -> Self {
        let mut formula = Self { terms: Vec::new() };
        formula.add(expr, 1.0);
        formula
    }

    /// One more expression, times a factor.
    pub fn add(&mut self, expr: &Expr, factor: f64) {
        if let Expr::Sum(terms) = expr {
            return terms.iter().for_each(|term| self.add(term, factor));
        }
        let tree = Tree::Product(vec![Tree::Number(R::literal(factor)), tree(expr)]);
        self.terms.push(Term { tree, symbols: expr.symbols() });
    }
}

impl<R> Term<R> {
    /// Whether it mentions a symbol for which `is` holds.
    pub fn mentions(&self, is: impl Fn(Symbol) -> bool) -> bool {
        self.symbols.iter().any(|symbol| is(*symbol))
    }
}

impl<R: Real> Term<R> {
    /// Its value.
    pub fn value(&self, tables: &[Table], of: &impl Fn(Symbol) -> Hyper<R>) -> Hyper<R> {
        value(&self.tree, tables, of)
    }
}

fn tree<R: Real>(expr: &Expr) -> Tree<R> {
    let all = |parts: &[Expr]| parts.iter().map(tree).collect();
    match expr {
        Expr::Number(number) => Tree::Number(nearest(number)),
        Expr::Symbol(symbol) => Tree::Symbol(*symbol),
        Expr::Sum(terms) => Tree::Sum(all(terms)),
        Expr::Product(factors) => Tree::Product(all(factors)),
        Expr::Power(base, exponent) => match &**exponent {
            Expr::Number(exponent) => power(Box::new(tree(base)), exponent),
            _ => Tree::Unknown,
        },
        Expr::Call(Function::SelectLess, arguments) => match arguments.as_slice() {
            [a, b, x, y] => Tree::Less(Box::new([tree(a), tree(b), tree(x), tree(y)])),
            _ => Tree::Unknown,
        },
        Expr::Call(function, arguments) => match (function, arguments.as_slice()) {
            (Function::Table { table, order }, [argument]) => {
                Tree::Table(*table, *order, Box::new(tree(argument)))
            }
            (function, [argument]) => match function.unary() {
                Some(unary) => Tree::Call(unary, Box::new(tree(argument))),
                None => Tree::Unknown,
            },
            _ => Tree::Unknown,
        },
    }
}

/// Integers and halves by products and roots, which have a value for negative bases and for
/// zero; all else by logarithms.
fn power<R: Real>(base: Box<Tree<R>>, exponent: &BigRational) -> Tree<R> {
    let twice = exponent * BigRational::from_integer(2.into());
    let integer = |number: &BigRational| number.is_integer().then(|| number.to_integer().to_i32());
    match (integer(exponent).flatten(), integer(&twice).flatten()) {
        (Some(exponent), _) => Tree::Integer(base, exponent),
        (None, Some(twice)) => Tree::Root(base, twice),
        (None, None) => Tree::Real(base, nearest(exponent)),
    }
}

/// A number by two `f64`: the nearest, and the nearest to what that leaves.
fn nearest<R: Real>(number: &BigRational) -> R {
    let first = number.to_f64().unwrap_or(f64::NAN);
    let rest = BigRational::from_float(first).map(|first| number - first);
    let rest = rest.and_then(|rest| rest.to_f64()).unwrap_or(0.0);
    R::literal(first) + R::literal(rest)
}

/// pi by two `f64`.
pub fn pi<R: Real>() -> R {
    R::literal(std::f64::consts::PI) + R::literal(1.224_646_799_147_353_2e-16)
}

fn value<R: Real>(tree: &Tree<R>, tables: &[Table], of: &impl Fn(Symbol) -> Hyper<R>) -> Hyper<R> {
    let value = |tree: &Tree<R>| value(tree, tables, of);
    match tree {
        Tree::Number(number) => Hyper::constant(*number),
        Tree::Symbol(symbol) => of(*symbol),
        Tree::Sum(terms) => terms.iter().map(value).fold(Hyper::literal(0.0), Hyper::plus),
        Tree::Product(factors) => factors.iter().map(value).fold(Hyper::literal(1.0), Hyper::by),
        Tree::Integer(base, exponent) => value(base).power(*exponent),
        Tree::Root(base, exponent) => value(base).call(Unary::Sqrt).power(*exponent),
        Tree::Real(base, exponent) => value(base).real_power(*exponent),
        Tree::Call(function, argument) => value(argument).call(*function),
        Tree::Table(table, order, argument) => {
            let Some(table) = tables.get(table.0 as usize) else {
                return Hyper::literal(f64::NAN);
            };
            let table = CubicTable { knots: &table.knots, coefficients: &table.coefficients };
            let argument = value(argument);
            let read = |more: u32| table.evaluate(order + more, argument.value);
            argument.through(read(0), || read(1), || read(2))
        }
        Tree::Less(parts) => {
            let [lhs, rhs, then, otherwise] = &**parts;
            let [lhs, rhs] = [lhs, rhs].map(|side| value(side).value);
            Hyper::select_less([lhs, rhs], value(then), value(otherwise))
        }
        Tree::Unknown => Hyper::literal(f64::NAN),
    }
}

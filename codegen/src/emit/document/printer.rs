//! Printing of expressions as text or LaTeX, with helpers by name.

use std::cell::RefCell;
use std::collections::BTreeSet;

use machinist_algebra::expr::abbreviate::Abbreviations;
use machinist_algebra::expr::{Expr, Function, HelperId, Shared, Symbol};
use num_rational::BigRational;
use num_traits::{One, Signed};

use super::{Notation, dotted, symbol_name};
use crate::mechanics::lagrange::EquationsOfMotion;
use crate::scene::system::LagrangianSystem;
use machinist_model::Quantity;

/// Binding strength, weakest first.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Strength {
    Sum,
    Product,
    Power,
    Atom,
}

/// Prints expressions and records the helpers they name.
pub(super) struct Printer<'a> {
    system: &'a LagrangianSystem,
    abbreviations: Abbreviations,
    notation: Notation,
    used: RefCell<BTreeSet<usize>>,
    shared: RefCell<Vec<Shared>>,
}

impl<'a> Printer<'a> {
    pub(super) fn new(equations: &'a EquationsOfMotion, notation: Notation) -> Self {
        Printer {
            system: &equations.system,
            abbreviations: Abbreviations::new(&equations.helpers),
            notation,
            used: RefCell::default(),
            shared: RefCell::default(),
        }
    }

    /// Returns the indices of the helpers named so far.
    pub(super) fn used(&self) -> BTreeSet<usize> {
        self.used.borrow().clone()
    }

    /// Prints an expression with helpers by name.
    pub(super) fn print(&self, expr: &Expr) -> String {
        self.short(&self.abbreviations.apply(expr))
    }

    /// Prints a helper's own definition: smaller helpers by name, itself in full.
    pub(super) fn print_helper(&self, index: usize) -> String {
        let mut entries = self.abbreviations.entries().iter();
        match entries.find(|(id, _)| id.0 as usize == index) {
            Some((_, definition)) => self.short(definition),
            None => String::new(),
        }
    }

    /// Prints an expression in which helpers are already substituted.
    fn short(&self, expr: &Expr) -> String {
        self.expr(expr).0
    }

    pub(super) fn quantity(&self, quantity: &Quantity) -> String {
        match self.notation {
            Notation::Text => quantity.name.path.clone(),
            Notation::Latex => quantity.name.latex.clone(),
        }
    }

    /// Prints the time derivative of a state.
    pub(super) fn rate_of(&self, symbol: Symbol) -> String {
        let name = symbol_name(self.system, symbol, self.notation);
        match self.notation {
            Notation::Text => format!("{name}'"),
            Notation::Latex => dotted(&name, "dot"),
        }
    }

    fn expr(&self, expr: &Expr) -> (String, Strength) {
        match expr {
            Expr::Number(value) => self.number(value),
            Expr::Symbol(symbol) => {
                if let Symbol::Helper(HelperId(index)) = symbol {
                    self.used.borrow_mut().insert(*index as usize);
                }
                (symbol_name(self.system, *symbol, self.notation), Strength::Atom)
            }
            Expr::Sum(terms) => (self.sum(terms), Strength::Sum),
            Expr::Product(factors) => self.product(factors),
            Expr::Power(base, exponent) => self.power(base, exponent),
            Expr::Call(function, arguments) => (self.call(*function, arguments), Strength::Atom),
            Expr::Shared(shared) => (self.shared_name(shared), Strength::Atom),
        }
    }

    /// Returns the name of a shared part: its own, or a number in order of appearance.
    fn shared_name(&self, shared: &Shared) -> String {
        let mut parts = self.shared.borrow_mut();
        let known = parts.iter().position(|known| known == shared);
        let place = known.unwrap_or(parts.len());
        if known.is_none() {
            parts.push(shared.clone());
        }
        match (shared.name(), self.notation) {
            (Some(name), Notation::Text) => name.to_owned(),
            (Some(name), Notation::Latex) => {
                format!("\\mathrm{{{}}}", name.replace('_', "\\_"))
            }
            (None, Notation::Text) => format!("part_{}", place + 1),
            (None, Notation::Latex) => format!("u_{{{}}}", place + 1),
        }
    }

    /// Returns the shared parts named so far, in order.
    pub(super) fn shared_parts(&self) -> Vec<Shared> {
        self.shared.borrow().clone()
    }

    /// Prints a shared part's name and its definition.
    pub(super) fn print_shared(&self, shared: &Shared) -> (String, String) {
        (self.shared_name(shared), self.print(shared.definition()))
    }

    fn within(&self, expr: &Expr, least: Strength) -> String {
        let (text, strength) = self.expr(expr);
        if strength < least { self.parenthesized(&text) } else { text }
    }

    fn parenthesized(&self, text: &str) -> String {
        match self.notation {
            Notation::Text => format!("({text})"),
            Notation::Latex => format!("\\left({text}\\right)"),
        }
    }

    fn number(&self, value: &BigRational) -> (String, Strength) {
        if value.is_integer() {
            return (value.numer().to_string(), Strength::Atom);
        }
        match self.notation {
            Notation::Text => (value.to_string(), Strength::Product),
            Notation::Latex => {
                (format!("\\tfrac{{{}}}{{{}}}", value.numer(), value.denom()), Strength::Atom)
            }
        }
    }

    /// Prints a sum; added terms precede subtracted ones.
    fn sum(&self, terms: &[Expr]) -> String {
        let mut parts: Vec<(String, bool)> =
            terms.iter().map(|term| self.signed_term(term)).collect();
        parts.sort_by_key(|(_, negative)| *negative);
        let mut text = String::new();
        for (index, (part, negative)) in parts.iter().enumerate() {
            match (index, negative) {
                (0, false) => {}
                (0, true) => text.push('-'),
                (_, false) => text.push_str(" + "),
                (_, true) => text.push_str(" - "),
            }
            text.push_str(part);
        }
        text
    }

    fn signed_term(&self, term: &Expr) -> (String, bool) {
        let text = self.within(term, Strength::Product);
        match text.strip_prefix('-') {
            Some(positive) => (positive.to_owned(), true),
            None => (text, false),
        }
    }

    fn product(&self, factors: &[Expr]) -> (String, Strength) {
        let mut coefficient = BigRational::one();
        let (mut above, mut below) = (Vec::new(), Vec::new());
        for factor in factors {
            match factor {
                Expr::Number(value) => coefficient *= value,
                Expr::Power(base, exponent) => match exponent.as_ref() {
                    Expr::Number(value) if value.is_negative() => {
                        let positive = -value.clone();
                        below.push(if positive.is_one() {
                            base.as_ref().clone()
                        } else {
                            Expr::Power(base.clone(), Box::new(Expr::Number(positive)))
                        });
                    }
                    _ => above.push(factor.clone()),
                },
                _ => above.push(factor.clone()),
            }
        }
        // Parameters precede varying factors, as is usual in engineering.
        let varies = |factor: &Expr| {
            !matches!(
                factor,
                Expr::Number(_)
                    | Expr::Symbol(Symbol::Pi | Symbol::Parameter(_) | Symbol::Handed(_))
            )
        };
        above.sort_by_key(varies);
        below.sort_by_key(varies);
        let sign = if coefficient.is_negative() { "-" } else { "" };
        let coefficient = coefficient.abs();
        let whole = |n: &num_bigint::BigInt| Expr::Number(BigRational::from_integer(n.clone()));
        if !coefficient.numer().is_one() || above.is_empty() {
            above.insert(0, whole(coefficient.numer()));
        }
        if !coefficient.denom().is_one() {
            below.insert(0, whole(coefficient.denom()));
        }
        let text = match self.notation {
            Notation::Text => self.text_quotient(&above, &below),
            Notation::Latex => self.latex_quotient(&above, &below),
        };
        (format!("{sign}{text}"), Strength::Product)
    }

    fn text_quotient(&self, above: &[Expr], below: &[Expr]) -> String {
        let join = |factors: &[Expr]| {
            let factors: Vec<String> =
                factors.iter().map(|f| self.within(f, Strength::Power)).collect();
            factors.join("*")
        };
        match below {
            [] => join(above),
            [one] => format!("{}/{}", join(above), self.within(one, Strength::Power)),
            _ => format!("{}/({})", join(above), join(below)),
        }
    }

    fn latex_quotient(&self, above: &[Expr], below: &[Expr]) -> String {
        let join = |factors: &[Expr]| {
            let lone = factors.len() == 1;
            let least = if lone { Strength::Sum } else { Strength::Product };
            let factors: Vec<String> = factors.iter().map(|f| self.within(f, least)).collect();
            factors.join(" \\, ")
        };
        if below.is_empty() {
            let factors: Vec<String> =
                above.iter().map(|f| self.within(f, Strength::Product)).collect();
            return factors.join(" \\, ");
        }
        format!("\\frac{{{}}}{{{}}}", join(above), join(below))
    }

    fn power(&self, base: &Expr, exponent: &Expr) -> (String, Strength) {
        if let Expr::Number(value) = exponent
            && value.is_negative()
        {
            return self
                .product(&[Expr::Power(Box::new(base.clone()), Box::new(exponent.clone()))]);
        }
        let base_text = self.within(base, Strength::Atom);
        match self.notation {
            Notation::Text => {
                (format!("{base_text}^{}", self.within(exponent, Strength::Atom)), Strength::Power)
            }
            Notation::Latex => {
                // Braces keep a dot or a subscript readable.
                (format!("{{{base_text}}}^{{{}}}", self.short(exponent)), Strength::Power)
            }
        }
    }

    fn call(&self, function: Function, arguments: &[Expr]) -> String {
        let arguments: Vec<String> = arguments.iter().map(|a| self.short(a)).collect();
        match (function, self.notation) {
            (Function::Sqrt, Notation::Latex) => format!("\\sqrt{{{}}}", arguments[0]),
            (Function::Abs, Notation::Latex) => format!("\\left|{}\\right|", arguments[0]),
            (Function::Floor, Notation::Latex) => {
                format!("\\left\\lfloor {} \\right\\rfloor", arguments[0])
            }
            (Function::SelectLess, Notation::Text) => format!(
                "(if {} < {} then {} else {})",
                arguments[0], arguments[1], arguments[2], arguments[3]
            ),
            (Function::SelectLess, Notation::Latex) => format!(
                "\\begin{{cases}} {} & {} < {} \\\\ {} & \\text{{else}} \\end{{cases}}",
                arguments[2], arguments[0], arguments[1], arguments[3]
            ),
            (Function::Table { table, order }, notation) => {
                let table = &self.system.tables[table.0 as usize].name;
                let primes = "'".repeat(order as usize);
                match notation {
                    Notation::Text => format!("{}{primes}({})", table.path, arguments[0]),
                    Notation::Latex => {
                        format!("{}{primes}\\left({}\\right)", table.latex, arguments[0])
                    }
                }
            }
            (_, Notation::Text) => format!("{}({})", plain_name(function), arguments[0]),
            (_, Notation::Latex) => {
                format!("{}\\left({}\\right)", latex_name(function), arguments[0])
            }
        }
    }
}

fn plain_name(function: Function) -> &'static str {
    match function {
        Function::Sqrt => "sqrt",
        Function::Abs => "abs",
        Function::Floor => "floor",
        Function::Exp => "exp",
        Function::Ln => "ln",
        Function::Sin => "sin",
        Function::Cos => "cos",
        Function::Tan => "tan",
        Function::Asin => "asin",
        Function::Acos => "acos",
        Function::Atan => "atan",
        Function::Sinh => "sinh",
        Function::Cosh => "cosh",
        Function::Tanh => "tanh",
        Function::SelectLess => "select_less",
        Function::Table { .. } => "table",
    }
}

fn latex_name(function: Function) -> &'static str {
    match function {
        Function::Exp => "\\exp",
        Function::Ln => "\\ln",
        Function::Sin => "\\sin",
        Function::Cos => "\\cos",
        Function::Tan => "\\tan",
        Function::Asin => "\\arcsin",
        Function::Acos => "\\arccos",
        Function::Atan => "\\arctan",
        Function::Sinh => "\\sinh",
        Function::Cosh => "\\cosh",
        Function::Tanh => "\\tanh",
        _ => plain_name(function),
    }
}

//! Expressions after names are resolved, and the graph of their operations.
//!
//! Excluded: spans, strings and units (they stay in the spec), and any type of the computer algebra
//! system (it stays in [`crate::cas`]).

pub mod abbreviate;
mod cost;
pub mod extent;
mod fold;
mod graph;
pub mod held;
pub mod identity;
mod matrix;
mod overflow;
pub mod rank;
mod shared;
mod signs;
mod terms;
pub mod trigonometry;
mod vanishing;

use std::collections::BTreeSet;

use machinist_model::{Function as Unary, TableId};
use num_rational::BigRational;
use num_traits::Zero as _;

pub use cost::{operations, weigh};
pub use graph::{Graph, PlusExponential};
pub use matrix::Matrix;
pub use shared::{Replacement, Shared};

/// Index of a generalized coordinate of a scene.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct CoordinateId(pub u32);

/// Index of a first-order state of a scene.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct FirstOrderId(pub u32);

/// Index of a parameter of a scene.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct ParameterId(pub u32);

/// Index of a helper of a scene.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct HelperId(pub u32);

/// Index of a number that a field hands to the machine at one of its ports.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct HandedId(pub u32);

/// Index of a constraint of a scene.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct ConstraintId(pub u32);

/// Symbols in expressions.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Symbol {
    /// The number pi, kept as a symbol so that documents show it.
    Pi,
    /// Time t.
    Time,
    /// Generalized coordinate q.
    Coordinate(CoordinateId),
    /// Generalized velocity q'.
    Velocity(CoordinateId),
    /// Generalized acceleration q''; in outputs only.
    Acceleration(CoordinateId),
    /// Multiplier lambda of a constraint.
    Multiplier(ConstraintId),
    /// The multiplier of a constraint if no force acted in proportion to its size. Both have the same
    /// sign.
    Unloaded(ConstraintId),
    /// First-order state z.
    FirstOrder(FirstOrderId),
    /// Parameter p.
    Parameter(ParameterId),
    /// Value that a field hands over.
    Handed(HandedId),
    /// A helper in place of its expression; only after [`crate::expr::abbreviate`].
    Helper(HelperId),
}

/// Functions in expressions, by their usual names.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Function {
    /// Square root.
    Sqrt,
    /// Absolute value.
    Abs,
    /// The largest integer not above the argument; its derivative is 0.
    Floor,
    /// Exponential function.
    Exp,
    /// Natural logarithm.
    Ln,
    /// Sine.
    Sin,
    /// Cosine.
    Cos,
    /// Tangent.
    Tan,
    /// Inverse sine.
    Asin,
    /// Inverse cosine.
    Acos,
    /// Inverse tangent.
    Atan,
    /// Hyperbolic sine.
    Sinh,
    /// Hyperbolic cosine.
    Cosh,
    /// Hyperbolic tangent.
    Tanh,
    /// `select_less(a, b, x, y)`: x if a < b, else y. `min`, `max`, `step`, `piecewise` and
    /// `smooth_step` are written with it; it is differentiated branch by branch.
    SelectLess,
    /// Cubic table or a derivative of it, of one argument.
    Table {
        /// The table.
        table: TableId,
        /// 0 for the value, k for the k-th derivative.
        order: u32,
    },
}

impl Function {
    /// Functions that tapes have under the same names.
    const UNARY: [(Self, Unary); 14] = [
        (Self::Sqrt, Unary::Sqrt),
        (Self::Abs, Unary::Abs),
        (Self::Floor, Unary::Floor),
        (Self::Exp, Unary::Exp),
        (Self::Ln, Unary::Ln),
        (Self::Sin, Unary::Sin),
        (Self::Cos, Unary::Cos),
        (Self::Tan, Unary::Tan),
        (Self::Asin, Unary::Asin),
        (Self::Acos, Unary::Acos),
        (Self::Atan, Unary::Atan),
        (Self::Sinh, Unary::Sinh),
        (Self::Cosh, Unary::Cosh),
        (Self::Tanh, Unary::Tanh),
    ];

    /// Returns the function of tapes; `None` for functions that tapes have as operations of their
    /// own.
    #[must_use]
    pub fn unary(self) -> Option<Unary> {
        Self::UNARY.iter().find(|(function, _)| *function == self).map(|(_, unary)| *unary)
    }

    /// Returns the function of expressions for one of tapes; `None` if there is none.
    #[must_use]
    pub fn of_unary(unary: Unary) -> Option<Self> {
        Self::UNARY.iter().find(|(_, other)| *other == unary).map(|(function, _)| *function)
    }
}

/// An expression tree with exact numbers.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Expr {
    /// An exact number, as the spec writes it.
    Number(BigRational),
    /// A variable or parameter.
    Symbol(Symbol),
    /// Sum of two or more terms.
    Sum(Vec<Expr>),
    /// Product of two or more factors; a quotient has factors of negative power.
    Product(Vec<Expr>),
    /// Base and exponent.
    Power(Box<Expr>, Box<Expr>),
    /// Function and arguments.
    Call(Function, Vec<Expr>),
    /// A part that several expressions share, defined once; see [`Shared`].
    Shared(Shared),
}

impl Expr {
    /// Returns an integer as an expression.
    #[must_use]
    pub fn integer(value: i64) -> Self {
        Expr::Number(BigRational::from_integer(value.into()))
    }

    /// Returns whether this is the number zero.
    #[must_use]
    pub fn is_zero(&self) -> bool {
        matches!(self, Expr::Number(number) if number.is_zero())
    }

    /// Calls `see` with this expression and every part of it. Shared parts are leaves: their
    /// definitions are not visited.
    pub fn visit<'a>(&'a self, see: &mut impl FnMut(&'a Expr)) {
        see(self);
        match self {
            Expr::Number(_) | Expr::Symbol(_) | Expr::Shared(_) => {}
            Expr::Sum(parts) | Expr::Product(parts) | Expr::Call(_, parts) => {
                for part in parts {
                    part.visit(see);
                }
            }
            Expr::Power(base, exponent) => {
                base.visit(see);
                exponent.visit(see);
            }
        }
    }

    /// Returns all symbols of the expression.
    #[must_use]
    pub fn symbols(&self) -> BTreeSet<Symbol> {
        let mut symbols = BTreeSet::new();
        self.visit(&mut |part| match part {
            Expr::Symbol(symbol) => drop(symbols.insert(*symbol)),
            Expr::Shared(shared) => symbols.extend(shared.symbols()),
            _ => {}
        });
        symbols
    }

    /// Returns whether the expression contains a symbol for which `is` returns true.
    #[must_use]
    pub fn mentions(&self, is: impl Fn(Symbol) -> bool) -> bool {
        let mut found = false;
        self.visit(&mut |part| {
            found = found
                || match part {
                    Expr::Symbol(symbol) => is(*symbol),
                    Expr::Shared(shared) => shared.symbols().iter().any(|symbol| is(*symbol)),
                    _ => false,
                };
        });
        found
    }
}

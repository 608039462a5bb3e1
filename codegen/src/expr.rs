//! Expressions after names are resolved.
//!
//! Excluded: spans, strings and units (they stay in [`crate::spec`]), and any
//! type of the computer algebra system (it stays in [`crate::cas`]).

use num_rational::BigRational;

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

/// Index of an interpolation table of a scene.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct TableId(pub u32);

/// What an expression may depend on.
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
    /// First-order state z.
    FirstOrder(FirstOrderId),
    /// Parameter p.
    Parameter(ParameterId),
    /// A helper standing for its expression; from [`crate::abbreviate`] on only.
    Helper(HelperId),
}

/// The functions expressions know, by their usual names.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Function {
    /// Square root.
    Sqrt,
    /// Absolute value.
    Abs,
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
    /// `select_less(a, b, x, y)`: x where a < b, else y. `min`, `max`, `step`,
    /// `piecewise` and `smooth_step` are written with it; it is differentiated
    /// branch by branch.
    SelectLess,
    /// Cubic table or a derivative of it, of one argument.
    Table {
        /// Which table.
        table: TableId,
        /// 0 for the value, k for the k-th derivative.
        order: u32,
    },
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
}

//! Recurrences for the normalized Taylor coefficients of a solution, plain data.
//!
//! Excluded: functions without a recurrence of their own (a tangent brings its
//! 1 + tan^2 with it, an absolute value is a choice, an integer power is
//! products), the L D L^T of a mass matrix that moves (it is kept as a matrix
//! and factored at order zero alone), names of emitted variables.
//!
//! With `x = sum_k x_k (t - t_0)^k` every node has a zeroth coefficient, its
//! value, and a k-th one made of coefficients up to order k of the nodes before
//! it, and of those up to order k - 1 of any node. The sums within
//! are listed by [`TaylorTape::convolutions`]; they read orders 1 to k - 1 only:
//!
//! ```text
//! S(a, b)_k = sum_(j=1..k-1) a_j b_(k-j)      a' stands for the series j a_j
//! product            y_k = a_0 b_k + a_k b_0 + S(a, b)
//! quotient a/b       y_k = (a_k - b_k y_0 - S(b, y))/b_0
//! root of a          y_k = (a_k - S(y, y))/(2 y_0)
//! integral of g dx   y_k = x_k g_0 + S(x', g)/k
//! integral of dx/w   y_k = (x_k - S(y', w)/k)/w_0
//! power x^c          y_k = (c x_k y_0 + (c S(x', y) - S(y', x))/k)/x_0
//! ```

mod build;
mod evaluate;

use machinist_contract::taylor::Bends;

use crate::{Function, NodeId, Op, TableId};

pub use build::recurrences;
pub use evaluate::SeriesEvaluator;

/// How the coefficients of one node follow from those of others.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Recurrence {
    /// Of parameters only: all coefficients but the zeroth vanish. Operands are
    /// constants too.
    Constant(Op),
    /// Time: t_0, 1, 0, 0, ...
    Time,
    /// Entry of the state: `y_k = rate_(k-1)/k`.
    State(u32),
    /// `-a`.
    Neg(NodeId),
    /// `a + b`.
    Add(NodeId, NodeId),
    /// `a - b`.
    Sub(NodeId, NodeId),
    /// Series times constant.
    Scaled {
        /// The factor that varies.
        series: NodeId,
        /// The constant.
        factor: NodeId,
    },
    /// Product of two series.
    Product(NodeId, NodeId),
    /// `(a - a_0) (b - b_0)`, for the powers within a table: `y_k = S(a, b)`,
    /// zeroth coefficient 0.
    Tail(NodeId, NodeId),
    /// Quotient by a series; the numerator may be a constant.
    Quotient(NodeId, NodeId),
    /// Square root.
    Root(NodeId),
    /// `function(argument)` with derivative `integrand`, or minus that; the
    /// integrand may come later or be this very node.
    Integral {
        /// Gives the zeroth coefficient.
        function: Function,
        /// What the function is of.
        argument: NodeId,
        /// The derivative by the argument.
        integrand: NodeId,
        /// Whether the derivative has a minus.
        minus: bool,
    },
    /// `function(argument)` with derivative 1/`divisor`, or minus that.
    IntegralOver {
        /// Gives the zeroth coefficient.
        function: Function,
        /// What the function is of.
        argument: NodeId,
        /// One over the derivative by the argument.
        divisor: NodeId,
        /// Whether the derivative has a minus.
        minus: bool,
    },
    /// Constant real power of a positive series.
    Power {
        /// The positive series.
        base: NodeId,
        /// The constant.
        exponent: NodeId,
    },
    /// All coefficients of `then` or of `otherwise`, as the zeroth ones of `lhs`
    /// and `rhs` say.
    Select {
        /// Compared for less.
        lhs: NodeId,
        /// What it is compared with.
        rhs: NodeId,
        /// Where less.
        then: NodeId,
        /// Where not.
        otherwise: NodeId,
    },
    /// The cubic that holds at the zeroth coefficient of the argument; `square`
    /// and `cube` are the powers of the argument less its zeroth coefficient.
    Table {
        /// Which table.
        table: TableId,
        /// Derivative of the table.
        order: u32,
        /// What the function is of.
        argument: NodeId,
        /// `(x - x_0)^2`.
        square: NodeId,
        /// `(x - x_0)^3`.
        cube: NodeId,
    },
    /// The part of entry times acceleration that is known before the
    /// acceleration: `y_k = entry_k acceleration_0 + S(entry, acceleration)`,
    /// zeroth coefficient 0.
    Lagged {
        /// Of the mass matrix.
        entry: NodeId,
        /// The unknown it is multiplied with.
        acceleration: NodeId,
    },
    /// Entry of the accelerations, solved for after all other nodes of an order.
    Acceleration(u32),
}

/// How much of a series there is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Extent {
    /// The zeroth coefficient only.
    Constant,
    /// Zeroth and first: linear in time.
    Line,
    /// All of them.
    Series,
}

/// One node.
#[derive(Debug, Clone, PartialEq)]
pub struct SeriesNode {
    /// How its coefficients follow.
    pub recurrence: Recurrence,
    /// How many of them there are.
    pub extent: Extent,
    /// The spec's name, if it has one.
    pub name: Option<String>,
}

/// A mass matrix that moves: `M_0 a_k = right_side_k` at every order.
#[derive(Debug, Clone, PartialEq)]
pub struct MassMatrix {
    /// Nonzeros of the lower triangle, `(row, column, entry)`.
    pub lower: Vec<(u32, u32, NodeId)>,
    /// `f - sum lagged`, one for each coordinate.
    pub right_side: Vec<NodeId>,
    /// The nodes that hold the solution.
    pub accelerations: Vec<NodeId>,
}

/// `S(left, right)`, the left one perhaps with every coefficient times its order.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub struct Convolution {
    /// The first factor.
    pub left: NodeId,
    /// Whether the left factor is `j left_j`.
    pub weighted: bool,
    /// The second factor.
    pub right: NodeId,
}

/// Recurrences of all that the rate depends on.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct TaylorTape {
    /// Zeroth coefficients in order of evaluation.
    pub nodes: Vec<SeriesNode>,
    /// The rate of every state.
    pub rate: Vec<NodeId>,
    /// Present where the mass matrix couples coordinates and moves.
    pub mass_matrix: Option<MassMatrix>,
}

impl std::ops::Index<NodeId> for TaylorTape {
    type Output = SeriesNode;
    fn index(&self, id: NodeId) -> &SeriesNode {
        &self.nodes[id.0 as usize]
    }
}

impl TaylorTape {
    /// Whether a node is the same at all times.
    #[must_use]
    pub fn is_constant(&self, id: NodeId) -> bool {
        self[id].extent == Extent::Constant
    }

    /// Whether a node is linear in time, and so costs no sum.
    #[must_use]
    pub fn is_line(&self, id: NodeId) -> bool {
        self[id].extent == Extent::Line
    }

    /// Where the motion may bend so that no coefficient tells of it from afar, if runs
    /// are cut at so many times at which the rate jumps.
    ///
    /// A comparison of time with a constant is one of these jumps; where there are more
    /// of them than jumps, one is a kink. Functions that saturate (tanh, exp, atan and
    /// their kin) lose all their coefficients to rounding where they are flat. Poles and
    /// roots do not: what is near shows in how coefficients grow.
    #[must_use]
    pub fn bends(&self, jumps: usize) -> Bends {
        let mut switches: Vec<(NodeId, NodeId)> = Vec::new();
        let mut of_node = |node: &SeriesNode| match node.recurrence {
            Recurrence::Select { lhs, rhs, .. } => {
                let switches_once = [(lhs, rhs), (rhs, lhs)].into_iter().any(|(time, at)| {
                    self[time].recurrence == Recurrence::Time && self.is_constant(at)
                });
                if switches_once && !switches.contains(&(lhs, rhs)) {
                    switches.push((lhs, rhs));
                }
                let rests = self.rests(lhs) && self.rests(rhs);
                if rests || switches_once { Bends::Nowhere } else { Bends::Corners }
            }
            Recurrence::Table { .. } | Recurrence::Integral { function: Function::Floor, .. } => {
                Bends::Corners
            }
            Recurrence::Integral { function: Function::Exp, argument, .. }
                if self.is_line(argument) =>
            {
                Bends::Nowhere
            }
            Recurrence::Integral { function, .. } | Recurrence::IntegralOver { function, .. } => {
                let saturates = matches!(
                    function,
                    Function::Exp
                        | Function::Tanh
                        | Function::Sinh
                        | Function::Cosh
                        | Function::Atan
                );
                if saturates { Bends::Saturates } else { Bends::Nowhere }
            }
            _ => Bends::Nowhere,
        };
        let most = self.nodes.iter().map(&mut of_node).max().unwrap_or(Bends::Nowhere);
        if switches.len() > jumps { Bends::Corners } else { most }
    }

    /// Whether a node stays as it is along a motion: a constant, or a mode.
    fn rests(&self, id: NodeId) -> bool {
        let is_zero =
            |rate: &NodeId| self[*rate].recurrence == Recurrence::Constant(Op::Literal(0.0));
        match self[id].recurrence {
            Recurrence::State(entry) => self.rate.get(entry as usize).is_some_and(is_zero),
            _ => self.is_constant(id),
        }
    }

    /// The sums in a node's k-th coefficient that are written as sums. None where a factor
    /// is linear in time: there the sum is one product.
    #[must_use]
    pub fn convolutions(&self, id: NodeId) -> Vec<Convolution> {
        match self[id].recurrence {
            Recurrence::Product(a, b) if self.is_line(a) || self.is_line(b) => vec![],
            Recurrence::Integral { argument, .. } if self.is_line(argument) => vec![],
            _ => self.all_convolutions(id),
        }
    }

    /// The sums in a node's k-th coefficient, whatever their factors are.
    #[must_use]
    pub fn all_convolutions(&self, id: NodeId) -> Vec<Convolution> {
        let plain = |left, right| Convolution { left, weighted: false, right };
        let weighted = |left, right| Convolution { left, weighted: true, right };
        match self[id].recurrence {
            Recurrence::Product(a, b) | Recurrence::Tail(a, b) => vec![plain(a, b)],
            Recurrence::Quotient(_, b) => vec![plain(b, id)],
            Recurrence::Root(_) => vec![plain(id, id)],
            Recurrence::Integral { argument, integrand, .. } => vec![weighted(argument, integrand)],
            Recurrence::IntegralOver { divisor, .. } => vec![weighted(id, divisor)],
            Recurrence::Power { base, .. } => vec![weighted(base, id), weighted(id, base)],
            Recurrence::Lagged { entry, acceleration } => vec![plain(entry, acceleration)],
            _ => vec![],
        }
    }
}

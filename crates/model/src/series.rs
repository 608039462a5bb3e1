//! Recurrences for the normalized Taylor coefficients of a solution, as plain data.
//!
//! Excluded: functions without a recurrence of their own (a tangent uses 1 + tan^2, an absolute
//! value is a selection, an integer power is products), the L D L^T of a variable mass matrix (it
//! is kept as a matrix and factored at order zero only), names of emitted variables.
//!
//! With `x = sum_k x_k (t - t_0)^k` the zeroth coefficient of a node is its value. The k-th follows
//! from coefficients up to order k of the nodes before it, and up to order k - 1 of any node.
//! [`TaylorTape::convolutions`] lists the sums in it, which read orders 1 to k - 1 only:
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

use crate::{Function, NodeId, Op, TableId};

pub use build::recurrences;
pub use evaluate::SeriesEvaluator;

/// Rule by which the coefficients of a node follow from those of others.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Recurrence {
    /// A function of parameters only: all coefficients but the zeroth vanish, also those of the
    /// operands.
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
        /// The variable factor.
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
    /// `function(argument)` with derivative `integrand`, or minus that; the integrand may come
    /// later or be the node itself.
    Integral {
        /// Function that gives the zeroth coefficient.
        function: Function,
        /// Argument of the function.
        argument: NodeId,
        /// Derivative by the argument.
        integrand: NodeId,
        /// True if the derivative is `-integrand`.
        minus: bool,
    },
    /// `function(argument)` with derivative 1/`divisor`, or minus that.
    IntegralOver {
        /// Function that gives the zeroth coefficient.
        function: Function,
        /// Argument of the function.
        argument: NodeId,
        /// Reciprocal of the derivative by the argument.
        divisor: NodeId,
        /// True if the derivative is `-1/divisor`.
        minus: bool,
    },
    /// Constant real power of a positive series.
    Power {
        /// The positive series.
        base: NodeId,
        /// The constant.
        exponent: NodeId,
    },
    /// All coefficients of `then` or of `otherwise`, selected by the zeroth ones of `lhs` and
    /// `rhs`.
    Select {
        /// Left side of the comparison `lhs < rhs`.
        lhs: NodeId,
        /// Right side.
        rhs: NodeId,
        /// Result if the comparison is true.
        then: NodeId,
        /// Result if it is false.
        otherwise: NodeId,
    },
    /// The cubic that applies at the zeroth coefficient of the argument; `square` and `cube` are
    /// the powers of the argument less its zeroth coefficient.
    Table {
        /// The table.
        table: TableId,
        /// Order of the derivative of the table.
        order: u32,
        /// Argument of the table.
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
        /// Entry of the mass matrix.
        entry: NodeId,
        /// Acceleration that the entry multiplies.
        acceleration: NodeId,
    },
    /// Entry of the accelerations, solved for after all other nodes of an order.
    Acceleration(u32),
}

/// Coefficients of a series that may differ from zero.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Extent {
    /// The zeroth coefficient only.
    Constant,
    /// Zeroth and first, linear in time.
    Line,
    /// All of them.
    Series,
}

/// One node.
#[derive(Debug, Clone, PartialEq)]
pub struct SeriesNode {
    /// Rule for the coefficients.
    pub recurrence: Recurrence,
    /// Coefficients that may differ from zero.
    pub extent: Extent,
    /// The spec's name, if it has one.
    pub name: Option<String>,
}

/// A variable mass matrix: `M_0 a_k = right_side_k` at every order.
#[derive(Debug, Clone, PartialEq)]
pub struct MassMatrix {
    /// Nonzeros of the lower triangle, `(row, column, entry)`.
    pub lower: Vec<(u32, u32, NodeId)>,
    /// `f - sum lagged`, one for each coordinate.
    pub right_side: Vec<NodeId>,
    /// The nodes that hold the solution.
    pub accelerations: Vec<NodeId>,
}

/// `S(left, right)`, with the coefficients of `left` multiplied by their order if `weighted`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub struct Convolution {
    /// The first factor.
    pub left: NodeId,
    /// True if the left factor is `j left_j`.
    pub weighted: bool,
    /// The second factor.
    pub right: NodeId,
}

/// Recurrences of all nodes that the rate depends on.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct TaylorTape {
    /// Nodes in order of evaluation.
    pub nodes: Vec<SeriesNode>,
    /// Rate of every state.
    pub rate: Vec<NodeId>,
    /// Mass matrix, if it is variable and couples coordinates.
    pub mass_matrix: Option<MassMatrix>,
}

impl std::ops::Index<NodeId> for TaylorTape {
    type Output = SeriesNode;
    fn index(&self, id: NodeId) -> &SeriesNode {
        &self.nodes[id.0 as usize]
    }
}

impl TaylorTape {
    /// Returns whether a node is the same at all times.
    #[must_use]
    pub fn is_constant(&self, id: NodeId) -> bool {
        self[id].extent == Extent::Constant
    }

    /// Returns whether a node is linear in time, so that a product with it needs no sum.
    #[must_use]
    pub fn is_line(&self, id: NodeId) -> bool {
        self[id].extent == Extent::Line
    }

    /// Returns whether the motion has corners that the coefficients do not announce, for runs that
    /// are split at `jumps` discontinuities of the rate in time.
    ///
    /// A comparison of time with a constant is one of these discontinuities. If there are more
    /// comparisons than discontinuities, one of them is a switching surface. Poles and roots are no
    /// corners: the growth of the coefficients shows that one is near.
    #[must_use]
    pub fn has_corners(&self, jumps: usize) -> bool {
        let mut switches: Vec<(NodeId, NodeId)> = Vec::new();
        let live: Vec<NodeId> = self.nodes.iter().filter_map(|node| self.live_of(node)).collect();
        let is_corner = |(index, node): (usize, &SeriesNode)| match node.recurrence {
            Recurrence::Select { lhs, .. } if self.is_held(lhs) => false,
            _ if live.contains(&NodeId(index as u32)) => false,
            Recurrence::Select { lhs, rhs, .. } => {
                let switches_once = [(lhs, rhs), (rhs, lhs)].into_iter().any(|(time, at)| {
                    self[time].recurrence == Recurrence::Time && self.is_constant(at)
                });
                if switches_once && !switches.contains(&(lhs, rhs)) {
                    switches.push((lhs, rhs));
                }
                let rests = self.rests(lhs) && self.rests(rhs);
                !(rests || switches_once)
            }
            Recurrence::Table { .. } | Recurrence::Integral { function: Function::Floor, .. } => {
                true
            }
            _ => false,
        };
        let has_corners = self.nodes.iter().enumerate().any(is_corner);
        has_corners || switches.len() > jumps
    }

    /// Returns whether the left side of a comparison contains a slot: a sum with one, compared with
    /// zero, or the slot itself, compared with the largest number.
    fn is_held(&self, lhs: NodeId) -> bool {
        let is_slot = |id: NodeId| matches!(self[id].recurrence, Recurrence::Constant(Op::Held(_)));
        match self[lhs].recurrence {
            Recurrence::Add(a, b) | Recurrence::Sub(a, b) => is_slot(a) || is_slot(b),
            _ => is_slot(lhs),
        }
    }

    /// Returns the integer that a node chooses while its relation is live.
    fn live_of(&self, node: &SeriesNode) -> Option<NodeId> {
        let is_whole = |id: NodeId| {
            matches!(self[id].recurrence, Recurrence::Integral { function: Function::Floor, .. })
        };
        match node.recurrence {
            Recurrence::Select { lhs, otherwise, .. } if self.is_held(lhs) => {
                Some(otherwise).filter(|id| is_whole(*id))
            }
            _ => None,
        }
    }

    /// Returns whether a node is constant along a motion: a constant or a mode.
    fn rests(&self, id: NodeId) -> bool {
        let is_zero =
            |rate: &NodeId| self[*rate].recurrence == Recurrence::Constant(Op::Literal(0.0));
        match self[id].recurrence {
            Recurrence::State(entry) => self.rate.get(entry as usize).is_some_and(is_zero),
            _ => self.is_constant(id),
        }
    }

    /// Returns the sums in a node's k-th coefficient that are written as sums, none if a factor is
    /// linear in time, where the sum is a single product.
    #[must_use]
    pub fn convolutions(&self, id: NodeId) -> Vec<Convolution> {
        match self[id].recurrence {
            Recurrence::Product(a, b) if self.is_line(a) || self.is_line(b) => vec![],
            Recurrence::Integral { argument, .. } if self.is_line(argument) => vec![],
            _ => self.all_convolutions(id),
        }
    }

    /// Returns all sums in a node's k-th coefficient, also those with a factor linear in time.
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

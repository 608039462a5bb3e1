//! Features near a place: a bump on a path, by `exp(-((x - place)/width)^2)`, say, or a magnet by
//! `1/(1 + (x/width)^2)^2`.
//!
//! From far away they have no effect, so a long step passes over them. Steps end where they come
//! near and where they leave, and so are no longer inside than the feature is wide. The guard grows
//! like the distance, both inside and far away, so that the watch can predict it: (1 + d^2)^(1/4),
//! where d is how many powers of e an exponential is below its largest value.
//!
//! A single step by `tanh` has an effect behind it. Two may be the ends of a window, and the square
//! of one is a bell.

use machinist_algebra::expr::Graph;
use machinist_model::{Function, NodeId, Op};

use super::extent::{Extents, States};
use super::{By, Given, Search, reached};

/// Powers of e below the largest value at which an exponential has no effect.
const EXPONENTIAL: f64 = 25.0;
/// Factor by which a power of the distance is below its largest value at the border of its zone:
/// its effect reaches far.
const ALGEBRAIC: f64 = 100.0;
/// Ratio to its least value above which a divisor makes a pulse: the distance, its root, is then
/// ten times that at the border of the zone of [`ALGEBRAIC`].
const RECURS: f64 = 1e4;
/// Argument at which `tanh` and `cosh` are at their limits, up to e^-24.
const SATURATED: f64 = 12.0;

/// Distance of a state from a feature, and the distance from which on it is near.
struct Bell {
    far: NodeId,
    near: f64,
    is_of_place: bool,
    /// Argument of its function, if that is flat far away.
    argument: Option<NodeId>,
}

/// Returns the guards of states that come near to bells among nodes, or leave them, with the
/// arguments of functions that are flat far away.
pub(super) fn near(
    search: &Search<'_>,
    graph: &mut Graph,
    nodes: &[NodeId],
    given: &Given<'_>,
) -> Vec<(NodeId, Option<NodeId>)> {
    let mut bells = Bells {
        search,
        given,
        anywhere: Extents::new(given, States::Anywhere),
        at_start: Extents::new(given, States::AtStart),
        varies: By::State,
    };
    let mut found = Vec::new();
    for &id in nodes {
        found.extend(bells.exponential(graph, id));
        found.extend(bells.algebraic(graph, id));
    }
    found.extend(bells.windows(graph, nodes));
    found.retain(|Bell { far, near, is_of_place, .. }| {
        // The feature of a friction law at rest has its effect where the machine starts.
        let start = bells.at_start.of(graph, *far);
        *is_of_place || start.is_some_and(|far| far.start() > near)
    });
    let mut guard = |Bell { far, near, argument, .. }: &Bell| {
        let near = graph.literal(*near);
        (graph.sub(near, *far), *argument)
    };
    found.iter().map(&mut guard).collect()
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum End {
    Low,
    High,
}

impl End {
    fn other(self) -> Self {
        if self == Self::Low { Self::High } else { Self::Low }
    }
}

struct Bells<'a> {
    search: &'a Search<'a>,
    given: &'a Given<'a>,
    anywhere: Extents<'a>,
    at_start: Extents<'a>,
    /// Quantity that varies freely in the search for the extrema of a node: time, for a node of
    /// time alone; otherwise states, at each time.
    varies: By,
}

impl Bells<'_> {
    fn is_of_state(&self, id: NodeId) -> bool {
        self.search.by[&id] == By::State
    }

    fn is_of_place(&self, graph: &Graph, id: NodeId) -> bool {
        let is_place = |id: &NodeId| match graph.op(*id) {
            Op::State(entry) => self.given.is_place[entry as usize],
            _ => false,
        };
        reached(graph, &[id]).iter().any(is_place)
    }

    /// Returns the bell of e^u, which is far below its largest value where u is far below its
    /// maximum.
    fn exponential(&mut self, graph: &mut Graph, id: NodeId) -> Option<Bell> {
        let Op::Call(Function::Exp, argument) = graph.op(id) else { return None };
        self.varies = self.search.by[&argument];
        // For a polynomial of time the time is known.
        if self.varies == By::Nothing || self.search.polynomials[&argument].is_some() {
            return None;
        }
        let (low, high) = self.anywhere.of(graph, argument)?.into_inner();
        let end = match (low.is_finite(), high.is_finite()) {
            (false, true) => End::High,
            // In a denominator.
            (true, false) => End::Low,
            // In every period.
            (true, true) if high - low > EXPONENTIAL => End::High,
            _ => return None,
        };
        let end = self.end(graph, argument, end)?;
        self.varies = By::State;
        let depth = graph.sub(end, argument);
        let far = root_of_one_and(graph, depth);
        let far = graph.call(Function::Sqrt, far);
        let near = (1.0 + EXPONENTIAL * EXPONENTIAL).sqrt().sqrt();
        let is_of_place =
            self.search.by[&argument] == By::Time || self.is_of_place(graph, argument);
        Some(Bell { far, near, is_of_place, argument: Some(argument) })
    }

    /// Returns the bell of a quotient, where the divisor is many times its least value.
    fn algebraic(&mut self, graph: &mut Graph, id: NodeId) -> Option<Bell> {
        self.varies = By::State;
        let below = match graph.op(id) {
            Op::Div(_, divisor) => (divisor, 1.0),
            Op::Powi(base, power) if power < 0 => (base, -f64::from(power)),
            Op::Powf(base, power) => (base, -self.anywhere.of(graph, power)?.end()),
            _ => return None,
        };
        let (divisor, power) = self.base(graph, below);
        // The reciprocal of a distance has an effect everywhere.
        if !self.is_of_state(divisor) || power < 0.75 {
            return None;
        }
        if let Op::Call(Function::Cosh, argument) = graph.op(divisor) {
            return Some(self.step(graph, argument));
        }
        let grows_fast = |id: &NodeId| {
            matches!(graph.op(*id), Op::Call(Function::Exp | Function::Cosh | Function::Sinh, _))
        };
        let (low, high) = self.anywhere.of(graph, divisor)?.into_inner();
        // With a sine it recurs in every period.
        let is_in_turns = high.is_finite() && high > RECURS * low;
        let is_bell = low > 0.0 && (high.is_infinite() || is_in_turns);
        if !is_bell || reached(graph, &[divisor]).iter().any(grows_fast) {
            return None;
        }
        let least = self.end(graph, divisor, End::Low)?;
        let ratio = graph.div(divisor, least);
        let far = graph.call(Function::Sqrt, ratio);
        // Only the start tells whether a machine goes far away from what it is built around, such
        // as a bobbin from its radius.
        let is_of_place = is_in_turns && self.is_of_place(graph, divisor);
        let near = ALGEBRAIC.powf(0.5 / power).max(2.0);
        Some(Bell { far, near, is_of_place, argument: None })
    }

    /// Returns the base of a power, except for factors that no state changes, with the exponent.
    fn base(&self, graph: &Graph, (id, power): (NodeId, f64)) -> (NodeId, f64) {
        let (base, exponent) = graph.as_power(id);
        if exponent > 1 {
            return self.base(graph, (base, f64::from(exponent) * power));
        }
        match graph.op(id) {
            Op::Mul(a, b) if !self.is_of_state(a) => self.base(graph, (b, power)),
            Op::Mul(a, b) if !self.is_of_state(b) => self.base(graph, (a, power)),
            Op::Call(Function::Sqrt, a) => self.base(graph, (a, 0.5 * power)),
            _ => (id, power),
        }
    }

    /// Returns the steps of places, if two of them may be the ends of a window, or one is squared.
    fn windows(&mut self, graph: &mut Graph, nodes: &[NodeId]) -> Vec<Bell> {
        let step = |id: NodeId| match graph.op(id) {
            Op::Call(Function::Tanh, argument) => Some(argument),
            _ => None,
        };
        // 1/(1 + exp(-u)) is (1 + tanh(u/2))/2.
        let logistic = |id: NodeId| Some(graph.plus_exponential(id)?.argument);
        let either = |id: NodeId| step(id).or_else(|| logistic(id));
        let is_squared = |id: &NodeId| {
            let (base, power) = graph.as_power(*id);
            power > 1 && either(base).is_some()
        };
        let mut is_bell = nodes.iter().any(is_squared);
        let mut arguments: Vec<NodeId> = nodes.iter().filter_map(|id| either(*id)).collect();
        arguments.retain(|id| self.is_of_place(graph, *id));
        arguments.sort_unstable();
        arguments.dedup();
        is_bell |= arguments.len() > 1;
        // Without its sign: 1/((1 + e^u) (1 + e^-u)) has two steps at one place.
        let size = |id: &mut NodeId| {
            if let Op::Neg(a) = graph.op(*id) {
                *id = a;
            }
        };
        arguments.iter_mut().for_each(size);
        arguments.sort_unstable();
        arguments.dedup();
        arguments.retain(|id| is_bell && self.goes_anywhere(graph, *id));
        arguments.into_iter().map(|argument| self.step(graph, argument)).collect()
    }

    fn goes_anywhere(&mut self, graph: &Graph, id: NodeId) -> bool {
        self.anywhere
            .of(graph, id)
            .is_some_and(|extent| extent.start().is_infinite() && extent.end().is_infinite())
    }

    /// Returns the bell where the argument of `tanh` or `cosh` is large.
    fn step(&self, graph: &mut Graph, argument: NodeId) -> Bell {
        let is_of_place = self.is_of_place(graph, argument);
        let far = root_of_one_and(graph, argument);
        Bell { far, near: SATURATED, is_of_place, argument: Some(argument) }
    }

    /// Returns the minimum or maximum of a node over all states.
    fn end(&mut self, graph: &mut Graph, id: NodeId, end: End) -> Option<NodeId> {
        if self.search.by[&id] < self.varies {
            return Some(id);
        }
        match graph.op(id) {
            Op::Neg(a) => {
                let a = self.end(graph, a, end.other())?;
                Some(graph.neg(a))
            }
            Op::Add(a, b) => {
                let (a, b) = (self.end(graph, a, end)?, self.end(graph, b, end)?);
                Some(graph.add(a, b))
            }
            Op::Sub(a, b) => {
                let (a, b) = (self.end(graph, a, end)?, self.end(graph, b, end.other())?);
                Some(graph.sub(a, b))
            }
            Op::Mul(a, b) if a == b => {
                let size = self.size(graph, a, end)?;
                Some(graph.mul(size, size))
            }
            Op::Powi(a, power) if power > 0 && power % 2 == 0 => {
                let size = self.size(graph, a, end)?;
                Some(graph.powi(size, power))
            }
            Op::Powi(a, power) if power > 0 => {
                let a = self.end(graph, a, end)?;
                Some(graph.powi(a, power))
            }
            Op::Mul(a, b) if self.search.by[&a] < self.varies => {
                let end = self.times(graph, a, end)?;
                let b = self.end(graph, b, end)?;
                Some(graph.mul(a, b))
            }
            Op::Mul(a, b) if self.search.by[&b] < self.varies => {
                let end = self.times(graph, b, end)?;
                let a = self.end(graph, a, end)?;
                Some(graph.mul(a, b))
            }
            Op::Mul(a, b) => {
                let mut is_positive = |id: NodeId| self.times(graph, id, end) == Some(end);
                let (true, true) = (is_positive(a), is_positive(b)) else { return None };
                let (a, b) = (self.end(graph, a, end)?, self.end(graph, b, end)?);
                Some(graph.mul(a, b))
            }
            Op::Div(a, b) if self.search.by[&b] < self.varies => {
                let end = self.times(graph, b, end)?;
                let a = self.end(graph, a, end)?;
                Some(graph.div(a, b))
            }
            Op::Powf(a, power) if self.search.by[&power] < self.varies => {
                let end = self.times(graph, power, end)?;
                let a = self.end(graph, a, end)?;
                Some(graph.powf(a, power))
            }
            Op::Call(function @ (Function::Sqrt | Function::Exp), a) => {
                let a = self.end(graph, a, end)?;
                Some(graph.call(function, a))
            }
            Op::Call(Function::Abs, a) => {
                let size = self.size(graph, a, end)?;
                Some(graph.call(Function::Abs, size))
            }
            Op::Call(Function::Sin | Function::Cos, _) => {
                Some(graph.literal(if end == End::Low { -1.0 } else { 1.0 }))
            }
            _ => None,
        }
    }

    /// Returns the end of a factor that gives this end of its product with a node.
    fn times(&mut self, graph: &Graph, id: NodeId, end: End) -> Option<End> {
        let (low, high) = self.anywhere.of(graph, id)?.into_inner();
        (low >= 0.0 || high <= 0.0).then_some(if low >= 0.0 { end } else { end.other() })
    }

    /// Returns the value at which the magnitude of a node is minimal or maximal: zero, if possible.
    fn size(&mut self, graph: &mut Graph, id: NodeId, end: End) -> Option<NodeId> {
        let (low, high) = self.anywhere.of(graph, id)?.into_inner();
        if low >= 0.0 {
            self.end(graph, id, end)
        } else if high <= 0.0 {
            self.end(graph, id, end.other())
        } else {
            (end == End::Low).then(|| graph.literal(0.0))
        }
    }
}

/// sqrt(1 + a^2)
fn root_of_one_and(graph: &mut Graph, a: NodeId) -> NodeId {
    let (one, square) = (graph.literal(1.0), graph.mul(a, a));
    let sum = graph.add(one, square);
    graph.call(Function::Sqrt, sum)
}

//! Operations of a whole scene, each stored once.

use machinist_model::{Function, Node, NodeId, Op, OpKey, TableId, Tape, reachable, reachable_at};
use rustc_hash::FxHashMap;

use super::fold;
use super::held::Held;
use super::{ConstraintId, Expr, HelperId, Symbol};

/// Operations in order of creation, with equal ones shared; functions of the scene are parts of the
/// graph.
#[derive(Debug, Default)]
pub struct Graph {
    pub(super) nodes: Vec<Node>,
    known: FxHashMap<OpKey, NodeId>,
    /// True for nodes that depend on parameters and literals only; see [`super::terms`].
    constant: Vec<bool>,
    /// Entries of the state by their symbols in expressions.
    entries: FxHashMap<Symbol, u32>,
    accelerations: Vec<NodeId>,
    multipliers: Vec<NodeId>,
    unloaded: FxHashMap<ConstraintId, NodeId>,
    helpers: FxHashMap<HelperId, NodeId>,
    /// Nodes of shared parts, by their digests.
    pub(super) shared: FxHashMap<u128, NodeId>,
    /// Relations that tapes hold.
    pub(super) held: Held,
}

/// a + b e^v.
#[derive(Debug, Clone, Copy)]
pub struct PlusExponential {
    /// a.
    pub a: NodeId,
    /// b; `None` is 1.
    pub b: Option<NodeId>,
    /// v.
    pub argument: NodeId,
}

impl Graph {
    /// Returns a graph for one expression, whose symbols get entries in order of appearance.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// Returns a graph for a scene with the state `symbols`, in this order.
    #[must_use]
    pub fn for_scene(symbols: impl Iterator<Item = Symbol>) -> Self {
        Graph { entries: symbols.zip(0..).collect(), ..Self::default() }
    }

    /// Sets the nodes of q'' and of the multipliers of constraints.
    pub fn set_accelerations(&mut self, accelerations: Vec<NodeId>, multipliers: Vec<NodeId>) {
        self.accelerations = accelerations;
        self.multipliers = multipliers;
    }

    /// Sets the nodes of the multipliers without forces in proportion to their sizes.
    pub fn set_unloaded(&mut self, nodes: impl IntoIterator<Item = (ConstraintId, NodeId)>) {
        self.unloaded.extend(nodes);
    }

    /// Sets the node of a helper.
    pub fn set_helper(&mut self, id: HelperId, node: NodeId) {
        self.helpers.insert(id, node);
    }

    /// Adds an expression and returns its node.
    ///
    /// # Panics
    /// If the expression contains accelerations or helpers that are not set.
    pub fn lower(&mut self, expr: &Expr) -> NodeId {
        super::terms::lower(self, expr)
    }

    pub(super) fn symbol(&mut self, symbol: Symbol) -> NodeId {
        match symbol {
            Symbol::Pi => self.literal(std::f64::consts::PI),
            Symbol::Time => self.time(),
            Symbol::Coordinate(_) | Symbol::Velocity(_) | Symbol::FirstOrder(_) => {
                let next = self.entries.len() as u32;
                let entry = *self.entries.entry(symbol).or_insert(next);
                self.push(Op::State(entry))
            }
            Symbol::Parameter(id) => self.parameter(id.0),
            Symbol::Handed(id) => self.push(Op::Handed(id.0)),
            Symbol::Acceleration(id) => self.accelerations[id.0 as usize],
            Symbol::Multiplier(id) => self.multipliers[id.0 as usize],
            Symbol::Unloaded(id) => {
                // Where no such force acts, it is the multiplier.
                let own = self.unloaded.get(&id).copied();
                own.unwrap_or_else(|| self.multipliers[id.0 as usize])
            }
            Symbol::Helper(id) => self.helpers[&id],
        }
    }

    /// Names a node if it is an operation without a name; the first name remains.
    pub fn name(&mut self, id: NodeId, ident: &str) {
        let node = &mut self.nodes[id.0 as usize];
        if node.op.is_arithmetic() && node.name.is_none() {
            node.name = Some(ident.to_owned());
        }
    }

    /// Returns whether a node has a name.
    #[must_use]
    pub fn is_named(&self, id: NodeId) -> bool {
        self.nodes[id.0 as usize].name.is_some()
    }

    /// Adds a finite literal.
    pub fn literal(&mut self, value: f64) -> NodeId {
        // Minus zero would hide equal operations.
        self.push(Op::Literal(if value == 0.0 { 0.0 } else { value }))
    }

    /// Returns the value of a literal node.
    #[must_use]
    pub fn literal_value(&self, id: NodeId) -> Option<f64> {
        match self.nodes[id.0 as usize].op {
            Op::Literal(value) => Some(value),
            _ => None,
        }
    }

    /// Returns whether a node is the literal zero.
    #[must_use]
    pub fn is_zero(&self, id: NodeId) -> bool {
        matches!(self.nodes[id.0 as usize].op, Op::Literal(value) if value == 0.0)
    }

    /// Returns for each node whether it is zero for all states, parameters and times, even if its
    /// structure does not show it.
    #[must_use]
    pub fn vanishing(&self) -> Vec<bool> {
        super::vanishing::vanishing(&self.nodes)
    }

    /// Returns whether a node depends on parameters and literals only.
    #[must_use]
    pub fn is_constant(&self, id: NodeId) -> bool {
        self.constant[id.0 as usize]
    }

    /// Returns the operation of a node.
    #[must_use]
    pub fn op(&self, id: NodeId) -> Op {
        self.nodes[id.0 as usize].op
    }

    /// Adds time t.
    pub fn time(&mut self) -> NodeId {
        self.push(Op::Time)
    }

    /// Adds an entry of the parameters.
    pub fn parameter(&mut self, index: u32) -> NodeId {
        self.push(Op::Parameter(index))
    }

    /// Adds -a.
    pub fn neg(&mut self, a: NodeId) -> NodeId {
        self.push(Op::Neg(a))
    }
    /// Adds a + b.
    pub fn add(&mut self, a: NodeId, b: NodeId) -> NodeId {
        self.push(Op::Add(a, b))
    }
    /// Adds a - b.
    pub fn sub(&mut self, a: NodeId, b: NodeId) -> NodeId {
        self.push(Op::Sub(a, b))
    }
    /// Adds a b.
    pub fn mul(&mut self, a: NodeId, b: NodeId) -> NodeId {
        self.push(Op::Mul(a, b))
    }
    /// Adds a / b.
    pub fn div(&mut self, a: NodeId, b: NodeId) -> NodeId {
        self.push(Op::Div(a, b))
    }
    /// Adds a^n; small powers are products.
    pub fn powi(&mut self, a: NodeId, exponent: i32) -> NodeId {
        match exponent {
            0 => self.literal(1.0),
            1 => a,
            2 => self.mul(a, a),
            3 => {
                let square = self.mul(a, a);
                self.mul(square, a)
            }
            4 => {
                let square = self.mul(a, a);
                self.mul(square, square)
            }
            _ if exponent < 0 => {
                let power = self.powi(a, -exponent);
                let one = self.literal(1.0);
                self.div(one, power)
            }
            _ => self.push(Op::Powi(a, exponent)),
        }
    }
    /// Returns base and exponent of a power made by [`Graph::powi`]; for any other node the node
    /// and 1.
    #[must_use]
    pub fn as_power(&self, id: NodeId) -> (NodeId, i32) {
        let is_square = |id: NodeId, of: NodeId| self.op(id) == Op::Mul(of, of);
        match self.op(id) {
            Op::Powi(base, exponent) => (base, exponent),
            Op::Mul(a, b) if a == b => match self.op(a) {
                Op::Mul(c, d) if c == d => (c, 4),
                _ => (a, 2),
            },
            Op::Mul(a, b) if is_square(a, b) => (b, 3),
            Op::Mul(a, b) if is_square(b, a) => (a, 3),
            _ => (id, 1),
        }
    }
    /// Returns the parts of a + b e^v, where a and b depend on parameters only.
    #[must_use]
    pub fn plus_exponential(&self, id: NodeId) -> Option<PlusExponential> {
        let Op::Add(first, second) = self.op(id) else { return None };
        let argument = |id: NodeId| match self.op(id) {
            Op::Call(Function::Exp, argument) => Some(argument),
            _ => None,
        };
        let term = |id: NodeId| match self.op(id) {
            Op::Mul(a, b) => [(a, b), (b, a)]
                .into_iter()
                .filter(|(factor, _)| self.is_constant(*factor))
                .find_map(|(factor, exp)| Some((Some(factor), argument(exp)?))),
            _ => argument(id).map(|argument| (None, argument)),
        };
        [(first, second), (second, first)].into_iter().find_map(|(a, rest)| {
            let (b, argument) = term(rest)?;
            self.is_constant(a).then_some(PlusExponential { a, b, argument })
        })
    }
    /// Adds a^b.
    pub fn powf(&mut self, a: NodeId, b: NodeId) -> NodeId {
        self.push(Op::Powf(a, b))
    }
    /// Adds a function of one argument.
    pub fn call(&mut self, function: Function, a: NodeId) -> NodeId {
        self.push(Op::Call(function, a))
    }
    /// Adds a selection: `then` if lhs < rhs, else `otherwise`.
    pub fn select_less(
        &mut self,
        lhs: NodeId,
        rhs: NodeId,
        then: NodeId,
        otherwise: NodeId,
    ) -> NodeId {
        self.push(Op::SelectLess { lhs, rhs, then, otherwise })
    }
    /// Adds an operation on nodes of this graph.
    pub fn insert(&mut self, op: Op) -> NodeId {
        self.push(op)
    }
    /// Adds a table or a derivative of it.
    pub fn table(&mut self, table: TableId, order: u32, argument: NodeId) -> NodeId {
        self.push(Op::Table { table, order, argument })
    }

    /// Folds an operation, then finds or appends it.
    pub(super) fn push(&mut self, op: Op) -> NodeId {
        let op = match fold::fold(self, op) {
            fold::Folded::Node(id) => return id,
            fold::Folded::Op(op) => op,
        };
        let key = op.key();
        if let Some(id) = self.known.get(&key) {
            return *id;
        }
        let id = NodeId(self.nodes.len() as u32);
        let constant = match op {
            Op::Literal(_) | Op::Parameter(_) | Op::Constant(_) => true,
            Op::Time | Op::State(_) | Op::Handed(_) | Op::Held(_) => false,
            _ => op.operands().iter().all(|operand| self.is_constant(*operand)),
        };
        self.nodes.push(Node { op, name: None });
        self.constant.push(constant);
        self.known.insert(key, id);
        id
    }

    /// Returns the nodes that `results` need, in order, with slots for [held](Graph::hold)
    /// relations, and nothing else.
    #[must_use]
    pub fn tape(&self, results: &[NodeId]) -> Tape {
        if !self.holds_anything() {
            return self.live_tape(results);
        }
        let (tape, places) = reachable_at(&self.nodes, results);
        super::signs::absorb(&self.with_slots(&tape, &places))
    }

    /// Returns the same with every relation live.
    #[must_use]
    pub fn live_tape(&self, results: &[NodeId]) -> Tape {
        super::signs::absorb(&reachable(&self.nodes, results))
    }
}

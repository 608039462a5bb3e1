//! A tape while it is built: equal operations are done once, and those with 0 and 1 not at all.

use rustc_hash::FxHashMap;

use crate::{Function, Node, NodeId, Op, OpKey, Tape, reachable};

#[derive(Default)]
pub(super) struct Builder {
    nodes: Vec<Node>,
    known: FxHashMap<OpKey, NodeId>,
}

impl Builder {
    pub(super) fn put(&mut self, op: Op) -> NodeId {
        let next = NodeId(u32::try_from(self.nodes.len()).expect("few operations"));
        let nodes = &mut self.nodes;
        *self.known.entry(op.key()).or_insert_with(|| {
            nodes.push(Node { op, name: None });
            next
        })
    }

    pub(super) fn literal(&mut self, value: f64) -> NodeId {
        self.put(Op::Literal(value))
    }

    fn value(&self, id: NodeId) -> Option<f64> {
        match self.nodes[id.0 as usize].op {
            Op::Literal(value) => Some(value),
            _ => None,
        }
    }

    pub(super) fn add(&mut self, a: NodeId, b: NodeId) -> NodeId {
        match (self.value(a), self.value(b)) {
            (Some(a), Some(b)) => self.literal(a + b),
            (Some(0.0), _) => b,
            (_, Some(0.0)) => a,
            _ => self.put(Op::Add(a, b)),
        }
    }

    pub(super) fn multiply(&mut self, a: NodeId, b: NodeId) -> NodeId {
        match (self.value(a), self.value(b)) {
            (Some(a), Some(b)) => self.literal(a * b),
            (Some(0.0), _) | (_, Some(1.0)) => a,
            (_, Some(0.0)) | (Some(1.0), _) => b,
            _ => self.put(Op::Mul(a, b)),
        }
    }

    pub(super) fn scale(&mut self, a: NodeId, by: f64) -> NodeId {
        let by = self.literal(by);
        self.multiply(a, by)
    }

    pub(super) fn divide(&mut self, a: NodeId, b: NodeId) -> NodeId {
        match (self.value(a), self.value(b)) {
            (Some(0.0), _) | (_, Some(1.0)) => a,
            _ => self.put(Op::Div(a, b)),
        }
    }

    /// Returns 1/a, which is computed once a run where parameters alone determine it.
    pub(super) fn inverse(&mut self, a: NodeId) -> NodeId {
        let one = self.literal(1.0);
        self.divide(one, a)
    }

    /// Returns a difference.
    fn subtract(&mut self, a: NodeId, b: NodeId) -> NodeId {
        match (self.value(a), self.value(b)) {
            (Some(a), Some(b)) => self.literal(a - b),
            (_, Some(0.0)) => a,
            (Some(0.0), _) => self.negate(b),
            _ => self.put(Op::Sub(a, b)),
        }
    }

    fn negate(&mut self, a: NodeId) -> NodeId {
        match self.value(a) {
            Some(value) => self.literal(-value),
            None => self.put(Op::Neg(a)),
        }
    }

    /// Puts an operation, or its result where that is a literal or one of the operands.
    pub(super) fn folded(&mut self, op: Op) -> NodeId {
        match op {
            Op::Neg(a) => self.negate(a),
            Op::Add(a, b) => self.add(a, b),
            Op::Sub(a, b) => self.subtract(a, b),
            Op::Mul(a, b) => self.multiply(a, b),
            Op::Div(a, b) => self.divide(a, b),
            Op::Call(Function::Abs, a) => match self.value(a) {
                Some(value) => self.literal(value.abs()),
                None => self.put(op),
            },
            Op::SelectLess { lhs, rhs, then, otherwise } => {
                match (self.value(lhs), self.value(rhs)) {
                    (Some(lhs), Some(rhs)) => {
                        if lhs < rhs {
                            then
                        } else {
                            otherwise
                        }
                    }
                    _ if then == otherwise => then,
                    _ => self.put(op),
                }
            }
            _ => self.put(op),
        }
    }

    /// Reports whether a node is the literal zero.
    pub(super) fn is_zero(&self, id: NodeId) -> bool {
        self.value(id) == Some(0.0)
    }

    /// Copies a tape; `read` gives the nodes of what it reads. Returns its results.
    pub(super) fn copy(
        &mut self,
        tape: &Tape,
        mut read: impl FnMut(&mut Self, Op) -> NodeId,
    ) -> Vec<NodeId> {
        let mut places: Vec<NodeId> = Vec::with_capacity(tape.nodes.len());
        for node in &tape.nodes {
            let op = node.op.with_operands(|id| places[id.0 as usize]);
            let is_read = node.op.operands().is_empty() && !matches!(op, Op::Literal(_));
            let place = if is_read { read(self, op) } else { self.put(op) };
            places.push(place);
        }
        tape.results.iter().map(|id| places[id.0 as usize]).collect()
    }

    /// Copies a function of a point of a field, at u, u_x, u_t, u_xt and x.
    pub(super) fn at_point(&mut self, tape: &Tape, state: [NodeId; 5]) -> Vec<NodeId> {
        self.copy(tape, |builder, op| match op {
            Op::State(index) => state[index as usize],
            other => builder.put(other),
        })
    }

    pub(super) fn tape(self, results: &[NodeId]) -> Tape {
        reachable(&self.nodes, results)
    }
}

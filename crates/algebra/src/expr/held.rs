//! Slots of relations that steps hold, inserted into tapes.
//!
//! ```text
//! a < b ? x : y     becomes   a + s < b ? x : y        s = -inf below, inf above, 0 live
//! |a|               becomes   a + s < 0 ? -a : a       likewise
//! floor(a)          becomes   s < largest ? s : floor(a)    s = n, or inf live
//! ```
//!
//! where s is the slot of the relation, or minus the slot if its guard is b - a. With live
//! relations, every result is bitwise unchanged, except for the sign of a zero.

use machinist_model::{Function, Node, NodeId, Op, Tape};
use rustc_hash::FxHashMap;

use super::Graph;
use super::vanishing::at_points;

/// The comparison of a relation.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Compared {
    /// The first is less than the second.
    Less(NodeId, NodeId),
    /// The two integers between which this lies.
    Whole(NodeId),
}

/// The slot of a relation.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Slot {
    /// Index of the relation.
    pub index: u32,
    /// True if the relation's guard is minus that of the comparison.
    pub is_opposite: bool,
}

impl Compared {
    /// Returns the comparison of an operation, if it has one.
    pub fn at(graph: &mut Graph, id: NodeId) -> Option<Self> {
        match graph.op(id) {
            Op::SelectLess { lhs, rhs, .. } => Some(Self::Less(lhs, rhs)),
            Op::Call(Function::Abs, a) => Some(Self::Less(a, graph.literal(0.0))),
            Op::Call(Function::Floor, a) => Some(Self::Whole(a)),
            _ => None,
        }
    }

    /// Returns the guard, which crosses zero where the comparison changes; for integers, the
    /// argument.
    pub fn guard(self, graph: &mut Graph) -> NodeId {
        match self {
            Self::Less(lhs, rhs) => graph.sub(lhs, rhs),
            Self::Whole(argument) => argument,
        }
    }
}

/// Slots of a scene, by comparison.
#[derive(Debug, Default)]
pub(super) struct Held {
    slots: FxHashMap<Compared, Slot>,
    /// Index of the first slot among the parameters.
    first: u32,
    /// The literal zero.
    zero: Option<NodeId>,
}

/// A node as a rational multiple of another one.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Multiple {
    /// Index of the other node, the node itself included.
    pub of: usize,
    /// True if the factor is negative.
    pub is_opposite: bool,
}

impl Graph {
    /// Returns the first of the nodes of which each is a rational multiple, for all states,
    /// parameters and times; found by values at random points.
    #[must_use]
    pub fn multiples(&self, nodes: &[NodeId]) -> Vec<Multiple> {
        let values = at_points(&self.nodes);
        let of = |index: usize| values[nodes[index].0 as usize].as_ref();
        let factor = |index: usize, other: usize| {
            let (mut values, mut others) = (of(index)?.iter(), of(other)?.iter());
            let first = values.next()?.times(others.next()?.inverse()?);
            values.zip(others).all(|(value, other)| *value == other.times(first)).then_some(first)
        };
        let of_first = |index: usize| {
            (0..index).find_map(|other| {
                let is_opposite = factor(index, other)?.is_negative()?;
                Some(Multiple { of: other, is_opposite })
            })
        };
        let alone = |index: usize| Multiple { of: index, is_opposite: false };
        (0..nodes.len()).map(|index| of_first(index).unwrap_or_else(|| alone(index))).collect()
    }

    /// Holds relations on all tapes from now on. `first` is the index of the first slot among the
    /// parameters. Equal comparisons are held too, also where derivatives contain them in another
    /// form.
    pub fn hold(&mut self, slots: impl IntoIterator<Item = (Compared, Slot)>, first: u32) {
        let zero = Some(self.literal(0.0));
        let mut slots: FxHashMap<_, _> = slots.into_iter().collect();
        self.add_equal(&mut slots);
        self.held = Held { slots, first, zero };
    }

    /// Adds all comparisons equal to one with a slot, found by values at random points.
    fn add_equal(&mut self, slots: &mut FxHashMap<Compared, Slot>) {
        if slots.is_empty() {
            return;
        }
        let compared: Vec<Compared> = (0..self.nodes.len())
            .filter_map(|index| Compared::at(self, NodeId(index as u32)))
            .collect();
        let values = at_points(&self.nodes);
        let of = |compared: Compared| match compared {
            Compared::Less(lhs, rhs) => {
                let [lhs, rhs] = [lhs, rhs].map(|id| values[id.0 as usize].as_ref());
                let pairs = lhs?.iter().zip(rhs?);
                Some((false, pairs.map(|(lhs, rhs)| lhs.plus(rhs.minus())).collect::<Vec<_>>()))
            }
            Compared::Whole(argument) => Some((true, values[argument.0 as usize].clone()?)),
        };
        let mut known = FxHashMap::default();
        for (compared, slot) in &*slots {
            let Some((is_whole, guard)) = of(*compared) else { continue };
            if !is_whole {
                let opposite = guard.iter().map(|value| value.minus()).collect::<Vec<_>>();
                let slot = Slot { is_opposite: !slot.is_opposite, ..*slot };
                known.insert((is_whole, opposite), slot);
            }
            known.insert((is_whole, guard), *slot);
        }
        for compared in compared {
            if let Some(slot) = of(compared).and_then(|guard| known.get(&guard)) {
                slots.entry(compared).or_insert(*slot);
            }
        }
    }

    /// Returns a tape with slots where relations are held.
    pub(super) fn with_slots(&self, tape: &Tape, places: &[NodeId]) -> Tape {
        let mut again = Again { tape: Tape::default(), known: FxHashMap::default() };
        let mut moved: Vec<NodeId> = Vec::with_capacity(tape.nodes.len());
        for (node, original) in tape.nodes.iter().zip(places) {
            let op = node.op.with_operands(|id| moved[id.0 as usize]);
            let slot = self.slot_at(*original);
            let op = slot.map_or(op, |slot| again.held(op, self.held.first, slot));
            moved.push(again.push(op, node.name.clone()));
        }
        let results = tape.results.iter().map(|id| moved[id.0 as usize]).collect();
        Tape { results, ..again.tape }
    }

    /// Returns the slot of the relation that an operation evaluates, if it is held.
    #[must_use]
    pub fn slot_at(&self, id: NodeId) -> Option<Slot> {
        let compared = match self.op(id) {
            Op::SelectLess { lhs, rhs, .. } => Compared::Less(lhs, rhs),
            Op::Call(Function::Abs, a) => Compared::Less(a, self.held.zero?),
            Op::Call(Function::Floor, a) => Compared::Whole(a),
            _ => return None,
        };
        self.held.slots.get(&compared).copied()
    }

    pub(super) fn holds_anything(&self) -> bool {
        !self.held.slots.is_empty()
    }
}

/// A tape under reconstruction.
struct Again {
    tape: Tape,
    /// Slots, sums with them and literals, each inserted once.
    known: FxHashMap<machinist_model::OpKey, NodeId>,
}

impl Again {
    fn push(&mut self, op: Op, name: Option<String>) -> NodeId {
        self.tape.nodes.push(Node { op, name });
        NodeId(self.tape.nodes.len() as u32 - 1)
    }

    fn once(&mut self, op: Op) -> NodeId {
        if let Some(known) = self.known.get(&op.key()) {
            return *known;
        }
        let id = self.push(op, None);
        self.known.insert(op.key(), id);
        id
    }

    /// Returns the operation with a slot that replaces a comparison.
    fn held(&mut self, op: Op, first: u32, slot: Slot) -> Op {
        let place = self.once(Op::Held(first + slot.index));
        let mut shifted = |a: NodeId| {
            self.once(if slot.is_opposite { Op::Sub(a, place) } else { Op::Add(a, place) })
        };
        match op {
            Op::SelectLess { lhs, rhs, then, otherwise } => {
                Op::SelectLess { lhs: shifted(lhs), rhs, then, otherwise }
            }
            Op::Call(Function::Abs, a) => {
                let lhs = shifted(a);
                let rhs = self.once(Op::Literal(0.0));
                let then = self.once(Op::Neg(a));
                Op::SelectLess { lhs, rhs, then, otherwise: a }
            }
            _ => {
                let rhs = self.once(Op::Literal(f64::MAX));
                let otherwise = self.once(op);
                Op::SelectLess { lhs: place, rhs, then: place, otherwise }
            }
        }
    }
}

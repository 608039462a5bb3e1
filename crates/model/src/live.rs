//! Tapes without slots, in which the state alone decides relations.

use crate::{Model, NodeId, Op, Tape};

impl Tape {
    /// Returns the comparand and the slot of an operation that adds a slot to it, and whether the
    /// slot is subtracted instead.
    #[must_use]
    pub fn shifted(&self, op: Op) -> Option<(NodeId, Op, bool)> {
        let slot = |id: NodeId| Some(self[id].op).filter(|op| matches!(op, Op::Held(_)));
        match op {
            Op::Add(a, b) => slot(b).map(|slot| (a, slot, false)),
            Op::Sub(a, b) => slot(b).map(|slot| (a, slot, true)),
            _ => None,
        }
    }

    /// Returns the tape with every relation live, for hosts that hold none.
    #[must_use]
    pub fn live(&self) -> Self {
        let mut live = Self::default();
        let mut places: Vec<NodeId> = Vec::with_capacity(self.nodes.len());
        let is_slot = |id: NodeId| matches!(self[id].op, Op::Held(_));
        for node in &self.nodes {
            // A slot is added to a comparison, or replaces an integer.
            let stands_for = match node.op {
                Op::SelectLess { lhs, otherwise, .. } if is_slot(lhs) => Some(otherwise),
                op => self.shifted(op).map(|(comparand, ..)| comparand),
            };
            let place = match stands_for {
                Some(other) => places[other.0 as usize],
                None if matches!(node.op, Op::Held(_)) => NodeId(u32::MAX),
                None => {
                    let op = node.op.with_operands(|id| places[id.0 as usize]);
                    live.nodes.push(crate::Node { op, name: node.name.clone() });
                    NodeId(live.nodes.len() as u32 - 1)
                }
            };
            places.push(place);
        }
        live.results = self.results.iter().map(|id| places[id.0 as usize]).collect();
        live
    }
}

impl Model {
    /// Returns the machine with every relation live; the guards of kinks remain.
    #[must_use]
    pub fn live(&self) -> Self {
        let mut live = self.clone();
        if !live.relations.is_empty() {
            live.excitation = None;
        }
        live.relations.clear();
        live.tapes_mut().for_each(|tape| *tape = tape.live());
        live
    }

    /// Iterates over the tapes that may read slots.
    fn tapes_mut(&mut self) -> impl Iterator<Item = &mut Tape> {
        let own = [
            &mut self.discontinuities,
            &mut self.rate,
            &mut self.rate_jacobian.tape,
            &mut self.parameter_jacobian.tape,
            &mut self.time_derivative,
            &mut self.mass_matrix.tape,
            &mut self.forcing,
            &mut self.outputs,
            &mut self.energy,
            &mut self.power_balance,
            &mut self.guards,
            &mut self.guard_rates,
            &mut self.resets,
            &mut self.constraint_values,
            &mut self.constraint_rates,
            &mut self.constraint_matrix.tape,
            &mut self.kink_guards,
            &mut self.kink_rates,
            &mut self.saturating_arguments,
        ];
        own.into_iter().chain(self.motion.as_mut().map(|motion| &mut motion.tape))
    }
}

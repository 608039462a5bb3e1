//! Fused operations: products that are written into the sums that use them.
//!
//! A product is fused if nothing else uses it and the spec gives it no name. Tapes are not
//! changed: if the target has no fused operation, the emitted code does the two operations of the
//! tape and gives the same bits.

use super::plan::count_uses;
use machinist_model::{NodeId, Op, Tape};

/// A sum that contains a product.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Fused {
    /// The other operand of the sum.
    pub(super) summand: NodeId,
    /// True if the summand is subtracted.
    pub(super) is_summand_negative: bool,
    /// Factors of the product.
    pub(super) factors: [NodeId; 2],
    /// True if the product is subtracted.
    pub(super) is_product_negative: bool,
    /// Nodes that are not written separately.
    swallowed: [Option<NodeId>; 2],
}

impl Fused {
    /// Returns the operands that are read.
    pub(super) fn operands(&self) -> [NodeId; 3] {
        [self.summand, self.factors[0], self.factors[1]]
    }
}

/// Returns the fused sum of each node, if it is one.
pub(super) fn fuse(tape: &Tape) -> Vec<Option<Fused>> {
    let uses = count_uses(tape);
    let delays = delays(tape);
    let is_free = |id: NodeId| uses[id.0 as usize] == 1 && tape[id].name.is_none();
    // A product or its negation: factors, sign, and nodes that disappear.
    let product = |id: NodeId| match tape[id].op {
        _ if !is_free(id) => None,
        Op::Mul(a, b) => Some(([a, b], false, [Some(id), None])),
        Op::Neg(inner) if is_free(inner) => match tape[inner].op {
            Op::Mul(a, b) => Some(([a, b], true, [Some(id), Some(inner)])),
            _ => None,
        },
        _ => None,
    };
    let sum = |op: Op| {
        let (a, b, is_difference) = match op {
            Op::Add(a, b) => (a, b, false),
            Op::Sub(a, b) => (a, b, true),
            _ => return None,
        };
        // The product that is ready last is multiplied last.
        let is_first = match (product(a), product(b)) {
            (None, None) => return None,
            (Some(_), Some(_)) => delays[a.0 as usize] > delays[b.0 as usize],
            (first, _) => first.is_some(),
        };
        let (own, summand) = if is_first { (a, b) } else { (b, a) };
        let (factors, is_opposite, swallowed) = product(own)?;
        Some(Fused {
            summand,
            is_summand_negative: is_difference && is_first,
            factors,
            is_product_negative: is_opposite != (is_difference && !is_first),
            swallowed,
        })
    };
    let nodes = tape.nodes.iter().zip(&uses);
    nodes.map(|(node, uses)| if *uses > 0 { sum(node.op) } else { None }).collect()
}

/// Returns, for each node, whether it disappears into a fused sum.
pub(super) fn swallowed(fused: &[Option<Fused>]) -> Vec<bool> {
    let mut swallowed = vec![false; fused.len()];
    for id in fused.iter().flatten().flat_map(|fused| fused.swallowed).flatten() {
        swallowed[id.0 as usize] = true;
    }
    swallowed
}

/// Returns the delay of each node after the inputs, in units of a sum.
fn delays(tape: &Tape) -> Vec<u32> {
    let mut delays: Vec<u32> = Vec::with_capacity(tape.nodes.len());
    for node in &tape.nodes {
        let before = node.op.operands().iter().map(|id| delays[id.0 as usize]).max();
        delays.push(before.unwrap_or(0) + node.op.cost());
    }
    delays
}

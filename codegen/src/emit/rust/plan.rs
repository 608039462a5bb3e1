//! Choice of the nodes of a tape that become a `let`; the others are written where they are used.

use std::collections::BTreeSet;

use super::batch::Step;
use super::fuse::{Fused, swallowed};
use machinist_model::{NodeId, Tape, needed_nodes};

/// Maximum number of operations in one expression.
const LONGEST_EXPRESSION: usize = 24;

/// Place of a node in the emitted code.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(in crate::emit) enum Place {
    /// Not emitted: no result needs it, or it is part of a fused sum.
    Nowhere,
    /// Written into the expression that uses it.
    Inline,
    /// A variable of its own.
    Statement,
}

/// Returns the place of each node. Results of `steps` that are calls for several arguments get a
/// `let`. `spread_results` requests a `let` for each result that is not a leaf, so that a long
/// array of results is readable.
pub(super) fn plan(
    tape: &Tape,
    fused: &[Option<Fused>],
    steps: &[Step],
    spread_results: bool,
) -> Vec<Place> {
    let uses = count_uses(tape);
    let swallowed = swallowed(fused);
    let batched: BTreeSet<usize> = steps
        .iter()
        .filter_map(|step| if let Step::Batch(batch) = step { Some(batch) } else { None })
        .flat_map(|batch| batch.results().map(|id| id.0 as usize))
        .collect();
    let mut places = Vec::with_capacity(tape.nodes.len());
    let mut sizes: Vec<usize> = Vec::with_capacity(tape.nodes.len());
    for (index, (node, &uses)) in tape.nodes.iter().zip(&uses).enumerate() {
        let place = match node.op {
            _ if uses == 0 || swallowed[index] => Place::Nowhere,
            _ if !node.op.is_arithmetic() => Place::Inline,
            _ if uses > 1 || node.name.is_some() || batched.contains(&index) => Place::Statement,
            _ => Place::Inline,
        };
        let operands = match &fused[index] {
            _ if !node.op.is_arithmetic() || swallowed[index] => vec![],
            Some(fused) => fused.operands().to_vec(),
            None => node.op.operands(),
        };
        let size = size_within_limit(&operands, &mut places, &sizes);
        places.push(place);
        sizes.push(size);
    }
    if spread_results {
        for &NodeId(result) in &tape.results {
            let index = result as usize;
            if tape.nodes[index].op.is_arithmetic() {
                places[index] = Place::Statement;
            }
        }
    }
    places
}

/// Returns [`plan`] for a target without fused products.
pub(in crate::emit) fn plain(tape: &Tape, steps: &[Step], spread_results: bool) -> Vec<Place> {
    plan(tape, &vec![None; tape.nodes.len()], steps, spread_results)
}

/// Returns the size of an operation's expression with everything inlined. As long as it is too
/// large, its largest operands get a `let`.
fn size_within_limit(operands: &[NodeId], places: &mut [Place], sizes: &[usize]) -> usize {
    if operands.is_empty() {
        return 0;
    }
    let operands: Vec<usize> = operands.iter().map(|id| id.0 as usize).collect();
    loop {
        let inlined = operands.iter().copied().filter(|&k| places[k] == Place::Inline);
        let size = 1 + inlined.clone().map(|k| sizes[k]).sum::<usize>();
        let largest = inlined.max_by_key(|&k| sizes[k]);
        match largest {
            Some(largest) if size > LONGEST_EXPRESSION && sizes[largest] > 0 => {
                places[largest] = Place::Statement;
            }
            _ => return size,
        }
    }
}

/// Counts the uses of each node by nodes that results need, and as a result.
pub(super) fn count_uses(tape: &Tape) -> Vec<u32> {
    let needed = needed_nodes(tape);
    let mut uses = vec![0_u32; tape.nodes.len()];
    let operands = tape.nodes.iter().zip(needed).filter(|(_, needed)| *needed);
    let operands = operands.flat_map(|(node, _)| node.op.operands());
    for NodeId(used) in operands.chain(tape.results.iter().copied()) {
        uses[used as usize] += 1;
    }
    uses
}

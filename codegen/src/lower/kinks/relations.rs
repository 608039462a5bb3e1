//! Relations that keep a value within its domain, and readers of the others.

use std::collections::HashSet;

use machinist_algebra::expr::Graph;
use machinist_algebra::expr::held::{Compared, Slot};
use machinist_contract::Reader;
use machinist_model::{Function, NodeId, Op};

use super::{Kinks, Places};

/// Returns the comparisons directly under a root, a logarithm, an inverse sine or a power. Held
/// beyond their guard these would have no value, so such branches stay live.
pub(super) fn clamps(graph: &mut Graph, nodes: &[NodeId]) -> HashSet<Compared> {
    let mut open: Vec<NodeId> = Vec::new();
    for &id in nodes {
        match graph.op(id) {
            Op::Call(Function::Sqrt | Function::Ln | Function::Asin | Function::Acos, a)
            | Op::Powf(a, _) => open.push(a),
            Op::Div(_, b) if matches!(graph.op(b), Op::Call(Function::Abs, _)) => open.push(b),
            _ => {}
        }
    }
    let mut found = HashSet::new();
    while let Some(id) = open.pop() {
        match graph.op(id) {
            Op::Mul(a, b) => open.extend([a, b]),
            Op::Neg(a) | Op::Div(a, _) => open.push(a),
            Op::SelectLess { then, otherwise, .. } => {
                found.extend(Compared::at(graph, id));
                open.extend([then, otherwise]);
            }
            Op::Call(Function::Abs, _) => found.extend(Compared::at(graph, id)),
            _ => {}
        }
    }
    found
}

/// Finds the readers of each relation in the motion and the guards.
pub(super) fn readers(graph: &mut Graph, places: &Places<'_>, found: &mut Kinks) {
    let mut open = vec![(Reader::Rate, [places.rate, places.holds].concat())];
    open.extend(
        (0..).zip(places.guards).map(|(event, guard)| (Reader::Event(event), vec![*guard])),
    );
    read(graph, open, found);
}

/// Adds the readers of relations that nodes reach, and those of relations that these read.
pub(super) fn read(graph: &mut Graph, mut open: Vec<(Reader, Vec<NodeId>)>, found: &mut Kinks) {
    let guards = found.slots.iter().map(|(compared, slot)| {
        let operands = match *compared {
            Compared::Less(lhs, rhs) => vec![lhs, rhs],
            Compared::Whole(argument) => vec![argument],
        };
        (Reader::Relation(slot.index), operands)
    });
    open.extend(guards);
    let mut visited = HashSet::new();
    while let Some((reader, nodes)) = open.pop() {
        let mut nodes = nodes;
        while let Some(id) = nodes.pop() {
            if !visited.insert((key(reader), id)) {
                continue;
            }
            let compared = Compared::at(graph, id);
            let slot = found.slots.iter().find(|(known, _)| Some(*known) == compared);
            let Some(&(_, Slot { index, is_opposite })) = slot else {
                nodes.extend(graph.op(id).operands());
                continue;
            };
            let readers = &mut found.relations[index as usize].readers;
            if !readers.contains(&reader) {
                readers.push(reader);
            }
            match graph.op(id) {
                Op::SelectLess { then, otherwise, .. } => {
                    let (below, above) = (Reader::Below(index), Reader::Above(index));
                    let [on_then, on_otherwise] =
                        if is_opposite { [above, below] } else { [below, above] };
                    open.push((on_then, vec![then]));
                    open.push((on_otherwise, vec![otherwise]));
                }
                // Both branches read the argument.
                Op::Call(Function::Abs, argument) => nodes.push(argument),
                _ => {}
            }
        }
    }
    found.relations.iter_mut().for_each(|relation| relation.readers.sort_by_key(|it| key(*it)));
}

fn key(reader: Reader) -> (u8, u32) {
    match reader {
        Reader::Rate => (0, 0),
        Reader::Event(index) => (1, index),
        Reader::Relation(index) => (2, index),
        Reader::Below(index) => (3, index),
        Reader::Above(index) => (4, index),
    }
}

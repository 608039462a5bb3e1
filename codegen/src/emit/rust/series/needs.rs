//! Coefficients that the function of a series reads.

use machinist_model::NodeId;
use machinist_model::series::{Convolution, Recurrence, TaylorTape};

/// The parts of a tape of recurrences that are emitted.
pub(super) struct Needs {
    /// For each node, true if its newest coefficient is read.
    pub(super) newest: Vec<bool>,
    /// For each node, true if the coefficient before its newest is read.
    pub(super) before: Vec<bool>,
    /// For each node, true if it is a product with a constant that a single sum or difference
    /// reads. It is then written within that.
    pub(super) within: Vec<bool>,
    /// All sums, each once; the index is the lane. Neighbours are formed together, so sums whose
    /// factors are ready early precede those that wait for the end of an order.
    pub(super) convolutions: Vec<Convolution>,
    /// For each node, number of dependent operations from the states' coefficients to its newest
    /// coefficient.
    pub(super) depth: Vec<u32>,
}

/// Finds what the rates read, order by order.
pub(super) fn needs(tape: &TaylorTape) -> Needs {
    let count = tape.nodes.len();
    let (mut newest, mut before) = (vec![false; count], vec![false; count]);
    let mut reads = vec![0_u32; count];
    let mut waiting = tape.rate.clone();
    if let Some(mass) = &tape.mass_matrix {
        waiting.extend(&mass.right_side);
        waiting.extend(&mass.accelerations);
    }
    while let Some(id) = waiting.pop() {
        reads[id.0 as usize] += 1;
        if std::mem::replace(&mut newest[id.0 as usize], true) {
            continue;
        }
        waiting.extend(newest_operands(tape, id));
        for convolution in tape.convolutions(id) {
            waiting.extend([convolution.left, convolution.right]);
        }
        if let Some(earlier) = operand_before(tape, id) {
            before[earlier.0 as usize] = true;
            waiting.push(earlier);
        }
    }
    let mut convolutions: Vec<Convolution> = Vec::new();
    for index in (0..count).filter(|&index| newest[index]) {
        for convolution in tape.convolutions(NodeId(index as u32)).into_iter().map(in_order) {
            if !convolutions.contains(&convolution) {
                convolutions.push(convolution);
            }
        }
    }
    let depth = depths(tape);
    let of = |id: NodeId| depth[id.0 as usize];
    convolutions.sort_by_key(|sum| (of(sum.left) + u32::from(sum.weighted)).max(of(sum.right)));
    let mut within = vec![false; count];
    for node in tape.nodes.iter().zip(&newest).filter(|(_, needed)| **needed).map(|(n, _)| n) {
        if let Recurrence::Add(a, b) | Recurrence::Sub(a, b) = node.recurrence {
            for id in [a, b].map(|id| id.0 as usize) {
                let is_scaled = matches!(tape.nodes[id].recurrence, Recurrence::Scaled { .. });
                within[id] = is_scaled && reads[id] == 1;
            }
        }
    }
    Needs { newest, before, within, convolutions, depth }
}

/// Returns the depth of each node. Accelerations come after all others.
fn depths(tape: &TaylorTape) -> Vec<u32> {
    let mut depths = vec![0_u32; tape.nodes.len()];
    for index in 0..tape.nodes.len() {
        let id = NodeId(index as u32);
        let known = |id: &NodeId| depths[id.0 as usize];
        let operands = newest_operands(tape, id);
        depths[index] = match tape[id].recurrence {
            Recurrence::Constant(_) | Recurrence::State(_) | Recurrence::Time => 0,
            _ => operands.iter().map(known).max().unwrap_or(0) + 1,
        };
    }
    let last = depths.iter().max().copied().unwrap_or(0);
    let accelerations = tape.mass_matrix.iter().flat_map(|mass| &mass.accelerations);
    for acceleration in accelerations {
        depths[acceleration.0 as usize] = last + 1;
    }
    depths
}

/// Orders the factors: S(a, b) is S(b, a) if neither factor is weighted.
pub(super) fn in_order(convolution: Convolution) -> Convolution {
    let Convolution { left, weighted, right } = convolution;
    if weighted || left <= right {
        convolution
    } else {
        Convolution { left: right, weighted, right: left }
    }
}

/// Returns the operands whose newest coefficient a node's newest one reads.
fn newest_operands(tape: &TaylorTape, id: NodeId) -> Vec<NodeId> {
    match tape[id].recurrence {
        Recurrence::Constant(_)
        | Recurrence::Time
        | Recurrence::State(_)
        | Recurrence::Tail(..)
        | Recurrence::Acceleration(_) => vec![],
        Recurrence::Neg(a) | Recurrence::Root(a) | Recurrence::Scaled { series: a, .. } => vec![a],
        Recurrence::Product(..) if line_and_other(tape, id).is_some() => {
            line_and_other(tape, id).map(|(_, other)| other).into_iter().collect()
        }
        Recurrence::Add(a, b)
        | Recurrence::Sub(a, b)
        | Recurrence::Product(a, b)
        | Recurrence::Quotient(a, b) => vec![a, b],
        Recurrence::Integral { argument, .. } if tape.is_line(argument) => vec![],
        Recurrence::Integral { argument, .. } | Recurrence::IntegralOver { argument, .. } => {
            vec![argument]
        }
        Recurrence::Power { base, .. } => vec![base],
        Recurrence::Select { then, otherwise, .. } => vec![then, otherwise],
        Recurrence::Table { argument, square, cube, .. } => vec![argument, square, cube],
        Recurrence::Lagged { entry, .. } => vec![entry],
    }
}

/// Returns the node of which the coefficient before the newest is read.
fn operand_before(tape: &TaylorTape, id: NodeId) -> Option<NodeId> {
    match tape[id].recurrence {
        Recurrence::Integral { argument, integrand, .. } if tape.is_line(argument) => {
            Some(integrand)
        }
        _ => line_and_other(tape, id).map(|(_, other)| other),
    }
}

/// Returns the factors of a product of which one is linear in time; that one comes first.
pub(super) fn line_and_other(tape: &TaylorTape, id: NodeId) -> Option<(NodeId, NodeId)> {
    match tape[id].recurrence {
        Recurrence::Product(a, b) if tape.is_line(a) => Some((a, b)),
        Recurrence::Product(a, b) if tape.is_line(b) => Some((b, a)),
        _ => None,
    }
}

//! Sharing of the motion: a tape computes what several functions need, before theirs.

use std::collections::HashMap;

use machinist_model::{Dependence, Motion, Node, NodeId, Op, Tape, reachable};

/// Nodes of one tape, by their purpose.
pub struct Parts {
    /// Factors in the steps of a solution.
    pub factors: Vec<NodeId>,
    /// Nodes so expensive that functions read them from the motion: the accelerations, and those
    /// of the factors for which a matrix was factored.
    pub costly: Vec<NodeId>,
    /// Results of each function.
    pub functions: Vec<Vec<NodeId>>,
}

/// Maximum cost of an operation, in sums, that is repeated rather than passed on.
const DONE_AGAIN: u32 = 2;

/// Returns the motion, and the tapes of the functions. Tapes that need nothing expensive are
/// independent of it.
#[must_use]
pub fn share(tape: &Tape, parts: &Parts) -> (Motion, Vec<Tape>) {
    let motion: Vec<NodeId> = [&parts.factors[..], &parts.costly].concat();
    let in_motion = reached(tape, &motion, |_| false);
    let handed_over = handed_over(tape, &in_motion, &parts.costly);
    let is_handed = |id: NodeId| handed_over[id.0 as usize];
    let is_costly = |function: &[NodeId]| {
        let reached = reached(tape, function, |_| false);
        parts.costly.iter().any(|id| reached[id.0 as usize])
    };
    let sharing: Vec<bool> = parts.functions.iter().map(|f| is_costly(f)).collect();
    let mut read = vec![false; tape.nodes.len()];
    for (function, _) in parts.functions.iter().zip(&sharing).filter(|(_, shares)| **shares) {
        let reached = reached(tape, function, is_handed);
        for (read, (reached, handed)) in read.iter_mut().zip(reached.iter().zip(&handed_over)) {
            *read |= reached & handed;
        }
    }
    let mut results = parts.factors.clone();
    let is_read = (0..tape.nodes.len() as u32).map(NodeId).filter(|id| read[id.0 as usize]);
    results.extend(is_read.filter(|id| !parts.factors.contains(id)));
    let places = results.iter().zip(0..).map(|(id, place)| (*id, place)).collect();
    let tapes = parts.functions.iter().zip(&sharing).map(|(function, shares)| {
        if *shares { behind(tape, function, &places) } else { reachable(&tape.nodes, function) }
    });
    let motion = Motion {
        tape: reachable(&tape.nodes, &results),
        factors: (0..parts.factors.len() as u32).collect(),
    };
    (motion, tapes.collect())
}

/// Returns the nodes that results need, without those needed only through `ends`.
fn reached(tape: &Tape, results: &[NodeId], ends: impl Fn(NodeId) -> bool) -> Vec<bool> {
    let mut reached = vec![false; tape.nodes.len()];
    let mut open = results.to_vec();
    while let Some(id) = open.pop() {
        if !std::mem::replace(&mut reached[id.0 as usize], true) && !ends(id) {
            open.extend(tape[id].op.operands());
        }
    }
    reached
}

/// Returns the nodes of the motion that are worth passing on, wherever one is read.
fn handed_over(tape: &Tape, in_motion: &[bool], costly: &[NodeId]) -> Vec<bool> {
    let dependence = Dependence::of(tape);
    let mut handed = vec![false; tape.nodes.len()];
    let mut costs = vec![0; tape.nodes.len()];
    for (index, node) in tape.nodes.iter().enumerate().filter(|(index, _)| in_motion[*index]) {
        let operands = node.op.operands();
        let cost = operands.iter().fold(node.op.cost(), |sum, id| sum + costs[id.0 as usize]);
        let is_result = costly.contains(&NodeId(index as u32));
        // Nodes of parameters only are computed once a run wherever they are needed.
        let varies = dependence.on_anything(NodeId(index as u32));
        let is_worth_it = node.op.is_arithmetic() && (cost > DONE_AGAIN || is_result);
        handed[index] = varies && is_worth_it;
        costs[index] = if handed[index] { 0 } else { cost };
    }
    handed
}

/// Returns the tape of results, in which results of the motion replace their operations.
fn behind(tape: &Tape, results: &[NodeId], places: &HashMap<NodeId, u32>) -> Tape {
    let nodes = tape.nodes.iter().enumerate().map(|(index, node)| {
        match places.get(&NodeId(index as u32)) {
            Some(place) if node.op.is_arithmetic() => Node { op: Op::Motion(*place), name: None },
            _ => node.clone(),
        }
    });
    let nodes: Vec<Node> = nodes.collect();
    reachable(&nodes, results)
}

#[cfg(test)]
mod tests {
    use super::*;
    use machinist_algebra::expr::Graph;
    use machinist_model::Function;
    use machinist_model::evaluate::{Evaluator, Inputs};

    fn values(tape: &Tape, state: &[f64], motion: &[f64]) -> Vec<f64> {
        let inputs = Inputs { state, motion, ..Inputs::default() };
        let mut values = vec![0.0; tape.results.len()];
        Evaluator::new(tape).evaluate(&inputs, &mut values);
        values
    }

    #[test]
    fn functions_read_what_the_motion_has_and_give_the_same_bits() {
        let mut graph = Graph::new();
        let [x, y] = [0, 1].map(|entry| graph.insert(Op::State(entry)));
        let sine = graph.call(Function::Sin, x);
        let factor = graph.div(sine, y);
        let acceleration = graph.mul(factor, y);
        let twice = graph.add(acceleration, sine);
        let cheap = graph.mul(x, sine);
        let tape = graph.tape(&[factor, acceleration, twice, cheap]);
        let [factor, acceleration, twice, cheap] = tape.results[..] else { unreachable!() };
        let parts = Parts {
            factors: vec![factor],
            costly: vec![acceleration],
            functions: vec![vec![twice], vec![cheap]],
        };
        let (motion, tapes) = share(&tape, &parts);
        assert_eq!(motion.factors, [0]);
        let reads =
            |tape: &Tape| tape.nodes.iter().filter(|n| matches!(n.op, Op::Motion(_))).count();
        assert_eq!((reads(&tapes[0]), reads(&tapes[1])), (2, 0));
        let state = [0.3, 1.7];
        let moved = values(&motion.tape, &state, &[]);
        let whole = values(&tape, &state, &[]);
        assert_eq!(values(&tapes[0], &state, &moved)[0].to_bits(), whole[2].to_bits());
        assert_eq!(values(&tapes[1], &state, &moved)[0].to_bits(), whole[3].to_bits());
    }
}

//! Sines and cosines of sums and differences of angles, from those of the angles.
//!
//! ```text
//! sin(x + y) = sin x cos y + cos x sin y      cos(x + y) = cos x cos y - sin x sin y
//! sin(x - y) = sin x cos y - cos x sin y      cos(x - y) = cos x cos y + sin x sin y
//! ```
//!
//! A chain of n links has n (n - 1)/2 differences of n angles, and a call costs as much as about
//! ten products. The result is that of angles which differ from the given ones by their rounding,
//! so no precision of the state is lost.
//!
//! Excluded: the Taylor series, whose products are sums; there a difference is cheaper.

use std::collections::{BTreeMap, BTreeSet};

use machinist_algebra::expr::Graph;
use machinist_model::{Function, NodeId, Op, Tape};

/// Returns the tape with fewer calls, if there are fewer angles than sums of angles.
#[must_use]
pub fn expand(tape: &Tape) -> Tape {
    let split = split(tape);
    if split.is_empty() {
        return tape.clone();
    }
    let mut graph = Graph::new();
    let mut places: Vec<NodeId> = Vec::with_capacity(tape.nodes.len());
    for node in &tape.nodes {
        let op = node.op.with_operands(|id| places[id.0 as usize]);
        let place = match node.op {
            Op::Call(function @ (Function::Sin | Function::Cos), angle)
                if split.contains(&angle) =>
            {
                let [sine, cosine] = of_sum(&mut graph, tape, &places, angle);
                if function == Function::Sin { sine } else { cosine }
            }
            _ => graph.insert(op),
        };
        if let Some(name) = &node.name {
            graph.name(place, name);
        }
        places.push(place);
    }
    let results: Vec<NodeId> = tape.results.iter().map(|id| places[id.0 as usize]).collect();
    graph.tape(&results)
}

/// Returns sine and cosine of an angle, from those of its terms.
fn of_sum(graph: &mut Graph, tape: &Tape, places: &[NodeId], angle: NodeId) -> [NodeId; 2] {
    let (x, y, is_difference) = match tape[angle].op {
        Op::Add(x, y) => (x, y, false),
        Op::Sub(x, y) => (x, y, true),
        Op::Neg(x) => {
            let [sine, cosine] = of_sum(graph, tape, places, x);
            return [graph.neg(sine), cosine];
        }
        _ => {
            let place = places[angle.0 as usize];
            return [Function::Sin, Function::Cos].map(|function| graph.call(function, place));
        }
    };
    let [sin_x, cos_x] = of_sum(graph, tape, places, x);
    let [sin_y, cos_y] = of_sum(graph, tape, places, y);
    let [sin_cos, cos_sin] = [graph.mul(sin_x, cos_y), graph.mul(cos_x, sin_y)];
    let [cos_cos, sin_sin] = [graph.mul(cos_x, cos_y), graph.mul(sin_x, sin_y)];
    if is_difference {
        [graph.sub(sin_cos, cos_sin), graph.add(cos_cos, sin_sin)]
    } else {
        [graph.add(sin_cos, cos_sin), graph.sub(cos_cos, sin_sin)]
    }
}

/// Returns the angles to be split. Of those that share terms, all are split or none.
fn split(tape: &Tape) -> BTreeSet<NodeId> {
    let calls = tape.nodes.iter().filter_map(|node| match node.op {
        Op::Call(Function::Sin | Function::Cos, angle) => Some(angle),
        _ => None,
    });
    let angles: BTreeMap<NodeId, BTreeSet<NodeId>> =
        calls.map(|angle| (angle, parts(tape, angle))).collect();
    let mut left: BTreeSet<NodeId> = angles.keys().copied().collect();
    let mut split = BTreeSet::new();
    while let Some(first) = left.pop_first() {
        let (group, parts) = connected(first, &angles, &mut left);
        if parts.len() < group.len() {
            split.extend(group);
        }
    }
    split
}

/// Removes all angles that share terms with the first one from `left`, and returns them with the
/// terms.
fn connected(
    first: NodeId,
    angles: &BTreeMap<NodeId, BTreeSet<NodeId>>,
    left: &mut BTreeSet<NodeId>,
) -> (BTreeSet<NodeId>, BTreeSet<NodeId>) {
    let (mut group, mut parts) = (BTreeSet::from([first]), angles[&first].clone());
    loop {
        let near: Vec<NodeId> =
            left.iter().copied().filter(|angle| !angles[angle].is_disjoint(&parts)).collect();
        if near.is_empty() {
            return (group, parts);
        }
        for angle in near {
            left.remove(&angle);
            group.insert(angle);
            parts.extend(&angles[&angle]);
        }
    }
}

/// Returns the terms of an angle. A number costs nothing: its sine is a number.
fn parts(tape: &Tape, angle: NodeId) -> BTreeSet<NodeId> {
    match tape[angle].op {
        Op::Add(x, y) | Op::Sub(x, y) => {
            let mut all = parts(tape, x);
            all.extend(parts(tape, y));
            all
        }
        Op::Neg(x) => parts(tape, x),
        Op::Literal(_) => BTreeSet::new(),
        _ => BTreeSet::from([angle]),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use machinist_model::evaluate::{Evaluator, Inputs};

    fn calls(tape: &Tape) -> usize {
        tape.nodes.iter().filter(|node| matches!(node.op, Op::Call(..))).count()
    }

    /// Returns sin(x_i - x_j) and cos(x_i - x_j) for all pairs of `angles` entries of the state.
    fn pairs(angles: u32) -> Tape {
        let mut graph = Graph::new();
        let entries: Vec<NodeId> = (0..angles).map(|i| graph.insert(Op::State(i))).collect();
        let mut results = Vec::new();
        for (i, x) in entries.iter().enumerate() {
            for y in &entries[i + 1..] {
                let difference = graph.sub(*x, *y);
                results.push(graph.call(Function::Sin, difference));
                results.push(graph.call(Function::Cos, difference));
            }
        }
        graph.tape(&results)
    }

    fn values(tape: &Tape, state: &[f64]) -> Vec<f64> {
        let mut results = vec![0.0; tape.results.len()];
        let inputs = Inputs { time: 0.3, state, parameters: &[0.7], ..Inputs::default() };
        Evaluator::new(tape).evaluate(&inputs, &mut results);
        results
    }

    #[test]
    fn differences_of_many_angles_cost_two_calls_an_angle() {
        let tape = pairs(6);
        let expanded = expand(&tape);
        assert_eq!((calls(&tape), calls(&expanded)), (30, 12));
        let state = [0.3, -1.2, 2.9, 1e-9, -40.0, 1.57];
        for (before, after) in values(&tape, &state).iter().zip(values(&expanded, &state)) {
            assert!((before - after).abs() < 4e-16 * 40.0, "{before} {after}");
        }
    }

    #[test]
    fn small_angles_keep_their_digits() {
        let expanded = expand(&pairs(4));
        let state = [3e-9, 1e-9, -5e-10, 7e-10];
        let sine = values(&expanded, &state)[0];
        assert!((sine / 2e-9 - 1.0).abs() < 1e-15);
    }

    #[test]
    fn a_lone_sum_is_left_alone() {
        let tape = pairs(2);
        assert_eq!(expand(&tape), tape);
    }

    #[test]
    fn three_phases_are_one_sine_and_one_cosine_of_time() {
        let mut graph = Graph::new();
        let (time, frequency) = (graph.time(), graph.parameter(0));
        let angle = graph.mul(time, frequency);
        let third = graph.literal(2.0 * std::f64::consts::PI / 3.0);
        let (behind, ahead) = (graph.sub(angle, third), graph.add(angle, third));
        let phases = [angle, behind, ahead].map(|angle| graph.call(Function::Cos, angle));
        let tape = graph.tape(&phases);
        let expanded = expand(&tape);
        assert_eq!((calls(&tape), calls(&expanded)), (3, 2));
        for (before, after) in values(&tape, &[]).iter().zip(values(&expanded, &[])) {
            assert!((before - after).abs() < 4e-16, "{before} {after}");
        }
    }

    #[test]
    fn as_many_parts_as_angles_are_left_alone() {
        let mut graph = Graph::new();
        let [x, y] = [0, 1].map(|entry| graph.insert(Op::State(entry)));
        let difference = graph.sub(x, y);
        let sines = [x, difference].map(|angle| graph.call(Function::Sin, angle));
        let tape = graph.tape(&sines);
        assert_eq!(expand(&tape), tape);
    }

    #[test]
    fn angles_that_differ_by_numbers_are_one() {
        let mut graph = Graph::new();
        let x = graph.insert(Op::State(0));
        let [one, two] = [1.0, 2.0].map(|value| graph.literal(value));
        let (ahead, behind) = (graph.add(x, one), graph.sub(x, two));
        let cosines = [ahead, behind].map(|angle| graph.call(Function::Cos, angle));
        let sines = [ahead, behind].map(|angle| graph.call(Function::Sin, angle));
        let tape = graph.tape(&[cosines, sines].concat());
        let expanded = expand(&tape);
        assert_eq!((calls(&tape), calls(&expanded)), (4, 2));
        for (before, after) in values(&tape, &[0.4]).iter().zip(values(&expanded, &[0.4])) {
            assert!((before - after).abs() < 4e-16, "{before} {after}");
        }
    }

    #[test]
    fn groups_that_share_no_angle_are_decided_apart() {
        let mut graph = Graph::new();
        let entries: Vec<NodeId> = (0..5).map(|i| graph.insert(Op::State(i))).collect();
        let lone = graph.sub(entries[3], entries[4]);
        let mut results = vec![graph.call(Function::Sin, lone)];
        for (i, j) in [(0, 1), (0, 2), (1, 2)] {
            let (sum, difference) =
                (graph.add(entries[i], entries[j]), graph.sub(entries[i], entries[j]));
            results.extend([sum, difference].map(|angle| graph.call(Function::Cos, angle)));
        }
        let tape = graph.tape(&results);
        let expanded = expand(&tape);
        assert_eq!((calls(&tape), calls(&expanded)), (7, 7));
        let state = [0.1, 0.9, -0.4, 2.0, 0.5];
        for (before, after) in values(&tape, &state).iter().zip(values(&expanded, &state)) {
            assert!((before - after).abs() < 4e-16, "{before} {after}");
        }
    }
}

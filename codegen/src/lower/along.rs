//! Rates of expressions along the motion, by differentiation on the graph.

use std::collections::{BTreeSet, HashMap};

use machinist_algebra::expr::Graph;
use machinist_model::{Function, NodeId, Op};

/// Returns the rates of nodes along a motion: dx/dt by the chain rule, from the rate of the
/// state.
pub(super) fn along(graph: &mut Graph, rate: &[NodeId], of: &[NodeId]) -> Vec<NodeId> {
    let mut known: HashMap<NodeId, NodeId> = HashMap::new();
    for id in reached(graph, of) {
        let op = graph.op(id);
        let slopes: Vec<NodeId> = op.operands().iter().map(|id| known[id]).collect();
        let slope = slope(graph, rate, id, &slopes);
        known.insert(id, slope);
    }
    of.iter().map(|id| known[id]).collect()
}

/// Returns the rate of an operation, from those of its operands.
fn slope(graph: &mut Graph, rate: &[NodeId], id: NodeId, slopes: &[NodeId]) -> NodeId {
    let zero = graph.literal(0.0);
    let op = graph.op(id);
    match op {
        Op::Time => graph.literal(1.0),
        Op::State(entry) => rate[entry as usize],
        _ if slopes.iter().all(|slope| graph.is_zero(*slope)) => zero,
        Op::Neg(_) => graph.neg(slopes[0]),
        Op::Add(..) => graph.add(slopes[0], slopes[1]),
        Op::Sub(..) => graph.sub(slopes[0], slopes[1]),
        Op::Mul(a, b) => {
            let [left, right] = [graph.mul(slopes[0], b), graph.mul(a, slopes[1])];
            graph.add(left, right)
        }
        Op::Div(_, b) => {
            let less = graph.mul(id, slopes[1]);
            let above = graph.sub(slopes[0], less);
            graph.div(above, b)
        }
        Op::Powi(a, exponent) => {
            let factor = graph.literal(f64::from(exponent));
            let power = graph.powi(a, exponent - 1);
            let by_base = graph.mul(factor, power);
            graph.mul(by_base, slopes[0])
        }
        Op::Powf(a, b) => {
            // a^b (b' ln a + b a'/a)
            let relative = graph.div(slopes[0], a);
            let by_base = graph.mul(b, relative);
            let by_exponent = if graph.is_zero(slopes[1]) {
                zero
            } else {
                let logarithm = graph.call(Function::Ln, a);
                graph.mul(slopes[1], logarithm)
            };
            let sum = graph.add(by_base, by_exponent);
            graph.mul(id, sum)
        }
        Op::Call(function, a) => {
            let derivative = derivative(graph, function, a, id);
            graph.mul(derivative, slopes[0])
        }
        Op::SelectLess { lhs, rhs, .. } => graph.select_less(lhs, rhs, slopes[2], slopes[3]),
        Op::Table { table, order, argument } => {
            let derivative = graph.table(table, order + 1, argument);
            graph.mul(derivative, slopes[0])
        }
        Op::Literal(_)
        | Op::Parameter(_)
        | Op::Handed(_)
        | Op::Held(_)
        | Op::Constant(_)
        | Op::Motion(_) => zero,
    }
}

/// Returns the derivative of a function at a, given its value.
fn derivative(graph: &mut Graph, function: Function, a: NodeId, value: NodeId) -> NodeId {
    let one = graph.literal(1.0);
    let square = |graph: &mut Graph, x: NodeId| graph.mul(x, x);
    match function {
        Function::Sqrt => {
            let two = graph.literal(2.0);
            let below = graph.mul(two, value);
            graph.div(one, below)
        }
        Function::Abs => {
            let [zero, minus] = [0.0, -1.0].map(|value| graph.literal(value));
            graph.select_less(a, zero, minus, one)
        }
        Function::Floor => graph.literal(0.0),
        Function::Exp => value,
        Function::Ln => graph.div(one, a),
        Function::Sin => graph.call(Function::Cos, a),
        Function::Cos => {
            let sine = graph.call(Function::Sin, a);
            graph.neg(sine)
        }
        Function::Tan => {
            let square = square(graph, value);
            graph.add(one, square)
        }
        Function::Asin | Function::Acos => {
            let square = square(graph, a);
            let below = graph.sub(one, square);
            let root = graph.call(Function::Sqrt, below);
            let slope = graph.div(one, root);
            if function == Function::Asin { slope } else { graph.neg(slope) }
        }
        Function::Atan => {
            let square = square(graph, a);
            let below = graph.add(one, square);
            graph.div(one, below)
        }
        Function::Sinh => graph.call(Function::Cosh, a),
        Function::Cosh => graph.call(Function::Sinh, a),
        Function::Tanh => {
            let square = square(graph, value);
            graph.sub(one, square)
        }
    }
}

/// Returns the nodes that results need, including themselves, each after its operands.
pub(super) fn reached(graph: &Graph, results: &[NodeId]) -> BTreeSet<NodeId> {
    let mut reached = BTreeSet::new();
    let mut open = results.to_vec();
    while let Some(id) = open.pop() {
        if reached.insert(id) {
            open.extend(graph.op(id).operands());
        }
    }
    reached
}

#[cfg(test)]
mod tests {
    use machinist_model::evaluate::{Evaluator, Inputs};
    use machinist_model::{Name, Table, TableId};

    use super::*;

    /// Compares rates along x = x0 + 0.7 (t - 0.4) with differences of values.
    #[test]
    fn rates_of_all_operations_are_differences_along_the_motion() {
        type Build = fn(&mut Graph, [NodeId; 3]) -> NodeId;
        let builds: [Build; 12] = [
            |g, [x, ..]| g.neg(x),
            |g, [x, t, _]| g.add(x, t),
            |g, [x, t, _]| g.sub(x, t),
            |g, [x, t, _]| g.mul(x, t),
            |g, [x, t, _]| g.div(x, t),
            |g, [x, t, _]| g.div(t, x),
            |g, [x, ..]| g.powi(x, 7),
            |g, [x, ..]| g.powi(x, -3),
            |g, [x, t, _]| g.powf(x, t),
            |g, [x, _, p]| g.powf(x, p),
            |g, [x, t, p]| g.select_less(p, x, t, x),
            |g, [x, t, p]| {
                let product = g.mul(x, p);
                g.select_less(x, p, t, product)
            },
        ];
        let functions = Function::ALL.map(|(function, _)| function);
        let mut graph = Graph::new();
        let [x, time, p] = [Op::State(0), Op::Time, Op::Parameter(0)].map(|op| graph.insert(op));
        let speed = graph.literal(0.7);
        let mut nodes: Vec<NodeId> =
            builds.iter().map(|build| build(&mut graph, [x, time, p])).collect();
        nodes.extend(functions.map(|function| graph.call(function, x)));
        let table = Table {
            name: Name { path: "table".into(), ident: "table".into(), latex: String::new() },
            knots: vec![0.0, 1.0, 2.0],
            coefficients: vec![[0.2, -1.1, 0.7, 2.0], [1.8, 6.3, 6.7, -1.0]],
        };
        nodes.extend([0, 1].map(|order| graph.table(TableId(0), order, x)));
        // Nodes that do not change.
        nodes.extend([p, speed, graph.call(Function::Sin, p)]);
        let rates = along(&mut graph, &[speed], &nodes);
        let values = |nodes: &[NodeId], later: f64| {
            let tape = graph.tape(nodes);
            let state = [0.6 + 0.7 * later];
            let inputs = Inputs {
                time: 0.4 + later,
                state: &state,
                parameters: &[1.7],
                tables: std::slice::from_ref(&table),
                ..Inputs::default()
            };
            let mut values = vec![0.0; nodes.len()];
            Evaluator::new(&tape).evaluate(&inputs, &mut values);
            values
        };
        let (found, after, before) =
            (values(&rates, 0.0), values(&nodes, 1e-5), values(&nodes, -1e-5));
        for (index, node) in nodes.iter().enumerate() {
            let expected = (after[index] - before[index]) / 2e-5;
            let off = (found[index] - expected).abs();
            let size = expected.abs().max(1.0);
            assert!(off < 1e-7 * size, "{:?}: {} {expected}", graph.op(*node), found[index]);
        }
    }
}

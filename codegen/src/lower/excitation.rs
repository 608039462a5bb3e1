//! Machines whose equations are linear with constant coefficients, solved without
//! stepping: y' = A y + b(t), with
//!
//! ```text
//! b(t) = sum of t^k e^(g t) (C cos(w t) + S sin(w t))
//! ```
//!
//! Found on the tape of the rate, each node of which is followed as a sum of terms;
//! one that is no such sum ends the search. Choices by time, as in `step` and
//! `piecewise`, hold between their switching times, at which a run has to be cut.
//!
//! Excluded: A, which is the Jacobian of the rate anywhere within such a piece.

mod sum;

use machinist_algebra::expr::Graph;
use machinist_model::{Excitation, Node, NodeId, Op, Tape};

use sum::{Algebra, Sum};

/// Returns the excitation of a machine with this rate y'; `None` if the rate is not linear in the
/// state with constant coefficients, or if time enters by other functions.
#[must_use]
pub fn excitation(rate: &Tape) -> Option<Excitation> {
    let mut algebra = Algebra::new();
    let sums = follow(&mut algebra, rate)?;
    let mut terms = Vec::new();
    let mut values = Vec::new();
    for (entry, sum) in (0..).zip(sums) {
        for wave in sum.waves(&algebra) {
            terms.push((entry, wave.power));
            values.extend([wave.growth, wave.frequency, wave.cosine, wave.sine]);
        }
    }
    let graph = algebra.graph();
    let switches = graph.tape(algebra.switches());
    Some(Excitation { terms, values: graph.tape(&values), switches })
}

/// Returns whether the results of a tape are linear and homogeneous in the state, with coefficients
/// that depend only on parameters and on one entry of the state, `place`.
#[must_use]
pub fn is_homogeneous(tape: &Tape, place: u32) -> bool {
    let mut tape = tape.clone();
    for node in &mut tape.nodes {
        if node.op == Op::State(place) {
            node.op = Op::Constant(0);
        }
    }
    let mut algebra = Algebra::new();
    follow(&mut algebra, &tape).is_some_and(|sums| sums.iter().all(Sum::is_of_states))
}

/// The results of a tape as sums of terms.
fn follow(algebra: &mut Algebra, tape: &Tape) -> Option<Vec<Sum>> {
    let mut sums: Vec<Sum> = Vec::with_capacity(tape.nodes.len());
    for Node { op, .. } in &tape.nodes {
        let of = |id: NodeId| &sums[id.0 as usize];
        let sum = match *op {
            Op::Literal(value) => algebra.literal(value),
            Op::Parameter(_) | Op::Handed(_) | Op::Constant(_) => algebra.given(*op),
            Op::Motion(_) | Op::Held(_) => return None,
            Op::Time => algebra.time(),
            Op::State(entry) => algebra.state(entry),
            Op::Neg(a) => algebra.negative(of(a)),
            Op::Add(a, b) => algebra.sum(of(a), of(b)),
            Op::Sub(a, b) => {
                let negative = algebra.negative(of(b));
                algebra.sum(of(a), &negative)
            }
            Op::Mul(a, b) => algebra.product(of(a), of(b))?,
            Op::Div(a, b) => algebra.quotient(of(a), of(b))?,
            Op::Powi(a, exponent) => algebra.power(of(a), exponent)?,
            Op::Powf(a, b) => {
                algebra.of_constants(&[of(a), of(b)], |graph, c| graph.powf(c[0], c[1]))?
            }
            Op::Call(function, a) => algebra.call(function, of(a))?,
            Op::SelectLess { lhs, rhs, then, otherwise } => {
                algebra.choice(of(lhs), of(rhs), [of(then), of(otherwise)])?
            }
            Op::Table { table, order, argument } => algebra
                .of_constants(&[of(argument)], |graph: &mut Graph, c| {
                    graph.table(table, order, c[0])
                })?,
        };
        sums.push(sum);
    }
    Some(tape.results.iter().map(|id| sums[id.0 as usize].clone()).collect())
}

#[cfg(test)]
mod tests {
    use super::is_homogeneous;
    use machinist_model::{Node, NodeId, Op, Tape};

    fn tape(ops: &[Op]) -> Tape {
        let nodes = ops.iter().map(|&op| Node { op, name: None }).collect();
        Tape { nodes, results: vec![NodeId(ops.len() as u32 - 1)] }
    }

    #[test]
    fn forces_are_linear_if_only_parameters_and_the_place_multiply_the_state() {
        let (u, x, p) = (Op::State(0), Op::State(4), Op::Parameter(2));
        let of = |op: fn(NodeId, NodeId) -> Op| op(NodeId(0), NodeId(1));
        let product = |a, b| tape(&[a, b, of(Op::Mul)]);
        assert!(is_homogeneous(&product(u, p), 4));
        assert!(is_homogeneous(&product(x, u), 4));
        assert!(is_homogeneous(&tape(&[u, Op::State(1), of(Op::Sub)]), 4));
        assert!(is_homogeneous(&tape(&[Op::Literal(0.0)]), 4));
        // A square, the place alone, an excitation, and a stiffness that moves with time.
        assert!(!is_homogeneous(&product(u, u), 4));
        assert!(!is_homogeneous(&product(x, p), 4));
        assert!(!is_homogeneous(&tape(&[u, p, of(Op::Add)]), 4));
        assert!(!is_homogeneous(&product(u, Op::Time), 4));
    }
}

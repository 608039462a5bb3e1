//! Machines whose equations are linear with constant coefficients while relations and modes are
//! held, solved without stepping: y' = A y + b(t), with
//!
//! ```text
//! b(t) = sum of t^k e^(g t) (C cos(w t) + S sin(w t))
//! ```
//!
//! Found on the tape of the rate, each node of which is followed as a sum of terms;
//! one that is no such sum ends the search. Choices by time, as in `step` and
//! `piecewise`, hold between their switching times, at which a run has to be cut. Choices by
//! relations hold while their slots do. Guards, which end such a piece, must be sums of the same
//! kind: they are further rows. Their coefficients of the state, and those of the rate, follow from the
//! slots, too: a derivative may contain a comparison in a form that has no slot.
//!
//! Excluded: A of a machine without guards, which is the Jacobian of the rate anywhere.

mod sum;

use machinist_algebra::expr::Graph;
use machinist_model::{Excitation, Node, NodeId, Op, Tape};

use sum::{Algebra, Sum};

/// Returns the excitation of a machine with this rate y', followed by guards; `None` if one of
/// them is not linear in the state with constant coefficients, or if time enters by other functions.
/// `is_mode` is true for entries of the state that change only at events.
#[must_use]
pub fn excitation(tape: &Tape, is_mode: &[bool]) -> Option<Excitation> {
    let mut algebra = Algebra::new();
    let sums = follow(&mut algebra, tape, is_mode)?;
    let (mut terms, mut slopes) = (Vec::new(), Vec::new());
    let mut values = Vec::new();
    for (row, sum) in (0..).zip(&sums) {
        for wave in sum.waves(&algebra) {
            terms.push((row, wave.power));
            values.extend([wave.growth, wave.frequency, wave.cosine, wave.sine]);
        }
    }
    // Without guards nothing is held, and the Jacobian of the rate is A anywhere.
    let has_guards = sums.len() > is_mode.len();
    for (row, sum) in (0..).zip(&sums).filter(|_| has_guards) {
        for (entry, slope) in sum.slopes() {
            slopes.push((row, entry));
            values.push(slope);
        }
    }
    let graph = algebra.graph();
    let switches = graph.tape(algebra.switches());
    Some(Excitation { terms, slopes, values: graph.tape(&values), switches })
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
    follow(&mut algebra, &tape, &[]).is_some_and(|sums| sums.iter().all(Sum::is_of_states))
}

/// The results of a tape as sums of terms.
fn follow(algebra: &mut Algebra, tape: &Tape, is_mode: &[bool]) -> Option<Vec<Sum>> {
    // An operation that is no sum of terms may be on a branch that slots replace.
    let mut sums: Vec<Option<Sum>> = Vec::with_capacity(tape.nodes.len());
    for Node { op, .. } in &tape.nodes {
        sums.push(of_operation(algebra, (tape, *op), &sums, is_mode));
    }
    tape.results.iter().map(|id| sums[id.0 as usize].clone()).collect()
}

/// Returns the sum of an operation, given those of the nodes before it.
fn of_operation(
    algebra: &mut Algebra,
    (tape, op): (&Tape, Op),
    sums: &[Option<Sum>],
    is_mode: &[bool],
) -> Option<Sum> {
    let of = |id: NodeId| sums[id.0 as usize].as_ref();
    Some(match op {
        Op::Literal(value) => algebra.literal(value),
        Op::State(entry) if is_mode.get(entry as usize) != Some(&true) => algebra.state(entry),
        Op::Parameter(_) | Op::Handed(_) | Op::Constant(_) | Op::Held(_) | Op::State(_) => {
            algebra.given(op)
        }
        Op::Motion(_) => return None,
        Op::Time => algebra.time(),
        Op::Neg(a) => algebra.negative(of(a)?),
        Op::Add(a, b) => algebra.sum(of(a)?, of(b)?),
        Op::Sub(a, b) => {
            let negative = algebra.negative(of(b)?);
            algebra.sum(of(a)?, &negative)
        }
        Op::Mul(a, b) => algebra.product(of(a)?, of(b)?)?,
        Op::Div(a, b) => algebra.quotient(of(a)?, of(b)?)?,
        Op::Powi(a, exponent) => algebra.power(of(a)?, exponent)?,
        Op::Powf(a, b) => {
            algebra.of_constants(&[of(a)?, of(b)?], |graph, c| graph.powf(c[0], c[1]))?
        }
        Op::Call(function, a) => algebra.call(function, of(a)?)?,
        Op::SelectLess { lhs, rhs, then, otherwise } => {
            match (tape.shifted(tape[lhs].op), tape[lhs].op) {
                (Some((_, slot, is_opposite)), _) => {
                    algebra.held_choice((slot, is_opposite), [of(then)?, of(otherwise)?])
                }
                // The slot of an integer stands for it.
                (None, Op::Held(_)) => of(then)?.clone(),
                (None, _) => algebra.choice(of(lhs)?, of(rhs)?, [of(then)?, of(otherwise)?])?,
            }
        }
        Op::Table { table, order, argument } => algebra
            .of_constants(&[of(argument)?], |graph: &mut Graph, c| {
                graph.table(table, order, c[0])
            })?,
    })
}

#[cfg(test)]
mod tests {
    use super::{excitation, is_homogeneous};
    use machinist_model::{Function, Node, NodeId, Op, Tape};

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

    /// Rates of a mode and of x' = (x + slot < 0 ? x : mode x) + floor(x), and the guard 2 x - p.
    #[test]
    fn held_relations_and_modes_are_constants() {
        let [mode, x, slot, sum, zero] = [0, 1, 2, 3, 4].map(NodeId);
        let ops = [
            Op::State(0),
            Op::State(1),
            Op::Held(7),
            Op::Add(x, slot),
            Op::Literal(0.0),
            Op::Mul(mode, x),
            Op::SelectLess { lhs: sum, rhs: zero, then: x, otherwise: NodeId(5) },
            // A whole number is its slot unless it is live.
            Op::Held(8),
            Op::Literal(f64::MAX),
            Op::Call(Function::Floor, x),
            Op::SelectLess {
                lhs: NodeId(7),
                rhs: NodeId(8),
                then: NodeId(7),
                otherwise: NodeId(9),
            },
            Op::Add(NodeId(6), NodeId(10)),
            Op::Add(x, x),
            Op::Parameter(0),
            Op::Sub(NodeId(12), NodeId(13)),
            Op::Mul(x, x),
        ];
        let of = |results: &[u32]| {
            let results = results.iter().copied().map(NodeId).collect();
            excitation(&Tape { results, ..tape(&ops) }, &[true, false])
        };
        let found = of(&[4, 11, 14]).expect("linear");
        // The slot of the whole number acts on the rate, the parameter on the guard.
        assert_eq!((found.terms, found.slopes), (vec![(1, 0), (2, 0)], vec![(1, 1), (2, 1)]));
        let reads_slot = |op: &Op| matches!(op, Op::Held(8));
        assert!(found.values.nodes.iter().any(|node| reads_slot(&node.op)));
        assert!(of(&[4, 11, 15]).is_none(), "a guard that is not affine");
        assert!(of(&[4, 9, 14]).is_none(), "a whole number that no slot holds");
        assert!(
            excitation(&Tape { results: vec![zero, NodeId(11)], ..tape(&ops) }, &[false; 2])
                .is_none()
        );
    }
}

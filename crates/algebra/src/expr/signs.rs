//! Absorption of signs before a product or a sum into a literal, or into a difference that nothing
//! else reads, by exchange of its operands. Every result keeps its bits, except for the sign of a
//! zero.

use machinist_model::{Node, NodeId, Op, Tape, reachable};

/// Returns the tape with fewer negations.
pub(super) fn absorb(tape: &Tape) -> Tape {
    let mut uses = vec![0_u32; tape.nodes.len()];
    let operands = tape.nodes.iter().flat_map(|node| node.op.operands());
    for id in operands.chain(tape.results.iter().copied()) {
        uses[id.0 as usize] += 1;
    }
    let mut absorbed = Absorbed { tape, uses, nodes: Vec::new(), moved: Vec::new() };
    for node in &tape.nodes {
        let op = match node.op {
            Op::Neg(a) => absorbed.opposite(a),
            _ => None,
        };
        let op = op.unwrap_or_else(|| absorbed.again(node.op));
        let id = absorbed.push(op, node.name.clone());
        absorbed.moved.push(id);
    }
    let results: Vec<NodeId> =
        tape.results.iter().map(|id| absorbed.moved[id.0 as usize]).collect();
    reachable(&absorbed.nodes, &results)
}

struct Absorbed<'a> {
    tape: &'a Tape,
    uses: Vec<u32>,
    nodes: Vec<Node>,
    /// New ids of the nodes of the tape.
    moved: Vec<NodeId>,
}

impl Absorbed<'_> {
    fn push(&mut self, op: Op, name: Option<String>) -> NodeId {
        self.nodes.push(Node { op, name });
        NodeId(self.nodes.len() as u32 - 1)
    }

    /// Returns an operation of the tape on the moved nodes.
    fn again(&self, op: Op) -> Op {
        op.with_operands(|id| self.moved[id.0 as usize])
    }

    /// Returns the operation that gives -a, if nothing else reads a and it can absorb a sign.
    fn opposite(&mut self, a: NodeId) -> Option<Op> {
        let node = &self.tape[a];
        if let Op::Literal(value) = node.op {
            return Some(Op::Literal(-value));
        }
        if self.uses[a.0 as usize] != 1 || node.name.is_some() {
            return None;
        }
        match node.op {
            Op::Sub(x, y) => Some(self.again(Op::Sub(y, x))),
            Op::Add(x, y) => {
                let (x, y) = match self.opposite(x) {
                    Some(minus_x) => (minus_x, y),
                    None => (self.opposite(y)?, x),
                };
                let x = self.push(x, None);
                Some(Op::Sub(x, self.moved[y.0 as usize]))
            }
            Op::Mul(x, y) => {
                if let Some(x) = self.opposite(x) {
                    let x = self.push(x, None);
                    return Some(Op::Mul(x, self.moved[y.0 as usize]));
                }
                let y = self.opposite(y)?;
                let y = self.push(y, None);
                Some(Op::Mul(self.moved[x.0 as usize], y))
            }
            Op::Div(x, y) => {
                let x = self.opposite(x)?;
                let x = self.push(x, None);
                Some(Op::Div(x, self.moved[y.0 as usize]))
            }
            _ => None,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::absorb;
    use machinist_model::{Node, NodeId, Op, Tape};

    fn tape(ops: &[Op], results: &[u32]) -> Tape {
        let nodes = ops.iter().map(|&op| Node { op, name: None }).collect();
        Tape { nodes, results: results.iter().copied().map(NodeId).collect() }
    }

    #[test]
    fn a_sign_goes_into_the_literal_of_a_product() {
        let [first, second, third] = [0, 1, 2].map(NodeId);
        // -(2 y_0), which nothing else reads.
        let ops = [Op::Literal(2.0), Op::State(0), Op::Mul(first, second), Op::Neg(third)];
        let expected = [Op::State(0), Op::Literal(-2.0), Op::Mul(second, first)];
        assert_eq!(absorb(&tape(&ops, &[3])), tape(&expected, &[2]));
        // Here the product is also a result.
        assert_eq!(absorb(&tape(&ops, &[2, 3])), tape(&ops, &[2, 3]));
    }
}

//! Derivatives of tapes along a direction, as tapes.
//!
//! The operations are those of [`Dual`](machinist_contract::Dual) numbers, without those on zeros,
//! so both give the same bits.

use rustc_hash::FxHashMap;

use crate::{Function, MatrixTape, Model, Node, NodeId, Op, OpKey, Solve, Tape, reachable};

/// Inputs of a tangent that follow the state and the parameters of the machine.
///
/// Entry `states + k` of the state is the direction of the k-th entry. Parameter `parameters + k` is
/// the direction of the k-th of `along`, and the last one is that of time.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Directions {
    /// Parameters that have a direction; all others are constant.
    pub along: Vec<u32>,
}

impl Model {
    /// Returns the derivative of some results of a tape of this machine along a direction.
    ///
    /// It may read the motion, but no constants. Slots of relations are constant.
    ///
    /// # Panics
    /// If the tape reads constants or numbers of fields.
    #[must_use]
    pub fn tangent(&self, tape: &Tape, results: &[usize], directions: &Directions) -> Tape {
        let mut writer = Writer::new(self, directions);
        let (_, known) = writer.behind_motion(tape);
        let of_results = results.iter().map(|result| known[*result]).collect::<Vec<_>>();
        writer.slopes_of(&of_results)
    }

    /// Returns the derivatives of the nonzeros of a matrix of this machine along a direction. A
    /// solution for nonzeros is written out.
    ///
    /// # Panics
    /// As [`Model::tangent`].
    #[must_use]
    pub fn tangent_of_matrix(&self, matrix: &MatrixTape, directions: &Directions) -> Tape {
        let mut writer = Writer::new(self, directions);
        let (motion, mut known) = writer.behind_motion(&matrix.tape);
        if let (Some(solve), Some(of)) = (&matrix.solve, &self.motion) {
            let factors: Vec<NodeId> =
                of.factors.iter().map(|place| motion[*place as usize]).collect();
            known = writer.solved(solve, &factors, &known, matrix.pattern.entries.len());
        }
        writer.slopes_of(&known)
    }
}

struct Writer<'a> {
    model: &'a Model,
    directions: &'a Directions,
    nodes: Vec<Node>,
    /// Derivative of each node; `None` for zero, and for nodes of derivatives.
    slopes: Vec<Option<NodeId>>,
    known: FxHashMap<OpKey, NodeId>,
    names: std::collections::HashSet<String>,
}

impl<'a> Writer<'a> {
    fn new(model: &'a Model, directions: &'a Directions) -> Self {
        Self {
            model,
            directions,
            nodes: Vec::new(),
            slopes: Vec::new(),
            known: FxHashMap::default(),
            names: std::collections::HashSet::new(),
        }
    }

    /// Returns the node of an operation.
    fn node(&mut self, op: Op, name: Option<&str>) -> NodeId {
        let next = NodeId(self.nodes.len() as u32);
        // Sums and products commute to the last bit.
        let id = *self.known.entry(op.key()).or_insert(next);
        if id == next {
            let name = name.filter(|name| self.names.insert((*name).to_owned()));
            self.nodes.push(Node { op, name: name.map(str::to_owned) });
            self.slopes.push(None);
        }
        id
    }

    fn add(&mut self, op: Op) -> NodeId {
        self.node(op, None)
    }

    fn literal(&mut self, value: f64) -> NodeId {
        self.add(Op::Literal(value))
    }

    /// Returns the number of a derivative, which may be zero.
    fn number(&mut self, slope: Option<NodeId>) -> NodeId {
        slope.unwrap_or_else(|| self.literal(0.0))
    }

    /// Writes the motion and a tape behind it, and returns the nodes of their results.
    fn behind_motion(&mut self, tape: &Tape) -> (Vec<NodeId>, Vec<NodeId>) {
        let results = |tape: &Tape, known: &[NodeId]| -> Vec<NodeId> {
            tape.results.iter().map(|id| known[id.0 as usize]).collect()
        };
        let motion = self.model.motion.as_ref().map_or_else(Vec::new, |motion| {
            let known = self.copy(&motion.tape, &[]);
            results(&motion.tape, &known)
        });
        let known = self.copy(tape, &motion);
        (motion, results(tape, &known))
    }

    /// Returns a tape of the derivatives of nodes.
    fn slopes_of(mut self, nodes: &[NodeId]) -> Tape {
        let results: Vec<NodeId> = nodes.iter().map(|id| self.number(self.of(*id))).collect();
        reachable(&self.nodes, &results)
    }

    /// Writes the steps of a solution, without those on zeros, and returns the nodes of a matrix.
    fn solved(
        &mut self,
        solve: &Solve,
        factors: &[NodeId],
        inputs: &[NodeId],
        entries: usize,
    ) -> Vec<NodeId> {
        let zero = self.literal(0.0);
        let mut values = vec![zero; entries];
        let (given, right_sides) = inputs.split_at(solve.given.len());
        for (entry, value) in solve.given.iter().zip(given) {
            values[*entry as usize] = *value;
        }
        for column in 0..solve.columns {
            let mut work: Vec<Option<NodeId>> = vec![None; solve.rows as usize];
            let of_column = solve.right_sides.iter().zip(right_sides);
            for ((row, _), value) in of_column.filter(|((_, of), _)| *of == column) {
                work[*row as usize] = Some(*value);
            }
            for step in &solve.steps {
                let mut sum = work[step.row as usize];
                if let (Some(known), Some(scale)) = (sum, step.scale) {
                    sum = Some(self.derived(Op::Mul(known, factors[scale as usize]), None));
                }
                for (factor, from) in &step.terms {
                    let Some(from) = work[*from as usize] else { continue };
                    let product = self.derived(Op::Mul(factors[*factor as usize], from), None);
                    sum = Some(match sum {
                        Some(sum) => self.derived(Op::Sub(sum, product), None),
                        None => self.derived(Op::Neg(product), None),
                    });
                }
                work[step.row as usize] = sum;
            }
            for (entry, row, _) in solve.solved.iter().filter(|(.., of)| *of == column) {
                values[*entry as usize] = work[*row as usize].unwrap_or(zero);
            }
        }
        values
    }

    /// Returns the node of an operation, with its derivative.
    fn derived(&mut self, op: Op, name: Option<&str>) -> NodeId {
        let before = self.nodes.len();
        let id = self.node(op, name);
        // A node of a derivative may be computed by the tape as well.
        if id.0 as usize == before || self.slopes[id.0 as usize].is_none() {
            let slope = self.slope(op, id);
            self.slopes[id.0 as usize] = slope;
        }
        id
    }

    /// Writes the nodes of a tape and their derivatives; returns their ids.
    fn copy(&mut self, tape: &Tape, motion: &[NodeId]) -> Vec<NodeId> {
        let mut places: Vec<NodeId> = Vec::with_capacity(tape.nodes.len());
        for node in &tape.nodes {
            let id = if let Op::Motion(result) = node.op {
                motion[result as usize]
            } else {
                let op = node.op.with_operands(|id| places[id.0 as usize]);
                self.derived(op, node.name.as_deref())
            };
            places.push(id);
        }
        places
    }

    fn of(&self, id: NodeId) -> Option<NodeId> {
        self.slopes[id.0 as usize]
    }

    /// Returns the derivative of an operation, the node `value`.
    fn slope(&mut self, op: Op, value: NodeId) -> Option<NodeId> {
        let (states, parameters) = (self.model.states.len(), self.model.parameters.len());
        match op {
            Op::Literal(_) | Op::Held(_) => None,
            Op::Time => {
                let last = parameters + self.directions.along.len();
                Some(self.add(Op::Parameter(last as u32)))
            }
            Op::State(entry) => Some(self.add(Op::State(states as u32 + entry))),
            Op::Parameter(parameter) => {
                let place = self.directions.along.iter().position(|along| *along == parameter)?;
                Some(self.add(Op::Parameter((parameters + place) as u32)))
            }
            Op::Constant(_) | Op::Handed(_) | Op::Motion(_) => {
                unreachable!("tapes of machines without fields, before hoisting")
            }
            Op::Neg(a) => {
                let slope = self.of(a)?;
                Some(self.add(Op::Neg(slope)))
            }
            Op::Add(a, b) => self.sum(self.of(a), self.of(b)),
            Op::Sub(a, b) => self.difference(self.of(a), self.of(b)),
            Op::Mul(a, b) => {
                let left = self.of(a).map(|slope| self.add(Op::Mul(slope, b)));
                let right = self.of(b).map(|slope| self.add(Op::Mul(a, slope)));
                self.sum(left, right)
            }
            Op::Div(a, b) => {
                let by = self.of(b).map(|slope| self.add(Op::Mul(value, slope)));
                let slope = self.difference(self.of(a), by)?;
                Some(self.add(Op::Div(slope, b)))
            }
            Op::Powi(a, exponent) => self.power(a, exponent),
            Op::Powf(a, exponent) => self.real_power(a, exponent, value),
            Op::Call(function, a) => self.call(function, a, value),
            Op::SelectLess { lhs, rhs, then, otherwise } => {
                let slopes = [self.of(then), self.of(otherwise)];
                if slopes == [None; 2] {
                    return None;
                }
                let [then, otherwise] = slopes.map(|slope| self.number(slope));
                Some(self.add(Op::SelectLess { lhs, rhs, then, otherwise }))
            }
            Op::Table { table, order, argument } => {
                let along = self.of(argument)?;
                let slope = self.add(Op::Table { table, order: order + 1, argument });
                Some(self.add(Op::Mul(slope, along)))
            }
        }
    }

    fn sum(&mut self, a: Option<NodeId>, b: Option<NodeId>) -> Option<NodeId> {
        match (a, b) {
            (Some(a), Some(b)) => Some(self.add(Op::Add(a, b))),
            (one, other) => one.or(other),
        }
    }

    fn difference(&mut self, a: Option<NodeId>, b: Option<NodeId>) -> Option<NodeId> {
        match (a, b) {
            (Some(a), Some(b)) => Some(self.add(Op::Sub(a, b))),
            (None, Some(b)) => Some(self.add(Op::Neg(b))),
            (a, None) => a,
        }
    }

    /// Returns `slope along`, or zero if `along` is zero, even if the slope is infinite.
    fn chain(&mut self, slope: NodeId, along: NodeId) -> NodeId {
        let then = self.add(Op::Mul(slope, along));
        let [lhs, size] = [self.literal(0.0), self.add(Op::Call(Function::Abs, along))];
        self.add(Op::SelectLess { lhs, rhs: size, then, otherwise: lhs })
    }

    fn power(&mut self, a: NodeId, exponent: i32) -> Option<NodeId> {
        let along = self.of(a)?;
        let lower = match exponent {
            0 => return None,
            1 => return Some(along),
            2 => a,
            _ => self.add(Op::Powi(a, exponent - 1)),
        };
        let factor = self.literal(f64::from(exponent));
        let slope = self.add(Op::Mul(factor, lower));
        Some(if exponent < 0 { self.chain(slope, along) } else { self.add(Op::Mul(slope, along)) })
    }

    fn real_power(&mut self, base: NodeId, exponent: NodeId, value: NodeId) -> Option<NodeId> {
        let by_base = self.of(base).map(|along| {
            let one = self.literal(1.0);
            let lower = self.add(Op::Sub(exponent, one));
            let lower = self.add(Op::Powf(base, lower));
            let slope = self.add(Op::Mul(exponent, lower));
            self.chain(slope, along)
        });
        let by_exponent = self.of(exponent).map(|along| {
            let logarithm = self.add(Op::Call(Function::Ln, base));
            let slope = self.add(Op::Mul(value, logarithm));
            self.chain(slope, along)
        });
        self.sum(by_base, by_exponent)
    }

    fn call(&mut self, function: Function, x: NodeId, value: NodeId) -> Option<NodeId> {
        if function == Function::Floor {
            return None;
        }
        let along = self.of(x)?;
        let one = self.literal(1.0);
        let slope = match function {
            Function::Abs => {
                let then = self.add(Op::Neg(along));
                let rhs = self.literal(0.0);
                return Some(self.add(Op::SelectLess { lhs: x, rhs, then, otherwise: along }));
            }
            Function::Sqrt => {
                let half = self.literal(0.5);
                Op::Div(half, value)
            }
            Function::Exp | Function::Floor => return Some(self.add(Op::Mul(value, along))),
            Function::Ln => Op::Div(one, x),
            Function::Sin => Op::Call(Function::Cos, x),
            Function::Cos => {
                let sine = self.add(Op::Call(Function::Sin, x));
                Op::Neg(sine)
            }
            Function::Tan => {
                let square = self.add(Op::Mul(value, value));
                Op::Add(one, square)
            }
            Function::Asin | Function::Acos => {
                let [below, above] = [self.add(Op::Sub(one, x)), self.add(Op::Add(one, x))];
                let product = self.add(Op::Mul(below, above));
                let root = self.add(Op::Call(Function::Sqrt, product));
                let sign = if function == Function::Asin { one } else { self.literal(-1.0) };
                Op::Div(sign, root)
            }
            Function::Atan => {
                let square = self.add(Op::Mul(x, x));
                let sum = self.add(Op::Add(one, square));
                Op::Div(one, sum)
            }
            Function::Sinh => Op::Call(Function::Cosh, x),
            Function::Cosh => Op::Call(Function::Sinh, x),
            Function::Tanh => {
                let cosh = self.add(Op::Call(Function::Cosh, x));
                let square = self.add(Op::Mul(cosh, cosh));
                Op::Div(one, square)
            }
        };
        let slope = self.add(slope);
        let is_vertical =
            matches!(function, Function::Sqrt | Function::Ln | Function::Asin | Function::Acos);
        Some(if is_vertical { self.chain(slope, along) } else { self.add(Op::Mul(slope, along)) })
    }
}

//! Construction of recurrences from a model.

use std::collections::BTreeMap;

use super::{Extent, MassMatrix, Recurrence, SeriesNode, TaylorTape};
use crate::{Function, Model, NodeId, Op, StateKind, Tape, reachable};

/// Returns the recurrences of a model's solution.
///
/// If the mass matrix is variable and couples coordinates, the accelerations remain unknowns of a
/// linear system; otherwise the solved rate is used.
#[must_use]
pub fn recurrences(model: &Model) -> TaylorTape {
    let mut builder = Builder::default();
    let entries = builder.translate(&model.mass_matrix.tape, &model.mass_matrix.tape.results);
    let pattern = &model.mass_matrix.pattern.entries;
    let couples = pattern.iter().any(|(row, column)| row != column);
    let moves = entries.iter().any(|&entry| !builder.tape.is_constant(entry));
    let is_free = model.constraints.is_empty();
    let mut tape = if couples && moves && is_free {
        unsolved(builder, model, &entries)
    } else {
        solved(model)
    };
    keep_needed(&mut tape);
    tape
}

/// Translates the rate tape.
fn solved(model: &Model) -> TaylorTape {
    let mut builder = Builder::default();
    builder.tape.rate = builder.translate(&model.rate, &model.rate.results);
    builder.tape
}

/// Keeps the accelerations as unknowns of `M a = f`.
fn unsolved(mut builder: Builder, model: &Model, entries: &[NodeId]) -> TaylorTape {
    let n = model.coordinates.len();
    let forcing = builder.translate(&model.forcing, &model.forcing.results);
    let accelerations: Vec<NodeId> =
        (0..n).map(|i| builder.push(Recurrence::Acceleration(i as u32))).collect();
    for (&id, coordinate) in accelerations.iter().zip(&model.coordinates) {
        builder.name(id, Some(&format!("{}_dot", coordinate.velocity.name.ident)));
    }
    let mut lagged = vec![Vec::new(); n];
    let mut lower = Vec::new();
    for (&(row, column), &entry) in model.mass_matrix.pattern.entries.iter().zip(entries) {
        if column <= row {
            lower.push((row, column, entry));
        }
        if !builder.tape.is_constant(entry) {
            let acceleration = accelerations[column as usize];
            lagged[row as usize].push(builder.push(Recurrence::Lagged { entry, acceleration }));
        }
    }
    let right_side = forcing.iter().zip(&lagged).map(|(&forcing, lagged)| {
        let known = builder.balanced_sum(lagged);
        known.map_or(forcing, |known| builder.push(Recurrence::Sub(forcing, known)))
    });
    let right_side = right_side.collect();
    let states = model.states.iter().zip(&model.rate.results);
    builder.tape.rate = states
        .map(|(state, &rate)| match state.kind {
            StateKind::Velocity(id) => accelerations[id as usize],
            StateKind::Position(_) | StateKind::FirstOrder | StateKind::Mode => {
                builder.translate(&model.rate, &[rate])[0]
            }
        })
        .collect();
    builder.tape.mass_matrix = Some(MassMatrix { lower, right_side, accelerations });
    builder.tape
}

#[derive(Default)]
struct Builder {
    tape: TaylorTape,
    /// Nodes by their text, so that each is stored once.
    known: BTreeMap<String, NodeId>,
}

impl Builder {
    /// Translates the part of a tape that `results` need.
    fn translate(&mut self, tape: &Tape, results: &[NodeId]) -> Vec<NodeId> {
        let tape = reachable(&tape.nodes, results);
        let mut place: Vec<NodeId> = Vec::with_capacity(tape.nodes.len());
        for node in &tape.nodes {
            let op = node.op.with_operands(|id| place[id.0 as usize]);
            let id = self.node(op);
            self.name(id, node.name.as_deref());
            place.push(id);
        }
        tape.results.iter().map(|id| place[id.0 as usize]).collect()
    }

    /// Adds an operation on nodes of this tape.
    fn node(&mut self, op: Op) -> NodeId {
        let reads_machine = matches!(op, Op::Time | Op::State(_));
        if !reads_machine && op.operands().iter().all(|&id| self.tape.is_constant(id)) {
            return self.push(Recurrence::Constant(op));
        }
        match op {
            Op::Literal(_) | Op::Parameter(_) | Op::Handed(_) | Op::Held(_) | Op::Constant(_) => {
                self.push(Recurrence::Constant(op))
            }
            Op::Motion(_) => unreachable!("the tapes that series are made of stand by themselves"),
            Op::Time => self.push(Recurrence::Time),
            Op::State(entry) => self.push(Recurrence::State(entry)),
            Op::Neg(a) => self.push(Recurrence::Neg(a)),
            Op::Add(a, b) => self.push(Recurrence::Add(a, b)),
            Op::Sub(a, b) => self.difference(a, b),
            Op::Mul(a, b) => self.product(a, b),
            Op::Div(a, b) => self.quotient(a, b),
            Op::Powi(base, exponent) => self.integer_power(base, exponent),
            Op::Powf(base, exponent) => self.power(base, exponent),
            Op::Call(function, argument) => self.call(function, argument),
            Op::SelectLess { lhs, rhs, then, otherwise } => {
                self.push(Recurrence::Select { lhs, rhs, then, otherwise })
            }
            Op::Table { table, order, argument } => {
                let square = self.push(Recurrence::Tail(argument, argument));
                let cube = self.push(Recurrence::Tail(square, argument));
                self.push(Recurrence::Table { table, order, argument, square, cube })
            }
        }
    }

    fn push(&mut self, recurrence: Recurrence) -> NodeId {
        let text = format!("{recurrence:?}");
        if let Some(&known) = self.known.get(&text) {
            return known;
        }
        let id = self.next_id();
        let extent = self.extent(&recurrence);
        self.tape.nodes.push(SeriesNode { recurrence, extent, name: None });
        self.known.insert(text, id);
        id
    }

    fn next_id(&self) -> NodeId {
        NodeId(self.tape.nodes.len() as u32)
    }

    fn name(&mut self, id: NodeId, name: Option<&str>) {
        let node = &mut self.tape.nodes[id.0 as usize];
        if node.name.is_none() && !matches!(node.recurrence, Recurrence::State(_)) {
            node.name = name.map(str::to_owned);
        }
    }

    fn extent(&self, recurrence: &Recurrence) -> Extent {
        let of = |id: NodeId| self.tape[id].extent;
        match *recurrence {
            Recurrence::Constant(_) => Extent::Constant,
            Recurrence::Time => Extent::Line,
            Recurrence::Neg(a) | Recurrence::Scaled { series: a, .. } => of(a),
            Recurrence::Add(a, b) | Recurrence::Sub(a, b) => of(a).max(of(b)),
            _ => Extent::Series,
        }
    }

    fn number(&mut self, value: f64) -> NodeId {
        self.push(Recurrence::Constant(Op::Literal(value)))
    }

    /// Returns `a - b`, as `-(b - a)` if that difference exists already, so that functions of both
    /// are shared.
    fn difference(&mut self, a: NodeId, b: NodeId) -> NodeId {
        let opposite = format!("{:?}", Recurrence::Sub(b, a));
        match self.known.get(&opposite) {
            Some(&opposite) => self.push(Recurrence::Neg(opposite)),
            None => self.push(Recurrence::Sub(a, b)),
        }
    }

    fn product(&mut self, a: NodeId, b: NodeId) -> NodeId {
        if self.tape.is_constant(a) {
            return self.scaled(b, a);
        }
        if self.tape.is_constant(b) {
            return self.scaled(a, b);
        }
        self.push(Recurrence::Product(a, b))
    }

    /// Merges constant factors: the cost of an order is its longest chain.
    fn scaled(&mut self, series: NodeId, factor: NodeId) -> NodeId {
        let Recurrence::Scaled { series: inner, factor: first } = self.tape[series].recurrence
        else {
            return self.push(Recurrence::Scaled { series, factor });
        };
        let literal = |id: NodeId| match self.tape[id].recurrence {
            Recurrence::Constant(Op::Literal(value)) => Some(value),
            _ => None,
        };
        let factor = match (literal(first), literal(factor)) {
            (Some(a), Some(b)) if (a * b).is_finite() => self.number(a * b),
            _ => self.push(Recurrence::Constant(Op::Mul(first, factor))),
        };
        self.push(Recurrence::Scaled { series: inner, factor })
    }

    fn quotient(&mut self, a: NodeId, b: NodeId) -> NodeId {
        if !self.tape.is_constant(b) {
            return self.push(Recurrence::Quotient(a, b));
        }
        let factor = match self.tape[b].recurrence {
            // Exact, so that halves need no division.
            Recurrence::Constant(Op::Literal(value)) if value.log2().fract() == 0.0 => {
                self.number(1.0 / value)
            }
            _ => {
                let one = self.number(1.0);
                self.push(Recurrence::Constant(Op::Div(one, b)))
            }
        };
        self.scaled(a, factor)
    }

    /// Expands a power by repeated squaring.
    fn integer_power(&mut self, base: NodeId, exponent: i32) -> NodeId {
        let mut power = None;
        let mut square = base;
        let mut left = exponent.unsigned_abs();
        while left > 0 {
            if left & 1 == 1 {
                power = Some(power.map_or(square, |power| self.product(power, square)));
            }
            left >>= 1;
            if left > 0 {
                square = self.product(square, square);
            }
        }
        let one = self.number(1.0);
        let power = power.unwrap_or(one);
        if exponent < 0 { self.quotient(one, power) } else { power }
    }

    fn power(&mut self, base: NodeId, exponent: NodeId) -> NodeId {
        if !self.tape.is_constant(exponent) {
            let logarithm = self.node(Op::Call(Function::Ln, base));
            let product = self.product(exponent, logarithm);
            return self.call(Function::Exp, product);
        }
        self.push(Recurrence::Power { base, exponent })
    }

    /// Returns a function by its differential equation; odd and even functions of -x by those of x.
    fn call(&mut self, function: Function, x: NodeId) -> NodeId {
        if let (Recurrence::Neg(x), Some(is_odd)) = (self.tape[x].recurrence, function.is_odd()) {
            let of_x = self.call(function, x);
            return if is_odd { self.push(Recurrence::Neg(of_x)) } else { of_x };
        }
        match function {
            Function::Sqrt => self.push(Recurrence::Root(x)),
            Function::Abs => {
                let (zero, minus) = (self.number(0.0), self.push(Recurrence::Neg(x)));
                self.push(Recurrence::Select { lhs: x, rhs: zero, then: minus, otherwise: x })
            }
            Function::Floor => {
                let zero = self.number(0.0);
                self.integral(Function::Floor, x, zero, false)
            }
            Function::Exp => {
                let itself = self.next_id();
                self.integral(Function::Exp, x, itself, false)
            }
            Function::Sin => self.pair(x, [Function::Sin, Function::Cos], true).0,
            Function::Cos => self.pair(x, [Function::Sin, Function::Cos], true).1,
            Function::Sinh => self.pair(x, [Function::Sinh, Function::Cosh], false).0,
            Function::Cosh => self.pair(x, [Function::Sinh, Function::Cosh], false).1,
            Function::Tan => self.with_square(Function::Tan, x, Recurrence::Add),
            Function::Tanh => self.with_square(Function::Tanh, x, Recurrence::Sub),
            Function::Ln => self.integral_over(function, x, x, false),
            Function::Atan => {
                let divisor = self.one_and_square(x, Recurrence::Add);
                self.integral_over(function, x, divisor, false)
            }
            Function::Asin | Function::Acos => {
                let under = self.one_and_square(x, Recurrence::Sub);
                let root = self.push(Recurrence::Root(under));
                self.integral_over(function, x, root, function == Function::Acos)
            } // Operations of their own, and never calls; see `tape::Op`.
        }
    }

    fn integral(
        &mut self,
        function: Function,
        argument: NodeId,
        integrand: NodeId,
        minus: bool,
    ) -> NodeId {
        // The integrand's id depends on the position of this node, so equal functions are
        // recognized by function and argument only.
        let text = format!("{function:?} of {argument:?}");
        if let Some(&known) = self.known.get(&text) {
            return known;
        }
        let id = self.push(Recurrence::Integral { function, argument, integrand, minus });
        self.known.insert(text, id);
        id
    }

    fn integral_over(
        &mut self,
        function: Function,
        argument: NodeId,
        divisor: NodeId,
        minus: bool,
    ) -> NodeId {
        self.push(Recurrence::IntegralOver { function, argument, divisor, minus })
    }

    /// Adds two functions, each the derivative of the other, the second with a minus if `minus`.
    fn pair(&mut self, x: NodeId, functions: [Function; 2], minus: bool) -> (NodeId, NodeId) {
        let NodeId(next) = self.next_id();
        let first = self.integral(functions[0], x, NodeId(next + 1), false);
        let second = self.integral(functions[1], x, first, minus);
        (first, second)
    }

    /// Adds a function with derivative 1 + y^2 or 1 - y^2.
    fn with_square(
        &mut self,
        function: Function,
        x: NodeId,
        combine: fn(NodeId, NodeId) -> Recurrence,
    ) -> NodeId {
        let one = self.number(1.0);
        let NodeId(next) = self.next_id();
        // The square and its sum with one are new nodes too, because they read this node.
        let y = self.integral(function, x, NodeId(next + 2), false);
        let square = self.push(Recurrence::Product(y, y));
        self.push(combine(one, square));
        y
    }

    fn one_and_square(&mut self, x: NodeId, combine: fn(NodeId, NodeId) -> Recurrence) -> NodeId {
        let (one, square) = (self.number(1.0), self.push(Recurrence::Product(x, x)));
        self.push(combine(one, square))
    }

    /// Adds terms as a balanced tree, without a long chain.
    fn balanced_sum(&mut self, terms: &[NodeId]) -> Option<NodeId> {
        match terms {
            [] => None,
            [only] => Some(*only),
            _ => {
                let (front, back) = terms.split_at(terms.len() / 2);
                let (front, back) = (self.balanced_sum(front)?, self.balanced_sum(back)?);
                Some(self.push(Recurrence::Add(front, back)))
            }
        }
    }
}

/// Removes nodes that no rate needs.
fn keep_needed(tape: &mut TaylorTape) {
    let mut needed = vec![false; tape.nodes.len()];
    let mut waiting = tape.rate.clone();
    if let Some(mass) = &tape.mass_matrix {
        waiting.extend(mass.lower.iter().map(|(_, _, entry)| *entry));
        waiting.extend(mass.right_side.iter().chain(&mass.accelerations));
    }
    while let Some(NodeId(index)) = waiting.pop() {
        if !std::mem::replace(&mut needed[index as usize], true) {
            waiting.extend(tape.nodes[index as usize].recurrence.reads());
        }
    }
    let mut count = 0;
    let place = needed.iter().map(|needed| {
        count += u32::from(*needed);
        NodeId(count.saturating_sub(1))
    });
    let place: Vec<NodeId> = place.collect();
    let to = |id: NodeId| place[id.0 as usize];
    let nodes = std::mem::take(&mut tape.nodes).into_iter().zip(needed);
    tape.nodes = nodes.filter(|(_, needed)| *needed).map(|(node, _)| node).collect();
    for node in &mut tape.nodes {
        node.recurrence = node.recurrence.with_reads(to);
    }
    let move_all = |ids: &mut Vec<NodeId>| ids.iter_mut().for_each(|id| *id = to(*id));
    move_all(&mut tape.rate);
    if let Some(mass) = &mut tape.mass_matrix {
        mass.lower.iter_mut().for_each(|(_, _, entry)| *entry = to(*entry));
        move_all(&mut mass.right_side);
        move_all(&mut mass.accelerations);
    }
}

impl Recurrence {
    /// Returns the nodes whose coefficients are read, earlier or later ones.
    #[must_use]
    pub fn reads(&self) -> Vec<NodeId> {
        let mut reads = Vec::new();
        let note = |id| {
            reads.push(id);
            id
        };
        let _ = self.with_reads(note);
        reads
    }

    /// Returns the same recurrence on other nodes.
    #[must_use]
    pub fn with_reads(self, mut to: impl FnMut(NodeId) -> NodeId) -> Self {
        match self {
            Self::Time | Self::State(_) | Self::Acceleration(_) => self,
            Self::Constant(op) => Self::Constant(op.with_operands(to)),
            Self::Neg(a) => Self::Neg(to(a)),
            Self::Root(a) => Self::Root(to(a)),
            Self::Add(a, b) => Self::Add(to(a), to(b)),
            Self::Sub(a, b) => Self::Sub(to(a), to(b)),
            Self::Product(a, b) => Self::Product(to(a), to(b)),
            Self::Tail(a, b) => Self::Tail(to(a), to(b)),
            Self::Quotient(a, b) => Self::Quotient(to(a), to(b)),
            Self::Scaled { series, factor } => {
                Self::Scaled { series: to(series), factor: to(factor) }
            }
            Self::Integral { function, argument, integrand, minus } => {
                let (argument, integrand) = (to(argument), to(integrand));
                Self::Integral { function, argument, integrand, minus }
            }
            Self::IntegralOver { function, argument, divisor, minus } => {
                let (argument, divisor) = (to(argument), to(divisor));
                Self::IntegralOver { function, argument, divisor, minus }
            }
            Self::Power { base, exponent } => {
                Self::Power { base: to(base), exponent: to(exponent) }
            }
            Self::Select { lhs, rhs, then, otherwise } => {
                let [lhs, rhs, then, otherwise] = [lhs, rhs, then, otherwise].map(to);
                Self::Select { lhs, rhs, then, otherwise }
            }
            Self::Table { table, order, argument, square, cube } => {
                let [argument, square, cube] = [argument, square, cube].map(to);
                Self::Table { table, order, argument, square, cube }
            }
            Self::Lagged { entry, acceleration } => {
                Self::Lagged { entry: to(entry), acceleration: to(acceleration) }
            }
        }
    }
}

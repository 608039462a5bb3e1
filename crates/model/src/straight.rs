//! Straight-line programs from which machine code or WebAssembly is made: reads, operations and
//! writes.
//!
//! Excluded: integer powers (they become products), unused operations, names.

use std::collections::HashMap;

use crate::{Function, NodeId, Op, TableId, Tape, needed_nodes};

/// Index of a step in its program.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct StepId(pub u32);

/// A block of numbers behind one pointer.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Region {
    /// Time; for series the numbers of an order.
    Time,
    /// The state; for series its coefficients of an order.
    State,
    /// Parameters.
    Parameters,
    /// Values that fields hand over.
    Handed,
    /// Constants computed before.
    Constants,
    /// Results of the motion.
    Motion,
    /// Results, the only region that is written.
    Results,
}

impl Region {
    /// Number of regions.
    pub const COUNT: usize = 7;
}

/// One operation.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Step {
    /// A literal.
    Literal(f64),
    /// An entry of a region.
    Read(Region, u32),
    /// -a.
    Neg(StepId),
    /// a + b.
    Add(StepId, StepId),
    /// a - b.
    Sub(StepId, StepId),
    /// a b.
    Mul(StepId, StepId),
    /// a / b.
    Div(StepId, StepId),
    /// Real power.
    Powf(StepId, StepId),
    /// A function of one argument.
    Call(Function, StepId),
    /// The third operand if the first is less than the second, else the fourth.
    SelectLess([StepId; 4]),
    /// Cubic table or its derivative.
    Table(TableId, u32, StepId),
}

impl Step {
    /// Returns the steps that it reads.
    pub fn operands(&self) -> impl Iterator<Item = StepId> + use<> {
        let none = [None; 4];
        let all = match *self {
            Step::Literal(_) | Step::Read(..) => none,
            Step::Neg(a) | Step::Call(_, a) | Step::Table(_, _, a) => [Some(a), None, None, None],
            Step::Add(a, b)
            | Step::Sub(a, b)
            | Step::Mul(a, b)
            | Step::Div(a, b)
            | Step::Powf(a, b) => [Some(a), Some(b), None, None],
            Step::SelectLess(all) => all.map(Some),
        };
        all.into_iter().flatten()
    }

    /// Returns the same operation on other steps.
    fn with_operands(self, to: impl Fn(StepId) -> StepId) -> Self {
        match self {
            Step::Literal(_) | Step::Read(..) => self,
            Step::Neg(a) => Step::Neg(to(a)),
            Step::Add(a, b) => Step::Add(to(a), to(b)),
            Step::Sub(a, b) => Step::Sub(to(a), to(b)),
            Step::Mul(a, b) => Step::Mul(to(a), to(b)),
            Step::Div(a, b) => Step::Div(to(a), to(b)),
            Step::Powf(a, b) => Step::Powf(to(a), to(b)),
            Step::Call(function, a) => Step::Call(function, to(a)),
            Step::SelectLess(all) => Step::SelectLess(all.map(to)),
            Step::Table(table, order, a) => Step::Table(table, order, to(a)),
        }
    }

    /// Returns whether the step is only a number in memory.
    pub fn is_leaf(&self) -> bool {
        matches!(self, Step::Literal(_) | Step::Read(..))
    }

    /// Returns whether the step calls an external function.
    pub fn is_call(&self) -> bool {
        match self {
            Step::Call(function, _) => !matches!(function, Function::Sqrt | Function::Abs),
            Step::Powf(..) | Step::Table(..) => true,
            _ => false,
        }
    }

    fn key(&self) -> (u8, [u64; 4]) {
        let n = |id: StepId| u64::from(id.0);
        match *self {
            Step::Literal(value) => (0, [value.to_bits(), 0, 0, 0]),
            Step::Read(region, entry) => (1, [region as u64, u64::from(entry), 0, 0]),
            Step::Neg(a) => (2, [n(a), 0, 0, 0]),
            Step::Add(a, b) => (3, [n(a), n(b), 0, 0]),
            Step::Sub(a, b) => (4, [n(a), n(b), 0, 0]),
            Step::Mul(a, b) => (5, [n(a), n(b), 0, 0]),
            Step::Div(a, b) => (6, [n(a), n(b), 0, 0]),
            Step::Powf(a, b) => (7, [n(a), n(b), 0, 0]),
            Step::Call(function, a) => (8, [function as u64, n(a), 0, 0]),
            Step::SelectLess(all) => (9, all.map(n)),
            Step::Table(table, order, a) => (10, [u64::from(table.0), u64::from(order), n(a), 0]),
        }
    }
}

/// Sums of products for series that are formed before the steps: `sum of left_j right_(k-j)`, j
/// from 2 to k - 2, in all lanes together.
///
/// Rows of factors follow one another. The row of order 1 is the first of the parameters, that of
/// order k - 1 the first of the state. Sums are written to the results.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Middles {
    /// Number of sums.
    pub count: usize,
    /// Index of the first left factor in a row.
    pub left: usize,
    /// Index of the first right factor in a row.
    pub right: usize,
    /// Index of the first sum in the results.
    pub sums: usize,
    /// Length of a row.
    pub row: usize,
}

/// Steps in order of evaluation, and the results to write.
#[derive(Debug, Clone, Default)]
pub struct Straight {
    /// Steps, each of which reads earlier steps only.
    pub steps: Vec<Step>,
    /// Entries of the results with the steps that give them.
    pub writes: Vec<(u32, StepId)>,
    /// Sums formed before the steps.
    pub middles: Option<Middles>,
    known: HashMap<(u8, [u64; 4]), StepId>,
}

impl Straight {
    /// Adds a step, or returns the equal step that is already there.
    pub fn push(&mut self, step: Step) -> StepId {
        let next = StepId(self.steps.len() as u32);
        let id = *self.known.entry(step.key()).or_insert(next);
        if id == next {
            self.steps.push(step);
        }
        id
    }

    /// Adds a literal.
    pub fn literal(&mut self, value: f64) -> StepId {
        self.push(Step::Literal(value))
    }

    /// Returns a step.
    pub fn step(&self, id: StepId) -> Step {
        self.steps[id.0 as usize]
    }

    /// Adds an operation of a tape whose operands are known. Returns `None` if its table does not
    /// exist.
    pub fn operation(
        &mut self,
        op: Op,
        of: impl Fn(NodeId) -> Option<StepId>,
        tables: usize,
    ) -> Option<StepId> {
        let step = match op {
            Op::Literal(value) => Step::Literal(value),
            Op::Time => Step::Read(Region::Time, 0),
            Op::State(entry) => Step::Read(Region::State, entry),
            Op::Parameter(entry) | Op::Held(entry) => Step::Read(Region::Parameters, entry),
            Op::Handed(entry) => Step::Read(Region::Handed, entry),
            Op::Constant(entry) => Step::Read(Region::Constants, entry),
            Op::Motion(entry) => Step::Read(Region::Motion, entry),
            Op::Neg(a) => Step::Neg(of(a)?),
            Op::Add(a, b) => Step::Add(of(a)?, of(b)?),
            Op::Sub(a, b) => Step::Sub(of(a)?, of(b)?),
            Op::Mul(a, b) => Step::Mul(of(a)?, of(b)?),
            Op::Div(a, b) => Step::Div(of(a)?, of(b)?),
            Op::Powf(a, b) => Step::Powf(of(a)?, of(b)?),
            Op::Powi(base, exponent) => return Some(self.integer_power(of(base)?, exponent)),
            Op::Call(function, a) => Step::Call(function, of(a)?),
            Op::SelectLess { lhs, rhs, then, otherwise } => {
                Step::SelectLess([of(lhs)?, of(rhs)?, of(then)?, of(otherwise)?])
            }
            Op::Table { table, .. } if table.0 as usize >= tables => return None,
            Op::Table { table, order, argument } => Step::Table(table, order, of(argument)?),
        };
        Some(self.push(step))
    }

    /// Expands a power by repeated squaring, as the contract does. The contract's initial product
    /// with one is left out, because it changes nothing.
    fn integer_power(&mut self, base: StepId, exponent: i32) -> StepId {
        let (mut power, mut square) = (None, base);
        let mut left = exponent.unsigned_abs();
        while left > 0 {
            if left & 1 == 1 {
                power = Some(power.map_or(square, |power| self.push(Step::Mul(power, square))));
            }
            left >>= 1;
            if left > 0 {
                square = self.push(Step::Mul(square, square));
            }
        }
        let one = self.literal(1.0);
        let power = power.unwrap_or(one);
        if exponent < 0 { self.push(Step::Div(one, power)) } else { power }
    }

    /// Translates a tape, with its results in order. Returns `None` for a tape that breaks the
    /// rules of models.
    pub fn of_tape(tape: &Tape, tables: usize) -> Option<Self> {
        let mut straight = Self::default();
        let mut places: Vec<Option<StepId>> = Vec::with_capacity(tape.nodes.len());
        for (node, needed) in tape.nodes.iter().zip(needed_nodes(tape)) {
            let of = |id: NodeId| places.get(id.0 as usize).copied().flatten();
            let place = if needed { Some(straight.operation(node.op, of, tables)?) } else { None };
            places.push(place);
        }
        for (entry, id) in tape.results.iter().enumerate() {
            straight.writes.push((entry as u32, places.get(id.0 as usize).copied().flatten()?));
        }
        Some(straight.pruned())
    }

    /// Returns the program without the steps that no result needs.
    pub fn pruned(&self) -> Self {
        let mut needed = vec![false; self.steps.len()];
        self.writes.iter().for_each(|(_, id)| needed[id.0 as usize] = true);
        for (index, step) in self.steps.iter().enumerate().rev() {
            if needed[index] {
                step.operands().for_each(|id| needed[id.0 as usize] = true);
            }
        }
        let mut pruned = Self { middles: self.middles, ..Self::default() };
        let mut places = vec![StepId(0); self.steps.len()];
        for (index, step) in self.steps.iter().enumerate().filter(|(index, _)| needed[*index]) {
            places[index] = pruned.push(step.with_operands(|id| places[id.0 as usize]));
        }
        pruned.writes =
            self.writes.iter().map(|&(entry, id)| (entry, places[id.0 as usize])).collect();
        pruned
    }

    /// Returns the length that each region must have.
    #[cfg(feature = "compiled")]
    pub fn needs(&self) -> [usize; Region::COUNT] {
        let mut needs = [0; Region::COUNT];
        let mut note = |region: Region, entry: u32| {
            let need = &mut needs[region as usize];
            *need = (*need).max(entry as usize + 1);
        };
        for step in &self.steps {
            if let Step::Read(region, entry) = *step {
                note(region, entry);
            }
        }
        self.writes.iter().for_each(|&(entry, _)| note(Region::Results, entry));
        if let Some(middles) = self.middles {
            for region in [Region::State, Region::Parameters, Region::Results] {
                note(region, middles.row as u32 - 1);
            }
        }
        needs
    }
}

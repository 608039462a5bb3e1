//! Translation of a straight-line program to the body of a function.
//!
//! WebAssembly is a stack machine: a value that is read once is computed where it is read. A value
//! that is read more often is kept in a local, which is reused after its last read.

use std::collections::HashMap;

use wasm_encoder::{Function as Body, InstructionSink, MemArg, MemArgTarget, ValType};

use super::{Imports, POWER, Places, TableKey};
use crate::Function;
use crate::straight::{Region, Step, StepId, Straight};

/// Nesting depth beyond which values are kept in a local: hosts and this module walk nested
/// operations recursively.
const DEEPEST: u32 = 48;

/// The local that holds time, the only argument.
const TIME: u32 = 0;

/// Indices of functions that bodies call.
pub(super) struct Calls<'a> {
    pub(super) host: &'a Imports,
    pub(super) tables: HashMap<TableKey, u32>,
}

/// Returns the body of a program that calls the function `before`, if any, and writes its results
/// from the byte `into` on.
pub(super) fn body(
    straight: &Straight,
    places: &Places,
    into: usize,
    calls: &Calls<'_>,
    before: Option<u32>,
) -> Body {
    let plan = Plan::of(straight);
    let locals = plan.locals.iter().flatten().max().map_or(0, |last| last - TIME);
    let mut body = Body::new([(locals, ValType::F64)]);
    let mut sink = body.instructions();
    if let Some(before) = before {
        sink.local_get(TIME).call(before);
    }
    let writer = Writer { straight, places, calls, plan: &plan };
    for root in &plan.roots {
        match *root {
            Root::Keep(id) => {
                writer.operation(&mut sink, id);
                if let Some(local) = plan.locals[id.0 as usize] {
                    sink.local_set(local);
                }
            }
            Root::Write(entry, id) => {
                sink.i32_const(0);
                writer.value(&mut sink, id);
                sink.f64_store(place(into + 8 * entry as usize));
            }
        }
    }
    sink.end();
    body
}

fn place(byte: usize) -> MemArg {
    MemArg { offset: byte as u64, align: 3, target: MemArgTarget::default(), ordering: None }
}

/// A statement of the body.
#[derive(Clone, Copy)]
enum Root {
    /// Stores a value in its local.
    Keep(StepId),
    /// Writes a result.
    Write(u32, StepId),
}

impl Root {
    fn step(self) -> StepId {
        let (Self::Keep(id) | Self::Write(_, id)) = self;
        id
    }
}

/// Values that are kept, and their locals.
struct Plan {
    roots: Vec<Root>,
    /// Local of each step that has one.
    locals: Vec<Option<u32>>,
}

impl Plan {
    fn of(straight: &Straight) -> Self {
        let is_kept = kept(straight);
        let keeps = is_kept.iter().enumerate().filter(|(_, is_kept)| **is_kept);
        let keeps = keeps.map(|(index, _)| Root::Keep(StepId(index as u32)));
        let writes = straight.writes.iter().map(|&(entry, id)| Root::Write(entry, id));
        let roots: Vec<Root> = keeps.chain(writes).collect();
        let reads: Vec<Vec<StepId>> =
            roots.iter().map(|root| read_by(straight, &is_kept, *root)).collect();
        let mut last_reader = vec![0; is_kept.len()];
        for (reader, read) in reads.iter().enumerate() {
            for id in read {
                last_reader[id.0 as usize] = reader;
            }
        }
        let mut locals: Vec<Option<u32>> = vec![None; is_kept.len()];
        let (mut free, mut next) = (Vec::new(), TIME + 1);
        for (reader, (root, read)) in roots.iter().zip(&reads).enumerate() {
            for id in read {
                let index = id.0 as usize;
                // A local that this root reads twice is freed once.
                if last_reader[index] == reader
                    && let Some(local) = locals[index].filter(|local| !free.contains(local))
                {
                    free.push(local);
                }
            }
            if let Root::Keep(id) = root {
                locals[id.0 as usize] = Some(free.pop().unwrap_or_else(|| {
                    next += 1;
                    next - 1
                }));
            }
        }
        Self { roots, locals }
    }
}

/// Returns for each step whether it is kept in a local.
fn kept(straight: &Straight) -> Vec<bool> {
    let mut readers = vec![0_u32; straight.steps.len()];
    let operands = straight.steps.iter().flat_map(Step::operands);
    operands.chain(straight.writes.iter().map(|(_, id)| *id)).for_each(|id| {
        readers[id.0 as usize] += 1;
    });
    let mut depths = vec![0_u32; straight.steps.len()];
    let mut is_kept = vec![false; straight.steps.len()];
    for (index, step) in straight.steps.iter().enumerate() {
        let depth = step.operands().map(|id| depths[id.0 as usize]).max().map_or(0, |d| d + 1);
        is_kept[index] = !step.is_leaf() && (readers[index] > 1 || depth > DEEPEST);
        depths[index] = if is_kept[index] { 0 } else { depth };
    }
    is_kept
}

/// Returns the kept values that a root reads.
fn read_by(straight: &Straight, is_kept: &[bool], root: Root) -> Vec<StepId> {
    let mut read = Vec::new();
    let mut left = match root {
        Root::Keep(id) => straight.step(id).operands().collect(),
        Root::Write(_, id) => vec![id],
    };
    while let Some(id) = left.pop() {
        if is_kept[id.0 as usize] {
            read.push(id);
        } else {
            left.extend(straight.step(id).operands());
        }
    }
    debug_assert!(!matches!(root, Root::Keep(id) if read.contains(&id)), "{:?}", root.step());
    read
}

struct Writer<'a> {
    straight: &'a Straight,
    places: &'a Places,
    calls: &'a Calls<'a>,
    plan: &'a Plan,
}

impl Writer<'_> {
    /// Pushes the value of a step onto the stack.
    fn value(&self, sink: &mut InstructionSink<'_>, id: StepId) {
        match self.plan.locals[id.0 as usize] {
            Some(local) => {
                sink.local_get(local);
            }
            None => self.operation(sink, id),
        }
    }

    /// Computes a step on the stack.
    fn operation(&self, sink: &mut InstructionSink<'_>, id: StepId) {
        let step = self.straight.step(id);
        if let Step::SelectLess([lhs, rhs, then, otherwise]) = step {
            // The condition comes last.
            for id in [then, otherwise, lhs, rhs] {
                self.value(sink, id);
            }
            sink.f64_lt().select();
            return;
        }
        step.operands().for_each(|id| self.value(sink, id));
        match step {
            Step::Literal(value) => sink.f64_const(value.into()),
            Step::Read(Region::Time, _) => sink.local_get(TIME),
            Step::Read(region, entry) => {
                let byte = self.places.regions[region as usize] + 8 * entry as usize;
                sink.i32_const(0).f64_load(place(byte))
            }
            Step::Neg(_) => sink.f64_neg(),
            Step::Add(..) => sink.f64_add(),
            Step::Sub(..) => sink.f64_sub(),
            Step::Mul(..) => sink.f64_mul(),
            Step::Div(..) => sink.f64_div(),
            Step::Call(Function::Sqrt, _) => sink.f64_sqrt(),
            Step::Call(Function::Abs, _) => sink.f64_abs(),
            Step::Call(function, _) => sink.call(self.calls.host[function.name()].0),
            Step::Powf(..) => sink.call(self.calls.host[POWER].0),
            Step::Table(table, order, _) => sink.call(self.calls.tables[&(table, order)]),
            Step::SelectLess(_) => unreachable!("selected above"),
        };
    }
}

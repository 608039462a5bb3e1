//! Translation of a piece of a program to a function of Cranelift.
//!
//! Excluded: the operations and their order, which the schedule determines.

use std::collections::HashMap;

use cranelift_codegen::cursor::{Cursor as _, FuncCursor};
use cranelift_codegen::ir::{
    self, AbiParam, Block, BlockArg, InstBuilder as _, MemFlags, SigRef, Signature, StackSlotData,
    StackSlotKind, Type, Value,
    condcodes::{FloatCC, IntCC},
    types,
};
use cranelift_codegen::isa::TargetIsa;

use super::schedule::{Batch, BatchKind, Item, Schedule};
use super::thunks::Thunk;
use crate::straight::{Middles, Region, Step, StepId, Straight};
use crate::{Function, Table};

/// Pointer parameters of a piece.
const POINTERS: [usize; Region::COUNT + 1] = [
    Region::Time as usize,
    Region::State as usize,
    Region::Parameters as usize,
    Region::Handed as usize,
    Region::Constants as usize,
    Region::Motion as usize,
    Region::Results as usize,
    ROOM,
];

/// Pointer parameters of a short program, behind time. In this order most arguments of the
/// contract's functions are in the same registers.
const OF_SHORT: [usize; 5] = [
    Region::Results as usize,
    Region::State as usize,
    Region::Handed as usize,
    Region::Parameters as usize,
    Region::Constants as usize,
];

/// Index of the workspace, behind the regions.
const ROOM: usize = Region::COUNT;

/// Number of vectors of sums that are formed together: two sums of each, and the factors read, stay
/// in registers.
const BLOCK: usize = 6;

/// Returns the signature of pieces, or of a short program.
fn signature(isa: &dyn TargetIsa, is_short: bool) -> Signature {
    let time = if is_short { 2 } else { 0 };
    let pointers = if is_short { OF_SHORT.len() } else { POINTERS.len() };
    let mut signature = Signature::new(isa.default_call_conv());
    signature.params.extend(vec![AbiParam::new(types::F64); time]);
    signature.params.extend(vec![AbiParam::new(isa.pointer_type()); pointers]);
    signature
}

/// Translates pieces of one program.
pub struct Translator<'a> {
    /// The program.
    pub straight: &'a Straight,
    /// Its schedule.
    pub schedule: &'a Schedule,
    /// Number of lanes, 1 or 2.
    pub lanes: usize,
    /// Tables of the model; they must outlive the code.
    pub tables: &'a [Table],
    /// True for a program of one piece that takes time by value, reads no motion and has its
    /// workspace on the stack.
    pub is_short: bool,
}

/// Arguments of a piece.
struct Arguments {
    /// Times of the lanes of a short program, as one value.
    time: Option<Value>,
    /// Pointers by region, and to the workspace.
    pointers: [Option<Value>; POINTERS.len()],
}

/// State of the translation of one piece.
struct Piece<'a, 'b> {
    of: &'a Translator<'a>,
    at: FuncCursor<'b>,
    isa: &'a dyn TargetIsa,
    /// Signatures of called functions.
    signatures: HashMap<Thunk, SigRef>,
    given: Arguments,
    pointer: Type,
    /// Values of this piece that are not in memory.
    values: HashMap<StepId, Value>,
    /// Values loaded from memory since the last call; behind a call they are loaded again.
    read: HashMap<StepId, Value>,
    lane: Type,
}

impl Translator<'_> {
    /// Writes the body of a piece.
    pub fn translate(&self, index: usize, function: &mut ir::Function, isa: &dyn TargetIsa) {
        function.signature = signature(isa, self.is_short);
        let pointer = isa.pointer_type();
        let mut at = FuncCursor::new(function);
        let block = at.func.dfg.make_block();
        at.func.layout.append_block(block);
        at.goto_bottom(block);
        let types: Vec<Type> =
            at.func.signature.params.iter().map(|given| given.value_type).collect();
        for given in types {
            at.func.dfg.append_block_param(block, given);
        }
        let given = self.given(block, &mut at, pointer);
        let lane = self.lane();
        let mut piece = Piece {
            of: self,
            at,
            isa,
            signatures: HashMap::new(),
            given,
            pointer,
            values: HashMap::new(),
            read: HashMap::new(),
            lane,
        };
        let mut writes: HashMap<StepId, Vec<u32>> = HashMap::new();
        for &(entry, id) in &self.straight.writes {
            writes.entry(id).or_default().push(entry);
        }
        if let (0, Some(middles)) = (index, self.straight.middles) {
            piece.form(middles);
        }
        for item in &self.schedule.pieces[index] {
            match item {
                Item::Step(id) => {
                    let value = piece.compute(*id);
                    piece.values.insert(*id, value);
                    if let Some(place) = self.schedule.places[id.0 as usize] {
                        piece.store(ROOM, place, value);
                    }
                    for &entry in writes.get(id).into_iter().flatten() {
                        piece.store(Region::Results as usize, entry, value);
                    }
                }
                Item::Batch(batch) => piece.batch(batch),
            }
        }
        if index + 1 == self.schedule.pieces.len() {
            // Results that are in memory already: leaves, and results of batches.
            for &(entry, id) in &self.straight.writes {
                if piece.is_in_memory(id) {
                    let value = piece.value(id);
                    piece.store(Region::Results as usize, entry, value);
                }
            }
        }
        piece.at.ins().return_(&[]);
    }

    fn lane(&self) -> Type {
        if self.lanes == 2 { types::F64X2 } else { types::F64 }
    }

    fn given(&self, block: Block, at: &mut FuncCursor<'_>, pointer: Type) -> Arguments {
        let all = at.func.dfg.block_params(block).to_vec();
        let mut given = Arguments { time: None, pointers: [None; POINTERS.len()] };
        let mut note = |regions: &[usize], values: &[Value]| {
            for (region, value) in regions.iter().zip(values) {
                given.pointers[*region] = Some(*value);
            }
        };
        if !self.is_short {
            note(&POINTERS, &all);
            return given;
        }
        let (time, rest) = all.split_at(2);
        note(&OF_SHORT, rest);
        given.time = Some(if self.lanes == 2 {
            let both = at.ins().splat(self.lane(), time[0]);
            at.ins().insertlane(both, time[1], 1)
        } else {
            time[0]
        });
        if self.schedule.room > 0 {
            let bytes = (8 * self.lanes * self.schedule.room) as u32;
            let slot = StackSlotData::new(StackSlotKind::ExplicitSlot, bytes, 4);
            let slot = at.func.create_sized_stack_slot(slot);
            given.pointers[ROOM] = Some(at.ins().stack_addr(pointer, slot, 0));
        }
        given
    }
}

impl Piece<'_, '_> {
    /// Appends a block and continues in it.
    fn append(&mut self, block: Block) {
        self.at.func.layout.append_block(block);
        self.at.goto_bottom(block);
    }

    fn is_in_memory(&self, id: StepId) -> bool {
        match self.of.straight.step(id) {
            step if step.is_leaf() => true,
            Step::Call(function, _) => {
                matches!(function, Function::Sin | Function::Cos | Function::Tanh)
            }
            _ => false,
        }
    }

    /// Forms sums of products row by row, for a block of vectors at a time.
    fn form(&mut self, middles: Middles) {
        let vectors = (middles.count * self.of.lanes).div_ceil(2);
        for first in (0..vectors).step_by(BLOCK) {
            self.form_block(middles, first, BLOCK.min(vectors - first));
        }
    }

    /// Forms a block of sums. In each lane two sums alternate, so that neither waits for its last
    /// addition.
    fn form_block(&mut self, middles: Middles, first: usize, count: usize) {
        let flags = MemFlags::new().with_notrap();
        let row = self.offset(middles.row as u32);
        let of_rows = Region::Parameters as usize;
        let [low, end] = [of_rows, Region::State as usize].map(|region| self.pointer_to(region));
        let low = self.at.ins().iadd_imm(low, i64::from(row));
        let high = self.at.ins().iadd_imm(end, -i64::from(row));
        let zeros = self.at.func.dfg.constants.insert(vec![0; 16].into());
        let zero = self.at.ins().vconst(types::F64X2, zeros);
        let [head, body, tail] = [(); 3].map(|()| self.at.func.dfg.make_block());
        for pointer in [self.pointer; 2] {
            self.at.func.dfg.append_block_param(head, pointer);
        }
        for _ in 0..2 * count {
            self.at.func.dfg.append_block_param(head, types::F64X2);
        }
        let begin: Vec<BlockArg> =
            [low, high].into_iter().chain(vec![zero; 2 * count]).map(BlockArg::from).collect();
        self.at.ins().jump(head, &begin);
        self.append(head);
        let known = self.at.func.dfg.block_params(head).to_vec();
        let (low, high, sums) = (known[0], known[1], &known[2..]);
        let goes_on = self.at.ins().icmp(IntCC::UnsignedLessThan, low, end);
        self.at.ins().brif(goes_on, body, &[], tail, &[]);
        self.append(body);
        let mut next = sums[count..].to_vec();
        for (vector, sum) in sums[..count].iter().enumerate() {
            let at = 16 * (first + vector) as i32;
            let [left, right] = [(low, middles.left), (high, middles.right)].map(|(row, entry)| {
                let offset = self.offset(entry as u32) + at;
                self.at.ins().load(types::F64X2, flags, row, offset)
            });
            let product = self.at.ins().fmul(left, right);
            next.push(self.at.ins().fadd(*sum, product));
        }
        let low = self.at.ins().iadd_imm(low, i64::from(row));
        let high = self.at.ins().iadd_imm(high, -i64::from(row));
        let next: Vec<BlockArg> = [low, high].into_iter().chain(next).map(BlockArg::from).collect();
        self.at.ins().jump(head, &next);
        self.append(tail);
        let results = self.pointer_to(Region::Results as usize);
        for vector in 0..count {
            let sum = self.at.ins().fadd(sums[vector], sums[count + vector]);
            let at = self.offset(middles.sums as u32) + 16 * (first + vector) as i32;
            self.at.ins().store(flags, sum, results, at);
        }
    }

    fn pointer_to(&self, region: usize) -> Value {
        self.given.pointers[region]
            .expect("a short program has no motion, and a room if it needs one")
    }

    fn offset(&self, entry: u32) -> i32 {
        (entry as usize * 8 * self.of.lanes) as i32
    }

    fn load(&mut self, pointer: usize, entry: u32) -> Value {
        let offset = self.offset(entry);
        let flags = MemFlags::new().with_notrap();
        let pointer = self.pointer_to(pointer);
        self.at.ins().load(self.lane, flags, pointer, offset)
    }

    fn store(&mut self, pointer: usize, entry: u32, value: Value) {
        let offset = self.offset(entry);
        let flags = MemFlags::new().with_notrap();
        let pointer = self.pointer_to(pointer);
        self.at.ins().store(flags, value, pointer, offset);
    }

    /// Returns the value of a step that was computed, in this or an earlier piece.
    fn value(&mut self, id: StepId) -> Value {
        if let Some(&value) = self.values.get(&id).or_else(|| self.read.get(&id)) {
            return value;
        }
        let value = match self.of.straight.step(id) {
            Step::Literal(literal) => return self.literal(literal),
            Step::Read(region, entry) => {
                let time = self.given.time.filter(|_| region == Region::Time);
                return time.unwrap_or_else(|| self.load(region as usize, entry));
            }
            _ => {
                let place = self.of.schedule.places[id.0 as usize];
                self.load(ROOM, place.expect("what is read later has a place"))
            }
        };
        self.read.insert(id, value);
        value
    }

    fn literal(&mut self, literal: f64) -> Value {
        if self.of.lanes == 1 && literal.to_bits() == 0 {
            return self.at.ins().f64const(literal);
        }
        let bytes: Vec<u8> = [literal.to_le_bytes(); 2].concat();
        let constant = self.at.func.dfg.constants.insert(bytes.into());
        let both = self.at.ins().vconst(types::F64X2, constant);
        // Loaded from memory: as a constant, a single number would pass through an integer
        // register.
        if self.of.lanes == 1 { self.at.ins().extractlane(both, 0) } else { both }
    }

    fn compute(&mut self, id: StepId) -> Value {
        let step = self.of.straight.step(id);
        let mut of = |id| self.value(id);
        match step {
            Step::Literal(_) | Step::Read(..) => of(id),
            Step::Neg(a) => {
                let a = of(a);
                self.at.ins().fneg(a)
            }
            Step::Add(a, b) => {
                let (a, b) = (of(a), of(b));
                self.at.ins().fadd(a, b)
            }
            Step::Sub(a, b) => {
                let (a, b) = (of(a), of(b));
                self.at.ins().fsub(a, b)
            }
            Step::Mul(a, b) => {
                let (a, b) = (of(a), of(b));
                self.at.ins().fmul(a, b)
            }
            Step::Div(a, b) => {
                let (a, b) = (of(a), of(b));
                self.at.ins().fdiv(a, b)
            }
            Step::Call(Function::Sqrt, a) => {
                let a = of(a);
                self.at.ins().sqrt(a)
            }
            Step::Call(Function::Abs, a) => {
                let a = of(a);
                self.at.ins().fabs(a)
            }
            Step::SelectLess(all) => {
                let all = all.map(of);
                self.select_less(all)
            }
            Step::Call(function, a) => {
                let a = of(a);
                self.each(Thunk::Function(function), &[], &[a])
            }
            Step::Powf(a, b) => {
                let (a, b) = (of(a), of(b));
                self.each(Thunk::Powf, &[], &[a, b])
            }
            Step::Table(table, order, a) => {
                let a = of(a);
                let address = &raw const self.of.tables[table.0 as usize];
                let table = self.at.ins().iconst(self.pointer, address as i64);
                let order = self.at.ins().iconst(types::I32, i64::from(order));
                self.each(Thunk::Table, &[table, order], &[a])
            }
        }
    }

    fn select_less(&mut self, [lhs, rhs, then, otherwise]: [Value; 4]) -> Value {
        let is_less = self.at.ins().fcmp(FloatCC::LessThan, lhs, rhs);
        if self.of.lanes == 1 {
            return self.at.ins().select(is_less, then, otherwise);
        }
        let as_vector = MemFlags::new().with_endianness(cranelift_codegen::ir::Endianness::Little);
        let mask = self.at.ins().bitcast(self.lane, as_vector, is_less);
        self.at.ins().bitselect(mask, then, otherwise)
    }

    /// Calls a function lane by lane.
    fn each(&mut self, thunk: Thunk, before: &[Value], arguments: &[Value]) -> Value {
        let lanes = 0..self.of.lanes;
        let results: Vec<Value> = lanes
            .map(|lane| {
                let mut all = before.to_vec();
                all.extend(arguments.iter().map(|argument| self.lane_of(*argument, lane)));
                self.call(thunk, &all)[0]
            })
            .collect();
        match results[..] {
            [low, high] => {
                let both = self.at.ins().splat(self.lane, low);
                self.at.ins().insertlane(both, high, 1)
            }
            _ => results[0],
        }
    }

    fn lane_of(&mut self, value: Value, lane: usize) -> Value {
        if self.of.lanes == 1 { value } else { self.at.ins().extractlane(value, lane as u8) }
    }

    fn call(&mut self, thunk: Thunk, arguments: &[Value]) -> Vec<Value> {
        let signature = self.signature_of(thunk);
        let address = thunk.address() as i64;
        let callee = self.at.ins().iconst(self.pointer, address);
        let call = self.at.ins().call_indirect(signature, callee, arguments);
        self.read.clear();
        self.at.func.dfg.inst_results(call).to_vec()
    }

    fn signature_of(&mut self, thunk: Thunk) -> SigRef {
        *self.signatures.entry(thunk).or_insert_with(|| {
            let mut signature = Signature::new(self.isa.default_call_conv());
            let (parameters, result) = thunk.signature(self.pointer);
            signature.params.extend(parameters.into_iter().map(AbiParam::new));
            signature.returns.extend(result.then(|| AbiParam::new(types::F64)));
            self.at.func.import_signature(signature)
        })
    }

    fn batch(&mut self, batch: &Batch) {
        let arguments: Vec<Value> = batch.arguments.iter().map(|id| self.value(*id)).collect();
        let mut all: Vec<Value> = Vec::with_capacity(5);
        for argument in arguments {
            all.extend((0..self.of.lanes).map(|lane| self.lane_of(argument, lane)));
        }
        let place = self.offset(batch.place);
        let room = self.pointer_to(ROOM);
        let out = self.at.ins().iadd_imm(room, i64::from(place));
        let is_alone = all.len() == 1;
        while !is_alone && all.len() < 4 {
            all.extend(all.last().copied());
        }
        let thunk = match batch.kind {
            BatchKind::SinCos if is_alone => Thunk::SinCos,
            BatchKind::SinCos => Thunk::SinCosOfFour,
            BatchKind::Tanh if is_alone => Thunk::Function(Function::Tanh),
            BatchKind::Tanh => Thunk::TanhOfFour,
        };
        if let Thunk::Function(_) = thunk {
            let value = self.call(thunk, &all)[0];
            self.store(ROOM, batch.place, value);
        } else {
            all.push(out);
            self.call(thunk, &all);
        }
    }
}

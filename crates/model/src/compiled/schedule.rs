//! Order and pieces in which a program runs.
//!
//! A called function may change every register, so values that are alive across a call must be
//! stored and loaded again. Calls that are independent of each other are therefore grouped, as
//! early as possible, with only the computation of their arguments before them. Sines and
//! hyperbolic tangents of up to four numbers are one call. Every operation keeps its operands.

use crate::Function;
use crate::straight::{Step, StepId, Straight};

/// Maximum number of steps of a piece: the cost of register allocation grows faster than the
/// length.
const LONGEST: usize = 1500;

/// A unit of work of a piece.
#[derive(Debug, Clone, PartialEq)]
pub enum Item {
    /// One step.
    Step(StepId),
    /// A function of several numbers.
    Batch(Batch),
}

/// A function of up to four numbers, computed in one call.
#[derive(Debug, Clone, PartialEq)]
pub struct Batch {
    /// The function.
    pub kind: BatchKind,
    /// Its arguments.
    pub arguments: Vec<StepId>,
    /// First place of its results in the workspace.
    pub place: u32,
}

/// Functions that are computed for several numbers in one call.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum BatchKind {
    /// Sines, then cosines.
    SinCos,
    /// Hyperbolic tangents.
    Tanh,
}

/// Place of each step's value in the workspace, if it has one.
pub type Places = Vec<Option<u32>>;

/// An ordered program.
#[derive(Debug, Clone)]
pub struct Schedule {
    /// Pieces, run in order.
    pub pieces: Vec<Vec<Item>>,
    /// Places in the workspace: results of batches, and values that a later piece reads.
    pub places: Places,
    /// Number of places.
    pub room: usize,
}

impl Schedule {
    /// Orders a program for numbers of `lanes` lanes.
    pub fn new(straight: &Straight, lanes: usize) -> Self {
        let mut schedule =
            Self { pieces: vec![], places: vec![None; straight.steps.len()], room: 0 };
        let items = schedule.ordered(straight, 4 / lanes);
        schedule.pieces = cut(items);
        schedule.keep_what_pieces_share(straight);
        schedule
    }

    fn take_room(&mut self, places: usize) -> u32 {
        let place = self.room as u32;
        self.room += places;
        place
    }

    /// Orders the steps by stage: first those that the calls of a stage need, then the calls.
    fn ordered(&mut self, straight: &Straight, width: usize) -> Vec<Item> {
        let stages = stages(straight);
        let last = stages.iter().filter(|stage| **stage != u32::MAX).max().copied();
        let mut by_stage: Vec<Vec<StepId>> = vec![vec![]; last.map_or(0, |last| last as usize + 1)];
        let mut rest = Vec::new();
        for (index, &stage) in stages.iter().enumerate() {
            let id = StepId(index as u32);
            if straight.step(id).is_leaf() {
                continue;
            }
            match by_stage.get_mut(stage as usize) {
                Some(of_stage) => of_stage.push(id),
                None => rest.push(id),
            }
        }
        let mut items = Vec::new();
        for of_stage in by_stage {
            let (calls, steps): (Vec<_>, Vec<_>) =
                of_stage.into_iter().partition(|id| straight.step(*id).is_call());
            items.extend(steps.into_iter().map(Item::Step));
            self.batch(straight, &calls, width, &mut items);
        }
        items.extend(rest.into_iter().map(Item::Step));
        items
    }

    /// Adds the calls of one stage.
    fn batch(
        &mut self,
        straight: &Straight,
        calls: &[StepId],
        width: usize,
        items: &mut Vec<Item>,
    ) {
        let (mut angles, mut tangents): (Vec<StepId>, Vec<StepId>) = (vec![], vec![]);
        let mut seen = std::collections::HashMap::new();
        for &id in calls {
            match straight.step(id) {
                Step::Call(Function::Sin | Function::Cos, x) => {
                    seen.entry(x).or_insert_with(|| {
                        angles.push(x);
                        angles.len() - 1
                    });
                }
                Step::Call(Function::Tanh, x) => tangents.push(x),
                _ => items.push(Item::Step(id)),
            }
        }
        let mut bases = [vec![], vec![]];
        let kinds = [(BatchKind::SinCos, &angles, 2 * width), (BatchKind::Tanh, &tangents, width)];
        for (bases, (kind, arguments, room)) in bases.iter_mut().zip(kinds) {
            for arguments in arguments.chunks(width) {
                let place = self.take_room(room);
                bases.push(place);
                items.push(Item::Batch(Batch { kind, arguments: arguments.to_vec(), place }));
            }
        }
        let mut tangent = 0;
        for &id in calls {
            let place = match straight.step(id) {
                Step::Call(function @ (Function::Sin | Function::Cos), x) => {
                    let at = seen[&x];
                    let half = if function == Function::Sin { 0 } else { width };
                    bases[0][at / width] as usize + half + at % width
                }
                Step::Call(Function::Tanh, _) => {
                    tangent += 1;
                    bases[1][(tangent - 1) / width] as usize + (tangent - 1) % width
                }
                _ => continue,
            };
            self.places[id.0 as usize] = Some(place as u32);
        }
    }

    /// Assigns a place to every step that a later piece reads.
    fn keep_what_pieces_share(&mut self, straight: &Straight) {
        if self.pieces.len() < 2 {
            return;
        }
        let mut home = vec![usize::MAX; straight.steps.len()];
        for (index, piece) in self.pieces.iter().enumerate() {
            for item in piece {
                if let Item::Step(id) = item {
                    home[id.0 as usize] = index;
                }
            }
        }
        let mut shared = Vec::new();
        for (index, piece) in self.pieces.iter().enumerate() {
            for item in piece {
                let read: Vec<StepId> = match item {
                    Item::Step(id) => straight.step(*id).operands().collect(),
                    Item::Batch(batch) => batch.arguments.clone(),
                };
                shared
                    .extend(read.into_iter().filter(|id| {
                        home[id.0 as usize] != index && !straight.step(*id).is_leaf()
                    }));
            }
        }
        for id in shared {
            if self.places[id.0 as usize].is_none() {
                self.places[id.0 as usize] = Some(self.take_room(1));
            }
        }
    }
}

/// Returns the stage of every step. Calls of a stage need calls of earlier stages only. Any other
/// step belongs to the first stage whose calls need it, and to none if only results need it.
fn stages(straight: &Straight) -> Vec<u32> {
    let count = straight.steps.len();
    let mut level = vec![0; count];
    for (index, step) in straight.steps.iter().enumerate() {
        let after = |id: StepId| level[id.0 as usize] + u32::from(straight.step(id).is_call());
        level[index] = step.operands().map(after).max().unwrap_or(0);
    }
    let mut stage = vec![u32::MAX; count];
    for index in (0..count).rev() {
        let step = &straight.steps[index];
        if step.is_call() {
            stage[index] = level[index];
        }
        for id in step.operands().filter(|id| !straight.step(*id).is_call()) {
            stage[id.0 as usize] = stage[id.0 as usize].min(stage[index]);
        }
    }
    stage
}

/// Splits the items into pieces of about the same length.
fn cut(items: Vec<Item>) -> Vec<Vec<Item>> {
    let pieces = items.len().div_ceil(LONGEST).max(1);
    let length = items.len().div_ceil(pieces).max(1);
    let mut cut: Vec<Vec<Item>> = vec![];
    for item in items {
        match cut.last_mut() {
            Some(piece) if piece.len() < length => piece.push(item),
            _ => cut.push(vec![item]),
        }
    }
    if cut.is_empty() { vec![vec![]] } else { cut }
}

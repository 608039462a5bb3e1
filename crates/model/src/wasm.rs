//! Models as WebAssembly, for web pages and other hosts where nothing can be compiled.
//!
//! ```text
//! Tape -> Straight -> function bodies -> module
//! ```
//!
//! Every operation keeps its operands from the tape. Results are therefore those of
//! [`Evaluator`](crate::evaluate::Evaluator) to the last bit, provided that the host's functions
//! are the same: sines, exponentials and the like are imported from the host. A module has one
//! memory, in which arguments and results have their [places](Layout), and a function
//! `(time: f64) -> ()` for each requested function of the model, under its name. The function
//! `prepare` computes the values that depend on parameters only; call it after each change of them.
//!
//! Excluded: fields, methods, hosts.

mod body;
mod solve;
mod table;

use std::collections::BTreeMap;

use serde::Serialize;
use wasm_encoder::{
    CodeSection, ConstExpr, DataSection, EntityType, ExportKind, ExportSection, FunctionSection,
    ImportSection, MemorySection, MemoryType, Module, TypeSection, ValType,
};

use crate::functions::FunctionId;
use crate::hoist::Hoisted;
use crate::straight::{Region, Step, Straight};
use crate::{Model, Table, TableId};

/// Name of the module from which host functions are imported.
pub const HOST: &str = "math";
/// Name of `x^y` among them; the others have the names of [`Function`](crate::Function).
pub const POWER: &str = "powf";

/// A model's functions as a module.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct WasmModule {
    /// The module.
    pub bytes: Vec<u8>,
    /// Places of its numbers.
    pub layout: Layout,
}

/// Places in the memory of a module, in bytes from its start; each number has eight bytes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
pub struct Layout {
    /// State, to be written before a call.
    pub state: usize,
    /// Parameters, to be written before a call.
    pub parameters: usize,
    /// Slots of relations, live until they are written; see
    /// [`RelationKind`](machinist_contract::RelationKind).
    pub slots: usize,
    /// Results of the last call.
    pub results: usize,
}

/// Reason why a model has no module.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
pub enum NotInWasm {
    /// The model has fields, whose values the engine computes.
    #[error("it has fields along a shaft")]
    Fields,
    /// A function is longer than hosts accept.
    #[error("its equations are too long: {steps} operations in `{function}`")]
    TooLong {
        /// Name of the function.
        function: &'static str,
        /// Number of its operations, at most [`LONGEST`] are allowed.
        steps: usize,
    },
    /// A tape refers to a table or node that does not exist.
    #[error("the model is malformed")]
    Malformed,
}

/// Maximum number of operations of a function: hosts refuse bodies of more than some megabytes.
pub const LONGEST: usize = 300_000;

/// Types of functions, by their index.
#[derive(Clone, Copy)]
enum Type {
    /// One number to one number.
    OfOne,
    /// Two numbers to one number.
    OfTwo,
    /// Time to no result.
    Program,
}

/// A function of the module before it is encoded.
struct Program {
    name: &'static str,
    straight: Straight,
    /// Place of its results.
    into: usize,
    /// True if the motion is computed before it.
    reads_motion: bool,
}

/// Returns a module of some functions of a model, without those that the model does not have.
///
/// # Errors
/// [`NotInWasm`] gives the reason.
pub fn module(model: &Model, wanted: &[FunctionId]) -> Result<WasmModule, NotInWasm> {
    if !model.fields.is_empty() || !model.handed.is_empty() {
        return Err(NotInWasm::Fields);
    }
    let hoisted = Hoisted::new(model);
    let places = Places::of(model, &hoisted, wanted);
    let programs = programs(model, &hoisted, wanted, &places)?;
    let imports = imports(&programs);
    let tables = table::used(programs.iter().map(|program| &program.straight));
    let first_table = imports.len() as u32;
    let first_program = first_table + tables.len() as u32;
    let calls = body::Calls {
        host: &imports,
        tables: tables.iter().zip(first_table..).map(|(key, index)| (*key, index)).collect(),
    };
    let is_motion = |program: &Program| program.name == MOTION;
    let motion = programs.iter().zip(first_program..).find(|(program, _)| is_motion(program));
    let motion = motion.map(|(_, index)| index);

    let mut functions = FunctionSection::new();
    let mut exports = ExportSection::new();
    let mut code = CodeSection::new();
    for &(table, order) in &tables {
        functions.function(Type::OfOne as u32);
        let Some(of) = model.tables.get(table.0 as usize) else { return Err(NotInWasm::Malformed) };
        code.function(&table::body(of, order, places.tables[table.0 as usize]));
    }
    for (program, index) in programs.iter().zip(first_program..) {
        functions.function(Type::Program as u32);
        let before = motion.filter(|_| program.reads_motion);
        code.function(&body::body(&program.straight, &places, program.into, &calls, before));
        exports.export(program.name, ExportKind::Func, index);
    }
    exports.export("memory", ExportKind::Memory, 0);
    let mut module = Module::new();
    module
        .section(&types())
        .section(&import_section(&imports))
        .section(&functions)
        .section(&memory(places.end))
        .section(&exports)
        .section(&code)
        .section(&data(model, &places));
    let layout = Layout {
        state: places.regions[Region::State as usize],
        parameters: places.regions[Region::Parameters as usize],
        slots: places.slots(model),
        results: places.regions[Region::Results as usize],
    };
    Ok(WasmModule { bytes: module.finish(), layout })
}

const MOTION: &str = "motion";
const PREPARE: &str = "prepare";

/// Returns the programs that others depend on, then each wanted function.
fn programs(
    model: &Model,
    hoisted: &Hoisted,
    wanted: &[FunctionId],
    places: &Places,
) -> Result<Vec<Program>, NotInWasm> {
    let of_tape = |tape| Straight::of_tape(tape, model.tables.len()).ok_or(NotInWasm::Malformed);
    let at = |region: Region| places.regions[region as usize];
    let mut programs = vec![Program {
        name: PREPARE,
        straight: of_tape(&hoisted.constants)?,
        into: at(Region::Constants),
        reads_motion: false,
    }];
    if model.motion.is_some() {
        programs.push(Program {
            name: MOTION,
            straight: of_tape(&hoisted.motion)?,
            into: at(Region::Motion),
            reads_motion: false,
        });
    }
    for row in model.functions().filter(|row| wanted.contains(&row.id)) {
        let straight = of_tape(hoisted.tape(model, row.id))?;
        let straight = match (model.solve(row.id), &model.motion) {
            (Some(solve), Some(motion)) => solve::solved(&straight, solve, &motion.factors),
            _ => Some(straight),
        };
        programs.push(Program {
            name: row.name,
            straight: straight.ok_or(NotInWasm::Malformed)?,
            into: at(Region::Results),
            reads_motion: model.reads_motion(row.id),
        });
    }
    let steps = |program: &Program| program.straight.steps.len();
    match programs.iter().find(|program| steps(program) > LONGEST) {
        None => Ok(programs),
        Some(long) => Err(NotInWasm::TooLong { function: long.name, steps: steps(long) }),
    }
}

/// Places of numbers in the memory, in bytes.
struct Places {
    /// Regions; time is an argument instead.
    regions: [usize; Region::COUNT],
    /// Tables: knots, then coefficients of each.
    tables: Vec<usize>,
    end: usize,
}

impl Places {
    fn of(model: &Model, hoisted: &Hoisted, wanted: &[FunctionId]) -> Self {
        let results = model.functions().filter(|row| wanted.contains(&row.id));
        let results = results.map(|row| (row.results)(model)).max().unwrap_or(0);
        let mut end = 0;
        let mut take = |numbers: usize| {
            let place = end;
            end += 8 * numbers;
            place
        };
        let mut regions = [0; Region::COUNT];
        for (region, numbers) in [
            (Region::State, model.states.len()),
            (Region::Parameters, model.slots().end),
            (Region::Constants, hoisted.constants.results.len()),
            (Region::Motion, hoisted.motion.results.len()),
            (Region::Results, results),
        ] {
            regions[region as usize] = take(numbers);
        }
        let numbers = |table: &Table| table.knots.len() + 4 * table.coefficients.len();
        let tables = model.tables.iter().map(|table| take(numbers(table))).collect();
        Self { regions, tables, end }
    }

    fn slots(&self, model: &Model) -> usize {
        self.regions[Region::Parameters as usize] + 8 * model.slots().start
    }
}

/// Functions of the host that programs call, each with its index and type.
type Imports = BTreeMap<&'static str, (u32, Type)>;

fn imports(programs: &[Program]) -> Imports {
    let mut imports = Imports::new();
    for step in programs.iter().flat_map(|program| &program.straight.steps) {
        match step {
            Step::Call(function, _) if step.is_call() => {
                imports.insert(function.name(), (0, Type::OfOne));
            }
            Step::Powf(..) => {
                imports.insert(POWER, (0, Type::OfTwo));
            }
            _ => {}
        }
    }
    for (index, import) in imports.values_mut().enumerate() {
        import.0 = index as u32;
    }
    imports
}

fn types() -> TypeSection {
    let mut types = TypeSection::new();
    // In the order of `Type`.
    types.ty().function([ValType::F64], [ValType::F64]);
    types.ty().function([ValType::F64; 2], [ValType::F64]);
    types.ty().function([ValType::F64], []);
    types
}

fn import_section(imports: &Imports) -> ImportSection {
    let mut section = ImportSection::new();
    let mut all: Vec<_> = imports.iter().collect();
    all.sort_by_key(|(_, (index, _))| *index);
    for (name, (_, kind)) in all {
        section.import(HOST, name, EntityType::Function(*kind as u32));
    }
    section
}

fn memory(bytes: usize) -> MemorySection {
    const PAGE: usize = 65_536;
    let mut section = MemorySection::new();
    section.memory(MemoryType {
        minimum: bytes.div_ceil(PAGE) as u64,
        maximum: None,
        memory64: false,
        shared: false,
        page_size_log2: None,
    });
    section
}

/// Returns the tables, and slots that leave relations live.
fn data(model: &Model, places: &Places) -> DataSection {
    let mut section = DataSection::new();
    let mut put = |place: usize, numbers: &mut dyn Iterator<Item = f64>| {
        let bytes: Vec<u8> = numbers.flat_map(f64::to_le_bytes).collect();
        section.active(0, &ConstExpr::i32_const(place as i32), bytes);
    };
    for (table, place) in model.tables.iter().zip(&places.tables) {
        let numbers = table.knots.iter().chain(table.coefficients.iter().flatten());
        put(*place, &mut numbers.copied());
    }
    if !model.relations.is_empty() {
        put(places.slots(model), &mut model.relations.iter().map(|relation| relation.kind.live()));
    }
    section
}

/// A table and the order of its derivative.
type TableKey = (TableId, u32);

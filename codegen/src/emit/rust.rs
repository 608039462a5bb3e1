//! A scene as one module of readable Rust.
//!
//! The module has no inner attributes, so that it works as a file of its own
//! and through `include!`; its header is made of plain comments. It needs `core`
//! and the contract crate, allocates nothing, and computes with any
//! `machinist_contract::Real`.

mod batch;
mod body;
mod describe;
mod excitation;
mod field;
mod functions;
mod fuse;
mod header;
mod items;
mod motion;
mod names;
mod plan;
mod points;
mod prepare;
mod series;

use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};

use crate::emit::{EmitError, EmitOptions};
use body::Scope;
pub(crate) use header::MARK;
use machinist_model::Model;
use motion::Motion;
use names::Namer;
use prepare::Prepare;
use series::Series;

/// The text of a scene's module: constants, `Parameters`, `Outputs`, one
/// function for each tape, and a unit struct that implements `Describe` and
/// `Simulator`.
///
/// # Errors
/// [`EmitError`] if the model holds a number without a literal, a name that is
/// no identifier, or a tape that breaks the rules of [`machinist_model::`].
pub fn emit(model: &Model, options: &EmitOptions) -> Result<String, EmitError> {
    model.validate()?;
    let scene = Scene::new(model)?;
    // What fields do is not in the machine's own series.
    let series = if model.fields.is_empty() { Series::new(&scene) } else { None };
    let imports = imports(model, series.as_ref());
    let constants = items::constants(&scene);
    let machine = items::machine(&scene);
    let parameters = items::parameters(&scene)?;
    let outputs = items::outputs(&scene);
    let state_indices = items::state_indices(&scene);
    let prepare = scene.prepare.items();
    let motion = &scene.motion.items;
    let functions = functions::functions(&scene)?;
    let excitation = excitation::items(&scene)?;
    let implementations = describe::implementations(&scene, series.is_some())?;
    let series = series.map(|series| series.items(&scene)).transpose()?;
    let fields = field::items(&scene)?;
    let tables = items::tables(&scene)?;
    let tokens = quote! {
        #imports
        #constants
        #machine
        #parameters
        #outputs
        #state_indices
        #prepare
        #motion
        #functions
        #series
        #excitation
        #implementations
        #fields
        #tables
    };
    let module = pretty(tokens)?;
    Ok(format!("{}\n{module}", header::header(model, options)))
}

/// Features of a crate of scenes that are no scenes, and so no names for scenes.
pub(crate) const TAKEN: [&str; 5] = ["default", "std", "libm", "bench", "scenes"];

/// The type that stands for a scene in its emitted module: `SawGin` for `saw_gin`.
#[must_use]
pub fn type_name(scene: &str) -> String {
    names::type_name(scene)
}

/// The module that lists emitted scenes: one `pub mod` for each, their names,
/// and a look-up; each only if the Cargo feature of its name is on.
///
/// # Errors
/// [`EmitError`] if a scene's name is no identifier, given twice, or taken by another
/// feature of the crate of scenes.
pub fn emit_index(models: &[&Model], options: &EmitOptions) -> Result<String, EmitError> {
    let mut models = models.to_vec();
    models.sort_by(|a, b| a.name.cmp(&b.name));
    let names: Vec<&str> = models.iter().map(|model| model.name.as_str()).collect();
    let modules = names::distinct(names.iter().copied(), "scenes")?;
    if let Some(name) = names.iter().find(|name| TAKEN.contains(name)) {
        let name = (*name).to_owned();
        return Err(EmitError::NamedTwice { name, kind: "features of the crate of scenes" });
    }
    let tokens = items::index(&models, &modules, options);
    Ok(format!("{}\n{}", header::index_header(options), pretty(tokens)?))
}

/// Formats a whole file.
fn pretty(tokens: TokenStream) -> Result<String, EmitError> {
    let file =
        syn::parse2(tokens).map_err(|error| EmitError::Unparsable { reason: error.to_string() })?;
    Ok(pack(&space_items(&prettyplease::unparse(&file))))
}

/// Puts lists of numbers, and of places in an array, several into a line, where the printer
/// puts each into one of its own.
fn pack(text: &str) -> String {
    const WIDTH: usize = 100;
    let is_number = |word: &str| word.bytes().all(|b| b.is_ascii_digit());
    let is_place = |item: &str| {
        let mut words = item.split([',', ' ', '(', ')', '[', ']']);
        words.all(|word| word == "x" || is_number(word))
    };
    let is_packed = |line: &str| {
        let item = line.trim_start();
        let is_short = item.len() < WIDTH / 4 && item.starts_with(|c: char| c != ']' && c != ')');
        is_short && item.strip_suffix(',').is_some_and(is_place)
    };
    let mut packed = String::with_capacity(text.len());
    // Length of the line that is open for more, if one is.
    let mut open = None;
    for line in text.lines() {
        let item = line.trim_start();
        let length = match open {
            Some(length) if is_packed(line) && length + 1 + item.len() <= WIDTH => {
                packed.pop();
                packed.push(' ');
                packed.push_str(item);
                length + 1 + item.len()
            }
            _ => {
                packed.push_str(line);
                line.len()
            }
        };
        packed.push('\n');
        open = is_packed(line).then_some(length);
    }
    packed
}

/// Puts an empty line between items, where the printer puts none.
fn space_items(text: &str) -> String {
    let mut spaced = String::with_capacity(text.len() + text.len() / 16);
    let mut previous = "";
    for line in text.lines() {
        let ends_item = matches!(previous.bytes().last(), Some(b'}' | b';'))
            && !previous.starts_with([' ', '/']);
        if ends_item && !line.is_empty() && !line.starts_with([' ', '}']) {
            spaced.push('\n');
        }
        spaced.push_str(line);
        spaced.push('\n');
        previous = line;
    }
    spaced
}

/// A model with the names of its emitted module.
struct Scene<'a> {
    model: &'a Model,
    machine: Ident,
    states: Vec<Ident>,
    parameters: Vec<Ident>,
    outputs: Vec<Ident>,
    tables: Vec<Ident>,
    /// Namer for local variables; states, parameters and constants are taken.
    locals: Namer,
    /// What is done once a run.
    prepare: Prepare,
    /// What several functions read.
    motion: Motion,
}

impl<'a> Scene<'a> {
    fn new(model: &'a Model) -> Result<Self, EmitError> {
        names::identifier(&model.name)?;
        let machine = format_ident!("{}", names::type_name(&model.name));
        let states = model
            .states
            .iter()
            .map(|state| &state.quantity)
            .map(|quantity| quantity.name.ident.as_str());
        let states = names::distinct(states, "states")?;
        let parameters = model.all_parameters().map(|p| p.quantity.name.ident.as_str());
        let parameters = names::distinct(parameters, "parameters")?;
        let outputs = model.wanted.iter().map(|output| output.name.ident.as_str());
        let outputs = names::distinct(outputs, "outputs")?;
        let tables = model.tables.iter().map(|table| table.name.ident.as_str());
        let tables = names::distinct(tables, "tables")?;

        let mut constants = Namer::for_constants();
        constants.reserve(&machine.to_string());
        let tables = tables.iter().map(|table| {
            constants.claim(&format!("{}_TABLE", names::constant_name(&table.to_string())))
        });
        let tables: Vec<Ident> = tables.collect();

        let mut locals = Namer::for_locals();
        locals.reserve(&machine.to_string());
        for constant in &tables {
            locals.reserve(&constant.to_string());
        }
        if model.motion.is_some() {
            for name in motion::LOCALS {
                locals.reserve(name);
            }
        }
        let states: Vec<Ident> =
            states.iter().map(|state| locals.claim(&state.to_string())).collect();
        for parameter in &parameters {
            locals.reserve(&parameter.to_string());
        }
        let prepare = Prepare::new(model, &states, &parameters, &tables, &locals)?;
        let (own, handed) = parameters.split_at(model.parameters.len());
        let scope = Scope {
            states: &states,
            parameters: own,
            handed,
            constants: &prepare.constants,
            motion: &[],
            tables: &tables,
            is_in_loop: false,
            namer: &locals,
        };
        let motion = Motion::new(model, &prepare.hoisted, &scope)?;
        Ok(Self { model, machine, states, parameters, outputs, tables, locals, prepare, motion })
    }
}

impl Scene<'_> {
    /// Fields of `Parameters` that are the machine's.
    fn own_parameters(&self) -> &[Ident] {
        &self.parameters[..self.model.parameters.len()]
    }

    /// Fields of `Parameters` that its fields set.
    fn handed(&self) -> &[Ident] {
        &self.parameters[self.model.parameters.len()..]
    }
}

/// `use` of exactly what the module needs.
fn imports(model: &Model, series: Option<&Series>) -> TokenStream {
    let series = series.map(Series::imports);
    let solves = [&model.rate_jacobian, &model.parameter_jacobian];
    let implicit = solves.iter().any(|matrix| matrix.solve.is_some());
    let implicit = implicit.then(|| quote!(implicit::{Step, substitute},));
    let linear = model.excitation.is_some().then(|| quote!(linear::LinearEquations,));
    let fields = (!model.fields.is_empty()).then(field::imports);
    let events = (!model.events.is_empty()).then(|| quote!(Direction, Event,));
    let constraint = (!model.constraints.is_empty()).then(|| quote!(Constraint,));
    let table = (!model.tables.is_empty()).then(|| quote!(CubicTable,));
    let kinds = (!model.is_whole()).then(|| quote!(StateKind,));
    quote! {
        use ::machinist_contract::{
            #constraint #table Describe, #events Energy, PowerBalance, Quantity, Real, RunDefaults, Shape, Simulator,
            SparsityPattern, #kinds #implicit #linear #series #fields
        };
    }
}

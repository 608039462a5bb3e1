//! Emission of a scene as one module of readable Rust.
//!
//! The module has no inner attributes, so it works as a file of its own and with `include!`; its
//! header consists of plain comments. It needs `core` and the contract crate, allocates nothing,
//! and computes with any `machinist_contract::Real`.

pub(in crate::emit) mod batch;
mod body;
mod describe;
mod estimator;
mod excitation;
mod field;
mod functions;
mod fuse;
mod header;
mod items;
mod layout;
mod motion;
mod names;
mod operation;
pub(super) mod plan;
mod points;
mod prepare;
mod series;

use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};

use crate::emit::{EmitError, EmitOptions};
use body::Scope;
pub use estimator::emit_estimator;
pub(crate) use header::MARK;
use machinist_model::Model;
use motion::Motion;
use names::Namer;
use prepare::Prepare;
use series::Series;

/// Emits the text of a scene's module: rows of the contract's macros, and one function for each
/// tape. The macros define `Parameters`, `Outputs`, constants, and a unit struct that implements
/// `Describe` and `Simulator`.
///
/// # Errors
/// [`EmitError`] if the model contains a number without a literal, a name that is not an
/// identifier, or a tape that breaks the rules of [`machinist_model::Model`].
pub fn emit(model: &Model, options: &EmitOptions) -> Result<String, EmitError> {
    model.validate()?;
    let scene = Scene::new(model)?;
    // The machine's own series does not include the dynamics of fields.
    let series = if model.fields.is_empty() { Series::new(&scene) } else { None };
    let imports = pretty(imports(model, series.as_ref()))?;
    let description = describe::description(&scene, series.as_ref())?;
    let prepare = scene.prepare.items();
    let motion = &scene.motion.items;
    let functions = functions::functions(&scene)?;
    let excitation = excitation::items(&scene)?;
    let series = series.map(|series| series.items(&scene)).transpose()?;
    let fields = field::items(&scene)?;
    let tables = items::tables(&scene)?;
    let items = pretty(quote!(#prepare #motion #functions #series #excitation #fields #tables))?;
    let of_fields = field::description(&scene)?;
    let header = header::header(model, options);
    let parts = [header, imports, description, of_fields, items];
    let text = parts.into_iter().filter(|part| !part.is_empty()).collect::<Vec<_>>().join("\n");
    match syn::parse_file(&text) {
        Ok(_) => Ok(text),
        Err(error) => Err(EmitError::Unparsable { reason: error.to_string() }),
    }
}

/// Features of a crate of scenes that are not scenes, and the folder for benchmarks: scenes cannot have their names.
pub(crate) const TAKEN: [&str; 5] = ["default", "std", "libm", "bench", "scenes"];

/// Returns the type of a scene in its emitted module: `SawGin` for `saw_gin`.
#[must_use]
pub fn type_name(scene: &str) -> String {
    names::type_name(scene)
}

/// Emits the module that lists emitted scenes: one `pub mod` for each, their names, and a lookup.
/// Each depends on the Cargo feature of its name.
///
/// # Errors
/// [`EmitError`] if a scene's name is not an identifier, occurs twice, or is that of another
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
    Ok(layout::lay_out(&prettyplease::unparse(&file)))
}

/// A model with the names in its emitted module.
struct Scene<'a> {
    model: &'a Model,
    machine: Ident,
    states: Vec<Ident>,
    parameters: Vec<Ident>,
    outputs: Vec<Ident>,
    tables: Vec<Ident>,
    /// Namer for local variables; names of states, parameters and constants are taken.
    locals: Namer,
    /// Computations that are done once a run.
    prepare: Prepare,
    /// Results that several functions share.
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
        let mut parameters = names::distinct(parameters, "parameters")?;
        let mut fields = Namer::empty();
        for name in &parameters {
            fields.reserve(&name.to_string());
        }
        let slots = (1..=model.relations.len()).map(|number| format!("held_{number}"));
        parameters.extend(slots.map(|name| fields.claim(&name)));
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
        let scope = Scope {
            states: &states,
            parameters: &parameters,
            own: model.parameters.len(),
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
    /// Reports whether one function computes dy'/dy and dy'/dp from constants.
    fn gives_jacobians_at_once(&self) -> bool {
        !self.prepare.is_empty() && self.model.gives_jacobians_at_once()
    }

    /// Returns the names that bodies of free functions may use.
    fn scope<'a>(&'a self, constants: &'a [Ident]) -> Scope<'a> {
        Scope {
            states: &self.states,
            parameters: &self.parameters,
            own: self.model.parameters.len(),
            constants,
            motion: &self.motion.results,
            tables: &self.tables,
            is_in_loop: false,
            namer: &self.locals,
        }
    }
}

/// Returns `use` items for exactly what the module needs.
fn imports(model: &Model, series: Option<&Series>) -> TokenStream {
    let series = series.map(Series::imports);
    let solves = [&model.rate_jacobian, &model.parameter_jacobian];
    let implicit = solves.iter().any(|matrix| matrix.solve.is_some());
    let implicit = implicit.then(|| quote!(implicit::{Step, substitute},));
    let field = (!model.fields.is_empty()).then(|| quote!(field::FieldPoint,));
    let table = (!model.tables.is_empty()).then(|| quote!(CubicTable,));
    quote!(use ::machinist_contract::{#table Energy, PowerBalance, Real, #implicit #series #field};)
}

//! Emission of a scene as C99: one header, one source, a CMake file and an example.
//!
//! No heap, no mutable globals, no recursion, no input or output. The functions compute the same
//! operations in the same order as the emitted Rust, so both are bitwise equal if products are
//! not fused.

mod body;
mod cost;
mod description;
mod estimator;
mod events;
mod expression;
mod functions;
mod helpers;
mod implicit;
mod layout;
mod names;
mod project;
mod solve;
mod stack;
mod step;
mod unit;

use machinist_contract::Jumps;
use machinist_contract::fixed_step::StepMethod;
use machinist_model::hoist::Hoisted;
use machinist_model::{Model, StateKind};

use super::EmitError;
use body::{Scope, body};
pub use cost::{FilterCost, StepCost, filter_cost, rust_filter_cost, step_cost};
pub use description::needs_start;
pub use estimator::EstimatorOptions;
use estimator::Tangents;
use expression::Written;
use names::Namer;
pub use stack::{StackBound, StackBounds};
pub use unit::{FmiVersion, Settable, UnitKind, UnitOptions, UnitVariable, emit_unit};

/// Number type of emitted C.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Real {
    /// `double`.
    #[default]
    Double,
    /// `float`.
    Float,
}

impl Real {
    /// Returns its name in C.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Double => "double",
            Self::Float => "float",
        }
    }

    /// Returns the size of a number.
    fn bytes(self) -> usize {
        match self {
            Self::Double => size_of::<f64>(),
            Self::Float => size_of::<f32>(),
        }
    }

    /// Returns the name of a function of the standard library for this type.
    fn function(self, name: &str) -> String {
        match self {
            Self::Double => name.to_owned(),
            Self::Float => format!("{name}f"),
        }
    }

    /// Returns the shortest literal that reads back as the number of this type nearest to a
    /// value; `None` if that is not finite.
    fn literal(self, value: f64) -> Option<String> {
        #[allow(clippy::cast_possible_truncation, reason = "the nearest number of C's float")]
        match self {
            Self::Double => value.is_finite().then(|| format!("{value:?}")),
            Self::Float => {
                let value = value as f32;
                value.is_finite().then(|| format!("{value:?}f"))
            }
        }
    }
}

/// Options of the emitted code.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct C99Options {
    /// Number type.
    pub real: Real,
    /// Method of a step.
    pub method: StepMethod,
    /// The command that updates the files, for their headers.
    pub command: String,
    /// Names of parameters that are inputs. They get a struct of their own.
    pub inputs: Vec<String>,
    /// The state in which a run of the spec starts, if its initial values do not determine it: on
    /// the constraints, or in equilibrium.
    pub start: Option<Vec<f64>>,
    /// An extended Kalman filter beside the machine.
    pub estimator: Option<EstimatorOptions>,
}

/// An emitted file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct C99File {
    /// Its name, without folders.
    pub name: String,
    /// Its content.
    pub text: String,
}

/// The first words of every emitted file, by which it is recognized.
pub(crate) const MARK: &str = "Emitted by Machinist";

/// Emits the files of a scene: header, source, CMake file and example.
///
/// # Errors
/// [`EmitError::Unsupported`] for a scene with fields that are not divided into elements, which
/// [`Model::divided_completely`] does, and for an input that is not a parameter; else as [`rust::emit`](super::rust::emit).
pub fn emit(model: &Model, options: &C99Options) -> Result<Vec<C99File>, EmitError> {
    model.validate()?;
    if let Some(field) = model.fields.first() {
        return Err(fields_are_unsupported(&field.quantities[0].name.path));
    }
    // Steps of emitted C hold no relations, and none is by series.
    let model = &Model { saturating_arguments: machinist_model::Tape::default(), ..model.live() };
    let mut scene = Scene::new(model, options)?;
    let functions = functions::functions(&scene)?;
    let name = &model.name;
    let file = |name: String, text: String| C99File { name, text };
    let source = description::source(&scene, &functions)?;
    // The header states the stack of functions of the source, whose types it declares.
    scene.stack = Some(StackBounds::of(&description::header(&scene, &functions), &source));
    Ok(vec![
        file(format!("{name}.h"), description::header(&scene, &functions)),
        file(format!("{name}.c"), source),
        file("CMakeLists.txt".to_owned(), project::cmake(&scene)),
        file(format!("{name}_example.c"), project::example(&scene)?),
    ])
}

/// Returns the error for a scene with fields.
fn fields_are_unsupported(field: &str) -> EmitError {
    let message = format!(
        "field `{field}` is not divided into elements, whose nodes emitted C99 has as states"
    );
    EmitError::Unsupported { message }
}

/// A model with the names in its emitted files.
struct Scene<'a> {
    model: &'a Model,
    options: &'a C99Options,
    /// Variables for the entries of the state.
    states: Vec<String>,
    /// Members of the state.
    state_members: Vec<String>,
    /// Members of the parameters.
    parameter_members: Vec<String>,
    /// Expressions of the parameters that tapes read.
    parameters: Vec<Written>,
    /// Members of the outputs.
    output_members: Vec<String>,
    tables: Vec<String>,
    /// Names that variables must not take.
    namer: Namer,
    hoisted: Hoisted,
    /// Members of the constants.
    constants: Vec<String>,
    /// Statements that compute the constants.
    prepare: Vec<String>,
    motion: Option<solve::Motion>,
    /// Expressions of the results of the motion.
    motion_results: Vec<String>,
    /// Indices of the parameters that are inputs.
    inputs: Vec<usize>,
    /// Derivatives for the filter, if there is one.
    tangents: Option<Tangents>,
    /// Stack of the emitted functions, once it is counted.
    stack: Option<StackBounds>,
}

impl<'a> Scene<'a> {
    fn new(model: &'a Model, options: &'a C99Options) -> Result<Self, EmitError> {
        if let Some(of) = model.constraints.iter().find(|it| it.jumps == Jumps::AtPlaces) {
            let message = format!(
                "constraint `{}` is of friction whose speed jumps at a place, which fixed steps do \
                 not find in time. Hint: let the speed change over a short distance, such as by \
                 `min(max((x - x0)/1e-3, 0), 1)`",
                of.name.path
            );
            return Err(EmitError::Unsupported { message });
        }
        let idents = model.states.iter().map(|state| state.quantity.name.ident.as_str());
        let state_members = Namer::members(idents);
        let parameter_members =
            Namer::members(model.parameters.iter().map(|p| p.quantity.name.ident.as_str()));
        let output_members = Namer::members(model.wanted.iter().map(|o| o.name.ident.as_str()));
        let hoisted = Hoisted::new(model);
        let tangents = match &options.estimator {
            Some(filter) => {
                estimator::check(model)?;
                Some(Tangents::of(model, options.method, filter))
            }
            None => None,
        };
        let tapes = helpers::tapes(model, &hoisted, tangents.as_ref());
        let mut namer = Namer::for_locals(helpers::names(&tapes, options.real));
        drop(tapes);
        let tables = model.tables.iter();
        let tables: Vec<String> =
            tables.map(|table| namer.claim(&format!("{}_table", table.name.ident))).collect();
        let states: Vec<String> = state_members.iter().map(|name| namer.claim(name)).collect();
        let parameters = parameter_members.iter().map(|name| Written::call(format!("p->{name}")));
        let parameters = parameters.collect();
        let mut scene = Self {
            model,
            options,
            states,
            state_members,
            parameter_members,
            parameters,
            output_members,
            tables,
            namer,
            hoisted,
            constants: Vec::new(),
            prepare: Vec::new(),
            motion: None,
            motion_results: Vec::new(),
            inputs: inputs(model, &options.inputs)?,
            tangents,
            stack: None,
        };
        scene.name_constants()?;
        scene.motion = solve::Motion::of(&scene)?;
        scene.motion_results = scene.motion.as_ref().map_or_else(Vec::new, solve::Motion::results);
        Ok(scene)
    }

    /// Names the values that are computed once a run, after the variables that compute them.
    fn name_constants(&mut self) -> Result<(), EmitError> {
        let prepare = body(&self.hoisted.constants, &self.scope("prepare"), true)?;
        // Every constant is an operation, so its result is a variable.
        self.constants = prepare.results;
        self.prepare = prepare.statements;
        Ok(())
    }

    /// Returns the names that bodies may use.
    fn scope<'s>(&'s self, function: &'s str) -> Scope<'s> {
        Scope {
            function,
            real: self.options.real,
            states: &self.states,
            parameters: &self.parameters,
            constants: &self.constants,
            motion: &self.motion_results,
            tables: &self.tables,
            namer: &self.namer,
        }
    }

    /// Returns the number type.
    fn real(&self) -> &'static str {
        self.options.real.name()
    }

    /// Returns a public name: `saw_gin_rate`.
    fn public(&self, name: &str) -> String {
        format!("{}_{name}", self.model.name)
    }

    /// Returns a sentence on the stack of a public function.
    fn stack_of(&self, name: &str) -> String {
        let bound = self.stack.as_ref().and_then(|stack| stack.function(&self.public(name)));
        bound.map_or_else(String::new, |bound| format!(" Its stack holds {bound}."))
    }

    /// Returns the name of a macro: `SAW_GIN_STATES`.
    fn macro_name(&self, name: &str) -> String {
        format!("{}_{name}", self.model.name.to_ascii_uppercase())
    }

    /// Fills the names and the number type of this scene into a snippet.
    fn filled(&self, snippet: &str) -> String {
        let text = snippet
            .replace("scene_real_t", self.real())
            .replace("scene_index_t", self.index_type())
            .replace("scene_", &format!("{}_", self.model.name))
            .replace("SCENE_", &self.macro_name(""));
        helpers::with_literals(&text, self.options.real)
    }

    /// Returns the smallest C type for all indices of the scene.
    fn index_type(&self) -> &'static str {
        let model = self.model;
        let nonzeros = model.functions().filter_map(|row| Some(row.pattern?(model).entries.len()));
        let motion = model.motion.as_ref().map_or(0, |motion| motion.tape.results.len());
        let terms = model.functions().filter_map(|row| model.solve(row.id)).map(|solve| {
            let terms: usize = solve.steps.iter().map(|step| step.terms.len()).sum();
            terms.max(solve.inputs()).max(solve.rows as usize).max(solve.columns as usize)
        });
        let most = nonzeros.chain(terms).chain([motion, model.states.len()]).max().unwrap_or(0);
        if most < usize::from(u16::MAX) { "uint16_t" } else { "uint32_t" }
    }

    /// Reports whether an entry of the state is a mode.
    fn is_mode(&self, entry: usize) -> bool {
        self.model.states[entry].kind == StateKind::Mode
    }
}

/// Returns the indices of the named parameters.
fn inputs(model: &Model, names: &[String]) -> Result<Vec<usize>, EmitError> {
    let find = |name: &String| {
        let found = model.parameters.iter().position(|p| p.quantity.name.path == *name);
        found.ok_or_else(|| EmitError::Unsupported {
            message: format!("input `{name}` is not a parameter"),
        })
    };
    names.iter().map(find).collect()
}

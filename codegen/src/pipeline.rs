//! The stages from spec text to a model.
//!
//! ```text
//! spec text -> SceneSpec -> LagrangianSystem -> EquationsOfMotion
//!   -> (reduce) -> Linearization -> Model -> emitted Rust, and all that runs models
//! ```
//!
//! A reduction step may give another system. Its equations are then derived again, here and
//! nowhere else.

use std::path::Path;

use machinist_algebra::cas::{Algebra, Cas, CasError, session};
use machinist_algebra::expr::{ConstraintId, Expr, Symbol};
use machinist_model::Model;
use machinist_model::file::Stamped;
use serde::{Deserialize, Serialize};

use crate::emit::document::{Document, Notation};
use crate::mechanics::density::{self, FieldEquations};
use crate::mechanics::dependencies::Dependencies;
use crate::mechanics::lagrange::{self, EquationsOfMotion};
use crate::mechanics::linearize::{Linearization, linearize};
use crate::mechanics::reduce::{FreezeError, Keep, Step, drop_unused};
use crate::scene::system::LagrangianSystem;
use crate::spec::code::Code;
use crate::spec::diagnostic::{Diagnostic, Diagnostics};
use crate::{lower, scene, spec};

/// Derives the model of a scene file by the default algebra: of the whole scene, or of what its
/// outputs need.
///
/// # Errors
/// [`Diagnostics`] with file, line, span and hint for each mistake in the spec.
pub fn generate(scene: &Path, keep: Keep) -> Result<Model, Diagnostics> {
    compile(check(scene)?, keep)
}

/// Derives the model of a checked scene by the default algebra.
///
/// # Errors
/// As [`generate`].
pub fn compile(system: LagrangianSystem, keep: Keep) -> Result<Model, Diagnostics> {
    compile_by(Algebra::default(), system, keep)
}

/// Derives the model of a checked scene by a given algebra.
///
/// # Errors
/// As [`generate`].
pub fn compile_by(
    algebra: Algebra,
    system: LagrangianSystem,
    keep: Keep,
) -> Result<Model, Diagnostics> {
    let (_, needed) = reduced_by(algebra, system, keep)?;
    needed.lower()
}

/// Returns the equations of the whole scene, and the linearized equations of what is kept.
fn reduced_by(
    algebra: Algebra,
    system: LagrangianSystem,
    keep: Keep,
) -> Result<(EquationsOfMotion, Linear), Diagnostics> {
    let keep = possible(&system, keep);
    let algebra = suitable(algebra, &system);
    let _span =
        tracing::info_span!("derive", scene = system.name, algebra = algebra.name()).entered();
    session(&system.name.clone(), algebra, move |cas| {
        let equations = lagrange::derive(cas, &system);
        decided(&equations)?;
        let needed = reduce(cas, &equations, keep)?;
        let needed = Linear::of(cas, &needed);
        defined(cas)?;
        Ok((equations, needed))
    })?
}

/// Returns the equations of what is kept.
fn reduce(
    cas: &mut Cas,
    whole: &EquationsOfMotion,
    keep: Keep,
) -> Result<EquationsOfMotion, FreezeError> {
    let mut equations = whole.clone();
    for step in keep.steps() {
        equations = match step.step(cas, equations)? {
            Step::Equations(equations) => equations,
            Step::System(system, reduction) => {
                EquationsOfMotion { reduction, ..lagrange::derive(cas, &system) }
            }
        };
    }
    if keep > Keep::All {
        equations = drop_unused(cas, equations, whole);
    }
    Ok(equations)
}

/// Returns how far a system may be reduced: the machine's own equations do not show what its
/// fields and its drawing depend on, and trees of bodies are kept whole.
fn possible(system: &LagrangianSystem, keep: Keep) -> Keep {
    let is_reducible = system.fields.is_empty()
        && system.mechanisms.is_empty()
        && system.orientations.is_empty()
        && system.drawing.is_empty();
    if is_reducible { keep } else { Keep::All }
}

/// Returns the algebra for a system: shared parts, of which equations of bodies consist, belong to
/// our own.
fn suitable(algebra: Algebra, system: &LagrangianSystem) -> Algebra {
    let is_plain = system.mechanisms.is_empty() && system.orientations.is_empty();
    if is_plain { algebra } else { Algebra::Plain }
}

/// Linearized equations of the machine, and the equations of its fields.
struct Linear {
    machine: Linearization,
    fields: Vec<FieldEquations>,
}

impl Linear {
    fn of(cas: &mut Cas, equations: &EquationsOfMotion) -> Self {
        let fields = density::derive(cas, &equations.system);
        Linear { machine: linearize(cas, equations), fields }
    }

    /// Lowers the equations to a model.
    ///
    /// # Errors
    /// If a number in the equations is not finite. All numbers of the spec are finite, but
    /// results of computations with them may overflow.
    fn lower(&self) -> Result<Model, Diagnostics> {
        linear(&self.machine)?;
        let mut model = lower::lower(&self.machine);
        let fields = self.machine.equations.system.fields.iter().zip(&self.fields);
        model.fields =
            fields.map(|(field, equations)| lower::density::lower(field, equations)).collect();
        model.validate().map_err(|error| {
            let message = format!("the equations cannot be computed: {error}");
            let help = "look for a number above 1e308, such as a large number to a high power";
            Diagnostic::of_file(Code::UndefinedValue, "", message, help)
        })?;
        Ok(model)
    }
}

/// Models of a scene: the whole, and after each step of reduction.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Stages {
    /// The model of the whole scene.
    pub whole: Model,
    /// Each reduction step that changed anything, with its result.
    pub steps: Vec<(Keep, Model)>,
}

impl Stages {
    /// Returns the last model.
    #[must_use]
    pub fn needed(&self) -> &Model {
        self.steps.last().map_or(&self.whole, |(_, model)| model)
    }
}

/// All results of deriving a scene, for reading and for further processing.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Derivation {
    /// The algebra that derived them.
    pub algebra: Algebra,
    /// Models, step by step.
    pub stages: Stages,
    /// The equations of the whole scene as text.
    pub text: Document,
    /// The same equations as LaTeX.
    pub latex: Document,
    /// Dependencies between the quantities.
    pub dependencies: Dependencies,
}

/// The first results of a [`Derivation`]: the model to run, and equations to read.
#[derive(Debug, Clone, PartialEq)]
pub struct Outline {
    /// The model of what is kept.
    pub model: Model,
    /// The equations of the whole scene as LaTeX.
    pub latex: Document,
    /// Dependencies between the quantities.
    pub dependencies: Dependencies,
}

/// Derives the outline of a checked scene by a given algebra. Its model is the last one of the
/// [`Stages`] that [`derivation_by`] returns; the preceding ones are not derived.
///
/// # Errors
/// As [`generate`].
pub fn outline_by(
    algebra: Algebra,
    system: LagrangianSystem,
    keep: Keep,
) -> Result<Outline, Diagnostics> {
    let (equations, needed) = reduced_by(algebra, system, keep)?;
    let model = needed.lower()?;
    Ok(Outline {
        latex: Document::new(&equations, Notation::Latex),
        dependencies: Dependencies::new(&equations, &model.reduction),
        model,
    })
}

/// Derives everything of a checked scene, reduced step by step up to `keep`.
///
/// # Errors
/// As [`generate`].
pub fn derivation_by(
    algebra: Algebra,
    system: LagrangianSystem,
    keep: Keep,
) -> Result<Derivation, Diagnostics> {
    let keep = possible(&system, keep);
    let (equations, whole, steps) =
        session(&system.name.clone(), suitable(algebra, &system), move |cas| {
            let equations = lagrange::derive(cas, &system);
            decided(&equations)?;
            let mut steps: Vec<(Keep, EquationsOfMotion)> = Vec::new();
            for step in Keep::STEPS.into_iter().filter(|step| *step <= keep) {
                let reduced = reduce(cas, &equations, step)?;
                if *steps.last().map_or(&equations, |(_, last)| last) != reduced {
                    steps.push((step, reduced));
                }
            }
            let linear: Vec<_> =
                steps.iter().map(|(step, reduced)| (*step, Linear::of(cas, reduced))).collect();
            let whole = Linear::of(cas, &equations);
            defined(cas)?;
            Ok::<_, Diagnostics>((equations, whole, linear))
        })??;
    let steps = steps.iter().map(|(step, linear)| Ok((*step, linear.lower()?)));
    let steps = steps.collect::<Result<_, Diagnostics>>()?;
    let stages = Stages { whole: whole.lower()?, steps };
    Ok(Derivation {
        algebra,
        text: Document::new(&equations, Notation::Text),
        latex: Document::new(&equations, Notation::Latex),
        dependencies: Dependencies::new(&equations, &stages.needed().reduction),
        stages,
    })
}

/// Reads a scene file as one Lagrangian system, with names and dimensions checked.
///
/// # Errors
/// As [`generate`].
pub fn check(scene: &Path) -> Result<LagrangianSystem, Diagnostics> {
    let spec = spec::load_scene(scene)?;
    scene::compose(&spec)
}

/// Derives the equations of motion of a scene file, to be read.
///
/// # Errors
/// As [`generate`].
pub fn derive(scene: &Path) -> Result<EquationsOfMotion, Diagnostics> {
    let system = check(scene)?;
    let algebra = Algebra::most_simplifying(system.coordinates.len());
    session(&system.name.clone(), suitable(algebra, &system), move |cas| {
        let equations = lagrange::derive(cas, &system);
        decided(&equations)?;
        defined(cas).map(|()| equations)
    })?
}

/// Rejects equations that have no value at any state. The checks of the spec see each expression
/// as written; this one sees the result of the derivation.
fn defined(cas: &mut Cas) -> Result<(), Diagnostics> {
    if !cas.was_undefined() {
        return Ok(());
    }
    let message = "the equations divide by zero, or take its logarithm, in every state";
    let help = "look for a denominator or an argument of `ln` whose terms cancel";
    Err(Diagnostic::of_file(Code::UndefinedValue, "", message.to_owned(), help).into())
}

/// Rejects forces that are not linear in constraint forces, although each as written is: by the rate
/// of a state that a momentum depends on.
fn linear(linearization: &Linearization) -> Result<(), Diagnostics> {
    let is_force = |symbol| matches!(symbol, Symbol::Multiplier(_));
    let slopes = linearization.reactions.iter().flat_map(|reaction| &reaction.forcing);
    if slopes.into_iter().any(|(_, slope)| slope.mentions(is_force)) {
        let message = "forces depend on constraint forces by the rate of a state, and not in \
                       proportion";
        let help = "write the rate as a factor times the constraint force, or times its `abs`";
        return Err(Diagnostic::of_file(Code::InvalidForce, "", message, help).into());
    }
    Ok(())
}

/// Rejects forces and rates that depend on the force of a constraint that is dropped.
fn carried(equations: &EquationsOfMotion) -> Result<(), Diagnostics> {
    let dropped = equations.system.constraints.iter().enumerate().filter(|(_, one)| one.is_dropped);
    for (index, constraint) in dropped {
        let its = Symbol::Multiplier(ConstraintId(index as u32));
        // Any of the forces may be shared.
        let is_shared = equations.system.shares_redundant;
        let is_its = |symbol: Symbol| match symbol {
            Symbol::Multiplier(_) => is_shared || symbol == its,
            _ => false,
        };
        let reads = |exprs: &[Expr]| exprs.iter().any(|expr| expr.mentions(is_its));
        let what = match (reads(&equations.forcing), reads(&equations.rates)) {
            (true, _) => "a force",
            (_, true) => "a rate",
            _ => continue,
        };
        let name = &constraint.name.path;
        let (message, help) = if is_shared {
            (
                format!(
                    "{what} depends on a constraint force, but `share_redundant` shares those of \
                     constraint `{name}` with others"
                ),
                "leave `share_redundant` out, so that the others carry its force",
            )
        } else {
            (
                format!(
                    "{what} depends on the force of constraint `{name}`, which is dropped because \
                     it follows from others"
                ),
                "these carry its force: read theirs instead, or leave them out",
            )
        };
        return Err(Diagnostic::of_file(Code::InvalidForce, "", message, help).into());
    }
    Ok(())
}

/// Rejects coordinates that neither an inertia nor a constraint determines.
fn decided(equations: &EquationsOfMotion) -> Result<(), Diagnostics> {
    carried(equations)?;
    let Some(undecided) = equations.undecided() else { return Ok(()) };
    let coordinates = &equations.system.coordinates;
    let names =
        undecided.iter().map(|index| format!("`{}`", coordinates[*index].position.name.path));
    let names = names.collect::<Vec<_>>().join(", ");
    let message = format!(
        "the equations are singular: {names} can move without kinetic energy, and no constraint \
         active in all modes determines their motion"
    );
    let help = "give one of them an inertia, or add a constraint";
    Err(Diagnostic::of_file(Code::NoInertia, "", message, help).into())
}

/// Returns a model with the name of its generator.
#[must_use]
pub fn stamped(algebra: Algebra, model: Model, keep: Keep) -> Stamped {
    Stamped { generator: format!("{GENERATOR} {}, {}", algebra.name(), keep.name()), model }
}

/// The generator of models: name, version, and the hash of its own source text.
pub const GENERATOR: &str = concat!(
    env!("CARGO_PKG_NAME"),
    " ",
    env!("CARGO_PKG_VERSION"),
    " ",
    env!("MACHINIST_GENERATOR")
);

impl From<CasError> for Diagnostics {
    fn from(error: CasError) -> Self {
        let help =
            miette::Diagnostic::help(&error).map_or_else(String::new, |help| help.to_string());
        Diagnostic::of_file(error.code(), "", error.to_string(), &help).into()
    }
}

impl From<FreezeError> for Diagnostics {
    fn from(error: FreezeError) -> Self {
        let help =
            "leave it out of `rigid` in [freeze]; `machinist explain` lists what can be frozen";
        Diagnostic::of_file(error.code(), "", error.to_string(), help).into()
    }
}

//! The straight line, from spec text to a model.
//!
//! ```text
//! spec text -> SceneSpec -> LagrangianSystem -> EquationsOfMotion
//!   -> (reduce) -> Linearization -> Model -> emitted Rust, and all that runs models
//! ```
//!
//! A step of reduction may give another system; then equations are derived again, here and
//! nowhere else.

use std::path::Path;

use machinist_algebra::cas::{Algebra, Cas, CasError, session};
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
use crate::spec::diagnostic::{Diagnostic, Diagnostics};
use crate::{lower, scene, spec};

/// A scene file to its model, of the whole scene or of what its outputs need, derived by the
/// default algebra.
///
/// # Errors
/// With file, line, span and hint for whatever is wrong in the spec.
pub fn generate(scene: &Path, keep: Keep) -> Result<Model, Diagnostics> {
    compile(check(scene)?, keep)
}

/// A checked scene to its model, derived by the default algebra.
///
/// # Errors
/// As [`generate`].
pub fn compile(system: LagrangianSystem, keep: Keep) -> Result<Model, Diagnostics> {
    compile_by(Algebra::default(), system, keep)
}

/// A checked scene to its model, derived by an algebra of one's choice.
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

/// The equations of the whole scene, and those of what is kept, linearized.
fn reduced_by(
    algebra: Algebra,
    system: LagrangianSystem,
    keep: Keep,
) -> Result<(EquationsOfMotion, Linear), Diagnostics> {
    let keep = possible(&system, keep);
    session(&system.name.clone(), algebra, move |cas| {
        let equations = lagrange::derive(cas, &system);
        decided(&equations)?;
        let needed = reduce(cas, &equations, keep)?;
        let needed = Linear::of(cas, &needed);
        defined(cas)?;
        Ok((equations, needed))
    })?
}

/// The equations of what is kept.
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

/// What may be left out of a system: what a field holds on to is not seen in the
/// machine's own equations.
fn possible(system: &LagrangianSystem, keep: Keep) -> Keep {
    if system.fields.is_empty() { keep } else { Keep::All }
}

/// Equations with their derivatives, of the machine and of its fields.
struct Linear {
    machine: Linearization,
    fields: Vec<FieldEquations>,
}

impl Linear {
    fn of(cas: &mut Cas, equations: &EquationsOfMotion) -> Self {
        let fields = density::derive(cas, &equations.system);
        Linear { machine: linearize(cas, equations), fields }
    }

    /// # Errors
    /// If a number of the equations is none: each is finite in the spec, and what is computed
    /// of them need not be.
    fn lower(&self) -> Result<Model, Diagnostics> {
        let mut model = lower::lower(&self.machine);
        let fields = self.machine.equations.system.fields.iter().zip(&self.fields);
        model.fields =
            fields.map(|(field, equations)| lower::density::lower(field, equations)).collect();
        model.validate().map_err(|error| {
            let message = format!("the equations cannot be computed: {error}");
            let help = "look for a number beyond 1e308, such as a large one to a high power";
            Diagnostic::of_file("", message, help)
        })?;
        Ok(model)
    }
}

/// A scene's models, of the whole and after each step of reduction.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Stages {
    /// Nothing left out.
    pub whole: Model,
    /// After each step that changed anything, that step and what is left.
    pub steps: Vec<(Keep, Model)>,
}

impl Stages {
    /// The last of them.
    #[must_use]
    pub fn needed(&self) -> &Model {
        self.steps.last().map_or(&self.whole, |(_, model)| model)
    }
}

/// Everything that is derived of a scene, for people and for machines.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Derivation {
    /// What worked it out.
    pub algebra: Algebra,
    /// Models, step by step.
    pub stages: Stages,
    /// The equations of the whole scene as text.
    pub text: Document,
    /// The same as LaTeX.
    pub latex: Document,
    /// Who needs whom.
    pub dependencies: Dependencies,
}

/// The part of a [`Derivation`] that is wanted first: the model to run, and equations for people.
#[derive(Debug, Clone, PartialEq)]
pub struct Outline {
    /// The model of what is kept.
    pub model: Model,
    /// The equations of the whole scene as LaTeX.
    pub latex: Document,
    /// Who needs whom.
    pub dependencies: Dependencies,
}

/// A checked scene to its outline, worked out by an algebra of one's choice. The model is the last one
/// of the [`Stages`] that [`derivation_by`] gives; those before it are not derived.
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

/// A checked scene to all that is derived of it, reduced step by step up to `keep`.
///
/// # Errors
/// As [`generate`].
pub fn derivation_by(
    algebra: Algebra,
    system: LagrangianSystem,
    keep: Keep,
) -> Result<Derivation, Diagnostics> {
    let keep = possible(&system, keep);
    let (equations, whole, steps) = session(&system.name.clone(), algebra, move |cas| {
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

/// A scene file to one Lagrangian system, names and dimensions checked.
///
/// # Errors
/// As [`generate`].
pub fn check(scene: &Path) -> Result<LagrangianSystem, Diagnostics> {
    let spec = spec::load_scene(scene)?;
    scene::compose(&spec)
}

/// A scene file to its equations of motion, for people to read.
///
/// # Errors
/// As [`generate`].
pub fn derive(scene: &Path) -> Result<EquationsOfMotion, Diagnostics> {
    let system = check(scene)?;
    let algebra = Algebra::most_simplifying(system.coordinates.len());
    session(&system.name.clone(), algebra, move |cas| {
        let equations = lagrange::derive(cas, &system);
        decided(&equations)?;
        defined(cas).map(|()| equations)
    })?
}

/// Refuses what has no value for any state: checks of the spec see each expression as it
/// is written, this sees what became of them.
fn defined(cas: &mut Cas) -> Result<(), Diagnostics> {
    if !cas.was_undefined() {
        return Ok(());
    }
    let message = "the equations divide by zero, or take its logarithm, whatever the state is";
    let help = "look for a denominator or an argument of `ln` whose terms cancel";
    Err(Diagnostic::of_file("", message.to_owned(), help).into())
}

/// Refuses coordinates that neither an inertia nor a constraint decides.
fn decided(equations: &EquationsOfMotion) -> Result<(), Diagnostics> {
    let Some(undecided) = equations.undecided() else { return Ok(()) };
    let coordinates = &equations.system.coordinates;
    let names =
        undecided.iter().map(|index| format!("`{}`", coordinates[*index].position.name.path));
    let names = names.collect::<Vec<_>>().join(", ");
    let message = format!(
        "the equations are singular: {names} can move without kinetic energy, and no constraint \
         that always holds decides how"
    );
    let help = "give one of them an inertia of its own, or hold it by one more constraint";
    Err(Diagnostic::of_file("", message, help).into())
}

/// A model with word of what made it.
#[must_use]
pub fn stamped(algebra: Algebra, model: Model, keep: Keep) -> Stamped {
    Stamped { generator: format!("{GENERATOR} {}, {}", algebra.name(), keep.name()), model }
}

/// The generator of models: name, version, and the hash of its own text.
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
        Diagnostic::of_file("", error.to_string(), &help).into()
    }
}

impl From<FreezeError> for Diagnostics {
    fn from(error: FreezeError) -> Self {
        let help =
            "leave it out of `rigid` in [freeze]; `machinist explain` lists what can be frozen";
        Diagnostic::of_file("", error.to_string(), help).into()
    }
}

//! Models and equations of a scene: read from the cache, derived by Machinist's own algebra in this
//! process, or derived by Symbolica in a short-lived child process.
//!
//! Machines to run or to analyse are derived by Machinist's own algebra, which takes no lock.
//! Equations to emit or to read are derived by Symbolica, which simplifies further, and so is
//! everything if the user names it. Symbolica needs the child for two reasons. It may run in one
//! process of a machine at a time, from its first use to the end of that process, while a report
//! takes minutes. And a process that has used it must start no other (see
//! `machinist_algebra::cas`), as `explain` does to compile.

mod cache;
mod child;

use std::panic::{AssertUnwindSafe, catch_unwind, resume_unwind};
use std::sync::{Mutex, OnceLock, PoisonError};

use machinist::constraints::{self, Lasting};
use machinist_algebra::cas::Algebra;
use machinist_algebra::interrupt::Interrupted;
use machinist_codegen::mechanics::reduce::Keep;
use machinist_codegen::pipeline::{self, Derivation};
use machinist_codegen::scene::compose;
use machinist_codegen::scene::system::LagrangianSystem;
use machinist_codegen::spec::code::Code;
use machinist_codegen::spec::diagnostic::{Diagnostic, Diagnostics};
use machinist_model::file::Stamped;
use machinist_model::{Model, ModelSimulator, SourceFile};
use miette::Report;
use serde::{Deserialize, Serialize};

use crate::config;
use crate::failure::{Failure, Trouble, all};
use crate::progress::during;
use crate::spec_source::SpecSource;
use cache::Key;
pub use cache::{Cache, turn_off as turn_off_cache};
pub use child::{COMMAND, answer_parent, end_with_parent};

/// Request to derive a scene.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct Request {
    /// Scene to derive.
    pub scene: SpecSource,
    /// Extent of the reduction.
    pub keep: Keep,
    /// Instances to be taken as rigid instead of those that the scene names.
    pub rigid: Option<Vec<String>>,
    /// Result wanted: only a model, or everything.
    pub wanted: Wanted,
    /// Purpose of the derivation.
    pub purpose: Purpose,
    /// Constraints to be dropped because they follow from others, each with the parameters that
    /// must keep the spec's values for this.
    pub dropped: Vec<(String, Vec<String>)>,
    /// Coordinates on which a test force of zero acts, as a parameter.
    pub test_forces: Vec<String>,
    /// Inputs of units that become parameters.
    pub opened: Vec<String>,
}

/// Algebra for all further derivations in this process, if the user names one.
static ALGEBRA: OnceLock<Algebra> = OnceLock::new();

/// Returns the algebra that the user named, if any.
fn named_algebra() -> Option<Algebra> {
    ALGEBRA.get().copied().or_else(config::algebra_for_derivation)
}

/// Sets the algebra for all further derivations. Only the first call has an effect.
pub fn derive_by(algebra: Algebra) {
    let _ = ALGEBRA.set(algebra);
}

/// True if the user named the algebra. Emitted code is that of the default one.
pub fn is_algebra_named() -> bool {
    named_algebra().is_some()
}

/// Purpose of a derivation, which decides the algebra unless the user names it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub enum Purpose {
    /// To be run or analysed: by Machinist's own algebra, which takes no lock.
    Running,
    /// To be emitted, or to be read by people: by the algebra that simplifies most.
    Reading,
}

impl Purpose {
    /// Returns the algebra that derives a system.
    fn algebra(self, system: &LagrangianSystem) -> Algebra {
        named_algebra().unwrap_or_else(|| match self {
            Self::Running => Algebra::default(),
            Self::Reading => Algebra::most_simplifying(system.coordinates.len()),
        })
    }
}

/// Result wanted from a derivation.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub enum Wanted {
    /// Model.
    Model,
    /// Model if it exists.
    ModelIfPossible,
    /// Models after each step of the reduction, and equations for people.
    Everything,
}

/// Result of a derivation.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
enum Derived {
    Model(Box<Stamped>),
    /// The requested model does not exist.
    Impossible,
    Everything(Box<Derivation>),
}

impl Request {
    /// Requests the model of a scene, to be run.
    pub fn model(scene: &SpecSource, keep: Keep) -> Self {
        Self {
            scene: scene.clone(),
            keep,
            rigid: None,
            wanted: Wanted::Model,
            purpose: Purpose::Running,
            dropped: Vec::new(),
            test_forces: Vec::new(),
            opened: Vec::new(),
        }
    }

    /// Reads the system of the scene and applies the request's changes.
    fn system(&self) -> Result<LagrangianSystem, Diagnostics> {
        let mut system = self.opened_system()?;
        if let Some(rigid) = &self.rigid {
            system.freeze.rigid.clone_from(rigid);
        }
        for (constraint, needs) in &self.dropped {
            system.drop_constraint(constraint, needs);
        }
        for coordinate in &self.test_forces {
            if !system.add_test_force(coordinate) {
                let message = format!("there is no coordinate `{coordinate}`");
                return Err(Diagnostic::of_file(Code::UnknownName, "", message, "").into());
            }
        }
        Ok(system)
    }

    /// Reads the system of the scene, with parameters in place of the opened inputs.
    fn opened_system(&self) -> Result<LagrangianSystem, Diagnostics> {
        let mut spec = self.scene.read()?;
        for input in &self.opened {
            if spec.open_input(input).is_none() {
                let message = format!("there is no input `{input}` to open");
                return Err(Diagnostic::of_file(Code::UnknownInput, "", message, "").into());
            }
        }
        compose(&spec)
    }

    /// Derives the requested model or equations of the system that was read.
    fn derived_of(
        &self,
        system: LagrangianSystem,
        algebra: Algebra,
    ) -> Result<Derived, Diagnostics> {
        let keep = self.keep;
        let model = |system| {
            let model = pipeline::compile_by(algebra, system, keep)?;
            Ok(Derived::Model(Box::new(pipeline::stamped(algebra, model, keep))))
        };
        match self.wanted {
            Wanted::Model => model(system),
            Wanted::ModelIfPossible => Ok(model(system).unwrap_or(Derived::Impossible)),
            Wanted::Everything => {
                let derivation = pipeline::derivation_by(algebra, system, keep)?;
                Ok(Derived::Everything(Box::new(derivation)))
            }
        }
    }
}

/// Derives the model of a scene.
pub fn model(scene: &SpecSource, keep: Keep) -> Result<Model, Failure> {
    Ok(stamped(&Request::model(scene, keep))?.model)
}

/// Derives the model of a request, with the generator that made it. Drops constraints that always
/// follow from others, with a note.
pub fn stamped(request: &Request) -> Result<Stamped, Failure> {
    during("deriving", || stamped_with(request, &mut tell))
}

/// Like [`stamped`], but hands remarks to the caller instead of printing them.
pub fn stamped_with(request: &Request, remark: &mut dyn FnMut(Remark)) -> Result<Stamped, Failure> {
    let whole = derived_as_asked(request, remark)?;
    let dropped = to_drop(&whole.model, remark);
    if dropped.is_empty() {
        return Ok(whole);
    }
    derived_as_asked(&Request { dropped, ..request.clone() }, remark)
}

/// Returns the constraints of a model that always follow from others, each with the parameters that
/// must keep their values for this, after remarks that name them.
pub fn to_drop(model: &Model, remark: &mut dyn FnMut(Remark)) -> Vec<(String, Vec<String>)> {
    let dropped = repeated(model);
    let (empty, repeating): (Vec<_>, Vec<_>) =
        dropped.iter().partition(|one| one.repeats.is_empty());
    let of_empty = (!empty.is_empty()).then(|| empty_note(model, &empty));
    let notes = of_empty.into_iter().chain(repeating.iter().map(|one| repeating_note(model, one)));
    notes.for_each(|note| remark(Remark::Note(note)));
    dropped.into_iter().map(|one| (one.constraint, one.needs)).collect()
}

/// Returns the constraints that follow from others in every state.
fn repeated(model: &Model) -> Vec<Lasting> {
    if model.constraints.is_empty() || !model.fields.is_empty() {
        return Vec::new();
    }
    let parameters: Vec<f64> = model.all_parameters().map(|one| one.value).collect();
    let simulator = ModelSimulator::new(model.clone());
    constraints::lasting(&simulator, &parameters, model.run.from)
}

/// Returns the note about constraints that are dropped because they hold in any position.
fn empty_note(model: &Model, dropped: &[&Lasting]) -> String {
    let (names, name) = (quoted(dropped.iter().map(|one| &one.constraint)), &model.name);
    match dropped {
        [_] => {
            format!(
                "constraint {names} of {name} holds in any position: it is redundant and dropped"
            )
        }
        _ => format!(
            "{} constraints of {name} hold in any position: they are redundant and dropped: {names}",
            dropped.len()
        ),
    }
}

/// Returns the note about a constraint that is dropped because others imply it.
fn repeating_note(model: &Model, Lasting { constraint, repeats, .. }: &Lasting) -> String {
    format!(
        "constraint `{constraint}` of {} follows from {} everywhere: it is redundant and dropped, \
         and these carry its force unless `share_redundant` is set",
        model.name,
        quoted(repeats)
    )
}

/// Returns names in backquotes, with commas between them.
fn quoted<'a>(names: impl IntoIterator<Item = &'a String>) -> String {
    names.into_iter().map(|name| format!("`{name}`")).collect::<Vec<_>>().join(", ")
}

/// Remark on a scene that is derived all the same.
#[derive(Debug, Clone, PartialEq)]
pub enum Remark {
    /// Warning of its spec.
    Warning(Diagnostic),
    /// Note on its derivation.
    Note(String),
}

impl From<&Remark> for Trouble {
    fn from(remark: &Remark) -> Self {
        match remark {
            Remark::Warning(warning) => warning.into(),
            Remark::Note(note) => Self::note(note.clone()),
        }
    }
}

/// Remarks already shown by this process.
static SHOWN: Mutex<Vec<Remark>> = Mutex::new(Vec::new());

/// Shows a remark on standard error, once.
fn tell(remark: Remark) {
    let mut shown = SHOWN.lock().unwrap_or_else(PoisonError::into_inner);
    if shown.contains(&remark) {
        return;
    }
    match &remark {
        Remark::Warning(warning) => eprintln!("{:?}", Report::new(warning.clone())),
        Remark::Note(note) => eprintln!("machinist: {note}"),
    }
    shown.push(remark);
}

/// Shows warnings of a spec on standard error, each once.
pub fn warn(system: &LagrangianSystem) {
    warnings(system).for_each(tell);
}

fn warnings(system: &LagrangianSystem) -> impl Iterator<Item = Remark> {
    notes(system).chain(system.warnings.iter().cloned().map(Remark::Warning))
}

/// Returns the notes on a scene, which name it.
pub fn notes(system: &LagrangianSystem) -> impl Iterator<Item = Remark> {
    system.notes.iter().map(|note| Remark::Note(format!("{}: {note}", system.name)))
}

fn derived_as_asked(request: &Request, remark: &mut dyn FnMut(Remark)) -> Result<Stamped, Failure> {
    let mut derived = derive_with(std::slice::from_ref(request), remark)?;
    match derived.pop() {
        Some(Derived::Model(stamped)) => Ok(*stamped),
        _ => Err(broken("unexpected kind of answer")),
    }
}

/// Creates the failure of the derivation itself, not of the spec.
fn broken(how: &str) -> Failure {
    let help = "its messages are above; `machinist check` finds errors in a spec";
    Failure::unsuccessful(format!("the derivation failed: {how}"), help)
}

/// Derives a model for each request that has one.
pub fn possible(requests: &[Request]) -> Result<Vec<Option<Model>>, Failure> {
    let derived = derive(requests)?.into_iter().map(|derived| match derived {
        Derived::Model(stamped) => Ok(Some(stamped.model)),
        Derived::Impossible => Ok(None),
        Derived::Everything(_) => Err(broken("unexpected kind of answer")),
    });
    derived.collect()
}

/// Derives the models of scenes, to be emitted.
pub fn models(scenes: &[SpecSource], keep: Keep) -> Result<Vec<Model>, Failure> {
    let request =
        |scene: &SpecSource| Request { purpose: Purpose::Reading, ..Request::model(scene, keep) };
    let requests: Vec<Request> = scenes.iter().map(request).collect();
    let derived = derive(&requests)?.into_iter().map(|derived| match derived {
        Derived::Model(stamped) => Ok(stamped.model),
        _ => Err(broken("unexpected kind of answer")),
    });
    derived.collect()
}

/// Derives models and equations of scenes.
pub fn derivations(
    scenes: &[SpecSource],
    keep: Keep,
    purpose: Purpose,
) -> Result<Vec<Derivation>, Failure> {
    let wanted = Wanted::Everything;
    let request = |scene: &SpecSource| Request { wanted, purpose, ..Request::model(scene, keep) };
    let requests: Vec<Request> = scenes.iter().map(request).collect();
    let derived = derive(&requests)?.into_iter().map(|derived| match derived {
        Derived::Everything(derivation) => Ok(*derivation),
        _ => Err(broken("unexpected kind of answer")),
    });
    derived.collect()
}

/// Derives models and equations of a scene. Drops constraints that always follow from others, with a
/// note.
pub fn derivation(scene: &SpecSource, keep: Keep, purpose: Purpose) -> Result<Derivation, Failure> {
    let mut found = derivations(std::slice::from_ref(scene), keep, purpose)?;
    let whole = found.pop().ok_or_else(|| broken("nothing"))?;
    let dropped = to_drop(whole.stages.needed(), &mut tell);
    if dropped.is_empty() {
        return Ok(whole);
    }
    let request =
        Request { wanted: Wanted::Everything, purpose, dropped, ..Request::model(scene, keep) };
    match derive(&[request])?.pop() {
        Some(Derived::Everything(derivation)) => Ok(*derivation),
        _ => Err(broken("unexpected kind of answer")),
    }
}

/// Answers requests, and shows remarks on standard error.
fn derive(requests: &[Request]) -> Result<Vec<Derived>, Failure> {
    during("deriving", || derive_with(requests, &mut tell))
}

/// Answers requests in their order: from the cache if possible, otherwise by deriving here, or in
/// one child process if Symbolica derives them.
fn derive_with(
    requests: &[Request],
    remark: &mut dyn FnMut(Remark),
) -> Result<Vec<Derived>, Failure> {
    let cache = Cache::of_user();
    let systems = all(requests, Request::system)?;
    systems.iter().flat_map(warnings).for_each(remark);
    let asked = requests.iter().zip(systems).map(|(request, system)| {
        let algebra = request.purpose.algebra(&system);
        let key = cache::key(request, algebra, &system.files);
        let derived = cache.get(&key);
        Asked { request, system, algebra, key, derived }
    });
    let mut asked: Vec<Asked> = asked.collect();
    let (mut own, mut others) = (Vec::new(), Vec::new());
    for one in asked.iter_mut().filter(|one| one.derived.is_none()) {
        if one.algebra == Algebra::Plain { own.push(one) } else { others.push(one) }
    }
    derive_here(own, &cache)?;
    derive_by_child(others, &cache)?;
    asked.into_iter().map(|one| one.derived.ok_or_else(|| broken("too little"))).collect()
}

/// Request that awaits its answer.
struct Asked<'a> {
    request: &'a Request,
    /// System that was read.
    system: LagrangianSystem,
    algebra: Algebra,
    key: Key,
    derived: Option<Derived>,
}

/// Derives in this process, with Machinist's own algebra. A panic is reported as a failure.
fn derive_here(asked: Vec<&mut Asked>, cache: &Cache) -> Result<(), Failure> {
    let derived = all(&asked, |one| {
        let system = one.system.clone();
        let work = || one.request.derived_of(system, one.algebra);
        match catch_unwind(AssertUnwindSafe(work)) {
            Ok(derived) => derived.map(Some),
            Err(payload) if payload.is::<Interrupted>() => resume_unwind(payload),
            Err(_) => Ok(None),
        }
    })?;
    for (one, derived) in asked.into_iter().zip(derived) {
        let derived = derived.ok_or_else(|| broken("internal error"))?;
        cache.put(&one.key, &derived);
        one.derived = Some(derived);
    }
    Ok(())
}

/// Derives in a child process.
fn derive_by_child(asked: Vec<&mut Asked>, cache: &Cache) -> Result<(), Failure> {
    if asked.is_empty() {
        return Ok(());
    }
    let questions: Vec<_> = asked.iter().map(|one| (one.request, one.algebra)).collect();
    let answers = child::ask(&questions)?;
    for (one, answer) in asked.into_iter().zip(answers) {
        // A file may have changed in the meantime. The answer then describes what the child read,
        // and belongs to another key.
        let names = one.system.files.iter().map(|file| &file.sha256);
        if answer.files().is_some_and(|files| files.iter().map(|f| &f.sha256).eq(names)) {
            cache.put(&one.key, &answer);
        }
        one.derived = Some(answer);
    }
    Ok(())
}

impl Derived {
    /// Returns the files of the derivation.
    fn files(&self) -> Option<&[SourceFile]> {
        let model = match self {
            Derived::Model(stamped) => &stamped.model,
            Derived::Everything(derivation) => &derivation.stages.whole,
            Derived::Impossible => return None,
        };
        Some(&model.files)
    }

    /// Returns whether all models are valid.
    fn is_valid(&self) -> bool {
        match self {
            Derived::Model(stamped) => stamped.model.validate().is_ok(),
            Derived::Impossible => true,
            Derived::Everything(derivation) => {
                let steps = derivation.stages.steps.iter().map(|(_, model)| model);
                std::iter::once(&derivation.stages.whole)
                    .chain(steps)
                    .all(|model| model.validate().is_ok())
            }
        }
    }
}

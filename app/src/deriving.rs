//! What is derived of a scene: remembered, or derived in a process that ends at once.
//!
//! Symbolica may run in one process of a machine at a time, and keeps what it holds until
//! that process ends. So this process never derives: it reads the spec, looks for what was
//! derived of it before, and only then has a child of its own derive it.

mod cache;
mod child;

use std::sync::{Mutex, OnceLock, PoisonError};

use machinist::constraints::{self, Lasting};
use machinist_algebra::cas::Algebra;
use machinist_codegen::mechanics::reduce::Keep;
use machinist_codegen::pipeline::Derivation;
use machinist_codegen::scene::system::LagrangianSystem;
use machinist_codegen::spec::diagnostic::{Diagnostic, Diagnostics};
use machinist_model::file::Stamped;
use machinist_model::{Model, ModelSimulator, SourceFile};
use miette::Report;
use serde::{Deserialize, Serialize};

use crate::failure::{Failure, all};
use crate::progress::during;
use crate::spec_source::SpecSource;
use cache::Key;
pub use cache::{Cache, turn_off as turn_off_cache};
pub use child::{COMMAND, answer_parent, end_with_parent};

/// What is to be derived of a scene.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct Request {
    /// The scene.
    pub scene: SpecSource,
    /// How much of it is kept.
    pub keep: Keep,
    /// Instances to be taken for rigid instead of those that the scene names.
    pub rigid: Option<Vec<String>>,
    /// Only a model, or everything.
    pub wanted: Wanted,
    /// What works it out, if somebody said so.
    pub algebra: Option<Algebra>,
    /// Constraints to be dropped because they follow from others, each with the parameters that this
    /// needs as the spec has them.
    pub dropped: Vec<(String, Vec<String>)>,
}

/// What everything is worked out by from now on in this process.
static ALGEBRA: OnceLock<Algebra> = OnceLock::new();

/// Has everything worked out by an algebra; the first word holds.
pub fn work_out_by(algebra: Algebra) {
    let _ = ALGEBRA.set(algebra);
}

/// Whether somebody named the algebra. What is emitted is what the default one gives.
pub fn is_algebra_named() -> bool {
    ALGEBRA.get().is_some()
}

/// How much is wanted.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub enum Wanted {
    /// A model.
    Model,
    /// A model, or word that there is none.
    ModelIfPossible,
    /// Models step by step, and equations for people.
    Everything,
}

/// What was derived.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
enum Derived {
    Model(Box<Stamped>),
    /// There is no such model.
    Impossible,
    Everything(Box<Derivation>),
}

impl Request {
    /// A request for the model of a scene.
    pub fn model(scene: &SpecSource, keep: Keep) -> Self {
        let algebra = ALGEBRA.get().copied();
        let (rigid, wanted, dropped) = (None, Wanted::Model, Vec::new());
        Self { scene: scene.clone(), keep, rigid, wanted, algebra, dropped }
    }

    /// The system of the scene, as asked for.
    fn system(&self) -> Result<LagrangianSystem, Diagnostics> {
        let mut system = self.scene.system()?;
        if let Some(rigid) = &self.rigid {
            system.freeze.rigid.clone_from(rigid);
        }
        for (constraint, needs) in &self.dropped {
            system.drop_constraint(constraint, needs);
        }
        Ok(system)
    }
}

/// The model of a scene.
pub fn model(scene: &SpecSource, keep: Keep) -> Result<Model, Failure> {
    Ok(stamped(&Request::model(scene, keep))?.model)
}

/// The model of a request, with word of what made it; without constraints that follow from others
/// wherever the machine goes, of which it says so.
pub fn stamped(request: &Request) -> Result<Stamped, Failure> {
    let whole = derived_as_asked(request)?;
    let lasting = repeated(&whole.model);
    if lasting.is_empty() {
        return Ok(whole);
    }
    for one in &lasting {
        tell_once(dropped_note(&whole.model, one));
    }
    let dropped = lasting.into_iter().map(|one| (one.constraint, one.needs)).collect();
    derived_as_asked(&Request { dropped, ..request.clone() })
}

/// Constraints that follow from others wherever the machine goes.
pub fn repeated(model: &Model) -> Vec<Lasting> {
    if model.constraints.is_empty() || !model.fields.is_empty() {
        return Vec::new();
    }
    let parameters: Vec<f64> = model.all_parameters().map(|one| one.value).collect();
    let simulator = ModelSimulator::new(model.clone());
    constraints::lasting(&simulator, &parameters, model.run.from)
}

/// What is said of such a constraint when it is dropped.
pub fn dropped_note(model: &Model, Lasting { constraint, repeats, .. }: &Lasting) -> String {
    let others: Vec<String> = repeats.iter().map(|name| format!("`{name}`")).collect();
    format!(
        "constraint `{constraint}` of {} follows from {} wherever the machine goes: it is \
         dropped, and these carry its force",
        model.name,
        others.join(", ")
    )
}

/// Notes that were shown by this process.
static TOLD: Mutex<Vec<String>> = Mutex::new(Vec::new());

fn tell_once(note: String) {
    let mut told = TOLD.lock().unwrap_or_else(PoisonError::into_inner);
    if !told.contains(&note) {
        eprintln!("machinist: {note}");
        told.push(note);
    }
}

fn derived_as_asked(request: &Request) -> Result<Stamped, Failure> {
    let mut derived = derive(std::slice::from_ref(request))?;
    match derived.pop() {
        Some(Derived::Model(stamped)) => Ok(*stamped),
        _ => Err(child::broken("another thing than was asked for")),
    }
}

/// A model for each request that can be fulfilled.
pub fn possible(requests: &[Request]) -> Result<Vec<Option<Model>>, Failure> {
    let derived = derive(requests)?.into_iter().map(|derived| match derived {
        Derived::Model(stamped) => Ok(Some(stamped.model)),
        Derived::Impossible => Ok(None),
        Derived::Everything(_) => Err(child::broken("more than was asked for")),
    });
    derived.collect()
}

/// The models of scenes.
pub fn models(scenes: &[SpecSource], keep: Keep) -> Result<Vec<Model>, Failure> {
    let requests: Vec<Request> = scenes.iter().map(|scene| Request::model(scene, keep)).collect();
    let derived = derive(&requests)?.into_iter().map(|derived| match derived {
        Derived::Model(stamped) => Ok(stamped.model),
        _ => Err(child::broken("another thing than was asked for")),
    });
    derived.collect()
}

/// Everything that is derived of scenes.
pub fn derivations(scenes: &[SpecSource], keep: Keep) -> Result<Vec<Derivation>, Failure> {
    let request =
        |scene: &SpecSource| Request { wanted: Wanted::Everything, ..Request::model(scene, keep) };
    let requests: Vec<Request> = scenes.iter().map(request).collect();
    let derived = derive(&requests)?.into_iter().map(|derived| match derived {
        Derived::Everything(derivation) => Ok(*derivation),
        _ => Err(child::broken("less than was asked for")),
    });
    derived.collect()
}

/// Everything that is derived of a scene.
pub fn derivation(scene: &SpecSource, keep: Keep) -> Result<Derivation, Failure> {
    let mut derivations = derivations(std::slice::from_ref(scene), keep)?;
    derivations.pop().ok_or_else(|| child::broken("nothing"))
}

/// Warnings that were shown by this process.
static SHOWN: Mutex<Vec<Diagnostic>> = Mutex::new(Vec::new());

/// Shows warnings of a spec on standard error, each once.
pub fn warn(system: &LagrangianSystem) {
    let mut shown = SHOWN.lock().unwrap_or_else(PoisonError::into_inner);
    for warning in &system.warnings {
        if !shown.contains(warning) {
            shown.push(warning.clone());
            eprintln!("{:?}", Report::new(warning.clone()));
        }
    }
}

/// Answers requests, in their order: from the cache where it has them, by one child that
/// derives all others.
fn derive(requests: &[Request]) -> Result<Vec<Derived>, Failure> {
    let cache = Cache::of_user();
    let systems = all(requests, Request::system)?;
    systems.iter().for_each(warn);
    let read: Vec<_> = systems.into_iter().map(|system| system.files).collect();
    let keys: Vec<Key> =
        requests.iter().zip(&read).map(|(request, files)| cache::key(request, files)).collect();
    let mut derived: Vec<Option<Derived>> = keys.iter().map(|key| cache.get(key)).collect();
    let missing: Vec<usize> = (0..requests.len()).filter(|at| derived[*at].is_none()).collect();
    if !missing.is_empty() {
        let asked: Vec<&Request> = missing.iter().map(|at| &requests[*at]).collect();
        let answers = during("deriving", || child::ask(&asked))?;
        for (at, answer) in missing.into_iter().zip(answers) {
            // A file may have changed since it was looked at: the answer is of what the child
            // read, and belongs to another key.
            let names = read[at].iter().map(|file| &file.sha256);
            if answer.files().is_some_and(|files| files.iter().map(|f| &f.sha256).eq(names)) {
                cache.put(&keys[at], &answer);
            }
            derived[at] = Some(answer);
        }
    }
    derived.into_iter().map(|derived| derived.ok_or_else(|| child::broken("too little"))).collect()
}

impl Derived {
    /// The files it was derived from.
    fn files(&self) -> Option<&[SourceFile]> {
        let model = match self {
            Derived::Model(stamped) => &stamped.model,
            Derived::Everything(derivation) => &derivation.stages.whole,
            Derived::Impossible => return None,
        };
        Some(&model.files)
    }

    /// Whether all its models keep the rules of models.
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

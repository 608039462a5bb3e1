//! Custom machines for tests of the runtime: from a spec to a simulator.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, OnceLock};

use machinist::FieldSimulator;
use machinist::constraints::lasting;
use machinist::field::Discretisation;
use machinist_codegen::mechanics::reduce::Keep;
use machinist_codegen::pipeline;
use machinist_codegen::scene::system::LagrangianSystem;
use machinist_contract::Describe;
use machinist_model::{Model, ModelSimulator};

#[path = "common/specs.rs"]
mod specs;

pub use specs::specs_in;

/// Returns the folder `specs/scenes`.
pub fn folder_of_specs() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../specs/scenes")
}

/// Returns the scenes for a test: some by default, or all if an environment variable is `all`.
pub fn scenes_to_try(variable: &str, some: &[&str]) -> Vec<String> {
    if std::env::var(variable).is_ok_and(|which| which == "all") {
        let folder = folder_of_specs();
        let name = |path: PathBuf| {
            let path = path.strip_prefix(&folder).expect("within").with_extension("");
            path.to_str().expect("a name").to_owned()
        };
        return specs_in(&folder).into_iter().map(name).collect();
    }
    some.iter().map(|name| (*name).to_owned()).collect()
}

/// Models of scenes of the folder `specs/scenes` that tests have requested.
type Derived = BTreeMap<(String, Keep), Arc<OnceLock<Model>>>;
static DERIVED: Mutex<Derived> = Mutex::new(Derived::new());

/// Returns the model of a scene of the folder `specs/scenes`, such as `msl/first`. It is derived
/// once for all tests.
pub fn model_of_specs(name: &str, keep: Keep) -> Model {
    let key = (name.to_owned(), keep);
    let model = Arc::clone(DERIVED.lock().expect("models").entry(key).or_default());
    model.get_or_init(|| as_run(&folder_of_specs().join(format!("{name}.toml")), keep)).clone()
}

/// Returns that model with its fields divided, as it is emitted as C99.
pub fn whole_model_of_specs(name: &str, keep: Keep) -> Model {
    let model = model_of_specs(name, keep);
    if model.fields.is_empty() { model } else { divided(&model, Discretisation::default()) }
}

/// Returns a model with its fields divided into elements.
pub fn divided(model: &Model, wanted: Discretisation) -> Model {
    let simulator = ModelSimulator::interpreted(model.clone());
    let cut = FieldSimulator::new(simulator.with_fields(), wanted).expect("a division");
    let p: Vec<f64> = model.parameters.iter().map(|parameter| parameter.value).collect();
    model.divided_completely(&cut.divisions(&p)).expect("a whole machine")
}

/// Returns that scene as a simulator.
pub fn of_specs(name: &str, keep: Keep) -> ModelSimulator {
    ModelSimulator::new(model_of_specs(name, keep))
}

/// Returns the scene of a spec in one file.
pub fn of_text(text: &str, keep: Keep) -> ModelSimulator {
    of_files(&[("scene.toml", text)], keep)
}

/// Returns the scene of the first of some files in one folder.
pub fn of_files(files: &[(&str, &str)], keep: Keep) -> ModelSimulator {
    let folder = written(files);
    ModelSimulator::new(of_path(&folder.path().join(files[0].0), keep))
}

/// Returns the system of a spec in one file.
pub fn system_of(text: &str) -> LagrangianSystem {
    let folder = written(&[("scene.toml", text)]);
    let checked = pipeline::check(&folder.path().join("scene.toml"));
    checked.unwrap_or_else(|errors| panic!("{}", errors.render()))
}

/// Returns the message for a refused spec in one file.
pub fn refusal(text: &str) -> String {
    let folder = written(&[("scene.toml", text)]);
    let refused = pipeline::generate(&folder.path().join("scene.toml"), Keep::Needed);
    let said = refused.expect_err("it is refused").render().replace('│', " ");
    said.split_whitespace().collect::<Vec<_>>().join(" ")
}

fn written(files: &[(&str, &str)]) -> tempfile::TempDir {
    let folder = tempfile::tempdir().expect("a folder");
    for (name, text) in files {
        std::fs::write(folder.path().join(name), text).expect("written");
    }
    folder
}

/// Returns the model of a scene without constraints that always repeat others, as the program runs
/// it.
fn as_run(path: &Path, keep: Keep) -> Model {
    let model = of_path(path, keep);
    if !model.fields.is_empty() {
        return model;
    }
    let whole = ModelSimulator::interpreted(model.clone());
    let parameters: Vec<f64> =
        (0..whole.shape().parameters).map(|index| whole.parameter_default(index)).collect();
    let dropped = lasting(&whole, &parameters, 0.0);
    if dropped.is_empty() {
        return model;
    }
    let checked = pipeline::check(path);
    let mut system = checked.unwrap_or_else(|errors| panic!("{}", errors.render()));
    for one in &dropped {
        system.drop_constraint(&one.constraint, &one.needs);
    }
    pipeline::compile(system, keep).unwrap_or_else(|errors| panic!("{}", errors.render()))
}

fn of_path(path: &Path, keep: Keep) -> Model {
    pipeline::generate(path, keep).unwrap_or_else(|errors| panic!("{}", errors.render()))
}

//! Lookup of a scene by its argument: a built-in simulator, a spec or a model file.

use std::fs::{self, File};
use std::io::Read as _;
use std::path::{MAIN_SEPARATOR, Path, PathBuf};

use crate::failure::did_you_mean;
use machinist::field::{Discretisation, FieldError, FieldSimulator};
#[cfg(feature = "derive")]
use machinist_codegen::mechanics::reduce::Keep;
use machinist_contract::Simulator;
use machinist_model::file::{MARK, Stamped, read};
use machinist_model::{Model, ModelSimulator, Running};
use machinist_scenes::scenes;
use machinist_studies::double_double::{Twin, precise};

use super::arguments::Code;
#[cfg(feature = "derive")]
use crate::deriving::{self, Request};
use crate::failure::{ErrorCode, Failure};
#[cfg(feature = "derive")]
use crate::freeze::admit;
use crate::spec_source::SpecSource;

/// Source that an argument stands for.
pub enum SceneSource {
    /// Spec.
    Spec(SpecSource),
    /// Content of a model file.
    Model(Box<Stamped>),
}

impl SceneSource {
    /// Resolves an argument: a file of either kind, or the spec of a name.
    pub fn of(argument: &str) -> Result<Self, Failure> {
        let path = match spec_of(argument)? {
            SpecSource::File(path) => path,
            built_in @ SpecSource::BuiltIn(_) => return Ok(Self::Spec(built_in)),
        };
        let mut mark = [0; MARK.len()];
        let begins_as_model = File::open(&path)
            .and_then(|mut file| file.read_exact(&mut mark))
            .is_ok_and(|()| mark == *MARK);
        if !begins_as_model {
            return Ok(Self::Spec(SpecSource::File(path)));
        }
        let bytes = fs::read(&path).map_err(|error| Failure::file(&path, &error))?;
        let stamped = read(&bytes).map_err(|error| {
            let help = "compile it again from its spec with `machinist compile`";
            Failure::at(path.display(), error, help)
        })?;
        Ok(Self::Model(Box::new(stamped)))
    }
}

/// Scene ready to run.
pub enum Scene {
    /// Built-in simulator.
    Emitted(&'static dyn Simulator<f64>),
    /// Model, derived or read from a file.
    Model(Box<ModelSimulator>),
    /// Scene with fields.
    Fields(Cut),
}

/// Scene with fields, discretized into elements.
pub struct Cut {
    simulator: Box<FieldSimulator<'static, f64>>,
    of: Uncut,
    wanted: Discretisation,
}

/// Scene with fields before discretization, shared by threads.
#[derive(Clone, Copy)]
enum Uncut {
    /// Name of a built-in scene.
    BuiltIn(&'static str),
    /// Model, leaked because a command loads only one scene.
    Model(&'static ModelSimulator),
}

impl Uncut {
    fn cut(self, wanted: Discretisation) -> Result<FieldSimulator<'static, f64>, FieldError> {
        match self {
            Self::BuiltIn(name) => {
                let scene = scenes::find_field_f64(name).expect("it was found by this name before");
                let cut = FieldSimulator::new(scene, wanted)?;
                Ok(match scenes::find_field_duals(name) {
                    Some(scene) => cut.with_derivatives(scene),
                    None => cut,
                })
            }
            Self::Model(simulator) => {
                let cut = FieldSimulator::new(simulator.with_fields(), wanted)?;
                Ok(cut.with_derivatives(simulator.with_fields_on_duals()))
            }
        }
    }
}

impl Cut {
    fn new(of: Uncut, wanted: Discretisation) -> Result<Self, Failure> {
        let simulator = Box::new(of.cut(wanted).map_err(|error| refused(&error))?);
        Ok(Self { simulator, of, wanted })
    }

    /// Returns a function that discretizes the scene again, for threads that each need their own.
    pub fn again(
        &self,
    ) -> impl Fn() -> Result<FieldSimulator<'static, f64>, FieldError> + Sync + use<> {
        let (of, wanted) = (self.of, self.wanted);
        move || of.cut(wanted)
    }
}

/// Form in which a scene is loaded.
#[derive(Debug, Clone, Copy, Default)]
pub struct Loading {
    /// True to keep what no output needs; the spec is then always derived.
    pub keep_all: bool,
    /// Discretization of fields.
    pub wanted: Discretisation,
    /// Form of the equations; the spec is then always derived.
    pub code: Option<Code>,
    /// True for machine code from the first call on, for measuring times.
    pub is_timed: bool,
}

impl Loading {
    /// Returns the simulator of a model.
    pub fn simulator(&self, model: Model) -> Result<ModelSimulator, Failure> {
        match self.code {
            None if self.is_timed => Ok(ModelSimulator::compiled_at_once(model)),
            None => Ok(ModelSimulator::new(model)),
            Some(Code::Interpreted) => Ok(ModelSimulator::interpreted(model)),
            Some(Code::Compiled) => {
                let simulator = ModelSimulator::compiled_at_once(model);
                if simulator.running() == Running::Interpreted {
                    let message = "models cannot be JIT-compiled on this computer";
                    return Err(Failure::input(message, "leave `--code compiled` out"));
                }
                Ok(simulator)
            }
        }
    }

    /// Returns the scene of a model.
    fn scene(&self, model: Model) -> Result<Scene, Failure> {
        let has_fields = !model.fields.is_empty();
        let simulator = Box::new(self.simulator(model)?);
        if !has_fields {
            return without_fields(self.wanted, Scene::Model(simulator));
        }
        Cut::new(Uncut::Model(Box::leak(simulator)), self.wanted).map(Scene::Fields)
    }
}

impl Scene {
    /// Loads the scene of a name, a spec or a model file. A name that is not built in may be that
    /// of a spec.
    pub fn load(argument: &str, loading: &Loading) -> Result<Self, Failure> {
        let is_named = !loading.keep_all && loading.code.is_none() && !is_path(argument);
        let mut of_fields = scenes::FIELD_NAMES.iter();
        if is_named && let Some(name) = of_fields.find(|name| **name == argument) {
            return Cut::new(Uncut::BuiltIn(name), loading.wanted).map(Self::Fields);
        }
        if is_named && let Some(simulator) = built_in(argument) {
            return without_fields(loading.wanted, Self::Emitted(simulator));
        }
        loading.scene(match SceneSource::of(argument)? {
            SceneSource::Model(_) if loading.keep_all => return Err(already_reduced(argument)),
            SceneSource::Model(stamped) => stamped.model,
            SceneSource::Spec(source) => derived(&source, loading.keep_all)?,
        })
    }

    /// Derives the scene with a parameter for a test force on each of these coordinates; `None` for
    /// a model file or in a build that does not derive.
    #[cfg(feature = "derive")]
    pub fn load_with_forces(
        argument: &str,
        loading: &Loading,
        coordinates: Vec<String>,
    ) -> Result<Option<Self>, Failure> {
        let SceneSource::Spec(source) = SceneSource::of(argument)? else { return Ok(None) };
        let keep = if loading.keep_all { Keep::All } else { Keep::Needed };
        let request = Request { test_forces: coordinates, ..Request::model(&source, keep) };
        loading.scene(deriving::stamped(&request)?.model).map(Some)
    }

    /// Returns `None`, because this build does not derive.
    #[cfg(not(feature = "derive"))]
    #[expect(clippy::unnecessary_wraps, reason = "as in a build that derives")]
    pub fn load_with_forces(_: &str, _: &Loading, _: Vec<String>) -> Result<Option<Self>, Failure> {
        Ok(None)
    }

    /// Derives the scene with parameters in place of those names that are inputs of units. Returns
    /// it with the names of the parameters; `None` if no name is an input.
    #[cfg(feature = "derive")]
    pub fn load_opened(
        argument: &str,
        loading: &Loading,
        names: &[&str],
    ) -> Result<Option<(Self, Vec<String>)>, Failure> {
        let Some((stamped, parameters)) = with_inputs(argument, loading.keep_all, names)? else {
            return Ok(None);
        };
        let scene = loading.scene(stamped.model)?;
        Ok(Some((scene, parameters)))
    }

    /// Returns `None`, because this build does not derive.
    #[cfg(not(feature = "derive"))]
    #[expect(clippy::unnecessary_wraps, reason = "as in a build that derives")]
    pub fn load_opened(
        _: &str,
        _: &Loading,
        _: &[&str],
    ) -> Result<Option<(Self, Vec<String>)>, Failure> {
        Ok(None)
    }

    /// Returns the simulator.
    pub fn simulator(&self) -> &dyn Simulator<f64> {
        match self {
            Self::Emitted(simulator) => *simulator,
            Self::Model(simulator) => simulator.single(),
            Self::Fields(cut) => cut.simulator.single(),
        }
    }

    /// Returns whether the scene is emitted code.
    pub fn is_emitted(&self) -> bool {
        match self {
            Self::Emitted(_) | Self::Fields(Cut { of: Uncut::BuiltIn(_), .. }) => true,
            Self::Model(_) | Self::Fields(Cut { of: Uncut::Model(_), .. }) => false,
        }
    }

    /// Returns the same emitted code with numbers of 31 digits.
    pub fn twin(&self) -> Option<&'static dyn Twin> {
        match self {
            Self::Emitted(simulator) => precise(simulator.name()),
            Self::Model(_) | Self::Fields(..) => None,
        }
    }

    /// Describes for people how the scene runs.
    pub fn how(&self) -> &'static str {
        let running = match self {
            Self::Emitted(_) | Self::Fields(Cut { of: Uncut::BuiltIn(_), .. }) => None,
            Self::Model(simulator) => Some(simulator.running()),
            Self::Fields(Cut { of: Uncut::Model(simulator), .. }) => Some(simulator.running()),
        };
        match running {
            None => "emitted code",
            Some(Running::Compiled | Running::CompiledAtOnce) => "JIT-compiled",
            Some(Running::Interpreted) => "interpreted",
        }
    }
}

/// Derives the model of a spec.
#[cfg(feature = "derive")]
pub fn derived(source: &SpecSource, keep_all: bool) -> Result<Model, Failure> {
    Ok(derived_stamped(source, keep_all)?.model)
}

/// Like [`derived`], with the generator that made the model.
#[cfg(feature = "derive")]
pub fn derived_stamped(source: &SpecSource, keep_all: bool) -> Result<Stamped, Failure> {
    let keep = if keep_all { Keep::All } else { Keep::Needed };
    let stamped = deriving::stamped(&Request::model(source, keep))?;
    if !keep_all {
        admit(source, &stamped.model)?;
    }
    Ok(stamped)
}

/// Returns the model of a spec or of a model file. A model file is already reduced.
#[cfg(feature = "derive")]
pub fn stamped(argument: &str, keep_all: bool) -> Result<Stamped, Failure> {
    match SceneSource::of(argument)? {
        SceneSource::Model(_) if keep_all => Err(already_reduced(argument)),
        SceneSource::Model(stamped) => Ok(*stamped),
        SceneSource::Spec(source) => derived_stamped(&source, keep_all),
    }
}

/// Returns the model of a spec or of a model file with parameters in place of those names that are
/// inputs of units, and the names of the parameters.
#[cfg(feature = "derive")]
pub fn stamped_opened(
    argument: &str,
    keep_all: bool,
    names: &[String],
) -> Result<(Stamped, Vec<String>), Failure> {
    let inputs: Vec<&str> = names.iter().map(String::as_str).collect();
    if let Some(opened) = with_inputs(argument, keep_all, &inputs)? {
        return Ok(opened);
    }
    Ok((stamped(argument, keep_all)?, names.to_owned()))
}

/// Derives a spec with parameters in place of those names that are inputs of units. Returns the
/// model with the names of the parameters; `None` if no name is an input, or for a model file.
#[cfg(feature = "derive")]
fn with_inputs(
    argument: &str,
    keep_all: bool,
    names: &[&str],
) -> Result<Option<(Stamped, Vec<String>)>, Failure> {
    let SceneSource::Spec(source) = SceneSource::of(argument)? else { return Ok(None) };
    let Some((opened, parameters)) = opened(&source, names)? else { return Ok(None) };
    let keep = if keep_all { Keep::All } else { Keep::Needed };
    let request = Request { opened, ..Request::model(&source, keep) };
    Ok(Some((deriving::stamped(&request)?, parameters)))
}

/// Names that are inputs of units, and all names with the parameters that stand for these.
#[cfg(feature = "derive")]
type Opened = (Vec<String>, Vec<String>);

/// Returns the inputs of units among names; `None` if no name is an input.
#[cfg(feature = "derive")]
fn opened(source: &SpecSource, names: &[&str]) -> Result<Option<Opened>, Failure> {
    let mut spec = source.read()?;
    let mut inputs = Vec::new();
    let parameters = names.iter().map(|name| {
        let parameter = spec.open_input(name);
        if parameter.is_some() {
            inputs.push((*name).to_owned());
        }
        parameter.unwrap_or_else(|| (*name).to_owned())
    });
    let parameters = parameters.collect();
    Ok((!inputs.is_empty()).then_some((inputs, parameters)))
}

/// Creates the error for a model file whose scene is to be kept whole.
pub fn already_reduced(argument: &str) -> Failure {
    Failure::input(format!("{argument} is already a model"), "leave `--keep-all` out")
}

/// Returns an error, because this build reads no specs.
#[cfg(not(feature = "derive"))]
fn derived(source: &SpecSource, _keep_all: bool) -> Result<Model, Failure> {
    Err(cannot_derive(source))
}

/// Creates the error for a spec in a build that reads none.
#[cfg(not(feature = "derive"))]
pub fn cannot_derive(source: &SpecSource) -> Failure {
    let message = format!("{source}: this program was built without the feature `derive`");
    Failure::coded(
        ErrorCode::NotBuiltIn,
        message,
        "give a model file, written by `machinist compile` of a full build",
    )
}

/// Hint for fields that cannot be discretized as wanted.
pub const CUTTING: &str =
    "`--elements` and `--order` override the discretization of fields in the spec";

/// Creates the failure of fields that cannot be discretized as wanted.
pub fn refused(error: &FieldError) -> Failure {
    Failure::input(error, CUTTING)
}

/// Returns a scene without fields, or an error if they are to be discretized.
fn without_fields(wanted: Discretisation, scene: Scene) -> Result<Scene, Failure> {
    require_no_cut(wanted, scene.simulator().name())?;
    Ok(scene)
}

/// Returns an error if the fields of a scene are to be discretized that has none.
pub fn require_no_cut(wanted: Discretisation, scene: &str) -> Result<(), Failure> {
    if wanted == Discretisation::default() {
        return Ok(());
    }
    let message = format!("scene `{scene}` has no fields");
    Err(Failure::input(message, "leave `--elements` and `--order` out"))
}

/// Returns the emitted simulator of a name.
pub fn built_in(name: &str) -> Option<&'static dyn Simulator<f64>> {
    scenes::find_f64(name)
}

/// Folder of scenes.
pub const SCENES: &str = "specs/scenes";
/// Subfolders of machines of standard parts.
pub const DRIVES: &str = "drives";
const GALLERY: &str = "gallery";
/// Subfolder of scenes for benchmarks.
pub const BENCH: &str = "bench";

/// Returns the spec of a name or a path. A name is searched in the specs of the current folder,
/// then among the built-in ones.
pub fn spec_of(argument: &str) -> Result<SpecSource, Failure> {
    if is_path(argument) {
        return Ok(SpecSource::File(PathBuf::from(argument)));
    }
    let file = format!("{argument}.toml");
    let folders = ["", BENCH, DRIVES, GALLERY].into_iter();
    let mut places = folders.map(|folder| Path::new(SCENES).join(folder).join(&file));
    if let Some(found) = places.find(|place| place.is_file()) {
        return Ok(SpecSource::File(found));
    }
    if has_built_in_spec(argument) {
        return Ok(SpecSource::BuiltIn(argument.to_owned()));
    }
    Err(unknown(argument))
}

#[cfg(feature = "derive")]
fn has_built_in_spec(name: &str) -> bool {
    machinist_codegen::spec::library::LibraryScene::find(name).is_some()
}

/// Returns whether a simulator is built in, because this build has no specs.
#[cfg(not(feature = "derive"))]
fn has_built_in_spec(name: &str) -> bool {
    scenes::NAMES.contains(&name) || scenes::FIELD_NAMES.contains(&name)
}

/// Returns the machines of standard parts whose specs are built in, by name and title.
#[cfg(feature = "derive")]
pub fn machines() -> impl Iterator<Item = [&'static str; 2]> + Clone {
    let title = |text: &'static str| {
        let line = text.lines().find_map(|line| line.strip_prefix("title = \""));
        line.and_then(|line| line.strip_suffix('"')).unwrap_or_default()
    };
    machinist_codegen::spec::library::MACHINES
        .iter()
        .map(move |machine| [machine.name, title(machine.text)])
}

/// This build has no specs.
#[cfg(not(feature = "derive"))]
pub fn machines() -> impl Iterator<Item = [&'static str; 2]> + Clone {
    std::iter::empty()
}

/// Extension of model files.
pub const MODEL_ENDING: &str = "model";

/// Returns whether an argument is meant as a path rather than as a name.
fn is_path(argument: &str) -> bool {
    let ending = Path::new(argument).extension();
    ending.is_some_and(|ending| ending == "toml" || ending == MODEL_ENDING)
        || argument.contains(['/', MAIN_SEPARATOR])
}

fn unknown(name: &str) -> Failure {
    let message = format!("there is no scene `{}`", name.escape_debug());
    let file = format!("{name}.toml");
    if Path::new(&file).is_file() {
        return Failure::coded(
            ErrorCode::UnknownName,
            message,
            format!("there is a file of this name: write `{file}`"),
        );
    }
    let names = scenes::NAMES.iter().chain(scenes::FIELD_NAMES).copied();
    let hint = did_you_mean(name, names.chain(machines().map(|[name, _]| name)));
    let help = format!(
        "{hint}\n`machinist list` shows all scenes; a path that ends in `.toml` names a scene file"
    );
    Failure::coded(ErrorCode::UnknownName, message, help.trim_start())
}

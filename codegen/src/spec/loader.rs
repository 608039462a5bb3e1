//! Loading of a scene and of everything it refers to.

use std::collections::HashMap;
use std::path::{Path, PathBuf};

use crate::spec::code::Code;
use crate::spec::diagnostic::{Diagnostics, FileId, Mistake, Spanned};
use crate::spec::fields::Findings;
use crate::spec::library::{LIBRARY, LibraryScene};
use crate::spec::names::quoted;
use crate::spec::scene;
use crate::spec::source::{Sources, folder_of};
use crate::spec::{
    Inside, InstanceSpec, InstanceText, JointSpec, SceneSpec, UnitSpec, connect, table, toml, unit,
};

/// Similarity of names beyond which one is taken as a misspelling of the other.
const ALIKE: f64 = 0.85;
/// Maximum number of instances of a scene, including all inner ones.
const MOST_INSTANCES: usize = 20_000;

pub(super) fn load(path: &Path) -> Result<SceneSpec, Diagnostics> {
    let mut sources = Sources::beside(path);
    let file = sources.read(path)?;
    read(sources, file, Some(folder_of(path)))
}

/// Loads a scene that comes with Machinist, as do its units.
pub(super) fn load_library(scene: &LibraryScene) -> Result<SceneSpec, Diagnostics> {
    let mut sources = Sources::default();
    let file = sources.embed(scene.label, scene.text);
    read(sources, file, None)
}

fn read(sources: Sources, file: FileId, folder: Option<&Path>) -> Result<SceneSpec, Diagnostics> {
    let text = sources.get(file).text.clone();
    let tree = toml::parse(&text, file).map_err(|mistake| sources.diagnostics(&[mistake]))?;
    let mut found = Findings::default();
    let mut scene = scene::read(&tree, file, &mut found);
    let mut loader = Loader {
        sources,
        found,
        folder,
        scene: file,
        define: std::mem::take(&mut scene.define),
        units: Vec::new(),
        known: HashMap::new(),
        instances: Vec::new(),
        joints: Vec::new(),
    };
    let inside = std::mem::take(&mut scene.inside);
    loader.open(&inside, None, &mut Vec::new());
    let Loader { mut sources, mut found, units, instances, joints, .. } = loader;
    let mut forces = scene.forces;
    let joints = connect::ports_of(&units, &instances, joints, &mut forces, &mut found.mistakes);
    let tables = table::read_all(&found.tables, &mut sources, &mut found.mistakes);
    match (scene.header, scene.run) {
        (Some(header), Some(run)) if found.mistakes.is_empty() => Ok(SceneSpec {
            sources,
            name: header.name,
            title: header.title,
            doc: header.doc,
            source: header.source,
            shares_redundant: header.shares_redundant,
            units,
            instances,
            joints,
            parameters: scene.parameters,
            scatter: scene.scatter,
            correlations: scene.correlations,
            helpers: scene.helpers,
            states: scene.states,
            energy: scene.energy,
            power: scene.power,
            forces,
            events: scene.events,
            constraints: scene.constraints,
            frictions: scene.frictions,
            initial: inside.initial,
            starts_in_equilibrium: scene.starts_in_equilibrium,
            guess: inside.guess,
            outputs: scene.outputs,
            checks: scene.checks,
            tunable: scene.tunable,
            rigid: scene.rigid,
            freeze_tolerance: scene.freeze_tolerance,
            run,
            tables,
        }),
        _ => Err(sources.diagnostics(&found.mistakes)),
    }
}

/// Marks a failure whose mistake has been recorded.
struct Refused;

struct Loader<'a> {
    sources: Sources,
    found: Findings,
    /// The folder in which units are searched besides the library.
    folder: Option<&'a Path>,
    /// The scene's own file.
    scene: FileId,
    /// The units that the scene defines.
    define: Vec<UnitSpec>,
    units: Vec<UnitSpec>,
    /// Units by name; true selects only units that come with Machinist.
    known: HashMap<(bool, String), Option<usize>>,
    instances: Vec<InstanceSpec>,
    joints: Vec<JointSpec>,
}

impl Loader<'_> {
    /// Adds the contents of the scene, or of an assembly: `within` is its instance, and `trail`
    /// lists the units that enclose it.
    fn open(&mut self, inside: &Inside, within: Option<usize>, trail: &mut Vec<usize>) {
        let prefix =
            within.map_or(String::new(), |at| format!("{}.", self.instances[at].name.value));
        for text in &inside.instances {
            // Units that come with Machinist consist of such units too, whatever other unit has
            // the name.
            let by_library = trail.last().is_some_and(|unit| self.is_library(*unit));
            let Some(unit) = self.unit_of(&text.unit, by_library) else { continue };
            if trail.contains(&unit) {
                self.refuse_cycle(text, unit, trail);
                continue;
            }
            if self.instances.len() >= MOST_INSTANCES {
                let message = format!("a scene has at most {MOST_INSTANCES} instances");
                let mistake =
                    Mistake::new(Code::TooLarge, text.name.span, message, "too many from here on");
                self.found.mistakes.push(mistake);
                return;
            }
            let name = format!("{prefix}{}", text.name.value);
            let at = self.instances.len();
            self.instances.push(InstanceSpec {
                name: Spanned { value: name, span: text.name.span },
                parent: within,
                unit,
                parameters: text.parameters.clone(),
                tolerances: text.tolerances.clone(),
                inputs: text.inputs.clone(),
                fields: text.fields.clone(),
            });
            if self.units[unit].is_assembly() {
                let inside = self.units[unit].inside.clone();
                trail.push(unit);
                self.open(&inside, Some(at), trail);
                trail.pop();
            }
        }
        self.joints.extend(inside.joints.iter().map(|joint| JointSpec {
            connect:
                joint.connect.each_ref().map(|port| Spanned {
                    value: format!("{prefix}{}", port.value),
                    span: port.span,
                }),
            ratio: joint.ratio.clone(),
            within,
        }));
    }

    fn refuse_cycle(&mut self, text: &InstanceText, unit: usize, trail: &[usize]) {
        let from = trail.iter().position(|known| *known == unit).unwrap_or(0);
        let names = trail[from..].iter().chain([&unit]).map(|unit| quoted(&self.units[*unit].name));
        let names: Vec<String> = names.collect();
        let message = format!("unit {} contains itself", names[0]);
        let help = format!("one inside the other: {}", names.join(", "));
        self.found.mistakes.push(
            Mistake::new(Code::CyclicDefinition, text.unit.span, message, "again").help(help),
        );
    }

    /// Reports whether a unit comes with Machinist. Units of the scene's own file do not.
    fn is_library(&self, unit: usize) -> bool {
        let file = self.units[unit].file;
        file != self.scene && self.sources.get(file).file.path.as_os_str().is_empty()
    }

    /// Returns the unit of a name. Each is read once.
    fn unit_of(&mut self, name: &Spanned<String>, by_library: bool) -> Option<usize> {
        let key = (by_library, name.value.clone());
        if let Some(known) = self.known.get(&key) {
            return *known;
        }
        let own = if by_library { Ok(None) } else { self.find_own(name) };
        let found = match own {
            Ok(Some(unit)) => {
                self.units.push(unit);
                Some(self.units.len() - 1)
            }
            Ok(None) => self.of_library(name),
            Err(Refused) => None,
        };
        self.known.insert(key, found);
        found
    }

    /// Finds a unit that the scene defines, or in a file beside it.
    fn find_own(&mut self, name: &Spanned<String>) -> Result<Option<UnitSpec>, Refused> {
        if let Some(unit) = self.define.iter().find(|unit| unit.name == name.value) {
            return Ok(Some(unit.clone()));
        }
        let file_name = format!("{}.toml", name.value);
        for folder in self.unit_folders() {
            let path = folder.join(&file_name);
            if std::fs::symlink_metadata(&path).is_err() {
                continue;
            }
            if self.leads_out(&path) {
                let message = format!(
                    "the file of unit {} is a link to a place outside the folders of specs",
                    quoted(&name.value)
                );
                self.refuse(name, message, "replace the link by the file");
                return Err(Refused);
            }
            return match self.sources.read(&path) {
                Ok(file) => self.unit(name, file).map(Some).ok_or(Refused),
                Err(error) => {
                    self.refuse(name, error.to_string(), "");
                    Err(Refused)
                }
            };
        }
        Ok(None)
    }

    /// Finds a unit that comes with Machinist.
    fn of_library(&mut self, name: &Spanned<String>) -> Option<usize> {
        let key = (true, name.value.clone());
        if let Some(known) = self.known.get(&key) {
            return *known;
        }
        let Some(unit) = LIBRARY.iter().find(|unit| unit.name == name.value) else {
            let help = help_to_find(&name.value, &self.define);
            self.refuse(name, format!("there is no unit {}", quoted(&name.value)), &help);
            return None;
        };
        let file = self.sources.embed(&format!("units/{}.toml", name.value), unit.text);
        let found = self.unit(name, file).map(|unit| {
            self.units.push(unit);
            self.units.len() - 1
        });
        self.known.insert(key, found);
        found
    }

    /// Iterates over the scene's folder, and that of the units beside it.
    fn unit_folders(&self) -> impl Iterator<Item = PathBuf> + use<> {
        let folder = self.folder.map(Path::to_path_buf);
        folder.into_iter().flat_map(|folder| {
            let units = folder.join("..").join("units");
            [folder, units]
        })
    }

    /// Reports whether a file is really outside of the scene's folder and of the units' folder.
    /// Its contents may then not be quoted.
    fn leads_out(&self, path: &Path) -> bool {
        let Ok(real) = path.canonicalize() else { return false };
        let mut folders = self.unit_folders().filter_map(|folder| folder.canonicalize().ok());
        !folders.any(|folder| real.starts_with(folder))
    }

    fn unit(&mut self, name: &Spanned<String>, file: FileId) -> Option<UnitSpec> {
        let text = self.sources.get(file).text.clone();
        match toml::parse(&text, file) {
            Ok(tree) => Some(unit::read(&tree, &name.value, file, true, &mut self.found)),
            Err(mistake) => {
                self.found.mistakes.push(mistake);
                None
            }
        }
    }

    fn refuse(&mut self, name: &Spanned<String>, message: String, help: &str) {
        self.found
            .mistakes
            .push(Mistake::new(Code::UnknownUnit, name.span, message, "used here").help(help));
    }
}

/// Suggests the name of a unit, or says where units are searched.
fn help_to_find(name: &str, define: &[UnitSpec]) -> String {
    let last = |name: &str| name.rsplit('/').next().unwrap_or_default().to_owned();
    let alike = LIBRARY.iter().filter(|unit| last(unit.name) == last(name));
    let alike: Vec<String> = alike.map(|unit| quoted(unit.name)).collect();
    if !alike.is_empty() {
        return format!("Machinist comes with {}", alike.join(" and "));
    }
    // Compared by the last part alone: folders are long, and would make any two names similar.
    let defined = define.iter().map(|unit| unit.name.as_str());
    let library = LIBRARY.iter().map(|unit| unit.name);
    let library = library.filter(|name| define.iter().all(|unit| unit.name != *name));
    let known: Vec<&str> = defined.chain(library).collect();
    let likeness = |known: &&str| strsim::jaro_winkler(&last(name), &last(known));
    let best = known.iter().map(likeness).fold(ALIKE, f64::max);
    let folder = |name: &str| name.rsplit_once('/').map(|(folder, _)| folder.to_owned());
    let mut meant: Vec<&str> = known.into_iter().filter(|known| likeness(known) >= best).collect();
    if meant.iter().any(|known| folder(known) == folder(name)) {
        meant.retain(|known| folder(known) == folder(name));
    }
    if !meant.is_empty() {
        let meant: Vec<String> = meant.into_iter().map(quoted).collect();
        return format!("did you mean {}?", meant.join(" or "));
    }
    let file = name.rsplit('/').next().filter(|last| *last == name);
    let define = file.map_or_else(String::new, |name| format!("in [define.{name}], "));
    format!(
        "a unit is looked for {define}as {name}.toml beside the scene, as ../units/{name}.toml, and \
         among those that come with Machinist, which `machinist parts` lists"
    )
}

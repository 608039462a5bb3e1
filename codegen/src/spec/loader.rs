//! From a scene's path to everything it refers to.

use std::path::{Path, PathBuf};

use crate::spec::diagnostic::{Diagnostics, FileId, Mistake, Spanned};
use crate::spec::fields::Findings;
use crate::spec::library::{LIBRARY, LibraryScene};
use crate::spec::names::quoted;
use crate::spec::scene::{self, SceneText};
use crate::spec::source::{Sources, folder_of};
use crate::spec::{InstanceSpec, SceneSpec, UnitSpec, table, toml, unit};

/// Names that are as alike as this are taken for one that was misspelt.
const ALIKE: f64 = 0.85;

pub(super) fn load(path: &Path) -> Result<SceneSpec, Diagnostics> {
    let mut sources = Sources::beside(path);
    let file = sources.read(path)?;
    read(sources, file, Some(folder_of(path)))
}

/// A scene that comes with Machinist, whose units do so too.
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
    let mut loader = Loader { sources, found, folder, units: Vec::new() };
    let instances = loader.instances(&mut scene);
    let Loader { mut sources, mut found, units, .. } = loader;
    let tables = table::read_all(&found.tables, &mut sources, &mut found.mistakes);
    match (scene.header, scene.run) {
        (Some(header), Some(run)) if found.mistakes.is_empty() => Ok(SceneSpec {
            sources,
            name: header.name,
            title: header.title,
            doc: header.doc,
            source: header.source,
            units,
            instances,
            joints: scene.joints,
            parameters: scene.parameters,
            helpers: scene.helpers,
            energy: scene.energy,
            forces: scene.forces,
            events: scene.events,
            constraints: scene.constraints,
            initial: scene.initial,
            starts_in_equilibrium: scene.starts_in_equilibrium,
            guess: scene.guess,
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

struct Loader<'a> {
    sources: Sources,
    found: Findings,
    /// Where units are looked for beside the library.
    folder: Option<&'a Path>,
    units: Vec<UnitSpec>,
}

impl Loader<'_> {
    /// The instances, each with its unit looked up; a unit is read once.
    fn instances(&mut self, scene: &mut SceneText) -> Vec<InstanceSpec> {
        let texts = std::mem::take(&mut scene.instances);
        let mut instances = Vec::new();
        for text in texts {
            let known = self.units.iter().position(|unit| unit.name == text.unit.value);
            let unit = known.or_else(|| {
                let unit = self.find(&text.unit, &scene.define)?;
                self.units.push(unit);
                Some(self.units.len() - 1)
            });
            let Some(unit) = unit else { continue };
            let (parameters, inputs, fields) = (text.parameters, text.inputs, text.fields);
            instances.push(InstanceSpec { name: text.name, unit, parameters, inputs, fields });
        }
        instances
    }

    fn find(&mut self, name: &Spanned<String>, define: &[UnitSpec]) -> Option<UnitSpec> {
        if let Some(unit) = define.iter().find(|unit| unit.name == name.value) {
            return Some(unit.clone());
        }
        let file_name = format!("{}.toml", name.value);
        for folder in self.unit_folders() {
            let path = folder.join(&file_name);
            if std::fs::symlink_metadata(&path).is_ok() {
                if self.leads_out(&path) {
                    let message = format!(
                        "the file of unit {} is a link that leads out of the folders of specs",
                        quoted(&name.value)
                    );
                    return self.refuse(name, message, "put the file itself there");
                }
                let read = self.sources.read(&path);
                return match read {
                    Ok(file) => self.unit(name, file),
                    Err(error) => self.refuse(name, error.to_string(), ""),
                };
            }
        }
        if let Some(unit) = LIBRARY.iter().find(|unit| unit.name == name.value) {
            let file = self.sources.embed(&format!("units/{file_name}"), unit.text);
            return self.unit(name, file);
        }
        let help = help_to_find(&name.value, define);
        self.refuse(name, format!("there is no unit {}", quoted(&name.value)), &help)
    }

    /// The scene's folder, and that of the units beside it.
    fn unit_folders(&self) -> impl Iterator<Item = PathBuf> + use<> {
        let folder = self.folder.map(Path::to_path_buf);
        folder.into_iter().flat_map(|folder| {
            let units = folder.join("..").join("units");
            [folder, units]
        })
    }

    /// Whether a file is really neither in the scene's folder nor among the units: what it
    /// holds is then nobody's to quote.
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

    fn refuse(&mut self, name: &Spanned<String>, message: String, help: &str) -> Option<UnitSpec> {
        self.found.mistakes.push(Mistake::new(name.span, message, "asked for here").help(help));
        None
    }
}

/// What a unit is called that may be meant, or where it is looked for.
fn help_to_find(name: &str, define: &[UnitSpec]) -> String {
    let last = |name: &str| name.rsplit('/').next().unwrap_or_default().to_owned();
    let alike = LIBRARY.iter().filter(|unit| last(unit.name) == last(name));
    let alike: Vec<String> = alike.map(|unit| quoted(unit.name)).collect();
    if !alike.is_empty() {
        return format!("with Machinist comes {}", alike.join(" and "));
    }
    // By the last part alone: folders are long, and would make any two alike.
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

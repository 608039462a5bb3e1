//! `machinist new`: a new machine, as a crate or as a spec.

use std::fs;
use std::io::Write as _;
use std::path::{Path, PathBuf};

use clap::Args;
use machinist_codegen::emit::rust::type_name;
use machinist_codegen::spec::library::{LibraryScene, MACHINES};
use machinist_codegen::spec::scene_name_mistake;

use super::output::print;
use crate::failure::{Failure, did_you_mean};

/// File of `examples/own_machine`, a crate that is tested by itself. Its names are replaced by
/// those of a new crate. The packed crate holds the file under another name, because Cargo does not
/// pack a crate within a package.
#[cfg(not(packed))]
macro_rules! template {
    ($file:literal, $packed:literal) => {
        ($file, include_str!(concat!("../../../examples/own_machine/", $file)))
    };
}
#[cfg(packed)]
macro_rules! template {
    ($file:literal, $packed:literal) => {
        ($file, include_str!(concat!("../../template/", $packed)))
    };
}

const SPEC: (&str, &str) = template!("specs/own_machine.toml", "own_machine.toml");
const MANIFEST: (&str, &str) = template!("Cargo.toml", "manifest.txt");
const FILES: [(&str, &str); 4] = [
    template!(".gitignore", "gitignore.txt"),
    template!("build.rs", "build.rs.txt"),
    SPEC,
    template!("src/main.rs", "main.rs.txt"),
];
/// Lock file with which the template was tested. It is only of use beside the sources.
const LOCK: (&str, &str) = template!("Cargo.lock", "lock.txt");
/// Names of the template's crate, of its scene, and of the scene's type.
const OWN_NAMES: [&str; 3] = ["own-machine", "own_machine", "OwnMachine"];
/// Dependencies of the template by path, and their folders in the sources.
const DEPENDENCIES: [(&str, &str); 3] =
    [("../..", ""), ("../../crates/contract", "crates/contract"), ("../../codegen", "codegen")];

/// Names that Cargo or Windows refuse for a crate and its program, or that another crate of the
/// build has.
const RESERVED: &[&str] = &[
    "alloc",
    "aux",
    "build",
    "con",
    "core",
    "deps",
    "examples",
    "incremental",
    "machinist",
    "machinist_algebra",
    "machinist_codegen",
    "machinist_contract",
    "machinist_model",
    "nul",
    "prn",
    "proc_macro",
    "std",
    "test",
];

#[derive(Debug, Args)]
pub struct New {
    /// Name of the machine: lower-case letters, digits, - and _
    name: String,
    /// Write only the spec, as the file NAME.toml
    #[arg(long)]
    spec_only: bool,
    /// Start from a machine of standard parts, as the file NAME.toml; `machinist list` shows all
    /// of them
    #[arg(long, value_name = "winch|press|robot|pendulum|motor|...")]
    from: Option<String>,
}

impl New {
    pub fn execute(&self) -> Result<(), Failure> {
        let names = Names::of(&self.name)?;
        if let Some(machine) = &self.from {
            return from_machine(&names, machine);
        }
        if self.spec_only {
            let file = format!("{}.toml", names.package);
            write_new_file(Path::new(&file), &names.put_in(SPEC.1))?;
            return print(&spec_written(&file, "hoist"));
        }
        let sources = sources();
        write_new_folder(Path::new(&names.package), &files(&names, sources.as_deref()))?;
        print(&crate_written(&names, sources.as_deref()))
    }
}

/// Writes the spec of a machine that comes with Machinist, under a new name.
fn from_machine(names: &Names, machine: &str) -> Result<(), Failure> {
    let is_meant = |scene: &&LibraryScene| scene.name.split('_').next() == Some(machine);
    let exact = MACHINES.iter().find(|scene| scene.name == machine);
    let Some(scene) = exact.or_else(|| MACHINES.iter().find(is_meant)) else {
        let known = MACHINES.iter().map(|scene| scene.name);
        let all: Vec<&str> = known.clone().collect();
        let message = format!("there is no machine `{}` to start from", machine.escape_debug());
        let hint = did_you_mean(machine, known);
        let help = format!("{hint}\nthe machines are {}", all.join(", "));
        return Err(Failure::input(message, help.trim_start()));
    };
    let own = format!("name = \"{}\"", scene.name);
    let new = format!("name = \"{}\"", names.scene);
    let file = format!("{}.toml", names.package);
    write_new_file(Path::new(&file), &scene.text.replacen(&own, &new, 1))?;
    print(&spec_written(&file, scene.name))
}

/// Names of a new crate, its scene and the scene's type.
struct Names {
    package: String,
    scene: String,
    type_name: String,
}

impl Names {
    fn of(package: &str) -> Result<Self, Failure> {
        let refuse = |why: &str, help: &str| {
            let message = format!("a machine cannot be called `{}`: {why}", package.escape_debug());
            Err(Failure::input(message, help))
        };
        let is_plain = |c: char| c.is_ascii_lowercase() || c.is_ascii_digit() || "-_".contains(c);
        let starts_well = package.starts_with(|c: char| c.is_ascii_lowercase());
        if !starts_well || !package.chars().all(is_plain) {
            let rule = "a name is made of lower-case letters, digits, - and _, and starts with a \
                        letter";
            let suggested = suggestion(package);
            let help = suggested.map_or_else(String::new, |name| format!("such as `{name}`"));
            return refuse(rule, &help);
        }
        let scene = package.replace('-', "_");
        let is_port = |name: &str| {
            let number = name.strip_prefix("com").or_else(|| name.strip_prefix("lpt"));
            number.is_some_and(|number| number.len() == 1 && number != "0")
        };
        if RESERVED.contains(&scene.as_str()) || is_port(&scene) {
            return refuse("it is reserved", "add a word");
        }
        if let Some(mistake) = scene_name_mistake(&scene) {
            return Err(Failure::input(mistake.message, mistake.help));
        }
        let type_name = type_name(&scene);
        Ok(Self { package: package.to_owned(), scene, type_name })
    }

    /// Replaces the template's names in a text.
    fn put_in(&self, text: &str) -> String {
        // A new name may contain one of the template's, so all of those are replaced by marks
        // first.
        let marks = ["\u{1}", "\u{2}", "\u{3}"];
        let new = [&self.package, &self.scene, &self.type_name];
        let with = |text: String, (from, to): (&str, &str)| text.replace(from, to);
        let marked = OWN_NAMES.into_iter().zip(marks).fold(text.to_owned(), with);
        marks.into_iter().zip(new.map(String::as_str)).fold(marked, with)
    }
}

/// Returns the nearest allowed name, if anything remains of the given one.
fn suggestion(name: &str) -> Option<String> {
    let plain = |c: char| if c.is_ascii_alphanumeric() { c.to_ascii_lowercase() } else { '_' };
    let plain: String = name.chars().take(64).map(plain).collect();
    let plain = plain.trim_start_matches(|c: char| !c.is_ascii_lowercase()).trim_end_matches('_');
    (!plain.is_empty()).then(|| plain.to_owned())
}

/// Returns the folder of the sources that this program was built from, if it still exists.
pub fn sources() -> Option<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).parent()?;
    let has = |part: &str| folder.join(part).join("Cargo.toml").is_file();
    DEPENDENCIES.iter().all(|(_, part)| has(part)).then(|| folder.to_owned())
}

/// Returns the files of a new crate with their content.
fn files(names: &Names, sources: Option<&Path>) -> Vec<(String, String)> {
    let put_in = |(file, text): (&str, &str)| (names.put_in(file), names.put_in(text));
    let mut files: Vec<_> = FILES.into_iter().map(put_in).collect();
    let (file, text) = put_in(MANIFEST);
    files.push((file, with_dependencies(&text, sources)));
    if sources.is_some() {
        files.push(put_in(LOCK));
    }
    files
}

/// Returns the manifest with Machinist's crates by their folders, or else by their version.
fn with_dependencies(manifest: &str, sources: Option<&Path>) -> String {
    // The example uses Symbolica. A new crate uses the plain algebra, which takes no lock.
    let mut text = manifest.replace(", features = [\"symbolica\"]", "");
    for (place, folder) in DEPENDENCIES {
        let found = sources.and_then(|sources| {
            let path = if folder.is_empty() { sources.to_owned() } else { sources.join(folder) };
            path.to_str().map(|path| format!("path = {}", serde_json::json!(path)))
        });
        let found = found.unwrap_or_else(|| format!("version = \"{}\"", env!("CARGO_PKG_VERSION")));
        text = text.replace(&format!("path = \"{place}\""), &found);
    }
    text
}

fn refuse_existing(path: &Path) -> Result<(), Failure> {
    if fs::symlink_metadata(path).is_err() {
        return Ok(());
    }
    let message = format!("{} exists already", path.display());
    Err(Failure::input(message, "choose another name, or move what is there; nothing was written"))
}

/// Writes a file that does not exist yet, completely or not at all.
fn write_new_file(path: &Path, text: &str) -> Result<(), Failure> {
    refuse_existing(path)?;
    super::output::write_file(path, |out| out.write_all(text.as_bytes()))
}

/// Writes files to a new folder, all or none: to a temporary folder beside it, which is then
/// renamed.
fn write_new_folder(folder: &Path, files: &[(String, String)]) -> Result<(), Failure> {
    refuse_existing(folder)?;
    let failed = |error: std::io::Error| Failure::file(folder, &error);
    let mut builder = tempfile::Builder::new();
    builder.prefix(".machinist-");
    #[cfg(unix)]
    {
        use std::os::unix::fs::PermissionsExt as _;
        builder.permissions(fs::Permissions::from_mode(0o777));
    }
    let beside = builder.tempdir_in(".").map_err(failed)?;
    for (file, text) in files {
        let path = beside.path().join(file);
        if let Some(parent) = path.parent() {
            fs::create_dir_all(parent).map_err(failed)?;
        }
        fs::File::create_new(&path)
            .and_then(|mut file| file.write_all(text.as_bytes()))
            .map_err(failed)?;
    }
    fs::rename(beside.path(), folder).map_err(failed)?;
    // The folder has been renamed and must not be deleted.
    let _ = beside.keep();
    Ok(())
}

fn spec_written(file: &str, machine: &str) -> String {
    let article = if machine.starts_with(['a', 'e', 'i', 'o', 'u']) { "an" } else { "a" };
    format!(
        "wrote {file}: {article} {}, to be made into a machine of your own\n\n\
         machinist show {file}\n\
         machinist watch {file}\n\
         machinist run {file} --plot {}\n\
         machinist verify {file}\n",
        machine.replace('_', " "),
        file.replace(".toml", ".svg")
    )
}

fn crate_written(names: &Names, sources: Option<&Path>) -> String {
    let (package, spec) = (&names.package, names.put_in(SPEC.0));
    let from = match sources {
        Some(folder) => format!("Machinist itself is taken from {}.", folder.display()),
        None => format!(
            "Machinist itself is taken from the registry, version {}: the sources of this program \
             are not here;\nCargo.toml may name their folders by `path` instead.",
            env!("CARGO_PKG_VERSION")
        ),
    };
    format!(
        "wrote {package}/: a hoist, to be made into a machine of your own in {package}/{spec}\n\
         {from}\n\n\
         cd {package}\n\
         machinist run {spec} --plot {package}.svg\n\
         machinist verify {spec}\n\
         cargo run     # the first build takes some minutes\n\
         cargo test\n"
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_name_of_the_template_is_left() {
        let names = Names::of("hoist-2").expect("a name");
        for (file, text) in files(&names, Some(Path::new("/sources"))) {
            for own in OWN_NAMES {
                assert!(!file.contains(own) && !text.contains(own), "{file} has {own}");
            }
            assert!(!text.contains("\"../"), "{file} has a path of the template");
        }
    }

    #[test]
    fn a_name_may_contain_that_of_the_template() {
        let names = Names::of("own_machine-2").expect("a name");
        let put_in = names.put_in("own-machine own_machine OwnMachine");
        assert_eq!(put_in, "own_machine-2 own_machine_2 OwnMachine2");
    }

    #[test]
    fn dependencies_are_folders_of_the_sources_or_else_versions() {
        let (_, text) = MANIFEST;
        let by_path = with_dependencies(text, Some(Path::new("/some \"place\"")));
        assert!(by_path.contains(r#"machinist = { path = "/some \"place\"", default-features"#));
        assert!(by_path.contains(r#"codegen = { path = "/some \"place\"/codegen" }"#), "{by_path}");
        let by_version = with_dependencies(text, None);
        let version =
            format!("machinist-contract = {{ version = \"{}\" }}", env!("CARGO_PKG_VERSION"));
        assert!(by_version.contains(&version), "{by_version}");
        assert!(!by_version.contains("path"), "{by_version}");
    }

    #[test]
    fn a_name_of_a_folder_or_of_another_crate_is_refused() {
        for name in ["hoist", "my-hoist", "h2_o"] {
            assert!(Names::of(name).is_ok(), "{name}");
        }
        let long = "a".repeat(65);
        for name in [
            "",
            ".",
            "..",
            "../x",
            "a/b",
            "a\\b",
            "/tmp/x",
            "-x",
            "_x",
            "2x",
            "Hoist",
            "h oist",
            "h\u{f6}ist",
            "std",
            "core",
            "test",
            "match",
            "machinist",
            "machinist-codegen",
            "com1",
            "shape",
            "sin",
            "pi",
            "a\n",
            long.as_str(),
        ] {
            assert!(Names::of(name).is_err(), "{name:?}");
        }
        assert_eq!(suggestion("My Hoist!").as_deref(), Some("my_hoist"));
        assert_eq!(suggestion("../x").as_deref(), Some("x"));
        assert_eq!(suggestion("42"), None);
    }
}

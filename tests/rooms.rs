//! Rooms of the engine: modules of a room use those of rooms before it.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

const SOURCES: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../src");

/// Rooms in their order, with the modules of each. ARCHITECTURE.md shows them.
const ROOMS: [(&str, &[&str]); 10] = [
    ("numbers", &["complex_step", "dense", "legendre", "scales", "sorting", "threads"]),
    ("results", &["error", "trajectory"]),
    ("constraints", &["constraints"]),
    ("methods", &["lanes", "method"]),
    ("runs", &["error_estimate", "hosted", "simulate"]),
    ("linear", &["linear_analysis"]),
    ("fields", &["field"]),
    ("periodic", &["periodic"]),
    ("estimation", &["fatigue", "fit", "improve"]),
    ("variants", &["estimator", "scatter", "sweep"]),
];

/// Uses of later rooms that remain: a file, the module that it uses, and what for.
const UPWARDS: [(&str, &str, &str); 9] = [
    ("constraints.rs", "method", "slots of held branches"),
    ("error.rs", "linear_analysis", "error of a search for an equilibrium"),
    ("error.rs", "method", "name of the method that stopped"),
    ("error.rs", "simulate", "limit of output times, in a message"),
    ("method/sensitivity/start.rs", "linear_analysis", "derivatives of a start in equilibrium"),
    ("simulate/start.rs", "linear_analysis", "start in equilibrium"),
    ("trajectory.rs", "constraints", "type of a field"),
    ("trajectory.rs", "error_estimate", "type of a field"),
    ("trajectory.rs", "method", "types of fields"),
];

/// Returns all source files of a folder.
fn files(folder: &Path) -> Vec<PathBuf> {
    let entries =
        fs::read_dir(folder).expect("a folder").map(|entry| entry.expect("an entry").path());
    let (folders, files): (Vec<PathBuf>, Vec<PathBuf>) = entries.partition(|path| path.is_dir());
    folders.iter().flat_map(|folder| self::files(folder)).chain(files).collect()
}

/// Returns the text without comments and unit tests.
fn code(path: &Path) -> String {
    let text = fs::read_to_string(path).expect("a source");
    let text = text.split("#[cfg(test)]\nmod tests {").next().unwrap_or_default();
    let lines = text.lines().map(|line| line.split("//").next().unwrap_or_default());
    lines.collect::<Vec<_>>().join("\n")
}

/// Returns the names that follow `crate::`, also within braces.
fn used(code: &str) -> BTreeSet<String> {
    let name = |text: &str| -> String {
        text.trim_start().chars().take_while(|c| c.is_alphanumeric() || *c == '_').collect()
    };
    let mut names = BTreeSet::new();
    for rest in code.split("crate::").skip(1) {
        let Some(list) = rest.strip_prefix('{') else {
            names.insert(name(rest));
            continue;
        };
        let (mut depth, mut begins) = (0, true);
        for (at, character) in list.char_indices() {
            if begins && depth == 0 {
                names.insert(name(&list[at..]));
            }
            begins = character == ',';
            match character {
                '{' => depth += 1,
                '}' if depth == 0 => break,
                '}' => depth -= 1,
                _ => {}
            }
        }
    }
    names
}

/// Returns the modules from which the crate's root exports items, by the names of the items.
fn exports() -> BTreeMap<String, String> {
    let root = code(&Path::new(SOURCES).join("lib.rs"));
    let uses = root.split("pub use ").skip(1).filter_map(|rest| rest.split(';').next());
    let named = uses.filter_map(|path| path.split_once("::"));
    let items = named.flat_map(|(module, items)| {
        let items = items.trim_matches(['{', '}']).split(',');
        items.map(|item| (item.trim().to_owned(), module.to_owned()))
    });
    items.collect()
}

#[test]
fn the_rooms_of_the_engine_use_only_those_before_them() {
    let room = |module: &str| ROOMS.iter().position(|(_, modules)| modules.contains(&module));
    let exports = exports();
    let (mut upwards, mut homeless) = (BTreeSet::new(), BTreeSet::new());
    for path in files(Path::new(SOURCES)) {
        let file = path.strip_prefix(SOURCES).expect("within").display().to_string();
        let module = file.split(['/', '.']).next().unwrap_or_default().to_owned();
        if module == "lib" {
            continue;
        }
        let Some(own) = room(&module) else {
            homeless.insert(module);
            continue;
        };
        for name in used(&code(&path)) {
            let name = exports.get(&name).unwrap_or(&name);
            if room(name).is_some_and(|other| other > own) {
                upwards.insert((file.clone(), name.clone()));
            }
        }
    }
    assert!(homeless.is_empty(), "add to a room: {homeless:?}");
    let known = UPWARDS.iter().map(|(file, module, _)| ((*file).to_owned(), (*module).to_owned()));
    let known: BTreeSet<_> = known.collect();
    let new: Vec<_> = upwards.difference(&known).collect();
    assert!(new.is_empty(), "these use a room behind their own: {new:?}");
    let gone: Vec<_> = known.difference(&upwards).collect();
    assert!(gone.is_empty(), "remove from UPWARDS: {gone:?}");
}

#[test]
fn uses_are_found_in_lists_and_paths() {
    let found = used("use crate::{a::{b, c}, d};\nlet x = crate::e::f();\nuse crate::g;");
    assert_eq!(found.into_iter().collect::<Vec<_>>(), ["a", "d", "e", "g"]);
}

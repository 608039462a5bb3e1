//! Rooms of the engine: modules of a room use those of rooms before it.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

const SOURCES: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../src");

/// Rooms in their order, with the modules of each. Files of a folder are in the room of the folder,
/// unless they are named. ARCHITECTURE.md shows the rooms.
const ROOMS: [(&str, &[&str]); 14] = [
    ("numbers", &["complex_step", "dense", "held", "legendre", "scales", "sorting", "threads"]),
    ("results", &["error", "method_table", "trajectory"]),
    ("constraints", &["constraints"]),
    ("linear", &["linear_analysis"]),
    (
        "tables and matrices of methods",
        &[
            "method/choices",
            "method/lanes",
            "method/lu",
            "method/milestone",
            "method/patience",
            "method/sparse",
            "method/suitable",
            "method/tableau",
            "method/tolerance",
            "method/vectors",
        ],
    ),
    ("steps and events", &["lanes", "method"]),
    (
        "matrices of steps",
        &["method/bordered", "method/onset", "method/quadrature", "method/step_matrix"],
    ),
    (
        "implicit methods",
        &[
            "method/auto",
            "method/diffsol",
            "method/fixed",
            "method/published",
            "method/radau",
            "method/rosenbrock",
        ],
    ),
    ("runs", &["error_estimate", "hosted", "simulate"]),
    (
        "operating points",
        &[
            "linear_analysis/along",
            "linear_analysis/campbell",
            "linear_analysis/operating_point",
            "linear_analysis/slopes",
        ],
    ),
    ("fields", &["field"]),
    ("periodic", &["periodic"]),
    ("estimation", &["fatigue", "fit", "improve"]),
    ("variants", &["estimator", "scatter", "sweep"]),
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

/// Names of a path in Rust, such as `crate`, `method`, `Held`.
type Names = Vec<String>;

/// Parses a path, or a tree of paths within braces, and returns the text after it.
fn tree<'t>(mut text: &'t str, mut path: Names, found: &mut Vec<Names>) -> &'t str {
    loop {
        if let Some(mut rest) = text.strip_prefix('{') {
            while let Some(next) = rest.chars().next().filter(|next| *next != '}') {
                let is_name = next.is_alphanumeric() || next == '_' || next == '{';
                rest = if is_name {
                    tree(rest, path.clone(), found)
                } else {
                    &rest[next.len_utf8()..]
                };
            }
            return rest.get(1..).unwrap_or_default();
        }
        let end = text.find(|c: char| !c.is_alphanumeric() && c != '_').unwrap_or(text.len());
        path.push(text[..end].to_owned());
        let Some(rest) = text[end..].strip_prefix("::") else {
            found.push(path);
            return &text[end..];
        };
        text = rest;
    }
}

/// Returns the paths that begin at each place where the text has one of these words.
fn paths(code: &str, words: &[&str]) -> Vec<Names> {
    let mut found = Vec::new();
    for word in words {
        for (at, _) in code.match_indices(word) {
            let before = &code[..at];
            let is_within = before.ends_with(|c: char| c.is_alphanumeric() || "_:".contains(c))
                || before.ends_with("pub(in ");
            if !is_within {
                tree(code[at..].trim_start_matches("use "), Vec::new(), &mut found);
            }
        }
    }
    found
}

/// Sources of the engine by the paths of their modules, such as `method/watch`.
struct Sources {
    code: BTreeMap<String, String>,
    /// Modules from which a module imports names of its child modules.
    imports: BTreeMap<(String, String), String>,
}

impl Sources {
    fn read() -> Self {
        let path = |file: &Path| {
            let path = file.strip_prefix(SOURCES).expect("within").with_extension("");
            path.display().to_string().replace('\\', "/")
        };
        let code = files(Path::new(SOURCES)).iter().map(|file| (path(file), code(file))).collect();
        let mut sources = Self { code, imports: BTreeMap::new() };
        for (module, code) in &sources.code {
            for names in paths(code, &["use "]) {
                let (Some(item), Some(child)) = (names.last(), names.first()) else { continue };
                let of = if module == "lib" { String::new() } else { format!("{module}/") };
                let child = format!("{of}{child}");
                if names.len() > 1 && sources.code.contains_key(&child) {
                    sources.imports.insert((module.clone(), item.clone()), child);
                }
            }
        }
        sources
    }

    /// Returns the module that a path from the root leads to.
    fn module(&self, names: &[String]) -> String {
        let mut module = String::from("lib");
        for name in names {
            let below = if module == "lib" { name.clone() } else { format!("{module}/{name}") };
            module = match self.imports.get(&(module.clone(), name.clone())) {
                _ if self.code.contains_key(&below) => below,
                Some(child) => child.clone(),
                None => return module,
            };
        }
        module
    }

    /// Returns the modules that a module uses by `crate::` and `super::`.
    fn used(&self, module: &str) -> BTreeSet<String> {
        let from_root = |names: Names| {
            let ups = names.iter().take_while(|name| *name == "super").count();
            let own = module.split('/').map(str::to_owned).collect::<Names>();
            let above = if ups == 0 { Names::new() } else { own[..own.len() - ups].to_vec() };
            [above, names[ups.max(1)..].to_vec()].concat()
        };
        let paths = paths(&self.code[module], &["crate::", "super::"]);
        paths.into_iter().map(|names| self.module(&from_root(names))).collect()
    }
}

/// Returns the index of the room of a module.
fn room(module: &str) -> Option<usize> {
    let mut path = module;
    loop {
        let found = ROOMS.iter().position(|(_, modules)| modules.contains(&path));
        match (found, path.rsplit_once('/')) {
            (None, Some((above, _))) => path = above,
            (found, _) => return found,
        }
    }
}

#[test]
fn the_rooms_of_the_engine_use_only_those_before_them() {
    let sources = Sources::read();
    let (mut upwards, mut count) = (Vec::new(), 0);
    for module in sources.code.keys().filter(|module| *module != "lib") {
        let own = room(module).unwrap_or_else(|| panic!("add `{module}` to a room"));
        for used in sources.used(module) {
            let other = room(&used);
            count += usize::from(other.is_some_and(|other| other < own));
            if other.is_some_and(|other| other > own) {
                upwards.push(format!("{module} uses {used}"));
            }
        }
    }
    assert!(upwards.is_empty(), "these use a room behind their own: {upwards:#?}");
    assert!(count > 300, "{count} uses of rooms before");
}

#[test]
fn uses_are_found_in_lists_and_paths() {
    let code =
        "use crate::{a::{b, c}, d};\nlet x = crate::e::f();\nuse super::g;\nuse crate::h as i;";
    let found: BTreeSet<String> =
        paths(code, &["crate::", "super::"]).iter().map(|names| names.join("::")).collect();
    let wanted = ["crate::a::b", "crate::a::c", "crate::d", "crate::e::f", "crate::h", "super::g"];
    assert_eq!(found.into_iter().collect::<Vec<_>>(), wanted);
}

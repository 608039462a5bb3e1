//! Source text of the crate, for compiling emitted scenes without Cargo.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

use machinist_contract::SOURCES;

fn files_below(folder: &Path, found: &mut BTreeSet<PathBuf>) {
    for entry in fs::read_dir(folder).expect("a folder") {
        let path = entry.expect("an entry").path();
        if path.is_dir() {
            files_below(&path, found);
        } else {
            found.insert(path);
        }
    }
}

#[test]
fn no_file_of_the_crate_is_missing() {
    let source = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let mut found = BTreeSet::new();
    files_below(&source, &mut found);
    let listed = SOURCES.iter().map(|(file, _)| source.join(file)).collect();
    assert_eq!(found, listed);
}

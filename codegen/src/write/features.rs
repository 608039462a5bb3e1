//! One Cargo feature for each emitted scene, so that a program links only the scenes it runs.
//!
//! Excluded: files (see [`crate::write`]).

use std::path::{Path, PathBuf};

use crate::emit::rust::TAKEN;
use toml_edit::{Array, DocumentMut, TomlError, value};

/// The feature that enables all scenes.
const ALL: &str = "scenes";
/// Mark in the comment above that feature, for manifests whose list Machinist maintains.
const MARK: &str = "machinist gen";

/// Returns the manifest of the crate whose `src/scenes` the folder is, if there is one.
pub(crate) fn manifest_of(folder: &Path) -> Option<PathBuf> {
    let source = folder.parent().filter(|source| source.ends_with("src"))?;
    let manifest = source.parent()?.join("Cargo.toml");
    manifest.is_file().then_some(manifest)
}

/// Returns a manifest with a feature for each scene, and one for all of them. `None` if the
/// manifest has no feature for all scenes with the mark in its comment. Features that are not in
/// its list are kept.
pub(crate) fn with_scenes(manifest: &str, scenes: &[&str]) -> Result<Option<String>, TomlError> {
    let mut document: DocumentMut = manifest.parse()?;
    let Some(features) = document.get_mut("features").and_then(|item| item.as_table_like_mut())
    else {
        return Ok(None);
    };
    let comment = features.key(ALL).and_then(|key| key.leaf_decor().prefix()?.as_str());
    if !comment.is_some_and(|comment| comment.contains(MARK)) {
        return Ok(None);
    }
    let listed = features.get(ALL).and_then(|item| item.as_array());
    let listed: Vec<String> =
        listed.into_iter().flatten().filter_map(|name| Some(name.as_str()?.to_owned())).collect();
    for name in listed.iter().filter(|name| !TAKEN.contains(&name.as_str())) {
        features.remove(name);
    }
    let mut scenes = scenes.to_vec();
    scenes.sort_unstable();
    let mut all = Array::new();
    for scene in &scenes {
        all.push_formatted(toml_edit::Value::from(*scene).decorated("\n    ", ""));
        features.insert(scene, value(Array::new()));
    }
    all.set_trailing(if scenes.is_empty() { "" } else { "\n" });
    all.set_trailing_comma(!scenes.is_empty());
    // Changed in place, so that its comment is kept.
    if let Some(item) = features.get_mut(ALL) {
        *item = value(all);
    }
    Ok(Some(document.to_string()))
}

#[cfg(test)]
mod tests {
    use super::with_scenes;

    const MANIFEST: &str = "[package]\nname = \"a\"\n\n[features]\n# How.\ndefault = [\"std\"]\n\
                            std = []\nmine = []\n# Kept by `machinist gen`.\n\
                            scenes = [\"old\"]\nold = []\n";

    #[test]
    fn features_follow_the_scenes_and_leave_the_rest_alone() {
        let text = with_scenes(MANIFEST, &["pump", "gin"]).expect("a manifest").expect("a change");
        let expected = "[package]\nname = \"a\"\n\n[features]\n# How.\ndefault = [\"std\"]\n\
                        std = []\nmine = []\n# Kept by `machinist gen`.\n\
                        scenes = [\n    \"gin\",\n    \"pump\",\n]\n\
                        gin = []\npump = []\n";
        assert_eq!(text, expected);
        assert_eq!(with_scenes(&text, &["gin", "pump"]).expect("a manifest"), Some(text));
    }

    #[test]
    fn a_manifest_without_our_feature_for_all_scenes_is_none_of_ours() {
        let theirs = MANIFEST.replace("# Kept by `machinist gen`.\n", "");
        assert_eq!(with_scenes(&theirs, &["gin"]).expect("a manifest"), None);
        assert_eq!(with_scenes("[features]\nstd = []\n", &["gin"]).expect("a manifest"), None);
        assert_eq!(with_scenes("", &["gin"]).expect("a manifest"), None);
        assert!(with_scenes("[features", &["gin"]).is_err());
    }
}

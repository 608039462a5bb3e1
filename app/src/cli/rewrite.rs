//! Text of a scene with found values, as a file of its own.

use std::path::Path;

#[cfg(feature = "derive")]
use super::amount::Amount;
use super::arguments::SceneArgs;
#[cfg(not(feature = "derive"))]
use crate::failure::ErrorCode;
use crate::failure::Failure;

/// Value found for a parameter, or for the start of a state.
#[cfg_attr(not(feature = "derive"), expect(dead_code, reason = "read where specs are written"))]
pub struct FoundValue<'a> {
    pub name: &'a str,
    pub value: f64,
    pub is_parameter: bool,
}

/// Writes the text of a scene with the values found, and the parameters and initial values set on
/// the command line. Never overwrites the file that it was read from.
#[cfg(feature = "derive")]
pub fn write_scene<'a>(
    SceneArgs { scene, machine }: &'a SceneArgs,
    found: impl Iterator<Item = FoundValue<'a>>,
    file: &Path,
) -> Result<(), Failure> {
    use machinist_codegen::spec::library::LibraryScene;
    use machinist_codegen::spec::rewrite::{Setting, with_settings};

    use super::scene::SceneSource;
    use crate::spec_source::SpecSource;

    let no_text = || {
        let message = format!("--out: `{scene}` is a model, which has no spec");
        Failure::input(message, "give the spec that it was compiled from")
    };
    let (text, of) = match SceneSource::of(scene)? {
        SceneSource::Model(_) => return Err(no_text()),
        SceneSource::Spec(SpecSource::BuiltIn(name)) => {
            let scene = LibraryScene::find(&name).ok_or_else(no_text)?;
            (scene.text.to_owned(), None)
        }
        SceneSource::Spec(SpecSource::File(path)) => {
            let text =
                std::fs::read_to_string(&path).map_err(|error| Failure::file(&path, &error))?;
            (text, Some(path))
        }
    };
    let is_same = |path: &std::path::PathBuf| {
        let [a, b] = [path.as_path(), file].map(std::fs::canonicalize);
        matches!((a, b), (Ok(a), Ok(b)) if a == b)
    };
    if of.as_ref().is_some_and(is_same) {
        let message = format!("--out {} would overwrite the scene itself", file.display());
        return Err(Failure::input(message, "give another name"));
    }
    let given = |is_parameter| {
        move |(name, amount): &'a (String, Amount)| FoundValue {
            name,
            value: amount.value,
            is_parameter,
        }
    };
    let mut all: Vec<FoundValue<'_>> = found.collect();
    let initial = machine.initial.iter().map(given(false));
    let initial: Vec<_> =
        initial.filter(|given| all.iter().all(|found| found.name != given.name)).collect();
    all.extend(machine.set.iter().map(given(true)).chain(initial));
    let setting = |found: FoundValue<'_>| {
        let name = found.name.to_owned();
        if found.is_parameter {
            Setting::Parameter(name, found.value)
        } else {
            Setting::Initial(name, found.value)
        }
    };
    let settings: Vec<Setting> = all.into_iter().map(setting).collect();
    let text = with_settings(&text, &settings)
        .map_err(|why| Failure::unsuccessful(format!("--out {}: {why}", file.display()), ""))?;
    super::output::write_file(file, |out| out.write_all(text.as_bytes()))
}

/// Returns an error, because this build reads no specs.
#[cfg(not(feature = "derive"))]
pub fn write_scene<'a>(
    _scene: &'a SceneArgs,
    _found: impl Iterator<Item = FoundValue<'a>>,
    file: &Path,
) -> Result<(), Failure> {
    let message = format!("--out {}: this program was built without specs", file.display());
    Err(Failure::coded(
        ErrorCode::NotBuiltIn,
        message,
        "take the values from the table, or `--json`",
    ))
}

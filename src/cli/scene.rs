//! What the name of a scene stands for: a simulator built in, or a spec file.

use std::path::{MAIN_SEPARATOR, Path, PathBuf};

use machinist::interpreted::InterpretedSimulator;
use machinist_codegen::pipeline;
use machinist_codegen::reduce::Keep;
use machinist_codegen::spec::did_you_mean;
use machinist_scenes::{Simulator, scenes};

use super::progress::during;
use super::{Failure, specs};
use crate::freeze::admit;

/// A scene ready to run.
pub enum Scene {
    /// Built in, by name.
    Emitted(&'static dyn Simulator<f64>),
    /// From a file, evaluated from its tapes.
    Interpreted(Box<InterpretedSimulator>),
}

impl Scene {
    /// The scene of a name or of a spec file; a name that is not built in may be that
    /// of a spec. Of its spec in any case if nothing is to be left out.
    pub fn load(argument: &str, keep_all: bool) -> Result<Self, Failure> {
        if !keep_all
            && !is_path(argument)
            && let Some(simulator) = built_in(argument)
        {
            return Ok(Self::Emitted(simulator));
        }
        let path = spec_path(argument)?;
        let keep = if keep_all { Keep::All } else { Keep::Needed };
        let program = during("deriving", || pipeline::generate(&path, keep))?;
        if !keep_all {
            admit(&path, &program)?;
        }
        Ok(Self::Interpreted(Box::new(InterpretedSimulator::new(program))))
    }

    /// The simulator.
    pub fn simulator(&self) -> &dyn Simulator<f64> {
        match self {
            Self::Emitted(simulator) => *simulator,
            Self::Interpreted(simulator) => simulator.as_ref(),
        }
    }

    /// How it runs, for people.
    pub fn how(&self) -> &'static str {
        match self {
            Self::Emitted(_) => "emitted code",
            Self::Interpreted(_) => "evaluated from its tapes",
        }
    }
}

/// The emitted simulator of a name.
pub fn built_in(name: &str) -> Option<&'static dyn Simulator<f64>> {
    #[cfg(feature = "bench")]
    if let Some(simulator) = machinist_scenes::bench::find(name) {
        return Some(simulator);
    }
    scenes::find(name)
}

/// The spec file of a name or a path. A name is looked for among the specs of
/// the current folder.
pub fn spec_path(argument: &str) -> Result<PathBuf, Failure> {
    if is_path(argument) {
        return Ok(PathBuf::from(argument));
    }
    let places = specs::places_of(argument);
    if let Some(found) = places.iter().find(|place| place.is_file()) {
        return Ok(found.clone());
    }
    if !scenes::NAMES.contains(&argument) {
        return Err(unknown(argument));
    }
    let places: Vec<String> = places.iter().map(|place| place.display().to_string()).collect();
    Err(Failure::input(
        format!("no spec of scene `{argument}` here; looked for {}", places.join(" and ")),
        "run this in the folder that holds `specs`, or give the path of a scene file",
    ))
}

/// Whether an argument is meant as a path rather than as a name.
fn is_path(argument: &str) -> bool {
    Path::new(argument).extension().is_some_and(|ending| ending == "toml")
        || argument.contains(['/', MAIN_SEPARATOR])
}

fn unknown(name: &str) -> Failure {
    let hint = did_you_mean(name, scenes::NAMES.iter().copied());
    let help = format!(
        "{hint}\n`machinist list` shows all scenes; a path that ends in `.toml` names a scene file"
    );
    Failure::input(format!("there is no scene `{}`", name.escape_debug()), help.trim_start())
}

//! Settings from files and the environment.
//!
//! The command line wins over the environment, the environment over `machinist.toml` in the current
//! folder or the nearest one above it, and that file over `machinist/machinist.toml` in the user's
//! folder for configuration.

use std::env;
use std::fs;
use std::ops::Range;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, OnceLock, PoisonError};

use clap::ValueEnum;
use machinist::Method;
#[cfg(feature = "derive")]
use machinist_algebra::cas::Algebra;
use miette::{LabeledSpan, MietteDiagnostic, NamedSource, Report};
use toml_edit::{Document, Item, Value};
use tracing_subscriber::filter::{LevelFilter, Targets};
use tracing_subscriber::fmt::format::FmtSpan;
use tracing_subscriber::fmt::time::uptime;
use tracing_subscriber::layer::{Layer as _, SubscriberExt as _};
use tracing_subscriber::util::SubscriberInitExt as _;

#[cfg(feature = "derive")]
use crate::cli::arguments::algebra;
use crate::failure::{ErrorCode, Failure, did_you_mean};

/// Name of the files.
const FILE: &str = "machinist.toml";
/// Keys of the files.
pub const KEYS: [&str; 6] = ["algebra", "method", "rtol", "threads", "colours", "log"];
/// Tables that only specs have.
const OF_SPECS: [&str; 5] = ["scene", "unit", "units", "joints", "coordinates"];

/// When messages are coloured.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum Colours {
    /// On terminals
    Auto,
    /// Everywhere
    Always,
    /// Nowhere
    Never,
}

/// What is logged on standard error.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Log {
    /// Nothing
    Off,
    /// Derivations and runs
    Info,
    /// Compilations, segments and events too
    Debug,
}

/// Setting with its source.
#[derive(Debug, Clone, PartialEq)]
struct Setting<T> {
    value: T,
    source: Source,
}

/// Source of a setting.
#[derive(Debug, Clone, PartialEq, Eq)]
enum Source {
    /// Variable of the environment.
    Environment,
    File(PathBuf),
}

/// Settings from files and the environment.
#[derive(Debug, Default)]
struct Config {
    #[cfg(feature = "derive")]
    algebra: Option<Setting<Algebra>>,
    method: Option<Setting<String>>,
    rtol: Option<Setting<f64>>,
    threads: Option<Setting<usize>>,
    colours: Option<Setting<Colours>>,
    log: Option<Setting<Log>>,
}

static CONFIG: OnceLock<Config> = OnceLock::new();

/// Reads the environment and the files. Only the first call has an effect.
///
/// # Errors
/// [`Failure`] for a file that cannot be read, and for unknown keys and values.
pub fn load() -> Result<(), Failure> {
    let mut config = Config::default();
    config.take_environment()?;
    for file in files() {
        config.take_file(&file)?;
    }
    let _ = CONFIG.set(config);
    Ok(())
}

fn current() -> Option<&'static Config> {
    CONFIG.get()
}

/// Returns the algebra for derivations that the command line leaves open.
#[cfg(feature = "derive")]
pub fn algebra_for_derivation() -> Option<Algebra> {
    used("algebra", current()?.algebra.as_ref(), |algebra| algebra.name().to_owned())
}

/// Returns the name of the method for runs that the command line leaves open.
pub fn method() -> Option<String> {
    used("method", current()?.method.as_ref(), Clone::clone)
}

/// Returns the relative tolerance for runs that the command line leaves open.
pub fn rtol() -> Option<f64> {
    used("rtol", current()?.rtol.as_ref(), |rtol| format!("{rtol:e}"))
}

/// Returns the number of threads of sweeps that the command line leaves open.
pub fn threads() -> Option<usize> {
    used("threads", current()?.threads.as_ref(), ToString::to_string)
}

/// Returns when messages are coloured.
pub fn colours() -> Option<Colours> {
    Some(current()?.colours.as_ref()?.value)
}

/// Returns the value of a setting. Says once that it comes from a file.
fn used<T: Clone>(
    key: &'static str,
    setting: Option<&Setting<T>>,
    shown: impl Fn(&T) -> String,
) -> Option<T> {
    static TOLD: Mutex<Vec<&str>> = Mutex::new(Vec::new());
    let Setting { value, source } = setting?;
    if let Source::File(file) = source {
        let mut told = TOLD.lock().unwrap_or_else(PoisonError::into_inner);
        if !told.contains(&key) {
            told.push(key);
            eprintln!("machinist: {key} {}, from {}", shown(value), file.display());
        }
    }
    Some(value.clone())
}

/// Returns the files that exist, the one of the project first.
fn files() -> Vec<PathBuf> {
    let here = env::current_dir().unwrap_or_default();
    let project = here.ancestors().map(|folder| folder.join(FILE)).find(|file| file.is_file());
    let project = project.map(|file| match file.strip_prefix(&here) {
        Ok(beside) => beside.to_owned(),
        Err(_) => file,
    });
    let user = user_folder().map(|folder| folder.join("machinist").join(FILE));
    project.into_iter().chain(user.filter(|file| file.is_file())).collect()
}

/// Returns the user's folder for configuration.
fn user_folder() -> Option<PathBuf> {
    let folder = |variable: &str| {
        env::var_os(variable).map(PathBuf::from).filter(|folder| folder.is_absolute())
    };
    let of_system = if cfg!(windows) { folder("APPDATA") } else { None };
    folder("XDG_CONFIG_HOME").or(of_system).or_else(|| Some(folder("HOME")?.join(".config")))
}

/// Error in a file.
struct Wrong {
    message: String,
    help: String,
    at: Option<Range<usize>>,
}

impl Config {
    fn take_environment(&mut self) -> Result<(), Failure> {
        for key in KEYS {
            let variable = format!("MACHINIST_{}", key.to_uppercase());
            let Some(text) = env::var_os(&variable).filter(|text| !text.is_empty()) else {
                continue;
            };
            let text = text.to_string_lossy();
            self.take(key, &text, Source::Environment).map_err(|known| {
                Failure::input(format!("{variable} is `{}`", text.escape_debug()), known)
            })?;
        }
        let is_plain = env::var_os("NO_COLOR").is_some_and(|text| !text.is_empty());
        if is_plain && self.colours.is_none() {
            self.colours = Some(Setting { value: Colours::Never, source: Source::Environment });
        }
        Ok(())
    }

    fn take_file(&mut self, file: &Path) -> Result<(), Failure> {
        let text = fs::read_to_string(file).map_err(|error| Failure::file(file, &error))?;
        self.take_text(file, &text).map_err(|Wrong { message, help, at }| {
            let mut diagnostic =
                MietteDiagnostic::new(message).with_code(<&str>::from(ErrorCode::InvalidData));
            if !help.is_empty() {
                diagnostic = diagnostic.with_help(help);
            }
            if let Some(at) = at {
                diagnostic = diagnostic.with_label(LabeledSpan::underline(at));
            }
            let source = NamedSource::new(file.display().to_string(), text.clone());
            Failure::Input(vec![Report::new(diagnostic).with_source_code(source)])
        })
    }

    fn take_text(&mut self, file: &Path, text: &str) -> Result<(), Wrong> {
        let document = Document::parse(text).map_err(|error| Wrong {
            message: error.message().lines().next().unwrap_or_default().to_owned(),
            help: String::new(),
            at: error.span(),
        })?;
        let table = document.as_table();
        if OF_SPECS.iter().any(|key| table.contains_key(key)) {
            eprintln!(
                "machinist: {} is a spec, so it is not read as configuration; rename it to avoid \
                 this note",
                file.display()
            );
            return Ok(());
        }
        for (key, item) in table {
            let at = || table.key(key).and_then(toml_edit::Key::span);
            let Some(known) = KEYS.into_iter().find(|known| *known == key) else {
                let message = format!("a configuration has no key `{}`", key.escape_debug());
                return Err(Wrong { message, help: did_you_mean(key, KEYS.into_iter()), at: at() });
            };
            let source = Source::File(file.to_owned());
            self.take(known, &written(item), source).map_err(|help| {
                let message = format!("this value of `{key}` is not possible");
                Wrong { message, help, at: item.span().or_else(at) }
            })?;
        }
        Ok(())
    }

    /// Takes the value of a key unless an earlier source has set it.
    ///
    /// # Errors
    /// The possible values.
    fn take(&mut self, key: &str, text: &str, source: Source) -> Result<(), String> {
        match key {
            "algebra" => {
                #[cfg(feature = "derive")]
                keep(&mut self.algebra, algebra(text)?, source);
            }
            "method" => {
                let method = Method::from_name(text).map_err(|error| error.to_string())?;
                keep(&mut self.method, method.name().to_owned(), source);
            }
            "rtol" => match text.parse() {
                Ok(rtol) if rtol > 0.0 && rtol <= 1.0 => keep(&mut self.rtol, rtol, source),
                _ => return Err("a relative tolerance is a number in 0 to 1, such as 1e-8".into()),
            },
            "threads" => match text.parse() {
                Ok(threads) if threads > 0 => keep(&mut self.threads, threads, source),
                _ => return Err("a number of threads is whole and at least 1".to_owned()),
            },
            "log" => {
                let log = Log::from_str(text, false);
                keep(&mut self.log, log.map_err(|_| "known are off, info and debug")?, source);
            }
            _ => {
                let colours = Colours::from_str(text, false);
                let colours = colours.map_err(|_| "known are auto, always and never")?;
                keep(&mut self.colours, colours, source);
            }
        }
        Ok(())
    }
}

fn keep<T>(setting: &mut Option<Setting<T>>, value: T, source: Source) {
    setting.get_or_insert(Setting { value, source });
}

/// Returns the text of a value, without the quotation marks of a string.
fn written(item: &Item) -> String {
    match item.as_value() {
        Some(Value::String(text)) => text.value().clone(),
        Some(Value::Float(number)) => number.value().to_string(),
        Some(value) => value.to_string().trim().to_owned(),
        None => String::new(),
    }
}

/// Logs on standard error what settings ask for, with the time that each part takes. Without it, Symbolica would log
/// as it sees fit.
pub fn start_log() {
    let level = match current().and_then(|config| config.log.as_ref()) {
        Some(Setting { value: Log::Debug, .. }) => LevelFilter::DEBUG,
        Some(Setting { value: Log::Info, .. }) => LevelFilter::INFO,
        Some(Setting { value: Log::Off, .. }) | None => LevelFilter::OFF,
    };
    let lines = tracing_subscriber::fmt::layer()
        .with_writer(std::io::stderr)
        .with_ansi(false)
        .with_target(false)
        .with_timer(uptime())
        .with_span_events(FmtSpan::CLOSE)
        .with_filter(Targets::new().with_target("machinist", level));
    // The console script of the Python package runs many commands in one process.
    let _ = tracing_subscriber::registry().with(lines).try_init();
}

/// Applies the choice of colours to messages.
pub fn colour_messages(colours: Colours) {
    let is_coloured = match colours {
        Colours::Auto => return,
        Colours::Always => true,
        Colours::Never => false,
    };
    // The hook can be set only once, and this is the only place that sets it.
    let _ = miette::set_hook(Box::new(move |_| {
        Box::new(miette::MietteHandlerOpts::new().color(is_coloured).build())
    }));
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(texts: &[&str]) -> Result<Config, Wrong> {
        let mut config = Config::default();
        for text in texts {
            config.take_text(Path::new("machinist.toml"), text)?;
        }
        Ok(config)
    }

    #[test]
    fn the_first_file_wins_key_by_key() {
        let Ok(config) = of(&["rtol = 1e-9\nthreads = 2", "rtol = 1e-3\nmethod = \"radau\""])
        else {
            panic!("refused")
        };
        assert_eq!(config.rtol.map(|rtol| rtol.value), Some(1e-9));
        assert_eq!(config.threads.map(|threads| threads.value), Some(2));
        assert_eq!(config.method.map(|method| method.value).as_deref(), Some("radau"));
        assert_eq!(config.colours, None);
    }

    #[test]
    fn mistakes_are_refused_with_their_place_and_a_hint() {
        for (text, at, message, help) in [
            ("rtoll = 1e-9", 0..5, "no key `rtoll`", "`rtol`"),
            ("rtol = 2", 7..8, "`rtol`", "0 to 1"),
            ("rtol = nan", 7..10, "`rtol`", "0 to 1"),
            ("rtol = [1]", 7..10, "`rtol`", "0 to 1"),
            ("method = \"raddau\"", 9..17, "`method`", "radau"),
            ("threads = 0", 10..11, "`threads`", "at least 1"),
            ("threads = 1.5", 10..13, "`threads`", "at least 1"),
            ("colours = true", 10..14, "`colours`", "never"),
            ("[method]\nname = 1", 0..8, "`method`", "known"),
        ] {
            let Err(wrong) = of(&[text]) else { panic!("{text} is accepted") };
            assert!(wrong.message.contains(message), "{text}: {}", wrong.message);
            assert!(wrong.help.contains(help), "{text}: {}", wrong.help);
            assert_eq!(wrong.at, Some(at), "{text}");
        }
        assert!(of(&["rtol = "]).is_err_and(|wrong| wrong.at.is_some()));
    }

    #[test]
    fn a_spec_is_not_taken_for_a_configuration() {
        let Ok(config) = of(&["[scene]\nname = \"a\"\n[run]\nrtol = 1"]) else { panic!("refused") };
        assert_eq!(config.rtol, None);
    }
}

//! Measured runs with settings of their own, from a TOML file.
//!
//! ```toml
//! [[experiment]]
//! name = "cold"                    # the file's name, unless given
//! data = "cold.csv"                # beside this file
//! from = 0.5                       # s
//! set = { motor.inertia = 4.2, coupling.stiffness = "18 [kN m/rad]" }
//! map = { n1 = "motor_speed" }
//! outputs = ["motor_speed"]
//! sigma = { motor_speed = "0.1 + 1 %" }
//! ```

use std::path::{Path, PathBuf};

use super::noise::Sigma;
use crate::cli::amount::Amount;
use crate::failure::{ErrorCode, Failure};

/// Settings of a measured run before its file is read.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Setup {
    pub name: String,
    pub data: PathBuf,
    pub from: Option<f64>,
    /// Parameters, and initial values of states.
    pub set: Vec<(String, Amount)>,
    pub map: Vec<(String, String)>,
    pub outputs: Vec<String>,
    pub sigma: Vec<(String, Sigma)>,
}

/// Reads all experiments of a file.
#[cfg(feature = "derive")]
pub fn read(path: &Path) -> Result<Vec<Setup>, Failure> {
    let text = std::fs::read_to_string(path).map_err(|error| Failure::file(path, &error))?;
    let folder = path.parent().unwrap_or(Path::new(""));
    let mut setups = parse::experiments(&text).map_err(|parse::Wrong { at, message, help }| {
        let line = text.get(..at).unwrap_or_default().matches('\n').count() + 1;
        Failure::coded(
            ErrorCode::InvalidData,
            format!("{}, line {line}: {message}", path.display()),
            help,
        )
    })?;
    for setup in &mut setups {
        setup.data = folder.join(&setup.data);
    }
    Ok(setups)
}

/// Returns an error, because this build reads no TOML.
#[cfg(not(feature = "derive"))]
pub fn read(path: &Path) -> Result<Vec<Setup>, Failure> {
    let message = format!("--experiments {}: this program reads no TOML", path.display());
    Err(Failure::coded(
        ErrorCode::NotBuiltIn,
        message,
        "use `--data`, or a build with the feature `derive`",
    ))
}

#[cfg(feature = "derive")]
mod parse {
    use std::ops::Range;

    use toml_edit::{Document, Item, TableLike, Value};

    use super::Setup;
    use crate::cli::amount::Amount;
    use crate::cli::fit::noise::noise;
    use crate::failure::did_you_mean;

    const KEYS: [&str; 7] = ["name", "data", "from", "set", "map", "outputs", "sigma"];

    /// Error with its byte position.
    #[derive(Debug)]
    pub struct Wrong {
        pub at: usize,
        pub message: String,
        pub help: String,
    }

    fn wrong(span: Option<Range<usize>>, message: impl Into<String>) -> Wrong {
        let at = span.map_or(0, |span| span.start);
        Wrong { at, message: message.into(), help: String::new() }
    }

    pub fn experiments(text: &str) -> Result<Vec<Setup>, Wrong> {
        let document = Document::parse(text).map_err(|error| {
            let message = error.message().lines().next().unwrap_or_default().to_owned();
            wrong(error.span(), format!("not valid TOML: {message}"))
        })?;
        let help = "each experiment is a table [[experiment]]";
        let refuse =
            |span, message: String| Wrong { help: help.to_owned(), ..wrong(span, message) };
        let root = document.as_table();
        if let Some((key, item)) = root.iter().find(|(key, _)| *key != "experiment") {
            let key = key.escape_debug();
            return Err(refuse(item.span(), format!("`{key}` is not known here")));
        }
        let Some(tables) = root.get("experiment").and_then(Item::as_array_of_tables) else {
            return Err(refuse(None, "there are no experiments".to_owned()));
        };
        let mut setups: Vec<Setup> = Vec::new();
        for table in tables {
            let setup = experiment(table, table.span())?;
            if setups.iter().any(|other| other.name == setup.name) {
                let name = setup.name.escape_debug();
                let message = format!("two experiments are called `{name}`");
                return Err(Wrong {
                    help: "give each a different `name`".to_owned(),
                    ..wrong(table.span(), message)
                });
            }
            setups.push(setup);
        }
        Ok(setups)
    }

    fn experiment(table: &dyn TableLike, span: Option<Range<usize>>) -> Result<Setup, Wrong> {
        let mut setup = Setup::default();
        for (key, item) in table.iter() {
            let at = || item.span().or_else(|| table.key(key).and_then(toml_edit::Key::span));
            match key {
                "name" => setup.name = string(item, key)?,
                "data" => setup.data = string(item, key)?.into(),
                "from" => setup.from = Some(number(item, key)?),
                "set" => {
                    setup.set =
                        leaves(item, key)?.into_iter().map(amount).collect::<Result<_, _>>()?;
                }
                "map" => {
                    let text = |(name, value): Leaf<'_>| match value.as_str() {
                        Some(output) => Ok((name, output.to_owned())),
                        None => Err(wrong(value.span(), format!("`{name}` is not a string"))),
                    };
                    setup.map =
                        leaves(item, key)?.into_iter().map(text).collect::<Result<_, _>>()?;
                }
                "outputs" => {
                    let list =
                        item.as_array().ok_or_else(|| wrong(at(), "`outputs` is not a list"))?;
                    let text = |value: &Value| {
                        let text = value.as_str().map(str::to_owned);
                        text.ok_or_else(|| wrong(value.span(), "`outputs` is a list of names"))
                    };
                    setup.outputs = list.iter().map(text).collect::<Result<_, _>>()?;
                }
                "sigma" => {
                    setup.sigma =
                        leaves(item, key)?.into_iter().map(sigma).collect::<Result<_, _>>()?;
                }
                _ => {
                    let message = format!("an experiment has no `{}`", key.escape_debug());
                    let help = did_you_mean(key, KEYS.into_iter());
                    return Err(Wrong { help, ..wrong(at(), message) });
                }
            }
        }
        if setup.data.as_os_str().is_empty() {
            let help = "`data` names its CSV file".to_owned();
            return Err(Wrong { help, ..wrong(span, "an experiment has no data") });
        }
        if setup.name.is_empty() {
            setup.name = setup.data.display().to_string();
        }
        Ok(setup)
    }

    type Leaf<'t> = (String, &'t Value);

    /// Returns the values of a table and its subtables, with names joined by points.
    fn leaves<'t>(item: &'t Item, key: &str) -> Result<Vec<Leaf<'t>>, Wrong> {
        let Some(table) = item.as_table_like() else {
            return Err(wrong(item.span(), format!("`{key}` is not a table")));
        };
        let mut all = Vec::new();
        gather(table, "", &mut all);
        Ok(all)
    }

    fn gather<'t>(table: &'t dyn TableLike, before: &str, all: &mut Vec<Leaf<'t>>) {
        for (key, item) in table.iter() {
            let name = if before.is_empty() { key.to_owned() } else { format!("{before}.{key}") };
            match (item.as_table_like(), item.as_value()) {
                (Some(table), _) => gather(table, &name, all),
                (None, Some(value)) => all.push((name, value)),
                (None, None) => {}
            }
        }
    }

    fn string(item: &Item, key: &str) -> Result<String, Wrong> {
        let text = item.as_str().filter(|text| !text.is_empty()).map(str::to_owned);
        text.ok_or_else(|| wrong(item.span(), format!("`{key}` is not a string such as \"cold\"")))
    }

    fn number(item: &Item, key: &str) -> Result<f64, Wrong> {
        let value = item.as_value().and_then(plain).filter(|value| value.is_finite());
        value.ok_or_else(|| wrong(item.span(), format!("`{key}` is not a finite number")))
    }

    fn plain(value: &Value) -> Option<f64> {
        value.as_float().or_else(|| value.as_integer().map(|integer| integer as f64))
    }

    /// Parses a number, or a text with a unit.
    fn amount((name, value): Leaf<'_>) -> Result<(String, Amount), Wrong> {
        let of = |why: String| wrong(value.span(), format!("{name}: {why}"));
        let read = match (plain(value), value.as_str()) {
            (Some(number), _) if number.is_finite() => Amount { value: number, unit: None },
            (None, Some(text)) => Amount::parse(text).map_err(of)?,
            _ => return Err(of("a number, or a text with a unit, \"18 [kN m/rad]\"".to_owned())),
        };
        Ok((name, read))
    }

    fn sigma((name, value): Leaf<'_>) -> Result<(String, crate::cli::fit::noise::Sigma), Wrong> {
        let text = plain(value).map(|number| number.to_string());
        let text = text.or_else(|| value.as_str().map(str::to_owned)).unwrap_or_default();
        let read = noise(&text);
        read.map(|noise| (name.clone(), noise))
            .map_err(|why| wrong(value.span(), format!("sigma of {name}: {why}")))
    }

    #[cfg(test)]
    mod tests {
        use super::*;

        #[test]
        fn an_experiment_is_read_whole() {
            let text = r#"
                [[experiment]]
                data = "a.csv"
                [[experiment]]
                name = "warm"
                data = "b.csv"
                from = 1
                map = { n1 = "motor_speed" }
                outputs = ["twist"]
                sigma = { twist = "1 + 2 %", motor.omega = 3 }
                [experiment.set]
                motor.inertia = 4.2
                "coupling.stiffness" = "18 [kN m/rad]"
            "#;
            let read = experiments(text).expect("it is right");
            let [plain, warm] = &read[..] else { panic!("{read:?}") };
            assert_eq!(plain.name, "a.csv");
            assert_eq!((&*warm.name, warm.from), ("warm", Some(1.0)));
            let set: Vec<(&str, f64)> =
                warm.set.iter().map(|(name, a)| (&**name, a.value)).collect();
            assert_eq!(set, [("motor.inertia", 4.2), ("coupling.stiffness", 18e3)]);
            assert_eq!(warm.sigma.len(), 2);
        }

        #[test]
        fn what_is_wrong_is_said_with_its_place() {
            for (text, words) in [
                ("", "no experiments"),
                ("[[experiments]]\ndata = \"a\"", "not known here"),
                ("[[experiment]]\nname = \"a\"", "no data"),
                ("[[experiment]]\ndata = 3", "not a string"),
                ("[[experiment]]\ndata = \"a\"\nsett = {}", "no `sett`"),
                ("[[experiment]]\ndata = \"a\"\nset = { b = true }", "b: a number"),
                ("[[experiment]]\ndata = \"a\"\nset = { b = \"1 [x y]\" }", "b:"),
                ("[[experiment]]\ndata = \"a\"\nsigma = { b = -1 }", "not above 0"),
                ("[[experiment]]\ndata = \"a\"\nfrom = nan", "not a finite"),
                ("[[experiment]]\ndata = \"a\"\n[[experiment]]\ndata = \"a\"", "called `a`"),
                ("[[experiment]\n", "not valid TOML"),
            ] {
                let found = experiments(text).expect_err(text);
                assert!(found.message.contains(words), "{text}: {}", found.message);
            }
        }
    }
}

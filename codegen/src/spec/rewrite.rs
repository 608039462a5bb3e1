//! Changes of parameters and initial values in the text of a scene, which is otherwise kept as
//! written.
//!
//! Excluded: validation of names and values. Reading the result does that.

use super::measure::Measure;
use toml_edit::{DocumentMut, InlineTable, Item, TableLike, Value, value};

/// A quantity with a new value.
#[derive(Debug, Clone, PartialEq)]
pub enum Setting {
    /// A parameter, of the scene or of one of its units, `coupling.stiffness`, in SI units.
    Parameter(String, f64),
    /// The initial value of a state, `coupling.twist`.
    Initial(String, f64),
}

/// Returns the text of a scene with new values.
///
/// # Errors
/// The setting that cannot be made in this text: it is not TOML, or has no such unit or
/// parameter.
pub fn with_settings(text: &str, settings: &[Setting]) -> Result<String, String> {
    let mut document: DocumentMut = text.parse().map_err(|error| format!("{error}"))?;
    for setting in settings {
        match setting {
            Setting::Parameter(name, number) => set_parameter(&mut document, name, *number)?,
            Setting::Initial(name, number) => {
                let initial = document.entry("initial").or_insert(toml_edit::table());
                let initial = initial.as_table_like_mut().ok_or("`initial` is no table")?;
                put(initial, name, *number);
            }
        }
    }
    Ok(document.to_string())
}

fn set_parameter(document: &mut DocumentMut, name: &str, number: f64) -> Result<(), String> {
    let own = document.get_mut("parameters").and_then(Item::as_table_like_mut);
    let own = own.and_then(|own| own.get_mut(name)).and_then(Item::as_table_like_mut);
    if let Some(own) = own {
        let unit = own.get("unit").and_then(Item::as_str).map(Measure::parse);
        let factor = unit.and_then(Result::ok).map_or(1.0, |measure| measure.factor.to_f64());
        put(own, "value", number / factor);
        return Ok(());
    }
    let (unit, parameter) =
        name.split_once('.').ok_or_else(|| format!("the scene has no parameter `{name}`"))?;
    let units = document.get_mut("units").and_then(Item::as_table_like_mut);
    let unit = units
        .and_then(|units| units.get_mut(unit))
        .and_then(Item::as_table_like_mut)
        .ok_or_else(|| format!("`{name}` is of no unit that stands in the scene's own file"))?;
    if unit.get("parameters").is_none() {
        unit.insert("parameters", value(InlineTable::new()));
    }
    let parameters = unit.get_mut("parameters").and_then(Item::as_table_like_mut);
    put(
        parameters.ok_or_else(|| format!("`parameters` of `{name}` is no table"))?,
        parameter,
        number,
    );
    Ok(())
}

/// Sets a key to a number, and keeps the space and the comment around it.
fn put(table: &mut dyn TableLike, key: &str, number: f64) {
    let mut new = Value::from(number);
    if let Some(old) = table.get(key).and_then(Item::as_value) {
        *new.decor_mut() = old.decor().clone();
    }
    table.insert(key, Item::Value(new));
}

#[cfg(test)]
mod tests {
    use super::*;

    const SCENE: &str = r#"# My scene.
[scene]
name = "own"

[units.motor]
unit = "rotor"
parameters = { inertia = 4.2 }   # measured

[units.coupling] # the soft one
unit = "coupling"

[parameters.torque]
value = 100.0 # rated
unit = "N m"

[parameters.play]
value = 1.5
unit = "mm"

[initial]
"motor.angle" = "0.1"
"#;

    #[test]
    fn values_change_and_nothing_else() {
        let settings = [
            Setting::Parameter("motor.inertia".to_owned(), 5.5),
            Setting::Parameter("coupling.stiffness".to_owned(), 2e4),
            Setting::Parameter("torque".to_owned(), 90.0),
            Setting::Parameter("play".to_owned(), 0.0025),
            Setting::Initial("motor.angle".to_owned(), 0.25),
            Setting::Initial("motor.speed".to_owned(), -1.0),
        ];
        let text = with_settings(SCENE, &settings).unwrap();
        for (line, wanted) in [
            ("inertia", "parameters = { inertia = 5.5 }   # measured"),
            ("stiffness", "parameters = { stiffness = 20000.0 }"),
            ("90", "value = 90.0 # rated"),
            ("2.5", "value = 2.5"),
            ("motor.angle", "\"motor.angle\" = 0.25"),
            ("motor.speed", "\"motor.speed\" = -1.0"),
            ("soft", "[units.coupling] # the soft one"),
        ] {
            assert!(text.lines().any(|found| found.contains(line) && found == wanted), "{text}");
        }
        assert!(text.starts_with("# My scene.\n[scene]\nname = \"own\"\n"));
    }

    #[test]
    fn what_is_not_there_is_refused() {
        for name in ["power", "gear.ratio"] {
            let setting = Setting::Parameter(name.to_owned(), 1.0);
            assert!(with_settings(SCENE, &[setting]).unwrap_err().contains(name));
        }
    }
}

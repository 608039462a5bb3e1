//! JSON schema for editors: every spec of the repository fits it, and specs of the wrong shape do
//! not.

use std::fs;
use std::path::{Path, PathBuf};

use serde_json::{Map, Value, json};
use toml_edit::{Document, Item};

use crate::cli::answer;
use crate::process::REPOSITORY;

/// Messages of the parser for errors that a schema can detect.
const OF_SHAPE: [&str; 8] = [
    "unknown key",
    " lacks `",
    ", not a string",
    ", not a number",
    ", not an integer",
    ", not a list",
    ", not a table",
    ", not true or false",
];

#[test]
fn every_spec_of_the_repository_fits_the_schema() {
    let [scene, unit] = schemas();
    let specs = Path::new(REPOSITORY).join("specs");
    let mut count = 0;
    for (folder, schema) in [("scenes", &scene), ("units", &unit)] {
        for file in files_below(&specs.join(folder)) {
            let text = fs::read_to_string(&file).expect("a spec");
            if let Err(why) = fits(schema, &tree(&text)) {
                panic!("{}: {why}", file.display());
            }
            count += 1;
        }
    }
    assert!(count > 200, "{count} specs");
    for file in files_below(&Path::new(REPOSITORY).join("codegen/tests/pass")) {
        let text = fs::read_to_string(&file).expect("a spec");
        assert_eq!(fits(&scene, &tree(&text)), Ok(()), "{}", file.display());
    }
}

#[test]
fn specs_of_the_wrong_shape_do_not_fit_and_those_wrong_in_what_they_say_do() {
    let [scene, _] = schemas();
    let (mut refused, mut overlooked) = (0, Vec::new());
    for file in files_below(&Path::new(REPOSITORY).join("codegen/tests/fail")) {
        let text = fs::read_to_string(&file).expect("a spec");
        let said = fs::read_to_string(file.with_extension("snap")).expect("what is said");
        let said = said.replace('\u{2502}', " ");
        let said = said.split_whitespace().collect::<Vec<_>>().join(" ");
        let Ok(document) = text.parse::<Document<String>>() else { continue };
        let does_fit = fits(&scene, &value_of(document.as_item())).is_ok();
        // Only messages about the file itself, not about files that it names.
        let name = file.file_name().and_then(|name| name.to_str()).expect("a name").to_owned();
        let is_of_shape = said.contains(&name) && OF_SHAPE.iter().any(|words| said.contains(words));
        refused += usize::from(!does_fit);
        if is_of_shape && does_fit {
            overlooked.push(name);
        }
    }
    assert!(refused >= 17, "{refused} are refused");
    // Their missing keys depend on the distribution or the unit that they name.
    let known =
        ["distribution_without_deviation.toml", "field_not_cut.toml", "field_without_inertia.toml"];
    assert_eq!(overlooked, known);
}

#[test]
fn what_the_parser_knows_is_in_the_schema() {
    let [scene, unit] = schemas();
    let run = &scene["properties"]["run"];
    assert_eq!(run["required"], json!(null));
    let methods = run["properties"]["method"]["enum"].as_array().expect("words");
    assert!(methods.contains(&json!("radau")) && methods.len() > 8);
    let initial = &scene["properties"]["initial"];
    assert_eq!(initial["properties"]["from"], json!({ "enum": ["equilibrium"] }));
    let ports = &unit["properties"]["ports"]["additionalProperties"]["anyOf"];
    let of_part = |shape: &&Value| shape["type"] == json!("string");
    let (texts, tables): (Vec<_>, Vec<_>) =
        ports.as_array().expect("two").iter().partition(of_part);
    let ([_], [port]) = (&texts[..], &tables[..]) else { panic!("a port of a part, or a table") };
    let keys: Vec<&String> = port["properties"].as_object().expect("keys").keys().collect();
    for key in ["at", "coordinate", "field", "kind", "ratio"] {
        assert!(keys.iter().any(|known| *known == key), "{key}");
    }
    // Either a coordinate or a place on a field.
    assert_eq!(port["required"], json!(["kind"]));
    assert_eq!(port["properties"]["kind"]["enum"].as_array().map(Vec::len), Some(4));
    let defined = &scene["properties"]["define"]["additionalProperties"];
    assert_eq!(defined["properties"]["ports"], unit["properties"]["ports"]);
    assert_eq!(unit["required"], json!(["unit"]));
}

/// Returns the schemas of scenes and of units.
pub fn schemas() -> [Value; 2] {
    [&["schema"][..], &["schema", "--unit"]]
        .map(|arguments| serde_json::from_str(&answer(arguments)).expect("JSON"))
}

fn files_below(folder: &Path) -> Vec<PathBuf> {
    let mut files = Vec::new();
    for entry in fs::read_dir(folder).expect("a folder") {
        let path = entry.expect("an entry").path();
        if path.is_dir() {
            files.extend(files_below(&path));
        } else if path.extension().is_some_and(|ending| ending == "toml") {
            files.push(path);
        }
    }
    files.sort();
    files
}

fn tree(text: &str) -> Value {
    value_of(text.parse::<Document<String>>().expect("TOML").as_item())
}

pub fn value_of(item: &Item) -> Value {
    if let Some(table) = item.as_table_like() {
        let entries = table.iter().map(|(key, item)| (key.to_owned(), value_of(item)));
        return Value::Object(entries.collect());
    }
    if let Some(tables) = item.as_array_of_tables() {
        let tables = tables.iter().map(|table| value_of(&Item::Table(table.clone())));
        return Value::Array(tables.collect());
    }
    if let Some(list) = item.as_array() {
        return list.iter().map(|value| value_of(&Item::Value(value.clone()))).collect();
    }
    if let Some(text) = item.as_str() {
        return json!(text);
    }
    let number = item.as_float().or(item.as_integer().map(|integer| integer as f64));
    // Numbers that JSON cannot represent still count as numbers.
    let number = number.map(|number| if number.is_finite() { number } else { 0.0 });
    number.map(|number| json!(number)).or(item.as_bool().map(Value::Bool)).unwrap_or(Value::Null)
}

/// Checks a value against a schema, for the keywords that Machinist's schemas use. Any other
/// keyword fails.
pub fn fits(schema: &Value, value: &Value) -> Result<(), String> {
    let schema = schema.as_object().expect("a schema");
    let known = ["$schema", "title", "propertyNames", "additionalProperties", "required"];
    for (word, rule) in schema {
        match word.as_str() {
            "type" => {
                let is_it = match rule.as_str() {
                    Some("object") => value.is_object(),
                    Some("array") => value.is_array(),
                    Some("string") => value.is_string(),
                    Some("number") => value.is_number(),
                    Some("boolean") => value.is_boolean(),
                    other => panic!("{other:?}"),
                };
                require(is_it, || format!("{value} is no {rule}"))?;
            }
            "enum" => {
                let words = rule.as_array().expect("words");
                require(words.contains(value), || format!("{value} is none of {rule}"))?;
            }
            "anyOf" => {
                let any = rule.as_array().expect("schemas");
                let fit = any.iter().any(|schema| fits(schema, value).is_ok());
                require(fit, || format!("{value} is none of several"))?;
            }
            "items" => {
                let mut items = value.as_array().into_iter().flatten();
                items.try_for_each(|item| fits(rule, item))?;
            }
            "properties" => {
                if let Some(table) = value.as_object() {
                    fits_keys(schema, table)?;
                }
            }
            other => assert!(known.contains(&other), "{other} is not checked here"),
        }
    }
    match value.as_object() {
        Some(table) if !schema.contains_key("properties") => fits_keys(schema, table),
        _ => Ok(()),
    }
}

fn fits_keys(schema: &Map<String, Value>, table: &Map<String, Value>) -> Result<(), String> {
    for key in schema.get("required").and_then(Value::as_array).into_iter().flatten() {
        let key = key.as_str().expect("a key");
        require(table.contains_key(key), || format!("{key} is not there"))?;
    }
    for (key, value) in table {
        if schema.contains_key("propertyNames") {
            let is_word = |c: char| c.is_ascii_alphanumeric() || c == '_';
            let is_name = key.starts_with(|c: char| c.is_ascii_alphabetic());
            require(is_name && key.chars().all(is_word), || format!("{key} is no name"))?;
        }
        let own = schema.get("properties").and_then(|properties| properties.get(key));
        match own.or(schema.get("additionalProperties")) {
            Some(Value::Bool(false)) => return Err(format!("{key} is unknown")),
            Some(of_key) => fits(of_key, value).map_err(|why| format!("{key}: {why}"))?,
            None => {}
        }
    }
    Ok(())
}

fn require(is_so: bool, why: impl FnOnce() -> String) -> Result<(), String> {
    if is_so { Ok(()) } else { Err(why()) }
}

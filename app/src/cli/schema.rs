//! `machinist schema`: a JSON schema of specs, for editors.

use std::path::PathBuf;

use clap::Args;
use machinist_codegen::spec::schema::{Key, Shape};
use serde_json::{Map, Value, json};

use super::output::{print, write_file};
use crate::failure::Failure;

/// Newest dialect that all TOML editors support.
const DIALECT: &str = "http://json-schema.org/draft-07/schema#";

#[derive(Debug, Args)]
pub struct Schema {
    /// Print the schema of unit files instead of scene files
    #[arg(long)]
    unit: bool,
    /// Write to a file instead of standard output
    #[arg(short, long, value_name = "FILE")]
    out: Option<PathBuf>,
}

impl Schema {
    pub fn execute(&self) -> Result<(), Failure> {
        let (title, shape) = if self.unit {
            ("Unit of Machinist", Shape::of_unit())
        } else {
            ("Scene of Machinist", Shape::of_scene())
        };
        let mut schema = Map::new();
        schema.insert("$schema".to_owned(), json!(DIALECT));
        schema.insert("title".to_owned(), json!(title));
        schema.extend(of_shape(&shape));
        let text = serde_json::to_string_pretty(&Value::Object(schema))
            .map_err(|error| Failure::unsuccessful(error, ""))?;
        match &self.out {
            Some(file) => write_file(file, |out| writeln!(out, "{text}")),
            None => print(&format!("{text}\n")),
        }
    }
}

fn of_shape(shape: &Shape) -> Map<String, Value> {
    let schema = match shape {
        Shape::Text => json!({ "type": "string" }),
        Shape::Choice(words) => json!({ "enum": words }),
        Shape::Number => json!({ "type": "number" }),
        Shape::Boolean => json!({ "type": "boolean" }),
        Shape::List(of) => json!({ "type": "array", "items": of_shape(of) }),
        Shape::Table(keys) => {
            let required = keys.iter().filter(|key| key.is_required).map(|key| &key.name);
            let required: Vec<&String> = required.collect();
            let mut table = json!({
                "type": "object",
                "properties": properties(keys),
                "additionalProperties": false,
            });
            if !required.is_empty() {
                table["required"] = json!(required);
            }
            table
        }
        Shape::Named { identifiers, known, of } => {
            let mut table = json!({ "type": "object", "additionalProperties": of_shape(of) });
            if !known.is_empty() {
                table["properties"] = Value::Object(properties(known));
            }
            if *identifiers {
                table["propertyNames"] = json!({ "pattern": "^[A-Za-z][A-Za-z0-9_]*$" });
            }
            table
        }
        Shape::Any(shapes) => {
            json!({ "anyOf": shapes.iter().map(of_shape).collect::<Vec<_>>() })
        }
    };
    match schema {
        Value::Object(schema) => schema,
        _ => Map::new(),
    }
}

fn properties(keys: &[Key]) -> Map<String, Value> {
    let property = |key: &Key| (key.name.clone(), Value::Object(of_shape(&key.shape)));
    keys.iter().map(property).collect()
}

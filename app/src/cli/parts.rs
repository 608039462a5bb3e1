//! `machinist parts`: the standard parts that come with Machinist.

use std::fmt::Write as _;
use std::path::PathBuf;

use clap::{Args, Subcommand};
use machinist_codegen::spec::card::Card;
use machinist_codegen::spec::library::{LIBRARY, LibraryUnit};

use super::output::{columns, print, write_file};
use super::table::{SECTION, columns_of_section, indented, paragraph, width};
use crate::failure::{Failure, did_you_mean};

/// Command that renews the page of the parts.
const MENDING_COMMAND: &str = "cargo run --release -- parts --page docs/book/src/parts.md";

#[derive(Debug, Args)]
#[command(args_conflicts_with_subcommands = true)]
pub struct Parts {
    #[command(subcommand)]
    what: Option<What>,
    /// List only parts whose name, title, synonyms, text, ports or parameters contain all of these
    /// words
    #[arg(value_name = "WORD")]
    words: Vec<String>,
    /// Write all parts to a page in Markdown
    #[arg(long, value_name = "FILE", conflicts_with = "words")]
    page: Option<PathBuf>,
}

#[derive(Debug, Subcommand)]
enum What {
    /// Show equations, ports, parameters and an example of one part
    Show {
        /// Name of the part, such as `rotational/clutch`, or its last component
        name: String,
    },
}

impl Parts {
    pub fn execute(&self) -> Result<(), Failure> {
        match (&self.what, &self.page) {
            (Some(What::Show { name }), _) => show(name),
            (None, Some(path)) => {
                let text = page()?;
                write_file(path, |out| out.write_all(text.as_bytes()))
            }
            (None, None) => list(&self.words),
        }
    }
}

/// Returns the standard parts: units with an example.
fn standard() -> impl Iterator<Item = &'static LibraryUnit> + Clone {
    LIBRARY.iter().filter(|unit| unit.example.is_some())
}

fn card(unit: &LibraryUnit) -> Result<Card, Failure> {
    Card::of(unit).map_err(Failure::from)
}

fn list(words: &[String]) -> Result<(), Failure> {
    let words: Vec<String> =
        words.iter().map(|word| word.to_lowercase().replace('_', " ")).collect();
    let mut rows = Vec::new();
    for unit in standard() {
        let card = card(unit)?;
        let text = searched(&card);
        if words.iter().all(|word| text.contains(word)) {
            rows.push([card.name, card.title]);
        }
    }
    if rows.is_empty() {
        let message = format!("no part matches `{}`", words.join(" ").escape_debug());
        return Err(Failure::input(message, "`machinist parts` lists them all"));
    }
    print(&columns(&rows, 2))
}

/// Returns the text that is searched for words, in lower case.
fn searched(card: &Card) -> String {
    let ports = card.ports.iter().flatten().chain(card.parts.iter().flatten());
    let parameters = card.parameters.iter().flat_map(|[name, _, _, doc]| [name, doc]);
    let inputs = card.inputs.iter().flat_map(|[name, _, doc]| [name, doc]);
    let named = [&card.name, &card.title, &card.doc, &card.source].into_iter();
    let named = named.chain(&card.synonyms);
    let all: Vec<&str> =
        named.chain(ports).chain(parameters).chain(inputs).map(String::as_str).collect();
    // The words of names are separated by an underscore, and those of phrases by a space.
    all.join(" ").to_lowercase().replace('_', " ")
}

fn show(name: &str) -> Result<(), Failure> {
    let is_last = |unit: &&LibraryUnit| unit.name.rsplit('/').next() == Some(name);
    let exact = LIBRARY.iter().find(|unit| unit.name == name);
    let found: Vec<&LibraryUnit> = match exact {
        Some(unit) => vec![unit],
        None => standard().filter(is_last).collect(),
    };
    if found.is_empty() {
        let lasts = standard().filter_map(|unit| unit.name.rsplit('/').next());
        let names = LIBRARY.iter().map(|unit| unit.name).chain(lasts);
        let message = format!("there is no part `{}`", name.escape_debug());
        let hint = did_you_mean(name, names);
        return Err(Failure::input(message, format!("{hint}\n`machinist parts` lists them all")));
    }
    let mut texts = Vec::new();
    for unit in found {
        texts.push(plain(&card(unit)?));
    }
    print(&texts.join("\n"))
}

/// Formats a part for a terminal.
fn plain(card: &Card) -> String {
    let paragraphs = [
        format!("{}: {}", card.name, card.title),
        card.doc.clone(),
        format!("Source: {}", card.source),
        match card.synonyms.as_slice() {
            [] => String::new(),
            synonyms => format!("Also found by: {}", synonyms.join(", ")),
        },
    ];
    let mut text: String = paragraphs.iter().flat_map(|text| text.lines()).map(paragraph).collect();
    let formula = |line: String| indented(&line, "", width() - SECTION.len());
    let mut section = |heading: &str, rows: String| {
        if !rows.is_empty() {
            let _ = write!(text, "\n{heading}\n");
            rows.lines().for_each(|line| {
                let _ = writeln!(text, "{}", format!("{SECTION}{line}").trim_end());
            });
        }
    };
    section("Ports", columns_of_section(&card.ports, 3));
    section("Connectors", columns_of_section(&card.connectors, 2));
    section("Parts", columns_of_section(&card.parts, 3));
    section("Joints", joints(card));
    section("Parameters", columns_of_section(&card.parameters, 4));
    section("Inputs", columns_of_section(&card.inputs, 3));
    section("Modes", columns_of_section(&card.modes, 2));
    let equations = card.equations.iter().map(|[left, right, unit, doc]| {
        let unit = if unit.is_empty() { String::new() } else { format!("   [{unit}]") };
        formula(format!("{left} = {right}{unit}   {doc}"))
    });
    section("Equations", equations.collect());
    let events =
        card.events.iter().map(|[when, set, doc]| formula(format!("{when}: {set}   {doc}")));
    section("Events", events.collect());
    section("Outputs", columns_of_section(&card.outputs, 3));
    section("Example", card.example.unwrap_or_default().to_owned());
    text
}

fn joints(card: &Card) -> String {
    card.joints.iter().fold(String::new(), |mut text, [first, second]| {
        let _ = writeln!(text, "{first} = {second}");
        text
    })
}

/// Returns all parts in Markdown.
fn page() -> Result<String, Failure> {
    let mut text = format!(
        "# Standard parts\n\nMade from `specs/units` by `{MENDING_COMMAND}`; do not edit.\n\n\
         What a scene writes as `unit = \"rotational/gear\"`. Joints connect ports by name; a part's \
         example shows how. `machinist parts WORD` searches this list, `machinist parts show NAME` \
         prints one of them.\n\n| part | what it is |\n| --- | --- |\n"
    );
    let cards = standard().map(card).collect::<Result<Vec<Card>, Failure>>()?;
    for card in &cards {
        let anchor = card.name.replace('/', "");
        let _ = writeln!(text, "| [{}](#{anchor}) | {} |", card.name, card.title);
    }
    for card in &cards {
        text.push_str(&section(card));
    }
    Ok(text)
}

/// Returns a part in Markdown.
fn section(card: &Card) -> String {
    let mut text =
        format!("\n## {}\n\n{}. {}\n\n*{}*\n", card.name, card.title, card.doc, card.source);
    table(&mut text, ["port", "kind", "moves by"], &card.ports);
    table(&mut text, ["connector", "ports"], &card.connectors);
    table(&mut text, ["part", "unit", "with"], &card.parts);
    if !card.joints.is_empty() {
        let _ = write!(text, "\n```text,formula\n{}```\n", joints(card));
    }
    table(&mut text, ["parameter", "default", "unit", "meaning"], &card.parameters);
    table(&mut text, ["input", "unit", "meaning"], &card.inputs);
    table(&mut text, ["mode", "meaning"], &card.modes);
    if !card.equations.is_empty() || !card.events.is_empty() {
        text.push_str("\n```text,formula\n");
        for [left, right, unit, _] in &card.equations {
            let unit = if unit.is_empty() { String::new() } else { format!("   [{unit}]") };
            let _ = writeln!(text, "{left} = {right}{unit}");
        }
        for [when, set, _] in &card.events {
            let _ = writeln!(text, "{when}: {set}");
        }
        text.push_str("```\n");
    }
    table(&mut text, ["output", "unit", "meaning"], &card.outputs);
    let _ = writeln!(
        text,
        "\nExample: [specs/scenes/parts/{0}.toml](../../../specs/scenes/parts/{0}.toml)",
        card.name
    );
    text
}

fn table<const N: usize>(text: &mut String, heads: [&str; N], rows: &[[String; N]]) {
    if rows.is_empty() {
        return;
    }
    let rule = ["---"; N].join(" | ");
    let _ = write!(text, "\n| {} |\n| {rule} |\n", heads.join(" | "));
    for row in rows {
        let _ = writeln!(text, "| {} |", row.join(" | "));
    }
}

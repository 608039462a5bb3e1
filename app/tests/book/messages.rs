//! Messages in the book are those that the program prints.

use std::fs;
use std::path::{Path, PathBuf};

use super::alike::line_matches;
use super::chapter;
use super::markdown::{Piece, codes};
use crate::process::REPOSITORY;

/// Sections of this chapter have a message as heading and show a command that prints it.
#[test]
fn every_message_of_the_book_is_one_that_the_program_prints() {
    let mut of_heading = None::<String>;
    let (mut sections, mut unshown) = (0, Vec::new());
    for piece in chapter("troubleshooting.md").pieces {
        match piece {
            Piece::Heading(_, codes) => {
                unshown.extend(of_heading.take());
                of_heading = codes.into_iter().next();
            }
            Piece::Block(block) if block.language == "console" => {
                let shown = unwrapped(&block.text);
                if of_heading.as_ref().is_some_and(|message| is_within(message, &shown)) {
                    of_heading = None;
                    sections += 1;
                }
            }
            _ => {}
        }
    }
    unshown.extend(of_heading);
    assert!(unshown.is_empty(), "not said by the program: {unshown:#?}");
    assert!(sections > 15, "{sections} sections");
}

/// Each code has one section, and tables have messages of the tests' bad specs with that code.
#[test]
fn every_code_of_an_error_has_a_section_and_every_section_a_code() {
    let known = known();
    let (mut code, mut sections, mut rows, mut unknown) =
        (String::new(), Vec::new(), 0, Vec::new());
    for piece in chapter("errors.md").pieces {
        match piece {
            Piece::Heading(_, codes) => {
                code = codes.into_iter().next().unwrap_or_default();
                sections.extend((!code.is_empty()).then(|| code.clone()));
            }
            Piece::Row(cells) => {
                let message = message_of(&cells[0]);
                let is_known = |known: &Known| known.0 == code && line_matches(&message, &known.1);
                unknown.extend((!known.iter().any(is_known)).then(|| (code.clone(), message)));
                rows += 1;
            }
            _ => {}
        }
    }
    sections.sort();
    let codes = machinist_app::error_codes();
    assert_eq!(sections, codes);
    assert!(unknown.is_empty(), "not said by the program: {unknown:#?}");
    assert!(rows > 40, "{rows} rows");
    for (code, message) in known {
        assert!(codes.contains(&code.as_str()), "`{code}` of {message}");
    }
}

/// The list of codes leaves out no type of error.
#[test]
fn every_type_with_codes_is_listed() {
    let codes = machinist_app::error_codes();
    let mut count = 0;
    for folder in ["src", "crates", "codegen/src", "app/src"] {
        for path in sources(&Path::new(REPOSITORY).join(folder)) {
            let text = fs::read_to_string(&path).expect("a source file");
            for rest in text.split("#[strum(prefix = \"").skip(1) {
                let (prefix, rest) = rest.split_once('"').expect("an end of the prefix");
                let variant = first_variant(rest).expect("a variant");
                let code = format!("{prefix}{}", kebab(variant));
                assert!(codes.contains(&code.as_str()), "{code} of {}", path.display());
                count += 1;
            }
        }
    }
    assert!(count > 20, "{count} types");
}

/// Returns the name of the first variant that has a code by its name.
fn first_variant(text: &str) -> Option<&str> {
    let mut is_named = false;
    text.lines().find_map(|line| {
        is_named |= line.trim_start().starts_with("#[strum(serialize");
        let name = line.strip_prefix("    ")?.split([',', ' ', '(']).next()?;
        let is_variant = name.starts_with(|c: char| c.is_ascii_uppercase());
        (is_variant && !std::mem::take(&mut is_named)).then_some(name)
    })
}

fn kebab(name: &str) -> String {
    let parts = name.char_indices().map(|(at, c)| match c {
        'A'..='Z' if at > 0 => format!("-{}", c.to_ascii_lowercase()),
        c => c.to_ascii_lowercase().to_string(),
    });
    parts.collect()
}

fn sources(folder: &Path) -> Vec<PathBuf> {
    let mut found = Vec::new();
    for entry in fs::read_dir(folder).expect("a folder") {
        let path = entry.expect("an entry").path();
        if path.is_dir() {
            found.extend(sources(&path));
        } else if path.extension().is_some_and(|ending| ending == "rs") {
            found.push(path);
        }
    }
    found
}

/// Returns the message of a cell as the program prints it, with backticks, from double backticks or
/// a single code span.
fn message_of(cell: &str) -> String {
    let inner = cell.strip_prefix('`').and_then(|cell| cell.strip_suffix('`'));
    inner.unwrap_or_else(|| codes(cell).next().unwrap_or_default()).trim().to_owned()
}

/// Code and message of an error.
type Known = (String, String);

/// Returns the errors of the tests' bad specs.
fn known() -> Vec<Known> {
    let mut known = Vec::new();
    for entry in fs::read_dir(Path::new(REPOSITORY).join("codegen/tests/fail")).expect("a folder") {
        let path = entry.expect("an entry").path();
        if path.extension().is_some_and(|ending| ending == "snap") {
            known.extend(messages(&fs::read_to_string(path).expect("a snapshot")));
        }
    }
    known
}

/// Returns the errors of an answer that have a code: a line that ends in it, then one that starts with a cross,
/// with its continuation lines.
fn messages(text: &str) -> Vec<Known> {
    let mut messages: Vec<Known> = Vec::new();
    let (mut code, mut goes_on) = ("", false);
    for line in text.lines() {
        let line = line.trim();
        if let Some(message) = line.strip_prefix('\u{d7}').filter(|_| !code.is_empty()) {
            messages.push((code.to_owned(), message.trim().to_owned()));
            goes_on = true;
        } else if let (true, Some(more)) = (goes_on, line.strip_prefix('\u{2502}')) {
            let (_, message) = messages.last_mut().expect("it was begun");
            message.push(' ');
            message.push_str(more.trim());
        } else {
            goes_on = false;
            code = line.split(' ').find(|word| word.contains("::")).unwrap_or(code);
        }
    }
    messages
}

/// Joins a text that may be wrapped anywhere to one line.
fn unwrapped(text: &str) -> String {
    let text = text.replace('\u{2502}', " ");
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

/// Returns whether a text contains a message, in which `...` stands for variable parts.
fn is_within(message: &str, text: &str) -> bool {
    line_matches(&format!("...{message}..."), text)
}

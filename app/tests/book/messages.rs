//! Messages in the book are those that the program prints.

use std::fs;
use std::path::Path;

use super::alike::line_matches;
use super::chapter;
use super::markdown::{Piece, codes};
use crate::process::REPOSITORY;

/// Chapter that lists messages.
const CHAPTER: &str = "troubleshooting.md";

/// Sections have a message as heading and show a command that prints it. Tables have messages from
/// the tests' bad specs.
#[test]
fn every_message_of_the_book_is_one_that_the_program_prints() {
    let known = known();
    let (mut of_heading, mut is_of_messages) = (None::<String>, false);
    let (mut sections, mut rows, mut unshown) = (0, 0, Vec::new());
    for piece in chapter(CHAPTER).pieces {
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
            Piece::Head(cells) => is_of_messages = cells[0] == "message",
            Piece::Row(cells) if is_of_messages => {
                let message = message_of(&cells[0]);
                let is_known = known.iter().any(|known| line_matches(&message, known));
                unshown.extend((!is_known).then_some(message));
                rows += 1;
            }
            _ => {}
        }
    }
    unshown.extend(of_heading);
    assert!(unshown.is_empty(), "not said by the program: {unshown:#?}");
    assert!(sections > 15 && rows > 40, "{sections} sections, {rows} rows");
}

/// Returns the message of a cell as the program prints it, with backticks, from double backticks or
/// a single code span.
fn message_of(cell: &str) -> String {
    let inner = cell.strip_prefix('`').and_then(|cell| cell.strip_suffix('`'));
    inner.unwrap_or_else(|| codes(cell).next().unwrap_or_default()).trim().to_owned()
}

/// Returns the messages of the tests' bad specs, one on each line.
fn known() -> Vec<String> {
    let mut known = Vec::new();
    for entry in fs::read_dir(Path::new(REPOSITORY).join("codegen/tests/fail")).expect("a folder") {
        let path = entry.expect("an entry").path();
        if path.extension().is_some_and(|ending| ending == "snap") {
            known.extend(messages(&fs::read_to_string(path).expect("a snapshot")));
        }
    }
    known
}

/// Returns the messages of an answer, each a line that starts with a cross, with its continuation
/// lines.
fn messages(text: &str) -> Vec<String> {
    let mut messages: Vec<String> = Vec::new();
    let mut goes_on = false;
    for line in text.lines() {
        let line = line.trim();
        if let Some(message) = line.strip_prefix('\u{d7}') {
            messages.push(message.trim().to_owned());
            goes_on = true;
        } else if let (true, Some(more)) = (goes_on, line.strip_prefix('\u{2502}')) {
            let message = messages.last_mut().expect("it was begun");
            message.push(' ');
            message.push_str(more.trim());
        } else {
            goes_on = false;
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

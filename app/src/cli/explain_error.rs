//! `machinist explain-error`: cause of an error and how to mend it, by the code in its first line.

use clap::Args;

use super::output::print;
use super::table::paragraph;
use crate::codes::{codes, section};
use crate::failure::Failure;

#[derive(Debug, Args)]
pub struct ExplainError {
    /// Code in the first line of an error, such as spec::unknown-name; all codes if left out
    code: Option<String>,
}

impl ExplainError {
    pub fn execute(&self) -> Result<(), Failure> {
        let Some(code) = &self.code else { return print(&(codes().join("\n") + "\n")) };
        let Some(text) = section(code) else {
            let message = format!("no error has the code `{}`", code.escape_debug());
            return Err(Failure::unknown(message, code, codes().into_iter()));
        };
        print(&plain(text))
    }
}

/// Returns a section as it is read in a terminal: paragraphs wrapped, links and emphasis as plain
/// text. Tables stay as they are.
fn plain(section: &str) -> String {
    let parts = section.split("\n\n").map(|part| {
        if part.starts_with('|') {
            return format!("{part}\n");
        }
        paragraph(&without_links(
            &part.replace('\n', " ").replace("*Cause:*", "Cause:").replace("*Fix:*", "Fix:"),
        ))
    });
    parts.collect::<Vec<_>>().join("\n")
}

/// Replaces `[text](target)` by its text.
fn without_links(text: &str) -> String {
    let Some((before, rest)) = text.split_once('[') else { return text.to_owned() };
    match rest.split_once("](").and_then(|(inner, rest)| Some((inner, rest.split_once(')')?))) {
        Some((inner, (_, after))) if !inner.contains('`') => {
            format!("{before}{inner}{}", without_links(after))
        }
        _ => format!("{before}[{}", without_links(rest)),
    }
}

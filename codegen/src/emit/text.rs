//! Sanitizing of free text of specs for comments and docs.

use proc_macro2::TokenStream;
use quote::quote;

/// Returns one `#[doc]` attribute for each line of Markdown, which is written by this crate or
/// escaped by [`markdown`].
pub(crate) fn doc<Line: AsRef<str>>(lines: impl IntoIterator<Item = Line>) -> TokenStream {
    let attributes = lines.into_iter().map(|line| {
        let line = line.as_ref();
        let line = if line.is_empty() { String::new() } else { format!(" {line}") };
        quote!(#[doc = #line])
    });
    quote!(#(#attributes)*)
}

/// Returns lines of plain text for `//` comments. Nothing in them can end the comment, and no
/// invisible character can disguise them.
#[must_use]
pub fn comment_lines(text: &str) -> Vec<String> {
    let lines = text.lines().map(|line| visible(line).trim().to_owned());
    let mut lines: Vec<String> = lines.collect();
    while lines.last().is_some_and(String::is_empty) {
        lines.pop();
    }
    lines
}

/// Returns lines of Markdown that show `text` as it is. Paragraphs are kept, and nothing in it
/// becomes a link, a heading, a list, HTML or code.
#[must_use]
pub fn markdown(text: &str) -> Vec<String> {
    comment_lines(text).iter().map(|line| escape_line(line)).collect()
}

/// Returns [`markdown`] as a single line.
#[must_use]
pub fn markdown_line(text: &str) -> String {
    markdown(text).join(" ").trim().to_owned()
}

/// Escapes all Markdown characters in a line. Addresses are put in angle brackets, as rustdoc
/// requires.
fn escape_line(line: &str) -> String {
    let words = line.split(' ').enumerate().map(|(index, word)| {
        if is_address(word) { format!("<{word}>") } else { escape_word(word, index == 0) }
    });
    words.collect::<Vec<_>>().join(" ")
}

/// Reports whether a word is a web address of characters that need no escape.
fn is_address(word: &str) -> bool {
    let rest = word.strip_prefix("https://").or_else(|| word.strip_prefix("http://"));
    rest.is_some_and(|rest| {
        !rest.is_empty()
            && rest.chars().all(|c| c.is_ascii_alphanumeric() || "-._~/?#&=%+:".contains(c))
    })
}

fn escape_word(word: &str, first: bool) -> String {
    let mut escaped = String::with_capacity(word.len());
    let numbered = word.trim_end_matches(['.', ')']);
    let is_item_number = first
        && numbered.len() < word.len()
        && !numbered.is_empty()
        && numbered.bytes().all(|byte| byte.is_ascii_digit());
    for (index, character) in word.chars().enumerate() {
        let mark = matches!(character, '\\' | '`' | '[' | ']' | '<' | '>' | '*' | '~' | '|' | '&')
            || (first && index == 0 && matches!(character, '#' | '-' | '+' | '=' | '_'))
            || (is_item_number && matches!(character, '.' | ')'));
        // A bare address that is not valid within angle brackets.
        let scheme = character == ':' && word[..].contains("://");
        if mark || scheme {
            escaped.push('\\');
        }
        escaped.push(character);
    }
    escaped
}

/// Spells out control characters and characters that reorder text.
fn visible(line: &str) -> String {
    let mut shown = String::with_capacity(line.len());
    for character in line.chars() {
        match character {
            '\t' => shown.push(' '),
            '\u{200b}'..='\u{200f}'
            | '\u{2028}'..='\u{202e}'
            | '\u{2066}'..='\u{2069}'
            | '\u{feff}' => shown.extend(character.escape_unicode()),
            _ if character.is_control() => shown.extend(character.escape_unicode()),
            _ => shown.push(character),
        }
    }
    shown
}

#[cfg(test)]
mod tests {
    use super::{comment_lines, markdown, markdown_line};

    #[test]
    fn marks_of_markdown_are_escaped() {
        assert_eq!(markdown_line("see [x](y) `z` <b>"), r"see \[x\](y) \`z\` \<b\>");
        assert_eq!(
            markdown("# a\n- b\n1. c\n\n    let d;"),
            [r"\# a", r"\- b", r"1\. c", "", "let d;"]
        );
    }

    #[test]
    fn equations_stay_as_they_are() {
        assert_eq!(markdown_line("psi_x1' = Um cos g - w0"), "psi_x1' = Um cos g - w0");
        assert_eq!(markdown_line("-1 below zero"), r"\-1 below zero");
    }

    #[test]
    fn addresses_are_linked() {
        assert_eq!(
            markdown_line("from https://example.org/a?b=1 on"),
            "from <https://example.org/a?b=1> on"
        );
        assert_eq!(markdown_line("https://example.org/\"a\""), r#"https\://example.org/"a""#);
    }

    #[test]
    fn characters_that_hide_are_spelled_out() {
        assert_eq!(comment_lines("a\u{202e}b\rc\u{0}"), [r"a\u{202e}b\u{d}c\u{0}"]);
    }
}

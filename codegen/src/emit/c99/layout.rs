//! Layout of C lines, and comments that free text cannot end.

use crate::emit::text::comment_lines;

/// Maximum length of a line, if it can be broken.
const WIDTH: usize = 100;

/// Breaks a statement, or any text without strings and comments, into indented lines.
pub(super) fn statement(text: &str, indent: usize) -> String {
    let mut lines = String::new();
    let mut line = " ".repeat(indent);
    let mut is_empty = true;
    for word in text.split(' ') {
        if !is_empty && line.len() + 1 + word.len() > WIDTH {
            lines.push_str(&line);
            lines.push('\n');
            line = " ".repeat(indent + 4);
            is_empty = true;
        }
        if !is_empty {
            line.push(' ');
        }
        line.push_str(word);
        is_empty = false;
    }
    lines.push_str(&line);
    lines.push('\n');
    lines
}

/// Returns statements, each on a line of its own.
pub(super) fn statements<'a>(all: impl IntoIterator<Item = &'a String>) -> String {
    all.into_iter().map(|text| statement(text, 4)).collect()
}

/// Returns a comment of several lines. Free text in it is sanitized.
pub(super) fn comment<Line: AsRef<str>>(lines: impl IntoIterator<Item = Line>) -> String {
    let lines = lines.into_iter().flat_map(|line| {
        let line = line.as_ref();
        let indent = line.len() - line.trim_start().len();
        broken(&harmless(line), indent)
    });
    let lines: Vec<String> = lines.collect();
    match lines.as_slice() {
        [one] if one.len() + 6 <= WIDTH => format!("/* {one} */\n"),
        many => {
            let mut text = String::from("/*");
            for (index, line) in many.iter().enumerate() {
                let start = if index == 0 { " " } else { " * " };
                text.push_str(format!("{start}{line}").trim_end());
                text.push('\n');
            }
            text.truncate(text.trim_end().len());
            text.push_str(" */\n");
            text
        }
    }
}

/// Returns a comment that follows something else on its line.
pub(super) fn remark(text: &str) -> String {
    format!("/* {} */", harmless(text).trim())
}

/// Returns text that neither ends nor begins a comment, and contains no trigraph.
fn harmless(text: &str) -> String {
    let line = comment_lines(text).join(" ");
    line.replace("*/", "* /").replace("/*", "/ *").replace("??", "? ?")
}

/// Breaks a text into lines that fit into a comment.
fn broken(text: &str, indent: usize) -> Vec<String> {
    let mut lines = vec![" ".repeat(indent)];
    for word in text.split_whitespace() {
        let line = lines.last_mut().expect("there is a line");
        if line.trim().is_empty() {
            line.push_str(word);
        } else if line.chars().count() + 1 + word.chars().count() <= WIDTH - 3 {
            line.push(' ');
            line.push_str(word);
        } else {
            lines.push(format!("{}{word}", " ".repeat(indent)));
        }
    }
    lines
}

#[cfg(test)]
mod tests {
    use super::{comment, remark, statement};

    #[test]
    fn long_statements_are_broken_between_words() {
        let text = ["abcdefghi"; 12].join(" ");
        let lines = statement(&text, 4);
        assert!(lines.lines().all(|line| line.len() <= 100), "{lines}");
        assert_eq!(lines.split_whitespace().collect::<Vec<_>>().join(" "), text);
        assert!(lines.lines().nth(1).is_some_and(|line| line.starts_with("        a")));
    }

    #[test]
    fn free_text_ends_no_comment() {
        let text = remark("a */ int b; /* c ??/");
        assert_eq!(text, "/* a * / int b; / * c ? ?/ */");
        assert_eq!(comment(["one"]), "/* one */\n");
        assert_eq!(comment(["one", "", "  two"]), "/* one\n *\n *   two */\n");
    }
}

//! Line layout of an emitted file: full lines, broken where an expression is least nested.
//!
//! Excluded: the contents of lines. The token printer writes lists with one element per line and
//! breaks every call that does not fit. Equations would then take several times as many lines as
//! readers want.

/// Maximum length of a line in characters.
pub(super) const WIDTH: usize = 100;

/// Cost of one level of nesting, in characters, in the choice of a place to break.
const DEPTH_WEIGHT: usize = 14;

/// Joins and breaks statements, signatures and lists anew, and inserts an empty line between
/// items.
pub(super) fn lay_out(text: &str) -> String {
    let lines: Vec<&str> = text.lines().collect();
    let mut laid_out = String::with_capacity(text.len());
    let mut index = 0;
    let mut previous = String::new();
    while index < lines.len() {
        let first = lines[index];
        let of_attribute = attribute(&lines[index..]);
        if of_attribute > 1 {
            for line in &lines[index..index + of_attribute] {
                laid_out.push_str(line);
                laid_out.push('\n');
            }
            index += of_attribute;
            continue;
        }
        let count = if is_whole(first) { 1 } else { unit(&lines[index..]) };
        let joined = join(&lines[index..index + count]);
        index += count;
        let indent = first.len() - first.trim_start().len();
        if ends_item(&previous) && !joined.is_empty() && indent == 0 && !joined.starts_with('}') {
            laid_out.push('\n');
        }
        for line in broken(&joined, indent) {
            laid_out.push_str(line.trim_end());
            laid_out.push('\n');
            previous = line;
        }
    }
    laid_out
}

/// Reports whether an item of the module ends with this line.
fn ends_item(line: &str) -> bool {
    matches!(line.bytes().last(), Some(b'}' | b';')) && !line.starts_with(['/', ' '])
}

/// Returns the number of lines of the attribute that begins here; 0 if there is none.
fn attribute(lines: &[&str]) -> usize {
    if !lines[0].trim_start().starts_with("#[") {
        return 0;
    }
    let mut depth = 0;
    let ends = lines.iter().position(|line| {
        depth += nesting(line);
        depth == 0
    });
    ends.map_or(1, |last| last + 1)
}

/// Reports whether a line is kept as it is: a comment, an attribute, or empty.
fn is_whole(line: &str) -> bool {
    let line = line.trim_start();
    line.is_empty() || line.starts_with("//") || line.starts_with("#[")
}

/// Returns the number of lines of the statement, signature, field or list that begins here.
fn unit(lines: &[&str]) -> usize {
    if let Some(count) = list_of_names(lines) {
        return count;
    }
    let mut depth = 0_i32;
    for (index, line) in lines.iter().enumerate() {
        if is_whole(line) {
            return 1;
        }
        depth += nesting(line);
        let next = lines.get(index + 1).map_or("}", |next| next.trim_start());
        let ends = matches!(line.bytes().last(), Some(b';' | b'{' | b'}' | b','));
        if depth <= 0 && (ends || next.starts_with('}')) {
            return index + 1;
        }
    }
    lines.len()
}

/// Returns the number of lines of a struct whose fields are only names.
fn list_of_names(lines: &[&str]) -> Option<usize> {
    let is_name = |text: &str| text.chars().all(|c| c.is_alphanumeric() || c == '_');
    let begins = lines[0].trim_start().strip_suffix(" {")?;
    if !begins.starts_with(|c: char| c.is_uppercase()) || !is_name(begins) {
        return None;
    }
    let end = lines.iter().position(|line| line.trim_start().starts_with('}'))?;
    let fields = &lines[1..end];
    fields.iter().all(|line| line.trim().strip_suffix(',').is_some_and(is_name)).then_some(end + 1)
}

fn nesting(line: &str) -> i32 {
    let change = |byte| match byte {
        b'(' | b'[' => 1,
        b')' | b']' => -1,
        _ => 0,
    };
    line.bytes().map(change).sum()
}

/// Joins lines, without the trailing commas of lists that had one element per line.
fn join(lines: &[&str]) -> String {
    let mut joined = lines[0].trim().to_owned();
    for line in &lines[1..] {
        let line = line.trim();
        if line.starts_with([')', ']']) && joined.ends_with(',') {
            joined.pop();
        }
        if line.starts_with('}') && joined.ends_with(',') {
            joined.pop();
        }
        let is_tight = joined.ends_with(['(', '['])
            || line.starts_with([')', ']', ';'])
            || (line.starts_with('.') && !joined.ends_with(','));
        if !is_tight {
            joined.push(' ');
        }
        joined.push_str(line);
    }
    joined
}

/// Breaks a text into lines that fit; lines after the first are indented further.
pub(super) fn broken(text: &str, indent: usize) -> Vec<String> {
    let is_comment = text.starts_with("//") || text.starts_with("#[");
    let further = indent + if text.ends_with('{') { 8 } else { 4 };
    let mut lines = Vec::new();
    let mut open = Vec::new();
    let (mut rest, mut margin) = (text, indent);
    while margin + rest.chars().count() > WIDTH && !is_comment {
        let Some(at) = place_to_break(rest, WIDTH - margin, &open) else { break };
        rest[..at].bytes().for_each(|byte| follow(byte, &mut open));
        lines.push(format!("{:margin$}{}", "", rest[..at].trim_end()));
        rest = rest[at..].trim_start();
        margin = further;
    }
    lines.push(format!("{:margin$}{rest}", ""));
    lines
}

/// Keeps track of open brackets.
fn follow(byte: u8, open: &mut Vec<u8>) {
    match byte {
        b'(' | b'[' => open.push(byte),
        b')' | b']' => drop(open.pop()),
        _ => {}
    }
}

/// Returns where to break a line: far to the right, but at low nesting, and between the elements
/// of a list rather than within one.
fn place_to_break(text: &str, room: usize, open: &[u8]) -> Option<usize> {
    let bytes = text.as_bytes();
    let mut open = open.to_vec();
    let mut is_string = false;
    let mut best: Option<(bool, usize, usize)> = None;
    for at in 1..bytes.len().min(room + 1) {
        let byte = bytes[at - 1];
        if byte == b'"' && (at < 2 || bytes[at - 2] != b'\\') {
            is_string = !is_string;
        }
        if is_string {
            continue;
        }
        follow(byte, &mut open);
        if !text.is_char_boundary(at) || !may_break(text, at) {
            continue;
        }
        let is_within_element =
            open.last() == Some(&b'[') && !text[..at].trim_end().ends_with([',', ']']);
        let is_good = !is_within_element && at >= room / 3;
        let worth = at + DEPTH_WEIGHT * 8 - DEPTH_WEIGHT * open.len().min(8);
        if best.is_none_or(|(was_good, known, _)| (is_good, worth) >= (was_good, known)) {
            best = Some((is_good, worth, at));
        }
    }
    best.map(|(_, _, at)| at)
}

/// Reports whether a line may end before this byte: after a comma or a space of a list, before an
/// operator, before a method.
fn may_break(text: &str, at: usize) -> bool {
    let (before, after) = (&text[..at], &text[at..]);
    if before.ends_with(", ") || before.ends_with("] ") {
        return true;
    }
    if before.ends_with(' ') {
        let operators = ["* ", "/ ", "+ ", "- "];
        return operators.iter().any(|operator| after.starts_with(operator))
            || before.trim_end().ends_with(|c: char| c.is_ascii_digit())
                && after.starts_with(|c: char| c.is_ascii_digit());
    }
    after.strip_prefix('.').is_some_and(|method| {
        let name = method.find(|c: char| !(c.is_alphanumeric() || c == '_'));
        name.is_some_and(|end| end > 0 && method[end..].starts_with('('))
    }) && !before.ends_with(' ')
}

#[cfg(test)]
mod tests {
    use super::lay_out;

    #[test]
    fn statements_and_lists_fill_their_lines() {
        let text = "\
pub fn f<R: Real>(
    a: R,
    b: R,
) -> [R; 2] {
    let [x, y,
    z] = *state;
    let sum = (a * b)
        .add_product(
            a,
            b,
        ) - c;
    [
        sum,
        R::literal(0.0),
    ]
}
pub fn g() -> Pair {
    Pair {
        a,
        b,
    }
}
";
        let expected = "\
pub fn f<R: Real>(a: R, b: R) -> [R; 2] {
    let [x, y, z] = *state;
    let sum = (a * b).add_product(a, b) - c;
    [sum, R::literal(0.0)]
}

pub fn g() -> Pair {
    Pair { a, b }
}
";
        assert_eq!(lay_out(text), expected);
    }

    #[test]
    fn long_expressions_break_where_they_are_least_nested() {
        let text = "    let x = first_of_many_long_names * (second_of_many_long_names + third) \
                    + fourth_of_many_long_names * fifth_of_them;\n";
        let expected = "    let x = first_of_many_long_names * (second_of_many_long_names + third)\n        \
                        + fourth_of_many_long_names * fifth_of_them;\n";
        assert_eq!(lay_out(text), expected);
    }
}

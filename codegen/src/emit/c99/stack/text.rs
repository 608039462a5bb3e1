//! The parts of emitted C that declare something: structs, functions, variables.

use std::collections::BTreeMap;

/// A word, a number or a sign.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Token(String);

impl Token {
    pub(super) fn is(&self, text: &str) -> bool {
        self.0 == text
    }

    pub(super) fn is_word(&self) -> bool {
        self.0.starts_with(|c: char| c.is_ascii_alphabetic() || c == '_')
    }

    pub(super) fn text(&self) -> &str {
        &self.0
    }
}

/// An item outside functions.
#[derive(Debug)]
pub(super) enum Item {
    Structure { name: String, members: Vec<Token> },
    Function { name: String, arguments: Vec<Token>, body: Vec<Token> },
}

/// Variables of one declaration.
#[derive(Debug)]
pub(super) struct Declaration {
    pub(super) is_static: bool,
    /// Name of their type, as `double` or `unsigned int`; a struct by its tag.
    pub(super) kind: String,
    pub(super) variables: Vec<Variable>,
}

/// A variable without its type.
#[derive(Debug, Default)]
pub(super) struct Variable {
    pub(super) is_pointer: bool,
    pub(super) points_to_array: bool,
    /// Expressions of the sizes of an array.
    pub(super) sizes: Vec<Vec<Token>>,
}

/// Returns a text without comments, and without what only C++ reads.
pub(super) fn without_comments(text: &str) -> String {
    let mut plain = String::with_capacity(text.len());
    let mut rest = text;
    while let Some(start) = rest.find("/*") {
        plain.push_str(&rest[..start]);
        plain.push(' ');
        rest = rest[start..].split_once("*/").map_or("", |(_, rest)| rest);
    }
    plain.push_str(rest);
    let mut is_skipped = false;
    let lines = plain.lines().filter(|line| {
        let line = line.trim_start();
        is_skipped = line.starts_with("#ifdef __cplusplus") || is_skipped;
        let is_kept = !is_skipped;
        is_skipped &= !line.starts_with("#endif");
        is_kept
    });
    lines.fold(String::new(), |text, line| text + line + "\n")
}

/// Returns the constants that macros define.
pub(super) fn definitions(text: &str) -> impl Iterator<Item = (String, Vec<Token>)> {
    text.lines().filter_map(|line| {
        let (name, value) = line.trim_start().strip_prefix("#define ")?.split_once(' ')?;
        Some((name.to_owned(), tokens(value)))
    })
}

/// Returns the tokens of a text, without lines of the preprocessor.
pub(super) fn tokens(text: &str) -> Vec<Token> {
    let mut tokens = Vec::new();
    for line in text.lines().filter(|line| !line.trim_start().starts_with('#')) {
        let mut word = String::new();
        for sign in line.chars().chain([' ']) {
            if sign.is_ascii_alphanumeric() || sign == '_' || (sign == '.' && is_number(&word)) {
                word.push(sign);
                continue;
            }
            if !word.is_empty() {
                tokens.push(Token(std::mem::take(&mut word)));
            }
            if !sign.is_whitespace() {
                tokens.push(Token(sign.to_string()));
            }
        }
    }
    tokens
}

fn is_number(word: &str) -> bool {
    word.starts_with(|c: char| c.is_ascii_digit())
}

/// Returns the place of the bracket that closes the one at a place.
fn closing(tokens: &[Token], open: usize) -> usize {
    let mut depth = 0_usize;
    for (place, token) in tokens.iter().enumerate().skip(open) {
        match token.text() {
            "(" | "[" | "{" => depth += 1,
            ")" | "]" | "}" => depth -= 1,
            _ => {}
        }
        if depth == 0 {
            return place;
        }
    }
    tokens.len()
}

/// Returns the structs and functions that a text defines.
pub(super) fn items(tokens: &[Token]) -> Vec<Item> {
    let mut items = Vec::new();
    let mut start = 0;
    let mut place = 0;
    while place < tokens.len() {
        match tokens[place].text() {
            ";" => start = place + 1,
            "(" | "[" => place = closing(tokens, place),
            "{" => {
                let end = closing(tokens, place);
                let (head, inner) = (&tokens[start..place], &tokens[place + 1..end]);
                let is_enumeration = head.first().is_some_and(|first| first.is("enum"));
                if is_enumeration || head.iter().any(|token| token.is("=")) {
                    // Nothing but values.
                } else if let Some(open) = head.iter().position(|token| token.is("(")) {
                    items.push(Item::Function {
                        name: head[open - 1].0.clone(),
                        arguments: head[open + 1..closing(head, open)].to_vec(),
                        body: inner.to_vec(),
                    });
                    start = end + 1;
                } else {
                    let is_named_later = head.first().is_some_and(|first| first.is("typedef"));
                    let name = if is_named_later { &tokens[end + 1] } else { &head[1] };
                    items.push(Item::Structure { name: name.0.clone(), members: inner.to_vec() });
                }
                place = end;
            }
            _ => {}
        }
        place += 1;
    }
    items
}

/// Splits tokens at commas outside of brackets.
pub(super) fn split_at_commas(tokens: &[Token]) -> impl Iterator<Item = &[Token]> {
    let mut depth = 0_usize;
    tokens.split(move |token| {
        match token.text() {
            "(" | "[" | "{" => depth += 1,
            ")" | "]" | "}" => depth -= 1,
            _ => {}
        }
        depth == 0 && token.is(",")
    })
}

/// Returns the statements of a body that may be declarations: what follows the start of a block,
/// its end, a label or a statement, up to a semicolon.
pub(super) fn statements(body: &[Token]) -> Vec<&[Token]> {
    let mut statements = Vec::new();
    let mut start = 0;
    let mut place = 0;
    while place < body.len() {
        match body[place].text() {
            "(" | "[" => place = closing(body, place),
            // Initial values are a part of their declaration.
            "{" if place > 0 && body[place - 1].is("=") => place = closing(body, place),
            "{" | "}" => start = place + 1,
            ":" if ["case", "default"].contains(&body[start].text()) => start = place + 1,
            ";" => {
                statements.push(&body[start..place]);
                start = place + 1;
            }
            _ => {}
        }
        place += 1;
    }
    statements
}

/// Words that begin statements, or follow one another in them.
const OF_STATEMENTS: [&str; 8] =
    ["return", "break", "continue", "else", "if", "for", "while", "switch"];

/// Returns the declaration that a statement or an argument is, if it is one.
pub(super) fn declaration(tokens: &[Token]) -> Option<Declaration> {
    let is_static = tokens.iter().any(|token| token.is("static"));
    let skipped = ["static", "const", "struct", "extern"];
    let mut rest = tokens;
    while rest.first().is_some_and(|token| skipped.contains(&token.text())) {
        rest = &rest[1..];
    }
    let [first, ..] = rest else { return None };
    if !first.is_word() || OF_STATEMENTS.contains(&first.text()) {
        return None;
    }
    let mut kind = first.0.clone();
    rest = &rest[1..];
    if ["unsigned", "signed"].contains(&&*kind) {
        kind = format!("{kind} {}", rest.first()?.text());
        rest = &rest[1..];
    }
    // A type is followed by a name, by the sign of a pointer, or by nothing: an argument `void`.

    let is_declared = match rest.first() {
        None => false,
        // A pointer to an array.
        Some(token) if token.is("(") => {
            let signs = [(1, "*"), (3, ")"), (4, "[")];
            signs.iter().all(|(place, sign)| rest.get(*place).is_some_and(|token| token.is(sign)))
        }
        Some(token) => token.is("*") || token.is_word(),
    };
    let variables = split_at_commas(rest).map(variable);
    is_declared.then(|| Declaration { is_static, kind, variables: variables.collect() })
}

/// Returns a variable without its initial value.
fn variable(tokens: &[Token]) -> Variable {
    let end = tokens.iter().position(|token| token.is("=")).unwrap_or(tokens.len());
    let tokens = &tokens[..end];
    let mut variable = Variable {
        is_pointer: tokens.iter().any(|token| token.is("*")),
        points_to_array: tokens.first().is_some_and(|token| token.is("(")),
        sizes: Vec::new(),
    };
    let mut place = 0;
    while place < tokens.len() {
        if tokens[place].is("[") {
            let end = closing(tokens, place);
            variable.sizes.push(tokens[place + 1..end].to_vec());
            place = end;
        }
        place += 1;
    }
    variable
}

/// Returns the value of the size of an array: a sum of numbers, constants and sums in brackets.
pub(super) fn value(size: &[Token], constants: &BTreeMap<String, Vec<Token>>) -> usize {
    let terms = size.iter().filter(|token| !["+", "(", ")"].contains(&token.text()));
    let term = |token: &Token| {
        if let Some(value) = constants.get(token.text()) {
            return self::value(value, constants);
        }
        let digits = token.text().trim_end_matches('u');
        digits.parse().unwrap_or_else(|_| panic!("the size `{}`", token.text()))
    };
    terms.map(term).sum()
}

//! Parsing of TOML text into a tree with the span of every key and value.
//!
//! Excluded: comments, layout, and the kinds of tables (inline, dotted, with a header), which
//! mean the same.

use std::ops::Range;

use toml_edit::{Document, Item, Value};

use crate::spec::code::Code;
use crate::spec::diagnostic::{FileId, Mistake, Span, Spanned};

/// A value of a TOML file.
#[derive(Debug, Clone, PartialEq)]
pub enum Tree {
    /// A string.
    Text {
        /// The characters.
        value: String,
        /// Offset of its first character in the file, unless escapes make offsets within it
        /// meaningless.
        inner: Option<u32>,
    },
    /// An integer or a float, with its text.
    Number {
        /// The value as a float.
        value: f64,
        /// The text in the file.
        text: String,
        /// The value, if written as an integer.
        integer: Option<i64>,
    },
    /// `true` or `false`.
    Boolean(bool),
    /// A date or time, which specs do not use.
    Date,
    /// A list.
    List(Vec<Spanned<Tree>>),
    /// A table, in the order of the file.
    Table(Vec<Entry>),
}

/// A key and its value.
#[derive(Debug, Clone, PartialEq)]
pub struct Entry {
    /// The key.
    pub key: Spanned<String>,
    /// The value.
    pub value: Spanned<Tree>,
}

impl Tree {
    /// Returns the kind of the value, with its article.
    #[must_use]
    pub fn kind(&self) -> &'static str {
        match self {
            Tree::Text { .. } => "a string",
            Tree::Number { integer: Some(_), .. } => "an integer",
            Tree::Number { .. } => "a number",
            Tree::Boolean(_) => "true or false",
            Tree::Date => "a date",
            Tree::List(_) => "a list",
            Tree::Table(_) => "a table",
        }
    }
}

/// Parses the text of `file`.
///
/// # Errors
/// If it is not TOML, contains a key twice, or nests too deep.
pub fn parse(text: &str, file: FileId) -> Result<Spanned<Tree>, Mistake> {
    let document = Document::parse(text).map_err(|error| {
        let range = error.span().unwrap_or(0..0);
        let message = match error.message() {
            deep if deep.contains("recurs") => "tables or lists nest too deep".to_owned(),
            other => format!("not valid TOML: {}", first_line(other)),
        };
        let is_unit = is_unit_behind_number(text, range.start);
        let mistake = Mistake::new(Code::InvalidToml, Span::new(file, range), message, "here");
        if is_unit { mistake.help("quote a number with a unit: \"0.1 [s]\"") } else { mistake }
    })?;
    let reader = Reader { text, file };
    let whole = Span::new(file, 0..0);
    Ok(Spanned { value: Tree::Table(reader.entries(document.as_table().iter_keys())), span: whole })
}

/// Reports whether a bracket opens here after a number on its line.
fn is_unit_behind_number(text: &str, at: usize) -> bool {
    let parts = text.get(..at).zip(text.get(at..));
    parts.is_some_and(|(before, rest)| {
        let before = before.trim_end_matches(' ');
        rest.trim_start_matches(' ').starts_with('[')
            && before.ends_with(|last: char| last.is_ascii_digit() || last == '.')
    })
}

fn first_line(text: &str) -> &str {
    text.lines().next().unwrap_or_default()
}

/// Tables of either kind as keys and items.
trait Keyed {
    fn iter_keys(&self) -> Vec<(&toml_edit::Key, &Item)>;
}

impl<T: toml_edit::TableLike + ?Sized> Keyed for T {
    fn iter_keys(&self) -> Vec<(&toml_edit::Key, &Item)> {
        self.iter().filter_map(|(key, _)| self.get_key_value(key)).collect()
    }
}

struct Reader<'a> {
    text: &'a str,
    file: FileId,
}

impl Reader<'_> {
    fn entries(&self, items: Vec<(&toml_edit::Key, &Item)>) -> Vec<Entry> {
        let entries = items.into_iter().filter_map(|(key, item)| {
            let span = self.span(key.span(), self.span(item.span(), Span::new(self.file, 0..0)));
            let value = self.item(item, span)?;
            Some(Entry { key: Spanned { value: key.get().to_owned(), span }, value })
        });
        entries.collect()
    }

    /// Returns an item; `key` is the span for items without one of their own.
    fn item(&self, item: &Item, key: Span) -> Option<Spanned<Tree>> {
        let span = self.span(item.span(), key);
        let value = match item {
            Item::None => return None,
            Item::Value(value) => self.value(value, span),
            Item::Table(table) => Tree::Table(self.entries(table.iter_keys())),
            Item::ArrayOfTables(tables) => {
                let tables = tables.iter().map(|table| Spanned {
                    value: Tree::Table(self.entries(table.iter_keys())),
                    span: self.span(table.span(), key),
                });
                Tree::List(tables.collect())
            }
        };
        Some(Spanned { value, span })
    }

    fn value(&self, value: &Value, span: Span) -> Tree {
        match value {
            Value::String(text) => {
                Tree::Text { value: text.value().clone(), inner: self.inner(text.value(), span) }
            }
            Value::Integer(integer) => Tree::Number {
                value: *integer.value() as f64,
                text: self.slice(span).to_owned(),
                integer: Some(*integer.value()),
            },
            Value::Float(float) => Tree::Number {
                value: *float.value(),
                text: self.slice(span).to_owned(),
                integer: None,
            },
            Value::Boolean(boolean) => Tree::Boolean(*boolean.value()),
            Value::Datetime(_) => Tree::Date,
            Value::Array(list) => {
                let items = list.iter().map(|item| {
                    let span = self.span(item.span(), span);
                    Spanned { value: self.value(item, span), span }
                });
                Tree::List(items.collect())
            }
            Value::InlineTable(table) => Tree::Table(self.entries(table.iter_keys())),
        }
    }

    /// Returns the offset of a string's first character, if its text is in the file unchanged.
    fn inner(&self, value: &str, span: Span) -> Option<u32> {
        let raw = self.slice(span);
        let quotes = ["\"\"\"\r\n", "\"\"\"\n", "'''\r\n", "'''\n", "\"\"\"", "'''", "\"", "'"];
        let quote = quotes.into_iter().find(|quote| raw.starts_with(quote))?;
        let at = span.start as usize + quote.len();
        let same = self.text.get(at..at + value.len()) == Some(value);
        same.then_some(at as u32)
    }

    fn slice(&self, span: Span) -> &str {
        self.text.get(span.start as usize..span.end as usize).unwrap_or_default()
    }

    fn span(&self, range: Option<Range<usize>>, otherwise: Span) -> Span {
        range.map_or(otherwise, |range| Span::new(self.file, range))
    }
}

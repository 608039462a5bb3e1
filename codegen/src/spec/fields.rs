//! Reading of tables: each key is requested once, and keys that are never requested are an error.

use crate::spec::code::Code;
use crate::spec::diagnostic::{Mistake, Span, Spanned};
use crate::spec::expression::{self, Ast, Literal, Text};
use crate::spec::measure::{Measure, UnitError};
use crate::spec::names::{self, did_you_mean, quoted};
use crate::spec::toml::{Entry, Tree};
use crate::spec::{Declared, Formula, Value};

/// Findings of reading, besides the values.
#[derive(Debug, Default)]
pub struct Findings {
    /// Mistakes.
    pub mistakes: Vec<Mistake>,
    /// Paths of the CSV files that expressions refer to.
    pub tables: Vec<Spanned<String>>,
    /// Tables that were read, if they are recorded.
    pub reads: Option<Vec<TableRead>>,
}

/// A table that was read, with its requested and its required keys.
#[derive(Debug, Clone)]
pub struct TableRead {
    /// The table.
    pub span: Span,
    /// Keys that were requested.
    pub asked: Vec<&'static str>,
    /// Keys among them that are required.
    pub required: Vec<&'static str>,
}

/// A table that is being read.
pub struct Fields<'a> {
    entries: &'a [Entry],
    asked: Vec<&'static str>,
    required: Vec<&'static str>,
    /// The span of the table, for missing keys.
    pub span: Span,
    what: String,
    /// False if another value stands in place of the table, which is reported.
    is_table: bool,
    found: &'a mut Findings,
}

impl<'a> Fields<'a> {
    /// Opens a table called `what` in messages. Any other value is an error.
    pub fn open(tree: &'a Spanned<Tree>, what: String, found: &'a mut Findings) -> Self {
        let entries = match &tree.value {
            Tree::Table(entries) => entries.as_slice(),
            other => {
                let message = format!("{what} must be a table, not {}", other.kind());
                found.mistakes.push(Mistake::new(
                    Code::WrongType,
                    tree.span,
                    message,
                    "not a table",
                ));
                &[]
            }
        };
        let is_table = matches!(tree.value, Tree::Table(_));
        let (asked, required) = (Vec::new(), Vec::new());
        Fields { entries, asked, required, span: tree.span, what, is_table, found }
    }

    /// Opens no table, for a single value.
    pub fn alone(span: Span, found: &'a mut Findings) -> Self {
        Fields {
            entries: &[],
            asked: Vec::new(),
            required: Vec::new(),
            span,
            what: String::new(),
            is_table: true,
            found,
        }
    }

    /// Reports every key that was not requested.
    pub fn close(self) {
        if self.found.reads.is_some() {
            let (asked, required) = (self.asked.clone(), self.required.clone());
            let read = TableRead { span: self.span, asked, required };
            self.found.reads.iter_mut().for_each(|reads| reads.push(read.clone()));
        }
        for entry in self.entries {
            let key = entry.key.value.as_str();
            if !self.asked.contains(&key) {
                let message = format!("unknown key {} in {}", quoted(key), self.what);
                let help = did_you_mean(key, self.asked.iter().copied());
                self.found.mistakes.push(
                    Mistake::new(Code::UnknownKey, entry.key.span, message, "unknown").help(help),
                );
            }
        }
    }

    /// Returns the findings of this reader.
    pub fn found(&mut self) -> &mut Findings {
        self.found
    }

    /// Returns the value of a key, if present.
    pub fn take(&mut self, key: &'static str) -> Option<&'a Spanned<Tree>> {
        if !self.asked.contains(&key) {
            self.asked.push(key);
        }
        self.entries.iter().find(|entry| entry.key.value == key).map(|entry| &entry.value)
    }

    /// Returns the value of a required key.
    pub fn require(&mut self, key: &'static str) -> Option<&'a Spanned<Tree>> {
        let value = self.take(key);
        if !self.required.contains(&key) {
            self.required.push(key);
        }
        if value.is_none() && self.is_table {
            let message = format!("{} lacks `{key}`", self.what);
            self.found.mistakes.push(Mistake::new(
                Code::MissingKey,
                self.span,
                message,
                "it belongs here",
            ));
        }
        value
    }

    /// Returns the entries of a table of tables, whose keys are names.
    pub fn named(&mut self, key: &'static str) -> &'a [Entry] {
        let Some(tree) = self.take(key) else { return &[] };
        let Tree::Table(entries) = &tree.value else {
            self.wrong::<()>(tree, key, "a table");
            return &[];
        };
        for entry in entries {
            if let Err(mistake) = names::check(&entry.key) {
                self.found.mistakes.push(mistake);
            }
        }
        entries
    }

    /// Returns the entries of a table with keys of any kind.
    pub fn entries(&mut self, key: &'static str) -> &'a [Entry] {
        match self.take(key) {
            None => &[],
            Some(Spanned { value: Tree::Table(entries), .. }) => entries,
            Some(tree) => {
                self.wrong::<()>(tree, key, "a table");
                &[]
            }
        }
    }

    /// Returns the items of a list of tables.
    pub fn list(&mut self, key: &'static str) -> &'a [Spanned<Tree>] {
        match self.take(key) {
            None => &[],
            Some(Spanned { value: Tree::List(items), .. }) => items,
            Some(tree) => {
                self.wrong::<()>(tree, key, "a list of tables, [[...]]");
                &[]
            }
        }
    }

    /// Reads a list of strings, empty if absent.
    pub fn texts(&mut self, key: &'static str) -> Vec<String> {
        let items = match self.take(key) {
            None => return Vec::new(),
            Some(Spanned { value: Tree::List(items), .. }) => items,
            Some(tree) => {
                self.wrong::<()>(tree, key, "a list of strings, [\"...\"]");
                return Vec::new();
            }
        };
        items.iter().filter_map(|item| self.as_text(item, key)).map(|text| text.value).collect()
    }

    /// Reads a string, empty if absent.
    pub fn text(&mut self, key: &'static str) -> String {
        match self.take(key) {
            None => String::new(),
            Some(tree) => self.as_text(tree, key).map(|text| text.value).unwrap_or_default(),
        }
    }

    /// Reads a required string.
    pub fn required_text(&mut self, key: &'static str) -> Option<Spanned<String>> {
        let tree = self.require(key)?;
        self.as_text(tree, key)
    }

    /// Reads a name, if present.
    pub fn name(&mut self, key: &'static str) -> Option<Spanned<String>> {
        let tree = self.take(key)?;
        let name = self.as_text(tree, key)?;
        match names::check(&name) {
            Ok(()) => Some(name),
            Err(mistake) => {
                self.found.mistakes.push(mistake);
                None
            }
        }
    }

    /// Reads `true` or `false`, false if absent.
    pub fn flag(&mut self, key: &'static str) -> bool {
        match self.take(key) {
            None => false,
            Some(Spanned { value: Tree::Boolean(flag), .. }) => *flag,
            Some(tree) => {
                self.wrong::<()>(tree, key, "true or false");
                false
            }
        }
    }

    /// Reads a finite number, if present.
    pub fn number(&mut self, key: &'static str) -> Option<Spanned<f64>> {
        let tree = self.take(key)?;
        self.as_number(tree, key)
    }

    /// Reads a required finite number.
    pub fn required_number(&mut self, key: &'static str) -> Option<Spanned<f64>> {
        let tree = self.require(key)?;
        self.as_number(tree, key)
    }

    /// Reads a finite number above 0; 1 if absent.
    pub fn scale(&mut self, key: &'static str) -> f64 {
        let Some(scale) = self.number(key) else { return 1.0 };
        if scale.value > 0.0 {
            return scale.value;
        }
        let message = format!("`{key}` is a typical magnitude and must be above 0");
        self.found.mistakes.push(Mistake::new(
            Code::OutOfRange,
            scale.span,
            message,
            "not above 0",
        ));
        1.0
    }

    /// Reads a required coherent unit of measure.
    pub fn unit(&mut self) -> Option<Declared> {
        self.unit_by(Measure::parse_coherent)
    }

    /// Reads a required unit of measure by the function `read`.
    pub fn unit_by(&mut self, read: fn(&str) -> Result<Measure, UnitError>) -> Option<Declared> {
        let tree = self.require("unit")?;
        let text = self.as_text(tree, "unit")?;
        match read(&text.value) {
            Ok(Measure { unit, factor }) => {
                Some(Declared { text: text.value, unit, factor, span: text.span })
            }
            Err(error) => {
                let span = Text::of(tree).map_or(tree.span, |inner| inner.span(error.range));
                self.found.mistakes.push(
                    Mistake::new(Code::InvalidMeasure, span, error.message, "here")
                        .help(error.help),
                );
                None
            }
        }
    }

    /// Reads an expression, if present.
    pub fn expression(&mut self, key: &'static str) -> Option<Ast> {
        let tree = self.take(key)?;
        self.as_expression(tree, key)
    }

    /// Reads a required expression.
    pub fn required_expression(&mut self, key: &'static str) -> Option<Ast> {
        let tree = self.require(key)?;
        self.as_expression(tree, key)
    }

    /// Reads an expression or a number, if present.
    pub fn formula(&mut self, key: &'static str) -> Option<Formula> {
        let tree = self.take(key)?;
        self.as_formula(tree, key)
    }

    /// Returns the value of a string.
    pub fn as_text(&mut self, tree: &Spanned<Tree>, key: &str) -> Option<Spanned<String>> {
        match &tree.value {
            Tree::Text { value, .. } => Some(Spanned { value: value.clone(), span: tree.span }),
            _ => self.wrong(tree, key, "a string"),
        }
    }

    /// Returns the value of a finite number.
    pub fn as_number(&mut self, tree: &Spanned<Tree>, key: &str) -> Option<Spanned<f64>> {
        match &tree.value {
            Tree::Number { value: 0.0, text, .. } if is_written_as_more(text) => {
                let message = format!("{} is too small for a double, but not 0", quoted(key));
                let mistake = Mistake::new(Code::OutOfRange, tree.span, message, "would become 0");
                self.found.mistakes.push(mistake.help("values range from about 1e-308 to 1e308"));
                None
            }
            Tree::Number { value, .. } if value.is_finite() => {
                Some(Spanned { value: *value, span: tree.span })
            }
            Tree::Number { .. } => {
                let message = format!("{} must be a finite number", quoted(key));
                self.found.mistakes.push(Mistake::new(
                    Code::OutOfRange,
                    tree.span,
                    message,
                    "not finite",
                ));
                None
            }
            _ => self.wrong(tree, key, "a number"),
        }
    }

    /// Parses a string as an expression.
    pub fn as_expression(&mut self, tree: &Spanned<Tree>, key: &str) -> Option<Ast> {
        let Some(text) = Text::of(tree) else {
            return self.wrong(tree, key, "an expression in quotes");
        };
        match expression::parse(&text) {
            Ok(ast) => {
                ast.tables(&mut self.found.tables);
                Some(ast)
            }
            Err(mistake) => {
                self.found.mistakes.push(*mistake);
                None
            }
        }
    }

    /// Returns a finite number, or a string parsed as an expression.
    pub fn as_value(&mut self, tree: &Spanned<Tree>, key: &str) -> Option<Value> {
        match &tree.value {
            Tree::Text { .. } => self.as_expression(tree, key).map(Value::Expression),
            _ => Some(Value::Number(self.as_number(tree, key)?.value)),
        }
    }

    /// Returns a string parsed as an expression, or a number.
    pub fn as_formula(&mut self, tree: &Spanned<Tree>, key: &str) -> Option<Formula> {
        let Tree::Number { text, integer, .. } = &tree.value else {
            return self.as_expression(tree, key).map(Formula::Expression);
        };
        self.as_number(tree, key)?;
        let literal = match integer {
            Some(integer) => Some(Literal::of_integer(*integer)),
            None => Literal::parse(&text.replace('_', "")),
        };
        match literal {
            Some(literal) => Some(Formula::Number(Spanned { value: literal, span: tree.span })),
            None => self.wrong(tree, key, "a finite number"),
        }
    }

    /// Reports a value of the wrong kind.
    pub fn wrong<T>(&mut self, tree: &Spanned<Tree>, key: &str, wanted: &str) -> Option<T> {
        let found = tree.value.kind();
        let message = format!("{} must be {wanted}, not {found}", quoted(key));
        self.found.mistakes.push(Mistake::new(
            Code::WrongType,
            tree.span,
            message,
            format!("this is {found}"),
        ));
        None
    }
}

/// Reports whether the text of a number has a nonzero digit before its exponent.
fn is_written_as_more(text: &str) -> bool {
    let mantissa = text.split(['e', 'E']).next().unwrap_or(text);
    mantissa.contains(|c: char| ('1'..='9').contains(&c))
}

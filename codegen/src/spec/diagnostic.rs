//! Diagnostics of specs: what is wrong, where, and how to mend it.
//!
//! Excluded: absolute paths (files are named by their labels), colours and times, so equal
//! mistakes give equal reports.

use std::fmt;
use std::ops::Range;

use super::code::Code;
use miette::{LabeledSpan, MietteError, MietteSpanContents, SourceCode, SourceSpan, SpanContents};

/// Maximum number of errors reported for one spec.
const MAX_REPORTED: usize = 50;
/// Width of a rendered report in columns.
const WIDTH: usize = 100;
/// Lines of context before and after a mistake.
const CONTEXT: usize = 3;
/// Maximum number of bytes shown of a line. Longer lines are cut around the mistake.
const LONG_LINE: usize = 160;

/// Index of a source text of a scene.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct FileId(pub u32);

/// A range of bytes of a source text.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Span {
    /// The text.
    pub file: FileId,
    /// First byte.
    pub start: u32,
    /// One past the last byte.
    pub end: u32,
}

impl Span {
    /// Returns the span of the bytes `range` of `file`.
    #[must_use]
    pub fn new(file: FileId, range: Range<usize>) -> Self {
        Span { file, start: range.start as u32, end: range.end as u32 }
    }

    /// Returns the smallest span over `self` and `other` of the same file.
    #[must_use]
    pub fn to(self, other: Span) -> Self {
        Span { file: self.file, start: self.start.min(other.start), end: self.end.max(other.end) }
    }
}

/// A value with its source span.
#[derive(Debug, Clone, PartialEq)]
pub struct Spanned<T> {
    /// The value.
    pub value: T,
    /// Source span.
    pub span: Span,
}

/// A mistake at a span, before the text around it is attached.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Mistake {
    /// Kind of the mistake.
    pub code: Code,
    /// The mistake in one sentence.
    pub message: String,
    /// The span.
    pub span: Span,
    /// Label of the span, a few words.
    pub label: String,
    /// Hint for mending it; may be empty.
    pub help: String,
}

impl Mistake {
    /// Returns a mistake at `span`.
    #[must_use]
    pub fn new(
        code: Code,
        span: Span,
        message: impl Into<String>,
        label: impl Into<String>,
    ) -> Self {
        Mistake { code, message: message.into(), span, label: label.into(), help: String::new() }
    }

    /// Adds a hint.
    #[must_use]
    pub fn help(mut self, help: impl Into<String>) -> Self {
        self.help = help.into();
        self
    }
}

/// One error or warning of a spec, ready to be shown.
#[derive(Debug, Clone, PartialEq)]
pub struct Diagnostic {
    /// Code of the kind of error, such as `spec::unknown-name`.
    pub code: &'static str,
    /// The mistake in one sentence.
    pub message: String,
    /// Label of the file, `scenes/saw_gin.toml`.
    pub file: Box<str>,
    /// Line of the mistake, from 1; 0 if the file could not be read.
    pub line: usize,
    /// Column of the mistake in characters, from 1; 0 likewise.
    pub column: usize,
    /// Label of the span.
    pub label: Box<str>,
    /// Hint for mending it.
    pub help: Option<Box<str>>,
    /// True for a warning: the spec is accepted as it is.
    pub is_warning: bool,
    source: Option<Box<Excerpt>>,
}

impl Diagnostic {
    /// Returns an error of a whole file, without an excerpt.
    #[must_use]
    pub fn of_file(
        code: impl Into<&'static str>,
        file: &str,
        message: impl Into<String>,
        help: impl Into<String>,
    ) -> Self {
        let help = help.into();
        Diagnostic {
            code: code.into(),
            message: message.into(),
            file: file.into(),
            line: 0,
            column: 0,
            label: Box::default(),
            help: (!help.is_empty()).then(|| help.into()),
            is_warning: false,
            source: None,
        }
    }

    /// Returns the error that the system granted no thread to work on.
    #[must_use]
    pub fn no_thread() -> Self {
        let message = "the system could not start a thread to read the spec";
        Diagnostic::of_file(Code::TooLarge, "", message, "")
    }

    /// Returns the mistake with the text around it; `label` names the file.
    #[must_use]
    pub fn of_text(mistake: &Mistake, label: &str, text: &str) -> Self {
        let start = floor_boundary(text, mistake.span.start as usize);
        let end = floor_boundary(text, mistake.span.end as usize).max(start);
        let before = &text[..start];
        let line_start = before.rfind('\n').map_or(0, |newline| newline + 1);
        Diagnostic {
            code: mistake.code.name(),
            message: mistake.message.clone(),
            file: label.into(),
            line: before.matches('\n').count() + 1,
            column: before[line_start..].chars().count() + 1,
            label: mistake.label.as_str().into(),
            help: (!mistake.help.is_empty()).then(|| mistake.help.as_str().into()),
            is_warning: false,
            source: Some(Box::new(Excerpt::new(label, text, start..end))),
        }
    }

    /// Returns the number of characters of the span; 0 if the file could not be read.
    #[must_use]
    pub fn length(&self) -> usize {
        self.source.as_ref().map_or(0, |source| source.length)
    }

    /// Returns the diagnostic as a warning.
    #[must_use]
    pub fn as_warning(self) -> Self {
        Diagnostic { is_warning: true, ..self }
    }
}

/// Lines around a mistake. Long lines are cut and control characters replaced, so a report stays
/// readable and cannot control a terminal.
#[derive(Debug, Clone, PartialEq)]
struct Excerpt {
    name: String,
    text: String,
    /// Number of characters of the whole mistake.
    length: usize,
    /// Number of lines of the file before the first one kept.
    lines_before: usize,
    /// Span of the mistake, in bytes of `text`.
    range: Range<usize>,
}

impl Excerpt {
    fn new(name: &str, text: &str, range: Range<usize>) -> Self {
        let length = text[range.clone()].chars().count();
        let line = text[..range.start].matches('\n').count();
        let lines_before = line.saturating_sub(CONTEXT);
        let mut offset = 0;
        let mut kept = String::new();
        let mut moved = None;
        for (index, line) in text.split_inclusive('\n').enumerate().take(line + CONTEXT + 1) {
            if index >= lines_before {
                let inside = range.start.checked_sub(offset).filter(|at| *at < line.len());
                let window = window(line, inside);
                if let Some(at) = inside {
                    let start = kept.len() + at - window.start;
                    moved = Some(start..start + range.len().min(window.end.saturating_sub(at)));
                }
                kept.extend(line[window.clone()].chars().map(harmless));
                if window.end < line.len() {
                    kept.push('\n');
                }
            }
            offset += line.len();
        }
        let end = kept.len()..kept.len();
        let (name, range) = (name.to_owned(), moved.unwrap_or(end));
        Excerpt { name, text: kept, length, lines_before, range }
    }
}

impl SourceCode for Excerpt {
    fn read_span<'a>(
        &'a self,
        span: &SourceSpan,
        context_lines_before: usize,
        context_lines_after: usize,
    ) -> Result<Box<dyn SpanContents<'a> + 'a>, MietteError> {
        let inner = self.text.read_span(span, context_lines_before, context_lines_after)?;
        Ok(Box::new(MietteSpanContents::new_named(
            self.name.clone(),
            inner.data(),
            *inner.span(),
            inner.line() + self.lines_before,
            inner.column(),
            inner.line_count(),
        )))
    }
}

/// Returns the part of a line that is shown, around the byte `inside` if given.
fn window(line: &str, inside: Option<usize>) -> Range<usize> {
    let window = match inside {
        _ if line.len() <= LONG_LINE => 0..line.len(),
        Some(at) => at.saturating_sub(LONG_LINE / 3)..at + 2 * LONG_LINE / 3,
        None => 0..LONG_LINE,
    };
    floor_boundary(line, window.start)..floor_boundary(line, window.end)
}

/// Replaces ASCII control characters by `?`, which keeps byte offsets.
fn harmless(c: char) -> char {
    if c.is_ascii_control() && c != '\n' && c != '\t' { '?' } else { c }
}

fn floor_boundary(text: &str, index: usize) -> usize {
    let mut index = index.min(text.len());
    while !text.is_char_boundary(index) {
        index -= 1;
    }
    index
}

impl fmt::Display for Diagnostic {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.source.is_some() || self.file.is_empty() {
            write!(f, "{}", self.message)
        } else {
            write!(f, "{}: {}", self.file, self.message)
        }
    }
}

impl std::error::Error for Diagnostic {}

impl miette::Diagnostic for Diagnostic {
    fn code<'a>(&'a self) -> Option<Box<dyn fmt::Display + 'a>> {
        Some(Box::new(self.code))
    }

    fn severity(&self) -> Option<miette::Severity> {
        Some(if self.is_warning { miette::Severity::Warning } else { miette::Severity::Error })
    }

    fn help<'a>(&'a self) -> Option<Box<dyn fmt::Display + 'a>> {
        self.help.as_ref().map(|help| Box::new(help) as Box<dyn fmt::Display>)
    }

    fn source_code(&self) -> Option<&dyn SourceCode> {
        self.source.as_ref().map(|source| source.as_ref() as &dyn SourceCode)
    }

    fn labels(&self) -> Option<Box<dyn Iterator<Item = LabeledSpan> + '_>> {
        let range = self.source.as_ref()?.range.clone();
        let label = LabeledSpan::new_primary_with_span(Some(self.label.to_string()), range);
        Some(Box::new(std::iter::once(label)))
    }
}

/// All errors found in a spec, at least one, in the order found.
#[derive(Debug, Clone)]
pub struct Diagnostics {
    errors: Vec<Diagnostic>,
    left_out: usize,
}

impl Diagnostics {
    /// Returns the errors, at most fifty.
    #[must_use]
    pub fn errors(&self) -> &[Diagnostic] {
        &self.errors
    }

    /// Returns the code of the first error.
    #[must_use]
    pub fn code(&self) -> &'static str {
        self.errors[0].code
    }

    /// Renders a report without colour, equal on all machines.
    #[must_use]
    pub fn render(&self) -> String {
        render(self)
    }
}

/// Renders a report without colour, equal on all machines.
#[must_use]
pub fn render(of: &dyn miette::Diagnostic) -> String {
    let theme = miette::GraphicalTheme::unicode_nocolor();
    let handler = miette::GraphicalReportHandler::new_themed(theme)
        .with_width(WIDTH)
        .without_syntax_highlighting();
    let mut report = String::new();
    // Writing to a string cannot fail. A partial report is still a report.
    if handler.render_report(&mut report, of).is_err() {
        report.push_str(&of.to_string());
    }
    report
}

impl From<Diagnostic> for Diagnostics {
    fn from(error: Diagnostic) -> Self {
        Diagnostics { errors: vec![error], left_out: 0 }
    }
}

impl FromIterator<Diagnostic> for Diagnostics {
    fn from_iter<I: IntoIterator<Item = Diagnostic>>(errors: I) -> Self {
        let mut errors: Vec<Diagnostic> = errors.into_iter().collect();
        let left_out = errors.len().saturating_sub(MAX_REPORTED);
        errors.truncate(MAX_REPORTED);
        Diagnostics { errors, left_out }
    }
}

impl fmt::Display for Diagnostics {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.errors.as_slice() {
            [error] => write!(f, "{error}"),
            errors => write!(f, "{} errors in the spec", errors.len() + self.left_out),
        }
    }
}

impl std::error::Error for Diagnostics {}

impl miette::Diagnostic for Diagnostics {
    fn code<'a>(&'a self) -> Option<Box<dyn fmt::Display + 'a>> {
        self.single()?.code()
    }

    fn help<'a>(&'a self) -> Option<Box<dyn fmt::Display + 'a>> {
        match self.errors.as_slice() {
            [error] => error.help(),
            _ if self.left_out > 0 => {
                Some(Box::new(format!("{} more are not shown", self.left_out)))
            }
            _ => None,
        }
    }

    fn source_code(&self) -> Option<&dyn SourceCode> {
        self.single()?.source_code()
    }

    fn labels(&self) -> Option<Box<dyn Iterator<Item = LabeledSpan> + '_>> {
        self.single()?.labels()
    }

    fn related<'a>(&'a self) -> Option<Box<dyn Iterator<Item = &'a dyn miette::Diagnostic> + 'a>> {
        if self.single().is_some() {
            return None;
        }
        Some(Box::new(self.errors.iter().map(|error| error as &dyn miette::Diagnostic)))
    }
}

impl Diagnostics {
    fn single(&self) -> Option<&Diagnostic> {
        match self.errors.as_slice() {
            [error] => Some(error),
            _ => None,
        }
    }
}

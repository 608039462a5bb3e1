//! Reading of source files: limits, labels, hashes.

use std::fmt::Write as _;
use std::io::Read as _;
use std::path::{Component, Path, PathBuf};
use std::sync::Arc;

use sha2::{Digest as _, Sha256};

use super::code::Code;
use crate::spec::Formula;
use crate::spec::diagnostic::{Diagnostic, Diagnostics, FileId, Mistake, Span};

/// Maximum size of a file in bytes.
pub const MAX_FILE_BYTES: u64 = 1 << 20;
/// Maximum number of mistakes shown; the rest is only counted.
const MAX_SHOWN: usize = 50;

/// A source file that was read, for headers, `rerun-if-changed` and freshness.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct SourceFile {
    /// Path as found; empty for a unit that comes with Machinist. Absolute paths never reach
    /// emitted text.
    pub path: PathBuf,
    /// File name relative to the folder of specs, with forward slashes.
    pub label: String,
    /// SHA-256 of its bytes, in hexadecimal.
    pub sha256: String,
}

/// A file with its text.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct SourceText {
    /// Path, label and hash. The path is empty for a unit that comes with Machinist.
    pub file: SourceFile,
    /// The contents.
    pub text: Arc<str>,
}

/// All files read, in the order of reading.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Sources {
    texts: Vec<SourceText>,
    /// The folder to which labels are relative.
    root: PathBuf,
}

impl Sources {
    /// Returns an empty list. Labels are relative to the parent of the folder of `scene`.
    #[must_use]
    pub fn beside(scene: &Path) -> Self {
        let folder = std::fs::canonicalize(folder_of(scene)).unwrap_or_default();
        let root = folder.parent().map(Path::to_path_buf).unwrap_or_default();
        Sources { texts: Vec::new(), root }
    }

    /// Returns the text of an id.
    #[must_use]
    pub fn get(&self, id: FileId) -> &SourceText {
        &self.texts[id.0 as usize]
    }

    /// Returns paths, labels and hashes, in the order of reading.
    #[must_use]
    pub fn files(&self) -> Vec<SourceFile> {
        self.texts.iter().map(|text| text.file.clone()).collect()
    }

    /// Reads the file at `path`.
    ///
    /// # Errors
    /// If it is missing, not a regular file, empty, longer than [`MAX_FILE_BYTES`], not UTF-8, or
    /// cannot be read.
    pub fn read(&mut self, path: &Path) -> Result<FileId, Diagnostic> {
        let label = self.label(path);
        let text = read_text(path, &label)?;
        Ok(self.add(path.to_path_buf(), label, &text))
    }

    /// Adds a text that is not a file.
    pub fn embed(&mut self, label: &str, text: &str) -> FileId {
        self.add(PathBuf::new(), label.to_owned(), text)
    }

    /// Returns an expression as written in its spec, on one line.
    #[must_use]
    pub fn expression(&self, span: Span) -> String {
        written(&self.get(span.file).text, span)
    }

    /// Returns a formula as written in its spec, on one line.
    #[must_use]
    pub fn formula(&self, formula: &Formula) -> String {
        written_formula(&self.get(formula.span().file).text, formula)
    }

    /// Attaches the surrounding text to mistakes. Equal ones are reported once.
    #[must_use]
    pub fn diagnostics(&self, mistakes: &[Mistake]) -> Diagnostics {
        let mut told: Vec<&Mistake> = Vec::new();
        for mistake in mistakes {
            if told.len() <= MAX_SHOWN && !told.contains(&mistake) {
                told.push(mistake);
            }
        }
        let shown = told.iter().map(|mistake| {
            let source = self.get(mistake.span.file);
            Diagnostic::of_text(mistake, &source.file.label, &source.text)
        });
        shown.collect()
    }

    /// Attaches the surrounding text to warnings.
    #[must_use]
    pub fn warnings(&self, warnings: &[Mistake]) -> Vec<Diagnostic> {
        let shown = warnings.iter().map(|warning| {
            let source = self.get(warning.span.file);
            Diagnostic::of_text(warning, &source.file.label, &source.text).as_warning()
        });
        shown.collect()
    }

    fn add(&mut self, path: PathBuf, label: String, text: &str) -> FileId {
        let mut sha256 = String::new();
        for byte in Sha256::digest(text.as_bytes()) {
            // Writing to a string cannot fail.
            let _ = write!(sha256, "{byte:02x}");
        }
        let file = SourceFile { path, label, sha256 };
        self.texts.push(SourceText { file, text: text.into() });
        FileId(self.texts.len() as u32 - 1)
    }

    /// Returns the path relative to the root if it is below it, else the file's name.
    fn label(&self, path: &Path) -> String {
        let whole = std::fs::canonicalize(folder_of(path)).unwrap_or_default();
        let name = path.file_name().map_or(Path::new("?"), Path::new);
        let below = match whole.strip_prefix(&self.root) {
            Ok(below) if !self.root.as_os_str().is_empty() => below.join(name),
            _ => name.to_path_buf(),
        };
        let parts = below.components().filter_map(|part| match part {
            Component::Normal(part) => Some(part.to_string_lossy()),
            _ => None,
        });
        parts.collect::<Vec<_>>().join("/")
    }
}

/// Returns the whole string around a span: an expression as written in `text`, on one line.
pub(super) fn written(text: &str, span: Span) -> String {
    let (start, end) = (span.start as usize, span.end as usize);
    let from = text[..start].rfind('"').map_or(start, |quote| quote + 1);
    let until = text[end..].find('"').map_or(end, |quote| end + quote);
    one_line(&text[from..until])
}

/// Returns a formula, likewise.
pub(super) fn written_formula(text: &str, formula: &Formula) -> String {
    match formula {
        Formula::Number(number) => {
            text[number.span.start as usize..number.span.end as usize].to_owned()
        }
        Formula::Expression(ast) => written(text, ast.span),
    }
}

/// Returns all words of a text on one line.
#[must_use]
pub fn one_line(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

/// Returns the folder of a file, `.` for a bare name.
pub(super) fn folder_of(path: &Path) -> &Path {
    match path.parent() {
        Some(parent) if !parent.as_os_str().is_empty() => parent,
        _ => Path::new("."),
    }
}

fn read_text(path: &Path, label: &str) -> Result<String, Diagnostic> {
    let refuse = |message: String, help: &str| {
        Err(Diagnostic::of_file(Code::UnreadableFile, label, message, help))
    };
    let metadata = match std::fs::metadata(path) {
        Ok(metadata) => metadata,
        Err(error) if error.kind() == std::io::ErrorKind::NotFound => {
            return refuse("there is no such file".to_owned(), "");
        }
        Err(error) => return refuse(format!("cannot be read: {}", error.kind()), ""),
    };
    if metadata.is_dir() {
        return refuse("this is a folder, not a file".to_owned(), "name a file in it");
    }
    if !metadata.is_file() {
        return refuse("this is not a regular file".to_owned(), "");
    }
    let too_long = "a file is at most 1 MiB long";
    if metadata.len() > MAX_FILE_BYTES {
        return refuse(too_long.to_owned(), "");
    }
    let mut bytes = Vec::new();
    // The file may have grown since, so reading stops one byte beyond the limit.
    let read = std::fs::File::open(path)
        .and_then(|file| file.take(MAX_FILE_BYTES + 1).read_to_end(&mut bytes));
    if let Err(error) = read {
        return refuse(format!("cannot be read: {}", error.kind()), "");
    }
    if bytes.len() as u64 > MAX_FILE_BYTES {
        return refuse(too_long.to_owned(), "");
    }
    match String::from_utf8(bytes) {
        Ok(text) if text.trim().is_empty() => refuse("the file is empty".to_owned(), ""),
        Ok(text) => Ok(text),
        Err(error) => {
            let at = error.utf8_error().valid_up_to();
            refuse(format!("the file is not UTF-8 text (byte {at})"), "save it as UTF-8")
        }
    }
}

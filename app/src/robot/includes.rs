//! Files that models of MuJoCo include, put in place of the elements that name them.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use roxmltree::Node;

use super::tree::RobotError;
use super::xml::{Reader, parsed};
use crate::failure::Failure;

/// Maximum number of bytes of a model with all that it includes.
const MOST_BYTES: usize = 64 << 20;

impl RobotError {
    /// Returns the mistake as a failure of its file.
    pub fn in_file(&self, file: &Path) -> Failure {
        let line = if self.line > 0 { format!(":{}", self.line) } else { String::new() };
        Failure::input(format!("{}{line}: {}", file.display(), self.message), &self.help)
    }
}

/// Text of a model with the files that it includes.
#[derive(Debug, Default)]
pub struct Source {
    /// The text.
    pub text: String,
    pieces: Vec<Piece>,
}

/// A part of the text from one file.
#[derive(Debug)]
struct Piece {
    /// Byte at which it begins in the text.
    from: usize,
    file: PathBuf,
    /// Line at which it begins in its file, from 1.
    line: usize,
}

impl Source {
    /// Reads a file and the files that it includes. Their paths are relative to its folder, and none is
    /// included twice, as in MuJoCo.
    ///
    /// # Errors
    /// [`Failure`] if a file cannot be read or is not XML.
    pub fn read(
        file: &Path,
        read: &dyn Fn(&Path) -> Result<String, Failure>,
    ) -> Result<Self, Failure> {
        let mut source = Source::default();
        let mut known = BTreeSet::from([file.to_path_buf()]);
        source.add(file, &read(file)?, false, &mut known, read)?;
        Ok(source)
    }

    /// Returns a text that includes nothing.
    pub fn of(file: &Path, text: String) -> Self {
        Source { text, pieces: vec![Piece { from: 0, file: file.to_path_buf(), line: 1 }] }
    }

    /// Returns the file and the line of a line of the text.
    pub fn place(&self, line: usize) -> (&Path, usize) {
        let before = self.text.split_inclusive('\n').take(line.saturating_sub(1));
        let from: usize = before.map(str::len).sum();
        let piece = self.pieces.iter().rfind(|piece| piece.from <= from);
        let Some(piece) = piece else { return (Path::new(""), line) };
        let lines = self.text[piece.from..from].matches('\n').count();
        (&piece.file, if line == 0 { 0 } else { piece.line + lines })
    }

    /// Adds the text of a file, or what is within its root.
    fn add(
        &mut self,
        file: &Path,
        text: &str,
        is_within: bool,
        known: &mut BTreeSet<PathBuf>,
        read: &dyn Fn(&Path) -> Result<String, Failure>,
    ) -> Result<(), Failure> {
        let at_file = |error: RobotError| error.in_file(file);
        // Other formats are not parsed twice.
        if !is_within && !text.contains("<include") {
            self.copy(file, text, 0..text.len());
            return Ok(());
        }
        let document = parsed(text).map_err(at_file)?;
        let (reader, root) = (Reader { document: &document }, document.root_element());
        let ends = (root.first_child(), root.last_child());
        let whole = match ends {
            (Some(first), Some(last)) if is_within => first.range().start..last.range().end,
            _ if is_within => 0..0,
            _ => 0..text.len(),
        };
        let mut from = whole.start;
        let includes = |node: &Node<'_, '_>| node.has_tag_name("include");
        for node in root.descendants().filter(includes) {
            if root.has_tag_name("sdf") {
                break;
            }
            self.copy(file, text, from..node.range().start);
            from = node.range().end;
            let name = reader.attribute(node, "file").map_err(at_file)?.to_owned();
            let folder = self.pieces.first().and_then(|piece| piece.file.parent());
            let path = folder.unwrap_or_else(|| Path::new("")).join(&name);
            if Path::new(&name).is_absolute() || !known.insert(path.clone()) {
                let why = "is included twice, or by an absolute path";
                let message = format!("`{}` {why}", name.escape_debug());
                return Err(at_file(reader.error(node, message, "")));
            }
            self.add(&path, &read(&path)?, true, known, read)?;
        }
        self.copy(file, text, from..whole.end);
        if self.text.len() > MOST_BYTES {
            let message =
                format!("the model with what it includes has more than {MOST_BYTES} bytes");
            return Err(at_file(RobotError::new(0, message, "")));
        }
        Ok(())
    }

    fn copy(&mut self, file: &Path, text: &str, range: std::ops::Range<usize>) {
        let line = 1 + text[..range.start].matches('\n').count();
        self.pieces.push(Piece { from: self.text.len(), file: file.to_path_buf(), line });
        self.text.push_str(&text[range]);
    }
}

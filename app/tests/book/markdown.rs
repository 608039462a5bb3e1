//! Elements of chapters: blocks of code, tables of keys, links.

use std::fs;
use std::path::{Path, PathBuf};

use pulldown_cmark::{CodeBlockKind, Event, Options, Parser, Tag, TagEnd};

/// Markdown file.
pub struct Chapter {
    /// Path of the file.
    pub path: PathBuf,
    /// Whole text.
    pub text: String,
    /// Elements in their order.
    pub pieces: Vec<Piece>,
}

/// Element of a chapter that tests check.
pub enum Piece {
    /// Block of code.
    Block(Block),
    /// Heading: its text, and the code in it.
    Heading(String, Vec<String>),
    /// Row of a table after its header: its cells, code between backticks.
    Row(Vec<String>),
    /// Header of a table.
    Head(Vec<String>),
    /// Target of a link or picture.
    Link(String),
}

/// Fenced block of code.
#[derive(Clone)]
pub struct Block {
    /// First word of the info string.
    pub language: String,
    /// The other words, `key=value` or a word alone.
    pub attributes: Vec<String>,
    /// Content.
    pub text: String,
    /// Position of the content in the file.
    pub start: usize,
    /// True if a comment just before the block says why it is not tested.
    pub is_excused: bool,
}

impl Block {
    /// Returns the value of `key=value` in the info string.
    pub fn attribute(&self, key: &str) -> Option<&str> {
        let is_it = |attribute: &&String| attribute.split_once('=').is_some_and(|it| it.0 == key);
        let attribute = self.attributes.iter().find(is_it)?;
        attribute.split_once('=').map(|(_, value)| value)
    }
}

impl Chapter {
    pub fn read(path: &Path) -> Self {
        let text =
            fs::read_to_string(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
        let pieces = pieces(&text);
        Self { path: path.to_owned(), text, pieces }
    }

    pub fn blocks(&self) -> impl Iterator<Item = &Block> {
        self.pieces.iter().filter_map(|piece| match piece {
            Piece::Block(block) => Some(block),
            _ => None,
        })
    }

    /// Returns path and line of a position, in the form that editors take.
    pub fn place(&self, at: usize) -> String {
        let line = self.text[..at].lines().count() + 1;
        format!("{}:{line}", self.path.display())
    }
}

/// Start of a comment before a block that is not tested.
const EXCUSE: &str = "<!-- not run: ";

fn pieces(text: &str) -> Vec<Piece> {
    let mut pieces = Vec::new();
    let mut block: Option<Block> = None;
    let mut heading: Option<(String, Vec<String>)> = None;
    let mut row: Option<Vec<String>> = None;
    for (event, range) in Parser::new_ext(text, Options::ENABLE_TABLES).into_offset_iter() {
        match event {
            Event::Start(Tag::CodeBlock(CodeBlockKind::Fenced(info))) => {
                let mut words = info.split([',', ' ']).filter(|word| !word.is_empty());
                let body =
                    text[range.start..].find('\n').map_or(range.end, |at| range.start + at + 1);
                block = Some(Block {
                    language: words.next().unwrap_or_default().to_owned(),
                    attributes: words.map(str::to_owned).collect(),
                    text: String::new(),
                    start: body,
                    is_excused: text[..range.start]
                        .trim_end()
                        .lines()
                        .next_back()
                        .is_some_and(|line| line.trim_start().starts_with(EXCUSE)),
                });
            }
            Event::End(TagEnd::CodeBlock) => pieces.extend(block.take().map(Piece::Block)),
            Event::Start(Tag::Heading { .. }) => heading = Some((String::new(), Vec::new())),
            Event::End(TagEnd::Heading(_)) => {
                let found = heading.take().map(|(text, codes)| Piece::Heading(text, codes));
                pieces.extend(found);
            }
            Event::Start(Tag::TableHead | Tag::TableRow) => row = Some(Vec::new()),
            Event::End(TagEnd::TableHead) => pieces.extend(row.take().map(Piece::Head)),
            Event::End(TagEnd::TableRow) => pieces.extend(row.take().map(Piece::Row)),
            Event::Start(Tag::TableCell) => row.iter_mut().for_each(|row| row.push(String::new())),
            Event::Start(Tag::Link { dest_url, .. } | Tag::Image { dest_url, .. }) => {
                pieces.push(Piece::Link(dest_url.into_string()));
            }
            Event::Text(part) => {
                if let Some(block) = &mut block {
                    block.text.push_str(&part);
                } else {
                    write(&mut heading, &mut row, &part);
                }
            }
            Event::Code(code) => {
                if let Some((_, codes)) = &mut heading {
                    codes.push(code.to_string());
                }
                write(&mut heading, &mut row, &format!("`{code}`"));
            }
            _ => {}
        }
    }
    pieces
}

fn write(heading: &mut Option<(String, Vec<String>)>, row: &mut Option<Vec<String>>, part: &str) {
    if let Some((text, _)) = heading {
        text.push_str(part);
    } else if let Some(cell) = row.as_mut().and_then(|row| row.last_mut()) {
        cell.push_str(part);
    }
}

/// Returns the text between backticks.
pub fn codes(text: &str) -> impl Iterator<Item = &str> {
    text.split('`').skip(1).step_by(2)
}

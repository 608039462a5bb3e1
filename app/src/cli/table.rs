//! Tables and paragraphs in the width of the terminal. Nothing is cut off: cells wrap between words,
//! and columns that do not fit beside the others follow below them.

use std::io::stdout;
use std::ops::Range;

use terminal_size::{Width, terminal_size_of};

/// Width of text that is not written to a terminal.
const ELSEWHERE: usize = 100;
/// Minimum width, below which a terminal wraps the lines itself.
const NARROWEST: usize = 40;
/// Space between two columns.
const BETWEEN: &str = "  ";

/// Returns the width of standard output in characters: that of its terminal, or the one that the
/// variable `COLUMNS` names, or 100.
pub fn width() -> usize {
    width_of_terminal().unwrap_or(ELSEWHERE)
}

/// Returns the width of the terminal, or the one that the variable `COLUMNS` names, if any.
pub fn width_of_terminal() -> Option<usize> {
    let named = std::env::var("COLUMNS").ok().and_then(|columns| columns.parse::<usize>().ok());
    let of_terminal = || terminal_size_of(stdout()).map(|(Width(width), _)| usize::from(width));
    named.or_else(of_terminal).map(|width| width.max(NARROWEST))
}

/// Wraps the lines that are wider, with the space before them and four more before what follows.
#[cfg(feature = "derive")]
pub fn hanging(text: &str, width: usize) -> String {
    let line = |line: &str| {
        let (space, content) = line.split_at(line.len() - line.trim_start().len());
        if length(line) <= width {
            return format!("{line}\n");
        }
        let room = width.saturating_sub(space.len() + 4).max(1);
        let lines = wrapped(content, room);
        let first = lines.first().map(|first| format!("{space}{first}\n"));
        let others = lines.iter().skip(1).map(|line| format!("{space}    {line}\n"));
        first.into_iter().chain(others).collect()
    };
    text.lines().map(line).collect()
}

/// Aligns lines of cells as columns: the first `left` of them flush left, the others flush right.
/// The first row is the header.
pub fn columns<Row: AsRef<[String]>>(rows: &[Row], left: usize) -> String {
    columns_within(rows, left, width())
}

/// Space before the lines of a section.
pub const SECTION: &str = "  ";

/// Like [`columns`], for a section whose lines follow [`SECTION`].
pub fn columns_of_section<Row: AsRef<[String]>>(rows: &[Row], left: usize) -> String {
    columns_within(rows, left, width() - SECTION.len())
}

/// Like [`columns`], within a width.
pub fn columns_within<Row: AsRef<[String]>>(rows: &[Row], left: usize, width: usize) -> String {
    let rows: Vec<&[String]> = rows.iter().map(AsRef::as_ref).collect();
    let bands = bands(&rows, left, width).into_iter().map(|band| {
        let rows: Vec<Vec<&str>> = rows.iter().map(|row| band.cells(row)).collect();
        rows.iter().map(|row| band.row(row)).collect::<String>()
    });
    bands.collect::<Vec<_>>().join("\n")
}

/// Like [`columns`], with the rows one by one. All columns stand side by side, even if their
/// longest words are too wide for that.
pub fn rows<Row: AsRef<[String]>>(rows: &[Row], left: usize, width: usize) -> Vec<String> {
    let rows: Vec<&[String]> = rows.iter().map(AsRef::as_ref).collect();
    let band = Band::of((0..count(&rows)).collect(), &rows, left).shrunk(&rows, left, width);
    rows.iter().map(|row| band.row(&band.cells(row))).collect()
}

/// Wraps a paragraph.
pub fn paragraph(text: &str) -> String {
    indented(text, "", width())
}

/// Wraps a paragraph with the same space before each of its lines.
pub fn indented(text: &str, space: &str, width: usize) -> String {
    let lines = wrapped(text, width.saturating_sub(space.chars().count()).max(1));
    lines.iter().flat_map(|line| [space, line, "\n"]).collect()
}

/// Columns that stand side by side.
struct Band {
    /// Indices of the columns.
    columns: Vec<usize>,
    widths: Vec<usize>,
    /// Number of columns that are flush left.
    left: usize,
}

impl Band {
    /// Returns columns in their natural widths.
    fn of(columns: Vec<usize>, rows: &[&[String]], left: usize) -> Self {
        let natural = |column: &usize| rows.iter().map(|row| length(&row[*column])).max();
        let widths = columns.iter().map(|column| natural(column).unwrap_or_default()).collect();
        let left = columns.iter().filter(|column| **column < left).count();
        Self { columns, widths, left }
    }

    fn total(&self) -> usize {
        self.widths.iter().sum::<usize>() + BETWEEN.len() * self.widths.len().saturating_sub(1)
    }

    /// Makes columns narrower until they fit: first those of which only the header is wide, then the
    /// widest, as far as words and numbers allow it.
    fn shrunk(mut self, rows: &[&[String]], left: usize, width: usize) -> Self {
        let body = rows.get(1..).unwrap_or_default();
        let least: Vec<usize> =
            self.columns.iter().map(|column| least(*column, rows, left)).collect();
        let natural = Self::of(self.columns.clone(), body, left).widths;
        let with_header = natural.into_iter().zip(&least).map(|(body, least)| body.max(*least));
        for floors in [with_header.collect(), least.clone()] {
            self.shrink_to(&floors, width);
        }
        self
    }

    fn shrink_to(&mut self, floors: &[usize], width: usize) {
        while self.total() > width {
            let wide = (0..self.widths.len()).filter(|at| self.widths[*at] > floors[*at]);
            let Some(widest) = wide.max_by_key(|at| self.widths[*at]) else { return };
            self.widths[widest] -= 1;
        }
    }

    fn cells<'r>(&self, row: &'r [String]) -> Vec<&'r str> {
        self.columns.iter().map(|column| row[*column].as_str()).collect()
    }

    /// Formats a row, in as many lines as its longest cell has.
    fn row(&self, cells: &[&str]) -> String {
        let cells: Vec<Vec<String>> =
            cells.iter().zip(&self.widths).map(|(cell, width)| wrapped(cell, *width)).collect();
        let height = cells.iter().map(Vec::len).max().unwrap_or(1).max(1);
        let mut text = String::new();
        for line in 0..height {
            let parts = cells.iter().zip(&self.widths).enumerate().map(|(at, (cell, width))| {
                let part = cell.get(line).map_or("", String::as_str);
                if at < self.left { format!("{part:<width$}") } else { format!("{part:>width$}") }
            });
            text.push_str(parts.collect::<Vec<_>>().join(BETWEEN).trim_end());
            text.push('\n');
        }
        text
    }
}

/// Distributes the columns of a table over bands that fit. Each band begins with the first column.
fn bands(rows: &[&[String]], left: usize, width: usize) -> Vec<Band> {
    let all = Band::of((0..count(rows)).collect(), rows, left).shrunk(rows, left, width);
    if all.total() <= width || all.columns.len() < 3 {
        return vec![all];
    }
    let fitted = |columns: Vec<usize>| Band::of(columns, rows, left).shrunk(rows, left, width);
    let mut bands = vec![fitted(vec![0, 1])];
    for column in 2..count(rows) {
        let Some(last) = bands.last_mut() else { break };
        let wider = fitted([&last.columns[..], &[column]].concat());
        if wider.total() <= width {
            *last = wider;
        } else {
            bands.push(fitted(vec![0, column]));
        }
    }
    bands
}

/// Number of columns.
fn count(rows: &[&[String]]) -> usize {
    rows.first().map_or(0, |row| row.len())
}

/// Returns the least width of a column: text wraps between words, but numbers do not wrap except
/// for their header.
fn least(column: usize, rows: &[&[String]], left: usize) -> usize {
    let of = |(at, row): (usize, &&[String])| {
        let cell = &row[column];
        let wraps = column < left || at == 0;
        if wraps {
            words(cell).into_iter().map(length).max().unwrap_or_default()
        } else {
            length(cell)
        }
    };
    rows.iter().enumerate().map(of).max().unwrap_or_default()
}

/// Wraps a text between words. A unit in brackets is a word.
fn wrapped(text: &str, width: usize) -> Vec<String> {
    if length(text) <= width {
        return vec![text.to_owned()];
    }
    let mut lines: Vec<String> = Vec::new();
    for word in words(text) {
        match lines.last_mut() {
            Some(line) if length(line) + 1 + length(word) <= width => {
                line.push(' ');
                line.push_str(word);
            }
            _ => lines.push(word.to_owned()),
        }
    }
    lines
}

/// Splits a text at spaces outside of brackets. A number stays with the word before it, and `%` with
/// its number.
fn words(text: &str) -> Vec<&str> {
    let mut words: Vec<Range<usize>> = Vec::new();
    let (mut start, mut depth, mut was_number) = (0, 0_usize, false);
    for (at, c) in text.char_indices().chain([(text.len(), ' ')]) {
        match c {
            '[' => depth += 1,
            ']' => depth = depth.saturating_sub(1),
            ' ' if depth == 0 || at == text.len() => {
                let word = &text[start..at];
                let is_number = word.starts_with(|c: char| c.is_ascii_digit());
                let stays = is_number && !was_number || word.starts_with('%');
                match words.last_mut() {
                    _ if word.is_empty() => {}
                    Some(last) if stays => last.end = at,
                    _ => words.push(start..at),
                }
                (start, was_number) = (at + 1, is_number);
            }
            _ => {}
        }
    }
    words.into_iter().map(|word| &text[word]).collect()
}

fn length(text: &str) -> usize {
    text.chars().count()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn table(rows: &[[&str; 4]]) -> Vec<[String; 4]> {
        rows.iter().map(|row| row.map(str::to_owned)).collect()
    }

    fn example() -> Vec<[String; 4]> {
        table(&[
            ["motion", "moves", "damped [rad/s]", "decay time"],
            ["oscillation", "drum.phi 77 %, motor.phi 23 %", "77.173", "0.00012"],
            ["decay", "", "", "12"],
        ])
    }

    #[test]
    fn a_table_that_fits_is_aligned() {
        let text = columns_within(&example(), 2, 100);
        let lines: Vec<&str> = text.lines().collect();
        assert_eq!(lines.len(), 3);
        assert_eq!(
            lines[1],
            "oscillation  drum.phi 77 %, motor.phi 23 %          77.173     0.00012"
        );
        assert!(lines.iter().all(|line| line.trim_end() == *line));
    }

    #[test]
    fn every_word_and_number_of_a_narrow_table_is_whole_and_within_its_width() {
        let whole: Vec<String> =
            example().iter().flatten().flat_map(|cell| words(cell)).map(str::to_owned).collect();
        for width in 33..80 {
            let text = columns_within(&example(), 2, width);
            for line in text.lines() {
                assert!(length(line) <= width, "{width}: {text}");
            }
            let is_there = |word: &&String| text.split(' ').any(|_| text.contains(word.as_str()));
            assert_eq!(whole.iter().filter(is_there).count(), whole.len(), "{width}: {text}");
        }
    }

    #[test]
    fn columns_that_do_not_fit_follow_below_with_the_first_one() {
        let text = columns_within(&example(), 2, 30);
        assert!(text.matches("oscillation").count() >= 2, "{text}");
        assert!(text.contains("\n\nmotion"), "{text}");
    }

    #[test]
    fn paragraphs_wrap_between_words() {
        assert_eq!(indented("a bc def", "  ", 6), "  a bc\n  def\n");
        assert_eq!(indented("averylongword b", "", 4), "averylongword\nb\n");
        assert_eq!(words("at [kN m/rad] b"), ["at", "[kN m/rad]", "b"]);
        assert_eq!(words("a.phi 77 %,  b 1 2 "), ["a.phi 77 %,", "b 1", "2"]);
        assert_eq!(words("open [bracket"), ["open", "[bracket"]);
    }
}

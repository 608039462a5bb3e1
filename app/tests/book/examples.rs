//! Files and commands of a chapter, written and run in order in a folder of their own.
//!
//! | block | what is done |
//! | --- | --- |
//! | `toml,file=NAME`, `csv,file=NAME` | written to the folder |
//! | `toml,add=NAME`, with `from=OTHER` of another file | added to the end of a file |
//! | `diff,file=NAME`, likewise | lines replaced: `-` by `+` |
//! | `toml` alone | a part of a scene or unit: it must fit the schema |
//! | `console`, with `exit=N` of the last command | each `$` line is run, what it prints compared |
//! | `sh` | commands whose options must be right; not run |
//! | `rust` | compiled as a documentation test, elsewhere |
//! | others | a comment `<!-- not run: why -->` before them, or `text,formula` |
//!
//! The text below a command must be its whole output. In it, `...` stands for anything within a
//! line and, alone on a line, for any number of lines. Numbers may differ by rounding (`alike`). If
//! nothing is shown below a command, only its exit code is checked. `MACHINIST_BOOK=write` replaces
//! text that differs by the actual output.

use std::fs;
use std::path::{Path, PathBuf};

use serde_json::Value;

use super::alike::line_matches;
use super::markdown::{Block, Chapter};
use crate::process::{REPOSITORY, machinist, output, said};
use crate::schema;

/// Mistakes in a chapter, and its corrected text.
pub struct Tried {
    pub mistakes: Vec<String>,
    pub text: String,
}

/// Runs all examples of a chapter.
pub fn try_chapter(chapter: &Chapter) -> Tried {
    let scratch = tempfile::tempdir().expect("a folder");
    // Folder that messages show beside file names.
    let folder = scratch.path().join("machines");
    fs::create_dir(&folder).expect("a folder");
    let mut trial = Trial { chapter, folder, mistakes: Vec::new(), text: chapter.text.clone() };
    // The order matters because files and commands build upon each other, so positions shift.
    let mut moved = 0_isize;
    for block in chapter.blocks() {
        if let Err(why) = trial.try_block(block, &mut moved) {
            trial.mistakes.push(format!("{}: {why}", chapter.place(block.start)));
        }
    }
    Tried { mistakes: trial.mistakes, text: trial.text }
}

struct Trial<'a> {
    chapter: &'a Chapter,
    folder: PathBuf,
    mistakes: Vec<String>,
    text: String,
}

impl Trial<'_> {
    fn try_block(&mut self, block: &Block, moved: &mut isize) -> Result<(), String> {
        let file = |key| block.attribute(key).map(|name| self.folder.join(name));
        if block.is_excused {
            return Ok(());
        }
        match (block.language.as_str(), file("file"), file("add")) {
            ("toml" | "csv", Some(to), None) => write(&to, &block.text),
            ("toml", None, Some(to)) => {
                let before = read(&file("from").unwrap_or_else(|| to.clone()))?;
                write(&to, &format!("{before}\n{}", block.text))
            }
            ("diff", Some(to), None) => {
                let before = read(&file("from").unwrap_or_else(|| to.clone()))?;
                write(&to, &replaced(&before, &block.text)?)
            }
            ("toml", None, None) => fits_in_part(&block.text),
            ("console", None, None) => self.try_console(block, moved),
            ("sh", None, None) => {
                let commands = block.text.replace("\\\n", "");
                commands.lines().try_for_each(|line| self.has_right_options(line))
            }
            ("rust", None, None) => Ok(()),
            ("text", None, None) if block.attributes == ["formula"] => Ok(()),
            (language, ..) => Err(format!("a block `{language}` is neither tried nor excused")),
        }
    }

    /// Runs the commands of a block, and compares their output.
    fn try_console(&mut self, block: &Block, moved: &mut isize) -> Result<(), String> {
        let commands = commands(&block.text);
        let code = block.attribute("exit").map_or(Ok(0), str::parse::<i32>);
        let code = code.map_err(|_| "exit= takes a number".to_owned())?;
        let count = commands.len();
        let mut shown_anew = String::new();
        for (at, command) in commands.into_iter().enumerate() {
            let expected = if at + 1 == count { code } else { 0 };
            let printed = self.run(&command.words, expected)?;
            shown_anew.push_str(command.lines);
            if command.shown.trim().is_empty() || matches(command.shown, &printed) {
                shown_anew.push_str(command.shown);
                continue;
            }
            shown_anew.push_str(&cut_as(command.shown, &printed));
            let words = command.words.join(" ");
            let difference =
                format!("`{words}` prints\n{printed}\nbut shown is\n{}", command.shown);
            self.mistakes.push(format!("{}: {difference}", self.chapter.place(block.start)));
        }
        let start = (block.start as isize + *moved) as usize;
        self.text.replace_range(start..start + block.text.len(), &shown_anew);
        *moved += shown_anew.len() as isize - block.text.len() as isize;
        Ok(())
    }

    /// Returns the output of a command, with standard error if it fails.
    fn run(&mut self, words: &[String], code: i32) -> Result<String, String> {
        let words: Vec<&str> = words.iter().map(String::as_str).collect();
        match words.as_slice() {
            ["cd", folder] => {
                self.folder = self.folder.join(folder);
                let is_there = self.folder.is_dir();
                is_there.then(String::new).ok_or_else(|| format!("there is no folder {folder}"))
            }
            ["machinist", arguments @ ..] => {
                let arguments: Vec<String> =
                    arguments.iter().map(|word| of_repository(word)).collect();
                let arguments: Vec<&str> = arguments.iter().map(String::as_str).collect();
                let output = output(machinist(&self.folder, &arguments));
                if output.status.code() != Some(code) {
                    return Err(format!(
                        "{words:?} ends with {:?}: {}",
                        output.status.code(),
                        said(&output)
                    ));
                }
                let mut printed = String::from_utf8_lossy(&output.stdout).into_owned();
                if code != 0 {
                    printed.push_str(&String::from_utf8_lossy(&output.stderr));
                }
                Ok(plain(&printed))
            }
            _ => Err(format!("only machinist and cd are run, not {words:?}")),
        }
    }

    /// Checks a command and its options without running it.
    fn has_right_options(&self, line: &str) -> Result<(), String> {
        let words = split(line);
        let Some((program, arguments)) = words.split_first() else { return Ok(()) };
        if program != "machinist" {
            return Ok(());
        }
        let arguments: Vec<&str> = arguments.iter().map(String::as_str).collect();
        let output = output(machinist(&self.folder, &[&arguments[..], &["--help"]].concat()));
        output.status.success().then_some(()).ok_or_else(|| format!("{line}: {}", said(&output)))
    }
}

/// Command of a block.
struct Command<'a> {
    words: Vec<String>,
    /// Lines of the command in the block.
    lines: &'a str,
    /// Lines shown below it.
    shown: &'a str,
}

fn commands(text: &str) -> Vec<Command<'_>> {
    let mut starts: Vec<usize> = Vec::new();
    let mut at = 0;
    for line in text.split_inclusive('\n') {
        if line.starts_with("$ ") {
            starts.push(at);
        }
        at += line.len();
    }
    starts.push(text.len());
    let command = |ends: &[usize]| {
        let all = &text[ends[0]..ends[1]];
        let mut end = 0;
        let mut joined = String::new();
        for line in all.split_inclusive('\n') {
            end += line.len();
            let continued = line.trim_end().strip_suffix('\\');
            joined.push_str(continued.unwrap_or(line));
            if continued.is_none() {
                break;
            }
        }
        Command { words: split(&joined[2..]), lines: &all[..end], shown: &all[end..] }
    };
    starts.windows(2).map(command).collect()
}

/// Splits words like a shell, with quotes and comments.
fn split(line: &str) -> Vec<String> {
    let (mut words, mut word, mut quote) = (Vec::new(), None::<String>, None);
    for c in line.chars() {
        match (quote, c) {
            (Some(open), c) if c == open => quote = None,
            (None, '"' | '\'') => {
                quote = Some(c);
                word.get_or_insert_default();
            }
            (None, '#') if word.is_none() => break,
            (None, c) if c.is_whitespace() => words.extend(word.take()),
            (_, c) => word.get_or_insert_default().push(c),
        }
    }
    words.extend(word);
    words
}

/// Returns the absolute path of a spec of the repository.
fn of_repository(word: &str) -> String {
    let path = Path::new(REPOSITORY).join(word);
    let is_kept = ["specs/", "app/tests/"].iter().any(|folder| word.starts_with(folder));
    if is_kept && path.exists() { path.display().to_string() } else { word.to_owned() }
}

/// Removes invisible text, trailing blanks, and output that depends on the computer's load.
fn plain(text: &str) -> String {
    let lines = text.trim_start_matches('\n').lines().map(str::trim_end);
    let is_of_deriving = |line: &str| {
        line.starts_with("machinist: waiting for") || line.starts_with("machinist: deriving with")
    };
    let lines: Vec<&str> = lines.filter(|line| !is_of_deriving(line)).collect();
    let text = lines.join("\n");
    let text = text.trim_end();
    if text.is_empty() { String::new() } else { format!("{text}\n") }
}

/// Shortens the output by the `...` of the text shown: for lines that are unchanged, and for rows
/// of tables from the same column on.
fn cut_as(shown: &str, printed: &str) -> String {
    let cut = shown.lines().find_map(|line| line.strip_suffix("| ..."));
    let bars = cut.map(|row| row.matches('|').count() + 1);
    let mut text = String::new();
    for line in printed.lines() {
        let mut before = shown.lines().filter(|line| line.contains("...") && *line != "...");
        let end = bars.and_then(|bars| line.match_indices('|').nth(bars - 1));
        match (before.find(|shown| line_matches(shown, line)), end) {
            (Some(shown), _) => text.push_str(shown),
            (None, Some((end, bar))) => {
                let (kept, rest) = line.split_at(end + bar.len());
                text.push_str(kept);
                text.push_str(if rest.starts_with('-') { "-..." } else { " ..." });
            }
            (None, None) => text.push_str(line),
        }
        text.push('\n');
    }
    text
}

#[test]
fn what_is_printed_anew_is_cut_as_it_was() {
    let shown = "| pass | a | ...\n|---|---|-...\ntook ... s\n";
    let printed = "| FAIL | b | long | longer |\n|---|---|---|---|\ntook 3 s\nmore\n";
    assert_eq!(cut_as(shown, printed), "| FAIL | b | ...\n|---|---|-...\ntook ... s\nmore\n");
}

/// Returns whether a text is as shown, where `...` stands for anything within a line, or for any
/// lines.
pub fn matches(shown: &str, printed: &str) -> bool {
    let shown: Vec<&str> = shown.trim_end().lines().map(str::trim_end).collect();
    let printed: Vec<&str> = printed.trim_end().lines().map(str::trim_end).collect();
    lines_match(&shown, &printed)
}

fn lines_match(shown: &[&str], printed: &[&str]) -> bool {
    match shown {
        [] => printed.is_empty(),
        ["...", rest @ ..] => (0..=printed.len()).any(|at| lines_match(rest, &printed[at..])),
        [line, rest @ ..] => printed
            .split_first()
            .is_some_and(|(first, others)| line_matches(line, first) && lines_match(rest, others)),
    }
}

/// Replaces lines of a text: those marked `-`, which must occur once and in sequence, by those
/// marked `+`. Other lines give the context.
fn replaced(text: &str, changes: &str) -> Result<String, String> {
    let of = |signs: [char; 2]| {
        let mut lines = String::new();
        for line in changes.lines().filter(|line| line.is_empty() || line.starts_with(signs)) {
            lines.push_str(line.get(1..).unwrap_or_default());
            lines.push('\n');
        }
        lines
    };
    let (before, after) = (of(['-', ' ']), of(['+', ' ']));
    match text.matches(&before).count() {
        1 => Ok(text.replace(&before, &after)),
        count => Err(format!("these lines are there {count} times, not once:\n{before}")),
    }
}

fn read(file: &Path) -> Result<String, String> {
    fs::read_to_string(file).map_err(|error| format!("{}: {error}", file.display()))
}

fn write(file: &Path, text: &str) -> Result<(), String> {
    fs::write(file, text).map_err(|error| format!("{}: {error}", file.display()))
}

/// Checks that a part of a scene or unit has only known keys, with values of the right kind.
fn fits_in_part(text: &str) -> Result<(), String> {
    let tree = text.parse::<toml_edit::Document<String>>().map_err(|error| error.to_string())?;
    let tree = schema::value_of(tree.as_item());
    let [of_scene, of_unit] = schema::schemas().map(|mut schema| {
        ask_for_nothing(&mut schema);
        schema::fits(&schema, &tree)
    });
    match (of_scene, of_unit) {
        (Err(scene), Err(unit)) => {
            Err(format!("part of no scene: {scene}\npart of no unit: {unit}"))
        }
        _ => Ok(()),
    }
}

/// Makes all keys of a schema optional.
fn ask_for_nothing(schema: &mut Value) {
    match schema {
        Value::Object(entries) => {
            if entries.get("required").is_some_and(Value::is_array) {
                entries.remove("required");
            }
            entries.values_mut().for_each(ask_for_nothing);
        }
        Value::Array(items) => items.iter_mut().for_each(ask_for_nothing),
        _ => {}
    }
}

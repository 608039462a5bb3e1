//! Output to standard output and to files, which are written completely or not at all.

use std::io::{self, BufWriter, Write as _, stdout};
use std::path::Path;

use machinist::trajectory::{Stop, Trajectory};

pub use super::table::columns;
use crate::failure::Failure;
use crate::parquet;
use crate::plot::PlotError;

/// Writes to standard output. A reader that closes early, such as `head`, is no failure.
pub fn print(text: &str) -> Result<(), Failure> {
    print_with(|out| out.write_all(text.as_bytes()))
}

/// Like [`print`], with a function that writes.
pub fn print_with(write: impl FnOnce(&mut dyn io::Write) -> io::Result<()>) -> Result<(), Failure> {
    let mut out = BufWriter::new(stdout().lock());
    match write(&mut out).and_then(|()| out.flush()) {
        Err(error) if error.kind() != io::ErrorKind::BrokenPipe => {
            Err(Failure::unsuccessful(format!("standard output: {error}"), ""))
        }
        _ => Ok(()),
    }
}

/// Writes a temporary file beside the target and renames it, so that a failure leaves the old file
/// unchanged.
pub fn write_file(
    path: &Path,
    write: impl FnOnce(&mut dyn io::Write) -> io::Result<()>,
) -> Result<(), Failure> {
    let failed = |error: &io::Error| Failure::file(path, error);
    let mut file = temporary_beside(path).map_err(|error| failed(&error))?;
    {
        let mut writer = BufWriter::new(file.as_file_mut());
        write(&mut writer).and_then(|()| writer.flush()).map_err(|error| failed(&error))?;
    }
    file.persist(path).map_err(|error| failed(&error.error))?;
    Ok(())
}

/// Returns an error unless the file's name has one of these extensions.
pub fn require_ending(file: &Path, endings: &[&str], option: &str) -> Result<(), Failure> {
    let ending = file.extension().and_then(|ending| ending.to_str()).unwrap_or_default();
    if endings.iter().any(|known| known.eq_ignore_ascii_case(ending)) {
        return Ok(());
    }
    let message = format!("{option} {}: unknown format", file.display());
    Err(Failure::input(message, format!("the name must end in .{}", endings.join(" or ."))))
}

/// Returns an error unless the name of a table's file has one of these extensions or that of
/// Parquet, or if the program cannot write Parquet.
pub fn require_table(file: &Path, endings: &[&str]) -> Result<(), Failure> {
    let endings = [endings, &[parquet::ENDING]].concat();
    require_ending(file, &endings, "--out")?;
    parquet::require(file)
}

/// Returns an error for a plot whose name does not end in `.svg` or `.png`.
pub fn require_picture(file: Option<&Path>, option: &str) -> Result<(), Failure> {
    file.map_or(Ok(()), |file| require_ending(file, &["svg", "png"], option))
}

/// Returns whether a table goes to standard output, as `-` requests.
///
/// # Errors
/// [`Failure`] for a file whose name does not end in `.csv` or `.parquet`.
pub fn is_standard_output(out: Option<&Path>) -> Result<bool, Failure> {
    match out {
        Some(file) if file == Path::new("-") => Ok(true),
        Some(file) => require_table(file, &["csv"]).map(|()| false),
        None => Ok(false),
    }
}

/// Draws to a temporary file first, so that a failure leaves the old file unchanged.
pub fn draw_file(
    path: &Path,
    draw: impl FnOnce(&Path) -> Result<(), PlotError>,
) -> Result<(), Failure> {
    let failed = |error: &io::Error| Failure::file(path, error);
    let drawing = temporary_beside(path).map_err(|error| failed(&error))?;
    draw(drawing.path()).map_err(|error| Failure::unsuccessful(error, ""))?;
    drawing.persist(path).map_err(|error| failed(&error.error))?;
    Ok(())
}

/// Creates a temporary file in the folder of `path`, with its extension and the permissions of a
/// new file.
fn temporary_beside(path: &Path) -> io::Result<tempfile::NamedTempFile> {
    let folder = match path.parent() {
        Some(folder) if !folder.as_os_str().is_empty() => folder,
        _ => Path::new("."),
    };
    let ending = path.extension().map(|ending| format!(".{}", ending.display()));
    let ending = ending.unwrap_or_default();
    let mut builder = tempfile::Builder::new();
    builder.prefix(".machinist-").suffix(&ending);
    #[cfg(unix)]
    {
        use std::os::unix::fs::PermissionsExt as _;
        builder.permissions(std::fs::Permissions::from_mode(0o666));
    }
    builder.tempfile_in(folder)
}

/// Returns why the run stopped early and the notes of the method, such as which one `auto` chose
/// and why, each on a line. `whole` names the option that gives all notes.
pub fn remarks(trajectory: &Trajectory, whole: &str) -> String {
    lines(trajectory.stopped.iter().map(describe), &trajectory.notes, whole)
}

/// Formats notes on runs, each on a line.
pub fn notes_told(notes: &[String], whole: &str) -> String {
    lines([], notes, whole)
}

/// Prints remarks on standard error if standard output is reserved for numbers.
pub fn remark_beside(trajectory: &Trajectory) {
    let text = remarks(trajectory, "--out FILE.json");
    for line in text.lines().filter(|line| !line.is_empty()) {
        eprintln!("machinist: {line}");
    }
}

fn describe(stop: &Stop) -> String {
    format!("stopped early, at {} s: {}", stop.time, stop.cause)
}

fn lines(first: impl IntoIterator<Item = String>, notes: &[String], whole: &str) -> String {
    /// Maximum number of notes. A machine that becomes stiff again and again has one each time.
    const MOST: usize = 8;
    let more = notes.len().saturating_sub(MOST);
    let more = (more > 0).then(|| format!("and {more} more remarks; {whole} has all of them"));
    let lines = first.into_iter().chain(notes.iter().take(MOST).cloned()).chain(more);
    lines.flat_map(|line| ["\n".to_owned(), line]).collect()
}

/// Lists how often each event happened, in the order of their first times.
pub fn counted_events(trajectory: &Trajectory) -> String {
    let mut counts: Vec<(&str, usize)> = Vec::new();
    for switch in &trajectory.switches {
        match counts.iter_mut().find(|(event, _)| *event == switch.event) {
            Some((_, count)) => *count += 1,
            None => counts.push((&switch.event, 1)),
        }
    }
    let counts = counts.iter().map(|(event, count)| format!("{event} {count}"));
    counts.collect::<Vec<_>>().join(", ")
}

//! The book and the README: their examples agree with the program, they describe exactly the keys
//! of the language, and their links have targets.

mod alike;
mod examples;
mod keys;
mod markdown;
mod messages;

use std::fs;
use std::path::{Path, PathBuf};
use std::sync::Mutex;
use std::thread;

use crate::process::REPOSITORY;
use markdown::{Chapter, Piece};

/// Folder of the chapters.
fn source() -> PathBuf {
    Path::new(REPOSITORY).join("docs/book/src")
}

/// Reads a chapter by its path in the book.
fn chapter(name: &str) -> Chapter {
    Chapter::read(&source().join(name))
}

/// Returns the paths of all chapters in the book, as its contents list them.
fn listed() -> Vec<String> {
    let contents = chapter("SUMMARY.md");
    let links = contents.pieces.into_iter().filter_map(|piece| match piece {
        Piece::Link(link) => Some(link),
        _ => None,
    });
    links.collect()
}

#[test]
fn every_example_does_what_the_book_shows() {
    let mut paths: Vec<PathBuf> = listed().iter().map(|name| source().join(name)).collect();
    paths.push(Path::new(REPOSITORY).join("README.md"));
    let (left, mistakes) = (Mutex::new(paths), Mutex::new(Vec::new()));
    let try_what_is_left = || {
        loop {
            let Some(path) = left.lock().expect("a list").pop() else { return };
            let chapter = Chapter::read(&path);
            let tried = examples::try_chapter(&chapter);
            if std::env::var("MACHINIST_BOOK").is_ok_and(|word| word == "write")
                && tried.text != chapter.text
            {
                fs::write(&path, &tried.text).expect("written");
            }
            mistakes.lock().expect("a list").extend(tried.mistakes);
        }
    };
    thread::scope(|scope| {
        for _ in 0..4 {
            scope.spawn(try_what_is_left);
        }
    });
    let mistakes = mistakes.into_inner().expect("a list");
    assert!(mistakes.is_empty(), "\n{}", mistakes.join("\n\n"));
}

/// The gallery shows the specs that come with Machinist, word for word.
#[test]
fn the_gallery_shows_the_machines_of_the_library() {
    let text = chapter("gallery.md").text;
    let mut count = 0;
    for machine in machinist_codegen::spec::library::MACHINES {
        let head = format!("```toml,file={}.toml\n", machine.name);
        let shown = text.split(&head).nth(1).and_then(|rest| rest.split("```").next());
        let Some(shown) = shown else { continue };
        assert_eq!(shown.trim_end(), machine.text.trim_end(), "{}", machine.name);
        let picture = source().join(format!("gallery/{}.svg", machine.name));
        assert!(picture.is_file(), "{}", picture.display());
        count += 1;
    }
    assert!(count >= 11, "{count}");
}

#[test]
fn the_book_names_every_command() {
    let commands = chapter("commands.md").text;
    let program = machinist_app::command();
    let mut count = 0;
    for command in program.get_subcommands().filter(|command| !command.is_hide_set()) {
        let name = command.get_name();
        assert!(commands.contains(&format!("\nmachinist {name} ")), "{name} is not named");
        count += 1;
    }
    assert!(count > 20, "{count} commands");
}

#[test]
fn the_contents_list_every_chapter_once() {
    let mut listed = listed();
    listed.sort();
    let mut there = Vec::new();
    for folder in ["", "language"] {
        for entry in fs::read_dir(source().join(folder)).expect("a folder") {
            let path = entry.expect("an entry").path();
            if path.extension().is_some_and(|ending| ending == "md")
                && !path.ends_with("SUMMARY.md")
            {
                let name = path.strip_prefix(source()).expect("below it");
                there.push(name.to_str().expect("a plain path").replace('\\', "/"));
            }
        }
    }
    there.sort();
    assert_eq!(listed, there);
}

#[test]
fn links_lead_to_what_is_there() {
    let mut mistakes = Vec::new();
    for path in with_links() {
        let chapter = Chapter::read(&path);
        let is_of_book = path.starts_with(source());
        for piece in &chapter.pieces {
            let Piece::Link(link) = piece else { continue };
            if link.contains("://") {
                continue;
            }
            if let Err(why) = leads_somewhere(&chapter, link, is_of_book) {
                mistakes.push(format!("{}: {link}: {why}", path.display()));
            }
        }
    }
    assert!(mistakes.is_empty(), "\n{}", mistakes.join("\n"));
}

/// Returns all Markdown files whose links are checked.
fn with_links() -> Vec<PathBuf> {
    let root = Path::new(REPOSITORY);
    let mut paths: Vec<PathBuf> = listed().iter().map(|name| source().join(name)).collect();
    let files = [
        "README.md",
        "ARCHITECTURE.md",
        "CONTRIBUTING.md",
        "CHANGELOG.md",
        "docs/licensing.md",
        "docs/releasing.md",
    ];
    paths.extend(files.map(|file| root.join(file)));
    for entry in fs::read_dir(root.join("docs/decisions")).expect("a folder") {
        paths.push(entry.expect("an entry").path());
    }
    paths
}

fn leads_somewhere(chapter: &Chapter, link: &str, is_of_book: bool) -> Result<(), String> {
    let (file, anchor) = link.split_once('#').unwrap_or((link, ""));
    let target = match file {
        "" => chapter.path.clone(),
        file => chapter.path.parent().expect("a folder").join(file),
    };
    if !target.exists() {
        return Err("there is no such file".to_owned());
    }
    // mdBook makes pages of its chapters, and takes any link to Markdown for a link to a page.
    let ends_outside = is_of_book
        && !target
            .canonicalize()
            .expect("it is there")
            .starts_with(source().canonicalize().expect("it is there"));
    if ends_outside && target.extension().is_some_and(|ending| ending == "md") {
        return Err("no page of the book".to_owned());
    }
    if anchor.is_empty() || anchors(&Chapter::read(&target)).iter().any(|known| known == anchor) {
        return Ok(());
    }
    Err("there is no such heading".to_owned())
}

/// Returns the names of headings in links.
fn anchors(chapter: &Chapter) -> Vec<String> {
    let anchor = |text: &str| -> String {
        let plain = text.chars().filter(|c| c.is_alphanumeric() || " -_".contains(*c));
        plain.map(|c| if c == ' ' { '-' } else { c.to_ascii_lowercase() }).collect()
    };
    let headings = chapter.pieces.iter().filter_map(|piece| match piece {
        Piece::Heading(text, _) => Some(anchor(text)),
        _ => None,
    });
    headings.collect()
}

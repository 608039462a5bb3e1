//! Keys of the language: the book describes exactly the keys that the parser knows.
//!
//! A table of keys stands below a heading that names their place: `[coordinates.NAME]` of a unit,
//! `[[joints]]` of a scene, or of both.

use std::collections::{BTreeMap, BTreeSet};

use machinist_codegen::spec::schema::{Key, Shape};

use super::markdown::{Piece, codes};
use super::{chapter, listed};

/// Description of a key.
#[derive(Debug, PartialEq, Eq)]
struct Described {
    is_required: bool,
    /// Words allowed as its value, in the schema; all code of the row, in the book.
    words: BTreeSet<String>,
}

/// Keys by place and name: `unit coordinates.NAME.scale`.
type Keys = BTreeMap<String, Described>;

#[test]
fn the_book_describes_the_keys_that_the_parser_knows_and_no_others() {
    let (known, described) = (known(), described());
    let names = |keys: &Keys| keys.keys().cloned().collect::<BTreeSet<String>>();
    let missing: Vec<_> = names(&known).difference(&names(&described)).cloned().collect();
    let invented: Vec<_> = names(&described).difference(&names(&known)).cloned().collect();
    assert!(missing.is_empty(), "the book lacks {missing:#?}");
    assert!(invented.is_empty(), "the parser does not know {invented:#?}");
    for (name, key) in &known {
        let told = &described[name];
        assert_eq!(told.is_required, key.is_required, "whether {name} is required");
        let missing: Vec<_> = key.words.difference(&told.words).collect();
        assert!(missing.is_empty(), "{name} lacks {missing:?}");
    }
}

#[test]
fn the_book_has_a_heading_for_each_table_of_a_file() {
    let mut known = BTreeSet::new();
    for (file, shape) in [("scene", Shape::of_scene()), ("unit", Shape::of_unit())] {
        let Shape::Table(keys) = shape else { panic!("a file is a table") };
        known.extend(keys.iter().map(|key| format!("{file} {}", key.name)));
    }
    let mut headed = BTreeSet::new();
    for name in listed().iter().filter(|name| name.starts_with("language/")) {
        for piece in chapter(name).pieces {
            let Piece::Heading(text, codes) = piece else { continue };
            let of_file = |place: String| place.split(['.', '[']).next().map(str::to_owned);
            headed.extend(places_of(&text, &codes).into_iter().filter_map(of_file));
        }
    }
    assert_eq!(headed, known);
}

/// Returns the keys that the parser knows.
fn known() -> Keys {
    let mut keys = Keys::new();
    collect(&Shape::of_scene(), "scene ", &mut keys);
    collect(&Shape::of_unit(), "unit ", &mut keys);
    keys
}

fn collect(shape: &Shape, place: &str, keys: &mut Keys) {
    let below = |name: &str| {
        let dot = if place.ends_with(' ') { "" } else { "." };
        format!("{place}{dot}{name}")
    };
    let add = |of: &[Key], keys: &mut Keys| {
        for key in of {
            // A unit within a scene has the same keys as in a file of its own.
            let is_of_file = place.ends_with(' ');
            let is_unit = place == "scene " && key.name == "define";
            // Tables have headings of their own.
            let words = words_of(&key.shape);
            if !is_unit && !is_of_file && !is_table(&key.shape) {
                keys.insert(below(&key.name), Described { is_required: key.is_required, words });
            }
            if !is_unit {
                collect(&key.shape, &below(&key.name), keys);
            }
        }
    };
    match shape {
        Shape::Table(of) => add(of, keys),
        Shape::Named { known, of, .. } => {
            add(known, keys);
            collect(of, &below("NAME"), keys);
        }
        Shape::Any(shapes) => shapes.iter().for_each(|shape| collect(shape, place, keys)),
        Shape::List(of) => collect(of, &format!("{place}[]"), keys),
        Shape::Text | Shape::Choice(_) | Shape::Number | Shape::Boolean => {}
    }
}

/// Returns whether a key is only a table of other keys.
fn is_table(shape: &Shape) -> bool {
    match shape {
        Shape::Table(_) => true,
        Shape::Named { of, .. } | Shape::List(of) => is_table(of),
        _ => false,
    }
}

fn words_of(shape: &Shape) -> BTreeSet<String> {
    match shape {
        Shape::Choice(words) => words.iter().map(|word| (*word).to_owned()).collect(),
        Shape::Any(shapes) => shapes.iter().flat_map(words_of).collect(),
        _ => BTreeSet::new(),
    }
}

/// Returns the keys in the tables of the book.
fn described() -> Keys {
    let mut keys = Keys::new();
    for name in listed().iter().filter(|name| name.starts_with("language/")) {
        let (mut places, mut is_of_keys) = (Vec::new(), false);
        for piece in chapter(name).pieces {
            match piece {
                Piece::Heading(text, codes) => places = places_of(&text, &codes),
                Piece::Head(cells) => is_of_keys = cells.first().is_some_and(|cell| cell == "key"),
                Piece::Row(cells) if is_of_keys => {
                    assert!(!places.is_empty(), "{name}: nothing says where {} is", cells[0]);
                    for place in &places {
                        describe(place, &cells, &mut keys);
                    }
                }
                _ => {}
            }
        }
    }
    keys
}

fn describe(place: &str, cells: &[String], keys: &mut Keys) {
    for key in codes(&cells[0]) {
        let described = Described {
            is_required: cells[1].contains("required"),
            words: cells[2..].iter().flat_map(|cell| codes(cell)).map(str::to_owned).collect(),
        };
        let before = keys.insert(format!("{place}.{key}"), described);
        assert!(before.is_none(), "{place}.{key} is described twice");
    }
}

/// Returns the places of the keys below a heading: `[ports.NAME]` of a unit is `unit ports.NAME`.
fn places_of(text: &str, codes: &[String]) -> Vec<String> {
    let files: &[&str] = match text.rsplit(" of ").next() {
        Some("a unit") => &["unit"],
        Some("a scene") => &["scene"],
        Some("both") => &["unit", "scene"],
        _ => &[],
    };
    let place = |code: &String| match code.strip_prefix("[[") {
        Some(list) => format!("{}[]", list.trim_end_matches(']')),
        None => code.trim_matches(['[', ']']).to_owned(),
    };
    let all = |file: &&str| {
        codes.iter().map(|code| format!("{file} {}", place(code))).collect::<Vec<_>>()
    };
    files.iter().flat_map(all).collect()
}

#[test]
fn the_book_names_every_function_and_unit_of_measure() {
    use machinist_codegen::spec::measure;
    let said = |name: &str| -> BTreeSet<String> {
        let text = chapter(name).text;
        let of_code = |code: &str| -> Vec<String> {
            code.split(|c: char| !c.is_ascii_alphanumeric() && c != '_')
                .map(str::to_owned)
                .collect()
        };
        codes(&text).flat_map(of_code).collect()
    };
    let functions = said("language/expressions.md");
    for function in machinist_codegen::spec::FUNCTIONS {
        assert!(functions.contains(*function), "{function} is in no row");
    }
    let units = said("language/measures.md");
    for unit in measure::symbols() {
        assert!(units.contains(unit), "{unit} is not named");
    }
}

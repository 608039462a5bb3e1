//! The schema of specs for editors, found by probing the parser.
//!
//! The language is not described here a second time. A spec of one value is read, with a string,
//! a number, a list and so on in its place. The parser's messages, and the keys it requests, give
//! the shape of that place, and then of every key in it. See [`Shape::of_scene`].
//!
//! Excluded: whatever depends on more than one place, such as names that must be known, and the
//! meaning of strings.

use crate::spec::diagnostic::{FileId, Span, Spanned};
use crate::spec::fields::{Findings, TableRead};
use crate::spec::toml::{Entry, Tree};
use crate::spec::{PortKind, Symbol, distributed, scene, spread, unit};
use machinist_model::Direction;

/// Shape of the values allowed at a place of a spec.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Shape {
    /// A string.
    Text,
    /// One of these strings.
    Choice(Vec<&'static str>),
    /// A number.
    Number,
    /// `true` or `false`.
    Boolean,
    /// A list of values of this shape.
    List(Box<Shape>),
    /// A table with these keys and no others.
    Table(Vec<Key>),
    /// A table whose keys are names chosen by the user.
    Named {
        /// True if the keys have to be identifiers.
        identifiers: bool,
        /// Keys with a meaning of their own.
        known: Vec<Key>,
        /// Shape of the values under all other keys.
        of: Box<Shape>,
    },
    /// One of several shapes.
    Any(Vec<Shape>),
}

/// A key of a table.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Key {
    /// The key.
    pub name: String,
    /// Shape of its value.
    pub shape: Shape,
    /// True if the key is always required.
    pub is_required: bool,
}

impl Shape {
    /// Returns the shape of a scene file.
    #[must_use]
    pub fn of_scene() -> Self {
        let mut shape = Asking(read_scene).shape(&[]);
        if let Some(Self::Named { known, .. }) = shape.at_mut("initial") {
            let from = Self::Choice(vec![scene::EQUILIBRIUM]);
            known.push(Key { name: scene::FROM.to_owned(), shape: from, is_required: false });
        }
        shape
    }

    /// Returns the shape of a unit file.
    #[must_use]
    pub fn of_unit() -> Self {
        Asking(read_unit).shape(&[])
    }

    fn at_mut(&mut self, name: &str) -> Option<&mut Self> {
        let Self::Table(keys) = self else { return None };
        keys.iter_mut().find(|key| key.name == name).map(|key| &mut key.shape)
    }
}

fn read_scene(tree: &Spanned<Tree>, found: &mut Findings) {
    scene::read(tree, FILE, found);
}

fn read_unit(tree: &Spanned<Tree>, found: &mut Findings) {
    unit::read(tree, "unit", FILE, true, found);
}

const FILE: FileId = FileId(0);
/// A name that no table uses as a key.
const NAME: &str = "some_name";

/// A reader of specs that is probed.
struct Asking(fn(&Spanned<Tree>, &mut Findings));

/// A step on the path into a spec.
#[derive(Debug, Clone)]
enum Step {
    /// Into a table, with another key that may have to be present for this one to be requested.
    Key(String, Option<String>),
    /// Into a list.
    Item,
}

impl Asking {
    /// Returns the shape of the values allowed at a place.
    fn shape(&self, place: &[Step]) -> Shape {
        let mut shapes = Vec::new();
        if self.takes(place, text()) {
            shapes.push(self.choices(place).map_or(Shape::Text, Shape::Choice));
        }
        if self.takes(place, number()) {
            shapes.push(Shape::Number);
        }
        if self.takes(place, Tree::Boolean(true)) {
            shapes.push(Shape::Boolean);
        }
        if self.takes(place, Tree::List(Vec::new())) {
            shapes.push(Shape::List(Box::new(self.shape(&then(place, Step::Item)))));
        }
        if !is_long_path(place) && self.takes(place, Tree::Table(Vec::new())) {
            shapes.push(self.table(place));
        }
        match <[Shape; 1]>::try_from(shapes) {
            Ok([shape]) => shape,
            Err(shapes) => Shape::Any(shapes),
        }
    }

    /// Reports whether a value is of a kind allowed at a place.
    fn takes(&self, place: &[Step], value: Tree) -> bool {
        let found = self.ask(place, value);
        let is_wrong = |label: &str| label.starts_with("this is ") || label == "not a table";
        !found.mistakes.iter().any(|mistake| mistake.span == PROBED && is_wrong(&mistake.label))
    }

    /// Returns the words allowed at a place, unless any string is.
    fn choices(&self, place: &[Step]) -> Option<Vec<&'static str>> {
        let found = self.ask(place, text());
        let is_unknown = |label: &str| label == "unknown";
        let some = found.mistakes.iter().any(|m| m.span == PROBED && is_unknown(&m.label));
        let Some(Step::Key(key, _)) = place.last().filter(|_| some) else { return None };
        let all = [
            scene::METHODS.to_vec(),
            scene::SPACINGS.to_vec(),
            PortKind::ALL.into_iter().map(|(name, _)| name).collect(),
            Direction::ALL.into_iter().map(Direction::name).collect(),
            Symbol::ALL.into_iter().map(|(name, _)| name).collect(),
            distributed::BOUNDARIES.iter().map(|(name, _)| *name).collect(),
            spread::KINDS.to_vec(),
        ];
        let known = |words: &Vec<&'static str>| {
            let all_known = words.iter().all(|word| {
                let tree = Tree::Text { value: (*word).to_owned(), inner: None };
                let found = self.ask(place, tree);
                !found.mistakes.iter().any(|m| m.span == PROBED && is_unknown(&m.label))
            });
            all_known && !words.is_empty()
        };
        let words = all.into_iter().find(known);
        debug_assert!(words.is_some(), "`{key}` takes words that nobody knows");
        words
    }

    /// Returns the shape of a table at a place.
    fn table(&self, place: &[Step]) -> Shape {
        let Some(bare) = self.keys(place, &[]) else { return self.named(place) };
        let mut keys: Vec<(&str, Option<String>)> =
            bare.asked.iter().map(|key| (*key, None)).collect();
        let mut required = bare.required.clone();
        for beside in &bare.asked {
            let Some(read) = self.keys(place, &[beside]) else { continue };
            required.retain(|key| key == beside || read.required.contains(key));
            for key in read.asked {
                if keys.iter().all(|(known, _)| *known != key) {
                    keys.push((key, Some((*beside).to_owned())));
                }
            }
        }
        let key = |(name, beside): (&str, Option<String>)| Key {
            name: name.to_owned(),
            shape: self.shape(&then(place, Step::Key(name.to_owned(), beside))),
            is_required: required.contains(&name),
        };
        Shape::Table(keys.into_iter().map(key).collect())
    }

    /// Returns the keys that are requested in a table with some keys present. `None` for a table
    /// whose keys are names.
    fn keys(&self, place: &[Step], present: &[&str]) -> Option<TableRead> {
        let entries = present.iter().map(|key| entry(key, elsewhere(text())));
        let found = self.ask(place, Tree::Table(entries.collect()));
        found.reads.into_iter().flatten().find(|read| read.span == PROBED)
    }

    fn named(&self, place: &[Step]) -> Shape {
        let bad = Tree::Table(vec![entry("1.x", elsewhere(Tree::Table(Vec::new())))]);
        let found = self.ask(place, bad);
        let identifiers = found.mistakes.iter().any(|mistake| mistake.label == "not a name");
        let of = self.shape(&then(place, Step::Key(NAME.to_owned(), None)));
        Shape::Named { identifiers, known: Vec::new(), of: Box::new(of) }
    }

    /// Reads a spec of one value.
    fn ask(&self, place: &[Step], value: Tree) -> Findings {
        let mut tree = Spanned { value, span: PROBED };
        for step in place.iter().rev() {
            tree = elsewhere(match step {
                Step::Key(key, beside) => {
                    let beside = beside.iter().map(|key| entry(key, elsewhere(text())));
                    Tree::Table(beside.chain([entry(key, tree)]).collect())
                }
                // Points in the plane, rows and joints are lists of two.
                Step::Item => Tree::List(vec![tree.clone(), tree]),
            });
        }
        let mut found = Findings { reads: Some(Vec::new()), ..Findings::default() };
        (self.0)(&tree, &mut found);
        found
    }
}

/// Reports whether a place is a path of names, `gearbox.gear.phi`, at the depth limit. Nested
/// assemblies make paths of any length; longer ones are written in quotes.
fn is_long_path(place: &[Step]) -> bool {
    let is_name = |step: &&Step| matches!(step, Step::Key(key, _) if key == NAME);
    place.iter().rev().take_while(is_name).count() > 3
}

/// Span of the probed value.
const PROBED: Span = Span { file: FILE, start: 1, end: 2 };

fn elsewhere(value: Tree) -> Spanned<Tree> {
    Spanned { value, span: Span { file: FILE, start: 0, end: 0 } }
}

fn entry(key: &str, value: Spanned<Tree>) -> Entry {
    let span = Span { file: FILE, start: 0, end: 0 };
    Entry { key: Spanned { value: key.to_owned(), span }, value }
}

fn text() -> Tree {
    Tree::Text { value: NAME.to_owned(), inner: None }
}

fn number() -> Tree {
    Tree::Number { value: 1.0, text: "1".to_owned(), integer: Some(1) }
}

fn then(place: &[Step], step: Step) -> Vec<Step> {
    place.iter().cloned().chain([step]).collect()
}

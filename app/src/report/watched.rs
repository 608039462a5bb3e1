//! Page of a machine that `machinist watch` serves: made as a whole once, then updated piece by
//! piece.

use std::time::Duration;

use machinist_codegen::pipeline::{Outline, Stages};
use machinist_codegen::spec::SceneSpec;
use maud::{Markup, PreEscaped, html};
use serde::{Deserialize, Serialize};

use super::live;
use super::machine::{Machine, Ways};
use super::page::{Page, Served, entries, section};
use super::scene::Pieces;
use crate::cli::verify::{Changes, verify_spec};
use crate::failure::{Failure, Trouble};
use crate::spec_source::SpecSource;

/// Machine that was run, with its page.
pub struct Ran {
    machine: Machine,
    source: SpecSource,
    time_limit: Duration,
}

/// Content of the page of a machine.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct Content {
    /// Title of the page.
    pub title: String,
    /// Pieces of the page, from top to bottom.
    pub pieces: Vec<Piece>,
    /// Data of the machine for scripts, as JSON; `None` if pages cannot run the machine.
    pub known: Option<String>,
}

/// Piece of a page.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct Piece {
    /// Id, unique in the page.
    pub id: String,
    /// Entry in the contents, if there is one.
    pub title: Option<String>,
    /// Element of HTML with this id.
    pub html: String,
}

impl Ran {
    /// Runs the machine derived from a spec.
    pub fn new(
        outline: Outline,
        source: &SpecSource,
        spec: &SceneSpec,
        time_limit: Duration,
    ) -> Result<Self, Failure> {
        let machine = Machine::ran(outline, source, spec, Ways::Soonest, time_limit)?;
        Ok(Self { machine, source: source.clone(), time_limit })
    }

    /// Returns the reason why the run stopped, if it did.
    pub fn stopped(&self) -> Option<String> {
        self.machine.run.as_ref().err().map(ToString::to_string)
    }

    /// Completes the page with what the run need not wait for: modes, reduction, and the checks of
    /// `machinist verify`.
    pub fn complete(&mut self, stages: Stages) -> Result<(), Failure> {
        self.machine.find_modes(self.time_limit);
        self.machine.explain(&self.source, stages, false)?;
        let time_limit = self.time_limit;
        let changes = Changes::none(time_limit);
        self.machine.verdicts = verify_spec(&self.source, &self.machine.model, &changes)?;
        Ok(())
    }

    /// Returns the content of the page.
    pub fn content(&self) -> Content {
        let Pieces { title, header, sections, known } = Pieces::of(&self.machine);
        let header = Piece { id: "summary".to_owned(), title: None, html: header.into_string() };
        let sections = sections.iter().map(|(id, title, content)| Piece {
            id: (*id).to_owned(),
            title: Some((*title).to_owned()),
            html: section(id, title, content).into_string(),
        });
        Content { title, pieces: std::iter::once(header).chain(sections).collect(), known }
    }
}

impl Content {
    fn contents(&self) -> Vec<(&str, String)> {
        let titled = self.pieces.iter().filter_map(|piece| {
            piece.title.as_ref().map(|title| (piece.id.as_str(), title.clone()))
        });
        titled.collect()
    }

    /// Renders the entries of the contents on the side.
    pub fn navigation(&self) -> String {
        entries(&self.contents()).into_string()
    }
}

/// Status and messages beside the machine.
pub struct Beside<'a> {
    /// Version of the page's state, which the script compares.
    pub version: u64,
    /// Status for people.
    pub status: &'a str,
    /// Errors and warnings of the present files.
    pub troubles: &'a [Trouble],
}

/// Renders the whole page. `name` stands for the machine until there is one.
pub fn page(name: &str, content: Option<&Content>, beside: &Beside<'_>) -> String {
    let page = Page {
        title: content
            .map_or_else(|| format!("{name}: Machinist"), |content| content.title.clone()),
        others: Vec::new(),
        contents: content.map(Content::contents).unwrap_or_default(),
        has_equations: true,
        served: Some(Served {
            style: include_str!("watched/watch.css"),
            script: include_str!("watched/watch.js"),
        }),
        body: html! {
            div #watch data-version=(beside.version) {
                p #watch-status.muted role="status" { (beside.status) }
                div #watch-troubles { (PreEscaped(troubles(beside.troubles))) }
            }
            @for piece in content.iter().flat_map(|content| &content.pieces) {
                (PreEscaped(&piece.html))
            }
            @if let Some(known) = content.and_then(|content| content.known.as_deref()) {
                (live::data(known))
            }
            // The script of the page runs this, once for each machine.
            script type="text/plain" id="live-script" { (PreEscaped(live::script())) }
        },
    };
    page.render()
}

/// Renders errors and warnings with their locations, as `machinist check` prints them.
pub fn troubles(troubles: &[Trouble]) -> String {
    let shown: Markup = html! {
        @for trouble in troubles {
            div.trouble.warns[trouble.is_warning] role=[(!trouble.is_warning).then_some("alert")] {
                pre.scroll { (trouble.text) }
            }
        }
    };
    shown.into_string()
}

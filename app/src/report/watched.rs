//! The page of a machine that `machinist watch` serves: made once as a whole, then updated piece by piece.

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

/// A machine that was run, and its page.
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
    /// Pieces of the page from above.
    pub pieces: Vec<Piece>,
    /// Data of the machine for scripts, as JSON; nothing where pages cannot run it.
    pub known: Option<String>,
}

/// A piece of a page.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct Piece {
    /// Its id, unique in the page.
    pub id: String,
    /// Its entry in the contents, if it has one.
    pub title: Option<String>,
    /// One element of HTML with this id.
    pub html: String,
}

impl Ran {
    /// Runs what was derived of a spec.
    pub fn new(
        outline: Outline,
        source: &SpecSource,
        spec: &SceneSpec,
        time_limit: Duration,
    ) -> Result<Self, Failure> {
        let machine = Machine::ran(outline, source, spec, Ways::Soonest, time_limit)?;
        Ok(Self { machine, source: source.clone(), time_limit })
    }

    /// Why the run stopped, if it did.
    pub fn stopped(&self) -> Option<String> {
        self.machine.run.as_ref().err().map(ToString::to_string)
    }

    /// Looks at all that nobody waits for before the run: modes, what is left out, and the checks of
    /// `machinist verify`.
    pub fn complete(&mut self, stages: Stages) -> Result<(), Failure> {
        self.machine.find_modes(self.time_limit);
        self.machine.explain(&self.source, stages, false)?;
        let time_limit = self.time_limit;
        let changes = Changes { parameters: &[], until: None, rtol: None, time_limit };
        self.machine.verdicts = verify_spec(&self.source, &self.machine.model, &changes)?;
        Ok(())
    }

    /// Content of its page.
    pub fn content(&self) -> Content {
        let Pieces { title, header, sections, live } = Pieces::of(&self.machine);
        let header = Piece { id: "summary".to_owned(), title: None, html: header.into_string() };
        let sections = sections.iter().map(|(id, title, content)| Piece {
            id: (*id).to_owned(),
            title: Some((*title).to_owned()),
            html: section(id, title, content).into_string(),
        });
        Content {
            title,
            pieces: std::iter::once(header).chain(sections).collect(),
            known: live.map(|live| live.known()),
        }
    }
}

impl Content {
    fn contents(&self) -> Vec<(&str, String)> {
        let titled = self.pieces.iter().filter_map(|piece| {
            piece.title.as_ref().map(|title| (piece.id.as_str(), title.clone()))
        });
        titled.collect()
    }

    /// Entries of the contents on the side.
    pub fn navigation(&self) -> String {
        entries(&self.contents()).into_string()
    }
}

/// Status and messages beside the machine.
pub struct Beside<'a> {
    /// Number of the state of the page, which the script compares.
    pub version: u64,
    /// Status, for people.
    pub status: &'a str,
    /// Errors and warnings of the files as they are.
    pub troubles: &'a [Trouble],
}

/// The whole page; `name` stands for the machine as long as there is none.
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
            // Run by the script of the page, once for each machine.
            script type="text/plain" id="live-script" { (PreEscaped(live::script())) }
        },
    };
    page.render()
}

/// Errors and warnings with their places, as `machinist check` prints them.
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

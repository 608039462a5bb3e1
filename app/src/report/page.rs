//! Page: head, contents on the side, and body.

use base64::prelude::{BASE64_STANDARD, Engine as _};
use maud::{DOCTYPE, Markup, PreEscaped, html};

use super::figure;

/// Content security policy: nothing is loaded, because everything is within the page. Pages that
/// run a machine compile it.
const POLICY: &str = "default-src 'none'; script-src 'unsafe-inline' 'wasm-unsafe-eval'; style-src 'unsafe-inline'; font-src data:; \
     img-src data: blob:";

/// Addition for a served page, which loads content and events from its own server.
const SERVED: &str = "; connect-src 'self'";

/// Style and script of a served page that changes while it is shown.
pub(super) struct Served {
    pub(super) style: &'static str,
    pub(super) script: &'static str,
}

/// Page without its head.
pub(super) struct Page<'a> {
    pub(super) title: String,
    /// Other pages, by address and name.
    pub(super) others: Vec<(&'static str, &'static str)>,
    /// Sections, by id and name.
    pub(super) contents: Vec<(&'a str, String)>,
    /// True if the page has equations, which need their font.
    pub(super) has_equations: bool,
    /// `None` in a page that is a file.
    pub(super) served: Option<Served>,
    pub(super) body: Markup,
}

impl Page<'_> {
    /// Renders the whole page as HTML.
    pub(super) fn render(&self) -> String {
        let page = html! {
            (DOCTYPE)
            html lang="en" {
                (self.head())
                body {
                    (self.navigation())
                    main { (self.body) }
                    (figure::script())
                    @if let Some(served) = &self.served { script { (PreEscaped(served.script)) } }
                }
            }
        };
        page.into_string()
    }

    fn head(&self) -> Markup {
        let more = if self.served.is_some() { SERVED } else { "" };
        html! {
            head {
                meta charset="utf-8";
                meta http-equiv="Content-Security-Policy" content={ (POLICY) (more) };
                meta name="viewport" content="width=device-width, initial-scale=1";
                meta name="color-scheme" content="light dark";
                // Without it, browsers would ask the server for an icon.
                @if self.served.is_some() { link rel="icon" href="data:,"; }
                title { (self.title) }
                style {
                    @if self.has_equations { (PreEscaped(math_font())) }
                    (PreEscaped(include_str!("style.css")))
                    @if let Some(served) = &self.served { (PreEscaped(served.style)) }
                }
            }
        }
    }

    fn navigation(&self) -> Markup {
        html! {
            nav aria-label="Contents" {
                details open {
                    summary { "Contents" }
                    ol {
                        @for (address, name) in &self.others {
                            li.other { a href=(address) { (name) } }
                        }
                        (entries(&self.contents))
                    }
                }
            }
        }
    }
}

/// Renders links to sections of the page, by id and name.
pub(super) fn entries(contents: &[(&str, String)]) -> Markup {
    html! { @for (id, name) in contents { li { a href={ "#" (id) } { (name) } } } }
}

/// Returns the style that embeds the font of the equations. Most systems have no font for
/// mathematics.
fn math_font() -> String {
    let font = BASE64_STANDARD.encode(include_bytes!("font/latinmodern-math.woff2"));
    format!(
        "@font-face {{ font-family: \"Latin Modern Math\"; \
         src: url(data:font/woff2;base64,{font}) format(\"woff2\"); }}\n"
    )
}

/// Renders a section of a page.
pub(super) fn section(id: &str, title: &str, content: &Markup) -> Markup {
    html! { section id=(id) { h2 { (title) } (content) } }
}

/// Renders text with backticks as code.
pub(super) fn prose(text: &str) -> Markup {
    html! {
        @for (index, piece) in text.split('`').enumerate() {
            @if index % 2 == 0 { (piece) } @else { code { (piece) } }
        }
    }
}

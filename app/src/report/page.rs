//! A page: its head, its contents on the side, and what stands in it.

use base64::prelude::{BASE64_STANDARD, Engine as _};
use maud::{DOCTYPE, Markup, PreEscaped, html};

use super::figure;

/// Nothing may be loaded: everything a page needs is in it. Pages that run a machine compile it.
const POLICY: &str = "default-src 'none'; script-src 'unsafe-inline' 'wasm-unsafe-eval'; style-src 'unsafe-inline'; font-src data:; \
     img-src data: blob:";

/// Addresses that a served page loads from: content and events of the same server.
const SERVED: &str = "; connect-src 'self'";

/// Style and script of a page that is served and changes while it is shown.
pub(super) struct Served {
    pub(super) style: &'static str,
    pub(super) script: &'static str,
}

/// A page without its head.
pub(super) struct Page<'a> {
    pub(super) title: String,
    /// Other pages, by address and name.
    pub(super) others: Vec<(&'static str, &'static str)>,
    /// Sections, by id and name.
    pub(super) contents: Vec<(&'a str, String)>,
    /// Whether there are equations in it, which need their font.
    pub(super) has_equations: bool,
    /// Nothing in a page that is a file.
    pub(super) served: Option<Served>,
    pub(super) body: Markup,
}

impl Page<'_> {
    /// The whole of it as HTML.
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
                // A server would be asked for one.
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

/// Links to sections of the page, by id and name.
pub(super) fn entries(contents: &[(&str, String)]) -> Markup {
    html! { @for (id, name) in contents { li { a href={ "#" (id) } { (name) } } } }
}

/// The font of the equations, within the page: most systems have none that knows
/// how to set mathematics.
fn math_font() -> String {
    let font = BASE64_STANDARD.encode(include_bytes!("font/latinmodern-math.woff2"));
    format!(
        "@font-face {{ font-family: \"Latin Modern Math\"; \
         src: url(data:font/woff2;base64,{font}) format(\"woff2\"); }}\n"
    )
}

/// A section of a page.
pub(super) fn section(id: &str, title: &str, content: &Markup) -> Markup {
    html! { section id=(id) { h2 { (title) } (content) } }
}

/// Text with what is between backticks as code.
pub(super) fn prose(text: &str) -> Markup {
    html! {
        @for (index, piece) in text.split('`').enumerate() {
            @if index % 2 == 0 { (piece) } @else { code { (piece) } }
        }
    }
}

//! Licences.

use maud::{Markup, html};

/// Renders a summary of the licences.
pub fn section() -> Markup {
    html! {
        ul {
            li {
                "Machinist and everything it emits: MIT or Apache-2.0, as you like. Emitted
                 simulators depend on nothing but Rust's core library."
            }
            li {
                "Symbolica, which derives the equations when scenes are emitted, is
                 source-available, not open source. Without a key it is for non-commercial use, one
                 instance and one core on a machine; Machinist keeps to that by one thread and a
                 lock file. For commercial use, get a key from its makers."
            }
            li {
                "Emitted code, the engine and model files contain nothing of Symbolica and never
                 start it."
            }
            li {
                "diffsol, in builds with the feature " code { "diffsol" } ": MIT. Latin Modern Math, the font of the equations: GUST
                 Font License, that is the LaTeX Project Public License."
            }
        }
        p { "Who needs what, case by case, is in " code { "docs/licensing.md" } "." }
    }
}

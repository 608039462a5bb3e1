//! Which of three models a winder needs: what its spectrum says.

use machinist::winder_walk::{ENOUGH, FirstStage};
use maud::{Markup, html};

use super::number::number;

/// The first stage, or why it could not be walked.
pub fn section(stage: &Result<FirstStage, String>) -> Markup {
    html! {
        p {
            "A linear model of a winder is enough if every operating frequency stays a factor of "
            (number(ENOUGH, 2)) " from the resonance while the package grows. Frequencies of the
             scene " a href="#winder_linear" { code { "winder_linear" } } " in rad/s:"
        }
        @match stage {
            Ok(stage) => (table(stage)),
            Err(error) => p.warning { "The spectrum could not be computed: " (error) },
        }
    }
}

fn table(stage: &FirstStage) -> Markup {
    html! {
        div.scroll {
            table {
                thead { tr {
                    th { "Frequency" } th.number { "Package of " (number(stage.radii.0, 3)) " m" }
                    th.number { "of " (number(stage.radii.1, 3)) " m" } th.number { "Smallest ratio" }
                } }
                tbody {
                    tr {
                        td { "resonance" } td.number { (number(stage.resonance.0, 4)) }
                        td.number { (number(stage.resonance.1, 4)) } td {}
                    }
                    @for clearance in &stage.clearances { tr {
                        td { (clearance.name) } td.number { (number(clearance.frequency.0, 4)) }
                        td.number { (number(clearance.frequency.1, 4)) }
                        td.number { (number(clearance.ratio, 3)) }
                    } }
                }
            }
        }
        p { (verdict(stage)) }
    }
}

fn verdict(stage: &FirstStage) -> String {
    match stage.nearest() {
        Some(_) if stage.decides() => "The linear model is enough.".to_owned(),
        Some(nearest) if nearest.ratio > 1.0 => format!(
            "The linear model is not enough: {} comes within {} % of the resonance.",
            nearest.name,
            number(100.0 * (nearest.ratio - 1.0), 2)
        ),
        Some(nearest) => format!(
            "The linear model is not enough: {} passes through the resonance.",
            nearest.name
        ),
        None => "There are no operating frequencies.".to_owned(),
    }
}

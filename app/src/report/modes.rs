//! Eigenmodes of a scene about its operating point.

use machinist::Simulation;
use machinist::linear_analysis::{LinearError, Linearization, ModeKind, Place, operating_point};
use maud::{Markup, html};

use crate::cli::modes::{HEADING, NO_MOTION, row};

/// Maximum number of states; larger scenes are left to the command.
const MAX_STATES: usize = 200;
/// Maximum number of modes shown.
const MAX_ROWS: usize = 24;

/// Table of modes and the operating point.
pub struct Modes {
    place: String,
    rows: Vec<[String; 7]>,
    left_out: usize,
    /// Natural frequency \[rad/s\] and damping ratio of the slowest oscillation.
    pub slowest: Option<(f64, f64)>,
}

/// Reason why there are no modes.
pub enum NoModes {
    /// The scene is too large and left to the command.
    TooLarge,
    /// The scene cannot be linearized.
    Linear(LinearError),
}

/// Computes the modes about the equilibrium near the end of the run, or about the state at the end
/// if there is no equilibrium.
pub fn modes(run: &Simulation<'_>) -> Result<Modes, NoModes> {
    if run.simulator().shape().states() > MAX_STATES {
        return Err(NoModes::TooLarge);
    }
    about_the_end(run).map_err(NoModes::Linear)
}

fn about_the_end(run: &Simulation<'_>) -> Result<Modes, LinearError> {
    let simulator = run.simulator();
    let until = simulator.run_defaults().until;
    let (point, steady) = match operating_point(run, Place::Equilibrium) {
        Err(LinearError::NoEquilibrium { .. }) => {
            (operating_point(run, Place::Time(until))?, "the state in which the run ends")
        }
        point => (point?, "the equilibrium near the end of the run"),
    };
    let place = format!("{steady}, time being held at {} s", point.time);
    let linearization = Linearization::at(simulator, point)?;
    let modes = linearization.modes()?;
    let rows = modes.iter().take(MAX_ROWS).map(|mode| row(&linearization, mode)).collect();
    let oscillations = modes.iter().filter(|mode| mode.kind == ModeKind::Oscillation);
    let slowest = oscillations
        .map(|mode| (mode.natural_frequency(), mode.damping_ratio()))
        .min_by(|a, b| a.0.total_cmp(&b.0));
    Ok(Modes { place, rows, left_out: modes.len().saturating_sub(MAX_ROWS), slowest })
}

/// Renders the modes in a scene's section.
pub fn section(scene: &str, modes: &Result<Modes, NoModes>) -> Markup {
    let command = format!("machinist modes {scene}");
    html! {
        @match modes {
            Err(NoModes::TooLarge) => p { "The scene is large; see " code { (command) } },
            Err(NoModes::Linear(error)) => p.warning { "There is no linear analysis: " (error) },
            Ok(modes) if modes.rows.is_empty() => p { (NO_MOTION) },
            Ok(modes) => (table(modes, &command)),
        }
    }
}

fn table(modes: &Modes, command: &str) -> Markup {
    html! {
        p {
            "Natural motions about " (modes.place) ". What moves is given by participation
             factors, which do not depend on units. " code { (command) }
        }
        div.scroll {
            table {
                thead { tr {
                    @for (index, heading) in HEADING.iter().enumerate() {
                        @if index < 2 { th { (heading) } } @else { th.number { (heading) } }
                    }
                } }
                tbody {
                    @for row in &modes.rows {
                        tr {
                            @for (index, cell) in row.iter().enumerate() {
                                @if index < 2 { td { (cell) } } @else { td.number { (cell) } }
                            }
                        }
                    }
                }
            }
        }
        @if modes.left_out > 0 { p.muted { (modes.left_out) " faster motions are left out." } }
    }
}

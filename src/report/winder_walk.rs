//! Which of three models a winder needs, and where it winds stably.

use machinist::winder_walk::layer;
use machinist::winder_walk::map::{Cell, Condition, StabilityMap};
use machinist::winder_walk::{SPEEDS, Stage, Walk, Winder, spectrum};
use maud::{Markup, html};

use super::figure;
use super::number::number;
use crate::cli::walk::{HEADING, line};

/// Speed up to which the map goes \[m/s\].
const FASTEST: f64 = 9.0;

/// Three winders walked, and the map of the bench winder.
pub struct Study {
    walks: Vec<Walk>,
    map: StabilityMap,
    /// Whether what stages cost is shown.
    with_times: bool,
}

impl Study {
    /// Walks and maps.
    ///
    /// # Errors
    /// Why that could not be done.
    pub fn new(with_times: bool) -> Result<Self, String> {
        let winder = |speed| Winder::at_speed(speed).map_err(|error| error.to_string());
        let walk = |speed| Walk::of(&winder(speed)?).map_err(|error| error.to_string());
        let walks = SPEEDS.into_iter().map(walk).collect::<Result<_, String>>()?;
        let bench = winder(SPEEDS[2])?;
        let map = StabilityMap::of(&bench, FASTEST).map_err(|error| error.to_string())?;
        Ok(Self { walks, map, with_times })
    }
}

/// Walks and map, or why there are none.
pub fn section(study: &Result<Study, String>) -> Markup {
    html! {
        p {
            "A linear model of a winder is enough if every operating frequency stays a factor of "
            (number(spectrum::ENOUGH, 2)) " from the resonance while the package grows ("
            a href="#winder_linear" { code { "winder_linear" } } "); one of a stiffening layer, if
             they stay a factor of " (number(layer::ENOUGH, 2)) " from the resonance at the
             amplitude that there is (" a href="#winder_nonlinear" { code { "winder_nonlinear" } }
            "); what is left takes the full one (" a href="#winder_full" { code { "winder_full" } }
            "). All three are run each time, to say what the later ones change. Figures are the
             worst over the radii of the package; of another winder, "
            code { "machinist walk" } " says the same."
        }
        @match study {
            Ok(study) => {
                @for walk in &study.walks { (walked(walk, study.with_times)) }
                (map(&study.map))
            }
            Err(error) => p.warning { "The winders could not be walked: " (error) },
        }
    }
}

fn walked(walk: &Walk, with_times: bool) -> Markup {
    html! {
        h3 {
            (number(walk.winder.speed, 3)) " m/s: stage " (walk.decided().number) " decides"
        }
        @for line in walk.why() { p { (line) } }
        div.scroll {
            table {
                thead { tr {
                    @for (index, heading) in HEADING.iter().enumerate() {
                        @if index == 0 { th { (heading) } } @else { th.number { (heading) } }
                    }
                } }
                tbody { @for stage in &walk.stages { (row(stage)) } }
            }
        }
        @for stage in walk.later() {
            p {
                "Stage " (stage.number) " would have "
                @if with_times {
                    "cost " (number(walk.cost(stage), 2)) " times as much, and "
                }
                "changed: " (walk.change(stage)) "."
            }
        }
    }
}

fn row(stage: &Stage) -> Markup {
    html! {
        tr {
            @for (index, cell) in line(stage).iter().enumerate() {
                @if index == 0 { td { (cell) } } @else { td.number { (cell) } }
            }
        }
    }
}

fn map(map: &StabilityMap) -> Markup {
    let limits = &map.limits;
    html! {
        h3 { "Where winding is stable" }
        p {
            "Pressure " (number(limits.pressure, 4)) " N, tension " (number(limits.tension, 4))
            " N, at most " (number(limits.largest, 4)) " N on the yarn, the unbalance growing with
             the square of the speed. The pressure varies by the sum of amplitudes at worst phases,
             with the stiffness known to " (number(100.0 * limits.spread, 2)) " %: what is stable
             here neither leaves the drum nor slips. Of all points: "
            @for condition in Condition::ALL {
                @if map.share(condition) > 0.0 {
                    (condition.name()) " " (number(100.0 * map.share(condition), 2)) " %; "
                }
            }
            "the colour is that of the condition which fails first."
        }
        (figure::classes(
            "winder-stability-map",
            (&map.radii.iter().map(|radius| 1e3 * radius).collect::<Vec<f64>>(), &map.speeds),
            &classes(map),
            ["radius of the package [mm]", "winding speed [m/s]"],
            "%{x:.4~g} mm, %{y:.3~g} m/s: adhesion margin %{z:.3~g} N",
            &html! {
                "Conditions of stable winding. The numbers are the adhesion margin
                 (N - dN) (f - (fa r + k)/R) - Pn, below zero of which friction may not suffice.
                 The drum's shape, twice a turn, meets the resonance at half the speed at which
                 its unbalance does."
            },
        ))
    }
}

/// Adhesion margins where each condition is the first to fail.
fn classes(map: &StabilityMap) -> Vec<figure::Class> {
    let class = |(index, condition): (usize, Condition)| figure::Class {
        name: condition.name(),
        colour: CLASS_COLOURS[index],
        values: map
            .cells
            .iter()
            .map(|row| {
                let margin = |cell: &Cell| {
                    if cell.condition == condition { cell.margin } else { f64::NAN }
                };
                row.iter().map(margin).collect()
            })
            .collect(),
    };
    let all = Condition::ALL.into_iter().enumerate();
    all.filter(|(_, condition)| map.share(*condition) > 0.0).map(class).collect()
}

/// In the order of [`Condition::ALL`].
const CLASS_COLOURS: [&str; 5] = ["#56b4e9", "#b03a48", "#d55e00", "#e6b800", "#7a56a0"];

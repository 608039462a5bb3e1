//! Comparison of three models of a winder, and maps of its stability.

use machinist_studies::winder_walk::layer;
use machinist_studies::winder_walk::map::{Cell, Condition, FASTEST, StabilityMap};
use machinist_studies::winder_walk::{SPEEDS, Stage, Walk, Winder, spectrum};
use maud::{Markup, html};

use super::figure;
use super::gather::Report;
use crate::cli::walk::{HEADING, line};
use crate::number::number;

/// Pressure of the second map \[N\]. The first has the bench winder's own.
const HARDER: f64 = 100.0;

/// Walks of three winders and maps of the bench winder.
pub struct Study {
    walks: Vec<Walk>,
    maps: Vec<StabilityMap>,
    /// True if the cost of stages is shown.
    with_times: bool,
}

impl Study {
    /// Computes the walks and maps.
    ///
    /// # Errors
    /// The reason of the failure.
    pub fn new(with_times: bool) -> Result<Self, String> {
        let winder = |speed| Winder::at_speed(speed).map_err(|error| error.to_string());
        let walk = |speed| Walk::of(&winder(speed)?).map_err(|error| error.to_string());
        let walks = SPEEDS.into_iter().map(walk).collect::<Result<_, String>>()?;
        let bench = winder(SPEEDS[2])?;
        let map = |winder| StabilityMap::of(&winder, FASTEST).map_err(|error| error.to_string());
        let maps = vec![map(bench)?, map(Winder { preload: HARDER, ..bench })?];
        Ok(Self { walks, maps, with_times })
    }
}

/// Renders walks and maps, or the reason why there are none.
pub fn section(report: &Report) -> Markup {
    html! {
        p {
            "A linear model of a winder is enough if every operating frequency stays a factor of "
            (number(spectrum::ENOUGH, 2)) " from the resonance while the package grows ("
            (report.named("winder_linear")) "); a stiffening layer, if
             they stay a factor of " (number(layer::ENOUGH, 2)) " from the resonance at its
             amplitude (" (report.named("winder_nonlinear"))
            "); what is left takes the full one (" (report.named("winder_full"))
            "). All three run each time, to show what the later ones change. Values are the worst
             over the radii of the package. " code { "machinist studies walk" }
            " computes them for other winders."
        }
        @match &report.winder {
            Ok(study) => {
                @for walk in &study.walks { (walked(walk, study.with_times)) }
                (maps(&study.maps))
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

fn maps(maps: &[StabilityMap]) -> Markup {
    html! {
        h3 { "Where winding is stable" }
        p {
            "The unbalance grows with the square of the speed. The pressure varies by the sum of
             amplitudes at worst phases, so that what is stable here neither leaves the drum nor
             slips. The colour is that of the condition which fails first; of adhesion the margin is
             (N - dN) (f - (fa r + k)/R) - Pn. The drum's shape, twice a turn,
             meets the resonance at half the speed at which its unbalance does."
        }
        @for (index, map) in maps.iter().enumerate() { (drawn(map, index)) }
    }
}

fn drawn(map: &StabilityMap, index: usize) -> Markup {
    let limits = &map.limits;
    let millimetres: Vec<f64> = map.radii.iter().map(|radius| 1e3 * radius).collect();
    let named = Condition::ALL.iter().zip(CLASS_COLOURS);
    let classes: Vec<figure::Class> =
        named.map(|(condition, colour)| figure::Class { name: condition.name(), colour }).collect();
    figure::classes(
        &format!("winder-stability-{}", index + 1),
        (&millimetres, &map.speeds),
        &classes,
        &cells(map),
        ["radius of the package [mm]", "winding speed [m/s]"],
        &html! {
            "Pressure " (number(limits.pressure, 4)) " N, tension " (number(limits.tension, 4))
            " N, at most " (number(limits.largest, 4)) " N on the yarn, stiffness known to "
            (number(100.0 * limits.spread, 2)) " %. Of all points: "
            @for condition in Condition::ALL {
                @if map.share(condition) > 0.0 {
                    (condition.name()) " " (number(100.0 * map.share(condition), 2)) " %; "
                }
            }
            code { "machinist studies walk --preload " (number(limits.pressure, 4)) " --map map.svg" }
        },
    )
}

/// Returns the first condition that fails in each cell, as an index of [`Condition::ALL`].
fn cells(map: &StabilityMap) -> Vec<Vec<usize>> {
    let index = |cell: &Cell| {
        Condition::ALL.iter().position(|condition| *condition == cell.condition).unwrap_or(0)
    };
    map.cells.iter().map(|row| row.iter().map(index).collect()).collect()
}

/// Colours in the order of [`Condition::ALL`].
const CLASS_COLOURS: [[u8; 3]; 5] =
    [[86, 180, 233], [176, 58, 72], [213, 94, 0], [230, 184, 0], [122, 86, 160]];

//! Figures 5 and 6 of the saw-gin study, drawn by its formulas and by the consistent shaft.

use machinist_studies::closed_form::printed_laws::{
    PrintedShaft, Reading, SAW_GIN_SHAFT, TWIST_TIME,
};
use machinist_studies::closed_form::shaft::{LoadDensity, SAW_GIN_SHAFT as CONSISTENT};
use maud::{Markup, html};

use super::figure::{self, Named, Scales};
use crate::number::number;

const TIMES: u32 = 1800;
const PLACES: u32 = 60;

/// Renders both figures.
pub fn section() -> Markup {
    let shaft = SAW_GIN_SHAFT;
    html! {
        p {
            "Slope and angle of the saw cylinder's shaft by formulas (14) and (15) of the study. Its
             headline figures, 1.89 deg/m and 4.39 deg, follow from the density J instead of J/l and
             half the load term; the second is that slope times the length. The consistent shaft
             under the mean load twists by some hundredths of a degree."
        }
        (figure::curves(
            "printed-slope",
            ["time [s]", "slope [deg/m]"],
            &slopes(&shaft),
            Scales::Linear,
            &html! { "Figure 5 as printed, (14): slope over time at several x." },
        ))
        (figure::curves(
            "printed-angle",
            ["x [m]", "angle [deg]"],
            &angles(&shaft),
            Scales::Linear,
            &html! {
                "Figure 6: angle along the shaft at " (number(TWIST_TIME, 2)) " s, (15); the
                 consistent curve is the static twist under the mean load, spread evenly."
            },
        ))
    }
}

fn slopes(shaft: &PrintedShaft) -> Vec<Named> {
    let times: Vec<f64> =
        (0..=TIMES).map(|k| TWIST_TIME * f64::from(k) / f64::from(TIMES)).collect();
    let curve = |quarter: u32| {
        let x = shaft.length * f64::from(quarter) / 4.0;
        let slope = |time: &f64| shaft.slope(*time, x, Reading::AsPrinted).to_degrees();
        (format!("x = {} m", number(x, 3)), times.clone(), times.iter().map(slope).collect())
    };
    (1..=4).rev().map(curve).collect()
}

fn angles(shaft: &PrintedShaft) -> Vec<Named> {
    let places: Vec<f64> =
        (0..=PLACES).map(|k| shaft.length * f64::from(k) / f64::from(PLACES)).collect();
    let curve = |name: &str, angle: &dyn Fn(f64) -> f64| {
        let angles = places.iter().map(|x| angle(*x).to_degrees()).collect();
        (name.to_owned(), places.clone(), angles)
    };
    let headline = |x: f64| shaft.slope(TWIST_TIME, shaft.length, Reading::OfTheFigures) * x;
    let consistent =
        |x: f64| CONSISTENT.static_twist_under(x, shaft.load_mean, LoadDensity::Uniform);
    vec![
        curve("as printed, (15)", &|x| shaft.angle(TWIST_TIME, x, Reading::AsPrinted)),
        curve("slope of the headline figure times x", &headline),
        curve("consistent", &consistent),
    ]
}

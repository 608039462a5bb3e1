//! Plots of linear analyses.

use std::path::Path;

use super::panel::Panel;
use super::ruler::Axis;
use super::{Picture, PlotError};
use crate::linear_analysis::{Linearization, Mode, ModeKind, Response};
use crate::trajectory::{Column, ColumnKind};

/// Mode shapes drawn at most.
const MAX_MODES: usize = 6;

/// Draws amplitude and phase over frequency, into an `.svg` or `.png` file.
///
/// # Errors
/// [`PlotError`]; no file is written then, or only part of one.
pub fn plot_response(response: &Response, title: &str, path: &Path) -> Result<(), PlotError> {
    let Response { from, to, frequencies, .. } = response;
    let degrees = response.phases.iter().map(|phase| phase.to_degrees()).collect();
    let amplitude = column("amplitude", &response.amplitude_unit(), response.amplitudes.clone());
    let phase = column("phase", "deg", degrees);
    let horizontal = Axis::Logarithmic("frequency [rad/s]");
    let axes = [Axis::Logarithmic(""), Axis::Linear("")];
    let panel = |column, vertical| over(frequencies, vec![column], [&horizontal, vertical]);
    let picture = Picture {
        title,
        subtitle: format!("{to} answers {from}"),
        panels: vec![panel(&amplitude, &axes[0]), panel(&phase, &axes[1])],
    };
    picture.write(path)
}

/// Draws the shapes of the slowest six oscillations, or of aperiodic motions if there
/// is none, into an `.svg` or `.png` file: what coordinates and first-order states do
/// beside their scales, in phase with the one that moves most and a quarter later.
///
/// # Errors
/// As [`plot_response`]; [`PlotError::Nothing`] if all motions are free.
pub fn plot_modes(
    linearization: &Linearization<'_>,
    modes: &[Mode],
    path: &Path,
) -> Result<(), PlotError> {
    let simulator = linearization.simulator();
    let shape = simulator.shape();
    let n = shape.coordinates;
    let states: Vec<usize> = (0..n).chain(2 * n..shape.states()).collect();
    let places: Vec<f64> = (0..states.len()).map(|place| place as f64).collect();
    let names = states.iter().map(|state| simulator.state(*state).name.to_owned()).collect();
    let axes = [Axis::Names(names), Axis::Linear("")];
    let columns: Vec<[Column; 2]> = drawn(modes)
        .into_iter()
        .map(|mode| {
            let size = |state: &usize| {
                let [re, im] = mode.shape[*state];
                re.hypot(im) / simulator.state_scale(*state)
            };
            let largest = states.iter().map(size).fold(0.0, f64::max);
            let part = |which: usize| {
                let value = |state: &usize| {
                    mode.shape[*state][which] / simulator.state_scale(*state) / largest
                };
                states.iter().map(value).collect::<Vec<f64>>()
            };
            let later = part(1).iter().map(|value| -value).collect();
            [column(&described(mode), "1", part(0)), column("a quarter later", "1", later)]
        })
        .collect();
    let panels = columns
        .iter()
        .map(|pair| over(&places, pair.iter().collect(), [&axes[0], &axes[1]]))
        .collect();
    let subtitle = format!(
        "{}, shapes of natural motions at t = {} s, beside the scales of the states",
        simulator.name(),
        linearization.point().time
    );
    Picture { title: simulator.title(), subtitle, panels }.write(path)
}

/// The modes to draw.
fn drawn(modes: &[Mode]) -> Vec<&Mode> {
    let of = |kind: ModeKind| modes.iter().filter(move |mode| mode.kind == kind);
    let oscillations: Vec<&Mode> = of(ModeKind::Oscillation).take(MAX_MODES).collect();
    if oscillations.is_empty() {
        of(ModeKind::Aperiodic).take(MAX_MODES).collect()
    } else {
        oscillations
    }
}

fn described(mode: &Mode) -> String {
    let (frequency, ratio) = (mode.natural_frequency(), mode.damping_ratio());
    match mode.kind {
        ModeKind::Oscillation => {
            format!("{frequency:.5} rad/s, damping ratio {ratio:.3}: in phase")
        }
        ModeKind::Aperiodic | ModeKind::Free => {
            format!("decay within {:.3e} s: in phase", mode.decay_time())
        }
    }
}

fn column(name: &str, unit: &str, values: Vec<f64>) -> Column {
    let (name, unit) = (name.to_owned(), unit.to_owned());
    Column { name, unit, kind: ColumnKind::Output, doc: String::new(), values }
}

fn over<'a>(
    places: &'a [f64],
    columns: Vec<&'a Column>,
    [horizontal, vertical]: [&'a Axis; 2],
) -> Panel<'a> {
    let unit = columns.first().map_or("", |column| column.unit.as_str());
    Panel { unit, places, columns, horizontal, vertical }
}

//! Plots of linear analyses.

use std::path::Path;

use super::panel::{Mark, Panel, over};
use super::ruler::Axis;
use super::{Picture, PlotError, alike};
use machinist::linear_analysis::{Campbell, Linearization, Mode, ModeKind, Response};
use machinist::trajectory::{Column, ColumnKind};

/// Maximum number of mode shapes drawn.
const MAX_MODES: usize = 6;

/// Draws amplitude and phase over frequency, into an `.svg` or `.png` file.
///
/// # Errors
/// [`PlotError`]. In that case no file is written, or only part of one.
pub fn plot_response(response: &Response, title: &str, path: &Path) -> Result<(), PlotError> {
    let Response { from, to, frequencies, .. } = response;
    let degrees = response.phases.iter().map(|phase| phase.to_degrees()).collect();
    let amplitude = column("amplitude", &response.amplitude_unit(), response.amplitudes.clone());
    let phase = column("phase", "deg", degrees);
    let horizontal = Axis::Logarithmic("frequency [rad/s]".into());
    let axes = [Axis::Logarithmic("".into()), Axis::Linear("".into())];
    let panel = |column, vertical| over(frequencies, vec![column], [&horizontal, vertical]);
    let picture = Picture {
        title,
        subtitle: format!("{to} answers {from}"),
        panels: vec![panel(&amplitude, &axes[0]), panel(&phase, &axes[1])],
    };
    picture.write(path)
}

/// Draws frequencies over a parameter, with orders of the speed if there is one and circles at
/// their crossings, into an `.svg` or `.png` file. Frequencies and orders are in `unit`;
/// `per_speed` is one unit of the diagram's speed in that unit.
///
/// # Errors
/// As [`plot_response`]; [`PlotError::Nothing`] if nothing oscillates.
pub fn plot_campbell(
    diagram: &Campbell,
    orders: &[f64],
    (unit, per_speed): (&str, f64),
    title: &str,
    path: &Path,
) -> Result<(), PlotError> {
    let branches = diagram.branches.iter().enumerate().map(|(index, branch)| {
        let name = format!("{} {}", index + 1, branch.moves);
        column(&name, unit, branch.frequencies.clone())
    });
    let mut drawn: Vec<Column> = branches.collect();
    let mut marks = Vec::new();
    let fastest = drawn.iter().flat_map(|column| &column.values).copied().fold(0.0, f64::max);
    for (order, speeds) in orders.iter().zip(diagram.speeds.iter().cycle()) {
        // The lines end where the frequencies end.
        let along = speeds.iter().map(|speed| order * speed.abs() * per_speed);
        let along = along.map(|line| if line <= 1.05 * fastest { line } else { f64::NAN });
        let along: Vec<f64> = along.collect();
        let last = along.iter().rposition(|line| line.is_finite());
        marks.extend(last.map(|last| Mark {
            place: diagram.values[last],
            value: along[last],
            label: format!("order {order}"),
            is_circled: false,
        }));
        drawn.push(column(&format!("order {order}"), unit, along));
    }
    marks.extend(diagram.critical.iter().map(|meeting| Mark {
        place: meeting.value,
        value: meeting.frequency,
        label: rounded(meeting.value),
        is_circled: true,
    }));
    let axes = [
        Axis::Linear(format!("{} [{}]", diagram.parameter, diagram.unit).into()),
        Axis::Linear("".into()),
    ];
    let mut panel = over(&diagram.values, drawn.iter().collect(), [&axes[0], &axes[1]]);
    panel.marks = marks;
    let subtitle = format!("natural frequencies over {}", diagram.parameter);
    Picture { title, subtitle, panels: vec![panel] }.write(path)
}

/// Draws curves over a parameter that may turn back, each in a panel, with marks at (place, value,
/// label) in the first panel, into an `.svg` or `.png` file; `texts` are title and subtitle.
///
/// # Errors
/// As [`plot_response`].
pub fn plot_branch(
    (parameter, places): (String, &[f64]),
    panels: &[Vec<Column>],
    marks: Vec<(f64, f64, String)>,
    texts: [&str; 2],
    path: &Path,
) -> Result<(), PlotError> {
    let axes = [Axis::Linear(parameter.into()), Axis::Linear("".into())];
    let all = panels.iter();
    let all = all.map(|columns| over(places, columns.iter().collect(), [&axes[0], &axes[1]]));
    let mut panels: Vec<Panel<'_>> = all.collect();
    if let Some(first) = panels.first_mut() {
        let mark = |(place, value, label)| Mark { place, value, label, is_circled: true };
        first.marks = marks.into_iter().map(mark).collect();
    }
    Picture { title: texts[0], subtitle: texts[1].to_owned(), panels }.write(path)
}

/// Smallest amplitude that counts as a line in a plot, relative to the largest of the column.
const LINE: f64 = 2e-3;
/// Room on the right of the last line, relative to its frequency.
const ROOM: f64 = 0.25;

/// Returns the number of values up to the last line that is visible in a plot, with room on its
/// right. The mean, which comes first, is no line.
fn with_lines(columns: &[Column]) -> usize {
    let last = |column: &Column| {
        let lines = column.values.get(1..).unwrap_or_default();
        let largest = lines.iter().copied().fold(0.0, f64::max);
        lines.iter().rposition(|line| *line > LINE * largest).map_or(0, |last| last + 1)
    };
    let last = columns.iter().map(last).max().unwrap_or(0);
    let all = columns.iter().map(|column| column.values.len()).max().unwrap_or(0);
    if last == 0 { all } else { (last + 2 + (ROOM * last as f64) as usize).min(all) }
}

/// Draws amplitudes over frequency up to the last visible line, columns alike in one panel, into an `.svg` or `.png`
/// file; `texts` are title and subtitle.
///
/// # Errors
/// As [`plot_response`].
pub fn plot_spectrum(
    frequencies: &[f64],
    columns: &[Column],
    texts: [&str; 2],
    path: &Path,
) -> Result<(), PlotError> {
    let axes = [Axis::Linear("frequency [Hz]".into()), Axis::Linear("".into())];
    let shown = with_lines(columns).min(frequencies.len());
    let cropped =
        |column: &Column| Column { values: column.values[..shown].to_vec(), ..column.clone() };
    let columns: Vec<Column> = columns.iter().map(cropped).collect();
    let panels = alike(columns.iter()).into_iter();
    let panels = panels.map(|same| over(&frequencies[..shown], same, [&axes[0], &axes[1]]));
    let panels = panels.collect();
    Picture { title: texts[0], subtitle: texts[1].to_owned(), panels }.write(path)
}

/// Draws amplitudes of orders over a speed or over time, columns alike in one panel, into an `.svg`
/// or `.png` file; `texts` are title and subtitle.
///
/// # Errors
/// As [`plot_response`].
pub fn plot_cuts(
    (title, places): (&str, &[f64]),
    cuts: &[Column],
    texts: [&str; 2],
    path: &Path,
) -> Result<(), PlotError> {
    let axes = [Axis::Linear(title.to_owned().into()), Axis::Linear("".into())];
    let panels = alike(cuts.iter()).into_iter();
    let panels = panels.map(|same| over(places, same, [&axes[0], &axes[1]])).collect();
    Picture { title: texts[0], subtitle: texts[1].to_owned(), panels }.write(path)
}

/// Draws amplitudes over the number of cycles that reach them, columns alike in one panel, into an
/// `.svg` or `.png` file; `texts` are title and subtitle.
///
/// # Errors
/// As [`plot_response`].
pub fn plot_loads(
    places: &[f64],
    columns: &[Column],
    texts: [&str; 2],
    path: &Path,
) -> Result<(), PlotError> {
    let axes = [Axis::Logarithmic("cycles".into()), Axis::Linear("".into())];
    let panels = alike(columns.iter()).into_iter();
    let panels = panels.map(|same| over(places, same, [&axes[0], &axes[1]])).collect();
    Picture { title: texts[0], subtitle: texts[1].to_owned(), panels }.write(path)
}

/// Draws errors over the size of steps, into an `.svg` or `.png` file; `texts` are title and
/// subtitle.
///
/// # Errors
/// As [`plot_response`].
pub fn plot_errors(
    sizes: &[f64],
    errors: Vec<(String, Vec<f64>)>,
    texts: [&str; 2],
    path: &Path,
) -> Result<(), PlotError> {
    let drawn = errors.into_iter().map(|(name, values)| column(&name, "1", values));
    let drawn: Vec<Column> = drawn.collect();
    let axes = [Axis::Logarithmic("step [s]".into()), Axis::Logarithmic("".into())];
    let panel = over(sizes, drawn.iter().collect(), [&axes[0], &axes[1]]);
    Picture { title: texts[0], subtitle: texts[1].to_owned(), panels: vec![panel] }.write(path)
}

/// Draws tau of likelihood profiles over the change of their parameters in standard errors, and the
/// limits of 95 %, into an `.svg` or `.png` file.
///
/// # Errors
/// As [`plot_response`].
pub fn plot_profiles(
    places: &[f64],
    curves: Vec<(String, Vec<f64>)>,
    limit: f64,
    title: &str,
    path: &Path,
) -> Result<(), PlotError> {
    let limits = [("t of 95 %", limit), ("-t", -limit)];
    let limits = limits.map(|(name, limit)| (name.to_owned(), vec![limit; places.len()]));
    let drawn = curves.into_iter().chain(limits);
    let drawn: Vec<Column> = drawn.map(|(name, values)| column(&name, "1", values)).collect();
    let axes = [
        Axis::Linear("change of the parameter, in standard errors".into()),
        Axis::Linear("".into()),
    ];
    let panel = over(places, drawn.iter().collect(), [&axes[0], &axes[1]]);
    let subtitle = "profiles: signed root of the growth of the sum of squares, over s".to_owned();
    Picture { title, subtitle, panels: vec![panel] }.write(path)
}

/// Draws the shapes of the slowest six oscillations, or of aperiodic motions if there are none,
/// into an `.svg` or `.png` file.
///
/// The values are square roots of the shares of coordinates and first-order states, the largest as
/// 1, in phase with that one and a quarter of a period later. For equal undamped masses this is the
/// mode shape itself. The values do not depend on units.
///
/// # Errors
/// As [`plot_response`]; [`PlotError::Nothing`] if all motions are free.
pub fn plot_modes(
    linearization: &Linearization<'_>,
    modes: &[Mode],
    path: &Path,
) -> Result<(), PlotError> {
    let simulator = linearization.simulator();
    let n = simulator.shape().coordinates;
    let all = linearization.motion_names();
    let motions: Vec<usize> = (0..n).chain(2 * n..all.len()).collect();
    let places: Vec<f64> = (0..motions.len()).map(|place| place as f64).collect();
    let names = motions.iter().map(|motion| all[*motion].clone()).collect();
    let axes = [Axis::Names(names), Axis::Linear("".into())];
    let columns: Vec<[Column; 2]> = drawn(modes)
        .into_iter()
        .map(|mode| {
            let largest = mode.shares.iter().copied().fold(0.0, f64::max);
            let part = |which: usize| {
                let value = |(motion, share): (&usize, &f64)| {
                    let [re, im] = mode.shape[*motion];
                    let size = re.hypot(im);
                    let direction = if size > 0.0 { [re, im][which] / size } else { 0.0 };
                    (share / largest).sqrt() * direction
                };
                motions.iter().zip(&mode.shares).map(value).collect::<Vec<f64>>()
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
        "{}, natural motions at t = {} s: roots of the shares of states, with their phase",
        simulator.name(),
        linearization.point().time
    );
    Picture { title: simulator.title(), subtitle, panels }.write(path)
}

/// Returns the modes to draw.
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
            format!("{} rad/s, damping ratio {ratio:.3}: in phase", rounded(frequency))
        }
        ModeKind::Aperiodic | ModeKind::Free => {
            format!("decay within {} s: in phase", rounded(mode.decay_time()))
        }
    }
}

/// Formats four significant digits.
fn rounded(value: f64) -> String {
    if !(1e-3..1e6).contains(&value.abs()) {
        return format!("{value:.3e}");
    }
    let decimals = (3 - value.abs().log10().floor() as i32).max(0) as usize;
    format!("{value:.decimals$}")
}

fn column(name: &str, unit: &str, values: Vec<f64>) -> Column {
    let (name, unit) = (name.to_owned(), unit.to_owned());
    Column { name, unit, kind: ColumnKind::Output, doc: String::new(), values }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_spectrum_is_shown_up_to_its_last_line() {
        let of = |line: usize| {
            let mut values = vec![1e-6; 1000];
            (values[0], values[5], values[line]) = (f64::NAN, 2.0, 0.1);
            column("x", "m", values)
        };
        assert_eq!(with_lines(&[of(40)]), 52);
        assert_eq!(with_lines(&[of(40), of(100)]), 127);
        assert_eq!(with_lines(&[of(990)]), 1000);
        assert_eq!(with_lines(&[column("x", "m", vec![0.0; 8])]), 8);
    }
}

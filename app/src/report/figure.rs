//! Plots of the page. `page.js` shows values at the pointer.

mod chart;

use machinist::trajectory::Column;
use machinist_studies::work_precision::{Point, WorkPrecision};
use maud::{Markup, PreEscaped, html};

use crate::number::number;
use crate::plot::ruler::Axis;
use chart::{Colour, Frame, Panel, figure, keys, legend};

/// Number of points above which only the least and greatest of each bin are drawn.
const MAX_POINTS: usize = 1600;
/// Maximum number of curves of a small plot.
const MOST_SMALL: usize = 3;
/// Rows of a field's picture.
const ROWS: usize = 120;

/// Returns the script of the page.
pub fn script() -> Markup {
    html! { script { (PreEscaped(include_str!("page.js"))) } }
}

/// Plots columns of one unit over time.
pub fn over_time(id: &str, times: &[f64], columns: &[&Column], caption: &Markup) -> Markup {
    let Some(first) = columns.first() else { return html! {} };
    let quantity = if let [only] = columns { only.name.as_str() } else { "" };
    let title = format!("{quantity}{}", in_brackets(&first.unit));
    let values: Vec<f64> = columns.iter().flat_map(|column| column.values.clone()).collect();
    let axes = [Axis::Linear("".into()), Axis::Linear("".into())];
    let titles = ["time [s]", title.trim()];
    let mut panel = Panel::new(Frame::WHOLE, axes, titles, (times, &values));
    for (index, column) in columns.iter().enumerate() {
        let (x, y) = reduced(times, &column.values);
        panel.line(index, &column.name, &x, &y);
    }
    let names = columns.iter().map(|column| column.name.as_str());
    let legend = if columns.len() > 1 {
        legend(names)
    } else {
        html! {}
    };
    // All figures of a scene share the time at the pointer.
    let scene = id.split('-').next();
    figure(id, &[panel], &legend, scene, caption)
}

/// Plots columns of one unit over time in small, without axes.
pub fn thumbnail(times: &[f64], columns: &[&Column]) -> Markup {
    let (Some(first), [start, .., end]) = (columns.first(), times) else { return html! {} };
    let columns = &columns[..columns.len().min(MOST_SMALL)];
    let names: Vec<&str> = columns.iter().map(|column| column.name.as_str()).collect();
    let curves: Vec<(Vec<f64>, Vec<f64>)> =
        columns.iter().map(|column| reduced(times, &column.values)).collect();
    let span = format!("{} s", number(end - start, 3));
    html! {
        (legend(names.iter().copied()))
        (chart::small(&names.join(", "), &curves))
        div.muted { (in_brackets(&first.unit)) " over " (span) }
    }
}

/// Plots the error over run time, and beside it the error over tolerance, a curve for each method.
pub fn work_precision(id: &str, measured: &WorkPrecision, caption: &Markup) -> Markup {
    let all = |of: &dyn Fn(&Point) -> f64| -> Vec<f64> {
        measured.curves.iter().flat_map(|curve| curve.points.iter().map(of)).collect()
    };
    let logarithmic = || [Axis::Logarithmic("".into()), Axis::Logarithmic("".into())];
    let (times, errors) = (all(&|point| point.milliseconds), all(&|point| point.error));
    let (rtols, shares) = (all(&|point| point.rtol), all(&Point::proportionality));
    let titles = ["run time [ms]", "largest relative error"];
    let mut left = Panel::new(Frame::WIDER_HALF, logarithmic(), titles, (&times, &errors));
    let titles = ["tolerance", "error over tolerance"];
    let mut right = Panel::new(Frame::OTHER_HALF, logarithmic(), titles, (&rtols, &shares));
    for (index, curve) in measured.curves.iter().enumerate() {
        let name = curve.method.name();
        let values =
            |of: &dyn Fn(&Point) -> f64| -> Vec<f64> { curve.points.iter().map(of).collect() };
        let (x, y) = (values(&|point| point.milliseconds), values(&|point| point.error));
        left.line(index, name, &x, &y);
        right.line(index, name, &values(&|point| point.rtol), &values(&Point::proportionality));
        for point in &curve.points {
            let Point { rtol, error, milliseconds, work, .. } = point;
            let says = format!(
                "{name}, rtol {rtol:.0e}: error {error:.1e}, {milliseconds:.3} ms, {} steps",
                work.steps
            );
            left.dot(index, *milliseconds, *error, Some(&says));
            right.dot(index, *rtol, point.proportionality(), None);
        }
    }
    let names = measured.curves.iter().map(|curve| curve.method.name());
    figure(id, &[left, right], &legend(names), None, caption)
}

/// Draws a quantity over time and place as colours, with a row of `values` for each place.
pub fn picture(
    id: &str,
    (times, places): (&[f64], &[f64]),
    values: &[Vec<f64>],
    unit: &str,
    caption: &Markup,
) -> Markup {
    let largest = values.iter().flatten().fold(0.0, |most: f64, value| most.max(value.abs()));
    let shade = |value: f64| diverging(if largest > 0.0 { value / largest } else { 0.0 });
    let (Some(low), Some(high)) = (places.first(), places.last()) else { return html! {} };
    // Places are not equally spaced, but rows of a picture are.
    let row = |index: usize| {
        let place = high + (low - high) * (index as f64 + 0.5) / ROWS as f64;
        let above = places.partition_point(|at| *at < place).clamp(1, places.len() - 1);
        let share = (place - places[above - 1]) / (places[above] - places[above - 1]);
        let between = values[above - 1].iter().zip(&values[above]);
        between.map(|(a, b)| shade(a + share * (b - a))).collect()
    };
    if places.len() < 2 {
        return html! {};
    }
    let rows: Vec<Vec<Colour>> = (0..ROWS).map(row).collect();
    let mut panel = Panel::of_picture(["time [s]", "x [m]"], (times, places));
    panel.picture(&rows);
    let ends = [-1.0, 0.0, 1.0].map(|share| {
        let [red, green, blue] = diverging(share);
        (format!("{} {unit}", number(share * largest, 3)), format!("rgb({red} {green} {blue})"))
    });
    let keys = keys(ends.iter().map(|(name, colour)| (name.as_str(), colour.clone())));
    figure(id, &[panel], &keys, None, caption)
}

/// Class of places with its colour.
pub struct Class {
    pub name: &'static str,
    pub colour: Colour,
}

/// Draws the class at each place, from rows of indices of `classes`, the lowest place first.
pub fn classes(
    id: &str,
    axes: (&[f64], &[f64]),
    classes: &[Class],
    cells: &[Vec<usize>],
    titles: [&str; 2],
    caption: &Markup,
) -> Markup {
    let row = |row: &Vec<usize>| row.iter().map(|class| classes[*class].colour).collect();
    let rows: Vec<Vec<Colour>> = cells.iter().rev().map(row).collect();
    let mut panel = Panel::of_picture(titles, axes);
    panel.picture(&rows);
    let occurs = |index: &usize| cells.iter().flatten().any(|class| class == index);
    let found = (0..classes.len()).filter(occurs).map(|index| {
        let Class { name, colour: [red, green, blue] } = &classes[index];
        (*name, format!("rgb({red} {green} {blue})"))
    });
    figure(id, &[panel], &keys(found), None, caption)
}

/// Curve with its name.
pub type Named = (String, Vec<f64>, Vec<f64>);

/// Scales of both axes. Few points are marked, as those of logarithmic axes are.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Scales {
    /// Both linear.
    Linear,
    /// The horizontal axis is logarithmic.
    LogarithmicAcross,
    /// Both logarithmic.
    Logarithmic,
}

impl Scales {
    fn axes(self) -> [Axis; 2] {
        let linear = || Axis::Linear("".into());
        let logarithmic = || Axis::Logarithmic("".into());
        match self {
            Self::Linear => [linear(), linear()],
            Self::LogarithmicAcross => [logarithmic(), linear()],
            Self::Logarithmic => [logarithmic(), logarithmic()],
        }
    }
}

/// Plots curves of one quantity over another.
pub fn curves(
    id: &str,
    titles: [&str; 2],
    curves: &[Named],
    scales: Scales,
    caption: &Markup,
) -> Markup {
    let across: Vec<f64> = curves.iter().flat_map(|(_, x, _)| x.clone()).collect();
    let up: Vec<f64> = curves.iter().flat_map(|(_, _, y)| y.clone()).collect();
    let mut panel = Panel::new(Frame::WHOLE, scales.axes(), titles, (&across, &up));
    for (index, (name, x, y)) in curves.iter().enumerate() {
        let (thin_x, thin_y) = reduced(x, y);
        panel.line(index, name, &thin_x, &thin_y);
        if scales != Scales::Linear {
            for (x, y) in x.iter().zip(y) {
                panel.dot(index, *x, *y, None);
            }
        }
    }
    let names = curves.iter().map(|(name, _, _)| name.as_str());
    let legend = if curves.len() > 1 {
        legend(names)
    } else {
        html! {}
    };
    figure(id, &[panel], &legend, None, caption)
}

fn in_brackets(unit: &str) -> String {
    if unit == "1" { String::new() } else { format!(" [{unit}]") }
}

/// Returns a colour from blue at -1 over white at 0 to red at 1.
fn diverging(share: f64) -> Colour {
    let ends: [[f64; 3]; 2] = [[33.0, 102.0, 172.0], [178.0, 24.0, 43.0]];
    let end = ends[usize::from(share > 0.0)];
    let share = if share.is_finite() { share.abs().min(1.0) } else { 0.0 };
    end.map(|end| (247.0 + share * (end - 247.0)).round() as u8)
}

/// Reduces the number of points of a curve without a visible change. Spikes stay.
fn reduced(times: &[f64], values: &[f64]) -> (Vec<f64>, Vec<f64>) {
    if times.len() <= MAX_POINTS {
        return (times.to_vec(), values.to_vec());
    }
    let bin = times.len().div_ceil(MAX_POINTS / 2).max(2);
    let starts = (0..times.len()).step_by(bin);
    let mut keep: Vec<usize> = starts
        .flat_map(|start| {
            let indices = start..(start + bin).min(times.len());
            let by_value = |a: &usize, b: &usize| values[*a].total_cmp(&values[*b]);
            [indices.clone().min_by(by_value), indices.max_by(by_value)]
        })
        .flatten()
        .chain([0, times.len() - 1])
        .collect();
    keep.sort_unstable();
    keep.dedup();
    let pick = |list: &[f64]| keep.iter().map(|index| list[*index]).collect();
    (pick(times), pick(values))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_spike_survives_reduction() {
        let times: Vec<f64> = (0..10_000).map(f64::from).collect();
        let mut values = vec![0.0; times.len()];
        values[5003] = 7.0;
        let (x, y) = reduced(&times, &values);
        assert!(x.len() <= MAX_POINTS + 2);
        assert_eq!((x[0], x[x.len() - 1]), (0.0, 9999.0));
        assert!(y.contains(&7.0));
    }

    #[test]
    fn a_field_is_blue_below_zero_and_red_above() {
        assert_eq!(diverging(0.0), [247; 3]);
        assert_eq!((diverging(-1.0), diverging(2.0)), ([33, 102, 172], [178, 24, 43]));
    }
}

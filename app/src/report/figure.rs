//! Interactive plots. Each is a place and its data; one script, `page.js`, draws
//! them in the colours of the page when they come into view.

use machinist::trajectory::Column;
use maud::{Markup, PreEscaped, html};
use plotly::common::{
    Anchor, ColorScale, ColorScaleElement, ColorScalePalette, DashType, Line, Marker, Mode,
    Orientation, Title,
};
use plotly::configuration::Configuration;
use plotly::layout::{Axis, AxisType, HoverMode, Legend, Margin};
use plotly::{HeatMap, Layout, Plot, Scatter};

use machinist_studies::work_precision::{Point, WorkPrecision};

/// Colours that people with any colour vision can tell apart, on light and dark
/// (after M. Okabe and K. Ito, Color universal design, 2008).
const COLOURS: &[&str] =
    &["#2584c6", "#e69f00", "#009e73", "#cc79a7", "#56b4e9", "#d55e00", "#8c8c8c", "#a08a00"];

/// More points than this are drawn by the least and greatest of each bin.
const MAX_POINTS: usize = 2400;

/// The script that draws all plots, with plotly.js.
pub fn scripts() -> Markup {
    let sources = Plot::offline_js_sources();
    // The first of the two scripts is plotly.js; the other one sets LaTeX in
    // titles, of which there is none here.
    let plotly = sources.split_inclusive("</script>").next().unwrap_or_default();
    html! {
        (PreEscaped(plotly))
        script { (PreEscaped(include_str!("page.js"))) }
    }
}

/// Columns of one unit over time.
pub fn over_time(id: &str, times: &[f64], columns: &[&Column], caption: &Markup) -> Markup {
    let Some(first) = columns.first() else { return html! {} };
    let mut plot = Plot::new();
    for (index, column) in columns.iter().enumerate() {
        let (x, y) = reduced(times, &column.values);
        let unit = in_brackets(&column.unit);
        let trace = Scatter::new(x, y)
            .name(&column.name)
            .mode(Mode::Lines)
            .line(line(index))
            .hover_template(format!("%{{y:.6~g}}{unit}"));
        plot.add_trace(trace);
    }
    let quantity = if let [only] = columns { only.name.as_str() } else { "" };
    let y_title = format!("{quantity}{}", in_brackets(&first.unit));
    let axis = Axis::new().title(Title::with_text(y_title.trim()));
    let layout = layout()
        .x_axis(Axis::new().title(Title::with_text("time [s]")).hover_format(".6~g"))
        .y_axis(axis.exponent_format(plotly::common::ExponentFormat::SmallE))
        .hover_mode(HoverMode::XUnified)
        .show_legend(columns.len() > 1);
    plot.set_layout(layout);
    element(id, &plot, caption)
}

/// Error against run time, and beside it error over tolerance; a curve a method.
pub fn work_precision(id: &str, measured: &WorkPrecision, caption: &Markup) -> Markup {
    let mut plot = Plot::new();
    for (index, curve) in measured.curves.iter().enumerate() {
        let points = &curve.points;
        let hover = points.iter().map(|point| {
            format!(
                "rtol {:.0e}<br>error {:.2e}<br>{:.3} ms<br>{} steps<br>{} rate evaluations",
                point.rtol,
                point.error,
                point.milliseconds,
                point.work.steps,
                point.work.rate_evaluations
            )
        });
        let hover: Vec<String> = hover.collect();
        let values = |of: &dyn Fn(&Point) -> f64| points.iter().map(of).map(rounded).collect();
        let trace = |x: Vec<f64>, y: Vec<f64>| {
            Scatter::new(x, y)
                .name(curve.method.name())
                .legend_group(curve.method.name())
                .mode(Mode::LinesMarkers)
                .line(line(index))
                .marker(Marker::new().size(6).color(COLOURS[index % COLOURS.len()]))
                .text_array(hover.clone())
                .hover_template("%{text}")
        };
        plot.add_trace(trace(values(&|point| point.milliseconds), values(&|point| point.error)));
        let beside = trace(values(&|point| point.rtol), values(&Point::proportionality));
        plot.add_trace(beside.x_axis("x2").y_axis("y2").show_legend(false));
    }
    let logarithmic = |title: &str| {
        Axis::new()
            .title(Title::with_text(title))
            .type_(AxisType::Log)
            .exponent_format(plotly::common::ExponentFormat::SmallE)
    };
    let layout = layout()
        .x_axis(logarithmic("run time [ms]").domain(&[0.0, 0.56]))
        .y_axis(logarithmic("largest relative error"))
        .x_axis2(logarithmic("tolerance").domain(&[0.68, 1.0]).anchor("y2"))
        .y_axis2(logarithmic("error over tolerance").anchor("x2"))
        .hover_mode(HoverMode::Closest);
    plot.set_layout(layout);
    element(id, &plot, caption)
}

/// A quantity over time and place, as colours: a row of `values` for each place.
pub fn picture(
    id: &str,
    (times, places): (&[f64], &[f64]),
    values: &[Vec<f64>],
    unit: &str,
    caption: &Markup,
) -> Markup {
    let round = |values: &[f64]| values.iter().copied().map(rounded).collect::<Vec<f64>>();
    let rows = values.iter().map(|row| round(row)).collect();
    let largest = values.iter().flatten().fold(0.0, |most: f64, value| most.max(value.abs()));
    let map = HeatMap::new(round(times), round(places), rows)
        .color_scale(ColorScale::Palette(ColorScalePalette::RdBu))
        .zmin(-largest)
        .zmax(largest)
        .hover_template(format!("%{{x:.5~g}} s, %{{y:.4~g}} m: %{{z:.4~g}} {unit}"));
    let mut plot = Plot::new();
    plot.add_trace(map);
    let axis = |title: &str| Axis::new().title(Title::with_text(title));
    plot.set_layout(layout().x_axis(axis("time [s]")).y_axis(axis("x [m]")));
    element(id, &plot, caption)
}

/// Where something is the case, in a colour of its own: a row of values for each place,
/// NaN where it is not.
pub struct Class {
    pub name: &'static str,
    pub colour: &'static str,
    pub values: Vec<Vec<f64>>,
}

/// What is the case where.
pub fn classes(
    id: &str,
    (across, up): (&[f64], &[f64]),
    classes: &[Class],
    [x_title, y_title]: [&str; 2],
    hover: &str,
    caption: &Markup,
) -> Markup {
    let round = |values: &[f64]| values.iter().copied().map(rounded).collect::<Vec<f64>>();
    let mut plot = Plot::new();
    for Class { name, colour, values } in classes {
        let scale = [0.0, 1.0].map(|end| ColorScaleElement(end, (*colour).to_owned()));
        let rows: Vec<Vec<f64>> = values.iter().map(|row| round(row)).collect();
        let map = HeatMap::new(round(across), round(up), rows)
            .name(name)
            .color_scale(ColorScale::Vector(scale.to_vec()))
            .show_scale(false)
            .show_legend(true)
            .hover_on_gaps(false)
            .hover_template(hover);
        plot.add_trace(map);
    }
    let axis = |title: &str| Axis::new().title(Title::with_text(title));
    let layout = layout().x_axis(axis(x_title)).y_axis(axis(y_title));
    plot.set_layout(layout.hover_mode(HoverMode::Closest));
    element(id, &plot, caption)
}

/// A curve by its name.
pub type Named = (String, Vec<f64>, Vec<f64>);

/// Curves of one quantity over another, on logarithmic axes if wanted.
pub fn curves(
    id: &str,
    [x_title, y_title]: [&str; 2],
    curves: &[Named],
    is_logarithmic: bool,
    caption: &Markup,
) -> Markup {
    let mut plot = Plot::new();
    for (index, (name, x, y)) in curves.iter().enumerate() {
        let round = |values: &[f64]| values.iter().copied().map(rounded).collect();
        let mode = if is_logarithmic { Mode::LinesMarkers } else { Mode::Lines };
        let trace = Scatter::new(round(x), round(y)).name(name).mode(mode).line(line(index));
        plot.add_trace(trace);
    }
    let axis = |title: &str| {
        let axis = Axis::new().title(Title::with_text(title));
        if !is_logarithmic {
            return axis;
        }
        axis.type_(AxisType::Log).exponent_format(plotly::common::ExponentFormat::SmallE)
    };
    let layout = layout().x_axis(axis(x_title)).y_axis(axis(y_title));
    plot.set_layout(layout.hover_mode(HoverMode::Closest).show_legend(curves.len() > 1));
    element(id, &plot, caption)
}

fn element(id: &str, plot: &Plot, caption: &Markup) -> Markup {
    let mut plot = plot.clone();
    plot.set_configuration(Configuration::new().responsive(true).display_logo(false));
    // `<` inside of a script element could end it.
    let data = plot.to_json().replace('<', "\\u003c");
    html! {
        figure.plot id=(id) {
            div.canvas {}
            script type="application/json" { (PreEscaped(data)) }
            figcaption { (caption) }
        }
    }
}

fn layout() -> Layout {
    Layout::new()
        .auto_size(true)
        .margin(Margin::new().left(56).right(14).top(34).bottom(46))
        .legend(
            Legend::new()
                .orientation(Orientation::Horizontal)
                .x(0.0)
                .y(1.02)
                .y_anchor(Anchor::Bottom),
        )
        .paper_background_color("rgba(0,0,0,0)")
        .plot_background_color("rgba(0,0,0,0)")
}

fn line(index: usize) -> Line {
    let dash = if index < COLOURS.len() { DashType::Solid } else { DashType::Dot };
    Line::new().width(1.6).color(COLOURS[index % COLOURS.len()]).dash(dash)
}

fn in_brackets(unit: &str) -> String {
    if unit == "1" { String::new() } else { format!(" [{unit}]") }
}

/// The curve with so many points that it looks the same; spikes stay.
fn reduced(times: &[f64], values: &[f64]) -> (Vec<f64>, Vec<f64>) {
    let bin = times.len().div_ceil(MAX_POINTS / 2).max(2);
    let keep: Vec<usize> = if times.len() <= MAX_POINTS {
        (0..times.len()).collect()
    } else {
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
        keep
    };
    let pick = |list: &[f64]| keep.iter().map(|index| rounded(list[*index])).collect();
    (pick(times), pick(values))
}

/// Six digits, which is more than a screen shows.
fn rounded(value: f64) -> f64 {
    format!("{value:.5e}").parse().unwrap_or(value)
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
    fn the_page_carries_plotly_itself_and_no_reference_to_it() {
        let scripts = scripts().0;
        assert!(scripts.len() > 1_000_000);
        assert_eq!(scripts.matches("<script").count(), 2);
        assert!(!scripts.contains("<script src"));
    }
}

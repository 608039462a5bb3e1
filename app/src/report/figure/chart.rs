//! Plot as SVG within the page. It takes its colours from the page and needs no script to be seen.

use std::fmt::Write as _;

use base64::prelude::{BASE64_STANDARD, Engine as _};
use maud::{Markup, html};

use crate::plot::ruler::{Axis, Ruler};

/// Size of a plot, in its own units.
const WIDTH: f64 = 880.0;
const HEIGHT: f64 = 300.0;
/// Margins: for numbers on the left and below, for titles above and below.
const LEFT: f64 = 72.0;
const RIGHT: f64 = 22.0;
const TOP: f64 = 24.0;
const BOTTOM: f64 = 42.0;

/// Colours that can be distinguished with any colour vision, on light and dark backgrounds (after
/// M. Okabe and K. Ito, Color universal design, 2008).
const COLOURS: &[&str] =
    &["#2584c6", "#e69f00", "#009e73", "#cc79a7", "#56b4e9", "#d55e00", "#8c8c8c", "#a08a00"];

/// Red, green and blue.
pub(super) type Colour = [u8; 3];

/// Horizontal extent of a panel within the plot.
#[derive(Clone, Copy)]
pub(super) struct Frame {
    left: f64,
    right: f64,
}

impl Frame {
    pub(super) const WHOLE: Self = Self { left: LEFT, right: WIDTH - RIGHT };
    pub(super) const WIDER_HALF: Self = Self { left: LEFT, right: 0.56 * WIDTH };
    pub(super) const OTHER_HALF: Self = Self { left: 0.56 * WIDTH + LEFT, right: WIDTH - RIGHT };
}

/// Panel with two axes and its drawing.
pub(super) struct Panel {
    frame: Frame,
    axes: [Axis; 2],
    rulers: [Ruler; 2],
    titles: [String; 2],
    drawn: Vec<Markup>,
}

impl Panel {
    /// Creates a panel that spans these values across and up.
    pub(super) fn new(
        frame: Frame,
        axes: [Axis; 2],
        titles: [&str; 2],
        (across, up): (&[f64], &[f64]),
    ) -> Self {
        let [horizontal, vertical] = &axes;
        let placed = horizontal.placed(across);
        let across = match horizontal {
            Axis::Logarithmic(_) => horizontal.around(placed.into_iter()),
            _ => horizontal.along(&extent(&placed)),
        };
        let up = vertical.around(vertical.placed(up).into_iter());
        let titles = titles.map(str::to_owned);
        Self { frame, axes, rulers: [across, up], titles, drawn: Vec::new() }
    }

    /// Creates a panel whose axes end at the edges of a picture.
    pub(super) fn of_picture(titles: [&str; 2], (across, up): (&[f64], &[f64])) -> Self {
        let axes = [Axis::Linear("".into()), Axis::Linear("".into())];
        let rulers = [axes[0].along(&extent(across)), axes[1].along(&extent(up))];
        let titles = titles.map(str::to_owned);
        Self { frame: Frame::WHOLE, axes, rulers, titles, drawn: Vec::new() }
    }

    /// Returns the place of a point; `None` if a value or its logarithm is not a number.
    fn at(&self, x: f64, y: f64) -> Option<(f64, f64)> {
        let place = |axis: &Axis, value: f64| axis.placed(&[value])[0];
        let across = self.rulers[0].share(place(&self.axes[0], x));
        let up = self.rulers[1].share(place(&self.axes[1], y));
        let Frame { left, right } = self.frame;
        let point =
            (left + across * (right - left), HEIGHT - BOTTOM - up * (HEIGHT - TOP - BOTTOM));
        (point.0.is_finite() && point.1.is_finite()).then_some(point)
    }

    /// Draws a line through points, interrupted at missing ones. Path coordinates are in tenths,
    /// each point but the first of a piece relative to the one before.
    pub(super) fn line(&mut self, index: usize, name: &str, x: &[f64], y: &[f64]) {
        let mut path = String::new();
        let mut pen = None;
        for (x, y) in x.iter().zip(y) {
            let Some(point) = self.at(*x, *y) else {
                pen = None;
                continue;
            };
            let point = (tenths(point.0), tenths(point.1));
            let _ = match pen {
                Some(before) if before == point => continue,
                Some((x, y)) => write!(path, "l{} {}", point.0 - x, point.1 - y),
                None => write!(path, "M{} {}", point.0, point.1),
            };
            pen = Some(point);
        }
        let dashes = (index >= COLOURS.len()).then_some("2 3");
        self.drawn.push(html! {
            path.curve d=(path) data-name=(name) stroke=(colour(index)) stroke-dasharray=[dashes] {}
        });
    }

    /// Draws a dot with a tooltip.
    pub(super) fn dot(&mut self, index: usize, x: f64, y: f64, says: Option<&str>) {
        let Some((x, y)) = self.at(x, y) else { return };
        self.drawn.push(html! {
            circle cx=(tenth(x)) cy=(tenth(y)) r="3" fill=(colour(index)) {
                @if let Some(says) = says { title { (says) } }
            }
        });
    }

    /// Draws a picture that fills the panel, in rows from the top.
    pub(super) fn picture(&mut self, rows: &[Vec<Colour>]) {
        let Some(data) = png(rows) else { return };
        let Frame { left, right } = self.frame;
        let source = format!("data:image/png;base64,{}", BASE64_STANDARD.encode(data));
        self.drawn.push(html! {
            image x=(left) y=(TOP) width=(right - left) height=(HEIGHT - TOP - BOTTOM)
                preserveAspectRatio="none" href=(source) {}
        });
    }

    fn markup(&self) -> Markup {
        let Frame { left, right } = self.frame;
        let bottom = HEIGHT - BOTTOM;
        let across = |share: f64| tenth(left + share * (right - left));
        let up = |share: f64| tenth(bottom - share * (bottom - TOP));
        html! {
            g.panel data-axes=(self.axes_in_words()) {
                @for (share, label) in self.rulers[1].marks() {
                    line.grid x1=(left) x2=(right) y1=(up(share)) y2=(up(share)) {}
                    text.end x=(left - 8.0) y=(up(share) + 4.0) { (label) }
                }
                @for (share, label) in self.rulers[0].marks() {
                    line.tick x1=(across(share)) x2=(across(share)) y1=(bottom) y2=(bottom + 5.0) {}
                    text.middle x=(across(share)) y=(bottom + 19.0) { (label) }
                }
                line.tick x1=(left) x2=(right) y1=(bottom) y2=(bottom) {}
                text.title x=(left) y=(TOP - 10.0) { (self.titles[1]) }
                text.title.middle x=(f64::midpoint(left, right)) y=(HEIGHT - 6.0) { (self.titles[0]) }
                @for thing in &self.drawn { (thing) }
            }
        }
    }

    /// Describes the axes for the script, which converts places to values: for each direction the
    /// ends of the plot and of the axis, and whether the axis is logarithmic.
    fn axes_in_words(&self) -> String {
        let Frame { left, right } = self.frame;
        let ends = [(left, right), (HEIGHT - BOTTOM, TOP)];
        let words = ends.iter().zip(&self.rulers).zip(&self.axes).map(|((ends, ruler), axis)| {
            let range = ruler.ends();
            let is_logarithmic = u8::from(matches!(axis, Axis::Logarithmic(_)));
            format!("{} {} {:e} {:e} {is_logarithmic}", ends.0, ends.1, range.start, range.end)
        });
        words.collect::<Vec<_>>().join(" ")
    }
}

/// Renders a figure of panels. Figures with the same `link` share the time at the pointer.
pub(super) fn figure(
    id: &str,
    panels: &[Panel],
    legend: &Markup,
    link: Option<&str>,
    caption: &Markup,
) -> Markup {
    html! {
        figure.plot id=(id) {
            (legend)
            div.scroll {
                svg.chart viewBox={ "0 0 " (WIDTH) " " (HEIGHT) } role="img" data-link=[link]
                    aria-label=(id.replace('-', " ")) {
                    @for panel in panels { (panel.markup()) }
                }
            }
            figcaption { (caption) }
        }
    }
}

/// Size of a small plot.
const SMALL: [f64; 2] = [280.0, 96.0];

/// Renders a small plot of curves over time.
pub(super) fn small(name: &str, curves: &[(Vec<f64>, Vec<f64>)]) -> Markup {
    let [width, height] = SMALL;
    let across: Vec<f64> = curves.iter().flat_map(|(x, _)| x.clone()).collect();
    let up: Vec<f64> = curves.iter().flat_map(|(_, y)| y.clone()).collect();
    let axis = Axis::Linear("".into());
    let (across, up) = (axis.along(&extent(&across)), axis.around(up.into_iter()));
    let base = (0.0..=1.0).contains(&up.share(0.0)).then(|| tenth((1.0 - up.share(0.0)) * height));
    let path = |(x, y): &(Vec<f64>, Vec<f64>)| {
        let points = x.iter().zip(y).filter(|(x, y)| x.is_finite() && y.is_finite());
        let points = points.map(|(x, y)| {
            let at = (across.share(*x) * width, (1.0 - up.share(*y)) * height);
            format!("{} {}", tenth(at.0), tenth(at.1))
        });
        let mut points: Vec<String> = points.collect();
        points.dedup();
        format!("M{}", points.join("L"))
    };
    html! {
        svg.small viewBox={ "0 0 " (width) " " (height) } role="img" aria-label=(name) {
            @if let Some(y) = base { line.grid x1="0" x2=(width) y1=(y) y2=(y) {} }
            @for (index, curve) in curves.iter().enumerate() {
                path d=(path(curve)) stroke=(colour(index)) {}
            }
        }
    }
}

/// Renders names beside the colours of their lines.
pub(super) fn legend<'a>(names: impl Iterator<Item = &'a str>) -> Markup {
    let colours = (0..).map(|index| colour(index).to_owned());
    keys(names.zip(colours))
}

/// Renders names beside their colours.
pub(super) fn keys<'a>(keys: impl Iterator<Item = (&'a str, String)>) -> Markup {
    html! {
        ul.legend {
            @for (name, colour) in keys {
                li {
                    svg viewBox="0 0 18 10" aria-hidden="true" {
                        line x1="0" x2="18" y1="5" y2="5" stroke=(colour) stroke-width="3" {}
                    }
                    (name)
                }
            }
        }
    }
}

fn colour(index: usize) -> &'static str {
    COLOURS[index % COLOURS.len()]
}

/// Rounds to tenths of a plot's units, below which no difference is visible.
fn tenths(value: f64) -> i32 {
    (value.clamp(-1e5, 1e5) * 10.0).round() as i32
}

fn tenth(value: f64) -> f64 {
    f64::from(tenths(value)) / 10.0
}

fn extent(values: &[f64]) -> [f64; 2] {
    let finite = values.iter().copied().filter(|value| value.is_finite());
    let ends = finite.fold(None, |ends: Option<[f64; 2]>, value| {
        let [low, high] = ends.unwrap_or([value; 2]);
        Some([low.min(value), high.max(value)])
    });
    ends.unwrap_or([0.0, 1.0])
}

fn png(rows: &[Vec<Colour>]) -> Option<Vec<u8>> {
    let width = rows.first()?.len();
    let mut file = Vec::new();
    let mut encoder = png::Encoder::new(&mut file, width as u32, rows.len() as u32);
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_depth(png::BitDepth::Eight);
    let pixels: Vec<u8> = rows.iter().flatten().flatten().copied().collect();
    encoder.write_header().ok()?.write_image_data(&pixels).ok()?;
    Some(file)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn panel(axes: [Axis; 2], values: &[f64]) -> Panel {
        Panel::new(Frame::WHOLE, axes, ["x", "y"], (values, values))
    }

    #[test]
    fn a_line_is_broken_where_it_has_no_value() {
        let mut panel = panel([Axis::Linear("".into()), Axis::Linear("".into())], &[0.0, 3.0]);
        panel.line(0, "z", &[0.0, 1.0, 2.0, 3.0], &[0.0, f64::NAN, 2.0, 3.0]);
        let svg = panel.drawn[0].clone().into_string();
        let path = svg.split('"').find(|part| part.starts_with('M')).expect("a path");
        assert_eq!((path.matches('M').count(), path.matches('l').count()), (2, 1), "{path}");
    }

    #[test]
    fn logarithmic_axes_leave_out_what_is_not_positive() {
        let axes = [Axis::Logarithmic("".into()), Axis::Logarithmic("".into())];
        let panel = panel(axes, &[0.01, 100.0]);
        assert_eq!(panel.at(1.0, 0.0), None);
        let (x, y) = panel.at(1.0, 1.0).expect("a point");
        let middle = (f64::midpoint(LEFT, WIDTH - RIGHT), f64::midpoint(HEIGHT - BOTTOM, TOP));
        assert!((x - middle.0).abs() < 1e-9 && (y - middle.1).abs() < 1e-9);
    }

    #[test]
    fn a_picture_is_an_image_within_the_page() {
        let mut panel = Panel::of_picture(["t", "x"], (&[0.0, 1.0], &[0.0, 1.0]));
        panel.picture(&[vec![[255, 0, 0], [0, 0, 255]]]);
        let svg = panel.markup().into_string();
        assert!(svg.contains("href=\"data:image/png;base64,"), "{svg}");
    }
}

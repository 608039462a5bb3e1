//! Heat map of amplitudes over speed and order.

use std::path::Path;

use plotters::coord::Shift;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

use super::panel::{FAINT, INK};
use super::ruler::Axis;
use super::{DrawResult, Drawn, PlotError, SCALE, TITLE_HEIGHT, WIDTH, draw_title, text, write};

const HEIGHT: u32 = 420;
/// Width of the scale of colours with its labels.
const BAR: u32 = 110;
/// Range of the colours: factor between the largest amplitude and the faintest colour.
const RANGE: f64 = 1e3;
/// Colours from the faintest to the strongest, evenly spaced on the logarithm of the amplitude:
/// increasing in darkness, for readers with a colour vision deficiency.
const COLORS: [(f64, f64, f64); 6] = [
    (255.0, 255.0, 255.0),
    (208.0, 225.0, 242.0),
    (116.0, 169.0, 207.0),
    (120.0, 100.0, 170.0),
    (150.0, 40.0, 100.0),
    (60.0, 5.0, 40.0),
];

/// Amplitudes of an output.
pub struct Heat<'a> {
    /// Name and unit of the output.
    pub name: String,
    /// Places of the rows: speeds or times, with their title.
    pub places: (&'a [f64], &'a str),
    /// Orders of the lines.
    pub orders: &'a [f64],
    /// Amplitudes, a row for each place.
    pub amplitudes: &'a [Vec<f64>],
}

/// Draws heat maps above each other into an `.svg` or `.png` file, without the mean and up to the
/// order `highest`; `texts` are title and subtitle.
///
/// # Errors
/// [`PlotError`]. In that case no file is written, or only part of one.
pub fn plot_heat(
    maps: &[Heat<'_>],
    highest: f64,
    texts: [&str; 2],
    path: &Path,
) -> Result<(), PlotError> {
    if maps.iter().all(|map| map.amplitudes.is_empty()) {
        return Err(PlotError::Nothing);
    }
    write(&Picture { maps, highest, texts }, path)
}

struct Picture<'a> {
    maps: &'a [Heat<'a>],
    highest: f64,
    texts: [&'a str; 2],
}

impl Drawn for Picture<'_> {
    fn size(&self) -> (u32, u32) {
        (WIDTH * SCALE, (TITLE_HEIGHT + HEIGHT * self.maps.len() as u32) * SCALE)
    }

    fn draw<DB: DrawingBackend>(&self, area: &DrawingArea<DB, Shift>) -> DrawResult<DB> {
        area.fill(&WHITE)?;
        let (heading, mut rest) = area.split_vertically(TITLE_HEIGHT * SCALE);
        draw_title(&heading, self.texts[0], self.texts[1])?;
        for map in self.maps {
            let (own, below) = rest.split_vertically(HEIGHT * SCALE);
            map.draw(&own, self.highest)?;
            rest = below;
        }
        area.present()
    }
}

/// Returns the colour of an amplitude over the largest one.
fn color(share: f64) -> RGBColor {
    let strength = (1.0 + share.log10() / RANGE.log10()).clamp(0.0, 1.0);
    let place = if strength.is_finite() { strength * (COLORS.len() - 1) as f64 } else { 0.0 };
    let below = (place.floor() as usize).min(COLORS.len() - 2);
    let (a, b, part) = (COLORS[below], COLORS[below + 1], place - below as f64);
    let mixed = |a: f64, b: f64| (a + (b - a) * part).round() as u8;
    RGBColor(mixed(a.0, b.0), mixed(a.1, b.1), mixed(a.2, b.2))
}

impl Heat<'_> {
    fn draw<DB: DrawingBackend>(
        &self,
        area: &DrawingArea<DB, Shift>,
        highest: f64,
    ) -> DrawResult<DB> {
        let shown = self.orders.iter().take_while(|order| **order <= highest).count().max(2);
        let largest = self.amplitudes.iter().flat_map(|row| &row[1..shown]);
        let largest = largest.copied().fold(0.0, f64::max);
        let (left, bar) = area.split_horizontally((WIDTH - BAR) * SCALE);
        let (across, up) = (edges(self.places.0), edges(&self.orders[1..shown]));
        let axes = [Axis::Linear(self.places.1.to_owned().into()), Axis::Linear("order".into())];
        let [horizontal, vertical] = [axes[0].along(&across), axes[1].along(&up)];
        let (ticks_across, ticks_up) = (horizontal.ticks(), vertical.ticks());
        let mut chart = ChartBuilder::on(&left)
            .margin_top(30 * SCALE)
            .margin_right(8 * SCALE)
            .margin_left(10 * SCALE)
            .set_label_area_size(LabelAreaPosition::Left, 72 * SCALE)
            .set_label_area_size(LabelAreaPosition::Bottom, 52 * SCALE)
            .build_cartesian_2d(horizontal, vertical)?;
        for (row, amplitudes) in self.amplitudes.iter().enumerate() {
            let cells = amplitudes[1..shown].iter().enumerate().map(|(line, amplitude)| {
                let corners = [(across[row], up[line]), (across[row + 1], up[line + 1])];
                Rectangle::new(corners, color(amplitude / largest).filled())
            });
            chart.draw_series(cells)?;
        }
        chart
            .configure_mesh()
            .disable_mesh()
            .axis_style(FAINT.stroke_width(SCALE))
            .set_all_tick_mark_size(6 * SCALE)
            .x_labels(ticks_across)
            .y_labels(ticks_up)
            .label_style(text(13, FAINT))
            .axis_desc_style(text(14, INK))
            .x_desc(axes[0].title())
            .y_desc(axes[1].title())
            .draw()?;
        let style = text(15, INK).pos(Pos::new(HPos::Left, VPos::Top));
        area.draw_text(&self.name, &style, ((84 * SCALE) as i32, (6 * SCALE) as i32))?;
        draw_bar(&bar, largest)
    }
}

/// Draws the scale of colours.
fn draw_bar<DB: DrawingBackend>(area: &DrawingArea<DB, Shift>, largest: f64) -> DrawResult<DB> {
    const STEPS: u32 = 120;
    let [top, bottom, left, right] = [30, HEIGHT - 52, 6, 22].map(|size| (size * SCALE) as i32);
    let at = |step: u32| bottom + (top - bottom) * step as i32 / STEPS as i32;
    for step in 0..STEPS {
        let share = RANGE.powf(f64::from(step) / f64::from(STEPS) - 1.0);
        let corners = [(left, at(step + 1)), (right, at(step))];
        area.draw(&Rectangle::new(corners, color(share).filled()))?;
    }
    area.draw(&Rectangle::new([(left, top), (right, bottom)], FAINT.stroke_width(SCALE)))?;
    let style = text(13, FAINT).pos(Pos::new(HPos::Left, VPos::Center));
    for decade in 0..=3 {
        let label = crate::number::number(largest * 10f64.powi(decade - 3), 3);
        let place = (right + (6 * SCALE) as i32, at(STEPS * decade as u32 / 3));
        area.draw_text(&label, &style, place)?;
    }
    Ok(())
}

/// Returns the middles between places, and outer edges at the same distance.
fn edges(places: &[f64]) -> Vec<f64> {
    let middles = places.windows(2).map(|pair| f64::midpoint(pair[0], pair[1]));
    let (Some(first), Some(last)) = (places.first(), places.last()) else { return Vec::new() };
    let inner: Vec<f64> = middles.collect();
    let (Some(low), Some(high)) = (inner.first(), inner.last()) else {
        return vec![first - 0.5, last + 0.5];
    };
    let ends = [2.0 * first - low, 2.0 * last - high];
    std::iter::once(ends[0]).chain(inner).chain([ends[1]]).collect()
}

#[cfg(test)]
mod tests {
    use super::{color, edges};

    #[test]
    fn cells_end_half_way_to_their_neighbours() {
        assert_eq!(edges(&[1.0, 2.0, 4.0]), [0.5, 1.5, 3.0, 5.0]);
        assert_eq!(edges(&[2.0]), [1.5, 2.5]);
    }

    #[test]
    fn stronger_lines_are_darker() {
        let light = |share: f64| {
            let plotters::style::RGBColor(red, green, blue) = color(share);
            [red, green, blue].map(u32::from).iter().sum::<u32>()
        };
        let shares = [0.0, 1e-4, 1e-3, 1e-2, 0.1, 0.5, 1.0];
        assert!(shares.windows(2).all(|pair| light(pair[0]) >= light(pair[1])));
        assert!(light(1.0) < light(0.01));
    }
}

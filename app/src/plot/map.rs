//! Map of stable winding.

use std::path::Path;

use plotters::chart::ChartContext;
use plotters::coord::Shift;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

use super::panel::{FAINT, INK};
use super::ruler::{Axis, Ruler};
use super::{DrawResult, Drawn, PlotError, SCALE, TITLE_HEIGHT, WIDTH, draw_title, text, write};
use machinist_studies::winder_walk::map::{Condition, StabilityMap};

const HEIGHT: u32 = 640;
const LEGEND_HEIGHT: u32 = 30;

/// Draws a stability map, one colour for each condition, into an `.svg` or `.png` file.
///
/// # Errors
/// [`PlotError`]. In that case no file is written, or only part of one.
pub fn plot_map(map: &StabilityMap, path: &Path) -> Result<(), PlotError> {
    if map.cells.is_empty() {
        return Err(PlotError::Nothing);
    }
    write(&Picture { map }, path)
}

struct Picture<'a> {
    map: &'a StabilityMap,
}

/// Returns a colour that readers with a colour vision deficiency can distinguish. Stable is the
/// faintest.
fn color(condition: Condition) -> RGBColor {
    match condition {
        Condition::Stable => RGBColor(214, 232, 244),
        Condition::Contact => RGBColor(176, 52, 62),
        Condition::Adhesion => RGBColor(217, 112, 20),
        Condition::Practice => RGBColor(240, 190, 60),
        Condition::Yarn => RGBColor(110, 80, 150),
    }
}

type Chart<'c, DB> = ChartContext<'c, DB, Cartesian2d<Ruler, Ruler>>;

impl Drawn for Picture<'_> {
    fn size(&self) -> (u32, u32) {
        (WIDTH * SCALE, HEIGHT * SCALE)
    }

    fn draw<DB: DrawingBackend>(&self, area: &DrawingArea<DB, Shift>) -> DrawResult<DB> {
        area.fill(&WHITE)?;
        let (heading, rest) = area.split_vertically(TITLE_HEIGHT * SCALE);
        let limits = &self.map.limits;
        let subtitle = format!(
            "pressure {} N, tension {} N, {} N at most on the yarn, stiffness to {:.0} %",
            limits.pressure,
            limits.tension,
            limits.largest,
            100.0 * limits.spread
        );
        draw_title(&heading, "Where winding is stable", &subtitle)?;
        let (legend, rest) = rest.split_vertically(LEGEND_HEIGHT * SCALE);
        self.draw_legend(&legend)?;
        self.draw_cells(&rest)?;
        area.present()
    }
}

impl Picture<'_> {
    /// Draws the conditions that occur.
    fn draw_legend<DB: DrawingBackend>(&self, area: &DrawingArea<DB, Shift>) -> DrawResult<DB> {
        let style = text(14, INK).pos(Pos::new(HPos::Left, VPos::Center));
        let [side, gap, between] = [14, 7, 24].map(|size| (size * SCALE) as i32);
        let (mut x, y) = ((24 * SCALE) as i32, (12 * SCALE) as i32);
        let occurs = |condition: &Condition| self.map.share(*condition) > 0.0;
        for condition in Condition::ALL.into_iter().filter(occurs) {
            let corners = [(x, y - side / 2), (x + side, y + side / 2)];
            area.draw(&Rectangle::new(corners, color(condition).filled()))?;
            area.draw_text(condition.name(), &style, (x + side + gap, y))?;
            let width = area.estimate_text_size(condition.name(), &style)?.0 as i32;
            x += side + gap + width + between;
        }
        Ok(())
    }

    fn draw_cells<DB: DrawingBackend>(&self, area: &DrawingArea<DB, Shift>) -> DrawResult<DB> {
        let millimetres: Vec<f64> = self.map.radii.iter().map(|radius| 1e3 * radius).collect();
        let (across, up) = (edges(&millimetres), edges(&self.map.speeds));
        let axes = [
            Axis::Linear("radius of the package [mm]".into()),
            Axis::Linear("winding speed [m/s]".into()),
        ];
        let [horizontal, vertical] = [axes[0].along(&across), axes[1].along(&up)];
        let (ticks_across, ticks_up) = (horizontal.ticks(), vertical.ticks());
        let mut chart = ChartBuilder::on(area)
            .margin_top(6 * SCALE)
            .margin_right(28 * SCALE)
            .margin_left(10 * SCALE)
            .set_label_area_size(LabelAreaPosition::Left, 72 * SCALE)
            .set_label_area_size(LabelAreaPosition::Bottom, 52 * SCALE)
            .build_cartesian_2d(horizontal, vertical)?;
        self.fill(&mut chart, &across, &up)?;
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
            .draw()
    }

    /// Fills one rectangle for adjacent cells of one condition.
    fn fill<DB: DrawingBackend>(
        &self,
        chart: &mut Chart<'_, DB>,
        across: &[f64],
        up: &[f64],
    ) -> DrawResult<DB> {
        for (row, cells) in self.map.cells.iter().enumerate() {
            let mut first = 0;
            for same in cells.chunk_by(|a, b| a.condition == b.condition) {
                let next = first + same.len();
                let corners = [(across[first], up[row]), (across[next], up[row + 1])];
                let style = color(same[0].condition).filled();
                chart.draw_series(std::iter::once(Rectangle::new(corners, style)))?;
                first = next;
            }
        }
        Ok(())
    }
}

/// Returns the middles between ascending places, and outer edges at the same distance.
fn edges(places: &[f64]) -> Vec<f64> {
    let middles = places.windows(2).map(|pair| f64::midpoint(pair[0], pair[1]));
    let (Some(first), Some(last)) = (places.first(), places.last()) else { return Vec::new() };
    let half = 0.5 * (last - first) / (places.len().max(2) - 1) as f64;
    let inner: Vec<f64> = middles.collect();
    std::iter::once(first - half).chain(inner).chain([last + half]).collect()
}

#[cfg(test)]
mod tests {
    use super::edges;

    #[test]
    fn cells_reach_half_way_to_their_neighbours() {
        assert_eq!(edges(&[1.0, 2.0, 3.0]), [0.5, 1.5, 2.5, 3.5]);
    }
}

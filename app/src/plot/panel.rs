//! One panel of a plot: the columns of one unit over time, frequency or names.

use std::collections::BTreeSet;

use plotters::chart::ChartContext;
use plotters::coord::Shift;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

use super::ruler::{Axis, Ruler};
use super::{DrawResult, SCALE, TIME_AXIS_HEIGHT, text};
use machinist::trajectory::{Column, ColumnKind};

pub(super) const INK: RGBColor = RGBColor(38, 43, 51);
pub(super) const FAINT: RGBColor = RGBColor(92, 99, 110);
const GRID: RGBColor = RGBColor(229, 232, 236);

/// Colours of lines that readers with a colour vision deficiency can distinguish.
const COLORS: [RGBColor; 6] = [
    RGBColor(31, 98, 171),
    RGBColor(217, 112, 20),
    RGBColor(22, 137, 116),
    RGBColor(150, 72, 148),
    RGBColor(176, 52, 62),
    RGBColor(110, 117, 128),
];

const LEFT: u32 = 92;
const TICK: u32 = 6;
const RIGHT: u32 = 28;
const LEGEND_LINE: u32 = 20;

/// Maximum number of points of a line.
const MAX_POINTS: usize = 2000;

/// Distance of adjacent stems, in steps from name to name.
const STEM_DISTANCE: f64 = 0.2;

/// Columns that share a unit.
pub(super) struct Panel<'a> {
    pub unit: &'a str,
    /// Positions of the values of all columns on the horizontal axis.
    pub places: &'a [f64],
    pub columns: Vec<&'a Column>,
    pub horizontal: &'a Axis,
    pub vertical: &'a Axis,
    /// Labels and circles.
    pub marks: Vec<Mark>,
}

/// Labelled point of a panel.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Mark {
    pub place: f64,
    pub value: f64,
    pub label: String,
    pub is_circled: bool,
}

pub(super) fn over<'a>(
    places: &'a [f64],
    columns: Vec<&'a Column>,
    [horizontal, vertical]: [&'a Axis; 2],
) -> Panel<'a> {
    let unit = columns.first().map_or("", |column| column.unit.as_str());
    Panel { unit, places, columns, horizontal, vertical, marks: Vec::new() }
}

type Chart<'c, DB> = ChartContext<'c, DB, Cartesian2d<Ruler, Ruler>>;

impl Panel<'_> {
    /// Draws the legend above, the lines below, and under the last panel the horizontal axis.
    pub fn draw<DB: DrawingBackend>(
        &self,
        area: &DrawingArea<DB, Shift>,
        is_last: bool,
    ) -> DrawResult<DB> {
        let legend_height = self.draw_legend(area)?;
        let axis_height = if is_last { TIME_AXIS_HEIGHT } else { 14 };
        let (across, up) = self.rulers();
        let (across_ticks, up_ticks) = (across.ticks(), up.ticks());
        let mut chart = ChartBuilder::on(area)
            .margin_top(legend_height)
            .margin_right(RIGHT * SCALE)
            .margin_left(0)
            .set_label_area_size(LabelAreaPosition::Left, LEFT * SCALE)
            .set_label_area_size(LabelAreaPosition::Bottom, axis_height * SCALE)
            .build_cartesian_2d(if is_last { across } else { across.unlabelled() }, up)?;

        let label = text(13, FAINT);
        let description = text(14, INK);
        let mut mesh = chart.configure_mesh();
        mesh.max_light_lines(1)
            .bold_line_style(GRID.stroke_width(SCALE))
            .light_line_style(TRANSPARENT)
            .axis_style(GRID.stroke_width(SCALE))
            .set_all_tick_mark_size(TICK * SCALE)
            .x_labels(across_ticks)
            .y_labels(up_ticks)
            .label_style(label)
            .axis_desc_style(description);
        if is_last {
            mesh.x_desc(self.horizontal.title());
        }
        mesh.draw()?;
        match self.horizontal {
            Axis::Names(_) => self.draw_stems(&mut chart),
            Axis::Linear(_) | Axis::Logarithmic(_) => self.draw_lines(&mut chart),
        }?;
        self.draw_marks(&mut chart)
    }

    /// Draws circles, with labels to the upper left, away from the right edge.
    fn draw_marks<DB: DrawingBackend>(&self, chart: &mut Chart<'_, DB>) -> DrawResult<DB> {
        let style = text(12, INK).pos(Pos::new(HPos::Right, VPos::Bottom));
        let away = (4 * SCALE) as i32;
        for Mark { place, value, label, is_circled } in &self.marks {
            let place = self.horizontal.placed(&[*place])[0];
            let value = self.vertical.placed(&[*value])[0];
            if !(place.is_finite() && value.is_finite()) {
                continue;
            }
            if *is_circled {
                let ring = Circle::new((place, value), 5 * SCALE, INK.stroke_width(SCALE));
                chart.draw_series(std::iter::once(ring))?;
            }
            let words = EmptyElement::at((place, value))
                + Text::new(label.clone(), (-away, -away), style.clone());
            chart.draw_series(std::iter::once(words))?;
        }
        Ok(())
    }

    fn draw_lines<DB: DrawingBackend>(&self, chart: &mut Chart<'_, DB>) -> DrawResult<DB> {
        let places = self.horizontal.placed(self.places);
        for (column, color) in self.columns.iter().zip(COLORS.iter().cycle()) {
            let style = color.stroke_width(SCALE + SCALE / 2);
            if column.kind == ColumnKind::Measured {
                let mut dots =
                    finite_lines(&places, &self.vertical.placed(&column.values)).concat();
                // Dots at one place are drawn once.
                let (mut drawn, radius) = (BTreeSet::new(), 2 * SCALE as i32);
                dots.retain(|point| {
                    let (x, y) = chart.backend_coord(point);
                    drawn.insert((x / radius, y / radius))
                });
                let dot = |point: &(f64, f64)| Circle::new(*point, radius, color.filled());
                chart.draw_series(dots.iter().map(dot))?;
                continue;
            }
            for line in finite_lines(&places, &self.vertical.placed(&column.values)) {
                let pixel = |point: &(f64, f64)| chart.backend_coord(point);
                for piece in cut_at_sharp_turns(&thinned(line), pixel) {
                    chart.draw_series(LineSeries::new(piece, style))?;
                }
            }
        }
        Ok(())
    }

    /// Draws stems from zero to each value, with a dot; columns side by side.
    fn draw_stems<DB: DrawingBackend>(&self, chart: &mut Chart<'_, DB>) -> DrawResult<DB> {
        let middle = (self.columns.len() as f64 - 1.0) / 2.0;
        for (number, column) in self.columns.iter().enumerate() {
            let color = COLORS[number % COLORS.len()];
            let shift = STEM_DISTANCE * (number as f64 - middle);
            let points: Vec<(f64, f64)> =
                self.places.iter().map(|place| place + shift).zip(column.values.clone()).collect();
            let style = color.stroke_width(2 * SCALE);
            let stem = |point: &(f64, f64)| PathElement::new([(point.0, 0.0), *point], style);
            chart.draw_series(points.iter().map(stem))?;
            let dot = |point: &(f64, f64)| Circle::new(*point, 4 * SCALE, color.filled());
            chart.draw_series(points.iter().map(dot))?;
        }
        Ok(())
    }

    /// Draws the unit above the value axis, and beside it coloured dashes with names, in as many
    /// lines as needed. Returns their height.
    fn draw_legend<DB: DrawingBackend>(
        &self,
        area: &DrawingArea<DB, Shift>,
    ) -> Result<u32, DrawingAreaErrorKind<DB::ErrorType>> {
        let (dash, gap, between) = (18 * SCALE as i32, 7 * SCALE as i32, 24 * SCALE as i32);
        let left = (LEFT * SCALE) as i32;
        let right = area.dim_in_pixel().0 as i32 - (RIGHT * SCALE) as i32;
        let style = text(14, INK).pos(Pos::new(HPos::Left, VPos::Center));
        let unit_style = text(14, INK).pos(Pos::new(HPos::Right, VPos::Center));
        let first_line = (LEGEND_LINE / 2 * SCALE) as i32;
        let unit = if self.unit.is_empty() { String::new() } else { format!("[{}]", self.unit) };
        area.draw_text(&unit, &unit_style, (left - (2 * TICK * SCALE) as i32, first_line))?;
        let (mut x, mut line) = (left, 0);
        for (column, color) in self.columns.iter().zip(COLORS.iter().cycle()) {
            let width = dash + gap + area.estimate_text_size(&column.name, &style)?.0 as i32;
            if x > left && x + width > right {
                (x, line) = (left, line + 1);
            }
            let y = ((line * LEGEND_LINE + LEGEND_LINE / 2) * SCALE) as i32;
            let stroke = color.stroke_width(2 * SCALE);
            area.draw(&PathElement::new([(x, y), (x + dash, y)], stroke))?;
            area.draw_text(&column.name, &style, (x + dash + gap, y))?;
            x += width + between;
        }
        Ok(((line + 1) * LEGEND_LINE + 6) * SCALE)
    }

    fn rulers(&self) -> (Ruler, Ruler) {
        let places = self.horizontal.placed(self.places);
        let values = self.columns.iter().flat_map(|column| self.vertical.placed(&column.values));
        (self.horizontal.along(&places), self.vertical.around(values))
    }
}

/// Splits points into lines where a coordinate is NaN or infinite.
fn finite_lines(places: &[f64], values: &[f64]) -> Vec<Vec<(f64, f64)>> {
    let points: Vec<_> = places.iter().copied().zip(values.iter().copied()).collect();
    let lines = points.split(|(place, value)| !(place.is_finite() && value.is_finite()));
    lines.filter(|line| !line.is_empty()).map(<[_]>::to_vec).collect()
}

/// Keeps at most [`MAX_POINTS`] points: the least and greatest of each of equal bins of time, in
/// their order. A line that turns back keeps all.
fn thinned(line: Vec<(f64, f64)>) -> Vec<(f64, f64)> {
    let (Some(first), Some(last)) = (line.first().copied(), line.last().copied()) else {
        return line;
    };
    let is_forward = first.0 < last.0 && line.is_sorted_by(|a, b| a.0 <= b.0);
    if line.len() <= MAX_POINTS || !is_forward {
        return line;
    }
    let bins = MAX_POINTS / 2 - 1;
    let bin = |time: f64| ((time - first.0) / (last.0 - first.0) * bins as f64) as usize;
    let mut thin = vec![first];
    for same in line.chunk_by(|a, b| bin(a.0) == bin(b.0)) {
        let by_value = |a: &&(f64, f64), b: &&(f64, f64)| a.1.total_cmp(&b.1);
        let low = same.iter().min_by(by_value);
        let high = same.iter().max_by(by_value);
        if let (Some(&low), Some(&high)) = (low, high) {
            let ordered = if low.0 <= high.0 { [low, high] } else { [high, low] };
            thin.extend_from_slice(&ordered);
        }
    }
    thin.push(last);
    thin
}

/// Cuts a line at turns sharper than a right angle, for which plotters draws long miters that may
/// leave the panel.
fn cut_at_sharp_turns(
    line: &[(f64, f64)],
    pixel: impl Fn(&(f64, f64)) -> (i32, i32),
) -> Vec<Vec<(f64, f64)>> {
    let mut points: Vec<_> = line.iter().map(|point| (pixel(point), *point)).collect();
    points.dedup_by_key(|(pixel, _)| *pixel);
    let mut pieces = Vec::new();
    let mut piece = Vec::new();
    for (index, (here, point)) in points.iter().enumerate() {
        piece.push(*point);
        let (Some((before, _)), Some((after, _))) =
            (index.checked_sub(1).and_then(|index| points.get(index)), points.get(index + 1))
        else {
            continue;
        };
        let along = |a: (i32, i32), b: (i32, i32)| (i64::from(b.0 - a.0), i64::from(b.1 - a.1));
        let (reached, left) = (along(*before, *here), along(*here, *after));
        if reached.0 * left.0 + reached.1 * left.1 <= 0 {
            pieces.push(std::mem::replace(&mut piece, vec![*point]));
        }
    }
    pieces.push(piece);
    pieces
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn thinning_keeps_ends_and_spikes() {
        let spike = 123_457;
        let line: Vec<_> = (0..1_000_000)
            .map(|i| (f64::from(i), if i == spike { 7.0 } else { (f64::from(i) * 1e-4).sin() }))
            .collect();
        let thin = thinned(line.clone());
        assert!(thin.len() <= MAX_POINTS + 2, "{}", thin.len());
        assert_eq!((thin.first(), thin.last()), (line.first(), line.last()));
        assert!(thin.contains(&(f64::from(spike), 7.0)));
        assert!(thin.windows(2).all(|pair| pair[0].0 <= pair[1].0));
        assert_eq!(thinned(line[..100].to_vec()), line[..100]);
        let circle: Vec<_> = (0..5000).map(|i| f64::from(i).sin_cos()).collect();
        assert_eq!(thinned(circle.clone()), circle);
    }

    #[test]
    fn a_line_is_cut_where_it_is_not_finite() {
        let lines = finite_lines(&[0.0, 1.0, 2.0, 3.0], &[5.0, f64::NAN, f64::INFINITY, 6.0]);
        assert_eq!(lines, [vec![(0.0, 5.0)], vec![(3.0, 6.0)]]);
    }

    #[test]
    fn a_spike_is_drawn_as_two_strokes_and_a_curve_as_one() {
        let pixel = |point: &(f64, f64)| (point.0 as i32, point.1 as i32);
        let spike = [(0.0, 0.0), (1.0, 0.0), (2.0, 90.0), (3.0, 0.0), (3.0, 0.2), (4.0, 0.0)];
        let pieces = cut_at_sharp_turns(&spike, pixel);
        let [up, down] = pieces.as_slice() else { panic!("{pieces:?}") };
        assert_eq!((up.last(), down.first()), (Some(&spike[2]), Some(&spike[2])));
        let curve: Vec<_> = (0..20).map(|i| (f64::from(i), f64::from(i * i))).collect();
        assert_eq!(cut_at_sharp_turns(&curve, pixel), [curve]);
    }
}

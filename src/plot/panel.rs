//! One panel of a plot: the columns of one unit over time.

use std::ops::Range;

use plotters::coord::Shift;
use plotters::coord::ranged1d::{BoldPoints, Ranged};
use plotters::coord::types::RangedCoordf64;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

use super::{DrawResult, SCALE, TIME_AXIS_HEIGHT, text};
use crate::trajectory::Column;

pub(super) const INK: RGBColor = RGBColor(38, 43, 51);
pub(super) const FAINT: RGBColor = RGBColor(92, 99, 110);
const GRID: RGBColor = RGBColor(229, 232, 236);

/// Colours of lines, told apart also by readers with a colour vision deficiency.
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

/// Points drawn of a line at most.
const MAX_POINTS: usize = 2000;

/// Columns that share a unit.
pub(super) struct Panel<'a> {
    pub unit: &'a str,
    pub times: &'a [f64],
    pub columns: Vec<&'a Column>,
}

impl Panel<'_> {
    /// Legend above, lines below, and under the last panel the axis of time.
    pub fn draw<DB: DrawingBackend>(
        &self,
        area: &DrawingArea<DB, Shift>,
        is_last: bool,
    ) -> DrawResult<DB> {
        let legend_height = self.draw_legend(area)?;
        let time_axis = if is_last { TIME_AXIS_HEIGHT } else { 14 };
        let (time, value) = (self.time_range(), self.value_range());
        let mut chart = ChartBuilder::on(area)
            .margin_top(legend_height)
            .margin_right(RIGHT * SCALE)
            .margin_left(0)
            .set_label_area_size(LabelAreaPosition::Left, LEFT * SCALE)
            .set_label_area_size(LabelAreaPosition::Bottom, time_axis * SCALE)
            .build_cartesian_2d(time.clone(), value.clone())?;

        let time_ticks = Ticks::new(&time, 11);
        let value_ticks = Ticks::new(&value, 6);
        let label = text(13, FAINT);
        let description = text(14, INK);
        let mut mesh = chart.configure_mesh();
        mesh.max_light_lines(1)
            .bold_line_style(GRID.stroke_width(SCALE))
            .light_line_style(TRANSPARENT)
            .axis_style(GRID.stroke_width(SCALE))
            .set_all_tick_mark_size(TICK * SCALE)
            .x_labels(11)
            .y_labels(6)
            .label_style(label)
            .axis_desc_style(description);
        let format_time =
            |tick: &f64| if is_last { time_ticks.format(*tick) } else { String::new() };
        let format_value = |tick: &f64| value_ticks.format(*tick);
        mesh.x_label_formatter(&format_time).y_label_formatter(&format_value);
        if is_last {
            mesh.x_desc("time [s]");
        }
        mesh.draw()?;

        for (column, color) in self.columns.iter().zip(COLORS.iter().cycle()) {
            let style = color.stroke_width(SCALE + SCALE / 2);
            for line in finite_lines(self.times, &column.values) {
                let pixel = |point: &(f64, f64)| chart.backend_coord(point);
                for piece in cut_at_sharp_turns(&thinned(line), pixel) {
                    chart.draw_series(LineSeries::new(piece, style))?;
                }
            }
        }
        Ok(())
    }

    /// The unit over the axis of values, and beside it coloured dashes with names,
    /// in as many lines as needed; returns the height that they take.
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
        let unit = format!("[{}]", self.unit);
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

    fn time_range(&self) -> Range<f64> {
        let first = self.times.first().copied().unwrap_or(0.0);
        let last = self.times.last().copied().unwrap_or(1.0);
        if first < last { first..last } else { widened(first..last) }
    }

    /// From the least to the greatest value, and a little more.
    fn value_range(&self) -> Range<f64> {
        let values = self.columns.iter().flat_map(|column| &column.values);
        let extent = |(low, high): (f64, f64), value: &f64| (low.min(*value), high.max(*value));
        let finite = values.filter(|value| value.is_finite());
        let (low, high) = finite.fold((f64::INFINITY, f64::NEG_INFINITY), extent);
        if low <= high { widened(low..high) } else { 0.0..1.0 }
    }
}

fn widened(range: Range<f64>) -> Range<f64> {
    const MARGIN: f64 = 0.06;
    let size = range.start.abs().max(range.end.abs());
    let span = range.end - range.start;
    let margin = if span > 1e-9 * size { MARGIN * span } else { (0.1 * size).max(1e-3) };
    range.start - margin..range.end + margin
}

/// The ticks that plotters chooses, and how to write them all alike.
struct Ticks {
    decimals: usize,
    exponential: bool,
}

impl Ticks {
    fn new(range: &Range<f64>, count: usize) -> Self {
        let axis: RangedCoordf64 = range.clone().into();
        let ticks = axis.key_points(BoldPoints(count));
        let largest = ticks.iter().fold(0.0, |max: f64, tick| max.max(tick.abs()));
        let step = ticks.windows(2).map(|pair| pair[1] - pair[0]).fold(largest, f64::min);
        let exponential = largest >= 1e6 || (largest > 0.0 && largest < 1e-4);
        let unit = if exponential { power_of_ten(largest) } else { 1.0 };
        let is_exact = |decimals: &i32| {
            let scaled = |tick: &f64| tick / unit * 10f64.powi(*decimals);
            let tolerance = 1e-3 * step / unit * 10f64.powi(*decimals);
            ticks.iter().map(scaled).all(|tick| (tick - tick.round()).abs() <= tolerance)
        };
        let decimals = (0..9).find(is_exact).unwrap_or(9) as usize;
        Self { decimals, exponential }
    }

    fn format(&self, tick: f64) -> String {
        let decimals = self.decimals;
        let text = if self.exponential && tick != 0.0 {
            format!("{tick:.decimals$e}")
        } else {
            format!("{tick:.decimals$}")
        };
        let is_zero = text.chars().all(|c| matches!(c, '-' | '0' | '.'));
        if is_zero { "0".to_owned() } else { text.replace('-', "\u{2212}") }
    }
}

fn power_of_ten(value: f64) -> f64 {
    10f64.powf(value.log10().floor())
}

/// The points in order, cut where a value is NaN or infinite.
fn finite_lines(times: &[f64], values: &[f64]) -> Vec<Vec<(f64, f64)>> {
    let points: Vec<_> = times.iter().copied().zip(values.iter().copied()).collect();
    let lines = points.split(|(_, value)| !value.is_finite());
    lines.filter(|line| !line.is_empty()).map(<[_]>::to_vec).collect()
}

/// At most [`MAX_POINTS`] points: of each of equal bins of time the least and
/// the greatest, in the order they come.
fn thinned(line: Vec<(f64, f64)>) -> Vec<(f64, f64)> {
    let (Some(first), Some(last)) = (line.first().copied(), line.last().copied()) else {
        return line;
    };
    if line.len() <= MAX_POINTS {
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

/// The line in pieces that turn by less than a right angle: at sharper turns
/// plotters draws long miters, out of the panel even.
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

    #[test]
    fn ticks_are_written_alike() {
        let texts = |range: Range<f64>, ticks: &[f64]| {
            let format = Ticks::new(&range, 6);
            ticks.iter().map(|tick| format.format(*tick)).collect::<Vec<_>>()
        };
        assert_eq!(texts(-1.0..1.0, &[-0.5, -0.0, 0.5]), ["\u{2212}0.5", "0", "0.5"]);
        assert_eq!(texts(0.0..50.0, &[10.0, 20.0]), ["10", "20"]);
        assert_eq!(texts(0.0..5e7, &[1e7, 2e7]), ["1e7", "2e7"]);
        assert_eq!(texts(0.0..5e-6, &[0.0, 2e-6]), ["0", "2e\u{2212}6"]);
    }

    #[test]
    fn a_constant_gets_a_range_around_it() {
        let range = widened(5.0..5.0);
        assert!(range.start < 5.0 && range.end > 5.0);
        let range = widened(0.0..0.0);
        assert!(range.start < 0.0 && range.end > 0.0);
    }
}

//! Axes: the positions of values and the labels of ticks.

use std::borrow::Cow;
use std::ops::Range;

use plotters::coord::ranged1d::{
    BoldPoints, KeyPointHint, NoDefaultFormatting, Ranged, ValueFormatter,
};
use plotters::coord::types::RangedCoordf64;

/// Number of ticks along the time axis and the value axis.
const TICKS_ACROSS: usize = 11;
const TICKS_UP: usize = 6;
/// Maximum number of names along an axis.
const MAX_NAMES: usize = 12;

/// Kind of an axis.
pub(crate) enum Axis {
    /// Numbers, with a title.
    Linear(Cow<'static, str>),
    /// Positive numbers by their decimal logarithm, with a title; others are left out.
    Logarithmic(Cow<'static, str>),
    /// Names, at 0, 1, 2, ...
    Names(Vec<String>),
}

impl Axis {
    /// Title of the axis.
    pub fn title(&self) -> &str {
        match self {
            Self::Linear(title) | Self::Logarithmic(title) => title,
            Self::Names(_) => "",
        }
    }

    /// Returns the positions of numbers along the axis; NaN for those without one.
    pub fn placed(&self, values: &[f64]) -> Vec<f64> {
        match self {
            Self::Logarithmic(_) => values.iter().map(|value| value.log10()).collect(),
            Self::Linear(_) | Self::Names(_) => values.to_vec(),
        }
    }

    /// Creates a ruler from the least to the greatest place.
    pub fn along(&self, places: &[f64]) -> Ruler {
        if let Self::Names(names) = self {
            return Ruler::of_names(names);
        }
        let finite = || places.iter().copied().filter(|place| place.is_finite());
        let first = finite().reduce(f64::min).unwrap_or(0.0);
        let last = finite().reduce(f64::max).unwrap_or(1.0);
        let range = if first < last { first..last } else { widened(first..last) };
        self.ruler(range, TICKS_ACROSS)
    }

    /// Creates a ruler from the least to the greatest place, with a margin.
    pub fn around(&self, places: impl Iterator<Item = f64>) -> Ruler {
        let extent = |(low, high): (f64, f64), place: f64| (low.min(place), high.max(place));
        let finite = places.filter(|place| place.is_finite());
        let (low, high) = finite.fold((f64::INFINITY, f64::NEG_INFINITY), extent);
        self.ruler(if low <= high { widened(low..high) } else { 0.0..1.0 }, TICKS_UP)
    }

    fn ruler(&self, range: Range<f64>, count: usize) -> Ruler {
        match self {
            Self::Logarithmic(_) => Ruler::of_powers(range, count),
            Self::Linear(_) | Self::Names(_) => Ruler::of_numbers(range, count),
        }
    }
}

/// Range with labelled ticks.
pub(crate) struct Ruler {
    range: Range<f64>,
    labels: Vec<(f64, String)>,
}

/// Functions that the report draws with.
#[cfg(feature = "derive")]
impl Ruler {
    /// Returns the first and last place.
    pub fn ends(&self) -> Range<f64> {
        self.range.clone()
    }

    /// Returns the fraction of the range at a place.
    pub fn share(&self, place: f64) -> f64 {
        (place - self.range.start) / (self.range.end - self.range.start)
    }

    /// Returns the labels with their fractions of the range.
    pub fn marks(&self) -> impl Iterator<Item = (f64, &str)> {
        self.labels.iter().map(|(place, label)| (self.share(*place), label.as_str()))
    }
}

impl Ruler {
    /// Removes the labels.
    pub fn unlabelled(mut self) -> Self {
        self.labels.iter_mut().for_each(|(_, label)| label.clear());
        self
    }

    /// Number of ticks.
    pub fn ticks(&self) -> usize {
        self.labels.len()
    }

    /// Chooses the ticks of plotters, with labels of one format.
    fn of_numbers(range: Range<f64>, count: usize) -> Self {
        let axis: RangedCoordf64 = range.clone().into();
        let format = Ticks::new(&range, count);
        let ticks = axis.key_points(BoldPoints(count));
        let labels = ticks.into_iter().map(|tick| (tick, format.format(tick))).collect();
        Self { range, labels }
    }

    /// Chooses at most `count` ticks: 1, 2 and 5 times powers of ten, only powers, or only some
    /// powers. A range too short for these gets plain numbers.
    fn of_powers(range: Range<f64>, count: usize) -> Self {
        let within = |digits: &[u32], every: i32| -> Vec<(f64, String)> {
            let powers = range.start.floor() as i32..=range.end.ceil() as i32;
            let powers = powers.filter(|power| power.rem_euclid(every) == 0);
            let ticks = powers.flat_map(|power| digits.iter().map(move |digit| (*digit, power)));
            let placed = ticks.map(|(digit, power)| {
                (f64::from(digit).log10() + f64::from(power), power_label(digit, power))
            });
            placed.filter(|(place, _)| range.start <= *place && *place <= range.end).collect()
        };
        let few = |ticks: &Vec<(f64, String)>| ticks.len() <= count;
        let chosen = Some(within(&[1, 2, 5], 1))
            .filter(few)
            .or_else(|| (1..=700).map(|every| within(&[1], every)).find(few))
            .unwrap_or_default();
        if chosen.len() >= 2 {
            return Self { range, labels: chosen };
        }
        if range.end - range.start < 1.0 {
            // Within a factor of ten, evenly spaced numbers are rounder than evenly spaced powers.
            let values = 10f64.powf(range.start)..10f64.powf(range.end);
            let ticks = Self::of_numbers(values, count).labels.into_iter();
            let placed = ticks.map(|(value, label)| (value.log10(), label));
            let labels: Vec<_> = placed.filter(|(place, _)| range.contains(place)).collect();
            if labels.len() >= 2 {
                return Self { range, labels };
            }
        }
        let mut ruler = Self::of_numbers(range, count);
        for (place, label) in &mut ruler.labels {
            *label = format!("{:.3e}", 10f64.powf(*place)).replace('-', "\u{2212}");
        }
        ruler
    }

    fn of_names(names: &[String]) -> Self {
        let every = names.len().div_ceil(MAX_NAMES).max(1);
        let labels = names.iter().enumerate().step_by(every);
        let labels = labels.map(|(place, name)| (place as f64, name.clone())).collect();
        Self { range: -0.5..names.len() as f64 - 0.5, labels }
    }
}

impl Ranged for Ruler {
    type FormatOption = NoDefaultFormatting;
    type ValueType = f64;

    fn map(&self, value: &f64, (first, last): (i32, i32)) -> i32 {
        let axis: RangedCoordf64 = self.range.clone().into();
        axis.map(value, (first, last))
    }

    fn key_points<Hint: KeyPointHint>(&self, _hint: Hint) -> Vec<f64> {
        self.labels.iter().map(|(place, _)| *place).collect()
    }

    fn range(&self) -> Range<f64> {
        self.range.clone()
    }
}

impl ValueFormatter<f64> for Ruler {
    fn format_ext(&self, tick: &f64) -> String {
        let label = self.labels.iter().find(|(place, _)| place.to_bits() == tick.to_bits());
        label.map(|(_, label)| label.clone()).unwrap_or_default()
    }
}

/// Formats `0.02`, `5`, `1000`, `2e-6` with a true minus sign.
fn power_label(digit: u32, power: i32) -> String {
    let value = f64::from(digit) * 10f64.powi(power);
    match power {
        -3..0 => format!("{value:.*}", power.unsigned_abs() as usize),
        0..4 => format!("{value:.0}"),
        _ => format!("{digit}e{power}").replace('-', "\u{2212}"),
    }
}

fn widened(range: Range<f64>) -> Range<f64> {
    const MARGIN: f64 = 0.06;
    let size = range.start.abs().max(range.end.abs());
    let span = range.end - range.start;
    let margin = if span > 1e-9 * size { MARGIN * span } else { (0.1 * size).max(1e-3) };
    range.start - margin..range.end + margin
}

/// Format of the labels of the ticks that plotters chooses.
struct Ticks {
    decimals: usize,
    exponential: bool,
    /// Size below which a tick is zero with rounding.
    zero: f64,
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
        Self { decimals, exponential, zero: 1e-9 * step }
    }

    fn format(&self, tick: f64) -> String {
        let decimals = self.decimals;
        let text = if self.exponential && tick.abs() > self.zero {
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn logarithmic_ticks_are_round_numbers_within_the_range() {
        let labels = |range: Range<f64>, count: usize| {
            let ruler = Ruler::of_powers(range, count);
            assert!(ruler.ticks() <= count);
            ruler.labels.into_iter().map(|(_, label)| label).collect::<Vec<_>>()
        };
        assert_eq!(labels(-1.0..1.0, 11), ["0.1", "0.2", "0.5", "1", "2", "5", "10"]);
        assert_eq!(labels(0.0..5.0, 6), ["1", "10", "100", "1000", "1e4", "1e5"]);
        assert_eq!(labels(-9.5..-2.0, 5), ["1e\u{2212}8", "1e\u{2212}6", "1e\u{2212}4", "0.01"]);
        assert!(labels(2.01..2.02, 6).len() >= 2);
        let plain = labels(2.95..3.25, 6);
        assert!(plain.len() >= 2 && plain.contains(&"1000".to_owned()), "{plain:?}");
        assert!(labels(-300.0..300.0, 6).len() >= 2);
    }

    #[test]
    fn names_are_thinned_when_there_are_many() {
        let names: Vec<String> = (0..100).map(|index| format!("q{index}")).collect();
        assert!(Ruler::of_names(&names).ticks() <= MAX_NAMES);
        assert_eq!(Ruler::of_names(&names[..3]).format_ext(&2.0), "q2");
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
        assert_eq!(texts(-5e-6..5e-6, &[-4e-22, 2e-6]), ["0", "2e\u{2212}6"]);
    }

    #[test]
    fn a_constant_gets_a_range_around_it() {
        let range = widened(5.0..5.0);
        assert!(range.start < 5.0 && range.end > 5.0);
        let range = widened(0.0..0.0);
        assert!(range.start < 0.0 && range.end > 0.0);
    }
}

//! Series with many sums, compared with the steps of a pair while it runs.

use machinist_contract::taylor::TaylorSeries;

use super::super::taylor::TaylorSteps;
use super::Stretch;

/// Number of steps of a pair before the first comparison, which costs about two of them. Each next
/// comparison waits twice as long.
const FIRST: usize = 24;

/// Square of the order at which a step by series with many sums costs as much as one of `dop853`.
///
/// The sums of an order p take p^2 products for each product of a rate, of which a step of `dop853`
/// evaluates twelve. Measured cost over p^2: 1/110 (Pleiades, order 17), 1/140 to 1/90 (chains of 5 and
/// 10 pendulums, orders 13 to 23), 1/150 (an induction machine in stationary axes).
const EQUAL_COST: f64 = 100.0;

/// Taylor's method beside the pair that runs.
pub(super) struct Rival<'a> {
    stretch: &'a Stretch<'a>,
    series: &'a dyn TaylorSeries<f64>,
    /// Time from which on the steps of the pair are counted \[s\].
    since: f64,
    steps: usize,
    due: usize,
}

impl<'a> Rival<'a> {
    pub(super) fn new(stretch: &'a Stretch<'a>, series: &'a dyn TaylorSeries<f64>) -> Self {
        Self { stretch, series, since: stretch.from, steps: 0, due: FIRST }
    }

    /// Takes a step of the pair to a time and a state. Returns how many of its mean steps one step by
    /// series would replace there, if that is worth its cost. The first half of the steps does not
    /// count, because steps grow at the beginning.
    pub(super) fn gains(&mut self, (time, state): (f64, &[f64])) -> Option<f64> {
        self.steps += 1;
        if 2 * self.steps == self.due {
            self.since = time;
        }
        if self.steps < self.due {
            return None;
        }
        let mean = (time - self.since) / (self.due - self.due / 2) as f64;
        let stretch = Stretch { from: time, ..*self.stretch };
        let [length, order] = TaylorSteps::step_from(&stretch, self.series, state)?;
        (self.since, self.due) = (time, 2 * self.due);
        let gain = length / mean;
        (gain > order * order / EQUAL_COST).then_some(gain)
    }
}

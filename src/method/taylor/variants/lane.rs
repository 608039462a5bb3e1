//! A variant, and what it is at in its lane.

use super::super::step::{Tolerance, order_for};
use crate::error::StopCause;
use crate::method::stretch::within;
use crate::method::{Stopped, Work};

/// Looks at the steps of one variant, which Taylor's method alone would take differently.
pub(crate) trait Overseer {
    /// A stretch begins from a state, with coefficients that are finite up to an order; whether the variant
    /// stays.
    fn begin(&mut self, span: (f64, f64), state: &[f64], order: usize) -> bool;
    /// Whether the variant stays after a step of this length to a time and a state.
    fn stays(&mut self, time: f64, state: &[f64], step: f64) -> bool;
}

/// A variant of a machine, to be run.
pub(crate) struct Variant<'a> {
    /// Who looks at its steps, if somebody does; a variant that does not stay is interrupted.
    pub(crate) overseer: Option<Box<dyn Overseer + 'a>>,
    pub(crate) parameters: Vec<f64>,
    pub(crate) initial: Vec<f64>,
    /// Start, jumps in order, end \[s\].
    pub(crate) ends: Vec<f64>,
    /// Times at which the state is wanted, sorted \[s\].
    pub(crate) times: Vec<f64>,
    pub(crate) atol: Vec<f64>,
    pub(crate) rtol: f64,
    pub(crate) max_steps: usize,
}

/// States at the wanted times, one row after another.
pub(crate) struct Outcome {
    pub(crate) rows: Vec<f64>,
    pub(crate) work: Work,
}

/// A variant on its way.
pub(super) struct Lane<'a> {
    pub(super) number: usize,
    pub(super) variant: Variant<'a>,
    pub(super) tolerance: Tolerance,
    /// Which stretch between ends it is on.
    pub(super) stretch: usize,
    pub(super) time: f64,
    pub(super) step: f64,
    /// Order up to which the coefficients at `time` are finite.
    pub(super) order: usize,
    pub(super) longest: f64,
    pub(super) trial: Trial,
    pub(super) rows: Vec<f64>,
    pub(super) taken: usize,
    pub(super) work: Work,
    pub(super) stopped: Option<Stopped>,
}

/// What the coefficients being computed are those of.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Trial {
    /// The start of a stretch.
    Start,
    /// The end of a step.
    Step {
        now: f64,
    },
    /// Nothing more was asked for.
    Accepted,
    Rejected,
}

impl<'a> Lane<'a> {
    pub(super) fn new(number: usize, variant: Variant<'a>) -> Self {
        let order = order_for(variant.rtol);
        Self {
            number,
            tolerance: Tolerance::new(variant.rtol, &variant.atol, order),
            stretch: 0,
            time: variant.ends[0],
            step: 0.0,
            order,
            longest: 0.0,
            trial: Trial::Start,
            rows: Vec::with_capacity(variant.times.len() * variant.initial.len()),
            taken: 0,
            work: Work::default(),
            stopped: None,
            variant,
        }
    }

    pub(super) fn from(&self) -> f64 {
        self.variant.ends[self.stretch]
    }

    pub(super) fn until(&self) -> f64 {
        self.variant.ends[self.stretch + 1]
    }

    /// Moved into the stretch.
    pub(super) fn within(&self, time: f64) -> f64 {
        within(time, (self.from(), self.until()))
    }

    pub(super) fn next_sample_until(&self, time: f64) -> Option<f64> {
        self.variant.times.get(self.taken).copied().filter(|next| *next <= time)
    }

    pub(super) fn stop(&mut self, cause: StopCause) {
        self.stopped = Some(Stopped { time: self.time, cause });
    }
}

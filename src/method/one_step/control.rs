//! Step size control.

use super::{End, OneStep, ResumePoint, Stopped, Stretch, is_too_small};
use crate::method::tolerance::REFINEMENT;

/// Step size control: after error e of step h and error e' of the previous one, the next step is
/// `safety` h e^-exponent e'^memory, within limits (a PI controller; Hairer, Norsett, Wanner,
/// sections II.4 and IV.2).
#[derive(Debug, Clone, Copy)]
pub(crate) struct Pace {
    pub(in crate::method) exponent: f64,
    pub(in crate::method) memory: f64,
    pub(in crate::method) safety: f64,
    pub(in crate::method) smallest: f64,
    pub(in crate::method) largest: f64,
    /// A step that would grow by less than this factor stays, and so do the factors of its matrix;
    /// 1 if there are none to keep.
    pub(in crate::method) hold: f64,
}

impl Pace {
    /// Returns the error by which to choose the next step, from the error of a step and, before it,
    /// a step and its error.
    ///
    /// An error estimate is a number that changes its sign. It passes through zero now and then
    /// where the error does not: in a fast oscillation as often as once in a few hundred steps. A
    /// step that grew because of this would be far too long, and might be accepted by the same
    /// chance. So an error far below the prediction of the previous step is not believed at once.
    pub(in crate::method) fn believed(
        &self,
        error: f64,
        step: f64,
        before: Option<(f64, f64)>,
    ) -> f64 {
        const LUCK: f64 = 1e-2;
        let foretold = |(step_before, error): (f64, f64)| {
            error * (step / step_before).powf(1.0 / self.exponent)
        };
        before.map_or(error, |before| error.max(LUCK * foretold(before)))
    }

    pub(in crate::method) fn factor(&self, error: f64, last_error: f64) -> f64 {
        let wanted = self.safety * error.powf(-self.exponent) * last_error.powf(self.memory);
        // An error of zero asks for an infinite step; a NaN cannot occur.
        let factor = wanted.min(self.largest).max(self.smallest);
        if (1.0..=self.hold).contains(&factor) { 1.0 } else { factor }
    }
}

/// Step size control of a run by steps.
pub(super) struct Control {
    /// Start of the next step.
    pub(super) time: f64,
    /// Its length.
    pub(super) step: f64,
    /// Error of the last step.
    last_error: f64,
    /// Length and error of the last step, if there was one.
    before: Option<(f64, f64)>,
    /// Number of steps rejected from this start.
    refusals: u32,
    /// Longest of the last steps.
    pub(super) longest: f64,
    /// True if the next step is the first of a segment and was not shortened to an event within it.
    may_be_shortened: bool,
}

impl Control {
    pub(super) fn from(ResumePoint { time, step }: ResumePoint) -> Self {
        Self {
            time,
            step,
            last_error: 1e-4,
            before: None,
            refusals: 0,
            longest: 0.0,
            may_be_shortened: true,
        }
    }

    /// Begins again at a time.
    pub(super) fn begin(&mut self, time: f64, step: f64) {
        *self = Self { last_error: self.last_error, ..Self::from(ResumePoint { time, step }) };
    }

    /// Shortens the first step of a segment as much as error control would at a tolerance
    /// [`REFINEMENT`] times as tight, if the run is to take other steps than one without this.
    pub(super) fn shorten(&self, stretch: &Stretch<'_>, pace: Pace, end: End<f64>) -> End<f64> {
        let time = self.time;
        let now = time + REFINEMENT.powf(-pace.exponent) * end.tried;
        if !stretch.shortens || self.before.is_some() || is_too_small(now - time, time) {
            return end;
        }
        End { now, tried: now - time, arrives: 0.0 }
    }

    /// Returns whether the first step of a segment, which has met an event, must be repeated with
    /// a shorter one before it.
    pub(super) fn shortens_to(&mut self, stretch: &Stretch<'_>, event: f64) -> bool {
        let step = event - self.time;
        let is_first = stretch.shortens && self.before.is_none() && self.may_be_shortened;
        if !is_first || is_too_small(step, self.time) {
            return false;
        }
        (self.step, self.may_be_shortened) = (step, false);
        true
    }

    /// Accepts a step that was tried; the next one is as long as its error allows.
    pub(super) fn accept(
        &mut self,
        method: &mut dyn OneStep,
        pace: Pace,
        now: f64,
        (tried, error): (f64, f64),
    ) {
        let factor = pace.factor(pace.believed(error, tried, self.before), self.last_error);
        let factor = if self.refusals > 0 { factor.min(1.0) } else { factor };
        self.step = method.own_step().unwrap_or(tried * factor);
        self.last_error = error.max(1e-4);
        self.before = Some((tried, error));
        self.longest = tried.max(0.5 * self.longest);
        (self.time, self.refusals) = (now, 0);
    }

    /// Returns whether steps from this start fail again and again.
    pub(super) fn is_refused(&self) -> bool {
        /// Number of rejected steps in a row.
        const REFUSALS: u32 = 2;
        self.refusals >= REFUSALS
    }

    /// Rejects a step; the next one from this start is `step` long.
    pub(super) fn reject(&mut self, stretch: &Stretch<'_>, step: f64) -> Result<(), Stopped> {
        stretch.count_rejected(self.time)?;
        self.refusals += 1;
        self.step = step;
        Ok(())
    }
}

//! Supervision of the steps of lanes, with access to rate and Jacobian.

use machinist_contract::SideBySide;

use super::lane::Variant;
use crate::lanes::Lanes;

/// Supervisor of the steps of all lanes, some of which Taylor's method alone would take
/// differently. Lanes are represented by bits.
pub(crate) trait Overseer<R> {
    /// Returns for each variant whether it does not even begin.
    fn leaving(&mut self, variants: &[Variant]) -> Vec<bool>;
    /// Returns the lanes whose variants leave at the start of a segment, given their numbers of
    /// finite coefficients. Lanes in `at_start` are at the start of a variant, for which
    /// [`Overseer::leaving`] was called.
    fn begin(&mut self, lanes: u32, at_start: u32, terms: R, at: &Moment<'_, R>) -> u32;
    /// Returns the lanes whose variants leave after an accepted step of this length. Accepted lanes
    /// are given by bits and by 1 or 0; the latter may include lanes at the end of a segment.
    fn look(&mut self, passed: (u32, R), step: R, at: &Moment<'_, R>) -> u32;
}

/// Current times and states of all lanes.
#[cfg_attr(not(feature = "implicit"), expect(dead_code, reason = "only `auto` looks at it"))]
pub(crate) struct Moment<'a, R> {
    pub(crate) equations: &'a Equations<'a, R>,
    /// Time, moved into the segment.
    pub(crate) time: R,
    /// Rest of the segment.
    pub(crate) left: R,
    pub(crate) state: &'a [R],
}

/// Rate and Jacobian, with parameters for each lane.
pub(crate) struct Equations<'a, R> {
    machine: &'a dyn SideBySide<R>,
    pub(super) parameters: Vec<R>,
    constants: Vec<R>,
}

impl<'a, R: Lanes> Equations<'a, R> {
    pub(crate) fn new(machine: &'a dyn SideBySide<R>) -> Self {
        let zeros = |count: usize| vec![R::literal(0.0); count];
        let parameters = zeros(machine.shape().parameters);
        Self { machine, parameters, constants: zeros(machine.constants()) }
    }

    /// Copies parameters into a lane; must be followed by [`Equations::prepare`].
    pub(crate) fn load(&mut self, index: usize, parameters: &[f64]) {
        for (into, value) in self.parameters.iter_mut().zip(parameters) {
            into.set_lane(index, *value);
        }
    }

    /// Computes the constants of the parameters.
    pub(crate) fn prepare(&mut self) {
        self.machine.prepare(&self.parameters, &mut self.constants);
    }

    pub(crate) fn rate(&self, time: R, state: &[R], rate: &mut [R]) {
        self.machine.prepared_rate(time, state, &self.parameters, &self.constants, rate);
    }

    pub(crate) fn saturating_arguments(&self, time: R, state: &[R], arguments: &mut [R]) {
        self.machine.saturating_arguments(time, state, &self.parameters, arguments);
    }

    #[cfg(feature = "implicit")]
    pub(crate) fn jacobian(&self, time: R, state: &[R], values: &mut [R]) {
        self.machine.prepared_rate_jacobian(time, state, &self.parameters, &self.constants, values);
    }
}

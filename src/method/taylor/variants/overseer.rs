//! Who looks at the steps of lanes, and what there is to be asked beside the series.

use machinist_contract::SideBySide;

use super::lane::Variant;
use crate::lanes::Lanes;

/// Looks at the steps of all lanes, some of which Taylor's method alone would take differently. Lanes
/// are told by bits.
pub(crate) trait Overseer<R> {
    /// Of every variant whether it does not even begin.
    fn leaving(&mut self, variants: &[Variant]) -> Vec<bool>;
    /// Lanes begin a stretch, each with so many coefficients that are finite; those whose variant does
    /// not stay. Some of them are at the start of a variant, of which [`Overseer::leaving`] has told.
    fn begin(&mut self, lanes: u32, at_start: u32, terms: R, at: &Moment<'_, R>) -> u32;
    /// Those whose variant does not stay after a step of this length that has passed, told by bits
    /// and by 1 or 0; lanes at the end of a stretch may be among the latter.
    fn look(&mut self, passed: (u32, R), step: R, at: &Moment<'_, R>) -> u32;
}

/// Where all lanes are.
#[cfg_attr(not(feature = "implicit"), expect(dead_code, reason = "only `auto` looks at it"))]
pub(crate) struct Moment<'a, R> {
    pub(crate) equations: &'a Equations<'a, R>,
    /// Moved into the stretch.
    pub(crate) time: R,
    /// What is left of the stretch.
    pub(crate) left: R,
    pub(crate) state: &'a [R],
}

/// Rate and Jacobian, each lane with parameters of its own.
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

    /// Puts parameters into a lane; [`Equations::prepare`] comes after it.
    pub(crate) fn load(&mut self, index: usize, parameters: &[f64]) {
        for (into, value) in self.parameters.iter_mut().zip(parameters) {
            into.set_lane(index, *value);
        }
    }

    /// Computes what parameters decide.
    pub(crate) fn prepare(&mut self) {
        self.machine.prepare(&self.parameters, &mut self.constants);
    }

    pub(crate) fn rate(&self, time: R, state: &[R], rate: &mut [R]) {
        self.machine.prepared_rate(time, state, &self.parameters, &self.constants, rate);
    }

    #[cfg(feature = "implicit")]
    pub(crate) fn jacobian(&self, time: R, state: &[R], values: &mut [R]) {
        self.machine.prepared_rate_jacobian(time, state, &self.parameters, &self.constants, values);
    }
}

//! What `auto` asks of the steps of Taylor's method, where variants take them side by side.
//!
//! A variant goes on in its lane for as long as a run of its own would go on by Taylor's
//! method, with the same bits; one that would change the method is sent away.

use machinist_contract::Simulator;

use super::stiffness::{Evidence, STIFF_STEPS, Strain, is_worth_beginning};
use super::{suitable_series, taylor_limit};
use crate::method::Method;
use crate::method::stretch::within;
use crate::method::taylor::step::order_for;
use crate::method::taylor::{FEW, variants::Overseer};

/// The relative tolerance of the steps, if `auto` runs a machine by Taylor's method alone until
/// something turns out to be stiff.
pub(crate) fn rtol_of_lanes(simulator: &dyn Simulator<f64>, rtol: f64) -> Option<f64> {
    let rtol = Method::Auto.step_rtol(rtol);
    let is_plain = simulator.events() == 0
        && simulator.kinks() == 0
        && simulator.constraints() == 0
        && simulator.linear().is_none();
    (is_plain && suitable_series(simulator, rtol).0.is_some()).then_some(rtol)
}

/// Looks at the steps of one variant.
pub(crate) struct InLane<'a> {
    simulator: &'a dyn Simulator<f64>,
    parameters: Vec<f64>,
    constants: Vec<f64>,
    /// Where the stretch begins and ends.
    span: (f64, f64),
    limit: f64,
    strain: Strain<'a>,
    evidence: Evidence,
}

impl<'a> InLane<'a> {
    pub(crate) fn new(simulator: &'a dyn Simulator<f64>, parameters: &[f64], rtol: f64) -> Self {
        let mut constants = vec![0.0; simulator.constants()];
        simulator.prepare(parameters, &mut constants);
        let limit = taylor_limit(order_for(rtol));
        Self {
            simulator,
            parameters: parameters.to_vec(),
            constants,
            span: (0.0, 0.0),
            limit,
            strain: Strain::new(simulator, limit),
            evidence: Evidence::of(STIFF_STEPS),
        }
    }
}

impl Overseer for InLane<'_> {
    fn begin(&mut self, span: (f64, f64), state: &[f64], order: usize) -> bool {
        let Self { simulator, parameters, constants, limit, .. } = self;
        let held = is_worth_beginning(*simulator, (span.1 - span.0) / *limit, |values| {
            simulator.prepared_rate_jacobian(
                within(span.0, span),
                state,
                parameters,
                constants,
                values,
            );
        });
        if held.is_some() {
            return false;
        }
        self.span = span;
        self.strain = Strain::new(self.simulator, self.limit);
        self.evidence = Evidence::of(STIFF_STEPS);
        order >= FEW
    }

    fn stays(&mut self, time: f64, state: &[f64], step: f64) -> bool {
        let Self { simulator, parameters, constants, span, strain, evidence, limit, .. } = self;
        let left = span.1 - time;
        let at = within(time, *span);
        let jacobian = |values: &mut [f64]| {
            simulator.prepared_rate_jacobian(at, state, parameters, constants, values);
        };
        let strain = strain.look(left, step, jacobian);
        !strain.is_some_and(|strain| evidence.grows(strain > *limit))
    }
}

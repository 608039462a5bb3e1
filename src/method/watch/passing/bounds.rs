//! Values of guards, and bounds of their derivatives, of methods that know them in closed form.

use super::{Parts, Step, Zero};
use crate::constraints::Constraints;
use crate::method::watch::polynomial::{Enclosure, NODES};

impl Parts {
    /// Returns a guard within the step, if the method knows it without the state.
    pub(super) fn known(&self, step: &mut Step<'_, '_>, time: f64, index: usize) -> Option<f64> {
        let watched = self.watched[index];
        let of = watched.bounded(step.system.simulator().events())?;
        // Guards see states projected onto constraints that prescribe a motion.
        if step.system.constraints().is_some_and(Constraints::may_lead) {
            return None;
        }
        Some(watched.of_bounded(step.method.value(of, time)?, step.system))
    }

    /// Returns a bound of a derivative of a guard over a span of the step, if the method knows one.
    ///
    /// If the guard was zero, it is one of q = (g - r)/(t - t0): at the start of the step the mean of
    /// u^n g^(n + 1) over u from 0 to 1, later by Leibniz's rule n! times the sum of
    /// g^(k)/k! (t - t0)^(k - n - 1).
    pub(super) fn bound(
        &self,
        step: &mut Step<'_, '_>,
        (index, zero): (usize, Option<Zero>),
        order: usize,
        [low, high]: [f64; 2],
    ) -> Option<f64> {
        let of = self.watched[index].bounded(step.system.simulator().events())?;
        let Some(zero) = zero else { return step.method.bound(of, order, high) };
        if zero.time >= self.start.time {
            return Some(step.method.bound(of, order + 1, high)? / (order + 1) as f64);
        }
        let since = low - zero.time;
        let (mut sum, mut factorial) = (0.0, 1.0);
        for k in 0..=order {
            factorial *= k.max(1) as f64;
            let residual = if k == 0 { zero.residual.abs() } else { 0.0 };
            let bound = step.method.bound(of, k, high)? + residual;
            sum += bound / factorial / since.powi((order - k + 1) as i32);
        }
        Some(factorial * sum)
    }

    /// Returns the polynomial through samples of a deflated guard over a span.
    pub(super) fn enclosure(
        &self,
        step: &mut Step<'_, '_>,
        (index, zero): (usize, Option<Zero>),
        (samples, noise): (&[f64; NODES], f64),
        [low, high]: [f64; 2],
    ) -> Enclosure {
        let bound = self.bound(step, (index, zero), NODES, [low, high]);
        Enclosure::of(samples, noise, bound.map(|bound| Enclosure::beyond(bound, high - low)))
    }
}

//! Steps that end where functions bend that were flat at their start.

use super::OneStep;
use crate::method::Stretch;
use crate::method::saturating::{Motion, Saturating};

/// Places within steps at which functions bend.
pub(super) struct Bends {
    saturating: Saturating<f64>,
    end: Vec<f64>,
    /// Start of the last step with such a place.
    met: Option<f64>,
}

impl Bends {
    /// Returns `None` if the machine has no such functions, or the method sees where they bend.
    pub(super) fn new(method: &dyn OneStep, stretch: &Stretch<'_>) -> Option<Self> {
        let (count, states) = (stretch.system.simulator().saturations(), stretch.system.len());
        let saturating = Saturating::new(count, states).filter(|_| !method.sees_bends())?;
        Some(Self { saturating, end: Vec::new(), met: None })
    }

    /// Returns the time of the first place within a step from a state. A step that ends there shows
    /// the bend to the method, so only the first step from a start is asked for.
    pub(super) fn first<M: OneStep>(
        &mut self,
        method: &mut M,
        stretch: &Stretch<'_>,
        start: &[f64],
        [time, now]: [f64; 2],
    ) -> Option<f64> {
        if self.met == Some(time) {
            return None;
        }
        self.end.clear();
        self.end.extend_from_slice(method.end());
        let mut along = Along { method, stretch, time };
        let mut first = None::<f64>;
        let ends = (start, now - time, &self.end[..]);
        self.saturating.places(
            &mut along,
            ends,
            |place| place > 0.0,
            |_, after, _| {
                first = Some(first.map_or(time + after, |first| first.min(time + after)));
            },
        );
        let first = first.filter(|place| time < *place && *place < now);
        self.met = first.map_or(self.met, |_| Some(time));
        first
    }
}

/// The motion over the current step.
struct Along<'a, M> {
    method: &'a mut M,
    stretch: &'a Stretch<'a>,
    time: f64,
}

impl<M: OneStep> Motion<f64> for Along<'_, M> {
    // Cubics through the ends of steps of order eight, over half a period, are off by a tenth.
    const OFF: f64 = 0.25;
    const SEES: f64 = 0.0;

    fn states<const N: usize>(&mut self, times: [f64; N], states: &mut [[f64; N]]) {
        let mut state = vec![0.0; states.len()];
        for (index, time) in times.into_iter().enumerate() {
            self.method.sketch(self.time + time, &mut state);
            for (states, value) in states.iter_mut().zip(&state) {
                states[index] = *value;
            }
        }
    }

    fn arguments(&self, time: f64, state: &[f64], arguments: &mut [f64]) {
        let state = &state[..self.stretch.system.states()];
        self.stretch.saturating_arguments(self.time + time, state, arguments);
    }
}

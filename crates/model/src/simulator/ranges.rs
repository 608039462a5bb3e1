//! Ranges of guards, interpreted on intervals.

use machinist_contract::{Interval, Ranges};

use super::ModelSimulator;
use crate::functions::FunctionId;

impl Ranges for ModelSimulator {
    fn guard_ranges(
        &self,
        time: Interval,
        state: &[Interval],
        parameters: &[Interval],
        ranges: &mut [Interval],
    ) {
        let (events, kinks) = ranges.split_at_mut(self.model.events.len());
        self.with_slots(parameters, |parameters| {
            let inputs = self.inputs_of((time, state), parameters);
            for (function, ranges) in
                [(FunctionId::Guards, events), (FunctionId::KinkGuards, kinks)]
            {
                if self.motion.is_read_by(function) {
                    // Solutions for accelerations are unbounded as soon as pivots are.
                    ranges.fill(Interval::WHOLE);
                } else if !ranges.is_empty() {
                    let ready = &self.functions[function as usize];
                    ready.run_on(self.model.tape(function), &inputs, ranges);
                }
            }
        });
    }
}

//! Functions of a model on dual numbers, interpreted.

use machinist_contract::implicit::LANES;
use machinist_contract::{Dual, Energy, PowerBalance, Real, Simulator};

use super::{ModelSimulator, Runs};
use crate::evaluate::Inputs;
use crate::functions::FunctionId;

const ZERO: Dual = Dual::constant(0.0);

impl ModelSimulator {
    /// Returns the inputs of tapes on another type of numbers.
    pub(super) fn inputs_of<'a, R: Real>(
        &'a self,
        (time, state): (R, &'a [R]),
        parameters: &'a [R],
    ) -> Inputs<'a, R> {
        let own = self.model.parameters.len();
        let handed = &parameters[own..own + self.model.handed.len()];
        let tables = &self.model.tables;
        Inputs { time, state, parameters, handed, constants: &[], motion: &[], tables }
    }
}

impl Runs<Dual> for ModelSimulator {
    fn run(
        &self,
        function: FunctionId,
        motion: Option<(&Dual, &[Dual])>,
        p: &[Dual],
        results: &mut [Dual],
    ) {
        self.with_slots(p, |p| self.run_with_slots(function, motion, p, results));
    }
}

impl ModelSimulator {
    fn run_with_slots(
        &self,
        function: FunctionId,
        motion: Option<(&Dual, &[Dual])>,
        p: &[Dual],
        results: &mut [Dual],
    ) {
        let (time, state) = motion.map_or((ZERO, &[][..]), |(time, state)| (*time, state));
        let inputs = self.inputs_of((time, state), p);
        let own = |inputs: &Inputs<'_, Dual>, results: &mut [Dual]| {
            let ready = &self.functions[function as usize];
            ready.run_on(self.model.tape(function), inputs, results);
        };
        let before = self.model.motion.as_ref().filter(|_| self.motion.is_read_by(function));
        let Some(before) = before else { return own(&inputs, results) };
        let mut known = vec![ZERO; before.tape.results.len()];
        self.motion.run_on(&before.tape, &inputs, &mut known);
        let inputs = Inputs { motion: &known, ..inputs };
        let Some(solve) = self.model.solve(function) else { return own(&inputs, results) };
        let mut own_results = vec![ZERO; solve.inputs()];
        own(&inputs, &mut own_results);
        let factors: Vec<Dual> =
            before.factors.iter().map(|place| known[*place as usize]).collect();
        let mut work = vec![[ZERO; LANES]; solve.rows as usize];
        solve.write(&factors, &own_results, &mut work, results);
    }
}

impl Simulator<Dual> for ModelSimulator {
    machinist_contract::for_each_function! { [functions] Dual }
}

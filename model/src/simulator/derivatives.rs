//! Functions of a model on dual numbers, interpreted.

use std::sync::OnceLock;

use machinist_contract::implicit::LANES;
use machinist_contract::{Derivatives, Dual, DualFunction};

use super::ModelSimulator;
use crate::evaluate::{Evaluator, Inputs};
use crate::functions::{COUNT, FunctionId};

/// Tapes that are ready to be run on dual numbers: that of the motion, then one for each row
/// of the table of functions.
#[derive(Debug)]
pub(super) struct OnDuals {
    motion: OnceLock<Evaluator>,
    functions: [OnceLock<Evaluator>; COUNT],
}

impl Default for OnDuals {
    fn default() -> Self {
        Self { motion: OnceLock::new(), functions: [const { OnceLock::new() }; COUNT] }
    }
}

fn function_of(function: DualFunction) -> FunctionId {
    match function {
        DualFunction::InitialState => FunctionId::InitialState,
        DualFunction::Discontinuities => FunctionId::Discontinuities,
        DualFunction::Outputs => FunctionId::Outputs,
        DualFunction::Guards => FunctionId::Guards,
        DualFunction::Resets => FunctionId::Resets,
        DualFunction::KinkGuards => FunctionId::KinkGuards,
        DualFunction::ConstraintValues => FunctionId::ConstraintValues,
        DualFunction::ConstraintRates => FunctionId::ConstraintRates,
        DualFunction::ConstraintMatrix => FunctionId::ConstraintMatrix,
        DualFunction::MassMatrix => FunctionId::MassMatrix,
    }
}

impl Derivatives for ModelSimulator {
    fn on_duals(
        &self,
        function: DualFunction,
        time: Dual,
        state: &[Dual],
        parameters: &[Dual],
        values: &mut [Dual],
    ) {
        let function = function_of(function);
        let (parameters, handed) = parameters.split_at(self.model.parameters.len());
        let tables = &self.model.tables;
        let inputs =
            Inputs { time, state, parameters, handed, constants: &[], motion: &[], tables };
        let own = self.duals.functions[function as usize]
            .get_or_init(|| Evaluator::new(self.model.tape(function)));
        let of_motion = self.model.motion.as_ref().filter(|_| self.motion.is_read_by(function));
        let mut motion = Vec::new();
        if let Some(tape) = of_motion.map(|motion| &motion.tape) {
            let before = self.duals.motion.get_or_init(|| Evaluator::new(tape));
            motion.resize(before.results(), Dual::constant(0.0));
            let mut room = vec![Dual::constant(0.0); before.room()];
            before.evaluate_in(&mut room, &inputs, &mut motion);
        }
        let mut room = vec![Dual::constant(0.0); own.room()];
        let inputs = Inputs { motion: &motion, ..inputs };
        let (Some(solve), Some(before)) = (self.model.solve(function), &self.model.motion) else {
            own.evaluate_in(&mut room, &inputs, values);
            return;
        };
        let mut results = vec![Dual::constant(0.0); solve.inputs()];
        own.evaluate_in(&mut room, &inputs, &mut results);
        let factors: Vec<Dual> =
            before.factors.iter().map(|place| motion[*place as usize]).collect();
        let mut work = vec![[Dual::constant(0.0); LANES]; solve.rows as usize];
        solve.write(&factors, &results, &mut work, values);
    }
}

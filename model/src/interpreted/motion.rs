//! The motion's tape, run before the functions that read it.

use machinist_contract::implicit::LANES;

use crate::evaluate::{Evaluator, Inputs};
use crate::hoist::Hoisted;
use crate::{Model, Solve};

/// The tape with room for what it gives and for what is solved with it.
#[derive(Debug)]
pub(super) struct Motion {
    tape: Evaluator,
    /// By constants of the parameters.
    prepared: Evaluator,
    results: Vec<f64>,
    /// Which results are factors.
    places: Vec<u32>,
    factors: Vec<f64>,
    /// What a matrix is solved from.
    inputs: Vec<f64>,
    work: Vec<[f64; LANES]>,
}

impl Motion {
    /// None of a model whose functions stand by themselves.
    pub(super) fn new(model: &Model, hoisted: &Hoisted) -> Option<Self> {
        let motion = model.motion.as_ref()?;
        let matrices = [&model.rate_jacobian, &model.parameter_jacobian];
        let solves = || matrices.into_iter().filter_map(|matrix| matrix.solve.as_ref());
        let rows = solves().map(|solve| solve.rows as usize).max().unwrap_or(0);
        let inputs = solves().map(Solve::inputs).max().unwrap_or(0);
        Some(Self {
            tape: Evaluator::new(&motion.tape),
            prepared: Evaluator::new(&hoisted.motion),
            results: vec![0.0; motion.tape.results.len()],
            places: motion.factors.clone(),
            factors: vec![0.0; motion.factors.len()],
            inputs: vec![0.0; inputs],
            work: vec![[0.0; LANES]; rows],
        })
    }

    /// A function's tape behind the motion's, and what is solved from its results.
    pub(super) fn run(
        &mut self,
        tape: &mut Evaluator,
        solve: Option<&Solve>,
        inputs: &Inputs<'_>,
        values: &mut [f64],
    ) {
        let motion = if inputs.constants.is_empty() { &mut self.tape } else { &mut self.prepared };
        motion.evaluate(inputs, &mut self.results);
        let inputs = Inputs { motion: &self.results, ..*inputs };
        let Some(solve) = solve else {
            tape.evaluate(&inputs, values);
            return;
        };
        for (factor, result) in self.factors.iter_mut().zip(&self.places) {
            *factor = self.results[*result as usize];
        }
        let right_sides = &mut self.inputs[..solve.inputs()];
        tape.evaluate(&inputs, right_sides);
        solve.write(&self.factors, right_sides, &mut self.work, values);
    }
}

//! Sensitivities over a step that has been solved: linear equations for their stages.
//!
//! ```text
//! Z_i - h sum_j a_ij J_j Z_j = h sum_j a_ij (J_j S + p_j),   S_i = S + Z_i
//! ```
//!
//! J_j and p_j = df/dp being those of the states of the stages, so that S is the derivative of
//! what the step computes. One factorization of all stages at once serves every direction; a
//! stiff machine has few states or is refused.

use nalgebra::{DMatrix, Dyn, LU};

use super::RadauSteps;
use super::collocation::Collocation;
use crate::method::sensitivity::Tangents;

/// Stages of sensitivities.
#[derive(Default)]
pub(super) struct Carried {
    /// Z, stage after stage.
    stages: Vec<f64>,
    /// Divided differences of the polynomial through them.
    differences: Vec<f64>,
}

impl RadauSteps<'_> {
    /// Carries sensitivities over the current step; the error as that of the states.
    pub(super) fn carry_over(
        &mut self,
        tangents: &Tangents<'_>,
        start: &[f64],
        end: &mut [f64],
    ) -> f64 {
        let method = &self.methods[self.current];
        let (count, size, len) = (method.stages(), self.size, start.len());
        let directions = len / size;
        let mut system = DMatrix::<f64>::identity(count * size, count * size);
        let mut right_side = DMatrix::<f64>::zeros(count * size, directions);
        let mut rate = vec![0.0; len];
        for (stage, node) in method.coefficients.nodes.iter().enumerate() {
            let z = &self.stages[stage * self.len..][..size];
            for ((state, start), z) in self.scratch.iter_mut().zip(&self.start).zip(z) {
                *state = start + z;
            }
            let time = self.time + node * self.step;
            tangents.rate(self.stretch, time, &self.scratch[..size], start, &mut rate);
            for row in 0..count {
                let weight = self.step * method.integrals[row * count + stage];
                tangents.for_each_slope(|on, by, value| {
                    system[(row * size + on, stage * size + by)] -= weight * value;
                });
                for (place, rate) in rate.iter().enumerate() {
                    let (on, direction) = (place / directions, place % directions);
                    right_side[(row * size + on, direction)] += weight * rate;
                }
            }
        }
        let Some(stages) = solved(&system.lu(), right_side) else { return f64::NAN };
        self.carried.stages.clear();
        for row in stages.row_iter() {
            self.carried.stages.extend(row.iter());
        }
        for ((end, start), z) in
            end.iter_mut().zip(start).zip(&self.carried.stages[(count - 1) * len..])
        {
            *end = start + z;
        }
        if tangents.is_controlled() { self.error_of(tangents, start, end) } else { 0.0 }
    }

    /// (gamma/h I - J)^-1 (S' - u'(0)), as of the states.
    fn error_of(&mut self, tangents: &Tangents<'_>, start: &[f64], end: &[f64]) -> f64 {
        let method = &self.methods[self.current];
        let (size, len) = (self.size, start.len());
        let directions = len / size;
        let mut errors = vec![0.0; len];
        tangents.rate(self.stretch, self.time, &self.start[..size], start, &mut errors);
        for (place, error) in errors.iter_mut().enumerate() {
            let stages = self.carried.stages[place..].iter().step_by(len);
            let slope: f64 = method.slope.iter().zip(stages).map(|(weight, z)| weight * z).sum();
            *error -= slope / self.step;
        }
        let mut column = vec![0.0; size];
        for direction in 0..directions {
            for (value, row) in column.iter_mut().zip(errors.chunks_exact(directions)) {
                *value = row[direction];
            }
            self.newton.solve_real(&mut column);
            for (value, row) in column.iter().zip(errors.chunks_exact_mut(directions)) {
                row[direction] = *value;
            }
        }
        tangents.error(self.stretch, &errors, (start, end))
    }

    /// Sensitivities within the current step.
    pub(super) fn carried_at(&mut self, time: f64, start: &[f64], into: &mut [f64]) {
        let method: &Collocation = &self.methods[self.current];
        let Carried { stages, differences } = &mut self.carried;
        differences.resize(start.len() * (method.stages() + 1), 0.0);
        method.differences(start, stages, differences);
        method.evaluate(differences, (time - self.time) / self.step, into);
    }
}

fn solved(factors: &LU<f64, Dyn, Dyn>, mut right_side: DMatrix<f64>) -> Option<DMatrix<f64>> {
    factors.solve_mut(&mut right_side).then_some(right_side)
}

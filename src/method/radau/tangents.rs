//! Sensitivities over a solved step: linear equations for their stages.
//!
//! ```text
//! 1/h sum_j (A^-1)_ij Z_j - J_i Z_i = J_i S + p_i,   S_i = S + Z_i
//! ```
//!
//! J_i and p_i = df/dp belong to the states of the stages, so that S is the derivative of the
//! computed step. One factorization of all stages serves every direction; a stiff machine has few
//! states or is refused. The stages of a state are neighbouring unknowns, so zeros of J remain
//! zeros in most of the elimination.

use super::RadauSteps;
use super::collocation::Collocation;
use crate::method::lu::Lu;
use crate::method::sensitivity::Tangents;

/// Stages of sensitivities.
#[derive(Default)]
pub(super) struct Carried {
    /// Z, stage by stage.
    stages: Vec<f64>,
    /// The same, with the stages of a state next to each other.
    solved: Vec<f64>,
    rate: Vec<f64>,
    column: Vec<f64>,
    /// Matrix of all stages, with their number.
    matrix: Option<(usize, Lu<f64>)>,
    /// Divided differences of the polynomial through the stages.
    differences: Vec<f64>,
}

impl RadauSteps<'_> {
    /// Carries sensitivities over the current step; returns their error, defined as that of the
    /// states.
    pub(super) fn carry_over(
        &mut self,
        tangents: &Tangents<'_>,
        start: &[f64],
        end: &mut [f64],
    ) -> f64 {
        let method = &self.methods[self.current];
        let (count, size, len) = (method.stages(), self.size, start.len());
        let directions = len / size;
        let Carried { stages, solved, rate, matrix, .. } = &mut self.carried;
        if matrix.as_ref().is_none_or(|(stages, _)| *stages != count) {
            *matrix = Some((count, Lu::new(count * size)));
        }
        let Some((_, matrix)) = matrix else { return f64::NAN };
        matrix.clear();
        stages.resize(count * len, 0.0);
        solved.resize(count * len, 0.0);
        rate.resize(len, 0.0);
        for (stage, node) in method.coefficients.nodes.iter().enumerate() {
            let z = &self.stages[stage * self.len..][..size];
            for ((state, start), z) in self.scratch.iter_mut().zip(&self.start).zip(z) {
                *state = start + z;
            }
            let time = self.time + node * self.step;
            tangents.rate(self.stretch, time, &self.scratch[..size], start, rate);
            for (other, slope) in method.slopes[stage * count..][..count].iter().enumerate() {
                for state in 0..size {
                    let row = state * count;
                    matrix.add(row + stage, row + other, slope / self.step);
                }
            }
            tangents.for_each_slope(|on, by, value| {
                matrix.add(on * count + stage, by * count + stage, -value);
            });
            for (state, rate) in rate.chunks_exact(directions).enumerate() {
                let row = state * count + stage;
                solved[row * directions..][..directions].copy_from_slice(rate);
            }
        }
        if matrix.factor_large().is_err() {
            return f64::NAN;
        }
        matrix.solve_each(solved, directions);
        for (row, z) in solved.chunks_exact(directions).enumerate() {
            let (state, stage) = (row / count, row % count);
            stages[stage * len + state * directions..][..directions].copy_from_slice(z);
        }
        for ((end, start), z) in end.iter_mut().zip(start).zip(&stages[(count - 1) * len..]) {
            *end = start + z;
        }
        if tangents.is_controlled() { self.error_of(tangents, start, end) } else { 0.0 }
    }

    /// Returns the norm of (gamma/h I - J)^-1 (S' - u'(0)), as for states.
    fn error_of(&mut self, tangents: &Tangents<'_>, start: &[f64], end: &[f64]) -> f64 {
        let method = &self.methods[self.current];
        let (size, len) = (self.size, start.len());
        let directions = len / size;
        let looser = self.looser();
        let Carried { stages, rate: errors, column, .. } = &mut self.carried;
        tangents.rate(self.stretch, self.time, &self.start[..size], start, errors);
        for (place, error) in errors.iter_mut().enumerate() {
            let stages = stages[place..].iter().step_by(len);
            let slope: f64 = method.slope.iter().zip(stages).map(|(weight, z)| weight * z).sum();
            *error -= slope / self.step;
        }
        column.resize(size, 0.0);
        for direction in 0..directions {
            for (value, row) in column.iter_mut().zip(errors.chunks_exact(directions)) {
                *value = row[direction];
            }
            self.newton.solve_real(column);
            for (value, row) in column.iter().zip(errors.chunks_exact_mut(directions)) {
                row[direction] = *value;
            }
        }
        tangents.errors(self.stretch, (start, end), |norm| norm(errors)) / looser
    }

    /// Computes sensitivities within the current step.
    pub(super) fn carried_at(&mut self, time: f64, start: &[f64], into: &mut [f64]) {
        let method: &Collocation = &self.methods[self.current];
        let Carried { stages, differences, .. } = &mut self.carried;
        differences.resize(start.len() * (method.stages() + 1), 0.0);
        method.differences(start, stages, differences);
        method.evaluate(differences, (time - self.time) / self.step, into);
    }
}

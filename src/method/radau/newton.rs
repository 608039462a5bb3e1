//! Newton's iteration for the stages of a Radau method, in variables in which they are decoupled.

use machinist_contract::Real;
use num_complex::Complex64;

use super::collocation::Collocation;
use crate::method::Stretch;
use crate::method::one_step::{Trial, finite_jacobian, require_finite, sum_of_squares};
use crate::method::onset::Onset;
use crate::method::step_matrix::StepMatrix;

/// Maximum change by a first iteration, in units of the scale, for which the contraction of the
/// previous step is trusted. A linear machine contracts at once from any guess. Where it becomes
/// nonlinear, the first iteration still ends at the linear solution.
const NEAR: f64 = 10.0;

/// Result of an iteration.
#[derive(Debug, Clone, Copy)]
pub(super) enum Outcome {
    Converged,
    /// The iteration diverges or is too slow; `shrink` is the recommended factor for the step.
    Failed {
        shrink: f64,
    },
}

/// The simplified Newton iteration: one Jacobian and one factorization as long as it converges
/// well.
pub(super) struct Newton<'a> {
    stretch: &'a Stretch<'a>,
    size: usize,
    jacobian: Vec<f64>,
    jacobian_state: JacobianState,
    onset: Onset<'a>,
    real: StepMatrix<'a, f64>,
    pairs: Vec<StepMatrix<'a, Complex64>>,
    /// Step and number of stages of the factorization; a step of zero means none.
    factored: (f64, usize),
    /// Stages in transformed variables, one after another.
    transformed: Vec<f64>,
    rates: Vec<f64>,
    residual: Vec<f64>,
    complex: Vec<Complex64>,
    state: Vec<f64>,
    /// Convergence limit, in units of the scale.
    tolerance: f64,
    iterations: usize,
    least: usize,
    limit: usize,
    /// Rate of contraction, and remaining error after an iteration.
    contraction: f64,
    remainder: f64,
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum JacobianState {
    Unknown,
    Old,
    Current,
}

impl<'a> Newton<'a> {
    pub(super) fn new(stretch: &'a Stretch<'a>, most_stages: usize) -> Self {
        let system = stretch.system;
        let size = system.states();
        let zeros = || vec![0.0; size * most_stages];
        Self {
            stretch,
            size,
            jacobian: vec![0.0; system.jacobian_pattern().entries.len()],
            jacobian_state: JacobianState::Unknown,
            onset: Onset::new(stretch),
            real: StepMatrix::new(system),
            pairs: (0..most_stages / 2).map(|_| StepMatrix::new(system)).collect(),
            factored: (0.0, 0),
            transformed: zeros(),
            rates: zeros(),
            residual: zeros(),
            complex: vec![Complex64::default(); size],
            state: vec![0.0; size],
            tolerance: 1e-3,
            iterations: 0,
            least: 1,
            limit: 7,
            contraction: 0.0,
            remainder: 1.0,
        }
    }

    /// Sets the convergence limit for a relative tolerance of the error.
    pub(super) fn set_tolerance(&mut self, rtol: f64) {
        self.tolerance = (10.0 * f64::EPSILON / rtol).max(rtol.sqrt()).min(0.03);
    }

    /// Sets the convergence limit, in units of the scale.
    pub(super) fn demand(&mut self, tolerance: f64) {
        self.tolerance = tolerance;
    }

    /// Resets everything for another run.
    pub(super) fn forget(&mut self) {
        self.jacobian_state = JacobianState::Unknown;
        self.onset.forget();
        self.expect_nothing();
    }

    /// Resets the convergence data: the next iteration has no guess, so its first iteration only
    /// uses the rate at the start.
    pub(super) fn expect_nothing(&mut self) {
        self.remainder = 1.0;
        self.least = 2;
    }

    /// Marks the Jacobian as old after an accepted step. It is kept only if it converged well.
    pub(super) fn start_anew(&mut self) {
        self.jacobian_state = if self.is_reusable() {
            JacobianState::Old
        } else if self.onset.hand_over(&mut self.jacobian) {
            self.factored = (0.0, 0);
            JacobianState::Current
        } else {
            JacobianState::Unknown
        };
    }

    /// Refuses a step at whose end an instability has set in; see [`Onset::refuse`].
    pub(super) fn refuse_onset(
        &mut self,
        method: &Collocation,
        (now, step): (f64, f64),
        end: &[f64],
    ) -> Result<(), Trial> {
        let shift = method.coefficients.real / step;
        self.onset.refuse(self.stretch, (now, &end[..self.size]), (shift, &self.jacobian))
    }

    /// Returns whether the Jacobian and the factors are worth keeping for the next step.
    pub(super) fn is_reusable(&self) -> bool {
        self.contraction < 1e-3
    }

    /// Returns a factor for the next step, from the number of iterations needed.
    pub(super) fn ease(&self) -> f64 {
        let limit = self.limit as f64;
        ((1.0 + 2.0 * limit) / (self.iterations as f64 + 2.0 * limit)).min(1.0)
    }

    /// Returns the last Jacobian evaluated, in pattern order.
    pub(super) fn jacobian(&self) -> &[f64] {
        &self.jacobian
    }

    /// Returns the estimated contraction of one iteration.
    pub(super) fn contraction(&self) -> f64 {
        self.contraction
    }

    /// Evaluates the Jacobian at the start of a step if there is none.
    pub(super) fn linearize(&mut self, time: f64, state: &[f64]) -> Result<(), Trial> {
        if self.jacobian_state != JacobianState::Unknown {
            return Ok(());
        }
        finite_jacobian(self.stretch, time, state, &mut self.jacobian)?;
        self.jacobian_state = JacobianState::Current;
        self.factored = (0.0, 0);
        Ok(())
    }

    /// Replaces an old Jacobian by a new one; returns false if it is new already.
    pub(super) fn renew(&mut self, time: f64, state: &[f64]) -> Result<bool, Trial> {
        if self.jacobian_state == JacobianState::Current {
            return Ok(false);
        }
        self.jacobian_state = JacobianState::Unknown;
        self.linearize(time, state)?;
        Ok(true)
    }

    /// Solves with the real matrix of the last factorization.
    pub(super) fn solve_real(&mut self, r: &mut [f64]) {
        self.real.solve(r);
    }

    /// Solves for the stages, relative to the start, from the guess they contain.
    pub(super) fn solve(
        &mut self,
        method: &Collocation,
        (time, step): (f64, f64),
        start: &[f64],
        scale: &[f64],
        stages: &mut [f64],
    ) -> Result<Outcome, Trial> {
        let len = start.len();
        if !self.factor(method, step) {
            return Ok(Outcome::Failed { shrink: 0.5 });
        }
        let count = method.stages();
        self.limit = 7 + (count - 3) * 5 / 2;
        self.transform(method, len, stages);
        self.remainder = self.remainder.max(f64::EPSILON).powf(0.8);
        let carried = self.remainder;
        let mut before = 0.0;
        let mut ratio_before = 0.0;
        self.iterations = 0;
        while self.iterations < self.limit {
            self.iterations += 1;
            self.stretch.system.count(|work| work.newton_iterations += 1);
            self.evaluate(method, (time, step), start, stages)?;
            let change = self.improve(method, step, scale);
            self.transform_back(method, len, stages);
            if !change.is_finite() {
                return Ok(Outcome::Failed { shrink: 0.5 });
            }
            if self.iterations > 1 {
                let ratio: f64 = change / before;
                self.contraction =
                    if self.iterations == 2 { ratio } else { (ratio * ratio_before).sqrt() };
                ratio_before = ratio;
                if self.contraction >= 0.99 {
                    return Ok(Outcome::Failed { shrink: 0.5 });
                }
                self.remainder = self.contraction / (1.0 - self.contraction);
                let left = (self.limit - self.iterations) as i32;
                let expected =
                    self.remainder * change * self.contraction.powi(left - 1) / self.tolerance;
                if left > 0 && expected >= 1.0 {
                    let exponent = -1.0 / (4.0 + f64::from(left));
                    let shrink = 0.8 * expected.clamp(1e-4, 20.0).powf(exponent);
                    return Ok(Outcome::Failed { shrink: shrink.min(0.8) });
                }
            }
            let is_near = if self.iterations > 1 { before } else { change } <= NEAR;
            before = change.max(f64::EPSILON * self.tolerance);
            // The contraction of a large first change does not apply near the solution.
            let remainder = match self.iterations {
                _ if is_near => self.remainder,
                1 => 1.0,
                _ => self.remainder.max(carried),
            };
            if remainder * change <= self.tolerance && self.iterations >= self.least {
                self.least = 1;
                if self.iterations == 1 {
                    self.contraction = 0.0;
                }
                return Ok(Outcome::Converged);
            }
        }
        Ok(Outcome::Failed { shrink: 0.5 })
    }

    /// Factors the matrices for a step, unless those of the last one apply. Returns false if a
    /// matrix is singular, or the step is too long for growing motions.
    fn factor(&mut self, method: &Collocation, step: f64) -> bool {
        // Steps may differ by rounding from the requested one.
        let is_same = (step / self.factored.0 - 1.0).abs() < 1e-9;
        if is_same && self.factored.1 == method.stages() {
            return true;
        }
        self.factored = (0.0, 0);
        let coefficients = method.coefficients;
        self.stretch.system.count(|work| work.factorizations += 1);
        let mut outcome = self.real.factor(coefficients.real / step, &self.jacobian);
        if outcome.is_ok() && self.real.is_outgrown() {
            return false;
        }
        for (&(a, b), matrix) in coefficients.pairs.iter().zip(&mut self.pairs) {
            let shift = Complex64::new(a / step, b / step);
            outcome = outcome.and(matrix.factor(shift, &self.jacobian));
        }
        if outcome.is_ok() {
            self.factored = (step, method.stages());
        }
        outcome.is_ok()
    }

    /// Computes W = T^-1 Z.
    fn transform(&mut self, method: &Collocation, len: usize, stages: &[f64]) {
        let matrix = method.coefficients.inverse;
        product(
            matrix,
            method.stages(),
            self.size,
            (stages, len),
            (&mut self.transformed, self.size),
        );
    }

    /// Computes Z = T W.
    fn transform_back(&self, method: &Collocation, len: usize, stages: &mut [f64]) {
        let matrix = method.coefficients.transform;
        product(matrix, method.stages(), self.size, (&self.transformed, self.size), (stages, len));
    }

    /// Evaluates f at all stages, and the residual T^-1 f.
    fn evaluate(
        &mut self,
        method: &Collocation,
        (time, step): (f64, f64),
        start: &[f64],
        stages: &[f64],
    ) -> Result<(), Trial> {
        let len = start.len();
        for (stage, node) in method.coefficients.nodes.iter().enumerate() {
            for ((state, start), z) in self.state.iter_mut().zip(start).zip(&stages[stage * len..])
            {
                *state = start + z;
            }
            let rate = &mut self.rates[stage * self.size..][..self.size];
            self.stretch.state_rate(time + node * step, &self.state, rate);
            require_finite("the rate of", rate)?;
        }
        let matrix = method.coefficients.inverse;
        product(
            matrix,
            method.stages(),
            self.size,
            (&self.rates, self.size),
            (&mut self.residual, self.size),
        );
        Ok(())
    }

    /// Makes one iteration on W; returns the norm of its change, over stages and states.
    fn improve(&mut self, method: &Collocation, step: f64, scale: &[f64]) -> f64 {
        let size = self.size;
        let coefficients = method.coefficients;
        let real = coefficients.real / step;
        let (first, mut rest) = self.residual.split_at_mut(size);
        for (residual, w) in first.iter_mut().zip(&self.transformed) {
            *residual -= real * w;
        }
        self.real.solve(first);
        for (pair, (&(a, b), matrix)) in coefficients.pairs.iter().zip(&mut self.pairs).enumerate()
        {
            let shift = Complex64::new(a / step, b / step);
            let (two, others) = rest.split_at_mut(2 * size);
            rest = others;
            let (upper, lower) = two.split_at_mut(size);
            let w = &self.transformed[(1 + 2 * pair) * size..];
            for (index, complex) in self.complex.iter_mut().enumerate() {
                let w = Complex64::new(w[index], w[size + index]);
                *complex = Complex64::new(upper[index], lower[index]) - shift * w;
            }
            matrix.solve(&mut self.complex);
            for ((upper, lower), complex) in upper.iter_mut().zip(lower).zip(&self.complex) {
                (*upper, *lower) = (complex.re, complex.im);
            }
        }
        let count = method.stages() * size;
        let mut sum = 0.0;
        let transformed = self.transformed[..count].chunks_exact_mut(size);
        for (transformed, changes) in transformed.zip(self.residual.chunks_exact(size)) {
            for (w, change) in transformed.iter_mut().zip(changes) {
                *w += change;
            }
            sum += sum_of_squares(changes, scale);
        }
        (sum / count as f64).sqrt()
    }
}

/// Computes rows of `into` = matrix times rows of `from`, each of `size` entries and with the given
/// strides.
fn product(
    matrix: &[f64],
    count: usize,
    size: usize,
    (from, from_stride): (&[f64], usize),
    (into, into_stride): (&mut [f64], usize),
) {
    for (row, weights) in matrix.chunks_exact(count).enumerate() {
        let (blocks, rest) = into[row * into_stride..][..size].as_chunks_mut();
        let done = size - rest.len();
        for (block, first) in blocks.iter_mut().zip((0..).step_by(BLOCK)) {
            *block = sum::<BLOCK>(weights, &from[first..], from_stride);
        }
        for (value, first) in rest.iter_mut().zip(done..) {
            [*value] = sum(weights, &from[first..], from_stride);
        }
    }
}

/// Number of entries summed together, so that sums stay in registers.
const BLOCK: usize = 8;

/// Returns the weighted sums of the first `N` entries of rows with this stride.
fn sum<const N: usize>(weights: &[f64], from: &[f64], stride: usize) -> [f64; N] {
    let mut sums = [0.0; N];
    for (weight, row) in weights.iter().zip(from.chunks(stride)) {
        for (sum, value) in sums.iter_mut().zip(&row[..N]) {
            *sum = Real::mul_add(*value, *weight, *sum);
        }
    }
    sums
}

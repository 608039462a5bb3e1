//! Rosenbrock methods: implicit methods without iteration, in which each stage solves one linear
//! system with the emitted Jacobian.

use super::lanes::{Sum, combine, padded, sum};
use super::one_step::{
    BETWEEN, OneStep, Pace, Trial, drive_all, finite_jacobian, first_step, require_finite,
    weighted_norm,
};
use super::onset::Onset;
use super::quadrature::{Flows, NODES, Quadrature};
use super::step_matrix::StepMatrix;
use super::tableau::{RODAS5P, Rosenbrock};
use super::{Integrator, Samples, Sealed, Stopped, Stretch};

/// The method [`RODAS5P`].
pub(super) struct Rodas5p;

impl Sealed for Rodas5p {}

impl Integrator for Rodas5p {
    fn integrate(
        &self,
        stretch: &Stretch<'_>,
        state: &mut [f64],
        samples: &mut Samples<'_>,
    ) -> Result<(), Stopped> {
        drive_all(&mut RosenbrockSteps::new(&RODAS5P, stretch), stretch, state, samples)
    }
}

/// Steps of a Rosenbrock method. The energy quadratures have no feedback, so they are computed over
/// each step once its states are known.
pub(super) struct RosenbrockSteps<'a> {
    method: &'static Rosenbrock,
    stretch: &'a Stretch<'a>,
    /// Number of states, without quadratures.
    size: usize,
    width: usize,
    time: f64,
    step: f64,
    /// State at the start and the end of the step, with quadratures last.
    start: Vec<f64>,
    end: Vec<f64>,
    quadrature: Option<Quadrature>,
    /// f, f_t and J at the start of the step.
    rate: Vec<f64>,
    time_derivative: Vec<f64>,
    jacobian: Vec<f64>,
    is_linearized: bool,
    onset: Onset<'a>,
    matrix: StepMatrix<'a, f64>,
    factored_step: f64,
    argument: Vec<f64>,
    slope: Vec<f64>,
    /// U_i, one after another.
    stages: Vec<f64>,
    error: Vec<f64>,
    state_sums: Vec<Sum>,
    stage_sums: Vec<Sum>,
    /// D_1, D_2, D_3 of the dense output.
    dense: Vec<f64>,
    has_dense: bool,
}

impl<'a> RosenbrockSteps<'a> {
    pub(super) fn new(method: &'static Rosenbrock, stretch: &'a Stretch<'a>) -> Self {
        let (size, len) = (stretch.system.states(), stretch.system.len());
        let width = padded(size);
        let zeros = || vec![0.0; width];
        let everything = || vec![0.0; width.max(len)];
        Self {
            method,
            stretch,
            size,
            width,
            time: stretch.from,
            step: 0.0,
            start: everything(),
            end: everything(),
            quadrature: (len > size).then(Quadrature::default),
            rate: zeros(),
            time_derivative: zeros(),
            jacobian: vec![0.0; stretch.system.jacobian_pattern().entries.len()],
            is_linearized: false,
            onset: Onset::new(stretch),
            matrix: StepMatrix::new(stretch.system),
            factored_step: 0.0,
            argument: zeros(),
            slope: zeros(),
            stages: vec![0.0; width * method.stages.len()],
            error: everything(),
            state_sums: method.states.iter().map(|row| sum(row, width)).collect(),
            stage_sums: method.stages.iter().map(|row| sum(row, width)).collect(),
            dense: vec![0.0; 3 * width],
            has_dense: false,
        }
    }

    /// Returns J at the start of the last step, in pattern order.
    pub(super) fn jacobian(&self) -> &[f64] {
        &self.jacobian
    }

    /// Evaluates f, f_t and J at the start, once per step even if it is repeated.
    fn linearize(&mut self) -> Result<(), Trial> {
        if self.is_linearized {
            return Ok(());
        }
        let (time, state) = (self.time, &self.start[..self.size]);
        self.stretch.state_rate(time, state, &mut self.rate[..self.size]);
        require_finite("the rate of", &self.rate)?;
        self.stretch.time_derivative(time, state, &mut self.time_derivative[..self.size]);
        require_finite("the time derivative of the rate of", &self.time_derivative)?;
        if !self.onset.hand_over(&mut self.jacobian) {
            finite_jacobian(self.stretch, time, state, &mut self.jacobian)?;
        }
        self.factored_step = 0.0;
        self.is_linearized = true;
        Ok(())
    }

    fn factor(&mut self) -> Result<(), Trial> {
        if self.factored_step.to_bits() == self.step.to_bits() {
            return Ok(());
        }
        self.stretch.system.count(|work| work.factorizations += 1);
        self.factored_step = 0.0;
        let outcome = self.matrix.factor(self.shift(), &self.jacobian);
        if outcome.is_err() || self.matrix.is_outgrown() {
            return Err(Trial::Unsolved { shrink: 0.5 });
        }
        self.factored_step = self.step;
        Ok(())
    }

    /// Returns the shift of the matrix of the current step.
    fn shift(&self) -> f64 {
        1.0 / (self.method.gamma * self.step)
    }

    /// Computes U of one stage, and Y of the next one as the argument.
    fn stage(&mut self, stage: usize) -> Result<(), Trial> {
        let size = self.size;
        if stage > 0 {
            let time = self.time + self.method.nodes[stage] * self.step;
            let slope = &mut self.slope[..size];
            self.stretch.state_rate(time, &self.argument[..size], slope);
            require_finite("the rate of", slope)?;
        } else {
            self.slope.copy_from_slice(&self.rate);
        }
        let explicit = self.method.time_weights[stage] * self.step;
        for (slope, derivative) in self.slope.iter_mut().zip(&self.time_derivative) {
            *slope += explicit * derivative;
        }
        let (known, rest) = self.stages.split_at_mut(stage * self.width);
        let of_stage = &mut rest[..self.width];
        combine(&self.stage_sums[stage], known, 1.0 / self.step, Some(&self.slope), of_stage);
        self.matrix.solve(&mut of_stage[..size]);

        let next = &self.method.states[stage + 1];
        if stage > 0 && next[0].0 == stage {
            for (argument, stage) in self.argument.iter_mut().zip(of_stage) {
                *argument += *stage;
            }
        } else {
            let start = Some(&self.start[..self.width]);
            combine(&self.state_sums[stage + 1], &self.stages, 1.0, start, &mut self.argument);
        }
        Ok(())
    }

    fn try_step(&mut self) -> Result<f64, Trial> {
        self.linearize()?;
        self.factor()?;
        for stage in 0..self.method.stages.len() {
            self.stage(stage)?;
        }
        self.end[..self.width].copy_from_slice(&self.argument);
        require_finite("the state", &self.end)?;
        let last = self.stages.len() - self.width;
        self.error[..self.width].copy_from_slice(&self.stages[last..]);
        self.sum_up_flows();
        let len = self.stretch.system.len();
        let error = weighted_norm(self.stretch, &self.error[..len], &self.start, &self.end);
        Ok(error)
    }

    fn sum_up_flows(&mut self) {
        let Some(mut quadrature) = self.quadrature.take() else { return };
        let mut flows = [quadrature.at_start; NODES.len()];
        for (node, flow) in NODES.iter().zip(&mut flows).skip(1) {
            let time = self.time + node * self.step;
            *flow = if *node < 1.0 {
                self.states_at(*node);
                self.stretch.flow_rates(time, &self.argument[..self.size])
            } else {
                self.stretch.flow_rates(time, &self.end[..self.size])
            };
        }
        let errors = quadrature.complete(self.step, flows);
        for (flow, (gained, error)) in
            quadrature.gained_until(1.0).into_iter().zip(errors).enumerate()
        {
            self.end[self.size + flow] = self.start[self.size + flow] + gained;
            self.error[self.size + flow] = error;
        }
        self.quadrature = Some(quadrature);
    }

    /// Computes the states at `theta` of the step as the argument.
    fn states_at(&mut self, theta: f64) {
        if !self.has_dense {
            for (dense, weights) in self.dense.chunks_exact_mut(self.width).zip(self.method.dense) {
                dense.fill(0.0);
                for (weight, stage) in weights.iter().zip(self.stages.chunks_exact(self.width)) {
                    for (dense, stage) in dense.iter_mut().zip(stage) {
                        *dense += weight * stage;
                    }
                }
            }
            self.has_dense = true;
        }
        let rest = 1.0 - theta;
        let (first, others) = self.dense.split_at(self.width);
        let (second, third) = others.split_at(self.width);
        for (index, state) in self.argument[..self.size].iter_mut().enumerate() {
            let inner = first[index] + theta * (second[index] + theta * third[index]);
            *state = rest * self.start[index] + theta * (self.end[index] + rest * inner);
        }
    }
}

impl OneStep for RosenbrockSteps<'_> {
    fn begin(&mut self, time: f64, state: &[f64]) {
        self.time = time;
        self.step = 0.0;
        self.start[..state.len()].copy_from_slice(state);
        self.end[..state.len()].copy_from_slice(state);
        self.is_linearized = false;
        self.onset.forget();
        if let Some(quadrature) = &mut self.quadrature {
            quadrature.at_start = self.stretch.flow_rates(time, &self.start[..self.size]);
        }
    }

    fn first_step(&mut self) -> f64 {
        let size = self.size;
        let state = &self.start[..size];
        self.stretch.state_rate(self.time, state, &mut self.rate[..size]);
        let scratch = (&mut self.argument[..size], &mut self.slope[..size]);
        first_step(self.stretch, 5, self.time, (state, &self.rate[..size]), scratch)
    }

    fn attempt(&mut self, step: f64) -> Trial {
        self.step = step;
        self.has_dense = false;
        let tried = self.try_step().and_then(|error| {
            if error <= 1.0 {
                let at_end = (self.time + step, &self.end[..self.size]);
                self.onset.refuse(self.stretch, at_end, (self.shift(), &self.jacobian))?;
            }
            Ok(error)
        });
        tried.map_or_else(|trial| trial, Trial::Error)
    }

    fn end(&self) -> &[f64] {
        &self.end[..self.stretch.system.len()]
    }

    fn interpolate(&mut self, time: f64, state: &mut [f64]) {
        let theta = (time - self.time) / self.step;
        self.states_at(theta);
        state[..self.size].copy_from_slice(&self.argument[..self.size]);
        if let Some(quadrature) = &self.quadrature {
            let gained: Flows = quadrature.gained_until(theta);
            for (flow, gained) in gained.into_iter().enumerate() {
                state[self.size + flow] = self.start[self.size + flow] + gained;
            }
        }
    }

    /// Returns the norm of (1/(gamma h) I - J)^-1 (f(t, u) - u'(t)) at the middle, u being the
    /// dense output.
    fn error_between(&mut self, _is_sampled: bool) -> f64 {
        const THETA: f64 = 0.5;
        self.states_at(THETA);
        let (size, width) = (self.size, self.width);
        let time = self.time + THETA * self.step;
        self.stretch.state_rate(time, &self.argument[..size], &mut self.slope[..size]);
        for index in 0..size {
            let [d_1, d_2, d_3] = [0, 1, 2].map(|row| self.dense[row * width + index]);
            let inner = d_1 + THETA * (d_2 + THETA * d_3);
            let chord = self.end[index] - self.start[index];
            // u = (1 - theta) y_0 + theta y_1 + theta (1 - theta) inner(theta)
            let bow =
                (1.0 - 2.0 * THETA) * inner + THETA * (1.0 - THETA) * (d_2 + 2.0 * THETA * d_3);
            self.slope[index] -= (chord + bow) / self.step;
        }
        self.matrix.solve(&mut self.slope[..size]);
        let (start, end) = (&self.start[..size], &self.end[..size]);
        weighted_norm(self.stretch, &self.slope[..size], start, end) / BETWEEN
    }

    fn accept(&mut self) {
        self.time += self.step;
        self.start.copy_from_slice(&self.end);
        self.is_linearized = false;
        if let Some(quadrature) = &mut self.quadrature {
            quadrature.advance();
        }
    }

    fn pace(&self) -> Pace {
        Pace { exponent: 0.2, memory: 0.0, safety: 0.9, smallest: 0.2, largest: 6.0, hold: 1.0 }
    }
}

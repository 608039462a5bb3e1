//! Consistency of an estimator: its errors compared with its own covariance, over runs with random
//! noise.

use machinist_contract::Simulator;
use machinist_contract::fixed_step::{Clock, FixedSteps, Room};
use nalgebra::{DMatrix, DVector};
use serde::Serialize;
use statrs::distribution::{ChiSquared, ContinuousCDF};

use super::{Estimator, EstimatorIndices};
use crate::scatter::{normal_quantile, random_unit};

/// Runs that test an estimator.
#[derive(Debug, Clone, PartialEq)]
pub struct ConsistencyRun {
    /// Length of a step \[s\]; each ends with a measurement.
    pub step: f64,
    /// Number of steps.
    pub steps: usize,
    /// Number of runs.
    pub draws: usize,
    /// Number of instants, equally spaced up to the end.
    pub instants: usize,
    /// Seed of the noise.
    pub seed: u64,
}

/// Mean of a squared error over the runs, at an instant.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Instant {
    /// Time \[s\].
    pub time: f64,
    /// Degrees of freedom.
    pub freedom: usize,
    /// Number of runs that count. Those in which the estimate has other modes than the machine
    /// do not: no covariance describes a wrong mode.
    pub draws: usize,
    /// Mean over the runs; the expected value is `freedom`.
    pub mean: f64,
    /// Limits between which the mean is with a probability of 95 %, if the estimator is consistent.
    pub band: [f64; 2],
}

impl Instant {
    fn new(time: f64, freedom: usize, draws: usize, sum: f64) -> Self {
        let count = draws as f64;
        let band = match ChiSquared::new(freedom as f64 * count) {
            Ok(law) => [0.025, 0.975].map(|p| law.inverse_cdf(p) / count),
            Err(_) => [0.0; 2],
        };
        Self { time, freedom, draws, mean: sum / count, band }
    }

    /// Reports whether the mean is within its band.
    #[must_use]
    pub fn is_within(&self) -> bool {
        let [low, high] = self.band;
        low <= self.mean && self.mean <= high
    }
}

/// Consistency of an estimator.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Consistency {
    /// Number of runs.
    pub draws: usize,
    /// Normalized estimation error squared, e^T P^-1 e, after the measurements of some instants.
    pub nees: Vec<Instant>,
    /// Normalized innovation squared of the measurements of these instants.
    pub nis: Vec<Instant>,
    /// Outputs of the scene at the last instant.
    pub outputs: Vec<OutputError>,
    /// Number of instants and runs at which the estimate has other modes than the machine.
    pub other_modes: usize,
}

/// Error of an estimated output.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct OutputError {
    /// Name of the output.
    pub name: String,
    /// Its unit.
    pub unit: String,
    /// Root of the mean square of the error over the runs.
    pub error: f64,
}

impl Consistency {
    /// Tests an estimator: in each run the machine starts at random by the covariance at the start,
    /// and the noise of the design acts on it and on its measurements.
    ///
    /// # Panics
    /// If `instants` is 0 or above the number of steps.
    #[must_use]
    pub fn of(
        simulator: &dyn Simulator<f64>,
        indices: &EstimatorIndices<'_>,
        start: (f64, &[f64], &[f64]),
        run: &ConsistencyRun,
    ) -> Self {
        Self::against(simulator, [indices, indices], start, run)
    }

    /// Tests an estimator on a machine with the noise of another design, which has the same
    /// measurements and estimated parameters.
    ///
    /// # Panics
    /// If the designs have other measurements or estimated parameters, or as [`Self::of`].
    #[must_use]
    pub fn against(
        simulator: &dyn Simulator<f64>,
        [indices, noise]: [&EstimatorIndices<'_>; 2],
        (time, state, parameters): (f64, &[f64], &[f64]),
        run: &ConsistencyRun,
    ) -> Self {
        let outputs = |of: &EstimatorIndices<'_>| -> Vec<usize> {
            of.measured.iter().map(|(output, _)| *output).collect()
        };
        assert_eq!(outputs(indices), outputs(noise), "the same outputs are measured");
        assert_eq!(indices.estimated, noise.estimated, "the same parameters are estimated");
        assert!(0 < run.instants && run.instants <= run.steps, "instants are steps");
        let begun = Estimator::at(simulator, indices, time, state, parameters);
        let root = begun.root().to_vec();
        let mut sums = vec![Sums::default(); run.instants];
        let mut other_modes = 0;
        let mut squares = vec![0.0; simulator.shape().outputs];
        for draw in 0..run.draws {
            let mut random = Random { key: [run.seed, draw as u64], count: 0 };
            let mut estimator = Estimator::at(simulator, indices, time, state, parameters);
            let mut truth = Truth::new(&estimator, noise, time);
            truth.begin(&root, &mut random);
            let mut instant = 0;
            for step in 1..=run.steps {
                truth.step(run.step, &mut random);
                let _ = estimator.predict(run.step);
                let correction = estimator.correct(&truth.measured(&mut random));
                if step * run.instants < (instant + 1) * run.steps {
                    continue;
                }
                let (error, has_other_modes) = truth.error(&estimator);
                let (squared, freedom) = normalized(&estimator, &error);
                other_modes += usize::from(has_other_modes);
                if !has_other_modes {
                    sums[instant].add(estimator.time(), (squared, freedom), &correction);
                }
                instant += 1;
            }
            let pairs = truth.outputs().into_iter().zip(estimator.outputs());
            for (square, (truth, estimate)) in squares.iter_mut().zip(pairs) {
                *square += (truth - estimate).powi(2);
            }
        }
        let outputs = squares.iter().enumerate().map(|(index, square)| OutputError {
            name: simulator.output(index).name.to_owned(),
            unit: simulator.output(index).unit.to_owned(),
            error: (square / run.draws as f64).sqrt(),
        });
        let outputs = outputs.collect();
        let of = |told: fn(&Sums) -> (usize, f64)| {
            let instants = sums.iter().map(|sums| {
                let (freedom, sum) = told(sums);
                Instant::new(sums.time, freedom, sums.draws, sum)
            });
            instants.collect()
        };
        Self {
            draws: run.draws,
            nees: of(|sums| (sums.freedom, sums.nees)),
            nis: of(|sums| (sums.measured, sums.nis)),
            outputs,
            other_modes,
        }
    }
}

/// Sums over the runs, at an instant.
#[derive(Debug, Clone, Default)]
struct Sums {
    time: f64,
    draws: usize,
    freedom: usize,
    nees: f64,
    measured: usize,
    nis: f64,
}

impl Sums {
    fn add(
        &mut self,
        time: f64,
        (squared, freedom): (f64, usize),
        correction: &machinist_contract::fixed_step::Correction,
    ) {
        self.time = time;
        self.draws += 1;
        self.freedom = freedom;
        self.nees += squared;
        self.measured = correction.count;
        self.nis += correction.innovation;
    }
}

/// Normal random numbers, in order.
struct Random {
    key: [u64; 2],
    count: u64,
}

impl Random {
    fn normal(&mut self) -> f64 {
        self.count += 1;
        normal_quantile(random_unit(&[self.key[0], self.key[1], self.count]))
    }
}

/// Returns e^T P^+ e and the rank of P, with entries measured by their deviations. Errors in
/// directions without variance, which are of second order, do not count.
fn normalized(estimator: &Estimator<'_>, error: &[f64]) -> (f64, usize) {
    /// Eigenvalue, relative to the largest, below which a direction has no variance.
    const ROUNDING: f64 = 1e-12;
    /// Deviation, relative to the typical size of a state, below which it is known.
    const KNOWN: f64 = 1e-8;
    let deviations = estimator.deviations();
    let simulator = estimator.filter.simulator;
    let states = simulator.shape().states();
    let scale = |entry: usize| if entry < states { simulator.state_scale(entry) } else { 0.0 };
    let varies = |entry: &usize| deviations[*entry] > KNOWN * scale(*entry);
    let varies: Vec<usize> = (0..error.len()).filter(varies).collect();
    let count = varies.len();
    if count == 0 {
        return (0.0, 0);
    }
    let correlation = DMatrix::from_fn(count, count, |row, column| {
        let [row, column] = [varies[row], varies[column]];
        estimator.covariance(row, column) / (deviations[row] * deviations[column])
    });
    let scaled = DVector::from_fn(count, |row, _| error[varies[row]] / deviations[varies[row]]);
    let eigen = correlation.symmetric_eigen();
    let least = ROUNDING * eigen.eigenvalues.amax();
    let mut squared = 0.0;
    let mut rank = 0;
    for (index, value) in eigen.eigenvalues.iter().enumerate().filter(|(_, value)| **value > least)
    {
        squared += eigen.eigenvectors.column(index).dot(&scaled).powi(2) / value;
        rank += 1;
    }
    (squared, rank)
}

/// The machine itself, with noise.
struct Truth<'a> {
    indices: &'a EstimatorIndices<'a>,
    simulator: &'a dyn Simulator<f64>,
    clock: Clock<f64>,
    state: Vec<f64>,
    parameters: Vec<f64>,
    constants: Vec<f64>,
    numbers: Vec<f64>,
    signs: Vec<i8>,
}

impl<'a> Truth<'a> {
    fn new(estimator: &Estimator<'a>, indices: &'a EstimatorIndices<'a>, time: f64) -> Self {
        let simulator = estimator.filter.simulator;
        let mut truth = Self {
            indices,
            simulator,
            clock: Clock::new(time),
            state: estimator.state().to_vec(),
            parameters: estimator.parameters().to_vec(),
            constants: vec![0.0; simulator.constants()],
            numbers: Vec::new(),
            signs: Vec::new(),
        };
        let [numbers, signs] = truth.steps(&truth.parameters).room();
        truth.numbers = vec![0.0; numbers];
        truth.signs = vec![0; signs];
        truth
    }

    fn steps<'s>(&'s self, parameters: &'s [f64]) -> FixedSteps<'s, f64> {
        let filter = self.indices.filter(self.simulator);
        FixedSteps {
            simulator: self.simulator,
            parameters,
            constants: &self.constants,
            method: filter.method,
            parts_a_step: filter.parts_a_step,
        }
    }

    /// Adds a deviation of x.
    fn deviate(&mut self, entry: usize, by: f64) {
        match entry.checked_sub(self.state.len()) {
            None if self.simulator.is_mode(entry) => {}
            None => self.state[entry] += by,
            Some(slot) => self.parameters[self.indices.estimated[slot]] += by,
        }
    }

    fn begin(&mut self, root: &[f64], random: &mut Random) {
        let size = self.state.len() + self.indices.estimated.len();
        for column in root.chunks_exact(size).filter(|column| column.iter().any(|x| *x != 0.0)) {
            let z = random.normal();
            for (entry, by) in column.iter().enumerate() {
                self.deviate(entry, z * by);
            }
        }
        self.settle();
    }

    fn settle(&mut self) {
        let time = self.clock.time();
        let parameters = self.parameters.clone();
        self.with(&parameters, |steps, state, room| steps.restore_and_settle(time, state, room));
    }

    fn step(&mut self, step: f64, random: &mut Random) {
        let indices = self.indices;
        for &(entry, intensity) in &indices.diffusing {
            self.deviate(entry, intensity * step.sqrt() * random.normal());
        }
        if !indices.diffusing.is_empty() {
            self.settle();
        }
        let mut parameters = self.parameters.clone();
        for &(parameter, intensity) in &indices.disturbed {
            parameters[parameter] += intensity / step.sqrt() * random.normal();
        }
        self.simulator.prepare(&parameters, &mut self.constants);
        let time = self.clock.time();
        self.with(&parameters, |steps, state, room| {
            let _ = steps.step(time, step, state, room);
        });
        self.clock.pass(step);
    }

    /// Calls with the steps at some parameters, the state and the workspace.
    fn with(
        &mut self,
        parameters: &[f64],
        call: impl FnOnce(&FixedSteps<'_, f64>, &mut [f64], &mut Room<'_, f64>),
    ) {
        let (mut state, mut numbers, mut signs) = (
            std::mem::take(&mut self.state),
            std::mem::take(&mut self.numbers),
            std::mem::take(&mut self.signs),
        );
        let mut room = Room { numbers: &mut numbers, signs: &mut signs };
        call(&self.steps(parameters), &mut state, &mut room);
        (self.state, self.numbers, self.signs) = (state, numbers, signs);
    }

    fn outputs(&self) -> Vec<f64> {
        let mut outputs = vec![0.0; self.simulator.shape().outputs];
        let (time, state) = (self.clock.time(), &self.state);
        self.simulator.outputs(time, state, &self.parameters, &mut outputs);
        outputs
    }

    fn measured(&self, random: &mut Random) -> Vec<f64> {
        let outputs = self.outputs();
        let measured = self.indices.measured.iter();
        measured.map(|&(output, deviation)| outputs[output] + deviation * random.normal()).collect()
    }

    /// Returns the error of an estimate, and whether it has other modes.
    fn error(&self, estimator: &Estimator<'_>) -> (Vec<f64>, bool) {
        let mut other_modes = false;
        let states = self.state.iter().zip(estimator.state()).enumerate();
        let mut error: Vec<f64> = states
            .map(|(entry, (truth, estimate))| {
                let is_mode = self.simulator.is_mode(entry);
                // Modes are whole numbers.
                other_modes |= is_mode && (truth - estimate).abs() > 0.5;
                if is_mode { 0.0 } else { truth - estimate }
            })
            .collect();
        let parameters = self.indices.estimated.iter();
        error.extend(parameters.map(|&p| self.parameters[p] - estimator.parameters()[p]));
        (error, other_modes)
    }
}

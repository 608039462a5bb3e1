// Emitted by Machinist 0.1.0; do not edit. To make it again:
//
//     machinist gen saw_gin -o . --estimator ekf --measure motor_speed=0.1,stator_current=0.5 --noise load.mean=5,motor.phase_voltage=0.05 --estimate load.mean --uncertain load.mean=10,motor.omega=0.1
//
// Extended Kalman filter: Saw gin: motor, coupling and saw cylinder
//
// A prediction by the classical Runge-Kutta method of order 4:
//   5897 operations without events, at most 4634 more for each further part, 10531 in 2 parts.
// A correction: at most 1970 operations.
// An estimate with its workspace: 5544 bytes.

use machinist_contract::fixed_step::{
    Clock, Correction, ExtendedKalmanFilter, FilterMemory, FixedMethod, Stepped,
};
use machinist_contract::{Dual, Simulator};

use super::saw_gin::{CONSTANTS, SawGin};

/// Measured outputs, with the standard deviations of their noise.
pub const MEASURED: [(usize, f64); 2] = [
    (0, 0.1), // motor_speed [rad/s]
    (7, 0.5), // stator_current [A]
];

/// Entries that diffuse, with intensities per root of a second.
pub const DIFFUSING: [(usize, f64); 1] = [
    (7, 5.0), // load.mean [N m]
];

/// Disturbed parameters, with intensities times the root of a second.
pub const DISTURBED: [(usize, f64); 1] = [
    (1, 0.05), // motor.phase_voltage [V]
];

/// Estimated parameters.
pub const ESTIMATED: [usize; 1] = [
    14, // load.mean [N m]
];

/// Standard deviations of the entries at the start: states, then estimated parameters.
pub const DEVIATIONS: [f64; 8] = [
    0.0, // coupling.twist [rad]
    0.1, // motor.omega [rad/s]
    0.0, // cylinder.omega [rad/s]
    0.0, // motor.psi_sx [V s]
    0.0, // motor.psi_sy [V s]
    0.0, // motor.psi_rx [V s]
    0.0, // motor.psi_ry [V s]
    10.0, // load.mean [N m]
];

/// State at the start.
pub const START: [f64; 7] = [
    0.0, // coupling.twist [rad]
    0.0, // motor.omega [rad/s]
    0.0, // cylinder.omega [rad/s]
    0.0, // motor.psi_sx [V s]
    0.0, // motor.psi_sy [V s]
    0.0, // motor.psi_rx [V s]
    0.0, // motor.psi_ry [V s]
];

/// Returns the filter.
#[must_use]
pub fn filter() -> ExtendedKalmanFilter<'static> {
    ExtendedKalmanFilter {
        simulator: &SawGin,
        method: FixedMethod::RungeKutta4,
        parts_a_step: 2,
        measured: &MEASURED,
        estimated: &ESTIMATED,
        diffusing: &DIFFUSING,
        disturbed: &DISTURBED,
    }
}

/// Estimate of the machine, with its workspace.
#[derive(Debug, Clone)]
pub struct Estimator {
    clock: Clock<f64>,
    state: [f64; 7],
    parameters: [f64; 21],
    constants: [f64; CONSTANTS],
    root: [f64; 80],
    numbers: [f64; 361],
    signs: [i8; 0],
    duals: [Dual; 36],
}

impl Default for Estimator {
    fn default() -> Self {
        Self::new()
    }
}

impl Estimator {
    /// Returns the estimate at the start of the spec's run.
    #[must_use]
    pub fn new() -> Self {
        let mut estimator = Self {
            clock: Clock::new(0.0),
            state: START,
            parameters: core::array::from_fn(|index| {
                machinist_contract::Describe::parameter_default(&SawGin, index)
            }),
            constants: [0.0; CONSTANTS],
            root: [0.0; 80],
            numbers: [0.0; 361],
            signs: [0; 0],
            duals: [Dual::constant(0.0); 36],
        };
        estimator.with(|filter, memory| filter.begin(&DEVIATIONS, memory));
        estimator
    }

    fn with<T>(
        &mut self,
        call: impl FnOnce(&ExtendedKalmanFilter<'_>, &mut FilterMemory<'_>) -> T,
    ) -> T {
        let mut memory = FilterMemory {
            clock: self.clock,
            state: &mut self.state,
            parameters: &mut self.parameters,
            constants: &mut self.constants,
            root: &mut self.root,
            numbers: &mut self.numbers,
            signs: &mut self.signs,
            duals: &mut self.duals,
        };
        let result = call(&filter(), &mut memory);
        self.clock = memory.clock;
        result
    }

    /// Advances the estimate by a step [s].
    pub fn predict(&mut self, step: f64) -> Stepped {
        self.with(|filter, memory| filter.predict(step, memory))
    }

    /// Corrects the estimate by measured outputs, in the order of [`MEASURED`]. Values that are not
    /// a number are left out.
    pub fn correct(&mut self, measured: &[f64; MEASURED.len()]) -> Correction {
        self.with(|filter, memory| filter.correct(measured, memory))
    }

    /// Sets a parameter, such as an input.
    ///
    /// # Panics
    /// If there is no parameter with this index.
    pub fn set(&mut self, parameter: usize, value: f64) {
        self.parameters[parameter] = value;
        Simulator::<f64>::prepare(&SawGin, &self.parameters, &mut self.constants);
    }

    /// Returns the time of the estimate [s].
    #[must_use]
    pub fn time(&self) -> f64 {
        self.clock.time()
    }

    /// Returns the estimated state.
    #[must_use]
    pub fn state(&self) -> &[f64; 7] {
        &self.state
    }

    /// Returns the parameters, with the estimated ones among them.
    #[must_use]
    pub fn parameters(&self) -> &[f64; 21] {
        &self.parameters
    }

    /// Computes the outputs of the scene at the estimate.
    pub fn outputs(&self, outputs: &mut [f64]) {
        Simulator::outputs(&SawGin, self.time(), &self.state, &self.parameters, outputs);
    }

    /// Returns the covariance of two entries: states, then estimated parameters.
    #[must_use]
    pub fn covariance(&self, row: usize, column: usize) -> f64 {
        filter().covariance(&self.root, row, column)
    }
}

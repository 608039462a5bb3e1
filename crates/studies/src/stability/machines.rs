//! Problems that strain methods, written by hand as first-order states.
//!
//! E. Hairer, G. Wanner: Solving Ordinary Differential Equations II, sections IV.2
//! (Dahlquist), IV.10 (van der Pol, Robertson) and IV.15 (Prothero and Robinson).

use machinist_contract::{
    Describe, Energy, PowerBalance, Quantity, RunDefaults, Shape, Simulator, SparsityPattern,
};

/// Equations y' = f(t, y) with parameters p, given as functions.
#[derive(Debug, Clone, Copy)]
pub struct ByHand {
    /// Identifier.
    pub name: &'static str,
    /// The equations in one line.
    pub title: &'static str,
    /// States at the start.
    pub initial: &'static [f64],
    /// Typical sizes of the states.
    pub scales: &'static [f64],
    /// Names and values of the dimensionless parameters.
    pub parameters: &'static [(&'static str, f64)],
    /// Writes f(t, y, p) into the last argument.
    pub rate: fn(f64, &[f64], &[f64], &mut [f64]),
    /// Rows and columns of the nonzeros of df/dy.
    pub pattern: &'static [(u32, u32)],
    /// Writes these nonzeros.
    pub jacobian: fn(f64, &[f64], &[f64], &mut [f64]),
    /// Partial derivative of f with respect to time.
    pub time_derivative: fn(f64, &[f64], &mut [f64]),
    /// Number of times at which f jumps.
    pub jumps: usize,
    /// Writes these times, from the parameters.
    pub jump_times: fn(&[f64], &mut [f64]),
    /// End of a run \[s\].
    pub until: f64,
}

/// Dahlquist: y' = lambda y from 1.
pub static DAHLQUIST: ByHand = ByHand {
    name: "dahlquist",
    title: "y' = lambda y",
    initial: &[1.0],
    scales: &[1.0],
    parameters: &[("lambda", -1.0)],
    rate: |_, y, p, rate| rate[0] = p[0] * y[0],
    pattern: &[(0, 0)],
    jacobian: |_, _, p, values| values[0] = p[0],
    time_derivative: |_, _, derivative| derivative[0] = 0.0,
    jumps: 0,
    jump_times: |_, _| {},
    until: 2.0,
};

/// Prothero and Robinson: y' = lambda (y - cos t) - sin t from 1, so y = cos t.
pub static PROTHERO_ROBINSON: ByHand = ByHand {
    name: "prothero_robinson",
    title: "y' = lambda (y - cos t) - sin t",
    initial: &[1.0],
    scales: &[1.0],
    parameters: &[("lambda", -1.0)],
    rate: |t, y, p, rate| rate[0] = p[0] * (y[0] - t.cos()) - t.sin(),
    pattern: &[(0, 0)],
    jacobian: |_, _, p, values| values[0] = p[0],
    time_derivative: |t, p, derivative| derivative[0] = p[0] * t.sin() - t.cos(),
    jumps: 0,
    jump_times: |_, _| {},
    until: 3.0,
};

/// Van der Pol: y1' = y2, y2' = ((1 - y1^2) y2 - y1)/epsilon from (2, 0). This is y'' = mu (1 -
/// y^2) y' - y in the time t/mu, with epsilon = 1/mu^2.
pub static VAN_DER_POL: ByHand = ByHand {
    name: "van_der_pol",
    title: "y'' = ((1 - y^2) y' - y)/epsilon",
    initial: &[2.0, 0.0],
    scales: &[1.0, 1.0],
    parameters: &[("epsilon", 1e-6)],
    rate: |_, y, p, rate| {
        rate[0] = y[1];
        rate[1] = ((1.0 - y[0] * y[0]) * y[1] - y[0]) / p[0];
    },
    pattern: &[(0, 1), (1, 0), (1, 1)],
    jacobian: |_, y, p, values| {
        let by_position = (-2.0 * y[0] * y[1] - 1.0) / p[0];
        values.copy_from_slice(&[1.0, by_position, (1.0 - y[0] * y[0]) / p[0]]);
    },
    time_derivative: |_, _, derivative| derivative.fill(0.0),
    jumps: 0,
    jump_times: |_, _| {},
    until: 2.0,
};

/// Robertson: three reactions with rates 0.04, 1e4 and 3e7, from (1, 0, 0).
pub static ROBERTSON: ByHand = ByHand {
    name: "robertson",
    title: "Robertson's reactions, 0.04, 1e4, 3e7",
    initial: &[1.0, 0.0, 0.0],
    scales: &[1e-6, 1e-12, 1e-6],
    parameters: &[],
    rate: |_, y, _, rate| {
        let (slow, middle, fast) = (0.04 * y[0], 1e4 * y[1] * y[2], 3e7 * y[1] * y[1]);
        rate.copy_from_slice(&[middle - slow, slow - middle - fast, fast]);
    },
    pattern: &[(0, 0), (0, 1), (0, 2), (1, 0), (1, 1), (1, 2), (2, 1)],
    jacobian: |_, y, _, values| {
        let (by_y2, by_y3, fast) = (1e4 * y[2], 1e4 * y[1], 6e7 * y[1]);
        values.copy_from_slice(&[-0.04, by_y2, by_y3, 0.04, -by_y2 - fast, -by_y3, fast]);
    },
    time_derivative: |_, _, derivative| derivative.fill(0.0),
    jumps: 0,
    jump_times: |_, _| {},
    until: 1e11,
};

/// A rotor of inertia 1 on a spring c and a damper b, at rest until a torque m acts from 0.1 s for
/// `width`: x'' + b x' + c x = m (s(t - 0.1) - s(t - 0.1 - width)).
pub static PULSE: ByHand = ByHand {
    name: "pulse",
    title: "x'' + b x' + c x under a pulse of torque",
    initial: &[0.0, 0.0],
    scales: &[1.0, 1.0],
    parameters: &[("stiffness", 1e4), ("damping", 1.0), ("torque", 1e3), ("width", 1e-4)],
    rate: |t, y, p, rate| {
        let torque = if t >= PULSE_START && t < PULSE_START + p[3] { p[2] } else { 0.0 };
        rate[0] = y[1];
        rate[1] = torque - p[1] * y[1] - p[0] * y[0];
    },
    pattern: &[(0, 1), (1, 0), (1, 1)],
    jacobian: |_, _, p, values| values.copy_from_slice(&[1.0, -p[0], -p[1]]),
    time_derivative: |_, _, derivative| derivative.fill(0.0),
    jumps: 2,
    jump_times: |p, times| times.copy_from_slice(&[PULSE_START, PULSE_START + p[3]]),
    until: 0.5,
};

/// Start of the pulse \[s\].
pub const PULSE_START: f64 = 0.1;

impl Describe for ByHand {
    fn name(&self) -> &str {
        self.name
    }
    fn title(&self) -> &str {
        self.title
    }
    fn shape(&self) -> Shape {
        Shape {
            coordinates: 0,
            positions: 0,
            first_order: self.initial.len(),
            quadratures: 0,
            parameters: self.parameters.len(),
            outputs: 0,
            discontinuities: self.jumps,
        }
    }
    fn state(&self, index: usize) -> Quantity<'_> {
        Quantity { name: ["y1", "y2", "y3"][index], unit: "1", doc: "a state" }
    }
    fn state_scale(&self, index: usize) -> f64 {
        self.scales[index]
    }
    fn parameter(&self, index: usize) -> Quantity<'_> {
        Quantity { name: self.parameters[index].0, unit: "1", doc: "" }
    }
    fn parameter_default(&self, index: usize) -> f64 {
        self.parameters[index].1
    }
    fn output(&self, _index: usize) -> Quantity<'_> {
        unreachable!("has no outputs")
    }
    fn rate_jacobian_pattern(&self) -> SparsityPattern<'_> {
        let states = self.initial.len();
        SparsityPattern { rows: states, columns: states, entries: self.pattern }
    }
    fn parameter_jacobian_pattern(&self) -> SparsityPattern<'_> {
        let (rows, columns) = (self.initial.len(), self.parameters.len());
        SparsityPattern { rows, columns, entries: &[] }
    }
    fn mass_matrix_pattern(&self) -> SparsityPattern<'_> {
        SparsityPattern { rows: 0, columns: 0, entries: &[] }
    }
    fn run_defaults(&self) -> RunDefaults<'_> {
        RunDefaults {
            from: 0.0,
            until: self.until,
            points: 2,
            times: &[],
            rtol: 1e-6,
            method: "bdf",
        }
    }
}

impl Simulator<f64> for ByHand {
    fn initial_state(&self, _p: &[f64], state: &mut [f64]) {
        state.copy_from_slice(self.initial);
    }
    fn discontinuities(&self, p: &[f64], times: &mut [f64]) {
        (self.jump_times)(p, times);
    }
    fn rate(&self, time: f64, y: &[f64], p: &[f64], rate: &mut [f64]) {
        (self.rate)(time, y, p, rate);
    }
    fn rate_jacobian(&self, time: f64, y: &[f64], p: &[f64], values: &mut [f64]) {
        (self.jacobian)(time, y, p, values);
    }
    fn parameter_jacobian(&self, _time: f64, _y: &[f64], _p: &[f64], _values: &mut [f64]) {}
    fn time_derivative(&self, time: f64, _y: &[f64], p: &[f64], derivative: &mut [f64]) {
        (self.time_derivative)(time, p, derivative);
    }
    fn mass_matrix(&self, _time: f64, _y: &[f64], _p: &[f64], _values: &mut [f64]) {}
    fn forcing(&self, _time: f64, _y: &[f64], _p: &[f64], _forcing: &mut [f64]) {}
    fn outputs(&self, _time: f64, _y: &[f64], _p: &[f64], _outputs: &mut [f64]) {}
    fn energy(&self, _time: f64, _y: &[f64], _p: &[f64]) -> Energy<f64> {
        Energy { kinetic: 0.0, potential: 0.0, stored: 0.0 }
    }
    fn power_balance(&self, _time: f64, _y: &[f64], _p: &[f64]) -> PowerBalance<f64> {
        PowerBalance { stored_rate: 0.0, supplied: 0.0, dissipated: 0.0 }
    }
}

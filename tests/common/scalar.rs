// One first-order state y' = f(t, y), written by hand for each test.
use machinist_contract::{
    Describe, Energy, PowerBalance, Quantity, RunDefaults, Shape, Simulator, SparsityPattern,
};

#[derive(Clone, Copy)]
pub struct Scalar {
    pub rate: fn(f64, f64) -> f64,
    pub slope: fn(f64, f64) -> f64,
    pub initial: f64,
    pub jumps: &'static [f64],
    pub scale: f64,
    pub supplied: fn(f64) -> f64,
}

impl Scalar {
    pub fn new(rate: fn(f64, f64) -> f64, slope: fn(f64, f64) -> f64, initial: f64) -> Self {
        Self { rate, slope, initial, jumps: &[], scale: 1.0, supplied: no_power }
    }
}

impl Describe for Scalar {
    fn name(&self) -> &'static str {
        "scalar"
    }
    fn title(&self) -> &'static str {
        "One equation"
    }
    fn shape(&self) -> Shape {
        Shape {
            coordinates: 0,
            positions: 0,
            first_order: 1,
            quadratures: 0,
            parameters: 0,
            outputs: 0,
            discontinuities: self.jumps.len(),
        }
    }
    fn state(&self, _index: usize) -> Quantity<'_> {
        Quantity { name: "y", unit: "1", doc: "the state" }
    }
    fn state_scale(&self, _index: usize) -> f64 {
        self.scale
    }
    fn parameter(&self, _index: usize) -> Quantity<'_> {
        unreachable!("has no parameters")
    }
    fn parameter_default(&self, _index: usize) -> f64 {
        unreachable!("has no parameters")
    }
    fn output(&self, _index: usize) -> Quantity<'_> {
        unreachable!("has no outputs")
    }
    fn rate_jacobian_pattern(&self) -> SparsityPattern<'_> {
        SparsityPattern { rows: 1, columns: 1, entries: &[(0, 0)] }
    }
    fn parameter_jacobian_pattern(&self) -> SparsityPattern<'_> {
        SparsityPattern { rows: 1, columns: 0, entries: &[] }
    }
    fn mass_matrix_pattern(&self) -> SparsityPattern<'_> {
        SparsityPattern { rows: 0, columns: 0, entries: &[] }
    }
    fn run_defaults(&self) -> RunDefaults<'_> {
        RunDefaults { from: 0.0, until: 2.0, points: 21, times: &[], rtol: 1e-6, method: "bdf" }
    }
}

impl Simulator<f64> for Scalar {
    fn initial_state(&self, _p: &[f64], state: &mut [f64]) {
        state[0] = self.initial;
    }
    fn discontinuities(&self, _p: &[f64], times: &mut [f64]) {
        times.copy_from_slice(self.jumps);
    }
    fn rate(&self, time: f64, y: &[f64], _p: &[f64], rate: &mut [f64]) {
        rate[0] = (self.rate)(time, y[0]);
    }
    fn rate_jacobian(&self, time: f64, y: &[f64], _p: &[f64], values: &mut [f64]) {
        values[0] = (self.slope)(time, y[0]);
    }
    fn parameter_jacobian(&self, _time: f64, _y: &[f64], _p: &[f64], _values: &mut [f64]) {}
    fn time_derivative(&self, time: f64, y: &[f64], _p: &[f64], derivative: &mut [f64]) {
        let step = 1e-5;
        let (ahead, behind) = ((self.rate)(time + step, y[0]), (self.rate)(time - step, y[0]));
        derivative[0] = (ahead - behind) / (2.0 * step);
    }
    fn mass_matrix(&self, _time: f64, _y: &[f64], _p: &[f64], _values: &mut [f64]) {}
    fn forcing(&self, _time: f64, _y: &[f64], _p: &[f64], _forcing: &mut [f64]) {}
    fn outputs(&self, _time: f64, _y: &[f64], _p: &[f64], _outputs: &mut [f64]) {}
    fn energy(&self, _time: f64, _y: &[f64], _p: &[f64]) -> Energy<f64> {
        Energy { kinetic: 0.0, potential: 0.0, stored: 0.0 }
    }
    fn power_balance(&self, time: f64, _y: &[f64], _p: &[f64]) -> PowerBalance<f64> {
        PowerBalance { stored_rate: 0.0, supplied: (self.supplied)(time), dissipated: 0.0 }
    }
}

fn no_power(_time: f64) -> f64 {
    0.0
}

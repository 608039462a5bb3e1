// A pendulum whose support swings, written by hand: nonlinear and driven.
//
//     q'' = -sin q - 0.2 q' + cos(3 t) sin q
use machinist_scenes::{
    Describe, Energy, PowerBalance, Quantity, RunDefaults, Shape, Simulator, SparsityPattern,
};

#[derive(Debug, Clone, Copy)]
pub struct Pendulum;

impl Describe for Pendulum {
    fn name(&self) -> &'static str {
        "pendulum"
    }
    fn title(&self) -> &'static str {
        "A pendulum whose support swings"
    }
    fn shape(&self) -> Shape {
        Shape { coordinates: 1, first_order: 0, parameters: 0, outputs: 0, discontinuities: 0 }
    }
    fn state(&self, index: usize) -> Quantity<'_> {
        [
            Quantity { name: "angle", unit: "rad", doc: "angle" },
            Quantity { name: "omega", unit: "rad/s", doc: "speed" },
        ][index]
    }
    fn state_scale(&self, _index: usize) -> f64 {
        1.0
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
        SparsityPattern { rows: 2, columns: 2, entries: &[(0, 1), (1, 0), (1, 1)] }
    }
    fn parameter_jacobian_pattern(&self) -> SparsityPattern<'_> {
        SparsityPattern { rows: 2, columns: 0, entries: &[] }
    }
    fn mass_matrix_pattern(&self) -> SparsityPattern<'_> {
        SparsityPattern { rows: 1, columns: 1, entries: &[(0, 0)] }
    }
    fn run_defaults(&self) -> RunDefaults<'_> {
        RunDefaults { from: 0.0, until: 6.0, points: 61, rtol: 1e-8, method: "bdf" }
    }
}

impl Simulator<f64> for Pendulum {
    fn initial_state(&self, _p: &[f64], state: &mut [f64]) {
        state.copy_from_slice(&[2.0, 0.5]);
    }
    fn discontinuities(&self, _p: &[f64], _times: &mut [f64]) {}
    fn rate(&self, time: f64, y: &[f64], _p: &[f64], rate: &mut [f64]) {
        rate[0] = y[1];
        rate[1] = ((3.0 * time).cos() - 1.0) * y[0].sin() - 0.2 * y[1];
    }
    fn rate_jacobian(&self, time: f64, y: &[f64], _p: &[f64], values: &mut [f64]) {
        values.copy_from_slice(&[1.0, ((3.0 * time).cos() - 1.0) * y[0].cos(), -0.2]);
    }
    fn parameter_jacobian(&self, _time: f64, _y: &[f64], _p: &[f64], _values: &mut [f64]) {}
    fn time_derivative(&self, time: f64, y: &[f64], _p: &[f64], derivative: &mut [f64]) {
        derivative.copy_from_slice(&[0.0, -3.0 * (3.0 * time).sin() * y[0].sin()]);
    }
    fn mass_matrix(&self, _time: f64, _y: &[f64], _p: &[f64], values: &mut [f64]) {
        values[0] = 1.0;
    }
    fn forcing(&self, time: f64, y: &[f64], p: &[f64], forcing: &mut [f64]) {
        let mut rate = [0.0; 2];
        self.rate(time, y, p, &mut rate);
        forcing[0] = rate[1];
    }
    fn outputs(&self, _time: f64, _y: &[f64], _p: &[f64], _outputs: &mut [f64]) {}
    fn energy(&self, _time: f64, y: &[f64], _p: &[f64]) -> Energy<f64> {
        Energy { kinetic: 0.5 * y[1] * y[1], potential: 1.0 - y[0].cos(), stored: 0.0 }
    }
    fn power_balance(&self, time: f64, y: &[f64], _p: &[f64]) -> PowerBalance<f64> {
        let supplied = (3.0 * time).cos() * y[0].sin() * y[1];
        let dissipated = 0.2 * y[1] * y[1];
        PowerBalance { stored_rate: supplied - dissipated, supplied, dissipated }
    }
}

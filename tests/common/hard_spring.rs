// A spring that hardens and whose stiffness swings, written by hand:
//
//     q'' = -q - q^3 - 0.1 q' + 0.5 cos(2 t) q
use machinist_contract::{
    Describe, Energy, PowerBalance, Quantity, RunDefaults, Shape, Simulator, SparsityPattern,
};

#[derive(Debug, Clone, Copy)]
pub struct HardSpring;

impl Describe for HardSpring {
    fn name(&self) -> &'static str {
        "hard_spring"
    }
    fn title(&self) -> &'static str {
        "A spring that hardens and whose stiffness swings"
    }
    fn shape(&self) -> Shape {
        Shape {
            coordinates: 1,
            positions: 1,
            first_order: 0,
            quadratures: 0,
            parameters: 0,
            outputs: 0,
            discontinuities: 0,
        }
    }
    fn state(&self, index: usize) -> Quantity<'_> {
        [
            Quantity { name: "position", unit: "m", doc: "position" },
            Quantity { name: "speed", unit: "m/s", doc: "speed" },
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
        RunDefaults { from: 0.0, until: 8.0, points: 81, times: &[], rtol: 1e-8, method: "bdf" }
    }
    fn conserves_energy(&self, _p: &[f64]) -> Option<bool> {
        Some(false)
    }
}

impl Simulator<f64> for HardSpring {
    fn initial_state(&self, _p: &[f64], state: &mut [f64]) {
        state.copy_from_slice(&[1.0, 0.5]);
    }
    fn discontinuities(&self, _p: &[f64], _times: &mut [f64]) {}
    fn rate(&self, time: f64, y: &[f64], _p: &[f64], rate: &mut [f64]) {
        rate[0] = y[1];
        rate[1] = (0.5 * (2.0 * time).cos() - 1.0 - y[0] * y[0]) * y[0] - 0.1 * y[1];
    }
    fn rate_jacobian(&self, time: f64, y: &[f64], _p: &[f64], values: &mut [f64]) {
        values.copy_from_slice(&[1.0, 0.5 * (2.0 * time).cos() - 1.0 - 3.0 * y[0] * y[0], -0.1]);
    }
    fn parameter_jacobian(&self, _time: f64, _y: &[f64], _p: &[f64], _values: &mut [f64]) {}
    fn time_derivative(&self, time: f64, y: &[f64], _p: &[f64], derivative: &mut [f64]) {
        derivative.copy_from_slice(&[0.0, -(2.0 * time).sin() * y[0]]);
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
        Energy {
            kinetic: 0.5 * y[1] * y[1],
            potential: 0.5 * y[0] * y[0] + 0.25 * y[0].powi(4),
            stored: 0.0,
        }
    }
    fn power_balance(&self, time: f64, y: &[f64], _p: &[f64]) -> PowerBalance<f64> {
        let supplied = 0.5 * (2.0 * time).cos() * y[0] * y[1];
        let dissipated = 0.1 * y[1] * y[1];
        PowerBalance { stored_rate: supplied - dissipated, supplied, dissipated }
    }
}

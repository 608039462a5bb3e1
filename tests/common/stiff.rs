// Two problems that every stiff method is measured by, as first-order states:
// E. Hairer, G. Wanner: Solving Ordinary Differential Equations II, section IV.10.
use machinist_scenes::{
    Describe, Energy, PowerBalance, Quantity, RunDefaults, Shape, Simulator, SparsityPattern,
};

#[derive(Debug, Clone, Copy)]
pub enum Stiff {
    /// y1' = y2, y2' = ((1 - y1^2) y2 - y1) / 1e-6.
    VanDerPol,
    /// Three reactions with rates 0.04, 1e4 and 3e7.
    Robertson,
}

const EPSILON: f64 = 1e-6;

impl Describe for Stiff {
    fn name(&self) -> &'static str {
        "stiff"
    }
    fn title(&self) -> &'static str {
        "A stiff problem"
    }
    fn shape(&self) -> Shape {
        let first_order = match self {
            Self::VanDerPol => 2,
            Self::Robertson => 3,
        };
        Shape {
            coordinates: 0,
            positions: 0,
            first_order,
            quadratures: 0,
            parameters: 0,
            outputs: 0,
            discontinuities: 0,
        }
    }
    fn state(&self, index: usize) -> Quantity<'_> {
        Quantity { name: ["y1", "y2", "y3"][index], unit: "1", doc: "a state" }
    }
    fn state_scale(&self, index: usize) -> f64 {
        match self {
            Self::VanDerPol => 1.0,
            Self::Robertson => [1e-6, 1e-12, 1e-6][index],
        }
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
        match self {
            Self::VanDerPol => {
                SparsityPattern { rows: 2, columns: 2, entries: &[(0, 1), (1, 0), (1, 1)] }
            }
            Self::Robertson => SparsityPattern {
                rows: 3,
                columns: 3,
                entries: &[(0, 0), (0, 1), (0, 2), (1, 0), (1, 1), (1, 2), (2, 1)],
            },
        }
    }
    fn parameter_jacobian_pattern(&self) -> SparsityPattern<'_> {
        SparsityPattern { rows: self.shape().first_order, columns: 0, entries: &[] }
    }
    fn mass_matrix_pattern(&self) -> SparsityPattern<'_> {
        SparsityPattern { rows: 0, columns: 0, entries: &[] }
    }
    fn run_defaults(&self) -> RunDefaults<'_> {
        let until = match self {
            Self::VanDerPol => 2.0,
            Self::Robertson => 1e11,
        };
        RunDefaults { from: 0.0, until, points: 2, rtol: 1e-6, method: "bdf" }
    }
}

impl Simulator<f64> for Stiff {
    fn initial_state(&self, _p: &[f64], state: &mut [f64]) {
        match self {
            Self::VanDerPol => state.copy_from_slice(&[2.0, 0.0]),
            Self::Robertson => state.copy_from_slice(&[1.0, 0.0, 0.0]),
        }
    }
    fn discontinuities(&self, _p: &[f64], _times: &mut [f64]) {}
    fn rate(&self, _time: f64, y: &[f64], _p: &[f64], rate: &mut [f64]) {
        match self {
            Self::VanDerPol => {
                rate[0] = y[1];
                rate[1] = ((1.0 - y[0] * y[0]) * y[1] - y[0]) / EPSILON;
            }
            Self::Robertson => {
                let (slow, middle, fast) = (0.04 * y[0], 1e4 * y[1] * y[2], 3e7 * y[1] * y[1]);
                rate.copy_from_slice(&[middle - slow, slow - middle - fast, fast]);
            }
        }
    }
    fn rate_jacobian(&self, _time: f64, y: &[f64], _p: &[f64], values: &mut [f64]) {
        match self {
            Self::VanDerPol => values.copy_from_slice(&[
                1.0,
                (-2.0 * y[0] * y[1] - 1.0) / EPSILON,
                (1.0 - y[0] * y[0]) / EPSILON,
            ]),
            Self::Robertson => {
                let (by_y2, by_y3, fast) = (1e4 * y[2], 1e4 * y[1], 6e7 * y[1]);
                let jacobian = [-0.04, by_y2, by_y3, 0.04, -by_y2 - fast, -by_y3, fast];
                values.copy_from_slice(&jacobian);
            }
        }
    }
    fn parameter_jacobian(&self, _time: f64, _y: &[f64], _p: &[f64], _values: &mut [f64]) {}
    fn time_derivative(&self, _time: f64, _y: &[f64], _p: &[f64], derivative: &mut [f64]) {
        derivative.fill(0.0);
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

// A rotor on a spring and a damper under a torque that steps, written by hand:
//
//     J q'' + d q' + c q = M step(t, t0)
use machinist_contract::taylor::TaylorSeries;
use machinist_contract::{
    Derivatives, Describe, Energy, PowerBalance, Quantity, Real, RunDefaults, Shape, Simulator,
    SparsityPattern,
};

#[derive(Debug, Clone, Copy)]
pub struct Oscillator;

const PARAMETERS: [(&str, &str, f64); 5] = [
    ("rotor.inertia", "kg m^2", 2.0),
    ("rotor.damping", "N m s/rad", 0.8),
    ("rotor.stiffness", "N m/rad", 50.0),
    ("torque", "N m", 30.0),
    ("torque_start", "s", 0.7),
];

impl Describe for Oscillator {
    fn name(&self) -> &'static str {
        "oscillator"
    }
    fn title(&self) -> &'static str {
        "A rotor on a spring and a damper"
    }
    fn shape(&self) -> Shape {
        Shape {
            coordinates: 1,
            positions: 1,
            first_order: 0,
            quadratures: 0,
            parameters: 5,
            outputs: 2,
            discontinuities: 1,
        }
    }
    fn state(&self, index: usize) -> Quantity<'_> {
        [
            Quantity { name: "rotor.angle", unit: "rad", doc: "angle" },
            Quantity { name: "rotor.omega", unit: "rad/s", doc: "speed" },
        ][index]
    }
    fn state_scale(&self, index: usize) -> f64 {
        [1.0, 5.0][index]
    }
    fn parameter(&self, index: usize) -> Quantity<'_> {
        let (name, unit, _) = PARAMETERS[index];
        Quantity { name, unit, doc: "" }
    }
    fn parameter_default(&self, index: usize) -> f64 {
        PARAMETERS[index].2
    }
    fn output(&self, index: usize) -> Quantity<'_> {
        [
            Quantity { name: "spring_torque", unit: "N m", doc: "torque of the spring" },
            Quantity { name: "drive_torque", unit: "N m", doc: "torque that drives" },
        ][index]
    }
    fn rate_jacobian_pattern(&self) -> SparsityPattern<'_> {
        SparsityPattern { rows: 2, columns: 2, entries: &[(0, 1), (1, 0), (1, 1)] }
    }
    fn parameter_jacobian_pattern(&self) -> SparsityPattern<'_> {
        SparsityPattern { rows: 2, columns: 5, entries: &[(1, 0), (1, 1), (1, 2), (1, 3)] }
    }
    fn mass_matrix_pattern(&self) -> SparsityPattern<'_> {
        SparsityPattern { rows: 1, columns: 1, entries: &[(0, 0)] }
    }
    fn run_defaults(&self) -> RunDefaults<'_> {
        RunDefaults { from: 0.0, until: 3.0, points: 301, times: &[], rtol: 1e-8, method: "bdf" }
    }
}

impl<R: Real> Simulator<R> for Oscillator {
    fn initial_state(&self, _p: &[R], state: &mut [R]) {
        state.copy_from_slice(&[R::literal(0.4), R::literal(0.0)]);
    }
    fn discontinuities(&self, p: &[R], times: &mut [R]) {
        times[0] = p[4];
    }
    fn rate(&self, time: R, y: &[R], p: &[R], rate: &mut [R]) {
        rate[0] = y[1];
        rate[1] = (drive_torque(time, p) - p[1] * y[1] - p[2] * y[0]) / p[0];
    }
    fn rate_jacobian(&self, _time: R, _y: &[R], p: &[R], values: &mut [R]) {
        values.copy_from_slice(&[R::literal(1.0), -p[2] / p[0], -p[1] / p[0]]);
    }
    fn parameter_jacobian(&self, time: R, y: &[R], p: &[R], values: &mut [R]) {
        let force = drive_torque(time, p) - p[1] * y[1] - p[2] * y[0];
        let driven = drive_torque(time, p) / p[3];
        values.copy_from_slice(&[
            -force / (p[0] * p[0]),
            -y[1] / p[0],
            -y[0] / p[0],
            driven / p[0],
        ]);
    }
    fn time_derivative(&self, _time: R, _y: &[R], _p: &[R], derivative: &mut [R]) {
        derivative.fill(R::literal(0.0));
    }
    fn mass_matrix(&self, _time: R, _y: &[R], p: &[R], values: &mut [R]) {
        values[0] = p[0];
    }
    fn forcing(&self, time: R, y: &[R], p: &[R], forcing: &mut [R]) {
        forcing[0] = drive_torque(time, p) - p[1] * y[1] - p[2] * y[0];
    }
    fn outputs(&self, time: R, y: &[R], p: &[R], outputs: &mut [R]) {
        outputs[0] = p[2] * y[0];
        outputs[1] = drive_torque(time, p);
    }
    fn energy(&self, _time: R, y: &[R], p: &[R]) -> Energy<R> {
        let half = R::literal(0.5);
        Energy {
            kinetic: half * p[0] * y[1] * y[1],
            potential: half * p[2] * y[0] * y[0],
            stored: R::literal(0.0),
        }
    }
    fn power_balance(&self, time: R, y: &[R], p: &[R]) -> PowerBalance<R> {
        let supplied = drive_torque(time, p) * y[1];
        let dissipated = p[1] * y[1] * y[1];
        PowerBalance { stored_rate: supplied - dissipated, supplied, dissipated }
    }
    fn taylor(&self) -> Option<&dyn TaylorSeries<R>> {
        Some(self)
    }
    fn derivatives(&self) -> Option<&dyn Derivatives> {
        Some(self)
    }
}

impl<R: Real> TaylorSeries<R> for Oscillator {
    fn series_workspace(&self, _order: usize) -> usize {
        0
    }
    fn series(&self, time: R, y: &[R], p: &[R], coefficients: &mut [R], _workspace: &mut [R]) {
        coefficients[..2].copy_from_slice(y);
        let mut order = R::literal(1.0);
        let mut torque = drive_torque(time, p);
        for k in 1..coefficients.len() / 2 {
            let [angle, speed] = [coefficients[2 * k - 2], coefficients[2 * k - 1]];
            coefficients[2 * k] = speed / order;
            coefficients[2 * k + 1] = (torque - p[1] * speed - p[2] * angle) / p[0] / order;
            order = order + R::literal(1.0);
            torque = R::literal(0.0);
        }
    }
}

fn drive_torque<R: Real>(time: R, p: &[R]) -> R {
    R::select_less(time, p[4], R::literal(0.0), p[3])
}

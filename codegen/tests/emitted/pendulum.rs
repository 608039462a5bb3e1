// Emitted by Machinist 0.1.0; do not edit. To make it again:
//
//     cargo build
//
// Sources, with SHA-256:
//   e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855  scenes/pendulum.toml
//
// Damped pendulum
//
// A point mass on a rod.
//
// Its torque follows a table with a lag.
//
// Source:
//   Worked out on paper.
//
// Shapes; all quantities are in SI units:
//   coordinates               1
//   first-order states        1
//   states                    3
//   parameters                6
//   outputs                   2
//   discontinuities           1
//
// State:
//     0  arm.phi       [rad]    angle from the vertical
//     1  arm.phi_dot   [rad/s]  speed of arm.phi
//     2  drive.torque  [N m]    torque on the arm
//
// Nonzeros:
//   mass_matrix               1 of 1 by 1
//   rate_jacobian             5 of 3 by 3
//   parameter_jacobian        2 of 3 by 6
//
// Operations:
//   initial_state             0
//   discontinuities           0
//   rate                     14
//   mass_matrix               2
//   forcing                   7
//   rate_jacobian            13
//   parameter_jacobian        7
//   time_derivative           3
//   outputs                   3
//   energy                   10
//   power_balance             4
// With constants of the parameters, prepared once a run:
//   prepare                   9
//   prepared_rate            10
//   prepared_rate_jacobian    4

use ::machinist_contract::{
    CubicTable, Describe, Energy, PowerBalance, Quantity, Real, RunDefaults, Shape,
    Simulator, SparsityPattern, taylor::{Bends, Lanes, TaylorSeries, order_and_inverse},
};

/// Generalized coordinates, n.
pub const COORDINATES: usize = 1;

/// Length of the state y.
pub const STATES: usize = 3;

/// Parameters.
pub const PARAMETERS: usize = 6;

/// Wanted outputs.
pub const OUTPUTS: usize = 2;

/// Times at which the right-hand side jumps.
pub const DISCONTINUITIES: usize = 1;

/// Nonzeros of M, both triangles.
pub const MASS_MATRIX_PATTERN: SparsityPattern<'static> = SparsityPattern {
    rows: 1,
    columns: 1,
    entries: &[(0, 0)],
};

/// Nonzeros of dy'/dy.
pub const RATE_JACOBIAN_PATTERN: SparsityPattern<'static> = SparsityPattern {
    rows: 3,
    columns: 3,
    entries: &[(0, 1), (1, 0), (1, 1), (1, 2), (2, 2)],
};

/// Nonzeros of dy'/dp.
pub const PARAMETER_JACOBIAN_PATTERN: SparsityPattern<'static> = SparsityPattern {
    rows: 3,
    columns: 6,
    entries: &[(1, 2), (1, 3)],
};

/// Damped pendulum
///
/// A point mass on a rod.
///
/// Its torque follows a table with a lag.
///
/// Source: Worked out on paper.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Pendulum;

/// Parameters, in SI units; the default holds the values of the spec.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Parameters<R> {
    /// arm.mass: mass of the bob \[kg\]. In the spec: 4.2.
    pub arm_mass: R,
    /// arm.length: length of the rod \[m\]. In the spec: 0.75.
    pub arm_length: R,
    /// arm.gravity: acceleration of free fall \[m/s^2\]. In the spec: 9.80665.
    pub arm_gravity: R,
    /// arm.damping: viscous damping of the pivot \[N m s/rad\]. In the spec: 0.1285346.
    pub arm_damping: R,
    /// drive.lag: time constant of the drive \[s\]. In the spec: 0.01.
    pub drive_lag: R,
    /// start: time at which the drive starts \[s\]. In the spec: 0.1.
    pub start: R,
}

impl<R: Real> Parameters<R> {
    /// From the numbers in their order.
    #[must_use]
    #[inline]
    pub fn from_array(values: [R; PARAMETERS]) -> Self {
        Self {
            arm_mass: values[0],
            arm_length: values[1],
            arm_gravity: values[2],
            arm_damping: values[3],
            drive_lag: values[4],
            start: values[5],
        }
    }
    /// The numbers in their order.
    #[must_use]
    #[inline]
    pub fn to_array(self) -> [R; PARAMETERS] {
        [
            self.arm_mass,
            self.arm_length,
            self.arm_gravity,
            self.arm_damping,
            self.drive_lag,
            self.start,
        ]
    }
}

impl<R: Real> Default for Parameters<R> {
    fn default() -> Self {
        Self {
            arm_mass: R::literal(4.2),
            arm_length: R::literal(0.75),
            arm_gravity: R::literal(9.80665),
            arm_damping: R::literal(0.128_534_6),
            drive_lag: R::literal(0.01),
            start: R::literal(0.1),
        }
    }
}

/// Wanted outputs, in SI units.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Outputs<R> {
    /// height: height of the bob \[m\].
    pub height: R,
    /// deflection \[rad\].
    pub deflection: R,
}

impl<R: Real> Outputs<R> {
    /// From the numbers in their order.
    #[must_use]
    #[inline]
    pub fn from_array(values: [R; OUTPUTS]) -> Self {
        Self {
            height: values[0],
            deflection: values[1],
        }
    }
    /// The numbers in their order.
    #[must_use]
    #[inline]
    pub fn to_array(self) -> [R; OUTPUTS] {
        [self.height, self.deflection]
    }
}

/// Where to find what in the state.
pub mod state {
    /// arm.phi: angle from the vertical \[rad\].
    pub const ARM_PHI: usize = 0;
    /// arm.phi_dot: speed of arm.phi \[rad/s\].
    pub const ARM_PHI_DOT: usize = 1;
    /// drive.torque: torque on the arm \[N m\].
    pub const DRIVE_TORQUE: usize = 2;
}

/// Constants that `prepare` computes.
pub const CONSTANTS: usize = 5;

#[allow(missing_docs, reason = "`prepare` says what each is")]
/// What parameters alone decide; `prepare` says what each is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Constants<R> {
    pub t0: R,
    pub inertia: R,
    pub arm_phi_dot_dot_by_arm_phi_dot: R,
    pub arm_phi_dot_dot_by_drive_torque: R,
    pub drive_torque_dot_by_drive_torque: R,
}

impl<R: Real> Constants<R> {
    /// From the numbers in their order.
    #[must_use]
    #[inline]
    pub fn from_array(values: [R; CONSTANTS]) -> Self {
        Self {
            t0: values[0],
            inertia: values[1],
            arm_phi_dot_dot_by_arm_phi_dot: values[2],
            arm_phi_dot_dot_by_drive_torque: values[3],
            drive_torque_dot_by_drive_torque: values[4],
        }
    }
    /// The numbers in their order.
    #[must_use]
    #[inline]
    pub fn to_array(self) -> [R; CONSTANTS] {
        [
            self.t0,
            self.inertia,
            self.arm_phi_dot_dot_by_arm_phi_dot,
            self.arm_phi_dot_dot_by_drive_torque,
            self.drive_torque_dot_by_drive_torque,
        ]
    }
}

/// What `rate` and `rate_jacobian` need of the parameters, once a run.
///
/// 9 operations.
#[must_use]
#[inline]
pub fn prepare<R: Real>(p: &Parameters<R>) -> Constants<R> {
    let t0 = p.arm_mass * p.arm_gravity * p.arm_length;
    let inertia = p.arm_mass * p.arm_length.powi(2);
    let arm_phi_dot_dot_by_arm_phi_dot = -(p.arm_damping / inertia);
    let arm_phi_dot_dot_by_drive_torque = R::literal(1.0) / inertia;
    let drive_torque_dot_by_drive_torque = -(R::literal(1.0) / p.drive_lag);
    Constants {
        t0,
        inertia,
        arm_phi_dot_dot_by_arm_phi_dot,
        arm_phi_dot_dot_by_drive_torque,
        drive_torque_dot_by_drive_torque,
    }
}

/// State at the start of the run, in the units of the states.
///
/// No operations.
#[must_use]
pub fn initial_state<R: Real>(_p: &Parameters<R>) -> [R; STATES] {
    [R::literal(0.5), R::literal(0.0), R::literal(0.0)]
}

/// Times at which the right-hand side jumps \[s\].
///
/// No operations.
#[must_use]
pub fn discontinuities<R: Real>(p: &Parameters<R>) -> [R; DISCONTINUITIES] {
    [p.start]
}

/// `y'`: velocities, `M^-1 f`, `h`; in the units of the states per second.
///
/// 14 operations.
#[must_use]
#[inline]
pub fn rate<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>) -> [R; STATES] {
    prepared_rate(time, state, p, &prepare(p))
}

/// As `rate`, with the constants of the parameters from `prepare`.
///
/// 10 operations.
#[must_use]
#[inline]
pub fn prepared_rate<R: Real>(
    time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
    c: &Constants<R>,
) -> [R; STATES] {
    let [arm_phi, arm_phi_dot, drive_torque] = *state;
    let arm_phi_dot_dot = drive_torque
        .sub_product(p.arm_damping, arm_phi_dot)
        .sub_product(c.t0, arm_phi.sin()) / c.inertia;
    let load = R::select_less(
        time,
        p.start,
        R::literal(0.0),
        R::interpolate(&DRIVE_LOAD_TABLE, 0, time),
    );
    let drive_torque_dot = (load - drive_torque) / p.drive_lag;
    [arm_phi_dot, arm_phi_dot_dot, drive_torque_dot]
}

/// `M = d2L/dq'2`, values in the order of `MASS_MATRIX_PATTERN`.
///
/// 2 operations.
#[must_use]
pub fn mass_matrix<R: Real>(
    _time: R,
    _state: &[R; STATES],
    p: &Parameters<R>,
) -> [R; 1] {
    let inertia = p.arm_mass * p.arm_length.powi(2);
    [inertia]
}

/// `f` of `M q'' = f(q, q', z, t)`, one for each coordinate.
///
/// 7 operations.
#[must_use]
pub fn forcing<R: Real>(
    _time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
) -> [R; COORDINATES] {
    let [arm_phi, arm_phi_dot, drive_torque] = *state;
    let arm_phi_forcing = drive_torque
        .sub_product(p.arm_damping, arm_phi_dot)
        .sub_product(p.arm_mass * p.arm_gravity * p.arm_length, arm_phi.sin());
    [arm_phi_forcing]
}

/// `dy'/dy`, values in the order of `RATE_JACOBIAN_PATTERN`.
///
/// 13 operations.
#[must_use]
#[inline]
pub fn rate_jacobian<R: Real>(
    time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
) -> [R; 5] {
    prepared_rate_jacobian(time, state, p, &prepare(p))
}

/// As `rate_jacobian`, with the constants of the parameters from `prepare`.
///
/// 4 operations.
#[must_use]
pub fn prepared_rate_jacobian<R: Real>(
    _time: R,
    state: &[R; STATES],
    _p: &Parameters<R>,
    c: &Constants<R>,
) -> [R; 5] {
    let [arm_phi, ..] = *state;
    let arm_phi_dot_dot_by_arm_phi = -(c.t0 * arm_phi.cos() / c.inertia);
    [
        R::literal(1.0),
        arm_phi_dot_dot_by_arm_phi,
        c.arm_phi_dot_dot_by_arm_phi_dot,
        c.arm_phi_dot_dot_by_drive_torque,
        c.drive_torque_dot_by_drive_torque,
    ]
}

/// `dy'/dp`, values in the order of `PARAMETER_JACOBIAN_PATTERN`.
///
/// 7 operations.
#[must_use]
pub fn parameter_jacobian<R: Real>(
    _time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
) -> [R; 2] {
    let [arm_phi, arm_phi_dot, ..] = *state;
    let arm_phi_dot_dot_by_arm_gravity = -(arm_phi.sin() / p.arm_length);
    let inertia = p.arm_mass * p.arm_length.powi(2);
    let arm_phi_dot_dot_by_arm_damping = -(arm_phi_dot / inertia);
    [arm_phi_dot_dot_by_arm_gravity, arm_phi_dot_dot_by_arm_damping]
}

/// Partial derivative of `y'` with respect to time.
///
/// 3 operations.
#[must_use]
pub fn time_derivative<R: Real>(
    time: R,
    _state: &[R; STATES],
    p: &Parameters<R>,
) -> [R; STATES] {
    let drive_torque_dot_by_time = R::select_less(
        time,
        p.start,
        R::literal(0.0),
        R::interpolate(&DRIVE_LOAD_TABLE, 1, time),
    ) / p.drive_lag;
    [R::literal(0.0), R::literal(0.0), drive_torque_dot_by_time]
}

/// Wanted outputs.
///
/// 3 operations.
#[must_use]
pub fn outputs<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>) -> Outputs<R> {
    let [arm_phi, ..] = *state;
    Outputs {
        height: p.arm_length * (R::literal(1.0) - arm_phi.cos()),
        deflection: arm_phi,
    }
}

/// T, V and the energy of first-order states \[J\].
///
/// 10 operations.
#[must_use]
pub fn energy<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>) -> Energy<R> {
    let [arm_phi, arm_phi_dot, ..] = *state;
    let inertia = p.arm_mass * p.arm_length.powi(2);
    Energy {
        kinetic: inertia * arm_phi_dot.powi(2) / R::literal(2.0),
        potential: p.arm_mass * p.arm_gravity
            * (p.arm_length * (R::literal(1.0) - arm_phi.cos())),
        stored: R::literal(0.0),
    }
}

/// `dE/dt`, power supplied and power dissipated \[W\].
///
/// 4 operations.
#[must_use]
pub fn power_balance<R: Real>(
    _time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
) -> PowerBalance<R> {
    let [_, arm_phi_dot, drive_torque] = *state;
    let supplied = drive_torque * arm_phi_dot;
    let dissipated = p.arm_damping * arm_phi_dot.powi(2);
    PowerBalance {
        stored_rate: supplied - dissipated,
        supplied,
        dissipated,
    }
}

/// Normalized Taylor coefficients of the solution through `state`, order after order.
///
/// `_k` marks the coefficient of order k, `_before` that of order k - 1; bare names are
/// zeroth coefficients. The workspace is as `series_workspace` says.
///
/// 31 recurrences. 4 sums of products an order.
///
/// # Panics
/// If there is no room for the zeroth coefficients, or the workspace is too short.
pub fn series<R: Real>(
    time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
    coefficients: &mut [[R; STATES]],
    workspace: &mut [R],
) {
    let (mut lanes, _) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let [arm_phi, arm_phi_dot, drive_torque] = *state;
    let t0 = arm_phi_dot * p.arm_damping;
    let t1 = drive_torque - t0;
    let sin_arm_phi = arm_phi.sin();
    let cos_arm_phi = arm_phi.cos();
    let t2 = p.arm_mass * p.arm_gravity;
    let t3 = t2 * p.arm_length;
    let t4 = sin_arm_phi * t3;
    let t5 = t1 - t4;
    let t6 = p.arm_length.powi(2);
    let inertia = p.arm_mass * t6;
    let t7 = R::literal(1.0) / inertia;
    let t8 = t5 * t7;
    let t9 = R::interpolate(&DRIVE_LOAD_TABLE, 0, time);
    let load = R::select_less(time, p.start, R::literal(0.0), t9);
    let t10 = load - drive_torque;
    let t11 = R::literal(1.0) / p.drive_lag;
    let t12 = t10 * t11;
    let t9_first = R::interpolate(&DRIVE_LOAD_TABLE, 1, time);
    let t9_second = R::literal(0.5) * R::interpolate(&DRIVE_LOAD_TABLE, 2, time);
    let t9_third = R::literal(1.0 / 6.0) * R::interpolate(&DRIVE_LOAD_TABLE, 3, time);
    let mut rates = [arm_phi_dot, t8, t12];
    coefficients[0] = *state;
    let highest = coefficients.len() - 1;
    for (order, state_k) in coefficients.iter_mut().enumerate().skip(1) {
        let (k, inverse) = order_and_inverse::<R>(order);
        *state_k = rates.map(|rate| rate * inverse);
        if order == highest {
            break;
        }
        let [arm_phi_k, arm_phi_dot_k, drive_torque_k] = *state_k;
        let sums = lanes.sums(order);
        let t1_k = (-arm_phi_dot_k).mul_add(p.arm_damping, drive_torque_k);
        let sin_arm_phi_k = arm_phi_k.mul_add(cos_arm_phi, inverse * sums[1]);
        let cos_arm_phi_k = -arm_phi_k.mul_add(sin_arm_phi, inverse * sums[2]);
        let t5_k = (-sin_arm_phi_k).mul_add(t3, t1_k);
        let t8_k = t5_k * t7;
        let time_k = R::literal(if order == 1 { 1.0 } else { 0.0 });
        let t9_k = t9_first * time_k + t9_second * sums[0] + t9_third * sums[3];
        let load_k = R::select_less(time, p.start, R::literal(0.0), t9_k);
        let t10_k = load_k - drive_torque_k;
        let t12_k = t10_k * t11;
        lanes
            .set(
                order,
                [time_k, k * arm_phi_k, k * arm_phi_k, time_k],
                [time_k, cos_arm_phi_k, sin_arm_phi_k, sums[0]],
            );
        rates = [arm_phi_dot_k, t8_k, t12_k];
    }
}

impl<R: Real> TaylorSeries<R> for Pendulum {
    fn series_workspace(&self, order: usize) -> usize {
        Lanes::<R, 4>::workspace(order + 1)
    }
    fn series(
        &self,
        time: R,
        state: &[R],
        parameters: &[R],
        coefficients: &mut [R],
        workspace: &mut [R],
    ) {
        let (coefficients, rest) = coefficients.as_chunks_mut();
        assert!(rest.is_empty(), "every order has STATES coefficients");
        let p = parameters_of(parameters);
        series(time, state_of(state), &p, coefficients, workspace);
    }
    fn bends(&self) -> Bends {
        Bends::Corners
    }
}

impl Describe for Pendulum {
    fn name(&self) -> &'static str {
        "pendulum"
    }
    fn title(&self) -> &'static str {
        "Damped pendulum"
    }
    fn shape(&self) -> Shape {
        Shape {
            coordinates: COORDINATES,
            positions: 1,
            first_order: 1,
            quadratures: 0,
            parameters: PARAMETERS,
            outputs: OUTPUTS,
            discontinuities: DISCONTINUITIES,
        }
    }
    fn state(&self, index: usize) -> Quantity<'_> {
        STATE_QUANTITIES[index]
    }
    fn state_scale(&self, index: usize) -> f64 {
        STATE_SCALES[index]
    }
    fn parameter(&self, index: usize) -> Quantity<'_> {
        PARAMETER_QUANTITIES[index]
    }
    fn parameter_default(&self, index: usize) -> f64 {
        PARAMETER_DEFAULTS[index]
    }
    fn output(&self, index: usize) -> Quantity<'_> {
        OUTPUT_QUANTITIES[index]
    }
    fn rate_jacobian_pattern(&self) -> SparsityPattern<'_> {
        RATE_JACOBIAN_PATTERN
    }
    fn parameter_jacobian_pattern(&self) -> SparsityPattern<'_> {
        PARAMETER_JACOBIAN_PATTERN
    }
    fn mass_matrix_pattern(&self) -> SparsityPattern<'_> {
        MASS_MATRIX_PATTERN
    }
    fn run_defaults(&self) -> RunDefaults<'_> {
        RUN_DEFAULTS
    }
}

impl<R: Real> Simulator<R> for Pendulum {
    fn constants(&self) -> usize {
        CONSTANTS
    }
    fn prepare(&self, parameters: &[R], constants: &mut [R]) {
        *array_of(constants) = prepare(&parameters_of(parameters)).to_array();
    }
    fn prepared_rate(
        &self,
        time: R,
        state: &[R],
        parameters: &[R],
        constants: &[R],
        values: &mut [R],
    ) {
        let (p, c) = (parameters_of(parameters), constants_of(constants));
        *array_of(values) = prepared_rate(time, state_of(state), &p, &c);
    }
    fn prepared_rate_jacobian(
        &self,
        time: R,
        state: &[R],
        parameters: &[R],
        constants: &[R],
        values: &mut [R],
    ) {
        let (p, c) = (parameters_of(parameters), constants_of(constants));
        *array_of(values) = prepared_rate_jacobian(time, state_of(state), &p, &c);
    }
    fn initial_state(&self, parameters: &[R], values: &mut [R]) {
        *array_of(values) = initial_state(&parameters_of(parameters));
    }
    fn discontinuities(&self, parameters: &[R], values: &mut [R]) {
        *array_of(values) = discontinuities(&parameters_of(parameters));
    }
    fn rate(&self, time: R, state: &[R], parameters: &[R], values: &mut [R]) {
        *array_of(values) = rate(time, state_of(state), &parameters_of(parameters));
    }
    fn rate_jacobian(&self, time: R, state: &[R], parameters: &[R], values: &mut [R]) {
        *array_of(values) = rate_jacobian(
            time,
            state_of(state),
            &parameters_of(parameters),
        );
    }
    fn parameter_jacobian(
        &self,
        time: R,
        state: &[R],
        parameters: &[R],
        values: &mut [R],
    ) {
        *array_of(values) = parameter_jacobian(
            time,
            state_of(state),
            &parameters_of(parameters),
        );
    }
    fn time_derivative(&self, time: R, state: &[R], parameters: &[R], values: &mut [R]) {
        *array_of(values) = time_derivative(
            time,
            state_of(state),
            &parameters_of(parameters),
        );
    }
    fn mass_matrix(&self, time: R, state: &[R], parameters: &[R], values: &mut [R]) {
        *array_of(values) = mass_matrix(
            time,
            state_of(state),
            &parameters_of(parameters),
        );
    }
    fn forcing(&self, time: R, state: &[R], parameters: &[R], values: &mut [R]) {
        *array_of(values) = forcing(time, state_of(state), &parameters_of(parameters));
    }
    fn outputs(&self, time: R, state: &[R], parameters: &[R], values: &mut [R]) {
        *array_of(values) = outputs(time, state_of(state), &parameters_of(parameters))
            .to_array();
    }
    fn energy(&self, time: R, state: &[R], parameters: &[R]) -> Energy<R> {
        energy(time, state_of(state), &parameters_of(parameters))
    }
    fn power_balance(&self, time: R, state: &[R], parameters: &[R]) -> PowerBalance<R> {
        power_balance(time, state_of(state), &parameters_of(parameters))
    }
    fn taylor(&self) -> Option<&dyn TaylorSeries<R>> {
        Some(self)
    }
}

#[inline]
fn constants_of<R: Real>(constants: &[R]) -> Constants<R> {
    let values: &[R; CONSTANTS] = constants
        .try_into()
        .expect("there are CONSTANTS constants");
    Constants::from_array(*values)
}

#[inline]
fn array_of<R, const N: usize>(values: &mut [R]) -> &mut [R; N] {
    values.try_into().expect("there is one place for each value")
}

#[inline]
fn state_of<R>(state: &[R]) -> &[R; STATES] {
    state.try_into().expect("the state has STATES entries")
}

#[inline]
fn parameters_of<R: Real>(parameters: &[R]) -> Parameters<R> {
    let values: &[R; PARAMETERS] = parameters
        .try_into()
        .expect("there are PARAMETERS parameters");
    Parameters::from_array(*values)
}

static STATE_QUANTITIES: [Quantity<'static>; STATES] = [
    Quantity {
        name: "arm.phi",
        unit: "rad",
        doc: "angle from the vertical",
    },
    Quantity {
        name: "arm.phi_dot",
        unit: "rad/s",
        doc: "speed of arm.phi",
    },
    Quantity {
        name: "drive.torque",
        unit: "N m",
        doc: "torque on the arm",
    },
];

static STATE_SCALES: [f64; STATES] = [1.0, 10.0, 100.0];

static PARAMETER_QUANTITIES: [Quantity<'static>; PARAMETERS] = [
    Quantity {
        name: "arm.mass",
        unit: "kg",
        doc: "mass of the bob",
    },
    Quantity {
        name: "arm.length",
        unit: "m",
        doc: "length of the rod",
    },
    Quantity {
        name: "arm.gravity",
        unit: "m/s^2",
        doc: "acceleration of free fall",
    },
    Quantity {
        name: "arm.damping",
        unit: "N m s/rad",
        doc: "viscous damping of the pivot",
    },
    Quantity {
        name: "drive.lag",
        unit: "s",
        doc: "time constant of the drive",
    },
    Quantity {
        name: "start",
        unit: "s",
        doc: "time at which the drive starts",
    },
];

static PARAMETER_DEFAULTS: [f64; PARAMETERS] = [
    4.2,
    0.75,
    9.80665,
    0.128_534_6,
    0.01,
    0.1,
];

static OUTPUT_QUANTITIES: [Quantity<'static>; OUTPUTS] = [
    Quantity {
        name: "height",
        unit: "m",
        doc: "height of the bob",
    },
    Quantity {
        name: "deflection",
        unit: "rad",
        doc: "",
    },
];

/// The run the spec asks for.
pub const RUN_DEFAULTS: RunDefaults<'static> = RunDefaults {
    from: 0.0,
    until: 2.0,
    points: 1001,
    rtol: 1e-8,
    method: "bdf",
};

/// Natural cubic spline drive.load.
pub static DRIVE_LOAD_TABLE: CubicTable<'static> = CubicTable {
    knots: &[0.0, 1.0, 3.0],
    coefficients: &[[0.0, 1.25, 0.0, -0.25], [1.0, 0.5, -0.75, 0.125]],
};

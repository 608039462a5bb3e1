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
//   coordinates               2
//   first-order states        0
//   states                    4
//   parameters                6
//   outputs                   0
//   discontinuities           0
//
// State:
//     0  q_0      [rad]
//     1  q_1      [rad]
//     2  q_0_dot  [rad/s]
//     3  q_1_dot  [rad/s]
//
// Nonzeros:
//   mass_matrix               4 of 2 by 2
//   rate_jacobian             0 of 4 by 4
//   parameter_jacobian        0 of 4 by 6
//
// Operations:
//   initial_state             0
//   discontinuities           0
//   rate                     27
//   mass_matrix               2
//   forcing                  16
//   rate_jacobian             0
//   parameter_jacobian        0
//   time_derivative           0
//   outputs                   0
//   energy                   10
//   power_balance             4
// With constants of the parameters, prepared once a run:
//   prepare                   2
//   prepared_rate            25
//   prepared_rate_jacobian    0

use ::machinist_contract::{
    CubicTable, Describe, Energy, PowerBalance, Quantity, Real, RunDefaults, Shape,
    Simulator, SparsityPattern,
    taylor::{Factored, Lanes, TaylorSeries, order_and_inverse},
};

/// Generalized coordinates, n.
pub const COORDINATES: usize = 2;

/// Length of the state y.
pub const STATES: usize = 4;

/// Parameters.
pub const PARAMETERS: usize = 6;

/// Wanted outputs.
pub const OUTPUTS: usize = 0;

/// Times at which the right-hand side jumps.
pub const DISCONTINUITIES: usize = 0;

/// Nonzeros of M, both triangles.
pub const MASS_MATRIX_PATTERN: SparsityPattern<'static> = SparsityPattern {
    rows: 2,
    columns: 2,
    entries: &[(0, 0), (0, 1), (1, 0), (1, 1)],
};

/// Nonzeros of dy'/dy.
pub const RATE_JACOBIAN_PATTERN: SparsityPattern<'static> = SparsityPattern {
    rows: 4,
    columns: 4,
    entries: &[],
};

/// Nonzeros of dy'/dp.
pub const PARAMETER_JACOBIAN_PATTERN: SparsityPattern<'static> = SparsityPattern {
    rows: 4,
    columns: 6,
    entries: &[],
};

/// Damped pendulum
///
/// A point mass on a rod.
///
/// Its torque follows a table with a lag.
///
/// Source: Worked out on paper.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Coupled;

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
    /// Nothing; there are no numbers here.
    pub real: core::marker::PhantomData<R>,
}

impl<R: Real> Outputs<R> {
    /// From the numbers in their order.
    #[must_use]
    #[inline]
    pub fn from_array(_values: [R; OUTPUTS]) -> Self {
        Self {
            real: core::marker::PhantomData,
        }
    }
    /// The numbers in their order.
    #[must_use]
    #[inline]
    pub fn to_array(self) -> [R; OUTPUTS] {
        []
    }
}

/// Where to find what in the state.
pub mod state {
    /// q_0 \[rad\].
    pub const Q_0: usize = 0;
    /// q_1 \[rad\].
    pub const Q_1: usize = 1;
    /// q_0_dot \[rad/s\].
    pub const Q_0_DOT: usize = 2;
    /// q_1_dot \[rad/s\].
    pub const Q_1_DOT: usize = 3;
}

/// Constants that `prepare` computes.
pub const CONSTANTS: usize = 2;

#[allow(missing_docs, reason = "`prepare` says what each is")]
/// What parameters alone decide; `prepare` says what each is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Constants<R> {
    pub t0: R,
    pub t1: R,
}

impl<R: Real> Constants<R> {
    /// From the numbers in their order.
    #[must_use]
    #[inline]
    pub fn from_array(values: [R; CONSTANTS]) -> Self {
        Self {
            t0: values[0],
            t1: values[1],
        }
    }
    /// The numbers in their order.
    #[must_use]
    #[inline]
    pub fn to_array(self) -> [R; CONSTANTS] {
        [self.t0, self.t1]
    }
}

/// What `rate` and `rate_jacobian` need of the parameters, once a run.
///
/// 2 operations.
#[must_use]
#[inline]
pub fn prepare<R: Real>(p: &Parameters<R>) -> Constants<R> {
    let t0 = R::literal(2.0) * p.arm_gravity;
    let t1 = R::literal(1.0) * p.arm_gravity;
    Constants { t0, t1 }
}

/// State at the start of the run, in the units of the states.
///
/// No operations.
#[must_use]
pub fn initial_state<R: Real>(_p: &Parameters<R>) -> [R; STATES] {
    [R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0)]
}

/// Times at which the right-hand side jumps \[s\].
///
/// No operations.
#[must_use]
pub fn discontinuities<R: Real>(_p: &Parameters<R>) -> [R; DISCONTINUITIES] {
    []
}

/// `y'`: velocities, `M^-1 f`, `h`; in the units of the states per second.
///
/// 27 operations.
#[must_use]
#[inline]
pub fn rate<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>) -> [R; STATES] {
    prepared_rate(time, state, p, &prepare(p))
}

/// As `rate`, with the constants of the parameters from `prepare`.
///
/// 25 operations.
#[must_use]
#[inline]
pub fn prepared_rate<R: Real>(
    _time: R,
    state: &[R; STATES],
    _p: &Parameters<R>,
    c: &Constants<R>,
) -> [R; STATES] {
    let [q_0, q_1, q_0_dot, q_1_dot] = *state;
    let q_0_minus_q_1 = q_0 - q_1;
    let [(sin_q_0_minus_q_1, cos_q_0_minus_q_1), (sin_q_1_minus_q_0, _), (sin_q_0, _),
    (sin_q_1, _)] = R::sin_cos_each([q_0_minus_q_1, q_1 - q_0, q_0, q_1]);
    let t0 = (-(c.t0 * sin_q_0)).add_product(sin_q_1_minus_q_0, q_1_dot.powi(2));
    let t1 = (-(c.t1 * sin_q_1)).add_product(sin_q_0_minus_q_1, q_0_dot.powi(2));
    let t2 = R::literal(2.0).sub_product(cos_q_0_minus_q_1, cos_q_0_minus_q_1);
    let q_0_dot_dot = (R::literal(1.0) * t0).sub_product(cos_q_0_minus_q_1, t1) / t2;
    let q_1_dot_dot = (R::literal(2.0) * t1).sub_product(cos_q_0_minus_q_1, t0) / t2;
    [q_0_dot, q_1_dot, q_0_dot_dot, q_1_dot_dot]
}

/// `M = d2L/dq'2`, values in the order of `MASS_MATRIX_PATTERN`.
///
/// 2 operations.
#[must_use]
pub fn mass_matrix<R: Real>(
    _time: R,
    state: &[R; STATES],
    _p: &Parameters<R>,
) -> [R; 4] {
    let [q_0, q_1, ..] = *state;
    let cos_q_0_minus_q_1 = (q_0 - q_1).cos();
    [R::literal(2.0), cos_q_0_minus_q_1, cos_q_0_minus_q_1, R::literal(1.0)]
}

/// `f` of `M q'' = f(q, q', z, t)`, one for each coordinate.
///
/// 16 operations.
#[must_use]
pub fn forcing<R: Real>(
    _time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
) -> [R; COORDINATES] {
    let [q_0, q_1, q_0_dot, q_1_dot] = *state;
    let [(sin_q_1_minus_q_0, _), (sin_q_0, _), (sin_q_0_minus_q_1, _), (sin_q_1, _)] = R::sin_cos_each([
        q_1 - q_0,
        q_0,
        q_0 - q_1,
        q_1,
    ]);
    let q_0_forcing = (-(R::literal(2.0) * p.arm_gravity * sin_q_0))
        .add_product(sin_q_1_minus_q_0, q_1_dot.powi(2));
    let q_1_forcing = (-(R::literal(1.0) * p.arm_gravity * sin_q_1))
        .add_product(sin_q_0_minus_q_1, q_0_dot.powi(2));
    [q_0_forcing, q_1_forcing]
}

/// `dy'/dy`, values in the order of `RATE_JACOBIAN_PATTERN`.
///
/// No operations.
#[must_use]
#[inline]
pub fn rate_jacobian<R: Real>(
    time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
) -> [R; 0] {
    prepared_rate_jacobian(time, state, p, &prepare(p))
}

/// As `rate_jacobian`, with the constants of the parameters from `prepare`.
///
/// No operations.
#[must_use]
pub fn prepared_rate_jacobian<R: Real>(
    _time: R,
    _state: &[R; STATES],
    _p: &Parameters<R>,
    _c: &Constants<R>,
) -> [R; 0] {
    []
}

/// `dy'/dp`, values in the order of `PARAMETER_JACOBIAN_PATTERN`.
///
/// No operations.
#[must_use]
pub fn parameter_jacobian<R: Real>(
    _time: R,
    _state: &[R; STATES],
    _p: &Parameters<R>,
) -> [R; 0] {
    []
}

/// Partial derivative of `y'` with respect to time.
///
/// No operations.
#[must_use]
pub fn time_derivative<R: Real>(
    _time: R,
    _state: &[R; STATES],
    _p: &Parameters<R>,
) -> [R; STATES] {
    [R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0)]
}

/// Wanted outputs.
///
/// No operations.
#[must_use]
pub fn outputs<R: Real>(
    _time: R,
    _state: &[R; STATES],
    _p: &Parameters<R>,
) -> Outputs<R> {
    Outputs {
        real: core::marker::PhantomData,
    }
}

/// T, V and the energy of first-order states \[J\].
///
/// 10 operations.
#[must_use]
pub fn energy<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>) -> Energy<R> {
    let [q_0, q_1, ..] = *state;
    let inertia = p.arm_mass * p.arm_length.powi(2);
    Energy {
        kinetic: inertia * q_1.powi(2) / R::literal(2.0),
        potential: p.arm_mass * p.arm_gravity
            * (p.arm_length * (R::literal(1.0) - q_0.cos())),
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
    let [_, q_1, q_0_dot, ..] = *state;
    let supplied = q_0_dot * q_1;
    let dissipated = p.arm_damping * q_1.powi(2);
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
/// 31 recurrences. 12 sums of products an order.
///
/// # Panics
/// If there is no room for the zeroth coefficients, or the workspace is too short.
pub fn series<R: Real>(
    _time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
    coefficients: &mut [[R; STATES]],
    workspace: &mut [R],
) {
    let (mut lanes, workspace) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let (mut lanes_1, workspace) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let (mut lanes_2, _) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let [q_0, q_1, q_0_dot, q_1_dot] = *state;
    let t0 = q_0 - q_1;
    let t1 = t0.sin();
    let t2 = t0.cos();
    let t3 = -t1;
    let t4 = q_1_dot * q_1_dot;
    let t5 = t3 * t4;
    let t6 = R::literal(2.0) * p.arm_gravity;
    let sin_q_0 = q_0.sin();
    let cos_q_0 = q_0.cos();
    let t7 = sin_q_0 * t6;
    let t8 = t5 - t7;
    let t9 = q_0_dot * q_0_dot;
    let t10 = t1 * t9;
    let t11 = R::literal(1.0) * p.arm_gravity;
    let sin_q_1 = q_1.sin();
    let cos_q_1 = q_1.cos();
    let t12 = sin_q_1 * t11;
    let t13 = t10 - t12;
    let factored = Factored::new([
        [R::literal(2.0), R::literal(0.0)],
        [t2, R::literal(1.0)],
    ]);
    let [q_0_dot_dot, q_1_dot_dot] = factored.solve([t8, t13]);
    let mut rates = [q_0_dot, q_1_dot, q_0_dot_dot, q_1_dot_dot];
    coefficients[0] = *state;
    let highest = coefficients.len() - 1;
    for (order, state_k) in coefficients.iter_mut().enumerate().skip(1) {
        let (k, inverse) = order_and_inverse::<R>(order);
        *state_k = rates.map(|rate| rate * inverse);
        if order == highest {
            break;
        }
        let [q_0_k, q_1_k, q_0_dot_k, q_1_dot_k] = *state_k;
        let sums = lanes.sums(order);
        let sums_1 = lanes_1.sums(order);
        let sums_2 = lanes_2.sums(order);
        let t0_k = q_0_k - q_1_k;
        let t1_k = t0_k.mul_add(t2, inverse * sums_1[2]);
        let t2_k = -t0_k.mul_add(t1, inverse * sums_1[3]);
        let t3_k = -t1_k;
        let t4_k = (q_1_dot + q_1_dot).mul_add(q_1_dot_k, sums[0]);
        let t5_k = t4.mul_add(t3_k, t3.mul_add(t4_k, sums_2[1]));
        let sin_q_0_k = q_0_k.mul_add(cos_q_0, inverse * sums[2]);
        let cos_q_0_k = -q_0_k.mul_add(sin_q_0, inverse * sums[3]);
        let t8_k = (-sin_q_0_k).mul_add(t6, t5_k);
        let t9_k = (q_0_dot + q_0_dot).mul_add(q_0_dot_k, sums[1]);
        let t10_k = t9.mul_add(t1_k, t1.mul_add(t9_k, sums_2[0]));
        let sin_q_1_k = q_1_k.mul_add(cos_q_1, inverse * sums_1[0]);
        let cos_q_1_k = -q_1_k.mul_add(sin_q_1, inverse * sums_1[1]);
        let t13_k = (-sin_q_1_k).mul_add(t11, t10_k);
        let n27_k = t2_k.mul_add(q_1_dot_dot, sums_2[2]);
        let n28_k = t2_k.mul_add(q_0_dot_dot, sums_2[3]);
        let t8_k_2 = t8_k - n27_k;
        let t13_k_2 = t13_k - n28_k;
        let [q_0_dot_dot_k, q_1_dot_dot_k] = factored.solve([t8_k_2, t13_k_2]);
        lanes
            .set(
                order,
                [q_1_dot_k, q_0_dot_k, k * q_0_k, k * q_0_k],
                [q_1_dot_k, q_0_dot_k, cos_q_0_k, sin_q_0_k],
            );
        lanes_1
            .set(
                order,
                [k * q_1_k, k * q_1_k, k * t0_k, k * t0_k],
                [cos_q_1_k, sin_q_1_k, t2_k, t1_k],
            );
        lanes_2
            .set(
                order,
                [t1_k, t3_k, t2_k, t2_k],
                [t9_k, t4_k, q_1_dot_dot_k, q_0_dot_dot_k],
            );
        rates = [q_0_dot_k, q_1_dot_k, q_0_dot_dot_k, q_1_dot_dot_k];
    }
}

impl<R: Real> TaylorSeries<R> for Coupled {
    fn series_workspace(&self, order: usize) -> usize {
        Lanes::<R, 4>::workspace(order + 1) + Lanes::<R, 4>::workspace(order + 1)
            + Lanes::<R, 4>::workspace(order + 1)
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
}

impl Describe for Coupled {
    fn name(&self) -> &'static str {
        "coupled"
    }
    fn title(&self) -> &'static str {
        "Damped pendulum"
    }
    fn shape(&self) -> Shape {
        Shape {
            coordinates: COORDINATES,
            positions: 2,
            first_order: 0,
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

impl<R: Real> Simulator<R> for Coupled {
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
        name: "q_0",
        unit: "rad",
        doc: "",
    },
    Quantity {
        name: "q_1",
        unit: "rad",
        doc: "",
    },
    Quantity {
        name: "q_0_dot",
        unit: "rad/s",
        doc: "",
    },
    Quantity {
        name: "q_1_dot",
        unit: "rad/s",
        doc: "",
    },
];

static STATE_SCALES: [f64; STATES] = [1.0, 1.0, 10.0, 10.0];

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

static OUTPUT_QUANTITIES: [Quantity<'static>; OUTPUTS] = [];

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

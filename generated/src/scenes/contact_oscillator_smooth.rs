// Emitted by Machinist 0.1.0; do not edit. To make it again:
//
//     cargo run --release -- gen
//
// Sources, with SHA-256:
//   623629d455d12d8ac289b2f7651abfa544e0ce4f9b215a11f46b15b633e56a79  scenes/contact_oscillator_smooth.toml
//   f0db790170b6c3f134330c00617de69bb14585d0c566d62cfa2cc6117d09122a  units/sprung_mass.toml
//   e05d4b59e2dcb3fbd6a15912f703a3764b38a08608fe136fee7b6e165aabff5b  units/stop_smooth.toml
//
// Oscillator with a one-sided stop, smoothed
//
// The smooth twin of `contact_oscillator`.
//
// Source:
//   Textbook.
//
// Shapes; all quantities are in SI units:
//   coordinates               1
//   first-order states        0
//   states                    2
//   parameters                7
//   outputs                   2
//   discontinuities           0
//
// State:
//     0  oscillator.x  [m]    deflection of the spring
//     1  oscillator.v  [m/s]  rate of deflection of the spring
//
// Nonzeros:
//   mass_matrix               1 of 1 by 1
//   rate_jacobian             3 of 2 by 2
//   parameter_jacobian        6 of 2 by 7
//
// Operations:
//   initial_state             0
//   discontinuities           0
//   rate                     18
//   mass_matrix               0
//   forcing                  16
//   rate_jacobian            25
//   parameter_jacobian       44
//   time_derivative           0
//   outputs                   0
//   energy                   16
//   power_balance            24
// With constants of the parameters, prepared once a run:
//   prepare                   5
//   prepared_rate            15
//   prepared_rate_jacobian   20

use ::machinist_contract::{
    Describe, Energy, PowerBalance, Quantity, Real, RunDefaults, Shape, Simulator,
    SparsityPattern, taylor::{Lanes, TaylorSeries, order_and_inverse},
};

/// Generalized coordinates, n.
pub const COORDINATES: usize = 1;

/// Length of the state y.
pub const STATES: usize = 2;

/// Parameters.
pub const PARAMETERS: usize = 7;

/// Wanted outputs.
pub const OUTPUTS: usize = 2;

/// Times at which the right-hand side jumps.
pub const DISCONTINUITIES: usize = 0;

/// Nonzeros of M, both triangles.
pub const MASS_MATRIX_PATTERN: SparsityPattern<'static> = SparsityPattern {
    rows: 1,
    columns: 1,
    entries: &[(0, 0)],
};

/// Nonzeros of dy'/dy.
pub const RATE_JACOBIAN_PATTERN: SparsityPattern<'static> = SparsityPattern {
    rows: 2,
    columns: 2,
    entries: &[(0, 1), (1, 0), (1, 1)],
};

/// Nonzeros of dy'/dp.
pub const PARAMETER_JACOBIAN_PATTERN: SparsityPattern<'static> = SparsityPattern {
    rows: 2,
    columns: 7,
    entries: &[(1, 1), (1, 2), (1, 3), (1, 4), (1, 5), (1, 6)],
};

/// Oscillator with a one-sided stop, smoothed
///
/// The smooth twin of \`contact_oscillator\`.
///
/// Source: Textbook.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct ContactOscillatorSmooth;

/// Parameters, in SI units; the default holds the values of the spec.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Parameters<R> {
    /// deflection: deflection at the start \[m\]. In the spec: -0.02.
    pub deflection: R,
    /// oscillator.mass: the mass \[kg\]. In the spec: 1.0.
    pub oscillator_mass: R,
    /// oscillator.stiffness: spring \[N/m\]. In the spec: 400.0.
    pub oscillator_stiffness: R,
    /// oscillator.damping: damper \[N s/m\]. In the spec: 0.0.
    pub oscillator_damping: R,
    /// stop.distance: place of the stop \[m\]. In the spec: 0.005.
    pub stop_distance: R,
    /// stop.stiffness: spring of the stop \[N/m\]. In the spec: 10000.0.
    pub stop_stiffness: R,
    /// stop.width: travel over which the force bends \[m\]. In the spec: 0.0005.
    pub stop_width: R,
}

impl<R: Real> Parameters<R> {
    /// From the numbers in their order.
    #[must_use]
    #[inline]
    pub fn from_array(values: [R; PARAMETERS]) -> Self {
        Self {
            deflection: values[0],
            oscillator_mass: values[1],
            oscillator_stiffness: values[2],
            oscillator_damping: values[3],
            stop_distance: values[4],
            stop_stiffness: values[5],
            stop_width: values[6],
        }
    }
    /// The numbers in their order.
    #[must_use]
    #[inline]
    pub fn to_array(self) -> [R; PARAMETERS] {
        [
            self.deflection,
            self.oscillator_mass,
            self.oscillator_stiffness,
            self.oscillator_damping,
            self.stop_distance,
            self.stop_stiffness,
            self.stop_width,
        ]
    }
}

impl<R: Real> Default for Parameters<R> {
    fn default() -> Self {
        Self {
            deflection: R::literal(-0.02),
            oscillator_mass: R::literal(1.0),
            oscillator_stiffness: R::literal(400.0),
            oscillator_damping: R::literal(0.0),
            stop_distance: R::literal(0.005),
            stop_stiffness: R::literal(10000.0),
            stop_width: R::literal(0.0005),
        }
    }
}

/// Wanted outputs, in SI units.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Outputs<R> {
    /// deflection: deflection of the spring \[m\].
    pub deflection: R,
    /// velocity: rate of deflection of the spring \[m/s\].
    pub velocity: R,
}

impl<R: Real> Outputs<R> {
    /// From the numbers in their order.
    #[must_use]
    #[inline]
    pub fn from_array(values: [R; OUTPUTS]) -> Self {
        Self {
            deflection: values[0],
            velocity: values[1],
        }
    }
    /// The numbers in their order.
    #[must_use]
    #[inline]
    pub fn to_array(self) -> [R; OUTPUTS] {
        [self.deflection, self.velocity]
    }
}

/// Where to find what in the state.
pub mod state {
    /// oscillator.x: deflection of the spring \[m\].
    pub const OSCILLATOR_X: usize = 0;
    /// oscillator.v: rate of deflection of the spring \[m/s\].
    pub const OSCILLATOR_V: usize = 1;
}

/// Constants that `prepare` computes.
pub const CONSTANTS: usize = 4;

#[allow(missing_docs, reason = "`prepare` says what each is")]
/// What parameters alone decide; `prepare` says what each is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Constants<R> {
    pub stop_width_squared: R,
    pub inverse_oscillator_mass: R,
    pub t0: R,
    pub oscillator_v_dot_by_oscillator_v: R,
}

impl<R: Real> Constants<R> {
    /// From the numbers in their order.
    #[must_use]
    #[inline]
    pub fn from_array(values: [R; CONSTANTS]) -> Self {
        Self {
            stop_width_squared: values[0],
            inverse_oscillator_mass: values[1],
            t0: values[2],
            oscillator_v_dot_by_oscillator_v: values[3],
        }
    }
    /// The numbers in their order.
    #[must_use]
    #[inline]
    pub fn to_array(self) -> [R; CONSTANTS] {
        [
            self.stop_width_squared,
            self.inverse_oscillator_mass,
            self.t0,
            self.oscillator_v_dot_by_oscillator_v,
        ]
    }
}

/// What `rate` and `rate_jacobian` need of the parameters, once a run.
///
/// 5 operations.
#[must_use]
#[inline]
pub fn prepare<R: Real>(p: &Parameters<R>) -> Constants<R> {
    let stop_width_squared = p.stop_width * p.stop_width;
    let inverse_oscillator_mass = R::literal(1.0) / p.oscillator_mass;
    let t0 = R::literal(0.25) * p.stop_stiffness;
    let oscillator_v_dot_by_oscillator_v = -(p.oscillator_damping
        * inverse_oscillator_mass);
    Constants {
        stop_width_squared,
        inverse_oscillator_mass,
        t0,
        oscillator_v_dot_by_oscillator_v,
    }
}

/// State at the start of the run, in the units of the states.
///
/// No operations.
#[must_use]
pub fn initial_state<R: Real>(p: &Parameters<R>) -> [R; STATES] {
    [p.deflection, R::literal(0.0)]
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
/// 18 operations.
#[must_use]
#[inline]
pub fn rate<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>) -> [R; STATES] {
    prepared_rate(time, state, p, &prepare(p))
}

/// As `rate`, with the constants of the parameters from `prepare`.
///
/// 15 operations.
#[must_use]
#[inline]
pub fn prepared_rate<R: Real>(
    _time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
    c: &Constants<R>,
) -> [R; STATES] {
    let [oscillator_x, oscillator_v] = *state;
    let oscillator_x_minus_stop_distance = oscillator_x - p.stop_distance;
    let t0 = c
        .stop_width_squared
        .add_product(oscillator_x_minus_stop_distance, oscillator_x_minus_stop_distance)
        .sqrt();
    let oscillator_v_dot = (-(p.oscillator_stiffness * oscillator_x)
        .add_product(
            c.t0 * (R::literal(1.0) + oscillator_x_minus_stop_distance / t0),
            oscillator_x_minus_stop_distance + t0,
        ))
        .sub_product(p.oscillator_damping, oscillator_v) * c.inverse_oscillator_mass;
    [oscillator_v, oscillator_v_dot]
}

/// `M = d2L/dq'2`, values in the order of `MASS_MATRIX_PATTERN`.
///
/// No operations.
#[must_use]
pub fn mass_matrix<R: Real>(
    _time: R,
    _state: &[R; STATES],
    p: &Parameters<R>,
) -> [R; 1] {
    [p.oscillator_mass]
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
    let [oscillator_x, oscillator_v] = *state;
    let oscillator_x_minus_stop_distance = oscillator_x - p.stop_distance;
    let t0 = (p.stop_width * p.stop_width)
        .add_product(oscillator_x_minus_stop_distance, oscillator_x_minus_stop_distance)
        .sqrt();
    let oscillator_x_forcing = (-(p.oscillator_stiffness * oscillator_x)
        .add_product(
            R::literal(0.25) * p.stop_stiffness
                * (R::literal(1.0) + oscillator_x_minus_stop_distance / t0),
            oscillator_x_minus_stop_distance + t0,
        ))
        .sub_product(p.oscillator_damping, oscillator_v);
    [oscillator_x_forcing]
}

/// `dy'/dy`, values in the order of `RATE_JACOBIAN_PATTERN`.
///
/// 25 operations.
#[must_use]
#[inline]
pub fn rate_jacobian<R: Real>(
    time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
) -> [R; 3] {
    prepared_rate_jacobian(time, state, p, &prepare(p))
}

/// As `rate_jacobian`, with the constants of the parameters from `prepare`.
///
/// 20 operations.
#[must_use]
pub fn prepared_rate_jacobian<R: Real>(
    _time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
    c: &Constants<R>,
) -> [R; 3] {
    let [oscillator_x, ..] = *state;
    let oscillator_x_minus_stop_distance = oscillator_x - p.stop_distance;
    let t0 = oscillator_x_minus_stop_distance * oscillator_x_minus_stop_distance;
    let t1 = (c.stop_width_squared + t0).sqrt();
    let t2 = R::literal(1.0) + oscillator_x_minus_stop_distance / t1;
    let oscillator_v_dot_by_oscillator_x = -(p
        .oscillator_stiffness
        .add_product(
            c.t0 * (oscillator_x_minus_stop_distance + t1),
            R::literal(1.0) / t1 - t0 / (t1 * t1 * t1),
        )
        .add_product(c.t0, t2 * t2) * c.inverse_oscillator_mass);
    [
        R::literal(1.0),
        oscillator_v_dot_by_oscillator_x,
        c.oscillator_v_dot_by_oscillator_v,
    ]
}

/// `dy'/dp`, values in the order of `PARAMETER_JACOBIAN_PATTERN`.
///
/// 44 operations.
#[must_use]
pub fn parameter_jacobian<R: Real>(
    _time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
) -> [R; 6] {
    let [oscillator_x, oscillator_v] = *state;
    let oscillator_x_minus_stop_distance = oscillator_x - p.stop_distance;
    let t0 = (p.stop_width * p.stop_width)
        .add_product(oscillator_x_minus_stop_distance, oscillator_x_minus_stop_distance)
        .sqrt();
    let t1 = oscillator_x_minus_stop_distance + t0;
    let inverse_oscillator_mass = R::literal(1.0) / p.oscillator_mass;
    let t2 = R::literal(0.25) * p.stop_stiffness;
    let oscillator_v_dot = (-(p.oscillator_stiffness * oscillator_x)
        .add_product(t2 * (R::literal(1.0) + oscillator_x_minus_stop_distance / t0), t1))
        .sub_product(p.oscillator_damping, oscillator_v) * inverse_oscillator_mass;
    let t3 = t0 * t0 * t0;
    let oscillator_v_dot_by_oscillator_mass = -(oscillator_v_dot
        * inverse_oscillator_mass);
    let oscillator_v_dot_by_oscillator_stiffness = -(oscillator_x
        * inverse_oscillator_mass);
    let oscillator_v_dot_by_oscillator_damping = -(oscillator_v
        * inverse_oscillator_mass);
    let t4 = t1 * t1;
    let oscillator_v_dot_by_stop_distance = -(t2
        * oscillator_x_minus_stop_distance.sub_product(R::literal(2.0), t0) * t4 / t3
        * inverse_oscillator_mass);
    let oscillator_v_dot_by_stop_stiffness = -(R::literal(0.25) * t4 / t0
        * inverse_oscillator_mass);
    let oscillator_v_dot_by_stop_width = t2 * p.stop_width
        * (oscillator_x_minus_stop_distance - t0) * t1 / t3 * inverse_oscillator_mass;
    [
        oscillator_v_dot_by_oscillator_mass,
        oscillator_v_dot_by_oscillator_stiffness,
        oscillator_v_dot_by_oscillator_damping,
        oscillator_v_dot_by_stop_distance,
        oscillator_v_dot_by_stop_stiffness,
        oscillator_v_dot_by_stop_width,
    ]
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
    [R::literal(0.0), R::literal(0.0)]
}

/// Wanted outputs.
///
/// No operations.
#[must_use]
pub fn outputs<R: Real>(
    _time: R,
    state: &[R; STATES],
    _p: &Parameters<R>,
) -> Outputs<R> {
    let [oscillator_x, oscillator_v] = *state;
    Outputs {
        deflection: oscillator_x,
        velocity: oscillator_v,
    }
}

/// T, V and the energy of first-order states \[J\].
///
/// 16 operations.
#[must_use]
pub fn energy<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>) -> Energy<R> {
    let [oscillator_x, oscillator_v] = *state;
    let oscillator_x_minus_stop_distance = oscillator_x - p.stop_distance;
    let t0 = oscillator_x_minus_stop_distance
        + (p.stop_width * p.stop_width)
            .add_product(
                oscillator_x_minus_stop_distance,
                oscillator_x_minus_stop_distance,
            )
            .sqrt();
    Energy {
        kinetic: R::literal(0.5) * p.oscillator_mass * (oscillator_v * oscillator_v),
        potential: (R::literal(0.5) * p.oscillator_stiffness
            * (oscillator_x * oscillator_x))
            .add_product(R::literal(0.125) * p.stop_stiffness, t0 * t0),
        stored: R::literal(0.0),
    }
}

/// `dE/dt`, power supplied and power dissipated \[W\].
///
/// 24 operations.
#[must_use]
pub fn power_balance<R: Real>(
    _time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
) -> PowerBalance<R> {
    let [oscillator_x, oscillator_v] = *state;
    let oscillator_x_minus_stop_distance = oscillator_x - p.stop_distance;
    let t0 = (p.stop_width * p.stop_width)
        .add_product(oscillator_x_minus_stop_distance, oscillator_x_minus_stop_distance)
        .sqrt();
    let t1 = (p.oscillator_stiffness * oscillator_x)
        .add_product(
            R::literal(0.25) * p.stop_stiffness
                * (R::literal(1.0) + oscillator_x_minus_stop_distance / t0),
            oscillator_x_minus_stop_distance + t0,
        );
    let oscillator_v_dot = (-t1).sub_product(p.oscillator_damping, oscillator_v)
        * (R::literal(1.0) / p.oscillator_mass);
    PowerBalance {
        stored_rate: (t1 * oscillator_v)
            .add_product(p.oscillator_mass * oscillator_v, oscillator_v_dot),
        supplied: R::literal(0.0),
        dissipated: p.oscillator_damping * (oscillator_v * oscillator_v),
    }
}

/// Normalized Taylor coefficients of the solution through `state`, order after order.
///
/// `_k` marks the coefficient of order k, `_before` that of order k - 1; bare names are
/// zeroth coefficients. The workspace is as `series_workspace` says.
///
/// 28 recurrences. 4 sums of products an order.
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
    let (mut lanes, _) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let [oscillator_x, oscillator_v] = *state;
    let t0 = p.stop_width * p.stop_width;
    let t1 = oscillator_x - p.stop_distance;
    let t2 = t1 * t1;
    let t3 = t0 + t2;
    let t4 = t3.sqrt();
    let t5 = t1 + t4;
    let t6 = R::literal(1.0) / p.oscillator_mass;
    let t7 = oscillator_v * p.oscillator_damping;
    let t8 = t1 / t4;
    let t9 = R::literal(1.0) + t8;
    let t10 = R::literal(0.25) * p.stop_stiffness;
    let t11 = t9 * t10;
    let t12 = t11 * t5;
    let t13 = oscillator_x * p.oscillator_stiffness;
    let t14 = t12 + t13;
    let t15 = -t7;
    let t16 = t15 - t14;
    let oscillator_v_dot = t16 * t6;
    let inverse_t4 = R::literal(1.0) / (t4 + t4);
    let inverse_t4_2 = R::literal(1.0) / t4;
    let mut rates = [oscillator_v, oscillator_v_dot];
    coefficients[0] = *state;
    let highest = coefficients.len() - 1;
    for (order, state_k) in coefficients.iter_mut().enumerate().skip(1) {
        let (_, inverse) = order_and_inverse::<R>(order);
        *state_k = rates.map(|rate| rate * inverse);
        if order == highest {
            break;
        }
        let [oscillator_x_k, oscillator_v_k] = *state_k;
        let sums = lanes.sums(order);
        let t2_k = (t1 + t1).mul_add(oscillator_x_k, sums[0]);
        let t4_k = (t2_k - sums[1]) * inverse_t4;
        let t5_k = oscillator_x_k + t4_k;
        let t7_k = oscillator_v_k * p.oscillator_damping;
        let t8_k = (-t4_k).mul_add(t8, oscillator_x_k - sums[2]) * inverse_t4_2;
        let t11_k = t8_k * t10;
        let t12_k = t5.mul_add(t11_k, t11.mul_add(t5_k, sums[3]));
        let t14_k = oscillator_x_k.mul_add(p.oscillator_stiffness, t12_k);
        let t15_k = -t7_k;
        let t16_k = t15_k - t14_k;
        let oscillator_v_dot_k = t16_k * t6;
        lanes
            .set(
                order,
                [oscillator_x_k, t4_k, t4_k, t5_k],
                [oscillator_x_k, t4_k, t8_k, t11_k],
            );
        rates = [oscillator_v_k, oscillator_v_dot_k];
    }
}

impl<R: Real> TaylorSeries<R> for ContactOscillatorSmooth {
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
}

impl Describe for ContactOscillatorSmooth {
    fn name(&self) -> &'static str {
        "contact_oscillator_smooth"
    }
    fn title(&self) -> &'static str {
        "Oscillator with a one-sided stop, smoothed"
    }
    fn shape(&self) -> Shape {
        Shape {
            coordinates: COORDINATES,
            positions: 1,
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

impl<R: Real> Simulator<R> for ContactOscillatorSmooth {
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
        name: "oscillator.x",
        unit: "m",
        doc: "deflection of the spring",
    },
    Quantity {
        name: "oscillator.v",
        unit: "m/s",
        doc: "rate of deflection of the spring",
    },
];

static STATE_SCALES: [f64; STATES] = [0.01, 0.1];

static PARAMETER_QUANTITIES: [Quantity<'static>; PARAMETERS] = [
    Quantity {
        name: "deflection",
        unit: "m",
        doc: "deflection at the start",
    },
    Quantity {
        name: "oscillator.mass",
        unit: "kg",
        doc: "the mass",
    },
    Quantity {
        name: "oscillator.stiffness",
        unit: "N/m",
        doc: "spring",
    },
    Quantity {
        name: "oscillator.damping",
        unit: "N s/m",
        doc: "damper",
    },
    Quantity {
        name: "stop.distance",
        unit: "m",
        doc: "place of the stop",
    },
    Quantity {
        name: "stop.stiffness",
        unit: "N/m",
        doc: "spring of the stop",
    },
    Quantity {
        name: "stop.width",
        unit: "m",
        doc: "travel over which the force bends",
    },
];

static PARAMETER_DEFAULTS: [f64; PARAMETERS] = [
    -0.02,
    1.0,
    400.0,
    0.0,
    0.005,
    10000.0,
    0.0005,
];

static OUTPUT_QUANTITIES: [Quantity<'static>; OUTPUTS] = [
    Quantity {
        name: "deflection",
        unit: "m",
        doc: "deflection of the spring",
    },
    Quantity {
        name: "velocity",
        unit: "m/s",
        doc: "rate of deflection of the spring",
    },
];

/// The run the spec asks for.
pub const RUN_DEFAULTS: RunDefaults<'static> = RunDefaults {
    from: 0.0,
    until: 2.0,
    points: 2001,
    rtol: 1e-8,
    method: "dop853",
};

// Emitted by Machinist 0.1.0; do not edit. To make it again:
//
//     cargo run --release -- gen
//
// Sources, with SHA-256:
//   d5f791591548f3d0783dd936c85151e668e502bd1044f337e83ea88c4bc67466  scenes/bouncing_mass.toml
//   12df7804de72103290d4f71966f2eb8bb7a1e6a701dfcc9fd70c310ee6226898  units/bouncer.toml
//
// Mass bouncing on a shaken plate
//
// The plate shakes at 10 Hz with seven tenths of the acceleration of free fall. The mass
// settles into one bounce a period.
//
// Source:
//   Textbook; the orbit of one bounce a period is in closed form.
//
// Shapes; all quantities are in SI units:
//   coordinates               1
//   first-order states        1
//   states                    3
//   parameters                8
//   outputs                   4
//   discontinuities           0
//   events                    2
//
// State:
//     0  ball.x        [m]    height of the mass
//     1  ball.v        [m/s]  rate of height of the mass
//     2  ball.resting  [1]    1 while the mass stays on the plate
//
// Nonzeros:
//   mass_matrix               1 of 1 by 1
//   rate_jacobian             1 of 3 by 3
//   parameter_jacobian        4 of 3 by 8
//
// Operations:
//   initial_state             0
//   discontinuities           0
//   rate                     12
//   mass_matrix               0
//   forcing                  10
//   rate_jacobian             0
//   parameter_jacobian       35
//   time_derivative          11
//   outputs                   4
//   energy                    5
//   power_balance            18
//   guards                    8
//   guard_rates               9
//   resets                   23
// With constants of the parameters, prepared once a run:
//   prepare                   3
//   prepared_rate             9
//   prepared_rate_jacobian    0

use ::machinist_contract::{
    Describe, Direction, Event, Energy, PowerBalance, Quantity, Real, RunDefaults, Shape,
    Simulator, SparsityPattern, taylor::{TaylorSeries, order_and_inverse},
};

/// Generalized coordinates, n.
pub const COORDINATES: usize = 1;

/// Length of the state y.
pub const STATES: usize = 3;

/// Parameters.
pub const PARAMETERS: usize = 8;

/// Wanted outputs.
pub const OUTPUTS: usize = 4;

/// Times at which the right-hand side jumps.
pub const DISCONTINUITIES: usize = 0;

/// Events.
pub const EVENTS: usize = 2;

/// States that events set, those of all events.
pub const RESETS: usize = 3;

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
    entries: &[(0, 1)],
};

/// Nonzeros of dy'/dp.
pub const PARAMETER_JACOBIAN_PATTERN: SparsityPattern<'static> = SparsityPattern {
    rows: 3,
    columns: 8,
    entries: &[(1, 0), (1, 1), (1, 4), (1, 5)],
};

/// Mass bouncing on a shaken plate
///
/// The plate shakes at 10 Hz with seven tenths of the acceleration of free fall. The mass
/// settles into one bounce a period.
///
/// Source: Textbook; the orbit of one bounce a period is in closed form.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct BouncingMass;

/// Parameters, in SI units; the default holds the values of the spec.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Parameters<R> {
    /// amplitude: A, amplitude of the plate \[m\]. In the spec: 0.0017395.
    pub amplitude: R,
    /// frequency: w, angular frequency of the plate \[rad/s\]. In the spec: 62.83185307179586.
    pub frequency: R,
    /// height: height of the mass at the start \[m\]. In the spec: 0.009.
    pub height: R,
    /// speed: its velocity at the start, upwards \[m/s\]. In the spec: -0.33.
    pub speed: R,
    /// ball.mass: the mass \[kg\]. In the spec: 0.5.
    pub ball_mass: R,
    /// ball.gravity: acceleration of free fall \[m/s^2\]. In the spec: 9.81.
    pub ball_gravity: R,
    /// ball.restitution: speed after over speed before an impact, relative to the plate \[1\]. In the spec: 0.8.
    pub ball_restitution: R,
    /// ball.rest_speed: impacts slower than that leave the mass on the plate \[m/s\]. In the spec: 0.0001.
    pub ball_rest_speed: R,
}

impl<R: Real> Parameters<R> {
    /// From the numbers in their order.
    #[must_use]
    #[inline]
    pub fn from_array(values: [R; PARAMETERS]) -> Self {
        Self {
            amplitude: values[0],
            frequency: values[1],
            height: values[2],
            speed: values[3],
            ball_mass: values[4],
            ball_gravity: values[5],
            ball_restitution: values[6],
            ball_rest_speed: values[7],
        }
    }
    /// The numbers in their order.
    #[must_use]
    #[inline]
    pub fn to_array(self) -> [R; PARAMETERS] {
        [
            self.amplitude,
            self.frequency,
            self.height,
            self.speed,
            self.ball_mass,
            self.ball_gravity,
            self.ball_restitution,
            self.ball_rest_speed,
        ]
    }
}

impl<R: Real> Default for Parameters<R> {
    fn default() -> Self {
        Self {
            amplitude: R::literal(0.001_739_5),
            frequency: R::literal(62.831_853_071_795_86),
            height: R::literal(0.009),
            speed: R::literal(-0.33),
            ball_mass: R::literal(0.5),
            ball_gravity: R::literal(9.81),
            ball_restitution: R::literal(0.8),
            ball_rest_speed: R::literal(0.0001),
        }
    }
}

/// Wanted outputs, in SI units.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Outputs<R> {
    /// height: height of the mass \[m\].
    pub height: R,
    /// gap: gap between mass and plate \[m\].
    pub gap: R,
    /// plate: height of the plate \[m\].
    pub plate: R,
    /// resting: 1 while the mass stays on the plate \[1\].
    pub resting: R,
}

impl<R: Real> Outputs<R> {
    /// From the numbers in their order.
    #[must_use]
    #[inline]
    pub fn from_array(values: [R; OUTPUTS]) -> Self {
        Self {
            height: values[0],
            gap: values[1],
            plate: values[2],
            resting: values[3],
        }
    }
    /// The numbers in their order.
    #[must_use]
    #[inline]
    pub fn to_array(self) -> [R; OUTPUTS] {
        [self.height, self.gap, self.plate, self.resting]
    }
}

/// Where to find what in the state.
pub mod state {
    /// ball.x: height of the mass \[m\].
    pub const BALL_X: usize = 0;
    /// ball.v: rate of height of the mass \[m/s\].
    pub const BALL_V: usize = 1;
    /// ball.resting: 1 while the mass stays on the plate \[1\].
    pub const BALL_RESTING: usize = 2;
}

/// Constants that `prepare` computes.
pub const CONSTANTS: usize = 3;

#[allow(missing_docs, reason = "`prepare` says what each is")]
/// What parameters alone decide; `prepare` says what each is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Constants<R> {
    pub frequency_squared: R,
    pub inverse_ball_mass: R,
    pub ball_mass_times_ball_gravity: R,
}

impl<R: Real> Constants<R> {
    /// From the numbers in their order.
    #[must_use]
    #[inline]
    pub fn from_array(values: [R; CONSTANTS]) -> Self {
        Self {
            frequency_squared: values[0],
            inverse_ball_mass: values[1],
            ball_mass_times_ball_gravity: values[2],
        }
    }
    /// The numbers in their order.
    #[must_use]
    #[inline]
    pub fn to_array(self) -> [R; CONSTANTS] {
        [
            self.frequency_squared,
            self.inverse_ball_mass,
            self.ball_mass_times_ball_gravity,
        ]
    }
}

/// What `rate` and `rate_jacobian` need of the parameters, once a run.
///
/// 3 operations.
#[must_use]
#[inline]
pub fn prepare<R: Real>(p: &Parameters<R>) -> Constants<R> {
    let frequency_squared = p.frequency * p.frequency;
    let inverse_ball_mass = R::literal(1.0) / p.ball_mass;
    let ball_mass_times_ball_gravity = p.ball_mass * p.ball_gravity;
    Constants {
        frequency_squared,
        inverse_ball_mass,
        ball_mass_times_ball_gravity,
    }
}

/// State at the start of the run, in the units of the states.
///
/// No operations.
#[must_use]
pub fn initial_state<R: Real>(p: &Parameters<R>) -> [R; STATES] {
    [p.height, p.speed, R::literal(0.0)]
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
/// 12 operations.
#[must_use]
#[inline]
pub fn rate<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>) -> [R; STATES] {
    prepared_rate(time, state, p, &prepare(p))
}

/// As `rate`, with the constants of the parameters from `prepare`.
///
/// 9 operations.
#[must_use]
#[inline]
pub fn prepared_rate<R: Real>(
    time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
    c: &Constants<R>,
) -> [R; STATES] {
    let [_, ball_v, ball_resting] = *state;
    let plate = p.amplitude * (p.frequency * time).sin();
    let ball_weight = p.ball_mass
        * p.ball_gravity.sub_product(c.frequency_squared, plate);
    let ball_contact_force = R::select_less(
        ball_resting,
        R::literal(0.5),
        R::literal(0.0),
        ball_weight,
    );
    let ball_v_dot = (ball_contact_force - c.ball_mass_times_ball_gravity)
        * c.inverse_ball_mass;
    [ball_v, ball_v_dot, R::literal(0.0)]
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
    [p.ball_mass]
}

/// `f` of `M q'' = f(q, q', z, t)`, one for each coordinate.
///
/// 10 operations.
#[must_use]
pub fn forcing<R: Real>(
    time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
) -> [R; COORDINATES] {
    let [_, _, ball_resting] = *state;
    let plate = p.amplitude * (p.frequency * time).sin();
    let ball_weight = p.ball_mass
        * p.ball_gravity.sub_product(p.frequency * p.frequency, plate);
    let ball_contact_force = R::select_less(
        ball_resting,
        R::literal(0.5),
        R::literal(0.0),
        ball_weight,
    );
    let ball_x_forcing = ball_contact_force.sub_product(p.ball_mass, p.ball_gravity);
    [ball_x_forcing]
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
) -> [R; 1] {
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
) -> [R; 1] {
    [R::literal(1.0)]
}

/// `dy'/dp`, values in the order of `PARAMETER_JACOBIAN_PATTERN`.
///
/// 35 operations.
#[must_use]
pub fn parameter_jacobian<R: Real>(
    time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
) -> [R; 4] {
    let [_, _, ball_resting] = *state;
    let frequency_times_time = p.frequency * time;
    let (sin_frequency_times_time, cos_frequency_times_time) = frequency_times_time
        .sin_cos();
    let plate = p.amplitude * sin_frequency_times_time;
    let plate_speed = p.amplitude * p.frequency * cos_frequency_times_time;
    let frequency_squared = p.frequency * p.frequency;
    let t0 = p.ball_gravity.sub_product(frequency_squared, plate);
    let ball_weight = p.ball_mass * t0;
    let ball_contact_force = R::select_less(
        ball_resting,
        R::literal(0.5),
        R::literal(0.0),
        ball_weight,
    );
    let inverse_ball_mass = R::literal(1.0) / p.ball_mass;
    let ball_v_dot = ball_contact_force.sub_product(p.ball_mass, p.ball_gravity)
        * inverse_ball_mass;
    let ball_v_dot_by_amplitude = R::select_less(
        ball_resting,
        R::literal(0.5),
        R::literal(0.0),
        -(p.ball_mass * frequency_squared * sin_frequency_times_time),
    ) * inverse_ball_mass;
    let ball_v_dot_by_frequency = R::select_less(
        ball_resting,
        R::literal(0.5),
        R::literal(0.0),
        p.ball_mass
            * (-(frequency_times_time * plate_speed))
                .sub_product(R::literal(2.0) * p.frequency, plate),
    ) * inverse_ball_mass;
    let ball_v_dot_by_ball_mass = (R::select_less(
        ball_resting,
        R::literal(0.5),
        R::literal(0.0),
        t0,
    ) - p.ball_gravity - ball_v_dot) * inverse_ball_mass;
    let ball_v_dot_by_ball_gravity = (R::select_less(
        ball_resting,
        R::literal(0.5),
        R::literal(0.0),
        p.ball_mass,
    ) - p.ball_mass) * inverse_ball_mass;
    [
        ball_v_dot_by_amplitude,
        ball_v_dot_by_frequency,
        ball_v_dot_by_ball_mass,
        ball_v_dot_by_ball_gravity,
    ]
}

/// Partial derivative of `y'` with respect to time.
///
/// 11 operations.
#[must_use]
pub fn time_derivative<R: Real>(
    time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
) -> [R; STATES] {
    let [_, _, ball_resting] = *state;
    let plate_speed = p.amplitude * p.frequency * (p.frequency * time).cos();
    let ball_v_dot_by_time = R::select_less(
        ball_resting,
        R::literal(0.5),
        R::literal(0.0),
        -(p.ball_mass * (p.frequency * p.frequency) * plate_speed),
    ) * (R::literal(1.0) / p.ball_mass);
    [R::literal(0.0), ball_v_dot_by_time, R::literal(0.0)]
}

/// Wanted outputs.
///
/// 4 operations.
#[must_use]
pub fn outputs<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>) -> Outputs<R> {
    let [ball_x, _, ball_resting] = *state;
    let plate = p.amplitude * (p.frequency * time).sin();
    let ball_gap = ball_x - plate;
    Outputs {
        height: ball_x,
        gap: ball_gap,
        plate,
        resting: ball_resting,
    }
}

/// T, V and the energy of first-order states \[J\].
///
/// 5 operations.
#[must_use]
pub fn energy<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>) -> Energy<R> {
    let [ball_x, ball_v, ..] = *state;
    Energy {
        kinetic: R::literal(0.5) * p.ball_mass * (ball_v * ball_v),
        potential: p.ball_mass * p.ball_gravity * ball_x,
        stored: R::literal(0.0),
    }
}

/// `dE/dt`, power supplied and power dissipated \[W\].
///
/// 18 operations.
#[must_use]
pub fn power_balance<R: Real>(
    time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
) -> PowerBalance<R> {
    let [_, ball_v, ball_resting] = *state;
    let plate = p.amplitude * (p.frequency * time).sin();
    let ball_weight = p.ball_mass
        * p.ball_gravity.sub_product(p.frequency * p.frequency, plate);
    let ball_contact_force = R::select_less(
        ball_resting,
        R::literal(0.5),
        R::literal(0.0),
        ball_weight,
    );
    let ball_mass_times_ball_gravity = p.ball_mass * p.ball_gravity;
    let ball_v_dot = (ball_contact_force - ball_mass_times_ball_gravity)
        * (R::literal(1.0) / p.ball_mass);
    PowerBalance {
        stored_rate: (ball_mass_times_ball_gravity * ball_v)
            .add_product(p.ball_mass * ball_v, ball_v_dot),
        supplied: R::select_less(
            ball_resting,
            R::literal(0.5),
            R::literal(0.0),
            ball_v * ball_weight,
        ),
        dissipated: R::literal(0.0),
    }
}

/// What passes zero where an event happens, in the order of `EVENT_SHAPES`.
///
/// 8 operations.
#[must_use]
pub fn guards<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>) -> [R; EVENTS] {
    let [ball_x, ..] = *state;
    let plate = p.amplitude * (p.frequency * time).sin();
    let ball_gap = ball_x - plate;
    let ball_weight = p.ball_mass
        * p.ball_gravity.sub_product(p.frequency * p.frequency, plate);
    [ball_gap, ball_weight]
}

/// `dg/dt` of the guards along the motion.
///
/// 9 operations.
#[must_use]
pub fn guard_rates<R: Real>(
    time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
) -> [R; EVENTS] {
    let [_, ball_v, ..] = *state;
    let plate_speed = p.amplitude * p.frequency * (p.frequency * time).cos();
    let ball_approach = ball_v - plate_speed;
    let ball_lift_off_guard_rate = -(p.ball_mass * (p.frequency * p.frequency)
        * plate_speed);
    [ball_approach, ball_lift_off_guard_rate]
}

/// New values of the states that each event sets, event by event.
///
/// 23 operations.
#[must_use]
pub fn resets<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>) -> [R; RESETS] {
    let [_, ball_v, ..] = *state;
    let frequency_times_time = p.frequency * time;
    let (sin_frequency_times_time, cos_frequency_times_time) = frequency_times_time
        .sin_cos();
    let plate = p.amplitude * sin_frequency_times_time;
    let plate_speed = p.amplitude * p.frequency * cos_frequency_times_time;
    let ball_approach = ball_v - plate_speed;
    let ball_weight = p.ball_mass
        * p.ball_gravity.sub_product(p.frequency * p.frequency, plate);
    let ball_settles = R::literal(0.25)
        * (R::literal(1.0)
            - R::select_less(
                -p.ball_rest_speed - ball_approach,
                R::literal(0.0),
                R::literal(-1.0),
                R::literal(1.0),
            ))
        * (R::literal(1.0)
            + R::select_less(
                ball_weight,
                R::literal(0.0),
                R::literal(-1.0),
                R::literal(1.0),
            ));
    let ball_v_after_ball_impact = plate_speed
        .sub_product(p.ball_restitution * ball_approach, R::literal(1.0) - ball_settles);
    [ball_v_after_ball_impact, ball_settles, R::literal(0.0)]
}

/// Normalized Taylor coefficients of the solution through `state`, order after order.
///
/// `_k` marks the coefficient of order k, `_before` that of order k - 1; bare names are
/// zeroth coefficients. The workspace is as `series_workspace` says.
///
/// 23 recurrences. No sums of products.
///
/// # Panics
/// If there is no room for the zeroth coefficients, or the workspace is too short.
pub fn series<R: Real>(
    time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
    coefficients: &mut [[R; STATES]],
    _workspace: &mut [R],
) {
    let [_, ball_v, ball_resting] = *state;
    let t0 = time * p.frequency;
    let t1 = t0.sin();
    let t2 = t0.cos();
    let t3 = p.frequency * p.frequency;
    let t4 = p.amplitude * t3;
    let t5 = t1 * t4;
    let t6 = p.ball_gravity - t5;
    let ball_weight = t6 * p.ball_mass;
    let ball_contact_force = R::select_less(
        ball_resting,
        R::literal(0.5),
        R::literal(0.0),
        ball_weight,
    );
    let t7 = R::literal(1.0) / p.ball_mass;
    let t8 = p.ball_mass * p.ball_gravity;
    let t9 = ball_contact_force - t8;
    let ball_v_dot = t9 * t7;
    let mut t1_before = t1;
    let mut t2_before = t2;
    let mut rates = [ball_v, ball_v_dot, R::literal(0.0)];
    coefficients[0] = *state;
    let highest = coefficients.len() - 1;
    for (order, state_k) in coefficients.iter_mut().enumerate().skip(1) {
        let (_, inverse) = order_and_inverse::<R>(order);
        *state_k = rates.map(|rate| rate * inverse);
        if order == highest {
            break;
        }
        let [_, ball_v_k, ..] = *state_k;
        let t1_k = inverse * p.frequency * t2_before;
        let t2_k = -inverse * p.frequency * t1_before;
        let t6_k = -t1_k * t4;
        let ball_weight_k = t6_k * p.ball_mass;
        let ball_contact_force_k = R::select_less(
            ball_resting,
            R::literal(0.5),
            R::literal(0.0),
            ball_weight_k,
        );
        let ball_v_dot_k = ball_contact_force_k * t7;
        t1_before = t1_k;
        t2_before = t2_k;
        rates = [ball_v_k, ball_v_dot_k, R::literal(0.0)];
    }
}

impl<R: Real> TaylorSeries<R> for BouncingMass {
    fn series_workspace(&self, _order: usize) -> usize {
        0
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

impl Describe for BouncingMass {
    fn name(&self) -> &'static str {
        "bouncing_mass"
    }
    fn title(&self) -> &'static str {
        "Mass bouncing on a shaken plate"
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
    fn events(&self) -> usize {
        EVENTS
    }
    fn event(&self, index: usize) -> Event<'_> {
        EVENT_SHAPES[index]
    }
    fn is_mode(&self, index: usize) -> bool {
        matches!(index, 2)
    }
}

impl<R: Real> Simulator<R> for BouncingMass {
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
    fn guards(&self, time: R, state: &[R], parameters: &[R], values: &mut [R]) {
        *array_of(values) = guards(time, state_of(state), &parameters_of(parameters));
    }
    fn guard_rates(&self, time: R, state: &[R], parameters: &[R], values: &mut [R]) {
        *array_of(values) = guard_rates(
            time,
            state_of(state),
            &parameters_of(parameters),
        );
    }
    fn resets(&self, time: R, state: &[R], parameters: &[R], values: &mut [R]) {
        *array_of(values) = resets(time, state_of(state), &parameters_of(parameters));
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
        name: "ball.x",
        unit: "m",
        doc: "height of the mass",
    },
    Quantity {
        name: "ball.v",
        unit: "m/s",
        doc: "rate of height of the mass",
    },
    Quantity {
        name: "ball.resting",
        unit: "1",
        doc: "1 while the mass stays on the plate",
    },
];

static STATE_SCALES: [f64; STATES] = [0.01, 0.3, 1.0];

static PARAMETER_QUANTITIES: [Quantity<'static>; PARAMETERS] = [
    Quantity {
        name: "amplitude",
        unit: "m",
        doc: "A, amplitude of the plate",
    },
    Quantity {
        name: "frequency",
        unit: "rad/s",
        doc: "w, angular frequency of the plate",
    },
    Quantity {
        name: "height",
        unit: "m",
        doc: "height of the mass at the start",
    },
    Quantity {
        name: "speed",
        unit: "m/s",
        doc: "its velocity at the start, upwards",
    },
    Quantity {
        name: "ball.mass",
        unit: "kg",
        doc: "the mass",
    },
    Quantity {
        name: "ball.gravity",
        unit: "m/s^2",
        doc: "acceleration of free fall",
    },
    Quantity {
        name: "ball.restitution",
        unit: "1",
        doc: "speed after over speed before an impact, relative to the plate",
    },
    Quantity {
        name: "ball.rest_speed",
        unit: "m/s",
        doc: "impacts slower than that leave the mass on the plate",
    },
];

static PARAMETER_DEFAULTS: [f64; PARAMETERS] = [
    0.001_739_5,
    62.831_853_071_795_86,
    0.009,
    -0.33,
    0.5,
    9.81,
    0.8,
    0.0001,
];

static OUTPUT_QUANTITIES: [Quantity<'static>; OUTPUTS] = [
    Quantity {
        name: "height",
        unit: "m",
        doc: "height of the mass",
    },
    Quantity {
        name: "gap",
        unit: "m",
        doc: "gap between mass and plate",
    },
    Quantity {
        name: "plate",
        unit: "m",
        doc: "height of the plate",
    },
    Quantity {
        name: "resting",
        unit: "1",
        doc: "1 while the mass stays on the plate",
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

/// What happens where guards pass zero.
pub static EVENT_SHAPES: [Event<'static>; EVENTS] = [
    Event {
        name: "ball.impact",
        doc: "the mass meets the plate",
        direction: Direction::Falling,
        when: &[(2, 0.0)],
        sets: &[1, 2],
    },
    Event {
        name: "ball.lift_off",
        doc: "the plate falls away",
        direction: Direction::Falling,
        when: &[(2, 1.0)],
        sets: &[2],
    },
];

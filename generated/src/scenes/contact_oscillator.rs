// Emitted by Machinist 0.1.0; do not edit. To make it again:
//
//     cargo run --release -- gen
//
// Sources, with SHA-256:
//   88ef63c78e86c26fddbb155af33e6a2671afb454b0ba926a3aba7ed701abc3b7  scenes/contact_oscillator.toml
//   f0db790170b6c3f134330c00617de69bb14585d0c566d62cfa2cc6117d09122a  units/sprung_mass.toml
//   aa460541694f4c6c145124dcacf35c9d1c5ec7ec73d776fc4eb9748b2b487367  units/stop.toml
//
// Oscillator with a one-sided stop
//
// A mass on a spring meets an elastic stop on one side: piecewise linear.
//
// Source:
//   Textbook; exact, stitched from sinusoids.
//
// Shapes; all quantities are in SI units:
//   coordinates               1
//   first-order states        1
//   states                    3
//   parameters                7
//   outputs                   4
//   discontinuities           0
//   events                    2
//
// State:
//     0  oscillator.x  [m]    deflection of the spring
//     1  oscillator.v  [m/s]  rate of deflection of the spring
//     2  stop.closed   [1]    1 while the stop is touched
//
// Nonzeros:
//   mass_matrix               1 of 1 by 1
//   rate_jacobian             3 of 3 by 3
//   parameter_jacobian        6 of 3 by 7
//
// Operations:
//   initial_state             0
//   discontinuities           0
//   rate                     12
//   mass_matrix               0
//   forcing                  10
//   rate_jacobian             9
//   parameter_jacobian       26
//   time_derivative           0
//   outputs                   5
//   energy                   12
//   power_balance            23
//   guards                    5
//   guard_rates              19
//   resets                    0
// With constants of the parameters, prepared once a run:
//   prepare                   4
//   prepared_rate            10
//   prepared_rate_jacobian    6

use ::machinist_contract::{
    Describe, Direction, Event, Energy, PowerBalance, Quantity, Real, RunDefaults, Shape,
    Simulator, SparsityPattern, taylor::{TaylorSeries, order_and_inverse},
};

/// Generalized coordinates, n.
pub const COORDINATES: usize = 1;

/// Length of the state y.
pub const STATES: usize = 3;

/// Parameters.
pub const PARAMETERS: usize = 7;

/// Wanted outputs.
pub const OUTPUTS: usize = 4;

/// Times at which the right-hand side jumps.
pub const DISCONTINUITIES: usize = 0;

/// Events.
pub const EVENTS: usize = 2;

/// States that events set, those of all events.
pub const RESETS: usize = 2;

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
    entries: &[(0, 1), (1, 0), (1, 1)],
};

/// Nonzeros of dy'/dp.
pub const PARAMETER_JACOBIAN_PATTERN: SparsityPattern<'static> = SparsityPattern {
    rows: 3,
    columns: 7,
    entries: &[(1, 1), (1, 2), (1, 3), (1, 4), (1, 5), (1, 6)],
};

/// Oscillator with a one-sided stop
///
/// A mass on a spring meets an elastic stop on one side: piecewise linear.
///
/// Source: Textbook; exact, stitched from sinusoids.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct ContactOscillator;

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
    /// stop.damping: damper of the stop \[N s/m\]. In the spec: 0.0.
    pub stop_damping: R,
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
            stop_damping: values[6],
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
            self.stop_damping,
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
            stop_damping: R::literal(0.0),
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
    /// force: force of the stop \[N\].
    pub force: R,
    /// closed: 1 while the stop is touched \[1\].
    pub closed: R,
}

impl<R: Real> Outputs<R> {
    /// From the numbers in their order.
    #[must_use]
    #[inline]
    pub fn from_array(values: [R; OUTPUTS]) -> Self {
        Self {
            deflection: values[0],
            velocity: values[1],
            force: values[2],
            closed: values[3],
        }
    }
    /// The numbers in their order.
    #[must_use]
    #[inline]
    pub fn to_array(self) -> [R; OUTPUTS] {
        [self.deflection, self.velocity, self.force, self.closed]
    }
}

/// Where to find what in the state.
pub mod state {
    /// oscillator.x: deflection of the spring \[m\].
    pub const OSCILLATOR_X: usize = 0;
    /// oscillator.v: rate of deflection of the spring \[m/s\].
    pub const OSCILLATOR_V: usize = 1;
    /// stop.closed: 1 while the stop is touched \[1\].
    pub const STOP_CLOSED: usize = 2;
}

/// Constants that `prepare` computes.
pub const CONSTANTS: usize = 4;

#[allow(missing_docs, reason = "`prepare` says what each is")]
/// What parameters alone decide; `prepare` says what each is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Constants<R> {
    pub inverse_oscillator_mass: R,
    pub stop_distance_times_stop_stiffness: R,
    pub minus_stop_stiffness: R,
    pub minus_stop_damping: R,
}

impl<R: Real> Constants<R> {
    /// From the numbers in their order.
    #[must_use]
    #[inline]
    pub fn from_array(values: [R; CONSTANTS]) -> Self {
        Self {
            inverse_oscillator_mass: values[0],
            stop_distance_times_stop_stiffness: values[1],
            minus_stop_stiffness: values[2],
            minus_stop_damping: values[3],
        }
    }
    /// The numbers in their order.
    #[must_use]
    #[inline]
    pub fn to_array(self) -> [R; CONSTANTS] {
        [
            self.inverse_oscillator_mass,
            self.stop_distance_times_stop_stiffness,
            self.minus_stop_stiffness,
            self.minus_stop_damping,
        ]
    }
}

/// What `rate` and `rate_jacobian` need of the parameters, once a run.
///
/// 4 operations.
#[must_use]
#[inline]
pub fn prepare<R: Real>(p: &Parameters<R>) -> Constants<R> {
    let inverse_oscillator_mass = R::literal(1.0) / p.oscillator_mass;
    let stop_distance_times_stop_stiffness = p.stop_distance * p.stop_stiffness;
    let minus_stop_stiffness = -p.stop_stiffness;
    let minus_stop_damping = -p.stop_damping;
    Constants {
        inverse_oscillator_mass,
        stop_distance_times_stop_stiffness,
        minus_stop_stiffness,
        minus_stop_damping,
    }
}

/// State at the start of the run, in the units of the states.
///
/// No operations.
#[must_use]
pub fn initial_state<R: Real>(p: &Parameters<R>) -> [R; STATES] {
    [p.deflection, R::literal(0.0), R::literal(0.0)]
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
/// 10 operations.
#[must_use]
#[inline]
pub fn prepared_rate<R: Real>(
    _time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
    c: &Constants<R>,
) -> [R; STATES] {
    let [oscillator_x, oscillator_v, stop_closed] = *state;
    let oscillator_v_dot = R::select_less(
            stop_closed,
            R::literal(0.5),
            R::literal(0.0),
            c
                .stop_distance_times_stop_stiffness
                .sub_product(p.stop_stiffness, oscillator_x)
                .sub_product(p.stop_damping, oscillator_v),
        )
        .sub_product(p.oscillator_stiffness, oscillator_x)
        .sub_product(p.oscillator_damping, oscillator_v) * c.inverse_oscillator_mass;
    [oscillator_v, oscillator_v_dot, R::literal(0.0)]
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
/// 10 operations.
#[must_use]
pub fn forcing<R: Real>(
    _time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
) -> [R; COORDINATES] {
    let [oscillator_x, oscillator_v, stop_closed] = *state;
    let oscillator_x_forcing = R::select_less(
            stop_closed,
            R::literal(0.5),
            R::literal(0.0),
            (p.stop_distance * p.stop_stiffness)
                .sub_product(p.stop_stiffness, oscillator_x)
                .sub_product(p.stop_damping, oscillator_v),
        )
        .sub_product(p.oscillator_stiffness, oscillator_x)
        .sub_product(p.oscillator_damping, oscillator_v);
    [oscillator_x_forcing]
}

/// `dy'/dy`, values in the order of `RATE_JACOBIAN_PATTERN`.
///
/// 9 operations.
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
/// 6 operations.
#[must_use]
pub fn prepared_rate_jacobian<R: Real>(
    _time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
    c: &Constants<R>,
) -> [R; 3] {
    let [_, _, stop_closed] = *state;
    let oscillator_v_dot_by_oscillator_x = (R::select_less(
        stop_closed,
        R::literal(0.5),
        R::literal(0.0),
        c.minus_stop_stiffness,
    ) - p.oscillator_stiffness) * c.inverse_oscillator_mass;
    let oscillator_v_dot_by_oscillator_v = (R::select_less(
        stop_closed,
        R::literal(0.5),
        R::literal(0.0),
        c.minus_stop_damping,
    ) - p.oscillator_damping) * c.inverse_oscillator_mass;
    [R::literal(1.0), oscillator_v_dot_by_oscillator_x, oscillator_v_dot_by_oscillator_v]
}

/// `dy'/dp`, values in the order of `PARAMETER_JACOBIAN_PATTERN`.
///
/// 26 operations.
#[must_use]
pub fn parameter_jacobian<R: Real>(
    _time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
) -> [R; 6] {
    let [oscillator_x, oscillator_v, stop_closed] = *state;
    let inverse_oscillator_mass = R::literal(1.0) / p.oscillator_mass;
    let oscillator_v_dot = R::select_less(
            stop_closed,
            R::literal(0.5),
            R::literal(0.0),
            (p.stop_distance * p.stop_stiffness)
                .sub_product(p.stop_stiffness, oscillator_x)
                .sub_product(p.stop_damping, oscillator_v),
        )
        .sub_product(p.oscillator_stiffness, oscillator_x)
        .sub_product(p.oscillator_damping, oscillator_v) * inverse_oscillator_mass;
    let oscillator_v_dot_by_oscillator_mass = -(oscillator_v_dot
        * inverse_oscillator_mass);
    let oscillator_v_dot_by_oscillator_stiffness = -(oscillator_x
        * inverse_oscillator_mass);
    let oscillator_v_dot_by_oscillator_damping = -(oscillator_v
        * inverse_oscillator_mass);
    let oscillator_v_dot_by_stop_distance = R::select_less(
        stop_closed,
        R::literal(0.5),
        R::literal(0.0),
        p.stop_stiffness,
    ) * inverse_oscillator_mass;
    let oscillator_v_dot_by_stop_stiffness = R::select_less(
        stop_closed,
        R::literal(0.5),
        R::literal(0.0),
        p.stop_distance - oscillator_x,
    ) * inverse_oscillator_mass;
    let oscillator_v_dot_by_stop_damping = R::select_less(
        stop_closed,
        R::literal(0.5),
        R::literal(0.0),
        -oscillator_v,
    ) * inverse_oscillator_mass;
    [
        oscillator_v_dot_by_oscillator_mass,
        oscillator_v_dot_by_oscillator_stiffness,
        oscillator_v_dot_by_oscillator_damping,
        oscillator_v_dot_by_stop_distance,
        oscillator_v_dot_by_stop_stiffness,
        oscillator_v_dot_by_stop_damping,
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
    [R::literal(0.0), R::literal(0.0), R::literal(0.0)]
}

/// Wanted outputs.
///
/// 5 operations.
#[must_use]
pub fn outputs<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>) -> Outputs<R> {
    let [oscillator_x, oscillator_v, stop_closed] = *state;
    let stop_compression = oscillator_x - p.stop_distance;
    let stop_push = (p.stop_damping * oscillator_v)
        .add_product(p.stop_stiffness, stop_compression);
    Outputs {
        deflection: oscillator_x,
        velocity: oscillator_v,
        force: R::select_less(stop_closed, R::literal(0.5), R::literal(0.0), stop_push),
        closed: stop_closed,
    }
}

/// T, V and the energy of first-order states \[J\].
///
/// 12 operations.
#[must_use]
pub fn energy<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>) -> Energy<R> {
    let [oscillator_x, oscillator_v, stop_closed] = *state;
    let stop_compression = oscillator_x - p.stop_distance;
    Energy {
        kinetic: R::literal(0.5) * p.oscillator_mass * (oscillator_v * oscillator_v),
        potential: R::select_less(
                stop_closed,
                R::literal(0.5),
                R::literal(0.0),
                R::literal(0.5) * p.stop_stiffness
                    * (stop_compression * stop_compression),
            )
            .add_product(
                R::literal(0.5) * p.oscillator_stiffness,
                oscillator_x * oscillator_x,
            ),
        stored: R::literal(0.0),
    }
}

/// `dE/dt`, power supplied and power dissipated \[W\].
///
/// 23 operations.
#[must_use]
pub fn power_balance<R: Real>(
    _time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
) -> PowerBalance<R> {
    let [oscillator_x, oscillator_v, stop_closed] = *state;
    let stop_compression = oscillator_x - p.stop_distance;
    let stop_damping_times_oscillator_v = p.stop_damping * oscillator_v;
    let t0 = p.oscillator_stiffness * oscillator_x;
    let t1 = p.oscillator_damping * oscillator_v;
    let oscillator_v_dot = (R::select_less(
        stop_closed,
        R::literal(0.5),
        R::literal(0.0),
        (p.stop_distance * p.stop_stiffness).sub_product(p.stop_stiffness, oscillator_x)
            - stop_damping_times_oscillator_v,
    ) - t0 - t1) * (R::literal(1.0) / p.oscillator_mass);
    PowerBalance {
        stored_rate: ((t0
            + R::select_less(
                stop_closed,
                R::literal(0.5),
                R::literal(0.0),
                p.stop_stiffness * stop_compression,
            )) * oscillator_v)
            .add_product(p.oscillator_mass * oscillator_v, oscillator_v_dot),
        supplied: R::literal(0.0),
        dissipated: oscillator_v
            * (t1
                + R::select_less(
                    stop_closed,
                    R::literal(0.5),
                    R::literal(0.0),
                    stop_damping_times_oscillator_v,
                )),
    }
}

/// What passes zero where an event happens, in the order of `EVENT_SHAPES`.
///
/// 5 operations.
#[must_use]
pub fn guards<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>) -> [R; EVENTS] {
    let [oscillator_x, oscillator_v, ..] = *state;
    let stop_compression = oscillator_x - p.stop_distance;
    let t0 = p.stop_stiffness * stop_compression;
    let stop_push = t0.add_product(p.stop_damping, oscillator_v);
    let stop_contact = R::select_less(t0, stop_push, t0, stop_push);
    [stop_contact, stop_contact]
}

/// `dg/dt` of the guards along the motion.
///
/// 19 operations.
#[must_use]
pub fn guard_rates<R: Real>(
    _time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
) -> [R; EVENTS] {
    let [oscillator_x, oscillator_v, stop_closed] = *state;
    let stop_compression = oscillator_x - p.stop_distance;
    let stop_damping_times_oscillator_v = p.stop_damping * oscillator_v;
    let t0 = p.stop_stiffness * stop_compression;
    let stop_push = stop_damping_times_oscillator_v + t0;
    let oscillator_v_dot = R::select_less(
            stop_closed,
            R::literal(0.5),
            R::literal(0.0),
            (p.stop_distance * p.stop_stiffness)
                .sub_product(p.stop_stiffness, oscillator_x)
                - stop_damping_times_oscillator_v,
        )
        .sub_product(p.oscillator_stiffness, oscillator_x)
        .sub_product(p.oscillator_damping, oscillator_v)
        * (R::literal(1.0) / p.oscillator_mass);
    let stop_touches_guard_rate = (p.stop_stiffness * oscillator_v)
        .add_product(
            R::select_less(t0, stop_push, R::literal(0.0), p.stop_damping),
            oscillator_v_dot,
        );
    [stop_touches_guard_rate, stop_touches_guard_rate]
}

/// New values of the states that each event sets, event by event.
///
/// No operations.
#[must_use]
pub fn resets<R: Real>(
    _time: R,
    _state: &[R; STATES],
    _p: &Parameters<R>,
) -> [R; RESETS] {
    [R::literal(1.0), R::literal(0.0)]
}

/// Normalized Taylor coefficients of the solution through `state`, order after order.
///
/// `_k` marks the coefficient of order k, `_before` that of order k - 1; bare names are
/// zeroth coefficients. The workspace is as `series_workspace` says.
///
/// 24 recurrences. No sums of products.
///
/// # Panics
/// If there is no room for the zeroth coefficients, or the workspace is too short.
pub fn series<R: Real>(
    _time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
    coefficients: &mut [[R; STATES]],
    _workspace: &mut [R],
) {
    let [oscillator_x, oscillator_v, stop_closed] = *state;
    let t0 = oscillator_v * p.stop_damping;
    let t1 = R::literal(1.0) / p.oscillator_mass;
    let t2 = oscillator_x * p.oscillator_stiffness;
    let t3 = oscillator_v * p.oscillator_damping;
    let t4 = oscillator_x * p.stop_stiffness;
    let t5 = p.stop_distance * p.stop_stiffness;
    let t6 = t5 - t4;
    let t7 = t6 - t0;
    let t8 = R::select_less(stop_closed, R::literal(0.5), R::literal(0.0), t7);
    let t9 = t8 - t2;
    let t10 = t9 - t3;
    let oscillator_v_dot = t10 * t1;
    let mut rates = [oscillator_v, oscillator_v_dot, R::literal(0.0)];
    coefficients[0] = *state;
    let highest = coefficients.len() - 1;
    for (order, state_k) in coefficients.iter_mut().enumerate().skip(1) {
        let (_, inverse) = order_and_inverse::<R>(order);
        *state_k = rates.map(|rate| rate * inverse);
        if order == highest {
            break;
        }
        let [oscillator_x_k, oscillator_v_k, ..] = *state_k;
        let t6_k = -oscillator_x_k * p.stop_stiffness;
        let t7_k = (-oscillator_v_k).mul_add(p.stop_damping, t6_k);
        let t8_k = R::select_less(stop_closed, R::literal(0.5), R::literal(0.0), t7_k);
        let t9_k = (-oscillator_x_k).mul_add(p.oscillator_stiffness, t8_k);
        let t10_k = (-oscillator_v_k).mul_add(p.oscillator_damping, t9_k);
        let oscillator_v_dot_k = t10_k * t1;
        rates = [oscillator_v_k, oscillator_v_dot_k, R::literal(0.0)];
    }
}

impl<R: Real> TaylorSeries<R> for ContactOscillator {
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

impl Describe for ContactOscillator {
    fn name(&self) -> &'static str {
        "contact_oscillator"
    }
    fn title(&self) -> &'static str {
        "Oscillator with a one-sided stop"
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

impl<R: Real> Simulator<R> for ContactOscillator {
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
        name: "oscillator.x",
        unit: "m",
        doc: "deflection of the spring",
    },
    Quantity {
        name: "oscillator.v",
        unit: "m/s",
        doc: "rate of deflection of the spring",
    },
    Quantity {
        name: "stop.closed",
        unit: "1",
        doc: "1 while the stop is touched",
    },
];

static STATE_SCALES: [f64; STATES] = [0.01, 0.1, 1.0];

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
        name: "stop.damping",
        unit: "N s/m",
        doc: "damper of the stop",
    },
];

static PARAMETER_DEFAULTS: [f64; PARAMETERS] = [
    -0.02,
    1.0,
    400.0,
    0.0,
    0.005,
    10000.0,
    0.0,
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
    Quantity {
        name: "force",
        unit: "N",
        doc: "force of the stop",
    },
    Quantity {
        name: "closed",
        unit: "1",
        doc: "1 while the stop is touched",
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
        name: "stop.touches",
        doc: "the stop is touched",
        direction: Direction::Rising,
        when: &[(2, 0.0)],
        sets: &[2],
    },
    Event {
        name: "stop.opens",
        doc: "the stop would pull",
        direction: Direction::Falling,
        when: &[(2, 1.0)],
        sets: &[2],
    },
];

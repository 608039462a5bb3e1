// Emitted by Machinist 0.1.0; do not edit. To make it again:
//
//     cargo run --release -- gen
//
// Sources, with SHA-256:
//   f8abff35e6a069e781dcda976b8f3f0d885f93c6048f990fe8344a6d5dacec2c  scenes/bouncing_mass.toml
//   eef0d63eed8eb3949487ee6297ac61f06319df67e7bc044a0e177113dff0b858  units/bouncer.toml
//
// Mass bouncing on a shaken plate
//
// The plate shakes at 10 Hz with an acceleration amplitude of 0.7 g. The mass settles into one bounce
// per period.
//
// Source:
//   Textbook; the orbit of one bounce a period is in closed form.
//
// All quantities are in SI units.
// Shapes: coordinates 1, first-order states 1, states 3, parameters 8, outputs 4, events 2.
// Nonzeros: mass_matrix 1 of 1 by 1, rate_jacobian 1 of 3 by 3, parameter_jacobian 3 of 3 by 8.
// Operations: rate 12, forcing 10, parameter_jacobian 23, time_derivative 10, outputs 4, energy 5,
//     power_balance 18, guards 8, guard_rates 9, resets 23, prepare 6, prepared_rate 9,
//     prepared_jacobians 18.

use ::machinist_contract::{Energy, PowerBalance, Real, taylor::order_and_inverse};

::machinist_contract::simulator! {
    /// Mass bouncing on a shaken plate
    ///
    /// The plate shakes at 10 Hz with an acceleration amplitude of 0.7 g. The mass settles into one bounce
    /// per period.
    ///
    /// Source: Textbook; the orbit of one bounce a period is in closed form.
    BouncingMass: "bouncing_mass", "Mass bouncing on a shaken plate";
    run from 0.0, until 2.0, points 2001, rtol 1e-8, method "dop853";
    quadratures 0, discontinuities 0;
    events; prepared; jacobians_at_once; linear; series 0;
}

::machinist_contract::parameters! {
    amplitude: 0.001_739_5, "m", "amplitude", "A, amplitude of the plate";
    frequency: 62.831_853_071_795_86, "rad/s", "frequency", "w, angular frequency of the plate";
    height: 0.009, "m", "height", "initial height of the mass";
    speed: -0.33, "m/s", "speed", "initial upward velocity of the mass";
    ball_mass: 0.5, "kg", "ball.mass", "mass";
    ball_gravity: 9.81, "m/s^2", "ball.gravity", "gravitational acceleration";
    ball_restitution: 0.8, "1", "ball.restitution", "coefficient of restitution";
    ball_rest_speed: 0.0001, "m/s", "ball.rest_speed", "impact speed below which the mass stays on the plate";
}

::machinist_contract::outputs! {
    height: "m", "height", "height of the mass";
    gap: "m", "gap", "gap between mass and plate";
    plate: "m", "plate", "height of the plate";
    resting: "1", "resting", "1 while the mass stays on the plate";
}

::machinist_contract::states! {
    BALL_X: position, 0.01, "m", "ball.x", "height of the mass";
    BALL_V: velocity, 0.3, "m/s", "ball.v", "rate of height of the mass";
    BALL_RESTING: mode, 1.0, "1", "ball.resting", "1 while the mass stays on the plate";
}

::machinist_contract::events! {
    "ball.impact": Falling moves_guard, when [(2, 0.0)], sets [1, 2], "impact on the plate";
    "ball.lift_off": Falling, when [(2, 1.0)], sets [2], "the mass lifts off the plate";
}

::machinist_contract::patterns! {
    /// Nonzeros of M.
    MASS_MATRIX_PATTERN: 1 by 1 { 0 [0] }
    /// Nonzeros of dy'/dy.
    RATE_JACOBIAN_PATTERN: 3 by 3 { 0 [1] }
    /// Nonzeros of dy'/dp.
    PARAMETER_JACOBIAN_PATTERN: 3 by 8 { 1 [0 1 5] }
}

::machinist_contract::constants! {
    frequency_squared, inverse_ball_mass, ball_mass_times_ball_gravity, amplitude_times_frequency,
    ball_mass_times_frequency_squared, t0
}

/// Returns the constants of `rate` and its Jacobians from the parameters. 6 operations.
#[must_use]
#[inline]
pub fn prepare<R: Real>(p: &Parameters<R>) -> Constants<R> {
    let frequency_squared = p.frequency * p.frequency;
    let inverse_ball_mass = R::literal(1.0) / p.ball_mass;
    let ball_mass_times_ball_gravity = p.ball_mass * p.ball_gravity;
    let amplitude_times_frequency = p.amplitude * p.frequency;
    let ball_mass_times_frequency_squared = p.ball_mass * frequency_squared;
    let t0 = R::literal(-2.0) * p.frequency;
    Constants { frequency_squared, inverse_ball_mass, ball_mass_times_ball_gravity,
        amplitude_times_frequency, ball_mass_times_frequency_squared, t0 }
}

/// State at the start of the run, in the units of the states. No operations.
#[must_use]
pub fn initial_state<R: Real>(p: &Parameters<R>) -> [R; STATES] {
    [p.height, p.speed, R::literal(0.0)]
}

/// Times of known jumps of the right-hand side \[s\], unsorted. No operations.
#[must_use]
pub fn discontinuities<R: Real>(_p: &Parameters<R>) -> [R; DISCONTINUITIES] {
    []
}

/// As `rate`, with the constants of the parameters from `prepare`. 9 operations.
#[must_use]
#[inline]
pub fn prepared_rate<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>,
        c: &Constants<R>) -> [R; STATES] {
    let [_, ball_v, ball_resting] = *state;
    let plate = p.amplitude * (p.frequency * time).sin();
    let ball_weight = p.ball_mass * p.ball_gravity.sub_product(c.frequency_squared, plate);
    let ball_contact_force = R::select_less(ball_resting, R::literal(0.5), R::literal(0.0),
        ball_weight);
    let ball_v_dot = (ball_contact_force - c.ball_mass_times_ball_gravity) * c.inverse_ball_mass;
    [ball_v, ball_v_dot, R::literal(0.0)]
}

/// `M = d2L/dq'2`, values in the order of its pattern. No operations.
#[must_use]
pub fn mass_matrix<R: Real>(_time: R, _state: &[R; STATES], p: &Parameters<R>) -> [R; 1] {
    [p.ball_mass]
}

/// `f` of `M q'' = f + G^T lambda`, one for each coordinate. 10 operations.
#[must_use]
pub fn forcing<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>) -> [R; COORDINATES] {
    let [_, _, ball_resting] = *state;
    let plate = p.amplitude * (p.frequency * time).sin();
    let ball_weight = p.ball_mass * p.ball_gravity.sub_product(p.frequency * p.frequency, plate);
    let ball_contact_force = R::select_less(ball_resting, R::literal(0.5), R::literal(0.0),
        ball_weight);
    let ball_x_forcing = ball_contact_force.sub_product(p.ball_mass, p.ball_gravity);
    [ball_x_forcing]
}

/// As `rate_jacobian`, with the constants of the parameters from `prepare`. No operations.
#[must_use]
pub fn prepared_rate_jacobian<R: Real>(_time: R, _state: &[R; STATES], _p: &Parameters<R>,
        _c: &Constants<R>) -> [R; 1] {
    [R::literal(1.0)]
}

/// `rate_jacobian`, then `parameter_jacobian`, with the constants of the parameters from `prepare`.
/// 18 operations.
#[must_use]
pub fn prepared_jacobians<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>,
        c: &Constants<R>) -> [R; 4] {
    let [_, _, ball_resting] = *state;
    let frequency_times_time = p.frequency * time;
    let (sin_frequency_times_time, cos_frequency_times_time) = frequency_times_time.sin_cos();
    let plate = p.amplitude * sin_frequency_times_time;
    let plate_speed = c.amplitude_times_frequency * cos_frequency_times_time;
    let ball_v_dot_by_amplitude = R::select_less(ball_resting, R::literal(0.5), R::literal(0.0),
        -(c.ball_mass_times_frequency_squared * sin_frequency_times_time * c.inverse_ball_mass));
    let ball_v_dot_by_frequency = R::select_less(ball_resting, R::literal(0.5), R::literal(0.0),
        p.ball_mass * (c.t0 * plate).sub_product(frequency_times_time, plate_speed)
        * c.inverse_ball_mass);
    let ball_v_dot_by_ball_gravity = (R::select_less(ball_resting, R::literal(0.5),
        R::literal(0.0), p.ball_mass) - p.ball_mass) * c.inverse_ball_mass;
    [R::literal(1.0), ball_v_dot_by_amplitude, ball_v_dot_by_frequency, ball_v_dot_by_ball_gravity]
}

/// Partial derivative of `y'` with respect to time. 10 operations.
#[must_use]
pub fn time_derivative<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>) -> [R; STATES] {
    let [_, _, ball_resting] = *state;
    let plate_speed = p.amplitude * p.frequency * (p.frequency * time).cos();
    let ball_v_dot_by_time = R::select_less(ball_resting, R::literal(0.5), R::literal(0.0),
        p.ball_mass * (p.frequency * p.frequency) * plate_speed * (R::literal(-1.0) / p.ball_mass));
    [R::literal(0.0), ball_v_dot_by_time, R::literal(0.0)]
}

/// Wanted outputs. 4 operations.
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

/// T, V and the energy of first-order states \[J\]. 5 operations.
#[must_use]
pub fn energy<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>) -> Energy<R> {
    let [ball_x, ball_v, ..] = *state;
    Energy {
        kinetic: R::literal(0.5) * p.ball_mass * (ball_v * ball_v),
        potential: p.ball_mass * p.ball_gravity * ball_x,
        stored: R::literal(0.0),
    }
}

/// `dE/dt`, power supplied and power dissipated \[W\]. 18 operations.
#[must_use]
pub fn power_balance<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>) -> PowerBalance<R> {
    let [_, ball_v, ball_resting] = *state;
    let plate = p.amplitude * (p.frequency * time).sin();
    let ball_weight = p.ball_mass * p.ball_gravity.sub_product(p.frequency * p.frequency, plate);
    let ball_contact_force = R::select_less(ball_resting, R::literal(0.5), R::literal(0.0),
        ball_weight);
    let ball_mass_times_ball_gravity = p.ball_mass * p.ball_gravity;
    let ball_v_dot = (ball_contact_force - ball_mass_times_ball_gravity) * (R::literal(1.0)
        / p.ball_mass);
    PowerBalance {
        stored_rate: (ball_mass_times_ball_gravity * ball_v).add_product(p.ball_mass * ball_v,
            ball_v_dot),
        supplied: R::select_less(ball_resting, R::literal(0.5), R::literal(0.0), ball_v
            * ball_weight),
        dissipated: R::literal(0.0),
    }
}

/// What passes zero where events happen, one for each event. 8 operations.
#[must_use]
pub fn guards<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>) -> [R; EVENTS] {
    let [ball_x, ..] = *state;
    let plate = p.amplitude * (p.frequency * time).sin();
    let ball_gap = ball_x - plate;
    let ball_weight = p.ball_mass * p.ball_gravity.sub_product(p.frequency * p.frequency, plate);
    [ball_gap, ball_weight]
}

/// `dg/dt` of the guards along the motion. 9 operations.
#[must_use]
pub fn guard_rates<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>) -> [R; EVENTS] {
    let [_, ball_v, ..] = *state;
    let plate_speed = p.amplitude * p.frequency * (p.frequency * time).cos();
    let ball_approach = ball_v - plate_speed;
    let ball_lift_off_guard_rate = -(p.ball_mass * (p.frequency * p.frequency) * plate_speed);
    [ball_approach, ball_lift_off_guard_rate]
}

/// New values of the entries that each event sets, computed from the state before it: those of the
/// first event, in the order of its `sets`, then those of the second, and so on. 23 operations.
#[must_use]
pub fn resets<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>) -> [R; RESETS] {
    let [_, ball_v, ..] = *state;
    let frequency_times_time = p.frequency * time;
    let (sin_frequency_times_time, cos_frequency_times_time) = frequency_times_time.sin_cos();
    let plate = p.amplitude * sin_frequency_times_time;
    let plate_speed = p.amplitude * p.frequency * cos_frequency_times_time;
    let ball_approach = ball_v - plate_speed;
    let ball_weight = p.ball_mass * p.ball_gravity.sub_product(p.frequency * p.frequency, plate);
    let ball_settles = R::literal(0.25) * (R::literal(1.0) - R::select_less(-(p.ball_rest_speed
        + ball_approach), R::literal(0.0), R::literal(-1.0), R::literal(1.0))) * (R::literal(1.0)
        + R::select_less(ball_weight, R::literal(0.0), R::literal(-1.0), R::literal(1.0)));
    let ball_v_after_ball_impact = plate_speed.sub_product(p.ball_restitution * ball_approach,
        R::literal(1.0) - ball_settles);
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
pub fn series<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>,
        coefficients: &mut [[R; STATES]], _workspace: &mut [R]) {
    let [_, ball_v, ball_resting] = *state;
    let t0 = time * p.frequency;
    let t1 = t0.sin();
    let t2 = t0.cos();
    let t3 = p.frequency * p.frequency;
    let t4 = p.amplitude * t3;
    let t5 = t1 * t4;
    let t6 = p.ball_gravity - t5;
    let ball_weight = t6 * p.ball_mass;
    let ball_contact_force = R::select_less(ball_resting, R::literal(0.5), R::literal(0.0),
        ball_weight);
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
        let ball_contact_force_k = R::select_less(ball_resting, R::literal(0.5), R::literal(0.0),
            ball_weight_k);
        let ball_v_dot_k = ball_contact_force_k * t7;
        t1_before = t1_k;
        t2_before = t2_k;
        rates = [ball_v_k, ball_v_dot_k, R::literal(0.0)];
    }
}

/// Row on which a term `t^k e^(g t) (C cos(w t) + S sin(w t))` acts, and k. Rows are rates of the state, then guards of events, then those of kinks.
pub const EXCITATION_TERMS: [(u32, u32); 5] = [(1, 0), (1, 0), (3, 0), (4, 0), (4, 0)];

/// Row and entry of the state of each nonzero slope, if there are guards.
pub const SLOPES: [(u32, u32); 2] = [(0, 1), (3, 0)];

/// Times at which pieces of the excitation end.
pub const SWITCHES: usize = 0;

/// g, w, C and S of every term of the excitation, then the slopes, on the piece that holds `time`,
/// in the modes of a state. 13 operations.
#[must_use]
pub fn excitation<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>) -> [R; 22] {
    let [_, _, ball_resting] = *state;
    let ball_gravity_times_ball_mass = p.ball_gravity * p.ball_mass;
    let t0 = p.amplitude * (p.frequency * p.frequency) * p.ball_mass;
    let inverse_ball_mass = R::literal(1.0) / p.ball_mass;
    [R::literal(0.0), R::literal(0.0), (R::select_less(ball_resting, R::literal(0.5),
        R::literal(0.0), ball_gravity_times_ball_mass)
        - ball_gravity_times_ball_mass) * inverse_ball_mass, R::literal(0.0), R::literal(0.0),
        p.frequency, R::literal(0.0), R::select_less(ball_resting, R::literal(0.5),
        R::literal(0.0), -(t0 * inverse_ball_mass)), R::literal(0.0), p.frequency, R::literal(0.0),
        -p.amplitude, R::literal(0.0), R::literal(0.0), ball_gravity_times_ball_mass,
        R::literal(0.0), R::literal(0.0), p.frequency, R::literal(0.0), -t0, R::literal(1.0),
        R::literal(1.0)]
}

/// Times at which pieces of the excitation end \[s\]; not finite where there is none. No
/// operations.
#[must_use]
pub fn switches<R: Real>(_p: &Parameters<R>) -> [R; SWITCHES] {
    []
}

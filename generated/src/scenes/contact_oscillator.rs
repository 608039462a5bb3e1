// Emitted by Machinist 0.1.0; do not edit. To make it again:
//
//     cargo run --release -- gen
//
// Sources, with SHA-256:
//   0f6b56796f383d0b9880c6df9360bbad4a8dc600a310a7846ffaa1c962b1d74e  scenes/contact_oscillator.toml
//   c8af9cbc8f8bab7920483e7aee1409777c222910f5dd879848e293281ff61e58  units/sprung_mass.toml
//   be7f9d9c9d2b686ed58c85e7716c3da26c6f969604d8c11b496c98253a874cdc  units/stop.toml
//
// Oscillator with a one-sided stop
//
// A mass on a spring meets an elastic stop on one side: a piecewise linear oscillator.
//
// Source:
//   Textbook; exact, stitched from sinusoids.
//
// All quantities are in SI units.
// Shapes: coordinates 1, first-order states 1, states 3, parameters 7, outputs 4, events 2, kinks 1,
//     relations 1.
// Nonzeros: mass_matrix 1 of 1 by 1, rate_jacobian 3 of 3 by 3, parameter_jacobian 6 of 3 by 7.
// Operations: rate 12, forcing 10, rate_jacobian 9, parameter_jacobian 24, outputs 5, energy 12,
//     power_balance 23, guards 6, guard_rates 20, kink_guards 5, kink_rates 16, prepare 5,
//     prepared_rate 10, prepared_rate_jacobian 6, prepared_jacobians 27.

use ::machinist_contract::{Energy, PowerBalance, Real, taylor::order_and_inverse};

::machinist_contract::simulator! {
    /// Oscillator with a one-sided stop
    ///
    /// A mass on a spring meets an elastic stop on one side: a piecewise linear oscillator.
    ///
    /// Source: Textbook; exact, stitched from sinusoids.
    ContactOscillator: "contact_oscillator", "Oscillator with a one-sided stop";
    run from 0.0, until 2.0, points 2001, rtol 1e-8, method "dop853";
    quadratures 0, discontinuities 0;
    events; prepared; jacobians_at_once; linear; kinks 1; relations; series 0;
}

::machinist_contract::parameters! {
    deflection: -0.02, "m", "deflection", "initial deflection";
    oscillator_mass: 1.0, "kg", "oscillator.mass", "mass";
    oscillator_stiffness: 400.0, "N/m", "oscillator.stiffness", "stiffness of the spring";
    oscillator_damping: 0.0, "N s/m", "oscillator.damping", "damping";
    stop_distance: 0.005, "m", "stop.distance", "position of the stop";
    stop_stiffness: 10000.0, "N/m", "stop.stiffness", "stiffness of the stop";
    stop_damping: 0.0, "N s/m", "stop.damping", "damping of the stop";
    @ held_1: Branch;
}

::machinist_contract::outputs! {
    deflection: "m", "deflection", "deflection of the spring";
    velocity: "m/s", "velocity", "rate of deflection of the spring";
    force: "N", "force", "force of the stop";
    closed: "1", "closed", "1 while in contact";
}

::machinist_contract::states! {
    OSCILLATOR_X: position, 0.01, "m", "oscillator.x", "deflection of the spring";
    OSCILLATOR_V: velocity, 0.1, "m/s", "oscillator.v", "rate of deflection of the spring";
    STOP_CLOSED: mode, 1.0, "1", "stop.closed", "1 while in contact";
}

::machinist_contract::events! {
    "stop.touches": Rising, when [(2, 0.0)], sets [2], "contact begins";
    "stop.opens": Falling, when [(2, 1.0)], sets [2], "the stop would pull";
}

::machinist_contract::relations! {
    Branch [Event(0), Event(1)];
}

::machinist_contract::patterns! {
    /// Nonzeros of M.
    MASS_MATRIX_PATTERN: 1 by 1 { 0 [0] }
    /// Nonzeros of dy'/dy.
    RATE_JACOBIAN_PATTERN: 3 by 3 { 0 [1] 1 [0 1] }
    /// Nonzeros of dy'/dp.
    PARAMETER_JACOBIAN_PATTERN: 3 by 7 { 1 [1 2 3 4 5 6] }
}

::machinist_contract::constants! {
    inverse_oscillator_mass, stop_distance_times_stop_stiffness, minus_stop_stiffness,
    minus_stop_damping, t0
}

/// Returns the constants of `rate` and its Jacobians from the parameters. 5 operations.
#[must_use]
#[inline]
pub fn prepare<R: Real>(p: &Parameters<R>) -> Constants<R> {
    let inverse_oscillator_mass = R::literal(1.0) / p.oscillator_mass;
    let stop_distance_times_stop_stiffness = p.stop_distance * p.stop_stiffness;
    let minus_stop_stiffness = -p.stop_stiffness;
    let minus_stop_damping = -p.stop_damping;
    let t0 = p.stop_stiffness * inverse_oscillator_mass;
    Constants { inverse_oscillator_mass, stop_distance_times_stop_stiffness, minus_stop_stiffness,
        minus_stop_damping, t0 }
}

/// State at the start of the run, in the units of the states. No operations.
#[must_use]
pub fn initial_state<R: Real>(p: &Parameters<R>) -> [R; STATES] {
    [p.deflection, R::literal(0.0), R::literal(0.0)]
}

/// Times of known jumps of the right-hand side \[s\], unsorted. No operations.
#[must_use]
pub fn discontinuities<R: Real>(_p: &Parameters<R>) -> [R; DISCONTINUITIES] {
    []
}

/// As `rate`, with the constants of the parameters from `prepare`. 10 operations.
#[must_use]
#[inline]
pub fn prepared_rate<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>,
        c: &Constants<R>) -> [R; STATES] {
    let [oscillator_x, oscillator_v, stop_closed] = *state;
    let oscillator_v_dot = R::select_less(stop_closed, R::literal(0.5), R::literal(0.0),
        c.stop_distance_times_stop_stiffness.sub_product(p.stop_stiffness, oscillator_x)
        .sub_product(p.stop_damping, oscillator_v)).sub_product(p.oscillator_stiffness,
        oscillator_x).sub_product(p.oscillator_damping, oscillator_v) * c.inverse_oscillator_mass;
    [oscillator_v, oscillator_v_dot, R::literal(0.0)]
}

/// `M = d2L/dq'2`, values in the order of its pattern. No operations.
#[must_use]
pub fn mass_matrix<R: Real>(_time: R, _state: &[R; STATES], p: &Parameters<R>) -> [R; 1] {
    [p.oscillator_mass]
}

/// `f` of `M q'' = f + G^T lambda`, one for each coordinate. 10 operations.
#[must_use]
pub fn forcing<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>) -> [R; COORDINATES] {
    let [oscillator_x, oscillator_v, stop_closed] = *state;
    let oscillator_x_forcing = R::select_less(stop_closed, R::literal(0.5), R::literal(0.0),
        (p.stop_distance * p.stop_stiffness).sub_product(p.stop_stiffness, oscillator_x)
        .sub_product(p.stop_damping, oscillator_v)).sub_product(p.oscillator_stiffness,
        oscillator_x).sub_product(p.oscillator_damping, oscillator_v);
    [oscillator_x_forcing]
}

/// As `rate_jacobian`, with the constants of the parameters from `prepare`. 6 operations.
#[must_use]
pub fn prepared_rate_jacobian<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>,
        c: &Constants<R>) -> [R; 3] {
    let [_, _, stop_closed] = *state;
    let oscillator_v_dot_by_oscillator_x = (R::select_less(stop_closed, R::literal(0.5),
        R::literal(0.0), c.minus_stop_stiffness) - p.oscillator_stiffness)
        * c.inverse_oscillator_mass;
    let oscillator_v_dot_by_oscillator_v = (R::select_less(stop_closed, R::literal(0.5),
        R::literal(0.0), c.minus_stop_damping) - p.oscillator_damping) * c.inverse_oscillator_mass;
    [R::literal(1.0), oscillator_v_dot_by_oscillator_x, oscillator_v_dot_by_oscillator_v]
}

/// `rate_jacobian`, then `parameter_jacobian`, with the constants of the parameters from `prepare`.
/// 27 operations.
#[must_use]
pub fn prepared_jacobians<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>,
        c: &Constants<R>) -> [R; 9] {
    let [oscillator_x, oscillator_v, stop_closed] = *state;
    let oscillator_v_dot_by_oscillator_x = (R::select_less(stop_closed, R::literal(0.5),
        R::literal(0.0), c.minus_stop_stiffness) - p.oscillator_stiffness)
        * c.inverse_oscillator_mass;
    let oscillator_v_dot_by_oscillator_v = (R::select_less(stop_closed, R::literal(0.5),
        R::literal(0.0), c.minus_stop_damping) - p.oscillator_damping) * c.inverse_oscillator_mass;
    let oscillator_v_dot = R::select_less(stop_closed, R::literal(0.5), R::literal(0.0),
        c.stop_distance_times_stop_stiffness.sub_product(p.stop_stiffness, oscillator_x)
        .sub_product(p.stop_damping, oscillator_v)).sub_product(p.oscillator_stiffness,
        oscillator_x).sub_product(p.oscillator_damping, oscillator_v) * c.inverse_oscillator_mass;
    let oscillator_v_dot_by_oscillator_mass = -(oscillator_v_dot * c.inverse_oscillator_mass);
    let oscillator_v_dot_by_oscillator_stiffness = -(oscillator_x * c.inverse_oscillator_mass);
    let oscillator_v_dot_by_oscillator_damping = -(oscillator_v * c.inverse_oscillator_mass);
    let oscillator_v_dot_by_stop_distance = R::select_less(stop_closed, R::literal(0.5),
        R::literal(0.0), c.t0);
    let oscillator_v_dot_by_stop_stiffness = R::select_less(stop_closed, R::literal(0.5),
        R::literal(0.0), (p.stop_distance - oscillator_x) * c.inverse_oscillator_mass);
    let oscillator_v_dot_by_stop_damping = R::select_less(stop_closed, R::literal(0.5),
        R::literal(0.0), oscillator_v_dot_by_oscillator_damping);
    [R::literal(1.0), oscillator_v_dot_by_oscillator_x, oscillator_v_dot_by_oscillator_v,
        oscillator_v_dot_by_oscillator_mass, oscillator_v_dot_by_oscillator_stiffness,
        oscillator_v_dot_by_oscillator_damping, oscillator_v_dot_by_stop_distance,
        oscillator_v_dot_by_stop_stiffness, oscillator_v_dot_by_stop_damping]
}

/// Partial derivative of `y'` with respect to time. No operations.
#[must_use]
pub fn time_derivative<R: Real>(_time: R, _state: &[R; STATES], _p: &Parameters<R>) -> [R; STATES] {
    [R::literal(0.0), R::literal(0.0), R::literal(0.0)]
}

/// Wanted outputs. 5 operations.
#[must_use]
pub fn outputs<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>) -> Outputs<R> {
    let [oscillator_x, oscillator_v, stop_closed] = *state;
    let stop_compression = oscillator_x - p.stop_distance;
    let stop_push = (p.stop_damping * oscillator_v).add_product(p.stop_stiffness, stop_compression);
    Outputs {
        deflection: oscillator_x,
        velocity: oscillator_v,
        force: R::select_less(stop_closed, R::literal(0.5), R::literal(0.0), stop_push),
        closed: stop_closed,
    }
}

/// T, V and the energy of first-order states \[J\]. 12 operations.
#[must_use]
pub fn energy<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>) -> Energy<R> {
    let [oscillator_x, oscillator_v, stop_closed] = *state;
    let stop_compression = oscillator_x - p.stop_distance;
    Energy {
        kinetic: R::literal(0.5) * p.oscillator_mass * (oscillator_v * oscillator_v),
        potential: R::select_less(stop_closed, R::literal(0.5), R::literal(0.0), R::literal(0.5)
            * p.stop_stiffness * (stop_compression * stop_compression)).add_product(R::literal(0.5)
            * p.oscillator_stiffness, oscillator_x * oscillator_x),
        stored: R::literal(0.0),
    }
}

/// `dE/dt`, power supplied and power dissipated \[W\]. 23 operations.
#[must_use]
pub fn power_balance<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>) -> PowerBalance<R> {
    let [oscillator_x, oscillator_v, stop_closed] = *state;
    let stop_compression = oscillator_x - p.stop_distance;
    let stop_damping_times_oscillator_v = p.stop_damping * oscillator_v;
    let t0 = p.oscillator_stiffness * oscillator_x;
    let t1 = p.oscillator_damping * oscillator_v;
    let oscillator_v_dot = (R::select_less(stop_closed, R::literal(0.5), R::literal(0.0),
        (p.stop_distance * p.stop_stiffness).sub_product(p.stop_stiffness, oscillator_x)
        - stop_damping_times_oscillator_v) - t0 - t1) * (R::literal(1.0) / p.oscillator_mass);
    PowerBalance {
        stored_rate: ((t0 + R::select_less(stop_closed, R::literal(0.5), R::literal(0.0),
            p.stop_stiffness * stop_compression)) * oscillator_v).add_product(p.oscillator_mass
            * oscillator_v, oscillator_v_dot),
        supplied: R::literal(0.0),
        dissipated: oscillator_v * (t1 + R::select_less(stop_closed, R::literal(0.5),
            R::literal(0.0), stop_damping_times_oscillator_v)),
    }
}

/// What passes zero where events happen, one for each event. 6 operations.
#[must_use]
pub fn guards<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>) -> [R; EVENTS] {
    let [oscillator_x, oscillator_v, ..] = *state;
    let stop_compression = oscillator_x - p.stop_distance;
    let t0 = p.stop_stiffness * stop_compression;
    let stop_push = t0.add_product(p.stop_damping, oscillator_v);
    let stop_contact = R::select_less(t0 + p.held_1, stop_push, t0, stop_push);
    [stop_contact, stop_contact]
}

/// `dg/dt` of the guards along the motion. 20 operations.
#[must_use]
pub fn guard_rates<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>) -> [R; EVENTS] {
    let [oscillator_x, oscillator_v, stop_closed] = *state;
    let stop_compression = oscillator_x - p.stop_distance;
    let stop_damping_times_oscillator_v = p.stop_damping * oscillator_v;
    let t0 = p.stop_stiffness * stop_compression;
    let stop_push = stop_damping_times_oscillator_v + t0;
    let oscillator_v_dot = R::select_less(stop_closed, R::literal(0.5), R::literal(0.0),
        (p.stop_distance * p.stop_stiffness).sub_product(p.stop_stiffness, oscillator_x)
        - stop_damping_times_oscillator_v).sub_product(p.oscillator_stiffness, oscillator_x)
        .sub_product(p.oscillator_damping, oscillator_v) * (R::literal(1.0) / p.oscillator_mass);
    let stop_touches_guard_rate = (p.stop_stiffness * oscillator_v).add_product(R::select_less(t0
        + p.held_1, stop_push, R::literal(0.0), p.stop_damping), oscillator_v_dot);
    [stop_touches_guard_rate, stop_touches_guard_rate]
}

/// New values of the entries that each event sets, computed from the state before it: those of the
/// first event, in the order of its `sets`, then those of the second, and so on. No operations.
#[must_use]
pub fn resets<R: Real>(_time: R, _state: &[R; STATES], _p: &Parameters<R>) -> [R; RESETS] {
    [R::literal(1.0), R::literal(0.0)]
}

/// What passes zero where the rate has a kink or a jump: arguments of `abs` and `sign`, differences
/// of what `min` and `max` compare, ends of tables. 5 operations.
#[must_use]
pub fn kink_guards<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>) -> [R; KINKS] {
    let [oscillator_x, oscillator_v, ..] = *state;
    let stop_compression = oscillator_x - p.stop_distance;
    let t0 = p.stop_stiffness * stop_compression;
    let stop_push = t0.add_product(p.stop_damping, oscillator_v);
    let kink_1 = t0 - stop_push;
    [kink_1]
}

/// Rates along the motion of what passes zero at kinks. 16 operations.
#[must_use]
pub fn kink_rates<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>) -> [R; KINKS] {
    let [oscillator_x, oscillator_v, stop_closed] = *state;
    let oscillator_v_dot = R::select_less(stop_closed, R::literal(0.5), R::literal(0.0),
        (p.stop_distance * p.stop_stiffness).sub_product(p.stop_stiffness, oscillator_x)
        .sub_product(p.stop_damping, oscillator_v)).sub_product(p.oscillator_stiffness,
        oscillator_x).sub_product(p.oscillator_damping, oscillator_v) * (R::literal(1.0)
        / p.oscillator_mass);
    let stop_stiffness_times_oscillator_v = p.stop_stiffness * oscillator_v;
    let kink_rate_1 = stop_stiffness_times_oscillator_v - stop_stiffness_times_oscillator_v
        .add_product(p.stop_damping, oscillator_v_dot);
    [kink_rate_1]
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
pub fn series<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>,
        coefficients: &mut [[R; STATES]], _workspace: &mut [R]) {
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

/// Row on which a term `t^k e^(g t) (C cos(w t) + S sin(w t))` acts, and k. Rows are rates of the state, then guards of events, then those of kinks.
pub const EXCITATION_TERMS: [(u32, u32); 3] = [(1, 0), (3, 0), (4, 0)];

/// Row and entry of the state of each nonzero slope, if there are guards.
pub const SLOPES: [(u32, u32); 8] = [(0, 1), (1, 0), (1, 1), (3, 0), (3, 1), (4, 0), (4, 1),
    (5, 1)];
/// Times at which pieces of the excitation end.
pub const SWITCHES: usize = 0;

/// g, w, C and S of every term of the excitation, then the slopes, on the piece that holds `time`,
/// in the modes of a state. 14 operations.
#[must_use]
pub fn excitation<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>) -> [R; 20] {
    let [_, _, stop_closed] = *state;
    let stop_distance_times_stop_stiffness = p.stop_distance * p.stop_stiffness;
    let t0 = -stop_distance_times_stop_stiffness;
    let t1 = R::select_less(p.held_1, R::literal(0.0), R::literal(0.0), p.stop_damping);
    let inverse_oscillator_mass = R::literal(1.0) / p.oscillator_mass;
    let minus_stop_damping = -p.stop_damping;
    [R::literal(0.0), R::literal(0.0), R::select_less(stop_closed, R::literal(0.5),
        R::literal(0.0), stop_distance_times_stop_stiffness * inverse_oscillator_mass),
        R::literal(0.0), R::literal(0.0), R::literal(0.0), t0, R::literal(0.0), R::literal(0.0),
        R::literal(0.0), t0, R::literal(0.0), R::literal(1.0), (R::select_less(stop_closed,
        R::literal(0.5), R::literal(0.0), -p.stop_stiffness)
        - p.oscillator_stiffness) * inverse_oscillator_mass, (R::select_less(stop_closed,
        R::literal(0.5), R::literal(0.0), minus_stop_damping)
        - p.oscillator_damping) * inverse_oscillator_mass, p.stop_stiffness, t1, p.stop_stiffness,
        t1, minus_stop_damping]
}

/// Times at which pieces of the excitation end \[s\]; not finite where there is none. No
/// operations.
#[must_use]
pub fn switches<R: Real>(_p: &Parameters<R>) -> [R; SWITCHES] {
    []
}

// Emitted by Machinist 0.1.0; do not edit. To make it again:
//
//     cargo run --release -- gen
//
// Sources, with SHA-256:
//   77348d9235a88c43d426cb6ba26a022bf24c59d1bb0383851a02b3a5d3e413d4  scenes/contact_oscillator_smooth.toml
//   c8af9cbc8f8bab7920483e7aee1409777c222910f5dd879848e293281ff61e58  units/sprung_mass.toml
//   26d300375a958de6b3de07d817393c5eeb494f9bcbb81aac4c13ce990277d88b  units/stop_smooth.toml
//
// Oscillator with a one-sided stop, smoothed
//
// Smoothed variant of `contact_oscillator`.
//
// Source:
//   Textbook.
//
// All quantities are in SI units.
// Shapes: coordinates 1, states 2, parameters 7, outputs 2.
// Nonzeros: mass_matrix 1 of 1 by 1, rate_jacobian 3 of 2 by 2, parameter_jacobian 6 of 2 by 7.
// Operations: rate 17, forcing 15, rate_jacobian 24, parameter_jacobian 49, energy 16,
//     power_balance 23, prepare 10, prepared_rate 14, prepared_rate_jacobian 19,
//     prepared_jacobians 47.

use ::machinist_contract::{
    Energy, PowerBalance, Real, taylor::{Lanes, order_and_inverse},
};

::machinist_contract::simulator! {
    /// Oscillator with a one-sided stop, smoothed
    ///
    /// Smoothed variant of \`contact_oscillator\`.
    ///
    /// Source: Textbook.
    ContactOscillatorSmooth: "contact_oscillator_smooth", "Oscillator with a one-sided stop, smoothed";
    run from 0.0, until 2.0, points 2001, rtol 1e-8, method "dop853";
    quadratures 0, discontinuities 0;
    prepared; jacobians_at_once; series 4;
}

::machinist_contract::parameters! {
    deflection: -0.02, "m", "deflection", "initial deflection";
    oscillator_mass: 1.0, "kg", "oscillator.mass", "mass";
    oscillator_stiffness: 400.0, "N/m", "oscillator.stiffness", "stiffness of the spring";
    oscillator_damping: 0.0, "N s/m", "oscillator.damping", "damping";
    stop_distance: 0.005, "m", "stop.distance", "position of the stop";
    stop_stiffness: 10000.0, "N/m", "stop.stiffness", "stiffness of the stop";
    stop_width: 0.0005, "m", "stop.width", "travel over which the force bends";
}

::machinist_contract::outputs! {
    deflection: "m", "deflection", "deflection of the spring";
    velocity: "m/s", "velocity", "rate of deflection of the spring";
}

::machinist_contract::states! {
    OSCILLATOR_X: position, 0.01, "m", "oscillator.x", "deflection of the spring";
    OSCILLATOR_V: velocity, 0.1, "m/s", "oscillator.v", "rate of deflection of the spring";
}

::machinist_contract::patterns! {
    /// Nonzeros of M.
    MASS_MATRIX_PATTERN: 1 by 1 { 0 [0] }
    /// Nonzeros of dy'/dy.
    RATE_JACOBIAN_PATTERN: 2 by 2 { 0 [1] 1 [0 1] }
    /// Nonzeros of dy'/dp.
    PARAMETER_JACOBIAN_PATTERN: 2 by 7 { 1 [1 2 3 4 5 6] }
}

::machinist_contract::constants! {
    stop_width_squared, inverse_oscillator_mass, t0, t1, oscillator_v_dot_by_oscillator_v, t2, t3,
    stop_stiffness_times_stop_width
}

/// Returns the constants of `rate` and its Jacobians from the parameters. 10 operations.
#[must_use]
#[inline]
pub fn prepare<R: Real>(p: &Parameters<R>) -> Constants<R> {
    let stop_width_squared = p.stop_width * p.stop_width;
    let inverse_oscillator_mass = R::literal(1.0) / p.oscillator_mass;
    let t0 = R::literal(-0.25) * p.stop_stiffness;
    let t1 = R::literal(0.25) * p.stop_stiffness;
    let oscillator_v_dot_by_oscillator_v = -(p.oscillator_damping * inverse_oscillator_mass);
    let t2 = R::literal(0.5) * p.stop_distance;
    let t3 = R::literal(0.25) * (p.stop_distance * p.stop_distance);
    let stop_stiffness_times_stop_width = p.stop_stiffness * p.stop_width;
    Constants { stop_width_squared, inverse_oscillator_mass, t0, t1,
        oscillator_v_dot_by_oscillator_v, t2, t3, stop_stiffness_times_stop_width }
}

/// State at the start of the run, in the units of the states. No operations.
#[must_use]
pub fn initial_state<R: Real>(p: &Parameters<R>) -> [R; STATES] {
    [p.deflection, R::literal(0.0)]
}

/// Times of known jumps of the right-hand side \[s\], unsorted. No operations.
#[must_use]
pub fn discontinuities<R: Real>(_p: &Parameters<R>) -> [R; DISCONTINUITIES] {
    []
}

/// As `rate`, with the constants of the parameters from `prepare`. 14 operations.
#[must_use]
#[inline]
pub fn prepared_rate<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>,
        c: &Constants<R>) -> [R; STATES] {
    let [oscillator_x, oscillator_v] = *state;
    let oscillator_x_minus_stop_distance = oscillator_x - p.stop_distance;
    let t0 = c.stop_width_squared.add_product(oscillator_x_minus_stop_distance,
        oscillator_x_minus_stop_distance).sqrt();
    let oscillator_v_dot = (-(p.oscillator_stiffness * oscillator_x)).add_product(c.t0
        * (R::literal(1.0) + oscillator_x_minus_stop_distance / t0),
        oscillator_x_minus_stop_distance + t0).sub_product(p.oscillator_damping, oscillator_v)
        * c.inverse_oscillator_mass;
    [oscillator_v, oscillator_v_dot]
}

/// `M = d2L/dq'2`, values in the order of its pattern. No operations.
#[must_use]
pub fn mass_matrix<R: Real>(_time: R, _state: &[R; STATES], p: &Parameters<R>) -> [R; 1] {
    [p.oscillator_mass]
}

/// `f` of `M q'' = f + G^T lambda`, one for each coordinate. 15 operations.
#[must_use]
pub fn forcing<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>) -> [R; COORDINATES] {
    let [oscillator_x, oscillator_v] = *state;
    let oscillator_x_minus_stop_distance = oscillator_x - p.stop_distance;
    let t0 = (p.stop_width * p.stop_width).add_product(oscillator_x_minus_stop_distance,
        oscillator_x_minus_stop_distance).sqrt();
    let oscillator_x_forcing = (-(p.oscillator_stiffness * oscillator_x))
        .add_product(R::literal(-0.25) * p.stop_stiffness * (R::literal(1.0)
        + oscillator_x_minus_stop_distance / t0), oscillator_x_minus_stop_distance + t0)
        .sub_product(p.oscillator_damping, oscillator_v);
    [oscillator_x_forcing]
}

/// As `rate_jacobian`, with the constants of the parameters from `prepare`. 19 operations.
#[must_use]
pub fn prepared_rate_jacobian<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>,
        c: &Constants<R>) -> [R; 3] {
    let [oscillator_x, ..] = *state;
    let oscillator_x_minus_stop_distance = oscillator_x - p.stop_distance;
    let t0 = oscillator_x_minus_stop_distance * oscillator_x_minus_stop_distance;
    let t1 = (c.stop_width_squared + t0).sqrt();
    let t2 = R::literal(1.0) + oscillator_x_minus_stop_distance / t1;
    let oscillator_v_dot_by_oscillator_x = (-p.oscillator_stiffness).add_product(c.t1
        * (oscillator_x_minus_stop_distance + t1), t0 / (t1 * t1 * t1) - R::literal(1.0) / t1)
        .sub_product(c.t1, t2 * t2) * c.inverse_oscillator_mass;
    [R::literal(1.0), oscillator_v_dot_by_oscillator_x, c.oscillator_v_dot_by_oscillator_v]
}

/// `rate_jacobian`, then `parameter_jacobian`, with the constants of the parameters from `prepare`.
/// 47 operations.
#[must_use]
pub fn prepared_jacobians<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>,
        c: &Constants<R>) -> [R; 9] {
    let [oscillator_x, oscillator_v] = *state;
    let oscillator_x_minus_stop_distance = oscillator_x - p.stop_distance;
    let t0 = oscillator_x_minus_stop_distance * oscillator_x_minus_stop_distance;
    let t1 = (c.stop_width_squared + t0).sqrt();
    let t2 = oscillator_x_minus_stop_distance + t1;
    let t3 = R::literal(1.0) + oscillator_x_minus_stop_distance / t1;
    let t4 = t1 * t1;
    let t5 = t4 * t1;
    let t6 = c.t1 * t2 * (t0 / t5 - R::literal(1.0) / t1);
    let oscillator_v_dot_by_oscillator_x = (t6 - p.oscillator_stiffness).sub_product(c.t1, t3 * t3)
        * c.inverse_oscillator_mass;
    let t7 = c.t1 * t3;
    let oscillator_v_dot_by_oscillator_mass = (p.oscillator_stiffness * oscillator_x)
        .add_product(t7, t2).add_product(p.oscillator_damping, oscillator_v)
        * c.inverse_oscillator_mass * c.inverse_oscillator_mass;
    let oscillator_v_dot_by_oscillator_stiffness = -(oscillator_x * c.inverse_oscillator_mass);
    let oscillator_v_dot_by_oscillator_damping = -(oscillator_v * c.inverse_oscillator_mass);
    let oscillator_v_dot_by_stop_distance = (-t6).add_product(t7, t3) * c.inverse_oscillator_mass;
    let oscillator_v_dot_by_stop_stiffness = R::literal(-0.25) * t3 * t2
        * c.inverse_oscillator_mass;
    let oscillator_v_dot_by_stop_width = c.stop_stiffness_times_stop_width * c.t3
        .add_product(R::literal(0.25), oscillator_x * oscillator_x).sub_product(c.t2, oscillator_x)
        .sub_product(R::literal(0.25), t4) / t5 * c.inverse_oscillator_mass;
    [R::literal(1.0), oscillator_v_dot_by_oscillator_x, c.oscillator_v_dot_by_oscillator_v,
        oscillator_v_dot_by_oscillator_mass, oscillator_v_dot_by_oscillator_stiffness,
        oscillator_v_dot_by_oscillator_damping, oscillator_v_dot_by_stop_distance,
        oscillator_v_dot_by_stop_stiffness, oscillator_v_dot_by_stop_width]
}

/// Partial derivative of `y'` with respect to time. No operations.
#[must_use]
pub fn time_derivative<R: Real>(_time: R, _state: &[R; STATES], _p: &Parameters<R>) -> [R; STATES] {
    [R::literal(0.0), R::literal(0.0)]
}

/// Wanted outputs. No operations.
#[must_use]
pub fn outputs<R: Real>(_time: R, state: &[R; STATES], _p: &Parameters<R>) -> Outputs<R> {
    let [oscillator_x, oscillator_v] = *state;
    Outputs {
        deflection: oscillator_x,
        velocity: oscillator_v,
    }
}

/// T, V and the energy of first-order states \[J\]. 16 operations.
#[must_use]
pub fn energy<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>) -> Energy<R> {
    let [oscillator_x, oscillator_v] = *state;
    let oscillator_x_minus_stop_distance = oscillator_x - p.stop_distance;
    let t0 = oscillator_x_minus_stop_distance + (p.stop_width * p.stop_width)
        .add_product(oscillator_x_minus_stop_distance, oscillator_x_minus_stop_distance).sqrt();
    Energy {
        kinetic: R::literal(0.5) * p.oscillator_mass * (oscillator_v * oscillator_v),
        potential: (R::literal(0.5) * p.oscillator_stiffness * (oscillator_x * oscillator_x))
            .add_product(R::literal(0.125) * p.stop_stiffness, t0 * t0),
        stored: R::literal(0.0),
    }
}

/// `dE/dt`, power supplied and power dissipated \[W\]. 23 operations.
#[must_use]
pub fn power_balance<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>) -> PowerBalance<R> {
    let [oscillator_x, oscillator_v] = *state;
    let oscillator_x_minus_stop_distance = oscillator_x - p.stop_distance;
    let t0 = (p.stop_width * p.stop_width).add_product(oscillator_x_minus_stop_distance,
        oscillator_x_minus_stop_distance).sqrt();
    let t1 = (p.oscillator_stiffness * oscillator_x).add_product(R::literal(0.25)
        * p.stop_stiffness * (R::literal(1.0) + oscillator_x_minus_stop_distance / t0),
        oscillator_x_minus_stop_distance + t0);
    PowerBalance {
        stored_rate: (t1 * oscillator_v).sub_product(p.oscillator_mass * oscillator_v, t1
            .add_product(p.oscillator_damping, oscillator_v) * (R::literal(1.0)
            / p.oscillator_mass)),
        supplied: R::literal(0.0),
        dissipated: p.oscillator_damping * (oscillator_v * oscillator_v),
    }
}

/// Normalized Taylor coefficients of the solution through `state`, order after order.
///
/// `_k` marks the coefficient of order k, `_before` that of order k - 1; bare names are
/// zeroth coefficients. The workspace is as `series_workspace` says.
///
/// 27 recurrences. 4 sums of products an order.
///
/// # Panics
/// If there is no room for the zeroth coefficients, or the workspace is too short.
pub fn series<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>,
        coefficients: &mut [[R; STATES]], workspace: &mut [R]) {
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
    let t10 = oscillator_x * p.oscillator_stiffness;
    let t11 = R::literal(-0.25) * p.stop_stiffness;
    let t12 = t9 * t11;
    let t13 = t12 * t5;
    let t14 = t13 - t10;
    let t15 = t14 - t7;
    let oscillator_v_dot = t15 * t6;
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
        let t8_k = (-t4_k).mul_add(t8, oscillator_x_k - sums[2]) * inverse_t4_2;
        let t12_k = t8_k * t11;
        let t13_k = t5.mul_add(t12_k, t12.mul_add(t5_k, sums[3]));
        let t14_k = (-oscillator_x_k).mul_add(p.oscillator_stiffness, t13_k);
        let t15_k = (-oscillator_v_k).mul_add(p.oscillator_damping, t14_k);
        let oscillator_v_dot_k = t15_k * t6;
        lanes.set(order, [oscillator_x_k, t4_k, t4_k, t5_k], [oscillator_x_k, t4_k, t8_k, t12_k]);
        rates = [oscillator_v_k, oscillator_v_dot_k];
    }
}

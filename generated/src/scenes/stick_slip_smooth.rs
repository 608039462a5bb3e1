// Emitted by Machinist 0.1.0; do not edit. To make it again:
//
//     cargo run --release -- gen
//
// Sources, with SHA-256:
//   66bfbdece1814587959b34be9276cc57810f235c5e89ac78f81867c0b001c389  scenes/stick_slip_smooth.toml
//   2b1ddd7c3f47c80834fcf2b105259b46e513aba5c8a901dfa8118e2b95566121  units/friction_slider_smooth.toml
//
// Stick-slip oscillation on a belt, smoothed
//
// Smoothed variant of `stick_slip`: stiff where that sticks.
//
// Source:
//   Textbook.
//
// All quantities are in SI units.
// Shapes: coordinates 1, states 2, parameters 9, outputs 3, kinks 1, relations 1, saturations 2.
// Nonzeros: mass_matrix 1 of 1 by 1, rate_jacobian 3 of 2 by 2, parameter_jacobian 9 of 2 by 9.
// Operations: rate 20, forcing 19, rate_jacobian 29, parameter_jacobian 60, outputs 15, energy 6,
//     power_balance 28, kink_guards 1, kink_rates 20, saturating_arguments 8, prepare 12,
//     prepared_rate 17, prepared_rate_jacobian 22, prepared_jacobians 54.

use ::machinist_contract::{
    Energy, PowerBalance, Real, taylor::{Lanes, order_and_inverse},
};

::machinist_contract::simulator! {
    /// Stick-slip oscillation on a belt, smoothed
    ///
    /// Smoothed variant of \`stick_slip\`: stiff where that sticks.
    ///
    /// Source: Textbook.
    StickSlipSmooth: "stick_slip_smooth", "Stick-slip oscillation on a belt, smoothed";
    run from 0.0, until 5.0, points 2001, rtol 1e-8, method "radau";
    quadratures 0, discontinuities 0;
    prepared; jacobians_at_once; kinks 1; saturations 2; relations; series 4;
}

::machinist_contract::parameters! {
    belt_speed: 0.1, "m/s", "belt_speed", "speed of the belt";
    slider_mass: 1.0, "kg", "slider.mass", "mass";
    slider_stiffness: 400.0, "N/m", "slider.stiffness", "stiffness of the spring";
    slider_damping: 0.0, "N s/m", "slider.damping", "damping";
    slider_normal_force: 10.0, "N", "slider.normal_force", "normal force";
    slider_kinetic_friction: 0.25, "1", "slider.kinetic_friction", "coefficient of kinetic friction at high sliding speed";
    slider_stribeck_friction: 0.1, "1", "slider.stribeck_friction", "increase of the coefficient at low sliding speed";
    slider_stribeck_speed: 0.05, "m/s", "slider.stribeck_speed", "sliding speed over which the increase decays";
    slider_width: 0.001, "m/s", "slider.width", "sliding speed over which friction reverses";
    @ held_1: Branch;
}

::machinist_contract::outputs! {
    deflection: "m", "deflection", "deflection of the spring";
    velocity: "m/s", "velocity", "rate of deflection of the spring";
    friction: "N", "friction", "friction force on the mass";
}

::machinist_contract::states! {
    SLIDER_X: position, 0.01, "m", "slider.x", "deflection of the spring";
    SLIDER_V: velocity, 0.1, "m/s", "slider.v", "rate of deflection of the spring";
}

::machinist_contract::relations! {
    Branch [Rate];
}

::machinist_contract::patterns! {
    /// Nonzeros of M.
    MASS_MATRIX_PATTERN: 1 by 1 { 0 [0] }
    /// Nonzeros of dy'/dy.
    RATE_JACOBIAN_PATTERN: 2 by 2 { 0 [1] 1 [0 1] }
    /// Nonzeros of dy'/dp.
    PARAMETER_JACOBIAN_PATTERN: 2 by 9 { 1 [0 1 2 3 4 5 6 7 8] }
}

::machinist_contract::constants! {
    t0, inverse_slider_width, t1, inverse_slider_mass, slider_v_dot_by_slider_x, t3, t4,
    inverse_slider_width_squared
}

/// Returns the constants of `rate` and its Jacobians from the parameters. 12 operations.
#[must_use]
#[inline]
pub fn prepare<R: Real>(p: &Parameters<R>) -> Constants<R> {
    let t0 = R::literal(-1.0) / p.slider_stribeck_speed;
    let inverse_slider_width = R::literal(1.0) / p.slider_width;
    let t1 = R::literal(-1.0) / p.slider_mass;
    let inverse_slider_mass = R::literal(1.0) / p.slider_mass;
    let slider_v_dot_by_slider_x = -(p.slider_stiffness * inverse_slider_mass);
    let t2 = p.slider_normal_force * p.slider_stribeck_friction;
    let t3 = t2 / p.slider_stribeck_speed;
    let t4 = t2 / (p.slider_stribeck_speed * p.slider_stribeck_speed);
    let inverse_slider_width_squared = R::literal(1.0) / (p.slider_width * p.slider_width);
    Constants { t0, inverse_slider_width, t1, inverse_slider_mass, slider_v_dot_by_slider_x, t3,
        t4, inverse_slider_width_squared }
}

/// State at the start of the run, in the units of the states. No operations.
#[must_use]
pub fn initial_state<R: Real>(p: &Parameters<R>) -> [R; STATES] {
    [R::literal(0.0), p.belt_speed]
}

/// Times of known jumps of the right-hand side \[s\], unsorted. No operations.
#[must_use]
pub fn discontinuities<R: Real>(_p: &Parameters<R>) -> [R; DISCONTINUITIES] {
    []
}

/// As `rate`, with the constants of the parameters from `prepare`. 17 operations.
#[must_use]
#[inline]
pub fn prepared_rate<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>,
        c: &Constants<R>) -> [R; STATES] {
    let [slider_x, slider_v] = *state;
    let slider_sliding = slider_v - p.belt_speed;
    let slider_dragged = p.slider_normal_force * p.slider_kinetic_friction
        .add_product(p.slider_stribeck_friction, (c.t0 * R::select_less(slider_sliding + p.held_1,
        R::literal(0.0), -slider_sliding, slider_sliding)).exp());
    let slider_v_dot = (p.slider_stiffness * slider_x).add_product(slider_dragged,
        (c.inverse_slider_width * slider_sliding).tanh()).add_product(p.slider_damping, slider_v)
        * c.t1;
    [slider_v, slider_v_dot]
}

/// `M = d2L/dq'2`, values in the order of its pattern. No operations.
#[must_use]
pub fn mass_matrix<R: Real>(_time: R, _state: &[R; STATES], p: &Parameters<R>) -> [R; 1] {
    [p.slider_mass]
}

/// `f` of `M q'' = f + G^T lambda`, one for each coordinate. 19 operations.
#[must_use]
pub fn forcing<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>) -> [R; COORDINATES] {
    let [slider_x, slider_v] = *state;
    let slider_sliding = slider_v - p.belt_speed;
    let slider_dragged = p.slider_normal_force * p.slider_kinetic_friction
        .add_product(p.slider_stribeck_friction, (R::literal(-1.0) / p.slider_stribeck_speed
        * R::select_less(slider_sliding + p.held_1, R::literal(0.0), -slider_sliding,
        slider_sliding)).exp());
    let slider_x_forcing = -(p.slider_stiffness * slider_x).add_product(slider_dragged,
        (R::literal(1.0) / p.slider_width * slider_sliding).tanh()).add_product(p.slider_damping,
        slider_v);
    [slider_x_forcing]
}

/// As `rate_jacobian`, with the constants of the parameters from `prepare`. 22 operations.
#[must_use]
pub fn prepared_rate_jacobian<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>,
        c: &Constants<R>) -> [R; 3] {
    let [_, slider_v] = *state;
    let slider_sliding = slider_v - p.belt_speed;
    let slider_sliding_plus_held_1 = slider_sliding + p.held_1;
    let t0 = (c.t0 * R::select_less(slider_sliding_plus_held_1, R::literal(0.0), -slider_sliding,
        slider_sliding)).exp();
    let slider_dragged = p.slider_normal_force * p.slider_kinetic_friction
        .add_product(p.slider_stribeck_friction, t0);
    let t1 = (c.inverse_slider_width * slider_sliding).tanh();
    let slider_v_dot_by_slider_v = (-p.slider_damping).add_product(c.t3 * t0 * t1,
        R::select_less(slider_sliding_plus_held_1, R::literal(0.0), R::literal(-1.0),
        R::literal(1.0))).sub_product(c.inverse_slider_width * slider_dragged, R::literal(1.0)
        .sub_product(t1, t1)) * c.inverse_slider_mass;
    [R::literal(1.0), c.slider_v_dot_by_slider_x, slider_v_dot_by_slider_v]
}

/// `rate_jacobian`, then `parameter_jacobian`, with the constants of the parameters from `prepare`.
/// 54 operations.
#[must_use]
pub fn prepared_jacobians<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>,
        c: &Constants<R>) -> [R; 12] {
    let [slider_x, slider_v] = *state;
    let slider_sliding = slider_v - p.belt_speed;
    let slider_sliding_plus_held_1 = slider_sliding + p.held_1;
    let t0 = R::select_less(slider_sliding_plus_held_1, R::literal(0.0), -slider_sliding,
        slider_sliding);
    let t1 = (c.t0 * t0).exp();
    let t2 = p.slider_kinetic_friction.add_product(p.slider_stribeck_friction, t1);
    let slider_dragged = p.slider_normal_force * t2;
    let t3 = (c.inverse_slider_width * slider_sliding).tanh();
    let t4 = R::literal(1.0).sub_product(t3, t3);
    let t5 = c.inverse_slider_width * slider_dragged * t4;
    let t6 = c.t3 * t1 * t3 * R::select_less(slider_sliding_plus_held_1, R::literal(0.0),
        R::literal(-1.0), R::literal(1.0));
    let slider_v_dot_by_slider_v = (t6 - p.slider_damping - t5) * c.inverse_slider_mass;
    let slider_v_dot_by_belt_speed = (t5 - t6) * c.inverse_slider_mass;
    let slider_v_dot_by_slider_mass = (p.slider_stiffness * slider_x).add_product(slider_dragged,
        t3).add_product(p.slider_damping, slider_v) * c.inverse_slider_mass * c.inverse_slider_mass;
    let slider_v_dot_by_slider_stiffness = -(slider_x * c.inverse_slider_mass);
    let slider_v_dot_by_slider_damping = -(slider_v * c.inverse_slider_mass);
    let slider_v_dot_by_slider_normal_force = -(t2 * t3 * c.inverse_slider_mass);
    let slider_v_dot_by_slider_kinetic_friction = -(p.slider_normal_force * t3
        * c.inverse_slider_mass);
    let slider_v_dot_by_slider_stribeck_friction = -(p.slider_normal_force * t1 * t3
        * c.inverse_slider_mass);
    let slider_v_dot_by_slider_stribeck_speed = -(c.t4 * t0 * t1 * t3 * c.inverse_slider_mass);
    let slider_v_dot_by_slider_width = c.inverse_slider_width_squared * slider_sliding
        * slider_dragged * t4 * c.inverse_slider_mass;
    [R::literal(1.0), c.slider_v_dot_by_slider_x, slider_v_dot_by_slider_v,
        slider_v_dot_by_belt_speed, slider_v_dot_by_slider_mass, slider_v_dot_by_slider_stiffness,
        slider_v_dot_by_slider_damping, slider_v_dot_by_slider_normal_force,
        slider_v_dot_by_slider_kinetic_friction, slider_v_dot_by_slider_stribeck_friction,
        slider_v_dot_by_slider_stribeck_speed, slider_v_dot_by_slider_width]
}

/// Partial derivative of `y'` with respect to time. No operations.
#[must_use]
pub fn time_derivative<R: Real>(_time: R, _state: &[R; STATES], _p: &Parameters<R>) -> [R; STATES] {
    [R::literal(0.0), R::literal(0.0)]
}

/// Wanted outputs. 15 operations.
#[must_use]
pub fn outputs<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>) -> Outputs<R> {
    let [slider_x, slider_v] = *state;
    let slider_sliding = slider_v - p.belt_speed;
    let slider_dragged = p.slider_normal_force * p.slider_kinetic_friction
        .add_product(p.slider_stribeck_friction, (R::literal(-1.0) / p.slider_stribeck_speed
        * R::select_less(slider_sliding + p.held_1, R::literal(0.0), -slider_sliding,
        slider_sliding)).exp());
    let slider_friction = -(slider_dragged * (R::literal(1.0) / p.slider_width * slider_sliding)
        .tanh());
    Outputs {
        deflection: slider_x,
        velocity: slider_v,
        friction: slider_friction,
    }
}

/// T, V and the energy of first-order states \[J\]. 6 operations.
#[must_use]
pub fn energy<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>) -> Energy<R> {
    let [slider_x, slider_v] = *state;
    Energy {
        kinetic: R::literal(0.5) * p.slider_mass * (slider_v * slider_v),
        potential: R::literal(0.5) * p.slider_stiffness * (slider_x * slider_x),
        stored: R::literal(0.0),
    }
}

/// `dE/dt`, power supplied and power dissipated \[W\]. 28 operations.
#[must_use]
pub fn power_balance<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>) -> PowerBalance<R> {
    let [slider_x, slider_v] = *state;
    let slider_sliding = slider_v - p.belt_speed;
    let slider_dragged = p.slider_normal_force * p.slider_kinetic_friction
        .add_product(p.slider_stribeck_friction, (R::literal(-1.0) / p.slider_stribeck_speed
        * R::select_less(slider_sliding + p.held_1, R::literal(0.0), -slider_sliding,
        slider_sliding)).exp());
    let t0 = slider_dragged * (R::literal(1.0) / p.slider_width * slider_sliding).tanh();
    let slider_stiffness_times_slider_x = p.slider_stiffness * slider_x;
    PowerBalance {
        stored_rate: (slider_stiffness_times_slider_x * slider_v).sub_product(p.slider_mass
            * slider_v, (t0 + slider_stiffness_times_slider_x).add_product(p.slider_damping,
            slider_v) * (R::literal(1.0) / p.slider_mass)),
        supplied: -(slider_v * t0),
        dissipated: p.slider_damping * (slider_v * slider_v),
    }
}

/// What passes zero where the rate has a kink or a jump: arguments of `abs` and `sign`, differences
/// of what `min` and `max` compare, ends of tables. 1 operation.
#[must_use]
pub fn kink_guards<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>) -> [R; KINKS] {
    let [_, slider_v] = *state;
    let slider_sliding = slider_v - p.belt_speed;
    [slider_sliding]
}

/// Rates along the motion of what passes zero at kinks. 20 operations.
#[must_use]
pub fn kink_rates<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>) -> [R; KINKS] {
    let [slider_x, slider_v] = *state;
    let slider_sliding = slider_v - p.belt_speed;
    let slider_dragged = p.slider_normal_force * p.slider_kinetic_friction
        .add_product(p.slider_stribeck_friction, (R::literal(-1.0) / p.slider_stribeck_speed
        * R::select_less(slider_sliding + p.held_1, R::literal(0.0), -slider_sliding,
        slider_sliding)).exp());
    let slider_v_dot = (p.slider_stiffness * slider_x).add_product(slider_dragged, (R::literal(1.0)
        / p.slider_width * slider_sliding).tanh()).add_product(p.slider_damping, slider_v)
        * (R::literal(-1.0) / p.slider_mass);
    [slider_v_dot]
}

/// Arguments of functions that are flat far from a place, such as `tanh` far from zero. Steps by
/// series are checked where one passes zero or turns. 8 operations.
#[must_use]
pub fn saturating_arguments<R: Real>(_time: R, state: &[R; STATES],
        p: &Parameters<R>) -> [R; SATURATIONS] {
    let [_, slider_v] = *state;
    let slider_sliding = slider_v - p.belt_speed;
    let argument_1 = R::literal(1.0) / p.slider_stribeck_speed * R::select_less(slider_sliding
        + p.held_1, R::literal(0.0), -slider_sliding, slider_sliding);
    let argument_2 = R::literal(1.0) / p.slider_width * slider_sliding;
    [argument_1, argument_2]
}

/// Normalized Taylor coefficients of the solution through `state`, order after order.
///
/// `_k` marks the coefficient of order k, `_before` that of order k - 1; bare names are
/// zeroth coefficients. The workspace is as `series_workspace` says.
///
/// 37 recurrences. 4 sums of products an order.
///
/// # Panics
/// If there is no room for the zeroth coefficients, or the workspace is too short.
pub fn series<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>,
        coefficients: &mut [[R; STATES]], workspace: &mut [R]) {
    let (mut lanes, _) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let [slider_x, slider_v] = *state;
    let slider_sliding = slider_v - p.belt_speed;
    let t0 = slider_sliding + p.held_1;
    let t1 = -slider_sliding;
    let t2 = R::select_less(t0, R::literal(0.0), t1, slider_sliding);
    let t3 = R::literal(-1.0) / p.slider_stribeck_speed;
    let t4 = t2 * t3;
    let t5 = t4.exp();
    let t6 = t5 * p.slider_stribeck_friction;
    let t7 = p.slider_kinetic_friction + t6;
    let slider_dragged = t7 * p.slider_normal_force;
    let t8 = R::literal(1.0) / p.slider_width;
    let t9 = slider_sliding * t8;
    let t10 = t9.tanh();
    let t11 = t10 * t10;
    let t12 = R::literal(1.0) - t11;
    let t13 = slider_dragged * t10;
    let t14 = slider_x * p.slider_stiffness;
    let t15 = slider_v * p.slider_damping;
    let t16 = t13 + t14;
    let t17 = t16 + t15;
    let t18 = R::literal(-1.0) / p.slider_mass;
    let slider_v_dot = t17 * t18;
    let mut rates = [slider_v, slider_v_dot];
    coefficients[0] = *state;
    let highest = coefficients.len() - 1;
    for (order, state_k) in coefficients.iter_mut().enumerate().skip(1) {
        let (k, inverse) = order_and_inverse::<R>(order);
        *state_k = rates.map(|rate| rate * inverse);
        if order == highest {
            break;
        }
        let [slider_x_k, slider_v_k] = *state_k;
        let sums = lanes.sums(order);
        let t1_k = -slider_v_k;
        let t2_k = R::select_less(t0, R::literal(0.0), t1_k, slider_v_k);
        let t4_k = t2_k * t3;
        let t5_k = t4_k.mul_add(t5, inverse * sums[1]);
        let slider_dragged_k = t5_k * p.slider_stribeck_friction * p.slider_normal_force;
        let t9_k = slider_v_k * t8;
        let t10_k = t9_k.mul_add(t12, inverse * sums[2]);
        let t11_k = (t10 + t10).mul_add(t10_k, sums[0]);
        let t12_k = -t11_k;
        let t13_k = t10.mul_add(slider_dragged_k, slider_dragged.mul_add(t10_k, sums[3]));
        let t16_k = slider_x_k.mul_add(p.slider_stiffness, t13_k);
        let t17_k = slider_v_k.mul_add(p.slider_damping, t16_k);
        let slider_v_dot_k = t17_k * t18;
        lanes.set(order, [t10_k, k * t4_k, k * t9_k, slider_dragged_k], [t10_k, t5_k, t12_k,
            t10_k]);
        rates = [slider_v_k, slider_v_dot_k];
    }
}

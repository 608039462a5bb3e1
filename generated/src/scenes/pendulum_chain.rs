// Emitted by Machinist 0.1.0; do not edit. To make it again:
//
//     cargo run --release -- gen
//
// Sources, with SHA-256:
//   0ae560c60e956f715b92bdc0ce2749786e7c81bc02d34d94b044bc7a5fa65ee8  scenes/pendulum_chain.toml
//   48ed9cb5f27292b0df4a6579955a5e1467e8afbc56213e36581b37e175cf7534  units/three_pendulums.toml
//
// Triple pendulum
//
// Released from one side, without drive or damping, so its energy is constant.
//
// Source:
//   Textbook.
//
// All quantities are in SI units.
// Shapes: coordinates 3, states 6, parameters 7, outputs 2.
// Nonzeros: mass_matrix 9 of 3 by 3, rate_jacobian 21 of 6 by 6, parameter_jacobian 21 of 6 by 7.
// Operations: rate 116, mass_matrix 24, forcing 56, rate_jacobian 281, parameter_jacobian 330,
//     outputs 17, energy 48, power_balance 219, prepare 38, prepared_rate 94,
//     prepared_rate_jacobian 251, prepared_jacobians 456.

use ::machinist_contract::{
    Energy, PowerBalance, Real, taylor::{Factored, Lanes, order_and_inverse},
};

::machinist_contract::simulator! {
    /// Triple pendulum
    ///
    /// Released from one side, without drive or damping, so its energy is constant.
    ///
    /// Source: Textbook.
    PendulumChain: "pendulum_chain", "Triple pendulum";
    run from 0.0, until 5.0, points 1001, rtol 1e-8, method "tsit5";
    quadratures 0, discontinuities 0;
    prepared; jacobians_at_once; series 29;
}

::machinist_contract::parameters! {
    chain_m_1: 1.0, "kg", "chain.m_1", "mass at the end of the first link";
    chain_m_2: 0.8, "kg", "chain.m_2", "mass at the end of the second link";
    chain_m_3: 0.5, "kg", "chain.m_3", "mass at the end of the third link";
    chain_l_1: 1.0, "m", "chain.l_1", "length of the first link";
    chain_l_2: 0.7, "m", "chain.l_2", "length of the second link";
    chain_l_3: 0.4, "m", "chain.l_3", "length of the third link";
    chain_gravity: 9.81, "m/s^2", "chain.gravity", "gravitational acceleration";
}

::machinist_contract::outputs! {
    end_x: "m", "end_x", "horizontal position of the third mass";
    end_y: "m", "end_y", "height of the third mass";
}

::machinist_contract::states! {
    CHAIN_TH_1: position, 1.0, "rad", "chain.th_1", "angle of the first link";
    CHAIN_TH_2: position, 1.0, "rad", "chain.th_2", "angle of the second link";
    CHAIN_TH_3: position, 1.0, "rad", "chain.th_3", "angle of the third link";
    CHAIN_W_1: velocity, 5.0, "rad/s", "chain.w_1", "rate of angle of the first link";
    CHAIN_W_2: velocity, 5.0, "rad/s", "chain.w_2", "rate of angle of the second link";
    CHAIN_W_3: velocity, 5.0, "rad/s", "chain.w_3", "rate of angle of the third link";
}

::machinist_contract::patterns! {
    /// Nonzeros of M.
    MASS_MATRIX_PATTERN: 3 by 3 { 0 [0 1 2] 1 [0 1 2] 2 [0 1 2] }
    /// Nonzeros of dy'/dy.
    RATE_JACOBIAN_PATTERN: 6 by 6 { 0 [3] 1 [4] 2 [5] 3 [0 1 2 3 4 5] 4 [0 1 2 3 4 5]
        5 [0 1 2 3 4 5] }
    /// Nonzeros of dy'/dp.
    PARAMETER_JACOBIAN_PATTERN: 6 by 7 { 3 [0 1 2 3 4 5 6] 4 [0 1 2 3 4 5 6] 5 [0 1 2 3 4 5 6] }
}

::machinist_contract::constants! {
    t1, chain_m_3_times_chain_l_1, t2, t3, chain_m_3_times_chain_l_2, t4,
    chain_m_3_times_chain_l_3_squared, t5, chain_m_1_times_chain_gravity,
    chain_m_2_times_chain_l_2, chain_m_2_times_chain_gravity, chain_m_3_times_chain_l_3,
    chain_m_3_times_chain_gravity, chain_m_2_times_chain_l_1, t7, t9, t10, t0, chain_l_1_squared,
    chain_l_1_times_chain_l_2, chain_l_2_squared, chain_l_3_squared, chain_l_1_times_chain_l_3,
    chain_l_2_times_chain_l_3, t11, t12, t13, t14, t15
}

/// Returns the constants of `rate` and its Jacobians from the parameters. 38 operations.
#[must_use]
#[inline]
pub fn prepare<R: Real>(p: &Parameters<R>) -> Constants<R> {
    let t0 = p.chain_m_1 + p.chain_m_2 + p.chain_m_3;
    let chain_l_1_squared = p.chain_l_1 * p.chain_l_1;
    let chain_m_2_plus_chain_m_3 = p.chain_m_2 + p.chain_m_3;
    let chain_l_1_times_chain_l_2 = p.chain_l_1 * p.chain_l_2;
    let t1 = chain_l_1_times_chain_l_2 * chain_m_2_plus_chain_m_3;
    let chain_m_3_times_chain_l_1 = p.chain_m_3 * p.chain_l_1;
    let t2 = chain_m_3_times_chain_l_1 * p.chain_l_3;
    let chain_l_2_squared = p.chain_l_2 * p.chain_l_2;
    let t3 = chain_m_2_plus_chain_m_3 * chain_l_2_squared;
    let chain_m_3_times_chain_l_2 = p.chain_m_3 * p.chain_l_2;
    let t4 = chain_m_3_times_chain_l_2 * p.chain_l_3;
    let chain_l_3_squared = p.chain_l_3 * p.chain_l_3;
    let chain_m_3_times_chain_l_3_squared = p.chain_m_3 * chain_l_3_squared;
    let t5 = R::literal(1.0) / (t0 * chain_l_1_squared);
    let chain_m_1_times_chain_gravity = p.chain_m_1 * p.chain_gravity;
    let chain_m_2_times_chain_l_2 = p.chain_m_2 * p.chain_l_2;
    let chain_m_2_times_chain_gravity = p.chain_m_2 * p.chain_gravity;
    let chain_m_3_times_chain_l_3 = p.chain_m_3 * p.chain_l_3;
    let chain_m_3_times_chain_gravity = p.chain_m_3 * p.chain_gravity;
    let chain_m_2_times_chain_l_1 = p.chain_m_2 * p.chain_l_1;
    let t6 = R::literal(2.0) * p.chain_l_1;
    let t7 = t6 * p.chain_l_2 * chain_m_2_plus_chain_m_3;
    let t8 = R::literal(2.0) * p.chain_m_3;
    let t9 = t8 * p.chain_l_1 * p.chain_l_3;
    let t10 = t8 * p.chain_l_2 * p.chain_l_3;
    let chain_l_1_times_chain_l_3 = p.chain_l_1 * p.chain_l_3;
    let chain_l_2_times_chain_l_3 = p.chain_l_2 * p.chain_l_3;
    let t11 = p.chain_l_2 * chain_m_2_plus_chain_m_3;
    let t12 = t6 * t0;
    let t13 = p.chain_l_1 * chain_m_2_plus_chain_m_3;
    let t14 = R::literal(2.0) * p.chain_l_2 * chain_m_2_plus_chain_m_3;
    let t15 = t8 * p.chain_l_3;
    Constants { t1, chain_m_3_times_chain_l_1, t2, t3, chain_m_3_times_chain_l_2, t4,
        chain_m_3_times_chain_l_3_squared, t5, chain_m_1_times_chain_gravity,
        chain_m_2_times_chain_l_2, chain_m_2_times_chain_gravity, chain_m_3_times_chain_l_3,
        chain_m_3_times_chain_gravity, chain_m_2_times_chain_l_1, t7, t9, t10, t0,
        chain_l_1_squared, chain_l_1_times_chain_l_2, chain_l_2_squared, chain_l_3_squared,
        chain_l_1_times_chain_l_3, chain_l_2_times_chain_l_3, t11, t12, t13, t14, t15 }
}

/// State at the start of the run, in the units of the states. No operations.
#[must_use]
pub fn initial_state<R: Real>(_p: &Parameters<R>) -> [R; STATES] {
    [R::literal(0.9), R::literal(1.1), R::literal(1.4), R::literal(0.0), R::literal(0.0),
        R::literal(0.0)]
}

/// Times of known jumps of the right-hand side \[s\], unsorted. No operations.
#[must_use]
pub fn discontinuities<R: Real>(_p: &Parameters<R>) -> [R; DISCONTINUITIES] {
    []
}

/// As `rate`, with the constants of the parameters from `prepare`. 94 operations.
#[must_use]
#[inline]
pub fn prepared_rate<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>,
        c: &Constants<R>) -> [R; STATES] {
    let [chain_th_1, chain_th_2, chain_th_3, chain_w_1, chain_w_2, chain_w_3] = *state;
    let [(sin_chain_th_1, cos_chain_th_1), (sin_chain_th_2, cos_chain_th_2), (sin_chain_th_3,
        cos_chain_th_3)] = R::sin_cos_each([chain_th_1, chain_th_2, chain_th_3]);
    let t0 = (sin_chain_th_1 * cos_chain_th_2).sub_product(cos_chain_th_1, sin_chain_th_2);
    let t1 = c.t1 * (cos_chain_th_1 * cos_chain_th_2).add_product(sin_chain_th_1, sin_chain_th_2);
    let t2 = (sin_chain_th_1 * cos_chain_th_3).sub_product(cos_chain_th_1, sin_chain_th_3);
    let t3 = c.t2 * (cos_chain_th_1 * cos_chain_th_3).add_product(sin_chain_th_1, sin_chain_th_3);
    let t4 = (sin_chain_th_2 * cos_chain_th_3).sub_product(cos_chain_th_2, sin_chain_th_3);
    let t5 = t1 * c.t5;
    let t6 = t3 * c.t5;
    let t7 = R::literal(1.0) / c.t3.sub_product(t5, t1);
    let t8 = (c.t4 * (cos_chain_th_2 * cos_chain_th_3).add_product(sin_chain_th_2, sin_chain_th_3))
        .sub_product(t6, t1);
    let t9 = t8 * t7;
    let chain_w_2_squared = chain_w_2 * chain_w_2;
    let t10 = c.chain_m_3_times_chain_l_3 * (chain_w_3 * chain_w_3);
    let t11 = p.chain_l_1 * (c.chain_m_1_times_chain_gravity * sin_chain_th_1)
        .add_product(c.chain_m_2_times_chain_l_2 * chain_w_2_squared, t0)
        .add_product(c.chain_m_2_times_chain_gravity, sin_chain_th_1)
        .add_product(c.chain_m_3_times_chain_l_2 * chain_w_2_squared, t0).add_product(t10, t2)
        .add_product(c.chain_m_3_times_chain_gravity, sin_chain_th_1);
    let chain_w_1_squared = chain_w_1 * chain_w_1;
    let t12 = (p.chain_l_2 * (c.chain_m_2_times_chain_l_1 * chain_w_1_squared * t0)
        .add_product(c.chain_m_3_times_chain_l_1 * chain_w_1_squared, t0)
        .sub_product(c.chain_m_2_times_chain_gravity, sin_chain_th_2).sub_product(t10, t4)
        .sub_product(c.chain_m_3_times_chain_gravity, sin_chain_th_2)).add_product(t5, t11);
    let chain_w_3_dot = (c.chain_m_3_times_chain_l_3 * (p.chain_l_1 * chain_w_1_squared * t2)
        .add_product(p.chain_l_2 * chain_w_2_squared, t4).sub_product(p.chain_gravity,
        sin_chain_th_3)).add_product(t6, t11).sub_product(t9, t12) * (R::literal(1.0)
        / c.chain_m_3_times_chain_l_3_squared.sub_product(t6, t3).sub_product(t9, t8));
    let chain_w_2_dot = (t12 * t7).sub_product(t9, chain_w_3_dot);
    let chain_w_1_dot = -(t11 * c.t5).add_product(t5, chain_w_2_dot).add_product(t6, chain_w_3_dot);
    [chain_w_1, chain_w_2, chain_w_3, chain_w_1_dot, chain_w_2_dot, chain_w_3_dot]
}

/// `M = d2L/dq'2`, values in the order of its pattern. 24 operations.
#[must_use]
pub fn mass_matrix<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>) -> [R; 9] {
    let [chain_th_1, chain_th_2, chain_th_3, ..] = *state;
    let [(_, cos_chain_th_1_minus_chain_th_2), (_, cos_chain_th_1_minus_chain_th_3),
        (_, cos_chain_th_2_minus_chain_th_3)] = R::sin_cos_each([chain_th_1 - chain_th_2,
        chain_th_1 - chain_th_3, chain_th_2 - chain_th_3]);
    let chain_m_2_plus_chain_m_3 = p.chain_m_2 + p.chain_m_3;
    let t0 = p.chain_l_1 * p.chain_l_2 * chain_m_2_plus_chain_m_3 * cos_chain_th_1_minus_chain_th_2;
    let t1 = p.chain_m_3 * p.chain_l_1 * p.chain_l_3 * cos_chain_th_1_minus_chain_th_3;
    let t2 = p.chain_m_3 * p.chain_l_2 * p.chain_l_3 * cos_chain_th_2_minus_chain_th_3;
    [(p.chain_m_1 + p.chain_m_2 + p.chain_m_3) * (p.chain_l_1 * p.chain_l_1), t0, t1, t0,
        chain_m_2_plus_chain_m_3 * (p.chain_l_2 * p.chain_l_2), t2, t1, t2,
        p.chain_m_3 * (p.chain_l_3 * p.chain_l_3)]
}

/// `f` of `M q'' = f + G^T lambda`, one for each coordinate. 56 operations.
#[must_use]
pub fn forcing<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>) -> [R; COORDINATES] {
    let [chain_th_1, chain_th_2, chain_th_3, chain_w_1, chain_w_2, chain_w_3] = *state;
    let [(sin_chain_th_1, _), (sin_chain_th_2, _), (sin_chain_th_3, _),
        (sin_chain_th_1_minus_chain_th_2, _), (sin_chain_th_1_minus_chain_th_3, _),
        (sin_chain_th_2_minus_chain_th_3, _)] = R::sin_cos_each([chain_th_1, chain_th_2,
        chain_th_3, chain_th_1 - chain_th_2, chain_th_1 - chain_th_3, chain_th_2 - chain_th_3]);
    let chain_w_2_squared = chain_w_2 * chain_w_2;
    let chain_m_2_times_chain_gravity = p.chain_m_2 * p.chain_gravity;
    let chain_m_3_times_chain_l_3 = p.chain_m_3 * p.chain_l_3;
    let t0 = chain_m_3_times_chain_l_3 * (chain_w_3 * chain_w_3);
    let chain_m_3_times_chain_gravity = p.chain_m_3 * p.chain_gravity;
    let chain_th_1_forcing = -(p.chain_l_1 * (p.chain_m_1 * p.chain_gravity * sin_chain_th_1)
        .add_product(p.chain_m_2 * p.chain_l_2 * chain_w_2_squared, sin_chain_th_1_minus_chain_th_2)
        .add_product(chain_m_2_times_chain_gravity, sin_chain_th_1).add_product(p.chain_m_3
        * p.chain_l_2 * chain_w_2_squared, sin_chain_th_1_minus_chain_th_2).add_product(t0,
        sin_chain_th_1_minus_chain_th_3).add_product(chain_m_3_times_chain_gravity,
        sin_chain_th_1));
    let chain_w_1_squared = chain_w_1 * chain_w_1;
    let chain_th_2_forcing = p.chain_l_2 * (p.chain_m_2 * p.chain_l_1 * chain_w_1_squared
        * sin_chain_th_1_minus_chain_th_2).add_product(p.chain_m_3 * p.chain_l_1
        * chain_w_1_squared, sin_chain_th_1_minus_chain_th_2)
        .sub_product(chain_m_2_times_chain_gravity, sin_chain_th_2).sub_product(t0,
        sin_chain_th_2_minus_chain_th_3).sub_product(chain_m_3_times_chain_gravity, sin_chain_th_2);
    let chain_th_3_forcing = chain_m_3_times_chain_l_3 * (p.chain_l_1 * chain_w_1_squared
        * sin_chain_th_1_minus_chain_th_3).add_product(p.chain_l_2 * chain_w_2_squared,
        sin_chain_th_2_minus_chain_th_3).sub_product(p.chain_gravity, sin_chain_th_3);
    [chain_th_1_forcing, chain_th_2_forcing, chain_th_3_forcing]
}

/// As `rate_jacobian`, with the constants of the parameters from `prepare`. 251 operations.
#[must_use]
pub fn prepared_rate_jacobian<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>,
        c: &Constants<R>) -> [R; 21] {
    let [chain_th_1, chain_th_2, chain_th_3, chain_w_1, chain_w_2, chain_w_3] = *state;
    let [(sin_chain_th_1, cos_chain_th_1), (sin_chain_th_2, cos_chain_th_2), (sin_chain_th_3,
        cos_chain_th_3)] = R::sin_cos_each([chain_th_1, chain_th_2, chain_th_3]);
    let t0 = (sin_chain_th_1 * cos_chain_th_2).sub_product(cos_chain_th_1, sin_chain_th_2);
    let t1 = (cos_chain_th_1 * cos_chain_th_2).add_product(sin_chain_th_1, sin_chain_th_2);
    let t2 = c.t1 * t1;
    let t3 = (sin_chain_th_1 * cos_chain_th_3).sub_product(cos_chain_th_1, sin_chain_th_3);
    let t4 = (cos_chain_th_1 * cos_chain_th_3).add_product(sin_chain_th_1, sin_chain_th_3);
    let t5 = c.t2 * t4;
    let t6 = (sin_chain_th_2 * cos_chain_th_3).sub_product(cos_chain_th_2, sin_chain_th_3);
    let t7 = (cos_chain_th_2 * cos_chain_th_3).add_product(sin_chain_th_2, sin_chain_th_3);
    let t8 = t2 * c.t5;
    let t9 = t5 * c.t5;
    let t10 = R::literal(1.0) / c.t3.sub_product(t8, t2);
    let t11 = (c.t4 * t7).sub_product(t9, t2);
    let t12 = t11 * t10;
    let t13 = R::literal(1.0) / c.chain_m_3_times_chain_l_3_squared.sub_product(t9, t5)
        .sub_product(t12, t11);
    let chain_w_2_squared = chain_w_2 * chain_w_2;
    let t14 = c.chain_m_2_times_chain_l_2 * chain_w_2_squared;
    let t15 = c.chain_m_3_times_chain_l_2 * chain_w_2_squared;
    let chain_w_3_squared = chain_w_3 * chain_w_3;
    let t16 = c.chain_m_3_times_chain_l_3 * chain_w_3_squared;
    let t17 = p.chain_l_1 * (c.chain_m_1_times_chain_gravity * sin_chain_th_1).add_product(t14, t0)
        .add_product(c.chain_m_2_times_chain_gravity, sin_chain_th_1).add_product(t15, t0)
        .add_product(t16, t3).add_product(c.chain_m_3_times_chain_gravity, sin_chain_th_1);
    let chain_w_1_squared = chain_w_1 * chain_w_1;
    let t18 = c.chain_m_2_times_chain_l_1 * chain_w_1_squared;
    let t19 = c.chain_m_3_times_chain_l_1 * chain_w_1_squared;
    let chain_l_1_times_chain_w_1_squared = p.chain_l_1 * chain_w_1_squared;
    let chain_l_2_times_chain_w_2_squared = p.chain_l_2 * chain_w_2_squared;
    let t20 = (p.chain_l_2 * (t18 * t0).add_product(t19, t0)
        .sub_product(c.chain_m_2_times_chain_gravity, sin_chain_th_2).sub_product(t16, t6)
        .sub_product(c.chain_m_3_times_chain_gravity, sin_chain_th_2)).add_product(t8, t17);
    let chain_w_3_dot = (c.chain_m_3_times_chain_l_3 * (chain_l_1_times_chain_w_1_squared * t3)
        .add_product(chain_l_2_times_chain_w_2_squared, t6).sub_product(p.chain_gravity,
        sin_chain_th_3)).add_product(t9, t17).sub_product(t12, t20) * t13;
    let chain_w_2_dot = (t20 * t10).sub_product(t12, chain_w_3_dot);
    let t21 = (t17 * c.t5).add_product(t8, chain_w_2_dot).add_product(t9, chain_w_3_dot);
    let t22 = c.t1 * t0;
    let t23 = t22 * chain_w_2_dot;
    let t24 = t22 * t21;
    let t25 = c.t2 * t3;
    let t26 = t25 * chain_w_3_dot;
    let t27 = t23.sub_product(p.chain_l_1, (c.chain_m_1_times_chain_gravity * cos_chain_th_1)
        .add_product(t14, t1).add_product(c.chain_m_2_times_chain_gravity, cos_chain_th_1)
        .add_product(t15, t1).add_product(t16, t4).add_product(c.chain_m_3_times_chain_gravity,
        cos_chain_th_1)) + t26;
    let t28 = t25 * t21;
    let t29 = (-t24).add_product(c.t1 * chain_w_1_squared, t1).sub_product(t8, t27);
    let chain_w_3_dot_by_chain_th_1 = (-t28).add_product(c.t2 * chain_w_1_squared, t4)
        .sub_product(t9, t27).sub_product(t12, t29) * t13;
    let chain_w_2_dot_by_chain_th_1 = (t29 * t10).sub_product(t12, chain_w_3_dot_by_chain_th_1);
    let chain_w_1_dot_by_chain_th_1 = (t27 * c.t5).sub_product(t8, chain_w_2_dot_by_chain_th_1)
        .sub_product(t9, chain_w_3_dot_by_chain_th_1);
    let t30 = (-t23).add_product(c.t1 * chain_w_2_squared, t1);
    let t31 = c.t4 * t6;
    let t32 = t31 * chain_w_3_dot;
    let t33 = t31 * chain_w_2_dot;
    let t34 = (t24.sub_product(p.chain_l_2, (c.chain_m_2_times_chain_gravity * cos_chain_th_2)
        .add_product(t18, t1).add_product(t19, t1).add_product(t16, t7)
        .add_product(c.chain_m_3_times_chain_gravity, cos_chain_th_2)) + t32).sub_product(t8, t30);
    let chain_w_3_dot_by_chain_th_2 = t33.add_product(c.t4 * chain_w_2_squared, t7).sub_product(t9,
        t30).sub_product(t12, t34) * t13;
    let chain_w_2_dot_by_chain_th_2 = (t34 * t10).sub_product(t12, chain_w_3_dot_by_chain_th_2);
    let chain_w_1_dot_by_chain_th_2 = (t30 * c.t5).sub_product(t8, chain_w_2_dot_by_chain_th_2)
        .sub_product(t9, chain_w_3_dot_by_chain_th_2);
    let t35 = (-t26).add_product(c.t2 * chain_w_3_squared, t4);
    let t36 = (-t32).add_product(c.t4 * chain_w_3_squared, t7).sub_product(t8, t35);
    let chain_w_3_dot_by_chain_th_3 = (t28.sub_product(c.chain_m_3_times_chain_l_3,
        (chain_l_1_times_chain_w_1_squared * t4).add_product(chain_l_2_times_chain_w_2_squared, t7)
        .add_product(p.chain_gravity, cos_chain_th_3)) - t33).sub_product(t9, t35).sub_product(t12,
        t36) * t13;
    let chain_w_2_dot_by_chain_th_3 = (t36 * t10).sub_product(t12, chain_w_3_dot_by_chain_th_3);
    let chain_w_1_dot_by_chain_th_3 = (t35 * c.t5).sub_product(t8, chain_w_2_dot_by_chain_th_3)
        .sub_product(t9, chain_w_3_dot_by_chain_th_3);
    let t37 = c.t7 * chain_w_1 * t0;
    let chain_w_3_dot_by_chain_w_1 = (c.t9 * chain_w_1 * t3).sub_product(t12, t37) * t13;
    let chain_w_2_dot_by_chain_w_1 = (t37 * t10).sub_product(t12, chain_w_3_dot_by_chain_w_1);
    let chain_w_1_dot_by_chain_w_1 = -(t9 * chain_w_3_dot_by_chain_w_1).add_product(t8,
        chain_w_2_dot_by_chain_w_1);
    let t38 = c.t7 * chain_w_2 * t0;
    let t39 = t8 * t38;
    let chain_w_3_dot_by_chain_w_2 = (c.t10 * chain_w_2 * t6).add_product(t9, t38).sub_product(t12,
        t39) * t13;
    let chain_w_2_dot_by_chain_w_2 = (t39 * t10).sub_product(t12, chain_w_3_dot_by_chain_w_2);
    let chain_w_1_dot_by_chain_w_2 = -(t38 * c.t5).add_product(t8, chain_w_2_dot_by_chain_w_2)
        .add_product(t9, chain_w_3_dot_by_chain_w_2);
    let t40 = c.t9 * chain_w_3 * t3;
    let t41 = (-(c.t10 * chain_w_3 * t6)).add_product(t8, t40);
    let chain_w_3_dot_by_chain_w_3 = (t9 * t40).sub_product(t12, t41) * t13;
    let chain_w_2_dot_by_chain_w_3 = (t41 * t10).sub_product(t12, chain_w_3_dot_by_chain_w_3);
    let chain_w_1_dot_by_chain_w_3 = -(t40 * c.t5).add_product(t8, chain_w_2_dot_by_chain_w_3)
        .add_product(t9, chain_w_3_dot_by_chain_w_3);
    [R::literal(1.0), R::literal(1.0), R::literal(1.0), chain_w_1_dot_by_chain_th_1,
        chain_w_1_dot_by_chain_th_2, chain_w_1_dot_by_chain_th_3, chain_w_1_dot_by_chain_w_1,
        chain_w_1_dot_by_chain_w_2, chain_w_1_dot_by_chain_w_3, chain_w_2_dot_by_chain_th_1,
        chain_w_2_dot_by_chain_th_2, chain_w_2_dot_by_chain_th_3, chain_w_2_dot_by_chain_w_1,
        chain_w_2_dot_by_chain_w_2, chain_w_2_dot_by_chain_w_3, chain_w_3_dot_by_chain_th_1,
        chain_w_3_dot_by_chain_th_2, chain_w_3_dot_by_chain_th_3, chain_w_3_dot_by_chain_w_1,
        chain_w_3_dot_by_chain_w_2, chain_w_3_dot_by_chain_w_3]
}

/// `rate_jacobian`, then `parameter_jacobian`, with the constants of the parameters from `prepare`.
/// 456 operations.
#[must_use]
pub fn prepared_jacobians<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>,
        c: &Constants<R>) -> [R; 42] {
    let [chain_th_1, chain_th_2, chain_th_3, chain_w_1, chain_w_2, chain_w_3] = *state;
    let [(sin_chain_th_1, cos_chain_th_1), (sin_chain_th_2, cos_chain_th_2), (sin_chain_th_3,
        cos_chain_th_3)] = R::sin_cos_each([chain_th_1, chain_th_2, chain_th_3]);
    let t0 = (sin_chain_th_1 * cos_chain_th_2).sub_product(cos_chain_th_1, sin_chain_th_2);
    let t1 = (cos_chain_th_1 * cos_chain_th_2).add_product(sin_chain_th_1, sin_chain_th_2);
    let t2 = c.t1 * t1;
    let t3 = (sin_chain_th_1 * cos_chain_th_3).sub_product(cos_chain_th_1, sin_chain_th_3);
    let t4 = (cos_chain_th_1 * cos_chain_th_3).add_product(sin_chain_th_1, sin_chain_th_3);
    let t5 = c.t2 * t4;
    let t6 = (sin_chain_th_2 * cos_chain_th_3).sub_product(cos_chain_th_2, sin_chain_th_3);
    let t7 = (cos_chain_th_2 * cos_chain_th_3).add_product(sin_chain_th_2, sin_chain_th_3);
    let t8 = t2 * c.t5;
    let t9 = t5 * c.t5;
    let t10 = R::literal(1.0) / c.t3.sub_product(t8, t2);
    let t11 = (c.t4 * t7).sub_product(t9, t2);
    let t12 = t11 * t10;
    let t13 = R::literal(1.0) / c.chain_m_3_times_chain_l_3_squared.sub_product(t9, t5)
        .sub_product(t12, t11);
    let chain_w_2_squared = chain_w_2 * chain_w_2;
    let t14 = c.chain_m_2_times_chain_l_2 * chain_w_2_squared;
    let t15 = c.chain_m_3_times_chain_l_2 * chain_w_2_squared;
    let chain_w_3_squared = chain_w_3 * chain_w_3;
    let t16 = c.chain_m_3_times_chain_l_3 * chain_w_3_squared;
    let t17 = (c.chain_m_1_times_chain_gravity * sin_chain_th_1).add_product(t14, t0)
        .add_product(c.chain_m_2_times_chain_gravity, sin_chain_th_1).add_product(t15, t0)
        .add_product(t16, t3).add_product(c.chain_m_3_times_chain_gravity, sin_chain_th_1);
    let t18 = p.chain_l_1 * t17;
    let chain_w_1_squared = chain_w_1 * chain_w_1;
    let t19 = c.chain_m_2_times_chain_l_1 * chain_w_1_squared;
    let t20 = c.chain_m_3_times_chain_l_1 * chain_w_1_squared;
    let t21 = (t19 * t0).add_product(t20, t0).sub_product(c.chain_m_2_times_chain_gravity,
        sin_chain_th_2).sub_product(t16, t6).sub_product(c.chain_m_3_times_chain_gravity,
        sin_chain_th_2);
    let chain_l_1_times_chain_w_1_squared = p.chain_l_1 * chain_w_1_squared;
    let chain_l_2_times_chain_w_2_squared = p.chain_l_2 * chain_w_2_squared;
    let t22 = (chain_l_1_times_chain_w_1_squared * t3)
        .add_product(chain_l_2_times_chain_w_2_squared, t6).sub_product(p.chain_gravity,
        sin_chain_th_3);
    let t23 = (p.chain_l_2 * t21).add_product(t8, t18);
    let chain_w_3_dot = (c.chain_m_3_times_chain_l_3 * t22).add_product(t9, t18).sub_product(t12,
        t23) * t13;
    let chain_w_2_dot = (t23 * t10).sub_product(t12, chain_w_3_dot);
    let t24 = (t18 * c.t5).add_product(t8, chain_w_2_dot).add_product(t9, chain_w_3_dot);
    let t25 = c.t1 * t0;
    let t26 = t25 * chain_w_2_dot;
    let t27 = t25 * t24;
    let t28 = c.t2 * t3;
    let t29 = t28 * chain_w_3_dot;
    let t30 = t26.sub_product(p.chain_l_1, (c.chain_m_1_times_chain_gravity * cos_chain_th_1)
        .add_product(t14, t1).add_product(c.chain_m_2_times_chain_gravity, cos_chain_th_1)
        .add_product(t15, t1).add_product(t16, t4).add_product(c.chain_m_3_times_chain_gravity,
        cos_chain_th_1)) + t29;
    let t31 = t28 * t24;
    let t32 = (-t27).add_product(c.t1 * chain_w_1_squared, t1).sub_product(t8, t30);
    let chain_w_3_dot_by_chain_th_1 = (-t31).add_product(c.t2 * chain_w_1_squared, t4)
        .sub_product(t9, t30).sub_product(t12, t32) * t13;
    let chain_w_2_dot_by_chain_th_1 = (t32 * t10).sub_product(t12, chain_w_3_dot_by_chain_th_1);
    let chain_w_1_dot_by_chain_th_1 = (t30 * c.t5).sub_product(t8, chain_w_2_dot_by_chain_th_1)
        .sub_product(t9, chain_w_3_dot_by_chain_th_1);
    let t33 = (-t26).add_product(c.t1 * chain_w_2_squared, t1);
    let t34 = c.t4 * t6;
    let t35 = t34 * chain_w_3_dot;
    let t36 = t34 * chain_w_2_dot;
    let t37 = (t27.sub_product(p.chain_l_2, (c.chain_m_2_times_chain_gravity * cos_chain_th_2)
        .add_product(t19, t1).add_product(t20, t1).add_product(t16, t7)
        .add_product(c.chain_m_3_times_chain_gravity, cos_chain_th_2)) + t35).sub_product(t8, t33);
    let chain_w_3_dot_by_chain_th_2 = t36.add_product(c.t4 * chain_w_2_squared, t7).sub_product(t9,
        t33).sub_product(t12, t37) * t13;
    let chain_w_2_dot_by_chain_th_2 = (t37 * t10).sub_product(t12, chain_w_3_dot_by_chain_th_2);
    let chain_w_1_dot_by_chain_th_2 = (t33 * c.t5).sub_product(t8, chain_w_2_dot_by_chain_th_2)
        .sub_product(t9, chain_w_3_dot_by_chain_th_2);
    let t38 = (-t29).add_product(c.t2 * chain_w_3_squared, t4);
    let t39 = (-t35).add_product(c.t4 * chain_w_3_squared, t7).sub_product(t8, t38);
    let chain_w_3_dot_by_chain_th_3 = (t31.sub_product(c.chain_m_3_times_chain_l_3,
        (chain_l_1_times_chain_w_1_squared * t4).add_product(chain_l_2_times_chain_w_2_squared, t7)
        .add_product(p.chain_gravity, cos_chain_th_3)) - t36).sub_product(t9, t38).sub_product(t12,
        t39) * t13;
    let chain_w_2_dot_by_chain_th_3 = (t39 * t10).sub_product(t12, chain_w_3_dot_by_chain_th_3);
    let chain_w_1_dot_by_chain_th_3 = (t38 * c.t5).sub_product(t8, chain_w_2_dot_by_chain_th_3)
        .sub_product(t9, chain_w_3_dot_by_chain_th_3);
    let t40 = c.t7 * chain_w_1 * t0;
    let chain_w_3_dot_by_chain_w_1 = (c.t9 * chain_w_1 * t3).sub_product(t12, t40) * t13;
    let chain_w_2_dot_by_chain_w_1 = (t40 * t10).sub_product(t12, chain_w_3_dot_by_chain_w_1);
    let chain_w_1_dot_by_chain_w_1 = -(t9 * chain_w_3_dot_by_chain_w_1).add_product(t8,
        chain_w_2_dot_by_chain_w_1);
    let t41 = c.t7 * chain_w_2 * t0;
    let t42 = t8 * t41;
    let chain_w_3_dot_by_chain_w_2 = (c.t10 * chain_w_2 * t6).add_product(t9, t41).sub_product(t12,
        t42) * t13;
    let chain_w_2_dot_by_chain_w_2 = (t42 * t10).sub_product(t12, chain_w_3_dot_by_chain_w_2);
    let chain_w_1_dot_by_chain_w_2 = -(t41 * c.t5).add_product(t8, chain_w_2_dot_by_chain_w_2)
        .add_product(t9, chain_w_3_dot_by_chain_w_2);
    let t43 = c.t9 * chain_w_3 * t3;
    let t44 = (-(c.t10 * chain_w_3 * t6)).add_product(t8, t43);
    let chain_w_3_dot_by_chain_w_3 = (t9 * t43).sub_product(t12, t44) * t13;
    let chain_w_2_dot_by_chain_w_3 = (t44 * t10).sub_product(t12, chain_w_3_dot_by_chain_w_3);
    let chain_w_1_dot_by_chain_w_3 = -(t43 * c.t5).add_product(t8, chain_w_2_dot_by_chain_w_3)
        .add_product(t9, chain_w_3_dot_by_chain_w_3);
    let chain_x_1 = p.chain_l_1 * sin_chain_th_1;
    let t45 = c.chain_l_1_squared * t24;
    let t46 = t45.sub_product(p.chain_gravity, chain_x_1);
    let t47 = t8 * t46;
    let chain_w_3_dot_by_chain_m_1 = (-(t9 * t46)).add_product(t12, t47) * t13;
    let t48 = (t47 * t10).add_product(t12, chain_w_3_dot_by_chain_m_1);
    let chain_w_2_dot_by_chain_m_1 = -t48;
    let chain_w_1_dot_by_chain_m_1 = (t46 * c.t5).add_product(t8, t48).sub_product(t9,
        chain_w_3_dot_by_chain_m_1);
    let t49 = chain_l_2_times_chain_w_2_squared * t0;
    let chain_gravity_times_sin_chain_th_1 = p.chain_gravity * sin_chain_th_1;
    let chain_gravity_times_sin_chain_th_2 = p.chain_gravity * sin_chain_th_2;
    let t50 = chain_l_1_times_chain_w_1_squared * t0;
    let t51 = c.chain_l_1_times_chain_l_2 * t1;
    let t52 = t51 * chain_w_2_dot;
    let t53 = t45.sub_product(p.chain_l_1, t49 + chain_gravity_times_sin_chain_th_1) - t52;
    let t54 = t51 * t24;
    let t55 = c.chain_l_2_squared * chain_w_2_dot;
    let t56 = (t54.add_product(p.chain_l_2, t50 - chain_gravity_times_sin_chain_th_2) - t55)
        .sub_product(t8, t53);
    let t57 = (t9 * t53).add_product(t12, t56) * t13;
    let chain_w_3_dot_by_chain_m_2 = -t57;
    let chain_w_2_dot_by_chain_m_2 = (t56 * t10).add_product(t12, t57);
    let chain_w_1_dot_by_chain_m_2 = (t53 * c.t5).sub_product(t8, chain_w_2_dot_by_chain_m_2)
        .add_product(t9, t57);
    let chain_l_3_times_chain_w_3_squared = p.chain_l_3 * chain_w_3_squared;
    let t58 = c.chain_l_1_times_chain_l_3 * t4;
    let t59 = (t45.sub_product(p.chain_l_1, t49.add_product(chain_l_3_times_chain_w_3_squared, t3)
        + chain_gravity_times_sin_chain_th_1) - t52).sub_product(t58, chain_w_3_dot);
    let t60 = c.chain_l_2_times_chain_l_3 * t7;
    let t61 = (t54.add_product(p.chain_l_2, t50.sub_product(chain_l_3_times_chain_w_3_squared, t6)
        - chain_gravity_times_sin_chain_th_2) - t55).sub_product(t60, chain_w_3_dot)
        .sub_product(t8, t59);
    let chain_w_3_dot_by_chain_m_3 = (p.chain_l_3 * t22).add_product(t58, t24).sub_product(t60,
        chain_w_2_dot).sub_product(c.chain_l_3_squared, chain_w_3_dot).sub_product(t9, t59)
        .sub_product(t12, t61) * t13;
    let chain_w_2_dot_by_chain_m_3 = (t61 * t10).sub_product(t12, chain_w_3_dot_by_chain_m_3);
    let chain_w_1_dot_by_chain_m_3 = (t59 * c.t5).sub_product(t8, chain_w_2_dot_by_chain_m_3)
        .sub_product(t9, chain_w_3_dot_by_chain_m_3);
    let t62 = c.t11 * t1;
    let t63 = c.chain_m_3_times_chain_l_3 * t4;
    let t64 = (-t17).add_product(c.t12, t24).sub_product(t62, chain_w_2_dot).sub_product(t63,
        chain_w_3_dot);
    let t65 = (c.t11 * chain_w_1_squared * t0).add_product(t62, t24).sub_product(t8, t64);
    let chain_w_3_dot_by_chain_l_1 = (c.chain_m_3_times_chain_l_3 * chain_w_1_squared * t3)
        .add_product(t63, t24).sub_product(t9, t64).sub_product(t12, t65) * t13;
    let chain_w_2_dot_by_chain_l_1 = (t65 * t10).sub_product(t12, chain_w_3_dot_by_chain_l_1);
    let chain_w_1_dot_by_chain_l_1 = (t64 * c.t5).sub_product(t8, chain_w_2_dot_by_chain_l_1)
        .sub_product(t9, chain_w_3_dot_by_chain_l_1);
    let t66 = c.t13 * t1;
    let t67 = (c.t13 * chain_w_2_squared * t0).add_product(t66, chain_w_2_dot);
    let t68 = c.chain_m_3_times_chain_l_3 * t7;
    let t69 = t21.add_product(t66, t24).sub_product(c.t14, chain_w_2_dot).sub_product(t68,
        chain_w_3_dot).add_product(t8, t67);
    let chain_w_3_dot_by_chain_l_2 = (c.chain_m_3_times_chain_l_3 * chain_w_2_squared * t6)
        .sub_product(t68, chain_w_2_dot).add_product(t9, t67).sub_product(t12, t69) * t13;
    let chain_w_2_dot_by_chain_l_2 = (t69 * t10).sub_product(t12, chain_w_3_dot_by_chain_l_2);
    let chain_w_1_dot_by_chain_l_2 = -(t67 * c.t5).add_product(t8, chain_w_2_dot_by_chain_l_2)
        .add_product(t9, chain_w_3_dot_by_chain_l_2);
    let t70 = c.chain_m_3_times_chain_l_1 * t4;
    let t71 = (c.chain_m_3_times_chain_l_1 * chain_w_3_squared * t3).add_product(t70,
        chain_w_3_dot);
    let t72 = c.chain_m_3_times_chain_l_2 * t7;
    let t73 = (-(c.chain_m_3_times_chain_l_2 * chain_w_3_squared * t6).add_product(t72,
        chain_w_3_dot)).add_product(t8, t71);
    let chain_w_3_dot_by_chain_l_3 = (p.chain_m_3 * t22).add_product(t70, t24).sub_product(t72,
        chain_w_2_dot).sub_product(c.t15, chain_w_3_dot).add_product(t9, t71).sub_product(t12, t73)
        * t13;
    let chain_w_2_dot_by_chain_l_3 = (t73 * t10).sub_product(t12, chain_w_3_dot_by_chain_l_3);
    let chain_w_1_dot_by_chain_l_3 = -(t71 * c.t5).add_product(t8, chain_w_2_dot_by_chain_l_3)
        .add_product(t9, chain_w_3_dot_by_chain_l_3);
    let t74 = c.t0 * chain_x_1;
    let t75 = (-(c.t11 * sin_chain_th_2)).add_product(t8, t74);
    let chain_w_3_dot_by_chain_gravity = (-(c.chain_m_3_times_chain_l_3 * sin_chain_th_3))
        .add_product(t9, t74).sub_product(t12, t75) * t13;
    let chain_w_2_dot_by_chain_gravity = (t75 * t10).sub_product(t12,
        chain_w_3_dot_by_chain_gravity);
    let chain_w_1_dot_by_chain_gravity = -(t74 * c.t5).add_product(t8,
        chain_w_2_dot_by_chain_gravity).add_product(t9, chain_w_3_dot_by_chain_gravity);
    [R::literal(1.0), R::literal(1.0), R::literal(1.0), chain_w_1_dot_by_chain_th_1,
        chain_w_1_dot_by_chain_th_2, chain_w_1_dot_by_chain_th_3, chain_w_1_dot_by_chain_w_1,
        chain_w_1_dot_by_chain_w_2, chain_w_1_dot_by_chain_w_3, chain_w_2_dot_by_chain_th_1,
        chain_w_2_dot_by_chain_th_2, chain_w_2_dot_by_chain_th_3, chain_w_2_dot_by_chain_w_1,
        chain_w_2_dot_by_chain_w_2, chain_w_2_dot_by_chain_w_3, chain_w_3_dot_by_chain_th_1,
        chain_w_3_dot_by_chain_th_2, chain_w_3_dot_by_chain_th_3, chain_w_3_dot_by_chain_w_1,
        chain_w_3_dot_by_chain_w_2, chain_w_3_dot_by_chain_w_3, chain_w_1_dot_by_chain_m_1,
        chain_w_1_dot_by_chain_m_2, chain_w_1_dot_by_chain_m_3, chain_w_1_dot_by_chain_l_1,
        chain_w_1_dot_by_chain_l_2, chain_w_1_dot_by_chain_l_3, chain_w_1_dot_by_chain_gravity,
        chain_w_2_dot_by_chain_m_1, chain_w_2_dot_by_chain_m_2, chain_w_2_dot_by_chain_m_3,
        chain_w_2_dot_by_chain_l_1, chain_w_2_dot_by_chain_l_2, chain_w_2_dot_by_chain_l_3,
        chain_w_2_dot_by_chain_gravity, chain_w_3_dot_by_chain_m_1, chain_w_3_dot_by_chain_m_2,
        chain_w_3_dot_by_chain_m_3, chain_w_3_dot_by_chain_l_1, chain_w_3_dot_by_chain_l_2,
        chain_w_3_dot_by_chain_l_3, chain_w_3_dot_by_chain_gravity]
}

/// Partial derivative of `y'` with respect to time. No operations.
#[must_use]
pub fn time_derivative<R: Real>(_time: R, _state: &[R; STATES], _p: &Parameters<R>) -> [R; STATES] {
    [R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0),
        R::literal(0.0)]
}

/// Wanted outputs. 17 operations.
#[must_use]
pub fn outputs<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>) -> Outputs<R> {
    let [chain_th_1, chain_th_2, chain_th_3, ..] = *state;
    let [(sin_chain_th_1, cos_chain_th_1), (sin_chain_th_2, cos_chain_th_2), (sin_chain_th_3,
        cos_chain_th_3)] = R::sin_cos_each([chain_th_1, chain_th_2, chain_th_3]);
    let chain_x_1 = p.chain_l_1 * sin_chain_th_1;
    let chain_x_2 = chain_x_1.add_product(p.chain_l_2, sin_chain_th_2);
    let chain_x_3 = chain_x_2.add_product(p.chain_l_3, sin_chain_th_3);
    let chain_y_3 = -(p.chain_l_1 * cos_chain_th_1).add_product(p.chain_l_2, cos_chain_th_2)
        .add_product(p.chain_l_3, cos_chain_th_3);
    Outputs {
        end_x: chain_x_3,
        end_y: chain_y_3,
    }
}

/// T, V and the energy of first-order states \[J\]. 48 operations.
#[must_use]
pub fn energy<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>) -> Energy<R> {
    let [chain_th_1, chain_th_2, chain_th_3, chain_w_1, chain_w_2, chain_w_3] = *state;
    let [(sin_chain_th_1, cos_chain_th_1), (sin_chain_th_2, cos_chain_th_2), (sin_chain_th_3,
        cos_chain_th_3)] = R::sin_cos_each([chain_th_1, chain_th_2, chain_th_3]);
    let chain_x_1 = p.chain_l_1 * sin_chain_th_1;
    let chain_l_1_times_cos_chain_th_1 = p.chain_l_1 * cos_chain_th_1;
    let chain_vx_1 = chain_w_1 * chain_l_1_times_cos_chain_th_1;
    let chain_vy_1 = chain_w_1 * chain_x_1;
    let t0 = chain_l_1_times_cos_chain_th_1.add_product(p.chain_l_2, cos_chain_th_2);
    let chain_l_2_times_chain_w_2 = p.chain_l_2 * chain_w_2;
    let chain_vx_2 = chain_vx_1.add_product(chain_l_2_times_chain_w_2, cos_chain_th_2);
    let chain_vy_2 = chain_vy_1.add_product(chain_l_2_times_chain_w_2, sin_chain_th_2);
    let chain_l_3_times_chain_w_3 = p.chain_l_3 * chain_w_3;
    let chain_vx_3 = chain_vx_2.add_product(chain_l_3_times_chain_w_3, cos_chain_th_3);
    let chain_vy_3 = chain_vy_2.add_product(chain_l_3_times_chain_w_3, sin_chain_th_3);
    Energy {
        kinetic: (R::literal(0.5) * p.chain_m_1 * (chain_vx_1 * chain_vx_1).add_product(chain_vy_1,
            chain_vy_1)).add_product(R::literal(0.5) * p.chain_m_2, (chain_vx_2 * chain_vx_2)
            .add_product(chain_vy_2, chain_vy_2)).add_product(R::literal(0.5) * p.chain_m_3,
            (chain_vx_3 * chain_vx_3).add_product(chain_vy_3, chain_vy_3)),
        potential: -(p.chain_gravity * (p.chain_m_1 * chain_l_1_times_cos_chain_th_1)
            .add_product(p.chain_m_2, t0).add_product(p.chain_m_3, t0.add_product(p.chain_l_3,
            cos_chain_th_3))),
        stored: R::literal(0.0),
    }
}

/// `dE/dt`, power supplied and power dissipated \[W\]. 219 operations.
#[must_use]
pub fn power_balance<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>) -> PowerBalance<R> {
    let [chain_th_1, chain_th_2, chain_th_3, chain_w_1, chain_w_2, chain_w_3] = *state;
    let chain_th_1_minus_chain_th_2 = chain_th_1 - chain_th_2;
    let chain_th_1_minus_chain_th_3 = chain_th_1 - chain_th_3;
    let chain_th_2_minus_chain_th_3 = chain_th_2 - chain_th_3;
    let [(sin_chain_th_1, cos_chain_th_1), (sin_chain_th_2, cos_chain_th_2), (sin_chain_th_3,
        cos_chain_th_3), (sin_chain_th_1_minus_chain_th_2, cos_chain_th_1_minus_chain_th_2),
        (sin_chain_th_1_minus_chain_th_3, cos_chain_th_1_minus_chain_th_3),
        (sin_chain_th_2_minus_chain_th_3, cos_chain_th_2_minus_chain_th_3)]
        = R::sin_cos_each([chain_th_1, chain_th_2, chain_th_3, chain_th_1_minus_chain_th_2,
        chain_th_1_minus_chain_th_3, chain_th_2_minus_chain_th_3]);
    let chain_x_1 = p.chain_l_1 * sin_chain_th_1;
    let chain_l_1_times_cos_chain_th_1 = p.chain_l_1 * cos_chain_th_1;
    let chain_vx_1 = chain_w_1 * chain_l_1_times_cos_chain_th_1;
    let chain_vy_1 = chain_w_1 * chain_x_1;
    let chain_l_2_times_chain_w_2 = p.chain_l_2 * chain_w_2;
    let chain_vx_2 = chain_vx_1.add_product(chain_l_2_times_chain_w_2, cos_chain_th_2);
    let chain_vy_2 = chain_vy_1.add_product(chain_l_2_times_chain_w_2, sin_chain_th_2);
    let chain_l_3_times_chain_w_3 = p.chain_l_3 * chain_w_3;
    let chain_vx_3 = chain_vx_2.add_product(chain_l_3_times_chain_w_3, cos_chain_th_3);
    let chain_vy_3 = chain_vy_2.add_product(chain_l_3_times_chain_w_3, sin_chain_th_3);
    let chain_m_2_plus_chain_m_3 = p.chain_m_2 + p.chain_m_3;
    let t0 = p.chain_l_1 * p.chain_l_2 * chain_m_2_plus_chain_m_3 * cos_chain_th_1_minus_chain_th_2;
    let chain_m_3_times_chain_l_1 = p.chain_m_3 * p.chain_l_1;
    let t1 = chain_m_3_times_chain_l_1 * p.chain_l_3 * cos_chain_th_1_minus_chain_th_3;
    let chain_m_3_times_chain_l_2 = p.chain_m_3 * p.chain_l_2;
    let t2 = R::literal(1.0) / ((p.chain_m_1 + p.chain_m_2 + p.chain_m_3) * (p.chain_l_1
        * p.chain_l_1));
    let t3 = t0 * t2;
    let t4 = t1 * t2;
    let t5 = R::literal(1.0) / (chain_m_2_plus_chain_m_3 * (p.chain_l_2 * p.chain_l_2))
        .sub_product(t3, t0);
    let t6 = (chain_m_3_times_chain_l_2 * p.chain_l_3 * cos_chain_th_2_minus_chain_th_3)
        .sub_product(t4, t0);
    let t7 = t6 * t5;
    let chain_w_2_squared = chain_w_2 * chain_w_2;
    let chain_m_2_times_chain_l_2 = p.chain_m_2 * p.chain_l_2;
    let chain_m_2_times_chain_gravity = p.chain_m_2 * p.chain_gravity;
    let chain_m_3_times_chain_l_3 = p.chain_m_3 * p.chain_l_3;
    let t8 = chain_m_3_times_chain_l_3 * (chain_w_3 * chain_w_3);
    let chain_m_3_times_chain_gravity = p.chain_m_3 * p.chain_gravity;
    let t9 = p.chain_l_1 * (p.chain_m_1 * p.chain_gravity * sin_chain_th_1)
        .add_product(chain_m_2_times_chain_l_2 * chain_w_2_squared, sin_chain_th_1_minus_chain_th_2)
        .add_product(chain_m_2_times_chain_gravity, sin_chain_th_1)
        .add_product(chain_m_3_times_chain_l_2 * chain_w_2_squared, sin_chain_th_1_minus_chain_th_2)
        .add_product(t8, sin_chain_th_1_minus_chain_th_3)
        .add_product(chain_m_3_times_chain_gravity, sin_chain_th_1);
    let chain_w_1_squared = chain_w_1 * chain_w_1;
    let t10 = (p.chain_l_2 * (p.chain_m_2 * p.chain_l_1 * chain_w_1_squared
        * sin_chain_th_1_minus_chain_th_2).add_product(chain_m_3_times_chain_l_1
        * chain_w_1_squared, sin_chain_th_1_minus_chain_th_2)
        .sub_product(chain_m_2_times_chain_gravity, sin_chain_th_2).sub_product(t8,
        sin_chain_th_2_minus_chain_th_3).sub_product(chain_m_3_times_chain_gravity, sin_chain_th_2))
        .add_product(t3, t9);
    let chain_w_3_dot = (chain_m_3_times_chain_l_3 * (p.chain_l_1 * chain_w_1_squared
        * sin_chain_th_1_minus_chain_th_3).add_product(p.chain_l_2 * chain_w_2_squared,
        sin_chain_th_2_minus_chain_th_3).sub_product(p.chain_gravity, sin_chain_th_3))
        .add_product(t4, t9).sub_product(t7, t10) * (R::literal(1.0) / (p.chain_m_3 * (p.chain_l_3
        * p.chain_l_3)).sub_product(t4, t1).sub_product(t7, t6));
    let chain_w_2_dot = (t10 * t5).sub_product(t7, chain_w_3_dot);
    let t11 = R::literal(2.0) * p.chain_l_2;
    let t12 = R::literal(0.5) * p.chain_m_2;
    let t13 = R::literal(0.5) * p.chain_m_3;
    let t14 = R::literal(2.0) * chain_vx_1;
    let t15 = t11 * chain_w_2;
    let t16 = (t12 * (t15 * chain_vy_2 * cos_chain_th_2).sub_product(t15 * chain_vx_2,
        sin_chain_th_2)).add_product(t13, (t15 * chain_vy_3 * cos_chain_th_2).sub_product(t15
        * chain_vx_3, sin_chain_th_2)).add_product(p.chain_gravity, (chain_m_2_times_chain_l_2
        * sin_chain_th_2).add_product(chain_m_3_times_chain_l_2, sin_chain_th_2));
    let t17 = R::literal(2.0) * p.chain_l_3;
    let t18 = t17 * chain_w_3;
    let t19 = ((t12 * (t14 * chain_vy_2).sub_product(R::literal(2.0) * chain_vx_2, chain_vy_1))
        .add_product(t13, (t14 * chain_vy_3).sub_product(R::literal(2.0) * chain_vx_3, chain_vy_1))
        .add_product(p.chain_gravity, (p.chain_m_1 * chain_x_1).add_product(p.chain_m_2, chain_x_1)
        .add_product(p.chain_m_3, chain_x_1)) * chain_w_1).add_product(t16, chain_w_2)
        .add_product((chain_m_3_times_chain_l_3 * p.chain_gravity * sin_chain_th_3)
        .add_product(t13, (t18 * chain_vy_3 * cos_chain_th_3).sub_product(t18 * chain_vx_3,
        sin_chain_th_3)), chain_w_3);
    let t20 = R::literal(2.0) * chain_l_1_times_cos_chain_th_1;
    let t21 = R::literal(2.0) * chain_x_1;
    let t22 = t19.sub_product((R::literal(0.5) * p.chain_m_1 * (t21 * chain_vy_1).add_product(t20,
        chain_vx_1)).add_product(t12, (t21 * chain_vy_2).add_product(t20, chain_vx_2))
        .add_product(t13, (t21 * chain_vy_3).add_product(t20, chain_vx_3)), (t9 * t2)
        .add_product(t3, chain_w_2_dot).add_product(t4, chain_w_3_dot));
    PowerBalance {
        stored_rate: t22.add_product((t12 * (t11 * chain_vx_2 * cos_chain_th_2).add_product(t11
            * chain_vy_2, sin_chain_th_2)).add_product(t13, (t11 * chain_vx_3 * cos_chain_th_2)
            .add_product(t11 * chain_vy_3, sin_chain_th_2)), chain_w_2_dot).add_product(t13
            * (t17 * chain_vx_3 * cos_chain_th_3).add_product(t17 * chain_vy_3, sin_chain_th_3),
            chain_w_3_dot),
        supplied: R::literal(0.0),
        dissipated: R::literal(0.0),
    }
}

/// Normalized Taylor coefficients of the solution through `state`, order after order.
///
/// `_k` marks the coefficient of order k, `_before` that of order k - 1; bare names are
/// zeroth coefficients. The workspace is as `series_workspace` says.
///
/// 106 recurrences. 29 sums of products an order.
///
/// # Panics
/// If there is no room for the zeroth coefficients, or the workspace is too short.
pub fn series<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>,
        coefficients: &mut [[R; STATES]], workspace: &mut [R]) {
    let (mut lanes, workspace) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let (mut lanes_1, workspace) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let (mut lanes_2, workspace) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let (mut lanes_3, workspace) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let (mut lanes_4, workspace) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let (mut lanes_5, workspace) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let (mut lanes_6, workspace) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let (mut lanes_7, _) = Lanes::<R, 1>::new(workspace, coefficients.len());
    let [chain_th_1, chain_th_2, chain_th_3, chain_w_1, chain_w_2, chain_w_3] = *state;
    let t0 = p.chain_m_1 + p.chain_m_2;
    let t1 = t0 + p.chain_m_3;
    let t2 = p.chain_l_1 * p.chain_l_1;
    let t3 = t1 * t2;
    let t4 = p.chain_m_2 + p.chain_m_3;
    let t5 = chain_th_1 - chain_th_2;
    let t6 = t5.sin();
    let t7 = t5.cos();
    let t8 = p.chain_l_1 * p.chain_l_2;
    let t9 = t8 * t4;
    let t10 = t7 * t9;
    let t11 = chain_th_1 - chain_th_3;
    let t12 = t11.sin();
    let t13 = t11.cos();
    let t14 = p.chain_m_3 * p.chain_l_1;
    let t15 = t14 * p.chain_l_3;
    let t16 = t13 * t15;
    let t17 = p.chain_l_2 * p.chain_l_2;
    let t18 = t4 * t17;
    let t19 = chain_th_2 - chain_th_3;
    let t20 = t19.sin();
    let t21 = t19.cos();
    let t22 = p.chain_m_3 * p.chain_l_2;
    let t23 = t22 * p.chain_l_3;
    let t24 = t21 * t23;
    let t25 = p.chain_l_3 * p.chain_l_3;
    let t26 = p.chain_m_3 * t25;
    let sin_chain_th_1 = chain_th_1.sin();
    let cos_chain_th_1 = chain_th_1.cos();
    let sin_chain_th_2 = chain_th_2.sin();
    let cos_chain_th_2 = chain_th_2.cos();
    let sin_chain_th_3 = chain_th_3.sin();
    let cos_chain_th_3 = chain_th_3.cos();
    let t27 = p.chain_m_1 * p.chain_gravity;
    let t28 = sin_chain_th_1 * t27;
    let t29 = chain_w_2 * chain_w_2;
    let t30 = p.chain_m_2 * p.chain_l_2;
    let t31 = t29 * t30;
    let t32 = t31 * t6;
    let t33 = p.chain_m_2 * p.chain_gravity;
    let t34 = sin_chain_th_1 * t33;
    let t35 = t29 * t22;
    let t36 = t35 * t6;
    let t37 = chain_w_3 * chain_w_3;
    let t38 = p.chain_m_3 * p.chain_l_3;
    let t39 = t37 * t38;
    let t40 = t39 * t12;
    let t41 = p.chain_m_3 * p.chain_gravity;
    let t42 = sin_chain_th_1 * t41;
    let t43 = t28 + t32;
    let t44 = t43 + t34;
    let t45 = t44 + t36;
    let t46 = t45 + t40;
    let t47 = t46 + t42;
    let t48 = t47 * p.chain_l_1;
    let t49 = -t48;
    let t50 = sin_chain_th_2 * t33;
    let t51 = t39 * t20;
    let t52 = sin_chain_th_2 * t41;
    let t53 = chain_w_1 * chain_w_1;
    let t54 = p.chain_m_2 * p.chain_l_1;
    let t55 = t53 * t54;
    let t56 = t55 * t6;
    let t57 = t53 * t14;
    let t58 = t57 * t6;
    let t59 = t56 + t58;
    let t60 = t59 - t50;
    let t61 = t60 - t51;
    let t62 = t61 - t52;
    let t63 = t62 * p.chain_l_2;
    let t64 = sin_chain_th_3 * p.chain_gravity;
    let t65 = t53 * p.chain_l_1;
    let t66 = t65 * t12;
    let t67 = t29 * p.chain_l_2;
    let t68 = t67 * t20;
    let t69 = t66 + t68;
    let t70 = t69 - t64;
    let t71 = t70 * t38;
    let factored = Factored::new([[t3, R::literal(0.0), R::literal(0.0)],
        [t10, t18, R::literal(0.0)], [t16, t24, t26]]);
    let [chain_w_1_dot, chain_w_2_dot, chain_w_3_dot] = factored.solve([t49, t63, t71]);
    let mut rates = [chain_w_1, chain_w_2, chain_w_3, chain_w_1_dot, chain_w_2_dot, chain_w_3_dot];
    coefficients[0] = *state;
    let highest = coefficients.len() - 1;
    for (order, state_k) in coefficients.iter_mut().enumerate().skip(1) {
        let (k, inverse) = order_and_inverse::<R>(order);
        *state_k = rates.map(|rate| rate * inverse);
        if order == highest {
            break;
        }
        let [chain_th_1_k, chain_th_2_k, chain_th_3_k, chain_w_1_k, chain_w_2_k, chain_w_3_k]
            = *state_k;
        let sums = lanes.sums(order);
        let sums_1 = lanes_1.sums(order);
        let sums_2 = lanes_2.sums(order);
        let sums_3 = lanes_3.sums(order);
        let sums_4 = lanes_4.sums(order);
        let sums_5 = lanes_5.sums(order);
        let sums_6 = lanes_6.sums(order);
        let sums_7 = lanes_7.sums(order);
        let t5_k = chain_th_1_k - chain_th_2_k;
        let t6_k = t5_k.mul_add(t7, inverse * sums_2[1]);
        let t7_k = -t5_k.mul_add(t6, inverse * sums_2[2]);
        let t10_k = t7_k * t9;
        let t11_k = chain_th_1_k - chain_th_3_k;
        let t12_k = t11_k.mul_add(t13, inverse * sums_2[3]);
        let t13_k = -t11_k.mul_add(t12, inverse * sums_3[0]);
        let t16_k = t13_k * t15;
        let t19_k = chain_th_2_k - chain_th_3_k;
        let t20_k = t19_k.mul_add(t21, inverse * sums_3[1]);
        let t21_k = -t19_k.mul_add(t20, inverse * sums_3[2]);
        let t24_k = t21_k * t23;
        let sin_chain_th_1_k = chain_th_1_k.mul_add(cos_chain_th_1, inverse * sums[3]);
        let cos_chain_th_1_k = -chain_th_1_k.mul_add(sin_chain_th_1, inverse * sums_1[0]);
        let sin_chain_th_2_k = chain_th_2_k.mul_add(cos_chain_th_2, inverse * sums_1[1]);
        let cos_chain_th_2_k = -chain_th_2_k.mul_add(sin_chain_th_2, inverse * sums_1[2]);
        let sin_chain_th_3_k = chain_th_3_k.mul_add(cos_chain_th_3, inverse * sums_1[3]);
        let cos_chain_th_3_k = -chain_th_3_k.mul_add(sin_chain_th_3, inverse * sums_2[0]);
        let t29_k = (chain_w_2 + chain_w_2).mul_add(chain_w_2_k, sums[0]);
        let t31_k = t29_k * t30;
        let t32_k = t31.mul_add(t6_k, t6.mul_add(t31_k, sums_3[3]));
        let t35_k = t29_k * t22;
        let t36_k = t35.mul_add(t6_k, t6.mul_add(t35_k, sums_4[0]));
        let t37_k = (chain_w_3 + chain_w_3).mul_add(chain_w_3_k, sums[1]);
        let t39_k = t37_k * t38;
        let t40_k = t39.mul_add(t12_k, t12.mul_add(t39_k, sums_4[1]));
        let t43_k = sin_chain_th_1_k.mul_add(t27, t32_k);
        let t44_k = sin_chain_th_1_k.mul_add(t33, t43_k);
        let t45_k = t44_k + t36_k;
        let t46_k = t45_k + t40_k;
        let t47_k = sin_chain_th_1_k.mul_add(t41, t46_k);
        let t48_k = t47_k * p.chain_l_1;
        let t49_k = -t48_k;
        let t51_k = t39.mul_add(t20_k, t20.mul_add(t39_k, sums_4[2]));
        let t53_k = (chain_w_1 + chain_w_1).mul_add(chain_w_1_k, sums[2]);
        let t55_k = t53_k * t54;
        let t56_k = t55.mul_add(t6_k, t6.mul_add(t55_k, sums_4[3]));
        let t57_k = t53_k * t14;
        let t58_k = t57.mul_add(t6_k, t6.mul_add(t57_k, sums_5[0]));
        let t59_k = t56_k + t58_k;
        let t60_k = (-sin_chain_th_2_k).mul_add(t33, t59_k);
        let t61_k = t60_k - t51_k;
        let t62_k = (-sin_chain_th_2_k).mul_add(t41, t61_k);
        let t65_k = t53_k * p.chain_l_1;
        let t66_k = t65.mul_add(t12_k, t12.mul_add(t65_k, sums_5[1]));
        let t67_k = t29_k * p.chain_l_2;
        let t68_k = t67.mul_add(t20_k, t20.mul_add(t67_k, sums_5[2]));
        let t69_k = t66_k + t68_k;
        let t70_k = (-sin_chain_th_3_k).mul_add(p.chain_gravity, t69_k);
        let n94_k = t10_k.mul_add(chain_w_2_dot, sums_5[3]);
        let n95_k = t16_k.mul_add(chain_w_3_dot, sums_6[0]);
        let n96_k = t10_k.mul_add(chain_w_1_dot, sums_6[1]);
        let n97_k = t24_k.mul_add(chain_w_3_dot, sums_6[2]);
        let n98_k = t16_k.mul_add(chain_w_1_dot, sums_6[3]);
        let n99_k = t24_k.mul_add(chain_w_2_dot, sums_7[0]);
        let n100_k = n94_k + n95_k;
        let t49_k_2 = t49_k - n100_k;
        let n102_k = n96_k + n97_k;
        let t63_k = t62_k.mul_add(p.chain_l_2, -n102_k);
        let n104_k = n98_k + n99_k;
        let t71_k = t70_k.mul_add(t38, -n104_k);
        let [chain_w_1_dot_k, chain_w_2_dot_k, chain_w_3_dot_k] = factored
            .solve([t49_k_2, t63_k, t71_k]);
        lanes.set(order, [chain_w_2_k, chain_w_3_k, chain_w_1_k, k * chain_th_1_k], [chain_w_2_k,
            chain_w_3_k, chain_w_1_k, cos_chain_th_1_k]);
        lanes_1.set(order, [k * chain_th_1_k, k * chain_th_2_k, k * chain_th_2_k,
            k * chain_th_3_k], [sin_chain_th_1_k, cos_chain_th_2_k, sin_chain_th_2_k,
            cos_chain_th_3_k]);
        lanes_2.set(order, [k * chain_th_3_k, k * t5_k, k * t5_k, k * t11_k], [sin_chain_th_3_k,
            t7_k, t6_k, t13_k]);
        lanes_3.set(order, [k * t11_k, k * t19_k, k * t19_k, t6_k], [t12_k, t21_k, t20_k, t31_k]);
        lanes_4.set(order, [t6_k, t12_k, t20_k, t6_k], [t35_k, t39_k, t39_k, t55_k]);
        lanes_5.set(order, [t6_k, t12_k, t20_k, t10_k], [t57_k, t65_k, t67_k, chain_w_2_dot_k]);
        lanes_6.set(order, [t16_k, t10_k, t24_k, t16_k], [chain_w_3_dot_k, chain_w_1_dot_k,
            chain_w_3_dot_k, chain_w_1_dot_k]);
        lanes_7.set(order, [t24_k], [chain_w_2_dot_k]);
        rates = [chain_w_1_k, chain_w_2_k, chain_w_3_k, chain_w_1_dot_k, chain_w_2_dot_k,
            chain_w_3_dot_k];
    }
}

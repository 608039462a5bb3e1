// Emitted by Machinist 0.1.0; do not edit. To make it again:
//
//     cargo run --release -- gen
//
// Sources, with SHA-256:
//   bc16f90f46b0cf7565da7ce00079aa46216060ed50a8862fc9575a2f46f554bd  scenes/pendulum_relative.toml
//   b0b36dfb20ac0773fbb9d50f90d5d2d459d987cb00073fdcee9a1c12e91a3bfa  units/three_pendulums_relative.toml
//
// Triple pendulum in relative angles
//
// The machine of `pendulum_chain` in the angles of its joints.
//
// Source:
//   Textbook.
//
// All quantities are in SI units.
// Shapes: coordinates 3, states 6, parameters 7, outputs 2.
// Nonzeros: mass_matrix 9 of 3 by 3, rate_jacobian 21 of 6 by 6, parameter_jacobian 21 of 6 by 7.
// Operations: rate 218, mass_matrix 61, forcing 126, rate_jacobian 515, parameter_jacobian 651,
//     outputs 19, energy 52, power_balance 310, prepare 61, prepared_rate 177,
//     prepared_rate_jacobian 472, prepared_jacobians 875.

use ::machinist_contract::{
    Energy, PowerBalance, Real, taylor::{Factored, Lanes, order_and_inverse},
};

::machinist_contract::simulator! {
    /// Triple pendulum in relative angles
    ///
    /// The machine of \`pendulum_chain\` in the angles of its joints.
    ///
    /// Source: Textbook.
    PendulumRelative: "pendulum_relative", "Triple pendulum in relative angles";
    run from 0.0, until 5.0, points 1001, rtol 1e-8, method "tsit5";
    quadratures 0, discontinuities 0;
    prepared; jacobians_at_once; series 54;
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
    CHAIN_TH_2: position, 1.0, "rad", "chain.th_2", "angle of the second link from the one above";
    CHAIN_TH_3: position, 1.0, "rad", "chain.th_3", "angle of the third link from the one above";
    CHAIN_W_1: velocity, 5.0, "rad/s", "chain.w_1", "rate of angle of the first link";
    CHAIN_W_2: velocity, 5.0, "rad/s", "chain.w_2", "rate of angle of the second link from the one above";
    CHAIN_W_3: velocity, 5.0, "rad/s", "chain.w_3", "rate of angle of the third link from the one above";
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
    t2, t5, t6, t8, chain_m_3_times_chain_l_3_squared, t9, t10, t11, t12, t13,
    chain_m_3_times_chain_l_3, chain_m_1_times_chain_gravity, t14, chain_m_2_times_chain_gravity,
    t15, t16, t17, chain_m_3_times_chain_gravity, t18, chain_m_2_times_chain_l_2,
    chain_m_3_times_chain_l_2, t19, t20, t1, t3, t4, t7, chain_l_1_squared, chain_l_2_squared,
    chain_l_3_squared, chain_m_2_times_chain_l_1, chain_m_3_times_chain_l_1, t21,
    chain_l_1_times_chain_l_2, chain_l_2_times_chain_gravity, t22, t23, t24,
    chain_l_1_times_chain_l_3, chain_l_2_times_chain_l_3, chain_l_3_times_chain_gravity, t25, t26,
    t27, t28, t29, t30, t31
}

/// Returns the constants of `rate` and its Jacobians from the parameters. 61 operations.
#[must_use]
#[inline]
pub fn prepare<R: Real>(p: &Parameters<R>) -> Constants<R> {
    let t0 = R::literal(2.0) * p.chain_m_2;
    let t1 = t0 * p.chain_l_1;
    let t2 = t1 * p.chain_l_2;
    let t3 = R::literal(2.0) * p.chain_m_3;
    let t4 = t3 * p.chain_l_1;
    let t5 = t4 * p.chain_l_2;
    let t6 = t4 * p.chain_l_3;
    let t7 = t3 * p.chain_l_2;
    let t8 = t7 * p.chain_l_3;
    let chain_l_1_squared = p.chain_l_1 * p.chain_l_1;
    let chain_l_2_squared = p.chain_l_2 * p.chain_l_2;
    let chain_m_2_times_chain_l_2_squared = p.chain_m_2 * chain_l_2_squared;
    let chain_m_3_times_chain_l_2_squared = p.chain_m_3 * chain_l_2_squared;
    let chain_l_3_squared = p.chain_l_3 * p.chain_l_3;
    let chain_m_3_times_chain_l_3_squared = p.chain_m_3 * chain_l_3_squared;
    let t9 = ((p.chain_m_1 * chain_l_1_squared).add_product(p.chain_m_2, chain_l_1_squared)
        + chain_m_2_times_chain_l_2_squared).add_product(p.chain_m_3, chain_l_1_squared)
        + chain_m_3_times_chain_l_2_squared + chain_m_3_times_chain_l_3_squared;
    let chain_m_2_times_chain_l_1 = p.chain_m_2 * p.chain_l_1;
    let t10 = chain_m_2_times_chain_l_1 * p.chain_l_2;
    let chain_m_3_times_chain_l_1 = p.chain_m_3 * p.chain_l_1;
    let t11 = chain_m_3_times_chain_l_1 * p.chain_l_2;
    let t12 = chain_m_3_times_chain_l_1 * p.chain_l_3;
    let t13 = chain_m_2_times_chain_l_2_squared + chain_m_3_times_chain_l_2_squared
        + chain_m_3_times_chain_l_3_squared;
    let chain_m_3_times_chain_l_3 = p.chain_m_3 * p.chain_l_3;
    let chain_m_1_times_chain_gravity = p.chain_m_1 * p.chain_gravity;
    let chain_m_2_times_chain_l_2 = p.chain_m_2 * p.chain_l_2;
    let t14 = chain_m_2_times_chain_l_2 * p.chain_gravity;
    let chain_m_2_times_chain_gravity = p.chain_m_2 * p.chain_gravity;
    let chain_m_3_times_chain_l_2 = p.chain_m_3 * p.chain_l_2;
    let t15 = chain_m_3_times_chain_l_2 * p.chain_l_3;
    let t16 = chain_m_3_times_chain_l_2 * p.chain_gravity;
    let t17 = chain_m_3_times_chain_l_3 * p.chain_gravity;
    let chain_m_3_times_chain_gravity = p.chain_m_3 * p.chain_gravity;
    let t18 = R::literal(2.0) * p.chain_l_2;
    let t19 = R::literal(2.0) * p.chain_l_1;
    let t20 = t3 * p.chain_l_3;
    let t21 = t19 * p.chain_l_2;
    let chain_l_1_times_chain_l_2 = p.chain_l_1 * p.chain_l_2;
    let chain_l_2_times_chain_gravity = p.chain_l_2 * p.chain_gravity;
    let t22 = chain_l_1_squared + chain_l_2_squared;
    let t23 = t19 * p.chain_l_3;
    let t24 = t18 * p.chain_l_3;
    let chain_l_1_times_chain_l_3 = p.chain_l_1 * p.chain_l_3;
    let chain_l_2_times_chain_l_3 = p.chain_l_2 * p.chain_l_3;
    let chain_l_3_times_chain_gravity = p.chain_l_3 * p.chain_gravity;
    let t25 = t22 + chain_l_3_squared;
    let t26 = chain_l_2_squared + chain_l_3_squared;
    let t27 = t0 * p.chain_l_2;
    let t28 = chain_m_2_times_chain_l_1.add_product(p.chain_m_1, p.chain_l_1)
        + chain_m_3_times_chain_l_1;
    let t29 = chain_m_2_times_chain_l_2 + chain_m_3_times_chain_l_2;
    let t30 = t27 + t7;
    let t31 = R::literal(2.0) * p.chain_l_3;
    Constants { t2, t5, t6, t8, chain_m_3_times_chain_l_3_squared, t9, t10, t11, t12, t13,
        chain_m_3_times_chain_l_3, chain_m_1_times_chain_gravity, t14,
        chain_m_2_times_chain_gravity, t15, t16, t17, chain_m_3_times_chain_gravity, t18,
        chain_m_2_times_chain_l_2, chain_m_3_times_chain_l_2, t19, t20, t1, t3, t4, t7,
        chain_l_1_squared, chain_l_2_squared, chain_l_3_squared, chain_m_2_times_chain_l_1,
        chain_m_3_times_chain_l_1, t21, chain_l_1_times_chain_l_2, chain_l_2_times_chain_gravity,
        t22, t23, t24, chain_l_1_times_chain_l_3, chain_l_2_times_chain_l_3,
        chain_l_3_times_chain_gravity, t25, t26, t27, t28, t29, t30, t31 }
}

/// State at the start of the run, in the units of the states. No operations.
#[must_use]
pub fn initial_state<R: Real>(_p: &Parameters<R>) -> [R; STATES] {
    [R::literal(0.9), R::literal(0.200_000_000_000_000_07), R::literal(0.299_999_999_999_999_8),
        R::literal(0.0), R::literal(0.0), R::literal(0.0)]
}

/// Times of known jumps of the right-hand side \[s\], unsorted. No operations.
#[must_use]
pub fn discontinuities<R: Real>(_p: &Parameters<R>) -> [R; DISCONTINUITIES] {
    []
}

/// As `rate`, with the constants of the parameters from `prepare`. 177 operations.
#[must_use]
#[inline]
pub fn prepared_rate<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>,
        c: &Constants<R>) -> [R; STATES] {
    let [chain_th_1, chain_th_2, chain_th_3, chain_w_1, chain_w_2, chain_w_3] = *state;
    let [(sin_chain_th_1, cos_chain_th_1), (sin_chain_th_2, cos_chain_th_2), (sin_chain_th_3,
        cos_chain_th_3)] = R::sin_cos_each([chain_th_1, chain_th_2, chain_th_3]);
    let chain_x_1 = p.chain_l_1 * sin_chain_th_1;
    let t0 = (sin_chain_th_1 * cos_chain_th_2).add_product(cos_chain_th_1, sin_chain_th_2);
    let t1 = (cos_chain_th_1 * cos_chain_th_2).sub_product(sin_chain_th_1, sin_chain_th_2);
    let t2 = (sin_chain_th_3 * t1).add_product(cos_chain_th_3, t0);
    let t3 = (cos_chain_th_3 * t1).sub_product(sin_chain_th_3, t0);
    let t4 = (sin_chain_th_1 * t1).sub_product(cos_chain_th_1, t0);
    let t5 = (cos_chain_th_1 * t1).add_product(sin_chain_th_1, t0);
    let t6 = (sin_chain_th_1 * t3).sub_product(cos_chain_th_1, t2);
    let t7 = (cos_chain_th_1 * t3).add_product(sin_chain_th_1, t2);
    let t8 = (t0 * t3).sub_product(t1, t2);
    let t9 = (t1 * t3).add_product(t0, t2);
    let t10 = c.t8 * t9;
    let t11 = c.t13 + t10;
    let t12 = t11.add_product(c.t10, t5).add_product(c.t11, t5).add_product(c.t12, t7);
    let t13 = p.chain_l_2 * t9;
    let t14 = c.chain_m_3_times_chain_l_3 * (p.chain_l_3.add_product(p.chain_l_1, t7) + t13);
    let t15 = R::literal(1.0) / (c.t9.add_product(c.t2, t5).add_product(c.t5, t5).add_product(c.t6,
        t7) + t10);
    let t16 = t12 * t15;
    let t17 = t14 * t15;
    let t18 = R::literal(1.0) / t11.sub_product(t16, t12);
    let t19 = (c.chain_m_3_times_chain_l_3 * (p.chain_l_3 + t13)).sub_product(t17, t12);
    let t20 = t19 * t18;
    let t21 = c.t6 * chain_w_1;
    let t22 = c.t8 * chain_w_1 * chain_w_3 * t8;
    let t23 = c.t8 * chain_w_2 * chain_w_3 * t8;
    let chain_w_2_squared = chain_w_2 * chain_w_2;
    let t24 = c.t14 * t0;
    let chain_w_3_squared = chain_w_3 * chain_w_3;
    let t25 = c.t15 * chain_w_3_squared * t8;
    let t26 = c.t16 * t0;
    let t27 = c.t17 * t2;
    let t28 = ((((c.t2 * chain_w_1 * chain_w_2 * t4).add_product(c.t5 * chain_w_1 * chain_w_2, t4)
        .add_product(t21 * chain_w_2, t6).add_product(t21 * chain_w_3, t6) + t22).add_product(c.t6
        * chain_w_2 * chain_w_3, t6) + t23).add_product(c.chain_m_1_times_chain_gravity, chain_x_1)
        .add_product(c.t10 * chain_w_2_squared, t4) + t24)
        .add_product(c.chain_m_2_times_chain_gravity, chain_x_1).add_product(c.t11
        * chain_w_2_squared, t4).add_product(c.t12 * chain_w_2_squared, t6);
    let t29 = (t28.add_product(c.t12 * chain_w_3_squared, t6) + t25 + t26 + t27)
        .add_product(c.chain_m_3_times_chain_gravity, chain_x_1);
    let chain_w_1_squared = chain_w_1 * chain_w_1;
    let t30 = (sin_chain_th_2 * cos_chain_th_3).add_product(cos_chain_th_2, sin_chain_th_3);
    let t31 = (-(((t22 + t23).add_product(c.t10 * chain_w_1_squared, sin_chain_th_2) + t24)
        .add_product(c.t11 * chain_w_1_squared, sin_chain_th_2).add_product(c.t12
        * chain_w_1_squared, t30) + t25 + t26 + t27)).add_product(t16, t29);
    let chain_w_3_dot = (c.chain_m_3_times_chain_l_3 * (-(p.chain_l_1 * chain_w_1_squared * t30))
        .add_product(c.t18 * chain_w_1 * chain_w_2, t8).add_product(p.chain_l_2
        * chain_w_1_squared, t8).add_product(p.chain_l_2 * chain_w_2_squared, t8)
        .sub_product(p.chain_gravity, t2)).add_product(t17, t29).sub_product(t20, t31)
        * (R::literal(1.0) / c.chain_m_3_times_chain_l_3_squared.sub_product(t17, t14)
        .sub_product(t20, t19));
    let chain_w_2_dot = (t31 * t18).sub_product(t20, chain_w_3_dot);
    let chain_w_1_dot = -(t29 * t15).add_product(t16, chain_w_2_dot).add_product(t17,
        chain_w_3_dot);
    [chain_w_1, chain_w_2, chain_w_3, chain_w_1_dot, chain_w_2_dot, chain_w_3_dot]
}

/// `M = d2L/dq'2`, values in the order of its pattern. 61 operations.
#[must_use]
pub fn mass_matrix<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>) -> [R; 9] {
    let [chain_th_1, chain_th_2, chain_th_3, ..] = *state;
    let chain_a_2 = chain_th_1 + chain_th_2;
    let chain_a_3 = chain_th_3 + chain_a_2;
    let [(_, cos_chain_th_1_minus_chain_a_2), (_, cos_chain_th_1_minus_chain_a_3),
        (_, cos_chain_a_2_minus_chain_a_3)] = R::sin_cos_each([chain_th_1 - chain_a_2,
        chain_th_1 - chain_a_3, chain_a_2 - chain_a_3]);
    let t0 = R::literal(2.0) * p.chain_m_3;
    let t1 = t0 * p.chain_l_1;
    let t2 = t0 * p.chain_l_2 * p.chain_l_3 * cos_chain_a_2_minus_chain_a_3;
    let chain_l_1_squared = p.chain_l_1 * p.chain_l_1;
    let chain_l_2_squared = p.chain_l_2 * p.chain_l_2;
    let chain_m_2_times_chain_l_2_squared = p.chain_m_2 * chain_l_2_squared;
    let chain_m_3_times_chain_l_2_squared = p.chain_m_3 * chain_l_2_squared;
    let chain_m_3_times_chain_l_3_squared = p.chain_m_3 * (p.chain_l_3 * p.chain_l_3);
    let chain_m_3_times_chain_l_1 = p.chain_m_3 * p.chain_l_1;
    let t3 = chain_m_2_times_chain_l_2_squared + chain_m_3_times_chain_l_2_squared
        + chain_m_3_times_chain_l_3_squared + t2;
    let t4 = t3.add_product(p.chain_m_2 * p.chain_l_1 * p.chain_l_2, cos_chain_th_1_minus_chain_a_2)
        .add_product(chain_m_3_times_chain_l_1 * p.chain_l_2, cos_chain_th_1_minus_chain_a_2)
        .add_product(chain_m_3_times_chain_l_1 * p.chain_l_3, cos_chain_th_1_minus_chain_a_3);
    let t5 = p.chain_l_2 * cos_chain_a_2_minus_chain_a_3;
    let chain_m_3_times_chain_l_3 = p.chain_m_3 * p.chain_l_3;
    let t6 = chain_m_3_times_chain_l_3 * (p.chain_l_3.add_product(p.chain_l_1,
        cos_chain_th_1_minus_chain_a_3) + t5);
    let t7 = chain_m_3_times_chain_l_3 * (p.chain_l_3 + t5);
    [(((p.chain_m_1 * chain_l_1_squared).add_product(p.chain_m_2, chain_l_1_squared)
        + chain_m_2_times_chain_l_2_squared).add_product(p.chain_m_3, chain_l_1_squared)
        + chain_m_3_times_chain_l_2_squared
        + chain_m_3_times_chain_l_3_squared).add_product(R::literal(2.0) * p.chain_m_2
        * p.chain_l_1 * p.chain_l_2, cos_chain_th_1_minus_chain_a_2).add_product(t1 * p.chain_l_2,
        cos_chain_th_1_minus_chain_a_2).add_product(t1 * p.chain_l_3,
        cos_chain_th_1_minus_chain_a_3) + t2, t4, t6, t4, t3, t7, t6, t7,
        chain_m_3_times_chain_l_3_squared]
}

/// `f` of `M q'' = f + G^T lambda`, one for each coordinate. 126 operations.
#[must_use]
pub fn forcing<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>) -> [R; COORDINATES] {
    let [chain_th_1, chain_th_2, chain_th_3, chain_w_1, chain_w_2, chain_w_3] = *state;
    let chain_a_2 = chain_th_1 + chain_th_2;
    let chain_a_3 = chain_th_3 + chain_a_2;
    let [(sin_chain_th_1, _), (sin_chain_a_2, _), (sin_chain_a_3, _),
        (sin_chain_th_1_minus_chain_a_2, _), (sin_chain_th_1_minus_chain_a_3, _),
        (sin_chain_a_2_minus_chain_a_3, _), (sin_chain_th_2, _), (sin_chain_th_2_plus_chain_th_3,
        _)] = R::sin_cos_each([chain_th_1, chain_a_2, chain_a_3, chain_th_1 - chain_a_2,
        chain_th_1 - chain_a_3, chain_a_2 - chain_a_3, chain_th_2, chain_th_2 + chain_th_3]);
    let chain_x_1 = p.chain_l_1 * sin_chain_th_1;
    let t0 = R::literal(2.0) * p.chain_m_3;
    let t1 = t0 * p.chain_l_1;
    let t2 = t1 * p.chain_l_3;
    let t3 = t0 * p.chain_l_2 * p.chain_l_3;
    let t4 = p.chain_m_2 * p.chain_l_1 * p.chain_l_2;
    let chain_m_3_times_chain_l_1 = p.chain_m_3 * p.chain_l_1;
    let t5 = chain_m_3_times_chain_l_1 * p.chain_l_2;
    let t6 = chain_m_3_times_chain_l_1 * p.chain_l_3;
    let chain_m_3_times_chain_l_3 = p.chain_m_3 * p.chain_l_3;
    let t7 = t2 * chain_w_1;
    let t8 = t3 * chain_w_1 * chain_w_3 * sin_chain_a_2_minus_chain_a_3;
    let t9 = t3 * chain_w_2 * chain_w_3 * sin_chain_a_2_minus_chain_a_3;
    let chain_w_2_squared = chain_w_2 * chain_w_2;
    let t10 = p.chain_m_2 * p.chain_l_2 * p.chain_gravity * sin_chain_a_2;
    let chain_w_3_squared = chain_w_3 * chain_w_3;
    let chain_m_3_times_chain_l_2 = p.chain_m_3 * p.chain_l_2;
    let t11 = chain_m_3_times_chain_l_2 * p.chain_l_3 * chain_w_3_squared
        * sin_chain_a_2_minus_chain_a_3;
    let t12 = chain_m_3_times_chain_l_2 * p.chain_gravity * sin_chain_a_2;
    let t13 = chain_m_3_times_chain_l_3 * p.chain_gravity * sin_chain_a_3;
    let t14 = (((R::literal(-2.0) * p.chain_m_2 * p.chain_l_1 * p.chain_l_2 * chain_w_1 * chain_w_2
        * sin_chain_th_1_minus_chain_a_2).sub_product(t1 * p.chain_l_2 * chain_w_1 * chain_w_2,
        sin_chain_th_1_minus_chain_a_2).sub_product(t7 * chain_w_2, sin_chain_th_1_minus_chain_a_3)
        .sub_product(t7 * chain_w_3, sin_chain_th_1_minus_chain_a_3) - t8).sub_product(t2
        * chain_w_2 * chain_w_3, sin_chain_th_1_minus_chain_a_3) - t9).sub_product(p.chain_m_1
        * p.chain_gravity, chain_x_1).sub_product(t4 * chain_w_2_squared,
        sin_chain_th_1_minus_chain_a_2) - t10;
    let chain_th_1_forcing = (t14.sub_product(p.chain_m_2 * p.chain_gravity, chain_x_1)
        .sub_product(t5 * chain_w_2_squared, sin_chain_th_1_minus_chain_a_2).sub_product(t6
        * chain_w_2_squared, sin_chain_th_1_minus_chain_a_3).sub_product(t6 * chain_w_3_squared,
        sin_chain_th_1_minus_chain_a_3) - t11 - t12 - t13).sub_product(p.chain_m_3
        * p.chain_gravity, chain_x_1);
    let chain_w_1_squared = chain_w_1 * chain_w_1;
    let chain_th_2_forcing = -(((t8 + t9).add_product(t4 * chain_w_1_squared, sin_chain_th_2) + t10)
        .add_product(t5 * chain_w_1_squared, sin_chain_th_2).add_product(t6 * chain_w_1_squared,
        sin_chain_th_2_plus_chain_th_3) + t11 + t12 + t13);
    let chain_th_3_forcing = chain_m_3_times_chain_l_3 * (-(p.chain_l_1 * chain_w_1_squared
        * sin_chain_th_2_plus_chain_th_3)).add_product(R::literal(2.0) * p.chain_l_2 * chain_w_1
        * chain_w_2, sin_chain_a_2_minus_chain_a_3).add_product(p.chain_l_2 * chain_w_1_squared,
        sin_chain_a_2_minus_chain_a_3).add_product(p.chain_l_2 * chain_w_2_squared,
        sin_chain_a_2_minus_chain_a_3).sub_product(p.chain_gravity, sin_chain_a_3);
    [chain_th_1_forcing, chain_th_2_forcing, chain_th_3_forcing]
}

/// As `rate_jacobian`, with the constants of the parameters from `prepare`. 472 operations.
#[must_use]
pub fn prepared_rate_jacobian<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>,
        c: &Constants<R>) -> [R; 21] {
    let [chain_th_1, chain_th_2, chain_th_3, chain_w_1, chain_w_2, chain_w_3] = *state;
    let [(sin_chain_th_1, cos_chain_th_1), (sin_chain_th_2, cos_chain_th_2), (sin_chain_th_3,
        cos_chain_th_3)] = R::sin_cos_each([chain_th_1, chain_th_2, chain_th_3]);
    let chain_s_2 = chain_w_1 + chain_w_2;
    let chain_s_3 = chain_w_3 + chain_s_2;
    let chain_x_1 = p.chain_l_1 * sin_chain_th_1;
    let chain_l_1_times_cos_chain_th_1 = p.chain_l_1 * cos_chain_th_1;
    let t0 = (sin_chain_th_1 * cos_chain_th_2).add_product(cos_chain_th_1, sin_chain_th_2);
    let t1 = (cos_chain_th_1 * cos_chain_th_2).sub_product(sin_chain_th_1, sin_chain_th_2);
    let t2 = (sin_chain_th_3 * t1).add_product(cos_chain_th_3, t0);
    let t3 = (cos_chain_th_3 * t1).sub_product(sin_chain_th_3, t0);
    let t4 = (sin_chain_th_1 * t1).sub_product(cos_chain_th_1, t0);
    let t5 = (cos_chain_th_1 * t1).add_product(sin_chain_th_1, t0);
    let t6 = (sin_chain_th_1 * t3).sub_product(cos_chain_th_1, t2);
    let t7 = (cos_chain_th_1 * t3).add_product(sin_chain_th_1, t2);
    let t8 = (t0 * t3).sub_product(t1, t2);
    let t9 = (t1 * t3).add_product(t0, t2);
    let t10 = c.t8 * t9;
    let t11 = c.t13 + t10;
    let t12 = t11.add_product(c.t10, t5).add_product(c.t11, t5).add_product(c.t12, t7);
    let t13 = p.chain_l_2 * t9;
    let t14 = c.chain_m_3_times_chain_l_3 * (p.chain_l_3.add_product(p.chain_l_1, t7) + t13);
    let t15 = R::literal(1.0) / (c.t9.add_product(c.t2, t5).add_product(c.t5, t5).add_product(c.t6,
        t7) + t10);
    let t16 = t12 * t15;
    let t17 = t14 * t15;
    let t18 = R::literal(1.0) / t11.sub_product(t16, t12);
    let t19 = (c.chain_m_3_times_chain_l_3 * (p.chain_l_3 + t13)).sub_product(t17, t12);
    let t20 = t19 * t18;
    let t21 = R::literal(1.0) / c.chain_m_3_times_chain_l_3_squared.sub_product(t17, t14)
        .sub_product(t20, t19);
    let t22 = c.t2 * chain_w_1 * chain_w_2;
    let t23 = c.t5 * chain_w_1 * chain_w_2;
    let t24 = c.t6 * chain_w_1;
    let t25 = t24 * chain_w_2;
    let t26 = t24 * chain_w_3;
    let t27 = c.t8 * chain_w_1 * chain_w_3 * t8;
    let t28 = c.t6 * chain_w_2 * chain_w_3;
    let t29 = c.t8 * chain_w_2 * chain_w_3 * t8;
    let chain_w_2_squared = chain_w_2 * chain_w_2;
    let t30 = c.t10 * chain_w_2_squared;
    let t31 = c.t14 * t0;
    let t32 = c.t11 * chain_w_2_squared;
    let t33 = c.t12 * chain_w_2_squared;
    let chain_w_3_squared = chain_w_3 * chain_w_3;
    let t34 = c.t12 * chain_w_3_squared;
    let t35 = c.t15 * chain_w_3_squared * t8;
    let t36 = c.t16 * t0;
    let t37 = c.t17 * t2;
    let t38 = (((((t22 * t4).add_product(t23, t4).add_product(t25, t6).add_product(t26, t6) + t27)
        .add_product(t28, t6) + t29).add_product(c.chain_m_1_times_chain_gravity, chain_x_1)
        .add_product(t30, t4) + t31).add_product(c.chain_m_2_times_chain_gravity, chain_x_1)
        .add_product(t32, t4).add_product(t33, t6).add_product(t34, t6) + t35 + t36 + t37)
        .add_product(c.chain_m_3_times_chain_gravity, chain_x_1);
    let chain_w_1_squared = chain_w_1 * chain_w_1;
    let t39 = c.t10 * chain_w_1_squared;
    let t40 = c.t11 * chain_w_1_squared;
    let t41 = (sin_chain_th_2 * cos_chain_th_3).add_product(cos_chain_th_2, sin_chain_th_3);
    let t42 = (cos_chain_th_2 * cos_chain_th_3).sub_product(sin_chain_th_2, sin_chain_th_3);
    let t43 = c.t12 * chain_w_1_squared;
    let t44 = c.t18 * chain_w_1;
    let t45 = t44 * chain_w_2;
    let chain_l_1_times_chain_w_1_squared = p.chain_l_1 * chain_w_1_squared;
    let chain_l_2_times_chain_w_1_squared = p.chain_l_2 * chain_w_1_squared;
    let chain_l_2_times_chain_w_2_squared = p.chain_l_2 * chain_w_2_squared;
    let t46 = (-(((t27 + t29).add_product(t39, sin_chain_th_2) + t31).add_product(t40,
        sin_chain_th_2).add_product(t43, t41) + t35 + t36 + t37)).add_product(t16, t38);
    let chain_w_3_dot = (c.chain_m_3_times_chain_l_3 * (-(chain_l_1_times_chain_w_1_squared * t41))
        .add_product(t45, t8).add_product(chain_l_2_times_chain_w_1_squared, t8)
        .add_product(chain_l_2_times_chain_w_2_squared, t8).sub_product(p.chain_gravity, t2))
        .add_product(t17, t38).sub_product(t20, t46) * t21;
    let chain_w_2_dot = (t46 * t18).sub_product(t20, chain_w_3_dot);
    let t47 = (t38 * t15).add_product(t16, chain_w_2_dot).add_product(t17, chain_w_3_dot);
    let t48 = (c.chain_m_2_times_chain_l_2 * t1).add_product(c.chain_m_3_times_chain_l_2, t1)
        .add_product(c.chain_m_3_times_chain_l_3, t3);
    let t49 = p.chain_gravity * t48.add_product(p.chain_m_1, chain_l_1_times_cos_chain_th_1)
        .add_product(p.chain_m_2, chain_l_1_times_cos_chain_th_1).add_product(p.chain_m_3,
        chain_l_1_times_cos_chain_th_1);
    let t50 = c.t17 * t3;
    let t51 = (-(p.chain_gravity * t48)).add_product(t16, t49);
    let chain_w_3_dot_by_chain_th_1 = (-t50).add_product(t17, t49).sub_product(t20, t51) * t21;
    let chain_w_2_dot_by_chain_th_1 = (t51 * t18).sub_product(t20, chain_w_3_dot_by_chain_th_1);
    let chain_w_1_dot_by_chain_th_1 = -(t49 * t15).add_product(t16, chain_w_2_dot_by_chain_th_1)
        .add_product(t17, chain_w_3_dot_by_chain_th_1);
    let t52 = c.t14 * t1;
    let t53 = c.t16 * t1;
    let t54 = chain_l_1_times_chain_w_1_squared * t42;
    let t55 = p.chain_gravity * t3;
    let t56 = (c.chain_m_2_times_chain_l_2 * t4).add_product(c.chain_m_3_times_chain_l_2, t4)
        .add_product(c.chain_m_3_times_chain_l_3, t6);
    let t57 = p.chain_l_1 * t56;
    let t58 = c.t12 * t6;
    let t59 = ((t22 * t5).add_product(t23, t5).add_product(t25, t7).add_product(t26, t7)
        .add_product(t28, t7).add_product(t30, t5).add_product(t32, t5).add_product(t33, t7)
        .add_product(t34, t7) - t52 - t53 - t50).add_product(c.t19 * t56, t47).sub_product(t57,
        chain_w_2_dot).sub_product(t58, chain_w_3_dot);
    let t60 = (-(t52.add_product(t39, cos_chain_th_2).add_product(t40, cos_chain_th_2)
        .add_product(t43, t42) + t53 + t50)).add_product(t57, t47).sub_product(t16, t59);
    let chain_w_3_dot_by_chain_th_2 = (-(c.chain_m_3_times_chain_l_3 * (t54 + t55)))
        .add_product(t58, t47).sub_product(t17, t59).sub_product(t20, t60) * t21;
    let chain_w_2_dot_by_chain_th_2 = (t60 * t18).sub_product(t20, chain_w_3_dot_by_chain_th_2);
    let chain_w_1_dot_by_chain_th_2 = (t59 * t15).sub_product(t16, chain_w_2_dot_by_chain_th_2)
        .sub_product(t17, chain_w_3_dot_by_chain_th_2);
    let t61 = c.t19 * chain_w_1;
    let t62 = t44 * chain_w_3 * t9;
    let t63 = c.t18 * chain_w_2 * chain_w_3 * t9;
    let t64 = p.chain_l_2 * chain_w_3_squared * t9;
    let t65 = p.chain_l_1 * t6;
    let t66 = t65.add_product(p.chain_l_2, t8);
    let t67 = c.chain_m_3_times_chain_l_3 * t65.add_product(c.t18, t8);
    let t68 = c.chain_m_3_times_chain_l_3 * t66;
    let t69 = (c.chain_m_3_times_chain_l_3 * ((((t61 * chain_w_2 * t7).add_product(t61 * chain_w_3,
        t7) + t62).add_product(c.t19 * chain_w_2 * chain_w_3, t7) + t63).add_product(p.chain_l_1
        * chain_w_2_squared, t7).add_product(p.chain_l_1 * chain_w_3_squared, t7) + t64 - t55))
        .add_product(c.t20 * t66, t47).sub_product(t67, chain_w_2_dot).sub_product(t68,
        chain_w_3_dot);
    let t70 = c.t15 * t8;
    let t71 = (c.chain_m_3_times_chain_l_3 * (t62 + t63 + t64 - t54 - t55)).add_product(t67, t47)
        .sub_product(c.t8 * t8, chain_w_2_dot).sub_product(t70, chain_w_3_dot).sub_product(t16,
        t69);
    let chain_w_3_dot_by_chain_th_3 = (-(c.chain_m_3_times_chain_l_3 * (t54.add_product(t45, t9)
        .add_product(chain_l_2_times_chain_w_1_squared, t9)
        .add_product(chain_l_2_times_chain_w_2_squared, t9) + t55))).add_product(t68, t47)
        .sub_product(t70, chain_w_2_dot).sub_product(t17, t69).sub_product(t20, t71) * t21;
    let chain_w_2_dot_by_chain_th_3 = (t71 * t18).sub_product(t20, chain_w_3_dot_by_chain_th_3);
    let chain_w_1_dot_by_chain_th_3 = (t69 * t15).sub_product(t16, chain_w_2_dot_by_chain_th_3)
        .sub_product(t17, chain_w_3_dot_by_chain_th_3);
    let t72 = c.t10 * chain_w_2 * t4;
    let t73 = c.t11 * chain_w_2 * t4;
    let t74 = c.t12 * chain_w_2 * t6;
    let t75 = c.t12 * chain_w_3 * t6;
    let t76 = c.t15 * chain_w_3 * t8;
    let t77 = R::literal(2.0) * (t72 + t73 + t74 + t75 + t76);
    let t78 = c.t10 * chain_w_1;
    let t79 = c.t11 * chain_w_1;
    let t80 = c.t12 * chain_w_1;
    let chain_l_1_times_chain_w_1 = p.chain_l_1 * chain_w_1;
    let t81 = p.chain_l_2 * chain_w_1 * t8;
    let t82 = p.chain_l_2 * chain_w_2 * t8;
    let t83 = (R::literal(-2.0) * ((t78 * sin_chain_th_2).add_product(t79, sin_chain_th_2)
        .add_product(t80, t41) + t76)).add_product(t16, t77);
    let chain_w_3_dot_by_chain_w_1 = (-(c.t20 * ((-t81).add_product(chain_l_1_times_chain_w_1, t41)
        - t82))).add_product(t17, t77).sub_product(t20, t83) * t21;
    let chain_w_2_dot_by_chain_w_1 = (t83 * t18).sub_product(t20, chain_w_3_dot_by_chain_w_1);
    let chain_w_1_dot_by_chain_w_1 = -(t77 * t15).add_product(t16, chain_w_2_dot_by_chain_w_1)
        .add_product(t17, chain_w_3_dot_by_chain_w_1);
    let t84 = R::literal(2.0) * ((t78 * t4).add_product(t79, t4).add_product(t80, t6) + t72 + t73
        + t74 + t75 + t76);
    let t85 = (-(c.t8 * chain_w_3 * t8)).add_product(t16, t84);
    let chain_w_3_dot_by_chain_w_2 = (c.t8 * chain_s_2 * t8).add_product(t17, t84).sub_product(t20,
        t85) * t21;
    let chain_w_2_dot_by_chain_w_2 = (t85 * t18).sub_product(t20, chain_w_3_dot_by_chain_w_2);
    let chain_w_1_dot_by_chain_w_2 = -(t84 * t15).add_product(t16, chain_w_2_dot_by_chain_w_2)
        .add_product(t17, chain_w_3_dot_by_chain_w_2);
    let t86 = c.t20 * (t81.add_product(chain_l_1_times_chain_w_1, t6).add_product(p.chain_l_1
        * chain_w_2, t6) + t82).add_product(p.chain_l_1 * chain_w_3, t6).add_product(p.chain_l_2
        * chain_w_3, t8);
    let t87 = (-(c.t8 * chain_s_3 * t8)).add_product(t16, t86);
    let chain_w_3_dot_by_chain_w_3 = (t17 * t86).sub_product(t20, t87) * t21;
    let chain_w_2_dot_by_chain_w_3 = (t87 * t18).sub_product(t20, chain_w_3_dot_by_chain_w_3);
    let chain_w_1_dot_by_chain_w_3 = -(t86 * t15).add_product(t16, chain_w_2_dot_by_chain_w_3)
        .add_product(t17, chain_w_3_dot_by_chain_w_3);
    [R::literal(1.0), R::literal(1.0), R::literal(1.0), chain_w_1_dot_by_chain_th_1,
        chain_w_1_dot_by_chain_th_2, chain_w_1_dot_by_chain_th_3, chain_w_1_dot_by_chain_w_1,
        chain_w_1_dot_by_chain_w_2, chain_w_1_dot_by_chain_w_3, chain_w_2_dot_by_chain_th_1,
        chain_w_2_dot_by_chain_th_2, chain_w_2_dot_by_chain_th_3, chain_w_2_dot_by_chain_w_1,
        chain_w_2_dot_by_chain_w_2, chain_w_2_dot_by_chain_w_3, chain_w_3_dot_by_chain_th_1,
        chain_w_3_dot_by_chain_th_2, chain_w_3_dot_by_chain_th_3, chain_w_3_dot_by_chain_w_1,
        chain_w_3_dot_by_chain_w_2, chain_w_3_dot_by_chain_w_3]
}

/// `rate_jacobian`, then `parameter_jacobian`, with the constants of the parameters from `prepare`.
/// 875 operations.
#[must_use]
pub fn prepared_jacobians<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>,
        c: &Constants<R>) -> [R; 42] {
    let [chain_th_1, chain_th_2, chain_th_3, chain_w_1, chain_w_2, chain_w_3] = *state;
    let [(sin_chain_th_1, cos_chain_th_1), (sin_chain_th_2, cos_chain_th_2), (sin_chain_th_3,
        cos_chain_th_3)] = R::sin_cos_each([chain_th_1, chain_th_2, chain_th_3]);
    let chain_s_2 = chain_w_1 + chain_w_2;
    let chain_s_3 = chain_w_3 + chain_s_2;
    let chain_x_1 = p.chain_l_1 * sin_chain_th_1;
    let chain_l_1_times_cos_chain_th_1 = p.chain_l_1 * cos_chain_th_1;
    let t0 = (sin_chain_th_1 * cos_chain_th_2).add_product(cos_chain_th_1, sin_chain_th_2);
    let t1 = (cos_chain_th_1 * cos_chain_th_2).sub_product(sin_chain_th_1, sin_chain_th_2);
    let t2 = (sin_chain_th_3 * t1).add_product(cos_chain_th_3, t0);
    let t3 = (cos_chain_th_3 * t1).sub_product(sin_chain_th_3, t0);
    let t4 = (sin_chain_th_1 * t1).sub_product(cos_chain_th_1, t0);
    let t5 = (cos_chain_th_1 * t1).add_product(sin_chain_th_1, t0);
    let t6 = (sin_chain_th_1 * t3).sub_product(cos_chain_th_1, t2);
    let t7 = (cos_chain_th_1 * t3).add_product(sin_chain_th_1, t2);
    let t8 = (t0 * t3).sub_product(t1, t2);
    let t9 = (t1 * t3).add_product(t0, t2);
    let t10 = c.t8 * t9;
    let t11 = c.t13 + t10;
    let t12 = t11.add_product(c.t10, t5).add_product(c.t11, t5).add_product(c.t12, t7);
    let t13 = p.chain_l_1 * t7;
    let t14 = p.chain_l_2 * t9;
    let t15 = p.chain_l_3 + t13 + t14;
    let t16 = c.chain_m_3_times_chain_l_3 * t15;
    let t17 = p.chain_l_3 + t14;
    let t18 = R::literal(1.0) / (c.t9.add_product(c.t2, t5).add_product(c.t5, t5).add_product(c.t6,
        t7) + t10);
    let t19 = t12 * t18;
    let t20 = t16 * t18;
    let t21 = R::literal(1.0) / t11.sub_product(t19, t12);
    let t22 = (c.chain_m_3_times_chain_l_3 * t17).sub_product(t20, t12);
    let t23 = t22 * t21;
    let t24 = R::literal(1.0) / c.chain_m_3_times_chain_l_3_squared.sub_product(t20, t16)
        .sub_product(t23, t22);
    let t25 = c.t2 * chain_w_1 * chain_w_2;
    let t26 = c.t5 * chain_w_1 * chain_w_2;
    let t27 = c.t6 * chain_w_1;
    let t28 = t27 * chain_w_2;
    let t29 = t27 * chain_w_3;
    let t30 = c.t8 * chain_w_1 * chain_w_3 * t8;
    let t31 = c.t6 * chain_w_2 * chain_w_3;
    let t32 = c.t8 * chain_w_2 * chain_w_3 * t8;
    let chain_w_2_squared = chain_w_2 * chain_w_2;
    let t33 = c.t10 * chain_w_2_squared;
    let t34 = c.t14 * t0;
    let t35 = c.t11 * chain_w_2_squared;
    let t36 = c.t12 * chain_w_2_squared;
    let chain_w_3_squared = chain_w_3 * chain_w_3;
    let t37 = c.t12 * chain_w_3_squared;
    let t38 = c.t15 * chain_w_3_squared * t8;
    let t39 = c.t16 * t0;
    let t40 = c.t17 * t2;
    let t41 = (((((t25 * t4).add_product(t26, t4).add_product(t28, t6).add_product(t29, t6) + t30)
        .add_product(t31, t6) + t32).add_product(c.chain_m_1_times_chain_gravity, chain_x_1)
        .add_product(t33, t4) + t34).add_product(c.chain_m_2_times_chain_gravity, chain_x_1)
        .add_product(t35, t4).add_product(t36, t6).add_product(t37, t6) + t38 + t39 + t40)
        .add_product(c.chain_m_3_times_chain_gravity, chain_x_1);
    let chain_w_1_squared = chain_w_1 * chain_w_1;
    let t42 = c.t10 * chain_w_1_squared;
    let t43 = c.t11 * chain_w_1_squared;
    let t44 = (sin_chain_th_2 * cos_chain_th_3).add_product(cos_chain_th_2, sin_chain_th_3);
    let t45 = (cos_chain_th_2 * cos_chain_th_3).sub_product(sin_chain_th_2, sin_chain_th_3);
    let t46 = c.t12 * chain_w_1_squared;
    let t47 = c.t18 * chain_w_1;
    let t48 = t47 * chain_w_2;
    let chain_l_1_times_chain_w_1_squared = p.chain_l_1 * chain_w_1_squared;
    let t49 = chain_l_1_times_chain_w_1_squared * t44;
    let chain_l_2_times_chain_w_1_squared = p.chain_l_2 * chain_w_1_squared;
    let chain_l_2_times_chain_w_2_squared = p.chain_l_2 * chain_w_2_squared;
    let t50 = p.chain_gravity * t2;
    let t51 = (-t49).add_product(t48, t8).add_product(chain_l_2_times_chain_w_1_squared, t8)
        .add_product(chain_l_2_times_chain_w_2_squared, t8) - t50;
    let t52 = (-(((t30 + t32).add_product(t42, sin_chain_th_2) + t34).add_product(t43,
        sin_chain_th_2).add_product(t46, t44) + t38 + t39 + t40)).add_product(t19, t41);
    let chain_w_3_dot = (c.chain_m_3_times_chain_l_3 * t51).add_product(t20, t41).sub_product(t23,
        t52) * t24;
    let chain_w_2_dot = (t52 * t21).sub_product(t23, chain_w_3_dot);
    let t53 = (t41 * t18).add_product(t19, chain_w_2_dot).add_product(t20, chain_w_3_dot);
    let t54 = (c.chain_m_2_times_chain_l_2 * t1).add_product(c.chain_m_3_times_chain_l_2, t1)
        .add_product(c.chain_m_3_times_chain_l_3, t3);
    let t55 = p.chain_gravity * t54.add_product(p.chain_m_1, chain_l_1_times_cos_chain_th_1)
        .add_product(p.chain_m_2, chain_l_1_times_cos_chain_th_1).add_product(p.chain_m_3,
        chain_l_1_times_cos_chain_th_1);
    let t56 = c.t17 * t3;
    let t57 = (-(p.chain_gravity * t54)).add_product(t19, t55);
    let chain_w_3_dot_by_chain_th_1 = (-t56).add_product(t20, t55).sub_product(t23, t57) * t24;
    let chain_w_2_dot_by_chain_th_1 = (t57 * t21).sub_product(t23, chain_w_3_dot_by_chain_th_1);
    let chain_w_1_dot_by_chain_th_1 = -(t55 * t18).add_product(t19, chain_w_2_dot_by_chain_th_1)
        .add_product(t20, chain_w_3_dot_by_chain_th_1);
    let t58 = c.t14 * t1;
    let t59 = c.t16 * t1;
    let t60 = chain_l_1_times_chain_w_1_squared * t45;
    let t61 = p.chain_gravity * t3;
    let t62 = (c.chain_m_2_times_chain_l_2 * t4).add_product(c.chain_m_3_times_chain_l_2, t4)
        .add_product(c.chain_m_3_times_chain_l_3, t6);
    let t63 = p.chain_l_1 * t62;
    let t64 = c.t12 * t6;
    let t65 = ((t25 * t5).add_product(t26, t5).add_product(t28, t7).add_product(t29, t7)
        .add_product(t31, t7).add_product(t33, t5).add_product(t35, t5).add_product(t36, t7)
        .add_product(t37, t7) - t58 - t59 - t56).add_product(c.t19 * t62, t53).sub_product(t63,
        chain_w_2_dot).sub_product(t64, chain_w_3_dot);
    let t66 = (-(t58.add_product(t42, cos_chain_th_2).add_product(t43, cos_chain_th_2)
        .add_product(t46, t45) + t59 + t56)).add_product(t63, t53).sub_product(t19, t65);
    let chain_w_3_dot_by_chain_th_2 = (-(c.chain_m_3_times_chain_l_3 * (t60 + t61)))
        .add_product(t64, t53).sub_product(t20, t65).sub_product(t23, t66) * t24;
    let chain_w_2_dot_by_chain_th_2 = (t66 * t21).sub_product(t23, chain_w_3_dot_by_chain_th_2);
    let chain_w_1_dot_by_chain_th_2 = (t65 * t18).sub_product(t19, chain_w_2_dot_by_chain_th_2)
        .sub_product(t20, chain_w_3_dot_by_chain_th_2);
    let t67 = c.t19 * chain_w_1;
    let t68 = t67 * chain_w_2;
    let t69 = t67 * chain_w_3;
    let t70 = t47 * chain_w_3;
    let t71 = t70 * t9;
    let t72 = c.t19 * chain_w_2 * chain_w_3;
    let t73 = c.t18 * chain_w_2 * chain_w_3;
    let t74 = t73 * t9;
    let chain_l_1_times_chain_w_2_squared = p.chain_l_1 * chain_w_2_squared;
    let chain_l_1_times_chain_w_3_squared = p.chain_l_1 * chain_w_3_squared;
    let chain_l_2_times_chain_w_3_squared = p.chain_l_2 * chain_w_3_squared;
    let t75 = chain_l_2_times_chain_w_3_squared * t9;
    let t76 = p.chain_l_1 * t6;
    let t77 = t76.add_product(p.chain_l_2, t8);
    let t78 = c.chain_m_3_times_chain_l_3 * t76.add_product(c.t18, t8);
    let t79 = c.chain_m_3_times_chain_l_3 * t77;
    let t80 = (c.chain_m_3_times_chain_l_3 * ((((t68 * t7).add_product(t69, t7) + t71)
        .add_product(t72, t7) + t74).add_product(chain_l_1_times_chain_w_2_squared, t7)
        .add_product(chain_l_1_times_chain_w_3_squared, t7) + t75 - t61)).add_product(c.t20 * t77,
        t53).sub_product(t78, chain_w_2_dot).sub_product(t79, chain_w_3_dot);
    let t81 = c.t15 * t8;
    let t82 = (c.chain_m_3_times_chain_l_3 * (t71 + t74 + t75 - t60 - t61)).add_product(t78, t53)
        .sub_product(c.t8 * t8, chain_w_2_dot).sub_product(t81, chain_w_3_dot).sub_product(t19,
        t80);
    let chain_w_3_dot_by_chain_th_3 = (-(c.chain_m_3_times_chain_l_3 * (t60.add_product(t48, t9)
        .add_product(chain_l_2_times_chain_w_1_squared, t9)
        .add_product(chain_l_2_times_chain_w_2_squared, t9) + t61))).add_product(t79, t53)
        .sub_product(t81, chain_w_2_dot).sub_product(t20, t80).sub_product(t23, t82) * t24;
    let chain_w_2_dot_by_chain_th_3 = (t82 * t21).sub_product(t23, chain_w_3_dot_by_chain_th_3);
    let chain_w_1_dot_by_chain_th_3 = (t80 * t18).sub_product(t19, chain_w_2_dot_by_chain_th_3)
        .sub_product(t20, chain_w_3_dot_by_chain_th_3);
    let t83 = c.t10 * chain_w_2 * t4;
    let t84 = c.t11 * chain_w_2 * t4;
    let t85 = c.t12 * chain_w_2 * t6;
    let t86 = c.t12 * chain_w_3 * t6;
    let t87 = c.t15 * chain_w_3 * t8;
    let t88 = R::literal(2.0) * (t83 + t84 + t85 + t86 + t87);
    let t89 = c.t10 * chain_w_1;
    let t90 = c.t11 * chain_w_1;
    let t91 = c.t12 * chain_w_1;
    let chain_l_1_times_chain_w_1 = p.chain_l_1 * chain_w_1;
    let t92 = p.chain_l_2 * chain_w_1 * t8;
    let t93 = p.chain_l_2 * chain_w_2 * t8;
    let t94 = (R::literal(-2.0) * ((t89 * sin_chain_th_2).add_product(t90, sin_chain_th_2)
        .add_product(t91, t44) + t87)).add_product(t19, t88);
    let chain_w_3_dot_by_chain_w_1 = (-(c.t20 * ((-t92).add_product(chain_l_1_times_chain_w_1, t44)
        - t93))).add_product(t20, t88).sub_product(t23, t94) * t24;
    let chain_w_2_dot_by_chain_w_1 = (t94 * t21).sub_product(t23, chain_w_3_dot_by_chain_w_1);
    let chain_w_1_dot_by_chain_w_1 = -(t88 * t18).add_product(t19, chain_w_2_dot_by_chain_w_1)
        .add_product(t20, chain_w_3_dot_by_chain_w_1);
    let t95 = R::literal(2.0) * ((t89 * t4).add_product(t90, t4).add_product(t91, t6) + t83 + t84
        + t85 + t86 + t87);
    let t96 = (-(c.t8 * chain_w_3 * t8)).add_product(t19, t95);
    let chain_w_3_dot_by_chain_w_2 = (c.t8 * chain_s_2 * t8).add_product(t20, t95).sub_product(t23,
        t96) * t24;
    let chain_w_2_dot_by_chain_w_2 = (t96 * t21).sub_product(t23, chain_w_3_dot_by_chain_w_2);
    let chain_w_1_dot_by_chain_w_2 = -(t95 * t18).add_product(t19, chain_w_2_dot_by_chain_w_2)
        .add_product(t20, chain_w_3_dot_by_chain_w_2);
    let t97 = c.t20 * (t92.add_product(chain_l_1_times_chain_w_1, t6).add_product(p.chain_l_1
        * chain_w_2, t6) + t93).add_product(p.chain_l_1 * chain_w_3, t6).add_product(p.chain_l_2
        * chain_w_3, t8);
    let t98 = (-(c.t8 * chain_s_3 * t8)).add_product(t19, t97);
    let chain_w_3_dot_by_chain_w_3 = (t20 * t97).sub_product(t23, t98) * t24;
    let chain_w_2_dot_by_chain_w_3 = (t98 * t21).sub_product(t23, chain_w_3_dot_by_chain_w_3);
    let chain_w_1_dot_by_chain_w_3 = -(t97 * t18).add_product(t19, chain_w_2_dot_by_chain_w_3)
        .add_product(t20, chain_w_3_dot_by_chain_w_3);
    let chain_gravity_times_chain_x_1 = p.chain_gravity * chain_x_1;
    let t99 = (-chain_gravity_times_chain_x_1).add_product(c.chain_l_1_squared, t53);
    let t100 = t19 * t99;
    let chain_w_3_dot_by_chain_m_1 = (-(t20 * t99)).add_product(t23, t100) * t24;
    let t101 = (t100 * t21).add_product(t23, chain_w_3_dot_by_chain_m_1);
    let chain_w_2_dot_by_chain_m_1 = -t101;
    let chain_w_1_dot_by_chain_m_1 = (t99 * t18).add_product(t19, t101).sub_product(t20,
        chain_w_3_dot_by_chain_m_1);
    let t102 = c.t21 * chain_w_1 * chain_w_2 * t4;
    let t103 = c.chain_l_1_times_chain_l_2 * chain_w_2_squared * t4;
    let t104 = c.chain_l_2_times_chain_gravity * t0;
    let t105 = c.t21 * t5;
    let t106 = p.chain_l_2 * p.chain_l_2.add_product(p.chain_l_1, t5);
    let t107 = (-(t102 + t103 + t104 + chain_gravity_times_chain_x_1)).add_product(c.t22 + t105,
        t53).sub_product(t106, chain_w_2_dot);
    let t108 = (-(p.chain_l_2 * (chain_l_1_times_chain_w_1_squared * sin_chain_th_2)
        .add_product(p.chain_gravity, t0))).add_product(t106, t53).sub_product(c.chain_l_2_squared,
        chain_w_2_dot).sub_product(t19, t107);
    let t109 = (t20 * t107).add_product(t23, t108) * t24;
    let chain_w_3_dot_by_chain_m_2 = -t109;
    let chain_w_2_dot_by_chain_m_2 = (t108 * t21).add_product(t23, t109);
    let chain_w_1_dot_by_chain_m_2 = (t107 * t18).sub_product(t19, chain_w_2_dot_by_chain_m_2)
        .add_product(t20, t109);
    let t110 = c.t23 * chain_w_1;
    let t111 = c.t24 * chain_w_1 * chain_w_3 * t8;
    let t112 = c.t24 * chain_w_2 * chain_w_3 * t8;
    let t113 = c.chain_l_2_times_chain_l_3 * chain_w_3_squared * t8;
    let t114 = c.chain_l_3_times_chain_gravity * t2;
    let t115 = c.t24 * t9;
    let t116 = c.t26 + t115;
    let t117 = t116.add_product(c.chain_l_1_times_chain_l_2, t5)
        .add_product(c.chain_l_1_times_chain_l_3, t7);
    let t118 = p.chain_l_3 * t15;
    let t119 = (-(((t102.add_product(t110 * chain_w_2, t6).add_product(t110 * chain_w_3, t6) + t111)
        .add_product(c.t23 * chain_w_2 * chain_w_3, t6) + t112 + t103)
        .add_product(c.chain_l_1_times_chain_l_3 * chain_w_2_squared, t6)
        .add_product(c.chain_l_1_times_chain_l_3 * chain_w_3_squared, t6) + t113 + t104 + t114
        + chain_gravity_times_chain_x_1)).add_product((c.t25 + t105).add_product(c.t23, t7) + t115,
        t53).sub_product(t117, chain_w_2_dot).sub_product(t118, chain_w_3_dot);
    let t120 = p.chain_l_3 * t17;
    let t121 = (-((t111 + t112).add_product(c.chain_l_1_times_chain_l_2 * chain_w_1_squared,
        sin_chain_th_2).add_product(c.chain_l_1_times_chain_l_3 * chain_w_1_squared, t44) + t113
        + t104 + t114)).add_product(t117, t53).sub_product(t116, chain_w_2_dot).sub_product(t120,
        chain_w_3_dot).sub_product(t19, t119);
    let chain_w_3_dot_by_chain_m_3 = (p.chain_l_3 * t51).add_product(t118, t53).sub_product(t120,
        chain_w_2_dot).sub_product(c.chain_l_3_squared, chain_w_3_dot).sub_product(t20, t119)
        .sub_product(t23, t121) * t24;
    let chain_w_2_dot_by_chain_m_3 = (t121 * t21).sub_product(t23, chain_w_3_dot_by_chain_m_3);
    let chain_w_1_dot_by_chain_m_3 = (t119 * t18).sub_product(t19, chain_w_2_dot_by_chain_m_3)
        .sub_product(t20, chain_w_3_dot_by_chain_m_3);
    let t122 = c.t20 * chain_w_1;
    let t123 = t122 * chain_w_3;
    let t124 = c.t20 * chain_w_2 * chain_w_3;
    let t125 = c.chain_m_3_times_chain_l_3 * chain_w_3_squared;
    let t126 = (c.t27 * chain_w_1 * chain_w_2 * t4).add_product(c.t7 * chain_w_1 * chain_w_2, t4)
        .add_product(t122 * chain_w_2, t6).add_product(t123, t6).add_product(t124, t6)
        .add_product(c.chain_m_1_times_chain_gravity, sin_chain_th_1)
        .add_product(c.chain_m_2_times_chain_l_2 * chain_w_2_squared, t4)
        .add_product(c.chain_m_2_times_chain_gravity, sin_chain_th_1)
        .add_product(c.chain_m_3_times_chain_l_2 * chain_w_2_squared, t4)
        .add_product(c.chain_m_3_times_chain_l_3 * chain_w_2_squared, t6).add_product(t125, t6)
        .add_product(c.chain_m_3_times_chain_gravity, sin_chain_th_1);
    let t127 = c.chain_m_2_times_chain_l_2 * t5;
    let t128 = c.chain_m_3_times_chain_l_2 * t5;
    let t129 = c.chain_m_3_times_chain_l_3 * t7;
    let t130 = t127 + t128 + t129;
    let t131 = (-t126).add_product(R::literal(2.0) * (c.t28 + t127 + t128 + t129), t53)
        .sub_product(t130, chain_w_2_dot).sub_product(t129, chain_w_3_dot);
    let t132 = (-((c.chain_m_2_times_chain_l_2 * sin_chain_th_2)
        .add_product(c.chain_m_3_times_chain_l_2, sin_chain_th_2)
        .add_product(c.chain_m_3_times_chain_l_3, t44) * chain_w_1_squared)).add_product(t130, t53)
        .sub_product(t19, t131);
    let chain_w_3_dot_by_chain_l_1 = (-(c.chain_m_3_times_chain_l_3 * chain_w_1_squared * t44))
        .add_product(t129, t53).sub_product(t20, t131).sub_product(t23, t132) * t24;
    let chain_w_2_dot_by_chain_l_1 = (t132 * t21).sub_product(t23, chain_w_3_dot_by_chain_l_1);
    let chain_w_1_dot_by_chain_l_1 = (t131 * t18).sub_product(t19, chain_w_2_dot_by_chain_l_1)
        .sub_product(t20, chain_w_3_dot_by_chain_l_1);
    let t133 = t123 * t8;
    let t134 = t124 * t8;
    let t135 = c.chain_m_2_times_chain_gravity * t0;
    let t136 = t125 * t8;
    let t137 = c.chain_m_3_times_chain_gravity * t0;
    let t138 = c.chain_m_2_times_chain_l_1 * t5;
    let t139 = c.chain_m_3_times_chain_l_1 * t5;
    let t140 = c.chain_m_3_times_chain_l_3 * t9;
    let t141 = c.t30.add_product(c.t20, t9) + t138 + t139;
    let t142 = t140 * chain_w_3_dot;
    let t143 = (-((((c.t1 * chain_w_1 * chain_w_2 * t4).add_product(c.t4 * chain_w_1 * chain_w_2,
        t4) + t133 + t134).add_product(c.chain_m_2_times_chain_l_1 * chain_w_2_squared, t4) + t135)
        .add_product(c.chain_m_3_times_chain_l_1 * chain_w_2_squared, t4) + t136 + t137))
        .add_product(R::literal(2.0) * (c.t29 + t138 + t139 + t140), t53).sub_product(t141,
        chain_w_2_dot) - t142;
    let t144 = ((-(((t133 + t134).add_product(c.chain_m_2_times_chain_l_1 * chain_w_1_squared,
        sin_chain_th_2) + t135).add_product(c.chain_m_3_times_chain_l_1 * chain_w_1_squared,
        sin_chain_th_2) + t136 + t137)).add_product(t141, t53).sub_product(R::literal(2.0)
        * (c.t29 + t140), chain_w_2_dot) - t142).sub_product(t19, t143);
    let chain_w_3_dot_by_chain_l_2 = (c.chain_m_3_times_chain_l_3 * (chain_w_1_squared
        .add_product(R::literal(2.0) * chain_w_1, chain_w_2) + chain_w_2_squared) * t8)
        .add_product(t140, t53).sub_product(t140, chain_w_2_dot).sub_product(t20, t143)
        .sub_product(t23, t144) * t24;
    let chain_w_2_dot_by_chain_l_2 = (t144 * t21).sub_product(t23, chain_w_3_dot_by_chain_l_2);
    let chain_w_1_dot_by_chain_l_2 = (t143 * t18).sub_product(t19, chain_w_2_dot_by_chain_l_2)
        .sub_product(t20, chain_w_3_dot_by_chain_l_2);
    let t145 = t70 * t8;
    let t146 = t73 * t8;
    let t147 = chain_l_2_times_chain_w_3_squared * t8;
    let t148 = p.chain_m_3 * (c.t31.add_product(c.t18, t9) + t13);
    let t149 = p.chain_m_3 * (c.t31 + t13 + t14);
    let t150 = (-(p.chain_m_3 * ((((t68 * t6).add_product(t69, t6) + t145).add_product(t72, t6)
        + t146).add_product(chain_l_1_times_chain_w_2_squared, t6)
        .add_product(chain_l_1_times_chain_w_3_squared, t6) + t147 + t50))).add_product(c.t3 * t15,
        t53).sub_product(t148, chain_w_2_dot).sub_product(t149, chain_w_3_dot);
    let t151 = p.chain_m_3 * (c.t31 + t14);
    let t152 = (-(p.chain_m_3 * (t145 + t146 + t49 + t147 + t50))).add_product(t148, t53)
        .sub_product(c.t3 * t17, chain_w_2_dot).sub_product(t151, chain_w_3_dot).sub_product(t19,
        t150);
    let chain_w_3_dot_by_chain_l_3 = (p.chain_m_3 * t51).add_product(t149, t53).sub_product(t151,
        chain_w_2_dot).sub_product(c.t20, chain_w_3_dot).sub_product(t20, t150).sub_product(t23,
        t152) * t24;
    let chain_w_2_dot_by_chain_l_3 = (t152 * t21).sub_product(t23, chain_w_3_dot_by_chain_l_3);
    let chain_w_1_dot_by_chain_l_3 = (t150 * t18).sub_product(t19, chain_w_2_dot_by_chain_l_3)
        .sub_product(t20, chain_w_3_dot_by_chain_l_3);
    let t153 = c.chain_m_2_times_chain_l_2 * t0;
    let t154 = c.chain_m_3_times_chain_l_2 * t0;
    let t155 = c.chain_m_3_times_chain_l_3 * t2;
    let t156 = (t153.add_product(p.chain_m_1, chain_x_1).add_product(p.chain_m_2, chain_x_1) + t154
        + t155).add_product(p.chain_m_3, chain_x_1);
    let t157 = (-(t153 + t154 + t155)).add_product(t19, t156);
    let chain_w_3_dot_by_chain_gravity = (-t155).add_product(t20, t156).sub_product(t23, t157)
        * t24;
    let chain_w_2_dot_by_chain_gravity = (t157 * t21).sub_product(t23,
        chain_w_3_dot_by_chain_gravity);
    let chain_w_1_dot_by_chain_gravity = -(t156 * t18).add_product(t19,
        chain_w_2_dot_by_chain_gravity).add_product(t20, chain_w_3_dot_by_chain_gravity);
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

/// Wanted outputs. 19 operations.
#[must_use]
pub fn outputs<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>) -> Outputs<R> {
    let [chain_th_1, chain_th_2, chain_th_3, ..] = *state;
    let chain_a_2 = chain_th_1 + chain_th_2;
    let chain_a_3 = chain_th_3 + chain_a_2;
    let [(sin_chain_th_1, cos_chain_th_1), (sin_chain_a_2, cos_chain_a_2), (sin_chain_a_3,
        cos_chain_a_3)] = R::sin_cos_each([chain_th_1, chain_a_2, chain_a_3]);
    let chain_x_1 = p.chain_l_1 * sin_chain_th_1;
    let chain_x_2 = chain_x_1.add_product(p.chain_l_2, sin_chain_a_2);
    let chain_x_3 = chain_x_2.add_product(p.chain_l_3, sin_chain_a_3);
    let chain_y_3 = -(p.chain_l_1 * cos_chain_th_1).add_product(p.chain_l_2, cos_chain_a_2)
        .add_product(p.chain_l_3, cos_chain_a_3);
    Outputs {
        end_x: chain_x_3,
        end_y: chain_y_3,
    }
}

/// T, V and the energy of first-order states \[J\]. 52 operations.
#[must_use]
pub fn energy<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>) -> Energy<R> {
    let [chain_th_1, chain_th_2, chain_th_3, chain_w_1, chain_w_2, chain_w_3] = *state;
    let chain_a_2 = chain_th_1 + chain_th_2;
    let chain_a_3 = chain_th_3 + chain_a_2;
    let [(sin_chain_th_1, cos_chain_th_1), (sin_chain_a_2, cos_chain_a_2), (sin_chain_a_3,
        cos_chain_a_3)] = R::sin_cos_each([chain_th_1, chain_a_2, chain_a_3]);
    let chain_s_2 = chain_w_1 + chain_w_2;
    let chain_s_3 = chain_w_3 + chain_s_2;
    let chain_x_1 = p.chain_l_1 * sin_chain_th_1;
    let chain_l_1_times_cos_chain_th_1 = p.chain_l_1 * cos_chain_th_1;
    let chain_vx_1 = chain_w_1 * chain_l_1_times_cos_chain_th_1;
    let chain_vy_1 = chain_w_1 * chain_x_1;
    let t0 = chain_l_1_times_cos_chain_th_1.add_product(p.chain_l_2, cos_chain_a_2);
    let chain_l_2_times_chain_s_2 = p.chain_l_2 * chain_s_2;
    let chain_vx_2 = chain_vx_1.add_product(chain_l_2_times_chain_s_2, cos_chain_a_2);
    let chain_vy_2 = chain_vy_1.add_product(chain_l_2_times_chain_s_2, sin_chain_a_2);
    let chain_l_3_times_chain_s_3 = p.chain_l_3 * chain_s_3;
    let chain_vx_3 = chain_vx_2.add_product(chain_l_3_times_chain_s_3, cos_chain_a_3);
    let chain_vy_3 = chain_vy_2.add_product(chain_l_3_times_chain_s_3, sin_chain_a_3);
    Energy {
        kinetic: (R::literal(0.5) * p.chain_m_1 * (chain_vx_1 * chain_vx_1).add_product(chain_vy_1,
            chain_vy_1)).add_product(R::literal(0.5) * p.chain_m_2, (chain_vx_2 * chain_vx_2)
            .add_product(chain_vy_2, chain_vy_2)).add_product(R::literal(0.5) * p.chain_m_3,
            (chain_vx_3 * chain_vx_3).add_product(chain_vy_3, chain_vy_3)),
        potential: -(p.chain_gravity * (p.chain_m_1 * chain_l_1_times_cos_chain_th_1)
            .add_product(p.chain_m_2, t0).add_product(p.chain_m_3, t0.add_product(p.chain_l_3,
            cos_chain_a_3))),
        stored: R::literal(0.0),
    }
}

/// `dE/dt`, power supplied and power dissipated \[W\]. 310 operations.
#[must_use]
pub fn power_balance<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>) -> PowerBalance<R> {
    let [chain_th_1, chain_th_2, chain_th_3, chain_w_1, chain_w_2, chain_w_3] = *state;
    let chain_a_2 = chain_th_1 + chain_th_2;
    let chain_a_3 = chain_th_3 + chain_a_2;
    let chain_th_1_minus_chain_a_2 = chain_th_1 - chain_a_2;
    let chain_th_1_minus_chain_a_3 = chain_th_1 - chain_a_3;
    let chain_a_2_minus_chain_a_3 = chain_a_2 - chain_a_3;
    let [(sin_chain_th_1, cos_chain_th_1), (sin_chain_a_2, cos_chain_a_2), (sin_chain_a_3,
        cos_chain_a_3), (sin_chain_th_1_minus_chain_a_2, cos_chain_th_1_minus_chain_a_2),
        (sin_chain_th_1_minus_chain_a_3, cos_chain_th_1_minus_chain_a_3),
        (sin_chain_a_2_minus_chain_a_3, cos_chain_a_2_minus_chain_a_3), (sin_chain_th_2, _),
        (sin_chain_th_2_plus_chain_th_3, _)] = R::sin_cos_each([chain_th_1, chain_a_2, chain_a_3,
        chain_th_1_minus_chain_a_2, chain_th_1_minus_chain_a_3, chain_a_2_minus_chain_a_3,
        chain_th_2, chain_th_2 + chain_th_3]);
    let chain_s_2 = chain_w_1 + chain_w_2;
    let chain_s_3 = chain_w_3 + chain_s_2;
    let chain_x_1 = p.chain_l_1 * sin_chain_th_1;
    let chain_l_1_times_cos_chain_th_1 = p.chain_l_1 * cos_chain_th_1;
    let chain_vx_1 = chain_w_1 * chain_l_1_times_cos_chain_th_1;
    let chain_vy_1 = chain_w_1 * chain_x_1;
    let chain_l_2_times_sin_chain_a_2 = p.chain_l_2 * sin_chain_a_2;
    let chain_x_2 = chain_x_1 + chain_l_2_times_sin_chain_a_2;
    let chain_l_2_times_cos_chain_a_2 = p.chain_l_2 * cos_chain_a_2;
    let t0 = chain_l_1_times_cos_chain_th_1 + chain_l_2_times_cos_chain_a_2;
    let chain_l_2_times_chain_s_2 = p.chain_l_2 * chain_s_2;
    let t1 = chain_l_2_times_chain_s_2 * cos_chain_a_2;
    let chain_vx_2 = chain_vx_1 + t1;
    let t2 = chain_l_2_times_chain_s_2 * sin_chain_a_2;
    let chain_vy_2 = chain_vy_1 + t2;
    let chain_l_3_times_sin_chain_a_3 = p.chain_l_3 * sin_chain_a_3;
    let chain_x_3 = chain_x_2 + chain_l_3_times_sin_chain_a_3;
    let chain_l_3_times_cos_chain_a_3 = p.chain_l_3 * cos_chain_a_3;
    let chain_l_3_times_chain_s_3 = p.chain_l_3 * chain_s_3;
    let t3 = chain_l_3_times_chain_s_3 * cos_chain_a_3;
    let chain_vx_3 = chain_vx_2 + t3;
    let t4 = chain_l_3_times_chain_s_3 * sin_chain_a_3;
    let chain_vy_3 = chain_vy_2 + t4;
    let t5 = R::literal(2.0) * p.chain_m_2 * p.chain_l_1 * p.chain_l_2;
    let t6 = R::literal(2.0) * p.chain_m_3;
    let t7 = t6 * p.chain_l_1;
    let t8 = t7 * p.chain_l_2;
    let t9 = t7 * p.chain_l_3;
    let t10 = t6 * p.chain_l_2 * p.chain_l_3;
    let t11 = t10 * cos_chain_a_2_minus_chain_a_3;
    let chain_l_1_squared = p.chain_l_1 * p.chain_l_1;
    let chain_l_2_squared = p.chain_l_2 * p.chain_l_2;
    let chain_m_2_times_chain_l_2_squared = p.chain_m_2 * chain_l_2_squared;
    let chain_m_3_times_chain_l_2_squared = p.chain_m_3 * chain_l_2_squared;
    let chain_m_3_times_chain_l_3_squared = p.chain_m_3 * (p.chain_l_3 * p.chain_l_3);
    let t12 = p.chain_m_2 * p.chain_l_1 * p.chain_l_2;
    let chain_m_3_times_chain_l_1 = p.chain_m_3 * p.chain_l_1;
    let t13 = chain_m_3_times_chain_l_1 * p.chain_l_2;
    let t14 = chain_m_3_times_chain_l_1 * p.chain_l_3;
    let t15 = chain_m_2_times_chain_l_2_squared + chain_m_3_times_chain_l_2_squared
        + chain_m_3_times_chain_l_3_squared + t11;
    let t16 = t15.add_product(t12, cos_chain_th_1_minus_chain_a_2).add_product(t13,
        cos_chain_th_1_minus_chain_a_2).add_product(t14, cos_chain_th_1_minus_chain_a_3);
    let t17 = p.chain_l_2 * cos_chain_a_2_minus_chain_a_3;
    let chain_m_3_times_chain_l_3 = p.chain_m_3 * p.chain_l_3;
    let t18 = chain_m_3_times_chain_l_3 * (p.chain_l_3.add_product(p.chain_l_1,
        cos_chain_th_1_minus_chain_a_3) + t17);
    let t19 = R::literal(1.0) / ((((p.chain_m_1 * chain_l_1_squared).add_product(p.chain_m_2,
        chain_l_1_squared) + chain_m_2_times_chain_l_2_squared).add_product(p.chain_m_3,
        chain_l_1_squared) + chain_m_3_times_chain_l_2_squared + chain_m_3_times_chain_l_3_squared)
        .add_product(t5, cos_chain_th_1_minus_chain_a_2).add_product(t8,
        cos_chain_th_1_minus_chain_a_2).add_product(t9, cos_chain_th_1_minus_chain_a_3) + t11);
    let t20 = t16 * t19;
    let t21 = t18 * t19;
    let t22 = R::literal(1.0) / t15.sub_product(t20, t16);
    let t23 = (chain_m_3_times_chain_l_3 * (p.chain_l_3 + t17)).sub_product(t21, t16);
    let t24 = t23 * t22;
    let t25 = t9 * chain_w_1;
    let t26 = t10 * chain_w_1 * chain_w_3 * sin_chain_a_2_minus_chain_a_3;
    let t27 = t10 * chain_w_2 * chain_w_3 * sin_chain_a_2_minus_chain_a_3;
    let chain_w_2_squared = chain_w_2 * chain_w_2;
    let chain_m_2_times_chain_l_2 = p.chain_m_2 * p.chain_l_2;
    let t28 = chain_m_2_times_chain_l_2 * p.chain_gravity * sin_chain_a_2;
    let chain_w_3_squared = chain_w_3 * chain_w_3;
    let chain_m_3_times_chain_l_2 = p.chain_m_3 * p.chain_l_2;
    let t29 = chain_m_3_times_chain_l_2 * p.chain_l_3 * chain_w_3_squared
        * sin_chain_a_2_minus_chain_a_3;
    let t30 = chain_m_3_times_chain_l_2 * p.chain_gravity * sin_chain_a_2;
    let t31 = chain_m_3_times_chain_l_3 * p.chain_gravity * sin_chain_a_3;
    let t32 = ((((t5 * chain_w_1 * chain_w_2 * sin_chain_th_1_minus_chain_a_2).add_product(t8
        * chain_w_1 * chain_w_2, sin_chain_th_1_minus_chain_a_2).add_product(t25 * chain_w_2,
        sin_chain_th_1_minus_chain_a_3).add_product(t25 * chain_w_3,
        sin_chain_th_1_minus_chain_a_3) + t26).add_product(t9 * chain_w_2 * chain_w_3,
        sin_chain_th_1_minus_chain_a_3) + t27).add_product(p.chain_m_1 * p.chain_gravity, chain_x_1)
        .add_product(t12 * chain_w_2_squared, sin_chain_th_1_minus_chain_a_2) + t28)
        .add_product(p.chain_m_2 * p.chain_gravity, chain_x_1).add_product(t13 * chain_w_2_squared,
        sin_chain_th_1_minus_chain_a_2);
    let t33 = (t32.add_product(t14 * chain_w_2_squared, sin_chain_th_1_minus_chain_a_3)
        .add_product(t14 * chain_w_3_squared, sin_chain_th_1_minus_chain_a_3) + t29 + t30 + t31)
        .add_product(p.chain_m_3 * p.chain_gravity, chain_x_1);
    let chain_w_1_squared = chain_w_1 * chain_w_1;
    let t34 = R::literal(2.0) * p.chain_l_2;
    let t35 = (-(((t26 + t27).add_product(t12 * chain_w_1_squared, sin_chain_th_2) + t28)
        .add_product(t13 * chain_w_1_squared, sin_chain_th_2).add_product(t14 * chain_w_1_squared,
        sin_chain_th_2_plus_chain_th_3) + t29 + t30 + t31)).add_product(t20, t33);
    let chain_w_3_dot = (chain_m_3_times_chain_l_3 * (-(p.chain_l_1 * chain_w_1_squared
        * sin_chain_th_2_plus_chain_th_3)).add_product(t34 * chain_w_1 * chain_w_2,
        sin_chain_a_2_minus_chain_a_3).add_product(p.chain_l_2 * chain_w_1_squared,
        sin_chain_a_2_minus_chain_a_3).add_product(p.chain_l_2 * chain_w_2_squared,
        sin_chain_a_2_minus_chain_a_3).sub_product(p.chain_gravity, sin_chain_a_3))
        .add_product(t21, t33).sub_product(t24, t35) * (R::literal(1.0)
        / chain_m_3_times_chain_l_3_squared.sub_product(t21, t18).sub_product(t24, t23));
    let chain_w_2_dot = (t35 * t22).sub_product(t24, chain_w_3_dot);
    let t36 = R::literal(2.0) * p.chain_l_3;
    let t37 = R::literal(0.5) * p.chain_m_2;
    let t38 = R::literal(0.5) * p.chain_m_3;
    let t39 = R::literal(2.0) * chain_vx_3;
    let t40 = t34 * chain_s_2;
    let t41 = R::literal(2.0) * chain_vy_3;
    let t42 = chain_l_2_times_sin_chain_a_2 + chain_l_3_times_sin_chain_a_3;
    let t43 = (p.chain_gravity * (p.chain_m_1 * chain_x_1).add_product(p.chain_m_2, chain_x_2)
        .add_product(p.chain_m_3, chain_x_3) * chain_w_1)
        .add_product((t37 * (t40 * chain_vy_2 * cos_chain_a_2).sub_product(t40 * chain_vx_2,
        sin_chain_a_2)).add_product(t38, (t41 * (t1 + t3)).sub_product(t39, t2 + t4))
        .add_product(p.chain_gravity, (chain_m_2_times_chain_l_2 * sin_chain_a_2)
        .add_product(p.chain_m_3, t42)), chain_w_2);
    let t44 = t36 * chain_s_3;
    let t45 = (R::literal(0.5) * p.chain_m_1 * (R::literal(2.0) * chain_x_1 * chain_vy_1)
        .add_product(R::literal(2.0) * chain_l_1_times_cos_chain_th_1, chain_vx_1))
        .add_product(t37, (R::literal(2.0) * chain_x_2 * chain_vy_2).add_product(R::literal(2.0)
        * t0, chain_vx_2)).add_product(t38, (R::literal(2.0) * chain_x_3 * chain_vy_3)
        .add_product(R::literal(2.0) * (t0 + chain_l_3_times_cos_chain_a_3), chain_vx_3));
    let t46 = t43.add_product(t31.add_product(t38, (t44 * chain_vy_3 * cos_chain_a_3)
        .sub_product(t44 * chain_vx_3, sin_chain_a_3)), chain_w_3).sub_product(t45, (t33 * t19)
        .add_product(t20, chain_w_2_dot).add_product(t21, chain_w_3_dot))
        .add_product((t37 * (t34 * chain_vx_2 * cos_chain_a_2).add_product(t34 * chain_vy_2,
        sin_chain_a_2)).add_product(t38, (t39 * (chain_l_2_times_cos_chain_a_2
        + chain_l_3_times_cos_chain_a_3)).add_product(t41, t42)), chain_w_2_dot);
    PowerBalance {
        stored_rate: t46.add_product(t38 * (t36 * chain_vx_3 * cos_chain_a_3).add_product(t36
            * chain_vy_3, sin_chain_a_3), chain_w_3_dot),
        supplied: R::literal(0.0),
        dissipated: R::literal(0.0),
    }
}

/// Normalized Taylor coefficients of the solution through `state`, order after order.
///
/// `_k` marks the coefficient of order k, `_before` that of order k - 1; bare names are
/// zeroth coefficients. The workspace is as `series_workspace` says.
///
/// 211 recurrences. 54 sums of products an order.
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
    let (mut lanes_7, workspace) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let (mut lanes_8, workspace) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let (mut lanes_9, workspace) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let (mut lanes_10, workspace) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let (mut lanes_11, workspace) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let (mut lanes_12, workspace) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let (mut lanes_13, _) = Lanes::<R, 2>::new(workspace, coefficients.len());
    let [chain_th_1, chain_th_2, chain_th_3, chain_w_1, chain_w_2, chain_w_3] = *state;
    let chain_a_2 = chain_th_1 + chain_th_2;
    let chain_a_3 = chain_th_3 + chain_a_2;
    let t0 = chain_th_1 - chain_a_2;
    let t1 = t0.sin();
    let t2 = t0.cos();
    let t3 = R::literal(2.0) * p.chain_m_2;
    let t4 = t3 * p.chain_l_1;
    let t5 = t4 * p.chain_l_2;
    let t6 = t2 * t5;
    let t7 = R::literal(2.0) * p.chain_m_3;
    let t8 = t7 * p.chain_l_1;
    let t9 = t8 * p.chain_l_2;
    let t10 = t2 * t9;
    let t11 = chain_th_1 - chain_a_3;
    let t12 = t11.sin();
    let t13 = t11.cos();
    let t14 = t8 * p.chain_l_3;
    let t15 = t13 * t14;
    let t16 = chain_a_2 - chain_a_3;
    let t17 = t16.sin();
    let t18 = t16.cos();
    let t19 = t7 * p.chain_l_2;
    let t20 = t19 * p.chain_l_3;
    let t21 = t18 * t20;
    let t22 = p.chain_l_1 * p.chain_l_1;
    let t23 = p.chain_m_1 * t22;
    let t24 = p.chain_m_2 * t22;
    let t25 = p.chain_l_2 * p.chain_l_2;
    let t26 = p.chain_m_2 * t25;
    let t27 = p.chain_m_3 * t22;
    let t28 = p.chain_m_3 * t25;
    let t29 = p.chain_l_3 * p.chain_l_3;
    let t30 = p.chain_m_3 * t29;
    let t31 = t23 + t24;
    let t32 = t31 + t26;
    let t33 = t32 + t27;
    let t34 = t33 + t28;
    let t35 = t34 + t30;
    let t36 = t35 + t6;
    let t37 = t36 + t10;
    let t38 = t37 + t15;
    let t39 = t38 + t21;
    let t40 = p.chain_m_2 * p.chain_l_1;
    let t41 = t40 * p.chain_l_2;
    let t42 = t2 * t41;
    let t43 = p.chain_m_3 * p.chain_l_1;
    let t44 = t43 * p.chain_l_2;
    let t45 = t2 * t44;
    let t46 = t43 * p.chain_l_3;
    let t47 = t13 * t46;
    let t48 = t26 + t28;
    let t49 = t48 + t30;
    let t50 = t49 + t21;
    let t51 = t50 + t42;
    let t52 = t51 + t45;
    let t53 = t52 + t47;
    let t54 = t13 * p.chain_l_1;
    let t55 = t18 * p.chain_l_2;
    let t56 = p.chain_l_3 + t54;
    let t57 = t56 + t55;
    let t58 = p.chain_m_3 * p.chain_l_3;
    let t59 = t57 * t58;
    let t60 = p.chain_l_3 + t55;
    let t61 = t60 * t58;
    let sin_chain_th_1 = chain_th_1.sin();
    let cos_chain_th_1 = chain_th_1.cos();
    let sin_chain_a_2 = chain_a_2.sin();
    let cos_chain_a_2 = chain_a_2.cos();
    let sin_chain_a_3 = chain_a_3.sin();
    let cos_chain_a_3 = chain_a_3.cos();
    let t62 = chain_w_1 * t9;
    let t63 = t62 * chain_w_2;
    let t64 = t63 * t1;
    let t65 = chain_w_1 * t14;
    let t66 = t65 * chain_w_2;
    let t67 = t66 * t12;
    let t68 = t65 * chain_w_3;
    let t69 = t68 * t12;
    let t70 = chain_w_1 * t20;
    let t71 = t70 * chain_w_3;
    let t72 = t71 * t17;
    let t73 = chain_w_2 * t14;
    let t74 = t73 * chain_w_3;
    let t75 = t74 * t12;
    let t76 = chain_w_2 * t20;
    let t77 = t76 * chain_w_3;
    let t78 = t77 * t17;
    let t79 = p.chain_m_1 * p.chain_gravity;
    let t80 = p.chain_l_1 * t79;
    let t81 = sin_chain_th_1 * t80;
    let t82 = chain_w_2 * chain_w_2;
    let t83 = t82 * t41;
    let t84 = t83 * t1;
    let t85 = p.chain_m_2 * p.chain_l_2;
    let t86 = t85 * p.chain_gravity;
    let t87 = sin_chain_a_2 * t86;
    let t88 = p.chain_m_2 * p.chain_gravity;
    let t89 = p.chain_l_1 * t88;
    let t90 = sin_chain_th_1 * t89;
    let t91 = t82 * t44;
    let t92 = t91 * t1;
    let t93 = t82 * t46;
    let t94 = t93 * t12;
    let t95 = chain_w_3 * chain_w_3;
    let t96 = t95 * t46;
    let t97 = t96 * t12;
    let t98 = p.chain_m_3 * p.chain_l_2;
    let t99 = t98 * p.chain_l_3;
    let t100 = t95 * t99;
    let t101 = t100 * t17;
    let t102 = t98 * p.chain_gravity;
    let t103 = sin_chain_a_2 * t102;
    let t104 = t58 * p.chain_gravity;
    let t105 = sin_chain_a_3 * t104;
    let t106 = p.chain_m_3 * p.chain_gravity;
    let t107 = p.chain_l_1 * t106;
    let t108 = sin_chain_th_1 * t107;
    let t109 = R::literal(-2.0) * p.chain_m_2;
    let t110 = t109 * p.chain_l_1;
    let t111 = t110 * p.chain_l_2;
    let t112 = chain_w_1 * t111;
    let t113 = t112 * chain_w_2;
    let t114 = t113 * t1;
    let t115 = t114 - t64;
    let t116 = t115 - t67;
    let t117 = t116 - t69;
    let t118 = t117 - t72;
    let t119 = t118 - t75;
    let t120 = t119 - t78;
    let t121 = t120 - t81;
    let t122 = t121 - t84;
    let t123 = t122 - t87;
    let t124 = t123 - t90;
    let t125 = t124 - t92;
    let t126 = t125 - t94;
    let t127 = t126 - t97;
    let t128 = t127 - t101;
    let t129 = t128 - t103;
    let t130 = t129 - t105;
    let t131 = t130 - t108;
    let t132 = chain_w_1 * chain_w_1;
    let sin_chain_th_2 = chain_th_2.sin();
    let cos_chain_th_2 = chain_th_2.cos();
    let t133 = t132 * t41;
    let t134 = t133 * sin_chain_th_2;
    let t135 = t132 * t44;
    let t136 = t135 * sin_chain_th_2;
    let t137 = chain_th_2 + chain_th_3;
    let t138 = t137.sin();
    let t139 = t137.cos();
    let t140 = t132 * t46;
    let t141 = t140 * t138;
    let t142 = t72 + t78;
    let t143 = t142 + t134;
    let t144 = t143 + t87;
    let t145 = t144 + t136;
    let t146 = t145 + t141;
    let t147 = t146 + t101;
    let t148 = t147 + t103;
    let t149 = t148 + t105;
    let t150 = -t149;
    let t151 = R::literal(2.0) * p.chain_l_2;
    let t152 = chain_w_1 * t151;
    let t153 = t152 * chain_w_2;
    let t154 = t153 * t17;
    let t155 = t132 * p.chain_l_1;
    let t156 = t155 * t138;
    let t157 = t132 * p.chain_l_2;
    let t158 = t157 * t17;
    let t159 = t82 * p.chain_l_2;
    let t160 = t159 * t17;
    let t161 = sin_chain_a_3 * p.chain_gravity;
    let t162 = t154 - t156;
    let t163 = t162 + t158;
    let t164 = t163 + t160;
    let t165 = t164 - t161;
    let t166 = t165 * t58;
    let factored = Factored::new([[t39, R::literal(0.0), R::literal(0.0)],
        [t53, t50, R::literal(0.0)], [t59, t61, t30]]);
    let [chain_w_1_dot, chain_w_2_dot, chain_w_3_dot] = factored.solve([t131, t150, t166]);
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
        let sums_8 = lanes_8.sums(order);
        let sums_9 = lanes_9.sums(order);
        let sums_10 = lanes_10.sums(order);
        let sums_11 = lanes_11.sums(order);
        let sums_12 = lanes_12.sums(order);
        let sums_13 = lanes_13.sums(order);
        let chain_a_2_k = chain_th_1_k + chain_th_2_k;
        let chain_a_3_k = chain_th_3_k + chain_a_2_k;
        let t0_k = chain_th_1_k - chain_a_2_k;
        let t1_k = t0_k.mul_add(t2, inverse * sums_5[3]);
        let t2_k = -t0_k.mul_add(t1, inverse * sums_6[0]);
        let t11_k = chain_th_1_k - chain_a_3_k;
        let t12_k = t11_k.mul_add(t13, inverse * sums_7[3]);
        let t13_k = -t11_k.mul_add(t12, inverse * sums_8[0]);
        let t16_k = chain_a_2_k - chain_a_3_k;
        let t17_k = t16_k.mul_add(t18, inverse * sums_8[1]);
        let t18_k = -t16_k.mul_add(t17, inverse * sums_8[2]);
        let t21_k = t18_k * t20;
        let t37_k = t2_k.mul_add(t9, t2_k * t5);
        let t38_k = t13_k.mul_add(t14, t37_k);
        let t39_k = t38_k + t21_k;
        let t51_k = t2_k.mul_add(t41, t21_k);
        let t52_k = t2_k.mul_add(t44, t51_k);
        let t53_k = t13_k.mul_add(t46, t52_k);
        let t55_k = t18_k * p.chain_l_2;
        let t57_k = t13_k * p.chain_l_1 + t55_k;
        let t59_k = t57_k * t58;
        let t61_k = t55_k * t58;
        let sin_chain_th_1_k = chain_th_1_k.mul_add(cos_chain_th_1, inverse * sums[3]);
        let cos_chain_th_1_k = -chain_th_1_k.mul_add(sin_chain_th_1, inverse * sums_1[0]);
        let sin_chain_a_2_k = chain_a_2_k.mul_add(cos_chain_a_2, inverse * sums_3[3]);
        let cos_chain_a_2_k = -chain_a_2_k.mul_add(sin_chain_a_2, inverse * sums_4[0]);
        let sin_chain_a_3_k = chain_a_3_k.mul_add(cos_chain_a_3, inverse * sums_6[1]);
        let cos_chain_a_3_k = -chain_a_3_k.mul_add(sin_chain_a_3, inverse * sums_6[2]);
        let t62_k = chain_w_1_k * t9;
        let t63_k = chain_w_2.mul_add(t62_k, t62.mul_add(chain_w_2_k, sums_1[1]));
        let t64_k = t63.mul_add(t1_k, t1.mul_add(t63_k, sums_6[3]));
        let t65_k = chain_w_1_k * t14;
        let t66_k = chain_w_2.mul_add(t65_k, t65.mul_add(chain_w_2_k, sums_1[2]));
        let t67_k = t66.mul_add(t12_k, t12.mul_add(t66_k, sums_8[3]));
        let t68_k = chain_w_3.mul_add(t65_k, t65.mul_add(chain_w_3_k, sums_1[3]));
        let t69_k = t68.mul_add(t12_k, t12.mul_add(t68_k, sums_9[0]));
        let t70_k = chain_w_1_k * t20;
        let t71_k = chain_w_3.mul_add(t70_k, t70.mul_add(chain_w_3_k, sums_2[0]));
        let t72_k = t71.mul_add(t17_k, t17.mul_add(t71_k, sums_9[1]));
        let t73_k = chain_w_2_k * t14;
        let t74_k = chain_w_3.mul_add(t73_k, t73.mul_add(chain_w_3_k, sums_2[1]));
        let t75_k = t74.mul_add(t12_k, t12.mul_add(t74_k, sums_9[2]));
        let t76_k = chain_w_2_k * t20;
        let t77_k = chain_w_3.mul_add(t76_k, t76.mul_add(chain_w_3_k, sums_2[2]));
        let t78_k = t77.mul_add(t17_k, t17.mul_add(t77_k, sums_9[3]));
        let t82_k = (chain_w_2 + chain_w_2).mul_add(chain_w_2_k, sums[0]);
        let t83_k = t82_k * t41;
        let t84_k = t83.mul_add(t1_k, t1.mul_add(t83_k, sums_7[0]));
        let t87_k = sin_chain_a_2_k * t86;
        let t91_k = t82_k * t44;
        let t92_k = t91.mul_add(t1_k, t1.mul_add(t91_k, sums_7[1]));
        let t93_k = t82_k * t46;
        let t94_k = t93.mul_add(t12_k, t12.mul_add(t93_k, sums_10[0]));
        let t95_k = (chain_w_3 + chain_w_3).mul_add(chain_w_3_k, sums[1]);
        let t96_k = t95_k * t46;
        let t97_k = t96.mul_add(t12_k, t12.mul_add(t96_k, sums_10[1]));
        let t100_k = t95_k * t99;
        let t101_k = t100.mul_add(t17_k, t17.mul_add(t100_k, sums_10[2]));
        let t103_k = sin_chain_a_2_k * t102;
        let t105_k = sin_chain_a_3_k * t104;
        let t112_k = chain_w_1_k * t111;
        let t113_k = chain_w_2.mul_add(t112_k, t112.mul_add(chain_w_2_k, sums_2[3]));
        let t114_k = t113.mul_add(t1_k, t1.mul_add(t113_k, sums_7[2]));
        let t115_k = t114_k - t64_k;
        let t116_k = t115_k - t67_k;
        let t117_k = t116_k - t69_k;
        let t118_k = t117_k - t72_k;
        let t119_k = t118_k - t75_k;
        let t120_k = t119_k - t78_k;
        let t121_k = (-sin_chain_th_1_k).mul_add(t80, t120_k);
        let t122_k = t121_k - t84_k;
        let t123_k = t122_k - t87_k;
        let t124_k = (-sin_chain_th_1_k).mul_add(t89, t123_k);
        let t125_k = t124_k - t92_k;
        let t126_k = t125_k - t94_k;
        let t127_k = t126_k - t97_k;
        let t128_k = t127_k - t101_k;
        let t129_k = t128_k - t103_k;
        let t130_k = t129_k - t105_k;
        let t131_k = (-sin_chain_th_1_k).mul_add(t107, t130_k);
        let t132_k = (chain_w_1 + chain_w_1).mul_add(chain_w_1_k, sums[2]);
        let sin_chain_th_2_k = chain_th_2_k.mul_add(cos_chain_th_2, inverse * sums_3[0]);
        let cos_chain_th_2_k = -chain_th_2_k.mul_add(sin_chain_th_2, inverse * sums_3[1]);
        let t133_k = t132_k * t41;
        let t134_k = sin_chain_th_2.mul_add(t133_k, t133.mul_add(sin_chain_th_2_k, sums_4[1]));
        let t135_k = t132_k * t44;
        let t136_k = sin_chain_th_2.mul_add(t135_k, t135.mul_add(sin_chain_th_2_k, sums_4[2]));
        let t137_k = chain_th_2_k + chain_th_3_k;
        let t138_k = t137_k.mul_add(t139, inverse * sums_4[3]);
        let t139_k = -t137_k.mul_add(t138, inverse * sums_5[0]);
        let t140_k = t132_k * t46;
        let t141_k = t140.mul_add(t138_k, t138.mul_add(t140_k, sums_5[1]));
        let t142_k = t72_k + t78_k;
        let t143_k = t142_k + t134_k;
        let t144_k = t143_k + t87_k;
        let t145_k = t144_k + t136_k;
        let t146_k = t145_k + t141_k;
        let t147_k = t146_k + t101_k;
        let t148_k = t147_k + t103_k;
        let t149_k = t148_k + t105_k;
        let t150_k = -t149_k;
        let t152_k = chain_w_1_k * t151;
        let t153_k = chain_w_2.mul_add(t152_k, t152.mul_add(chain_w_2_k, sums_3[2]));
        let t154_k = t153.mul_add(t17_k, t17.mul_add(t153_k, sums_10[3]));
        let t155_k = t132_k * p.chain_l_1;
        let t156_k = t155.mul_add(t138_k, t138.mul_add(t155_k, sums_5[2]));
        let t157_k = t132_k * p.chain_l_2;
        let t158_k = t157.mul_add(t17_k, t17.mul_add(t157_k, sums_11[0]));
        let t159_k = t82_k * p.chain_l_2;
        let t160_k = t159.mul_add(t17_k, t17.mul_add(t159_k, sums_11[1]));
        let t162_k = t154_k - t156_k;
        let t163_k = t162_k + t158_k;
        let t164_k = t163_k + t160_k;
        let t165_k = (-sin_chain_a_3_k).mul_add(p.chain_gravity, t164_k);
        let n195_k = t39_k.mul_add(chain_w_1_dot, sums_11[2]);
        let n196_k = t53_k.mul_add(chain_w_2_dot, sums_11[3]);
        let n197_k = t59_k.mul_add(chain_w_3_dot, sums_12[0]);
        let n198_k = t53_k.mul_add(chain_w_1_dot, sums_12[1]);
        let n199_k = t21_k.mul_add(chain_w_2_dot, sums_12[2]);
        let n200_k = t61_k.mul_add(chain_w_3_dot, sums_12[3]);
        let n201_k = t59_k.mul_add(chain_w_1_dot, sums_13[0]);
        let n202_k = t61_k.mul_add(chain_w_2_dot, sums_13[1]);
        let n203_k = n196_k + n197_k;
        let n204_k = n195_k + n203_k;
        let t131_k_2 = t131_k - n204_k;
        let n206_k = n199_k + n200_k;
        let n207_k = n198_k + n206_k;
        let t150_k_2 = t150_k - n207_k;
        let n209_k = n201_k + n202_k;
        let t166_k = t165_k.mul_add(t58, -n209_k);
        let [chain_w_1_dot_k, chain_w_2_dot_k, chain_w_3_dot_k] = factored
            .solve([t131_k_2, t150_k_2, t166_k]);
        lanes.set(order, [chain_w_2_k, chain_w_3_k, chain_w_1_k, k * chain_th_1_k], [chain_w_2_k,
            chain_w_3_k, chain_w_1_k, cos_chain_th_1_k]);
        lanes_1.set(order, [k * chain_th_1_k, chain_w_2_k, chain_w_2_k, chain_w_3_k],
            [sin_chain_th_1_k, t62_k, t65_k, t65_k]);
        lanes_2.set(order, [chain_w_3_k, chain_w_3_k, chain_w_3_k, chain_w_2_k], [t70_k, t73_k,
            t76_k, t112_k]);
        lanes_3.set(order, [k * chain_th_2_k, k * chain_th_2_k, chain_w_2_k, k * chain_a_2_k],
            [cos_chain_th_2_k, sin_chain_th_2_k, t152_k, cos_chain_a_2_k]);
        lanes_4.set(order, [k * chain_a_2_k, sin_chain_th_2_k, sin_chain_th_2_k, k * t137_k],
            [sin_chain_a_2_k, t133_k, t135_k, t139_k]);
        lanes_5.set(order, [k * t137_k, t138_k, t138_k, k * t0_k], [t138_k, t140_k, t155_k, t2_k]);
        lanes_6.set(order, [k * t0_k, k * chain_a_3_k, k * chain_a_3_k, t1_k],
            [t1_k, cos_chain_a_3_k, sin_chain_a_3_k, t63_k]);
        lanes_7.set(order, [t1_k, t1_k, t1_k, k * t11_k], [t83_k, t91_k, t113_k, t13_k]);
        lanes_8.set(order, [k * t11_k, k * t16_k, k * t16_k, t12_k], [t12_k, t18_k, t17_k, t66_k]);
        lanes_9.set(order, [t12_k, t17_k, t12_k, t17_k], [t68_k, t71_k, t74_k, t77_k]);
        lanes_10.set(order, [t12_k, t12_k, t17_k, t17_k], [t93_k, t96_k, t100_k, t153_k]);
        lanes_11.set(order, [t17_k, t17_k, t39_k, t53_k], [t157_k, t159_k, chain_w_1_dot_k,
            chain_w_2_dot_k]);
        lanes_12.set(order, [t59_k, t53_k, t21_k, t61_k], [chain_w_3_dot_k, chain_w_1_dot_k,
            chain_w_2_dot_k, chain_w_3_dot_k]);
        lanes_13.set(order, [t59_k, t61_k], [chain_w_1_dot_k, chain_w_2_dot_k]);
        rates = [chain_w_1_k, chain_w_2_k, chain_w_3_k, chain_w_1_dot_k, chain_w_2_dot_k,
            chain_w_3_dot_k];
    }
}

// Emitted by Machinist 0.1.0; do not edit. To make it again:
//
//     cargo run --release -- gen
//
// Sources, with SHA-256:
//   3e8c074867e50b1a29307f459226517360a97cbb3c8b87485ac9876919b35852  bench/m6_5.toml
//
// Benchmark M6: planar pendulum of 5 links
//
// Point masses on 5 massless links, angles from the downward vertical, released horizontal and at
// rest.
//
// Source:
//   Benchmark models of textile-machine dynamics.
//
// All quantities are in SI units.
// Shapes: coordinates 5, states 10, outputs 10.
// Nonzeros: mass_matrix 25 of 5 by 5, rate_jacobian 55 of 10 by 10, parameter_jacobian 0 of 10 by 0.
// Operations: rate 234, mass_matrix 26, forcing 84, rate_jacobian 816, energy 57, power_balance 396.

use ::machinist_contract::{
    Energy, PowerBalance, Real, taylor::{Factored, Lanes, order_and_inverse},
};

::machinist_contract::simulator! {
    /// Benchmark M6: planar pendulum of 5 links
    ///
    /// Point masses on 5 massless links, angles from the downward vertical, released horizontal and at
    /// rest.
    ///
    /// Source: Benchmark models of textile-machine dynamics.
    M65: "m6_5", "Benchmark M6: planar pendulum of 5 links";
    run from 0.0, until 5.0, points 501, rtol 1e-8, method "auto";
    quadratures 0, discontinuities 0;
    series 75;
}

::machinist_contract::parameters! {}

::machinist_contract::outputs! {
    theta_1: "rad", "theta_1", "angle of link 1 from the vertical";
    theta_2: "rad", "theta_2", "angle of link 2 from the vertical";
    theta_3: "rad", "theta_3", "angle of link 3 from the vertical";
    theta_4: "rad", "theta_4", "angle of link 4 from the vertical";
    theta_5: "rad", "theta_5", "angle of link 5 from the vertical";
    omega_1: "rad/s", "omega_1", "rate of angle of link 1 from the vertical";
    omega_2: "rad/s", "omega_2", "rate of angle of link 2 from the vertical";
    omega_3: "rad/s", "omega_3", "rate of angle of link 3 from the vertical";
    omega_4: "rad/s", "omega_4", "rate of angle of link 4 from the vertical";
    omega_5: "rad/s", "omega_5", "rate of angle of link 5 from the vertical";
}

::machinist_contract::states! {
    CHAIN_THETA_1: position, 1.0, "rad", "chain.theta_1", "angle of link 1 from the vertical";
    CHAIN_THETA_2: position, 1.0, "rad", "chain.theta_2", "angle of link 2 from the vertical";
    CHAIN_THETA_3: position, 1.0, "rad", "chain.theta_3", "angle of link 3 from the vertical";
    CHAIN_THETA_4: position, 1.0, "rad", "chain.theta_4", "angle of link 4 from the vertical";
    CHAIN_THETA_5: position, 1.0, "rad", "chain.theta_5", "angle of link 5 from the vertical";
    CHAIN_OMEGA_1: velocity, 5.0, "rad/s", "chain.omega_1", "rate of angle of link 1 from the vertical";
    CHAIN_OMEGA_2: velocity, 5.0, "rad/s", "chain.omega_2", "rate of angle of link 2 from the vertical";
    CHAIN_OMEGA_3: velocity, 5.0, "rad/s", "chain.omega_3", "rate of angle of link 3 from the vertical";
    CHAIN_OMEGA_4: velocity, 5.0, "rad/s", "chain.omega_4", "rate of angle of link 4 from the vertical";
    CHAIN_OMEGA_5: velocity, 5.0, "rad/s", "chain.omega_5", "rate of angle of link 5 from the vertical";
}

::machinist_contract::patterns! {
    /// Nonzeros of M.
    MASS_MATRIX_PATTERN: 5 by 5 { 0 [0 1 2 3 4] 1 [0 1 2 3 4] 2 [0 1 2 3 4] 3 [0 1 2 3 4]
        4 [0 1 2 3 4] }
    /// Nonzeros of dy'/dy.
    RATE_JACOBIAN_PATTERN: 10 by 10 { 0 [5] 1 [6] 2 [7] 3 [8] 4 [9] 5 [0 1 2 3 4 5 6 7 8 9]
        6 [0 1 2 3 4 5 6 7 8 9] 7 [0 1 2 3 4 5 6 7 8 9] 8 [0 1 2 3 4 5 6 7 8 9]
        9 [0 1 2 3 4 5 6 7 8 9] }
    /// Nonzeros of dy'/dp.
    PARAMETER_JACOBIAN_PATTERN: 10 by 0 {  }
}

/// State at the start of the run, in the units of the states. No operations.
#[must_use]
pub fn initial_state<R: Real>(_p: &Parameters<R>) -> [R; STATES] {
    [R::literal(core::f64::consts::FRAC_PI_2), R::literal(core::f64::consts::FRAC_PI_2),
        R::literal(core::f64::consts::FRAC_PI_2), R::literal(core::f64::consts::FRAC_PI_2),
        R::literal(core::f64::consts::FRAC_PI_2), R::literal(0.0), R::literal(0.0),
        R::literal(0.0), R::literal(0.0), R::literal(0.0)]
}

/// Times of known jumps of the right-hand side \[s\], unsorted. No operations.
#[must_use]
pub fn discontinuities<R: Real>(_p: &Parameters<R>) -> [R; DISCONTINUITIES] {
    []
}

/// `y'`: velocities, `q''` of `M q'' = f + G^T lambda`, `h`; in the units of the states per second.
/// 234 operations.
#[must_use]
#[inline]
pub fn rate<R: Real>(_time: R, state: &[R; STATES], _p: &Parameters<R>) -> [R; STATES] {
    let [chain_theta_1, chain_theta_2, chain_theta_3, chain_theta_4, chain_theta_5, chain_omega_1,
        chain_omega_2, chain_omega_3, chain_omega_4, chain_omega_5] = *state;
    let [(sin_chain_theta_1, cos_chain_theta_1), (sin_chain_theta_2, cos_chain_theta_2),
        (sin_chain_theta_3, cos_chain_theta_3), (sin_chain_theta_4, cos_chain_theta_4),
        (sin_chain_theta_5, cos_chain_theta_5)] = R::sin_cos_each([chain_theta_1, chain_theta_2,
        chain_theta_3, chain_theta_4, chain_theta_5]);
    let t0 = (sin_chain_theta_1 * cos_chain_theta_2).sub_product(cos_chain_theta_1,
        sin_chain_theta_2);
    let t1 = (cos_chain_theta_1 * cos_chain_theta_2).add_product(sin_chain_theta_1,
        sin_chain_theta_2);
    let t2 = R::literal(4.0) * t1;
    let t3 = (sin_chain_theta_1 * cos_chain_theta_3).sub_product(cos_chain_theta_1,
        sin_chain_theta_3);
    let t4 = (cos_chain_theta_1 * cos_chain_theta_3).add_product(sin_chain_theta_1,
        sin_chain_theta_3);
    let t5 = R::literal(3.0) * t4;
    let t6 = (sin_chain_theta_1 * cos_chain_theta_4).sub_product(cos_chain_theta_1,
        sin_chain_theta_4);
    let t7 = (cos_chain_theta_1 * cos_chain_theta_4).add_product(sin_chain_theta_1,
        sin_chain_theta_4);
    let t8 = R::literal(2.0) * t7;
    let t9 = (sin_chain_theta_1 * cos_chain_theta_5).sub_product(cos_chain_theta_1,
        sin_chain_theta_5);
    let t10 = (cos_chain_theta_1 * cos_chain_theta_5).add_product(sin_chain_theta_1,
        sin_chain_theta_5);
    let t11 = (sin_chain_theta_2 * cos_chain_theta_3).sub_product(cos_chain_theta_2,
        sin_chain_theta_3);
    let t12 = (sin_chain_theta_2 * cos_chain_theta_4).sub_product(cos_chain_theta_2,
        sin_chain_theta_4);
    let t13 = (sin_chain_theta_2 * cos_chain_theta_5).sub_product(cos_chain_theta_2,
        sin_chain_theta_5);
    let t14 = (sin_chain_theta_3 * cos_chain_theta_4).sub_product(cos_chain_theta_3,
        sin_chain_theta_4);
    let t15 = (sin_chain_theta_3 * cos_chain_theta_5).sub_product(cos_chain_theta_3,
        sin_chain_theta_5);
    let t16 = (sin_chain_theta_4 * cos_chain_theta_5).sub_product(cos_chain_theta_4,
        sin_chain_theta_5);
    let t17 = R::literal(0.8) * t1;
    let t18 = R::literal(0.600_000_000_000_000_1) * t4;
    let t19 = R::literal(0.4) * t7;
    let t20 = t10 * R::literal(0.2);
    let t21 = R::literal(1.0) / R::literal(4.0).sub_product(t17, t2);
    let t22 = (R::literal(3.0) * (cos_chain_theta_2 * cos_chain_theta_3)
        .add_product(sin_chain_theta_2, sin_chain_theta_3)).sub_product(t18, t2);
    let t23 = t22 * t21;
    let t24 = (R::literal(2.0) * (cos_chain_theta_2 * cos_chain_theta_4)
        .add_product(sin_chain_theta_2, sin_chain_theta_4)).sub_product(t19, t2);
    let t25 = t24 * t21;
    let t26 = (cos_chain_theta_2 * cos_chain_theta_5).add_product(sin_chain_theta_2,
        sin_chain_theta_5).sub_product(t20, t2);
    let t27 = t26 * t21;
    let t28 = R::literal(1.0) / R::literal(3.0).sub_product(t18, t5).sub_product(t23, t22);
    let t29 = (R::literal(2.0) * (cos_chain_theta_3 * cos_chain_theta_4)
        .add_product(sin_chain_theta_3, sin_chain_theta_4)).sub_product(t19, t5).sub_product(t25,
        t22);
    let t30 = t29 * t28;
    let t31 = (cos_chain_theta_3 * cos_chain_theta_5).add_product(sin_chain_theta_3,
        sin_chain_theta_5).sub_product(t20, t5).sub_product(t27, t22);
    let t32 = t31 * t28;
    let t33 = R::literal(1.0) / R::literal(2.0).sub_product(t19, t8).sub_product(t25, t24)
        .sub_product(t30, t29);
    let t34 = (cos_chain_theta_4 * cos_chain_theta_5).add_product(sin_chain_theta_4,
        sin_chain_theta_5).sub_product(t20, t8).sub_product(t27, t24).sub_product(t32, t29);
    let t35 = t34 * t33;
    let chain_omega_2_squared = chain_omega_2 * chain_omega_2;
    let chain_omega_3_squared = chain_omega_3 * chain_omega_3;
    let t36 = R::literal(3.0) * chain_omega_3_squared;
    let chain_omega_4_squared = chain_omega_4 * chain_omega_4;
    let t37 = R::literal(2.0) * chain_omega_4_squared;
    let chain_omega_5_squared = chain_omega_5 * chain_omega_5;
    let t38 = (R::literal(49.05) * sin_chain_theta_1).add_product(R::literal(4.0)
        * chain_omega_2_squared, t0).add_product(t36, t3).add_product(t37, t6)
        .add_product(chain_omega_5_squared, t9);
    let chain_omega_1_squared = chain_omega_1 * chain_omega_1;
    let t39 = (R::literal(-39.24) * sin_chain_theta_2).add_product(R::literal(4.0)
        * chain_omega_1_squared, t0).sub_product(t36, t11).sub_product(t37, t12)
        .sub_product(chain_omega_5_squared, t13).add_product(t17, t38);
    let t40 = (R::literal(3.0) * chain_omega_1_squared * t3).add_product(R::literal(3.0)
        * chain_omega_2_squared, t11).sub_product(R::literal(29.43), sin_chain_theta_3)
        .sub_product(t37, t14).sub_product(chain_omega_5_squared, t15).add_product(t18, t38)
        .sub_product(t23, t39);
    let t41 = (R::literal(2.0) * chain_omega_1_squared * t6).add_product(R::literal(2.0)
        * chain_omega_2_squared, t12).add_product(R::literal(2.0) * chain_omega_3_squared, t14)
        .sub_product(R::literal(19.62), sin_chain_theta_4).sub_product(chain_omega_5_squared, t16)
        .add_product(t19, t38).sub_product(t25, t39).sub_product(t30, t40);
    let chain_omega_5_dot = (chain_omega_1_squared * t9).add_product(chain_omega_2_squared, t13)
        .add_product(chain_omega_3_squared, t15).add_product(chain_omega_4_squared, t16)
        .sub_product(R::literal(9.81), sin_chain_theta_5).add_product(t20, t38).sub_product(t27,
        t39).sub_product(t32, t40).sub_product(t35, t41) * (R::literal(1.0) / R::literal(1.0)
        .sub_product(t20, t10).sub_product(t27, t26).sub_product(t32, t31).sub_product(t35, t34));
    let chain_omega_4_dot = (t41 * t33).sub_product(t35, chain_omega_5_dot);
    let chain_omega_3_dot = (t40 * t28).sub_product(t30, chain_omega_4_dot).sub_product(t32,
        chain_omega_5_dot);
    let chain_omega_2_dot = (t39 * t21).sub_product(t23, chain_omega_3_dot).sub_product(t25,
        chain_omega_4_dot).sub_product(t27, chain_omega_5_dot);
    let chain_omega_1_dot = (t38 * R::literal(-0.2)).sub_product(t17, chain_omega_2_dot)
        .sub_product(t18, chain_omega_3_dot).sub_product(t19, chain_omega_4_dot).sub_product(t20,
        chain_omega_5_dot);
    [chain_omega_1, chain_omega_2, chain_omega_3, chain_omega_4, chain_omega_5, chain_omega_1_dot,
        chain_omega_2_dot, chain_omega_3_dot, chain_omega_4_dot, chain_omega_5_dot]
}

/// `M = d2L/dq'2`, values in the order of its pattern. 26 operations.
#[must_use]
pub fn mass_matrix<R: Real>(_time: R, state: &[R; STATES], _p: &Parameters<R>) -> [R; 25] {
    let [chain_theta_1, chain_theta_2, chain_theta_3, chain_theta_4, chain_theta_5, ..] = *state;
    let [(_, t0), (_, t1), (_, t2), (_, t3), (_, t4), (_, t5), (_, t6), (_, t7), (_, t8), (_, t9)]
        = R::sin_cos_each([chain_theta_1 - chain_theta_2, chain_theta_1 - chain_theta_3,
        chain_theta_1 - chain_theta_4, chain_theta_1 - chain_theta_5,
        chain_theta_2 - chain_theta_3, chain_theta_2 - chain_theta_4,
        chain_theta_2 - chain_theta_5, chain_theta_3 - chain_theta_4,
        chain_theta_3 - chain_theta_5, chain_theta_4 - chain_theta_5]);
    let t10 = R::literal(4.0) * t0;
    let t11 = R::literal(3.0) * t1;
    let t12 = R::literal(2.0) * t2;
    let t13 = R::literal(3.0) * t4;
    let t14 = R::literal(2.0) * t5;
    let t15 = R::literal(2.0) * t7;
    [R::literal(5.0), t10, t11, t12, t3, t10, R::literal(4.0), t13, t14, t6, t11, t13,
        R::literal(3.0), t15, t8, t12, t14, t15, R::literal(2.0), t9, t3, t6, t8, t9,
        R::literal(1.0)]
}

/// `f` of `M q'' = f + G^T lambda`, one for each coordinate. 84 operations.
#[must_use]
pub fn forcing<R: Real>(_time: R, state: &[R; STATES], _p: &Parameters<R>) -> [R; COORDINATES] {
    let [chain_theta_1, chain_theta_2, chain_theta_3, chain_theta_4, chain_theta_5, chain_omega_1,
        chain_omega_2, chain_omega_3, chain_omega_4, chain_omega_5] = *state;
    let [(sin_chain_theta_1, _), (sin_chain_theta_2, _), (sin_chain_theta_3, _),
        (sin_chain_theta_4, _), (sin_chain_theta_5, _), (t0, _), (t1, _), (t2, _), (t3, _),
        (t4, _), (t5, _), (t6, _), (t7, _), (t8, _), (t9, _)] = R::sin_cos_each([chain_theta_1,
        chain_theta_2, chain_theta_3, chain_theta_4, chain_theta_5, chain_theta_1 - chain_theta_2,
        chain_theta_1 - chain_theta_3, chain_theta_1 - chain_theta_4,
        chain_theta_1 - chain_theta_5, chain_theta_2 - chain_theta_3,
        chain_theta_2 - chain_theta_4, chain_theta_2 - chain_theta_5,
        chain_theta_3 - chain_theta_4, chain_theta_3 - chain_theta_5,
        chain_theta_4 - chain_theta_5]);
    let chain_omega_2_squared = chain_omega_2 * chain_omega_2;
    let chain_omega_3_squared = chain_omega_3 * chain_omega_3;
    let t10 = R::literal(3.0) * chain_omega_3_squared;
    let chain_omega_4_squared = chain_omega_4 * chain_omega_4;
    let t11 = R::literal(2.0) * chain_omega_4_squared;
    let chain_omega_5_squared = chain_omega_5 * chain_omega_5;
    let chain_theta_1_forcing = (R::literal(-49.05) * sin_chain_theta_1)
        .sub_product(R::literal(4.0) * chain_omega_2_squared, t0).sub_product(t10, t1)
        .sub_product(t11, t2).sub_product(chain_omega_5_squared, t3);
    let chain_omega_1_squared = chain_omega_1 * chain_omega_1;
    let chain_theta_2_forcing = (R::literal(-39.24) * sin_chain_theta_2)
        .add_product(R::literal(4.0) * chain_omega_1_squared, t0).sub_product(t10, t4)
        .sub_product(t11, t5).sub_product(chain_omega_5_squared, t6);
    let chain_theta_3_forcing = (R::literal(3.0) * chain_omega_1_squared * t1)
        .add_product(R::literal(3.0) * chain_omega_2_squared, t4).sub_product(R::literal(29.43),
        sin_chain_theta_3).sub_product(t11, t7).sub_product(chain_omega_5_squared, t8);
    let chain_theta_4_forcing = (R::literal(2.0) * chain_omega_1_squared * t2)
        .add_product(R::literal(2.0) * chain_omega_2_squared, t5).add_product(R::literal(2.0)
        * chain_omega_3_squared, t7).sub_product(R::literal(19.62), sin_chain_theta_4)
        .sub_product(chain_omega_5_squared, t9);
    let chain_theta_5_forcing = (chain_omega_1_squared * t3).add_product(chain_omega_2_squared, t6)
        .add_product(chain_omega_3_squared, t8).add_product(chain_omega_4_squared, t9)
        .sub_product(R::literal(9.81), sin_chain_theta_5);
    [chain_theta_1_forcing, chain_theta_2_forcing, chain_theta_3_forcing, chain_theta_4_forcing,
        chain_theta_5_forcing]
}

/// `dy'/dy`, values in the order of its pattern. 816 operations.
#[must_use]
pub fn rate_jacobian<R: Real>(_time: R, state: &[R; STATES], _p: &Parameters<R>) -> [R; 55] {
    let [chain_theta_1, chain_theta_2, chain_theta_3, chain_theta_4, chain_theta_5, chain_omega_1,
        chain_omega_2, chain_omega_3, chain_omega_4, chain_omega_5] = *state;
    let [(sin_chain_theta_1, cos_chain_theta_1), (sin_chain_theta_2, cos_chain_theta_2),
        (sin_chain_theta_3, cos_chain_theta_3), (sin_chain_theta_4, cos_chain_theta_4),
        (sin_chain_theta_5, cos_chain_theta_5)] = R::sin_cos_each([chain_theta_1, chain_theta_2,
        chain_theta_3, chain_theta_4, chain_theta_5]);
    let t0 = (sin_chain_theta_1 * cos_chain_theta_2).sub_product(cos_chain_theta_1,
        sin_chain_theta_2);
    let t1 = (cos_chain_theta_1 * cos_chain_theta_2).add_product(sin_chain_theta_1,
        sin_chain_theta_2);
    let t2 = R::literal(4.0) * t1;
    let t3 = (sin_chain_theta_1 * cos_chain_theta_3).sub_product(cos_chain_theta_1,
        sin_chain_theta_3);
    let t4 = (cos_chain_theta_1 * cos_chain_theta_3).add_product(sin_chain_theta_1,
        sin_chain_theta_3);
    let t5 = R::literal(3.0) * t4;
    let t6 = (sin_chain_theta_1 * cos_chain_theta_4).sub_product(cos_chain_theta_1,
        sin_chain_theta_4);
    let t7 = (cos_chain_theta_1 * cos_chain_theta_4).add_product(sin_chain_theta_1,
        sin_chain_theta_4);
    let t8 = R::literal(2.0) * t7;
    let t9 = (sin_chain_theta_1 * cos_chain_theta_5).sub_product(cos_chain_theta_1,
        sin_chain_theta_5);
    let t10 = (cos_chain_theta_1 * cos_chain_theta_5).add_product(sin_chain_theta_1,
        sin_chain_theta_5);
    let t11 = (sin_chain_theta_2 * cos_chain_theta_3).sub_product(cos_chain_theta_2,
        sin_chain_theta_3);
    let t12 = (cos_chain_theta_2 * cos_chain_theta_3).add_product(sin_chain_theta_2,
        sin_chain_theta_3);
    let t13 = (sin_chain_theta_2 * cos_chain_theta_4).sub_product(cos_chain_theta_2,
        sin_chain_theta_4);
    let t14 = (cos_chain_theta_2 * cos_chain_theta_4).add_product(sin_chain_theta_2,
        sin_chain_theta_4);
    let t15 = (sin_chain_theta_2 * cos_chain_theta_5).sub_product(cos_chain_theta_2,
        sin_chain_theta_5);
    let t16 = (cos_chain_theta_2 * cos_chain_theta_5).add_product(sin_chain_theta_2,
        sin_chain_theta_5);
    let t17 = (sin_chain_theta_3 * cos_chain_theta_4).sub_product(cos_chain_theta_3,
        sin_chain_theta_4);
    let t18 = (cos_chain_theta_3 * cos_chain_theta_4).add_product(sin_chain_theta_3,
        sin_chain_theta_4);
    let t19 = (sin_chain_theta_3 * cos_chain_theta_5).sub_product(cos_chain_theta_3,
        sin_chain_theta_5);
    let t20 = (cos_chain_theta_3 * cos_chain_theta_5).add_product(sin_chain_theta_3,
        sin_chain_theta_5);
    let t21 = (sin_chain_theta_4 * cos_chain_theta_5).sub_product(cos_chain_theta_4,
        sin_chain_theta_5);
    let t22 = (cos_chain_theta_4 * cos_chain_theta_5).add_product(sin_chain_theta_4,
        sin_chain_theta_5);
    let t23 = R::literal(0.8) * t1;
    let t24 = R::literal(0.600_000_000_000_000_1) * t4;
    let t25 = R::literal(0.4) * t7;
    let t26 = t10 * R::literal(0.2);
    let t27 = R::literal(1.0) / R::literal(4.0).sub_product(t23, t2);
    let t28 = (R::literal(3.0) * t12).sub_product(t24, t2);
    let t29 = t28 * t27;
    let t30 = (R::literal(2.0) * t14).sub_product(t25, t2);
    let t31 = t30 * t27;
    let t32 = t16.sub_product(t26, t2);
    let t33 = t32 * t27;
    let t34 = R::literal(1.0) / R::literal(3.0).sub_product(t24, t5).sub_product(t29, t28);
    let t35 = (R::literal(2.0) * t18).sub_product(t25, t5).sub_product(t31, t28);
    let t36 = t35 * t34;
    let t37 = t20.sub_product(t26, t5).sub_product(t33, t28);
    let t38 = t37 * t34;
    let t39 = R::literal(1.0) / R::literal(2.0).sub_product(t25, t8).sub_product(t31, t30)
        .sub_product(t36, t35);
    let t40 = t22.sub_product(t26, t8).sub_product(t33, t30).sub_product(t38, t35);
    let t41 = t40 * t39;
    let t42 = R::literal(1.0) / R::literal(1.0).sub_product(t26, t10).sub_product(t33, t32)
        .sub_product(t38, t37).sub_product(t41, t40);
    let chain_omega_2_squared = chain_omega_2 * chain_omega_2;
    let t43 = R::literal(4.0) * chain_omega_2_squared;
    let chain_omega_3_squared = chain_omega_3 * chain_omega_3;
    let t44 = R::literal(3.0) * chain_omega_3_squared;
    let chain_omega_4_squared = chain_omega_4 * chain_omega_4;
    let t45 = R::literal(2.0) * chain_omega_4_squared;
    let chain_omega_5_squared = chain_omega_5 * chain_omega_5;
    let t46 = (R::literal(49.05) * sin_chain_theta_1).add_product(t43, t0).add_product(t44, t3)
        .add_product(t45, t6).add_product(chain_omega_5_squared, t9);
    let chain_omega_1_squared = chain_omega_1 * chain_omega_1;
    let t47 = R::literal(4.0) * chain_omega_1_squared;
    let t48 = R::literal(3.0) * chain_omega_1_squared;
    let t49 = R::literal(3.0) * chain_omega_2_squared;
    let t50 = R::literal(2.0) * chain_omega_1_squared;
    let t51 = R::literal(2.0) * chain_omega_2_squared;
    let t52 = R::literal(2.0) * chain_omega_3_squared;
    let t53 = (R::literal(-39.24) * sin_chain_theta_2).add_product(t47, t0).sub_product(t44, t11)
        .sub_product(t45, t13).sub_product(chain_omega_5_squared, t15).add_product(t23, t46);
    let t54 = (t48 * t3).add_product(t49, t11).sub_product(R::literal(29.43), sin_chain_theta_3)
        .sub_product(t45, t17).sub_product(chain_omega_5_squared, t19).add_product(t24, t46)
        .sub_product(t29, t53);
    let t55 = (t50 * t6).add_product(t51, t13).add_product(t52, t17).sub_product(R::literal(19.62),
        sin_chain_theta_4).sub_product(chain_omega_5_squared, t21).add_product(t25, t46)
        .sub_product(t31, t53).sub_product(t36, t54);
    let chain_omega_5_dot = (chain_omega_1_squared * t9).add_product(chain_omega_2_squared, t15)
        .add_product(chain_omega_3_squared, t19).add_product(chain_omega_4_squared, t21)
        .sub_product(R::literal(9.81), sin_chain_theta_5).add_product(t26, t46).sub_product(t33,
        t53).sub_product(t38, t54).sub_product(t41, t55) * t42;
    let chain_omega_4_dot = (t55 * t39).sub_product(t41, chain_omega_5_dot);
    let chain_omega_3_dot = (t54 * t34).sub_product(t36, chain_omega_4_dot).sub_product(t38,
        chain_omega_5_dot);
    let chain_omega_2_dot = (t53 * t27).sub_product(t29, chain_omega_3_dot).sub_product(t31,
        chain_omega_4_dot).sub_product(t33, chain_omega_5_dot);
    let t56 = (t46 * R::literal(0.2)).add_product(t23, chain_omega_2_dot).add_product(t24,
        chain_omega_3_dot).add_product(t25, chain_omega_4_dot).add_product(t26, chain_omega_5_dot);
    let t57 = t43 * t1;
    let t58 = t44 * t4;
    let t59 = t45 * t7;
    let t60 = chain_omega_5_squared * t10;
    let t61 = t47 * t1;
    let t62 = t48 * t4;
    let t63 = t50 * t7;
    let t64 = chain_omega_1_squared * t10;
    let t65 = R::literal(4.0) * t0;
    let t66 = t65 * chain_omega_2_dot;
    let t67 = t65 * t56;
    let t68 = R::literal(3.0) * t3;
    let t69 = t68 * chain_omega_3_dot;
    let t70 = t68 * t56;
    let t71 = R::literal(2.0) * t6;
    let t72 = t71 * chain_omega_4_dot;
    let t73 = t71 * t56;
    let t74 = t9 * chain_omega_5_dot;
    let t75 = t66 - (t57.add_product(R::literal(49.05), cos_chain_theta_1) + t58 + t59 + t60) + t69
        + t72 + t74;
    let t76 = t9 * t56;
    let t77 = (t61 - t67).sub_product(t23, t75);
    let t78 = (t62 - t70).sub_product(t24, t75).sub_product(t29, t77);
    let t79 = (t63 - t73).sub_product(t25, t75).sub_product(t31, t77).sub_product(t36, t78);
    let chain_omega_5_dot_by_chain_theta_1 = (t64 - t76).sub_product(t26, t75).sub_product(t33, t77)
        .sub_product(t38, t78).sub_product(t41, t79) * t42;
    let chain_omega_4_dot_by_chain_theta_1 = (t79 * t39).sub_product(t41,
        chain_omega_5_dot_by_chain_theta_1);
    let chain_omega_3_dot_by_chain_theta_1 = (t78 * t34).sub_product(t36,
        chain_omega_4_dot_by_chain_theta_1).sub_product(t38, chain_omega_5_dot_by_chain_theta_1);
    let chain_omega_2_dot_by_chain_theta_1 = (t77 * t27).sub_product(t29,
        chain_omega_3_dot_by_chain_theta_1).sub_product(t31, chain_omega_4_dot_by_chain_theta_1)
        .sub_product(t33, chain_omega_5_dot_by_chain_theta_1);
    let chain_omega_1_dot_by_chain_theta_1 = (t75 * R::literal(0.2)).sub_product(t23,
        chain_omega_2_dot_by_chain_theta_1).sub_product(t24, chain_omega_3_dot_by_chain_theta_1)
        .sub_product(t25, chain_omega_4_dot_by_chain_theta_1).sub_product(t26,
        chain_omega_5_dot_by_chain_theta_1);
    let t80 = t44 * t12;
    let t81 = t45 * t14;
    let t82 = chain_omega_5_squared * t16;
    let t83 = t49 * t12;
    let t84 = t51 * t14;
    let t85 = chain_omega_2_squared * t16;
    let t86 = t57 - t66;
    let t87 = R::literal(3.0) * t11;
    let t88 = t87 * chain_omega_3_dot;
    let t89 = t87 * chain_omega_2_dot;
    let t90 = R::literal(2.0) * t13;
    let t91 = t90 * chain_omega_4_dot;
    let t92 = t90 * chain_omega_2_dot;
    let t93 = t15 * chain_omega_5_dot;
    let t94 = t15 * chain_omega_2_dot;
    let t95 = (t67 - (t61.add_product(R::literal(39.24), cos_chain_theta_2) + t80 + t81 + t82)
        + t88 + t91 + t93).sub_product(t23, t86);
    let t96 = (t83 + t89).sub_product(t24, t86).sub_product(t29, t95);
    let t97 = (t84 + t92).sub_product(t25, t86).sub_product(t31, t95).sub_product(t36, t96);
    let chain_omega_5_dot_by_chain_theta_2 = (t85 + t94).sub_product(t26, t86).sub_product(t33, t95)
        .sub_product(t38, t96).sub_product(t41, t97) * t42;
    let chain_omega_4_dot_by_chain_theta_2 = (t97 * t39).sub_product(t41,
        chain_omega_5_dot_by_chain_theta_2);
    let chain_omega_3_dot_by_chain_theta_2 = (t96 * t34).sub_product(t36,
        chain_omega_4_dot_by_chain_theta_2).sub_product(t38, chain_omega_5_dot_by_chain_theta_2);
    let chain_omega_2_dot_by_chain_theta_2 = (t95 * t27).sub_product(t29,
        chain_omega_3_dot_by_chain_theta_2).sub_product(t31, chain_omega_4_dot_by_chain_theta_2)
        .sub_product(t33, chain_omega_5_dot_by_chain_theta_2);
    let chain_omega_1_dot_by_chain_theta_2 = (t86 * R::literal(0.2)).sub_product(t23,
        chain_omega_2_dot_by_chain_theta_2).sub_product(t24, chain_omega_3_dot_by_chain_theta_2)
        .sub_product(t25, chain_omega_4_dot_by_chain_theta_2).sub_product(t26,
        chain_omega_5_dot_by_chain_theta_2);
    let t98 = t45 * t18;
    let t99 = chain_omega_5_squared * t20;
    let t100 = t52 * t18;
    let t101 = chain_omega_3_squared * t20;
    let t102 = t58 - t69;
    let t103 = R::literal(2.0) * t17;
    let t104 = t103 * chain_omega_4_dot;
    let t105 = t103 * chain_omega_3_dot;
    let t106 = t19 * chain_omega_5_dot;
    let t107 = t19 * chain_omega_3_dot;
    let t108 = (t80 - t88).sub_product(t23, t102);
    let t109 = (t70 - (t62.add_product(R::literal(29.43), cos_chain_theta_3) + t83 + t98 + t99)
        - t89 + t104 + t106).sub_product(t24, t102).sub_product(t29, t108);
    let t110 = (t100 + t105).sub_product(t25, t102).sub_product(t31, t108).sub_product(t36, t109);
    let chain_omega_5_dot_by_chain_theta_3 = (t101 + t107).sub_product(t26, t102).sub_product(t33,
        t108).sub_product(t38, t109).sub_product(t41, t110) * t42;
    let chain_omega_4_dot_by_chain_theta_3 = (t110 * t39).sub_product(t41,
        chain_omega_5_dot_by_chain_theta_3);
    let chain_omega_3_dot_by_chain_theta_3 = (t109 * t34).sub_product(t36,
        chain_omega_4_dot_by_chain_theta_3).sub_product(t38, chain_omega_5_dot_by_chain_theta_3);
    let chain_omega_2_dot_by_chain_theta_3 = (t108 * t27).sub_product(t29,
        chain_omega_3_dot_by_chain_theta_3).sub_product(t31, chain_omega_4_dot_by_chain_theta_3)
        .sub_product(t33, chain_omega_5_dot_by_chain_theta_3);
    let chain_omega_1_dot_by_chain_theta_3 = (t102 * R::literal(0.2)).sub_product(t23,
        chain_omega_2_dot_by_chain_theta_3).sub_product(t24, chain_omega_3_dot_by_chain_theta_3)
        .sub_product(t25, chain_omega_4_dot_by_chain_theta_3).sub_product(t26,
        chain_omega_5_dot_by_chain_theta_3);
    let t111 = chain_omega_5_squared * t22;
    let t112 = chain_omega_4_squared * t22;
    let t113 = t59 - t72;
    let t114 = t21 * chain_omega_5_dot;
    let t115 = t21 * chain_omega_4_dot;
    let t116 = (t81 - t91).sub_product(t23, t113);
    let t117 = (t98 - t104).sub_product(t24, t113).sub_product(t29, t116);
    let t118 = (t73 - (t63.add_product(R::literal(19.62), cos_chain_theta_4) + t84 + t100 + t111)
        - t92 - t105 + t114).sub_product(t25, t113).sub_product(t31, t116).sub_product(t36, t117);
    let chain_omega_5_dot_by_chain_theta_4 = (t112 + t115).sub_product(t26, t113).sub_product(t33,
        t116).sub_product(t38, t117).sub_product(t41, t118) * t42;
    let chain_omega_4_dot_by_chain_theta_4 = (t118 * t39).sub_product(t41,
        chain_omega_5_dot_by_chain_theta_4);
    let chain_omega_3_dot_by_chain_theta_4 = (t117 * t34).sub_product(t36,
        chain_omega_4_dot_by_chain_theta_4).sub_product(t38, chain_omega_5_dot_by_chain_theta_4);
    let chain_omega_2_dot_by_chain_theta_4 = (t116 * t27).sub_product(t29,
        chain_omega_3_dot_by_chain_theta_4).sub_product(t31, chain_omega_4_dot_by_chain_theta_4)
        .sub_product(t33, chain_omega_5_dot_by_chain_theta_4);
    let chain_omega_1_dot_by_chain_theta_4 = (t113 * R::literal(0.2)).sub_product(t23,
        chain_omega_2_dot_by_chain_theta_4).sub_product(t24, chain_omega_3_dot_by_chain_theta_4)
        .sub_product(t25, chain_omega_4_dot_by_chain_theta_4).sub_product(t26,
        chain_omega_5_dot_by_chain_theta_4);
    let t119 = t60 - t74;
    let t120 = (t82 - t93).sub_product(t23, t119);
    let t121 = (t99 - t106).sub_product(t24, t119).sub_product(t29, t120);
    let t122 = (t111 - t114).sub_product(t25, t119).sub_product(t31, t120).sub_product(t36, t121);
    let chain_omega_5_dot_by_chain_theta_5 = (t76 - (t64.add_product(R::literal(9.81),
        cos_chain_theta_5) + t85 + t101 + t112) - t94 - t107 - t115).sub_product(t26, t119)
        .sub_product(t33, t120).sub_product(t38, t121).sub_product(t41, t122) * t42;
    let chain_omega_4_dot_by_chain_theta_5 = (t122 * t39).sub_product(t41,
        chain_omega_5_dot_by_chain_theta_5);
    let chain_omega_3_dot_by_chain_theta_5 = (t121 * t34).sub_product(t36,
        chain_omega_4_dot_by_chain_theta_5).sub_product(t38, chain_omega_5_dot_by_chain_theta_5);
    let chain_omega_2_dot_by_chain_theta_5 = (t120 * t27).sub_product(t29,
        chain_omega_3_dot_by_chain_theta_5).sub_product(t31, chain_omega_4_dot_by_chain_theta_5)
        .sub_product(t33, chain_omega_5_dot_by_chain_theta_5);
    let chain_omega_1_dot_by_chain_theta_5 = (t119 * R::literal(0.2)).sub_product(t23,
        chain_omega_2_dot_by_chain_theta_5).sub_product(t24, chain_omega_3_dot_by_chain_theta_5)
        .sub_product(t25, chain_omega_4_dot_by_chain_theta_5).sub_product(t26,
        chain_omega_5_dot_by_chain_theta_5);
    let t123 = R::literal(8.0) * chain_omega_1 * t0;
    let t124 = (R::literal(6.0) * chain_omega_1 * t3).sub_product(t29, t123);
    let t125 = (R::literal(4.0) * chain_omega_1 * t6).sub_product(t31, t123).sub_product(t36, t124);
    let chain_omega_5_dot_by_chain_omega_1 = (R::literal(2.0) * chain_omega_1 * t9)
        .sub_product(t33, t123).sub_product(t38, t124).sub_product(t41, t125) * t42;
    let chain_omega_4_dot_by_chain_omega_1 = (t125 * t39).sub_product(t41,
        chain_omega_5_dot_by_chain_omega_1);
    let chain_omega_3_dot_by_chain_omega_1 = (t124 * t34).sub_product(t36,
        chain_omega_4_dot_by_chain_omega_1).sub_product(t38, chain_omega_5_dot_by_chain_omega_1);
    let chain_omega_2_dot_by_chain_omega_1 = (t123 * t27).sub_product(t29,
        chain_omega_3_dot_by_chain_omega_1).sub_product(t31, chain_omega_4_dot_by_chain_omega_1)
        .sub_product(t33, chain_omega_5_dot_by_chain_omega_1);
    let chain_omega_1_dot_by_chain_omega_1 = -(t24 * chain_omega_3_dot_by_chain_omega_1)
        .add_product(t23, chain_omega_2_dot_by_chain_omega_1).add_product(t25,
        chain_omega_4_dot_by_chain_omega_1).add_product(t26, chain_omega_5_dot_by_chain_omega_1);
    let t126 = R::literal(8.0) * chain_omega_2 * t0;
    let t127 = t23 * t126;
    let t128 = (R::literal(6.0) * chain_omega_2 * t11).add_product(t24, t126).sub_product(t29,
        t127);
    let t129 = (R::literal(4.0) * chain_omega_2 * t13).add_product(t25, t126).sub_product(t31, t127)
        .sub_product(t36, t128);
    let chain_omega_5_dot_by_chain_omega_2 = (R::literal(2.0) * chain_omega_2 * t15)
        .add_product(t26, t126).sub_product(t33, t127).sub_product(t38, t128).sub_product(t41,
        t129) * t42;
    let chain_omega_4_dot_by_chain_omega_2 = (t129 * t39).sub_product(t41,
        chain_omega_5_dot_by_chain_omega_2);
    let chain_omega_3_dot_by_chain_omega_2 = (t128 * t34).sub_product(t36,
        chain_omega_4_dot_by_chain_omega_2).sub_product(t38, chain_omega_5_dot_by_chain_omega_2);
    let chain_omega_2_dot_by_chain_omega_2 = (t127 * t27).sub_product(t29,
        chain_omega_3_dot_by_chain_omega_2).sub_product(t31, chain_omega_4_dot_by_chain_omega_2)
        .sub_product(t33, chain_omega_5_dot_by_chain_omega_2);
    let chain_omega_1_dot_by_chain_omega_2 = (t126 * R::literal(-0.2)).sub_product(t23,
        chain_omega_2_dot_by_chain_omega_2).sub_product(t24, chain_omega_3_dot_by_chain_omega_2)
        .sub_product(t25, chain_omega_4_dot_by_chain_omega_2).sub_product(t26,
        chain_omega_5_dot_by_chain_omega_2);
    let t130 = R::literal(6.0) * chain_omega_3;
    let t131 = t130 * t3;
    let t132 = (-(t130 * t11)).add_product(t23, t131);
    let t133 = (t24 * t131).sub_product(t29, t132);
    let t134 = (R::literal(4.0) * chain_omega_3 * t17).add_product(t25, t131).sub_product(t31, t132)
        .sub_product(t36, t133);
    let chain_omega_5_dot_by_chain_omega_3 = (R::literal(2.0) * chain_omega_3 * t19)
        .add_product(t26, t131).sub_product(t33, t132).sub_product(t38, t133).sub_product(t41,
        t134) * t42;
    let chain_omega_4_dot_by_chain_omega_3 = (t134 * t39).sub_product(t41,
        chain_omega_5_dot_by_chain_omega_3);
    let chain_omega_3_dot_by_chain_omega_3 = (t133 * t34).sub_product(t36,
        chain_omega_4_dot_by_chain_omega_3).sub_product(t38, chain_omega_5_dot_by_chain_omega_3);
    let chain_omega_2_dot_by_chain_omega_3 = (t132 * t27).sub_product(t29,
        chain_omega_3_dot_by_chain_omega_3).sub_product(t31, chain_omega_4_dot_by_chain_omega_3)
        .sub_product(t33, chain_omega_5_dot_by_chain_omega_3);
    let chain_omega_1_dot_by_chain_omega_3 = (t131 * R::literal(-0.2)).sub_product(t23,
        chain_omega_2_dot_by_chain_omega_3).sub_product(t24, chain_omega_3_dot_by_chain_omega_3)
        .sub_product(t25, chain_omega_4_dot_by_chain_omega_3).sub_product(t26,
        chain_omega_5_dot_by_chain_omega_3);
    let t135 = R::literal(4.0) * chain_omega_4;
    let t136 = t135 * t6;
    let t137 = (-(t135 * t13)).add_product(t23, t136);
    let t138 = (-(t135 * t17)).add_product(t24, t136).sub_product(t29, t137);
    let t139 = (t25 * t136).sub_product(t31, t137).sub_product(t36, t138);
    let chain_omega_5_dot_by_chain_omega_4 = (R::literal(2.0) * chain_omega_4 * t21)
        .add_product(t26, t136).sub_product(t33, t137).sub_product(t38, t138).sub_product(t41,
        t139) * t42;
    let chain_omega_4_dot_by_chain_omega_4 = (t139 * t39).sub_product(t41,
        chain_omega_5_dot_by_chain_omega_4);
    let chain_omega_3_dot_by_chain_omega_4 = (t138 * t34).sub_product(t36,
        chain_omega_4_dot_by_chain_omega_4).sub_product(t38, chain_omega_5_dot_by_chain_omega_4);
    let chain_omega_2_dot_by_chain_omega_4 = (t137 * t27).sub_product(t29,
        chain_omega_3_dot_by_chain_omega_4).sub_product(t31, chain_omega_4_dot_by_chain_omega_4)
        .sub_product(t33, chain_omega_5_dot_by_chain_omega_4);
    let chain_omega_1_dot_by_chain_omega_4 = (t136 * R::literal(-0.2)).sub_product(t23,
        chain_omega_2_dot_by_chain_omega_4).sub_product(t24, chain_omega_3_dot_by_chain_omega_4)
        .sub_product(t25, chain_omega_4_dot_by_chain_omega_4).sub_product(t26,
        chain_omega_5_dot_by_chain_omega_4);
    let t140 = R::literal(2.0) * chain_omega_5;
    let t141 = t140 * t9;
    let t142 = (-(t140 * t15)).add_product(t23, t141);
    let t143 = (-(t140 * t19)).add_product(t24, t141).sub_product(t29, t142);
    let t144 = (-(t140 * t21)).add_product(t25, t141).sub_product(t31, t142).sub_product(t36, t143);
    let chain_omega_5_dot_by_chain_omega_5 = (t26 * t141).sub_product(t33, t142).sub_product(t38,
        t143).sub_product(t41, t144) * t42;
    let chain_omega_4_dot_by_chain_omega_5 = (t144 * t39).sub_product(t41,
        chain_omega_5_dot_by_chain_omega_5);
    let chain_omega_3_dot_by_chain_omega_5 = (t143 * t34).sub_product(t36,
        chain_omega_4_dot_by_chain_omega_5).sub_product(t38, chain_omega_5_dot_by_chain_omega_5);
    let chain_omega_2_dot_by_chain_omega_5 = (t142 * t27).sub_product(t29,
        chain_omega_3_dot_by_chain_omega_5).sub_product(t31, chain_omega_4_dot_by_chain_omega_5)
        .sub_product(t33, chain_omega_5_dot_by_chain_omega_5);
    let chain_omega_1_dot_by_chain_omega_5 = (t141 * R::literal(-0.2)).sub_product(t23,
        chain_omega_2_dot_by_chain_omega_5).sub_product(t24, chain_omega_3_dot_by_chain_omega_5)
        .sub_product(t25, chain_omega_4_dot_by_chain_omega_5).sub_product(t26,
        chain_omega_5_dot_by_chain_omega_5);
    [R::literal(1.0), R::literal(1.0), R::literal(1.0), R::literal(1.0), R::literal(1.0),
        chain_omega_1_dot_by_chain_theta_1, chain_omega_1_dot_by_chain_theta_2,
        chain_omega_1_dot_by_chain_theta_3, chain_omega_1_dot_by_chain_theta_4,
        chain_omega_1_dot_by_chain_theta_5, chain_omega_1_dot_by_chain_omega_1,
        chain_omega_1_dot_by_chain_omega_2, chain_omega_1_dot_by_chain_omega_3,
        chain_omega_1_dot_by_chain_omega_4, chain_omega_1_dot_by_chain_omega_5,
        chain_omega_2_dot_by_chain_theta_1, chain_omega_2_dot_by_chain_theta_2,
        chain_omega_2_dot_by_chain_theta_3, chain_omega_2_dot_by_chain_theta_4,
        chain_omega_2_dot_by_chain_theta_5, chain_omega_2_dot_by_chain_omega_1,
        chain_omega_2_dot_by_chain_omega_2, chain_omega_2_dot_by_chain_omega_3,
        chain_omega_2_dot_by_chain_omega_4, chain_omega_2_dot_by_chain_omega_5,
        chain_omega_3_dot_by_chain_theta_1, chain_omega_3_dot_by_chain_theta_2,
        chain_omega_3_dot_by_chain_theta_3, chain_omega_3_dot_by_chain_theta_4,
        chain_omega_3_dot_by_chain_theta_5, chain_omega_3_dot_by_chain_omega_1,
        chain_omega_3_dot_by_chain_omega_2, chain_omega_3_dot_by_chain_omega_3,
        chain_omega_3_dot_by_chain_omega_4, chain_omega_3_dot_by_chain_omega_5,
        chain_omega_4_dot_by_chain_theta_1, chain_omega_4_dot_by_chain_theta_2,
        chain_omega_4_dot_by_chain_theta_3, chain_omega_4_dot_by_chain_theta_4,
        chain_omega_4_dot_by_chain_theta_5, chain_omega_4_dot_by_chain_omega_1,
        chain_omega_4_dot_by_chain_omega_2, chain_omega_4_dot_by_chain_omega_3,
        chain_omega_4_dot_by_chain_omega_4, chain_omega_4_dot_by_chain_omega_5,
        chain_omega_5_dot_by_chain_theta_1, chain_omega_5_dot_by_chain_theta_2,
        chain_omega_5_dot_by_chain_theta_3, chain_omega_5_dot_by_chain_theta_4,
        chain_omega_5_dot_by_chain_theta_5, chain_omega_5_dot_by_chain_omega_1,
        chain_omega_5_dot_by_chain_omega_2, chain_omega_5_dot_by_chain_omega_3,
        chain_omega_5_dot_by_chain_omega_4, chain_omega_5_dot_by_chain_omega_5]
}

/// `dy'/dp`, values in the order of its pattern. No operations.
#[must_use]
pub fn parameter_jacobian<R: Real>(_time: R, _state: &[R; STATES], _p: &Parameters<R>) -> [R; 0] {
    []
}

/// Partial derivative of `y'` with respect to time. No operations.
#[must_use]
pub fn time_derivative<R: Real>(_time: R, _state: &[R; STATES], _p: &Parameters<R>) -> [R; STATES] {
    [R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0),
        R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0)]
}

/// Wanted outputs. No operations.
#[must_use]
pub fn outputs<R: Real>(_time: R, state: &[R; STATES], _p: &Parameters<R>) -> Outputs<R> {
    let [chain_theta_1, chain_theta_2, chain_theta_3, chain_theta_4, chain_theta_5, chain_omega_1,
        chain_omega_2, chain_omega_3, chain_omega_4, chain_omega_5] = *state;
    Outputs {
        theta_1: chain_theta_1,
        theta_2: chain_theta_2,
        theta_3: chain_theta_3,
        theta_4: chain_theta_4,
        theta_5: chain_theta_5,
        omega_1: chain_omega_1,
        omega_2: chain_omega_2,
        omega_3: chain_omega_3,
        omega_4: chain_omega_4,
        omega_5: chain_omega_5,
    }
}

/// T, V and the energy of first-order states \[J\]. 57 operations.
#[must_use]
pub fn energy<R: Real>(_time: R, state: &[R; STATES], _p: &Parameters<R>) -> Energy<R> {
    let [chain_theta_1, chain_theta_2, chain_theta_3, chain_theta_4, chain_theta_5, chain_omega_1,
        chain_omega_2, chain_omega_3, chain_omega_4, chain_omega_5] = *state;
    let [(sin_chain_theta_1, cos_chain_theta_1), (sin_chain_theta_2, cos_chain_theta_2),
        (sin_chain_theta_3, cos_chain_theta_3), (sin_chain_theta_4, cos_chain_theta_4),
        (sin_chain_theta_5, cos_chain_theta_5)] = R::sin_cos_each([chain_theta_1, chain_theta_2,
        chain_theta_3, chain_theta_4, chain_theta_5]);
    let chain_u_1 = chain_omega_1 * cos_chain_theta_1;
    let chain_v_1 = chain_omega_1 * sin_chain_theta_1;
    let chain_u_2 = chain_u_1.add_product(chain_omega_2, cos_chain_theta_2);
    let chain_v_2 = chain_v_1.add_product(chain_omega_2, sin_chain_theta_2);
    let chain_u_3 = chain_u_2.add_product(chain_omega_3, cos_chain_theta_3);
    let chain_v_3 = chain_v_2.add_product(chain_omega_3, sin_chain_theta_3);
    let chain_u_4 = chain_u_3.add_product(chain_omega_4, cos_chain_theta_4);
    let chain_v_4 = chain_v_3.add_product(chain_omega_4, sin_chain_theta_4);
    let chain_u_5 = chain_u_4.add_product(chain_omega_5, cos_chain_theta_5);
    let chain_v_5 = chain_v_4.add_product(chain_omega_5, sin_chain_theta_5);
    Energy {
        kinetic: R::literal(0.5) * (chain_u_1 * chain_u_1).add_product(chain_v_1, chain_v_1)
            .add_product(chain_u_2, chain_u_2).add_product(chain_v_2, chain_v_2)
            .add_product(chain_u_3, chain_u_3).add_product(chain_v_3, chain_v_3)
            .add_product(chain_u_4, chain_u_4).add_product(chain_v_4, chain_v_4)
            .add_product(chain_u_5, chain_u_5).add_product(chain_v_5, chain_v_5),
        potential: R::literal(-9.81) * ((R::literal(5.0) * cos_chain_theta_1)
            .add_product(R::literal(4.0), cos_chain_theta_2).add_product(R::literal(3.0),
            cos_chain_theta_3).add_product(R::literal(2.0), cos_chain_theta_4) + cos_chain_theta_5),
        stored: R::literal(0.0),
    }
}

/// `dE/dt`, power supplied and power dissipated \[W\]. 396 operations.
#[must_use]
pub fn power_balance<R: Real>(_time: R, state: &[R; STATES],
        _p: &Parameters<R>) -> PowerBalance<R> {
    let [chain_theta_1, chain_theta_2, chain_theta_3, chain_theta_4, chain_theta_5, chain_omega_1,
        chain_omega_2, chain_omega_3, chain_omega_4, chain_omega_5] = *state;
    let chain_theta_1_minus_chain_theta_2 = chain_theta_1 - chain_theta_2;
    let chain_theta_1_minus_chain_theta_3 = chain_theta_1 - chain_theta_3;
    let chain_theta_1_minus_chain_theta_4 = chain_theta_1 - chain_theta_4;
    let chain_theta_1_minus_chain_theta_5 = chain_theta_1 - chain_theta_5;
    let chain_theta_2_minus_chain_theta_3 = chain_theta_2 - chain_theta_3;
    let chain_theta_2_minus_chain_theta_4 = chain_theta_2 - chain_theta_4;
    let chain_theta_2_minus_chain_theta_5 = chain_theta_2 - chain_theta_5;
    let chain_theta_3_minus_chain_theta_4 = chain_theta_3 - chain_theta_4;
    let chain_theta_3_minus_chain_theta_5 = chain_theta_3 - chain_theta_5;
    let chain_theta_4_minus_chain_theta_5 = chain_theta_4 - chain_theta_5;
    let [(sin_chain_theta_1, cos_chain_theta_1), (sin_chain_theta_2, cos_chain_theta_2),
        (sin_chain_theta_3, cos_chain_theta_3), (sin_chain_theta_4, cos_chain_theta_4),
        (sin_chain_theta_5, cos_chain_theta_5), (t0, t1), (t2, t3), (t4, t5), (t6, t7), (t8, t9),
        (t10, t11), (t12, t13), (t14, t15), (t16, t17), (t18, t19)]
        = R::sin_cos_each([chain_theta_1, chain_theta_2, chain_theta_3, chain_theta_4,
        chain_theta_5, chain_theta_1_minus_chain_theta_2, chain_theta_1_minus_chain_theta_3,
        chain_theta_1_minus_chain_theta_4, chain_theta_1_minus_chain_theta_5,
        chain_theta_2_minus_chain_theta_3, chain_theta_2_minus_chain_theta_4,
        chain_theta_2_minus_chain_theta_5, chain_theta_3_minus_chain_theta_4,
        chain_theta_3_minus_chain_theta_5, chain_theta_4_minus_chain_theta_5]);
    let chain_u_1 = chain_omega_1 * cos_chain_theta_1;
    let chain_v_1 = chain_omega_1 * sin_chain_theta_1;
    let chain_u_2 = chain_u_1.add_product(chain_omega_2, cos_chain_theta_2);
    let chain_v_2 = chain_v_1.add_product(chain_omega_2, sin_chain_theta_2);
    let chain_u_3 = chain_u_2.add_product(chain_omega_3, cos_chain_theta_3);
    let chain_v_3 = chain_v_2.add_product(chain_omega_3, sin_chain_theta_3);
    let chain_u_4 = chain_u_3.add_product(chain_omega_4, cos_chain_theta_4);
    let chain_v_4 = chain_v_3.add_product(chain_omega_4, sin_chain_theta_4);
    let chain_u_5 = chain_u_4.add_product(chain_omega_5, cos_chain_theta_5);
    let chain_v_5 = chain_v_4.add_product(chain_omega_5, sin_chain_theta_5);
    let t20 = R::literal(4.0) * t1;
    let t21 = R::literal(3.0) * t3;
    let t22 = R::literal(2.0) * t5;
    let t23 = R::literal(0.8) * t1;
    let t24 = R::literal(0.600_000_000_000_000_1) * t3;
    let t25 = R::literal(0.4) * t5;
    let t26 = t7 * R::literal(0.2);
    let t27 = R::literal(1.0) / R::literal(4.0).sub_product(t23, t20);
    let t28 = (R::literal(3.0) * t9).sub_product(t24, t20);
    let t29 = t28 * t27;
    let t30 = (R::literal(2.0) * t11).sub_product(t25, t20);
    let t31 = t30 * t27;
    let t32 = t13.sub_product(t26, t20);
    let t33 = t32 * t27;
    let t34 = R::literal(1.0) / R::literal(3.0).sub_product(t24, t21).sub_product(t29, t28);
    let t35 = (R::literal(2.0) * t15).sub_product(t25, t21).sub_product(t31, t28);
    let t36 = t35 * t34;
    let t37 = t17.sub_product(t26, t21).sub_product(t33, t28);
    let t38 = t37 * t34;
    let t39 = R::literal(1.0) / R::literal(2.0).sub_product(t25, t22).sub_product(t31, t30)
        .sub_product(t36, t35);
    let t40 = t19.sub_product(t26, t22).sub_product(t33, t30).sub_product(t38, t35);
    let t41 = t40 * t39;
    let t42 = R::literal(49.05) * sin_chain_theta_1;
    let chain_omega_2_squared = chain_omega_2 * chain_omega_2;
    let chain_omega_3_squared = chain_omega_3 * chain_omega_3;
    let t43 = R::literal(3.0) * chain_omega_3_squared;
    let chain_omega_4_squared = chain_omega_4 * chain_omega_4;
    let t44 = R::literal(2.0) * chain_omega_4_squared;
    let chain_omega_5_squared = chain_omega_5 * chain_omega_5;
    let t45 = t42.add_product(R::literal(4.0) * chain_omega_2_squared, t0).add_product(t43, t2)
        .add_product(t44, t4).add_product(chain_omega_5_squared, t6);
    let t46 = R::literal(39.24) * sin_chain_theta_2;
    let chain_omega_1_squared = chain_omega_1 * chain_omega_1;
    let t47 = R::literal(29.43) * sin_chain_theta_3;
    let t48 = R::literal(19.62) * sin_chain_theta_4;
    let t49 = R::literal(9.81) * sin_chain_theta_5;
    let t50 = (-t46).add_product(R::literal(4.0) * chain_omega_1_squared, t0).sub_product(t43, t8)
        .sub_product(t44, t10).sub_product(chain_omega_5_squared, t12).add_product(t23, t45);
    let t51 = ((R::literal(3.0) * chain_omega_1_squared * t2).add_product(R::literal(3.0)
        * chain_omega_2_squared, t8) - t47).sub_product(t44, t14)
        .sub_product(chain_omega_5_squared, t16).add_product(t24, t45).sub_product(t29, t50);
    let t52 = ((R::literal(2.0) * chain_omega_1_squared * t4).add_product(R::literal(2.0)
        * chain_omega_2_squared, t10).add_product(R::literal(2.0) * chain_omega_3_squared, t14)
        - t48).sub_product(chain_omega_5_squared, t18).add_product(t25, t45).sub_product(t31, t50)
        .sub_product(t36, t51);
    let chain_omega_5_dot = ((chain_omega_1_squared * t6).add_product(chain_omega_2_squared, t12)
        .add_product(chain_omega_3_squared, t16).add_product(chain_omega_4_squared, t18) - t49)
        .add_product(t26, t45).sub_product(t33, t50).sub_product(t38, t51).sub_product(t41, t52)
        * (R::literal(1.0) / R::literal(1.0).sub_product(t26, t7).sub_product(t33, t32)
        .sub_product(t38, t37).sub_product(t41, t40));
    let chain_omega_4_dot = (t52 * t39).sub_product(t41, chain_omega_5_dot);
    let chain_omega_3_dot = (t51 * t34).sub_product(t36, chain_omega_4_dot).sub_product(t38,
        chain_omega_5_dot);
    let chain_omega_2_dot = (t50 * t27).sub_product(t29, chain_omega_3_dot).sub_product(t31,
        chain_omega_4_dot).sub_product(t33, chain_omega_5_dot);
    let t53 = R::literal(2.0) * chain_omega_2;
    let t54 = R::literal(2.0) * chain_omega_3;
    let t55 = R::literal(2.0) * chain_omega_4;
    let t56 = R::literal(2.0) * chain_omega_5;
    let t57 = R::literal(2.0) * chain_v_1;
    let t58 = R::literal(2.0) * chain_u_1;
    let t59 = t46.add_product(R::literal(0.5), (t53 * chain_v_2 * cos_chain_theta_2)
        .add_product(t53 * chain_v_3, cos_chain_theta_2).add_product(t53 * chain_v_4,
        cos_chain_theta_2).add_product(t53 * chain_v_5, cos_chain_theta_2).sub_product(t53
        * chain_u_2, sin_chain_theta_2).sub_product(t53 * chain_u_3, sin_chain_theta_2)
        .sub_product(t53 * chain_u_4, sin_chain_theta_2).sub_product(t53 * chain_u_5,
        sin_chain_theta_2));
    let t60 = t47.add_product(R::literal(0.5), (t54 * chain_v_3 * cos_chain_theta_3)
        .add_product(t54 * chain_v_4, cos_chain_theta_3).add_product(t54 * chain_v_5,
        cos_chain_theta_3).sub_product(t54 * chain_u_3, sin_chain_theta_3).sub_product(t54
        * chain_u_4, sin_chain_theta_3).sub_product(t54 * chain_u_5, sin_chain_theta_3));
    let t61 = (t42.add_product(R::literal(0.5), (t58 * chain_v_2).add_product(t58, chain_v_3)
        .add_product(t58, chain_v_4).add_product(t58, chain_v_5).sub_product(t57, chain_u_2)
        .sub_product(t57, chain_u_3).sub_product(t57, chain_u_4).sub_product(t57, chain_u_5))
        * chain_omega_1).add_product(t59, chain_omega_2).add_product(t60, chain_omega_3)
        .add_product(t48.add_product(R::literal(0.5), (t55 * chain_v_4 * cos_chain_theta_4)
        .add_product(t55 * chain_v_5, cos_chain_theta_4).sub_product(t55 * chain_u_4,
        sin_chain_theta_4).sub_product(t55 * chain_u_5, sin_chain_theta_4)), chain_omega_4);
    let t62 = R::literal(2.0) * chain_u_2;
    let t63 = R::literal(2.0) * chain_v_2;
    let t64 = R::literal(2.0) * chain_u_3;
    let t65 = R::literal(2.0) * chain_v_3;
    let t66 = R::literal(2.0) * chain_u_4;
    let t67 = R::literal(2.0) * chain_v_4;
    let t68 = R::literal(2.0) * chain_u_5;
    let t69 = R::literal(2.0) * chain_v_5;
    let t70 = t61.add_product(t49.add_product(R::literal(0.5), (t56 * chain_v_5 * cos_chain_theta_5)
        .sub_product(t56 * chain_u_5, sin_chain_theta_5)), chain_omega_5)
        .sub_product(R::literal(0.5) * (t58 * cos_chain_theta_1).add_product(t57, sin_chain_theta_1)
        .add_product(t62, cos_chain_theta_1).add_product(t63, sin_chain_theta_1).add_product(t64,
        cos_chain_theta_1).add_product(t65, sin_chain_theta_1).add_product(t66, cos_chain_theta_1)
        .add_product(t67, sin_chain_theta_1).add_product(t68, cos_chain_theta_1).add_product(t69,
        sin_chain_theta_1), (t45 * R::literal(0.2)).add_product(t23, chain_omega_2_dot)
        .add_product(t24, chain_omega_3_dot).add_product(t25, chain_omega_4_dot).add_product(t26,
        chain_omega_5_dot));
    let t71 = t70.add_product(R::literal(0.5) * (t62 * cos_chain_theta_2).add_product(t63,
        sin_chain_theta_2).add_product(t64, cos_chain_theta_2).add_product(t65, sin_chain_theta_2)
        .add_product(t66, cos_chain_theta_2).add_product(t67, sin_chain_theta_2).add_product(t68,
        cos_chain_theta_2).add_product(t69, sin_chain_theta_2), chain_omega_2_dot)
        .add_product(R::literal(0.5) * (t64 * cos_chain_theta_3).add_product(t65, sin_chain_theta_3)
        .add_product(t66, cos_chain_theta_3).add_product(t67, sin_chain_theta_3).add_product(t68,
        cos_chain_theta_3).add_product(t69, sin_chain_theta_3), chain_omega_3_dot)
        .add_product(R::literal(0.5) * (t66 * cos_chain_theta_4).add_product(t67, sin_chain_theta_4)
        .add_product(t68, cos_chain_theta_4).add_product(t69, sin_chain_theta_4),
        chain_omega_4_dot);
    PowerBalance {
        stored_rate: t71.add_product(R::literal(0.5) * (t68 * cos_chain_theta_5).add_product(t69,
            sin_chain_theta_5), chain_omega_5_dot),
        supplied: R::literal(0.0),
        dissipated: R::literal(0.0),
    }
}

/// Normalized Taylor coefficients of the solution through `state`, order after order.
///
/// `_k` marks the coefficient of order k, `_before` that of order k - 1; bare names are
/// zeroth coefficients. The workspace is as `series_workspace` says.
///
/// 170 recurrences. 75 sums of products an order.
///
/// # Panics
/// If there is no room for the zeroth coefficients, or the workspace is too short.
pub fn series<R: Real>(_time: R, state: &[R; STATES], _p: &Parameters<R>,
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
    let (mut lanes_13, workspace) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let (mut lanes_14, workspace) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let (mut lanes_15, workspace) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let (mut lanes_16, workspace) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let (mut lanes_17, workspace) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let (mut lanes_18, _) = Lanes::<R, 3>::new(workspace, coefficients.len());
    let [chain_theta_1, chain_theta_2, chain_theta_3, chain_theta_4, chain_theta_5, chain_omega_1,
        chain_omega_2, chain_omega_3, chain_omega_4, chain_omega_5] = *state;
    let t0 = chain_theta_1 - chain_theta_2;
    let t1 = t0.sin();
    let t2 = t0.cos();
    let t3 = t2 * R::literal(4.0);
    let t4 = chain_theta_1 - chain_theta_3;
    let t5 = t4.sin();
    let t6 = t4.cos();
    let t7 = t6 * R::literal(3.0);
    let t8 = chain_theta_1 - chain_theta_4;
    let t9 = t8.sin();
    let t10 = t8.cos();
    let t11 = t10 * R::literal(2.0);
    let t12 = chain_theta_1 - chain_theta_5;
    let t13 = t12.sin();
    let t14 = t12.cos();
    let t15 = chain_theta_2 - chain_theta_3;
    let t16 = t15.sin();
    let t17 = t15.cos();
    let t18 = t17 * R::literal(3.0);
    let t19 = chain_theta_2 - chain_theta_4;
    let t20 = t19.sin();
    let t21 = t19.cos();
    let t22 = t21 * R::literal(2.0);
    let t23 = chain_theta_2 - chain_theta_5;
    let t24 = t23.sin();
    let t25 = t23.cos();
    let t26 = chain_theta_3 - chain_theta_4;
    let t27 = t26.sin();
    let t28 = t26.cos();
    let t29 = t28 * R::literal(2.0);
    let t30 = chain_theta_3 - chain_theta_5;
    let t31 = t30.sin();
    let t32 = t30.cos();
    let t33 = chain_theta_4 - chain_theta_5;
    let t34 = t33.sin();
    let t35 = t33.cos();
    let sin_chain_theta_1 = chain_theta_1.sin();
    let cos_chain_theta_1 = chain_theta_1.cos();
    let sin_chain_theta_2 = chain_theta_2.sin();
    let cos_chain_theta_2 = chain_theta_2.cos();
    let sin_chain_theta_3 = chain_theta_3.sin();
    let cos_chain_theta_3 = chain_theta_3.cos();
    let sin_chain_theta_4 = chain_theta_4.sin();
    let cos_chain_theta_4 = chain_theta_4.cos();
    let sin_chain_theta_5 = chain_theta_5.sin();
    let cos_chain_theta_5 = chain_theta_5.cos();
    let t36 = chain_omega_2 * chain_omega_2;
    let t37 = t36 * R::literal(4.0);
    let t38 = t37 * t1;
    let t39 = chain_omega_3 * chain_omega_3;
    let t40 = t39 * R::literal(3.0);
    let t41 = t40 * t5;
    let t42 = chain_omega_4 * chain_omega_4;
    let t43 = t42 * R::literal(2.0);
    let t44 = t43 * t9;
    let t45 = chain_omega_5 * chain_omega_5;
    let t46 = t45 * t13;
    let t47 = sin_chain_theta_1 * R::literal(-49.05);
    let t48 = t47 - t38;
    let t49 = t48 - t41;
    let t50 = t49 - t44;
    let t51 = t50 - t46;
    let t52 = sin_chain_theta_2 * R::literal(39.24);
    let t53 = t40 * t16;
    let t54 = t43 * t20;
    let t55 = t45 * t24;
    let t56 = chain_omega_1 * chain_omega_1;
    let t57 = t56 * R::literal(4.0);
    let t58 = t57 * t1;
    let t59 = t58 - t52;
    let t60 = t59 - t53;
    let t61 = t60 - t54;
    let t62 = t61 - t55;
    let t63 = sin_chain_theta_3 * R::literal(29.43);
    let t64 = t43 * t27;
    let t65 = t45 * t31;
    let t66 = t56 * R::literal(3.0);
    let t67 = t66 * t5;
    let t68 = t36 * R::literal(3.0);
    let t69 = t68 * t16;
    let t70 = t67 + t69;
    let t71 = t70 - t63;
    let t72 = t71 - t64;
    let t73 = t72 - t65;
    let t74 = sin_chain_theta_4 * R::literal(19.62);
    let t75 = t45 * t34;
    let t76 = t56 * R::literal(2.0);
    let t77 = t76 * t9;
    let t78 = t36 * R::literal(2.0);
    let t79 = t78 * t20;
    let t80 = t39 * R::literal(2.0);
    let t81 = t80 * t27;
    let t82 = t77 + t79;
    let t83 = t82 + t81;
    let t84 = t83 - t74;
    let t85 = t84 - t75;
    let t86 = sin_chain_theta_5 * R::literal(9.81);
    let t87 = t56 * t13;
    let t88 = t36 * t24;
    let t89 = t39 * t31;
    let t90 = t42 * t34;
    let t91 = t87 + t88;
    let t92 = t91 + t89;
    let t93 = t92 + t90;
    let t94 = t93 - t86;
    let factored = Factored::new([[R::literal(5.0), R::literal(0.0), R::literal(0.0),
        R::literal(0.0), R::literal(0.0)], [t3, R::literal(4.0), R::literal(0.0), R::literal(0.0),
        R::literal(0.0)], [t7, t18, R::literal(3.0), R::literal(0.0), R::literal(0.0)],
        [t11, t22, t29, R::literal(2.0), R::literal(0.0)], [t14, t25, t32, t35, R::literal(1.0)]]);
    let [chain_omega_1_dot, chain_omega_2_dot, chain_omega_3_dot, chain_omega_4_dot,
        chain_omega_5_dot] = factored.solve([t51, t62, t73, t85, t94]);
    let mut rates = [chain_omega_1, chain_omega_2, chain_omega_3, chain_omega_4, chain_omega_5,
        chain_omega_1_dot, chain_omega_2_dot, chain_omega_3_dot, chain_omega_4_dot,
        chain_omega_5_dot];
    coefficients[0] = *state;
    let highest = coefficients.len() - 1;
    for (order, state_k) in coefficients.iter_mut().enumerate().skip(1) {
        let (k, inverse) = order_and_inverse::<R>(order);
        *state_k = rates.map(|rate| rate * inverse);
        if order == highest {
            break;
        }
        let [chain_theta_1_k, chain_theta_2_k, chain_theta_3_k, chain_theta_4_k, chain_theta_5_k,
            chain_omega_1_k, chain_omega_2_k, chain_omega_3_k, chain_omega_4_k, chain_omega_5_k]
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
        let sums_14 = lanes_14.sums(order);
        let sums_15 = lanes_15.sums(order);
        let sums_16 = lanes_16.sums(order);
        let sums_17 = lanes_17.sums(order);
        let sums_18 = lanes_18.sums(order);
        let t0_k = chain_theta_1_k - chain_theta_2_k;
        let t1_k = t0_k.mul_add(t2, inverse * sums_3[3]);
        let t2_k = -t0_k.mul_add(t1, inverse * sums_4[0]);
        let t3_k = t2_k * R::literal(4.0);
        let t4_k = chain_theta_1_k - chain_theta_3_k;
        let t5_k = t4_k.mul_add(t6, inverse * sums_4[1]);
        let t6_k = -t4_k.mul_add(t5, inverse * sums_4[2]);
        let t7_k = t6_k * R::literal(3.0);
        let t8_k = chain_theta_1_k - chain_theta_4_k;
        let t9_k = t8_k.mul_add(t10, inverse * sums_4[3]);
        let t10_k = -t8_k.mul_add(t9, inverse * sums_5[0]);
        let t11_k = t10_k * R::literal(2.0);
        let t12_k = chain_theta_1_k - chain_theta_5_k;
        let t13_k = t12_k.mul_add(t14, inverse * sums_5[1]);
        let t14_k = -t12_k.mul_add(t13, inverse * sums_5[2]);
        let t15_k = chain_theta_2_k - chain_theta_3_k;
        let t16_k = t15_k.mul_add(t17, inverse * sums_5[3]);
        let t17_k = -t15_k.mul_add(t16, inverse * sums_6[0]);
        let t18_k = t17_k * R::literal(3.0);
        let t19_k = chain_theta_2_k - chain_theta_4_k;
        let t20_k = t19_k.mul_add(t21, inverse * sums_6[1]);
        let t21_k = -t19_k.mul_add(t20, inverse * sums_6[2]);
        let t22_k = t21_k * R::literal(2.0);
        let t23_k = chain_theta_2_k - chain_theta_5_k;
        let t24_k = t23_k.mul_add(t25, inverse * sums_6[3]);
        let t25_k = -t23_k.mul_add(t24, inverse * sums_7[0]);
        let t26_k = chain_theta_3_k - chain_theta_4_k;
        let t27_k = t26_k.mul_add(t28, inverse * sums_7[1]);
        let t28_k = -t26_k.mul_add(t27, inverse * sums_7[2]);
        let t29_k = t28_k * R::literal(2.0);
        let t30_k = chain_theta_3_k - chain_theta_5_k;
        let t31_k = t30_k.mul_add(t32, inverse * sums_7[3]);
        let t32_k = -t30_k.mul_add(t31, inverse * sums_8[0]);
        let t33_k = chain_theta_4_k - chain_theta_5_k;
        let t34_k = t33_k.mul_add(t35, inverse * sums_8[1]);
        let t35_k = -t33_k.mul_add(t34, inverse * sums_8[2]);
        let sin_chain_theta_1_k = chain_theta_1_k.mul_add(cos_chain_theta_1, inverse * sums_1[1]);
        let cos_chain_theta_1_k = -chain_theta_1_k.mul_add(sin_chain_theta_1, inverse * sums_1[2]);
        let sin_chain_theta_2_k = chain_theta_2_k.mul_add(cos_chain_theta_2, inverse * sums_1[3]);
        let cos_chain_theta_2_k = -chain_theta_2_k.mul_add(sin_chain_theta_2, inverse * sums_2[0]);
        let sin_chain_theta_3_k = chain_theta_3_k.mul_add(cos_chain_theta_3, inverse * sums_2[1]);
        let cos_chain_theta_3_k = -chain_theta_3_k.mul_add(sin_chain_theta_3, inverse * sums_2[2]);
        let sin_chain_theta_4_k = chain_theta_4_k.mul_add(cos_chain_theta_4, inverse * sums_2[3]);
        let cos_chain_theta_4_k = -chain_theta_4_k.mul_add(sin_chain_theta_4, inverse * sums_3[0]);
        let sin_chain_theta_5_k = chain_theta_5_k.mul_add(cos_chain_theta_5, inverse * sums_3[1]);
        let cos_chain_theta_5_k = -chain_theta_5_k.mul_add(sin_chain_theta_5, inverse * sums_3[2]);
        let t36_k = (chain_omega_2 + chain_omega_2).mul_add(chain_omega_2_k, sums[0]);
        let t37_k = t36_k * R::literal(4.0);
        let t38_k = t37.mul_add(t1_k, t1.mul_add(t37_k, sums_8[3]));
        let t39_k = (chain_omega_3 + chain_omega_3).mul_add(chain_omega_3_k, sums[1]);
        let t40_k = t39_k * R::literal(3.0);
        let t41_k = t40.mul_add(t5_k, t5.mul_add(t40_k, sums_9[0]));
        let t42_k = (chain_omega_4 + chain_omega_4).mul_add(chain_omega_4_k, sums[2]);
        let t43_k = t42_k * R::literal(2.0);
        let t44_k = t43.mul_add(t9_k, t9.mul_add(t43_k, sums_9[1]));
        let t45_k = (chain_omega_5 + chain_omega_5).mul_add(chain_omega_5_k, sums[3]);
        let t46_k = t45.mul_add(t13_k, t13.mul_add(t45_k, sums_9[2]));
        let t48_k = sin_chain_theta_1_k.mul_add(R::literal(-49.05), -t38_k);
        let t49_k = t48_k - t41_k;
        let t50_k = t49_k - t44_k;
        let t51_k = t50_k - t46_k;
        let t53_k = t40.mul_add(t16_k, t16.mul_add(t40_k, sums_9[3]));
        let t54_k = t43.mul_add(t20_k, t20.mul_add(t43_k, sums_10[0]));
        let t55_k = t45.mul_add(t24_k, t24.mul_add(t45_k, sums_10[1]));
        let t56_k = (chain_omega_1 + chain_omega_1).mul_add(chain_omega_1_k, sums_1[0]);
        let t57_k = t56_k * R::literal(4.0);
        let t58_k = t57.mul_add(t1_k, t1.mul_add(t57_k, sums_10[2]));
        let t59_k = (-sin_chain_theta_2_k).mul_add(R::literal(39.24), t58_k);
        let t60_k = t59_k - t53_k;
        let t61_k = t60_k - t54_k;
        let t62_k = t61_k - t55_k;
        let t64_k = t43.mul_add(t27_k, t27.mul_add(t43_k, sums_10[3]));
        let t65_k = t45.mul_add(t31_k, t31.mul_add(t45_k, sums_11[0]));
        let t66_k = t56_k * R::literal(3.0);
        let t67_k = t66.mul_add(t5_k, t5.mul_add(t66_k, sums_11[1]));
        let t68_k = t36_k * R::literal(3.0);
        let t69_k = t68.mul_add(t16_k, t16.mul_add(t68_k, sums_11[2]));
        let t70_k = t67_k + t69_k;
        let t71_k = (-sin_chain_theta_3_k).mul_add(R::literal(29.43), t70_k);
        let t72_k = t71_k - t64_k;
        let t73_k = t72_k - t65_k;
        let t75_k = t45.mul_add(t34_k, t34.mul_add(t45_k, sums_11[3]));
        let t76_k = t56_k * R::literal(2.0);
        let t77_k = t76.mul_add(t9_k, t9.mul_add(t76_k, sums_12[0]));
        let t78_k = t36_k * R::literal(2.0);
        let t79_k = t78.mul_add(t20_k, t20.mul_add(t78_k, sums_12[1]));
        let t80_k = t39_k * R::literal(2.0);
        let t81_k = t80.mul_add(t27_k, t27.mul_add(t80_k, sums_12[2]));
        let t82_k = t77_k + t79_k;
        let t83_k = t82_k + t81_k;
        let t84_k = (-sin_chain_theta_4_k).mul_add(R::literal(19.62), t83_k);
        let t85_k = t84_k - t75_k;
        let t87_k = t56.mul_add(t13_k, t13.mul_add(t56_k, sums_12[3]));
        let t88_k = t36.mul_add(t24_k, t24.mul_add(t36_k, sums_13[0]));
        let t89_k = t39.mul_add(t31_k, t31.mul_add(t39_k, sums_13[1]));
        let t90_k = t42.mul_add(t34_k, t34.mul_add(t42_k, sums_13[2]));
        let t91_k = t87_k + t88_k;
        let t92_k = t91_k + t89_k;
        let t93_k = t92_k + t90_k;
        let t94_k = (-sin_chain_theta_5_k).mul_add(R::literal(9.81), t93_k);
        let n130_k = t3_k.mul_add(chain_omega_2_dot, sums_13[3]);
        let n131_k = t7_k.mul_add(chain_omega_3_dot, sums_14[0]);
        let n132_k = t11_k.mul_add(chain_omega_4_dot, sums_14[1]);
        let n133_k = t14_k.mul_add(chain_omega_5_dot, sums_14[2]);
        let n134_k = t3_k.mul_add(chain_omega_1_dot, sums_14[3]);
        let n135_k = t18_k.mul_add(chain_omega_3_dot, sums_15[0]);
        let n136_k = t22_k.mul_add(chain_omega_4_dot, sums_15[1]);
        let n137_k = t25_k.mul_add(chain_omega_5_dot, sums_15[2]);
        let n138_k = t7_k.mul_add(chain_omega_1_dot, sums_15[3]);
        let n139_k = t18_k.mul_add(chain_omega_2_dot, sums_16[0]);
        let n140_k = t29_k.mul_add(chain_omega_4_dot, sums_16[1]);
        let n141_k = t32_k.mul_add(chain_omega_5_dot, sums_16[2]);
        let n142_k = t11_k.mul_add(chain_omega_1_dot, sums_16[3]);
        let n143_k = t22_k.mul_add(chain_omega_2_dot, sums_17[0]);
        let n144_k = t29_k.mul_add(chain_omega_3_dot, sums_17[1]);
        let n145_k = t35_k.mul_add(chain_omega_5_dot, sums_17[2]);
        let n146_k = t14_k.mul_add(chain_omega_1_dot, sums_17[3]);
        let n147_k = t25_k.mul_add(chain_omega_2_dot, sums_18[0]);
        let n148_k = t32_k.mul_add(chain_omega_3_dot, sums_18[1]);
        let n149_k = t35_k.mul_add(chain_omega_4_dot, sums_18[2]);
        let n150_k = n130_k + n131_k;
        let n151_k = n132_k + n133_k;
        let n152_k = n150_k + n151_k;
        let t51_k_2 = t51_k - n152_k;
        let n154_k = n134_k + n135_k;
        let n155_k = n136_k + n137_k;
        let n156_k = n154_k + n155_k;
        let t62_k_2 = t62_k - n156_k;
        let n158_k = n138_k + n139_k;
        let n159_k = n140_k + n141_k;
        let n160_k = n158_k + n159_k;
        let t73_k_2 = t73_k - n160_k;
        let n162_k = n142_k + n143_k;
        let n163_k = n144_k + n145_k;
        let n164_k = n162_k + n163_k;
        let t85_k_2 = t85_k - n164_k;
        let n166_k = n146_k + n147_k;
        let n167_k = n148_k + n149_k;
        let n168_k = n166_k + n167_k;
        let t94_k_2 = t94_k - n168_k;
        let [chain_omega_1_dot_k, chain_omega_2_dot_k, chain_omega_3_dot_k, chain_omega_4_dot_k,
            chain_omega_5_dot_k] = factored.solve([t51_k_2, t62_k_2, t73_k_2, t85_k_2, t94_k_2]);
        lanes.set(order, [chain_omega_2_k, chain_omega_3_k, chain_omega_4_k, chain_omega_5_k],
            [chain_omega_2_k, chain_omega_3_k, chain_omega_4_k, chain_omega_5_k]);
        lanes_1.set(order, [chain_omega_1_k, k * chain_theta_1_k, k * chain_theta_1_k,
            k * chain_theta_2_k], [chain_omega_1_k, cos_chain_theta_1_k, sin_chain_theta_1_k,
            cos_chain_theta_2_k]);
        lanes_2.set(order, [k * chain_theta_2_k, k * chain_theta_3_k, k * chain_theta_3_k,
            k * chain_theta_4_k], [sin_chain_theta_2_k, cos_chain_theta_3_k, sin_chain_theta_3_k,
            cos_chain_theta_4_k]);
        lanes_3.set(order, [k * chain_theta_4_k, k * chain_theta_5_k, k * chain_theta_5_k,
            k * t0_k], [sin_chain_theta_4_k, cos_chain_theta_5_k, sin_chain_theta_5_k, t2_k]);
        lanes_4.set(order, [k * t0_k, k * t4_k, k * t4_k, k * t8_k], [t1_k, t6_k, t5_k, t10_k]);
        lanes_5.set(order, [k * t8_k, k * t12_k, k * t12_k, k * t15_k], [t9_k, t14_k, t13_k,
            t17_k]);
        lanes_6.set(order, [k * t15_k, k * t19_k, k * t19_k, k * t23_k], [t16_k, t21_k, t20_k,
            t25_k]);
        lanes_7.set(order, [k * t23_k, k * t26_k, k * t26_k, k * t30_k], [t24_k, t28_k, t27_k,
            t32_k]);
        lanes_8.set(order, [k * t30_k, k * t33_k, k * t33_k, t1_k], [t31_k, t35_k, t34_k, t37_k]);
        lanes_9.set(order, [t5_k, t9_k, t13_k, t16_k], [t40_k, t43_k, t45_k, t40_k]);
        lanes_10.set(order, [t20_k, t24_k, t1_k, t27_k], [t43_k, t45_k, t57_k, t43_k]);
        lanes_11.set(order, [t31_k, t5_k, t16_k, t34_k], [t45_k, t66_k, t68_k, t45_k]);
        lanes_12.set(order, [t9_k, t20_k, t27_k, t13_k], [t76_k, t78_k, t80_k, t56_k]);
        lanes_13.set(order, [t24_k, t31_k, t34_k, t3_k], [t36_k, t39_k, t42_k,
            chain_omega_2_dot_k]);
        lanes_14.set(order, [t7_k, t11_k, t14_k, t3_k], [chain_omega_3_dot_k, chain_omega_4_dot_k,
            chain_omega_5_dot_k, chain_omega_1_dot_k]);
        lanes_15.set(order, [t18_k, t22_k, t25_k, t7_k], [chain_omega_3_dot_k, chain_omega_4_dot_k,
            chain_omega_5_dot_k, chain_omega_1_dot_k]);
        lanes_16.set(order, [t18_k, t29_k, t32_k, t11_k], [chain_omega_2_dot_k,
            chain_omega_4_dot_k, chain_omega_5_dot_k, chain_omega_1_dot_k]);
        lanes_17.set(order, [t22_k, t29_k, t35_k, t14_k], [chain_omega_2_dot_k,
            chain_omega_3_dot_k, chain_omega_5_dot_k, chain_omega_1_dot_k]);
        lanes_18.set(order, [t25_k, t32_k, t35_k], [chain_omega_2_dot_k, chain_omega_3_dot_k,
            chain_omega_4_dot_k]);
        rates = [chain_omega_1_k, chain_omega_2_k, chain_omega_3_k, chain_omega_4_k,
            chain_omega_5_k, chain_omega_1_dot_k, chain_omega_2_dot_k, chain_omega_3_dot_k,
            chain_omega_4_dot_k, chain_omega_5_dot_k];
    }
}

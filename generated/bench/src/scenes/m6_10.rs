// Emitted by Machinist 0.1.0; do not edit. To make it again:
//
//     cargo run --release -- gen
//
// Sources, with SHA-256:
//   aafd28d8a41d6cb556ccb596d990d1acf5b1df44fb2132c1e18d669de001d607  bench/m6_10.toml
//
// Benchmark M6: planar pendulum of 10 links
//
// Point masses on 10 massless links, angles from the downward vertical, released horizontal and at
// rest.
//
// Source:
//   Benchmark models of textile-machine dynamics.
//
// All quantities are in SI units.
// Shapes: coordinates 10, states 20, outputs 20.
// Nonzeros: mass_matrix 100 of 10 by 10, rate_jacobian 210 of 20 by 20,
//     parameter_jacobian 0 of 20 by 0.
// Operations: rate 1144, mass_matrix 126, forcing 344, rate_jacobian 738, energy 117,
//     power_balance 652, motion 1144.

use ::machinist_contract::{
    Energy, PowerBalance, Real, implicit::{Step, substitute},
    taylor::{Factored, Lanes, order_and_inverse},
};

::machinist_contract::simulator! {
    /// Benchmark M6: planar pendulum of 10 links
    ///
    /// Point masses on 10 massless links, angles from the downward vertical, released horizontal and at
    /// rest.
    ///
    /// Source: Benchmark models of textile-machine dynamics.
    M610: "m6_10", "Benchmark M6: planar pendulum of 10 links";
    run from 0.0, until 5.0, points 501, rtol 1e-8, method "auto";
    quadratures 0, discontinuities 0;
    series 300;
}

::machinist_contract::parameters! {}

::machinist_contract::outputs! {
    theta_1: "rad", "theta_1", "angle of link 1 from the vertical";
    theta_2: "rad", "theta_2", "angle of link 2 from the vertical";
    theta_3: "rad", "theta_3", "angle of link 3 from the vertical";
    theta_4: "rad", "theta_4", "angle of link 4 from the vertical";
    theta_5: "rad", "theta_5", "angle of link 5 from the vertical";
    theta_6: "rad", "theta_6", "angle of link 6 from the vertical";
    theta_7: "rad", "theta_7", "angle of link 7 from the vertical";
    theta_8: "rad", "theta_8", "angle of link 8 from the vertical";
    theta_9: "rad", "theta_9", "angle of link 9 from the vertical";
    theta_10: "rad", "theta_10", "angle of link 10 from the vertical";
    omega_1: "rad/s", "omega_1", "rate of angle of link 1 from the vertical";
    omega_2: "rad/s", "omega_2", "rate of angle of link 2 from the vertical";
    omega_3: "rad/s", "omega_3", "rate of angle of link 3 from the vertical";
    omega_4: "rad/s", "omega_4", "rate of angle of link 4 from the vertical";
    omega_5: "rad/s", "omega_5", "rate of angle of link 5 from the vertical";
    omega_6: "rad/s", "omega_6", "rate of angle of link 6 from the vertical";
    omega_7: "rad/s", "omega_7", "rate of angle of link 7 from the vertical";
    omega_8: "rad/s", "omega_8", "rate of angle of link 8 from the vertical";
    omega_9: "rad/s", "omega_9", "rate of angle of link 9 from the vertical";
    omega_10: "rad/s", "omega_10", "rate of angle of link 10 from the vertical";
}

::machinist_contract::states! {
    CHAIN_THETA_1: position, 1.0, "rad", "chain.theta_1", "angle of link 1 from the vertical";
    CHAIN_THETA_2: position, 1.0, "rad", "chain.theta_2", "angle of link 2 from the vertical";
    CHAIN_THETA_3: position, 1.0, "rad", "chain.theta_3", "angle of link 3 from the vertical";
    CHAIN_THETA_4: position, 1.0, "rad", "chain.theta_4", "angle of link 4 from the vertical";
    CHAIN_THETA_5: position, 1.0, "rad", "chain.theta_5", "angle of link 5 from the vertical";
    CHAIN_THETA_6: position, 1.0, "rad", "chain.theta_6", "angle of link 6 from the vertical";
    CHAIN_THETA_7: position, 1.0, "rad", "chain.theta_7", "angle of link 7 from the vertical";
    CHAIN_THETA_8: position, 1.0, "rad", "chain.theta_8", "angle of link 8 from the vertical";
    CHAIN_THETA_9: position, 1.0, "rad", "chain.theta_9", "angle of link 9 from the vertical";
    CHAIN_THETA_10: position, 1.0, "rad", "chain.theta_10", "angle of link 10 from the vertical";
    CHAIN_OMEGA_1: velocity, 5.0, "rad/s", "chain.omega_1", "rate of angle of link 1 from the vertical";
    CHAIN_OMEGA_2: velocity, 5.0, "rad/s", "chain.omega_2", "rate of angle of link 2 from the vertical";
    CHAIN_OMEGA_3: velocity, 5.0, "rad/s", "chain.omega_3", "rate of angle of link 3 from the vertical";
    CHAIN_OMEGA_4: velocity, 5.0, "rad/s", "chain.omega_4", "rate of angle of link 4 from the vertical";
    CHAIN_OMEGA_5: velocity, 5.0, "rad/s", "chain.omega_5", "rate of angle of link 5 from the vertical";
    CHAIN_OMEGA_6: velocity, 5.0, "rad/s", "chain.omega_6", "rate of angle of link 6 from the vertical";
    CHAIN_OMEGA_7: velocity, 5.0, "rad/s", "chain.omega_7", "rate of angle of link 7 from the vertical";
    CHAIN_OMEGA_8: velocity, 5.0, "rad/s", "chain.omega_8", "rate of angle of link 8 from the vertical";
    CHAIN_OMEGA_9: velocity, 5.0, "rad/s", "chain.omega_9", "rate of angle of link 9 from the vertical";
    CHAIN_OMEGA_10: velocity, 5.0, "rad/s", "chain.omega_10", "rate of angle of link 10 from the vertical";
}

::machinist_contract::patterns! {
    /// Nonzeros of M.
    MASS_MATRIX_PATTERN: 10 by 10 { 0 [0 1 2 3 4 5 6 7 8 9] 1 [0 1 2 3 4 5 6 7 8 9]
        2 [0 1 2 3 4 5 6 7 8 9] 3 [0 1 2 3 4 5 6 7 8 9] 4 [0 1 2 3 4 5 6 7 8 9]
        5 [0 1 2 3 4 5 6 7 8 9] 6 [0 1 2 3 4 5 6 7 8 9] 7 [0 1 2 3 4 5 6 7 8 9]
        8 [0 1 2 3 4 5 6 7 8 9] 9 [0 1 2 3 4 5 6 7 8 9] }
    /// Nonzeros of dy'/dy.
    RATE_JACOBIAN_PATTERN: 20 by 20 { 0 [10] 1 [11] 2 [12] 3 [13] 4 [14] 5 [15] 6 [16] 7 [17]
        8 [18] 9 [19] 10 [0 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19]
        11 [0 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19]
        12 [0 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19]
        13 [0 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19]
        14 [0 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19]
        15 [0 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19]
        16 [0 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19]
        17 [0 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19]
        18 [0 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19]
        19 [0 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19] }
    /// Nonzeros of dy'/dp.
    PARAMETER_JACOBIAN_PATTERN: 20 by 0 {  }
}

/// What several functions need of the motion; `motion` says what each is.
#[allow(missing_docs, reason = "`motion` says what each is")]
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Motion<R> {
    pub factors: [R; 55],
    pub sin_chain_theta_1: R,
    pub cos_chain_theta_1: R,
    pub sin_chain_theta_2: R,
    pub cos_chain_theta_2: R,
    pub sin_chain_theta_3: R,
    pub cos_chain_theta_3: R,
    pub sin_chain_theta_4: R,
    pub cos_chain_theta_4: R,
    pub sin_chain_theta_5: R,
    pub cos_chain_theta_5: R,
    pub sin_chain_theta_6: R,
    pub cos_chain_theta_6: R,
    pub sin_chain_theta_7: R,
    pub cos_chain_theta_7: R,
    pub sin_chain_theta_8: R,
    pub cos_chain_theta_8: R,
    pub sin_chain_theta_9: R,
    pub cos_chain_theta_9: R,
    pub sin_chain_theta_10: R,
    pub cos_chain_theta_10: R,
    pub t0: R,
    pub t1: R,
    pub t3: R,
    pub t4: R,
    pub t6: R,
    pub t7: R,
    pub t9: R,
    pub t10: R,
    pub t12: R,
    pub t13: R,
    pub t15: R,
    pub t16: R,
    pub t18: R,
    pub t19: R,
    pub t21: R,
    pub t22: R,
    pub t24: R,
    pub t25: R,
    pub t26: R,
    pub t27: R,
    pub t28: R,
    pub t29: R,
    pub t30: R,
    pub t31: R,
    pub t32: R,
    pub t33: R,
    pub t34: R,
    pub t35: R,
    pub t36: R,
    pub t37: R,
    pub t38: R,
    pub t39: R,
    pub t40: R,
    pub t41: R,
    pub t42: R,
    pub t43: R,
    pub t44: R,
    pub t45: R,
    pub t46: R,
    pub t47: R,
    pub t48: R,
    pub t49: R,
    pub t50: R,
    pub t51: R,
    pub t52: R,
    pub t53: R,
    pub t54: R,
    pub t55: R,
    pub t56: R,
    pub t57: R,
    pub t58: R,
    pub t59: R,
    pub t60: R,
    pub t61: R,
    pub t62: R,
    pub t63: R,
    pub t64: R,
    pub t65: R,
    pub t66: R,
    pub t67: R,
    pub t68: R,
    pub t69: R,
    pub t70: R,
    pub t71: R,
    pub t72: R,
    pub t73: R,
    pub t74: R,
    pub t75: R,
    pub t76: R,
    pub t77: R,
    pub t78: R,
    pub t79: R,
    pub t80: R,
    pub t81: R,
    pub t82: R,
    pub t83: R,
    pub t84: R,
    pub t85: R,
    pub t86: R,
    pub t87: R,
    pub t88: R,
    pub t89: R,
    pub t90: R,
    pub t91: R,
    pub t92: R,
    pub t93: R,
    pub t94: R,
    pub t95: R,
    pub t96: R,
    pub t97: R,
    pub chain_omega_10_dot: R,
    pub chain_omega_9_dot: R,
    pub chain_omega_8_dot: R,
    pub chain_omega_7_dot: R,
    pub chain_omega_6_dot: R,
    pub chain_omega_5_dot: R,
    pub chain_omega_4_dot: R,
    pub chain_omega_3_dot: R,
    pub chain_omega_2_dot: R,
    pub t205: R,
}

/// Accelerations, factors of the linear equations they solve, and whatever else several functions
/// need. 1144 operations.
#[must_use]
pub fn motion<R: Real>(_time: R, state: &[R; STATES], _p: &Parameters<R>) -> Motion<R> {
    let [chain_theta_1, chain_theta_2, chain_theta_3, chain_theta_4, chain_theta_5, chain_theta_6,
        chain_theta_7, chain_theta_8, chain_theta_9, chain_theta_10, chain_omega_1, chain_omega_2,
        chain_omega_3, chain_omega_4, chain_omega_5, chain_omega_6, chain_omega_7, chain_omega_8,
        chain_omega_9, chain_omega_10] = *state;
    let [(sin_chain_theta_1, cos_chain_theta_1), (sin_chain_theta_2, cos_chain_theta_2),
        (sin_chain_theta_3, cos_chain_theta_3), (sin_chain_theta_4, cos_chain_theta_4),
        (sin_chain_theta_5, cos_chain_theta_5), (sin_chain_theta_6, cos_chain_theta_6),
        (sin_chain_theta_7, cos_chain_theta_7), (sin_chain_theta_8, cos_chain_theta_8),
        (sin_chain_theta_9, cos_chain_theta_9), (sin_chain_theta_10, cos_chain_theta_10)]
        = R::sin_cos_each([chain_theta_1, chain_theta_2, chain_theta_3, chain_theta_4,
        chain_theta_5, chain_theta_6, chain_theta_7, chain_theta_8, chain_theta_9, chain_theta_10]);
    let t0 = (sin_chain_theta_1 * cos_chain_theta_2).sub_product(cos_chain_theta_1,
        sin_chain_theta_2);
    let t1 = (cos_chain_theta_1 * cos_chain_theta_2).add_product(sin_chain_theta_1,
        sin_chain_theta_2);
    let t2 = R::literal(9.0) * t1;
    let t3 = (sin_chain_theta_1 * cos_chain_theta_3).sub_product(cos_chain_theta_1,
        sin_chain_theta_3);
    let t4 = (cos_chain_theta_1 * cos_chain_theta_3).add_product(sin_chain_theta_1,
        sin_chain_theta_3);
    let t5 = R::literal(8.0) * t4;
    let t6 = (sin_chain_theta_1 * cos_chain_theta_4).sub_product(cos_chain_theta_1,
        sin_chain_theta_4);
    let t7 = (cos_chain_theta_1 * cos_chain_theta_4).add_product(sin_chain_theta_1,
        sin_chain_theta_4);
    let t8 = R::literal(7.0) * t7;
    let t9 = (sin_chain_theta_1 * cos_chain_theta_5).sub_product(cos_chain_theta_1,
        sin_chain_theta_5);
    let t10 = (cos_chain_theta_1 * cos_chain_theta_5).add_product(sin_chain_theta_1,
        sin_chain_theta_5);
    let t11 = R::literal(6.0) * t10;
    let t12 = (sin_chain_theta_1 * cos_chain_theta_6).sub_product(cos_chain_theta_1,
        sin_chain_theta_6);
    let t13 = (cos_chain_theta_1 * cos_chain_theta_6).add_product(sin_chain_theta_1,
        sin_chain_theta_6);
    let t14 = R::literal(5.0) * t13;
    let t15 = (sin_chain_theta_1 * cos_chain_theta_7).sub_product(cos_chain_theta_1,
        sin_chain_theta_7);
    let t16 = (cos_chain_theta_1 * cos_chain_theta_7).add_product(sin_chain_theta_1,
        sin_chain_theta_7);
    let t17 = R::literal(4.0) * t16;
    let t18 = (sin_chain_theta_1 * cos_chain_theta_8).sub_product(cos_chain_theta_1,
        sin_chain_theta_8);
    let t19 = (cos_chain_theta_1 * cos_chain_theta_8).add_product(sin_chain_theta_1,
        sin_chain_theta_8);
    let t20 = R::literal(3.0) * t19;
    let t21 = (sin_chain_theta_1 * cos_chain_theta_9).sub_product(cos_chain_theta_1,
        sin_chain_theta_9);
    let t22 = (cos_chain_theta_1 * cos_chain_theta_9).add_product(sin_chain_theta_1,
        sin_chain_theta_9);
    let t23 = R::literal(2.0) * t22;
    let t24 = (sin_chain_theta_1 * cos_chain_theta_10).sub_product(cos_chain_theta_1,
        sin_chain_theta_10);
    let t25 = (cos_chain_theta_1 * cos_chain_theta_10).add_product(sin_chain_theta_1,
        sin_chain_theta_10);
    let t26 = (sin_chain_theta_2 * cos_chain_theta_3).sub_product(cos_chain_theta_2,
        sin_chain_theta_3);
    let t27 = (cos_chain_theta_2 * cos_chain_theta_3).add_product(sin_chain_theta_2,
        sin_chain_theta_3);
    let t28 = (sin_chain_theta_2 * cos_chain_theta_4).sub_product(cos_chain_theta_2,
        sin_chain_theta_4);
    let t29 = (cos_chain_theta_2 * cos_chain_theta_4).add_product(sin_chain_theta_2,
        sin_chain_theta_4);
    let t30 = (sin_chain_theta_2 * cos_chain_theta_5).sub_product(cos_chain_theta_2,
        sin_chain_theta_5);
    let t31 = (cos_chain_theta_2 * cos_chain_theta_5).add_product(sin_chain_theta_2,
        sin_chain_theta_5);
    let t32 = (sin_chain_theta_2 * cos_chain_theta_6).sub_product(cos_chain_theta_2,
        sin_chain_theta_6);
    let t33 = (cos_chain_theta_2 * cos_chain_theta_6).add_product(sin_chain_theta_2,
        sin_chain_theta_6);
    let t34 = (sin_chain_theta_2 * cos_chain_theta_7).sub_product(cos_chain_theta_2,
        sin_chain_theta_7);
    let t35 = (cos_chain_theta_2 * cos_chain_theta_7).add_product(sin_chain_theta_2,
        sin_chain_theta_7);
    let t36 = (sin_chain_theta_2 * cos_chain_theta_8).sub_product(cos_chain_theta_2,
        sin_chain_theta_8);
    let t37 = (cos_chain_theta_2 * cos_chain_theta_8).add_product(sin_chain_theta_2,
        sin_chain_theta_8);
    let t38 = (sin_chain_theta_2 * cos_chain_theta_9).sub_product(cos_chain_theta_2,
        sin_chain_theta_9);
    let t39 = (cos_chain_theta_2 * cos_chain_theta_9).add_product(sin_chain_theta_2,
        sin_chain_theta_9);
    let t40 = (sin_chain_theta_2 * cos_chain_theta_10).sub_product(cos_chain_theta_2,
        sin_chain_theta_10);
    let t41 = (cos_chain_theta_2 * cos_chain_theta_10).add_product(sin_chain_theta_2,
        sin_chain_theta_10);
    let t42 = (sin_chain_theta_3 * cos_chain_theta_4).sub_product(cos_chain_theta_3,
        sin_chain_theta_4);
    let t43 = (cos_chain_theta_3 * cos_chain_theta_4).add_product(sin_chain_theta_3,
        sin_chain_theta_4);
    let t44 = (sin_chain_theta_3 * cos_chain_theta_5).sub_product(cos_chain_theta_3,
        sin_chain_theta_5);
    let t45 = (cos_chain_theta_3 * cos_chain_theta_5).add_product(sin_chain_theta_3,
        sin_chain_theta_5);
    let t46 = (sin_chain_theta_3 * cos_chain_theta_6).sub_product(cos_chain_theta_3,
        sin_chain_theta_6);
    let t47 = (cos_chain_theta_3 * cos_chain_theta_6).add_product(sin_chain_theta_3,
        sin_chain_theta_6);
    let t48 = (sin_chain_theta_3 * cos_chain_theta_7).sub_product(cos_chain_theta_3,
        sin_chain_theta_7);
    let t49 = (cos_chain_theta_3 * cos_chain_theta_7).add_product(sin_chain_theta_3,
        sin_chain_theta_7);
    let t50 = (sin_chain_theta_3 * cos_chain_theta_8).sub_product(cos_chain_theta_3,
        sin_chain_theta_8);
    let t51 = (cos_chain_theta_3 * cos_chain_theta_8).add_product(sin_chain_theta_3,
        sin_chain_theta_8);
    let t52 = (sin_chain_theta_3 * cos_chain_theta_9).sub_product(cos_chain_theta_3,
        sin_chain_theta_9);
    let t53 = (cos_chain_theta_3 * cos_chain_theta_9).add_product(sin_chain_theta_3,
        sin_chain_theta_9);
    let t54 = (sin_chain_theta_3 * cos_chain_theta_10).sub_product(cos_chain_theta_3,
        sin_chain_theta_10);
    let t55 = (cos_chain_theta_3 * cos_chain_theta_10).add_product(sin_chain_theta_3,
        sin_chain_theta_10);
    let t56 = (sin_chain_theta_4 * cos_chain_theta_5).sub_product(cos_chain_theta_4,
        sin_chain_theta_5);
    let t57 = (cos_chain_theta_4 * cos_chain_theta_5).add_product(sin_chain_theta_4,
        sin_chain_theta_5);
    let t58 = (sin_chain_theta_4 * cos_chain_theta_6).sub_product(cos_chain_theta_4,
        sin_chain_theta_6);
    let t59 = (cos_chain_theta_4 * cos_chain_theta_6).add_product(sin_chain_theta_4,
        sin_chain_theta_6);
    let t60 = (sin_chain_theta_4 * cos_chain_theta_7).sub_product(cos_chain_theta_4,
        sin_chain_theta_7);
    let t61 = (cos_chain_theta_4 * cos_chain_theta_7).add_product(sin_chain_theta_4,
        sin_chain_theta_7);
    let t62 = (sin_chain_theta_4 * cos_chain_theta_8).sub_product(cos_chain_theta_4,
        sin_chain_theta_8);
    let t63 = (cos_chain_theta_4 * cos_chain_theta_8).add_product(sin_chain_theta_4,
        sin_chain_theta_8);
    let t64 = (sin_chain_theta_4 * cos_chain_theta_9).sub_product(cos_chain_theta_4,
        sin_chain_theta_9);
    let t65 = (cos_chain_theta_4 * cos_chain_theta_9).add_product(sin_chain_theta_4,
        sin_chain_theta_9);
    let t66 = (sin_chain_theta_4 * cos_chain_theta_10).sub_product(cos_chain_theta_4,
        sin_chain_theta_10);
    let t67 = (cos_chain_theta_4 * cos_chain_theta_10).add_product(sin_chain_theta_4,
        sin_chain_theta_10);
    let t68 = (sin_chain_theta_5 * cos_chain_theta_6).sub_product(cos_chain_theta_5,
        sin_chain_theta_6);
    let t69 = (cos_chain_theta_5 * cos_chain_theta_6).add_product(sin_chain_theta_5,
        sin_chain_theta_6);
    let t70 = (sin_chain_theta_5 * cos_chain_theta_7).sub_product(cos_chain_theta_5,
        sin_chain_theta_7);
    let t71 = (cos_chain_theta_5 * cos_chain_theta_7).add_product(sin_chain_theta_5,
        sin_chain_theta_7);
    let t72 = (sin_chain_theta_5 * cos_chain_theta_8).sub_product(cos_chain_theta_5,
        sin_chain_theta_8);
    let t73 = (cos_chain_theta_5 * cos_chain_theta_8).add_product(sin_chain_theta_5,
        sin_chain_theta_8);
    let t74 = (sin_chain_theta_5 * cos_chain_theta_9).sub_product(cos_chain_theta_5,
        sin_chain_theta_9);
    let t75 = (cos_chain_theta_5 * cos_chain_theta_9).add_product(sin_chain_theta_5,
        sin_chain_theta_9);
    let t76 = (sin_chain_theta_5 * cos_chain_theta_10).sub_product(cos_chain_theta_5,
        sin_chain_theta_10);
    let t77 = (cos_chain_theta_5 * cos_chain_theta_10).add_product(sin_chain_theta_5,
        sin_chain_theta_10);
    let t78 = (sin_chain_theta_6 * cos_chain_theta_7).sub_product(cos_chain_theta_6,
        sin_chain_theta_7);
    let t79 = (cos_chain_theta_6 * cos_chain_theta_7).add_product(sin_chain_theta_6,
        sin_chain_theta_7);
    let t80 = (sin_chain_theta_6 * cos_chain_theta_8).sub_product(cos_chain_theta_6,
        sin_chain_theta_8);
    let t81 = (cos_chain_theta_6 * cos_chain_theta_8).add_product(sin_chain_theta_6,
        sin_chain_theta_8);
    let t82 = (sin_chain_theta_6 * cos_chain_theta_9).sub_product(cos_chain_theta_6,
        sin_chain_theta_9);
    let t83 = (cos_chain_theta_6 * cos_chain_theta_9).add_product(sin_chain_theta_6,
        sin_chain_theta_9);
    let t84 = (sin_chain_theta_6 * cos_chain_theta_10).sub_product(cos_chain_theta_6,
        sin_chain_theta_10);
    let t85 = (cos_chain_theta_6 * cos_chain_theta_10).add_product(sin_chain_theta_6,
        sin_chain_theta_10);
    let t86 = (sin_chain_theta_7 * cos_chain_theta_8).sub_product(cos_chain_theta_7,
        sin_chain_theta_8);
    let t87 = (cos_chain_theta_7 * cos_chain_theta_8).add_product(sin_chain_theta_7,
        sin_chain_theta_8);
    let t88 = (sin_chain_theta_7 * cos_chain_theta_9).sub_product(cos_chain_theta_7,
        sin_chain_theta_9);
    let t89 = (cos_chain_theta_7 * cos_chain_theta_9).add_product(sin_chain_theta_7,
        sin_chain_theta_9);
    let t90 = (sin_chain_theta_7 * cos_chain_theta_10).sub_product(cos_chain_theta_7,
        sin_chain_theta_10);
    let t91 = (cos_chain_theta_7 * cos_chain_theta_10).add_product(sin_chain_theta_7,
        sin_chain_theta_10);
    let t92 = (sin_chain_theta_8 * cos_chain_theta_9).sub_product(cos_chain_theta_8,
        sin_chain_theta_9);
    let t93 = (cos_chain_theta_8 * cos_chain_theta_9).add_product(sin_chain_theta_8,
        sin_chain_theta_9);
    let t94 = (sin_chain_theta_8 * cos_chain_theta_10).sub_product(cos_chain_theta_8,
        sin_chain_theta_10);
    let t95 = (cos_chain_theta_8 * cos_chain_theta_10).add_product(sin_chain_theta_8,
        sin_chain_theta_10);
    let t96 = (sin_chain_theta_9 * cos_chain_theta_10).sub_product(cos_chain_theta_9,
        sin_chain_theta_10);
    let t97 = (cos_chain_theta_9 * cos_chain_theta_10).add_product(sin_chain_theta_9,
        sin_chain_theta_10);
    let t98 = R::literal(0.9) * t1;
    let t99 = R::literal(0.8) * t4;
    let t100 = R::literal(0.700_000_000_000_000_1) * t7;
    let t101 = R::literal(0.600_000_000_000_000_1) * t10;
    let t102 = R::literal(0.5) * t13;
    let t103 = R::literal(0.4) * t16;
    let t104 = R::literal(0.300_000_000_000_000_04) * t19;
    let t105 = R::literal(0.2) * t22;
    let t106 = t25 * R::literal(0.1);
    let t107 = R::literal(1.0) / R::literal(9.0).sub_product(t98, t2);
    let t108 = (R::literal(8.0) * t27).sub_product(t99, t2);
    let t109 = t108 * t107;
    let t110 = (R::literal(7.0) * t29).sub_product(t100, t2);
    let t111 = t110 * t107;
    let t112 = (R::literal(6.0) * t31).sub_product(t101, t2);
    let t113 = t112 * t107;
    let t114 = (R::literal(5.0) * t33).sub_product(t102, t2);
    let t115 = t114 * t107;
    let t116 = (R::literal(4.0) * t35).sub_product(t103, t2);
    let t117 = t116 * t107;
    let t118 = (R::literal(3.0) * t37).sub_product(t104, t2);
    let t119 = t118 * t107;
    let t120 = (R::literal(2.0) * t39).sub_product(t105, t2);
    let t121 = t120 * t107;
    let t122 = t41.sub_product(t106, t2);
    let t123 = t122 * t107;
    let t124 = R::literal(1.0) / R::literal(8.0).sub_product(t99, t5).sub_product(t109, t108);
    let t125 = (R::literal(7.0) * t43).sub_product(t100, t5).sub_product(t111, t108);
    let t126 = t125 * t124;
    let t127 = (R::literal(6.0) * t45).sub_product(t101, t5).sub_product(t113, t108);
    let t128 = t127 * t124;
    let t129 = (R::literal(5.0) * t47).sub_product(t102, t5).sub_product(t115, t108);
    let t130 = t129 * t124;
    let t131 = (R::literal(4.0) * t49).sub_product(t103, t5).sub_product(t117, t108);
    let t132 = t131 * t124;
    let t133 = (R::literal(3.0) * t51).sub_product(t104, t5).sub_product(t119, t108);
    let t134 = t133 * t124;
    let t135 = (R::literal(2.0) * t53).sub_product(t105, t5).sub_product(t121, t108);
    let t136 = t135 * t124;
    let t137 = t55.sub_product(t106, t5).sub_product(t123, t108);
    let t138 = t137 * t124;
    let t139 = R::literal(1.0) / R::literal(7.0).sub_product(t100, t8).sub_product(t111, t110)
        .sub_product(t126, t125);
    let t140 = (R::literal(6.0) * t57).sub_product(t101, t8).sub_product(t113, t110)
        .sub_product(t128, t125);
    let t141 = t140 * t139;
    let t142 = (R::literal(5.0) * t59).sub_product(t102, t8).sub_product(t115, t110)
        .sub_product(t130, t125);
    let t143 = t142 * t139;
    let t144 = (R::literal(4.0) * t61).sub_product(t103, t8).sub_product(t117, t110)
        .sub_product(t132, t125);
    let t145 = t144 * t139;
    let t146 = (R::literal(3.0) * t63).sub_product(t104, t8).sub_product(t119, t110)
        .sub_product(t134, t125);
    let t147 = t146 * t139;
    let t148 = (R::literal(2.0) * t65).sub_product(t105, t8).sub_product(t121, t110)
        .sub_product(t136, t125);
    let t149 = t148 * t139;
    let t150 = t67.sub_product(t106, t8).sub_product(t123, t110).sub_product(t138, t125);
    let t151 = t150 * t139;
    let t152 = R::literal(1.0) / R::literal(6.0).sub_product(t101, t11).sub_product(t113, t112)
        .sub_product(t128, t127).sub_product(t141, t140);
    let t153 = (R::literal(5.0) * t69).sub_product(t102, t11).sub_product(t115, t112)
        .sub_product(t130, t127).sub_product(t143, t140);
    let t154 = t153 * t152;
    let t155 = (R::literal(4.0) * t71).sub_product(t103, t11).sub_product(t117, t112)
        .sub_product(t132, t127).sub_product(t145, t140);
    let t156 = t155 * t152;
    let t157 = (R::literal(3.0) * t73).sub_product(t104, t11).sub_product(t119, t112)
        .sub_product(t134, t127).sub_product(t147, t140);
    let t158 = t157 * t152;
    let t159 = (R::literal(2.0) * t75).sub_product(t105, t11).sub_product(t121, t112)
        .sub_product(t136, t127).sub_product(t149, t140);
    let t160 = t159 * t152;
    let t161 = t77.sub_product(t106, t11).sub_product(t123, t112).sub_product(t138, t127)
        .sub_product(t151, t140);
    let t162 = t161 * t152;
    let t163 = R::literal(1.0) / R::literal(5.0).sub_product(t102, t14).sub_product(t115, t114)
        .sub_product(t130, t129).sub_product(t143, t142).sub_product(t154, t153);
    let t164 = (R::literal(4.0) * t79).sub_product(t103, t14).sub_product(t117, t114)
        .sub_product(t132, t129).sub_product(t145, t142).sub_product(t156, t153);
    let t165 = t164 * t163;
    let t166 = (R::literal(3.0) * t81).sub_product(t104, t14).sub_product(t119, t114)
        .sub_product(t134, t129).sub_product(t147, t142).sub_product(t158, t153);
    let t167 = t166 * t163;
    let t168 = (R::literal(2.0) * t83).sub_product(t105, t14).sub_product(t121, t114)
        .sub_product(t136, t129).sub_product(t149, t142).sub_product(t160, t153);
    let t169 = t168 * t163;
    let t170 = t85.sub_product(t106, t14).sub_product(t123, t114).sub_product(t138, t129)
        .sub_product(t151, t142).sub_product(t162, t153);
    let t171 = t170 * t163;
    let t172 = R::literal(1.0) / R::literal(4.0).sub_product(t103, t17).sub_product(t117, t116)
        .sub_product(t132, t131).sub_product(t145, t144).sub_product(t156, t155).sub_product(t165,
        t164);
    let t173 = (R::literal(3.0) * t87).sub_product(t104, t17).sub_product(t119, t116)
        .sub_product(t134, t131).sub_product(t147, t144).sub_product(t158, t155).sub_product(t167,
        t164);
    let t174 = t173 * t172;
    let t175 = (R::literal(2.0) * t89).sub_product(t105, t17).sub_product(t121, t116)
        .sub_product(t136, t131).sub_product(t149, t144).sub_product(t160, t155).sub_product(t169,
        t164);
    let t176 = t175 * t172;
    let t177 = t91.sub_product(t106, t17).sub_product(t123, t116).sub_product(t138, t131)
        .sub_product(t151, t144).sub_product(t162, t155).sub_product(t171, t164);
    let t178 = t177 * t172;
    let t179 = R::literal(1.0) / R::literal(3.0).sub_product(t104, t20).sub_product(t119, t118)
        .sub_product(t134, t133).sub_product(t147, t146).sub_product(t158, t157).sub_product(t167,
        t166).sub_product(t174, t173);
    let t180 = (R::literal(2.0) * t93).sub_product(t105, t20).sub_product(t121, t118)
        .sub_product(t136, t133).sub_product(t149, t146).sub_product(t160, t157).sub_product(t169,
        t166).sub_product(t176, t173);
    let t181 = t180 * t179;
    let t182 = t95.sub_product(t106, t20).sub_product(t123, t118).sub_product(t138, t133)
        .sub_product(t151, t146).sub_product(t162, t157).sub_product(t171, t166).sub_product(t178,
        t173);
    let t183 = t182 * t179;
    let t184 = R::literal(1.0) / R::literal(2.0).sub_product(t105, t23).sub_product(t121, t120)
        .sub_product(t136, t135).sub_product(t149, t148).sub_product(t160, t159).sub_product(t169,
        t168).sub_product(t176, t175).sub_product(t181, t180);
    let t185 = t97.sub_product(t106, t23).sub_product(t123, t120).sub_product(t138, t135)
        .sub_product(t151, t148).sub_product(t162, t159).sub_product(t171, t168).sub_product(t178,
        t175).sub_product(t183, t180);
    let t186 = t185 * t184;
    let t187 = R::literal(1.0) / R::literal(1.0).sub_product(t106, t25).sub_product(t123, t122)
        .sub_product(t138, t137).sub_product(t151, t150).sub_product(t162, t161).sub_product(t171,
        t170).sub_product(t178, t177).sub_product(t183, t182).sub_product(t186, t185);
    let chain_omega_2_squared = chain_omega_2 * chain_omega_2;
    let chain_omega_3_squared = chain_omega_3 * chain_omega_3;
    let t188 = R::literal(8.0) * chain_omega_3_squared;
    let chain_omega_4_squared = chain_omega_4 * chain_omega_4;
    let t189 = R::literal(7.0) * chain_omega_4_squared;
    let chain_omega_5_squared = chain_omega_5 * chain_omega_5;
    let t190 = R::literal(6.0) * chain_omega_5_squared;
    let chain_omega_6_squared = chain_omega_6 * chain_omega_6;
    let t191 = R::literal(5.0) * chain_omega_6_squared;
    let chain_omega_7_squared = chain_omega_7 * chain_omega_7;
    let t192 = R::literal(4.0) * chain_omega_7_squared;
    let chain_omega_8_squared = chain_omega_8 * chain_omega_8;
    let t193 = R::literal(3.0) * chain_omega_8_squared;
    let chain_omega_9_squared = chain_omega_9 * chain_omega_9;
    let t194 = R::literal(2.0) * chain_omega_9_squared;
    let chain_omega_10_squared = chain_omega_10 * chain_omega_10;
    let t195 = (R::literal(98.1) * sin_chain_theta_1).add_product(R::literal(9.0)
        * chain_omega_2_squared, t0).add_product(t188, t3).add_product(t189, t6).add_product(t190,
        t9).add_product(t191, t12).add_product(t192, t15).add_product(t193, t18).add_product(t194,
        t21).add_product(chain_omega_10_squared, t24);
    let chain_omega_1_squared = chain_omega_1 * chain_omega_1;
    let t196 = (R::literal(-88.29) * sin_chain_theta_2).add_product(R::literal(9.0)
        * chain_omega_1_squared, t0).sub_product(t188, t26).sub_product(t189, t28)
        .sub_product(t190, t30).sub_product(t191, t32).sub_product(t192, t34).sub_product(t193, t36)
        .sub_product(t194, t38).sub_product(chain_omega_10_squared, t40).add_product(t98, t195);
    let t197 = (R::literal(8.0) * chain_omega_1_squared * t3).add_product(R::literal(8.0)
        * chain_omega_2_squared, t26).sub_product(R::literal(78.48), sin_chain_theta_3)
        .sub_product(t189, t42).sub_product(t190, t44).sub_product(t191, t46).sub_product(t192, t48)
        .sub_product(t193, t50).sub_product(t194, t52).sub_product(chain_omega_10_squared, t54)
        .add_product(t99, t195).sub_product(t109, t196);
    let t198 = (R::literal(7.0) * chain_omega_1_squared * t6).add_product(R::literal(7.0)
        * chain_omega_2_squared, t28).add_product(R::literal(7.0) * chain_omega_3_squared, t42)
        .sub_product(R::literal(68.67), sin_chain_theta_4).sub_product(t190, t56).sub_product(t191,
        t58).sub_product(t192, t60).sub_product(t193, t62).sub_product(t194, t64)
        .sub_product(chain_omega_10_squared, t66).add_product(t100, t195).sub_product(t111, t196)
        .sub_product(t126, t197);
    let t199 = (R::literal(6.0) * chain_omega_1_squared * t9).add_product(R::literal(6.0)
        * chain_omega_2_squared, t30).add_product(R::literal(6.0) * chain_omega_3_squared, t44)
        .add_product(R::literal(6.0) * chain_omega_4_squared, t56).sub_product(R::literal(58.86),
        sin_chain_theta_5).sub_product(t191, t68).sub_product(t192, t70).sub_product(t193, t72)
        .sub_product(t194, t74).sub_product(chain_omega_10_squared, t76).add_product(t101, t195)
        .sub_product(t113, t196).sub_product(t128, t197).sub_product(t141, t198);
    let t200 = (R::literal(5.0) * chain_omega_1_squared * t12).add_product(R::literal(5.0)
        * chain_omega_2_squared, t32).add_product(R::literal(5.0) * chain_omega_3_squared, t46)
        .add_product(R::literal(5.0) * chain_omega_4_squared, t58).add_product(R::literal(5.0)
        * chain_omega_5_squared, t68).sub_product(R::literal(49.05), sin_chain_theta_6)
        .sub_product(t192, t78).sub_product(t193, t80).sub_product(t194, t82)
        .sub_product(chain_omega_10_squared, t84).add_product(t102, t195).sub_product(t115, t196)
        .sub_product(t130, t197).sub_product(t143, t198).sub_product(t154, t199);
    let t201 = (R::literal(4.0) * chain_omega_1_squared * t15).add_product(R::literal(4.0)
        * chain_omega_2_squared, t34).add_product(R::literal(4.0) * chain_omega_3_squared, t48)
        .add_product(R::literal(4.0) * chain_omega_4_squared, t60).add_product(R::literal(4.0)
        * chain_omega_5_squared, t70).add_product(R::literal(4.0) * chain_omega_6_squared, t78)
        .sub_product(R::literal(39.24), sin_chain_theta_7).sub_product(t193, t86).sub_product(t194,
        t88).sub_product(chain_omega_10_squared, t90).add_product(t103, t195).sub_product(t117,
        t196).sub_product(t132, t197).sub_product(t145, t198).sub_product(t156, t199)
        .sub_product(t165, t200);
    let t202 = (R::literal(3.0) * chain_omega_1_squared * t18).add_product(R::literal(3.0)
        * chain_omega_2_squared, t36).add_product(R::literal(3.0) * chain_omega_3_squared, t50)
        .add_product(R::literal(3.0) * chain_omega_4_squared, t62).add_product(R::literal(3.0)
        * chain_omega_5_squared, t72).add_product(R::literal(3.0) * chain_omega_6_squared, t80)
        .add_product(R::literal(3.0) * chain_omega_7_squared, t86).sub_product(R::literal(29.43),
        sin_chain_theta_8).sub_product(t194, t92).sub_product(chain_omega_10_squared, t94)
        .add_product(t104, t195).sub_product(t119, t196).sub_product(t134, t197).sub_product(t147,
        t198).sub_product(t158, t199).sub_product(t167, t200).sub_product(t174, t201);
    let t203 = (R::literal(2.0) * chain_omega_1_squared * t21).add_product(R::literal(2.0)
        * chain_omega_2_squared, t38).add_product(R::literal(2.0) * chain_omega_3_squared, t52)
        .add_product(R::literal(2.0) * chain_omega_4_squared, t64).add_product(R::literal(2.0)
        * chain_omega_5_squared, t74).add_product(R::literal(2.0) * chain_omega_6_squared, t82)
        .add_product(R::literal(2.0) * chain_omega_7_squared, t88).add_product(R::literal(2.0)
        * chain_omega_8_squared, t92).sub_product(R::literal(19.62), sin_chain_theta_9)
        .sub_product(chain_omega_10_squared, t96).add_product(t105, t195).sub_product(t121, t196)
        .sub_product(t136, t197).sub_product(t149, t198).sub_product(t160, t199).sub_product(t169,
        t200);
    let t204 = t203.sub_product(t176, t201).sub_product(t181, t202);
    let chain_omega_10_dot = (chain_omega_1_squared * t24).add_product(chain_omega_2_squared, t40)
        .add_product(chain_omega_3_squared, t54).add_product(chain_omega_4_squared, t66)
        .add_product(chain_omega_5_squared, t76).add_product(chain_omega_6_squared, t84)
        .add_product(chain_omega_7_squared, t90).add_product(chain_omega_8_squared, t94)
        .add_product(chain_omega_9_squared, t96).sub_product(R::literal(9.81), sin_chain_theta_10)
        .add_product(t106, t195).sub_product(t123, t196).sub_product(t138, t197).sub_product(t151,
        t198).sub_product(t162, t199).sub_product(t171, t200).sub_product(t178, t201)
        .sub_product(t183, t202).sub_product(t186, t204) * t187;
    let chain_omega_9_dot = (t204 * t184).sub_product(t186, chain_omega_10_dot);
    let chain_omega_8_dot = (t202 * t179).sub_product(t181, chain_omega_9_dot).sub_product(t183,
        chain_omega_10_dot);
    let chain_omega_7_dot = (t201 * t172).sub_product(t174, chain_omega_8_dot).sub_product(t176,
        chain_omega_9_dot).sub_product(t178, chain_omega_10_dot);
    let chain_omega_6_dot = (t200 * t163).sub_product(t165, chain_omega_7_dot).sub_product(t167,
        chain_omega_8_dot).sub_product(t169, chain_omega_9_dot).sub_product(t171,
        chain_omega_10_dot);
    let chain_omega_5_dot = (t199 * t152).sub_product(t154, chain_omega_6_dot).sub_product(t156,
        chain_omega_7_dot).sub_product(t158, chain_omega_8_dot).sub_product(t160, chain_omega_9_dot)
        .sub_product(t162, chain_omega_10_dot);
    let chain_omega_4_dot = (t198 * t139).sub_product(t141, chain_omega_5_dot).sub_product(t143,
        chain_omega_6_dot).sub_product(t145, chain_omega_7_dot).sub_product(t147, chain_omega_8_dot)
        .sub_product(t149, chain_omega_9_dot).sub_product(t151, chain_omega_10_dot);
    let chain_omega_3_dot = (t197 * t124).sub_product(t126, chain_omega_4_dot).sub_product(t128,
        chain_omega_5_dot).sub_product(t130, chain_omega_6_dot).sub_product(t132, chain_omega_7_dot)
        .sub_product(t134, chain_omega_8_dot).sub_product(t136, chain_omega_9_dot)
        .sub_product(t138, chain_omega_10_dot);
    let chain_omega_2_dot = (t196 * t107).sub_product(t109, chain_omega_3_dot).sub_product(t111,
        chain_omega_4_dot).sub_product(t113, chain_omega_5_dot).sub_product(t115, chain_omega_6_dot)
        .sub_product(t117, chain_omega_7_dot).sub_product(t119, chain_omega_8_dot)
        .sub_product(t121, chain_omega_9_dot).sub_product(t123, chain_omega_10_dot);
    let t205 = (t195 * R::literal(0.1)).add_product(t98, chain_omega_2_dot).add_product(t99,
        chain_omega_3_dot).add_product(t100, chain_omega_4_dot).add_product(t101, chain_omega_5_dot)
        .add_product(t102, chain_omega_6_dot).add_product(t103, chain_omega_7_dot)
        .add_product(t104, chain_omega_8_dot).add_product(t105, chain_omega_9_dot)
        .add_product(t106, chain_omega_10_dot);
    Motion {
        factors: [t98, t99, t109, t100, t111, t126, t101, t113, t128, t141, t102, t115, t130, t143,
            t154, t103, t117, t132, t145, t156, t165, t104, t119, t134, t147, t158, t167, t174,
            t105, t121, t136, t149, t160, t169, t176, t181, t106, t123, t138, t151, t162, t171,
            t178, t183, t186, t187, t184, t179, t172, t163, t152, t139, t124, t107,
            R::literal(0.1)],
        sin_chain_theta_1,
        cos_chain_theta_1,
        sin_chain_theta_2,
        cos_chain_theta_2,
        sin_chain_theta_3,
        cos_chain_theta_3,
        sin_chain_theta_4,
        cos_chain_theta_4,
        sin_chain_theta_5,
        cos_chain_theta_5,
        sin_chain_theta_6,
        cos_chain_theta_6,
        sin_chain_theta_7,
        cos_chain_theta_7,
        sin_chain_theta_8,
        cos_chain_theta_8,
        sin_chain_theta_9,
        cos_chain_theta_9,
        sin_chain_theta_10,
        cos_chain_theta_10,
        t0,
        t1,
        t3,
        t4,
        t6,
        t7,
        t9,
        t10,
        t12,
        t13,
        t15,
        t16,
        t18,
        t19,
        t21,
        t22,
        t24,
        t25,
        t26,
        t27,
        t28,
        t29,
        t30,
        t31,
        t32,
        t33,
        t34,
        t35,
        t36,
        t37,
        t38,
        t39,
        t40,
        t41,
        t42,
        t43,
        t44,
        t45,
        t46,
        t47,
        t48,
        t49,
        t50,
        t51,
        t52,
        t53,
        t54,
        t55,
        t56,
        t57,
        t58,
        t59,
        t60,
        t61,
        t62,
        t63,
        t64,
        t65,
        t66,
        t67,
        t68,
        t69,
        t70,
        t71,
        t72,
        t73,
        t74,
        t75,
        t76,
        t77,
        t78,
        t79,
        t80,
        t81,
        t82,
        t83,
        t84,
        t85,
        t86,
        t87,
        t88,
        t89,
        t90,
        t91,
        t92,
        t93,
        t94,
        t95,
        t96,
        t97,
        chain_omega_10_dot,
        chain_omega_9_dot,
        chain_omega_8_dot,
        chain_omega_7_dot,
        chain_omega_6_dot,
        chain_omega_5_dot,
        chain_omega_4_dot,
        chain_omega_3_dot,
        chain_omega_2_dot,
        t205,
    }
}

/// State at the start of the run, in the units of the states. No operations.
#[must_use]
pub fn initial_state<R: Real>(_p: &Parameters<R>) -> [R; STATES] {
    [R::literal(core::f64::consts::FRAC_PI_2), R::literal(core::f64::consts::FRAC_PI_2),
        R::literal(core::f64::consts::FRAC_PI_2), R::literal(core::f64::consts::FRAC_PI_2),
        R::literal(core::f64::consts::FRAC_PI_2), R::literal(core::f64::consts::FRAC_PI_2),
        R::literal(core::f64::consts::FRAC_PI_2), R::literal(core::f64::consts::FRAC_PI_2),
        R::literal(core::f64::consts::FRAC_PI_2), R::literal(core::f64::consts::FRAC_PI_2),
        R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0),
        R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0)]
}

/// Times of known jumps of the right-hand side \[s\], unsorted. No operations.
#[must_use]
pub fn discontinuities<R: Real>(_p: &Parameters<R>) -> [R; DISCONTINUITIES] {
    []
}

/// `y'`: velocities, `q''` of `M q'' = f + G^T lambda`, `h`; in the units of the states per second.
/// 1144 operations.
#[must_use]
#[inline]
pub fn rate<R: Real>(_time: R, state: &[R; STATES], _p: &Parameters<R>) -> [R; STATES] {
    let [chain_theta_1, chain_theta_2, chain_theta_3, chain_theta_4, chain_theta_5, chain_theta_6,
        chain_theta_7, chain_theta_8, chain_theta_9, chain_theta_10, chain_omega_1, chain_omega_2,
        chain_omega_3, chain_omega_4, chain_omega_5, chain_omega_6, chain_omega_7, chain_omega_8,
        chain_omega_9, chain_omega_10] = *state;
    let [(sin_chain_theta_1, cos_chain_theta_1), (sin_chain_theta_2, cos_chain_theta_2),
        (sin_chain_theta_3, cos_chain_theta_3), (sin_chain_theta_4, cos_chain_theta_4),
        (sin_chain_theta_5, cos_chain_theta_5), (sin_chain_theta_6, cos_chain_theta_6),
        (sin_chain_theta_7, cos_chain_theta_7), (sin_chain_theta_8, cos_chain_theta_8),
        (sin_chain_theta_9, cos_chain_theta_9), (sin_chain_theta_10, cos_chain_theta_10)]
        = R::sin_cos_each([chain_theta_1, chain_theta_2, chain_theta_3, chain_theta_4,
        chain_theta_5, chain_theta_6, chain_theta_7, chain_theta_8, chain_theta_9, chain_theta_10]);
    let t0 = (sin_chain_theta_1 * cos_chain_theta_2).sub_product(cos_chain_theta_1,
        sin_chain_theta_2);
    let t1 = (cos_chain_theta_1 * cos_chain_theta_2).add_product(sin_chain_theta_1,
        sin_chain_theta_2);
    let t2 = R::literal(9.0) * t1;
    let t3 = (sin_chain_theta_1 * cos_chain_theta_3).sub_product(cos_chain_theta_1,
        sin_chain_theta_3);
    let t4 = (cos_chain_theta_1 * cos_chain_theta_3).add_product(sin_chain_theta_1,
        sin_chain_theta_3);
    let t5 = R::literal(8.0) * t4;
    let t6 = (sin_chain_theta_1 * cos_chain_theta_4).sub_product(cos_chain_theta_1,
        sin_chain_theta_4);
    let t7 = (cos_chain_theta_1 * cos_chain_theta_4).add_product(sin_chain_theta_1,
        sin_chain_theta_4);
    let t8 = R::literal(7.0) * t7;
    let t9 = (sin_chain_theta_1 * cos_chain_theta_5).sub_product(cos_chain_theta_1,
        sin_chain_theta_5);
    let t10 = (cos_chain_theta_1 * cos_chain_theta_5).add_product(sin_chain_theta_1,
        sin_chain_theta_5);
    let t11 = R::literal(6.0) * t10;
    let t12 = (sin_chain_theta_1 * cos_chain_theta_6).sub_product(cos_chain_theta_1,
        sin_chain_theta_6);
    let t13 = (cos_chain_theta_1 * cos_chain_theta_6).add_product(sin_chain_theta_1,
        sin_chain_theta_6);
    let t14 = R::literal(5.0) * t13;
    let t15 = (sin_chain_theta_1 * cos_chain_theta_7).sub_product(cos_chain_theta_1,
        sin_chain_theta_7);
    let t16 = (cos_chain_theta_1 * cos_chain_theta_7).add_product(sin_chain_theta_1,
        sin_chain_theta_7);
    let t17 = R::literal(4.0) * t16;
    let t18 = (sin_chain_theta_1 * cos_chain_theta_8).sub_product(cos_chain_theta_1,
        sin_chain_theta_8);
    let t19 = (cos_chain_theta_1 * cos_chain_theta_8).add_product(sin_chain_theta_1,
        sin_chain_theta_8);
    let t20 = R::literal(3.0) * t19;
    let t21 = (sin_chain_theta_1 * cos_chain_theta_9).sub_product(cos_chain_theta_1,
        sin_chain_theta_9);
    let t22 = (cos_chain_theta_1 * cos_chain_theta_9).add_product(sin_chain_theta_1,
        sin_chain_theta_9);
    let t23 = R::literal(2.0) * t22;
    let t24 = (sin_chain_theta_1 * cos_chain_theta_10).sub_product(cos_chain_theta_1,
        sin_chain_theta_10);
    let t25 = (cos_chain_theta_1 * cos_chain_theta_10).add_product(sin_chain_theta_1,
        sin_chain_theta_10);
    let t26 = (sin_chain_theta_2 * cos_chain_theta_3).sub_product(cos_chain_theta_2,
        sin_chain_theta_3);
    let t27 = (sin_chain_theta_2 * cos_chain_theta_4).sub_product(cos_chain_theta_2,
        sin_chain_theta_4);
    let t28 = (sin_chain_theta_2 * cos_chain_theta_5).sub_product(cos_chain_theta_2,
        sin_chain_theta_5);
    let t29 = (sin_chain_theta_2 * cos_chain_theta_6).sub_product(cos_chain_theta_2,
        sin_chain_theta_6);
    let t30 = (sin_chain_theta_2 * cos_chain_theta_7).sub_product(cos_chain_theta_2,
        sin_chain_theta_7);
    let t31 = (sin_chain_theta_2 * cos_chain_theta_8).sub_product(cos_chain_theta_2,
        sin_chain_theta_8);
    let t32 = (sin_chain_theta_2 * cos_chain_theta_9).sub_product(cos_chain_theta_2,
        sin_chain_theta_9);
    let t33 = (sin_chain_theta_2 * cos_chain_theta_10).sub_product(cos_chain_theta_2,
        sin_chain_theta_10);
    let t34 = (sin_chain_theta_3 * cos_chain_theta_4).sub_product(cos_chain_theta_3,
        sin_chain_theta_4);
    let t35 = (sin_chain_theta_3 * cos_chain_theta_5).sub_product(cos_chain_theta_3,
        sin_chain_theta_5);
    let t36 = (sin_chain_theta_3 * cos_chain_theta_6).sub_product(cos_chain_theta_3,
        sin_chain_theta_6);
    let t37 = (sin_chain_theta_3 * cos_chain_theta_7).sub_product(cos_chain_theta_3,
        sin_chain_theta_7);
    let t38 = (sin_chain_theta_3 * cos_chain_theta_8).sub_product(cos_chain_theta_3,
        sin_chain_theta_8);
    let t39 = (sin_chain_theta_3 * cos_chain_theta_9).sub_product(cos_chain_theta_3,
        sin_chain_theta_9);
    let t40 = (sin_chain_theta_3 * cos_chain_theta_10).sub_product(cos_chain_theta_3,
        sin_chain_theta_10);
    let t41 = (sin_chain_theta_4 * cos_chain_theta_5).sub_product(cos_chain_theta_4,
        sin_chain_theta_5);
    let t42 = (sin_chain_theta_4 * cos_chain_theta_6).sub_product(cos_chain_theta_4,
        sin_chain_theta_6);
    let t43 = (sin_chain_theta_4 * cos_chain_theta_7).sub_product(cos_chain_theta_4,
        sin_chain_theta_7);
    let t44 = (sin_chain_theta_4 * cos_chain_theta_8).sub_product(cos_chain_theta_4,
        sin_chain_theta_8);
    let t45 = (sin_chain_theta_4 * cos_chain_theta_9).sub_product(cos_chain_theta_4,
        sin_chain_theta_9);
    let t46 = (sin_chain_theta_4 * cos_chain_theta_10).sub_product(cos_chain_theta_4,
        sin_chain_theta_10);
    let t47 = (sin_chain_theta_5 * cos_chain_theta_6).sub_product(cos_chain_theta_5,
        sin_chain_theta_6);
    let t48 = (sin_chain_theta_5 * cos_chain_theta_7).sub_product(cos_chain_theta_5,
        sin_chain_theta_7);
    let t49 = (sin_chain_theta_5 * cos_chain_theta_8).sub_product(cos_chain_theta_5,
        sin_chain_theta_8);
    let t50 = (sin_chain_theta_5 * cos_chain_theta_9).sub_product(cos_chain_theta_5,
        sin_chain_theta_9);
    let t51 = (sin_chain_theta_5 * cos_chain_theta_10).sub_product(cos_chain_theta_5,
        sin_chain_theta_10);
    let t52 = (sin_chain_theta_6 * cos_chain_theta_7).sub_product(cos_chain_theta_6,
        sin_chain_theta_7);
    let t53 = (sin_chain_theta_6 * cos_chain_theta_8).sub_product(cos_chain_theta_6,
        sin_chain_theta_8);
    let t54 = (sin_chain_theta_6 * cos_chain_theta_9).sub_product(cos_chain_theta_6,
        sin_chain_theta_9);
    let t55 = (sin_chain_theta_6 * cos_chain_theta_10).sub_product(cos_chain_theta_6,
        sin_chain_theta_10);
    let t56 = (sin_chain_theta_7 * cos_chain_theta_8).sub_product(cos_chain_theta_7,
        sin_chain_theta_8);
    let t57 = (sin_chain_theta_7 * cos_chain_theta_9).sub_product(cos_chain_theta_7,
        sin_chain_theta_9);
    let t58 = (sin_chain_theta_7 * cos_chain_theta_10).sub_product(cos_chain_theta_7,
        sin_chain_theta_10);
    let t59 = (sin_chain_theta_8 * cos_chain_theta_9).sub_product(cos_chain_theta_8,
        sin_chain_theta_9);
    let t60 = (sin_chain_theta_8 * cos_chain_theta_10).sub_product(cos_chain_theta_8,
        sin_chain_theta_10);
    let t61 = (sin_chain_theta_9 * cos_chain_theta_10).sub_product(cos_chain_theta_9,
        sin_chain_theta_10);
    let t62 = R::literal(0.9) * t1;
    let t63 = R::literal(0.8) * t4;
    let t64 = R::literal(0.700_000_000_000_000_1) * t7;
    let t65 = R::literal(0.600_000_000_000_000_1) * t10;
    let t66 = R::literal(0.5) * t13;
    let t67 = R::literal(0.4) * t16;
    let t68 = R::literal(0.300_000_000_000_000_04) * t19;
    let t69 = R::literal(0.2) * t22;
    let t70 = t25 * R::literal(0.1);
    let t71 = R::literal(1.0) / R::literal(9.0).sub_product(t62, t2);
    let t72 = (R::literal(8.0) * (cos_chain_theta_2 * cos_chain_theta_3)
        .add_product(sin_chain_theta_2, sin_chain_theta_3)).sub_product(t63, t2);
    let t73 = t72 * t71;
    let t74 = (R::literal(7.0) * (cos_chain_theta_2 * cos_chain_theta_4)
        .add_product(sin_chain_theta_2, sin_chain_theta_4)).sub_product(t64, t2);
    let t75 = t74 * t71;
    let t76 = (R::literal(6.0) * (cos_chain_theta_2 * cos_chain_theta_5)
        .add_product(sin_chain_theta_2, sin_chain_theta_5)).sub_product(t65, t2);
    let t77 = t76 * t71;
    let t78 = (R::literal(5.0) * (cos_chain_theta_2 * cos_chain_theta_6)
        .add_product(sin_chain_theta_2, sin_chain_theta_6)).sub_product(t66, t2);
    let t79 = t78 * t71;
    let t80 = (R::literal(4.0) * (cos_chain_theta_2 * cos_chain_theta_7)
        .add_product(sin_chain_theta_2, sin_chain_theta_7)).sub_product(t67, t2);
    let t81 = t80 * t71;
    let t82 = (R::literal(3.0) * (cos_chain_theta_2 * cos_chain_theta_8)
        .add_product(sin_chain_theta_2, sin_chain_theta_8)).sub_product(t68, t2);
    let t83 = t82 * t71;
    let t84 = (R::literal(2.0) * (cos_chain_theta_2 * cos_chain_theta_9)
        .add_product(sin_chain_theta_2, sin_chain_theta_9)).sub_product(t69, t2);
    let t85 = t84 * t71;
    let t86 = (cos_chain_theta_2 * cos_chain_theta_10).add_product(sin_chain_theta_2,
        sin_chain_theta_10).sub_product(t70, t2);
    let t87 = t86 * t71;
    let t88 = R::literal(1.0) / R::literal(8.0).sub_product(t63, t5).sub_product(t73, t72);
    let t89 = (R::literal(7.0) * (cos_chain_theta_3 * cos_chain_theta_4)
        .add_product(sin_chain_theta_3, sin_chain_theta_4)).sub_product(t64, t5).sub_product(t75,
        t72);
    let t90 = t89 * t88;
    let t91 = (R::literal(6.0) * (cos_chain_theta_3 * cos_chain_theta_5)
        .add_product(sin_chain_theta_3, sin_chain_theta_5)).sub_product(t65, t5).sub_product(t77,
        t72);
    let t92 = t91 * t88;
    let t93 = (R::literal(5.0) * (cos_chain_theta_3 * cos_chain_theta_6)
        .add_product(sin_chain_theta_3, sin_chain_theta_6)).sub_product(t66, t5).sub_product(t79,
        t72);
    let t94 = t93 * t88;
    let t95 = (R::literal(4.0) * (cos_chain_theta_3 * cos_chain_theta_7)
        .add_product(sin_chain_theta_3, sin_chain_theta_7)).sub_product(t67, t5).sub_product(t81,
        t72);
    let t96 = t95 * t88;
    let t97 = (R::literal(3.0) * (cos_chain_theta_3 * cos_chain_theta_8)
        .add_product(sin_chain_theta_3, sin_chain_theta_8)).sub_product(t68, t5).sub_product(t83,
        t72);
    let t98 = t97 * t88;
    let t99 = (R::literal(2.0) * (cos_chain_theta_3 * cos_chain_theta_9)
        .add_product(sin_chain_theta_3, sin_chain_theta_9)).sub_product(t69, t5).sub_product(t85,
        t72);
    let t100 = t99 * t88;
    let t101 = (cos_chain_theta_3 * cos_chain_theta_10).add_product(sin_chain_theta_3,
        sin_chain_theta_10).sub_product(t70, t5).sub_product(t87, t72);
    let t102 = t101 * t88;
    let t103 = R::literal(1.0) / R::literal(7.0).sub_product(t64, t8).sub_product(t75, t74)
        .sub_product(t90, t89);
    let t104 = (R::literal(6.0) * (cos_chain_theta_4 * cos_chain_theta_5)
        .add_product(sin_chain_theta_4, sin_chain_theta_5)).sub_product(t65, t8).sub_product(t77,
        t74).sub_product(t92, t89);
    let t105 = t104 * t103;
    let t106 = (R::literal(5.0) * (cos_chain_theta_4 * cos_chain_theta_6)
        .add_product(sin_chain_theta_4, sin_chain_theta_6)).sub_product(t66, t8).sub_product(t79,
        t74).sub_product(t94, t89);
    let t107 = t106 * t103;
    let t108 = (R::literal(4.0) * (cos_chain_theta_4 * cos_chain_theta_7)
        .add_product(sin_chain_theta_4, sin_chain_theta_7)).sub_product(t67, t8).sub_product(t81,
        t74).sub_product(t96, t89);
    let t109 = t108 * t103;
    let t110 = (R::literal(3.0) * (cos_chain_theta_4 * cos_chain_theta_8)
        .add_product(sin_chain_theta_4, sin_chain_theta_8)).sub_product(t68, t8).sub_product(t83,
        t74).sub_product(t98, t89);
    let t111 = t110 * t103;
    let t112 = (R::literal(2.0) * (cos_chain_theta_4 * cos_chain_theta_9)
        .add_product(sin_chain_theta_4, sin_chain_theta_9)).sub_product(t69, t8).sub_product(t85,
        t74).sub_product(t100, t89);
    let t113 = t112 * t103;
    let t114 = (cos_chain_theta_4 * cos_chain_theta_10).add_product(sin_chain_theta_4,
        sin_chain_theta_10).sub_product(t70, t8).sub_product(t87, t74).sub_product(t102, t89);
    let t115 = t114 * t103;
    let t116 = R::literal(1.0) / R::literal(6.0).sub_product(t65, t11).sub_product(t77, t76)
        .sub_product(t92, t91).sub_product(t105, t104);
    let t117 = (R::literal(5.0) * (cos_chain_theta_5 * cos_chain_theta_6)
        .add_product(sin_chain_theta_5, sin_chain_theta_6)).sub_product(t66, t11).sub_product(t79,
        t76).sub_product(t94, t91).sub_product(t107, t104);
    let t118 = t117 * t116;
    let t119 = (R::literal(4.0) * (cos_chain_theta_5 * cos_chain_theta_7)
        .add_product(sin_chain_theta_5, sin_chain_theta_7)).sub_product(t67, t11).sub_product(t81,
        t76).sub_product(t96, t91).sub_product(t109, t104);
    let t120 = t119 * t116;
    let t121 = (R::literal(3.0) * (cos_chain_theta_5 * cos_chain_theta_8)
        .add_product(sin_chain_theta_5, sin_chain_theta_8)).sub_product(t68, t11).sub_product(t83,
        t76).sub_product(t98, t91).sub_product(t111, t104);
    let t122 = t121 * t116;
    let t123 = (R::literal(2.0) * (cos_chain_theta_5 * cos_chain_theta_9)
        .add_product(sin_chain_theta_5, sin_chain_theta_9)).sub_product(t69, t11).sub_product(t85,
        t76).sub_product(t100, t91).sub_product(t113, t104);
    let t124 = t123 * t116;
    let t125 = (cos_chain_theta_5 * cos_chain_theta_10).add_product(sin_chain_theta_5,
        sin_chain_theta_10).sub_product(t70, t11).sub_product(t87, t76).sub_product(t102, t91)
        .sub_product(t115, t104);
    let t126 = t125 * t116;
    let t127 = R::literal(1.0) / R::literal(5.0).sub_product(t66, t14).sub_product(t79, t78)
        .sub_product(t94, t93).sub_product(t107, t106).sub_product(t118, t117);
    let t128 = (R::literal(4.0) * (cos_chain_theta_6 * cos_chain_theta_7)
        .add_product(sin_chain_theta_6, sin_chain_theta_7)).sub_product(t67, t14).sub_product(t81,
        t78).sub_product(t96, t93).sub_product(t109, t106).sub_product(t120, t117);
    let t129 = t128 * t127;
    let t130 = (R::literal(3.0) * (cos_chain_theta_6 * cos_chain_theta_8)
        .add_product(sin_chain_theta_6, sin_chain_theta_8)).sub_product(t68, t14).sub_product(t83,
        t78).sub_product(t98, t93).sub_product(t111, t106).sub_product(t122, t117);
    let t131 = t130 * t127;
    let t132 = (R::literal(2.0) * (cos_chain_theta_6 * cos_chain_theta_9)
        .add_product(sin_chain_theta_6, sin_chain_theta_9)).sub_product(t69, t14).sub_product(t85,
        t78).sub_product(t100, t93).sub_product(t113, t106).sub_product(t124, t117);
    let t133 = t132 * t127;
    let t134 = (cos_chain_theta_6 * cos_chain_theta_10).add_product(sin_chain_theta_6,
        sin_chain_theta_10).sub_product(t70, t14).sub_product(t87, t78).sub_product(t102, t93)
        .sub_product(t115, t106).sub_product(t126, t117);
    let t135 = t134 * t127;
    let t136 = R::literal(1.0) / R::literal(4.0).sub_product(t67, t17).sub_product(t81, t80)
        .sub_product(t96, t95).sub_product(t109, t108).sub_product(t120, t119).sub_product(t129,
        t128);
    let t137 = (R::literal(3.0) * (cos_chain_theta_7 * cos_chain_theta_8)
        .add_product(sin_chain_theta_7, sin_chain_theta_8)).sub_product(t68, t17).sub_product(t83,
        t80).sub_product(t98, t95).sub_product(t111, t108).sub_product(t122, t119)
        .sub_product(t131, t128);
    let t138 = t137 * t136;
    let t139 = (R::literal(2.0) * (cos_chain_theta_7 * cos_chain_theta_9)
        .add_product(sin_chain_theta_7, sin_chain_theta_9)).sub_product(t69, t17).sub_product(t85,
        t80).sub_product(t100, t95).sub_product(t113, t108).sub_product(t124, t119)
        .sub_product(t133, t128);
    let t140 = t139 * t136;
    let t141 = (cos_chain_theta_7 * cos_chain_theta_10).add_product(sin_chain_theta_7,
        sin_chain_theta_10).sub_product(t70, t17).sub_product(t87, t80).sub_product(t102, t95)
        .sub_product(t115, t108).sub_product(t126, t119).sub_product(t135, t128);
    let t142 = t141 * t136;
    let t143 = R::literal(1.0) / R::literal(3.0).sub_product(t68, t20).sub_product(t83, t82)
        .sub_product(t98, t97).sub_product(t111, t110).sub_product(t122, t121).sub_product(t131,
        t130).sub_product(t138, t137);
    let t144 = (R::literal(2.0) * (cos_chain_theta_8 * cos_chain_theta_9)
        .add_product(sin_chain_theta_8, sin_chain_theta_9)).sub_product(t69, t20).sub_product(t85,
        t82).sub_product(t100, t97).sub_product(t113, t110).sub_product(t124, t121)
        .sub_product(t133, t130).sub_product(t140, t137);
    let t145 = t144 * t143;
    let t146 = (cos_chain_theta_8 * cos_chain_theta_10).add_product(sin_chain_theta_8,
        sin_chain_theta_10).sub_product(t70, t20).sub_product(t87, t82).sub_product(t102, t97)
        .sub_product(t115, t110).sub_product(t126, t121).sub_product(t135, t130).sub_product(t142,
        t137);
    let t147 = t146 * t143;
    let t148 = R::literal(1.0) / R::literal(2.0).sub_product(t69, t23).sub_product(t85, t84)
        .sub_product(t100, t99).sub_product(t113, t112).sub_product(t124, t123).sub_product(t133,
        t132).sub_product(t140, t139).sub_product(t145, t144);
    let t149 = (cos_chain_theta_9 * cos_chain_theta_10).add_product(sin_chain_theta_9,
        sin_chain_theta_10).sub_product(t70, t23).sub_product(t87, t84).sub_product(t102, t99)
        .sub_product(t115, t112).sub_product(t126, t123).sub_product(t135, t132).sub_product(t142,
        t139).sub_product(t147, t144);
    let t150 = t149 * t148;
    let chain_omega_2_squared = chain_omega_2 * chain_omega_2;
    let chain_omega_3_squared = chain_omega_3 * chain_omega_3;
    let t151 = R::literal(8.0) * chain_omega_3_squared;
    let chain_omega_4_squared = chain_omega_4 * chain_omega_4;
    let t152 = R::literal(7.0) * chain_omega_4_squared;
    let chain_omega_5_squared = chain_omega_5 * chain_omega_5;
    let t153 = R::literal(6.0) * chain_omega_5_squared;
    let chain_omega_6_squared = chain_omega_6 * chain_omega_6;
    let t154 = R::literal(5.0) * chain_omega_6_squared;
    let chain_omega_7_squared = chain_omega_7 * chain_omega_7;
    let t155 = R::literal(4.0) * chain_omega_7_squared;
    let chain_omega_8_squared = chain_omega_8 * chain_omega_8;
    let t156 = R::literal(3.0) * chain_omega_8_squared;
    let chain_omega_9_squared = chain_omega_9 * chain_omega_9;
    let t157 = R::literal(2.0) * chain_omega_9_squared;
    let chain_omega_10_squared = chain_omega_10 * chain_omega_10;
    let t158 = (R::literal(98.1) * sin_chain_theta_1).add_product(R::literal(9.0)
        * chain_omega_2_squared, t0).add_product(t151, t3).add_product(t152, t6).add_product(t153,
        t9).add_product(t154, t12).add_product(t155, t15).add_product(t156, t18).add_product(t157,
        t21).add_product(chain_omega_10_squared, t24);
    let chain_omega_1_squared = chain_omega_1 * chain_omega_1;
    let t159 = (R::literal(-88.29) * sin_chain_theta_2).add_product(R::literal(9.0)
        * chain_omega_1_squared, t0).sub_product(t151, t26).sub_product(t152, t27)
        .sub_product(t153, t28).sub_product(t154, t29).sub_product(t155, t30).sub_product(t156, t31)
        .sub_product(t157, t32).sub_product(chain_omega_10_squared, t33).add_product(t62, t158);
    let t160 = (R::literal(8.0) * chain_omega_1_squared * t3).add_product(R::literal(8.0)
        * chain_omega_2_squared, t26).sub_product(R::literal(78.48), sin_chain_theta_3)
        .sub_product(t152, t34).sub_product(t153, t35).sub_product(t154, t36).sub_product(t155, t37)
        .sub_product(t156, t38).sub_product(t157, t39).sub_product(chain_omega_10_squared, t40)
        .add_product(t63, t158).sub_product(t73, t159);
    let t161 = (R::literal(7.0) * chain_omega_1_squared * t6).add_product(R::literal(7.0)
        * chain_omega_2_squared, t27).add_product(R::literal(7.0) * chain_omega_3_squared, t34)
        .sub_product(R::literal(68.67), sin_chain_theta_4).sub_product(t153, t41).sub_product(t154,
        t42).sub_product(t155, t43).sub_product(t156, t44).sub_product(t157, t45)
        .sub_product(chain_omega_10_squared, t46).add_product(t64, t158).sub_product(t75, t159)
        .sub_product(t90, t160);
    let t162 = (R::literal(6.0) * chain_omega_1_squared * t9).add_product(R::literal(6.0)
        * chain_omega_2_squared, t28).add_product(R::literal(6.0) * chain_omega_3_squared, t35)
        .add_product(R::literal(6.0) * chain_omega_4_squared, t41).sub_product(R::literal(58.86),
        sin_chain_theta_5).sub_product(t154, t47).sub_product(t155, t48).sub_product(t156, t49)
        .sub_product(t157, t50).sub_product(chain_omega_10_squared, t51).add_product(t65, t158)
        .sub_product(t77, t159).sub_product(t92, t160).sub_product(t105, t161);
    let t163 = (R::literal(5.0) * chain_omega_1_squared * t12).add_product(R::literal(5.0)
        * chain_omega_2_squared, t29).add_product(R::literal(5.0) * chain_omega_3_squared, t36)
        .add_product(R::literal(5.0) * chain_omega_4_squared, t42).add_product(R::literal(5.0)
        * chain_omega_5_squared, t47).sub_product(R::literal(49.05), sin_chain_theta_6)
        .sub_product(t155, t52).sub_product(t156, t53).sub_product(t157, t54)
        .sub_product(chain_omega_10_squared, t55).add_product(t66, t158).sub_product(t79, t159)
        .sub_product(t94, t160).sub_product(t107, t161).sub_product(t118, t162);
    let t164 = (R::literal(4.0) * chain_omega_1_squared * t15).add_product(R::literal(4.0)
        * chain_omega_2_squared, t30).add_product(R::literal(4.0) * chain_omega_3_squared, t37)
        .add_product(R::literal(4.0) * chain_omega_4_squared, t43).add_product(R::literal(4.0)
        * chain_omega_5_squared, t48).add_product(R::literal(4.0) * chain_omega_6_squared, t52)
        .sub_product(R::literal(39.24), sin_chain_theta_7).sub_product(t156, t56).sub_product(t157,
        t57).sub_product(chain_omega_10_squared, t58).add_product(t67, t158).sub_product(t81, t159)
        .sub_product(t96, t160).sub_product(t109, t161).sub_product(t120, t162).sub_product(t129,
        t163);
    let t165 = (R::literal(3.0) * chain_omega_1_squared * t18).add_product(R::literal(3.0)
        * chain_omega_2_squared, t31).add_product(R::literal(3.0) * chain_omega_3_squared, t38)
        .add_product(R::literal(3.0) * chain_omega_4_squared, t44).add_product(R::literal(3.0)
        * chain_omega_5_squared, t49).add_product(R::literal(3.0) * chain_omega_6_squared, t53)
        .add_product(R::literal(3.0) * chain_omega_7_squared, t56).sub_product(R::literal(29.43),
        sin_chain_theta_8).sub_product(t157, t59).sub_product(chain_omega_10_squared, t60)
        .add_product(t68, t158).sub_product(t83, t159).sub_product(t98, t160).sub_product(t111,
        t161).sub_product(t122, t162).sub_product(t131, t163).sub_product(t138, t164);
    let t166 = (R::literal(2.0) * chain_omega_1_squared * t21).add_product(R::literal(2.0)
        * chain_omega_2_squared, t32).add_product(R::literal(2.0) * chain_omega_3_squared, t39)
        .add_product(R::literal(2.0) * chain_omega_4_squared, t45).add_product(R::literal(2.0)
        * chain_omega_5_squared, t50).add_product(R::literal(2.0) * chain_omega_6_squared, t54)
        .add_product(R::literal(2.0) * chain_omega_7_squared, t57).add_product(R::literal(2.0)
        * chain_omega_8_squared, t59).sub_product(R::literal(19.62), sin_chain_theta_9)
        .sub_product(chain_omega_10_squared, t61).add_product(t69, t158).sub_product(t85, t159)
        .sub_product(t100, t160).sub_product(t113, t161).sub_product(t124, t162).sub_product(t133,
        t163);
    let t167 = t166.sub_product(t140, t164).sub_product(t145, t165);
    let t168 = (chain_omega_1_squared * t24).add_product(chain_omega_2_squared, t33)
        .add_product(chain_omega_3_squared, t40).add_product(chain_omega_4_squared, t46)
        .add_product(chain_omega_5_squared, t51).add_product(chain_omega_6_squared, t55)
        .add_product(chain_omega_7_squared, t58).add_product(chain_omega_8_squared, t60)
        .add_product(chain_omega_9_squared, t61).sub_product(R::literal(9.81), sin_chain_theta_10)
        .add_product(t70, t158).sub_product(t87, t159).sub_product(t102, t160).sub_product(t115,
        t161).sub_product(t126, t162).sub_product(t135, t163).sub_product(t142, t164)
        .sub_product(t147, t165).sub_product(t150, t167);
    let chain_omega_10_dot = t168 * (R::literal(1.0) / R::literal(1.0).sub_product(t70, t25)
        .sub_product(t87, t86).sub_product(t102, t101).sub_product(t115, t114).sub_product(t126,
        t125).sub_product(t135, t134).sub_product(t142, t141).sub_product(t147, t146)
        .sub_product(t150, t149));
    let chain_omega_9_dot = (t167 * t148).sub_product(t150, chain_omega_10_dot);
    let chain_omega_8_dot = (t165 * t143).sub_product(t145, chain_omega_9_dot).sub_product(t147,
        chain_omega_10_dot);
    let chain_omega_7_dot = (t164 * t136).sub_product(t138, chain_omega_8_dot).sub_product(t140,
        chain_omega_9_dot).sub_product(t142, chain_omega_10_dot);
    let chain_omega_6_dot = (t163 * t127).sub_product(t129, chain_omega_7_dot).sub_product(t131,
        chain_omega_8_dot).sub_product(t133, chain_omega_9_dot).sub_product(t135,
        chain_omega_10_dot);
    let chain_omega_5_dot = (t162 * t116).sub_product(t118, chain_omega_6_dot).sub_product(t120,
        chain_omega_7_dot).sub_product(t122, chain_omega_8_dot).sub_product(t124, chain_omega_9_dot)
        .sub_product(t126, chain_omega_10_dot);
    let chain_omega_4_dot = (t161 * t103).sub_product(t105, chain_omega_5_dot).sub_product(t107,
        chain_omega_6_dot).sub_product(t109, chain_omega_7_dot).sub_product(t111, chain_omega_8_dot)
        .sub_product(t113, chain_omega_9_dot).sub_product(t115, chain_omega_10_dot);
    let chain_omega_3_dot = (t160 * t88).sub_product(t90, chain_omega_4_dot).sub_product(t92,
        chain_omega_5_dot).sub_product(t94, chain_omega_6_dot).sub_product(t96, chain_omega_7_dot)
        .sub_product(t98, chain_omega_8_dot).sub_product(t100, chain_omega_9_dot).sub_product(t102,
        chain_omega_10_dot);
    let chain_omega_2_dot = (t159 * t71).sub_product(t73, chain_omega_3_dot).sub_product(t75,
        chain_omega_4_dot).sub_product(t77, chain_omega_5_dot).sub_product(t79, chain_omega_6_dot)
        .sub_product(t81, chain_omega_7_dot).sub_product(t83, chain_omega_8_dot).sub_product(t85,
        chain_omega_9_dot).sub_product(t87, chain_omega_10_dot);
    let chain_omega_1_dot = (t158 * R::literal(-0.1)).sub_product(t62, chain_omega_2_dot)
        .sub_product(t63, chain_omega_3_dot).sub_product(t64, chain_omega_4_dot).sub_product(t65,
        chain_omega_5_dot).sub_product(t66, chain_omega_6_dot).sub_product(t67, chain_omega_7_dot)
        .sub_product(t68, chain_omega_8_dot).sub_product(t69, chain_omega_9_dot).sub_product(t70,
        chain_omega_10_dot);
    [chain_omega_1, chain_omega_2, chain_omega_3, chain_omega_4, chain_omega_5, chain_omega_6,
        chain_omega_7, chain_omega_8, chain_omega_9, chain_omega_10, chain_omega_1_dot,
        chain_omega_2_dot, chain_omega_3_dot, chain_omega_4_dot, chain_omega_5_dot,
        chain_omega_6_dot, chain_omega_7_dot, chain_omega_8_dot, chain_omega_9_dot,
        chain_omega_10_dot]
}

/// `M = d2L/dq'2`, values in the order of its pattern. 126 operations.
#[must_use]
pub fn mass_matrix<R: Real>(_time: R, state: &[R; STATES], _p: &Parameters<R>) -> [R; 100] {
    let [chain_theta_1, chain_theta_2, chain_theta_3, chain_theta_4, chain_theta_5, chain_theta_6,
        chain_theta_7, chain_theta_8, chain_theta_9, chain_theta_10, ..] = *state;
    let [(_, t0), (_, t1), (_, t2), (_, t3), (_, t4), (_, t5), (_, t6), (_, t7), (_, t8), (_, t9),
        (_, t10), (_, t11), (_, t12), (_, t13), (_, t14), (_, t15), (_, t16), (_, t17), (_, t18),
        (_, t19), (_, t20), (_, t21), (_, t22), (_, t23), (_, t24), (_, t25), (_, t26), (_, t27),
        (_, t28), (_, t29), (_, t30), (_, t31), (_, t32), (_, t33), (_, t34), (_, t35), (_, t36),
        (_, t37), (_, t38), (_, t39), (_, t40), (_, t41), (_, t42), (_, t43), (_, t44)]
        = R::sin_cos_each([chain_theta_1 - chain_theta_2, chain_theta_1 - chain_theta_3,
        chain_theta_1 - chain_theta_4, chain_theta_1 - chain_theta_5,
        chain_theta_1 - chain_theta_6, chain_theta_1 - chain_theta_7,
        chain_theta_1 - chain_theta_8, chain_theta_1 - chain_theta_9,
        chain_theta_1 - chain_theta_10, chain_theta_2 - chain_theta_3,
        chain_theta_2 - chain_theta_4, chain_theta_2 - chain_theta_5,
        chain_theta_2 - chain_theta_6, chain_theta_2 - chain_theta_7,
        chain_theta_2 - chain_theta_8, chain_theta_2 - chain_theta_9,
        chain_theta_2 - chain_theta_10, chain_theta_3 - chain_theta_4,
        chain_theta_3 - chain_theta_5, chain_theta_3 - chain_theta_6,
        chain_theta_3 - chain_theta_7, chain_theta_3 - chain_theta_8,
        chain_theta_3 - chain_theta_9, chain_theta_3 - chain_theta_10,
        chain_theta_4 - chain_theta_5, chain_theta_4 - chain_theta_6,
        chain_theta_4 - chain_theta_7, chain_theta_4 - chain_theta_8,
        chain_theta_4 - chain_theta_9, chain_theta_4 - chain_theta_10,
        chain_theta_5 - chain_theta_6, chain_theta_5 - chain_theta_7,
        chain_theta_5 - chain_theta_8, chain_theta_5 - chain_theta_9,
        chain_theta_5 - chain_theta_10, chain_theta_6 - chain_theta_7,
        chain_theta_6 - chain_theta_8, chain_theta_6 - chain_theta_9,
        chain_theta_6 - chain_theta_10, chain_theta_7 - chain_theta_8,
        chain_theta_7 - chain_theta_9, chain_theta_7 - chain_theta_10,
        chain_theta_8 - chain_theta_9, chain_theta_8 - chain_theta_10,
        chain_theta_9 - chain_theta_10]);
    let t45 = R::literal(9.0) * t0;
    let t46 = R::literal(8.0) * t1;
    let t47 = R::literal(7.0) * t2;
    let t48 = R::literal(6.0) * t3;
    let t49 = R::literal(5.0) * t4;
    let t50 = R::literal(4.0) * t5;
    let t51 = R::literal(3.0) * t6;
    let t52 = R::literal(2.0) * t7;
    let t53 = R::literal(8.0) * t9;
    let t54 = R::literal(7.0) * t10;
    let t55 = R::literal(6.0) * t11;
    let t56 = R::literal(5.0) * t12;
    let t57 = R::literal(4.0) * t13;
    let t58 = R::literal(3.0) * t14;
    let t59 = R::literal(2.0) * t15;
    let t60 = R::literal(7.0) * t17;
    let t61 = R::literal(6.0) * t18;
    let t62 = R::literal(5.0) * t19;
    let t63 = R::literal(4.0) * t20;
    let t64 = R::literal(3.0) * t21;
    let t65 = R::literal(2.0) * t22;
    let t66 = R::literal(6.0) * t24;
    let t67 = R::literal(5.0) * t25;
    let t68 = R::literal(4.0) * t26;
    let t69 = R::literal(3.0) * t27;
    let t70 = R::literal(2.0) * t28;
    let t71 = R::literal(5.0) * t30;
    let t72 = R::literal(4.0) * t31;
    let t73 = R::literal(3.0) * t32;
    let t74 = R::literal(2.0) * t33;
    let t75 = R::literal(4.0) * t35;
    let t76 = R::literal(3.0) * t36;
    let t77 = R::literal(2.0) * t37;
    let t78 = R::literal(3.0) * t39;
    let t79 = R::literal(2.0) * t40;
    let t80 = R::literal(2.0) * t42;
    [R::literal(10.0), t45, t46, t47, t48, t49, t50, t51, t52, t8, t45, R::literal(9.0), t53, t54,
        t55, t56, t57, t58, t59, t16, t46, t53, R::literal(8.0), t60, t61, t62, t63, t64, t65, t23,
        t47, t54, t60, R::literal(7.0), t66, t67, t68, t69, t70, t29, t48, t55, t61, t66,
        R::literal(6.0), t71, t72, t73, t74, t34, t49, t56, t62, t67, t71, R::literal(5.0), t75,
        t76, t77, t38, t50, t57, t63, t68, t72, t75, R::literal(4.0), t78, t79, t41, t51, t58, t64,
        t69, t73, t76, t78, R::literal(3.0), t80, t43, t52, t59, t65, t70, t74, t77, t79, t80,
        R::literal(2.0), t44, t8, t16, t23, t29, t34, t38, t41, t43, t44, R::literal(1.0)]
}

/// `f` of `M q'' = f + G^T lambda`, one for each coordinate. 344 operations.
#[must_use]
pub fn forcing<R: Real>(_time: R, state: &[R; STATES], _p: &Parameters<R>) -> [R; COORDINATES] {
    let [chain_theta_1, chain_theta_2, chain_theta_3, chain_theta_4, chain_theta_5, chain_theta_6,
        chain_theta_7, chain_theta_8, chain_theta_9, chain_theta_10, chain_omega_1, chain_omega_2,
        chain_omega_3, chain_omega_4, chain_omega_5, chain_omega_6, chain_omega_7, chain_omega_8,
        chain_omega_9, chain_omega_10] = *state;
    let [(sin_chain_theta_1, _), (sin_chain_theta_2, _), (sin_chain_theta_3, _),
        (sin_chain_theta_4, _), (sin_chain_theta_5, _), (sin_chain_theta_6, _), (sin_chain_theta_7,
        _), (sin_chain_theta_8, _), (sin_chain_theta_9, _), (sin_chain_theta_10, _), (t0, _),
        (t1, _), (t2, _), (t3, _), (t4, _), (t5, _), (t6, _), (t7, _), (t8, _), (t9, _), (t10, _),
        (t11, _), (t12, _), (t13, _), (t14, _), (t15, _), (t16, _), (t17, _), (t18, _), (t19, _),
        (t20, _), (t21, _), (t22, _), (t23, _), (t24, _), (t25, _), (t26, _), (t27, _), (t28, _),
        (t29, _), (t30, _), (t31, _), (t32, _), (t33, _), (t34, _), (t35, _), (t36, _), (t37, _),
        (t38, _), (t39, _), (t40, _), (t41, _), (t42, _), (t43, _), (t44, _)]
        = R::sin_cos_each([chain_theta_1, chain_theta_2, chain_theta_3, chain_theta_4,
        chain_theta_5, chain_theta_6, chain_theta_7, chain_theta_8, chain_theta_9, chain_theta_10,
        chain_theta_1 - chain_theta_2, chain_theta_1 - chain_theta_3,
        chain_theta_1 - chain_theta_4, chain_theta_1 - chain_theta_5,
        chain_theta_1 - chain_theta_6, chain_theta_1 - chain_theta_7,
        chain_theta_1 - chain_theta_8, chain_theta_1 - chain_theta_9,
        chain_theta_1 - chain_theta_10, chain_theta_2 - chain_theta_3,
        chain_theta_2 - chain_theta_4, chain_theta_2 - chain_theta_5,
        chain_theta_2 - chain_theta_6, chain_theta_2 - chain_theta_7,
        chain_theta_2 - chain_theta_8, chain_theta_2 - chain_theta_9,
        chain_theta_2 - chain_theta_10, chain_theta_3 - chain_theta_4,
        chain_theta_3 - chain_theta_5, chain_theta_3 - chain_theta_6,
        chain_theta_3 - chain_theta_7, chain_theta_3 - chain_theta_8,
        chain_theta_3 - chain_theta_9, chain_theta_3 - chain_theta_10,
        chain_theta_4 - chain_theta_5, chain_theta_4 - chain_theta_6,
        chain_theta_4 - chain_theta_7, chain_theta_4 - chain_theta_8,
        chain_theta_4 - chain_theta_9, chain_theta_4 - chain_theta_10,
        chain_theta_5 - chain_theta_6, chain_theta_5 - chain_theta_7,
        chain_theta_5 - chain_theta_8, chain_theta_5 - chain_theta_9,
        chain_theta_5 - chain_theta_10, chain_theta_6 - chain_theta_7,
        chain_theta_6 - chain_theta_8, chain_theta_6 - chain_theta_9,
        chain_theta_6 - chain_theta_10, chain_theta_7 - chain_theta_8,
        chain_theta_7 - chain_theta_9, chain_theta_7 - chain_theta_10,
        chain_theta_8 - chain_theta_9, chain_theta_8 - chain_theta_10,
        chain_theta_9 - chain_theta_10]);
    let chain_omega_2_squared = chain_omega_2 * chain_omega_2;
    let chain_omega_3_squared = chain_omega_3 * chain_omega_3;
    let t45 = R::literal(8.0) * chain_omega_3_squared;
    let chain_omega_4_squared = chain_omega_4 * chain_omega_4;
    let t46 = R::literal(7.0) * chain_omega_4_squared;
    let chain_omega_5_squared = chain_omega_5 * chain_omega_5;
    let t47 = R::literal(6.0) * chain_omega_5_squared;
    let chain_omega_6_squared = chain_omega_6 * chain_omega_6;
    let t48 = R::literal(5.0) * chain_omega_6_squared;
    let chain_omega_7_squared = chain_omega_7 * chain_omega_7;
    let t49 = R::literal(4.0) * chain_omega_7_squared;
    let chain_omega_8_squared = chain_omega_8 * chain_omega_8;
    let t50 = R::literal(3.0) * chain_omega_8_squared;
    let chain_omega_9_squared = chain_omega_9 * chain_omega_9;
    let t51 = R::literal(2.0) * chain_omega_9_squared;
    let chain_omega_10_squared = chain_omega_10 * chain_omega_10;
    let chain_theta_1_forcing = (R::literal(-98.1) * sin_chain_theta_1).sub_product(R::literal(9.0)
        * chain_omega_2_squared, t0).sub_product(t45, t1).sub_product(t46, t2).sub_product(t47, t3)
        .sub_product(t48, t4).sub_product(t49, t5).sub_product(t50, t6).sub_product(t51, t7)
        .sub_product(chain_omega_10_squared, t8);
    let chain_omega_1_squared = chain_omega_1 * chain_omega_1;
    let chain_theta_2_forcing = (R::literal(-88.29) * sin_chain_theta_2)
        .add_product(R::literal(9.0) * chain_omega_1_squared, t0).sub_product(t45, t9)
        .sub_product(t46, t10).sub_product(t47, t11).sub_product(t48, t12).sub_product(t49, t13)
        .sub_product(t50, t14).sub_product(t51, t15).sub_product(chain_omega_10_squared, t16);
    let chain_theta_3_forcing = (R::literal(8.0) * chain_omega_1_squared * t1)
        .add_product(R::literal(8.0) * chain_omega_2_squared, t9).sub_product(R::literal(78.48),
        sin_chain_theta_3).sub_product(t46, t17).sub_product(t47, t18).sub_product(t48, t19)
        .sub_product(t49, t20).sub_product(t50, t21).sub_product(t51, t22)
        .sub_product(chain_omega_10_squared, t23);
    let chain_theta_4_forcing = (R::literal(7.0) * chain_omega_1_squared * t2)
        .add_product(R::literal(7.0) * chain_omega_2_squared, t10).add_product(R::literal(7.0)
        * chain_omega_3_squared, t17).sub_product(R::literal(68.67), sin_chain_theta_4)
        .sub_product(t47, t24).sub_product(t48, t25).sub_product(t49, t26).sub_product(t50, t27)
        .sub_product(t51, t28).sub_product(chain_omega_10_squared, t29);
    let chain_theta_5_forcing = (R::literal(6.0) * chain_omega_1_squared * t3)
        .add_product(R::literal(6.0) * chain_omega_2_squared, t11).add_product(R::literal(6.0)
        * chain_omega_3_squared, t18).add_product(R::literal(6.0) * chain_omega_4_squared, t24)
        .sub_product(R::literal(58.86), sin_chain_theta_5).sub_product(t48, t30).sub_product(t49,
        t31).sub_product(t50, t32).sub_product(t51, t33).sub_product(chain_omega_10_squared, t34);
    let chain_theta_6_forcing = (R::literal(5.0) * chain_omega_1_squared * t4)
        .add_product(R::literal(5.0) * chain_omega_2_squared, t12).add_product(R::literal(5.0)
        * chain_omega_3_squared, t19).add_product(R::literal(5.0) * chain_omega_4_squared, t25)
        .add_product(R::literal(5.0) * chain_omega_5_squared, t30).sub_product(R::literal(49.05),
        sin_chain_theta_6).sub_product(t49, t35).sub_product(t50, t36).sub_product(t51, t37)
        .sub_product(chain_omega_10_squared, t38);
    let chain_theta_7_forcing = (R::literal(4.0) * chain_omega_1_squared * t5)
        .add_product(R::literal(4.0) * chain_omega_2_squared, t13).add_product(R::literal(4.0)
        * chain_omega_3_squared, t20).add_product(R::literal(4.0) * chain_omega_4_squared, t26)
        .add_product(R::literal(4.0) * chain_omega_5_squared, t31).add_product(R::literal(4.0)
        * chain_omega_6_squared, t35).sub_product(R::literal(39.24), sin_chain_theta_7)
        .sub_product(t50, t39).sub_product(t51, t40).sub_product(chain_omega_10_squared, t41);
    let chain_theta_8_forcing = (R::literal(3.0) * chain_omega_1_squared * t6)
        .add_product(R::literal(3.0) * chain_omega_2_squared, t14).add_product(R::literal(3.0)
        * chain_omega_3_squared, t21).add_product(R::literal(3.0) * chain_omega_4_squared, t27)
        .add_product(R::literal(3.0) * chain_omega_5_squared, t32).add_product(R::literal(3.0)
        * chain_omega_6_squared, t36).add_product(R::literal(3.0) * chain_omega_7_squared, t39)
        .sub_product(R::literal(29.43), sin_chain_theta_8).sub_product(t51, t42)
        .sub_product(chain_omega_10_squared, t43);
    let chain_theta_9_forcing = (R::literal(2.0) * chain_omega_1_squared * t7)
        .add_product(R::literal(2.0) * chain_omega_2_squared, t15).add_product(R::literal(2.0)
        * chain_omega_3_squared, t22).add_product(R::literal(2.0) * chain_omega_4_squared, t28)
        .add_product(R::literal(2.0) * chain_omega_5_squared, t33).add_product(R::literal(2.0)
        * chain_omega_6_squared, t37).add_product(R::literal(2.0) * chain_omega_7_squared, t40)
        .add_product(R::literal(2.0) * chain_omega_8_squared, t42).sub_product(R::literal(19.62),
        sin_chain_theta_9).sub_product(chain_omega_10_squared, t44);
    let chain_theta_10_forcing = (chain_omega_1_squared * t8).add_product(chain_omega_2_squared,
        t16).add_product(chain_omega_3_squared, t23).add_product(chain_omega_4_squared, t29)
        .add_product(chain_omega_5_squared, t34).add_product(chain_omega_6_squared, t38)
        .add_product(chain_omega_7_squared, t41).add_product(chain_omega_8_squared, t43)
        .add_product(chain_omega_9_squared, t44).sub_product(R::literal(9.81), sin_chain_theta_10);
    [chain_theta_1_forcing, chain_theta_2_forcing, chain_theta_3_forcing, chain_theta_4_forcing,
        chain_theta_5_forcing, chain_theta_6_forcing, chain_theta_7_forcing, chain_theta_8_forcing,
        chain_theta_9_forcing, chain_theta_10_forcing]
}

/// `dy'/dy`, values in the order of its pattern. 738 operations.
#[must_use]
pub fn rate_jacobian<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>) -> [R; 210] {
    let [_, _, _, _, _, _, _, _, _, _, chain_omega_1, chain_omega_2, chain_omega_3, chain_omega_4,
        chain_omega_5, chain_omega_6, chain_omega_7, chain_omega_8, chain_omega_9, chain_omega_10]
        = *state;
    let m = &motion(time, state, p);
    let chain_omega_2_squared = chain_omega_2 * chain_omega_2;
    let chain_omega_3_squared = chain_omega_3 * chain_omega_3;
    let t0 = R::literal(8.0) * chain_omega_3_squared;
    let chain_omega_4_squared = chain_omega_4 * chain_omega_4;
    let t1 = R::literal(7.0) * chain_omega_4_squared;
    let chain_omega_5_squared = chain_omega_5 * chain_omega_5;
    let t2 = R::literal(6.0) * chain_omega_5_squared;
    let chain_omega_6_squared = chain_omega_6 * chain_omega_6;
    let t3 = R::literal(5.0) * chain_omega_6_squared;
    let chain_omega_7_squared = chain_omega_7 * chain_omega_7;
    let t4 = R::literal(4.0) * chain_omega_7_squared;
    let chain_omega_8_squared = chain_omega_8 * chain_omega_8;
    let t5 = R::literal(3.0) * chain_omega_8_squared;
    let chain_omega_9_squared = chain_omega_9 * chain_omega_9;
    let t6 = R::literal(2.0) * chain_omega_9_squared;
    let chain_omega_10_squared = chain_omega_10 * chain_omega_10;
    let chain_omega_1_squared = chain_omega_1 * chain_omega_1;
    let t7 = R::literal(9.0) * chain_omega_2_squared * m.t1;
    let t8 = t0 * m.t4;
    let t9 = t1 * m.t7;
    let t10 = t2 * m.t10;
    let t11 = t3 * m.t13;
    let t12 = t4 * m.t16;
    let t13 = t5 * m.t19;
    let t14 = t6 * m.t22;
    let t15 = chain_omega_10_squared * m.t25;
    let t16 = R::literal(9.0) * chain_omega_1_squared * m.t1;
    let t17 = R::literal(8.0) * chain_omega_1_squared * m.t4;
    let t18 = R::literal(7.0) * chain_omega_1_squared * m.t7;
    let t19 = R::literal(6.0) * chain_omega_1_squared * m.t10;
    let t20 = R::literal(5.0) * chain_omega_1_squared * m.t13;
    let t21 = R::literal(4.0) * chain_omega_1_squared * m.t16;
    let t22 = R::literal(3.0) * chain_omega_1_squared * m.t19;
    let t23 = R::literal(2.0) * chain_omega_1_squared * m.t22;
    let t24 = chain_omega_1_squared * m.t25;
    let t25 = R::literal(9.0) * m.t0;
    let t26 = t25 * m.chain_omega_2_dot;
    let t27 = t25 * m.t205;
    let t28 = R::literal(8.0) * m.t3;
    let t29 = t28 * m.chain_omega_3_dot;
    let t30 = t28 * m.t205;
    let t31 = R::literal(7.0) * m.t6;
    let t32 = t31 * m.chain_omega_4_dot;
    let t33 = t31 * m.t205;
    let t34 = R::literal(6.0) * m.t9;
    let t35 = t34 * m.chain_omega_5_dot;
    let t36 = t34 * m.t205;
    let t37 = R::literal(5.0) * m.t12;
    let t38 = t37 * m.chain_omega_6_dot;
    let t39 = t37 * m.t205;
    let t40 = R::literal(4.0) * m.t15;
    let t41 = t40 * m.chain_omega_7_dot;
    let t42 = t40 * m.t205;
    let t43 = R::literal(3.0) * m.t18;
    let t44 = t43 * m.chain_omega_8_dot;
    let t45 = t43 * m.t205;
    let t46 = R::literal(2.0) * m.t21;
    let t47 = t46 * m.chain_omega_9_dot;
    let t48 = t46 * m.t205;
    let t49 = m.t24 * m.chain_omega_10_dot;
    let t50 = m.t24 * m.t205;
    let t51 = t0 * m.t27;
    let t52 = t1 * m.t29;
    let t53 = t2 * m.t31;
    let t54 = t3 * m.t33;
    let t55 = t4 * m.t35;
    let t56 = t5 * m.t37;
    let t57 = t6 * m.t39;
    let t58 = chain_omega_10_squared * m.t41;
    let t59 = R::literal(8.0) * chain_omega_2_squared * m.t27;
    let t60 = R::literal(7.0) * chain_omega_2_squared * m.t29;
    let t61 = R::literal(6.0) * chain_omega_2_squared * m.t31;
    let t62 = R::literal(5.0) * chain_omega_2_squared * m.t33;
    let t63 = R::literal(4.0) * chain_omega_2_squared * m.t35;
    let t64 = R::literal(3.0) * chain_omega_2_squared * m.t37;
    let t65 = R::literal(2.0) * chain_omega_2_squared * m.t39;
    let t66 = chain_omega_2_squared * m.t41;
    let t67 = R::literal(8.0) * m.t26;
    let t68 = t67 * m.chain_omega_3_dot;
    let t69 = t67 * m.chain_omega_2_dot;
    let t70 = R::literal(7.0) * m.t28;
    let t71 = t70 * m.chain_omega_4_dot;
    let t72 = t70 * m.chain_omega_2_dot;
    let t73 = R::literal(6.0) * m.t30;
    let t74 = t73 * m.chain_omega_5_dot;
    let t75 = t73 * m.chain_omega_2_dot;
    let t76 = R::literal(5.0) * m.t32;
    let t77 = t76 * m.chain_omega_6_dot;
    let t78 = t76 * m.chain_omega_2_dot;
    let t79 = R::literal(4.0) * m.t34;
    let t80 = t79 * m.chain_omega_7_dot;
    let t81 = t79 * m.chain_omega_2_dot;
    let t82 = R::literal(3.0) * m.t36;
    let t83 = t82 * m.chain_omega_8_dot;
    let t84 = t82 * m.chain_omega_2_dot;
    let t85 = R::literal(2.0) * m.t38;
    let t86 = t85 * m.chain_omega_9_dot;
    let t87 = t85 * m.chain_omega_2_dot;
    let t88 = m.t40 * m.chain_omega_10_dot;
    let t89 = m.t40 * m.chain_omega_2_dot;
    let t90 = t1 * m.t43;
    let t91 = t2 * m.t45;
    let t92 = t3 * m.t47;
    let t93 = t4 * m.t49;
    let t94 = t5 * m.t51;
    let t95 = t6 * m.t53;
    let t96 = chain_omega_10_squared * m.t55;
    let t97 = R::literal(7.0) * chain_omega_3_squared * m.t43;
    let t98 = R::literal(6.0) * chain_omega_3_squared * m.t45;
    let t99 = R::literal(5.0) * chain_omega_3_squared * m.t47;
    let t100 = R::literal(4.0) * chain_omega_3_squared * m.t49;
    let t101 = R::literal(3.0) * chain_omega_3_squared * m.t51;
    let t102 = R::literal(2.0) * chain_omega_3_squared * m.t53;
    let t103 = chain_omega_3_squared * m.t55;
    let t104 = R::literal(7.0) * m.t42;
    let t105 = t104 * m.chain_omega_4_dot;
    let t106 = t104 * m.chain_omega_3_dot;
    let t107 = R::literal(6.0) * m.t44;
    let t108 = t107 * m.chain_omega_5_dot;
    let t109 = t107 * m.chain_omega_3_dot;
    let t110 = R::literal(5.0) * m.t46;
    let t111 = t110 * m.chain_omega_6_dot;
    let t112 = t110 * m.chain_omega_3_dot;
    let t113 = R::literal(4.0) * m.t48;
    let t114 = t113 * m.chain_omega_7_dot;
    let t115 = t113 * m.chain_omega_3_dot;
    let t116 = R::literal(3.0) * m.t50;
    let t117 = t116 * m.chain_omega_8_dot;
    let t118 = t116 * m.chain_omega_3_dot;
    let t119 = R::literal(2.0) * m.t52;
    let t120 = t119 * m.chain_omega_9_dot;
    let t121 = t119 * m.chain_omega_3_dot;
    let t122 = m.t54 * m.chain_omega_10_dot;
    let t123 = m.t54 * m.chain_omega_3_dot;
    let t124 = t2 * m.t57;
    let t125 = t3 * m.t59;
    let t126 = t4 * m.t61;
    let t127 = t5 * m.t63;
    let t128 = t6 * m.t65;
    let t129 = chain_omega_10_squared * m.t67;
    let t130 = R::literal(6.0) * chain_omega_4_squared * m.t57;
    let t131 = R::literal(5.0) * chain_omega_4_squared * m.t59;
    let t132 = R::literal(4.0) * chain_omega_4_squared * m.t61;
    let t133 = R::literal(3.0) * chain_omega_4_squared * m.t63;
    let t134 = R::literal(2.0) * chain_omega_4_squared * m.t65;
    let t135 = chain_omega_4_squared * m.t67;
    let t136 = R::literal(6.0) * m.t56;
    let t137 = t136 * m.chain_omega_5_dot;
    let t138 = t136 * m.chain_omega_4_dot;
    let t139 = R::literal(5.0) * m.t58;
    let t140 = t139 * m.chain_omega_6_dot;
    let t141 = t139 * m.chain_omega_4_dot;
    let t142 = R::literal(4.0) * m.t60;
    let t143 = t142 * m.chain_omega_7_dot;
    let t144 = t142 * m.chain_omega_4_dot;
    let t145 = R::literal(3.0) * m.t62;
    let t146 = t145 * m.chain_omega_8_dot;
    let t147 = t145 * m.chain_omega_4_dot;
    let t148 = R::literal(2.0) * m.t64;
    let t149 = t148 * m.chain_omega_9_dot;
    let t150 = t148 * m.chain_omega_4_dot;
    let t151 = m.t66 * m.chain_omega_10_dot;
    let t152 = m.t66 * m.chain_omega_4_dot;
    let t153 = t3 * m.t69;
    let t154 = t4 * m.t71;
    let t155 = t5 * m.t73;
    let t156 = t6 * m.t75;
    let t157 = chain_omega_10_squared * m.t77;
    let t158 = R::literal(5.0) * chain_omega_5_squared * m.t69;
    let t159 = R::literal(4.0) * chain_omega_5_squared * m.t71;
    let t160 = R::literal(3.0) * chain_omega_5_squared * m.t73;
    let t161 = R::literal(2.0) * chain_omega_5_squared * m.t75;
    let t162 = chain_omega_5_squared * m.t77;
    let t163 = R::literal(5.0) * m.t68;
    let t164 = t163 * m.chain_omega_6_dot;
    let t165 = t163 * m.chain_omega_5_dot;
    let t166 = R::literal(4.0) * m.t70;
    let t167 = t166 * m.chain_omega_7_dot;
    let t168 = t166 * m.chain_omega_5_dot;
    let t169 = R::literal(3.0) * m.t72;
    let t170 = t169 * m.chain_omega_8_dot;
    let t171 = t169 * m.chain_omega_5_dot;
    let t172 = R::literal(2.0) * m.t74;
    let t173 = t172 * m.chain_omega_9_dot;
    let t174 = t172 * m.chain_omega_5_dot;
    let t175 = m.t76 * m.chain_omega_10_dot;
    let t176 = m.t76 * m.chain_omega_5_dot;
    let t177 = t4 * m.t79;
    let t178 = t5 * m.t81;
    let t179 = t6 * m.t83;
    let t180 = chain_omega_10_squared * m.t85;
    let t181 = R::literal(4.0) * chain_omega_6_squared * m.t79;
    let t182 = R::literal(3.0) * chain_omega_6_squared * m.t81;
    let t183 = R::literal(2.0) * chain_omega_6_squared * m.t83;
    let t184 = chain_omega_6_squared * m.t85;
    let t185 = R::literal(4.0) * m.t78;
    let t186 = t185 * m.chain_omega_7_dot;
    let t187 = t185 * m.chain_omega_6_dot;
    let t188 = R::literal(3.0) * m.t80;
    let t189 = t188 * m.chain_omega_8_dot;
    let t190 = t188 * m.chain_omega_6_dot;
    let t191 = R::literal(2.0) * m.t82;
    let t192 = t191 * m.chain_omega_9_dot;
    let t193 = t191 * m.chain_omega_6_dot;
    let t194 = m.t84 * m.chain_omega_10_dot;
    let t195 = m.t84 * m.chain_omega_6_dot;
    let t196 = t5 * m.t87;
    let t197 = t6 * m.t89;
    let t198 = chain_omega_10_squared * m.t91;
    let t199 = R::literal(3.0) * chain_omega_7_squared * m.t87;
    let t200 = R::literal(2.0) * chain_omega_7_squared * m.t89;
    let t201 = chain_omega_7_squared * m.t91;
    let t202 = R::literal(3.0) * m.t86;
    let t203 = t202 * m.chain_omega_8_dot;
    let t204 = t202 * m.chain_omega_7_dot;
    let t205 = R::literal(2.0) * m.t88;
    let t206 = t205 * m.chain_omega_9_dot;
    let t207 = t205 * m.chain_omega_7_dot;
    let t208 = m.t90 * m.chain_omega_10_dot;
    let t209 = m.t90 * m.chain_omega_7_dot;
    let t210 = t6 * m.t93;
    let t211 = chain_omega_10_squared * m.t95;
    let t212 = R::literal(2.0) * chain_omega_8_squared * m.t93;
    let t213 = chain_omega_8_squared * m.t95;
    let t214 = R::literal(2.0) * m.t92;
    let t215 = t214 * m.chain_omega_9_dot;
    let t216 = t214 * m.chain_omega_8_dot;
    let t217 = m.t94 * m.chain_omega_10_dot;
    let t218 = m.t94 * m.chain_omega_8_dot;
    let t219 = chain_omega_10_squared * m.t97;
    let t220 = chain_omega_9_squared * m.t97;
    let t221 = m.t96 * m.chain_omega_10_dot;
    let t222 = m.t96 * m.chain_omega_9_dot;
    let t223 = R::literal(16.0) * chain_omega_3;
    let t224 = R::literal(14.0) * chain_omega_4;
    let t225 = R::literal(12.0) * chain_omega_5;
    let t226 = R::literal(10.0) * chain_omega_6;
    let t227 = R::literal(8.0) * chain_omega_7;
    let t228 = R::literal(6.0) * chain_omega_8;
    let t229 = R::literal(4.0) * chain_omega_9;
    let t230 = R::literal(2.0) * chain_omega_10;
    let mut x = [[R::literal(0.0); 20]; 10];
    x[0][0] = t26 - (t7.add_product(R::literal(98.1), m.cos_chain_theta_1) + t8 + t9 + t10 + t11
        + t12 + t13 + t14 + t15) + t29 + t32 + t35 + t38 + t41 + t44 + t47 + t49;
    x[1][0] = t16 - t27;
    x[2][0] = t17 - t30;
    x[3][0] = t18 - t33;
    x[4][0] = t19 - t36;
    x[5][0] = t20 - t39;
    x[6][0] = t21 - t42;
    x[7][0] = t22 - t45;
    x[8][0] = t23 - t48;
    x[9][0] = t24 - t50;
    x[0][1] = t7 - t26;
    x[1][1] = t27 - (t16.add_product(R::literal(88.29), m.cos_chain_theta_2) + t51 + t52 + t53
        + t54 + t55 + t56 + t57 + t58) + t68 + t71 + t74 + t77 + t80 + t83 + t86 + t88;
    x[2][1] = t59 + t69;
    x[3][1] = t60 + t72;
    x[4][1] = t61 + t75;
    x[5][1] = t62 + t78;
    x[6][1] = t63 + t81;
    x[7][1] = t64 + t84;
    x[8][1] = t65 + t87;
    x[9][1] = t66 + t89;
    x[0][2] = t8 - t29;
    x[1][2] = t51 - t68;
    x[2][2] = t30 - (t17.add_product(R::literal(78.48), m.cos_chain_theta_3) + t59 + t90 + t91
        + t92 + t93 + t94 + t95 + t96) - t69 + t105 + t108 + t111 + t114 + t117 + t120 + t122;
    x[3][2] = t97 + t106;
    x[4][2] = t98 + t109;
    x[5][2] = t99 + t112;
    x[6][2] = t100 + t115;
    x[7][2] = t101 + t118;
    x[8][2] = t102 + t121;
    x[9][2] = t103 + t123;
    x[0][3] = t9 - t32;
    x[1][3] = t52 - t71;
    x[2][3] = t90 - t105;
    x[3][3] = t33 - (t18.add_product(R::literal(68.67), m.cos_chain_theta_4) + t60 + t97 + t124
        + t125 + t126 + t127 + t128 + t129) - t72 - t106 + t137 + t140 + t143 + t146 + t149 + t151;
    x[4][3] = t130 + t138;
    x[5][3] = t131 + t141;
    x[6][3] = t132 + t144;
    x[7][3] = t133 + t147;
    x[8][3] = t134 + t150;
    x[9][3] = t135 + t152;
    x[0][4] = t10 - t35;
    x[1][4] = t53 - t74;
    x[2][4] = t91 - t108;
    x[3][4] = t124 - t137;
    x[4][4] = t36 - (t19.add_product(R::literal(58.86), m.cos_chain_theta_5) + t61 + t98 + t130
        + t153 + t154 + t155 + t156 + t157) - t75 - t109 - t138 + t164 + t167 + t170 + t173 + t175;
    x[5][4] = t158 + t165;
    x[6][4] = t159 + t168;
    x[7][4] = t160 + t171;
    x[8][4] = t161 + t174;
    x[9][4] = t162 + t176;
    x[0][5] = t11 - t38;
    x[1][5] = t54 - t77;
    x[2][5] = t92 - t111;
    x[3][5] = t125 - t140;
    x[4][5] = t153 - t164;
    x[5][5] = t39 - (t20.add_product(R::literal(49.05), m.cos_chain_theta_6) + t62 + t99 + t131
        + t158 + t177 + t178 + t179 + t180) - t78 - t112 - t141 - t165 + t186 + t189 + t192 + t194;
    x[6][5] = t181 + t187;
    x[7][5] = t182 + t190;
    x[8][5] = t183 + t193;
    x[9][5] = t184 + t195;
    x[0][6] = t12 - t41;
    x[1][6] = t55 - t80;
    x[2][6] = t93 - t114;
    x[3][6] = t126 - t143;
    x[4][6] = t154 - t167;
    x[5][6] = t177 - t186;
    x[6][6] = t42 - (t21.add_product(R::literal(39.24), m.cos_chain_theta_7) + t63 + t100 + t132
        + t159 + t181 + t196 + t197 + t198) - t81 - t115 - t144 - t168 - t187 + t203 + t206 + t208;
    x[7][6] = t199 + t204;
    x[8][6] = t200 + t207;
    x[9][6] = t201 + t209;
    x[0][7] = t13 - t44;
    x[1][7] = t56 - t83;
    x[2][7] = t94 - t117;
    x[3][7] = t127 - t146;
    x[4][7] = t155 - t170;
    x[5][7] = t178 - t189;
    x[6][7] = t196 - t203;
    x[7][7] = t45 - (t22.add_product(R::literal(29.43), m.cos_chain_theta_8) + t64 + t101 + t133
        + t160 + t182 + t199 + t210 + t211) - t84 - t118 - t147 - t171 - t190 - t204 + t215 + t217;
    x[8][7] = t212 + t216;
    x[9][7] = t213 + t218;
    x[0][8] = t14 - t47;
    x[1][8] = t57 - t86;
    x[2][8] = t95 - t120;
    x[3][8] = t128 - t149;
    x[4][8] = t156 - t173;
    x[5][8] = t179 - t192;
    x[6][8] = t197 - t206;
    x[7][8] = t210 - t215;
    x[8][8] = t48 - (t23.add_product(R::literal(19.62), m.cos_chain_theta_9) + t65 + t102 + t134
        + t161 + t183 + t200 + t212 + t219) - t87 - t121 - t150 - t174 - t193 - t207 - t216 + t221;
    x[9][8] = t220 + t222;
    x[0][9] = t15 - t49;
    x[1][9] = t58 - t88;
    x[2][9] = t96 - t122;
    x[3][9] = t129 - t151;
    x[4][9] = t157 - t175;
    x[5][9] = t180 - t194;
    x[6][9] = t198 - t208;
    x[7][9] = t211 - t217;
    x[8][9] = t219 - t221;
    x[9][9] = t50 - (t24.add_product(R::literal(9.81), m.cos_chain_theta_10) + t66 + t103 + t135
        + t162 + t184 + t201 + t213 + t220) - t89 - t123 - t152 - t176 - t195 - t209 - t218 - t222;
    x[1][10] = R::literal(18.0) * chain_omega_1 * m.t0;
    x[2][10] = R::literal(16.0) * chain_omega_1 * m.t3;
    x[3][10] = R::literal(14.0) * chain_omega_1 * m.t6;
    x[4][10] = R::literal(12.0) * chain_omega_1 * m.t9;
    x[5][10] = R::literal(10.0) * chain_omega_1 * m.t12;
    x[6][10] = R::literal(8.0) * chain_omega_1 * m.t15;
    x[7][10] = R::literal(6.0) * chain_omega_1 * m.t18;
    x[8][10] = R::literal(4.0) * chain_omega_1 * m.t21;
    x[9][10] = R::literal(2.0) * chain_omega_1 * m.t24;
    x[0][11] = R::literal(-18.0) * chain_omega_2 * m.t0;
    x[2][11] = R::literal(16.0) * chain_omega_2 * m.t26;
    x[3][11] = R::literal(14.0) * chain_omega_2 * m.t28;
    x[4][11] = R::literal(12.0) * chain_omega_2 * m.t30;
    x[5][11] = R::literal(10.0) * chain_omega_2 * m.t32;
    x[6][11] = R::literal(8.0) * chain_omega_2 * m.t34;
    x[7][11] = R::literal(6.0) * chain_omega_2 * m.t36;
    x[8][11] = R::literal(4.0) * chain_omega_2 * m.t38;
    x[9][11] = R::literal(2.0) * chain_omega_2 * m.t40;
    x[0][12] = -(t223 * m.t3);
    x[1][12] = -(t223 * m.t26);
    x[3][12] = R::literal(14.0) * chain_omega_3 * m.t42;
    x[4][12] = R::literal(12.0) * chain_omega_3 * m.t44;
    x[5][12] = R::literal(10.0) * chain_omega_3 * m.t46;
    x[6][12] = R::literal(8.0) * chain_omega_3 * m.t48;
    x[7][12] = R::literal(6.0) * chain_omega_3 * m.t50;
    x[8][12] = R::literal(4.0) * chain_omega_3 * m.t52;
    x[9][12] = R::literal(2.0) * chain_omega_3 * m.t54;
    x[0][13] = -(t224 * m.t6);
    x[1][13] = -(t224 * m.t28);
    x[2][13] = -(t224 * m.t42);
    x[4][13] = R::literal(12.0) * chain_omega_4 * m.t56;
    x[5][13] = R::literal(10.0) * chain_omega_4 * m.t58;
    x[6][13] = R::literal(8.0) * chain_omega_4 * m.t60;
    x[7][13] = R::literal(6.0) * chain_omega_4 * m.t62;
    x[8][13] = R::literal(4.0) * chain_omega_4 * m.t64;
    x[9][13] = R::literal(2.0) * chain_omega_4 * m.t66;
    x[0][14] = -(t225 * m.t9);
    x[1][14] = -(t225 * m.t30);
    x[2][14] = -(t225 * m.t44);
    x[3][14] = -(t225 * m.t56);
    x[5][14] = R::literal(10.0) * chain_omega_5 * m.t68;
    x[6][14] = R::literal(8.0) * chain_omega_5 * m.t70;
    x[7][14] = R::literal(6.0) * chain_omega_5 * m.t72;
    x[8][14] = R::literal(4.0) * chain_omega_5 * m.t74;
    x[9][14] = R::literal(2.0) * chain_omega_5 * m.t76;
    x[0][15] = -(t226 * m.t12);
    x[1][15] = -(t226 * m.t32);
    x[2][15] = -(t226 * m.t46);
    x[3][15] = -(t226 * m.t58);
    x[4][15] = -(t226 * m.t68);
    x[6][15] = R::literal(8.0) * chain_omega_6 * m.t78;
    x[7][15] = R::literal(6.0) * chain_omega_6 * m.t80;
    x[8][15] = R::literal(4.0) * chain_omega_6 * m.t82;
    x[9][15] = R::literal(2.0) * chain_omega_6 * m.t84;
    x[0][16] = -(t227 * m.t15);
    x[1][16] = -(t227 * m.t34);
    x[2][16] = -(t227 * m.t48);
    x[3][16] = -(t227 * m.t60);
    x[4][16] = -(t227 * m.t70);
    x[5][16] = -(t227 * m.t78);
    x[7][16] = R::literal(6.0) * chain_omega_7 * m.t86;
    x[8][16] = R::literal(4.0) * chain_omega_7 * m.t88;
    x[9][16] = R::literal(2.0) * chain_omega_7 * m.t90;
    x[0][17] = -(t228 * m.t18);
    x[1][17] = -(t228 * m.t36);
    x[2][17] = -(t228 * m.t50);
    x[3][17] = -(t228 * m.t62);
    x[4][17] = -(t228 * m.t72);
    x[5][17] = -(t228 * m.t80);
    x[6][17] = -(t228 * m.t86);
    x[8][17] = R::literal(4.0) * chain_omega_8 * m.t92;
    x[9][17] = R::literal(2.0) * chain_omega_8 * m.t94;
    x[0][18] = -(t229 * m.t21);
    x[1][18] = -(t229 * m.t38);
    x[2][18] = -(t229 * m.t52);
    x[3][18] = -(t229 * m.t64);
    x[4][18] = -(t229 * m.t74);
    x[5][18] = -(t229 * m.t82);
    x[6][18] = -(t229 * m.t88);
    x[7][18] = -(t229 * m.t92);
    x[9][18] = R::literal(2.0) * chain_omega_9 * m.t96;
    x[0][19] = -(t230 * m.t24);
    x[1][19] = -(t230 * m.t40);
    x[2][19] = -(t230 * m.t54);
    x[3][19] = -(t230 * m.t66);
    x[4][19] = -(t230 * m.t76);
    x[5][19] = -(t230 * m.t84);
    x[6][19] = -(t230 * m.t90);
    x[7][19] = -(t230 * m.t94);
    x[8][19] = -(t230 * m.t96);
    substitute(RATE_JACOBIAN_STEPS.iter().copied(), &m.factors, &mut x);
    [R::literal(1.0), R::literal(1.0), R::literal(1.0), R::literal(1.0), R::literal(1.0),
        R::literal(1.0), R::literal(1.0), R::literal(1.0), R::literal(1.0), R::literal(1.0),
        x[0][0], x[0][1], x[0][2], x[0][3], x[0][4], x[0][5], x[0][6], x[0][7], x[0][8], x[0][9],
        x[0][10], x[0][11], x[0][12], x[0][13], x[0][14], x[0][15], x[0][16], x[0][17], x[0][18],
        x[0][19], x[1][0], x[1][1], x[1][2], x[1][3], x[1][4], x[1][5], x[1][6], x[1][7], x[1][8],
        x[1][9], x[1][10], x[1][11], x[1][12], x[1][13], x[1][14], x[1][15], x[1][16], x[1][17],
        x[1][18], x[1][19], x[2][0], x[2][1], x[2][2], x[2][3], x[2][4], x[2][5], x[2][6], x[2][7],
        x[2][8], x[2][9], x[2][10], x[2][11], x[2][12], x[2][13], x[2][14], x[2][15], x[2][16],
        x[2][17], x[2][18], x[2][19], x[3][0], x[3][1], x[3][2], x[3][3], x[3][4], x[3][5],
        x[3][6], x[3][7], x[3][8], x[3][9], x[3][10], x[3][11], x[3][12], x[3][13], x[3][14],
        x[3][15], x[3][16], x[3][17], x[3][18], x[3][19], x[4][0], x[4][1], x[4][2], x[4][3],
        x[4][4], x[4][5], x[4][6], x[4][7], x[4][8], x[4][9], x[4][10], x[4][11], x[4][12],
        x[4][13], x[4][14], x[4][15], x[4][16], x[4][17], x[4][18], x[4][19], x[5][0], x[5][1],
        x[5][2], x[5][3], x[5][4], x[5][5], x[5][6], x[5][7], x[5][8], x[5][9], x[5][10], x[5][11],
        x[5][12], x[5][13], x[5][14], x[5][15], x[5][16], x[5][17], x[5][18], x[5][19], x[6][0],
        x[6][1], x[6][2], x[6][3], x[6][4], x[6][5], x[6][6], x[6][7], x[6][8], x[6][9], x[6][10],
        x[6][11], x[6][12], x[6][13], x[6][14], x[6][15], x[6][16], x[6][17], x[6][18], x[6][19],
        x[7][0], x[7][1], x[7][2], x[7][3], x[7][4], x[7][5], x[7][6], x[7][7], x[7][8], x[7][9],
        x[7][10], x[7][11], x[7][12], x[7][13], x[7][14], x[7][15], x[7][16], x[7][17], x[7][18],
        x[7][19], x[8][0], x[8][1], x[8][2], x[8][3], x[8][4], x[8][5], x[8][6], x[8][7], x[8][8],
        x[8][9], x[8][10], x[8][11], x[8][12], x[8][13], x[8][14], x[8][15], x[8][16], x[8][17],
        x[8][18], x[8][19], x[9][0], x[9][1], x[9][2], x[9][3], x[9][4], x[9][5], x[9][6], x[9][7],
        x[9][8], x[9][9], x[9][10], x[9][11], x[9][12], x[9][13], x[9][14], x[9][15], x[9][16],
        x[9][17], x[9][18], x[9][19]]
}

static RATE_JACOBIAN_STEPS: &[Step<'static>] = &[Step::less(1, &[(0, 0)]), Step::less(2,
    &[(1, 0), (2, 1)]), Step::less(3, &[(3, 0), (4, 1), (5, 2)]), Step::less(4, &[(6, 0), (7, 1),
    (8, 2), (9, 3)]), Step::less(5, &[(10, 0), (11, 1), (12, 2), (13, 3), (14, 4)]), Step::less(6,
    &[(15, 0), (16, 1), (17, 2), (18, 3), (19, 4), (20, 5)]), Step::less(7, &[(21, 0), (22, 1),
    (23, 2), (24, 3), (25, 4), (26, 5), (27, 6)]), Step::less(8, &[(28, 0), (29, 1), (30, 2),
    (31, 3), (32, 4), (33, 5), (34, 6), (35, 7)]), Step::less(9, &[(36, 0), (37, 1), (38, 2),
    (39, 3), (40, 4), (41, 5), (42, 6), (43, 7), (44, 8)]), Step::scaled(9, 45, &[]),
    Step::scaled(8, 46, &[(44, 9)]), Step::scaled(7, 47, &[(35, 8), (43, 9)]), Step::scaled(6, 48,
    &[(27, 7), (34, 8), (42, 9)]), Step::scaled(5, 49, &[(20, 6), (26, 7), (33, 8), (41, 9)]),
    Step::scaled(4, 50, &[(14, 5), (19, 6), (25, 7), (32, 8), (40, 9)]), Step::scaled(3, 51,
    &[(9, 4), (13, 5), (18, 6), (24, 7), (31, 8), (39, 9)]), Step::scaled(2, 52, &[(5, 3), (8, 4),
    (12, 5), (17, 6), (23, 7), (30, 8), (38, 9)]), Step::scaled(1, 53, &[(2, 2), (4, 3), (7, 4),
    (11, 5), (16, 6), (22, 7), (29, 8), (37, 9)]), Step::scaled(0, 54, &[(0, 1), (1, 2), (3, 3),
    (6, 4), (10, 5), (15, 6), (21, 7), (28, 8), (36, 9)])];
/// `dy'/dp`, values in the order of its pattern. No operations.
#[must_use]
pub fn parameter_jacobian<R: Real>(_time: R, _state: &[R; STATES], _p: &Parameters<R>) -> [R; 0] {
    []
}

/// Partial derivative of `y'` with respect to time. No operations.
#[must_use]
pub fn time_derivative<R: Real>(_time: R, _state: &[R; STATES], _p: &Parameters<R>) -> [R; STATES] {
    [R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0),
        R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0),
        R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0),
        R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0)]
}

/// Wanted outputs. No operations.
#[must_use]
pub fn outputs<R: Real>(_time: R, state: &[R; STATES], _p: &Parameters<R>) -> Outputs<R> {
    let [chain_theta_1, chain_theta_2, chain_theta_3, chain_theta_4, chain_theta_5, chain_theta_6,
        chain_theta_7, chain_theta_8, chain_theta_9, chain_theta_10, chain_omega_1, chain_omega_2,
        chain_omega_3, chain_omega_4, chain_omega_5, chain_omega_6, chain_omega_7, chain_omega_8,
        chain_omega_9, chain_omega_10] = *state;
    Outputs {
        theta_1: chain_theta_1,
        theta_2: chain_theta_2,
        theta_3: chain_theta_3,
        theta_4: chain_theta_4,
        theta_5: chain_theta_5,
        theta_6: chain_theta_6,
        theta_7: chain_theta_7,
        theta_8: chain_theta_8,
        theta_9: chain_theta_9,
        theta_10: chain_theta_10,
        omega_1: chain_omega_1,
        omega_2: chain_omega_2,
        omega_3: chain_omega_3,
        omega_4: chain_omega_4,
        omega_5: chain_omega_5,
        omega_6: chain_omega_6,
        omega_7: chain_omega_7,
        omega_8: chain_omega_8,
        omega_9: chain_omega_9,
        omega_10: chain_omega_10,
    }
}

/// T, V and the energy of first-order states \[J\]. 117 operations.
#[must_use]
pub fn energy<R: Real>(_time: R, state: &[R; STATES], _p: &Parameters<R>) -> Energy<R> {
    let [chain_theta_1, chain_theta_2, chain_theta_3, chain_theta_4, chain_theta_5, chain_theta_6,
        chain_theta_7, chain_theta_8, chain_theta_9, chain_theta_10, chain_omega_1, chain_omega_2,
        chain_omega_3, chain_omega_4, chain_omega_5, chain_omega_6, chain_omega_7, chain_omega_8,
        chain_omega_9, chain_omega_10] = *state;
    let [(sin_chain_theta_1, cos_chain_theta_1), (sin_chain_theta_2, cos_chain_theta_2),
        (sin_chain_theta_3, cos_chain_theta_3), (sin_chain_theta_4, cos_chain_theta_4),
        (sin_chain_theta_5, cos_chain_theta_5), (sin_chain_theta_6, cos_chain_theta_6),
        (sin_chain_theta_7, cos_chain_theta_7), (sin_chain_theta_8, cos_chain_theta_8),
        (sin_chain_theta_9, cos_chain_theta_9), (sin_chain_theta_10, cos_chain_theta_10)]
        = R::sin_cos_each([chain_theta_1, chain_theta_2, chain_theta_3, chain_theta_4,
        chain_theta_5, chain_theta_6, chain_theta_7, chain_theta_8, chain_theta_9, chain_theta_10]);
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
    let chain_u_6 = chain_u_5.add_product(chain_omega_6, cos_chain_theta_6);
    let chain_v_6 = chain_v_5.add_product(chain_omega_6, sin_chain_theta_6);
    let chain_u_7 = chain_u_6.add_product(chain_omega_7, cos_chain_theta_7);
    let chain_v_7 = chain_v_6.add_product(chain_omega_7, sin_chain_theta_7);
    let chain_u_8 = chain_u_7.add_product(chain_omega_8, cos_chain_theta_8);
    let chain_v_8 = chain_v_7.add_product(chain_omega_8, sin_chain_theta_8);
    let chain_u_9 = chain_u_8.add_product(chain_omega_9, cos_chain_theta_9);
    let chain_v_9 = chain_v_8.add_product(chain_omega_9, sin_chain_theta_9);
    let chain_u_10 = chain_u_9.add_product(chain_omega_10, cos_chain_theta_10);
    let chain_v_10 = chain_v_9.add_product(chain_omega_10, sin_chain_theta_10);
    Energy {
        kinetic: R::literal(0.5) * (chain_u_1 * chain_u_1).add_product(chain_v_1, chain_v_1)
            .add_product(chain_u_2, chain_u_2).add_product(chain_v_2, chain_v_2)
            .add_product(chain_u_3, chain_u_3).add_product(chain_v_3, chain_v_3)
            .add_product(chain_u_4, chain_u_4).add_product(chain_v_4, chain_v_4)
            .add_product(chain_u_5, chain_u_5).add_product(chain_v_5, chain_v_5)
            .add_product(chain_u_6, chain_u_6).add_product(chain_v_6, chain_v_6)
            .add_product(chain_u_7, chain_u_7).add_product(chain_v_7, chain_v_7)
            .add_product(chain_u_8, chain_u_8).add_product(chain_v_8, chain_v_8)
            .add_product(chain_u_9, chain_u_9).add_product(chain_v_9, chain_v_9)
            .add_product(chain_u_10, chain_u_10).add_product(chain_v_10, chain_v_10),
        potential: R::literal(-9.81) * ((R::literal(10.0) * cos_chain_theta_1)
            .add_product(R::literal(9.0), cos_chain_theta_2).add_product(R::literal(8.0),
            cos_chain_theta_3).add_product(R::literal(7.0), cos_chain_theta_4)
            .add_product(R::literal(6.0), cos_chain_theta_5).add_product(R::literal(5.0),
            cos_chain_theta_6).add_product(R::literal(4.0), cos_chain_theta_7)
            .add_product(R::literal(3.0), cos_chain_theta_8).add_product(R::literal(2.0),
            cos_chain_theta_9) + cos_chain_theta_10),
        stored: R::literal(0.0),
    }
}

/// `dE/dt`, power supplied and power dissipated \[W\]. 652 operations.
#[must_use]
pub fn power_balance<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>) -> PowerBalance<R> {
    let [_, _, _, _, _, _, _, _, _, _, chain_omega_1, chain_omega_2, chain_omega_3, chain_omega_4,
        chain_omega_5, chain_omega_6, chain_omega_7, chain_omega_8, chain_omega_9, chain_omega_10]
        = *state;
    let m = &motion(time, state, p);
    let chain_u_1 = chain_omega_1 * m.cos_chain_theta_1;
    let chain_v_1 = chain_omega_1 * m.sin_chain_theta_1;
    let chain_u_2 = chain_u_1.add_product(chain_omega_2, m.cos_chain_theta_2);
    let chain_v_2 = chain_v_1.add_product(chain_omega_2, m.sin_chain_theta_2);
    let chain_u_3 = chain_u_2.add_product(chain_omega_3, m.cos_chain_theta_3);
    let chain_v_3 = chain_v_2.add_product(chain_omega_3, m.sin_chain_theta_3);
    let chain_u_4 = chain_u_3.add_product(chain_omega_4, m.cos_chain_theta_4);
    let chain_v_4 = chain_v_3.add_product(chain_omega_4, m.sin_chain_theta_4);
    let chain_u_5 = chain_u_4.add_product(chain_omega_5, m.cos_chain_theta_5);
    let chain_v_5 = chain_v_4.add_product(chain_omega_5, m.sin_chain_theta_5);
    let chain_u_6 = chain_u_5.add_product(chain_omega_6, m.cos_chain_theta_6);
    let chain_v_6 = chain_v_5.add_product(chain_omega_6, m.sin_chain_theta_6);
    let chain_u_7 = chain_u_6.add_product(chain_omega_7, m.cos_chain_theta_7);
    let chain_v_7 = chain_v_6.add_product(chain_omega_7, m.sin_chain_theta_7);
    let chain_u_8 = chain_u_7.add_product(chain_omega_8, m.cos_chain_theta_8);
    let chain_v_8 = chain_v_7.add_product(chain_omega_8, m.sin_chain_theta_8);
    let chain_u_9 = chain_u_8.add_product(chain_omega_9, m.cos_chain_theta_9);
    let chain_v_9 = chain_v_8.add_product(chain_omega_9, m.sin_chain_theta_9);
    let chain_u_10 = chain_u_9.add_product(chain_omega_10, m.cos_chain_theta_10);
    let chain_v_10 = chain_v_9.add_product(chain_omega_10, m.sin_chain_theta_10);
    let t0 = R::literal(2.0) * chain_omega_2;
    let t1 = R::literal(2.0) * chain_omega_3;
    let t2 = R::literal(2.0) * chain_omega_4;
    let t3 = R::literal(2.0) * chain_omega_5;
    let t4 = R::literal(2.0) * chain_omega_6;
    let t5 = R::literal(2.0) * chain_omega_7;
    let t6 = R::literal(2.0) * chain_omega_8;
    let t7 = R::literal(2.0) * chain_omega_9;
    let t8 = R::literal(2.0) * chain_omega_10;
    let t9 = R::literal(2.0) * chain_v_1;
    let t10 = R::literal(2.0) * chain_u_1;
    let t11 = (R::literal(98.1) * m.sin_chain_theta_1).add_product(R::literal(0.5),
        (t10 * chain_v_2).add_product(t10, chain_v_3).add_product(t10, chain_v_4).add_product(t10,
        chain_v_5).add_product(t10, chain_v_6).add_product(t10, chain_v_7).add_product(t10,
        chain_v_8).add_product(t10, chain_v_9).add_product(t10, chain_v_10).sub_product(t9,
        chain_u_2).sub_product(t9, chain_u_3).sub_product(t9, chain_u_4).sub_product(t9, chain_u_5)
        .sub_product(t9, chain_u_6).sub_product(t9, chain_u_7).sub_product(t9, chain_u_8)
        .sub_product(t9, chain_u_9).sub_product(t9, chain_u_10)) * chain_omega_1;
    let t12 = (t0 * chain_v_2 * m.cos_chain_theta_2).add_product(t0 * chain_v_3,
        m.cos_chain_theta_2).add_product(t0 * chain_v_4, m.cos_chain_theta_2).add_product(t0
        * chain_v_5, m.cos_chain_theta_2).add_product(t0 * chain_v_6, m.cos_chain_theta_2)
        .add_product(t0 * chain_v_7, m.cos_chain_theta_2).add_product(t0 * chain_v_8,
        m.cos_chain_theta_2).add_product(t0 * chain_v_9, m.cos_chain_theta_2).add_product(t0
        * chain_v_10, m.cos_chain_theta_2).sub_product(t0 * chain_u_2, m.sin_chain_theta_2)
        .sub_product(t0 * chain_u_3, m.sin_chain_theta_2).sub_product(t0 * chain_u_4,
        m.sin_chain_theta_2);
    let t13 = t11.add_product((R::literal(88.29) * m.sin_chain_theta_2)
        .add_product(R::literal(0.5), t12.sub_product(t0 * chain_u_5, m.sin_chain_theta_2)
        .sub_product(t0 * chain_u_6, m.sin_chain_theta_2).sub_product(t0 * chain_u_7,
        m.sin_chain_theta_2).sub_product(t0 * chain_u_8, m.sin_chain_theta_2).sub_product(t0
        * chain_u_9, m.sin_chain_theta_2).sub_product(t0 * chain_u_10, m.sin_chain_theta_2)),
        chain_omega_2);
    let t14 = (t1 * chain_v_3 * m.cos_chain_theta_3).add_product(t1 * chain_v_4,
        m.cos_chain_theta_3).add_product(t1 * chain_v_5, m.cos_chain_theta_3).add_product(t1
        * chain_v_6, m.cos_chain_theta_3).add_product(t1 * chain_v_7, m.cos_chain_theta_3)
        .add_product(t1 * chain_v_8, m.cos_chain_theta_3).add_product(t1 * chain_v_9,
        m.cos_chain_theta_3).add_product(t1 * chain_v_10, m.cos_chain_theta_3).sub_product(t1
        * chain_u_3, m.sin_chain_theta_3).sub_product(t1 * chain_u_4, m.sin_chain_theta_3)
        .sub_product(t1 * chain_u_5, m.sin_chain_theta_3).sub_product(t1 * chain_u_6,
        m.sin_chain_theta_3);
    let t15 = (t2 * chain_v_4 * m.cos_chain_theta_4).add_product(t2 * chain_v_5,
        m.cos_chain_theta_4).add_product(t2 * chain_v_6, m.cos_chain_theta_4).add_product(t2
        * chain_v_7, m.cos_chain_theta_4).add_product(t2 * chain_v_8, m.cos_chain_theta_4)
        .add_product(t2 * chain_v_9, m.cos_chain_theta_4).add_product(t2 * chain_v_10,
        m.cos_chain_theta_4).sub_product(t2 * chain_u_4, m.sin_chain_theta_4).sub_product(t2
        * chain_u_5, m.sin_chain_theta_4).sub_product(t2 * chain_u_6, m.sin_chain_theta_4)
        .sub_product(t2 * chain_u_7, m.sin_chain_theta_4).sub_product(t2 * chain_u_8,
        m.sin_chain_theta_4);
    let t16 = (t3 * chain_v_5 * m.cos_chain_theta_5).add_product(t3 * chain_v_6,
        m.cos_chain_theta_5).add_product(t3 * chain_v_7, m.cos_chain_theta_5).add_product(t3
        * chain_v_8, m.cos_chain_theta_5).add_product(t3 * chain_v_9, m.cos_chain_theta_5)
        .add_product(t3 * chain_v_10, m.cos_chain_theta_5).sub_product(t3 * chain_u_5,
        m.sin_chain_theta_5).sub_product(t3 * chain_u_6, m.sin_chain_theta_5).sub_product(t3
        * chain_u_7, m.sin_chain_theta_5).sub_product(t3 * chain_u_8, m.sin_chain_theta_5)
        .sub_product(t3 * chain_u_9, m.sin_chain_theta_5).sub_product(t3 * chain_u_10,
        m.sin_chain_theta_5);
    let t17 = (R::literal(49.05) * m.sin_chain_theta_6).add_product(R::literal(0.5),
        (t4 * chain_v_6 * m.cos_chain_theta_6).add_product(t4 * chain_v_7, m.cos_chain_theta_6)
        .add_product(t4 * chain_v_8, m.cos_chain_theta_6).add_product(t4 * chain_v_9,
        m.cos_chain_theta_6).add_product(t4 * chain_v_10, m.cos_chain_theta_6).sub_product(t4
        * chain_u_6, m.sin_chain_theta_6).sub_product(t4 * chain_u_7, m.sin_chain_theta_6)
        .sub_product(t4 * chain_u_8, m.sin_chain_theta_6).sub_product(t4 * chain_u_9,
        m.sin_chain_theta_6).sub_product(t4 * chain_u_10, m.sin_chain_theta_6));
    let t18 = t13.add_product((R::literal(78.48) * m.sin_chain_theta_3)
        .add_product(R::literal(0.5), t14.sub_product(t1 * chain_u_7, m.sin_chain_theta_3)
        .sub_product(t1 * chain_u_8, m.sin_chain_theta_3).sub_product(t1 * chain_u_9,
        m.sin_chain_theta_3).sub_product(t1 * chain_u_10, m.sin_chain_theta_3)), chain_omega_3)
        .add_product((R::literal(68.67) * m.sin_chain_theta_4).add_product(R::literal(0.5), t15
        .sub_product(t2 * chain_u_9, m.sin_chain_theta_4).sub_product(t2 * chain_u_10,
        m.sin_chain_theta_4)), chain_omega_4).add_product((R::literal(58.86) * m.sin_chain_theta_5)
        .add_product(R::literal(0.5), t16), chain_omega_5).add_product(t17, chain_omega_6);
    let t19 = t18.add_product((R::literal(39.24) * m.sin_chain_theta_7)
        .add_product(R::literal(0.5), (t5 * chain_v_7 * m.cos_chain_theta_7).add_product(t5
        * chain_v_8, m.cos_chain_theta_7).add_product(t5 * chain_v_9, m.cos_chain_theta_7)
        .add_product(t5 * chain_v_10, m.cos_chain_theta_7).sub_product(t5 * chain_u_7,
        m.sin_chain_theta_7).sub_product(t5 * chain_u_8, m.sin_chain_theta_7).sub_product(t5
        * chain_u_9, m.sin_chain_theta_7).sub_product(t5 * chain_u_10, m.sin_chain_theta_7)),
        chain_omega_7);
    let t20 = t19.add_product((R::literal(29.43) * m.sin_chain_theta_8)
        .add_product(R::literal(0.5), (t6 * chain_v_8 * m.cos_chain_theta_8).add_product(t6
        * chain_v_9, m.cos_chain_theta_8).add_product(t6 * chain_v_10, m.cos_chain_theta_8)
        .sub_product(t6 * chain_u_8, m.sin_chain_theta_8).sub_product(t6 * chain_u_9,
        m.sin_chain_theta_8).sub_product(t6 * chain_u_10, m.sin_chain_theta_8)), chain_omega_8);
    let t21 = R::literal(2.0) * chain_u_2;
    let t22 = R::literal(2.0) * chain_v_2;
    let t23 = R::literal(2.0) * chain_u_3;
    let t24 = R::literal(2.0) * chain_v_3;
    let t25 = R::literal(2.0) * chain_u_4;
    let t26 = R::literal(2.0) * chain_v_4;
    let t27 = R::literal(2.0) * chain_u_5;
    let t28 = R::literal(2.0) * chain_v_5;
    let t29 = R::literal(2.0) * chain_u_6;
    let t30 = R::literal(2.0) * chain_v_6;
    let t31 = R::literal(2.0) * chain_u_7;
    let t32 = R::literal(2.0) * chain_v_7;
    let t33 = R::literal(2.0) * chain_u_8;
    let t34 = R::literal(2.0) * chain_v_8;
    let t35 = R::literal(2.0) * chain_u_9;
    let t36 = R::literal(2.0) * chain_v_9;
    let t37 = R::literal(2.0) * chain_u_10;
    let t38 = R::literal(2.0) * chain_v_10;
    let t39 = R::literal(0.5) * (t10 * m.cos_chain_theta_1).add_product(t9, m.sin_chain_theta_1)
        .add_product(t21, m.cos_chain_theta_1).add_product(t22, m.sin_chain_theta_1)
        .add_product(t23, m.cos_chain_theta_1).add_product(t24, m.sin_chain_theta_1)
        .add_product(t25, m.cos_chain_theta_1).add_product(t26, m.sin_chain_theta_1)
        .add_product(t27, m.cos_chain_theta_1).add_product(t28, m.sin_chain_theta_1)
        .add_product(t29, m.cos_chain_theta_1).add_product(t30, m.sin_chain_theta_1)
        .add_product(t31, m.cos_chain_theta_1).add_product(t32, m.sin_chain_theta_1)
        .add_product(t33, m.cos_chain_theta_1).add_product(t34, m.sin_chain_theta_1)
        .add_product(t35, m.cos_chain_theta_1).add_product(t36, m.sin_chain_theta_1)
        .add_product(t37, m.cos_chain_theta_1).add_product(t38, m.sin_chain_theta_1);
    let t40 = R::literal(0.5) * (t21 * m.cos_chain_theta_2).add_product(t22, m.sin_chain_theta_2)
        .add_product(t23, m.cos_chain_theta_2).add_product(t24, m.sin_chain_theta_2)
        .add_product(t25, m.cos_chain_theta_2).add_product(t26, m.sin_chain_theta_2)
        .add_product(t27, m.cos_chain_theta_2).add_product(t28, m.sin_chain_theta_2)
        .add_product(t29, m.cos_chain_theta_2).add_product(t30, m.sin_chain_theta_2)
        .add_product(t31, m.cos_chain_theta_2).add_product(t32, m.sin_chain_theta_2)
        .add_product(t33, m.cos_chain_theta_2).add_product(t34, m.sin_chain_theta_2)
        .add_product(t35, m.cos_chain_theta_2).add_product(t36, m.sin_chain_theta_2)
        .add_product(t37, m.cos_chain_theta_2).add_product(t38, m.sin_chain_theta_2);
    let t41 = t20.add_product((R::literal(19.62) * m.sin_chain_theta_9)
        .add_product(R::literal(0.5), (t7 * chain_v_9 * m.cos_chain_theta_9).add_product(t7
        * chain_v_10, m.cos_chain_theta_9).sub_product(t7 * chain_u_9, m.sin_chain_theta_9)
        .sub_product(t7 * chain_u_10, m.sin_chain_theta_9)), chain_omega_9)
        .add_product((R::literal(9.81) * m.sin_chain_theta_10).add_product(R::literal(0.5),
        (t8 * chain_v_10 * m.cos_chain_theta_10).sub_product(t8 * chain_u_10,
        m.sin_chain_theta_10)), chain_omega_10).sub_product(t39, m.t205).add_product(t40,
        m.chain_omega_2_dot);
    let t42 = t41.add_product(R::literal(0.5) * (t23 * m.cos_chain_theta_3).add_product(t24,
        m.sin_chain_theta_3).add_product(t25, m.cos_chain_theta_3).add_product(t26,
        m.sin_chain_theta_3).add_product(t27, m.cos_chain_theta_3).add_product(t28,
        m.sin_chain_theta_3).add_product(t29, m.cos_chain_theta_3).add_product(t30,
        m.sin_chain_theta_3).add_product(t31, m.cos_chain_theta_3).add_product(t32,
        m.sin_chain_theta_3).add_product(t33, m.cos_chain_theta_3).add_product(t34,
        m.sin_chain_theta_3).add_product(t35, m.cos_chain_theta_3).add_product(t36,
        m.sin_chain_theta_3).add_product(t37, m.cos_chain_theta_3).add_product(t38,
        m.sin_chain_theta_3), m.chain_omega_3_dot);
    let t43 = t42.add_product(R::literal(0.5) * (t25 * m.cos_chain_theta_4).add_product(t26,
        m.sin_chain_theta_4).add_product(t27, m.cos_chain_theta_4).add_product(t28,
        m.sin_chain_theta_4).add_product(t29, m.cos_chain_theta_4).add_product(t30,
        m.sin_chain_theta_4).add_product(t31, m.cos_chain_theta_4).add_product(t32,
        m.sin_chain_theta_4).add_product(t33, m.cos_chain_theta_4).add_product(t34,
        m.sin_chain_theta_4).add_product(t35, m.cos_chain_theta_4).add_product(t36,
        m.sin_chain_theta_4).add_product(t37, m.cos_chain_theta_4).add_product(t38,
        m.sin_chain_theta_4), m.chain_omega_4_dot);
    let t44 = t43.add_product(R::literal(0.5) * (t27 * m.cos_chain_theta_5).add_product(t28,
        m.sin_chain_theta_5).add_product(t29, m.cos_chain_theta_5).add_product(t30,
        m.sin_chain_theta_5).add_product(t31, m.cos_chain_theta_5).add_product(t32,
        m.sin_chain_theta_5).add_product(t33, m.cos_chain_theta_5).add_product(t34,
        m.sin_chain_theta_5).add_product(t35, m.cos_chain_theta_5).add_product(t36,
        m.sin_chain_theta_5).add_product(t37, m.cos_chain_theta_5).add_product(t38,
        m.sin_chain_theta_5), m.chain_omega_5_dot);
    let t45 = t44.add_product(R::literal(0.5) * (t29 * m.cos_chain_theta_6).add_product(t30,
        m.sin_chain_theta_6).add_product(t31, m.cos_chain_theta_6).add_product(t32,
        m.sin_chain_theta_6).add_product(t33, m.cos_chain_theta_6).add_product(t34,
        m.sin_chain_theta_6).add_product(t35, m.cos_chain_theta_6).add_product(t36,
        m.sin_chain_theta_6).add_product(t37, m.cos_chain_theta_6).add_product(t38,
        m.sin_chain_theta_6), m.chain_omega_6_dot).add_product(R::literal(0.5)
        * (t31 * m.cos_chain_theta_7).add_product(t32, m.sin_chain_theta_7).add_product(t33,
        m.cos_chain_theta_7).add_product(t34, m.sin_chain_theta_7).add_product(t35,
        m.cos_chain_theta_7).add_product(t36, m.sin_chain_theta_7).add_product(t37,
        m.cos_chain_theta_7).add_product(t38, m.sin_chain_theta_7), m.chain_omega_7_dot);
    PowerBalance {
        stored_rate: t45.add_product(R::literal(0.5) * (t33 * m.cos_chain_theta_8).add_product(t34,
            m.sin_chain_theta_8).add_product(t35, m.cos_chain_theta_8).add_product(t36,
            m.sin_chain_theta_8).add_product(t37, m.cos_chain_theta_8).add_product(t38,
            m.sin_chain_theta_8), m.chain_omega_8_dot).add_product(R::literal(0.5)
            * (t35 * m.cos_chain_theta_9).add_product(t36, m.sin_chain_theta_9).add_product(t37,
            m.cos_chain_theta_9).add_product(t38, m.sin_chain_theta_9), m.chain_omega_9_dot)
            .add_product(R::literal(0.5) * (t37 * m.cos_chain_theta_10).add_product(t38,
            m.sin_chain_theta_10), m.chain_omega_10_dot),
        supplied: R::literal(0.0),
        dissipated: R::literal(0.0),
    }
}

/// Normalized Taylor coefficients of the solution through `state`, order after order.
///
/// `_k` marks the coefficient of order k, `_before` that of order k - 1; bare names are
/// zeroth coefficients. The workspace is as `series_workspace` says.
///
/// 665 recurrences. 300 sums of products an order.
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
    let (mut lanes_18, workspace) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let (mut lanes_19, workspace) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let (mut lanes_20, workspace) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let (mut lanes_21, workspace) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let (mut lanes_22, workspace) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let (mut lanes_23, workspace) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let (mut lanes_24, workspace) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let (mut lanes_25, workspace) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let (mut lanes_26, workspace) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let (mut lanes_27, workspace) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let (mut lanes_28, workspace) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let (mut lanes_29, workspace) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let (mut lanes_30, workspace) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let (mut lanes_31, workspace) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let (mut lanes_32, workspace) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let (mut lanes_33, workspace) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let (mut lanes_34, workspace) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let (mut lanes_35, workspace) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let (mut lanes_36, workspace) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let (mut lanes_37, workspace) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let (mut lanes_38, workspace) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let (mut lanes_39, workspace) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let (mut lanes_40, workspace) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let (mut lanes_41, workspace) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let (mut lanes_42, workspace) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let (mut lanes_43, workspace) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let (mut lanes_44, workspace) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let (mut lanes_45, workspace) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let (mut lanes_46, workspace) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let (mut lanes_47, workspace) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let (mut lanes_48, workspace) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let (mut lanes_49, workspace) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let (mut lanes_50, workspace) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let (mut lanes_51, workspace) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let (mut lanes_52, workspace) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let (mut lanes_53, workspace) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let (mut lanes_54, workspace) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let (mut lanes_55, workspace) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let (mut lanes_56, workspace) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let (mut lanes_57, workspace) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let (mut lanes_58, workspace) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let (mut lanes_59, workspace) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let (mut lanes_60, workspace) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let (mut lanes_61, workspace) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let (mut lanes_62, workspace) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let (mut lanes_63, workspace) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let (mut lanes_64, workspace) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let (mut lanes_65, workspace) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let (mut lanes_66, workspace) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let (mut lanes_67, workspace) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let (mut lanes_68, workspace) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let (mut lanes_69, workspace) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let (mut lanes_70, workspace) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let (mut lanes_71, workspace) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let (mut lanes_72, workspace) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let (mut lanes_73, workspace) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let (mut lanes_74, _) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let [chain_theta_1, chain_theta_2, chain_theta_3, chain_theta_4, chain_theta_5, chain_theta_6,
        chain_theta_7, chain_theta_8, chain_theta_9, chain_theta_10, chain_omega_1, chain_omega_2,
        chain_omega_3, chain_omega_4, chain_omega_5, chain_omega_6, chain_omega_7, chain_omega_8,
        chain_omega_9, chain_omega_10] = *state;
    let t0 = chain_theta_1 - chain_theta_2;
    let t1 = t0.sin();
    let t2 = t0.cos();
    let t3 = t2 * R::literal(9.0);
    let t4 = chain_theta_1 - chain_theta_3;
    let t5 = t4.sin();
    let t6 = t4.cos();
    let t7 = t6 * R::literal(8.0);
    let t8 = chain_theta_1 - chain_theta_4;
    let t9 = t8.sin();
    let t10 = t8.cos();
    let t11 = t10 * R::literal(7.0);
    let t12 = chain_theta_1 - chain_theta_5;
    let t13 = t12.sin();
    let t14 = t12.cos();
    let t15 = t14 * R::literal(6.0);
    let t16 = chain_theta_1 - chain_theta_6;
    let t17 = t16.sin();
    let t18 = t16.cos();
    let t19 = t18 * R::literal(5.0);
    let t20 = chain_theta_1 - chain_theta_7;
    let t21 = t20.sin();
    let t22 = t20.cos();
    let t23 = t22 * R::literal(4.0);
    let t24 = chain_theta_1 - chain_theta_8;
    let t25 = t24.sin();
    let t26 = t24.cos();
    let t27 = t26 * R::literal(3.0);
    let t28 = chain_theta_1 - chain_theta_9;
    let t29 = t28.sin();
    let t30 = t28.cos();
    let t31 = t30 * R::literal(2.0);
    let t32 = chain_theta_1 - chain_theta_10;
    let t33 = t32.sin();
    let t34 = t32.cos();
    let t35 = chain_theta_2 - chain_theta_3;
    let t36 = t35.sin();
    let t37 = t35.cos();
    let t38 = t37 * R::literal(8.0);
    let t39 = chain_theta_2 - chain_theta_4;
    let t40 = t39.sin();
    let t41 = t39.cos();
    let t42 = t41 * R::literal(7.0);
    let t43 = chain_theta_2 - chain_theta_5;
    let t44 = t43.sin();
    let t45 = t43.cos();
    let t46 = t45 * R::literal(6.0);
    let t47 = chain_theta_2 - chain_theta_6;
    let t48 = t47.sin();
    let t49 = t47.cos();
    let t50 = t49 * R::literal(5.0);
    let t51 = chain_theta_2 - chain_theta_7;
    let t52 = t51.sin();
    let t53 = t51.cos();
    let t54 = t53 * R::literal(4.0);
    let t55 = chain_theta_2 - chain_theta_8;
    let t56 = t55.sin();
    let t57 = t55.cos();
    let t58 = t57 * R::literal(3.0);
    let t59 = chain_theta_2 - chain_theta_9;
    let t60 = t59.sin();
    let t61 = t59.cos();
    let t62 = t61 * R::literal(2.0);
    let t63 = chain_theta_2 - chain_theta_10;
    let t64 = t63.sin();
    let t65 = t63.cos();
    let t66 = chain_theta_3 - chain_theta_4;
    let t67 = t66.sin();
    let t68 = t66.cos();
    let t69 = t68 * R::literal(7.0);
    let t70 = chain_theta_3 - chain_theta_5;
    let t71 = t70.sin();
    let t72 = t70.cos();
    let t73 = t72 * R::literal(6.0);
    let t74 = chain_theta_3 - chain_theta_6;
    let t75 = t74.sin();
    let t76 = t74.cos();
    let t77 = t76 * R::literal(5.0);
    let t78 = chain_theta_3 - chain_theta_7;
    let t79 = t78.sin();
    let t80 = t78.cos();
    let t81 = t80 * R::literal(4.0);
    let t82 = chain_theta_3 - chain_theta_8;
    let t83 = t82.sin();
    let t84 = t82.cos();
    let t85 = t84 * R::literal(3.0);
    let t86 = chain_theta_3 - chain_theta_9;
    let t87 = t86.sin();
    let t88 = t86.cos();
    let t89 = t88 * R::literal(2.0);
    let t90 = chain_theta_3 - chain_theta_10;
    let t91 = t90.sin();
    let t92 = t90.cos();
    let t93 = chain_theta_4 - chain_theta_5;
    let t94 = t93.sin();
    let t95 = t93.cos();
    let t96 = t95 * R::literal(6.0);
    let t97 = chain_theta_4 - chain_theta_6;
    let t98 = t97.sin();
    let t99 = t97.cos();
    let t100 = t99 * R::literal(5.0);
    let t101 = chain_theta_4 - chain_theta_7;
    let t102 = t101.sin();
    let t103 = t101.cos();
    let t104 = t103 * R::literal(4.0);
    let t105 = chain_theta_4 - chain_theta_8;
    let t106 = t105.sin();
    let t107 = t105.cos();
    let t108 = t107 * R::literal(3.0);
    let t109 = chain_theta_4 - chain_theta_9;
    let t110 = t109.sin();
    let t111 = t109.cos();
    let t112 = t111 * R::literal(2.0);
    let t113 = chain_theta_4 - chain_theta_10;
    let t114 = t113.sin();
    let t115 = t113.cos();
    let t116 = chain_theta_5 - chain_theta_6;
    let t117 = t116.sin();
    let t118 = t116.cos();
    let t119 = t118 * R::literal(5.0);
    let t120 = chain_theta_5 - chain_theta_7;
    let t121 = t120.sin();
    let t122 = t120.cos();
    let t123 = t122 * R::literal(4.0);
    let t124 = chain_theta_5 - chain_theta_8;
    let t125 = t124.sin();
    let t126 = t124.cos();
    let t127 = t126 * R::literal(3.0);
    let t128 = chain_theta_5 - chain_theta_9;
    let t129 = t128.sin();
    let t130 = t128.cos();
    let t131 = t130 * R::literal(2.0);
    let t132 = chain_theta_5 - chain_theta_10;
    let t133 = t132.sin();
    let t134 = t132.cos();
    let t135 = chain_theta_6 - chain_theta_7;
    let t136 = t135.sin();
    let t137 = t135.cos();
    let t138 = t137 * R::literal(4.0);
    let t139 = chain_theta_6 - chain_theta_8;
    let t140 = t139.sin();
    let t141 = t139.cos();
    let t142 = t141 * R::literal(3.0);
    let t143 = chain_theta_6 - chain_theta_9;
    let t144 = t143.sin();
    let t145 = t143.cos();
    let t146 = t145 * R::literal(2.0);
    let t147 = chain_theta_6 - chain_theta_10;
    let t148 = t147.sin();
    let t149 = t147.cos();
    let t150 = chain_theta_7 - chain_theta_8;
    let t151 = t150.sin();
    let t152 = t150.cos();
    let t153 = t152 * R::literal(3.0);
    let t154 = chain_theta_7 - chain_theta_9;
    let t155 = t154.sin();
    let t156 = t154.cos();
    let t157 = t156 * R::literal(2.0);
    let t158 = chain_theta_7 - chain_theta_10;
    let t159 = t158.sin();
    let t160 = t158.cos();
    let t161 = chain_theta_8 - chain_theta_9;
    let t162 = t161.sin();
    let t163 = t161.cos();
    let t164 = t163 * R::literal(2.0);
    let t165 = chain_theta_8 - chain_theta_10;
    let t166 = t165.sin();
    let t167 = t165.cos();
    let t168 = chain_theta_9 - chain_theta_10;
    let t169 = t168.sin();
    let t170 = t168.cos();
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
    let sin_chain_theta_6 = chain_theta_6.sin();
    let cos_chain_theta_6 = chain_theta_6.cos();
    let sin_chain_theta_7 = chain_theta_7.sin();
    let cos_chain_theta_7 = chain_theta_7.cos();
    let sin_chain_theta_8 = chain_theta_8.sin();
    let cos_chain_theta_8 = chain_theta_8.cos();
    let sin_chain_theta_9 = chain_theta_9.sin();
    let cos_chain_theta_9 = chain_theta_9.cos();
    let sin_chain_theta_10 = chain_theta_10.sin();
    let cos_chain_theta_10 = chain_theta_10.cos();
    let t171 = chain_omega_2 * chain_omega_2;
    let t172 = t171 * R::literal(9.0);
    let t173 = t172 * t1;
    let t174 = chain_omega_3 * chain_omega_3;
    let t175 = t174 * R::literal(8.0);
    let t176 = t175 * t5;
    let t177 = chain_omega_4 * chain_omega_4;
    let t178 = t177 * R::literal(7.0);
    let t179 = t178 * t9;
    let t180 = chain_omega_5 * chain_omega_5;
    let t181 = t180 * R::literal(6.0);
    let t182 = t181 * t13;
    let t183 = chain_omega_6 * chain_omega_6;
    let t184 = t183 * R::literal(5.0);
    let t185 = t184 * t17;
    let t186 = chain_omega_7 * chain_omega_7;
    let t187 = t186 * R::literal(4.0);
    let t188 = t187 * t21;
    let t189 = chain_omega_8 * chain_omega_8;
    let t190 = t189 * R::literal(3.0);
    let t191 = t190 * t25;
    let t192 = chain_omega_9 * chain_omega_9;
    let t193 = t192 * R::literal(2.0);
    let t194 = t193 * t29;
    let t195 = chain_omega_10 * chain_omega_10;
    let t196 = t195 * t33;
    let t197 = sin_chain_theta_1 * R::literal(-98.1);
    let t198 = t197 - t173;
    let t199 = t198 - t176;
    let t200 = t199 - t179;
    let t201 = t200 - t182;
    let t202 = t201 - t185;
    let t203 = t202 - t188;
    let t204 = t203 - t191;
    let t205 = t204 - t194;
    let t206 = t205 - t196;
    let t207 = sin_chain_theta_2 * R::literal(88.29);
    let t208 = t175 * t36;
    let t209 = t178 * t40;
    let t210 = t181 * t44;
    let t211 = t184 * t48;
    let t212 = t187 * t52;
    let t213 = t190 * t56;
    let t214 = t193 * t60;
    let t215 = t195 * t64;
    let t216 = chain_omega_1 * chain_omega_1;
    let t217 = t216 * R::literal(9.0);
    let t218 = t217 * t1;
    let t219 = t218 - t207;
    let t220 = t219 - t208;
    let t221 = t220 - t209;
    let t222 = t221 - t210;
    let t223 = t222 - t211;
    let t224 = t223 - t212;
    let t225 = t224 - t213;
    let t226 = t225 - t214;
    let t227 = t226 - t215;
    let t228 = sin_chain_theta_3 * R::literal(78.48);
    let t229 = t178 * t67;
    let t230 = t181 * t71;
    let t231 = t184 * t75;
    let t232 = t187 * t79;
    let t233 = t190 * t83;
    let t234 = t193 * t87;
    let t235 = t195 * t91;
    let t236 = t216 * R::literal(8.0);
    let t237 = t236 * t5;
    let t238 = t171 * R::literal(8.0);
    let t239 = t238 * t36;
    let t240 = t237 + t239;
    let t241 = t240 - t228;
    let t242 = t241 - t229;
    let t243 = t242 - t230;
    let t244 = t243 - t231;
    let t245 = t244 - t232;
    let t246 = t245 - t233;
    let t247 = t246 - t234;
    let t248 = t247 - t235;
    let t249 = sin_chain_theta_4 * R::literal(68.67);
    let t250 = t181 * t94;
    let t251 = t184 * t98;
    let t252 = t187 * t102;
    let t253 = t190 * t106;
    let t254 = t193 * t110;
    let t255 = t195 * t114;
    let t256 = t216 * R::literal(7.0);
    let t257 = t256 * t9;
    let t258 = t171 * R::literal(7.0);
    let t259 = t258 * t40;
    let t260 = t174 * R::literal(7.0);
    let t261 = t260 * t67;
    let t262 = t257 + t259;
    let t263 = t262 + t261;
    let t264 = t263 - t249;
    let t265 = t264 - t250;
    let t266 = t265 - t251;
    let t267 = t266 - t252;
    let t268 = t267 - t253;
    let t269 = t268 - t254;
    let t270 = t269 - t255;
    let t271 = sin_chain_theta_5 * R::literal(58.86);
    let t272 = t184 * t117;
    let t273 = t187 * t121;
    let t274 = t190 * t125;
    let t275 = t193 * t129;
    let t276 = t195 * t133;
    let t277 = t216 * R::literal(6.0);
    let t278 = t277 * t13;
    let t279 = t171 * R::literal(6.0);
    let t280 = t279 * t44;
    let t281 = t174 * R::literal(6.0);
    let t282 = t281 * t71;
    let t283 = t177 * R::literal(6.0);
    let t284 = t283 * t94;
    let t285 = t278 + t280;
    let t286 = t285 + t282;
    let t287 = t286 + t284;
    let t288 = t287 - t271;
    let t289 = t288 - t272;
    let t290 = t289 - t273;
    let t291 = t290 - t274;
    let t292 = t291 - t275;
    let t293 = t292 - t276;
    let t294 = sin_chain_theta_6 * R::literal(49.05);
    let t295 = t187 * t136;
    let t296 = t190 * t140;
    let t297 = t193 * t144;
    let t298 = t195 * t148;
    let t299 = t216 * R::literal(5.0);
    let t300 = t299 * t17;
    let t301 = t171 * R::literal(5.0);
    let t302 = t301 * t48;
    let t303 = t174 * R::literal(5.0);
    let t304 = t303 * t75;
    let t305 = t177 * R::literal(5.0);
    let t306 = t305 * t98;
    let t307 = t180 * R::literal(5.0);
    let t308 = t307 * t117;
    let t309 = t300 + t302;
    let t310 = t309 + t304;
    let t311 = t310 + t306;
    let t312 = t311 + t308;
    let t313 = t312 - t294;
    let t314 = t313 - t295;
    let t315 = t314 - t296;
    let t316 = t315 - t297;
    let t317 = t316 - t298;
    let t318 = sin_chain_theta_7 * R::literal(39.24);
    let t319 = t190 * t151;
    let t320 = t193 * t155;
    let t321 = t195 * t159;
    let t322 = t216 * R::literal(4.0);
    let t323 = t322 * t21;
    let t324 = t171 * R::literal(4.0);
    let t325 = t324 * t52;
    let t326 = t174 * R::literal(4.0);
    let t327 = t326 * t79;
    let t328 = t177 * R::literal(4.0);
    let t329 = t328 * t102;
    let t330 = t180 * R::literal(4.0);
    let t331 = t330 * t121;
    let t332 = t183 * R::literal(4.0);
    let t333 = t332 * t136;
    let t334 = t323 + t325;
    let t335 = t334 + t327;
    let t336 = t335 + t329;
    let t337 = t336 + t331;
    let t338 = t337 + t333;
    let t339 = t338 - t318;
    let t340 = t339 - t319;
    let t341 = t340 - t320;
    let t342 = t341 - t321;
    let t343 = sin_chain_theta_8 * R::literal(29.43);
    let t344 = t193 * t162;
    let t345 = t195 * t166;
    let t346 = t216 * R::literal(3.0);
    let t347 = t346 * t25;
    let t348 = t171 * R::literal(3.0);
    let t349 = t348 * t56;
    let t350 = t174 * R::literal(3.0);
    let t351 = t350 * t83;
    let t352 = t177 * R::literal(3.0);
    let t353 = t352 * t106;
    let t354 = t180 * R::literal(3.0);
    let t355 = t354 * t125;
    let t356 = t183 * R::literal(3.0);
    let t357 = t356 * t140;
    let t358 = t186 * R::literal(3.0);
    let t359 = t358 * t151;
    let t360 = t347 + t349;
    let t361 = t360 + t351;
    let t362 = t361 + t353;
    let t363 = t362 + t355;
    let t364 = t363 + t357;
    let t365 = t364 + t359;
    let t366 = t365 - t343;
    let t367 = t366 - t344;
    let t368 = t367 - t345;
    let t369 = sin_chain_theta_9 * R::literal(19.62);
    let t370 = t195 * t169;
    let t371 = t216 * R::literal(2.0);
    let t372 = t371 * t29;
    let t373 = t171 * R::literal(2.0);
    let t374 = t373 * t60;
    let t375 = t174 * R::literal(2.0);
    let t376 = t375 * t87;
    let t377 = t177 * R::literal(2.0);
    let t378 = t377 * t110;
    let t379 = t180 * R::literal(2.0);
    let t380 = t379 * t129;
    let t381 = t183 * R::literal(2.0);
    let t382 = t381 * t144;
    let t383 = t186 * R::literal(2.0);
    let t384 = t383 * t155;
    let t385 = t189 * R::literal(2.0);
    let t386 = t385 * t162;
    let t387 = t372 + t374;
    let t388 = t387 + t376;
    let t389 = t388 + t378;
    let t390 = t389 + t380;
    let t391 = t390 + t382;
    let t392 = t391 + t384;
    let t393 = t392 + t386;
    let t394 = t393 - t369;
    let t395 = t394 - t370;
    let t396 = sin_chain_theta_10 * R::literal(9.81);
    let t397 = t216 * t33;
    let t398 = t171 * t64;
    let t399 = t174 * t91;
    let t400 = t177 * t114;
    let t401 = t180 * t133;
    let t402 = t183 * t148;
    let t403 = t186 * t159;
    let t404 = t189 * t166;
    let t405 = t192 * t169;
    let t406 = t397 + t398;
    let t407 = t406 + t399;
    let t408 = t407 + t400;
    let t409 = t408 + t401;
    let t410 = t409 + t402;
    let t411 = t410 + t403;
    let t412 = t411 + t404;
    let t413 = t412 + t405;
    let t414 = t413 - t396;
    let factored = Factored::new([[R::literal(10.0), R::literal(0.0), R::literal(0.0),
        R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0),
        R::literal(0.0), R::literal(0.0)], [t3, R::literal(9.0), R::literal(0.0), R::literal(0.0),
        R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0),
        R::literal(0.0)], [t7, t38, R::literal(8.0), R::literal(0.0), R::literal(0.0),
        R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0)],
        [t11, t42, t69, R::literal(7.0), R::literal(0.0), R::literal(0.0), R::literal(0.0),
        R::literal(0.0), R::literal(0.0), R::literal(0.0)], [t15, t46, t73, t96, R::literal(6.0),
        R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0)],
        [t19, t50, t77, t100, t119, R::literal(5.0), R::literal(0.0), R::literal(0.0),
        R::literal(0.0), R::literal(0.0)], [t23, t54, t81, t104, t123, t138, R::literal(4.0),
        R::literal(0.0), R::literal(0.0), R::literal(0.0)], [t27, t58, t85, t108, t127, t142, t153,
        R::literal(3.0), R::literal(0.0), R::literal(0.0)], [t31, t62, t89, t112, t131, t146, t157,
        t164, R::literal(2.0), R::literal(0.0)], [t34, t65, t92, t115, t134, t149, t160, t167,
        t170, R::literal(1.0)]]);
    let [chain_omega_1_dot, chain_omega_2_dot, chain_omega_3_dot, chain_omega_4_dot,
        chain_omega_5_dot, chain_omega_6_dot, chain_omega_7_dot, chain_omega_8_dot,
        chain_omega_9_dot, chain_omega_10_dot] = factored.solve([t206, t227, t248, t270, t293,
        t317, t342, t368, t395, t414]);
    let mut rates = [chain_omega_1, chain_omega_2, chain_omega_3, chain_omega_4, chain_omega_5,
        chain_omega_6, chain_omega_7, chain_omega_8, chain_omega_9, chain_omega_10,
        chain_omega_1_dot, chain_omega_2_dot, chain_omega_3_dot, chain_omega_4_dot,
        chain_omega_5_dot, chain_omega_6_dot, chain_omega_7_dot, chain_omega_8_dot,
        chain_omega_9_dot, chain_omega_10_dot];
    coefficients[0] = *state;
    let highest = coefficients.len() - 1;
    for (order, state_k) in coefficients.iter_mut().enumerate().skip(1) {
        let (k, inverse) = order_and_inverse::<R>(order);
        *state_k = rates.map(|rate| rate * inverse);
        if order == highest {
            break;
        }
        let [chain_theta_1_k, chain_theta_2_k, chain_theta_3_k, chain_theta_4_k, chain_theta_5_k,
            chain_theta_6_k, chain_theta_7_k, chain_theta_8_k, chain_theta_9_k, chain_theta_10_k,
            chain_omega_1_k, chain_omega_2_k, chain_omega_3_k, chain_omega_4_k, chain_omega_5_k,
            chain_omega_6_k, chain_omega_7_k, chain_omega_8_k, chain_omega_9_k, chain_omega_10_k]
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
        let sums_19 = lanes_19.sums(order);
        let sums_20 = lanes_20.sums(order);
        let sums_21 = lanes_21.sums(order);
        let sums_22 = lanes_22.sums(order);
        let sums_23 = lanes_23.sums(order);
        let sums_24 = lanes_24.sums(order);
        let sums_25 = lanes_25.sums(order);
        let sums_26 = lanes_26.sums(order);
        let sums_27 = lanes_27.sums(order);
        let sums_28 = lanes_28.sums(order);
        let sums_29 = lanes_29.sums(order);
        let sums_30 = lanes_30.sums(order);
        let sums_31 = lanes_31.sums(order);
        let sums_32 = lanes_32.sums(order);
        let sums_33 = lanes_33.sums(order);
        let sums_34 = lanes_34.sums(order);
        let sums_35 = lanes_35.sums(order);
        let sums_36 = lanes_36.sums(order);
        let sums_37 = lanes_37.sums(order);
        let sums_38 = lanes_38.sums(order);
        let sums_39 = lanes_39.sums(order);
        let sums_40 = lanes_40.sums(order);
        let sums_41 = lanes_41.sums(order);
        let sums_42 = lanes_42.sums(order);
        let sums_43 = lanes_43.sums(order);
        let sums_44 = lanes_44.sums(order);
        let sums_45 = lanes_45.sums(order);
        let sums_46 = lanes_46.sums(order);
        let sums_47 = lanes_47.sums(order);
        let sums_48 = lanes_48.sums(order);
        let sums_49 = lanes_49.sums(order);
        let sums_50 = lanes_50.sums(order);
        let sums_51 = lanes_51.sums(order);
        let sums_52 = lanes_52.sums(order);
        let sums_53 = lanes_53.sums(order);
        let sums_54 = lanes_54.sums(order);
        let sums_55 = lanes_55.sums(order);
        let sums_56 = lanes_56.sums(order);
        let sums_57 = lanes_57.sums(order);
        let sums_58 = lanes_58.sums(order);
        let sums_59 = lanes_59.sums(order);
        let sums_60 = lanes_60.sums(order);
        let sums_61 = lanes_61.sums(order);
        let sums_62 = lanes_62.sums(order);
        let sums_63 = lanes_63.sums(order);
        let sums_64 = lanes_64.sums(order);
        let sums_65 = lanes_65.sums(order);
        let sums_66 = lanes_66.sums(order);
        let sums_67 = lanes_67.sums(order);
        let sums_68 = lanes_68.sums(order);
        let sums_69 = lanes_69.sums(order);
        let sums_70 = lanes_70.sums(order);
        let sums_71 = lanes_71.sums(order);
        let sums_72 = lanes_72.sums(order);
        let sums_73 = lanes_73.sums(order);
        let sums_74 = lanes_74.sums(order);
        let t0_k = chain_theta_1_k - chain_theta_2_k;
        let t1_k = t0_k.mul_add(t2, inverse * sums_7[2]);
        let t2_k = -t0_k.mul_add(t1, inverse * sums_7[3]);
        let t3_k = t2_k * R::literal(9.0);
        let t4_k = chain_theta_1_k - chain_theta_3_k;
        let t5_k = t4_k.mul_add(t6, inverse * sums_8[0]);
        let t6_k = -t4_k.mul_add(t5, inverse * sums_8[1]);
        let t7_k = t6_k * R::literal(8.0);
        let t8_k = chain_theta_1_k - chain_theta_4_k;
        let t9_k = t8_k.mul_add(t10, inverse * sums_8[2]);
        let t10_k = -t8_k.mul_add(t9, inverse * sums_8[3]);
        let t11_k = t10_k * R::literal(7.0);
        let t12_k = chain_theta_1_k - chain_theta_5_k;
        let t13_k = t12_k.mul_add(t14, inverse * sums_9[0]);
        let t14_k = -t12_k.mul_add(t13, inverse * sums_9[1]);
        let t15_k = t14_k * R::literal(6.0);
        let t16_k = chain_theta_1_k - chain_theta_6_k;
        let t17_k = t16_k.mul_add(t18, inverse * sums_9[2]);
        let t18_k = -t16_k.mul_add(t17, inverse * sums_9[3]);
        let t19_k = t18_k * R::literal(5.0);
        let t20_k = chain_theta_1_k - chain_theta_7_k;
        let t21_k = t20_k.mul_add(t22, inverse * sums_10[0]);
        let t22_k = -t20_k.mul_add(t21, inverse * sums_10[1]);
        let t23_k = t22_k * R::literal(4.0);
        let t24_k = chain_theta_1_k - chain_theta_8_k;
        let t25_k = t24_k.mul_add(t26, inverse * sums_10[2]);
        let t26_k = -t24_k.mul_add(t25, inverse * sums_10[3]);
        let t27_k = t26_k * R::literal(3.0);
        let t28_k = chain_theta_1_k - chain_theta_9_k;
        let t29_k = t28_k.mul_add(t30, inverse * sums_11[0]);
        let t30_k = -t28_k.mul_add(t29, inverse * sums_11[1]);
        let t31_k = t30_k * R::literal(2.0);
        let t32_k = chain_theta_1_k - chain_theta_10_k;
        let t33_k = t32_k.mul_add(t34, inverse * sums_11[2]);
        let t34_k = -t32_k.mul_add(t33, inverse * sums_11[3]);
        let t35_k = chain_theta_2_k - chain_theta_3_k;
        let t36_k = t35_k.mul_add(t37, inverse * sums_12[0]);
        let t37_k = -t35_k.mul_add(t36, inverse * sums_12[1]);
        let t38_k = t37_k * R::literal(8.0);
        let t39_k = chain_theta_2_k - chain_theta_4_k;
        let t40_k = t39_k.mul_add(t41, inverse * sums_12[2]);
        let t41_k = -t39_k.mul_add(t40, inverse * sums_12[3]);
        let t42_k = t41_k * R::literal(7.0);
        let t43_k = chain_theta_2_k - chain_theta_5_k;
        let t44_k = t43_k.mul_add(t45, inverse * sums_13[0]);
        let t45_k = -t43_k.mul_add(t44, inverse * sums_13[1]);
        let t46_k = t45_k * R::literal(6.0);
        let t47_k = chain_theta_2_k - chain_theta_6_k;
        let t48_k = t47_k.mul_add(t49, inverse * sums_13[2]);
        let t49_k = -t47_k.mul_add(t48, inverse * sums_13[3]);
        let t50_k = t49_k * R::literal(5.0);
        let t51_k = chain_theta_2_k - chain_theta_7_k;
        let t52_k = t51_k.mul_add(t53, inverse * sums_14[0]);
        let t53_k = -t51_k.mul_add(t52, inverse * sums_14[1]);
        let t54_k = t53_k * R::literal(4.0);
        let t55_k = chain_theta_2_k - chain_theta_8_k;
        let t56_k = t55_k.mul_add(t57, inverse * sums_14[2]);
        let t57_k = -t55_k.mul_add(t56, inverse * sums_14[3]);
        let t58_k = t57_k * R::literal(3.0);
        let t59_k = chain_theta_2_k - chain_theta_9_k;
        let t60_k = t59_k.mul_add(t61, inverse * sums_15[0]);
        let t61_k = -t59_k.mul_add(t60, inverse * sums_15[1]);
        let t62_k = t61_k * R::literal(2.0);
        let t63_k = chain_theta_2_k - chain_theta_10_k;
        let t64_k = t63_k.mul_add(t65, inverse * sums_15[2]);
        let t65_k = -t63_k.mul_add(t64, inverse * sums_15[3]);
        let t66_k = chain_theta_3_k - chain_theta_4_k;
        let t67_k = t66_k.mul_add(t68, inverse * sums_16[0]);
        let t68_k = -t66_k.mul_add(t67, inverse * sums_16[1]);
        let t69_k = t68_k * R::literal(7.0);
        let t70_k = chain_theta_3_k - chain_theta_5_k;
        let t71_k = t70_k.mul_add(t72, inverse * sums_16[2]);
        let t72_k = -t70_k.mul_add(t71, inverse * sums_16[3]);
        let t73_k = t72_k * R::literal(6.0);
        let t74_k = chain_theta_3_k - chain_theta_6_k;
        let t75_k = t74_k.mul_add(t76, inverse * sums_17[0]);
        let t76_k = -t74_k.mul_add(t75, inverse * sums_17[1]);
        let t77_k = t76_k * R::literal(5.0);
        let t78_k = chain_theta_3_k - chain_theta_7_k;
        let t79_k = t78_k.mul_add(t80, inverse * sums_17[2]);
        let t80_k = -t78_k.mul_add(t79, inverse * sums_17[3]);
        let t81_k = t80_k * R::literal(4.0);
        let t82_k = chain_theta_3_k - chain_theta_8_k;
        let t83_k = t82_k.mul_add(t84, inverse * sums_18[0]);
        let t84_k = -t82_k.mul_add(t83, inverse * sums_18[1]);
        let t85_k = t84_k * R::literal(3.0);
        let t86_k = chain_theta_3_k - chain_theta_9_k;
        let t87_k = t86_k.mul_add(t88, inverse * sums_18[2]);
        let t88_k = -t86_k.mul_add(t87, inverse * sums_18[3]);
        let t89_k = t88_k * R::literal(2.0);
        let t90_k = chain_theta_3_k - chain_theta_10_k;
        let t91_k = t90_k.mul_add(t92, inverse * sums_19[0]);
        let t92_k = -t90_k.mul_add(t91, inverse * sums_19[1]);
        let t93_k = chain_theta_4_k - chain_theta_5_k;
        let t94_k = t93_k.mul_add(t95, inverse * sums_19[2]);
        let t95_k = -t93_k.mul_add(t94, inverse * sums_19[3]);
        let t96_k = t95_k * R::literal(6.0);
        let t97_k = chain_theta_4_k - chain_theta_6_k;
        let t98_k = t97_k.mul_add(t99, inverse * sums_20[0]);
        let t99_k = -t97_k.mul_add(t98, inverse * sums_20[1]);
        let t100_k = t99_k * R::literal(5.0);
        let t101_k = chain_theta_4_k - chain_theta_7_k;
        let t102_k = t101_k.mul_add(t103, inverse * sums_20[2]);
        let t103_k = -t101_k.mul_add(t102, inverse * sums_20[3]);
        let t104_k = t103_k * R::literal(4.0);
        let t105_k = chain_theta_4_k - chain_theta_8_k;
        let t106_k = t105_k.mul_add(t107, inverse * sums_21[0]);
        let t107_k = -t105_k.mul_add(t106, inverse * sums_21[1]);
        let t108_k = t107_k * R::literal(3.0);
        let t109_k = chain_theta_4_k - chain_theta_9_k;
        let t110_k = t109_k.mul_add(t111, inverse * sums_21[2]);
        let t111_k = -t109_k.mul_add(t110, inverse * sums_21[3]);
        let t112_k = t111_k * R::literal(2.0);
        let t113_k = chain_theta_4_k - chain_theta_10_k;
        let t114_k = t113_k.mul_add(t115, inverse * sums_22[0]);
        let t115_k = -t113_k.mul_add(t114, inverse * sums_22[1]);
        let t116_k = chain_theta_5_k - chain_theta_6_k;
        let t117_k = t116_k.mul_add(t118, inverse * sums_22[2]);
        let t118_k = -t116_k.mul_add(t117, inverse * sums_22[3]);
        let t119_k = t118_k * R::literal(5.0);
        let t120_k = chain_theta_5_k - chain_theta_7_k;
        let t121_k = t120_k.mul_add(t122, inverse * sums_23[0]);
        let t122_k = -t120_k.mul_add(t121, inverse * sums_23[1]);
        let t123_k = t122_k * R::literal(4.0);
        let t124_k = chain_theta_5_k - chain_theta_8_k;
        let t125_k = t124_k.mul_add(t126, inverse * sums_23[2]);
        let t126_k = -t124_k.mul_add(t125, inverse * sums_23[3]);
        let t127_k = t126_k * R::literal(3.0);
        let t128_k = chain_theta_5_k - chain_theta_9_k;
        let t129_k = t128_k.mul_add(t130, inverse * sums_24[0]);
        let t130_k = -t128_k.mul_add(t129, inverse * sums_24[1]);
        let t131_k = t130_k * R::literal(2.0);
        let t132_k = chain_theta_5_k - chain_theta_10_k;
        let t133_k = t132_k.mul_add(t134, inverse * sums_24[2]);
        let t134_k = -t132_k.mul_add(t133, inverse * sums_24[3]);
        let t135_k = chain_theta_6_k - chain_theta_7_k;
        let t136_k = t135_k.mul_add(t137, inverse * sums_25[0]);
        let t137_k = -t135_k.mul_add(t136, inverse * sums_25[1]);
        let t138_k = t137_k * R::literal(4.0);
        let t139_k = chain_theta_6_k - chain_theta_8_k;
        let t140_k = t139_k.mul_add(t141, inverse * sums_25[2]);
        let t141_k = -t139_k.mul_add(t140, inverse * sums_25[3]);
        let t142_k = t141_k * R::literal(3.0);
        let t143_k = chain_theta_6_k - chain_theta_9_k;
        let t144_k = t143_k.mul_add(t145, inverse * sums_26[0]);
        let t145_k = -t143_k.mul_add(t144, inverse * sums_26[1]);
        let t146_k = t145_k * R::literal(2.0);
        let t147_k = chain_theta_6_k - chain_theta_10_k;
        let t148_k = t147_k.mul_add(t149, inverse * sums_26[2]);
        let t149_k = -t147_k.mul_add(t148, inverse * sums_26[3]);
        let t150_k = chain_theta_7_k - chain_theta_8_k;
        let t151_k = t150_k.mul_add(t152, inverse * sums_27[0]);
        let t152_k = -t150_k.mul_add(t151, inverse * sums_27[1]);
        let t153_k = t152_k * R::literal(3.0);
        let t154_k = chain_theta_7_k - chain_theta_9_k;
        let t155_k = t154_k.mul_add(t156, inverse * sums_27[2]);
        let t156_k = -t154_k.mul_add(t155, inverse * sums_27[3]);
        let t157_k = t156_k * R::literal(2.0);
        let t158_k = chain_theta_7_k - chain_theta_10_k;
        let t159_k = t158_k.mul_add(t160, inverse * sums_28[0]);
        let t160_k = -t158_k.mul_add(t159, inverse * sums_28[1]);
        let t161_k = chain_theta_8_k - chain_theta_9_k;
        let t162_k = t161_k.mul_add(t163, inverse * sums_28[2]);
        let t163_k = -t161_k.mul_add(t162, inverse * sums_28[3]);
        let t164_k = t163_k * R::literal(2.0);
        let t165_k = chain_theta_8_k - chain_theta_10_k;
        let t166_k = t165_k.mul_add(t167, inverse * sums_29[0]);
        let t167_k = -t165_k.mul_add(t166, inverse * sums_29[1]);
        let t168_k = chain_theta_9_k - chain_theta_10_k;
        let t169_k = t168_k.mul_add(t170, inverse * sums_29[2]);
        let t170_k = -t168_k.mul_add(t169, inverse * sums_29[3]);
        let sin_chain_theta_1_k = chain_theta_1_k.mul_add(cos_chain_theta_1, inverse * sums_2[2]);
        let cos_chain_theta_1_k = -chain_theta_1_k.mul_add(sin_chain_theta_1, inverse * sums_2[3]);
        let sin_chain_theta_2_k = chain_theta_2_k.mul_add(cos_chain_theta_2, inverse * sums_3[0]);
        let cos_chain_theta_2_k = -chain_theta_2_k.mul_add(sin_chain_theta_2, inverse * sums_3[1]);
        let sin_chain_theta_3_k = chain_theta_3_k.mul_add(cos_chain_theta_3, inverse * sums_3[2]);
        let cos_chain_theta_3_k = -chain_theta_3_k.mul_add(sin_chain_theta_3, inverse * sums_3[3]);
        let sin_chain_theta_4_k = chain_theta_4_k.mul_add(cos_chain_theta_4, inverse * sums_4[0]);
        let cos_chain_theta_4_k = -chain_theta_4_k.mul_add(sin_chain_theta_4, inverse * sums_4[1]);
        let sin_chain_theta_5_k = chain_theta_5_k.mul_add(cos_chain_theta_5, inverse * sums_4[2]);
        let cos_chain_theta_5_k = -chain_theta_5_k.mul_add(sin_chain_theta_5, inverse * sums_4[3]);
        let sin_chain_theta_6_k = chain_theta_6_k.mul_add(cos_chain_theta_6, inverse * sums_5[0]);
        let cos_chain_theta_6_k = -chain_theta_6_k.mul_add(sin_chain_theta_6, inverse * sums_5[1]);
        let sin_chain_theta_7_k = chain_theta_7_k.mul_add(cos_chain_theta_7, inverse * sums_5[2]);
        let cos_chain_theta_7_k = -chain_theta_7_k.mul_add(sin_chain_theta_7, inverse * sums_5[3]);
        let sin_chain_theta_8_k = chain_theta_8_k.mul_add(cos_chain_theta_8, inverse * sums_6[0]);
        let cos_chain_theta_8_k = -chain_theta_8_k.mul_add(sin_chain_theta_8, inverse * sums_6[1]);
        let sin_chain_theta_9_k = chain_theta_9_k.mul_add(cos_chain_theta_9, inverse * sums_6[2]);
        let cos_chain_theta_9_k = -chain_theta_9_k.mul_add(sin_chain_theta_9, inverse * sums_6[3]);
        let sin_chain_theta_10_k = chain_theta_10_k.mul_add(cos_chain_theta_10, inverse
            * sums_7[0]);
        let cos_chain_theta_10_k = -chain_theta_10_k.mul_add(sin_chain_theta_10, inverse
            * sums_7[1]);
        let t171_k = (chain_omega_2 + chain_omega_2).mul_add(chain_omega_2_k, sums[0]);
        let t172_k = t171_k * R::literal(9.0);
        let t173_k = t172.mul_add(t1_k, t1.mul_add(t172_k, sums_30[0]));
        let t174_k = (chain_omega_3 + chain_omega_3).mul_add(chain_omega_3_k, sums[1]);
        let t175_k = t174_k * R::literal(8.0);
        let t176_k = t175.mul_add(t5_k, t5.mul_add(t175_k, sums_30[1]));
        let t177_k = (chain_omega_4 + chain_omega_4).mul_add(chain_omega_4_k, sums[2]);
        let t178_k = t177_k * R::literal(7.0);
        let t179_k = t178.mul_add(t9_k, t9.mul_add(t178_k, sums_30[2]));
        let t180_k = (chain_omega_5 + chain_omega_5).mul_add(chain_omega_5_k, sums[3]);
        let t181_k = t180_k * R::literal(6.0);
        let t182_k = t181.mul_add(t13_k, t13.mul_add(t181_k, sums_30[3]));
        let t183_k = (chain_omega_6 + chain_omega_6).mul_add(chain_omega_6_k, sums_1[0]);
        let t184_k = t183_k * R::literal(5.0);
        let t185_k = t184.mul_add(t17_k, t17.mul_add(t184_k, sums_31[0]));
        let t186_k = (chain_omega_7 + chain_omega_7).mul_add(chain_omega_7_k, sums_1[1]);
        let t187_k = t186_k * R::literal(4.0);
        let t188_k = t187.mul_add(t21_k, t21.mul_add(t187_k, sums_31[1]));
        let t189_k = (chain_omega_8 + chain_omega_8).mul_add(chain_omega_8_k, sums_1[2]);
        let t190_k = t189_k * R::literal(3.0);
        let t191_k = t190.mul_add(t25_k, t25.mul_add(t190_k, sums_31[2]));
        let t192_k = (chain_omega_9 + chain_omega_9).mul_add(chain_omega_9_k, sums_1[3]);
        let t193_k = t192_k * R::literal(2.0);
        let t194_k = t193.mul_add(t29_k, t29.mul_add(t193_k, sums_31[3]));
        let t195_k = (chain_omega_10 + chain_omega_10).mul_add(chain_omega_10_k, sums_2[0]);
        let t196_k = t195.mul_add(t33_k, t33.mul_add(t195_k, sums_32[0]));
        let t198_k = sin_chain_theta_1_k.mul_add(R::literal(-98.1), -t173_k);
        let t199_k = t198_k - t176_k;
        let t200_k = t199_k - t179_k;
        let t201_k = t200_k - t182_k;
        let t202_k = t201_k - t185_k;
        let t203_k = t202_k - t188_k;
        let t204_k = t203_k - t191_k;
        let t205_k = t204_k - t194_k;
        let t206_k = t205_k - t196_k;
        let t208_k = t175.mul_add(t36_k, t36.mul_add(t175_k, sums_32[1]));
        let t209_k = t178.mul_add(t40_k, t40.mul_add(t178_k, sums_32[2]));
        let t210_k = t181.mul_add(t44_k, t44.mul_add(t181_k, sums_32[3]));
        let t211_k = t184.mul_add(t48_k, t48.mul_add(t184_k, sums_33[0]));
        let t212_k = t187.mul_add(t52_k, t52.mul_add(t187_k, sums_33[1]));
        let t213_k = t190.mul_add(t56_k, t56.mul_add(t190_k, sums_33[2]));
        let t214_k = t193.mul_add(t60_k, t60.mul_add(t193_k, sums_33[3]));
        let t215_k = t195.mul_add(t64_k, t64.mul_add(t195_k, sums_34[0]));
        let t216_k = (chain_omega_1 + chain_omega_1).mul_add(chain_omega_1_k, sums_2[1]);
        let t217_k = t216_k * R::literal(9.0);
        let t218_k = t217.mul_add(t1_k, t1.mul_add(t217_k, sums_34[1]));
        let t219_k = (-sin_chain_theta_2_k).mul_add(R::literal(88.29), t218_k);
        let t220_k = t219_k - t208_k;
        let t221_k = t220_k - t209_k;
        let t222_k = t221_k - t210_k;
        let t223_k = t222_k - t211_k;
        let t224_k = t223_k - t212_k;
        let t225_k = t224_k - t213_k;
        let t226_k = t225_k - t214_k;
        let t227_k = t226_k - t215_k;
        let t229_k = t178.mul_add(t67_k, t67.mul_add(t178_k, sums_34[2]));
        let t230_k = t181.mul_add(t71_k, t71.mul_add(t181_k, sums_34[3]));
        let t231_k = t184.mul_add(t75_k, t75.mul_add(t184_k, sums_35[0]));
        let t232_k = t187.mul_add(t79_k, t79.mul_add(t187_k, sums_35[1]));
        let t233_k = t190.mul_add(t83_k, t83.mul_add(t190_k, sums_35[2]));
        let t234_k = t193.mul_add(t87_k, t87.mul_add(t193_k, sums_35[3]));
        let t235_k = t195.mul_add(t91_k, t91.mul_add(t195_k, sums_36[0]));
        let t236_k = t216_k * R::literal(8.0);
        let t237_k = t236.mul_add(t5_k, t5.mul_add(t236_k, sums_36[1]));
        let t238_k = t171_k * R::literal(8.0);
        let t239_k = t238.mul_add(t36_k, t36.mul_add(t238_k, sums_36[2]));
        let t240_k = t237_k + t239_k;
        let t241_k = (-sin_chain_theta_3_k).mul_add(R::literal(78.48), t240_k);
        let t242_k = t241_k - t229_k;
        let t243_k = t242_k - t230_k;
        let t244_k = t243_k - t231_k;
        let t245_k = t244_k - t232_k;
        let t246_k = t245_k - t233_k;
        let t247_k = t246_k - t234_k;
        let t248_k = t247_k - t235_k;
        let t250_k = t181.mul_add(t94_k, t94.mul_add(t181_k, sums_36[3]));
        let t251_k = t184.mul_add(t98_k, t98.mul_add(t184_k, sums_37[0]));
        let t252_k = t187.mul_add(t102_k, t102.mul_add(t187_k, sums_37[1]));
        let t253_k = t190.mul_add(t106_k, t106.mul_add(t190_k, sums_37[2]));
        let t254_k = t193.mul_add(t110_k, t110.mul_add(t193_k, sums_37[3]));
        let t255_k = t195.mul_add(t114_k, t114.mul_add(t195_k, sums_38[0]));
        let t256_k = t216_k * R::literal(7.0);
        let t257_k = t256.mul_add(t9_k, t9.mul_add(t256_k, sums_38[1]));
        let t258_k = t171_k * R::literal(7.0);
        let t259_k = t258.mul_add(t40_k, t40.mul_add(t258_k, sums_38[2]));
        let t260_k = t174_k * R::literal(7.0);
        let t261_k = t260.mul_add(t67_k, t67.mul_add(t260_k, sums_38[3]));
        let t262_k = t257_k + t259_k;
        let t263_k = t262_k + t261_k;
        let t264_k = (-sin_chain_theta_4_k).mul_add(R::literal(68.67), t263_k);
        let t265_k = t264_k - t250_k;
        let t266_k = t265_k - t251_k;
        let t267_k = t266_k - t252_k;
        let t268_k = t267_k - t253_k;
        let t269_k = t268_k - t254_k;
        let t270_k = t269_k - t255_k;
        let t272_k = t184.mul_add(t117_k, t117.mul_add(t184_k, sums_39[0]));
        let t273_k = t187.mul_add(t121_k, t121.mul_add(t187_k, sums_39[1]));
        let t274_k = t190.mul_add(t125_k, t125.mul_add(t190_k, sums_39[2]));
        let t275_k = t193.mul_add(t129_k, t129.mul_add(t193_k, sums_39[3]));
        let t276_k = t195.mul_add(t133_k, t133.mul_add(t195_k, sums_40[0]));
        let t277_k = t216_k * R::literal(6.0);
        let t278_k = t277.mul_add(t13_k, t13.mul_add(t277_k, sums_40[1]));
        let t279_k = t171_k * R::literal(6.0);
        let t280_k = t279.mul_add(t44_k, t44.mul_add(t279_k, sums_40[2]));
        let t281_k = t174_k * R::literal(6.0);
        let t282_k = t281.mul_add(t71_k, t71.mul_add(t281_k, sums_40[3]));
        let t283_k = t177_k * R::literal(6.0);
        let t284_k = t283.mul_add(t94_k, t94.mul_add(t283_k, sums_41[0]));
        let t285_k = t278_k + t280_k;
        let t286_k = t285_k + t282_k;
        let t287_k = t286_k + t284_k;
        let t288_k = (-sin_chain_theta_5_k).mul_add(R::literal(58.86), t287_k);
        let t289_k = t288_k - t272_k;
        let t290_k = t289_k - t273_k;
        let t291_k = t290_k - t274_k;
        let t292_k = t291_k - t275_k;
        let t293_k = t292_k - t276_k;
        let t295_k = t187.mul_add(t136_k, t136.mul_add(t187_k, sums_41[1]));
        let t296_k = t190.mul_add(t140_k, t140.mul_add(t190_k, sums_41[2]));
        let t297_k = t193.mul_add(t144_k, t144.mul_add(t193_k, sums_41[3]));
        let t298_k = t195.mul_add(t148_k, t148.mul_add(t195_k, sums_42[0]));
        let t299_k = t216_k * R::literal(5.0);
        let t300_k = t299.mul_add(t17_k, t17.mul_add(t299_k, sums_42[1]));
        let t301_k = t171_k * R::literal(5.0);
        let t302_k = t301.mul_add(t48_k, t48.mul_add(t301_k, sums_42[2]));
        let t303_k = t174_k * R::literal(5.0);
        let t304_k = t303.mul_add(t75_k, t75.mul_add(t303_k, sums_42[3]));
        let t305_k = t177_k * R::literal(5.0);
        let t306_k = t305.mul_add(t98_k, t98.mul_add(t305_k, sums_43[0]));
        let t307_k = t180_k * R::literal(5.0);
        let t308_k = t307.mul_add(t117_k, t117.mul_add(t307_k, sums_43[1]));
        let t309_k = t300_k + t302_k;
        let t310_k = t309_k + t304_k;
        let t311_k = t310_k + t306_k;
        let t312_k = t311_k + t308_k;
        let t313_k = (-sin_chain_theta_6_k).mul_add(R::literal(49.05), t312_k);
        let t314_k = t313_k - t295_k;
        let t315_k = t314_k - t296_k;
        let t316_k = t315_k - t297_k;
        let t317_k = t316_k - t298_k;
        let t319_k = t190.mul_add(t151_k, t151.mul_add(t190_k, sums_43[2]));
        let t320_k = t193.mul_add(t155_k, t155.mul_add(t193_k, sums_43[3]));
        let t321_k = t195.mul_add(t159_k, t159.mul_add(t195_k, sums_44[0]));
        let t322_k = t216_k * R::literal(4.0);
        let t323_k = t322.mul_add(t21_k, t21.mul_add(t322_k, sums_44[1]));
        let t324_k = t171_k * R::literal(4.0);
        let t325_k = t324.mul_add(t52_k, t52.mul_add(t324_k, sums_44[2]));
        let t326_k = t174_k * R::literal(4.0);
        let t327_k = t326.mul_add(t79_k, t79.mul_add(t326_k, sums_44[3]));
        let t328_k = t177_k * R::literal(4.0);
        let t329_k = t328.mul_add(t102_k, t102.mul_add(t328_k, sums_45[0]));
        let t330_k = t180_k * R::literal(4.0);
        let t331_k = t330.mul_add(t121_k, t121.mul_add(t330_k, sums_45[1]));
        let t332_k = t183_k * R::literal(4.0);
        let t333_k = t332.mul_add(t136_k, t136.mul_add(t332_k, sums_45[2]));
        let t334_k = t323_k + t325_k;
        let t335_k = t334_k + t327_k;
        let t336_k = t335_k + t329_k;
        let t337_k = t336_k + t331_k;
        let t338_k = t337_k + t333_k;
        let t339_k = (-sin_chain_theta_7_k).mul_add(R::literal(39.24), t338_k);
        let t340_k = t339_k - t319_k;
        let t341_k = t340_k - t320_k;
        let t342_k = t341_k - t321_k;
        let t344_k = t193.mul_add(t162_k, t162.mul_add(t193_k, sums_45[3]));
        let t345_k = t195.mul_add(t166_k, t166.mul_add(t195_k, sums_46[0]));
        let t346_k = t216_k * R::literal(3.0);
        let t347_k = t346.mul_add(t25_k, t25.mul_add(t346_k, sums_46[1]));
        let t348_k = t171_k * R::literal(3.0);
        let t349_k = t348.mul_add(t56_k, t56.mul_add(t348_k, sums_46[2]));
        let t350_k = t174_k * R::literal(3.0);
        let t351_k = t350.mul_add(t83_k, t83.mul_add(t350_k, sums_46[3]));
        let t352_k = t177_k * R::literal(3.0);
        let t353_k = t352.mul_add(t106_k, t106.mul_add(t352_k, sums_47[0]));
        let t354_k = t180_k * R::literal(3.0);
        let t355_k = t354.mul_add(t125_k, t125.mul_add(t354_k, sums_47[1]));
        let t356_k = t183_k * R::literal(3.0);
        let t357_k = t356.mul_add(t140_k, t140.mul_add(t356_k, sums_47[2]));
        let t358_k = t186_k * R::literal(3.0);
        let t359_k = t358.mul_add(t151_k, t151.mul_add(t358_k, sums_47[3]));
        let t360_k = t347_k + t349_k;
        let t361_k = t360_k + t351_k;
        let t362_k = t361_k + t353_k;
        let t363_k = t362_k + t355_k;
        let t364_k = t363_k + t357_k;
        let t365_k = t364_k + t359_k;
        let t366_k = (-sin_chain_theta_8_k).mul_add(R::literal(29.43), t365_k);
        let t367_k = t366_k - t344_k;
        let t368_k = t367_k - t345_k;
        let t370_k = t195.mul_add(t169_k, t169.mul_add(t195_k, sums_48[0]));
        let t371_k = t216_k * R::literal(2.0);
        let t372_k = t371.mul_add(t29_k, t29.mul_add(t371_k, sums_48[1]));
        let t373_k = t171_k * R::literal(2.0);
        let t374_k = t373.mul_add(t60_k, t60.mul_add(t373_k, sums_48[2]));
        let t375_k = t174_k * R::literal(2.0);
        let t376_k = t375.mul_add(t87_k, t87.mul_add(t375_k, sums_48[3]));
        let t377_k = t177_k * R::literal(2.0);
        let t378_k = t377.mul_add(t110_k, t110.mul_add(t377_k, sums_49[0]));
        let t379_k = t180_k * R::literal(2.0);
        let t380_k = t379.mul_add(t129_k, t129.mul_add(t379_k, sums_49[1]));
        let t381_k = t183_k * R::literal(2.0);
        let t382_k = t381.mul_add(t144_k, t144.mul_add(t381_k, sums_49[2]));
        let t383_k = t186_k * R::literal(2.0);
        let t384_k = t383.mul_add(t155_k, t155.mul_add(t383_k, sums_49[3]));
        let t385_k = t189_k * R::literal(2.0);
        let t386_k = t385.mul_add(t162_k, t162.mul_add(t385_k, sums_50[0]));
        let t387_k = t372_k + t374_k;
        let t388_k = t387_k + t376_k;
        let t389_k = t388_k + t378_k;
        let t390_k = t389_k + t380_k;
        let t391_k = t390_k + t382_k;
        let t392_k = t391_k + t384_k;
        let t393_k = t392_k + t386_k;
        let t394_k = (-sin_chain_theta_9_k).mul_add(R::literal(19.62), t393_k);
        let t395_k = t394_k - t370_k;
        let t397_k = t216.mul_add(t33_k, t33.mul_add(t216_k, sums_50[1]));
        let t398_k = t171.mul_add(t64_k, t64.mul_add(t171_k, sums_50[2]));
        let t399_k = t174.mul_add(t91_k, t91.mul_add(t174_k, sums_50[3]));
        let t400_k = t177.mul_add(t114_k, t114.mul_add(t177_k, sums_51[0]));
        let t401_k = t180.mul_add(t133_k, t133.mul_add(t180_k, sums_51[1]));
        let t402_k = t183.mul_add(t148_k, t148.mul_add(t183_k, sums_51[2]));
        let t403_k = t186.mul_add(t159_k, t159.mul_add(t186_k, sums_51[3]));
        let t404_k = t189.mul_add(t166_k, t166.mul_add(t189_k, sums_52[0]));
        let t405_k = t192.mul_add(t169_k, t169.mul_add(t192_k, sums_52[1]));
        let t406_k = t397_k + t398_k;
        let t407_k = t406_k + t399_k;
        let t408_k = t407_k + t400_k;
        let t409_k = t408_k + t401_k;
        let t410_k = t409_k + t402_k;
        let t411_k = t410_k + t403_k;
        let t412_k = t411_k + t404_k;
        let t413_k = t412_k + t405_k;
        let t414_k = (-sin_chain_theta_10_k).mul_add(R::literal(9.81), t413_k);
        let n485_k = t3_k.mul_add(chain_omega_2_dot, sums_52[2]);
        let n486_k = t7_k.mul_add(chain_omega_3_dot, sums_52[3]);
        let n487_k = t11_k.mul_add(chain_omega_4_dot, sums_53[0]);
        let n488_k = t15_k.mul_add(chain_omega_5_dot, sums_53[1]);
        let n489_k = t19_k.mul_add(chain_omega_6_dot, sums_53[2]);
        let n490_k = t23_k.mul_add(chain_omega_7_dot, sums_53[3]);
        let n491_k = t27_k.mul_add(chain_omega_8_dot, sums_54[0]);
        let n492_k = t31_k.mul_add(chain_omega_9_dot, sums_54[1]);
        let n493_k = t34_k.mul_add(chain_omega_10_dot, sums_54[2]);
        let n494_k = t3_k.mul_add(chain_omega_1_dot, sums_54[3]);
        let n495_k = t38_k.mul_add(chain_omega_3_dot, sums_55[0]);
        let n496_k = t42_k.mul_add(chain_omega_4_dot, sums_55[1]);
        let n497_k = t46_k.mul_add(chain_omega_5_dot, sums_55[2]);
        let n498_k = t50_k.mul_add(chain_omega_6_dot, sums_55[3]);
        let n499_k = t54_k.mul_add(chain_omega_7_dot, sums_56[0]);
        let n500_k = t58_k.mul_add(chain_omega_8_dot, sums_56[1]);
        let n501_k = t62_k.mul_add(chain_omega_9_dot, sums_56[2]);
        let n502_k = t65_k.mul_add(chain_omega_10_dot, sums_56[3]);
        let n503_k = t7_k.mul_add(chain_omega_1_dot, sums_57[0]);
        let n504_k = t38_k.mul_add(chain_omega_2_dot, sums_57[1]);
        let n505_k = t69_k.mul_add(chain_omega_4_dot, sums_57[2]);
        let n506_k = t73_k.mul_add(chain_omega_5_dot, sums_57[3]);
        let n507_k = t77_k.mul_add(chain_omega_6_dot, sums_58[0]);
        let n508_k = t81_k.mul_add(chain_omega_7_dot, sums_58[1]);
        let n509_k = t85_k.mul_add(chain_omega_8_dot, sums_58[2]);
        let n510_k = t89_k.mul_add(chain_omega_9_dot, sums_58[3]);
        let n511_k = t92_k.mul_add(chain_omega_10_dot, sums_59[0]);
        let n512_k = t11_k.mul_add(chain_omega_1_dot, sums_59[1]);
        let n513_k = t42_k.mul_add(chain_omega_2_dot, sums_59[2]);
        let n514_k = t69_k.mul_add(chain_omega_3_dot, sums_59[3]);
        let n515_k = t96_k.mul_add(chain_omega_5_dot, sums_60[0]);
        let n516_k = t100_k.mul_add(chain_omega_6_dot, sums_60[1]);
        let n517_k = t104_k.mul_add(chain_omega_7_dot, sums_60[2]);
        let n518_k = t108_k.mul_add(chain_omega_8_dot, sums_60[3]);
        let n519_k = t112_k.mul_add(chain_omega_9_dot, sums_61[0]);
        let n520_k = t115_k.mul_add(chain_omega_10_dot, sums_61[1]);
        let n521_k = t15_k.mul_add(chain_omega_1_dot, sums_61[2]);
        let n522_k = t46_k.mul_add(chain_omega_2_dot, sums_61[3]);
        let n523_k = t73_k.mul_add(chain_omega_3_dot, sums_62[0]);
        let n524_k = t96_k.mul_add(chain_omega_4_dot, sums_62[1]);
        let n525_k = t119_k.mul_add(chain_omega_6_dot, sums_62[2]);
        let n526_k = t123_k.mul_add(chain_omega_7_dot, sums_62[3]);
        let n527_k = t127_k.mul_add(chain_omega_8_dot, sums_63[0]);
        let n528_k = t131_k.mul_add(chain_omega_9_dot, sums_63[1]);
        let n529_k = t134_k.mul_add(chain_omega_10_dot, sums_63[2]);
        let n530_k = t19_k.mul_add(chain_omega_1_dot, sums_63[3]);
        let n531_k = t50_k.mul_add(chain_omega_2_dot, sums_64[0]);
        let n532_k = t77_k.mul_add(chain_omega_3_dot, sums_64[1]);
        let n533_k = t100_k.mul_add(chain_omega_4_dot, sums_64[2]);
        let n534_k = t119_k.mul_add(chain_omega_5_dot, sums_64[3]);
        let n535_k = t138_k.mul_add(chain_omega_7_dot, sums_65[0]);
        let n536_k = t142_k.mul_add(chain_omega_8_dot, sums_65[1]);
        let n537_k = t146_k.mul_add(chain_omega_9_dot, sums_65[2]);
        let n538_k = t149_k.mul_add(chain_omega_10_dot, sums_65[3]);
        let n539_k = t23_k.mul_add(chain_omega_1_dot, sums_66[0]);
        let n540_k = t54_k.mul_add(chain_omega_2_dot, sums_66[1]);
        let n541_k = t81_k.mul_add(chain_omega_3_dot, sums_66[2]);
        let n542_k = t104_k.mul_add(chain_omega_4_dot, sums_66[3]);
        let n543_k = t123_k.mul_add(chain_omega_5_dot, sums_67[0]);
        let n544_k = t138_k.mul_add(chain_omega_6_dot, sums_67[1]);
        let n545_k = t153_k.mul_add(chain_omega_8_dot, sums_67[2]);
        let n546_k = t157_k.mul_add(chain_omega_9_dot, sums_67[3]);
        let n547_k = t160_k.mul_add(chain_omega_10_dot, sums_68[0]);
        let n548_k = t27_k.mul_add(chain_omega_1_dot, sums_68[1]);
        let n549_k = t58_k.mul_add(chain_omega_2_dot, sums_68[2]);
        let n550_k = t85_k.mul_add(chain_omega_3_dot, sums_68[3]);
        let n551_k = t108_k.mul_add(chain_omega_4_dot, sums_69[0]);
        let n552_k = t127_k.mul_add(chain_omega_5_dot, sums_69[1]);
        let n553_k = t142_k.mul_add(chain_omega_6_dot, sums_69[2]);
        let n554_k = t153_k.mul_add(chain_omega_7_dot, sums_69[3]);
        let n555_k = t164_k.mul_add(chain_omega_9_dot, sums_70[0]);
        let n556_k = t167_k.mul_add(chain_omega_10_dot, sums_70[1]);
        let n557_k = t31_k.mul_add(chain_omega_1_dot, sums_70[2]);
        let n558_k = t62_k.mul_add(chain_omega_2_dot, sums_70[3]);
        let n559_k = t89_k.mul_add(chain_omega_3_dot, sums_71[0]);
        let n560_k = t112_k.mul_add(chain_omega_4_dot, sums_71[1]);
        let n561_k = t131_k.mul_add(chain_omega_5_dot, sums_71[2]);
        let n562_k = t146_k.mul_add(chain_omega_6_dot, sums_71[3]);
        let n563_k = t157_k.mul_add(chain_omega_7_dot, sums_72[0]);
        let n564_k = t164_k.mul_add(chain_omega_8_dot, sums_72[1]);
        let n565_k = t170_k.mul_add(chain_omega_10_dot, sums_72[2]);
        let n566_k = t34_k.mul_add(chain_omega_1_dot, sums_72[3]);
        let n567_k = t65_k.mul_add(chain_omega_2_dot, sums_73[0]);
        let n568_k = t92_k.mul_add(chain_omega_3_dot, sums_73[1]);
        let n569_k = t115_k.mul_add(chain_omega_4_dot, sums_73[2]);
        let n570_k = t134_k.mul_add(chain_omega_5_dot, sums_73[3]);
        let n571_k = t149_k.mul_add(chain_omega_6_dot, sums_74[0]);
        let n572_k = t160_k.mul_add(chain_omega_7_dot, sums_74[1]);
        let n573_k = t167_k.mul_add(chain_omega_8_dot, sums_74[2]);
        let n574_k = t170_k.mul_add(chain_omega_9_dot, sums_74[3]);
        let n575_k = n485_k + n486_k;
        let n576_k = n487_k + n488_k;
        let n577_k = n575_k + n576_k;
        let n578_k = n489_k + n490_k;
        let n579_k = n492_k + n493_k;
        let n580_k = n491_k + n579_k;
        let n581_k = n578_k + n580_k;
        let n582_k = n577_k + n581_k;
        let t206_k_2 = t206_k - n582_k;
        let n584_k = n494_k + n495_k;
        let n585_k = n496_k + n497_k;
        let n586_k = n584_k + n585_k;
        let n587_k = n498_k + n499_k;
        let n588_k = n501_k + n502_k;
        let n589_k = n500_k + n588_k;
        let n590_k = n587_k + n589_k;
        let n591_k = n586_k + n590_k;
        let t227_k_2 = t227_k - n591_k;
        let n593_k = n503_k + n504_k;
        let n594_k = n505_k + n506_k;
        let n595_k = n593_k + n594_k;
        let n596_k = n507_k + n508_k;
        let n597_k = n510_k + n511_k;
        let n598_k = n509_k + n597_k;
        let n599_k = n596_k + n598_k;
        let n600_k = n595_k + n599_k;
        let t248_k_2 = t248_k - n600_k;
        let n602_k = n512_k + n513_k;
        let n603_k = n514_k + n515_k;
        let n604_k = n602_k + n603_k;
        let n605_k = n516_k + n517_k;
        let n606_k = n519_k + n520_k;
        let n607_k = n518_k + n606_k;
        let n608_k = n605_k + n607_k;
        let n609_k = n604_k + n608_k;
        let t270_k_2 = t270_k - n609_k;
        let n611_k = n521_k + n522_k;
        let n612_k = n523_k + n524_k;
        let n613_k = n611_k + n612_k;
        let n614_k = n525_k + n526_k;
        let n615_k = n528_k + n529_k;
        let n616_k = n527_k + n615_k;
        let n617_k = n614_k + n616_k;
        let n618_k = n613_k + n617_k;
        let t293_k_2 = t293_k - n618_k;
        let n620_k = n530_k + n531_k;
        let n621_k = n532_k + n533_k;
        let n622_k = n620_k + n621_k;
        let n623_k = n534_k + n535_k;
        let n624_k = n537_k + n538_k;
        let n625_k = n536_k + n624_k;
        let n626_k = n623_k + n625_k;
        let n627_k = n622_k + n626_k;
        let t317_k_2 = t317_k - n627_k;
        let n629_k = n539_k + n540_k;
        let n630_k = n541_k + n542_k;
        let n631_k = n629_k + n630_k;
        let n632_k = n543_k + n544_k;
        let n633_k = n546_k + n547_k;
        let n634_k = n545_k + n633_k;
        let n635_k = n632_k + n634_k;
        let n636_k = n631_k + n635_k;
        let t342_k_2 = t342_k - n636_k;
        let n638_k = n548_k + n549_k;
        let n639_k = n550_k + n551_k;
        let n640_k = n638_k + n639_k;
        let n641_k = n552_k + n553_k;
        let n642_k = n555_k + n556_k;
        let n643_k = n554_k + n642_k;
        let n644_k = n641_k + n643_k;
        let n645_k = n640_k + n644_k;
        let t368_k_2 = t368_k - n645_k;
        let n647_k = n557_k + n558_k;
        let n648_k = n559_k + n560_k;
        let n649_k = n647_k + n648_k;
        let n650_k = n561_k + n562_k;
        let n651_k = n564_k + n565_k;
        let n652_k = n563_k + n651_k;
        let n653_k = n650_k + n652_k;
        let n654_k = n649_k + n653_k;
        let t395_k_2 = t395_k - n654_k;
        let n656_k = n566_k + n567_k;
        let n657_k = n568_k + n569_k;
        let n658_k = n656_k + n657_k;
        let n659_k = n570_k + n571_k;
        let n660_k = n573_k + n574_k;
        let n661_k = n572_k + n660_k;
        let n662_k = n659_k + n661_k;
        let n663_k = n658_k + n662_k;
        let t414_k_2 = t414_k - n663_k;
        let [chain_omega_1_dot_k, chain_omega_2_dot_k, chain_omega_3_dot_k, chain_omega_4_dot_k,
            chain_omega_5_dot_k, chain_omega_6_dot_k, chain_omega_7_dot_k, chain_omega_8_dot_k,
            chain_omega_9_dot_k, chain_omega_10_dot_k] = factored.solve([t206_k_2, t227_k_2,
            t248_k_2, t270_k_2, t293_k_2, t317_k_2, t342_k_2, t368_k_2, t395_k_2, t414_k_2]);
        lanes.set(order, [chain_omega_2_k, chain_omega_3_k, chain_omega_4_k, chain_omega_5_k],
            [chain_omega_2_k, chain_omega_3_k, chain_omega_4_k, chain_omega_5_k]);
        lanes_1.set(order, [chain_omega_6_k, chain_omega_7_k, chain_omega_8_k, chain_omega_9_k],
            [chain_omega_6_k, chain_omega_7_k, chain_omega_8_k, chain_omega_9_k]);
        lanes_2.set(order, [chain_omega_10_k, chain_omega_1_k, k * chain_theta_1_k,
            k * chain_theta_1_k], [chain_omega_10_k, chain_omega_1_k, cos_chain_theta_1_k,
            sin_chain_theta_1_k]);
        lanes_3.set(order, [k * chain_theta_2_k, k * chain_theta_2_k, k * chain_theta_3_k,
            k * chain_theta_3_k], [cos_chain_theta_2_k, sin_chain_theta_2_k, cos_chain_theta_3_k,
            sin_chain_theta_3_k]);
        lanes_4.set(order, [k * chain_theta_4_k, k * chain_theta_4_k, k * chain_theta_5_k,
            k * chain_theta_5_k], [cos_chain_theta_4_k, sin_chain_theta_4_k, cos_chain_theta_5_k,
            sin_chain_theta_5_k]);
        lanes_5.set(order, [k * chain_theta_6_k, k * chain_theta_6_k, k * chain_theta_7_k,
            k * chain_theta_7_k], [cos_chain_theta_6_k, sin_chain_theta_6_k, cos_chain_theta_7_k,
            sin_chain_theta_7_k]);
        lanes_6.set(order, [k * chain_theta_8_k, k * chain_theta_8_k, k * chain_theta_9_k,
            k * chain_theta_9_k], [cos_chain_theta_8_k, sin_chain_theta_8_k, cos_chain_theta_9_k,
            sin_chain_theta_9_k]);
        lanes_7.set(order, [k * chain_theta_10_k, k * chain_theta_10_k, k * t0_k, k * t0_k],
            [cos_chain_theta_10_k, sin_chain_theta_10_k, t2_k, t1_k]);
        lanes_8.set(order, [k * t4_k, k * t4_k, k * t8_k, k * t8_k], [t6_k, t5_k, t10_k, t9_k]);
        lanes_9.set(order, [k * t12_k, k * t12_k, k * t16_k, k * t16_k], [t14_k, t13_k, t18_k,
            t17_k]);
        lanes_10.set(order, [k * t20_k, k * t20_k, k * t24_k, k * t24_k], [t22_k, t21_k, t26_k,
            t25_k]);
        lanes_11.set(order, [k * t28_k, k * t28_k, k * t32_k, k * t32_k], [t30_k, t29_k, t34_k,
            t33_k]);
        lanes_12.set(order, [k * t35_k, k * t35_k, k * t39_k, k * t39_k], [t37_k, t36_k, t41_k,
            t40_k]);
        lanes_13.set(order, [k * t43_k, k * t43_k, k * t47_k, k * t47_k], [t45_k, t44_k, t49_k,
            t48_k]);
        lanes_14.set(order, [k * t51_k, k * t51_k, k * t55_k, k * t55_k], [t53_k, t52_k, t57_k,
            t56_k]);
        lanes_15.set(order, [k * t59_k, k * t59_k, k * t63_k, k * t63_k], [t61_k, t60_k, t65_k,
            t64_k]);
        lanes_16.set(order, [k * t66_k, k * t66_k, k * t70_k, k * t70_k], [t68_k, t67_k, t72_k,
            t71_k]);
        lanes_17.set(order, [k * t74_k, k * t74_k, k * t78_k, k * t78_k], [t76_k, t75_k, t80_k,
            t79_k]);
        lanes_18.set(order, [k * t82_k, k * t82_k, k * t86_k, k * t86_k], [t84_k, t83_k, t88_k,
            t87_k]);
        lanes_19.set(order, [k * t90_k, k * t90_k, k * t93_k, k * t93_k], [t92_k, t91_k, t95_k,
            t94_k]);
        lanes_20.set(order, [k * t97_k, k * t97_k, k * t101_k, k * t101_k], [t99_k, t98_k, t103_k,
            t102_k]);
        lanes_21.set(order, [k * t105_k, k * t105_k, k * t109_k, k * t109_k], [t107_k, t106_k,
            t111_k, t110_k]);
        lanes_22.set(order, [k * t113_k, k * t113_k, k * t116_k, k * t116_k], [t115_k, t114_k,
            t118_k, t117_k]);
        lanes_23.set(order, [k * t120_k, k * t120_k, k * t124_k, k * t124_k], [t122_k, t121_k,
            t126_k, t125_k]);
        lanes_24.set(order, [k * t128_k, k * t128_k, k * t132_k, k * t132_k], [t130_k, t129_k,
            t134_k, t133_k]);
        lanes_25.set(order, [k * t135_k, k * t135_k, k * t139_k, k * t139_k], [t137_k, t136_k,
            t141_k, t140_k]);
        lanes_26.set(order, [k * t143_k, k * t143_k, k * t147_k, k * t147_k], [t145_k, t144_k,
            t149_k, t148_k]);
        lanes_27.set(order, [k * t150_k, k * t150_k, k * t154_k, k * t154_k], [t152_k, t151_k,
            t156_k, t155_k]);
        lanes_28.set(order, [k * t158_k, k * t158_k, k * t161_k, k * t161_k], [t160_k, t159_k,
            t163_k, t162_k]);
        lanes_29.set(order, [k * t165_k, k * t165_k, k * t168_k, k * t168_k], [t167_k, t166_k,
            t170_k, t169_k]);
        lanes_30.set(order, [t1_k, t5_k, t9_k, t13_k], [t172_k, t175_k, t178_k, t181_k]);
        lanes_31.set(order, [t17_k, t21_k, t25_k, t29_k], [t184_k, t187_k, t190_k, t193_k]);
        lanes_32.set(order, [t33_k, t36_k, t40_k, t44_k], [t195_k, t175_k, t178_k, t181_k]);
        lanes_33.set(order, [t48_k, t52_k, t56_k, t60_k], [t184_k, t187_k, t190_k, t193_k]);
        lanes_34.set(order, [t64_k, t1_k, t67_k, t71_k], [t195_k, t217_k, t178_k, t181_k]);
        lanes_35.set(order, [t75_k, t79_k, t83_k, t87_k], [t184_k, t187_k, t190_k, t193_k]);
        lanes_36.set(order, [t91_k, t5_k, t36_k, t94_k], [t195_k, t236_k, t238_k, t181_k]);
        lanes_37.set(order, [t98_k, t102_k, t106_k, t110_k], [t184_k, t187_k, t190_k, t193_k]);
        lanes_38.set(order, [t114_k, t9_k, t40_k, t67_k], [t195_k, t256_k, t258_k, t260_k]);
        lanes_39.set(order, [t117_k, t121_k, t125_k, t129_k], [t184_k, t187_k, t190_k, t193_k]);
        lanes_40.set(order, [t133_k, t13_k, t44_k, t71_k], [t195_k, t277_k, t279_k, t281_k]);
        lanes_41.set(order, [t94_k, t136_k, t140_k, t144_k], [t283_k, t187_k, t190_k, t193_k]);
        lanes_42.set(order, [t148_k, t17_k, t48_k, t75_k], [t195_k, t299_k, t301_k, t303_k]);
        lanes_43.set(order, [t98_k, t117_k, t151_k, t155_k], [t305_k, t307_k, t190_k, t193_k]);
        lanes_44.set(order, [t159_k, t21_k, t52_k, t79_k], [t195_k, t322_k, t324_k, t326_k]);
        lanes_45.set(order, [t102_k, t121_k, t136_k, t162_k], [t328_k, t330_k, t332_k, t193_k]);
        lanes_46.set(order, [t166_k, t25_k, t56_k, t83_k], [t195_k, t346_k, t348_k, t350_k]);
        lanes_47.set(order, [t106_k, t125_k, t140_k, t151_k], [t352_k, t354_k, t356_k, t358_k]);
        lanes_48.set(order, [t169_k, t29_k, t60_k, t87_k], [t195_k, t371_k, t373_k, t375_k]);
        lanes_49.set(order, [t110_k, t129_k, t144_k, t155_k], [t377_k, t379_k, t381_k, t383_k]);
        lanes_50.set(order, [t162_k, t33_k, t64_k, t91_k], [t385_k, t216_k, t171_k, t174_k]);
        lanes_51.set(order, [t114_k, t133_k, t148_k, t159_k], [t177_k, t180_k, t183_k, t186_k]);
        lanes_52.set(order, [t166_k, t169_k, t3_k, t7_k], [t189_k, t192_k, chain_omega_2_dot_k,
            chain_omega_3_dot_k]);
        lanes_53.set(order, [t11_k, t15_k, t19_k, t23_k], [chain_omega_4_dot_k,
            chain_omega_5_dot_k, chain_omega_6_dot_k, chain_omega_7_dot_k]);
        lanes_54.set(order, [t27_k, t31_k, t34_k, t3_k], [chain_omega_8_dot_k, chain_omega_9_dot_k,
            chain_omega_10_dot_k, chain_omega_1_dot_k]);
        lanes_55.set(order, [t38_k, t42_k, t46_k, t50_k], [chain_omega_3_dot_k,
            chain_omega_4_dot_k, chain_omega_5_dot_k, chain_omega_6_dot_k]);
        lanes_56.set(order, [t54_k, t58_k, t62_k, t65_k], [chain_omega_7_dot_k,
            chain_omega_8_dot_k, chain_omega_9_dot_k, chain_omega_10_dot_k]);
        lanes_57.set(order, [t7_k, t38_k, t69_k, t73_k], [chain_omega_1_dot_k, chain_omega_2_dot_k,
            chain_omega_4_dot_k, chain_omega_5_dot_k]);
        lanes_58.set(order, [t77_k, t81_k, t85_k, t89_k], [chain_omega_6_dot_k,
            chain_omega_7_dot_k, chain_omega_8_dot_k, chain_omega_9_dot_k]);
        lanes_59.set(order, [t92_k, t11_k, t42_k, t69_k], [chain_omega_10_dot_k,
            chain_omega_1_dot_k, chain_omega_2_dot_k, chain_omega_3_dot_k]);
        lanes_60.set(order, [t96_k, t100_k, t104_k, t108_k], [chain_omega_5_dot_k,
            chain_omega_6_dot_k, chain_omega_7_dot_k, chain_omega_8_dot_k]);
        lanes_61.set(order, [t112_k, t115_k, t15_k, t46_k], [chain_omega_9_dot_k,
            chain_omega_10_dot_k, chain_omega_1_dot_k, chain_omega_2_dot_k]);
        lanes_62.set(order, [t73_k, t96_k, t119_k, t123_k], [chain_omega_3_dot_k,
            chain_omega_4_dot_k, chain_omega_6_dot_k, chain_omega_7_dot_k]);
        lanes_63.set(order, [t127_k, t131_k, t134_k, t19_k], [chain_omega_8_dot_k,
            chain_omega_9_dot_k, chain_omega_10_dot_k, chain_omega_1_dot_k]);
        lanes_64.set(order, [t50_k, t77_k, t100_k, t119_k], [chain_omega_2_dot_k,
            chain_omega_3_dot_k, chain_omega_4_dot_k, chain_omega_5_dot_k]);
        lanes_65.set(order, [t138_k, t142_k, t146_k, t149_k], [chain_omega_7_dot_k,
            chain_omega_8_dot_k, chain_omega_9_dot_k, chain_omega_10_dot_k]);
        lanes_66.set(order, [t23_k, t54_k, t81_k, t104_k], [chain_omega_1_dot_k,
            chain_omega_2_dot_k, chain_omega_3_dot_k, chain_omega_4_dot_k]);
        lanes_67.set(order, [t123_k, t138_k, t153_k, t157_k], [chain_omega_5_dot_k,
            chain_omega_6_dot_k, chain_omega_8_dot_k, chain_omega_9_dot_k]);
        lanes_68.set(order, [t160_k, t27_k, t58_k, t85_k], [chain_omega_10_dot_k,
            chain_omega_1_dot_k, chain_omega_2_dot_k, chain_omega_3_dot_k]);
        lanes_69.set(order, [t108_k, t127_k, t142_k, t153_k], [chain_omega_4_dot_k,
            chain_omega_5_dot_k, chain_omega_6_dot_k, chain_omega_7_dot_k]);
        lanes_70.set(order, [t164_k, t167_k, t31_k, t62_k], [chain_omega_9_dot_k,
            chain_omega_10_dot_k, chain_omega_1_dot_k, chain_omega_2_dot_k]);
        lanes_71.set(order, [t89_k, t112_k, t131_k, t146_k], [chain_omega_3_dot_k,
            chain_omega_4_dot_k, chain_omega_5_dot_k, chain_omega_6_dot_k]);
        lanes_72.set(order, [t157_k, t164_k, t170_k, t34_k], [chain_omega_7_dot_k,
            chain_omega_8_dot_k, chain_omega_10_dot_k, chain_omega_1_dot_k]);
        lanes_73.set(order, [t65_k, t92_k, t115_k, t134_k], [chain_omega_2_dot_k,
            chain_omega_3_dot_k, chain_omega_4_dot_k, chain_omega_5_dot_k]);
        lanes_74.set(order, [t149_k, t160_k, t167_k, t170_k], [chain_omega_6_dot_k,
            chain_omega_7_dot_k, chain_omega_8_dot_k, chain_omega_9_dot_k]);
        rates = [chain_omega_1_k, chain_omega_2_k, chain_omega_3_k, chain_omega_4_k,
            chain_omega_5_k, chain_omega_6_k, chain_omega_7_k, chain_omega_8_k, chain_omega_9_k,
            chain_omega_10_k, chain_omega_1_dot_k, chain_omega_2_dot_k, chain_omega_3_dot_k,
            chain_omega_4_dot_k, chain_omega_5_dot_k, chain_omega_6_dot_k, chain_omega_7_dot_k,
            chain_omega_8_dot_k, chain_omega_9_dot_k, chain_omega_10_dot_k];
    }
}

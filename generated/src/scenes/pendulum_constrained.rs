// Emitted by Machinist 0.1.0; do not edit. To make it again:
//
//     cargo run --release -- gen
//
// Sources, with SHA-256:
//   c240fcede2008db131f14a86d7cfd2a9484a94c3e08b27a91d5e8a9191ef7a6b  scenes/pendulum_constrained.toml
//   64acac656bdcd3eff72da121666c55c5813f1a41cb59e10f86d23f461a961f05  units/point_mass.toml
//
// Triple pendulum, by constraints
//
// The machine of `pendulum_chain` as three point masses in a plane, each at a fixed distance from the
// one above. The constraint forces are those in the links.
//
// Source:
//   Textbook.
//
// All quantities are in SI units.
// Shapes: coordinates 6, states 12, parameters 12, outputs 5, constraints 3.
// Nonzeros: mass_matrix 6 of 6 by 6, rate_jacobian 78 of 12 by 12, parameter_jacobian 36 of 12 by 12,
//     constraint_matrix 10 of 3 by 6.
// Operations: initial_state 8, rate 132, forcing 6, rate_jacobian 514, parameter_jacobian 305,
//     outputs 111, energy 25, power_balance 153, constraint_values 25, constraint_rates 33,
//     constraint_matrix 17, prepare 18, prepared_rate 120, prepared_rate_jacobian 499,
//     prepared_jacobians 672.

use ::machinist_contract::{Energy, PowerBalance, Real};

::machinist_contract::simulator! {
    /// Triple pendulum, by constraints
    ///
    /// The machine of \`pendulum_chain\` as three point masses in a plane, each at a fixed distance from the
    /// one above. The constraint forces are those in the links.
    ///
    /// Source: Textbook.
    PendulumConstrained: "pendulum_constrained", "Triple pendulum, by constraints";
    run from 0.0, until 5.0, points 1001, rtol 1e-8, method "dop853";
    quadratures 0, discontinuities 0;
    constraints; prepared; jacobians_at_once;
}

::machinist_contract::parameters! {
    l_1: 1.0, "m", "l_1", "length of the first link";
    l_2: 0.7, "m", "l_2", "length of the second link";
    l_3: 0.4, "m", "l_3", "length of the third link";
    th_1: 0.9, "rad", "th_1", "initial angle of the first link";
    th_2: 1.1, "rad", "th_2", "initial angle of the second link";
    th_3: 1.4, "rad", "th_3", "initial angle of the third link";
    first_mass: 1.0, "kg", "first.mass", "mass";
    first_gravity: 9.81, "m/s^2", "first.gravity", "gravitational acceleration";
    second_mass: 0.8, "kg", "second.mass", "mass";
    second_gravity: 9.81, "m/s^2", "second.gravity", "gravitational acceleration";
    third_mass: 0.5, "kg", "third.mass", "mass";
    third_gravity: 9.81, "m/s^2", "third.gravity", "gravitational acceleration";
}

::machinist_contract::outputs! {
    end_x: "m", "end_x", "horizontal position";
    end_y: "m", "end_y", "height";
    force_1: at_once "N", "force_1", "force in the first link, positive in compression";
    force_2: at_once "N", "force_2", "force in the second link, positive in compression";
    force_3: at_once "N", "force_3", "force in the third link, positive in compression";
}

::machinist_contract::states! {
    FIRST_X: position, 1.0, "m", "first.x", "horizontal position";
    FIRST_Y: position guess, 1.0, "m", "first.y", "height";
    SECOND_X: position, 1.0, "m", "second.x", "horizontal position";
    SECOND_Y: position guess, 1.0, "m", "second.y", "height";
    THIRD_X: position, 1.0, "m", "third.x", "horizontal position";
    THIRD_Y: position guess, 1.0, "m", "third.y", "height";
    FIRST_V_X: velocity guess, 1.0, "m/s", "first.v_x", "rate of horizontal position";
    FIRST_V_Y: velocity guess, 1.0, "m/s", "first.v_y", "rate of height";
    SECOND_V_X: velocity guess, 1.0, "m/s", "second.v_x", "rate of horizontal position";
    SECOND_V_Y: velocity guess, 1.0, "m/s", "second.v_y", "rate of height";
    THIRD_V_X: velocity guess, 1.0, "m/s", "third.v_x", "rate of horizontal position";
    THIRD_V_Y: velocity guess, 1.0, "m/s", "third.v_y", "rate of height";
}

::machinist_contract::constraints! {
    "link_1": of_positions, "m", "length of the first link";
    "link_2": of_positions, "m", "length of the second link";
    "link_3": of_positions, "m", "length of the third link";
}

::machinist_contract::patterns! {
    /// Nonzeros of M.
    MASS_MATRIX_PATTERN: 6 by 6 { 0 [0] 1 [1] 2 [2] 3 [3] 4 [4] 5 [5] }
    /// Nonzeros of dy'/dy.
    RATE_JACOBIAN_PATTERN: 12 by 12 { 0 [6] 1 [7] 2 [8] 3 [9] 4 [10] 5 [11]
        6 [0 1 2 3 4 5 6 7 8 9 10 11] 7 [0 1 2 3 4 5 6 7 8 9 10 11] 8 [0 1 2 3 4 5 6 7 8 9 10 11]
        9 [0 1 2 3 4 5 6 7 8 9 10 11] 10 [0 1 2 3 4 5 6 7 8 9 10 11] 11 [0 1 2 3 4 5 6 7 8 9 10 11]
        }
    /// Nonzeros of dy'/dp.
    PARAMETER_JACOBIAN_PATTERN: 12 by 12 { 6 [6 7 8 9 10 11] 7 [6 7 8 9 10 11] 8 [6 7 8 9 10 11]
        9 [6 7 8 9 10 11] 10 [6 7 8 9 10 11] 11 [6 7 8 9 10 11] }
    /// Nonzeros of G = dg'/dq'.
    CONSTRAINT_MATRIX_PATTERN: 3 by 6 { 0 [0 1] 1 [0 1 2 3] 2 [2 3 4 5] }
}

::machinist_contract::constants! {
    inverse_l_1, inverse_l_2, inverse_l_3, inverse_first_mass, inverse_second_mass, inverse_third_mass,
    first_mass_times_first_gravity, second_mass_times_second_gravity,
    third_mass_times_third_gravity, t0, t1, t2, t3, t4, t5, first_mass_times_inverse_first_mass,
    t6, third_mass_times_inverse_third_mass
}

/// Returns the constants of `rate` and its Jacobians from the parameters. 18 operations.
#[must_use]
#[inline]
pub fn prepare<R: Real>(p: &Parameters<R>) -> Constants<R> {
    let inverse_l_1 = R::literal(1.0) / p.l_1;
    let inverse_l_2 = R::literal(1.0) / p.l_2;
    let inverse_l_3 = R::literal(1.0) / p.l_3;
    let inverse_first_mass = R::literal(1.0) / p.first_mass;
    let inverse_second_mass = R::literal(1.0) / p.second_mass;
    let inverse_third_mass = R::literal(1.0) / p.third_mass;
    let first_mass_times_first_gravity = p.first_mass * p.first_gravity;
    let second_mass_times_second_gravity = p.second_mass * p.second_gravity;
    let third_mass_times_third_gravity = p.third_mass * p.third_gravity;
    let t0 = third_mass_times_third_gravity * inverse_third_mass;
    let t1 = second_mass_times_second_gravity * inverse_second_mass;
    let t2 = first_mass_times_first_gravity * inverse_first_mass;
    let t3 = R::literal(2.0) / p.l_1;
    let t4 = R::literal(2.0) / p.l_2;
    let t5 = R::literal(2.0) / p.l_3;
    let first_mass_times_inverse_first_mass = p.first_mass * inverse_first_mass;
    let t6 = p.second_mass * inverse_second_mass;
    let third_mass_times_inverse_third_mass = p.third_mass * inverse_third_mass;
    Constants { inverse_l_1, inverse_l_2, inverse_l_3, inverse_first_mass, inverse_second_mass,
        inverse_third_mass, first_mass_times_first_gravity, second_mass_times_second_gravity,
        third_mass_times_third_gravity, t0, t1, t2, t3, t4, t5,
        first_mass_times_inverse_first_mass, t6, third_mass_times_inverse_third_mass }
}

/// State at the start of the run, in the units of the states. 8 operations.
#[must_use]
pub fn initial_state<R: Real>(p: &Parameters<R>) -> [R; STATES] {
    let [(sin_th_1, _), (sin_th_2, _), (sin_th_3, _)] = R::sin_cos_each([p.th_1, p.th_2, p.th_3]);
    let l_1_times_sin_th_1 = p.l_1 * sin_th_1;
    let t0 = l_1_times_sin_th_1.add_product(p.l_2, sin_th_2);
    [l_1_times_sin_th_1, R::literal(-0.5), t0, R::literal(-1.0), t0.add_product(p.l_3, sin_th_3),
        R::literal(-1.1), R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0),
        R::literal(0.0), R::literal(0.0)]
}

/// Times of known jumps of the right-hand side \[s\], unsorted. No operations.
#[must_use]
pub fn discontinuities<R: Real>(_p: &Parameters<R>) -> [R; DISCONTINUITIES] {
    []
}

/// As `rate`, with the constants of the parameters from `prepare`. 120 operations.
#[must_use]
#[inline]
pub fn prepared_rate<R: Real>(_time: R, state: &[R; STATES], _p: &Parameters<R>,
        c: &Constants<R>) -> [R; STATES] {
    let [first_x, first_y, second_x, second_y, third_x, third_y, first_v_x, first_v_y, second_v_x,
        second_v_y, third_v_x, third_v_y] = *state;
    let inverse_l_1_times_first_x = c.inverse_l_1 * first_x;
    let t0 = c.inverse_l_2 * (second_x - first_x);
    let inverse_l_1_times_first_y = c.inverse_l_1 * first_y;
    let t1 = c.inverse_l_2 * (second_y - first_y);
    let t2 = c.inverse_l_3 * (third_x - second_x);
    let t3 = c.inverse_l_3 * (third_y - second_y);
    let t4 = inverse_l_1_times_first_x * c.inverse_first_mass;
    let t5 = t0 * c.inverse_first_mass;
    let t6 = inverse_l_1_times_first_y * c.inverse_first_mass;
    let t7 = t1 * c.inverse_first_mass;
    let t8 = t0 * c.inverse_second_mass;
    let t9 = t2 * c.inverse_second_mass;
    let t10 = t1 * c.inverse_second_mass;
    let t11 = t3 * c.inverse_second_mass;
    let t12 = t2 * c.inverse_third_mass;
    let t13 = t3 * c.inverse_third_mass;
    let t14 = R::literal(1.0) / (t4 * inverse_l_1_times_first_x).add_product(t6,
        inverse_l_1_times_first_y);
    let t15 = (t5 * inverse_l_1_times_first_x).add_product(t7, inverse_l_1_times_first_y);
    let t16 = t15 * t14;
    let t17 = R::literal(1.0) / (-(t5 * t0).add_product(t7, t1).add_product(t8, t0)
        .add_product(t10, t1)).add_product(t16, t15);
    let t18 = (t9 * t0).add_product(t11, t1);
    let t19 = t18 * t17;
    let first_v_x_squared = first_v_x * first_v_x;
    let first_v_y_squared = first_v_y * first_v_y;
    let second_v_x_squared = second_v_x * second_v_x;
    let second_v_y_squared = second_v_y * second_v_y;
    let t20 = (t6 * c.first_mass_times_first_gravity).sub_product(c.inverse_l_1, first_v_x_squared
        + first_v_y_squared);
    let t21 = (-(t7 * c.first_mass_times_first_gravity)).add_product(c.inverse_l_2,
        (R::literal(2.0) * first_v_x * second_v_x).add_product(R::literal(2.0) * first_v_y,
        second_v_y) - first_v_x_squared - first_v_y_squared - second_v_x_squared
        - second_v_y_squared).add_product(t10, c.second_mass_times_second_gravity).add_product(t16,
        t20);
    let link_3 = (-(t11 * c.second_mass_times_second_gravity)).add_product(c.inverse_l_3,
        ((R::literal(2.0) * second_v_x * third_v_x).add_product(R::literal(2.0) * second_v_y,
        third_v_y) - second_v_x_squared - second_v_y_squared).sub_product(third_v_x, third_v_x)
        .sub_product(third_v_y, third_v_y)).add_product(t13, c.third_mass_times_third_gravity)
        .sub_product(t19, t21) * (R::literal(1.0) / (t9 * t2).add_product(t11, t3).add_product(t12,
        t2).add_product(t13, t3).add_product(t19, t18));
    let t22 = (t21 * t17).add_product(t19, link_3);
    let t23 = (-(t20 * t14)).add_product(t16, t22);
    let third_v_y_dot = (-c.t0).add_product(t13, link_3);
    let third_v_x_dot = t12 * link_3;
    let second_v_y_dot = -c.t1.add_product(t10, t22).add_product(t11, link_3);
    let second_v_x_dot = -(t9 * link_3).add_product(t8, t22);
    let first_v_y_dot = (-c.t2.add_product(t6, t23)).add_product(t7, t22);
    let first_v_x_dot = (t5 * t22).sub_product(t4, t23);
    [first_v_x, first_v_y, second_v_x, second_v_y, third_v_x, third_v_y, first_v_x_dot,
        first_v_y_dot, second_v_x_dot, second_v_y_dot, third_v_x_dot, third_v_y_dot]
}

/// `M = d2L/dq'2`, values in the order of its pattern. No operations.
#[must_use]
pub fn mass_matrix<R: Real>(_time: R, _state: &[R; STATES], p: &Parameters<R>) -> [R; 6] {
    [p.first_mass, p.first_mass, p.second_mass, p.second_mass, p.third_mass, p.third_mass]
}

/// `f` of `M q'' = f + G^T lambda`, one for each coordinate. 6 operations.
#[must_use]
pub fn forcing<R: Real>(_time: R, _state: &[R; STATES], p: &Parameters<R>) -> [R; COORDINATES] {
    let first_y_forcing = -(p.first_mass * p.first_gravity);
    let second_y_forcing = -(p.second_mass * p.second_gravity);
    let third_y_forcing = -(p.third_mass * p.third_gravity);
    [R::literal(0.0), first_y_forcing, R::literal(0.0), second_y_forcing, R::literal(0.0),
        third_y_forcing]
}

/// As `rate_jacobian`, with the constants of the parameters from `prepare`. 499 operations.
#[must_use]
pub fn prepared_rate_jacobian<R: Real>(_time: R, state: &[R; STATES], _p: &Parameters<R>,
        c: &Constants<R>) -> [R; 78] {
    let [first_x, first_y, second_x, second_y, third_x, third_y, first_v_x, first_v_y, second_v_x,
        second_v_y, third_v_x, third_v_y] = *state;
    let inverse_l_1_times_first_x = c.inverse_l_1 * first_x;
    let t0 = c.inverse_l_2 * (second_x - first_x);
    let inverse_l_1_times_first_y = c.inverse_l_1 * first_y;
    let t1 = c.inverse_l_2 * (second_y - first_y);
    let t2 = c.inverse_l_3 * (third_x - second_x);
    let t3 = c.inverse_l_3 * (third_y - second_y);
    let t4 = inverse_l_1_times_first_x * c.inverse_first_mass;
    let t5 = t0 * c.inverse_first_mass;
    let t6 = inverse_l_1_times_first_y * c.inverse_first_mass;
    let t7 = t1 * c.inverse_first_mass;
    let t8 = t0 * c.inverse_second_mass;
    let t9 = t2 * c.inverse_second_mass;
    let t10 = t1 * c.inverse_second_mass;
    let t11 = t3 * c.inverse_second_mass;
    let t12 = t2 * c.inverse_third_mass;
    let t13 = t3 * c.inverse_third_mass;
    let t14 = R::literal(1.0) / (t4 * inverse_l_1_times_first_x).add_product(t6,
        inverse_l_1_times_first_y);
    let t15 = (t5 * inverse_l_1_times_first_x).add_product(t7, inverse_l_1_times_first_y);
    let t16 = t15 * t14;
    let t17 = R::literal(1.0) / (-(t5 * t0).add_product(t7, t1).add_product(t8, t0)
        .add_product(t10, t1)).add_product(t16, t15);
    let t18 = (t9 * t0).add_product(t11, t1);
    let t19 = t18 * t17;
    let t20 = R::literal(1.0) / (t9 * t2).add_product(t11, t3).add_product(t12, t2)
        .add_product(t13, t3).add_product(t19, t18);
    let first_v_x_squared = first_v_x * first_v_x;
    let first_v_y_squared = first_v_y * first_v_y;
    let second_v_x_squared = second_v_x * second_v_x;
    let second_v_y_squared = second_v_y * second_v_y;
    let t21 = (t6 * c.first_mass_times_first_gravity).sub_product(c.inverse_l_1, first_v_x_squared
        + first_v_y_squared);
    let t22 = (-(t7 * c.first_mass_times_first_gravity)).add_product(c.inverse_l_2,
        (R::literal(2.0) * first_v_x * second_v_x).add_product(R::literal(2.0) * first_v_y,
        second_v_y) - first_v_x_squared - first_v_y_squared - second_v_x_squared
        - second_v_y_squared).add_product(t10, c.second_mass_times_second_gravity).add_product(t16,
        t21);
    let link_3 = (-(t11 * c.second_mass_times_second_gravity)).add_product(c.inverse_l_3,
        ((R::literal(2.0) * second_v_x * third_v_x).add_product(R::literal(2.0) * second_v_y,
        third_v_y) - second_v_x_squared - second_v_y_squared).sub_product(third_v_x, third_v_x)
        .sub_product(third_v_y, third_v_y)).add_product(t13, c.third_mass_times_third_gravity)
        .sub_product(t19, t22) * t20;
    let t23 = (t22 * t17).add_product(t19, link_3);
    let t24 = (-(t21 * t14)).add_product(t16, t23);
    let third_v_y_dot = (-c.t0).add_product(t13, link_3);
    let third_v_x_dot = t12 * link_3;
    let t25 = c.t1.add_product(t10, t23).add_product(t11, link_3);
    let t26 = (t9 * link_3).add_product(t8, t23);
    let first_v_y_dot = (-c.t2.add_product(t6, t24)).add_product(t7, t23);
    let first_v_x_dot = (t5 * t23).sub_product(t4, t24);
    let t27 = c.inverse_l_2 * t23;
    let t28 = t27.add_product(c.inverse_l_1, t24);
    let t29 = (c.inverse_l_2 * t26).add_product(c.inverse_l_2, first_v_x_dot);
    let t30 = (t4 * t28).sub_product(c.inverse_l_1, first_v_x_dot);
    let t31 = (-t29.add_product(t5, t28).add_product(t8, t27)).add_product(t16, t30);
    let t32 = (t9 * t27).sub_product(t19, t31) * t20;
    let t33 = (t31 * t17).add_product(t19, t32);
    let t34 = (-(t30 * t14)).add_product(t16, t33);
    let third_v_y_dot_by_first_x = t13 * t32;
    let third_v_x_dot_by_first_x = t12 * t32;
    let second_v_y_dot_by_first_x = -(t11 * t32).add_product(t10, t33);
    let t35 = t27 * c.inverse_second_mass;
    let second_v_x_dot_by_first_x = t35.sub_product(t8, t33).sub_product(t9, t32);
    let first_v_y_dot_by_first_x = (t7 * t33).sub_product(t6, t34);
    let t36 = t28 * c.inverse_first_mass;
    let first_v_x_dot_by_first_x = (-t36.add_product(t4, t34)).add_product(t5, t33);
    let t37 = (c.inverse_l_2 * t25).add_product(c.inverse_l_2, first_v_y_dot);
    let t38 = (t6 * t28).sub_product(c.inverse_l_1, first_v_y_dot);
    let t39 = (-t37.add_product(t7, t28).add_product(t10, t27)).add_product(t16, t38);
    let t40 = (t11 * t27).sub_product(t19, t39) * t20;
    let t41 = (t39 * t17).add_product(t19, t40);
    let t42 = (-(t38 * t14)).add_product(t16, t41);
    let third_v_y_dot_by_first_y = t13 * t40;
    let third_v_x_dot_by_first_y = t12 * t40;
    let second_v_y_dot_by_first_y = t35.sub_product(t10, t41).sub_product(t11, t40);
    let second_v_x_dot_by_first_y = -(t9 * t40).add_product(t8, t41);
    let first_v_y_dot_by_first_y = (-t36.add_product(t6, t42)).add_product(t7, t41);
    let first_v_x_dot_by_first_y = (t5 * t41).sub_product(t4, t42);
    let inverse_l_3_times_link_3 = c.inverse_l_3 * link_3;
    let t43 = inverse_l_3_times_link_3 - t27;
    let t44 = (c.inverse_l_3 * third_v_x_dot).add_product(c.inverse_l_3, t26);
    let t45 = t4 * t27;
    let t46 = t29.add_product(t5, t27).sub_product(t8, t43).sub_product(t16, t45);
    let t47 = t12 * inverse_l_3_times_link_3;
    let t48 = (t44.add_product(t9, t43) + t47).sub_product(t19, t46) * t20;
    let t49 = (t46 * t17).add_product(t19, t48);
    let t50 = (t45 * t14).add_product(t16, t49);
    let third_v_y_dot_by_second_x = t13 * t48;
    let t51 = inverse_l_3_times_link_3 * c.inverse_third_mass;
    let third_v_x_dot_by_second_x = (-t51).add_product(t12, t48);
    let second_v_y_dot_by_second_x = -(t11 * t48).add_product(t10, t49);
    let t52 = t43 * c.inverse_second_mass;
    let second_v_x_dot_by_second_x = t52.sub_product(t8, t49).sub_product(t9, t48);
    let first_v_y_dot_by_second_x = (t7 * t49).sub_product(t6, t50);
    let t53 = t27 * c.inverse_first_mass;
    let first_v_x_dot_by_second_x = t53.sub_product(t4, t50).add_product(t5, t49);
    let t54 = (c.inverse_l_3 * third_v_y_dot).add_product(c.inverse_l_3, t25);
    let t55 = t6 * t27;
    let t56 = t37.add_product(t7, t27).sub_product(t10, t43).sub_product(t16, t55);
    let t57 = t13 * inverse_l_3_times_link_3;
    let t58 = (t54.add_product(t11, t43) + t57).sub_product(t19, t56) * t20;
    let t59 = (t56 * t17).add_product(t19, t58);
    let t60 = (t55 * t14).add_product(t16, t59);
    let third_v_y_dot_by_second_y = (-t51).add_product(t13, t58);
    let third_v_x_dot_by_second_y = t12 * t58;
    let second_v_y_dot_by_second_y = t52.sub_product(t10, t59).sub_product(t11, t58);
    let second_v_x_dot_by_second_y = -(t9 * t58).add_product(t8, t59);
    let first_v_y_dot_by_second_y = t53.sub_product(t6, t60).add_product(t7, t59);
    let first_v_x_dot_by_second_y = (t5 * t59).sub_product(t4, t60);
    let t61 = t8 * inverse_l_3_times_link_3;
    let t62 = (t44.add_product(t9, inverse_l_3_times_link_3) + t47).add_product(t19, t61) * t20;
    let t63 = (t61 * t17).sub_product(t19, t62);
    let t64 = t16 * t63;
    let third_v_y_dot_by_third_x = -(t13 * t62);
    let third_v_x_dot_by_third_x = t51.sub_product(t12, t62);
    let second_v_y_dot_by_third_x = (t11 * t62).sub_product(t10, t63);
    let t65 = inverse_l_3_times_link_3 * c.inverse_second_mass;
    let second_v_x_dot_by_third_x = (-t65.add_product(t8, t63)).add_product(t9, t62);
    let first_v_y_dot_by_third_x = (t7 * t63).sub_product(t6, t64);
    let first_v_x_dot_by_third_x = (t5 * t63).sub_product(t4, t64);
    let t66 = t10 * inverse_l_3_times_link_3;
    let t67 = (t54.add_product(t11, inverse_l_3_times_link_3) + t57).add_product(t19, t66) * t20;
    let t68 = (t66 * t17).sub_product(t19, t67);
    let t69 = t16 * t68;
    let third_v_y_dot_by_third_y = t51.sub_product(t13, t67);
    let third_v_x_dot_by_third_y = -(t12 * t67);
    let second_v_y_dot_by_third_y = (-t65.add_product(t10, t68)).add_product(t11, t67);
    let second_v_x_dot_by_third_y = (t9 * t67).sub_product(t8, t68);
    let first_v_y_dot_by_third_y = (t7 * t68).sub_product(t6, t69);
    let first_v_x_dot_by_third_y = (t5 * t68).sub_product(t4, t69);
    let t70 = c.t3 * first_v_x;
    let t71 = c.t4 * first_v_x;
    let t72 = c.t4 * second_v_x;
    let t73 = (t72 - t71).sub_product(t16, t70);
    let t74 = t19 * t73 * t20;
    let t75 = (t73 * t17).sub_product(t19, t74);
    let t76 = (t70 * t14).add_product(t16, t75);
    let third_v_y_dot_by_first_v_x = -(t13 * t74);
    let third_v_x_dot_by_first_v_x = -(t12 * t74);
    let second_v_y_dot_by_first_v_x = (t11 * t74).sub_product(t10, t75);
    let second_v_x_dot_by_first_v_x = (t9 * t74).sub_product(t8, t75);
    let first_v_y_dot_by_first_v_x = (t7 * t75).sub_product(t6, t76);
    let first_v_x_dot_by_first_v_x = (t5 * t75).sub_product(t4, t76);
    let t77 = c.t3 * first_v_y;
    let t78 = c.t4 * first_v_y;
    let t79 = c.t4 * second_v_y;
    let t80 = (t79 - t78).sub_product(t16, t77);
    let t81 = t19 * t80 * t20;
    let t82 = (t80 * t17).sub_product(t19, t81);
    let t83 = (t77 * t14).add_product(t16, t82);
    let third_v_y_dot_by_first_v_y = -(t13 * t81);
    let third_v_x_dot_by_first_v_y = -(t12 * t81);
    let second_v_y_dot_by_first_v_y = (t11 * t81).sub_product(t10, t82);
    let second_v_x_dot_by_first_v_y = (t9 * t81).sub_product(t8, t82);
    let first_v_y_dot_by_first_v_y = (t7 * t82).sub_product(t6, t83);
    let first_v_x_dot_by_first_v_y = (t5 * t82).sub_product(t4, t83);
    let t84 = t71 - t72;
    let t85 = c.t5 * second_v_x;
    let t86 = c.t5 * third_v_x;
    let t87 = (t86 - t85).sub_product(t19, t84) * t20;
    let t88 = (t84 * t17).add_product(t19, t87);
    let t89 = t16 * t88;
    let third_v_y_dot_by_second_v_x = t13 * t87;
    let third_v_x_dot_by_second_v_x = t12 * t87;
    let second_v_y_dot_by_second_v_x = -(t11 * t87).add_product(t10, t88);
    let second_v_x_dot_by_second_v_x = -(t9 * t87).add_product(t8, t88);
    let first_v_y_dot_by_second_v_x = (t7 * t88).sub_product(t6, t89);
    let first_v_x_dot_by_second_v_x = (t5 * t88).sub_product(t4, t89);
    let t90 = t78 - t79;
    let t91 = c.t5 * second_v_y;
    let t92 = c.t5 * third_v_y;
    let t93 = (t92 - t91).sub_product(t19, t90) * t20;
    let t94 = (t90 * t17).add_product(t19, t93);
    let t95 = t16 * t94;
    let third_v_y_dot_by_second_v_y = t13 * t93;
    let third_v_x_dot_by_second_v_y = t12 * t93;
    let second_v_y_dot_by_second_v_y = -(t11 * t93).add_product(t10, t94);
    let second_v_x_dot_by_second_v_y = -(t9 * t93).add_product(t8, t94);
    let first_v_y_dot_by_second_v_y = (t7 * t94).sub_product(t6, t95);
    let first_v_x_dot_by_second_v_y = (t5 * t94).sub_product(t4, t95);
    let t96 = (t85 - t86) * t20;
    let t97 = t19 * t96;
    let t98 = t16 * t97;
    let third_v_y_dot_by_third_v_x = t13 * t96;
    let third_v_x_dot_by_third_v_x = t12 * t96;
    let second_v_y_dot_by_third_v_x = -(t11 * t96).add_product(t10, t97);
    let second_v_x_dot_by_third_v_x = -(t9 * t96).add_product(t8, t97);
    let first_v_y_dot_by_third_v_x = (t7 * t97).sub_product(t6, t98);
    let first_v_x_dot_by_third_v_x = (t5 * t97).sub_product(t4, t98);
    let t99 = (t91 - t92) * t20;
    let t100 = t19 * t99;
    let t101 = t16 * t100;
    let third_v_y_dot_by_third_v_y = t13 * t99;
    let third_v_x_dot_by_third_v_y = t12 * t99;
    let second_v_y_dot_by_third_v_y = -(t11 * t99).add_product(t10, t100);
    let second_v_x_dot_by_third_v_y = -(t9 * t99).add_product(t8, t100);
    let first_v_y_dot_by_third_v_y = (t7 * t100).sub_product(t6, t101);
    let first_v_x_dot_by_third_v_y = (t5 * t100).sub_product(t4, t101);
    [R::literal(1.0), R::literal(1.0), R::literal(1.0), R::literal(1.0), R::literal(1.0),
        R::literal(1.0), first_v_x_dot_by_first_x, first_v_x_dot_by_first_y,
        first_v_x_dot_by_second_x, first_v_x_dot_by_second_y, first_v_x_dot_by_third_x,
        first_v_x_dot_by_third_y, first_v_x_dot_by_first_v_x, first_v_x_dot_by_first_v_y,
        first_v_x_dot_by_second_v_x, first_v_x_dot_by_second_v_y, first_v_x_dot_by_third_v_x,
        first_v_x_dot_by_third_v_y, first_v_y_dot_by_first_x, first_v_y_dot_by_first_y,
        first_v_y_dot_by_second_x, first_v_y_dot_by_second_y, first_v_y_dot_by_third_x,
        first_v_y_dot_by_third_y, first_v_y_dot_by_first_v_x, first_v_y_dot_by_first_v_y,
        first_v_y_dot_by_second_v_x, first_v_y_dot_by_second_v_y, first_v_y_dot_by_third_v_x,
        first_v_y_dot_by_third_v_y, second_v_x_dot_by_first_x, second_v_x_dot_by_first_y,
        second_v_x_dot_by_second_x, second_v_x_dot_by_second_y, second_v_x_dot_by_third_x,
        second_v_x_dot_by_third_y, second_v_x_dot_by_first_v_x, second_v_x_dot_by_first_v_y,
        second_v_x_dot_by_second_v_x, second_v_x_dot_by_second_v_y, second_v_x_dot_by_third_v_x,
        second_v_x_dot_by_third_v_y, second_v_y_dot_by_first_x, second_v_y_dot_by_first_y,
        second_v_y_dot_by_second_x, second_v_y_dot_by_second_y, second_v_y_dot_by_third_x,
        second_v_y_dot_by_third_y, second_v_y_dot_by_first_v_x, second_v_y_dot_by_first_v_y,
        second_v_y_dot_by_second_v_x, second_v_y_dot_by_second_v_y, second_v_y_dot_by_third_v_x,
        second_v_y_dot_by_third_v_y, third_v_x_dot_by_first_x, third_v_x_dot_by_first_y,
        third_v_x_dot_by_second_x, third_v_x_dot_by_second_y, third_v_x_dot_by_third_x,
        third_v_x_dot_by_third_y, third_v_x_dot_by_first_v_x, third_v_x_dot_by_first_v_y,
        third_v_x_dot_by_second_v_x, third_v_x_dot_by_second_v_y, third_v_x_dot_by_third_v_x,
        third_v_x_dot_by_third_v_y, third_v_y_dot_by_first_x, third_v_y_dot_by_first_y,
        third_v_y_dot_by_second_x, third_v_y_dot_by_second_y, third_v_y_dot_by_third_x,
        third_v_y_dot_by_third_y, third_v_y_dot_by_first_v_x, third_v_y_dot_by_first_v_y,
        third_v_y_dot_by_second_v_x, third_v_y_dot_by_second_v_y, third_v_y_dot_by_third_v_x,
        third_v_y_dot_by_third_v_y]
}

/// `rate_jacobian`, then `parameter_jacobian`, with the constants of the parameters from `prepare`.
/// 672 operations.
#[must_use]
pub fn prepared_jacobians<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>,
        c: &Constants<R>) -> [R; 114] {
    let [first_x, first_y, second_x, second_y, third_x, third_y, first_v_x, first_v_y, second_v_x,
        second_v_y, third_v_x, third_v_y] = *state;
    let inverse_l_1_times_first_x = c.inverse_l_1 * first_x;
    let t0 = c.inverse_l_2 * (second_x - first_x);
    let inverse_l_1_times_first_y = c.inverse_l_1 * first_y;
    let t1 = c.inverse_l_2 * (second_y - first_y);
    let t2 = c.inverse_l_3 * (third_x - second_x);
    let t3 = c.inverse_l_3 * (third_y - second_y);
    let t4 = inverse_l_1_times_first_x * c.inverse_first_mass;
    let t5 = t0 * c.inverse_first_mass;
    let t6 = inverse_l_1_times_first_y * c.inverse_first_mass;
    let t7 = t1 * c.inverse_first_mass;
    let t8 = t0 * c.inverse_second_mass;
    let t9 = t2 * c.inverse_second_mass;
    let t10 = t1 * c.inverse_second_mass;
    let t11 = t3 * c.inverse_second_mass;
    let t12 = t2 * c.inverse_third_mass;
    let t13 = t3 * c.inverse_third_mass;
    let t14 = R::literal(1.0) / (t4 * inverse_l_1_times_first_x).add_product(t6,
        inverse_l_1_times_first_y);
    let t15 = (t5 * inverse_l_1_times_first_x).add_product(t7, inverse_l_1_times_first_y);
    let t16 = t15 * t14;
    let t17 = R::literal(1.0) / (-(t5 * t0).add_product(t7, t1).add_product(t8, t0)
        .add_product(t10, t1)).add_product(t16, t15);
    let t18 = (t9 * t0).add_product(t11, t1);
    let t19 = t18 * t17;
    let t20 = R::literal(1.0) / (t9 * t2).add_product(t11, t3).add_product(t12, t2)
        .add_product(t13, t3).add_product(t19, t18);
    let first_v_x_squared = first_v_x * first_v_x;
    let first_v_y_squared = first_v_y * first_v_y;
    let second_v_x_squared = second_v_x * second_v_x;
    let second_v_y_squared = second_v_y * second_v_y;
    let t21 = (t6 * c.first_mass_times_first_gravity).sub_product(c.inverse_l_1, first_v_x_squared
        + first_v_y_squared);
    let t22 = (-(t7 * c.first_mass_times_first_gravity)).add_product(c.inverse_l_2,
        (R::literal(2.0) * first_v_x * second_v_x).add_product(R::literal(2.0) * first_v_y,
        second_v_y) - first_v_x_squared - first_v_y_squared - second_v_x_squared
        - second_v_y_squared).add_product(t10, c.second_mass_times_second_gravity).add_product(t16,
        t21);
    let link_3 = (-(t11 * c.second_mass_times_second_gravity)).add_product(c.inverse_l_3,
        ((R::literal(2.0) * second_v_x * third_v_x).add_product(R::literal(2.0) * second_v_y,
        third_v_y) - second_v_x_squared - second_v_y_squared).sub_product(third_v_x, third_v_x)
        .sub_product(third_v_y, third_v_y)).add_product(t13, c.third_mass_times_third_gravity)
        .sub_product(t19, t22) * t20;
    let t23 = (t22 * t17).add_product(t19, link_3);
    let t24 = (-(t21 * t14)).add_product(t16, t23);
    let third_v_y_dot = (-c.t0).add_product(t13, link_3);
    let third_v_x_dot = t12 * link_3;
    let t25 = c.t1.add_product(t10, t23).add_product(t11, link_3);
    let t26 = (t9 * link_3).add_product(t8, t23);
    let first_v_y_dot = (-c.t2.add_product(t6, t24)).add_product(t7, t23);
    let t27 = t4 * t24;
    let t28 = t5 * t23;
    let first_v_x_dot = t28 - t27;
    let t29 = c.inverse_l_2 * t23;
    let t30 = t29.add_product(c.inverse_l_1, t24);
    let t31 = (c.inverse_l_2 * t26).add_product(c.inverse_l_2, first_v_x_dot);
    let t32 = (t4 * t30).sub_product(c.inverse_l_1, first_v_x_dot);
    let t33 = (-t31.add_product(t5, t30).add_product(t8, t29)).add_product(t16, t32);
    let t34 = (t9 * t29).sub_product(t19, t33) * t20;
    let t35 = (t33 * t17).add_product(t19, t34);
    let t36 = (-(t32 * t14)).add_product(t16, t35);
    let third_v_y_dot_by_first_x = t13 * t34;
    let third_v_x_dot_by_first_x = t12 * t34;
    let second_v_y_dot_by_first_x = -(t11 * t34).add_product(t10, t35);
    let t37 = t29 * c.inverse_second_mass;
    let second_v_x_dot_by_first_x = t37.sub_product(t8, t35).sub_product(t9, t34);
    let first_v_y_dot_by_first_x = (t7 * t35).sub_product(t6, t36);
    let t38 = t30 * c.inverse_first_mass;
    let first_v_x_dot_by_first_x = (-t38.add_product(t4, t36)).add_product(t5, t35);
    let t39 = (c.inverse_l_2 * t25).add_product(c.inverse_l_2, first_v_y_dot);
    let t40 = (t6 * t30).sub_product(c.inverse_l_1, first_v_y_dot);
    let t41 = (-t39.add_product(t7, t30).add_product(t10, t29)).add_product(t16, t40);
    let t42 = (t11 * t29).sub_product(t19, t41) * t20;
    let t43 = (t41 * t17).add_product(t19, t42);
    let t44 = (-(t40 * t14)).add_product(t16, t43);
    let third_v_y_dot_by_first_y = t13 * t42;
    let third_v_x_dot_by_first_y = t12 * t42;
    let second_v_y_dot_by_first_y = t37.sub_product(t10, t43).sub_product(t11, t42);
    let second_v_x_dot_by_first_y = -(t9 * t42).add_product(t8, t43);
    let first_v_y_dot_by_first_y = (-t38.add_product(t6, t44)).add_product(t7, t43);
    let first_v_x_dot_by_first_y = (t5 * t43).sub_product(t4, t44);
    let inverse_l_3_times_link_3 = c.inverse_l_3 * link_3;
    let t45 = inverse_l_3_times_link_3 - t29;
    let t46 = (c.inverse_l_3 * third_v_x_dot).add_product(c.inverse_l_3, t26);
    let t47 = t4 * t29;
    let t48 = t31.add_product(t5, t29).sub_product(t8, t45).sub_product(t16, t47);
    let t49 = t12 * inverse_l_3_times_link_3;
    let t50 = (t46.add_product(t9, t45) + t49).sub_product(t19, t48) * t20;
    let t51 = (t48 * t17).add_product(t19, t50);
    let t52 = (t47 * t14).add_product(t16, t51);
    let third_v_y_dot_by_second_x = t13 * t50;
    let t53 = inverse_l_3_times_link_3 * c.inverse_third_mass;
    let third_v_x_dot_by_second_x = (-t53).add_product(t12, t50);
    let second_v_y_dot_by_second_x = -(t11 * t50).add_product(t10, t51);
    let t54 = t45 * c.inverse_second_mass;
    let second_v_x_dot_by_second_x = t54.sub_product(t8, t51).sub_product(t9, t50);
    let first_v_y_dot_by_second_x = (t7 * t51).sub_product(t6, t52);
    let t55 = t29 * c.inverse_first_mass;
    let first_v_x_dot_by_second_x = t55.sub_product(t4, t52).add_product(t5, t51);
    let t56 = (c.inverse_l_3 * third_v_y_dot).add_product(c.inverse_l_3, t25);
    let t57 = t6 * t29;
    let t58 = t39.add_product(t7, t29).sub_product(t10, t45).sub_product(t16, t57);
    let t59 = t13 * inverse_l_3_times_link_3;
    let t60 = (t56.add_product(t11, t45) + t59).sub_product(t19, t58) * t20;
    let t61 = (t58 * t17).add_product(t19, t60);
    let t62 = (t57 * t14).add_product(t16, t61);
    let third_v_y_dot_by_second_y = (-t53).add_product(t13, t60);
    let third_v_x_dot_by_second_y = t12 * t60;
    let second_v_y_dot_by_second_y = t54.sub_product(t10, t61).sub_product(t11, t60);
    let second_v_x_dot_by_second_y = -(t9 * t60).add_product(t8, t61);
    let first_v_y_dot_by_second_y = t55.sub_product(t6, t62).add_product(t7, t61);
    let first_v_x_dot_by_second_y = (t5 * t61).sub_product(t4, t62);
    let t63 = t8 * inverse_l_3_times_link_3;
    let t64 = (t46.add_product(t9, inverse_l_3_times_link_3) + t49).add_product(t19, t63) * t20;
    let t65 = (t63 * t17).sub_product(t19, t64);
    let t66 = t16 * t65;
    let third_v_y_dot_by_third_x = -(t13 * t64);
    let third_v_x_dot_by_third_x = t53.sub_product(t12, t64);
    let second_v_y_dot_by_third_x = (t11 * t64).sub_product(t10, t65);
    let t67 = inverse_l_3_times_link_3 * c.inverse_second_mass;
    let second_v_x_dot_by_third_x = (-t67.add_product(t8, t65)).add_product(t9, t64);
    let first_v_y_dot_by_third_x = (t7 * t65).sub_product(t6, t66);
    let first_v_x_dot_by_third_x = (t5 * t65).sub_product(t4, t66);
    let t68 = t10 * inverse_l_3_times_link_3;
    let t69 = (t56.add_product(t11, inverse_l_3_times_link_3) + t59).add_product(t19, t68) * t20;
    let t70 = (t68 * t17).sub_product(t19, t69);
    let t71 = t16 * t70;
    let third_v_y_dot_by_third_y = t53.sub_product(t13, t69);
    let third_v_x_dot_by_third_y = -(t12 * t69);
    let second_v_y_dot_by_third_y = (-t67.add_product(t10, t70)).add_product(t11, t69);
    let second_v_x_dot_by_third_y = (t9 * t69).sub_product(t8, t70);
    let first_v_y_dot_by_third_y = (t7 * t70).sub_product(t6, t71);
    let first_v_x_dot_by_third_y = (t5 * t70).sub_product(t4, t71);
    let t72 = c.t3 * first_v_x;
    let t73 = c.t4 * first_v_x;
    let t74 = c.t4 * second_v_x;
    let t75 = (t74 - t73).sub_product(t16, t72);
    let t76 = t19 * t75 * t20;
    let t77 = (t75 * t17).sub_product(t19, t76);
    let t78 = (t72 * t14).add_product(t16, t77);
    let third_v_y_dot_by_first_v_x = -(t13 * t76);
    let third_v_x_dot_by_first_v_x = -(t12 * t76);
    let second_v_y_dot_by_first_v_x = (t11 * t76).sub_product(t10, t77);
    let second_v_x_dot_by_first_v_x = (t9 * t76).sub_product(t8, t77);
    let first_v_y_dot_by_first_v_x = (t7 * t77).sub_product(t6, t78);
    let first_v_x_dot_by_first_v_x = (t5 * t77).sub_product(t4, t78);
    let t79 = c.t3 * first_v_y;
    let t80 = c.t4 * first_v_y;
    let t81 = c.t4 * second_v_y;
    let t82 = (t81 - t80).sub_product(t16, t79);
    let t83 = t19 * t82 * t20;
    let t84 = (t82 * t17).sub_product(t19, t83);
    let t85 = (t79 * t14).add_product(t16, t84);
    let third_v_y_dot_by_first_v_y = -(t13 * t83);
    let third_v_x_dot_by_first_v_y = -(t12 * t83);
    let second_v_y_dot_by_first_v_y = (t11 * t83).sub_product(t10, t84);
    let second_v_x_dot_by_first_v_y = (t9 * t83).sub_product(t8, t84);
    let first_v_y_dot_by_first_v_y = (t7 * t84).sub_product(t6, t85);
    let first_v_x_dot_by_first_v_y = (t5 * t84).sub_product(t4, t85);
    let t86 = t73 - t74;
    let t87 = c.t5 * second_v_x;
    let t88 = c.t5 * third_v_x;
    let t89 = (t88 - t87).sub_product(t19, t86) * t20;
    let t90 = (t86 * t17).add_product(t19, t89);
    let t91 = t16 * t90;
    let third_v_y_dot_by_second_v_x = t13 * t89;
    let third_v_x_dot_by_second_v_x = t12 * t89;
    let second_v_y_dot_by_second_v_x = -(t11 * t89).add_product(t10, t90);
    let second_v_x_dot_by_second_v_x = -(t9 * t89).add_product(t8, t90);
    let first_v_y_dot_by_second_v_x = (t7 * t90).sub_product(t6, t91);
    let first_v_x_dot_by_second_v_x = (t5 * t90).sub_product(t4, t91);
    let t92 = t80 - t81;
    let t93 = c.t5 * second_v_y;
    let t94 = c.t5 * third_v_y;
    let t95 = (t94 - t93).sub_product(t19, t92) * t20;
    let t96 = (t92 * t17).add_product(t19, t95);
    let t97 = t16 * t96;
    let third_v_y_dot_by_second_v_y = t13 * t95;
    let third_v_x_dot_by_second_v_y = t12 * t95;
    let second_v_y_dot_by_second_v_y = -(t11 * t95).add_product(t10, t96);
    let second_v_x_dot_by_second_v_y = -(t9 * t95).add_product(t8, t96);
    let first_v_y_dot_by_second_v_y = (t7 * t96).sub_product(t6, t97);
    let first_v_x_dot_by_second_v_y = (t5 * t96).sub_product(t4, t97);
    let t98 = (t87 - t88) * t20;
    let t99 = t19 * t98;
    let t100 = t16 * t99;
    let third_v_y_dot_by_third_v_x = t13 * t98;
    let third_v_x_dot_by_third_v_x = t12 * t98;
    let second_v_y_dot_by_third_v_x = -(t11 * t98).add_product(t10, t99);
    let second_v_x_dot_by_third_v_x = -(t9 * t98).add_product(t8, t99);
    let first_v_y_dot_by_third_v_x = (t7 * t99).sub_product(t6, t100);
    let first_v_x_dot_by_third_v_x = (t5 * t99).sub_product(t4, t100);
    let t101 = (t93 - t94) * t20;
    let t102 = t19 * t101;
    let t103 = t16 * t102;
    let third_v_y_dot_by_third_v_y = t13 * t101;
    let third_v_x_dot_by_third_v_y = t12 * t101;
    let second_v_y_dot_by_third_v_y = -(t11 * t101).add_product(t10, t102);
    let second_v_x_dot_by_third_v_y = -(t9 * t101).add_product(t8, t102);
    let first_v_y_dot_by_third_v_y = (t7 * t102).sub_product(t6, t103);
    let first_v_x_dot_by_third_v_y = (t5 * t102).sub_product(t4, t103);
    let t104 = t27 - t28;
    let first_gravity_plus_first_v_y_dot = p.first_gravity + first_v_y_dot;
    let t105 = (-(t4 * t104)).add_product(t6, first_gravity_plus_first_v_y_dot);
    let t106 = (t5 * t104).sub_product(t7, first_gravity_plus_first_v_y_dot).add_product(t16, t105);
    let t107 = t19 * t106 * t20;
    let t108 = (t106 * t17).sub_product(t19, t107);
    let t109 = (-(t105 * t14)).add_product(t16, t108);
    let third_v_y_dot_by_first_mass = -(t13 * t107);
    let third_v_x_dot_by_first_mass = -(t12 * t107);
    let second_v_y_dot_by_first_mass = (t11 * t107).sub_product(t10, t108);
    let second_v_x_dot_by_first_mass = (t9 * t107).sub_product(t8, t108);
    let first_v_y_dot_by_first_mass = (-(first_gravity_plus_first_v_y_dot * c.inverse_first_mass)
        .add_product(t6, t109)).add_product(t7, t108);
    let first_v_x_dot_by_first_mass = (t104 * c.inverse_first_mass).sub_product(t4, t109)
        .add_product(t5, t108);
    let t110 = t6 * p.first_mass;
    let t111 = (-(t7 * p.first_mass)).add_product(t16, t110);
    let t112 = t19 * t111 * t20;
    let t113 = (t111 * t17).sub_product(t19, t112);
    let t114 = (-(t110 * t14)).add_product(t16, t113);
    let third_v_y_dot_by_first_gravity = -(t13 * t112);
    let third_v_x_dot_by_first_gravity = -(t12 * t112);
    let second_v_y_dot_by_first_gravity = (t11 * t112).sub_product(t10, t113);
    let second_v_x_dot_by_first_gravity = (t9 * t112).sub_product(t8, t113);
    let first_v_y_dot_by_first_gravity = (-c.first_mass_times_inverse_first_mass.add_product(t6,
        t114)).add_product(t7, t113);
    let first_v_x_dot_by_first_gravity = (t5 * t113).sub_product(t4, t114);
    let t115 = t25 - p.second_gravity;
    let t116 = (t8 * t26).add_product(t10, t115);
    let t117 = (t9 * t26).add_product(t11, t115).add_product(t19, t116) * t20;
    let t118 = (-(t116 * t17)).add_product(t19, t117);
    let t119 = t16 * t118;
    let third_v_y_dot_by_second_mass = t13 * t117;
    let third_v_x_dot_by_second_mass = t12 * t117;
    let second_v_y_dot_by_second_mass = (t115 * c.inverse_second_mass).sub_product(t10, t118)
        .sub_product(t11, t117);
    let second_v_x_dot_by_second_mass = (t26 * c.inverse_second_mass).sub_product(t8, t118)
        .sub_product(t9, t117);
    let first_v_y_dot_by_second_mass = (t7 * t118).sub_product(t6, t119);
    let first_v_x_dot_by_second_mass = (t5 * t118).sub_product(t4, t119);
    let t120 = t10 * p.second_mass;
    let t121 = (t11 * p.second_mass).add_product(t19, t120) * t20;
    let t122 = (t120 * t17).sub_product(t19, t121);
    let t123 = t16 * t122;
    let third_v_y_dot_by_second_gravity = -(t13 * t121);
    let third_v_x_dot_by_second_gravity = -(t12 * t121);
    let second_v_y_dot_by_second_gravity = (-c.t6.add_product(t10, t122)).add_product(t11, t121);
    let second_v_x_dot_by_second_gravity = (t9 * t121).sub_product(t8, t122);
    let first_v_y_dot_by_second_gravity = (t7 * t122).sub_product(t6, t123);
    let first_v_x_dot_by_second_gravity = (t5 * t122).sub_product(t4, t123);
    let third_gravity_plus_third_v_y_dot = p.third_gravity + third_v_y_dot;
    let t124 = (t12 * third_v_x_dot).add_product(t13, third_gravity_plus_third_v_y_dot) * t20;
    let t125 = t19 * t124;
    let t126 = t16 * t125;
    let third_v_y_dot_by_third_mass = (-(third_gravity_plus_third_v_y_dot * c.inverse_third_mass))
        .add_product(t13, t124);
    let third_v_x_dot_by_third_mass = (-(third_v_x_dot * c.inverse_third_mass)).add_product(t12,
        t124);
    let second_v_y_dot_by_third_mass = -(t11 * t124).add_product(t10, t125);
    let second_v_x_dot_by_third_mass = -(t9 * t124).add_product(t8, t125);
    let first_v_y_dot_by_third_mass = (t7 * t125).sub_product(t6, t126);
    let first_v_x_dot_by_third_mass = (t5 * t125).sub_product(t4, t126);
    let t127 = t13 * p.third_mass * t20;
    let t128 = t19 * t127;
    let t129 = t16 * t128;
    let third_v_y_dot_by_third_gravity = (-c.third_mass_times_inverse_third_mass).add_product(t13,
        t127);
    let third_v_x_dot_by_third_gravity = t12 * t127;
    let second_v_y_dot_by_third_gravity = -(t11 * t127).add_product(t10, t128);
    let second_v_x_dot_by_third_gravity = -(t9 * t127).add_product(t8, t128);
    let first_v_y_dot_by_third_gravity = (t7 * t128).sub_product(t6, t129);
    let first_v_x_dot_by_third_gravity = (t5 * t128).sub_product(t4, t129);
    [R::literal(1.0), R::literal(1.0), R::literal(1.0), R::literal(1.0), R::literal(1.0),
        R::literal(1.0), first_v_x_dot_by_first_x, first_v_x_dot_by_first_y,
        first_v_x_dot_by_second_x, first_v_x_dot_by_second_y, first_v_x_dot_by_third_x,
        first_v_x_dot_by_third_y, first_v_x_dot_by_first_v_x, first_v_x_dot_by_first_v_y,
        first_v_x_dot_by_second_v_x, first_v_x_dot_by_second_v_y, first_v_x_dot_by_third_v_x,
        first_v_x_dot_by_third_v_y, first_v_y_dot_by_first_x, first_v_y_dot_by_first_y,
        first_v_y_dot_by_second_x, first_v_y_dot_by_second_y, first_v_y_dot_by_third_x,
        first_v_y_dot_by_third_y, first_v_y_dot_by_first_v_x, first_v_y_dot_by_first_v_y,
        first_v_y_dot_by_second_v_x, first_v_y_dot_by_second_v_y, first_v_y_dot_by_third_v_x,
        first_v_y_dot_by_third_v_y, second_v_x_dot_by_first_x, second_v_x_dot_by_first_y,
        second_v_x_dot_by_second_x, second_v_x_dot_by_second_y, second_v_x_dot_by_third_x,
        second_v_x_dot_by_third_y, second_v_x_dot_by_first_v_x, second_v_x_dot_by_first_v_y,
        second_v_x_dot_by_second_v_x, second_v_x_dot_by_second_v_y, second_v_x_dot_by_third_v_x,
        second_v_x_dot_by_third_v_y, second_v_y_dot_by_first_x, second_v_y_dot_by_first_y,
        second_v_y_dot_by_second_x, second_v_y_dot_by_second_y, second_v_y_dot_by_third_x,
        second_v_y_dot_by_third_y, second_v_y_dot_by_first_v_x, second_v_y_dot_by_first_v_y,
        second_v_y_dot_by_second_v_x, second_v_y_dot_by_second_v_y, second_v_y_dot_by_third_v_x,
        second_v_y_dot_by_third_v_y, third_v_x_dot_by_first_x, third_v_x_dot_by_first_y,
        third_v_x_dot_by_second_x, third_v_x_dot_by_second_y, third_v_x_dot_by_third_x,
        third_v_x_dot_by_third_y, third_v_x_dot_by_first_v_x, third_v_x_dot_by_first_v_y,
        third_v_x_dot_by_second_v_x, third_v_x_dot_by_second_v_y, third_v_x_dot_by_third_v_x,
        third_v_x_dot_by_third_v_y, third_v_y_dot_by_first_x, third_v_y_dot_by_first_y,
        third_v_y_dot_by_second_x, third_v_y_dot_by_second_y, third_v_y_dot_by_third_x,
        third_v_y_dot_by_third_y, third_v_y_dot_by_first_v_x, third_v_y_dot_by_first_v_y,
        third_v_y_dot_by_second_v_x, third_v_y_dot_by_second_v_y, third_v_y_dot_by_third_v_x,
        third_v_y_dot_by_third_v_y, first_v_x_dot_by_first_mass, first_v_x_dot_by_first_gravity,
        first_v_x_dot_by_second_mass, first_v_x_dot_by_second_gravity, first_v_x_dot_by_third_mass,
        first_v_x_dot_by_third_gravity, first_v_y_dot_by_first_mass,
        first_v_y_dot_by_first_gravity, first_v_y_dot_by_second_mass,
        first_v_y_dot_by_second_gravity, first_v_y_dot_by_third_mass,
        first_v_y_dot_by_third_gravity, second_v_x_dot_by_first_mass,
        second_v_x_dot_by_first_gravity, second_v_x_dot_by_second_mass,
        second_v_x_dot_by_second_gravity, second_v_x_dot_by_third_mass,
        second_v_x_dot_by_third_gravity, second_v_y_dot_by_first_mass,
        second_v_y_dot_by_first_gravity, second_v_y_dot_by_second_mass,
        second_v_y_dot_by_second_gravity, second_v_y_dot_by_third_mass,
        second_v_y_dot_by_third_gravity, third_v_x_dot_by_first_mass,
        third_v_x_dot_by_first_gravity, third_v_x_dot_by_second_mass,
        third_v_x_dot_by_second_gravity, third_v_x_dot_by_third_mass,
        third_v_x_dot_by_third_gravity, third_v_y_dot_by_first_mass,
        third_v_y_dot_by_first_gravity, third_v_y_dot_by_second_mass,
        third_v_y_dot_by_second_gravity, third_v_y_dot_by_third_mass,
        third_v_y_dot_by_third_gravity]
}

/// Partial derivative of `y'` with respect to time. No operations.
#[must_use]
pub fn time_derivative<R: Real>(_time: R, _state: &[R; STATES], _p: &Parameters<R>) -> [R; STATES] {
    [R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0),
        R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0),
        R::literal(0.0), R::literal(0.0)]
}

/// Wanted outputs. 111 operations.
#[must_use]
pub fn outputs<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>) -> Outputs<R> {
    let [first_x, first_y, second_x, second_y, third_x, third_y, first_v_x, first_v_y, second_v_x,
        second_v_y, third_v_x, third_v_y] = *state;
    let inverse_l_1 = R::literal(1.0) / p.l_1;
    let inverse_l_1_times_first_x = inverse_l_1 * first_x;
    let inverse_l_2 = R::literal(1.0) / p.l_2;
    let t0 = inverse_l_2 * (second_x - first_x);
    let inverse_l_1_times_first_y = inverse_l_1 * first_y;
    let t1 = inverse_l_2 * (second_y - first_y);
    let inverse_l_3 = R::literal(1.0) / p.l_3;
    let t2 = inverse_l_3 * (third_x - second_x);
    let t3 = inverse_l_3 * (third_y - second_y);
    let inverse_first_mass = R::literal(1.0) / p.first_mass;
    let t4 = t0 * inverse_first_mass;
    let t5 = inverse_l_1_times_first_y * inverse_first_mass;
    let t6 = t1 * inverse_first_mass;
    let inverse_second_mass = R::literal(1.0) / p.second_mass;
    let t7 = t2 * inverse_second_mass;
    let t8 = t1 * inverse_second_mass;
    let t9 = t3 * inverse_second_mass;
    let inverse_third_mass = R::literal(1.0) / p.third_mass;
    let t10 = t3 * inverse_third_mass;
    let t11 = R::literal(1.0) / (inverse_l_1_times_first_x * inverse_first_mass
        * inverse_l_1_times_first_x).add_product(t5, inverse_l_1_times_first_y);
    let t12 = (t4 * inverse_l_1_times_first_x).add_product(t6, inverse_l_1_times_first_y);
    let t13 = t12 * t11;
    let t14 = R::literal(1.0) / (-(t4 * t0).add_product(t6, t1).add_product(t0
        * inverse_second_mass, t0).add_product(t8, t1)).add_product(t13, t12);
    let t15 = (t7 * t0).add_product(t9, t1);
    let t16 = t15 * t14;
    let first_mass_times_first_gravity = p.first_mass * p.first_gravity;
    let second_mass_times_second_gravity = p.second_mass * p.second_gravity;
    let first_v_x_squared = first_v_x * first_v_x;
    let first_v_y_squared = first_v_y * first_v_y;
    let second_v_x_squared = second_v_x * second_v_x;
    let second_v_y_squared = second_v_y * second_v_y;
    let t17 = (-(inverse_l_1 * (first_v_x_squared + first_v_y_squared))).add_product(t5,
        first_mass_times_first_gravity);
    let t18 = (-(t6 * first_mass_times_first_gravity)).add_product(inverse_l_2, (R::literal(2.0)
        * first_v_x * second_v_x).add_product(R::literal(2.0) * first_v_y, second_v_y)
        - first_v_x_squared - first_v_y_squared - second_v_x_squared - second_v_y_squared)
        .add_product(t8, second_mass_times_second_gravity).add_product(t13, t17);
    let link_3 = (-(t9 * second_mass_times_second_gravity)).add_product(inverse_l_3,
        ((R::literal(2.0) * second_v_x * third_v_x).add_product(R::literal(2.0) * second_v_y,
        third_v_y) - second_v_x_squared - second_v_y_squared).sub_product(third_v_x, third_v_x)
        .sub_product(third_v_y, third_v_y)).add_product(t10, p.third_mass * p.third_gravity)
        .sub_product(t16, t18) * (R::literal(1.0) / (t7 * t2).add_product(t9, t3).add_product(t2
        * inverse_third_mass, t2).add_product(t10, t3).add_product(t16, t15));
    let t19 = (t18 * t14).add_product(t16, link_3);
    let link_1 = (t17 * t11).sub_product(t13, t19);
    let link_2 = -t19;
    Outputs {
        end_x: third_x,
        end_y: third_y,
        force_1: link_1,
        force_2: link_2,
        force_3: link_3,
    }
}

/// T, V and the energy of first-order states \[J\]. 25 operations.
#[must_use]
pub fn energy<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>) -> Energy<R> {
    let [_, first_y, _, second_y, _, third_y, first_v_x, first_v_y, second_v_x, second_v_y,
        third_v_x, third_v_y] = *state;
    Energy {
        kinetic: (R::literal(0.5) * p.first_mass * (first_v_x * first_v_x).add_product(first_v_y,
            first_v_y)).add_product(R::literal(0.5) * p.second_mass, (second_v_x * second_v_x)
            .add_product(second_v_y, second_v_y)).add_product(R::literal(0.5) * p.third_mass,
            (third_v_x * third_v_x).add_product(third_v_y, third_v_y)),
        potential: (p.first_mass * p.first_gravity * first_y).add_product(p.second_mass
            * p.second_gravity, second_y).add_product(p.third_mass * p.third_gravity, third_y),
        stored: R::literal(0.0),
    }
}

/// `dE/dt`, power supplied and power dissipated \[W\]. 153 operations.
#[must_use]
pub fn power_balance<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>) -> PowerBalance<R> {
    let [first_x, first_y, second_x, second_y, third_x, third_y, first_v_x, first_v_y, second_v_x,
        second_v_y, third_v_x, third_v_y] = *state;
    let inverse_l_1 = R::literal(1.0) / p.l_1;
    let inverse_l_1_times_first_x = inverse_l_1 * first_x;
    let inverse_l_2 = R::literal(1.0) / p.l_2;
    let t0 = inverse_l_2 * (second_x - first_x);
    let inverse_l_1_times_first_y = inverse_l_1 * first_y;
    let t1 = inverse_l_2 * (second_y - first_y);
    let inverse_l_3 = R::literal(1.0) / p.l_3;
    let t2 = inverse_l_3 * (third_x - second_x);
    let t3 = inverse_l_3 * (third_y - second_y);
    let inverse_first_mass = R::literal(1.0) / p.first_mass;
    let t4 = inverse_l_1_times_first_x * inverse_first_mass;
    let t5 = t0 * inverse_first_mass;
    let t6 = inverse_l_1_times_first_y * inverse_first_mass;
    let t7 = t1 * inverse_first_mass;
    let inverse_second_mass = R::literal(1.0) / p.second_mass;
    let t8 = t0 * inverse_second_mass;
    let t9 = t2 * inverse_second_mass;
    let t10 = t1 * inverse_second_mass;
    let t11 = t3 * inverse_second_mass;
    let inverse_third_mass = R::literal(1.0) / p.third_mass;
    let t12 = t2 * inverse_third_mass;
    let t13 = t3 * inverse_third_mass;
    let t14 = R::literal(1.0) / (t4 * inverse_l_1_times_first_x).add_product(t6,
        inverse_l_1_times_first_y);
    let t15 = (t5 * inverse_l_1_times_first_x).add_product(t7, inverse_l_1_times_first_y);
    let t16 = t15 * t14;
    let t17 = R::literal(1.0) / (-(t5 * t0).add_product(t7, t1).add_product(t8, t0)
        .add_product(t10, t1)).add_product(t16, t15);
    let t18 = (t9 * t0).add_product(t11, t1);
    let t19 = t18 * t17;
    let first_mass_times_first_gravity = p.first_mass * p.first_gravity;
    let second_mass_times_second_gravity = p.second_mass * p.second_gravity;
    let third_mass_times_third_gravity = p.third_mass * p.third_gravity;
    let first_v_x_squared = first_v_x * first_v_x;
    let first_v_y_squared = first_v_y * first_v_y;
    let second_v_x_squared = second_v_x * second_v_x;
    let second_v_y_squared = second_v_y * second_v_y;
    let t20 = (-(inverse_l_1 * (first_v_x_squared + first_v_y_squared))).add_product(t6,
        first_mass_times_first_gravity);
    let t21 = (-(t7 * first_mass_times_first_gravity)).add_product(inverse_l_2, (R::literal(2.0)
        * first_v_x * second_v_x).add_product(R::literal(2.0) * first_v_y, second_v_y)
        - first_v_x_squared - first_v_y_squared - second_v_x_squared - second_v_y_squared)
        .add_product(t10, second_mass_times_second_gravity).add_product(t16, t20);
    let link_3 = (-(t11 * second_mass_times_second_gravity)).add_product(inverse_l_3,
        ((R::literal(2.0) * second_v_x * third_v_x).add_product(R::literal(2.0) * second_v_y,
        third_v_y) - second_v_x_squared - second_v_y_squared).sub_product(third_v_x, third_v_x)
        .sub_product(third_v_y, third_v_y)).add_product(t13, third_mass_times_third_gravity)
        .sub_product(t19, t21) * (R::literal(1.0) / (t9 * t2).add_product(t11, t3).add_product(t12,
        t2).add_product(t13, t3).add_product(t19, t18));
    let t22 = (t21 * t17).add_product(t19, link_3);
    let t23 = (-(t20 * t14)).add_product(t16, t22);
    let third_v_y_dot = (-(third_mass_times_third_gravity * inverse_third_mass)).add_product(t13,
        link_3);
    let third_v_x_dot = t12 * link_3;
    let first_v_y_dot = (-(first_mass_times_first_gravity * inverse_first_mass).add_product(t6,
        t23)).add_product(t7, t22);
    let first_v_x_dot = (t5 * t22).sub_product(t4, t23);
    PowerBalance {
        stored_rate: (first_mass_times_first_gravity * first_v_y)
            .add_product(second_mass_times_second_gravity, second_v_y)
            .add_product(third_mass_times_third_gravity, third_v_y).add_product(p.first_mass
            * first_v_x, first_v_x_dot).add_product(p.first_mass * first_v_y, first_v_y_dot)
            .sub_product(p.second_mass * second_v_x, (t9 * link_3).add_product(t8, t22))
            .sub_product(p.second_mass * second_v_y, (second_mass_times_second_gravity
            * inverse_second_mass).add_product(t10, t22).add_product(t11, link_3))
            .add_product(p.third_mass * third_v_x, third_v_x_dot).add_product(p.third_mass
            * third_v_y, third_v_y_dot),
        supplied: R::literal(0.0),
        dissipated: R::literal(0.0),
    }
}

/// `g` of each constraint, zero for those of velocities alone. 25 operations.
#[must_use]
pub fn constraint_values<R: Real>(_time: R, state: &[R; STATES],
        p: &Parameters<R>) -> [R; CONSTRAINTS] {
    let [first_x, first_y, second_x, second_y, third_x, third_y, ..] = *state;
    let second_x_minus_first_x = second_x - first_x;
    let second_y_minus_first_y = second_y - first_y;
    let third_x_minus_second_x = third_x - second_x;
    let third_y_minus_second_y = third_y - second_y;
    let link_1_value = R::literal(0.5) / p.l_1 * (first_x * first_x).sub_product(p.l_1, p.l_1)
        .add_product(first_y, first_y);
    let link_2_value = R::literal(0.5) / p.l_2 * (-(p.l_2 * p.l_2))
        .add_product(second_x_minus_first_x, second_x_minus_first_x)
        .add_product(second_y_minus_first_y, second_y_minus_first_y);
    let link_3_value = R::literal(0.5) / p.l_3 * (-(p.l_3 * p.l_3))
        .add_product(third_x_minus_second_x, third_x_minus_second_x)
        .add_product(third_y_minus_second_y, third_y_minus_second_y);
    [link_1_value, link_2_value, link_3_value]
}

/// `g'` of each constraint. 33 operations.
#[must_use]
pub fn constraint_rates<R: Real>(_time: R, state: &[R; STATES],
        p: &Parameters<R>) -> [R; CONSTRAINTS] {
    let [first_x, first_y, second_x, second_y, third_x, third_y, first_v_x, first_v_y, second_v_x,
        second_v_y, third_v_x, third_v_y] = *state;
    let second_x_minus_first_x = second_x - first_x;
    let inverse_l_2 = R::literal(1.0) / p.l_2;
    let second_y_minus_first_y = second_y - first_y;
    let third_x_minus_second_x = third_x - second_x;
    let inverse_l_3 = R::literal(1.0) / p.l_3;
    let third_y_minus_second_y = third_y - second_y;
    let link_1_rate = R::literal(1.0) / p.l_1 * (first_x * first_v_x).add_product(first_y,
        first_v_y);
    let link_2_rate = (inverse_l_2 * second_v_x * second_x_minus_first_x).add_product(inverse_l_2
        * second_v_y, second_y_minus_first_y).sub_product(inverse_l_2 * first_v_x,
        second_x_minus_first_x).sub_product(inverse_l_2 * first_v_y, second_y_minus_first_y);
    let link_3_rate = (inverse_l_3 * third_v_x * third_x_minus_second_x).add_product(inverse_l_3
        * third_v_y, third_y_minus_second_y).sub_product(inverse_l_3 * second_v_x,
        third_x_minus_second_x).sub_product(inverse_l_3 * second_v_y, third_y_minus_second_y);
    [link_1_rate, link_2_rate, link_3_rate]
}

/// `G = dg'/dq'`, values in the order of its pattern. 17 operations.
#[must_use]
pub fn constraint_matrix<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>) -> [R; 10] {
    let [first_x, first_y, second_x, second_y, third_x, third_y, ..] = *state;
    let inverse_l_1 = R::literal(1.0) / p.l_1;
    let inverse_l_2 = R::literal(1.0) / p.l_2;
    let t0 = inverse_l_2 * (second_x - first_x);
    let t1 = inverse_l_2 * (second_y - first_y);
    let inverse_l_3 = R::literal(1.0) / p.l_3;
    let t2 = inverse_l_3 * (third_x - second_x);
    let t3 = inverse_l_3 * (third_y - second_y);
    [inverse_l_1 * first_x, inverse_l_1 * first_y, -t0, -t1, t0, t1, -t2, -t3, t2, t3]
}

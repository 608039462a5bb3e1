// Emitted by Machinist 0.1.0; do not edit. To make it again:
//
//     cargo run --release -- gen
//
// Sources, with SHA-256:
//   5b7ba03a7b8c7607f85575b24543e580d5eb9c851c7ddafd50b456286de295fe  scenes/pendulum_constrained.toml
//   4c8ee37f2c8ba7febb53cb3d6b92bd44186fef63303e4ee1f9467038bf69e830  units/point_mass.toml
//
// Chain of three pendulums, by constraints
//
// The chain of `pendulum_chain` once more: three point masses in a plane, each held at its
// distance from the one above. The forces of the constraints are those in the links.
//
// Source:
//   Textbook.
//
// All quantities are in SI units.
// Shapes: coordinates 6, states 12, parameters 12, outputs 5, constraints 3.
// Nonzeros: mass_matrix 6 of 6 by 6, rate_jacobian 78 of 12 by 12, parameter_jacobian 54 of 12 by 12,
//     constraint_matrix 10 of 3 by 6.
// Operations: initial_state 8, rate 149, forcing 6, rate_jacobian 560, parameter_jacobian 524,
//     outputs 125, energy 25, power_balance 171, constraint_values 25, constraint_rates 33,
//     constraint_matrix 21, prepare 18, prepared_rate 134, prepared_rate_jacobian 542.

use ::machinist_contract::{Energy, PowerBalance, Real};

::machinist_contract::simulator! {
    /// Chain of three pendulums, by constraints
    ///
    /// The chain of \`pendulum_chain\` once more: three point masses in a plane, each held at its
    /// distance from the one above. The forces of the constraints are those in the links.
    ///
    /// Source: Textbook.
    PendulumConstrained: "pendulum_constrained", "Chain of three pendulums, by constraints";
    run from 0.0, until 5.0, points 1001, rtol 1e-8, method "dop853";
    quadratures 0, discontinuities 0;
    constraints; prepared;
}

::machinist_contract::parameters! {
    l_1: 1.0, "m", "l_1", "length of the first link";
    l_2: 0.7, "m", "l_2", "length of the second link";
    l_3: 0.4, "m", "l_3", "length of the third link";
    th_1: 0.9, "rad", "th_1", "angle of the first link at the start";
    th_2: 1.1, "rad", "th_2", "angle of the second link at the start";
    th_3: 1.4, "rad", "th_3", "angle of the third link at the start";
    first_mass: 1.0, "kg", "first.mass", "the mass";
    first_gravity: 9.81, "m/s^2", "first.gravity", "acceleration of free fall";
    second_mass: 0.8, "kg", "second.mass", "the mass";
    second_gravity: 9.81, "m/s^2", "second.gravity", "acceleration of free fall";
    third_mass: 0.5, "kg", "third.mass", "the mass";
    third_gravity: 9.81, "m/s^2", "third.gravity", "acceleration of free fall";
}

::machinist_contract::outputs! {
    end_x: "m", "end_x", "place, sideways";
    end_y: "m", "end_y", "place, upwards";
    force_1: "N", "force_1", "force in the first link, pushing";
    force_2: "N", "force_2", "force in the second link, pushing";
    force_3: "N", "force_3", "force in the third link, pushing";
}

::machinist_contract::states! {
    FIRST_X: position, 1.0, "m", "first.x", "place, sideways";
    FIRST_Y: position guess, 1.0, "m", "first.y", "place, upwards";
    SECOND_X: position, 1.0, "m", "second.x", "place, sideways";
    SECOND_Y: position guess, 1.0, "m", "second.y", "place, upwards";
    THIRD_X: position, 1.0, "m", "third.x", "place, sideways";
    THIRD_Y: position guess, 1.0, "m", "third.y", "place, upwards";
    FIRST_V_X: velocity guess, 1.0, "m/s", "first.v_x", "rate of place, sideways";
    FIRST_V_Y: velocity guess, 1.0, "m/s", "first.v_y", "rate of place, upwards";
    SECOND_V_X: velocity guess, 1.0, "m/s", "second.v_x", "rate of place, sideways";
    SECOND_V_Y: velocity guess, 1.0, "m/s", "second.v_y", "rate of place, upwards";
    THIRD_V_X: velocity guess, 1.0, "m/s", "third.v_x", "rate of place, sideways";
    THIRD_V_Y: velocity guess, 1.0, "m/s", "third.v_y", "rate of place, upwards";
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
    PARAMETER_JACOBIAN_PATTERN: 12 by 12 { 6 [0 1 2 6 7 8 9 10 11] 7 [0 1 2 6 7 8 9 10 11]
        8 [0 1 2 6 7 8 9 10 11] 9 [0 1 2 6 7 8 9 10 11] 10 [0 1 2 6 7 8 9 10 11]
        11 [0 1 2 6 7 8 9 10 11] }
    /// Nonzeros of G = dg'/dq'.
    CONSTRAINT_MATRIX_PATTERN: 3 by 6 { 0 [0 1] 1 [0 1 2 3] 2 [2 3 4 5] }
}

::machinist_contract::constants! {
    inverse_l_1, inverse_l_2, inverse_l_3, inverse_first_mass, inverse_second_mass, inverse_third_mass,
    first_mass_times_first_gravity, second_mass_times_second_gravity,
    third_mass_times_third_gravity, t0, t1, t2, t3, t4, t5
}

/// What `rate` and `rate_jacobian` need of the parameters, once a run. 18 operations.
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
    let t0 = -(first_mass_times_first_gravity * inverse_first_mass);
    let t1 = -(second_mass_times_second_gravity * inverse_second_mass);
    let t2 = -(third_mass_times_third_gravity * inverse_third_mass);
    let t3 = R::literal(2.0) / p.l_1;
    let t4 = R::literal(2.0) / p.l_2;
    let t5 = R::literal(2.0) / p.l_3;
    Constants { inverse_l_1, inverse_l_2, inverse_l_3, inverse_first_mass, inverse_second_mass,
        inverse_third_mass, first_mass_times_first_gravity, second_mass_times_second_gravity,
        third_mass_times_third_gravity, t0, t1, t2, t3, t4, t5 }
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

/// As `rate`, with the constants of the parameters from `prepare`. 134 operations.
#[must_use]
#[inline]
pub fn prepared_rate<R: Real>(_time: R, state: &[R; STATES], _p: &Parameters<R>,
        c: &Constants<R>) -> [R; STATES] {
    let [first_x, first_y, second_x, second_y, third_x, third_y, first_v_x, first_v_y, second_v_x,
        second_v_y, third_v_x, third_v_y] = *state;
    let inverse_l_1_times_first_x = c.inverse_l_1 * first_x;
    let t0 = c.inverse_l_2 * (first_x - second_x);
    let inverse_l_1_times_first_y = c.inverse_l_1 * first_y;
    let t1 = c.inverse_l_2 * (first_y - second_y);
    let t2 = c.inverse_l_2 * (second_x - first_x);
    let t3 = c.inverse_l_3 * (second_x - third_x);
    let t4 = c.inverse_l_2 * (second_y - first_y);
    let t5 = c.inverse_l_3 * (second_y - third_y);
    let t6 = c.inverse_l_3 * (third_x - second_x);
    let t7 = c.inverse_l_3 * (third_y - second_y);
    let t8 = inverse_l_1_times_first_x * c.inverse_first_mass;
    let t9 = t0 * c.inverse_first_mass;
    let t10 = inverse_l_1_times_first_y * c.inverse_first_mass;
    let t11 = t1 * c.inverse_first_mass;
    let t12 = t2 * c.inverse_second_mass;
    let t13 = t3 * c.inverse_second_mass;
    let t14 = t4 * c.inverse_second_mass;
    let t15 = t5 * c.inverse_second_mass;
    let t16 = t6 * c.inverse_third_mass;
    let t17 = t7 * c.inverse_third_mass;
    let t18 = R::literal(1.0) / (-(t10 * inverse_l_1_times_first_y)).sub_product(t8,
        inverse_l_1_times_first_x);
    let t19 = (-(t11 * inverse_l_1_times_first_y)).sub_product(t9, inverse_l_1_times_first_x);
    let t20 = t19 * t18;
    let t21 = R::literal(1.0) / (-(t11 * t1)).sub_product(t9, t0).sub_product(t12, t2)
        .sub_product(t14, t4).sub_product(t20, t19);
    let t22 = (-(t15 * t4)).sub_product(t13, t2);
    let t23 = t22 * t21;
    let first_v_x_squared = first_v_x * first_v_x;
    let first_v_y_squared = first_v_y * first_v_y;
    let second_v_x_squared = second_v_x * second_v_x;
    let second_v_y_squared = second_v_y * second_v_y;
    let t24 = (t10 * c.first_mass_times_first_gravity).sub_product(c.inverse_l_1, first_v_x_squared
        + first_v_y_squared);
    let t25 = (t11 * c.first_mass_times_first_gravity).add_product(c.inverse_l_2, (R::literal(2.0)
        * first_v_x * second_v_x).add_product(R::literal(2.0) * first_v_y, second_v_y)
        - first_v_x_squared - first_v_y_squared - second_v_x_squared - second_v_y_squared)
        .add_product(t14, c.second_mass_times_second_gravity).sub_product(t20, t24);
    let t26 = (t15 * c.second_mass_times_second_gravity).add_product(c.inverse_l_3,
        ((R::literal(2.0) * second_v_x * third_v_x).add_product(R::literal(2.0) * second_v_y,
        third_v_y) - second_v_x_squared - second_v_y_squared).sub_product(third_v_x, third_v_x)
        .sub_product(third_v_y, third_v_y)).add_product(t17, c.third_mass_times_third_gravity)
        .sub_product(t23, t25) * (R::literal(1.0) / (-(t15 * t5)).sub_product(t13, t3)
        .sub_product(t16, t6).sub_product(t17, t7).sub_product(t23, t22));
    let t27 = (t25 * t21).sub_product(t23, t26);
    let t28 = (t24 * t18).sub_product(t20, t27);
    let third_v_y_dot = c.t2.sub_product(t17, t26);
    let third_v_x_dot = -(t16 * t26);
    let second_v_y_dot = c.t1.sub_product(t14, t27).sub_product(t15, t26);
    let second_v_x_dot = (-(t13 * t26)).sub_product(t12, t27);
    let first_v_y_dot = c.t0.sub_product(t10, t28).sub_product(t11, t27);
    let first_v_x_dot = (-(t9 * t27)).sub_product(t8, t28);
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

/// As `rate_jacobian`, with the constants of the parameters from `prepare`. 542 operations.
#[must_use]
pub fn prepared_rate_jacobian<R: Real>(_time: R, state: &[R; STATES], _p: &Parameters<R>,
        c: &Constants<R>) -> [R; 78] {
    let [first_x, first_y, second_x, second_y, third_x, third_y, first_v_x, first_v_y, second_v_x,
        second_v_y, third_v_x, third_v_y] = *state;
    let inverse_l_1_times_first_x = c.inverse_l_1 * first_x;
    let t0 = c.inverse_l_2 * (first_x - second_x);
    let inverse_l_1_times_first_y = c.inverse_l_1 * first_y;
    let t1 = c.inverse_l_2 * (first_y - second_y);
    let t2 = c.inverse_l_2 * (second_x - first_x);
    let t3 = c.inverse_l_3 * (second_x - third_x);
    let t4 = c.inverse_l_2 * (second_y - first_y);
    let t5 = c.inverse_l_3 * (second_y - third_y);
    let t6 = c.inverse_l_3 * (third_x - second_x);
    let t7 = c.inverse_l_3 * (third_y - second_y);
    let t8 = inverse_l_1_times_first_x * c.inverse_first_mass;
    let t9 = t0 * c.inverse_first_mass;
    let t10 = inverse_l_1_times_first_y * c.inverse_first_mass;
    let t11 = t1 * c.inverse_first_mass;
    let t12 = t2 * c.inverse_second_mass;
    let t13 = t3 * c.inverse_second_mass;
    let t14 = t4 * c.inverse_second_mass;
    let t15 = t5 * c.inverse_second_mass;
    let t16 = t6 * c.inverse_third_mass;
    let t17 = t7 * c.inverse_third_mass;
    let t18 = R::literal(1.0) / (-(t10 * inverse_l_1_times_first_y)).sub_product(t8,
        inverse_l_1_times_first_x);
    let t19 = (-(t11 * inverse_l_1_times_first_y)).sub_product(t9, inverse_l_1_times_first_x);
    let t20 = t19 * t18;
    let t21 = R::literal(1.0) / (-(t11 * t1)).sub_product(t9, t0).sub_product(t12, t2)
        .sub_product(t14, t4).sub_product(t20, t19);
    let t22 = (-(t15 * t4)).sub_product(t13, t2);
    let t23 = t22 * t21;
    let t24 = R::literal(1.0) / (-(t15 * t5)).sub_product(t13, t3).sub_product(t16, t6)
        .sub_product(t17, t7).sub_product(t23, t22);
    let first_v_x_squared = first_v_x * first_v_x;
    let first_v_y_squared = first_v_y * first_v_y;
    let second_v_x_squared = second_v_x * second_v_x;
    let second_v_y_squared = second_v_y * second_v_y;
    let t25 = (t10 * c.first_mass_times_first_gravity).sub_product(c.inverse_l_1, first_v_x_squared
        + first_v_y_squared);
    let t26 = (t11 * c.first_mass_times_first_gravity).add_product(c.inverse_l_2, (R::literal(2.0)
        * first_v_x * second_v_x).add_product(R::literal(2.0) * first_v_y, second_v_y)
        - first_v_x_squared - first_v_y_squared - second_v_x_squared - second_v_y_squared)
        .add_product(t14, c.second_mass_times_second_gravity).sub_product(t20, t25);
    let t27 = (t15 * c.second_mass_times_second_gravity).add_product(c.inverse_l_3,
        ((R::literal(2.0) * second_v_x * third_v_x).add_product(R::literal(2.0) * second_v_y,
        third_v_y) - second_v_x_squared - second_v_y_squared).sub_product(third_v_x, third_v_x)
        .sub_product(third_v_y, third_v_y)).add_product(t17, c.third_mass_times_third_gravity)
        .sub_product(t23, t26) * t24;
    let t28 = (t26 * t21).sub_product(t23, t27);
    let t29 = (t25 * t18).sub_product(t20, t28);
    let third_v_y_dot = c.t2.sub_product(t17, t27);
    let second_v_y_dot = c.t1.sub_product(t14, t28).sub_product(t15, t27);
    let second_v_x_dot = (-(t13 * t27)).sub_product(t12, t28);
    let first_v_y_dot = c.t0.sub_product(t10, t29).sub_product(t11, t28);
    let first_v_x_dot = (-(t9 * t28)).sub_product(t8, t29);
    let t30 = c.inverse_l_2 * t28;
    let t31 = (-t30).sub_product(c.inverse_l_1, t29);
    let inverse_l_2_times_first_v_x_dot = c.inverse_l_2 * first_v_x_dot;
    let inverse_l_2_times_second_v_x_dot = c.inverse_l_2 * second_v_x_dot;
    let t32 = (-(t8 * t31)).sub_product(c.inverse_l_1, first_v_x_dot);
    let t33 = (inverse_l_2_times_second_v_x_dot - inverse_l_2_times_first_v_x_dot).sub_product(t9,
        t31).sub_product(t12, t30).sub_product(t20, t32);
    let t34 = t31 * c.inverse_first_mass;
    let t35 = t30 * c.inverse_second_mass;
    let t36 = (-(t13 * t30)).sub_product(t23, t33) * t24;
    let t37 = (t33 * t21).sub_product(t23, t36);
    let t38 = (t32 * t18).sub_product(t20, t37);
    let third_v_y_dot_by_first_x = -(t17 * t36);
    let third_v_x_dot_by_first_x = -(t16 * t36);
    let second_v_y_dot_by_first_x = (-(t15 * t36)).sub_product(t14, t37);
    let second_v_x_dot_by_first_x = t35.sub_product(t12, t37).sub_product(t13, t36);
    let first_v_y_dot_by_first_x = (-(t11 * t37)).sub_product(t10, t38);
    let first_v_x_dot_by_first_x = t34.sub_product(t8, t38).sub_product(t9, t37);
    let inverse_l_2_times_first_v_y_dot = c.inverse_l_2 * first_v_y_dot;
    let inverse_l_2_times_second_v_y_dot = c.inverse_l_2 * second_v_y_dot;
    let t39 = (-(t10 * t31)).sub_product(c.inverse_l_1, first_v_y_dot);
    let t40 = (inverse_l_2_times_second_v_y_dot - inverse_l_2_times_first_v_y_dot).sub_product(t11,
        t31).sub_product(t14, t30).sub_product(t20, t39);
    let t41 = (-(t15 * t30)).sub_product(t23, t40) * t24;
    let t42 = (t40 * t21).sub_product(t23, t41);
    let t43 = (t39 * t18).sub_product(t20, t42);
    let third_v_y_dot_by_first_y = -(t17 * t41);
    let third_v_x_dot_by_first_y = -(t16 * t41);
    let second_v_y_dot_by_first_y = t35.sub_product(t14, t42).sub_product(t15, t41);
    let second_v_x_dot_by_first_y = (-(t13 * t41)).sub_product(t12, t42);
    let first_v_y_dot_by_first_y = t34.sub_product(t10, t43).sub_product(t11, t42);
    let first_v_x_dot_by_first_y = (-(t9 * t42)).sub_product(t8, t43);
    let t44 = c.inverse_l_3 * t27;
    let t45 = -t30 - t44;
    let inverse_l_3_times_second_v_x_dot = c.inverse_l_3 * second_v_x_dot;
    let t46 = c.inverse_l_3 * (t16 * t27);
    let t47 = t8 * t30;
    let t48 = (inverse_l_2_times_first_v_x_dot - inverse_l_2_times_second_v_x_dot).sub_product(t9,
        t30).sub_product(t12, t45).add_product(t20, t47);
    let t49 = t16 * t44;
    let t50 = t30 * c.inverse_first_mass;
    let t51 = t45 * c.inverse_second_mass;
    let t52 = t44 * c.inverse_third_mass;
    let t53 = ((-inverse_l_3_times_second_v_x_dot - t46).sub_product(t13, t45) - t49)
        .sub_product(t23, t48) * t24;
    let t54 = (t48 * t21).sub_product(t23, t53);
    let t55 = (-(t47 * t18)).sub_product(t20, t54);
    let third_v_y_dot_by_second_x = -(t17 * t53);
    let third_v_x_dot_by_second_x = t52.sub_product(t16, t53);
    let second_v_y_dot_by_second_x = (-(t15 * t53)).sub_product(t14, t54);
    let second_v_x_dot_by_second_x = t51.sub_product(t12, t54).sub_product(t13, t53);
    let first_v_y_dot_by_second_x = (-(t11 * t54)).sub_product(t10, t55);
    let first_v_x_dot_by_second_x = t50.sub_product(t8, t55).sub_product(t9, t54);
    let inverse_l_3_times_second_v_y_dot = c.inverse_l_3 * second_v_y_dot;
    let inverse_l_3_times_third_v_y_dot = c.inverse_l_3 * third_v_y_dot;
    let t56 = t10 * t30;
    let t57 = (inverse_l_2_times_first_v_y_dot - inverse_l_2_times_second_v_y_dot).sub_product(t11,
        t30).sub_product(t14, t45).add_product(t20, t56);
    let t58 = t17 * t44;
    let t59 = ((inverse_l_3_times_third_v_y_dot - inverse_l_3_times_second_v_y_dot)
        .sub_product(t15, t45) - t58).sub_product(t23, t57) * t24;
    let t60 = (t57 * t21).sub_product(t23, t59);
    let t61 = (-(t56 * t18)).sub_product(t20, t60);
    let third_v_y_dot_by_second_y = t52.sub_product(t17, t59);
    let third_v_x_dot_by_second_y = -(t16 * t59);
    let second_v_y_dot_by_second_y = t51.sub_product(t14, t60).sub_product(t15, t59);
    let second_v_x_dot_by_second_y = (-(t13 * t59)).sub_product(t12, t60);
    let first_v_y_dot_by_second_y = t50.sub_product(t10, t61).sub_product(t11, t60);
    let first_v_x_dot_by_second_y = (-(t9 * t60)).sub_product(t8, t61);
    let t62 = t12 * t44;
    let t63 = t44 * c.inverse_second_mass;
    let t64 = -t52;
    let t65 = ((inverse_l_3_times_second_v_x_dot + t46).sub_product(t13, t44) + t49)
        .add_product(t23, t62) * t24;
    let t66 = (-(t62 * t21)).sub_product(t23, t65);
    let t67 = t20 * t66;
    let third_v_y_dot_by_third_x = -(t17 * t65);
    let third_v_x_dot_by_third_x = t64.sub_product(t16, t65);
    let second_v_y_dot_by_third_x = (-(t15 * t65)).sub_product(t14, t66);
    let second_v_x_dot_by_third_x = t63.sub_product(t12, t66).sub_product(t13, t65);
    let first_v_y_dot_by_third_x = (-(t11 * t66)).add_product(t10, t67);
    let first_v_x_dot_by_third_x = (-(t9 * t66)).add_product(t8, t67);
    let t68 = t14 * t44;
    let t69 = ((inverse_l_3_times_second_v_y_dot - inverse_l_3_times_third_v_y_dot)
        .sub_product(t15, t44) + t58).add_product(t23, t68) * t24;
    let t70 = (-(t68 * t21)).sub_product(t23, t69);
    let t71 = t20 * t70;
    let third_v_y_dot_by_third_y = t64.sub_product(t17, t69);
    let third_v_x_dot_by_third_y = -(t16 * t69);
    let second_v_y_dot_by_third_y = t63.sub_product(t14, t70).sub_product(t15, t69);
    let second_v_x_dot_by_third_y = (-(t13 * t69)).sub_product(t12, t70);
    let first_v_y_dot_by_third_y = (-(t11 * t70)).add_product(t10, t71);
    let first_v_x_dot_by_third_y = (-(t9 * t70)).add_product(t8, t71);
    let t72 = c.t3 * first_v_x;
    let t73 = c.t4 * (first_v_x - second_v_x);
    let t74 = (-t73).add_product(t20, t72);
    let t75 = t23 * t74 * t24;
    let t76 = (t74 * t21).add_product(t23, t75);
    let t77 = (-(t72 * t18)).sub_product(t20, t76);
    let third_v_y_dot_by_first_v_x = t17 * t75;
    let third_v_x_dot_by_first_v_x = t16 * t75;
    let second_v_y_dot_by_first_v_x = (t15 * t75).sub_product(t14, t76);
    let second_v_x_dot_by_first_v_x = (t13 * t75).sub_product(t12, t76);
    let first_v_y_dot_by_first_v_x = (-(t11 * t76)).sub_product(t10, t77);
    let first_v_x_dot_by_first_v_x = (-(t9 * t76)).sub_product(t8, t77);
    let t78 = c.t3 * first_v_y;
    let t79 = c.t4 * (first_v_y - second_v_y);
    let t80 = (-t79).add_product(t20, t78);
    let t81 = t23 * t80 * t24;
    let t82 = (t80 * t21).add_product(t23, t81);
    let t83 = (-(t78 * t18)).sub_product(t20, t82);
    let third_v_y_dot_by_first_v_y = t17 * t81;
    let third_v_x_dot_by_first_v_y = t16 * t81;
    let second_v_y_dot_by_first_v_y = (t15 * t81).sub_product(t14, t82);
    let second_v_x_dot_by_first_v_y = (t13 * t81).sub_product(t12, t82);
    let first_v_y_dot_by_first_v_y = (-(t11 * t82)).sub_product(t10, t83);
    let first_v_x_dot_by_first_v_y = (-(t9 * t82)).sub_product(t8, t83);
    let t84 = c.t5 * (second_v_x - third_v_x);
    let t85 = (-t84).sub_product(t23, t73) * t24;
    let t86 = (t73 * t21).sub_product(t23, t85);
    let t87 = t20 * t86;
    let third_v_y_dot_by_second_v_x = -(t17 * t85);
    let third_v_x_dot_by_second_v_x = -(t16 * t85);
    let second_v_y_dot_by_second_v_x = (-(t15 * t85)).sub_product(t14, t86);
    let second_v_x_dot_by_second_v_x = (-(t13 * t85)).sub_product(t12, t86);
    let first_v_y_dot_by_second_v_x = (-(t11 * t86)).add_product(t10, t87);
    let first_v_x_dot_by_second_v_x = (-(t9 * t86)).add_product(t8, t87);
    let t88 = c.t5 * (second_v_y - third_v_y);
    let t89 = (-t88).sub_product(t23, t79) * t24;
    let t90 = (t79 * t21).sub_product(t23, t89);
    let t91 = t20 * t90;
    let third_v_y_dot_by_second_v_y = -(t17 * t89);
    let third_v_x_dot_by_second_v_y = -(t16 * t89);
    let second_v_y_dot_by_second_v_y = (-(t15 * t89)).sub_product(t14, t90);
    let second_v_x_dot_by_second_v_y = (-(t13 * t89)).sub_product(t12, t90);
    let first_v_y_dot_by_second_v_y = (-(t11 * t90)).add_product(t10, t91);
    let first_v_x_dot_by_second_v_y = (-(t9 * t90)).add_product(t8, t91);
    let t92 = t84 * t24;
    let t93 = t23 * t92;
    let t94 = t20 * t93;
    let third_v_y_dot_by_third_v_x = -(t17 * t92);
    let third_v_x_dot_by_third_v_x = -(t16 * t92);
    let second_v_y_dot_by_third_v_x = (-(t15 * t92)).add_product(t14, t93);
    let second_v_x_dot_by_third_v_x = (-(t13 * t92)).add_product(t12, t93);
    let first_v_y_dot_by_third_v_x = (t11 * t93).sub_product(t10, t94);
    let first_v_x_dot_by_third_v_x = (t9 * t93).sub_product(t8, t94);
    let t95 = t88 * t24;
    let t96 = t23 * t95;
    let t97 = t20 * t96;
    let third_v_y_dot_by_third_v_y = -(t17 * t95);
    let third_v_x_dot_by_third_v_y = -(t16 * t95);
    let second_v_y_dot_by_third_v_y = (-(t15 * t95)).add_product(t14, t96);
    let second_v_x_dot_by_third_v_y = (-(t13 * t95)).add_product(t12, t96);
    let first_v_y_dot_by_third_v_y = (t11 * t96).sub_product(t10, t97);
    let first_v_x_dot_by_third_v_y = (t9 * t96).sub_product(t8, t97);
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

/// `dy'/dp`, values in the order of its pattern. 524 operations.
#[must_use]
pub fn parameter_jacobian<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>) -> [R; 54] {
    let [first_x, first_y, second_x, second_y, third_x, third_y, first_v_x, first_v_y, second_v_x,
        second_v_y, third_v_x, third_v_y] = *state;
    let inverse_l_1 = R::literal(1.0) / p.l_1;
    let inverse_l_1_times_first_x = inverse_l_1 * first_x;
    let first_x_minus_second_x = first_x - second_x;
    let inverse_l_2 = R::literal(1.0) / p.l_2;
    let t0 = inverse_l_2 * first_x_minus_second_x;
    let inverse_l_1_times_first_y = inverse_l_1 * first_y;
    let first_y_minus_second_y = first_y - second_y;
    let t1 = inverse_l_2 * first_y_minus_second_y;
    let second_x_minus_first_x = second_x - first_x;
    let t2 = inverse_l_2 * second_x_minus_first_x;
    let second_x_minus_third_x = second_x - third_x;
    let inverse_l_3 = R::literal(1.0) / p.l_3;
    let t3 = inverse_l_3 * second_x_minus_third_x;
    let second_y_minus_first_y = second_y - first_y;
    let t4 = inverse_l_2 * second_y_minus_first_y;
    let second_y_minus_third_y = second_y - third_y;
    let t5 = inverse_l_3 * second_y_minus_third_y;
    let third_x_minus_second_x = third_x - second_x;
    let t6 = inverse_l_3 * third_x_minus_second_x;
    let third_y_minus_second_y = third_y - second_y;
    let t7 = inverse_l_3 * third_y_minus_second_y;
    let inverse_first_mass = R::literal(1.0) / p.first_mass;
    let t8 = inverse_l_1_times_first_x * inverse_first_mass;
    let t9 = t0 * inverse_first_mass;
    let t10 = inverse_l_1_times_first_y * inverse_first_mass;
    let t11 = t1 * inverse_first_mass;
    let inverse_second_mass = R::literal(1.0) / p.second_mass;
    let t12 = t2 * inverse_second_mass;
    let t13 = t3 * inverse_second_mass;
    let t14 = t4 * inverse_second_mass;
    let t15 = t5 * inverse_second_mass;
    let inverse_third_mass = R::literal(1.0) / p.third_mass;
    let t16 = t6 * inverse_third_mass;
    let t17 = t7 * inverse_third_mass;
    let t18 = R::literal(1.0) / (-(t10 * inverse_l_1_times_first_y)).sub_product(t8,
        inverse_l_1_times_first_x);
    let t19 = (-(t11 * inverse_l_1_times_first_y)).sub_product(t9, inverse_l_1_times_first_x);
    let t20 = t19 * t18;
    let t21 = R::literal(1.0) / (-(t11 * t1)).sub_product(t9, t0).sub_product(t12, t2)
        .sub_product(t14, t4).sub_product(t20, t19);
    let t22 = (-(t15 * t4)).sub_product(t13, t2);
    let t23 = t22 * t21;
    let t24 = R::literal(1.0) / (-(t15 * t5)).sub_product(t13, t3).sub_product(t16, t6)
        .sub_product(t17, t7).sub_product(t23, t22);
    let first_mass_times_first_gravity = p.first_mass * p.first_gravity;
    let second_mass_times_second_gravity = p.second_mass * p.second_gravity;
    let third_mass_times_third_gravity = p.third_mass * p.third_gravity;
    let first_v_x_squared = first_v_x * first_v_x;
    let first_v_y_squared = first_v_y * first_v_y;
    let t25 = first_v_x_squared + first_v_y_squared;
    let second_v_x_squared = second_v_x * second_v_x;
    let second_v_y_squared = second_v_y * second_v_y;
    let t26 = R::literal(2.0) * first_v_x * second_v_x;
    let t27 = R::literal(2.0) * first_v_y * second_v_y;
    let third_v_x_squared = third_v_x * third_v_x;
    let third_v_y_squared = third_v_y * third_v_y;
    let t28 = R::literal(2.0) * second_v_x * third_v_x;
    let t29 = R::literal(2.0) * second_v_y * third_v_y;
    let t30 = (-(inverse_l_1 * t25)).add_product(t10, first_mass_times_first_gravity);
    let t31 = (t11 * first_mass_times_first_gravity).add_product(inverse_l_2, t26 + t27
        - first_v_x_squared - first_v_y_squared - second_v_x_squared - second_v_y_squared)
        .add_product(t14, second_mass_times_second_gravity).sub_product(t20, t30);
    let t32 = (t15 * second_mass_times_second_gravity).add_product(inverse_l_3, t28 + t29
        - second_v_x_squared - second_v_y_squared - third_v_x_squared - third_v_y_squared)
        .add_product(t17, third_mass_times_third_gravity).sub_product(t23, t31) * t24;
    let t33 = (t31 * t21).sub_product(t23, t32);
    let t34 = (t30 * t18).sub_product(t20, t33);
    let third_v_y_dot = (-(third_mass_times_third_gravity * inverse_third_mass)).sub_product(t17,
        t32);
    let t35 = t16 * t32;
    let second_v_y_dot = (-(second_mass_times_second_gravity * inverse_second_mass))
        .sub_product(t14, t33).sub_product(t15, t32);
    let t36 = t12 * t33;
    let t37 = t13 * t32;
    let second_v_x_dot = -t36 - t37;
    let first_v_y_dot = (-(first_mass_times_first_gravity * inverse_first_mass)).sub_product(t10,
        t34).sub_product(t11, t33);
    let t38 = t8 * t34;
    let t39 = t9 * t33;
    let first_v_x_dot = -t38 - t39;
    let inverse_l_1_squared = R::literal(1.0) / (p.l_1 * p.l_1);
    let inverse_l_1_squared_times_first_x = inverse_l_1_squared * first_x;
    let t40 = inverse_l_1_squared_times_first_x * t34;
    let inverse_l_1_squared_times_first_y = inverse_l_1_squared * first_y;
    let t41 = inverse_l_1_squared_times_first_y * t34;
    let t42 = (inverse_l_1_squared * t25).add_product(inverse_l_1_squared_times_first_x,
        first_v_x_dot).add_product(inverse_l_1_squared_times_first_y, first_v_y_dot)
        .sub_product(t8, t40).sub_product(t10, t41);
    let t43 = (-(t11 * t41)).sub_product(t9, t40).sub_product(t20, t42);
    let t44 = t23 * t43 * t24;
    let t45 = (t43 * t21).add_product(t23, t44);
    let t46 = (t42 * t18).sub_product(t20, t45);
    let third_v_y_dot_by_l_1 = t17 * t44;
    let third_v_x_dot_by_l_1 = t16 * t44;
    let second_v_y_dot_by_l_1 = (t15 * t44).sub_product(t14, t45);
    let second_v_x_dot_by_l_1 = (t13 * t44).sub_product(t12, t45);
    let first_v_y_dot_by_l_1 = (t41 * inverse_first_mass).sub_product(t10, t46).sub_product(t11,
        t45);
    let first_v_x_dot_by_l_1 = (t40 * inverse_first_mass).sub_product(t8, t46).sub_product(t9, t45);
    let inverse_l_2_squared = R::literal(1.0) / (p.l_2 * p.l_2);
    let t47 = inverse_l_2_squared * second_x_minus_first_x;
    let t48 = t47 * t33;
    let t49 = inverse_l_2_squared * second_y_minus_first_y;
    let t50 = t49 * t33;
    let t51 = inverse_l_2_squared * first_x_minus_second_x;
    let t52 = t51 * t33;
    let t53 = inverse_l_2_squared * first_y_minus_second_y;
    let t54 = t53 * t33;
    let t55 = (t8 * t48).add_product(t10, t50);
    let t56 = (inverse_l_2_squared * (t25 + second_v_x_squared + second_v_y_squared - t26 - t27))
        .sub_product(t47, first_v_x_dot).sub_product(t49, first_v_y_dot).sub_product(t51,
        second_v_x_dot).sub_product(t53, second_v_y_dot).add_product(t9, t48).add_product(t11, t50)
        .add_product(t12, t52).add_product(t14, t54).sub_product(t20, t55);
    let t57 = (t13 * t52).add_product(t15, t54).sub_product(t23, t56) * t24;
    let t58 = (t56 * t21).sub_product(t23, t57);
    let t59 = (t55 * t18).sub_product(t20, t58);
    let third_v_y_dot_by_l_2 = -(t17 * t57);
    let third_v_x_dot_by_l_2 = -(t16 * t57);
    let second_v_y_dot_by_l_2 = (-(t54 * inverse_second_mass)).sub_product(t14, t58)
        .sub_product(t15, t57);
    let second_v_x_dot_by_l_2 = (-(t52 * inverse_second_mass)).sub_product(t12, t58)
        .sub_product(t13, t57);
    let first_v_y_dot_by_l_2 = (-(t50 * inverse_first_mass)).sub_product(t10, t59).sub_product(t11,
        t58);
    let first_v_x_dot_by_l_2 = (-(t48 * inverse_first_mass)).sub_product(t8, t59).sub_product(t9,
        t58);
    let inverse_l_3_squared = R::literal(1.0) / (p.l_3 * p.l_3);
    let t60 = inverse_l_3_squared * third_x_minus_second_x;
    let t61 = t60 * t32;
    let t62 = inverse_l_3_squared * third_y_minus_second_y;
    let t63 = t62 * t32;
    let t64 = inverse_l_3_squared * second_x_minus_third_x;
    let t65 = t64 * t32;
    let t66 = inverse_l_3_squared * second_y_minus_third_y;
    let t67 = t66 * t32;
    let t68 = (t12 * t61).add_product(t14, t63);
    let t69 = (inverse_l_3_squared * (second_v_x_squared + second_v_y_squared + third_v_x_squared
        + third_v_y_squared - t28 - t29)).sub_product(t60, second_v_x_dot).sub_product(t62,
        second_v_y_dot).add_product(t64, t35).sub_product(t66, third_v_y_dot).add_product(t13, t61)
        .add_product(t15, t63).add_product(t16, t65).add_product(t17, t67).sub_product(t23, t68)
        * t24;
    let t70 = (t68 * t21).sub_product(t23, t69);
    let t71 = t20 * t70;
    let third_v_y_dot_by_l_3 = (-(t67 * inverse_third_mass)).sub_product(t17, t69);
    let third_v_x_dot_by_l_3 = (-(t65 * inverse_third_mass)).sub_product(t16, t69);
    let second_v_y_dot_by_l_3 = (-(t63 * inverse_second_mass)).sub_product(t14, t70)
        .sub_product(t15, t69);
    let second_v_x_dot_by_l_3 = (-(t61 * inverse_second_mass)).sub_product(t12, t70)
        .sub_product(t13, t69);
    let first_v_y_dot_by_l_3 = (-(t11 * t70)).add_product(t10, t71);
    let first_v_x_dot_by_l_3 = (-(t9 * t70)).add_product(t8, t71);
    let t72 = t39 + t38;
    let t73 = -p.first_gravity - first_v_y_dot;
    let t74 = (-(t8 * t72)).sub_product(t10, t73);
    let t75 = (-(t9 * t72)).sub_product(t11, t73).sub_product(t20, t74);
    let t76 = t23 * t75 * t24;
    let t77 = (t75 * t21).add_product(t23, t76);
    let t78 = (t74 * t18).sub_product(t20, t77);
    let third_v_y_dot_by_first_mass = t17 * t76;
    let third_v_x_dot_by_first_mass = t16 * t76;
    let second_v_y_dot_by_first_mass = (t15 * t76).sub_product(t14, t77);
    let second_v_x_dot_by_first_mass = (t13 * t76).sub_product(t12, t77);
    let first_v_y_dot_by_first_mass = (t73 * inverse_first_mass).sub_product(t10, t78)
        .sub_product(t11, t77);
    let first_v_x_dot_by_first_mass = (t72 * inverse_first_mass).sub_product(t8, t78)
        .sub_product(t9, t77);
    let t79 = t10 * p.first_mass;
    let t80 = (t11 * p.first_mass).sub_product(t20, t79);
    let t81 = t23 * t80 * t24;
    let t82 = (t80 * t21).add_product(t23, t81);
    let t83 = (t79 * t18).sub_product(t20, t82);
    let third_v_y_dot_by_first_gravity = t17 * t81;
    let third_v_x_dot_by_first_gravity = t16 * t81;
    let second_v_y_dot_by_first_gravity = (t15 * t81).sub_product(t14, t82);
    let second_v_x_dot_by_first_gravity = (t13 * t81).sub_product(t12, t82);
    let first_v_y_dot_by_first_gravity = (-(p.first_mass * inverse_first_mass)).sub_product(t10,
        t83).sub_product(t11, t82);
    let first_v_x_dot_by_first_gravity = (-(t9 * t82)).sub_product(t8, t83);
    let t84 = t37 + t36;
    let t85 = -p.second_gravity - second_v_y_dot;
    let t86 = (-(t12 * t84)).sub_product(t14, t85);
    let t87 = (-(t13 * t84)).sub_product(t15, t85).sub_product(t23, t86) * t24;
    let t88 = (t86 * t21).sub_product(t23, t87);
    let t89 = t20 * t88;
    let third_v_y_dot_by_second_mass = -(t17 * t87);
    let third_v_x_dot_by_second_mass = -(t16 * t87);
    let second_v_y_dot_by_second_mass = (t85 * inverse_second_mass).sub_product(t14, t88)
        .sub_product(t15, t87);
    let second_v_x_dot_by_second_mass = (t84 * inverse_second_mass).sub_product(t12, t88)
        .sub_product(t13, t87);
    let first_v_y_dot_by_second_mass = (-(t11 * t88)).add_product(t10, t89);
    let first_v_x_dot_by_second_mass = (-(t9 * t88)).add_product(t8, t89);
    let t90 = t14 * p.second_mass;
    let t91 = (t15 * p.second_mass).sub_product(t23, t90) * t24;
    let t92 = (t90 * t21).sub_product(t23, t91);
    let t93 = t20 * t92;
    let third_v_y_dot_by_second_gravity = -(t17 * t91);
    let third_v_x_dot_by_second_gravity = -(t16 * t91);
    let second_v_y_dot_by_second_gravity = (-(p.second_mass * inverse_second_mass))
        .sub_product(t14, t92).sub_product(t15, t91);
    let second_v_x_dot_by_second_gravity = (-(t13 * t91)).sub_product(t12, t92);
    let first_v_y_dot_by_second_gravity = (-(t11 * t92)).add_product(t10, t93);
    let first_v_x_dot_by_second_gravity = (-(t9 * t92)).add_product(t8, t93);
    let t94 = -p.third_gravity - third_v_y_dot;
    let t95 = (-(t16 * t35)).sub_product(t17, t94) * t24;
    let t96 = t23 * t95;
    let t97 = t20 * t96;
    let third_v_y_dot_by_third_mass = (t94 * inverse_third_mass).sub_product(t17, t95);
    let third_v_x_dot_by_third_mass = (t35 * inverse_third_mass).sub_product(t16, t95);
    let second_v_y_dot_by_third_mass = (-(t15 * t95)).add_product(t14, t96);
    let second_v_x_dot_by_third_mass = (-(t13 * t95)).add_product(t12, t96);
    let first_v_y_dot_by_third_mass = (t11 * t96).sub_product(t10, t97);
    let first_v_x_dot_by_third_mass = (t9 * t96).sub_product(t8, t97);
    let t98 = t17 * p.third_mass * t24;
    let t99 = t23 * t98;
    let t100 = t20 * t99;
    let third_v_y_dot_by_third_gravity = (-(p.third_mass * inverse_third_mass)).sub_product(t17,
        t98);
    let third_v_x_dot_by_third_gravity = -(t16 * t98);
    let second_v_y_dot_by_third_gravity = (-(t15 * t98)).add_product(t14, t99);
    let second_v_x_dot_by_third_gravity = (-(t13 * t98)).add_product(t12, t99);
    let first_v_y_dot_by_third_gravity = (t11 * t99).sub_product(t10, t100);
    let first_v_x_dot_by_third_gravity = (t9 * t99).sub_product(t8, t100);
    [first_v_x_dot_by_l_1, first_v_x_dot_by_l_2, first_v_x_dot_by_l_3, first_v_x_dot_by_first_mass,
        first_v_x_dot_by_first_gravity, first_v_x_dot_by_second_mass,
        first_v_x_dot_by_second_gravity, first_v_x_dot_by_third_mass,
        first_v_x_dot_by_third_gravity, first_v_y_dot_by_l_1, first_v_y_dot_by_l_2,
        first_v_y_dot_by_l_3, first_v_y_dot_by_first_mass, first_v_y_dot_by_first_gravity,
        first_v_y_dot_by_second_mass, first_v_y_dot_by_second_gravity, first_v_y_dot_by_third_mass,
        first_v_y_dot_by_third_gravity, second_v_x_dot_by_l_1, second_v_x_dot_by_l_2,
        second_v_x_dot_by_l_3, second_v_x_dot_by_first_mass, second_v_x_dot_by_first_gravity,
        second_v_x_dot_by_second_mass, second_v_x_dot_by_second_gravity,
        second_v_x_dot_by_third_mass, second_v_x_dot_by_third_gravity, second_v_y_dot_by_l_1,
        second_v_y_dot_by_l_2, second_v_y_dot_by_l_3, second_v_y_dot_by_first_mass,
        second_v_y_dot_by_first_gravity, second_v_y_dot_by_second_mass,
        second_v_y_dot_by_second_gravity, second_v_y_dot_by_third_mass,
        second_v_y_dot_by_third_gravity, third_v_x_dot_by_l_1, third_v_x_dot_by_l_2,
        third_v_x_dot_by_l_3, third_v_x_dot_by_first_mass, third_v_x_dot_by_first_gravity,
        third_v_x_dot_by_second_mass, third_v_x_dot_by_second_gravity, third_v_x_dot_by_third_mass,
        third_v_x_dot_by_third_gravity, third_v_y_dot_by_l_1, third_v_y_dot_by_l_2,
        third_v_y_dot_by_l_3, third_v_y_dot_by_first_mass, third_v_y_dot_by_first_gravity,
        third_v_y_dot_by_second_mass, third_v_y_dot_by_second_gravity, third_v_y_dot_by_third_mass,
        third_v_y_dot_by_third_gravity]
}

/// Partial derivative of `y'` with respect to time. No operations.
#[must_use]
pub fn time_derivative<R: Real>(_time: R, _state: &[R; STATES], _p: &Parameters<R>) -> [R; STATES] {
    [R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0),
        R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0),
        R::literal(0.0), R::literal(0.0)]
}

/// Wanted outputs. 125 operations.
#[must_use]
pub fn outputs<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>) -> Outputs<R> {
    let [first_x, first_y, second_x, second_y, third_x, third_y, first_v_x, first_v_y, second_v_x,
        second_v_y, third_v_x, third_v_y] = *state;
    let inverse_l_1 = R::literal(1.0) / p.l_1;
    let inverse_l_1_times_first_x = inverse_l_1 * first_x;
    let inverse_l_2 = R::literal(1.0) / p.l_2;
    let t0 = inverse_l_2 * (first_x - second_x);
    let inverse_l_1_times_first_y = inverse_l_1 * first_y;
    let t1 = inverse_l_2 * (first_y - second_y);
    let t2 = inverse_l_2 * (second_x - first_x);
    let inverse_l_3 = R::literal(1.0) / p.l_3;
    let t3 = inverse_l_3 * (second_x - third_x);
    let t4 = inverse_l_2 * (second_y - first_y);
    let t5 = inverse_l_3 * (second_y - third_y);
    let t6 = inverse_l_3 * (third_x - second_x);
    let t7 = inverse_l_3 * (third_y - second_y);
    let inverse_first_mass = R::literal(1.0) / p.first_mass;
    let t8 = t0 * inverse_first_mass;
    let t9 = inverse_l_1_times_first_y * inverse_first_mass;
    let t10 = t1 * inverse_first_mass;
    let inverse_second_mass = R::literal(1.0) / p.second_mass;
    let t11 = t3 * inverse_second_mass;
    let t12 = t4 * inverse_second_mass;
    let t13 = t5 * inverse_second_mass;
    let inverse_third_mass = R::literal(1.0) / p.third_mass;
    let t14 = t7 * inverse_third_mass;
    let t15 = R::literal(1.0) / (-(t9 * inverse_l_1_times_first_y))
        .sub_product(inverse_l_1_times_first_x * inverse_first_mass, inverse_l_1_times_first_x);
    let t16 = (-(t10 * inverse_l_1_times_first_y)).sub_product(t8, inverse_l_1_times_first_x);
    let t17 = t16 * t15;
    let t18 = R::literal(1.0) / (-(t10 * t1)).sub_product(t8, t0).sub_product(t2
        * inverse_second_mass, t2).sub_product(t12, t4).sub_product(t17, t16);
    let t19 = (-(t13 * t4)).sub_product(t11, t2);
    let t20 = t19 * t18;
    let first_mass_times_first_gravity = p.first_mass * p.first_gravity;
    let second_mass_times_second_gravity = p.second_mass * p.second_gravity;
    let first_v_x_squared = first_v_x * first_v_x;
    let first_v_y_squared = first_v_y * first_v_y;
    let second_v_x_squared = second_v_x * second_v_x;
    let second_v_y_squared = second_v_y * second_v_y;
    let t21 = (-(inverse_l_1 * (first_v_x_squared + first_v_y_squared))).add_product(t9,
        first_mass_times_first_gravity);
    let t22 = (t10 * first_mass_times_first_gravity).add_product(inverse_l_2, (R::literal(2.0)
        * first_v_x * second_v_x).add_product(R::literal(2.0) * first_v_y, second_v_y)
        - first_v_x_squared - first_v_y_squared - second_v_x_squared - second_v_y_squared)
        .add_product(t12, second_mass_times_second_gravity).sub_product(t17, t21);
    let t23 = t22 * t18;
    let t24 = (t13 * second_mass_times_second_gravity).add_product(inverse_l_3,
        ((R::literal(2.0) * second_v_x * third_v_x).add_product(R::literal(2.0) * second_v_y,
        third_v_y) - second_v_x_squared - second_v_y_squared).sub_product(third_v_x, third_v_x)
        .sub_product(third_v_y, third_v_y)).add_product(t14, p.third_mass * p.third_gravity)
        .sub_product(t20, t22) * (R::literal(1.0) / (-(t13 * t5)).sub_product(t11, t3)
        .sub_product(t6 * inverse_third_mass, t6).sub_product(t14, t7).sub_product(t20, t19));
    let t25 = t20 * t24;
    let link_1 = (-(t21 * t15)).add_product(t17, t23 - t25);
    let link_2 = t25 - t23;
    let link_3 = -t24;
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

/// `dE/dt`, power supplied and power dissipated \[W\]. 171 operations.
#[must_use]
pub fn power_balance<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>) -> PowerBalance<R> {
    let [first_x, first_y, second_x, second_y, third_x, third_y, first_v_x, first_v_y, second_v_x,
        second_v_y, third_v_x, third_v_y] = *state;
    let inverse_l_1 = R::literal(1.0) / p.l_1;
    let inverse_l_1_times_first_x = inverse_l_1 * first_x;
    let inverse_l_2 = R::literal(1.0) / p.l_2;
    let t0 = inverse_l_2 * (first_x - second_x);
    let inverse_l_1_times_first_y = inverse_l_1 * first_y;
    let t1 = inverse_l_2 * (first_y - second_y);
    let t2 = inverse_l_2 * (second_x - first_x);
    let inverse_l_3 = R::literal(1.0) / p.l_3;
    let t3 = inverse_l_3 * (second_x - third_x);
    let t4 = inverse_l_2 * (second_y - first_y);
    let t5 = inverse_l_3 * (second_y - third_y);
    let t6 = inverse_l_3 * (third_x - second_x);
    let t7 = inverse_l_3 * (third_y - second_y);
    let inverse_first_mass = R::literal(1.0) / p.first_mass;
    let t8 = inverse_l_1_times_first_x * inverse_first_mass;
    let t9 = t0 * inverse_first_mass;
    let t10 = inverse_l_1_times_first_y * inverse_first_mass;
    let t11 = t1 * inverse_first_mass;
    let inverse_second_mass = R::literal(1.0) / p.second_mass;
    let t12 = t2 * inverse_second_mass;
    let t13 = t3 * inverse_second_mass;
    let t14 = t4 * inverse_second_mass;
    let t15 = t5 * inverse_second_mass;
    let inverse_third_mass = R::literal(1.0) / p.third_mass;
    let t16 = t6 * inverse_third_mass;
    let t17 = t7 * inverse_third_mass;
    let t18 = R::literal(1.0) / (-(t10 * inverse_l_1_times_first_y)).sub_product(t8,
        inverse_l_1_times_first_x);
    let t19 = (-(t11 * inverse_l_1_times_first_y)).sub_product(t9, inverse_l_1_times_first_x);
    let t20 = t19 * t18;
    let t21 = R::literal(1.0) / (-(t11 * t1)).sub_product(t9, t0).sub_product(t12, t2)
        .sub_product(t14, t4).sub_product(t20, t19);
    let t22 = (-(t15 * t4)).sub_product(t13, t2);
    let t23 = t22 * t21;
    let first_mass_times_first_gravity = p.first_mass * p.first_gravity;
    let second_mass_times_second_gravity = p.second_mass * p.second_gravity;
    let third_mass_times_third_gravity = p.third_mass * p.third_gravity;
    let first_v_x_squared = first_v_x * first_v_x;
    let first_v_y_squared = first_v_y * first_v_y;
    let second_v_x_squared = second_v_x * second_v_x;
    let second_v_y_squared = second_v_y * second_v_y;
    let t24 = (-(inverse_l_1 * (first_v_x_squared + first_v_y_squared))).add_product(t10,
        first_mass_times_first_gravity);
    let t25 = (t11 * first_mass_times_first_gravity).add_product(inverse_l_2, (R::literal(2.0)
        * first_v_x * second_v_x).add_product(R::literal(2.0) * first_v_y, second_v_y)
        - first_v_x_squared - first_v_y_squared - second_v_x_squared - second_v_y_squared)
        .add_product(t14, second_mass_times_second_gravity).sub_product(t20, t24);
    let t26 = (t15 * second_mass_times_second_gravity).add_product(inverse_l_3,
        ((R::literal(2.0) * second_v_x * third_v_x).add_product(R::literal(2.0) * second_v_y,
        third_v_y) - second_v_x_squared - second_v_y_squared).sub_product(third_v_x, third_v_x)
        .sub_product(third_v_y, third_v_y)).add_product(t17, third_mass_times_third_gravity)
        .sub_product(t23, t25) * (R::literal(1.0) / (-(t15 * t5)).sub_product(t13, t3)
        .sub_product(t16, t6).sub_product(t17, t7).sub_product(t23, t22));
    let t27 = (t25 * t21).sub_product(t23, t26);
    let t28 = (t24 * t18).sub_product(t20, t27);
    let third_v_y_dot = (-(third_mass_times_third_gravity * inverse_third_mass)).sub_product(t17,
        t26);
    let second_v_y_dot = (-(second_mass_times_second_gravity * inverse_second_mass))
        .sub_product(t14, t27).sub_product(t15, t26);
    let second_v_x_dot = (-(t13 * t26)).sub_product(t12, t27);
    let first_v_y_dot = (-(first_mass_times_first_gravity * inverse_first_mass)).sub_product(t10,
        t28).sub_product(t11, t27);
    let first_v_x_dot = (-(t9 * t27)).sub_product(t8, t28);
    PowerBalance {
        stored_rate: (first_mass_times_first_gravity * first_v_y)
            .add_product(second_mass_times_second_gravity, second_v_y)
            .add_product(third_mass_times_third_gravity, third_v_y).add_product(p.first_mass
            * first_v_x, first_v_x_dot).add_product(p.first_mass * first_v_y, first_v_y_dot)
            .add_product(p.second_mass * second_v_x, second_v_x_dot).add_product(p.second_mass
            * second_v_y, second_v_y_dot).sub_product(p.third_mass * third_v_x, t16 * t26)
            .add_product(p.third_mass * third_v_y, third_v_y_dot),
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
    let inverse_l_2 = R::literal(1.0) / p.l_2;
    let second_x_minus_first_x = second_x - first_x;
    let inverse_l_3 = R::literal(1.0) / p.l_3;
    let second_y_minus_first_y = second_y - first_y;
    let third_x_minus_second_x = third_x - second_x;
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

/// `G = dg'/dq'`, values in the order of its pattern. 21 operations.
#[must_use]
pub fn constraint_matrix<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>) -> [R; 10] {
    let [first_x, first_y, second_x, second_y, third_x, third_y, ..] = *state;
    let inverse_l_1 = R::literal(1.0) / p.l_1;
    let inverse_l_2 = R::literal(1.0) / p.l_2;
    let inverse_l_3 = R::literal(1.0) / p.l_3;
    [inverse_l_1 * first_x, inverse_l_1 * first_y, inverse_l_2 * (first_x - second_x),
        inverse_l_2 * (first_y - second_y), inverse_l_2 * (second_x - first_x),
        inverse_l_2 * (second_y - first_y), inverse_l_3 * (second_x - third_x),
        inverse_l_3 * (second_y - third_y), inverse_l_3 * (third_x - second_x),
        inverse_l_3 * (third_y - second_y)]
}

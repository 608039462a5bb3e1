// Emitted by Machinist 0.1.0; do not edit. To make it again:
//
//     cargo run --release -- gen
//
// Sources, with SHA-256:
//   d2c75a90dbcb8c06281a8cefccfd565b2e1085edd377fb79777746de2b897e53  scenes/four_bar.toml
//   b4594591158f68ce8c9070674fa9b2138edb31e0a5645bf03c9d1c4965420587  units/planar_body.toml
//
// Four-bar linkage under gravity
//
// Crank, coupler and rocker pinned to one another and to the frame. Let go near the crank's
// upper position with a push, the crank turns over and over; nothing brakes it.
//
// Source:
//   Textbook; Freudenstein's equation.
//
// All quantities are in SI units.
// Shapes: coordinates 9, states 18, parameters 15, outputs 6, constraints 8.
// Nonzeros: mass_matrix 9 of 9 by 9, rate_jacobian 63 of 18 by 18,
//     parameter_jacobian 108 of 18 by 15, constraint_matrix 24 of 8 by 9.
// Operations: rate 290, forcing 6, rate_jacobian 907, parameter_jacobian 1521, outputs 246,
//     energy 37, power_balance 319, constraint_values 32, constraint_rates 34, constraint_matrix 19,
//     prepare 18, prepared_rate 275, prepared_rate_jacobian 892, prepared_parameter_jacobian 1503.

use ::machinist_contract::{Energy, PowerBalance, Real};

::machinist_contract::simulator! {
    /// Four-bar linkage under gravity
    ///
    /// Crank, coupler and rocker pinned to one another and to the frame. Let go near the crank's
    /// upper position with a push, the crank turns over and over; nothing brakes it.
    ///
    /// Source: Textbook; Freudenstein's equation.
    FourBar: "four_bar", "Four-bar linkage under gravity";
    run from 0.0, until 2.0, points 2001, rtol 1e-8, method "dop853";
    quadratures 0, discontinuities 0;
    constraints; prepared;
}

::machinist_contract::parameters! {
    base: 0.22, "m", "base", "distance of the two pins in the frame";
    angle: 1.5, "rad", "angle", "angle of the crank at the start";
    speed: 25.0, "rad/s", "speed", "speed of the crank at the start";
    crank_length: 0.1, "m", "crank.length", "length of the bar";
    crank_mass: 0.5, "kg", "crank.mass", "the mass";
    crank_inertia: 0.00045, "kg m^2", "crank.inertia", "moment of inertia about the centre of mass";
    crank_gravity: 9.81, "m/s^2", "crank.gravity", "acceleration of free fall";
    coupler_length: 0.25, "m", "coupler.length", "length of the bar";
    coupler_mass: 0.9, "kg", "coupler.mass", "the mass";
    coupler_inertia: 0.0047, "kg m^2", "coupler.inertia", "moment of inertia about the centre of mass";
    coupler_gravity: 9.81, "m/s^2", "coupler.gravity", "acceleration of free fall";
    rocker_length: 0.2, "m", "rocker.length", "length of the bar";
    rocker_mass: 0.7, "kg", "rocker.mass", "the mass";
    rocker_inertia: 0.0024, "kg m^2", "rocker.inertia", "moment of inertia about the centre of mass";
    rocker_gravity: 9.81, "m/s^2", "rocker.gravity", "acceleration of free fall";
}

::machinist_contract::outputs! {
    crank_angle: "rad", "crank_angle", "angle of the bar from sideways";
    coupler_angle: "rad", "coupler_angle", "angle of the bar from sideways";
    rocker_angle: "rad", "rocker_angle", "angle of the bar from sideways";
    crank_speed: "rad/s", "crank_speed", "rate of angle of the bar from sideways";
    pin_force_x: "N", "pin_force_x", "force of the frame on the crank, sideways";
    pin_force_y: "N", "pin_force_y", "force of the frame on the crank, upwards";
}

::machinist_contract::states! {
    CRANK_X: position guess, 0.1, "m", "crank.x", "centre of mass, sideways";
    CRANK_Y: position guess, 0.1, "m", "crank.y", "centre of mass, upwards";
    CRANK_PHI: position, 1.0, "rad", "crank.phi", "angle of the bar from sideways";
    COUPLER_X: position guess, 0.1, "m", "coupler.x", "centre of mass, sideways";
    COUPLER_Y: position guess, 0.1, "m", "coupler.y", "centre of mass, upwards";
    COUPLER_PHI: position guess, 1.0, "rad", "coupler.phi", "angle of the bar from sideways";
    ROCKER_X: position guess, 0.1, "m", "rocker.x", "centre of mass, sideways";
    ROCKER_Y: position guess, 0.1, "m", "rocker.y", "centre of mass, upwards";
    ROCKER_PHI: position guess, 1.0, "rad", "rocker.phi", "angle of the bar from sideways";
    CRANK_V_X: velocity guess, 1.0, "m/s", "crank.v_x", "rate of centre of mass, sideways";
    CRANK_V_Y: velocity guess, 1.0, "m/s", "crank.v_y", "rate of centre of mass, upwards";
    CRANK_OMEGA: velocity, 10.0, "rad/s", "crank.omega", "rate of angle of the bar from sideways";
    COUPLER_V_X: velocity guess, 1.0, "m/s", "coupler.v_x", "rate of centre of mass, sideways";
    COUPLER_V_Y: velocity guess, 1.0, "m/s", "coupler.v_y", "rate of centre of mass, upwards";
    COUPLER_OMEGA: velocity guess, 10.0, "rad/s", "coupler.omega", "rate of angle of the bar from sideways";
    ROCKER_V_X: velocity guess, 1.0, "m/s", "rocker.v_x", "rate of centre of mass, sideways";
    ROCKER_V_Y: velocity guess, 1.0, "m/s", "rocker.v_y", "rate of centre of mass, upwards";
    ROCKER_OMEGA: velocity guess, 10.0, "rad/s", "rocker.omega", "rate of angle of the bar from sideways";
}

::machinist_contract::constraints! {
    "pin_o_x": of_positions, "m", "the crank's pin in the frame, sideways";
    "pin_o_y": of_positions, "m", "the crank's pin in the frame, upwards";
    "pin_a_x": of_positions, "m", "pin between crank and coupler, sideways";
    "pin_a_y": of_positions, "m", "pin between crank and coupler, upwards";
    "pin_b_x": of_positions, "m", "pin between coupler and rocker, sideways";
    "pin_b_y": of_positions, "m", "pin between coupler and rocker, upwards";
    "pin_c_x": of_positions, "m", "the rocker's pin in the frame, sideways";
    "pin_c_y": of_positions, "m", "the rocker's pin in the frame, upwards";
}

::machinist_contract::patterns! {
    /// Nonzeros of M.
    MASS_MATRIX_PATTERN: 9 by 9 { 0 [0] 1 [1] 2 [2] 3 [3] 4 [4] 5 [5] 6 [6] 7 [7] 8 [8] }
    /// Nonzeros of dy'/dy.
    RATE_JACOBIAN_PATTERN: 18 by 18 { 0 [9] 1 [10] 2 [11] 3 [12] 4 [13] 5 [14] 6 [15] 7 [16] 8 [17]
        9 [2 5 8 11 14 17] 10 [2 5 8 11 14 17] 11 [2 5 8 11 14 17] 12 [2 5 8 11 14 17]
        13 [2 5 8 11 14 17] 14 [2 5 8 11 14 17] 15 [2 5 8 11 14 17] 16 [2 5 8 11 14 17]
        17 [2 5 8 11 14 17] }
    /// Nonzeros of dy'/dp.
    PARAMETER_JACOBIAN_PATTERN: 18 by 15 { 9 [3 4 5 6 7 8 9 10 11 12 13 14]
        10 [3 4 5 6 7 8 9 10 11 12 13 14] 11 [3 4 5 6 7 8 9 10 11 12 13 14]
        12 [3 4 5 6 7 8 9 10 11 12 13 14] 13 [3 4 5 6 7 8 9 10 11 12 13 14]
        14 [3 4 5 6 7 8 9 10 11 12 13 14] 15 [3 4 5 6 7 8 9 10 11 12 13 14]
        16 [3 4 5 6 7 8 9 10 11 12 13 14] 17 [3 4 5 6 7 8 9 10 11 12 13 14] }
    /// Nonzeros of G = dg'/dq'.
    CONSTRAINT_MATRIX_PATTERN: 8 by 9 { 0 [0 2] 1 [1 2] 2 [0 2 3 5] 3 [1 2 4 5] 4 [3 5 6 8]
        5 [4 5 7 8] 6 [6 8] 7 [7 8] }
}

::machinist_contract::constants! {
    t0, t1, t2, inverse_crank_mass, inverse_crank_inertia, inverse_coupler_mass,
    inverse_coupler_inertia, inverse_rocker_mass, inverse_rocker_inertia, t3, t4, t5,
    inverse_crank_mass_times_crank_mass, t6, t7
}

/// What `rate` and its Jacobians need of the parameters, once a run. 18 operations.
#[must_use]
#[inline]
pub fn prepare<R: Real>(p: &Parameters<R>) -> Constants<R> {
    let t0 = R::literal(0.5) * p.crank_length;
    let t1 = R::literal(0.5) * p.coupler_length;
    let t2 = R::literal(0.5) * p.rocker_length;
    let inverse_crank_mass = R::literal(1.0) / p.crank_mass;
    let inverse_crank_inertia = R::literal(1.0) / p.crank_inertia;
    let inverse_coupler_mass = R::literal(1.0) / p.coupler_mass;
    let inverse_coupler_inertia = R::literal(1.0) / p.coupler_inertia;
    let inverse_rocker_mass = R::literal(1.0) / p.rocker_mass;
    let inverse_rocker_inertia = R::literal(1.0) / p.rocker_inertia;
    let t3 = inverse_crank_mass * (p.crank_mass * p.crank_gravity);
    let t4 = inverse_coupler_mass * (p.coupler_mass * p.coupler_gravity);
    let t5 = inverse_rocker_mass * (p.rocker_mass * p.rocker_gravity);
    let inverse_crank_mass_times_crank_mass = inverse_crank_mass * p.crank_mass;
    let t6 = inverse_coupler_mass * p.coupler_mass;
    let t7 = inverse_rocker_mass * p.rocker_mass;
    Constants { t0, t1, t2, inverse_crank_mass, inverse_crank_inertia, inverse_coupler_mass,
        inverse_coupler_inertia, inverse_rocker_mass, inverse_rocker_inertia, t3, t4, t5,
        inverse_crank_mass_times_crank_mass, t6, t7 }
}

/// State at the start of the run, in the units of the states. No operations.
#[must_use]
pub fn initial_state<R: Real>(p: &Parameters<R>) -> [R; STATES] {
    [R::literal(0.0), R::literal(0.0), p.angle, R::literal(0.1), R::literal(0.15), R::literal(0.5),
        R::literal(0.23), R::literal(0.1), R::literal(1.3), R::literal(0.0), R::literal(0.0),
        p.speed, R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0),
        R::literal(0.0), R::literal(0.0)]
}

/// Times of known jumps of the right-hand side \[s\], unsorted. No operations.
#[must_use]
pub fn discontinuities<R: Real>(_p: &Parameters<R>) -> [R; DISCONTINUITIES] {
    []
}

/// As `rate`, with the constants of the parameters from `prepare`. 275 operations.
#[must_use]
#[inline]
pub fn prepared_rate<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>,
        c: &Constants<R>) -> [R; STATES] {
    let [_, _, crank_phi, _, _, coupler_phi, _, _, rocker_phi, crank_v_x, crank_v_y, crank_omega,
        coupler_v_x, coupler_v_y, coupler_omega, rocker_v_x, rocker_v_y, rocker_omega] = *state;
    let [(sin_crank_phi, cos_crank_phi), (sin_coupler_phi, cos_coupler_phi), (sin_rocker_phi,
        cos_rocker_phi)] = R::sin_cos_each([crank_phi, coupler_phi, rocker_phi]);
    let t0 = c.t0 * cos_crank_phi;
    let t1 = c.t0 * sin_crank_phi;
    let t2 = c.t1 * cos_coupler_phi;
    let t3 = c.t1 * sin_coupler_phi;
    let t4 = c.t2 * cos_rocker_phi;
    let t5 = c.t2 * sin_rocker_phi;
    let t6 = t1 * c.inverse_crank_inertia;
    let t7 = t0 * c.inverse_crank_inertia;
    let t8 = t3 * c.inverse_coupler_inertia;
    let t9 = t2 * c.inverse_coupler_inertia;
    let t10 = t5 * c.inverse_rocker_inertia;
    let t11 = t4 * c.inverse_rocker_inertia;
    let t12 = t6 * t1;
    let t13 = c.inverse_crank_mass + t12;
    let t14 = R::literal(1.0) / t13;
    let t15 = t7 * t1;
    let t16 = t15 * t14;
    let t17 = c.inverse_crank_mass - t12;
    let t18 = t17 * t14;
    let t19 = t7 * t0;
    let t20 = c.inverse_crank_mass + t19;
    let t21 = t16 * t15;
    let t22 = R::literal(1.0) / (t21 - t20);
    let t23 = (t6 * t0).add_product(t18, t15);
    let t24 = t23 * t22;
    let t25 = c.inverse_crank_mass - t19 + t21;
    let t26 = t25 * t22;
    let t27 = t8 * t3;
    let t28 = R::literal(1.0) / (-(t13 + c.inverse_coupler_mass + t27)).add_product(t18, t17)
        .sub_product(t24, t23);
    let t29 = t9 * t3;
    let t30 = (t15 + t29).add_product(t16, t17).sub_product(t26, t23);
    let t31 = t30 * t28;
    let t32 = c.inverse_coupler_mass - t27;
    let t33 = t32 * t28;
    let t34 = t29 * t28;
    let t35 = t9 * t2;
    let t36 = R::literal(1.0) / (t21 - (t20 + c.inverse_coupler_mass + t35)).sub_product(t26, t25)
        .sub_product(t31, t30);
    let t37 = (t8 * t2).sub_product(t33, t30);
    let t38 = t37 * t36;
    let t39 = (c.inverse_coupler_mass - t35).sub_product(t34, t30);
    let t40 = t39 * t36;
    let t41 = t10 * t5;
    let t42 = R::literal(1.0) / (c.inverse_coupler_mass + t27 + c.inverse_rocker_mass + t41)
        .add_product(t33, t32).add_product(t38, t37);
    let t43 = t11 * t5;
    let t44 = (t29 + t43).sub_product(t34, t32).sub_product(t40, t37);
    let t45 = t44 * t42;
    let t46 = t41 - c.inverse_rocker_mass;
    let t47 = t46 * t42;
    let t48 = t43 * t42;
    let t49 = t11 * t4;
    let t50 = R::literal(1.0) / (-(c.inverse_coupler_mass + t35 + c.inverse_rocker_mass + t49)
        .add_product(t34, t29).add_product(t40, t39)).add_product(t45, t44);
    let t51 = (-(t10 * t4)).add_product(t47, t44);
    let t52 = t51 * t50;
    let t53 = (t49 - c.inverse_rocker_mass).sub_product(t48, t44);
    let t54 = t53 * t50;
    let t55 = R::literal(1.0) / (-(c.inverse_rocker_mass + t41)).add_product(t47, t46)
        .sub_product(t52, t51);
    let t56 = t43.sub_product(t48, t46).sub_product(t54, t51);
    let t57 = t56 * t55;
    let crank_omega_squared = crank_omega * crank_omega;
    let t58 = c.t0 * crank_omega_squared;
    let t59 = t58 * cos_crank_phi;
    let t60 = p.crank_length * crank_omega_squared;
    let coupler_omega_squared = coupler_omega * coupler_omega;
    let t61 = p.coupler_length * coupler_omega_squared;
    let t62 = c.t2 * (rocker_omega * rocker_omega);
    let t63 = t62 * cos_rocker_phi;
    let t64 = c.t1 * coupler_omega_squared;
    let t65 = t62 * sin_rocker_phi;
    let t66 = t16 * t59;
    let t67 = c.t3.sub_product(t58, sin_crank_phi) - t66;
    let t68 = (R::literal(0.5) * (t60 * cos_crank_phi).add_product(t61, cos_coupler_phi))
        .add_product(t18, t59).add_product(t24, t67);
    let t69 = (c.t4 - c.t3.add_product(R::literal(0.5), (t60 * sin_crank_phi).add_product(t61,
        sin_coupler_phi)) - t66).sub_product(t26, t67).add_product(t31, t68);
    let t70 = t63.sub_product(t64, cos_coupler_phi).add_product(t33, t68).sub_product(t38, t69);
    let t71 = (t65.sub_product(t64, sin_coupler_phi) - c.t4 + c.t5).add_product(t34, t68)
        .sub_product(t40, t69).add_product(t45, t70);
    let t72 = (-t63).add_product(t47, t70).sub_product(t52, t71);
    let t73 = (c.t5 - t65).sub_product(t48, t70).sub_product(t54, t71).sub_product(t57, t72)
        * (R::literal(1.0) / (-(c.inverse_rocker_mass + t49)).add_product(t48, t43)
        .sub_product(t54, t53).sub_product(t57, t56));
    let t74 = (t72 * t55).sub_product(t57, t73);
    let t75 = (t71 * t50).sub_product(t52, t74).sub_product(t54, t73);
    let t76 = (-(t70 * t42)).add_product(t45, t75).add_product(t47, t74).sub_product(t48, t73);
    let t77 = (t69 * t36).sub_product(t38, t76).sub_product(t40, t75);
    let pin_a_x = (t68 * t28).add_product(t31, t77).add_product(t33, t76).add_product(t34, t75);
    let t78 = (t67 * t22).add_product(t24, pin_a_x).sub_product(t26, t77);
    let t79 = (t59 * t14).add_product(t16, t78).sub_product(t18, pin_a_x).add_product(t16, t77);
    let rocker_omega_dot = (-(t11 * t75)).add_product(t10, t76).sub_product(t10, t74)
        .add_product(t11, t73);
    let rocker_v_y_dot = -c.t5.add_product(c.inverse_rocker_mass, t75)
        .add_product(c.inverse_rocker_mass, t73);
    let rocker_v_x_dot = -(c.inverse_rocker_mass * t74).add_product(c.inverse_rocker_mass, t76);
    let coupler_omega_dot = (t9 * t77).add_product(t8, pin_a_x).sub_product(t8, t76)
        .add_product(t9, t75);
    let coupler_v_y_dot = (-c.t4.add_product(c.inverse_coupler_mass, t77))
        .add_product(c.inverse_coupler_mass, t75);
    let coupler_v_x_dot = (c.inverse_coupler_mass * t76).add_product(c.inverse_coupler_mass,
        pin_a_x);
    let crank_omega_dot = (t7 * t78).sub_product(t6, t79).add_product(t6, pin_a_x).add_product(t7,
        t77);
    let crank_v_y_dot = (-c.t3.add_product(c.inverse_crank_mass, t78))
        .add_product(c.inverse_crank_mass, t77);
    let crank_v_x_dot = -(c.inverse_crank_mass * pin_a_x).add_product(c.inverse_crank_mass, t79);
    [crank_v_x, crank_v_y, crank_omega, coupler_v_x, coupler_v_y, coupler_omega, rocker_v_x,
        rocker_v_y, rocker_omega, crank_v_x_dot, crank_v_y_dot, crank_omega_dot, coupler_v_x_dot,
        coupler_v_y_dot, coupler_omega_dot, rocker_v_x_dot, rocker_v_y_dot, rocker_omega_dot]
}

/// `M = d2L/dq'2`, values in the order of its pattern. No operations.
#[must_use]
pub fn mass_matrix<R: Real>(_time: R, _state: &[R; STATES], p: &Parameters<R>) -> [R; 9] {
    [p.crank_mass, p.crank_mass, p.crank_inertia, p.coupler_mass, p.coupler_mass,
        p.coupler_inertia, p.rocker_mass, p.rocker_mass, p.rocker_inertia]
}

/// `f` of `M q'' = f + G^T lambda`, one for each coordinate. 6 operations.
#[must_use]
pub fn forcing<R: Real>(_time: R, _state: &[R; STATES], p: &Parameters<R>) -> [R; COORDINATES] {
    let crank_y_forcing = -(p.crank_mass * p.crank_gravity);
    let coupler_y_forcing = -(p.coupler_mass * p.coupler_gravity);
    let rocker_y_forcing = -(p.rocker_mass * p.rocker_gravity);
    [R::literal(0.0), crank_y_forcing, R::literal(0.0), R::literal(0.0), coupler_y_forcing,
        R::literal(0.0), R::literal(0.0), rocker_y_forcing, R::literal(0.0)]
}

/// As `rate_jacobian`, with the constants of the parameters from `prepare`. 892 operations.
#[must_use]
pub fn prepared_rate_jacobian<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>,
        c: &Constants<R>) -> [R; 63] {
    let [_, _, crank_phi, _, _, coupler_phi, _, _, rocker_phi, _, _, crank_omega, _, _,
        coupler_omega, _, _, rocker_omega] = *state;
    let [(sin_crank_phi, cos_crank_phi), (sin_coupler_phi, cos_coupler_phi), (sin_rocker_phi,
        cos_rocker_phi)] = R::sin_cos_each([crank_phi, coupler_phi, rocker_phi]);
    let t0 = c.t0 * cos_crank_phi;
    let t1 = c.t0 * sin_crank_phi;
    let t2 = c.t1 * cos_coupler_phi;
    let t3 = c.t1 * sin_coupler_phi;
    let t4 = c.t2 * cos_rocker_phi;
    let t5 = c.t2 * sin_rocker_phi;
    let t6 = t1 * c.inverse_crank_inertia;
    let t7 = t0 * c.inverse_crank_inertia;
    let t8 = t3 * c.inverse_coupler_inertia;
    let t9 = t2 * c.inverse_coupler_inertia;
    let t10 = t5 * c.inverse_rocker_inertia;
    let t11 = t4 * c.inverse_rocker_inertia;
    let t12 = t6 * t1;
    let t13 = c.inverse_crank_mass + t12;
    let t14 = R::literal(1.0) / t13;
    let t15 = t7 * t1;
    let t16 = t15 * t14;
    let t17 = c.inverse_crank_mass - t12;
    let t18 = t17 * t14;
    let t19 = t7 * t0;
    let t20 = c.inverse_crank_mass + t19;
    let t21 = t16 * t15;
    let t22 = R::literal(1.0) / (t21 - t20);
    let t23 = (t6 * t0).add_product(t18, t15);
    let t24 = t23 * t22;
    let t25 = c.inverse_crank_mass - t19 + t21;
    let t26 = t25 * t22;
    let t27 = t8 * t3;
    let t28 = R::literal(1.0) / (-(t13 + c.inverse_coupler_mass + t27)).add_product(t18, t17)
        .sub_product(t24, t23);
    let t29 = t9 * t3;
    let t30 = (t15 + t29).add_product(t16, t17).sub_product(t26, t23);
    let t31 = t30 * t28;
    let t32 = c.inverse_coupler_mass - t27;
    let t33 = t32 * t28;
    let t34 = t29 * t28;
    let t35 = t9 * t2;
    let t36 = R::literal(1.0) / (t21 - (t20 + c.inverse_coupler_mass + t35)).sub_product(t26, t25)
        .sub_product(t31, t30);
    let t37 = (t8 * t2).sub_product(t33, t30);
    let t38 = t37 * t36;
    let t39 = (c.inverse_coupler_mass - t35).sub_product(t34, t30);
    let t40 = t39 * t36;
    let t41 = t10 * t5;
    let t42 = R::literal(1.0) / (c.inverse_coupler_mass + t27 + c.inverse_rocker_mass + t41)
        .add_product(t33, t32).add_product(t38, t37);
    let t43 = t11 * t5;
    let t44 = (t29 + t43).sub_product(t34, t32).sub_product(t40, t37);
    let t45 = t44 * t42;
    let t46 = t41 - c.inverse_rocker_mass;
    let t47 = t46 * t42;
    let t48 = t43 * t42;
    let t49 = t11 * t4;
    let t50 = R::literal(1.0) / (-(c.inverse_coupler_mass + t35 + c.inverse_rocker_mass + t49)
        .add_product(t34, t29).add_product(t40, t39)).add_product(t45, t44);
    let t51 = (-(t10 * t4)).add_product(t47, t44);
    let t52 = t51 * t50;
    let t53 = (t49 - c.inverse_rocker_mass).sub_product(t48, t44);
    let t54 = t53 * t50;
    let t55 = R::literal(1.0) / (-(c.inverse_rocker_mass + t41)).add_product(t47, t46)
        .sub_product(t52, t51);
    let t56 = t43.sub_product(t48, t46).sub_product(t54, t51);
    let t57 = t56 * t55;
    let t58 = R::literal(1.0) / (-(c.inverse_rocker_mass + t49)).add_product(t48, t43)
        .sub_product(t54, t53).sub_product(t57, t56);
    let crank_omega_squared = crank_omega * crank_omega;
    let t59 = c.t0 * crank_omega_squared;
    let t60 = t59 * cos_crank_phi;
    let t61 = t59 * sin_crank_phi;
    let t62 = p.crank_length * crank_omega_squared;
    let coupler_omega_squared = coupler_omega * coupler_omega;
    let t63 = p.coupler_length * coupler_omega_squared;
    let t64 = c.t2 * (rocker_omega * rocker_omega);
    let t65 = t64 * cos_rocker_phi;
    let t66 = c.t1 * coupler_omega_squared;
    let t67 = t66 * cos_coupler_phi;
    let t68 = t64 * sin_rocker_phi;
    let t69 = t66 * sin_coupler_phi;
    let t70 = t16 * t60;
    let t71 = c.t3 - t61 - t70;
    let t72 = (R::literal(0.5) * (t62 * cos_crank_phi).add_product(t63, cos_coupler_phi))
        .add_product(t18, t60).add_product(t24, t71);
    let t73 = (c.t4 - c.t3.add_product(R::literal(0.5), (t62 * sin_crank_phi).add_product(t63,
        sin_coupler_phi)) - t70).sub_product(t26, t71).add_product(t31, t72);
    let t74 = (t65 - t67).add_product(t33, t72).sub_product(t38, t73);
    let t75 = (t68 - t69 - c.t4 + c.t5).add_product(t34, t72).sub_product(t40, t73)
        .add_product(t45, t74);
    let t76 = (-t65).add_product(t47, t74).sub_product(t52, t75);
    let t77 = (c.t5 - t68).sub_product(t48, t74).sub_product(t54, t75).sub_product(t57, t76) * t58;
    let t78 = (t76 * t55).sub_product(t57, t77);
    let t79 = (t75 * t50).sub_product(t52, t78).sub_product(t54, t77);
    let t80 = (-(t74 * t42)).add_product(t45, t79).add_product(t47, t78).sub_product(t48, t77);
    let t81 = (t73 * t36).sub_product(t38, t80).sub_product(t40, t79);
    let pin_a_x = (t72 * t28).add_product(t31, t81).add_product(t33, t80).add_product(t34, t79);
    let t82 = (t71 * t22).add_product(t24, pin_a_x).sub_product(t26, t81);
    let t83 = (t60 * t14).add_product(t16, t82).sub_product(t18, pin_a_x).add_product(t16, t81);
    let rocker_omega_dot = (-(t11 * t79)).add_product(t10, t80).sub_product(t10, t78)
        .add_product(t11, t77);
    let coupler_omega_dot = (t9 * t81).add_product(t8, pin_a_x).sub_product(t8, t80)
        .add_product(t9, t79);
    let crank_omega_dot = (t7 * t82).sub_product(t6, t83).add_product(t6, pin_a_x).add_product(t7,
        t81);
    let t84 = (-(t1 * t82).add_product(t0, t83)).add_product(t0, pin_a_x).sub_product(t1, t81);
    let t85 = t61.sub_product(t0, crank_omega_dot).sub_product(t6, t84);
    let t86 = (-t60.add_product(t1, crank_omega_dot)).add_product(t7, t84).add_product(t16, t85);
    let t87 = t85.add_product(t18, t85).sub_product(t24, t86);
    let t88 = t86.sub_product(t26, t86).sub_product(t31, t87);
    let t89 = (t33 * t87).add_product(t38, t88);
    let t90 = (t34 * t87).add_product(t40, t88).add_product(t45, t89);
    let t91 = (-(t47 * t89)).add_product(t52, t90);
    let t92 = (t48 * t89).add_product(t54, t90).sub_product(t57, t91) * t58;
    let t93 = (t91 * t55).sub_product(t57, t92);
    let t94 = (t90 * t50).add_product(t52, t93).add_product(t54, t92);
    let t95 = (t89 * t42).sub_product(t45, t94).add_product(t47, t93).sub_product(t48, t92);
    let t96 = (t88 * t36).sub_product(t38, t95).add_product(t40, t94);
    let t97 = (t87 * t28).sub_product(t31, t96).sub_product(t33, t95).add_product(t34, t94);
    let t98 = (t86 * t22).sub_product(t24, t97).sub_product(t26, t96);
    let t99 = (-(t85 * t14)).add_product(t16, t98).add_product(t18, t97).add_product(t16, t96);
    let rocker_omega_dot_by_crank_phi = (t11 * t94).add_product(t10, t95).sub_product(t10, t93)
        .add_product(t11, t92);
    let rocker_v_y_dot_by_crank_phi = (-(c.inverse_rocker_mass * t92))
        .add_product(c.inverse_rocker_mass, t94);
    let rocker_v_x_dot_by_crank_phi = -(c.inverse_rocker_mass * t93)
        .add_product(c.inverse_rocker_mass, t95);
    let coupler_omega_dot_by_crank_phi = (t9 * t96).sub_product(t8, t97).sub_product(t8, t95)
        .sub_product(t9, t94);
    let coupler_v_y_dot_by_crank_phi = -(c.inverse_coupler_mass * t94)
        .add_product(c.inverse_coupler_mass, t96);
    let coupler_v_x_dot_by_crank_phi = (c.inverse_coupler_mass * t95)
        .sub_product(c.inverse_coupler_mass, t97);
    let crank_omega_dot_by_crank_phi = (t84 * c.inverse_crank_inertia).sub_product(t6, t99)
        .add_product(t7, t98).sub_product(t6, t97).add_product(t7, t96);
    let crank_v_y_dot_by_crank_phi = (c.inverse_crank_mass * t96).sub_product(c.inverse_crank_mass,
        t98);
    let crank_v_x_dot_by_crank_phi = (c.inverse_crank_mass * t97).sub_product(c.inverse_crank_mass,
        t99);
    let t100 = (-(t3 * t81)).add_product(t2, pin_a_x).sub_product(t2, t80).sub_product(t3, t79);
    let t101 = t69.sub_product(t2, coupler_omega_dot).sub_product(t8, t100);
    let t102 = (-t67.add_product(t3, coupler_omega_dot)).add_product(t9, t100);
    let t103 = t102.sub_product(t31, t101);
    let t104 = t101.sub_product(t33, t101).sub_product(t38, t103);
    let t105 = t102.sub_product(t34, t101).sub_product(t40, t103).add_product(t45, t104);
    let t106 = (t47 * t104).sub_product(t52, t105);
    let t107 = (t48 * t104).add_product(t54, t105).add_product(t57, t106) * t58;
    let t108 = (t106 * t55).add_product(t57, t107);
    let t109 = (t105 * t50).sub_product(t52, t108).add_product(t54, t107);
    let t110 = (-(t104 * t42)).add_product(t45, t109).add_product(t47, t108).add_product(t48, t107);
    let t111 = (t103 * t36).sub_product(t38, t110).sub_product(t40, t109);
    let t112 = (t101 * t28).sub_product(t31, t111).sub_product(t33, t110).sub_product(t34, t109);
    let t113 = (t26 * t111).add_product(t24, t112);
    let t114 = (t18 * t112).sub_product(t16, t113).add_product(t16, t111);
    let rocker_omega_dot_by_coupler_phi = (-(t11 * t109)).add_product(t10, t110).sub_product(t10,
        t108).sub_product(t11, t107);
    let rocker_v_y_dot_by_coupler_phi = (c.inverse_rocker_mass * t107)
        .sub_product(c.inverse_rocker_mass, t109);
    let rocker_v_x_dot_by_coupler_phi = -(c.inverse_rocker_mass * t108)
        .add_product(c.inverse_rocker_mass, t110);
    let coupler_omega_dot_by_coupler_phi = (t100 * c.inverse_coupler_inertia).sub_product(t8, t112)
        .add_product(t9, t111).sub_product(t8, t110).add_product(t9, t109);
    let coupler_v_y_dot_by_coupler_phi = (c.inverse_coupler_mass * t109)
        .sub_product(c.inverse_coupler_mass, t111);
    let coupler_v_x_dot_by_coupler_phi = (c.inverse_coupler_mass * t110)
        .sub_product(c.inverse_coupler_mass, t112);
    let crank_omega_dot_by_coupler_phi = (-(t7 * t113).add_product(t6, t114).add_product(t6, t112))
        .add_product(t7, t111);
    let crank_v_y_dot_by_coupler_phi = (c.inverse_crank_mass * t111)
        .add_product(c.inverse_crank_mass, t113);
    let crank_v_x_dot_by_coupler_phi = (c.inverse_crank_mass * t112)
        .sub_product(c.inverse_crank_mass, t114);
    let t115 = t4 * rocker_omega_dot;
    let t116 = t65.add_product(t5, rocker_omega_dot);
    let t117 = (t5 * t79).add_product(t4, t80).sub_product(t4, t78).sub_product(t5, t77);
    let t118 = t10 * t117;
    let t119 = t115 - t68 + t118;
    let t120 = t11 * t117;
    let t121 = (t116 - t120).add_product(t45, t119);
    let t122 = (t68 - t115 - t118).add_product(t47, t119).sub_product(t52, t121);
    let t123 = (t120 - t116).sub_product(t48, t119).sub_product(t54, t121).sub_product(t57, t122)
        * t58;
    let t124 = (t122 * t55).sub_product(t57, t123);
    let t125 = (t121 * t50).sub_product(t52, t124).sub_product(t54, t123);
    let t126 = (-(t119 * t42)).add_product(t45, t125).add_product(t47, t124).sub_product(t48, t123);
    let t127 = (t40 * t125).add_product(t38, t126);
    let t128 = (-(t33 * t126)).add_product(t31, t127).sub_product(t34, t125);
    let t129 = (t26 * t127).sub_product(t24, t128);
    let t130 = (t18 * t128).add_product(t16, t129).sub_product(t16, t127);
    let rocker_omega_dot_by_rocker_phi = (t117 * c.inverse_rocker_inertia).add_product(t10, t126)
        .sub_product(t11, t125).sub_product(t10, t124).add_product(t11, t123);
    let rocker_v_y_dot_by_rocker_phi = -(c.inverse_rocker_mass * t123)
        .add_product(c.inverse_rocker_mass, t125);
    let rocker_v_x_dot_by_rocker_phi = -(c.inverse_rocker_mass * t124)
        .add_product(c.inverse_rocker_mass, t126);
    let coupler_omega_dot_by_rocker_phi = (-(t9 * t127).add_product(t8, t128).add_product(t8, t126))
        .add_product(t9, t125);
    let coupler_v_y_dot_by_rocker_phi = (c.inverse_coupler_mass * t125)
        .add_product(c.inverse_coupler_mass, t127);
    let coupler_v_x_dot_by_rocker_phi = (c.inverse_coupler_mass * t126)
        .sub_product(c.inverse_coupler_mass, t128);
    let crank_omega_dot_by_rocker_phi = (t7 * t129).sub_product(t6, t130).sub_product(t6, t128)
        .sub_product(t7, t127);
    let crank_v_y_dot_by_rocker_phi = -(c.inverse_crank_mass * t127)
        .add_product(c.inverse_crank_mass, t129);
    let crank_v_x_dot_by_rocker_phi = (c.inverse_crank_mass * t128)
        .sub_product(c.inverse_crank_mass, t130);
    let crank_length_times_crank_omega = p.crank_length * crank_omega;
    let t131 = crank_length_times_crank_omega * cos_crank_phi;
    let t132 = (crank_length_times_crank_omega * sin_crank_phi).add_product(t16, t131);
    let t133 = (-t131.add_product(t18, t131)).add_product(t24, t132);
    let t134 = (-t132).add_product(t26, t132).sub_product(t31, t133);
    let t135 = (t33 * t133).add_product(t38, t134);
    let t136 = (t34 * t133).add_product(t40, t134).add_product(t45, t135);
    let t137 = (-(t47 * t135)).add_product(t52, t136);
    let t138 = (t48 * t135).add_product(t54, t136).sub_product(t57, t137) * t58;
    let t139 = (t137 * t55).sub_product(t57, t138);
    let t140 = (t136 * t50).add_product(t52, t139).add_product(t54, t138);
    let t141 = (t135 * t42).sub_product(t45, t140).add_product(t47, t139).sub_product(t48, t138);
    let t142 = (t134 * t36).sub_product(t38, t141).add_product(t40, t140);
    let t143 = (t133 * t28).sub_product(t31, t142).sub_product(t33, t141).add_product(t34, t140);
    let t144 = (t132 * t22).add_product(t24, t143).add_product(t26, t142);
    let t145 = (t131 * t14).sub_product(t16, t144).add_product(t18, t143).add_product(t16, t142);
    let rocker_omega_dot_by_crank_omega = (t11 * t140).add_product(t10, t141).sub_product(t10, t139)
        .add_product(t11, t138);
    let rocker_v_y_dot_by_crank_omega = (-(c.inverse_rocker_mass * t138))
        .add_product(c.inverse_rocker_mass, t140);
    let rocker_v_x_dot_by_crank_omega = -(c.inverse_rocker_mass * t139)
        .add_product(c.inverse_rocker_mass, t141);
    let coupler_omega_dot_by_crank_omega = (t9 * t142).sub_product(t8, t143).sub_product(t8, t141)
        .sub_product(t9, t140);
    let coupler_v_y_dot_by_crank_omega = -(c.inverse_coupler_mass * t140)
        .add_product(c.inverse_coupler_mass, t142);
    let coupler_v_x_dot_by_crank_omega = (c.inverse_coupler_mass * t141)
        .sub_product(c.inverse_coupler_mass, t143);
    let crank_omega_dot_by_crank_omega = (-(t7 * t144).add_product(t6, t145).add_product(t6, t143))
        .add_product(t7, t142);
    let crank_v_y_dot_by_crank_omega = (c.inverse_crank_mass * t142)
        .add_product(c.inverse_crank_mass, t144);
    let crank_v_x_dot_by_crank_omega = (c.inverse_crank_mass * t143)
        .sub_product(c.inverse_crank_mass, t145);
    let coupler_length_times_coupler_omega = p.coupler_length * coupler_omega;
    let t146 = coupler_length_times_coupler_omega * cos_coupler_phi;
    let t147 = coupler_length_times_coupler_omega * sin_coupler_phi;
    let t148 = (-t147).add_product(t31, t146);
    let t149 = (-t146).add_product(t33, t146).sub_product(t38, t148);
    let t150 = (-t147).add_product(t34, t146).sub_product(t40, t148).add_product(t45, t149);
    let t151 = (t47 * t149).sub_product(t52, t150);
    let t152 = (t48 * t149).add_product(t54, t150).add_product(t57, t151) * t58;
    let t153 = (t151 * t55).add_product(t57, t152);
    let t154 = (t150 * t50).sub_product(t52, t153).add_product(t54, t152);
    let t155 = (-(t149 * t42)).add_product(t45, t154).add_product(t47, t153).add_product(t48, t152);
    let t156 = (t148 * t36).sub_product(t38, t155).sub_product(t40, t154);
    let t157 = (t146 * t28).add_product(t31, t156).add_product(t33, t155).add_product(t34, t154);
    let t158 = (-(t26 * t156)).add_product(t24, t157);
    let t159 = (-(t18 * t157)).add_product(t16, t158).add_product(t16, t156);
    let rocker_omega_dot_by_coupler_omega = (-(t11 * t154)).add_product(t10, t155).sub_product(t10,
        t153).sub_product(t11, t152);
    let rocker_v_y_dot_by_coupler_omega = (c.inverse_rocker_mass * t152)
        .sub_product(c.inverse_rocker_mass, t154);
    let rocker_v_x_dot_by_coupler_omega = -(c.inverse_rocker_mass * t153)
        .add_product(c.inverse_rocker_mass, t155);
    let coupler_omega_dot_by_coupler_omega = (t9 * t156).add_product(t8, t157).sub_product(t8, t155)
        .add_product(t9, t154);
    let coupler_v_y_dot_by_coupler_omega = (c.inverse_coupler_mass * t154)
        .sub_product(c.inverse_coupler_mass, t156);
    let coupler_v_x_dot_by_coupler_omega = (c.inverse_coupler_mass * t155)
        .add_product(c.inverse_coupler_mass, t157);
    let crank_omega_dot_by_coupler_omega = (t7 * t158).sub_product(t6, t159).add_product(t6, t157)
        .add_product(t7, t156);
    let crank_v_y_dot_by_coupler_omega = (c.inverse_crank_mass * t156)
        .sub_product(c.inverse_crank_mass, t158);
    let crank_v_x_dot_by_coupler_omega = -(c.inverse_crank_mass * t157)
        .add_product(c.inverse_crank_mass, t159);
    let rocker_length_times_rocker_omega = p.rocker_length * rocker_omega;
    let t160 = rocker_length_times_rocker_omega * cos_rocker_phi;
    let t161 = rocker_length_times_rocker_omega * sin_rocker_phi;
    let t162 = t161.add_product(t45, t160);
    let t163 = (-t160).add_product(t47, t160).sub_product(t52, t162);
    let t164 = t161.add_product(t48, t160).add_product(t54, t162).add_product(t57, t163) * t58;
    let t165 = (t163 * t55).add_product(t57, t164);
    let t166 = (t162 * t50).sub_product(t52, t165).add_product(t54, t164);
    let t167 = (-(t160 * t42)).add_product(t45, t166).add_product(t47, t165).add_product(t48, t164);
    let t168 = (t40 * t166).add_product(t38, t167);
    let t169 = (-(t33 * t167)).add_product(t31, t168).sub_product(t34, t166);
    let t170 = (t26 * t168).sub_product(t24, t169);
    let t171 = (t18 * t169).add_product(t16, t170).sub_product(t16, t168);
    let rocker_omega_dot_by_rocker_omega = (-(t11 * t166)).add_product(t10, t167).sub_product(t10,
        t165).sub_product(t11, t164);
    let rocker_v_y_dot_by_rocker_omega = (c.inverse_rocker_mass * t164)
        .sub_product(c.inverse_rocker_mass, t166);
    let rocker_v_x_dot_by_rocker_omega = -(c.inverse_rocker_mass * t165)
        .add_product(c.inverse_rocker_mass, t167);
    let coupler_omega_dot_by_rocker_omega = (-(t9 * t168).add_product(t8, t169).add_product(t8,
        t167)).add_product(t9, t166);
    let coupler_v_y_dot_by_rocker_omega = (c.inverse_coupler_mass * t166)
        .add_product(c.inverse_coupler_mass, t168);
    let coupler_v_x_dot_by_rocker_omega = (c.inverse_coupler_mass * t167)
        .sub_product(c.inverse_coupler_mass, t169);
    let crank_omega_dot_by_rocker_omega = (t7 * t170).sub_product(t6, t171).sub_product(t6, t169)
        .sub_product(t7, t168);
    let crank_v_y_dot_by_rocker_omega = -(c.inverse_crank_mass * t168)
        .add_product(c.inverse_crank_mass, t170);
    let crank_v_x_dot_by_rocker_omega = (c.inverse_crank_mass * t169)
        .sub_product(c.inverse_crank_mass, t171);
    [R::literal(1.0), R::literal(1.0), R::literal(1.0), R::literal(1.0), R::literal(1.0),
        R::literal(1.0), R::literal(1.0), R::literal(1.0), R::literal(1.0),
        crank_v_x_dot_by_crank_phi, crank_v_x_dot_by_coupler_phi, crank_v_x_dot_by_rocker_phi,
        crank_v_x_dot_by_crank_omega, crank_v_x_dot_by_coupler_omega,
        crank_v_x_dot_by_rocker_omega, crank_v_y_dot_by_crank_phi, crank_v_y_dot_by_coupler_phi,
        crank_v_y_dot_by_rocker_phi, crank_v_y_dot_by_crank_omega, crank_v_y_dot_by_coupler_omega,
        crank_v_y_dot_by_rocker_omega, crank_omega_dot_by_crank_phi,
        crank_omega_dot_by_coupler_phi, crank_omega_dot_by_rocker_phi,
        crank_omega_dot_by_crank_omega, crank_omega_dot_by_coupler_omega,
        crank_omega_dot_by_rocker_omega, coupler_v_x_dot_by_crank_phi,
        coupler_v_x_dot_by_coupler_phi, coupler_v_x_dot_by_rocker_phi,
        coupler_v_x_dot_by_crank_omega, coupler_v_x_dot_by_coupler_omega,
        coupler_v_x_dot_by_rocker_omega, coupler_v_y_dot_by_crank_phi,
        coupler_v_y_dot_by_coupler_phi, coupler_v_y_dot_by_rocker_phi,
        coupler_v_y_dot_by_crank_omega, coupler_v_y_dot_by_coupler_omega,
        coupler_v_y_dot_by_rocker_omega, coupler_omega_dot_by_crank_phi,
        coupler_omega_dot_by_coupler_phi, coupler_omega_dot_by_rocker_phi,
        coupler_omega_dot_by_crank_omega, coupler_omega_dot_by_coupler_omega,
        coupler_omega_dot_by_rocker_omega, rocker_v_x_dot_by_crank_phi,
        rocker_v_x_dot_by_coupler_phi, rocker_v_x_dot_by_rocker_phi, rocker_v_x_dot_by_crank_omega,
        rocker_v_x_dot_by_coupler_omega, rocker_v_x_dot_by_rocker_omega,
        rocker_v_y_dot_by_crank_phi, rocker_v_y_dot_by_coupler_phi, rocker_v_y_dot_by_rocker_phi,
        rocker_v_y_dot_by_crank_omega, rocker_v_y_dot_by_coupler_omega,
        rocker_v_y_dot_by_rocker_omega, rocker_omega_dot_by_crank_phi,
        rocker_omega_dot_by_coupler_phi, rocker_omega_dot_by_rocker_phi,
        rocker_omega_dot_by_crank_omega, rocker_omega_dot_by_coupler_omega,
        rocker_omega_dot_by_rocker_omega]
}

/// As `parameter_jacobian`, with the constants of the parameters from `prepare`. 1503 operations.
#[must_use]
pub fn prepared_parameter_jacobian<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>,
        c: &Constants<R>) -> [R; 108] {
    let [_, _, crank_phi, _, _, coupler_phi, _, _, rocker_phi, _, _, crank_omega, _, _,
        coupler_omega, _, _, rocker_omega] = *state;
    let [(sin_crank_phi, cos_crank_phi), (sin_coupler_phi, cos_coupler_phi), (sin_rocker_phi,
        cos_rocker_phi)] = R::sin_cos_each([crank_phi, coupler_phi, rocker_phi]);
    let t0 = c.t0 * cos_crank_phi;
    let t1 = c.t0 * sin_crank_phi;
    let t2 = c.t1 * cos_coupler_phi;
    let t3 = c.t1 * sin_coupler_phi;
    let t4 = c.t2 * cos_rocker_phi;
    let t5 = c.t2 * sin_rocker_phi;
    let t6 = t1 * c.inverse_crank_inertia;
    let t7 = t0 * c.inverse_crank_inertia;
    let t8 = t3 * c.inverse_coupler_inertia;
    let t9 = t2 * c.inverse_coupler_inertia;
    let t10 = t5 * c.inverse_rocker_inertia;
    let t11 = t4 * c.inverse_rocker_inertia;
    let t12 = t6 * t1;
    let t13 = c.inverse_crank_mass + t12;
    let t14 = R::literal(1.0) / t13;
    let t15 = t7 * t1;
    let t16 = t15 * t14;
    let t17 = c.inverse_crank_mass - t12;
    let t18 = t17 * t14;
    let t19 = t7 * t0;
    let t20 = c.inverse_crank_mass + t19;
    let t21 = t16 * t15;
    let t22 = R::literal(1.0) / (t21 - t20);
    let t23 = (t6 * t0).add_product(t18, t15);
    let t24 = t23 * t22;
    let t25 = c.inverse_crank_mass - t19 + t21;
    let t26 = t25 * t22;
    let t27 = t8 * t3;
    let t28 = R::literal(1.0) / (-(t13 + c.inverse_coupler_mass + t27)).add_product(t18, t17)
        .sub_product(t24, t23);
    let t29 = t9 * t3;
    let t30 = (t15 + t29).add_product(t16, t17).sub_product(t26, t23);
    let t31 = t30 * t28;
    let t32 = c.inverse_coupler_mass - t27;
    let t33 = t32 * t28;
    let t34 = t29 * t28;
    let t35 = t9 * t2;
    let t36 = R::literal(1.0) / (t21 - (t20 + c.inverse_coupler_mass + t35)).sub_product(t26, t25)
        .sub_product(t31, t30);
    let t37 = (t8 * t2).sub_product(t33, t30);
    let t38 = t37 * t36;
    let t39 = (c.inverse_coupler_mass - t35).sub_product(t34, t30);
    let t40 = t39 * t36;
    let t41 = t10 * t5;
    let t42 = R::literal(1.0) / (c.inverse_coupler_mass + t27 + c.inverse_rocker_mass + t41)
        .add_product(t33, t32).add_product(t38, t37);
    let t43 = t11 * t5;
    let t44 = (t29 + t43).sub_product(t34, t32).sub_product(t40, t37);
    let t45 = t44 * t42;
    let t46 = t41 - c.inverse_rocker_mass;
    let t47 = t46 * t42;
    let t48 = t43 * t42;
    let t49 = t11 * t4;
    let t50 = R::literal(1.0) / (-(c.inverse_coupler_mass + t35 + c.inverse_rocker_mass + t49)
        .add_product(t34, t29).add_product(t40, t39)).add_product(t45, t44);
    let t51 = (-(t10 * t4)).add_product(t47, t44);
    let t52 = t51 * t50;
    let t53 = (t49 - c.inverse_rocker_mass).sub_product(t48, t44);
    let t54 = t53 * t50;
    let t55 = R::literal(1.0) / (-(c.inverse_rocker_mass + t41)).add_product(t47, t46)
        .sub_product(t52, t51);
    let t56 = t43.sub_product(t48, t46).sub_product(t54, t51);
    let t57 = t56 * t55;
    let t58 = R::literal(1.0) / (-(c.inverse_rocker_mass + t49)).add_product(t48, t43)
        .sub_product(t54, t53).sub_product(t57, t56);
    let crank_omega_squared = crank_omega * crank_omega;
    let t59 = c.t0 * crank_omega_squared;
    let t60 = t59 * cos_crank_phi;
    let t61 = p.crank_length * crank_omega_squared;
    let coupler_omega_squared = coupler_omega * coupler_omega;
    let t62 = p.coupler_length * coupler_omega_squared;
    let rocker_omega_squared = rocker_omega * rocker_omega;
    let t63 = c.t2 * rocker_omega_squared;
    let t64 = t63 * cos_rocker_phi;
    let t65 = c.t1 * coupler_omega_squared;
    let t66 = t63 * sin_rocker_phi;
    let t67 = t16 * t60;
    let t68 = c.t3.sub_product(t59, sin_crank_phi) - t67;
    let t69 = (R::literal(0.5) * (t61 * cos_crank_phi).add_product(t62, cos_coupler_phi))
        .add_product(t18, t60).add_product(t24, t68);
    let t70 = (c.t4 - c.t3.add_product(R::literal(0.5), (t61 * sin_crank_phi).add_product(t62,
        sin_coupler_phi)) - t67).sub_product(t26, t68).add_product(t31, t69);
    let t71 = t64.sub_product(t65, cos_coupler_phi).add_product(t33, t69).sub_product(t38, t70);
    let t72 = (t66.sub_product(t65, sin_coupler_phi) - c.t4 + c.t5).add_product(t34, t69)
        .sub_product(t40, t70).add_product(t45, t71);
    let t73 = (-t64).add_product(t47, t71).sub_product(t52, t72);
    let t74 = (c.t5 - t66).sub_product(t48, t71).sub_product(t54, t72).sub_product(t57, t73) * t58;
    let t75 = (t73 * t55).sub_product(t57, t74);
    let t76 = (t72 * t50).sub_product(t52, t75).sub_product(t54, t74);
    let t77 = (-(t71 * t42)).add_product(t45, t76).add_product(t47, t75).sub_product(t48, t74);
    let t78 = (t70 * t36).sub_product(t38, t77).sub_product(t40, t76);
    let pin_a_x = (t69 * t28).add_product(t31, t78).add_product(t33, t77).add_product(t34, t76);
    let t79 = (t68 * t22).add_product(t24, pin_a_x).sub_product(t26, t78);
    let t80 = (t60 * t14).add_product(t16, t79).sub_product(t18, pin_a_x).add_product(t16, t78);
    let rocker_omega_dot = (-(t11 * t76)).add_product(t10, t77).sub_product(t10, t75)
        .add_product(t11, t74);
    let coupler_omega_dot = (t9 * t78).add_product(t8, pin_a_x).sub_product(t8, t77)
        .add_product(t9, t76);
    let coupler_v_y_dot = (-c.t4.add_product(c.inverse_coupler_mass, t78))
        .add_product(c.inverse_coupler_mass, t76);
    let coupler_v_x_dot = (c.inverse_coupler_mass * t77).add_product(c.inverse_coupler_mass,
        pin_a_x);
    let crank_omega_dot = (t7 * t79).sub_product(t6, t80).add_product(t6, pin_a_x).add_product(t7,
        t78);
    let crank_v_y_dot = (-c.t3.add_product(c.inverse_crank_mass, t79))
        .add_product(c.inverse_crank_mass, t78);
    let t81 = R::literal(0.5) * crank_omega_squared;
    let t82 = R::literal(0.5) * sin_crank_phi;
    let t83 = R::literal(0.5) * cos_crank_phi;
    let t84 = (t83 * t79).sub_product(t82, t80).add_product(t82, pin_a_x).add_product(t83, t78);
    let t85 = (t81 * cos_crank_phi).add_product(t82, crank_omega_dot).add_product(t6, t84);
    let t86 = (-(t81 * sin_crank_phi)).add_product(t83, crank_omega_dot).add_product(t7, t84)
        .sub_product(t16, t85);
    let t87 = t85.add_product(t18, t85).add_product(t24, t86);
    let t88 = t86.sub_product(t26, t86).add_product(t31, t87);
    let t89 = (t33 * t87).sub_product(t38, t88);
    let t90 = (t34 * t87).sub_product(t40, t88).add_product(t45, t89);
    let t91 = (t47 * t89).sub_product(t52, t90);
    let t92 = (t48 * t89).add_product(t54, t90).add_product(t57, t91) * t58;
    let t93 = (t91 * t55).add_product(t57, t92);
    let t94 = (t90 * t50).sub_product(t52, t93).add_product(t54, t92);
    let t95 = (-(t89 * t42)).add_product(t45, t94).add_product(t47, t93).add_product(t48, t92);
    let t96 = (t88 * t36).sub_product(t38, t95).sub_product(t40, t94);
    let t97 = (t87 * t28).add_product(t31, t96).add_product(t33, t95).add_product(t34, t94);
    let t98 = (t86 * t22).add_product(t24, t97).sub_product(t26, t96);
    let t99 = (t85 * t14).add_product(t16, t98).sub_product(t18, t97).add_product(t16, t96);
    let rocker_omega_dot_by_crank_length = (-(t11 * t94)).add_product(t10, t95).sub_product(t10,
        t93).sub_product(t11, t92);
    let rocker_v_y_dot_by_crank_length = (c.inverse_rocker_mass * t92)
        .sub_product(c.inverse_rocker_mass, t94);
    let rocker_v_x_dot_by_crank_length = -(c.inverse_rocker_mass * t93)
        .add_product(c.inverse_rocker_mass, t95);
    let coupler_omega_dot_by_crank_length = (t9 * t96).add_product(t8, t97).sub_product(t8, t95)
        .add_product(t9, t94);
    let coupler_v_y_dot_by_crank_length = (c.inverse_coupler_mass * t94)
        .sub_product(c.inverse_coupler_mass, t96);
    let coupler_v_x_dot_by_crank_length = (c.inverse_coupler_mass * t95)
        .add_product(c.inverse_coupler_mass, t97);
    let crank_omega_dot_by_crank_length = (t84 * c.inverse_crank_inertia).sub_product(t6, t99)
        .add_product(t7, t98).add_product(t6, t97).add_product(t7, t96);
    let crank_v_y_dot_by_crank_length = (c.inverse_crank_mass * t96)
        .sub_product(c.inverse_crank_mass, t98);
    let crank_v_x_dot_by_crank_length = -(c.inverse_crank_mass * t97)
        .add_product(c.inverse_crank_mass, t99);
    let t100 = c.inverse_crank_mass * (c.inverse_crank_mass * pin_a_x)
        .add_product(c.inverse_crank_mass, t80);
    let t101 = c.inverse_crank_mass * (p.crank_gravity + crank_v_y_dot);
    let t102 = t16 * t100;
    let t103 = t101 - t102;
    let t104 = t100.sub_product(t18, t100).sub_product(t24, t103);
    let t105 = (t101 + t102).add_product(t26, t103).add_product(t31, t104);
    let t106 = (-(t33 * t104)).add_product(t38, t105);
    let t107 = (-(t34 * t104)).add_product(t40, t105).add_product(t45, t106);
    let t108 = (t47 * t106).sub_product(t52, t107);
    let t109 = (t48 * t106).add_product(t54, t107).add_product(t57, t108) * t58;
    let t110 = (t108 * t55).add_product(t57, t109);
    let t111 = (t107 * t50).sub_product(t52, t110).add_product(t54, t109);
    let t112 = (-(t106 * t42)).add_product(t45, t111).add_product(t47, t110).add_product(t48, t109);
    let t113 = (t105 * t36).add_product(t38, t112).add_product(t40, t111);
    let t114 = (t104 * t28).add_product(t31, t113).sub_product(t33, t112).sub_product(t34, t111);
    let t115 = (t103 * t22).sub_product(t24, t114).add_product(t26, t113);
    let t116 = (t100 * t14).add_product(t16, t115).add_product(t18, t114).sub_product(t16, t113);
    let rocker_omega_dot_by_crank_mass = (-(t11 * t111)).add_product(t10, t112).sub_product(t10,
        t110).sub_product(t11, t109);
    let rocker_v_y_dot_by_crank_mass = (c.inverse_rocker_mass * t109)
        .sub_product(c.inverse_rocker_mass, t111);
    let rocker_v_x_dot_by_crank_mass = -(c.inverse_rocker_mass * t110)
        .add_product(c.inverse_rocker_mass, t112);
    let coupler_omega_dot_by_crank_mass = (-(t9 * t113).add_product(t8, t114).add_product(t8, t112))
        .add_product(t9, t111);
    let coupler_v_y_dot_by_crank_mass = (c.inverse_coupler_mass * t111)
        .add_product(c.inverse_coupler_mass, t113);
    let coupler_v_x_dot_by_crank_mass = (c.inverse_coupler_mass * t112)
        .sub_product(c.inverse_coupler_mass, t114);
    let crank_omega_dot_by_crank_mass = (t7 * t115).sub_product(t6, t116).sub_product(t6, t114)
        .sub_product(t7, t113);
    let crank_v_y_dot_by_crank_mass = -t101.add_product(c.inverse_crank_mass, t115)
        .add_product(c.inverse_crank_mass, t113);
    let crank_v_x_dot_by_crank_mass = t100.sub_product(c.inverse_crank_mass, t116)
        .add_product(c.inverse_crank_mass, t114);
    let t117 = t6 * crank_omega_dot;
    let t118 = (-(t7 * crank_omega_dot)).add_product(t16, t117);
    let t119 = t117.add_product(t18, t117).sub_product(t24, t118);
    let t120 = t118.sub_product(t26, t118).sub_product(t31, t119);
    let t121 = (t33 * t119).add_product(t38, t120);
    let t122 = (t34 * t119).add_product(t40, t120).add_product(t45, t121);
    let t123 = (-(t47 * t121)).add_product(t52, t122);
    let t124 = (t48 * t121).add_product(t54, t122).sub_product(t57, t123) * t58;
    let t125 = (t123 * t55).sub_product(t57, t124);
    let t126 = (t122 * t50).add_product(t52, t125).add_product(t54, t124);
    let t127 = (t121 * t42).sub_product(t45, t126).add_product(t47, t125).sub_product(t48, t124);
    let t128 = (t120 * t36).sub_product(t38, t127).add_product(t40, t126);
    let t129 = (t119 * t28).sub_product(t31, t128).sub_product(t33, t127).add_product(t34, t126);
    let t130 = (t118 * t22).sub_product(t24, t129).sub_product(t26, t128);
    let t131 = (-(t117 * t14)).add_product(t16, t130).add_product(t18, t129).add_product(t16, t128);
    let rocker_omega_dot_by_crank_inertia = (t11 * t126).add_product(t10, t127).sub_product(t10,
        t125).add_product(t11, t124);
    let rocker_v_y_dot_by_crank_inertia = (-(c.inverse_rocker_mass * t124))
        .add_product(c.inverse_rocker_mass, t126);
    let rocker_v_x_dot_by_crank_inertia = -(c.inverse_rocker_mass * t125)
        .add_product(c.inverse_rocker_mass, t127);
    let coupler_omega_dot_by_crank_inertia = (t9 * t128).sub_product(t8, t129).sub_product(t8, t127)
        .sub_product(t9, t126);
    let coupler_v_y_dot_by_crank_inertia = -(c.inverse_coupler_mass * t126)
        .add_product(c.inverse_coupler_mass, t128);
    let coupler_v_x_dot_by_crank_inertia = (c.inverse_coupler_mass * t127)
        .sub_product(c.inverse_coupler_mass, t129);
    let crank_omega_dot_by_crank_inertia = (-(crank_omega_dot * c.inverse_crank_inertia)
        .add_product(t6, t131)).add_product(t7, t130).sub_product(t6, t129).add_product(t7, t128);
    let crank_v_y_dot_by_crank_inertia = (c.inverse_crank_mass * t128)
        .sub_product(c.inverse_crank_mass, t130);
    let crank_v_x_dot_by_crank_inertia = (c.inverse_crank_mass * t129)
        .sub_product(c.inverse_crank_mass, t131);
    let t132 = t24 * c.inverse_crank_mass_times_crank_mass;
    let t133 = (-c.inverse_crank_mass_times_crank_mass.add_product(t26,
        c.inverse_crank_mass_times_crank_mass)).add_product(t31, t132);
    let t134 = (t33 * t132).sub_product(t38, t133);
    let t135 = (t34 * t132).sub_product(t40, t133).add_product(t45, t134);
    let t136 = (t47 * t134).sub_product(t52, t135);
    let t137 = (t48 * t134).add_product(t54, t135).add_product(t57, t136) * t58;
    let t138 = (t136 * t55).add_product(t57, t137);
    let t139 = (t135 * t50).sub_product(t52, t138).add_product(t54, t137);
    let t140 = (-(t134 * t42)).add_product(t45, t139).add_product(t47, t138).add_product(t48, t137);
    let t141 = (t133 * t36).sub_product(t38, t140).sub_product(t40, t139);
    let t142 = (t132 * t28).add_product(t31, t141).add_product(t33, t140).add_product(t34, t139);
    let t143 = (c.inverse_crank_mass_times_crank_mass * t22).add_product(t24, t142)
        .sub_product(t26, t141);
    let t144 = (-(t18 * t142)).add_product(t16, t143).add_product(t16, t141);
    let rocker_omega_dot_by_crank_gravity = (-(t11 * t139)).add_product(t10, t140).sub_product(t10,
        t138).sub_product(t11, t137);
    let rocker_v_y_dot_by_crank_gravity = (c.inverse_rocker_mass * t137)
        .sub_product(c.inverse_rocker_mass, t139);
    let rocker_v_x_dot_by_crank_gravity = -(c.inverse_rocker_mass * t138)
        .add_product(c.inverse_rocker_mass, t140);
    let coupler_omega_dot_by_crank_gravity = (t9 * t141).add_product(t8, t142).sub_product(t8, t140)
        .add_product(t9, t139);
    let coupler_v_y_dot_by_crank_gravity = (c.inverse_coupler_mass * t139)
        .sub_product(c.inverse_coupler_mass, t141);
    let coupler_v_x_dot_by_crank_gravity = (c.inverse_coupler_mass * t140)
        .add_product(c.inverse_coupler_mass, t142);
    let crank_omega_dot_by_crank_gravity = (t7 * t143).sub_product(t6, t144).add_product(t6, t142)
        .add_product(t7, t141);
    let crank_v_y_dot_by_crank_gravity = (-c.inverse_crank_mass_times_crank_mass
        .add_product(c.inverse_crank_mass, t143)).add_product(c.inverse_crank_mass, t141);
    let crank_v_x_dot_by_crank_gravity = -(c.inverse_crank_mass * t142)
        .add_product(c.inverse_crank_mass, t144);
    let t145 = R::literal(0.5) * coupler_omega_squared;
    let t146 = R::literal(0.5) * sin_coupler_phi;
    let t147 = R::literal(0.5) * cos_coupler_phi;
    let t148 = (t147 * t78).add_product(t146, pin_a_x).sub_product(t146, t77).add_product(t147,
        t76);
    let t149 = (t145 * cos_coupler_phi).add_product(t146, coupler_omega_dot).add_product(t8, t148);
    let t150 = (-(t145 * sin_coupler_phi)).add_product(t147, coupler_omega_dot).add_product(t9,
        t148);
    let t151 = t150.add_product(t31, t149);
    let t152 = (-t149).add_product(t33, t149).sub_product(t38, t151);
    let t153 = t150.add_product(t34, t149).sub_product(t40, t151).add_product(t45, t152);
    let t154 = (t47 * t152).sub_product(t52, t153);
    let t155 = (t48 * t152).add_product(t54, t153).add_product(t57, t154) * t58;
    let t156 = (t154 * t55).add_product(t57, t155);
    let t157 = (t153 * t50).sub_product(t52, t156).add_product(t54, t155);
    let t158 = (-(t152 * t42)).add_product(t45, t157).add_product(t47, t156).add_product(t48, t155);
    let t159 = (t151 * t36).sub_product(t38, t158).sub_product(t40, t157);
    let t160 = (t149 * t28).add_product(t31, t159).add_product(t33, t158).add_product(t34, t157);
    let t161 = (-(t26 * t159)).add_product(t24, t160);
    let t162 = (-(t18 * t160)).add_product(t16, t161).add_product(t16, t159);
    let rocker_omega_dot_by_coupler_length = (-(t11 * t157)).add_product(t10, t158)
        .sub_product(t10, t156).sub_product(t11, t155);
    let rocker_v_y_dot_by_coupler_length = (c.inverse_rocker_mass * t155)
        .sub_product(c.inverse_rocker_mass, t157);
    let rocker_v_x_dot_by_coupler_length = -(c.inverse_rocker_mass * t156)
        .add_product(c.inverse_rocker_mass, t158);
    let coupler_omega_dot_by_coupler_length = (t148 * c.inverse_coupler_inertia).add_product(t8,
        t160).add_product(t9, t159).sub_product(t8, t158).add_product(t9, t157);
    let coupler_v_y_dot_by_coupler_length = (c.inverse_coupler_mass * t157)
        .sub_product(c.inverse_coupler_mass, t159);
    let coupler_v_x_dot_by_coupler_length = (c.inverse_coupler_mass * t158)
        .add_product(c.inverse_coupler_mass, t160);
    let crank_omega_dot_by_coupler_length = (t7 * t161).sub_product(t6, t162).add_product(t6, t160)
        .add_product(t7, t159);
    let crank_v_y_dot_by_coupler_length = (c.inverse_crank_mass * t159)
        .sub_product(c.inverse_crank_mass, t161);
    let crank_v_x_dot_by_coupler_length = -(c.inverse_crank_mass * t160)
        .add_product(c.inverse_crank_mass, t162);
    let t163 = c.inverse_coupler_mass * coupler_v_x_dot;
    let t164 = c.inverse_coupler_mass * (p.coupler_gravity + coupler_v_y_dot);
    let t165 = t164.sub_product(t31, t163);
    let t166 = t163.add_product(t33, t163).add_product(t38, t165);
    let t167 = t164.add_product(t34, t163).add_product(t40, t165).add_product(t45, t166);
    let t168 = (-(t47 * t166)).add_product(t52, t167);
    let t169 = (t48 * t166).add_product(t54, t167).sub_product(t57, t168) * t58;
    let t170 = (t168 * t55).sub_product(t57, t169);
    let t171 = (t167 * t50).add_product(t52, t170).add_product(t54, t169);
    let t172 = (t166 * t42).sub_product(t45, t171).add_product(t47, t170).sub_product(t48, t169);
    let t173 = (t165 * t36).sub_product(t38, t172).add_product(t40, t171);
    let t174 = (t163 * t28).sub_product(t31, t173).sub_product(t33, t172).add_product(t34, t171);
    let t175 = (t26 * t173).add_product(t24, t174);
    let t176 = (t18 * t174).sub_product(t16, t175).add_product(t16, t173);
    let rocker_omega_dot_by_coupler_mass = (t11 * t171).add_product(t10, t172).sub_product(t10,
        t170).add_product(t11, t169);
    let rocker_v_y_dot_by_coupler_mass = (-(c.inverse_rocker_mass * t169))
        .add_product(c.inverse_rocker_mass, t171);
    let rocker_v_x_dot_by_coupler_mass = -(c.inverse_rocker_mass * t170)
        .add_product(c.inverse_rocker_mass, t172);
    let coupler_omega_dot_by_coupler_mass = (t9 * t173).sub_product(t8, t174).sub_product(t8, t172)
        .sub_product(t9, t171);
    let coupler_v_y_dot_by_coupler_mass = -t164.add_product(c.inverse_coupler_mass, t173)
        .add_product(c.inverse_coupler_mass, t171);
    let coupler_v_x_dot_by_coupler_mass = (-t163.add_product(c.inverse_coupler_mass, t174))
        .add_product(c.inverse_coupler_mass, t172);
    let crank_omega_dot_by_coupler_mass = (-(t7 * t175).add_product(t6, t176).add_product(t6, t174))
        .add_product(t7, t173);
    let crank_v_y_dot_by_coupler_mass = (c.inverse_crank_mass * t173)
        .add_product(c.inverse_crank_mass, t175);
    let crank_v_x_dot_by_coupler_mass = (c.inverse_crank_mass * t174)
        .sub_product(c.inverse_crank_mass, t176);
    let t177 = t8 * coupler_omega_dot;
    let t178 = t9 * coupler_omega_dot;
    let t179 = t178.add_product(t31, t177);
    let t180 = t177.sub_product(t33, t177).add_product(t38, t179);
    let t181 = (-t178.add_product(t34, t177)).add_product(t40, t179).add_product(t45, t180);
    let t182 = (t47 * t180).sub_product(t52, t181);
    let t183 = (t48 * t180).add_product(t54, t181).add_product(t57, t182) * t58;
    let t184 = (t182 * t55).add_product(t57, t183);
    let t185 = (t181 * t50).sub_product(t52, t184).add_product(t54, t183);
    let t186 = (-(t180 * t42)).add_product(t45, t185).add_product(t47, t184).add_product(t48, t183);
    let t187 = (t179 * t36).add_product(t38, t186).add_product(t40, t185);
    let t188 = (t177 * t28).add_product(t31, t187).sub_product(t33, t186).sub_product(t34, t185);
    let t189 = (t26 * t187).sub_product(t24, t188);
    let t190 = (t18 * t188).add_product(t16, t189).sub_product(t16, t187);
    let rocker_omega_dot_by_coupler_inertia = (-(t11 * t185)).add_product(t10, t186)
        .sub_product(t10, t184).sub_product(t11, t183);
    let rocker_v_y_dot_by_coupler_inertia = (c.inverse_rocker_mass * t183)
        .sub_product(c.inverse_rocker_mass, t185);
    let rocker_v_x_dot_by_coupler_inertia = -(c.inverse_rocker_mass * t184)
        .add_product(c.inverse_rocker_mass, t186);
    let coupler_omega_dot_by_coupler_inertia = (-(coupler_omega_dot * c.inverse_coupler_inertia)
        .add_product(t8, t188).add_product(t9, t187).add_product(t8, t186)).add_product(t9, t185);
    let coupler_v_y_dot_by_coupler_inertia = (c.inverse_coupler_mass * t185)
        .add_product(c.inverse_coupler_mass, t187);
    let coupler_v_x_dot_by_coupler_inertia = (c.inverse_coupler_mass * t186)
        .sub_product(c.inverse_coupler_mass, t188);
    let crank_omega_dot_by_coupler_inertia = (t7 * t189).sub_product(t6, t190).sub_product(t6, t188)
        .sub_product(t7, t187);
    let crank_v_y_dot_by_coupler_inertia = -(c.inverse_crank_mass * t187)
        .add_product(c.inverse_crank_mass, t189);
    let crank_v_x_dot_by_coupler_inertia = (c.inverse_crank_mass * t188)
        .sub_product(c.inverse_crank_mass, t190);
    let t191 = t38 * c.t6;
    let t192 = c.t6.add_product(t40, c.t6).add_product(t45, t191);
    let t193 = (-(t47 * t191)).add_product(t52, t192);
    let t194 = (t48 * t191).add_product(t54, t192).sub_product(t57, t193) * t58;
    let t195 = (t193 * t55).sub_product(t57, t194);
    let t196 = (t192 * t50).add_product(t52, t195).add_product(t54, t194);
    let t197 = (t191 * t42).sub_product(t45, t196).add_product(t47, t195).sub_product(t48, t194);
    let t198 = (c.t6 * t36).sub_product(t38, t197).add_product(t40, t196);
    let t199 = (-(t33 * t197).add_product(t31, t198)).add_product(t34, t196);
    let t200 = (t26 * t198).add_product(t24, t199);
    let t201 = (t18 * t199).sub_product(t16, t200).add_product(t16, t198);
    let rocker_omega_dot_by_coupler_gravity = (t11 * t196).add_product(t10, t197).sub_product(t10,
        t195).add_product(t11, t194);
    let rocker_v_y_dot_by_coupler_gravity = (-(c.inverse_rocker_mass * t194))
        .add_product(c.inverse_rocker_mass, t196);
    let rocker_v_x_dot_by_coupler_gravity = -(c.inverse_rocker_mass * t195)
        .add_product(c.inverse_rocker_mass, t197);
    let coupler_omega_dot_by_coupler_gravity = (t9 * t198).sub_product(t8, t199).sub_product(t8,
        t197).sub_product(t9, t196);
    let coupler_v_y_dot_by_coupler_gravity = -c.t6.add_product(c.inverse_coupler_mass, t198)
        .add_product(c.inverse_coupler_mass, t196);
    let coupler_v_x_dot_by_coupler_gravity = (c.inverse_coupler_mass * t197)
        .sub_product(c.inverse_coupler_mass, t199);
    let crank_omega_dot_by_coupler_gravity = (-(t7 * t200).add_product(t6, t201).add_product(t6,
        t199)).add_product(t7, t198);
    let crank_v_y_dot_by_coupler_gravity = (c.inverse_crank_mass * t198)
        .add_product(c.inverse_crank_mass, t200);
    let crank_v_x_dot_by_coupler_gravity = (c.inverse_crank_mass * t199)
        .sub_product(c.inverse_crank_mass, t201);
    let t202 = R::literal(0.5) * rocker_omega_squared;
    let t203 = t202 * sin_rocker_phi;
    let t204 = R::literal(0.5) * sin_rocker_phi;
    let t205 = R::literal(0.5) * cos_rocker_phi;
    let t206 = t205 * rocker_omega_dot;
    let t207 = (-(t205 * t76)).add_product(t204, t77).sub_product(t204, t75).add_product(t205, t74);
    let t208 = (t202 * cos_rocker_phi).add_product(t204, rocker_omega_dot).add_product(t10, t207);
    let t209 = t11 * t207;
    let t210 = (t203 - t206 - t209).add_product(t45, t208);
    let t211 = (-t208).add_product(t47, t208).sub_product(t52, t210);
    let t212 = (t206 - t203 + t209).sub_product(t48, t208).sub_product(t54, t210).sub_product(t57,
        t211) * t58;
    let t213 = (t211 * t55).sub_product(t57, t212);
    let t214 = (t210 * t50).sub_product(t52, t213).sub_product(t54, t212);
    let t215 = (-(t208 * t42)).add_product(t45, t214).add_product(t47, t213).sub_product(t48, t212);
    let t216 = (t40 * t214).add_product(t38, t215);
    let t217 = (-(t33 * t215)).add_product(t31, t216).sub_product(t34, t214);
    let t218 = (t26 * t216).sub_product(t24, t217);
    let t219 = (t18 * t217).add_product(t16, t218).sub_product(t16, t216);
    let rocker_omega_dot_by_rocker_length = (t207 * c.inverse_rocker_inertia).add_product(t10, t215)
        .sub_product(t11, t214).sub_product(t10, t213).add_product(t11, t212);
    let rocker_v_y_dot_by_rocker_length = -(c.inverse_rocker_mass * t212)
        .add_product(c.inverse_rocker_mass, t214);
    let rocker_v_x_dot_by_rocker_length = -(c.inverse_rocker_mass * t213)
        .add_product(c.inverse_rocker_mass, t215);
    let coupler_omega_dot_by_rocker_length = (-(t9 * t216).add_product(t8, t217).add_product(t8,
        t215)).add_product(t9, t214);
    let coupler_v_y_dot_by_rocker_length = (c.inverse_coupler_mass * t214)
        .add_product(c.inverse_coupler_mass, t216);
    let coupler_v_x_dot_by_rocker_length = (c.inverse_coupler_mass * t215)
        .sub_product(c.inverse_coupler_mass, t217);
    let crank_omega_dot_by_rocker_length = (t7 * t218).sub_product(t6, t219).sub_product(t6, t217)
        .sub_product(t7, t216);
    let crank_v_y_dot_by_rocker_length = -(c.inverse_crank_mass * t216)
        .add_product(c.inverse_crank_mass, t218);
    let crank_v_x_dot_by_rocker_length = (c.inverse_crank_mass * t217)
        .sub_product(c.inverse_crank_mass, t219);
    let t220 = c.inverse_rocker_mass * (c.inverse_rocker_mass * t75)
        .add_product(c.inverse_rocker_mass, t77);
    let t221 = c.inverse_rocker_mass * (c.t5.add_product(c.inverse_rocker_mass, t76)
        .add_product(c.inverse_rocker_mass, t74) - p.rocker_gravity);
    let t222 = t221.add_product(t45, t220);
    let t223 = (-t220.add_product(t47, t220)).add_product(t52, t222);
    let t224 = (-t221).add_product(t48, t220).add_product(t54, t222).sub_product(t57, t223) * t58;
    let t225 = (t223 * t55).sub_product(t57, t224);
    let t226 = (t222 * t50).add_product(t52, t225).add_product(t54, t224);
    let t227 = (t220 * t42).sub_product(t45, t226).add_product(t47, t225).sub_product(t48, t224);
    let t228 = (t40 * t226).sub_product(t38, t227);
    let t229 = (-(t33 * t227).add_product(t31, t228)).add_product(t34, t226);
    let t230 = (t26 * t228).add_product(t24, t229);
    let t231 = (t18 * t229).sub_product(t16, t230).add_product(t16, t228);
    let rocker_omega_dot_by_rocker_mass = (t11 * t226).add_product(t10, t227).sub_product(t10, t225)
        .add_product(t11, t224);
    let rocker_v_y_dot_by_rocker_mass = t221.add_product(c.inverse_rocker_mass, t226)
        .sub_product(c.inverse_rocker_mass, t224);
    let rocker_v_x_dot_by_rocker_mass = t220.sub_product(c.inverse_rocker_mass, t227)
        .sub_product(c.inverse_rocker_mass, t225);
    let coupler_omega_dot_by_rocker_mass = (t9 * t228).sub_product(t8, t229).sub_product(t8, t227)
        .sub_product(t9, t226);
    let coupler_v_y_dot_by_rocker_mass = -(c.inverse_coupler_mass * t226)
        .add_product(c.inverse_coupler_mass, t228);
    let coupler_v_x_dot_by_rocker_mass = (c.inverse_coupler_mass * t227)
        .sub_product(c.inverse_coupler_mass, t229);
    let crank_omega_dot_by_rocker_mass = (-(t7 * t230).add_product(t6, t231).add_product(t6, t229))
        .add_product(t7, t228);
    let crank_v_y_dot_by_rocker_mass = (c.inverse_crank_mass * t228)
        .add_product(c.inverse_crank_mass, t230);
    let crank_v_x_dot_by_rocker_mass = (c.inverse_crank_mass * t229)
        .sub_product(c.inverse_crank_mass, t231);
    let t232 = t10 * rocker_omega_dot;
    let t233 = t11 * rocker_omega_dot;
    let t234 = t233.sub_product(t45, t232);
    let t235 = t232.sub_product(t47, t232).sub_product(t52, t234);
    let t236 = (-t233).add_product(t48, t232).sub_product(t54, t234).sub_product(t57, t235) * t58;
    let t237 = (t235 * t55).sub_product(t57, t236);
    let t238 = (t234 * t50).sub_product(t52, t237).sub_product(t54, t236);
    let t239 = (t232 * t42).add_product(t45, t238).add_product(t47, t237).sub_product(t48, t236);
    let t240 = (t40 * t238).add_product(t38, t239);
    let t241 = (-(t33 * t239)).add_product(t31, t240).sub_product(t34, t238);
    let t242 = (t26 * t240).sub_product(t24, t241);
    let t243 = (t18 * t241).add_product(t16, t242).sub_product(t16, t240);
    let rocker_omega_dot_by_rocker_inertia = (-(rocker_omega_dot * c.inverse_rocker_inertia))
        .add_product(t10, t239).sub_product(t11, t238).sub_product(t10, t237).add_product(t11,
        t236);
    let rocker_v_y_dot_by_rocker_inertia = -(c.inverse_rocker_mass * t236)
        .add_product(c.inverse_rocker_mass, t238);
    let rocker_v_x_dot_by_rocker_inertia = -(c.inverse_rocker_mass * t237)
        .add_product(c.inverse_rocker_mass, t239);
    let coupler_omega_dot_by_rocker_inertia = (-(t9 * t240).add_product(t8, t241).add_product(t8,
        t239)).add_product(t9, t238);
    let coupler_v_y_dot_by_rocker_inertia = (c.inverse_coupler_mass * t238)
        .add_product(c.inverse_coupler_mass, t240);
    let coupler_v_x_dot_by_rocker_inertia = (c.inverse_coupler_mass * t239)
        .sub_product(c.inverse_coupler_mass, t241);
    let crank_omega_dot_by_rocker_inertia = (t7 * t242).sub_product(t6, t243).sub_product(t6, t241)
        .sub_product(t7, t240);
    let crank_v_y_dot_by_rocker_inertia = -(c.inverse_crank_mass * t240)
        .add_product(c.inverse_crank_mass, t242);
    let crank_v_x_dot_by_rocker_inertia = (c.inverse_crank_mass * t241)
        .sub_product(c.inverse_crank_mass, t243);
    let t244 = t52 * c.t7;
    let t245 = c.t7.sub_product(t54, c.t7).add_product(t57, t244) * t58;
    let t246 = (t244 * t55).add_product(t57, t245);
    let t247 = (c.t7 * t50).add_product(t52, t246).sub_product(t54, t245);
    let t248 = (-(t47 * t246)).add_product(t45, t247).sub_product(t48, t245);
    let t249 = (t40 * t247).add_product(t38, t248);
    let t250 = (-(t33 * t248)).add_product(t31, t249).sub_product(t34, t247);
    let t251 = (t26 * t249).sub_product(t24, t250);
    let t252 = (t18 * t250).add_product(t16, t251).sub_product(t16, t249);
    let rocker_omega_dot_by_rocker_gravity = (-(t11 * t247)).add_product(t10, t248)
        .add_product(t10, t246).add_product(t11, t245);
    let rocker_v_y_dot_by_rocker_gravity = -c.t7.add_product(c.inverse_rocker_mass, t247)
        .add_product(c.inverse_rocker_mass, t245);
    let rocker_v_x_dot_by_rocker_gravity = (c.inverse_rocker_mass * t246)
        .sub_product(c.inverse_rocker_mass, t248);
    let coupler_omega_dot_by_rocker_gravity = (-(t9 * t249).add_product(t8, t250).add_product(t8,
        t248)).add_product(t9, t247);
    let coupler_v_y_dot_by_rocker_gravity = (c.inverse_coupler_mass * t247)
        .add_product(c.inverse_coupler_mass, t249);
    let coupler_v_x_dot_by_rocker_gravity = (c.inverse_coupler_mass * t248)
        .sub_product(c.inverse_coupler_mass, t250);
    let crank_omega_dot_by_rocker_gravity = (t7 * t251).sub_product(t6, t252).sub_product(t6, t250)
        .sub_product(t7, t249);
    let crank_v_y_dot_by_rocker_gravity = -(c.inverse_crank_mass * t249)
        .add_product(c.inverse_crank_mass, t251);
    let crank_v_x_dot_by_rocker_gravity = (c.inverse_crank_mass * t250)
        .sub_product(c.inverse_crank_mass, t252);
    [crank_v_x_dot_by_crank_length, crank_v_x_dot_by_crank_mass, crank_v_x_dot_by_crank_inertia,
        crank_v_x_dot_by_crank_gravity, crank_v_x_dot_by_coupler_length,
        crank_v_x_dot_by_coupler_mass, crank_v_x_dot_by_coupler_inertia,
        crank_v_x_dot_by_coupler_gravity, crank_v_x_dot_by_rocker_length,
        crank_v_x_dot_by_rocker_mass, crank_v_x_dot_by_rocker_inertia,
        crank_v_x_dot_by_rocker_gravity, crank_v_y_dot_by_crank_length,
        crank_v_y_dot_by_crank_mass, crank_v_y_dot_by_crank_inertia,
        crank_v_y_dot_by_crank_gravity, crank_v_y_dot_by_coupler_length,
        crank_v_y_dot_by_coupler_mass, crank_v_y_dot_by_coupler_inertia,
        crank_v_y_dot_by_coupler_gravity, crank_v_y_dot_by_rocker_length,
        crank_v_y_dot_by_rocker_mass, crank_v_y_dot_by_rocker_inertia,
        crank_v_y_dot_by_rocker_gravity, crank_omega_dot_by_crank_length,
        crank_omega_dot_by_crank_mass, crank_omega_dot_by_crank_inertia,
        crank_omega_dot_by_crank_gravity, crank_omega_dot_by_coupler_length,
        crank_omega_dot_by_coupler_mass, crank_omega_dot_by_coupler_inertia,
        crank_omega_dot_by_coupler_gravity, crank_omega_dot_by_rocker_length,
        crank_omega_dot_by_rocker_mass, crank_omega_dot_by_rocker_inertia,
        crank_omega_dot_by_rocker_gravity, coupler_v_x_dot_by_crank_length,
        coupler_v_x_dot_by_crank_mass, coupler_v_x_dot_by_crank_inertia,
        coupler_v_x_dot_by_crank_gravity, coupler_v_x_dot_by_coupler_length,
        coupler_v_x_dot_by_coupler_mass, coupler_v_x_dot_by_coupler_inertia,
        coupler_v_x_dot_by_coupler_gravity, coupler_v_x_dot_by_rocker_length,
        coupler_v_x_dot_by_rocker_mass, coupler_v_x_dot_by_rocker_inertia,
        coupler_v_x_dot_by_rocker_gravity, coupler_v_y_dot_by_crank_length,
        coupler_v_y_dot_by_crank_mass, coupler_v_y_dot_by_crank_inertia,
        coupler_v_y_dot_by_crank_gravity, coupler_v_y_dot_by_coupler_length,
        coupler_v_y_dot_by_coupler_mass, coupler_v_y_dot_by_coupler_inertia,
        coupler_v_y_dot_by_coupler_gravity, coupler_v_y_dot_by_rocker_length,
        coupler_v_y_dot_by_rocker_mass, coupler_v_y_dot_by_rocker_inertia,
        coupler_v_y_dot_by_rocker_gravity, coupler_omega_dot_by_crank_length,
        coupler_omega_dot_by_crank_mass, coupler_omega_dot_by_crank_inertia,
        coupler_omega_dot_by_crank_gravity, coupler_omega_dot_by_coupler_length,
        coupler_omega_dot_by_coupler_mass, coupler_omega_dot_by_coupler_inertia,
        coupler_omega_dot_by_coupler_gravity, coupler_omega_dot_by_rocker_length,
        coupler_omega_dot_by_rocker_mass, coupler_omega_dot_by_rocker_inertia,
        coupler_omega_dot_by_rocker_gravity, rocker_v_x_dot_by_crank_length,
        rocker_v_x_dot_by_crank_mass, rocker_v_x_dot_by_crank_inertia,
        rocker_v_x_dot_by_crank_gravity, rocker_v_x_dot_by_coupler_length,
        rocker_v_x_dot_by_coupler_mass, rocker_v_x_dot_by_coupler_inertia,
        rocker_v_x_dot_by_coupler_gravity, rocker_v_x_dot_by_rocker_length,
        rocker_v_x_dot_by_rocker_mass, rocker_v_x_dot_by_rocker_inertia,
        rocker_v_x_dot_by_rocker_gravity, rocker_v_y_dot_by_crank_length,
        rocker_v_y_dot_by_crank_mass, rocker_v_y_dot_by_crank_inertia,
        rocker_v_y_dot_by_crank_gravity, rocker_v_y_dot_by_coupler_length,
        rocker_v_y_dot_by_coupler_mass, rocker_v_y_dot_by_coupler_inertia,
        rocker_v_y_dot_by_coupler_gravity, rocker_v_y_dot_by_rocker_length,
        rocker_v_y_dot_by_rocker_mass, rocker_v_y_dot_by_rocker_inertia,
        rocker_v_y_dot_by_rocker_gravity, rocker_omega_dot_by_crank_length,
        rocker_omega_dot_by_crank_mass, rocker_omega_dot_by_crank_inertia,
        rocker_omega_dot_by_crank_gravity, rocker_omega_dot_by_coupler_length,
        rocker_omega_dot_by_coupler_mass, rocker_omega_dot_by_coupler_inertia,
        rocker_omega_dot_by_coupler_gravity, rocker_omega_dot_by_rocker_length,
        rocker_omega_dot_by_rocker_mass, rocker_omega_dot_by_rocker_inertia,
        rocker_omega_dot_by_rocker_gravity]
}

/// Partial derivative of `y'` with respect to time. No operations.
#[must_use]
pub fn time_derivative<R: Real>(_time: R, _state: &[R; STATES], _p: &Parameters<R>) -> [R; STATES] {
    [R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0),
        R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0),
        R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0),
        R::literal(0.0), R::literal(0.0), R::literal(0.0)]
}

/// Wanted outputs. 246 operations.
#[must_use]
pub fn outputs<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>) -> Outputs<R> {
    let [_, _, crank_phi, _, _, coupler_phi, _, _, rocker_phi, _, _, crank_omega, _, _,
        coupler_omega, _, _, rocker_omega] = *state;
    let [(sin_crank_phi, cos_crank_phi), (sin_coupler_phi, cos_coupler_phi), (sin_rocker_phi,
        cos_rocker_phi)] = R::sin_cos_each([crank_phi, coupler_phi, rocker_phi]);
    let t0 = R::literal(0.5) * p.crank_length;
    let t1 = t0 * cos_crank_phi;
    let t2 = t0 * sin_crank_phi;
    let t3 = R::literal(0.5) * p.coupler_length;
    let t4 = t3 * cos_coupler_phi;
    let t5 = t3 * sin_coupler_phi;
    let t6 = R::literal(0.5) * p.rocker_length;
    let t7 = t6 * cos_rocker_phi;
    let t8 = t6 * sin_rocker_phi;
    let inverse_crank_mass = R::literal(1.0) / p.crank_mass;
    let inverse_crank_inertia = R::literal(1.0) / p.crank_inertia;
    let t9 = t2 * inverse_crank_inertia;
    let t10 = t1 * inverse_crank_inertia;
    let inverse_coupler_mass = R::literal(1.0) / p.coupler_mass;
    let inverse_coupler_inertia = R::literal(1.0) / p.coupler_inertia;
    let t11 = t5 * inverse_coupler_inertia;
    let t12 = t4 * inverse_coupler_inertia;
    let inverse_rocker_mass = R::literal(1.0) / p.rocker_mass;
    let inverse_rocker_inertia = R::literal(1.0) / p.rocker_inertia;
    let t13 = t8 * inverse_rocker_inertia;
    let t14 = t7 * inverse_rocker_inertia;
    let t15 = t9 * t2;
    let t16 = inverse_crank_mass + t15;
    let t17 = R::literal(1.0) / t16;
    let t18 = t10 * t2;
    let t19 = t18 * t17;
    let t20 = inverse_crank_mass - t15;
    let t21 = t20 * t17;
    let t22 = t10 * t1;
    let t23 = inverse_crank_mass + t22;
    let t24 = t19 * t18;
    let t25 = R::literal(1.0) / (t24 - t23);
    let t26 = (t9 * t1).add_product(t21, t18);
    let t27 = t26 * t25;
    let t28 = inverse_crank_mass - t22 + t24;
    let t29 = t28 * t25;
    let t30 = t11 * t5;
    let t31 = R::literal(1.0) / (-(t16 + inverse_coupler_mass + t30)).add_product(t21, t20)
        .sub_product(t27, t26);
    let t32 = t12 * t5;
    let t33 = (t18 + t32).add_product(t19, t20).sub_product(t29, t26);
    let t34 = t33 * t31;
    let t35 = inverse_coupler_mass - t30;
    let t36 = t35 * t31;
    let t37 = t32 * t31;
    let t38 = t12 * t4;
    let t39 = R::literal(1.0) / (t24 - (t23 + inverse_coupler_mass + t38)).sub_product(t29, t28)
        .sub_product(t34, t33);
    let t40 = (t11 * t4).sub_product(t36, t33);
    let t41 = t40 * t39;
    let t42 = (inverse_coupler_mass - t38).sub_product(t37, t33);
    let t43 = t42 * t39;
    let t44 = t13 * t8;
    let t45 = R::literal(1.0) / (inverse_coupler_mass + t30 + inverse_rocker_mass + t44)
        .add_product(t36, t35).add_product(t41, t40);
    let t46 = t14 * t8;
    let t47 = (t32 + t46).sub_product(t37, t35).sub_product(t43, t40);
    let t48 = t47 * t45;
    let t49 = t44 - inverse_rocker_mass;
    let t50 = t49 * t45;
    let t51 = t46 * t45;
    let t52 = t14 * t7;
    let t53 = R::literal(1.0) / (-(inverse_coupler_mass + t38 + inverse_rocker_mass + t52)
        .add_product(t37, t32).add_product(t43, t42)).add_product(t48, t47);
    let t54 = (-(t13 * t7)).add_product(t50, t47);
    let t55 = t54 * t53;
    let t56 = (t52 - inverse_rocker_mass).sub_product(t51, t47);
    let t57 = t56 * t53;
    let t58 = R::literal(1.0) / (-(inverse_rocker_mass + t44)).add_product(t50, t49)
        .sub_product(t55, t54);
    let t59 = t46.sub_product(t51, t49).sub_product(t57, t54);
    let t60 = t59 * t58;
    let crank_omega_squared = crank_omega * crank_omega;
    let t61 = t0 * crank_omega_squared;
    let t62 = t61 * cos_crank_phi;
    let t63 = p.crank_length * crank_omega_squared;
    let coupler_omega_squared = coupler_omega * coupler_omega;
    let t64 = p.coupler_length * coupler_omega_squared;
    let t65 = t6 * (rocker_omega * rocker_omega);
    let t66 = t65 * cos_rocker_phi;
    let t67 = t3 * coupler_omega_squared;
    let t68 = t65 * sin_rocker_phi;
    let t69 = inverse_crank_mass * (p.crank_mass * p.crank_gravity);
    let t70 = t19 * t62;
    let t71 = t69.sub_product(t61, sin_crank_phi) - t70;
    let t72 = (R::literal(0.5) * (t63 * cos_crank_phi).add_product(t64, cos_coupler_phi))
        .add_product(t21, t62).add_product(t27, t71);
    let t73 = inverse_coupler_mass * (p.coupler_mass * p.coupler_gravity);
    let t74 = (t73 - t69.add_product(R::literal(0.5), (t63 * sin_crank_phi).add_product(t64,
        sin_coupler_phi)) - t70).sub_product(t29, t71).add_product(t34, t72);
    let t75 = t66.sub_product(t67, cos_coupler_phi).add_product(t36, t72).sub_product(t41, t74);
    let t76 = inverse_rocker_mass * (p.rocker_mass * p.rocker_gravity);
    let t77 = (t68.sub_product(t67, sin_coupler_phi) - t73 + t76).add_product(t37, t72)
        .sub_product(t43, t74).add_product(t48, t75);
    let t78 = (-t66).add_product(t50, t75).sub_product(t55, t77);
    let t79 = (t76 - t68).sub_product(t51, t75).sub_product(t57, t77).sub_product(t60, t78)
        * (R::literal(1.0) / (-(inverse_rocker_mass + t52)).add_product(t51, t46).sub_product(t57,
        t56).sub_product(t60, t59));
    let t80 = (t78 * t58).sub_product(t60, t79);
    let t81 = (t77 * t53).sub_product(t55, t80).sub_product(t57, t79);
    let t82 = (-(t75 * t45)).add_product(t48, t81).add_product(t50, t80).sub_product(t51, t79);
    let t83 = (t74 * t39).sub_product(t41, t82).sub_product(t43, t81);
    let pin_a_x = (t72 * t31).add_product(t34, t83).add_product(t36, t82).add_product(t37, t81);
    let t84 = (t71 * t25).add_product(t27, pin_a_x);
    let t85 = t29 * t83;
    let pin_o_x = (-(t62 * t17).add_product(t19, t84 - t85)).add_product(t21, pin_a_x)
        .sub_product(t19, t83);
    let pin_o_y = t85 - t84;
    Outputs {
        crank_angle: crank_phi,
        coupler_angle: coupler_phi,
        rocker_angle: rocker_phi,
        crank_speed: crank_omega,
        pin_force_x: pin_o_x,
        pin_force_y: pin_o_y,
    }
}

/// T, V and the energy of first-order states \[J\]. 37 operations.
#[must_use]
pub fn energy<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>) -> Energy<R> {
    let [_, crank_y, _, _, coupler_y, _, _, rocker_y, _, crank_v_x, crank_v_y, crank_omega,
        coupler_v_x, coupler_v_y, coupler_omega, rocker_v_x, rocker_v_y, rocker_omega] = *state;
    Energy {
        kinetic: (R::literal(0.5) * p.crank_inertia * (crank_omega * crank_omega))
            .add_product(R::literal(0.5) * p.crank_mass, (crank_v_x * crank_v_x)
            .add_product(crank_v_y, crank_v_y)).add_product(R::literal(0.5) * p.coupler_mass,
            (coupler_v_x * coupler_v_x).add_product(coupler_v_y, coupler_v_y))
            .add_product(R::literal(0.5) * p.coupler_inertia, coupler_omega * coupler_omega)
            .add_product(R::literal(0.5) * p.rocker_mass, (rocker_v_x * rocker_v_x)
            .add_product(rocker_v_y, rocker_v_y)).add_product(R::literal(0.5) * p.rocker_inertia,
            rocker_omega * rocker_omega),
        potential: (p.crank_mass * p.crank_gravity * crank_y).add_product(p.coupler_mass
            * p.coupler_gravity, coupler_y).add_product(p.rocker_mass * p.rocker_gravity, rocker_y),
        stored: R::literal(0.0),
    }
}

/// `dE/dt`, power supplied and power dissipated \[W\]. 319 operations.
#[must_use]
pub fn power_balance<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>) -> PowerBalance<R> {
    let [_, _, crank_phi, _, _, coupler_phi, _, _, rocker_phi, crank_v_x, crank_v_y, crank_omega,
        coupler_v_x, coupler_v_y, coupler_omega, rocker_v_x, rocker_v_y, rocker_omega] = *state;
    let [(sin_crank_phi, cos_crank_phi), (sin_coupler_phi, cos_coupler_phi), (sin_rocker_phi,
        cos_rocker_phi)] = R::sin_cos_each([crank_phi, coupler_phi, rocker_phi]);
    let t0 = R::literal(0.5) * p.crank_length;
    let t1 = t0 * cos_crank_phi;
    let t2 = t0 * sin_crank_phi;
    let t3 = R::literal(0.5) * p.coupler_length;
    let t4 = t3 * cos_coupler_phi;
    let t5 = t3 * sin_coupler_phi;
    let t6 = R::literal(0.5) * p.rocker_length;
    let t7 = t6 * cos_rocker_phi;
    let t8 = t6 * sin_rocker_phi;
    let inverse_crank_mass = R::literal(1.0) / p.crank_mass;
    let inverse_crank_inertia = R::literal(1.0) / p.crank_inertia;
    let t9 = t2 * inverse_crank_inertia;
    let t10 = t1 * inverse_crank_inertia;
    let inverse_coupler_mass = R::literal(1.0) / p.coupler_mass;
    let inverse_coupler_inertia = R::literal(1.0) / p.coupler_inertia;
    let t11 = t5 * inverse_coupler_inertia;
    let t12 = t4 * inverse_coupler_inertia;
    let inverse_rocker_mass = R::literal(1.0) / p.rocker_mass;
    let inverse_rocker_inertia = R::literal(1.0) / p.rocker_inertia;
    let t13 = t8 * inverse_rocker_inertia;
    let t14 = t7 * inverse_rocker_inertia;
    let t15 = t9 * t2;
    let t16 = inverse_crank_mass + t15;
    let t17 = R::literal(1.0) / t16;
    let t18 = t10 * t2;
    let t19 = t18 * t17;
    let t20 = inverse_crank_mass - t15;
    let t21 = t20 * t17;
    let t22 = t10 * t1;
    let t23 = inverse_crank_mass + t22;
    let t24 = t19 * t18;
    let t25 = R::literal(1.0) / (t24 - t23);
    let t26 = (t9 * t1).add_product(t21, t18);
    let t27 = t26 * t25;
    let t28 = inverse_crank_mass - t22 + t24;
    let t29 = t28 * t25;
    let t30 = t11 * t5;
    let t31 = R::literal(1.0) / (-(t16 + inverse_coupler_mass + t30)).add_product(t21, t20)
        .sub_product(t27, t26);
    let t32 = t12 * t5;
    let t33 = (t18 + t32).add_product(t19, t20).sub_product(t29, t26);
    let t34 = t33 * t31;
    let t35 = inverse_coupler_mass - t30;
    let t36 = t35 * t31;
    let t37 = t32 * t31;
    let t38 = t12 * t4;
    let t39 = R::literal(1.0) / (t24 - (t23 + inverse_coupler_mass + t38)).sub_product(t29, t28)
        .sub_product(t34, t33);
    let t40 = (t11 * t4).sub_product(t36, t33);
    let t41 = t40 * t39;
    let t42 = (inverse_coupler_mass - t38).sub_product(t37, t33);
    let t43 = t42 * t39;
    let t44 = t13 * t8;
    let t45 = R::literal(1.0) / (inverse_coupler_mass + t30 + inverse_rocker_mass + t44)
        .add_product(t36, t35).add_product(t41, t40);
    let t46 = t14 * t8;
    let t47 = (t32 + t46).sub_product(t37, t35).sub_product(t43, t40);
    let t48 = t47 * t45;
    let t49 = t44 - inverse_rocker_mass;
    let t50 = t49 * t45;
    let t51 = t46 * t45;
    let t52 = t14 * t7;
    let t53 = R::literal(1.0) / (-(inverse_coupler_mass + t38 + inverse_rocker_mass + t52)
        .add_product(t37, t32).add_product(t43, t42)).add_product(t48, t47);
    let t54 = (-(t13 * t7)).add_product(t50, t47);
    let t55 = t54 * t53;
    let t56 = (t52 - inverse_rocker_mass).sub_product(t51, t47);
    let t57 = t56 * t53;
    let t58 = R::literal(1.0) / (-(inverse_rocker_mass + t44)).add_product(t50, t49)
        .sub_product(t55, t54);
    let t59 = t46.sub_product(t51, t49).sub_product(t57, t54);
    let t60 = t59 * t58;
    let crank_mass_times_crank_gravity = p.crank_mass * p.crank_gravity;
    let coupler_mass_times_coupler_gravity = p.coupler_mass * p.coupler_gravity;
    let rocker_mass_times_rocker_gravity = p.rocker_mass * p.rocker_gravity;
    let crank_omega_squared = crank_omega * crank_omega;
    let t61 = t0 * crank_omega_squared;
    let t62 = t61 * cos_crank_phi;
    let t63 = p.crank_length * crank_omega_squared;
    let coupler_omega_squared = coupler_omega * coupler_omega;
    let t64 = p.coupler_length * coupler_omega_squared;
    let t65 = t6 * (rocker_omega * rocker_omega);
    let t66 = t65 * cos_rocker_phi;
    let t67 = t3 * coupler_omega_squared;
    let t68 = t65 * sin_rocker_phi;
    let t69 = inverse_crank_mass * crank_mass_times_crank_gravity;
    let t70 = t19 * t62;
    let t71 = t69.sub_product(t61, sin_crank_phi) - t70;
    let t72 = (R::literal(0.5) * (t63 * cos_crank_phi).add_product(t64, cos_coupler_phi))
        .add_product(t21, t62).add_product(t27, t71);
    let t73 = inverse_coupler_mass * coupler_mass_times_coupler_gravity;
    let t74 = (t73 - t69.add_product(R::literal(0.5), (t63 * sin_crank_phi).add_product(t64,
        sin_coupler_phi)) - t70).sub_product(t29, t71).add_product(t34, t72);
    let t75 = t66.sub_product(t67, cos_coupler_phi).add_product(t36, t72).sub_product(t41, t74);
    let t76 = inverse_rocker_mass * rocker_mass_times_rocker_gravity;
    let t77 = (t68.sub_product(t67, sin_coupler_phi) - t73 + t76).add_product(t37, t72)
        .sub_product(t43, t74).add_product(t48, t75);
    let t78 = (-t66).add_product(t50, t75).sub_product(t55, t77);
    let t79 = (t76 - t68).sub_product(t51, t75).sub_product(t57, t77).sub_product(t60, t78)
        * (R::literal(1.0) / (-(inverse_rocker_mass + t52)).add_product(t51, t46).sub_product(t57,
        t56).sub_product(t60, t59));
    let t80 = (t78 * t58).sub_product(t60, t79);
    let t81 = (t77 * t53).sub_product(t55, t80).sub_product(t57, t79);
    let t82 = (-(t75 * t45)).add_product(t48, t81).add_product(t50, t80).sub_product(t51, t79);
    let t83 = (t74 * t39).sub_product(t41, t82).sub_product(t43, t81);
    let pin_a_x = (t72 * t31).add_product(t34, t83).add_product(t36, t82).add_product(t37, t81);
    let t84 = (t71 * t25).add_product(t27, pin_a_x).sub_product(t29, t83);
    let t85 = (t62 * t17).add_product(t19, t84).sub_product(t21, pin_a_x).add_product(t19, t83);
    let rocker_omega_dot = (-(t14 * t81)).add_product(t13, t82).sub_product(t13, t80)
        .add_product(t14, t79);
    let coupler_omega_dot = (t12 * t83).add_product(t11, pin_a_x).sub_product(t11, t82)
        .add_product(t12, t81);
    let coupler_v_y_dot = (-t73.add_product(inverse_coupler_mass, t83))
        .add_product(inverse_coupler_mass, t81);
    let coupler_v_x_dot = (inverse_coupler_mass * t82).add_product(inverse_coupler_mass, pin_a_x);
    let crank_omega_dot = (t10 * t84).sub_product(t9, t85).add_product(t9, pin_a_x)
        .add_product(t10, t83);
    let crank_v_y_dot = (-t69.add_product(inverse_crank_mass, t84)).add_product(inverse_crank_mass,
        t83);
    let t86 = (crank_mass_times_crank_gravity * crank_v_y)
        .add_product(coupler_mass_times_coupler_gravity, coupler_v_y)
        .add_product(rocker_mass_times_rocker_gravity, rocker_v_y).sub_product(p.crank_mass
        * crank_v_x, (inverse_crank_mass * pin_a_x).add_product(inverse_crank_mass, t85))
        .add_product(p.crank_mass * crank_v_y, crank_v_y_dot).add_product(p.crank_inertia
        * crank_omega, crank_omega_dot).add_product(p.coupler_mass * coupler_v_x, coupler_v_x_dot)
        .add_product(p.coupler_mass * coupler_v_y, coupler_v_y_dot).add_product(p.coupler_inertia
        * coupler_omega, coupler_omega_dot).sub_product(p.rocker_mass * rocker_v_x,
        (inverse_rocker_mass * t80).add_product(inverse_rocker_mass, t82));
    PowerBalance {
        stored_rate: t86.sub_product(p.rocker_mass * rocker_v_y, t76
            .add_product(inverse_rocker_mass, t81).add_product(inverse_rocker_mass, t79))
            .add_product(p.rocker_inertia * rocker_omega, rocker_omega_dot),
        supplied: R::literal(0.0),
        dissipated: R::literal(0.0),
    }
}

/// `g` of each constraint, zero for those of velocities alone. 32 operations.
#[must_use]
pub fn constraint_values<R: Real>(_time: R, state: &[R; STATES],
        p: &Parameters<R>) -> [R; CONSTRAINTS] {
    let [crank_x, crank_y, crank_phi, coupler_x, coupler_y, coupler_phi, rocker_x, rocker_y,
        rocker_phi, ..] = *state;
    let [(sin_crank_phi, cos_crank_phi), (sin_coupler_phi, cos_coupler_phi), (sin_rocker_phi,
        cos_rocker_phi)] = R::sin_cos_each([crank_phi, coupler_phi, rocker_phi]);
    let t0 = R::literal(0.5) * p.crank_length;
    let t1 = t0 * cos_crank_phi;
    let crank_start_x = crank_x - t1;
    let t2 = t0 * sin_crank_phi;
    let crank_start_y = crank_y - t2;
    let crank_end_x = crank_x + t1;
    let crank_end_y = crank_y + t2;
    let t3 = R::literal(0.5) * p.coupler_length;
    let t4 = t3 * cos_coupler_phi;
    let coupler_start_x = coupler_x - t4;
    let t5 = t3 * sin_coupler_phi;
    let coupler_start_y = coupler_y - t5;
    let coupler_end_x = coupler_x + t4;
    let coupler_end_y = coupler_y + t5;
    let t6 = R::literal(0.5) * p.rocker_length;
    let t7 = t6 * cos_rocker_phi;
    let rocker_start_x = rocker_x - t7;
    let t8 = t6 * sin_rocker_phi;
    let rocker_start_y = rocker_y - t8;
    let rocker_end_x = rocker_x + t7;
    let rocker_end_y = rocker_y + t8;
    let pin_a_x_value = coupler_start_x - crank_end_x;
    let pin_a_y_value = coupler_start_y - crank_end_y;
    let pin_b_x_value = rocker_end_x - coupler_end_x;
    let pin_b_y_value = rocker_end_y - coupler_end_y;
    let pin_c_x_value = rocker_start_x - p.base;
    [crank_start_x, crank_start_y, pin_a_x_value, pin_a_y_value, pin_b_x_value, pin_b_y_value,
        pin_c_x_value, rocker_start_y]
}

/// `g'` of each constraint. 34 operations.
#[must_use]
pub fn constraint_rates<R: Real>(_time: R, state: &[R; STATES],
        p: &Parameters<R>) -> [R; CONSTRAINTS] {
    let [_, _, crank_phi, _, _, coupler_phi, _, _, rocker_phi, crank_v_x, crank_v_y, crank_omega,
        coupler_v_x, coupler_v_y, coupler_omega, rocker_v_x, rocker_v_y, rocker_omega] = *state;
    let [(sin_crank_phi, cos_crank_phi), (sin_coupler_phi, cos_coupler_phi), (sin_rocker_phi,
        cos_rocker_phi)] = R::sin_cos_each([crank_phi, coupler_phi, rocker_phi]);
    let t0 = R::literal(0.5) * p.crank_length * crank_omega;
    let t1 = t0 * sin_crank_phi;
    let pin_o_x_rate = crank_v_x + t1;
    let t2 = t0 * cos_crank_phi;
    let pin_o_y_rate = crank_v_y - t2;
    let t3 = R::literal(0.5) * p.coupler_length * coupler_omega;
    let t4 = t3 * sin_coupler_phi;
    let pin_a_x_rate = coupler_v_x + t1 + t4 - crank_v_x;
    let t5 = t3 * cos_coupler_phi;
    let pin_a_y_rate = coupler_v_y - crank_v_y - t2 - t5;
    let t6 = R::literal(0.5) * p.rocker_length * rocker_omega;
    let t7 = t6 * sin_rocker_phi;
    let pin_b_x_rate = rocker_v_x + t4 - coupler_v_x - t7;
    let t8 = t6 * cos_rocker_phi;
    let pin_b_y_rate = rocker_v_y + t8 - coupler_v_y - t5;
    let pin_c_x_rate = rocker_v_x + t7;
    let pin_c_y_rate = rocker_v_y - t8;
    [pin_o_x_rate, pin_o_y_rate, pin_a_x_rate, pin_a_y_rate, pin_b_x_rate, pin_b_y_rate,
        pin_c_x_rate, pin_c_y_rate]
}

/// `G = dg'/dq'`, values in the order of its pattern. 19 operations.
#[must_use]
pub fn constraint_matrix<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>) -> [R; 24] {
    let [_, _, crank_phi, _, _, coupler_phi, _, _, rocker_phi, ..] = *state;
    let [(sin_crank_phi, cos_crank_phi), (sin_coupler_phi, cos_coupler_phi), (sin_rocker_phi,
        cos_rocker_phi)] = R::sin_cos_each([crank_phi, coupler_phi, rocker_phi]);
    let t0 = R::literal(0.5) * p.crank_length;
    let t1 = t0 * sin_crank_phi;
    let t2 = R::literal(0.5) * p.coupler_length;
    let t3 = t2 * sin_coupler_phi;
    let t4 = R::literal(0.5) * p.rocker_length;
    let t5 = t4 * cos_rocker_phi;
    let t6 = t4 * sin_rocker_phi;
    let t7 = -(t0 * cos_crank_phi);
    let t8 = -(t2 * cos_coupler_phi);
    [R::literal(1.0), t1, R::literal(1.0), t7, R::literal(-1.0), t1, R::literal(1.0), t3,
        R::literal(-1.0), t7, R::literal(1.0), t8, R::literal(-1.0), t3, R::literal(1.0), -t6,
        R::literal(-1.0), t8, R::literal(1.0), t5, R::literal(1.0), t6, R::literal(1.0), -t5]
}

// Emitted by Machinist 0.1.0; do not edit. To make it again:
//
//     cargo run --release -- gen
//
// Sources, with SHA-256:
//   5d872f4d91d720109ea5ca50f877536b1a517c3603286d4a0c07cadaf81cf1ba  scenes/four_bar.toml
//   9870540d48dd190f3f4e3c2fea172f613c63b75b8e7bdb1d3432a0e230aaf646  units/planar_body.toml
//
// Four-bar linkage under gravity
//
// Crank, coupler and rocker pinned to one another and to the frame. Released with a push near its
// upper position, the crank turns over and over without damping.
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
//     prepare 18, prepared_rate 275, prepared_rate_jacobian 892, prepared_jacobians 2144.

use ::machinist_contract::{Energy, PowerBalance, Real};

::machinist_contract::simulator! {
    /// Four-bar linkage under gravity
    ///
    /// Crank, coupler and rocker pinned to one another and to the frame. Released with a push near its
    /// upper position, the crank turns over and over without damping.
    ///
    /// Source: Textbook; Freudenstein's equation.
    FourBar: "four_bar", "Four-bar linkage under gravity";
    run from 0.0, until 2.0, points 2001, rtol 1e-8, method "dop853";
    quadratures 0, discontinuities 0;
    constraints; prepared; jacobians_at_once;
}

::machinist_contract::parameters! {
    base: 0.22, "m", "base", "distance between the pins in the frame";
    angle: 1.5, "rad", "angle", "initial angle of the crank";
    speed: 25.0, "rad/s", "speed", "initial speed of the crank";
    crank_length: 0.1, "m", "crank.length", "length of the bar";
    crank_mass: 0.5, "kg", "crank.mass", "mass";
    crank_inertia: 0.00045, "kg m^2", "crank.inertia", "moment of inertia about the centre of mass";
    crank_gravity: 9.81, "m/s^2", "crank.gravity", "gravitational acceleration";
    coupler_length: 0.25, "m", "coupler.length", "length of the bar";
    coupler_mass: 0.9, "kg", "coupler.mass", "mass";
    coupler_inertia: 0.0047, "kg m^2", "coupler.inertia", "moment of inertia about the centre of mass";
    coupler_gravity: 9.81, "m/s^2", "coupler.gravity", "gravitational acceleration";
    rocker_length: 0.2, "m", "rocker.length", "length of the bar";
    rocker_mass: 0.7, "kg", "rocker.mass", "mass";
    rocker_inertia: 0.0024, "kg m^2", "rocker.inertia", "moment of inertia about the centre of mass";
    rocker_gravity: 9.81, "m/s^2", "rocker.gravity", "gravitational acceleration";
}

::machinist_contract::outputs! {
    crank_angle: "rad", "crank_angle", "angle of the bar from the horizontal";
    coupler_angle: "rad", "coupler_angle", "angle of the bar from the horizontal";
    rocker_angle: "rad", "rocker_angle", "angle of the bar from the horizontal";
    crank_speed: "rad/s", "crank_speed", "rate of angle of the bar from the horizontal";
    pin_force_x: at_once "N", "pin_force_x", "horizontal force of the frame on the crank";
    pin_force_y: at_once "N", "pin_force_y", "upward force of the frame on the crank";
}

::machinist_contract::states! {
    CRANK_X: position guess, 0.1, "m", "crank.x", "horizontal position of the centre of mass";
    CRANK_Y: position guess, 0.1, "m", "crank.y", "height of the centre of mass";
    CRANK_PHI: position, 1.0, "rad", "crank.phi", "angle of the bar from the horizontal";
    COUPLER_X: position guess, 0.1, "m", "coupler.x", "horizontal position of the centre of mass";
    COUPLER_Y: position guess, 0.1, "m", "coupler.y", "height of the centre of mass";
    COUPLER_PHI: position guess, 1.0, "rad", "coupler.phi", "angle of the bar from the horizontal";
    ROCKER_X: position guess, 0.1, "m", "rocker.x", "horizontal position of the centre of mass";
    ROCKER_Y: position guess, 0.1, "m", "rocker.y", "height of the centre of mass";
    ROCKER_PHI: position guess, 1.0, "rad", "rocker.phi", "angle of the bar from the horizontal";
    CRANK_V_X: velocity guess, 1.0, "m/s", "crank.v_x", "rate of horizontal position of the centre of mass";
    CRANK_V_Y: velocity guess, 1.0, "m/s", "crank.v_y", "rate of height of the centre of mass";
    CRANK_OMEGA: velocity, 10.0, "rad/s", "crank.omega", "rate of angle of the bar from the horizontal";
    COUPLER_V_X: velocity guess, 1.0, "m/s", "coupler.v_x", "rate of horizontal position of the centre of mass";
    COUPLER_V_Y: velocity guess, 1.0, "m/s", "coupler.v_y", "rate of height of the centre of mass";
    COUPLER_OMEGA: velocity guess, 10.0, "rad/s", "coupler.omega", "rate of angle of the bar from the horizontal";
    ROCKER_V_X: velocity guess, 1.0, "m/s", "rocker.v_x", "rate of horizontal position of the centre of mass";
    ROCKER_V_Y: velocity guess, 1.0, "m/s", "rocker.v_y", "rate of height of the centre of mass";
    ROCKER_OMEGA: velocity guess, 10.0, "rad/s", "rocker.omega", "rate of angle of the bar from the horizontal";
}

::machinist_contract::constraints! {
    "pin_o_x": of_positions, "m", "the crank's pin in the frame, horizontal";
    "pin_o_y": of_positions, "m", "the crank's pin in the frame, vertical";
    "pin_a_x": of_positions, "m", "pin between crank and coupler, horizontal";
    "pin_a_y": of_positions, "m", "pin between crank and coupler, vertical";
    "pin_b_x": of_positions, "m", "pin between coupler and rocker, horizontal";
    "pin_b_y": of_positions, "m", "pin between coupler and rocker, vertical";
    "pin_c_x": of_positions, "m", "the rocker's pin in the frame, horizontal";
    "pin_c_y": of_positions, "m", "the rocker's pin in the frame, vertical";
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

/// Returns the constants of `rate` and its Jacobians from the parameters. 18 operations.
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

/// `rate_jacobian`, then `parameter_jacobian`, with the constants of the parameters from `prepare`.
/// 2144 operations.
#[must_use]
pub fn prepared_jacobians<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>,
        c: &Constants<R>) -> [R; 171] {
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
    let rocker_omega_squared = rocker_omega * rocker_omega;
    let t64 = c.t2 * rocker_omega_squared;
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
    let coupler_v_y_dot = (-c.t4.add_product(c.inverse_coupler_mass, t81))
        .add_product(c.inverse_coupler_mass, t79);
    let coupler_v_x_dot = (c.inverse_coupler_mass * t80).add_product(c.inverse_coupler_mass,
        pin_a_x);
    let crank_v_y_dot = (-c.t3.add_product(c.inverse_crank_mass, t82))
        .add_product(c.inverse_crank_mass, t81);
    let t172 = R::literal(0.5) * crank_omega_squared;
    let t173 = R::literal(0.5) * sin_crank_phi;
    let t174 = R::literal(0.5) * cos_crank_phi;
    let t175 = (t174 * t82).sub_product(t173, t83).add_product(t173, pin_a_x).add_product(t174,
        t81);
    let t176 = (t172 * cos_crank_phi).add_product(t173, crank_omega_dot).add_product(t6, t175);
    let t177 = (-(t172 * sin_crank_phi)).add_product(t174, crank_omega_dot).add_product(t7, t175)
        .sub_product(t16, t176);
    let t178 = t176.add_product(t18, t176).add_product(t24, t177);
    let t179 = t177.sub_product(t26, t177).add_product(t31, t178);
    let t180 = (t33 * t178).sub_product(t38, t179);
    let t181 = (t34 * t178).sub_product(t40, t179).add_product(t45, t180);
    let t182 = (t47 * t180).sub_product(t52, t181);
    let t183 = (t48 * t180).add_product(t54, t181).add_product(t57, t182) * t58;
    let t184 = (t182 * t55).add_product(t57, t183);
    let t185 = (t181 * t50).sub_product(t52, t184).add_product(t54, t183);
    let t186 = (-(t180 * t42)).add_product(t45, t185).add_product(t47, t184).add_product(t48, t183);
    let t187 = (t179 * t36).sub_product(t38, t186).sub_product(t40, t185);
    let t188 = (t178 * t28).add_product(t31, t187).add_product(t33, t186).add_product(t34, t185);
    let t189 = (t177 * t22).add_product(t24, t188).sub_product(t26, t187);
    let t190 = (t176 * t14).add_product(t16, t189).sub_product(t18, t188).add_product(t16, t187);
    let rocker_omega_dot_by_crank_length = (-(t11 * t185)).add_product(t10, t186).sub_product(t10,
        t184).sub_product(t11, t183);
    let rocker_v_y_dot_by_crank_length = (c.inverse_rocker_mass * t183)
        .sub_product(c.inverse_rocker_mass, t185);
    let rocker_v_x_dot_by_crank_length = -(c.inverse_rocker_mass * t184)
        .add_product(c.inverse_rocker_mass, t186);
    let coupler_omega_dot_by_crank_length = (t9 * t187).add_product(t8, t188).sub_product(t8, t186)
        .add_product(t9, t185);
    let coupler_v_y_dot_by_crank_length = (c.inverse_coupler_mass * t185)
        .sub_product(c.inverse_coupler_mass, t187);
    let coupler_v_x_dot_by_crank_length = (c.inverse_coupler_mass * t186)
        .add_product(c.inverse_coupler_mass, t188);
    let crank_omega_dot_by_crank_length = (t175 * c.inverse_crank_inertia).sub_product(t6, t190)
        .add_product(t7, t189).add_product(t6, t188).add_product(t7, t187);
    let crank_v_y_dot_by_crank_length = (c.inverse_crank_mass * t187)
        .sub_product(c.inverse_crank_mass, t189);
    let crank_v_x_dot_by_crank_length = -(c.inverse_crank_mass * t188)
        .add_product(c.inverse_crank_mass, t190);
    let t191 = c.inverse_crank_mass * (c.inverse_crank_mass * pin_a_x)
        .add_product(c.inverse_crank_mass, t83);
    let t192 = c.inverse_crank_mass * (p.crank_gravity + crank_v_y_dot);
    let t193 = t16 * t191;
    let t194 = t192 - t193;
    let t195 = t191.sub_product(t18, t191).sub_product(t24, t194);
    let t196 = (t192 + t193).add_product(t26, t194).add_product(t31, t195);
    let t197 = (-(t33 * t195)).add_product(t38, t196);
    let t198 = (-(t34 * t195)).add_product(t40, t196).add_product(t45, t197);
    let t199 = (t47 * t197).sub_product(t52, t198);
    let t200 = (t48 * t197).add_product(t54, t198).add_product(t57, t199) * t58;
    let t201 = (t199 * t55).add_product(t57, t200);
    let t202 = (t198 * t50).sub_product(t52, t201).add_product(t54, t200);
    let t203 = (-(t197 * t42)).add_product(t45, t202).add_product(t47, t201).add_product(t48, t200);
    let t204 = (t196 * t36).add_product(t38, t203).add_product(t40, t202);
    let t205 = (t195 * t28).add_product(t31, t204).sub_product(t33, t203).sub_product(t34, t202);
    let t206 = (t194 * t22).sub_product(t24, t205).add_product(t26, t204);
    let t207 = (t191 * t14).add_product(t16, t206).add_product(t18, t205).sub_product(t16, t204);
    let rocker_omega_dot_by_crank_mass = (-(t11 * t202)).add_product(t10, t203).sub_product(t10,
        t201).sub_product(t11, t200);
    let rocker_v_y_dot_by_crank_mass = (c.inverse_rocker_mass * t200)
        .sub_product(c.inverse_rocker_mass, t202);
    let rocker_v_x_dot_by_crank_mass = -(c.inverse_rocker_mass * t201)
        .add_product(c.inverse_rocker_mass, t203);
    let coupler_omega_dot_by_crank_mass = (-(t9 * t204).add_product(t8, t205).add_product(t8, t203))
        .add_product(t9, t202);
    let coupler_v_y_dot_by_crank_mass = (c.inverse_coupler_mass * t202)
        .add_product(c.inverse_coupler_mass, t204);
    let coupler_v_x_dot_by_crank_mass = (c.inverse_coupler_mass * t203)
        .sub_product(c.inverse_coupler_mass, t205);
    let crank_omega_dot_by_crank_mass = (t7 * t206).sub_product(t6, t207).sub_product(t6, t205)
        .sub_product(t7, t204);
    let crank_v_y_dot_by_crank_mass = -t192.add_product(c.inverse_crank_mass, t206)
        .add_product(c.inverse_crank_mass, t204);
    let crank_v_x_dot_by_crank_mass = t191.sub_product(c.inverse_crank_mass, t207)
        .add_product(c.inverse_crank_mass, t205);
    let t208 = t6 * crank_omega_dot;
    let t209 = (-(t7 * crank_omega_dot)).add_product(t16, t208);
    let t210 = t208.add_product(t18, t208).sub_product(t24, t209);
    let t211 = t209.sub_product(t26, t209).sub_product(t31, t210);
    let t212 = (t33 * t210).add_product(t38, t211);
    let t213 = (t34 * t210).add_product(t40, t211).add_product(t45, t212);
    let t214 = (-(t47 * t212)).add_product(t52, t213);
    let t215 = (t48 * t212).add_product(t54, t213).sub_product(t57, t214) * t58;
    let t216 = (t214 * t55).sub_product(t57, t215);
    let t217 = (t213 * t50).add_product(t52, t216).add_product(t54, t215);
    let t218 = (t212 * t42).sub_product(t45, t217).add_product(t47, t216).sub_product(t48, t215);
    let t219 = (t211 * t36).sub_product(t38, t218).add_product(t40, t217);
    let t220 = (t210 * t28).sub_product(t31, t219).sub_product(t33, t218).add_product(t34, t217);
    let t221 = (t209 * t22).sub_product(t24, t220).sub_product(t26, t219);
    let t222 = (-(t208 * t14)).add_product(t16, t221).add_product(t18, t220).add_product(t16, t219);
    let rocker_omega_dot_by_crank_inertia = (t11 * t217).add_product(t10, t218).sub_product(t10,
        t216).add_product(t11, t215);
    let rocker_v_y_dot_by_crank_inertia = (-(c.inverse_rocker_mass * t215))
        .add_product(c.inverse_rocker_mass, t217);
    let rocker_v_x_dot_by_crank_inertia = -(c.inverse_rocker_mass * t216)
        .add_product(c.inverse_rocker_mass, t218);
    let coupler_omega_dot_by_crank_inertia = (t9 * t219).sub_product(t8, t220).sub_product(t8, t218)
        .sub_product(t9, t217);
    let coupler_v_y_dot_by_crank_inertia = -(c.inverse_coupler_mass * t217)
        .add_product(c.inverse_coupler_mass, t219);
    let coupler_v_x_dot_by_crank_inertia = (c.inverse_coupler_mass * t218)
        .sub_product(c.inverse_coupler_mass, t220);
    let crank_omega_dot_by_crank_inertia = (-(crank_omega_dot * c.inverse_crank_inertia)
        .add_product(t6, t222)).add_product(t7, t221).sub_product(t6, t220).add_product(t7, t219);
    let crank_v_y_dot_by_crank_inertia = (c.inverse_crank_mass * t219)
        .sub_product(c.inverse_crank_mass, t221);
    let crank_v_x_dot_by_crank_inertia = (c.inverse_crank_mass * t220)
        .sub_product(c.inverse_crank_mass, t222);
    let t223 = t24 * c.inverse_crank_mass_times_crank_mass;
    let t224 = (-c.inverse_crank_mass_times_crank_mass.add_product(t26,
        c.inverse_crank_mass_times_crank_mass)).add_product(t31, t223);
    let t225 = (t33 * t223).sub_product(t38, t224);
    let t226 = (t34 * t223).sub_product(t40, t224).add_product(t45, t225);
    let t227 = (t47 * t225).sub_product(t52, t226);
    let t228 = (t48 * t225).add_product(t54, t226).add_product(t57, t227) * t58;
    let t229 = (t227 * t55).add_product(t57, t228);
    let t230 = (t226 * t50).sub_product(t52, t229).add_product(t54, t228);
    let t231 = (-(t225 * t42)).add_product(t45, t230).add_product(t47, t229).add_product(t48, t228);
    let t232 = (t224 * t36).sub_product(t38, t231).sub_product(t40, t230);
    let t233 = (t223 * t28).add_product(t31, t232).add_product(t33, t231).add_product(t34, t230);
    let t234 = (c.inverse_crank_mass_times_crank_mass * t22).add_product(t24, t233)
        .sub_product(t26, t232);
    let t235 = (-(t18 * t233)).add_product(t16, t234).add_product(t16, t232);
    let rocker_omega_dot_by_crank_gravity = (-(t11 * t230)).add_product(t10, t231).sub_product(t10,
        t229).sub_product(t11, t228);
    let rocker_v_y_dot_by_crank_gravity = (c.inverse_rocker_mass * t228)
        .sub_product(c.inverse_rocker_mass, t230);
    let rocker_v_x_dot_by_crank_gravity = -(c.inverse_rocker_mass * t229)
        .add_product(c.inverse_rocker_mass, t231);
    let coupler_omega_dot_by_crank_gravity = (t9 * t232).add_product(t8, t233).sub_product(t8, t231)
        .add_product(t9, t230);
    let coupler_v_y_dot_by_crank_gravity = (c.inverse_coupler_mass * t230)
        .sub_product(c.inverse_coupler_mass, t232);
    let coupler_v_x_dot_by_crank_gravity = (c.inverse_coupler_mass * t231)
        .add_product(c.inverse_coupler_mass, t233);
    let crank_omega_dot_by_crank_gravity = (t7 * t234).sub_product(t6, t235).add_product(t6, t233)
        .add_product(t7, t232);
    let crank_v_y_dot_by_crank_gravity = (-c.inverse_crank_mass_times_crank_mass
        .add_product(c.inverse_crank_mass, t234)).add_product(c.inverse_crank_mass, t232);
    let crank_v_x_dot_by_crank_gravity = -(c.inverse_crank_mass * t233)
        .add_product(c.inverse_crank_mass, t235);
    let t236 = R::literal(0.5) * coupler_omega_squared;
    let t237 = R::literal(0.5) * sin_coupler_phi;
    let t238 = R::literal(0.5) * cos_coupler_phi;
    let t239 = (t238 * t81).add_product(t237, pin_a_x).sub_product(t237, t80).add_product(t238,
        t79);
    let t240 = (t236 * cos_coupler_phi).add_product(t237, coupler_omega_dot).add_product(t8, t239);
    let t241 = (-(t236 * sin_coupler_phi)).add_product(t238, coupler_omega_dot).add_product(t9,
        t239);
    let t242 = t241.add_product(t31, t240);
    let t243 = (-t240).add_product(t33, t240).sub_product(t38, t242);
    let t244 = t241.add_product(t34, t240).sub_product(t40, t242).add_product(t45, t243);
    let t245 = (t47 * t243).sub_product(t52, t244);
    let t246 = (t48 * t243).add_product(t54, t244).add_product(t57, t245) * t58;
    let t247 = (t245 * t55).add_product(t57, t246);
    let t248 = (t244 * t50).sub_product(t52, t247).add_product(t54, t246);
    let t249 = (-(t243 * t42)).add_product(t45, t248).add_product(t47, t247).add_product(t48, t246);
    let t250 = (t242 * t36).sub_product(t38, t249).sub_product(t40, t248);
    let t251 = (t240 * t28).add_product(t31, t250).add_product(t33, t249).add_product(t34, t248);
    let t252 = (-(t26 * t250)).add_product(t24, t251);
    let t253 = (-(t18 * t251)).add_product(t16, t252).add_product(t16, t250);
    let rocker_omega_dot_by_coupler_length = (-(t11 * t248)).add_product(t10, t249)
        .sub_product(t10, t247).sub_product(t11, t246);
    let rocker_v_y_dot_by_coupler_length = (c.inverse_rocker_mass * t246)
        .sub_product(c.inverse_rocker_mass, t248);
    let rocker_v_x_dot_by_coupler_length = -(c.inverse_rocker_mass * t247)
        .add_product(c.inverse_rocker_mass, t249);
    let coupler_omega_dot_by_coupler_length = (t239 * c.inverse_coupler_inertia).add_product(t8,
        t251).add_product(t9, t250).sub_product(t8, t249).add_product(t9, t248);
    let coupler_v_y_dot_by_coupler_length = (c.inverse_coupler_mass * t248)
        .sub_product(c.inverse_coupler_mass, t250);
    let coupler_v_x_dot_by_coupler_length = (c.inverse_coupler_mass * t249)
        .add_product(c.inverse_coupler_mass, t251);
    let crank_omega_dot_by_coupler_length = (t7 * t252).sub_product(t6, t253).add_product(t6, t251)
        .add_product(t7, t250);
    let crank_v_y_dot_by_coupler_length = (c.inverse_crank_mass * t250)
        .sub_product(c.inverse_crank_mass, t252);
    let crank_v_x_dot_by_coupler_length = -(c.inverse_crank_mass * t251)
        .add_product(c.inverse_crank_mass, t253);
    let t254 = c.inverse_coupler_mass * coupler_v_x_dot;
    let t255 = c.inverse_coupler_mass * (p.coupler_gravity + coupler_v_y_dot);
    let t256 = t255.sub_product(t31, t254);
    let t257 = t254.add_product(t33, t254).add_product(t38, t256);
    let t258 = t255.add_product(t34, t254).add_product(t40, t256).add_product(t45, t257);
    let t259 = (-(t47 * t257)).add_product(t52, t258);
    let t260 = (t48 * t257).add_product(t54, t258).sub_product(t57, t259) * t58;
    let t261 = (t259 * t55).sub_product(t57, t260);
    let t262 = (t258 * t50).add_product(t52, t261).add_product(t54, t260);
    let t263 = (t257 * t42).sub_product(t45, t262).add_product(t47, t261).sub_product(t48, t260);
    let t264 = (t256 * t36).sub_product(t38, t263).add_product(t40, t262);
    let t265 = (t254 * t28).sub_product(t31, t264).sub_product(t33, t263).add_product(t34, t262);
    let t266 = (t26 * t264).add_product(t24, t265);
    let t267 = (t18 * t265).sub_product(t16, t266).add_product(t16, t264);
    let rocker_omega_dot_by_coupler_mass = (t11 * t262).add_product(t10, t263).sub_product(t10,
        t261).add_product(t11, t260);
    let rocker_v_y_dot_by_coupler_mass = (-(c.inverse_rocker_mass * t260))
        .add_product(c.inverse_rocker_mass, t262);
    let rocker_v_x_dot_by_coupler_mass = -(c.inverse_rocker_mass * t261)
        .add_product(c.inverse_rocker_mass, t263);
    let coupler_omega_dot_by_coupler_mass = (t9 * t264).sub_product(t8, t265).sub_product(t8, t263)
        .sub_product(t9, t262);
    let coupler_v_y_dot_by_coupler_mass = -t255.add_product(c.inverse_coupler_mass, t264)
        .add_product(c.inverse_coupler_mass, t262);
    let coupler_v_x_dot_by_coupler_mass = (-t254.add_product(c.inverse_coupler_mass, t265))
        .add_product(c.inverse_coupler_mass, t263);
    let crank_omega_dot_by_coupler_mass = (-(t7 * t266).add_product(t6, t267).add_product(t6, t265))
        .add_product(t7, t264);
    let crank_v_y_dot_by_coupler_mass = (c.inverse_crank_mass * t264)
        .add_product(c.inverse_crank_mass, t266);
    let crank_v_x_dot_by_coupler_mass = (c.inverse_crank_mass * t265)
        .sub_product(c.inverse_crank_mass, t267);
    let t268 = t8 * coupler_omega_dot;
    let t269 = t9 * coupler_omega_dot;
    let t270 = t269.add_product(t31, t268);
    let t271 = t268.sub_product(t33, t268).add_product(t38, t270);
    let t272 = (-t269.add_product(t34, t268)).add_product(t40, t270).add_product(t45, t271);
    let t273 = (t47 * t271).sub_product(t52, t272);
    let t274 = (t48 * t271).add_product(t54, t272).add_product(t57, t273) * t58;
    let t275 = (t273 * t55).add_product(t57, t274);
    let t276 = (t272 * t50).sub_product(t52, t275).add_product(t54, t274);
    let t277 = (-(t271 * t42)).add_product(t45, t276).add_product(t47, t275).add_product(t48, t274);
    let t278 = (t270 * t36).add_product(t38, t277).add_product(t40, t276);
    let t279 = (t268 * t28).add_product(t31, t278).sub_product(t33, t277).sub_product(t34, t276);
    let t280 = (t26 * t278).sub_product(t24, t279);
    let t281 = (t18 * t279).add_product(t16, t280).sub_product(t16, t278);
    let rocker_omega_dot_by_coupler_inertia = (-(t11 * t276)).add_product(t10, t277)
        .sub_product(t10, t275).sub_product(t11, t274);
    let rocker_v_y_dot_by_coupler_inertia = (c.inverse_rocker_mass * t274)
        .sub_product(c.inverse_rocker_mass, t276);
    let rocker_v_x_dot_by_coupler_inertia = -(c.inverse_rocker_mass * t275)
        .add_product(c.inverse_rocker_mass, t277);
    let coupler_omega_dot_by_coupler_inertia = (-(coupler_omega_dot * c.inverse_coupler_inertia)
        .add_product(t8, t279).add_product(t9, t278).add_product(t8, t277)).add_product(t9, t276);
    let coupler_v_y_dot_by_coupler_inertia = (c.inverse_coupler_mass * t276)
        .add_product(c.inverse_coupler_mass, t278);
    let coupler_v_x_dot_by_coupler_inertia = (c.inverse_coupler_mass * t277)
        .sub_product(c.inverse_coupler_mass, t279);
    let crank_omega_dot_by_coupler_inertia = (t7 * t280).sub_product(t6, t281).sub_product(t6, t279)
        .sub_product(t7, t278);
    let crank_v_y_dot_by_coupler_inertia = -(c.inverse_crank_mass * t278)
        .add_product(c.inverse_crank_mass, t280);
    let crank_v_x_dot_by_coupler_inertia = (c.inverse_crank_mass * t279)
        .sub_product(c.inverse_crank_mass, t281);
    let t282 = t38 * c.t6;
    let t283 = c.t6.add_product(t40, c.t6).add_product(t45, t282);
    let t284 = (-(t47 * t282)).add_product(t52, t283);
    let t285 = (t48 * t282).add_product(t54, t283).sub_product(t57, t284) * t58;
    let t286 = (t284 * t55).sub_product(t57, t285);
    let t287 = (t283 * t50).add_product(t52, t286).add_product(t54, t285);
    let t288 = (t282 * t42).sub_product(t45, t287).add_product(t47, t286).sub_product(t48, t285);
    let t289 = (c.t6 * t36).sub_product(t38, t288).add_product(t40, t287);
    let t290 = (-(t33 * t288).add_product(t31, t289)).add_product(t34, t287);
    let t291 = (t26 * t289).add_product(t24, t290);
    let t292 = (t18 * t290).sub_product(t16, t291).add_product(t16, t289);
    let rocker_omega_dot_by_coupler_gravity = (t11 * t287).add_product(t10, t288).sub_product(t10,
        t286).add_product(t11, t285);
    let rocker_v_y_dot_by_coupler_gravity = (-(c.inverse_rocker_mass * t285))
        .add_product(c.inverse_rocker_mass, t287);
    let rocker_v_x_dot_by_coupler_gravity = -(c.inverse_rocker_mass * t286)
        .add_product(c.inverse_rocker_mass, t288);
    let coupler_omega_dot_by_coupler_gravity = (t9 * t289).sub_product(t8, t290).sub_product(t8,
        t288).sub_product(t9, t287);
    let coupler_v_y_dot_by_coupler_gravity = -c.t6.add_product(c.inverse_coupler_mass, t289)
        .add_product(c.inverse_coupler_mass, t287);
    let coupler_v_x_dot_by_coupler_gravity = (c.inverse_coupler_mass * t288)
        .sub_product(c.inverse_coupler_mass, t290);
    let crank_omega_dot_by_coupler_gravity = (-(t7 * t291).add_product(t6, t292).add_product(t6,
        t290)).add_product(t7, t289);
    let crank_v_y_dot_by_coupler_gravity = (c.inverse_crank_mass * t289)
        .add_product(c.inverse_crank_mass, t291);
    let crank_v_x_dot_by_coupler_gravity = (c.inverse_crank_mass * t290)
        .sub_product(c.inverse_crank_mass, t292);
    let t293 = R::literal(0.5) * rocker_omega_squared;
    let t294 = t293 * sin_rocker_phi;
    let t295 = R::literal(0.5) * sin_rocker_phi;
    let t296 = R::literal(0.5) * cos_rocker_phi;
    let t297 = t296 * rocker_omega_dot;
    let t298 = (-(t296 * t79)).add_product(t295, t80).sub_product(t295, t78).add_product(t296, t77);
    let t299 = (t293 * cos_rocker_phi).add_product(t295, rocker_omega_dot).add_product(t10, t298);
    let t300 = t11 * t298;
    let t301 = (t294 - t297 - t300).add_product(t45, t299);
    let t302 = (-t299).add_product(t47, t299).sub_product(t52, t301);
    let t303 = (t297 - t294 + t300).sub_product(t48, t299).sub_product(t54, t301).sub_product(t57,
        t302) * t58;
    let t304 = (t302 * t55).sub_product(t57, t303);
    let t305 = (t301 * t50).sub_product(t52, t304).sub_product(t54, t303);
    let t306 = (-(t299 * t42)).add_product(t45, t305).add_product(t47, t304).sub_product(t48, t303);
    let t307 = (t40 * t305).add_product(t38, t306);
    let t308 = (-(t33 * t306)).add_product(t31, t307).sub_product(t34, t305);
    let t309 = (t26 * t307).sub_product(t24, t308);
    let t310 = (t18 * t308).add_product(t16, t309).sub_product(t16, t307);
    let rocker_omega_dot_by_rocker_length = (t298 * c.inverse_rocker_inertia).add_product(t10, t306)
        .sub_product(t11, t305).sub_product(t10, t304).add_product(t11, t303);
    let rocker_v_y_dot_by_rocker_length = -(c.inverse_rocker_mass * t303)
        .add_product(c.inverse_rocker_mass, t305);
    let rocker_v_x_dot_by_rocker_length = -(c.inverse_rocker_mass * t304)
        .add_product(c.inverse_rocker_mass, t306);
    let coupler_omega_dot_by_rocker_length = (-(t9 * t307).add_product(t8, t308).add_product(t8,
        t306)).add_product(t9, t305);
    let coupler_v_y_dot_by_rocker_length = (c.inverse_coupler_mass * t305)
        .add_product(c.inverse_coupler_mass, t307);
    let coupler_v_x_dot_by_rocker_length = (c.inverse_coupler_mass * t306)
        .sub_product(c.inverse_coupler_mass, t308);
    let crank_omega_dot_by_rocker_length = (t7 * t309).sub_product(t6, t310).sub_product(t6, t308)
        .sub_product(t7, t307);
    let crank_v_y_dot_by_rocker_length = -(c.inverse_crank_mass * t307)
        .add_product(c.inverse_crank_mass, t309);
    let crank_v_x_dot_by_rocker_length = (c.inverse_crank_mass * t308)
        .sub_product(c.inverse_crank_mass, t310);
    let t311 = c.inverse_rocker_mass * (c.inverse_rocker_mass * t78)
        .add_product(c.inverse_rocker_mass, t80);
    let t312 = c.inverse_rocker_mass * (c.t5.add_product(c.inverse_rocker_mass, t79)
        .add_product(c.inverse_rocker_mass, t77) - p.rocker_gravity);
    let t313 = t312.add_product(t45, t311);
    let t314 = (-t311.add_product(t47, t311)).add_product(t52, t313);
    let t315 = (-t312).add_product(t48, t311).add_product(t54, t313).sub_product(t57, t314) * t58;
    let t316 = (t314 * t55).sub_product(t57, t315);
    let t317 = (t313 * t50).add_product(t52, t316).add_product(t54, t315);
    let t318 = (t311 * t42).sub_product(t45, t317).add_product(t47, t316).sub_product(t48, t315);
    let t319 = (t40 * t317).sub_product(t38, t318);
    let t320 = (-(t33 * t318).add_product(t31, t319)).add_product(t34, t317);
    let t321 = (t26 * t319).add_product(t24, t320);
    let t322 = (t18 * t320).sub_product(t16, t321).add_product(t16, t319);
    let rocker_omega_dot_by_rocker_mass = (t11 * t317).add_product(t10, t318).sub_product(t10, t316)
        .add_product(t11, t315);
    let rocker_v_y_dot_by_rocker_mass = t312.add_product(c.inverse_rocker_mass, t317)
        .sub_product(c.inverse_rocker_mass, t315);
    let rocker_v_x_dot_by_rocker_mass = t311.sub_product(c.inverse_rocker_mass, t318)
        .sub_product(c.inverse_rocker_mass, t316);
    let coupler_omega_dot_by_rocker_mass = (t9 * t319).sub_product(t8, t320).sub_product(t8, t318)
        .sub_product(t9, t317);
    let coupler_v_y_dot_by_rocker_mass = -(c.inverse_coupler_mass * t317)
        .add_product(c.inverse_coupler_mass, t319);
    let coupler_v_x_dot_by_rocker_mass = (c.inverse_coupler_mass * t318)
        .sub_product(c.inverse_coupler_mass, t320);
    let crank_omega_dot_by_rocker_mass = (-(t7 * t321).add_product(t6, t322).add_product(t6, t320))
        .add_product(t7, t319);
    let crank_v_y_dot_by_rocker_mass = (c.inverse_crank_mass * t319)
        .add_product(c.inverse_crank_mass, t321);
    let crank_v_x_dot_by_rocker_mass = (c.inverse_crank_mass * t320)
        .sub_product(c.inverse_crank_mass, t322);
    let t323 = t10 * rocker_omega_dot;
    let t324 = t11 * rocker_omega_dot;
    let t325 = t324.sub_product(t45, t323);
    let t326 = t323.sub_product(t47, t323).sub_product(t52, t325);
    let t327 = (-t324).add_product(t48, t323).sub_product(t54, t325).sub_product(t57, t326) * t58;
    let t328 = (t326 * t55).sub_product(t57, t327);
    let t329 = (t325 * t50).sub_product(t52, t328).sub_product(t54, t327);
    let t330 = (t323 * t42).add_product(t45, t329).add_product(t47, t328).sub_product(t48, t327);
    let t331 = (t40 * t329).add_product(t38, t330);
    let t332 = (-(t33 * t330)).add_product(t31, t331).sub_product(t34, t329);
    let t333 = (t26 * t331).sub_product(t24, t332);
    let t334 = (t18 * t332).add_product(t16, t333).sub_product(t16, t331);
    let rocker_omega_dot_by_rocker_inertia = (-(rocker_omega_dot * c.inverse_rocker_inertia))
        .add_product(t10, t330).sub_product(t11, t329).sub_product(t10, t328).add_product(t11,
        t327);
    let rocker_v_y_dot_by_rocker_inertia = -(c.inverse_rocker_mass * t327)
        .add_product(c.inverse_rocker_mass, t329);
    let rocker_v_x_dot_by_rocker_inertia = -(c.inverse_rocker_mass * t328)
        .add_product(c.inverse_rocker_mass, t330);
    let coupler_omega_dot_by_rocker_inertia = (-(t9 * t331).add_product(t8, t332).add_product(t8,
        t330)).add_product(t9, t329);
    let coupler_v_y_dot_by_rocker_inertia = (c.inverse_coupler_mass * t329)
        .add_product(c.inverse_coupler_mass, t331);
    let coupler_v_x_dot_by_rocker_inertia = (c.inverse_coupler_mass * t330)
        .sub_product(c.inverse_coupler_mass, t332);
    let crank_omega_dot_by_rocker_inertia = (t7 * t333).sub_product(t6, t334).sub_product(t6, t332)
        .sub_product(t7, t331);
    let crank_v_y_dot_by_rocker_inertia = -(c.inverse_crank_mass * t331)
        .add_product(c.inverse_crank_mass, t333);
    let crank_v_x_dot_by_rocker_inertia = (c.inverse_crank_mass * t332)
        .sub_product(c.inverse_crank_mass, t334);
    let t335 = t52 * c.t7;
    let t336 = c.t7.sub_product(t54, c.t7).add_product(t57, t335) * t58;
    let t337 = (t335 * t55).add_product(t57, t336);
    let t338 = (c.t7 * t50).add_product(t52, t337).sub_product(t54, t336);
    let t339 = (-(t47 * t337)).add_product(t45, t338).sub_product(t48, t336);
    let t340 = (t40 * t338).add_product(t38, t339);
    let t341 = (-(t33 * t339)).add_product(t31, t340).sub_product(t34, t338);
    let t342 = (t26 * t340).sub_product(t24, t341);
    let t343 = (t18 * t341).add_product(t16, t342).sub_product(t16, t340);
    let rocker_omega_dot_by_rocker_gravity = (-(t11 * t338)).add_product(t10, t339)
        .add_product(t10, t337).add_product(t11, t336);
    let rocker_v_y_dot_by_rocker_gravity = -c.t7.add_product(c.inverse_rocker_mass, t338)
        .add_product(c.inverse_rocker_mass, t336);
    let rocker_v_x_dot_by_rocker_gravity = (c.inverse_rocker_mass * t337)
        .sub_product(c.inverse_rocker_mass, t339);
    let coupler_omega_dot_by_rocker_gravity = (-(t9 * t340).add_product(t8, t341).add_product(t8,
        t339)).add_product(t9, t338);
    let coupler_v_y_dot_by_rocker_gravity = (c.inverse_coupler_mass * t338)
        .add_product(c.inverse_coupler_mass, t340);
    let coupler_v_x_dot_by_rocker_gravity = (c.inverse_coupler_mass * t339)
        .sub_product(c.inverse_coupler_mass, t341);
    let crank_omega_dot_by_rocker_gravity = (t7 * t342).sub_product(t6, t343).sub_product(t6, t341)
        .sub_product(t7, t340);
    let crank_v_y_dot_by_rocker_gravity = -(c.inverse_crank_mass * t340)
        .add_product(c.inverse_crank_mass, t342);
    let crank_v_x_dot_by_rocker_gravity = (c.inverse_crank_mass * t341)
        .sub_product(c.inverse_crank_mass, t343);
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
        rocker_omega_dot_by_rocker_omega, crank_v_x_dot_by_crank_length,
        crank_v_x_dot_by_crank_mass, crank_v_x_dot_by_crank_inertia,
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

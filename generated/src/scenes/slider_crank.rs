// Emitted by Machinist 0.1.0; do not edit. To make it again:
//
//     cargo run --release -- gen
//
// Sources, with SHA-256:
//   5aa30d4253a9899d4f39237de04cfe3095f1ceeaee0ffeccd40e4148beadb747  scenes/slider_crank.toml
//   fa69a391ab85c57533a93c32c47f18b29da038e678b6c6fe99931f82ce4979fa  units/planar_body.toml
//
// Slider-crank turned at constant speed
//
// Crank, rod and slider as three bodies in a plane, held together by pins, a guide and a
// drive that turns the crank. The force of the drive's constraint is the torque it takes.
//
// Source:
//   Textbook.
//
// All quantities are in SI units.
// Shapes: coordinates 8, states 16, parameters 12, outputs 7, constraints 8.
// Nonzeros: mass_matrix 8 of 8 by 8, rate_jacobian 40 of 16 by 16, parameter_jacobian 80 of 16 by 12,
//     constraint_matrix 20 of 8 by 8.
// Operations: rate 287, forcing 6, rate_jacobian 728, parameter_jacobian 1340, outputs 221,
//     energy 33, power_balance 316, constraint_values 25, constraint_rates 25, constraint_matrix 12,
//     prepare 13, prepared_rate 274, prepared_rate_jacobian 715.

use ::machinist_contract::{Energy, PowerBalance, Real};

::machinist_contract::simulator! {
    /// Slider-crank turned at constant speed
    ///
    /// Crank, rod and slider as three bodies in a plane, held together by pins, a guide and a
    /// drive that turns the crank. The force of the drive's constraint is the torque it takes.
    ///
    /// Source: Textbook.
    SliderCrank: "slider_crank", "Slider-crank turned at constant speed";
    run from 0.0, until 1.0, points 1001, rtol 1e-8, method "dop853";
    quadratures 0, discontinuities 0;
    constraints; prepared;
}

::machinist_contract::parameters! {
    speed: 30.0, "rad/s", "speed", "speed of the crank";
    start: 0.4, "rad", "start", "angle of the crank at the start";
    crank_length: 0.05, "m", "crank.length", "length of the bar";
    crank_mass: 0.8, "kg", "crank.mass", "the mass";
    crank_inertia: 0.0002, "kg m^2", "crank.inertia", "moment of inertia about the centre of mass";
    crank_gravity: 9.81, "m/s^2", "crank.gravity", "acceleration of free fall";
    rod_length: 0.2, "m", "rod.length", "length of the bar";
    rod_mass: 0.6, "kg", "rod.mass", "the mass";
    rod_inertia: 0.002, "kg m^2", "rod.inertia", "moment of inertia about the centre of mass";
    rod_gravity: 9.81, "m/s^2", "rod.gravity", "acceleration of free fall";
    slider_mass: 1.1, "kg", "slider.mass", "the mass";
    slider_gravity: 9.81, "m/s^2", "slider.gravity", "acceleration of free fall";
}

::machinist_contract::outputs! {
    angle: "rad", "angle", "angle of the bar from sideways";
    rod_angle: "rad", "rod_angle", "angle of the bar from sideways";
    stroke: "m", "stroke", "centre of mass, sideways";
    slider_speed: "m/s", "slider_speed", "rate of centre of mass, sideways";
    slider_acceleration: "m/s^2", "slider_acceleration", "acceleration of the slider";
    torque: "N m", "torque", "torque of the drive on the crank";
    guide_force: "N", "guide_force", "force of the guide on the slider, upwards";
}

::machinist_contract::states! {
    CRANK_X: position guess, 0.1, "m", "crank.x", "centre of mass, sideways";
    CRANK_Y: position guess, 0.1, "m", "crank.y", "centre of mass, upwards";
    CRANK_PHI: position guess, 1.0, "rad", "crank.phi", "angle of the bar from sideways";
    ROD_X: position guess, 0.1, "m", "rod.x", "centre of mass, sideways";
    ROD_Y: position guess, 0.1, "m", "rod.y", "centre of mass, upwards";
    ROD_PHI: position guess, 1.0, "rad", "rod.phi", "angle of the bar from sideways";
    SLIDER_X: position guess, 0.1, "m", "slider.x", "centre of mass, sideways";
    SLIDER_Y: position guess, 0.1, "m", "slider.y", "centre of mass, upwards";
    CRANK_V_X: velocity guess, 1.0, "m/s", "crank.v_x", "rate of centre of mass, sideways";
    CRANK_V_Y: velocity guess, 1.0, "m/s", "crank.v_y", "rate of centre of mass, upwards";
    CRANK_OMEGA: velocity guess, 10.0, "rad/s", "crank.omega", "rate of angle of the bar from sideways";
    ROD_V_X: velocity guess, 1.0, "m/s", "rod.v_x", "rate of centre of mass, sideways";
    ROD_V_Y: velocity guess, 1.0, "m/s", "rod.v_y", "rate of centre of mass, upwards";
    ROD_OMEGA: velocity guess, 10.0, "rad/s", "rod.omega", "rate of angle of the bar from sideways";
    SLIDER_V_X: velocity guess, 1.0, "m/s", "slider.v_x", "rate of centre of mass, sideways";
    SLIDER_V_Y: velocity guess, 1.0, "m/s", "slider.v_y", "rate of centre of mass, upwards";
}

::machinist_contract::constraints! {
    "pin_o_x": of_positions, "m", "the crank's pin in the frame, sideways";
    "pin_o_y": of_positions, "m", "the crank's pin in the frame, upwards";
    "pin_a_x": of_positions, "m", "pin between crank and rod, sideways";
    "pin_a_y": of_positions, "m", "pin between crank and rod, upwards";
    "pin_b_x": of_positions, "m", "pin between rod and slider, sideways";
    "pin_b_y": of_positions, "m", "pin between rod and slider, upwards";
    "guide": of_positions, "m", "the slider on its guide";
    "drive": of_positions, "1", "the crank turns at constant speed";
}

::machinist_contract::patterns! {
    /// Nonzeros of M.
    MASS_MATRIX_PATTERN: 8 by 8 { 0 [0] 1 [1] 2 [2] 3 [3] 4 [4] 5 [5] 6 [6] 7 [7] }
    /// Nonzeros of dy'/dy.
    RATE_JACOBIAN_PATTERN: 16 by 16 { 0 [8] 1 [9] 2 [10] 3 [11] 4 [12] 5 [13] 6 [14] 7 [15]
        8 [2 5 10 13] 9 [2 5 10 13] 10 [2 5 10 13] 11 [2 5 10 13] 12 [2 5 10 13] 13 [2 5 10 13]
        14 [2 5 10 13] 15 [2 5 10 13] }
    /// Nonzeros of dy'/dp.
    PARAMETER_JACOBIAN_PATTERN: 16 by 12 { 8 [2 3 4 5 6 7 8 9 10 11] 9 [2 3 4 5 6 7 8 9 10 11]
        10 [2 3 4 5 6 7 8 9 10 11] 11 [2 3 4 5 6 7 8 9 10 11] 12 [2 3 4 5 6 7 8 9 10 11]
        13 [2 3 4 5 6 7 8 9 10 11] 14 [2 3 4 5 6 7 8 9 10 11] 15 [2 3 4 5 6 7 8 9 10 11] }
    /// Nonzeros of G = dg'/dq'.
    CONSTRAINT_MATRIX_PATTERN: 8 by 8 { 0 [0 2] 1 [1 2] 2 [0 2 3 5] 3 [1 2 4 5] 4 [3 5 6] 5 [4 5 7]
        6 [7] 7 [2] }
}

::machinist_contract::constants! {
    t0, t1, inverse_crank_mass, inverse_crank_inertia, inverse_rod_mass, inverse_rod_inertia,
    inverse_slider_mass, t2, t3, t4
}

/// What `rate` and `rate_jacobian` need of the parameters, once a run. 13 operations.
#[must_use]
#[inline]
pub fn prepare<R: Real>(p: &Parameters<R>) -> Constants<R> {
    let t0 = R::literal(0.5) * p.crank_length;
    let t1 = R::literal(0.5) * p.rod_length;
    let inverse_crank_mass = R::literal(1.0) / p.crank_mass;
    let inverse_crank_inertia = R::literal(1.0) / p.crank_inertia;
    let inverse_rod_mass = R::literal(1.0) / p.rod_mass;
    let inverse_rod_inertia = R::literal(1.0) / p.rod_inertia;
    let inverse_slider_mass = R::literal(1.0) / p.slider_mass;
    let t2 = inverse_crank_mass * (p.crank_mass * p.crank_gravity);
    let t3 = inverse_rod_mass * (p.rod_mass * p.rod_gravity);
    let t4 = inverse_slider_mass * (p.slider_mass * p.slider_gravity);
    Constants { t0, t1, inverse_crank_mass, inverse_crank_inertia, inverse_rod_mass,
        inverse_rod_inertia, inverse_slider_mass, t2, t3, t4 }
}

/// State at the start of the run, in the units of the states. No operations.
#[must_use]
pub fn initial_state<R: Real>(_p: &Parameters<R>) -> [R; STATES] {
    [R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.15), R::literal(0.0),
        R::literal(-0.1), R::literal(0.24), R::literal(0.0), R::literal(0.0), R::literal(0.0),
        R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0),
        R::literal(0.0)]
}

/// Times of known jumps of the right-hand side \[s\], unsorted. No operations.
#[must_use]
pub fn discontinuities<R: Real>(_p: &Parameters<R>) -> [R; DISCONTINUITIES] {
    []
}

/// As `rate`, with the constants of the parameters from `prepare`. 274 operations.
#[must_use]
#[inline]
pub fn prepared_rate<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>,
        c: &Constants<R>) -> [R; STATES] {
    let [_, _, crank_phi, _, _, rod_phi, _, _, crank_v_x, crank_v_y, crank_omega, rod_v_x, rod_v_y,
        rod_omega, slider_v_x, slider_v_y] = *state;
    let [(sin_crank_phi, cos_crank_phi), (sin_rod_phi, cos_rod_phi)] = R::sin_cos_each([crank_phi,
        rod_phi]);
    let t0 = c.t0 * cos_crank_phi;
    let t1 = c.t0 * sin_crank_phi;
    let t2 = c.t1 * cos_rod_phi;
    let t3 = c.t1 * sin_rod_phi;
    let t4 = t1 * c.inverse_crank_inertia;
    let t5 = t0 * c.inverse_crank_inertia;
    let t6 = t3 * c.inverse_rod_inertia;
    let t7 = t2 * c.inverse_rod_inertia;
    let t8 = t4 * t1;
    let t9 = c.inverse_crank_mass + t8;
    let t10 = R::literal(1.0) / t9;
    let t11 = t5 * t1;
    let t12 = t11 * t10;
    let t13 = c.inverse_crank_mass - t8;
    let t14 = t13 * t10;
    let t15 = t4 * t10;
    let t16 = t5 * t0;
    let t17 = c.inverse_crank_mass + t16;
    let t18 = t12 * t11;
    let t19 = R::literal(1.0) / (t18 - t17);
    let t20 = (t4 * t0).add_product(t14, t11);
    let t21 = t20 * t19;
    let t22 = c.inverse_crank_mass - t16 + t18;
    let t23 = t22 * t19;
    let t24 = t5.sub_product(t15, t11);
    let t25 = t24 * t19;
    let t26 = t6 * t3;
    let t27 = R::literal(1.0) / (-(t9 + c.inverse_rod_mass + t26)).add_product(t14, t13)
        .sub_product(t21, t20);
    let t28 = t7 * t3;
    let t29 = (t11 + t28).add_product(t12, t13).sub_product(t23, t20);
    let t30 = t29 * t27;
    let t31 = c.inverse_rod_mass - t26;
    let t32 = t31 * t27;
    let t33 = t28 * t27;
    let t34 = t4.add_product(t15, t13).add_product(t25, t20);
    let t35 = t34 * t27;
    let t36 = t7 * t2;
    let t37 = R::literal(1.0) / (t18 - (t17 + c.inverse_rod_mass + t36)).sub_product(t23, t22)
        .sub_product(t30, t29);
    let t38 = (t6 * t2).sub_product(t32, t29);
    let t39 = t38 * t37;
    let t40 = (c.inverse_rod_mass - t36).sub_product(t33, t29);
    let t41 = t40 * t37;
    let t42 = t24.sub_product(t25, t22).add_product(t35, t29);
    let t43 = t42 * t37;
    let t44 = R::literal(1.0) / (c.inverse_rod_mass + t26 + c.inverse_slider_mass).add_product(t32,
        t31).add_product(t39, t38);
    let t45 = t28.sub_product(t33, t31).sub_product(t41, t38);
    let t46 = t45 * t44;
    let t47 = (t35 * t31).sub_product(t43, t38);
    let t48 = t47 * t44;
    let t49 = R::literal(1.0) / (-(c.inverse_rod_mass + t36 + c.inverse_slider_mass)
        .add_product(t33, t28).add_product(t41, t40)).add_product(t46, t45);
    let t50 = c.inverse_slider_mass * t49;
    let t51 = (t35 * t28).sub_product(t43, t40).add_product(t48, t45);
    let t52 = t51 * t49;
    let t53 = R::literal(1.0) / c.inverse_slider_mass.add_product(t50, c.inverse_slider_mass);
    let t54 = t52 * c.inverse_slider_mass;
    let t55 = t54 * t53;
    let crank_omega_squared = crank_omega * crank_omega;
    let t56 = c.t0 * crank_omega_squared;
    let t57 = t56 * cos_crank_phi;
    let t58 = p.crank_length * crank_omega_squared;
    let rod_omega_squared = rod_omega * rod_omega;
    let rod_length_times_rod_omega_squared = p.rod_length * rod_omega_squared;
    let t59 = c.t1 * rod_omega_squared;
    let t60 = t12 * t57;
    let t61 = c.t2.sub_product(t56, sin_crank_phi) - t60;
    let t62 = (R::literal(0.5) * (t58 * cos_crank_phi)
        .add_product(rod_length_times_rod_omega_squared, cos_rod_phi)).add_product(t14, t57)
        .add_product(t21, t61);
    let t63 = (c.t3 - c.t2.add_product(R::literal(0.5), (t58 * sin_crank_phi)
        .add_product(rod_length_times_rod_omega_squared, sin_rod_phi)) - t60).sub_product(t23, t61)
        .add_product(t30, t62);
    let t64 = (-(t59 * cos_rod_phi)).add_product(t32, t62).sub_product(t39, t63);
    let t65 = (c.t4 - c.t3.add_product(t59, sin_rod_phi)).add_product(t33, t62).sub_product(t41,
        t63).add_product(t46, t64);
    let t66 = c.t4.add_product(t50, t65);
    let t67 = (t15 * t57).sub_product(t25, t61).sub_product(t35, t62).sub_product(t43, t63)
        .add_product(t48, t64).sub_product(t52, t65).add_product(t55, t66) * (R::literal(1.0)
        / (-c.inverse_crank_inertia).add_product(t15, t4).sub_product(t25, t24).sub_product(t35,
        t34).sub_product(t43, t42).add_product(t48, t47).sub_product(t52, t51).add_product(t55,
        t54));
    let t68 = (-(t66 * t53)).add_product(t55, t67);
    let t69 = (t65 * t49).add_product(t50, t68).sub_product(t52, t67);
    let t70 = (-(t64 * t44)).add_product(t46, t69).add_product(t48, t67);
    let t71 = (t63 * t37).sub_product(t39, t70).sub_product(t41, t69).sub_product(t43, t67);
    let t72 = (-(t62 * t27).add_product(t30, t71).add_product(t32, t70).add_product(t33, t69))
        .add_product(t35, t67);
    let t73 = (t61 * t19).sub_product(t21, t72).sub_product(t23, t71).sub_product(t25, t67);
    let t74 = (t57 * t10).add_product(t12, t73).add_product(t14, t72).add_product(t12, t71)
        .sub_product(t15, t67);
    let slider_v_y_dot = -c.t4.add_product(c.inverse_slider_mass, t69)
        .add_product(c.inverse_slider_mass, t68);
    let slider_v_x_dot = -(c.inverse_slider_mass * t70);
    let rod_omega_dot = (t7 * t71).sub_product(t6, t72).sub_product(t6, t70).add_product(t7, t69);
    let rod_v_y_dot = (-c.t3.add_product(c.inverse_rod_mass, t71)).add_product(c.inverse_rod_mass,
        t69);
    let rod_v_x_dot = (c.inverse_rod_mass * t70).sub_product(c.inverse_rod_mass, t72);
    let crank_omega_dot = (t5 * t73).sub_product(t4, t74).sub_product(t4, t72).add_product(t5, t71)
        .sub_product(c.inverse_crank_inertia, t67);
    let crank_v_y_dot = (-c.t2.add_product(c.inverse_crank_mass, t73))
        .add_product(c.inverse_crank_mass, t71);
    let crank_v_x_dot = (c.inverse_crank_mass * t72).sub_product(c.inverse_crank_mass, t74);
    [crank_v_x, crank_v_y, crank_omega, rod_v_x, rod_v_y, rod_omega, slider_v_x, slider_v_y,
        crank_v_x_dot, crank_v_y_dot, crank_omega_dot, rod_v_x_dot, rod_v_y_dot, rod_omega_dot,
        slider_v_x_dot, slider_v_y_dot]
}

/// `M = d2L/dq'2`, values in the order of its pattern. No operations.
#[must_use]
pub fn mass_matrix<R: Real>(_time: R, _state: &[R; STATES], p: &Parameters<R>) -> [R; 8] {
    [p.crank_mass, p.crank_mass, p.crank_inertia, p.rod_mass, p.rod_mass, p.rod_inertia,
        p.slider_mass, p.slider_mass]
}

/// `f` of `M q'' = f + G^T lambda`, one for each coordinate. 6 operations.
#[must_use]
pub fn forcing<R: Real>(_time: R, _state: &[R; STATES], p: &Parameters<R>) -> [R; COORDINATES] {
    let crank_y_forcing = -(p.crank_mass * p.crank_gravity);
    let rod_y_forcing = -(p.rod_mass * p.rod_gravity);
    let slider_y_forcing = -(p.slider_mass * p.slider_gravity);
    [R::literal(0.0), crank_y_forcing, R::literal(0.0), R::literal(0.0), rod_y_forcing,
        R::literal(0.0), R::literal(0.0), slider_y_forcing]
}

/// As `rate_jacobian`, with the constants of the parameters from `prepare`. 715 operations.
#[must_use]
pub fn prepared_rate_jacobian<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>,
        c: &Constants<R>) -> [R; 40] {
    let crank_phi = state[2];
    let rod_phi = state[5];
    let crank_omega = state[10];
    let rod_omega = state[13];
    let [(sin_crank_phi, cos_crank_phi), (sin_rod_phi, cos_rod_phi)] = R::sin_cos_each([crank_phi,
        rod_phi]);
    let t0 = c.t0 * cos_crank_phi;
    let t1 = c.t0 * sin_crank_phi;
    let t2 = c.t1 * cos_rod_phi;
    let t3 = c.t1 * sin_rod_phi;
    let t4 = t1 * c.inverse_crank_inertia;
    let t5 = t0 * c.inverse_crank_inertia;
    let t6 = t3 * c.inverse_rod_inertia;
    let t7 = t2 * c.inverse_rod_inertia;
    let t8 = t4 * t1;
    let t9 = c.inverse_crank_mass + t8;
    let t10 = R::literal(1.0) / t9;
    let t11 = t5 * t1;
    let t12 = t11 * t10;
    let t13 = c.inverse_crank_mass - t8;
    let t14 = t13 * t10;
    let t15 = t4 * t10;
    let t16 = t5 * t0;
    let t17 = c.inverse_crank_mass + t16;
    let t18 = t12 * t11;
    let t19 = R::literal(1.0) / (t18 - t17);
    let t20 = (t4 * t0).add_product(t14, t11);
    let t21 = t20 * t19;
    let t22 = c.inverse_crank_mass - t16 + t18;
    let t23 = t22 * t19;
    let t24 = t5.sub_product(t15, t11);
    let t25 = t24 * t19;
    let t26 = t6 * t3;
    let t27 = R::literal(1.0) / (-(t9 + c.inverse_rod_mass + t26)).add_product(t14, t13)
        .sub_product(t21, t20);
    let t28 = t7 * t3;
    let t29 = (t11 + t28).add_product(t12, t13).sub_product(t23, t20);
    let t30 = t29 * t27;
    let t31 = c.inverse_rod_mass - t26;
    let t32 = t31 * t27;
    let t33 = t28 * t27;
    let t34 = t4.add_product(t15, t13).add_product(t25, t20);
    let t35 = t34 * t27;
    let t36 = t7 * t2;
    let t37 = R::literal(1.0) / (t18 - (t17 + c.inverse_rod_mass + t36)).sub_product(t23, t22)
        .sub_product(t30, t29);
    let t38 = (t6 * t2).sub_product(t32, t29);
    let t39 = t38 * t37;
    let t40 = (c.inverse_rod_mass - t36).sub_product(t33, t29);
    let t41 = t40 * t37;
    let t42 = t24.sub_product(t25, t22).add_product(t35, t29);
    let t43 = t42 * t37;
    let t44 = R::literal(1.0) / (c.inverse_rod_mass + t26 + c.inverse_slider_mass).add_product(t32,
        t31).add_product(t39, t38);
    let t45 = t28.sub_product(t33, t31).sub_product(t41, t38);
    let t46 = t45 * t44;
    let t47 = (t35 * t31).sub_product(t43, t38);
    let t48 = t47 * t44;
    let t49 = R::literal(1.0) / (-(c.inverse_rod_mass + t36 + c.inverse_slider_mass)
        .add_product(t33, t28).add_product(t41, t40)).add_product(t46, t45);
    let t50 = c.inverse_slider_mass * t49;
    let t51 = (t35 * t28).sub_product(t43, t40).add_product(t48, t45);
    let t52 = t51 * t49;
    let t53 = R::literal(1.0) / c.inverse_slider_mass.add_product(t50, c.inverse_slider_mass);
    let t54 = t52 * c.inverse_slider_mass;
    let t55 = t54 * t53;
    let t56 = R::literal(1.0) / (-c.inverse_crank_inertia).add_product(t15, t4).sub_product(t25,
        t24).sub_product(t35, t34).sub_product(t43, t42).add_product(t48, t47).sub_product(t52, t51)
        .add_product(t55, t54);
    let crank_omega_squared = crank_omega * crank_omega;
    let t57 = c.t0 * crank_omega_squared;
    let t58 = t57 * cos_crank_phi;
    let t59 = t57 * sin_crank_phi;
    let t60 = p.crank_length * crank_omega_squared;
    let rod_omega_squared = rod_omega * rod_omega;
    let rod_length_times_rod_omega_squared = p.rod_length * rod_omega_squared;
    let t61 = c.t1 * rod_omega_squared;
    let t62 = t61 * cos_rod_phi;
    let t63 = t61 * sin_rod_phi;
    let t64 = t12 * t58;
    let t65 = c.t2 - t59 - t64;
    let t66 = (R::literal(0.5) * (t60 * cos_crank_phi)
        .add_product(rod_length_times_rod_omega_squared, cos_rod_phi)).add_product(t14, t58)
        .add_product(t21, t65);
    let t67 = (c.t3 - c.t2.add_product(R::literal(0.5), (t60 * sin_crank_phi)
        .add_product(rod_length_times_rod_omega_squared, sin_rod_phi)) - t64).sub_product(t23, t65)
        .add_product(t30, t66);
    let t68 = (-t62).add_product(t32, t66).sub_product(t39, t67);
    let t69 = (c.t4 - (t63 + c.t3)).add_product(t33, t66).sub_product(t41, t67).add_product(t46,
        t68);
    let t70 = c.t4.add_product(t50, t69);
    let t71 = (t15 * t58).sub_product(t25, t65).sub_product(t35, t66).sub_product(t43, t67)
        .add_product(t48, t68).sub_product(t52, t69).add_product(t55, t70) * t56;
    let t72 = (t69 * t49).add_product(t50, (-(t70 * t53)).add_product(t55, t71)).sub_product(t52,
        t71);
    let t73 = (-(t68 * t44)).add_product(t46, t72).add_product(t48, t71);
    let t74 = (t67 * t37).sub_product(t39, t73).sub_product(t41, t72).sub_product(t43, t71);
    let t75 = (-(t66 * t27).add_product(t30, t74).add_product(t32, t73).add_product(t33, t72))
        .add_product(t35, t71);
    let t76 = (t65 * t19).sub_product(t21, t75).sub_product(t23, t74).sub_product(t25, t71);
    let t77 = (t58 * t10).add_product(t12, t76).add_product(t14, t75).add_product(t12, t74)
        .sub_product(t15, t71);
    let rod_omega_dot = (t7 * t74).sub_product(t6, t75).sub_product(t6, t73).add_product(t7, t72);
    let crank_omega_dot = (t5 * t76).sub_product(t4, t77).sub_product(t4, t75).add_product(t5, t74)
        .sub_product(c.inverse_crank_inertia, t71);
    let t78 = (t1 * t76).add_product(t0, t77).add_product(t0, t75).add_product(t1, t74);
    let t79 = t59.sub_product(t0, crank_omega_dot).add_product(t4, t78);
    let t80 = (-t58.add_product(t1, crank_omega_dot).add_product(t5, t78)).add_product(t12, t79);
    let t81 = t79.add_product(t14, t79).sub_product(t21, t80);
    let t82 = t80.sub_product(t23, t80).sub_product(t30, t81);
    let t83 = (t32 * t81).add_product(t39, t82);
    let t84 = (t33 * t81).add_product(t41, t82).add_product(t46, t83);
    let t85 = t50 * t84;
    let t86 = c.inverse_crank_inertia * t78;
    let t87 = t86.sub_product(t15, t79).sub_product(t25, t80).add_product(t35, t81)
        .sub_product(t43, t82).sub_product(t48, t83).add_product(t52, t84).sub_product(t55, t85)
        * t56;
    let t88 = (t85 * t53).add_product(t55, t87);
    let t89 = (-(t84 * t49)).add_product(t50, t88).sub_product(t52, t87);
    let t90 = (t83 * t44).add_product(t46, t89).add_product(t48, t87);
    let t91 = (t82 * t37).sub_product(t39, t90).sub_product(t41, t89).sub_product(t43, t87);
    let t92 = (t81 * t27).sub_product(t30, t91).sub_product(t32, t90).sub_product(t33, t89)
        .add_product(t35, t87);
    let t93 = (t80 * t19).sub_product(t21, t92).sub_product(t23, t91).sub_product(t25, t87);
    let t94 = (-(t79 * t10)).add_product(t12, t93).add_product(t14, t92).add_product(t12, t91)
        .sub_product(t15, t87);
    let slider_v_y_dot_by_crank_phi = -(c.inverse_slider_mass * t88)
        .add_product(c.inverse_slider_mass, t89);
    let slider_v_x_dot_by_crank_phi = -(c.inverse_slider_mass * t90);
    let rod_omega_dot_by_crank_phi = (t7 * t91).sub_product(t6, t92).sub_product(t6, t90)
        .add_product(t7, t89);
    let rod_v_y_dot_by_crank_phi = (c.inverse_rod_mass * t89).sub_product(c.inverse_rod_mass, t91);
    let rod_v_x_dot_by_crank_phi = (c.inverse_rod_mass * t90).sub_product(c.inverse_rod_mass, t92);
    let crank_omega_dot_by_crank_phi = (-t86.add_product(t4, t94)).add_product(t5, t93)
        .sub_product(t4, t92).add_product(t5, t91).sub_product(c.inverse_crank_inertia, t87);
    let crank_v_y_dot_by_crank_phi = (c.inverse_crank_mass * t91).sub_product(c.inverse_crank_mass,
        t93);
    let crank_v_x_dot_by_crank_phi = (c.inverse_crank_mass * t92).sub_product(c.inverse_crank_mass,
        t94);
    let t95 = (t3 * t74).add_product(t2, t75).add_product(t2, t73).add_product(t3, t72);
    let t96 = t63.sub_product(t2, rod_omega_dot).add_product(t6, t95);
    let t97 = t62.add_product(t3, rod_omega_dot).add_product(t7, t95);
    let t98 = t97.add_product(t30, t96);
    let t99 = t96.sub_product(t32, t96).add_product(t39, t98);
    let t100 = (-t97.add_product(t33, t96)).add_product(t41, t98).add_product(t46, t99);
    let t101 = t50 * t100;
    let t102 = (t35 * t96).add_product(t43, t98).add_product(t48, t99).sub_product(t52, t100)
        .add_product(t55, t101) * t56;
    let t103 = (-(t101 * t53)).add_product(t55, t102);
    let t104 = (t100 * t49).add_product(t50, t103).sub_product(t52, t102);
    let t105 = (-(t99 * t44)).add_product(t46, t104).add_product(t48, t102);
    let t106 = (t98 * t37).add_product(t39, t105).add_product(t41, t104).add_product(t43, t102);
    let t107 = (t96 * t27).add_product(t30, t106).sub_product(t32, t105).sub_product(t33, t104)
        .add_product(t35, t102);
    let t108 = (t23 * t106).sub_product(t21, t107).sub_product(t25, t102);
    let t109 = (t14 * t107).add_product(t12, t108).sub_product(t12, t106).sub_product(t15, t102);
    let slider_v_y_dot_by_rod_phi = -(c.inverse_slider_mass * t103)
        .add_product(c.inverse_slider_mass, t104);
    let slider_v_x_dot_by_rod_phi = -(c.inverse_slider_mass * t105);
    let rod_omega_dot_by_rod_phi = (-(t95 * c.inverse_rod_inertia).add_product(t6, t107)
        .add_product(t7, t106).add_product(t6, t105)).add_product(t7, t104);
    let rod_v_y_dot_by_rod_phi = (c.inverse_rod_mass * t104).add_product(c.inverse_rod_mass, t106);
    let rod_v_x_dot_by_rod_phi = (c.inverse_rod_mass * t105).sub_product(c.inverse_rod_mass, t107);
    let crank_omega_dot_by_rod_phi = (t5 * t108).sub_product(t4, t109).sub_product(t4, t107)
        .sub_product(t5, t106).sub_product(c.inverse_crank_inertia, t102);
    let crank_v_y_dot_by_rod_phi = -(c.inverse_crank_mass * t106).add_product(c.inverse_crank_mass,
        t108);
    let crank_v_x_dot_by_rod_phi = (c.inverse_crank_mass * t107).sub_product(c.inverse_crank_mass,
        t109);
    let crank_length_times_crank_omega = p.crank_length * crank_omega;
    let t110 = crank_length_times_crank_omega * cos_crank_phi;
    let t111 = (crank_length_times_crank_omega * sin_crank_phi).add_product(t12, t110);
    let t112 = (-t110.add_product(t14, t110)).add_product(t21, t111);
    let t113 = (-t111).add_product(t23, t111).sub_product(t30, t112);
    let t114 = (t32 * t112).add_product(t39, t113);
    let t115 = (t33 * t112).add_product(t41, t113).add_product(t46, t114);
    let t116 = t50 * t115;
    let t117 = (t15 * t110).add_product(t25, t111).add_product(t35, t112).sub_product(t43, t113)
        .sub_product(t48, t114).add_product(t52, t115).sub_product(t55, t116) * t56;
    let t118 = (t116 * t53).add_product(t55, t117);
    let t119 = (-(t115 * t49)).add_product(t50, t118).sub_product(t52, t117);
    let t120 = (t114 * t44).add_product(t46, t119).add_product(t48, t117);
    let t121 = (t113 * t37).sub_product(t39, t120).sub_product(t41, t119).sub_product(t43, t117);
    let t122 = (t112 * t27).sub_product(t30, t121).sub_product(t32, t120).sub_product(t33, t119)
        .add_product(t35, t117);
    let t123 = (t111 * t19).add_product(t21, t122).add_product(t23, t121).add_product(t25, t117);
    let t124 = (t110 * t10).sub_product(t12, t123).add_product(t14, t122).add_product(t12, t121)
        .sub_product(t15, t117);
    let slider_v_y_dot_by_crank_omega = -(c.inverse_slider_mass * t118)
        .add_product(c.inverse_slider_mass, t119);
    let slider_v_x_dot_by_crank_omega = -(c.inverse_slider_mass * t120);
    let rod_omega_dot_by_crank_omega = (t7 * t121).sub_product(t6, t122).sub_product(t6, t120)
        .add_product(t7, t119);
    let rod_v_y_dot_by_crank_omega = (c.inverse_rod_mass * t119).sub_product(c.inverse_rod_mass,
        t121);
    let rod_v_x_dot_by_crank_omega = (c.inverse_rod_mass * t120).sub_product(c.inverse_rod_mass,
        t122);
    let crank_omega_dot_by_crank_omega = (-(t5 * t123).add_product(t4, t124).add_product(t4, t122))
        .add_product(t5, t121).sub_product(c.inverse_crank_inertia, t117);
    let crank_v_y_dot_by_crank_omega = (c.inverse_crank_mass * t121)
        .add_product(c.inverse_crank_mass, t123);
    let crank_v_x_dot_by_crank_omega = (c.inverse_crank_mass * t122)
        .sub_product(c.inverse_crank_mass, t124);
    let rod_length_times_rod_omega = p.rod_length * rod_omega;
    let t125 = rod_length_times_rod_omega * cos_rod_phi;
    let t126 = rod_length_times_rod_omega * sin_rod_phi;
    let t127 = (-t126).add_product(t30, t125);
    let t128 = (-t125).add_product(t32, t125).sub_product(t39, t127);
    let t129 = (-t126).add_product(t33, t125).sub_product(t41, t127).add_product(t46, t128);
    let t130 = t50 * t129;
    let t131 = (-(t35 * t125).add_product(t43, t127)).add_product(t48, t128).sub_product(t52, t129)
        .add_product(t55, t130) * t56;
    let t132 = (-(t130 * t53)).add_product(t55, t131);
    let t133 = (t129 * t49).add_product(t50, t132).sub_product(t52, t131);
    let t134 = (-(t128 * t44)).add_product(t46, t133).add_product(t48, t131);
    let t135 = (t127 * t37).sub_product(t39, t134).sub_product(t41, t133).sub_product(t43, t131);
    let t136 = (-(t125 * t27).add_product(t30, t135).add_product(t32, t134).add_product(t33, t133))
        .add_product(t35, t131);
    let t137 = (t23 * t135).add_product(t21, t136).add_product(t25, t131);
    let t138 = (t14 * t136).sub_product(t12, t137).add_product(t12, t135).sub_product(t15, t131);
    let slider_v_y_dot_by_rod_omega = -(c.inverse_slider_mass * t132)
        .add_product(c.inverse_slider_mass, t133);
    let slider_v_x_dot_by_rod_omega = -(c.inverse_slider_mass * t134);
    let rod_omega_dot_by_rod_omega = (t7 * t135).sub_product(t6, t136).sub_product(t6, t134)
        .add_product(t7, t133);
    let rod_v_y_dot_by_rod_omega = (c.inverse_rod_mass * t133).sub_product(c.inverse_rod_mass,
        t135);
    let rod_v_x_dot_by_rod_omega = (c.inverse_rod_mass * t134).sub_product(c.inverse_rod_mass,
        t136);
    let crank_omega_dot_by_rod_omega = (-(t5 * t137).add_product(t4, t138).add_product(t4, t136))
        .add_product(t5, t135).sub_product(c.inverse_crank_inertia, t131);
    let crank_v_y_dot_by_rod_omega = (c.inverse_crank_mass * t135)
        .add_product(c.inverse_crank_mass, t137);
    let crank_v_x_dot_by_rod_omega = (c.inverse_crank_mass * t136)
        .sub_product(c.inverse_crank_mass, t138);
    [R::literal(1.0), R::literal(1.0), R::literal(1.0), R::literal(1.0), R::literal(1.0),
        R::literal(1.0), R::literal(1.0), R::literal(1.0), crank_v_x_dot_by_crank_phi,
        crank_v_x_dot_by_rod_phi, crank_v_x_dot_by_crank_omega, crank_v_x_dot_by_rod_omega,
        crank_v_y_dot_by_crank_phi, crank_v_y_dot_by_rod_phi, crank_v_y_dot_by_crank_omega,
        crank_v_y_dot_by_rod_omega, crank_omega_dot_by_crank_phi, crank_omega_dot_by_rod_phi,
        crank_omega_dot_by_crank_omega, crank_omega_dot_by_rod_omega, rod_v_x_dot_by_crank_phi,
        rod_v_x_dot_by_rod_phi, rod_v_x_dot_by_crank_omega, rod_v_x_dot_by_rod_omega,
        rod_v_y_dot_by_crank_phi, rod_v_y_dot_by_rod_phi, rod_v_y_dot_by_crank_omega,
        rod_v_y_dot_by_rod_omega, rod_omega_dot_by_crank_phi, rod_omega_dot_by_rod_phi,
        rod_omega_dot_by_crank_omega, rod_omega_dot_by_rod_omega, slider_v_x_dot_by_crank_phi,
        slider_v_x_dot_by_rod_phi, slider_v_x_dot_by_crank_omega, slider_v_x_dot_by_rod_omega,
        slider_v_y_dot_by_crank_phi, slider_v_y_dot_by_rod_phi, slider_v_y_dot_by_crank_omega,
        slider_v_y_dot_by_rod_omega]
}

/// `dy'/dp`, values in the order of its pattern. 1340 operations.
#[must_use]
pub fn parameter_jacobian<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>) -> [R; 80] {
    let crank_phi = state[2];
    let rod_phi = state[5];
    let crank_omega = state[10];
    let rod_omega = state[13];
    let [(sin_crank_phi, cos_crank_phi), (sin_rod_phi, cos_rod_phi)] = R::sin_cos_each([crank_phi,
        rod_phi]);
    let t0 = R::literal(0.5) * p.crank_length;
    let t1 = t0 * cos_crank_phi;
    let t2 = t0 * sin_crank_phi;
    let t3 = R::literal(0.5) * p.rod_length;
    let t4 = t3 * cos_rod_phi;
    let t5 = t3 * sin_rod_phi;
    let inverse_crank_mass = R::literal(1.0) / p.crank_mass;
    let inverse_crank_inertia = R::literal(1.0) / p.crank_inertia;
    let t6 = t2 * inverse_crank_inertia;
    let t7 = t1 * inverse_crank_inertia;
    let inverse_rod_mass = R::literal(1.0) / p.rod_mass;
    let inverse_rod_inertia = R::literal(1.0) / p.rod_inertia;
    let t8 = t5 * inverse_rod_inertia;
    let t9 = t4 * inverse_rod_inertia;
    let inverse_slider_mass = R::literal(1.0) / p.slider_mass;
    let t10 = t6 * t2;
    let t11 = inverse_crank_mass + t10;
    let t12 = R::literal(1.0) / t11;
    let t13 = t7 * t2;
    let t14 = t13 * t12;
    let t15 = inverse_crank_mass - t10;
    let t16 = t15 * t12;
    let t17 = t6 * t12;
    let t18 = t7 * t1;
    let t19 = inverse_crank_mass + t18;
    let t20 = t14 * t13;
    let t21 = R::literal(1.0) / (t20 - t19);
    let t22 = (t6 * t1).add_product(t16, t13);
    let t23 = t22 * t21;
    let t24 = inverse_crank_mass - t18 + t20;
    let t25 = t24 * t21;
    let t26 = t7.sub_product(t17, t13);
    let t27 = t26 * t21;
    let t28 = t8 * t5;
    let t29 = R::literal(1.0) / (-(t11 + inverse_rod_mass + t28)).add_product(t16, t15)
        .sub_product(t23, t22);
    let t30 = t9 * t5;
    let t31 = (t13 + t30).add_product(t14, t15).sub_product(t25, t22);
    let t32 = t31 * t29;
    let t33 = inverse_rod_mass - t28;
    let t34 = t33 * t29;
    let t35 = t30 * t29;
    let t36 = t6.add_product(t17, t15).add_product(t27, t22);
    let t37 = t36 * t29;
    let t38 = t9 * t4;
    let t39 = R::literal(1.0) / (t20 - (t19 + inverse_rod_mass + t38)).sub_product(t25, t24)
        .sub_product(t32, t31);
    let t40 = (t8 * t4).sub_product(t34, t31);
    let t41 = t40 * t39;
    let t42 = (inverse_rod_mass - t38).sub_product(t35, t31);
    let t43 = t42 * t39;
    let t44 = t26.sub_product(t27, t24).add_product(t37, t31);
    let t45 = t44 * t39;
    let t46 = R::literal(1.0) / (inverse_rod_mass + t28 + inverse_slider_mass).add_product(t34, t33)
        .add_product(t41, t40);
    let t47 = t30.sub_product(t35, t33).sub_product(t43, t40);
    let t48 = t47 * t46;
    let t49 = (t37 * t33).sub_product(t45, t40);
    let t50 = t49 * t46;
    let t51 = R::literal(1.0) / (-(inverse_rod_mass + t38 + inverse_slider_mass).add_product(t35,
        t30).add_product(t43, t42)).add_product(t48, t47);
    let t52 = inverse_slider_mass * t51;
    let t53 = (t37 * t30).sub_product(t45, t42).add_product(t50, t47);
    let t54 = t53 * t51;
    let t55 = R::literal(1.0) / inverse_slider_mass.add_product(t52, inverse_slider_mass);
    let t56 = t54 * inverse_slider_mass;
    let t57 = t56 * t55;
    let t58 = R::literal(1.0) / (-inverse_crank_inertia).add_product(t17, t6).sub_product(t27, t26)
        .sub_product(t37, t36).sub_product(t45, t44).add_product(t50, t49).sub_product(t54, t53)
        .add_product(t57, t56);
    let crank_omega_squared = crank_omega * crank_omega;
    let t59 = t0 * crank_omega_squared;
    let t60 = t59 * cos_crank_phi;
    let t61 = p.crank_length * crank_omega_squared;
    let rod_omega_squared = rod_omega * rod_omega;
    let rod_length_times_rod_omega_squared = p.rod_length * rod_omega_squared;
    let t62 = t3 * rod_omega_squared;
    let t63 = inverse_crank_mass * (p.crank_mass * p.crank_gravity);
    let t64 = t14 * t60;
    let t65 = t63.sub_product(t59, sin_crank_phi) - t64;
    let t66 = (R::literal(0.5) * (t61 * cos_crank_phi)
        .add_product(rod_length_times_rod_omega_squared, cos_rod_phi)).add_product(t16, t60)
        .add_product(t23, t65);
    let t67 = inverse_rod_mass * (p.rod_mass * p.rod_gravity);
    let t68 = (t67 - t63.add_product(R::literal(0.5), (t61 * sin_crank_phi)
        .add_product(rod_length_times_rod_omega_squared, sin_rod_phi)) - t64).sub_product(t25, t65)
        .add_product(t32, t66);
    let t69 = (-(t62 * cos_rod_phi)).add_product(t34, t66).sub_product(t41, t68);
    let t70 = inverse_slider_mass * (p.slider_mass * p.slider_gravity);
    let t71 = (t70 - t67.add_product(t62, sin_rod_phi)).add_product(t35, t66).sub_product(t43, t68)
        .add_product(t48, t69);
    let t72 = t70.add_product(t52, t71);
    let t73 = (t17 * t60).sub_product(t27, t65).sub_product(t37, t66).sub_product(t45, t68)
        .add_product(t50, t69).sub_product(t54, t71).add_product(t57, t72) * t58;
    let t74 = (-(t72 * t55)).add_product(t57, t73);
    let t75 = (t71 * t51).add_product(t52, t74).sub_product(t54, t73);
    let t76 = (-(t69 * t46)).add_product(t48, t75).add_product(t50, t73);
    let t77 = (t68 * t39).sub_product(t41, t76).sub_product(t43, t75).sub_product(t45, t73);
    let t78 = (-(t66 * t29).add_product(t32, t77).add_product(t34, t76).add_product(t35, t75))
        .add_product(t37, t73);
    let t79 = (t65 * t21).sub_product(t23, t78).sub_product(t25, t77).sub_product(t27, t73);
    let t80 = (t60 * t12).add_product(t14, t79).add_product(t16, t78).add_product(t14, t77)
        .sub_product(t17, t73);
    let rod_omega_dot = (t9 * t77).sub_product(t8, t78).sub_product(t8, t76).add_product(t9, t75);
    let rod_v_y_dot = (-t67.add_product(inverse_rod_mass, t77)).add_product(inverse_rod_mass, t75);
    let t81 = (t7 * t79).sub_product(t6, t80).sub_product(t6, t78).add_product(t7, t77);
    let t82 = inverse_crank_inertia * t73;
    let crank_omega_dot = t81 - t82;
    let crank_v_y_dot = (-t63.add_product(inverse_crank_mass, t79)).add_product(inverse_crank_mass,
        t77);
    let t83 = R::literal(0.5) * crank_omega_squared;
    let t84 = R::literal(0.5) * sin_crank_phi;
    let t85 = R::literal(0.5) * cos_crank_phi;
    let t86 = (t85 * t79).sub_product(t84, t80).sub_product(t84, t78).add_product(t85, t77);
    let t87 = (t83 * cos_crank_phi).add_product(t84, crank_omega_dot).add_product(t6, t86);
    let t88 = (-(t83 * sin_crank_phi)).add_product(t85, crank_omega_dot).add_product(t7, t86)
        .sub_product(t14, t87);
    let t89 = t87.add_product(t16, t87).add_product(t23, t88);
    let t90 = t88.sub_product(t25, t88).add_product(t32, t89);
    let t91 = (t34 * t89).sub_product(t41, t90);
    let t92 = (t35 * t89).sub_product(t43, t90).add_product(t48, t91);
    let t93 = t52 * t92;
    let t94 = inverse_crank_inertia * t86;
    let t95 = (-t94).add_product(t17, t87).sub_product(t27, t88).sub_product(t37, t89)
        .sub_product(t45, t90).add_product(t50, t91).sub_product(t54, t92).add_product(t57, t93)
        * t58;
    let t96 = (-(t93 * t55)).add_product(t57, t95);
    let t97 = (t92 * t51).add_product(t52, t96).sub_product(t54, t95);
    let t98 = (-(t91 * t46)).add_product(t48, t97).add_product(t50, t95);
    let t99 = (t90 * t39).sub_product(t41, t98).sub_product(t43, t97).sub_product(t45, t95);
    let t100 = (-(t89 * t29).add_product(t32, t99).add_product(t34, t98).add_product(t35, t97))
        .add_product(t37, t95);
    let t101 = (t88 * t21).sub_product(t23, t100).sub_product(t25, t99).sub_product(t27, t95);
    let t102 = (t87 * t12).add_product(t14, t101).add_product(t16, t100).add_product(t14, t99)
        .sub_product(t17, t95);
    let slider_v_y_dot_by_crank_length = -(inverse_slider_mass * t96)
        .add_product(inverse_slider_mass, t97);
    let slider_v_x_dot_by_crank_length = -(inverse_slider_mass * t98);
    let rod_omega_dot_by_crank_length = (t9 * t99).sub_product(t8, t100).sub_product(t8, t98)
        .add_product(t9, t97);
    let rod_v_y_dot_by_crank_length = (inverse_rod_mass * t97).sub_product(inverse_rod_mass, t99);
    let rod_v_x_dot_by_crank_length = (inverse_rod_mass * t98).sub_product(inverse_rod_mass, t100);
    let crank_omega_dot_by_crank_length = t94.sub_product(t6, t102).add_product(t7, t101)
        .sub_product(t6, t100).add_product(t7, t99).sub_product(inverse_crank_inertia, t95);
    let crank_v_y_dot_by_crank_length = (inverse_crank_mass * t99).sub_product(inverse_crank_mass,
        t101);
    let crank_v_x_dot_by_crank_length = (inverse_crank_mass * t100).sub_product(inverse_crank_mass,
        t102);
    let t103 = inverse_crank_mass * (-(inverse_crank_mass * t78)).add_product(inverse_crank_mass,
        t80);
    let t104 = inverse_crank_mass * (p.crank_gravity + crank_v_y_dot);
    let t105 = t14 * t103;
    let t106 = t104 - t105;
    let t107 = t103.sub_product(t16, t103).sub_product(t23, t106);
    let t108 = (t104 + t105).add_product(t25, t106).add_product(t32, t107);
    let t109 = (-(t34 * t107)).add_product(t41, t108);
    let t110 = (-(t35 * t107)).add_product(t43, t108).add_product(t48, t109);
    let t111 = t52 * t110;
    let t112 = (t17 * t103).sub_product(t27, t106).add_product(t37, t107).add_product(t45, t108)
        .add_product(t50, t109).sub_product(t54, t110).add_product(t57, t111) * t58;
    let t113 = (-(t111 * t55)).add_product(t57, t112);
    let t114 = (t110 * t51).add_product(t52, t113).sub_product(t54, t112);
    let t115 = (-(t109 * t46)).add_product(t48, t114).add_product(t50, t112);
    let t116 = (t108 * t39).add_product(t41, t115).add_product(t43, t114).add_product(t45, t112);
    let t117 = (t107 * t29).add_product(t32, t116).sub_product(t34, t115).sub_product(t35, t114)
        .add_product(t37, t112);
    let t118 = (t106 * t21).sub_product(t23, t117).add_product(t25, t116).sub_product(t27, t112);
    let t119 = (t103 * t12).add_product(t14, t118).add_product(t16, t117).sub_product(t14, t116)
        .sub_product(t17, t112);
    let slider_v_y_dot_by_crank_mass = -(inverse_slider_mass * t113)
        .add_product(inverse_slider_mass, t114);
    let slider_v_x_dot_by_crank_mass = -(inverse_slider_mass * t115);
    let rod_omega_dot_by_crank_mass = (-(t9 * t116).add_product(t8, t117).add_product(t8, t115))
        .add_product(t9, t114);
    let rod_v_y_dot_by_crank_mass = (inverse_rod_mass * t114).add_product(inverse_rod_mass, t116);
    let rod_v_x_dot_by_crank_mass = (inverse_rod_mass * t115).sub_product(inverse_rod_mass, t117);
    let crank_omega_dot_by_crank_mass = (t7 * t118).sub_product(t6, t119).sub_product(t6, t117)
        .sub_product(t7, t116).sub_product(inverse_crank_inertia, t112);
    let crank_v_y_dot_by_crank_mass = -t104.add_product(inverse_crank_mass, t118)
        .add_product(inverse_crank_mass, t116);
    let crank_v_x_dot_by_crank_mass = t103.sub_product(inverse_crank_mass, t119)
        .add_product(inverse_crank_mass, t117);
    let t120 = t82 - t81;
    let t121 = t6 * t120;
    let t122 = (t7 * t120).sub_product(t14, t121);
    let t123 = t121.add_product(t16, t121).add_product(t23, t122);
    let t124 = t122.sub_product(t25, t122).add_product(t32, t123);
    let t125 = (t34 * t123).sub_product(t41, t124);
    let t126 = (t35 * t123).sub_product(t43, t124).add_product(t48, t125);
    let t127 = t52 * t126;
    let t128 = inverse_crank_inertia * t120;
    let t129 = (-t128).add_product(t17, t121).sub_product(t27, t122).sub_product(t37, t123)
        .sub_product(t45, t124).add_product(t50, t125).sub_product(t54, t126).add_product(t57,
        t127) * t58;
    let t130 = (-(t127 * t55)).add_product(t57, t129);
    let t131 = (t126 * t51).add_product(t52, t130).sub_product(t54, t129);
    let t132 = (-(t125 * t46)).add_product(t48, t131).add_product(t50, t129);
    let t133 = (t124 * t39).sub_product(t41, t132).sub_product(t43, t131).sub_product(t45, t129);
    let t134 = (-(t123 * t29).add_product(t32, t133).add_product(t34, t132).add_product(t35, t131))
        .add_product(t37, t129);
    let t135 = (t122 * t21).sub_product(t23, t134).sub_product(t25, t133).sub_product(t27, t129);
    let t136 = (t121 * t12).add_product(t14, t135).add_product(t16, t134).add_product(t14, t133)
        .sub_product(t17, t129);
    let slider_v_y_dot_by_crank_inertia = -(inverse_slider_mass * t130)
        .add_product(inverse_slider_mass, t131);
    let slider_v_x_dot_by_crank_inertia = -(inverse_slider_mass * t132);
    let rod_omega_dot_by_crank_inertia = (t9 * t133).sub_product(t8, t134).sub_product(t8, t132)
        .add_product(t9, t131);
    let rod_v_y_dot_by_crank_inertia = (inverse_rod_mass * t131).sub_product(inverse_rod_mass,
        t133);
    let rod_v_x_dot_by_crank_inertia = (inverse_rod_mass * t132).sub_product(inverse_rod_mass,
        t134);
    let crank_omega_dot_by_crank_inertia = t128.sub_product(t6, t136).add_product(t7, t135)
        .sub_product(t6, t134).add_product(t7, t133).sub_product(inverse_crank_inertia, t129);
    let crank_v_y_dot_by_crank_inertia = (inverse_crank_mass * t133)
        .sub_product(inverse_crank_mass, t135);
    let crank_v_x_dot_by_crank_inertia = (inverse_crank_mass * t134)
        .sub_product(inverse_crank_mass, t136);
    let inverse_crank_mass_times_crank_mass = inverse_crank_mass * p.crank_mass;
    let t137 = t23 * inverse_crank_mass_times_crank_mass;
    let t138 = (-inverse_crank_mass_times_crank_mass.add_product(t25,
        inverse_crank_mass_times_crank_mass)).add_product(t32, t137);
    let t139 = (t34 * t137).sub_product(t41, t138);
    let t140 = (t35 * t137).sub_product(t43, t138).add_product(t48, t139);
    let t141 = t52 * t140;
    let t142 = (-(t27 * inverse_crank_mass_times_crank_mass).add_product(t37, t137)
        .add_product(t45, t138)).add_product(t50, t139).sub_product(t54, t140).add_product(t57,
        t141) * t58;
    let t143 = (-(t141 * t55)).add_product(t57, t142);
    let t144 = (t140 * t51).add_product(t52, t143).sub_product(t54, t142);
    let t145 = (-(t139 * t46)).add_product(t48, t144).add_product(t50, t142);
    let t146 = (t138 * t39).sub_product(t41, t145).sub_product(t43, t144).sub_product(t45, t142);
    let t147 = (-(t137 * t29).add_product(t32, t146).add_product(t34, t145).add_product(t35, t144))
        .add_product(t37, t142);
    let t148 = (inverse_crank_mass_times_crank_mass * t21).sub_product(t23, t147).sub_product(t25,
        t146).sub_product(t27, t142);
    let t149 = (t16 * t147).add_product(t14, t148).add_product(t14, t146).sub_product(t17, t142);
    let slider_v_y_dot_by_crank_gravity = -(inverse_slider_mass * t143)
        .add_product(inverse_slider_mass, t144);
    let slider_v_x_dot_by_crank_gravity = -(inverse_slider_mass * t145);
    let rod_omega_dot_by_crank_gravity = (t9 * t146).sub_product(t8, t147).sub_product(t8, t145)
        .add_product(t9, t144);
    let rod_v_y_dot_by_crank_gravity = (inverse_rod_mass * t144).sub_product(inverse_rod_mass,
        t146);
    let rod_v_x_dot_by_crank_gravity = (inverse_rod_mass * t145).sub_product(inverse_rod_mass,
        t147);
    let crank_omega_dot_by_crank_gravity = (t7 * t148).sub_product(t6, t149).sub_product(t6, t147)
        .add_product(t7, t146).sub_product(inverse_crank_inertia, t142);
    let crank_v_y_dot_by_crank_gravity = (-inverse_crank_mass_times_crank_mass
        .add_product(inverse_crank_mass, t148)).add_product(inverse_crank_mass, t146);
    let crank_v_x_dot_by_crank_gravity = (inverse_crank_mass * t147)
        .sub_product(inverse_crank_mass, t149);
    let t150 = R::literal(0.5) * rod_omega_squared;
    let t151 = R::literal(0.5) * sin_rod_phi;
    let t152 = R::literal(0.5) * cos_rod_phi;
    let t153 = (t152 * t77).sub_product(t151, t78).sub_product(t151, t76).add_product(t152, t75);
    let t154 = (t150 * cos_rod_phi).add_product(t151, rod_omega_dot).add_product(t8, t153);
    let t155 = (-(t150 * sin_rod_phi)).add_product(t152, rod_omega_dot).add_product(t9, t153);
    let t156 = t155.add_product(t32, t154);
    let t157 = (-t154).add_product(t34, t154).sub_product(t41, t156);
    let t158 = t155.add_product(t35, t154).sub_product(t43, t156).add_product(t48, t157);
    let t159 = t52 * t158;
    let t160 = (-(t37 * t154).add_product(t45, t156)).add_product(t50, t157).sub_product(t54, t158)
        .add_product(t57, t159) * t58;
    let t161 = (-(t159 * t55)).add_product(t57, t160);
    let t162 = (t158 * t51).add_product(t52, t161).sub_product(t54, t160);
    let t163 = (-(t157 * t46)).add_product(t48, t162).add_product(t50, t160);
    let t164 = (t156 * t39).sub_product(t41, t163).sub_product(t43, t162).sub_product(t45, t160);
    let t165 = (-(t154 * t29).add_product(t32, t164).add_product(t34, t163).add_product(t35, t162))
        .add_product(t37, t160);
    let t166 = (t25 * t164).add_product(t23, t165).add_product(t27, t160);
    let t167 = (t16 * t165).sub_product(t14, t166).add_product(t14, t164).sub_product(t17, t160);
    let slider_v_y_dot_by_rod_length = -(inverse_slider_mass * t161)
        .add_product(inverse_slider_mass, t162);
    let slider_v_x_dot_by_rod_length = -(inverse_slider_mass * t163);
    let rod_omega_dot_by_rod_length = (t153 * inverse_rod_inertia).sub_product(t8, t165)
        .add_product(t9, t164).sub_product(t8, t163).add_product(t9, t162);
    let rod_v_y_dot_by_rod_length = (inverse_rod_mass * t162).sub_product(inverse_rod_mass, t164);
    let rod_v_x_dot_by_rod_length = (inverse_rod_mass * t163).sub_product(inverse_rod_mass, t165);
    let crank_omega_dot_by_rod_length = (-(t7 * t166).add_product(t6, t167).add_product(t6, t165))
        .add_product(t7, t164).sub_product(inverse_crank_inertia, t160);
    let crank_v_y_dot_by_rod_length = (inverse_crank_mass * t164).add_product(inverse_crank_mass,
        t166);
    let crank_v_x_dot_by_rod_length = (inverse_crank_mass * t165).sub_product(inverse_crank_mass,
        t167);
    let t168 = inverse_rod_mass * (-(inverse_rod_mass * t76)).add_product(inverse_rod_mass, t78);
    let t169 = inverse_rod_mass * (p.rod_gravity + rod_v_y_dot);
    let t170 = t169.add_product(t32, t168);
    let t171 = t168.add_product(t34, t168).sub_product(t41, t170);
    let t172 = (-t169).add_product(t35, t168).sub_product(t43, t170).add_product(t48, t171);
    let t173 = t52 * t172;
    let t174 = (-(t37 * t168).add_product(t45, t170)).add_product(t50, t171).sub_product(t54, t172)
        .add_product(t57, t173) * t58;
    let t175 = (-(t173 * t55)).add_product(t57, t174);
    let t176 = (t172 * t51).add_product(t52, t175).sub_product(t54, t174);
    let t177 = (-(t171 * t46)).add_product(t48, t176).add_product(t50, t174);
    let t178 = (t170 * t39).sub_product(t41, t177).sub_product(t43, t176).sub_product(t45, t174);
    let t179 = (-(t168 * t29).add_product(t32, t178).add_product(t34, t177).add_product(t35, t176))
        .add_product(t37, t174);
    let t180 = (t25 * t178).add_product(t23, t179).add_product(t27, t174);
    let t181 = (t16 * t179).sub_product(t14, t180).add_product(t14, t178).sub_product(t17, t174);
    let slider_v_y_dot_by_rod_mass = -(inverse_slider_mass * t175).add_product(inverse_slider_mass,
        t176);
    let slider_v_x_dot_by_rod_mass = -(inverse_slider_mass * t177);
    let rod_omega_dot_by_rod_mass = (t9 * t178).sub_product(t8, t179).sub_product(t8, t177)
        .add_product(t9, t176);
    let rod_v_y_dot_by_rod_mass = (-t169.add_product(inverse_rod_mass, t178))
        .add_product(inverse_rod_mass, t176);
    let rod_v_x_dot_by_rod_mass = t168.sub_product(inverse_rod_mass, t179)
        .add_product(inverse_rod_mass, t177);
    let crank_omega_dot_by_rod_mass = (-(t7 * t180).add_product(t6, t181).add_product(t6, t179))
        .add_product(t7, t178).sub_product(inverse_crank_inertia, t174);
    let crank_v_y_dot_by_rod_mass = (inverse_crank_mass * t178).add_product(inverse_crank_mass,
        t180);
    let crank_v_x_dot_by_rod_mass = (inverse_crank_mass * t179).sub_product(inverse_crank_mass,
        t181);
    let t182 = t8 * rod_omega_dot;
    let t183 = t9 * rod_omega_dot;
    let t184 = t183.add_product(t32, t182);
    let t185 = t182.sub_product(t34, t182).add_product(t41, t184);
    let t186 = (-t183.add_product(t35, t182)).add_product(t43, t184).add_product(t48, t185);
    let t187 = t52 * t186;
    let t188 = (t37 * t182).add_product(t45, t184).add_product(t50, t185).sub_product(t54, t186)
        .add_product(t57, t187) * t58;
    let t189 = (-(t187 * t55)).add_product(t57, t188);
    let t190 = (t186 * t51).add_product(t52, t189).sub_product(t54, t188);
    let t191 = (-(t185 * t46)).add_product(t48, t190).add_product(t50, t188);
    let t192 = (t184 * t39).add_product(t41, t191).add_product(t43, t190).add_product(t45, t188);
    let t193 = (t182 * t29).add_product(t32, t192).sub_product(t34, t191).sub_product(t35, t190)
        .add_product(t37, t188);
    let t194 = (t25 * t192).sub_product(t23, t193).sub_product(t27, t188);
    let t195 = (t16 * t193).add_product(t14, t194).sub_product(t14, t192).sub_product(t17, t188);
    let slider_v_y_dot_by_rod_inertia = -(inverse_slider_mass * t189)
        .add_product(inverse_slider_mass, t190);
    let slider_v_x_dot_by_rod_inertia = -(inverse_slider_mass * t191);
    let rod_omega_dot_by_rod_inertia = (-(rod_omega_dot * inverse_rod_inertia).add_product(t8, t193)
        .add_product(t9, t192).add_product(t8, t191)).add_product(t9, t190);
    let rod_v_y_dot_by_rod_inertia = (inverse_rod_mass * t190).add_product(inverse_rod_mass, t192);
    let rod_v_x_dot_by_rod_inertia = (inverse_rod_mass * t191).sub_product(inverse_rod_mass, t193);
    let crank_omega_dot_by_rod_inertia = (t7 * t194).sub_product(t6, t195).sub_product(t6, t193)
        .sub_product(t7, t192).sub_product(inverse_crank_inertia, t188);
    let crank_v_y_dot_by_rod_inertia = -(inverse_crank_mass * t192).add_product(inverse_crank_mass,
        t194);
    let crank_v_x_dot_by_rod_inertia = (inverse_crank_mass * t193).sub_product(inverse_crank_mass,
        t195);
    let inverse_rod_mass_times_rod_mass = inverse_rod_mass * p.rod_mass;
    let t196 = t41 * inverse_rod_mass_times_rod_mass;
    let t197 = inverse_rod_mass_times_rod_mass.add_product(t43, inverse_rod_mass_times_rod_mass)
        .add_product(t48, t196);
    let t198 = t52 * t197;
    let t199 = (-(t45 * inverse_rod_mass_times_rod_mass).add_product(t50, t196)).add_product(t54,
        t197).sub_product(t57, t198) * t58;
    let t200 = (t198 * t55).add_product(t57, t199);
    let t201 = (-(t197 * t51)).add_product(t52, t200).sub_product(t54, t199);
    let t202 = (t196 * t46).add_product(t48, t201).add_product(t50, t199);
    let t203 = (inverse_rod_mass_times_rod_mass * t39).sub_product(t41, t202).sub_product(t43, t201)
        .sub_product(t45, t199);
    let t204 = (-(t34 * t202).add_product(t32, t203).add_product(t35, t201)).add_product(t37, t199);
    let t205 = (t25 * t203).add_product(t23, t204).add_product(t27, t199);
    let t206 = (t16 * t204).sub_product(t14, t205).add_product(t14, t203).sub_product(t17, t199);
    let slider_v_y_dot_by_rod_gravity = -(inverse_slider_mass * t200)
        .add_product(inverse_slider_mass, t201);
    let slider_v_x_dot_by_rod_gravity = -(inverse_slider_mass * t202);
    let rod_omega_dot_by_rod_gravity = (t9 * t203).sub_product(t8, t204).sub_product(t8, t202)
        .add_product(t9, t201);
    let rod_v_y_dot_by_rod_gravity = (-inverse_rod_mass_times_rod_mass
        .add_product(inverse_rod_mass, t203)).add_product(inverse_rod_mass, t201);
    let rod_v_x_dot_by_rod_gravity = (inverse_rod_mass * t202).sub_product(inverse_rod_mass, t204);
    let crank_omega_dot_by_rod_gravity = (-(t7 * t205).add_product(t6, t206).add_product(t6, t204))
        .add_product(t7, t203).sub_product(inverse_crank_inertia, t199);
    let crank_v_y_dot_by_rod_gravity = (inverse_crank_mass * t203).add_product(inverse_crank_mass,
        t205);
    let crank_v_x_dot_by_rod_gravity = (inverse_crank_mass * t204).sub_product(inverse_crank_mass,
        t206);
    let t207 = inverse_slider_mass * (inverse_slider_mass * t76);
    let t208 = inverse_slider_mass * (t70.add_product(inverse_slider_mass, t75)
        .add_product(inverse_slider_mass, t74) - p.slider_gravity);
    let t209 = t208.add_product(t48, t207);
    let t210 = t208.add_product(t52, t209);
    let t211 = (-(t50 * t207)).add_product(t54, t209).sub_product(t57, t210) * t58;
    let t212 = (t210 * t55).add_product(t57, t211);
    let t213 = (-(t209 * t51)).add_product(t52, t212).sub_product(t54, t211);
    let t214 = (t207 * t46).add_product(t48, t213).add_product(t50, t211);
    let t215 = (t43 * t213).add_product(t41, t214).add_product(t45, t211);
    let t216 = (-(t34 * t214)).add_product(t32, t215).sub_product(t35, t213).add_product(t37, t211);
    let t217 = (t25 * t215).sub_product(t23, t216).sub_product(t27, t211);
    let t218 = (t16 * t216).add_product(t14, t217).sub_product(t14, t215).sub_product(t17, t211);
    let slider_v_y_dot_by_slider_mass = t208.sub_product(inverse_slider_mass, t213)
        .sub_product(inverse_slider_mass, t212);
    let slider_v_x_dot_by_slider_mass = t207.sub_product(inverse_slider_mass, t214);
    let rod_omega_dot_by_slider_mass = (-(t9 * t215).add_product(t8, t216).add_product(t8, t214))
        .add_product(t9, t213);
    let rod_v_y_dot_by_slider_mass = (inverse_rod_mass * t213).add_product(inverse_rod_mass, t215);
    let rod_v_x_dot_by_slider_mass = (inverse_rod_mass * t214).sub_product(inverse_rod_mass, t216);
    let crank_omega_dot_by_slider_mass = (t7 * t217).sub_product(t6, t218).sub_product(t6, t216)
        .sub_product(t7, t215).sub_product(inverse_crank_inertia, t211);
    let crank_v_y_dot_by_slider_mass = -(inverse_crank_mass * t215).add_product(inverse_crank_mass,
        t217);
    let crank_v_x_dot_by_slider_mass = (inverse_crank_mass * t216).sub_product(inverse_crank_mass,
        t218);
    let t219 = inverse_slider_mass * p.slider_mass;
    let t220 = t219.add_product(t52, t219);
    let t221 = (-(t54 * t219)).add_product(t57, t220) * t58;
    let t222 = (-(t220 * t55)).add_product(t57, t221);
    let t223 = (t219 * t51).add_product(t52, t222).sub_product(t54, t221);
    let t224 = (t50 * t221).add_product(t48, t223);
    let t225 = (t43 * t223).add_product(t41, t224).add_product(t45, t221);
    let t226 = (-(t34 * t224)).add_product(t32, t225).sub_product(t35, t223).add_product(t37, t221);
    let t227 = (t25 * t225).sub_product(t23, t226).sub_product(t27, t221);
    let t228 = (t16 * t226).add_product(t14, t227).sub_product(t14, t225).sub_product(t17, t221);
    let slider_v_y_dot_by_slider_gravity = -t219.add_product(inverse_slider_mass, t223)
        .add_product(inverse_slider_mass, t222);
    let slider_v_x_dot_by_slider_gravity = -(inverse_slider_mass * t224);
    let rod_omega_dot_by_slider_gravity = (-(t9 * t225).add_product(t8, t226).add_product(t8, t224))
        .add_product(t9, t223);
    let rod_v_y_dot_by_slider_gravity = (inverse_rod_mass * t223).add_product(inverse_rod_mass,
        t225);
    let rod_v_x_dot_by_slider_gravity = (inverse_rod_mass * t224).sub_product(inverse_rod_mass,
        t226);
    let crank_omega_dot_by_slider_gravity = (t7 * t227).sub_product(t6, t228).sub_product(t6, t226)
        .sub_product(t7, t225).sub_product(inverse_crank_inertia, t221);
    let crank_v_y_dot_by_slider_gravity = -(inverse_crank_mass * t225)
        .add_product(inverse_crank_mass, t227);
    let crank_v_x_dot_by_slider_gravity = (inverse_crank_mass * t226)
        .sub_product(inverse_crank_mass, t228);
    [crank_v_x_dot_by_crank_length, crank_v_x_dot_by_crank_mass, crank_v_x_dot_by_crank_inertia,
        crank_v_x_dot_by_crank_gravity, crank_v_x_dot_by_rod_length, crank_v_x_dot_by_rod_mass,
        crank_v_x_dot_by_rod_inertia, crank_v_x_dot_by_rod_gravity, crank_v_x_dot_by_slider_mass,
        crank_v_x_dot_by_slider_gravity, crank_v_y_dot_by_crank_length,
        crank_v_y_dot_by_crank_mass, crank_v_y_dot_by_crank_inertia,
        crank_v_y_dot_by_crank_gravity, crank_v_y_dot_by_rod_length, crank_v_y_dot_by_rod_mass,
        crank_v_y_dot_by_rod_inertia, crank_v_y_dot_by_rod_gravity, crank_v_y_dot_by_slider_mass,
        crank_v_y_dot_by_slider_gravity, crank_omega_dot_by_crank_length,
        crank_omega_dot_by_crank_mass, crank_omega_dot_by_crank_inertia,
        crank_omega_dot_by_crank_gravity, crank_omega_dot_by_rod_length,
        crank_omega_dot_by_rod_mass, crank_omega_dot_by_rod_inertia,
        crank_omega_dot_by_rod_gravity, crank_omega_dot_by_slider_mass,
        crank_omega_dot_by_slider_gravity, rod_v_x_dot_by_crank_length, rod_v_x_dot_by_crank_mass,
        rod_v_x_dot_by_crank_inertia, rod_v_x_dot_by_crank_gravity, rod_v_x_dot_by_rod_length,
        rod_v_x_dot_by_rod_mass, rod_v_x_dot_by_rod_inertia, rod_v_x_dot_by_rod_gravity,
        rod_v_x_dot_by_slider_mass, rod_v_x_dot_by_slider_gravity, rod_v_y_dot_by_crank_length,
        rod_v_y_dot_by_crank_mass, rod_v_y_dot_by_crank_inertia, rod_v_y_dot_by_crank_gravity,
        rod_v_y_dot_by_rod_length, rod_v_y_dot_by_rod_mass, rod_v_y_dot_by_rod_inertia,
        rod_v_y_dot_by_rod_gravity, rod_v_y_dot_by_slider_mass, rod_v_y_dot_by_slider_gravity,
        rod_omega_dot_by_crank_length, rod_omega_dot_by_crank_mass, rod_omega_dot_by_crank_inertia,
        rod_omega_dot_by_crank_gravity, rod_omega_dot_by_rod_length, rod_omega_dot_by_rod_mass,
        rod_omega_dot_by_rod_inertia, rod_omega_dot_by_rod_gravity, rod_omega_dot_by_slider_mass,
        rod_omega_dot_by_slider_gravity, slider_v_x_dot_by_crank_length,
        slider_v_x_dot_by_crank_mass, slider_v_x_dot_by_crank_inertia,
        slider_v_x_dot_by_crank_gravity, slider_v_x_dot_by_rod_length, slider_v_x_dot_by_rod_mass,
        slider_v_x_dot_by_rod_inertia, slider_v_x_dot_by_rod_gravity,
        slider_v_x_dot_by_slider_mass, slider_v_x_dot_by_slider_gravity,
        slider_v_y_dot_by_crank_length, slider_v_y_dot_by_crank_mass,
        slider_v_y_dot_by_crank_inertia, slider_v_y_dot_by_crank_gravity,
        slider_v_y_dot_by_rod_length, slider_v_y_dot_by_rod_mass, slider_v_y_dot_by_rod_inertia,
        slider_v_y_dot_by_rod_gravity, slider_v_y_dot_by_slider_mass,
        slider_v_y_dot_by_slider_gravity]
}

/// Partial derivative of `y'` with respect to time. No operations.
#[must_use]
pub fn time_derivative<R: Real>(_time: R, _state: &[R; STATES], _p: &Parameters<R>) -> [R; STATES] {
    [R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0),
        R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0),
        R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0),
        R::literal(0.0)]
}

/// Wanted outputs. 221 operations.
#[must_use]
pub fn outputs<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>) -> Outputs<R> {
    let [_, _, crank_phi, _, _, rod_phi, slider_x, _, _, _, crank_omega, _, _, rod_omega,
        slider_v_x, ..] = *state;
    let [(sin_crank_phi, cos_crank_phi), (sin_rod_phi, cos_rod_phi)] = R::sin_cos_each([crank_phi,
        rod_phi]);
    let t0 = R::literal(0.5) * p.crank_length;
    let t1 = t0 * cos_crank_phi;
    let t2 = t0 * sin_crank_phi;
    let t3 = R::literal(0.5) * p.rod_length;
    let t4 = t3 * cos_rod_phi;
    let t5 = t3 * sin_rod_phi;
    let inverse_crank_mass = R::literal(1.0) / p.crank_mass;
    let inverse_crank_inertia = R::literal(1.0) / p.crank_inertia;
    let t6 = t2 * inverse_crank_inertia;
    let t7 = t1 * inverse_crank_inertia;
    let inverse_rod_mass = R::literal(1.0) / p.rod_mass;
    let inverse_rod_inertia = R::literal(1.0) / p.rod_inertia;
    let t8 = t5 * inverse_rod_inertia;
    let t9 = t4 * inverse_rod_inertia;
    let inverse_slider_mass = R::literal(1.0) / p.slider_mass;
    let t10 = t6 * t2;
    let t11 = inverse_crank_mass + t10;
    let t12 = R::literal(1.0) / t11;
    let t13 = t7 * t2;
    let t14 = t13 * t12;
    let t15 = inverse_crank_mass - t10;
    let t16 = t15 * t12;
    let t17 = t6 * t12;
    let t18 = t7 * t1;
    let t19 = inverse_crank_mass + t18;
    let t20 = t14 * t13;
    let t21 = R::literal(1.0) / (t20 - t19);
    let t22 = (t6 * t1).add_product(t16, t13);
    let t23 = t22 * t21;
    let t24 = inverse_crank_mass - t18 + t20;
    let t25 = t24 * t21;
    let t26 = t7.sub_product(t17, t13);
    let t27 = t26 * t21;
    let t28 = t8 * t5;
    let t29 = R::literal(1.0) / (-(t11 + inverse_rod_mass + t28)).add_product(t16, t15)
        .sub_product(t23, t22);
    let t30 = t9 * t5;
    let t31 = (t13 + t30).add_product(t14, t15).sub_product(t25, t22);
    let t32 = t31 * t29;
    let t33 = inverse_rod_mass - t28;
    let t34 = t33 * t29;
    let t35 = t30 * t29;
    let t36 = t6.add_product(t17, t15).add_product(t27, t22);
    let t37 = t36 * t29;
    let t38 = t9 * t4;
    let t39 = R::literal(1.0) / (t20 - (t19 + inverse_rod_mass + t38)).sub_product(t25, t24)
        .sub_product(t32, t31);
    let t40 = (t8 * t4).sub_product(t34, t31);
    let t41 = t40 * t39;
    let t42 = (inverse_rod_mass - t38).sub_product(t35, t31);
    let t43 = t42 * t39;
    let t44 = t26.sub_product(t27, t24).add_product(t37, t31);
    let t45 = t44 * t39;
    let t46 = R::literal(1.0) / (inverse_rod_mass + t28 + inverse_slider_mass).add_product(t34, t33)
        .add_product(t41, t40);
    let t47 = t30.sub_product(t35, t33).sub_product(t43, t40);
    let t48 = t47 * t46;
    let t49 = (t37 * t33).sub_product(t45, t40);
    let t50 = t49 * t46;
    let t51 = R::literal(1.0) / (-(inverse_rod_mass + t38 + inverse_slider_mass).add_product(t35,
        t30).add_product(t43, t42)).add_product(t48, t47);
    let t52 = inverse_slider_mass * t51;
    let t53 = (t37 * t30).sub_product(t45, t42).add_product(t50, t47);
    let t54 = t53 * t51;
    let t55 = R::literal(1.0) / inverse_slider_mass.add_product(t52, inverse_slider_mass);
    let t56 = t54 * inverse_slider_mass;
    let t57 = t56 * t55;
    let crank_omega_squared = crank_omega * crank_omega;
    let t58 = t0 * crank_omega_squared;
    let t59 = t58 * cos_crank_phi;
    let t60 = p.crank_length * crank_omega_squared;
    let rod_omega_squared = rod_omega * rod_omega;
    let rod_length_times_rod_omega_squared = p.rod_length * rod_omega_squared;
    let t61 = t3 * rod_omega_squared;
    let t62 = inverse_crank_mass * (p.crank_mass * p.crank_gravity);
    let t63 = t14 * t59;
    let t64 = t62.sub_product(t58, sin_crank_phi) - t63;
    let t65 = (R::literal(0.5) * (t60 * cos_crank_phi)
        .add_product(rod_length_times_rod_omega_squared, cos_rod_phi)).add_product(t16, t59)
        .add_product(t23, t64);
    let t66 = inverse_rod_mass * (p.rod_mass * p.rod_gravity);
    let t67 = (t66 - t62.add_product(R::literal(0.5), (t60 * sin_crank_phi)
        .add_product(rod_length_times_rod_omega_squared, sin_rod_phi)) - t63).sub_product(t25, t64)
        .add_product(t32, t65);
    let t68 = (-(t61 * cos_rod_phi)).add_product(t34, t65).sub_product(t41, t67);
    let t69 = inverse_slider_mass * (p.slider_mass * p.slider_gravity);
    let t70 = (t69 - t66.add_product(t61, sin_rod_phi)).add_product(t35, t65).sub_product(t43, t67)
        .add_product(t48, t68);
    let t71 = t69.add_product(t52, t70);
    let t72 = t71 * t55;
    let t73 = (t17 * t59).sub_product(t27, t64).sub_product(t37, t65).sub_product(t45, t67)
        .add_product(t50, t68).sub_product(t54, t70).add_product(t57, t71) * (R::literal(1.0)
        / (-inverse_crank_inertia).add_product(t17, t6).sub_product(t27, t26).sub_product(t37, t36)
        .sub_product(t45, t44).add_product(t50, t49).sub_product(t54, t53).add_product(t57, t56));
    let t74 = t57 * t73;
    let slider_v_x_dot = inverse_slider_mass * (t68 * t46).sub_product(t48, (t70 * t51)
        .add_product(t52, t74 - t72).sub_product(t54, t73)).sub_product(t50, t73);
    let guide = t72 - t74;
    let drive = -t73;
    Outputs {
        angle: crank_phi,
        rod_angle: rod_phi,
        stroke: slider_x,
        slider_speed: slider_v_x,
        slider_acceleration: slider_v_x_dot,
        torque: drive,
        guide_force: guide,
    }
}

/// T, V and the energy of first-order states \[J\]. 33 operations.
#[must_use]
pub fn energy<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>) -> Energy<R> {
    let [_, crank_y, _, _, rod_y, _, _, slider_y, crank_v_x, crank_v_y, crank_omega, rod_v_x,
        rod_v_y, rod_omega, slider_v_x, slider_v_y] = *state;
    Energy {
        kinetic: (R::literal(0.5) * p.crank_inertia * (crank_omega * crank_omega))
            .add_product(R::literal(0.5) * p.crank_mass, (crank_v_x * crank_v_x)
            .add_product(crank_v_y, crank_v_y)).add_product(R::literal(0.5) * p.rod_mass,
            (rod_v_x * rod_v_x).add_product(rod_v_y, rod_v_y)).add_product(R::literal(0.5)
            * p.rod_inertia, rod_omega * rod_omega).add_product(R::literal(0.5) * p.slider_mass,
            (slider_v_x * slider_v_x).add_product(slider_v_y, slider_v_y)),
        potential: (p.crank_mass * p.crank_gravity * crank_y).add_product(p.rod_mass
            * p.rod_gravity, rod_y).add_product(p.slider_mass * p.slider_gravity, slider_y),
        stored: R::literal(0.0),
    }
}

/// `dE/dt`, power supplied and power dissipated \[W\]. 316 operations.
#[must_use]
pub fn power_balance<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>) -> PowerBalance<R> {
    let [_, _, crank_phi, _, _, rod_phi, _, _, crank_v_x, crank_v_y, crank_omega, rod_v_x, rod_v_y,
        rod_omega, slider_v_x, slider_v_y] = *state;
    let [(sin_crank_phi, cos_crank_phi), (sin_rod_phi, cos_rod_phi)] = R::sin_cos_each([crank_phi,
        rod_phi]);
    let t0 = R::literal(0.5) * p.crank_length;
    let t1 = t0 * cos_crank_phi;
    let t2 = t0 * sin_crank_phi;
    let t3 = R::literal(0.5) * p.rod_length;
    let t4 = t3 * cos_rod_phi;
    let t5 = t3 * sin_rod_phi;
    let inverse_crank_mass = R::literal(1.0) / p.crank_mass;
    let inverse_crank_inertia = R::literal(1.0) / p.crank_inertia;
    let t6 = t2 * inverse_crank_inertia;
    let t7 = t1 * inverse_crank_inertia;
    let inverse_rod_mass = R::literal(1.0) / p.rod_mass;
    let inverse_rod_inertia = R::literal(1.0) / p.rod_inertia;
    let t8 = t5 * inverse_rod_inertia;
    let t9 = t4 * inverse_rod_inertia;
    let inverse_slider_mass = R::literal(1.0) / p.slider_mass;
    let t10 = t6 * t2;
    let t11 = inverse_crank_mass + t10;
    let t12 = R::literal(1.0) / t11;
    let t13 = t7 * t2;
    let t14 = t13 * t12;
    let t15 = inverse_crank_mass - t10;
    let t16 = t15 * t12;
    let t17 = t6 * t12;
    let t18 = t7 * t1;
    let t19 = inverse_crank_mass + t18;
    let t20 = t14 * t13;
    let t21 = R::literal(1.0) / (t20 - t19);
    let t22 = (t6 * t1).add_product(t16, t13);
    let t23 = t22 * t21;
    let t24 = inverse_crank_mass - t18 + t20;
    let t25 = t24 * t21;
    let t26 = t7.sub_product(t17, t13);
    let t27 = t26 * t21;
    let t28 = t8 * t5;
    let t29 = R::literal(1.0) / (-(t11 + inverse_rod_mass + t28)).add_product(t16, t15)
        .sub_product(t23, t22);
    let t30 = t9 * t5;
    let t31 = (t13 + t30).add_product(t14, t15).sub_product(t25, t22);
    let t32 = t31 * t29;
    let t33 = inverse_rod_mass - t28;
    let t34 = t33 * t29;
    let t35 = t30 * t29;
    let t36 = t6.add_product(t17, t15).add_product(t27, t22);
    let t37 = t36 * t29;
    let t38 = t9 * t4;
    let t39 = R::literal(1.0) / (t20 - (t19 + inverse_rod_mass + t38)).sub_product(t25, t24)
        .sub_product(t32, t31);
    let t40 = (t8 * t4).sub_product(t34, t31);
    let t41 = t40 * t39;
    let t42 = (inverse_rod_mass - t38).sub_product(t35, t31);
    let t43 = t42 * t39;
    let t44 = t26.sub_product(t27, t24).add_product(t37, t31);
    let t45 = t44 * t39;
    let t46 = R::literal(1.0) / (inverse_rod_mass + t28 + inverse_slider_mass).add_product(t34, t33)
        .add_product(t41, t40);
    let t47 = t30.sub_product(t35, t33).sub_product(t43, t40);
    let t48 = t47 * t46;
    let t49 = (t37 * t33).sub_product(t45, t40);
    let t50 = t49 * t46;
    let t51 = R::literal(1.0) / (-(inverse_rod_mass + t38 + inverse_slider_mass).add_product(t35,
        t30).add_product(t43, t42)).add_product(t48, t47);
    let t52 = inverse_slider_mass * t51;
    let t53 = (t37 * t30).sub_product(t45, t42).add_product(t50, t47);
    let t54 = t53 * t51;
    let t55 = R::literal(1.0) / inverse_slider_mass.add_product(t52, inverse_slider_mass);
    let t56 = t54 * inverse_slider_mass;
    let t57 = t56 * t55;
    let crank_mass_times_crank_gravity = p.crank_mass * p.crank_gravity;
    let rod_mass_times_rod_gravity = p.rod_mass * p.rod_gravity;
    let slider_mass_times_slider_gravity = p.slider_mass * p.slider_gravity;
    let crank_omega_squared = crank_omega * crank_omega;
    let t58 = t0 * crank_omega_squared;
    let t59 = t58 * cos_crank_phi;
    let t60 = p.crank_length * crank_omega_squared;
    let rod_omega_squared = rod_omega * rod_omega;
    let rod_length_times_rod_omega_squared = p.rod_length * rod_omega_squared;
    let t61 = t3 * rod_omega_squared;
    let t62 = inverse_crank_mass * crank_mass_times_crank_gravity;
    let t63 = t14 * t59;
    let t64 = t62.sub_product(t58, sin_crank_phi) - t63;
    let t65 = (R::literal(0.5) * (t60 * cos_crank_phi)
        .add_product(rod_length_times_rod_omega_squared, cos_rod_phi)).add_product(t16, t59)
        .add_product(t23, t64);
    let t66 = inverse_rod_mass * rod_mass_times_rod_gravity;
    let t67 = (t66 - t62.add_product(R::literal(0.5), (t60 * sin_crank_phi)
        .add_product(rod_length_times_rod_omega_squared, sin_rod_phi)) - t63).sub_product(t25, t64)
        .add_product(t32, t65);
    let t68 = (-(t61 * cos_rod_phi)).add_product(t34, t65).sub_product(t41, t67);
    let t69 = inverse_slider_mass * slider_mass_times_slider_gravity;
    let t70 = (t69 - t66.add_product(t61, sin_rod_phi)).add_product(t35, t65).sub_product(t43, t67)
        .add_product(t48, t68);
    let t71 = t69.add_product(t52, t70);
    let t72 = (t17 * t59).sub_product(t27, t64).sub_product(t37, t65).sub_product(t45, t67)
        .add_product(t50, t68).sub_product(t54, t70).add_product(t57, t71) * (R::literal(1.0)
        / (-inverse_crank_inertia).add_product(t17, t6).sub_product(t27, t26).sub_product(t37, t36)
        .sub_product(t45, t44).add_product(t50, t49).sub_product(t54, t53).add_product(t57, t56));
    let t73 = (-(t71 * t55)).add_product(t57, t72);
    let t74 = (t70 * t51).add_product(t52, t73).sub_product(t54, t72);
    let t75 = (-(t68 * t46)).add_product(t48, t74).add_product(t50, t72);
    let t76 = (t67 * t39).sub_product(t41, t75).sub_product(t43, t74).sub_product(t45, t72);
    let t77 = (-(t65 * t29).add_product(t32, t76).add_product(t34, t75).add_product(t35, t74))
        .add_product(t37, t72);
    let t78 = (t64 * t21).sub_product(t23, t77).sub_product(t25, t76).sub_product(t27, t72);
    let t79 = (t59 * t12).add_product(t14, t78).add_product(t16, t77).add_product(t14, t76)
        .sub_product(t17, t72);
    let rod_omega_dot = (t9 * t76).sub_product(t8, t77).sub_product(t8, t75).add_product(t9, t74);
    let rod_v_y_dot = (-t66.add_product(inverse_rod_mass, t76)).add_product(inverse_rod_mass, t74);
    let rod_v_x_dot = (inverse_rod_mass * t75).sub_product(inverse_rod_mass, t77);
    let crank_omega_dot = (t7 * t78).sub_product(t6, t79).sub_product(t6, t77).add_product(t7, t76)
        .sub_product(inverse_crank_inertia, t72);
    let crank_v_y_dot = (-t62.add_product(inverse_crank_mass, t78)).add_product(inverse_crank_mass,
        t76);
    let crank_v_x_dot = (inverse_crank_mass * t77).sub_product(inverse_crank_mass, t79);
    PowerBalance {
        stored_rate: (crank_mass_times_crank_gravity * crank_v_y)
            .add_product(rod_mass_times_rod_gravity, rod_v_y)
            .add_product(slider_mass_times_slider_gravity, slider_v_y).add_product(p.crank_mass
            * crank_v_x, crank_v_x_dot).add_product(p.crank_mass * crank_v_y, crank_v_y_dot)
            .add_product(p.crank_inertia * crank_omega, crank_omega_dot).add_product(p.rod_mass
            * rod_v_x, rod_v_x_dot).add_product(p.rod_mass * rod_v_y, rod_v_y_dot)
            .add_product(p.rod_inertia * rod_omega, rod_omega_dot).sub_product(p.slider_mass
            * slider_v_x, inverse_slider_mass * t75).sub_product(p.slider_mass * slider_v_y, t69
            .add_product(inverse_slider_mass, t74).add_product(inverse_slider_mass, t73)),
        supplied: -(p.speed * t72),
        dissipated: R::literal(0.0),
    }
}

/// `g` of each constraint, zero for those of velocities alone. 25 operations.
#[must_use]
pub fn constraint_values<R: Real>(time: R, state: &[R; STATES],
        p: &Parameters<R>) -> [R; CONSTRAINTS] {
    let [crank_x, crank_y, crank_phi, rod_x, rod_y, rod_phi, slider_x, slider_y, ..] = *state;
    let [(sin_crank_phi, cos_crank_phi), (sin_rod_phi, cos_rod_phi)] = R::sin_cos_each([crank_phi,
        rod_phi]);
    let t0 = R::literal(0.5) * p.crank_length;
    let t1 = t0 * cos_crank_phi;
    let crank_start_x = crank_x - t1;
    let t2 = t0 * sin_crank_phi;
    let crank_start_y = crank_y - t2;
    let crank_end_x = crank_x + t1;
    let crank_end_y = crank_y + t2;
    let t3 = R::literal(0.5) * p.rod_length;
    let t4 = t3 * cos_rod_phi;
    let rod_start_x = rod_x - t4;
    let t5 = t3 * sin_rod_phi;
    let rod_start_y = rod_y - t5;
    let rod_end_x = rod_x + t4;
    let rod_end_y = rod_y + t5;
    let pin_a_x_value = rod_start_x - crank_end_x;
    let pin_a_y_value = rod_start_y - crank_end_y;
    let pin_b_x_value = slider_x - rod_end_x;
    let pin_b_y_value = slider_y - rod_end_y;
    let drive_value = (crank_phi - p.start).sub_product(p.speed, time);
    [crank_start_x, crank_start_y, pin_a_x_value, pin_a_y_value, pin_b_x_value, pin_b_y_value,
        slider_y, drive_value]
}

/// `g'` of each constraint. 25 operations.
#[must_use]
pub fn constraint_rates<R: Real>(_time: R, state: &[R; STATES],
        p: &Parameters<R>) -> [R; CONSTRAINTS] {
    let [_, _, crank_phi, _, _, rod_phi, _, _, crank_v_x, crank_v_y, crank_omega, rod_v_x, rod_v_y,
        rod_omega, slider_v_x, slider_v_y] = *state;
    let [(sin_crank_phi, cos_crank_phi), (sin_rod_phi, cos_rod_phi)] = R::sin_cos_each([crank_phi,
        rod_phi]);
    let t0 = R::literal(0.5) * p.crank_length * crank_omega;
    let t1 = t0 * sin_crank_phi;
    let pin_o_x_rate = crank_v_x + t1;
    let t2 = t0 * cos_crank_phi;
    let pin_o_y_rate = crank_v_y - t2;
    let t3 = R::literal(0.5) * p.rod_length * rod_omega;
    let t4 = t3 * sin_rod_phi;
    let pin_a_x_rate = rod_v_x + t1 + t4 - crank_v_x;
    let t5 = t3 * cos_rod_phi;
    let pin_a_y_rate = rod_v_y - crank_v_y - t2 - t5;
    let pin_b_x_rate = slider_v_x + t4 - rod_v_x;
    let pin_b_y_rate = slider_v_y - rod_v_y - t5;
    let drive_rate = crank_omega - p.speed;
    [pin_o_x_rate, pin_o_y_rate, pin_a_x_rate, pin_a_y_rate, pin_b_x_rate, pin_b_y_rate,
        slider_v_y, drive_rate]
}

/// `G = dg'/dq'`, values in the order of its pattern. 12 operations.
#[must_use]
pub fn constraint_matrix<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>) -> [R; 20] {
    let [_, _, crank_phi, _, _, rod_phi, ..] = *state;
    let [(sin_crank_phi, cos_crank_phi), (sin_rod_phi, cos_rod_phi)] = R::sin_cos_each([crank_phi,
        rod_phi]);
    let t0 = R::literal(0.5) * p.crank_length;
    let t1 = t0 * sin_crank_phi;
    let t2 = R::literal(0.5) * p.rod_length;
    let t3 = t2 * sin_rod_phi;
    let t4 = -(t0 * cos_crank_phi);
    let t5 = -(t2 * cos_rod_phi);
    [R::literal(1.0), t1, R::literal(1.0), t4, R::literal(-1.0), t1, R::literal(1.0), t3,
        R::literal(-1.0), t4, R::literal(1.0), t5, R::literal(-1.0), t3, R::literal(1.0),
        R::literal(-1.0), t5, R::literal(1.0), R::literal(1.0), R::literal(1.0)]
}

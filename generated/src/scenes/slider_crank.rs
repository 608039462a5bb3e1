// Emitted by Machinist 0.1.0; do not edit. To make it again:
//
//     cargo run --release -- gen
//
// Sources, with SHA-256:
//   8a103c91fe4b3310f3f4544fb7277f7196277442c1a3d474548a963e8652fb3d  scenes/slider_crank.toml
//   9870540d48dd190f3f4e3c2fea172f613c63b75b8e7bdb1d3432a0e230aaf646  units/planar_body.toml
//
// Slider-crank at constant speed
//
// Crank, rod and slider as three bodies in a plane, connected by pins, a guide and a drive that turns
// the crank. The constraint force of the drive is its torque.
//
// Source:
//   Textbook.
//
// All quantities are in SI units.
// Shapes: coordinates 8, states 16, parameters 12, outputs 7, constraints 8.
// Nonzeros: mass_matrix 8 of 8 by 8, rate_jacobian 26 of 16 by 16, parameter_jacobian 9 of 16 by 12,
//     constraint_matrix 20 of 8 by 8.
// Operations: rate 60, forcing 6, rate_jacobian 120, parameter_jacobian 88, outputs 94, energy 33,
//     power_balance 116, constraint_values 25, constraint_rates 25, constraint_matrix 12, prepare 4,
//     prepared_rate 56, prepared_rate_jacobian 116, prepared_jacobians 162.

use ::machinist_contract::{Energy, PowerBalance, Real};

::machinist_contract::simulator! {
    /// Slider-crank at constant speed
    ///
    /// Crank, rod and slider as three bodies in a plane, connected by pins, a guide and a drive that turns
    /// the crank. The constraint force of the drive is its torque.
    ///
    /// Source: Textbook.
    SliderCrank: "slider_crank", "Slider-crank at constant speed";
    run from 0.0, until 1.0, points 1001, rtol 1e-8, method "dop853";
    quadratures 0, discontinuities 0;
    constraints; prepared; jacobians_at_once;
}

::machinist_contract::parameters! {
    speed: 30.0, "rad/s", "speed", "speed of the crank";
    start: 0.4, "rad", "start", "initial angle of the crank";
    crank_length: 0.05, "m", "crank.length", "length of the bar";
    crank_mass: 0.8, "kg", "crank.mass", "mass";
    crank_inertia: 0.0002, "kg m^2", "crank.inertia", "moment of inertia about the centre of mass";
    crank_gravity: 9.81, "m/s^2", "crank.gravity", "gravitational acceleration";
    rod_length: 0.2, "m", "rod.length", "length of the bar";
    rod_mass: 0.6, "kg", "rod.mass", "mass";
    rod_inertia: 0.002, "kg m^2", "rod.inertia", "moment of inertia about the centre of mass";
    rod_gravity: 9.81, "m/s^2", "rod.gravity", "gravitational acceleration";
    slider_mass: 1.1, "kg", "slider.mass", "mass";
    slider_gravity: 9.81, "m/s^2", "slider.gravity", "gravitational acceleration";
}

::machinist_contract::outputs! {
    angle: "rad", "angle", "angle of the bar from the horizontal";
    rod_angle: "rad", "rod_angle", "angle of the bar from the horizontal";
    stroke: "m", "stroke", "horizontal position of the centre of mass";
    slider_speed: "m/s", "slider_speed", "rate of horizontal position of the centre of mass";
    slider_acceleration: at_once "m/s^2", "slider_acceleration", "acceleration of the slider";
    torque: at_once "N m", "torque", "torque of the drive on the crank";
    guide_force: at_once "N", "guide_force", "upward force of the guide on the slider";
}

::machinist_contract::states! {
    CRANK_X: position guess, 0.1, "m", "crank.x", "horizontal position of the centre of mass";
    CRANK_Y: position guess, 0.1, "m", "crank.y", "height of the centre of mass";
    CRANK_PHI: position guess, 1.0, "rad", "crank.phi", "angle of the bar from the horizontal";
    ROD_X: position guess, 0.1, "m", "rod.x", "horizontal position of the centre of mass";
    ROD_Y: position guess, 0.1, "m", "rod.y", "height of the centre of mass";
    ROD_PHI: position guess, 1.0, "rad", "rod.phi", "angle of the bar from the horizontal";
    SLIDER_X: position guess, 0.1, "m", "slider.x", "horizontal position of the centre of mass";
    SLIDER_Y: position guess, 0.1, "m", "slider.y", "height of the centre of mass";
    CRANK_V_X: velocity guess, 1.0, "m/s", "crank.v_x", "rate of horizontal position of the centre of mass";
    CRANK_V_Y: velocity guess, 1.0, "m/s", "crank.v_y", "rate of height of the centre of mass";
    CRANK_OMEGA: velocity guess, 10.0, "rad/s", "crank.omega", "rate of angle of the bar from the horizontal";
    ROD_V_X: velocity guess, 1.0, "m/s", "rod.v_x", "rate of horizontal position of the centre of mass";
    ROD_V_Y: velocity guess, 1.0, "m/s", "rod.v_y", "rate of height of the centre of mass";
    ROD_OMEGA: velocity guess, 10.0, "rad/s", "rod.omega", "rate of angle of the bar from the horizontal";
    SLIDER_V_X: velocity guess, 1.0, "m/s", "slider.v_x", "rate of horizontal position of the centre of mass";
    SLIDER_V_Y: velocity guess, 1.0, "m/s", "slider.v_y", "rate of height of the centre of mass";
}

::machinist_contract::constraints! {
    "pin_o_x": of_positions, "m", "the crank's pin in the frame, horizontal";
    "pin_o_y": of_positions, "m", "the crank's pin in the frame, vertical";
    "pin_a_x": of_positions, "m", "pin between crank and rod, horizontal";
    "pin_a_y": of_positions, "m", "pin between crank and rod, vertical";
    "pin_b_x": of_positions, "m", "pin between rod and slider, horizontal";
    "pin_b_y": of_positions, "m", "pin between rod and slider, vertical";
    "guide": of_positions, "m", "the slider on its guide";
    "drive": of_positions, "1", "the crank turns at constant speed";
}

::machinist_contract::patterns! {
    /// Nonzeros of M.
    MASS_MATRIX_PATTERN: 8 by 8 { 0 [0] 1 [1] 2 [2] 3 [3] 4 [4] 5 [5] 6 [6] 7 [7] }
    /// Nonzeros of dy'/dy.
    RATE_JACOBIAN_PATTERN: 16 by 16 { 0 [8] 1 [9] 2 [10] 3 [11] 4 [12] 5 [13] 6 [14] 7 [15]
        8 [2 10] 9 [2 10] 11 [2 5 10 13] 12 [2 10] 13 [2 5 10 13] 14 [2 5 10 13] }
    /// Nonzeros of dy'/dp.
    PARAMETER_JACOBIAN_PATTERN: 16 by 12 { 8 [2] 9 [2] 11 [2 6] 12 [2] 13 [2 6] 14 [2 6] }
    /// Nonzeros of G = dg'/dq'.
    CONSTRAINT_MATRIX_PATTERN: 8 by 8 { 0 [0 2] 1 [1 2] 2 [0 2 3 5] 3 [1 2 4 5] 4 [3 5 6] 5 [4 5 7]
        6 [7] 7 [2] }
}

::machinist_contract::constants! {
    t0, t1, inverse_rod_mass, inverse_rod_inertia
}

/// Returns the constants of `rate` and its Jacobians from the parameters. 4 operations.
#[must_use]
#[inline]
pub fn prepare<R: Real>(p: &Parameters<R>) -> Constants<R> {
    let t0 = R::literal(0.5) * p.crank_length;
    let t1 = R::literal(0.5) * p.rod_length;
    let inverse_rod_mass = R::literal(1.0) / p.rod_mass;
    let inverse_rod_inertia = R::literal(1.0) / p.rod_inertia;
    Constants { t0, t1, inverse_rod_mass, inverse_rod_inertia }
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

/// As `rate`, with the constants of the parameters from `prepare`. 56 operations.
#[must_use]
#[inline]
pub fn prepared_rate<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>,
        c: &Constants<R>) -> [R; STATES] {
    let [_, _, crank_phi, _, _, rod_phi, _, _, crank_v_x, crank_v_y, crank_omega, rod_v_x, rod_v_y,
        rod_omega, slider_v_x, slider_v_y] = *state;
    let [(sin_crank_phi, cos_crank_phi), (sin_rod_phi, cos_rod_phi)] = R::sin_cos_each([crank_phi,
        rod_phi]);
    let t0 = c.t1 * cos_rod_phi;
    let t1 = t0 * c.inverse_rod_inertia;
    let t2 = t1 * t0;
    let t3 = c.inverse_rod_mass + t2;
    let t4 = R::literal(1.0) / t3;
    let t5 = c.inverse_rod_mass - t2;
    let t6 = t5 * t4;
    let crank_omega_squared = crank_omega * crank_omega;
    let t7 = c.t0 * crank_omega_squared;
    let t8 = t7 * cos_crank_phi;
    let crank_v_x_dot = -t8;
    let t9 = t7 * sin_crank_phi;
    let crank_v_y_dot = -t9;
    let t10 = p.crank_length * crank_omega_squared;
    let rod_omega_squared = rod_omega * rod_omega;
    let rod_length_times_rod_omega_squared = p.rod_length * rod_omega_squared;
    let t11 = c.t1 * rod_omega_squared;
    let t12 = t9.add_product(R::literal(0.5), (t10 * sin_crank_phi)
        .add_product(rod_length_times_rod_omega_squared, sin_rod_phi));
    let t13 = (t11 * sin_rod_phi).add_product(t6, t12) * (R::literal(1.0) / (-t3).add_product(t6,
        t5));
    let t14 = (t12 * t4).sub_product(t6, t13);
    let rod_omega_dot = (-(t1 * t13)).add_product(t1, t14);
    let rod_v_y_dot = -(c.inverse_rod_mass * t13).add_product(c.inverse_rod_mass, t14);
    let t15 = c.t1 * sin_rod_phi * rod_omega_dot;
    let t16 = t8.add_product(R::literal(0.5), (t10 * cos_crank_phi)
        .add_product(rod_length_times_rod_omega_squared, cos_rod_phi)) + t15;
    let rod_v_x_dot = -t16;
    let slider_v_x_dot = -(t15.add_product(t11, cos_rod_phi) + t16);
    [crank_v_x, crank_v_y, crank_omega, rod_v_x, rod_v_y, rod_omega, slider_v_x, slider_v_y,
        crank_v_x_dot, crank_v_y_dot, R::literal(0.0), rod_v_x_dot, rod_v_y_dot, rod_omega_dot,
        slider_v_x_dot, R::literal(0.0)]
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

/// As `rate_jacobian`, with the constants of the parameters from `prepare`. 116 operations.
#[must_use]
pub fn prepared_rate_jacobian<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>,
        c: &Constants<R>) -> [R; 26] {
    let crank_phi = state[2];
    let rod_phi = state[5];
    let crank_omega = state[10];
    let rod_omega = state[13];
    let [(sin_crank_phi, cos_crank_phi), (sin_rod_phi, cos_rod_phi)] = R::sin_cos_each([crank_phi,
        rod_phi]);
    let t0 = c.t1 * cos_rod_phi;
    let t1 = c.t1 * sin_rod_phi;
    let t2 = t0 * c.inverse_rod_inertia;
    let t3 = t2 * t0;
    let t4 = c.inverse_rod_mass + t3;
    let t5 = R::literal(1.0) / t4;
    let t6 = c.inverse_rod_mass - t3;
    let t7 = t6 * t5;
    let t8 = R::literal(1.0) / (-t4).add_product(t7, t6);
    let crank_omega_squared = crank_omega * crank_omega;
    let t9 = c.t0 * crank_omega_squared;
    let t10 = t9 * cos_crank_phi;
    let crank_v_x_dot = -t10;
    let crank_v_x_dot_by_crank_phi = t9 * sin_crank_phi;
    let rod_omega_squared = rod_omega * rod_omega;
    let t11 = c.t1 * rod_omega_squared;
    let t12 = t11 * sin_rod_phi;
    let t13 = crank_v_x_dot_by_crank_phi.add_product(R::literal(0.5), (p.crank_length
        * crank_omega_squared * sin_crank_phi).add_product(p.rod_length * rod_omega_squared,
        sin_rod_phi));
    let t14 = t12.add_product(t7, t13) * t8;
    let rod_omega_dot = (-(t2 * t14)).add_product(t2, (t13 * t5).sub_product(t7, t14));
    let t15 = (t11 * cos_rod_phi).add_product(t1, rod_omega_dot);
    let t16 = t10 + t10;
    let t17 = t7 * t16 * t8;
    let t18 = (t16 * t5).sub_product(t7, t17);
    let rod_omega_dot_by_crank_phi = (-(t2 * t17)).add_product(t2, t18);
    let rod_v_y_dot_by_crank_phi = -(c.inverse_rod_mass * t17).add_product(c.inverse_rod_mass, t18);
    let t19 = crank_v_x_dot_by_crank_phi + crank_v_x_dot_by_crank_phi;
    let t20 = t1 * rod_omega_dot_by_crank_phi;
    let rod_v_x_dot_by_crank_phi = t19 - t20;
    let slider_v_x_dot_by_crank_phi = t19 - t20 - t20;
    let t21 = t12.sub_product(t0, rod_omega_dot);
    let t22 = t15.add_product(t7, t15) * t8;
    let rod_omega_dot_by_rod_phi = (-(t2 * t22)).add_product(t2, (t15 * t5).sub_product(t7, t22));
    let t23 = t1 * rod_omega_dot_by_rod_phi;
    let rod_v_x_dot_by_rod_phi = t21 - t23;
    let slider_v_x_dot_by_rod_phi = rod_v_x_dot_by_rod_phi - (t23 - t21);
    let crank_length_times_crank_omega = p.crank_length * crank_omega;
    let t24 = crank_length_times_crank_omega * cos_crank_phi;
    let crank_v_x_dot_by_crank_omega = -t24;
    let t25 = crank_length_times_crank_omega * sin_crank_phi;
    let crank_v_y_dot_by_crank_omega = -t25;
    let t26 = t25 + t25;
    let t27 = t7 * t26 * t8;
    let t28 = (t26 * t5).sub_product(t7, t27);
    let rod_omega_dot_by_crank_omega = (-(t2 * t27)).add_product(t2, t28);
    let rod_v_y_dot_by_crank_omega = -(c.inverse_rod_mass * t27).add_product(c.inverse_rod_mass,
        t28);
    let t29 = t1 * rod_omega_dot_by_crank_omega;
    let t30 = t24 + t24 + t29;
    let rod_v_x_dot_by_crank_omega = -t30;
    let slider_v_x_dot_by_crank_omega = -(t29 + t30);
    let rod_length_times_rod_omega = p.rod_length * rod_omega;
    let t31 = rod_length_times_rod_omega * sin_rod_phi;
    let t32 = t31.add_product(t7, t31) * t8;
    let rod_omega_dot_by_rod_omega = (-(t2 * t32)).add_product(t2, (t31 * t5).sub_product(t7, t32));
    let t33 = (rod_length_times_rod_omega * cos_rod_phi).add_product(t1,
        rod_omega_dot_by_rod_omega);
    let rod_v_x_dot_by_rod_omega = -t33;
    let slider_v_x_dot_by_rod_omega = -(t33 + t33);
    [R::literal(1.0), R::literal(1.0), R::literal(1.0), R::literal(1.0), R::literal(1.0),
        R::literal(1.0), R::literal(1.0), R::literal(1.0), crank_v_x_dot_by_crank_phi,
        crank_v_x_dot_by_crank_omega, crank_v_x_dot, crank_v_y_dot_by_crank_omega,
        rod_v_x_dot_by_crank_phi, rod_v_x_dot_by_rod_phi, rod_v_x_dot_by_crank_omega,
        rod_v_x_dot_by_rod_omega, rod_v_y_dot_by_crank_phi, rod_v_y_dot_by_crank_omega,
        rod_omega_dot_by_crank_phi, rod_omega_dot_by_rod_phi, rod_omega_dot_by_crank_omega,
        rod_omega_dot_by_rod_omega, slider_v_x_dot_by_crank_phi, slider_v_x_dot_by_rod_phi,
        slider_v_x_dot_by_crank_omega, slider_v_x_dot_by_rod_omega]
}

/// `rate_jacobian`, then `parameter_jacobian`, with the constants of the parameters from `prepare`.
/// 162 operations.
#[must_use]
pub fn prepared_jacobians<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>,
        c: &Constants<R>) -> [R; 35] {
    let crank_phi = state[2];
    let rod_phi = state[5];
    let crank_omega = state[10];
    let rod_omega = state[13];
    let [(sin_crank_phi, cos_crank_phi), (sin_rod_phi, cos_rod_phi)] = R::sin_cos_each([crank_phi,
        rod_phi]);
    let t0 = c.t1 * cos_rod_phi;
    let t1 = c.t1 * sin_rod_phi;
    let t2 = t0 * c.inverse_rod_inertia;
    let t3 = t2 * t0;
    let t4 = c.inverse_rod_mass + t3;
    let t5 = R::literal(1.0) / t4;
    let t6 = c.inverse_rod_mass - t3;
    let t7 = t6 * t5;
    let t8 = R::literal(1.0) / (-t4).add_product(t7, t6);
    let crank_omega_squared = crank_omega * crank_omega;
    let t9 = c.t0 * crank_omega_squared;
    let t10 = t9 * cos_crank_phi;
    let crank_v_x_dot = -t10;
    let crank_v_x_dot_by_crank_phi = t9 * sin_crank_phi;
    let rod_omega_squared = rod_omega * rod_omega;
    let t11 = c.t1 * rod_omega_squared;
    let t12 = t11 * sin_rod_phi;
    let t13 = crank_v_x_dot_by_crank_phi.add_product(R::literal(0.5), (p.crank_length
        * crank_omega_squared * sin_crank_phi).add_product(p.rod_length * rod_omega_squared,
        sin_rod_phi));
    let t14 = t12.add_product(t7, t13) * t8;
    let rod_omega_dot = (-(t2 * t14)).add_product(t2, (t13 * t5).sub_product(t7, t14));
    let t15 = (t11 * cos_rod_phi).add_product(t1, rod_omega_dot);
    let t16 = t10 + t10;
    let t17 = t7 * t16 * t8;
    let t18 = (t16 * t5).sub_product(t7, t17);
    let rod_omega_dot_by_crank_phi = (-(t2 * t17)).add_product(t2, t18);
    let rod_v_y_dot_by_crank_phi = -(c.inverse_rod_mass * t17).add_product(c.inverse_rod_mass, t18);
    let t19 = t1 * rod_omega_dot_by_crank_phi;
    let rod_v_x_dot_by_crank_phi = crank_v_x_dot_by_crank_phi + crank_v_x_dot_by_crank_phi - t19;
    let slider_v_x_dot_by_crank_phi = rod_v_x_dot_by_crank_phi - t19;
    let t20 = t12.sub_product(t0, rod_omega_dot);
    let t21 = t15.add_product(t7, t15) * t8;
    let rod_omega_dot_by_rod_phi = (-(t2 * t21)).add_product(t2, (t15 * t5).sub_product(t7, t21));
    let t22 = t1 * rod_omega_dot_by_rod_phi;
    let rod_v_x_dot_by_rod_phi = t20 - t22;
    let slider_v_x_dot_by_rod_phi = rod_v_x_dot_by_rod_phi - (t22 - t20);
    let crank_length_times_crank_omega = p.crank_length * crank_omega;
    let t23 = crank_length_times_crank_omega * cos_crank_phi;
    let crank_v_x_dot_by_crank_omega = -t23;
    let t24 = crank_length_times_crank_omega * sin_crank_phi;
    let crank_v_y_dot_by_crank_omega = -t24;
    let t25 = t24 + t24;
    let t26 = t7 * t25 * t8;
    let t27 = (t25 * t5).sub_product(t7, t26);
    let rod_omega_dot_by_crank_omega = (-(t2 * t26)).add_product(t2, t27);
    let rod_v_y_dot_by_crank_omega = -(c.inverse_rod_mass * t26).add_product(c.inverse_rod_mass,
        t27);
    let t28 = t1 * rod_omega_dot_by_crank_omega;
    let t29 = t23 + t23 + t28;
    let rod_v_x_dot_by_crank_omega = -t29;
    let slider_v_x_dot_by_crank_omega = -(t28 + t29);
    let rod_length_times_rod_omega = p.rod_length * rod_omega;
    let t30 = rod_length_times_rod_omega * sin_rod_phi;
    let t31 = t30.add_product(t7, t30) * t8;
    let rod_omega_dot_by_rod_omega = (-(t2 * t31)).add_product(t2, (t30 * t5).sub_product(t7, t31));
    let t32 = (rod_length_times_rod_omega * cos_rod_phi).add_product(t1,
        rod_omega_dot_by_rod_omega);
    let rod_v_x_dot_by_rod_omega = -t32;
    let slider_v_x_dot_by_rod_omega = -(t32 + t32);
    let t33 = R::literal(0.5) * crank_omega_squared;
    let t34 = t33 * cos_crank_phi;
    let crank_v_x_dot_by_crank_length = -t34;
    let t35 = t33 * sin_crank_phi;
    let crank_v_y_dot_by_crank_length = -t35;
    let t36 = t35 + t35;
    let t37 = t7 * t36 * t8;
    let t38 = (t36 * t5).sub_product(t7, t37);
    let rod_omega_dot_by_crank_length = (-(t2 * t37)).add_product(t2, t38);
    let rod_v_y_dot_by_crank_length = -(c.inverse_rod_mass * t37).add_product(c.inverse_rod_mass,
        t38);
    let t39 = t1 * rod_omega_dot_by_crank_length;
    let t40 = t34 + t34 + t39;
    let rod_v_x_dot_by_crank_length = -t40;
    let slider_v_x_dot_by_crank_length = -(t39 + t40);
    let t41 = R::literal(0.5) * rod_omega_squared;
    let t42 = (-(t41 * sin_rod_phi)).add_product(R::literal(0.5) * cos_rod_phi, rod_omega_dot);
    let t43 = t42.add_product(t7, t42) * t8;
    let rod_omega_dot_by_rod_length = (t2 * t43).add_product(t2, (-(t42 * t5)).add_product(t7,
        t43));
    let t44 = (t41 * cos_rod_phi).add_product(R::literal(0.5) * sin_rod_phi, rod_omega_dot)
        .add_product(t1, rod_omega_dot_by_rod_length);
    let rod_v_x_dot_by_rod_length = -t44;
    let slider_v_x_dot_by_rod_length = -(t44 + t44);
    [R::literal(1.0), R::literal(1.0), R::literal(1.0), R::literal(1.0), R::literal(1.0),
        R::literal(1.0), R::literal(1.0), R::literal(1.0), crank_v_x_dot_by_crank_phi,
        crank_v_x_dot_by_crank_omega, crank_v_x_dot, crank_v_y_dot_by_crank_omega,
        rod_v_x_dot_by_crank_phi, rod_v_x_dot_by_rod_phi, rod_v_x_dot_by_crank_omega,
        rod_v_x_dot_by_rod_omega, rod_v_y_dot_by_crank_phi, rod_v_y_dot_by_crank_omega,
        rod_omega_dot_by_crank_phi, rod_omega_dot_by_rod_phi, rod_omega_dot_by_crank_omega,
        rod_omega_dot_by_rod_omega, slider_v_x_dot_by_crank_phi, slider_v_x_dot_by_rod_phi,
        slider_v_x_dot_by_crank_omega, slider_v_x_dot_by_rod_omega, crank_v_x_dot_by_crank_length,
        crank_v_y_dot_by_crank_length, rod_v_x_dot_by_crank_length, rod_v_x_dot_by_rod_length,
        rod_v_y_dot_by_crank_length, rod_omega_dot_by_crank_length, rod_omega_dot_by_rod_length,
        slider_v_x_dot_by_crank_length, slider_v_x_dot_by_rod_length]
}

/// Partial derivative of `y'` with respect to time. No operations.
#[must_use]
pub fn time_derivative<R: Real>(_time: R, _state: &[R; STATES], _p: &Parameters<R>) -> [R; STATES] {
    [R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0),
        R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0),
        R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0),
        R::literal(0.0)]
}

/// Wanted outputs. 94 operations.
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
    let inverse_rod_mass = R::literal(1.0) / p.rod_mass;
    let t6 = t4 * (R::literal(1.0) / p.rod_inertia);
    let t7 = t6 * t4;
    let t8 = inverse_rod_mass + t7;
    let t9 = R::literal(1.0) / t8;
    let t10 = inverse_rod_mass - t7;
    let t11 = t10 * t9;
    let t12 = R::literal(1.0) / (-t8).add_product(t11, t10);
    let crank_omega_squared = crank_omega * crank_omega;
    let t13 = t0 * crank_omega_squared;
    let t14 = t13 * cos_crank_phi;
    let t15 = t13 * sin_crank_phi;
    let t16 = p.crank_length * crank_omega_squared;
    let rod_omega_squared = rod_omega * rod_omega;
    let rod_length_times_rod_omega_squared = p.rod_length * rod_omega_squared;
    let t17 = t3 * rod_omega_squared;
    let t18 = t15.add_product(R::literal(0.5), (t16 * sin_crank_phi)
        .add_product(rod_length_times_rod_omega_squared, sin_rod_phi));
    let t19 = (t17 * sin_rod_phi).add_product(t11, t18) * t12;
    let t20 = (t18 * t9).sub_product(t11, t19);
    let rod_omega_dot = (-(t6 * t19)).add_product(t6, t20);
    let t21 = t5 * rod_omega_dot;
    let t22 = t14.add_product(R::literal(0.5), (t16 * cos_crank_phi)
        .add_product(rod_length_times_rod_omega_squared, cos_rod_phi)) + t21;
    let t23 = t21.add_product(t17, cos_rod_phi) + t22;
    let slider_v_x_dot = -t23;
    let t24 = p.slider_mass * t23;
    let t25 = t24.add_product(p.rod_mass, t22);
    let t26 = inverse_rod_mass * (-(p.rod_mass * p.rod_gravity)).add_product(p.rod_mass,
        (inverse_rod_mass * t19).add_product(inverse_rod_mass, t20));
    let t27 = t6 * (p.rod_inertia * rod_omega_dot).add_product(t5, t24).add_product(t5, t25);
    let t28 = t26 + t27;
    let t29 = (t26 - t27).sub_product(t11, t28) * t12;
    let t30 = (t28 * t9).add_product(t11, t29);
    let guide = t29.add_product(p.slider_mass, p.slider_gravity);
    let drive = (-(-(t2 * t25)).add_product(t1, t30).add_product(t1,
        (-(p.crank_mass * p.crank_gravity)).add_product(p.crank_mass, t15) + t30)).add_product(t2,
        t25.add_product(p.crank_mass, t14));
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

/// `dE/dt`, power supplied and power dissipated \[W\]. 116 operations.
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
    let inverse_rod_mass = R::literal(1.0) / p.rod_mass;
    let t6 = t4 * (R::literal(1.0) / p.rod_inertia);
    let t7 = t6 * t4;
    let t8 = inverse_rod_mass + t7;
    let t9 = R::literal(1.0) / t8;
    let t10 = inverse_rod_mass - t7;
    let t11 = t10 * t9;
    let t12 = R::literal(1.0) / (-t8).add_product(t11, t10);
    let crank_mass_times_crank_gravity = p.crank_mass * p.crank_gravity;
    let rod_mass_times_rod_gravity = p.rod_mass * p.rod_gravity;
    let crank_omega_squared = crank_omega * crank_omega;
    let t13 = t0 * crank_omega_squared;
    let t14 = t13 * cos_crank_phi;
    let t15 = t13 * sin_crank_phi;
    let t16 = p.crank_length * crank_omega_squared;
    let rod_omega_squared = rod_omega * rod_omega;
    let rod_length_times_rod_omega_squared = p.rod_length * rod_omega_squared;
    let t17 = t3 * rod_omega_squared;
    let t18 = t15.add_product(R::literal(0.5), (t16 * sin_crank_phi)
        .add_product(rod_length_times_rod_omega_squared, sin_rod_phi));
    let t19 = (t17 * sin_rod_phi).add_product(t11, t18) * t12;
    let t20 = (t18 * t9).sub_product(t11, t19);
    let rod_omega_dot = (-(t6 * t19)).add_product(t6, t20);
    let t21 = (inverse_rod_mass * t19).add_product(inverse_rod_mass, t20);
    let t22 = t5 * rod_omega_dot;
    let t23 = t14.add_product(R::literal(0.5), (t16 * cos_crank_phi)
        .add_product(rod_length_times_rod_omega_squared, cos_rod_phi)) + t22;
    let t24 = t22.add_product(t17, cos_rod_phi) + t23;
    let t25 = p.slider_mass * t24;
    let t26 = t25.add_product(p.rod_mass, t23);
    let t27 = inverse_rod_mass * (-rod_mass_times_rod_gravity).add_product(p.rod_mass, t21);
    let t28 = t6 * (p.rod_inertia * rod_omega_dot).add_product(t5, t25).add_product(t5, t26);
    let t29 = t27 + t28;
    let t30 = (t29 * t9).add_product(t11, (t27 - t28).sub_product(t11, t29) * t12);
    let drive = (-(-(t2 * t26)).add_product(t1, t30).add_product(t1,
        (-crank_mass_times_crank_gravity).add_product(p.crank_mass, t15) + t30)).add_product(t2, t26
        .add_product(p.crank_mass, t14));
    PowerBalance {
        stored_rate: (crank_mass_times_crank_gravity * crank_v_y)
            .add_product(rod_mass_times_rod_gravity, rod_v_y).add_product(p.slider_mass
            * p.slider_gravity, slider_v_y).sub_product(p.crank_mass * crank_v_x, t14)
            .sub_product(p.crank_mass * crank_v_y, t15).sub_product(p.rod_mass * rod_v_x, t23)
            .sub_product(p.rod_mass * rod_v_y, t21).add_product(p.rod_inertia * rod_omega,
            rod_omega_dot).sub_product(p.slider_mass * slider_v_x, t24),
        supplied: p.speed * drive,
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

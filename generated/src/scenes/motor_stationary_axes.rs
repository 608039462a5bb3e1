// Emitted by Machinist 0.1.0; do not edit. To make it again:
//
//     cargo run --release -- gen
//
// Sources, with SHA-256:
//   c0b80f5732a77d4a28be0e0b05a07ec7d5af6ce890dd0c1a18e9c103a7a85b97  scenes/motor_stationary_axes.toml
//   fcfe841cdc092c0e1e704fe7f084a140202ddcbe7265bbceeac9558d7ad4bf18  units/textile/induction_motor_stationary.toml
//
// No-load run-up of an induction motor, from its co-energy
//
// The run-up of `motor_run_up` with charges as coordinates: the same torque and speed from another
// derivation.
//
// Source:
//   Saw-gin study (2020), motor of equations (2), as a Lagrangian.
//
// All quantities are in SI units.
// Shapes: coordinates 5, states 6, parameters 11, outputs 9.
// Nonzeros: mass_matrix 13 of 5 by 5, rate_jacobian 30 of 6 by 6, parameter_jacobian 41 of 6 by 11.
// Operations: rate 118, mass_matrix 13, forcing 69, rate_jacobian 298, parameter_jacobian 574,
//     time_derivative 63, outputs 25, energy 33, power_balance 169, prepare 62, prepared_rate 98,
//     prepared_rate_jacobian 273, prepared_jacobians 693.

use ::machinist_contract::{
    Energy, PowerBalance, Real, taylor::{Factored, Lanes, order_and_inverse},
};

::machinist_contract::simulator! {
    /// No-load run-up of an induction motor, from its co-energy
    ///
    /// The run-up of \`motor_run_up\` with charges as coordinates: the same torque and speed from another
    /// derivation.
    ///
    /// Source: Saw-gin study (2020), motor of equations (2), as a Lagrangian.
    MotorStationaryAxes: "motor_stationary_axes", "No-load run-up of an induction motor, from its co-energy";
    run from 0.0, until 2.0, points 2001, rtol 1e-8, method "tsit5";
    quadratures 0, discontinuities 0;
    coordinates; prepared; jacobians_at_once; series 28;
}

::machinist_contract::parameters! {
    initial_speed: 0.0, "rad/s", "initial_speed", "initial speed";
    motor_inertia: 4.2, "kg m^2", "motor.inertia", "moment of inertia of the rotor";
    motor_phase_voltage: 220.0, "V", "motor.phase_voltage", "RMS phase voltage";
    motor_supply_frequency: 50.0, "Hz", "motor.supply_frequency", "supply frequency";
    motor_supply_phase: 0.0, "rad", "motor.supply_phase", "initial phase of the supply";
    motor_pole_pairs: 4.0, "1", "motor.pole_pairs", "pole pairs";
    motor_k_s: 0.956, "1", "motor.k_s", "stator coupling factor x_mu/x_s";
    motor_k_r: 0.952, "1", "motor.k_r", "rotor coupling factor x_mu/x_r";
    motor_x_s: 4.14, "ohm", "motor.x_s", "stator reactance at supply frequency";
    motor_alpha_s: 0.115, "1", "motor.alpha_s", "stator decay factor R_s/(sigma x_s)";
    motor_alpha_r: 0.0858, "1", "motor.alpha_r", "rotor decay factor R_r/(sigma x_r)";
}

::machinist_contract::outputs! {
    speed: "rad/s", "speed", "rotor speed";
    torque: "N m", "torque", "electromagnetic torque";
    slip: "1", "slip", "slip";
    stator_current: "A", "stator_current", "amplitude of the stator current";
    stator_alpha: "C/s", "stator_alpha", "rate of charge through the stator winding along alpha";
    stator_beta: "C/s", "stator_beta", "rate of charge through the stator winding along beta";
    rotor_first: "C/s", "rotor_first", "rate of charge through the rotor's first winding";
    rotor_second: "C/s", "rotor_second", "rate of charge through the rotor's second winding";
    angle: "rad", "angle", "rotor angle";
}

::machinist_contract::states! {
    MOTOR_PHI: position, 150.0, "rad", "motor.phi", "rotor angle";
    MOTOR_I_SA: velocity, 800.0, "C/s", "motor.i_sa", "rate of charge through the stator winding along alpha";
    MOTOR_I_SB: velocity, 800.0, "C/s", "motor.i_sb", "rate of charge through the stator winding along beta";
    MOTOR_I_RA: velocity, 800.0, "C/s", "motor.i_ra", "rate of charge through the rotor's first winding";
    MOTOR_I_RB: velocity, 800.0, "C/s", "motor.i_rb", "rate of charge through the rotor's second winding";
    MOTOR_OMEGA: velocity, 78.5, "rad/s", "motor.omega", "rate of rotor angle";
}

::machinist_contract::coordinates! {
    "motor.q_sa", "C", "charge through the stator winding along alpha";
    "motor.q_sb", "C", "charge through the stator winding along beta";
    "motor.q_ra", "C", "charge through the rotor's first winding";
    "motor.q_rb", "C", "charge through the rotor's second winding";
    "motor.phi", "rad", "rotor angle";
}

::machinist_contract::patterns! {
    /// Nonzeros of M.
    MASS_MATRIX_PATTERN: 5 by 5 { 0 [0 2 3] 1 [1 2 3] 2 [0 1 2] 3 [0 1 3] 4 [4] }
    /// Nonzeros of dy'/dy.
    RATE_JACOBIAN_PATTERN: 6 by 6 { 0 [5] 1 [0 1 2 3 4 5] 2 [0 1 2 3 4 5] 3 [0 1 2 3 4 5]
        4 [0 1 2 3 4 5] 5 [0 1 2 3 4] }
    /// Nonzeros of dy'/dp.
    PARAMETER_JACOBIAN_PATTERN: 6 by 11 { 1 [2 3 4 5 6 7 8 9 10] 2 [2 3 4 5 6 7 8 9 10]
        3 [2 3 4 5 6 7 8 9 10] 4 [2 3 4 5 6 7 8 9 10] 5 [1 3 5 6 8] }
}

::machinist_contract::constants! {
    motor_omega_0, t0, t2, t3, t4, inverse_motor_inertia, t5, t6, t7, motor_pole_pairs_squared, t8, t9,
    t1, t10, t11, t12, t13, t14, t15, t16, t18, t19, t20, t22, t23, t24, t25, t26, t27, t28, t29,
    t30, t31
}

/// Returns the constants of `rate` and its Jacobians from the parameters. 62 operations.
#[must_use]
#[inline]
pub fn prepare<R: Real>(p: &Parameters<R>) -> Constants<R> {
    let motor_omega_0 = R::literal(core::f64::consts::TAU) * p.motor_supply_frequency;
    let motor_sigma = R::literal(1.0).sub_product(p.motor_k_s, p.motor_k_r);
    let motor_L_s = p.motor_x_s / motor_omega_0;
    let motor_R_s = p.motor_x_s * p.motor_alpha_s * motor_sigma;
    let motor_M = p.motor_k_s * motor_L_s;
    let t0 = p.motor_phase_voltage * R::literal(core::f64::consts::SQRT_2);
    let motor_L_r = motor_M / p.motor_k_r;
    let motor_R_r = p.motor_k_s * p.motor_x_s * p.motor_alpha_r * motor_sigma / p.motor_k_r;
    let t1 = R::literal(1.5) * motor_L_s;
    let t2 = R::literal(1.5) * motor_M;
    let t3 = R::literal(1.5) * motor_L_r;
    let t4 = R::literal(1.0) / t1;
    let inverse_motor_inertia = R::literal(1.0) / p.motor_inertia;
    let t5 = R::literal(1.5) * motor_R_s;
    let t6 = R::literal(1.5) * motor_R_r;
    let t7 = R::literal(1.5) * p.motor_pole_pairs * motor_M;
    let motor_pole_pairs_squared = p.motor_pole_pairs * p.motor_pole_pairs;
    let t8 = t2 * motor_pole_pairs_squared;
    let t9 = t5 * t4;
    let t10 = t2 / p.motor_supply_frequency;
    let t11 = t7 / p.motor_supply_frequency;
    let t12 = t1 / p.motor_supply_frequency;
    let t13 = t3 / p.motor_supply_frequency;
    let t14 = R::literal(1.5) * p.motor_k_r * p.motor_x_s * p.motor_alpha_s;
    let t15 = R::literal(0.75) * p.motor_pole_pairs * p.motor_k_r;
    let t16 = R::literal(0.75) * p.motor_alpha_r * motor_omega_0;
    let t17 = R::literal(1.5) * p.motor_k_s;
    let t18 = t17 * p.motor_k_r * p.motor_alpha_r * motor_omega_0;
    let t19 = R::literal(2.0) * motor_L_s / p.motor_k_r;
    let t20 = t1 / p.motor_k_r;
    let t21 = t17 * p.motor_x_s;
    let t22 = t21 * p.motor_alpha_s;
    let t23 = t21 * p.motor_alpha_r / (p.motor_k_r * p.motor_k_r);
    let t24 = t3 / p.motor_k_r;
    let t25 = R::literal(1.5) * p.motor_alpha_s * motor_sigma;
    let t26 = t17 / motor_omega_0;
    let t27 = t17 * p.motor_alpha_r * motor_sigma / p.motor_k_r;
    let t28 = R::literal(1.5) / motor_omega_0;
    let t29 = t17 / (p.motor_k_r * motor_omega_0);
    let t30 = R::literal(1.5) * p.motor_x_s * motor_sigma;
    let t31 = t21 * motor_sigma / p.motor_k_r;
    Constants { motor_omega_0, t0, t2, t3, t4, inverse_motor_inertia, t5, t6, t7,
        motor_pole_pairs_squared, t8, t9, t1, t10, t11, t12, t13, t14, t15, t16, t18, t19, t20,
        t22, t23, t24, t25, t26, t27, t28, t29, t30, t31 }
}

/// State at the start of the run, in the units of the states. No operations.
#[must_use]
pub fn initial_state<R: Real>(p: &Parameters<R>) -> [R; STATES] {
    [R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0),
        p.initial_speed]
}

/// Times of known jumps of the right-hand side \[s\], unsorted. No operations.
#[must_use]
pub fn discontinuities<R: Real>(_p: &Parameters<R>) -> [R; DISCONTINUITIES] {
    []
}

/// As `rate`, with the constants of the parameters from `prepare`. 98 operations.
#[must_use]
#[inline]
pub fn prepared_rate<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>,
        c: &Constants<R>) -> [R; STATES] {
    let [motor_phi, motor_i_sa, motor_i_sb, motor_i_ra, motor_i_rb, motor_omega] = *state;
    let motor_theta = p.motor_pole_pairs * motor_phi;
    let t0 = p.motor_supply_phase.add_product(c.motor_omega_0, time);
    let [(t1, t2), (sin_motor_theta, cos_motor_theta)] = R::sin_cos_each([t0, motor_theta]);
    let motor_along = (motor_i_sa * motor_i_ra).add_product(motor_i_sb, motor_i_rb);
    let motor_across = (motor_i_sb * motor_i_ra).sub_product(motor_i_sa, motor_i_rb);
    let motor_u_a = c.t0 * t2;
    let motor_u_b = c.t0 * t1;
    let t3 = c.t2 * cos_motor_theta;
    let t4 = c.t2 * sin_motor_theta;
    let t5 = t3 * c.t4;
    let t6 = t4 * c.t4;
    let t7 = t5 * t3;
    let t8 = t6 * t4;
    let t9 = R::literal(1.0) / (c.t3 - t7 - t8);
    let t10 = (t6 * t3).sub_product(t5, t4);
    let t11 = t10 * t9;
    let motor_pole_pairs_times_motor_i_ra = p.motor_pole_pairs * motor_i_ra;
    let motor_pole_pairs_times_motor_i_rb = p.motor_pole_pairs * motor_i_rb;
    let t12 = c.t2 * motor_omega;
    let t13 = (-(c.t5 * motor_i_sa)).add_product(R::literal(1.5), motor_u_a).add_product(t12,
        (motor_pole_pairs_times_motor_i_ra * sin_motor_theta)
        .add_product(motor_pole_pairs_times_motor_i_rb, cos_motor_theta));
    let t14 = (-(c.t5 * motor_i_sb)).add_product(R::literal(1.5), motor_u_b).sub_product(t12,
        (motor_pole_pairs_times_motor_i_ra * cos_motor_theta)
        .sub_product(motor_pole_pairs_times_motor_i_rb, sin_motor_theta));
    let motor_pole_pairs_times_motor_i_sa = p.motor_pole_pairs * motor_i_sa;
    let motor_pole_pairs_times_motor_i_sb = p.motor_pole_pairs * motor_i_sb;
    let t15 = (c.t6 * motor_i_ra).add_product(t12, (motor_pole_pairs_times_motor_i_sb
        * cos_motor_theta).sub_product(motor_pole_pairs_times_motor_i_sa, sin_motor_theta))
        .add_product(t5, t13).add_product(t6, t14);
    let motor_omega_dot = c.t2 * (p.motor_pole_pairs * motor_across * cos_motor_theta)
        .sub_product(p.motor_pole_pairs * motor_along, sin_motor_theta) * c.inverse_motor_inertia;
    let motor_i_rb_dot = (-(c.t6 * motor_i_rb)).add_product(t12, (motor_pole_pairs_times_motor_i_sa
        * cos_motor_theta).add_product(motor_pole_pairs_times_motor_i_sb, sin_motor_theta))
        .add_product(t6, t13).sub_product(t5, t14).add_product(t11, t15) * (R::literal(1.0)
        / (c.t3 - t8 - t7).sub_product(t11, t10));
    let t16 = (t15 * t9).add_product(t11, motor_i_rb_dot);
    let motor_i_ra_dot = -t16;
    let motor_i_sb_dot = (t14 * c.t4).add_product(t6, t16).sub_product(t5, motor_i_rb_dot);
    let motor_i_sa_dot = (t13 * c.t4).add_product(t5, t16).add_product(t6, motor_i_rb_dot);
    [motor_omega, motor_i_sa_dot, motor_i_sb_dot, motor_i_ra_dot, motor_i_rb_dot, motor_omega_dot]
}

/// `M = d2L/dq'2`, values in the order of its pattern. 13 operations.
#[must_use]
pub fn mass_matrix<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>) -> [R; 13] {
    let [motor_phi, ..] = *state;
    let motor_theta = p.motor_pole_pairs * motor_phi;
    let (sin_motor_theta, cos_motor_theta) = motor_theta.sin_cos();
    let motor_omega_0 = R::literal(core::f64::consts::TAU) * p.motor_supply_frequency;
    let motor_L_s = p.motor_x_s / motor_omega_0;
    let motor_M = p.motor_k_s * motor_L_s;
    let motor_L_r = motor_M / p.motor_k_r;
    let t0 = R::literal(1.5) * motor_L_s;
    let t1 = R::literal(1.5) * motor_M;
    let t2 = t1 * cos_motor_theta;
    let t3 = t1 * sin_motor_theta;
    let t4 = -t3;
    let t5 = R::literal(1.5) * motor_L_r;
    [t0, t2, t4, t0, t3, t2, t2, t3, t5, t4, t2, t5, p.motor_inertia]
}

/// `f` of `M q'' = f + G^T lambda`, one for each coordinate. 69 operations.
#[must_use]
pub fn forcing<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>) -> [R; COORDINATES] {
    let [motor_phi, motor_i_sa, motor_i_sb, motor_i_ra, motor_i_rb, motor_omega] = *state;
    let motor_theta = p.motor_pole_pairs * motor_phi;
    let motor_omega_0 = R::literal(core::f64::consts::TAU) * p.motor_supply_frequency;
    let t0 = p.motor_supply_phase.add_product(motor_omega_0, time);
    let [(t1, t2), (sin_motor_theta, cos_motor_theta)] = R::sin_cos_each([t0, motor_theta]);
    let motor_sigma = R::literal(1.0).sub_product(p.motor_k_s, p.motor_k_r);
    let motor_along = (motor_i_sa * motor_i_ra).add_product(motor_i_sb, motor_i_rb);
    let motor_across = (motor_i_sb * motor_i_ra).sub_product(motor_i_sa, motor_i_rb);
    let motor_L_s = p.motor_x_s / motor_omega_0;
    let motor_R_s = p.motor_x_s * p.motor_alpha_s * motor_sigma;
    let motor_M = p.motor_k_s * motor_L_s;
    let t3 = p.motor_phase_voltage * R::literal(core::f64::consts::SQRT_2);
    let motor_u_a = t3 * t2;
    let motor_u_b = t3 * t1;
    let motor_R_r = p.motor_k_s * p.motor_x_s * p.motor_alpha_r * motor_sigma / p.motor_k_r;
    let t4 = R::literal(1.5) * motor_M;
    let t5 = R::literal(1.5) * motor_R_s;
    let motor_pole_pairs_times_motor_i_ra = p.motor_pole_pairs * motor_i_ra;
    let motor_pole_pairs_times_motor_i_rb = p.motor_pole_pairs * motor_i_rb;
    let t6 = t4 * motor_omega;
    let motor_q_sa_forcing = (-(t5 * motor_i_sa)).add_product(R::literal(1.5), motor_u_a)
        .add_product(t6, (motor_pole_pairs_times_motor_i_ra * sin_motor_theta)
        .add_product(motor_pole_pairs_times_motor_i_rb, cos_motor_theta));
    let motor_q_sb_forcing = (-(t5 * motor_i_sb)).add_product(R::literal(1.5), motor_u_b)
        .sub_product(t6, (motor_pole_pairs_times_motor_i_ra * cos_motor_theta)
        .sub_product(motor_pole_pairs_times_motor_i_rb, sin_motor_theta));
    let t7 = R::literal(1.5) * motor_R_r;
    let motor_pole_pairs_times_motor_i_sa = p.motor_pole_pairs * motor_i_sa;
    let motor_pole_pairs_times_motor_i_sb = p.motor_pole_pairs * motor_i_sb;
    let motor_q_ra_forcing = (-(t7 * motor_i_ra)).add_product(t6,
        (motor_pole_pairs_times_motor_i_sa * sin_motor_theta)
        .sub_product(motor_pole_pairs_times_motor_i_sb, cos_motor_theta));
    let motor_q_rb_forcing = (-(t7 * motor_i_rb)).add_product(t6,
        (motor_pole_pairs_times_motor_i_sa * cos_motor_theta)
        .add_product(motor_pole_pairs_times_motor_i_sb, sin_motor_theta));
    let motor_phi_forcing = t4 * (p.motor_pole_pairs * motor_across * cos_motor_theta)
        .sub_product(p.motor_pole_pairs * motor_along, sin_motor_theta);
    [motor_q_sa_forcing, motor_q_sb_forcing, motor_q_ra_forcing, motor_q_rb_forcing,
        motor_phi_forcing]
}

/// As `rate_jacobian`, with the constants of the parameters from `prepare`. 273 operations.
#[must_use]
pub fn prepared_rate_jacobian<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>,
        c: &Constants<R>) -> [R; 30] {
    let [motor_phi, motor_i_sa, motor_i_sb, motor_i_ra, motor_i_rb, motor_omega] = *state;
    let motor_theta = p.motor_pole_pairs * motor_phi;
    let t0 = p.motor_supply_phase.add_product(c.motor_omega_0, time);
    let [(t1, t2), (sin_motor_theta, cos_motor_theta)] = R::sin_cos_each([t0, motor_theta]);
    let motor_along = (motor_i_sa * motor_i_ra).add_product(motor_i_sb, motor_i_rb);
    let motor_across = (motor_i_sb * motor_i_ra).sub_product(motor_i_sa, motor_i_rb);
    let motor_u_a = c.t0 * t2;
    let motor_u_b = c.t0 * t1;
    let t3 = c.t2 * cos_motor_theta;
    let t4 = c.t2 * sin_motor_theta;
    let t5 = t3 * c.t4;
    let t6 = t4 * c.t4;
    let t7 = t5 * t3;
    let t8 = t6 * t4;
    let t9 = R::literal(1.0) / (c.t3 - t7 - t8);
    let t10 = (t6 * t3).sub_product(t5, t4);
    let t11 = t10 * t9;
    let t12 = R::literal(1.0) / (c.t3 - t8 - t7).sub_product(t11, t10);
    let motor_pole_pairs_times_motor_i_ra = p.motor_pole_pairs * motor_i_ra;
    let motor_pole_pairs_times_motor_i_rb = p.motor_pole_pairs * motor_i_rb;
    let t13 = c.t2 * motor_omega;
    let t14 = (-(c.t5 * motor_i_sa)).add_product(R::literal(1.5), motor_u_a).add_product(t13,
        (motor_pole_pairs_times_motor_i_ra * sin_motor_theta)
        .add_product(motor_pole_pairs_times_motor_i_rb, cos_motor_theta));
    let t15 = (motor_pole_pairs_times_motor_i_ra * cos_motor_theta)
        .sub_product(motor_pole_pairs_times_motor_i_rb, sin_motor_theta);
    let t16 = (-(c.t5 * motor_i_sb)).add_product(R::literal(1.5), motor_u_b).sub_product(t13, t15);
    let motor_pole_pairs_times_motor_i_sa = p.motor_pole_pairs * motor_i_sa;
    let motor_pole_pairs_times_motor_i_sb = p.motor_pole_pairs * motor_i_sb;
    let t17 = (motor_pole_pairs_times_motor_i_sb * cos_motor_theta)
        .sub_product(motor_pole_pairs_times_motor_i_sa, sin_motor_theta);
    let t18 = (c.t6 * motor_i_ra).add_product(t13, t17).add_product(t5, t14).add_product(t6, t16);
    let motor_i_rb_dot = (-(c.t6 * motor_i_rb)).add_product(t13, (motor_pole_pairs_times_motor_i_sa
        * cos_motor_theta).add_product(motor_pole_pairs_times_motor_i_sb, sin_motor_theta))
        .add_product(t6, t14).sub_product(t5, t16).add_product(t11, t18) * t12;
    let t19 = (t18 * t9).add_product(t11, motor_i_rb_dot);
    let motor_i_sb_dot = (t16 * c.t4).add_product(t6, t19).sub_product(t5, motor_i_rb_dot);
    let motor_i_sa_dot = (t14 * c.t4).add_product(t5, t19).add_product(t6, motor_i_rb_dot);
    let t20 = (motor_i_ra * sin_motor_theta).add_product(motor_i_rb, cos_motor_theta);
    let t21 = c.t8 * motor_omega;
    let t22 = (motor_i_sa * cos_motor_theta).add_product(motor_i_sb, sin_motor_theta);
    let t23 = c.t7 * sin_motor_theta;
    let t24 = c.t7 * cos_motor_theta;
    let t25 = (-(t13 * (c.motor_pole_pairs_squared * motor_i_rb * sin_motor_theta)
        .sub_product(c.motor_pole_pairs_squared * motor_i_ra, cos_motor_theta)).add_product(t23,
        t19)).add_product(t24, motor_i_rb_dot);
    let t26 = (t21 * t20).add_product(t24, t19).add_product(t23, motor_i_rb_dot);
    let t27 = (t21 * t22).add_product(t23, motor_i_sa_dot).sub_product(t24, motor_i_sb_dot)
        .sub_product(t5, t25).sub_product(t6, t26);
    let motor_omega_dot_by_motor_phi = -(c.t2 * (c.motor_pole_pairs_squared * motor_along
        * cos_motor_theta).add_product(c.motor_pole_pairs_squared * motor_across, sin_motor_theta)
        * c.inverse_motor_inertia);
    let motor_i_rb_dot_by_motor_phi = (-(t13 * (c.motor_pole_pairs_squared * motor_i_sa
        * sin_motor_theta).sub_product(c.motor_pole_pairs_squared * motor_i_sb, cos_motor_theta)))
        .add_product(t24, motor_i_sa_dot).add_product(t23, motor_i_sb_dot).add_product(t6, t25)
        .sub_product(t5, t26).sub_product(t11, t27) * t12;
    let motor_i_ra_dot_by_motor_phi = (t27 * t9).sub_product(t11, motor_i_rb_dot_by_motor_phi);
    let motor_i_sb_dot_by_motor_phi = (t26 * c.t4).sub_product(t6, motor_i_ra_dot_by_motor_phi)
        .sub_product(t5, motor_i_rb_dot_by_motor_phi);
    let motor_i_sa_dot_by_motor_phi = (t25 * c.t4).sub_product(t5, motor_i_ra_dot_by_motor_phi)
        .add_product(t6, motor_i_rb_dot_by_motor_phi);
    let t28 = c.t7 * motor_omega;
    let t29 = t28 * sin_motor_theta;
    let t30 = t28 * cos_motor_theta;
    let t31 = c.t7 * t20;
    let t32 = t29.add_product(t5, c.t5);
    let t33 = t6 * c.t5;
    let motor_omega_dot_by_motor_i_sa = -(t31 * c.inverse_motor_inertia);
    let motor_i_rb_dot_by_motor_i_sa = (t30 - t33).sub_product(t11, t32) * t12;
    let motor_i_ra_dot_by_motor_i_sa = (t32 * t9).sub_product(t11, motor_i_rb_dot_by_motor_i_sa);
    let motor_i_sb_dot_by_motor_i_sa = -(t5 * motor_i_rb_dot_by_motor_i_sa).add_product(t6,
        motor_i_ra_dot_by_motor_i_sa);
    let motor_i_sa_dot_by_motor_i_sa = (-c.t9.add_product(t5, motor_i_ra_dot_by_motor_i_sa))
        .add_product(t6, motor_i_rb_dot_by_motor_i_sa);
    let t34 = c.t2 * t15;
    let t35 = t33 - t30;
    let motor_omega_dot_by_motor_i_sb = t34 * c.inverse_motor_inertia;
    let motor_i_rb_dot_by_motor_i_sb = t32.sub_product(t11, t35) * t12;
    let motor_i_ra_dot_by_motor_i_sb = (t35 * t9).sub_product(t11, motor_i_rb_dot_by_motor_i_sb);
    let motor_i_sb_dot_by_motor_i_sb = -c.t9.add_product(t6, motor_i_ra_dot_by_motor_i_sb)
        .add_product(t5, motor_i_rb_dot_by_motor_i_sb);
    let motor_i_sa_dot_by_motor_i_sb = (t6 * motor_i_rb_dot_by_motor_i_sb).sub_product(t5,
        motor_i_ra_dot_by_motor_i_sb);
    let t36 = c.t2 * t17;
    let t37 = t5 * t29;
    let t38 = t6 * t30;
    let t39 = t38 - (c.t6 + t37);
    let t40 = (t6 * t29).add_product(t5, t30);
    let motor_omega_dot_by_motor_i_ra = t36 * c.inverse_motor_inertia;
    let motor_i_rb_dot_by_motor_i_ra = t40.sub_product(t11, t39) * t12;
    let motor_i_ra_dot_by_motor_i_ra = (t39 * t9).sub_product(t11, motor_i_rb_dot_by_motor_i_ra);
    let t41 = t30 * c.t4;
    let motor_i_sb_dot_by_motor_i_ra = -t41.add_product(t6, motor_i_ra_dot_by_motor_i_ra)
        .add_product(t5, motor_i_rb_dot_by_motor_i_ra);
    let t42 = t29 * c.t4;
    let motor_i_sa_dot_by_motor_i_ra = t42.sub_product(t5, motor_i_ra_dot_by_motor_i_ra)
        .add_product(t6, motor_i_rb_dot_by_motor_i_ra);
    let t43 = c.t7 * t22;
    let motor_omega_dot_by_motor_i_rb = -(t43 * c.inverse_motor_inertia);
    let motor_i_rb_dot_by_motor_i_rb = (t38 - c.t6 - t37).add_product(t11, t40) * t12;
    let t44 = (t40 * t9).add_product(t11, motor_i_rb_dot_by_motor_i_rb);
    let motor_i_ra_dot_by_motor_i_rb = -t44;
    let motor_i_sb_dot_by_motor_i_rb = t42.add_product(t6, t44).sub_product(t5,
        motor_i_rb_dot_by_motor_i_rb);
    let motor_i_sa_dot_by_motor_i_rb = t41.add_product(t5, t44).add_product(t6,
        motor_i_rb_dot_by_motor_i_rb);
    let t45 = (-t36.add_product(t5, t31)).add_product(t6, t34);
    let motor_i_rb_dot_by_motor_omega = t43.add_product(t6, t31).add_product(t5, t34)
        .sub_product(t11, t45) * t12;
    let motor_i_ra_dot_by_motor_omega = (t45 * t9).sub_product(t11, motor_i_rb_dot_by_motor_omega);
    let motor_i_sb_dot_by_motor_omega = -(t34 * c.t4).add_product(t6, motor_i_ra_dot_by_motor_omega)
        .add_product(t5, motor_i_rb_dot_by_motor_omega);
    let motor_i_sa_dot_by_motor_omega = (t31 * c.t4).sub_product(t5, motor_i_ra_dot_by_motor_omega)
        .add_product(t6, motor_i_rb_dot_by_motor_omega);
    [R::literal(1.0), motor_i_sa_dot_by_motor_phi, motor_i_sa_dot_by_motor_i_sa,
        motor_i_sa_dot_by_motor_i_sb, motor_i_sa_dot_by_motor_i_ra, motor_i_sa_dot_by_motor_i_rb,
        motor_i_sa_dot_by_motor_omega, motor_i_sb_dot_by_motor_phi, motor_i_sb_dot_by_motor_i_sa,
        motor_i_sb_dot_by_motor_i_sb, motor_i_sb_dot_by_motor_i_ra, motor_i_sb_dot_by_motor_i_rb,
        motor_i_sb_dot_by_motor_omega, motor_i_ra_dot_by_motor_phi, motor_i_ra_dot_by_motor_i_sa,
        motor_i_ra_dot_by_motor_i_sb, motor_i_ra_dot_by_motor_i_ra, motor_i_ra_dot_by_motor_i_rb,
        motor_i_ra_dot_by_motor_omega, motor_i_rb_dot_by_motor_phi, motor_i_rb_dot_by_motor_i_sa,
        motor_i_rb_dot_by_motor_i_sb, motor_i_rb_dot_by_motor_i_ra, motor_i_rb_dot_by_motor_i_rb,
        motor_i_rb_dot_by_motor_omega, motor_omega_dot_by_motor_phi, motor_omega_dot_by_motor_i_sa,
        motor_omega_dot_by_motor_i_sb, motor_omega_dot_by_motor_i_ra, motor_omega_dot_by_motor_i_rb]
}

/// `rate_jacobian`, then `parameter_jacobian`, with the constants of the parameters from `prepare`.
/// 693 operations.
#[must_use]
pub fn prepared_jacobians<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>,
        c: &Constants<R>) -> [R; 71] {
    let [motor_phi, motor_i_sa, motor_i_sb, motor_i_ra, motor_i_rb, motor_omega] = *state;
    let motor_theta = p.motor_pole_pairs * motor_phi;
    let t0 = p.motor_supply_phase.add_product(c.motor_omega_0, time);
    let [(t1, t2), (sin_motor_theta, cos_motor_theta)] = R::sin_cos_each([t0, motor_theta]);
    let motor_along = (motor_i_sa * motor_i_ra).add_product(motor_i_sb, motor_i_rb);
    let motor_across = (motor_i_sb * motor_i_ra).sub_product(motor_i_sa, motor_i_rb);
    let motor_u_a = c.t0 * t2;
    let motor_u_b = c.t0 * t1;
    let t3 = c.t2 * cos_motor_theta;
    let t4 = c.t2 * sin_motor_theta;
    let t5 = t3 * c.t4;
    let t6 = t4 * c.t4;
    let t7 = t5 * t3;
    let t8 = t6 * t4;
    let t9 = R::literal(1.0) / (c.t3 - t7 - t8);
    let t10 = (t6 * t3).sub_product(t5, t4);
    let t11 = t10 * t9;
    let t12 = R::literal(1.0) / (c.t3 - t8 - t7).sub_product(t11, t10);
    let motor_pole_pairs_times_motor_i_ra = p.motor_pole_pairs * motor_i_ra;
    let motor_pole_pairs_times_motor_i_rb = p.motor_pole_pairs * motor_i_rb;
    let t13 = (motor_pole_pairs_times_motor_i_ra * sin_motor_theta)
        .add_product(motor_pole_pairs_times_motor_i_rb, cos_motor_theta);
    let t14 = c.t2 * motor_omega;
    let t15 = R::literal(1.5) * motor_u_a;
    let t16 = t15.sub_product(c.t5, motor_i_sa).add_product(t14, t13);
    let t17 = (motor_pole_pairs_times_motor_i_ra * cos_motor_theta)
        .sub_product(motor_pole_pairs_times_motor_i_rb, sin_motor_theta);
    let t18 = R::literal(1.5) * motor_u_b;
    let t19 = t18.sub_product(c.t5, motor_i_sb).sub_product(t14, t17);
    let motor_pole_pairs_times_motor_i_sa = p.motor_pole_pairs * motor_i_sa;
    let motor_pole_pairs_times_motor_i_sb = p.motor_pole_pairs * motor_i_sb;
    let t20 = (motor_pole_pairs_times_motor_i_sb * cos_motor_theta)
        .sub_product(motor_pole_pairs_times_motor_i_sa, sin_motor_theta);
    let t21 = (motor_pole_pairs_times_motor_i_sa * cos_motor_theta)
        .add_product(motor_pole_pairs_times_motor_i_sb, sin_motor_theta);
    let t22 = (c.t6 * motor_i_ra).add_product(t14, t20).add_product(t5, t16).add_product(t6, t19);
    let motor_i_rb_dot = (-(c.t6 * motor_i_rb)).add_product(t14, t21).add_product(t6, t16)
        .sub_product(t5, t19).add_product(t11, t22) * t12;
    let t23 = (t22 * t9).add_product(t11, motor_i_rb_dot);
    let motor_i_sb_dot = (t19 * c.t4).add_product(t6, t23).sub_product(t5, motor_i_rb_dot);
    let motor_i_sa_dot = (t16 * c.t4).add_product(t5, t23).add_product(t6, motor_i_rb_dot);
    let motor_i_ra_times_sin_motor_theta = motor_i_ra * sin_motor_theta;
    let motor_i_rb_times_cos_motor_theta = motor_i_rb * cos_motor_theta;
    let t24 = motor_i_ra_times_sin_motor_theta + motor_i_rb_times_cos_motor_theta;
    let t25 = c.t8 * motor_omega;
    let motor_i_sa_times_cos_motor_theta = motor_i_sa * cos_motor_theta;
    let motor_i_sb_times_sin_motor_theta = motor_i_sb * sin_motor_theta;
    let t26 = motor_i_sa_times_cos_motor_theta + motor_i_sb_times_sin_motor_theta;
    let t27 = c.t7 * sin_motor_theta;
    let t28 = c.t7 * cos_motor_theta;
    let t29 = (-(t14 * (c.motor_pole_pairs_squared * motor_i_rb * sin_motor_theta)
        .sub_product(c.motor_pole_pairs_squared * motor_i_ra, cos_motor_theta)).add_product(t27,
        t23)).add_product(t28, motor_i_rb_dot);
    let t30 = (t25 * t24).add_product(t28, t23).add_product(t27, motor_i_rb_dot);
    let t31 = (t25 * t26).add_product(t27, motor_i_sa_dot).sub_product(t28, motor_i_sb_dot)
        .sub_product(t5, t29).sub_product(t6, t30);
    let motor_omega_dot_by_motor_phi = -(c.t2 * (c.motor_pole_pairs_squared * motor_along
        * cos_motor_theta).add_product(c.motor_pole_pairs_squared * motor_across, sin_motor_theta)
        * c.inverse_motor_inertia);
    let motor_i_rb_dot_by_motor_phi = (-(t14 * (c.motor_pole_pairs_squared * motor_i_sa
        * sin_motor_theta).sub_product(c.motor_pole_pairs_squared * motor_i_sb, cos_motor_theta)))
        .add_product(t28, motor_i_sa_dot).add_product(t27, motor_i_sb_dot).add_product(t6, t29)
        .sub_product(t5, t30).sub_product(t11, t31) * t12;
    let motor_i_ra_dot_by_motor_phi = (t31 * t9).sub_product(t11, motor_i_rb_dot_by_motor_phi);
    let motor_i_sb_dot_by_motor_phi = (t30 * c.t4).sub_product(t6, motor_i_ra_dot_by_motor_phi)
        .sub_product(t5, motor_i_rb_dot_by_motor_phi);
    let motor_i_sa_dot_by_motor_phi = (t29 * c.t4).sub_product(t5, motor_i_ra_dot_by_motor_phi)
        .add_product(t6, motor_i_rb_dot_by_motor_phi);
    let t32 = c.t7 * motor_omega;
    let t33 = t32 * sin_motor_theta;
    let t34 = t32 * cos_motor_theta;
    let t35 = c.t7 * t24;
    let t36 = t33.add_product(t5, c.t5);
    let t37 = t6 * c.t5;
    let motor_omega_dot_by_motor_i_sa = -(t35 * c.inverse_motor_inertia);
    let motor_i_rb_dot_by_motor_i_sa = (t34 - t37).sub_product(t11, t36) * t12;
    let motor_i_ra_dot_by_motor_i_sa = (t36 * t9).sub_product(t11, motor_i_rb_dot_by_motor_i_sa);
    let motor_i_sb_dot_by_motor_i_sa = -(t5 * motor_i_rb_dot_by_motor_i_sa).add_product(t6,
        motor_i_ra_dot_by_motor_i_sa);
    let motor_i_sa_dot_by_motor_i_sa = (-c.t9.add_product(t5, motor_i_ra_dot_by_motor_i_sa))
        .add_product(t6, motor_i_rb_dot_by_motor_i_sa);
    let t38 = c.t2 * t17;
    let t39 = t37 - t34;
    let motor_omega_dot_by_motor_i_sb = t38 * c.inverse_motor_inertia;
    let motor_i_rb_dot_by_motor_i_sb = t36.sub_product(t11, t39) * t12;
    let motor_i_ra_dot_by_motor_i_sb = (t39 * t9).sub_product(t11, motor_i_rb_dot_by_motor_i_sb);
    let motor_i_sb_dot_by_motor_i_sb = -c.t9.add_product(t6, motor_i_ra_dot_by_motor_i_sb)
        .add_product(t5, motor_i_rb_dot_by_motor_i_sb);
    let motor_i_sa_dot_by_motor_i_sb = (t6 * motor_i_rb_dot_by_motor_i_sb).sub_product(t5,
        motor_i_ra_dot_by_motor_i_sb);
    let t40 = c.t2 * t20;
    let t41 = t5 * t33;
    let t42 = t6 * t34;
    let t43 = t42 - (c.t6 + t41);
    let t44 = (t6 * t33).add_product(t5, t34);
    let motor_omega_dot_by_motor_i_ra = t40 * c.inverse_motor_inertia;
    let motor_i_rb_dot_by_motor_i_ra = t44.sub_product(t11, t43) * t12;
    let motor_i_ra_dot_by_motor_i_ra = (t43 * t9).sub_product(t11, motor_i_rb_dot_by_motor_i_ra);
    let t45 = t34 * c.t4;
    let motor_i_sb_dot_by_motor_i_ra = -t45.add_product(t6, motor_i_ra_dot_by_motor_i_ra)
        .add_product(t5, motor_i_rb_dot_by_motor_i_ra);
    let t46 = t33 * c.t4;
    let motor_i_sa_dot_by_motor_i_ra = t46.sub_product(t5, motor_i_ra_dot_by_motor_i_ra)
        .add_product(t6, motor_i_rb_dot_by_motor_i_ra);
    let t47 = c.t7 * t26;
    let motor_omega_dot_by_motor_i_rb = -(t47 * c.inverse_motor_inertia);
    let motor_i_rb_dot_by_motor_i_rb = (t42 - c.t6 - t41).add_product(t11, t44) * t12;
    let t48 = (t44 * t9).add_product(t11, motor_i_rb_dot_by_motor_i_rb);
    let motor_i_ra_dot_by_motor_i_rb = -t48;
    let motor_i_sb_dot_by_motor_i_rb = t46.add_product(t6, t48).sub_product(t5,
        motor_i_rb_dot_by_motor_i_rb);
    let motor_i_sa_dot_by_motor_i_rb = t45.add_product(t5, t48).add_product(t6,
        motor_i_rb_dot_by_motor_i_rb);
    let t49 = (-t40.add_product(t5, t35)).add_product(t6, t38);
    let motor_i_rb_dot_by_motor_omega = t47.add_product(t6, t35).add_product(t5, t38)
        .sub_product(t11, t49) * t12;
    let motor_i_ra_dot_by_motor_omega = (t49 * t9).sub_product(t11, motor_i_rb_dot_by_motor_omega);
    let motor_i_sb_dot_by_motor_omega = -(t38 * c.t4).add_product(t6, motor_i_ra_dot_by_motor_omega)
        .add_product(t5, motor_i_rb_dot_by_motor_omega);
    let motor_i_sa_dot_by_motor_omega = (t35 * c.t4).sub_product(t5, motor_i_ra_dot_by_motor_omega)
        .add_product(t6, motor_i_rb_dot_by_motor_omega);
    let t50 = (p.motor_pole_pairs * motor_across * cos_motor_theta).sub_product(p.motor_pole_pairs
        * motor_along, sin_motor_theta);
    let motor_omega_dot = c.t2 * t50 * c.inverse_motor_inertia;
    let motor_omega_dot_by_motor_inertia = -(motor_omega_dot * c.inverse_motor_inertia);
    let t51 = R::literal(2.121_320_343_559_643) * t2;
    let t52 = R::literal(2.121_320_343_559_643) * t1;
    let t53 = (t5 * t51).add_product(t6, t52);
    let motor_i_rb_dot_by_motor_phase_voltage = (t6 * t51).sub_product(t5, t52).add_product(t11,
        t53) * t12;
    let t54 = (t53 * t9).add_product(t11, motor_i_rb_dot_by_motor_phase_voltage);
    let motor_i_ra_dot_by_motor_phase_voltage = -t54;
    let motor_i_sb_dot_by_motor_phase_voltage = (t52 * c.t4).add_product(t6, t54).sub_product(t5,
        motor_i_rb_dot_by_motor_phase_voltage);
    let motor_i_sa_dot_by_motor_phase_voltage = (t51 * c.t4).add_product(t5, t54).add_product(t6,
        motor_i_rb_dot_by_motor_phase_voltage);
    let t55 = R::literal(3.0 * core::f64::consts::PI) * time;
    let t56 = c.t10 * motor_omega;
    let t57 = c.t10 * cos_motor_theta;
    let t58 = c.t10 * sin_motor_theta;
    let t59 = (-(t56 * t13).add_product(t55, motor_u_b)).add_product(c.t12, motor_i_sa_dot)
        .sub_product(t57, t23).sub_product(t58, motor_i_rb_dot);
    let t60 = (t56 * t17).add_product(t55, motor_u_a).add_product(c.t12, motor_i_sb_dot)
        .sub_product(t58, t23).add_product(t57, motor_i_rb_dot);
    let t61 = (t56 * t20).add_product(t57, motor_i_sa_dot).add_product(t58, motor_i_sb_dot)
        .sub_product(c.t13, t23).sub_product(t5, t59).sub_product(t6, t60);
    let motor_omega_dot_by_motor_supply_frequency = -(c.t10 * t50 * c.inverse_motor_inertia);
    let motor_i_rb_dot_by_motor_supply_frequency = (-(c.t11 * motor_omega * t26).add_product(t58,
        motor_i_sa_dot)).add_product(t57, motor_i_sb_dot).add_product(c.t13, motor_i_rb_dot)
        .add_product(t6, t59).sub_product(t5, t60).sub_product(t11, t61) * t12;
    let motor_i_ra_dot_by_motor_supply_frequency = (t61 * t9).sub_product(t11,
        motor_i_rb_dot_by_motor_supply_frequency);
    let motor_i_sb_dot_by_motor_supply_frequency = (t60 * c.t4).sub_product(t6,
        motor_i_ra_dot_by_motor_supply_frequency).sub_product(t5,
        motor_i_rb_dot_by_motor_supply_frequency);
    let motor_i_sa_dot_by_motor_supply_frequency = (t59 * c.t4).sub_product(t5,
        motor_i_ra_dot_by_motor_supply_frequency).add_product(t6,
        motor_i_rb_dot_by_motor_supply_frequency);
    let t62 = (t5 * t18).sub_product(t6, t15);
    let t63 = (t6 * t18).add_product(t5, t15).add_product(t11, t62) * t12;
    let motor_i_rb_dot_by_motor_supply_phase = -t63;
    let motor_i_ra_dot_by_motor_supply_phase = (t62 * t9).add_product(t11, t63);
    let motor_i_sb_dot_by_motor_supply_phase = (t15 * c.t4).sub_product(t6,
        motor_i_ra_dot_by_motor_supply_phase).add_product(t5, t63);
    let motor_i_sa_dot_by_motor_supply_phase = -(t18 * c.t4).add_product(t5,
        motor_i_ra_dot_by_motor_supply_phase).add_product(t6, t63);
    let motor_i_ra_times_motor_theta = motor_i_ra * motor_theta;
    let motor_i_rb_times_motor_theta = motor_i_rb * motor_theta;
    let motor_i_sa_times_motor_theta = motor_i_sa * motor_theta;
    let motor_i_sb_times_motor_theta = motor_i_sb * motor_theta;
    let t64 = c.t2 * motor_phi;
    let t65 = t64 * sin_motor_theta;
    let t66 = t64 * cos_motor_theta;
    let t67 = (-(t14 * ((motor_i_rb_times_motor_theta * sin_motor_theta)
        .sub_product(motor_i_ra_times_motor_theta, cos_motor_theta)
        - motor_i_ra_times_sin_motor_theta - motor_i_rb_times_cos_motor_theta)).add_product(t65,
        t23)).add_product(t66, motor_i_rb_dot);
    let t68 = (-(t14 * (motor_i_ra * cos_motor_theta).sub_product(motor_i_ra_times_motor_theta,
        sin_motor_theta).sub_product(motor_i_rb_times_motor_theta, cos_motor_theta)
        .sub_product(motor_i_rb, sin_motor_theta))).add_product(t66, t23).add_product(t65,
        motor_i_rb_dot);
    let t69 = (-(t14 * (motor_i_sb * cos_motor_theta).sub_product(motor_i_sa_times_motor_theta,
        cos_motor_theta).sub_product(motor_i_sa, sin_motor_theta)
        .sub_product(motor_i_sb_times_motor_theta, sin_motor_theta))).add_product(t65,
        motor_i_sa_dot).sub_product(t66, motor_i_sb_dot).sub_product(t5, t67).sub_product(t6, t68);
    let motor_omega_dot_by_motor_pole_pairs = c.t2 * (motor_across * cos_motor_theta)
        .sub_product(motor_theta * motor_along, cos_motor_theta).sub_product(motor_theta
        * motor_across, sin_motor_theta).sub_product(motor_along, sin_motor_theta)
        * c.inverse_motor_inertia;
    let motor_i_rb_dot_by_motor_pole_pairs = (-(t14 * ((-motor_i_sa_times_cos_motor_theta)
        .add_product(motor_i_sa_times_motor_theta, sin_motor_theta)
        .sub_product(motor_i_sb_times_motor_theta, cos_motor_theta)
        - motor_i_sb_times_sin_motor_theta))).add_product(t66, motor_i_sa_dot).add_product(t65,
        motor_i_sb_dot).add_product(t6, t67).sub_product(t5, t68).sub_product(t11, t69) * t12;
    let motor_i_ra_dot_by_motor_pole_pairs = (t69 * t9).sub_product(t11,
        motor_i_rb_dot_by_motor_pole_pairs);
    let motor_i_sb_dot_by_motor_pole_pairs = (t68 * c.t4).sub_product(t6,
        motor_i_ra_dot_by_motor_pole_pairs).sub_product(t5, motor_i_rb_dot_by_motor_pole_pairs);
    let motor_i_sa_dot_by_motor_pole_pairs = (t67 * c.t4).sub_product(t5,
        motor_i_ra_dot_by_motor_pole_pairs).add_product(t6, motor_i_rb_dot_by_motor_pole_pairs);
    let t70 = c.t1 * motor_omega;
    let t71 = c.t15 * motor_i_sb * motor_omega;
    let t72 = c.t15 * motor_i_sa * motor_omega;
    let t73 = c.t1 * cos_motor_theta;
    let t74 = c.t1 * sin_motor_theta;
    let t75 = (c.t14 * motor_i_sa).add_product(t70, t13).add_product(t73, t23).add_product(t74,
        motor_i_rb_dot);
    let t76 = (c.t14 * motor_i_sb).sub_product(t70, t17).add_product(t74, t23).sub_product(t73,
        motor_i_rb_dot);
    let t77 = (c.t19 * (c.t18 * motor_i_ra).add_product(t72, sin_motor_theta).sub_product(t71,
        cos_motor_theta).sub_product(c.t16, motor_i_ra)).sub_product(t73, motor_i_sa_dot)
        .sub_product(t74, motor_i_sb_dot).add_product(c.t20, t23).sub_product(t5, t75)
        .sub_product(t6, t76);
    let motor_omega_dot_by_motor_k_s = c.t1 * t50 * c.inverse_motor_inertia;
    let motor_i_rb_dot_by_motor_k_s = (c.t19 * (t72 * cos_motor_theta).add_product(t71,
        sin_motor_theta).add_product(c.t18, motor_i_rb).sub_product(c.t16, motor_i_rb))
        .add_product(t74, motor_i_sa_dot).sub_product(t73, motor_i_sb_dot).sub_product(c.t20,
        motor_i_rb_dot).add_product(t6, t75).sub_product(t5, t76).sub_product(t11, t77) * t12;
    let motor_i_ra_dot_by_motor_k_s = (t77 * t9).sub_product(t11, motor_i_rb_dot_by_motor_k_s);
    let motor_i_sb_dot_by_motor_k_s = (t76 * c.t4).sub_product(t6, motor_i_ra_dot_by_motor_k_s)
        .sub_product(t5, motor_i_rb_dot_by_motor_k_s);
    let motor_i_sa_dot_by_motor_k_s = (t75 * c.t4).sub_product(t5, motor_i_ra_dot_by_motor_k_s)
        .add_product(t6, motor_i_rb_dot_by_motor_k_s);
    let t78 = c.t22 * motor_i_sa;
    let t79 = c.t22 * motor_i_sb;
    let t80 = (c.t23 * motor_i_ra).sub_product(c.t24, t23).sub_product(t5, t78).sub_product(t6,
        t79);
    let motor_i_rb_dot_by_motor_k_r = (c.t23 * motor_i_rb).add_product(c.t24, motor_i_rb_dot)
        .add_product(t6, t78).sub_product(t5, t79).sub_product(t11, t80) * t12;
    let motor_i_ra_dot_by_motor_k_r = (t80 * t9).sub_product(t11, motor_i_rb_dot_by_motor_k_r);
    let motor_i_sb_dot_by_motor_k_r = (t79 * c.t4).sub_product(t6, motor_i_ra_dot_by_motor_k_r)
        .sub_product(t5, motor_i_rb_dot_by_motor_k_r);
    let motor_i_sa_dot_by_motor_k_r = (t78 * c.t4).sub_product(t5, motor_i_ra_dot_by_motor_k_r)
        .add_product(t6, motor_i_rb_dot_by_motor_k_r);
    let t81 = c.t26 * motor_omega;
    let t82 = c.t26 * cos_motor_theta;
    let t83 = c.t26 * sin_motor_theta;
    let t84 = (-(c.t25 * motor_i_sa)).add_product(t81, t13).sub_product(c.t28, motor_i_sa_dot)
        .add_product(t82, t23).add_product(t83, motor_i_rb_dot);
    let t85 = (-(c.t25 * motor_i_sb).add_product(t81, t17).add_product(c.t28, motor_i_sb_dot))
        .add_product(t83, t23).sub_product(t82, motor_i_rb_dot);
    let t86 = (-(c.t27 * motor_i_ra).add_product(t81, t20).add_product(t82, motor_i_sa_dot)
        .add_product(t83, motor_i_sb_dot)).add_product(c.t29, t23).sub_product(t5, t84)
        .sub_product(t6, t85);
    let motor_omega_dot_by_motor_x_s = c.t26 * t50 * c.inverse_motor_inertia;
    let motor_i_rb_dot_by_motor_x_s = (-(c.t27 * motor_i_rb)).add_product(t81, t21)
        .add_product(t83, motor_i_sa_dot).sub_product(t82, motor_i_sb_dot).sub_product(c.t29,
        motor_i_rb_dot).add_product(t6, t84).sub_product(t5, t85).sub_product(t11, t86) * t12;
    let motor_i_ra_dot_by_motor_x_s = (t86 * t9).sub_product(t11, motor_i_rb_dot_by_motor_x_s);
    let motor_i_sb_dot_by_motor_x_s = (t85 * c.t4).sub_product(t6, motor_i_ra_dot_by_motor_x_s)
        .sub_product(t5, motor_i_rb_dot_by_motor_x_s);
    let motor_i_sa_dot_by_motor_x_s = (t84 * c.t4).sub_product(t5, motor_i_ra_dot_by_motor_x_s)
        .add_product(t6, motor_i_rb_dot_by_motor_x_s);
    let t87 = c.t30 * motor_i_sa;
    let t88 = c.t30 * motor_i_sb;
    let t89 = (t5 * t87).add_product(t6, t88);
    let motor_i_rb_dot_by_motor_alpha_s = (t5 * t88).sub_product(t6, t87).sub_product(t11, t89)
        * t12;
    let motor_i_ra_dot_by_motor_alpha_s = (t89 * t9).sub_product(t11,
        motor_i_rb_dot_by_motor_alpha_s);
    let motor_i_sb_dot_by_motor_alpha_s = -(t88 * c.t4).add_product(t6,
        motor_i_ra_dot_by_motor_alpha_s).add_product(t5, motor_i_rb_dot_by_motor_alpha_s);
    let motor_i_sa_dot_by_motor_alpha_s = (-(t87 * c.t4).add_product(t5,
        motor_i_ra_dot_by_motor_alpha_s)).add_product(t6, motor_i_rb_dot_by_motor_alpha_s);
    let t90 = c.t31 * motor_i_ra;
    let motor_i_rb_dot_by_motor_alpha_r = (-(c.t31 * motor_i_rb)).add_product(t11, t90) * t12;
    let t91 = (t90 * t9).add_product(t11, motor_i_rb_dot_by_motor_alpha_r);
    let motor_i_ra_dot_by_motor_alpha_r = -t91;
    let motor_i_sb_dot_by_motor_alpha_r = (-(t5 * motor_i_rb_dot_by_motor_alpha_r)).add_product(t6,
        t91);
    let motor_i_sa_dot_by_motor_alpha_r = (t6 * motor_i_rb_dot_by_motor_alpha_r).add_product(t5,
        t91);
    [R::literal(1.0), motor_i_sa_dot_by_motor_phi, motor_i_sa_dot_by_motor_i_sa,
        motor_i_sa_dot_by_motor_i_sb, motor_i_sa_dot_by_motor_i_ra, motor_i_sa_dot_by_motor_i_rb,
        motor_i_sa_dot_by_motor_omega, motor_i_sb_dot_by_motor_phi, motor_i_sb_dot_by_motor_i_sa,
        motor_i_sb_dot_by_motor_i_sb, motor_i_sb_dot_by_motor_i_ra, motor_i_sb_dot_by_motor_i_rb,
        motor_i_sb_dot_by_motor_omega, motor_i_ra_dot_by_motor_phi, motor_i_ra_dot_by_motor_i_sa,
        motor_i_ra_dot_by_motor_i_sb, motor_i_ra_dot_by_motor_i_ra, motor_i_ra_dot_by_motor_i_rb,
        motor_i_ra_dot_by_motor_omega, motor_i_rb_dot_by_motor_phi, motor_i_rb_dot_by_motor_i_sa,
        motor_i_rb_dot_by_motor_i_sb, motor_i_rb_dot_by_motor_i_ra, motor_i_rb_dot_by_motor_i_rb,
        motor_i_rb_dot_by_motor_omega, motor_omega_dot_by_motor_phi, motor_omega_dot_by_motor_i_sa,
        motor_omega_dot_by_motor_i_sb, motor_omega_dot_by_motor_i_ra,
        motor_omega_dot_by_motor_i_rb, motor_i_sa_dot_by_motor_phase_voltage,
        motor_i_sa_dot_by_motor_supply_frequency, motor_i_sa_dot_by_motor_supply_phase,
        motor_i_sa_dot_by_motor_pole_pairs, motor_i_sa_dot_by_motor_k_s,
        motor_i_sa_dot_by_motor_k_r, motor_i_sa_dot_by_motor_x_s, motor_i_sa_dot_by_motor_alpha_s,
        motor_i_sa_dot_by_motor_alpha_r, motor_i_sb_dot_by_motor_phase_voltage,
        motor_i_sb_dot_by_motor_supply_frequency, motor_i_sb_dot_by_motor_supply_phase,
        motor_i_sb_dot_by_motor_pole_pairs, motor_i_sb_dot_by_motor_k_s,
        motor_i_sb_dot_by_motor_k_r, motor_i_sb_dot_by_motor_x_s, motor_i_sb_dot_by_motor_alpha_s,
        motor_i_sb_dot_by_motor_alpha_r, motor_i_ra_dot_by_motor_phase_voltage,
        motor_i_ra_dot_by_motor_supply_frequency, motor_i_ra_dot_by_motor_supply_phase,
        motor_i_ra_dot_by_motor_pole_pairs, motor_i_ra_dot_by_motor_k_s,
        motor_i_ra_dot_by_motor_k_r, motor_i_ra_dot_by_motor_x_s, motor_i_ra_dot_by_motor_alpha_s,
        motor_i_ra_dot_by_motor_alpha_r, motor_i_rb_dot_by_motor_phase_voltage,
        motor_i_rb_dot_by_motor_supply_frequency, motor_i_rb_dot_by_motor_supply_phase,
        motor_i_rb_dot_by_motor_pole_pairs, motor_i_rb_dot_by_motor_k_s,
        motor_i_rb_dot_by_motor_k_r, motor_i_rb_dot_by_motor_x_s, motor_i_rb_dot_by_motor_alpha_s,
        motor_i_rb_dot_by_motor_alpha_r, motor_omega_dot_by_motor_inertia,
        motor_omega_dot_by_motor_supply_frequency, motor_omega_dot_by_motor_pole_pairs,
        motor_omega_dot_by_motor_k_s, motor_omega_dot_by_motor_x_s]
}

/// Partial derivative of `y'` with respect to time. 63 operations.
#[must_use]
pub fn time_derivative<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>) -> [R; STATES] {
    let [motor_phi, ..] = *state;
    let motor_theta = p.motor_pole_pairs * motor_phi;
    let motor_omega_0 = R::literal(core::f64::consts::TAU) * p.motor_supply_frequency;
    let t0 = p.motor_supply_phase.add_product(motor_omega_0, time);
    let [(t1, t2), (sin_motor_theta, cos_motor_theta)] = R::sin_cos_each([t0, motor_theta]);
    let motor_L_s = p.motor_x_s / motor_omega_0;
    let motor_M = p.motor_k_s * motor_L_s;
    let t3 = p.motor_phase_voltage * R::literal(core::f64::consts::SQRT_2);
    let motor_u_a = t3 * t2;
    let motor_u_b = t3 * t1;
    let motor_L_r = motor_M / p.motor_k_r;
    let t4 = R::literal(1.5) * motor_M;
    let t5 = t4 * cos_motor_theta;
    let t6 = t4 * sin_motor_theta;
    let t7 = R::literal(1.5) * motor_L_r;
    let t8 = R::literal(1.0) / (R::literal(1.5) * motor_L_s);
    let t9 = t5 * t8;
    let t10 = t6 * t8;
    let t11 = t9 * t5;
    let t12 = t10 * t6;
    let t13 = R::literal(1.0) / (t7 - t11 - t12);
    let t14 = (t10 * t5).sub_product(t9, t6);
    let t15 = t14 * t13;
    let t16 = R::literal(1.5) * motor_omega_0;
    let t17 = t16 * motor_u_b;
    let t18 = t16 * motor_u_a;
    let t19 = (t9 * t17).sub_product(t10, t18);
    let t20 = (t10 * t17).add_product(t9, t18).add_product(t15, t19) * (R::literal(1.0)
        / (t7 - t12 - t11).sub_product(t15, t14));
    let motor_i_rb_dot_by_time = -t20;
    let motor_i_ra_dot_by_time = (t19 * t13).add_product(t15, t20);
    let motor_i_sb_dot_by_time = (t18 * t8).sub_product(t10, motor_i_ra_dot_by_time)
        .add_product(t9, t20);
    let motor_i_sa_dot_by_time = -(t17 * t8).add_product(t9, motor_i_ra_dot_by_time)
        .add_product(t10, t20);
    [R::literal(0.0), motor_i_sa_dot_by_time, motor_i_sb_dot_by_time, motor_i_ra_dot_by_time,
        motor_i_rb_dot_by_time, R::literal(0.0)]
}

/// Wanted outputs. 25 operations.
#[must_use]
pub fn outputs<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>) -> Outputs<R> {
    let [motor_phi, motor_i_sa, motor_i_sb, motor_i_ra, motor_i_rb, motor_omega] = *state;
    let motor_theta = p.motor_pole_pairs * motor_phi;
    let (sin_motor_theta, cos_motor_theta) = motor_theta.sin_cos();
    let motor_omega_0 = R::literal(core::f64::consts::TAU) * p.motor_supply_frequency;
    let motor_along = (motor_i_sa * motor_i_ra).add_product(motor_i_sb, motor_i_rb);
    let motor_across = (motor_i_sb * motor_i_ra).sub_product(motor_i_sa, motor_i_rb);
    let motor_L_s = p.motor_x_s / motor_omega_0;
    let motor_M = p.motor_k_s * motor_L_s;
    let motor_torque = R::literal(1.5) * p.motor_pole_pairs * motor_M * (motor_across
        * cos_motor_theta).sub_product(motor_along, sin_motor_theta);
    Outputs {
        speed: motor_omega,
        torque: motor_torque,
        slip: R::literal(1.0).sub_product(p.motor_pole_pairs / motor_omega_0, motor_omega),
        stator_current: (motor_i_sa * motor_i_sa).add_product(motor_i_sb, motor_i_sb).sqrt(),
        stator_alpha: motor_i_sa,
        stator_beta: motor_i_sb,
        rotor_first: motor_i_ra,
        rotor_second: motor_i_rb,
        angle: motor_phi,
    }
}

/// T, V and the energy of first-order states \[J\]. 33 operations.
#[must_use]
pub fn energy<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>) -> Energy<R> {
    let [motor_phi, motor_i_sa, motor_i_sb, motor_i_ra, motor_i_rb, motor_omega] = *state;
    let motor_theta = p.motor_pole_pairs * motor_phi;
    let (sin_motor_theta, cos_motor_theta) = motor_theta.sin_cos();
    let motor_omega_0 = R::literal(core::f64::consts::TAU) * p.motor_supply_frequency;
    let motor_along = (motor_i_sa * motor_i_ra).add_product(motor_i_sb, motor_i_rb);
    let motor_across = (motor_i_sb * motor_i_ra).sub_product(motor_i_sa, motor_i_rb);
    let motor_L_s = p.motor_x_s / motor_omega_0;
    let motor_M = p.motor_k_s * motor_L_s;
    let motor_L_r = motor_M / p.motor_k_r;
    Energy {
        kinetic: (R::literal(0.5) * p.motor_inertia * (motor_omega * motor_omega))
            .add_product(R::literal(0.75), (motor_L_s * (motor_i_sa * motor_i_sa)
            .add_product(motor_i_sb, motor_i_sb)).add_product(motor_L_r, (motor_i_ra * motor_i_ra)
            .add_product(motor_i_rb, motor_i_rb))).add_product(R::literal(1.5) * motor_M,
            (motor_along * cos_motor_theta).add_product(motor_across, sin_motor_theta)),
        potential: R::literal(0.0),
        stored: R::literal(0.0),
    }
}

/// `dE/dt`, power supplied and power dissipated \[W\]. 169 operations.
#[must_use]
pub fn power_balance<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>) -> PowerBalance<R> {
    let [motor_phi, motor_i_sa, motor_i_sb, motor_i_ra, motor_i_rb, motor_omega] = *state;
    let motor_theta = p.motor_pole_pairs * motor_phi;
    let motor_omega_0 = R::literal(core::f64::consts::TAU) * p.motor_supply_frequency;
    let t0 = p.motor_supply_phase.add_product(motor_omega_0, time);
    let [(t1, t2), (sin_motor_theta, cos_motor_theta)] = R::sin_cos_each([t0, motor_theta]);
    let motor_sigma = R::literal(1.0).sub_product(p.motor_k_s, p.motor_k_r);
    let motor_along = (motor_i_sa * motor_i_ra).add_product(motor_i_sb, motor_i_rb);
    let motor_across = (motor_i_sb * motor_i_ra).sub_product(motor_i_sa, motor_i_rb);
    let motor_L_s = p.motor_x_s / motor_omega_0;
    let motor_R_s = p.motor_x_s * p.motor_alpha_s * motor_sigma;
    let motor_M = p.motor_k_s * motor_L_s;
    let t3 = p.motor_phase_voltage * R::literal(core::f64::consts::SQRT_2);
    let motor_u_a = t3 * t2;
    let motor_u_b = t3 * t1;
    let motor_L_r = motor_M / p.motor_k_r;
    let motor_R_r = p.motor_k_s * p.motor_x_s * p.motor_alpha_r * motor_sigma / p.motor_k_r;
    let t4 = R::literal(1.5) * motor_L_s;
    let t5 = R::literal(1.5) * motor_M;
    let t6 = t5 * cos_motor_theta;
    let t7 = t5 * sin_motor_theta;
    let t8 = R::literal(1.5) * motor_L_r;
    let t9 = R::literal(1.0) / t4;
    let t10 = t6 * t9;
    let t11 = t7 * t9;
    let t12 = t10 * t6;
    let t13 = t11 * t7;
    let t14 = R::literal(1.0) / (t8 - t12 - t13);
    let t15 = (t11 * t6).sub_product(t10, t7);
    let t16 = t15 * t14;
    let t17 = R::literal(1.5) * motor_R_s;
    let motor_pole_pairs_times_motor_i_ra = p.motor_pole_pairs * motor_i_ra;
    let motor_pole_pairs_times_motor_i_rb = p.motor_pole_pairs * motor_i_rb;
    let t18 = t5 * motor_omega;
    let t19 = (-(t17 * motor_i_sa)).add_product(R::literal(1.5), motor_u_a).add_product(t18,
        (motor_pole_pairs_times_motor_i_ra * sin_motor_theta)
        .add_product(motor_pole_pairs_times_motor_i_rb, cos_motor_theta));
    let t20 = (-(t17 * motor_i_sb)).add_product(R::literal(1.5), motor_u_b).sub_product(t18,
        (motor_pole_pairs_times_motor_i_ra * cos_motor_theta)
        .sub_product(motor_pole_pairs_times_motor_i_rb, sin_motor_theta));
    let t21 = R::literal(1.5) * motor_R_r;
    let motor_pole_pairs_times_motor_i_sa = p.motor_pole_pairs * motor_i_sa;
    let motor_pole_pairs_times_motor_i_sb = p.motor_pole_pairs * motor_i_sb;
    let t22 = t5 * (p.motor_pole_pairs * motor_across * cos_motor_theta)
        .sub_product(p.motor_pole_pairs * motor_along, sin_motor_theta);
    let t23 = (t21 * motor_i_ra).add_product(t18, (motor_pole_pairs_times_motor_i_sb
        * cos_motor_theta).sub_product(motor_pole_pairs_times_motor_i_sa, sin_motor_theta))
        .add_product(t10, t19).add_product(t11, t20);
    let motor_omega_dot = t22 * (R::literal(1.0) / p.motor_inertia);
    let motor_i_rb_dot = (-(t21 * motor_i_rb)).add_product(t18, (motor_pole_pairs_times_motor_i_sa
        * cos_motor_theta).add_product(motor_pole_pairs_times_motor_i_sb, sin_motor_theta))
        .add_product(t11, t19).sub_product(t10, t20).add_product(t16, t23) * (R::literal(1.0)
        / (t8 - t13 - t12).sub_product(t16, t15));
    let t24 = (t23 * t14).add_product(t16, motor_i_rb_dot);
    let motor_i_sb_dot = (t20 * t9).add_product(t11, t24).sub_product(t10, motor_i_rb_dot);
    let motor_i_sa_dot = (t19 * t9).add_product(t10, t24).add_product(t11, motor_i_rb_dot);
    PowerBalance {
        stored_rate: (t22 * motor_omega).add_product((t4 * motor_i_sa).add_product(t5,
            (motor_i_ra * cos_motor_theta).sub_product(motor_i_rb, sin_motor_theta)),
            motor_i_sa_dot).add_product((t4 * motor_i_sb).add_product(t5,
            (motor_i_ra * sin_motor_theta).add_product(motor_i_rb, cos_motor_theta)),
            motor_i_sb_dot).sub_product((t8 * motor_i_ra).add_product(t5,
            (motor_i_sa * cos_motor_theta).add_product(motor_i_sb, sin_motor_theta)), t24)
            .add_product((t8 * motor_i_rb).add_product(t5, (motor_i_sb * cos_motor_theta)
            .sub_product(motor_i_sa, sin_motor_theta)), motor_i_rb_dot).add_product(p.motor_inertia
            * motor_omega, motor_omega_dot),
        supplied: (R::literal(1.5) * motor_i_sa * motor_u_a).add_product(R::literal(1.5)
            * motor_i_sb, motor_u_b),
        dissipated: (t17 * (motor_i_sa * motor_i_sa)).add_product(t17, motor_i_sb * motor_i_sb)
            .add_product(t21, motor_i_ra * motor_i_ra).add_product(t21, motor_i_rb * motor_i_rb),
    }
}

/// Normalized Taylor coefficients of the solution through `state`, order after order.
///
/// `_k` marks the coefficient of order k, `_before` that of order k - 1; bare names are
/// zeroth coefficients. The workspace is as `series_workspace` says.
///
/// 116 recurrences. 28 sums of products an order.
///
/// # Panics
/// If there is no room for the zeroth coefficients, or the workspace is too short.
pub fn series<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>,
        coefficients: &mut [[R; STATES]], workspace: &mut [R]) {
    let (mut lanes, workspace) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let (mut lanes_1, workspace) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let (mut lanes_2, workspace) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let (mut lanes_3, workspace) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let (mut lanes_4, workspace) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let (mut lanes_5, workspace) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let (mut lanes_6, _) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let [motor_phi, motor_i_sa, motor_i_sb, motor_i_ra, motor_i_rb, motor_omega] = *state;
    let motor_theta = motor_phi * p.motor_pole_pairs;
    let motor_omega_0 = R::literal(core::f64::consts::TAU) * p.motor_supply_frequency;
    let motor_L_s = p.motor_x_s / motor_omega_0;
    let motor_M = p.motor_k_s * motor_L_s;
    let motor_L_r = motor_M / p.motor_k_r;
    let sin_motor_theta = motor_theta.sin();
    let cos_motor_theta = motor_theta.cos();
    let t0 = R::literal(1.5) * motor_L_s;
    let t1 = R::literal(1.5) * motor_M;
    let t2 = cos_motor_theta * t1;
    let t3 = sin_motor_theta * t1;
    let t4 = -t3;
    let t5 = R::literal(1.5) * motor_L_r;
    let t6 = p.motor_k_s * p.motor_k_r;
    let motor_sigma = R::literal(1.0) - t6;
    let t7 = motor_i_sa * motor_i_ra;
    let t8 = motor_i_sb * motor_i_rb;
    let motor_along = t7 + t8;
    let t9 = motor_i_sa * motor_i_rb;
    let t10 = motor_i_sb * motor_i_ra;
    let motor_across = t10 - t9;
    let t11 = p.motor_x_s * p.motor_alpha_s;
    let motor_R_s = t11 * motor_sigma;
    let t12 = time * motor_omega_0;
    let t13 = p.motor_supply_phase + t12;
    let t14 = t13.sin();
    let t15 = t13.cos();
    let t16 = p.motor_phase_voltage * R::literal(core::f64::consts::SQRT_2);
    let t17 = p.motor_k_s * p.motor_x_s;
    let t18 = t17 * p.motor_alpha_r;
    let t19 = t18 * motor_sigma;
    let motor_R_r = t19 / p.motor_k_r;
    let t20 = R::literal(1.5) * motor_R_s;
    let t21 = motor_i_sa * t20;
    let t22 = motor_i_ra * p.motor_pole_pairs;
    let t23 = t22 * sin_motor_theta;
    let t24 = motor_i_rb * p.motor_pole_pairs;
    let t25 = t24 * cos_motor_theta;
    let t26 = t23 + t25;
    let t27 = motor_omega * t1;
    let t28 = t27 * t26;
    let t29 = t16 * R::literal(1.5);
    let t30 = t15 * t29;
    let t31 = t30 - t21;
    let t32 = t31 + t28;
    let t33 = motor_i_sb * t20;
    let t34 = t24 * sin_motor_theta;
    let t35 = t22 * cos_motor_theta;
    let t36 = t35 - t34;
    let t37 = t27 * t36;
    let t38 = t14 * t29;
    let t39 = t38 - t33;
    let t40 = t39 - t37;
    let t41 = R::literal(1.5) * motor_R_r;
    let t42 = motor_i_ra * t41;
    let t43 = motor_i_sa * p.motor_pole_pairs;
    let t44 = t43 * sin_motor_theta;
    let t45 = motor_i_sb * p.motor_pole_pairs;
    let t46 = t45 * cos_motor_theta;
    let t47 = t44 - t46;
    let t48 = t27 * t47;
    let t49 = t48 - t42;
    let t50 = motor_i_rb * t41;
    let t51 = t43 * cos_motor_theta;
    let t52 = t45 * sin_motor_theta;
    let t53 = t51 + t52;
    let t54 = t27 * t53;
    let t55 = t54 - t50;
    let t56 = motor_along * p.motor_pole_pairs;
    let t57 = t56 * sin_motor_theta;
    let t58 = motor_across * p.motor_pole_pairs;
    let t59 = t58 * cos_motor_theta;
    let t60 = t59 - t57;
    let t61 = t60 * t1;
    let factored = Factored::new([[t0, R::literal(0.0), R::literal(0.0), R::literal(0.0),
        R::literal(0.0)], [R::literal(0.0), t0, R::literal(0.0), R::literal(0.0), R::literal(0.0)],
        [t2, t3, t5, R::literal(0.0), R::literal(0.0)], [t4, t2, R::literal(0.0), t5,
        R::literal(0.0)], [R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0),
        p.motor_inertia]]);
    let [motor_i_sa_dot, motor_i_sb_dot, motor_i_ra_dot, motor_i_rb_dot, motor_omega_dot] = factored
        .solve([t32, t40, t49, t55, t61]);
    let mut t14_before = t14;
    let mut t15_before = t15;
    let mut rates = [motor_omega, motor_i_sa_dot, motor_i_sb_dot, motor_i_ra_dot, motor_i_rb_dot,
        motor_omega_dot];
    coefficients[0] = *state;
    let highest = coefficients.len() - 1;
    for (order, state_k) in coefficients.iter_mut().enumerate().skip(1) {
        let (k, inverse) = order_and_inverse::<R>(order);
        *state_k = rates.map(|rate| rate * inverse);
        if order == highest {
            break;
        }
        let [motor_phi_k, motor_i_sa_k, motor_i_sb_k, motor_i_ra_k, motor_i_rb_k, motor_omega_k]
            = *state_k;
        let sums = lanes.sums(order);
        let sums_1 = lanes_1.sums(order);
        let sums_2 = lanes_2.sums(order);
        let sums_3 = lanes_3.sums(order);
        let sums_4 = lanes_4.sums(order);
        let sums_5 = lanes_5.sums(order);
        let sums_6 = lanes_6.sums(order);
        let motor_theta_k = motor_phi_k * p.motor_pole_pairs;
        let sin_motor_theta_k = motor_theta_k.mul_add(cos_motor_theta, inverse * sums_1[0]);
        let cos_motor_theta_k = -motor_theta_k.mul_add(sin_motor_theta, inverse * sums_1[1]);
        let t2_k = cos_motor_theta_k * t1;
        let t3_k = sin_motor_theta_k * t1;
        let t4_k = -t3_k;
        let t7_k = motor_i_sa.mul_add(motor_i_ra_k, motor_i_ra.mul_add(motor_i_sa_k, sums[0]));
        let t8_k = motor_i_sb.mul_add(motor_i_rb_k, motor_i_rb.mul_add(motor_i_sb_k, sums[1]));
        let motor_along_k = t7_k + t8_k;
        let t9_k = motor_i_sa.mul_add(motor_i_rb_k, motor_i_rb.mul_add(motor_i_sa_k, sums[2]));
        let t10_k = motor_i_sb.mul_add(motor_i_ra_k, motor_i_ra.mul_add(motor_i_sb_k, sums[3]));
        let motor_across_k = t10_k - t9_k;
        let t14_k = inverse * motor_omega_0 * t15_before;
        let t15_k = -inverse * motor_omega_0 * t14_before;
        let t22_k = motor_i_ra_k * p.motor_pole_pairs;
        let t23_k = t22.mul_add(sin_motor_theta_k, sin_motor_theta.mul_add(t22_k, sums_1[2]));
        let t24_k = motor_i_rb_k * p.motor_pole_pairs;
        let t25_k = t24.mul_add(cos_motor_theta_k, cos_motor_theta.mul_add(t24_k, sums_1[3]));
        let t26_k = t23_k + t25_k;
        let t27_k = motor_omega_k * t1;
        let t28_k = t27.mul_add(t26_k, t26.mul_add(t27_k, sums_4[0]));
        let t31_k = (-motor_i_sa_k).mul_add(t20, t15_k * t29);
        let t32_k = t31_k + t28_k;
        let t34_k = t24.mul_add(sin_motor_theta_k, sin_motor_theta.mul_add(t24_k, sums_2[0]));
        let t35_k = t22.mul_add(cos_motor_theta_k, cos_motor_theta.mul_add(t22_k, sums_2[1]));
        let t36_k = t35_k - t34_k;
        let t37_k = t27.mul_add(t36_k, t36.mul_add(t27_k, sums_4[1]));
        let t39_k = (-motor_i_sb_k).mul_add(t20, t14_k * t29);
        let t40_k = t39_k - t37_k;
        let t43_k = motor_i_sa_k * p.motor_pole_pairs;
        let t44_k = t43.mul_add(sin_motor_theta_k, sin_motor_theta.mul_add(t43_k, sums_2[2]));
        let t45_k = motor_i_sb_k * p.motor_pole_pairs;
        let t46_k = t45.mul_add(cos_motor_theta_k, cos_motor_theta.mul_add(t45_k, sums_2[3]));
        let t47_k = t44_k - t46_k;
        let t48_k = t27.mul_add(t47_k, t47.mul_add(t27_k, sums_4[2]));
        let t49_k = (-motor_i_ra_k).mul_add(t41, t48_k);
        let t51_k = t43.mul_add(cos_motor_theta_k, cos_motor_theta.mul_add(t43_k, sums_3[0]));
        let t52_k = t45.mul_add(sin_motor_theta_k, sin_motor_theta.mul_add(t45_k, sums_3[1]));
        let t53_k = t51_k + t52_k;
        let t54_k = t27.mul_add(t53_k, t53.mul_add(t27_k, sums_4[3]));
        let t55_k = (-motor_i_rb_k).mul_add(t41, t54_k);
        let t56_k = motor_along_k * p.motor_pole_pairs;
        let t57_k = sin_motor_theta.mul_add(t56_k, t56.mul_add(sin_motor_theta_k, sums_3[2]));
        let t58_k = motor_across_k * p.motor_pole_pairs;
        let t59_k = cos_motor_theta.mul_add(t58_k, t58.mul_add(cos_motor_theta_k, sums_3[3]));
        let t60_k = t59_k - t57_k;
        let t61_k = t60_k * t1;
        let n100_k = t2_k.mul_add(motor_i_ra_dot, sums_5[0]);
        let n101_k = t4_k.mul_add(motor_i_rb_dot, sums_5[1]);
        let n102_k = t3_k.mul_add(motor_i_ra_dot, sums_5[2]);
        let n103_k = t2_k.mul_add(motor_i_rb_dot, sums_5[3]);
        let n104_k = t2_k.mul_add(motor_i_sa_dot, sums_6[0]);
        let n105_k = t3_k.mul_add(motor_i_sb_dot, sums_6[1]);
        let n106_k = t4_k.mul_add(motor_i_sa_dot, sums_6[2]);
        let n107_k = t2_k.mul_add(motor_i_sb_dot, sums_6[3]);
        let n108_k = n100_k + n101_k;
        let t32_k_2 = t32_k - n108_k;
        let n110_k = n102_k + n103_k;
        let t40_k_2 = t40_k - n110_k;
        let n112_k = n104_k + n105_k;
        let t49_k_2 = t49_k - n112_k;
        let n114_k = n106_k + n107_k;
        let t55_k_2 = t55_k - n114_k;
        let [motor_i_sa_dot_k, motor_i_sb_dot_k, motor_i_ra_dot_k, motor_i_rb_dot_k,
            motor_omega_dot_k] = factored.solve([t32_k_2, t40_k_2, t49_k_2, t55_k_2, t61_k]);
        lanes.set(order, [motor_i_sa_k, motor_i_sb_k, motor_i_sa_k, motor_i_ra_k], [motor_i_ra_k,
            motor_i_rb_k, motor_i_rb_k, motor_i_sb_k]);
        lanes_1.set(order, [k * motor_theta_k, k * motor_theta_k, sin_motor_theta_k,
            cos_motor_theta_k], [cos_motor_theta_k, sin_motor_theta_k, t22_k, t24_k]);
        lanes_2.set(order, [sin_motor_theta_k, cos_motor_theta_k, sin_motor_theta_k,
            cos_motor_theta_k], [t24_k, t22_k, t43_k, t45_k]);
        lanes_3.set(order, [cos_motor_theta_k, sin_motor_theta_k, sin_motor_theta_k,
            cos_motor_theta_k], [t43_k, t45_k, t56_k, t58_k]);
        lanes_4.set(order, [t26_k, t27_k, t27_k, t27_k], [t27_k, t36_k, t47_k, t53_k]);
        lanes_5.set(order, [t2_k, t4_k, t3_k, t2_k], [motor_i_ra_dot_k, motor_i_rb_dot_k,
            motor_i_ra_dot_k, motor_i_rb_dot_k]);
        lanes_6.set(order, [t2_k, t3_k, t4_k, t2_k], [motor_i_sa_dot_k, motor_i_sb_dot_k,
            motor_i_sa_dot_k, motor_i_sb_dot_k]);
        t14_before = t14_k;
        t15_before = t15_k;
        rates = [motor_omega_k, motor_i_sa_dot_k, motor_i_sb_dot_k, motor_i_ra_dot_k,
            motor_i_rb_dot_k, motor_omega_dot_k];
    }
}

// Emitted by Machinist 0.1.0; do not edit. To make it again:
//
//     cargo run --release -- gen
//
// Sources, with SHA-256:
//   ededd50d7761559adb7e3a8af6856f7492c10a532d751730f98cb9c4ba2d736a  scenes/saw_gin_as_printed.toml
//   e207f0c5b2968da441dc246e9142c471829e8b7dd7f33fc61589afdd7a34b871  units/textile/induction_motor_as_printed.toml
//   512419e5aa73ad1710ef3556037050e97b898e87a7d5d8a4e9c4b03a7a8b0141  units/coupling.toml
//   ba9b76a100d91a8597c44349f557e301fa971bdcc9a7e0cf5da5ce4fd6af94b2  units/rotor.toml
//   02dd59962bd405d6a2dcac78b4101ca2138de7a376566a8d8c4460eb40293556  units/textile/technological_load.toml
//
// Saw gin with the equations and numbers as printed
//
// For the reproduction ledger: started without load and loaded later, like the consistent scene.
//
// Source:
//   Saw-gin study (2020), equations (1) and (2), as printed.
//
// All quantities are in SI units.
// Shapes: coordinates 2, first-order states 4, states 8, parameters 23, outputs 5, discontinuities 1,
//     saturations 1.
// Nonzeros: mass_matrix 2 of 2 by 2, rate_jacobian 30 of 8 by 8, parameter_jacobian 38 of 8 by 23.
// Operations: discontinuities 6, rate 85, forcing 41, rate_jacobian 78, parameter_jacobian 179,
//     time_derivative 32, outputs 42, energy 12, power_balance 62, saturating_arguments 2,
//     prepare 61, prepared_rate 61, prepared_rate_jacobian 42, prepared_jacobians 167.

use ::machinist_contract::{
    Energy, PowerBalance, Real, taylor::{Lanes, order_and_inverse},
};

::machinist_contract::simulator! {
    /// Saw gin with the equations and numbers as printed
    ///
    /// For the reproduction ledger: started without load and loaded later, like the consistent scene.
    ///
    /// Source: Saw-gin study (2020), equations (1) and (2), as printed.
    SawGinAsPrinted: "saw_gin_as_printed", "Saw gin with the equations and numbers as printed";
    run from 0.0, until 3.0, points 3001, rtol 1e-8, method "tsit5";
    quadratures 0, discontinuities 1;
    prepared; jacobians_at_once; saturations 1; series 9;
}

::machinist_contract::parameters! {
    motor_inertia: 4.2, "kg m^2", "motor.inertia", "moment of inertia of the rotor";
    motor_u_m: 220.0, "V", "motor.u_m", "printed amplitude of the phase voltage";
    motor_gamma: 0.0, "rad", "motor.gamma", "supply phase";
    motor_omega_0: 78.54, "rad/s", "motor.omega_0", "printed synchronous speed";
    motor_pole_pairs: 4.0, "1", "motor.pole_pairs", "pole pairs";
    motor_k_s: 0.956, "1", "motor.k_s", "stator coupling factor";
    motor_k_r: 0.952, "1", "motor.k_r", "rotor coupling factor";
    motor_sigma: 0.0896, "1", "motor.sigma", "printed leakage factor";
    motor_x_s: 4.14, "ohm", "motor.x_s", "stator reactance";
    motor_alpha_s: 0.115, "1", "motor.alpha_s", "stator decay factor";
    motor_alpha_r: 0.0858, "1", "motor.alpha_r", "rotor decay factor";
    motor_literal: 1.0, "1", "motor.literal", "1: rotor angle, as printed; 0: rotor speed";
    coupling_stiffness: 23065.2, "N m/rad", "coupling.stiffness", "torsional stiffness";
    coupling_damping: 128.5346, "N m s/rad", "coupling.damping", "torsional damping";
    coupling_ratio: 1.0, "1", "coupling.ratio", "turns of the driving end per turn of the driven end";
    cylinder_inertia: 1.244, "kg m^2", "cylinder.inertia", "moment of inertia";
    load_mean: 843.72, "N m", "load.mean", "mean torque";
    load_amplitude: 78.78, "N m", "load.amplitude", "amplitude of the harmonic part";
    load_speed: 735.0, "1", "load.speed", "nominal speed in revolutions per minute, dimensionless as in the study";
    load_phase: 0.0, "rad", "load.phase", "phase of the harmonic part";
    load_engagement_time: 1.2, "s", "load.engagement_time", "time at which half of the load acts";
    load_engagement_width: 0.02, "s", "load.engagement_width", "time constant of engagement";
    load_standstill_band: 0.5, "rad/s", "load.standstill_band", "speed below which the load fades out";
}

::machinist_contract::outputs! {
    motor_speed: "rad/s", "motor_speed", "rate of rotor angle";
    cylinder_speed: "rad/s", "cylinder_speed", "rate of angle";
    motor_torque: "N m", "motor_torque", "driving torque";
    coupling_torque: "N m", "coupling_torque", "torque at the driving end";
    cylinder_acceleration: at_once "rad/s^2", "cylinder_acceleration", "rate of rate of angle";
}

::machinist_contract::states! {
    MOTOR_PHI: position, 150.0, "rad", "motor.phi", "rotor angle";
    CYLINDER_PHI: position, 150.0, "rad", "cylinder.phi", "angle";
    MOTOR_OMEGA: velocity, 78.5, "rad/s", "motor.omega", "rate of rotor angle";
    CYLINDER_OMEGA: velocity, 78.5, "rad/s", "cylinder.omega", "rate of angle";
    MOTOR_PSI_X1: first_order, 1.0, "V s", "motor.psi_x1", "stator flux linkage along x";
    MOTOR_PSI_Y1: first_order, 1.0, "V s", "motor.psi_y1", "stator flux linkage along y";
    MOTOR_PSI_X2: first_order, 1.0, "V s", "motor.psi_x2", "rotor flux linkage along x";
    MOTOR_PSI_Y2: first_order, 1.0, "V s", "motor.psi_y2", "rotor flux linkage along y";
}

::machinist_contract::patterns! {
    /// Nonzeros of M.
    MASS_MATRIX_PATTERN: 2 by 2 { 0 [0] 1 [1] }
    /// Nonzeros of dy'/dy.
    RATE_JACOBIAN_PATTERN: 8 by 8 { 0 [2] 1 [3] 2 [0 1 2 3 4 5 6 7] 3 [0 1 2 3] 4 [4 5 6] 5 [4 5 7]
        6 [0 2 4 6 7] 7 [0 2 5 6 7] }
    /// Nonzeros of dy'/dp.
    PARAMETER_JACOBIAN_PATTERN: 8 by 23 { 2 [0 3 4 6 7 8 12 13 14]
        3 [12 13 14 15 16 17 18 19 20 21 22] 4 [1 2 3 6 9] 5 [1 2 3 6 9] 6 [3 5 10 11]
        7 [3 5 10 11] }
}

::machinist_contract::constants! {
    t0, t1, t4, t5, inverse_load_standstill_band, inverse_motor_inertia, inverse_cylinder_inertia, t6,
    t7, motor_omega_0_times_motor_alpha_s, t8, motor_u_m_times_cos_motor_gamma,
    motor_u_m_times_sin_motor_gamma, motor_omega_0_times_motor_alpha_r, t9,
    inverse_load_engagement_width, cylinder_omega_dot_by_motor_phi, motor_omega_dot_by_motor_phi,
    cylinder_omega_dot_by_cylinder_phi, motor_omega_dot_by_cylinder_phi,
    cylinder_omega_dot_by_motor_omega, motor_omega_dot_by_motor_omega, t10,
    motor_omega_dot_by_cylinder_omega, motor_psi_x1_dot_by_motor_psi_x1,
    motor_psi_y1_dot_by_motor_psi_x1, motor_psi_x2_dot_by_motor_psi_x2, cos_motor_gamma,
    sin_motor_gamma, t11, t12, motor_k_r_times_motor_alpha_s, motor_k_s_times_motor_alpha_r, t13,
    t14, t15, t16, t17, t18, t19, t20, inverse_load_standstill_band_squared
}

/// Returns the constants of `rate` and its Jacobians from the parameters. 61 operations.
#[must_use]
#[inline]
pub fn prepare<R: Real>(p: &Parameters<R>) -> Constants<R> {
    let (sin_motor_gamma, cos_motor_gamma) = p.motor_gamma.sin_cos();
    let load_omega_2 = R::literal(0.104_719_755_119_659_77) * p.load_speed;
    let t0 = R::literal(1.0) - p.motor_literal;
    let t1 = R::literal(-1.0) / p.load_engagement_width;
    let t2 = R::literal(1.5) * p.motor_omega_0;
    let t3 = t2 * p.motor_pole_pairs;
    let motor_sigma_times_motor_x_s = p.motor_sigma * p.motor_x_s;
    let t4 = t3 * p.motor_k_r / motor_sigma_times_motor_x_s;
    let t5 = R::literal(core::f64::consts::PI) * load_omega_2;
    let inverse_load_standstill_band = R::literal(1.0) / p.load_standstill_band;
    let inverse_motor_inertia = R::literal(1.0) / p.motor_inertia;
    let inverse_cylinder_inertia = R::literal(1.0) / p.cylinder_inertia;
    let t6 = p.coupling_stiffness * p.coupling_ratio;
    let t7 = p.coupling_damping * p.coupling_ratio;
    let motor_omega_0_times_motor_alpha_s = p.motor_omega_0 * p.motor_alpha_s;
    let t8 = p.motor_omega_0 * p.motor_k_r * p.motor_alpha_s;
    let motor_u_m_times_cos_motor_gamma = p.motor_u_m * cos_motor_gamma;
    let motor_u_m_times_sin_motor_gamma = p.motor_u_m * sin_motor_gamma;
    let motor_omega_0_times_motor_alpha_r = p.motor_omega_0 * p.motor_alpha_r;
    let t9 = p.motor_omega_0 * p.motor_k_s * p.motor_alpha_r;
    let inverse_load_engagement_width = R::literal(1.0) / p.load_engagement_width;
    let cylinder_omega_dot_by_motor_phi = t6 * inverse_cylinder_inertia;
    let motor_omega_dot_by_motor_phi = -(p.coupling_stiffness * inverse_motor_inertia);
    let coupling_ratio_squared = p.coupling_ratio * p.coupling_ratio;
    let cylinder_omega_dot_by_cylinder_phi = -(p.coupling_stiffness * coupling_ratio_squared
        * inverse_cylinder_inertia);
    let motor_omega_dot_by_cylinder_phi = t6 * inverse_motor_inertia;
    let cylinder_omega_dot_by_motor_omega = t7 * inverse_cylinder_inertia;
    let motor_omega_dot_by_motor_omega = -(p.coupling_damping * inverse_motor_inertia);
    let t10 = p.coupling_damping * coupling_ratio_squared;
    let motor_omega_dot_by_cylinder_omega = t7 * inverse_motor_inertia;
    let motor_psi_x1_dot_by_motor_psi_x1 = -motor_omega_0_times_motor_alpha_s;
    let motor_psi_y1_dot_by_motor_psi_x1 = -p.motor_omega_0;
    let motor_psi_x2_dot_by_motor_psi_x2 = -motor_omega_0_times_motor_alpha_r;
    let t11 = -motor_u_m_times_sin_motor_gamma;
    let t12 = R::literal(1.5) * p.motor_pole_pairs * p.motor_k_r / motor_sigma_times_motor_x_s;
    let motor_k_r_times_motor_alpha_s = p.motor_k_r * p.motor_alpha_s;
    let motor_k_s_times_motor_alpha_r = p.motor_k_s * p.motor_alpha_r;
    let t13 = t2 * p.motor_k_r / motor_sigma_times_motor_x_s;
    let t14 = t3 / motor_sigma_times_motor_x_s;
    let t15 = R::literal(-1.0) / p.motor_sigma;
    let t16 = R::literal(-1.0) / p.motor_x_s;
    let t17 = R::literal(2.0) * p.coupling_stiffness * p.coupling_ratio;
    let t18 = R::literal(2.0) * p.coupling_damping * p.coupling_ratio;
    let t19 = R::literal(-0.328_986_813_369_645_25) * p.load_amplitude;
    let t20 = R::literal(1.0) / (p.load_engagement_width * p.load_engagement_width);
    let inverse_load_standstill_band_squared = R::literal(1.0) / (p.load_standstill_band
        * p.load_standstill_band);
    Constants { t0, t1, t4, t5, inverse_load_standstill_band, inverse_motor_inertia,
        inverse_cylinder_inertia, t6, t7, motor_omega_0_times_motor_alpha_s, t8,
        motor_u_m_times_cos_motor_gamma, motor_u_m_times_sin_motor_gamma,
        motor_omega_0_times_motor_alpha_r, t9, inverse_load_engagement_width,
        cylinder_omega_dot_by_motor_phi, motor_omega_dot_by_motor_phi,
        cylinder_omega_dot_by_cylinder_phi, motor_omega_dot_by_cylinder_phi,
        cylinder_omega_dot_by_motor_omega, motor_omega_dot_by_motor_omega, t10,
        motor_omega_dot_by_cylinder_omega, motor_psi_x1_dot_by_motor_psi_x1,
        motor_psi_y1_dot_by_motor_psi_x1, motor_psi_x2_dot_by_motor_psi_x2, cos_motor_gamma,
        sin_motor_gamma, t11, t12, motor_k_r_times_motor_alpha_s, motor_k_s_times_motor_alpha_r,
        t13, t14, t15, t16, t17, t18, t19, t20, inverse_load_standstill_band_squared }
}

/// State at the start of the run, in the units of the states. No operations.
#[must_use]
pub fn initial_state<R: Real>(_p: &Parameters<R>) -> [R; STATES] {
    [R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0),
        R::literal(0.0), R::literal(0.0), R::literal(0.0)]
}

/// Times of known jumps of the right-hand side \[s\], unsorted. 6 operations.
#[must_use]
pub fn discontinuities<R: Real>(p: &Parameters<R>) -> [R; DISCONTINUITIES] {
    let inverse_load_engagement_width = R::literal(1.0) / p.load_engagement_width;
    let abs_inverse_load_engagement_width = inverse_load_engagement_width.abs();
    [R::select_less(R::literal(33.333_333_333_333_336), abs_inverse_load_engagement_width,
        R::select_less(R::literal(0.0), abs_inverse_load_engagement_width,
        inverse_load_engagement_width * p.load_engagement_time / inverse_load_engagement_width,
        R::literal(0.0)), R::literal(0.0))]
}

/// As `rate`, with the constants of the parameters from `prepare`. 61 operations.
#[must_use]
#[inline]
pub fn prepared_rate<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>,
        c: &Constants<R>) -> [R; STATES] {
    let [motor_phi, cylinder_phi, motor_omega, cylinder_omega, motor_psi_x1, motor_psi_y1,
        motor_psi_x2, motor_psi_y2] = *state;
    let coupling_twist = motor_phi.sub_product(p.coupling_ratio, cylinder_phi);
    let coupling_twist_rate = motor_omega.sub_product(p.coupling_ratio, cylinder_omega);
    let motor_rotor_term = (p.motor_literal * motor_phi).add_product(c.t0, motor_omega);
    let load_engagement = R::literal(1.0) / (R::literal(1.0)
        + (c.t1 * (time - p.load_engagement_time)).exp());
    let coupling_torque = (p.coupling_stiffness * coupling_twist).add_product(p.coupling_damping,
        coupling_twist_rate);
    let motor_torque = c.t4 * (motor_psi_y1 * motor_psi_x2).sub_product(motor_psi_x1, motor_psi_y2);
    let load_resistance = load_engagement * p.load_mean.add_product(p.load_amplitude, p.load_phase
        .add_product(c.t5, time).sin()) * (c.inverse_load_standstill_band * cylinder_omega).tanh();
    let cylinder_omega_dot = ((c.t6 * coupling_twist).add_product(c.t7, coupling_twist_rate)
        - load_resistance) * c.inverse_cylinder_inertia;
    let motor_omega_dot = (motor_torque - coupling_torque) * c.inverse_motor_inertia;
    let motor_psi_x1_dot = c.motor_u_m_times_cos_motor_gamma.add_product(p.motor_omega_0,
        motor_psi_y1).add_product(c.t8, motor_psi_x2)
        .sub_product(c.motor_omega_0_times_motor_alpha_s, motor_psi_x1);
    let motor_psi_y1_dot = c.motor_u_m_times_sin_motor_gamma.add_product(c.t8, motor_psi_y2)
        .sub_product(p.motor_omega_0, motor_psi_x1)
        .sub_product(c.motor_omega_0_times_motor_alpha_s, motor_psi_y1);
    let motor_psi_x2_dot = (c.t9 * motor_psi_x1).add_product(p.motor_omega_0, motor_psi_y2)
        .sub_product(c.motor_omega_0_times_motor_alpha_r, motor_psi_x2).sub_product(motor_psi_y2,
        motor_rotor_term);
    let motor_psi_y2_dot = (c.t9 * motor_psi_y1).add_product(motor_psi_x2, motor_rotor_term)
        .sub_product(p.motor_omega_0, motor_psi_x2)
        .sub_product(c.motor_omega_0_times_motor_alpha_r, motor_psi_y2);
    [motor_omega, cylinder_omega, motor_omega_dot, cylinder_omega_dot, motor_psi_x1_dot,
        motor_psi_y1_dot, motor_psi_x2_dot, motor_psi_y2_dot]
}

/// `M = d2L/dq'2`, values in the order of its pattern. No operations.
#[must_use]
pub fn mass_matrix<R: Real>(_time: R, _state: &[R; STATES], p: &Parameters<R>) -> [R; 2] {
    [p.motor_inertia, p.cylinder_inertia]
}

/// `f` of `M q'' = f + G^T lambda`, one for each coordinate. 41 operations.
#[must_use]
pub fn forcing<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>) -> [R; COORDINATES] {
    let [motor_phi, cylinder_phi, motor_omega, cylinder_omega, motor_psi_x1, motor_psi_y1,
        motor_psi_x2, motor_psi_y2] = *state;
    let load_omega_2 = R::literal(0.104_719_755_119_659_77) * p.load_speed;
    let coupling_twist = motor_phi.sub_product(p.coupling_ratio, cylinder_phi);
    let coupling_twist_rate = motor_omega.sub_product(p.coupling_ratio, cylinder_omega);
    let load_engagement = R::literal(1.0) / (R::literal(1.0) + (R::literal(-1.0)
        / p.load_engagement_width * (time - p.load_engagement_time)).exp());
    let coupling_torque = (p.coupling_stiffness * coupling_twist).add_product(p.coupling_damping,
        coupling_twist_rate);
    let motor_torque = R::literal(1.5) * p.motor_omega_0 * p.motor_pole_pairs * p.motor_k_r
        / (p.motor_sigma * p.motor_x_s) * (motor_psi_y1 * motor_psi_x2).sub_product(motor_psi_x1,
        motor_psi_y2);
    let load_resistance = load_engagement * p.load_mean.add_product(p.load_amplitude, p.load_phase
        .add_product(R::literal(core::f64::consts::PI) * load_omega_2, time).sin())
        * (R::literal(1.0) / p.load_standstill_band * cylinder_omega).tanh();
    let motor_phi_forcing = motor_torque - coupling_torque;
    let cylinder_phi_forcing = (p.coupling_stiffness * p.coupling_ratio * coupling_twist)
        .add_product(p.coupling_damping * p.coupling_ratio, coupling_twist_rate) - load_resistance;
    [motor_phi_forcing, cylinder_phi_forcing]
}

/// As `rate_jacobian`, with the constants of the parameters from `prepare`. 42 operations.
#[must_use]
pub fn prepared_rate_jacobian<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>,
        c: &Constants<R>) -> [R; 30] {
    let [motor_phi, _, motor_omega, cylinder_omega, motor_psi_x1, motor_psi_y1, motor_psi_x2,
        motor_psi_y2] = *state;
    let motor_rotor_term = (p.motor_literal * motor_phi).add_product(c.t0, motor_omega);
    let load_engagement = R::literal(1.0) / (R::literal(1.0) + (-(c.inverse_load_engagement_width
        * (time - p.load_engagement_time))).exp());
    let t0 = (c.inverse_load_standstill_band * cylinder_omega).tanh();
    let motor_psi_x2_dot_by_motor_phi = -(p.motor_literal * motor_psi_y2);
    let motor_psi_y2_dot_by_motor_phi = p.motor_literal * motor_psi_x2;
    let motor_psi_x2_dot_by_motor_omega = -(c.t0 * motor_psi_y2);
    let motor_psi_y2_dot_by_motor_omega = c.t0 * motor_psi_x2;
    let cylinder_omega_dot_by_cylinder_omega = -(c.t10.add_product(c.inverse_load_standstill_band
        * load_engagement * R::literal(1.0).sub_product(t0, t0), p.load_mean
        .add_product(p.load_amplitude, p.load_phase.add_product(c.t5, time).sin()))
        * c.inverse_cylinder_inertia);
    let motor_omega_dot_by_motor_psi_x1 = -(c.t4 * motor_psi_y2 * c.inverse_motor_inertia);
    let motor_omega_dot_by_motor_psi_y1 = c.t4 * motor_psi_x2 * c.inverse_motor_inertia;
    let motor_omega_dot_by_motor_psi_x2 = c.t4 * motor_psi_y1 * c.inverse_motor_inertia;
    let motor_psi_y2_dot_by_motor_psi_x2 = motor_rotor_term - p.motor_omega_0;
    let motor_omega_dot_by_motor_psi_y2 = -(c.t4 * motor_psi_x1 * c.inverse_motor_inertia);
    let motor_psi_x2_dot_by_motor_psi_y2 = p.motor_omega_0 - motor_rotor_term;
    [R::literal(1.0), R::literal(1.0), c.motor_omega_dot_by_motor_phi,
        c.motor_omega_dot_by_cylinder_phi, c.motor_omega_dot_by_motor_omega,
        c.motor_omega_dot_by_cylinder_omega, motor_omega_dot_by_motor_psi_x1,
        motor_omega_dot_by_motor_psi_y1, motor_omega_dot_by_motor_psi_x2,
        motor_omega_dot_by_motor_psi_y2, c.cylinder_omega_dot_by_motor_phi,
        c.cylinder_omega_dot_by_cylinder_phi, c.cylinder_omega_dot_by_motor_omega,
        cylinder_omega_dot_by_cylinder_omega, c.motor_psi_x1_dot_by_motor_psi_x1, p.motor_omega_0,
        c.t8, c.motor_psi_y1_dot_by_motor_psi_x1, c.motor_psi_x1_dot_by_motor_psi_x1, c.t8,
        motor_psi_x2_dot_by_motor_phi, motor_psi_x2_dot_by_motor_omega, c.t9,
        c.motor_psi_x2_dot_by_motor_psi_x2, motor_psi_x2_dot_by_motor_psi_y2,
        motor_psi_y2_dot_by_motor_phi, motor_psi_y2_dot_by_motor_omega, c.t9,
        motor_psi_y2_dot_by_motor_psi_x2, c.motor_psi_x2_dot_by_motor_psi_x2]
}

/// `rate_jacobian`, then `parameter_jacobian`, with the constants of the parameters from `prepare`.
/// 167 operations.
#[must_use]
pub fn prepared_jacobians<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>,
        c: &Constants<R>) -> [R; 68] {
    let [motor_phi, cylinder_phi, motor_omega, cylinder_omega, motor_psi_x1, motor_psi_y1,
        motor_psi_x2, motor_psi_y2] = *state;
    let t0 = p.load_phase.add_product(c.t5, time);
    let (t1, t2) = t0.sin_cos();
    let motor_rotor_term = (p.motor_literal * motor_phi).add_product(c.t0, motor_omega);
    let time_minus_load_engagement_time = time - p.load_engagement_time;
    let t3 = c.inverse_load_engagement_width * time_minus_load_engagement_time;
    let t4 = R::literal(1.0) + (-t3).exp();
    let load_engagement = R::literal(1.0) / t4;
    let t5 = p.load_mean.add_product(p.load_amplitude, t1);
    let t6 = (c.inverse_load_standstill_band * cylinder_omega).tanh();
    let motor_psi_x2_dot_by_motor_phi = -(p.motor_literal * motor_psi_y2);
    let motor_psi_y2_dot_by_motor_phi = p.motor_literal * motor_psi_x2;
    let motor_psi_x2_dot_by_motor_omega = -(c.t0 * motor_psi_y2);
    let motor_psi_y2_dot_by_motor_omega = c.t0 * motor_psi_x2;
    let t7 = R::literal(1.0).sub_product(t6, t6);
    let cylinder_omega_dot_by_cylinder_omega = -(c.t10.add_product(c.inverse_load_standstill_band
        * load_engagement * t7, t5) * c.inverse_cylinder_inertia);
    let motor_omega_dot_by_motor_psi_x1 = -(c.t4 * motor_psi_y2 * c.inverse_motor_inertia);
    let motor_omega_dot_by_motor_psi_y1 = c.t4 * motor_psi_x2 * c.inverse_motor_inertia;
    let motor_omega_dot_by_motor_psi_x2 = c.t4 * motor_psi_y1 * c.inverse_motor_inertia;
    let motor_psi_y2_dot_by_motor_psi_x2 = motor_rotor_term - p.motor_omega_0;
    let motor_omega_dot_by_motor_psi_y2 = -(c.t4 * motor_psi_x1 * c.inverse_motor_inertia);
    let motor_psi_x2_dot_by_motor_psi_y2 = p.motor_omega_0 - motor_rotor_term;
    let coupling_ratio_times_cylinder_phi = p.coupling_ratio * cylinder_phi;
    let coupling_twist = motor_phi - coupling_ratio_times_cylinder_phi;
    let coupling_ratio_times_cylinder_omega = p.coupling_ratio * cylinder_omega;
    let coupling_twist_rate = motor_omega - coupling_ratio_times_cylinder_omega;
    let coupling_torque = (p.coupling_stiffness * coupling_twist).add_product(p.coupling_damping,
        coupling_twist_rate);
    let t8 = (motor_psi_y1 * motor_psi_x2).sub_product(motor_psi_x1, motor_psi_y2);
    let motor_torque = c.t4 * t8;
    let load_resistance = load_engagement * t5 * t6;
    let cylinder_omega_dot = ((c.t6 * coupling_twist).add_product(c.t7, coupling_twist_rate)
        - load_resistance) * c.inverse_cylinder_inertia;
    let motor_omega_dot = (motor_torque - coupling_torque) * c.inverse_motor_inertia;
    let motor_omega_dot_by_motor_inertia = -(motor_omega_dot * c.inverse_motor_inertia);
    let motor_omega_dot_by_motor_omega_0 = c.t12 * t8 * c.inverse_motor_inertia;
    let motor_psi_x1_dot_by_motor_omega_0 = motor_psi_y1
        .add_product(c.motor_k_r_times_motor_alpha_s, motor_psi_x2).sub_product(p.motor_alpha_s,
        motor_psi_x1);
    let motor_psi_y1_dot_by_motor_omega_0 = (-motor_psi_x1)
        .add_product(c.motor_k_r_times_motor_alpha_s, motor_psi_y2).sub_product(p.motor_alpha_s,
        motor_psi_y1);
    let motor_psi_x2_dot_by_motor_omega_0 = motor_psi_y2
        .add_product(c.motor_k_s_times_motor_alpha_r, motor_psi_x1).sub_product(p.motor_alpha_r,
        motor_psi_x2);
    let motor_psi_y2_dot_by_motor_omega_0 = (-motor_psi_x2)
        .add_product(c.motor_k_s_times_motor_alpha_r, motor_psi_y1).sub_product(p.motor_alpha_r,
        motor_psi_y2);
    let motor_omega_dot_by_motor_pole_pairs = c.t13 * t8 * c.inverse_motor_inertia;
    let motor_psi_x2_dot_by_motor_k_s = c.motor_omega_0_times_motor_alpha_r * motor_psi_x1;
    let motor_psi_y2_dot_by_motor_k_s = c.motor_omega_0_times_motor_alpha_r * motor_psi_y1;
    let motor_omega_dot_by_motor_k_r = c.t14 * t8 * c.inverse_motor_inertia;
    let motor_psi_x1_dot_by_motor_k_r = c.motor_omega_0_times_motor_alpha_s * motor_psi_x2;
    let motor_psi_y1_dot_by_motor_k_r = c.motor_omega_0_times_motor_alpha_s * motor_psi_y2;
    let motor_omega_dot_by_motor_sigma = c.t15 * motor_torque * c.inverse_motor_inertia;
    let motor_omega_dot_by_motor_x_s = c.t16 * motor_torque * c.inverse_motor_inertia;
    let motor_psi_x1_dot_by_motor_alpha_s = p.motor_omega_0 * (-motor_psi_x1)
        .add_product(p.motor_k_r, motor_psi_x2);
    let motor_psi_y1_dot_by_motor_alpha_s = p.motor_omega_0 * (-motor_psi_y1)
        .add_product(p.motor_k_r, motor_psi_y2);
    let motor_psi_x2_dot_by_motor_alpha_r = p.motor_omega_0 * (-motor_psi_x2)
        .add_product(p.motor_k_s, motor_psi_x1);
    let motor_psi_y2_dot_by_motor_alpha_r = p.motor_omega_0 * (-motor_psi_y2)
        .add_product(p.motor_k_s, motor_psi_y1);
    let motor_phi_minus_motor_omega = motor_phi - motor_omega;
    let motor_psi_x2_dot_by_motor_literal = -(motor_psi_y2 * motor_phi_minus_motor_omega);
    let motor_psi_y2_dot_by_motor_literal = motor_psi_x2 * motor_phi_minus_motor_omega;
    let cylinder_omega_dot_by_coupling_stiffness = p.coupling_ratio * coupling_twist
        * c.inverse_cylinder_inertia;
    let motor_omega_dot_by_coupling_stiffness = (coupling_ratio_times_cylinder_phi - motor_phi)
        * c.inverse_motor_inertia;
    let cylinder_omega_dot_by_coupling_damping = p.coupling_ratio * coupling_twist_rate
        * c.inverse_cylinder_inertia;
    let motor_omega_dot_by_coupling_damping = (coupling_ratio_times_cylinder_omega - motor_omega)
        * c.inverse_motor_inertia;
    let cylinder_omega_dot_by_coupling_ratio = (p.coupling_stiffness * motor_phi)
        .add_product(p.coupling_damping, motor_omega).sub_product(c.t17, cylinder_phi)
        .sub_product(c.t18, cylinder_omega) * c.inverse_cylinder_inertia;
    let motor_omega_dot_by_coupling_ratio = (p.coupling_stiffness * cylinder_phi)
        .add_product(p.coupling_damping, cylinder_omega) * c.inverse_motor_inertia;
    let cylinder_omega_dot_by_cylinder_inertia = -(cylinder_omega_dot * c.inverse_cylinder_inertia);
    let cylinder_omega_dot_by_load_mean = -(load_engagement * t6 * c.inverse_cylinder_inertia);
    let cylinder_omega_dot_by_load_amplitude = -(load_engagement * t1 * t6
        * c.inverse_cylinder_inertia);
    let cylinder_omega_dot_by_load_speed = c.t19 * time * load_engagement * t2 * t6
        * c.inverse_cylinder_inertia;
    let cylinder_omega_dot_by_load_phase = -(p.load_amplitude * load_engagement * t2 * t6
        * c.inverse_cylinder_inertia);
    let t9 = t4 * (R::literal(1.0) + t3.exp());
    let cylinder_omega_dot_by_load_engagement_time = c.inverse_load_engagement_width * t5 * t6 / t9
        * c.inverse_cylinder_inertia;
    let cylinder_omega_dot_by_load_engagement_width = c.t20 * time_minus_load_engagement_time * t5
        * t6 / t9 * c.inverse_cylinder_inertia;
    let cylinder_omega_dot_by_load_standstill_band = c.inverse_load_standstill_band_squared
        * cylinder_omega * load_engagement * t7 * t5 * c.inverse_cylinder_inertia;
    [R::literal(1.0), R::literal(1.0), c.motor_omega_dot_by_motor_phi,
        c.motor_omega_dot_by_cylinder_phi, c.motor_omega_dot_by_motor_omega,
        c.motor_omega_dot_by_cylinder_omega, motor_omega_dot_by_motor_psi_x1,
        motor_omega_dot_by_motor_psi_y1, motor_omega_dot_by_motor_psi_x2,
        motor_omega_dot_by_motor_psi_y2, c.cylinder_omega_dot_by_motor_phi,
        c.cylinder_omega_dot_by_cylinder_phi, c.cylinder_omega_dot_by_motor_omega,
        cylinder_omega_dot_by_cylinder_omega, c.motor_psi_x1_dot_by_motor_psi_x1, p.motor_omega_0,
        c.t8, c.motor_psi_y1_dot_by_motor_psi_x1, c.motor_psi_x1_dot_by_motor_psi_x1, c.t8,
        motor_psi_x2_dot_by_motor_phi, motor_psi_x2_dot_by_motor_omega, c.t9,
        c.motor_psi_x2_dot_by_motor_psi_x2, motor_psi_x2_dot_by_motor_psi_y2,
        motor_psi_y2_dot_by_motor_phi, motor_psi_y2_dot_by_motor_omega, c.t9,
        motor_psi_y2_dot_by_motor_psi_x2, c.motor_psi_x2_dot_by_motor_psi_x2,
        motor_omega_dot_by_motor_inertia, motor_omega_dot_by_motor_omega_0,
        motor_omega_dot_by_motor_pole_pairs, motor_omega_dot_by_motor_k_r,
        motor_omega_dot_by_motor_sigma, motor_omega_dot_by_motor_x_s,
        motor_omega_dot_by_coupling_stiffness, motor_omega_dot_by_coupling_damping,
        motor_omega_dot_by_coupling_ratio, cylinder_omega_dot_by_coupling_stiffness,
        cylinder_omega_dot_by_coupling_damping, cylinder_omega_dot_by_coupling_ratio,
        cylinder_omega_dot_by_cylinder_inertia, cylinder_omega_dot_by_load_mean,
        cylinder_omega_dot_by_load_amplitude, cylinder_omega_dot_by_load_speed,
        cylinder_omega_dot_by_load_phase, cylinder_omega_dot_by_load_engagement_time,
        cylinder_omega_dot_by_load_engagement_width, cylinder_omega_dot_by_load_standstill_band,
        c.cos_motor_gamma, c.t11, motor_psi_x1_dot_by_motor_omega_0, motor_psi_x1_dot_by_motor_k_r,
        motor_psi_x1_dot_by_motor_alpha_s, c.sin_motor_gamma, c.motor_u_m_times_cos_motor_gamma,
        motor_psi_y1_dot_by_motor_omega_0, motor_psi_y1_dot_by_motor_k_r,
        motor_psi_y1_dot_by_motor_alpha_s, motor_psi_x2_dot_by_motor_omega_0,
        motor_psi_x2_dot_by_motor_k_s, motor_psi_x2_dot_by_motor_alpha_r,
        motor_psi_x2_dot_by_motor_literal, motor_psi_y2_dot_by_motor_omega_0,
        motor_psi_y2_dot_by_motor_k_s, motor_psi_y2_dot_by_motor_alpha_r,
        motor_psi_y2_dot_by_motor_literal]
}

/// Partial derivative of `y'` with respect to time. 32 operations.
#[must_use]
pub fn time_derivative<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>) -> [R; STATES] {
    let [_, _, _, cylinder_omega, ..] = *state;
    let load_omega_2 = R::literal(0.104_719_755_119_659_77) * p.load_speed;
    let t0 = p.load_phase.add_product(R::literal(core::f64::consts::PI) * load_omega_2, time);
    let (t1, t2) = t0.sin_cos();
    let inverse_load_engagement_width = R::literal(1.0) / p.load_engagement_width;
    let t3 = inverse_load_engagement_width * (time - p.load_engagement_time);
    let t4 = R::literal(1.0) + (-t3).exp();
    let load_engagement = R::literal(1.0) / t4;
    let t5 = (R::literal(1.0) / p.load_standstill_band * cylinder_omega).tanh();
    let cylinder_omega_dot_by_time = (-(inverse_load_engagement_width * p.load_mean
        .add_product(p.load_amplitude, t1) * t5 / (t4 * (R::literal(1.0) + t3.exp()))))
        .add_product(R::literal(-3.141_592_653_589_793) * p.load_amplitude * load_omega_2
        * load_engagement * t2, t5) * (R::literal(1.0) / p.cylinder_inertia);
    [R::literal(0.0), R::literal(0.0), R::literal(0.0), cylinder_omega_dot_by_time,
        R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0)]
}

/// Wanted outputs. 42 operations.
#[must_use]
pub fn outputs<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>) -> Outputs<R> {
    let [motor_phi, cylinder_phi, motor_omega, cylinder_omega, motor_psi_x1, motor_psi_y1,
        motor_psi_x2, motor_psi_y2] = *state;
    let load_omega_2 = R::literal(0.104_719_755_119_659_77) * p.load_speed;
    let coupling_twist = motor_phi.sub_product(p.coupling_ratio, cylinder_phi);
    let coupling_twist_rate = motor_omega.sub_product(p.coupling_ratio, cylinder_omega);
    let load_engagement = R::literal(1.0) / (R::literal(1.0) + (R::literal(-1.0)
        / p.load_engagement_width * (time - p.load_engagement_time)).exp());
    let coupling_torque = (p.coupling_stiffness * coupling_twist).add_product(p.coupling_damping,
        coupling_twist_rate);
    let motor_torque = R::literal(1.5) * p.motor_omega_0 * p.motor_pole_pairs * p.motor_k_r
        / (p.motor_sigma * p.motor_x_s) * (motor_psi_y1 * motor_psi_x2).sub_product(motor_psi_x1,
        motor_psi_y2);
    let load_resistance = load_engagement * p.load_mean.add_product(p.load_amplitude, p.load_phase
        .add_product(R::literal(core::f64::consts::PI) * load_omega_2, time).sin())
        * (R::literal(1.0) / p.load_standstill_band * cylinder_omega).tanh();
    let cylinder_omega_dot = ((p.coupling_stiffness * p.coupling_ratio * coupling_twist)
        .add_product(p.coupling_damping * p.coupling_ratio, coupling_twist_rate) - load_resistance)
        * (R::literal(1.0) / p.cylinder_inertia);
    Outputs {
        motor_speed: motor_omega,
        cylinder_speed: cylinder_omega,
        motor_torque,
        coupling_torque,
        cylinder_acceleration: cylinder_omega_dot,
    }
}

/// T, V and the energy of first-order states \[J\]. 12 operations.
#[must_use]
pub fn energy<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>) -> Energy<R> {
    let [motor_phi, cylinder_phi, motor_omega, cylinder_omega, ..] = *state;
    let coupling_twist = motor_phi.sub_product(p.coupling_ratio, cylinder_phi);
    Energy {
        kinetic: (R::literal(0.5) * p.motor_inertia * (motor_omega * motor_omega))
            .add_product(R::literal(0.5) * p.cylinder_inertia, cylinder_omega * cylinder_omega),
        potential: R::literal(0.5) * p.coupling_stiffness * (coupling_twist * coupling_twist),
        stored: R::literal(0.0),
    }
}

/// `dE/dt`, power supplied and power dissipated \[W\]. 62 operations.
#[must_use]
pub fn power_balance<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>) -> PowerBalance<R> {
    let [motor_phi, cylinder_phi, motor_omega, cylinder_omega, motor_psi_x1, motor_psi_y1,
        motor_psi_x2, motor_psi_y2] = *state;
    let load_omega_2 = R::literal(0.104_719_755_119_659_77) * p.load_speed;
    let coupling_twist = motor_phi.sub_product(p.coupling_ratio, cylinder_phi);
    let coupling_twist_rate = motor_omega.sub_product(p.coupling_ratio, cylinder_omega);
    let load_engagement = R::literal(1.0) / (R::literal(1.0) + (R::literal(-1.0)
        / p.load_engagement_width * (time - p.load_engagement_time)).exp());
    let t0 = p.coupling_stiffness * coupling_twist;
    let coupling_torque = t0.add_product(p.coupling_damping, coupling_twist_rate);
    let motor_torque = R::literal(1.5) * p.motor_omega_0 * p.motor_pole_pairs * p.motor_k_r
        / (p.motor_sigma * p.motor_x_s) * (motor_psi_y1 * motor_psi_x2).sub_product(motor_psi_x1,
        motor_psi_y2);
    let load_resistance = load_engagement * p.load_mean.add_product(p.load_amplitude, p.load_phase
        .add_product(R::literal(core::f64::consts::PI) * load_omega_2, time).sin())
        * (R::literal(1.0) / p.load_standstill_band * cylinder_omega).tanh();
    let t1 = p.coupling_stiffness * p.coupling_ratio * coupling_twist;
    let t2 = p.coupling_damping * p.coupling_ratio;
    let cylinder_omega_dot = (t1.add_product(t2, coupling_twist_rate) - load_resistance)
        * (R::literal(1.0) / p.cylinder_inertia);
    let motor_omega_dot = (motor_torque - coupling_torque) * (R::literal(1.0) / p.motor_inertia);
    PowerBalance {
        stored_rate: (t0 * motor_omega).sub_product(t1, cylinder_omega).add_product(p.motor_inertia
            * motor_omega, motor_omega_dot).add_product(p.cylinder_inertia * cylinder_omega,
            cylinder_omega_dot),
        supplied: (motor_omega * motor_torque).sub_product(cylinder_omega, load_resistance),
        dissipated: (p.coupling_damping * motor_omega * coupling_twist_rate).sub_product(t2
            * cylinder_omega, coupling_twist_rate),
    }
}

/// Arguments of functions that are flat far from a place, such as `tanh` far from zero. Steps by
/// series are checked where one passes zero or turns. 2 operations.
#[must_use]
pub fn saturating_arguments<R: Real>(_time: R, state: &[R; STATES],
        p: &Parameters<R>) -> [R; SATURATIONS] {
    let [_, _, _, cylinder_omega, ..] = *state;
    let argument_1 = R::literal(1.0) / p.load_standstill_band * cylinder_omega;
    [argument_1]
}

/// Normalized Taylor coefficients of the solution through `state`, order after order.
///
/// `_k` marks the coefficient of order k, `_before` that of order k - 1; bare names are
/// zeroth coefficients. The workspace is as `series_workspace` says.
///
/// 125 recurrences. 9 sums of products an order.
///
/// # Panics
/// If there is no room for the zeroth coefficients, or the workspace is too short.
pub fn series<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>,
        coefficients: &mut [[R; STATES]], workspace: &mut [R]) {
    let (mut lanes, workspace) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let (mut lanes_1, workspace) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let (mut lanes_2, _) = Lanes::<R, 1>::new(workspace, coefficients.len());
    let [motor_phi, cylinder_phi, motor_omega, cylinder_omega, motor_psi_x1, motor_psi_y1,
        motor_psi_x2, motor_psi_y2] = *state;
    let load_omega_2 = R::literal(0.104_719_755_119_659_77) * p.load_speed;
    let t0 = cylinder_phi * p.coupling_ratio;
    let coupling_twist = motor_phi - t0;
    let t1 = cylinder_omega * p.coupling_ratio;
    let coupling_twist_rate = motor_omega - t1;
    let t2 = motor_phi * p.motor_literal;
    let t3 = R::literal(1.0) - p.motor_literal;
    let t4 = motor_omega * t3;
    let motor_rotor_term = t2 + t4;
    let t5 = time - p.load_engagement_time;
    let t6 = R::literal(-1.0) / p.load_engagement_width;
    let t7 = t5 * t6;
    let t8 = t7.exp();
    let t9 = R::literal(1.0) + t8;
    let load_engagement = R::literal(1.0) / t9;
    let t10 = coupling_twist * p.coupling_stiffness;
    let t11 = coupling_twist_rate * p.coupling_damping;
    let coupling_torque = t10 + t11;
    let t12 = motor_psi_x1 * motor_psi_y2;
    let t13 = motor_psi_y1 * motor_psi_x2;
    let t14 = t13 - t12;
    let t15 = R::literal(1.5) * p.motor_omega_0;
    let t16 = t15 * p.motor_pole_pairs;
    let t17 = t16 * p.motor_k_r;
    let t18 = p.motor_sigma * p.motor_x_s;
    let t19 = t17 / t18;
    let motor_torque = t14 * t19;
    let t20 = R::literal(core::f64::consts::PI) * load_omega_2;
    let t21 = time * t20;
    let t22 = p.load_phase + t21;
    let t23 = t22.sin();
    let t24 = t22.cos();
    let t25 = t23 * p.load_amplitude;
    let t26 = p.load_mean + t25;
    let t27 = R::literal(1.0) / p.load_standstill_band;
    let t28 = cylinder_omega * t27;
    let t29 = t28.tanh();
    let t30 = t29 * t29;
    let t31 = R::literal(1.0) - t30;
    let t32 = load_engagement * t26;
    let load_resistance = t32 * t29;
    let t33 = R::literal(1.0) / p.motor_inertia;
    let t34 = R::literal(1.0) / p.cylinder_inertia;
    let t35 = motor_torque - coupling_torque;
    let t36 = p.coupling_stiffness * p.coupling_ratio;
    let t37 = coupling_twist * t36;
    let t38 = p.coupling_damping * p.coupling_ratio;
    let t39 = coupling_twist_rate * t38;
    let t40 = t37 + t39;
    let t41 = t40 - load_resistance;
    let cylinder_omega_dot = t41 * t34;
    let motor_omega_dot = t35 * t33;
    let t42 = p.motor_omega_0 * p.motor_alpha_s;
    let t43 = motor_psi_x1 * t42;
    let t44 = motor_psi_y1 * p.motor_omega_0;
    let t45 = p.motor_omega_0 * p.motor_k_r;
    let t46 = t45 * p.motor_alpha_s;
    let t47 = motor_psi_x2 * t46;
    let t48 = p.motor_gamma.cos();
    let t49 = p.motor_u_m * t48;
    let t50 = t49 + t44;
    let t51 = t50 + t47;
    let motor_psi_x1_dot = t51 - t43;
    let t52 = motor_psi_x1 * p.motor_omega_0;
    let t53 = motor_psi_y1 * t42;
    let t54 = motor_psi_y2 * t46;
    let t55 = p.motor_gamma.sin();
    let t56 = p.motor_u_m * t55;
    let t57 = t56 + t54;
    let t58 = t57 - t52;
    let motor_psi_y1_dot = t58 - t53;
    let t59 = p.motor_omega_0 * p.motor_alpha_r;
    let t60 = motor_psi_x2 * t59;
    let t61 = motor_psi_y2 * motor_rotor_term;
    let t62 = p.motor_omega_0 * p.motor_k_s;
    let t63 = t62 * p.motor_alpha_r;
    let t64 = motor_psi_x1 * t63;
    let t65 = motor_psi_y2 * p.motor_omega_0;
    let t66 = t64 + t65;
    let t67 = t66 - t60;
    let motor_psi_x2_dot = t67 - t61;
    let t68 = motor_psi_x2 * p.motor_omega_0;
    let t69 = motor_psi_y2 * t59;
    let t70 = motor_psi_y1 * t63;
    let t71 = motor_psi_x2 * motor_rotor_term;
    let t72 = t70 + t71;
    let t73 = t72 - t68;
    let motor_psi_y2_dot = t73 - t69;
    let t7_slope = R::literal(1.0) * t6;
    let inverse_t9 = R::literal(1.0) / t9;
    let mut t8_before = t8;
    let mut t23_before = t23;
    let mut t24_before = t24;
    let mut rates = [motor_omega, cylinder_omega, motor_omega_dot, cylinder_omega_dot,
        motor_psi_x1_dot, motor_psi_y1_dot, motor_psi_x2_dot, motor_psi_y2_dot];
    coefficients[0] = *state;
    let highest = coefficients.len() - 1;
    for (order, state_k) in coefficients.iter_mut().enumerate().skip(1) {
        let (k, inverse) = order_and_inverse::<R>(order);
        *state_k = rates.map(|rate| rate * inverse);
        if order == highest {
            break;
        }
        let [motor_phi_k, cylinder_phi_k, motor_omega_k, cylinder_omega_k, motor_psi_x1_k,
            motor_psi_y1_k, motor_psi_x2_k, motor_psi_y2_k] = *state_k;
        let sums = lanes.sums(order);
        let sums_1 = lanes_1.sums(order);
        let sums_2 = lanes_2.sums(order);
        let coupling_twist_k = (-cylinder_phi_k).mul_add(p.coupling_ratio, motor_phi_k);
        let coupling_twist_rate_k = (-cylinder_omega_k).mul_add(p.coupling_ratio, motor_omega_k);
        let motor_rotor_term_k = motor_omega_k.mul_add(t3, motor_phi_k * p.motor_literal);
        let t8_k = inverse * t7_slope * t8_before;
        let load_engagement_k = -t8_k.mul_add(load_engagement, sums_1[1]) * inverse_t9;
        let coupling_torque_k = coupling_twist_rate_k.mul_add(p.coupling_damping, coupling_twist_k
            * p.coupling_stiffness);
        let t12_k = motor_psi_x1.mul_add(motor_psi_y2_k, motor_psi_y2.mul_add(motor_psi_x1_k,
            sums[0]));
        let t13_k = motor_psi_y1.mul_add(motor_psi_x2_k, motor_psi_x2.mul_add(motor_psi_y1_k,
            sums[1]));
        let t14_k = t13_k - t12_k;
        let t23_k = inverse * t20 * t24_before;
        let t24_k = -inverse * t20 * t23_before;
        let t28_k = cylinder_omega_k * t27;
        let t29_k = t28_k.mul_add(t31, inverse * sums_1[3]);
        let t30_k = (t29 + t29).mul_add(t29_k, sums[2]);
        let t31_k = -t30_k;
        let t32_k = load_engagement.mul_add(t23_k * p.load_amplitude, t26
            .mul_add(load_engagement_k, sums_1[2]));
        let load_resistance_k = t29.mul_add(t32_k, t32.mul_add(t29_k, sums_2[0]));
        let t35_k = t14_k.mul_add(t19, -coupling_torque_k);
        let t40_k = coupling_twist_rate_k.mul_add(t38, coupling_twist_k * t36);
        let t41_k = t40_k - load_resistance_k;
        let cylinder_omega_dot_k = t41_k * t34;
        let motor_omega_dot_k = t35_k * t33;
        let t51_k = motor_psi_x2_k.mul_add(t46, motor_psi_y1_k * p.motor_omega_0);
        let motor_psi_x1_dot_k = (-motor_psi_x1_k).mul_add(t42, t51_k);
        let t58_k = (-motor_psi_x1_k).mul_add(p.motor_omega_0, motor_psi_y2_k * t46);
        let motor_psi_y1_dot_k = (-motor_psi_y1_k).mul_add(t42, t58_k);
        let t61_k = motor_psi_y2.mul_add(motor_rotor_term_k, motor_rotor_term
            .mul_add(motor_psi_y2_k, sums[3]));
        let t66_k = motor_psi_y2_k.mul_add(p.motor_omega_0, motor_psi_x1_k * t63);
        let t67_k = (-motor_psi_x2_k).mul_add(t59, t66_k);
        let motor_psi_x2_dot_k = t67_k - t61_k;
        let t71_k = motor_psi_x2.mul_add(motor_rotor_term_k, motor_rotor_term
            .mul_add(motor_psi_x2_k, sums_1[0]));
        let t72_k = motor_psi_y1_k.mul_add(t63, t71_k);
        let t73_k = (-motor_psi_x2_k).mul_add(p.motor_omega_0, t72_k);
        let motor_psi_y2_dot_k = (-motor_psi_y2_k).mul_add(t59, t73_k);
        lanes.set(order, [motor_psi_x1_k, motor_psi_y1_k, t29_k, motor_rotor_term_k],
            [motor_psi_y2_k, motor_psi_x2_k, t29_k, motor_psi_y2_k]);
        lanes_1.set(order, [motor_rotor_term_k, t8_k, load_engagement_k, k * t28_k],
            [motor_psi_x2_k, load_engagement_k, t23_k * p.load_amplitude, t31_k]);
        lanes_2.set(order, [t29_k], [t32_k]);
        t8_before = t8_k;
        t23_before = t23_k;
        t24_before = t24_k;
        rates = [motor_omega_k, cylinder_omega_k, motor_omega_dot_k, cylinder_omega_dot_k,
            motor_psi_x1_dot_k, motor_psi_y1_dot_k, motor_psi_x2_dot_k, motor_psi_y2_dot_k];
    }
}

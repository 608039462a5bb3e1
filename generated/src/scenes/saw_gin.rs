// Emitted by Machinist 0.1.0; do not edit. To make it again:
//
//     cargo run --release -- gen
//
// Sources, with SHA-256:
//   33657ca8de87edac5530c71aa28608f076cfc4bf896071adbf4fe4322831e90b  scenes/saw_gin.toml
//   03bebde2dcd618fcbd0662a0f5e63f806e09d154c0fc25f1f0527c30944dd55e  units/textile/induction_motor.toml
//   512419e5aa73ad1710ef3556037050e97b898e87a7d5d8a4e9c4b03a7a8b0141  units/coupling.toml
//   ba9b76a100d91a8597c44349f557e301fa971bdcc9a7e0cf5da5ce4fd6af94b2  units/rotor.toml
//   02dd59962bd405d6a2dcac78b4101ca2138de7a376566a8d8c4460eb40293556  units/textile/technological_load.toml
//
// Saw gin: motor, coupling and saw cylinder
//
// The machine runs up without load. The technological load engages at 1.2 s and opposes motion.
//
// Source:
//   Saw-gin study (2020), equations (1) and (2), in their consistent reading.
//
// All quantities are in SI units.
// Shapes: coordinates 2, first-order states 4, states 7, parameters 21, outputs 8, discontinuities 1,
//     saturations 1.
// Nonzeros: mass_matrix 2 of 2 by 2, rate_jacobian 26 of 7 by 7, parameter_jacobian 39 of 7 by 21.
// Operations: discontinuities 6, rate 77, forcing 42, rate_jacobian 72, parameter_jacobian 179,
//     time_derivative 32, outputs 54, energy 39, power_balance 151, saturating_arguments 2,
//     prepare 64, prepared_rate 54, prepared_rate_jacobian 37, prepared_jacobians 155.

use ::machinist_contract::{
    Energy, PowerBalance, Real, taylor::{Lanes, order_and_inverse},
};

::machinist_contract::simulator! {
    /// Saw gin: motor, coupling and saw cylinder
    ///
    /// The machine runs up without load. The technological load engages at 1.2 s and opposes motion.
    ///
    /// Source: Saw-gin study (2020), equations (1) and (2), in their consistent reading.
    SawGin: "saw_gin", "Saw gin: motor, coupling and saw cylinder";
    run from 0.0, until 2.0, points 2001, rtol 1e-8, method "tsit5";
    quadratures 0, discontinuities 1;
    coordinates; prepared; jacobians_at_once; saturations 1; series 9;
}

::machinist_contract::parameters! {
    motor_inertia: 4.2, "kg m^2", "motor.inertia", "moment of inertia of the rotor";
    motor_phase_voltage: 220.0, "V", "motor.phase_voltage", "RMS phase voltage";
    motor_supply_frequency: 50.0, "Hz", "motor.supply_frequency", "supply frequency";
    motor_supply_phase: 0.0, "rad", "motor.supply_phase", "initial phase of the supply";
    motor_pole_pairs: 4.0, "1", "motor.pole_pairs", "pole pairs";
    motor_k_s: 0.956, "1", "motor.k_s", "stator coupling factor x_mu/x_s";
    motor_k_r: 0.952, "1", "motor.k_r", "rotor coupling factor x_mu/x_r";
    motor_x_s: 4.14, "ohm", "motor.x_s", "stator reactance at supply frequency";
    motor_alpha_s: 0.115, "1", "motor.alpha_s", "stator decay factor r_s/(sigma x_s)";
    motor_alpha_r: 0.0858, "1", "motor.alpha_r", "rotor decay factor r_r/(sigma x_r)";
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
    motor_torque: "N m", "motor_torque", "electromagnetic torque";
    coupling_torque: "N m", "coupling_torque", "torque at the driving end";
    load_torque: "N m", "load_torque", "resisting torque";
    twist: "rad", "twist", "twist";
    cylinder_acceleration: at_once "rad/s^2", "cylinder_acceleration", "rate of rate of angle";
    stator_current: "A", "stator_current", "amplitude of the stator current";
}

::machinist_contract::states! {
    COUPLING_TWIST: position, 1.0, "rad", "coupling.twist", "twist";
    MOTOR_OMEGA: velocity, 78.5, "rad/s", "motor.omega", "rate of rotor angle";
    CYLINDER_OMEGA: velocity, 78.5, "rad/s", "cylinder.omega", "rate of angle";
    MOTOR_PSI_SX: first_order, 1.0, "V s", "motor.psi_sx", "stator flux linkage along x";
    MOTOR_PSI_SY: first_order, 1.0, "V s", "motor.psi_sy", "stator flux linkage along y";
    MOTOR_PSI_RX: first_order, 1.0, "V s", "motor.psi_rx", "rotor flux linkage along x";
    MOTOR_PSI_RY: first_order, 1.0, "V s", "motor.psi_ry", "rotor flux linkage along y";
}

::machinist_contract::coordinates! {
    "motor.phi", "rad", "rotor angle";
    "cylinder.phi", "rad", "angle";
}

::machinist_contract::patterns! {
    /// Nonzeros of M.
    MASS_MATRIX_PATTERN: 2 by 2 { 0 [0] 1 [1] }
    /// Nonzeros of dy'/dy.
    RATE_JACOBIAN_PATTERN: 7 by 7 { 0 [1 2] 1 [0 1 2 3 4 5 6] 2 [0 1 2] 3 [3 4 5] 4 [3 4 6]
        5 [1 3 5 6] 6 [1 4 5 6] }
    /// Nonzeros of dy'/dp.
    PARAMETER_JACOBIAN_PATTERN: 7 by 21 { 0 [12] 1 [0 2 4 5 6 7 10 11 12]
        2 [10 11 12 13 14 15 16 17 18 19 20] 3 [1 2 3 6 8] 4 [1 2 3 6 8] 5 [2 4 5 9] 6 [2 4 5 9] }
}

::machinist_contract::constants! {
    motor_omega_0, motor_u_x, motor_u_y, t1, t3, t4, inverse_load_standstill_band,
    inverse_motor_inertia, inverse_cylinder_inertia, t5, t6, motor_alpha_s_times_motor_omega_0,
    motor_alpha_r_times_motor_omega_0, inverse_load_engagement_width,
    cylinder_omega_dot_by_coupling_twist, motor_omega_dot_by_coupling_twist,
    cylinder_omega_dot_by_motor_omega, motor_omega_dot_by_motor_omega, t7,
    motor_omega_dot_by_cylinder_omega, coupling_twist_dot_by_cylinder_omega,
    motor_psi_sx_dot_by_motor_psi_sx, motor_psi_sy_dot_by_motor_psi_sx,
    motor_psi_rx_dot_by_motor_psi_sx, motor_psi_sx_dot_by_motor_psi_rx,
    motor_psi_rx_dot_by_motor_psi_rx, t8, t9, t10, t11, t12, minus_motor_u_y, t13,
    motor_k_r_over_motor_sigma, t14, motor_k_s_over_motor_sigma, t15, t16, t17, t18,
    inverse_load_standstill_band_squared
}

/// Returns the constants of `rate` and its Jacobians from the parameters. 64 operations.
#[must_use]
#[inline]
pub fn prepare<R: Real>(p: &Parameters<R>) -> Constants<R> {
    let (sin_motor_supply_phase, cos_motor_supply_phase) = p.motor_supply_phase.sin_cos();
    let motor_omega_0 = R::literal(core::f64::consts::TAU) * p.motor_supply_frequency;
    let load_omega_2 = R::literal(0.104_719_755_119_659_77) * p.load_speed;
    let motor_sigma = R::literal(1.0).sub_product(p.motor_k_s, p.motor_k_r);
    let t0 = p.motor_phase_voltage * R::literal(core::f64::consts::SQRT_2);
    let motor_u_x = t0 * cos_motor_supply_phase;
    let motor_u_y = t0 * sin_motor_supply_phase;
    let t1 = R::literal(-1.0) / p.load_engagement_width;
    let motor_x_s_times_motor_sigma = p.motor_x_s * motor_sigma;
    let t2 = R::literal(1.5) * p.motor_pole_pairs;
    let t3 = t2 * p.motor_k_r * motor_omega_0 / motor_x_s_times_motor_sigma;
    let t4 = R::literal(core::f64::consts::PI) * load_omega_2;
    let inverse_load_standstill_band = R::literal(1.0) / p.load_standstill_band;
    let inverse_motor_inertia = R::literal(1.0) / p.motor_inertia;
    let inverse_cylinder_inertia = R::literal(1.0) / p.cylinder_inertia;
    let t5 = p.coupling_stiffness * p.coupling_ratio;
    let t6 = p.coupling_damping * p.coupling_ratio;
    let motor_alpha_s_times_motor_omega_0 = p.motor_alpha_s * motor_omega_0;
    let motor_alpha_r_times_motor_omega_0 = p.motor_alpha_r * motor_omega_0;
    let inverse_load_engagement_width = R::literal(1.0) / p.load_engagement_width;
    let cylinder_omega_dot_by_coupling_twist = t5 * inverse_cylinder_inertia;
    let motor_omega_dot_by_coupling_twist = -(p.coupling_stiffness * inverse_motor_inertia);
    let cylinder_omega_dot_by_motor_omega = t6 * inverse_cylinder_inertia;
    let motor_omega_dot_by_motor_omega = -(p.coupling_damping * inverse_motor_inertia);
    let t7 = p.coupling_damping * (p.coupling_ratio * p.coupling_ratio);
    let motor_omega_dot_by_cylinder_omega = t6 * inverse_motor_inertia;
    let coupling_twist_dot_by_cylinder_omega = -p.coupling_ratio;
    let motor_psi_sx_dot_by_motor_psi_sx = -motor_alpha_s_times_motor_omega_0;
    let motor_psi_sy_dot_by_motor_psi_sx = -motor_omega_0;
    let motor_psi_rx_dot_by_motor_psi_sx = p.motor_k_s * p.motor_alpha_r * motor_omega_0;
    let motor_psi_sx_dot_by_motor_psi_rx = p.motor_k_r * p.motor_alpha_s * motor_omega_0;
    let motor_psi_rx_dot_by_motor_psi_rx = -motor_alpha_r_times_motor_omega_0;
    let t8 = R::literal(core::f64::consts::SQRT_2) * cos_motor_supply_phase;
    let t9 = R::literal(core::f64::consts::SQRT_2) * sin_motor_supply_phase;
    let t10 = R::literal(3.0 * core::f64::consts::PI) * p.motor_pole_pairs * p.motor_k_r
        / motor_x_s_times_motor_sigma;
    let t11 = R::literal(core::f64::consts::TAU) * p.motor_alpha_s;
    let t12 = R::literal(core::f64::consts::TAU) * p.motor_alpha_r;
    let minus_motor_u_y = -motor_u_y;
    let t13 = R::literal(1.5) * p.motor_k_r * motor_omega_0 / motor_x_s_times_motor_sigma;
    let motor_k_r_over_motor_sigma = p.motor_k_r / motor_sigma;
    let t14 = t2 * motor_omega_0 / motor_x_s_times_motor_sigma;
    let motor_k_s_over_motor_sigma = p.motor_k_s / motor_sigma;
    let t15 = R::literal(-1.0) / p.motor_x_s;
    let t16 = R::literal(2.0) * p.coupling_damping * p.coupling_ratio;
    let t17 = R::literal(-0.328_986_813_369_645_25) * p.load_amplitude;
    let t18 = R::literal(1.0) / (p.load_engagement_width * p.load_engagement_width);
    let inverse_load_standstill_band_squared = R::literal(1.0) / (p.load_standstill_band
        * p.load_standstill_band);
    Constants { motor_omega_0, motor_u_x, motor_u_y, t1, t3, t4, inverse_load_standstill_band,
        inverse_motor_inertia, inverse_cylinder_inertia, t5, t6, motor_alpha_s_times_motor_omega_0,
        motor_alpha_r_times_motor_omega_0, inverse_load_engagement_width,
        cylinder_omega_dot_by_coupling_twist, motor_omega_dot_by_coupling_twist,
        cylinder_omega_dot_by_motor_omega, motor_omega_dot_by_motor_omega, t7,
        motor_omega_dot_by_cylinder_omega, coupling_twist_dot_by_cylinder_omega,
        motor_psi_sx_dot_by_motor_psi_sx, motor_psi_sy_dot_by_motor_psi_sx,
        motor_psi_rx_dot_by_motor_psi_sx, motor_psi_sx_dot_by_motor_psi_rx,
        motor_psi_rx_dot_by_motor_psi_rx, t8, t9, t10, t11, t12, minus_motor_u_y, t13,
        motor_k_r_over_motor_sigma, t14, motor_k_s_over_motor_sigma, t15, t16, t17, t18,
        inverse_load_standstill_band_squared }
}

/// State at the start of the run, in the units of the states. No operations.
#[must_use]
pub fn initial_state<R: Real>(_p: &Parameters<R>) -> [R; STATES] {
    [R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0),
        R::literal(0.0), R::literal(0.0)]
}

/// Times of known jumps of the right-hand side \[s\], unsorted. 6 operations.
#[must_use]
pub fn discontinuities<R: Real>(p: &Parameters<R>) -> [R; DISCONTINUITIES] {
    let inverse_load_engagement_width = R::literal(1.0) / p.load_engagement_width;
    let abs_inverse_load_engagement_width = inverse_load_engagement_width.abs();
    [R::select_less(R::literal(50.0), abs_inverse_load_engagement_width,
        R::select_less(R::literal(0.0), abs_inverse_load_engagement_width,
        inverse_load_engagement_width * p.load_engagement_time / inverse_load_engagement_width,
        R::literal(0.0)), R::literal(0.0))]
}

/// As `rate`, with the constants of the parameters from `prepare`. 54 operations.
#[must_use]
#[inline]
pub fn prepared_rate<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>,
        c: &Constants<R>) -> [R; STATES] {
    let [coupling_twist, motor_omega, cylinder_omega, motor_psi_sx, motor_psi_sy, motor_psi_rx,
        motor_psi_ry] = *state;
    let coupling_twist_rate = motor_omega.sub_product(p.coupling_ratio, cylinder_omega);
    let motor_slip_speed = c.motor_omega_0.sub_product(p.motor_pole_pairs, motor_omega);
    let coupling_torque = (p.coupling_stiffness * coupling_twist).add_product(p.coupling_damping,
        coupling_twist_rate);
    let load_engagement = R::literal(1.0) / (R::literal(1.0)
        + (c.t1 * (time - p.load_engagement_time)).exp());
    let motor_torque = c.t3 * (motor_psi_sy * motor_psi_rx).sub_product(motor_psi_sx, motor_psi_ry);
    let load_resistance = load_engagement * p.load_mean.add_product(p.load_amplitude, p.load_phase
        .add_product(c.t4, time).sin()) * (c.inverse_load_standstill_band * cylinder_omega).tanh();
    let cylinder_omega_dot = ((c.t5 * coupling_twist).add_product(c.t6, coupling_twist_rate)
        - load_resistance) * c.inverse_cylinder_inertia;
    let motor_omega_dot = (motor_torque - coupling_torque) * c.inverse_motor_inertia;
    let motor_psi_sx_dot = c.motor_u_x.add_product(c.motor_omega_0, motor_psi_sy)
        .sub_product(c.motor_alpha_s_times_motor_omega_0, motor_psi_sx.sub_product(p.motor_k_r,
        motor_psi_rx));
    let motor_psi_sy_dot = c.motor_u_y.sub_product(c.motor_omega_0, motor_psi_sx)
        .sub_product(c.motor_alpha_s_times_motor_omega_0, motor_psi_sy.sub_product(p.motor_k_r,
        motor_psi_ry));
    let motor_psi_rx_dot = (motor_psi_ry * motor_slip_speed)
        .add_product(c.motor_alpha_r_times_motor_omega_0, (-motor_psi_rx).add_product(p.motor_k_s,
        motor_psi_sx));
    let motor_psi_ry_dot = (c.motor_alpha_r_times_motor_omega_0 * (-motor_psi_ry)
        .add_product(p.motor_k_s, motor_psi_sy)).sub_product(motor_psi_rx, motor_slip_speed);
    [coupling_twist_rate, motor_omega_dot, cylinder_omega_dot, motor_psi_sx_dot, motor_psi_sy_dot,
        motor_psi_rx_dot, motor_psi_ry_dot]
}

/// `M = d2L/dq'2`, values in the order of its pattern. No operations.
#[must_use]
pub fn mass_matrix<R: Real>(_time: R, _state: &[R; STATES], p: &Parameters<R>) -> [R; 2] {
    [p.motor_inertia, p.cylinder_inertia]
}

/// `f` of `M q'' = f + G^T lambda`, one for each coordinate. 42 operations.
#[must_use]
pub fn forcing<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>) -> [R; COORDINATES] {
    let [coupling_twist, motor_omega, cylinder_omega, motor_psi_sx, motor_psi_sy, motor_psi_rx,
        motor_psi_ry] = *state;
    let motor_omega_0 = R::literal(core::f64::consts::TAU) * p.motor_supply_frequency;
    let load_omega_2 = R::literal(0.104_719_755_119_659_77) * p.load_speed;
    let motor_sigma = R::literal(1.0).sub_product(p.motor_k_s, p.motor_k_r);
    let coupling_twist_rate = motor_omega.sub_product(p.coupling_ratio, cylinder_omega);
    let coupling_torque = (p.coupling_stiffness * coupling_twist).add_product(p.coupling_damping,
        coupling_twist_rate);
    let load_engagement = R::literal(1.0) / (R::literal(1.0) + (R::literal(-1.0)
        / p.load_engagement_width * (time - p.load_engagement_time)).exp());
    let motor_torque = R::literal(1.5) * p.motor_pole_pairs * p.motor_k_r * motor_omega_0
        / (p.motor_x_s * motor_sigma) * (motor_psi_sy * motor_psi_rx).sub_product(motor_psi_sx,
        motor_psi_ry);
    let load_resistance = load_engagement * p.load_mean.add_product(p.load_amplitude, p.load_phase
        .add_product(R::literal(core::f64::consts::PI) * load_omega_2, time).sin())
        * (R::literal(1.0) / p.load_standstill_band * cylinder_omega).tanh();
    let motor_phi_forcing = motor_torque - coupling_torque;
    let cylinder_phi_forcing = (p.coupling_stiffness * p.coupling_ratio * coupling_twist)
        .add_product(p.coupling_damping * p.coupling_ratio, coupling_twist_rate) - load_resistance;
    [motor_phi_forcing, cylinder_phi_forcing]
}

/// As `rate_jacobian`, with the constants of the parameters from `prepare`. 37 operations.
#[must_use]
pub fn prepared_rate_jacobian<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>,
        c: &Constants<R>) -> [R; 26] {
    let [_, motor_omega, cylinder_omega, motor_psi_sx, motor_psi_sy, motor_psi_rx, motor_psi_ry]
        = *state;
    let motor_pole_pairs_times_motor_omega = p.motor_pole_pairs * motor_omega;
    let motor_slip_speed = c.motor_omega_0 - motor_pole_pairs_times_motor_omega;
    let load_engagement = R::literal(1.0) / (R::literal(1.0) + (-(c.inverse_load_engagement_width
        * (time - p.load_engagement_time))).exp());
    let t0 = (c.inverse_load_standstill_band * cylinder_omega).tanh();
    let motor_psi_rx_dot_by_motor_omega = -(p.motor_pole_pairs * motor_psi_ry);
    let motor_psi_ry_dot_by_motor_omega = p.motor_pole_pairs * motor_psi_rx;
    let cylinder_omega_dot_by_cylinder_omega = -(c.t7.add_product(c.inverse_load_standstill_band
        * load_engagement * R::literal(1.0).sub_product(t0, t0), p.load_mean
        .add_product(p.load_amplitude, p.load_phase.add_product(c.t4, time).sin()))
        * c.inverse_cylinder_inertia);
    let motor_omega_dot_by_motor_psi_sx = -(c.t3 * motor_psi_ry * c.inverse_motor_inertia);
    let motor_omega_dot_by_motor_psi_sy = c.t3 * motor_psi_rx * c.inverse_motor_inertia;
    let motor_omega_dot_by_motor_psi_rx = c.t3 * motor_psi_sy * c.inverse_motor_inertia;
    let motor_psi_ry_dot_by_motor_psi_rx = motor_pole_pairs_times_motor_omega - c.motor_omega_0;
    let motor_omega_dot_by_motor_psi_ry = -(c.t3 * motor_psi_sx * c.inverse_motor_inertia);
    [R::literal(1.0), c.coupling_twist_dot_by_cylinder_omega, c.motor_omega_dot_by_coupling_twist,
        c.motor_omega_dot_by_motor_omega, c.motor_omega_dot_by_cylinder_omega,
        motor_omega_dot_by_motor_psi_sx, motor_omega_dot_by_motor_psi_sy,
        motor_omega_dot_by_motor_psi_rx, motor_omega_dot_by_motor_psi_ry,
        c.cylinder_omega_dot_by_coupling_twist, c.cylinder_omega_dot_by_motor_omega,
        cylinder_omega_dot_by_cylinder_omega, c.motor_psi_sx_dot_by_motor_psi_sx, c.motor_omega_0,
        c.motor_psi_sx_dot_by_motor_psi_rx, c.motor_psi_sy_dot_by_motor_psi_sx,
        c.motor_psi_sx_dot_by_motor_psi_sx, c.motor_psi_sx_dot_by_motor_psi_rx,
        motor_psi_rx_dot_by_motor_omega, c.motor_psi_rx_dot_by_motor_psi_sx,
        c.motor_psi_rx_dot_by_motor_psi_rx, motor_slip_speed, motor_psi_ry_dot_by_motor_omega,
        c.motor_psi_rx_dot_by_motor_psi_sx, motor_psi_ry_dot_by_motor_psi_rx,
        c.motor_psi_rx_dot_by_motor_psi_rx]
}

/// `rate_jacobian`, then `parameter_jacobian`, with the constants of the parameters from `prepare`.
/// 155 operations.
#[must_use]
pub fn prepared_jacobians<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>,
        c: &Constants<R>) -> [R; 65] {
    let [coupling_twist, motor_omega, cylinder_omega, motor_psi_sx, motor_psi_sy, motor_psi_rx,
        motor_psi_ry] = *state;
    let t0 = p.load_phase.add_product(c.t4, time);
    let (t1, t2) = t0.sin_cos();
    let motor_pole_pairs_times_motor_omega = p.motor_pole_pairs * motor_omega;
    let motor_slip_speed = c.motor_omega_0 - motor_pole_pairs_times_motor_omega;
    let time_minus_load_engagement_time = time - p.load_engagement_time;
    let t3 = c.inverse_load_engagement_width * time_minus_load_engagement_time;
    let t4 = R::literal(1.0) + (-t3).exp();
    let load_engagement = R::literal(1.0) / t4;
    let t5 = p.load_mean.add_product(p.load_amplitude, t1);
    let t6 = (c.inverse_load_standstill_band * cylinder_omega).tanh();
    let motor_psi_rx_dot_by_motor_omega = -(p.motor_pole_pairs * motor_psi_ry);
    let motor_psi_ry_dot_by_motor_omega = p.motor_pole_pairs * motor_psi_rx;
    let t7 = R::literal(1.0).sub_product(t6, t6);
    let cylinder_omega_dot_by_cylinder_omega = -(c.t7.add_product(c.inverse_load_standstill_band
        * load_engagement * t7, t5) * c.inverse_cylinder_inertia);
    let motor_omega_dot_by_motor_psi_sx = -(c.t3 * motor_psi_ry * c.inverse_motor_inertia);
    let motor_omega_dot_by_motor_psi_sy = c.t3 * motor_psi_rx * c.inverse_motor_inertia;
    let motor_omega_dot_by_motor_psi_rx = c.t3 * motor_psi_sy * c.inverse_motor_inertia;
    let motor_psi_ry_dot_by_motor_psi_rx = motor_pole_pairs_times_motor_omega - c.motor_omega_0;
    let motor_omega_dot_by_motor_psi_ry = -(c.t3 * motor_psi_sx * c.inverse_motor_inertia);
    let coupling_ratio_times_cylinder_omega = p.coupling_ratio * cylinder_omega;
    let coupling_twist_rate = motor_omega - coupling_ratio_times_cylinder_omega;
    let t8 = p.coupling_stiffness * coupling_twist;
    let coupling_torque = t8.add_product(p.coupling_damping, coupling_twist_rate);
    let t9 = motor_psi_sx.sub_product(p.motor_k_r, motor_psi_rx);
    let t10 = motor_psi_sy.sub_product(p.motor_k_r, motor_psi_ry);
    let t11 = (motor_psi_sy * motor_psi_rx).sub_product(motor_psi_sx, motor_psi_ry);
    let motor_torque = c.t3 * t11;
    let load_resistance = load_engagement * t5 * t6;
    let cylinder_omega_dot = ((c.t5 * coupling_twist).add_product(c.t6, coupling_twist_rate)
        - load_resistance) * c.inverse_cylinder_inertia;
    let motor_omega_dot = (motor_torque - coupling_torque) * c.inverse_motor_inertia;
    let t12 = (-motor_psi_rx).add_product(p.motor_k_s, motor_psi_sx);
    let t13 = (-motor_psi_ry).add_product(p.motor_k_s, motor_psi_sy);
    let motor_omega_dot_by_motor_inertia = -(motor_omega_dot * c.inverse_motor_inertia);
    let motor_omega_dot_by_motor_supply_frequency = c.t10 * t11 * c.inverse_motor_inertia;
    let motor_psi_sx_dot_by_motor_supply_frequency = (R::literal(core::f64::consts::TAU)
        * motor_psi_sy).sub_product(c.t11, t9);
    let motor_psi_sy_dot_by_motor_supply_frequency = (R::literal(-6.283_185_307_179_586)
        * motor_psi_sx).sub_product(c.t11, t10);
    let motor_psi_rx_dot_by_motor_supply_frequency = (R::literal(core::f64::consts::TAU)
        * motor_psi_ry).add_product(c.t12, t12);
    let motor_psi_ry_dot_by_motor_supply_frequency = (R::literal(-6.283_185_307_179_586)
        * motor_psi_rx).add_product(c.t12, t13);
    let motor_omega_dot_by_motor_pole_pairs = c.t13 * t11 * c.inverse_motor_inertia;
    let motor_psi_rx_dot_by_motor_pole_pairs = -(motor_omega * motor_psi_ry);
    let motor_psi_ry_dot_by_motor_pole_pairs = motor_omega * motor_psi_rx;
    let motor_omega_dot_by_motor_k_s = c.motor_k_r_over_motor_sigma * motor_torque
        * c.inverse_motor_inertia;
    let motor_psi_rx_dot_by_motor_k_s = c.motor_alpha_r_times_motor_omega_0 * motor_psi_sx;
    let motor_psi_ry_dot_by_motor_k_s = c.motor_alpha_r_times_motor_omega_0 * motor_psi_sy;
    let motor_omega_dot_by_motor_k_r = (c.t14 * t11).add_product(c.motor_k_s_over_motor_sigma,
        motor_torque) * c.inverse_motor_inertia;
    let motor_psi_sx_dot_by_motor_k_r = c.motor_alpha_s_times_motor_omega_0 * motor_psi_rx;
    let motor_psi_sy_dot_by_motor_k_r = c.motor_alpha_s_times_motor_omega_0 * motor_psi_ry;
    let motor_omega_dot_by_motor_x_s = c.t15 * motor_torque * c.inverse_motor_inertia;
    let motor_psi_sx_dot_by_motor_alpha_s = -(c.motor_omega_0 * t9);
    let motor_psi_sy_dot_by_motor_alpha_s = -(c.motor_omega_0 * t10);
    let motor_psi_rx_dot_by_motor_alpha_r = c.motor_omega_0 * t12;
    let motor_psi_ry_dot_by_motor_alpha_r = c.motor_omega_0 * t13;
    let cylinder_omega_dot_by_coupling_stiffness = p.coupling_ratio * coupling_twist
        * c.inverse_cylinder_inertia;
    let motor_omega_dot_by_coupling_stiffness = -(coupling_twist * c.inverse_motor_inertia);
    let cylinder_omega_dot_by_coupling_damping = p.coupling_ratio * coupling_twist_rate
        * c.inverse_cylinder_inertia;
    let motor_omega_dot_by_coupling_damping = (coupling_ratio_times_cylinder_omega - motor_omega)
        * c.inverse_motor_inertia;
    let cylinder_omega_dot_by_coupling_ratio = t8.add_product(p.coupling_damping, motor_omega)
        .sub_product(c.t16, cylinder_omega) * c.inverse_cylinder_inertia;
    let motor_omega_dot_by_coupling_ratio = p.coupling_damping * cylinder_omega
        * c.inverse_motor_inertia;
    let coupling_twist_dot_by_coupling_ratio = -cylinder_omega;
    let cylinder_omega_dot_by_cylinder_inertia = -(cylinder_omega_dot * c.inverse_cylinder_inertia);
    let cylinder_omega_dot_by_load_mean = -(load_engagement * t6 * c.inverse_cylinder_inertia);
    let cylinder_omega_dot_by_load_amplitude = -(load_engagement * t1 * t6
        * c.inverse_cylinder_inertia);
    let cylinder_omega_dot_by_load_speed = c.t17 * time * load_engagement * t2 * t6
        * c.inverse_cylinder_inertia;
    let cylinder_omega_dot_by_load_phase = -(p.load_amplitude * load_engagement * t2 * t6
        * c.inverse_cylinder_inertia);
    let t14 = t4 * (R::literal(1.0) + t3.exp());
    let cylinder_omega_dot_by_load_engagement_time = c.inverse_load_engagement_width * t5 * t6
        / t14 * c.inverse_cylinder_inertia;
    let cylinder_omega_dot_by_load_engagement_width = c.t18 * time_minus_load_engagement_time * t5
        * t6 / t14 * c.inverse_cylinder_inertia;
    let cylinder_omega_dot_by_load_standstill_band = c.inverse_load_standstill_band_squared
        * cylinder_omega * load_engagement * t7 * t5 * c.inverse_cylinder_inertia;
    [R::literal(1.0), c.coupling_twist_dot_by_cylinder_omega, c.motor_omega_dot_by_coupling_twist,
        c.motor_omega_dot_by_motor_omega, c.motor_omega_dot_by_cylinder_omega,
        motor_omega_dot_by_motor_psi_sx, motor_omega_dot_by_motor_psi_sy,
        motor_omega_dot_by_motor_psi_rx, motor_omega_dot_by_motor_psi_ry,
        c.cylinder_omega_dot_by_coupling_twist, c.cylinder_omega_dot_by_motor_omega,
        cylinder_omega_dot_by_cylinder_omega, c.motor_psi_sx_dot_by_motor_psi_sx, c.motor_omega_0,
        c.motor_psi_sx_dot_by_motor_psi_rx, c.motor_psi_sy_dot_by_motor_psi_sx,
        c.motor_psi_sx_dot_by_motor_psi_sx, c.motor_psi_sx_dot_by_motor_psi_rx,
        motor_psi_rx_dot_by_motor_omega, c.motor_psi_rx_dot_by_motor_psi_sx,
        c.motor_psi_rx_dot_by_motor_psi_rx, motor_slip_speed, motor_psi_ry_dot_by_motor_omega,
        c.motor_psi_rx_dot_by_motor_psi_sx, motor_psi_ry_dot_by_motor_psi_rx,
        c.motor_psi_rx_dot_by_motor_psi_rx, coupling_twist_dot_by_coupling_ratio,
        motor_omega_dot_by_motor_inertia, motor_omega_dot_by_motor_supply_frequency,
        motor_omega_dot_by_motor_pole_pairs, motor_omega_dot_by_motor_k_s,
        motor_omega_dot_by_motor_k_r, motor_omega_dot_by_motor_x_s,
        motor_omega_dot_by_coupling_stiffness, motor_omega_dot_by_coupling_damping,
        motor_omega_dot_by_coupling_ratio, cylinder_omega_dot_by_coupling_stiffness,
        cylinder_omega_dot_by_coupling_damping, cylinder_omega_dot_by_coupling_ratio,
        cylinder_omega_dot_by_cylinder_inertia, cylinder_omega_dot_by_load_mean,
        cylinder_omega_dot_by_load_amplitude, cylinder_omega_dot_by_load_speed,
        cylinder_omega_dot_by_load_phase, cylinder_omega_dot_by_load_engagement_time,
        cylinder_omega_dot_by_load_engagement_width, cylinder_omega_dot_by_load_standstill_band,
        c.t8, motor_psi_sx_dot_by_motor_supply_frequency, c.minus_motor_u_y,
        motor_psi_sx_dot_by_motor_k_r, motor_psi_sx_dot_by_motor_alpha_s, c.t9,
        motor_psi_sy_dot_by_motor_supply_frequency, c.motor_u_x, motor_psi_sy_dot_by_motor_k_r,
        motor_psi_sy_dot_by_motor_alpha_s, motor_psi_rx_dot_by_motor_supply_frequency,
        motor_psi_rx_dot_by_motor_pole_pairs, motor_psi_rx_dot_by_motor_k_s,
        motor_psi_rx_dot_by_motor_alpha_r, motor_psi_ry_dot_by_motor_supply_frequency,
        motor_psi_ry_dot_by_motor_pole_pairs, motor_psi_ry_dot_by_motor_k_s,
        motor_psi_ry_dot_by_motor_alpha_r]
}

/// Partial derivative of `y'` with respect to time. 32 operations.
#[must_use]
pub fn time_derivative<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>) -> [R; STATES] {
    let [_, _, cylinder_omega, ..] = *state;
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
    [R::literal(0.0), R::literal(0.0), cylinder_omega_dot_by_time, R::literal(0.0),
        R::literal(0.0), R::literal(0.0), R::literal(0.0)]
}

/// Wanted outputs. 54 operations.
#[must_use]
pub fn outputs<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>) -> Outputs<R> {
    let [coupling_twist, motor_omega, cylinder_omega, motor_psi_sx, motor_psi_sy, motor_psi_rx,
        motor_psi_ry] = *state;
    let motor_omega_0 = R::literal(core::f64::consts::TAU) * p.motor_supply_frequency;
    let load_omega_2 = R::literal(0.104_719_755_119_659_77) * p.load_speed;
    let motor_sigma = R::literal(1.0).sub_product(p.motor_k_s, p.motor_k_r);
    let coupling_twist_rate = motor_omega.sub_product(p.coupling_ratio, cylinder_omega);
    let coupling_torque = (p.coupling_stiffness * coupling_twist).add_product(p.coupling_damping,
        coupling_twist_rate);
    let load_engagement = R::literal(1.0) / (R::literal(1.0) + (R::literal(-1.0)
        / p.load_engagement_width * (time - p.load_engagement_time)).exp());
    let motor_x_s_times_motor_sigma = p.motor_x_s * motor_sigma;
    let t0 = motor_omega_0 / motor_x_s_times_motor_sigma;
    let motor_i_sx = t0 * motor_psi_sx.sub_product(p.motor_k_r, motor_psi_rx);
    let motor_i_sy = t0 * motor_psi_sy.sub_product(p.motor_k_r, motor_psi_ry);
    let motor_torque = R::literal(1.5) * p.motor_pole_pairs * p.motor_k_r * motor_omega_0
        / motor_x_s_times_motor_sigma * (motor_psi_sy * motor_psi_rx).sub_product(motor_psi_sx,
        motor_psi_ry);
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
        load_torque: load_resistance,
        twist: coupling_twist,
        cylinder_acceleration: cylinder_omega_dot,
        stator_current: (motor_i_sx * motor_i_sx).add_product(motor_i_sy, motor_i_sy).sqrt(),
    }
}

/// T, V and the energy of first-order states \[J\]. 39 operations.
#[must_use]
pub fn energy<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>) -> Energy<R> {
    let [coupling_twist, motor_omega, cylinder_omega, motor_psi_sx, motor_psi_sy, motor_psi_rx,
        motor_psi_ry] = *state;
    let motor_omega_0 = R::literal(core::f64::consts::TAU) * p.motor_supply_frequency;
    let motor_sigma = R::literal(1.0).sub_product(p.motor_k_s, p.motor_k_r);
    let motor_x_r = p.motor_k_s * p.motor_x_s / p.motor_k_r;
    let t0 = motor_omega_0 / (p.motor_x_s * motor_sigma);
    let motor_i_sx = t0 * motor_psi_sx.sub_product(p.motor_k_r, motor_psi_rx);
    let motor_i_sy = t0 * motor_psi_sy.sub_product(p.motor_k_r, motor_psi_ry);
    let t1 = motor_omega_0 / (motor_sigma * motor_x_r);
    let motor_i_rx = t1 * motor_psi_rx.sub_product(p.motor_k_s, motor_psi_sx);
    let motor_i_ry = t1 * motor_psi_ry.sub_product(p.motor_k_s, motor_psi_sy);
    Energy {
        kinetic: (R::literal(0.5) * p.motor_inertia * (motor_omega * motor_omega))
            .add_product(R::literal(0.5) * p.cylinder_inertia, cylinder_omega * cylinder_omega),
        potential: R::literal(0.5) * p.coupling_stiffness * (coupling_twist * coupling_twist),
        stored: R::literal(0.75) * (motor_psi_sx * motor_i_sx).add_product(motor_psi_sy, motor_i_sy)
            .add_product(motor_psi_rx, motor_i_rx).add_product(motor_psi_ry, motor_i_ry),
    }
}

/// `dE/dt`, power supplied and power dissipated \[W\]. 151 operations.
#[must_use]
pub fn power_balance<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>) -> PowerBalance<R> {
    let [coupling_twist, motor_omega, cylinder_omega, motor_psi_sx, motor_psi_sy, motor_psi_rx,
        motor_psi_ry] = *state;
    let load_omega_2 = R::literal(0.104_719_755_119_659_77) * p.load_speed;
    let [(sin_motor_supply_phase, cos_motor_supply_phase), (t0, _)]
        = R::sin_cos_each([p.motor_supply_phase,
        p.load_phase.add_product(R::literal(core::f64::consts::PI) * load_omega_2, time)]);
    let motor_omega_0 = R::literal(core::f64::consts::TAU) * p.motor_supply_frequency;
    let motor_sigma = R::literal(1.0).sub_product(p.motor_k_s, p.motor_k_r);
    let motor_x_r = p.motor_k_s * p.motor_x_s / p.motor_k_r;
    let t1 = p.motor_phase_voltage * R::literal(core::f64::consts::SQRT_2);
    let motor_u_x = t1 * cos_motor_supply_phase;
    let motor_u_y = t1 * sin_motor_supply_phase;
    let coupling_twist_rate = motor_omega.sub_product(p.coupling_ratio, cylinder_omega);
    let motor_slip_speed = motor_omega_0.sub_product(p.motor_pole_pairs, motor_omega);
    let t2 = p.coupling_stiffness * coupling_twist;
    let coupling_torque = t2.add_product(p.coupling_damping, coupling_twist_rate);
    let load_engagement = R::literal(1.0) / (R::literal(1.0) + (R::literal(-1.0)
        / p.load_engagement_width * (time - p.load_engagement_time)).exp());
    let t3 = motor_psi_sx.sub_product(p.motor_k_r, motor_psi_rx);
    let motor_x_s_times_motor_sigma = p.motor_x_s * motor_sigma;
    let t4 = motor_omega_0 / motor_x_s_times_motor_sigma;
    let motor_i_sx = t4 * t3;
    let t5 = motor_psi_sy.sub_product(p.motor_k_r, motor_psi_ry);
    let motor_i_sy = t4 * t5;
    let motor_k_s_times_motor_psi_sx = p.motor_k_s * motor_psi_sx;
    let t6 = motor_omega_0 / (motor_sigma * motor_x_r);
    let motor_i_rx = t6 * (motor_psi_rx - motor_k_s_times_motor_psi_sx);
    let motor_k_s_times_motor_psi_sy = p.motor_k_s * motor_psi_sy;
    let motor_i_ry = t6 * (motor_psi_ry - motor_k_s_times_motor_psi_sy);
    let motor_torque = R::literal(1.5) * p.motor_pole_pairs * p.motor_k_r * motor_omega_0
        / motor_x_s_times_motor_sigma * (motor_psi_sy * motor_psi_rx).sub_product(motor_psi_sx,
        motor_psi_ry);
    let load_resistance = load_engagement * p.load_mean.add_product(p.load_amplitude, t0)
        * (R::literal(1.0) / p.load_standstill_band * cylinder_omega).tanh();
    let t7 = p.coupling_damping * p.coupling_ratio;
    let cylinder_omega_dot = ((p.coupling_stiffness * p.coupling_ratio * coupling_twist)
        .add_product(t7, coupling_twist_rate) - load_resistance) * (R::literal(1.0)
        / p.cylinder_inertia);
    let motor_omega_dot = (motor_torque - coupling_torque) * (R::literal(1.0) / p.motor_inertia);
    let motor_alpha_s_times_motor_omega_0 = p.motor_alpha_s * motor_omega_0;
    let motor_psi_sx_dot = motor_u_x.add_product(motor_omega_0, motor_psi_sy)
        .sub_product(motor_alpha_s_times_motor_omega_0, t3);
    let motor_psi_sy_dot = motor_u_y.sub_product(motor_omega_0, motor_psi_sx)
        .sub_product(motor_alpha_s_times_motor_omega_0, t5);
    let motor_alpha_r_times_motor_omega_0 = p.motor_alpha_r * motor_omega_0;
    let motor_psi_rx_dot = (motor_psi_ry * motor_slip_speed)
        .add_product(motor_alpha_r_times_motor_omega_0, motor_k_s_times_motor_psi_sx
        - motor_psi_rx);
    let motor_psi_ry_dot = (motor_alpha_r_times_motor_omega_0 * (motor_k_s_times_motor_psi_sy
        - motor_psi_ry)).sub_product(motor_psi_rx, motor_slip_speed);
    let t8 = p.motor_k_r * motor_omega_0 / motor_x_s_times_motor_sigma;
    PowerBalance {
        stored_rate: (t2 * coupling_twist_rate).add_product(p.motor_inertia * motor_omega,
            motor_omega_dot).add_product(p.cylinder_inertia * cylinder_omega, cylinder_omega_dot)
            .add_product(R::literal(0.75) * motor_i_sx.add_product(t4, motor_psi_sx)
            .sub_product(t8, motor_psi_rx), motor_psi_sx_dot).add_product(R::literal(0.75)
            * motor_i_sy.add_product(t4, motor_psi_sy).sub_product(t8, motor_psi_ry),
            motor_psi_sy_dot).add_product(R::literal(0.75) * motor_i_rx.add_product(t6,
            motor_psi_rx).sub_product(t8, motor_psi_sx), motor_psi_rx_dot)
            .add_product(R::literal(0.75) * motor_i_ry.add_product(t6, motor_psi_ry)
            .sub_product(t8, motor_psi_sy), motor_psi_ry_dot),
        supplied: (R::literal(1.5) * (motor_u_x * motor_i_sx).add_product(motor_u_y, motor_i_sy))
            .sub_product(cylinder_omega, load_resistance),
        dissipated: (p.coupling_damping * motor_omega * coupling_twist_rate)
            .add_product(R::literal(1.5), (p.motor_x_s * p.motor_alpha_s * motor_sigma
            * (motor_i_sx * motor_i_sx).add_product(motor_i_sy, motor_i_sy))
            .add_product(p.motor_alpha_r * motor_sigma * motor_x_r, (motor_i_rx * motor_i_rx)
            .add_product(motor_i_ry, motor_i_ry))).sub_product(t7 * cylinder_omega,
            coupling_twist_rate),
    }
}

/// Arguments of functions that are flat far from a place, such as `tanh` far from zero. Steps by
/// series are checked where one passes zero or turns. 2 operations.
#[must_use]
pub fn saturating_arguments<R: Real>(_time: R, state: &[R; STATES],
        p: &Parameters<R>) -> [R; SATURATIONS] {
    let [_, _, cylinder_omega, ..] = *state;
    let argument_1 = R::literal(1.0) / p.load_standstill_band * cylinder_omega;
    [argument_1]
}

/// Normalized Taylor coefficients of the solution through `state`, order after order.
///
/// `_k` marks the coefficient of order k, `_before` that of order k - 1; bare names are
/// zeroth coefficients. The workspace is as `series_workspace` says.
///
/// 116 recurrences. 9 sums of products an order.
///
/// # Panics
/// If there is no room for the zeroth coefficients, or the workspace is too short.
pub fn series<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>,
        coefficients: &mut [[R; STATES]], workspace: &mut [R]) {
    let (mut lanes, workspace) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let (mut lanes_1, workspace) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let (mut lanes_2, _) = Lanes::<R, 1>::new(workspace, coefficients.len());
    let [coupling_twist, motor_omega, cylinder_omega, motor_psi_sx, motor_psi_sy, motor_psi_rx,
        motor_psi_ry] = *state;
    let motor_omega_0 = R::literal(core::f64::consts::TAU) * p.motor_supply_frequency;
    let load_omega_2 = R::literal(0.104_719_755_119_659_77) * p.load_speed;
    let t0 = p.motor_k_s * p.motor_k_r;
    let motor_sigma = R::literal(1.0) - t0;
    let t1 = p.motor_supply_phase.cos();
    let t2 = p.motor_phase_voltage * R::literal(core::f64::consts::SQRT_2);
    let motor_u_x = t2 * t1;
    let t3 = p.motor_supply_phase.sin();
    let motor_u_y = t2 * t3;
    let t4 = cylinder_omega * p.coupling_ratio;
    let coupling_twist_rate = motor_omega - t4;
    let t5 = motor_omega * p.motor_pole_pairs;
    let motor_slip_speed = motor_omega_0 - t5;
    let t6 = coupling_twist * p.coupling_stiffness;
    let t7 = coupling_twist_rate * p.coupling_damping;
    let coupling_torque = t6 + t7;
    let t8 = time - p.load_engagement_time;
    let t9 = R::literal(-1.0) / p.load_engagement_width;
    let t10 = t8 * t9;
    let t11 = t10.exp();
    let t12 = R::literal(1.0) + t11;
    let load_engagement = R::literal(1.0) / t12;
    let t13 = motor_psi_rx * p.motor_k_r;
    let t14 = motor_psi_sx - t13;
    let t15 = p.motor_x_s * motor_sigma;
    let t16 = motor_psi_ry * p.motor_k_r;
    let t17 = motor_psi_sy - t16;
    let t18 = motor_psi_sx * p.motor_k_s;
    let t19 = motor_psi_sy * p.motor_k_s;
    let t20 = motor_psi_sx * motor_psi_ry;
    let t21 = motor_psi_sy * motor_psi_rx;
    let t22 = t21 - t20;
    let t23 = R::literal(1.5) * p.motor_pole_pairs;
    let t24 = t23 * p.motor_k_r;
    let t25 = t24 * motor_omega_0;
    let t26 = t25 / t15;
    let motor_torque = t22 * t26;
    let t27 = R::literal(core::f64::consts::PI) * load_omega_2;
    let t28 = time * t27;
    let t29 = p.load_phase + t28;
    let t30 = t29.sin();
    let t31 = t29.cos();
    let t32 = t30 * p.load_amplitude;
    let t33 = p.load_mean + t32;
    let t34 = R::literal(1.0) / p.load_standstill_band;
    let t35 = cylinder_omega * t34;
    let t36 = t35.tanh();
    let t37 = t36 * t36;
    let t38 = R::literal(1.0) - t37;
    let t39 = load_engagement * t33;
    let load_resistance = t39 * t36;
    let t40 = R::literal(1.0) / p.motor_inertia;
    let t41 = R::literal(1.0) / p.cylinder_inertia;
    let t42 = motor_torque - coupling_torque;
    let t43 = p.coupling_stiffness * p.coupling_ratio;
    let t44 = coupling_twist * t43;
    let t45 = p.coupling_damping * p.coupling_ratio;
    let t46 = coupling_twist_rate * t45;
    let t47 = t44 + t46;
    let t48 = t47 - load_resistance;
    let cylinder_omega_dot = t48 * t41;
    let motor_omega_dot = t42 * t40;
    let t49 = p.motor_alpha_s * motor_omega_0;
    let t50 = t14 * t49;
    let t51 = motor_psi_sy * motor_omega_0;
    let t52 = motor_u_x + t51;
    let motor_psi_sx_dot = t52 - t50;
    let t53 = motor_psi_sx * motor_omega_0;
    let t54 = t17 * t49;
    let t55 = motor_u_y - t53;
    let motor_psi_sy_dot = t55 - t54;
    let t56 = motor_psi_ry * motor_slip_speed;
    let t57 = t18 - motor_psi_rx;
    let t58 = p.motor_alpha_r * motor_omega_0;
    let t59 = t57 * t58;
    let motor_psi_rx_dot = t56 + t59;
    let t60 = motor_psi_rx * motor_slip_speed;
    let t61 = t19 - motor_psi_ry;
    let t62 = t61 * t58;
    let motor_psi_ry_dot = t62 - t60;
    let t10_slope = R::literal(1.0) * t9;
    let inverse_t12 = R::literal(1.0) / t12;
    let mut t11_before = t11;
    let mut t30_before = t30;
    let mut t31_before = t31;
    let mut rates = [coupling_twist_rate, motor_omega_dot, cylinder_omega_dot, motor_psi_sx_dot,
        motor_psi_sy_dot, motor_psi_rx_dot, motor_psi_ry_dot];
    coefficients[0] = *state;
    let highest = coefficients.len() - 1;
    for (order, state_k) in coefficients.iter_mut().enumerate().skip(1) {
        let (k, inverse) = order_and_inverse::<R>(order);
        *state_k = rates.map(|rate| rate * inverse);
        if order == highest {
            break;
        }
        let [coupling_twist_k, motor_omega_k, cylinder_omega_k, motor_psi_sx_k, motor_psi_sy_k,
            motor_psi_rx_k, motor_psi_ry_k] = *state_k;
        let sums = lanes.sums(order);
        let sums_1 = lanes_1.sums(order);
        let sums_2 = lanes_2.sums(order);
        let coupling_twist_rate_k = (-cylinder_omega_k).mul_add(p.coupling_ratio, motor_omega_k);
        let motor_slip_speed_k = -motor_omega_k * p.motor_pole_pairs;
        let coupling_torque_k = coupling_twist_rate_k.mul_add(p.coupling_damping, coupling_twist_k
            * p.coupling_stiffness);
        let t11_k = inverse * t10_slope * t11_before;
        let load_engagement_k = -t11_k.mul_add(load_engagement, sums_1[1]) * inverse_t12;
        let t14_k = (-motor_psi_rx_k).mul_add(p.motor_k_r, motor_psi_sx_k);
        let t17_k = (-motor_psi_ry_k).mul_add(p.motor_k_r, motor_psi_sy_k);
        let t20_k = motor_psi_sx.mul_add(motor_psi_ry_k, motor_psi_ry.mul_add(motor_psi_sx_k,
            sums[0]));
        let t21_k = motor_psi_sy.mul_add(motor_psi_rx_k, motor_psi_rx.mul_add(motor_psi_sy_k,
            sums[1]));
        let t22_k = t21_k - t20_k;
        let t30_k = inverse * t27 * t31_before;
        let t31_k = -inverse * t27 * t30_before;
        let t35_k = cylinder_omega_k * t34;
        let t36_k = t35_k.mul_add(t38, inverse * sums_1[3]);
        let t37_k = (t36 + t36).mul_add(t36_k, sums[2]);
        let t38_k = -t37_k;
        let t39_k = load_engagement.mul_add(t30_k * p.load_amplitude, t33
            .mul_add(load_engagement_k, sums_1[2]));
        let load_resistance_k = t36.mul_add(t39_k, t39.mul_add(t36_k, sums_2[0]));
        let t42_k = t22_k.mul_add(t26, -coupling_torque_k);
        let t47_k = coupling_twist_rate_k.mul_add(t45, coupling_twist_k * t43);
        let t48_k = t47_k - load_resistance_k;
        let cylinder_omega_dot_k = t48_k * t41;
        let motor_omega_dot_k = t42_k * t40;
        let motor_psi_sx_dot_k = (-t14_k).mul_add(t49, motor_psi_sy_k * motor_omega_0);
        let t55_k = -motor_psi_sx_k * motor_omega_0;
        let motor_psi_sy_dot_k = (-t17_k).mul_add(t49, t55_k);
        let t56_k = motor_psi_ry.mul_add(motor_slip_speed_k, motor_slip_speed
            .mul_add(motor_psi_ry_k, sums[3]));
        let t57_k = motor_psi_sx_k.mul_add(p.motor_k_s, -motor_psi_rx_k);
        let motor_psi_rx_dot_k = t57_k.mul_add(t58, t56_k);
        let t60_k = motor_psi_rx.mul_add(motor_slip_speed_k, motor_slip_speed
            .mul_add(motor_psi_rx_k, sums_1[0]));
        let t61_k = motor_psi_sy_k.mul_add(p.motor_k_s, -motor_psi_ry_k);
        let motor_psi_ry_dot_k = t61_k.mul_add(t58, -t60_k);
        lanes.set(order, [motor_psi_sx_k, motor_psi_rx_k, t36_k, motor_slip_speed_k],
            [motor_psi_ry_k, motor_psi_sy_k, t36_k, motor_psi_ry_k]);
        lanes_1.set(order, [motor_slip_speed_k, t11_k, load_engagement_k, k * t35_k],
            [motor_psi_rx_k, load_engagement_k, t30_k * p.load_amplitude, t38_k]);
        lanes_2.set(order, [t36_k], [t39_k]);
        t11_before = t11_k;
        t30_before = t30_k;
        t31_before = t31_k;
        rates = [coupling_twist_rate_k, motor_omega_dot_k, cylinder_omega_dot_k,
            motor_psi_sx_dot_k, motor_psi_sy_dot_k, motor_psi_rx_dot_k, motor_psi_ry_dot_k];
    }
}

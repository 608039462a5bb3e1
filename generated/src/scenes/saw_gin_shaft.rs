// Emitted by Machinist 0.1.0; do not edit. To make it again:
//
//     cargo run --release -- gen
//
// Sources, with SHA-256:
//   1d8bb12d06ac0509d63c14a3ad33f56d715b24f5def8ad30da7df3fac9b6314a  scenes/saw_gin_shaft.toml
//   03bebde2dcd618fcbd0662a0f5e63f806e09d154c0fc25f1f0527c30944dd55e  units/textile/induction_motor.toml
//   512419e5aa73ad1710ef3556037050e97b898e87a7d5d8a4e9c4b03a7a8b0141  units/coupling.toml
//   a32885bfa4082a0bcaa664faa1136165fcd0288699b4fe9c76b9014aead24dbe  units/textile/saw_shaft.toml
//
// Saw gin with a distributed shaft
//
// Motor, coupling, and the saw cylinder as an elastic shaft with distributed inertia and load. The
// machine runs up without load; the load engages at 1.2 s.
//
// Source:
//   Saw-gin study (2020), in its consistent reading, with balanced load densities.
//
// All quantities are in SI units.
// Shapes: coordinates 3, first-order states 4, states 10, parameters 33, outputs 8.
// Nonzeros: mass_matrix 3 of 3 by 3, rate_jacobian 29 of 10 by 10, parameter_jacobian 34 of 10 by 33.
// Operations: rate 63, forcing 26, rate_jacobian 52, parameter_jacobian 130, outputs 22, energy 45,
//     power_balance 144, prepare 62, prepared_rate 43, prepared_rate_jacobian 16,
//     prepared_parameter_jacobian 90.

use ::machinist_contract::{Energy, PowerBalance, Real, field::FieldPoint};

::machinist_contract::simulator! {
    /// Saw gin with a distributed shaft
    ///
    /// Motor, coupling, and the saw cylinder as an elastic shaft with distributed inertia and load. The
    /// machine runs up without load; the load engages at 1.2 s.
    ///
    /// Source: Saw-gin study (2020), in its consistent reading, with balanced load densities.
    SawGinShaft: "saw_gin_shaft", "Saw gin with a distributed shaft";
    run from 0.0, until 2.0, points 2001, rtol 1e-7, method "rodas5p";
    quadratures 0, discontinuities 0;
    prepared; jacobians_apart;
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
    saws_length: 2.322, "m", "saws.length", "length";
    saws_inertia: 1.244, "kg m^2", "saws.inertia", "moment of inertia of the cylinder";
    saws_shear_modulus: 8e10, "Pa", "saws.shear_modulus", "shear modulus";
    saws_polar_moment: 9.817e-6, "m^4", "saws.polar_moment", "polar moment of area";
    saws_damping_time: 1e-5, "s", "saws.damping_time", "Kelvin-Voigt damping time, assumed";
    saws_mean: 843.72, "N m", "saws.mean", "mean load";
    saws_amplitude: 78.78, "N m", "saws.amplitude", "amplitude of the harmonic part";
    saws_speed: 735.0, "1", "saws.speed", "rated speed, revolutions per minute";
    saws_growing: 0.0, "1", "saws.growing", "share of the load that grows with x; 0 for a uniform load";
    saws_engagement_time: 1.2, "s", "saws.engagement_time", "time at which the load engages";
    saws_engagement_width: 0.02, "s", "saws.engagement_width", "time constant of engagement";
    saws_standstill_band: 0.5, "rad/s", "saws.standstill_band", "speed below which the load fades out";
    saws_driven_field_inertia: 1.0, "J s^2/(rad)^2", "saws.driven_field_inertia", "inertia of the field's node; the field sets it";
    saws_driven_field_force: 0.0, "J/(rad)", "saws.driven_field_force", "force of the field on its node; the field sets it";
    saws_driven_phi_x_before: 0.0, "rad/m", "saws.driven_phi_x_before", "slope of the field before the port; the field sets it";
    saws_driven_phi_x_after: 0.0, "rad/m", "saws.driven_phi_x_after", "slope of the field after the port; the field sets it";
    saws_end_field_inertia: 1.0, "J s^2/(rad)^2", "saws.end_field_inertia", "inertia of the field's node; the field sets it";
    saws_end_field_force: 0.0, "J/(rad)", "saws.end_field_force", "force of the field on its node; the field sets it";
    saws_end_phi_x_before: 0.0, "rad/m", "saws.end_phi_x_before", "slope of the field before the port; the field sets it";
    saws_end_phi_x_after: 0.0, "rad/m", "saws.end_phi_x_after", "slope of the field after the port; the field sets it";
}

::machinist_contract::outputs! {
    motor_speed: "rad/s", "motor_speed", "rate of rotor angle";
    driven_speed: "rad/s", "driven_speed", "rate of angle of the section, at port driven";
    end_speed: "rad/s", "end_speed", "rate of angle of the section, at port end";
    twist: "rad", "twist", "twist of the shaft";
    slope: "rad/m", "slope", "twist per unit length at the driven end";
    motor_torque: "N m", "motor_torque", "electromagnetic torque";
    coupling_torque: "N m", "coupling_torque", "torque at the driving end";
    shaft_torque: "N m", "shaft_torque", "elastic torque in the shaft at its driven end";
}

::machinist_contract::states! {
    MOTOR_PHI: position, 150.0, "rad", "motor.phi", "rotor angle";
    SAWS_DRIVEN: position, 150.0, "rad", "saws.driven", "angle of the section, at port driven";
    SAWS_END: position, 150.0, "rad", "saws.end", "angle of the section, at port end";
    MOTOR_OMEGA: velocity, 78.5, "rad/s", "motor.omega", "rate of rotor angle";
    SAWS_DRIVEN_DOT: velocity, 78.5, "rad/s", "saws.driven_dot", "rate of angle of the section, at port driven";
    SAWS_END_DOT: velocity, 78.5, "rad/s", "saws.end_dot", "rate of angle of the section, at port end";
    MOTOR_PSI_SX: first_order, 1.0, "V s", "motor.psi_sx", "stator flux linkage along x";
    MOTOR_PSI_SY: first_order, 1.0, "V s", "motor.psi_sy", "stator flux linkage along y";
    MOTOR_PSI_RX: first_order, 1.0, "V s", "motor.psi_rx", "rotor flux linkage along x";
    MOTOR_PSI_RY: first_order, 1.0, "V s", "motor.psi_ry", "rotor flux linkage along y";
}

::machinist_contract::patterns! {
    /// Nonzeros of M.
    MASS_MATRIX_PATTERN: 3 by 3 { 0 [0] 1 [1] 2 [2] }
    /// Nonzeros of dy'/dy.
    RATE_JACOBIAN_PATTERN: 10 by 10 { 0 [3] 1 [4] 2 [5] 3 [0 1 3 4 6 7 8 9] 4 [0 1 3 4] 6 [6 7 8]
        7 [6 7 9] 8 [3 6 8 9] 9 [3 7 8 9] }
    /// Nonzeros of dy'/dp.
    PARAMETER_JACOBIAN_PATTERN: 10 by 33 { 3 [0 2 4 5 6 7 10 11 12] 4 [10 11 12 25 26] 5 [29 30]
        6 [1 2 3 6 8] 7 [1 2 3 6 8] 8 [2 4 5 9] 9 [2 4 5 9] }
}

::machinist_contract::constants! {
    motor_omega_0, motor_u_x, motor_u_y, t2, inverse_motor_inertia, inverse_saws_driven_field_inertia,
    inverse_saws_end_field_inertia, t3, t4, motor_alpha_s_times_motor_omega_0,
    motor_alpha_r_times_motor_omega_0, saws_driven_dot_dot_by_motor_phi,
    motor_omega_dot_by_motor_phi, saws_driven_dot_dot_by_saws_driven,
    motor_omega_dot_by_saws_driven, saws_driven_dot_dot_by_motor_omega,
    motor_omega_dot_by_motor_omega, saws_driven_dot_dot_by_saws_driven_dot,
    motor_omega_dot_by_saws_driven_dot, motor_psi_sx_dot_by_motor_psi_sx,
    motor_psi_sy_dot_by_motor_psi_sx, motor_psi_rx_dot_by_motor_psi_sx,
    motor_psi_sx_dot_by_motor_psi_rx, motor_psi_rx_dot_by_motor_psi_rx, t5, t6, t7, t8, t9,
    minus_motor_u_y, t10, motor_k_r_over_motor_sigma, t11, motor_k_s_over_motor_sigma, t12, t13, t14
}

::machinist_contract::field_scene! {
    SawGinShaft: jacobian_reads_forces false;
    0 saws_phi: linear false, local true, forces [Varying, Varying], derivatives [Zero, Zero,
        Varying, Zero, Zero, Constant, Zero, Constant], scale [150.0, 78.5], fixed [false, false],
        length 2.322, elements 8, order 4;
    value "rad", "saws.phi", "angle of the section";
    rate "rad/s", "saws.phi_dot", "rate of angle of the section";
    slope "rad/m", "saws.phi_x", "slope of angle of the section";
    at 0.0 => Start, coordinate Some(1), handed 25;
    at 2.322 => End, coordinate Some(2), handed 29;
}

/// Returns the constants of `rate` and its Jacobians from the parameters. 62 operations.
#[must_use]
#[inline]
pub fn prepare<R: Real>(p: &Parameters<R>) -> Constants<R> {
    let (sin_motor_supply_phase, cos_motor_supply_phase) = p.motor_supply_phase.sin_cos();
    let motor_omega_0 = R::literal(core::f64::consts::TAU) * p.motor_supply_frequency;
    let motor_sigma = R::literal(1.0).sub_product(p.motor_k_s, p.motor_k_r);
    let t0 = p.motor_phase_voltage * R::literal(core::f64::consts::SQRT_2);
    let motor_u_x = t0 * cos_motor_supply_phase;
    let motor_u_y = t0 * sin_motor_supply_phase;
    let motor_x_s_times_motor_sigma = p.motor_x_s * motor_sigma;
    let t1 = R::literal(1.5) * p.motor_pole_pairs;
    let t2 = t1 * p.motor_k_r * motor_omega_0 / motor_x_s_times_motor_sigma;
    let inverse_motor_inertia = R::literal(1.0) / p.motor_inertia;
    let inverse_saws_driven_field_inertia = R::literal(1.0) / p.saws_driven_field_inertia;
    let inverse_saws_end_field_inertia = R::literal(1.0) / p.saws_end_field_inertia;
    let t3 = p.coupling_stiffness * p.coupling_ratio;
    let t4 = p.coupling_damping * p.coupling_ratio;
    let motor_alpha_s_times_motor_omega_0 = p.motor_alpha_s * motor_omega_0;
    let motor_alpha_r_times_motor_omega_0 = p.motor_alpha_r * motor_omega_0;
    let saws_driven_dot_dot_by_motor_phi = t3 * inverse_saws_driven_field_inertia;
    let motor_omega_dot_by_motor_phi = -(p.coupling_stiffness * inverse_motor_inertia);
    let coupling_ratio_squared = p.coupling_ratio * p.coupling_ratio;
    let saws_driven_dot_dot_by_saws_driven = -(p.coupling_stiffness * coupling_ratio_squared
        * inverse_saws_driven_field_inertia);
    let motor_omega_dot_by_saws_driven = t3 * inverse_motor_inertia;
    let saws_driven_dot_dot_by_motor_omega = t4 * inverse_saws_driven_field_inertia;
    let motor_omega_dot_by_motor_omega = -(p.coupling_damping * inverse_motor_inertia);
    let saws_driven_dot_dot_by_saws_driven_dot = -(p.coupling_damping * coupling_ratio_squared
        * inverse_saws_driven_field_inertia);
    let motor_omega_dot_by_saws_driven_dot = t4 * inverse_motor_inertia;
    let motor_psi_sx_dot_by_motor_psi_sx = -motor_alpha_s_times_motor_omega_0;
    let motor_psi_sy_dot_by_motor_psi_sx = -motor_omega_0;
    let motor_psi_rx_dot_by_motor_psi_sx = p.motor_k_s * p.motor_alpha_r * motor_omega_0;
    let motor_psi_sx_dot_by_motor_psi_rx = p.motor_k_r * p.motor_alpha_s * motor_omega_0;
    let motor_psi_rx_dot_by_motor_psi_rx = -motor_alpha_r_times_motor_omega_0;
    let t5 = R::literal(core::f64::consts::SQRT_2) * cos_motor_supply_phase;
    let t6 = R::literal(core::f64::consts::SQRT_2) * sin_motor_supply_phase;
    let t7 = R::literal(3.0 * core::f64::consts::PI) * p.motor_pole_pairs * p.motor_k_r
        / motor_x_s_times_motor_sigma;
    let t8 = R::literal(core::f64::consts::TAU) * p.motor_alpha_s;
    let t9 = R::literal(core::f64::consts::TAU) * p.motor_alpha_r;
    let minus_motor_u_y = -motor_u_y;
    let t10 = R::literal(1.5) * p.motor_k_r * motor_omega_0 / motor_x_s_times_motor_sigma;
    let motor_k_r_over_motor_sigma = p.motor_k_r / motor_sigma;
    let t11 = t1 * motor_omega_0 / motor_x_s_times_motor_sigma;
    let motor_k_s_over_motor_sigma = p.motor_k_s / motor_sigma;
    let t12 = R::literal(-1.0) / p.motor_x_s;
    let t13 = R::literal(2.0) * p.coupling_stiffness * p.coupling_ratio;
    let t14 = R::literal(2.0) * p.coupling_damping * p.coupling_ratio;
    Constants { motor_omega_0, motor_u_x, motor_u_y, t2, inverse_motor_inertia,
        inverse_saws_driven_field_inertia, inverse_saws_end_field_inertia, t3, t4,
        motor_alpha_s_times_motor_omega_0, motor_alpha_r_times_motor_omega_0,
        saws_driven_dot_dot_by_motor_phi, motor_omega_dot_by_motor_phi,
        saws_driven_dot_dot_by_saws_driven, motor_omega_dot_by_saws_driven,
        saws_driven_dot_dot_by_motor_omega, motor_omega_dot_by_motor_omega,
        saws_driven_dot_dot_by_saws_driven_dot, motor_omega_dot_by_saws_driven_dot,
        motor_psi_sx_dot_by_motor_psi_sx, motor_psi_sy_dot_by_motor_psi_sx,
        motor_psi_rx_dot_by_motor_psi_sx, motor_psi_sx_dot_by_motor_psi_rx,
        motor_psi_rx_dot_by_motor_psi_rx, t5, t6, t7, t8, t9, minus_motor_u_y, t10,
        motor_k_r_over_motor_sigma, t11, motor_k_s_over_motor_sigma, t12, t13, t14 }
}

/// State at the start of the run, in the units of the states. No operations.
#[must_use]
pub fn initial_state<R: Real>(_p: &Parameters<R>) -> [R; STATES] {
    [R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0),
        R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0)]
}

/// Times of known jumps of the right-hand side \[s\], unsorted. No operations.
#[must_use]
pub fn discontinuities<R: Real>(_p: &Parameters<R>) -> [R; DISCONTINUITIES] {
    []
}

/// As `rate`, with the constants of the parameters from `prepare`. 43 operations.
#[must_use]
#[inline]
pub fn prepared_rate<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>,
        c: &Constants<R>) -> [R; STATES] {
    let [motor_phi, saws_driven, _, motor_omega, saws_driven_dot, saws_end_dot, motor_psi_sx,
        motor_psi_sy, motor_psi_rx, motor_psi_ry] = *state;
    let coupling_twist = motor_phi.sub_product(p.coupling_ratio, saws_driven);
    let coupling_twist_rate = motor_omega.sub_product(p.coupling_ratio, saws_driven_dot);
    let motor_slip_speed = c.motor_omega_0.sub_product(p.motor_pole_pairs, motor_omega);
    let coupling_torque = (p.coupling_stiffness * coupling_twist).add_product(p.coupling_damping,
        coupling_twist_rate);
    let motor_torque = c.t2 * (motor_psi_sy * motor_psi_rx).sub_product(motor_psi_sx, motor_psi_ry);
    let saws_end_dot_dot = p.saws_end_field_force * c.inverse_saws_end_field_inertia;
    let saws_driven_dot_dot = p.saws_driven_field_force.add_product(c.t3, coupling_twist)
        .add_product(c.t4, coupling_twist_rate) * c.inverse_saws_driven_field_inertia;
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
    [motor_omega, saws_driven_dot, saws_end_dot, motor_omega_dot, saws_driven_dot_dot,
        saws_end_dot_dot, motor_psi_sx_dot, motor_psi_sy_dot, motor_psi_rx_dot, motor_psi_ry_dot]
}

/// `M = d2L/dq'2`, values in the order of its pattern. No operations.
#[must_use]
pub fn mass_matrix<R: Real>(_time: R, _state: &[R; STATES], p: &Parameters<R>) -> [R; 3] {
    [p.motor_inertia, p.saws_driven_field_inertia, p.saws_end_field_inertia]
}

/// `f` of `M q'' = f + G^T lambda`, one for each coordinate. 26 operations.
#[must_use]
pub fn forcing<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>) -> [R; COORDINATES] {
    let [motor_phi, saws_driven, _, motor_omega, saws_driven_dot, _, motor_psi_sx, motor_psi_sy,
        motor_psi_rx, motor_psi_ry] = *state;
    let motor_omega_0 = R::literal(core::f64::consts::TAU) * p.motor_supply_frequency;
    let motor_sigma = R::literal(1.0).sub_product(p.motor_k_s, p.motor_k_r);
    let coupling_twist = motor_phi.sub_product(p.coupling_ratio, saws_driven);
    let coupling_twist_rate = motor_omega.sub_product(p.coupling_ratio, saws_driven_dot);
    let coupling_torque = (p.coupling_stiffness * coupling_twist).add_product(p.coupling_damping,
        coupling_twist_rate);
    let motor_torque = R::literal(1.5) * p.motor_pole_pairs * p.motor_k_r * motor_omega_0
        / (p.motor_x_s * motor_sigma) * (motor_psi_sy * motor_psi_rx).sub_product(motor_psi_sx,
        motor_psi_ry);
    let motor_phi_forcing = motor_torque - coupling_torque;
    let saws_driven_forcing = p.saws_driven_field_force.add_product(p.coupling_stiffness
        * p.coupling_ratio, coupling_twist).add_product(p.coupling_damping * p.coupling_ratio,
        coupling_twist_rate);
    [motor_phi_forcing, saws_driven_forcing, p.saws_end_field_force]
}

/// As `rate_jacobian`, with the constants of the parameters from `prepare`. 16 operations.
#[must_use]
pub fn prepared_rate_jacobian<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>,
        c: &Constants<R>) -> [R; 29] {
    let [_, _, _, motor_omega, _, _, motor_psi_sx, motor_psi_sy, motor_psi_rx, motor_psi_ry]
        = *state;
    let motor_pole_pairs_times_motor_omega = p.motor_pole_pairs * motor_omega;
    let motor_slip_speed = c.motor_omega_0 - motor_pole_pairs_times_motor_omega;
    let motor_psi_rx_dot_by_motor_omega = -(p.motor_pole_pairs * motor_psi_ry);
    let motor_psi_ry_dot_by_motor_omega = p.motor_pole_pairs * motor_psi_rx;
    let motor_omega_dot_by_motor_psi_sx = -(c.t2 * motor_psi_ry * c.inverse_motor_inertia);
    let motor_omega_dot_by_motor_psi_sy = c.t2 * motor_psi_rx * c.inverse_motor_inertia;
    let motor_omega_dot_by_motor_psi_rx = c.t2 * motor_psi_sy * c.inverse_motor_inertia;
    let motor_psi_ry_dot_by_motor_psi_rx = motor_pole_pairs_times_motor_omega - c.motor_omega_0;
    let motor_omega_dot_by_motor_psi_ry = -(c.t2 * motor_psi_sx * c.inverse_motor_inertia);
    [R::literal(1.0), R::literal(1.0), R::literal(1.0), c.motor_omega_dot_by_motor_phi,
        c.motor_omega_dot_by_saws_driven, c.motor_omega_dot_by_motor_omega,
        c.motor_omega_dot_by_saws_driven_dot, motor_omega_dot_by_motor_psi_sx,
        motor_omega_dot_by_motor_psi_sy, motor_omega_dot_by_motor_psi_rx,
        motor_omega_dot_by_motor_psi_ry, c.saws_driven_dot_dot_by_motor_phi,
        c.saws_driven_dot_dot_by_saws_driven, c.saws_driven_dot_dot_by_motor_omega,
        c.saws_driven_dot_dot_by_saws_driven_dot, c.motor_psi_sx_dot_by_motor_psi_sx,
        c.motor_omega_0, c.motor_psi_sx_dot_by_motor_psi_rx, c.motor_psi_sy_dot_by_motor_psi_sx,
        c.motor_psi_sx_dot_by_motor_psi_sx, c.motor_psi_sx_dot_by_motor_psi_rx,
        motor_psi_rx_dot_by_motor_omega, c.motor_psi_rx_dot_by_motor_psi_sx,
        c.motor_psi_rx_dot_by_motor_psi_rx, motor_slip_speed, motor_psi_ry_dot_by_motor_omega,
        c.motor_psi_rx_dot_by_motor_psi_sx, motor_psi_ry_dot_by_motor_psi_rx,
        c.motor_psi_rx_dot_by_motor_psi_rx]
}

/// As `parameter_jacobian`, with the constants of the parameters from `prepare`. 90 operations.
#[must_use]
pub fn prepared_parameter_jacobian<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>,
        c: &Constants<R>) -> [R; 34] {
    let [motor_phi, saws_driven, _, motor_omega, saws_driven_dot, _, motor_psi_sx, motor_psi_sy,
        motor_psi_rx, motor_psi_ry] = *state;
    let coupling_ratio_times_saws_driven = p.coupling_ratio * saws_driven;
    let coupling_twist = motor_phi - coupling_ratio_times_saws_driven;
    let coupling_ratio_times_saws_driven_dot = p.coupling_ratio * saws_driven_dot;
    let coupling_twist_rate = motor_omega - coupling_ratio_times_saws_driven_dot;
    let coupling_torque = (p.coupling_stiffness * coupling_twist).add_product(p.coupling_damping,
        coupling_twist_rate);
    let t0 = motor_psi_sx.sub_product(p.motor_k_r, motor_psi_rx);
    let t1 = motor_psi_sy.sub_product(p.motor_k_r, motor_psi_ry);
    let t2 = (motor_psi_sy * motor_psi_rx).sub_product(motor_psi_sx, motor_psi_ry);
    let motor_torque = c.t2 * t2;
    let saws_end_dot_dot = p.saws_end_field_force * c.inverse_saws_end_field_inertia;
    let saws_driven_dot_dot = p.saws_driven_field_force.add_product(c.t3, coupling_twist)
        .add_product(c.t4, coupling_twist_rate) * c.inverse_saws_driven_field_inertia;
    let motor_omega_dot = (motor_torque - coupling_torque) * c.inverse_motor_inertia;
    let t3 = (-motor_psi_rx).add_product(p.motor_k_s, motor_psi_sx);
    let t4 = (-motor_psi_ry).add_product(p.motor_k_s, motor_psi_sy);
    let motor_omega_dot_by_motor_inertia = -(motor_omega_dot * c.inverse_motor_inertia);
    let motor_omega_dot_by_motor_supply_frequency = c.t7 * t2 * c.inverse_motor_inertia;
    let motor_psi_sx_dot_by_motor_supply_frequency = (R::literal(core::f64::consts::TAU)
        * motor_psi_sy).sub_product(c.t8, t0);
    let motor_psi_sy_dot_by_motor_supply_frequency = (R::literal(-6.283_185_307_179_586)
        * motor_psi_sx).sub_product(c.t8, t1);
    let motor_psi_rx_dot_by_motor_supply_frequency = (R::literal(core::f64::consts::TAU)
        * motor_psi_ry).add_product(c.t9, t3);
    let motor_psi_ry_dot_by_motor_supply_frequency = (R::literal(-6.283_185_307_179_586)
        * motor_psi_rx).add_product(c.t9, t4);
    let motor_omega_dot_by_motor_pole_pairs = c.t10 * t2 * c.inverse_motor_inertia;
    let motor_psi_rx_dot_by_motor_pole_pairs = -(motor_omega * motor_psi_ry);
    let motor_psi_ry_dot_by_motor_pole_pairs = motor_omega * motor_psi_rx;
    let motor_omega_dot_by_motor_k_s = c.motor_k_r_over_motor_sigma * motor_torque
        * c.inverse_motor_inertia;
    let motor_psi_rx_dot_by_motor_k_s = c.motor_alpha_r_times_motor_omega_0 * motor_psi_sx;
    let motor_psi_ry_dot_by_motor_k_s = c.motor_alpha_r_times_motor_omega_0 * motor_psi_sy;
    let motor_omega_dot_by_motor_k_r = (c.t11 * t2).add_product(c.motor_k_s_over_motor_sigma,
        motor_torque) * c.inverse_motor_inertia;
    let motor_psi_sx_dot_by_motor_k_r = c.motor_alpha_s_times_motor_omega_0 * motor_psi_rx;
    let motor_psi_sy_dot_by_motor_k_r = c.motor_alpha_s_times_motor_omega_0 * motor_psi_ry;
    let motor_omega_dot_by_motor_x_s = c.t12 * motor_torque * c.inverse_motor_inertia;
    let motor_psi_sx_dot_by_motor_alpha_s = -(c.motor_omega_0 * t0);
    let motor_psi_sy_dot_by_motor_alpha_s = -(c.motor_omega_0 * t1);
    let motor_psi_rx_dot_by_motor_alpha_r = c.motor_omega_0 * t3;
    let motor_psi_ry_dot_by_motor_alpha_r = c.motor_omega_0 * t4;
    let saws_driven_dot_dot_by_coupling_stiffness = p.coupling_ratio * coupling_twist
        * c.inverse_saws_driven_field_inertia;
    let motor_omega_dot_by_coupling_stiffness = (coupling_ratio_times_saws_driven - motor_phi)
        * c.inverse_motor_inertia;
    let saws_driven_dot_dot_by_coupling_damping = p.coupling_ratio * coupling_twist_rate
        * c.inverse_saws_driven_field_inertia;
    let motor_omega_dot_by_coupling_damping = (coupling_ratio_times_saws_driven_dot - motor_omega)
        * c.inverse_motor_inertia;
    let saws_driven_dot_dot_by_coupling_ratio = (p.coupling_stiffness * motor_phi)
        .add_product(p.coupling_damping, motor_omega).sub_product(c.t13, saws_driven)
        .sub_product(c.t14, saws_driven_dot) * c.inverse_saws_driven_field_inertia;
    let motor_omega_dot_by_coupling_ratio = (p.coupling_stiffness * saws_driven)
        .add_product(p.coupling_damping, saws_driven_dot) * c.inverse_motor_inertia;
    let saws_driven_dot_dot_by_saws_driven_field_inertia = -(saws_driven_dot_dot
        * c.inverse_saws_driven_field_inertia);
    let saws_end_dot_dot_by_saws_end_field_inertia = -(saws_end_dot_dot
        * c.inverse_saws_end_field_inertia);
    [motor_omega_dot_by_motor_inertia, motor_omega_dot_by_motor_supply_frequency,
        motor_omega_dot_by_motor_pole_pairs, motor_omega_dot_by_motor_k_s,
        motor_omega_dot_by_motor_k_r, motor_omega_dot_by_motor_x_s,
        motor_omega_dot_by_coupling_stiffness, motor_omega_dot_by_coupling_damping,
        motor_omega_dot_by_coupling_ratio, saws_driven_dot_dot_by_coupling_stiffness,
        saws_driven_dot_dot_by_coupling_damping, saws_driven_dot_dot_by_coupling_ratio,
        saws_driven_dot_dot_by_saws_driven_field_inertia, c.inverse_saws_driven_field_inertia,
        saws_end_dot_dot_by_saws_end_field_inertia, c.inverse_saws_end_field_inertia, c.t5,
        motor_psi_sx_dot_by_motor_supply_frequency, c.minus_motor_u_y,
        motor_psi_sx_dot_by_motor_k_r, motor_psi_sx_dot_by_motor_alpha_s, c.t6,
        motor_psi_sy_dot_by_motor_supply_frequency, c.motor_u_x, motor_psi_sy_dot_by_motor_k_r,
        motor_psi_sy_dot_by_motor_alpha_s, motor_psi_rx_dot_by_motor_supply_frequency,
        motor_psi_rx_dot_by_motor_pole_pairs, motor_psi_rx_dot_by_motor_k_s,
        motor_psi_rx_dot_by_motor_alpha_r, motor_psi_ry_dot_by_motor_supply_frequency,
        motor_psi_ry_dot_by_motor_pole_pairs, motor_psi_ry_dot_by_motor_k_s,
        motor_psi_ry_dot_by_motor_alpha_r]
}

/// Partial derivative of `y'` with respect to time. No operations.
#[must_use]
pub fn time_derivative<R: Real>(_time: R, _state: &[R; STATES], _p: &Parameters<R>) -> [R; STATES] {
    [R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0),
        R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0)]
}

/// Wanted outputs. 22 operations.
#[must_use]
pub fn outputs<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>) -> Outputs<R> {
    let [motor_phi, saws_driven, saws_end, motor_omega, saws_driven_dot, saws_end_dot,
        motor_psi_sx, motor_psi_sy, motor_psi_rx, motor_psi_ry] = *state;
    let motor_omega_0 = R::literal(core::f64::consts::TAU) * p.motor_supply_frequency;
    let motor_sigma = R::literal(1.0).sub_product(p.motor_k_s, p.motor_k_r);
    let coupling_twist = motor_phi.sub_product(p.coupling_ratio, saws_driven);
    let coupling_twist_rate = motor_omega.sub_product(p.coupling_ratio, saws_driven_dot);
    let coupling_torque = (p.coupling_stiffness * coupling_twist).add_product(p.coupling_damping,
        coupling_twist_rate);
    let motor_torque = R::literal(1.5) * p.motor_pole_pairs * p.motor_k_r * motor_omega_0
        / (p.motor_x_s * motor_sigma) * (motor_psi_sy * motor_psi_rx).sub_product(motor_psi_sx,
        motor_psi_ry);
    Outputs {
        motor_speed: motor_omega,
        driven_speed: saws_driven_dot,
        end_speed: saws_end_dot,
        twist: saws_driven - saws_end,
        slope: p.saws_driven_phi_x_after,
        motor_torque,
        coupling_torque,
        shaft_torque: p.saws_shear_modulus * p.saws_polar_moment * p.saws_driven_phi_x_after,
    }
}

/// T, V and the energy of first-order states \[J\]. 45 operations.
#[must_use]
pub fn energy<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>) -> Energy<R> {
    let [motor_phi, saws_driven, _, motor_omega, saws_driven_dot, saws_end_dot, motor_psi_sx,
        motor_psi_sy, motor_psi_rx, motor_psi_ry] = *state;
    let motor_omega_0 = R::literal(core::f64::consts::TAU) * p.motor_supply_frequency;
    let motor_sigma = R::literal(1.0).sub_product(p.motor_k_s, p.motor_k_r);
    let motor_x_r = p.motor_k_s * p.motor_x_s / p.motor_k_r;
    let coupling_twist = motor_phi.sub_product(p.coupling_ratio, saws_driven);
    let t0 = motor_omega_0 / (p.motor_x_s * motor_sigma);
    let motor_i_sx = t0 * motor_psi_sx.sub_product(p.motor_k_r, motor_psi_rx);
    let motor_i_sy = t0 * motor_psi_sy.sub_product(p.motor_k_r, motor_psi_ry);
    let t1 = motor_omega_0 / (motor_sigma * motor_x_r);
    let motor_i_rx = t1 * motor_psi_rx.sub_product(p.motor_k_s, motor_psi_sx);
    let motor_i_ry = t1 * motor_psi_ry.sub_product(p.motor_k_s, motor_psi_sy);
    Energy {
        kinetic: (R::literal(0.5) * p.motor_inertia * (motor_omega * motor_omega))
            .add_product(R::literal(0.5) * p.saws_driven_field_inertia, saws_driven_dot
            * saws_driven_dot).add_product(R::literal(0.5) * p.saws_end_field_inertia, saws_end_dot
            * saws_end_dot),
        potential: R::literal(0.5) * p.coupling_stiffness * (coupling_twist * coupling_twist),
        stored: R::literal(0.75) * (motor_psi_sx * motor_i_sx).add_product(motor_psi_sy, motor_i_sy)
            .add_product(motor_psi_rx, motor_i_rx).add_product(motor_psi_ry, motor_i_ry),
    }
}

/// `dE/dt`, power supplied and power dissipated \[W\]. 144 operations.
#[must_use]
pub fn power_balance<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>) -> PowerBalance<R> {
    let [motor_phi, saws_driven, _, motor_omega, saws_driven_dot, saws_end_dot, motor_psi_sx,
        motor_psi_sy, motor_psi_rx, motor_psi_ry] = *state;
    let (sin_motor_supply_phase, cos_motor_supply_phase) = p.motor_supply_phase.sin_cos();
    let motor_omega_0 = R::literal(core::f64::consts::TAU) * p.motor_supply_frequency;
    let motor_sigma = R::literal(1.0).sub_product(p.motor_k_s, p.motor_k_r);
    let motor_x_r = p.motor_k_s * p.motor_x_s / p.motor_k_r;
    let t0 = p.motor_phase_voltage * R::literal(core::f64::consts::SQRT_2);
    let motor_u_x = t0 * cos_motor_supply_phase;
    let motor_u_y = t0 * sin_motor_supply_phase;
    let coupling_twist = motor_phi.sub_product(p.coupling_ratio, saws_driven);
    let coupling_twist_rate = motor_omega.sub_product(p.coupling_ratio, saws_driven_dot);
    let motor_slip_speed = motor_omega_0.sub_product(p.motor_pole_pairs, motor_omega);
    let t1 = p.coupling_stiffness * coupling_twist;
    let coupling_torque = t1.add_product(p.coupling_damping, coupling_twist_rate);
    let t2 = motor_psi_sx.sub_product(p.motor_k_r, motor_psi_rx);
    let motor_x_s_times_motor_sigma = p.motor_x_s * motor_sigma;
    let t3 = motor_omega_0 / motor_x_s_times_motor_sigma;
    let motor_i_sx = t3 * t2;
    let t4 = motor_psi_sy.sub_product(p.motor_k_r, motor_psi_ry);
    let motor_i_sy = t3 * t4;
    let motor_k_s_times_motor_psi_sx = p.motor_k_s * motor_psi_sx;
    let t5 = motor_omega_0 / (motor_sigma * motor_x_r);
    let motor_i_rx = t5 * (motor_psi_rx - motor_k_s_times_motor_psi_sx);
    let motor_k_s_times_motor_psi_sy = p.motor_k_s * motor_psi_sy;
    let motor_i_ry = t5 * (motor_psi_ry - motor_k_s_times_motor_psi_sy);
    let motor_torque = R::literal(1.5) * p.motor_pole_pairs * p.motor_k_r * motor_omega_0
        / motor_x_s_times_motor_sigma * (motor_psi_sy * motor_psi_rx).sub_product(motor_psi_sx,
        motor_psi_ry);
    let t6 = p.coupling_stiffness * p.coupling_ratio * coupling_twist;
    let t7 = p.coupling_damping * p.coupling_ratio;
    let saws_end_dot_dot = p.saws_end_field_force * (R::literal(1.0) / p.saws_end_field_inertia);
    let saws_driven_dot_dot = (p.saws_driven_field_force + t6).add_product(t7, coupling_twist_rate)
        * (R::literal(1.0) / p.saws_driven_field_inertia);
    let motor_omega_dot = (motor_torque - coupling_torque) * (R::literal(1.0) / p.motor_inertia);
    let motor_alpha_s_times_motor_omega_0 = p.motor_alpha_s * motor_omega_0;
    let motor_psi_sx_dot = motor_u_x.add_product(motor_omega_0, motor_psi_sy)
        .sub_product(motor_alpha_s_times_motor_omega_0, t2);
    let motor_psi_sy_dot = motor_u_y.sub_product(motor_omega_0, motor_psi_sx)
        .sub_product(motor_alpha_s_times_motor_omega_0, t4);
    let motor_alpha_r_times_motor_omega_0 = p.motor_alpha_r * motor_omega_0;
    let motor_psi_rx_dot = (motor_psi_ry * motor_slip_speed)
        .add_product(motor_alpha_r_times_motor_omega_0, motor_k_s_times_motor_psi_sx
        - motor_psi_rx);
    let motor_psi_ry_dot = (motor_alpha_r_times_motor_omega_0 * (motor_k_s_times_motor_psi_sy
        - motor_psi_ry)).sub_product(motor_psi_rx, motor_slip_speed);
    let t8 = p.motor_k_r * motor_omega_0 / motor_x_s_times_motor_sigma;
    PowerBalance {
        stored_rate: (t1 * motor_omega).sub_product(t6, saws_driven_dot)
            .add_product(p.motor_inertia * motor_omega, motor_omega_dot)
            .add_product(saws_driven_dot * p.saws_driven_field_inertia, saws_driven_dot_dot)
            .add_product(saws_end_dot * p.saws_end_field_inertia, saws_end_dot_dot)
            .add_product(R::literal(0.75) * motor_i_sx.add_product(t3, motor_psi_sx)
            .sub_product(t8, motor_psi_rx), motor_psi_sx_dot).add_product(R::literal(0.75)
            * motor_i_sy.add_product(t3, motor_psi_sy).sub_product(t8, motor_psi_ry),
            motor_psi_sy_dot).add_product(R::literal(0.75) * motor_i_rx.add_product(t5,
            motor_psi_rx).sub_product(t8, motor_psi_sx), motor_psi_rx_dot)
            .add_product(R::literal(0.75) * motor_i_ry.add_product(t5, motor_psi_ry)
            .sub_product(t8, motor_psi_sy), motor_psi_ry_dot),
        supplied: (saws_driven_dot * p.saws_driven_field_force).add_product(R::literal(1.5),
            (motor_u_x * motor_i_sx).add_product(motor_u_y, motor_i_sy)).add_product(saws_end_dot,
            p.saws_end_field_force),
        dissipated: (p.coupling_damping * motor_omega * coupling_twist_rate)
            .add_product(R::literal(1.5), (p.motor_x_s * p.motor_alpha_s * motor_sigma
            * (motor_i_sx * motor_i_sx).add_product(motor_i_sy, motor_i_sy))
            .add_product(p.motor_alpha_r * motor_sigma * motor_x_r, (motor_i_rx * motor_i_rx)
            .add_product(motor_i_ry, motor_i_ry))).sub_product(t7 * saws_driven_dot,
            coupling_twist_rate),
    }
}

/// The field saws.phi: angle of the section \[rad\].
///
/// One generic element: what acts at a point with u, u_x, u_t, u_xt at x. The loops over elements are the contract's.
pub mod saws_phi {
    #[allow(
        clippy::wildcard_imports,
        unused_imports,
        reason = "what a field needs of it"
    )]
    use super::*;
    /// Parameters that the field depends on.
    pub const PARAMETERS: [u32; 12] = [13, 14, 15, 16, 17, 18, 19, 20, 21, 22, 23, 24];
    /// m, the inertia a length. 1 operation.
    #[must_use]
    #[inline(always)]
    pub fn inertia<R: Real>(_x: R, p: &Parameters<R>) -> [R; 1] {
        [p.saws_inertia / p.saws_length]
    }
    /// dm/dx, then dm/dp of `PARAMETERS`. 4 operations.
    #[must_use]
    #[inline]
    pub fn inertia_gradient<R: Real>(_x: R, p: &Parameters<R>) -> [R; 13] {
        [R::literal(0.0), -(p.saws_inertia / (p.saws_length * p.saws_length)),
            R::literal(1.0) / p.saws_length, R::literal(0.0), R::literal(0.0), R::literal(0.0),
            R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0),
            R::literal(0.0), R::literal(0.0)]
    }
    /// Forces a length: f_0 = dL/du - dD/du_t + Q on u, f_1 = dL/du_x - dD/du_xt on u_x. 28 operations.
    #[must_use]
    #[inline]
    pub fn force<R: Real>(time: R, x: R, point: &FieldPoint<R>, p: &Parameters<R>) -> [R; 2] {
        let [_, phi_x, phi_dot, phi_x_dot] = *point;
        [p.saws_mean.add_product(p.saws_amplitude, (R::literal(0.328_986_813_369_645_25)
            * p.saws_speed * time).sin()) * ((p.saws_growing - R::literal(1.0))
            / p.saws_length).sub_product(R::literal(2.0) * p.saws_growing / (p.saws_length
            * p.saws_length), x) * (R::literal(1.0) / p.saws_standstill_band
            * phi_dot).tanh() / (R::literal(1.0) + (R::literal(-1.0) / p.saws_engagement_width
            * (time - p.saws_engagement_time)).exp()), -(p.saws_shear_modulus * p.saws_polar_moment
            * phi_x.add_product(p.saws_damping_time, phi_x_dot))]
    }
    /// Derivatives of f_0, then of f_1, with respect to u, u_x, u_t, u_xt. 30 operations.
    #[must_use]
    #[inline]
    pub fn force_jacobian<R: Real>(time: R, x: R, point: &FieldPoint<R>,
            p: &Parameters<R>) -> [R; 8] {
        let [_, _, phi_dot, _] = *point;
        let inverse_saws_standstill_band = R::literal(1.0) / p.saws_standstill_band;
        let t0 = (inverse_saws_standstill_band * phi_dot).tanh();
        let t1 = p.saws_shear_modulus * p.saws_polar_moment;
        [R::literal(0.0), R::literal(0.0),
            inverse_saws_standstill_band * R::literal(-1.0).add_product(t0,
            t0) * p.saws_mean.add_product(p.saws_amplitude, (R::literal(0.328_986_813_369_645_25)
            * p.saws_speed * time).sin()) * ((R::literal(1.0) - p.saws_growing)
            / p.saws_length).add_product(R::literal(2.0) * p.saws_growing / (p.saws_length
            * p.saws_length), x) / (R::literal(1.0) + (R::literal(-1.0) / p.saws_engagement_width
            * (time - p.saws_engagement_time)).exp()), R::literal(0.0), R::literal(0.0), -t1,
            R::literal(0.0), -(t1 * p.saws_damping_time)]
    }
    /// Derivatives of f_0 and f_1 with respect to x, to t, then to `PARAMETERS`. 95 operations.
    #[must_use]
    #[inline]
    pub fn force_gradient<R: Real>(time: R, x: R, point: &FieldPoint<R>,
            p: &Parameters<R>) -> [R; 28] {
        let [_, phi_x, phi_dot, phi_x_dot] = *point;
        let t0 = R::literal(0.328_986_813_369_645_25) * p.saws_speed * time;
        let (t1, t2) = t0.sin_cos();
        let saws_length_squared = p.saws_length * p.saws_length;
        let t3 = p.saws_mean.add_product(p.saws_amplitude, t1);
        let t4 = R::literal(2.0) * p.saws_growing / saws_length_squared;
        let t5 = R::literal(1.0) - p.saws_growing;
        let t6 = (t5 / p.saws_length).add_product(t4, x);
        let time_minus_saws_engagement_time = time - p.saws_engagement_time;
        let inverse_saws_engagement_width = R::literal(1.0) / p.saws_engagement_width;
        let t7 = inverse_saws_engagement_width * time_minus_saws_engagement_time;
        let t8 = R::literal(1.0) + (-t7).exp();
        let t9 = (R::literal(1.0) / p.saws_standstill_band * phi_dot).tanh();
        let t10 = phi_x.add_product(p.saws_damping_time, phi_x_dot);
        let t11 = t8 * (R::literal(1.0) + t7.exp());
        let t12 = inverse_saws_engagement_width * t3 * t6 * t9 / t11;
        [-(t4 * t3 * t9 / t8), R::literal(0.0),
            R::literal(-0.033_333_333_333_333_33) * p.saws_amplitude * p.saws_speed
            * R::literal(core::f64::consts::PI * core::f64::consts::PI) * t6 * t2 * t9 / t8 - t12,
            R::literal(0.0), t3 * (t5 / saws_length_squared).add_product(R::literal(4.0)
            * p.saws_growing / (saws_length_squared * p.saws_length), x) * t9 / t8,
            R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0),
            -(p.saws_polar_moment * t10), R::literal(0.0), -(p.saws_shear_modulus * t10),
            R::literal(0.0), -(p.saws_shear_modulus * p.saws_polar_moment * phi_x_dot),
            -(t6 * t9 / t8), R::literal(0.0), -(t6 * t1 * t9 / t8), R::literal(0.0),
            R::literal(-0.328_986_813_369_645_25) * p.saws_amplitude * time * t6 * t2 * t9 / t8,
            R::literal(0.0), t3 * (R::literal(1.0) / p.saws_length).sub_product(R::literal(2.0)
            / saws_length_squared, x) * t9 / t8, R::literal(0.0), t12, R::literal(0.0),
            R::literal(1.0) / (p.saws_engagement_width
            * p.saws_engagement_width) * time_minus_saws_engagement_time * t3 * t6 * t9 / t11,
            R::literal(0.0), R::literal(1.0) / (p.saws_standstill_band
            * p.saws_standstill_band) * phi_dot * R::literal(1.0).sub_product(t9,
            t9) * t3 * t6 / t8, R::literal(0.0)]
    }
    /// T and V a length \[J/m\]. 8 operations.
    #[must_use]
    #[inline]
    pub fn energy<R: Real>(_time: R, _x: R, point: &FieldPoint<R>, p: &Parameters<R>) -> [R; 2] {
        let [_, phi_x, phi_dot, _] = *point;
        [R::literal(0.5) * p.saws_inertia / p.saws_length * (phi_dot * phi_dot),
            R::literal(0.5) * p.saws_shear_modulus * p.saws_polar_moment * (phi_x * phi_x)]
    }
    /// Rate of V, power supplied and power dissipated, a length \[W/m\]. 30 operations.
    #[must_use]
    #[inline]
    pub fn power<R: Real>(time: R, x: R, point: &FieldPoint<R>, p: &Parameters<R>) -> [R; 3] {
        let [_, phi_x, phi_dot, phi_x_dot] = *point;
        let t0 = p.saws_shear_modulus * p.saws_polar_moment;
        [t0 * phi_x * phi_x_dot, phi_dot * p.saws_mean.add_product(p.saws_amplitude,
            (R::literal(0.328_986_813_369_645_25) * p.saws_speed * time).sin()) * ((p.saws_growing
            - R::literal(1.0)) / p.saws_length).sub_product(R::literal(2.0) * p.saws_growing
            / (p.saws_length * p.saws_length), x) * (R::literal(1.0) / p.saws_standstill_band
            * phi_dot).tanh() / (R::literal(1.0) + (R::literal(-1.0) / p.saws_engagement_width
            * (time - p.saws_engagement_time)).exp()), t0 * p.saws_damping_time * (phi_x_dot
            * phi_x_dot)]
    }
    /// x of the attachments, then the length \[m\]. No operations.
    #[must_use]
    #[inline]
    pub fn places<R: Real>(p: &Parameters<R>) -> [R; 3] {
        [R::literal(0.0), p.saws_length, p.saws_length]
    }
    /// Derivatives of `places` with respect to `PARAMETERS`, row by row. No operations.
    #[must_use]
    #[inline]
    pub fn places_gradient<R: Real>(_p: &Parameters<R>) -> [R; 36] {
        [R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0),
            R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0),
            R::literal(0.0), R::literal(0.0), R::literal(1.0), R::literal(0.0), R::literal(0.0),
            R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0),
            R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(1.0),
            R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0),
            R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0),
            R::literal(0.0)]
    }
    /// u and u_t at the start. No operations.
    #[must_use]
    #[inline]
    pub fn initial<R: Real>(_x: R, _p: &Parameters<R>) -> [R; 2] {
        [R::literal(0.0), R::literal(0.0)]
    }
    /// f_0 alone, at many points.
    ///
    /// 16 operations for all points, 7 for each.
    pub fn on_value<R: Real>(time: R, at: &[R], u: &[R], u_t: &[R], p: &Parameters<R>,
            force: &mut [R]) {
        let t0 = p.saws_mean.add_product(p.saws_amplitude, (R::literal(0.328_986_813_369_645_25)
            * p.saws_speed * time).sin());
        let t1 = R::literal(2.0) * p.saws_growing / (p.saws_length * p.saws_length);
        let t2 = R::literal(1.0) + (R::literal(-1.0) / p.saws_engagement_width
            * (time - p.saws_engagement_time)).exp();
        let inverse_saws_standstill_band = R::literal(1.0) / p.saws_standstill_band;
        let t3 = (p.saws_growing - R::literal(1.0)) / p.saws_length;
        for (((&x, _), &phi_dot), force) in at.iter().zip(u).zip(u_t).zip(force) {
            *force = t0 * t3.sub_product(t1, x) * (inverse_saws_standstill_band * phi_dot).tanh()
                / t2;
        }
    }
    /// df_0/du and df_0/du_t, at many points.
    ///
    /// 16 operations for all points, 10 for each.
    pub fn on_value_jacobian<R: Real>(time: R, at: &[R], u: &[R], u_t: &[R], p: &Parameters<R>,
            by_u: &mut [R], by_u_t: &mut [R]) {
        let t0 = p.saws_mean.add_product(p.saws_amplitude, (R::literal(0.328_986_813_369_645_25)
            * p.saws_speed * time).sin());
        let t1 = R::literal(2.0) * p.saws_growing / (p.saws_length * p.saws_length);
        let t2 = (R::literal(1.0) - p.saws_growing) / p.saws_length;
        let t3 = R::literal(1.0) + (R::literal(-1.0) / p.saws_engagement_width
            * (time - p.saws_engagement_time)).exp();
        let inverse_saws_standstill_band = R::literal(1.0) / p.saws_standstill_band;
        for ((((&x, _), &phi_dot), by_u), by_u_t) in at.iter().zip(u).zip(u_t).zip(by_u)
                .zip(by_u_t) {
            let t0_2 = (inverse_saws_standstill_band * phi_dot).tanh();
            *by_u = R::literal(0.0);
            *by_u_t = inverse_saws_standstill_band * R::literal(-1.0).add_product(t0_2, t0_2) * t0
                * t2.add_product(t1, x) / t3;
        }
    }
    /// df_0/dt, at many points.
    ///
    /// 25 operations for all points, 12 for each.
    pub fn on_value_by_time<R: Real>(time: R, at: &[R], u: &[R], u_t: &[R], p: &Parameters<R>,
            by_time: &mut [R]) {
        let t0 = R::literal(0.328_986_813_369_645_25) * p.saws_speed * time;
        let (t1, t2) = t0.sin_cos();
        let t3 = R::literal(2.0) * p.saws_growing / (p.saws_length * p.saws_length);
        let t4 = (R::literal(1.0) - p.saws_growing) / p.saws_length;
        let inverse_saws_engagement_width = R::literal(1.0) / p.saws_engagement_width;
        let t5 = inverse_saws_engagement_width * (time - p.saws_engagement_time);
        let t6 = R::literal(1.0) + (-t5).exp();
        let inverse_saws_standstill_band = R::literal(1.0) / p.saws_standstill_band;
        let t7 = inverse_saws_engagement_width * p.saws_mean.add_product(p.saws_amplitude, t1);
        let t8 = t6 * (R::literal(1.0) + t5.exp());
        let t9 = R::literal(-0.033_333_333_333_333_33) * p.saws_amplitude * p.saws_speed
            * R::literal(core::f64::consts::PI * core::f64::consts::PI);
        for (((&x, _), &phi_dot), by_time) in at.iter().zip(u).zip(u_t).zip(by_time) {
            let t0 = t4.add_product(t3, x);
            let t1 = (inverse_saws_standstill_band * phi_dot).tanh();
            *by_time = t9 * t0 * t2 * t1 / t6 - t7 * t0 * t1 / t8;
        }
    }
    /// f_1 alone, at many points.
    ///
    /// 1 operations for all points, 4 for each.
    pub fn on_slope<R: Real>(u_x: &[R], u_xt: &[R], p: &Parameters<R>, force: &mut [R]) {
        let t0 = p.saws_shear_modulus * p.saws_polar_moment;
        for ((&phi_x, &phi_x_dot), force) in u_x.iter().zip(u_xt).zip(force) {
            *force = -(t0 * phi_x.add_product(p.saws_damping_time, phi_x_dot));
        }
    }
    /// df_1/du_x and df_1/du_xt, at many points.
    ///
    /// 4 operations for all points, 0 for each.
    pub fn on_slope_jacobian<R: Real>(u_x: &[R], u_xt: &[R], p: &Parameters<R>, by_u_x: &mut [R],
            by_u_xt: &mut [R]) {
        let t0 = p.saws_shear_modulus * p.saws_polar_moment;
        let t1 = -t0;
        let t2 = -(t0 * p.saws_damping_time);
        for (((_, _), by_u_x), by_u_xt) in u_x.iter().zip(u_xt).zip(by_u_x).zip(by_u_xt) {
            *by_u_x = t1;
            *by_u_xt = t2;
        }
    }
}

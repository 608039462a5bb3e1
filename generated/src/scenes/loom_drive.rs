// Emitted by Machinist 0.1.0; do not edit. To make it again:
//
//     cargo run --release -- gen
//
// Sources, with SHA-256:
//   29f1b0af4834db9b42b54f798d4c06bdc4372ffc1ec853bda4294d4ddeb8071d  scenes/loom_drive.toml
//   03bebde2dcd618fcbd0662a0f5e63f806e09d154c0fc25f1f0527c30944dd55e  units/textile/induction_motor.toml
//   512419e5aa73ad1710ef3556037050e97b898e87a7d5d8a4e9c4b03a7a8b0141  units/coupling.toml
//   dfe11eec2c46ab2845d6693f49f4f3634573d8ca64fadaf874b71b4c8dcafb3a  units/textile/loom_shaft.toml
//   26e14d50834ad425bb0bc762e8b125d605c2c6b5f805586de92628a7bf67982c  units/textile/reed.toml
//   00194fa7aada6df5187ca4fb9b608bd4cbec21105dda9447be2267c590d0c0c2  units/textile/cloth_fell_contact.toml
//
// Loom: motor, coupling, shaft and reed
//
// An induction motor turns a crank through the coupling and a gear. The crank rocks the driven end of
// the reed's shaft through the drive spring. The reed presses the cloth fell.
//
// Source:
//   Saw-gin study (2020) for motor and coupling; reed study for shaft and reed. Crank, gear and brake torque are ours.
//
// All quantities are in SI units.
// Shapes: coordinates 6, first-order states 4, states 16, parameters 39, outputs 8.
// Nonzeros: mass_matrix 6 of 6 by 6, rate_jacobian 39 of 16 by 16, parameter_jacobian 47 of 16 by 39.
// Operations: rate 87, mass_matrix 2, forcing 42, rate_jacobian 82, parameter_jacobian 184,
//     outputs 17, energy 75, power_balance 185, prepare 79, prepared_rate 61,
//     prepared_rate_jacobian 31, prepared_parameter_jacobian 136.

use ::machinist_contract::{Energy, PowerBalance, Real, field::FieldPoint};

::machinist_contract::simulator! {
    /// Loom: motor, coupling, shaft and reed
    ///
    /// An induction motor turns a crank through the coupling and a gear. The crank rocks the driven end of
    /// the reed's shaft through the drive spring. The reed presses the cloth fell.
    ///
    /// Source: Saw-gin study (2020) for motor and coupling; reed study for shaft and reed. Crank, gear and brake torque are ours.
    LoomDrive: "loom_drive", "Loom: motor, coupling, shaft and reed";
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
    crank_inertia: 2.0, "kg m^2", "crank.inertia", "inertia of crank and flywheel";
    crank_ratio: 0.05, "1", "crank.ratio", "amplitude of the rocking angle, in rad";
    crank_stiffness: 45200.0, "N m/rad", "crank.stiffness", "stiffness of the drive spring";
    crank_drag: 0.5, "N m s/rad", "crank.drag", "viscous friction of the crank";
    shaft_length: 1.75, "m", "shaft.length", "half length of the shaft";
    shaft_reed_position: 1.0, "m", "shaft.reed_position", "position of the reed";
    shaft_radius: 0.025, "m", "shaft.radius", "radius";
    shaft_density: 7659.0, "kg/m^3", "shaft.density", "density";
    shaft_shear_modulus: 7.692_307_692_307_692e10, "Pa", "shaft.shear_modulus", "shear modulus, E/(2 (1 + nu)) with E = 2e11 Pa, nu = 0.3";
    shaft_damping_time: 1e-6, "s", "shaft.damping_time", "Kelvin-Voigt damping time";
    reed_mass: 3.56, "kg", "reed.mass", "mass";
    reed_arm: 0.025, "m", "reed.arm", "lever arm of the mass";
    reed_stiffness: 15600.0, "N m/rad", "reed.stiffness", "stiffness C1 of the spring between shaft and reed";
    fell_stiffness: 7800.0, "N m/rad", "fell.stiffness", "stiffness C2 of the contact";
    shaft_driven_field_inertia: 1.0, "J s^2/(rad)^2", "shaft.driven_field_inertia", "inertia of the field's node; the field sets it";
    shaft_driven_field_force: 0.0, "J/(rad)", "shaft.driven_field_force", "force of the field on its node; the field sets it";
    shaft_driven_u_x_before: 0.0, "rad/m", "shaft.driven_u_x_before", "slope of the field before the port; the field sets it";
    shaft_driven_u_x_after: 0.0, "rad/m", "shaft.driven_u_x_after", "slope of the field after the port; the field sets it";
    shaft_reed_field_inertia: 1.0, "J s^2/(rad)^2", "shaft.reed_field_inertia", "inertia of the field's node; the field sets it";
    shaft_reed_field_force: 0.0, "J/(rad)", "shaft.reed_field_force", "force of the field on its node; the field sets it";
    shaft_reed_u_x_before: 0.0, "rad/m", "shaft.reed_u_x_before", "slope of the field before the port; the field sets it";
    shaft_reed_u_x_after: 0.0, "rad/m", "shaft.reed_u_x_after", "slope of the field after the port; the field sets it";
    shaft_middle_field_inertia: 1.0, "J s^2/(rad)^2", "shaft.middle_field_inertia", "inertia of the field's node; the field sets it";
    shaft_middle_field_force: 0.0, "J/(rad)", "shaft.middle_field_force", "force of the field on its node; the field sets it";
    shaft_middle_u_x_before: 0.0, "rad/m", "shaft.middle_u_x_before", "slope of the field before the port; the field sets it";
    shaft_middle_u_x_after: 0.0, "rad/m", "shaft.middle_u_x_after", "slope of the field after the port; the field sets it";
}

::machinist_contract::outputs! {
    motor_speed: "rad/s", "motor_speed", "rate of rotor angle";
    crank_speed: "rad/s", "crank_speed", "rate of angle of the crank";
    drive_angle: "rad", "drive_angle", "prescribed angle of the drive spring";
    shaft_angle: "rad", "shaft_angle", "angle of the section, at port reed";
    reed_angle: "rad", "reed_angle", "angle of the reed";
    stress_before: "Pa", "stress_before", "shear stress at the surface, on the driven side of the reed";
    stress_after: "Pa", "stress_after", "shear stress at the surface, beyond the reed";
    motor_torque: "N m", "motor_torque", "electromagnetic torque";
}

::machinist_contract::states! {
    MOTOR_PHI: position, 150.0, "rad", "motor.phi", "rotor angle";
    CRANK_TURN: position, 10.0, "rad", "crank.turn", "angle of the crank";
    SHAFT_DRIVEN: position, 1.0, "rad", "shaft.driven", "angle of the section, at port driven";
    SHAFT_REED: position, 1.0, "rad", "shaft.reed", "angle of the section, at port reed";
    SHAFT_MIDDLE: position, 1.0, "rad", "shaft.middle", "angle of the section, at port middle";
    REED_ANGLE: position, 1.0, "rad", "reed.angle", "angle of the reed";
    MOTOR_OMEGA: velocity, 78.5, "rad/s", "motor.omega", "rate of rotor angle";
    CRANK_TURN_SPEED: velocity, 10.0, "rad/s", "crank.turn_speed", "rate of angle of the crank";
    SHAFT_DRIVEN_DOT: velocity, 100.0, "rad/s", "shaft.driven_dot", "rate of angle of the section, at port driven";
    SHAFT_REED_DOT: velocity, 100.0, "rad/s", "shaft.reed_dot", "rate of angle of the section, at port reed";
    SHAFT_MIDDLE_DOT: velocity, 100.0, "rad/s", "shaft.middle_dot", "rate of angle of the section, at port middle";
    REED_SPEED: velocity, 100.0, "rad/s", "reed.speed", "rate of angle of the reed";
    MOTOR_PSI_SX: first_order, 1.0, "V s", "motor.psi_sx", "stator flux linkage along x";
    MOTOR_PSI_SY: first_order, 1.0, "V s", "motor.psi_sy", "stator flux linkage along y";
    MOTOR_PSI_RX: first_order, 1.0, "V s", "motor.psi_rx", "rotor flux linkage along x";
    MOTOR_PSI_RY: first_order, 1.0, "V s", "motor.psi_ry", "rotor flux linkage along y";
}

::machinist_contract::patterns! {
    /// Nonzeros of M.
    MASS_MATRIX_PATTERN: 6 by 6 { 0 [0] 1 [1] 2 [2] 3 [3] 4 [4] 5 [5] }
    /// Nonzeros of dy'/dy.
    RATE_JACOBIAN_PATTERN: 16 by 16 { 0 [6] 1 [7] 2 [8] 3 [9] 4 [10] 5 [11] 6 [0 1 6 7 12 13 14 15]
        7 [0 1 2 6 7] 8 [1 2] 9 [3 5] 11 [3 5] 12 [12 13 14] 13 [12 13 15] 14 [6 12 14 15]
        15 [6 13 14 15] }
    /// Nonzeros of dy'/dp.
    PARAMETER_JACOBIAN_PATTERN: 16 by 39 { 6 [0 2 4 5 6 7 10 11 12] 7 [10 11 12 13 14 15 16]
        8 [14 15 27 28] 9 [25 31 32] 10 [35 36] 11 [23 24 25 26] 12 [1 2 3 6 8] 13 [1 2 3 6 8]
        14 [2 4 5 9] 15 [2 4 5 9] }
}

::machinist_contract::constants! {
    motor_omega_0, motor_u_x, motor_u_y, t2, inverse_motor_inertia, inverse_crank_inertia,
    inverse_shaft_driven_field_inertia, inverse_shaft_reed_field_inertia,
    inverse_shaft_middle_field_inertia, t3, t4, crank_ratio_times_crank_stiffness, t5,
    motor_alpha_s_times_motor_omega_0, motor_alpha_r_times_motor_omega_0,
    crank_turn_speed_dot_by_motor_phi, motor_omega_dot_by_motor_phi, t6, t7,
    motor_omega_dot_by_crank_turn, shaft_driven_dot_dot_by_shaft_driven,
    reed_speed_dot_by_shaft_reed, t8, shaft_reed_dot_dot_by_shaft_reed,
    reed_speed_dot_by_reed_angle, crank_turn_speed_dot_by_motor_omega,
    motor_omega_dot_by_motor_omega, crank_turn_speed_dot_by_crank_turn_speed,
    motor_omega_dot_by_crank_turn_speed, motor_psi_sx_dot_by_motor_psi_sx,
    motor_psi_sy_dot_by_motor_psi_sx, motor_psi_rx_dot_by_motor_psi_sx,
    motor_psi_sx_dot_by_motor_psi_rx, motor_psi_rx_dot_by_motor_psi_rx, reed_arm_squared, t9, t10,
    t11, t12, t13, minus_motor_u_y, t14, motor_k_r_over_motor_sigma, t15,
    motor_k_s_over_motor_sigma, t16, t17, t18, t19
}

::machinist_contract::field_scene! {
    LoomDrive: jacobian_reads_forces false;
    0 shaft_u: linear true, local true, forces [Zero, Varying], derivatives [Zero, Zero, Zero,
        Zero, Zero, Constant, Zero, Constant], scale [1.0, 100.0], fixed [false, false],
        length 1.75, elements 8, order 4;
    value "rad", "shaft.u", "angle of the section";
    rate "rad/s", "shaft.u_dot", "rate of angle of the section";
    slope "rad/m", "shaft.u_x", "slope of angle of the section";
    at 0.0 => Start, coordinate Some(2), handed 27;
    at 1.0 => Inside, coordinate Some(3), handed 31;
    at 1.75 => End, coordinate Some(4), handed 35;
}

/// Returns the constants of `rate` and its Jacobians from the parameters. 79 operations.
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
    let reed_arm_squared = p.reed_arm * p.reed_arm;
    let inverse_motor_inertia = R::literal(1.0) / p.motor_inertia;
    let inverse_crank_inertia = R::literal(1.0) / p.crank_inertia;
    let inverse_shaft_driven_field_inertia = R::literal(1.0) / p.shaft_driven_field_inertia;
    let inverse_shaft_reed_field_inertia = R::literal(1.0) / p.shaft_reed_field_inertia;
    let inverse_shaft_middle_field_inertia = R::literal(1.0) / p.shaft_middle_field_inertia;
    let t3 = R::literal(1.0) / (p.reed_mass * reed_arm_squared);
    let t4 = p.coupling_stiffness * p.coupling_ratio;
    let crank_ratio_times_crank_stiffness = p.crank_ratio * p.crank_stiffness;
    let t5 = p.coupling_damping * p.coupling_ratio;
    let motor_alpha_s_times_motor_omega_0 = p.motor_alpha_s * motor_omega_0;
    let motor_alpha_r_times_motor_omega_0 = p.motor_alpha_r * motor_omega_0;
    let crank_turn_speed_dot_by_motor_phi = t4 * inverse_crank_inertia;
    let motor_omega_dot_by_motor_phi = -(p.coupling_stiffness * inverse_motor_inertia);
    let coupling_ratio_squared = p.coupling_ratio * p.coupling_ratio;
    let t6 = p.coupling_stiffness * coupling_ratio_squared;
    let t7 = p.crank_stiffness * (p.crank_ratio * p.crank_ratio);
    let motor_omega_dot_by_crank_turn = t4 * inverse_motor_inertia;
    let shaft_driven_dot_dot_by_shaft_driven = -(p.crank_stiffness
        * inverse_shaft_driven_field_inertia);
    let reed_speed_dot_by_shaft_reed = p.reed_stiffness * t3;
    let t8 = p.reed_stiffness * inverse_shaft_reed_field_inertia;
    let shaft_reed_dot_dot_by_shaft_reed = -t8;
    let reed_speed_dot_by_reed_angle = -((p.reed_stiffness + p.fell_stiffness) * t3);
    let crank_turn_speed_dot_by_motor_omega = t5 * inverse_crank_inertia;
    let motor_omega_dot_by_motor_omega = -(p.coupling_damping * inverse_motor_inertia);
    let crank_turn_speed_dot_by_crank_turn_speed = -(p.crank_drag.add_product(p.coupling_damping,
        coupling_ratio_squared) * inverse_crank_inertia);
    let motor_omega_dot_by_crank_turn_speed = t5 * inverse_motor_inertia;
    let motor_psi_sx_dot_by_motor_psi_sx = -motor_alpha_s_times_motor_omega_0;
    let motor_psi_sy_dot_by_motor_psi_sx = -motor_omega_0;
    let motor_psi_rx_dot_by_motor_psi_sx = p.motor_k_s * p.motor_alpha_r * motor_omega_0;
    let motor_psi_sx_dot_by_motor_psi_rx = p.motor_k_r * p.motor_alpha_s * motor_omega_0;
    let motor_psi_rx_dot_by_motor_psi_rx = -motor_alpha_r_times_motor_omega_0;
    let t9 = R::literal(core::f64::consts::SQRT_2) * cos_motor_supply_phase;
    let t10 = R::literal(core::f64::consts::SQRT_2) * sin_motor_supply_phase;
    let t11 = R::literal(3.0 * core::f64::consts::PI) * p.motor_pole_pairs * p.motor_k_r
        / motor_x_s_times_motor_sigma;
    let t12 = R::literal(core::f64::consts::TAU) * p.motor_alpha_s;
    let t13 = R::literal(core::f64::consts::TAU) * p.motor_alpha_r;
    let minus_motor_u_y = -motor_u_y;
    let t14 = R::literal(1.5) * p.motor_k_r * motor_omega_0 / motor_x_s_times_motor_sigma;
    let motor_k_r_over_motor_sigma = p.motor_k_r / motor_sigma;
    let t15 = t1 * motor_omega_0 / motor_x_s_times_motor_sigma;
    let motor_k_s_over_motor_sigma = p.motor_k_s / motor_sigma;
    let t16 = R::literal(-1.0) / p.motor_x_s;
    let t17 = R::literal(2.0) * p.coupling_stiffness * p.coupling_ratio;
    let t18 = R::literal(2.0) * p.coupling_damping * p.coupling_ratio;
    let t19 = R::literal(-2.0) * p.reed_mass * p.reed_arm;
    Constants { motor_omega_0, motor_u_x, motor_u_y, t2, inverse_motor_inertia,
        inverse_crank_inertia, inverse_shaft_driven_field_inertia,
        inverse_shaft_reed_field_inertia, inverse_shaft_middle_field_inertia, t3, t4,
        crank_ratio_times_crank_stiffness, t5, motor_alpha_s_times_motor_omega_0,
        motor_alpha_r_times_motor_omega_0, crank_turn_speed_dot_by_motor_phi,
        motor_omega_dot_by_motor_phi, t6, t7, motor_omega_dot_by_crank_turn,
        shaft_driven_dot_dot_by_shaft_driven, reed_speed_dot_by_shaft_reed, t8,
        shaft_reed_dot_dot_by_shaft_reed, reed_speed_dot_by_reed_angle,
        crank_turn_speed_dot_by_motor_omega, motor_omega_dot_by_motor_omega,
        crank_turn_speed_dot_by_crank_turn_speed, motor_omega_dot_by_crank_turn_speed,
        motor_psi_sx_dot_by_motor_psi_sx, motor_psi_sy_dot_by_motor_psi_sx,
        motor_psi_rx_dot_by_motor_psi_sx, motor_psi_sx_dot_by_motor_psi_rx,
        motor_psi_rx_dot_by_motor_psi_rx, reed_arm_squared, t9, t10, t11, t12, t13,
        minus_motor_u_y, t14, motor_k_r_over_motor_sigma, t15, motor_k_s_over_motor_sigma, t16,
        t17, t18, t19 }
}

/// State at the start of the run, in the units of the states. No operations.
#[must_use]
pub fn initial_state<R: Real>(_p: &Parameters<R>) -> [R; STATES] {
    [R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0),
        R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0),
        R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0),
        R::literal(0.0)]
}

/// Times of known jumps of the right-hand side \[s\], unsorted. No operations.
#[must_use]
pub fn discontinuities<R: Real>(_p: &Parameters<R>) -> [R; DISCONTINUITIES] {
    []
}

/// As `rate`, with the constants of the parameters from `prepare`. 61 operations.
#[must_use]
#[inline]
pub fn prepared_rate<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>,
        c: &Constants<R>) -> [R; STATES] {
    let [motor_phi, crank_turn, shaft_driven, shaft_reed, _, reed_angle, motor_omega,
        crank_turn_speed, shaft_driven_dot, shaft_reed_dot, shaft_middle_dot, reed_speed,
        motor_psi_sx, motor_psi_sy, motor_psi_rx, motor_psi_ry] = *state;
    let (sin_crank_turn, cos_crank_turn) = crank_turn.sin_cos();
    let fell_torque = p.fell_stiffness * reed_angle;
    let crank_angle = p.crank_ratio * sin_crank_turn;
    let coupling_twist = motor_phi.sub_product(p.coupling_ratio, crank_turn);
    let coupling_twist_rate = motor_omega.sub_product(p.coupling_ratio, crank_turn_speed);
    let motor_slip_speed = c.motor_omega_0.sub_product(p.motor_pole_pairs, motor_omega);
    let coupling_torque = (p.coupling_stiffness * coupling_twist).add_product(p.coupling_damping,
        coupling_twist_rate);
    let motor_torque = c.t2 * (motor_psi_sy * motor_psi_rx).sub_product(motor_psi_sx, motor_psi_ry);
    let shaft_driven_minus_crank_angle = shaft_driven - crank_angle;
    let t0 = p.reed_stiffness * (shaft_reed - reed_angle);
    let reed_speed_dot = (t0 - fell_torque) * c.t3;
    let shaft_middle_dot_dot = p.shaft_middle_field_force * c.inverse_shaft_middle_field_inertia;
    let shaft_reed_dot_dot = (p.shaft_reed_field_force - t0) * c.inverse_shaft_reed_field_inertia;
    let shaft_driven_dot_dot = p.shaft_driven_field_force.sub_product(p.crank_stiffness,
        shaft_driven_minus_crank_angle) * c.inverse_shaft_driven_field_inertia;
    let crank_turn_speed_dot = ((c.t4 * coupling_twist)
        .add_product(c.crank_ratio_times_crank_stiffness * shaft_driven_minus_crank_angle,
        cos_crank_turn) - (p.crank_drag * crank_turn_speed).sub_product(c.t5, coupling_twist_rate))
        * c.inverse_crank_inertia;
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
    [motor_omega, crank_turn_speed, shaft_driven_dot, shaft_reed_dot, shaft_middle_dot, reed_speed,
        motor_omega_dot, crank_turn_speed_dot, shaft_driven_dot_dot, shaft_reed_dot_dot,
        shaft_middle_dot_dot, reed_speed_dot, motor_psi_sx_dot, motor_psi_sy_dot, motor_psi_rx_dot,
        motor_psi_ry_dot]
}

/// `M = d2L/dq'2`, values in the order of its pattern. 2 operations.
#[must_use]
pub fn mass_matrix<R: Real>(_time: R, _state: &[R; STATES], p: &Parameters<R>) -> [R; 6] {
    [p.motor_inertia, p.crank_inertia, p.shaft_driven_field_inertia, p.shaft_reed_field_inertia,
        p.shaft_middle_field_inertia, p.reed_mass * (p.reed_arm * p.reed_arm)]
}

/// `f` of `M q'' = f + G^T lambda`, one for each coordinate. 42 operations.
#[must_use]
pub fn forcing<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>) -> [R; COORDINATES] {
    let [motor_phi, crank_turn, shaft_driven, shaft_reed, _, reed_angle, motor_omega,
        crank_turn_speed, _, _, _, _, motor_psi_sx, motor_psi_sy, motor_psi_rx, motor_psi_ry]
        = *state;
    let (sin_crank_turn, cos_crank_turn) = crank_turn.sin_cos();
    let fell_torque = p.fell_stiffness * reed_angle;
    let motor_omega_0 = R::literal(core::f64::consts::TAU) * p.motor_supply_frequency;
    let crank_angle = p.crank_ratio * sin_crank_turn;
    let motor_sigma = R::literal(1.0).sub_product(p.motor_k_s, p.motor_k_r);
    let coupling_twist = motor_phi.sub_product(p.coupling_ratio, crank_turn);
    let coupling_twist_rate = motor_omega.sub_product(p.coupling_ratio, crank_turn_speed);
    let coupling_torque = (p.coupling_stiffness * coupling_twist).add_product(p.coupling_damping,
        coupling_twist_rate);
    let motor_torque = R::literal(1.5) * p.motor_pole_pairs * p.motor_k_r * motor_omega_0
        / (p.motor_x_s * motor_sigma) * (motor_psi_sy * motor_psi_rx).sub_product(motor_psi_sx,
        motor_psi_ry);
    let motor_phi_forcing = motor_torque - coupling_torque;
    let shaft_driven_minus_crank_angle = shaft_driven - crank_angle;
    let crank_turn_forcing = (p.coupling_stiffness * p.coupling_ratio * coupling_twist)
        .add_product(p.crank_ratio * p.crank_stiffness * shaft_driven_minus_crank_angle,
        cos_crank_turn) - (p.crank_drag * crank_turn_speed).sub_product(p.coupling_damping
        * p.coupling_ratio, coupling_twist_rate);
    let shaft_driven_forcing = p.shaft_driven_field_force.sub_product(p.crank_stiffness,
        shaft_driven_minus_crank_angle);
    let t0 = p.reed_stiffness * (shaft_reed - reed_angle);
    let shaft_reed_forcing = p.shaft_reed_field_force - t0;
    let reed_angle_forcing = t0 - fell_torque;
    [motor_phi_forcing, crank_turn_forcing, shaft_driven_forcing, shaft_reed_forcing,
        p.shaft_middle_field_force, reed_angle_forcing]
}

/// As `rate_jacobian`, with the constants of the parameters from `prepare`. 31 operations.
#[must_use]
pub fn prepared_rate_jacobian<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>,
        c: &Constants<R>) -> [R; 39] {
    let [_, crank_turn, shaft_driven, _, _, _, motor_omega, _, _, _, _, _, motor_psi_sx,
        motor_psi_sy, motor_psi_rx, motor_psi_ry] = *state;
    let (sin_crank_turn, cos_crank_turn) = crank_turn.sin_cos();
    let crank_angle = p.crank_ratio * sin_crank_turn;
    let motor_pole_pairs_times_motor_omega = p.motor_pole_pairs * motor_omega;
    let motor_slip_speed = c.motor_omega_0 - motor_pole_pairs_times_motor_omega;
    let t0 = c.crank_ratio_times_crank_stiffness * cos_crank_turn;
    let shaft_driven_dot_dot_by_crank_turn = t0 * c.inverse_shaft_driven_field_inertia;
    let crank_turn_speed_dot_by_crank_turn = -(c.t6.add_product(p.crank_stiffness * crank_angle,
        shaft_driven - crank_angle).add_product(c.t7, cos_crank_turn * cos_crank_turn)
        * c.inverse_crank_inertia);
    let crank_turn_speed_dot_by_shaft_driven = t0 * c.inverse_crank_inertia;
    let motor_psi_rx_dot_by_motor_omega = -(p.motor_pole_pairs * motor_psi_ry);
    let motor_psi_ry_dot_by_motor_omega = p.motor_pole_pairs * motor_psi_rx;
    let motor_omega_dot_by_motor_psi_sx = -(c.t2 * motor_psi_ry * c.inverse_motor_inertia);
    let motor_omega_dot_by_motor_psi_sy = c.t2 * motor_psi_rx * c.inverse_motor_inertia;
    let motor_omega_dot_by_motor_psi_rx = c.t2 * motor_psi_sy * c.inverse_motor_inertia;
    let motor_psi_ry_dot_by_motor_psi_rx = motor_pole_pairs_times_motor_omega - c.motor_omega_0;
    let motor_omega_dot_by_motor_psi_ry = -(c.t2 * motor_psi_sx * c.inverse_motor_inertia);
    [R::literal(1.0), R::literal(1.0), R::literal(1.0), R::literal(1.0), R::literal(1.0),
        R::literal(1.0), c.motor_omega_dot_by_motor_phi, c.motor_omega_dot_by_crank_turn,
        c.motor_omega_dot_by_motor_omega, c.motor_omega_dot_by_crank_turn_speed,
        motor_omega_dot_by_motor_psi_sx, motor_omega_dot_by_motor_psi_sy,
        motor_omega_dot_by_motor_psi_rx, motor_omega_dot_by_motor_psi_ry,
        c.crank_turn_speed_dot_by_motor_phi, crank_turn_speed_dot_by_crank_turn,
        crank_turn_speed_dot_by_shaft_driven, c.crank_turn_speed_dot_by_motor_omega,
        c.crank_turn_speed_dot_by_crank_turn_speed, shaft_driven_dot_dot_by_crank_turn,
        c.shaft_driven_dot_dot_by_shaft_driven, c.shaft_reed_dot_dot_by_shaft_reed, c.t8,
        c.reed_speed_dot_by_shaft_reed, c.reed_speed_dot_by_reed_angle,
        c.motor_psi_sx_dot_by_motor_psi_sx, c.motor_omega_0, c.motor_psi_sx_dot_by_motor_psi_rx,
        c.motor_psi_sy_dot_by_motor_psi_sx, c.motor_psi_sx_dot_by_motor_psi_sx,
        c.motor_psi_sx_dot_by_motor_psi_rx, motor_psi_rx_dot_by_motor_omega,
        c.motor_psi_rx_dot_by_motor_psi_sx, c.motor_psi_rx_dot_by_motor_psi_rx, motor_slip_speed,
        motor_psi_ry_dot_by_motor_omega, c.motor_psi_rx_dot_by_motor_psi_sx,
        motor_psi_ry_dot_by_motor_psi_rx, c.motor_psi_rx_dot_by_motor_psi_rx]
}

/// As `parameter_jacobian`, with the constants of the parameters from `prepare`. 136 operations.
#[must_use]
pub fn prepared_parameter_jacobian<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>,
        c: &Constants<R>) -> [R; 47] {
    let [motor_phi, crank_turn, shaft_driven, shaft_reed, _, reed_angle, motor_omega,
        crank_turn_speed, _, _, _, _, motor_psi_sx, motor_psi_sy, motor_psi_rx, motor_psi_ry]
        = *state;
    let (sin_crank_turn, cos_crank_turn) = crank_turn.sin_cos();
    let fell_torque = p.fell_stiffness * reed_angle;
    let crank_angle = p.crank_ratio * sin_crank_turn;
    let coupling_ratio_times_crank_turn = p.coupling_ratio * crank_turn;
    let coupling_twist = motor_phi - coupling_ratio_times_crank_turn;
    let t0 = p.coupling_ratio * crank_turn_speed;
    let coupling_twist_rate = motor_omega - t0;
    let coupling_torque = (p.coupling_stiffness * coupling_twist).add_product(p.coupling_damping,
        coupling_twist_rate);
    let t1 = motor_psi_sx.sub_product(p.motor_k_r, motor_psi_rx);
    let t2 = motor_psi_sy.sub_product(p.motor_k_r, motor_psi_ry);
    let t3 = (motor_psi_sy * motor_psi_rx).sub_product(motor_psi_sx, motor_psi_ry);
    let motor_torque = c.t2 * t3;
    let shaft_driven_minus_crank_angle = shaft_driven - crank_angle;
    let shaft_reed_minus_reed_angle = shaft_reed - reed_angle;
    let t4 = p.reed_stiffness * shaft_reed_minus_reed_angle;
    let reed_speed_dot = (t4 - fell_torque) * c.t3;
    let shaft_middle_dot_dot = p.shaft_middle_field_force * c.inverse_shaft_middle_field_inertia;
    let shaft_reed_dot_dot = (p.shaft_reed_field_force - t4) * c.inverse_shaft_reed_field_inertia;
    let shaft_driven_dot_dot = p.shaft_driven_field_force.sub_product(p.crank_stiffness,
        shaft_driven_minus_crank_angle) * c.inverse_shaft_driven_field_inertia;
    let crank_turn_speed_dot = ((c.t4 * coupling_twist)
        .add_product(c.crank_ratio_times_crank_stiffness * shaft_driven_minus_crank_angle,
        cos_crank_turn) - (p.crank_drag * crank_turn_speed).sub_product(c.t5, coupling_twist_rate))
        * c.inverse_crank_inertia;
    let motor_omega_dot = (motor_torque - coupling_torque) * c.inverse_motor_inertia;
    let t5 = (-motor_psi_rx).add_product(p.motor_k_s, motor_psi_sx);
    let t6 = (-motor_psi_ry).add_product(p.motor_k_s, motor_psi_sy);
    let motor_omega_dot_by_motor_inertia = -(motor_omega_dot * c.inverse_motor_inertia);
    let motor_omega_dot_by_motor_supply_frequency = c.t11 * t3 * c.inverse_motor_inertia;
    let motor_psi_sx_dot_by_motor_supply_frequency = (R::literal(core::f64::consts::TAU)
        * motor_psi_sy).sub_product(c.t12, t1);
    let motor_psi_sy_dot_by_motor_supply_frequency = (R::literal(-6.283_185_307_179_586)
        * motor_psi_sx).sub_product(c.t12, t2);
    let motor_psi_rx_dot_by_motor_supply_frequency = (R::literal(core::f64::consts::TAU)
        * motor_psi_ry).add_product(c.t13, t5);
    let motor_psi_ry_dot_by_motor_supply_frequency = (R::literal(-6.283_185_307_179_586)
        * motor_psi_rx).add_product(c.t13, t6);
    let motor_omega_dot_by_motor_pole_pairs = c.t14 * t3 * c.inverse_motor_inertia;
    let motor_psi_rx_dot_by_motor_pole_pairs = -(motor_omega * motor_psi_ry);
    let motor_psi_ry_dot_by_motor_pole_pairs = motor_omega * motor_psi_rx;
    let motor_omega_dot_by_motor_k_s = c.motor_k_r_over_motor_sigma * motor_torque
        * c.inverse_motor_inertia;
    let motor_psi_rx_dot_by_motor_k_s = c.motor_alpha_r_times_motor_omega_0 * motor_psi_sx;
    let motor_psi_ry_dot_by_motor_k_s = c.motor_alpha_r_times_motor_omega_0 * motor_psi_sy;
    let motor_omega_dot_by_motor_k_r = (c.t15 * t3).add_product(c.motor_k_s_over_motor_sigma,
        motor_torque) * c.inverse_motor_inertia;
    let motor_psi_sx_dot_by_motor_k_r = c.motor_alpha_s_times_motor_omega_0 * motor_psi_rx;
    let motor_psi_sy_dot_by_motor_k_r = c.motor_alpha_s_times_motor_omega_0 * motor_psi_ry;
    let motor_omega_dot_by_motor_x_s = c.t16 * motor_torque * c.inverse_motor_inertia;
    let motor_psi_sx_dot_by_motor_alpha_s = -(c.motor_omega_0 * t1);
    let motor_psi_sy_dot_by_motor_alpha_s = -(c.motor_omega_0 * t2);
    let motor_psi_rx_dot_by_motor_alpha_r = c.motor_omega_0 * t5;
    let motor_psi_ry_dot_by_motor_alpha_r = c.motor_omega_0 * t6;
    let crank_turn_speed_dot_by_coupling_stiffness = p.coupling_ratio * coupling_twist
        * c.inverse_crank_inertia;
    let motor_omega_dot_by_coupling_stiffness = (coupling_ratio_times_crank_turn - motor_phi)
        * c.inverse_motor_inertia;
    let crank_turn_speed_dot_by_coupling_damping = p.coupling_ratio * coupling_twist_rate
        * c.inverse_crank_inertia;
    let motor_omega_dot_by_coupling_damping = (t0 - motor_omega) * c.inverse_motor_inertia;
    let crank_turn_speed_dot_by_coupling_ratio = (p.coupling_stiffness * motor_phi)
        .add_product(p.coupling_damping, motor_omega).sub_product(c.t17, crank_turn)
        .sub_product(c.t18, crank_turn_speed) * c.inverse_crank_inertia;
    let motor_omega_dot_by_coupling_ratio = (p.coupling_stiffness * crank_turn)
        .add_product(p.coupling_damping, crank_turn_speed) * c.inverse_motor_inertia;
    let crank_turn_speed_dot_by_crank_inertia = -(crank_turn_speed_dot * c.inverse_crank_inertia);
    let shaft_driven_dot_dot_by_crank_ratio = p.crank_stiffness * sin_crank_turn
        * c.inverse_shaft_driven_field_inertia;
    let crank_turn_speed_dot_by_crank_ratio = p.crank_stiffness * shaft_driven
        .sub_product(R::literal(2.0), crank_angle) * cos_crank_turn * c.inverse_crank_inertia;
    let shaft_driven_dot_dot_by_crank_stiffness = (crank_angle - shaft_driven)
        * c.inverse_shaft_driven_field_inertia;
    let crank_turn_speed_dot_by_crank_stiffness = p.crank_ratio * shaft_driven_minus_crank_angle
        * cos_crank_turn * c.inverse_crank_inertia;
    let crank_turn_speed_dot_by_crank_drag = -(crank_turn_speed * c.inverse_crank_inertia);
    let reed_speed_dot_by_reed_mass = -(c.reed_arm_squared * reed_speed_dot * c.t3);
    let reed_speed_dot_by_reed_arm = c.t19 * reed_speed_dot * c.t3;
    let reed_speed_dot_by_reed_stiffness = shaft_reed_minus_reed_angle * c.t3;
    let shaft_reed_dot_dot_by_reed_stiffness = (reed_angle - shaft_reed)
        * c.inverse_shaft_reed_field_inertia;
    let reed_speed_dot_by_fell_stiffness = -(reed_angle * c.t3);
    let shaft_driven_dot_dot_by_shaft_driven_field_inertia = -(shaft_driven_dot_dot
        * c.inverse_shaft_driven_field_inertia);
    let shaft_reed_dot_dot_by_shaft_reed_field_inertia = -(shaft_reed_dot_dot
        * c.inverse_shaft_reed_field_inertia);
    let shaft_middle_dot_dot_by_shaft_middle_field_inertia = -(shaft_middle_dot_dot
        * c.inverse_shaft_middle_field_inertia);
    [motor_omega_dot_by_motor_inertia, motor_omega_dot_by_motor_supply_frequency,
        motor_omega_dot_by_motor_pole_pairs, motor_omega_dot_by_motor_k_s,
        motor_omega_dot_by_motor_k_r, motor_omega_dot_by_motor_x_s,
        motor_omega_dot_by_coupling_stiffness, motor_omega_dot_by_coupling_damping,
        motor_omega_dot_by_coupling_ratio, crank_turn_speed_dot_by_coupling_stiffness,
        crank_turn_speed_dot_by_coupling_damping, crank_turn_speed_dot_by_coupling_ratio,
        crank_turn_speed_dot_by_crank_inertia, crank_turn_speed_dot_by_crank_ratio,
        crank_turn_speed_dot_by_crank_stiffness, crank_turn_speed_dot_by_crank_drag,
        shaft_driven_dot_dot_by_crank_ratio, shaft_driven_dot_dot_by_crank_stiffness,
        shaft_driven_dot_dot_by_shaft_driven_field_inertia, c.inverse_shaft_driven_field_inertia,
        shaft_reed_dot_dot_by_reed_stiffness, shaft_reed_dot_dot_by_shaft_reed_field_inertia,
        c.inverse_shaft_reed_field_inertia, shaft_middle_dot_dot_by_shaft_middle_field_inertia,
        c.inverse_shaft_middle_field_inertia, reed_speed_dot_by_reed_mass,
        reed_speed_dot_by_reed_arm, reed_speed_dot_by_reed_stiffness,
        reed_speed_dot_by_fell_stiffness, c.t9, motor_psi_sx_dot_by_motor_supply_frequency,
        c.minus_motor_u_y, motor_psi_sx_dot_by_motor_k_r, motor_psi_sx_dot_by_motor_alpha_s, c.t10,
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
        R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0),
        R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0),
        R::literal(0.0)]
}

/// Wanted outputs. 17 operations.
#[must_use]
pub fn outputs<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>) -> Outputs<R> {
    let [_, crank_turn, _, shaft_reed, _, reed_angle, motor_omega, crank_turn_speed, _, _, _, _,
        motor_psi_sx, motor_psi_sy, motor_psi_rx, motor_psi_ry] = *state;
    let motor_omega_0 = R::literal(core::f64::consts::TAU) * p.motor_supply_frequency;
    let crank_angle = p.crank_ratio * crank_turn.sin();
    let motor_sigma = R::literal(1.0).sub_product(p.motor_k_s, p.motor_k_r);
    let motor_torque = R::literal(1.5) * p.motor_pole_pairs * p.motor_k_r * motor_omega_0
        / (p.motor_x_s * motor_sigma) * (motor_psi_sy * motor_psi_rx).sub_product(motor_psi_sx,
        motor_psi_ry);
    let t0 = p.shaft_radius * p.shaft_shear_modulus;
    Outputs {
        motor_speed: motor_omega,
        crank_speed: crank_turn_speed,
        drive_angle: crank_angle,
        shaft_angle: shaft_reed,
        reed_angle,
        stress_before: t0 * p.shaft_reed_u_x_before,
        stress_after: t0 * p.shaft_reed_u_x_after,
        motor_torque,
    }
}

/// T, V and the energy of first-order states \[J\]. 75 operations.
#[must_use]
pub fn energy<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>) -> Energy<R> {
    let [motor_phi, crank_turn, shaft_driven, shaft_reed, _, reed_angle, motor_omega,
        crank_turn_speed, shaft_driven_dot, shaft_reed_dot, shaft_middle_dot, reed_speed,
        motor_psi_sx, motor_psi_sy, motor_psi_rx, motor_psi_ry] = *state;
    let fell_torque = p.fell_stiffness * reed_angle;
    let motor_omega_0 = R::literal(core::f64::consts::TAU) * p.motor_supply_frequency;
    let crank_angle = p.crank_ratio * crank_turn.sin();
    let motor_sigma = R::literal(1.0).sub_product(p.motor_k_s, p.motor_k_r);
    let motor_x_r = p.motor_k_s * p.motor_x_s / p.motor_k_r;
    let coupling_twist = motor_phi.sub_product(p.coupling_ratio, crank_turn);
    let t0 = motor_omega_0 / (p.motor_x_s * motor_sigma);
    let motor_i_sx = t0 * motor_psi_sx.sub_product(p.motor_k_r, motor_psi_rx);
    let motor_i_sy = t0 * motor_psi_sy.sub_product(p.motor_k_r, motor_psi_ry);
    let t1 = motor_omega_0 / (motor_sigma * motor_x_r);
    let motor_i_rx = t1 * motor_psi_rx.sub_product(p.motor_k_s, motor_psi_sx);
    let motor_i_ry = t1 * motor_psi_ry.sub_product(p.motor_k_s, motor_psi_sy);
    let shaft_driven_minus_crank_angle = shaft_driven - crank_angle;
    let shaft_reed_minus_reed_angle = shaft_reed - reed_angle;
    Energy {
        kinetic: (R::literal(0.5) * p.motor_inertia * (motor_omega * motor_omega))
            .add_product(R::literal(0.5) * p.crank_inertia, crank_turn_speed * crank_turn_speed)
            .add_product(R::literal(0.5) * p.reed_mass * (p.reed_arm * p.reed_arm), reed_speed
            * reed_speed).add_product(R::literal(0.5) * p.shaft_driven_field_inertia,
            shaft_driven_dot * shaft_driven_dot).add_product(R::literal(0.5)
            * p.shaft_reed_field_inertia, shaft_reed_dot * shaft_reed_dot)
            .add_product(R::literal(0.5) * p.shaft_middle_field_inertia, shaft_middle_dot
            * shaft_middle_dot),
        potential: (R::literal(0.5) * reed_angle * fell_torque).add_product(R::literal(0.5)
            * p.coupling_stiffness, coupling_twist * coupling_twist).add_product(R::literal(0.5)
            * p.crank_stiffness, shaft_driven_minus_crank_angle * shaft_driven_minus_crank_angle)
            .add_product(R::literal(0.5) * p.reed_stiffness, shaft_reed_minus_reed_angle
            * shaft_reed_minus_reed_angle),
        stored: R::literal(0.75) * (motor_psi_sx * motor_i_sx).add_product(motor_psi_sy, motor_i_sy)
            .add_product(motor_psi_rx, motor_i_rx).add_product(motor_psi_ry, motor_i_ry),
    }
}

/// `dE/dt`, power supplied and power dissipated \[W\]. 185 operations.
#[must_use]
pub fn power_balance<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>) -> PowerBalance<R> {
    let [motor_phi, crank_turn, shaft_driven, shaft_reed, _, reed_angle, motor_omega,
        crank_turn_speed, shaft_driven_dot, shaft_reed_dot, shaft_middle_dot, reed_speed,
        motor_psi_sx, motor_psi_sy, motor_psi_rx, motor_psi_ry] = *state;
    let [(sin_crank_turn, cos_crank_turn), (sin_motor_supply_phase, cos_motor_supply_phase)]
        = R::sin_cos_each([crank_turn, p.motor_supply_phase]);
    let fell_torque = p.fell_stiffness * reed_angle;
    let motor_omega_0 = R::literal(core::f64::consts::TAU) * p.motor_supply_frequency;
    let crank_angle = p.crank_ratio * sin_crank_turn;
    let motor_sigma = R::literal(1.0).sub_product(p.motor_k_s, p.motor_k_r);
    let motor_x_r = p.motor_k_s * p.motor_x_s / p.motor_k_r;
    let t0 = p.motor_phase_voltage * R::literal(core::f64::consts::SQRT_2);
    let motor_u_x = t0 * cos_motor_supply_phase;
    let motor_u_y = t0 * sin_motor_supply_phase;
    let coupling_twist = motor_phi.sub_product(p.coupling_ratio, crank_turn);
    let coupling_twist_rate = motor_omega.sub_product(p.coupling_ratio, crank_turn_speed);
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
    let reed_mass_times_reed_arm_squared = p.reed_mass * (p.reed_arm * p.reed_arm);
    let shaft_driven_minus_crank_angle = shaft_driven - crank_angle;
    let t6 = (p.coupling_stiffness * p.coupling_ratio * coupling_twist).add_product(p.crank_ratio
        * p.crank_stiffness * shaft_driven_minus_crank_angle, cos_crank_turn);
    let t7 = (p.crank_drag * crank_turn_speed).sub_product(p.coupling_damping * p.coupling_ratio,
        coupling_twist_rate);
    let t8 = p.crank_stiffness * shaft_driven_minus_crank_angle;
    let t9 = p.reed_stiffness * (shaft_reed - reed_angle);
    let reed_speed_dot = (t9 - fell_torque) * (R::literal(1.0) / reed_mass_times_reed_arm_squared);
    let shaft_middle_dot_dot = p.shaft_middle_field_force * (R::literal(1.0)
        / p.shaft_middle_field_inertia);
    let shaft_reed_dot_dot = (p.shaft_reed_field_force - t9) * (R::literal(1.0)
        / p.shaft_reed_field_inertia);
    let shaft_driven_dot_dot = (p.shaft_driven_field_force - t8) * (R::literal(1.0)
        / p.shaft_driven_field_inertia);
    let crank_turn_speed_dot = (t6 - t7) * (R::literal(1.0) / p.crank_inertia);
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
    let t10 = p.motor_k_r * motor_omega_0 / motor_x_s_times_motor_sigma;
    let t11 = (t1 * motor_omega).sub_product(t6, crank_turn_speed).add_product(t8, shaft_driven_dot)
        .add_product(t9, shaft_reed_dot).add_product(fell_torque - t9, reed_speed)
        .add_product(p.motor_inertia * motor_omega, motor_omega_dot).add_product(p.crank_inertia
        * crank_turn_speed, crank_turn_speed_dot).add_product(shaft_driven_dot
        * p.shaft_driven_field_inertia, shaft_driven_dot_dot).add_product(shaft_reed_dot
        * p.shaft_reed_field_inertia, shaft_reed_dot_dot).add_product(shaft_middle_dot
        * p.shaft_middle_field_inertia, shaft_middle_dot_dot)
        .add_product(reed_mass_times_reed_arm_squared * reed_speed, reed_speed_dot)
        .add_product(R::literal(0.75) * motor_i_sx.add_product(t3, motor_psi_sx).sub_product(t10,
        motor_psi_rx), motor_psi_sx_dot);
    PowerBalance {
        stored_rate: t11.add_product(R::literal(0.75) * motor_i_sy.add_product(t3, motor_psi_sy)
            .sub_product(t10, motor_psi_ry), motor_psi_sy_dot).add_product(R::literal(0.75)
            * motor_i_rx.add_product(t5, motor_psi_rx).sub_product(t10, motor_psi_sx),
            motor_psi_rx_dot).add_product(R::literal(0.75) * motor_i_ry.add_product(t5,
            motor_psi_ry).sub_product(t10, motor_psi_sy), motor_psi_ry_dot),
        supplied: (shaft_driven_dot * p.shaft_driven_field_force).add_product(R::literal(1.5),
            (motor_u_x * motor_i_sx).add_product(motor_u_y, motor_i_sy))
            .add_product(shaft_reed_dot, p.shaft_reed_field_force).add_product(shaft_middle_dot,
            p.shaft_middle_field_force),
        dissipated: (p.coupling_damping * motor_omega * coupling_twist_rate)
            .add_product(R::literal(1.5), (p.motor_x_s * p.motor_alpha_s * motor_sigma
            * (motor_i_sx * motor_i_sx).add_product(motor_i_sy, motor_i_sy))
            .add_product(p.motor_alpha_r * motor_sigma * motor_x_r, (motor_i_rx * motor_i_rx)
            .add_product(motor_i_ry, motor_i_ry))).add_product(crank_turn_speed, t7),
    }
}

/// The field shaft.u: angle of the section \[rad\].
///
/// One generic element: what acts at a point with u, u_x, u_t, u_xt at x. The loops over elements are the contract's.
pub mod shaft_u {
    #[allow(
        clippy::wildcard_imports,
        unused_imports,
        reason = "what a field needs of it"
    )]
    use super::*;
    /// Parameters that the field depends on.
    pub const PARAMETERS: [u32; 6] = [17, 18, 19, 20, 21, 22];
    /// m, the inertia a length. 4 operations.
    #[must_use]
    #[inline(always)]
    pub fn inertia<R: Real>(_x: R, p: &Parameters<R>) -> [R; 1] {
        let shaft_radius_squared = p.shaft_radius * p.shaft_radius;
        [R::literal(core::f64::consts::FRAC_PI_2) * p.shaft_density * (shaft_radius_squared
            * shaft_radius_squared)]
    }
    /// dm/dx, then dm/dp of `PARAMETERS`. 6 operations.
    #[must_use]
    #[inline]
    pub fn inertia_gradient<R: Real>(_x: R, p: &Parameters<R>) -> [R; 7] {
        let shaft_radius_squared = p.shaft_radius * p.shaft_radius;
        [R::literal(0.0), R::literal(0.0), R::literal(0.0),
            R::literal(core::f64::consts::TAU) * p.shaft_density * (shaft_radius_squared
            * p.shaft_radius), R::literal(core::f64::consts::FRAC_PI_2) * (shaft_radius_squared
            * shaft_radius_squared), R::literal(0.0), R::literal(0.0)]
    }
    /// Forces a length: f_0 = dL/du - dD/du_t + Q on u, f_1 = dL/du_x - dD/du_xt on u_x. 7 operations.
    #[must_use]
    #[inline]
    pub fn force<R: Real>(_time: R, _x: R, point: &FieldPoint<R>, p: &Parameters<R>) -> [R; 2] {
        let [_, u_x_2, _, u_x_dot] = *point;
        let shaft_radius_squared = p.shaft_radius * p.shaft_radius;
        [R::literal(0.0), R::literal(-1.570_796_326_794_896_6) * p.shaft_shear_modulus
            * (shaft_radius_squared * shaft_radius_squared) * u_x_2
            .add_product(p.shaft_damping_time, u_x_dot)]
    }
    /// Derivatives of f_0, then of f_1, with respect to u, u_x, u_t, u_xt. 8 operations.
    #[must_use]
    #[inline]
    pub fn force_jacobian<R: Real>(_time: R, _x: R, _point: &FieldPoint<R>,
            p: &Parameters<R>) -> [R; 8] {
        let shaft_radius_squared = p.shaft_radius * p.shaft_radius;
        let shaft_radius_squared_squared = shaft_radius_squared * shaft_radius_squared;
        let t0 = R::literal(core::f64::consts::FRAC_PI_2) * p.shaft_shear_modulus;
        [R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0),
            -(t0 * shaft_radius_squared_squared), R::literal(0.0), -(t0 * p.shaft_damping_time
            * shaft_radius_squared_squared)]
    }
    /// Derivatives of f_0 and f_1 with respect to x, to t, then to `PARAMETERS`. 13 operations.
    #[must_use]
    #[inline]
    pub fn force_gradient<R: Real>(_time: R, _x: R, point: &FieldPoint<R>,
            p: &Parameters<R>) -> [R; 16] {
        let [_, u_x_2, _, u_x_dot] = *point;
        let shaft_radius_squared = p.shaft_radius * p.shaft_radius;
        let shaft_radius_squared_squared = shaft_radius_squared * shaft_radius_squared;
        let t0 = u_x_2.add_product(p.shaft_damping_time, u_x_dot);
        [R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0),
            R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0),
            R::literal(-6.283_185_307_179_586) * p.shaft_shear_modulus * (shaft_radius_squared
            * p.shaft_radius) * t0, R::literal(0.0), R::literal(0.0), R::literal(0.0),
            R::literal(-1.570_796_326_794_896_6) * shaft_radius_squared_squared * t0,
            R::literal(0.0), R::literal(-1.570_796_326_794_896_6) * p.shaft_shear_modulus
            * shaft_radius_squared_squared * u_x_dot]
    }
    /// T and V a length \[J/m\]. 10 operations.
    #[must_use]
    #[inline]
    pub fn energy<R: Real>(_time: R, _x: R, point: &FieldPoint<R>, p: &Parameters<R>) -> [R; 2] {
        let [_, u_x_2, u_dot, _] = *point;
        let shaft_radius_squared = p.shaft_radius * p.shaft_radius;
        let shaft_radius_squared_squared = shaft_radius_squared * shaft_radius_squared;
        [R::literal(core::f64::consts::FRAC_PI_4) * p.shaft_density * shaft_radius_squared_squared
            * (u_dot * u_dot), R::literal(core::f64::consts::FRAC_PI_4) * p.shaft_shear_modulus
            * shaft_radius_squared_squared * (u_x_2 * u_x_2)]
    }
    /// Rate of V, power supplied and power dissipated, a length \[W/m\]. 10 operations.
    #[must_use]
    #[inline]
    pub fn power<R: Real>(_time: R, _x: R, point: &FieldPoint<R>, p: &Parameters<R>) -> [R; 3] {
        let [_, u_x_2, _, u_x_dot] = *point;
        let shaft_radius_squared = p.shaft_radius * p.shaft_radius;
        let shaft_radius_squared_squared = shaft_radius_squared * shaft_radius_squared;
        let t0 = R::literal(core::f64::consts::FRAC_PI_2) * p.shaft_shear_modulus;
        [t0 * shaft_radius_squared_squared * u_x_2 * u_x_dot, R::literal(0.0),
            t0 * p.shaft_damping_time * shaft_radius_squared_squared * (u_x_dot * u_x_dot)]
    }
    /// x of the attachments, then the length \[m\]. No operations.
    #[must_use]
    #[inline]
    pub fn places<R: Real>(p: &Parameters<R>) -> [R; 4] {
        [R::literal(0.0), p.shaft_reed_position, p.shaft_length, p.shaft_length]
    }
    /// Derivatives of `places` with respect to `PARAMETERS`, row by row. No operations.
    #[must_use]
    #[inline]
    pub fn places_gradient<R: Real>(_p: &Parameters<R>) -> [R; 24] {
        [R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0),
            R::literal(0.0), R::literal(0.0), R::literal(1.0), R::literal(0.0), R::literal(0.0),
            R::literal(0.0), R::literal(0.0), R::literal(1.0), R::literal(0.0), R::literal(0.0),
            R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(1.0), R::literal(0.0),
            R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0)]
    }
    /// u and u_t at the start. No operations.
    #[must_use]
    #[inline]
    pub fn initial<R: Real>(_x: R, _p: &Parameters<R>) -> [R; 2] {
        [R::literal(0.0), R::literal(0.0)]
    }
    /// f_0 alone, at many points.
    ///
    /// 0 operations for all points, 0 for each.
    pub fn on_value<R: Real>(_time: R, at: &[R], u: &[R], u_t: &[R], _p: &Parameters<R>,
            force: &mut [R]) {
        for (((_, _), _), force) in at.iter().zip(u).zip(u_t).zip(force) {
            *force = R::literal(0.0);
        }
    }
    /// df_0/du and df_0/du_t, at many points.
    ///
    /// 0 operations for all points, 0 for each.
    pub fn on_value_jacobian<R: Real>(_time: R, at: &[R], u: &[R], u_t: &[R], _p: &Parameters<R>,
            by_u: &mut [R], by_u_t: &mut [R]) {
        for ((((_, _), _), by_u), by_u_t) in at.iter().zip(u).zip(u_t).zip(by_u).zip(by_u_t) {
            *by_u = R::literal(0.0);
            *by_u_t = R::literal(0.0);
        }
    }
    /// df_0/dt, at many points.
    ///
    /// 0 operations for all points, 0 for each.
    pub fn on_value_by_time<R: Real>(_time: R, at: &[R], u: &[R], u_t: &[R], _p: &Parameters<R>,
            by_time: &mut [R]) {
        for (((_, _), _), by_time) in at.iter().zip(u).zip(u_t).zip(by_time) {
            *by_time = R::literal(0.0);
        }
    }
    /// f_1 alone, at many points.
    ///
    /// 4 operations for all points, 3 for each.
    pub fn on_slope<R: Real>(u_x: &[R], u_xt: &[R], p: &Parameters<R>, force: &mut [R]) {
        let shaft_radius_squared = p.shaft_radius * p.shaft_radius;
        let t0 = R::literal(-1.570_796_326_794_896_6) * p.shaft_shear_modulus
            * (shaft_radius_squared * shaft_radius_squared);
        for ((&u_x_2, &u_x_dot), force) in u_x.iter().zip(u_xt).zip(force) {
            *force = t0 * u_x_2.add_product(p.shaft_damping_time, u_x_dot);
        }
    }
    /// df_1/du_x and df_1/du_xt, at many points.
    ///
    /// 8 operations for all points, 0 for each.
    pub fn on_slope_jacobian<R: Real>(u_x: &[R], u_xt: &[R], p: &Parameters<R>, by_u_x: &mut [R],
            by_u_xt: &mut [R]) {
        let shaft_radius_squared = p.shaft_radius * p.shaft_radius;
        let shaft_radius_squared_squared = shaft_radius_squared * shaft_radius_squared;
        let t0 = R::literal(core::f64::consts::FRAC_PI_2) * p.shaft_shear_modulus;
        let t1 = -(t0 * shaft_radius_squared_squared);
        let t2 = -(t0 * p.shaft_damping_time * shaft_radius_squared_squared);
        for (((_, _), by_u_x), by_u_xt) in u_x.iter().zip(u_xt).zip(by_u_x).zip(by_u_xt) {
            *by_u_x = t1;
            *by_u_xt = t2;
        }
    }
}

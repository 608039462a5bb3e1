// Emitted by Machinist 0.1.0; do not edit. To make it again:
//
//     cargo run --release -- gen
//
// Sources, with SHA-256:
//   d62769a1e907b40839e02cc16ea36289229b2b7983381a7974cec74a1a8a8fd5  bench/m3.toml
//   03bebde2dcd618fcbd0662a0f5e63f806e09d154c0fc25f1f0527c30944dd55e  units/textile/induction_motor.toml
//   512419e5aa73ad1710ef3556037050e97b898e87a7d5d8a4e9c4b03a7a8b0141  units/coupling.toml
//
// Benchmark M3: motor and torsional shaft of equal pieces
//
// A motor at synchronous speed drives a shaft of equal pieces through the coupling of the saw gin. A
// distributed load engages at 0.15 s. M3:100 has 100 pieces: `shaft.pieces` is 100, and the field has
// one element of order 1 fewer, between the centres of the pieces.
//
// Source:
//   Benchmark models of textile-machine dynamics.
//
// All quantities are in SI units.
// Shapes: coordinates 3, first-order states 4, states 10, parameters 33, outputs 3,
//     discontinuities 1, saturations 2.
// Nonzeros: mass_matrix 3 of 3 by 3, rate_jacobian 30 of 10 by 10, parameter_jacobian 50 of 10 by 33.
// Operations: initial_state 18, discontinuities 6, rate 91, mass_matrix 4, forcing 50,
//     rate_jacobian 88, parameter_jacobian 241, time_derivative 46, energy 50, power_balance 177,
//     saturating_arguments 3, prepare 85, prepared_rate 62, prepared_rate_jacobian 43,
//     prepared_parameter_jacobian 179.

use ::machinist_contract::{Energy, PowerBalance, Real, field::FieldPoint};

::machinist_contract::simulator! {
    /// Benchmark M3: motor and torsional shaft of equal pieces
    ///
    /// A motor at synchronous speed drives a shaft of equal pieces through the coupling of the saw gin. A
    /// distributed load engages at 0.15 s. M3:100 has 100 pieces: \`shaft.pieces\` is 100, and the field has
    /// one element of order 1 fewer, between the centres of the pieces.
    ///
    /// Source: Benchmark models of textile-machine dynamics.
    M3: "m3", "Benchmark M3: motor and torsional shaft of equal pieces";
    run from 0.0, until 0.5, points 501, rtol 1e-8, method "auto";
    quadratures 0, discontinuities 1;
    prepared; jacobians_apart; saturations 2;
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
    shaft_length: 2.322, "m", "shaft.length", "length";
    shaft_pieces: 100.0, "1", "shaft.pieces", "number of pieces";
    shaft_inertia: 1.244, "kg m^2", "shaft.inertia", "moment of inertia";
    shaft_shear_modulus: 8e10, "Pa", "shaft.shear_modulus", "shear modulus";
    shaft_polar_moment: 9.817e-6, "m^4", "shaft.polar_moment", "polar moment of area";
    shaft_loss_time: 2e-5, "s", "shaft.loss_time", "ratio of damping to stiffness";
    shaft_mean: 843.72, "N m", "shaft.mean", "mean torque of the load";
    shaft_amplitude: 78.78, "N m", "shaft.amplitude", "amplitude of the harmonic part";
    shaft_speed: 735.0, "1", "shaft.speed", "nominal speed in revolutions per minute";
    shaft_engagement_time: 0.15, "s", "shaft.engagement_time", "time at which half of the load acts";
    shaft_engagement_width: 0.02, "s", "shaft.engagement_width", "time constant of engagement";
    shaft_standstill_band: 0.5, "rad/s", "shaft.standstill_band", "speed below which the load fades out";
    shaft_driven_field_inertia: 1.0, "J s^2/(rad)^2", "shaft.driven_field_inertia", "inertia of the field's node; the field sets it";
    shaft_driven_field_force: 0.0, "J/(rad)", "shaft.driven_field_force", "force of the field on its node; the field sets it";
    shaft_driven_phi_x_before: 0.0, "rad/m", "shaft.driven_phi_x_before", "slope of the field before the port; the field sets it";
    shaft_driven_phi_x_after: 0.0, "rad/m", "shaft.driven_phi_x_after", "slope of the field after the port; the field sets it";
    shaft_end_field_inertia: 1.0, "J s^2/(rad)^2", "shaft.end_field_inertia", "inertia of the field's node; the field sets it";
    shaft_end_field_force: 0.0, "J/(rad)", "shaft.end_field_force", "force of the field on its node; the field sets it";
    shaft_end_phi_x_before: 0.0, "rad/m", "shaft.end_phi_x_before", "slope of the field before the port; the field sets it";
    shaft_end_phi_x_after: 0.0, "rad/m", "shaft.end_phi_x_after", "slope of the field after the port; the field sets it";
}

::machinist_contract::outputs! {
    motor_speed: "rad/s", "motor_speed", "rate of rotor angle";
    driven_speed: "rad/s", "driven_speed", "rate of angle of the section, at port driven";
    end_speed: "rad/s", "end_speed", "rate of angle of the section, at port end";
}

::machinist_contract::states! {
    MOTOR_PHI: position, 150.0, "rad", "motor.phi", "rotor angle";
    SHAFT_DRIVEN: position, 40.0, "rad", "shaft.driven", "angle of the section, at port driven";
    SHAFT_END: position, 40.0, "rad", "shaft.end", "angle of the section, at port end";
    MOTOR_OMEGA: velocity, 78.5, "rad/s", "motor.omega", "rate of rotor angle";
    SHAFT_DRIVEN_DOT: velocity, 78.5, "rad/s", "shaft.driven_dot", "rate of angle of the section, at port driven";
    SHAFT_END_DOT: velocity, 78.5, "rad/s", "shaft.end_dot", "rate of angle of the section, at port end";
    MOTOR_PSI_SX: first_order, 1.0, "V s", "motor.psi_sx", "stator flux linkage along x";
    MOTOR_PSI_SY: first_order, 1.0, "V s", "motor.psi_sy", "stator flux linkage along y";
    MOTOR_PSI_RX: first_order, 1.0, "V s", "motor.psi_rx", "rotor flux linkage along x";
    MOTOR_PSI_RY: first_order, 1.0, "V s", "motor.psi_ry", "rotor flux linkage along y";
}

::machinist_contract::patterns! {
    /// Nonzeros of M.
    MASS_MATRIX_PATTERN: 3 by 3 { 0 [0] 1 [1] 2 [2] }
    /// Nonzeros of dy'/dy.
    RATE_JACOBIAN_PATTERN: 10 by 10 { 0 [3] 1 [4] 2 [5] 3 [0 1 3 4 6 7 8 9] 4 [0 1 3 4] 5 [5]
        6 [6 7 8] 7 [6 7 9] 8 [3 6 8 9] 9 [3 7 8 9] }
    /// Nonzeros of dy'/dp.
    PARAMETER_JACOBIAN_PATTERN: 10 by 33 { 3 [0 2 4 5 6 7 10 11 12]
        4 [10 11 12 14 15 19 20 21 22 23 24 25 26] 5 [14 15 19 20 21 22 23 24 29 30] 6 [1 2 3 6 8]
        7 [1 2 3 6 8] 8 [2 4 5 9] 9 [2 4 5 9] }
}

::machinist_contract::constants! {
    motor_omega_0, motor_u_x, motor_u_y, t1, t3, t4, inverse_motor_inertia, t7, t8,
    inverse_shaft_standstill_band, t9, t10, t11, motor_alpha_s_times_motor_omega_0,
    motor_alpha_r_times_motor_omega_0, inverse_shaft_engagement_width,
    shaft_driven_dot_dot_by_motor_phi, motor_omega_dot_by_motor_phi,
    shaft_driven_dot_dot_by_shaft_driven, motor_omega_dot_by_shaft_driven,
    shaft_driven_dot_dot_by_motor_omega, motor_omega_dot_by_motor_omega, t12, t13,
    motor_omega_dot_by_shaft_driven_dot, motor_psi_sx_dot_by_motor_psi_sx,
    motor_psi_sy_dot_by_motor_psi_sx, motor_psi_rx_dot_by_motor_psi_sx,
    motor_psi_sx_dot_by_motor_psi_rx, motor_psi_rx_dot_by_motor_psi_rx, t14, t15, t16, t17, t18,
    minus_motor_u_y, t19, motor_k_r_over_motor_sigma, t20, motor_k_s_over_motor_sigma, t21, t22,
    t23, t24, t25, t26, t27, t28, t29
}

::machinist_contract::field_scene! {
    M3: jacobian_reads_forces false;
    0 shaft_phi: linear false, local true, forces [Varying, Varying], derivatives [Zero, Zero,
        Varying, Zero, Zero, Constant, Zero, Constant], scale [40.0, 78.5], fixed [false, false],
        length 2.322, elements 99, order 1;
    value "rad", "shaft.phi", "angle of the section";
    rate "rad/s", "shaft.phi_dot", "rate of angle of the section";
    slope "rad/m", "shaft.phi_x", "slope of angle of the section";
    at 0.0 => Start, coordinate Some(1), handed 25;
    at 2.322 => End, coordinate Some(2), handed 29;
}

/// Returns the constants of `rate` and its Jacobians from the parameters. 85 operations.
#[must_use]
#[inline]
pub fn prepare<R: Real>(p: &Parameters<R>) -> Constants<R> {
    let (sin_motor_supply_phase, cos_motor_supply_phase) = p.motor_supply_phase.sin_cos();
    let motor_omega_0 = R::literal(core::f64::consts::TAU) * p.motor_supply_frequency;
    let shaft_omega_2 = R::literal(0.104_719_755_119_659_77) * p.shaft_speed;
    let motor_sigma = R::literal(1.0).sub_product(p.motor_k_s, p.motor_k_r);
    let t0 = p.motor_phase_voltage * R::literal(core::f64::consts::SQRT_2);
    let motor_u_x = t0 * cos_motor_supply_phase;
    let motor_u_y = t0 * sin_motor_supply_phase;
    let t1 = R::literal(-1.0) / p.shaft_engagement_width;
    let motor_x_s_times_motor_sigma = p.motor_x_s * motor_sigma;
    let t2 = R::literal(1.5) * p.motor_pole_pairs;
    let t3 = t2 * p.motor_k_r * motor_omega_0 / motor_x_s_times_motor_sigma;
    let t4 = R::literal(core::f64::consts::PI) * shaft_omega_2;
    let t5 = R::literal(0.5) * p.shaft_inertia;
    let t6 = t5 / p.shaft_pieces;
    let inverse_motor_inertia = R::literal(1.0) / p.motor_inertia;
    let t7 = R::literal(1.0) / (t6 + p.shaft_driven_field_inertia);
    let t8 = R::literal(1.0) / (t6 + p.shaft_end_field_inertia);
    let inverse_shaft_standstill_band = R::literal(1.0) / p.shaft_standstill_band;
    let t9 = R::literal(0.5) / p.shaft_pieces;
    let t10 = p.coupling_stiffness * p.coupling_ratio;
    let t11 = p.coupling_damping * p.coupling_ratio;
    let motor_alpha_s_times_motor_omega_0 = p.motor_alpha_s * motor_omega_0;
    let motor_alpha_r_times_motor_omega_0 = p.motor_alpha_r * motor_omega_0;
    let inverse_shaft_engagement_width = R::literal(1.0) / p.shaft_engagement_width;
    let shaft_driven_dot_dot_by_motor_phi = t10 * t7;
    let motor_omega_dot_by_motor_phi = -(p.coupling_stiffness * inverse_motor_inertia);
    let coupling_ratio_squared = p.coupling_ratio * p.coupling_ratio;
    let shaft_driven_dot_dot_by_shaft_driven = -(p.coupling_stiffness * coupling_ratio_squared
        * t7);
    let motor_omega_dot_by_shaft_driven = t10 * inverse_motor_inertia;
    let shaft_driven_dot_dot_by_motor_omega = t11 * t7;
    let motor_omega_dot_by_motor_omega = -(p.coupling_damping * inverse_motor_inertia);
    let t12 = p.coupling_damping * coupling_ratio_squared;
    let t13 = R::literal(0.5) / (p.shaft_pieces * p.shaft_standstill_band);
    let motor_omega_dot_by_shaft_driven_dot = t11 * inverse_motor_inertia;
    let motor_psi_sx_dot_by_motor_psi_sx = -motor_alpha_s_times_motor_omega_0;
    let motor_psi_sy_dot_by_motor_psi_sx = -motor_omega_0;
    let motor_psi_rx_dot_by_motor_psi_sx = p.motor_k_s * p.motor_alpha_r * motor_omega_0;
    let motor_psi_sx_dot_by_motor_psi_rx = p.motor_k_r * p.motor_alpha_s * motor_omega_0;
    let motor_psi_rx_dot_by_motor_psi_rx = -motor_alpha_r_times_motor_omega_0;
    let t14 = R::literal(core::f64::consts::SQRT_2) * cos_motor_supply_phase;
    let t15 = R::literal(core::f64::consts::SQRT_2) * sin_motor_supply_phase;
    let t16 = R::literal(3.0 * core::f64::consts::PI) * p.motor_pole_pairs * p.motor_k_r
        / motor_x_s_times_motor_sigma;
    let t17 = R::literal(core::f64::consts::TAU) * p.motor_alpha_s;
    let t18 = R::literal(core::f64::consts::TAU) * p.motor_alpha_r;
    let minus_motor_u_y = -motor_u_y;
    let t19 = R::literal(1.5) * p.motor_k_r * motor_omega_0 / motor_x_s_times_motor_sigma;
    let motor_k_r_over_motor_sigma = p.motor_k_r / motor_sigma;
    let t20 = t2 * motor_omega_0 / motor_x_s_times_motor_sigma;
    let motor_k_s_over_motor_sigma = p.motor_k_s / motor_sigma;
    let t21 = R::literal(-1.0) / p.motor_x_s;
    let t22 = R::literal(2.0) * p.coupling_stiffness * p.coupling_ratio;
    let t23 = R::literal(2.0) * p.coupling_damping * p.coupling_ratio;
    let shaft_pieces_squared = p.shaft_pieces * p.shaft_pieces;
    let t24 = R::literal(0.5) / shaft_pieces_squared;
    let t25 = t5 / shaft_pieces_squared;
    let t26 = R::literal(0.164_493_406_684_822_62) * p.shaft_amplitude / p.shaft_pieces;
    let t27 = R::literal(0.5) / (p.shaft_pieces * p.shaft_engagement_width);
    let t28 = R::literal(0.5) / (p.shaft_pieces * (p.shaft_engagement_width
        * p.shaft_engagement_width));
    let t29 = R::literal(0.5) / (p.shaft_pieces * (p.shaft_standstill_band
        * p.shaft_standstill_band));
    Constants { motor_omega_0, motor_u_x, motor_u_y, t1, t3, t4, inverse_motor_inertia, t7, t8,
        inverse_shaft_standstill_band, t9, t10, t11, motor_alpha_s_times_motor_omega_0,
        motor_alpha_r_times_motor_omega_0, inverse_shaft_engagement_width,
        shaft_driven_dot_dot_by_motor_phi, motor_omega_dot_by_motor_phi,
        shaft_driven_dot_dot_by_shaft_driven, motor_omega_dot_by_shaft_driven,
        shaft_driven_dot_dot_by_motor_omega, motor_omega_dot_by_motor_omega, t12, t13,
        motor_omega_dot_by_shaft_driven_dot, motor_psi_sx_dot_by_motor_psi_sx,
        motor_psi_sy_dot_by_motor_psi_sx, motor_psi_rx_dot_by_motor_psi_sx,
        motor_psi_sx_dot_by_motor_psi_rx, motor_psi_rx_dot_by_motor_psi_rx, t14, t15, t16, t17,
        t18, minus_motor_u_y, t19, motor_k_r_over_motor_sigma, t20, motor_k_s_over_motor_sigma,
        t21, t22, t23, t24, t25, t26, t27, t28, t29 }
}

/// State at the start of the run, in the units of the states. 18 operations.
#[must_use]
pub fn initial_state<R: Real>(p: &Parameters<R>) -> [R; STATES] {
    let motor_omega_0 = R::literal(core::f64::consts::TAU) * p.motor_supply_frequency;
    let motor_sigma = R::literal(1.0).sub_product(p.motor_k_s, p.motor_k_r);
    let motor_u_x = p.motor_phase_voltage * R::literal(core::f64::consts::SQRT_2)
        * p.motor_supply_phase.cos();
    let synchronous_speed = motor_omega_0 / p.motor_pole_pairs;
    let loss = p.motor_alpha_s * motor_sigma;
    let flux = motor_u_x / (motor_omega_0 * R::literal(1.0).add_product(loss, loss));
    [R::literal(0.0), R::literal(0.0), R::literal(0.0), synchronous_speed, synchronous_speed,
        synchronous_speed, loss * flux, -flux, p.motor_k_s * loss * flux, -(p.motor_k_s * flux)]
}

/// Times of known jumps of the right-hand side \[s\], unsorted. 6 operations.
#[must_use]
pub fn discontinuities<R: Real>(p: &Parameters<R>) -> [R; DISCONTINUITIES] {
    let inverse_shaft_engagement_width = R::literal(1.0) / p.shaft_engagement_width;
    let abs_inverse_shaft_engagement_width = inverse_shaft_engagement_width.abs();
    [R::select_less(R::literal(200.0), abs_inverse_shaft_engagement_width,
        R::select_less(R::literal(0.0), abs_inverse_shaft_engagement_width,
        inverse_shaft_engagement_width * p.shaft_engagement_time / inverse_shaft_engagement_width,
        R::literal(0.0)), R::literal(0.0))]
}

/// As `rate`, with the constants of the parameters from `prepare`. 62 operations.
#[must_use]
#[inline]
pub fn prepared_rate<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>,
        c: &Constants<R>) -> [R; STATES] {
    let [motor_phi, shaft_driven, _, motor_omega, shaft_driven_dot, shaft_end_dot, motor_psi_sx,
        motor_psi_sy, motor_psi_rx, motor_psi_ry] = *state;
    let [t0, t1] = R::tanh_each([c.inverse_shaft_standstill_band * shaft_driven_dot,
        c.inverse_shaft_standstill_band * shaft_end_dot]);
    let coupling_twist = motor_phi.sub_product(p.coupling_ratio, shaft_driven);
    let coupling_twist_rate = motor_omega.sub_product(p.coupling_ratio, shaft_driven_dot);
    let motor_slip_speed = c.motor_omega_0.sub_product(p.motor_pole_pairs, motor_omega);
    let shaft_engagement = R::literal(1.0) / (R::literal(1.0)
        + (c.t1 * (time - p.shaft_engagement_time)).exp());
    let coupling_torque = (p.coupling_stiffness * coupling_twist).add_product(p.coupling_damping,
        coupling_twist_rate);
    let motor_torque = c.t3 * (motor_psi_sy * motor_psi_rx).sub_product(motor_psi_sx, motor_psi_ry);
    let shaft_load = shaft_engagement * p.shaft_mean.add_product(p.shaft_amplitude, (c.t4 * time)
        .sin());
    let t2 = c.t9 * shaft_load;
    let shaft_end_dot_dot = p.shaft_end_field_force.sub_product(t2, t1) * c.t8;
    let shaft_driven_dot_dot = p.shaft_driven_field_force.add_product(c.t10, coupling_twist)
        .add_product(c.t11, coupling_twist_rate).sub_product(t2, t0) * c.t7;
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
    [motor_omega, shaft_driven_dot, shaft_end_dot, motor_omega_dot, shaft_driven_dot_dot,
        shaft_end_dot_dot, motor_psi_sx_dot, motor_psi_sy_dot, motor_psi_rx_dot, motor_psi_ry_dot]
}

/// `M = d2L/dq'2`, values in the order of its pattern. 4 operations.
#[must_use]
pub fn mass_matrix<R: Real>(_time: R, _state: &[R; STATES], p: &Parameters<R>) -> [R; 3] {
    let t0 = R::literal(0.5) * p.shaft_inertia / p.shaft_pieces;
    [p.motor_inertia, t0 + p.shaft_driven_field_inertia, t0 + p.shaft_end_field_inertia]
}

/// `f` of `M q'' = f + G^T lambda`, one for each coordinate. 50 operations.
#[must_use]
pub fn forcing<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>) -> [R; COORDINATES] {
    let [motor_phi, shaft_driven, _, motor_omega, shaft_driven_dot, shaft_end_dot, motor_psi_sx,
        motor_psi_sy, motor_psi_rx, motor_psi_ry] = *state;
    let inverse_shaft_standstill_band = R::literal(1.0) / p.shaft_standstill_band;
    let [t0, t1] = R::tanh_each([inverse_shaft_standstill_band * shaft_driven_dot,
        inverse_shaft_standstill_band * shaft_end_dot]);
    let motor_omega_0 = R::literal(core::f64::consts::TAU) * p.motor_supply_frequency;
    let shaft_omega_2 = R::literal(0.104_719_755_119_659_77) * p.shaft_speed;
    let motor_sigma = R::literal(1.0).sub_product(p.motor_k_s, p.motor_k_r);
    let coupling_twist = motor_phi.sub_product(p.coupling_ratio, shaft_driven);
    let coupling_twist_rate = motor_omega.sub_product(p.coupling_ratio, shaft_driven_dot);
    let shaft_engagement = R::literal(1.0) / (R::literal(1.0) + (R::literal(-1.0)
        / p.shaft_engagement_width * (time - p.shaft_engagement_time)).exp());
    let coupling_torque = (p.coupling_stiffness * coupling_twist).add_product(p.coupling_damping,
        coupling_twist_rate);
    let motor_torque = R::literal(1.5) * p.motor_pole_pairs * p.motor_k_r * motor_omega_0
        / (p.motor_x_s * motor_sigma) * (motor_psi_sy * motor_psi_rx).sub_product(motor_psi_sx,
        motor_psi_ry);
    let shaft_load = shaft_engagement * p.shaft_mean.add_product(p.shaft_amplitude,
        (R::literal(core::f64::consts::PI) * shaft_omega_2 * time).sin());
    let motor_phi_forcing = motor_torque - coupling_torque;
    let t2 = R::literal(0.5) / p.shaft_pieces * shaft_load;
    let shaft_driven_forcing = p.shaft_driven_field_force.add_product(p.coupling_stiffness
        * p.coupling_ratio, coupling_twist).add_product(p.coupling_damping * p.coupling_ratio,
        coupling_twist_rate).sub_product(t2, t0);
    let shaft_end_forcing = p.shaft_end_field_force.sub_product(t2, t1);
    [motor_phi_forcing, shaft_driven_forcing, shaft_end_forcing]
}

/// As `rate_jacobian`, with the constants of the parameters from `prepare`. 43 operations.
#[must_use]
pub fn prepared_rate_jacobian<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>,
        c: &Constants<R>) -> [R; 30] {
    let [_, _, _, motor_omega, shaft_driven_dot, shaft_end_dot, motor_psi_sx, motor_psi_sy,
        motor_psi_rx, motor_psi_ry] = *state;
    let [t0, t1] = R::tanh_each([c.inverse_shaft_standstill_band * shaft_driven_dot,
        c.inverse_shaft_standstill_band * shaft_end_dot]);
    let motor_pole_pairs_times_motor_omega = p.motor_pole_pairs * motor_omega;
    let motor_slip_speed = c.motor_omega_0 - motor_pole_pairs_times_motor_omega;
    let shaft_engagement = R::literal(1.0) / (R::literal(1.0) + (-(c.inverse_shaft_engagement_width
        * (time - p.shaft_engagement_time))).exp());
    let shaft_load = shaft_engagement * p.shaft_mean.add_product(p.shaft_amplitude, (c.t4 * time)
        .sin());
    let motor_psi_rx_dot_by_motor_omega = -(p.motor_pole_pairs * motor_psi_ry);
    let motor_psi_ry_dot_by_motor_omega = p.motor_pole_pairs * motor_psi_rx;
    let t2 = c.t13 * shaft_load;
    let shaft_driven_dot_dot_by_shaft_driven_dot = -(c.t12.add_product(t2, R::literal(1.0)
        .sub_product(t0, t0)) * c.t7);
    let shaft_end_dot_dot_by_shaft_end_dot = -(t2 * R::literal(1.0).sub_product(t1, t1) * c.t8);
    let motor_omega_dot_by_motor_psi_sx = -(c.t3 * motor_psi_ry * c.inverse_motor_inertia);
    let motor_omega_dot_by_motor_psi_sy = c.t3 * motor_psi_rx * c.inverse_motor_inertia;
    let motor_omega_dot_by_motor_psi_rx = c.t3 * motor_psi_sy * c.inverse_motor_inertia;
    let motor_psi_ry_dot_by_motor_psi_rx = motor_pole_pairs_times_motor_omega - c.motor_omega_0;
    let motor_omega_dot_by_motor_psi_ry = -(c.t3 * motor_psi_sx * c.inverse_motor_inertia);
    [R::literal(1.0), R::literal(1.0), R::literal(1.0), c.motor_omega_dot_by_motor_phi,
        c.motor_omega_dot_by_shaft_driven, c.motor_omega_dot_by_motor_omega,
        c.motor_omega_dot_by_shaft_driven_dot, motor_omega_dot_by_motor_psi_sx,
        motor_omega_dot_by_motor_psi_sy, motor_omega_dot_by_motor_psi_rx,
        motor_omega_dot_by_motor_psi_ry, c.shaft_driven_dot_dot_by_motor_phi,
        c.shaft_driven_dot_dot_by_shaft_driven, c.shaft_driven_dot_dot_by_motor_omega,
        shaft_driven_dot_dot_by_shaft_driven_dot, shaft_end_dot_dot_by_shaft_end_dot,
        c.motor_psi_sx_dot_by_motor_psi_sx, c.motor_omega_0, c.motor_psi_sx_dot_by_motor_psi_rx,
        c.motor_psi_sy_dot_by_motor_psi_sx, c.motor_psi_sx_dot_by_motor_psi_sx,
        c.motor_psi_sx_dot_by_motor_psi_rx, motor_psi_rx_dot_by_motor_omega,
        c.motor_psi_rx_dot_by_motor_psi_sx, c.motor_psi_rx_dot_by_motor_psi_rx, motor_slip_speed,
        motor_psi_ry_dot_by_motor_omega, c.motor_psi_rx_dot_by_motor_psi_sx,
        motor_psi_ry_dot_by_motor_psi_rx, c.motor_psi_rx_dot_by_motor_psi_rx]
}

/// As `parameter_jacobian`, with the constants of the parameters from `prepare`. 179 operations.
#[must_use]
pub fn prepared_parameter_jacobian<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>,
        c: &Constants<R>) -> [R; 50] {
    let [motor_phi, shaft_driven, _, motor_omega, shaft_driven_dot, shaft_end_dot, motor_psi_sx,
        motor_psi_sy, motor_psi_rx, motor_psi_ry] = *state;
    let t0 = c.t4 * time;
    let (t1, t2) = t0.sin_cos();
    let [t3, t4] = R::tanh_each([c.inverse_shaft_standstill_band * shaft_driven_dot,
        c.inverse_shaft_standstill_band * shaft_end_dot]);
    let coupling_ratio_times_shaft_driven = p.coupling_ratio * shaft_driven;
    let coupling_twist = motor_phi - coupling_ratio_times_shaft_driven;
    let t5 = p.coupling_ratio * shaft_driven_dot;
    let coupling_twist_rate = motor_omega - t5;
    let time_minus_shaft_engagement_time = time - p.shaft_engagement_time;
    let t6 = c.inverse_shaft_engagement_width * time_minus_shaft_engagement_time;
    let t7 = R::literal(1.0) + (-t6).exp();
    let shaft_engagement = R::literal(1.0) / t7;
    let coupling_torque = (p.coupling_stiffness * coupling_twist).add_product(p.coupling_damping,
        coupling_twist_rate);
    let t8 = motor_psi_sx.sub_product(p.motor_k_r, motor_psi_rx);
    let t9 = motor_psi_sy.sub_product(p.motor_k_r, motor_psi_ry);
    let t10 = (motor_psi_sy * motor_psi_rx).sub_product(motor_psi_sx, motor_psi_ry);
    let motor_torque = c.t3 * t10;
    let t11 = p.shaft_mean.add_product(p.shaft_amplitude, t1);
    let shaft_load = shaft_engagement * t11;
    let t12 = c.t9 * shaft_load;
    let shaft_end_dot_dot = p.shaft_end_field_force.sub_product(t12, t4) * c.t8;
    let shaft_driven_dot_dot = p.shaft_driven_field_force.add_product(c.t10, coupling_twist)
        .add_product(c.t11, coupling_twist_rate).sub_product(t12, t3) * c.t7;
    let motor_omega_dot = (motor_torque - coupling_torque) * c.inverse_motor_inertia;
    let t13 = (-motor_psi_rx).add_product(p.motor_k_s, motor_psi_sx);
    let t14 = (-motor_psi_ry).add_product(p.motor_k_s, motor_psi_sy);
    let motor_omega_dot_by_motor_inertia = -(motor_omega_dot * c.inverse_motor_inertia);
    let motor_omega_dot_by_motor_supply_frequency = c.t16 * t10 * c.inverse_motor_inertia;
    let motor_psi_sx_dot_by_motor_supply_frequency = (R::literal(core::f64::consts::TAU)
        * motor_psi_sy).sub_product(c.t17, t8);
    let motor_psi_sy_dot_by_motor_supply_frequency = (R::literal(-6.283_185_307_179_586)
        * motor_psi_sx).sub_product(c.t17, t9);
    let motor_psi_rx_dot_by_motor_supply_frequency = (R::literal(core::f64::consts::TAU)
        * motor_psi_ry).add_product(c.t18, t13);
    let motor_psi_ry_dot_by_motor_supply_frequency = (R::literal(-6.283_185_307_179_586)
        * motor_psi_rx).add_product(c.t18, t14);
    let motor_omega_dot_by_motor_pole_pairs = c.t19 * t10 * c.inverse_motor_inertia;
    let motor_psi_rx_dot_by_motor_pole_pairs = -(motor_omega * motor_psi_ry);
    let motor_psi_ry_dot_by_motor_pole_pairs = motor_omega * motor_psi_rx;
    let motor_omega_dot_by_motor_k_s = c.motor_k_r_over_motor_sigma * motor_torque
        * c.inverse_motor_inertia;
    let motor_psi_rx_dot_by_motor_k_s = c.motor_alpha_r_times_motor_omega_0 * motor_psi_sx;
    let motor_psi_ry_dot_by_motor_k_s = c.motor_alpha_r_times_motor_omega_0 * motor_psi_sy;
    let motor_omega_dot_by_motor_k_r = (c.t20 * t10).add_product(c.motor_k_s_over_motor_sigma,
        motor_torque) * c.inverse_motor_inertia;
    let motor_psi_sx_dot_by_motor_k_r = c.motor_alpha_s_times_motor_omega_0 * motor_psi_rx;
    let motor_psi_sy_dot_by_motor_k_r = c.motor_alpha_s_times_motor_omega_0 * motor_psi_ry;
    let motor_omega_dot_by_motor_x_s = c.t21 * motor_torque * c.inverse_motor_inertia;
    let motor_psi_sx_dot_by_motor_alpha_s = -(c.motor_omega_0 * t8);
    let motor_psi_sy_dot_by_motor_alpha_s = -(c.motor_omega_0 * t9);
    let motor_psi_rx_dot_by_motor_alpha_r = c.motor_omega_0 * t13;
    let motor_psi_ry_dot_by_motor_alpha_r = c.motor_omega_0 * t14;
    let shaft_driven_dot_dot_by_coupling_stiffness = p.coupling_ratio * coupling_twist * c.t7;
    let motor_omega_dot_by_coupling_stiffness = (coupling_ratio_times_shaft_driven - motor_phi)
        * c.inverse_motor_inertia;
    let shaft_driven_dot_dot_by_coupling_damping = p.coupling_ratio * coupling_twist_rate * c.t7;
    let motor_omega_dot_by_coupling_damping = (t5 - motor_omega) * c.inverse_motor_inertia;
    let shaft_driven_dot_dot_by_coupling_ratio = (p.coupling_stiffness * motor_phi)
        .add_product(p.coupling_damping, motor_omega).sub_product(c.t22, shaft_driven)
        .sub_product(c.t23, shaft_driven_dot) * c.t7;
    let motor_omega_dot_by_coupling_ratio = (p.coupling_stiffness * shaft_driven)
        .add_product(p.coupling_damping, shaft_driven_dot) * c.inverse_motor_inertia;
    let t15 = c.t24 * shaft_load;
    let shaft_end_dot_dot_by_shaft_pieces = (t15 * t4).add_product(c.t25, shaft_end_dot_dot) * c.t8;
    let shaft_driven_dot_dot_by_shaft_pieces = (t15 * t3).add_product(c.t25, shaft_driven_dot_dot)
        * c.t7;
    let shaft_end_dot_dot_by_shaft_inertia = -(c.t9 * shaft_end_dot_dot * c.t8);
    let shaft_driven_dot_dot_by_shaft_inertia = -(c.t9 * shaft_driven_dot_dot * c.t7);
    let t16 = c.t9 * shaft_engagement;
    let shaft_end_dot_dot_by_shaft_mean = -(t16 * t4 * c.t8);
    let shaft_driven_dot_dot_by_shaft_mean = -(t16 * t3 * c.t7);
    let t17 = t16 * t1;
    let shaft_end_dot_dot_by_shaft_amplitude = -(t17 * t4 * c.t8);
    let shaft_driven_dot_dot_by_shaft_amplitude = -(t17 * t3 * c.t7);
    let t18 = c.t26 * time * shaft_engagement * t2;
    let shaft_end_dot_dot_by_shaft_speed = -(t18 * t4 * c.t8);
    let shaft_driven_dot_dot_by_shaft_speed = -(t18 * t3 * c.t7);
    let t19 = c.t27 * t11;
    let t20 = t7 * (R::literal(1.0) + t6.exp());
    let shaft_end_dot_dot_by_shaft_engagement_time = t19 * t4 / t20 * c.t8;
    let shaft_driven_dot_dot_by_shaft_engagement_time = t19 * t3 / t20 * c.t7;
    let t21 = c.t28 * time_minus_shaft_engagement_time * t11;
    let shaft_end_dot_dot_by_shaft_engagement_width = t21 * t4 / t20 * c.t8;
    let shaft_driven_dot_dot_by_shaft_engagement_width = t21 * t3 / t20 * c.t7;
    let shaft_end_dot_dot_by_shaft_standstill_band = c.t29 * shaft_end_dot * shaft_load
        * R::literal(1.0).sub_product(t4, t4) * c.t8;
    let shaft_driven_dot_dot_by_shaft_standstill_band = c.t29 * shaft_driven_dot * shaft_load
        * R::literal(1.0).sub_product(t3, t3) * c.t7;
    let shaft_driven_dot_dot_by_shaft_driven_field_inertia = -(shaft_driven_dot_dot * c.t7);
    let shaft_end_dot_dot_by_shaft_end_field_inertia = -(shaft_end_dot_dot * c.t8);
    [motor_omega_dot_by_motor_inertia, motor_omega_dot_by_motor_supply_frequency,
        motor_omega_dot_by_motor_pole_pairs, motor_omega_dot_by_motor_k_s,
        motor_omega_dot_by_motor_k_r, motor_omega_dot_by_motor_x_s,
        motor_omega_dot_by_coupling_stiffness, motor_omega_dot_by_coupling_damping,
        motor_omega_dot_by_coupling_ratio, shaft_driven_dot_dot_by_coupling_stiffness,
        shaft_driven_dot_dot_by_coupling_damping, shaft_driven_dot_dot_by_coupling_ratio,
        shaft_driven_dot_dot_by_shaft_pieces, shaft_driven_dot_dot_by_shaft_inertia,
        shaft_driven_dot_dot_by_shaft_mean, shaft_driven_dot_dot_by_shaft_amplitude,
        shaft_driven_dot_dot_by_shaft_speed, shaft_driven_dot_dot_by_shaft_engagement_time,
        shaft_driven_dot_dot_by_shaft_engagement_width,
        shaft_driven_dot_dot_by_shaft_standstill_band,
        shaft_driven_dot_dot_by_shaft_driven_field_inertia, c.t7,
        shaft_end_dot_dot_by_shaft_pieces, shaft_end_dot_dot_by_shaft_inertia,
        shaft_end_dot_dot_by_shaft_mean, shaft_end_dot_dot_by_shaft_amplitude,
        shaft_end_dot_dot_by_shaft_speed, shaft_end_dot_dot_by_shaft_engagement_time,
        shaft_end_dot_dot_by_shaft_engagement_width, shaft_end_dot_dot_by_shaft_standstill_band,
        shaft_end_dot_dot_by_shaft_end_field_inertia, c.t8, c.t14,
        motor_psi_sx_dot_by_motor_supply_frequency, c.minus_motor_u_y,
        motor_psi_sx_dot_by_motor_k_r, motor_psi_sx_dot_by_motor_alpha_s, c.t15,
        motor_psi_sy_dot_by_motor_supply_frequency, c.motor_u_x, motor_psi_sy_dot_by_motor_k_r,
        motor_psi_sy_dot_by_motor_alpha_s, motor_psi_rx_dot_by_motor_supply_frequency,
        motor_psi_rx_dot_by_motor_pole_pairs, motor_psi_rx_dot_by_motor_k_s,
        motor_psi_rx_dot_by_motor_alpha_r, motor_psi_ry_dot_by_motor_supply_frequency,
        motor_psi_ry_dot_by_motor_pole_pairs, motor_psi_ry_dot_by_motor_k_s,
        motor_psi_ry_dot_by_motor_alpha_r]
}

/// Partial derivative of `y'` with respect to time. 46 operations.
#[must_use]
pub fn time_derivative<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>) -> [R; STATES] {
    let [_, _, _, _, shaft_driven_dot, shaft_end_dot, ..] = *state;
    let shaft_omega_2 = R::literal(0.104_719_755_119_659_77) * p.shaft_speed;
    let t0 = R::literal(core::f64::consts::PI) * shaft_omega_2 * time;
    let (t1, t2) = t0.sin_cos();
    let inverse_shaft_standstill_band = R::literal(1.0) / p.shaft_standstill_band;
    let [t3, t4] = R::tanh_each([inverse_shaft_standstill_band * shaft_driven_dot,
        inverse_shaft_standstill_band * shaft_end_dot]);
    let t5 = R::literal(1.0) / p.shaft_engagement_width * (time - p.shaft_engagement_time);
    let t6 = R::literal(1.0) + (-t5).exp();
    let shaft_engagement = R::literal(1.0) / t6;
    let t7 = R::literal(0.5) * p.shaft_inertia / p.shaft_pieces;
    let t8 = R::literal(0.5) / (p.shaft_pieces * p.shaft_engagement_width) * p.shaft_mean
        .add_product(p.shaft_amplitude, t1);
    let t9 = t6 * (R::literal(1.0) + t5.exp());
    let t10 = R::literal(core::f64::consts::FRAC_PI_2) * p.shaft_amplitude * shaft_omega_2
        / p.shaft_pieces * shaft_engagement * t2;
    let shaft_end_dot_dot_by_time = (t8 * t4 / t9).add_product(t10, t4) * (R::literal(-1.0)
        / (t7 + p.shaft_end_field_inertia));
    let shaft_driven_dot_dot_by_time = (t8 * t3 / t9).add_product(t10, t3) * (R::literal(-1.0)
        / (t7 + p.shaft_driven_field_inertia));
    [R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0),
        shaft_driven_dot_dot_by_time, shaft_end_dot_dot_by_time, R::literal(0.0), R::literal(0.0),
        R::literal(0.0), R::literal(0.0)]
}

/// Wanted outputs. No operations.
#[must_use]
pub fn outputs<R: Real>(_time: R, state: &[R; STATES], _p: &Parameters<R>) -> Outputs<R> {
    let [_, _, _, motor_omega, shaft_driven_dot, shaft_end_dot, ..] = *state;
    Outputs {
        motor_speed: motor_omega,
        driven_speed: shaft_driven_dot,
        end_speed: shaft_end_dot,
    }
}

/// T, V and the energy of first-order states \[J\]. 50 operations.
#[must_use]
pub fn energy<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>) -> Energy<R> {
    let [motor_phi, shaft_driven, _, motor_omega, shaft_driven_dot, shaft_end_dot, motor_psi_sx,
        motor_psi_sy, motor_psi_rx, motor_psi_ry] = *state;
    let motor_omega_0 = R::literal(core::f64::consts::TAU) * p.motor_supply_frequency;
    let motor_sigma = R::literal(1.0).sub_product(p.motor_k_s, p.motor_k_r);
    let motor_x_r = p.motor_k_s * p.motor_x_s / p.motor_k_r;
    let coupling_twist = motor_phi.sub_product(p.coupling_ratio, shaft_driven);
    let t0 = motor_omega_0 / (p.motor_x_s * motor_sigma);
    let motor_i_sx = t0 * motor_psi_sx.sub_product(p.motor_k_r, motor_psi_rx);
    let motor_i_sy = t0 * motor_psi_sy.sub_product(p.motor_k_r, motor_psi_ry);
    let t1 = motor_omega_0 / (motor_sigma * motor_x_r);
    let motor_i_rx = t1 * motor_psi_rx.sub_product(p.motor_k_s, motor_psi_sx);
    let motor_i_ry = t1 * motor_psi_ry.sub_product(p.motor_k_s, motor_psi_sy);
    let shaft_driven_dot_squared = shaft_driven_dot * shaft_driven_dot;
    let shaft_end_dot_squared = shaft_end_dot * shaft_end_dot;
    Energy {
        kinetic: (R::literal(0.5) * p.motor_inertia * (motor_omega * motor_omega))
            .add_product(R::literal(0.25) * p.shaft_inertia / p.shaft_pieces,
            shaft_driven_dot_squared + shaft_end_dot_squared).add_product(R::literal(0.5)
            * p.shaft_driven_field_inertia, shaft_driven_dot_squared).add_product(R::literal(0.5)
            * p.shaft_end_field_inertia, shaft_end_dot_squared),
        potential: R::literal(0.5) * p.coupling_stiffness * (coupling_twist * coupling_twist),
        stored: R::literal(0.75) * (motor_psi_sx * motor_i_sx).add_product(motor_psi_sy, motor_i_sy)
            .add_product(motor_psi_rx, motor_i_rx).add_product(motor_psi_ry, motor_i_ry),
    }
}

/// `dE/dt`, power supplied and power dissipated \[W\]. 177 operations.
#[must_use]
pub fn power_balance<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>) -> PowerBalance<R> {
    let [motor_phi, shaft_driven, _, motor_omega, shaft_driven_dot, shaft_end_dot, motor_psi_sx,
        motor_psi_sy, motor_psi_rx, motor_psi_ry] = *state;
    let shaft_omega_2 = R::literal(0.104_719_755_119_659_77) * p.shaft_speed;
    let [(sin_motor_supply_phase, cos_motor_supply_phase), (t0, _)]
        = R::sin_cos_each([p.motor_supply_phase,
        R::literal(core::f64::consts::PI) * shaft_omega_2 * time]);
    let inverse_shaft_standstill_band = R::literal(1.0) / p.shaft_standstill_band;
    let [t1, t2] = R::tanh_each([inverse_shaft_standstill_band * shaft_driven_dot,
        inverse_shaft_standstill_band * shaft_end_dot]);
    let motor_omega_0 = R::literal(core::f64::consts::TAU) * p.motor_supply_frequency;
    let motor_sigma = R::literal(1.0).sub_product(p.motor_k_s, p.motor_k_r);
    let motor_x_r = p.motor_k_s * p.motor_x_s / p.motor_k_r;
    let t3 = p.motor_phase_voltage * R::literal(core::f64::consts::SQRT_2);
    let motor_u_x = t3 * cos_motor_supply_phase;
    let motor_u_y = t3 * sin_motor_supply_phase;
    let coupling_twist = motor_phi.sub_product(p.coupling_ratio, shaft_driven);
    let coupling_twist_rate = motor_omega.sub_product(p.coupling_ratio, shaft_driven_dot);
    let loss = p.motor_alpha_s * motor_sigma;
    let motor_slip_speed = motor_omega_0.sub_product(p.motor_pole_pairs, motor_omega);
    let shaft_engagement = R::literal(1.0) / (R::literal(1.0) + (R::literal(-1.0)
        / p.shaft_engagement_width * (time - p.shaft_engagement_time)).exp());
    let t4 = p.coupling_stiffness * coupling_twist;
    let coupling_torque = t4.add_product(p.coupling_damping, coupling_twist_rate);
    let t5 = motor_psi_sx.sub_product(p.motor_k_r, motor_psi_rx);
    let motor_x_s_times_motor_sigma = p.motor_x_s * motor_sigma;
    let t6 = motor_omega_0 / motor_x_s_times_motor_sigma;
    let motor_i_sx = t6 * t5;
    let t7 = motor_psi_sy.sub_product(p.motor_k_r, motor_psi_ry);
    let motor_i_sy = t6 * t7;
    let motor_k_s_times_motor_psi_sx = p.motor_k_s * motor_psi_sx;
    let t8 = motor_omega_0 / (motor_sigma * motor_x_r);
    let motor_i_rx = t8 * (motor_psi_rx - motor_k_s_times_motor_psi_sx);
    let motor_k_s_times_motor_psi_sy = p.motor_k_s * motor_psi_sy;
    let motor_i_ry = t8 * (motor_psi_ry - motor_k_s_times_motor_psi_sy);
    let motor_torque = R::literal(1.5) * p.motor_pole_pairs * p.motor_k_r * motor_omega_0
        / motor_x_s_times_motor_sigma * (motor_psi_sy * motor_psi_rx).sub_product(motor_psi_sx,
        motor_psi_ry);
    let shaft_load = shaft_engagement * p.shaft_mean.add_product(p.shaft_amplitude, t0);
    let t9 = R::literal(0.5) * p.shaft_inertia / p.shaft_pieces;
    let t10 = R::literal(0.5) / p.shaft_pieces * shaft_load;
    let t11 = t10 * t1;
    let t12 = p.coupling_stiffness * p.coupling_ratio * coupling_twist;
    let t13 = p.coupling_damping * p.coupling_ratio;
    let t14 = p.shaft_end_field_force.sub_product(t10, t2);
    let shaft_end_dot_dot = t14 * (R::literal(1.0) / (t9 + p.shaft_end_field_inertia));
    let shaft_driven_dot_dot = ((p.shaft_driven_field_force + t12).add_product(t13,
        coupling_twist_rate) - t11) * (R::literal(1.0) / (t9 + p.shaft_driven_field_inertia));
    let motor_omega_dot = (motor_torque - coupling_torque) * (R::literal(1.0) / p.motor_inertia);
    let motor_alpha_s_times_motor_omega_0 = p.motor_alpha_s * motor_omega_0;
    let motor_psi_sx_dot = motor_u_x.add_product(motor_omega_0, motor_psi_sy)
        .sub_product(motor_alpha_s_times_motor_omega_0, t5);
    let motor_psi_sy_dot = motor_u_y.sub_product(motor_omega_0, motor_psi_sx)
        .sub_product(motor_alpha_s_times_motor_omega_0, t7);
    let motor_alpha_r_times_motor_omega_0 = p.motor_alpha_r * motor_omega_0;
    let motor_psi_rx_dot = (motor_psi_ry * motor_slip_speed)
        .add_product(motor_alpha_r_times_motor_omega_0, motor_k_s_times_motor_psi_sx
        - motor_psi_rx);
    let motor_psi_ry_dot = (motor_alpha_r_times_motor_omega_0 * (motor_k_s_times_motor_psi_sy
        - motor_psi_ry)).sub_product(motor_psi_rx, motor_slip_speed);
    let t15 = p.motor_k_r * motor_omega_0 / motor_x_s_times_motor_sigma;
    let t16 = (t4 * motor_omega).sub_product(t12, shaft_driven_dot).add_product(p.motor_inertia
        * motor_omega, motor_omega_dot).add_product((shaft_driven_dot
        * p.shaft_driven_field_inertia).add_product(t9, shaft_driven_dot), shaft_driven_dot_dot)
        .add_product((shaft_end_dot * p.shaft_end_field_inertia).add_product(t9, shaft_end_dot),
        shaft_end_dot_dot).add_product(R::literal(0.75) * motor_i_sx.add_product(t6, motor_psi_sx)
        .sub_product(t15, motor_psi_rx), motor_psi_sx_dot).add_product(R::literal(0.75) * motor_i_sy
        .add_product(t6, motor_psi_sy).sub_product(t15, motor_psi_ry), motor_psi_sy_dot)
        .add_product(R::literal(0.75) * motor_i_rx.add_product(t8, motor_psi_rx).sub_product(t15,
        motor_psi_sx), motor_psi_rx_dot);
    PowerBalance {
        stored_rate: t16.add_product(R::literal(0.75) * motor_i_ry.add_product(t8, motor_psi_ry)
            .sub_product(t15, motor_psi_sy), motor_psi_ry_dot),
        supplied: (R::literal(1.5) * (motor_u_x * motor_i_sx).add_product(motor_u_y, motor_i_sy))
            .add_product(shaft_driven_dot, p.shaft_driven_field_force - t11)
            .add_product(shaft_end_dot, t14),
        dissipated: (p.coupling_damping * motor_omega * coupling_twist_rate)
            .add_product(R::literal(1.5), (p.motor_x_s * loss * (motor_i_sx * motor_i_sx)
            .add_product(motor_i_sy, motor_i_sy)).add_product(p.motor_alpha_r * motor_sigma
            * motor_x_r, (motor_i_rx * motor_i_rx).add_product(motor_i_ry, motor_i_ry)))
            .sub_product(t13 * shaft_driven_dot, coupling_twist_rate),
    }
}

/// Arguments of functions that are flat far from a place, such as `tanh` far from zero. Steps by
/// series are checked where one passes zero or turns. 3 operations.
#[must_use]
pub fn saturating_arguments<R: Real>(_time: R, state: &[R; STATES],
        p: &Parameters<R>) -> [R; SATURATIONS] {
    let [_, _, _, _, shaft_driven_dot, shaft_end_dot, ..] = *state;
    let inverse_shaft_standstill_band = R::literal(1.0) / p.shaft_standstill_band;
    let argument_1 = inverse_shaft_standstill_band * shaft_driven_dot;
    let argument_2 = inverse_shaft_standstill_band * shaft_end_dot;
    [argument_1, argument_2]
}

/// The field shaft.phi: angle of the section \[rad\].
///
/// One generic element: what acts at a point with u, u_x, u_t, u_xt at x. The loops over elements are the contract's.
pub mod shaft_phi {
    #[allow(
        clippy::wildcard_imports,
        unused_imports,
        reason = "what a field needs of it"
    )]
    use super::*;
    /// Parameters that the field depends on.
    pub const PARAMETERS: [u32; 12] = [13, 14, 15, 16, 17, 18, 19, 20, 21, 22, 23, 24];
    /// m, the inertia a length. 4 operations.
    #[must_use]
    #[inline(always)]
    pub fn inertia<R: Real>(_x: R, p: &Parameters<R>) -> [R; 1] {
        [p.shaft_inertia * (p.shaft_pieces - R::literal(1.0)) / (p.shaft_length * p.shaft_pieces)]
    }
    /// dm/dx, then dm/dp of `PARAMETERS`. 11 operations.
    #[must_use]
    #[inline]
    pub fn inertia_gradient<R: Real>(_x: R, p: &Parameters<R>) -> [R; 13] {
        let t0 = p.shaft_pieces - R::literal(1.0);
        [R::literal(0.0), -(p.shaft_inertia * t0 / (p.shaft_length * p.shaft_length
            * p.shaft_pieces)), p.shaft_inertia / (p.shaft_length * (p.shaft_pieces
            * p.shaft_pieces)), t0 / (p.shaft_length * p.shaft_pieces), R::literal(0.0),
            R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0),
            R::literal(0.0), R::literal(0.0), R::literal(0.0)]
    }
    /// Forces a length: f_0 = dL/du - dD/du_t + Q on u, f_1 = dL/du_x - dD/du_xt on u_x. 27 operations.
    #[must_use]
    #[inline]
    pub fn force<R: Real>(time: R, _x: R, point: &FieldPoint<R>, p: &Parameters<R>) -> [R; 2] {
        let [_, phi_x, phi_dot, phi_x_dot] = *point;
        [(R::literal(1.0) / p.shaft_pieces
            - R::literal(1.0)) / p.shaft_length * p.shaft_mean.add_product(p.shaft_amplitude,
            (R::literal(0.328_986_813_369_645_25) * p.shaft_speed * time).sin()) * (R::literal(1.0)
            / p.shaft_standstill_band * phi_dot).tanh() / (R::literal(1.0) + (R::literal(-1.0)
            / p.shaft_engagement_width * (time - p.shaft_engagement_time)).exp()), -(p.shaft_pieces
            * p.shaft_shear_modulus * p.shaft_polar_moment / (p.shaft_pieces - R::literal(1.0))
            * phi_x.add_product(p.shaft_loss_time, phi_x_dot))]
    }
    /// Derivatives of f_0, then of f_1, with respect to u, u_x, u_t, u_xt. 30 operations.
    #[must_use]
    #[inline]
    pub fn force_jacobian<R: Real>(time: R, _x: R, point: &FieldPoint<R>,
            p: &Parameters<R>) -> [R; 8] {
        let [_, _, phi_dot, _] = *point;
        let t0 = p.shaft_pieces - R::literal(1.0);
        let t1 = (R::literal(1.0) / p.shaft_standstill_band * phi_dot).tanh();
        let t2 = p.shaft_pieces * p.shaft_shear_modulus * p.shaft_polar_moment;
        [R::literal(0.0), R::literal(0.0), (R::literal(1.0) / p.shaft_pieces
            - R::literal(1.0)) / (p.shaft_length
            * p.shaft_standstill_band) * R::literal(1.0).sub_product(t1,
            t1) * p.shaft_mean.add_product(p.shaft_amplitude, (R::literal(0.328_986_813_369_645_25)
            * p.shaft_speed * time).sin()) / (R::literal(1.0) + (R::literal(-1.0)
            / p.shaft_engagement_width * (time - p.shaft_engagement_time)).exp()), R::literal(0.0),
            R::literal(0.0), -(t2 / t0), R::literal(0.0), -(t2 * p.shaft_loss_time / t0)]
    }
    /// Derivatives of f_0 and f_1 with respect to x, to t, then to `PARAMETERS`. 98 operations.
    #[must_use]
    #[inline]
    pub fn force_gradient<R: Real>(time: R, _x: R, point: &FieldPoint<R>,
            p: &Parameters<R>) -> [R; 28] {
        let [_, phi_x, phi_dot, phi_x_dot] = *point;
        let t0 = R::literal(0.328_986_813_369_645_25) * p.shaft_speed * time;
        let (t1, t2) = t0.sin_cos();
        let t3 = p.shaft_pieces - R::literal(1.0);
        let t4 = R::literal(1.0) - R::literal(1.0) / p.shaft_pieces;
        let t5 = p.shaft_mean.add_product(p.shaft_amplitude, t1);
        let time_minus_shaft_engagement_time = time - p.shaft_engagement_time;
        let t6 = R::literal(1.0) / p.shaft_engagement_width * time_minus_shaft_engagement_time;
        let t7 = R::literal(1.0) + (-t6).exp();
        let t8 = (R::literal(1.0) / p.shaft_standstill_band * phi_dot).tanh();
        let t9 = t4 / p.shaft_length;
        let t10 = phi_x.add_product(p.shaft_loss_time, phi_x_dot);
        let t11 = p.shaft_pieces * p.shaft_shear_modulus;
        let t12 = t11 * p.shaft_polar_moment;
        let t13 = t7 * (R::literal(1.0) + t6.exp());
        let t14 = t4 / (p.shaft_length * p.shaft_engagement_width) * t5 * t8 / t13;
        let t15 = R::literal(0.033_333_333_333_333_33) * p.shaft_amplitude;
        [R::literal(0.0), R::literal(0.0),
            t15 * p.shaft_speed * t4 * R::literal(-9.869_604_401_089_358) / p.shaft_length * t2
            * t8 / t7 - t14, R::literal(0.0), t4 / (p.shaft_length
            * p.shaft_length) * t5 * t8 / t7, R::literal(0.0), R::literal(-1.0) / (p.shaft_length
            * (p.shaft_pieces * p.shaft_pieces)) * t5 * t8 / t7,
            (-(p.shaft_shear_modulus * p.shaft_polar_moment / t3 * t10)).add_product(t12
            / (t3 * t3), t10), R::literal(0.0), R::literal(0.0), R::literal(0.0), -(p.shaft_pieces
            * p.shaft_polar_moment / t3 * t10), R::literal(0.0), -(t11 / t3 * t10),
            R::literal(0.0), -(t12 / t3 * phi_x_dot), -(t9 * t8 / t7), R::literal(0.0),
            -(t9 * t1 * t8 / t7), R::literal(0.0),
            t15 * t4 * R::literal(-9.869_604_401_089_358) / p.shaft_length * time * t2 * t8 / t7,
            R::literal(0.0), t14, R::literal(0.0), t4 / (p.shaft_length * (p.shaft_engagement_width
            * p.shaft_engagement_width)) * time_minus_shaft_engagement_time * t5 * t8 / t13,
            R::literal(0.0), t4 / (p.shaft_length * (p.shaft_standstill_band
            * p.shaft_standstill_band)) * phi_dot * R::literal(1.0).sub_product(t8, t8) * t5 / t7,
            R::literal(0.0)]
    }
    /// T and V a length \[J/m\]. 12 operations.
    #[must_use]
    #[inline]
    pub fn energy<R: Real>(_time: R, _x: R, point: &FieldPoint<R>, p: &Parameters<R>) -> [R; 2] {
        let [_, phi_x, phi_dot, _] = *point;
        let t0 = R::literal(1.0) - R::literal(1.0) / p.shaft_pieces;
        [R::literal(0.5) * p.shaft_inertia * t0 / p.shaft_length * (phi_dot * phi_dot),
            R::literal(0.5) * p.shaft_shear_modulus * p.shaft_polar_moment / t0 * (phi_x * phi_x)]
    }
    /// Rate of V, power supplied and power dissipated, a length \[W/m\]. 29 operations.
    #[must_use]
    #[inline]
    pub fn power<R: Real>(time: R, _x: R, point: &FieldPoint<R>, p: &Parameters<R>) -> [R; 3] {
        let [_, phi_x, phi_dot, phi_x_dot] = *point;
        let t0 = R::literal(1.0) - R::literal(1.0) / p.shaft_pieces;
        let t1 = p.shaft_shear_modulus * p.shaft_polar_moment;
        [t1 / t0 * phi_x * phi_x_dot, -(t0 / p.shaft_length * phi_dot * p.shaft_mean
            .add_product(p.shaft_amplitude, (R::literal(0.328_986_813_369_645_25) * p.shaft_speed
            * time).sin()) * (R::literal(1.0) / p.shaft_standstill_band * phi_dot).tanh()
            / (R::literal(1.0) + (R::literal(-1.0) / p.shaft_engagement_width
            * (time - p.shaft_engagement_time)).exp())), t1 * p.shaft_loss_time / t0 * (phi_x_dot
            * phi_x_dot)]
    }
    /// x of the attachments, then the length \[m\]. No operations.
    #[must_use]
    #[inline]
    pub fn places<R: Real>(p: &Parameters<R>) -> [R; 3] {
        [R::literal(0.0), p.shaft_length, p.shaft_length]
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
    /// u and u_t at the start. 2 operations.
    #[must_use]
    #[inline]
    pub fn initial<R: Real>(_x: R, p: &Parameters<R>) -> [R; 2] {
        [R::literal(0.0), R::literal(core::f64::consts::TAU) * p.motor_supply_frequency
            / p.motor_pole_pairs]
    }
    /// f_0 alone, at many points.
    ///
    /// 15 operations for all points, 4 for each.
    pub fn on_value<R: Real>(time: R, at: &[R], u: &[R], u_t: &[R], p: &Parameters<R>,
            force: &mut [R]) {
        let t0 = R::literal(1.0) + (R::literal(-1.0) / p.shaft_engagement_width
            * (time - p.shaft_engagement_time)).exp();
        let inverse_shaft_standstill_band = R::literal(1.0) / p.shaft_standstill_band;
        let t1 = (R::literal(1.0) / p.shaft_pieces - R::literal(1.0)) / p.shaft_length
            * p.shaft_mean.add_product(p.shaft_amplitude, (R::literal(0.328_986_813_369_645_25)
            * p.shaft_speed * time).sin());
        for (((_, _), &phi_dot), force) in at.iter().zip(u).zip(u_t).zip(force) {
            *force = t1 * (inverse_shaft_standstill_band * phi_dot).tanh() / t0;
        }
    }
    /// df_0/du and df_0/du_t, at many points.
    ///
    /// 15 operations for all points, 7 for each.
    pub fn on_value_jacobian<R: Real>(time: R, at: &[R], u: &[R], u_t: &[R], p: &Parameters<R>,
            by_u: &mut [R], by_u_t: &mut [R]) {
        let t0 = p.shaft_mean.add_product(p.shaft_amplitude, (R::literal(0.328_986_813_369_645_25)
            * p.shaft_speed * time).sin());
        let t1 = R::literal(1.0) + (R::literal(-1.0) / p.shaft_engagement_width
            * (time - p.shaft_engagement_time)).exp();
        let inverse_shaft_standstill_band = R::literal(1.0) / p.shaft_standstill_band;
        let t2 = (R::literal(1.0) / p.shaft_pieces - R::literal(1.0)) / (p.shaft_length
            * p.shaft_standstill_band);
        for ((((_, _), &phi_dot), by_u), by_u_t) in at.iter().zip(u).zip(u_t).zip(by_u)
                .zip(by_u_t) {
            let t0_2 = (inverse_shaft_standstill_band * phi_dot).tanh();
            *by_u = R::literal(0.0);
            *by_u_t = t2 * R::literal(1.0).sub_product(t0_2, t0_2) * t0 / t1;
        }
    }
    /// df_0/dt, at many points.
    ///
    /// 27 operations for all points, 7 for each.
    pub fn on_value_by_time<R: Real>(time: R, at: &[R], u: &[R], u_t: &[R], p: &Parameters<R>,
            by_time: &mut [R]) {
        let t0 = R::literal(0.328_986_813_369_645_25) * p.shaft_speed * time;
        let (t1, t2) = t0.sin_cos();
        let t3 = R::literal(1.0) - R::literal(1.0) / p.shaft_pieces;
        let t4 = R::literal(1.0) / p.shaft_engagement_width * (time - p.shaft_engagement_time);
        let t5 = R::literal(1.0) + (-t4).exp();
        let inverse_shaft_standstill_band = R::literal(1.0) / p.shaft_standstill_band;
        let t6 = t3 / (p.shaft_length * p.shaft_engagement_width) * p.shaft_mean
            .add_product(p.shaft_amplitude, t1);
        let t7 = t5 * (R::literal(1.0) + t4.exp());
        let t8 = R::literal(-0.033_333_333_333_333_33) * p.shaft_amplitude * p.shaft_speed * t3
            * R::literal(core::f64::consts::PI * core::f64::consts::PI) / p.shaft_length * t2;
        for (((_, _), &phi_dot), by_time) in at.iter().zip(u).zip(u_t).zip(by_time) {
            let t0 = (inverse_shaft_standstill_band * phi_dot).tanh();
            *by_time = t8 * t0 / t5 - t6 * t0 / t7;
        }
    }
    /// f_1 alone, at many points.
    ///
    /// 4 operations for all points, 4 for each.
    pub fn on_slope<R: Real>(u_x: &[R], u_xt: &[R], p: &Parameters<R>, force: &mut [R]) {
        let t0 = p.shaft_pieces * p.shaft_shear_modulus * p.shaft_polar_moment / (p.shaft_pieces
            - R::literal(1.0));
        for ((&phi_x, &phi_x_dot), force) in u_x.iter().zip(u_xt).zip(force) {
            *force = -(t0 * phi_x.add_product(p.shaft_loss_time, phi_x_dot));
        }
    }
    /// df_1/du_x and df_1/du_xt, at many points.
    ///
    /// 8 operations for all points, 0 for each.
    pub fn on_slope_jacobian<R: Real>(u_x: &[R], u_xt: &[R], p: &Parameters<R>, by_u_x: &mut [R],
            by_u_xt: &mut [R]) {
        let t0 = p.shaft_pieces - R::literal(1.0);
        let t1 = p.shaft_pieces * p.shaft_shear_modulus * p.shaft_polar_moment;
        let t2 = -(t1 / t0);
        let t3 = -(t1 * p.shaft_loss_time / t0);
        for (((_, _), by_u_x), by_u_xt) in u_x.iter().zip(u_xt).zip(by_u_x).zip(by_u_xt) {
            *by_u_x = t2;
            *by_u_xt = t3;
        }
    }
}

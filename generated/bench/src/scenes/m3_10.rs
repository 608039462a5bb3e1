// Emitted by Machinist 0.1.0; do not edit. To make it again:
//
//     cargo run --release -- gen
//
// Sources, with SHA-256:
//   91abc9bad01c2855c13904a46d691ae42c163ecc9a55bd6de520e0dd11cac4bb  bench/m3_10.toml
//   03bebde2dcd618fcbd0662a0f5e63f806e09d154c0fc25f1f0527c30944dd55e  units/textile/induction_motor.toml
//   512419e5aa73ad1710ef3556037050e97b898e87a7d5d8a4e9c4b03a7a8b0141  units/coupling.toml
//   ba9b76a100d91a8597c44349f557e301fa971bdcc9a7e0cf5da5ce4fd6af94b2  units/rotor.toml
//   02dd59962bd405d6a2dcac78b4101ca2138de7a376566a8d8c4460eb40293556  units/textile/technological_load.toml
//
// Benchmark M3: motor and torsional shaft of 10 pieces
//
// A motor at synchronous speed drives a shaft of 10 pieces through the coupling of the saw gin. A
// distributed load engages at 0.15 s.
//
// Source:
//   Benchmark models of textile-machine dynamics.
//
// All quantities are in SI units.
// Shapes: coordinates 11, first-order states 4, states 26, outputs 26, saturations 10.
// Nonzeros: mass_matrix 11 of 11 by 11, rate_jacobian 99 of 26 by 26, parameter_jacobian 0 of 26 by 0.
// Operations: rate 168, forcing 123, rate_jacobian 99, time_derivative 87, outputs 10, energy 90,
//     power_balance 307, saturating_arguments 10.

use ::machinist_contract::{
    Energy, PowerBalance, Real, taylor::{Lanes, order_and_inverse},
};

::machinist_contract::simulator! {
    /// Benchmark M3: motor and torsional shaft of 10 pieces
    ///
    /// A motor at synchronous speed drives a shaft of 10 pieces through the coupling of the saw gin. A
    /// distributed load engages at 0.15 s.
    ///
    /// Source: Benchmark models of textile-machine dynamics.
    M310: "m3_10", "Benchmark M3: motor and torsional shaft of 10 pieces";
    run from 0.0, until 0.5, points 501, rtol 1e-8, method "auto";
    quadratures 1, discontinuities 0;
    coordinates; saturations 10; series 36;
}

::machinist_contract::parameters! {}

::machinist_contract::outputs! {
    psi_x1: "V s", "psi_x1", "stator flux linkage along x";
    psi_y1: "V s", "psi_y1", "stator flux linkage along y";
    psi_x2: "V s", "psi_x2", "rotor flux linkage along x";
    psi_y2: "V s", "psi_y2", "rotor flux linkage along y";
    phi_d: "rad", "phi_d", "rotor angle";
    w_d: "rad/s", "w_d", "rate of rotor angle";
    phi_1: "rad", "phi_1", "angle";
    w_1: "rad/s", "w_1", "rate of angle";
    phi_2: "rad", "phi_2", "angle";
    w_2: "rad/s", "w_2", "rate of angle";
    phi_3: "rad", "phi_3", "angle";
    w_3: "rad/s", "w_3", "rate of angle";
    phi_4: "rad", "phi_4", "angle";
    w_4: "rad/s", "w_4", "rate of angle";
    phi_5: "rad", "phi_5", "angle";
    w_5: "rad/s", "w_5", "rate of angle";
    phi_6: "rad", "phi_6", "angle";
    w_6: "rad/s", "w_6", "rate of angle";
    phi_7: "rad", "phi_7", "angle";
    w_7: "rad/s", "w_7", "rate of angle";
    phi_8: "rad", "phi_8", "angle";
    w_8: "rad/s", "w_8", "rate of angle";
    phi_9: "rad", "phi_9", "angle";
    w_9: "rad/s", "w_9", "rate of angle";
    phi_10: "rad", "phi_10", "angle";
    w_10: "rad/s", "w_10", "rate of angle";
}

::machinist_contract::states! {
    MOTOR_PHI_RELATIVE: position, 1.0, "rad", "motor.phi_relative", "rotor angle, relative";
    PIECE_1_PHI_RELATIVE: position, 1.0, "rad", "piece_1.phi_relative", "angle, relative";
    PIECE_2_PHI_RELATIVE: position, 1.0, "rad", "piece_2.phi_relative", "angle, relative";
    PIECE_3_PHI_RELATIVE: position, 1.0, "rad", "piece_3.phi_relative", "angle, relative";
    PIECE_4_PHI_RELATIVE: position, 1.0, "rad", "piece_4.phi_relative", "angle, relative";
    PIECE_5_PHI_RELATIVE: position, 1.0, "rad", "piece_5.phi_relative", "angle, relative";
    PIECE_6_PHI_RELATIVE: position, 1.0, "rad", "piece_6.phi_relative", "angle, relative";
    PIECE_7_PHI_RELATIVE: position, 1.0, "rad", "piece_7.phi_relative", "angle, relative";
    PIECE_8_PHI_RELATIVE: position, 1.0, "rad", "piece_8.phi_relative", "angle, relative";
    PIECE_9_PHI_RELATIVE: position, 1.0, "rad", "piece_9.phi_relative", "angle, relative";
    MOTOR_OMEGA: velocity, 78.5, "rad/s", "motor.omega", "rate of rotor angle";
    PIECE_1_OMEGA: velocity, 78.5, "rad/s", "piece_1.omega", "rate of angle";
    PIECE_2_OMEGA: velocity, 78.5, "rad/s", "piece_2.omega", "rate of angle";
    PIECE_3_OMEGA: velocity, 78.5, "rad/s", "piece_3.omega", "rate of angle";
    PIECE_4_OMEGA: velocity, 78.5, "rad/s", "piece_4.omega", "rate of angle";
    PIECE_5_OMEGA: velocity, 78.5, "rad/s", "piece_5.omega", "rate of angle";
    PIECE_6_OMEGA: velocity, 78.5, "rad/s", "piece_6.omega", "rate of angle";
    PIECE_7_OMEGA: velocity, 78.5, "rad/s", "piece_7.omega", "rate of angle";
    PIECE_8_OMEGA: velocity, 78.5, "rad/s", "piece_8.omega", "rate of angle";
    PIECE_9_OMEGA: velocity, 78.5, "rad/s", "piece_9.omega", "rate of angle";
    PIECE_10_OMEGA: velocity, 78.5, "rad/s", "piece_10.omega", "rate of angle";
    MOTOR_PSI_SX: first_order, 1.0, "V s", "motor.psi_sx", "stator flux linkage along x";
    MOTOR_PSI_SY: first_order, 1.0, "V s", "motor.psi_sy", "stator flux linkage along y";
    MOTOR_PSI_RX: first_order, 1.0, "V s", "motor.psi_rx", "rotor flux linkage along x";
    MOTOR_PSI_RY: first_order, 1.0, "V s", "motor.psi_ry", "rotor flux linkage along y";
    PIECE_10_PHI: position, 150.0, "rad", "piece_10.phi", "angle";
}

::machinist_contract::coordinates! {
    "motor.phi", "rad", "rotor angle";
    "piece_1.phi", "rad", "angle";
    "piece_2.phi", "rad", "angle";
    "piece_3.phi", "rad", "angle";
    "piece_4.phi", "rad", "angle";
    "piece_5.phi", "rad", "angle";
    "piece_6.phi", "rad", "angle";
    "piece_7.phi", "rad", "angle";
    "piece_8.phi", "rad", "angle";
    "piece_9.phi", "rad", "angle";
    "piece_10.phi", "rad", "angle";
}

::machinist_contract::patterns! {
    /// Nonzeros of M.
    MASS_MATRIX_PATTERN: 11 by 11 { 0 [0] 1 [1] 2 [2] 3 [3] 4 [4] 5 [5] 6 [6] 7 [7] 8 [8] 9 [9]
        10 [10] }
    /// Nonzeros of dy'/dy.
    RATE_JACOBIAN_PATTERN: 26 by 26 { 0 [10 20] 1 [11 20] 2 [12 20] 3 [13 20] 4 [14 20] 5 [15 20]
        6 [16 20] 7 [17 20] 8 [18 20] 9 [19 20] 10 [0 1 10 11 21 22 23 24] 11 [0 1 2 10 11 12]
        12 [1 2 3 11 12 13] 13 [2 3 4 12 13 14] 14 [3 4 5 13 14 15] 15 [4 5 6 14 15 16]
        16 [5 6 7 15 16 17] 17 [6 7 8 16 17 18] 18 [7 8 9 17 18 19] 19 [8 9 18 19 20] 20 [9 19 20]
        21 [21 22 23] 22 [21 22 24] 23 [10 21 23 24] 24 [10 22 23 24] 25 [20] }
    /// Nonzeros of dy'/dp.
    PARAMETER_JACOBIAN_PATTERN: 26 by 0 {  }
}

/// State at the start of the run, in the units of the states. No operations.
#[must_use]
pub fn initial_state<R: Real>(_p: &Parameters<R>) -> [R; STATES] {
    [R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0),
        R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0),
        R::literal(78.539_816_339_744_83), R::literal(78.539_816_339_744_83),
        R::literal(78.539_816_339_744_83), R::literal(78.539_816_339_744_83),
        R::literal(78.539_816_339_744_83), R::literal(78.539_816_339_744_83),
        R::literal(78.539_816_339_744_83), R::literal(78.539_816_339_744_83),
        R::literal(78.539_816_339_744_83), R::literal(78.539_816_339_744_83),
        R::literal(78.539_816_339_744_83), R::literal(0.010_236_251_772_451_205),
        R::literal(-0.990_242_134_409_894_5), R::literal(0.009_785_856_694_463_354),
        R::literal(-0.946_671_480_495_859_1), R::literal(0.0)]
}

/// Times of known jumps of the right-hand side \[s\], unsorted. No operations.
#[must_use]
pub fn discontinuities<R: Real>(_p: &Parameters<R>) -> [R; DISCONTINUITIES] {
    []
}

/// `y'`: velocities, `q''` of `M q'' = f + G^T lambda`, `h`; in the units of the states per second.
/// 168 operations.
#[must_use]
#[inline]
pub fn rate<R: Real>(time: R, state: &[R; STATES], _p: &Parameters<R>) -> [R; STATES] {
    let [motor_phi_relative, piece_1_phi_relative, piece_2_phi_relative, piece_3_phi_relative,
        piece_4_phi_relative, piece_5_phi_relative, piece_6_phi_relative, piece_7_phi_relative,
        piece_8_phi_relative, piece_9_phi_relative, motor_omega, piece_1_omega, piece_2_omega,
        piece_3_omega, piece_4_omega, piece_5_omega, piece_6_omega, piece_7_omega, piece_8_omega,
        piece_9_omega, piece_10_omega, motor_psi_sx, motor_psi_sy, motor_psi_rx, motor_psi_ry, ..]
        = *state;
    let [t0, t1, t2, t3, t4, t5, t6, t7, t8, t9] = R::tanh_each([R::literal(2.0) * piece_1_omega,
        R::literal(2.0) * piece_2_omega, R::literal(2.0) * piece_3_omega,
        R::literal(2.0) * piece_4_omega, R::literal(2.0) * piece_5_omega,
        R::literal(2.0) * piece_6_omega, R::literal(2.0) * piece_7_omega,
        R::literal(2.0) * piece_8_omega, R::literal(2.0) * piece_9_omega,
        R::literal(2.0) * piece_10_omega]);
    let coupling_twist = motor_phi_relative - piece_1_phi_relative;
    let coupling_twist_rate = motor_omega - piece_1_omega;
    let motor_slip_speed = R::literal(314.159_265_358_979_3).sub_product(R::literal(4.0),
        motor_omega);
    let motor_i_sx = R::literal(844.204_793_982_429_1) * motor_psi_sx
        .sub_product(R::literal(0.952), motor_psi_rx);
    let motor_i_sy = R::literal(844.204_793_982_429_1) * motor_psi_sy
        .sub_product(R::literal(0.952), motor_psi_ry);
    let load_1_engagement = R::literal(1.0) / (R::literal(1.0) + (R::literal(-50.0)
        * (time - R::literal(0.15))).exp());
    let motor_torque = R::literal(4_822.097_783_227_635) * (motor_psi_sy * motor_psi_rx)
        .sub_product(motor_psi_sx, motor_psi_ry);
    let t10 = R::literal(128.5346) * coupling_twist_rate;
    let t11 = R::literal(23065.2) * coupling_twist;
    let coupling_torque = t10 + t11;
    let t12 = load_1_engagement * R::literal(84.372).add_product(R::literal(7.878),
        (R::literal(241.805_307_826_689_27) * time).sin());
    let load_1_resistance = t12 * t0;
    let load_2_resistance = t12 * t1;
    let load_3_resistance = t12 * t2;
    let load_4_resistance = t12 * t3;
    let load_5_resistance = t12 * t4;
    let load_6_resistance = t12 * t5;
    let load_7_resistance = t12 * t6;
    let load_8_resistance = t12 * t7;
    let load_9_resistance = t12 * t8;
    let load_10_resistance = t12 * t9;
    let t13 = R::literal(3_382_256.675_279_931) * (piece_1_phi_relative - piece_2_phi_relative);
    let t14 = R::literal(67.645_133_505_598_62) * (piece_1_omega - piece_2_omega);
    let t15 = R::literal(3_382_256.675_279_931) * (piece_2_phi_relative - piece_3_phi_relative);
    let t16 = R::literal(67.645_133_505_598_62) * (piece_2_omega - piece_3_omega);
    let t17 = R::literal(3_382_256.675_279_931) * (piece_3_phi_relative - piece_4_phi_relative);
    let t18 = R::literal(67.645_133_505_598_62) * (piece_3_omega - piece_4_omega);
    let t19 = R::literal(3_382_256.675_279_931) * (piece_4_phi_relative - piece_5_phi_relative);
    let t20 = R::literal(67.645_133_505_598_62) * (piece_4_omega - piece_5_omega);
    let t21 = R::literal(3_382_256.675_279_931) * (piece_5_phi_relative - piece_6_phi_relative);
    let t22 = R::literal(67.645_133_505_598_62) * (piece_5_omega - piece_6_omega);
    let t23 = R::literal(3_382_256.675_279_931) * (piece_6_phi_relative - piece_7_phi_relative);
    let t24 = R::literal(67.645_133_505_598_62) * (piece_6_omega - piece_7_omega);
    let t25 = R::literal(3_382_256.675_279_931) * (piece_7_phi_relative - piece_8_phi_relative);
    let t26 = R::literal(67.645_133_505_598_62) * (piece_7_omega - piece_8_omega);
    let t27 = R::literal(3_382_256.675_279_931) * (piece_8_phi_relative - piece_9_phi_relative);
    let t28 = R::literal(67.645_133_505_598_62) * (piece_8_omega - piece_9_omega);
    let t29 = R::literal(3_382_256.675_279_931) * piece_9_phi_relative;
    let piece_9_omega_minus_piece_10_omega = piece_9_omega - piece_10_omega;
    let t30 = R::literal(67.645_133_505_598_62) * piece_9_omega_minus_piece_10_omega;
    let piece_10_omega_dot = (t30 + t29 - load_10_resistance) * R::literal(8.038_585_209_003_216);
    let piece_9_omega_dot = (t27 - t29 - load_9_resistance - (t30 - t28))
        * R::literal(8.038_585_209_003_216);
    let piece_8_omega_dot = (t25 - t27 - load_8_resistance - (t28 - t26))
        * R::literal(8.038_585_209_003_216);
    let piece_7_omega_dot = (t23 - t25 - load_7_resistance - (t26 - t24))
        * R::literal(8.038_585_209_003_216);
    let piece_6_omega_dot = (t21 - t23 - load_6_resistance - (t24 - t22))
        * R::literal(8.038_585_209_003_216);
    let piece_5_omega_dot = (t19 - t21 - load_5_resistance - (t22 - t20))
        * R::literal(8.038_585_209_003_216);
    let piece_4_omega_dot = (t17 - t19 - load_4_resistance - (t20 - t18))
        * R::literal(8.038_585_209_003_216);
    let piece_3_omega_dot = (t15 - t17 - load_3_resistance - (t18 - t16))
        * R::literal(8.038_585_209_003_216);
    let piece_2_omega_dot = (t13 - t15 - load_2_resistance - (t16 - t14))
        * R::literal(8.038_585_209_003_216);
    let piece_1_omega_dot = (t11 - t13 - load_1_resistance - (t14 - t10))
        * R::literal(8.038_585_209_003_216);
    let motor_omega_dot = (motor_torque - coupling_torque) * R::literal(0.238_095_238_095_238_08);
    let motor_psi_sx_dot = R::literal(311.126_983_722_080_9)
        .add_product(R::literal(314.159_265_358_979_3), motor_psi_sy)
        .sub_product(R::literal(0.042_795_676_8), motor_i_sx);
    let motor_psi_sy_dot = (R::literal(-314.159_265_358_979_3) * motor_psi_sx)
        .sub_product(R::literal(0.042_795_676_8), motor_i_sy);
    let motor_psi_rx_dot = (R::literal(26.954_864_967_800_425) * (-motor_psi_rx)
        .add_product(R::literal(0.956), motor_psi_sx)).add_product(motor_psi_ry, motor_slip_speed);
    let motor_psi_ry_dot = (R::literal(26.954_864_967_800_425) * (-motor_psi_ry)
        .add_product(R::literal(0.956), motor_psi_sy)).sub_product(motor_psi_rx, motor_slip_speed);
    let motor_phi_relative_dot = motor_omega - piece_10_omega;
    let piece_1_phi_relative_dot = piece_1_omega - piece_10_omega;
    let piece_2_phi_relative_dot = piece_2_omega - piece_10_omega;
    let piece_3_phi_relative_dot = piece_3_omega - piece_10_omega;
    let piece_4_phi_relative_dot = piece_4_omega - piece_10_omega;
    let piece_5_phi_relative_dot = piece_5_omega - piece_10_omega;
    let piece_6_phi_relative_dot = piece_6_omega - piece_10_omega;
    let piece_7_phi_relative_dot = piece_7_omega - piece_10_omega;
    let piece_8_phi_relative_dot = piece_8_omega - piece_10_omega;
    [motor_phi_relative_dot, piece_1_phi_relative_dot, piece_2_phi_relative_dot,
        piece_3_phi_relative_dot, piece_4_phi_relative_dot, piece_5_phi_relative_dot,
        piece_6_phi_relative_dot, piece_7_phi_relative_dot, piece_8_phi_relative_dot,
        piece_9_omega_minus_piece_10_omega, motor_omega_dot, piece_1_omega_dot, piece_2_omega_dot,
        piece_3_omega_dot, piece_4_omega_dot, piece_5_omega_dot, piece_6_omega_dot,
        piece_7_omega_dot, piece_8_omega_dot, piece_9_omega_dot, piece_10_omega_dot,
        motor_psi_sx_dot, motor_psi_sy_dot, motor_psi_rx_dot, motor_psi_ry_dot, piece_10_omega]
}

/// `M = d2L/dq'2`, values in the order of its pattern. No operations.
#[must_use]
pub fn mass_matrix<R: Real>(_time: R, _state: &[R; STATES], _p: &Parameters<R>) -> [R; 11] {
    [R::literal(4.2), R::literal(0.1244), R::literal(0.1244), R::literal(0.1244),
        R::literal(0.1244), R::literal(0.1244), R::literal(0.1244), R::literal(0.1244),
        R::literal(0.1244), R::literal(0.1244), R::literal(0.1244)]
}

/// `f` of `M q'' = f + G^T lambda`, one for each coordinate. 123 operations.
#[must_use]
pub fn forcing<R: Real>(time: R, state: &[R; STATES], _p: &Parameters<R>) -> [R; COORDINATES] {
    let [motor_phi_relative, piece_1_phi_relative, piece_2_phi_relative, piece_3_phi_relative,
        piece_4_phi_relative, piece_5_phi_relative, piece_6_phi_relative, piece_7_phi_relative,
        piece_8_phi_relative, piece_9_phi_relative, motor_omega, piece_1_omega, piece_2_omega,
        piece_3_omega, piece_4_omega, piece_5_omega, piece_6_omega, piece_7_omega, piece_8_omega,
        piece_9_omega, piece_10_omega, motor_psi_sx, motor_psi_sy, motor_psi_rx, motor_psi_ry, ..]
        = *state;
    let [t0, t1, t2, t3, t4, t5, t6, t7, t8, t9] = R::tanh_each([R::literal(2.0) * piece_1_omega,
        R::literal(2.0) * piece_2_omega, R::literal(2.0) * piece_3_omega,
        R::literal(2.0) * piece_4_omega, R::literal(2.0) * piece_5_omega,
        R::literal(2.0) * piece_6_omega, R::literal(2.0) * piece_7_omega,
        R::literal(2.0) * piece_8_omega, R::literal(2.0) * piece_9_omega,
        R::literal(2.0) * piece_10_omega]);
    let coupling_twist = motor_phi_relative - piece_1_phi_relative;
    let coupling_twist_rate = motor_omega - piece_1_omega;
    let load_1_engagement = R::literal(1.0) / (R::literal(1.0) + (R::literal(-50.0)
        * (time - R::literal(0.15))).exp());
    let motor_torque = R::literal(4_822.097_783_227_635) * (motor_psi_sy * motor_psi_rx)
        .sub_product(motor_psi_sx, motor_psi_ry);
    let t10 = R::literal(128.5346) * coupling_twist_rate;
    let t11 = R::literal(23065.2) * coupling_twist;
    let coupling_torque = t10 + t11;
    let t12 = load_1_engagement * R::literal(84.372).add_product(R::literal(7.878),
        (R::literal(241.805_307_826_689_27) * time).sin());
    let load_1_resistance = t12 * t0;
    let load_2_resistance = t12 * t1;
    let load_3_resistance = t12 * t2;
    let load_4_resistance = t12 * t3;
    let load_5_resistance = t12 * t4;
    let load_6_resistance = t12 * t5;
    let load_7_resistance = t12 * t6;
    let load_8_resistance = t12 * t7;
    let load_9_resistance = t12 * t8;
    let load_10_resistance = t12 * t9;
    let motor_phi_forcing = motor_torque - coupling_torque;
    let t13 = R::literal(3_382_256.675_279_931) * (piece_1_phi_relative - piece_2_phi_relative);
    let t14 = R::literal(67.645_133_505_598_62) * (piece_1_omega - piece_2_omega);
    let piece_1_phi_forcing = t11 - t13 - load_1_resistance - (t14 - t10);
    let t15 = R::literal(3_382_256.675_279_931) * (piece_2_phi_relative - piece_3_phi_relative);
    let t16 = R::literal(67.645_133_505_598_62) * (piece_2_omega - piece_3_omega);
    let piece_2_phi_forcing = t13 - t15 - load_2_resistance - (t16 - t14);
    let t17 = R::literal(3_382_256.675_279_931) * (piece_3_phi_relative - piece_4_phi_relative);
    let t18 = R::literal(67.645_133_505_598_62) * (piece_3_omega - piece_4_omega);
    let piece_3_phi_forcing = t15 - t17 - load_3_resistance - (t18 - t16);
    let t19 = R::literal(3_382_256.675_279_931) * (piece_4_phi_relative - piece_5_phi_relative);
    let t20 = R::literal(67.645_133_505_598_62) * (piece_4_omega - piece_5_omega);
    let piece_4_phi_forcing = t17 - t19 - load_4_resistance - (t20 - t18);
    let t21 = R::literal(3_382_256.675_279_931) * (piece_5_phi_relative - piece_6_phi_relative);
    let t22 = R::literal(67.645_133_505_598_62) * (piece_5_omega - piece_6_omega);
    let piece_5_phi_forcing = t19 - t21 - load_5_resistance - (t22 - t20);
    let t23 = R::literal(3_382_256.675_279_931) * (piece_6_phi_relative - piece_7_phi_relative);
    let t24 = R::literal(67.645_133_505_598_62) * (piece_6_omega - piece_7_omega);
    let piece_6_phi_forcing = t21 - t23 - load_6_resistance - (t24 - t22);
    let t25 = R::literal(3_382_256.675_279_931) * (piece_7_phi_relative - piece_8_phi_relative);
    let t26 = R::literal(67.645_133_505_598_62) * (piece_7_omega - piece_8_omega);
    let piece_7_phi_forcing = t23 - t25 - load_7_resistance - (t26 - t24);
    let t27 = R::literal(3_382_256.675_279_931) * (piece_8_phi_relative - piece_9_phi_relative);
    let t28 = R::literal(67.645_133_505_598_62) * (piece_8_omega - piece_9_omega);
    let piece_8_phi_forcing = t25 - t27 - load_8_resistance - (t28 - t26);
    let t29 = R::literal(3_382_256.675_279_931) * piece_9_phi_relative;
    let t30 = R::literal(67.645_133_505_598_62) * (piece_9_omega - piece_10_omega);
    let piece_9_phi_forcing = t27 - t29 - load_9_resistance - (t30 - t28);
    let piece_10_phi_forcing = t30 + t29 - load_10_resistance;
    [motor_phi_forcing, piece_1_phi_forcing, piece_2_phi_forcing, piece_3_phi_forcing,
        piece_4_phi_forcing, piece_5_phi_forcing, piece_6_phi_forcing, piece_7_phi_forcing,
        piece_8_phi_forcing, piece_9_phi_forcing, piece_10_phi_forcing]
}

/// `dy'/dy`, values in the order of its pattern. 99 operations.
#[must_use]
pub fn rate_jacobian<R: Real>(time: R, state: &[R; STATES], _p: &Parameters<R>) -> [R; 99] {
    let [_, _, _, _, _, _, _, _, _, _, motor_omega, piece_1_omega, piece_2_omega, piece_3_omega,
        piece_4_omega, piece_5_omega, piece_6_omega, piece_7_omega, piece_8_omega, piece_9_omega,
        piece_10_omega, motor_psi_sx, motor_psi_sy, motor_psi_rx, motor_psi_ry, ..] = *state;
    let [t0, t1, t2, t3, t4, t5, t6, t7, t8, t9] = R::tanh_each([R::literal(2.0) * piece_1_omega,
        R::literal(2.0) * piece_2_omega, R::literal(2.0) * piece_3_omega,
        R::literal(2.0) * piece_4_omega, R::literal(2.0) * piece_5_omega,
        R::literal(2.0) * piece_6_omega, R::literal(2.0) * piece_7_omega,
        R::literal(2.0) * piece_8_omega, R::literal(2.0) * piece_9_omega,
        R::literal(2.0) * piece_10_omega]);
    let t10 = R::literal(4.0) * motor_omega;
    let motor_slip_speed = R::literal(314.159_265_358_979_3) - t10;
    let load_1_engagement = R::literal(1.0) / (R::literal(1.0) + (R::literal(-50.0)
        * (time - R::literal(0.15))).exp());
    let t11 = R::literal(84.372).add_product(R::literal(7.878), (R::literal(241.805_307_826_689_27)
        * time).sin());
    let motor_psi_rx_dot_by_motor_omega = R::literal(-4.0) * motor_psi_ry;
    let motor_psi_ry_dot_by_motor_omega = R::literal(4.0) * motor_psi_rx;
    let t12 = R::literal(2.0) * load_1_engagement;
    let piece_1_omega_dot_by_piece_1_omega = R::literal(-196.179_733_505_598_62).sub_product(t12
        * R::literal(1.0).sub_product(t0, t0), t11) * R::literal(8.038_585_209_003_216);
    let piece_2_omega_dot_by_piece_2_omega = R::literal(-135.290_267_011_197_24).sub_product(t12
        * R::literal(1.0).sub_product(t1, t1), t11) * R::literal(8.038_585_209_003_216);
    let piece_3_omega_dot_by_piece_3_omega = R::literal(-135.290_267_011_197_24).sub_product(t12
        * R::literal(1.0).sub_product(t2, t2), t11) * R::literal(8.038_585_209_003_216);
    let piece_4_omega_dot_by_piece_4_omega = R::literal(-135.290_267_011_197_24).sub_product(t12
        * R::literal(1.0).sub_product(t3, t3), t11) * R::literal(8.038_585_209_003_216);
    let piece_5_omega_dot_by_piece_5_omega = R::literal(-135.290_267_011_197_24).sub_product(t12
        * R::literal(1.0).sub_product(t4, t4), t11) * R::literal(8.038_585_209_003_216);
    let piece_6_omega_dot_by_piece_6_omega = R::literal(-135.290_267_011_197_24).sub_product(t12
        * R::literal(1.0).sub_product(t5, t5), t11) * R::literal(8.038_585_209_003_216);
    let piece_7_omega_dot_by_piece_7_omega = R::literal(-135.290_267_011_197_24).sub_product(t12
        * R::literal(1.0).sub_product(t6, t6), t11) * R::literal(8.038_585_209_003_216);
    let piece_8_omega_dot_by_piece_8_omega = R::literal(-135.290_267_011_197_24).sub_product(t12
        * R::literal(1.0).sub_product(t7, t7), t11) * R::literal(8.038_585_209_003_216);
    let piece_9_omega_dot_by_piece_9_omega = R::literal(-135.290_267_011_197_24).sub_product(t12
        * R::literal(1.0).sub_product(t8, t8), t11) * R::literal(8.038_585_209_003_216);
    let piece_10_omega_dot_by_piece_10_omega = R::literal(-67.645_133_505_598_62).sub_product(t12
        * R::literal(1.0).sub_product(t9, t9), t11) * R::literal(8.038_585_209_003_216);
    let motor_omega_dot_by_motor_psi_sx = R::literal(-1_148.118_519_816_103_6) * motor_psi_ry;
    let motor_omega_dot_by_motor_psi_sy = R::literal(1_148.118_519_816_103_6) * motor_psi_rx;
    let motor_omega_dot_by_motor_psi_rx = R::literal(1_148.118_519_816_103_6) * motor_psi_sy;
    let motor_psi_ry_dot_by_motor_psi_rx = t10 - R::literal(314.159_265_358_979_3);
    let motor_omega_dot_by_motor_psi_ry = R::literal(-1_148.118_519_816_103_6) * motor_psi_sx;
    [R::literal(1.0), R::literal(-1.0), R::literal(1.0), R::literal(-1.0), R::literal(1.0),
        R::literal(-1.0), R::literal(1.0), R::literal(-1.0), R::literal(1.0), R::literal(-1.0),
        R::literal(1.0), R::literal(-1.0), R::literal(1.0), R::literal(-1.0), R::literal(1.0),
        R::literal(-1.0), R::literal(1.0), R::literal(-1.0), R::literal(1.0), R::literal(-1.0),
        R::literal(-5_491.714_285_714_285), R::literal(5_491.714_285_714_285),
        R::literal(-30.603_476_190_476_19), R::literal(30.603_476_190_476_19),
        motor_omega_dot_by_motor_psi_sx, motor_omega_dot_by_motor_psi_sy,
        motor_omega_dot_by_motor_psi_rx, motor_omega_dot_by_motor_psi_ry,
        R::literal(185_411.575_562_700_98), R::literal(-27_373_970.058_520_347),
        R::literal(27_188_558.482_957_646), R::literal(1_033.236_334_405_144_8),
        piece_1_omega_dot_by_piece_1_omega, R::literal(543.771_169_659_153),
        R::literal(27_188_558.482_957_646), R::literal(-54_377_116.965_915_29),
        R::literal(27_188_558.482_957_646), R::literal(543.771_169_659_153),
        piece_2_omega_dot_by_piece_2_omega, R::literal(543.771_169_659_153),
        R::literal(27_188_558.482_957_646), R::literal(-54_377_116.965_915_29),
        R::literal(27_188_558.482_957_646), R::literal(543.771_169_659_153),
        piece_3_omega_dot_by_piece_3_omega, R::literal(543.771_169_659_153),
        R::literal(27_188_558.482_957_646), R::literal(-54_377_116.965_915_29),
        R::literal(27_188_558.482_957_646), R::literal(543.771_169_659_153),
        piece_4_omega_dot_by_piece_4_omega, R::literal(543.771_169_659_153),
        R::literal(27_188_558.482_957_646), R::literal(-54_377_116.965_915_29),
        R::literal(27_188_558.482_957_646), R::literal(543.771_169_659_153),
        piece_5_omega_dot_by_piece_5_omega, R::literal(543.771_169_659_153),
        R::literal(27_188_558.482_957_646), R::literal(-54_377_116.965_915_29),
        R::literal(27_188_558.482_957_646), R::literal(543.771_169_659_153),
        piece_6_omega_dot_by_piece_6_omega, R::literal(543.771_169_659_153),
        R::literal(27_188_558.482_957_646), R::literal(-54_377_116.965_915_29),
        R::literal(27_188_558.482_957_646), R::literal(543.771_169_659_153),
        piece_7_omega_dot_by_piece_7_omega, R::literal(543.771_169_659_153),
        R::literal(27_188_558.482_957_646), R::literal(-54_377_116.965_915_29),
        R::literal(27_188_558.482_957_646), R::literal(543.771_169_659_153),
        piece_8_omega_dot_by_piece_8_omega, R::literal(543.771_169_659_153),
        R::literal(27_188_558.482_957_646), R::literal(-54_377_116.965_915_29),
        R::literal(543.771_169_659_153), piece_9_omega_dot_by_piece_9_omega,
        R::literal(543.771_169_659_153), R::literal(27_188_558.482_957_646),
        R::literal(543.771_169_659_153), piece_10_omega_dot_by_piece_10_omega,
        R::literal(-36.128_315_516_282_62), R::literal(314.159_265_358_979_3),
        R::literal(34.394_156_371_501_055), R::literal(-314.159_265_358_979_3),
        R::literal(-36.128_315_516_282_62), R::literal(34.394_156_371_501_055),
        motor_psi_rx_dot_by_motor_omega, R::literal(25.768_850_909_217_203),
        R::literal(-26.954_864_967_800_425), motor_slip_speed, motor_psi_ry_dot_by_motor_omega,
        R::literal(25.768_850_909_217_203), motor_psi_ry_dot_by_motor_psi_rx,
        R::literal(-26.954_864_967_800_425), R::literal(1.0)]
}

/// `dy'/dp`, values in the order of its pattern. No operations.
#[must_use]
pub fn parameter_jacobian<R: Real>(_time: R, _state: &[R; STATES], _p: &Parameters<R>) -> [R; 0] {
    []
}

/// Partial derivative of `y'` with respect to time. 87 operations.
#[must_use]
pub fn time_derivative<R: Real>(time: R, state: &[R; STATES], _p: &Parameters<R>) -> [R; STATES] {
    let [_, _, _, _, _, _, _, _, _, _, _, piece_1_omega, piece_2_omega, piece_3_omega,
        piece_4_omega, piece_5_omega, piece_6_omega, piece_7_omega, piece_8_omega, piece_9_omega,
        piece_10_omega, ..] = *state;
    let t0 = R::literal(241.805_307_826_689_27) * time;
    let (t1, t2) = t0.sin_cos();
    let [t3, t4, t5, t6, t7, t8, t9, t10, t11, t12]
        = R::tanh_each([R::literal(2.0) * piece_1_omega, R::literal(2.0) * piece_2_omega,
        R::literal(2.0) * piece_3_omega, R::literal(2.0) * piece_4_omega,
        R::literal(2.0) * piece_5_omega, R::literal(2.0) * piece_6_omega,
        R::literal(2.0) * piece_7_omega, R::literal(2.0) * piece_8_omega,
        R::literal(2.0) * piece_9_omega, R::literal(2.0) * piece_10_omega]);
    let t13 = R::literal(50.0) * (time - R::literal(0.15));
    let t14 = R::literal(1.0) + (-t13).exp();
    let load_1_engagement = R::literal(1.0) / t14;
    let t15 = R::literal(1_904.942_215_058_658_1) * load_1_engagement * t2;
    let t16 = R::literal(50.0) * R::literal(84.372).add_product(R::literal(7.878), t1);
    let t17 = t14 * (R::literal(1.0) + t13.exp());
    let piece_10_omega_dot_by_time = (t16 * t12 / t17).add_product(t15, t12)
        * R::literal(-8.038_585_209_003_216);
    let piece_9_omega_dot_by_time = (t16 * t11 / t17).add_product(t15, t11)
        * R::literal(-8.038_585_209_003_216);
    let piece_8_omega_dot_by_time = (t16 * t10 / t17).add_product(t15, t10)
        * R::literal(-8.038_585_209_003_216);
    let piece_7_omega_dot_by_time = (t16 * t9 / t17).add_product(t15, t9)
        * R::literal(-8.038_585_209_003_216);
    let piece_6_omega_dot_by_time = (t16 * t8 / t17).add_product(t15, t8)
        * R::literal(-8.038_585_209_003_216);
    let piece_5_omega_dot_by_time = (t16 * t7 / t17).add_product(t15, t7)
        * R::literal(-8.038_585_209_003_216);
    let piece_4_omega_dot_by_time = (t16 * t6 / t17).add_product(t15, t6)
        * R::literal(-8.038_585_209_003_216);
    let piece_3_omega_dot_by_time = (t16 * t5 / t17).add_product(t15, t5)
        * R::literal(-8.038_585_209_003_216);
    let piece_2_omega_dot_by_time = (t16 * t4 / t17).add_product(t15, t4)
        * R::literal(-8.038_585_209_003_216);
    let piece_1_omega_dot_by_time = (t16 * t3 / t17).add_product(t15, t3)
        * R::literal(-8.038_585_209_003_216);
    [R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0),
        R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0),
        R::literal(0.0), piece_1_omega_dot_by_time, piece_2_omega_dot_by_time,
        piece_3_omega_dot_by_time, piece_4_omega_dot_by_time, piece_5_omega_dot_by_time,
        piece_6_omega_dot_by_time, piece_7_omega_dot_by_time, piece_8_omega_dot_by_time,
        piece_9_omega_dot_by_time, piece_10_omega_dot_by_time, R::literal(0.0), R::literal(0.0),
        R::literal(0.0), R::literal(0.0), R::literal(0.0)]
}

/// Wanted outputs. 10 operations.
#[must_use]
pub fn outputs<R: Real>(_time: R, state: &[R; STATES], _p: &Parameters<R>) -> Outputs<R> {
    let [motor_phi_relative, piece_1_phi_relative, piece_2_phi_relative, piece_3_phi_relative,
        piece_4_phi_relative, piece_5_phi_relative, piece_6_phi_relative, piece_7_phi_relative,
        piece_8_phi_relative, piece_9_phi_relative, motor_omega, piece_1_omega, piece_2_omega,
        piece_3_omega, piece_4_omega, piece_5_omega, piece_6_omega, piece_7_omega, piece_8_omega,
        piece_9_omega, piece_10_omega, motor_psi_sx, motor_psi_sy, motor_psi_rx, motor_psi_ry,
        piece_10_phi] = *state;
    Outputs {
        psi_x1: motor_psi_sx,
        psi_y1: motor_psi_sy,
        psi_x2: motor_psi_rx,
        psi_y2: motor_psi_ry,
        phi_d: motor_phi_relative + piece_10_phi,
        w_d: motor_omega,
        phi_1: piece_1_phi_relative + piece_10_phi,
        w_1: piece_1_omega,
        phi_2: piece_2_phi_relative + piece_10_phi,
        w_2: piece_2_omega,
        phi_3: piece_3_phi_relative + piece_10_phi,
        w_3: piece_3_omega,
        phi_4: piece_4_phi_relative + piece_10_phi,
        w_4: piece_4_omega,
        phi_5: piece_5_phi_relative + piece_10_phi,
        w_5: piece_5_omega,
        phi_6: piece_6_phi_relative + piece_10_phi,
        w_6: piece_6_omega,
        phi_7: piece_7_phi_relative + piece_10_phi,
        w_7: piece_7_omega,
        phi_8: piece_8_phi_relative + piece_10_phi,
        w_8: piece_8_omega,
        phi_9: piece_9_phi_relative + piece_10_phi,
        w_9: piece_9_omega,
        phi_10: piece_10_phi,
        w_10: piece_10_omega,
    }
}

/// T, V and the energy of first-order states \[J\]. 90 operations.
#[must_use]
pub fn energy<R: Real>(_time: R, state: &[R; STATES], _p: &Parameters<R>) -> Energy<R> {
    let [motor_phi_relative, piece_1_phi_relative, piece_2_phi_relative, piece_3_phi_relative,
        piece_4_phi_relative, piece_5_phi_relative, piece_6_phi_relative, piece_7_phi_relative,
        piece_8_phi_relative, piece_9_phi_relative, motor_omega, piece_1_omega, piece_2_omega,
        piece_3_omega, piece_4_omega, piece_5_omega, piece_6_omega, piece_7_omega, piece_8_omega,
        piece_9_omega, piece_10_omega, motor_psi_sx, motor_psi_sy, motor_psi_rx, motor_psi_ry, ..]
        = *state;
    let coupling_twist = motor_phi_relative - piece_1_phi_relative;
    let motor_i_sx = R::literal(844.204_793_982_429_1) * motor_psi_sx
        .sub_product(R::literal(0.952), motor_psi_rx);
    let motor_i_sy = R::literal(844.204_793_982_429_1) * motor_psi_sy
        .sub_product(R::literal(0.952), motor_psi_ry);
    let motor_i_rx = R::literal(840.672_556_350_703_5) * motor_psi_rx
        .sub_product(R::literal(0.956), motor_psi_sx);
    let motor_i_ry = R::literal(840.672_556_350_703_5) * motor_psi_ry
        .sub_product(R::literal(0.956), motor_psi_sy);
    let t0 = piece_1_phi_relative - piece_2_phi_relative;
    let t1 = piece_2_phi_relative - piece_3_phi_relative;
    let t2 = piece_3_phi_relative - piece_4_phi_relative;
    let t3 = piece_4_phi_relative - piece_5_phi_relative;
    let t4 = piece_5_phi_relative - piece_6_phi_relative;
    let t5 = piece_6_phi_relative - piece_7_phi_relative;
    let t6 = piece_7_phi_relative - piece_8_phi_relative;
    let t7 = piece_8_phi_relative - piece_9_phi_relative;
    Energy {
        kinetic: (R::literal(0.0622) * (piece_1_omega * piece_1_omega))
            .add_product(R::literal(0.0622), piece_2_omega * piece_2_omega)
            .add_product(R::literal(0.0622), piece_3_omega * piece_3_omega)
            .add_product(R::literal(0.0622), piece_4_omega * piece_4_omega)
            .add_product(R::literal(0.0622), piece_5_omega * piece_5_omega)
            .add_product(R::literal(0.0622), piece_6_omega * piece_6_omega)
            .add_product(R::literal(0.0622), piece_7_omega * piece_7_omega)
            .add_product(R::literal(0.0622), piece_8_omega * piece_8_omega)
            .add_product(R::literal(0.0622), piece_9_omega * piece_9_omega)
            .add_product(R::literal(0.0622), piece_10_omega * piece_10_omega)
            .add_product(R::literal(2.1), motor_omega * motor_omega),
        potential: (R::literal(1_691_128.337_639_965_6) * (piece_9_phi_relative
            * piece_9_phi_relative)).add_product(R::literal(11532.6), coupling_twist
            * coupling_twist).add_product(R::literal(1_691_128.337_639_965_6), t0 * t0)
            .add_product(R::literal(1_691_128.337_639_965_6), t1 * t1)
            .add_product(R::literal(1_691_128.337_639_965_6), t2 * t2)
            .add_product(R::literal(1_691_128.337_639_965_6), t3 * t3)
            .add_product(R::literal(1_691_128.337_639_965_6), t4 * t4)
            .add_product(R::literal(1_691_128.337_639_965_6), t5 * t5)
            .add_product(R::literal(1_691_128.337_639_965_6), t6 * t6)
            .add_product(R::literal(1_691_128.337_639_965_6), t7 * t7),
        stored: R::literal(0.75) * (motor_psi_sx * motor_i_sx).add_product(motor_psi_sy, motor_i_sy)
            .add_product(motor_psi_rx, motor_i_rx).add_product(motor_psi_ry, motor_i_ry),
    }
}

/// `dE/dt`, power supplied and power dissipated \[W\]. 307 operations.
#[must_use]
pub fn power_balance<R: Real>(time: R, state: &[R; STATES], _p: &Parameters<R>) -> PowerBalance<R> {
    let [motor_phi_relative, piece_1_phi_relative, piece_2_phi_relative, piece_3_phi_relative,
        piece_4_phi_relative, piece_5_phi_relative, piece_6_phi_relative, piece_7_phi_relative,
        piece_8_phi_relative, piece_9_phi_relative, motor_omega, piece_1_omega, piece_2_omega,
        piece_3_omega, piece_4_omega, piece_5_omega, piece_6_omega, piece_7_omega, piece_8_omega,
        piece_9_omega, piece_10_omega, motor_psi_sx, motor_psi_sy, motor_psi_rx, motor_psi_ry, ..]
        = *state;
    let [t0, t1, t2, t3, t4, t5, t6, t7, t8, t9] = R::tanh_each([R::literal(2.0) * piece_1_omega,
        R::literal(2.0) * piece_2_omega, R::literal(2.0) * piece_3_omega,
        R::literal(2.0) * piece_4_omega, R::literal(2.0) * piece_5_omega,
        R::literal(2.0) * piece_6_omega, R::literal(2.0) * piece_7_omega,
        R::literal(2.0) * piece_8_omega, R::literal(2.0) * piece_9_omega,
        R::literal(2.0) * piece_10_omega]);
    let coupling_twist = motor_phi_relative - piece_1_phi_relative;
    let coupling_twist_rate = motor_omega - piece_1_omega;
    let motor_slip_speed = R::literal(314.159_265_358_979_3).sub_product(R::literal(4.0),
        motor_omega);
    let motor_i_sx = R::literal(844.204_793_982_429_1) * motor_psi_sx
        .sub_product(R::literal(0.952), motor_psi_rx);
    let motor_i_sy = R::literal(844.204_793_982_429_1) * motor_psi_sy
        .sub_product(R::literal(0.952), motor_psi_ry);
    let t10 = R::literal(0.956) * motor_psi_sx;
    let motor_i_rx = R::literal(840.672_556_350_703_5) * (motor_psi_rx - t10);
    let t11 = R::literal(0.956) * motor_psi_sy;
    let motor_i_ry = R::literal(840.672_556_350_703_5) * (motor_psi_ry - t11);
    let load_1_engagement = R::literal(1.0) / (R::literal(1.0) + (R::literal(-50.0)
        * (time - R::literal(0.15))).exp());
    let motor_torque = R::literal(4_822.097_783_227_635) * (motor_psi_sy * motor_psi_rx)
        .sub_product(motor_psi_sx, motor_psi_ry);
    let t12 = R::literal(128.5346) * coupling_twist_rate;
    let t13 = R::literal(23065.2) * coupling_twist;
    let coupling_torque = t12 + t13;
    let t14 = load_1_engagement * R::literal(84.372).add_product(R::literal(7.878),
        (R::literal(241.805_307_826_689_27) * time).sin());
    let load_1_resistance = t14 * t0;
    let load_2_resistance = t14 * t1;
    let load_3_resistance = t14 * t2;
    let load_4_resistance = t14 * t3;
    let load_5_resistance = t14 * t4;
    let load_6_resistance = t14 * t5;
    let load_7_resistance = t14 * t6;
    let load_8_resistance = t14 * t7;
    let load_9_resistance = t14 * t8;
    let load_10_resistance = t14 * t9;
    let t15 = R::literal(3_382_256.675_279_931) * (piece_1_phi_relative - piece_2_phi_relative);
    let t16 = t15 - t13;
    let t17 = R::literal(67.645_133_505_598_62) * (piece_1_omega - piece_2_omega);
    let t18 = t17 - t12;
    let t19 = R::literal(3_382_256.675_279_931) * (piece_2_phi_relative - piece_3_phi_relative);
    let t20 = t19 - t15;
    let t21 = R::literal(67.645_133_505_598_62) * (piece_2_omega - piece_3_omega);
    let t22 = t21 - t17;
    let t23 = R::literal(3_382_256.675_279_931) * (piece_3_phi_relative - piece_4_phi_relative);
    let t24 = t23 - t19;
    let t25 = R::literal(67.645_133_505_598_62) * (piece_3_omega - piece_4_omega);
    let t26 = t25 - t21;
    let t27 = R::literal(3_382_256.675_279_931) * (piece_4_phi_relative - piece_5_phi_relative);
    let t28 = t27 - t23;
    let t29 = R::literal(67.645_133_505_598_62) * (piece_4_omega - piece_5_omega);
    let t30 = t29 - t25;
    let t31 = R::literal(3_382_256.675_279_931) * (piece_5_phi_relative - piece_6_phi_relative);
    let t32 = t31 - t27;
    let t33 = R::literal(67.645_133_505_598_62) * (piece_5_omega - piece_6_omega);
    let t34 = t33 - t29;
    let t35 = R::literal(3_382_256.675_279_931) * (piece_6_phi_relative - piece_7_phi_relative);
    let t36 = t35 - t31;
    let t37 = R::literal(67.645_133_505_598_62) * (piece_6_omega - piece_7_omega);
    let t38 = t37 - t33;
    let t39 = R::literal(3_382_256.675_279_931) * (piece_7_phi_relative - piece_8_phi_relative);
    let t40 = t39 - t35;
    let t41 = R::literal(67.645_133_505_598_62) * (piece_7_omega - piece_8_omega);
    let t42 = t41 - t37;
    let t43 = R::literal(3_382_256.675_279_931) * (piece_8_phi_relative - piece_9_phi_relative);
    let t44 = t43 - t39;
    let t45 = R::literal(67.645_133_505_598_62) * (piece_8_omega - piece_9_omega);
    let t46 = t45 - t41;
    let t47 = R::literal(3_382_256.675_279_931) * piece_9_phi_relative;
    let t48 = t47 - t43;
    let piece_9_omega_minus_piece_10_omega = piece_9_omega - piece_10_omega;
    let t49 = R::literal(67.645_133_505_598_62) * piece_9_omega_minus_piece_10_omega;
    let t50 = t49 - t45;
    let piece_10_omega_dot = (t49 + t47 - load_10_resistance) * R::literal(8.038_585_209_003_216);
    let motor_omega_dot = (motor_torque - coupling_torque) * R::literal(0.238_095_238_095_238_08);
    let motor_psi_sx_dot = R::literal(311.126_983_722_080_9)
        .add_product(R::literal(314.159_265_358_979_3), motor_psi_sy)
        .sub_product(R::literal(0.042_795_676_8), motor_i_sx);
    let motor_psi_rx_dot = (R::literal(26.954_864_967_800_425) * (t10 - motor_psi_rx))
        .add_product(motor_psi_ry, motor_slip_speed);
    let motor_psi_ry_dot = (R::literal(26.954_864_967_800_425) * (t11 - motor_psi_ry))
        .sub_product(motor_psi_rx, motor_slip_speed);
    let t51 = (t13 * (motor_omega - piece_10_omega)).add_product(t16, piece_1_omega
        - piece_10_omega).add_product(t20, piece_2_omega - piece_10_omega).add_product(t24,
        piece_3_omega - piece_10_omega).add_product(t28, piece_4_omega - piece_10_omega)
        .add_product(t32, piece_5_omega - piece_10_omega).add_product(t36, piece_6_omega
        - piece_10_omega).add_product(t40, piece_7_omega - piece_10_omega).add_product(t44,
        piece_8_omega - piece_10_omega).add_product(t48, piece_9_omega_minus_piece_10_omega)
        .add_product(R::literal(4.2) * motor_omega, motor_omega_dot);
    let t52 = t51.sub_product(R::literal(0.1244) * piece_1_omega, (load_1_resistance + t16 + t18)
        * R::literal(8.038_585_209_003_216)).sub_product(R::literal(0.1244) * piece_2_omega,
        (load_2_resistance + t20 + t22) * R::literal(8.038_585_209_003_216))
        .sub_product(R::literal(0.1244) * piece_3_omega, (load_3_resistance + t24 + t26)
        * R::literal(8.038_585_209_003_216)).sub_product(R::literal(0.1244) * piece_4_omega,
        (load_4_resistance + t28 + t30) * R::literal(8.038_585_209_003_216));
    let t53 = t52.sub_product(R::literal(0.1244) * piece_5_omega, (load_5_resistance + t32 + t34)
        * R::literal(8.038_585_209_003_216)).sub_product(R::literal(0.1244) * piece_6_omega,
        (load_6_resistance + t36 + t38) * R::literal(8.038_585_209_003_216))
        .sub_product(R::literal(0.1244) * piece_7_omega, (load_7_resistance + t40 + t42)
        * R::literal(8.038_585_209_003_216)).sub_product(R::literal(0.1244) * piece_8_omega,
        (load_8_resistance + t44 + t46) * R::literal(8.038_585_209_003_216));
    let t54 = t53.sub_product(R::literal(0.1244) * piece_9_omega, (load_9_resistance + t48 + t50)
        * R::literal(8.038_585_209_003_216)).add_product(R::literal(0.1244) * piece_10_omega,
        piece_10_omega_dot).add_product(R::literal(0.75) * motor_i_sx
        .add_product(R::literal(844.204_793_982_429_1), motor_psi_sx)
        .sub_product(R::literal(803.682_963_871_272_6), motor_psi_rx), motor_psi_sx_dot)
        .sub_product(R::literal(0.75) * motor_i_sy.add_product(R::literal(844.204_793_982_429_1),
        motor_psi_sy).sub_product(R::literal(803.682_963_871_272_6), motor_psi_ry),
        (R::literal(314.159_265_358_979_3) * motor_psi_sx).add_product(R::literal(0.042_795_676_8),
        motor_i_sy)).add_product(R::literal(0.75) * motor_i_rx
        .add_product(R::literal(840.672_556_350_703_5), motor_psi_rx)
        .sub_product(R::literal(803.682_963_871_272_6), motor_psi_sx), motor_psi_rx_dot);
    PowerBalance {
        stored_rate: t54.add_product(R::literal(0.75) * motor_i_ry
            .add_product(R::literal(840.672_556_350_703_5), motor_psi_ry)
            .sub_product(R::literal(803.682_963_871_272_6), motor_psi_sy), motor_psi_ry_dot),
        supplied: (R::literal(466.690_475_583_121_4) * motor_i_sx).sub_product(piece_1_omega,
            load_1_resistance).sub_product(piece_2_omega, load_2_resistance)
            .sub_product(piece_3_omega, load_3_resistance).sub_product(piece_4_omega,
            load_4_resistance).sub_product(piece_5_omega, load_5_resistance)
            .sub_product(piece_6_omega, load_6_resistance).sub_product(piece_7_omega,
            load_7_resistance).sub_product(piece_8_omega, load_8_resistance)
            .sub_product(piece_9_omega, load_9_resistance).sub_product(piece_10_omega,
            load_10_resistance),
        dissipated: (R::literal(128.5346) * motor_omega * coupling_twist_rate)
            .add_product(R::literal(1.5), (R::literal(0.032_063_452_962_957_98) * (motor_i_rx
            * motor_i_rx).add_product(motor_i_ry, motor_i_ry))
            .add_product(R::literal(0.042_795_676_8), (motor_i_sx * motor_i_sx)
            .add_product(motor_i_sy, motor_i_sy))).add_product(piece_1_omega, t18)
            .add_product(piece_2_omega, t22).add_product(piece_3_omega, t26)
            .add_product(piece_4_omega, t30).add_product(piece_5_omega, t34)
            .add_product(piece_6_omega, t38).add_product(piece_7_omega, t42)
            .add_product(piece_8_omega, t46).add_product(piece_9_omega, t50)
            .sub_product(R::literal(67.645_133_505_598_62) * piece_10_omega,
            piece_9_omega_minus_piece_10_omega),
    }
}

/// Arguments of functions that are flat far from a place, such as `tanh` far from zero. Steps by
/// series are checked where one passes zero or turns. 10 operations.
#[must_use]
pub fn saturating_arguments<R: Real>(_time: R, state: &[R; STATES],
        _p: &Parameters<R>) -> [R; SATURATIONS] {
    let [_, _, _, _, _, _, _, _, _, _, _, piece_1_omega, piece_2_omega, piece_3_omega,
        piece_4_omega, piece_5_omega, piece_6_omega, piece_7_omega, piece_8_omega, piece_9_omega,
        piece_10_omega, ..] = *state;
    let argument_1 = R::literal(2.0) * piece_1_omega;
    let argument_2 = R::literal(2.0) * piece_2_omega;
    let argument_3 = R::literal(2.0) * piece_3_omega;
    let argument_4 = R::literal(2.0) * piece_4_omega;
    let argument_5 = R::literal(2.0) * piece_5_omega;
    let argument_6 = R::literal(2.0) * piece_6_omega;
    let argument_7 = R::literal(2.0) * piece_7_omega;
    let argument_8 = R::literal(2.0) * piece_8_omega;
    let argument_9 = R::literal(2.0) * piece_9_omega;
    let argument_10 = R::literal(2.0) * piece_10_omega;
    [argument_1, argument_2, argument_3, argument_4, argument_5, argument_6, argument_7,
        argument_8, argument_9, argument_10]
}

/// Normalized Taylor coefficients of the solution through `state`, order after order.
///
/// `_k` marks the coefficient of order k, `_before` that of order k - 1; bare names are
/// zeroth coefficients. The workspace is as `series_workspace` says.
///
/// 235 recurrences. 36 sums of products an order.
///
/// # Panics
/// If there is no room for the zeroth coefficients, or the workspace is too short.
pub fn series<R: Real>(time: R, state: &[R; STATES], _p: &Parameters<R>,
        coefficients: &mut [[R; STATES]], workspace: &mut [R]) {
    let (mut lanes, workspace) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let (mut lanes_1, workspace) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let (mut lanes_2, workspace) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let (mut lanes_3, workspace) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let (mut lanes_4, workspace) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let (mut lanes_5, workspace) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let (mut lanes_6, workspace) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let (mut lanes_7, workspace) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let (mut lanes_8, _) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let [motor_phi_relative, piece_1_phi_relative, piece_2_phi_relative, piece_3_phi_relative,
        piece_4_phi_relative, piece_5_phi_relative, piece_6_phi_relative, piece_7_phi_relative,
        piece_8_phi_relative, piece_9_phi_relative, motor_omega, piece_1_omega, piece_2_omega,
        piece_3_omega, piece_4_omega, piece_5_omega, piece_6_omega, piece_7_omega, piece_8_omega,
        piece_9_omega, piece_10_omega, motor_psi_sx, motor_psi_sy, motor_psi_rx, motor_psi_ry, ..]
        = *state;
    let coupling_twist = motor_phi_relative - piece_1_phi_relative;
    let coupling_twist_rate = motor_omega - piece_1_omega;
    let t0 = motor_omega * R::literal(4.0);
    let motor_slip_speed = R::literal(314.159_265_358_979_3) - t0;
    let t1 = motor_psi_rx * R::literal(0.952);
    let t2 = motor_psi_sx - t1;
    let t3 = motor_psi_ry * R::literal(0.952);
    let t4 = motor_psi_sy - t3;
    let t5 = motor_psi_sx * R::literal(0.956);
    let t6 = motor_psi_sy * R::literal(0.956);
    let t7 = time - R::literal(0.15);
    let t8 = t7 * R::literal(-50.0);
    let t9 = t8.exp();
    let t10 = R::literal(1.0) + t9;
    let load_1_engagement = R::literal(1.0) / t10;
    let t11 = motor_psi_sx * motor_psi_ry;
    let t12 = motor_psi_sy * motor_psi_rx;
    let t13 = t12 - t11;
    let motor_torque = t13 * R::literal(4_822.097_783_227_635);
    let t14 = coupling_twist_rate * R::literal(128.5346);
    let t15 = coupling_twist * R::literal(23065.2);
    let coupling_torque = t14 + t15;
    let t16 = time * R::literal(241.805_307_826_689_27);
    let t17 = t16.sin();
    let t18 = t16.cos();
    let t19 = t17 * R::literal(7.878);
    let t20 = R::literal(84.372) + t19;
    let t21 = piece_1_omega * R::literal(2.0);
    let t22 = t21.tanh();
    let t23 = t22 * t22;
    let t24 = R::literal(1.0) - t23;
    let t25 = load_1_engagement * t20;
    let load_1_resistance = t25 * t22;
    let t26 = piece_2_omega * R::literal(2.0);
    let t27 = t26.tanh();
    let t28 = t27 * t27;
    let t29 = R::literal(1.0) - t28;
    let load_2_resistance = t25 * t27;
    let t30 = piece_3_omega * R::literal(2.0);
    let t31 = t30.tanh();
    let t32 = t31 * t31;
    let t33 = R::literal(1.0) - t32;
    let load_3_resistance = t25 * t31;
    let t34 = piece_4_omega * R::literal(2.0);
    let t35 = t34.tanh();
    let t36 = t35 * t35;
    let t37 = R::literal(1.0) - t36;
    let load_4_resistance = t25 * t35;
    let t38 = piece_5_omega * R::literal(2.0);
    let t39 = t38.tanh();
    let t40 = t39 * t39;
    let t41 = R::literal(1.0) - t40;
    let load_5_resistance = t25 * t39;
    let t42 = piece_6_omega * R::literal(2.0);
    let t43 = t42.tanh();
    let t44 = t43 * t43;
    let t45 = R::literal(1.0) - t44;
    let load_6_resistance = t25 * t43;
    let t46 = piece_7_omega * R::literal(2.0);
    let t47 = t46.tanh();
    let t48 = t47 * t47;
    let t49 = R::literal(1.0) - t48;
    let load_7_resistance = t25 * t47;
    let t50 = piece_8_omega * R::literal(2.0);
    let t51 = t50.tanh();
    let t52 = t51 * t51;
    let t53 = R::literal(1.0) - t52;
    let load_8_resistance = t25 * t51;
    let t54 = piece_9_omega * R::literal(2.0);
    let t55 = t54.tanh();
    let t56 = t55 * t55;
    let t57 = R::literal(1.0) - t56;
    let load_9_resistance = t25 * t55;
    let t58 = piece_10_omega * R::literal(2.0);
    let t59 = t58.tanh();
    let t60 = t59 * t59;
    let t61 = R::literal(1.0) - t60;
    let load_10_resistance = t25 * t59;
    let t62 = motor_torque - coupling_torque;
    let t63 = piece_1_phi_relative - piece_2_phi_relative;
    let t64 = t63 * R::literal(3_382_256.675_279_931);
    let t65 = piece_1_omega - piece_2_omega;
    let t66 = t65 * R::literal(67.645_133_505_598_62);
    let t67 = t66 - t14;
    let t68 = piece_2_phi_relative - piece_3_phi_relative;
    let t69 = t68 * R::literal(3_382_256.675_279_931);
    let t70 = piece_2_omega - piece_3_omega;
    let t71 = t70 * R::literal(67.645_133_505_598_62);
    let t72 = t71 - t66;
    let t73 = piece_3_phi_relative - piece_4_phi_relative;
    let t74 = t73 * R::literal(3_382_256.675_279_931);
    let t75 = piece_3_omega - piece_4_omega;
    let t76 = t75 * R::literal(67.645_133_505_598_62);
    let t77 = t76 - t71;
    let t78 = piece_4_phi_relative - piece_5_phi_relative;
    let t79 = t78 * R::literal(3_382_256.675_279_931);
    let t80 = piece_4_omega - piece_5_omega;
    let t81 = t80 * R::literal(67.645_133_505_598_62);
    let t82 = t81 - t76;
    let t83 = piece_5_phi_relative - piece_6_phi_relative;
    let t84 = t83 * R::literal(3_382_256.675_279_931);
    let t85 = piece_5_omega - piece_6_omega;
    let t86 = t85 * R::literal(67.645_133_505_598_62);
    let t87 = t86 - t81;
    let t88 = piece_6_phi_relative - piece_7_phi_relative;
    let t89 = t88 * R::literal(3_382_256.675_279_931);
    let t90 = piece_6_omega - piece_7_omega;
    let t91 = t90 * R::literal(67.645_133_505_598_62);
    let t92 = t91 - t86;
    let t93 = piece_7_phi_relative - piece_8_phi_relative;
    let t94 = t93 * R::literal(3_382_256.675_279_931);
    let t95 = piece_7_omega - piece_8_omega;
    let t96 = t95 * R::literal(67.645_133_505_598_62);
    let t97 = t96 - t91;
    let t98 = piece_8_phi_relative - piece_9_phi_relative;
    let t99 = t98 * R::literal(3_382_256.675_279_931);
    let t100 = piece_8_omega - piece_9_omega;
    let t101 = t100 * R::literal(67.645_133_505_598_62);
    let t102 = t101 - t96;
    let t103 = piece_9_phi_relative * R::literal(3_382_256.675_279_931);
    let t104 = piece_9_omega - piece_10_omega;
    let t105 = t104 * R::literal(67.645_133_505_598_62);
    let t106 = t105 - t101;
    let t107 = t105 + t103;
    let t108 = t107 - load_10_resistance;
    let piece_10_omega_dot = t108 * R::literal(8.038_585_209_003_216);
    let t109 = t99 - t103;
    let t110 = t109 - load_9_resistance;
    let t111 = t110 - t106;
    let piece_9_omega_dot = t111 * R::literal(8.038_585_209_003_216);
    let t112 = t94 - t99;
    let t113 = t112 - load_8_resistance;
    let t114 = t113 - t102;
    let piece_8_omega_dot = t114 * R::literal(8.038_585_209_003_216);
    let t115 = t89 - t94;
    let t116 = t115 - load_7_resistance;
    let t117 = t116 - t97;
    let piece_7_omega_dot = t117 * R::literal(8.038_585_209_003_216);
    let t118 = t84 - t89;
    let t119 = t118 - load_6_resistance;
    let t120 = t119 - t92;
    let piece_6_omega_dot = t120 * R::literal(8.038_585_209_003_216);
    let t121 = t79 - t84;
    let t122 = t121 - load_5_resistance;
    let t123 = t122 - t87;
    let piece_5_omega_dot = t123 * R::literal(8.038_585_209_003_216);
    let t124 = t74 - t79;
    let t125 = t124 - load_4_resistance;
    let t126 = t125 - t82;
    let piece_4_omega_dot = t126 * R::literal(8.038_585_209_003_216);
    let t127 = t69 - t74;
    let t128 = t127 - load_3_resistance;
    let t129 = t128 - t77;
    let piece_3_omega_dot = t129 * R::literal(8.038_585_209_003_216);
    let t130 = t64 - t69;
    let t131 = t130 - load_2_resistance;
    let t132 = t131 - t72;
    let piece_2_omega_dot = t132 * R::literal(8.038_585_209_003_216);
    let t133 = t15 - t64;
    let t134 = t133 - load_1_resistance;
    let t135 = t134 - t67;
    let piece_1_omega_dot = t135 * R::literal(8.038_585_209_003_216);
    let motor_omega_dot = t62 * R::literal(0.238_095_238_095_238_08);
    let t136 = t2 * R::literal(36.128_315_516_282_626);
    let t137 = motor_psi_sy * R::literal(314.159_265_358_979_3);
    let t138 = R::literal(311.126_983_722_080_9) + t137;
    let motor_psi_sx_dot = t138 - t136;
    let t139 = t4 * R::literal(36.128_315_516_282_626);
    let t140 = motor_psi_sx * R::literal(-314.159_265_358_979_3);
    let motor_psi_sy_dot = t140 - t139;
    let t141 = t5 - motor_psi_rx;
    let t142 = t141 * R::literal(26.954_864_967_800_425);
    let t143 = motor_psi_ry * motor_slip_speed;
    let motor_psi_rx_dot = t142 + t143;
    let t144 = motor_psi_rx * motor_slip_speed;
    let t145 = t6 - motor_psi_ry;
    let t146 = t145 * R::literal(26.954_864_967_800_425);
    let motor_psi_ry_dot = t146 - t144;
    let t147 = motor_omega - piece_10_omega;
    let t148 = piece_1_omega - piece_10_omega;
    let t149 = piece_2_omega - piece_10_omega;
    let t150 = piece_3_omega - piece_10_omega;
    let t151 = piece_4_omega - piece_10_omega;
    let t152 = piece_5_omega - piece_10_omega;
    let t153 = piece_6_omega - piece_10_omega;
    let t154 = piece_7_omega - piece_10_omega;
    let t155 = piece_8_omega - piece_10_omega;
    let t8_slope = R::literal(1.0) * R::literal(-50.0);
    let inverse_t10 = R::literal(1.0) / t10;
    let mut t9_before = t9;
    let mut t17_before = t17;
    let mut t18_before = t18;
    let mut rates = [t147, t148, t149, t150, t151, t152, t153, t154, t155, t104, motor_omega_dot,
        piece_1_omega_dot, piece_2_omega_dot, piece_3_omega_dot, piece_4_omega_dot,
        piece_5_omega_dot, piece_6_omega_dot, piece_7_omega_dot, piece_8_omega_dot,
        piece_9_omega_dot, piece_10_omega_dot, motor_psi_sx_dot, motor_psi_sy_dot,
        motor_psi_rx_dot, motor_psi_ry_dot, piece_10_omega];
    coefficients[0] = *state;
    let highest = coefficients.len() - 1;
    for (order, state_k) in coefficients.iter_mut().enumerate().skip(1) {
        let (k, inverse) = order_and_inverse::<R>(order);
        *state_k = rates.map(|rate| rate * inverse);
        if order == highest {
            break;
        }
        let [motor_phi_relative_k, piece_1_phi_relative_k, piece_2_phi_relative_k,
            piece_3_phi_relative_k, piece_4_phi_relative_k, piece_5_phi_relative_k,
            piece_6_phi_relative_k, piece_7_phi_relative_k, piece_8_phi_relative_k,
            piece_9_phi_relative_k, motor_omega_k, piece_1_omega_k, piece_2_omega_k,
            piece_3_omega_k, piece_4_omega_k, piece_5_omega_k, piece_6_omega_k, piece_7_omega_k,
            piece_8_omega_k, piece_9_omega_k, piece_10_omega_k, motor_psi_sx_k, motor_psi_sy_k,
            motor_psi_rx_k, motor_psi_ry_k, ..] = *state_k;
        let sums = lanes.sums(order);
        let sums_1 = lanes_1.sums(order);
        let sums_2 = lanes_2.sums(order);
        let sums_3 = lanes_3.sums(order);
        let sums_4 = lanes_4.sums(order);
        let sums_5 = lanes_5.sums(order);
        let sums_6 = lanes_6.sums(order);
        let sums_7 = lanes_7.sums(order);
        let sums_8 = lanes_8.sums(order);
        let coupling_twist_k = motor_phi_relative_k - piece_1_phi_relative_k;
        let coupling_twist_rate_k = motor_omega_k - piece_1_omega_k;
        let motor_slip_speed_k = -motor_omega_k * R::literal(4.0);
        let t2_k = (-motor_psi_rx_k).mul_add(R::literal(0.952), motor_psi_sx_k);
        let t4_k = (-motor_psi_ry_k).mul_add(R::literal(0.952), motor_psi_sy_k);
        let t9_k = inverse * t8_slope * t9_before;
        let load_1_engagement_k = -t9_k.mul_add(load_1_engagement, sums_3[2]) * inverse_t10;
        let t11_k = motor_psi_sx.mul_add(motor_psi_ry_k, motor_psi_ry.mul_add(motor_psi_sx_k,
            sums[0]));
        let t12_k = motor_psi_sy.mul_add(motor_psi_rx_k, motor_psi_rx.mul_add(motor_psi_sy_k,
            sums[1]));
        let t13_k = t12_k - t11_k;
        let t14_k = coupling_twist_rate_k * R::literal(128.5346);
        let t15_k = coupling_twist_k * R::literal(23065.2);
        let coupling_torque_k = t14_k + t15_k;
        let t17_k = inverse * R::literal(241.805_307_826_689_27) * t18_before;
        let t18_k = -inverse * R::literal(241.805_307_826_689_27) * t17_before;
        let t21_k = piece_1_omega_k * R::literal(2.0);
        let t22_k = t21_k.mul_add(t24, inverse * sums_4[0]);
        let t23_k = (t22 + t22).mul_add(t22_k, sums[2]);
        let t24_k = -t23_k;
        let t25_k = load_1_engagement.mul_add(t17_k * R::literal(7.878), t20
            .mul_add(load_1_engagement_k, sums_3[3]));
        let load_1_resistance_k = t22.mul_add(t25_k, t25.mul_add(t22_k, sums_4[1]));
        let t26_k = piece_2_omega_k * R::literal(2.0);
        let t27_k = t26_k.mul_add(t29, inverse * sums_4[2]);
        let t28_k = (t27 + t27).mul_add(t27_k, sums[3]);
        let t29_k = -t28_k;
        let load_2_resistance_k = t27.mul_add(t25_k, t25.mul_add(t27_k, sums_4[3]));
        let t30_k = piece_3_omega_k * R::literal(2.0);
        let t31_k = t30_k.mul_add(t33, inverse * sums_5[0]);
        let t32_k = (t31 + t31).mul_add(t31_k, sums_1[0]);
        let t33_k = -t32_k;
        let load_3_resistance_k = t31.mul_add(t25_k, t25.mul_add(t31_k, sums_5[1]));
        let t34_k = piece_4_omega_k * R::literal(2.0);
        let t35_k = t34_k.mul_add(t37, inverse * sums_5[2]);
        let t36_k = (t35 + t35).mul_add(t35_k, sums_1[1]);
        let t37_k = -t36_k;
        let load_4_resistance_k = t35.mul_add(t25_k, t25.mul_add(t35_k, sums_5[3]));
        let t38_k = piece_5_omega_k * R::literal(2.0);
        let t39_k = t38_k.mul_add(t41, inverse * sums_6[0]);
        let t40_k = (t39 + t39).mul_add(t39_k, sums_1[2]);
        let t41_k = -t40_k;
        let load_5_resistance_k = t39.mul_add(t25_k, t25.mul_add(t39_k, sums_6[1]));
        let t42_k = piece_6_omega_k * R::literal(2.0);
        let t43_k = t42_k.mul_add(t45, inverse * sums_6[2]);
        let t44_k = (t43 + t43).mul_add(t43_k, sums_1[3]);
        let t45_k = -t44_k;
        let load_6_resistance_k = t43.mul_add(t25_k, t25.mul_add(t43_k, sums_6[3]));
        let t46_k = piece_7_omega_k * R::literal(2.0);
        let t47_k = t46_k.mul_add(t49, inverse * sums_7[0]);
        let t48_k = (t47 + t47).mul_add(t47_k, sums_2[0]);
        let t49_k = -t48_k;
        let load_7_resistance_k = t47.mul_add(t25_k, t25.mul_add(t47_k, sums_7[1]));
        let t50_k = piece_8_omega_k * R::literal(2.0);
        let t51_k = t50_k.mul_add(t53, inverse * sums_7[2]);
        let t52_k = (t51 + t51).mul_add(t51_k, sums_2[1]);
        let t53_k = -t52_k;
        let load_8_resistance_k = t51.mul_add(t25_k, t25.mul_add(t51_k, sums_7[3]));
        let t54_k = piece_9_omega_k * R::literal(2.0);
        let t55_k = t54_k.mul_add(t57, inverse * sums_8[0]);
        let t56_k = (t55 + t55).mul_add(t55_k, sums_2[2]);
        let t57_k = -t56_k;
        let load_9_resistance_k = t55.mul_add(t25_k, t25.mul_add(t55_k, sums_8[1]));
        let t58_k = piece_10_omega_k * R::literal(2.0);
        let t59_k = t58_k.mul_add(t61, inverse * sums_8[2]);
        let t60_k = (t59 + t59).mul_add(t59_k, sums_2[3]);
        let t61_k = -t60_k;
        let load_10_resistance_k = t59.mul_add(t25_k, t25.mul_add(t59_k, sums_8[3]));
        let t62_k = t13_k.mul_add(R::literal(4_822.097_783_227_635), -coupling_torque_k);
        let t63_k = piece_1_phi_relative_k - piece_2_phi_relative_k;
        let t64_k = t63_k * R::literal(3_382_256.675_279_931);
        let t65_k = piece_1_omega_k - piece_2_omega_k;
        let t66_k = t65_k * R::literal(67.645_133_505_598_62);
        let t67_k = t66_k - t14_k;
        let t68_k = piece_2_phi_relative_k - piece_3_phi_relative_k;
        let t69_k = t68_k * R::literal(3_382_256.675_279_931);
        let t70_k = piece_2_omega_k - piece_3_omega_k;
        let t71_k = t70_k * R::literal(67.645_133_505_598_62);
        let t72_k = t71_k - t66_k;
        let t73_k = piece_3_phi_relative_k - piece_4_phi_relative_k;
        let t74_k = t73_k * R::literal(3_382_256.675_279_931);
        let t75_k = piece_3_omega_k - piece_4_omega_k;
        let t76_k = t75_k * R::literal(67.645_133_505_598_62);
        let t77_k = t76_k - t71_k;
        let t78_k = piece_4_phi_relative_k - piece_5_phi_relative_k;
        let t79_k = t78_k * R::literal(3_382_256.675_279_931);
        let t80_k = piece_4_omega_k - piece_5_omega_k;
        let t81_k = t80_k * R::literal(67.645_133_505_598_62);
        let t82_k = t81_k - t76_k;
        let t83_k = piece_5_phi_relative_k - piece_6_phi_relative_k;
        let t84_k = t83_k * R::literal(3_382_256.675_279_931);
        let t85_k = piece_5_omega_k - piece_6_omega_k;
        let t86_k = t85_k * R::literal(67.645_133_505_598_62);
        let t87_k = t86_k - t81_k;
        let t88_k = piece_6_phi_relative_k - piece_7_phi_relative_k;
        let t89_k = t88_k * R::literal(3_382_256.675_279_931);
        let t90_k = piece_6_omega_k - piece_7_omega_k;
        let t91_k = t90_k * R::literal(67.645_133_505_598_62);
        let t92_k = t91_k - t86_k;
        let t93_k = piece_7_phi_relative_k - piece_8_phi_relative_k;
        let t94_k = t93_k * R::literal(3_382_256.675_279_931);
        let t95_k = piece_7_omega_k - piece_8_omega_k;
        let t96_k = t95_k * R::literal(67.645_133_505_598_62);
        let t97_k = t96_k - t91_k;
        let t98_k = piece_8_phi_relative_k - piece_9_phi_relative_k;
        let t99_k = t98_k * R::literal(3_382_256.675_279_931);
        let t100_k = piece_8_omega_k - piece_9_omega_k;
        let t101_k = t100_k * R::literal(67.645_133_505_598_62);
        let t102_k = t101_k - t96_k;
        let t103_k = piece_9_phi_relative_k * R::literal(3_382_256.675_279_931);
        let t104_k = piece_9_omega_k - piece_10_omega_k;
        let t105_k = t104_k * R::literal(67.645_133_505_598_62);
        let t106_k = t105_k - t101_k;
        let t107_k = t105_k + t103_k;
        let t108_k = t107_k - load_10_resistance_k;
        let piece_10_omega_dot_k = t108_k * R::literal(8.038_585_209_003_216);
        let t109_k = t99_k - t103_k;
        let t110_k = t109_k - load_9_resistance_k;
        let t111_k = t110_k - t106_k;
        let piece_9_omega_dot_k = t111_k * R::literal(8.038_585_209_003_216);
        let t112_k = t94_k - t99_k;
        let t113_k = t112_k - load_8_resistance_k;
        let t114_k = t113_k - t102_k;
        let piece_8_omega_dot_k = t114_k * R::literal(8.038_585_209_003_216);
        let t115_k = t89_k - t94_k;
        let t116_k = t115_k - load_7_resistance_k;
        let t117_k = t116_k - t97_k;
        let piece_7_omega_dot_k = t117_k * R::literal(8.038_585_209_003_216);
        let t118_k = t84_k - t89_k;
        let t119_k = t118_k - load_6_resistance_k;
        let t120_k = t119_k - t92_k;
        let piece_6_omega_dot_k = t120_k * R::literal(8.038_585_209_003_216);
        let t121_k = t79_k - t84_k;
        let t122_k = t121_k - load_5_resistance_k;
        let t123_k = t122_k - t87_k;
        let piece_5_omega_dot_k = t123_k * R::literal(8.038_585_209_003_216);
        let t124_k = t74_k - t79_k;
        let t125_k = t124_k - load_4_resistance_k;
        let t126_k = t125_k - t82_k;
        let piece_4_omega_dot_k = t126_k * R::literal(8.038_585_209_003_216);
        let t127_k = t69_k - t74_k;
        let t128_k = t127_k - load_3_resistance_k;
        let t129_k = t128_k - t77_k;
        let piece_3_omega_dot_k = t129_k * R::literal(8.038_585_209_003_216);
        let t130_k = t64_k - t69_k;
        let t131_k = t130_k - load_2_resistance_k;
        let t132_k = t131_k - t72_k;
        let piece_2_omega_dot_k = t132_k * R::literal(8.038_585_209_003_216);
        let t133_k = t15_k - t64_k;
        let t134_k = t133_k - load_1_resistance_k;
        let t135_k = t134_k - t67_k;
        let piece_1_omega_dot_k = t135_k * R::literal(8.038_585_209_003_216);
        let motor_omega_dot_k = t62_k * R::literal(0.238_095_238_095_238_08);
        let motor_psi_sx_dot_k = (-t2_k).mul_add(R::literal(36.128_315_516_282_626), motor_psi_sy_k
            * R::literal(314.159_265_358_979_3));
        let motor_psi_sy_dot_k = (-t4_k).mul_add(R::literal(36.128_315_516_282_626), motor_psi_sx_k
            * R::literal(-314.159_265_358_979_3));
        let t141_k = motor_psi_sx_k.mul_add(R::literal(0.956), -motor_psi_rx_k);
        let t143_k = motor_psi_ry.mul_add(motor_slip_speed_k, motor_slip_speed
            .mul_add(motor_psi_ry_k, sums_3[0]));
        let motor_psi_rx_dot_k = t141_k.mul_add(R::literal(26.954_864_967_800_425), t143_k);
        let t144_k = motor_psi_rx.mul_add(motor_slip_speed_k, motor_slip_speed
            .mul_add(motor_psi_rx_k, sums_3[1]));
        let t145_k = motor_psi_sy_k.mul_add(R::literal(0.956), -motor_psi_ry_k);
        let motor_psi_ry_dot_k = t145_k.mul_add(R::literal(26.954_864_967_800_425), -t144_k);
        let t147_k = motor_omega_k - piece_10_omega_k;
        let t148_k = piece_1_omega_k - piece_10_omega_k;
        let t149_k = piece_2_omega_k - piece_10_omega_k;
        let t150_k = piece_3_omega_k - piece_10_omega_k;
        let t151_k = piece_4_omega_k - piece_10_omega_k;
        let t152_k = piece_5_omega_k - piece_10_omega_k;
        let t153_k = piece_6_omega_k - piece_10_omega_k;
        let t154_k = piece_7_omega_k - piece_10_omega_k;
        let t155_k = piece_8_omega_k - piece_10_omega_k;
        lanes.set(order, [motor_psi_sx_k, motor_psi_rx_k, t22_k, t27_k], [motor_psi_ry_k,
            motor_psi_sy_k, t22_k, t27_k]);
        lanes_1.set(order, [t31_k, t35_k, t39_k, t43_k], [t31_k, t35_k, t39_k, t43_k]);
        lanes_2.set(order, [t47_k, t51_k, t55_k, t59_k], [t47_k, t51_k, t55_k, t59_k]);
        lanes_3.set(order, [motor_slip_speed_k, motor_slip_speed_k, t9_k, load_1_engagement_k],
            [motor_psi_ry_k, motor_psi_rx_k, load_1_engagement_k, t17_k * R::literal(7.878)]);
        lanes_4.set(order, [k * t21_k, t22_k, k * t26_k, t25_k], [t24_k, t25_k, t29_k, t27_k]);
        lanes_5.set(order, [k * t30_k, t25_k, k * t34_k, t25_k], [t33_k, t31_k, t37_k, t35_k]);
        lanes_6.set(order, [k * t38_k, t25_k, k * t42_k, t25_k], [t41_k, t39_k, t45_k, t43_k]);
        lanes_7.set(order, [k * t46_k, t25_k, k * t50_k, t25_k], [t49_k, t47_k, t53_k, t51_k]);
        lanes_8.set(order, [k * t54_k, t25_k, k * t58_k, t25_k], [t57_k, t55_k, t61_k, t59_k]);
        t9_before = t9_k;
        t17_before = t17_k;
        t18_before = t18_k;
        rates = [t147_k, t148_k, t149_k, t150_k, t151_k, t152_k, t153_k, t154_k, t155_k, t104_k,
            motor_omega_dot_k, piece_1_omega_dot_k, piece_2_omega_dot_k, piece_3_omega_dot_k,
            piece_4_omega_dot_k, piece_5_omega_dot_k, piece_6_omega_dot_k, piece_7_omega_dot_k,
            piece_8_omega_dot_k, piece_9_omega_dot_k, piece_10_omega_dot_k, motor_psi_sx_dot_k,
            motor_psi_sy_dot_k, motor_psi_rx_dot_k, motor_psi_ry_dot_k, piece_10_omega_k];
    }
}

// Emitted by Machinist 0.1.0; do not edit. To make it again:
//
//     cargo run --release -- gen
//
// Sources, with SHA-256:
//   ead077ce80811540b3fd28cdc35e52dcbb6093b7d315e301114f21a448bba845  scenes/motor_run_up.toml
//   03bebde2dcd618fcbd0662a0f5e63f806e09d154c0fc25f1f0527c30944dd55e  units/textile/induction_motor.toml
//
// No-load run-up of an induction motor
//
// The motor alone, from rest to synchronous speed.
//
// Source:
//   Saw-gin study (2020), equations (2).
//
// All quantities are in SI units.
// Shapes: coordinates 1, first-order states 4, states 5, parameters 11, outputs 4.
// Nonzeros: mass_matrix 1 of 1 by 1, rate_jacobian 18 of 5 by 5, parameter_jacobian 24 of 5 by 11.
// Operations: rate 45, forcing 12, rate_jacobian 34, parameter_jacobian 84, outputs 27, energy 32,
//     power_balance 106, prepare 39, prepared_rate 29, prepared_rate_jacobian 16,
//     prepared_jacobians 68.

use ::machinist_contract::{
    Energy, PowerBalance, Real, taylor::{Lanes, order_and_inverse},
};

::machinist_contract::simulator! {
    /// No-load run-up of an induction motor
    ///
    /// The motor alone, from rest to synchronous speed.
    ///
    /// Source: Saw-gin study (2020), equations (2).
    MotorRunUp: "motor_run_up", "No-load run-up of an induction motor";
    run from 0.0, until 2.0, points 2001, rtol 1e-8, method "tsit5";
    quadratures 0, discontinuities 0;
    coordinates; prepared; jacobians_at_once; series 4;
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
    motor_alpha_s: 0.115, "1", "motor.alpha_s", "stator decay factor r_s/(sigma x_s)";
    motor_alpha_r: 0.0858, "1", "motor.alpha_r", "rotor decay factor r_r/(sigma x_r)";
}

::machinist_contract::outputs! {
    speed: "rad/s", "speed", "rotor speed";
    torque: "N m", "torque", "electromagnetic torque";
    slip: "1", "slip", "slip";
    stator_current: "A", "stator_current", "amplitude of the stator current";
}

::machinist_contract::states! {
    MOTOR_OMEGA: velocity, 78.5, "rad/s", "motor.omega", "rate of rotor angle";
    MOTOR_PSI_SX: first_order, 1.0, "V s", "motor.psi_sx", "stator flux linkage along x";
    MOTOR_PSI_SY: first_order, 1.0, "V s", "motor.psi_sy", "stator flux linkage along y";
    MOTOR_PSI_RX: first_order, 1.0, "V s", "motor.psi_rx", "rotor flux linkage along x";
    MOTOR_PSI_RY: first_order, 1.0, "V s", "motor.psi_ry", "rotor flux linkage along y";
}

::machinist_contract::coordinates! {
    "motor.phi", "rad", "rotor angle";
}

::machinist_contract::patterns! {
    /// Nonzeros of M.
    MASS_MATRIX_PATTERN: 1 by 1 { 0 [0] }
    /// Nonzeros of dy'/dy.
    RATE_JACOBIAN_PATTERN: 5 by 5 { 0 [1 2 3 4] 1 [1 2 3] 2 [1 2 4] 3 [0 1 3 4] 4 [0 2 3 4] }
    /// Nonzeros of dy'/dp.
    PARAMETER_JACOBIAN_PATTERN: 5 by 11 { 0 [1 3 5 6 7 8] 1 [2 3 4 7 9] 2 [2 3 4 7 9] 3 [3 5 6 10]
        4 [3 5 6 10] }
}

::machinist_contract::constants! {
    motor_omega_0, motor_u_x, motor_u_y, t2, inverse_motor_inertia, motor_alpha_s_times_motor_omega_0,
    motor_alpha_r_times_motor_omega_0, motor_psi_sx_dot_by_motor_psi_sx,
    motor_psi_sy_dot_by_motor_psi_sx, motor_psi_rx_dot_by_motor_psi_sx,
    motor_psi_sx_dot_by_motor_psi_rx, motor_psi_rx_dot_by_motor_psi_rx, t3, t4, t5, t6, t7,
    minus_motor_u_y, t8, motor_k_r_over_motor_sigma, t9, motor_k_s_over_motor_sigma, t10
}

/// Returns the constants of `rate` and its Jacobians from the parameters. 39 operations.
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
    let motor_alpha_s_times_motor_omega_0 = p.motor_alpha_s * motor_omega_0;
    let motor_alpha_r_times_motor_omega_0 = p.motor_alpha_r * motor_omega_0;
    let motor_psi_sx_dot_by_motor_psi_sx = -motor_alpha_s_times_motor_omega_0;
    let motor_psi_sy_dot_by_motor_psi_sx = -motor_omega_0;
    let motor_psi_rx_dot_by_motor_psi_sx = p.motor_k_s * p.motor_alpha_r * motor_omega_0;
    let motor_psi_sx_dot_by_motor_psi_rx = p.motor_k_r * p.motor_alpha_s * motor_omega_0;
    let motor_psi_rx_dot_by_motor_psi_rx = -motor_alpha_r_times_motor_omega_0;
    let t3 = R::literal(core::f64::consts::SQRT_2) * cos_motor_supply_phase;
    let t4 = R::literal(core::f64::consts::SQRT_2) * sin_motor_supply_phase;
    let t5 = R::literal(3.0 * core::f64::consts::PI) * p.motor_pole_pairs * p.motor_k_r
        / motor_x_s_times_motor_sigma;
    let t6 = R::literal(core::f64::consts::TAU) * p.motor_alpha_s;
    let t7 = R::literal(core::f64::consts::TAU) * p.motor_alpha_r;
    let minus_motor_u_y = -motor_u_y;
    let t8 = R::literal(1.5) * p.motor_k_r * motor_omega_0 / motor_x_s_times_motor_sigma;
    let motor_k_r_over_motor_sigma = p.motor_k_r / motor_sigma;
    let t9 = t1 * motor_omega_0 / motor_x_s_times_motor_sigma;
    let motor_k_s_over_motor_sigma = p.motor_k_s / motor_sigma;
    let t10 = R::literal(-1.0) / p.motor_x_s;
    Constants { motor_omega_0, motor_u_x, motor_u_y, t2, inverse_motor_inertia,
        motor_alpha_s_times_motor_omega_0, motor_alpha_r_times_motor_omega_0,
        motor_psi_sx_dot_by_motor_psi_sx, motor_psi_sy_dot_by_motor_psi_sx,
        motor_psi_rx_dot_by_motor_psi_sx, motor_psi_sx_dot_by_motor_psi_rx,
        motor_psi_rx_dot_by_motor_psi_rx, t3, t4, t5, t6, t7, minus_motor_u_y, t8,
        motor_k_r_over_motor_sigma, t9, motor_k_s_over_motor_sigma, t10 }
}

/// State at the start of the run, in the units of the states. No operations.
#[must_use]
pub fn initial_state<R: Real>(p: &Parameters<R>) -> [R; STATES] {
    [p.initial_speed, R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0)]
}

/// Times of known jumps of the right-hand side \[s\], unsorted. No operations.
#[must_use]
pub fn discontinuities<R: Real>(_p: &Parameters<R>) -> [R; DISCONTINUITIES] {
    []
}

/// As `rate`, with the constants of the parameters from `prepare`. 29 operations.
#[must_use]
#[inline]
pub fn prepared_rate<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>,
        c: &Constants<R>) -> [R; STATES] {
    let [motor_omega, motor_psi_sx, motor_psi_sy, motor_psi_rx, motor_psi_ry] = *state;
    let motor_slip_speed = c.motor_omega_0.sub_product(p.motor_pole_pairs, motor_omega);
    let motor_torque = c.t2 * (motor_psi_sy * motor_psi_rx).sub_product(motor_psi_sx, motor_psi_ry);
    let motor_omega_dot = motor_torque * c.inverse_motor_inertia;
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
    [motor_omega_dot, motor_psi_sx_dot, motor_psi_sy_dot, motor_psi_rx_dot, motor_psi_ry_dot]
}

/// `M = d2L/dq'2`, values in the order of its pattern. No operations.
#[must_use]
pub fn mass_matrix<R: Real>(_time: R, _state: &[R; STATES], p: &Parameters<R>) -> [R; 1] {
    [p.motor_inertia]
}

/// `f` of `M q'' = f + G^T lambda`, one for each coordinate. 12 operations.
#[must_use]
pub fn forcing<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>) -> [R; COORDINATES] {
    let [_, motor_psi_sx, motor_psi_sy, motor_psi_rx, motor_psi_ry] = *state;
    let motor_omega_0 = R::literal(core::f64::consts::TAU) * p.motor_supply_frequency;
    let motor_sigma = R::literal(1.0).sub_product(p.motor_k_s, p.motor_k_r);
    let motor_torque = R::literal(1.5) * p.motor_pole_pairs * p.motor_k_r * motor_omega_0
        / (p.motor_x_s * motor_sigma) * (motor_psi_sy * motor_psi_rx).sub_product(motor_psi_sx,
        motor_psi_ry);
    [motor_torque]
}

/// As `rate_jacobian`, with the constants of the parameters from `prepare`. 16 operations.
#[must_use]
pub fn prepared_rate_jacobian<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>,
        c: &Constants<R>) -> [R; 18] {
    let [motor_omega, motor_psi_sx, motor_psi_sy, motor_psi_rx, motor_psi_ry] = *state;
    let motor_pole_pairs_times_motor_omega = p.motor_pole_pairs * motor_omega;
    let motor_slip_speed = c.motor_omega_0 - motor_pole_pairs_times_motor_omega;
    let motor_psi_rx_dot_by_motor_omega = -(p.motor_pole_pairs * motor_psi_ry);
    let motor_psi_ry_dot_by_motor_omega = p.motor_pole_pairs * motor_psi_rx;
    let motor_omega_dot_by_motor_psi_sx = -(c.t2 * motor_psi_ry * c.inverse_motor_inertia);
    let motor_omega_dot_by_motor_psi_sy = c.t2 * motor_psi_rx * c.inverse_motor_inertia;
    let motor_omega_dot_by_motor_psi_rx = c.t2 * motor_psi_sy * c.inverse_motor_inertia;
    let motor_psi_ry_dot_by_motor_psi_rx = motor_pole_pairs_times_motor_omega - c.motor_omega_0;
    let motor_omega_dot_by_motor_psi_ry = -(c.t2 * motor_psi_sx * c.inverse_motor_inertia);
    [motor_omega_dot_by_motor_psi_sx, motor_omega_dot_by_motor_psi_sy,
        motor_omega_dot_by_motor_psi_rx, motor_omega_dot_by_motor_psi_ry,
        c.motor_psi_sx_dot_by_motor_psi_sx, c.motor_omega_0, c.motor_psi_sx_dot_by_motor_psi_rx,
        c.motor_psi_sy_dot_by_motor_psi_sx, c.motor_psi_sx_dot_by_motor_psi_sx,
        c.motor_psi_sx_dot_by_motor_psi_rx, motor_psi_rx_dot_by_motor_omega,
        c.motor_psi_rx_dot_by_motor_psi_sx, c.motor_psi_rx_dot_by_motor_psi_rx, motor_slip_speed,
        motor_psi_ry_dot_by_motor_omega, c.motor_psi_rx_dot_by_motor_psi_sx,
        motor_psi_ry_dot_by_motor_psi_rx, c.motor_psi_rx_dot_by_motor_psi_rx]
}

/// `rate_jacobian`, then `parameter_jacobian`, with the constants of the parameters from `prepare`.
/// 68 operations.
#[must_use]
pub fn prepared_jacobians<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>,
        c: &Constants<R>) -> [R; 42] {
    let [motor_omega, motor_psi_sx, motor_psi_sy, motor_psi_rx, motor_psi_ry] = *state;
    let motor_pole_pairs_times_motor_omega = p.motor_pole_pairs * motor_omega;
    let motor_slip_speed = c.motor_omega_0 - motor_pole_pairs_times_motor_omega;
    let motor_psi_rx_dot_by_motor_omega = -(p.motor_pole_pairs * motor_psi_ry);
    let motor_psi_ry_dot_by_motor_omega = p.motor_pole_pairs * motor_psi_rx;
    let motor_omega_dot_by_motor_psi_sx = -(c.t2 * motor_psi_ry * c.inverse_motor_inertia);
    let motor_omega_dot_by_motor_psi_sy = c.t2 * motor_psi_rx * c.inverse_motor_inertia;
    let motor_omega_dot_by_motor_psi_rx = c.t2 * motor_psi_sy * c.inverse_motor_inertia;
    let motor_psi_ry_dot_by_motor_psi_rx = motor_pole_pairs_times_motor_omega - c.motor_omega_0;
    let motor_omega_dot_by_motor_psi_ry = -(c.t2 * motor_psi_sx * c.inverse_motor_inertia);
    let t0 = motor_psi_sx.sub_product(p.motor_k_r, motor_psi_rx);
    let t1 = motor_psi_sy.sub_product(p.motor_k_r, motor_psi_ry);
    let t2 = (motor_psi_sy * motor_psi_rx).sub_product(motor_psi_sx, motor_psi_ry);
    let motor_torque = c.t2 * t2;
    let motor_omega_dot = motor_torque * c.inverse_motor_inertia;
    let t3 = (-motor_psi_rx).add_product(p.motor_k_s, motor_psi_sx);
    let t4 = (-motor_psi_ry).add_product(p.motor_k_s, motor_psi_sy);
    let motor_omega_dot_by_motor_inertia = -(motor_omega_dot * c.inverse_motor_inertia);
    let motor_omega_dot_by_motor_supply_frequency = c.t5 * t2 * c.inverse_motor_inertia;
    let motor_psi_sx_dot_by_motor_supply_frequency = (R::literal(core::f64::consts::TAU)
        * motor_psi_sy).sub_product(c.t6, t0);
    let motor_psi_sy_dot_by_motor_supply_frequency = (R::literal(-6.283_185_307_179_586)
        * motor_psi_sx).sub_product(c.t6, t1);
    let motor_psi_rx_dot_by_motor_supply_frequency = (R::literal(core::f64::consts::TAU)
        * motor_psi_ry).add_product(c.t7, t3);
    let motor_psi_ry_dot_by_motor_supply_frequency = (R::literal(-6.283_185_307_179_586)
        * motor_psi_rx).add_product(c.t7, t4);
    let motor_omega_dot_by_motor_pole_pairs = c.t8 * t2 * c.inverse_motor_inertia;
    let motor_psi_rx_dot_by_motor_pole_pairs = -(motor_omega * motor_psi_ry);
    let motor_psi_ry_dot_by_motor_pole_pairs = motor_omega * motor_psi_rx;
    let motor_omega_dot_by_motor_k_s = c.motor_k_r_over_motor_sigma * motor_torque
        * c.inverse_motor_inertia;
    let motor_psi_rx_dot_by_motor_k_s = c.motor_alpha_r_times_motor_omega_0 * motor_psi_sx;
    let motor_psi_ry_dot_by_motor_k_s = c.motor_alpha_r_times_motor_omega_0 * motor_psi_sy;
    let motor_omega_dot_by_motor_k_r = (c.t9 * t2).add_product(c.motor_k_s_over_motor_sigma,
        motor_torque) * c.inverse_motor_inertia;
    let motor_psi_sx_dot_by_motor_k_r = c.motor_alpha_s_times_motor_omega_0 * motor_psi_rx;
    let motor_psi_sy_dot_by_motor_k_r = c.motor_alpha_s_times_motor_omega_0 * motor_psi_ry;
    let motor_omega_dot_by_motor_x_s = c.t10 * motor_torque * c.inverse_motor_inertia;
    let motor_psi_sx_dot_by_motor_alpha_s = -(c.motor_omega_0 * t0);
    let motor_psi_sy_dot_by_motor_alpha_s = -(c.motor_omega_0 * t1);
    let motor_psi_rx_dot_by_motor_alpha_r = c.motor_omega_0 * t3;
    let motor_psi_ry_dot_by_motor_alpha_r = c.motor_omega_0 * t4;
    [motor_omega_dot_by_motor_psi_sx, motor_omega_dot_by_motor_psi_sy,
        motor_omega_dot_by_motor_psi_rx, motor_omega_dot_by_motor_psi_ry,
        c.motor_psi_sx_dot_by_motor_psi_sx, c.motor_omega_0, c.motor_psi_sx_dot_by_motor_psi_rx,
        c.motor_psi_sy_dot_by_motor_psi_sx, c.motor_psi_sx_dot_by_motor_psi_sx,
        c.motor_psi_sx_dot_by_motor_psi_rx, motor_psi_rx_dot_by_motor_omega,
        c.motor_psi_rx_dot_by_motor_psi_sx, c.motor_psi_rx_dot_by_motor_psi_rx, motor_slip_speed,
        motor_psi_ry_dot_by_motor_omega, c.motor_psi_rx_dot_by_motor_psi_sx,
        motor_psi_ry_dot_by_motor_psi_rx, c.motor_psi_rx_dot_by_motor_psi_rx,
        motor_omega_dot_by_motor_inertia, motor_omega_dot_by_motor_supply_frequency,
        motor_omega_dot_by_motor_pole_pairs, motor_omega_dot_by_motor_k_s,
        motor_omega_dot_by_motor_k_r, motor_omega_dot_by_motor_x_s, c.t3,
        motor_psi_sx_dot_by_motor_supply_frequency, c.minus_motor_u_y,
        motor_psi_sx_dot_by_motor_k_r, motor_psi_sx_dot_by_motor_alpha_s, c.t4,
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
    [R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0)]
}

/// Wanted outputs. 27 operations.
#[must_use]
pub fn outputs<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>) -> Outputs<R> {
    let [motor_omega, motor_psi_sx, motor_psi_sy, motor_psi_rx, motor_psi_ry] = *state;
    let motor_omega_0 = R::literal(core::f64::consts::TAU) * p.motor_supply_frequency;
    let motor_sigma = R::literal(1.0).sub_product(p.motor_k_s, p.motor_k_r);
    let motor_slip_speed = motor_omega_0.sub_product(p.motor_pole_pairs, motor_omega);
    let motor_x_s_times_motor_sigma = p.motor_x_s * motor_sigma;
    let t0 = motor_omega_0 / motor_x_s_times_motor_sigma;
    let motor_i_sx = t0 * motor_psi_sx.sub_product(p.motor_k_r, motor_psi_rx);
    let motor_i_sy = t0 * motor_psi_sy.sub_product(p.motor_k_r, motor_psi_ry);
    let motor_torque = R::literal(1.5) * p.motor_pole_pairs * p.motor_k_r * motor_omega_0
        / motor_x_s_times_motor_sigma * (motor_psi_sy * motor_psi_rx).sub_product(motor_psi_sx,
        motor_psi_ry);
    Outputs {
        speed: motor_omega,
        torque: motor_torque,
        slip: R::literal(1.0) / motor_omega_0 * motor_slip_speed,
        stator_current: (motor_i_sx * motor_i_sx).add_product(motor_i_sy, motor_i_sy).sqrt(),
    }
}

/// T, V and the energy of first-order states \[J\]. 32 operations.
#[must_use]
pub fn energy<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>) -> Energy<R> {
    let [motor_omega, motor_psi_sx, motor_psi_sy, motor_psi_rx, motor_psi_ry] = *state;
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
        kinetic: R::literal(0.5) * p.motor_inertia * (motor_omega * motor_omega),
        potential: R::literal(0.0),
        stored: R::literal(0.75) * (motor_psi_sx * motor_i_sx).add_product(motor_psi_sy, motor_i_sy)
            .add_product(motor_psi_rx, motor_i_rx).add_product(motor_psi_ry, motor_i_ry),
    }
}

/// `dE/dt`, power supplied and power dissipated \[W\]. 106 operations.
#[must_use]
pub fn power_balance<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>) -> PowerBalance<R> {
    let [motor_omega, motor_psi_sx, motor_psi_sy, motor_psi_rx, motor_psi_ry] = *state;
    let (sin_motor_supply_phase, cos_motor_supply_phase) = p.motor_supply_phase.sin_cos();
    let motor_omega_0 = R::literal(core::f64::consts::TAU) * p.motor_supply_frequency;
    let motor_sigma = R::literal(1.0).sub_product(p.motor_k_s, p.motor_k_r);
    let motor_x_r = p.motor_k_s * p.motor_x_s / p.motor_k_r;
    let t0 = p.motor_phase_voltage * R::literal(core::f64::consts::SQRT_2);
    let motor_u_x = t0 * cos_motor_supply_phase;
    let motor_u_y = t0 * sin_motor_supply_phase;
    let motor_slip_speed = motor_omega_0.sub_product(p.motor_pole_pairs, motor_omega);
    let t1 = motor_psi_sx.sub_product(p.motor_k_r, motor_psi_rx);
    let motor_x_s_times_motor_sigma = p.motor_x_s * motor_sigma;
    let t2 = motor_omega_0 / motor_x_s_times_motor_sigma;
    let motor_i_sx = t2 * t1;
    let t3 = motor_psi_sy.sub_product(p.motor_k_r, motor_psi_ry);
    let motor_i_sy = t2 * t3;
    let motor_k_s_times_motor_psi_sx = p.motor_k_s * motor_psi_sx;
    let t4 = motor_omega_0 / (motor_sigma * motor_x_r);
    let motor_i_rx = t4 * (motor_psi_rx - motor_k_s_times_motor_psi_sx);
    let motor_k_s_times_motor_psi_sy = p.motor_k_s * motor_psi_sy;
    let motor_i_ry = t4 * (motor_psi_ry - motor_k_s_times_motor_psi_sy);
    let motor_torque = R::literal(1.5) * p.motor_pole_pairs * p.motor_k_r * motor_omega_0
        / motor_x_s_times_motor_sigma * (motor_psi_sy * motor_psi_rx).sub_product(motor_psi_sx,
        motor_psi_ry);
    let motor_omega_dot = motor_torque * (R::literal(1.0) / p.motor_inertia);
    let motor_alpha_s_times_motor_omega_0 = p.motor_alpha_s * motor_omega_0;
    let motor_psi_sx_dot = motor_u_x.add_product(motor_omega_0, motor_psi_sy)
        .sub_product(motor_alpha_s_times_motor_omega_0, t1);
    let motor_psi_sy_dot = motor_u_y.sub_product(motor_omega_0, motor_psi_sx)
        .sub_product(motor_alpha_s_times_motor_omega_0, t3);
    let motor_alpha_r_times_motor_omega_0 = p.motor_alpha_r * motor_omega_0;
    let motor_psi_rx_dot = (motor_psi_ry * motor_slip_speed)
        .add_product(motor_alpha_r_times_motor_omega_0, motor_k_s_times_motor_psi_sx
        - motor_psi_rx);
    let motor_psi_ry_dot = (motor_alpha_r_times_motor_omega_0 * (motor_k_s_times_motor_psi_sy
        - motor_psi_ry)).sub_product(motor_psi_rx, motor_slip_speed);
    let t5 = p.motor_k_r * motor_omega_0 / motor_x_s_times_motor_sigma;
    PowerBalance {
        stored_rate: (p.motor_inertia * motor_omega * motor_omega_dot).add_product(R::literal(0.75)
            * motor_i_sx.add_product(t2, motor_psi_sx).sub_product(t5, motor_psi_rx),
            motor_psi_sx_dot).add_product(R::literal(0.75) * motor_i_sy.add_product(t2,
            motor_psi_sy).sub_product(t5, motor_psi_ry), motor_psi_sy_dot)
            .add_product(R::literal(0.75) * motor_i_rx.add_product(t4, motor_psi_rx)
            .sub_product(t5, motor_psi_sx), motor_psi_rx_dot).add_product(R::literal(0.75)
            * motor_i_ry.add_product(t4, motor_psi_ry).sub_product(t5, motor_psi_sy),
            motor_psi_ry_dot),
        supplied: R::literal(1.5) * (motor_u_x * motor_i_sx).add_product(motor_u_y, motor_i_sy),
        dissipated: R::literal(1.5) * (p.motor_x_s * p.motor_alpha_s * motor_sigma * (motor_i_sx
            * motor_i_sx).add_product(motor_i_sy, motor_i_sy)).add_product(p.motor_alpha_r
            * motor_sigma * motor_x_r, (motor_i_rx * motor_i_rx).add_product(motor_i_ry,
            motor_i_ry)),
    }
}

/// Normalized Taylor coefficients of the solution through `state`, order after order.
///
/// `_k` marks the coefficient of order k, `_before` that of order k - 1; bare names are
/// zeroth coefficients. The workspace is as `series_workspace` says.
///
/// 64 recurrences. 4 sums of products an order.
///
/// # Panics
/// If there is no room for the zeroth coefficients, or the workspace is too short.
pub fn series<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>,
        coefficients: &mut [[R; STATES]], workspace: &mut [R]) {
    let (mut lanes, _) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let [motor_omega, motor_psi_sx, motor_psi_sy, motor_psi_rx, motor_psi_ry] = *state;
    let motor_omega_0 = R::literal(core::f64::consts::TAU) * p.motor_supply_frequency;
    let t0 = p.motor_k_s * p.motor_k_r;
    let motor_sigma = R::literal(1.0) - t0;
    let t1 = p.motor_supply_phase.cos();
    let t2 = p.motor_phase_voltage * R::literal(core::f64::consts::SQRT_2);
    let motor_u_x = t2 * t1;
    let t3 = p.motor_supply_phase.sin();
    let motor_u_y = t2 * t3;
    let t4 = motor_omega * p.motor_pole_pairs;
    let motor_slip_speed = motor_omega_0 - t4;
    let t5 = motor_psi_rx * p.motor_k_r;
    let t6 = motor_psi_sx - t5;
    let t7 = p.motor_x_s * motor_sigma;
    let t8 = motor_psi_ry * p.motor_k_r;
    let t9 = motor_psi_sy - t8;
    let t10 = motor_psi_sx * p.motor_k_s;
    let t11 = motor_psi_sy * p.motor_k_s;
    let t12 = motor_psi_sx * motor_psi_ry;
    let t13 = motor_psi_sy * motor_psi_rx;
    let t14 = t13 - t12;
    let t15 = R::literal(1.5) * p.motor_pole_pairs;
    let t16 = t15 * p.motor_k_r;
    let t17 = t16 * motor_omega_0;
    let t18 = t17 / t7;
    let t19 = R::literal(1.0) / p.motor_inertia;
    let t20 = t18 * t19;
    let motor_omega_dot = t14 * t20;
    let t21 = p.motor_alpha_s * motor_omega_0;
    let t22 = t6 * t21;
    let t23 = motor_psi_sy * motor_omega_0;
    let t24 = motor_u_x + t23;
    let motor_psi_sx_dot = t24 - t22;
    let t25 = motor_psi_sx * motor_omega_0;
    let t26 = t9 * t21;
    let t27 = motor_u_y - t25;
    let motor_psi_sy_dot = t27 - t26;
    let t28 = motor_psi_ry * motor_slip_speed;
    let t29 = t10 - motor_psi_rx;
    let t30 = p.motor_alpha_r * motor_omega_0;
    let t31 = t29 * t30;
    let motor_psi_rx_dot = t28 + t31;
    let t32 = motor_psi_rx * motor_slip_speed;
    let t33 = t11 - motor_psi_ry;
    let t34 = t33 * t30;
    let motor_psi_ry_dot = t34 - t32;
    let mut rates = [motor_omega_dot, motor_psi_sx_dot, motor_psi_sy_dot, motor_psi_rx_dot,
        motor_psi_ry_dot];
    coefficients[0] = *state;
    let highest = coefficients.len() - 1;
    for (order, state_k) in coefficients.iter_mut().enumerate().skip(1) {
        let (_, inverse) = order_and_inverse::<R>(order);
        *state_k = rates.map(|rate| rate * inverse);
        if order == highest {
            break;
        }
        let [motor_omega_k, motor_psi_sx_k, motor_psi_sy_k, motor_psi_rx_k, motor_psi_ry_k]
            = *state_k;
        let sums = lanes.sums(order);
        let motor_slip_speed_k = -motor_omega_k * p.motor_pole_pairs;
        let t6_k = (-motor_psi_rx_k).mul_add(p.motor_k_r, motor_psi_sx_k);
        let t9_k = (-motor_psi_ry_k).mul_add(p.motor_k_r, motor_psi_sy_k);
        let t12_k = motor_psi_sx.mul_add(motor_psi_ry_k, motor_psi_ry.mul_add(motor_psi_sx_k,
            sums[0]));
        let t13_k = motor_psi_sy.mul_add(motor_psi_rx_k, motor_psi_rx.mul_add(motor_psi_sy_k,
            sums[1]));
        let t14_k = t13_k - t12_k;
        let motor_omega_dot_k = t14_k * t20;
        let motor_psi_sx_dot_k = (-t6_k).mul_add(t21, motor_psi_sy_k * motor_omega_0);
        let t27_k = -motor_psi_sx_k * motor_omega_0;
        let motor_psi_sy_dot_k = (-t9_k).mul_add(t21, t27_k);
        let t28_k = motor_psi_ry.mul_add(motor_slip_speed_k, motor_slip_speed
            .mul_add(motor_psi_ry_k, sums[2]));
        let t29_k = motor_psi_sx_k.mul_add(p.motor_k_s, -motor_psi_rx_k);
        let motor_psi_rx_dot_k = t29_k.mul_add(t30, t28_k);
        let t32_k = motor_psi_rx.mul_add(motor_slip_speed_k, motor_slip_speed
            .mul_add(motor_psi_rx_k, sums[3]));
        let t33_k = motor_psi_sy_k.mul_add(p.motor_k_s, -motor_psi_ry_k);
        let motor_psi_ry_dot_k = t33_k.mul_add(t30, -t32_k);
        lanes.set(order, [motor_psi_sx_k, motor_psi_rx_k, motor_slip_speed_k, motor_slip_speed_k],
            [motor_psi_ry_k, motor_psi_sy_k, motor_psi_ry_k, motor_psi_rx_k]);
        rates = [motor_omega_dot_k, motor_psi_sx_dot_k, motor_psi_sy_dot_k, motor_psi_rx_dot_k,
            motor_psi_ry_dot_k];
    }
}

// Emitted by Machinist 0.1.0; do not edit. To make it again:
//
//     cargo run --release -- gen
//
// Sources, with SHA-256:
//   e10023c9e5545611f862023c1c9ab311a625bca1ee0a3bfad85f2ca356ec5e7f  bench/m1.toml
//   03bebde2dcd618fcbd0662a0f5e63f806e09d154c0fc25f1f0527c30944dd55e  units/textile/induction_motor.toml
//
// Benchmark M1: induction motor alone
//
// From rest to synchronous speed in about 0.8 s.
//
// Source:
//   Benchmark models of textile-machine dynamics.
//
// All quantities are in SI units.
// Shapes: coordinates 1, first-order states 4, states 5, outputs 5.
// Nonzeros: mass_matrix 1 of 1 by 1, rate_jacobian 18 of 5 by 5, parameter_jacobian 0 of 5 by 0.
// Operations: rate 30, forcing 4, rate_jacobian 9, energy 22, power_balance 75.

use ::machinist_contract::{
    Energy, PowerBalance, Real, taylor::{Lanes, order_and_inverse},
};

::machinist_contract::simulator! {
    /// Benchmark M1: induction motor alone
    ///
    /// From rest to synchronous speed in about 0.8 s.
    ///
    /// Source: Benchmark models of textile-machine dynamics.
    M1: "m1", "Benchmark M1: induction motor alone";
    run from 0.0, until 1.0, points 501, rtol 1e-8, method "auto";
    quadratures 0, discontinuities 0;
    coordinates; series 4;
}

::machinist_contract::parameters! {}

::machinist_contract::outputs! {
    psi_x1: "V s", "psi_x1", "stator flux linkage along x";
    psi_y1: "V s", "psi_y1", "stator flux linkage along y";
    psi_x2: "V s", "psi_x2", "rotor flux linkage along x";
    psi_y2: "V s", "psi_y2", "rotor flux linkage along y";
    w: "rad/s", "w", "rate of rotor angle";
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
    PARAMETER_JACOBIAN_PATTERN: 5 by 0 {  }
}

/// State at the start of the run, in the units of the states. No operations.
#[must_use]
pub fn initial_state<R: Real>(_p: &Parameters<R>) -> [R; STATES] {
    [R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0)]
}

/// Times of known jumps of the right-hand side \[s\], unsorted. No operations.
#[must_use]
pub fn discontinuities<R: Real>(_p: &Parameters<R>) -> [R; DISCONTINUITIES] {
    []
}

/// `y'`: velocities, `q''` of `M q'' = f + G^T lambda`, `h`; in the units of the states per second.
/// 30 operations.
#[must_use]
#[inline]
pub fn rate<R: Real>(_time: R, state: &[R; STATES], _p: &Parameters<R>) -> [R; STATES] {
    let [motor_omega, motor_psi_sx, motor_psi_sy, motor_psi_rx, motor_psi_ry] = *state;
    let motor_slip_speed = R::literal(314.159_265_358_979_3).sub_product(R::literal(4.0),
        motor_omega);
    let motor_i_sx = R::literal(844.204_793_982_429_1) * motor_psi_sx
        .sub_product(R::literal(0.952), motor_psi_rx);
    let motor_i_sy = R::literal(844.204_793_982_429_1) * motor_psi_sy
        .sub_product(R::literal(0.952), motor_psi_ry);
    let motor_torque = R::literal(4_822.097_783_227_635) * (motor_psi_sy * motor_psi_rx)
        .sub_product(motor_psi_sx, motor_psi_ry);
    let motor_omega_dot = motor_torque * R::literal(0.238_095_238_095_238_08);
    let motor_psi_sx_dot = R::literal(311.126_983_722_080_9)
        .add_product(R::literal(314.159_265_358_979_3), motor_psi_sy)
        .sub_product(R::literal(0.042_795_676_8), motor_i_sx);
    let motor_psi_sy_dot = (R::literal(-314.159_265_358_979_3) * motor_psi_sx)
        .sub_product(R::literal(0.042_795_676_8), motor_i_sy);
    let motor_psi_rx_dot = (R::literal(26.954_864_967_800_425) * (-motor_psi_rx)
        .add_product(R::literal(0.956), motor_psi_sx)).add_product(motor_psi_ry, motor_slip_speed);
    let motor_psi_ry_dot = (R::literal(26.954_864_967_800_425) * (-motor_psi_ry)
        .add_product(R::literal(0.956), motor_psi_sy)).sub_product(motor_psi_rx, motor_slip_speed);
    [motor_omega_dot, motor_psi_sx_dot, motor_psi_sy_dot, motor_psi_rx_dot, motor_psi_ry_dot]
}

/// `M = d2L/dq'2`, values in the order of its pattern. No operations.
#[must_use]
pub fn mass_matrix<R: Real>(_time: R, _state: &[R; STATES], _p: &Parameters<R>) -> [R; 1] {
    [R::literal(4.2)]
}

/// `f` of `M q'' = f + G^T lambda`, one for each coordinate. 4 operations.
#[must_use]
pub fn forcing<R: Real>(_time: R, state: &[R; STATES], _p: &Parameters<R>) -> [R; COORDINATES] {
    let [_, motor_psi_sx, motor_psi_sy, motor_psi_rx, motor_psi_ry] = *state;
    let motor_torque = R::literal(4_822.097_783_227_635) * (motor_psi_sy * motor_psi_rx)
        .sub_product(motor_psi_sx, motor_psi_ry);
    [motor_torque]
}

/// `dy'/dy`, values in the order of its pattern. 9 operations.
#[must_use]
pub fn rate_jacobian<R: Real>(_time: R, state: &[R; STATES], _p: &Parameters<R>) -> [R; 18] {
    let [motor_omega, motor_psi_sx, motor_psi_sy, motor_psi_rx, motor_psi_ry] = *state;
    let t0 = R::literal(4.0) * motor_omega;
    let motor_slip_speed = R::literal(314.159_265_358_979_3) - t0;
    let motor_psi_rx_dot_by_motor_omega = R::literal(-4.0) * motor_psi_ry;
    let motor_psi_ry_dot_by_motor_omega = R::literal(4.0) * motor_psi_rx;
    let motor_omega_dot_by_motor_psi_sx = R::literal(-1_148.118_519_816_103_6) * motor_psi_ry;
    let motor_omega_dot_by_motor_psi_sy = R::literal(1_148.118_519_816_103_6) * motor_psi_rx;
    let motor_omega_dot_by_motor_psi_rx = R::literal(1_148.118_519_816_103_6) * motor_psi_sy;
    let motor_psi_ry_dot_by_motor_psi_rx = t0 - R::literal(314.159_265_358_979_3);
    let motor_omega_dot_by_motor_psi_ry = R::literal(-1_148.118_519_816_103_6) * motor_psi_sx;
    [motor_omega_dot_by_motor_psi_sx, motor_omega_dot_by_motor_psi_sy,
        motor_omega_dot_by_motor_psi_rx, motor_omega_dot_by_motor_psi_ry,
        R::literal(-36.128_315_516_282_62), R::literal(314.159_265_358_979_3),
        R::literal(34.394_156_371_501_055), R::literal(-314.159_265_358_979_3),
        R::literal(-36.128_315_516_282_62), R::literal(34.394_156_371_501_055),
        motor_psi_rx_dot_by_motor_omega, R::literal(25.768_850_909_217_203),
        R::literal(-26.954_864_967_800_425), motor_slip_speed, motor_psi_ry_dot_by_motor_omega,
        R::literal(25.768_850_909_217_203), motor_psi_ry_dot_by_motor_psi_rx,
        R::literal(-26.954_864_967_800_425)]
}

/// `dy'/dp`, values in the order of its pattern. No operations.
#[must_use]
pub fn parameter_jacobian<R: Real>(_time: R, _state: &[R; STATES], _p: &Parameters<R>) -> [R; 0] {
    []
}

/// Partial derivative of `y'` with respect to time. No operations.
#[must_use]
pub fn time_derivative<R: Real>(_time: R, _state: &[R; STATES], _p: &Parameters<R>) -> [R; STATES] {
    [R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0)]
}

/// Wanted outputs. No operations.
#[must_use]
pub fn outputs<R: Real>(_time: R, state: &[R; STATES], _p: &Parameters<R>) -> Outputs<R> {
    let [motor_omega, motor_psi_sx, motor_psi_sy, motor_psi_rx, motor_psi_ry] = *state;
    Outputs {
        psi_x1: motor_psi_sx,
        psi_y1: motor_psi_sy,
        psi_x2: motor_psi_rx,
        psi_y2: motor_psi_ry,
        w: motor_omega,
    }
}

/// T, V and the energy of first-order states \[J\]. 22 operations.
#[must_use]
pub fn energy<R: Real>(_time: R, state: &[R; STATES], _p: &Parameters<R>) -> Energy<R> {
    let [motor_omega, motor_psi_sx, motor_psi_sy, motor_psi_rx, motor_psi_ry] = *state;
    let motor_i_sx = R::literal(844.204_793_982_429_1) * motor_psi_sx
        .sub_product(R::literal(0.952), motor_psi_rx);
    let motor_i_sy = R::literal(844.204_793_982_429_1) * motor_psi_sy
        .sub_product(R::literal(0.952), motor_psi_ry);
    let motor_i_rx = R::literal(840.672_556_350_703_5) * motor_psi_rx
        .sub_product(R::literal(0.956), motor_psi_sx);
    let motor_i_ry = R::literal(840.672_556_350_703_5) * motor_psi_ry
        .sub_product(R::literal(0.956), motor_psi_sy);
    Energy {
        kinetic: R::literal(2.1) * (motor_omega * motor_omega),
        potential: R::literal(0.0),
        stored: R::literal(0.75) * (motor_psi_sx * motor_i_sx).add_product(motor_psi_sy, motor_i_sy)
            .add_product(motor_psi_rx, motor_i_rx).add_product(motor_psi_ry, motor_i_ry),
    }
}

/// `dE/dt`, power supplied and power dissipated \[W\]. 75 operations.
#[must_use]
pub fn power_balance<R: Real>(_time: R, state: &[R; STATES],
        _p: &Parameters<R>) -> PowerBalance<R> {
    let [motor_omega, motor_psi_sx, motor_psi_sy, motor_psi_rx, motor_psi_ry] = *state;
    let motor_slip_speed = R::literal(314.159_265_358_979_3).sub_product(R::literal(4.0),
        motor_omega);
    let motor_i_sx = R::literal(844.204_793_982_429_1) * motor_psi_sx
        .sub_product(R::literal(0.952), motor_psi_rx);
    let motor_i_sy = R::literal(844.204_793_982_429_1) * motor_psi_sy
        .sub_product(R::literal(0.952), motor_psi_ry);
    let t0 = R::literal(0.956) * motor_psi_sx;
    let motor_i_rx = R::literal(840.672_556_350_703_5) * (motor_psi_rx - t0);
    let t1 = R::literal(0.956) * motor_psi_sy;
    let motor_i_ry = R::literal(840.672_556_350_703_5) * (motor_psi_ry - t1);
    let motor_torque = R::literal(4_822.097_783_227_635) * (motor_psi_sy * motor_psi_rx)
        .sub_product(motor_psi_sx, motor_psi_ry);
    let motor_omega_dot = motor_torque * R::literal(0.238_095_238_095_238_08);
    let motor_psi_sx_dot = R::literal(311.126_983_722_080_9)
        .add_product(R::literal(314.159_265_358_979_3), motor_psi_sy)
        .sub_product(R::literal(0.042_795_676_8), motor_i_sx);
    let motor_psi_rx_dot = (R::literal(26.954_864_967_800_425) * (t0 - motor_psi_rx))
        .add_product(motor_psi_ry, motor_slip_speed);
    let motor_psi_ry_dot = (R::literal(26.954_864_967_800_425) * (t1 - motor_psi_ry))
        .sub_product(motor_psi_rx, motor_slip_speed);
    PowerBalance {
        stored_rate: (R::literal(4.2) * motor_omega * motor_omega_dot).add_product(R::literal(0.75)
            * motor_i_sx.add_product(R::literal(844.204_793_982_429_1), motor_psi_sx)
            .sub_product(R::literal(803.682_963_871_272_6), motor_psi_rx), motor_psi_sx_dot)
            .sub_product(R::literal(0.75) * motor_i_sy
            .add_product(R::literal(844.204_793_982_429_1), motor_psi_sy)
            .sub_product(R::literal(803.682_963_871_272_6), motor_psi_ry),
            (R::literal(314.159_265_358_979_3) * motor_psi_sx)
            .add_product(R::literal(0.042_795_676_8), motor_i_sy)).add_product(R::literal(0.75)
            * motor_i_rx.add_product(R::literal(840.672_556_350_703_5), motor_psi_rx)
            .sub_product(R::literal(803.682_963_871_272_6), motor_psi_sx), motor_psi_rx_dot)
            .add_product(R::literal(0.75) * motor_i_ry
            .add_product(R::literal(840.672_556_350_703_5), motor_psi_ry)
            .sub_product(R::literal(803.682_963_871_272_6), motor_psi_sy), motor_psi_ry_dot),
        supplied: R::literal(466.690_475_583_121_4) * motor_i_sx,
        dissipated: R::literal(1.5) * (R::literal(0.032_063_452_962_957_98) * (motor_i_rx
            * motor_i_rx).add_product(motor_i_ry, motor_i_ry))
            .add_product(R::literal(0.042_795_676_8), (motor_i_sx * motor_i_sx)
            .add_product(motor_i_sy, motor_i_sy)),
    }
}

/// Normalized Taylor coefficients of the solution through `state`, order after order.
///
/// `_k` marks the coefficient of order k, `_before` that of order k - 1; bare names are
/// zeroth coefficients. The workspace is as `series_workspace` says.
///
/// 41 recurrences. 4 sums of products an order.
///
/// # Panics
/// If there is no room for the zeroth coefficients, or the workspace is too short.
pub fn series<R: Real>(_time: R, state: &[R; STATES], _p: &Parameters<R>,
        coefficients: &mut [[R; STATES]], workspace: &mut [R]) {
    let (mut lanes, _) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let [motor_omega, motor_psi_sx, motor_psi_sy, motor_psi_rx, motor_psi_ry] = *state;
    let t0 = motor_omega * R::literal(4.0);
    let motor_slip_speed = R::literal(314.159_265_358_979_3) - t0;
    let t1 = motor_psi_rx * R::literal(0.952);
    let t2 = motor_psi_sx - t1;
    let t3 = motor_psi_ry * R::literal(0.952);
    let t4 = motor_psi_sy - t3;
    let t5 = motor_psi_sx * R::literal(0.956);
    let t6 = motor_psi_sy * R::literal(0.956);
    let t7 = motor_psi_sx * motor_psi_ry;
    let t8 = motor_psi_sy * motor_psi_rx;
    let t9 = t8 - t7;
    let motor_omega_dot = t9 * R::literal(1_148.118_519_816_103_6);
    let t10 = t2 * R::literal(36.128_315_516_282_626);
    let t11 = motor_psi_sy * R::literal(314.159_265_358_979_3);
    let t12 = R::literal(311.126_983_722_080_9) + t11;
    let motor_psi_sx_dot = t12 - t10;
    let t13 = t4 * R::literal(36.128_315_516_282_626);
    let t14 = motor_psi_sx * R::literal(-314.159_265_358_979_3);
    let motor_psi_sy_dot = t14 - t13;
    let t15 = t5 - motor_psi_rx;
    let t16 = t15 * R::literal(26.954_864_967_800_425);
    let t17 = motor_psi_ry * motor_slip_speed;
    let motor_psi_rx_dot = t16 + t17;
    let t18 = motor_psi_rx * motor_slip_speed;
    let t19 = t6 - motor_psi_ry;
    let t20 = t19 * R::literal(26.954_864_967_800_425);
    let motor_psi_ry_dot = t20 - t18;
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
        let motor_slip_speed_k = -motor_omega_k * R::literal(4.0);
        let t2_k = (-motor_psi_rx_k).mul_add(R::literal(0.952), motor_psi_sx_k);
        let t4_k = (-motor_psi_ry_k).mul_add(R::literal(0.952), motor_psi_sy_k);
        let t7_k = motor_psi_sx.mul_add(motor_psi_ry_k, motor_psi_ry.mul_add(motor_psi_sx_k,
            sums[0]));
        let t8_k = motor_psi_sy.mul_add(motor_psi_rx_k, motor_psi_rx.mul_add(motor_psi_sy_k,
            sums[1]));
        let t9_k = t8_k - t7_k;
        let motor_omega_dot_k = t9_k * R::literal(1_148.118_519_816_103_6);
        let motor_psi_sx_dot_k = (-t2_k).mul_add(R::literal(36.128_315_516_282_626), motor_psi_sy_k
            * R::literal(314.159_265_358_979_3));
        let motor_psi_sy_dot_k = (-t4_k).mul_add(R::literal(36.128_315_516_282_626), motor_psi_sx_k
            * R::literal(-314.159_265_358_979_3));
        let t15_k = motor_psi_sx_k.mul_add(R::literal(0.956), -motor_psi_rx_k);
        let t17_k = motor_psi_ry.mul_add(motor_slip_speed_k, motor_slip_speed
            .mul_add(motor_psi_ry_k, sums[2]));
        let motor_psi_rx_dot_k = t15_k.mul_add(R::literal(26.954_864_967_800_425), t17_k);
        let t18_k = motor_psi_rx.mul_add(motor_slip_speed_k, motor_slip_speed
            .mul_add(motor_psi_rx_k, sums[3]));
        let t19_k = motor_psi_sy_k.mul_add(R::literal(0.956), -motor_psi_ry_k);
        let motor_psi_ry_dot_k = t19_k.mul_add(R::literal(26.954_864_967_800_425), -t18_k);
        lanes.set(order, [motor_psi_sx_k, motor_psi_rx_k, motor_slip_speed_k, motor_slip_speed_k],
            [motor_psi_ry_k, motor_psi_sy_k, motor_psi_ry_k, motor_psi_rx_k]);
        rates = [motor_omega_dot_k, motor_psi_sx_dot_k, motor_psi_sy_dot_k, motor_psi_rx_dot_k,
            motor_psi_ry_dot_k];
    }
}

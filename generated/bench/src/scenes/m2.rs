// Emitted by Machinist 0.1.0; do not edit. To make it again:
//
//     cargo run --release -- gen
//
// Sources, with SHA-256:
//   b2e8612655f0632c22be42bcacd70351e5fa156466e31dc447a6b57931e82702  bench/m2.toml
//   03bebde2dcd618fcbd0662a0f5e63f806e09d154c0fc25f1f0527c30944dd55e  units/textile/induction_motor.toml
//   512419e5aa73ad1710ef3556037050e97b898e87a7d5d8a4e9c4b03a7a8b0141  units/coupling.toml
//   ba9b76a100d91a8597c44349f557e301fa971bdcc9a7e0cf5da5ce4fd6af94b2  units/rotor.toml
//   02dd59962bd405d6a2dcac78b4101ca2138de7a376566a8d8c4460eb40293556  units/textile/technological_load.toml
//
// Benchmark M2: saw gin
//
// The saw gin from rest, loaded at 1.2 s. Only the stiffness of the coupling is tunable, for sweeps.
//
// Source:
//   Benchmark models of textile-machine dynamics.
//
// All quantities are in SI units.
// Shapes: coordinates 2, first-order states 4, states 8, parameters 1, outputs 8, saturations 1.
// Nonzeros: mass_matrix 2 of 2 by 2, rate_jacobian 27 of 8 by 8, parameter_jacobian 2 of 8 by 1.
// Operations: rate 50, forcing 23, rate_jacobian 29, parameter_jacobian 2, time_derivative 24,
//     outputs 1, energy 28, power_balance 108, saturating_arguments 1, prepare 2, prepared_rate 50,
//     prepared_rate_jacobian 27, prepared_jacobians 29.

use ::machinist_contract::{
    Energy, PowerBalance, Real, taylor::{Lanes, order_and_inverse},
};

::machinist_contract::simulator! {
    /// Benchmark M2: saw gin
    ///
    /// The saw gin from rest, loaded at 1.2 s. Only the stiffness of the coupling is tunable, for sweeps.
    ///
    /// Source: Benchmark models of textile-machine dynamics.
    M2: "m2", "Benchmark M2: saw gin";
    run from 0.0, until 2.0, points 501, rtol 1e-8, method "auto";
    quadratures 1, discontinuities 0;
    coordinates; prepared; jacobians_at_once; saturations 1; series 9;
}

::machinist_contract::parameters! {
    coupling_stiffness: 23065.2, "N m/rad", "coupling.stiffness", "torsional stiffness";
}

::machinist_contract::outputs! {
    psi_x1: "V s", "psi_x1", "stator flux linkage along x";
    psi_y1: "V s", "psi_y1", "stator flux linkage along y";
    psi_x2: "V s", "psi_x2", "rotor flux linkage along x";
    psi_y2: "V s", "psi_y2", "rotor flux linkage along y";
    phi_d: "rad", "phi_d", "rotor angle";
    w_d: "rad/s", "w_d", "rate of rotor angle";
    phi_2: "rad", "phi_2", "angle";
    w_2: "rad/s", "w_2", "rate of angle";
}

::machinist_contract::states! {
    COUPLING_TWIST: position, 1.0, "rad", "coupling.twist", "twist";
    MOTOR_OMEGA: velocity, 78.5, "rad/s", "motor.omega", "rate of rotor angle";
    CYLINDER_OMEGA: velocity, 78.5, "rad/s", "cylinder.omega", "rate of angle";
    MOTOR_PSI_SX: first_order, 1.0, "V s", "motor.psi_sx", "stator flux linkage along x";
    MOTOR_PSI_SY: first_order, 1.0, "V s", "motor.psi_sy", "stator flux linkage along y";
    MOTOR_PSI_RX: first_order, 1.0, "V s", "motor.psi_rx", "rotor flux linkage along x";
    MOTOR_PSI_RY: first_order, 1.0, "V s", "motor.psi_ry", "rotor flux linkage along y";
    CYLINDER_PHI: position, 150.0, "rad", "cylinder.phi", "angle";
}

::machinist_contract::coordinates! {
    "motor.phi", "rad", "rotor angle";
    "cylinder.phi", "rad", "angle";
}

::machinist_contract::patterns! {
    /// Nonzeros of M.
    MASS_MATRIX_PATTERN: 2 by 2 { 0 [0] 1 [1] }
    /// Nonzeros of dy'/dy.
    RATE_JACOBIAN_PATTERN: 8 by 8 { 0 [1 2] 1 [0 1 2 3 4 5 6] 2 [0 1 2] 3 [3 4 5] 4 [3 4 6]
        5 [1 3 5 6] 6 [1 4 5 6] 7 [2] }
    /// Nonzeros of dy'/dp.
    PARAMETER_JACOBIAN_PATTERN: 8 by 1 { 1 [0] 2 [0] }
}

::machinist_contract::constants! {
    cylinder_omega_dot_by_coupling_twist, motor_omega_dot_by_coupling_twist
}

/// Returns the constants of `rate` and its Jacobians from the parameters. 2 operations.
#[must_use]
#[inline]
pub fn prepare<R: Real>(p: &Parameters<R>) -> Constants<R> {
    let cylinder_omega_dot_by_coupling_twist = p.coupling_stiffness
        * R::literal(0.803_858_520_900_321_5);
    let motor_omega_dot_by_coupling_twist = p.coupling_stiffness
        * R::literal(-0.238_095_238_095_238_08);
    Constants { cylinder_omega_dot_by_coupling_twist, motor_omega_dot_by_coupling_twist }
}

/// State at the start of the run, in the units of the states. No operations.
#[must_use]
pub fn initial_state<R: Real>(_p: &Parameters<R>) -> [R; STATES] {
    [R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0),
        R::literal(0.0), R::literal(0.0), R::literal(0.0)]
}

/// Times of known jumps of the right-hand side \[s\], unsorted. No operations.
#[must_use]
pub fn discontinuities<R: Real>(_p: &Parameters<R>) -> [R; DISCONTINUITIES] {
    []
}

/// As `rate`, with the constants of the parameters from `prepare`. 50 operations.
#[must_use]
#[inline]
pub fn prepared_rate<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>,
        _c: &Constants<R>) -> [R; STATES] {
    let [coupling_twist, motor_omega, cylinder_omega, motor_psi_sx, motor_psi_sy, motor_psi_rx,
        motor_psi_ry, ..] = *state;
    let coupling_twist_rate = motor_omega - cylinder_omega;
    let motor_slip_speed = R::literal(314.159_265_358_979_3).sub_product(R::literal(4.0),
        motor_omega);
    let motor_i_sx = R::literal(844.204_793_982_429_1) * motor_psi_sx
        .sub_product(R::literal(0.952), motor_psi_rx);
    let motor_i_sy = R::literal(844.204_793_982_429_1) * motor_psi_sy
        .sub_product(R::literal(0.952), motor_psi_ry);
    let load_engagement = R::literal(1.0) / (R::literal(1.0) + (R::literal(-50.0)
        * (time - R::literal(1.2))).exp());
    let motor_torque = R::literal(4_822.097_783_227_635) * (motor_psi_sy * motor_psi_rx)
        .sub_product(motor_psi_sx, motor_psi_ry);
    let coupling_torque = (p.coupling_stiffness * coupling_twist).add_product(R::literal(128.5346),
        coupling_twist_rate);
    let load_resistance = load_engagement * R::literal(843.72).add_product(R::literal(78.78),
        (R::literal(241.805_307_826_689_27) * time).sin()) * (R::literal(2.0) * cylinder_omega)
        .tanh();
    let cylinder_omega_dot = (coupling_torque - load_resistance)
        * R::literal(0.803_858_520_900_321_5);
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
    [coupling_twist_rate, motor_omega_dot, cylinder_omega_dot, motor_psi_sx_dot, motor_psi_sy_dot,
        motor_psi_rx_dot, motor_psi_ry_dot, cylinder_omega]
}

/// `M = d2L/dq'2`, values in the order of its pattern. No operations.
#[must_use]
pub fn mass_matrix<R: Real>(_time: R, _state: &[R; STATES], _p: &Parameters<R>) -> [R; 2] {
    [R::literal(4.2), R::literal(1.244)]
}

/// `f` of `M q'' = f + G^T lambda`, one for each coordinate. 23 operations.
#[must_use]
pub fn forcing<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>) -> [R; COORDINATES] {
    let [coupling_twist, motor_omega, cylinder_omega, motor_psi_sx, motor_psi_sy, motor_psi_rx,
        motor_psi_ry, ..] = *state;
    let coupling_twist_rate = motor_omega - cylinder_omega;
    let load_engagement = R::literal(1.0) / (R::literal(1.0) + (R::literal(-50.0)
        * (time - R::literal(1.2))).exp());
    let motor_torque = R::literal(4_822.097_783_227_635) * (motor_psi_sy * motor_psi_rx)
        .sub_product(motor_psi_sx, motor_psi_ry);
    let coupling_torque = (p.coupling_stiffness * coupling_twist).add_product(R::literal(128.5346),
        coupling_twist_rate);
    let load_resistance = load_engagement * R::literal(843.72).add_product(R::literal(78.78),
        (R::literal(241.805_307_826_689_27) * time).sin()) * (R::literal(2.0) * cylinder_omega)
        .tanh();
    let motor_phi_forcing = motor_torque - coupling_torque;
    let cylinder_phi_forcing = coupling_torque - load_resistance;
    [motor_phi_forcing, cylinder_phi_forcing]
}

/// As `rate_jacobian`, with the constants of the parameters from `prepare`. 27 operations.
#[must_use]
pub fn prepared_rate_jacobian<R: Real>(time: R, state: &[R; STATES], _p: &Parameters<R>,
        c: &Constants<R>) -> [R; 27] {
    let [_, motor_omega, cylinder_omega, motor_psi_sx, motor_psi_sy, motor_psi_rx, motor_psi_ry,
        ..] = *state;
    let t0 = R::literal(4.0) * motor_omega;
    let motor_slip_speed = R::literal(314.159_265_358_979_3) - t0;
    let load_engagement = R::literal(1.0) / (R::literal(1.0) + (R::literal(-50.0)
        * (time - R::literal(1.2))).exp());
    let t1 = (R::literal(2.0) * cylinder_omega).tanh();
    let motor_psi_rx_dot_by_motor_omega = R::literal(-4.0) * motor_psi_ry;
    let motor_psi_ry_dot_by_motor_omega = R::literal(4.0) * motor_psi_rx;
    let cylinder_omega_dot_by_cylinder_omega = R::literal(-128.5346).sub_product(R::literal(2.0)
        * load_engagement * R::literal(1.0).sub_product(t1, t1), R::literal(843.72)
        .add_product(R::literal(78.78), (R::literal(241.805_307_826_689_27) * time).sin()))
        * R::literal(0.803_858_520_900_321_5);
    let motor_omega_dot_by_motor_psi_sx = R::literal(-1_148.118_519_816_103_6) * motor_psi_ry;
    let motor_omega_dot_by_motor_psi_sy = R::literal(1_148.118_519_816_103_6) * motor_psi_rx;
    let motor_omega_dot_by_motor_psi_rx = R::literal(1_148.118_519_816_103_6) * motor_psi_sy;
    let motor_psi_ry_dot_by_motor_psi_rx = t0 - R::literal(314.159_265_358_979_3);
    let motor_omega_dot_by_motor_psi_ry = R::literal(-1_148.118_519_816_103_6) * motor_psi_sx;
    [R::literal(1.0), R::literal(-1.0), c.motor_omega_dot_by_coupling_twist,
        R::literal(-30.603_476_190_476_19), R::literal(30.603_476_190_476_19),
        motor_omega_dot_by_motor_psi_sx, motor_omega_dot_by_motor_psi_sy,
        motor_omega_dot_by_motor_psi_rx, motor_omega_dot_by_motor_psi_ry,
        c.cylinder_omega_dot_by_coupling_twist, R::literal(103.323_633_440_514_47),
        cylinder_omega_dot_by_cylinder_omega, R::literal(-36.128_315_516_282_62),
        R::literal(314.159_265_358_979_3), R::literal(34.394_156_371_501_055),
        R::literal(-314.159_265_358_979_3), R::literal(-36.128_315_516_282_62),
        R::literal(34.394_156_371_501_055), motor_psi_rx_dot_by_motor_omega,
        R::literal(25.768_850_909_217_203), R::literal(-26.954_864_967_800_425), motor_slip_speed,
        motor_psi_ry_dot_by_motor_omega, R::literal(25.768_850_909_217_203),
        motor_psi_ry_dot_by_motor_psi_rx, R::literal(-26.954_864_967_800_425), R::literal(1.0)]
}

/// `rate_jacobian`, then `parameter_jacobian`, with the constants of the parameters from `prepare`.
/// 29 operations.
#[must_use]
pub fn prepared_jacobians<R: Real>(time: R, state: &[R; STATES], _p: &Parameters<R>,
        c: &Constants<R>) -> [R; 29] {
    let [coupling_twist, motor_omega, cylinder_omega, motor_psi_sx, motor_psi_sy, motor_psi_rx,
        motor_psi_ry, ..] = *state;
    let t0 = R::literal(4.0) * motor_omega;
    let motor_slip_speed = R::literal(314.159_265_358_979_3) - t0;
    let load_engagement = R::literal(1.0) / (R::literal(1.0) + (R::literal(-50.0)
        * (time - R::literal(1.2))).exp());
    let t1 = (R::literal(2.0) * cylinder_omega).tanh();
    let motor_psi_rx_dot_by_motor_omega = R::literal(-4.0) * motor_psi_ry;
    let motor_psi_ry_dot_by_motor_omega = R::literal(4.0) * motor_psi_rx;
    let cylinder_omega_dot_by_cylinder_omega = R::literal(-128.5346).sub_product(R::literal(2.0)
        * load_engagement * R::literal(1.0).sub_product(t1, t1), R::literal(843.72)
        .add_product(R::literal(78.78), (R::literal(241.805_307_826_689_27) * time).sin()))
        * R::literal(0.803_858_520_900_321_5);
    let motor_omega_dot_by_motor_psi_sx = R::literal(-1_148.118_519_816_103_6) * motor_psi_ry;
    let motor_omega_dot_by_motor_psi_sy = R::literal(1_148.118_519_816_103_6) * motor_psi_rx;
    let motor_omega_dot_by_motor_psi_rx = R::literal(1_148.118_519_816_103_6) * motor_psi_sy;
    let motor_psi_ry_dot_by_motor_psi_rx = t0 - R::literal(314.159_265_358_979_3);
    let motor_omega_dot_by_motor_psi_ry = R::literal(-1_148.118_519_816_103_6) * motor_psi_sx;
    let cylinder_omega_dot_by_coupling_stiffness = coupling_twist
        * R::literal(0.803_858_520_900_321_5);
    let motor_omega_dot_by_coupling_stiffness = coupling_twist
        * R::literal(-0.238_095_238_095_238_08);
    [R::literal(1.0), R::literal(-1.0), c.motor_omega_dot_by_coupling_twist,
        R::literal(-30.603_476_190_476_19), R::literal(30.603_476_190_476_19),
        motor_omega_dot_by_motor_psi_sx, motor_omega_dot_by_motor_psi_sy,
        motor_omega_dot_by_motor_psi_rx, motor_omega_dot_by_motor_psi_ry,
        c.cylinder_omega_dot_by_coupling_twist, R::literal(103.323_633_440_514_47),
        cylinder_omega_dot_by_cylinder_omega, R::literal(-36.128_315_516_282_62),
        R::literal(314.159_265_358_979_3), R::literal(34.394_156_371_501_055),
        R::literal(-314.159_265_358_979_3), R::literal(-36.128_315_516_282_62),
        R::literal(34.394_156_371_501_055), motor_psi_rx_dot_by_motor_omega,
        R::literal(25.768_850_909_217_203), R::literal(-26.954_864_967_800_425), motor_slip_speed,
        motor_psi_ry_dot_by_motor_omega, R::literal(25.768_850_909_217_203),
        motor_psi_ry_dot_by_motor_psi_rx, R::literal(-26.954_864_967_800_425), R::literal(1.0),
        motor_omega_dot_by_coupling_stiffness, cylinder_omega_dot_by_coupling_stiffness]
}

/// Partial derivative of `y'` with respect to time. 24 operations.
#[must_use]
pub fn time_derivative<R: Real>(time: R, state: &[R; STATES], _p: &Parameters<R>) -> [R; STATES] {
    let [_, _, cylinder_omega, ..] = *state;
    let t0 = R::literal(241.805_307_826_689_27) * time;
    let (t1, t2) = t0.sin_cos();
    let t3 = R::literal(50.0) * (time - R::literal(1.2));
    let t4 = R::literal(1.0) + (-t3).exp();
    let load_engagement = R::literal(1.0) / t4;
    let t5 = (R::literal(2.0) * cylinder_omega).tanh();
    let cylinder_omega_dot_by_time = (-(R::literal(50.0) * R::literal(843.72)
        .add_product(R::literal(78.78), t1) * t5 / (t4 * (R::literal(1.0) + t3.exp()))))
        .add_product(R::literal(-19_049.422_150_586_58) * load_engagement * t2, t5)
        * R::literal(0.803_858_520_900_321_5);
    [R::literal(0.0), R::literal(0.0), cylinder_omega_dot_by_time, R::literal(0.0),
        R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0)]
}

/// Wanted outputs. 1 operation.
#[must_use]
pub fn outputs<R: Real>(_time: R, state: &[R; STATES], _p: &Parameters<R>) -> Outputs<R> {
    let [coupling_twist, motor_omega, cylinder_omega, motor_psi_sx, motor_psi_sy, motor_psi_rx,
        motor_psi_ry, cylinder_phi] = *state;
    Outputs {
        psi_x1: motor_psi_sx,
        psi_y1: motor_psi_sy,
        psi_x2: motor_psi_rx,
        psi_y2: motor_psi_ry,
        phi_d: coupling_twist + cylinder_phi,
        w_d: motor_omega,
        phi_2: cylinder_phi,
        w_2: cylinder_omega,
    }
}

/// T, V and the energy of first-order states \[J\]. 28 operations.
#[must_use]
pub fn energy<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>) -> Energy<R> {
    let [coupling_twist, motor_omega, cylinder_omega, motor_psi_sx, motor_psi_sy, motor_psi_rx,
        motor_psi_ry, ..] = *state;
    let motor_i_sx = R::literal(844.204_793_982_429_1) * motor_psi_sx
        .sub_product(R::literal(0.952), motor_psi_rx);
    let motor_i_sy = R::literal(844.204_793_982_429_1) * motor_psi_sy
        .sub_product(R::literal(0.952), motor_psi_ry);
    let motor_i_rx = R::literal(840.672_556_350_703_5) * motor_psi_rx
        .sub_product(R::literal(0.956), motor_psi_sx);
    let motor_i_ry = R::literal(840.672_556_350_703_5) * motor_psi_ry
        .sub_product(R::literal(0.956), motor_psi_sy);
    Energy {
        kinetic: (R::literal(0.622) * (cylinder_omega * cylinder_omega))
            .add_product(R::literal(2.1), motor_omega * motor_omega),
        potential: R::literal(0.5) * p.coupling_stiffness * (coupling_twist * coupling_twist),
        stored: R::literal(0.75) * (motor_psi_sx * motor_i_sx).add_product(motor_psi_sy, motor_i_sy)
            .add_product(motor_psi_rx, motor_i_rx).add_product(motor_psi_ry, motor_i_ry),
    }
}

/// `dE/dt`, power supplied and power dissipated \[W\]. 108 operations.
#[must_use]
pub fn power_balance<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>) -> PowerBalance<R> {
    let [coupling_twist, motor_omega, cylinder_omega, motor_psi_sx, motor_psi_sy, motor_psi_rx,
        motor_psi_ry, ..] = *state;
    let coupling_twist_rate = motor_omega - cylinder_omega;
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
    let load_engagement = R::literal(1.0) / (R::literal(1.0) + (R::literal(-50.0)
        * (time - R::literal(1.2))).exp());
    let motor_torque = R::literal(4_822.097_783_227_635) * (motor_psi_sy * motor_psi_rx)
        .sub_product(motor_psi_sx, motor_psi_ry);
    let t2 = p.coupling_stiffness * coupling_twist;
    let coupling_torque = t2.add_product(R::literal(128.5346), coupling_twist_rate);
    let load_resistance = load_engagement * R::literal(843.72).add_product(R::literal(78.78),
        (R::literal(241.805_307_826_689_27) * time).sin()) * (R::literal(2.0) * cylinder_omega)
        .tanh();
    let cylinder_omega_dot = (coupling_torque - load_resistance)
        * R::literal(0.803_858_520_900_321_5);
    let motor_omega_dot = (motor_torque - coupling_torque) * R::literal(0.238_095_238_095_238_08);
    let motor_psi_sx_dot = R::literal(311.126_983_722_080_9)
        .add_product(R::literal(314.159_265_358_979_3), motor_psi_sy)
        .sub_product(R::literal(0.042_795_676_8), motor_i_sx);
    let motor_psi_rx_dot = (R::literal(26.954_864_967_800_425) * (t0 - motor_psi_rx))
        .add_product(motor_psi_ry, motor_slip_speed);
    let motor_psi_ry_dot = (R::literal(26.954_864_967_800_425) * (t1 - motor_psi_ry))
        .sub_product(motor_psi_rx, motor_slip_speed);
    PowerBalance {
        stored_rate: (t2 * coupling_twist_rate).add_product(R::literal(4.2) * motor_omega,
            motor_omega_dot).add_product(R::literal(1.244) * cylinder_omega, cylinder_omega_dot)
            .add_product(R::literal(0.75) * motor_i_sx
            .add_product(R::literal(844.204_793_982_429_1), motor_psi_sx)
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
        supplied: (R::literal(466.690_475_583_121_4) * motor_i_sx).sub_product(cylinder_omega,
            load_resistance),
        dissipated: (R::literal(128.5346) * motor_omega * coupling_twist_rate)
            .add_product(R::literal(1.5), (R::literal(0.032_063_452_962_957_98) * (motor_i_rx
            * motor_i_rx).add_product(motor_i_ry, motor_i_ry))
            .add_product(R::literal(0.042_795_676_8), (motor_i_sx * motor_i_sx)
            .add_product(motor_i_sy, motor_i_sy))).sub_product(R::literal(128.5346)
            * cylinder_omega, coupling_twist_rate),
    }
}

/// Arguments of functions that are flat far from a place, such as `tanh` far from zero. Steps by
/// series are checked where one passes zero or turns. 1 operation.
#[must_use]
pub fn saturating_arguments<R: Real>(_time: R, state: &[R; STATES],
        _p: &Parameters<R>) -> [R; SATURATIONS] {
    let [_, _, cylinder_omega, ..] = *state;
    let argument_1 = R::literal(2.0) * cylinder_omega;
    [argument_1]
}

/// Normalized Taylor coefficients of the solution through `state`, order after order.
///
/// `_k` marks the coefficient of order k, `_before` that of order k - 1; bare names are
/// zeroth coefficients. The workspace is as `series_workspace` says.
///
/// 79 recurrences. 9 sums of products an order.
///
/// # Panics
/// If there is no room for the zeroth coefficients, or the workspace is too short.
pub fn series<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>,
        coefficients: &mut [[R; STATES]], workspace: &mut [R]) {
    let (mut lanes, workspace) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let (mut lanes_1, workspace) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let (mut lanes_2, _) = Lanes::<R, 1>::new(workspace, coefficients.len());
    let [coupling_twist, motor_omega, cylinder_omega, motor_psi_sx, motor_psi_sy, motor_psi_rx,
        motor_psi_ry, ..] = *state;
    let coupling_twist_rate = motor_omega - cylinder_omega;
    let t0 = motor_omega * R::literal(4.0);
    let motor_slip_speed = R::literal(314.159_265_358_979_3) - t0;
    let t1 = motor_psi_rx * R::literal(0.952);
    let t2 = motor_psi_sx - t1;
    let t3 = motor_psi_ry * R::literal(0.952);
    let t4 = motor_psi_sy - t3;
    let t5 = motor_psi_sx * R::literal(0.956);
    let t6 = motor_psi_sy * R::literal(0.956);
    let t7 = time - R::literal(1.2);
    let t8 = t7 * R::literal(-50.0);
    let t9 = t8.exp();
    let t10 = R::literal(1.0) + t9;
    let load_engagement = R::literal(1.0) / t10;
    let t11 = motor_psi_sx * motor_psi_ry;
    let t12 = motor_psi_sy * motor_psi_rx;
    let t13 = t12 - t11;
    let motor_torque = t13 * R::literal(4_822.097_783_227_635);
    let t14 = coupling_twist_rate * R::literal(128.5346);
    let t15 = coupling_twist * p.coupling_stiffness;
    let coupling_torque = t14 + t15;
    let t16 = time * R::literal(241.805_307_826_689_27);
    let t17 = t16.sin();
    let t18 = t16.cos();
    let t19 = t17 * R::literal(78.78);
    let t20 = R::literal(843.72) + t19;
    let t21 = cylinder_omega * R::literal(2.0);
    let t22 = t21.tanh();
    let t23 = t22 * t22;
    let t24 = R::literal(1.0) - t23;
    let t25 = load_engagement * t20;
    let load_resistance = t25 * t22;
    let t26 = motor_torque - coupling_torque;
    let t27 = coupling_torque - load_resistance;
    let cylinder_omega_dot = t27 * R::literal(0.803_858_520_900_321_5);
    let motor_omega_dot = t26 * R::literal(0.238_095_238_095_238_08);
    let t28 = t2 * R::literal(36.128_315_516_282_626);
    let t29 = motor_psi_sy * R::literal(314.159_265_358_979_3);
    let t30 = R::literal(311.126_983_722_080_9) + t29;
    let motor_psi_sx_dot = t30 - t28;
    let t31 = t4 * R::literal(36.128_315_516_282_626);
    let t32 = motor_psi_sx * R::literal(-314.159_265_358_979_3);
    let motor_psi_sy_dot = t32 - t31;
    let t33 = t5 - motor_psi_rx;
    let t34 = t33 * R::literal(26.954_864_967_800_425);
    let t35 = motor_psi_ry * motor_slip_speed;
    let motor_psi_rx_dot = t34 + t35;
    let t36 = motor_psi_rx * motor_slip_speed;
    let t37 = t6 - motor_psi_ry;
    let t38 = t37 * R::literal(26.954_864_967_800_425);
    let motor_psi_ry_dot = t38 - t36;
    let t8_slope = R::literal(1.0) * R::literal(-50.0);
    let inverse_t10 = R::literal(1.0) / t10;
    let mut t9_before = t9;
    let mut t17_before = t17;
    let mut t18_before = t18;
    let mut rates = [coupling_twist_rate, motor_omega_dot, cylinder_omega_dot, motor_psi_sx_dot,
        motor_psi_sy_dot, motor_psi_rx_dot, motor_psi_ry_dot, cylinder_omega];
    coefficients[0] = *state;
    let highest = coefficients.len() - 1;
    for (order, state_k) in coefficients.iter_mut().enumerate().skip(1) {
        let (k, inverse) = order_and_inverse::<R>(order);
        *state_k = rates.map(|rate| rate * inverse);
        if order == highest {
            break;
        }
        let [coupling_twist_k, motor_omega_k, cylinder_omega_k, motor_psi_sx_k, motor_psi_sy_k,
            motor_psi_rx_k, motor_psi_ry_k, ..] = *state_k;
        let sums = lanes.sums(order);
        let sums_1 = lanes_1.sums(order);
        let sums_2 = lanes_2.sums(order);
        let coupling_twist_rate_k = motor_omega_k - cylinder_omega_k;
        let motor_slip_speed_k = -motor_omega_k * R::literal(4.0);
        let t2_k = (-motor_psi_rx_k).mul_add(R::literal(0.952), motor_psi_sx_k);
        let t4_k = (-motor_psi_ry_k).mul_add(R::literal(0.952), motor_psi_sy_k);
        let t9_k = inverse * t8_slope * t9_before;
        let load_engagement_k = -t9_k.mul_add(load_engagement, sums_1[1]) * inverse_t10;
        let t11_k = motor_psi_sx.mul_add(motor_psi_ry_k, motor_psi_ry.mul_add(motor_psi_sx_k,
            sums[0]));
        let t12_k = motor_psi_sy.mul_add(motor_psi_rx_k, motor_psi_rx.mul_add(motor_psi_sy_k,
            sums[1]));
        let t13_k = t12_k - t11_k;
        let coupling_torque_k = coupling_twist_k.mul_add(p.coupling_stiffness,
            coupling_twist_rate_k * R::literal(128.5346));
        let t17_k = inverse * R::literal(241.805_307_826_689_27) * t18_before;
        let t18_k = -inverse * R::literal(241.805_307_826_689_27) * t17_before;
        let t21_k = cylinder_omega_k * R::literal(2.0);
        let t22_k = t21_k.mul_add(t24, inverse * sums_1[3]);
        let t23_k = (t22 + t22).mul_add(t22_k, sums[2]);
        let t24_k = -t23_k;
        let t25_k = load_engagement.mul_add(t17_k * R::literal(78.78), t20
            .mul_add(load_engagement_k, sums_1[2]));
        let load_resistance_k = t22.mul_add(t25_k, t25.mul_add(t22_k, sums_2[0]));
        let t26_k = t13_k.mul_add(R::literal(4_822.097_783_227_635), -coupling_torque_k);
        let t27_k = coupling_torque_k - load_resistance_k;
        let cylinder_omega_dot_k = t27_k * R::literal(0.803_858_520_900_321_5);
        let motor_omega_dot_k = t26_k * R::literal(0.238_095_238_095_238_08);
        let motor_psi_sx_dot_k = (-t2_k).mul_add(R::literal(36.128_315_516_282_626), motor_psi_sy_k
            * R::literal(314.159_265_358_979_3));
        let motor_psi_sy_dot_k = (-t4_k).mul_add(R::literal(36.128_315_516_282_626), motor_psi_sx_k
            * R::literal(-314.159_265_358_979_3));
        let t33_k = motor_psi_sx_k.mul_add(R::literal(0.956), -motor_psi_rx_k);
        let t35_k = motor_psi_ry.mul_add(motor_slip_speed_k, motor_slip_speed
            .mul_add(motor_psi_ry_k, sums[3]));
        let motor_psi_rx_dot_k = t33_k.mul_add(R::literal(26.954_864_967_800_425), t35_k);
        let t36_k = motor_psi_rx.mul_add(motor_slip_speed_k, motor_slip_speed
            .mul_add(motor_psi_rx_k, sums_1[0]));
        let t37_k = motor_psi_sy_k.mul_add(R::literal(0.956), -motor_psi_ry_k);
        let motor_psi_ry_dot_k = t37_k.mul_add(R::literal(26.954_864_967_800_425), -t36_k);
        lanes.set(order, [motor_psi_sx_k, motor_psi_rx_k, t22_k, motor_slip_speed_k],
            [motor_psi_ry_k, motor_psi_sy_k, t22_k, motor_psi_ry_k]);
        lanes_1.set(order, [motor_slip_speed_k, t9_k, load_engagement_k, k * t21_k],
            [motor_psi_rx_k, load_engagement_k, t17_k * R::literal(78.78), t24_k]);
        lanes_2.set(order, [t22_k], [t25_k]);
        t9_before = t9_k;
        t17_before = t17_k;
        t18_before = t18_k;
        rates = [coupling_twist_rate_k, motor_omega_dot_k, cylinder_omega_dot_k,
            motor_psi_sx_dot_k, motor_psi_sy_dot_k, motor_psi_rx_dot_k, motor_psi_ry_dot_k,
            cylinder_omega_k];
    }
}

// Emitted by Machinist 0.1.0; do not edit. To make it again:
//
//     cargo run --release -- gen
//
// Sources, with SHA-256:
//   7080edd56360efaf8d3abfdac2138e8621c4c1d071cf151752cc1a0ba69e94e4  bench/m3_10.toml
//   fe2f2deb5f36655ff87e1d6f2bb763716b1c76007878e37e8e41643655074862  units/induction_motor.toml
//   a479b553f0542fe4aecc9e2a030097bc5b34e101f44a5e7297713fb52484327b  units/coupling.toml
//   192155c0a8dc7b884c45e939d6fe1b122b135258825141b94f360d68f1612fb5  units/rotor.toml
//   c25829d257d53d2e48562bcbdac2bfe42940eb3fdb1c5913863f1432683f6420  units/technological_load.toml
//
// Benchmark M3: motor and torsional shaft of 10 pieces
//
// A motor at synchronous speed drives a shaft of 10 pieces by the coupling of the saw
// gin. A load spread over the shaft engages at 0.15 s.
//
// Source:
//   Benchmark models of textile-machine dynamics.
//
// Shapes; all quantities are in SI units:
//   coordinates              11
//   first-order states        4
//   states                   26
//   parameters                0
//   outputs                  26
//   discontinuities           0
//
// State:
//     0  motor.phi_relative    [rad]    rotor angle, relative
//     1  piece_1.phi_relative  [rad]    angle, relative
//     2  piece_2.phi_relative  [rad]    angle, relative
//     3  piece_3.phi_relative  [rad]    angle, relative
//     4  piece_4.phi_relative  [rad]    angle, relative
//     5  piece_5.phi_relative  [rad]    angle, relative
//     6  piece_6.phi_relative  [rad]    angle, relative
//     7  piece_7.phi_relative  [rad]    angle, relative
//     8  piece_8.phi_relative  [rad]    angle, relative
//     9  piece_9.phi_relative  [rad]    angle, relative
//    10  motor.omega           [rad/s]  rate of rotor angle
//    11  piece_1.omega         [rad/s]  rate of angle
//    12  piece_2.omega         [rad/s]  rate of angle
//    13  piece_3.omega         [rad/s]  rate of angle
//    14  piece_4.omega         [rad/s]  rate of angle
//    15  piece_5.omega         [rad/s]  rate of angle
//    16  piece_6.omega         [rad/s]  rate of angle
//    17  piece_7.omega         [rad/s]  rate of angle
//    18  piece_8.omega         [rad/s]  rate of angle
//    19  piece_9.omega         [rad/s]  rate of angle
//    20  piece_10.omega        [rad/s]  rate of angle
//    21  motor.psi_sx          [V s]    stator flux linkage along x
//    22  motor.psi_sy          [V s]    stator flux linkage along y
//    23  motor.psi_rx          [V s]    rotor flux linkage along x
//    24  motor.psi_ry          [V s]    rotor flux linkage along y
//    25  piece_10.phi          [rad]    angle
//
// Nonzeros:
//   mass_matrix              11 of 11 by 11
//   rate_jacobian            99 of 26 by 26
//   parameter_jacobian        0 of 26 by 0
//
// Operations:
//   initial_state             0
//   discontinuities           0
//   rate                    179
//   mass_matrix               0
//   forcing                 133
//   rate_jacobian           103
//   parameter_jacobian        0
//   time_derivative          96
//   outputs                  10
//   energy                   90
//   power_balance           318

use ::machinist_contract::{
    Describe, Energy, PowerBalance, Quantity, Real, RunDefaults, Shape, Simulator,
    SparsityPattern, StateKind, taylor::{Bends, Lanes, TaylorSeries, order_and_inverse},
};

/// Generalized coordinates, n.
pub const COORDINATES: usize = 11;

/// Length of the state y.
pub const STATES: usize = 26;

/// Parameters.
pub const PARAMETERS: usize = 0;

/// Wanted outputs.
pub const OUTPUTS: usize = 26;

/// Times at which the right-hand side jumps.
pub const DISCONTINUITIES: usize = 0;

/// Nonzeros of M, both triangles.
pub const MASS_MATRIX_PATTERN: SparsityPattern<'static> = SparsityPattern {
    rows: 11,
    columns: 11,
    entries: &[
        (0, 0), (1, 1), (2, 2), (3, 3), (4, 4), (5, 5), (6, 6), (7, 7), (8, 8), (9, 9), (10, 10),
    ],
};

/// Nonzeros of dy'/dy.
pub const RATE_JACOBIAN_PATTERN: SparsityPattern<'static> = SparsityPattern {
    rows: 26,
    columns: 26,
    entries: &[
        (0, 10), (0, 20), (1, 11), (1, 20), (2, 12), (2, 20), (3, 13), (3, 20), (4, 14), (4, 20),
        (5, 15), (5, 20), (6, 16), (6, 20), (7, 17), (7, 20), (8, 18), (8, 20), (9, 19), (9, 20),
        (10, 0), (10, 1), (10, 10), (10, 11), (10, 21), (10, 22), (10, 23), (10, 24), (11, 0),
        (11, 1), (11, 2), (11, 10), (11, 11), (11, 12), (12, 1), (12, 2), (12, 3), (12, 11),
        (12, 12), (12, 13), (13, 2), (13, 3), (13, 4), (13, 12), (13, 13), (13, 14), (14, 3),
        (14, 4), (14, 5), (14, 13), (14, 14), (14, 15), (15, 4), (15, 5), (15, 6), (15, 14),
        (15, 15), (15, 16), (16, 5), (16, 6), (16, 7), (16, 15), (16, 16), (16, 17), (17, 6),
        (17, 7), (17, 8), (17, 16), (17, 17), (17, 18), (18, 7), (18, 8), (18, 9), (18, 17),
        (18, 18), (18, 19), (19, 8), (19, 9), (19, 18), (19, 19), (19, 20), (20, 9), (20, 19),
        (20, 20), (21, 21), (21, 22), (21, 23), (22, 21), (22, 22), (22, 24), (23, 10), (23, 21),
        (23, 23), (23, 24), (24, 10), (24, 22), (24, 23), (24, 24), (25, 20),
    ],
};

/// Nonzeros of dy'/dp.
pub const PARAMETER_JACOBIAN_PATTERN: SparsityPattern<'static> = SparsityPattern {
    rows: 26,
    columns: 0,
    entries: &[],
};

/// Benchmark M3: motor and torsional shaft of 10 pieces
///
/// A motor at synchronous speed drives a shaft of 10 pieces by the coupling of the saw
/// gin. A load spread over the shaft engages at 0.15 s.
///
/// Source: Benchmark models of textile-machine dynamics.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct M310;

/// Parameters, in SI units; the default holds the values of the spec.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Parameters<R> {
    /// Nothing; there are no numbers here.
    pub real: core::marker::PhantomData<R>,
}

impl<R: Real> Parameters<R> {
    /// From the numbers in their order.
    #[must_use]
    #[inline]
    pub fn from_array(_values: [R; PARAMETERS]) -> Self {
        Self {
            real: core::marker::PhantomData,
        }
    }
    /// The numbers in their order.
    #[must_use]
    #[inline]
    pub fn to_array(self) -> [R; PARAMETERS] {
        []
    }
}

impl<R: Real> Default for Parameters<R> {
    fn default() -> Self {
        Self {
            real: core::marker::PhantomData,
        }
    }
}

/// Wanted outputs, in SI units.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Outputs<R> {
    /// psi_x1: stator flux linkage along x \[V s\].
    pub psi_x1: R,
    /// psi_y1: stator flux linkage along y \[V s\].
    pub psi_y1: R,
    /// psi_x2: rotor flux linkage along x \[V s\].
    pub psi_x2: R,
    /// psi_y2: rotor flux linkage along y \[V s\].
    pub psi_y2: R,
    /// phi_d: rotor angle \[rad\].
    pub phi_d: R,
    /// w_d: rate of rotor angle \[rad/s\].
    pub w_d: R,
    /// phi_1: angle \[rad\].
    pub phi_1: R,
    /// w_1: rate of angle \[rad/s\].
    pub w_1: R,
    /// phi_2: angle \[rad\].
    pub phi_2: R,
    /// w_2: rate of angle \[rad/s\].
    pub w_2: R,
    /// phi_3: angle \[rad\].
    pub phi_3: R,
    /// w_3: rate of angle \[rad/s\].
    pub w_3: R,
    /// phi_4: angle \[rad\].
    pub phi_4: R,
    /// w_4: rate of angle \[rad/s\].
    pub w_4: R,
    /// phi_5: angle \[rad\].
    pub phi_5: R,
    /// w_5: rate of angle \[rad/s\].
    pub w_5: R,
    /// phi_6: angle \[rad\].
    pub phi_6: R,
    /// w_6: rate of angle \[rad/s\].
    pub w_6: R,
    /// phi_7: angle \[rad\].
    pub phi_7: R,
    /// w_7: rate of angle \[rad/s\].
    pub w_7: R,
    /// phi_8: angle \[rad\].
    pub phi_8: R,
    /// w_8: rate of angle \[rad/s\].
    pub w_8: R,
    /// phi_9: angle \[rad\].
    pub phi_9: R,
    /// w_9: rate of angle \[rad/s\].
    pub w_9: R,
    /// phi_10: angle \[rad\].
    pub phi_10: R,
    /// w_10: rate of angle \[rad/s\].
    pub w_10: R,
}

impl<R: Real> Outputs<R> {
    /// From the numbers in their order.
    #[must_use]
    #[inline]
    pub fn from_array(values: [R; OUTPUTS]) -> Self {
        Self {
            psi_x1: values[0],
            psi_y1: values[1],
            psi_x2: values[2],
            psi_y2: values[3],
            phi_d: values[4],
            w_d: values[5],
            phi_1: values[6],
            w_1: values[7],
            phi_2: values[8],
            w_2: values[9],
            phi_3: values[10],
            w_3: values[11],
            phi_4: values[12],
            w_4: values[13],
            phi_5: values[14],
            w_5: values[15],
            phi_6: values[16],
            w_6: values[17],
            phi_7: values[18],
            w_7: values[19],
            phi_8: values[20],
            w_8: values[21],
            phi_9: values[22],
            w_9: values[23],
            phi_10: values[24],
            w_10: values[25],
        }
    }
    /// The numbers in their order.
    #[must_use]
    #[inline]
    pub fn to_array(self) -> [R; OUTPUTS] {
        [
            self.psi_x1,
            self.psi_y1,
            self.psi_x2,
            self.psi_y2,
            self.phi_d,
            self.w_d,
            self.phi_1,
            self.w_1,
            self.phi_2,
            self.w_2,
            self.phi_3,
            self.w_3,
            self.phi_4,
            self.w_4,
            self.phi_5,
            self.w_5,
            self.phi_6,
            self.w_6,
            self.phi_7,
            self.w_7,
            self.phi_8,
            self.w_8,
            self.phi_9,
            self.w_9,
            self.phi_10,
            self.w_10,
        ]
    }
}

/// Where to find what in the state.
pub mod state {
    /// motor.phi_relative: rotor angle, relative \[rad\].
    pub const MOTOR_PHI_RELATIVE: usize = 0;
    /// piece_1.phi_relative: angle, relative \[rad\].
    pub const PIECE_1_PHI_RELATIVE: usize = 1;
    /// piece_2.phi_relative: angle, relative \[rad\].
    pub const PIECE_2_PHI_RELATIVE: usize = 2;
    /// piece_3.phi_relative: angle, relative \[rad\].
    pub const PIECE_3_PHI_RELATIVE: usize = 3;
    /// piece_4.phi_relative: angle, relative \[rad\].
    pub const PIECE_4_PHI_RELATIVE: usize = 4;
    /// piece_5.phi_relative: angle, relative \[rad\].
    pub const PIECE_5_PHI_RELATIVE: usize = 5;
    /// piece_6.phi_relative: angle, relative \[rad\].
    pub const PIECE_6_PHI_RELATIVE: usize = 6;
    /// piece_7.phi_relative: angle, relative \[rad\].
    pub const PIECE_7_PHI_RELATIVE: usize = 7;
    /// piece_8.phi_relative: angle, relative \[rad\].
    pub const PIECE_8_PHI_RELATIVE: usize = 8;
    /// piece_9.phi_relative: angle, relative \[rad\].
    pub const PIECE_9_PHI_RELATIVE: usize = 9;
    /// motor.omega: rate of rotor angle \[rad/s\].
    pub const MOTOR_OMEGA: usize = 10;
    /// piece_1.omega: rate of angle \[rad/s\].
    pub const PIECE_1_OMEGA: usize = 11;
    /// piece_2.omega: rate of angle \[rad/s\].
    pub const PIECE_2_OMEGA: usize = 12;
    /// piece_3.omega: rate of angle \[rad/s\].
    pub const PIECE_3_OMEGA: usize = 13;
    /// piece_4.omega: rate of angle \[rad/s\].
    pub const PIECE_4_OMEGA: usize = 14;
    /// piece_5.omega: rate of angle \[rad/s\].
    pub const PIECE_5_OMEGA: usize = 15;
    /// piece_6.omega: rate of angle \[rad/s\].
    pub const PIECE_6_OMEGA: usize = 16;
    /// piece_7.omega: rate of angle \[rad/s\].
    pub const PIECE_7_OMEGA: usize = 17;
    /// piece_8.omega: rate of angle \[rad/s\].
    pub const PIECE_8_OMEGA: usize = 18;
    /// piece_9.omega: rate of angle \[rad/s\].
    pub const PIECE_9_OMEGA: usize = 19;
    /// piece_10.omega: rate of angle \[rad/s\].
    pub const PIECE_10_OMEGA: usize = 20;
    /// motor.psi_sx: stator flux linkage along x \[V s\].
    pub const MOTOR_PSI_SX: usize = 21;
    /// motor.psi_sy: stator flux linkage along y \[V s\].
    pub const MOTOR_PSI_SY: usize = 22;
    /// motor.psi_rx: rotor flux linkage along x \[V s\].
    pub const MOTOR_PSI_RX: usize = 23;
    /// motor.psi_ry: rotor flux linkage along y \[V s\].
    pub const MOTOR_PSI_RY: usize = 24;
    /// piece_10.phi: angle \[rad\].
    pub const PIECE_10_PHI: usize = 25;
}

/// State at the start of the run, in the units of the states.
///
/// No operations.
#[must_use]
pub fn initial_state<R: Real>(_p: &Parameters<R>) -> [R; STATES] {
    [
        R::literal(0.0),
        R::literal(0.0),
        R::literal(0.0),
        R::literal(0.0),
        R::literal(0.0),
        R::literal(0.0),
        R::literal(0.0),
        R::literal(0.0),
        R::literal(0.0),
        R::literal(0.0),
        R::literal(78.539_816_339_744_83),
        R::literal(78.539_816_339_744_83),
        R::literal(78.539_816_339_744_83),
        R::literal(78.539_816_339_744_83),
        R::literal(78.539_816_339_744_83),
        R::literal(78.539_816_339_744_83),
        R::literal(78.539_816_339_744_83),
        R::literal(78.539_816_339_744_83),
        R::literal(78.539_816_339_744_83),
        R::literal(78.539_816_339_744_83),
        R::literal(78.539_816_339_744_83),
        R::literal(0.010_236_251_772_451_205),
        R::literal(-0.990_242_134_409_894_5),
        R::literal(0.009_785_856_694_463_354),
        R::literal(-0.946_671_480_495_859_1),
        R::literal(0.0),
    ]
}

/// Times at which the right-hand side jumps \[s\].
///
/// No operations.
#[must_use]
pub fn discontinuities<R: Real>(_p: &Parameters<R>) -> [R; DISCONTINUITIES] {
    []
}

/// `y'`: velocities, `M^-1 f`, `h`; in the units of the states per second.
///
/// 179 operations.
#[must_use]
#[inline]
pub fn rate<R: Real>(time: R, state: &[R; STATES], _p: &Parameters<R>) -> [R; STATES] {
    let [motor_phi_relative, piece_1_phi_relative, piece_2_phi_relative,
    piece_3_phi_relative, piece_4_phi_relative, piece_5_phi_relative,
    piece_6_phi_relative, piece_7_phi_relative, piece_8_phi_relative,
    piece_9_phi_relative, motor_omega, piece_1_omega, piece_2_omega, piece_3_omega,
    piece_4_omega, piece_5_omega, piece_6_omega, piece_7_omega, piece_8_omega,
    piece_9_omega, piece_10_omega, motor_psi_sx, motor_psi_sy, motor_psi_rx,
    motor_psi_ry, ..] = *state;
    let [t0, t1, t2, t3, t4, t5, t6, t7, t8, t9] = R::tanh_each([
        R::literal(2.0) * piece_1_omega,
        R::literal(2.0) * piece_2_omega,
        R::literal(2.0) * piece_3_omega,
        R::literal(2.0) * piece_4_omega,
        R::literal(2.0) * piece_5_omega,
        R::literal(2.0) * piece_6_omega,
        R::literal(2.0) * piece_7_omega,
        R::literal(2.0) * piece_8_omega,
        R::literal(2.0) * piece_9_omega,
        R::literal(2.0) * piece_10_omega,
    ]);
    let coupling_twist = motor_phi_relative - piece_1_phi_relative;
    let coupling_twist_rate = motor_omega - piece_1_omega;
    let motor_slip_speed = R::literal(314.159_265_358_979_3)
        .sub_product(R::literal(4.0), motor_omega);
    let motor_i_sx = R::literal(844.204_793_982_429_1)
        * motor_psi_sx.sub_product(R::literal(0.952), motor_psi_rx);
    let motor_i_sy = R::literal(844.204_793_982_429_1)
        * motor_psi_sy.sub_product(R::literal(0.952), motor_psi_ry);
    let load_1_engagement = R::literal(1.0)
        / (R::literal(1.0) + (-(R::literal(50.0) * (time - R::literal(0.15)))).exp());
    let motor_torque = R::literal(4_822.097_783_227_635)
        * (motor_psi_sy * motor_psi_rx).sub_product(motor_psi_sx, motor_psi_ry);
    let t10 = R::literal(128.5346) * coupling_twist_rate;
    let t11 = R::literal(23065.2) * coupling_twist;
    let coupling_torque = t10 + t11;
    let t12 = load_1_engagement
        * R::literal(84.372)
            .add_product(
                R::literal(7.878),
                (R::literal(241.805_307_826_689_27) * time).sin(),
            );
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
    let t13 = R::literal(3_382_256.675_279_931)
        * (piece_1_phi_relative - piece_2_phi_relative);
    let t14 = R::literal(67.645_133_505_598_62) * (piece_1_omega - piece_2_omega);
    let t15 = R::literal(3_382_256.675_279_931)
        * (piece_2_phi_relative - piece_3_phi_relative);
    let t16 = R::literal(67.645_133_505_598_62) * (piece_2_omega - piece_3_omega);
    let t17 = R::literal(3_382_256.675_279_931)
        * (piece_3_phi_relative - piece_4_phi_relative);
    let t18 = R::literal(67.645_133_505_598_62) * (piece_3_omega - piece_4_omega);
    let t19 = R::literal(3_382_256.675_279_931)
        * (piece_4_phi_relative - piece_5_phi_relative);
    let t20 = R::literal(67.645_133_505_598_62) * (piece_4_omega - piece_5_omega);
    let t21 = R::literal(3_382_256.675_279_931)
        * (piece_5_phi_relative - piece_6_phi_relative);
    let t22 = R::literal(67.645_133_505_598_62) * (piece_5_omega - piece_6_omega);
    let t23 = R::literal(3_382_256.675_279_931)
        * (piece_6_phi_relative - piece_7_phi_relative);
    let t24 = R::literal(67.645_133_505_598_62) * (piece_6_omega - piece_7_omega);
    let t25 = R::literal(3_382_256.675_279_931)
        * (piece_7_phi_relative - piece_8_phi_relative);
    let t26 = R::literal(67.645_133_505_598_62) * (piece_7_omega - piece_8_omega);
    let t27 = R::literal(3_382_256.675_279_931)
        * (piece_8_phi_relative - piece_9_phi_relative);
    let t28 = R::literal(67.645_133_505_598_62) * (piece_8_omega - piece_9_omega);
    let t29 = R::literal(3_382_256.675_279_931) * piece_9_phi_relative;
    let piece_9_omega_minus_piece_10_omega = piece_9_omega - piece_10_omega;
    let t30 = R::literal(67.645_133_505_598_62) * piece_9_omega_minus_piece_10_omega;
    let piece_10_omega_dot = (t30 + t29 - load_10_resistance)
        * R::literal(8.038_585_209_003_216);
    let piece_9_omega_dot = (-load_9_resistance - (t29 - t27) - (t30 - t28))
        * R::literal(8.038_585_209_003_216);
    let piece_8_omega_dot = (-load_8_resistance - (t27 - t25) - (t28 - t26))
        * R::literal(8.038_585_209_003_216);
    let piece_7_omega_dot = (-load_7_resistance - (t25 - t23) - (t26 - t24))
        * R::literal(8.038_585_209_003_216);
    let piece_6_omega_dot = (-load_6_resistance - (t23 - t21) - (t24 - t22))
        * R::literal(8.038_585_209_003_216);
    let piece_5_omega_dot = (-load_5_resistance - (t21 - t19) - (t22 - t20))
        * R::literal(8.038_585_209_003_216);
    let piece_4_omega_dot = (-load_4_resistance - (t19 - t17) - (t20 - t18))
        * R::literal(8.038_585_209_003_216);
    let piece_3_omega_dot = (-load_3_resistance - (t17 - t15) - (t18 - t16))
        * R::literal(8.038_585_209_003_216);
    let piece_2_omega_dot = (-load_2_resistance - (t15 - t13) - (t16 - t14))
        * R::literal(8.038_585_209_003_216);
    let piece_1_omega_dot = (-load_1_resistance - (t13 - t11) - (t14 - t10))
        * R::literal(8.038_585_209_003_216);
    let motor_omega_dot = (motor_torque - coupling_torque)
        * R::literal(0.238_095_238_095_238_08);
    let motor_psi_sx_dot = R::literal(311.126_983_722_080_9)
        .add_product(R::literal(314.159_265_358_979_3), motor_psi_sy)
        .sub_product(R::literal(0.042_795_676_8), motor_i_sx);
    let motor_psi_sy_dot = (-(R::literal(314.159_265_358_979_3) * motor_psi_sx))
        .sub_product(R::literal(0.042_795_676_8), motor_i_sy);
    let motor_psi_rx_dot = (R::literal(26.954_864_967_800_425)
        * (-motor_psi_rx).add_product(R::literal(0.956), motor_psi_sx))
        .add_product(motor_psi_ry, motor_slip_speed);
    let motor_psi_ry_dot = (R::literal(26.954_864_967_800_425)
        * (-motor_psi_ry).add_product(R::literal(0.956), motor_psi_sy))
        .sub_product(motor_psi_rx, motor_slip_speed);
    let motor_phi_relative_dot = motor_omega - piece_10_omega;
    let piece_1_phi_relative_dot = piece_1_omega - piece_10_omega;
    let piece_2_phi_relative_dot = piece_2_omega - piece_10_omega;
    let piece_3_phi_relative_dot = piece_3_omega - piece_10_omega;
    let piece_4_phi_relative_dot = piece_4_omega - piece_10_omega;
    let piece_5_phi_relative_dot = piece_5_omega - piece_10_omega;
    let piece_6_phi_relative_dot = piece_6_omega - piece_10_omega;
    let piece_7_phi_relative_dot = piece_7_omega - piece_10_omega;
    let piece_8_phi_relative_dot = piece_8_omega - piece_10_omega;
    [
        motor_phi_relative_dot,
        piece_1_phi_relative_dot,
        piece_2_phi_relative_dot,
        piece_3_phi_relative_dot,
        piece_4_phi_relative_dot,
        piece_5_phi_relative_dot,
        piece_6_phi_relative_dot,
        piece_7_phi_relative_dot,
        piece_8_phi_relative_dot,
        piece_9_omega_minus_piece_10_omega,
        motor_omega_dot,
        piece_1_omega_dot,
        piece_2_omega_dot,
        piece_3_omega_dot,
        piece_4_omega_dot,
        piece_5_omega_dot,
        piece_6_omega_dot,
        piece_7_omega_dot,
        piece_8_omega_dot,
        piece_9_omega_dot,
        piece_10_omega_dot,
        motor_psi_sx_dot,
        motor_psi_sy_dot,
        motor_psi_rx_dot,
        motor_psi_ry_dot,
        piece_10_omega,
    ]
}

/// `M = d2L/dq'2`, values in the order of `MASS_MATRIX_PATTERN`.
///
/// No operations.
#[must_use]
pub fn mass_matrix<R: Real>(
    _time: R,
    _state: &[R; STATES],
    _p: &Parameters<R>,
) -> [R; 11] {
    [
        R::literal(4.2),
        R::literal(0.1244),
        R::literal(0.1244),
        R::literal(0.1244),
        R::literal(0.1244),
        R::literal(0.1244),
        R::literal(0.1244),
        R::literal(0.1244),
        R::literal(0.1244),
        R::literal(0.1244),
        R::literal(0.1244),
    ]
}

/// `f` of `M q'' = f(q, q', z, t)`, one for each coordinate.
///
/// 133 operations.
#[must_use]
pub fn forcing<R: Real>(
    time: R,
    state: &[R; STATES],
    _p: &Parameters<R>,
) -> [R; COORDINATES] {
    let [motor_phi_relative, piece_1_phi_relative, piece_2_phi_relative,
    piece_3_phi_relative, piece_4_phi_relative, piece_5_phi_relative,
    piece_6_phi_relative, piece_7_phi_relative, piece_8_phi_relative,
    piece_9_phi_relative, motor_omega, piece_1_omega, piece_2_omega, piece_3_omega,
    piece_4_omega, piece_5_omega, piece_6_omega, piece_7_omega, piece_8_omega,
    piece_9_omega, piece_10_omega, motor_psi_sx, motor_psi_sy, motor_psi_rx,
    motor_psi_ry, ..] = *state;
    let [t0, t1, t2, t3, t4, t5, t6, t7, t8, t9] = R::tanh_each([
        R::literal(2.0) * piece_1_omega,
        R::literal(2.0) * piece_2_omega,
        R::literal(2.0) * piece_3_omega,
        R::literal(2.0) * piece_4_omega,
        R::literal(2.0) * piece_5_omega,
        R::literal(2.0) * piece_6_omega,
        R::literal(2.0) * piece_7_omega,
        R::literal(2.0) * piece_8_omega,
        R::literal(2.0) * piece_9_omega,
        R::literal(2.0) * piece_10_omega,
    ]);
    let coupling_twist = motor_phi_relative - piece_1_phi_relative;
    let coupling_twist_rate = motor_omega - piece_1_omega;
    let load_1_engagement = R::literal(1.0)
        / (R::literal(1.0) + (-(R::literal(50.0) * (time - R::literal(0.15)))).exp());
    let motor_torque = R::literal(4_822.097_783_227_635)
        * (motor_psi_sy * motor_psi_rx).sub_product(motor_psi_sx, motor_psi_ry);
    let t10 = R::literal(128.5346) * coupling_twist_rate;
    let t11 = R::literal(23065.2) * coupling_twist;
    let coupling_torque = t10 + t11;
    let t12 = load_1_engagement
        * R::literal(84.372)
            .add_product(
                R::literal(7.878),
                (R::literal(241.805_307_826_689_27) * time).sin(),
            );
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
    let t13 = R::literal(3_382_256.675_279_931)
        * (piece_1_phi_relative - piece_2_phi_relative);
    let t14 = R::literal(67.645_133_505_598_62) * (piece_1_omega - piece_2_omega);
    let piece_1_phi_forcing = -load_1_resistance - (t13 - t11) - (t14 - t10);
    let t15 = R::literal(3_382_256.675_279_931)
        * (piece_2_phi_relative - piece_3_phi_relative);
    let t16 = R::literal(67.645_133_505_598_62) * (piece_2_omega - piece_3_omega);
    let piece_2_phi_forcing = -load_2_resistance - (t15 - t13) - (t16 - t14);
    let t17 = R::literal(3_382_256.675_279_931)
        * (piece_3_phi_relative - piece_4_phi_relative);
    let t18 = R::literal(67.645_133_505_598_62) * (piece_3_omega - piece_4_omega);
    let piece_3_phi_forcing = -load_3_resistance - (t17 - t15) - (t18 - t16);
    let t19 = R::literal(3_382_256.675_279_931)
        * (piece_4_phi_relative - piece_5_phi_relative);
    let t20 = R::literal(67.645_133_505_598_62) * (piece_4_omega - piece_5_omega);
    let piece_4_phi_forcing = -load_4_resistance - (t19 - t17) - (t20 - t18);
    let t21 = R::literal(3_382_256.675_279_931)
        * (piece_5_phi_relative - piece_6_phi_relative);
    let t22 = R::literal(67.645_133_505_598_62) * (piece_5_omega - piece_6_omega);
    let piece_5_phi_forcing = -load_5_resistance - (t21 - t19) - (t22 - t20);
    let t23 = R::literal(3_382_256.675_279_931)
        * (piece_6_phi_relative - piece_7_phi_relative);
    let t24 = R::literal(67.645_133_505_598_62) * (piece_6_omega - piece_7_omega);
    let piece_6_phi_forcing = -load_6_resistance - (t23 - t21) - (t24 - t22);
    let t25 = R::literal(3_382_256.675_279_931)
        * (piece_7_phi_relative - piece_8_phi_relative);
    let t26 = R::literal(67.645_133_505_598_62) * (piece_7_omega - piece_8_omega);
    let piece_7_phi_forcing = -load_7_resistance - (t25 - t23) - (t26 - t24);
    let t27 = R::literal(3_382_256.675_279_931)
        * (piece_8_phi_relative - piece_9_phi_relative);
    let t28 = R::literal(67.645_133_505_598_62) * (piece_8_omega - piece_9_omega);
    let piece_8_phi_forcing = -load_8_resistance - (t27 - t25) - (t28 - t26);
    let t29 = R::literal(3_382_256.675_279_931) * piece_9_phi_relative;
    let t30 = R::literal(67.645_133_505_598_62) * (piece_9_omega - piece_10_omega);
    let piece_9_phi_forcing = -load_9_resistance - (t29 - t27) - (t30 - t28);
    let piece_10_phi_forcing = t30 + t29 - load_10_resistance;
    [
        motor_phi_forcing,
        piece_1_phi_forcing,
        piece_2_phi_forcing,
        piece_3_phi_forcing,
        piece_4_phi_forcing,
        piece_5_phi_forcing,
        piece_6_phi_forcing,
        piece_7_phi_forcing,
        piece_8_phi_forcing,
        piece_9_phi_forcing,
        piece_10_phi_forcing,
    ]
}

/// `dy'/dy`, values in the order of `RATE_JACOBIAN_PATTERN`.
///
/// 103 operations.
#[must_use]
pub fn rate_jacobian<R: Real>(
    time: R,
    state: &[R; STATES],
    _p: &Parameters<R>,
) -> [R; 99] {
    let [_, _, _, _, _, _, _, _, _, _, motor_omega, piece_1_omega, piece_2_omega,
    piece_3_omega, piece_4_omega, piece_5_omega, piece_6_omega, piece_7_omega,
    piece_8_omega, piece_9_omega, piece_10_omega, motor_psi_sx, motor_psi_sy,
    motor_psi_rx, motor_psi_ry, ..] = *state;
    let [t0, t1, t2, t3, t4, t5, t6, t7, t8, t9] = R::tanh_each([
        R::literal(2.0) * piece_1_omega,
        R::literal(2.0) * piece_2_omega,
        R::literal(2.0) * piece_3_omega,
        R::literal(2.0) * piece_4_omega,
        R::literal(2.0) * piece_5_omega,
        R::literal(2.0) * piece_6_omega,
        R::literal(2.0) * piece_7_omega,
        R::literal(2.0) * piece_8_omega,
        R::literal(2.0) * piece_9_omega,
        R::literal(2.0) * piece_10_omega,
    ]);
    let t10 = R::literal(4.0) * motor_omega;
    let motor_slip_speed = R::literal(314.159_265_358_979_3) - t10;
    let load_1_engagement = R::literal(1.0)
        / (R::literal(1.0) + (-(R::literal(50.0) * (time - R::literal(0.15)))).exp());
    let t11 = R::literal(84.372)
        .add_product(
            R::literal(7.878),
            (R::literal(241.805_307_826_689_27) * time).sin(),
        );
    let motor_psi_rx_dot_by_motor_omega = -(R::literal(4.0) * motor_psi_ry);
    let motor_psi_ry_dot_by_motor_omega = R::literal(4.0) * motor_psi_rx;
    let t12 = R::literal(2.0) * load_1_engagement;
    let piece_1_omega_dot_by_piece_1_omega = R::literal(-196.179_733_505_598_62)
        .sub_product(t12 * R::literal(1.0).sub_product(t0, t0), t11)
        * R::literal(8.038_585_209_003_216);
    let piece_2_omega_dot_by_piece_2_omega = R::literal(-135.290_267_011_197_24)
        .sub_product(t12 * R::literal(1.0).sub_product(t1, t1), t11)
        * R::literal(8.038_585_209_003_216);
    let piece_3_omega_dot_by_piece_3_omega = R::literal(-135.290_267_011_197_24)
        .sub_product(t12 * R::literal(1.0).sub_product(t2, t2), t11)
        * R::literal(8.038_585_209_003_216);
    let piece_4_omega_dot_by_piece_4_omega = R::literal(-135.290_267_011_197_24)
        .sub_product(t12 * R::literal(1.0).sub_product(t3, t3), t11)
        * R::literal(8.038_585_209_003_216);
    let piece_5_omega_dot_by_piece_5_omega = R::literal(-135.290_267_011_197_24)
        .sub_product(t12 * R::literal(1.0).sub_product(t4, t4), t11)
        * R::literal(8.038_585_209_003_216);
    let piece_6_omega_dot_by_piece_6_omega = R::literal(-135.290_267_011_197_24)
        .sub_product(t12 * R::literal(1.0).sub_product(t5, t5), t11)
        * R::literal(8.038_585_209_003_216);
    let piece_7_omega_dot_by_piece_7_omega = R::literal(-135.290_267_011_197_24)
        .sub_product(t12 * R::literal(1.0).sub_product(t6, t6), t11)
        * R::literal(8.038_585_209_003_216);
    let piece_8_omega_dot_by_piece_8_omega = R::literal(-135.290_267_011_197_24)
        .sub_product(t12 * R::literal(1.0).sub_product(t7, t7), t11)
        * R::literal(8.038_585_209_003_216);
    let piece_9_omega_dot_by_piece_9_omega = R::literal(-135.290_267_011_197_24)
        .sub_product(t12 * R::literal(1.0).sub_product(t8, t8), t11)
        * R::literal(8.038_585_209_003_216);
    let piece_10_omega_dot_by_piece_10_omega = R::literal(-67.645_133_505_598_62)
        .sub_product(t12 * R::literal(1.0).sub_product(t9, t9), t11)
        * R::literal(8.038_585_209_003_216);
    let motor_omega_dot_by_motor_psi_sx = -(R::literal(1_148.118_519_816_103_6)
        * motor_psi_ry);
    let motor_omega_dot_by_motor_psi_sy = R::literal(1_148.118_519_816_103_6)
        * motor_psi_rx;
    let motor_omega_dot_by_motor_psi_rx = R::literal(1_148.118_519_816_103_6)
        * motor_psi_sy;
    let motor_psi_ry_dot_by_motor_psi_rx = t10 - R::literal(314.159_265_358_979_3);
    let motor_omega_dot_by_motor_psi_ry = -(R::literal(1_148.118_519_816_103_6)
        * motor_psi_sx);
    [
        R::literal(1.0),
        R::literal(-1.0),
        R::literal(1.0),
        R::literal(-1.0),
        R::literal(1.0),
        R::literal(-1.0),
        R::literal(1.0),
        R::literal(-1.0),
        R::literal(1.0),
        R::literal(-1.0),
        R::literal(1.0),
        R::literal(-1.0),
        R::literal(1.0),
        R::literal(-1.0),
        R::literal(1.0),
        R::literal(-1.0),
        R::literal(1.0),
        R::literal(-1.0),
        R::literal(1.0),
        R::literal(-1.0),
        R::literal(-5_491.714_285_714_285),
        R::literal(5_491.714_285_714_285),
        R::literal(-30.603_476_190_476_19),
        R::literal(30.603_476_190_476_19),
        motor_omega_dot_by_motor_psi_sx,
        motor_omega_dot_by_motor_psi_sy,
        motor_omega_dot_by_motor_psi_rx,
        motor_omega_dot_by_motor_psi_ry,
        R::literal(185_411.575_562_700_98),
        R::literal(-27_373_970.058_520_347),
        R::literal(27_188_558.482_957_646),
        R::literal(1_033.236_334_405_144_8),
        piece_1_omega_dot_by_piece_1_omega,
        R::literal(543.771_169_659_153),
        R::literal(27_188_558.482_957_646),
        R::literal(-54_377_116.965_915_29),
        R::literal(27_188_558.482_957_646),
        R::literal(543.771_169_659_153),
        piece_2_omega_dot_by_piece_2_omega,
        R::literal(543.771_169_659_153),
        R::literal(27_188_558.482_957_646),
        R::literal(-54_377_116.965_915_29),
        R::literal(27_188_558.482_957_646),
        R::literal(543.771_169_659_153),
        piece_3_omega_dot_by_piece_3_omega,
        R::literal(543.771_169_659_153),
        R::literal(27_188_558.482_957_646),
        R::literal(-54_377_116.965_915_29),
        R::literal(27_188_558.482_957_646),
        R::literal(543.771_169_659_153),
        piece_4_omega_dot_by_piece_4_omega,
        R::literal(543.771_169_659_153),
        R::literal(27_188_558.482_957_646),
        R::literal(-54_377_116.965_915_29),
        R::literal(27_188_558.482_957_646),
        R::literal(543.771_169_659_153),
        piece_5_omega_dot_by_piece_5_omega,
        R::literal(543.771_169_659_153),
        R::literal(27_188_558.482_957_646),
        R::literal(-54_377_116.965_915_29),
        R::literal(27_188_558.482_957_646),
        R::literal(543.771_169_659_153),
        piece_6_omega_dot_by_piece_6_omega,
        R::literal(543.771_169_659_153),
        R::literal(27_188_558.482_957_646),
        R::literal(-54_377_116.965_915_29),
        R::literal(27_188_558.482_957_646),
        R::literal(543.771_169_659_153),
        piece_7_omega_dot_by_piece_7_omega,
        R::literal(543.771_169_659_153),
        R::literal(27_188_558.482_957_646),
        R::literal(-54_377_116.965_915_29),
        R::literal(27_188_558.482_957_646),
        R::literal(543.771_169_659_153),
        piece_8_omega_dot_by_piece_8_omega,
        R::literal(543.771_169_659_153),
        R::literal(27_188_558.482_957_646),
        R::literal(-54_377_116.965_915_29),
        R::literal(543.771_169_659_153),
        piece_9_omega_dot_by_piece_9_omega,
        R::literal(543.771_169_659_153),
        R::literal(27_188_558.482_957_646),
        R::literal(543.771_169_659_153),
        piece_10_omega_dot_by_piece_10_omega,
        R::literal(-36.128_315_516_282_62),
        R::literal(314.159_265_358_979_3),
        R::literal(34.394_156_371_501_055),
        R::literal(-314.159_265_358_979_3),
        R::literal(-36.128_315_516_282_62),
        R::literal(34.394_156_371_501_055),
        motor_psi_rx_dot_by_motor_omega,
        R::literal(25.768_850_909_217_203),
        R::literal(-26.954_864_967_800_425),
        motor_slip_speed,
        motor_psi_ry_dot_by_motor_omega,
        R::literal(25.768_850_909_217_203),
        motor_psi_ry_dot_by_motor_psi_rx,
        R::literal(-26.954_864_967_800_425),
        R::literal(1.0),
    ]
}

/// `dy'/dp`, values in the order of `PARAMETER_JACOBIAN_PATTERN`.
///
/// No operations.
#[must_use]
pub fn parameter_jacobian<R: Real>(
    _time: R,
    _state: &[R; STATES],
    _p: &Parameters<R>,
) -> [R; 0] {
    []
}

/// Partial derivative of `y'` with respect to time.
///
/// 96 operations.
#[must_use]
pub fn time_derivative<R: Real>(
    time: R,
    state: &[R; STATES],
    _p: &Parameters<R>,
) -> [R; STATES] {
    let [_, _, _, _, _, _, _, _, _, _, _, piece_1_omega, piece_2_omega, piece_3_omega,
    piece_4_omega, piece_5_omega, piece_6_omega, piece_7_omega, piece_8_omega,
    piece_9_omega, piece_10_omega, ..] = *state;
    let t0 = R::literal(241.805_307_826_689_27) * time;
    let (t1, t2) = t0.sin_cos();
    let [t3, t4, t5, t6, t7, t8, t9, t10, t11, t12] = R::tanh_each([
        R::literal(2.0) * piece_1_omega,
        R::literal(2.0) * piece_2_omega,
        R::literal(2.0) * piece_3_omega,
        R::literal(2.0) * piece_4_omega,
        R::literal(2.0) * piece_5_omega,
        R::literal(2.0) * piece_6_omega,
        R::literal(2.0) * piece_7_omega,
        R::literal(2.0) * piece_8_omega,
        R::literal(2.0) * piece_9_omega,
        R::literal(2.0) * piece_10_omega,
    ]);
    let t13 = (-(R::literal(50.0) * (time - R::literal(0.15)))).exp();
    let t14 = R::literal(1.0) + t13;
    let load_1_engagement = R::literal(1.0) / t14;
    let t15 = R::literal(1_904.942_215_058_658_1) * load_1_engagement * t2;
    let t16 = t14 * t14;
    let t17 = R::literal(50.0) * R::literal(84.372).add_product(R::literal(7.878), t1)
        * t13;
    let piece_10_omega_dot_by_time = (-(t17 * t12 / t16)).sub_product(t15, t12)
        * R::literal(8.038_585_209_003_216);
    let piece_9_omega_dot_by_time = (-(t17 * t11 / t16)).sub_product(t15, t11)
        * R::literal(8.038_585_209_003_216);
    let piece_8_omega_dot_by_time = (-(t17 * t10 / t16)).sub_product(t15, t10)
        * R::literal(8.038_585_209_003_216);
    let piece_7_omega_dot_by_time = (-(t17 * t9 / t16)).sub_product(t15, t9)
        * R::literal(8.038_585_209_003_216);
    let piece_6_omega_dot_by_time = (-(t17 * t8 / t16)).sub_product(t15, t8)
        * R::literal(8.038_585_209_003_216);
    let piece_5_omega_dot_by_time = (-(t17 * t7 / t16)).sub_product(t15, t7)
        * R::literal(8.038_585_209_003_216);
    let piece_4_omega_dot_by_time = (-(t17 * t6 / t16)).sub_product(t15, t6)
        * R::literal(8.038_585_209_003_216);
    let piece_3_omega_dot_by_time = (-(t17 * t5 / t16)).sub_product(t15, t5)
        * R::literal(8.038_585_209_003_216);
    let piece_2_omega_dot_by_time = (-(t17 * t4 / t16)).sub_product(t15, t4)
        * R::literal(8.038_585_209_003_216);
    let piece_1_omega_dot_by_time = (-(t17 * t3 / t16)).sub_product(t15, t3)
        * R::literal(8.038_585_209_003_216);
    [
        R::literal(0.0),
        R::literal(0.0),
        R::literal(0.0),
        R::literal(0.0),
        R::literal(0.0),
        R::literal(0.0),
        R::literal(0.0),
        R::literal(0.0),
        R::literal(0.0),
        R::literal(0.0),
        R::literal(0.0),
        piece_1_omega_dot_by_time,
        piece_2_omega_dot_by_time,
        piece_3_omega_dot_by_time,
        piece_4_omega_dot_by_time,
        piece_5_omega_dot_by_time,
        piece_6_omega_dot_by_time,
        piece_7_omega_dot_by_time,
        piece_8_omega_dot_by_time,
        piece_9_omega_dot_by_time,
        piece_10_omega_dot_by_time,
        R::literal(0.0),
        R::literal(0.0),
        R::literal(0.0),
        R::literal(0.0),
        R::literal(0.0),
    ]
}

/// Wanted outputs.
///
/// 10 operations.
#[must_use]
pub fn outputs<R: Real>(
    _time: R,
    state: &[R; STATES],
    _p: &Parameters<R>,
) -> Outputs<R> {
    let [motor_phi_relative, piece_1_phi_relative, piece_2_phi_relative,
    piece_3_phi_relative, piece_4_phi_relative, piece_5_phi_relative,
    piece_6_phi_relative, piece_7_phi_relative, piece_8_phi_relative,
    piece_9_phi_relative, motor_omega, piece_1_omega, piece_2_omega, piece_3_omega,
    piece_4_omega, piece_5_omega, piece_6_omega, piece_7_omega, piece_8_omega,
    piece_9_omega, piece_10_omega, motor_psi_sx, motor_psi_sy, motor_psi_rx,
    motor_psi_ry, piece_10_phi] = *state;
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

/// T, V and the energy of first-order states \[J\].
///
/// 90 operations.
#[must_use]
pub fn energy<R: Real>(_time: R, state: &[R; STATES], _p: &Parameters<R>) -> Energy<R> {
    let [motor_phi_relative, piece_1_phi_relative, piece_2_phi_relative,
    piece_3_phi_relative, piece_4_phi_relative, piece_5_phi_relative,
    piece_6_phi_relative, piece_7_phi_relative, piece_8_phi_relative,
    piece_9_phi_relative, motor_omega, piece_1_omega, piece_2_omega, piece_3_omega,
    piece_4_omega, piece_5_omega, piece_6_omega, piece_7_omega, piece_8_omega,
    piece_9_omega, piece_10_omega, motor_psi_sx, motor_psi_sy, motor_psi_rx,
    motor_psi_ry, ..] = *state;
    let coupling_twist = motor_phi_relative - piece_1_phi_relative;
    let motor_i_sx = R::literal(844.204_793_982_429_1)
        * motor_psi_sx.sub_product(R::literal(0.952), motor_psi_rx);
    let motor_i_sy = R::literal(844.204_793_982_429_1)
        * motor_psi_sy.sub_product(R::literal(0.952), motor_psi_ry);
    let motor_i_rx = R::literal(840.672_556_350_703_5)
        * motor_psi_rx.sub_product(R::literal(0.956), motor_psi_sx);
    let motor_i_ry = R::literal(840.672_556_350_703_5)
        * motor_psi_ry.sub_product(R::literal(0.956), motor_psi_sy);
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
        potential: (R::literal(1_691_128.337_639_965_6)
            * (piece_9_phi_relative * piece_9_phi_relative))
            .add_product(R::literal(11532.6), coupling_twist * coupling_twist)
            .add_product(R::literal(1_691_128.337_639_965_6), t0 * t0)
            .add_product(R::literal(1_691_128.337_639_965_6), t1 * t1)
            .add_product(R::literal(1_691_128.337_639_965_6), t2 * t2)
            .add_product(R::literal(1_691_128.337_639_965_6), t3 * t3)
            .add_product(R::literal(1_691_128.337_639_965_6), t4 * t4)
            .add_product(R::literal(1_691_128.337_639_965_6), t5 * t5)
            .add_product(R::literal(1_691_128.337_639_965_6), t6 * t6)
            .add_product(R::literal(1_691_128.337_639_965_6), t7 * t7),
        stored: R::literal(0.75)
            * (motor_psi_sx * motor_i_sx)
                .add_product(motor_psi_sy, motor_i_sy)
                .add_product(motor_psi_rx, motor_i_rx)
                .add_product(motor_psi_ry, motor_i_ry),
    }
}

/// `dE/dt`, power supplied and power dissipated \[W\].
///
/// 318 operations.
#[must_use]
pub fn power_balance<R: Real>(
    time: R,
    state: &[R; STATES],
    _p: &Parameters<R>,
) -> PowerBalance<R> {
    let [motor_phi_relative, piece_1_phi_relative, piece_2_phi_relative,
    piece_3_phi_relative, piece_4_phi_relative, piece_5_phi_relative,
    piece_6_phi_relative, piece_7_phi_relative, piece_8_phi_relative,
    piece_9_phi_relative, motor_omega, piece_1_omega, piece_2_omega, piece_3_omega,
    piece_4_omega, piece_5_omega, piece_6_omega, piece_7_omega, piece_8_omega,
    piece_9_omega, piece_10_omega, motor_psi_sx, motor_psi_sy, motor_psi_rx,
    motor_psi_ry, ..] = *state;
    let [t0, t1, t2, t3, t4, t5, t6, t7, t8, t9] = R::tanh_each([
        R::literal(2.0) * piece_1_omega,
        R::literal(2.0) * piece_2_omega,
        R::literal(2.0) * piece_3_omega,
        R::literal(2.0) * piece_4_omega,
        R::literal(2.0) * piece_5_omega,
        R::literal(2.0) * piece_6_omega,
        R::literal(2.0) * piece_7_omega,
        R::literal(2.0) * piece_8_omega,
        R::literal(2.0) * piece_9_omega,
        R::literal(2.0) * piece_10_omega,
    ]);
    let coupling_twist = motor_phi_relative - piece_1_phi_relative;
    let coupling_twist_rate = motor_omega - piece_1_omega;
    let motor_slip_speed = R::literal(314.159_265_358_979_3)
        .sub_product(R::literal(4.0), motor_omega);
    let motor_i_sx = R::literal(844.204_793_982_429_1)
        * motor_psi_sx.sub_product(R::literal(0.952), motor_psi_rx);
    let motor_i_sy = R::literal(844.204_793_982_429_1)
        * motor_psi_sy.sub_product(R::literal(0.952), motor_psi_ry);
    let t10 = R::literal(0.956) * motor_psi_sx;
    let motor_i_rx = R::literal(840.672_556_350_703_5) * (motor_psi_rx - t10);
    let t11 = R::literal(0.956) * motor_psi_sy;
    let motor_i_ry = R::literal(840.672_556_350_703_5) * (motor_psi_ry - t11);
    let load_1_engagement = R::literal(1.0)
        / (R::literal(1.0) + (-(R::literal(50.0) * (time - R::literal(0.15)))).exp());
    let motor_torque = R::literal(4_822.097_783_227_635)
        * (motor_psi_sy * motor_psi_rx).sub_product(motor_psi_sx, motor_psi_ry);
    let t12 = R::literal(128.5346) * coupling_twist_rate;
    let t13 = R::literal(23065.2) * coupling_twist;
    let coupling_torque = t12 + t13;
    let t14 = load_1_engagement
        * R::literal(84.372)
            .add_product(
                R::literal(7.878),
                (R::literal(241.805_307_826_689_27) * time).sin(),
            );
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
    let t15 = R::literal(3_382_256.675_279_931)
        * (piece_1_phi_relative - piece_2_phi_relative);
    let t16 = t15 - t13;
    let t17 = R::literal(67.645_133_505_598_62) * (piece_1_omega - piece_2_omega);
    let t18 = t17 - t12;
    let t19 = R::literal(3_382_256.675_279_931)
        * (piece_2_phi_relative - piece_3_phi_relative);
    let t20 = t19 - t15;
    let t21 = R::literal(67.645_133_505_598_62) * (piece_2_omega - piece_3_omega);
    let t22 = t21 - t17;
    let t23 = R::literal(3_382_256.675_279_931)
        * (piece_3_phi_relative - piece_4_phi_relative);
    let t24 = t23 - t19;
    let t25 = R::literal(67.645_133_505_598_62) * (piece_3_omega - piece_4_omega);
    let t26 = t25 - t21;
    let t27 = R::literal(3_382_256.675_279_931)
        * (piece_4_phi_relative - piece_5_phi_relative);
    let t28 = t27 - t23;
    let t29 = R::literal(67.645_133_505_598_62) * (piece_4_omega - piece_5_omega);
    let t30 = t29 - t25;
    let t31 = R::literal(3_382_256.675_279_931)
        * (piece_5_phi_relative - piece_6_phi_relative);
    let t32 = t31 - t27;
    let t33 = R::literal(67.645_133_505_598_62) * (piece_5_omega - piece_6_omega);
    let t34 = t33 - t29;
    let t35 = R::literal(3_382_256.675_279_931)
        * (piece_6_phi_relative - piece_7_phi_relative);
    let t36 = t35 - t31;
    let t37 = R::literal(67.645_133_505_598_62) * (piece_6_omega - piece_7_omega);
    let t38 = t37 - t33;
    let t39 = R::literal(3_382_256.675_279_931)
        * (piece_7_phi_relative - piece_8_phi_relative);
    let t40 = t39 - t35;
    let t41 = R::literal(67.645_133_505_598_62) * (piece_7_omega - piece_8_omega);
    let t42 = t41 - t37;
    let t43 = R::literal(3_382_256.675_279_931)
        * (piece_8_phi_relative - piece_9_phi_relative);
    let t44 = t43 - t39;
    let t45 = R::literal(67.645_133_505_598_62) * (piece_8_omega - piece_9_omega);
    let t46 = t45 - t41;
    let t47 = R::literal(3_382_256.675_279_931) * piece_9_phi_relative;
    let t48 = t47 - t43;
    let piece_9_omega_minus_piece_10_omega = piece_9_omega - piece_10_omega;
    let t49 = R::literal(67.645_133_505_598_62) * piece_9_omega_minus_piece_10_omega;
    let t50 = t49 - t45;
    let piece_10_omega_dot = (t49 + t47 - load_10_resistance)
        * R::literal(8.038_585_209_003_216);
    let piece_9_omega_dot = (-load_9_resistance - t48 - t50)
        * R::literal(8.038_585_209_003_216);
    let piece_8_omega_dot = (-load_8_resistance - t44 - t46)
        * R::literal(8.038_585_209_003_216);
    let piece_7_omega_dot = (-load_7_resistance - t40 - t42)
        * R::literal(8.038_585_209_003_216);
    let piece_6_omega_dot = (-load_6_resistance - t36 - t38)
        * R::literal(8.038_585_209_003_216);
    let piece_5_omega_dot = (-load_5_resistance - t32 - t34)
        * R::literal(8.038_585_209_003_216);
    let piece_4_omega_dot = (-load_4_resistance - t28 - t30)
        * R::literal(8.038_585_209_003_216);
    let piece_3_omega_dot = (-load_3_resistance - t24 - t26)
        * R::literal(8.038_585_209_003_216);
    let piece_2_omega_dot = (-load_2_resistance - t20 - t22)
        * R::literal(8.038_585_209_003_216);
    let piece_1_omega_dot = (-load_1_resistance - t16 - t18)
        * R::literal(8.038_585_209_003_216);
    let motor_omega_dot = (motor_torque - coupling_torque)
        * R::literal(0.238_095_238_095_238_08);
    let motor_psi_sx_dot = R::literal(311.126_983_722_080_9)
        .add_product(R::literal(314.159_265_358_979_3), motor_psi_sy)
        .sub_product(R::literal(0.042_795_676_8), motor_i_sx);
    let motor_psi_sy_dot = (-(R::literal(314.159_265_358_979_3) * motor_psi_sx))
        .sub_product(R::literal(0.042_795_676_8), motor_i_sy);
    let motor_psi_rx_dot = (R::literal(26.954_864_967_800_425) * (t10 - motor_psi_rx))
        .add_product(motor_psi_ry, motor_slip_speed);
    let motor_psi_ry_dot = (R::literal(26.954_864_967_800_425) * (t11 - motor_psi_ry))
        .sub_product(motor_psi_rx, motor_slip_speed);
    let t51 = (t13 * (motor_omega - piece_10_omega))
        .add_product(t16, piece_1_omega - piece_10_omega)
        .add_product(t20, piece_2_omega - piece_10_omega)
        .add_product(t24, piece_3_omega - piece_10_omega)
        .add_product(t28, piece_4_omega - piece_10_omega)
        .add_product(t32, piece_5_omega - piece_10_omega)
        .add_product(t36, piece_6_omega - piece_10_omega)
        .add_product(t40, piece_7_omega - piece_10_omega)
        .add_product(t44, piece_8_omega - piece_10_omega)
        .add_product(t48, piece_9_omega_minus_piece_10_omega)
        .add_product(R::literal(4.2) * motor_omega, motor_omega_dot)
        .add_product(R::literal(0.1244) * piece_1_omega, piece_1_omega_dot);
    let t52 = t51
        .add_product(R::literal(0.1244) * piece_2_omega, piece_2_omega_dot)
        .add_product(R::literal(0.1244) * piece_3_omega, piece_3_omega_dot)
        .add_product(R::literal(0.1244) * piece_4_omega, piece_4_omega_dot)
        .add_product(R::literal(0.1244) * piece_5_omega, piece_5_omega_dot)
        .add_product(R::literal(0.1244) * piece_6_omega, piece_6_omega_dot)
        .add_product(R::literal(0.1244) * piece_7_omega, piece_7_omega_dot)
        .add_product(R::literal(0.1244) * piece_8_omega, piece_8_omega_dot)
        .add_product(R::literal(0.1244) * piece_9_omega, piece_9_omega_dot)
        .add_product(R::literal(0.1244) * piece_10_omega, piece_10_omega_dot)
        .add_product(
            R::literal(0.75)
                * motor_i_sx
                    .add_product(R::literal(844.204_793_982_429_1), motor_psi_sx)
                    .sub_product(R::literal(803.682_963_871_272_6), motor_psi_rx),
            motor_psi_sx_dot,
        );
    PowerBalance {
        stored_rate: t52
            .add_product(
                R::literal(0.75)
                    * motor_i_sy
                        .add_product(R::literal(844.204_793_982_429_1), motor_psi_sy)
                        .sub_product(R::literal(803.682_963_871_272_6), motor_psi_ry),
                motor_psi_sy_dot,
            )
            .add_product(
                R::literal(0.75)
                    * motor_i_rx
                        .add_product(R::literal(840.672_556_350_703_5), motor_psi_rx)
                        .sub_product(R::literal(803.682_963_871_272_6), motor_psi_sx),
                motor_psi_rx_dot,
            )
            .add_product(
                R::literal(0.75)
                    * motor_i_ry
                        .add_product(R::literal(840.672_556_350_703_5), motor_psi_ry)
                        .sub_product(R::literal(803.682_963_871_272_6), motor_psi_sy),
                motor_psi_ry_dot,
            ),
        supplied: (R::literal(466.690_475_583_121_4) * motor_i_sx)
            .sub_product(piece_1_omega, load_1_resistance)
            .sub_product(piece_2_omega, load_2_resistance)
            .sub_product(piece_3_omega, load_3_resistance)
            .sub_product(piece_4_omega, load_4_resistance)
            .sub_product(piece_5_omega, load_5_resistance)
            .sub_product(piece_6_omega, load_6_resistance)
            .sub_product(piece_7_omega, load_7_resistance)
            .sub_product(piece_8_omega, load_8_resistance)
            .sub_product(piece_9_omega, load_9_resistance)
            .sub_product(piece_10_omega, load_10_resistance),
        dissipated: (R::literal(128.5346) * motor_omega * coupling_twist_rate)
            .add_product(
                R::literal(1.5),
                (R::literal(0.032_063_452_962_957_98)
                    * (motor_i_rx * motor_i_rx).add_product(motor_i_ry, motor_i_ry))
                    .add_product(
                        R::literal(0.042_795_676_8),
                        (motor_i_sx * motor_i_sx).add_product(motor_i_sy, motor_i_sy),
                    ),
            )
            .add_product(piece_1_omega, t18)
            .add_product(piece_2_omega, t22)
            .add_product(piece_3_omega, t26)
            .add_product(piece_4_omega, t30)
            .add_product(piece_5_omega, t34)
            .add_product(piece_6_omega, t38)
            .add_product(piece_7_omega, t42)
            .add_product(piece_8_omega, t46)
            .add_product(piece_9_omega, t50)
            .sub_product(
                R::literal(67.645_133_505_598_62) * piece_10_omega,
                piece_9_omega_minus_piece_10_omega,
            ),
    }
}

/// Normalized Taylor coefficients of the solution through `state`, order after order.
///
/// `_k` marks the coefficient of order k, `_before` that of order k - 1; bare names are
/// zeroth coefficients. The workspace is as `series_workspace` says.
///
/// 245 recurrences. 36 sums of products an order.
///
/// # Panics
/// If there is no room for the zeroth coefficients, or the workspace is too short.
pub fn series<R: Real>(
    time: R,
    state: &[R; STATES],
    _p: &Parameters<R>,
    coefficients: &mut [[R; STATES]],
    workspace: &mut [R],
) {
    let (mut lanes, workspace) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let (mut lanes_1, workspace) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let (mut lanes_2, workspace) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let (mut lanes_3, workspace) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let (mut lanes_4, workspace) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let (mut lanes_5, workspace) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let (mut lanes_6, workspace) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let (mut lanes_7, workspace) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let (mut lanes_8, _) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let [motor_phi_relative, piece_1_phi_relative, piece_2_phi_relative,
    piece_3_phi_relative, piece_4_phi_relative, piece_5_phi_relative,
    piece_6_phi_relative, piece_7_phi_relative, piece_8_phi_relative,
    piece_9_phi_relative, motor_omega, piece_1_omega, piece_2_omega, piece_3_omega,
    piece_4_omega, piece_5_omega, piece_6_omega, piece_7_omega, piece_8_omega,
    piece_9_omega, piece_10_omega, motor_psi_sx, motor_psi_sy, motor_psi_rx,
    motor_psi_ry, ..] = *state;
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
    let t8 = t7 * R::literal(50.0);
    let t9 = -t8;
    let t10 = t9.exp();
    let t11 = R::literal(1.0) + t10;
    let load_1_engagement = R::literal(1.0) / t11;
    let t12 = motor_psi_sx * motor_psi_ry;
    let t13 = motor_psi_sy * motor_psi_rx;
    let t14 = t13 - t12;
    let motor_torque = t14 * R::literal(4_822.097_783_227_635);
    let t15 = coupling_twist_rate * R::literal(128.5346);
    let t16 = coupling_twist * R::literal(23065.2);
    let coupling_torque = t15 + t16;
    let t17 = time * R::literal(241.805_307_826_689_27);
    let t18 = t17.sin();
    let t19 = t17.cos();
    let t20 = t18 * R::literal(7.878);
    let t21 = R::literal(84.372) + t20;
    let t22 = piece_1_omega * R::literal(2.0);
    let t23 = t22.tanh();
    let t24 = t23 * t23;
    let t25 = R::literal(1.0) - t24;
    let t26 = load_1_engagement * t21;
    let load_1_resistance = t26 * t23;
    let t27 = piece_2_omega * R::literal(2.0);
    let t28 = t27.tanh();
    let t29 = t28 * t28;
    let t30 = R::literal(1.0) - t29;
    let load_2_resistance = t26 * t28;
    let t31 = piece_3_omega * R::literal(2.0);
    let t32 = t31.tanh();
    let t33 = t32 * t32;
    let t34 = R::literal(1.0) - t33;
    let load_3_resistance = t26 * t32;
    let t35 = piece_4_omega * R::literal(2.0);
    let t36 = t35.tanh();
    let t37 = t36 * t36;
    let t38 = R::literal(1.0) - t37;
    let load_4_resistance = t26 * t36;
    let t39 = piece_5_omega * R::literal(2.0);
    let t40 = t39.tanh();
    let t41 = t40 * t40;
    let t42 = R::literal(1.0) - t41;
    let load_5_resistance = t26 * t40;
    let t43 = piece_6_omega * R::literal(2.0);
    let t44 = t43.tanh();
    let t45 = t44 * t44;
    let t46 = R::literal(1.0) - t45;
    let load_6_resistance = t26 * t44;
    let t47 = piece_7_omega * R::literal(2.0);
    let t48 = t47.tanh();
    let t49 = t48 * t48;
    let t50 = R::literal(1.0) - t49;
    let load_7_resistance = t26 * t48;
    let t51 = piece_8_omega * R::literal(2.0);
    let t52 = t51.tanh();
    let t53 = t52 * t52;
    let t54 = R::literal(1.0) - t53;
    let load_8_resistance = t26 * t52;
    let t55 = piece_9_omega * R::literal(2.0);
    let t56 = t55.tanh();
    let t57 = t56 * t56;
    let t58 = R::literal(1.0) - t57;
    let load_9_resistance = t26 * t56;
    let t59 = piece_10_omega * R::literal(2.0);
    let t60 = t59.tanh();
    let t61 = t60 * t60;
    let t62 = R::literal(1.0) - t61;
    let load_10_resistance = t26 * t60;
    let t63 = motor_torque - coupling_torque;
    let t64 = piece_1_phi_relative - piece_2_phi_relative;
    let t65 = t64 * R::literal(3_382_256.675_279_931);
    let t66 = t65 - t16;
    let t67 = piece_1_omega - piece_2_omega;
    let t68 = t67 * R::literal(67.645_133_505_598_62);
    let t69 = t68 - t15;
    let t70 = -load_1_resistance;
    let t71 = t70 - t66;
    let t72 = t71 - t69;
    let t73 = piece_2_phi_relative - piece_3_phi_relative;
    let t74 = t73 * R::literal(3_382_256.675_279_931);
    let t75 = t74 - t65;
    let t76 = piece_2_omega - piece_3_omega;
    let t77 = t76 * R::literal(67.645_133_505_598_62);
    let t78 = t77 - t68;
    let t79 = -load_2_resistance;
    let t80 = t79 - t75;
    let t81 = t80 - t78;
    let t82 = piece_3_phi_relative - piece_4_phi_relative;
    let t83 = t82 * R::literal(3_382_256.675_279_931);
    let t84 = t83 - t74;
    let t85 = piece_3_omega - piece_4_omega;
    let t86 = t85 * R::literal(67.645_133_505_598_62);
    let t87 = t86 - t77;
    let t88 = -load_3_resistance;
    let t89 = t88 - t84;
    let t90 = t89 - t87;
    let t91 = piece_4_phi_relative - piece_5_phi_relative;
    let t92 = t91 * R::literal(3_382_256.675_279_931);
    let t93 = t92 - t83;
    let t94 = piece_4_omega - piece_5_omega;
    let t95 = t94 * R::literal(67.645_133_505_598_62);
    let t96 = t95 - t86;
    let t97 = -load_4_resistance;
    let t98 = t97 - t93;
    let t99 = t98 - t96;
    let t100 = piece_5_phi_relative - piece_6_phi_relative;
    let t101 = t100 * R::literal(3_382_256.675_279_931);
    let t102 = t101 - t92;
    let t103 = piece_5_omega - piece_6_omega;
    let t104 = t103 * R::literal(67.645_133_505_598_62);
    let t105 = t104 - t95;
    let t106 = -load_5_resistance;
    let t107 = t106 - t102;
    let t108 = t107 - t105;
    let t109 = piece_6_phi_relative - piece_7_phi_relative;
    let t110 = t109 * R::literal(3_382_256.675_279_931);
    let t111 = t110 - t101;
    let t112 = piece_6_omega - piece_7_omega;
    let t113 = t112 * R::literal(67.645_133_505_598_62);
    let t114 = t113 - t104;
    let t115 = -load_6_resistance;
    let t116 = t115 - t111;
    let t117 = t116 - t114;
    let t118 = piece_7_phi_relative - piece_8_phi_relative;
    let t119 = t118 * R::literal(3_382_256.675_279_931);
    let t120 = t119 - t110;
    let t121 = piece_7_omega - piece_8_omega;
    let t122 = t121 * R::literal(67.645_133_505_598_62);
    let t123 = t122 - t113;
    let t124 = -load_7_resistance;
    let t125 = t124 - t120;
    let t126 = t125 - t123;
    let t127 = piece_8_phi_relative - piece_9_phi_relative;
    let t128 = t127 * R::literal(3_382_256.675_279_931);
    let t129 = t128 - t119;
    let t130 = piece_8_omega - piece_9_omega;
    let t131 = t130 * R::literal(67.645_133_505_598_62);
    let t132 = t131 - t122;
    let t133 = -load_8_resistance;
    let t134 = t133 - t129;
    let t135 = t134 - t132;
    let t136 = piece_9_phi_relative * R::literal(3_382_256.675_279_931);
    let t137 = t136 - t128;
    let t138 = piece_9_omega - piece_10_omega;
    let t139 = t138 * R::literal(67.645_133_505_598_62);
    let t140 = t139 - t131;
    let t141 = -load_9_resistance;
    let t142 = t141 - t137;
    let t143 = t142 - t140;
    let t144 = t139 + t136;
    let t145 = t144 - load_10_resistance;
    let piece_10_omega_dot = t145 * R::literal(8.038_585_209_003_216);
    let piece_9_omega_dot = t143 * R::literal(8.038_585_209_003_216);
    let piece_8_omega_dot = t135 * R::literal(8.038_585_209_003_216);
    let piece_7_omega_dot = t126 * R::literal(8.038_585_209_003_216);
    let piece_6_omega_dot = t117 * R::literal(8.038_585_209_003_216);
    let piece_5_omega_dot = t108 * R::literal(8.038_585_209_003_216);
    let piece_4_omega_dot = t99 * R::literal(8.038_585_209_003_216);
    let piece_3_omega_dot = t90 * R::literal(8.038_585_209_003_216);
    let piece_2_omega_dot = t81 * R::literal(8.038_585_209_003_216);
    let piece_1_omega_dot = t72 * R::literal(8.038_585_209_003_216);
    let motor_omega_dot = t63 * R::literal(0.238_095_238_095_238_08);
    let t146 = t2 * R::literal(36.128_315_516_282_626);
    let t147 = motor_psi_sy * R::literal(314.159_265_358_979_3);
    let t148 = R::literal(311.126_983_722_080_9) + t147;
    let motor_psi_sx_dot = t148 - t146;
    let t149 = motor_psi_sx * R::literal(314.159_265_358_979_3);
    let t150 = t4 * R::literal(36.128_315_516_282_626);
    let t151 = -t149;
    let motor_psi_sy_dot = t151 - t150;
    let t152 = t5 - motor_psi_rx;
    let t153 = t152 * R::literal(26.954_864_967_800_425);
    let t154 = motor_psi_ry * motor_slip_speed;
    let motor_psi_rx_dot = t153 + t154;
    let t155 = motor_psi_rx * motor_slip_speed;
    let t156 = t6 - motor_psi_ry;
    let t157 = t156 * R::literal(26.954_864_967_800_425);
    let motor_psi_ry_dot = t157 - t155;
    let t158 = motor_omega - piece_10_omega;
    let t159 = piece_1_omega - piece_10_omega;
    let t160 = piece_2_omega - piece_10_omega;
    let t161 = piece_3_omega - piece_10_omega;
    let t162 = piece_4_omega - piece_10_omega;
    let t163 = piece_5_omega - piece_10_omega;
    let t164 = piece_6_omega - piece_10_omega;
    let t165 = piece_7_omega - piece_10_omega;
    let t166 = piece_8_omega - piece_10_omega;
    let t8_slope = R::literal(1.0) * R::literal(50.0);
    let t9_slope = -t8_slope;
    let inverse_t11 = R::literal(1.0) / t11;
    let mut t10_before = t10;
    let mut t18_before = t18;
    let mut t19_before = t19;
    let mut rates = [
        t158,
        t159,
        t160,
        t161,
        t162,
        t163,
        t164,
        t165,
        t166,
        t138,
        motor_omega_dot,
        piece_1_omega_dot,
        piece_2_omega_dot,
        piece_3_omega_dot,
        piece_4_omega_dot,
        piece_5_omega_dot,
        piece_6_omega_dot,
        piece_7_omega_dot,
        piece_8_omega_dot,
        piece_9_omega_dot,
        piece_10_omega_dot,
        motor_psi_sx_dot,
        motor_psi_sy_dot,
        motor_psi_rx_dot,
        motor_psi_ry_dot,
        piece_10_omega,
    ];
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
        piece_3_omega_k, piece_4_omega_k, piece_5_omega_k, piece_6_omega_k,
        piece_7_omega_k, piece_8_omega_k, piece_9_omega_k, piece_10_omega_k,
        motor_psi_sx_k, motor_psi_sy_k, motor_psi_rx_k, motor_psi_ry_k, ..] = *state_k;
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
        let t10_k = inverse * t9_slope * t10_before;
        let load_1_engagement_k = -t10_k.mul_add(load_1_engagement, sums_3[2])
            * inverse_t11;
        let t12_k = motor_psi_sx
            .mul_add(motor_psi_ry_k, motor_psi_ry.mul_add(motor_psi_sx_k, sums[0]));
        let t13_k = motor_psi_sy
            .mul_add(motor_psi_rx_k, motor_psi_rx.mul_add(motor_psi_sy_k, sums[1]));
        let t14_k = t13_k - t12_k;
        let t15_k = coupling_twist_rate_k * R::literal(128.5346);
        let t16_k = coupling_twist_k * R::literal(23065.2);
        let coupling_torque_k = t15_k + t16_k;
        let t18_k = inverse * R::literal(241.805_307_826_689_27) * t19_before;
        let t19_k = -inverse * R::literal(241.805_307_826_689_27) * t18_before;
        let t22_k = piece_1_omega_k * R::literal(2.0);
        let t23_k = t22_k.mul_add(t25, inverse * sums_4[0]);
        let t24_k = (t23 + t23).mul_add(t23_k, sums[2]);
        let t25_k = -t24_k;
        let t26_k = load_1_engagement
            .mul_add(
                t18_k * R::literal(7.878),
                t21.mul_add(load_1_engagement_k, sums_3[3]),
            );
        let load_1_resistance_k = t23.mul_add(t26_k, t26.mul_add(t23_k, sums_4[1]));
        let t27_k = piece_2_omega_k * R::literal(2.0);
        let t28_k = t27_k.mul_add(t30, inverse * sums_4[2]);
        let t29_k = (t28 + t28).mul_add(t28_k, sums[3]);
        let t30_k = -t29_k;
        let load_2_resistance_k = t28.mul_add(t26_k, t26.mul_add(t28_k, sums_4[3]));
        let t31_k = piece_3_omega_k * R::literal(2.0);
        let t32_k = t31_k.mul_add(t34, inverse * sums_5[0]);
        let t33_k = (t32 + t32).mul_add(t32_k, sums_1[0]);
        let t34_k = -t33_k;
        let load_3_resistance_k = t32.mul_add(t26_k, t26.mul_add(t32_k, sums_5[1]));
        let t35_k = piece_4_omega_k * R::literal(2.0);
        let t36_k = t35_k.mul_add(t38, inverse * sums_5[2]);
        let t37_k = (t36 + t36).mul_add(t36_k, sums_1[1]);
        let t38_k = -t37_k;
        let load_4_resistance_k = t36.mul_add(t26_k, t26.mul_add(t36_k, sums_5[3]));
        let t39_k = piece_5_omega_k * R::literal(2.0);
        let t40_k = t39_k.mul_add(t42, inverse * sums_6[0]);
        let t41_k = (t40 + t40).mul_add(t40_k, sums_1[2]);
        let t42_k = -t41_k;
        let load_5_resistance_k = t40.mul_add(t26_k, t26.mul_add(t40_k, sums_6[1]));
        let t43_k = piece_6_omega_k * R::literal(2.0);
        let t44_k = t43_k.mul_add(t46, inverse * sums_6[2]);
        let t45_k = (t44 + t44).mul_add(t44_k, sums_1[3]);
        let t46_k = -t45_k;
        let load_6_resistance_k = t44.mul_add(t26_k, t26.mul_add(t44_k, sums_6[3]));
        let t47_k = piece_7_omega_k * R::literal(2.0);
        let t48_k = t47_k.mul_add(t50, inverse * sums_7[0]);
        let t49_k = (t48 + t48).mul_add(t48_k, sums_2[0]);
        let t50_k = -t49_k;
        let load_7_resistance_k = t48.mul_add(t26_k, t26.mul_add(t48_k, sums_7[1]));
        let t51_k = piece_8_omega_k * R::literal(2.0);
        let t52_k = t51_k.mul_add(t54, inverse * sums_7[2]);
        let t53_k = (t52 + t52).mul_add(t52_k, sums_2[1]);
        let t54_k = -t53_k;
        let load_8_resistance_k = t52.mul_add(t26_k, t26.mul_add(t52_k, sums_7[3]));
        let t55_k = piece_9_omega_k * R::literal(2.0);
        let t56_k = t55_k.mul_add(t58, inverse * sums_8[0]);
        let t57_k = (t56 + t56).mul_add(t56_k, sums_2[2]);
        let t58_k = -t57_k;
        let load_9_resistance_k = t56.mul_add(t26_k, t26.mul_add(t56_k, sums_8[1]));
        let t59_k = piece_10_omega_k * R::literal(2.0);
        let t60_k = t59_k.mul_add(t62, inverse * sums_8[2]);
        let t61_k = (t60 + t60).mul_add(t60_k, sums_2[3]);
        let t62_k = -t61_k;
        let load_10_resistance_k = t60.mul_add(t26_k, t26.mul_add(t60_k, sums_8[3]));
        let t63_k = t14_k.mul_add(R::literal(4_822.097_783_227_635), -coupling_torque_k);
        let t64_k = piece_1_phi_relative_k - piece_2_phi_relative_k;
        let t65_k = t64_k * R::literal(3_382_256.675_279_931);
        let t66_k = t65_k - t16_k;
        let t67_k = piece_1_omega_k - piece_2_omega_k;
        let t68_k = t67_k * R::literal(67.645_133_505_598_62);
        let t69_k = t68_k - t15_k;
        let t70_k = -load_1_resistance_k;
        let t71_k = t70_k - t66_k;
        let t72_k = t71_k - t69_k;
        let t73_k = piece_2_phi_relative_k - piece_3_phi_relative_k;
        let t74_k = t73_k * R::literal(3_382_256.675_279_931);
        let t75_k = t74_k - t65_k;
        let t76_k = piece_2_omega_k - piece_3_omega_k;
        let t77_k = t76_k * R::literal(67.645_133_505_598_62);
        let t78_k = t77_k - t68_k;
        let t79_k = -load_2_resistance_k;
        let t80_k = t79_k - t75_k;
        let t81_k = t80_k - t78_k;
        let t82_k = piece_3_phi_relative_k - piece_4_phi_relative_k;
        let t83_k = t82_k * R::literal(3_382_256.675_279_931);
        let t84_k = t83_k - t74_k;
        let t85_k = piece_3_omega_k - piece_4_omega_k;
        let t86_k = t85_k * R::literal(67.645_133_505_598_62);
        let t87_k = t86_k - t77_k;
        let t88_k = -load_3_resistance_k;
        let t89_k = t88_k - t84_k;
        let t90_k = t89_k - t87_k;
        let t91_k = piece_4_phi_relative_k - piece_5_phi_relative_k;
        let t92_k = t91_k * R::literal(3_382_256.675_279_931);
        let t93_k = t92_k - t83_k;
        let t94_k = piece_4_omega_k - piece_5_omega_k;
        let t95_k = t94_k * R::literal(67.645_133_505_598_62);
        let t96_k = t95_k - t86_k;
        let t97_k = -load_4_resistance_k;
        let t98_k = t97_k - t93_k;
        let t99_k = t98_k - t96_k;
        let t100_k = piece_5_phi_relative_k - piece_6_phi_relative_k;
        let t101_k = t100_k * R::literal(3_382_256.675_279_931);
        let t102_k = t101_k - t92_k;
        let t103_k = piece_5_omega_k - piece_6_omega_k;
        let t104_k = t103_k * R::literal(67.645_133_505_598_62);
        let t105_k = t104_k - t95_k;
        let t106_k = -load_5_resistance_k;
        let t107_k = t106_k - t102_k;
        let t108_k = t107_k - t105_k;
        let t109_k = piece_6_phi_relative_k - piece_7_phi_relative_k;
        let t110_k = t109_k * R::literal(3_382_256.675_279_931);
        let t111_k = t110_k - t101_k;
        let t112_k = piece_6_omega_k - piece_7_omega_k;
        let t113_k = t112_k * R::literal(67.645_133_505_598_62);
        let t114_k = t113_k - t104_k;
        let t115_k = -load_6_resistance_k;
        let t116_k = t115_k - t111_k;
        let t117_k = t116_k - t114_k;
        let t118_k = piece_7_phi_relative_k - piece_8_phi_relative_k;
        let t119_k = t118_k * R::literal(3_382_256.675_279_931);
        let t120_k = t119_k - t110_k;
        let t121_k = piece_7_omega_k - piece_8_omega_k;
        let t122_k = t121_k * R::literal(67.645_133_505_598_62);
        let t123_k = t122_k - t113_k;
        let t124_k = -load_7_resistance_k;
        let t125_k = t124_k - t120_k;
        let t126_k = t125_k - t123_k;
        let t127_k = piece_8_phi_relative_k - piece_9_phi_relative_k;
        let t128_k = t127_k * R::literal(3_382_256.675_279_931);
        let t129_k = t128_k - t119_k;
        let t130_k = piece_8_omega_k - piece_9_omega_k;
        let t131_k = t130_k * R::literal(67.645_133_505_598_62);
        let t132_k = t131_k - t122_k;
        let t133_k = -load_8_resistance_k;
        let t134_k = t133_k - t129_k;
        let t135_k = t134_k - t132_k;
        let t136_k = piece_9_phi_relative_k * R::literal(3_382_256.675_279_931);
        let t137_k = t136_k - t128_k;
        let t138_k = piece_9_omega_k - piece_10_omega_k;
        let t139_k = t138_k * R::literal(67.645_133_505_598_62);
        let t140_k = t139_k - t131_k;
        let t141_k = -load_9_resistance_k;
        let t142_k = t141_k - t137_k;
        let t143_k = t142_k - t140_k;
        let t144_k = t139_k + t136_k;
        let t145_k = t144_k - load_10_resistance_k;
        let piece_10_omega_dot_k = t145_k * R::literal(8.038_585_209_003_216);
        let piece_9_omega_dot_k = t143_k * R::literal(8.038_585_209_003_216);
        let piece_8_omega_dot_k = t135_k * R::literal(8.038_585_209_003_216);
        let piece_7_omega_dot_k = t126_k * R::literal(8.038_585_209_003_216);
        let piece_6_omega_dot_k = t117_k * R::literal(8.038_585_209_003_216);
        let piece_5_omega_dot_k = t108_k * R::literal(8.038_585_209_003_216);
        let piece_4_omega_dot_k = t99_k * R::literal(8.038_585_209_003_216);
        let piece_3_omega_dot_k = t90_k * R::literal(8.038_585_209_003_216);
        let piece_2_omega_dot_k = t81_k * R::literal(8.038_585_209_003_216);
        let piece_1_omega_dot_k = t72_k * R::literal(8.038_585_209_003_216);
        let motor_omega_dot_k = t63_k * R::literal(0.238_095_238_095_238_08);
        let motor_psi_sx_dot_k = (-t2_k)
            .mul_add(
                R::literal(36.128_315_516_282_626),
                motor_psi_sy_k * R::literal(314.159_265_358_979_3),
            );
        let t149_k = motor_psi_sx_k * R::literal(314.159_265_358_979_3);
        let t151_k = -t149_k;
        let motor_psi_sy_dot_k = (-t4_k)
            .mul_add(R::literal(36.128_315_516_282_626), t151_k);
        let t152_k = motor_psi_sx_k.mul_add(R::literal(0.956), -motor_psi_rx_k);
        let t154_k = motor_psi_ry
            .mul_add(
                motor_slip_speed_k,
                motor_slip_speed.mul_add(motor_psi_ry_k, sums_3[0]),
            );
        let motor_psi_rx_dot_k = t152_k
            .mul_add(R::literal(26.954_864_967_800_425), t154_k);
        let t155_k = motor_psi_rx
            .mul_add(
                motor_slip_speed_k,
                motor_slip_speed.mul_add(motor_psi_rx_k, sums_3[1]),
            );
        let t156_k = motor_psi_sy_k.mul_add(R::literal(0.956), -motor_psi_ry_k);
        let motor_psi_ry_dot_k = t156_k
            .mul_add(R::literal(26.954_864_967_800_425), -t155_k);
        let t158_k = motor_omega_k - piece_10_omega_k;
        let t159_k = piece_1_omega_k - piece_10_omega_k;
        let t160_k = piece_2_omega_k - piece_10_omega_k;
        let t161_k = piece_3_omega_k - piece_10_omega_k;
        let t162_k = piece_4_omega_k - piece_10_omega_k;
        let t163_k = piece_5_omega_k - piece_10_omega_k;
        let t164_k = piece_6_omega_k - piece_10_omega_k;
        let t165_k = piece_7_omega_k - piece_10_omega_k;
        let t166_k = piece_8_omega_k - piece_10_omega_k;
        lanes
            .set(
                order,
                [motor_psi_sx_k, motor_psi_rx_k, t23_k, t28_k],
                [motor_psi_ry_k, motor_psi_sy_k, t23_k, t28_k],
            );
        lanes_1.set(order, [t32_k, t36_k, t40_k, t44_k], [t32_k, t36_k, t40_k, t44_k]);
        lanes_2.set(order, [t48_k, t52_k, t56_k, t60_k], [t48_k, t52_k, t56_k, t60_k]);
        lanes_3
            .set(
                order,
                [motor_slip_speed_k, motor_slip_speed_k, t10_k, load_1_engagement_k],
                [
                    motor_psi_ry_k,
                    motor_psi_rx_k,
                    load_1_engagement_k,
                    t18_k * R::literal(7.878),
                ],
            );
        lanes_4
            .set(
                order,
                [k * t22_k, t23_k, k * t27_k, t26_k],
                [t25_k, t26_k, t30_k, t28_k],
            );
        lanes_5
            .set(
                order,
                [k * t31_k, t26_k, k * t35_k, t26_k],
                [t34_k, t32_k, t38_k, t36_k],
            );
        lanes_6
            .set(
                order,
                [k * t39_k, t26_k, k * t43_k, t26_k],
                [t42_k, t40_k, t46_k, t44_k],
            );
        lanes_7
            .set(
                order,
                [k * t47_k, t26_k, k * t51_k, t26_k],
                [t50_k, t48_k, t54_k, t52_k],
            );
        lanes_8
            .set(
                order,
                [k * t55_k, t26_k, k * t59_k, t26_k],
                [t58_k, t56_k, t62_k, t60_k],
            );
        t10_before = t10_k;
        t18_before = t18_k;
        t19_before = t19_k;
        rates = [
            t158_k,
            t159_k,
            t160_k,
            t161_k,
            t162_k,
            t163_k,
            t164_k,
            t165_k,
            t166_k,
            t138_k,
            motor_omega_dot_k,
            piece_1_omega_dot_k,
            piece_2_omega_dot_k,
            piece_3_omega_dot_k,
            piece_4_omega_dot_k,
            piece_5_omega_dot_k,
            piece_6_omega_dot_k,
            piece_7_omega_dot_k,
            piece_8_omega_dot_k,
            piece_9_omega_dot_k,
            piece_10_omega_dot_k,
            motor_psi_sx_dot_k,
            motor_psi_sy_dot_k,
            motor_psi_rx_dot_k,
            motor_psi_ry_dot_k,
            piece_10_omega_k,
        ];
    }
}

impl<R: Real> TaylorSeries<R> for M310 {
    fn series_workspace(&self, order: usize) -> usize {
        Lanes::<R, 4>::workspace(order + 1) + Lanes::<R, 4>::workspace(order + 1)
            + Lanes::<R, 4>::workspace(order + 1) + Lanes::<R, 4>::workspace(order + 1)
            + Lanes::<R, 4>::workspace(order + 1) + Lanes::<R, 4>::workspace(order + 1)
            + Lanes::<R, 4>::workspace(order + 1) + Lanes::<R, 4>::workspace(order + 1)
            + Lanes::<R, 4>::workspace(order + 1)
    }
    fn series(
        &self,
        time: R,
        state: &[R],
        parameters: &[R],
        coefficients: &mut [R],
        workspace: &mut [R],
    ) {
        let (coefficients, rest) = coefficients.as_chunks_mut();
        assert!(rest.is_empty(), "every order has STATES coefficients");
        let p = parameters_of(parameters);
        series(time, state_of(state), &p, coefficients, workspace);
    }
    fn bends(&self) -> Bends {
        Bends::Saturates
    }
}

impl Describe for M310 {
    fn name(&self) -> &'static str {
        "m3_10"
    }
    fn title(&self) -> &'static str {
        "Benchmark M3: motor and torsional shaft of 10 pieces"
    }
    fn shape(&self) -> Shape {
        Shape {
            coordinates: COORDINATES,
            positions: 11,
            first_order: 4,
            quadratures: 1,
            parameters: PARAMETERS,
            outputs: OUTPUTS,
            discontinuities: DISCONTINUITIES,
        }
    }
    fn state(&self, index: usize) -> Quantity<'_> {
        STATE_QUANTITIES[index]
    }
    fn state_kind(&self, index: usize) -> StateKind {
        STATE_KINDS[index]
    }
    fn coordinate(&self, index: usize) -> Quantity<'_> {
        COORDINATE_QUANTITIES[index]
    }
    fn state_scale(&self, index: usize) -> f64 {
        STATE_SCALES[index]
    }
    fn parameter(&self, index: usize) -> Quantity<'_> {
        PARAMETER_QUANTITIES[index]
    }
    fn parameter_default(&self, index: usize) -> f64 {
        PARAMETER_DEFAULTS[index]
    }
    fn output(&self, index: usize) -> Quantity<'_> {
        OUTPUT_QUANTITIES[index]
    }
    fn rate_jacobian_pattern(&self) -> SparsityPattern<'_> {
        RATE_JACOBIAN_PATTERN
    }
    fn parameter_jacobian_pattern(&self) -> SparsityPattern<'_> {
        PARAMETER_JACOBIAN_PATTERN
    }
    fn mass_matrix_pattern(&self) -> SparsityPattern<'_> {
        MASS_MATRIX_PATTERN
    }
    fn run_defaults(&self) -> RunDefaults<'_> {
        RUN_DEFAULTS
    }
}

impl<R: Real> Simulator<R> for M310 {
    fn initial_state(&self, parameters: &[R], values: &mut [R]) {
        *array_of(values) = initial_state(&parameters_of(parameters));
    }
    fn discontinuities(&self, parameters: &[R], values: &mut [R]) {
        *array_of(values) = discontinuities(&parameters_of(parameters));
    }
    fn rate(&self, time: R, state: &[R], parameters: &[R], values: &mut [R]) {
        *array_of(values) = rate(time, state_of(state), &parameters_of(parameters));
    }
    fn rate_jacobian(&self, time: R, state: &[R], parameters: &[R], values: &mut [R]) {
        *array_of(values) = rate_jacobian(
            time,
            state_of(state),
            &parameters_of(parameters),
        );
    }
    fn parameter_jacobian(
        &self,
        time: R,
        state: &[R],
        parameters: &[R],
        values: &mut [R],
    ) {
        *array_of(values) = parameter_jacobian(
            time,
            state_of(state),
            &parameters_of(parameters),
        );
    }
    fn time_derivative(&self, time: R, state: &[R], parameters: &[R], values: &mut [R]) {
        *array_of(values) = time_derivative(
            time,
            state_of(state),
            &parameters_of(parameters),
        );
    }
    fn mass_matrix(&self, time: R, state: &[R], parameters: &[R], values: &mut [R]) {
        *array_of(values) = mass_matrix(
            time,
            state_of(state),
            &parameters_of(parameters),
        );
    }
    fn forcing(&self, time: R, state: &[R], parameters: &[R], values: &mut [R]) {
        *array_of(values) = forcing(time, state_of(state), &parameters_of(parameters));
    }
    fn outputs(&self, time: R, state: &[R], parameters: &[R], values: &mut [R]) {
        *array_of(values) = outputs(time, state_of(state), &parameters_of(parameters))
            .to_array();
    }
    fn energy(&self, time: R, state: &[R], parameters: &[R]) -> Energy<R> {
        energy(time, state_of(state), &parameters_of(parameters))
    }
    fn power_balance(&self, time: R, state: &[R], parameters: &[R]) -> PowerBalance<R> {
        power_balance(time, state_of(state), &parameters_of(parameters))
    }
    fn taylor(&self) -> Option<&dyn TaylorSeries<R>> {
        Some(self)
    }
}

#[inline]
fn array_of<R, const N: usize>(values: &mut [R]) -> &mut [R; N] {
    values.try_into().expect("there is one place for each value")
}

#[inline]
fn state_of<R>(state: &[R]) -> &[R; STATES] {
    state.try_into().expect("the state has STATES entries")
}

#[inline]
fn parameters_of<R: Real>(parameters: &[R]) -> Parameters<R> {
    let values: &[R; PARAMETERS] = parameters
        .try_into()
        .expect("there are PARAMETERS parameters");
    Parameters::from_array(*values)
}

static STATE_KINDS: [StateKind; STATES] = [
    StateKind::Position,
    StateKind::Position,
    StateKind::Position,
    StateKind::Position,
    StateKind::Position,
    StateKind::Position,
    StateKind::Position,
    StateKind::Position,
    StateKind::Position,
    StateKind::Position,
    StateKind::Velocity,
    StateKind::Velocity,
    StateKind::Velocity,
    StateKind::Velocity,
    StateKind::Velocity,
    StateKind::Velocity,
    StateKind::Velocity,
    StateKind::Velocity,
    StateKind::Velocity,
    StateKind::Velocity,
    StateKind::Velocity,
    StateKind::FirstOrder,
    StateKind::FirstOrder,
    StateKind::FirstOrder,
    StateKind::FirstOrder,
    StateKind::Position,
];

static COORDINATE_QUANTITIES: [Quantity<'static>; COORDINATES] = [
    Quantity {
        name: "motor.phi",
        unit: "rad",
        doc: "rotor angle",
    },
    Quantity {
        name: "piece_1.phi",
        unit: "rad",
        doc: "angle",
    },
    Quantity {
        name: "piece_2.phi",
        unit: "rad",
        doc: "angle",
    },
    Quantity {
        name: "piece_3.phi",
        unit: "rad",
        doc: "angle",
    },
    Quantity {
        name: "piece_4.phi",
        unit: "rad",
        doc: "angle",
    },
    Quantity {
        name: "piece_5.phi",
        unit: "rad",
        doc: "angle",
    },
    Quantity {
        name: "piece_6.phi",
        unit: "rad",
        doc: "angle",
    },
    Quantity {
        name: "piece_7.phi",
        unit: "rad",
        doc: "angle",
    },
    Quantity {
        name: "piece_8.phi",
        unit: "rad",
        doc: "angle",
    },
    Quantity {
        name: "piece_9.phi",
        unit: "rad",
        doc: "angle",
    },
    Quantity {
        name: "piece_10.phi",
        unit: "rad",
        doc: "angle",
    },
];

static STATE_QUANTITIES: [Quantity<'static>; STATES] = [
    Quantity {
        name: "motor.phi_relative",
        unit: "rad",
        doc: "rotor angle, relative",
    },
    Quantity {
        name: "piece_1.phi_relative",
        unit: "rad",
        doc: "angle, relative",
    },
    Quantity {
        name: "piece_2.phi_relative",
        unit: "rad",
        doc: "angle, relative",
    },
    Quantity {
        name: "piece_3.phi_relative",
        unit: "rad",
        doc: "angle, relative",
    },
    Quantity {
        name: "piece_4.phi_relative",
        unit: "rad",
        doc: "angle, relative",
    },
    Quantity {
        name: "piece_5.phi_relative",
        unit: "rad",
        doc: "angle, relative",
    },
    Quantity {
        name: "piece_6.phi_relative",
        unit: "rad",
        doc: "angle, relative",
    },
    Quantity {
        name: "piece_7.phi_relative",
        unit: "rad",
        doc: "angle, relative",
    },
    Quantity {
        name: "piece_8.phi_relative",
        unit: "rad",
        doc: "angle, relative",
    },
    Quantity {
        name: "piece_9.phi_relative",
        unit: "rad",
        doc: "angle, relative",
    },
    Quantity {
        name: "motor.omega",
        unit: "rad/s",
        doc: "rate of rotor angle",
    },
    Quantity {
        name: "piece_1.omega",
        unit: "rad/s",
        doc: "rate of angle",
    },
    Quantity {
        name: "piece_2.omega",
        unit: "rad/s",
        doc: "rate of angle",
    },
    Quantity {
        name: "piece_3.omega",
        unit: "rad/s",
        doc: "rate of angle",
    },
    Quantity {
        name: "piece_4.omega",
        unit: "rad/s",
        doc: "rate of angle",
    },
    Quantity {
        name: "piece_5.omega",
        unit: "rad/s",
        doc: "rate of angle",
    },
    Quantity {
        name: "piece_6.omega",
        unit: "rad/s",
        doc: "rate of angle",
    },
    Quantity {
        name: "piece_7.omega",
        unit: "rad/s",
        doc: "rate of angle",
    },
    Quantity {
        name: "piece_8.omega",
        unit: "rad/s",
        doc: "rate of angle",
    },
    Quantity {
        name: "piece_9.omega",
        unit: "rad/s",
        doc: "rate of angle",
    },
    Quantity {
        name: "piece_10.omega",
        unit: "rad/s",
        doc: "rate of angle",
    },
    Quantity {
        name: "motor.psi_sx",
        unit: "V s",
        doc: "stator flux linkage along x",
    },
    Quantity {
        name: "motor.psi_sy",
        unit: "V s",
        doc: "stator flux linkage along y",
    },
    Quantity {
        name: "motor.psi_rx",
        unit: "V s",
        doc: "rotor flux linkage along x",
    },
    Quantity {
        name: "motor.psi_ry",
        unit: "V s",
        doc: "rotor flux linkage along y",
    },
    Quantity {
        name: "piece_10.phi",
        unit: "rad",
        doc: "angle",
    },
];

static STATE_SCALES: [f64; STATES] = [
    1.0,
    1.0,
    1.0,
    1.0,
    1.0,
    1.0,
    1.0,
    1.0,
    1.0,
    1.0,
    78.5,
    78.5,
    78.5,
    78.5,
    78.5,
    78.5,
    78.5,
    78.5,
    78.5,
    78.5,
    78.5,
    1.0,
    1.0,
    1.0,
    1.0,
    150.0,
];

static PARAMETER_QUANTITIES: [Quantity<'static>; PARAMETERS] = [];

static PARAMETER_DEFAULTS: [f64; PARAMETERS] = [];

static OUTPUT_QUANTITIES: [Quantity<'static>; OUTPUTS] = [
    Quantity {
        name: "psi_x1",
        unit: "V s",
        doc: "stator flux linkage along x",
    },
    Quantity {
        name: "psi_y1",
        unit: "V s",
        doc: "stator flux linkage along y",
    },
    Quantity {
        name: "psi_x2",
        unit: "V s",
        doc: "rotor flux linkage along x",
    },
    Quantity {
        name: "psi_y2",
        unit: "V s",
        doc: "rotor flux linkage along y",
    },
    Quantity {
        name: "phi_d",
        unit: "rad",
        doc: "rotor angle",
    },
    Quantity {
        name: "w_d",
        unit: "rad/s",
        doc: "rate of rotor angle",
    },
    Quantity {
        name: "phi_1",
        unit: "rad",
        doc: "angle",
    },
    Quantity {
        name: "w_1",
        unit: "rad/s",
        doc: "rate of angle",
    },
    Quantity {
        name: "phi_2",
        unit: "rad",
        doc: "angle",
    },
    Quantity {
        name: "w_2",
        unit: "rad/s",
        doc: "rate of angle",
    },
    Quantity {
        name: "phi_3",
        unit: "rad",
        doc: "angle",
    },
    Quantity {
        name: "w_3",
        unit: "rad/s",
        doc: "rate of angle",
    },
    Quantity {
        name: "phi_4",
        unit: "rad",
        doc: "angle",
    },
    Quantity {
        name: "w_4",
        unit: "rad/s",
        doc: "rate of angle",
    },
    Quantity {
        name: "phi_5",
        unit: "rad",
        doc: "angle",
    },
    Quantity {
        name: "w_5",
        unit: "rad/s",
        doc: "rate of angle",
    },
    Quantity {
        name: "phi_6",
        unit: "rad",
        doc: "angle",
    },
    Quantity {
        name: "w_6",
        unit: "rad/s",
        doc: "rate of angle",
    },
    Quantity {
        name: "phi_7",
        unit: "rad",
        doc: "angle",
    },
    Quantity {
        name: "w_7",
        unit: "rad/s",
        doc: "rate of angle",
    },
    Quantity {
        name: "phi_8",
        unit: "rad",
        doc: "angle",
    },
    Quantity {
        name: "w_8",
        unit: "rad/s",
        doc: "rate of angle",
    },
    Quantity {
        name: "phi_9",
        unit: "rad",
        doc: "angle",
    },
    Quantity {
        name: "w_9",
        unit: "rad/s",
        doc: "rate of angle",
    },
    Quantity {
        name: "phi_10",
        unit: "rad",
        doc: "angle",
    },
    Quantity {
        name: "w_10",
        unit: "rad/s",
        doc: "rate of angle",
    },
];

/// The run the spec asks for.
pub const RUN_DEFAULTS: RunDefaults<'static> = RunDefaults {
    from: 0.0,
    until: 0.5,
    points: 501,
    rtol: 1e-8,
    method: "auto",
};

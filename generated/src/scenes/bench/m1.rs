// Emitted by Machinist 0.1.0; do not edit. To make it again:
//
//     cargo run --release -- gen
//
// Sources, with SHA-256:
//   290c280f2762536a930aee55683f4ed2f3b53337119f1515f76d518b01eb9bd0  bench/m1.toml
//   fe2f2deb5f36655ff87e1d6f2bb763716b1c76007878e37e8e41643655074862  units/induction_motor.toml
//
// Benchmark M1: induction motor alone
//
// From rest to synchronous speed in about 0.8 s.
//
// Source:
//   Benchmark models of textile-machine dynamics.
//
// Shapes; all quantities are in SI units:
//   coordinates               1
//   first-order states        4
//   states                    5
//   parameters                0
//   outputs                   5
//   discontinuities           0
//
// State:
//     0  motor.omega   [rad/s]  rate of rotor angle
//     1  motor.psi_sx  [V s]    stator flux linkage along x
//     2  motor.psi_sy  [V s]    stator flux linkage along y
//     3  motor.psi_rx  [V s]    rotor flux linkage along x
//     4  motor.psi_ry  [V s]    rotor flux linkage along y
//
// Nonzeros:
//   mass_matrix               1 of 1 by 1
//   rate_jacobian            18 of 5 by 5
//   parameter_jacobian        0 of 5 by 0
//
// Operations:
//   initial_state             0
//   discontinuities           0
//   rate                     31
//   mass_matrix               0
//   forcing                   4
//   rate_jacobian            12
//   parameter_jacobian        0
//   time_derivative           0
//   outputs                   0
//   energy                   22
//   power_balance            76

use ::machinist_contract::{
    Describe, Energy, PowerBalance, Quantity, Real, RunDefaults, Shape, Simulator,
    SparsityPattern, StateKind, taylor::{Lanes, TaylorSeries, order_and_inverse},
};

/// Generalized coordinates, n.
pub const COORDINATES: usize = 1;

/// Length of the state y.
pub const STATES: usize = 5;

/// Parameters.
pub const PARAMETERS: usize = 0;

/// Wanted outputs.
pub const OUTPUTS: usize = 5;

/// Times at which the right-hand side jumps.
pub const DISCONTINUITIES: usize = 0;

/// Nonzeros of M, both triangles.
pub const MASS_MATRIX_PATTERN: SparsityPattern<'static> = SparsityPattern {
    rows: 1,
    columns: 1,
    entries: &[(0, 0)],
};

/// Nonzeros of dy'/dy.
pub const RATE_JACOBIAN_PATTERN: SparsityPattern<'static> = SparsityPattern {
    rows: 5,
    columns: 5,
    entries: &[
        (0, 1), (0, 2), (0, 3), (0, 4), (1, 1), (1, 2), (1, 3), (2, 1), (2, 2), (2, 4), (3, 0),
        (3, 1), (3, 3), (3, 4), (4, 0), (4, 2), (4, 3), (4, 4),
    ],
};

/// Nonzeros of dy'/dp.
pub const PARAMETER_JACOBIAN_PATTERN: SparsityPattern<'static> = SparsityPattern {
    rows: 5,
    columns: 0,
    entries: &[],
};

/// Benchmark M1: induction motor alone
///
/// From rest to synchronous speed in about 0.8 s.
///
/// Source: Benchmark models of textile-machine dynamics.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct M1;

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
    /// w: rate of rotor angle \[rad/s\].
    pub w: R,
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
            w: values[4],
        }
    }
    /// The numbers in their order.
    #[must_use]
    #[inline]
    pub fn to_array(self) -> [R; OUTPUTS] {
        [self.psi_x1, self.psi_y1, self.psi_x2, self.psi_y2, self.w]
    }
}

/// Where to find what in the state.
pub mod state {
    /// motor.omega: rate of rotor angle \[rad/s\].
    pub const MOTOR_OMEGA: usize = 0;
    /// motor.psi_sx: stator flux linkage along x \[V s\].
    pub const MOTOR_PSI_SX: usize = 1;
    /// motor.psi_sy: stator flux linkage along y \[V s\].
    pub const MOTOR_PSI_SY: usize = 2;
    /// motor.psi_rx: rotor flux linkage along x \[V s\].
    pub const MOTOR_PSI_RX: usize = 3;
    /// motor.psi_ry: rotor flux linkage along y \[V s\].
    pub const MOTOR_PSI_RY: usize = 4;
}

/// State at the start of the run, in the units of the states.
///
/// No operations.
#[must_use]
pub fn initial_state<R: Real>(_p: &Parameters<R>) -> [R; STATES] {
    [R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0)]
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
/// 31 operations.
#[must_use]
#[inline]
pub fn rate<R: Real>(_time: R, state: &[R; STATES], _p: &Parameters<R>) -> [R; STATES] {
    let [motor_omega, motor_psi_sx, motor_psi_sy, motor_psi_rx, motor_psi_ry] = *state;
    let motor_slip_speed = R::literal(314.159_265_358_979_3)
        .sub_product(R::literal(4.0), motor_omega);
    let motor_i_sx = R::literal(844.204_793_982_429_1)
        * motor_psi_sx.sub_product(R::literal(0.952), motor_psi_rx);
    let motor_i_sy = R::literal(844.204_793_982_429_1)
        * motor_psi_sy.sub_product(R::literal(0.952), motor_psi_ry);
    let motor_torque = R::literal(4_822.097_783_227_635)
        * (motor_psi_sy * motor_psi_rx).sub_product(motor_psi_sx, motor_psi_ry);
    let motor_omega_dot = motor_torque * R::literal(0.238_095_238_095_238_08);
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
    [
        motor_omega_dot,
        motor_psi_sx_dot,
        motor_psi_sy_dot,
        motor_psi_rx_dot,
        motor_psi_ry_dot,
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
) -> [R; 1] {
    [R::literal(4.2)]
}

/// `f` of `M q'' = f(q, q', z, t)`, one for each coordinate.
///
/// 4 operations.
#[must_use]
pub fn forcing<R: Real>(
    _time: R,
    state: &[R; STATES],
    _p: &Parameters<R>,
) -> [R; COORDINATES] {
    let [_, motor_psi_sx, motor_psi_sy, motor_psi_rx, motor_psi_ry] = *state;
    let motor_torque = R::literal(4_822.097_783_227_635)
        * (motor_psi_sy * motor_psi_rx).sub_product(motor_psi_sx, motor_psi_ry);
    [motor_torque]
}

/// `dy'/dy`, values in the order of `RATE_JACOBIAN_PATTERN`.
///
/// 12 operations.
#[must_use]
pub fn rate_jacobian<R: Real>(
    _time: R,
    state: &[R; STATES],
    _p: &Parameters<R>,
) -> [R; 18] {
    let [motor_omega, motor_psi_sx, motor_psi_sy, motor_psi_rx, motor_psi_ry] = *state;
    let t0 = R::literal(4.0) * motor_omega;
    let motor_slip_speed = R::literal(314.159_265_358_979_3) - t0;
    let motor_psi_rx_dot_by_motor_omega = -(R::literal(4.0) * motor_psi_ry);
    let motor_psi_ry_dot_by_motor_omega = R::literal(4.0) * motor_psi_rx;
    let motor_omega_dot_by_motor_psi_sx = -(R::literal(1_148.118_519_816_103_6)
        * motor_psi_ry);
    let motor_omega_dot_by_motor_psi_sy = R::literal(1_148.118_519_816_103_6)
        * motor_psi_rx;
    let motor_omega_dot_by_motor_psi_rx = R::literal(1_148.118_519_816_103_6)
        * motor_psi_sy;
    let motor_psi_ry_dot_by_motor_psi_rx = t0 - R::literal(314.159_265_358_979_3);
    let motor_omega_dot_by_motor_psi_ry = -(R::literal(1_148.118_519_816_103_6)
        * motor_psi_sx);
    [
        motor_omega_dot_by_motor_psi_sx,
        motor_omega_dot_by_motor_psi_sy,
        motor_omega_dot_by_motor_psi_rx,
        motor_omega_dot_by_motor_psi_ry,
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
/// No operations.
#[must_use]
pub fn time_derivative<R: Real>(
    _time: R,
    _state: &[R; STATES],
    _p: &Parameters<R>,
) -> [R; STATES] {
    [R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0)]
}

/// Wanted outputs.
///
/// No operations.
#[must_use]
pub fn outputs<R: Real>(
    _time: R,
    state: &[R; STATES],
    _p: &Parameters<R>,
) -> Outputs<R> {
    let [motor_omega, motor_psi_sx, motor_psi_sy, motor_psi_rx, motor_psi_ry] = *state;
    Outputs {
        psi_x1: motor_psi_sx,
        psi_y1: motor_psi_sy,
        psi_x2: motor_psi_rx,
        psi_y2: motor_psi_ry,
        w: motor_omega,
    }
}

/// T, V and the energy of first-order states \[J\].
///
/// 22 operations.
#[must_use]
pub fn energy<R: Real>(_time: R, state: &[R; STATES], _p: &Parameters<R>) -> Energy<R> {
    let [motor_omega, motor_psi_sx, motor_psi_sy, motor_psi_rx, motor_psi_ry] = *state;
    let motor_i_sx = R::literal(844.204_793_982_429_1)
        * motor_psi_sx.sub_product(R::literal(0.952), motor_psi_rx);
    let motor_i_sy = R::literal(844.204_793_982_429_1)
        * motor_psi_sy.sub_product(R::literal(0.952), motor_psi_ry);
    let motor_i_rx = R::literal(840.672_556_350_703_5)
        * motor_psi_rx.sub_product(R::literal(0.956), motor_psi_sx);
    let motor_i_ry = R::literal(840.672_556_350_703_5)
        * motor_psi_ry.sub_product(R::literal(0.956), motor_psi_sy);
    Energy {
        kinetic: R::literal(2.1) * (motor_omega * motor_omega),
        potential: R::literal(0.0),
        stored: R::literal(0.75)
            * (motor_psi_sx * motor_i_sx)
                .add_product(motor_psi_sy, motor_i_sy)
                .add_product(motor_psi_rx, motor_i_rx)
                .add_product(motor_psi_ry, motor_i_ry),
    }
}

/// `dE/dt`, power supplied and power dissipated \[W\].
///
/// 76 operations.
#[must_use]
pub fn power_balance<R: Real>(
    _time: R,
    state: &[R; STATES],
    _p: &Parameters<R>,
) -> PowerBalance<R> {
    let [motor_omega, motor_psi_sx, motor_psi_sy, motor_psi_rx, motor_psi_ry] = *state;
    let motor_slip_speed = R::literal(314.159_265_358_979_3)
        .sub_product(R::literal(4.0), motor_omega);
    let motor_i_sx = R::literal(844.204_793_982_429_1)
        * motor_psi_sx.sub_product(R::literal(0.952), motor_psi_rx);
    let motor_i_sy = R::literal(844.204_793_982_429_1)
        * motor_psi_sy.sub_product(R::literal(0.952), motor_psi_ry);
    let t0 = R::literal(0.956) * motor_psi_sx;
    let motor_i_rx = R::literal(840.672_556_350_703_5) * (motor_psi_rx - t0);
    let t1 = R::literal(0.956) * motor_psi_sy;
    let motor_i_ry = R::literal(840.672_556_350_703_5) * (motor_psi_ry - t1);
    let motor_torque = R::literal(4_822.097_783_227_635)
        * (motor_psi_sy * motor_psi_rx).sub_product(motor_psi_sx, motor_psi_ry);
    let motor_omega_dot = motor_torque * R::literal(0.238_095_238_095_238_08);
    let motor_psi_sx_dot = R::literal(311.126_983_722_080_9)
        .add_product(R::literal(314.159_265_358_979_3), motor_psi_sy)
        .sub_product(R::literal(0.042_795_676_8), motor_i_sx);
    let motor_psi_sy_dot = (-(R::literal(314.159_265_358_979_3) * motor_psi_sx))
        .sub_product(R::literal(0.042_795_676_8), motor_i_sy);
    let motor_psi_rx_dot = (R::literal(26.954_864_967_800_425) * (t0 - motor_psi_rx))
        .add_product(motor_psi_ry, motor_slip_speed);
    let motor_psi_ry_dot = (R::literal(26.954_864_967_800_425) * (t1 - motor_psi_ry))
        .sub_product(motor_psi_rx, motor_slip_speed);
    PowerBalance {
        stored_rate: (R::literal(4.2) * motor_omega * motor_omega_dot)
            .add_product(
                R::literal(0.75)
                    * motor_i_sx
                        .add_product(R::literal(844.204_793_982_429_1), motor_psi_sx)
                        .sub_product(R::literal(803.682_963_871_272_6), motor_psi_rx),
                motor_psi_sx_dot,
            )
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
        supplied: R::literal(466.690_475_583_121_4) * motor_i_sx,
        dissipated: R::literal(1.5)
            * (R::literal(0.032_063_452_962_957_98)
                * (motor_i_rx * motor_i_rx).add_product(motor_i_ry, motor_i_ry))
                .add_product(
                    R::literal(0.042_795_676_8),
                    (motor_i_sx * motor_i_sx).add_product(motor_i_sy, motor_i_sy),
                ),
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
pub fn series<R: Real>(
    _time: R,
    state: &[R; STATES],
    _p: &Parameters<R>,
    coefficients: &mut [[R; STATES]],
    workspace: &mut [R],
) {
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
    let t13 = motor_psi_sx * R::literal(314.159_265_358_979_3);
    let t14 = t4 * R::literal(36.128_315_516_282_626);
    let t15 = -t13;
    let motor_psi_sy_dot = t15 - t14;
    let t16 = t5 - motor_psi_rx;
    let t17 = t16 * R::literal(26.954_864_967_800_425);
    let t18 = motor_psi_ry * motor_slip_speed;
    let motor_psi_rx_dot = t17 + t18;
    let t19 = motor_psi_rx * motor_slip_speed;
    let t20 = t6 - motor_psi_ry;
    let t21 = t20 * R::literal(26.954_864_967_800_425);
    let motor_psi_ry_dot = t21 - t19;
    let mut rates = [
        motor_omega_dot,
        motor_psi_sx_dot,
        motor_psi_sy_dot,
        motor_psi_rx_dot,
        motor_psi_ry_dot,
    ];
    coefficients[0] = *state;
    let highest = coefficients.len() - 1;
    for (order, state_k) in coefficients.iter_mut().enumerate().skip(1) {
        let (_, inverse) = order_and_inverse::<R>(order);
        *state_k = rates.map(|rate| rate * inverse);
        if order == highest {
            break;
        }
        let [motor_omega_k, motor_psi_sx_k, motor_psi_sy_k, motor_psi_rx_k,
        motor_psi_ry_k] = *state_k;
        let sums = lanes.sums(order);
        let motor_slip_speed_k = -motor_omega_k * R::literal(4.0);
        let t2_k = (-motor_psi_rx_k).mul_add(R::literal(0.952), motor_psi_sx_k);
        let t4_k = (-motor_psi_ry_k).mul_add(R::literal(0.952), motor_psi_sy_k);
        let t7_k = motor_psi_sx
            .mul_add(motor_psi_ry_k, motor_psi_ry.mul_add(motor_psi_sx_k, sums[0]));
        let t8_k = motor_psi_sy
            .mul_add(motor_psi_rx_k, motor_psi_rx.mul_add(motor_psi_sy_k, sums[1]));
        let t9_k = t8_k - t7_k;
        let motor_omega_dot_k = t9_k * R::literal(1_148.118_519_816_103_6);
        let motor_psi_sx_dot_k = (-t2_k)
            .mul_add(
                R::literal(36.128_315_516_282_626),
                motor_psi_sy_k * R::literal(314.159_265_358_979_3),
            );
        let t13_k = motor_psi_sx_k * R::literal(314.159_265_358_979_3);
        let t15_k = -t13_k;
        let motor_psi_sy_dot_k = (-t4_k)
            .mul_add(R::literal(36.128_315_516_282_626), t15_k);
        let t16_k = motor_psi_sx_k.mul_add(R::literal(0.956), -motor_psi_rx_k);
        let t18_k = motor_psi_ry
            .mul_add(
                motor_slip_speed_k,
                motor_slip_speed.mul_add(motor_psi_ry_k, sums[2]),
            );
        let motor_psi_rx_dot_k = t16_k
            .mul_add(R::literal(26.954_864_967_800_425), t18_k);
        let t19_k = motor_psi_rx
            .mul_add(
                motor_slip_speed_k,
                motor_slip_speed.mul_add(motor_psi_rx_k, sums[3]),
            );
        let t20_k = motor_psi_sy_k.mul_add(R::literal(0.956), -motor_psi_ry_k);
        let motor_psi_ry_dot_k = t20_k
            .mul_add(R::literal(26.954_864_967_800_425), -t19_k);
        lanes
            .set(
                order,
                [motor_psi_sx_k, motor_psi_rx_k, motor_slip_speed_k, motor_slip_speed_k],
                [motor_psi_ry_k, motor_psi_sy_k, motor_psi_ry_k, motor_psi_rx_k],
            );
        rates = [
            motor_omega_dot_k,
            motor_psi_sx_dot_k,
            motor_psi_sy_dot_k,
            motor_psi_rx_dot_k,
            motor_psi_ry_dot_k,
        ];
    }
}

impl<R: Real> TaylorSeries<R> for M1 {
    fn series_workspace(&self, order: usize) -> usize {
        Lanes::<R, 4>::workspace(order + 1)
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
}

impl Describe for M1 {
    fn name(&self) -> &'static str {
        "m1"
    }
    fn title(&self) -> &'static str {
        "Benchmark M1: induction motor alone"
    }
    fn shape(&self) -> Shape {
        Shape {
            coordinates: COORDINATES,
            positions: 0,
            first_order: 4,
            quadratures: 0,
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

impl<R: Real> Simulator<R> for M1 {
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
    StateKind::Velocity,
    StateKind::FirstOrder,
    StateKind::FirstOrder,
    StateKind::FirstOrder,
    StateKind::FirstOrder,
];

static COORDINATE_QUANTITIES: [Quantity<'static>; COORDINATES] = [
    Quantity {
        name: "motor.phi",
        unit: "rad",
        doc: "rotor angle",
    },
];

static STATE_QUANTITIES: [Quantity<'static>; STATES] = [
    Quantity {
        name: "motor.omega",
        unit: "rad/s",
        doc: "rate of rotor angle",
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
];

static STATE_SCALES: [f64; STATES] = [78.5, 1.0, 1.0, 1.0, 1.0];

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
        name: "w",
        unit: "rad/s",
        doc: "rate of rotor angle",
    },
];

/// The run the spec asks for.
pub const RUN_DEFAULTS: RunDefaults<'static> = RunDefaults {
    from: 0.0,
    until: 1.0,
    points: 501,
    rtol: 1e-8,
    method: "auto",
};

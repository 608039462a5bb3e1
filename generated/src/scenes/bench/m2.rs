// Emitted by Machinist 0.1.0; do not edit. To make it again:
//
//     cargo run --release -- gen
//
// Sources, with SHA-256:
//   184d7b60cb50339e3f37bce6684fa46f6344f304435d27ee316de2c88fa9ae56  bench/m2.toml
//   fe2f2deb5f36655ff87e1d6f2bb763716b1c76007878e37e8e41643655074862  units/induction_motor.toml
//   a479b553f0542fe4aecc9e2a030097bc5b34e101f44a5e7297713fb52484327b  units/coupling.toml
//   192155c0a8dc7b884c45e939d6fe1b122b135258825141b94f360d68f1612fb5  units/rotor.toml
//   c25829d257d53d2e48562bcbdac2bfe42940eb3fdb1c5913863f1432683f6420  units/technological_load.toml
//
// Benchmark M2: saw gin
//
// The saw gin from rest, loaded at 1.2 s; of its parameters only the stiffness of the
// coupling can be set, for sweeps.
//
// Source:
//   Benchmark models of textile-machine dynamics.
//
// Shapes; all quantities are in SI units:
//   coordinates               2
//   first-order states        4
//   states                    8
//   parameters                1
//   outputs                   8
//   discontinuities           0
//
// State:
//     0  coupling.twist  [rad]    twist
//     1  motor.omega     [rad/s]  rate of rotor angle
//     2  cylinder.omega  [rad/s]  rate of angle
//     3  motor.psi_sx    [V s]    stator flux linkage along x
//     4  motor.psi_sy    [V s]    stator flux linkage along y
//     5  motor.psi_rx    [V s]    rotor flux linkage along x
//     6  motor.psi_ry    [V s]    rotor flux linkage along y
//     7  cylinder.phi    [rad]    angle
//
// Nonzeros:
//   mass_matrix               2 of 2 by 2
//   rate_jacobian            27 of 8 by 8
//   parameter_jacobian        2 of 8 by 1
//
// Operations:
//   initial_state             0
//   discontinuities           0
//   rate                     52
//   mass_matrix               0
//   forcing                  24
//   rate_jacobian            34
//   parameter_jacobian        3
//   time_derivative          24
//   outputs                   1
//   energy                   28
//   power_balance           110
// With constants of the parameters, prepared once a run:
//   prepare                   3
//   prepared_rate            52
//   prepared_rate_jacobian   31

use ::machinist_contract::{
    Describe, Energy, PowerBalance, Quantity, Real, RunDefaults, Shape, Simulator,
    SparsityPattern, StateKind, taylor::{Bends, Lanes, TaylorSeries, order_and_inverse},
};

/// Generalized coordinates, n.
pub const COORDINATES: usize = 2;

/// Length of the state y.
pub const STATES: usize = 8;

/// Parameters.
pub const PARAMETERS: usize = 1;

/// Wanted outputs.
pub const OUTPUTS: usize = 8;

/// Times at which the right-hand side jumps.
pub const DISCONTINUITIES: usize = 0;

/// Nonzeros of M, both triangles.
pub const MASS_MATRIX_PATTERN: SparsityPattern<'static> = SparsityPattern {
    rows: 2,
    columns: 2,
    entries: &[(0, 0), (1, 1)],
};

/// Nonzeros of dy'/dy.
pub const RATE_JACOBIAN_PATTERN: SparsityPattern<'static> = SparsityPattern {
    rows: 8,
    columns: 8,
    entries: &[
        (0, 1), (0, 2), (1, 0), (1, 1), (1, 2), (1, 3), (1, 4), (1, 5), (1, 6), (2, 0), (2, 1),
        (2, 2), (3, 3), (3, 4), (3, 5), (4, 3), (4, 4), (4, 6), (5, 1), (5, 3), (5, 5), (5, 6),
        (6, 1), (6, 4), (6, 5), (6, 6), (7, 2),
    ],
};

/// Nonzeros of dy'/dp.
pub const PARAMETER_JACOBIAN_PATTERN: SparsityPattern<'static> = SparsityPattern {
    rows: 8,
    columns: 1,
    entries: &[(1, 0), (2, 0)],
};

/// Benchmark M2: saw gin
///
/// The saw gin from rest, loaded at 1.2 s; of its parameters only the stiffness of the
/// coupling can be set, for sweeps.
///
/// Source: Benchmark models of textile-machine dynamics.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct M2;

/// Parameters, in SI units; the default holds the values of the spec.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Parameters<R> {
    /// coupling.stiffness: torsional stiffness \[N m/rad\]. In the spec: 23065.2.
    pub coupling_stiffness: R,
}

impl<R: Real> Parameters<R> {
    /// From the numbers in their order.
    #[must_use]
    #[inline]
    pub fn from_array(values: [R; PARAMETERS]) -> Self {
        Self {
            coupling_stiffness: values[0],
        }
    }
    /// The numbers in their order.
    #[must_use]
    #[inline]
    pub fn to_array(self) -> [R; PARAMETERS] {
        [self.coupling_stiffness]
    }
}

impl<R: Real> Default for Parameters<R> {
    fn default() -> Self {
        Self {
            coupling_stiffness: R::literal(23065.2),
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
    /// phi_2: angle \[rad\].
    pub phi_2: R,
    /// w_2: rate of angle \[rad/s\].
    pub w_2: R,
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
            phi_2: values[6],
            w_2: values[7],
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
            self.phi_2,
            self.w_2,
        ]
    }
}

/// Where to find what in the state.
pub mod state {
    /// coupling.twist: twist \[rad\].
    pub const COUPLING_TWIST: usize = 0;
    /// motor.omega: rate of rotor angle \[rad/s\].
    pub const MOTOR_OMEGA: usize = 1;
    /// cylinder.omega: rate of angle \[rad/s\].
    pub const CYLINDER_OMEGA: usize = 2;
    /// motor.psi_sx: stator flux linkage along x \[V s\].
    pub const MOTOR_PSI_SX: usize = 3;
    /// motor.psi_sy: stator flux linkage along y \[V s\].
    pub const MOTOR_PSI_SY: usize = 4;
    /// motor.psi_rx: rotor flux linkage along x \[V s\].
    pub const MOTOR_PSI_RX: usize = 5;
    /// motor.psi_ry: rotor flux linkage along y \[V s\].
    pub const MOTOR_PSI_RY: usize = 6;
    /// cylinder.phi: angle \[rad\].
    pub const CYLINDER_PHI: usize = 7;
}

/// Constants that `prepare` computes.
pub const CONSTANTS: usize = 2;

#[allow(missing_docs, reason = "`prepare` says what each is")]
/// What parameters alone decide; `prepare` says what each is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Constants<R> {
    pub cylinder_omega_dot_by_coupling_twist: R,
    pub motor_omega_dot_by_coupling_twist: R,
}

impl<R: Real> Constants<R> {
    /// From the numbers in their order.
    #[must_use]
    #[inline]
    pub fn from_array(values: [R; CONSTANTS]) -> Self {
        Self {
            cylinder_omega_dot_by_coupling_twist: values[0],
            motor_omega_dot_by_coupling_twist: values[1],
        }
    }
    /// The numbers in their order.
    #[must_use]
    #[inline]
    pub fn to_array(self) -> [R; CONSTANTS] {
        [
            self.cylinder_omega_dot_by_coupling_twist,
            self.motor_omega_dot_by_coupling_twist,
        ]
    }
}

/// What `rate` and `rate_jacobian` need of the parameters, once a run.
///
/// 3 operations.
#[must_use]
#[inline]
pub fn prepare<R: Real>(p: &Parameters<R>) -> Constants<R> {
    let cylinder_omega_dot_by_coupling_twist = p.coupling_stiffness
        * R::literal(0.803_858_520_900_321_5);
    let motor_omega_dot_by_coupling_twist = -(p.coupling_stiffness
        * R::literal(0.238_095_238_095_238_08));
    Constants {
        cylinder_omega_dot_by_coupling_twist,
        motor_omega_dot_by_coupling_twist,
    }
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
/// 52 operations.
#[must_use]
#[inline]
pub fn rate<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>) -> [R; STATES] {
    prepared_rate(time, state, p, &prepare(p))
}

/// As `rate`, with the constants of the parameters from `prepare`.
///
/// 52 operations.
#[must_use]
#[inline]
pub fn prepared_rate<R: Real>(
    time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
    _c: &Constants<R>,
) -> [R; STATES] {
    let [coupling_twist, motor_omega, cylinder_omega, motor_psi_sx, motor_psi_sy,
    motor_psi_rx, motor_psi_ry, ..] = *state;
    let coupling_twist_rate = motor_omega - cylinder_omega;
    let motor_slip_speed = R::literal(314.159_265_358_979_3)
        .sub_product(R::literal(4.0), motor_omega);
    let motor_i_sx = R::literal(844.204_793_982_429_1)
        * motor_psi_sx.sub_product(R::literal(0.952), motor_psi_rx);
    let motor_i_sy = R::literal(844.204_793_982_429_1)
        * motor_psi_sy.sub_product(R::literal(0.952), motor_psi_ry);
    let load_engagement = R::literal(1.0)
        / (R::literal(1.0) + (-(R::literal(50.0) * (time - R::literal(1.2)))).exp());
    let motor_torque = R::literal(4_822.097_783_227_635)
        * (motor_psi_sy * motor_psi_rx).sub_product(motor_psi_sx, motor_psi_ry);
    let coupling_torque = (p.coupling_stiffness * coupling_twist)
        .add_product(R::literal(128.5346), coupling_twist_rate);
    let load_resistance = load_engagement
        * R::literal(843.72)
            .add_product(
                R::literal(78.78),
                (R::literal(241.805_307_826_689_27) * time).sin(),
            ) * (R::literal(2.0) * cylinder_omega).tanh();
    let cylinder_omega_dot = (coupling_torque - load_resistance)
        * R::literal(0.803_858_520_900_321_5);
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
    [
        coupling_twist_rate,
        motor_omega_dot,
        cylinder_omega_dot,
        motor_psi_sx_dot,
        motor_psi_sy_dot,
        motor_psi_rx_dot,
        motor_psi_ry_dot,
        cylinder_omega,
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
) -> [R; 2] {
    [R::literal(4.2), R::literal(1.244)]
}

/// `f` of `M q'' = f(q, q', z, t)`, one for each coordinate.
///
/// 24 operations.
#[must_use]
pub fn forcing<R: Real>(
    time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
) -> [R; COORDINATES] {
    let [coupling_twist, motor_omega, cylinder_omega, motor_psi_sx, motor_psi_sy,
    motor_psi_rx, motor_psi_ry, ..] = *state;
    let coupling_twist_rate = motor_omega - cylinder_omega;
    let load_engagement = R::literal(1.0)
        / (R::literal(1.0) + (-(R::literal(50.0) * (time - R::literal(1.2)))).exp());
    let motor_torque = R::literal(4_822.097_783_227_635)
        * (motor_psi_sy * motor_psi_rx).sub_product(motor_psi_sx, motor_psi_ry);
    let coupling_torque = (p.coupling_stiffness * coupling_twist)
        .add_product(R::literal(128.5346), coupling_twist_rate);
    let load_resistance = load_engagement
        * R::literal(843.72)
            .add_product(
                R::literal(78.78),
                (R::literal(241.805_307_826_689_27) * time).sin(),
            ) * (R::literal(2.0) * cylinder_omega).tanh();
    let motor_phi_forcing = motor_torque - coupling_torque;
    let cylinder_phi_forcing = coupling_torque - load_resistance;
    [motor_phi_forcing, cylinder_phi_forcing]
}

/// `dy'/dy`, values in the order of `RATE_JACOBIAN_PATTERN`.
///
/// 34 operations.
#[must_use]
#[inline]
pub fn rate_jacobian<R: Real>(
    time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
) -> [R; 27] {
    prepared_rate_jacobian(time, state, p, &prepare(p))
}

/// As `rate_jacobian`, with the constants of the parameters from `prepare`.
///
/// 31 operations.
#[must_use]
pub fn prepared_rate_jacobian<R: Real>(
    time: R,
    state: &[R; STATES],
    _p: &Parameters<R>,
    c: &Constants<R>,
) -> [R; 27] {
    let [_, motor_omega, cylinder_omega, motor_psi_sx, motor_psi_sy, motor_psi_rx,
    motor_psi_ry, ..] = *state;
    let t0 = R::literal(4.0) * motor_omega;
    let motor_slip_speed = R::literal(314.159_265_358_979_3) - t0;
    let load_engagement = R::literal(1.0)
        / (R::literal(1.0) + (-(R::literal(50.0) * (time - R::literal(1.2)))).exp());
    let t1 = (R::literal(2.0) * cylinder_omega).tanh();
    let motor_psi_rx_dot_by_motor_omega = -(R::literal(4.0) * motor_psi_ry);
    let motor_psi_ry_dot_by_motor_omega = R::literal(4.0) * motor_psi_rx;
    let cylinder_omega_dot_by_cylinder_omega = R::literal(-128.5346)
        .sub_product(
            R::literal(2.0) * load_engagement * R::literal(1.0).sub_product(t1, t1),
            R::literal(843.72)
                .add_product(
                    R::literal(78.78),
                    (R::literal(241.805_307_826_689_27) * time).sin(),
                ),
        ) * R::literal(0.803_858_520_900_321_5);
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
        R::literal(1.0),
        R::literal(-1.0),
        c.motor_omega_dot_by_coupling_twist,
        R::literal(-30.603_476_190_476_19),
        R::literal(30.603_476_190_476_19),
        motor_omega_dot_by_motor_psi_sx,
        motor_omega_dot_by_motor_psi_sy,
        motor_omega_dot_by_motor_psi_rx,
        motor_omega_dot_by_motor_psi_ry,
        c.cylinder_omega_dot_by_coupling_twist,
        R::literal(103.323_633_440_514_47),
        cylinder_omega_dot_by_cylinder_omega,
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
/// 3 operations.
#[must_use]
pub fn parameter_jacobian<R: Real>(
    _time: R,
    state: &[R; STATES],
    _p: &Parameters<R>,
) -> [R; 2] {
    let [coupling_twist, ..] = *state;
    let cylinder_omega_dot_by_coupling_stiffness = coupling_twist
        * R::literal(0.803_858_520_900_321_5);
    let motor_omega_dot_by_coupling_stiffness = -(coupling_twist
        * R::literal(0.238_095_238_095_238_08));
    [motor_omega_dot_by_coupling_stiffness, cylinder_omega_dot_by_coupling_stiffness]
}

/// Partial derivative of `y'` with respect to time.
///
/// 24 operations.
#[must_use]
pub fn time_derivative<R: Real>(
    time: R,
    state: &[R; STATES],
    _p: &Parameters<R>,
) -> [R; STATES] {
    let [_, _, cylinder_omega, ..] = *state;
    let t0 = R::literal(241.805_307_826_689_27) * time;
    let (t1, t2) = t0.sin_cos();
    let t3 = (-(R::literal(50.0) * (time - R::literal(1.2)))).exp();
    let t4 = R::literal(1.0) + t3;
    let load_engagement = R::literal(1.0) / t4;
    let t5 = (R::literal(2.0) * cylinder_omega).tanh();
    let cylinder_omega_dot_by_time = (-(R::literal(50.0)
        * R::literal(843.72).add_product(R::literal(78.78), t1) * t3 * t5 / (t4 * t4)))
        .sub_product(R::literal(19_049.422_150_586_58) * load_engagement * t2, t5)
        * R::literal(0.803_858_520_900_321_5);
    [
        R::literal(0.0),
        R::literal(0.0),
        cylinder_omega_dot_by_time,
        R::literal(0.0),
        R::literal(0.0),
        R::literal(0.0),
        R::literal(0.0),
        R::literal(0.0),
    ]
}

/// Wanted outputs.
///
/// 1 operation.
#[must_use]
pub fn outputs<R: Real>(
    _time: R,
    state: &[R; STATES],
    _p: &Parameters<R>,
) -> Outputs<R> {
    let [coupling_twist, motor_omega, cylinder_omega, motor_psi_sx, motor_psi_sy,
    motor_psi_rx, motor_psi_ry, cylinder_phi] = *state;
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

/// T, V and the energy of first-order states \[J\].
///
/// 28 operations.
#[must_use]
pub fn energy<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>) -> Energy<R> {
    let [coupling_twist, motor_omega, cylinder_omega, motor_psi_sx, motor_psi_sy,
    motor_psi_rx, motor_psi_ry, ..] = *state;
    let motor_i_sx = R::literal(844.204_793_982_429_1)
        * motor_psi_sx.sub_product(R::literal(0.952), motor_psi_rx);
    let motor_i_sy = R::literal(844.204_793_982_429_1)
        * motor_psi_sy.sub_product(R::literal(0.952), motor_psi_ry);
    let motor_i_rx = R::literal(840.672_556_350_703_5)
        * motor_psi_rx.sub_product(R::literal(0.956), motor_psi_sx);
    let motor_i_ry = R::literal(840.672_556_350_703_5)
        * motor_psi_ry.sub_product(R::literal(0.956), motor_psi_sy);
    Energy {
        kinetic: (R::literal(0.622) * (cylinder_omega * cylinder_omega))
            .add_product(R::literal(2.1), motor_omega * motor_omega),
        potential: R::literal(0.5) * p.coupling_stiffness
            * (coupling_twist * coupling_twist),
        stored: R::literal(0.75)
            * (motor_psi_sx * motor_i_sx)
                .add_product(motor_psi_sy, motor_i_sy)
                .add_product(motor_psi_rx, motor_i_rx)
                .add_product(motor_psi_ry, motor_i_ry),
    }
}

/// `dE/dt`, power supplied and power dissipated \[W\].
///
/// 110 operations.
#[must_use]
pub fn power_balance<R: Real>(
    time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
) -> PowerBalance<R> {
    let [coupling_twist, motor_omega, cylinder_omega, motor_psi_sx, motor_psi_sy,
    motor_psi_rx, motor_psi_ry, ..] = *state;
    let coupling_twist_rate = motor_omega - cylinder_omega;
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
    let load_engagement = R::literal(1.0)
        / (R::literal(1.0) + (-(R::literal(50.0) * (time - R::literal(1.2)))).exp());
    let motor_torque = R::literal(4_822.097_783_227_635)
        * (motor_psi_sy * motor_psi_rx).sub_product(motor_psi_sx, motor_psi_ry);
    let t2 = p.coupling_stiffness * coupling_twist;
    let coupling_torque = t2.add_product(R::literal(128.5346), coupling_twist_rate);
    let load_resistance = load_engagement
        * R::literal(843.72)
            .add_product(
                R::literal(78.78),
                (R::literal(241.805_307_826_689_27) * time).sin(),
            ) * (R::literal(2.0) * cylinder_omega).tanh();
    let cylinder_omega_dot = (coupling_torque - load_resistance)
        * R::literal(0.803_858_520_900_321_5);
    let motor_omega_dot = (motor_torque - coupling_torque)
        * R::literal(0.238_095_238_095_238_08);
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
        stored_rate: (t2 * coupling_twist_rate)
            .add_product(R::literal(4.2) * motor_omega, motor_omega_dot)
            .add_product(R::literal(1.244) * cylinder_omega, cylinder_omega_dot)
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
        supplied: (R::literal(466.690_475_583_121_4) * motor_i_sx)
            .sub_product(cylinder_omega, load_resistance),
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
            .sub_product(R::literal(128.5346) * cylinder_omega, coupling_twist_rate),
    }
}

/// Normalized Taylor coefficients of the solution through `state`, order after order.
///
/// `_k` marks the coefficient of order k, `_before` that of order k - 1; bare names are
/// zeroth coefficients. The workspace is as `series_workspace` says.
///
/// 80 recurrences. 9 sums of products an order.
///
/// # Panics
/// If there is no room for the zeroth coefficients, or the workspace is too short.
pub fn series<R: Real>(
    time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
    coefficients: &mut [[R; STATES]],
    workspace: &mut [R],
) {
    let (mut lanes, workspace) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let (mut lanes_1, workspace) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let (mut lanes_2, _) = Lanes::<R, 1>::new(workspace, coefficients.len());
    let [coupling_twist, motor_omega, cylinder_omega, motor_psi_sx, motor_psi_sy,
    motor_psi_rx, motor_psi_ry, ..] = *state;
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
    let t8 = t7 * R::literal(50.0);
    let t9 = -t8;
    let t10 = t9.exp();
    let t11 = R::literal(1.0) + t10;
    let load_engagement = R::literal(1.0) / t11;
    let t12 = motor_psi_sx * motor_psi_ry;
    let t13 = motor_psi_sy * motor_psi_rx;
    let t14 = t13 - t12;
    let motor_torque = t14 * R::literal(4_822.097_783_227_635);
    let t15 = coupling_twist_rate * R::literal(128.5346);
    let t16 = coupling_twist * p.coupling_stiffness;
    let coupling_torque = t15 + t16;
    let t17 = time * R::literal(241.805_307_826_689_27);
    let t18 = t17.sin();
    let t19 = t17.cos();
    let t20 = t18 * R::literal(78.78);
    let t21 = R::literal(843.72) + t20;
    let t22 = cylinder_omega * R::literal(2.0);
    let t23 = t22.tanh();
    let t24 = t23 * t23;
    let t25 = R::literal(1.0) - t24;
    let t26 = load_engagement * t21;
    let load_resistance = t26 * t23;
    let t27 = motor_torque - coupling_torque;
    let t28 = coupling_torque - load_resistance;
    let cylinder_omega_dot = t28 * R::literal(0.803_858_520_900_321_5);
    let motor_omega_dot = t27 * R::literal(0.238_095_238_095_238_08);
    let t29 = t2 * R::literal(36.128_315_516_282_626);
    let t30 = motor_psi_sy * R::literal(314.159_265_358_979_3);
    let t31 = R::literal(311.126_983_722_080_9) + t30;
    let motor_psi_sx_dot = t31 - t29;
    let t32 = motor_psi_sx * R::literal(314.159_265_358_979_3);
    let t33 = t4 * R::literal(36.128_315_516_282_626);
    let t34 = -t32;
    let motor_psi_sy_dot = t34 - t33;
    let t35 = t5 - motor_psi_rx;
    let t36 = t35 * R::literal(26.954_864_967_800_425);
    let t37 = motor_psi_ry * motor_slip_speed;
    let motor_psi_rx_dot = t36 + t37;
    let t38 = motor_psi_rx * motor_slip_speed;
    let t39 = t6 - motor_psi_ry;
    let t40 = t39 * R::literal(26.954_864_967_800_425);
    let motor_psi_ry_dot = t40 - t38;
    let t8_slope = R::literal(1.0) * R::literal(50.0);
    let t9_slope = -t8_slope;
    let inverse_t11 = R::literal(1.0) / t11;
    let mut t10_before = t10;
    let mut t18_before = t18;
    let mut t19_before = t19;
    let mut rates = [
        coupling_twist_rate,
        motor_omega_dot,
        cylinder_omega_dot,
        motor_psi_sx_dot,
        motor_psi_sy_dot,
        motor_psi_rx_dot,
        motor_psi_ry_dot,
        cylinder_omega,
    ];
    coefficients[0] = *state;
    let highest = coefficients.len() - 1;
    for (order, state_k) in coefficients.iter_mut().enumerate().skip(1) {
        let (k, inverse) = order_and_inverse::<R>(order);
        *state_k = rates.map(|rate| rate * inverse);
        if order == highest {
            break;
        }
        let [coupling_twist_k, motor_omega_k, cylinder_omega_k, motor_psi_sx_k,
        motor_psi_sy_k, motor_psi_rx_k, motor_psi_ry_k, ..] = *state_k;
        let sums = lanes.sums(order);
        let sums_1 = lanes_1.sums(order);
        let sums_2 = lanes_2.sums(order);
        let coupling_twist_rate_k = motor_omega_k - cylinder_omega_k;
        let motor_slip_speed_k = -motor_omega_k * R::literal(4.0);
        let t2_k = (-motor_psi_rx_k).mul_add(R::literal(0.952), motor_psi_sx_k);
        let t4_k = (-motor_psi_ry_k).mul_add(R::literal(0.952), motor_psi_sy_k);
        let t10_k = inverse * t9_slope * t10_before;
        let load_engagement_k = -t10_k.mul_add(load_engagement, sums_1[1]) * inverse_t11;
        let t12_k = motor_psi_sx
            .mul_add(motor_psi_ry_k, motor_psi_ry.mul_add(motor_psi_sx_k, sums[0]));
        let t13_k = motor_psi_sy
            .mul_add(motor_psi_rx_k, motor_psi_rx.mul_add(motor_psi_sy_k, sums[1]));
        let t14_k = t13_k - t12_k;
        let coupling_torque_k = coupling_twist_k
            .mul_add(p.coupling_stiffness, coupling_twist_rate_k * R::literal(128.5346));
        let t18_k = inverse * R::literal(241.805_307_826_689_27) * t19_before;
        let t19_k = -inverse * R::literal(241.805_307_826_689_27) * t18_before;
        let t22_k = cylinder_omega_k * R::literal(2.0);
        let t23_k = t22_k.mul_add(t25, inverse * sums_1[3]);
        let t24_k = (t23 + t23).mul_add(t23_k, sums[2]);
        let t25_k = -t24_k;
        let t26_k = load_engagement
            .mul_add(
                t18_k * R::literal(78.78),
                t21.mul_add(load_engagement_k, sums_1[2]),
            );
        let load_resistance_k = t23.mul_add(t26_k, t26.mul_add(t23_k, sums_2[0]));
        let t27_k = t14_k.mul_add(R::literal(4_822.097_783_227_635), -coupling_torque_k);
        let t28_k = coupling_torque_k - load_resistance_k;
        let cylinder_omega_dot_k = t28_k * R::literal(0.803_858_520_900_321_5);
        let motor_omega_dot_k = t27_k * R::literal(0.238_095_238_095_238_08);
        let motor_psi_sx_dot_k = (-t2_k)
            .mul_add(
                R::literal(36.128_315_516_282_626),
                motor_psi_sy_k * R::literal(314.159_265_358_979_3),
            );
        let t32_k = motor_psi_sx_k * R::literal(314.159_265_358_979_3);
        let t34_k = -t32_k;
        let motor_psi_sy_dot_k = (-t4_k)
            .mul_add(R::literal(36.128_315_516_282_626), t34_k);
        let t35_k = motor_psi_sx_k.mul_add(R::literal(0.956), -motor_psi_rx_k);
        let t37_k = motor_psi_ry
            .mul_add(
                motor_slip_speed_k,
                motor_slip_speed.mul_add(motor_psi_ry_k, sums[3]),
            );
        let motor_psi_rx_dot_k = t35_k
            .mul_add(R::literal(26.954_864_967_800_425), t37_k);
        let t38_k = motor_psi_rx
            .mul_add(
                motor_slip_speed_k,
                motor_slip_speed.mul_add(motor_psi_rx_k, sums_1[0]),
            );
        let t39_k = motor_psi_sy_k.mul_add(R::literal(0.956), -motor_psi_ry_k);
        let motor_psi_ry_dot_k = t39_k
            .mul_add(R::literal(26.954_864_967_800_425), -t38_k);
        lanes
            .set(
                order,
                [motor_psi_sx_k, motor_psi_rx_k, t23_k, motor_slip_speed_k],
                [motor_psi_ry_k, motor_psi_sy_k, t23_k, motor_psi_ry_k],
            );
        lanes_1
            .set(
                order,
                [motor_slip_speed_k, t10_k, load_engagement_k, k * t22_k],
                [motor_psi_rx_k, load_engagement_k, t18_k * R::literal(78.78), t25_k],
            );
        lanes_2.set(order, [t23_k], [t26_k]);
        t10_before = t10_k;
        t18_before = t18_k;
        t19_before = t19_k;
        rates = [
            coupling_twist_rate_k,
            motor_omega_dot_k,
            cylinder_omega_dot_k,
            motor_psi_sx_dot_k,
            motor_psi_sy_dot_k,
            motor_psi_rx_dot_k,
            motor_psi_ry_dot_k,
            cylinder_omega_k,
        ];
    }
}

impl<R: Real> TaylorSeries<R> for M2 {
    fn series_workspace(&self, order: usize) -> usize {
        Lanes::<R, 4>::workspace(order + 1) + Lanes::<R, 4>::workspace(order + 1)
            + Lanes::<R, 1>::workspace(order + 1)
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

impl Describe for M2 {
    fn name(&self) -> &'static str {
        "m2"
    }
    fn title(&self) -> &'static str {
        "Benchmark M2: saw gin"
    }
    fn shape(&self) -> Shape {
        Shape {
            coordinates: COORDINATES,
            positions: 2,
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

impl<R: Real> Simulator<R> for M2 {
    fn constants(&self) -> usize {
        CONSTANTS
    }
    fn prepare(&self, parameters: &[R], constants: &mut [R]) {
        *array_of(constants) = prepare(&parameters_of(parameters)).to_array();
    }
    fn prepared_rate(
        &self,
        time: R,
        state: &[R],
        parameters: &[R],
        constants: &[R],
        values: &mut [R],
    ) {
        let (p, c) = (parameters_of(parameters), constants_of(constants));
        *array_of(values) = prepared_rate(time, state_of(state), &p, &c);
    }
    fn prepared_rate_jacobian(
        &self,
        time: R,
        state: &[R],
        parameters: &[R],
        constants: &[R],
        values: &mut [R],
    ) {
        let (p, c) = (parameters_of(parameters), constants_of(constants));
        *array_of(values) = prepared_rate_jacobian(time, state_of(state), &p, &c);
    }
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
fn constants_of<R: Real>(constants: &[R]) -> Constants<R> {
    let values: &[R; CONSTANTS] = constants
        .try_into()
        .expect("there are CONSTANTS constants");
    Constants::from_array(*values)
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
        name: "cylinder.phi",
        unit: "rad",
        doc: "angle",
    },
];

static STATE_QUANTITIES: [Quantity<'static>; STATES] = [
    Quantity {
        name: "coupling.twist",
        unit: "rad",
        doc: "twist",
    },
    Quantity {
        name: "motor.omega",
        unit: "rad/s",
        doc: "rate of rotor angle",
    },
    Quantity {
        name: "cylinder.omega",
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
        name: "cylinder.phi",
        unit: "rad",
        doc: "angle",
    },
];

static STATE_SCALES: [f64; STATES] = [1.0, 78.5, 78.5, 1.0, 1.0, 1.0, 1.0, 150.0];

static PARAMETER_QUANTITIES: [Quantity<'static>; PARAMETERS] = [
    Quantity {
        name: "coupling.stiffness",
        unit: "N m/rad",
        doc: "torsional stiffness",
    },
];

static PARAMETER_DEFAULTS: [f64; PARAMETERS] = [23065.2];

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
        name: "phi_2",
        unit: "rad",
        doc: "angle",
    },
    Quantity {
        name: "w_2",
        unit: "rad/s",
        doc: "rate of angle",
    },
];

/// The run the spec asks for.
pub const RUN_DEFAULTS: RunDefaults<'static> = RunDefaults {
    from: 0.0,
    until: 2.0,
    points: 501,
    rtol: 1e-8,
    method: "auto",
};

// Emitted by Machinist 0.1.0; do not edit. To make it again:
//
//     cargo run --release -- gen
//
// Sources, with SHA-256:
//   9cb3bc06b90741bd6579fe343a29720adfbbf2f1c299afe86f08de34d6c7fd6b  scenes/motor_run_up.toml
//   fe2f2deb5f36655ff87e1d6f2bb763716b1c76007878e37e8e41643655074862  units/induction_motor.toml
//
// Induction motor running up empty
//
// The motor alone, from rest to synchronous speed.
//
// Source:
//   Saw-gin study (2020), equations (2).
//
// Shapes; all quantities are in SI units:
//   coordinates               1
//   first-order states        4
//   states                    5
//   parameters               11
//   outputs                   4
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
//   parameter_jacobian       24 of 5 by 11
//
// Operations:
//   initial_state             0
//   discontinuities           0
//   rate                     45
//   mass_matrix               0
//   forcing                  12
//   rate_jacobian            35
//   parameter_jacobian       88
//   time_derivative           0
//   outputs                  27
//   energy                   32
//   power_balance           106
// With constants of the parameters, prepared once a run:
//   prepare                  26
//   prepared_rate            29
//   prepared_rate_jacobian   14

use ::machinist_contract::{
    Describe, Energy, PowerBalance, Quantity, Real, RunDefaults, Shape, Simulator,
    SparsityPattern, StateKind, taylor::{Lanes, TaylorSeries, order_and_inverse},
};

/// Generalized coordinates, n.
pub const COORDINATES: usize = 1;

/// Length of the state y.
pub const STATES: usize = 5;

/// Parameters.
pub const PARAMETERS: usize = 11;

/// Wanted outputs.
pub const OUTPUTS: usize = 4;

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
    columns: 11,
    entries: &[
        (0, 1), (0, 3), (0, 5), (0, 6), (0, 7), (0, 8), (1, 2), (1, 3), (1, 4), (1, 7), (1, 9),
        (2, 2), (2, 3), (2, 4), (2, 7), (2, 9), (3, 3), (3, 5), (3, 6), (3, 10), (4, 3), (4, 5),
        (4, 6), (4, 10),
    ],
};

/// Induction motor running up empty
///
/// The motor alone, from rest to synchronous speed.
///
/// Source: Saw-gin study (2020), equations (2).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct MotorRunUp;

/// Parameters, in SI units; the default holds the values of the spec.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Parameters<R> {
    /// initial_speed: speed at the start \[rad/s\]. In the spec: 0.0.
    pub initial_speed: R,
    /// motor.inertia: moment of inertia of the rotor \[kg m^2\]. In the spec: 4.2.
    pub motor_inertia: R,
    /// motor.phase_voltage: root mean square of the phase voltage \[V\]. In the spec: 220.0.
    pub motor_phase_voltage: R,
    /// motor.supply_frequency: frequency of the supply \[Hz\]. In the spec: 50.0.
    pub motor_supply_frequency: R,
    /// motor.supply_phase: phase of the supply at the start \[rad\]. In the spec: 0.0.
    pub motor_supply_phase: R,
    /// motor.pole_pairs: pairs of poles \[1\]. In the spec: 4.0.
    pub motor_pole_pairs: R,
    /// motor.k_s: stator coupling factor x_mu/x_s \[1\]. In the spec: 0.956.
    pub motor_k_s: R,
    /// motor.k_r: rotor coupling factor x_mu/x_r \[1\]. In the spec: 0.952.
    pub motor_k_r: R,
    /// motor.x_s: stator reactance at supply frequency \[ohm\]. In the spec: 4.14.
    pub motor_x_s: R,
    /// motor.alpha_s: stator decay r_s/(sigma x_s) \[1\]. In the spec: 0.115.
    pub motor_alpha_s: R,
    /// motor.alpha_r: rotor decay r_r/(sigma x_r) \[1\]. In the spec: 0.0858.
    pub motor_alpha_r: R,
}

impl<R: Real> Parameters<R> {
    /// From the numbers in their order.
    #[must_use]
    #[inline]
    pub fn from_array(values: [R; PARAMETERS]) -> Self {
        Self {
            initial_speed: values[0],
            motor_inertia: values[1],
            motor_phase_voltage: values[2],
            motor_supply_frequency: values[3],
            motor_supply_phase: values[4],
            motor_pole_pairs: values[5],
            motor_k_s: values[6],
            motor_k_r: values[7],
            motor_x_s: values[8],
            motor_alpha_s: values[9],
            motor_alpha_r: values[10],
        }
    }
    /// The numbers in their order.
    #[must_use]
    #[inline]
    pub fn to_array(self) -> [R; PARAMETERS] {
        [
            self.initial_speed,
            self.motor_inertia,
            self.motor_phase_voltage,
            self.motor_supply_frequency,
            self.motor_supply_phase,
            self.motor_pole_pairs,
            self.motor_k_s,
            self.motor_k_r,
            self.motor_x_s,
            self.motor_alpha_s,
            self.motor_alpha_r,
        ]
    }
}

impl<R: Real> Default for Parameters<R> {
    fn default() -> Self {
        Self {
            initial_speed: R::literal(0.0),
            motor_inertia: R::literal(4.2),
            motor_phase_voltage: R::literal(220.0),
            motor_supply_frequency: R::literal(50.0),
            motor_supply_phase: R::literal(0.0),
            motor_pole_pairs: R::literal(4.0),
            motor_k_s: R::literal(0.956),
            motor_k_r: R::literal(0.952),
            motor_x_s: R::literal(4.14),
            motor_alpha_s: R::literal(0.115),
            motor_alpha_r: R::literal(0.0858),
        }
    }
}

/// Wanted outputs, in SI units.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Outputs<R> {
    /// speed: rotor speed \[rad/s\].
    pub speed: R,
    /// torque: electromagnetic torque \[N m\].
    pub torque: R,
    /// slip: slip \[1\].
    pub slip: R,
    /// stator_current: amplitude of the stator current \[A\].
    pub stator_current: R,
}

impl<R: Real> Outputs<R> {
    /// From the numbers in their order.
    #[must_use]
    #[inline]
    pub fn from_array(values: [R; OUTPUTS]) -> Self {
        Self {
            speed: values[0],
            torque: values[1],
            slip: values[2],
            stator_current: values[3],
        }
    }
    /// The numbers in their order.
    #[must_use]
    #[inline]
    pub fn to_array(self) -> [R; OUTPUTS] {
        [self.speed, self.torque, self.slip, self.stator_current]
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

/// Constants that `prepare` computes.
pub const CONSTANTS: usize = 13;

#[allow(missing_docs, reason = "`prepare` says what each is")]
/// What parameters alone decide; `prepare` says what each is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Constants<R> {
    pub motor_omega_0: R,
    pub motor_u_x: R,
    pub motor_u_y: R,
    pub t2: R,
    pub inverse_motor_inertia: R,
    pub motor_alpha_s_times_motor_omega_0: R,
    pub motor_alpha_r_times_motor_omega_0: R,
    pub t3: R,
    pub motor_psi_sx_dot_by_motor_psi_sx: R,
    pub motor_psi_sy_dot_by_motor_psi_sx: R,
    pub motor_psi_rx_dot_by_motor_psi_sx: R,
    pub motor_psi_sx_dot_by_motor_psi_rx: R,
    pub motor_psi_rx_dot_by_motor_psi_rx: R,
}

impl<R: Real> Constants<R> {
    /// From the numbers in their order.
    #[must_use]
    #[inline]
    pub fn from_array(values: [R; CONSTANTS]) -> Self {
        Self {
            motor_omega_0: values[0],
            motor_u_x: values[1],
            motor_u_y: values[2],
            t2: values[3],
            inverse_motor_inertia: values[4],
            motor_alpha_s_times_motor_omega_0: values[5],
            motor_alpha_r_times_motor_omega_0: values[6],
            t3: values[7],
            motor_psi_sx_dot_by_motor_psi_sx: values[8],
            motor_psi_sy_dot_by_motor_psi_sx: values[9],
            motor_psi_rx_dot_by_motor_psi_sx: values[10],
            motor_psi_sx_dot_by_motor_psi_rx: values[11],
            motor_psi_rx_dot_by_motor_psi_rx: values[12],
        }
    }
    /// The numbers in their order.
    #[must_use]
    #[inline]
    pub fn to_array(self) -> [R; CONSTANTS] {
        [
            self.motor_omega_0,
            self.motor_u_x,
            self.motor_u_y,
            self.t2,
            self.inverse_motor_inertia,
            self.motor_alpha_s_times_motor_omega_0,
            self.motor_alpha_r_times_motor_omega_0,
            self.t3,
            self.motor_psi_sx_dot_by_motor_psi_sx,
            self.motor_psi_sy_dot_by_motor_psi_sx,
            self.motor_psi_rx_dot_by_motor_psi_sx,
            self.motor_psi_sx_dot_by_motor_psi_rx,
            self.motor_psi_rx_dot_by_motor_psi_rx,
        ]
    }
}

/// What `rate` and `rate_jacobian` need of the parameters, once a run.
///
/// 26 operations.
#[must_use]
#[inline]
pub fn prepare<R: Real>(p: &Parameters<R>) -> Constants<R> {
    let (sin_motor_supply_phase, cos_motor_supply_phase) = p
        .motor_supply_phase
        .sin_cos();
    let motor_omega_0 = R::literal(core::f64::consts::TAU) * p.motor_supply_frequency;
    let motor_k_s_times_motor_k_r = p.motor_k_s * p.motor_k_r;
    let motor_sigma = R::literal(1.0) - motor_k_s_times_motor_k_r;
    let t0 = p.motor_phase_voltage * R::literal(core::f64::consts::SQRT_2);
    let motor_u_x = t0 * cos_motor_supply_phase;
    let motor_u_y = t0 * sin_motor_supply_phase;
    let t1 = R::literal(1.5) * p.motor_pole_pairs * p.motor_k_r * motor_omega_0;
    let t2 = t1 / (p.motor_x_s * motor_sigma);
    let inverse_motor_inertia = R::literal(1.0) / p.motor_inertia;
    let motor_alpha_s_times_motor_omega_0 = p.motor_alpha_s * motor_omega_0;
    let motor_alpha_r_times_motor_omega_0 = p.motor_alpha_r * motor_omega_0;
    let t3 = t1 / (p.motor_x_s * (motor_k_s_times_motor_k_r - R::literal(1.0)));
    let motor_psi_sx_dot_by_motor_psi_sx = -motor_alpha_s_times_motor_omega_0;
    let motor_psi_sy_dot_by_motor_psi_sx = -motor_omega_0;
    let motor_psi_rx_dot_by_motor_psi_sx = p.motor_k_s * p.motor_alpha_r * motor_omega_0;
    let motor_psi_sx_dot_by_motor_psi_rx = p.motor_k_r * p.motor_alpha_s * motor_omega_0;
    let motor_psi_rx_dot_by_motor_psi_rx = -motor_alpha_r_times_motor_omega_0;
    Constants {
        motor_omega_0,
        motor_u_x,
        motor_u_y,
        t2,
        inverse_motor_inertia,
        motor_alpha_s_times_motor_omega_0,
        motor_alpha_r_times_motor_omega_0,
        t3,
        motor_psi_sx_dot_by_motor_psi_sx,
        motor_psi_sy_dot_by_motor_psi_sx,
        motor_psi_rx_dot_by_motor_psi_sx,
        motor_psi_sx_dot_by_motor_psi_rx,
        motor_psi_rx_dot_by_motor_psi_rx,
    }
}

/// State at the start of the run, in the units of the states.
///
/// No operations.
#[must_use]
pub fn initial_state<R: Real>(p: &Parameters<R>) -> [R; STATES] {
    [p.initial_speed, R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0)]
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
/// 45 operations.
#[must_use]
#[inline]
pub fn rate<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>) -> [R; STATES] {
    prepared_rate(time, state, p, &prepare(p))
}

/// As `rate`, with the constants of the parameters from `prepare`.
///
/// 29 operations.
#[must_use]
#[inline]
pub fn prepared_rate<R: Real>(
    _time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
    c: &Constants<R>,
) -> [R; STATES] {
    let [motor_omega, motor_psi_sx, motor_psi_sy, motor_psi_rx, motor_psi_ry] = *state;
    let motor_slip_speed = c.motor_omega_0.sub_product(p.motor_pole_pairs, motor_omega);
    let motor_torque = c.t2
        * (motor_psi_sy * motor_psi_rx).sub_product(motor_psi_sx, motor_psi_ry);
    let motor_omega_dot = motor_torque * c.inverse_motor_inertia;
    let motor_psi_sx_dot = c
        .motor_u_x
        .add_product(c.motor_omega_0, motor_psi_sy)
        .sub_product(
            c.motor_alpha_s_times_motor_omega_0,
            motor_psi_sx.sub_product(p.motor_k_r, motor_psi_rx),
        );
    let motor_psi_sy_dot = c
        .motor_u_y
        .sub_product(c.motor_omega_0, motor_psi_sx)
        .sub_product(
            c.motor_alpha_s_times_motor_omega_0,
            motor_psi_sy.sub_product(p.motor_k_r, motor_psi_ry),
        );
    let motor_psi_rx_dot = (motor_psi_ry * motor_slip_speed)
        .add_product(
            c.motor_alpha_r_times_motor_omega_0,
            (-motor_psi_rx).add_product(p.motor_k_s, motor_psi_sx),
        );
    let motor_psi_ry_dot = (c.motor_alpha_r_times_motor_omega_0
        * (-motor_psi_ry).add_product(p.motor_k_s, motor_psi_sy))
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
    p: &Parameters<R>,
) -> [R; 1] {
    [p.motor_inertia]
}

/// `f` of `M q'' = f(q, q', z, t)`, one for each coordinate.
///
/// 12 operations.
#[must_use]
pub fn forcing<R: Real>(
    _time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
) -> [R; COORDINATES] {
    let [_, motor_psi_sx, motor_psi_sy, motor_psi_rx, motor_psi_ry] = *state;
    let motor_omega_0 = R::literal(core::f64::consts::TAU) * p.motor_supply_frequency;
    let motor_sigma = R::literal(1.0).sub_product(p.motor_k_s, p.motor_k_r);
    let motor_torque = R::literal(1.5) * p.motor_pole_pairs * p.motor_k_r * motor_omega_0
        / (p.motor_x_s * motor_sigma)
        * (motor_psi_sy * motor_psi_rx).sub_product(motor_psi_sx, motor_psi_ry);
    [motor_torque]
}

/// `dy'/dy`, values in the order of `RATE_JACOBIAN_PATTERN`.
///
/// 35 operations.
#[must_use]
#[inline]
pub fn rate_jacobian<R: Real>(
    time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
) -> [R; 18] {
    prepared_rate_jacobian(time, state, p, &prepare(p))
}

/// As `rate_jacobian`, with the constants of the parameters from `prepare`.
///
/// 14 operations.
#[must_use]
pub fn prepared_rate_jacobian<R: Real>(
    _time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
    c: &Constants<R>,
) -> [R; 18] {
    let [motor_omega, motor_psi_sx, motor_psi_sy, motor_psi_rx, motor_psi_ry] = *state;
    let motor_pole_pairs_times_motor_omega = p.motor_pole_pairs * motor_omega;
    let motor_slip_speed = c.motor_omega_0 - motor_pole_pairs_times_motor_omega;
    let motor_psi_rx_dot_by_motor_omega = -(p.motor_pole_pairs * motor_psi_ry);
    let motor_psi_ry_dot_by_motor_omega = p.motor_pole_pairs * motor_psi_rx;
    let motor_omega_dot_by_motor_psi_sx = c.t3 * motor_psi_ry * c.inverse_motor_inertia;
    let motor_omega_dot_by_motor_psi_sy = c.t2 * motor_psi_rx * c.inverse_motor_inertia;
    let motor_omega_dot_by_motor_psi_rx = c.t2 * motor_psi_sy * c.inverse_motor_inertia;
    let motor_psi_ry_dot_by_motor_psi_rx = motor_pole_pairs_times_motor_omega
        - c.motor_omega_0;
    let motor_omega_dot_by_motor_psi_ry = c.t3 * motor_psi_sx * c.inverse_motor_inertia;
    [
        motor_omega_dot_by_motor_psi_sx,
        motor_omega_dot_by_motor_psi_sy,
        motor_omega_dot_by_motor_psi_rx,
        motor_omega_dot_by_motor_psi_ry,
        c.motor_psi_sx_dot_by_motor_psi_sx,
        c.motor_omega_0,
        c.motor_psi_sx_dot_by_motor_psi_rx,
        c.motor_psi_sy_dot_by_motor_psi_sx,
        c.motor_psi_sx_dot_by_motor_psi_sx,
        c.motor_psi_sx_dot_by_motor_psi_rx,
        motor_psi_rx_dot_by_motor_omega,
        c.motor_psi_rx_dot_by_motor_psi_sx,
        c.motor_psi_rx_dot_by_motor_psi_rx,
        motor_slip_speed,
        motor_psi_ry_dot_by_motor_omega,
        c.motor_psi_rx_dot_by_motor_psi_sx,
        motor_psi_ry_dot_by_motor_psi_rx,
        c.motor_psi_rx_dot_by_motor_psi_rx,
    ]
}

/// `dy'/dp`, values in the order of `PARAMETER_JACOBIAN_PATTERN`.
///
/// 88 operations.
#[must_use]
pub fn parameter_jacobian<R: Real>(
    _time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
) -> [R; 24] {
    let [motor_omega, motor_psi_sx, motor_psi_sy, motor_psi_rx, motor_psi_ry] = *state;
    let (sin_motor_supply_phase, cos_motor_supply_phase) = p
        .motor_supply_phase
        .sin_cos();
    let motor_omega_0 = R::literal(core::f64::consts::TAU) * p.motor_supply_frequency;
    let motor_k_s_times_motor_k_r = p.motor_k_s * p.motor_k_r;
    let motor_sigma = R::literal(1.0) - motor_k_s_times_motor_k_r;
    let t0 = p.motor_phase_voltage * R::literal(core::f64::consts::SQRT_2);
    let motor_u_x = t0 * cos_motor_supply_phase;
    let motor_u_y = t0 * sin_motor_supply_phase;
    let t1 = motor_psi_sx.sub_product(p.motor_k_r, motor_psi_rx);
    let motor_x_s_times_motor_sigma = p.motor_x_s * motor_sigma;
    let t2 = motor_psi_sy.sub_product(p.motor_k_r, motor_psi_ry);
    let motor_psi_sx_times_motor_psi_ry = motor_psi_sx * motor_psi_ry;
    let motor_psi_sy_times_motor_psi_rx = motor_psi_sy * motor_psi_rx;
    let t3 = motor_psi_sy_times_motor_psi_rx - motor_psi_sx_times_motor_psi_ry;
    let t4 = R::literal(1.5) * p.motor_pole_pairs;
    let motor_torque = t4 * p.motor_k_r * motor_omega_0 / motor_x_s_times_motor_sigma
        * t3;
    let inverse_motor_inertia = R::literal(1.0) / p.motor_inertia;
    let motor_omega_dot = motor_torque * inverse_motor_inertia;
    let motor_alpha_s_times_motor_omega_0 = p.motor_alpha_s * motor_omega_0;
    let t5 = (-motor_psi_rx).add_product(p.motor_k_s, motor_psi_sx);
    let motor_alpha_r_times_motor_omega_0 = p.motor_alpha_r * motor_omega_0;
    let t6 = (-motor_psi_ry).add_product(p.motor_k_s, motor_psi_sy);
    let t7 = motor_k_s_times_motor_k_r - R::literal(1.0);
    let motor_omega_dot_by_motor_inertia = -(motor_omega_dot * inverse_motor_inertia);
    let motor_psi_sx_dot_by_motor_phase_voltage = R::literal(core::f64::consts::SQRT_2)
        * cos_motor_supply_phase;
    let motor_psi_sy_dot_by_motor_phase_voltage = R::literal(core::f64::consts::SQRT_2)
        * sin_motor_supply_phase;
    let motor_omega_dot_by_motor_supply_frequency = R::literal(
        3.0 * core::f64::consts::PI,
    ) * p.motor_pole_pairs * p.motor_k_r / motor_x_s_times_motor_sigma * t3
        * inverse_motor_inertia;
    let t8 = R::literal(core::f64::consts::TAU) * p.motor_alpha_s;
    let motor_psi_sx_dot_by_motor_supply_frequency = (R::literal(core::f64::consts::TAU)
        * motor_psi_sy)
        .sub_product(t8, t1);
    let motor_psi_sy_dot_by_motor_supply_frequency = (-(R::literal(
        core::f64::consts::TAU,
    ) * motor_psi_sx))
        .sub_product(t8, t2);
    let t9 = R::literal(core::f64::consts::TAU) * p.motor_alpha_r;
    let motor_psi_rx_dot_by_motor_supply_frequency = (R::literal(core::f64::consts::TAU)
        * motor_psi_ry)
        .add_product(t9, t5);
    let motor_psi_ry_dot_by_motor_supply_frequency = (-(R::literal(
        core::f64::consts::TAU,
    ) * motor_psi_rx))
        .add_product(t9, t6);
    let motor_psi_sx_dot_by_motor_supply_phase = -motor_u_y;
    let motor_omega_dot_by_motor_pole_pairs = R::literal(1.5) * p.motor_k_r
        * motor_omega_0 / motor_x_s_times_motor_sigma * t3 * inverse_motor_inertia;
    let motor_psi_rx_dot_by_motor_pole_pairs = -(motor_omega * motor_psi_ry);
    let motor_psi_ry_dot_by_motor_pole_pairs = motor_omega * motor_psi_rx;
    let motor_omega_dot_by_motor_k_s = p.motor_k_r / motor_sigma * motor_torque
        * inverse_motor_inertia;
    let motor_psi_rx_dot_by_motor_k_s = motor_alpha_r_times_motor_omega_0 * motor_psi_sx;
    let motor_psi_ry_dot_by_motor_k_s = motor_alpha_r_times_motor_omega_0 * motor_psi_sy;
    let motor_omega_dot_by_motor_k_r = -(t4 * motor_omega_0 / (p.motor_x_s * (t7 * t7))
        * (motor_psi_sx_times_motor_psi_ry - motor_psi_sy_times_motor_psi_rx)
        * inverse_motor_inertia);
    let motor_psi_sx_dot_by_motor_k_r = motor_alpha_s_times_motor_omega_0 * motor_psi_rx;
    let motor_psi_sy_dot_by_motor_k_r = motor_alpha_s_times_motor_omega_0 * motor_psi_ry;
    let motor_omega_dot_by_motor_x_s = -(R::literal(1.0) / p.motor_x_s * motor_torque
        * inverse_motor_inertia);
    let motor_psi_sx_dot_by_motor_alpha_s = -(motor_omega_0 * t1);
    let motor_psi_sy_dot_by_motor_alpha_s = -(motor_omega_0 * t2);
    let motor_psi_rx_dot_by_motor_alpha_r = motor_omega_0 * t5;
    let motor_psi_ry_dot_by_motor_alpha_r = motor_omega_0 * t6;
    [
        motor_omega_dot_by_motor_inertia,
        motor_omega_dot_by_motor_supply_frequency,
        motor_omega_dot_by_motor_pole_pairs,
        motor_omega_dot_by_motor_k_s,
        motor_omega_dot_by_motor_k_r,
        motor_omega_dot_by_motor_x_s,
        motor_psi_sx_dot_by_motor_phase_voltage,
        motor_psi_sx_dot_by_motor_supply_frequency,
        motor_psi_sx_dot_by_motor_supply_phase,
        motor_psi_sx_dot_by_motor_k_r,
        motor_psi_sx_dot_by_motor_alpha_s,
        motor_psi_sy_dot_by_motor_phase_voltage,
        motor_psi_sy_dot_by_motor_supply_frequency,
        motor_u_x,
        motor_psi_sy_dot_by_motor_k_r,
        motor_psi_sy_dot_by_motor_alpha_s,
        motor_psi_rx_dot_by_motor_supply_frequency,
        motor_psi_rx_dot_by_motor_pole_pairs,
        motor_psi_rx_dot_by_motor_k_s,
        motor_psi_rx_dot_by_motor_alpha_r,
        motor_psi_ry_dot_by_motor_supply_frequency,
        motor_psi_ry_dot_by_motor_pole_pairs,
        motor_psi_ry_dot_by_motor_k_s,
        motor_psi_ry_dot_by_motor_alpha_r,
    ]
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
/// 27 operations.
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
        / motor_x_s_times_motor_sigma
        * (motor_psi_sy * motor_psi_rx).sub_product(motor_psi_sx, motor_psi_ry);
    Outputs {
        speed: motor_omega,
        torque: motor_torque,
        slip: R::literal(1.0) / motor_omega_0 * motor_slip_speed,
        stator_current: (motor_i_sx * motor_i_sx)
            .add_product(motor_i_sy, motor_i_sy)
            .sqrt(),
    }
}

/// T, V and the energy of first-order states \[J\].
///
/// 32 operations.
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
        stored: R::literal(0.75)
            * (motor_psi_sx * motor_i_sx)
                .add_product(motor_psi_sy, motor_i_sy)
                .add_product(motor_psi_rx, motor_i_rx)
                .add_product(motor_psi_ry, motor_i_ry),
    }
}

/// `dE/dt`, power supplied and power dissipated \[W\].
///
/// 106 operations.
#[must_use]
pub fn power_balance<R: Real>(
    _time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
) -> PowerBalance<R> {
    let [motor_omega, motor_psi_sx, motor_psi_sy, motor_psi_rx, motor_psi_ry] = *state;
    let (sin_motor_supply_phase, cos_motor_supply_phase) = p
        .motor_supply_phase
        .sin_cos();
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
        / motor_x_s_times_motor_sigma
        * (motor_psi_sy * motor_psi_rx).sub_product(motor_psi_sx, motor_psi_ry);
    let motor_omega_dot = motor_torque * (R::literal(1.0) / p.motor_inertia);
    let motor_alpha_s_times_motor_omega_0 = p.motor_alpha_s * motor_omega_0;
    let motor_psi_sx_dot = motor_u_x
        .add_product(motor_omega_0, motor_psi_sy)
        .sub_product(motor_alpha_s_times_motor_omega_0, t1);
    let motor_psi_sy_dot = motor_u_y
        .sub_product(motor_omega_0, motor_psi_sx)
        .sub_product(motor_alpha_s_times_motor_omega_0, t3);
    let motor_alpha_r_times_motor_omega_0 = p.motor_alpha_r * motor_omega_0;
    let motor_psi_rx_dot = (motor_psi_ry * motor_slip_speed)
        .add_product(
            motor_alpha_r_times_motor_omega_0,
            motor_k_s_times_motor_psi_sx - motor_psi_rx,
        );
    let motor_psi_ry_dot = (motor_alpha_r_times_motor_omega_0
        * (motor_k_s_times_motor_psi_sy - motor_psi_ry))
        .sub_product(motor_psi_rx, motor_slip_speed);
    let t5 = p.motor_k_r * motor_omega_0 / motor_x_s_times_motor_sigma;
    PowerBalance {
        stored_rate: (p.motor_inertia * motor_omega * motor_omega_dot)
            .add_product(
                R::literal(0.75)
                    * motor_i_sx
                        .add_product(t2, motor_psi_sx)
                        .sub_product(t5, motor_psi_rx),
                motor_psi_sx_dot,
            )
            .add_product(
                R::literal(0.75)
                    * motor_i_sy
                        .add_product(t2, motor_psi_sy)
                        .sub_product(t5, motor_psi_ry),
                motor_psi_sy_dot,
            )
            .add_product(
                R::literal(0.75)
                    * motor_i_rx
                        .add_product(t4, motor_psi_rx)
                        .sub_product(t5, motor_psi_sx),
                motor_psi_rx_dot,
            )
            .add_product(
                R::literal(0.75)
                    * motor_i_ry
                        .add_product(t4, motor_psi_ry)
                        .sub_product(t5, motor_psi_sy),
                motor_psi_ry_dot,
            ),
        supplied: R::literal(1.5)
            * (motor_u_x * motor_i_sx).add_product(motor_u_y, motor_i_sy),
        dissipated: R::literal(1.5)
            * (p.motor_x_s * p.motor_alpha_s * motor_sigma
                * (motor_i_sx * motor_i_sx).add_product(motor_i_sy, motor_i_sy))
                .add_product(
                    p.motor_alpha_r * motor_sigma * motor_x_r,
                    (motor_i_rx * motor_i_rx).add_product(motor_i_ry, motor_i_ry),
                ),
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
pub fn series<R: Real>(
    _time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
    coefficients: &mut [[R; STATES]],
    workspace: &mut [R],
) {
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
        let motor_slip_speed_k = -motor_omega_k * p.motor_pole_pairs;
        let t6_k = (-motor_psi_rx_k).mul_add(p.motor_k_r, motor_psi_sx_k);
        let t9_k = (-motor_psi_ry_k).mul_add(p.motor_k_r, motor_psi_sy_k);
        let t12_k = motor_psi_sx
            .mul_add(motor_psi_ry_k, motor_psi_ry.mul_add(motor_psi_sx_k, sums[0]));
        let t13_k = motor_psi_sy
            .mul_add(motor_psi_rx_k, motor_psi_rx.mul_add(motor_psi_sy_k, sums[1]));
        let t14_k = t13_k - t12_k;
        let motor_omega_dot_k = t14_k * t20;
        let motor_psi_sx_dot_k = (-t6_k).mul_add(t21, motor_psi_sy_k * motor_omega_0);
        let t27_k = -motor_psi_sx_k * motor_omega_0;
        let motor_psi_sy_dot_k = (-t9_k).mul_add(t21, t27_k);
        let t28_k = motor_psi_ry
            .mul_add(
                motor_slip_speed_k,
                motor_slip_speed.mul_add(motor_psi_ry_k, sums[2]),
            );
        let t29_k = motor_psi_sx_k.mul_add(p.motor_k_s, -motor_psi_rx_k);
        let motor_psi_rx_dot_k = t29_k.mul_add(t30, t28_k);
        let t32_k = motor_psi_rx
            .mul_add(
                motor_slip_speed_k,
                motor_slip_speed.mul_add(motor_psi_rx_k, sums[3]),
            );
        let t33_k = motor_psi_sy_k.mul_add(p.motor_k_s, -motor_psi_ry_k);
        let motor_psi_ry_dot_k = t33_k.mul_add(t30, -t32_k);
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

impl<R: Real> TaylorSeries<R> for MotorRunUp {
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

impl Describe for MotorRunUp {
    fn name(&self) -> &'static str {
        "motor_run_up"
    }
    fn title(&self) -> &'static str {
        "Induction motor running up empty"
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

impl<R: Real> Simulator<R> for MotorRunUp {
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

static PARAMETER_QUANTITIES: [Quantity<'static>; PARAMETERS] = [
    Quantity {
        name: "initial_speed",
        unit: "rad/s",
        doc: "speed at the start",
    },
    Quantity {
        name: "motor.inertia",
        unit: "kg m^2",
        doc: "moment of inertia of the rotor",
    },
    Quantity {
        name: "motor.phase_voltage",
        unit: "V",
        doc: "root mean square of the phase voltage",
    },
    Quantity {
        name: "motor.supply_frequency",
        unit: "Hz",
        doc: "frequency of the supply",
    },
    Quantity {
        name: "motor.supply_phase",
        unit: "rad",
        doc: "phase of the supply at the start",
    },
    Quantity {
        name: "motor.pole_pairs",
        unit: "1",
        doc: "pairs of poles",
    },
    Quantity {
        name: "motor.k_s",
        unit: "1",
        doc: "stator coupling factor x_mu/x_s",
    },
    Quantity {
        name: "motor.k_r",
        unit: "1",
        doc: "rotor coupling factor x_mu/x_r",
    },
    Quantity {
        name: "motor.x_s",
        unit: "ohm",
        doc: "stator reactance at supply frequency",
    },
    Quantity {
        name: "motor.alpha_s",
        unit: "1",
        doc: "stator decay r_s/(sigma x_s)",
    },
    Quantity {
        name: "motor.alpha_r",
        unit: "1",
        doc: "rotor decay r_r/(sigma x_r)",
    },
];

static PARAMETER_DEFAULTS: [f64; PARAMETERS] = [
    0.0,
    4.2,
    220.0,
    50.0,
    0.0,
    4.0,
    0.956,
    0.952,
    4.14,
    0.115,
    0.0858,
];

static OUTPUT_QUANTITIES: [Quantity<'static>; OUTPUTS] = [
    Quantity {
        name: "speed",
        unit: "rad/s",
        doc: "rotor speed",
    },
    Quantity {
        name: "torque",
        unit: "N m",
        doc: "electromagnetic torque",
    },
    Quantity {
        name: "slip",
        unit: "1",
        doc: "slip",
    },
    Quantity {
        name: "stator_current",
        unit: "A",
        doc: "amplitude of the stator current",
    },
];

/// The run the spec asks for.
pub const RUN_DEFAULTS: RunDefaults<'static> = RunDefaults {
    from: 0.0,
    until: 2.0,
    points: 2001,
    rtol: 1e-8,
    method: "tsit45",
};

// Emitted by Machinist 0.1.0; do not edit. To make it again:
//
//     cargo run --release -- gen
//
// Sources, with SHA-256:
//   8f45f0151bd7f9b04f50979fb7764e35ffae7dd1654b0dd483ce7f48b551ad63  scenes/motor_stationary_axes.toml
//   e8422c9ed02eea8c3a709bd8932dbac067c759a5c771209ef9b59cb86800c611  units/induction_motor_stationary.toml
//
// Induction motor running up empty, from its co-energy
//
// The run-up of `motor_run_up` with charges as coordinates: the same torque and speed by another way.
//
// Source:
//   Saw-gin study (2020), motor of equations (2), as a Lagrangian.
//
// Shapes; all quantities are in SI units:
//   coordinates               5
//   first-order states        0
//   states                    6
//   parameters               11
//   outputs                   9
//   discontinuities           0
//
// State:
//     0  motor.phi    [rad]    rotor angle
//     1  motor.i_sa   [C/s]    rate of charge passed by the stator winding along alpha
//     2  motor.i_sb   [C/s]    rate of charge passed by the stator winding along beta
//     3  motor.i_ra   [C/s]    rate of charge passed by the rotor's first winding
//     4  motor.i_rb   [C/s]    rate of charge passed by the rotor's second winding
//     5  motor.omega  [rad/s]  rate of rotor angle
//
// Nonzeros:
//   mass_matrix              13 of 5 by 5
//   rate_jacobian            30 of 6 by 6
//   parameter_jacobian       41 of 6 by 11
//
// Operations:
//   initial_state             0
//   discontinuities           0
//   rate                    121
//   mass_matrix              13
//   forcing                  73
//   rate_jacobian           321
//   parameter_jacobian      580
//   time_derivative          63
//   outputs                  25
//   energy                   33
//   power_balance           173
// With constants of the parameters, prepared once a run:
//   prepare                  35
//   prepared_rate           101
//   prepared_rate_jacobian  286

use crate::{
    Describe, Energy, PowerBalance, Quantity, Real, RunDefaults, Shape, Simulator,
    SparsityPattern, StateKind,
    taylor::{Factored, Lanes, TaylorSeries, order_and_inverse},
};

/// Generalized coordinates, n.
pub const COORDINATES: usize = 5;

/// Length of the state y.
pub const STATES: usize = 6;

/// Parameters.
pub const PARAMETERS: usize = 11;

/// Wanted outputs.
pub const OUTPUTS: usize = 9;

/// Times at which the right-hand side jumps.
pub const DISCONTINUITIES: usize = 0;

/// Nonzeros of M, both triangles.
pub const MASS_MATRIX_PATTERN: SparsityPattern<'static> = SparsityPattern {
    rows: 5,
    columns: 5,
    entries: &[
        (0, 0),
        (0, 2),
        (0, 3),
        (1, 1),
        (1, 2),
        (1, 3),
        (2, 0),
        (2, 1),
        (2, 2),
        (3, 0),
        (3, 1),
        (3, 3),
        (4, 4),
    ],
};

/// Nonzeros of dy'/dy.
pub const RATE_JACOBIAN_PATTERN: SparsityPattern<'static> = SparsityPattern {
    rows: 6,
    columns: 6,
    entries: &[
        (0, 5),
        (1, 0),
        (1, 1),
        (1, 2),
        (1, 3),
        (1, 4),
        (1, 5),
        (2, 0),
        (2, 1),
        (2, 2),
        (2, 3),
        (2, 4),
        (2, 5),
        (3, 0),
        (3, 1),
        (3, 2),
        (3, 3),
        (3, 4),
        (3, 5),
        (4, 0),
        (4, 1),
        (4, 2),
        (4, 3),
        (4, 4),
        (4, 5),
        (5, 0),
        (5, 1),
        (5, 2),
        (5, 3),
        (5, 4),
    ],
};

/// Nonzeros of dy'/dp.
pub const PARAMETER_JACOBIAN_PATTERN: SparsityPattern<'static> = SparsityPattern {
    rows: 6,
    columns: 11,
    entries: &[
        (1, 2),
        (1, 3),
        (1, 4),
        (1, 5),
        (1, 6),
        (1, 7),
        (1, 8),
        (1, 9),
        (1, 10),
        (2, 2),
        (2, 3),
        (2, 4),
        (2, 5),
        (2, 6),
        (2, 7),
        (2, 8),
        (2, 9),
        (2, 10),
        (3, 2),
        (3, 3),
        (3, 4),
        (3, 5),
        (3, 6),
        (3, 7),
        (3, 8),
        (3, 9),
        (3, 10),
        (4, 2),
        (4, 3),
        (4, 4),
        (4, 5),
        (4, 6),
        (4, 7),
        (4, 8),
        (4, 9),
        (4, 10),
        (5, 1),
        (5, 3),
        (5, 5),
        (5, 6),
        (5, 8),
    ],
};

/// Induction motor running up empty, from its co-energy
///
/// The run-up of \`motor_run_up\` with charges as coordinates: the same torque and speed by another way.
///
/// Source: Saw-gin study (2020), motor of equations (2), as a Lagrangian.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct MotorStationaryAxes;

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
    /// motor.alpha_s: stator decay R_s/(sigma x_s) \[1\]. In the spec: 0.115.
    pub motor_alpha_s: R,
    /// motor.alpha_r: rotor decay R_r/(sigma x_r) \[1\]. In the spec: 0.0858.
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
    /// stator_alpha: rate of charge passed by the stator winding along alpha \[C/s\].
    pub stator_alpha: R,
    /// stator_beta: rate of charge passed by the stator winding along beta \[C/s\].
    pub stator_beta: R,
    /// rotor_first: rate of charge passed by the rotor's first winding \[C/s\].
    pub rotor_first: R,
    /// rotor_second: rate of charge passed by the rotor's second winding \[C/s\].
    pub rotor_second: R,
    /// angle: rotor angle \[rad\].
    pub angle: R,
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
            stator_alpha: values[4],
            stator_beta: values[5],
            rotor_first: values[6],
            rotor_second: values[7],
            angle: values[8],
        }
    }
    /// The numbers in their order.
    #[must_use]
    #[inline]
    pub fn to_array(self) -> [R; OUTPUTS] {
        [
            self.speed,
            self.torque,
            self.slip,
            self.stator_current,
            self.stator_alpha,
            self.stator_beta,
            self.rotor_first,
            self.rotor_second,
            self.angle,
        ]
    }
}

/// Where to find what in the state.
pub mod state {
    /// motor.phi: rotor angle \[rad\].
    pub const MOTOR_PHI: usize = 0;
    /// motor.i_sa: rate of charge passed by the stator winding along alpha \[C/s\].
    pub const MOTOR_I_SA: usize = 1;
    /// motor.i_sb: rate of charge passed by the stator winding along beta \[C/s\].
    pub const MOTOR_I_SB: usize = 2;
    /// motor.i_ra: rate of charge passed by the rotor's first winding \[C/s\].
    pub const MOTOR_I_RA: usize = 3;
    /// motor.i_rb: rate of charge passed by the rotor's second winding \[C/s\].
    pub const MOTOR_I_RB: usize = 4;
    /// motor.omega: rate of rotor angle \[rad/s\].
    pub const MOTOR_OMEGA: usize = 5;
}

/// Constants that `prepare` computes.
pub const CONSTANTS: usize = 16;

#[allow(missing_docs, reason = "`prepare` says what each is")]
/// What parameters alone decide; `prepare` says what each is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Constants<R> {
    pub motor_omega_0: R,
    pub t0: R,
    pub t1: R,
    pub t2: R,
    pub t3: R,
    pub inverse_motor_inertia: R,
    pub t4: R,
    pub t6: R,
    pub t7: R,
    pub motor_pole_pairs_squared: R,
    pub t8: R,
    pub t9: R,
    pub t11: R,
    pub t12: R,
    pub t13: R,
    pub t14: R,
}

impl<R: Real> Constants<R> {
    /// From the numbers in their order.
    #[must_use]
    #[inline]
    pub fn from_array(values: [R; CONSTANTS]) -> Self {
        Self {
            motor_omega_0: values[0],
            t0: values[1],
            t1: values[2],
            t2: values[3],
            t3: values[4],
            inverse_motor_inertia: values[5],
            t4: values[6],
            t6: values[7],
            t7: values[8],
            motor_pole_pairs_squared: values[9],
            t8: values[10],
            t9: values[11],
            t11: values[12],
            t12: values[13],
            t13: values[14],
            t14: values[15],
        }
    }
    /// The numbers in their order.
    #[must_use]
    #[inline]
    pub fn to_array(self) -> [R; CONSTANTS] {
        [
            self.motor_omega_0,
            self.t0,
            self.t1,
            self.t2,
            self.t3,
            self.inverse_motor_inertia,
            self.t4,
            self.t6,
            self.t7,
            self.motor_pole_pairs_squared,
            self.t8,
            self.t9,
            self.t11,
            self.t12,
            self.t13,
            self.t14,
        ]
    }
}

/// What `rate` and `rate_jacobian` need of the parameters, once a run.
///
/// 35 operations.
#[must_use]
#[inline]
pub fn prepare<R: Real>(p: &Parameters<R>) -> Constants<R> {
    let motor_omega_0 = R::literal(core::f64::consts::TAU) * p.motor_supply_frequency;
    let t0 = p.motor_phase_voltage * R::literal(core::f64::consts::SQRT_2);
    let motor_L_s = p.motor_x_s / motor_omega_0;
    let motor_M = p.motor_k_s * motor_L_s;
    let t1 = R::literal(1.5) * motor_M;
    let motor_L_r = motor_M / p.motor_k_r;
    let t2 = R::literal(1.5) * motor_L_r;
    let t3 = R::literal(1.0) / (R::literal(1.5) * motor_L_s);
    let inverse_motor_inertia = R::literal(1.0) / p.motor_inertia;
    let motor_x_s_times_motor_alpha_s = p.motor_x_s * p.motor_alpha_s;
    let motor_sigma = R::literal(1.0) - p.motor_k_s * p.motor_k_r;
    let motor_R_s = motor_x_s_times_motor_alpha_s * motor_sigma;
    let t4 = R::literal(1.5) * motor_R_s;
    let t5 = p.motor_k_s * p.motor_x_s * p.motor_alpha_r;
    let motor_R_r = t5 * motor_sigma / p.motor_k_r;
    let t6 = R::literal(1.5) * motor_R_r;
    let t7 = R::literal(1.5) * p.motor_pole_pairs * motor_M;
    let motor_pole_pairs_squared = p.motor_pole_pairs * p.motor_pole_pairs;
    let t8 = t1 * motor_pole_pairs_squared;
    let t9 = R::literal(2.0) * motor_M * motor_pole_pairs_squared;
    let t10 = R::literal(1.5) * p.motor_k_s * p.motor_k_r - R::literal(1.5);
    let t11 = motor_x_s_times_motor_alpha_s * t10;
    let t12 = t11 * t3;
    let t13 = t5 * t10 / p.motor_k_r;
    let t14 = R::literal(2.0) * p.motor_pole_pairs * motor_M;
    Constants {
        motor_omega_0,
        t0,
        t1,
        t2,
        t3,
        inverse_motor_inertia,
        t4,
        t6,
        t7,
        motor_pole_pairs_squared,
        t8,
        t9,
        t11,
        t12,
        t13,
        t14,
    }
}

/// State at the start of the run, in the units of the states.
///
/// No operations.
#[must_use]
pub fn initial_state<R: Real>(p: &Parameters<R>) -> [R; STATES] {
    [
        R::literal(0.0),
        R::literal(0.0),
        R::literal(0.0),
        R::literal(0.0),
        R::literal(0.0),
        p.initial_speed,
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
/// 121 operations.
#[must_use]
#[inline]
pub fn rate<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>) -> [R; STATES] {
    prepared_rate(time, state, p, &prepare(p))
}

/// As `rate`, with the constants of the parameters from `prepare`.
///
/// 101 operations.
#[must_use]
#[inline]
pub fn prepared_rate<R: Real>(
    time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
    c: &Constants<R>,
) -> [R; STATES] {
    let [motor_phi, motor_i_sa, motor_i_sb, motor_i_ra, motor_i_rb, motor_omega] = *state;
    let motor_theta = p.motor_pole_pairs * motor_phi;
    let motor_along = motor_i_sa * motor_i_ra + motor_i_sb * motor_i_rb;
    let motor_across = motor_i_sb * motor_i_ra - motor_i_sa * motor_i_rb;
    let t0 = p.motor_supply_phase + c.motor_omega_0 * time;
    let motor_u_a = c.t0 * t0.cos();
    let motor_u_b = c.t0 * t0.sin();
    let sin_motor_theta = motor_theta.sin();
    let cos_motor_theta = motor_theta.cos();
    let t1 = c.t1 * cos_motor_theta;
    let t2 = c.t1 * sin_motor_theta;
    let t3 = t1 * c.t3;
    let t4 = t2 * c.t3;
    let t5 = t3 * t1;
    let t6 = t4 * t2;
    let t7 = R::literal(1.0) / (c.t2 - t5 - t6);
    let t8 = t4 * t1 - t3 * t2;
    let t9 = t8 * t7;
    let motor_pole_pairs_times_motor_i_ra = p.motor_pole_pairs * motor_i_ra;
    let motor_pole_pairs_times_motor_i_rb = p.motor_pole_pairs * motor_i_rb;
    let t10 = c.t1 * motor_omega;
    let t11 = R::literal(1.5) * motor_u_a - c.t4 * motor_i_sa
        - t10
            * (-(motor_pole_pairs_times_motor_i_ra * sin_motor_theta)
                - motor_pole_pairs_times_motor_i_rb * cos_motor_theta);
    let t12 = R::literal(1.5) * motor_u_b - c.t4 * motor_i_sb
        - t10
            * (motor_pole_pairs_times_motor_i_ra * cos_motor_theta
                - motor_pole_pairs_times_motor_i_rb * sin_motor_theta);
    let motor_pole_pairs_times_motor_i_sa = p.motor_pole_pairs * motor_i_sa;
    let motor_pole_pairs_times_motor_i_sb = p.motor_pole_pairs * motor_i_sb;
    let t13 = -(c.t6 * motor_i_ra)
        - t10
            * (motor_pole_pairs_times_motor_i_sb * cos_motor_theta
                - motor_pole_pairs_times_motor_i_sa * sin_motor_theta) - t3 * t11
        - t4 * t12;
    let motor_i_rb_dot = (-(c.t6 * motor_i_rb)
        - t10
            * (-(motor_pole_pairs_times_motor_i_sa * cos_motor_theta)
                - motor_pole_pairs_times_motor_i_sb * sin_motor_theta) + t4 * t11
        - t3 * t12 - t9 * t13) * (R::literal(1.0) / (c.t2 - t6 - t5 - t9 * t8));
    let motor_omega_dot = c.t1
        * (p.motor_pole_pairs * motor_across * cos_motor_theta
            - p.motor_pole_pairs * motor_along * sin_motor_theta)
        * c.inverse_motor_inertia;
    let motor_i_ra_dot = t13 * t7 - t9 * motor_i_rb_dot;
    let motor_i_sb_dot = t12 * c.t3 - t4 * motor_i_ra_dot - t3 * motor_i_rb_dot;
    let motor_i_sa_dot = t11 * c.t3 - t3 * motor_i_ra_dot + t4 * motor_i_rb_dot;
    [
        motor_omega,
        motor_i_sa_dot,
        motor_i_sb_dot,
        motor_i_ra_dot,
        motor_i_rb_dot,
        motor_omega_dot,
    ]
}

/// `M = d2L/dq'2`, values in the order of `MASS_MATRIX_PATTERN`.
///
/// 13 operations.
#[must_use]
pub fn mass_matrix<R: Real>(
    _time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
) -> [R; 13] {
    let [motor_phi, ..] = *state;
    let motor_theta = p.motor_pole_pairs * motor_phi;
    let motor_omega_0 = R::literal(core::f64::consts::TAU) * p.motor_supply_frequency;
    let motor_L_s = p.motor_x_s / motor_omega_0;
    let motor_M = p.motor_k_s * motor_L_s;
    let motor_L_r = motor_M / p.motor_k_r;
    let t0 = R::literal(1.5) * motor_L_s;
    let t1 = R::literal(1.5) * motor_M;
    let t2 = t1 * motor_theta.cos();
    let t3 = t1 * motor_theta.sin();
    let t4 = -t3;
    let t5 = R::literal(1.5) * motor_L_r;
    [t0, t2, t4, t0, t3, t2, t2, t3, t5, t4, t2, t5, p.motor_inertia]
}

/// `f` of `M q'' = f(q, q', z, t)`, one for each coordinate.
///
/// 73 operations.
#[must_use]
pub fn forcing<R: Real>(
    time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
) -> [R; COORDINATES] {
    let [motor_phi, motor_i_sa, motor_i_sb, motor_i_ra, motor_i_rb, motor_omega] = *state;
    let motor_theta = p.motor_pole_pairs * motor_phi;
    let motor_omega_0 = R::literal(core::f64::consts::TAU) * p.motor_supply_frequency;
    let motor_sigma = R::literal(1.0) - p.motor_k_s * p.motor_k_r;
    let motor_along = motor_i_sa * motor_i_ra + motor_i_sb * motor_i_rb;
    let motor_across = motor_i_sb * motor_i_ra - motor_i_sa * motor_i_rb;
    let motor_L_s = p.motor_x_s / motor_omega_0;
    let motor_R_s = p.motor_x_s * p.motor_alpha_s * motor_sigma;
    let motor_M = p.motor_k_s * motor_L_s;
    let t0 = p.motor_supply_phase + motor_omega_0 * time;
    let t1 = p.motor_phase_voltage * R::literal(core::f64::consts::SQRT_2);
    let motor_u_a = t1 * t0.cos();
    let motor_u_b = t1 * t0.sin();
    let motor_R_r = p.motor_k_s * p.motor_x_s * p.motor_alpha_r * motor_sigma
        / p.motor_k_r;
    let sin_motor_theta = motor_theta.sin();
    let cos_motor_theta = motor_theta.cos();
    let t2 = R::literal(1.5) * motor_M;
    let t3 = R::literal(1.5) * motor_R_s;
    let motor_pole_pairs_times_motor_i_ra = p.motor_pole_pairs * motor_i_ra;
    let motor_pole_pairs_times_motor_i_rb = p.motor_pole_pairs * motor_i_rb;
    let t4 = t2 * motor_omega;
    let motor_q_sa_forcing = R::literal(1.5) * motor_u_a - t3 * motor_i_sa
        - t4
            * (-(motor_pole_pairs_times_motor_i_ra * sin_motor_theta)
                - motor_pole_pairs_times_motor_i_rb * cos_motor_theta);
    let motor_q_sb_forcing = R::literal(1.5) * motor_u_b - t3 * motor_i_sb
        - t4
            * (motor_pole_pairs_times_motor_i_ra * cos_motor_theta
                - motor_pole_pairs_times_motor_i_rb * sin_motor_theta);
    let t5 = R::literal(1.5) * motor_R_r;
    let motor_pole_pairs_times_motor_i_sa = p.motor_pole_pairs * motor_i_sa;
    let motor_pole_pairs_times_motor_i_sb = p.motor_pole_pairs * motor_i_sb;
    let motor_q_ra_forcing = -(t5 * motor_i_ra)
        - t4
            * (motor_pole_pairs_times_motor_i_sb * cos_motor_theta
                - motor_pole_pairs_times_motor_i_sa * sin_motor_theta);
    let motor_q_rb_forcing = -(t5 * motor_i_rb)
        - t4
            * (-(motor_pole_pairs_times_motor_i_sa * cos_motor_theta)
                - motor_pole_pairs_times_motor_i_sb * sin_motor_theta);
    let motor_phi_forcing = t2
        * (p.motor_pole_pairs * motor_across * cos_motor_theta
            - p.motor_pole_pairs * motor_along * sin_motor_theta);
    [
        motor_q_sa_forcing,
        motor_q_sb_forcing,
        motor_q_ra_forcing,
        motor_q_rb_forcing,
        motor_phi_forcing,
    ]
}

/// `dy'/dy`, values in the order of `RATE_JACOBIAN_PATTERN`.
///
/// 321 operations.
#[must_use]
#[inline]
pub fn rate_jacobian<R: Real>(
    time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
) -> [R; 30] {
    prepared_rate_jacobian(time, state, p, &prepare(p))
}

/// As `rate_jacobian`, with the constants of the parameters from `prepare`.
///
/// 286 operations.
#[must_use]
pub fn prepared_rate_jacobian<R: Real>(
    time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
    c: &Constants<R>,
) -> [R; 30] {
    let [motor_phi, motor_i_sa, motor_i_sb, motor_i_ra, motor_i_rb, motor_omega] = *state;
    let motor_theta = p.motor_pole_pairs * motor_phi;
    let motor_along = motor_i_sa * motor_i_ra + motor_i_sb * motor_i_rb;
    let motor_across = motor_i_sb * motor_i_ra - motor_i_sa * motor_i_rb;
    let t0 = p.motor_supply_phase + c.motor_omega_0 * time;
    let motor_u_a = c.t0 * t0.cos();
    let motor_u_b = c.t0 * t0.sin();
    let sin_motor_theta = motor_theta.sin();
    let cos_motor_theta = motor_theta.cos();
    let t1 = c.t1 * cos_motor_theta;
    let t2 = c.t1 * sin_motor_theta;
    let t3 = t1 * c.t3;
    let t4 = t2 * c.t3;
    let t5 = t3 * t1;
    let t6 = t4 * t2;
    let t7 = R::literal(1.0) / (c.t2 - t5 - t6);
    let t8 = t4 * t1 - t3 * t2;
    let t9 = t8 * t7;
    let t10 = R::literal(1.0) / (c.t2 - t6 - t5 - t9 * t8);
    let motor_pole_pairs_times_motor_i_ra = p.motor_pole_pairs * motor_i_ra;
    let motor_pole_pairs_times_motor_i_rb = p.motor_pole_pairs * motor_i_rb;
    let t11 = c.t1 * motor_omega;
    let t12 = R::literal(1.5) * motor_u_a - c.t4 * motor_i_sa
        - t11
            * (-(motor_pole_pairs_times_motor_i_ra * sin_motor_theta)
                - motor_pole_pairs_times_motor_i_rb * cos_motor_theta);
    let t13 = R::literal(1.5) * motor_u_b - c.t4 * motor_i_sb
        - t11
            * (motor_pole_pairs_times_motor_i_ra * cos_motor_theta
                - motor_pole_pairs_times_motor_i_rb * sin_motor_theta);
    let motor_pole_pairs_times_motor_i_sa = p.motor_pole_pairs * motor_i_sa;
    let motor_pole_pairs_times_motor_i_sb = p.motor_pole_pairs * motor_i_sb;
    let t14 = motor_pole_pairs_times_motor_i_sb * cos_motor_theta
        - motor_pole_pairs_times_motor_i_sa * sin_motor_theta;
    let t15 = -(c.t6 * motor_i_ra) - t11 * t14 - t3 * t12 - t4 * t13;
    let motor_i_rb_dot = (-(c.t6 * motor_i_rb)
        - t11
            * (-(motor_pole_pairs_times_motor_i_sa * cos_motor_theta)
                - motor_pole_pairs_times_motor_i_sb * sin_motor_theta) + t4 * t12
        - t3 * t13 - t9 * t15) * t10;
    let motor_i_ra_dot = t15 * t7 - t9 * motor_i_rb_dot;
    let motor_i_sb_dot = t13 * c.t3 - t4 * motor_i_ra_dot - t3 * motor_i_rb_dot;
    let motor_i_sa_dot = t12 * c.t3 - t3 * motor_i_ra_dot + t4 * motor_i_rb_dot;
    let t16 = motor_i_ra * cos_motor_theta - motor_i_rb * sin_motor_theta;
    let t17 = c.t8 * motor_omega;
    let t18 = motor_i_ra * sin_motor_theta + motor_i_rb * cos_motor_theta;
    let t19 = motor_i_sa * cos_motor_theta + motor_i_sb * sin_motor_theta;
    let t20 = c.t7 * sin_motor_theta;
    let t21 = c.t7 * cos_motor_theta;
    let t22 = t17 * t16 + t20 * motor_i_ra_dot + t21 * motor_i_rb_dot;
    let t23 = t17 * t18 - t21 * motor_i_ra_dot + t20 * motor_i_rb_dot;
    let t24 = t17 * t19 + t20 * motor_i_sa_dot - t21 * motor_i_sb_dot - t3 * t22
        - t4 * t23;
    let motor_i_rb_dot_by_motor_phi = (c.t9 * motor_omega
        * (R::literal(0.75) * motor_i_sb * cos_motor_theta
            - R::literal(0.75) * motor_i_sa * sin_motor_theta) + t21 * motor_i_sa_dot
        + t20 * motor_i_sb_dot + t4 * t22 - t3 * t23 - t9 * t24) * t10;
    let motor_omega_dot_by_motor_phi = c.t1
        * (-(c.motor_pole_pairs_squared * motor_along * cos_motor_theta)
            - c.motor_pole_pairs_squared * motor_across * sin_motor_theta)
        * c.inverse_motor_inertia;
    let motor_i_ra_dot_by_motor_phi = t24 * t7 - t9 * motor_i_rb_dot_by_motor_phi;
    let motor_i_sb_dot_by_motor_phi = t23 * c.t3 - t4 * motor_i_ra_dot_by_motor_phi
        - t3 * motor_i_rb_dot_by_motor_phi;
    let motor_i_sa_dot_by_motor_phi = t22 * c.t3 - t3 * motor_i_ra_dot_by_motor_phi
        + t4 * motor_i_rb_dot_by_motor_phi;
    let t25 = c.t7 * motor_omega;
    let t26 = t25 * sin_motor_theta;
    let t27 = t25 * cos_motor_theta;
    let t28 = c.t7 * t18;
    let t29 = t26 - t3 * c.t11;
    let t30 = t4 * c.t11;
    let motor_i_rb_dot_by_motor_i_sa = (t27 + t30 - t9 * t29) * t10;
    let motor_omega_dot_by_motor_i_sa = -(t28 * c.inverse_motor_inertia);
    let motor_i_ra_dot_by_motor_i_sa = t29 * t7 - t9 * motor_i_rb_dot_by_motor_i_sa;
    let motor_i_sb_dot_by_motor_i_sa = -(t4 * motor_i_ra_dot_by_motor_i_sa)
        - t3 * motor_i_rb_dot_by_motor_i_sa;
    let motor_i_sa_dot_by_motor_i_sa = c.t12 - t3 * motor_i_ra_dot_by_motor_i_sa
        + t4 * motor_i_rb_dot_by_motor_i_sa;
    let t31 = -t27 - t30;
    let motor_i_rb_dot_by_motor_i_sb = (t29 - t9 * t31) * t10;
    let motor_omega_dot_by_motor_i_sb = c.t7 * t16 * c.inverse_motor_inertia;
    let motor_i_ra_dot_by_motor_i_sb = t31 * t7 - t9 * motor_i_rb_dot_by_motor_i_sb;
    let motor_i_sb_dot_by_motor_i_sb = c.t12 - t4 * motor_i_ra_dot_by_motor_i_sb
        - t3 * motor_i_rb_dot_by_motor_i_sb;
    let motor_i_sa_dot_by_motor_i_sb = t4 * motor_i_rb_dot_by_motor_i_sb
        - t3 * motor_i_ra_dot_by_motor_i_sb;
    let t32 = t3 * t26;
    let t33 = t4 * t27;
    let t34 = c.t13 - t32 + t33;
    let t35 = t4 * t26;
    let t36 = t3 * t27;
    let t37 = t26 * c.t3;
    let t38 = t27 * c.t3;
    let motor_i_rb_dot_by_motor_i_ra = (t35 + t36 - t9 * t34) * t10;
    let motor_omega_dot_by_motor_i_ra = c.t1 * t14 * c.inverse_motor_inertia;
    let motor_i_ra_dot_by_motor_i_ra = t34 * t7 - t9 * motor_i_rb_dot_by_motor_i_ra;
    let motor_i_sb_dot_by_motor_i_ra = -t38 - t4 * motor_i_ra_dot_by_motor_i_ra
        - t3 * motor_i_rb_dot_by_motor_i_ra;
    let motor_i_sa_dot_by_motor_i_ra = t37 - t3 * motor_i_ra_dot_by_motor_i_ra
        + t4 * motor_i_rb_dot_by_motor_i_ra;
    let t39 = c.t7 * t19;
    let t40 = -t36 - t35;
    let motor_i_rb_dot_by_motor_i_rb = (c.t13 + t33 - t32 - t9 * t40) * t10;
    let motor_omega_dot_by_motor_i_rb = -(t39 * c.inverse_motor_inertia);
    let motor_i_ra_dot_by_motor_i_rb = t40 * t7 - t9 * motor_i_rb_dot_by_motor_i_rb;
    let motor_i_sb_dot_by_motor_i_rb = t37 - t4 * motor_i_ra_dot_by_motor_i_rb
        - t3 * motor_i_rb_dot_by_motor_i_rb;
    let motor_i_sa_dot_by_motor_i_rb = t38 - t3 * motor_i_ra_dot_by_motor_i_rb
        + t4 * motor_i_rb_dot_by_motor_i_rb;
    let t41 = c.t14
        * (R::literal(0.75) * motor_i_rb * sin_motor_theta
            - R::literal(0.75) * motor_i_ra * cos_motor_theta);
    let t42 = c.t7 * (motor_i_sa * sin_motor_theta - motor_i_sb * cos_motor_theta)
        - t3 * t28 - t4 * t41;
    let motor_i_rb_dot_by_motor_omega = (t39 + t4 * t28 - t3 * t41 - t9 * t42) * t10;
    let motor_i_ra_dot_by_motor_omega = t42 * t7 - t9 * motor_i_rb_dot_by_motor_omega;
    let motor_i_sb_dot_by_motor_omega = t41 * c.t3 - t4 * motor_i_ra_dot_by_motor_omega
        - t3 * motor_i_rb_dot_by_motor_omega;
    let motor_i_sa_dot_by_motor_omega = t28 * c.t3 - t3 * motor_i_ra_dot_by_motor_omega
        + t4 * motor_i_rb_dot_by_motor_omega;
    [
        R::literal(1.0),
        motor_i_sa_dot_by_motor_phi,
        motor_i_sa_dot_by_motor_i_sa,
        motor_i_sa_dot_by_motor_i_sb,
        motor_i_sa_dot_by_motor_i_ra,
        motor_i_sa_dot_by_motor_i_rb,
        motor_i_sa_dot_by_motor_omega,
        motor_i_sb_dot_by_motor_phi,
        motor_i_sb_dot_by_motor_i_sa,
        motor_i_sb_dot_by_motor_i_sb,
        motor_i_sb_dot_by_motor_i_ra,
        motor_i_sb_dot_by_motor_i_rb,
        motor_i_sb_dot_by_motor_omega,
        motor_i_ra_dot_by_motor_phi,
        motor_i_ra_dot_by_motor_i_sa,
        motor_i_ra_dot_by_motor_i_sb,
        motor_i_ra_dot_by_motor_i_ra,
        motor_i_ra_dot_by_motor_i_rb,
        motor_i_ra_dot_by_motor_omega,
        motor_i_rb_dot_by_motor_phi,
        motor_i_rb_dot_by_motor_i_sa,
        motor_i_rb_dot_by_motor_i_sb,
        motor_i_rb_dot_by_motor_i_ra,
        motor_i_rb_dot_by_motor_i_rb,
        motor_i_rb_dot_by_motor_omega,
        motor_omega_dot_by_motor_phi,
        motor_omega_dot_by_motor_i_sa,
        motor_omega_dot_by_motor_i_sb,
        motor_omega_dot_by_motor_i_ra,
        motor_omega_dot_by_motor_i_rb,
    ]
}

/// `dy'/dp`, values in the order of `PARAMETER_JACOBIAN_PATTERN`.
///
/// 580 operations.
#[must_use]
pub fn parameter_jacobian<R: Real>(
    time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
) -> [R; 41] {
    let [motor_phi, motor_i_sa, motor_i_sb, motor_i_ra, motor_i_rb, motor_omega] = *state;
    let motor_theta = p.motor_pole_pairs * motor_phi;
    let motor_omega_0 = R::literal(core::f64::consts::TAU) * p.motor_supply_frequency;
    let motor_sigma = R::literal(1.0) - p.motor_k_s * p.motor_k_r;
    let motor_along = motor_i_sa * motor_i_ra + motor_i_sb * motor_i_rb;
    let motor_across = motor_i_sb * motor_i_ra - motor_i_sa * motor_i_rb;
    let motor_L_s = p.motor_x_s / motor_omega_0;
    let motor_R_s = p.motor_x_s * p.motor_alpha_s * motor_sigma;
    let motor_M = p.motor_k_s * motor_L_s;
    let t0 = p.motor_supply_phase + motor_omega_0 * time;
    let t1 = t0.cos();
    let t2 = p.motor_phase_voltage * R::literal(core::f64::consts::SQRT_2);
    let motor_u_a = t2 * t1;
    let t3 = t0.sin();
    let motor_u_b = t2 * t3;
    let motor_L_r = motor_M / p.motor_k_r;
    let motor_k_s_times_motor_x_s = p.motor_k_s * p.motor_x_s;
    let motor_R_r = motor_k_s_times_motor_x_s * p.motor_alpha_r * motor_sigma
        / p.motor_k_r;
    let sin_motor_theta = motor_theta.sin();
    let cos_motor_theta = motor_theta.cos();
    let t4 = R::literal(1.5) * p.motor_pole_pairs;
    let t5 = R::literal(1.5) * motor_L_s;
    let t6 = R::literal(1.5) * motor_M;
    let t7 = t6 * cos_motor_theta;
    let t8 = t6 * sin_motor_theta;
    let t9 = R::literal(1.5) * motor_L_r;
    let t10 = R::literal(1.0) / t5;
    let t11 = t7 * t10;
    let t12 = t8 * t10;
    let t13 = t11 * t7;
    let t14 = t12 * t8;
    let t15 = R::literal(1.0) / (t9 - t13 - t14);
    let t16 = t12 * t7 - t11 * t8;
    let t17 = t16 * t15;
    let t18 = R::literal(1.0) / (t9 - t14 - t13 - t17 * t16);
    let inverse_motor_inertia = R::literal(1.0) / p.motor_inertia;
    let t19 = R::literal(1.5) * motor_R_s;
    let motor_pole_pairs_times_motor_i_ra = p.motor_pole_pairs * motor_i_ra;
    let motor_pole_pairs_times_motor_i_rb = p.motor_pole_pairs * motor_i_rb;
    let t20 = -(motor_pole_pairs_times_motor_i_ra * sin_motor_theta)
        - motor_pole_pairs_times_motor_i_rb * cos_motor_theta;
    let t21 = t6 * motor_omega;
    let t22 = R::literal(1.5) * motor_u_a;
    let t23 = t22 - t19 * motor_i_sa - t21 * t20;
    let t24 = motor_pole_pairs_times_motor_i_ra * cos_motor_theta
        - motor_pole_pairs_times_motor_i_rb * sin_motor_theta;
    let t25 = R::literal(1.5) * motor_u_b;
    let t26 = t25 - t19 * motor_i_sb - t21 * t24;
    let t27 = R::literal(1.5) * motor_R_r;
    let motor_pole_pairs_times_motor_i_sa = p.motor_pole_pairs * motor_i_sa;
    let motor_pole_pairs_times_motor_i_sb = p.motor_pole_pairs * motor_i_sb;
    let t28 = motor_pole_pairs_times_motor_i_sb * cos_motor_theta
        - motor_pole_pairs_times_motor_i_sa * sin_motor_theta;
    let t29 = -(motor_pole_pairs_times_motor_i_sa * cos_motor_theta)
        - motor_pole_pairs_times_motor_i_sb * sin_motor_theta;
    let t30 = p.motor_pole_pairs * motor_across * cos_motor_theta
        - p.motor_pole_pairs * motor_along * sin_motor_theta;
    let t31 = -(t27 * motor_i_ra) - t21 * t28 - t11 * t23 - t12 * t26;
    let motor_i_rb_dot = (-(t27 * motor_i_rb) - t21 * t29 + t12 * t23 - t11 * t26
        - t17 * t31) * t18;
    let motor_omega_dot = t6 * t30 * inverse_motor_inertia;
    let motor_i_ra_dot = t31 * t15 - t17 * motor_i_rb_dot;
    let motor_i_sb_dot = t26 * t10 - t12 * motor_i_ra_dot - t11 * motor_i_rb_dot;
    let motor_i_sa_dot = t23 * t10 - t11 * motor_i_ra_dot + t12 * motor_i_rb_dot;
    let motor_i_sa_times_cos_motor_theta = motor_i_sa * cos_motor_theta;
    let motor_i_sb_times_sin_motor_theta = motor_i_sb * sin_motor_theta;
    let t32 = R::literal(1.5) * p.motor_k_s;
    let t33 = t32 * p.motor_k_r - R::literal(1.5);
    let motor_omega_dot_by_motor_inertia = -(motor_omega_dot * inverse_motor_inertia);
    let t34 = R::literal(2.121_320_343_559_643) * t1;
    let t35 = R::literal(2.121_320_343_559_643) * t3;
    let t36 = -(t11 * t34) - t12 * t35;
    let motor_i_rb_dot_by_motor_phase_voltage = (t12 * t34 - t11 * t35 - t17 * t36)
        * t18;
    let motor_i_ra_dot_by_motor_phase_voltage = t36 * t15
        - t17 * motor_i_rb_dot_by_motor_phase_voltage;
    let motor_i_sb_dot_by_motor_phase_voltage = t35 * t10
        - t12 * motor_i_ra_dot_by_motor_phase_voltage
        - t11 * motor_i_rb_dot_by_motor_phase_voltage;
    let motor_i_sa_dot_by_motor_phase_voltage = t34 * t10
        - t11 * motor_i_ra_dot_by_motor_phase_voltage
        + t12 * motor_i_rb_dot_by_motor_phase_voltage;
    let t37 = R::literal(3.0 * core::f64::consts::PI) * time;
    let t38 = t6 / p.motor_supply_frequency;
    let t39 = t38 * motor_omega;
    let t40 = t5 / p.motor_supply_frequency;
    let t41 = t38 * cos_motor_theta;
    let t42 = t38 * sin_motor_theta;
    let t43 = t39 * t20 - t37 * motor_u_b + t40 * motor_i_sa_dot + t41 * motor_i_ra_dot
        - t42 * motor_i_rb_dot;
    let t44 = t39 * t24 + t37 * motor_u_a + t40 * motor_i_sb_dot + t42 * motor_i_ra_dot
        + t41 * motor_i_rb_dot;
    let t45 = t9 / p.motor_supply_frequency;
    let t46 = t39 * t28 + t41 * motor_i_sa_dot + t42 * motor_i_sb_dot
        + t45 * motor_i_ra_dot - t11 * t43 - t12 * t44;
    let motor_i_rb_dot_by_motor_supply_frequency = (-(t4 * motor_M
        / p.motor_supply_frequency * motor_omega
        * (motor_i_sa_times_cos_motor_theta + motor_i_sb_times_sin_motor_theta))
        - t42 * motor_i_sa_dot + t41 * motor_i_sb_dot + t45 * motor_i_rb_dot + t12 * t43
        - t11 * t44 - t17 * t46) * t18;
    let motor_omega_dot_by_motor_supply_frequency = -(t38 * t30 * inverse_motor_inertia);
    let motor_i_ra_dot_by_motor_supply_frequency = t46 * t15
        - t17 * motor_i_rb_dot_by_motor_supply_frequency;
    let motor_i_sb_dot_by_motor_supply_frequency = t44 * t10
        - t12 * motor_i_ra_dot_by_motor_supply_frequency
        - t11 * motor_i_rb_dot_by_motor_supply_frequency;
    let motor_i_sa_dot_by_motor_supply_frequency = t43 * t10
        - t11 * motor_i_ra_dot_by_motor_supply_frequency
        + t12 * motor_i_rb_dot_by_motor_supply_frequency;
    let t47 = t11 * t25 - t12 * t22;
    let motor_i_rb_dot_by_motor_supply_phase = (-(t12 * t25) - t11 * t22 - t17 * t47)
        * t18;
    let motor_i_ra_dot_by_motor_supply_phase = t47 * t15
        - t17 * motor_i_rb_dot_by_motor_supply_phase;
    let motor_i_sb_dot_by_motor_supply_phase = t22 * t10
        - t12 * motor_i_ra_dot_by_motor_supply_phase
        - t11 * motor_i_rb_dot_by_motor_supply_phase;
    let motor_i_sa_dot_by_motor_supply_phase = -(t25 * t10)
        - t11 * motor_i_ra_dot_by_motor_supply_phase
        + t12 * motor_i_rb_dot_by_motor_supply_phase;
    let motor_i_rb_times_motor_theta = motor_i_rb * motor_theta;
    let motor_i_ra_times_motor_theta = motor_i_ra * motor_theta;
    let motor_i_sa_times_motor_theta = motor_i_sa * motor_theta;
    let motor_i_sb_times_motor_theta = motor_i_sb * motor_theta;
    let t48 = t6 * motor_phi;
    let t49 = t48 * sin_motor_theta;
    let t50 = t48 * cos_motor_theta;
    let t51 = t21
        * (motor_i_ra_times_motor_theta * cos_motor_theta + motor_i_ra * sin_motor_theta
            + motor_i_rb * cos_motor_theta
            - motor_i_rb_times_motor_theta * sin_motor_theta) + t49 * motor_i_ra_dot
        + t50 * motor_i_rb_dot;
    let t52 = t21
        * (motor_i_ra_times_motor_theta * sin_motor_theta
            + motor_i_rb_times_motor_theta * cos_motor_theta
            + motor_i_rb * sin_motor_theta - motor_i_ra * cos_motor_theta)
        - t50 * motor_i_ra_dot + t49 * motor_i_rb_dot;
    let t53 = t21
        * (motor_i_sa_times_motor_theta * cos_motor_theta + motor_i_sa * sin_motor_theta
            + motor_i_sb_times_motor_theta * sin_motor_theta
            - motor_i_sb * cos_motor_theta) + t49 * motor_i_sa_dot - t50 * motor_i_sb_dot
        - t11 * t51 - t12 * t52;
    let motor_i_rb_dot_by_motor_pole_pairs = (t50 * motor_i_sa_dot
        - t21
            * (motor_i_sa_times_motor_theta * sin_motor_theta
                - motor_i_sa_times_cos_motor_theta
                - motor_i_sb_times_motor_theta * cos_motor_theta
                - motor_i_sb_times_sin_motor_theta) + t49 * motor_i_sb_dot + t12 * t51
        - t11 * t52 - t17 * t53) * t18;
    let motor_omega_dot_by_motor_pole_pairs = t6
        * (motor_across * cos_motor_theta - motor_theta * motor_along * cos_motor_theta
            - motor_theta * motor_across * sin_motor_theta
            - motor_along * sin_motor_theta) * inverse_motor_inertia;
    let motor_i_ra_dot_by_motor_pole_pairs = t53 * t15
        - t17 * motor_i_rb_dot_by_motor_pole_pairs;
    let motor_i_sb_dot_by_motor_pole_pairs = t52 * t10
        - t12 * motor_i_ra_dot_by_motor_pole_pairs
        - t11 * motor_i_rb_dot_by_motor_pole_pairs;
    let motor_i_sa_dot_by_motor_pole_pairs = t51 * t10
        - t11 * motor_i_ra_dot_by_motor_pole_pairs
        + t12 * motor_i_rb_dot_by_motor_pole_pairs;
    let t54 = t5 * motor_omega;
    let t55 = R::literal(1.5) * p.motor_k_r * p.motor_x_s * p.motor_alpha_s;
    let t56 = t4 * motor_L_s;
    let t57 = t56 * motor_i_sb * motor_omega;
    let t58 = R::literal(1.5) * p.motor_x_s * p.motor_alpha_r / p.motor_k_r;
    let t59 = t56 * motor_i_sa * motor_omega;
    let t60 = R::literal(3.0) * p.motor_k_s * p.motor_x_s * p.motor_alpha_r;
    let t61 = t5 * cos_motor_theta;
    let t62 = t5 * sin_motor_theta;
    let t63 = t55 * motor_i_sa - t54 * t20 - t61 * motor_i_ra_dot + t62 * motor_i_rb_dot;
    let t64 = t55 * motor_i_sb - t54 * t24 - t62 * motor_i_ra_dot - t61 * motor_i_rb_dot;
    let t65 = t5 / p.motor_k_r;
    let t66 = t59 * sin_motor_theta + t60 * motor_i_ra - t57 * cos_motor_theta
        - t58 * motor_i_ra - t61 * motor_i_sa_dot - t62 * motor_i_sb_dot
        - t65 * motor_i_ra_dot - t11 * t63 - t12 * t64;
    let motor_i_rb_dot_by_motor_k_s = (t59 * cos_motor_theta + t57 * sin_motor_theta
        + t60 * motor_i_rb - t58 * motor_i_rb + t62 * motor_i_sa_dot
        - t61 * motor_i_sb_dot - t65 * motor_i_rb_dot + t12 * t63 - t11 * t64
        - t17 * t66) * t18;
    let motor_omega_dot_by_motor_k_s = t5 * t30 * inverse_motor_inertia;
    let motor_i_ra_dot_by_motor_k_s = t66 * t15 - t17 * motor_i_rb_dot_by_motor_k_s;
    let motor_i_sb_dot_by_motor_k_s = t64 * t10 - t12 * motor_i_ra_dot_by_motor_k_s
        - t11 * motor_i_rb_dot_by_motor_k_s;
    let motor_i_sa_dot_by_motor_k_s = t63 * t10 - t11 * motor_i_ra_dot_by_motor_k_s
        + t12 * motor_i_rb_dot_by_motor_k_s;
    let t67 = t32 * p.motor_x_s;
    let t68 = t67 * p.motor_alpha_s;
    let t69 = t68 * motor_i_sa;
    let t70 = t68 * motor_i_sb;
    let t71 = t67 * p.motor_alpha_r / (p.motor_k_r * p.motor_k_r);
    let t72 = t9 / p.motor_k_r;
    let t73 = t71 * motor_i_ra + t72 * motor_i_ra_dot - t11 * t69 - t12 * t70;
    let motor_i_rb_dot_by_motor_k_r = (t71 * motor_i_rb + t72 * motor_i_rb_dot
        + t12 * t69 - t11 * t70 - t17 * t73) * t18;
    let motor_i_ra_dot_by_motor_k_r = t73 * t15 - t17 * motor_i_rb_dot_by_motor_k_r;
    let motor_i_sb_dot_by_motor_k_r = t70 * t10 - t12 * motor_i_ra_dot_by_motor_k_r
        - t11 * motor_i_rb_dot_by_motor_k_r;
    let motor_i_sa_dot_by_motor_k_r = t69 * t10 - t11 * motor_i_ra_dot_by_motor_k_r
        + t12 * motor_i_rb_dot_by_motor_k_r;
    let t74 = R::literal(1.5) * p.motor_alpha_s * motor_sigma;
    let t75 = t32 / motor_omega_0;
    let t76 = t75 * motor_omega;
    let t77 = t32 * p.motor_alpha_r * motor_sigma / p.motor_k_r;
    let t78 = R::literal(1.5) / motor_omega_0;
    let t79 = t75 * cos_motor_theta;
    let t80 = t75 * sin_motor_theta;
    let t81 = -(t74 * motor_i_sa) - t76 * t20 - t78 * motor_i_sa_dot
        - t79 * motor_i_ra_dot + t80 * motor_i_rb_dot;
    let t82 = -(t74 * motor_i_sb) - t76 * t24 - t78 * motor_i_sb_dot
        - t80 * motor_i_ra_dot - t79 * motor_i_rb_dot;
    let t83 = t32 / (p.motor_k_r * motor_omega_0);
    let t84 = -(t77 * motor_i_ra) - t76 * t28 - t79 * motor_i_sa_dot
        - t80 * motor_i_sb_dot - t83 * motor_i_ra_dot - t11 * t81 - t12 * t82;
    let motor_i_rb_dot_by_motor_x_s = (-(t77 * motor_i_rb) - t76 * t29
        + t80 * motor_i_sa_dot - t79 * motor_i_sb_dot - t83 * motor_i_rb_dot + t12 * t81
        - t11 * t82 - t17 * t84) * t18;
    let motor_omega_dot_by_motor_x_s = t75 * t30 * inverse_motor_inertia;
    let motor_i_ra_dot_by_motor_x_s = t84 * t15 - t17 * motor_i_rb_dot_by_motor_x_s;
    let motor_i_sb_dot_by_motor_x_s = t82 * t10 - t12 * motor_i_ra_dot_by_motor_x_s
        - t11 * motor_i_rb_dot_by_motor_x_s;
    let motor_i_sa_dot_by_motor_x_s = t81 * t10 - t11 * motor_i_ra_dot_by_motor_x_s
        + t12 * motor_i_rb_dot_by_motor_x_s;
    let t85 = p.motor_x_s * t33;
    let t86 = t85 * motor_i_sa;
    let t87 = t85 * motor_i_sb;
    let t88 = -(t11 * t86) - t12 * t87;
    let motor_i_rb_dot_by_motor_alpha_s = (t12 * t86 - t11 * t87 - t17 * t88) * t18;
    let motor_i_ra_dot_by_motor_alpha_s = t88 * t15
        - t17 * motor_i_rb_dot_by_motor_alpha_s;
    let motor_i_sb_dot_by_motor_alpha_s = t87 * t10
        - t12 * motor_i_ra_dot_by_motor_alpha_s - t11 * motor_i_rb_dot_by_motor_alpha_s;
    let motor_i_sa_dot_by_motor_alpha_s = t86 * t10
        - t11 * motor_i_ra_dot_by_motor_alpha_s + t12 * motor_i_rb_dot_by_motor_alpha_s;
    let t89 = motor_k_s_times_motor_x_s * t33 / p.motor_k_r;
    let t90 = t89 * motor_i_ra;
    let motor_i_rb_dot_by_motor_alpha_r = (t89 * motor_i_rb - t17 * t90) * t18;
    let motor_i_ra_dot_by_motor_alpha_r = t90 * t15
        - t17 * motor_i_rb_dot_by_motor_alpha_r;
    let motor_i_sb_dot_by_motor_alpha_r = -(t12 * motor_i_ra_dot_by_motor_alpha_r)
        - t11 * motor_i_rb_dot_by_motor_alpha_r;
    let motor_i_sa_dot_by_motor_alpha_r = t12 * motor_i_rb_dot_by_motor_alpha_r
        - t11 * motor_i_ra_dot_by_motor_alpha_r;
    [
        motor_i_sa_dot_by_motor_phase_voltage,
        motor_i_sa_dot_by_motor_supply_frequency,
        motor_i_sa_dot_by_motor_supply_phase,
        motor_i_sa_dot_by_motor_pole_pairs,
        motor_i_sa_dot_by_motor_k_s,
        motor_i_sa_dot_by_motor_k_r,
        motor_i_sa_dot_by_motor_x_s,
        motor_i_sa_dot_by_motor_alpha_s,
        motor_i_sa_dot_by_motor_alpha_r,
        motor_i_sb_dot_by_motor_phase_voltage,
        motor_i_sb_dot_by_motor_supply_frequency,
        motor_i_sb_dot_by_motor_supply_phase,
        motor_i_sb_dot_by_motor_pole_pairs,
        motor_i_sb_dot_by_motor_k_s,
        motor_i_sb_dot_by_motor_k_r,
        motor_i_sb_dot_by_motor_x_s,
        motor_i_sb_dot_by_motor_alpha_s,
        motor_i_sb_dot_by_motor_alpha_r,
        motor_i_ra_dot_by_motor_phase_voltage,
        motor_i_ra_dot_by_motor_supply_frequency,
        motor_i_ra_dot_by_motor_supply_phase,
        motor_i_ra_dot_by_motor_pole_pairs,
        motor_i_ra_dot_by_motor_k_s,
        motor_i_ra_dot_by_motor_k_r,
        motor_i_ra_dot_by_motor_x_s,
        motor_i_ra_dot_by_motor_alpha_s,
        motor_i_ra_dot_by_motor_alpha_r,
        motor_i_rb_dot_by_motor_phase_voltage,
        motor_i_rb_dot_by_motor_supply_frequency,
        motor_i_rb_dot_by_motor_supply_phase,
        motor_i_rb_dot_by_motor_pole_pairs,
        motor_i_rb_dot_by_motor_k_s,
        motor_i_rb_dot_by_motor_k_r,
        motor_i_rb_dot_by_motor_x_s,
        motor_i_rb_dot_by_motor_alpha_s,
        motor_i_rb_dot_by_motor_alpha_r,
        motor_omega_dot_by_motor_inertia,
        motor_omega_dot_by_motor_supply_frequency,
        motor_omega_dot_by_motor_pole_pairs,
        motor_omega_dot_by_motor_k_s,
        motor_omega_dot_by_motor_x_s,
    ]
}

/// Partial derivative of `y'` with respect to time.
///
/// 63 operations.
#[must_use]
pub fn time_derivative<R: Real>(
    time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
) -> [R; STATES] {
    let [motor_phi, ..] = *state;
    let motor_theta = p.motor_pole_pairs * motor_phi;
    let motor_omega_0 = R::literal(core::f64::consts::TAU) * p.motor_supply_frequency;
    let motor_L_s = p.motor_x_s / motor_omega_0;
    let motor_M = p.motor_k_s * motor_L_s;
    let t0 = p.motor_supply_phase + motor_omega_0 * time;
    let t1 = p.motor_phase_voltage * R::literal(core::f64::consts::SQRT_2);
    let motor_u_a = t1 * t0.cos();
    let motor_u_b = t1 * t0.sin();
    let motor_L_r = motor_M / p.motor_k_r;
    let t2 = R::literal(1.5) * motor_M;
    let t3 = t2 * motor_theta.cos();
    let t4 = t2 * motor_theta.sin();
    let t5 = R::literal(1.5) * motor_L_r;
    let t6 = R::literal(1.0) / (R::literal(1.5) * motor_L_s);
    let t7 = t3 * t6;
    let t8 = t4 * t6;
    let t9 = t7 * t3;
    let t10 = t8 * t4;
    let t11 = R::literal(1.0) / (t5 - t9 - t10);
    let t12 = t8 * t3 - t7 * t4;
    let t13 = t12 * t11;
    let t14 = R::literal(1.5) * motor_omega_0;
    let t15 = t14 * motor_u_b;
    let t16 = t14 * motor_u_a;
    let t17 = t7 * t15 - t8 * t16;
    let motor_i_rb_dot_by_time = (-(t8 * t15) - t7 * t16 - t13 * t17)
        * (R::literal(1.0) / (t5 - t10 - t9 - t13 * t12));
    let motor_i_ra_dot_by_time = t17 * t11 - t13 * motor_i_rb_dot_by_time;
    let motor_i_sb_dot_by_time = t16 * t6 - t8 * motor_i_ra_dot_by_time
        - t7 * motor_i_rb_dot_by_time;
    let motor_i_sa_dot_by_time = -(t15 * t6) - t7 * motor_i_ra_dot_by_time
        + t8 * motor_i_rb_dot_by_time;
    [
        R::literal(0.0),
        motor_i_sa_dot_by_time,
        motor_i_sb_dot_by_time,
        motor_i_ra_dot_by_time,
        motor_i_rb_dot_by_time,
        R::literal(0.0),
    ]
}

/// Wanted outputs.
///
/// 25 operations.
#[must_use]
pub fn outputs<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>) -> Outputs<R> {
    let [motor_phi, motor_i_sa, motor_i_sb, motor_i_ra, motor_i_rb, motor_omega] = *state;
    let motor_theta = p.motor_pole_pairs * motor_phi;
    let motor_omega_0 = R::literal(core::f64::consts::TAU) * p.motor_supply_frequency;
    let motor_along = motor_i_sa * motor_i_ra + motor_i_sb * motor_i_rb;
    let motor_across = motor_i_sb * motor_i_ra - motor_i_sa * motor_i_rb;
    let motor_L_s = p.motor_x_s / motor_omega_0;
    let motor_M = p.motor_k_s * motor_L_s;
    let motor_torque = R::literal(1.5) * p.motor_pole_pairs * motor_M
        * (motor_across * motor_theta.cos() - motor_along * motor_theta.sin());
    Outputs {
        speed: motor_omega,
        torque: motor_torque,
        slip: R::literal(1.0) - p.motor_pole_pairs / motor_omega_0 * motor_omega,
        stator_current: (motor_i_sa * motor_i_sa + motor_i_sb * motor_i_sb).sqrt(),
        stator_alpha: motor_i_sa,
        stator_beta: motor_i_sb,
        rotor_first: motor_i_ra,
        rotor_second: motor_i_rb,
        angle: motor_phi,
    }
}

/// T, V and the energy of first-order states \[J\].
///
/// 33 operations.
#[must_use]
pub fn energy<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>) -> Energy<R> {
    let [motor_phi, motor_i_sa, motor_i_sb, motor_i_ra, motor_i_rb, motor_omega] = *state;
    let motor_theta = p.motor_pole_pairs * motor_phi;
    let motor_omega_0 = R::literal(core::f64::consts::TAU) * p.motor_supply_frequency;
    let motor_along = motor_i_sa * motor_i_ra + motor_i_sb * motor_i_rb;
    let motor_across = motor_i_sb * motor_i_ra - motor_i_sa * motor_i_rb;
    let motor_L_s = p.motor_x_s / motor_omega_0;
    let motor_M = p.motor_k_s * motor_L_s;
    let motor_L_r = motor_M / p.motor_k_r;
    Energy {
        kinetic: R::literal(0.5) * p.motor_inertia * (motor_omega * motor_omega)
            + R::literal(0.75)
                * (motor_L_s * (motor_i_sa * motor_i_sa + motor_i_sb * motor_i_sb)
                    + motor_L_r * (motor_i_ra * motor_i_ra + motor_i_rb * motor_i_rb))
            + R::literal(1.5) * motor_M
                * (motor_along * motor_theta.cos() + motor_across * motor_theta.sin()),
        potential: R::literal(0.0),
        stored: R::literal(0.0),
    }
}

/// `dE/dt`, power supplied and power dissipated \[W\].
///
/// 173 operations.
#[must_use]
pub fn power_balance<R: Real>(
    time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
) -> PowerBalance<R> {
    let [motor_phi, motor_i_sa, motor_i_sb, motor_i_ra, motor_i_rb, motor_omega] = *state;
    let motor_theta = p.motor_pole_pairs * motor_phi;
    let motor_omega_0 = R::literal(core::f64::consts::TAU) * p.motor_supply_frequency;
    let motor_sigma = R::literal(1.0) - p.motor_k_s * p.motor_k_r;
    let motor_along = motor_i_sa * motor_i_ra + motor_i_sb * motor_i_rb;
    let motor_across = motor_i_sb * motor_i_ra - motor_i_sa * motor_i_rb;
    let motor_L_s = p.motor_x_s / motor_omega_0;
    let motor_R_s = p.motor_x_s * p.motor_alpha_s * motor_sigma;
    let motor_M = p.motor_k_s * motor_L_s;
    let t0 = p.motor_supply_phase + motor_omega_0 * time;
    let t1 = p.motor_phase_voltage * R::literal(core::f64::consts::SQRT_2);
    let motor_u_a = t1 * t0.cos();
    let motor_u_b = t1 * t0.sin();
    let motor_L_r = motor_M / p.motor_k_r;
    let motor_R_r = p.motor_k_s * p.motor_x_s * p.motor_alpha_r * motor_sigma
        / p.motor_k_r;
    let sin_motor_theta = motor_theta.sin();
    let cos_motor_theta = motor_theta.cos();
    let t2 = R::literal(1.5) * motor_L_s;
    let t3 = R::literal(1.5) * motor_M;
    let t4 = t3 * cos_motor_theta;
    let t5 = t3 * sin_motor_theta;
    let t6 = R::literal(1.5) * motor_L_r;
    let t7 = R::literal(1.0) / t2;
    let t8 = t4 * t7;
    let t9 = t5 * t7;
    let t10 = t8 * t4;
    let t11 = t9 * t5;
    let t12 = R::literal(1.0) / (t6 - t10 - t11);
    let t13 = t9 * t4 - t8 * t5;
    let t14 = t13 * t12;
    let t15 = R::literal(1.5) * motor_R_s;
    let motor_pole_pairs_times_motor_i_ra = p.motor_pole_pairs * motor_i_ra;
    let motor_pole_pairs_times_motor_i_rb = p.motor_pole_pairs * motor_i_rb;
    let t16 = t3 * motor_omega;
    let t17 = R::literal(1.5) * motor_u_a - t15 * motor_i_sa
        - t16
            * (-(motor_pole_pairs_times_motor_i_ra * sin_motor_theta)
                - motor_pole_pairs_times_motor_i_rb * cos_motor_theta);
    let t18 = R::literal(1.5) * motor_u_b - t15 * motor_i_sb
        - t16
            * (motor_pole_pairs_times_motor_i_ra * cos_motor_theta
                - motor_pole_pairs_times_motor_i_rb * sin_motor_theta);
    let t19 = R::literal(1.5) * motor_R_r;
    let motor_pole_pairs_times_motor_i_sa = p.motor_pole_pairs * motor_i_sa;
    let motor_pole_pairs_times_motor_i_sb = p.motor_pole_pairs * motor_i_sb;
    let t20 = t3
        * (p.motor_pole_pairs * motor_across * cos_motor_theta
            - p.motor_pole_pairs * motor_along * sin_motor_theta);
    let t21 = -(t19 * motor_i_ra)
        - t16
            * (motor_pole_pairs_times_motor_i_sb * cos_motor_theta
                - motor_pole_pairs_times_motor_i_sa * sin_motor_theta) - t8 * t17
        - t9 * t18;
    let motor_i_rb_dot = (-(t19 * motor_i_rb)
        - t16
            * (-(motor_pole_pairs_times_motor_i_sa * cos_motor_theta)
                - motor_pole_pairs_times_motor_i_sb * sin_motor_theta) + t9 * t17
        - t8 * t18 - t14 * t21) * (R::literal(1.0) / (t6 - t11 - t10 - t14 * t13));
    let motor_omega_dot = t20 * (R::literal(1.0) / p.motor_inertia);
    let motor_i_ra_dot = t21 * t12 - t14 * motor_i_rb_dot;
    let motor_i_sb_dot = t18 * t7 - t9 * motor_i_ra_dot - t8 * motor_i_rb_dot;
    let motor_i_sa_dot = t17 * t7 - t8 * motor_i_ra_dot + t9 * motor_i_rb_dot;
    let t22 = t20 * motor_omega
        + (t2 * motor_i_sa
            + t3 * (motor_i_ra * cos_motor_theta - motor_i_rb * sin_motor_theta))
            * motor_i_sa_dot
        + (t2 * motor_i_sb
            + t3 * (motor_i_ra * sin_motor_theta + motor_i_rb * cos_motor_theta))
            * motor_i_sb_dot;
    PowerBalance {
        stored_rate: t22
            + (t6 * motor_i_ra
                + t3 * (motor_i_sa * cos_motor_theta + motor_i_sb * sin_motor_theta))
                * motor_i_ra_dot
            + (t6 * motor_i_rb
                + t3 * (motor_i_sb * cos_motor_theta - motor_i_sa * sin_motor_theta))
                * motor_i_rb_dot + p.motor_inertia * motor_omega * motor_omega_dot,
        supplied: R::literal(1.5) * motor_i_sa * motor_u_a
            + R::literal(1.5) * motor_i_sb * motor_u_b,
        dissipated: t15 * (motor_i_sa * motor_i_sa) + t15 * (motor_i_sb * motor_i_sb)
            + t19 * (motor_i_ra * motor_i_ra) + t19 * (motor_i_rb * motor_i_rb),
    }
}

/// Normalized Taylor coefficients of the solution through `state`, order after order.
///
/// `_k` marks the coefficient of order k, `_before` that of order k - 1; bare names are
/// zeroth coefficients. The workspace is as `series_workspace` says.
///
/// 120 recurrences. 28 sums of products an order.
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
    let (mut lanes_2, workspace) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let (mut lanes_3, workspace) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let (mut lanes_4, workspace) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let (mut lanes_5, workspace) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let (mut lanes_6, _) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let [motor_phi, motor_i_sa, motor_i_sb, motor_i_ra, motor_i_rb, motor_omega] = *state;
    let motor_theta = motor_phi * p.motor_pole_pairs;
    let motor_omega_0 = R::literal(core::f64::consts::TAU) * p.motor_supply_frequency;
    let motor_L_s = p.motor_x_s / motor_omega_0;
    let motor_M = p.motor_k_s * motor_L_s;
    let motor_L_r = motor_M / p.motor_k_r;
    let sin_motor_theta = motor_theta.sin();
    let cos_motor_theta = motor_theta.cos();
    let t0 = R::literal(1.5) * motor_L_s;
    let t1 = R::literal(1.5) * motor_M;
    let t2 = cos_motor_theta * t1;
    let t3 = sin_motor_theta * t1;
    let t4 = -t3;
    let t5 = R::literal(1.5) * motor_L_r;
    let t6 = p.motor_k_s * p.motor_k_r;
    let motor_sigma = R::literal(1.0) - t6;
    let t7 = motor_i_sa * motor_i_ra;
    let t8 = motor_i_sb * motor_i_rb;
    let motor_along = t7 + t8;
    let t9 = motor_i_sa * motor_i_rb;
    let t10 = motor_i_sb * motor_i_ra;
    let motor_across = t10 - t9;
    let t11 = p.motor_x_s * p.motor_alpha_s;
    let motor_R_s = t11 * motor_sigma;
    let t12 = time * motor_omega_0;
    let t13 = p.motor_supply_phase + t12;
    let t14 = t13.sin();
    let t15 = t13.cos();
    let t16 = p.motor_phase_voltage * R::literal(core::f64::consts::SQRT_2);
    let t17 = p.motor_k_s * p.motor_x_s;
    let t18 = t17 * p.motor_alpha_r;
    let t19 = t18 * motor_sigma;
    let motor_R_r = t19 / p.motor_k_r;
    let t20 = R::literal(1.5) * motor_R_s;
    let t21 = motor_i_sa * t20;
    let t22 = motor_i_ra * p.motor_pole_pairs;
    let t23 = t22 * sin_motor_theta;
    let t24 = motor_i_rb * p.motor_pole_pairs;
    let t25 = t24 * cos_motor_theta;
    let t26 = -t23;
    let t27 = t26 - t25;
    let t28 = motor_omega * t1;
    let t29 = t28 * t27;
    let t30 = t16 * R::literal(1.5);
    let t31 = t15 * t30;
    let t32 = t31 - t21;
    let t33 = t32 - t29;
    let t34 = motor_i_sb * t20;
    let t35 = t24 * sin_motor_theta;
    let t36 = t22 * cos_motor_theta;
    let t37 = t36 - t35;
    let t38 = t28 * t37;
    let t39 = t14 * t30;
    let t40 = t39 - t34;
    let t41 = t40 - t38;
    let t42 = R::literal(1.5) * motor_R_r;
    let t43 = motor_i_ra * t42;
    let t44 = motor_i_sa * p.motor_pole_pairs;
    let t45 = t44 * sin_motor_theta;
    let t46 = motor_i_sb * p.motor_pole_pairs;
    let t47 = t46 * cos_motor_theta;
    let t48 = t47 - t45;
    let t49 = t28 * t48;
    let t50 = -t43;
    let t51 = t50 - t49;
    let t52 = motor_i_rb * t42;
    let t53 = t44 * cos_motor_theta;
    let t54 = t46 * sin_motor_theta;
    let t55 = -t53;
    let t56 = t55 - t54;
    let t57 = t28 * t56;
    let t58 = -t52;
    let t59 = t58 - t57;
    let t60 = motor_along * p.motor_pole_pairs;
    let t61 = t60 * sin_motor_theta;
    let t62 = motor_across * p.motor_pole_pairs;
    let t63 = t62 * cos_motor_theta;
    let t64 = t63 - t61;
    let t65 = t64 * t1;
    let factored = Factored::new([
        [t0, R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0)],
        [R::literal(0.0), t0, R::literal(0.0), R::literal(0.0), R::literal(0.0)],
        [t2, t3, t5, R::literal(0.0), R::literal(0.0)],
        [t4, t2, R::literal(0.0), t5, R::literal(0.0)],
        [
            R::literal(0.0),
            R::literal(0.0),
            R::literal(0.0),
            R::literal(0.0),
            p.motor_inertia,
        ],
    ]);
    let [motor_i_sa_dot, motor_i_sb_dot, motor_i_ra_dot, motor_i_rb_dot, motor_omega_dot,
    ] = factored.solve([t33, t41, t51, t59, t65]);
    let mut t14_before = t14;
    let mut t15_before = t15;
    let mut rates = [
        motor_omega,
        motor_i_sa_dot,
        motor_i_sb_dot,
        motor_i_ra_dot,
        motor_i_rb_dot,
        motor_omega_dot,
    ];
    coefficients[0] = *state;
    let highest = coefficients.len() - 1;
    for (order, state_k) in coefficients.iter_mut().enumerate().skip(1) {
        let (k, inverse) = order_and_inverse::<R>(order);
        *state_k = rates.map(|rate| rate * inverse);
        if order == highest {
            break;
        }
        let [motor_phi_k, motor_i_sa_k, motor_i_sb_k, motor_i_ra_k, motor_i_rb_k,
        motor_omega_k] = *state_k;
        let sums = lanes.sums(order);
        let sums_1 = lanes_1.sums(order);
        let sums_2 = lanes_2.sums(order);
        let sums_3 = lanes_3.sums(order);
        let sums_4 = lanes_4.sums(order);
        let sums_5 = lanes_5.sums(order);
        let sums_6 = lanes_6.sums(order);
        let motor_theta_k = motor_phi_k * p.motor_pole_pairs;
        let sin_motor_theta_k = motor_theta_k
            .mul_add(cos_motor_theta, inverse * sums_1[0]);
        let cos_motor_theta_k = -motor_theta_k
            .mul_add(sin_motor_theta, inverse * sums_1[1]);
        let t2_k = cos_motor_theta_k * t1;
        let t3_k = sin_motor_theta_k * t1;
        let t4_k = -t3_k;
        let t7_k = motor_i_sa
            .mul_add(motor_i_ra_k, motor_i_ra.mul_add(motor_i_sa_k, sums[0]));
        let t8_k = motor_i_sb
            .mul_add(motor_i_rb_k, motor_i_rb.mul_add(motor_i_sb_k, sums[1]));
        let motor_along_k = t7_k + t8_k;
        let t9_k = motor_i_sa
            .mul_add(motor_i_rb_k, motor_i_rb.mul_add(motor_i_sa_k, sums[2]));
        let t10_k = motor_i_sb
            .mul_add(motor_i_ra_k, motor_i_ra.mul_add(motor_i_sb_k, sums[3]));
        let motor_across_k = t10_k - t9_k;
        let t14_k = inverse * motor_omega_0 * t15_before;
        let t15_k = -inverse * motor_omega_0 * t14_before;
        let t22_k = motor_i_ra_k * p.motor_pole_pairs;
        let t23_k = t22
            .mul_add(sin_motor_theta_k, sin_motor_theta.mul_add(t22_k, sums_1[2]));
        let t24_k = motor_i_rb_k * p.motor_pole_pairs;
        let t25_k = t24
            .mul_add(cos_motor_theta_k, cos_motor_theta.mul_add(t24_k, sums_1[3]));
        let t26_k = -t23_k;
        let t27_k = t26_k - t25_k;
        let t28_k = motor_omega_k * t1;
        let t29_k = t28.mul_add(t27_k, t27.mul_add(t28_k, sums_4[2]));
        let t32_k = (-motor_i_sa_k).mul_add(t20, t15_k * t30);
        let t33_k = t32_k - t29_k;
        let t35_k = t24
            .mul_add(sin_motor_theta_k, sin_motor_theta.mul_add(t24_k, sums_2[0]));
        let t36_k = t22
            .mul_add(cos_motor_theta_k, cos_motor_theta.mul_add(t22_k, sums_2[1]));
        let t37_k = t36_k - t35_k;
        let t38_k = t28.mul_add(t37_k, t37.mul_add(t28_k, sums_4[0]));
        let t40_k = (-motor_i_sb_k).mul_add(t20, t14_k * t30);
        let t41_k = t40_k - t38_k;
        let t43_k = motor_i_ra_k * t42;
        let t44_k = motor_i_sa_k * p.motor_pole_pairs;
        let t45_k = t44
            .mul_add(sin_motor_theta_k, sin_motor_theta.mul_add(t44_k, sums_2[2]));
        let t46_k = motor_i_sb_k * p.motor_pole_pairs;
        let t47_k = t46
            .mul_add(cos_motor_theta_k, cos_motor_theta.mul_add(t46_k, sums_2[3]));
        let t48_k = t47_k - t45_k;
        let t49_k = t28.mul_add(t48_k, t48.mul_add(t28_k, sums_4[1]));
        let t50_k = -t43_k;
        let t51_k = t50_k - t49_k;
        let t52_k = motor_i_rb_k * t42;
        let t53_k = t44
            .mul_add(cos_motor_theta_k, cos_motor_theta.mul_add(t44_k, sums_3[0]));
        let t54_k = t46
            .mul_add(sin_motor_theta_k, sin_motor_theta.mul_add(t46_k, sums_3[1]));
        let t55_k = -t53_k;
        let t56_k = t55_k - t54_k;
        let t57_k = t28.mul_add(t56_k, t56.mul_add(t28_k, sums_4[3]));
        let t58_k = -t52_k;
        let t59_k = t58_k - t57_k;
        let t60_k = motor_along_k * p.motor_pole_pairs;
        let t61_k = sin_motor_theta
            .mul_add(t60_k, t60.mul_add(sin_motor_theta_k, sums_3[2]));
        let t62_k = motor_across_k * p.motor_pole_pairs;
        let t63_k = cos_motor_theta
            .mul_add(t62_k, t62.mul_add(cos_motor_theta_k, sums_3[3]));
        let t64_k = t63_k - t61_k;
        let t65_k = t64_k * t1;
        let n104_k = t2_k.mul_add(motor_i_ra_dot, sums_5[0]);
        let n105_k = t4_k.mul_add(motor_i_rb_dot, sums_5[1]);
        let n106_k = t3_k.mul_add(motor_i_ra_dot, sums_5[2]);
        let n107_k = t2_k.mul_add(motor_i_rb_dot, sums_5[3]);
        let n108_k = t2_k.mul_add(motor_i_sa_dot, sums_6[0]);
        let n109_k = t3_k.mul_add(motor_i_sb_dot, sums_6[1]);
        let n110_k = t4_k.mul_add(motor_i_sa_dot, sums_6[2]);
        let n111_k = t2_k.mul_add(motor_i_sb_dot, sums_6[3]);
        let n112_k = n104_k + n105_k;
        let t33_k_2 = t33_k - n112_k;
        let n114_k = n106_k + n107_k;
        let t41_k_2 = t41_k - n114_k;
        let n116_k = n108_k + n109_k;
        let t51_k_2 = t51_k - n116_k;
        let n118_k = n110_k + n111_k;
        let t59_k_2 = t59_k - n118_k;
        let [motor_i_sa_dot_k, motor_i_sb_dot_k, motor_i_ra_dot_k, motor_i_rb_dot_k,
        motor_omega_dot_k] = factored.solve([t33_k_2, t41_k_2, t51_k_2, t59_k_2, t65_k]);
        lanes
            .set(
                order,
                [motor_i_sa_k, motor_i_sb_k, motor_i_sa_k, motor_i_ra_k],
                [motor_i_ra_k, motor_i_rb_k, motor_i_rb_k, motor_i_sb_k],
            );
        lanes_1
            .set(
                order,
                [
                    k * motor_theta_k,
                    k * motor_theta_k,
                    sin_motor_theta_k,
                    cos_motor_theta_k,
                ],
                [cos_motor_theta_k, sin_motor_theta_k, t22_k, t24_k],
            );
        lanes_2
            .set(
                order,
                [
                    sin_motor_theta_k,
                    cos_motor_theta_k,
                    sin_motor_theta_k,
                    cos_motor_theta_k,
                ],
                [t24_k, t22_k, t44_k, t46_k],
            );
        lanes_3
            .set(
                order,
                [
                    cos_motor_theta_k,
                    sin_motor_theta_k,
                    sin_motor_theta_k,
                    cos_motor_theta_k,
                ],
                [t44_k, t46_k, t60_k, t62_k],
            );
        lanes_4.set(order, [t28_k, t28_k, t27_k, t28_k], [t37_k, t48_k, t28_k, t56_k]);
        lanes_5
            .set(
                order,
                [t2_k, t4_k, t3_k, t2_k],
                [motor_i_ra_dot_k, motor_i_rb_dot_k, motor_i_ra_dot_k, motor_i_rb_dot_k],
            );
        lanes_6
            .set(
                order,
                [t2_k, t3_k, t4_k, t2_k],
                [motor_i_sa_dot_k, motor_i_sb_dot_k, motor_i_sa_dot_k, motor_i_sb_dot_k],
            );
        t14_before = t14_k;
        t15_before = t15_k;
        rates = [
            motor_omega_k,
            motor_i_sa_dot_k,
            motor_i_sb_dot_k,
            motor_i_ra_dot_k,
            motor_i_rb_dot_k,
            motor_omega_dot_k,
        ];
    }
}

impl<R: Real> TaylorSeries<R> for MotorStationaryAxes {
    fn series_workspace(&self, order: usize) -> usize {
        Lanes::<R, 4>::workspace(order + 1) + Lanes::<R, 4>::workspace(order + 1)
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
}

impl Describe for MotorStationaryAxes {
    fn name(&self) -> &'static str {
        "motor_stationary_axes"
    }
    fn title(&self) -> &'static str {
        "Induction motor running up empty, from its co-energy"
    }
    fn shape(&self) -> Shape {
        Shape {
            coordinates: COORDINATES,
            positions: 1,
            first_order: 0,
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

impl<R: Real> Simulator<R> for MotorStationaryAxes {
    fn constants(&self) -> usize {
        CONSTANTS
    }
    fn prepare(&self, parameters: &[R], constants: &mut [R]) {
        constants.copy_from_slice(&prepare(&parameters_of(parameters)).to_array());
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
        values.copy_from_slice(&prepared_rate(time, state_of(state), &p, &c));
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
        values.copy_from_slice(&prepared_rate_jacobian(time, state_of(state), &p, &c));
    }
    fn initial_state(&self, parameters: &[R], values: &mut [R]) {
        values.copy_from_slice(&initial_state(&parameters_of(parameters)));
    }
    fn discontinuities(&self, parameters: &[R], values: &mut [R]) {
        values.copy_from_slice(&discontinuities(&parameters_of(parameters)));
    }
    fn rate(&self, time: R, state: &[R], parameters: &[R], values: &mut [R]) {
        let result = rate(time, state_of(state), &parameters_of(parameters));
        values.copy_from_slice(&result);
    }
    fn rate_jacobian(&self, time: R, state: &[R], parameters: &[R], values: &mut [R]) {
        let result = rate_jacobian(time, state_of(state), &parameters_of(parameters));
        values.copy_from_slice(&result);
    }
    fn parameter_jacobian(
        &self,
        time: R,
        state: &[R],
        parameters: &[R],
        values: &mut [R],
    ) {
        let result = parameter_jacobian(
            time,
            state_of(state),
            &parameters_of(parameters),
        );
        values.copy_from_slice(&result);
    }
    fn time_derivative(&self, time: R, state: &[R], parameters: &[R], values: &mut [R]) {
        let result = time_derivative(time, state_of(state), &parameters_of(parameters));
        values.copy_from_slice(&result);
    }
    fn mass_matrix(&self, time: R, state: &[R], parameters: &[R], values: &mut [R]) {
        let result = mass_matrix(time, state_of(state), &parameters_of(parameters));
        values.copy_from_slice(&result);
    }
    fn forcing(&self, time: R, state: &[R], parameters: &[R], values: &mut [R]) {
        let result = forcing(time, state_of(state), &parameters_of(parameters));
        values.copy_from_slice(&result);
    }
    fn outputs(&self, time: R, state: &[R], parameters: &[R], values: &mut [R]) {
        let result = outputs(time, state_of(state), &parameters_of(parameters));
        values.copy_from_slice(&result.to_array());
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
    StateKind::Velocity,
    StateKind::Velocity,
    StateKind::Velocity,
];

static COORDINATE_QUANTITIES: [Quantity<'static>; COORDINATES] = [
    Quantity {
        name: "motor.q_sa",
        unit: "C",
        doc: "charge passed by the stator winding along alpha",
    },
    Quantity {
        name: "motor.q_sb",
        unit: "C",
        doc: "charge passed by the stator winding along beta",
    },
    Quantity {
        name: "motor.q_ra",
        unit: "C",
        doc: "charge passed by the rotor's first winding",
    },
    Quantity {
        name: "motor.q_rb",
        unit: "C",
        doc: "charge passed by the rotor's second winding",
    },
    Quantity {
        name: "motor.phi",
        unit: "rad",
        doc: "rotor angle",
    },
];

static STATE_QUANTITIES: [Quantity<'static>; STATES] = [
    Quantity {
        name: "motor.phi",
        unit: "rad",
        doc: "rotor angle",
    },
    Quantity {
        name: "motor.i_sa",
        unit: "C/s",
        doc: "rate of charge passed by the stator winding along alpha",
    },
    Quantity {
        name: "motor.i_sb",
        unit: "C/s",
        doc: "rate of charge passed by the stator winding along beta",
    },
    Quantity {
        name: "motor.i_ra",
        unit: "C/s",
        doc: "rate of charge passed by the rotor's first winding",
    },
    Quantity {
        name: "motor.i_rb",
        unit: "C/s",
        doc: "rate of charge passed by the rotor's second winding",
    },
    Quantity {
        name: "motor.omega",
        unit: "rad/s",
        doc: "rate of rotor angle",
    },
];

static STATE_SCALES: [f64; STATES] = [150.0, 800.0, 800.0, 800.0, 800.0, 78.5];

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
        doc: "stator decay R_s/(sigma x_s)",
    },
    Quantity {
        name: "motor.alpha_r",
        unit: "1",
        doc: "rotor decay R_r/(sigma x_r)",
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
    Quantity {
        name: "stator_alpha",
        unit: "C/s",
        doc: "rate of charge passed by the stator winding along alpha",
    },
    Quantity {
        name: "stator_beta",
        unit: "C/s",
        doc: "rate of charge passed by the stator winding along beta",
    },
    Quantity {
        name: "rotor_first",
        unit: "C/s",
        doc: "rate of charge passed by the rotor's first winding",
    },
    Quantity {
        name: "rotor_second",
        unit: "C/s",
        doc: "rate of charge passed by the rotor's second winding",
    },
    Quantity {
        name: "angle",
        unit: "rad",
        doc: "rotor angle",
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

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
//   rate                    128
//   mass_matrix              13
//   forcing                  81
//   rate_jacobian           335
//   parameter_jacobian      578
//   time_derivative          63
//   outputs                  25
//   energy                   33
//   power_balance           185
// With constants of the parameters, prepared once a run:
//   prepare                  41
//   prepared_rate           104
//   prepared_rate_jacobian  294

use ::machinist_contract::{
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
        (0, 0), (0, 2), (0, 3), (1, 1), (1, 2), (1, 3), (2, 0), (2, 1), (2, 2), (3, 0), (3, 1),
        (3, 3), (4, 4),
    ],
};

/// Nonzeros of dy'/dy.
pub const RATE_JACOBIAN_PATTERN: SparsityPattern<'static> = SparsityPattern {
    rows: 6,
    columns: 6,
    entries: &[
        (0, 5), (1, 0), (1, 1), (1, 2), (1, 3), (1, 4), (1, 5), (2, 0), (2, 1), (2, 2), (2, 3),
        (2, 4), (2, 5), (3, 0), (3, 1), (3, 2), (3, 3), (3, 4), (3, 5), (4, 0), (4, 1), (4, 2),
        (4, 3), (4, 4), (4, 5), (5, 0), (5, 1), (5, 2), (5, 3), (5, 4),
    ],
};

/// Nonzeros of dy'/dp.
pub const PARAMETER_JACOBIAN_PATTERN: SparsityPattern<'static> = SparsityPattern {
    rows: 6,
    columns: 11,
    entries: &[
        (1, 2), (1, 3), (1, 4), (1, 5), (1, 6), (1, 7), (1, 8), (1, 9), (1, 10), (2, 2), (2, 3),
        (2, 4), (2, 5), (2, 6), (2, 7), (2, 8), (2, 9), (2, 10), (3, 2), (3, 3), (3, 4), (3, 5),
        (3, 6), (3, 7), (3, 8), (3, 9), (3, 10), (4, 2), (4, 3), (4, 4), (4, 5), (4, 6), (4, 7),
        (4, 8), (4, 9), (4, 10), (5, 1), (5, 3), (5, 5), (5, 6), (5, 8),
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
pub const CONSTANTS: usize = 19;

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
    pub t5: R,
    pub t6: R,
    pub t7: R,
    pub t8: R,
    pub t9: R,
    pub motor_pole_pairs_squared: R,
    pub t10: R,
    pub t11: R,
    pub t13: R,
    pub t14: R,
    pub t15: R,
    pub t16: R,
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
            t5: values[7],
            t6: values[8],
            t7: values[9],
            t8: values[10],
            t9: values[11],
            motor_pole_pairs_squared: values[12],
            t10: values[13],
            t11: values[14],
            t13: values[15],
            t14: values[16],
            t15: values[17],
            t16: values[18],
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
            self.t5,
            self.t6,
            self.t7,
            self.t8,
            self.t9,
            self.motor_pole_pairs_squared,
            self.t10,
            self.t11,
            self.t13,
            self.t14,
            self.t15,
            self.t16,
        ]
    }
}

/// What `rate` and `rate_jacobian` need of the parameters, once a run.
///
/// 41 operations.
#[must_use]
#[inline]
pub fn prepare<R: Real>(p: &Parameters<R>) -> Constants<R> {
    let motor_omega_0 = R::literal(core::f64::consts::TAU) * p.motor_supply_frequency;
    let motor_sigma = R::literal(1.0).sub_product(p.motor_k_s, p.motor_k_r);
    let motor_L_s = p.motor_x_s / motor_omega_0;
    let motor_x_s_times_motor_alpha_s = p.motor_x_s * p.motor_alpha_s;
    let motor_R_s = motor_x_s_times_motor_alpha_s * motor_sigma;
    let motor_M = p.motor_k_s * motor_L_s;
    let t0 = p.motor_phase_voltage * R::literal(core::f64::consts::SQRT_2);
    let motor_L_r = motor_M / p.motor_k_r;
    let t1 = R::literal(1.5) * motor_M;
    let t2 = R::literal(1.5) * motor_L_r;
    let t3 = R::literal(1.0) / (R::literal(1.5) * motor_L_s);
    let inverse_motor_inertia = R::literal(1.0) / p.motor_inertia;
    let t4 = R::literal(1.5) * motor_R_s;
    let t5 = R::literal(0.75) * p.motor_pole_pairs * p.motor_k_r;
    let t6 = R::literal(0.75) * p.motor_alpha_r * motor_omega_0;
    let t7 = R::literal(0.75) * p.motor_k_s * p.motor_k_r * p.motor_alpha_r
        * motor_omega_0;
    let t8 = R::literal(2.0) * motor_L_r;
    let t9 = R::literal(1.5) * p.motor_pole_pairs * motor_M;
    let motor_pole_pairs_squared = p.motor_pole_pairs * p.motor_pole_pairs;
    let t10 = t1 * motor_pole_pairs_squared;
    let t11 = R::literal(2.0) * motor_M * motor_pole_pairs_squared;
    let t12 = R::literal(-1.5).add_product(R::literal(1.5) * p.motor_k_s, p.motor_k_r);
    let t13 = motor_x_s_times_motor_alpha_s * t12;
    let t14 = t13 * t3;
    let t15 = p.motor_k_s * p.motor_x_s * p.motor_alpha_r * t12 / p.motor_k_r;
    let t16 = R::literal(2.0) * p.motor_pole_pairs * motor_M;
    Constants {
        motor_omega_0,
        t0,
        t1,
        t2,
        t3,
        inverse_motor_inertia,
        t4,
        t5,
        t6,
        t7,
        t8,
        t9,
        motor_pole_pairs_squared,
        t10,
        t11,
        t13,
        t14,
        t15,
        t16,
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
/// 128 operations.
#[must_use]
#[inline]
pub fn rate<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>) -> [R; STATES] {
    prepared_rate(time, state, p, &prepare(p))
}

/// As `rate`, with the constants of the parameters from `prepare`.
///
/// 104 operations.
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
    let t0 = p.motor_supply_phase.add_product(c.motor_omega_0, time);
    let [(t1, t2), (sin_motor_theta, cos_motor_theta)] = R::sin_cos_each([
        t0,
        motor_theta,
    ]);
    let motor_along = (motor_i_sa * motor_i_ra).add_product(motor_i_sb, motor_i_rb);
    let motor_across = (motor_i_sb * motor_i_ra).sub_product(motor_i_sa, motor_i_rb);
    let motor_u_a = c.t0 * t2;
    let motor_u_b = c.t0 * t1;
    let t3 = c.t1 * cos_motor_theta;
    let t4 = c.t1 * sin_motor_theta;
    let t5 = t3 * c.t3;
    let t6 = t4 * c.t3;
    let t7 = t5 * t3;
    let t8 = t6 * t4;
    let t9 = R::literal(1.0) / (c.t2 - t7 - t8);
    let t10 = (t6 * t3).sub_product(t5, t4);
    let t11 = t10 * t9;
    let motor_pole_pairs_times_motor_i_ra = p.motor_pole_pairs * motor_i_ra;
    let motor_pole_pairs_times_motor_i_rb = p.motor_pole_pairs * motor_i_rb;
    let t12 = c.t1 * motor_omega;
    let t13 = (-(c.t4 * motor_i_sa))
        .add_product(R::literal(1.5), motor_u_a)
        .sub_product(
            t12,
            (-(motor_pole_pairs_times_motor_i_rb * cos_motor_theta))
                .sub_product(motor_pole_pairs_times_motor_i_ra, sin_motor_theta),
        );
    let t14 = (-(c.t4 * motor_i_sb))
        .add_product(R::literal(1.5), motor_u_b)
        .sub_product(
            t12,
            (motor_pole_pairs_times_motor_i_ra * cos_motor_theta)
                .sub_product(motor_pole_pairs_times_motor_i_rb, sin_motor_theta),
        );
    let t15 = c.t5 * motor_i_sb * motor_omega;
    let t16 = c.t5 * motor_i_sa * motor_omega;
    let t17 = (c.t8
        * (c.t7 * motor_i_ra)
            .add_product(t16, sin_motor_theta)
            .sub_product(t15, cos_motor_theta)
            .sub_product(c.t6, motor_i_ra))
        .sub_product(t5, t13)
        .sub_product(t6, t14);
    let motor_omega_dot = c.t1
        * (p.motor_pole_pairs * motor_across * cos_motor_theta)
            .sub_product(p.motor_pole_pairs * motor_along, sin_motor_theta)
        * c.inverse_motor_inertia;
    let motor_i_rb_dot = (c.t8
        * (t16 * cos_motor_theta)
            .add_product(t15, sin_motor_theta)
            .add_product(c.t7, motor_i_rb)
            .sub_product(c.t6, motor_i_rb))
        .add_product(t6, t13)
        .sub_product(t5, t14)
        .sub_product(t11, t17)
        * (R::literal(1.0) / (c.t2 - t8 - t7).sub_product(t11, t10));
    let motor_i_ra_dot = (t17 * t9).sub_product(t11, motor_i_rb_dot);
    let motor_i_sb_dot = (t14 * c.t3)
        .sub_product(t6, motor_i_ra_dot)
        .sub_product(t5, motor_i_rb_dot);
    let motor_i_sa_dot = (t13 * c.t3)
        .sub_product(t5, motor_i_ra_dot)
        .add_product(t6, motor_i_rb_dot);
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
    let (sin_motor_theta, cos_motor_theta) = motor_theta.sin_cos();
    let motor_omega_0 = R::literal(core::f64::consts::TAU) * p.motor_supply_frequency;
    let motor_L_s = p.motor_x_s / motor_omega_0;
    let motor_M = p.motor_k_s * motor_L_s;
    let motor_L_r = motor_M / p.motor_k_r;
    let t0 = R::literal(1.5) * motor_L_s;
    let t1 = R::literal(1.5) * motor_M;
    let t2 = t1 * cos_motor_theta;
    let t3 = t1 * sin_motor_theta;
    let t4 = -t3;
    let t5 = R::literal(1.5) * motor_L_r;
    [t0, t2, t4, t0, t3, t2, t2, t3, t5, t4, t2, t5, p.motor_inertia]
}

/// `f` of `M q'' = f(q, q', z, t)`, one for each coordinate.
///
/// 81 operations.
#[must_use]
pub fn forcing<R: Real>(
    time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
) -> [R; COORDINATES] {
    let [motor_phi, motor_i_sa, motor_i_sb, motor_i_ra, motor_i_rb, motor_omega] = *state;
    let motor_theta = p.motor_pole_pairs * motor_phi;
    let motor_omega_0 = R::literal(core::f64::consts::TAU) * p.motor_supply_frequency;
    let t0 = p.motor_supply_phase.add_product(motor_omega_0, time);
    let [(t1, t2), (sin_motor_theta, cos_motor_theta)] = R::sin_cos_each([
        t0,
        motor_theta,
    ]);
    let motor_sigma = R::literal(1.0).sub_product(p.motor_k_s, p.motor_k_r);
    let motor_along = (motor_i_sa * motor_i_ra).add_product(motor_i_sb, motor_i_rb);
    let motor_across = (motor_i_sb * motor_i_ra).sub_product(motor_i_sa, motor_i_rb);
    let motor_L_s = p.motor_x_s / motor_omega_0;
    let motor_R_s = p.motor_x_s * p.motor_alpha_s * motor_sigma;
    let motor_M = p.motor_k_s * motor_L_s;
    let t3 = p.motor_phase_voltage * R::literal(core::f64::consts::SQRT_2);
    let motor_u_a = t3 * t2;
    let motor_u_b = t3 * t1;
    let motor_L_r = motor_M / p.motor_k_r;
    let t4 = R::literal(1.5) * motor_M;
    let t5 = R::literal(1.5) * motor_R_s;
    let motor_pole_pairs_times_motor_i_ra = p.motor_pole_pairs * motor_i_ra;
    let motor_pole_pairs_times_motor_i_rb = p.motor_pole_pairs * motor_i_rb;
    let t6 = t4 * motor_omega;
    let motor_q_sa_forcing = (-(t5 * motor_i_sa))
        .add_product(R::literal(1.5), motor_u_a)
        .sub_product(
            t6,
            (-(motor_pole_pairs_times_motor_i_rb * cos_motor_theta))
                .sub_product(motor_pole_pairs_times_motor_i_ra, sin_motor_theta),
        );
    let motor_q_sb_forcing = (-(t5 * motor_i_sb))
        .add_product(R::literal(1.5), motor_u_b)
        .sub_product(
            t6,
            (motor_pole_pairs_times_motor_i_ra * cos_motor_theta)
                .sub_product(motor_pole_pairs_times_motor_i_rb, sin_motor_theta),
        );
    let t7 = R::literal(0.75) * p.motor_pole_pairs * p.motor_k_r;
    let t8 = t7 * motor_i_sb * motor_omega;
    let t9 = R::literal(0.75) * p.motor_alpha_r * motor_omega_0;
    let t10 = t7 * motor_i_sa * motor_omega;
    let t11 = R::literal(0.75) * p.motor_k_s * p.motor_k_r * p.motor_alpha_r
        * motor_omega_0;
    let t12 = R::literal(2.0) * motor_L_r;
    let motor_q_ra_forcing = t12
        * (t11 * motor_i_ra)
            .add_product(t10, sin_motor_theta)
            .sub_product(t8, cos_motor_theta)
            .sub_product(t9, motor_i_ra);
    let motor_q_rb_forcing = t12
        * (t10 * cos_motor_theta)
            .add_product(t8, sin_motor_theta)
            .add_product(t11, motor_i_rb)
            .sub_product(t9, motor_i_rb);
    let motor_phi_forcing = t4
        * (p.motor_pole_pairs * motor_across * cos_motor_theta)
            .sub_product(p.motor_pole_pairs * motor_along, sin_motor_theta);
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
/// 335 operations.
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
/// 294 operations.
#[must_use]
pub fn prepared_rate_jacobian<R: Real>(
    time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
    c: &Constants<R>,
) -> [R; 30] {
    let [motor_phi, motor_i_sa, motor_i_sb, motor_i_ra, motor_i_rb, motor_omega] = *state;
    let motor_theta = p.motor_pole_pairs * motor_phi;
    let t0 = p.motor_supply_phase.add_product(c.motor_omega_0, time);
    let [(t1, t2), (sin_motor_theta, cos_motor_theta)] = R::sin_cos_each([
        t0,
        motor_theta,
    ]);
    let motor_along = (motor_i_sa * motor_i_ra).add_product(motor_i_sb, motor_i_rb);
    let motor_across = (motor_i_sb * motor_i_ra).sub_product(motor_i_sa, motor_i_rb);
    let motor_u_a = c.t0 * t2;
    let motor_u_b = c.t0 * t1;
    let t3 = c.t1 * cos_motor_theta;
    let t4 = c.t1 * sin_motor_theta;
    let t5 = t3 * c.t3;
    let t6 = t4 * c.t3;
    let t7 = t5 * t3;
    let t8 = t6 * t4;
    let t9 = R::literal(1.0) / (c.t2 - t7 - t8);
    let t10 = (t6 * t3).sub_product(t5, t4);
    let t11 = t10 * t9;
    let t12 = R::literal(1.0) / (c.t2 - t8 - t7).sub_product(t11, t10);
    let motor_pole_pairs_times_motor_i_ra = p.motor_pole_pairs * motor_i_ra;
    let motor_pole_pairs_times_motor_i_rb = p.motor_pole_pairs * motor_i_rb;
    let t13 = c.t1 * motor_omega;
    let t14 = (-(c.t4 * motor_i_sa))
        .add_product(R::literal(1.5), motor_u_a)
        .sub_product(
            t13,
            (-(motor_pole_pairs_times_motor_i_rb * cos_motor_theta))
                .sub_product(motor_pole_pairs_times_motor_i_ra, sin_motor_theta),
        );
    let t15 = (-(c.t4 * motor_i_sb))
        .add_product(R::literal(1.5), motor_u_b)
        .sub_product(
            t13,
            (motor_pole_pairs_times_motor_i_ra * cos_motor_theta)
                .sub_product(motor_pole_pairs_times_motor_i_rb, sin_motor_theta),
        );
    let t16 = c.t5 * motor_i_sb * motor_omega;
    let t17 = c.t5 * motor_i_sa * motor_omega;
    let t18 = (c.t8
        * (c.t7 * motor_i_ra)
            .add_product(t17, sin_motor_theta)
            .sub_product(t16, cos_motor_theta)
            .sub_product(c.t6, motor_i_ra))
        .sub_product(t5, t14)
        .sub_product(t6, t15);
    let motor_i_rb_dot = (c.t8
        * (t17 * cos_motor_theta)
            .add_product(t16, sin_motor_theta)
            .add_product(c.t7, motor_i_rb)
            .sub_product(c.t6, motor_i_rb))
        .add_product(t6, t14)
        .sub_product(t5, t15)
        .sub_product(t11, t18) * t12;
    let motor_i_ra_dot = (t18 * t9).sub_product(t11, motor_i_rb_dot);
    let motor_i_sb_dot = (t15 * c.t3)
        .sub_product(t6, motor_i_ra_dot)
        .sub_product(t5, motor_i_rb_dot);
    let motor_i_sa_dot = (t14 * c.t3)
        .sub_product(t5, motor_i_ra_dot)
        .add_product(t6, motor_i_rb_dot);
    let t19 = (motor_i_ra * cos_motor_theta).sub_product(motor_i_rb, sin_motor_theta);
    let t20 = c.t10 * motor_omega;
    let t21 = (motor_i_ra * sin_motor_theta).add_product(motor_i_rb, cos_motor_theta);
    let t22 = (motor_i_sa * cos_motor_theta).add_product(motor_i_sb, sin_motor_theta);
    let t23 = c.t9 * sin_motor_theta;
    let t24 = c.t9 * cos_motor_theta;
    let t25 = (t20 * t19)
        .add_product(t23, motor_i_ra_dot)
        .add_product(t24, motor_i_rb_dot);
    let t26 = (t20 * t21)
        .sub_product(t24, motor_i_ra_dot)
        .add_product(t23, motor_i_rb_dot);
    let t27 = (t20 * t22)
        .add_product(t23, motor_i_sa_dot)
        .sub_product(t24, motor_i_sb_dot)
        .sub_product(t5, t25)
        .sub_product(t6, t26);
    let motor_omega_dot_by_motor_phi = c.t1
        * (-(c.motor_pole_pairs_squared * motor_across * sin_motor_theta))
            .sub_product(c.motor_pole_pairs_squared * motor_along, cos_motor_theta)
        * c.inverse_motor_inertia;
    let motor_i_rb_dot_by_motor_phi = (c.t11 * motor_omega
        * (R::literal(0.75) * motor_i_sb * cos_motor_theta)
            .sub_product(R::literal(0.75) * motor_i_sa, sin_motor_theta))
        .add_product(t24, motor_i_sa_dot)
        .add_product(t23, motor_i_sb_dot)
        .add_product(t6, t25)
        .sub_product(t5, t26)
        .sub_product(t11, t27) * t12;
    let motor_i_ra_dot_by_motor_phi = (t27 * t9)
        .sub_product(t11, motor_i_rb_dot_by_motor_phi);
    let motor_i_sb_dot_by_motor_phi = (t26 * c.t3)
        .sub_product(t6, motor_i_ra_dot_by_motor_phi)
        .sub_product(t5, motor_i_rb_dot_by_motor_phi);
    let motor_i_sa_dot_by_motor_phi = (t25 * c.t3)
        .sub_product(t5, motor_i_ra_dot_by_motor_phi)
        .add_product(t6, motor_i_rb_dot_by_motor_phi);
    let t28 = c.t9 * motor_omega;
    let t29 = t28 * sin_motor_theta;
    let t30 = t28 * cos_motor_theta;
    let t31 = c.t9 * t21;
    let t32 = t29.sub_product(t5, c.t13);
    let t33 = t6 * c.t13;
    let motor_omega_dot_by_motor_i_sa = -(t31 * c.inverse_motor_inertia);
    let motor_i_rb_dot_by_motor_i_sa = (t30 + t33).sub_product(t11, t32) * t12;
    let motor_i_ra_dot_by_motor_i_sa = (t32 * t9)
        .sub_product(t11, motor_i_rb_dot_by_motor_i_sa);
    let motor_i_sb_dot_by_motor_i_sa = (-(t5 * motor_i_rb_dot_by_motor_i_sa))
        .sub_product(t6, motor_i_ra_dot_by_motor_i_sa);
    let motor_i_sa_dot_by_motor_i_sa = c
        .t14
        .sub_product(t5, motor_i_ra_dot_by_motor_i_sa)
        .add_product(t6, motor_i_rb_dot_by_motor_i_sa);
    let t34 = -t30 - t33;
    let motor_omega_dot_by_motor_i_sb = c.t9 * t19 * c.inverse_motor_inertia;
    let motor_i_rb_dot_by_motor_i_sb = t32.sub_product(t11, t34) * t12;
    let motor_i_ra_dot_by_motor_i_sb = (t34 * t9)
        .sub_product(t11, motor_i_rb_dot_by_motor_i_sb);
    let motor_i_sb_dot_by_motor_i_sb = c
        .t14
        .sub_product(t6, motor_i_ra_dot_by_motor_i_sb)
        .sub_product(t5, motor_i_rb_dot_by_motor_i_sb);
    let motor_i_sa_dot_by_motor_i_sb = (t6 * motor_i_rb_dot_by_motor_i_sb)
        .sub_product(t5, motor_i_ra_dot_by_motor_i_sb);
    let t35 = t5 * t29;
    let t36 = t6 * t30;
    let t37 = c.t15 - t35 + t36;
    let t38 = t6 * t29;
    let t39 = t5 * t30;
    let motor_omega_dot_by_motor_i_ra = c.t1
        * (p.motor_pole_pairs * motor_i_sb * cos_motor_theta)
            .sub_product(p.motor_pole_pairs * motor_i_sa, sin_motor_theta)
        * c.inverse_motor_inertia;
    let motor_i_rb_dot_by_motor_i_ra = (t38 + t39).sub_product(t11, t37) * t12;
    let motor_i_ra_dot_by_motor_i_ra = (t37 * t9)
        .sub_product(t11, motor_i_rb_dot_by_motor_i_ra);
    let t40 = t30 * c.t3;
    let motor_i_sb_dot_by_motor_i_ra = (-t40)
        .sub_product(t6, motor_i_ra_dot_by_motor_i_ra)
        .sub_product(t5, motor_i_rb_dot_by_motor_i_ra);
    let t41 = t29 * c.t3;
    let motor_i_sa_dot_by_motor_i_ra = t41
        .sub_product(t5, motor_i_ra_dot_by_motor_i_ra)
        .add_product(t6, motor_i_rb_dot_by_motor_i_ra);
    let t42 = c.t9 * t22;
    let t43 = -t39 - t38;
    let motor_omega_dot_by_motor_i_rb = -(t42 * c.inverse_motor_inertia);
    let motor_i_rb_dot_by_motor_i_rb = (c.t15 + t36 - t35).sub_product(t11, t43) * t12;
    let motor_i_ra_dot_by_motor_i_rb = (t43 * t9)
        .sub_product(t11, motor_i_rb_dot_by_motor_i_rb);
    let motor_i_sb_dot_by_motor_i_rb = t41
        .sub_product(t6, motor_i_ra_dot_by_motor_i_rb)
        .sub_product(t5, motor_i_rb_dot_by_motor_i_rb);
    let motor_i_sa_dot_by_motor_i_rb = t40
        .sub_product(t5, motor_i_ra_dot_by_motor_i_rb)
        .add_product(t6, motor_i_rb_dot_by_motor_i_rb);
    let t44 = c.t16
        * (R::literal(0.75) * motor_i_rb * sin_motor_theta)
            .sub_product(R::literal(0.75) * motor_i_ra, cos_motor_theta);
    let t45 = (c.t9
        * (motor_i_sa * sin_motor_theta).sub_product(motor_i_sb, cos_motor_theta))
        .sub_product(t5, t31)
        .sub_product(t6, t44);
    let motor_i_rb_dot_by_motor_omega = t42
        .add_product(t6, t31)
        .sub_product(t5, t44)
        .sub_product(t11, t45) * t12;
    let motor_i_ra_dot_by_motor_omega = (t45 * t9)
        .sub_product(t11, motor_i_rb_dot_by_motor_omega);
    let motor_i_sb_dot_by_motor_omega = (t44 * c.t3)
        .sub_product(t6, motor_i_ra_dot_by_motor_omega)
        .sub_product(t5, motor_i_rb_dot_by_motor_omega);
    let motor_i_sa_dot_by_motor_omega = (t31 * c.t3)
        .sub_product(t5, motor_i_ra_dot_by_motor_omega)
        .add_product(t6, motor_i_rb_dot_by_motor_omega);
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
/// 578 operations.
#[must_use]
pub fn parameter_jacobian<R: Real>(
    time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
) -> [R; 41] {
    let [motor_phi, motor_i_sa, motor_i_sb, motor_i_ra, motor_i_rb, motor_omega] = *state;
    let motor_theta = p.motor_pole_pairs * motor_phi;
    let motor_omega_0 = R::literal(core::f64::consts::TAU) * p.motor_supply_frequency;
    let t0 = p.motor_supply_phase.add_product(motor_omega_0, time);
    let [(t1, t2), (sin_motor_theta, cos_motor_theta)] = R::sin_cos_each([
        t0,
        motor_theta,
    ]);
    let motor_sigma = R::literal(1.0).sub_product(p.motor_k_s, p.motor_k_r);
    let motor_along = (motor_i_sa * motor_i_ra).add_product(motor_i_sb, motor_i_rb);
    let motor_across = (motor_i_sb * motor_i_ra).sub_product(motor_i_sa, motor_i_rb);
    let motor_L_s = p.motor_x_s / motor_omega_0;
    let motor_R_s = p.motor_x_s * p.motor_alpha_s * motor_sigma;
    let motor_M = p.motor_k_s * motor_L_s;
    let t3 = p.motor_phase_voltage * R::literal(core::f64::consts::SQRT_2);
    let motor_u_a = t3 * t2;
    let motor_u_b = t3 * t1;
    let motor_L_r = motor_M / p.motor_k_r;
    let t4 = R::literal(1.5) * motor_L_s;
    let t5 = R::literal(1.5) * motor_M;
    let t6 = t5 * cos_motor_theta;
    let t7 = t5 * sin_motor_theta;
    let t8 = R::literal(1.5) * motor_L_r;
    let t9 = R::literal(1.0) / t4;
    let t10 = t6 * t9;
    let t11 = t7 * t9;
    let t12 = t10 * t6;
    let t13 = t11 * t7;
    let t14 = R::literal(1.0) / (t8 - t12 - t13);
    let t15 = (t11 * t6).sub_product(t10, t7);
    let t16 = t15 * t14;
    let t17 = R::literal(1.0) / (t8 - t13 - t12).sub_product(t16, t15);
    let inverse_motor_inertia = R::literal(1.0) / p.motor_inertia;
    let t18 = R::literal(1.5) * motor_R_s;
    let motor_pole_pairs_times_motor_i_ra = p.motor_pole_pairs * motor_i_ra;
    let motor_pole_pairs_times_motor_i_rb = p.motor_pole_pairs * motor_i_rb;
    let t19 = (-(motor_pole_pairs_times_motor_i_rb * cos_motor_theta))
        .sub_product(motor_pole_pairs_times_motor_i_ra, sin_motor_theta);
    let t20 = t5 * motor_omega;
    let t21 = R::literal(1.5) * motor_u_a;
    let t22 = t21.sub_product(t18, motor_i_sa).sub_product(t20, t19);
    let t23 = (motor_pole_pairs_times_motor_i_ra * cos_motor_theta)
        .sub_product(motor_pole_pairs_times_motor_i_rb, sin_motor_theta);
    let t24 = R::literal(1.5) * motor_u_b;
    let t25 = t24.sub_product(t18, motor_i_sb).sub_product(t20, t23);
    let t26 = R::literal(0.75) * p.motor_pole_pairs * p.motor_k_r;
    let t27 = t26 * motor_i_sb * motor_omega;
    let t28 = t27 * cos_motor_theta;
    let t29 = R::literal(0.75) * p.motor_alpha_r * motor_omega_0;
    let t30 = t29 * motor_i_ra;
    let t31 = t26 * motor_i_sa * motor_omega;
    let t32 = t31 * sin_motor_theta;
    let t33 = R::literal(0.75) * p.motor_k_s * p.motor_k_r * p.motor_alpha_r
        * motor_omega_0;
    let t34 = t32.add_product(t33, motor_i_ra) - t28 - t30;
    let t35 = R::literal(2.0) * motor_L_r;
    let t36 = t29 * motor_i_rb;
    let t37 = (t31 * cos_motor_theta).add_product(t27, sin_motor_theta);
    let t38 = t37.add_product(t33, motor_i_rb) - t36;
    let t39 = (p.motor_pole_pairs * motor_across * cos_motor_theta)
        .sub_product(p.motor_pole_pairs * motor_along, sin_motor_theta);
    let t40 = (t35 * t34).sub_product(t10, t22).sub_product(t11, t25);
    let motor_omega_dot = t5 * t39 * inverse_motor_inertia;
    let motor_i_rb_dot = (t35 * t38)
        .add_product(t11, t22)
        .sub_product(t10, t25)
        .sub_product(t16, t40) * t17;
    let motor_i_ra_dot = (t40 * t14).sub_product(t16, motor_i_rb_dot);
    let motor_i_sb_dot = (t25 * t9)
        .sub_product(t11, motor_i_ra_dot)
        .sub_product(t10, motor_i_rb_dot);
    let motor_i_sa_dot = (t22 * t9)
        .sub_product(t10, motor_i_ra_dot)
        .add_product(t11, motor_i_rb_dot);
    let motor_i_sa_times_cos_motor_theta = motor_i_sa * cos_motor_theta;
    let motor_i_sb_times_sin_motor_theta = motor_i_sb * sin_motor_theta;
    let t41 = R::literal(1.5) * p.motor_k_s;
    let t42 = t41 * p.motor_k_r;
    let t43 = t42 - R::literal(1.5);
    let motor_omega_dot_by_motor_inertia = -(motor_omega_dot * inverse_motor_inertia);
    let t44 = R::literal(2.121_320_343_559_643) * t2;
    let t45 = R::literal(2.121_320_343_559_643) * t1;
    let t46 = (-(t11 * t45)).sub_product(t10, t44);
    let motor_i_rb_dot_by_motor_phase_voltage = (t11 * t44)
        .sub_product(t10, t45)
        .sub_product(t16, t46) * t17;
    let motor_i_ra_dot_by_motor_phase_voltage = (t46 * t14)
        .sub_product(t16, motor_i_rb_dot_by_motor_phase_voltage);
    let motor_i_sb_dot_by_motor_phase_voltage = (t45 * t9)
        .sub_product(t11, motor_i_ra_dot_by_motor_phase_voltage)
        .sub_product(t10, motor_i_rb_dot_by_motor_phase_voltage);
    let motor_i_sa_dot_by_motor_phase_voltage = (t44 * t9)
        .sub_product(t10, motor_i_ra_dot_by_motor_phase_voltage)
        .add_product(t11, motor_i_rb_dot_by_motor_phase_voltage);
    let t47 = R::literal(3.0 * core::f64::consts::PI) * time;
    let t48 = t5 / p.motor_supply_frequency;
    let t49 = t48 * motor_omega;
    let t50 = t4 / p.motor_supply_frequency;
    let t51 = t48 * cos_motor_theta;
    let t52 = t48 * sin_motor_theta;
    let t53 = (t49 * t19)
        .sub_product(t47, motor_u_b)
        .add_product(t50, motor_i_sa_dot)
        .add_product(t51, motor_i_ra_dot)
        .sub_product(t52, motor_i_rb_dot);
    let t54 = (t49 * t23)
        .add_product(t47, motor_u_a)
        .add_product(t50, motor_i_sb_dot)
        .add_product(t52, motor_i_ra_dot)
        .add_product(t51, motor_i_rb_dot);
    let t55 = t8 / p.motor_supply_frequency;
    let t56 = (R::literal(2.0) * p.motor_pole_pairs * motor_M / p.motor_supply_frequency
        * motor_omega
        * (R::literal(0.75) * motor_i_sb * cos_motor_theta)
            .sub_product(R::literal(0.75) * motor_i_sa, sin_motor_theta))
        .add_product(t51, motor_i_sa_dot)
        .add_product(t52, motor_i_sb_dot)
        .add_product(t55, motor_i_ra_dot)
        .sub_product(t10, t53)
        .sub_product(t11, t54);
    let motor_omega_dot_by_motor_supply_frequency = -(t48 * t39 * inverse_motor_inertia);
    let motor_i_rb_dot_by_motor_supply_frequency = (-(R::literal(1.5)
        * p.motor_pole_pairs * motor_M / p.motor_supply_frequency * motor_omega
        * (motor_i_sa_times_cos_motor_theta + motor_i_sb_times_sin_motor_theta)))
        .sub_product(t52, motor_i_sa_dot)
        .add_product(t51, motor_i_sb_dot)
        .add_product(t55, motor_i_rb_dot)
        .add_product(t11, t53)
        .sub_product(t10, t54)
        .sub_product(t16, t56) * t17;
    let motor_i_ra_dot_by_motor_supply_frequency = (t56 * t14)
        .sub_product(t16, motor_i_rb_dot_by_motor_supply_frequency);
    let motor_i_sb_dot_by_motor_supply_frequency = (t54 * t9)
        .sub_product(t11, motor_i_ra_dot_by_motor_supply_frequency)
        .sub_product(t10, motor_i_rb_dot_by_motor_supply_frequency);
    let motor_i_sa_dot_by_motor_supply_frequency = (t53 * t9)
        .sub_product(t10, motor_i_ra_dot_by_motor_supply_frequency)
        .add_product(t11, motor_i_rb_dot_by_motor_supply_frequency);
    let t57 = (t10 * t24).sub_product(t11, t21);
    let motor_i_rb_dot_by_motor_supply_phase = (-(t10 * t21))
        .sub_product(t11, t24)
        .sub_product(t16, t57) * t17;
    let motor_i_ra_dot_by_motor_supply_phase = (t57 * t14)
        .sub_product(t16, motor_i_rb_dot_by_motor_supply_phase);
    let motor_i_sb_dot_by_motor_supply_phase = (t21 * t9)
        .sub_product(t11, motor_i_ra_dot_by_motor_supply_phase)
        .sub_product(t10, motor_i_rb_dot_by_motor_supply_phase);
    let motor_i_sa_dot_by_motor_supply_phase = (-(t24 * t9))
        .sub_product(t10, motor_i_ra_dot_by_motor_supply_phase)
        .add_product(t11, motor_i_rb_dot_by_motor_supply_phase);
    let motor_i_rb_times_motor_theta = motor_i_rb * motor_theta;
    let motor_i_ra_times_motor_theta = motor_i_ra * motor_theta;
    let motor_i_sa_times_motor_theta = motor_i_sa * motor_theta;
    let motor_i_sb_times_motor_theta = motor_i_sb * motor_theta;
    let t58 = t5 * motor_phi;
    let t59 = t58 * sin_motor_theta;
    let t60 = t58 * cos_motor_theta;
    let t61 = (t20
        * (motor_i_ra_times_motor_theta * cos_motor_theta)
            .add_product(motor_i_ra, sin_motor_theta)
            .add_product(motor_i_rb, cos_motor_theta)
            .sub_product(motor_i_rb_times_motor_theta, sin_motor_theta))
        .add_product(t59, motor_i_ra_dot)
        .add_product(t60, motor_i_rb_dot);
    let t62 = (t20
        * (motor_i_ra_times_motor_theta * sin_motor_theta)
            .add_product(motor_i_rb_times_motor_theta, cos_motor_theta)
            .add_product(motor_i_rb, sin_motor_theta)
            .sub_product(motor_i_ra, cos_motor_theta))
        .sub_product(t60, motor_i_ra_dot)
        .add_product(t59, motor_i_rb_dot);
    let t63 = (t20
        * (motor_i_sa_times_motor_theta * cos_motor_theta)
            .add_product(motor_i_sa, sin_motor_theta)
            .add_product(motor_i_sb_times_motor_theta, sin_motor_theta)
            .sub_product(motor_i_sb, cos_motor_theta))
        .add_product(t59, motor_i_sa_dot)
        .sub_product(t60, motor_i_sb_dot)
        .sub_product(t10, t61)
        .sub_product(t11, t62);
    let motor_omega_dot_by_motor_pole_pairs = t5
        * (motor_across * cos_motor_theta)
            .sub_product(motor_theta * motor_along, cos_motor_theta)
            .sub_product(motor_theta * motor_across, sin_motor_theta)
            .sub_product(motor_along, sin_motor_theta) * inverse_motor_inertia;
    let motor_i_rb_dot_by_motor_pole_pairs = (-(t20
        * ((-motor_i_sa_times_cos_motor_theta)
            .add_product(motor_i_sa_times_motor_theta, sin_motor_theta)
            .sub_product(motor_i_sb_times_motor_theta, cos_motor_theta)
            - motor_i_sb_times_sin_motor_theta)))
        .add_product(t60, motor_i_sa_dot)
        .add_product(t59, motor_i_sb_dot)
        .add_product(t11, t61)
        .sub_product(t10, t62)
        .sub_product(t16, t63) * t17;
    let motor_i_ra_dot_by_motor_pole_pairs = (t63 * t14)
        .sub_product(t16, motor_i_rb_dot_by_motor_pole_pairs);
    let motor_i_sb_dot_by_motor_pole_pairs = (t62 * t9)
        .sub_product(t11, motor_i_ra_dot_by_motor_pole_pairs)
        .sub_product(t10, motor_i_rb_dot_by_motor_pole_pairs);
    let motor_i_sa_dot_by_motor_pole_pairs = (t61 * t9)
        .sub_product(t10, motor_i_ra_dot_by_motor_pole_pairs)
        .add_product(t11, motor_i_rb_dot_by_motor_pole_pairs);
    let t64 = t4 * motor_omega;
    let t65 = R::literal(1.5) * p.motor_k_r * p.motor_x_s * p.motor_alpha_s;
    let t66 = t42 * p.motor_alpha_r * motor_omega_0;
    let t67 = R::literal(2.0) * motor_L_s / p.motor_k_r;
    let t68 = t4 * cos_motor_theta;
    let t69 = t4 * sin_motor_theta;
    let t70 = (t65 * motor_i_sa)
        .sub_product(t64, t19)
        .sub_product(t68, motor_i_ra_dot)
        .add_product(t69, motor_i_rb_dot);
    let t71 = (t65 * motor_i_sb)
        .sub_product(t64, t23)
        .sub_product(t69, motor_i_ra_dot)
        .sub_product(t68, motor_i_rb_dot);
    let t72 = t4 / p.motor_k_r;
    let t73 = (t67 * (t32.add_product(t66, motor_i_ra) - t28 - t30))
        .sub_product(t68, motor_i_sa_dot)
        .sub_product(t69, motor_i_sb_dot)
        .sub_product(t72, motor_i_ra_dot)
        .sub_product(t10, t70)
        .sub_product(t11, t71);
    let motor_omega_dot_by_motor_k_s = t4 * t39 * inverse_motor_inertia;
    let motor_i_rb_dot_by_motor_k_s = (t67 * (t37.add_product(t66, motor_i_rb) - t36))
        .add_product(t69, motor_i_sa_dot)
        .sub_product(t68, motor_i_sb_dot)
        .sub_product(t72, motor_i_rb_dot)
        .add_product(t11, t70)
        .sub_product(t10, t71)
        .sub_product(t16, t73) * t17;
    let motor_i_ra_dot_by_motor_k_s = (t73 * t14)
        .sub_product(t16, motor_i_rb_dot_by_motor_k_s);
    let motor_i_sb_dot_by_motor_k_s = (t71 * t9)
        .sub_product(t11, motor_i_ra_dot_by_motor_k_s)
        .sub_product(t10, motor_i_rb_dot_by_motor_k_s);
    let motor_i_sa_dot_by_motor_k_s = (t70 * t9)
        .sub_product(t10, motor_i_ra_dot_by_motor_k_s)
        .add_product(t11, motor_i_rb_dot_by_motor_k_s);
    let t74 = t41 * p.motor_x_s;
    let t75 = t74 * p.motor_alpha_s;
    let t76 = t75 * motor_i_sa;
    let t77 = t75 * motor_i_sb;
    let t78 = t74 * p.motor_alpha_r / (p.motor_k_r * p.motor_k_r);
    let t79 = t8 / p.motor_k_r;
    let t80 = (t78 * motor_i_ra)
        .add_product(t79, motor_i_ra_dot)
        .sub_product(t10, t76)
        .sub_product(t11, t77);
    let motor_i_rb_dot_by_motor_k_r = (t78 * motor_i_rb)
        .add_product(t79, motor_i_rb_dot)
        .add_product(t11, t76)
        .sub_product(t10, t77)
        .sub_product(t16, t80) * t17;
    let motor_i_ra_dot_by_motor_k_r = (t80 * t14)
        .sub_product(t16, motor_i_rb_dot_by_motor_k_r);
    let motor_i_sb_dot_by_motor_k_r = (t77 * t9)
        .sub_product(t11, motor_i_ra_dot_by_motor_k_r)
        .sub_product(t10, motor_i_rb_dot_by_motor_k_r);
    let motor_i_sa_dot_by_motor_k_r = (t76 * t9)
        .sub_product(t10, motor_i_ra_dot_by_motor_k_r)
        .add_product(t11, motor_i_rb_dot_by_motor_k_r);
    let t81 = R::literal(1.5) * p.motor_alpha_s * motor_sigma;
    let t82 = t41 / motor_omega_0;
    let t83 = t82 * motor_omega;
    let motor_k_r_times_motor_omega_0 = p.motor_k_r * motor_omega_0;
    let t84 = R::literal(2.0) * p.motor_k_s / motor_k_r_times_motor_omega_0;
    let t85 = R::literal(1.5) / motor_omega_0;
    let t86 = t82 * cos_motor_theta;
    let t87 = t82 * sin_motor_theta;
    let t88 = (-(t81 * motor_i_sa))
        .sub_product(t83, t19)
        .sub_product(t85, motor_i_sa_dot)
        .sub_product(t86, motor_i_ra_dot)
        .add_product(t87, motor_i_rb_dot);
    let t89 = (-(t81 * motor_i_sb))
        .sub_product(t83, t23)
        .sub_product(t85, motor_i_sb_dot)
        .sub_product(t87, motor_i_ra_dot)
        .sub_product(t86, motor_i_rb_dot);
    let t90 = t41 / motor_k_r_times_motor_omega_0;
    let t91 = (t84 * t34)
        .sub_product(t86, motor_i_sa_dot)
        .sub_product(t87, motor_i_sb_dot)
        .sub_product(t90, motor_i_ra_dot)
        .sub_product(t10, t88)
        .sub_product(t11, t89);
    let motor_omega_dot_by_motor_x_s = t82 * t39 * inverse_motor_inertia;
    let motor_i_rb_dot_by_motor_x_s = (t84 * t38)
        .add_product(t87, motor_i_sa_dot)
        .sub_product(t86, motor_i_sb_dot)
        .sub_product(t90, motor_i_rb_dot)
        .add_product(t11, t88)
        .sub_product(t10, t89)
        .sub_product(t16, t91) * t17;
    let motor_i_ra_dot_by_motor_x_s = (t91 * t14)
        .sub_product(t16, motor_i_rb_dot_by_motor_x_s);
    let motor_i_sb_dot_by_motor_x_s = (t89 * t9)
        .sub_product(t11, motor_i_ra_dot_by_motor_x_s)
        .sub_product(t10, motor_i_rb_dot_by_motor_x_s);
    let motor_i_sa_dot_by_motor_x_s = (t88 * t9)
        .sub_product(t10, motor_i_ra_dot_by_motor_x_s)
        .add_product(t11, motor_i_rb_dot_by_motor_x_s);
    let t92 = p.motor_x_s * t43;
    let t93 = t92 * motor_i_sa;
    let t94 = t92 * motor_i_sb;
    let t95 = (-(t11 * t94)).sub_product(t10, t93);
    let motor_i_rb_dot_by_motor_alpha_s = (t11 * t93)
        .sub_product(t10, t94)
        .sub_product(t16, t95) * t17;
    let motor_i_ra_dot_by_motor_alpha_s = (t95 * t14)
        .sub_product(t16, motor_i_rb_dot_by_motor_alpha_s);
    let motor_i_sb_dot_by_motor_alpha_s = (t94 * t9)
        .sub_product(t11, motor_i_ra_dot_by_motor_alpha_s)
        .sub_product(t10, motor_i_rb_dot_by_motor_alpha_s);
    let motor_i_sa_dot_by_motor_alpha_s = (t93 * t9)
        .sub_product(t10, motor_i_ra_dot_by_motor_alpha_s)
        .add_product(t11, motor_i_rb_dot_by_motor_alpha_s);
    let t96 = p.motor_k_s * p.motor_x_s * t43 / p.motor_k_r;
    let t97 = t96 * motor_i_ra;
    let motor_i_rb_dot_by_motor_alpha_r = (t96 * motor_i_rb).sub_product(t16, t97) * t17;
    let motor_i_ra_dot_by_motor_alpha_r = (t97 * t14)
        .sub_product(t16, motor_i_rb_dot_by_motor_alpha_r);
    let motor_i_sb_dot_by_motor_alpha_r = (-(t10 * motor_i_rb_dot_by_motor_alpha_r))
        .sub_product(t11, motor_i_ra_dot_by_motor_alpha_r);
    let motor_i_sa_dot_by_motor_alpha_r = (t11 * motor_i_rb_dot_by_motor_alpha_r)
        .sub_product(t10, motor_i_ra_dot_by_motor_alpha_r);
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
    let t0 = p.motor_supply_phase.add_product(motor_omega_0, time);
    let [(t1, t2), (sin_motor_theta, cos_motor_theta)] = R::sin_cos_each([
        t0,
        motor_theta,
    ]);
    let motor_L_s = p.motor_x_s / motor_omega_0;
    let motor_M = p.motor_k_s * motor_L_s;
    let t3 = p.motor_phase_voltage * R::literal(core::f64::consts::SQRT_2);
    let motor_u_a = t3 * t2;
    let motor_u_b = t3 * t1;
    let motor_L_r = motor_M / p.motor_k_r;
    let t4 = R::literal(1.5) * motor_M;
    let t5 = t4 * cos_motor_theta;
    let t6 = t4 * sin_motor_theta;
    let t7 = R::literal(1.5) * motor_L_r;
    let t8 = R::literal(1.0) / (R::literal(1.5) * motor_L_s);
    let t9 = t5 * t8;
    let t10 = t6 * t8;
    let t11 = t9 * t5;
    let t12 = t10 * t6;
    let t13 = R::literal(1.0) / (t7 - t11 - t12);
    let t14 = (t10 * t5).sub_product(t9, t6);
    let t15 = t14 * t13;
    let t16 = R::literal(1.5) * motor_omega_0;
    let t17 = t16 * motor_u_b;
    let t18 = t16 * motor_u_a;
    let t19 = (t9 * t17).sub_product(t10, t18);
    let motor_i_rb_dot_by_time = (-(t9 * t18))
        .sub_product(t10, t17)
        .sub_product(t15, t19)
        * (R::literal(1.0) / (t7 - t12 - t11).sub_product(t15, t14));
    let motor_i_ra_dot_by_time = (t19 * t13).sub_product(t15, motor_i_rb_dot_by_time);
    let motor_i_sb_dot_by_time = (t18 * t8)
        .sub_product(t10, motor_i_ra_dot_by_time)
        .sub_product(t9, motor_i_rb_dot_by_time);
    let motor_i_sa_dot_by_time = (-(t17 * t8))
        .sub_product(t9, motor_i_ra_dot_by_time)
        .add_product(t10, motor_i_rb_dot_by_time);
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
    let (sin_motor_theta, cos_motor_theta) = motor_theta.sin_cos();
    let motor_omega_0 = R::literal(core::f64::consts::TAU) * p.motor_supply_frequency;
    let motor_along = (motor_i_sa * motor_i_ra).add_product(motor_i_sb, motor_i_rb);
    let motor_across = (motor_i_sb * motor_i_ra).sub_product(motor_i_sa, motor_i_rb);
    let motor_L_s = p.motor_x_s / motor_omega_0;
    let motor_M = p.motor_k_s * motor_L_s;
    let motor_torque = R::literal(1.5) * p.motor_pole_pairs * motor_M
        * (motor_across * cos_motor_theta).sub_product(motor_along, sin_motor_theta);
    Outputs {
        speed: motor_omega,
        torque: motor_torque,
        slip: R::literal(1.0)
            .sub_product(p.motor_pole_pairs / motor_omega_0, motor_omega),
        stator_current: (motor_i_sa * motor_i_sa)
            .add_product(motor_i_sb, motor_i_sb)
            .sqrt(),
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
    let (sin_motor_theta, cos_motor_theta) = motor_theta.sin_cos();
    let motor_omega_0 = R::literal(core::f64::consts::TAU) * p.motor_supply_frequency;
    let motor_along = (motor_i_sa * motor_i_ra).add_product(motor_i_sb, motor_i_rb);
    let motor_across = (motor_i_sb * motor_i_ra).sub_product(motor_i_sa, motor_i_rb);
    let motor_L_s = p.motor_x_s / motor_omega_0;
    let motor_M = p.motor_k_s * motor_L_s;
    let motor_L_r = motor_M / p.motor_k_r;
    Energy {
        kinetic: (R::literal(0.5) * p.motor_inertia * (motor_omega * motor_omega))
            .add_product(
                R::literal(0.75),
                (motor_L_s
                    * (motor_i_sa * motor_i_sa).add_product(motor_i_sb, motor_i_sb))
                    .add_product(
                        motor_L_r,
                        (motor_i_ra * motor_i_ra).add_product(motor_i_rb, motor_i_rb),
                    ),
            )
            .add_product(
                R::literal(1.5) * motor_M,
                (motor_along * cos_motor_theta)
                    .add_product(motor_across, sin_motor_theta),
            ),
        potential: R::literal(0.0),
        stored: R::literal(0.0),
    }
}

/// `dE/dt`, power supplied and power dissipated \[W\].
///
/// 185 operations.
#[must_use]
pub fn power_balance<R: Real>(
    time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
) -> PowerBalance<R> {
    let [motor_phi, motor_i_sa, motor_i_sb, motor_i_ra, motor_i_rb, motor_omega] = *state;
    let motor_theta = p.motor_pole_pairs * motor_phi;
    let motor_omega_0 = R::literal(core::f64::consts::TAU) * p.motor_supply_frequency;
    let t0 = p.motor_supply_phase.add_product(motor_omega_0, time);
    let [(t1, t2), (sin_motor_theta, cos_motor_theta)] = R::sin_cos_each([
        t0,
        motor_theta,
    ]);
    let motor_sigma = R::literal(1.0).sub_product(p.motor_k_s, p.motor_k_r);
    let motor_along = (motor_i_sa * motor_i_ra).add_product(motor_i_sb, motor_i_rb);
    let motor_across = (motor_i_sb * motor_i_ra).sub_product(motor_i_sa, motor_i_rb);
    let motor_L_s = p.motor_x_s / motor_omega_0;
    let motor_R_s = p.motor_x_s * p.motor_alpha_s * motor_sigma;
    let motor_M = p.motor_k_s * motor_L_s;
    let t3 = p.motor_phase_voltage * R::literal(core::f64::consts::SQRT_2);
    let motor_u_a = t3 * t2;
    let motor_u_b = t3 * t1;
    let motor_L_r = motor_M / p.motor_k_r;
    let motor_R_r = p.motor_k_s * p.motor_x_s * p.motor_alpha_r * motor_sigma
        / p.motor_k_r;
    let t4 = R::literal(1.5) * motor_L_s;
    let t5 = R::literal(1.5) * motor_M;
    let t6 = t5 * cos_motor_theta;
    let t7 = t5 * sin_motor_theta;
    let t8 = R::literal(1.5) * motor_L_r;
    let t9 = R::literal(1.0) / t4;
    let t10 = t6 * t9;
    let t11 = t7 * t9;
    let t12 = t10 * t6;
    let t13 = t11 * t7;
    let t14 = R::literal(1.0) / (t8 - t12 - t13);
    let t15 = (t11 * t6).sub_product(t10, t7);
    let t16 = t15 * t14;
    let t17 = R::literal(1.5) * motor_R_s;
    let motor_pole_pairs_times_motor_i_ra = p.motor_pole_pairs * motor_i_ra;
    let motor_pole_pairs_times_motor_i_rb = p.motor_pole_pairs * motor_i_rb;
    let t18 = t5 * motor_omega;
    let t19 = (-(t17 * motor_i_sa))
        .add_product(R::literal(1.5), motor_u_a)
        .sub_product(
            t18,
            (-(motor_pole_pairs_times_motor_i_rb * cos_motor_theta))
                .sub_product(motor_pole_pairs_times_motor_i_ra, sin_motor_theta),
        );
    let t20 = (-(t17 * motor_i_sb))
        .add_product(R::literal(1.5), motor_u_b)
        .sub_product(
            t18,
            (motor_pole_pairs_times_motor_i_ra * cos_motor_theta)
                .sub_product(motor_pole_pairs_times_motor_i_rb, sin_motor_theta),
        );
    let t21 = R::literal(0.75) * p.motor_pole_pairs * p.motor_k_r;
    let t22 = t21 * motor_i_sb * motor_omega;
    let t23 = R::literal(0.75) * p.motor_alpha_r * motor_omega_0;
    let t24 = t21 * motor_i_sa * motor_omega;
    let t25 = R::literal(0.75) * p.motor_k_s * p.motor_k_r * p.motor_alpha_r
        * motor_omega_0;
    let t26 = R::literal(2.0) * motor_L_r;
    let t27 = t5
        * (p.motor_pole_pairs * motor_across * cos_motor_theta)
            .sub_product(p.motor_pole_pairs * motor_along, sin_motor_theta);
    let t28 = (t26
        * (t25 * motor_i_ra)
            .add_product(t24, sin_motor_theta)
            .sub_product(t22, cos_motor_theta)
            .sub_product(t23, motor_i_ra))
        .sub_product(t10, t19)
        .sub_product(t11, t20);
    let motor_omega_dot = t27 * (R::literal(1.0) / p.motor_inertia);
    let motor_i_rb_dot = (t26
        * (t24 * cos_motor_theta)
            .add_product(t22, sin_motor_theta)
            .add_product(t25, motor_i_rb)
            .sub_product(t23, motor_i_rb))
        .add_product(t11, t19)
        .sub_product(t10, t20)
        .sub_product(t16, t28)
        * (R::literal(1.0) / (t8 - t13 - t12).sub_product(t16, t15));
    let motor_i_ra_dot = (t28 * t14).sub_product(t16, motor_i_rb_dot);
    let motor_i_sb_dot = (t20 * t9)
        .sub_product(t11, motor_i_ra_dot)
        .sub_product(t10, motor_i_rb_dot);
    let motor_i_sa_dot = (t19 * t9)
        .sub_product(t10, motor_i_ra_dot)
        .add_product(t11, motor_i_rb_dot);
    let t29 = R::literal(1.5) * motor_R_r;
    PowerBalance {
        stored_rate: (t27 * motor_omega)
            .add_product(
                (t4 * motor_i_sa)
                    .add_product(
                        t5,
                        (motor_i_ra * cos_motor_theta)
                            .sub_product(motor_i_rb, sin_motor_theta),
                    ),
                motor_i_sa_dot,
            )
            .add_product(
                (t4 * motor_i_sb)
                    .add_product(
                        t5,
                        (motor_i_ra * sin_motor_theta)
                            .add_product(motor_i_rb, cos_motor_theta),
                    ),
                motor_i_sb_dot,
            )
            .add_product(
                (t8 * motor_i_ra)
                    .add_product(
                        t5,
                        (motor_i_sa * cos_motor_theta)
                            .add_product(motor_i_sb, sin_motor_theta),
                    ),
                motor_i_ra_dot,
            )
            .add_product(
                (t8 * motor_i_rb)
                    .add_product(
                        t5,
                        (motor_i_sb * cos_motor_theta)
                            .sub_product(motor_i_sa, sin_motor_theta),
                    ),
                motor_i_rb_dot,
            )
            .add_product(p.motor_inertia * motor_omega, motor_omega_dot),
        supplied: (R::literal(1.5) * motor_i_sa * motor_u_a)
            .add_product(R::literal(1.5) * motor_i_sb, motor_u_b),
        dissipated: (t17 * (motor_i_sa * motor_i_sa))
            .add_product(t17, motor_i_sb * motor_i_sb)
            .add_product(t29, motor_i_ra * motor_i_ra)
            .add_product(t29, motor_i_rb * motor_i_rb),
    }
}

/// Normalized Taylor coefficients of the solution through `state`, order after order.
///
/// `_k` marks the coefficient of order k, `_before` that of order k - 1; bare names are
/// zeroth coefficients. The workspace is as `series_workspace` says.
///
/// 129 recurrences. 28 sums of products an order.
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
    let t17 = R::literal(1.5) * motor_R_s;
    let t18 = motor_i_sa * t17;
    let t19 = motor_i_ra * p.motor_pole_pairs;
    let t20 = t19 * sin_motor_theta;
    let t21 = motor_i_rb * p.motor_pole_pairs;
    let t22 = t21 * cos_motor_theta;
    let t23 = -t20;
    let t24 = t23 - t22;
    let t25 = motor_omega * t1;
    let t26 = t25 * t24;
    let t27 = t16 * R::literal(1.5);
    let t28 = t15 * t27;
    let t29 = t28 - t18;
    let t30 = t29 - t26;
    let t31 = motor_i_sb * t17;
    let t32 = t21 * sin_motor_theta;
    let t33 = t19 * cos_motor_theta;
    let t34 = t33 - t32;
    let t35 = t25 * t34;
    let t36 = t14 * t27;
    let t37 = t36 - t31;
    let t38 = t37 - t35;
    let t39 = R::literal(0.75) * p.motor_pole_pairs;
    let t40 = t39 * p.motor_k_r;
    let t41 = motor_i_sb * t40;
    let t42 = t41 * motor_omega;
    let t43 = t42 * cos_motor_theta;
    let t44 = R::literal(0.75) * p.motor_alpha_r;
    let t45 = t44 * motor_omega_0;
    let t46 = motor_i_ra * t45;
    let t47 = motor_i_sa * t40;
    let t48 = t47 * motor_omega;
    let t49 = t48 * sin_motor_theta;
    let t50 = R::literal(0.75) * p.motor_k_s;
    let t51 = t50 * p.motor_k_r;
    let t52 = t51 * p.motor_alpha_r;
    let t53 = t52 * motor_omega_0;
    let t54 = motor_i_ra * t53;
    let t55 = t49 + t54;
    let t56 = t55 - t43;
    let t57 = t56 - t46;
    let t58 = R::literal(2.0) * motor_L_r;
    let t59 = t57 * t58;
    let t60 = motor_i_rb * t45;
    let t61 = t48 * cos_motor_theta;
    let t62 = t42 * sin_motor_theta;
    let t63 = motor_i_rb * t53;
    let t64 = t61 + t62;
    let t65 = t64 + t63;
    let t66 = t65 - t60;
    let t67 = t66 * t58;
    let t68 = motor_along * p.motor_pole_pairs;
    let t69 = t68 * sin_motor_theta;
    let t70 = motor_across * p.motor_pole_pairs;
    let t71 = t70 * cos_motor_theta;
    let t72 = t71 - t69;
    let t73 = t72 * t1;
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
    ] = factored.solve([t30, t38, t59, t67, t73]);
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
            .mul_add(cos_motor_theta, inverse * sums_1[2]);
        let cos_motor_theta_k = -motor_theta_k
            .mul_add(sin_motor_theta, inverse * sums_1[3]);
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
        let t19_k = motor_i_ra_k * p.motor_pole_pairs;
        let t20_k = t19
            .mul_add(sin_motor_theta_k, sin_motor_theta.mul_add(t19_k, sums_2[0]));
        let t21_k = motor_i_rb_k * p.motor_pole_pairs;
        let t22_k = t21
            .mul_add(cos_motor_theta_k, cos_motor_theta.mul_add(t21_k, sums_2[1]));
        let t23_k = -t20_k;
        let t24_k = t23_k - t22_k;
        let t25_k = motor_omega_k * t1;
        let t26_k = t25.mul_add(t24_k, t24.mul_add(t25_k, sums_4[3]));
        let t29_k = (-motor_i_sa_k).mul_add(t17, t15_k * t27);
        let t30_k = t29_k - t26_k;
        let t32_k = t21
            .mul_add(sin_motor_theta_k, sin_motor_theta.mul_add(t21_k, sums_2[2]));
        let t33_k = t19
            .mul_add(cos_motor_theta_k, cos_motor_theta.mul_add(t19_k, sums_2[3]));
        let t34_k = t33_k - t32_k;
        let t35_k = t25.mul_add(t34_k, t34.mul_add(t25_k, sums_4[2]));
        let t37_k = (-motor_i_sb_k).mul_add(t17, t14_k * t27);
        let t38_k = t37_k - t35_k;
        let t41_k = motor_i_sb_k * t40;
        let t42_k = motor_omega.mul_add(t41_k, t41.mul_add(motor_omega_k, sums_1[0]));
        let t43_k = t42
            .mul_add(cos_motor_theta_k, cos_motor_theta.mul_add(t42_k, sums_3[0]));
        let t47_k = motor_i_sa_k * t40;
        let t48_k = motor_omega.mul_add(t47_k, t47.mul_add(motor_omega_k, sums_1[1]));
        let t49_k = t48
            .mul_add(sin_motor_theta_k, sin_motor_theta.mul_add(t48_k, sums_3[1]));
        let t55_k = motor_i_ra_k.mul_add(t53, t49_k);
        let t56_k = t55_k - t43_k;
        let t57_k = (-motor_i_ra_k).mul_add(t45, t56_k);
        let t61_k = t48
            .mul_add(cos_motor_theta_k, cos_motor_theta.mul_add(t48_k, sums_3[2]));
        let t62_k = t42
            .mul_add(sin_motor_theta_k, sin_motor_theta.mul_add(t42_k, sums_3[3]));
        let t64_k = t61_k + t62_k;
        let t65_k = motor_i_rb_k.mul_add(t53, t64_k);
        let t66_k = (-motor_i_rb_k).mul_add(t45, t65_k);
        let t68_k = motor_along_k * p.motor_pole_pairs;
        let t69_k = sin_motor_theta
            .mul_add(t68_k, t68.mul_add(sin_motor_theta_k, sums_4[0]));
        let t70_k = motor_across_k * p.motor_pole_pairs;
        let t71_k = cos_motor_theta
            .mul_add(t70_k, t70.mul_add(cos_motor_theta_k, sums_4[1]));
        let t72_k = t71_k - t69_k;
        let t73_k = t72_k * t1;
        let n113_k = t2_k.mul_add(motor_i_ra_dot, sums_5[0]);
        let n114_k = t4_k.mul_add(motor_i_rb_dot, sums_5[1]);
        let n115_k = t3_k.mul_add(motor_i_ra_dot, sums_5[2]);
        let n116_k = t2_k.mul_add(motor_i_rb_dot, sums_5[3]);
        let n117_k = t2_k.mul_add(motor_i_sa_dot, sums_6[0]);
        let n118_k = t3_k.mul_add(motor_i_sb_dot, sums_6[1]);
        let n119_k = t4_k.mul_add(motor_i_sa_dot, sums_6[2]);
        let n120_k = t2_k.mul_add(motor_i_sb_dot, sums_6[3]);
        let n121_k = n113_k + n114_k;
        let t30_k_2 = t30_k - n121_k;
        let n123_k = n115_k + n116_k;
        let t38_k_2 = t38_k - n123_k;
        let n125_k = n117_k + n118_k;
        let t59_k = t57_k.mul_add(t58, -n125_k);
        let n127_k = n119_k + n120_k;
        let t67_k = t66_k.mul_add(t58, -n127_k);
        let [motor_i_sa_dot_k, motor_i_sb_dot_k, motor_i_ra_dot_k, motor_i_rb_dot_k,
        motor_omega_dot_k] = factored.solve([t30_k_2, t38_k_2, t59_k, t67_k, t73_k]);
        lanes
            .set(
                order,
                [motor_i_sa_k, motor_i_sb_k, motor_i_sa_k, motor_i_ra_k],
                [motor_i_ra_k, motor_i_rb_k, motor_i_rb_k, motor_i_sb_k],
            );
        lanes_1
            .set(
                order,
                [motor_omega_k, motor_omega_k, k * motor_theta_k, k * motor_theta_k],
                [t41_k, t47_k, cos_motor_theta_k, sin_motor_theta_k],
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
                [t19_k, t21_k, t21_k, t19_k],
            );
        lanes_3
            .set(
                order,
                [
                    cos_motor_theta_k,
                    sin_motor_theta_k,
                    cos_motor_theta_k,
                    sin_motor_theta_k,
                ],
                [t42_k, t48_k, t48_k, t42_k],
            );
        lanes_4
            .set(
                order,
                [sin_motor_theta_k, cos_motor_theta_k, t25_k, t24_k],
                [t68_k, t70_k, t34_k, t25_k],
            );
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

// Emitted by Machinist 0.1.0; do not edit. To make it again:
//
//     cargo run --release -- gen
//
// Sources, with SHA-256:
//   0a7b80ba16c86a18f99ecf8fe5cd7f2f59fdf61c6adcb99c671c96cf5a3e4e66  scenes/saw_gin_as_printed.toml
//   495ad7f7a1034ceca85b1f336cdb757e19f20ef1f884d8c24b8ad9f1dc96fd39  units/induction_motor_as_printed.toml
//   a479b553f0542fe4aecc9e2a030097bc5b34e101f44a5e7297713fb52484327b  units/coupling.toml
//   192155c0a8dc7b884c45e939d6fe1b122b135258825141b94f360d68f1612fb5  units/rotor.toml
//   c25829d257d53d2e48562bcbdac2bfe42940eb3fdb1c5913863f1432683f6420  units/technological_load.toml
//
// Saw gin with the equations and numbers as printed
//
// For the reproduction ledger: started empty and loaded later, like the consistent scene.
//
// Source:
//   Saw-gin study (2020), equations (1) and (2), as printed.
//
// Shapes; all quantities are in SI units:
//   coordinates               2
//   first-order states        4
//   states                    8
//   parameters               23
//   outputs                   5
//   discontinuities           0
//
// State:
//     0  motor.phi       [rad]    rotor angle
//     1  cylinder.phi    [rad]    angle
//     2  motor.omega     [rad/s]  rate of rotor angle
//     3  cylinder.omega  [rad/s]  rate of angle
//     4  motor.psi_x1    [V s]    stator flux linkage along x
//     5  motor.psi_y1    [V s]    stator flux linkage along y
//     6  motor.psi_x2    [V s]    rotor flux linkage along x
//     7  motor.psi_y2    [V s]    rotor flux linkage along y
//
// Nonzeros:
//   mass_matrix               2 of 2 by 2
//   rate_jacobian            30 of 8 by 8
//   parameter_jacobian       38 of 8 by 23
//
// Operations:
//   initial_state             0
//   discontinuities           0
//   rate                     86
//   mass_matrix               0
//   forcing                  42
//   rate_jacobian            78
//   parameter_jacobian      185
//   time_derivative          32
//   outputs                  43
//   energy                   12
//   power_balance            63
// With constants of the parameters, prepared once a run:
//   prepare                  42
//   prepared_rate            62
//   prepared_rate_jacobian   40

use ::machinist_contract::{
    Describe, Energy, PowerBalance, Quantity, Real, RunDefaults, Shape, Simulator,
    SparsityPattern, taylor::{Bends, Lanes, TaylorSeries, order_and_inverse},
};

/// Generalized coordinates, n.
pub const COORDINATES: usize = 2;

/// Length of the state y.
pub const STATES: usize = 8;

/// Parameters.
pub const PARAMETERS: usize = 23;

/// Wanted outputs.
pub const OUTPUTS: usize = 5;

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
        (0, 2), (1, 3), (2, 0), (2, 1), (2, 2), (2, 3), (2, 4), (2, 5), (2, 6), (2, 7), (3, 0),
        (3, 1), (3, 2), (3, 3), (4, 4), (4, 5), (4, 6), (5, 4), (5, 5), (5, 7), (6, 0), (6, 2),
        (6, 4), (6, 6), (6, 7), (7, 0), (7, 2), (7, 5), (7, 6), (7, 7),
    ],
};

/// Nonzeros of dy'/dp.
pub const PARAMETER_JACOBIAN_PATTERN: SparsityPattern<'static> = SparsityPattern {
    rows: 8,
    columns: 23,
    entries: &[
        (2, 0), (2, 3), (2, 4), (2, 6), (2, 7), (2, 8), (2, 12), (2, 13), (2, 14), (3, 12), (3, 13),
        (3, 14), (3, 15), (3, 16), (3, 17), (3, 18), (3, 19), (3, 20), (3, 21), (3, 22), (4, 1),
        (4, 2), (4, 3), (4, 6), (4, 9), (5, 1), (5, 2), (5, 3), (5, 6), (5, 9), (6, 3), (6, 5),
        (6, 10), (6, 11), (7, 3), (7, 5), (7, 10), (7, 11),
    ],
};

/// Saw gin with the equations and numbers as printed
///
/// For the reproduction ledger: started empty and loaded later, like the consistent scene.
///
/// Source: Saw-gin study (2020), equations (1) and (2), as printed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct SawGinAsPrinted;

/// Parameters, in SI units; the default holds the values of the spec.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Parameters<R> {
    /// motor.inertia: moment of inertia of the rotor \[kg m^2\]. In the spec: 4.2.
    pub motor_inertia: R,
    /// motor.u_m: printed amplitude of the phase voltage \[V\]. In the spec: 220.0.
    pub motor_u_m: R,
    /// motor.gamma: phase of the supply \[rad\]. In the spec: 0.0.
    pub motor_gamma: R,
    /// motor.omega_0: printed synchronous speed \[rad/s\]. In the spec: 78.54.
    pub motor_omega_0: R,
    /// motor.pole_pairs: pairs of poles \[1\]. In the spec: 4.0.
    pub motor_pole_pairs: R,
    /// motor.k_s: stator coupling factor \[1\]. In the spec: 0.956.
    pub motor_k_s: R,
    /// motor.k_r: rotor coupling factor \[1\]. In the spec: 0.952.
    pub motor_k_r: R,
    /// motor.sigma: printed leakage factor \[1\]. In the spec: 0.0896.
    pub motor_sigma: R,
    /// motor.x_s: stator reactance \[ohm\]. In the spec: 4.14.
    pub motor_x_s: R,
    /// motor.alpha_s: stator decay \[1\]. In the spec: 0.115.
    pub motor_alpha_s: R,
    /// motor.alpha_r: rotor decay \[1\]. In the spec: 0.0858.
    pub motor_alpha_r: R,
    /// motor.literal: 1: the rotor's angle, literally as printed; 0: its speed instead \[1\]. In the spec: 1.0.
    pub motor_literal: R,
    /// coupling.stiffness: torsional stiffness \[N m/rad\]. In the spec: 23065.2.
    pub coupling_stiffness: R,
    /// coupling.damping: torsional damping \[N m s/rad\]. In the spec: 128.5346.
    pub coupling_damping: R,
    /// coupling.ratio: turns of the driving end for one turn of the driven end \[1\]. In the spec: 1.0.
    pub coupling_ratio: R,
    /// cylinder.inertia: moment of inertia \[kg m^2\]. In the spec: 1.244.
    pub cylinder_inertia: R,
    /// load.mean: mean torque \[N m\]. In the spec: 843.72.
    pub load_mean: R,
    /// load.amplitude: amplitude of the harmonic part \[N m\]. In the spec: 78.78.
    pub load_amplitude: R,
    /// load.speed: nominal speed in revolutions per minute, a count as the study gives it \[1\]. In the spec: 735.0.
    pub load_speed: R,
    /// load.phase: phase of the harmonic part \[rad\]. In the spec: 0.0.
    pub load_phase: R,
    /// load.engagement_time: time at which half of the load acts \[s\]. In the spec: 1.2.
    pub load_engagement_time: R,
    /// load.engagement_width: time constant of engagement \[s\]. In the spec: 0.02.
    pub load_engagement_width: R,
    /// load.standstill_band: speed below which the load fades out \[rad/s\]. In the spec: 0.5.
    pub load_standstill_band: R,
}

impl<R: Real> Parameters<R> {
    /// From the numbers in their order.
    #[must_use]
    #[inline]
    pub fn from_array(values: [R; PARAMETERS]) -> Self {
        Self {
            motor_inertia: values[0],
            motor_u_m: values[1],
            motor_gamma: values[2],
            motor_omega_0: values[3],
            motor_pole_pairs: values[4],
            motor_k_s: values[5],
            motor_k_r: values[6],
            motor_sigma: values[7],
            motor_x_s: values[8],
            motor_alpha_s: values[9],
            motor_alpha_r: values[10],
            motor_literal: values[11],
            coupling_stiffness: values[12],
            coupling_damping: values[13],
            coupling_ratio: values[14],
            cylinder_inertia: values[15],
            load_mean: values[16],
            load_amplitude: values[17],
            load_speed: values[18],
            load_phase: values[19],
            load_engagement_time: values[20],
            load_engagement_width: values[21],
            load_standstill_band: values[22],
        }
    }
    /// The numbers in their order.
    #[must_use]
    #[inline]
    pub fn to_array(self) -> [R; PARAMETERS] {
        [
            self.motor_inertia,
            self.motor_u_m,
            self.motor_gamma,
            self.motor_omega_0,
            self.motor_pole_pairs,
            self.motor_k_s,
            self.motor_k_r,
            self.motor_sigma,
            self.motor_x_s,
            self.motor_alpha_s,
            self.motor_alpha_r,
            self.motor_literal,
            self.coupling_stiffness,
            self.coupling_damping,
            self.coupling_ratio,
            self.cylinder_inertia,
            self.load_mean,
            self.load_amplitude,
            self.load_speed,
            self.load_phase,
            self.load_engagement_time,
            self.load_engagement_width,
            self.load_standstill_band,
        ]
    }
}

impl<R: Real> Default for Parameters<R> {
    fn default() -> Self {
        Self {
            motor_inertia: R::literal(4.2),
            motor_u_m: R::literal(220.0),
            motor_gamma: R::literal(0.0),
            motor_omega_0: R::literal(78.54),
            motor_pole_pairs: R::literal(4.0),
            motor_k_s: R::literal(0.956),
            motor_k_r: R::literal(0.952),
            motor_sigma: R::literal(0.0896),
            motor_x_s: R::literal(4.14),
            motor_alpha_s: R::literal(0.115),
            motor_alpha_r: R::literal(0.0858),
            motor_literal: R::literal(1.0),
            coupling_stiffness: R::literal(23065.2),
            coupling_damping: R::literal(128.5346),
            coupling_ratio: R::literal(1.0),
            cylinder_inertia: R::literal(1.244),
            load_mean: R::literal(843.72),
            load_amplitude: R::literal(78.78),
            load_speed: R::literal(735.0),
            load_phase: R::literal(0.0),
            load_engagement_time: R::literal(1.2),
            load_engagement_width: R::literal(0.02),
            load_standstill_band: R::literal(0.5),
        }
    }
}

/// Wanted outputs, in SI units.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Outputs<R> {
    /// motor_speed: rate of rotor angle \[rad/s\].
    pub motor_speed: R,
    /// cylinder_speed: rate of angle \[rad/s\].
    pub cylinder_speed: R,
    /// motor_torque: driving torque \[N m\].
    pub motor_torque: R,
    /// coupling_torque: torque carried, on the driving side \[N m\].
    pub coupling_torque: R,
    /// cylinder_acceleration: rate of rate of angle \[rad/s^2\].
    pub cylinder_acceleration: R,
}

impl<R: Real> Outputs<R> {
    /// From the numbers in their order.
    #[must_use]
    #[inline]
    pub fn from_array(values: [R; OUTPUTS]) -> Self {
        Self {
            motor_speed: values[0],
            cylinder_speed: values[1],
            motor_torque: values[2],
            coupling_torque: values[3],
            cylinder_acceleration: values[4],
        }
    }
    /// The numbers in their order.
    #[must_use]
    #[inline]
    pub fn to_array(self) -> [R; OUTPUTS] {
        [
            self.motor_speed,
            self.cylinder_speed,
            self.motor_torque,
            self.coupling_torque,
            self.cylinder_acceleration,
        ]
    }
}

/// Where to find what in the state.
pub mod state {
    /// motor.phi: rotor angle \[rad\].
    pub const MOTOR_PHI: usize = 0;
    /// cylinder.phi: angle \[rad\].
    pub const CYLINDER_PHI: usize = 1;
    /// motor.omega: rate of rotor angle \[rad/s\].
    pub const MOTOR_OMEGA: usize = 2;
    /// cylinder.omega: rate of angle \[rad/s\].
    pub const CYLINDER_OMEGA: usize = 3;
    /// motor.psi_x1: stator flux linkage along x \[V s\].
    pub const MOTOR_PSI_X1: usize = 4;
    /// motor.psi_y1: stator flux linkage along y \[V s\].
    pub const MOTOR_PSI_Y1: usize = 5;
    /// motor.psi_x2: rotor flux linkage along x \[V s\].
    pub const MOTOR_PSI_X2: usize = 6;
    /// motor.psi_y2: rotor flux linkage along y \[V s\].
    pub const MOTOR_PSI_Y2: usize = 7;
}

/// Constants that `prepare` computes.
pub const CONSTANTS: usize = 27;

#[allow(missing_docs, reason = "`prepare` says what each is")]
/// What parameters alone decide; `prepare` says what each is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Constants<R> {
    pub t0: R,
    pub inverse_load_engagement_width: R,
    pub t1: R,
    pub t2: R,
    pub inverse_load_standstill_band: R,
    pub inverse_motor_inertia: R,
    pub inverse_cylinder_inertia: R,
    pub t3: R,
    pub t4: R,
    pub motor_omega_0_times_motor_alpha_s: R,
    pub t5: R,
    pub motor_u_m_times_cos_motor_gamma: R,
    pub motor_u_m_times_sin_motor_gamma: R,
    pub motor_omega_0_times_motor_alpha_r: R,
    pub t6: R,
    pub cylinder_omega_dot_by_motor_phi: R,
    pub motor_omega_dot_by_motor_phi: R,
    pub cylinder_omega_dot_by_cylinder_phi: R,
    pub motor_omega_dot_by_cylinder_phi: R,
    pub cylinder_omega_dot_by_motor_omega: R,
    pub motor_omega_dot_by_motor_omega: R,
    pub t7: R,
    pub t8: R,
    pub motor_omega_dot_by_cylinder_omega: R,
    pub motor_psi_x1_dot_by_motor_psi_x1: R,
    pub motor_psi_y1_dot_by_motor_psi_x1: R,
    pub motor_psi_x2_dot_by_motor_psi_x2: R,
}

impl<R: Real> Constants<R> {
    /// From the numbers in their order.
    #[must_use]
    #[inline]
    pub fn from_array(values: [R; CONSTANTS]) -> Self {
        Self {
            t0: values[0],
            inverse_load_engagement_width: values[1],
            t1: values[2],
            t2: values[3],
            inverse_load_standstill_band: values[4],
            inverse_motor_inertia: values[5],
            inverse_cylinder_inertia: values[6],
            t3: values[7],
            t4: values[8],
            motor_omega_0_times_motor_alpha_s: values[9],
            t5: values[10],
            motor_u_m_times_cos_motor_gamma: values[11],
            motor_u_m_times_sin_motor_gamma: values[12],
            motor_omega_0_times_motor_alpha_r: values[13],
            t6: values[14],
            cylinder_omega_dot_by_motor_phi: values[15],
            motor_omega_dot_by_motor_phi: values[16],
            cylinder_omega_dot_by_cylinder_phi: values[17],
            motor_omega_dot_by_cylinder_phi: values[18],
            cylinder_omega_dot_by_motor_omega: values[19],
            motor_omega_dot_by_motor_omega: values[20],
            t7: values[21],
            t8: values[22],
            motor_omega_dot_by_cylinder_omega: values[23],
            motor_psi_x1_dot_by_motor_psi_x1: values[24],
            motor_psi_y1_dot_by_motor_psi_x1: values[25],
            motor_psi_x2_dot_by_motor_psi_x2: values[26],
        }
    }
    /// The numbers in their order.
    #[must_use]
    #[inline]
    pub fn to_array(self) -> [R; CONSTANTS] {
        [
            self.t0,
            self.inverse_load_engagement_width,
            self.t1,
            self.t2,
            self.inverse_load_standstill_band,
            self.inverse_motor_inertia,
            self.inverse_cylinder_inertia,
            self.t3,
            self.t4,
            self.motor_omega_0_times_motor_alpha_s,
            self.t5,
            self.motor_u_m_times_cos_motor_gamma,
            self.motor_u_m_times_sin_motor_gamma,
            self.motor_omega_0_times_motor_alpha_r,
            self.t6,
            self.cylinder_omega_dot_by_motor_phi,
            self.motor_omega_dot_by_motor_phi,
            self.cylinder_omega_dot_by_cylinder_phi,
            self.motor_omega_dot_by_cylinder_phi,
            self.cylinder_omega_dot_by_motor_omega,
            self.motor_omega_dot_by_motor_omega,
            self.t7,
            self.t8,
            self.motor_omega_dot_by_cylinder_omega,
            self.motor_psi_x1_dot_by_motor_psi_x1,
            self.motor_psi_y1_dot_by_motor_psi_x1,
            self.motor_psi_x2_dot_by_motor_psi_x2,
        ]
    }
}

/// What `rate` and `rate_jacobian` need of the parameters, once a run.
///
/// 42 operations.
#[must_use]
#[inline]
pub fn prepare<R: Real>(p: &Parameters<R>) -> Constants<R> {
    let (sin_motor_gamma, cos_motor_gamma) = p.motor_gamma.sin_cos();
    let load_omega_2 = R::literal(0.104_719_755_119_659_77) * p.load_speed;
    let t0 = R::literal(1.0) - p.motor_literal;
    let inverse_load_engagement_width = R::literal(1.0) / p.load_engagement_width;
    let t1 = R::literal(1.5) * p.motor_omega_0 * p.motor_pole_pairs * p.motor_k_r
        / (p.motor_sigma * p.motor_x_s);
    let t2 = R::literal(core::f64::consts::PI) * load_omega_2;
    let inverse_load_standstill_band = R::literal(1.0) / p.load_standstill_band;
    let inverse_motor_inertia = R::literal(1.0) / p.motor_inertia;
    let inverse_cylinder_inertia = R::literal(1.0) / p.cylinder_inertia;
    let t3 = p.coupling_stiffness * p.coupling_ratio;
    let t4 = p.coupling_damping * p.coupling_ratio;
    let motor_omega_0_times_motor_alpha_s = p.motor_omega_0 * p.motor_alpha_s;
    let t5 = p.motor_omega_0 * p.motor_k_r * p.motor_alpha_s;
    let motor_u_m_times_cos_motor_gamma = p.motor_u_m * cos_motor_gamma;
    let motor_u_m_times_sin_motor_gamma = p.motor_u_m * sin_motor_gamma;
    let motor_omega_0_times_motor_alpha_r = p.motor_omega_0 * p.motor_alpha_r;
    let t6 = p.motor_omega_0 * p.motor_k_s * p.motor_alpha_r;
    let cylinder_omega_dot_by_motor_phi = t3 * inverse_cylinder_inertia;
    let motor_omega_dot_by_motor_phi = -(p.coupling_stiffness * inverse_motor_inertia);
    let coupling_ratio_squared = p.coupling_ratio * p.coupling_ratio;
    let cylinder_omega_dot_by_cylinder_phi = -(p.coupling_stiffness
        * coupling_ratio_squared * inverse_cylinder_inertia);
    let motor_omega_dot_by_cylinder_phi = t3 * inverse_motor_inertia;
    let cylinder_omega_dot_by_motor_omega = t4 * inverse_cylinder_inertia;
    let motor_omega_dot_by_motor_omega = -(p.coupling_damping * inverse_motor_inertia);
    let t7 = p.motor_literal - R::literal(1.0);
    let t8 = -(p.coupling_damping * coupling_ratio_squared);
    let motor_omega_dot_by_cylinder_omega = t4 * inverse_motor_inertia;
    let motor_psi_x1_dot_by_motor_psi_x1 = -motor_omega_0_times_motor_alpha_s;
    let motor_psi_y1_dot_by_motor_psi_x1 = -p.motor_omega_0;
    let motor_psi_x2_dot_by_motor_psi_x2 = -motor_omega_0_times_motor_alpha_r;
    Constants {
        t0,
        inverse_load_engagement_width,
        t1,
        t2,
        inverse_load_standstill_band,
        inverse_motor_inertia,
        inverse_cylinder_inertia,
        t3,
        t4,
        motor_omega_0_times_motor_alpha_s,
        t5,
        motor_u_m_times_cos_motor_gamma,
        motor_u_m_times_sin_motor_gamma,
        motor_omega_0_times_motor_alpha_r,
        t6,
        cylinder_omega_dot_by_motor_phi,
        motor_omega_dot_by_motor_phi,
        cylinder_omega_dot_by_cylinder_phi,
        motor_omega_dot_by_cylinder_phi,
        cylinder_omega_dot_by_motor_omega,
        motor_omega_dot_by_motor_omega,
        t7,
        t8,
        motor_omega_dot_by_cylinder_omega,
        motor_psi_x1_dot_by_motor_psi_x1,
        motor_psi_y1_dot_by_motor_psi_x1,
        motor_psi_x2_dot_by_motor_psi_x2,
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
/// 86 operations.
#[must_use]
#[inline]
pub fn rate<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>) -> [R; STATES] {
    prepared_rate(time, state, p, &prepare(p))
}

/// As `rate`, with the constants of the parameters from `prepare`.
///
/// 62 operations.
#[must_use]
#[inline]
pub fn prepared_rate<R: Real>(
    time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
    c: &Constants<R>,
) -> [R; STATES] {
    let [motor_phi, cylinder_phi, motor_omega, cylinder_omega, motor_psi_x1,
    motor_psi_y1, motor_psi_x2, motor_psi_y2] = *state;
    let coupling_twist = motor_phi.sub_product(p.coupling_ratio, cylinder_phi);
    let coupling_twist_rate = motor_omega.sub_product(p.coupling_ratio, cylinder_omega);
    let motor_rotor_term = (p.motor_literal * motor_phi).add_product(c.t0, motor_omega);
    let load_engagement = R::literal(1.0)
        / (R::literal(1.0)
            + (-(c.inverse_load_engagement_width * (time - p.load_engagement_time)))
                .exp());
    let coupling_torque = (p.coupling_stiffness * coupling_twist)
        .add_product(p.coupling_damping, coupling_twist_rate);
    let motor_torque = c.t1
        * (motor_psi_y1 * motor_psi_x2).sub_product(motor_psi_x1, motor_psi_y2);
    let load_resistance = load_engagement
        * p
            .load_mean
            .add_product(p.load_amplitude, p.load_phase.add_product(c.t2, time).sin())
        * (c.inverse_load_standstill_band * cylinder_omega).tanh();
    let cylinder_omega_dot = ((c.t3 * coupling_twist)
        .add_product(c.t4, coupling_twist_rate) - load_resistance)
        * c.inverse_cylinder_inertia;
    let motor_omega_dot = (motor_torque - coupling_torque) * c.inverse_motor_inertia;
    let motor_psi_x1_dot = c
        .motor_u_m_times_cos_motor_gamma
        .add_product(p.motor_omega_0, motor_psi_y1)
        .add_product(c.t5, motor_psi_x2)
        .sub_product(c.motor_omega_0_times_motor_alpha_s, motor_psi_x1);
    let motor_psi_y1_dot = c
        .motor_u_m_times_sin_motor_gamma
        .add_product(c.t5, motor_psi_y2)
        .sub_product(p.motor_omega_0, motor_psi_x1)
        .sub_product(c.motor_omega_0_times_motor_alpha_s, motor_psi_y1);
    let motor_psi_x2_dot = (c.t6 * motor_psi_x1)
        .add_product(p.motor_omega_0, motor_psi_y2)
        .sub_product(c.motor_omega_0_times_motor_alpha_r, motor_psi_x2)
        .sub_product(motor_psi_y2, motor_rotor_term);
    let motor_psi_y2_dot = (c.t6 * motor_psi_y1)
        .add_product(motor_psi_x2, motor_rotor_term)
        .sub_product(p.motor_omega_0, motor_psi_x2)
        .sub_product(c.motor_omega_0_times_motor_alpha_r, motor_psi_y2);
    [
        motor_omega,
        cylinder_omega,
        motor_omega_dot,
        cylinder_omega_dot,
        motor_psi_x1_dot,
        motor_psi_y1_dot,
        motor_psi_x2_dot,
        motor_psi_y2_dot,
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
) -> [R; 2] {
    [p.motor_inertia, p.cylinder_inertia]
}

/// `f` of `M q'' = f(q, q', z, t)`, one for each coordinate.
///
/// 42 operations.
#[must_use]
pub fn forcing<R: Real>(
    time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
) -> [R; COORDINATES] {
    let [motor_phi, cylinder_phi, motor_omega, cylinder_omega, motor_psi_x1,
    motor_psi_y1, motor_psi_x2, motor_psi_y2] = *state;
    let load_omega_2 = R::literal(0.104_719_755_119_659_77) * p.load_speed;
    let coupling_twist = motor_phi.sub_product(p.coupling_ratio, cylinder_phi);
    let coupling_twist_rate = motor_omega.sub_product(p.coupling_ratio, cylinder_omega);
    let load_engagement = R::literal(1.0)
        / (R::literal(1.0)
            + (-(R::literal(1.0) / p.load_engagement_width
                * (time - p.load_engagement_time)))
                .exp());
    let coupling_torque = (p.coupling_stiffness * coupling_twist)
        .add_product(p.coupling_damping, coupling_twist_rate);
    let motor_torque = R::literal(1.5) * p.motor_omega_0 * p.motor_pole_pairs
        * p.motor_k_r / (p.motor_sigma * p.motor_x_s)
        * (motor_psi_y1 * motor_psi_x2).sub_product(motor_psi_x1, motor_psi_y2);
    let load_resistance = load_engagement
        * p
            .load_mean
            .add_product(
                p.load_amplitude,
                p
                    .load_phase
                    .add_product(R::literal(core::f64::consts::PI) * load_omega_2, time)
                    .sin(),
            ) * (R::literal(1.0) / p.load_standstill_band * cylinder_omega).tanh();
    let motor_phi_forcing = motor_torque - coupling_torque;
    let cylinder_phi_forcing = (p.coupling_stiffness * p.coupling_ratio * coupling_twist)
        .add_product(p.coupling_damping * p.coupling_ratio, coupling_twist_rate)
        - load_resistance;
    [motor_phi_forcing, cylinder_phi_forcing]
}

/// `dy'/dy`, values in the order of `RATE_JACOBIAN_PATTERN`.
///
/// 78 operations.
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
/// 40 operations.
#[must_use]
pub fn prepared_rate_jacobian<R: Real>(
    time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
    c: &Constants<R>,
) -> [R; 30] {
    let [motor_phi, _, motor_omega, cylinder_omega, motor_psi_x1, motor_psi_y1,
    motor_psi_x2, motor_psi_y2] = *state;
    let motor_rotor_term = (p.motor_literal * motor_phi).add_product(c.t0, motor_omega);
    let load_engagement = R::literal(1.0)
        / (R::literal(1.0)
            + (-(c.inverse_load_engagement_width * (time - p.load_engagement_time)))
                .exp());
    let t0 = (c.inverse_load_standstill_band * cylinder_omega).tanh();
    let motor_psi_x2_dot_by_motor_phi = -(p.motor_literal * motor_psi_y2);
    let motor_psi_y2_dot_by_motor_phi = p.motor_literal * motor_psi_x2;
    let motor_psi_x2_dot_by_motor_omega = c.t7 * motor_psi_y2;
    let motor_psi_y2_dot_by_motor_omega = c.t0 * motor_psi_x2;
    let cylinder_omega_dot_by_cylinder_omega = c
        .t8
        .sub_product(
            c.inverse_load_standstill_band * load_engagement
                * R::literal(1.0).sub_product(t0, t0),
            p
                .load_mean
                .add_product(
                    p.load_amplitude,
                    p.load_phase.add_product(c.t2, time).sin(),
                ),
        ) * c.inverse_cylinder_inertia;
    let motor_omega_dot_by_motor_psi_x1 = -(c.t1 * motor_psi_y2
        * c.inverse_motor_inertia);
    let motor_omega_dot_by_motor_psi_y1 = c.t1 * motor_psi_x2 * c.inverse_motor_inertia;
    let motor_omega_dot_by_motor_psi_x2 = c.t1 * motor_psi_y1 * c.inverse_motor_inertia;
    let motor_psi_y2_dot_by_motor_psi_x2 = motor_rotor_term - p.motor_omega_0;
    let motor_omega_dot_by_motor_psi_y2 = -(c.t1 * motor_psi_x1
        * c.inverse_motor_inertia);
    let motor_psi_x2_dot_by_motor_psi_y2 = p.motor_omega_0 - motor_rotor_term;
    [
        R::literal(1.0),
        R::literal(1.0),
        c.motor_omega_dot_by_motor_phi,
        c.motor_omega_dot_by_cylinder_phi,
        c.motor_omega_dot_by_motor_omega,
        c.motor_omega_dot_by_cylinder_omega,
        motor_omega_dot_by_motor_psi_x1,
        motor_omega_dot_by_motor_psi_y1,
        motor_omega_dot_by_motor_psi_x2,
        motor_omega_dot_by_motor_psi_y2,
        c.cylinder_omega_dot_by_motor_phi,
        c.cylinder_omega_dot_by_cylinder_phi,
        c.cylinder_omega_dot_by_motor_omega,
        cylinder_omega_dot_by_cylinder_omega,
        c.motor_psi_x1_dot_by_motor_psi_x1,
        p.motor_omega_0,
        c.t5,
        c.motor_psi_y1_dot_by_motor_psi_x1,
        c.motor_psi_x1_dot_by_motor_psi_x1,
        c.t5,
        motor_psi_x2_dot_by_motor_phi,
        motor_psi_x2_dot_by_motor_omega,
        c.t6,
        c.motor_psi_x2_dot_by_motor_psi_x2,
        motor_psi_x2_dot_by_motor_psi_y2,
        motor_psi_y2_dot_by_motor_phi,
        motor_psi_y2_dot_by_motor_omega,
        c.t6,
        motor_psi_y2_dot_by_motor_psi_x2,
        c.motor_psi_x2_dot_by_motor_psi_x2,
    ]
}

/// `dy'/dp`, values in the order of `PARAMETER_JACOBIAN_PATTERN`.
///
/// 185 operations.
#[must_use]
pub fn parameter_jacobian<R: Real>(
    time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
) -> [R; 38] {
    let [motor_phi, cylinder_phi, motor_omega, cylinder_omega, motor_psi_x1,
    motor_psi_y1, motor_psi_x2, motor_psi_y2] = *state;
    let load_omega_2 = R::literal(0.104_719_755_119_659_77) * p.load_speed;
    let t0 = p
        .load_phase
        .add_product(R::literal(core::f64::consts::PI) * load_omega_2, time);
    let [(t1, t2), (sin_motor_gamma, cos_motor_gamma)] = R::sin_cos_each([
        t0,
        p.motor_gamma,
    ]);
    let coupling_ratio_times_cylinder_phi = p.coupling_ratio * cylinder_phi;
    let coupling_twist = motor_phi - coupling_ratio_times_cylinder_phi;
    let coupling_ratio_times_cylinder_omega = p.coupling_ratio * cylinder_omega;
    let coupling_twist_rate = motor_omega - coupling_ratio_times_cylinder_omega;
    let time_minus_load_engagement_time = time - p.load_engagement_time;
    let inverse_load_engagement_width = R::literal(1.0) / p.load_engagement_width;
    let t3 = (-(inverse_load_engagement_width * time_minus_load_engagement_time)).exp();
    let t4 = R::literal(1.0) + t3;
    let load_engagement = R::literal(1.0) / t4;
    let coupling_torque = (p.coupling_stiffness * coupling_twist)
        .add_product(p.coupling_damping, coupling_twist_rate);
    let motor_psi_x1_times_motor_psi_y2 = motor_psi_x1 * motor_psi_y2;
    let motor_psi_y1_times_motor_psi_x2 = motor_psi_y1 * motor_psi_x2;
    let t5 = motor_psi_y1_times_motor_psi_x2 - motor_psi_x1_times_motor_psi_y2;
    let t6 = R::literal(1.5) * p.motor_omega_0;
    let t7 = t6 * p.motor_pole_pairs;
    let t8 = t7 * p.motor_k_r;
    let motor_sigma_times_motor_x_s = p.motor_sigma * p.motor_x_s;
    let motor_torque = t8 / motor_sigma_times_motor_x_s * t5;
    let t9 = p.load_mean.add_product(p.load_amplitude, t1);
    let t10 = (R::literal(1.0) / p.load_standstill_band * cylinder_omega).tanh();
    let load_resistance = load_engagement * t9 * t10;
    let inverse_motor_inertia = R::literal(1.0) / p.motor_inertia;
    let inverse_cylinder_inertia = R::literal(1.0) / p.cylinder_inertia;
    let cylinder_omega_dot = ((p.coupling_stiffness * p.coupling_ratio * coupling_twist)
        .add_product(p.coupling_damping * p.coupling_ratio, coupling_twist_rate)
        - load_resistance) * inverse_cylinder_inertia;
    let motor_omega_dot = (motor_torque - coupling_torque) * inverse_motor_inertia;
    let motor_omega_0_times_motor_alpha_s = p.motor_omega_0 * p.motor_alpha_s;
    let motor_psi_y1_dot_by_motor_gamma = p.motor_u_m * cos_motor_gamma;
    let motor_omega_0_times_motor_alpha_r = p.motor_omega_0 * p.motor_alpha_r;
    let motor_omega_dot_by_motor_inertia = -(motor_omega_dot * inverse_motor_inertia);
    let motor_psi_x1_dot_by_motor_gamma = -(p.motor_u_m * sin_motor_gamma);
    let motor_omega_dot_by_motor_omega_0 = R::literal(1.5) * p.motor_pole_pairs
        * p.motor_k_r / motor_sigma_times_motor_x_s * t5 * inverse_motor_inertia;
    let motor_k_r_times_motor_alpha_s = p.motor_k_r * p.motor_alpha_s;
    let motor_psi_x1_dot_by_motor_omega_0 = motor_psi_y1
        .add_product(motor_k_r_times_motor_alpha_s, motor_psi_x2)
        .sub_product(p.motor_alpha_s, motor_psi_x1);
    let motor_psi_y1_dot_by_motor_omega_0 = (-motor_psi_x1)
        .add_product(motor_k_r_times_motor_alpha_s, motor_psi_y2)
        .sub_product(p.motor_alpha_s, motor_psi_y1);
    let motor_k_s_times_motor_alpha_r = p.motor_k_s * p.motor_alpha_r;
    let motor_psi_x2_dot_by_motor_omega_0 = motor_psi_y2
        .add_product(motor_k_s_times_motor_alpha_r, motor_psi_x1)
        .sub_product(p.motor_alpha_r, motor_psi_x2);
    let motor_psi_y2_dot_by_motor_omega_0 = (-motor_psi_x2)
        .add_product(motor_k_s_times_motor_alpha_r, motor_psi_y1)
        .sub_product(p.motor_alpha_r, motor_psi_y2);
    let motor_omega_dot_by_motor_pole_pairs = t6 * p.motor_k_r
        / motor_sigma_times_motor_x_s * t5 * inverse_motor_inertia;
    let motor_psi_x2_dot_by_motor_k_s = motor_omega_0_times_motor_alpha_r * motor_psi_x1;
    let motor_psi_y2_dot_by_motor_k_s = motor_omega_0_times_motor_alpha_r * motor_psi_y1;
    let motor_omega_dot_by_motor_k_r = t7 / motor_sigma_times_motor_x_s * t5
        * inverse_motor_inertia;
    let motor_psi_x1_dot_by_motor_k_r = motor_omega_0_times_motor_alpha_s * motor_psi_x2;
    let motor_psi_y1_dot_by_motor_k_r = motor_omega_0_times_motor_alpha_s * motor_psi_y2;
    let t11 = motor_psi_x1_times_motor_psi_y2 - motor_psi_y1_times_motor_psi_x2;
    let motor_omega_dot_by_motor_sigma = t8
        / (p.motor_sigma * p.motor_sigma * p.motor_x_s) * t11 * inverse_motor_inertia;
    let motor_omega_dot_by_motor_x_s = t8 / (p.motor_sigma * (p.motor_x_s * p.motor_x_s))
        * t11 * inverse_motor_inertia;
    let motor_psi_x1_dot_by_motor_alpha_s = p.motor_omega_0
        * (-motor_psi_x1).add_product(p.motor_k_r, motor_psi_x2);
    let motor_psi_y1_dot_by_motor_alpha_s = p.motor_omega_0
        * (-motor_psi_y1).add_product(p.motor_k_r, motor_psi_y2);
    let motor_psi_x2_dot_by_motor_alpha_r = p.motor_omega_0
        * (-motor_psi_x2).add_product(p.motor_k_s, motor_psi_x1);
    let motor_psi_y2_dot_by_motor_alpha_r = p.motor_omega_0
        * (-motor_psi_y2).add_product(p.motor_k_s, motor_psi_y1);
    let motor_psi_x2_dot_by_motor_literal = motor_psi_y2 * (motor_omega - motor_phi);
    let motor_psi_y2_dot_by_motor_literal = motor_psi_x2 * (motor_phi - motor_omega);
    let cylinder_omega_dot_by_coupling_stiffness = p.coupling_ratio * coupling_twist
        * inverse_cylinder_inertia;
    let motor_omega_dot_by_coupling_stiffness = (coupling_ratio_times_cylinder_phi
        - motor_phi) * inverse_motor_inertia;
    let cylinder_omega_dot_by_coupling_damping = p.coupling_ratio * coupling_twist_rate
        * inverse_cylinder_inertia;
    let motor_omega_dot_by_coupling_damping = (coupling_ratio_times_cylinder_omega
        - motor_omega) * inverse_motor_inertia;
    let cylinder_omega_dot_by_coupling_ratio = (p.coupling_stiffness * motor_phi)
        .add_product(p.coupling_damping, motor_omega)
        .sub_product(
            R::literal(2.0) * p.coupling_stiffness * p.coupling_ratio,
            cylinder_phi,
        )
        .sub_product(
            R::literal(2.0) * p.coupling_damping * p.coupling_ratio,
            cylinder_omega,
        ) * inverse_cylinder_inertia;
    let motor_omega_dot_by_coupling_ratio = (p.coupling_stiffness * cylinder_phi)
        .add_product(p.coupling_damping, cylinder_omega) * inverse_motor_inertia;
    let cylinder_omega_dot_by_cylinder_inertia = -(cylinder_omega_dot
        * inverse_cylinder_inertia);
    let cylinder_omega_dot_by_load_mean = -(load_engagement * t10
        * inverse_cylinder_inertia);
    let cylinder_omega_dot_by_load_amplitude = -(load_engagement * t1 * t10
        * inverse_cylinder_inertia);
    let cylinder_omega_dot_by_load_speed = -(R::literal(0.328_986_813_369_645_25)
        * p.load_amplitude * time * load_engagement * t2 * t10
        * inverse_cylinder_inertia);
    let cylinder_omega_dot_by_load_phase = -(p.load_amplitude * load_engagement * t2
        * t10 * inverse_cylinder_inertia);
    let t12 = t4 * t4;
    let cylinder_omega_dot_by_load_engagement_time = inverse_load_engagement_width * t9
        * t3 * t10 / t12 * inverse_cylinder_inertia;
    let cylinder_omega_dot_by_load_engagement_width = R::literal(1.0)
        / (p.load_engagement_width * p.load_engagement_width)
        * time_minus_load_engagement_time * t9 * t3 * t10 / t12
        * inverse_cylinder_inertia;
    let cylinder_omega_dot_by_load_standstill_band = R::literal(1.0)
        / (p.load_standstill_band * p.load_standstill_band) * cylinder_omega
        * load_engagement * R::literal(1.0).sub_product(t10, t10) * t9
        * inverse_cylinder_inertia;
    [
        motor_omega_dot_by_motor_inertia,
        motor_omega_dot_by_motor_omega_0,
        motor_omega_dot_by_motor_pole_pairs,
        motor_omega_dot_by_motor_k_r,
        motor_omega_dot_by_motor_sigma,
        motor_omega_dot_by_motor_x_s,
        motor_omega_dot_by_coupling_stiffness,
        motor_omega_dot_by_coupling_damping,
        motor_omega_dot_by_coupling_ratio,
        cylinder_omega_dot_by_coupling_stiffness,
        cylinder_omega_dot_by_coupling_damping,
        cylinder_omega_dot_by_coupling_ratio,
        cylinder_omega_dot_by_cylinder_inertia,
        cylinder_omega_dot_by_load_mean,
        cylinder_omega_dot_by_load_amplitude,
        cylinder_omega_dot_by_load_speed,
        cylinder_omega_dot_by_load_phase,
        cylinder_omega_dot_by_load_engagement_time,
        cylinder_omega_dot_by_load_engagement_width,
        cylinder_omega_dot_by_load_standstill_band,
        cos_motor_gamma,
        motor_psi_x1_dot_by_motor_gamma,
        motor_psi_x1_dot_by_motor_omega_0,
        motor_psi_x1_dot_by_motor_k_r,
        motor_psi_x1_dot_by_motor_alpha_s,
        sin_motor_gamma,
        motor_psi_y1_dot_by_motor_gamma,
        motor_psi_y1_dot_by_motor_omega_0,
        motor_psi_y1_dot_by_motor_k_r,
        motor_psi_y1_dot_by_motor_alpha_s,
        motor_psi_x2_dot_by_motor_omega_0,
        motor_psi_x2_dot_by_motor_k_s,
        motor_psi_x2_dot_by_motor_alpha_r,
        motor_psi_x2_dot_by_motor_literal,
        motor_psi_y2_dot_by_motor_omega_0,
        motor_psi_y2_dot_by_motor_k_s,
        motor_psi_y2_dot_by_motor_alpha_r,
        motor_psi_y2_dot_by_motor_literal,
    ]
}

/// Partial derivative of `y'` with respect to time.
///
/// 32 operations.
#[must_use]
pub fn time_derivative<R: Real>(
    time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
) -> [R; STATES] {
    let [_, _, _, cylinder_omega, ..] = *state;
    let load_omega_2 = R::literal(0.104_719_755_119_659_77) * p.load_speed;
    let t0 = p
        .load_phase
        .add_product(R::literal(core::f64::consts::PI) * load_omega_2, time);
    let (t1, t2) = t0.sin_cos();
    let inverse_load_engagement_width = R::literal(1.0) / p.load_engagement_width;
    let t3 = (-(inverse_load_engagement_width * (time - p.load_engagement_time))).exp();
    let t4 = R::literal(1.0) + t3;
    let load_engagement = R::literal(1.0) / t4;
    let t5 = (R::literal(1.0) / p.load_standstill_band * cylinder_omega).tanh();
    let cylinder_omega_dot_by_time = (-(inverse_load_engagement_width
        * p.load_mean.add_product(p.load_amplitude, t1) * t3 * t5 / (t4 * t4)))
        .sub_product(
            R::literal(core::f64::consts::PI) * p.load_amplitude * load_omega_2
                * load_engagement * t2,
            t5,
        ) * (R::literal(1.0) / p.cylinder_inertia);
    [
        R::literal(0.0),
        R::literal(0.0),
        R::literal(0.0),
        cylinder_omega_dot_by_time,
        R::literal(0.0),
        R::literal(0.0),
        R::literal(0.0),
        R::literal(0.0),
    ]
}

/// Wanted outputs.
///
/// 43 operations.
#[must_use]
pub fn outputs<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>) -> Outputs<R> {
    let [motor_phi, cylinder_phi, motor_omega, cylinder_omega, motor_psi_x1,
    motor_psi_y1, motor_psi_x2, motor_psi_y2] = *state;
    let load_omega_2 = R::literal(0.104_719_755_119_659_77) * p.load_speed;
    let coupling_twist = motor_phi.sub_product(p.coupling_ratio, cylinder_phi);
    let coupling_twist_rate = motor_omega.sub_product(p.coupling_ratio, cylinder_omega);
    let load_engagement = R::literal(1.0)
        / (R::literal(1.0)
            + (-(R::literal(1.0) / p.load_engagement_width
                * (time - p.load_engagement_time)))
                .exp());
    let coupling_torque = (p.coupling_stiffness * coupling_twist)
        .add_product(p.coupling_damping, coupling_twist_rate);
    let motor_torque = R::literal(1.5) * p.motor_omega_0 * p.motor_pole_pairs
        * p.motor_k_r / (p.motor_sigma * p.motor_x_s)
        * (motor_psi_y1 * motor_psi_x2).sub_product(motor_psi_x1, motor_psi_y2);
    let load_resistance = load_engagement
        * p
            .load_mean
            .add_product(
                p.load_amplitude,
                p
                    .load_phase
                    .add_product(R::literal(core::f64::consts::PI) * load_omega_2, time)
                    .sin(),
            ) * (R::literal(1.0) / p.load_standstill_band * cylinder_omega).tanh();
    let cylinder_omega_dot = ((p.coupling_stiffness * p.coupling_ratio * coupling_twist)
        .add_product(p.coupling_damping * p.coupling_ratio, coupling_twist_rate)
        - load_resistance) * (R::literal(1.0) / p.cylinder_inertia);
    Outputs {
        motor_speed: motor_omega,
        cylinder_speed: cylinder_omega,
        motor_torque,
        coupling_torque,
        cylinder_acceleration: cylinder_omega_dot,
    }
}

/// T, V and the energy of first-order states \[J\].
///
/// 12 operations.
#[must_use]
pub fn energy<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>) -> Energy<R> {
    let [motor_phi, cylinder_phi, motor_omega, cylinder_omega, ..] = *state;
    let coupling_twist = motor_phi.sub_product(p.coupling_ratio, cylinder_phi);
    Energy {
        kinetic: (R::literal(0.5) * p.motor_inertia * (motor_omega * motor_omega))
            .add_product(
                R::literal(0.5) * p.cylinder_inertia,
                cylinder_omega * cylinder_omega,
            ),
        potential: R::literal(0.5) * p.coupling_stiffness
            * (coupling_twist * coupling_twist),
        stored: R::literal(0.0),
    }
}

/// `dE/dt`, power supplied and power dissipated \[W\].
///
/// 63 operations.
#[must_use]
pub fn power_balance<R: Real>(
    time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
) -> PowerBalance<R> {
    let [motor_phi, cylinder_phi, motor_omega, cylinder_omega, motor_psi_x1,
    motor_psi_y1, motor_psi_x2, motor_psi_y2] = *state;
    let load_omega_2 = R::literal(0.104_719_755_119_659_77) * p.load_speed;
    let coupling_twist = motor_phi.sub_product(p.coupling_ratio, cylinder_phi);
    let coupling_twist_rate = motor_omega.sub_product(p.coupling_ratio, cylinder_omega);
    let load_engagement = R::literal(1.0)
        / (R::literal(1.0)
            + (-(R::literal(1.0) / p.load_engagement_width
                * (time - p.load_engagement_time)))
                .exp());
    let t0 = p.coupling_stiffness * coupling_twist;
    let coupling_torque = t0.add_product(p.coupling_damping, coupling_twist_rate);
    let motor_torque = R::literal(1.5) * p.motor_omega_0 * p.motor_pole_pairs
        * p.motor_k_r / (p.motor_sigma * p.motor_x_s)
        * (motor_psi_y1 * motor_psi_x2).sub_product(motor_psi_x1, motor_psi_y2);
    let load_resistance = load_engagement
        * p
            .load_mean
            .add_product(
                p.load_amplitude,
                p
                    .load_phase
                    .add_product(R::literal(core::f64::consts::PI) * load_omega_2, time)
                    .sin(),
            ) * (R::literal(1.0) / p.load_standstill_band * cylinder_omega).tanh();
    let t1 = p.coupling_stiffness * p.coupling_ratio * coupling_twist;
    let t2 = p.coupling_damping * p.coupling_ratio;
    let cylinder_omega_dot = (t1.add_product(t2, coupling_twist_rate) - load_resistance)
        * (R::literal(1.0) / p.cylinder_inertia);
    let motor_omega_dot = (motor_torque - coupling_torque)
        * (R::literal(1.0) / p.motor_inertia);
    PowerBalance {
        stored_rate: (t0 * motor_omega)
            .sub_product(t1, cylinder_omega)
            .add_product(p.motor_inertia * motor_omega, motor_omega_dot)
            .add_product(p.cylinder_inertia * cylinder_omega, cylinder_omega_dot),
        supplied: (motor_omega * motor_torque)
            .sub_product(cylinder_omega, load_resistance),
        dissipated: (p.coupling_damping * motor_omega * coupling_twist_rate)
            .sub_product(t2 * cylinder_omega, coupling_twist_rate),
    }
}

/// Normalized Taylor coefficients of the solution through `state`, order after order.
///
/// `_k` marks the coefficient of order k, `_before` that of order k - 1; bare names are
/// zeroth coefficients. The workspace is as `series_workspace` says.
///
/// 125 recurrences. 9 sums of products an order.
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
    let [motor_phi, cylinder_phi, motor_omega, cylinder_omega, motor_psi_x1,
    motor_psi_y1, motor_psi_x2, motor_psi_y2] = *state;
    let load_omega_2 = R::literal(0.104_719_755_119_659_77) * p.load_speed;
    let t0 = cylinder_phi * p.coupling_ratio;
    let coupling_twist = motor_phi - t0;
    let t1 = cylinder_omega * p.coupling_ratio;
    let coupling_twist_rate = motor_omega - t1;
    let t2 = motor_phi * p.motor_literal;
    let t3 = R::literal(1.0) - p.motor_literal;
    let t4 = motor_omega * t3;
    let motor_rotor_term = t2 + t4;
    let t5 = time - p.load_engagement_time;
    let t6 = R::literal(1.0) / p.load_engagement_width;
    let t7 = t5 * t6;
    let t8 = -t7;
    let t9 = t8.exp();
    let t10 = R::literal(1.0) + t9;
    let load_engagement = R::literal(1.0) / t10;
    let t11 = coupling_twist * p.coupling_stiffness;
    let t12 = coupling_twist_rate * p.coupling_damping;
    let coupling_torque = t11 + t12;
    let t13 = motor_psi_x1 * motor_psi_y2;
    let t14 = motor_psi_y1 * motor_psi_x2;
    let t15 = t14 - t13;
    let t16 = R::literal(1.5) * p.motor_omega_0;
    let t17 = t16 * p.motor_pole_pairs;
    let t18 = t17 * p.motor_k_r;
    let t19 = p.motor_sigma * p.motor_x_s;
    let t20 = t18 / t19;
    let motor_torque = t15 * t20;
    let t21 = R::literal(core::f64::consts::PI) * load_omega_2;
    let t22 = time * t21;
    let t23 = p.load_phase + t22;
    let t24 = t23.sin();
    let t25 = t23.cos();
    let t26 = t24 * p.load_amplitude;
    let t27 = p.load_mean + t26;
    let t28 = R::literal(1.0) / p.load_standstill_band;
    let t29 = cylinder_omega * t28;
    let t30 = t29.tanh();
    let t31 = t30 * t30;
    let t32 = R::literal(1.0) - t31;
    let t33 = load_engagement * t27;
    let load_resistance = t33 * t30;
    let t34 = R::literal(1.0) / p.motor_inertia;
    let t35 = R::literal(1.0) / p.cylinder_inertia;
    let t36 = motor_torque - coupling_torque;
    let t37 = p.coupling_stiffness * p.coupling_ratio;
    let t38 = coupling_twist * t37;
    let t39 = p.coupling_damping * p.coupling_ratio;
    let t40 = coupling_twist_rate * t39;
    let t41 = t38 + t40;
    let t42 = t41 - load_resistance;
    let cylinder_omega_dot = t42 * t35;
    let motor_omega_dot = t36 * t34;
    let t43 = p.motor_omega_0 * p.motor_alpha_s;
    let t44 = motor_psi_x1 * t43;
    let t45 = motor_psi_y1 * p.motor_omega_0;
    let t46 = p.motor_omega_0 * p.motor_k_r;
    let t47 = t46 * p.motor_alpha_s;
    let t48 = motor_psi_x2 * t47;
    let t49 = p.motor_gamma.cos();
    let t50 = p.motor_u_m * t49;
    let t51 = t50 + t45;
    let t52 = t51 + t48;
    let motor_psi_x1_dot = t52 - t44;
    let t53 = motor_psi_x1 * p.motor_omega_0;
    let t54 = motor_psi_y1 * t43;
    let t55 = motor_psi_y2 * t47;
    let t56 = p.motor_gamma.sin();
    let t57 = p.motor_u_m * t56;
    let t58 = t57 + t55;
    let t59 = t58 - t53;
    let motor_psi_y1_dot = t59 - t54;
    let t60 = p.motor_omega_0 * p.motor_alpha_r;
    let t61 = motor_psi_x2 * t60;
    let t62 = motor_psi_y2 * motor_rotor_term;
    let t63 = p.motor_omega_0 * p.motor_k_s;
    let t64 = t63 * p.motor_alpha_r;
    let t65 = motor_psi_x1 * t64;
    let t66 = motor_psi_y2 * p.motor_omega_0;
    let t67 = t65 + t66;
    let t68 = t67 - t61;
    let motor_psi_x2_dot = t68 - t62;
    let t69 = motor_psi_x2 * p.motor_omega_0;
    let t70 = motor_psi_y2 * t60;
    let t71 = motor_psi_y1 * t64;
    let t72 = motor_psi_x2 * motor_rotor_term;
    let t73 = t71 + t72;
    let t74 = t73 - t69;
    let motor_psi_y2_dot = t74 - t70;
    let t7_slope = R::literal(1.0) * t6;
    let t8_slope = -t7_slope;
    let inverse_t10 = R::literal(1.0) / t10;
    let mut t9_before = t9;
    let mut t24_before = t24;
    let mut t25_before = t25;
    let mut rates = [
        motor_omega,
        cylinder_omega,
        motor_omega_dot,
        cylinder_omega_dot,
        motor_psi_x1_dot,
        motor_psi_y1_dot,
        motor_psi_x2_dot,
        motor_psi_y2_dot,
    ];
    coefficients[0] = *state;
    let highest = coefficients.len() - 1;
    for (order, state_k) in coefficients.iter_mut().enumerate().skip(1) {
        let (k, inverse) = order_and_inverse::<R>(order);
        *state_k = rates.map(|rate| rate * inverse);
        if order == highest {
            break;
        }
        let [motor_phi_k, cylinder_phi_k, motor_omega_k, cylinder_omega_k,
        motor_psi_x1_k, motor_psi_y1_k, motor_psi_x2_k, motor_psi_y2_k] = *state_k;
        let sums = lanes.sums(order);
        let sums_1 = lanes_1.sums(order);
        let sums_2 = lanes_2.sums(order);
        let coupling_twist_k = (-cylinder_phi_k).mul_add(p.coupling_ratio, motor_phi_k);
        let coupling_twist_rate_k = (-cylinder_omega_k)
            .mul_add(p.coupling_ratio, motor_omega_k);
        let motor_rotor_term_k = motor_omega_k
            .mul_add(t3, motor_phi_k * p.motor_literal);
        let t9_k = inverse * t8_slope * t9_before;
        let load_engagement_k = -t9_k.mul_add(load_engagement, sums_1[1]) * inverse_t10;
        let coupling_torque_k = coupling_twist_rate_k
            .mul_add(p.coupling_damping, coupling_twist_k * p.coupling_stiffness);
        let t13_k = motor_psi_x1
            .mul_add(motor_psi_y2_k, motor_psi_y2.mul_add(motor_psi_x1_k, sums[0]));
        let t14_k = motor_psi_y1
            .mul_add(motor_psi_x2_k, motor_psi_x2.mul_add(motor_psi_y1_k, sums[1]));
        let t15_k = t14_k - t13_k;
        let t24_k = inverse * t21 * t25_before;
        let t25_k = -inverse * t21 * t24_before;
        let t29_k = cylinder_omega_k * t28;
        let t30_k = t29_k.mul_add(t32, inverse * sums_1[3]);
        let t31_k = (t30 + t30).mul_add(t30_k, sums[2]);
        let t32_k = -t31_k;
        let t33_k = load_engagement
            .mul_add(
                t24_k * p.load_amplitude,
                t27.mul_add(load_engagement_k, sums_1[2]),
            );
        let load_resistance_k = t30.mul_add(t33_k, t33.mul_add(t30_k, sums_2[0]));
        let t36_k = t15_k.mul_add(t20, -coupling_torque_k);
        let t41_k = coupling_twist_rate_k.mul_add(t39, coupling_twist_k * t37);
        let t42_k = t41_k - load_resistance_k;
        let cylinder_omega_dot_k = t42_k * t35;
        let motor_omega_dot_k = t36_k * t34;
        let t52_k = motor_psi_x2_k.mul_add(t47, motor_psi_y1_k * p.motor_omega_0);
        let motor_psi_x1_dot_k = (-motor_psi_x1_k).mul_add(t43, t52_k);
        let t59_k = (-motor_psi_x1_k).mul_add(p.motor_omega_0, motor_psi_y2_k * t47);
        let motor_psi_y1_dot_k = (-motor_psi_y1_k).mul_add(t43, t59_k);
        let t62_k = motor_psi_y2
            .mul_add(
                motor_rotor_term_k,
                motor_rotor_term.mul_add(motor_psi_y2_k, sums[3]),
            );
        let t67_k = motor_psi_y2_k.mul_add(p.motor_omega_0, motor_psi_x1_k * t64);
        let t68_k = (-motor_psi_x2_k).mul_add(t60, t67_k);
        let motor_psi_x2_dot_k = t68_k - t62_k;
        let t72_k = motor_psi_x2
            .mul_add(
                motor_rotor_term_k,
                motor_rotor_term.mul_add(motor_psi_x2_k, sums_1[0]),
            );
        let t73_k = motor_psi_y1_k.mul_add(t64, t72_k);
        let t74_k = (-motor_psi_x2_k).mul_add(p.motor_omega_0, t73_k);
        let motor_psi_y2_dot_k = (-motor_psi_y2_k).mul_add(t60, t74_k);
        lanes
            .set(
                order,
                [motor_psi_x1_k, motor_psi_y1_k, t30_k, motor_rotor_term_k],
                [motor_psi_y2_k, motor_psi_x2_k, t30_k, motor_psi_y2_k],
            );
        lanes_1
            .set(
                order,
                [motor_rotor_term_k, t9_k, load_engagement_k, k * t29_k],
                [motor_psi_x2_k, load_engagement_k, t24_k * p.load_amplitude, t32_k],
            );
        lanes_2.set(order, [t30_k], [t33_k]);
        t9_before = t9_k;
        t24_before = t24_k;
        t25_before = t25_k;
        rates = [
            motor_omega_k,
            cylinder_omega_k,
            motor_omega_dot_k,
            cylinder_omega_dot_k,
            motor_psi_x1_dot_k,
            motor_psi_y1_dot_k,
            motor_psi_x2_dot_k,
            motor_psi_y2_dot_k,
        ];
    }
}

impl<R: Real> TaylorSeries<R> for SawGinAsPrinted {
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

impl Describe for SawGinAsPrinted {
    fn name(&self) -> &'static str {
        "saw_gin_as_printed"
    }
    fn title(&self) -> &'static str {
        "Saw gin with the equations and numbers as printed"
    }
    fn shape(&self) -> Shape {
        Shape {
            coordinates: COORDINATES,
            positions: 2,
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

impl<R: Real> Simulator<R> for SawGinAsPrinted {
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

static STATE_QUANTITIES: [Quantity<'static>; STATES] = [
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
        name: "motor.psi_x1",
        unit: "V s",
        doc: "stator flux linkage along x",
    },
    Quantity {
        name: "motor.psi_y1",
        unit: "V s",
        doc: "stator flux linkage along y",
    },
    Quantity {
        name: "motor.psi_x2",
        unit: "V s",
        doc: "rotor flux linkage along x",
    },
    Quantity {
        name: "motor.psi_y2",
        unit: "V s",
        doc: "rotor flux linkage along y",
    },
];

static STATE_SCALES: [f64; STATES] = [150.0, 150.0, 78.5, 78.5, 1.0, 1.0, 1.0, 1.0];

static PARAMETER_QUANTITIES: [Quantity<'static>; PARAMETERS] = [
    Quantity {
        name: "motor.inertia",
        unit: "kg m^2",
        doc: "moment of inertia of the rotor",
    },
    Quantity {
        name: "motor.u_m",
        unit: "V",
        doc: "printed amplitude of the phase voltage",
    },
    Quantity {
        name: "motor.gamma",
        unit: "rad",
        doc: "phase of the supply",
    },
    Quantity {
        name: "motor.omega_0",
        unit: "rad/s",
        doc: "printed synchronous speed",
    },
    Quantity {
        name: "motor.pole_pairs",
        unit: "1",
        doc: "pairs of poles",
    },
    Quantity {
        name: "motor.k_s",
        unit: "1",
        doc: "stator coupling factor",
    },
    Quantity {
        name: "motor.k_r",
        unit: "1",
        doc: "rotor coupling factor",
    },
    Quantity {
        name: "motor.sigma",
        unit: "1",
        doc: "printed leakage factor",
    },
    Quantity {
        name: "motor.x_s",
        unit: "ohm",
        doc: "stator reactance",
    },
    Quantity {
        name: "motor.alpha_s",
        unit: "1",
        doc: "stator decay",
    },
    Quantity {
        name: "motor.alpha_r",
        unit: "1",
        doc: "rotor decay",
    },
    Quantity {
        name: "motor.literal",
        unit: "1",
        doc: "1: the rotor's angle, literally as printed; 0: its speed instead",
    },
    Quantity {
        name: "coupling.stiffness",
        unit: "N m/rad",
        doc: "torsional stiffness",
    },
    Quantity {
        name: "coupling.damping",
        unit: "N m s/rad",
        doc: "torsional damping",
    },
    Quantity {
        name: "coupling.ratio",
        unit: "1",
        doc: "turns of the driving end for one turn of the driven end",
    },
    Quantity {
        name: "cylinder.inertia",
        unit: "kg m^2",
        doc: "moment of inertia",
    },
    Quantity {
        name: "load.mean",
        unit: "N m",
        doc: "mean torque",
    },
    Quantity {
        name: "load.amplitude",
        unit: "N m",
        doc: "amplitude of the harmonic part",
    },
    Quantity {
        name: "load.speed",
        unit: "1",
        doc: "nominal speed in revolutions per minute, a count as the study gives it",
    },
    Quantity {
        name: "load.phase",
        unit: "rad",
        doc: "phase of the harmonic part",
    },
    Quantity {
        name: "load.engagement_time",
        unit: "s",
        doc: "time at which half of the load acts",
    },
    Quantity {
        name: "load.engagement_width",
        unit: "s",
        doc: "time constant of engagement",
    },
    Quantity {
        name: "load.standstill_band",
        unit: "rad/s",
        doc: "speed below which the load fades out",
    },
];

static PARAMETER_DEFAULTS: [f64; PARAMETERS] = [
    4.2,
    220.0,
    0.0,
    78.54,
    4.0,
    0.956,
    0.952,
    0.0896,
    4.14,
    0.115,
    0.0858,
    1.0,
    23065.2,
    128.5346,
    1.0,
    1.244,
    843.72,
    78.78,
    735.0,
    0.0,
    1.2,
    0.02,
    0.5,
];

static OUTPUT_QUANTITIES: [Quantity<'static>; OUTPUTS] = [
    Quantity {
        name: "motor_speed",
        unit: "rad/s",
        doc: "rate of rotor angle",
    },
    Quantity {
        name: "cylinder_speed",
        unit: "rad/s",
        doc: "rate of angle",
    },
    Quantity {
        name: "motor_torque",
        unit: "N m",
        doc: "driving torque",
    },
    Quantity {
        name: "coupling_torque",
        unit: "N m",
        doc: "torque carried, on the driving side",
    },
    Quantity {
        name: "cylinder_acceleration",
        unit: "rad/s^2",
        doc: "rate of rate of angle",
    },
];

/// The run the spec asks for.
pub const RUN_DEFAULTS: RunDefaults<'static> = RunDefaults {
    from: 0.0,
    until: 3.0,
    points: 3001,
    rtol: 1e-8,
    method: "tsit45",
};

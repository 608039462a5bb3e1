// Emitted by Machinist 0.1.0; do not edit. To make it again:
//
//     cargo run --release -- gen
//
// Sources, with SHA-256:
//   c4c2d6396f0304a4888cd124839e58b25a2a797e69561a3d8b874d9ba0142249  scenes/saw_gin_shaft.toml
//   fe2f2deb5f36655ff87e1d6f2bb763716b1c76007878e37e8e41643655074862  units/induction_motor.toml
//   a479b553f0542fe4aecc9e2a030097bc5b34e101f44a5e7297713fb52484327b  units/coupling.toml
//   dfce33ca2043ba8ff7ca98b593cfac2d21ce029618df546e0e9507db531728da  units/saw_shaft.toml
//
// Saw gin with a distributed shaft
//
// Motor, coupling, and the saw cylinder as an elastic shaft along which inertia and load
// are spread. The machine runs up empty; the load engages at 1.2 s.
//
// Source:
//   Saw-gin study (2020), in its consistent reading, with balanced load densities.
//
// Shapes; all quantities are in SI units:
//   coordinates               3
//   first-order states        4
//   states                   10
//   parameters               33
//   outputs                   8
//   discontinuities           0
//
// State:
//     0  motor.phi        [rad]    rotor angle
//     1  saws.driven      [rad]    angle of the section, at port driven
//     2  saws.end         [rad]    angle of the section, at port end
//     3  motor.omega      [rad/s]  rate of rotor angle
//     4  saws.driven_dot  [rad/s]  rate of angle of the section, at port driven
//     5  saws.end_dot     [rad/s]  rate of angle of the section, at port end
//     6  motor.psi_sx     [V s]    stator flux linkage along x
//     7  motor.psi_sy     [V s]    stator flux linkage along y
//     8  motor.psi_rx     [V s]    rotor flux linkage along x
//     9  motor.psi_ry     [V s]    rotor flux linkage along y
//
// Nonzeros:
//   mass_matrix               3 of 3 by 3
//   rate_jacobian            29 of 10 by 10
//   parameter_jacobian       34 of 10 by 33
//
// Operations:
//   initial_state             0
//   discontinuities           0
//   rate                     63
//   mass_matrix               0
//   forcing                  26
//   rate_jacobian            53
//   parameter_jacobian      134
//   time_derivative           0
//   outputs                  22
//   energy                   45
//   power_balance           144
// With constants of the parameters, prepared once a run:
//   prepare                  45
//   prepared_rate            43
//   prepared_rate_jacobian   14

use ::machinist_contract::{
    Describe, Energy, PowerBalance, Quantity, Real, RunDefaults, Shape, Simulator,
    SparsityPattern,
    field::{FieldAttachment, FieldDescription, FieldPlace, FieldPoint, FieldScene},
};

/// Generalized coordinates, n.
pub const COORDINATES: usize = 3;

/// Length of the state y.
pub const STATES: usize = 10;

/// Parameters.
pub const PARAMETERS: usize = 33;

/// Wanted outputs.
pub const OUTPUTS: usize = 8;

/// Times at which the right-hand side jumps.
pub const DISCONTINUITIES: usize = 0;

/// Nonzeros of M, both triangles.
pub const MASS_MATRIX_PATTERN: SparsityPattern<'static> = SparsityPattern {
    rows: 3,
    columns: 3,
    entries: &[(0, 0), (1, 1), (2, 2)],
};

/// Nonzeros of dy'/dy.
pub const RATE_JACOBIAN_PATTERN: SparsityPattern<'static> = SparsityPattern {
    rows: 10,
    columns: 10,
    entries: &[
        (0, 3), (1, 4), (2, 5), (3, 0), (3, 1), (3, 3), (3, 4), (3, 6), (3, 7), (3, 8), (3, 9),
        (4, 0), (4, 1), (4, 3), (4, 4), (6, 6), (6, 7), (6, 8), (7, 6), (7, 7), (7, 9), (8, 3),
        (8, 6), (8, 8), (8, 9), (9, 3), (9, 7), (9, 8), (9, 9),
    ],
};

/// Nonzeros of dy'/dp.
pub const PARAMETER_JACOBIAN_PATTERN: SparsityPattern<'static> = SparsityPattern {
    rows: 10,
    columns: 33,
    entries: &[
        (3, 0), (3, 2), (3, 4), (3, 5), (3, 6), (3, 7), (3, 10), (3, 11), (3, 12), (4, 10), (4, 11),
        (4, 12), (4, 25), (4, 26), (5, 29), (5, 30), (6, 1), (6, 2), (6, 3), (6, 6), (6, 8), (7, 1),
        (7, 2), (7, 3), (7, 6), (7, 8), (8, 2), (8, 4), (8, 5), (8, 9), (9, 2), (9, 4), (9, 5),
        (9, 9),
    ],
};

/// Saw gin with a distributed shaft
///
/// Motor, coupling, and the saw cylinder as an elastic shaft along which inertia and load
/// are spread. The machine runs up empty; the load engages at 1.2 s.
///
/// Source: Saw-gin study (2020), in its consistent reading, with balanced load densities.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct SawGinShaft;

/// Parameters, in SI units; the default holds the values of the spec.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Parameters<R> {
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
    /// coupling.stiffness: torsional stiffness \[N m/rad\]. In the spec: 23065.2.
    pub coupling_stiffness: R,
    /// coupling.damping: torsional damping \[N m s/rad\]. In the spec: 128.5346.
    pub coupling_damping: R,
    /// coupling.ratio: turns of the driving end for one turn of the driven end \[1\]. In the spec: 1.0.
    pub coupling_ratio: R,
    /// saws.length: length \[m\]. In the spec: 2.322.
    pub saws_length: R,
    /// saws.inertia: moment of inertia of the cylinder \[kg m^2\]. In the spec: 1.244.
    pub saws_inertia: R,
    /// saws.shear_modulus: shear modulus \[Pa\]. In the spec: 80000000000.0.
    pub saws_shear_modulus: R,
    /// saws.polar_moment: polar moment of the section \[m^4\]. In the spec: 9.817e-6.
    pub saws_polar_moment: R,
    /// saws.damping_time: Kelvin-Voigt damping time; ours \[s\]. In the spec: 1e-5.
    pub saws_damping_time: R,
    /// saws.mean: mean load \[N m\]. In the spec: 843.72.
    pub saws_mean: R,
    /// saws.amplitude: harmonic part of the load \[N m\]. In the spec: 78.78.
    pub saws_amplitude: R,
    /// saws.speed: rated speed, revolutions per minute \[1\]. In the spec: 735.0.
    pub saws_speed: R,
    /// saws.growing: share of the load that grows with x; 0 for an even one \[1\]. In the spec: 0.0.
    pub saws_growing: R,
    /// saws.engagement_time: time at which the load engages \[s\]. In the spec: 1.2.
    pub saws_engagement_time: R,
    /// saws.engagement_width: time scale of engagement \[s\]. In the spec: 0.02.
    pub saws_engagement_width: R,
    /// saws.standstill_band: speed below which the load fades \[rad/s\]. In the spec: 0.5.
    pub saws_standstill_band: R,
    /// saws.driven_field_inertia: inertia of the field's node; the field sets it \[J s^2/(rad)^2\]. In the spec: 1.0.
    pub saws_driven_field_inertia: R,
    /// saws.driven_field_force: force of the field on its node; the field sets it \[J/(rad)\]. In the spec: 0.0.
    pub saws_driven_field_force: R,
    /// saws.driven_phi_x_before: slope of the field before the port; the field sets it \[rad/m\]. In the spec: 0.0.
    pub saws_driven_phi_x_before: R,
    /// saws.driven_phi_x_after: slope of the field after the port; the field sets it \[rad/m\]. In the spec: 0.0.
    pub saws_driven_phi_x_after: R,
    /// saws.end_field_inertia: inertia of the field's node; the field sets it \[J s^2/(rad)^2\]. In the spec: 1.0.
    pub saws_end_field_inertia: R,
    /// saws.end_field_force: force of the field on its node; the field sets it \[J/(rad)\]. In the spec: 0.0.
    pub saws_end_field_force: R,
    /// saws.end_phi_x_before: slope of the field before the port; the field sets it \[rad/m\]. In the spec: 0.0.
    pub saws_end_phi_x_before: R,
    /// saws.end_phi_x_after: slope of the field after the port; the field sets it \[rad/m\]. In the spec: 0.0.
    pub saws_end_phi_x_after: R,
}

impl<R: Real> Parameters<R> {
    /// From the numbers in their order.
    #[must_use]
    #[inline]
    pub fn from_array(values: [R; PARAMETERS]) -> Self {
        Self {
            motor_inertia: values[0],
            motor_phase_voltage: values[1],
            motor_supply_frequency: values[2],
            motor_supply_phase: values[3],
            motor_pole_pairs: values[4],
            motor_k_s: values[5],
            motor_k_r: values[6],
            motor_x_s: values[7],
            motor_alpha_s: values[8],
            motor_alpha_r: values[9],
            coupling_stiffness: values[10],
            coupling_damping: values[11],
            coupling_ratio: values[12],
            saws_length: values[13],
            saws_inertia: values[14],
            saws_shear_modulus: values[15],
            saws_polar_moment: values[16],
            saws_damping_time: values[17],
            saws_mean: values[18],
            saws_amplitude: values[19],
            saws_speed: values[20],
            saws_growing: values[21],
            saws_engagement_time: values[22],
            saws_engagement_width: values[23],
            saws_standstill_band: values[24],
            saws_driven_field_inertia: values[25],
            saws_driven_field_force: values[26],
            saws_driven_phi_x_before: values[27],
            saws_driven_phi_x_after: values[28],
            saws_end_field_inertia: values[29],
            saws_end_field_force: values[30],
            saws_end_phi_x_before: values[31],
            saws_end_phi_x_after: values[32],
        }
    }
    /// The numbers in their order.
    #[must_use]
    #[inline]
    pub fn to_array(self) -> [R; PARAMETERS] {
        [
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
            self.coupling_stiffness,
            self.coupling_damping,
            self.coupling_ratio,
            self.saws_length,
            self.saws_inertia,
            self.saws_shear_modulus,
            self.saws_polar_moment,
            self.saws_damping_time,
            self.saws_mean,
            self.saws_amplitude,
            self.saws_speed,
            self.saws_growing,
            self.saws_engagement_time,
            self.saws_engagement_width,
            self.saws_standstill_band,
            self.saws_driven_field_inertia,
            self.saws_driven_field_force,
            self.saws_driven_phi_x_before,
            self.saws_driven_phi_x_after,
            self.saws_end_field_inertia,
            self.saws_end_field_force,
            self.saws_end_phi_x_before,
            self.saws_end_phi_x_after,
        ]
    }
}

impl<R: Real> Default for Parameters<R> {
    fn default() -> Self {
        Self {
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
            coupling_stiffness: R::literal(23065.2),
            coupling_damping: R::literal(128.5346),
            coupling_ratio: R::literal(1.0),
            saws_length: R::literal(2.322),
            saws_inertia: R::literal(1.244),
            saws_shear_modulus: R::literal(8e10),
            saws_polar_moment: R::literal(9.817e-6),
            saws_damping_time: R::literal(1e-5),
            saws_mean: R::literal(843.72),
            saws_amplitude: R::literal(78.78),
            saws_speed: R::literal(735.0),
            saws_growing: R::literal(0.0),
            saws_engagement_time: R::literal(1.2),
            saws_engagement_width: R::literal(0.02),
            saws_standstill_band: R::literal(0.5),
            saws_driven_field_inertia: R::literal(1.0),
            saws_driven_field_force: R::literal(0.0),
            saws_driven_phi_x_before: R::literal(0.0),
            saws_driven_phi_x_after: R::literal(0.0),
            saws_end_field_inertia: R::literal(1.0),
            saws_end_field_force: R::literal(0.0),
            saws_end_phi_x_before: R::literal(0.0),
            saws_end_phi_x_after: R::literal(0.0),
        }
    }
}

/// Wanted outputs, in SI units.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Outputs<R> {
    /// motor_speed: rate of rotor angle \[rad/s\].
    pub motor_speed: R,
    /// driven_speed: rate of angle of the section, at port driven \[rad/s\].
    pub driven_speed: R,
    /// end_speed: rate of angle of the section, at port end \[rad/s\].
    pub end_speed: R,
    /// twist: twist of the shaft \[rad\].
    pub twist: R,
    /// slope: twist a length at the driven end \[rad/m\].
    pub slope: R,
    /// motor_torque: electromagnetic torque \[N m\].
    pub motor_torque: R,
    /// coupling_torque: torque carried, on the driving side \[N m\].
    pub coupling_torque: R,
    /// shaft_torque: elastic torque in the shaft at its driven end \[N m\].
    pub shaft_torque: R,
}

impl<R: Real> Outputs<R> {
    /// From the numbers in their order.
    #[must_use]
    #[inline]
    pub fn from_array(values: [R; OUTPUTS]) -> Self {
        Self {
            motor_speed: values[0],
            driven_speed: values[1],
            end_speed: values[2],
            twist: values[3],
            slope: values[4],
            motor_torque: values[5],
            coupling_torque: values[6],
            shaft_torque: values[7],
        }
    }
    /// The numbers in their order.
    #[must_use]
    #[inline]
    pub fn to_array(self) -> [R; OUTPUTS] {
        [
            self.motor_speed,
            self.driven_speed,
            self.end_speed,
            self.twist,
            self.slope,
            self.motor_torque,
            self.coupling_torque,
            self.shaft_torque,
        ]
    }
}

/// Where to find what in the state.
pub mod state {
    /// motor.phi: rotor angle \[rad\].
    pub const MOTOR_PHI: usize = 0;
    /// saws.driven: angle of the section, at port driven \[rad\].
    pub const SAWS_DRIVEN: usize = 1;
    /// saws.end: angle of the section, at port end \[rad\].
    pub const SAWS_END: usize = 2;
    /// motor.omega: rate of rotor angle \[rad/s\].
    pub const MOTOR_OMEGA: usize = 3;
    /// saws.driven_dot: rate of angle of the section, at port driven \[rad/s\].
    pub const SAWS_DRIVEN_DOT: usize = 4;
    /// saws.end_dot: rate of angle of the section, at port end \[rad/s\].
    pub const SAWS_END_DOT: usize = 5;
    /// motor.psi_sx: stator flux linkage along x \[V s\].
    pub const MOTOR_PSI_SX: usize = 6;
    /// motor.psi_sy: stator flux linkage along y \[V s\].
    pub const MOTOR_PSI_SY: usize = 7;
    /// motor.psi_rx: rotor flux linkage along x \[V s\].
    pub const MOTOR_PSI_RX: usize = 8;
    /// motor.psi_ry: rotor flux linkage along y \[V s\].
    pub const MOTOR_PSI_RY: usize = 9;
}

/// Constants that `prepare` computes.
pub const CONSTANTS: usize = 25;

#[allow(missing_docs, reason = "`prepare` says what each is")]
/// What parameters alone decide; `prepare` says what each is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Constants<R> {
    pub motor_omega_0: R,
    pub motor_u_x: R,
    pub motor_u_y: R,
    pub t2: R,
    pub inverse_motor_inertia: R,
    pub inverse_saws_driven_field_inertia: R,
    pub inverse_saws_end_field_inertia: R,
    pub t3: R,
    pub t4: R,
    pub motor_alpha_s_times_motor_omega_0: R,
    pub motor_alpha_r_times_motor_omega_0: R,
    pub saws_driven_dot_dot_by_motor_phi: R,
    pub motor_omega_dot_by_motor_phi: R,
    pub saws_driven_dot_dot_by_saws_driven: R,
    pub motor_omega_dot_by_saws_driven: R,
    pub saws_driven_dot_dot_by_motor_omega: R,
    pub motor_omega_dot_by_motor_omega: R,
    pub saws_driven_dot_dot_by_saws_driven_dot: R,
    pub motor_omega_dot_by_saws_driven_dot: R,
    pub t5: R,
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
            inverse_saws_driven_field_inertia: values[5],
            inverse_saws_end_field_inertia: values[6],
            t3: values[7],
            t4: values[8],
            motor_alpha_s_times_motor_omega_0: values[9],
            motor_alpha_r_times_motor_omega_0: values[10],
            saws_driven_dot_dot_by_motor_phi: values[11],
            motor_omega_dot_by_motor_phi: values[12],
            saws_driven_dot_dot_by_saws_driven: values[13],
            motor_omega_dot_by_saws_driven: values[14],
            saws_driven_dot_dot_by_motor_omega: values[15],
            motor_omega_dot_by_motor_omega: values[16],
            saws_driven_dot_dot_by_saws_driven_dot: values[17],
            motor_omega_dot_by_saws_driven_dot: values[18],
            t5: values[19],
            motor_psi_sx_dot_by_motor_psi_sx: values[20],
            motor_psi_sy_dot_by_motor_psi_sx: values[21],
            motor_psi_rx_dot_by_motor_psi_sx: values[22],
            motor_psi_sx_dot_by_motor_psi_rx: values[23],
            motor_psi_rx_dot_by_motor_psi_rx: values[24],
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
            self.inverse_saws_driven_field_inertia,
            self.inverse_saws_end_field_inertia,
            self.t3,
            self.t4,
            self.motor_alpha_s_times_motor_omega_0,
            self.motor_alpha_r_times_motor_omega_0,
            self.saws_driven_dot_dot_by_motor_phi,
            self.motor_omega_dot_by_motor_phi,
            self.saws_driven_dot_dot_by_saws_driven,
            self.motor_omega_dot_by_saws_driven,
            self.saws_driven_dot_dot_by_motor_omega,
            self.motor_omega_dot_by_motor_omega,
            self.saws_driven_dot_dot_by_saws_driven_dot,
            self.motor_omega_dot_by_saws_driven_dot,
            self.t5,
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
/// 45 operations.
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
    let inverse_saws_driven_field_inertia = R::literal(1.0)
        / p.saws_driven_field_inertia;
    let inverse_saws_end_field_inertia = R::literal(1.0) / p.saws_end_field_inertia;
    let t3 = p.coupling_stiffness * p.coupling_ratio;
    let t4 = p.coupling_damping * p.coupling_ratio;
    let motor_alpha_s_times_motor_omega_0 = p.motor_alpha_s * motor_omega_0;
    let motor_alpha_r_times_motor_omega_0 = p.motor_alpha_r * motor_omega_0;
    let saws_driven_dot_dot_by_motor_phi = t3 * inverse_saws_driven_field_inertia;
    let motor_omega_dot_by_motor_phi = -(p.coupling_stiffness * inverse_motor_inertia);
    let coupling_ratio_squared = p.coupling_ratio * p.coupling_ratio;
    let saws_driven_dot_dot_by_saws_driven = -(p.coupling_stiffness
        * coupling_ratio_squared * inverse_saws_driven_field_inertia);
    let motor_omega_dot_by_saws_driven = t3 * inverse_motor_inertia;
    let saws_driven_dot_dot_by_motor_omega = t4 * inverse_saws_driven_field_inertia;
    let motor_omega_dot_by_motor_omega = -(p.coupling_damping * inverse_motor_inertia);
    let saws_driven_dot_dot_by_saws_driven_dot = -(p.coupling_damping
        * coupling_ratio_squared * inverse_saws_driven_field_inertia);
    let motor_omega_dot_by_saws_driven_dot = t4 * inverse_motor_inertia;
    let t5 = t1 / (p.motor_x_s * (motor_k_s_times_motor_k_r - R::literal(1.0)));
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
        inverse_saws_driven_field_inertia,
        inverse_saws_end_field_inertia,
        t3,
        t4,
        motor_alpha_s_times_motor_omega_0,
        motor_alpha_r_times_motor_omega_0,
        saws_driven_dot_dot_by_motor_phi,
        motor_omega_dot_by_motor_phi,
        saws_driven_dot_dot_by_saws_driven,
        motor_omega_dot_by_saws_driven,
        saws_driven_dot_dot_by_motor_omega,
        motor_omega_dot_by_motor_omega,
        saws_driven_dot_dot_by_saws_driven_dot,
        motor_omega_dot_by_saws_driven_dot,
        t5,
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
/// 63 operations.
#[must_use]
#[inline]
pub fn rate<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>) -> [R; STATES] {
    prepared_rate(time, state, p, &prepare(p))
}

/// As `rate`, with the constants of the parameters from `prepare`.
///
/// 43 operations.
#[must_use]
#[inline]
pub fn prepared_rate<R: Real>(
    _time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
    c: &Constants<R>,
) -> [R; STATES] {
    let [motor_phi, saws_driven, _, motor_omega, saws_driven_dot, saws_end_dot,
    motor_psi_sx, motor_psi_sy, motor_psi_rx, motor_psi_ry] = *state;
    let coupling_twist = motor_phi.sub_product(p.coupling_ratio, saws_driven);
    let coupling_twist_rate = motor_omega.sub_product(p.coupling_ratio, saws_driven_dot);
    let motor_slip_speed = c.motor_omega_0.sub_product(p.motor_pole_pairs, motor_omega);
    let coupling_torque = (p.coupling_stiffness * coupling_twist)
        .add_product(p.coupling_damping, coupling_twist_rate);
    let motor_torque = c.t2
        * (motor_psi_sy * motor_psi_rx).sub_product(motor_psi_sx, motor_psi_ry);
    let saws_end_dot_dot = p.saws_end_field_force * c.inverse_saws_end_field_inertia;
    let saws_driven_dot_dot = p
        .saws_driven_field_force
        .add_product(c.t3, coupling_twist)
        .add_product(c.t4, coupling_twist_rate) * c.inverse_saws_driven_field_inertia;
    let motor_omega_dot = (motor_torque - coupling_torque) * c.inverse_motor_inertia;
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
        motor_omega,
        saws_driven_dot,
        saws_end_dot,
        motor_omega_dot,
        saws_driven_dot_dot,
        saws_end_dot_dot,
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
) -> [R; 3] {
    [p.motor_inertia, p.saws_driven_field_inertia, p.saws_end_field_inertia]
}

/// `f` of `M q'' = f(q, q', z, t)`, one for each coordinate.
///
/// 26 operations.
#[must_use]
pub fn forcing<R: Real>(
    _time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
) -> [R; COORDINATES] {
    let [motor_phi, saws_driven, _, motor_omega, saws_driven_dot, _, motor_psi_sx,
    motor_psi_sy, motor_psi_rx, motor_psi_ry] = *state;
    let motor_omega_0 = R::literal(core::f64::consts::TAU) * p.motor_supply_frequency;
    let motor_sigma = R::literal(1.0).sub_product(p.motor_k_s, p.motor_k_r);
    let coupling_twist = motor_phi.sub_product(p.coupling_ratio, saws_driven);
    let coupling_twist_rate = motor_omega.sub_product(p.coupling_ratio, saws_driven_dot);
    let coupling_torque = (p.coupling_stiffness * coupling_twist)
        .add_product(p.coupling_damping, coupling_twist_rate);
    let motor_torque = R::literal(1.5) * p.motor_pole_pairs * p.motor_k_r * motor_omega_0
        / (p.motor_x_s * motor_sigma)
        * (motor_psi_sy * motor_psi_rx).sub_product(motor_psi_sx, motor_psi_ry);
    let motor_phi_forcing = motor_torque - coupling_torque;
    let saws_driven_forcing = p
        .saws_driven_field_force
        .add_product(p.coupling_stiffness * p.coupling_ratio, coupling_twist)
        .add_product(p.coupling_damping * p.coupling_ratio, coupling_twist_rate);
    [motor_phi_forcing, saws_driven_forcing, p.saws_end_field_force]
}

/// `dy'/dy`, values in the order of `RATE_JACOBIAN_PATTERN`.
///
/// 53 operations.
#[must_use]
#[inline]
pub fn rate_jacobian<R: Real>(
    time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
) -> [R; 29] {
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
) -> [R; 29] {
    let [_, _, _, motor_omega, _, _, motor_psi_sx, motor_psi_sy, motor_psi_rx,
    motor_psi_ry] = *state;
    let motor_pole_pairs_times_motor_omega = p.motor_pole_pairs * motor_omega;
    let motor_slip_speed = c.motor_omega_0 - motor_pole_pairs_times_motor_omega;
    let motor_psi_rx_dot_by_motor_omega = -(p.motor_pole_pairs * motor_psi_ry);
    let motor_psi_ry_dot_by_motor_omega = p.motor_pole_pairs * motor_psi_rx;
    let motor_omega_dot_by_motor_psi_sx = c.t5 * motor_psi_ry * c.inverse_motor_inertia;
    let motor_omega_dot_by_motor_psi_sy = c.t2 * motor_psi_rx * c.inverse_motor_inertia;
    let motor_omega_dot_by_motor_psi_rx = c.t2 * motor_psi_sy * c.inverse_motor_inertia;
    let motor_psi_ry_dot_by_motor_psi_rx = motor_pole_pairs_times_motor_omega
        - c.motor_omega_0;
    let motor_omega_dot_by_motor_psi_ry = c.t5 * motor_psi_sx * c.inverse_motor_inertia;
    [
        R::literal(1.0),
        R::literal(1.0),
        R::literal(1.0),
        c.motor_omega_dot_by_motor_phi,
        c.motor_omega_dot_by_saws_driven,
        c.motor_omega_dot_by_motor_omega,
        c.motor_omega_dot_by_saws_driven_dot,
        motor_omega_dot_by_motor_psi_sx,
        motor_omega_dot_by_motor_psi_sy,
        motor_omega_dot_by_motor_psi_rx,
        motor_omega_dot_by_motor_psi_ry,
        c.saws_driven_dot_dot_by_motor_phi,
        c.saws_driven_dot_dot_by_saws_driven,
        c.saws_driven_dot_dot_by_motor_omega,
        c.saws_driven_dot_dot_by_saws_driven_dot,
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
/// 134 operations.
#[must_use]
pub fn parameter_jacobian<R: Real>(
    _time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
) -> [R; 34] {
    let [motor_phi, saws_driven, _, motor_omega, saws_driven_dot, _, motor_psi_sx,
    motor_psi_sy, motor_psi_rx, motor_psi_ry] = *state;
    let (sin_motor_supply_phase, cos_motor_supply_phase) = p
        .motor_supply_phase
        .sin_cos();
    let motor_omega_0 = R::literal(core::f64::consts::TAU) * p.motor_supply_frequency;
    let motor_k_s_times_motor_k_r = p.motor_k_s * p.motor_k_r;
    let motor_sigma = R::literal(1.0) - motor_k_s_times_motor_k_r;
    let t0 = p.motor_phase_voltage * R::literal(core::f64::consts::SQRT_2);
    let motor_u_x = t0 * cos_motor_supply_phase;
    let motor_u_y = t0 * sin_motor_supply_phase;
    let coupling_ratio_times_saws_driven = p.coupling_ratio * saws_driven;
    let coupling_twist = motor_phi - coupling_ratio_times_saws_driven;
    let coupling_ratio_times_saws_driven_dot = p.coupling_ratio * saws_driven_dot;
    let coupling_twist_rate = motor_omega - coupling_ratio_times_saws_driven_dot;
    let coupling_torque = (p.coupling_stiffness * coupling_twist)
        .add_product(p.coupling_damping, coupling_twist_rate);
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
    let inverse_saws_driven_field_inertia = R::literal(1.0)
        / p.saws_driven_field_inertia;
    let inverse_saws_end_field_inertia = R::literal(1.0) / p.saws_end_field_inertia;
    let saws_end_dot_dot = p.saws_end_field_force * inverse_saws_end_field_inertia;
    let saws_driven_dot_dot = p
        .saws_driven_field_force
        .add_product(p.coupling_stiffness * p.coupling_ratio, coupling_twist)
        .add_product(p.coupling_damping * p.coupling_ratio, coupling_twist_rate)
        * inverse_saws_driven_field_inertia;
    let motor_omega_dot = (motor_torque - coupling_torque) * inverse_motor_inertia;
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
    let saws_driven_dot_dot_by_coupling_stiffness = p.coupling_ratio * coupling_twist
        * inverse_saws_driven_field_inertia;
    let motor_omega_dot_by_coupling_stiffness = (coupling_ratio_times_saws_driven
        - motor_phi) * inverse_motor_inertia;
    let saws_driven_dot_dot_by_coupling_damping = p.coupling_ratio * coupling_twist_rate
        * inverse_saws_driven_field_inertia;
    let motor_omega_dot_by_coupling_damping = (coupling_ratio_times_saws_driven_dot
        - motor_omega) * inverse_motor_inertia;
    let saws_driven_dot_dot_by_coupling_ratio = (p.coupling_stiffness * motor_phi)
        .add_product(p.coupling_damping, motor_omega)
        .sub_product(
            R::literal(2.0) * p.coupling_stiffness * p.coupling_ratio,
            saws_driven,
        )
        .sub_product(
            R::literal(2.0) * p.coupling_damping * p.coupling_ratio,
            saws_driven_dot,
        ) * inverse_saws_driven_field_inertia;
    let motor_omega_dot_by_coupling_ratio = (p.coupling_stiffness * saws_driven)
        .add_product(p.coupling_damping, saws_driven_dot) * inverse_motor_inertia;
    let saws_driven_dot_dot_by_saws_driven_field_inertia = -(saws_driven_dot_dot
        * inverse_saws_driven_field_inertia);
    let saws_end_dot_dot_by_saws_end_field_inertia = -(saws_end_dot_dot
        * inverse_saws_end_field_inertia);
    [
        motor_omega_dot_by_motor_inertia,
        motor_omega_dot_by_motor_supply_frequency,
        motor_omega_dot_by_motor_pole_pairs,
        motor_omega_dot_by_motor_k_s,
        motor_omega_dot_by_motor_k_r,
        motor_omega_dot_by_motor_x_s,
        motor_omega_dot_by_coupling_stiffness,
        motor_omega_dot_by_coupling_damping,
        motor_omega_dot_by_coupling_ratio,
        saws_driven_dot_dot_by_coupling_stiffness,
        saws_driven_dot_dot_by_coupling_damping,
        saws_driven_dot_dot_by_coupling_ratio,
        saws_driven_dot_dot_by_saws_driven_field_inertia,
        inverse_saws_driven_field_inertia,
        saws_end_dot_dot_by_saws_end_field_inertia,
        inverse_saws_end_field_inertia,
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
    ]
}

/// Wanted outputs.
///
/// 22 operations.
#[must_use]
pub fn outputs<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>) -> Outputs<R> {
    let [motor_phi, saws_driven, saws_end, motor_omega, saws_driven_dot, saws_end_dot,
    motor_psi_sx, motor_psi_sy, motor_psi_rx, motor_psi_ry] = *state;
    let motor_omega_0 = R::literal(core::f64::consts::TAU) * p.motor_supply_frequency;
    let motor_sigma = R::literal(1.0).sub_product(p.motor_k_s, p.motor_k_r);
    let coupling_twist = motor_phi.sub_product(p.coupling_ratio, saws_driven);
    let coupling_twist_rate = motor_omega.sub_product(p.coupling_ratio, saws_driven_dot);
    let coupling_torque = (p.coupling_stiffness * coupling_twist)
        .add_product(p.coupling_damping, coupling_twist_rate);
    let motor_torque = R::literal(1.5) * p.motor_pole_pairs * p.motor_k_r * motor_omega_0
        / (p.motor_x_s * motor_sigma)
        * (motor_psi_sy * motor_psi_rx).sub_product(motor_psi_sx, motor_psi_ry);
    Outputs {
        motor_speed: motor_omega,
        driven_speed: saws_driven_dot,
        end_speed: saws_end_dot,
        twist: saws_driven - saws_end,
        slope: p.saws_driven_phi_x_after,
        motor_torque,
        coupling_torque,
        shaft_torque: p.saws_shear_modulus * p.saws_polar_moment
            * p.saws_driven_phi_x_after,
    }
}

/// T, V and the energy of first-order states \[J\].
///
/// 45 operations.
#[must_use]
pub fn energy<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>) -> Energy<R> {
    let [motor_phi, saws_driven, _, motor_omega, saws_driven_dot, saws_end_dot,
    motor_psi_sx, motor_psi_sy, motor_psi_rx, motor_psi_ry] = *state;
    let motor_omega_0 = R::literal(core::f64::consts::TAU) * p.motor_supply_frequency;
    let motor_sigma = R::literal(1.0).sub_product(p.motor_k_s, p.motor_k_r);
    let motor_x_r = p.motor_k_s * p.motor_x_s / p.motor_k_r;
    let coupling_twist = motor_phi.sub_product(p.coupling_ratio, saws_driven);
    let t0 = motor_omega_0 / (p.motor_x_s * motor_sigma);
    let motor_i_sx = t0 * motor_psi_sx.sub_product(p.motor_k_r, motor_psi_rx);
    let motor_i_sy = t0 * motor_psi_sy.sub_product(p.motor_k_r, motor_psi_ry);
    let t1 = motor_omega_0 / (motor_sigma * motor_x_r);
    let motor_i_rx = t1 * motor_psi_rx.sub_product(p.motor_k_s, motor_psi_sx);
    let motor_i_ry = t1 * motor_psi_ry.sub_product(p.motor_k_s, motor_psi_sy);
    Energy {
        kinetic: (R::literal(0.5) * p.motor_inertia * (motor_omega * motor_omega))
            .add_product(
                R::literal(0.5) * p.saws_driven_field_inertia,
                saws_driven_dot * saws_driven_dot,
            )
            .add_product(
                R::literal(0.5) * p.saws_end_field_inertia,
                saws_end_dot * saws_end_dot,
            ),
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
/// 144 operations.
#[must_use]
pub fn power_balance<R: Real>(
    _time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
) -> PowerBalance<R> {
    let [motor_phi, saws_driven, _, motor_omega, saws_driven_dot, saws_end_dot,
    motor_psi_sx, motor_psi_sy, motor_psi_rx, motor_psi_ry] = *state;
    let (sin_motor_supply_phase, cos_motor_supply_phase) = p
        .motor_supply_phase
        .sin_cos();
    let motor_omega_0 = R::literal(core::f64::consts::TAU) * p.motor_supply_frequency;
    let motor_sigma = R::literal(1.0).sub_product(p.motor_k_s, p.motor_k_r);
    let motor_x_r = p.motor_k_s * p.motor_x_s / p.motor_k_r;
    let t0 = p.motor_phase_voltage * R::literal(core::f64::consts::SQRT_2);
    let motor_u_x = t0 * cos_motor_supply_phase;
    let motor_u_y = t0 * sin_motor_supply_phase;
    let coupling_twist = motor_phi.sub_product(p.coupling_ratio, saws_driven);
    let coupling_twist_rate = motor_omega.sub_product(p.coupling_ratio, saws_driven_dot);
    let motor_slip_speed = motor_omega_0.sub_product(p.motor_pole_pairs, motor_omega);
    let t1 = p.coupling_stiffness * coupling_twist;
    let coupling_torque = t1.add_product(p.coupling_damping, coupling_twist_rate);
    let t2 = motor_psi_sx.sub_product(p.motor_k_r, motor_psi_rx);
    let motor_x_s_times_motor_sigma = p.motor_x_s * motor_sigma;
    let t3 = motor_omega_0 / motor_x_s_times_motor_sigma;
    let motor_i_sx = t3 * t2;
    let t4 = motor_psi_sy.sub_product(p.motor_k_r, motor_psi_ry);
    let motor_i_sy = t3 * t4;
    let motor_k_s_times_motor_psi_sx = p.motor_k_s * motor_psi_sx;
    let t5 = motor_omega_0 / (motor_sigma * motor_x_r);
    let motor_i_rx = t5 * (motor_psi_rx - motor_k_s_times_motor_psi_sx);
    let motor_k_s_times_motor_psi_sy = p.motor_k_s * motor_psi_sy;
    let motor_i_ry = t5 * (motor_psi_ry - motor_k_s_times_motor_psi_sy);
    let motor_torque = R::literal(1.5) * p.motor_pole_pairs * p.motor_k_r * motor_omega_0
        / motor_x_s_times_motor_sigma
        * (motor_psi_sy * motor_psi_rx).sub_product(motor_psi_sx, motor_psi_ry);
    let t6 = p.coupling_stiffness * p.coupling_ratio * coupling_twist;
    let t7 = p.coupling_damping * p.coupling_ratio;
    let saws_end_dot_dot = p.saws_end_field_force
        * (R::literal(1.0) / p.saws_end_field_inertia);
    let saws_driven_dot_dot = (p.saws_driven_field_force + t6)
        .add_product(t7, coupling_twist_rate)
        * (R::literal(1.0) / p.saws_driven_field_inertia);
    let motor_omega_dot = (motor_torque - coupling_torque)
        * (R::literal(1.0) / p.motor_inertia);
    let motor_alpha_s_times_motor_omega_0 = p.motor_alpha_s * motor_omega_0;
    let motor_psi_sx_dot = motor_u_x
        .add_product(motor_omega_0, motor_psi_sy)
        .sub_product(motor_alpha_s_times_motor_omega_0, t2);
    let motor_psi_sy_dot = motor_u_y
        .sub_product(motor_omega_0, motor_psi_sx)
        .sub_product(motor_alpha_s_times_motor_omega_0, t4);
    let motor_alpha_r_times_motor_omega_0 = p.motor_alpha_r * motor_omega_0;
    let motor_psi_rx_dot = (motor_psi_ry * motor_slip_speed)
        .add_product(
            motor_alpha_r_times_motor_omega_0,
            motor_k_s_times_motor_psi_sx - motor_psi_rx,
        );
    let motor_psi_ry_dot = (motor_alpha_r_times_motor_omega_0
        * (motor_k_s_times_motor_psi_sy - motor_psi_ry))
        .sub_product(motor_psi_rx, motor_slip_speed);
    let t8 = p.motor_k_r * motor_omega_0 / motor_x_s_times_motor_sigma;
    PowerBalance {
        stored_rate: (t1 * motor_omega)
            .sub_product(t6, saws_driven_dot)
            .add_product(p.motor_inertia * motor_omega, motor_omega_dot)
            .add_product(
                saws_driven_dot * p.saws_driven_field_inertia,
                saws_driven_dot_dot,
            )
            .add_product(saws_end_dot * p.saws_end_field_inertia, saws_end_dot_dot)
            .add_product(
                R::literal(0.75)
                    * motor_i_sx
                        .add_product(t3, motor_psi_sx)
                        .sub_product(t8, motor_psi_rx),
                motor_psi_sx_dot,
            )
            .add_product(
                R::literal(0.75)
                    * motor_i_sy
                        .add_product(t3, motor_psi_sy)
                        .sub_product(t8, motor_psi_ry),
                motor_psi_sy_dot,
            )
            .add_product(
                R::literal(0.75)
                    * motor_i_rx
                        .add_product(t5, motor_psi_rx)
                        .sub_product(t8, motor_psi_sx),
                motor_psi_rx_dot,
            )
            .add_product(
                R::literal(0.75)
                    * motor_i_ry
                        .add_product(t5, motor_psi_ry)
                        .sub_product(t8, motor_psi_sy),
                motor_psi_ry_dot,
            ),
        supplied: (saws_driven_dot * p.saws_driven_field_force)
            .add_product(
                R::literal(1.5),
                (motor_u_x * motor_i_sx).add_product(motor_u_y, motor_i_sy),
            )
            .add_product(saws_end_dot, p.saws_end_field_force),
        dissipated: (p.coupling_damping * motor_omega * coupling_twist_rate)
            .add_product(
                R::literal(1.5),
                (p.motor_x_s * p.motor_alpha_s * motor_sigma
                    * (motor_i_sx * motor_i_sx).add_product(motor_i_sy, motor_i_sy))
                    .add_product(
                        p.motor_alpha_r * motor_sigma * motor_x_r,
                        (motor_i_rx * motor_i_rx).add_product(motor_i_ry, motor_i_ry),
                    ),
            )
            .sub_product(t7 * saws_driven_dot, coupling_twist_rate),
    }
}

impl Describe for SawGinShaft {
    fn name(&self) -> &'static str {
        "saw_gin_shaft"
    }
    fn title(&self) -> &'static str {
        "Saw gin with a distributed shaft"
    }
    fn shape(&self) -> Shape {
        Shape {
            coordinates: COORDINATES,
            positions: 3,
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

impl<R: Real> Simulator<R> for SawGinShaft {
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
        name: "saws.driven",
        unit: "rad",
        doc: "angle of the section, at port driven",
    },
    Quantity {
        name: "saws.end",
        unit: "rad",
        doc: "angle of the section, at port end",
    },
    Quantity {
        name: "motor.omega",
        unit: "rad/s",
        doc: "rate of rotor angle",
    },
    Quantity {
        name: "saws.driven_dot",
        unit: "rad/s",
        doc: "rate of angle of the section, at port driven",
    },
    Quantity {
        name: "saws.end_dot",
        unit: "rad/s",
        doc: "rate of angle of the section, at port end",
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

static STATE_SCALES: [f64; STATES] = [
    150.0,
    150.0,
    150.0,
    78.5,
    78.5,
    78.5,
    1.0,
    1.0,
    1.0,
    1.0,
];

static PARAMETER_QUANTITIES: [Quantity<'static>; PARAMETERS] = [
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
        name: "saws.length",
        unit: "m",
        doc: "length",
    },
    Quantity {
        name: "saws.inertia",
        unit: "kg m^2",
        doc: "moment of inertia of the cylinder",
    },
    Quantity {
        name: "saws.shear_modulus",
        unit: "Pa",
        doc: "shear modulus",
    },
    Quantity {
        name: "saws.polar_moment",
        unit: "m^4",
        doc: "polar moment of the section",
    },
    Quantity {
        name: "saws.damping_time",
        unit: "s",
        doc: "Kelvin-Voigt damping time; ours",
    },
    Quantity {
        name: "saws.mean",
        unit: "N m",
        doc: "mean load",
    },
    Quantity {
        name: "saws.amplitude",
        unit: "N m",
        doc: "harmonic part of the load",
    },
    Quantity {
        name: "saws.speed",
        unit: "1",
        doc: "rated speed, revolutions per minute",
    },
    Quantity {
        name: "saws.growing",
        unit: "1",
        doc: "share of the load that grows with x; 0 for an even one",
    },
    Quantity {
        name: "saws.engagement_time",
        unit: "s",
        doc: "time at which the load engages",
    },
    Quantity {
        name: "saws.engagement_width",
        unit: "s",
        doc: "time scale of engagement",
    },
    Quantity {
        name: "saws.standstill_band",
        unit: "rad/s",
        doc: "speed below which the load fades",
    },
    Quantity {
        name: "saws.driven_field_inertia",
        unit: "J s^2/(rad)^2",
        doc: "inertia of the field's node; the field sets it",
    },
    Quantity {
        name: "saws.driven_field_force",
        unit: "J/(rad)",
        doc: "force of the field on its node; the field sets it",
    },
    Quantity {
        name: "saws.driven_phi_x_before",
        unit: "rad/m",
        doc: "slope of the field before the port; the field sets it",
    },
    Quantity {
        name: "saws.driven_phi_x_after",
        unit: "rad/m",
        doc: "slope of the field after the port; the field sets it",
    },
    Quantity {
        name: "saws.end_field_inertia",
        unit: "J s^2/(rad)^2",
        doc: "inertia of the field's node; the field sets it",
    },
    Quantity {
        name: "saws.end_field_force",
        unit: "J/(rad)",
        doc: "force of the field on its node; the field sets it",
    },
    Quantity {
        name: "saws.end_phi_x_before",
        unit: "rad/m",
        doc: "slope of the field before the port; the field sets it",
    },
    Quantity {
        name: "saws.end_phi_x_after",
        unit: "rad/m",
        doc: "slope of the field after the port; the field sets it",
    },
];

static PARAMETER_DEFAULTS: [f64; PARAMETERS] = [
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
    23065.2,
    128.5346,
    1.0,
    2.322,
    1.244,
    8e10,
    9.817e-6,
    1e-5,
    843.72,
    78.78,
    735.0,
    0.0,
    1.2,
    0.02,
    0.5,
    1.0,
    0.0,
    0.0,
    0.0,
    1.0,
    0.0,
    0.0,
    0.0,
];

static OUTPUT_QUANTITIES: [Quantity<'static>; OUTPUTS] = [
    Quantity {
        name: "motor_speed",
        unit: "rad/s",
        doc: "rate of rotor angle",
    },
    Quantity {
        name: "driven_speed",
        unit: "rad/s",
        doc: "rate of angle of the section, at port driven",
    },
    Quantity {
        name: "end_speed",
        unit: "rad/s",
        doc: "rate of angle of the section, at port end",
    },
    Quantity {
        name: "twist",
        unit: "rad",
        doc: "twist of the shaft",
    },
    Quantity {
        name: "slope",
        unit: "rad/m",
        doc: "twist a length at the driven end",
    },
    Quantity {
        name: "motor_torque",
        unit: "N m",
        doc: "electromagnetic torque",
    },
    Quantity {
        name: "coupling_torque",
        unit: "N m",
        doc: "torque carried, on the driving side",
    },
    Quantity {
        name: "shaft_torque",
        unit: "N m",
        doc: "elastic torque in the shaft at its driven end",
    },
];

/// The run the spec asks for.
pub const RUN_DEFAULTS: RunDefaults<'static> = RunDefaults {
    from: 0.0,
    until: 2.0,
    points: 2001,
    rtol: 1e-7,
    method: "rodas5p",
};

/// The field saws.phi: angle of the section \[rad\].
///
/// One generic element: what acts at a point with u, u_x, u_t, u_xt at x. The loops over elements are the contract's.
pub mod saws_phi {
    #[allow(
        clippy::wildcard_imports,
        unused_imports,
        reason = "what a field needs of it"
    )]
    use super::*;
    /// Parameters that the field depends on.
    pub const PARAMETERS: [u32; 12] = [13, 14, 15, 16, 17, 18, 19, 20, 21, 22, 23, 24];
    /// m, the inertia a length.
    ///
    /// 1 operations.
    #[must_use]
    #[inline(always)]
    pub fn inertia<R: Real>(_x: R, p: &Parameters<R>) -> [R; 1] {
        [p.saws_inertia / p.saws_length]
    }
    /// dm/dx, then dm/dp of `PARAMETERS`.
    ///
    /// 4 operations.
    #[must_use]
    #[inline]
    pub fn inertia_gradient<R: Real>(_x: R, p: &Parameters<R>) -> [R; 13] {
        [
            R::literal(0.0),
            -(p.saws_inertia / (p.saws_length * p.saws_length)),
            R::literal(1.0) / p.saws_length,
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
        ]
    }
    /// Forces a length: f_0 = dL/du - dD/du_t + Q on u, f_1 = dL/du_x - dD/du_xt on u_x.
    ///
    /// 30 operations.
    #[must_use]
    #[inline]
    pub fn force<R: Real>(
        time: R,
        x: R,
        point: &FieldPoint<R>,
        p: &Parameters<R>,
    ) -> [R; 2] {
        let [_, phi_x, phi_dot, phi_x_dot] = *point;
        [
            -(p
                .saws_mean
                .add_product(
                    p.saws_amplitude,
                    (R::literal(0.328_986_813_369_645_25) * p.saws_speed * time).sin(),
                )
                * ((R::literal(1.0) - p.saws_growing) / p.saws_length)
                    .add_product(
                        R::literal(2.0) * p.saws_growing
                            / (p.saws_length * p.saws_length),
                        x,
                    ) * (R::literal(1.0) / p.saws_standstill_band * phi_dot).tanh()
                / (R::literal(1.0)
                    + (-(R::literal(1.0) / p.saws_engagement_width
                        * (time - p.saws_engagement_time)))
                        .exp())),
            -(p.saws_shear_modulus * p.saws_polar_moment
                * phi_x.add_product(p.saws_damping_time, phi_x_dot)),
        ]
    }
    /// Derivatives of f_0, then of f_1, with respect to u, u_x, u_t, u_xt.
    ///
    /// 32 operations.
    #[must_use]
    #[inline]
    pub fn force_jacobian<R: Real>(
        time: R,
        x: R,
        point: &FieldPoint<R>,
        p: &Parameters<R>,
    ) -> [R; 8] {
        let [_, _, phi_dot, _] = *point;
        let inverse_saws_standstill_band = R::literal(1.0) / p.saws_standstill_band;
        let t0 = (inverse_saws_standstill_band * phi_dot).tanh();
        let t1 = p.saws_shear_modulus * p.saws_polar_moment;
        [
            R::literal(0.0),
            R::literal(0.0),
            -(inverse_saws_standstill_band * R::literal(1.0).sub_product(t0, t0)
                * p
                    .saws_mean
                    .add_product(
                        p.saws_amplitude,
                        (R::literal(0.328_986_813_369_645_25) * p.saws_speed * time)
                            .sin(),
                    )
                * ((R::literal(1.0) - p.saws_growing) / p.saws_length)
                    .add_product(
                        R::literal(2.0) * p.saws_growing
                            / (p.saws_length * p.saws_length),
                        x,
                    )
                / (R::literal(1.0)
                    + (-(R::literal(1.0) / p.saws_engagement_width
                        * (time - p.saws_engagement_time)))
                        .exp())),
            R::literal(0.0),
            R::literal(0.0),
            -t1,
            R::literal(0.0),
            -(t1 * p.saws_damping_time),
        ]
    }
    /// Derivatives of f_0 and f_1 with respect to x, to t, then to `PARAMETERS`.
    ///
    /// 100 operations.
    #[must_use]
    #[inline]
    pub fn force_gradient<R: Real>(
        time: R,
        x: R,
        point: &FieldPoint<R>,
        p: &Parameters<R>,
    ) -> [R; 28] {
        let [_, phi_x, phi_dot, phi_x_dot] = *point;
        let t0 = R::literal(0.328_986_813_369_645_25) * p.saws_speed * time;
        let (t1, t2) = t0.sin_cos();
        let saws_length_squared = p.saws_length * p.saws_length;
        let t3 = p.saws_mean.add_product(p.saws_amplitude, t1);
        let t4 = R::literal(2.0) * p.saws_growing / saws_length_squared;
        let t5 = R::literal(1.0) - p.saws_growing;
        let t6 = (t5 / p.saws_length).add_product(t4, x);
        let time_minus_saws_engagement_time = time - p.saws_engagement_time;
        let inverse_saws_engagement_width = R::literal(1.0) / p.saws_engagement_width;
        let t7 = (-(inverse_saws_engagement_width * time_minus_saws_engagement_time))
            .exp();
        let t8 = R::literal(1.0) + t7;
        let t9 = (R::literal(1.0) / p.saws_standstill_band * phi_dot).tanh();
        let t10 = phi_x.add_product(p.saws_damping_time, phi_x_dot);
        let t11 = t8 * t8;
        let t12 = inverse_saws_engagement_width * t3 * t6 * t7 * t9 / t11;
        [
            -(t4 * t3 * t9 / t8),
            R::literal(0.0),
            -t12
                - R::literal(0.033_333_333_333_333_33) * p.saws_amplitude * p.saws_speed
                    * R::literal(core::f64::consts::PI * core::f64::consts::PI) * t6 * t2
                    * t9 / t8,
            R::literal(0.0),
            -(t3
                * (-(t5 / saws_length_squared))
                    .sub_product(
                        R::literal(4.0) * p.saws_growing
                            / (saws_length_squared * p.saws_length),
                        x,
                    ) * t9 / t8),
            R::literal(0.0),
            R::literal(0.0),
            R::literal(0.0),
            R::literal(0.0),
            -(p.saws_polar_moment * t10),
            R::literal(0.0),
            -(p.saws_shear_modulus * t10),
            R::literal(0.0),
            -(p.saws_shear_modulus * p.saws_polar_moment * phi_x_dot),
            -(t6 * t9 / t8),
            R::literal(0.0),
            -(t6 * t1 * t9 / t8),
            R::literal(0.0),
            -(R::literal(0.328_986_813_369_645_25) * p.saws_amplitude * time * t6 * t2
                * t9 / t8),
            R::literal(0.0),
            -(t3
                * (-(R::literal(1.0) / p.saws_length))
                    .add_product(R::literal(2.0) / saws_length_squared, x) * t9 / t8),
            R::literal(0.0),
            t12,
            R::literal(0.0),
            R::literal(1.0) / (p.saws_engagement_width * p.saws_engagement_width)
                * time_minus_saws_engagement_time * t3 * t6 * t7 * t9 / t11,
            R::literal(0.0),
            R::literal(1.0) / (p.saws_standstill_band * p.saws_standstill_band) * phi_dot
                * R::literal(1.0).sub_product(t9, t9) * t3 * t6 / t8,
            R::literal(0.0),
        ]
    }
    /// T and V a length \[J/m\].
    ///
    /// 8 operations.
    #[must_use]
    #[inline]
    pub fn energy<R: Real>(
        _time: R,
        _x: R,
        point: &FieldPoint<R>,
        p: &Parameters<R>,
    ) -> [R; 2] {
        let [_, phi_x, phi_dot, _] = *point;
        [
            R::literal(0.5) * p.saws_inertia / p.saws_length * (phi_dot * phi_dot),
            R::literal(0.5) * p.saws_shear_modulus * p.saws_polar_moment
                * (phi_x * phi_x),
        ]
    }
    /// Rate of V, power supplied and power dissipated, a length \[W/m\].
    ///
    /// 32 operations.
    #[must_use]
    #[inline]
    pub fn power<R: Real>(
        time: R,
        x: R,
        point: &FieldPoint<R>,
        p: &Parameters<R>,
    ) -> [R; 3] {
        let [_, phi_x, phi_dot, phi_x_dot] = *point;
        let t0 = p.saws_shear_modulus * p.saws_polar_moment;
        [
            t0 * phi_x * phi_x_dot,
            -(phi_dot
                * p
                    .saws_mean
                    .add_product(
                        p.saws_amplitude,
                        (R::literal(0.328_986_813_369_645_25) * p.saws_speed * time)
                            .sin(),
                    )
                * ((R::literal(1.0) - p.saws_growing) / p.saws_length)
                    .add_product(
                        R::literal(2.0) * p.saws_growing
                            / (p.saws_length * p.saws_length),
                        x,
                    ) * (R::literal(1.0) / p.saws_standstill_band * phi_dot).tanh()
                / (R::literal(1.0)
                    + (-(R::literal(1.0) / p.saws_engagement_width
                        * (time - p.saws_engagement_time)))
                        .exp())),
            t0 * p.saws_damping_time * (phi_x_dot * phi_x_dot),
        ]
    }
    /// x of the attachments, then the length \[m\].
    ///
    /// 0 operations.
    #[must_use]
    #[inline]
    pub fn places<R: Real>(p: &Parameters<R>) -> [R; 3] {
        [R::literal(0.0), p.saws_length, p.saws_length]
    }
    /// Derivatives of `places` with respect to `PARAMETERS`, row by row.
    ///
    /// 0 operations.
    #[must_use]
    #[inline]
    pub fn places_gradient<R: Real>(_p: &Parameters<R>) -> [R; 36] {
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
            R::literal(0.0),
            R::literal(1.0),
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
            R::literal(1.0),
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
        ]
    }
    /// u and u_t at the start.
    ///
    /// 0 operations.
    #[must_use]
    #[inline]
    pub fn initial<R: Real>(_x: R, _p: &Parameters<R>) -> [R; 2] {
        [R::literal(0.0), R::literal(0.0)]
    }
    /// f_0 alone, at many points.
    ///
    /// 17 operations for all points, 8 for each.
    pub fn on_value<R: Real>(
        time: R,
        at: &[R],
        u: &[R],
        u_t: &[R],
        p: &Parameters<R>,
        force: &mut [R],
    ) {
        let t0 = p
            .saws_mean
            .add_product(
                p.saws_amplitude,
                (R::literal(0.328_986_813_369_645_25) * p.saws_speed * time).sin(),
            );
        let t1 = R::literal(2.0) * p.saws_growing / (p.saws_length * p.saws_length);
        let t2 = (R::literal(1.0) - p.saws_growing) / p.saws_length;
        let t3 = R::literal(1.0)
            + (-(R::literal(1.0) / p.saws_engagement_width
                * (time - p.saws_engagement_time)))
                .exp();
        let inverse_saws_standstill_band = R::literal(1.0) / p.saws_standstill_band;
        for (((&x, _), &phi_dot), force) in at.iter().zip(u).zip(u_t).zip(force) {
            *force = -(t0 * t2.add_product(t1, x)
                * (inverse_saws_standstill_band * phi_dot).tanh() / t3);
        }
    }
    /// df_0/du and df_0/du_t, at many points.
    ///
    /// 17 operations for all points, 11 for each.
    pub fn on_value_jacobian<R: Real>(
        time: R,
        at: &[R],
        u: &[R],
        u_t: &[R],
        p: &Parameters<R>,
        by_u: &mut [R],
        by_u_t: &mut [R],
    ) {
        let t0 = p
            .saws_mean
            .add_product(
                p.saws_amplitude,
                (R::literal(0.328_986_813_369_645_25) * p.saws_speed * time).sin(),
            );
        let t1 = R::literal(2.0) * p.saws_growing / (p.saws_length * p.saws_length);
        let t2 = (R::literal(1.0) - p.saws_growing) / p.saws_length;
        let t3 = R::literal(1.0)
            + (-(R::literal(1.0) / p.saws_engagement_width
                * (time - p.saws_engagement_time)))
                .exp();
        let inverse_saws_standstill_band = R::literal(1.0) / p.saws_standstill_band;
        for ((((&x, _), &phi_dot), by_u), by_u_t) in at
            .iter()
            .zip(u)
            .zip(u_t)
            .zip(by_u)
            .zip(by_u_t)
        {
            let t0_2 = (inverse_saws_standstill_band * phi_dot).tanh();
            *by_u = R::literal(0.0);
            *by_u_t = -(inverse_saws_standstill_band
                * R::literal(1.0).sub_product(t0_2, t0_2) * t0 * t2.add_product(t1, x)
                / t3);
        }
    }
    /// df_0/dt, at many points.
    ///
    /// 23 operations for all points, 14 for each.
    pub fn on_value_by_time<R: Real>(
        time: R,
        at: &[R],
        u: &[R],
        u_t: &[R],
        p: &Parameters<R>,
        by_time: &mut [R],
    ) {
        let t0 = R::literal(0.328_986_813_369_645_25) * p.saws_speed * time;
        let (t1, t2) = t0.sin_cos();
        let t3 = R::literal(2.0) * p.saws_growing / (p.saws_length * p.saws_length);
        let t4 = (R::literal(1.0) - p.saws_growing) / p.saws_length;
        let inverse_saws_engagement_width = R::literal(1.0) / p.saws_engagement_width;
        let t5 = (-(inverse_saws_engagement_width * (time - p.saws_engagement_time)))
            .exp();
        let t6 = R::literal(1.0) + t5;
        let inverse_saws_standstill_band = R::literal(1.0) / p.saws_standstill_band;
        let t7 = t6 * t6;
        let t8 = inverse_saws_engagement_width
            * p.saws_mean.add_product(p.saws_amplitude, t1);
        let t9 = R::literal(0.033_333_333_333_333_33) * p.saws_amplitude * p.saws_speed
            * R::literal(core::f64::consts::PI * core::f64::consts::PI);
        for (((&x, _), &phi_dot), by_time) in at.iter().zip(u).zip(u_t).zip(by_time) {
            let t0 = t4.add_product(t3, x);
            let t1 = (inverse_saws_standstill_band * phi_dot).tanh();
            *by_time = -(t8 * t0 * t5 * t1 / t7) - t9 * t0 * t2 * t1 / t6;
        }
    }
    /// f_1 alone, at many points.
    ///
    /// 1 operations for all points, 4 for each.
    pub fn on_slope<R: Real>(u_x: &[R], u_xt: &[R], p: &Parameters<R>, force: &mut [R]) {
        let t0 = p.saws_shear_modulus * p.saws_polar_moment;
        for ((&phi_x, &phi_x_dot), force) in u_x.iter().zip(u_xt).zip(force) {
            *force = -(t0 * phi_x.add_product(p.saws_damping_time, phi_x_dot));
        }
    }
    /// df_1/du_x and df_1/du_xt, at many points.
    ///
    /// 4 operations for all points, 0 for each.
    pub fn on_slope_jacobian<R: Real>(
        u_x: &[R],
        u_xt: &[R],
        p: &Parameters<R>,
        by_u_x: &mut [R],
        by_u_xt: &mut [R],
    ) {
        let t0 = p.saws_shear_modulus * p.saws_polar_moment;
        let t1 = -t0;
        let t2 = -(t0 * p.saws_damping_time);
        for (((_, _), by_u_x), by_u_xt) in u_x.iter().zip(u_xt).zip(by_u_x).zip(by_u_xt)
        {
            *by_u_x = t1;
            *by_u_xt = t2;
        }
    }
}

impl<R: Real> FieldScene<R> for SawGinShaft {
    fn fields(&self) -> usize {
        1
    }
    fn field(&self, index: usize) -> FieldDescription<'_> {
        match index {
            0 => SAWS_PHI_FIELD,
            _ => no_field(index),
        }
    }
    fn field_inertia(&self, index: usize, x: R, parameters: &[R]) -> R {
        let p = parameters_of(parameters);
        let [inertia] = match index {
            0 => saws_phi::inertia(x, &p),
            _ => no_field(index),
        };
        inertia
    }
    fn field_initial(&self, index: usize, x: R, parameters: &[R]) -> [R; 2] {
        let p = parameters_of(parameters);
        match index {
            0 => saws_phi::initial(x, &p),
            _ => no_field(index),
        }
    }
    fn field_force(
        &self,
        index: usize,
        time: R,
        x: R,
        point: &FieldPoint<R>,
        parameters: &[R],
    ) -> [R; 2] {
        let p = parameters_of(parameters);
        match index {
            0 => saws_phi::force(time, x, point, &p),
            _ => no_field(index),
        }
    }
    fn field_force_jacobian(
        &self,
        index: usize,
        time: R,
        x: R,
        point: &FieldPoint<R>,
        parameters: &[R],
    ) -> [R; 8] {
        let p = parameters_of(parameters);
        match index {
            0 => saws_phi::force_jacobian(time, x, point, &p),
            _ => no_field(index),
        }
    }
    fn field_energy(
        &self,
        index: usize,
        time: R,
        x: R,
        point: &FieldPoint<R>,
        parameters: &[R],
    ) -> [R; 2] {
        let p = parameters_of(parameters);
        match index {
            0 => saws_phi::energy(time, x, point, &p),
            _ => no_field(index),
        }
    }
    fn field_power(
        &self,
        index: usize,
        time: R,
        x: R,
        point: &FieldPoint<R>,
        parameters: &[R],
    ) -> [R; 3] {
        let p = parameters_of(parameters);
        match index {
            0 => saws_phi::power(time, x, point, &p),
            _ => no_field(index),
        }
    }
    fn field_inertia_gradient(
        &self,
        index: usize,
        x: R,
        parameters: &[R],
        values: &mut [R],
    ) {
        let p = parameters_of(parameters);
        match index {
            0 => values.copy_from_slice(&saws_phi::inertia_gradient(x, &p)),
            _ => no_field(index),
        }
    }
    fn field_force_gradient(
        &self,
        index: usize,
        time: R,
        x: R,
        point: &FieldPoint<R>,
        parameters: &[R],
        values: &mut [R],
    ) {
        let p = parameters_of(parameters);
        match index {
            0 => values.copy_from_slice(&saws_phi::force_gradient(time, x, point, &p)),
            _ => no_field(index),
        }
    }
    fn field_places(&self, index: usize, parameters: &[R], values: &mut [R]) {
        let p = parameters_of(parameters);
        match index {
            0 => values.copy_from_slice(&saws_phi::places(&p)),
            _ => no_field(index),
        }
    }
    fn field_places_gradient(&self, index: usize, parameters: &[R], values: &mut [R]) {
        let p = parameters_of(parameters);
        match index {
            0 => values.copy_from_slice(&saws_phi::places_gradient(&p)),
            _ => no_field(index),
        }
    }
    fn jacobian_reads_forces(&self) -> bool {
        false
    }
    fn field_is_local(&self, index: usize) -> bool {
        matches!(index, 0)
    }
    fn field_inertias(
        &self,
        index: usize,
        x: &[R],
        parameters: &[R],
        inertias: &mut [R],
    ) {
        let p = parameters_of(parameters);
        match index {
            0 => {
                for (inertia, x) in inertias.iter_mut().zip(x) {
                    [*inertia] = saws_phi::inertia(*x, &p);
                }
            }
            _ => no_field(index),
        }
    }
    fn field_forces_on_values(
        &self,
        index: usize,
        time: R,
        [x,
        u,
        u_t,
        ]: [&[R]; 3],
        parameters: &[R],
        forces: &mut [R],
    ) {
        let p = parameters_of(parameters);
        match index {
            0 => saws_phi::on_value(time, x, u, u_t, &p, forces),
            _ => no_field(index),
        }
    }
    fn field_forces_on_values_jacobian(
        &self,
        index: usize,
        time: R,
        [x,
        u,
        u_t,
        ]: [&[R]; 3],
        parameters: &[R],
        [by_u,
        by_u_t,
        ]: [&mut [R]; 2],
    ) {
        let p = parameters_of(parameters);
        match index {
            0 => saws_phi::on_value_jacobian(time, x, u, u_t, &p, by_u, by_u_t),
            _ => no_field(index),
        }
    }
    fn field_forces_on_values_by_time(
        &self,
        index: usize,
        time: R,
        [x,
        u,
        u_t,
        ]: [&[R]; 3],
        parameters: &[R],
        (_, by_time): (&mut [R], &mut [R]),
    ) {
        let p = parameters_of(parameters);
        match index {
            0 => saws_phi::on_value_by_time(time, x, u, u_t, &p, by_time),
            _ => no_field(index),
        }
    }
    fn field_forces_on_slopes(
        &self,
        index: usize,
        [u_x,
        u_xt,
        ]: [&[R]; 2],
        parameters: &[R],
        forces: &mut [R],
    ) {
        let p = parameters_of(parameters);
        match index {
            0 => saws_phi::on_slope(u_x, u_xt, &p, forces),
            _ => no_field(index),
        }
    }
    fn field_forces_on_slopes_jacobian(
        &self,
        index: usize,
        [u_x,
        u_xt,
        ]: [&[R]; 2],
        parameters: &[R],
        [by_u_x,
        by_u_xt,
        ]: [&mut [R]; 2],
    ) {
        let p = parameters_of(parameters);
        match index {
            0 => saws_phi::on_slope_jacobian(u_x, u_xt, &p, by_u_x, by_u_xt),
            _ => no_field(index),
        }
    }
}

#[cold]
fn no_field(index: usize) -> ! {
    panic!("there is no field of number {index}")
}

static SAWS_PHI_FIELD: FieldDescription<'static> = FieldDescription {
    value: Quantity {
        name: "saws.phi",
        unit: "rad",
        doc: "angle of the section",
    },
    rate: Quantity {
        name: "saws.phi_dot",
        unit: "rad/s",
        doc: "rate of angle of the section",
    },
    slope: Quantity {
        name: "saws.phi_x",
        unit: "rad/m",
        doc: "slope of angle of the section",
    },
    scale: [150.0, 78.5],
    fixed: [false, false],
    length: 2.322,
    attachments: &[
        FieldAttachment {
            coordinate: Some(1),
            place: FieldPlace::Start,
            at: 0.0,
            handed: 25,
        },
        FieldAttachment {
            coordinate: Some(2),
            place: FieldPlace::End,
            at: 2.322,
            handed: 29,
        },
    ],
    parameters: &saws_phi::PARAMETERS,
    elements: 8,
    order: 4,
};

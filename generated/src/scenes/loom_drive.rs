// Emitted by Machinist 0.1.0; do not edit. To make it again:
//
//     cargo run --release -- gen
//
// Sources, with SHA-256:
//   278eefca1ca3adf2bf4aead4b04e9df478dc6267e23e406596e32c0bf34fadfc  scenes/loom_drive.toml
//   fe2f2deb5f36655ff87e1d6f2bb763716b1c76007878e37e8e41643655074862  units/induction_motor.toml
//   a479b553f0542fe4aecc9e2a030097bc5b34e101f44a5e7297713fb52484327b  units/coupling.toml
//   210450c6c85a818c6e10138353cf1dfe5286ef742fc908308e77a3b605c3c704  units/loom_shaft.toml
//   f7986e73556e5a9af8b7a8f55072bbd9b2cd4e98c46b71cc2927a976f7158acd  units/reed.toml
//   5b1dbf2392d60b9814b89aff64ac087d3b9babc2b90f90772c08dad998dacad3  units/cloth_fell_contact.toml
//
// Loom: motor, coupling, shaft and reed in one machine
//
// An induction motor turns a crank through the coupling and a gear; the crank rocks the
// driven end of the reed's shaft through the drive spring, and the reed presses the cloth
// fell.
//
// Source:
//   Saw-gin study (2020) for motor and coupling; reed study for shaft and reed. Crank, gear and brake torque are ours.
//
// Shapes; all quantities are in SI units:
//   coordinates               6
//   first-order states        4
//   states                   16
//   parameters               39
//   outputs                   8
//   discontinuities           0
//
// State:
//     0  motor.phi         [rad]    rotor angle
//     1  crank.turn        [rad]    angle of the crank
//     2  shaft.driven      [rad]    angle of the section, at port driven
//     3  shaft.reed        [rad]    angle of the section, at port reed
//     4  shaft.middle      [rad]    angle of the section, at port middle
//     5  reed.angle        [rad]    angle of the reed
//     6  motor.omega       [rad/s]  rate of rotor angle
//     7  crank.turn_speed  [rad/s]  rate of angle of the crank
//     8  shaft.driven_dot  [rad/s]  rate of angle of the section, at port driven
//     9  shaft.reed_dot    [rad/s]  rate of angle of the section, at port reed
//    10  shaft.middle_dot  [rad/s]  rate of angle of the section, at port middle
//    11  reed.speed        [rad/s]  rate of angle of the reed
//    12  motor.psi_sx      [V s]    stator flux linkage along x
//    13  motor.psi_sy      [V s]    stator flux linkage along y
//    14  motor.psi_rx      [V s]    rotor flux linkage along x
//    15  motor.psi_ry      [V s]    rotor flux linkage along y
//
// Nonzeros:
//   mass_matrix               6 of 6 by 6
//   rate_jacobian            39 of 16 by 16
//   parameter_jacobian       47 of 16 by 39
//
// Operations:
//   initial_state             0
//   discontinuities           0
//   rate                     87
//   mass_matrix               2
//   forcing                  42
//   rate_jacobian            83
//   parameter_jacobian      189
//   time_derivative           0
//   outputs                  17
//   energy                   75
//   power_balance           187
// With constants of the parameters, prepared once a run:
//   prepare                  60
//   prepared_rate            61
//   prepared_rate_jacobian   29

use ::machinist_contract::{
    Describe, Energy, PowerBalance, Quantity, Real, RunDefaults, Shape, Simulator,
    SparsityPattern,
    field::{FieldAttachment, FieldDescription, FieldPlace, FieldPoint, FieldScene},
};

/// Generalized coordinates, n.
pub const COORDINATES: usize = 6;

/// Length of the state y.
pub const STATES: usize = 16;

/// Parameters.
pub const PARAMETERS: usize = 39;

/// Wanted outputs.
pub const OUTPUTS: usize = 8;

/// Times at which the right-hand side jumps.
pub const DISCONTINUITIES: usize = 0;

/// Nonzeros of M, both triangles.
pub const MASS_MATRIX_PATTERN: SparsityPattern<'static> = SparsityPattern {
    rows: 6,
    columns: 6,
    entries: &[(0, 0), (1, 1), (2, 2), (3, 3), (4, 4), (5, 5)],
};

/// Nonzeros of dy'/dy.
pub const RATE_JACOBIAN_PATTERN: SparsityPattern<'static> = SparsityPattern {
    rows: 16,
    columns: 16,
    entries: &[
        (0, 6), (1, 7), (2, 8), (3, 9), (4, 10), (5, 11), (6, 0), (6, 1), (6, 6), (6, 7), (6, 12),
        (6, 13), (6, 14), (6, 15), (7, 0), (7, 1), (7, 2), (7, 6), (7, 7), (8, 1), (8, 2), (9, 3),
        (9, 5), (11, 3), (11, 5), (12, 12), (12, 13), (12, 14), (13, 12), (13, 13), (13, 15),
        (14, 6), (14, 12), (14, 14), (14, 15), (15, 6), (15, 13), (15, 14), (15, 15),
    ],
};

/// Nonzeros of dy'/dp.
pub const PARAMETER_JACOBIAN_PATTERN: SparsityPattern<'static> = SparsityPattern {
    rows: 16,
    columns: 39,
    entries: &[
        (6, 0), (6, 2), (6, 4), (6, 5), (6, 6), (6, 7), (6, 10), (6, 11), (6, 12), (7, 10), (7, 11),
        (7, 12), (7, 13), (7, 14), (7, 15), (7, 16), (8, 14), (8, 15), (8, 27), (8, 28), (9, 25),
        (9, 31), (9, 32), (10, 35), (10, 36), (11, 23), (11, 24), (11, 25), (11, 26), (12, 1),
        (12, 2), (12, 3), (12, 6), (12, 8), (13, 1), (13, 2), (13, 3), (13, 6), (13, 8), (14, 2),
        (14, 4), (14, 5), (14, 9), (15, 2), (15, 4), (15, 5), (15, 9),
    ],
};

/// Loom: motor, coupling, shaft and reed in one machine
///
/// An induction motor turns a crank through the coupling and a gear; the crank rocks the
/// driven end of the reed's shaft through the drive spring, and the reed presses the cloth
/// fell.
///
/// Source: Saw-gin study (2020) for motor and coupling; reed study for shaft and reed. Crank, gear and brake torque are ours.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct LoomDrive;

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
    /// crank.inertia: inertia of crank and flywheel \[kg m^2\]. In the spec: 2.0.
    pub crank_inertia: R,
    /// crank.ratio: rocking angle of the drive, in rad, at full crank \[1\]. In the spec: 0.05.
    pub crank_ratio: R,
    /// crank.stiffness: drive spring \[N m/rad\]. In the spec: 45200.0.
    pub crank_stiffness: R,
    /// crank.drag: friction of the crank \[N m s/rad\]. In the spec: 0.5.
    pub crank_drag: R,
    /// shaft.length: half of the shaft's length \[m\]. In the spec: 1.75.
    pub shaft_length: R,
    /// shaft.reed_position: place of the reed \[m\]. In the spec: 1.0.
    pub shaft_reed_position: R,
    /// shaft.radius: radius \[m\]. In the spec: 0.025.
    pub shaft_radius: R,
    /// shaft.density: density \[kg/m^3\]. In the spec: 7659.0.
    pub shaft_density: R,
    /// shaft.shear_modulus: shear modulus, E/(2 (1 + nu)) with E = 2e11 Pa, nu = 0.3 \[Pa\]. In the spec: 76923076923.07692.
    pub shaft_shear_modulus: R,
    /// shaft.damping_time: Kelvin-Voigt damping time \[s\]. In the spec: 1e-6.
    pub shaft_damping_time: R,
    /// reed.mass: mass \[kg\]. In the spec: 3.56.
    pub reed_mass: R,
    /// reed.arm: arm of the mass \[m\]. In the spec: 0.025.
    pub reed_arm: R,
    /// reed.stiffness: stiffness C1 of the spring between shaft and reed \[N m/rad\]. In the spec: 15600.0.
    pub reed_stiffness: R,
    /// fell.stiffness: stiffness C2 of the contact \[N m/rad\]. In the spec: 7800.0.
    pub fell_stiffness: R,
    /// shaft.driven_field_inertia: inertia of the field's node; the field sets it \[J s^2/(rad)^2\]. In the spec: 1.0.
    pub shaft_driven_field_inertia: R,
    /// shaft.driven_field_force: force of the field on its node; the field sets it \[J/(rad)\]. In the spec: 0.0.
    pub shaft_driven_field_force: R,
    /// shaft.driven_u_x_before: slope of the field before the port; the field sets it \[rad/m\]. In the spec: 0.0.
    pub shaft_driven_u_x_before: R,
    /// shaft.driven_u_x_after: slope of the field after the port; the field sets it \[rad/m\]. In the spec: 0.0.
    pub shaft_driven_u_x_after: R,
    /// shaft.reed_field_inertia: inertia of the field's node; the field sets it \[J s^2/(rad)^2\]. In the spec: 1.0.
    pub shaft_reed_field_inertia: R,
    /// shaft.reed_field_force: force of the field on its node; the field sets it \[J/(rad)\]. In the spec: 0.0.
    pub shaft_reed_field_force: R,
    /// shaft.reed_u_x_before: slope of the field before the port; the field sets it \[rad/m\]. In the spec: 0.0.
    pub shaft_reed_u_x_before: R,
    /// shaft.reed_u_x_after: slope of the field after the port; the field sets it \[rad/m\]. In the spec: 0.0.
    pub shaft_reed_u_x_after: R,
    /// shaft.middle_field_inertia: inertia of the field's node; the field sets it \[J s^2/(rad)^2\]. In the spec: 1.0.
    pub shaft_middle_field_inertia: R,
    /// shaft.middle_field_force: force of the field on its node; the field sets it \[J/(rad)\]. In the spec: 0.0.
    pub shaft_middle_field_force: R,
    /// shaft.middle_u_x_before: slope of the field before the port; the field sets it \[rad/m\]. In the spec: 0.0.
    pub shaft_middle_u_x_before: R,
    /// shaft.middle_u_x_after: slope of the field after the port; the field sets it \[rad/m\]. In the spec: 0.0.
    pub shaft_middle_u_x_after: R,
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
            crank_inertia: values[13],
            crank_ratio: values[14],
            crank_stiffness: values[15],
            crank_drag: values[16],
            shaft_length: values[17],
            shaft_reed_position: values[18],
            shaft_radius: values[19],
            shaft_density: values[20],
            shaft_shear_modulus: values[21],
            shaft_damping_time: values[22],
            reed_mass: values[23],
            reed_arm: values[24],
            reed_stiffness: values[25],
            fell_stiffness: values[26],
            shaft_driven_field_inertia: values[27],
            shaft_driven_field_force: values[28],
            shaft_driven_u_x_before: values[29],
            shaft_driven_u_x_after: values[30],
            shaft_reed_field_inertia: values[31],
            shaft_reed_field_force: values[32],
            shaft_reed_u_x_before: values[33],
            shaft_reed_u_x_after: values[34],
            shaft_middle_field_inertia: values[35],
            shaft_middle_field_force: values[36],
            shaft_middle_u_x_before: values[37],
            shaft_middle_u_x_after: values[38],
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
            self.crank_inertia,
            self.crank_ratio,
            self.crank_stiffness,
            self.crank_drag,
            self.shaft_length,
            self.shaft_reed_position,
            self.shaft_radius,
            self.shaft_density,
            self.shaft_shear_modulus,
            self.shaft_damping_time,
            self.reed_mass,
            self.reed_arm,
            self.reed_stiffness,
            self.fell_stiffness,
            self.shaft_driven_field_inertia,
            self.shaft_driven_field_force,
            self.shaft_driven_u_x_before,
            self.shaft_driven_u_x_after,
            self.shaft_reed_field_inertia,
            self.shaft_reed_field_force,
            self.shaft_reed_u_x_before,
            self.shaft_reed_u_x_after,
            self.shaft_middle_field_inertia,
            self.shaft_middle_field_force,
            self.shaft_middle_u_x_before,
            self.shaft_middle_u_x_after,
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
            crank_inertia: R::literal(2.0),
            crank_ratio: R::literal(0.05),
            crank_stiffness: R::literal(45200.0),
            crank_drag: R::literal(0.5),
            shaft_length: R::literal(1.75),
            shaft_reed_position: R::literal(1.0),
            shaft_radius: R::literal(0.025),
            shaft_density: R::literal(7659.0),
            shaft_shear_modulus: R::literal(7.692_307_692_307_692e10),
            shaft_damping_time: R::literal(1e-6),
            reed_mass: R::literal(3.56),
            reed_arm: R::literal(0.025),
            reed_stiffness: R::literal(15600.0),
            fell_stiffness: R::literal(7800.0),
            shaft_driven_field_inertia: R::literal(1.0),
            shaft_driven_field_force: R::literal(0.0),
            shaft_driven_u_x_before: R::literal(0.0),
            shaft_driven_u_x_after: R::literal(0.0),
            shaft_reed_field_inertia: R::literal(1.0),
            shaft_reed_field_force: R::literal(0.0),
            shaft_reed_u_x_before: R::literal(0.0),
            shaft_reed_u_x_after: R::literal(0.0),
            shaft_middle_field_inertia: R::literal(1.0),
            shaft_middle_field_force: R::literal(0.0),
            shaft_middle_u_x_before: R::literal(0.0),
            shaft_middle_u_x_after: R::literal(0.0),
        }
    }
}

/// Wanted outputs, in SI units.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Outputs<R> {
    /// motor_speed: rate of rotor angle \[rad/s\].
    pub motor_speed: R,
    /// crank_speed: rate of angle of the crank \[rad/s\].
    pub crank_speed: R,
    /// drive_angle: angle imposed on the drive spring \[rad\].
    pub drive_angle: R,
    /// shaft_angle: angle of the section, at port reed \[rad\].
    pub shaft_angle: R,
    /// reed_angle: angle of the reed \[rad\].
    pub reed_angle: R,
    /// stress_before: shear stress at the surface, on the driven side of the reed \[Pa\].
    pub stress_before: R,
    /// stress_after: shear stress at the surface, beyond the reed \[Pa\].
    pub stress_after: R,
    /// motor_torque: electromagnetic torque \[N m\].
    pub motor_torque: R,
}

impl<R: Real> Outputs<R> {
    /// From the numbers in their order.
    #[must_use]
    #[inline]
    pub fn from_array(values: [R; OUTPUTS]) -> Self {
        Self {
            motor_speed: values[0],
            crank_speed: values[1],
            drive_angle: values[2],
            shaft_angle: values[3],
            reed_angle: values[4],
            stress_before: values[5],
            stress_after: values[6],
            motor_torque: values[7],
        }
    }
    /// The numbers in their order.
    #[must_use]
    #[inline]
    pub fn to_array(self) -> [R; OUTPUTS] {
        [
            self.motor_speed,
            self.crank_speed,
            self.drive_angle,
            self.shaft_angle,
            self.reed_angle,
            self.stress_before,
            self.stress_after,
            self.motor_torque,
        ]
    }
}

/// Where to find what in the state.
pub mod state {
    /// motor.phi: rotor angle \[rad\].
    pub const MOTOR_PHI: usize = 0;
    /// crank.turn: angle of the crank \[rad\].
    pub const CRANK_TURN: usize = 1;
    /// shaft.driven: angle of the section, at port driven \[rad\].
    pub const SHAFT_DRIVEN: usize = 2;
    /// shaft.reed: angle of the section, at port reed \[rad\].
    pub const SHAFT_REED: usize = 3;
    /// shaft.middle: angle of the section, at port middle \[rad\].
    pub const SHAFT_MIDDLE: usize = 4;
    /// reed.angle: angle of the reed \[rad\].
    pub const REED_ANGLE: usize = 5;
    /// motor.omega: rate of rotor angle \[rad/s\].
    pub const MOTOR_OMEGA: usize = 6;
    /// crank.turn_speed: rate of angle of the crank \[rad/s\].
    pub const CRANK_TURN_SPEED: usize = 7;
    /// shaft.driven_dot: rate of angle of the section, at port driven \[rad/s\].
    pub const SHAFT_DRIVEN_DOT: usize = 8;
    /// shaft.reed_dot: rate of angle of the section, at port reed \[rad/s\].
    pub const SHAFT_REED_DOT: usize = 9;
    /// shaft.middle_dot: rate of angle of the section, at port middle \[rad/s\].
    pub const SHAFT_MIDDLE_DOT: usize = 10;
    /// reed.speed: rate of angle of the reed \[rad/s\].
    pub const REED_SPEED: usize = 11;
    /// motor.psi_sx: stator flux linkage along x \[V s\].
    pub const MOTOR_PSI_SX: usize = 12;
    /// motor.psi_sy: stator flux linkage along y \[V s\].
    pub const MOTOR_PSI_SY: usize = 13;
    /// motor.psi_rx: rotor flux linkage along x \[V s\].
    pub const MOTOR_PSI_RX: usize = 14;
    /// motor.psi_ry: rotor flux linkage along y \[V s\].
    pub const MOTOR_PSI_RY: usize = 15;
}

/// Constants that `prepare` computes.
pub const CONSTANTS: usize = 35;

#[allow(missing_docs, reason = "`prepare` says what each is")]
/// What parameters alone decide; `prepare` says what each is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Constants<R> {
    pub motor_omega_0: R,
    pub motor_u_x: R,
    pub motor_u_y: R,
    pub t2: R,
    pub inverse_motor_inertia: R,
    pub inverse_crank_inertia: R,
    pub inverse_shaft_driven_field_inertia: R,
    pub inverse_shaft_reed_field_inertia: R,
    pub inverse_shaft_middle_field_inertia: R,
    pub t3: R,
    pub t4: R,
    pub crank_ratio_times_crank_stiffness: R,
    pub t5: R,
    pub motor_alpha_s_times_motor_omega_0: R,
    pub motor_alpha_r_times_motor_omega_0: R,
    pub crank_turn_speed_dot_by_motor_phi: R,
    pub motor_omega_dot_by_motor_phi: R,
    pub t6: R,
    pub t7: R,
    pub motor_omega_dot_by_crank_turn: R,
    pub shaft_driven_dot_dot_by_shaft_driven: R,
    pub reed_speed_dot_by_shaft_reed: R,
    pub t8: R,
    pub shaft_reed_dot_dot_by_shaft_reed: R,
    pub reed_speed_dot_by_reed_angle: R,
    pub crank_turn_speed_dot_by_motor_omega: R,
    pub motor_omega_dot_by_motor_omega: R,
    pub crank_turn_speed_dot_by_crank_turn_speed: R,
    pub motor_omega_dot_by_crank_turn_speed: R,
    pub t9: R,
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
            inverse_crank_inertia: values[5],
            inverse_shaft_driven_field_inertia: values[6],
            inverse_shaft_reed_field_inertia: values[7],
            inverse_shaft_middle_field_inertia: values[8],
            t3: values[9],
            t4: values[10],
            crank_ratio_times_crank_stiffness: values[11],
            t5: values[12],
            motor_alpha_s_times_motor_omega_0: values[13],
            motor_alpha_r_times_motor_omega_0: values[14],
            crank_turn_speed_dot_by_motor_phi: values[15],
            motor_omega_dot_by_motor_phi: values[16],
            t6: values[17],
            t7: values[18],
            motor_omega_dot_by_crank_turn: values[19],
            shaft_driven_dot_dot_by_shaft_driven: values[20],
            reed_speed_dot_by_shaft_reed: values[21],
            t8: values[22],
            shaft_reed_dot_dot_by_shaft_reed: values[23],
            reed_speed_dot_by_reed_angle: values[24],
            crank_turn_speed_dot_by_motor_omega: values[25],
            motor_omega_dot_by_motor_omega: values[26],
            crank_turn_speed_dot_by_crank_turn_speed: values[27],
            motor_omega_dot_by_crank_turn_speed: values[28],
            t9: values[29],
            motor_psi_sx_dot_by_motor_psi_sx: values[30],
            motor_psi_sy_dot_by_motor_psi_sx: values[31],
            motor_psi_rx_dot_by_motor_psi_sx: values[32],
            motor_psi_sx_dot_by_motor_psi_rx: values[33],
            motor_psi_rx_dot_by_motor_psi_rx: values[34],
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
            self.inverse_crank_inertia,
            self.inverse_shaft_driven_field_inertia,
            self.inverse_shaft_reed_field_inertia,
            self.inverse_shaft_middle_field_inertia,
            self.t3,
            self.t4,
            self.crank_ratio_times_crank_stiffness,
            self.t5,
            self.motor_alpha_s_times_motor_omega_0,
            self.motor_alpha_r_times_motor_omega_0,
            self.crank_turn_speed_dot_by_motor_phi,
            self.motor_omega_dot_by_motor_phi,
            self.t6,
            self.t7,
            self.motor_omega_dot_by_crank_turn,
            self.shaft_driven_dot_dot_by_shaft_driven,
            self.reed_speed_dot_by_shaft_reed,
            self.t8,
            self.shaft_reed_dot_dot_by_shaft_reed,
            self.reed_speed_dot_by_reed_angle,
            self.crank_turn_speed_dot_by_motor_omega,
            self.motor_omega_dot_by_motor_omega,
            self.crank_turn_speed_dot_by_crank_turn_speed,
            self.motor_omega_dot_by_crank_turn_speed,
            self.t9,
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
/// 60 operations.
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
    let inverse_crank_inertia = R::literal(1.0) / p.crank_inertia;
    let inverse_shaft_driven_field_inertia = R::literal(1.0)
        / p.shaft_driven_field_inertia;
    let inverse_shaft_reed_field_inertia = R::literal(1.0) / p.shaft_reed_field_inertia;
    let inverse_shaft_middle_field_inertia = R::literal(1.0)
        / p.shaft_middle_field_inertia;
    let t3 = R::literal(1.0) / (p.reed_mass * (p.reed_arm * p.reed_arm));
    let t4 = p.coupling_stiffness * p.coupling_ratio;
    let crank_ratio_times_crank_stiffness = p.crank_ratio * p.crank_stiffness;
    let t5 = p.coupling_damping * p.coupling_ratio;
    let motor_alpha_s_times_motor_omega_0 = p.motor_alpha_s * motor_omega_0;
    let motor_alpha_r_times_motor_omega_0 = p.motor_alpha_r * motor_omega_0;
    let crank_turn_speed_dot_by_motor_phi = t4 * inverse_crank_inertia;
    let motor_omega_dot_by_motor_phi = -(p.coupling_stiffness * inverse_motor_inertia);
    let coupling_ratio_squared = p.coupling_ratio * p.coupling_ratio;
    let t6 = p.coupling_stiffness * coupling_ratio_squared;
    let t7 = p.crank_stiffness * (p.crank_ratio * p.crank_ratio);
    let motor_omega_dot_by_crank_turn = t4 * inverse_motor_inertia;
    let shaft_driven_dot_dot_by_shaft_driven = -(p.crank_stiffness
        * inverse_shaft_driven_field_inertia);
    let reed_speed_dot_by_shaft_reed = p.reed_stiffness * t3;
    let t8 = p.reed_stiffness * inverse_shaft_reed_field_inertia;
    let shaft_reed_dot_dot_by_shaft_reed = -t8;
    let reed_speed_dot_by_reed_angle = -((p.reed_stiffness + p.fell_stiffness) * t3);
    let crank_turn_speed_dot_by_motor_omega = t5 * inverse_crank_inertia;
    let motor_omega_dot_by_motor_omega = -(p.coupling_damping * inverse_motor_inertia);
    let crank_turn_speed_dot_by_crank_turn_speed = -(p
        .crank_drag
        .add_product(p.coupling_damping, coupling_ratio_squared)
        * inverse_crank_inertia);
    let motor_omega_dot_by_crank_turn_speed = t5 * inverse_motor_inertia;
    let t9 = t1 / (p.motor_x_s * (motor_k_s_times_motor_k_r - R::literal(1.0)));
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
        inverse_crank_inertia,
        inverse_shaft_driven_field_inertia,
        inverse_shaft_reed_field_inertia,
        inverse_shaft_middle_field_inertia,
        t3,
        t4,
        crank_ratio_times_crank_stiffness,
        t5,
        motor_alpha_s_times_motor_omega_0,
        motor_alpha_r_times_motor_omega_0,
        crank_turn_speed_dot_by_motor_phi,
        motor_omega_dot_by_motor_phi,
        t6,
        t7,
        motor_omega_dot_by_crank_turn,
        shaft_driven_dot_dot_by_shaft_driven,
        reed_speed_dot_by_shaft_reed,
        t8,
        shaft_reed_dot_dot_by_shaft_reed,
        reed_speed_dot_by_reed_angle,
        crank_turn_speed_dot_by_motor_omega,
        motor_omega_dot_by_motor_omega,
        crank_turn_speed_dot_by_crank_turn_speed,
        motor_omega_dot_by_crank_turn_speed,
        t9,
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
/// 87 operations.
#[must_use]
#[inline]
pub fn rate<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>) -> [R; STATES] {
    prepared_rate(time, state, p, &prepare(p))
}

/// As `rate`, with the constants of the parameters from `prepare`.
///
/// 61 operations.
#[must_use]
#[inline]
pub fn prepared_rate<R: Real>(
    _time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
    c: &Constants<R>,
) -> [R; STATES] {
    let [motor_phi, crank_turn, shaft_driven, shaft_reed, _, reed_angle, motor_omega,
    crank_turn_speed, shaft_driven_dot, shaft_reed_dot, shaft_middle_dot, reed_speed,
    motor_psi_sx, motor_psi_sy, motor_psi_rx, motor_psi_ry] = *state;
    let (sin_crank_turn, cos_crank_turn) = crank_turn.sin_cos();
    let fell_torque = p.fell_stiffness * reed_angle;
    let crank_angle = p.crank_ratio * sin_crank_turn;
    let coupling_twist = motor_phi.sub_product(p.coupling_ratio, crank_turn);
    let coupling_twist_rate = motor_omega
        .sub_product(p.coupling_ratio, crank_turn_speed);
    let motor_slip_speed = c.motor_omega_0.sub_product(p.motor_pole_pairs, motor_omega);
    let coupling_torque = (p.coupling_stiffness * coupling_twist)
        .add_product(p.coupling_damping, coupling_twist_rate);
    let motor_torque = c.t2
        * (motor_psi_sy * motor_psi_rx).sub_product(motor_psi_sx, motor_psi_ry);
    let shaft_driven_minus_crank_angle = shaft_driven - crank_angle;
    let t0 = p.reed_stiffness * (shaft_reed - reed_angle);
    let reed_speed_dot = (t0 - fell_torque) * c.t3;
    let shaft_middle_dot_dot = p.shaft_middle_field_force
        * c.inverse_shaft_middle_field_inertia;
    let shaft_reed_dot_dot = (p.shaft_reed_field_force - t0)
        * c.inverse_shaft_reed_field_inertia;
    let shaft_driven_dot_dot = p
        .shaft_driven_field_force
        .sub_product(p.crank_stiffness, shaft_driven_minus_crank_angle)
        * c.inverse_shaft_driven_field_inertia;
    let crank_turn_speed_dot = ((c.t4 * coupling_twist)
        .add_product(
            c.crank_ratio_times_crank_stiffness * shaft_driven_minus_crank_angle,
            cos_crank_turn,
        ) - (p.crank_drag * crank_turn_speed).sub_product(c.t5, coupling_twist_rate))
        * c.inverse_crank_inertia;
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
        crank_turn_speed,
        shaft_driven_dot,
        shaft_reed_dot,
        shaft_middle_dot,
        reed_speed,
        motor_omega_dot,
        crank_turn_speed_dot,
        shaft_driven_dot_dot,
        shaft_reed_dot_dot,
        shaft_middle_dot_dot,
        reed_speed_dot,
        motor_psi_sx_dot,
        motor_psi_sy_dot,
        motor_psi_rx_dot,
        motor_psi_ry_dot,
    ]
}

/// `M = d2L/dq'2`, values in the order of `MASS_MATRIX_PATTERN`.
///
/// 2 operations.
#[must_use]
pub fn mass_matrix<R: Real>(
    _time: R,
    _state: &[R; STATES],
    p: &Parameters<R>,
) -> [R; 6] {
    [
        p.motor_inertia,
        p.crank_inertia,
        p.shaft_driven_field_inertia,
        p.shaft_reed_field_inertia,
        p.shaft_middle_field_inertia,
        p.reed_mass * (p.reed_arm * p.reed_arm),
    ]
}

/// `f` of `M q'' = f(q, q', z, t)`, one for each coordinate.
///
/// 42 operations.
#[must_use]
pub fn forcing<R: Real>(
    _time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
) -> [R; COORDINATES] {
    let [motor_phi, crank_turn, shaft_driven, shaft_reed, _, reed_angle, motor_omega,
    crank_turn_speed, _, _, _, _, motor_psi_sx, motor_psi_sy, motor_psi_rx, motor_psi_ry,
    ] = *state;
    let (sin_crank_turn, cos_crank_turn) = crank_turn.sin_cos();
    let fell_torque = p.fell_stiffness * reed_angle;
    let motor_omega_0 = R::literal(core::f64::consts::TAU) * p.motor_supply_frequency;
    let crank_angle = p.crank_ratio * sin_crank_turn;
    let motor_sigma = R::literal(1.0).sub_product(p.motor_k_s, p.motor_k_r);
    let coupling_twist = motor_phi.sub_product(p.coupling_ratio, crank_turn);
    let coupling_twist_rate = motor_omega
        .sub_product(p.coupling_ratio, crank_turn_speed);
    let coupling_torque = (p.coupling_stiffness * coupling_twist)
        .add_product(p.coupling_damping, coupling_twist_rate);
    let motor_torque = R::literal(1.5) * p.motor_pole_pairs * p.motor_k_r * motor_omega_0
        / (p.motor_x_s * motor_sigma)
        * (motor_psi_sy * motor_psi_rx).sub_product(motor_psi_sx, motor_psi_ry);
    let motor_phi_forcing = motor_torque - coupling_torque;
    let shaft_driven_minus_crank_angle = shaft_driven - crank_angle;
    let crank_turn_forcing = (p.coupling_stiffness * p.coupling_ratio * coupling_twist)
        .add_product(
            p.crank_ratio * p.crank_stiffness * shaft_driven_minus_crank_angle,
            cos_crank_turn,
        )
        - (p.crank_drag * crank_turn_speed)
            .sub_product(p.coupling_damping * p.coupling_ratio, coupling_twist_rate);
    let shaft_driven_forcing = p
        .shaft_driven_field_force
        .sub_product(p.crank_stiffness, shaft_driven_minus_crank_angle);
    let t0 = p.reed_stiffness * (shaft_reed - reed_angle);
    let shaft_reed_forcing = p.shaft_reed_field_force - t0;
    let reed_angle_forcing = t0 - fell_torque;
    [
        motor_phi_forcing,
        crank_turn_forcing,
        shaft_driven_forcing,
        shaft_reed_forcing,
        p.shaft_middle_field_force,
        reed_angle_forcing,
    ]
}

/// `dy'/dy`, values in the order of `RATE_JACOBIAN_PATTERN`.
///
/// 83 operations.
#[must_use]
#[inline]
pub fn rate_jacobian<R: Real>(
    time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
) -> [R; 39] {
    prepared_rate_jacobian(time, state, p, &prepare(p))
}

/// As `rate_jacobian`, with the constants of the parameters from `prepare`.
///
/// 29 operations.
#[must_use]
pub fn prepared_rate_jacobian<R: Real>(
    _time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
    c: &Constants<R>,
) -> [R; 39] {
    let [_, crank_turn, shaft_driven, _, _, _, motor_omega, _, _, _, _, _, motor_psi_sx,
    motor_psi_sy, motor_psi_rx, motor_psi_ry] = *state;
    let (sin_crank_turn, cos_crank_turn) = crank_turn.sin_cos();
    let crank_angle = p.crank_ratio * sin_crank_turn;
    let motor_pole_pairs_times_motor_omega = p.motor_pole_pairs * motor_omega;
    let motor_slip_speed = c.motor_omega_0 - motor_pole_pairs_times_motor_omega;
    let t0 = c.crank_ratio_times_crank_stiffness * cos_crank_turn;
    let shaft_driven_dot_dot_by_crank_turn = t0 * c.inverse_shaft_driven_field_inertia;
    let crank_turn_speed_dot_by_crank_turn = -(c
        .t6
        .add_product(p.crank_stiffness * crank_angle, shaft_driven - crank_angle)
        .add_product(c.t7, cos_crank_turn * cos_crank_turn) * c.inverse_crank_inertia);
    let crank_turn_speed_dot_by_shaft_driven = t0 * c.inverse_crank_inertia;
    let motor_psi_rx_dot_by_motor_omega = -(p.motor_pole_pairs * motor_psi_ry);
    let motor_psi_ry_dot_by_motor_omega = p.motor_pole_pairs * motor_psi_rx;
    let motor_omega_dot_by_motor_psi_sx = c.t9 * motor_psi_ry * c.inverse_motor_inertia;
    let motor_omega_dot_by_motor_psi_sy = c.t2 * motor_psi_rx * c.inverse_motor_inertia;
    let motor_omega_dot_by_motor_psi_rx = c.t2 * motor_psi_sy * c.inverse_motor_inertia;
    let motor_psi_ry_dot_by_motor_psi_rx = motor_pole_pairs_times_motor_omega
        - c.motor_omega_0;
    let motor_omega_dot_by_motor_psi_ry = c.t9 * motor_psi_sx * c.inverse_motor_inertia;
    [
        R::literal(1.0),
        R::literal(1.0),
        R::literal(1.0),
        R::literal(1.0),
        R::literal(1.0),
        R::literal(1.0),
        c.motor_omega_dot_by_motor_phi,
        c.motor_omega_dot_by_crank_turn,
        c.motor_omega_dot_by_motor_omega,
        c.motor_omega_dot_by_crank_turn_speed,
        motor_omega_dot_by_motor_psi_sx,
        motor_omega_dot_by_motor_psi_sy,
        motor_omega_dot_by_motor_psi_rx,
        motor_omega_dot_by_motor_psi_ry,
        c.crank_turn_speed_dot_by_motor_phi,
        crank_turn_speed_dot_by_crank_turn,
        crank_turn_speed_dot_by_shaft_driven,
        c.crank_turn_speed_dot_by_motor_omega,
        c.crank_turn_speed_dot_by_crank_turn_speed,
        shaft_driven_dot_dot_by_crank_turn,
        c.shaft_driven_dot_dot_by_shaft_driven,
        c.shaft_reed_dot_dot_by_shaft_reed,
        c.t8,
        c.reed_speed_dot_by_shaft_reed,
        c.reed_speed_dot_by_reed_angle,
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
/// 189 operations.
#[must_use]
pub fn parameter_jacobian<R: Real>(
    _time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
) -> [R; 47] {
    let [motor_phi, crank_turn, shaft_driven, shaft_reed, _, reed_angle, motor_omega,
    crank_turn_speed, _, _, _, _, motor_psi_sx, motor_psi_sy, motor_psi_rx, motor_psi_ry,
    ] = *state;
    let [(sin_crank_turn, cos_crank_turn),
    (sin_motor_supply_phase, cos_motor_supply_phase)] = R::sin_cos_each([
        crank_turn,
        p.motor_supply_phase,
    ]);
    let fell_torque = p.fell_stiffness * reed_angle;
    let motor_omega_0 = R::literal(core::f64::consts::TAU) * p.motor_supply_frequency;
    let crank_angle = p.crank_ratio * sin_crank_turn;
    let motor_k_s_times_motor_k_r = p.motor_k_s * p.motor_k_r;
    let motor_sigma = R::literal(1.0) - motor_k_s_times_motor_k_r;
    let t0 = p.motor_phase_voltage * R::literal(core::f64::consts::SQRT_2);
    let motor_u_x = t0 * cos_motor_supply_phase;
    let motor_u_y = t0 * sin_motor_supply_phase;
    let coupling_ratio_times_crank_turn = p.coupling_ratio * crank_turn;
    let coupling_twist = motor_phi - coupling_ratio_times_crank_turn;
    let t1 = p.coupling_ratio * crank_turn_speed;
    let coupling_twist_rate = motor_omega - t1;
    let coupling_torque = (p.coupling_stiffness * coupling_twist)
        .add_product(p.coupling_damping, coupling_twist_rate);
    let t2 = motor_psi_sx.sub_product(p.motor_k_r, motor_psi_rx);
    let motor_x_s_times_motor_sigma = p.motor_x_s * motor_sigma;
    let t3 = motor_psi_sy.sub_product(p.motor_k_r, motor_psi_ry);
    let motor_psi_sx_times_motor_psi_ry = motor_psi_sx * motor_psi_ry;
    let motor_psi_sy_times_motor_psi_rx = motor_psi_sy * motor_psi_rx;
    let t4 = motor_psi_sy_times_motor_psi_rx - motor_psi_sx_times_motor_psi_ry;
    let t5 = R::literal(1.5) * p.motor_pole_pairs;
    let motor_torque = t5 * p.motor_k_r * motor_omega_0 / motor_x_s_times_motor_sigma
        * t4;
    let reed_arm_squared = p.reed_arm * p.reed_arm;
    let inverse_motor_inertia = R::literal(1.0) / p.motor_inertia;
    let inverse_crank_inertia = R::literal(1.0) / p.crank_inertia;
    let inverse_shaft_driven_field_inertia = R::literal(1.0)
        / p.shaft_driven_field_inertia;
    let inverse_shaft_reed_field_inertia = R::literal(1.0) / p.shaft_reed_field_inertia;
    let inverse_shaft_middle_field_inertia = R::literal(1.0)
        / p.shaft_middle_field_inertia;
    let t6 = R::literal(1.0) / (p.reed_mass * reed_arm_squared);
    let shaft_driven_minus_crank_angle = shaft_driven - crank_angle;
    let shaft_reed_minus_reed_angle = shaft_reed - reed_angle;
    let t7 = p.reed_stiffness * shaft_reed_minus_reed_angle;
    let reed_speed_dot = (t7 - fell_torque) * t6;
    let shaft_middle_dot_dot = p.shaft_middle_field_force
        * inverse_shaft_middle_field_inertia;
    let shaft_reed_dot_dot = (p.shaft_reed_field_force - t7)
        * inverse_shaft_reed_field_inertia;
    let shaft_driven_dot_dot = p
        .shaft_driven_field_force
        .sub_product(p.crank_stiffness, shaft_driven_minus_crank_angle)
        * inverse_shaft_driven_field_inertia;
    let crank_turn_speed_dot = ((p.coupling_stiffness * p.coupling_ratio
        * coupling_twist)
        .add_product(
            p.crank_ratio * p.crank_stiffness * shaft_driven_minus_crank_angle,
            cos_crank_turn,
        )
        - (p.crank_drag * crank_turn_speed)
            .sub_product(p.coupling_damping * p.coupling_ratio, coupling_twist_rate))
        * inverse_crank_inertia;
    let motor_omega_dot = (motor_torque - coupling_torque) * inverse_motor_inertia;
    let motor_alpha_s_times_motor_omega_0 = p.motor_alpha_s * motor_omega_0;
    let t8 = (-motor_psi_rx).add_product(p.motor_k_s, motor_psi_sx);
    let motor_alpha_r_times_motor_omega_0 = p.motor_alpha_r * motor_omega_0;
    let t9 = (-motor_psi_ry).add_product(p.motor_k_s, motor_psi_sy);
    let t10 = motor_k_s_times_motor_k_r - R::literal(1.0);
    let motor_omega_dot_by_motor_inertia = -(motor_omega_dot * inverse_motor_inertia);
    let motor_psi_sx_dot_by_motor_phase_voltage = R::literal(core::f64::consts::SQRT_2)
        * cos_motor_supply_phase;
    let motor_psi_sy_dot_by_motor_phase_voltage = R::literal(core::f64::consts::SQRT_2)
        * sin_motor_supply_phase;
    let motor_omega_dot_by_motor_supply_frequency = R::literal(
        3.0 * core::f64::consts::PI,
    ) * p.motor_pole_pairs * p.motor_k_r / motor_x_s_times_motor_sigma * t4
        * inverse_motor_inertia;
    let t11 = R::literal(core::f64::consts::TAU) * p.motor_alpha_s;
    let motor_psi_sx_dot_by_motor_supply_frequency = (R::literal(core::f64::consts::TAU)
        * motor_psi_sy)
        .sub_product(t11, t2);
    let motor_psi_sy_dot_by_motor_supply_frequency = (-(R::literal(
        core::f64::consts::TAU,
    ) * motor_psi_sx))
        .sub_product(t11, t3);
    let t12 = R::literal(core::f64::consts::TAU) * p.motor_alpha_r;
    let motor_psi_rx_dot_by_motor_supply_frequency = (R::literal(core::f64::consts::TAU)
        * motor_psi_ry)
        .add_product(t12, t8);
    let motor_psi_ry_dot_by_motor_supply_frequency = (-(R::literal(
        core::f64::consts::TAU,
    ) * motor_psi_rx))
        .add_product(t12, t9);
    let motor_psi_sx_dot_by_motor_supply_phase = -motor_u_y;
    let motor_omega_dot_by_motor_pole_pairs = R::literal(1.5) * p.motor_k_r
        * motor_omega_0 / motor_x_s_times_motor_sigma * t4 * inverse_motor_inertia;
    let motor_psi_rx_dot_by_motor_pole_pairs = -(motor_omega * motor_psi_ry);
    let motor_psi_ry_dot_by_motor_pole_pairs = motor_omega * motor_psi_rx;
    let motor_omega_dot_by_motor_k_s = p.motor_k_r / motor_sigma * motor_torque
        * inverse_motor_inertia;
    let motor_psi_rx_dot_by_motor_k_s = motor_alpha_r_times_motor_omega_0 * motor_psi_sx;
    let motor_psi_ry_dot_by_motor_k_s = motor_alpha_r_times_motor_omega_0 * motor_psi_sy;
    let motor_omega_dot_by_motor_k_r = -(t5 * motor_omega_0 / (p.motor_x_s * (t10 * t10))
        * (motor_psi_sx_times_motor_psi_ry - motor_psi_sy_times_motor_psi_rx)
        * inverse_motor_inertia);
    let motor_psi_sx_dot_by_motor_k_r = motor_alpha_s_times_motor_omega_0 * motor_psi_rx;
    let motor_psi_sy_dot_by_motor_k_r = motor_alpha_s_times_motor_omega_0 * motor_psi_ry;
    let motor_omega_dot_by_motor_x_s = -(R::literal(1.0) / p.motor_x_s * motor_torque
        * inverse_motor_inertia);
    let motor_psi_sx_dot_by_motor_alpha_s = -(motor_omega_0 * t2);
    let motor_psi_sy_dot_by_motor_alpha_s = -(motor_omega_0 * t3);
    let motor_psi_rx_dot_by_motor_alpha_r = motor_omega_0 * t8;
    let motor_psi_ry_dot_by_motor_alpha_r = motor_omega_0 * t9;
    let crank_turn_speed_dot_by_coupling_stiffness = p.coupling_ratio * coupling_twist
        * inverse_crank_inertia;
    let motor_omega_dot_by_coupling_stiffness = (coupling_ratio_times_crank_turn
        - motor_phi) * inverse_motor_inertia;
    let crank_turn_speed_dot_by_coupling_damping = p.coupling_ratio * coupling_twist_rate
        * inverse_crank_inertia;
    let motor_omega_dot_by_coupling_damping = (t1 - motor_omega) * inverse_motor_inertia;
    let crank_turn_speed_dot_by_coupling_ratio = (p.coupling_stiffness * motor_phi)
        .add_product(p.coupling_damping, motor_omega)
        .sub_product(
            R::literal(2.0) * p.coupling_stiffness * p.coupling_ratio,
            crank_turn,
        )
        .sub_product(
            R::literal(2.0) * p.coupling_damping * p.coupling_ratio,
            crank_turn_speed,
        ) * inverse_crank_inertia;
    let motor_omega_dot_by_coupling_ratio = (p.coupling_stiffness * crank_turn)
        .add_product(p.coupling_damping, crank_turn_speed) * inverse_motor_inertia;
    let crank_turn_speed_dot_by_crank_inertia = -(crank_turn_speed_dot
        * inverse_crank_inertia);
    let shaft_driven_dot_dot_by_crank_ratio = p.crank_stiffness * sin_crank_turn
        * inverse_shaft_driven_field_inertia;
    let crank_turn_speed_dot_by_crank_ratio = p.crank_stiffness
        * shaft_driven.sub_product(R::literal(2.0), crank_angle) * cos_crank_turn
        * inverse_crank_inertia;
    let shaft_driven_dot_dot_by_crank_stiffness = (crank_angle - shaft_driven)
        * inverse_shaft_driven_field_inertia;
    let crank_turn_speed_dot_by_crank_stiffness = p.crank_ratio
        * shaft_driven_minus_crank_angle * cos_crank_turn * inverse_crank_inertia;
    let crank_turn_speed_dot_by_crank_drag = -(crank_turn_speed * inverse_crank_inertia);
    let reed_speed_dot_by_reed_mass = -(reed_arm_squared * reed_speed_dot * t6);
    let reed_speed_dot_by_reed_arm = -(R::literal(2.0) * p.reed_mass * p.reed_arm
        * reed_speed_dot * t6);
    let reed_speed_dot_by_reed_stiffness = shaft_reed_minus_reed_angle * t6;
    let shaft_reed_dot_dot_by_reed_stiffness = (reed_angle - shaft_reed)
        * inverse_shaft_reed_field_inertia;
    let reed_speed_dot_by_fell_stiffness = -(reed_angle * t6);
    let shaft_driven_dot_dot_by_shaft_driven_field_inertia = -(shaft_driven_dot_dot
        * inverse_shaft_driven_field_inertia);
    let shaft_reed_dot_dot_by_shaft_reed_field_inertia = -(shaft_reed_dot_dot
        * inverse_shaft_reed_field_inertia);
    let shaft_middle_dot_dot_by_shaft_middle_field_inertia = -(shaft_middle_dot_dot
        * inverse_shaft_middle_field_inertia);
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
        crank_turn_speed_dot_by_coupling_stiffness,
        crank_turn_speed_dot_by_coupling_damping,
        crank_turn_speed_dot_by_coupling_ratio,
        crank_turn_speed_dot_by_crank_inertia,
        crank_turn_speed_dot_by_crank_ratio,
        crank_turn_speed_dot_by_crank_stiffness,
        crank_turn_speed_dot_by_crank_drag,
        shaft_driven_dot_dot_by_crank_ratio,
        shaft_driven_dot_dot_by_crank_stiffness,
        shaft_driven_dot_dot_by_shaft_driven_field_inertia,
        inverse_shaft_driven_field_inertia,
        shaft_reed_dot_dot_by_reed_stiffness,
        shaft_reed_dot_dot_by_shaft_reed_field_inertia,
        inverse_shaft_reed_field_inertia,
        shaft_middle_dot_dot_by_shaft_middle_field_inertia,
        inverse_shaft_middle_field_inertia,
        reed_speed_dot_by_reed_mass,
        reed_speed_dot_by_reed_arm,
        reed_speed_dot_by_reed_stiffness,
        reed_speed_dot_by_fell_stiffness,
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
/// 17 operations.
#[must_use]
pub fn outputs<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>) -> Outputs<R> {
    let [_, crank_turn, _, shaft_reed, _, reed_angle, motor_omega, crank_turn_speed, _,
    _, _, _, motor_psi_sx, motor_psi_sy, motor_psi_rx, motor_psi_ry] = *state;
    let motor_omega_0 = R::literal(core::f64::consts::TAU) * p.motor_supply_frequency;
    let crank_angle = p.crank_ratio * crank_turn.sin();
    let motor_sigma = R::literal(1.0).sub_product(p.motor_k_s, p.motor_k_r);
    let motor_torque = R::literal(1.5) * p.motor_pole_pairs * p.motor_k_r * motor_omega_0
        / (p.motor_x_s * motor_sigma)
        * (motor_psi_sy * motor_psi_rx).sub_product(motor_psi_sx, motor_psi_ry);
    let t0 = p.shaft_radius * p.shaft_shear_modulus;
    Outputs {
        motor_speed: motor_omega,
        crank_speed: crank_turn_speed,
        drive_angle: crank_angle,
        shaft_angle: shaft_reed,
        reed_angle,
        stress_before: t0 * p.shaft_reed_u_x_before,
        stress_after: t0 * p.shaft_reed_u_x_after,
        motor_torque,
    }
}

/// T, V and the energy of first-order states \[J\].
///
/// 75 operations.
#[must_use]
pub fn energy<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>) -> Energy<R> {
    let [motor_phi, crank_turn, shaft_driven, shaft_reed, _, reed_angle, motor_omega,
    crank_turn_speed, shaft_driven_dot, shaft_reed_dot, shaft_middle_dot, reed_speed,
    motor_psi_sx, motor_psi_sy, motor_psi_rx, motor_psi_ry] = *state;
    let fell_torque = p.fell_stiffness * reed_angle;
    let motor_omega_0 = R::literal(core::f64::consts::TAU) * p.motor_supply_frequency;
    let crank_angle = p.crank_ratio * crank_turn.sin();
    let motor_sigma = R::literal(1.0).sub_product(p.motor_k_s, p.motor_k_r);
    let motor_x_r = p.motor_k_s * p.motor_x_s / p.motor_k_r;
    let coupling_twist = motor_phi.sub_product(p.coupling_ratio, crank_turn);
    let t0 = motor_omega_0 / (p.motor_x_s * motor_sigma);
    let motor_i_sx = t0 * motor_psi_sx.sub_product(p.motor_k_r, motor_psi_rx);
    let motor_i_sy = t0 * motor_psi_sy.sub_product(p.motor_k_r, motor_psi_ry);
    let t1 = motor_omega_0 / (motor_sigma * motor_x_r);
    let motor_i_rx = t1 * motor_psi_rx.sub_product(p.motor_k_s, motor_psi_sx);
    let motor_i_ry = t1 * motor_psi_ry.sub_product(p.motor_k_s, motor_psi_sy);
    let shaft_driven_minus_crank_angle = shaft_driven - crank_angle;
    let shaft_reed_minus_reed_angle = shaft_reed - reed_angle;
    Energy {
        kinetic: (R::literal(0.5) * p.motor_inertia * (motor_omega * motor_omega))
            .add_product(
                R::literal(0.5) * p.crank_inertia,
                crank_turn_speed * crank_turn_speed,
            )
            .add_product(
                R::literal(0.5) * p.reed_mass * (p.reed_arm * p.reed_arm),
                reed_speed * reed_speed,
            )
            .add_product(
                R::literal(0.5) * p.shaft_driven_field_inertia,
                shaft_driven_dot * shaft_driven_dot,
            )
            .add_product(
                R::literal(0.5) * p.shaft_reed_field_inertia,
                shaft_reed_dot * shaft_reed_dot,
            )
            .add_product(
                R::literal(0.5) * p.shaft_middle_field_inertia,
                shaft_middle_dot * shaft_middle_dot,
            ),
        potential: (R::literal(0.5) * reed_angle * fell_torque)
            .add_product(
                R::literal(0.5) * p.coupling_stiffness,
                coupling_twist * coupling_twist,
            )
            .add_product(
                R::literal(0.5) * p.crank_stiffness,
                shaft_driven_minus_crank_angle * shaft_driven_minus_crank_angle,
            )
            .add_product(
                R::literal(0.5) * p.reed_stiffness,
                shaft_reed_minus_reed_angle * shaft_reed_minus_reed_angle,
            ),
        stored: R::literal(0.75)
            * (motor_psi_sx * motor_i_sx)
                .add_product(motor_psi_sy, motor_i_sy)
                .add_product(motor_psi_rx, motor_i_rx)
                .add_product(motor_psi_ry, motor_i_ry),
    }
}

/// `dE/dt`, power supplied and power dissipated \[W\].
///
/// 187 operations.
#[must_use]
pub fn power_balance<R: Real>(
    _time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
) -> PowerBalance<R> {
    let [motor_phi, crank_turn, shaft_driven, shaft_reed, _, reed_angle, motor_omega,
    crank_turn_speed, shaft_driven_dot, shaft_reed_dot, shaft_middle_dot, reed_speed,
    motor_psi_sx, motor_psi_sy, motor_psi_rx, motor_psi_ry] = *state;
    let [(sin_crank_turn, cos_crank_turn),
    (sin_motor_supply_phase, cos_motor_supply_phase)] = R::sin_cos_each([
        crank_turn,
        p.motor_supply_phase,
    ]);
    let fell_torque = p.fell_stiffness * reed_angle;
    let motor_omega_0 = R::literal(core::f64::consts::TAU) * p.motor_supply_frequency;
    let crank_angle = p.crank_ratio * sin_crank_turn;
    let motor_sigma = R::literal(1.0).sub_product(p.motor_k_s, p.motor_k_r);
    let motor_x_r = p.motor_k_s * p.motor_x_s / p.motor_k_r;
    let t0 = p.motor_phase_voltage * R::literal(core::f64::consts::SQRT_2);
    let motor_u_x = t0 * cos_motor_supply_phase;
    let motor_u_y = t0 * sin_motor_supply_phase;
    let coupling_twist = motor_phi.sub_product(p.coupling_ratio, crank_turn);
    let coupling_twist_rate = motor_omega
        .sub_product(p.coupling_ratio, crank_turn_speed);
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
    let reed_mass_times_reed_arm_squared = p.reed_mass * (p.reed_arm * p.reed_arm);
    let t6 = p.coupling_stiffness * p.coupling_ratio * coupling_twist;
    let shaft_driven_minus_crank_angle = shaft_driven - crank_angle;
    let t7 = p.crank_ratio * p.crank_stiffness * shaft_driven_minus_crank_angle
        * cos_crank_turn;
    let t8 = (p.crank_drag * crank_turn_speed)
        .sub_product(p.coupling_damping * p.coupling_ratio, coupling_twist_rate);
    let t9 = p.crank_stiffness * shaft_driven_minus_crank_angle;
    let t10 = p.reed_stiffness * (shaft_reed - reed_angle);
    let reed_speed_dot = (t10 - fell_torque)
        * (R::literal(1.0) / reed_mass_times_reed_arm_squared);
    let shaft_middle_dot_dot = p.shaft_middle_field_force
        * (R::literal(1.0) / p.shaft_middle_field_inertia);
    let shaft_reed_dot_dot = (p.shaft_reed_field_force - t10)
        * (R::literal(1.0) / p.shaft_reed_field_inertia);
    let shaft_driven_dot_dot = (p.shaft_driven_field_force - t9)
        * (R::literal(1.0) / p.shaft_driven_field_inertia);
    let crank_turn_speed_dot = (t7 + t6 - t8) * (R::literal(1.0) / p.crank_inertia);
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
    let t11 = p.motor_k_r * motor_omega_0 / motor_x_s_times_motor_sigma;
    let t12 = (t1 * motor_omega)
        .add_product(-t6 - t7, crank_turn_speed)
        .add_product(t9, shaft_driven_dot)
        .add_product(t10, shaft_reed_dot)
        .add_product(fell_torque - t10, reed_speed)
        .add_product(p.motor_inertia * motor_omega, motor_omega_dot)
        .add_product(p.crank_inertia * crank_turn_speed, crank_turn_speed_dot)
        .add_product(
            shaft_driven_dot * p.shaft_driven_field_inertia,
            shaft_driven_dot_dot,
        )
        .add_product(shaft_reed_dot * p.shaft_reed_field_inertia, shaft_reed_dot_dot)
        .add_product(
            shaft_middle_dot * p.shaft_middle_field_inertia,
            shaft_middle_dot_dot,
        )
        .add_product(reed_mass_times_reed_arm_squared * reed_speed, reed_speed_dot)
        .add_product(
            R::literal(0.75)
                * motor_i_sx
                    .add_product(t3, motor_psi_sx)
                    .sub_product(t11, motor_psi_rx),
            motor_psi_sx_dot,
        );
    PowerBalance {
        stored_rate: t12
            .add_product(
                R::literal(0.75)
                    * motor_i_sy
                        .add_product(t3, motor_psi_sy)
                        .sub_product(t11, motor_psi_ry),
                motor_psi_sy_dot,
            )
            .add_product(
                R::literal(0.75)
                    * motor_i_rx
                        .add_product(t5, motor_psi_rx)
                        .sub_product(t11, motor_psi_sx),
                motor_psi_rx_dot,
            )
            .add_product(
                R::literal(0.75)
                    * motor_i_ry
                        .add_product(t5, motor_psi_ry)
                        .sub_product(t11, motor_psi_sy),
                motor_psi_ry_dot,
            ),
        supplied: (shaft_driven_dot * p.shaft_driven_field_force)
            .add_product(
                R::literal(1.5),
                (motor_u_x * motor_i_sx).add_product(motor_u_y, motor_i_sy),
            )
            .add_product(shaft_reed_dot, p.shaft_reed_field_force)
            .add_product(shaft_middle_dot, p.shaft_middle_field_force),
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
            .add_product(crank_turn_speed, t8),
    }
}

impl Describe for LoomDrive {
    fn name(&self) -> &'static str {
        "loom_drive"
    }
    fn title(&self) -> &'static str {
        "Loom: motor, coupling, shaft and reed in one machine"
    }
    fn shape(&self) -> Shape {
        Shape {
            coordinates: COORDINATES,
            positions: 6,
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

impl<R: Real> Simulator<R> for LoomDrive {
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
        name: "crank.turn",
        unit: "rad",
        doc: "angle of the crank",
    },
    Quantity {
        name: "shaft.driven",
        unit: "rad",
        doc: "angle of the section, at port driven",
    },
    Quantity {
        name: "shaft.reed",
        unit: "rad",
        doc: "angle of the section, at port reed",
    },
    Quantity {
        name: "shaft.middle",
        unit: "rad",
        doc: "angle of the section, at port middle",
    },
    Quantity {
        name: "reed.angle",
        unit: "rad",
        doc: "angle of the reed",
    },
    Quantity {
        name: "motor.omega",
        unit: "rad/s",
        doc: "rate of rotor angle",
    },
    Quantity {
        name: "crank.turn_speed",
        unit: "rad/s",
        doc: "rate of angle of the crank",
    },
    Quantity {
        name: "shaft.driven_dot",
        unit: "rad/s",
        doc: "rate of angle of the section, at port driven",
    },
    Quantity {
        name: "shaft.reed_dot",
        unit: "rad/s",
        doc: "rate of angle of the section, at port reed",
    },
    Quantity {
        name: "shaft.middle_dot",
        unit: "rad/s",
        doc: "rate of angle of the section, at port middle",
    },
    Quantity {
        name: "reed.speed",
        unit: "rad/s",
        doc: "rate of angle of the reed",
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
    10.0,
    1.0,
    1.0,
    1.0,
    1.0,
    78.5,
    10.0,
    100.0,
    100.0,
    100.0,
    100.0,
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
        name: "crank.inertia",
        unit: "kg m^2",
        doc: "inertia of crank and flywheel",
    },
    Quantity {
        name: "crank.ratio",
        unit: "1",
        doc: "rocking angle of the drive, in rad, at full crank",
    },
    Quantity {
        name: "crank.stiffness",
        unit: "N m/rad",
        doc: "drive spring",
    },
    Quantity {
        name: "crank.drag",
        unit: "N m s/rad",
        doc: "friction of the crank",
    },
    Quantity {
        name: "shaft.length",
        unit: "m",
        doc: "half of the shaft's length",
    },
    Quantity {
        name: "shaft.reed_position",
        unit: "m",
        doc: "place of the reed",
    },
    Quantity {
        name: "shaft.radius",
        unit: "m",
        doc: "radius",
    },
    Quantity {
        name: "shaft.density",
        unit: "kg/m^3",
        doc: "density",
    },
    Quantity {
        name: "shaft.shear_modulus",
        unit: "Pa",
        doc: "shear modulus, E/(2 (1 + nu)) with E = 2e11 Pa, nu = 0.3",
    },
    Quantity {
        name: "shaft.damping_time",
        unit: "s",
        doc: "Kelvin-Voigt damping time",
    },
    Quantity {
        name: "reed.mass",
        unit: "kg",
        doc: "mass",
    },
    Quantity {
        name: "reed.arm",
        unit: "m",
        doc: "arm of the mass",
    },
    Quantity {
        name: "reed.stiffness",
        unit: "N m/rad",
        doc: "stiffness C1 of the spring between shaft and reed",
    },
    Quantity {
        name: "fell.stiffness",
        unit: "N m/rad",
        doc: "stiffness C2 of the contact",
    },
    Quantity {
        name: "shaft.driven_field_inertia",
        unit: "J s^2/(rad)^2",
        doc: "inertia of the field's node; the field sets it",
    },
    Quantity {
        name: "shaft.driven_field_force",
        unit: "J/(rad)",
        doc: "force of the field on its node; the field sets it",
    },
    Quantity {
        name: "shaft.driven_u_x_before",
        unit: "rad/m",
        doc: "slope of the field before the port; the field sets it",
    },
    Quantity {
        name: "shaft.driven_u_x_after",
        unit: "rad/m",
        doc: "slope of the field after the port; the field sets it",
    },
    Quantity {
        name: "shaft.reed_field_inertia",
        unit: "J s^2/(rad)^2",
        doc: "inertia of the field's node; the field sets it",
    },
    Quantity {
        name: "shaft.reed_field_force",
        unit: "J/(rad)",
        doc: "force of the field on its node; the field sets it",
    },
    Quantity {
        name: "shaft.reed_u_x_before",
        unit: "rad/m",
        doc: "slope of the field before the port; the field sets it",
    },
    Quantity {
        name: "shaft.reed_u_x_after",
        unit: "rad/m",
        doc: "slope of the field after the port; the field sets it",
    },
    Quantity {
        name: "shaft.middle_field_inertia",
        unit: "J s^2/(rad)^2",
        doc: "inertia of the field's node; the field sets it",
    },
    Quantity {
        name: "shaft.middle_field_force",
        unit: "J/(rad)",
        doc: "force of the field on its node; the field sets it",
    },
    Quantity {
        name: "shaft.middle_u_x_before",
        unit: "rad/m",
        doc: "slope of the field before the port; the field sets it",
    },
    Quantity {
        name: "shaft.middle_u_x_after",
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
    2.0,
    0.05,
    45200.0,
    0.5,
    1.75,
    1.0,
    0.025,
    7659.0,
    7.692_307_692_307_692e10,
    1e-6,
    3.56,
    0.025,
    15600.0,
    7800.0,
    1.0,
    0.0,
    0.0,
    0.0,
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
        name: "crank_speed",
        unit: "rad/s",
        doc: "rate of angle of the crank",
    },
    Quantity {
        name: "drive_angle",
        unit: "rad",
        doc: "angle imposed on the drive spring",
    },
    Quantity {
        name: "shaft_angle",
        unit: "rad",
        doc: "angle of the section, at port reed",
    },
    Quantity {
        name: "reed_angle",
        unit: "rad",
        doc: "angle of the reed",
    },
    Quantity {
        name: "stress_before",
        unit: "Pa",
        doc: "shear stress at the surface, on the driven side of the reed",
    },
    Quantity {
        name: "stress_after",
        unit: "Pa",
        doc: "shear stress at the surface, beyond the reed",
    },
    Quantity {
        name: "motor_torque",
        unit: "N m",
        doc: "electromagnetic torque",
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

/// The field shaft.u: angle of the section \[rad\].
///
/// One generic element: what acts at a point with u, u_x, u_t, u_xt at x. The loops over elements are the contract's.
pub mod shaft_u {
    #[allow(
        clippy::wildcard_imports,
        unused_imports,
        reason = "what a field needs of it"
    )]
    use super::*;
    /// Parameters that the field depends on.
    pub const PARAMETERS: [u32; 6] = [17, 18, 19, 20, 21, 22];
    /// m, the inertia a length.
    ///
    /// 4 operations.
    #[must_use]
    #[inline(always)]
    pub fn inertia<R: Real>(_x: R, p: &Parameters<R>) -> [R; 1] {
        let shaft_radius_squared = p.shaft_radius * p.shaft_radius;
        [
            R::literal(core::f64::consts::FRAC_PI_2) * p.shaft_density
                * (shaft_radius_squared * shaft_radius_squared),
        ]
    }
    /// dm/dx, then dm/dp of `PARAMETERS`.
    ///
    /// 6 operations.
    #[must_use]
    #[inline]
    pub fn inertia_gradient<R: Real>(_x: R, p: &Parameters<R>) -> [R; 7] {
        let shaft_radius_squared = p.shaft_radius * p.shaft_radius;
        [
            R::literal(0.0),
            R::literal(0.0),
            R::literal(0.0),
            R::literal(core::f64::consts::TAU) * p.shaft_density
                * (shaft_radius_squared * p.shaft_radius),
            R::literal(core::f64::consts::FRAC_PI_2)
                * (shaft_radius_squared * shaft_radius_squared),
            R::literal(0.0),
            R::literal(0.0),
        ]
    }
    /// Forces a length: f_0 = dL/du - dD/du_t + Q on u, f_1 = dL/du_x - dD/du_xt on u_x.
    ///
    /// 8 operations.
    #[must_use]
    #[inline]
    pub fn force<R: Real>(
        _time: R,
        _x: R,
        point: &FieldPoint<R>,
        p: &Parameters<R>,
    ) -> [R; 2] {
        let [_, u_x_2, _, u_x_dot] = *point;
        let shaft_radius_squared = p.shaft_radius * p.shaft_radius;
        [
            R::literal(0.0),
            -(R::literal(core::f64::consts::FRAC_PI_2) * p.shaft_shear_modulus
                * (shaft_radius_squared * shaft_radius_squared)
                * u_x_2.add_product(p.shaft_damping_time, u_x_dot)),
        ]
    }
    /// Derivatives of f_0, then of f_1, with respect to u, u_x, u_t, u_xt.
    ///
    /// 8 operations.
    #[must_use]
    #[inline]
    pub fn force_jacobian<R: Real>(
        _time: R,
        _x: R,
        _point: &FieldPoint<R>,
        p: &Parameters<R>,
    ) -> [R; 8] {
        let shaft_radius_squared = p.shaft_radius * p.shaft_radius;
        let shaft_radius_squared_squared = shaft_radius_squared * shaft_radius_squared;
        let t0 = R::literal(core::f64::consts::FRAC_PI_2) * p.shaft_shear_modulus;
        [
            R::literal(0.0),
            R::literal(0.0),
            R::literal(0.0),
            R::literal(0.0),
            R::literal(0.0),
            -(t0 * shaft_radius_squared_squared),
            R::literal(0.0),
            -(t0 * p.shaft_damping_time * shaft_radius_squared_squared),
        ]
    }
    /// Derivatives of f_0 and f_1 with respect to x, to t, then to `PARAMETERS`.
    ///
    /// 16 operations.
    #[must_use]
    #[inline]
    pub fn force_gradient<R: Real>(
        _time: R,
        _x: R,
        point: &FieldPoint<R>,
        p: &Parameters<R>,
    ) -> [R; 16] {
        let [_, u_x_2, _, u_x_dot] = *point;
        let shaft_radius_squared = p.shaft_radius * p.shaft_radius;
        let shaft_radius_squared_squared = shaft_radius_squared * shaft_radius_squared;
        let t0 = u_x_2.add_product(p.shaft_damping_time, u_x_dot);
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
            -(R::literal(core::f64::consts::TAU) * p.shaft_shear_modulus
                * (shaft_radius_squared * p.shaft_radius) * t0),
            R::literal(0.0),
            R::literal(0.0),
            R::literal(0.0),
            -(R::literal(core::f64::consts::FRAC_PI_2) * shaft_radius_squared_squared
                * t0),
            R::literal(0.0),
            -(R::literal(core::f64::consts::FRAC_PI_2) * p.shaft_shear_modulus
                * shaft_radius_squared_squared * u_x_dot),
        ]
    }
    /// T and V a length \[J/m\].
    ///
    /// 10 operations.
    #[must_use]
    #[inline]
    pub fn energy<R: Real>(
        _time: R,
        _x: R,
        point: &FieldPoint<R>,
        p: &Parameters<R>,
    ) -> [R; 2] {
        let [_, u_x_2, u_dot, _] = *point;
        let shaft_radius_squared = p.shaft_radius * p.shaft_radius;
        let shaft_radius_squared_squared = shaft_radius_squared * shaft_radius_squared;
        [
            R::literal(core::f64::consts::FRAC_PI_4) * p.shaft_density
                * shaft_radius_squared_squared * (u_dot * u_dot),
            R::literal(core::f64::consts::FRAC_PI_4) * p.shaft_shear_modulus
                * shaft_radius_squared_squared * (u_x_2 * u_x_2),
        ]
    }
    /// Rate of V, power supplied and power dissipated, a length \[W/m\].
    ///
    /// 10 operations.
    #[must_use]
    #[inline]
    pub fn power<R: Real>(
        _time: R,
        _x: R,
        point: &FieldPoint<R>,
        p: &Parameters<R>,
    ) -> [R; 3] {
        let [_, u_x_2, _, u_x_dot] = *point;
        let shaft_radius_squared = p.shaft_radius * p.shaft_radius;
        let shaft_radius_squared_squared = shaft_radius_squared * shaft_radius_squared;
        let t0 = R::literal(core::f64::consts::FRAC_PI_2) * p.shaft_shear_modulus;
        [
            t0 * shaft_radius_squared_squared * u_x_2 * u_x_dot,
            R::literal(0.0),
            t0 * p.shaft_damping_time * shaft_radius_squared_squared
                * (u_x_dot * u_x_dot),
        ]
    }
    /// x of the attachments, then the length \[m\].
    ///
    /// 0 operations.
    #[must_use]
    #[inline]
    pub fn places<R: Real>(p: &Parameters<R>) -> [R; 4] {
        [R::literal(0.0), p.shaft_reed_position, p.shaft_length, p.shaft_length]
    }
    /// Derivatives of `places` with respect to `PARAMETERS`, row by row.
    ///
    /// 0 operations.
    #[must_use]
    #[inline]
    pub fn places_gradient<R: Real>(_p: &Parameters<R>) -> [R; 24] {
        [
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
            R::literal(1.0),
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
    /// 0 operations for all points, 0 for each.
    pub fn on_value<R: Real>(
        _time: R,
        at: &[R],
        u: &[R],
        u_t: &[R],
        _p: &Parameters<R>,
        force: &mut [R],
    ) {
        for (((_, _), _), force) in at.iter().zip(u).zip(u_t).zip(force) {
            *force = R::literal(0.0);
        }
    }
    /// df_0/du and df_0/du_t, at many points.
    ///
    /// 0 operations for all points, 0 for each.
    pub fn on_value_jacobian<R: Real>(
        _time: R,
        at: &[R],
        u: &[R],
        u_t: &[R],
        _p: &Parameters<R>,
        by_u: &mut [R],
        by_u_t: &mut [R],
    ) {
        for ((((_, _), _), by_u), by_u_t) in at
            .iter()
            .zip(u)
            .zip(u_t)
            .zip(by_u)
            .zip(by_u_t)
        {
            *by_u = R::literal(0.0);
            *by_u_t = R::literal(0.0);
        }
    }
    /// df_0/dt, at many points.
    ///
    /// 0 operations for all points, 0 for each.
    pub fn on_value_by_time<R: Real>(
        _time: R,
        at: &[R],
        u: &[R],
        u_t: &[R],
        _p: &Parameters<R>,
        by_time: &mut [R],
    ) {
        for (((_, _), _), by_time) in at.iter().zip(u).zip(u_t).zip(by_time) {
            *by_time = R::literal(0.0);
        }
    }
    /// f_1 alone, at many points.
    ///
    /// 4 operations for all points, 4 for each.
    pub fn on_slope<R: Real>(u_x: &[R], u_xt: &[R], p: &Parameters<R>, force: &mut [R]) {
        let shaft_radius_squared = p.shaft_radius * p.shaft_radius;
        let t0 = R::literal(core::f64::consts::FRAC_PI_2) * p.shaft_shear_modulus
            * (shaft_radius_squared * shaft_radius_squared);
        for ((&u_x_2, &u_x_dot), force) in u_x.iter().zip(u_xt).zip(force) {
            *force = -(t0 * u_x_2.add_product(p.shaft_damping_time, u_x_dot));
        }
    }
    /// df_1/du_x and df_1/du_xt, at many points.
    ///
    /// 8 operations for all points, 0 for each.
    pub fn on_slope_jacobian<R: Real>(
        u_x: &[R],
        u_xt: &[R],
        p: &Parameters<R>,
        by_u_x: &mut [R],
        by_u_xt: &mut [R],
    ) {
        let shaft_radius_squared = p.shaft_radius * p.shaft_radius;
        let shaft_radius_squared_squared = shaft_radius_squared * shaft_radius_squared;
        let t0 = R::literal(core::f64::consts::FRAC_PI_2) * p.shaft_shear_modulus;
        let t1 = -(t0 * shaft_radius_squared_squared);
        let t2 = -(t0 * p.shaft_damping_time * shaft_radius_squared_squared);
        for (((_, _), by_u_x), by_u_xt) in u_x.iter().zip(u_xt).zip(by_u_x).zip(by_u_xt)
        {
            *by_u_x = t1;
            *by_u_xt = t2;
        }
    }
}

impl<R: Real> FieldScene<R> for LoomDrive {
    fn fields(&self) -> usize {
        1
    }
    fn field(&self, index: usize) -> FieldDescription<'_> {
        match index {
            0 => SHAFT_U_FIELD,
            _ => no_field(index),
        }
    }
    fn field_inertia(&self, index: usize, x: R, parameters: &[R]) -> R {
        let p = parameters_of(parameters);
        let [inertia] = match index {
            0 => shaft_u::inertia(x, &p),
            _ => no_field(index),
        };
        inertia
    }
    fn field_initial(&self, index: usize, x: R, parameters: &[R]) -> [R; 2] {
        let p = parameters_of(parameters);
        match index {
            0 => shaft_u::initial(x, &p),
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
            0 => shaft_u::force(time, x, point, &p),
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
            0 => shaft_u::force_jacobian(time, x, point, &p),
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
            0 => shaft_u::energy(time, x, point, &p),
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
            0 => shaft_u::power(time, x, point, &p),
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
            0 => values.copy_from_slice(&shaft_u::inertia_gradient(x, &p)),
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
            0 => values.copy_from_slice(&shaft_u::force_gradient(time, x, point, &p)),
            _ => no_field(index),
        }
    }
    fn field_places(&self, index: usize, parameters: &[R], values: &mut [R]) {
        let p = parameters_of(parameters);
        match index {
            0 => values.copy_from_slice(&shaft_u::places(&p)),
            _ => no_field(index),
        }
    }
    fn field_places_gradient(&self, index: usize, parameters: &[R], values: &mut [R]) {
        let p = parameters_of(parameters);
        match index {
            0 => values.copy_from_slice(&shaft_u::places_gradient(&p)),
            _ => no_field(index),
        }
    }
    fn jacobian_reads_forces(&self) -> bool {
        false
    }
    fn field_is_linear(&self, index: usize) -> bool {
        matches!(index, 0)
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
                    [*inertia] = shaft_u::inertia(*x, &p);
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
            0 => shaft_u::on_value(time, x, u, u_t, &p, forces),
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
            0 => shaft_u::on_value_jacobian(time, x, u, u_t, &p, by_u, by_u_t),
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
            0 => shaft_u::on_value_by_time(time, x, u, u_t, &p, by_time),
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
            0 => shaft_u::on_slope(u_x, u_xt, &p, forces),
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
            0 => shaft_u::on_slope_jacobian(u_x, u_xt, &p, by_u_x, by_u_xt),
            _ => no_field(index),
        }
    }
}

#[cold]
fn no_field(index: usize) -> ! {
    panic!("there is no field of number {index}")
}

static SHAFT_U_FIELD: FieldDescription<'static> = FieldDescription {
    value: Quantity {
        name: "shaft.u",
        unit: "rad",
        doc: "angle of the section",
    },
    rate: Quantity {
        name: "shaft.u_dot",
        unit: "rad/s",
        doc: "rate of angle of the section",
    },
    slope: Quantity {
        name: "shaft.u_x",
        unit: "rad/m",
        doc: "slope of angle of the section",
    },
    scale: [1.0, 100.0],
    fixed: [false, false],
    length: 1.75,
    attachments: &[
        FieldAttachment {
            coordinate: Some(2),
            place: FieldPlace::Start,
            at: 0.0,
            handed: 27,
        },
        FieldAttachment {
            coordinate: Some(3),
            place: FieldPlace::Inside,
            at: 1.0,
            handed: 31,
        },
        FieldAttachment {
            coordinate: Some(4),
            place: FieldPlace::End,
            at: 1.75,
            handed: 35,
        },
    ],
    parameters: &shaft_u::PARAMETERS,
    elements: 8,
    order: 4,
};

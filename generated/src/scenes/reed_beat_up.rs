// Emitted by Machinist 0.1.0; do not edit. To make it again:
//
//     cargo run --release -- gen
//
// Sources, with SHA-256:
//   7d526b557f970aacc7c8ce89ad49a244287d03ba0648fc731b119ca32e2eae28  scenes/reed_beat_up.toml
//   f6a02275b3378b55e3f073294275c62569c7d4c4584bfb46e0246a1b297c364b  units/imposed_drive.toml
//   210450c6c85a818c6e10138353cf1dfe5286ef742fc908308e77a3b605c3c704  units/loom_shaft.toml
//   f7986e73556e5a9af8b7a8f55072bbd9b2cd4e98c46b71cc2927a976f7158acd  units/reed.toml
//   5b1dbf2392d60b9814b89aff64ac087d3b9babc2b90f90772c08dad998dacad3  units/cloth_fell_contact.toml
//
// Beat-up of a reed by an elastic shaft
//
// Half of a symmetric shaft is driven through a spring by an imposed angle; the reed hangs
// on it by another spring and presses the cloth fell, here always in contact. The study
// asks for contact stiffnesses of 0, 0.5 C1 and C1.
//
// Source:
//   Reed study, in its consistent reading.
//
// Shapes; all quantities are in SI units:
//   coordinates               4
//   first-order states        0
//   states                    8
//   parameters               25
//   outputs                   8
//   discontinuities           0
//
// State:
//     0  shaft.driven      [rad]    angle of the section, at port driven
//     1  shaft.reed        [rad]    angle of the section, at port reed
//     2  shaft.middle      [rad]    angle of the section, at port middle
//     3  reed.angle        [rad]    angle of the reed
//     4  shaft.driven_dot  [rad/s]  rate of angle of the section, at port driven
//     5  shaft.reed_dot    [rad/s]  rate of angle of the section, at port reed
//     6  shaft.middle_dot  [rad/s]  rate of angle of the section, at port middle
//     7  reed.speed        [rad/s]  rate of angle of the reed
//
// Nonzeros:
//   mass_matrix               4 of 4 by 4
//   rate_jacobian             9 of 8 by 8
//   parameter_jacobian       14 of 8 by 25
//
// Operations:
//   initial_state             0
//   discontinuities           0
//   rate                     21
//   mass_matrix               2
//   forcing                  11
//   rate_jacobian            13
//   parameter_jacobian       49
//   time_derivative           7
//   outputs                   7
//   energy                   33
//   power_balance            51
// With constants of the parameters, prepared once a run:
//   prepare                  14
//   prepared_rate            15
//   prepared_rate_jacobian    0

use ::machinist_contract::{
    Describe, Energy, PowerBalance, Quantity, Real, RunDefaults, Shape, Simulator,
    SparsityPattern, linear::LinearEquations,
    field::{FieldAttachment, FieldDescription, FieldPlace, FieldPoint, FieldScene},
};

/// Generalized coordinates, n.
pub const COORDINATES: usize = 4;

/// Length of the state y.
pub const STATES: usize = 8;

/// Parameters.
pub const PARAMETERS: usize = 25;

/// Wanted outputs.
pub const OUTPUTS: usize = 8;

/// Times at which the right-hand side jumps.
pub const DISCONTINUITIES: usize = 0;

/// Nonzeros of M, both triangles.
pub const MASS_MATRIX_PATTERN: SparsityPattern<'static> = SparsityPattern {
    rows: 4,
    columns: 4,
    entries: &[(0, 0), (1, 1), (2, 2), (3, 3)],
};

/// Nonzeros of dy'/dy.
pub const RATE_JACOBIAN_PATTERN: SparsityPattern<'static> = SparsityPattern {
    rows: 8,
    columns: 8,
    entries: &[(0, 4), (1, 5), (2, 6), (3, 7), (4, 0), (5, 1), (5, 3), (7, 1), (7, 3)],
};

/// Nonzeros of dy'/dp.
pub const PARAMETER_JACOBIAN_PATTERN: SparsityPattern<'static> = SparsityPattern {
    rows: 8,
    columns: 25,
    entries: &[
        (4, 0), (4, 1), (4, 2), (4, 13), (4, 14), (5, 11), (5, 17), (5, 18), (6, 21), (6, 22),
        (7, 9), (7, 10), (7, 11), (7, 12),
    ],
};

/// Beat-up of a reed by an elastic shaft
///
/// Half of a symmetric shaft is driven through a spring by an imposed angle; the reed hangs
/// on it by another spring and presses the cloth fell, here always in contact. The study
/// asks for contact stiffnesses of 0, 0.5 C1 and C1.
///
/// Source: Reed study, in its consistent reading.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct ReedBeatUp;

/// Parameters, in SI units; the default holds the values of the spec.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Parameters<R> {
    /// drive.stiffness: stiffness C0 of the drive spring \[N m/rad\]. In the spec: 45200.0.
    pub drive_stiffness: R,
    /// drive.amplitude: amplitude of the imposed angle \[rad\]. In the spec: 0.2517196994494523.
    pub drive_amplitude: R,
    /// drive.frequency: angular frequency of the imposed angle \[rad/s\]. In the spec: 119.18018361540386.
    pub drive_frequency: R,
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
    /// shaft.damping_time: Kelvin-Voigt damping time \[s\]. In the spec: 0.0.
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
            drive_stiffness: values[0],
            drive_amplitude: values[1],
            drive_frequency: values[2],
            shaft_length: values[3],
            shaft_reed_position: values[4],
            shaft_radius: values[5],
            shaft_density: values[6],
            shaft_shear_modulus: values[7],
            shaft_damping_time: values[8],
            reed_mass: values[9],
            reed_arm: values[10],
            reed_stiffness: values[11],
            fell_stiffness: values[12],
            shaft_driven_field_inertia: values[13],
            shaft_driven_field_force: values[14],
            shaft_driven_u_x_before: values[15],
            shaft_driven_u_x_after: values[16],
            shaft_reed_field_inertia: values[17],
            shaft_reed_field_force: values[18],
            shaft_reed_u_x_before: values[19],
            shaft_reed_u_x_after: values[20],
            shaft_middle_field_inertia: values[21],
            shaft_middle_field_force: values[22],
            shaft_middle_u_x_before: values[23],
            shaft_middle_u_x_after: values[24],
        }
    }
    /// The numbers in their order.
    #[must_use]
    #[inline]
    pub fn to_array(self) -> [R; PARAMETERS] {
        [
            self.drive_stiffness,
            self.drive_amplitude,
            self.drive_frequency,
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
            drive_stiffness: R::literal(45200.0),
            drive_amplitude: R::literal(0.251_719_699_449_452_3),
            drive_frequency: R::literal(119.180_183_615_403_86),
            shaft_length: R::literal(1.75),
            shaft_reed_position: R::literal(1.0),
            shaft_radius: R::literal(0.025),
            shaft_density: R::literal(7659.0),
            shaft_shear_modulus: R::literal(7.692_307_692_307_692e10),
            shaft_damping_time: R::literal(0.0),
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
    /// drive_angle: imposed angle u0 \[rad\].
    pub drive_angle: R,
    /// driven_angle: angle of the section, at port driven \[rad\].
    pub driven_angle: R,
    /// shaft_angle: angle of the section, at port reed \[rad\].
    pub shaft_angle: R,
    /// middle_angle: angle of the section, at port middle \[rad\].
    pub middle_angle: R,
    /// reed_angle: angle of the reed \[rad\].
    pub reed_angle: R,
    /// stress_before: shear stress at the surface, on the driven side of the reed \[Pa\].
    pub stress_before: R,
    /// stress_after: shear stress at the surface, beyond the reed \[Pa\].
    pub stress_after: R,
    /// fell_torque: torque of the fell on the reed, against it \[N m\].
    pub fell_torque: R,
}

impl<R: Real> Outputs<R> {
    /// From the numbers in their order.
    #[must_use]
    #[inline]
    pub fn from_array(values: [R; OUTPUTS]) -> Self {
        Self {
            drive_angle: values[0],
            driven_angle: values[1],
            shaft_angle: values[2],
            middle_angle: values[3],
            reed_angle: values[4],
            stress_before: values[5],
            stress_after: values[6],
            fell_torque: values[7],
        }
    }
    /// The numbers in their order.
    #[must_use]
    #[inline]
    pub fn to_array(self) -> [R; OUTPUTS] {
        [
            self.drive_angle,
            self.driven_angle,
            self.shaft_angle,
            self.middle_angle,
            self.reed_angle,
            self.stress_before,
            self.stress_after,
            self.fell_torque,
        ]
    }
}

/// Where to find what in the state.
pub mod state {
    /// shaft.driven: angle of the section, at port driven \[rad\].
    pub const SHAFT_DRIVEN: usize = 0;
    /// shaft.reed: angle of the section, at port reed \[rad\].
    pub const SHAFT_REED: usize = 1;
    /// shaft.middle: angle of the section, at port middle \[rad\].
    pub const SHAFT_MIDDLE: usize = 2;
    /// reed.angle: angle of the reed \[rad\].
    pub const REED_ANGLE: usize = 3;
    /// shaft.driven_dot: rate of angle of the section, at port driven \[rad/s\].
    pub const SHAFT_DRIVEN_DOT: usize = 4;
    /// shaft.reed_dot: rate of angle of the section, at port reed \[rad/s\].
    pub const SHAFT_REED_DOT: usize = 5;
    /// shaft.middle_dot: rate of angle of the section, at port middle \[rad/s\].
    pub const SHAFT_MIDDLE_DOT: usize = 6;
    /// reed.speed: rate of angle of the reed \[rad/s\].
    pub const REED_SPEED: usize = 7;
}

/// Constants that `prepare` computes.
pub const CONSTANTS: usize = 9;

#[allow(missing_docs, reason = "`prepare` says what each is")]
/// What parameters alone decide; `prepare` says what each is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Constants<R> {
    pub inverse_shaft_driven_field_inertia: R,
    pub inverse_shaft_reed_field_inertia: R,
    pub inverse_shaft_middle_field_inertia: R,
    pub t0: R,
    pub shaft_driven_dot_dot_by_shaft_driven: R,
    pub reed_speed_dot_by_shaft_reed: R,
    pub t1: R,
    pub shaft_reed_dot_dot_by_shaft_reed: R,
    pub reed_speed_dot_by_reed_angle: R,
}

impl<R: Real> Constants<R> {
    /// From the numbers in their order.
    #[must_use]
    #[inline]
    pub fn from_array(values: [R; CONSTANTS]) -> Self {
        Self {
            inverse_shaft_driven_field_inertia: values[0],
            inverse_shaft_reed_field_inertia: values[1],
            inverse_shaft_middle_field_inertia: values[2],
            t0: values[3],
            shaft_driven_dot_dot_by_shaft_driven: values[4],
            reed_speed_dot_by_shaft_reed: values[5],
            t1: values[6],
            shaft_reed_dot_dot_by_shaft_reed: values[7],
            reed_speed_dot_by_reed_angle: values[8],
        }
    }
    /// The numbers in their order.
    #[must_use]
    #[inline]
    pub fn to_array(self) -> [R; CONSTANTS] {
        [
            self.inverse_shaft_driven_field_inertia,
            self.inverse_shaft_reed_field_inertia,
            self.inverse_shaft_middle_field_inertia,
            self.t0,
            self.shaft_driven_dot_dot_by_shaft_driven,
            self.reed_speed_dot_by_shaft_reed,
            self.t1,
            self.shaft_reed_dot_dot_by_shaft_reed,
            self.reed_speed_dot_by_reed_angle,
        ]
    }
}

/// What `rate` and `rate_jacobian` need of the parameters, once a run.
///
/// 14 operations.
#[must_use]
#[inline]
pub fn prepare<R: Real>(p: &Parameters<R>) -> Constants<R> {
    let inverse_shaft_driven_field_inertia = R::literal(1.0)
        / p.shaft_driven_field_inertia;
    let inverse_shaft_reed_field_inertia = R::literal(1.0) / p.shaft_reed_field_inertia;
    let inverse_shaft_middle_field_inertia = R::literal(1.0)
        / p.shaft_middle_field_inertia;
    let t0 = R::literal(1.0) / (p.reed_mass * (p.reed_arm * p.reed_arm));
    let shaft_driven_dot_dot_by_shaft_driven = -(p.drive_stiffness
        * inverse_shaft_driven_field_inertia);
    let reed_speed_dot_by_shaft_reed = p.reed_stiffness * t0;
    let t1 = p.reed_stiffness * inverse_shaft_reed_field_inertia;
    let shaft_reed_dot_dot_by_shaft_reed = -t1;
    let reed_speed_dot_by_reed_angle = -((p.reed_stiffness + p.fell_stiffness) * t0);
    Constants {
        inverse_shaft_driven_field_inertia,
        inverse_shaft_reed_field_inertia,
        inverse_shaft_middle_field_inertia,
        t0,
        shaft_driven_dot_dot_by_shaft_driven,
        reed_speed_dot_by_shaft_reed,
        t1,
        shaft_reed_dot_dot_by_shaft_reed,
        reed_speed_dot_by_reed_angle,
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
/// 21 operations.
#[must_use]
#[inline]
pub fn rate<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>) -> [R; STATES] {
    prepared_rate(time, state, p, &prepare(p))
}

/// As `rate`, with the constants of the parameters from `prepare`.
///
/// 15 operations.
#[must_use]
#[inline]
pub fn prepared_rate<R: Real>(
    time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
    c: &Constants<R>,
) -> [R; STATES] {
    let [shaft_driven, shaft_reed, _, reed_angle, shaft_driven_dot, shaft_reed_dot,
    shaft_middle_dot, reed_speed] = *state;
    let fell_torque = p.fell_stiffness * reed_angle;
    let drive_angle = p.drive_amplitude * (p.drive_frequency * time).sin();
    let t0 = p.reed_stiffness * (shaft_reed - reed_angle);
    let reed_speed_dot = (t0 - fell_torque) * c.t0;
    let shaft_middle_dot_dot = p.shaft_middle_field_force
        * c.inverse_shaft_middle_field_inertia;
    let shaft_reed_dot_dot = (p.shaft_reed_field_force - t0)
        * c.inverse_shaft_reed_field_inertia;
    let shaft_driven_dot_dot = p
        .shaft_driven_field_force
        .sub_product(p.drive_stiffness, shaft_driven - drive_angle)
        * c.inverse_shaft_driven_field_inertia;
    [
        shaft_driven_dot,
        shaft_reed_dot,
        shaft_middle_dot,
        reed_speed,
        shaft_driven_dot_dot,
        shaft_reed_dot_dot,
        shaft_middle_dot_dot,
        reed_speed_dot,
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
) -> [R; 4] {
    [
        p.shaft_driven_field_inertia,
        p.shaft_reed_field_inertia,
        p.shaft_middle_field_inertia,
        p.reed_mass * (p.reed_arm * p.reed_arm),
    ]
}

/// `f` of `M q'' = f(q, q', z, t)`, one for each coordinate.
///
/// 11 operations.
#[must_use]
pub fn forcing<R: Real>(
    time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
) -> [R; COORDINATES] {
    let [shaft_driven, shaft_reed, _, reed_angle, ..] = *state;
    let fell_torque = p.fell_stiffness * reed_angle;
    let drive_angle = p.drive_amplitude * (p.drive_frequency * time).sin();
    let shaft_driven_forcing = p
        .shaft_driven_field_force
        .sub_product(p.drive_stiffness, shaft_driven - drive_angle);
    let t0 = p.reed_stiffness * (shaft_reed - reed_angle);
    let shaft_reed_forcing = p.shaft_reed_field_force - t0;
    let reed_angle_forcing = t0 - fell_torque;
    [
        shaft_driven_forcing,
        shaft_reed_forcing,
        p.shaft_middle_field_force,
        reed_angle_forcing,
    ]
}

/// `dy'/dy`, values in the order of `RATE_JACOBIAN_PATTERN`.
///
/// 13 operations.
#[must_use]
#[inline]
pub fn rate_jacobian<R: Real>(
    time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
) -> [R; 9] {
    prepared_rate_jacobian(time, state, p, &prepare(p))
}

/// As `rate_jacobian`, with the constants of the parameters from `prepare`.
///
/// No operations.
#[must_use]
pub fn prepared_rate_jacobian<R: Real>(
    _time: R,
    _state: &[R; STATES],
    _p: &Parameters<R>,
    c: &Constants<R>,
) -> [R; 9] {
    [
        R::literal(1.0),
        R::literal(1.0),
        R::literal(1.0),
        R::literal(1.0),
        c.shaft_driven_dot_dot_by_shaft_driven,
        c.shaft_reed_dot_dot_by_shaft_reed,
        c.t1,
        c.reed_speed_dot_by_shaft_reed,
        c.reed_speed_dot_by_reed_angle,
    ]
}

/// `dy'/dp`, values in the order of `PARAMETER_JACOBIAN_PATTERN`.
///
/// 49 operations.
#[must_use]
pub fn parameter_jacobian<R: Real>(
    time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
) -> [R; 14] {
    let [shaft_driven, shaft_reed, _, reed_angle, ..] = *state;
    let drive_frequency_times_time = p.drive_frequency * time;
    let (sin_drive_frequency_times_time, cos_drive_frequency_times_time) = drive_frequency_times_time
        .sin_cos();
    let fell_torque = p.fell_stiffness * reed_angle;
    let drive_angle = p.drive_amplitude * sin_drive_frequency_times_time;
    let reed_arm_squared = p.reed_arm * p.reed_arm;
    let inverse_shaft_driven_field_inertia = R::literal(1.0)
        / p.shaft_driven_field_inertia;
    let inverse_shaft_reed_field_inertia = R::literal(1.0) / p.shaft_reed_field_inertia;
    let inverse_shaft_middle_field_inertia = R::literal(1.0)
        / p.shaft_middle_field_inertia;
    let t0 = R::literal(1.0) / (p.reed_mass * reed_arm_squared);
    let shaft_reed_minus_reed_angle = shaft_reed - reed_angle;
    let t1 = p.reed_stiffness * shaft_reed_minus_reed_angle;
    let reed_speed_dot = (t1 - fell_torque) * t0;
    let shaft_middle_dot_dot = p.shaft_middle_field_force
        * inverse_shaft_middle_field_inertia;
    let shaft_reed_dot_dot = (p.shaft_reed_field_force - t1)
        * inverse_shaft_reed_field_inertia;
    let shaft_driven_dot_dot = p
        .shaft_driven_field_force
        .sub_product(p.drive_stiffness, shaft_driven - drive_angle)
        * inverse_shaft_driven_field_inertia;
    let shaft_driven_dot_dot_by_drive_stiffness = (drive_angle - shaft_driven)
        * inverse_shaft_driven_field_inertia;
    let shaft_driven_dot_dot_by_drive_amplitude = p.drive_stiffness
        * sin_drive_frequency_times_time * inverse_shaft_driven_field_inertia;
    let shaft_driven_dot_dot_by_drive_frequency = p.drive_stiffness * p.drive_amplitude
        * time * cos_drive_frequency_times_time * inverse_shaft_driven_field_inertia;
    let reed_speed_dot_by_reed_mass = -(reed_arm_squared * reed_speed_dot * t0);
    let reed_speed_dot_by_reed_arm = -(R::literal(2.0) * p.reed_mass * p.reed_arm
        * reed_speed_dot * t0);
    let reed_speed_dot_by_reed_stiffness = shaft_reed_minus_reed_angle * t0;
    let shaft_reed_dot_dot_by_reed_stiffness = (reed_angle - shaft_reed)
        * inverse_shaft_reed_field_inertia;
    let reed_speed_dot_by_fell_stiffness = -(reed_angle * t0);
    let shaft_driven_dot_dot_by_shaft_driven_field_inertia = -(shaft_driven_dot_dot
        * inverse_shaft_driven_field_inertia);
    let shaft_reed_dot_dot_by_shaft_reed_field_inertia = -(shaft_reed_dot_dot
        * inverse_shaft_reed_field_inertia);
    let shaft_middle_dot_dot_by_shaft_middle_field_inertia = -(shaft_middle_dot_dot
        * inverse_shaft_middle_field_inertia);
    [
        shaft_driven_dot_dot_by_drive_stiffness,
        shaft_driven_dot_dot_by_drive_amplitude,
        shaft_driven_dot_dot_by_drive_frequency,
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
    ]
}

/// Partial derivative of `y'` with respect to time.
///
/// 7 operations.
#[must_use]
pub fn time_derivative<R: Real>(
    time: R,
    _state: &[R; STATES],
    p: &Parameters<R>,
) -> [R; STATES] {
    let shaft_driven_dot_dot_by_time = p.drive_stiffness * p.drive_amplitude
        * p.drive_frequency * (p.drive_frequency * time).cos()
        * (R::literal(1.0) / p.shaft_driven_field_inertia);
    [
        R::literal(0.0),
        R::literal(0.0),
        R::literal(0.0),
        R::literal(0.0),
        shaft_driven_dot_dot_by_time,
        R::literal(0.0),
        R::literal(0.0),
        R::literal(0.0),
    ]
}

/// Wanted outputs.
///
/// 7 operations.
#[must_use]
pub fn outputs<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>) -> Outputs<R> {
    let [shaft_driven, shaft_reed, shaft_middle, reed_angle, ..] = *state;
    let fell_torque = p.fell_stiffness * reed_angle;
    let drive_angle = p.drive_amplitude * (p.drive_frequency * time).sin();
    let t0 = p.shaft_radius * p.shaft_shear_modulus;
    Outputs {
        drive_angle,
        driven_angle: shaft_driven,
        shaft_angle: shaft_reed,
        middle_angle: shaft_middle,
        reed_angle,
        stress_before: t0 * p.shaft_reed_u_x_before,
        stress_after: t0 * p.shaft_reed_u_x_after,
        fell_torque,
    }
}

/// T, V and the energy of first-order states \[J\].
///
/// 33 operations.
#[must_use]
pub fn energy<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>) -> Energy<R> {
    let [shaft_driven, shaft_reed, _, reed_angle, shaft_driven_dot, shaft_reed_dot,
    shaft_middle_dot, reed_speed] = *state;
    let fell_torque = p.fell_stiffness * reed_angle;
    let drive_angle = p.drive_amplitude * (p.drive_frequency * time).sin();
    let shaft_driven_minus_drive_angle = shaft_driven - drive_angle;
    let shaft_reed_minus_reed_angle = shaft_reed - reed_angle;
    Energy {
        kinetic: (R::literal(0.5) * p.shaft_driven_field_inertia
            * (shaft_driven_dot * shaft_driven_dot))
            .add_product(
                R::literal(0.5) * p.reed_mass * (p.reed_arm * p.reed_arm),
                reed_speed * reed_speed,
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
                R::literal(0.5) * p.drive_stiffness,
                shaft_driven_minus_drive_angle * shaft_driven_minus_drive_angle,
            )
            .add_product(
                R::literal(0.5) * p.reed_stiffness,
                shaft_reed_minus_reed_angle * shaft_reed_minus_reed_angle,
            ),
        stored: R::literal(0.0),
    }
}

/// `dE/dt`, power supplied and power dissipated \[W\].
///
/// 51 operations.
#[must_use]
pub fn power_balance<R: Real>(
    time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
) -> PowerBalance<R> {
    let [shaft_driven, shaft_reed, _, reed_angle, shaft_driven_dot, shaft_reed_dot,
    shaft_middle_dot, reed_speed] = *state;
    let drive_frequency_times_time = p.drive_frequency * time;
    let (sin_drive_frequency_times_time, cos_drive_frequency_times_time) = drive_frequency_times_time
        .sin_cos();
    let fell_torque = p.fell_stiffness * reed_angle;
    let drive_angle = p.drive_amplitude * sin_drive_frequency_times_time;
    let reed_mass_times_reed_arm_squared = p.reed_mass * (p.reed_arm * p.reed_arm);
    let shaft_driven_minus_drive_angle = shaft_driven - drive_angle;
    let t0 = p.drive_stiffness * shaft_driven_minus_drive_angle;
    let t1 = p.reed_stiffness * (shaft_reed - reed_angle);
    let reed_speed_dot = (t1 - fell_torque)
        * (R::literal(1.0) / reed_mass_times_reed_arm_squared);
    let shaft_middle_dot_dot = p.shaft_middle_field_force
        * (R::literal(1.0) / p.shaft_middle_field_inertia);
    let shaft_reed_dot_dot = (p.shaft_reed_field_force - t1)
        * (R::literal(1.0) / p.shaft_reed_field_inertia);
    let shaft_driven_dot_dot = (p.shaft_driven_field_force - t0)
        * (R::literal(1.0) / p.shaft_driven_field_inertia);
    let t2 = p.drive_stiffness * p.drive_amplitude * p.drive_frequency
        * shaft_driven_minus_drive_angle * cos_drive_frequency_times_time;
    PowerBalance {
        stored_rate: (-t2)
            .add_product(t0, shaft_driven_dot)
            .add_product(t1, shaft_reed_dot)
            .add_product(fell_torque - t1, reed_speed)
            .add_product(
                shaft_driven_dot * p.shaft_driven_field_inertia,
                shaft_driven_dot_dot,
            )
            .add_product(shaft_reed_dot * p.shaft_reed_field_inertia, shaft_reed_dot_dot)
            .add_product(
                shaft_middle_dot * p.shaft_middle_field_inertia,
                shaft_middle_dot_dot,
            )
            .add_product(reed_mass_times_reed_arm_squared * reed_speed, reed_speed_dot),
        supplied: (shaft_driven_dot * p.shaft_driven_field_force)
            .add_product(shaft_reed_dot, p.shaft_reed_field_force)
            .add_product(shaft_middle_dot, p.shaft_middle_field_force) - t2,
        dissipated: R::literal(0.0),
    }
}

/// Entry of the state on whose rate a term `t^k e^(g t) (C cos(w t) + S sin(w t))` acts, and k.
pub const EXCITATION_TERMS: [(u32, u32); 4] = [(4, 0), (4, 0), (5, 0), (6, 0)];

/// Times at which pieces of the excitation end.
pub const SWITCHES: usize = 0;

/// g, w, C and S of every term of the excitation, on the piece that holds `time`.
///
/// 8 operations.
#[must_use]
pub fn excitation<R: Real>(_time: R, p: &Parameters<R>) -> [R; 16] {
    let inverse_shaft_driven_field_inertia = R::literal(1.0)
        / p.shaft_driven_field_inertia;
    [
        R::literal(0.0),
        R::literal(0.0),
        p.shaft_driven_field_force * inverse_shaft_driven_field_inertia,
        R::literal(0.0),
        R::literal(0.0),
        p.drive_frequency,
        R::literal(0.0),
        p.drive_amplitude * p.drive_stiffness * inverse_shaft_driven_field_inertia,
        R::literal(0.0),
        R::literal(0.0),
        p.shaft_reed_field_force * (R::literal(1.0) / p.shaft_reed_field_inertia),
        R::literal(0.0),
        R::literal(0.0),
        R::literal(0.0),
        p.shaft_middle_field_force * (R::literal(1.0) / p.shaft_middle_field_inertia),
        R::literal(0.0),
    ]
}

/// Times at which pieces of the excitation end \[s\]; not finite where there is none.
///
/// No operations.
#[must_use]
pub fn switches<R: Real>(_p: &Parameters<R>) -> [R; SWITCHES] {
    []
}

impl<R: Real> LinearEquations<R> for ReedBeatUp {
    fn excitation_terms(&self) -> &[(u32, u32)] {
        &EXCITATION_TERMS
    }
    fn excitation(&self, time: R, parameters: &[R], values: &mut [R]) {
        values.copy_from_slice(&excitation(time, &parameters_of(parameters)));
    }
    fn switches(&self) -> usize {
        SWITCHES
    }
    fn switch_times(&self, parameters: &[R], times: &mut [R]) {
        times.copy_from_slice(&switches(&parameters_of(parameters)));
    }
}

impl Describe for ReedBeatUp {
    fn name(&self) -> &'static str {
        "reed_beat_up"
    }
    fn title(&self) -> &'static str {
        "Beat-up of a reed by an elastic shaft"
    }
    fn shape(&self) -> Shape {
        Shape {
            coordinates: COORDINATES,
            positions: 4,
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

impl<R: Real> Simulator<R> for ReedBeatUp {
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
    fn linear(&self) -> Option<&dyn LinearEquations<R>> {
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
];

static STATE_SCALES: [f64; STATES] = [1.0, 1.0, 1.0, 1.0, 100.0, 100.0, 100.0, 100.0];

static PARAMETER_QUANTITIES: [Quantity<'static>; PARAMETERS] = [
    Quantity {
        name: "drive.stiffness",
        unit: "N m/rad",
        doc: "stiffness C0 of the drive spring",
    },
    Quantity {
        name: "drive.amplitude",
        unit: "rad",
        doc: "amplitude of the imposed angle",
    },
    Quantity {
        name: "drive.frequency",
        unit: "rad/s",
        doc: "angular frequency of the imposed angle",
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
    45200.0,
    0.251_719_699_449_452_3,
    119.180_183_615_403_86,
    1.75,
    1.0,
    0.025,
    7659.0,
    7.692_307_692_307_692e10,
    0.0,
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
        name: "drive_angle",
        unit: "rad",
        doc: "imposed angle u0",
    },
    Quantity {
        name: "driven_angle",
        unit: "rad",
        doc: "angle of the section, at port driven",
    },
    Quantity {
        name: "shaft_angle",
        unit: "rad",
        doc: "angle of the section, at port reed",
    },
    Quantity {
        name: "middle_angle",
        unit: "rad",
        doc: "angle of the section, at port middle",
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
        name: "fell_torque",
        unit: "N m",
        doc: "torque of the fell on the reed, against it",
    },
];

/// The run the spec asks for.
pub const RUN_DEFAULTS: RunDefaults<'static> = RunDefaults {
    from: 0.0,
    until: 0.0527,
    points: 501,
    rtol: 1e-8,
    method: "dop853",
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
    pub const PARAMETERS: [u32; 6] = [3, 4, 5, 6, 7, 8];
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

impl<R: Real> FieldScene<R> for ReedBeatUp {
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
            coordinate: Some(0),
            place: FieldPlace::Start,
            at: 0.0,
            handed: 13,
        },
        FieldAttachment {
            coordinate: Some(1),
            place: FieldPlace::Inside,
            at: 1.0,
            handed: 17,
        },
        FieldAttachment {
            coordinate: Some(2),
            place: FieldPlace::End,
            at: 1.75,
            handed: 21,
        },
    ],
    parameters: &shaft_u::PARAMETERS,
    elements: 24,
    order: 4,
};

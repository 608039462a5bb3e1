// Emitted by Machinist 0.1.0; do not edit. To make it again:
//
//     cargo run --release -- gen
//
// Sources, with SHA-256:
//   3f99403cbaf0e2e2849ad80741993c1c9b630ae018f8024ae94a647d656c194b  bench/m4.toml
//
// Benchmark M4: reed as a torsional shaft
//
// An undamped shaft driven by a spring at one end, with the reed and a spring to ground
// at four sevenths of its length. Elements of order 1 are the benchmark's lumped masses:
// M4:70 is cut into 70 of them.
//
// Source:
//   Benchmark models of textile-machine dynamics.
//
// Shapes; all quantities are in SI units:
//   coordinates               2
//   first-order states        0
//   states                    4
//   parameters               17
//   outputs                   4
//   discontinuities           0
//
// State:
//     0  shaft.driven      [rad]    angle of the section, at port driven
//     1  shaft.reed        [rad]    angle of the section, at port reed
//     2  shaft.driven_dot  [rad/s]  rate of angle of the section, at port driven
//     3  shaft.reed_dot    [rad/s]  rate of angle of the section, at port reed
//
// Nonzeros:
//   mass_matrix               2 of 2 by 2
//   rate_jacobian             4 of 4 by 4
//   parameter_jacobian        8 of 4 by 17
//
// Operations:
//   initial_state             0
//   discontinuities           0
//   rate                     15
//   mass_matrix               3
//   forcing                   8
//   rate_jacobian             9
//   parameter_jacobian       31
//   time_derivative           6
//   outputs                   0
//   energy                   23
//   power_balance            35
// With constants of the parameters, prepared once a run:
//   prepare                   9
//   prepared_rate            10
//   prepared_rate_jacobian    0

use ::machinist_contract::{
    Describe, Energy, PowerBalance, Quantity, Real, RunDefaults, Shape, Simulator,
    SparsityPattern, linear::LinearEquations,
    field::{FieldAttachment, FieldDescription, FieldPlace, FieldPoint, FieldScene},
};

/// Generalized coordinates, n.
pub const COORDINATES: usize = 2;

/// Length of the state y.
pub const STATES: usize = 4;

/// Parameters.
pub const PARAMETERS: usize = 17;

/// Wanted outputs.
pub const OUTPUTS: usize = 4;

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
    rows: 4,
    columns: 4,
    entries: &[(0, 2), (1, 3), (2, 0), (3, 1)],
};

/// Nonzeros of dy'/dp.
pub const PARAMETER_JACOBIAN_PATTERN: SparsityPattern<'static> = SparsityPattern {
    rows: 4,
    columns: 17,
    entries: &[(2, 7), (2, 9), (2, 10), (3, 5), (3, 6), (3, 8), (3, 13), (3, 14)],
};

/// Benchmark M4: reed as a torsional shaft
///
/// An undamped shaft driven by a spring at one end, with the reed and a spring to ground
/// at four sevenths of its length. Elements of order 1 are the benchmark's lumped masses:
/// M4:70 is cut into 70 of them.
///
/// Source: Benchmark models of textile-machine dynamics.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct M4;

/// Parameters, in SI units; the default holds the values of the spec.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Parameters<R> {
    /// shaft.length: length \[m\]. In the spec: 1.75.
    pub shaft_length: R,
    /// shaft.radius: radius \[m\]. In the spec: 0.025.
    pub shaft_radius: R,
    /// shaft.density: density \[kg/m^3\]. In the spec: 7659.0.
    pub shaft_density: R,
    /// shaft.elasticity: modulus of elasticity \[Pa\]. In the spec: 200000000000.0.
    pub shaft_elasticity: R,
    /// shaft.poisson: Poisson's ratio \[1\]. In the spec: 0.3.
    pub shaft_poisson: R,
    /// reed.mass: mass \[kg\]. In the spec: 3.56.
    pub reed_mass: R,
    /// reed.radius: distance from the axis \[m\]. In the spec: 0.12.
    pub reed_radius: R,
    /// drive_spring.stiffness: stiffness \[N m/rad\]. In the spec: 45200.0.
    pub drive_spring_stiffness: R,
    /// ground_spring.stiffness: stiffness \[N m/rad\]. In the spec: 15600.0.
    pub ground_spring_stiffness: R,
    /// shaft.driven_field_inertia: inertia of the field's node; the field sets it \[J s^2/(rad)^2\]. In the spec: 1.0.
    pub shaft_driven_field_inertia: R,
    /// shaft.driven_field_force: force of the field on its node; the field sets it \[J/(rad)\]. In the spec: 0.0.
    pub shaft_driven_field_force: R,
    /// shaft.driven_theta_x_before: slope of the field before the port; the field sets it \[rad/m\]. In the spec: 0.0.
    pub shaft_driven_theta_x_before: R,
    /// shaft.driven_theta_x_after: slope of the field after the port; the field sets it \[rad/m\]. In the spec: 0.0.
    pub shaft_driven_theta_x_after: R,
    /// shaft.reed_field_inertia: inertia of the field's node; the field sets it \[J s^2/(rad)^2\]. In the spec: 1.0.
    pub shaft_reed_field_inertia: R,
    /// shaft.reed_field_force: force of the field on its node; the field sets it \[J/(rad)\]. In the spec: 0.0.
    pub shaft_reed_field_force: R,
    /// shaft.reed_theta_x_before: slope of the field before the port; the field sets it \[rad/m\]. In the spec: 0.0.
    pub shaft_reed_theta_x_before: R,
    /// shaft.reed_theta_x_after: slope of the field after the port; the field sets it \[rad/m\]. In the spec: 0.0.
    pub shaft_reed_theta_x_after: R,
}

impl<R: Real> Parameters<R> {
    /// From the numbers in their order.
    #[must_use]
    #[inline]
    pub fn from_array(values: [R; PARAMETERS]) -> Self {
        Self {
            shaft_length: values[0],
            shaft_radius: values[1],
            shaft_density: values[2],
            shaft_elasticity: values[3],
            shaft_poisson: values[4],
            reed_mass: values[5],
            reed_radius: values[6],
            drive_spring_stiffness: values[7],
            ground_spring_stiffness: values[8],
            shaft_driven_field_inertia: values[9],
            shaft_driven_field_force: values[10],
            shaft_driven_theta_x_before: values[11],
            shaft_driven_theta_x_after: values[12],
            shaft_reed_field_inertia: values[13],
            shaft_reed_field_force: values[14],
            shaft_reed_theta_x_before: values[15],
            shaft_reed_theta_x_after: values[16],
        }
    }
    /// The numbers in their order.
    #[must_use]
    #[inline]
    pub fn to_array(self) -> [R; PARAMETERS] {
        [
            self.shaft_length,
            self.shaft_radius,
            self.shaft_density,
            self.shaft_elasticity,
            self.shaft_poisson,
            self.reed_mass,
            self.reed_radius,
            self.drive_spring_stiffness,
            self.ground_spring_stiffness,
            self.shaft_driven_field_inertia,
            self.shaft_driven_field_force,
            self.shaft_driven_theta_x_before,
            self.shaft_driven_theta_x_after,
            self.shaft_reed_field_inertia,
            self.shaft_reed_field_force,
            self.shaft_reed_theta_x_before,
            self.shaft_reed_theta_x_after,
        ]
    }
}

impl<R: Real> Default for Parameters<R> {
    fn default() -> Self {
        Self {
            shaft_length: R::literal(1.75),
            shaft_radius: R::literal(0.025),
            shaft_density: R::literal(7659.0),
            shaft_elasticity: R::literal(2e11),
            shaft_poisson: R::literal(0.3),
            reed_mass: R::literal(3.56),
            reed_radius: R::literal(0.12),
            drive_spring_stiffness: R::literal(45200.0),
            ground_spring_stiffness: R::literal(15600.0),
            shaft_driven_field_inertia: R::literal(1.0),
            shaft_driven_field_force: R::literal(0.0),
            shaft_driven_theta_x_before: R::literal(0.0),
            shaft_driven_theta_x_after: R::literal(0.0),
            shaft_reed_field_inertia: R::literal(1.0),
            shaft_reed_field_force: R::literal(0.0),
            shaft_reed_theta_x_before: R::literal(0.0),
            shaft_reed_theta_x_after: R::literal(0.0),
        }
    }
}

/// Wanted outputs, in SI units.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Outputs<R> {
    /// driven_angle: angle of the section, at port driven \[rad\].
    pub driven_angle: R,
    /// driven_speed: rate of angle of the section, at port driven \[rad/s\].
    pub driven_speed: R,
    /// reed_angle: angle of the section, at port reed \[rad\].
    pub reed_angle: R,
    /// reed_speed: rate of angle of the section, at port reed \[rad/s\].
    pub reed_speed: R,
}

impl<R: Real> Outputs<R> {
    /// From the numbers in their order.
    #[must_use]
    #[inline]
    pub fn from_array(values: [R; OUTPUTS]) -> Self {
        Self {
            driven_angle: values[0],
            driven_speed: values[1],
            reed_angle: values[2],
            reed_speed: values[3],
        }
    }
    /// The numbers in their order.
    #[must_use]
    #[inline]
    pub fn to_array(self) -> [R; OUTPUTS] {
        [self.driven_angle, self.driven_speed, self.reed_angle, self.reed_speed]
    }
}

/// Where to find what in the state.
pub mod state {
    /// shaft.driven: angle of the section, at port driven \[rad\].
    pub const SHAFT_DRIVEN: usize = 0;
    /// shaft.reed: angle of the section, at port reed \[rad\].
    pub const SHAFT_REED: usize = 1;
    /// shaft.driven_dot: rate of angle of the section, at port driven \[rad/s\].
    pub const SHAFT_DRIVEN_DOT: usize = 2;
    /// shaft.reed_dot: rate of angle of the section, at port reed \[rad/s\].
    pub const SHAFT_REED_DOT: usize = 3;
}

/// Constants that `prepare` computes.
pub const CONSTANTS: usize = 4;

#[allow(missing_docs, reason = "`prepare` says what each is")]
/// What parameters alone decide; `prepare` says what each is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Constants<R> {
    pub inverse_shaft_driven_field_inertia: R,
    pub t0: R,
    pub shaft_driven_dot_dot_by_shaft_driven: R,
    pub shaft_reed_dot_dot_by_shaft_reed: R,
}

impl<R: Real> Constants<R> {
    /// From the numbers in their order.
    #[must_use]
    #[inline]
    pub fn from_array(values: [R; CONSTANTS]) -> Self {
        Self {
            inverse_shaft_driven_field_inertia: values[0],
            t0: values[1],
            shaft_driven_dot_dot_by_shaft_driven: values[2],
            shaft_reed_dot_dot_by_shaft_reed: values[3],
        }
    }
    /// The numbers in their order.
    #[must_use]
    #[inline]
    pub fn to_array(self) -> [R; CONSTANTS] {
        [
            self.inverse_shaft_driven_field_inertia,
            self.t0,
            self.shaft_driven_dot_dot_by_shaft_driven,
            self.shaft_reed_dot_dot_by_shaft_reed,
        ]
    }
}

/// What `rate` and `rate_jacobian` need of the parameters, once a run.
///
/// 9 operations.
#[must_use]
#[inline]
pub fn prepare<R: Real>(p: &Parameters<R>) -> Constants<R> {
    let inverse_shaft_driven_field_inertia = R::literal(1.0)
        / p.shaft_driven_field_inertia;
    let t0 = R::literal(1.0)
        / p
            .shaft_reed_field_inertia
            .add_product(p.reed_mass, p.reed_radius * p.reed_radius);
    let shaft_driven_dot_dot_by_shaft_driven = -(p.drive_spring_stiffness
        * inverse_shaft_driven_field_inertia);
    let shaft_reed_dot_dot_by_shaft_reed = -(p.ground_spring_stiffness * t0);
    Constants {
        inverse_shaft_driven_field_inertia,
        t0,
        shaft_driven_dot_dot_by_shaft_driven,
        shaft_reed_dot_dot_by_shaft_reed,
    }
}

/// State at the start of the run, in the units of the states.
///
/// No operations.
#[must_use]
pub fn initial_state<R: Real>(_p: &Parameters<R>) -> [R; STATES] {
    [R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0)]
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
/// 15 operations.
#[must_use]
#[inline]
pub fn rate<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>) -> [R; STATES] {
    prepared_rate(time, state, p, &prepare(p))
}

/// As `rate`, with the constants of the parameters from `prepare`.
///
/// 10 operations.
#[must_use]
#[inline]
pub fn prepared_rate<R: Real>(
    time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
    c: &Constants<R>,
) -> [R; STATES] {
    let [shaft_driven, shaft_reed, shaft_driven_dot, shaft_reed_dot] = *state;
    let drive = R::literal(0.12)
        * (R::literal(8.0 * core::f64::consts::PI) * time).sin();
    let shaft_reed_dot_dot = p
        .shaft_reed_field_force
        .sub_product(p.ground_spring_stiffness, shaft_reed) * c.t0;
    let shaft_driven_dot_dot = p
        .shaft_driven_field_force
        .sub_product(p.drive_spring_stiffness, shaft_driven - drive)
        * c.inverse_shaft_driven_field_inertia;
    [shaft_driven_dot, shaft_reed_dot, shaft_driven_dot_dot, shaft_reed_dot_dot]
}

/// `M = d2L/dq'2`, values in the order of `MASS_MATRIX_PATTERN`.
///
/// 3 operations.
#[must_use]
pub fn mass_matrix<R: Real>(
    _time: R,
    _state: &[R; STATES],
    p: &Parameters<R>,
) -> [R; 2] {
    [
        p.shaft_driven_field_inertia,
        p
            .shaft_reed_field_inertia
            .add_product(p.reed_mass, p.reed_radius * p.reed_radius),
    ]
}

/// `f` of `M q'' = f(q, q', z, t)`, one for each coordinate.
///
/// 8 operations.
#[must_use]
pub fn forcing<R: Real>(
    time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
) -> [R; COORDINATES] {
    let [shaft_driven, shaft_reed, ..] = *state;
    let drive = R::literal(0.12)
        * (R::literal(8.0 * core::f64::consts::PI) * time).sin();
    let shaft_driven_forcing = p
        .shaft_driven_field_force
        .sub_product(p.drive_spring_stiffness, shaft_driven - drive);
    let shaft_reed_forcing = p
        .shaft_reed_field_force
        .sub_product(p.ground_spring_stiffness, shaft_reed);
    [shaft_driven_forcing, shaft_reed_forcing]
}

/// `dy'/dy`, values in the order of `RATE_JACOBIAN_PATTERN`.
///
/// 9 operations.
#[must_use]
#[inline]
pub fn rate_jacobian<R: Real>(
    time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
) -> [R; 4] {
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
) -> [R; 4] {
    [
        R::literal(1.0),
        R::literal(1.0),
        c.shaft_driven_dot_dot_by_shaft_driven,
        c.shaft_reed_dot_dot_by_shaft_reed,
    ]
}

/// `dy'/dp`, values in the order of `PARAMETER_JACOBIAN_PATTERN`.
///
/// 31 operations.
#[must_use]
pub fn parameter_jacobian<R: Real>(
    time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
) -> [R; 8] {
    let [shaft_driven, shaft_reed, ..] = *state;
    let drive = R::literal(0.12)
        * (R::literal(8.0 * core::f64::consts::PI) * time).sin();
    let reed_radius_squared = p.reed_radius * p.reed_radius;
    let inverse_shaft_driven_field_inertia = R::literal(1.0)
        / p.shaft_driven_field_inertia;
    let shaft_reed_dot_dot_by_shaft_reed_field_force = R::literal(1.0)
        / p.shaft_reed_field_inertia.add_product(p.reed_mass, reed_radius_squared);
    let shaft_reed_dot_dot = p
        .shaft_reed_field_force
        .sub_product(p.ground_spring_stiffness, shaft_reed)
        * shaft_reed_dot_dot_by_shaft_reed_field_force;
    let shaft_driven_dot_dot = p
        .shaft_driven_field_force
        .sub_product(p.drive_spring_stiffness, shaft_driven - drive)
        * inverse_shaft_driven_field_inertia;
    let shaft_reed_dot_dot_by_reed_mass = -(reed_radius_squared * shaft_reed_dot_dot
        * shaft_reed_dot_dot_by_shaft_reed_field_force);
    let shaft_reed_dot_dot_by_reed_radius = -(R::literal(2.0) * p.reed_mass
        * p.reed_radius * shaft_reed_dot_dot
        * shaft_reed_dot_dot_by_shaft_reed_field_force);
    let shaft_driven_dot_dot_by_drive_spring_stiffness = (drive - shaft_driven)
        * inverse_shaft_driven_field_inertia;
    let shaft_reed_dot_dot_by_ground_spring_stiffness = -(shaft_reed
        * shaft_reed_dot_dot_by_shaft_reed_field_force);
    let shaft_driven_dot_dot_by_shaft_driven_field_inertia = -(shaft_driven_dot_dot
        * inverse_shaft_driven_field_inertia);
    let shaft_reed_dot_dot_by_shaft_reed_field_inertia = -(shaft_reed_dot_dot
        * shaft_reed_dot_dot_by_shaft_reed_field_force);
    [
        shaft_driven_dot_dot_by_drive_spring_stiffness,
        shaft_driven_dot_dot_by_shaft_driven_field_inertia,
        inverse_shaft_driven_field_inertia,
        shaft_reed_dot_dot_by_reed_mass,
        shaft_reed_dot_dot_by_reed_radius,
        shaft_reed_dot_dot_by_ground_spring_stiffness,
        shaft_reed_dot_dot_by_shaft_reed_field_inertia,
        shaft_reed_dot_dot_by_shaft_reed_field_force,
    ]
}

/// Partial derivative of `y'` with respect to time.
///
/// 6 operations.
#[must_use]
pub fn time_derivative<R: Real>(
    time: R,
    _state: &[R; STATES],
    p: &Parameters<R>,
) -> [R; STATES] {
    let shaft_driven_dot_dot_by_time = R::literal(3.015_928_947_446_201)
        * p.drive_spring_stiffness
        * (R::literal(8.0 * core::f64::consts::PI) * time).cos()
        * (R::literal(1.0) / p.shaft_driven_field_inertia);
    [R::literal(0.0), R::literal(0.0), shaft_driven_dot_dot_by_time, R::literal(0.0)]
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
    let [shaft_driven, shaft_reed, shaft_driven_dot, shaft_reed_dot] = *state;
    Outputs {
        driven_angle: shaft_driven,
        driven_speed: shaft_driven_dot,
        reed_angle: shaft_reed,
        reed_speed: shaft_reed_dot,
    }
}

/// T, V and the energy of first-order states \[J\].
///
/// 23 operations.
#[must_use]
pub fn energy<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>) -> Energy<R> {
    let [shaft_driven, shaft_reed, shaft_driven_dot, shaft_reed_dot] = *state;
    let drive = R::literal(0.12)
        * (R::literal(8.0 * core::f64::consts::PI) * time).sin();
    let shaft_driven_minus_drive = shaft_driven - drive;
    let shaft_reed_dot_squared = shaft_reed_dot * shaft_reed_dot;
    Energy {
        kinetic: (R::literal(0.5) * p.shaft_driven_field_inertia
            * (shaft_driven_dot * shaft_driven_dot))
            .add_product(
                R::literal(0.5) * p.reed_mass * (p.reed_radius * p.reed_radius),
                shaft_reed_dot_squared,
            )
            .add_product(
                R::literal(0.5) * p.shaft_reed_field_inertia,
                shaft_reed_dot_squared,
            ),
        potential: (R::literal(0.5) * p.ground_spring_stiffness
            * (shaft_reed * shaft_reed))
            .add_product(
                R::literal(0.5) * p.drive_spring_stiffness,
                shaft_driven_minus_drive * shaft_driven_minus_drive,
            ),
        stored: R::literal(0.0),
    }
}

/// `dE/dt`, power supplied and power dissipated \[W\].
///
/// 35 operations.
#[must_use]
pub fn power_balance<R: Real>(
    time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
) -> PowerBalance<R> {
    let [shaft_driven, shaft_reed, shaft_driven_dot, shaft_reed_dot] = *state;
    let t0 = R::literal(8.0 * core::f64::consts::PI) * time;
    let (t1, t2) = t0.sin_cos();
    let drive = R::literal(0.12) * t1;
    let reed_mass_times_reed_radius_squared = p.reed_mass
        * (p.reed_radius * p.reed_radius);
    let shaft_driven_minus_drive = shaft_driven - drive;
    let t3 = p.drive_spring_stiffness * shaft_driven_minus_drive;
    let t4 = p.ground_spring_stiffness * shaft_reed;
    let shaft_reed_dot_dot = (p.shaft_reed_field_force - t4)
        * (R::literal(1.0)
            / (reed_mass_times_reed_radius_squared + p.shaft_reed_field_inertia));
    let shaft_driven_dot_dot = (p.shaft_driven_field_force - t3)
        * (R::literal(1.0) / p.shaft_driven_field_inertia);
    let t5 = R::literal(3.015_928_947_446_201) * p.drive_spring_stiffness
        * shaft_driven_minus_drive * t2;
    PowerBalance {
        stored_rate: (-t5)
            .add_product(t3, shaft_driven_dot)
            .add_product(t4, shaft_reed_dot)
            .add_product(
                shaft_driven_dot * p.shaft_driven_field_inertia,
                shaft_driven_dot_dot,
            )
            .add_product(
                (shaft_reed_dot * p.shaft_reed_field_inertia)
                    .add_product(reed_mass_times_reed_radius_squared, shaft_reed_dot),
                shaft_reed_dot_dot,
            ),
        supplied: (shaft_driven_dot * p.shaft_driven_field_force)
            .add_product(shaft_reed_dot, p.shaft_reed_field_force) - t5,
        dissipated: R::literal(0.0),
    }
}

/// Entry of the state on whose rate a term `t^k e^(g t) (C cos(w t) + S sin(w t))` acts, and k.
pub const EXCITATION_TERMS: [(u32, u32); 3] = [(2, 0), (2, 0), (3, 0)];

/// Times at which pieces of the excitation end.
pub const SWITCHES: usize = 0;

/// g, w, C and S of every term of the excitation, on the piece that holds `time`.
///
/// 10 operations.
#[must_use]
pub fn excitation<R: Real>(_time: R, p: &Parameters<R>) -> [R; 12] {
    let inverse_shaft_driven_field_inertia = R::literal(1.0)
        / p.shaft_driven_field_inertia;
    [
        R::literal(0.0),
        R::literal(0.0),
        p.shaft_driven_field_force * inverse_shaft_driven_field_inertia,
        R::literal(0.0),
        R::literal(0.0),
        R::literal(8.0 * core::f64::consts::PI),
        R::literal(0.0),
        -(R::literal(-0.12) * p.drive_spring_stiffness
            * inverse_shaft_driven_field_inertia),
        R::literal(0.0),
        R::literal(0.0),
        p.shaft_reed_field_force
            * (R::literal(1.0)
                / p
                    .shaft_reed_field_inertia
                    .add_product(p.reed_mass, p.reed_radius * p.reed_radius)),
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

impl<R: Real> LinearEquations<R> for M4 {
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

impl Describe for M4 {
    fn name(&self) -> &'static str {
        "m4"
    }
    fn title(&self) -> &'static str {
        "Benchmark M4: reed as a torsional shaft"
    }
    fn shape(&self) -> Shape {
        Shape {
            coordinates: COORDINATES,
            positions: 2,
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

impl<R: Real> Simulator<R> for M4 {
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
        name: "shaft.driven_dot",
        unit: "rad/s",
        doc: "rate of angle of the section, at port driven",
    },
    Quantity {
        name: "shaft.reed_dot",
        unit: "rad/s",
        doc: "rate of angle of the section, at port reed",
    },
];

static STATE_SCALES: [f64; STATES] = [0.12, 0.12, 3.0, 3.0];

static PARAMETER_QUANTITIES: [Quantity<'static>; PARAMETERS] = [
    Quantity {
        name: "shaft.length",
        unit: "m",
        doc: "length",
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
        name: "shaft.elasticity",
        unit: "Pa",
        doc: "modulus of elasticity",
    },
    Quantity {
        name: "shaft.poisson",
        unit: "1",
        doc: "Poisson's ratio",
    },
    Quantity {
        name: "reed.mass",
        unit: "kg",
        doc: "mass",
    },
    Quantity {
        name: "reed.radius",
        unit: "m",
        doc: "distance from the axis",
    },
    Quantity {
        name: "drive_spring.stiffness",
        unit: "N m/rad",
        doc: "stiffness",
    },
    Quantity {
        name: "ground_spring.stiffness",
        unit: "N m/rad",
        doc: "stiffness",
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
        name: "shaft.driven_theta_x_before",
        unit: "rad/m",
        doc: "slope of the field before the port; the field sets it",
    },
    Quantity {
        name: "shaft.driven_theta_x_after",
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
        name: "shaft.reed_theta_x_before",
        unit: "rad/m",
        doc: "slope of the field before the port; the field sets it",
    },
    Quantity {
        name: "shaft.reed_theta_x_after",
        unit: "rad/m",
        doc: "slope of the field after the port; the field sets it",
    },
];

static PARAMETER_DEFAULTS: [f64; PARAMETERS] = [
    1.75,
    0.025,
    7659.0,
    2e11,
    0.3,
    3.56,
    0.12,
    45200.0,
    15600.0,
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
        name: "driven_angle",
        unit: "rad",
        doc: "angle of the section, at port driven",
    },
    Quantity {
        name: "driven_speed",
        unit: "rad/s",
        doc: "rate of angle of the section, at port driven",
    },
    Quantity {
        name: "reed_angle",
        unit: "rad",
        doc: "angle of the section, at port reed",
    },
    Quantity {
        name: "reed_speed",
        unit: "rad/s",
        doc: "rate of angle of the section, at port reed",
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

/// The field shaft.theta: angle of the section \[rad\].
///
/// One generic element: what acts at a point with u, u_x, u_t, u_xt at x. The loops over elements are the contract's.
pub mod shaft_theta {
    #[allow(
        clippy::wildcard_imports,
        unused_imports,
        reason = "what a field needs of it"
    )]
    use super::*;
    /// Parameters that the field depends on.
    pub const PARAMETERS: [u32; 5] = [0, 1, 2, 3, 4];
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
    pub fn inertia_gradient<R: Real>(_x: R, p: &Parameters<R>) -> [R; 6] {
        let shaft_radius_squared = p.shaft_radius * p.shaft_radius;
        [
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
        let [_, theta_x, _, _] = *point;
        let shaft_radius_squared = p.shaft_radius * p.shaft_radius;
        [
            R::literal(0.0),
            -(R::literal(core::f64::consts::FRAC_PI_4) * p.shaft_elasticity
                * (shaft_radius_squared * shaft_radius_squared)
                / (R::literal(1.0) + p.shaft_poisson) * theta_x),
        ]
    }
    /// Derivatives of f_0, then of f_1, with respect to u, u_x, u_t, u_xt.
    ///
    /// 7 operations.
    #[must_use]
    #[inline]
    pub fn force_jacobian<R: Real>(
        _time: R,
        _x: R,
        _point: &FieldPoint<R>,
        p: &Parameters<R>,
    ) -> [R; 8] {
        let shaft_radius_squared = p.shaft_radius * p.shaft_radius;
        [
            R::literal(0.0),
            R::literal(0.0),
            R::literal(0.0),
            R::literal(0.0),
            R::literal(0.0),
            -(R::literal(core::f64::consts::FRAC_PI_4) * p.shaft_elasticity
                * (shaft_radius_squared * shaft_radius_squared)
                / (R::literal(1.0) + p.shaft_poisson)),
            R::literal(0.0),
            R::literal(0.0),
        ]
    }
    /// Derivatives of f_0 and f_1 with respect to x, to t, then to `PARAMETERS`.
    ///
    /// 18 operations.
    #[must_use]
    #[inline]
    pub fn force_gradient<R: Real>(
        _time: R,
        _x: R,
        point: &FieldPoint<R>,
        p: &Parameters<R>,
    ) -> [R; 14] {
        let [_, theta_x, _, _] = *point;
        let shaft_radius_squared = p.shaft_radius * p.shaft_radius;
        let shaft_radius_squared_squared = shaft_radius_squared * shaft_radius_squared;
        let t0 = R::literal(1.0) + p.shaft_poisson;
        [
            R::literal(0.0),
            R::literal(0.0),
            R::literal(0.0),
            R::literal(0.0),
            R::literal(0.0),
            R::literal(0.0),
            R::literal(0.0),
            -(R::literal(core::f64::consts::PI) * p.shaft_elasticity
                * (shaft_radius_squared * p.shaft_radius) / t0 * theta_x),
            R::literal(0.0),
            R::literal(0.0),
            R::literal(0.0),
            -(R::literal(core::f64::consts::FRAC_PI_4) * shaft_radius_squared_squared
                / t0 * theta_x),
            R::literal(0.0),
            R::literal(core::f64::consts::FRAC_PI_4) * p.shaft_elasticity
                * shaft_radius_squared_squared / (t0 * t0) * theta_x,
        ]
    }
    /// T and V a length \[J/m\].
    ///
    /// 12 operations.
    #[must_use]
    #[inline]
    pub fn energy<R: Real>(
        _time: R,
        _x: R,
        point: &FieldPoint<R>,
        p: &Parameters<R>,
    ) -> [R; 2] {
        let [_, theta_x, theta_dot, _] = *point;
        let shaft_radius_squared = p.shaft_radius * p.shaft_radius;
        let shaft_radius_squared_squared = shaft_radius_squared * shaft_radius_squared;
        [
            R::literal(core::f64::consts::FRAC_PI_4) * p.shaft_density
                * shaft_radius_squared_squared * (theta_dot * theta_dot),
            R::literal(0.392_699_081_698_724_14) * p.shaft_elasticity
                * shaft_radius_squared_squared / (R::literal(1.0) + p.shaft_poisson)
                * (theta_x * theta_x),
        ]
    }
    /// Rate of V, power supplied and power dissipated, a length \[W/m\].
    ///
    /// 8 operations.
    #[must_use]
    #[inline]
    pub fn power<R: Real>(
        _time: R,
        _x: R,
        point: &FieldPoint<R>,
        p: &Parameters<R>,
    ) -> [R; 3] {
        let [_, theta_x, _, theta_x_dot] = *point;
        let shaft_radius_squared = p.shaft_radius * p.shaft_radius;
        [
            R::literal(core::f64::consts::FRAC_PI_4) * p.shaft_elasticity
                * (shaft_radius_squared * shaft_radius_squared)
                / (R::literal(1.0) + p.shaft_poisson) * theta_x * theta_x_dot,
            R::literal(0.0),
            R::literal(0.0),
        ]
    }
    /// x of the attachments, then the length \[m\].
    ///
    /// 1 operations.
    #[must_use]
    #[inline]
    pub fn places<R: Real>(p: &Parameters<R>) -> [R; 3] {
        [
            R::literal(0.0),
            R::literal(0.571_428_571_428_571_4) * p.shaft_length,
            p.shaft_length,
        ]
    }
    /// Derivatives of `places` with respect to `PARAMETERS`, row by row.
    ///
    /// 0 operations.
    #[must_use]
    #[inline]
    pub fn places_gradient<R: Real>(_p: &Parameters<R>) -> [R; 15] {
        [
            R::literal(0.0),
            R::literal(0.0),
            R::literal(0.0),
            R::literal(0.0),
            R::literal(0.0),
            R::literal(0.571_428_571_428_571_4),
            R::literal(0.0),
            R::literal(0.0),
            R::literal(0.0),
            R::literal(0.0),
            R::literal(1.0),
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
    /// 6 operations for all points, 2 for each.
    pub fn on_slope<R: Real>(u_x: &[R], u_xt: &[R], p: &Parameters<R>, force: &mut [R]) {
        let shaft_radius_squared = p.shaft_radius * p.shaft_radius;
        let t0 = R::literal(core::f64::consts::FRAC_PI_4) * p.shaft_elasticity
            * (shaft_radius_squared * shaft_radius_squared)
            / (R::literal(1.0) + p.shaft_poisson);
        for ((&theta_x, _), force) in u_x.iter().zip(u_xt).zip(force) {
            *force = -(t0 * theta_x);
        }
    }
    /// df_1/du_x and df_1/du_xt, at many points.
    ///
    /// 7 operations for all points, 0 for each.
    pub fn on_slope_jacobian<R: Real>(
        u_x: &[R],
        u_xt: &[R],
        p: &Parameters<R>,
        by_u_x: &mut [R],
        by_u_xt: &mut [R],
    ) {
        let shaft_radius_squared = p.shaft_radius * p.shaft_radius;
        let t0 = -(R::literal(core::f64::consts::FRAC_PI_4) * p.shaft_elasticity
            * (shaft_radius_squared * shaft_radius_squared)
            / (R::literal(1.0) + p.shaft_poisson));
        for (((_, _), by_u_x), by_u_xt) in u_x.iter().zip(u_xt).zip(by_u_x).zip(by_u_xt)
        {
            *by_u_x = t0;
            *by_u_xt = R::literal(0.0);
        }
    }
}

impl<R: Real> FieldScene<R> for M4 {
    fn fields(&self) -> usize {
        1
    }
    fn field(&self, index: usize) -> FieldDescription<'_> {
        match index {
            0 => SHAFT_THETA_FIELD,
            _ => no_field(index),
        }
    }
    fn field_inertia(&self, index: usize, x: R, parameters: &[R]) -> R {
        let p = parameters_of(parameters);
        let [inertia] = match index {
            0 => shaft_theta::inertia(x, &p),
            _ => no_field(index),
        };
        inertia
    }
    fn field_initial(&self, index: usize, x: R, parameters: &[R]) -> [R; 2] {
        let p = parameters_of(parameters);
        match index {
            0 => shaft_theta::initial(x, &p),
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
            0 => shaft_theta::force(time, x, point, &p),
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
            0 => shaft_theta::force_jacobian(time, x, point, &p),
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
            0 => shaft_theta::energy(time, x, point, &p),
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
            0 => shaft_theta::power(time, x, point, &p),
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
            0 => values.copy_from_slice(&shaft_theta::inertia_gradient(x, &p)),
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
            0 => values.copy_from_slice(&shaft_theta::force_gradient(time, x, point, &p)),
            _ => no_field(index),
        }
    }
    fn field_places(&self, index: usize, parameters: &[R], values: &mut [R]) {
        let p = parameters_of(parameters);
        match index {
            0 => values.copy_from_slice(&shaft_theta::places(&p)),
            _ => no_field(index),
        }
    }
    fn field_places_gradient(&self, index: usize, parameters: &[R], values: &mut [R]) {
        let p = parameters_of(parameters);
        match index {
            0 => values.copy_from_slice(&shaft_theta::places_gradient(&p)),
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
                    [*inertia] = shaft_theta::inertia(*x, &p);
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
            0 => shaft_theta::on_value(time, x, u, u_t, &p, forces),
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
            0 => shaft_theta::on_value_jacobian(time, x, u, u_t, &p, by_u, by_u_t),
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
            0 => shaft_theta::on_value_by_time(time, x, u, u_t, &p, by_time),
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
            0 => shaft_theta::on_slope(u_x, u_xt, &p, forces),
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
            0 => shaft_theta::on_slope_jacobian(u_x, u_xt, &p, by_u_x, by_u_xt),
            _ => no_field(index),
        }
    }
}

#[cold]
fn no_field(index: usize) -> ! {
    panic!("there is no field of number {index}")
}

static SHAFT_THETA_FIELD: FieldDescription<'static> = FieldDescription {
    value: Quantity {
        name: "shaft.theta",
        unit: "rad",
        doc: "angle of the section",
    },
    rate: Quantity {
        name: "shaft.theta_dot",
        unit: "rad/s",
        doc: "rate of angle of the section",
    },
    slope: Quantity {
        name: "shaft.theta_x",
        unit: "rad/m",
        doc: "slope of angle of the section",
    },
    scale: [0.12, 3.0],
    fixed: [false, false],
    length: 1.75,
    attachments: &[
        FieldAttachment {
            coordinate: Some(0),
            place: FieldPlace::Start,
            at: 0.0,
            handed: 9,
        },
        FieldAttachment {
            coordinate: Some(1),
            place: FieldPlace::Inside,
            at: 1.0,
            handed: 13,
        },
    ],
    parameters: &shaft_theta::PARAMETERS,
    elements: 70,
    order: 1,
};

// Emitted by Machinist 0.1.0; do not edit. To make it again:
//
//     cargo run --release -- gen
//
// Sources, with SHA-256:
//   d2c75a90dbcb8c06281a8cefccfd565b2e1085edd377fb79777746de2b897e53  scenes/four_bar.toml
//   fa69a391ab85c57533a93c32c47f18b29da038e678b6c6fe99931f82ce4979fa  units/planar_body.toml
//
// Four-bar linkage under gravity
//
// Crank, coupler and rocker pinned to one another and to the frame. Let go near the crank's
// upper position with a push, the crank turns over and over; nothing brakes it.
//
// Source:
//   Textbook; Freudenstein's equation.
//
// Shapes; all quantities are in SI units:
//   coordinates               9
//   first-order states        0
//   states                   18
//   parameters               15
//   outputs                   6
//   discontinuities           0
//   constraints               8
//
// State:
//     0  crank.x        [m]      centre of mass, sideways
//     1  crank.y        [m]      centre of mass, upwards
//     2  crank.phi      [rad]    angle of the bar from sideways
//     3  coupler.x      [m]      centre of mass, sideways
//     4  coupler.y      [m]      centre of mass, upwards
//     5  coupler.phi    [rad]    angle of the bar from sideways
//     6  rocker.x       [m]      centre of mass, sideways
//     7  rocker.y       [m]      centre of mass, upwards
//     8  rocker.phi     [rad]    angle of the bar from sideways
//     9  crank.v_x      [m/s]    rate of centre of mass, sideways
//    10  crank.v_y      [m/s]    rate of centre of mass, upwards
//    11  crank.omega    [rad/s]  rate of angle of the bar from sideways
//    12  coupler.v_x    [m/s]    rate of centre of mass, sideways
//    13  coupler.v_y    [m/s]    rate of centre of mass, upwards
//    14  coupler.omega  [rad/s]  rate of angle of the bar from sideways
//    15  rocker.v_x     [m/s]    rate of centre of mass, sideways
//    16  rocker.v_y     [m/s]    rate of centre of mass, upwards
//    17  rocker.omega   [rad/s]  rate of angle of the bar from sideways
//
// Nonzeros:
//   mass_matrix               9 of 9 by 9
//   rate_jacobian            63 of 18 by 18
//   parameter_jacobian      108 of 18 by 15
//
// Operations:
//   initial_state             0
//   discontinuities           0
//   rate                    298
//   mass_matrix               0
//   forcing                   6
//   rate_jacobian           942
//   parameter_jacobian     1592
//   time_derivative           0
//   outputs                 253
//   energy                   37
//   power_balance           330
//   constraint_values        32
//   constraint_rates         34
//   constraint_matrix        19
// With constants of the parameters, prepared once a run:
//   prepare                  21
//   prepared_rate           277
//   prepared_rate_jacobian  924

use ::machinist_contract::{
    Constraint, Describe, Energy, PowerBalance, Quantity, Real, RunDefaults, Shape,
    Simulator, SparsityPattern,
};

/// Generalized coordinates, n.
pub const COORDINATES: usize = 9;

/// Length of the state y.
pub const STATES: usize = 18;

/// Parameters.
pub const PARAMETERS: usize = 15;

/// Wanted outputs.
pub const OUTPUTS: usize = 6;

/// Times at which the right-hand side jumps.
pub const DISCONTINUITIES: usize = 0;

/// Nonzeros of M, both triangles.
pub const MASS_MATRIX_PATTERN: SparsityPattern<'static> = SparsityPattern {
    rows: 9,
    columns: 9,
    entries: &[(0, 0), (1, 1), (2, 2), (3, 3), (4, 4), (5, 5), (6, 6), (7, 7), (8, 8)],
};

/// Nonzeros of dy'/dy.
pub const RATE_JACOBIAN_PATTERN: SparsityPattern<'static> = SparsityPattern {
    rows: 18,
    columns: 18,
    entries: &[
        (0, 9), (1, 10), (2, 11), (3, 12), (4, 13), (5, 14), (6, 15), (7, 16), (8, 17), (9, 2),
        (9, 5), (9, 8), (9, 11), (9, 14), (9, 17), (10, 2), (10, 5), (10, 8), (10, 11), (10, 14),
        (10, 17), (11, 2), (11, 5), (11, 8), (11, 11), (11, 14), (11, 17), (12, 2), (12, 5),
        (12, 8), (12, 11), (12, 14), (12, 17), (13, 2), (13, 5), (13, 8), (13, 11), (13, 14),
        (13, 17), (14, 2), (14, 5), (14, 8), (14, 11), (14, 14), (14, 17), (15, 2), (15, 5),
        (15, 8), (15, 11), (15, 14), (15, 17), (16, 2), (16, 5), (16, 8), (16, 11), (16, 14),
        (16, 17), (17, 2), (17, 5), (17, 8), (17, 11), (17, 14), (17, 17),
    ],
};

/// Nonzeros of dy'/dp.
pub const PARAMETER_JACOBIAN_PATTERN: SparsityPattern<'static> = SparsityPattern {
    rows: 18,
    columns: 15,
    entries: &[
        (9, 3), (9, 4), (9, 5), (9, 6), (9, 7), (9, 8), (9, 9), (9, 10), (9, 11), (9, 12), (9, 13),
        (9, 14), (10, 3), (10, 4), (10, 5), (10, 6), (10, 7), (10, 8), (10, 9), (10, 10), (10, 11),
        (10, 12), (10, 13), (10, 14), (11, 3), (11, 4), (11, 5), (11, 6), (11, 7), (11, 8), (11, 9),
        (11, 10), (11, 11), (11, 12), (11, 13), (11, 14), (12, 3), (12, 4), (12, 5), (12, 6),
        (12, 7), (12, 8), (12, 9), (12, 10), (12, 11), (12, 12), (12, 13), (12, 14), (13, 3),
        (13, 4), (13, 5), (13, 6), (13, 7), (13, 8), (13, 9), (13, 10), (13, 11), (13, 12),
        (13, 13), (13, 14), (14, 3), (14, 4), (14, 5), (14, 6), (14, 7), (14, 8), (14, 9), (14, 10),
        (14, 11), (14, 12), (14, 13), (14, 14), (15, 3), (15, 4), (15, 5), (15, 6), (15, 7),
        (15, 8), (15, 9), (15, 10), (15, 11), (15, 12), (15, 13), (15, 14), (16, 3), (16, 4),
        (16, 5), (16, 6), (16, 7), (16, 8), (16, 9), (16, 10), (16, 11), (16, 12), (16, 13),
        (16, 14), (17, 3), (17, 4), (17, 5), (17, 6), (17, 7), (17, 8), (17, 9), (17, 10), (17, 11),
        (17, 12), (17, 13), (17, 14),
    ],
};

/// Constraints.
pub const CONSTRAINTS: usize = 8;

/// Nonzeros of G = dg'/dq'.
pub const CONSTRAINT_MATRIX_PATTERN: SparsityPattern<'static> = SparsityPattern {
    rows: 8,
    columns: 9,
    entries: &[
        (0, 0), (0, 2), (1, 1), (1, 2), (2, 0), (2, 2), (2, 3), (2, 5), (3, 1), (3, 2), (3, 4),
        (3, 5), (4, 3), (4, 5), (4, 6), (4, 8), (5, 4), (5, 5), (5, 7), (5, 8), (6, 6), (6, 8),
        (7, 7), (7, 8),
    ],
};

/// Four-bar linkage under gravity
///
/// Crank, coupler and rocker pinned to one another and to the frame. Let go near the crank's
/// upper position with a push, the crank turns over and over; nothing brakes it.
///
/// Source: Textbook; Freudenstein's equation.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct FourBar;

/// Parameters, in SI units; the default holds the values of the spec.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Parameters<R> {
    /// base: distance of the two pins in the frame \[m\]. In the spec: 0.22.
    pub base: R,
    /// angle: angle of the crank at the start \[rad\]. In the spec: 1.5.
    pub angle: R,
    /// speed: speed of the crank at the start \[rad/s\]. In the spec: 25.0.
    pub speed: R,
    /// crank.length: length of the bar \[m\]. In the spec: 0.1.
    pub crank_length: R,
    /// crank.mass: the mass \[kg\]. In the spec: 0.5.
    pub crank_mass: R,
    /// crank.inertia: moment of inertia about the centre of mass \[kg m^2\]. In the spec: 0.00045.
    pub crank_inertia: R,
    /// crank.gravity: acceleration of free fall \[m/s^2\]. In the spec: 9.81.
    pub crank_gravity: R,
    /// coupler.length: length of the bar \[m\]. In the spec: 0.25.
    pub coupler_length: R,
    /// coupler.mass: the mass \[kg\]. In the spec: 0.9.
    pub coupler_mass: R,
    /// coupler.inertia: moment of inertia about the centre of mass \[kg m^2\]. In the spec: 0.0047.
    pub coupler_inertia: R,
    /// coupler.gravity: acceleration of free fall \[m/s^2\]. In the spec: 9.81.
    pub coupler_gravity: R,
    /// rocker.length: length of the bar \[m\]. In the spec: 0.2.
    pub rocker_length: R,
    /// rocker.mass: the mass \[kg\]. In the spec: 0.7.
    pub rocker_mass: R,
    /// rocker.inertia: moment of inertia about the centre of mass \[kg m^2\]. In the spec: 0.0024.
    pub rocker_inertia: R,
    /// rocker.gravity: acceleration of free fall \[m/s^2\]. In the spec: 9.81.
    pub rocker_gravity: R,
}

impl<R: Real> Parameters<R> {
    /// From the numbers in their order.
    #[must_use]
    #[inline]
    pub fn from_array(values: [R; PARAMETERS]) -> Self {
        Self {
            base: values[0],
            angle: values[1],
            speed: values[2],
            crank_length: values[3],
            crank_mass: values[4],
            crank_inertia: values[5],
            crank_gravity: values[6],
            coupler_length: values[7],
            coupler_mass: values[8],
            coupler_inertia: values[9],
            coupler_gravity: values[10],
            rocker_length: values[11],
            rocker_mass: values[12],
            rocker_inertia: values[13],
            rocker_gravity: values[14],
        }
    }
    /// The numbers in their order.
    #[must_use]
    #[inline]
    pub fn to_array(self) -> [R; PARAMETERS] {
        [
            self.base,
            self.angle,
            self.speed,
            self.crank_length,
            self.crank_mass,
            self.crank_inertia,
            self.crank_gravity,
            self.coupler_length,
            self.coupler_mass,
            self.coupler_inertia,
            self.coupler_gravity,
            self.rocker_length,
            self.rocker_mass,
            self.rocker_inertia,
            self.rocker_gravity,
        ]
    }
}

impl<R: Real> Default for Parameters<R> {
    fn default() -> Self {
        Self {
            base: R::literal(0.22),
            angle: R::literal(1.5),
            speed: R::literal(25.0),
            crank_length: R::literal(0.1),
            crank_mass: R::literal(0.5),
            crank_inertia: R::literal(0.00045),
            crank_gravity: R::literal(9.81),
            coupler_length: R::literal(0.25),
            coupler_mass: R::literal(0.9),
            coupler_inertia: R::literal(0.0047),
            coupler_gravity: R::literal(9.81),
            rocker_length: R::literal(0.2),
            rocker_mass: R::literal(0.7),
            rocker_inertia: R::literal(0.0024),
            rocker_gravity: R::literal(9.81),
        }
    }
}

/// Wanted outputs, in SI units.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Outputs<R> {
    /// crank_angle: angle of the bar from sideways \[rad\].
    pub crank_angle: R,
    /// coupler_angle: angle of the bar from sideways \[rad\].
    pub coupler_angle: R,
    /// rocker_angle: angle of the bar from sideways \[rad\].
    pub rocker_angle: R,
    /// crank_speed: rate of angle of the bar from sideways \[rad/s\].
    pub crank_speed: R,
    /// pin_force_x: force of the frame on the crank, sideways \[N\].
    pub pin_force_x: R,
    /// pin_force_y: force of the frame on the crank, upwards \[N\].
    pub pin_force_y: R,
}

impl<R: Real> Outputs<R> {
    /// From the numbers in their order.
    #[must_use]
    #[inline]
    pub fn from_array(values: [R; OUTPUTS]) -> Self {
        Self {
            crank_angle: values[0],
            coupler_angle: values[1],
            rocker_angle: values[2],
            crank_speed: values[3],
            pin_force_x: values[4],
            pin_force_y: values[5],
        }
    }
    /// The numbers in their order.
    #[must_use]
    #[inline]
    pub fn to_array(self) -> [R; OUTPUTS] {
        [
            self.crank_angle,
            self.coupler_angle,
            self.rocker_angle,
            self.crank_speed,
            self.pin_force_x,
            self.pin_force_y,
        ]
    }
}

/// Where to find what in the state.
pub mod state {
    /// crank.x: centre of mass, sideways \[m\].
    pub const CRANK_X: usize = 0;
    /// crank.y: centre of mass, upwards \[m\].
    pub const CRANK_Y: usize = 1;
    /// crank.phi: angle of the bar from sideways \[rad\].
    pub const CRANK_PHI: usize = 2;
    /// coupler.x: centre of mass, sideways \[m\].
    pub const COUPLER_X: usize = 3;
    /// coupler.y: centre of mass, upwards \[m\].
    pub const COUPLER_Y: usize = 4;
    /// coupler.phi: angle of the bar from sideways \[rad\].
    pub const COUPLER_PHI: usize = 5;
    /// rocker.x: centre of mass, sideways \[m\].
    pub const ROCKER_X: usize = 6;
    /// rocker.y: centre of mass, upwards \[m\].
    pub const ROCKER_Y: usize = 7;
    /// rocker.phi: angle of the bar from sideways \[rad\].
    pub const ROCKER_PHI: usize = 8;
    /// crank.v_x: rate of centre of mass, sideways \[m/s\].
    pub const CRANK_V_X: usize = 9;
    /// crank.v_y: rate of centre of mass, upwards \[m/s\].
    pub const CRANK_V_Y: usize = 10;
    /// crank.omega: rate of angle of the bar from sideways \[rad/s\].
    pub const CRANK_OMEGA: usize = 11;
    /// coupler.v_x: rate of centre of mass, sideways \[m/s\].
    pub const COUPLER_V_X: usize = 12;
    /// coupler.v_y: rate of centre of mass, upwards \[m/s\].
    pub const COUPLER_V_Y: usize = 13;
    /// coupler.omega: rate of angle of the bar from sideways \[rad/s\].
    pub const COUPLER_OMEGA: usize = 14;
    /// rocker.v_x: rate of centre of mass, sideways \[m/s\].
    pub const ROCKER_V_X: usize = 15;
    /// rocker.v_y: rate of centre of mass, upwards \[m/s\].
    pub const ROCKER_V_Y: usize = 16;
    /// rocker.omega: rate of angle of the bar from sideways \[rad/s\].
    pub const ROCKER_OMEGA: usize = 17;
}

/// Constants that `prepare` computes.
pub const CONSTANTS: usize = 18;

#[allow(missing_docs, reason = "`prepare` says what each is")]
/// What parameters alone decide; `prepare` says what each is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Constants<R> {
    pub t0: R,
    pub t1: R,
    pub t2: R,
    pub inverse_crank_mass: R,
    pub minus_inverse_crank_mass: R,
    pub inverse_crank_inertia: R,
    pub inverse_coupler_mass: R,
    pub minus_inverse_coupler_mass: R,
    pub inverse_coupler_inertia: R,
    pub inverse_rocker_mass: R,
    pub inverse_rocker_inertia: R,
    pub minus_inverse_rocker_mass: R,
    pub t3: R,
    pub t4: R,
    pub t5: R,
    pub t6: R,
    pub t7: R,
    pub t8: R,
}

impl<R: Real> Constants<R> {
    /// From the numbers in their order.
    #[must_use]
    #[inline]
    pub fn from_array(values: [R; CONSTANTS]) -> Self {
        Self {
            t0: values[0],
            t1: values[1],
            t2: values[2],
            inverse_crank_mass: values[3],
            minus_inverse_crank_mass: values[4],
            inverse_crank_inertia: values[5],
            inverse_coupler_mass: values[6],
            minus_inverse_coupler_mass: values[7],
            inverse_coupler_inertia: values[8],
            inverse_rocker_mass: values[9],
            inverse_rocker_inertia: values[10],
            minus_inverse_rocker_mass: values[11],
            t3: values[12],
            t4: values[13],
            t5: values[14],
            t6: values[15],
            t7: values[16],
            t8: values[17],
        }
    }
    /// The numbers in their order.
    #[must_use]
    #[inline]
    pub fn to_array(self) -> [R; CONSTANTS] {
        [
            self.t0,
            self.t1,
            self.t2,
            self.inverse_crank_mass,
            self.minus_inverse_crank_mass,
            self.inverse_crank_inertia,
            self.inverse_coupler_mass,
            self.minus_inverse_coupler_mass,
            self.inverse_coupler_inertia,
            self.inverse_rocker_mass,
            self.inverse_rocker_inertia,
            self.minus_inverse_rocker_mass,
            self.t3,
            self.t4,
            self.t5,
            self.t6,
            self.t7,
            self.t8,
        ]
    }
}

/// What `rate` and `rate_jacobian` need of the parameters, once a run.
///
/// 21 operations.
#[must_use]
#[inline]
pub fn prepare<R: Real>(p: &Parameters<R>) -> Constants<R> {
    let t0 = R::literal(0.5) * p.crank_length;
    let t1 = R::literal(0.5) * p.coupler_length;
    let t2 = R::literal(0.5) * p.rocker_length;
    let inverse_crank_mass = R::literal(1.0) / p.crank_mass;
    let minus_inverse_crank_mass = -inverse_crank_mass;
    let inverse_crank_inertia = R::literal(1.0) / p.crank_inertia;
    let inverse_coupler_mass = R::literal(1.0) / p.coupler_mass;
    let minus_inverse_coupler_mass = -inverse_coupler_mass;
    let inverse_coupler_inertia = R::literal(1.0) / p.coupler_inertia;
    let inverse_rocker_mass = R::literal(1.0) / p.rocker_mass;
    let inverse_rocker_inertia = R::literal(1.0) / p.rocker_inertia;
    let minus_inverse_rocker_mass = -inverse_rocker_mass;
    let t3 = inverse_crank_mass * (p.crank_mass * p.crank_gravity);
    let t4 = -t3;
    let t5 = inverse_coupler_mass * (p.coupler_mass * p.coupler_gravity);
    let t6 = -t5;
    let t7 = inverse_rocker_mass * (p.rocker_mass * p.rocker_gravity);
    let t8 = -t7;
    Constants {
        t0,
        t1,
        t2,
        inverse_crank_mass,
        minus_inverse_crank_mass,
        inverse_crank_inertia,
        inverse_coupler_mass,
        minus_inverse_coupler_mass,
        inverse_coupler_inertia,
        inverse_rocker_mass,
        inverse_rocker_inertia,
        minus_inverse_rocker_mass,
        t3,
        t4,
        t5,
        t6,
        t7,
        t8,
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
        p.angle,
        R::literal(0.1),
        R::literal(0.15),
        R::literal(0.5),
        R::literal(0.23),
        R::literal(0.1),
        R::literal(1.3),
        R::literal(0.0),
        R::literal(0.0),
        p.speed,
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

/// `y'`: velocities, `q''` of `M q'' = f + G^T lambda` with `g'' = 0`, `h`; in the units of the states per second.
///
/// 298 operations.
#[must_use]
#[inline]
pub fn rate<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>) -> [R; STATES] {
    prepared_rate(time, state, p, &prepare(p))
}

/// As `rate`, with the constants of the parameters from `prepare`.
///
/// 277 operations.
#[must_use]
#[inline]
pub fn prepared_rate<R: Real>(
    _time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
    c: &Constants<R>,
) -> [R; STATES] {
    let [_, _, crank_phi, _, _, coupler_phi, _, _, rocker_phi, crank_v_x, crank_v_y,
    crank_omega, coupler_v_x, coupler_v_y, coupler_omega, rocker_v_x, rocker_v_y,
    rocker_omega] = *state;
    let [(sin_crank_phi, cos_crank_phi), (sin_coupler_phi, cos_coupler_phi),
    (sin_rocker_phi, cos_rocker_phi)] = R::sin_cos_each([
        crank_phi,
        coupler_phi,
        rocker_phi,
    ]);
    let t0 = c.t0 * cos_crank_phi;
    let t1 = c.t0 * sin_crank_phi;
    let t2 = c.t1 * cos_coupler_phi;
    let t3 = c.t1 * sin_coupler_phi;
    let t4 = c.t2 * cos_rocker_phi;
    let t5 = c.t2 * sin_rocker_phi;
    let t6 = t1 * c.inverse_crank_inertia;
    let t7 = t0 * c.inverse_crank_inertia;
    let t8 = t3 * c.inverse_coupler_inertia;
    let t9 = t2 * c.inverse_coupler_inertia;
    let t10 = t5 * c.inverse_rocker_inertia;
    let t11 = t4 * c.inverse_rocker_inertia;
    let t12 = t6 * t1;
    let t13 = c.minus_inverse_crank_mass - t12;
    let t14 = R::literal(1.0) / t13;
    let t15 = t7 * t1;
    let t16 = t15 * t14;
    let t17 = c.inverse_crank_mass - t12;
    let t18 = t17 * t14;
    let t19 = t7 * t0;
    let t20 = c.minus_inverse_crank_mass - t19;
    let t21 = t16 * t15;
    let t22 = R::literal(1.0) / (t20 - t21);
    let t23 = (t6 * t0).sub_product(t18, t15);
    let t24 = t23 * t22;
    let t25 = c.inverse_crank_mass - t19 - t21;
    let t26 = t25 * t22;
    let t27 = t8 * t3;
    let t28 = R::literal(1.0)
        / (t13 - c.inverse_coupler_mass - t27)
            .sub_product(t18, t17)
            .sub_product(t24, t23);
    let t29 = t9 * t3;
    let t30 = (t15 + t29).sub_product(t16, t17).sub_product(t26, t23);
    let t31 = t30 * t28;
    let t32 = c.inverse_coupler_mass - t27;
    let t33 = t32 * t28;
    let t34 = t29 * t28;
    let t35 = t9 * t2;
    let t36 = R::literal(1.0)
        / (t20 - c.inverse_coupler_mass - t35 - t21)
            .sub_product(t26, t25)
            .sub_product(t31, t30);
    let t37 = (t8 * t2).sub_product(t33, t30);
    let t38 = t37 * t36;
    let t39 = (c.inverse_coupler_mass - t35).sub_product(t34, t30);
    let t40 = t39 * t36;
    let t41 = t10 * t5;
    let t42 = R::literal(1.0)
        / (c.minus_inverse_coupler_mass - t27 - c.inverse_rocker_mass - t41)
            .sub_product(t33, t32)
            .sub_product(t38, t37);
    let t43 = t11 * t5;
    let t44 = (t29 + t43).sub_product(t34, t32).sub_product(t40, t37);
    let t45 = t44 * t42;
    let t46 = t41 - c.inverse_rocker_mass;
    let t47 = t46 * t42;
    let t48 = t43 * t42;
    let t49 = t11 * t4;
    let t50 = R::literal(1.0)
        / (c.minus_inverse_coupler_mass - t35 - c.inverse_rocker_mass - t49)
            .sub_product(t34, t29)
            .sub_product(t40, t39)
            .sub_product(t45, t44);
    let t51 = (-(t10 * t4)).sub_product(t47, t44);
    let t52 = t51 * t50;
    let t53 = (t49 - c.inverse_rocker_mass).add_product(t48, t44);
    let t54 = t53 * t50;
    let t55 = R::literal(1.0)
        / (c.minus_inverse_rocker_mass - t41)
            .sub_product(t47, t46)
            .sub_product(t52, t51);
    let t56 = t43.add_product(t48, t46).sub_product(t54, t51);
    let t57 = t56 * t55;
    let crank_omega_squared = crank_omega * crank_omega;
    let t58 = c.t0 * crank_omega_squared;
    let t59 = t58 * cos_crank_phi;
    let t60 = p.crank_length * crank_omega_squared;
    let coupler_omega_squared = coupler_omega * coupler_omega;
    let t61 = p.coupler_length * coupler_omega_squared;
    let t62 = c.t2 * (rocker_omega * rocker_omega);
    let t63 = t62 * cos_rocker_phi;
    let t64 = c.t1 * coupler_omega_squared;
    let t65 = t62 * sin_rocker_phi;
    let t66 = t16 * t59;
    let t67 = c.t3.sub_product(t58, sin_crank_phi) + t66;
    let t68 = (-(R::literal(0.5)
        * (t60 * cos_crank_phi).add_product(t61, cos_coupler_phi)))
        .add_product(t18, t59)
        .sub_product(t24, t67);
    let t69 = ((-c.t3)
        .sub_product(
            R::literal(0.5),
            (t60 * sin_crank_phi).add_product(t61, sin_coupler_phi),
        ) + c.t5 + t66)
        .sub_product(t26, t67)
        .sub_product(t31, t68);
    let t70 = t63
        .sub_product(t64, cos_coupler_phi)
        .sub_product(t33, t68)
        .sub_product(t38, t69);
    let t71 = (t65.sub_product(t64, sin_coupler_phi) - c.t5 + c.t7)
        .sub_product(t34, t68)
        .sub_product(t40, t69)
        .sub_product(t45, t70);
    let t72 = (-t63).sub_product(t47, t70).sub_product(t52, t71);
    let t73 = (c.t7 - t65)
        .add_product(t48, t70)
        .sub_product(t54, t71)
        .sub_product(t57, t72)
        * (R::literal(1.0)
            / (c.minus_inverse_rocker_mass - t49)
                .sub_product(t48, t43)
                .sub_product(t54, t53)
                .sub_product(t57, t56));
    let t74 = (t72 * t55).sub_product(t57, t73);
    let t75 = (t71 * t50).sub_product(t52, t74).sub_product(t54, t73);
    let t76 = (t70 * t42)
        .sub_product(t45, t75)
        .sub_product(t47, t74)
        .add_product(t48, t73);
    let t77 = (t69 * t36).sub_product(t38, t76).sub_product(t40, t75);
    let t78 = (t68 * t28)
        .sub_product(t31, t77)
        .sub_product(t33, t76)
        .sub_product(t34, t75);
    let t79 = (t67 * t22).sub_product(t24, t78).sub_product(t26, t77);
    let t80 = (-(t59 * t14))
        .sub_product(t16, t79)
        .sub_product(t18, t78)
        .sub_product(t16, t77);
    let rocker_omega_dot = (-(t11 * t75))
        .add_product(t10, t76)
        .sub_product(t10, t74)
        .add_product(t11, t73);
    let rocker_v_y_dot = c
        .t8
        .sub_product(c.inverse_rocker_mass, t75)
        .sub_product(c.inverse_rocker_mass, t73);
    let rocker_v_x_dot = (-(c.inverse_rocker_mass * t74))
        .sub_product(c.inverse_rocker_mass, t76);
    let coupler_omega_dot = (t9 * t77)
        .sub_product(t8, t78)
        .sub_product(t8, t76)
        .add_product(t9, t75);
    let coupler_v_y_dot = c
        .t6
        .sub_product(c.inverse_coupler_mass, t77)
        .add_product(c.inverse_coupler_mass, t75);
    let coupler_v_x_dot = (c.inverse_coupler_mass * t76)
        .sub_product(c.inverse_coupler_mass, t78);
    let crank_omega_dot = (t7 * t79)
        .sub_product(t6, t80)
        .sub_product(t6, t78)
        .add_product(t7, t77);
    let crank_v_y_dot = c
        .t4
        .sub_product(c.inverse_crank_mass, t79)
        .add_product(c.inverse_crank_mass, t77);
    let crank_v_x_dot = (c.inverse_crank_mass * t78)
        .sub_product(c.inverse_crank_mass, t80);
    [
        crank_v_x,
        crank_v_y,
        crank_omega,
        coupler_v_x,
        coupler_v_y,
        coupler_omega,
        rocker_v_x,
        rocker_v_y,
        rocker_omega,
        crank_v_x_dot,
        crank_v_y_dot,
        crank_omega_dot,
        coupler_v_x_dot,
        coupler_v_y_dot,
        coupler_omega_dot,
        rocker_v_x_dot,
        rocker_v_y_dot,
        rocker_omega_dot,
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
) -> [R; 9] {
    [
        p.crank_mass,
        p.crank_mass,
        p.crank_inertia,
        p.coupler_mass,
        p.coupler_mass,
        p.coupler_inertia,
        p.rocker_mass,
        p.rocker_mass,
        p.rocker_inertia,
    ]
}

/// `f` of `M q'' = f(q, q', z, t)`, one for each coordinate.
///
/// 6 operations.
#[must_use]
pub fn forcing<R: Real>(
    _time: R,
    _state: &[R; STATES],
    p: &Parameters<R>,
) -> [R; COORDINATES] {
    let crank_y_forcing = -(p.crank_mass * p.crank_gravity);
    let coupler_y_forcing = -(p.coupler_mass * p.coupler_gravity);
    let rocker_y_forcing = -(p.rocker_mass * p.rocker_gravity);
    [
        R::literal(0.0),
        crank_y_forcing,
        R::literal(0.0),
        R::literal(0.0),
        coupler_y_forcing,
        R::literal(0.0),
        R::literal(0.0),
        rocker_y_forcing,
        R::literal(0.0),
    ]
}

/// `dy'/dy`, values in the order of `RATE_JACOBIAN_PATTERN`.
///
/// 942 operations.
#[must_use]
#[inline]
pub fn rate_jacobian<R: Real>(
    time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
) -> [R; 63] {
    prepared_rate_jacobian(time, state, p, &prepare(p))
}

/// As `rate_jacobian`, with the constants of the parameters from `prepare`.
///
/// 924 operations.
#[must_use]
pub fn prepared_rate_jacobian<R: Real>(
    _time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
    c: &Constants<R>,
) -> [R; 63] {
    let [_, _, crank_phi, _, _, coupler_phi, _, _, rocker_phi, _, _, crank_omega, _, _,
    coupler_omega, _, _, rocker_omega] = *state;
    let [(sin_crank_phi, cos_crank_phi), (sin_coupler_phi, cos_coupler_phi),
    (sin_rocker_phi, cos_rocker_phi)] = R::sin_cos_each([
        crank_phi,
        coupler_phi,
        rocker_phi,
    ]);
    let t0 = c.t0 * cos_crank_phi;
    let t1 = c.t0 * sin_crank_phi;
    let t2 = c.t1 * cos_coupler_phi;
    let t3 = c.t1 * sin_coupler_phi;
    let t4 = c.t2 * cos_rocker_phi;
    let t5 = c.t2 * sin_rocker_phi;
    let t6 = t1 * c.inverse_crank_inertia;
    let t7 = t0 * c.inverse_crank_inertia;
    let t8 = t3 * c.inverse_coupler_inertia;
    let t9 = t2 * c.inverse_coupler_inertia;
    let t10 = t5 * c.inverse_rocker_inertia;
    let t11 = t4 * c.inverse_rocker_inertia;
    let t12 = t6 * t1;
    let t13 = c.minus_inverse_crank_mass - t12;
    let t14 = R::literal(1.0) / t13;
    let t15 = t7 * t1;
    let t16 = t15 * t14;
    let t17 = c.inverse_crank_mass - t12;
    let t18 = t17 * t14;
    let t19 = t7 * t0;
    let t20 = c.minus_inverse_crank_mass - t19;
    let t21 = t16 * t15;
    let t22 = R::literal(1.0) / (t20 - t21);
    let t23 = (t6 * t0).sub_product(t18, t15);
    let t24 = t23 * t22;
    let t25 = c.inverse_crank_mass - t19 - t21;
    let t26 = t25 * t22;
    let t27 = t8 * t3;
    let t28 = R::literal(1.0)
        / (t13 - c.inverse_coupler_mass - t27)
            .sub_product(t18, t17)
            .sub_product(t24, t23);
    let t29 = t9 * t3;
    let t30 = (t15 + t29).sub_product(t16, t17).sub_product(t26, t23);
    let t31 = t30 * t28;
    let t32 = c.inverse_coupler_mass - t27;
    let t33 = t32 * t28;
    let t34 = t29 * t28;
    let t35 = t9 * t2;
    let t36 = R::literal(1.0)
        / (t20 - c.inverse_coupler_mass - t35 - t21)
            .sub_product(t26, t25)
            .sub_product(t31, t30);
    let t37 = (t8 * t2).sub_product(t33, t30);
    let t38 = t37 * t36;
    let t39 = (c.inverse_coupler_mass - t35).sub_product(t34, t30);
    let t40 = t39 * t36;
    let t41 = t10 * t5;
    let t42 = R::literal(1.0)
        / (c.minus_inverse_coupler_mass - t27 - c.inverse_rocker_mass - t41)
            .sub_product(t33, t32)
            .sub_product(t38, t37);
    let t43 = t11 * t5;
    let t44 = (t29 + t43).sub_product(t34, t32).sub_product(t40, t37);
    let t45 = t44 * t42;
    let t46 = t41 - c.inverse_rocker_mass;
    let t47 = t46 * t42;
    let t48 = t43 * t42;
    let t49 = t11 * t4;
    let t50 = R::literal(1.0)
        / (c.minus_inverse_coupler_mass - t35 - c.inverse_rocker_mass - t49)
            .sub_product(t34, t29)
            .sub_product(t40, t39)
            .sub_product(t45, t44);
    let t51 = (-(t10 * t4)).sub_product(t47, t44);
    let t52 = t51 * t50;
    let t53 = (t49 - c.inverse_rocker_mass).add_product(t48, t44);
    let t54 = t53 * t50;
    let t55 = R::literal(1.0)
        / (c.minus_inverse_rocker_mass - t41)
            .sub_product(t47, t46)
            .sub_product(t52, t51);
    let t56 = t43.add_product(t48, t46).sub_product(t54, t51);
    let t57 = t56 * t55;
    let t58 = R::literal(1.0)
        / (c.minus_inverse_rocker_mass - t49)
            .sub_product(t48, t43)
            .sub_product(t54, t53)
            .sub_product(t57, t56);
    let crank_omega_squared = crank_omega * crank_omega;
    let t59 = c.t0 * crank_omega_squared;
    let t60 = t59 * cos_crank_phi;
    let t61 = t59 * sin_crank_phi;
    let t62 = p.crank_length * crank_omega_squared;
    let coupler_omega_squared = coupler_omega * coupler_omega;
    let t63 = p.coupler_length * coupler_omega_squared;
    let t64 = c.t2 * (rocker_omega * rocker_omega);
    let t65 = t64 * cos_rocker_phi;
    let t66 = c.t1 * coupler_omega_squared;
    let t67 = t66 * cos_coupler_phi;
    let t68 = t64 * sin_rocker_phi;
    let t69 = t66 * sin_coupler_phi;
    let t70 = -t65;
    let t71 = t16 * t60;
    let t72 = c.t3 - t61 + t71;
    let t73 = (-(R::literal(0.5)
        * (t62 * cos_crank_phi).add_product(t63, cos_coupler_phi)))
        .add_product(t18, t60)
        .sub_product(t24, t72);
    let t74 = ((-c.t3)
        .sub_product(
            R::literal(0.5),
            (t62 * sin_crank_phi).add_product(t63, sin_coupler_phi),
        ) + c.t5 + t71)
        .sub_product(t26, t72)
        .sub_product(t31, t73);
    let t75 = (t65 - t67).sub_product(t33, t73).sub_product(t38, t74);
    let t76 = (t68 - t69 - c.t5 + c.t7)
        .sub_product(t34, t73)
        .sub_product(t40, t74)
        .sub_product(t45, t75);
    let t77 = t70.sub_product(t47, t75).sub_product(t52, t76);
    let t78 = (c.t7 - t68)
        .add_product(t48, t75)
        .sub_product(t54, t76)
        .sub_product(t57, t77) * t58;
    let t79 = (t77 * t55).sub_product(t57, t78);
    let t80 = (t76 * t50).sub_product(t52, t79).sub_product(t54, t78);
    let t81 = (t75 * t42)
        .sub_product(t45, t80)
        .sub_product(t47, t79)
        .add_product(t48, t78);
    let t82 = (t74 * t36).sub_product(t38, t81).sub_product(t40, t80);
    let t83 = (t73 * t28)
        .sub_product(t31, t82)
        .sub_product(t33, t81)
        .sub_product(t34, t80);
    let t84 = (t72 * t22).sub_product(t24, t83).sub_product(t26, t82);
    let t85 = (-(t60 * t14))
        .sub_product(t16, t84)
        .sub_product(t18, t83)
        .sub_product(t16, t82);
    let rocker_omega_dot = (-(t11 * t80))
        .add_product(t10, t81)
        .sub_product(t10, t79)
        .add_product(t11, t78);
    let coupler_omega_dot = (t9 * t82)
        .sub_product(t8, t83)
        .sub_product(t8, t81)
        .add_product(t9, t80);
    let crank_omega_dot = (t7 * t84)
        .sub_product(t6, t85)
        .sub_product(t6, t83)
        .add_product(t7, t82);
    let t86 = (-(t1 * t84))
        .sub_product(t0, t85)
        .sub_product(t0, t83)
        .sub_product(t1, t82);
    let t87 = t61.sub_product(t0, crank_omega_dot).sub_product(t6, t86);
    let t88 = (-t60)
        .sub_product(t1, crank_omega_dot)
        .add_product(t7, t86)
        .sub_product(t16, t87);
    let t89 = t87.sub_product(t18, t87).sub_product(t24, t88);
    let t90 = t88.sub_product(t26, t88).sub_product(t31, t89);
    let t91 = (-(t33 * t89)).sub_product(t38, t90);
    let t92 = (-(t34 * t89)).sub_product(t40, t90).sub_product(t45, t91);
    let t93 = (-(t47 * t91)).sub_product(t52, t92);
    let t94 = (t48 * t91).sub_product(t54, t92).sub_product(t57, t93) * t58;
    let t95 = (t93 * t55).sub_product(t57, t94);
    let t96 = (t92 * t50).sub_product(t52, t95).sub_product(t54, t94);
    let t97 = (t91 * t42)
        .sub_product(t45, t96)
        .sub_product(t47, t95)
        .add_product(t48, t94);
    let t98 = (t90 * t36).sub_product(t38, t97).sub_product(t40, t96);
    let t99 = (t89 * t28)
        .sub_product(t31, t98)
        .sub_product(t33, t97)
        .sub_product(t34, t96);
    let t100 = (t88 * t22).sub_product(t24, t99).sub_product(t26, t98);
    let t101 = (t87 * t14)
        .sub_product(t16, t100)
        .sub_product(t18, t99)
        .sub_product(t16, t98);
    let rocker_omega_dot_by_crank_phi = (-(t11 * t96))
        .add_product(t10, t97)
        .sub_product(t10, t95)
        .add_product(t11, t94);
    let rocker_v_y_dot_by_crank_phi = (-(c.inverse_rocker_mass * t94))
        .sub_product(c.inverse_rocker_mass, t96);
    let rocker_v_x_dot_by_crank_phi = (-(c.inverse_rocker_mass * t95))
        .sub_product(c.inverse_rocker_mass, t97);
    let coupler_omega_dot_by_crank_phi = (t9 * t98)
        .sub_product(t8, t99)
        .sub_product(t8, t97)
        .add_product(t9, t96);
    let coupler_v_y_dot_by_crank_phi = (c.inverse_coupler_mass * t96)
        .sub_product(c.inverse_coupler_mass, t98);
    let coupler_v_x_dot_by_crank_phi = (c.inverse_coupler_mass * t97)
        .sub_product(c.inverse_coupler_mass, t99);
    let crank_omega_dot_by_crank_phi = (t86 * c.inverse_crank_inertia)
        .sub_product(t6, t101)
        .add_product(t7, t100)
        .sub_product(t6, t99)
        .add_product(t7, t98);
    let crank_v_y_dot_by_crank_phi = (c.inverse_crank_mass * t98)
        .sub_product(c.inverse_crank_mass, t100);
    let crank_v_x_dot_by_crank_phi = (c.inverse_crank_mass * t99)
        .sub_product(c.inverse_crank_mass, t101);
    let t102 = (-(t3 * t82))
        .sub_product(t2, t83)
        .sub_product(t2, t81)
        .sub_product(t3, t80);
    let t103 = t69.sub_product(t2, coupler_omega_dot).sub_product(t8, t102);
    let t104 = (-t67).sub_product(t3, coupler_omega_dot).add_product(t9, t102);
    let t105 = t104.sub_product(t31, t103);
    let t106 = t103.sub_product(t33, t103).sub_product(t38, t105);
    let t107 = t104.sub_product(t34, t103).sub_product(t40, t105).sub_product(t45, t106);
    let t108 = (-(t47 * t106)).sub_product(t52, t107);
    let t109 = (t48 * t106).sub_product(t54, t107).sub_product(t57, t108) * t58;
    let t110 = (t108 * t55).sub_product(t57, t109);
    let t111 = (t107 * t50).sub_product(t52, t110).sub_product(t54, t109);
    let t112 = (t106 * t42)
        .sub_product(t45, t111)
        .sub_product(t47, t110)
        .add_product(t48, t109);
    let t113 = (t105 * t36).sub_product(t38, t112).sub_product(t40, t111);
    let t114 = (t103 * t28)
        .sub_product(t31, t113)
        .sub_product(t33, t112)
        .sub_product(t34, t111);
    let t115 = (-(t26 * t113)).sub_product(t24, t114);
    let t116 = (-(t18 * t114)).sub_product(t16, t115).sub_product(t16, t113);
    let rocker_omega_dot_by_coupler_phi = (-(t11 * t111))
        .add_product(t10, t112)
        .sub_product(t10, t110)
        .add_product(t11, t109);
    let rocker_v_y_dot_by_coupler_phi = (-(c.inverse_rocker_mass * t109))
        .sub_product(c.inverse_rocker_mass, t111);
    let rocker_v_x_dot_by_coupler_phi = (-(c.inverse_rocker_mass * t110))
        .sub_product(c.inverse_rocker_mass, t112);
    let coupler_omega_dot_by_coupler_phi = (t102 * c.inverse_coupler_inertia)
        .sub_product(t8, t114)
        .add_product(t9, t113)
        .sub_product(t8, t112)
        .add_product(t9, t111);
    let coupler_v_y_dot_by_coupler_phi = (c.inverse_coupler_mass * t111)
        .sub_product(c.inverse_coupler_mass, t113);
    let coupler_v_x_dot_by_coupler_phi = (c.inverse_coupler_mass * t112)
        .sub_product(c.inverse_coupler_mass, t114);
    let crank_omega_dot_by_coupler_phi = (t7 * t115)
        .sub_product(t6, t116)
        .sub_product(t6, t114)
        .add_product(t7, t113);
    let crank_v_y_dot_by_coupler_phi = (c.inverse_crank_mass * t113)
        .sub_product(c.inverse_crank_mass, t115);
    let crank_v_x_dot_by_coupler_phi = (c.inverse_crank_mass * t114)
        .sub_product(c.inverse_crank_mass, t116);
    let t117 = t4 * rocker_omega_dot;
    let t118 = t5 * rocker_omega_dot;
    let t119 = (t5 * t80).add_product(t4, t81).sub_product(t4, t79).sub_product(t5, t78);
    let t120 = t10 * t119;
    let t121 = t117 - t68 + t120;
    let t122 = t11 * t119;
    let t123 = (t65 + t118 - t122).sub_product(t45, t121);
    let t124 = (t68 - t117 - t120).sub_product(t47, t121).sub_product(t52, t123);
    let t125 = (t70 - t118 + t122)
        .add_product(t48, t121)
        .sub_product(t54, t123)
        .sub_product(t57, t124) * t58;
    let t126 = (t124 * t55).sub_product(t57, t125);
    let t127 = (t123 * t50).sub_product(t52, t126).sub_product(t54, t125);
    let t128 = (t121 * t42)
        .sub_product(t45, t127)
        .sub_product(t47, t126)
        .add_product(t48, t125);
    let t129 = (-(t40 * t127)).sub_product(t38, t128);
    let t130 = (-(t33 * t128)).sub_product(t31, t129).sub_product(t34, t127);
    let t131 = (-(t26 * t129)).sub_product(t24, t130);
    let t132 = (-(t18 * t130)).sub_product(t16, t131).sub_product(t16, t129);
    let rocker_omega_dot_by_rocker_phi = (t119 * c.inverse_rocker_inertia)
        .add_product(t10, t128)
        .sub_product(t11, t127)
        .sub_product(t10, t126)
        .add_product(t11, t125);
    let rocker_v_y_dot_by_rocker_phi = (-(c.inverse_rocker_mass * t125))
        .sub_product(c.inverse_rocker_mass, t127);
    let rocker_v_x_dot_by_rocker_phi = (-(c.inverse_rocker_mass * t126))
        .sub_product(c.inverse_rocker_mass, t128);
    let coupler_omega_dot_by_rocker_phi = (t9 * t129)
        .sub_product(t8, t130)
        .sub_product(t8, t128)
        .add_product(t9, t127);
    let coupler_v_y_dot_by_rocker_phi = (c.inverse_coupler_mass * t127)
        .sub_product(c.inverse_coupler_mass, t129);
    let coupler_v_x_dot_by_rocker_phi = (c.inverse_coupler_mass * t128)
        .sub_product(c.inverse_coupler_mass, t130);
    let crank_omega_dot_by_rocker_phi = (t7 * t131)
        .sub_product(t6, t132)
        .sub_product(t6, t130)
        .add_product(t7, t129);
    let crank_v_y_dot_by_rocker_phi = (c.inverse_crank_mass * t129)
        .sub_product(c.inverse_crank_mass, t131);
    let crank_v_x_dot_by_rocker_phi = (c.inverse_crank_mass * t130)
        .sub_product(c.inverse_crank_mass, t132);
    let crank_length_times_crank_omega = p.crank_length * crank_omega;
    let t133 = crank_length_times_crank_omega * cos_crank_phi;
    let t134 = (-(crank_length_times_crank_omega * sin_crank_phi))
        .add_product(t16, t133);
    let t135 = (-t133).add_product(t18, t133).sub_product(t24, t134);
    let t136 = t134.sub_product(t26, t134).sub_product(t31, t135);
    let t137 = (-(t33 * t135)).sub_product(t38, t136);
    let t138 = (-(t34 * t135)).sub_product(t40, t136).sub_product(t45, t137);
    let t139 = (-(t47 * t137)).sub_product(t52, t138);
    let t140 = (t48 * t137).sub_product(t54, t138).sub_product(t57, t139) * t58;
    let t141 = (t139 * t55).sub_product(t57, t140);
    let t142 = (t138 * t50).sub_product(t52, t141).sub_product(t54, t140);
    let t143 = (t137 * t42)
        .sub_product(t45, t142)
        .sub_product(t47, t141)
        .add_product(t48, t140);
    let t144 = (t136 * t36).sub_product(t38, t143).sub_product(t40, t142);
    let t145 = (t135 * t28)
        .sub_product(t31, t144)
        .sub_product(t33, t143)
        .sub_product(t34, t142);
    let t146 = (t134 * t22).sub_product(t24, t145).sub_product(t26, t144);
    let t147 = (-(t133 * t14))
        .sub_product(t16, t146)
        .sub_product(t18, t145)
        .sub_product(t16, t144);
    let rocker_omega_dot_by_crank_omega = (-(t11 * t142))
        .add_product(t10, t143)
        .sub_product(t10, t141)
        .add_product(t11, t140);
    let rocker_v_y_dot_by_crank_omega = (-(c.inverse_rocker_mass * t140))
        .sub_product(c.inverse_rocker_mass, t142);
    let rocker_v_x_dot_by_crank_omega = (-(c.inverse_rocker_mass * t141))
        .sub_product(c.inverse_rocker_mass, t143);
    let coupler_omega_dot_by_crank_omega = (t9 * t144)
        .sub_product(t8, t145)
        .sub_product(t8, t143)
        .add_product(t9, t142);
    let coupler_v_y_dot_by_crank_omega = (c.inverse_coupler_mass * t142)
        .sub_product(c.inverse_coupler_mass, t144);
    let coupler_v_x_dot_by_crank_omega = (c.inverse_coupler_mass * t143)
        .sub_product(c.inverse_coupler_mass, t145);
    let crank_omega_dot_by_crank_omega = (t7 * t146)
        .sub_product(t6, t147)
        .sub_product(t6, t145)
        .add_product(t7, t144);
    let crank_v_y_dot_by_crank_omega = (c.inverse_crank_mass * t144)
        .sub_product(c.inverse_crank_mass, t146);
    let crank_v_x_dot_by_crank_omega = (c.inverse_crank_mass * t145)
        .sub_product(c.inverse_crank_mass, t147);
    let coupler_length_times_coupler_omega = p.coupler_length * coupler_omega;
    let t148 = coupler_length_times_coupler_omega * cos_coupler_phi;
    let t149 = coupler_length_times_coupler_omega * sin_coupler_phi;
    let t150 = (-t149).add_product(t31, t148);
    let t151 = (-t148).add_product(t33, t148).sub_product(t38, t150);
    let t152 = (-t149)
        .add_product(t34, t148)
        .sub_product(t40, t150)
        .sub_product(t45, t151);
    let t153 = (-(t47 * t151)).sub_product(t52, t152);
    let t154 = (t48 * t151).sub_product(t54, t152).sub_product(t57, t153) * t58;
    let t155 = (t153 * t55).sub_product(t57, t154);
    let t156 = (t152 * t50).sub_product(t52, t155).sub_product(t54, t154);
    let t157 = (t151 * t42)
        .sub_product(t45, t156)
        .sub_product(t47, t155)
        .add_product(t48, t154);
    let t158 = (t150 * t36).sub_product(t38, t157).sub_product(t40, t156);
    let t159 = (-(t148 * t28))
        .sub_product(t31, t158)
        .sub_product(t33, t157)
        .sub_product(t34, t156);
    let t160 = (-(t26 * t158)).sub_product(t24, t159);
    let t161 = (-(t18 * t159)).sub_product(t16, t160).sub_product(t16, t158);
    let rocker_omega_dot_by_coupler_omega = (-(t11 * t156))
        .add_product(t10, t157)
        .sub_product(t10, t155)
        .add_product(t11, t154);
    let rocker_v_y_dot_by_coupler_omega = (-(c.inverse_rocker_mass * t154))
        .sub_product(c.inverse_rocker_mass, t156);
    let rocker_v_x_dot_by_coupler_omega = (-(c.inverse_rocker_mass * t155))
        .sub_product(c.inverse_rocker_mass, t157);
    let coupler_omega_dot_by_coupler_omega = (t9 * t158)
        .sub_product(t8, t159)
        .sub_product(t8, t157)
        .add_product(t9, t156);
    let coupler_v_y_dot_by_coupler_omega = (c.inverse_coupler_mass * t156)
        .sub_product(c.inverse_coupler_mass, t158);
    let coupler_v_x_dot_by_coupler_omega = (c.inverse_coupler_mass * t157)
        .sub_product(c.inverse_coupler_mass, t159);
    let crank_omega_dot_by_coupler_omega = (t7 * t160)
        .sub_product(t6, t161)
        .sub_product(t6, t159)
        .add_product(t7, t158);
    let crank_v_y_dot_by_coupler_omega = (c.inverse_crank_mass * t158)
        .sub_product(c.inverse_crank_mass, t160);
    let crank_v_x_dot_by_coupler_omega = (c.inverse_crank_mass * t159)
        .sub_product(c.inverse_crank_mass, t161);
    let rocker_length_times_rocker_omega = p.rocker_length * rocker_omega;
    let t162 = rocker_length_times_rocker_omega * cos_rocker_phi;
    let t163 = rocker_length_times_rocker_omega * sin_rocker_phi;
    let t164 = t163.sub_product(t45, t162);
    let t165 = (-t162).sub_product(t47, t162).sub_product(t52, t164);
    let t166 = (-t163)
        .add_product(t48, t162)
        .sub_product(t54, t164)
        .sub_product(t57, t165) * t58;
    let t167 = (t165 * t55).sub_product(t57, t166);
    let t168 = (t164 * t50).sub_product(t52, t167).sub_product(t54, t166);
    let t169 = (t162 * t42)
        .sub_product(t45, t168)
        .sub_product(t47, t167)
        .add_product(t48, t166);
    let t170 = (-(t40 * t168)).sub_product(t38, t169);
    let t171 = (-(t33 * t169)).sub_product(t31, t170).sub_product(t34, t168);
    let t172 = (-(t26 * t170)).sub_product(t24, t171);
    let t173 = (-(t18 * t171)).sub_product(t16, t172).sub_product(t16, t170);
    let rocker_omega_dot_by_rocker_omega = (-(t11 * t168))
        .add_product(t10, t169)
        .sub_product(t10, t167)
        .add_product(t11, t166);
    let rocker_v_y_dot_by_rocker_omega = (-(c.inverse_rocker_mass * t166))
        .sub_product(c.inverse_rocker_mass, t168);
    let rocker_v_x_dot_by_rocker_omega = (-(c.inverse_rocker_mass * t167))
        .sub_product(c.inverse_rocker_mass, t169);
    let coupler_omega_dot_by_rocker_omega = (t9 * t170)
        .sub_product(t8, t171)
        .sub_product(t8, t169)
        .add_product(t9, t168);
    let coupler_v_y_dot_by_rocker_omega = (c.inverse_coupler_mass * t168)
        .sub_product(c.inverse_coupler_mass, t170);
    let coupler_v_x_dot_by_rocker_omega = (c.inverse_coupler_mass * t169)
        .sub_product(c.inverse_coupler_mass, t171);
    let crank_omega_dot_by_rocker_omega = (t7 * t172)
        .sub_product(t6, t173)
        .sub_product(t6, t171)
        .add_product(t7, t170);
    let crank_v_y_dot_by_rocker_omega = (c.inverse_crank_mass * t170)
        .sub_product(c.inverse_crank_mass, t172);
    let crank_v_x_dot_by_rocker_omega = (c.inverse_crank_mass * t171)
        .sub_product(c.inverse_crank_mass, t173);
    [
        R::literal(1.0),
        R::literal(1.0),
        R::literal(1.0),
        R::literal(1.0),
        R::literal(1.0),
        R::literal(1.0),
        R::literal(1.0),
        R::literal(1.0),
        R::literal(1.0),
        crank_v_x_dot_by_crank_phi,
        crank_v_x_dot_by_coupler_phi,
        crank_v_x_dot_by_rocker_phi,
        crank_v_x_dot_by_crank_omega,
        crank_v_x_dot_by_coupler_omega,
        crank_v_x_dot_by_rocker_omega,
        crank_v_y_dot_by_crank_phi,
        crank_v_y_dot_by_coupler_phi,
        crank_v_y_dot_by_rocker_phi,
        crank_v_y_dot_by_crank_omega,
        crank_v_y_dot_by_coupler_omega,
        crank_v_y_dot_by_rocker_omega,
        crank_omega_dot_by_crank_phi,
        crank_omega_dot_by_coupler_phi,
        crank_omega_dot_by_rocker_phi,
        crank_omega_dot_by_crank_omega,
        crank_omega_dot_by_coupler_omega,
        crank_omega_dot_by_rocker_omega,
        coupler_v_x_dot_by_crank_phi,
        coupler_v_x_dot_by_coupler_phi,
        coupler_v_x_dot_by_rocker_phi,
        coupler_v_x_dot_by_crank_omega,
        coupler_v_x_dot_by_coupler_omega,
        coupler_v_x_dot_by_rocker_omega,
        coupler_v_y_dot_by_crank_phi,
        coupler_v_y_dot_by_coupler_phi,
        coupler_v_y_dot_by_rocker_phi,
        coupler_v_y_dot_by_crank_omega,
        coupler_v_y_dot_by_coupler_omega,
        coupler_v_y_dot_by_rocker_omega,
        coupler_omega_dot_by_crank_phi,
        coupler_omega_dot_by_coupler_phi,
        coupler_omega_dot_by_rocker_phi,
        coupler_omega_dot_by_crank_omega,
        coupler_omega_dot_by_coupler_omega,
        coupler_omega_dot_by_rocker_omega,
        rocker_v_x_dot_by_crank_phi,
        rocker_v_x_dot_by_coupler_phi,
        rocker_v_x_dot_by_rocker_phi,
        rocker_v_x_dot_by_crank_omega,
        rocker_v_x_dot_by_coupler_omega,
        rocker_v_x_dot_by_rocker_omega,
        rocker_v_y_dot_by_crank_phi,
        rocker_v_y_dot_by_coupler_phi,
        rocker_v_y_dot_by_rocker_phi,
        rocker_v_y_dot_by_crank_omega,
        rocker_v_y_dot_by_coupler_omega,
        rocker_v_y_dot_by_rocker_omega,
        rocker_omega_dot_by_crank_phi,
        rocker_omega_dot_by_coupler_phi,
        rocker_omega_dot_by_rocker_phi,
        rocker_omega_dot_by_crank_omega,
        rocker_omega_dot_by_coupler_omega,
        rocker_omega_dot_by_rocker_omega,
    ]
}

/// `dy'/dp`, values in the order of `PARAMETER_JACOBIAN_PATTERN`.
///
/// 1592 operations.
#[must_use]
pub fn parameter_jacobian<R: Real>(
    _time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
) -> [R; 108] {
    let [_, _, crank_phi, _, _, coupler_phi, _, _, rocker_phi, _, _, crank_omega, _, _,
    coupler_omega, _, _, rocker_omega] = *state;
    let [(sin_crank_phi, cos_crank_phi), (sin_coupler_phi, cos_coupler_phi),
    (sin_rocker_phi, cos_rocker_phi)] = R::sin_cos_each([
        crank_phi,
        coupler_phi,
        rocker_phi,
    ]);
    let t0 = R::literal(0.5) * p.crank_length;
    let t1 = t0 * cos_crank_phi;
    let t2 = t0 * sin_crank_phi;
    let t3 = R::literal(0.5) * p.coupler_length;
    let t4 = t3 * cos_coupler_phi;
    let t5 = t3 * sin_coupler_phi;
    let t6 = R::literal(0.5) * p.rocker_length;
    let t7 = t6 * cos_rocker_phi;
    let t8 = t6 * sin_rocker_phi;
    let inverse_crank_mass = R::literal(1.0) / p.crank_mass;
    let minus_inverse_crank_mass = -inverse_crank_mass;
    let inverse_crank_inertia = R::literal(1.0) / p.crank_inertia;
    let t9 = t2 * inverse_crank_inertia;
    let t10 = t1 * inverse_crank_inertia;
    let inverse_coupler_mass = R::literal(1.0) / p.coupler_mass;
    let minus_inverse_coupler_mass = -inverse_coupler_mass;
    let inverse_coupler_inertia = R::literal(1.0) / p.coupler_inertia;
    let t11 = t5 * inverse_coupler_inertia;
    let t12 = t4 * inverse_coupler_inertia;
    let inverse_rocker_mass = R::literal(1.0) / p.rocker_mass;
    let inverse_rocker_inertia = R::literal(1.0) / p.rocker_inertia;
    let t13 = t8 * inverse_rocker_inertia;
    let t14 = t7 * inverse_rocker_inertia;
    let t15 = t9 * t2;
    let t16 = minus_inverse_crank_mass - t15;
    let t17 = R::literal(1.0) / t16;
    let t18 = t10 * t2;
    let t19 = t18 * t17;
    let t20 = inverse_crank_mass - t15;
    let t21 = t20 * t17;
    let t22 = t10 * t1;
    let t23 = minus_inverse_crank_mass - t22;
    let t24 = t19 * t18;
    let t25 = R::literal(1.0) / (t23 - t24);
    let t26 = (t9 * t1).sub_product(t21, t18);
    let t27 = t26 * t25;
    let t28 = inverse_crank_mass - t22 - t24;
    let t29 = t28 * t25;
    let t30 = t11 * t5;
    let t31 = R::literal(1.0)
        / (t16 - inverse_coupler_mass - t30).sub_product(t21, t20).sub_product(t27, t26);
    let t32 = t12 * t5;
    let t33 = (t18 + t32).sub_product(t19, t20).sub_product(t29, t26);
    let t34 = t33 * t31;
    let t35 = inverse_coupler_mass - t30;
    let t36 = t35 * t31;
    let t37 = t32 * t31;
    let t38 = t12 * t4;
    let t39 = R::literal(1.0)
        / (t23 - inverse_coupler_mass - t38 - t24)
            .sub_product(t29, t28)
            .sub_product(t34, t33);
    let t40 = (t11 * t4).sub_product(t36, t33);
    let t41 = t40 * t39;
    let t42 = (inverse_coupler_mass - t38).sub_product(t37, t33);
    let t43 = t42 * t39;
    let t44 = t13 * t8;
    let t45 = R::literal(1.0)
        / (minus_inverse_coupler_mass - t30 - inverse_rocker_mass - t44)
            .sub_product(t36, t35)
            .sub_product(t41, t40);
    let t46 = t14 * t8;
    let t47 = (t32 + t46).sub_product(t37, t35).sub_product(t43, t40);
    let t48 = t47 * t45;
    let minus_inverse_rocker_mass = -inverse_rocker_mass;
    let t49 = t44 - inverse_rocker_mass;
    let t50 = t49 * t45;
    let t51 = t46 * t45;
    let t52 = t14 * t7;
    let t53 = R::literal(1.0)
        / (minus_inverse_coupler_mass - t38 - inverse_rocker_mass - t52)
            .sub_product(t37, t32)
            .sub_product(t43, t42)
            .sub_product(t48, t47);
    let t54 = (-(t13 * t7)).sub_product(t50, t47);
    let t55 = t54 * t53;
    let t56 = (t52 - inverse_rocker_mass).add_product(t51, t47);
    let t57 = t56 * t53;
    let t58 = R::literal(1.0)
        / (minus_inverse_rocker_mass - t44).sub_product(t50, t49).sub_product(t55, t54);
    let t59 = t46.add_product(t51, t49).sub_product(t57, t54);
    let t60 = t59 * t58;
    let t61 = R::literal(1.0)
        / (minus_inverse_rocker_mass - t52)
            .sub_product(t51, t46)
            .sub_product(t57, t56)
            .sub_product(t60, t59);
    let crank_omega_squared = crank_omega * crank_omega;
    let t62 = t0 * crank_omega_squared;
    let t63 = t62 * cos_crank_phi;
    let t64 = p.crank_length * crank_omega_squared;
    let coupler_omega_squared = coupler_omega * coupler_omega;
    let t65 = p.coupler_length * coupler_omega_squared;
    let rocker_omega_squared = rocker_omega * rocker_omega;
    let t66 = t6 * rocker_omega_squared;
    let t67 = t66 * cos_rocker_phi;
    let t68 = t3 * coupler_omega_squared;
    let t69 = t66 * sin_rocker_phi;
    let t70 = inverse_crank_mass * (p.crank_mass * p.crank_gravity);
    let t71 = t19 * t63;
    let t72 = t70.sub_product(t62, sin_crank_phi) + t71;
    let t73 = (-(R::literal(0.5)
        * (t64 * cos_crank_phi).add_product(t65, cos_coupler_phi)))
        .add_product(t21, t63)
        .sub_product(t27, t72);
    let t74 = inverse_coupler_mass * (p.coupler_mass * p.coupler_gravity);
    let t75 = ((-t70)
        .sub_product(
            R::literal(0.5),
            (t64 * sin_crank_phi).add_product(t65, sin_coupler_phi),
        ) + t74 + t71)
        .sub_product(t29, t72)
        .sub_product(t34, t73);
    let t76 = t67
        .sub_product(t68, cos_coupler_phi)
        .sub_product(t36, t73)
        .sub_product(t41, t75);
    let t77 = inverse_rocker_mass * (p.rocker_mass * p.rocker_gravity);
    let t78 = (t69.sub_product(t68, sin_coupler_phi) - t74 + t77)
        .sub_product(t37, t73)
        .sub_product(t43, t75)
        .sub_product(t48, t76);
    let t79 = (-t67).sub_product(t50, t76).sub_product(t55, t78);
    let t80 = (t77 - t69)
        .add_product(t51, t76)
        .sub_product(t57, t78)
        .sub_product(t60, t79) * t61;
    let t81 = (t79 * t58).sub_product(t60, t80);
    let t82 = (t78 * t53).sub_product(t55, t81).sub_product(t57, t80);
    let t83 = (t76 * t45)
        .sub_product(t48, t82)
        .sub_product(t50, t81)
        .add_product(t51, t80);
    let t84 = (t75 * t39).sub_product(t41, t83).sub_product(t43, t82);
    let t85 = (t73 * t31)
        .sub_product(t34, t84)
        .sub_product(t36, t83)
        .sub_product(t37, t82);
    let t86 = (t72 * t25).sub_product(t27, t85).sub_product(t29, t84);
    let t87 = (-(t63 * t17))
        .sub_product(t19, t86)
        .sub_product(t21, t85)
        .sub_product(t19, t84);
    let rocker_omega_dot = (-(t14 * t82))
        .add_product(t13, t83)
        .sub_product(t13, t81)
        .add_product(t14, t80);
    let rocker_v_y_dot = (-t77)
        .sub_product(inverse_rocker_mass, t82)
        .sub_product(inverse_rocker_mass, t80);
    let coupler_omega_dot = (t12 * t84)
        .sub_product(t11, t85)
        .sub_product(t11, t83)
        .add_product(t12, t82);
    let coupler_v_y_dot = (-t74)
        .sub_product(inverse_coupler_mass, t84)
        .add_product(inverse_coupler_mass, t82);
    let crank_omega_dot = (t10 * t86)
        .sub_product(t9, t87)
        .sub_product(t9, t85)
        .add_product(t10, t84);
    let crank_v_y_dot = (-t70)
        .sub_product(inverse_crank_mass, t86)
        .add_product(inverse_crank_mass, t84);
    let t88 = R::literal(0.5) * crank_omega_squared;
    let t89 = R::literal(0.5) * sin_crank_phi;
    let t90 = R::literal(0.5) * cos_crank_phi;
    let t91 = (t90 * t86)
        .sub_product(t89, t87)
        .sub_product(t89, t85)
        .add_product(t90, t84);
    let t92 = (-(t88 * cos_crank_phi))
        .sub_product(t89, crank_omega_dot)
        .sub_product(t9, t91);
    let t93 = (-(t88 * sin_crank_phi))
        .add_product(t90, crank_omega_dot)
        .add_product(t10, t91)
        .sub_product(t19, t92);
    let t94 = t92.sub_product(t21, t92).sub_product(t27, t93);
    let t95 = t93.sub_product(t29, t93).sub_product(t34, t94);
    let t96 = (-(t36 * t94)).sub_product(t41, t95);
    let t97 = (-(t37 * t94)).sub_product(t43, t95).sub_product(t48, t96);
    let t98 = (-(t50 * t96)).sub_product(t55, t97);
    let t99 = (t51 * t96).sub_product(t57, t97).sub_product(t60, t98) * t61;
    let t100 = (t98 * t58).sub_product(t60, t99);
    let t101 = (t97 * t53).sub_product(t55, t100).sub_product(t57, t99);
    let t102 = (t96 * t45)
        .sub_product(t48, t101)
        .sub_product(t50, t100)
        .add_product(t51, t99);
    let t103 = (t95 * t39).sub_product(t41, t102).sub_product(t43, t101);
    let t104 = (t94 * t31)
        .sub_product(t34, t103)
        .sub_product(t36, t102)
        .sub_product(t37, t101);
    let t105 = (t93 * t25).sub_product(t27, t104).sub_product(t29, t103);
    let t106 = (t92 * t17)
        .sub_product(t19, t105)
        .sub_product(t21, t104)
        .sub_product(t19, t103);
    let rocker_omega_dot_by_crank_length = (-(t14 * t101))
        .add_product(t13, t102)
        .sub_product(t13, t100)
        .add_product(t14, t99);
    let rocker_v_y_dot_by_crank_length = (-(inverse_rocker_mass * t99))
        .sub_product(inverse_rocker_mass, t101);
    let rocker_v_x_dot_by_crank_length = (-(inverse_rocker_mass * t100))
        .sub_product(inverse_rocker_mass, t102);
    let coupler_omega_dot_by_crank_length = (t12 * t103)
        .sub_product(t11, t104)
        .sub_product(t11, t102)
        .add_product(t12, t101);
    let coupler_v_y_dot_by_crank_length = (inverse_coupler_mass * t101)
        .sub_product(inverse_coupler_mass, t103);
    let coupler_v_x_dot_by_crank_length = (inverse_coupler_mass * t102)
        .sub_product(inverse_coupler_mass, t104);
    let crank_omega_dot_by_crank_length = (t91 * inverse_crank_inertia)
        .sub_product(t9, t106)
        .add_product(t10, t105)
        .sub_product(t9, t104)
        .add_product(t10, t103);
    let crank_v_y_dot_by_crank_length = (inverse_crank_mass * t103)
        .sub_product(inverse_crank_mass, t105);
    let crank_v_x_dot_by_crank_length = (inverse_crank_mass * t104)
        .sub_product(inverse_crank_mass, t106);
    let t107 = inverse_crank_mass
        * (-(inverse_crank_mass * t85)).add_product(inverse_crank_mass, t87);
    let t108 = inverse_crank_mass * (-p.crank_gravity - crank_v_y_dot);
    let t109 = t19 * t107;
    let t110 = t109 - t108;
    let t111 = t107.add_product(t21, t107).sub_product(t27, t110);
    let t112 = (t108 + t109).sub_product(t29, t110).sub_product(t34, t111);
    let t113 = (-(t36 * t111)).sub_product(t41, t112);
    let t114 = (-(t37 * t111)).sub_product(t43, t112).sub_product(t48, t113);
    let t115 = (-(t50 * t113)).sub_product(t55, t114);
    let t116 = (t51 * t113).sub_product(t57, t114).sub_product(t60, t115) * t61;
    let t117 = (t115 * t58).sub_product(t60, t116);
    let t118 = (t114 * t53).sub_product(t55, t117).sub_product(t57, t116);
    let t119 = (t113 * t45)
        .sub_product(t48, t118)
        .sub_product(t50, t117)
        .add_product(t51, t116);
    let t120 = (t112 * t39).sub_product(t41, t119).sub_product(t43, t118);
    let t121 = (t111 * t31)
        .sub_product(t34, t120)
        .sub_product(t36, t119)
        .sub_product(t37, t118);
    let t122 = (t110 * t25).sub_product(t27, t121).sub_product(t29, t120);
    let t123 = (-(t107 * t17))
        .sub_product(t19, t122)
        .sub_product(t21, t121)
        .sub_product(t19, t120);
    let rocker_omega_dot_by_crank_mass = (-(t14 * t118))
        .add_product(t13, t119)
        .sub_product(t13, t117)
        .add_product(t14, t116);
    let rocker_v_y_dot_by_crank_mass = (-(inverse_rocker_mass * t116))
        .sub_product(inverse_rocker_mass, t118);
    let rocker_v_x_dot_by_crank_mass = (-(inverse_rocker_mass * t117))
        .sub_product(inverse_rocker_mass, t119);
    let coupler_omega_dot_by_crank_mass = (t12 * t120)
        .sub_product(t11, t121)
        .sub_product(t11, t119)
        .add_product(t12, t118);
    let coupler_v_y_dot_by_crank_mass = (inverse_coupler_mass * t118)
        .sub_product(inverse_coupler_mass, t120);
    let coupler_v_x_dot_by_crank_mass = (inverse_coupler_mass * t119)
        .sub_product(inverse_coupler_mass, t121);
    let crank_omega_dot_by_crank_mass = (t10 * t122)
        .sub_product(t9, t123)
        .sub_product(t9, t121)
        .add_product(t10, t120);
    let crank_v_y_dot_by_crank_mass = t108
        .sub_product(inverse_crank_mass, t122)
        .add_product(inverse_crank_mass, t120);
    let crank_v_x_dot_by_crank_mass = t107
        .sub_product(inverse_crank_mass, t123)
        .add_product(inverse_crank_mass, t121);
    let t124 = t9 * crank_omega_dot;
    let t125 = (-(t10 * crank_omega_dot)).sub_product(t19, t124);
    let t126 = t124.sub_product(t21, t124).sub_product(t27, t125);
    let t127 = t125.sub_product(t29, t125).sub_product(t34, t126);
    let t128 = (-(t36 * t126)).sub_product(t41, t127);
    let t129 = (-(t37 * t126)).sub_product(t43, t127).sub_product(t48, t128);
    let t130 = (-(t50 * t128)).sub_product(t55, t129);
    let t131 = (t51 * t128).sub_product(t57, t129).sub_product(t60, t130) * t61;
    let t132 = (t130 * t58).sub_product(t60, t131);
    let t133 = (t129 * t53).sub_product(t55, t132).sub_product(t57, t131);
    let t134 = (t128 * t45)
        .sub_product(t48, t133)
        .sub_product(t50, t132)
        .add_product(t51, t131);
    let t135 = (t127 * t39).sub_product(t41, t134).sub_product(t43, t133);
    let t136 = (t126 * t31)
        .sub_product(t34, t135)
        .sub_product(t36, t134)
        .sub_product(t37, t133);
    let t137 = (t125 * t25).sub_product(t27, t136).sub_product(t29, t135);
    let t138 = (t124 * t17)
        .sub_product(t19, t137)
        .sub_product(t21, t136)
        .sub_product(t19, t135);
    let rocker_omega_dot_by_crank_inertia = (-(t14 * t133))
        .add_product(t13, t134)
        .sub_product(t13, t132)
        .add_product(t14, t131);
    let rocker_v_y_dot_by_crank_inertia = (-(inverse_rocker_mass * t131))
        .sub_product(inverse_rocker_mass, t133);
    let rocker_v_x_dot_by_crank_inertia = (-(inverse_rocker_mass * t132))
        .sub_product(inverse_rocker_mass, t134);
    let coupler_omega_dot_by_crank_inertia = (t12 * t135)
        .sub_product(t11, t136)
        .sub_product(t11, t134)
        .add_product(t12, t133);
    let coupler_v_y_dot_by_crank_inertia = (inverse_coupler_mass * t133)
        .sub_product(inverse_coupler_mass, t135);
    let coupler_v_x_dot_by_crank_inertia = (inverse_coupler_mass * t134)
        .sub_product(inverse_coupler_mass, t136);
    let crank_omega_dot_by_crank_inertia = (-(crank_omega_dot * inverse_crank_inertia))
        .sub_product(t9, t138)
        .add_product(t10, t137)
        .sub_product(t9, t136)
        .add_product(t10, t135);
    let crank_v_y_dot_by_crank_inertia = (inverse_crank_mass * t135)
        .sub_product(inverse_crank_mass, t137);
    let crank_v_x_dot_by_crank_inertia = (inverse_crank_mass * t136)
        .sub_product(inverse_crank_mass, t138);
    let inverse_crank_mass_times_crank_mass = inverse_crank_mass * p.crank_mass;
    let t139 = -inverse_crank_mass_times_crank_mass;
    let t140 = t27 * inverse_crank_mass_times_crank_mass;
    let t141 = t139
        .sub_product(t29, inverse_crank_mass_times_crank_mass)
        .add_product(t34, t140);
    let t142 = (t36 * t140).sub_product(t41, t141);
    let t143 = (t37 * t140).sub_product(t43, t141).sub_product(t48, t142);
    let t144 = (-(t50 * t142)).sub_product(t55, t143);
    let t145 = (t51 * t142).sub_product(t57, t143).sub_product(t60, t144) * t61;
    let t146 = (t144 * t58).sub_product(t60, t145);
    let t147 = (t143 * t53).sub_product(t55, t146).sub_product(t57, t145);
    let t148 = (t142 * t45)
        .sub_product(t48, t147)
        .sub_product(t50, t146)
        .add_product(t51, t145);
    let t149 = (t141 * t39).sub_product(t41, t148).sub_product(t43, t147);
    let t150 = (-(t140 * t31))
        .sub_product(t34, t149)
        .sub_product(t36, t148)
        .sub_product(t37, t147);
    let t151 = (inverse_crank_mass_times_crank_mass * t25)
        .sub_product(t27, t150)
        .sub_product(t29, t149);
    let t152 = (-(t21 * t150)).sub_product(t19, t151).sub_product(t19, t149);
    let rocker_omega_dot_by_crank_gravity = (-(t14 * t147))
        .add_product(t13, t148)
        .sub_product(t13, t146)
        .add_product(t14, t145);
    let rocker_v_y_dot_by_crank_gravity = (-(inverse_rocker_mass * t145))
        .sub_product(inverse_rocker_mass, t147);
    let rocker_v_x_dot_by_crank_gravity = (-(inverse_rocker_mass * t146))
        .sub_product(inverse_rocker_mass, t148);
    let coupler_omega_dot_by_crank_gravity = (t12 * t149)
        .sub_product(t11, t150)
        .sub_product(t11, t148)
        .add_product(t12, t147);
    let coupler_v_y_dot_by_crank_gravity = (inverse_coupler_mass * t147)
        .sub_product(inverse_coupler_mass, t149);
    let coupler_v_x_dot_by_crank_gravity = (inverse_coupler_mass * t148)
        .sub_product(inverse_coupler_mass, t150);
    let crank_omega_dot_by_crank_gravity = (t10 * t151)
        .sub_product(t9, t152)
        .sub_product(t9, t150)
        .add_product(t10, t149);
    let crank_v_y_dot_by_crank_gravity = t139
        .sub_product(inverse_crank_mass, t151)
        .add_product(inverse_crank_mass, t149);
    let crank_v_x_dot_by_crank_gravity = (inverse_crank_mass * t150)
        .sub_product(inverse_crank_mass, t152);
    let t153 = R::literal(0.5) * coupler_omega_squared;
    let t154 = R::literal(0.5) * sin_coupler_phi;
    let t155 = R::literal(0.5) * cos_coupler_phi;
    let t156 = (t155 * t84)
        .sub_product(t154, t85)
        .sub_product(t154, t83)
        .add_product(t155, t82);
    let t157 = (-(t153 * cos_coupler_phi))
        .sub_product(t154, coupler_omega_dot)
        .sub_product(t11, t156);
    let t158 = (-(t153 * sin_coupler_phi))
        .add_product(t155, coupler_omega_dot)
        .add_product(t12, t156);
    let t159 = t158.sub_product(t34, t157);
    let t160 = t157.sub_product(t36, t157).sub_product(t41, t159);
    let t161 = t158.sub_product(t37, t157).sub_product(t43, t159).sub_product(t48, t160);
    let t162 = (-(t50 * t160)).sub_product(t55, t161);
    let t163 = (t51 * t160).sub_product(t57, t161).sub_product(t60, t162) * t61;
    let t164 = (t162 * t58).sub_product(t60, t163);
    let t165 = (t161 * t53).sub_product(t55, t164).sub_product(t57, t163);
    let t166 = (t160 * t45)
        .sub_product(t48, t165)
        .sub_product(t50, t164)
        .add_product(t51, t163);
    let t167 = (t159 * t39).sub_product(t41, t166).sub_product(t43, t165);
    let t168 = (t157 * t31)
        .sub_product(t34, t167)
        .sub_product(t36, t166)
        .sub_product(t37, t165);
    let t169 = (-(t29 * t167)).sub_product(t27, t168);
    let t170 = (-(t21 * t168)).sub_product(t19, t169).sub_product(t19, t167);
    let rocker_omega_dot_by_coupler_length = (-(t14 * t165))
        .add_product(t13, t166)
        .sub_product(t13, t164)
        .add_product(t14, t163);
    let rocker_v_y_dot_by_coupler_length = (-(inverse_rocker_mass * t163))
        .sub_product(inverse_rocker_mass, t165);
    let rocker_v_x_dot_by_coupler_length = (-(inverse_rocker_mass * t164))
        .sub_product(inverse_rocker_mass, t166);
    let coupler_omega_dot_by_coupler_length = (t156 * inverse_coupler_inertia)
        .sub_product(t11, t168)
        .add_product(t12, t167)
        .sub_product(t11, t166)
        .add_product(t12, t165);
    let coupler_v_y_dot_by_coupler_length = (inverse_coupler_mass * t165)
        .sub_product(inverse_coupler_mass, t167);
    let coupler_v_x_dot_by_coupler_length = (inverse_coupler_mass * t166)
        .sub_product(inverse_coupler_mass, t168);
    let crank_omega_dot_by_coupler_length = (t10 * t169)
        .sub_product(t9, t170)
        .sub_product(t9, t168)
        .add_product(t10, t167);
    let crank_v_y_dot_by_coupler_length = (inverse_crank_mass * t167)
        .sub_product(inverse_crank_mass, t169);
    let crank_v_x_dot_by_coupler_length = (inverse_crank_mass * t168)
        .sub_product(inverse_crank_mass, t170);
    let t171 = inverse_coupler_mass
        * (-(inverse_coupler_mass * t83)).add_product(inverse_coupler_mass, t85);
    let t172 = inverse_coupler_mass * (-p.coupler_gravity - coupler_v_y_dot);
    let t173 = (-t172).add_product(t34, t171);
    let t174 = t171.add_product(t36, t171).sub_product(t41, t173);
    let t175 = t172.add_product(t37, t171).sub_product(t43, t173).sub_product(t48, t174);
    let t176 = (-(t50 * t174)).sub_product(t55, t175);
    let t177 = (t51 * t174).sub_product(t57, t175).sub_product(t60, t176) * t61;
    let t178 = (t176 * t58).sub_product(t60, t177);
    let t179 = (t175 * t53).sub_product(t55, t178).sub_product(t57, t177);
    let t180 = (t174 * t45)
        .sub_product(t48, t179)
        .sub_product(t50, t178)
        .add_product(t51, t177);
    let t181 = (t173 * t39).sub_product(t41, t180).sub_product(t43, t179);
    let t182 = (-(t171 * t31))
        .sub_product(t34, t181)
        .sub_product(t36, t180)
        .sub_product(t37, t179);
    let t183 = (-(t29 * t181)).sub_product(t27, t182);
    let t184 = (-(t21 * t182)).sub_product(t19, t183).sub_product(t19, t181);
    let rocker_omega_dot_by_coupler_mass = (-(t14 * t179))
        .add_product(t13, t180)
        .sub_product(t13, t178)
        .add_product(t14, t177);
    let rocker_v_y_dot_by_coupler_mass = (-(inverse_rocker_mass * t177))
        .sub_product(inverse_rocker_mass, t179);
    let rocker_v_x_dot_by_coupler_mass = (-(inverse_rocker_mass * t178))
        .sub_product(inverse_rocker_mass, t180);
    let coupler_omega_dot_by_coupler_mass = (t12 * t181)
        .sub_product(t11, t182)
        .sub_product(t11, t180)
        .add_product(t12, t179);
    let coupler_v_y_dot_by_coupler_mass = t172
        .sub_product(inverse_coupler_mass, t181)
        .add_product(inverse_coupler_mass, t179);
    let coupler_v_x_dot_by_coupler_mass = t171
        .sub_product(inverse_coupler_mass, t182)
        .add_product(inverse_coupler_mass, t180);
    let crank_omega_dot_by_coupler_mass = (t10 * t183)
        .sub_product(t9, t184)
        .sub_product(t9, t182)
        .add_product(t10, t181);
    let crank_v_y_dot_by_coupler_mass = (inverse_crank_mass * t181)
        .sub_product(inverse_crank_mass, t183);
    let crank_v_x_dot_by_coupler_mass = (inverse_crank_mass * t182)
        .sub_product(inverse_crank_mass, t184);
    let t185 = t11 * coupler_omega_dot;
    let t186 = -(t12 * coupler_omega_dot);
    let t187 = t186.sub_product(t34, t185);
    let t188 = t185.sub_product(t36, t185).sub_product(t41, t187);
    let t189 = t186.sub_product(t37, t185).sub_product(t43, t187).sub_product(t48, t188);
    let t190 = (-(t50 * t188)).sub_product(t55, t189);
    let t191 = (t51 * t188).sub_product(t57, t189).sub_product(t60, t190) * t61;
    let t192 = (t190 * t58).sub_product(t60, t191);
    let t193 = (t189 * t53).sub_product(t55, t192).sub_product(t57, t191);
    let t194 = (t188 * t45)
        .sub_product(t48, t193)
        .sub_product(t50, t192)
        .add_product(t51, t191);
    let t195 = (t187 * t39).sub_product(t41, t194).sub_product(t43, t193);
    let t196 = (t185 * t31)
        .sub_product(t34, t195)
        .sub_product(t36, t194)
        .sub_product(t37, t193);
    let t197 = (-(t29 * t195)).sub_product(t27, t196);
    let t198 = (-(t21 * t196)).sub_product(t19, t197).sub_product(t19, t195);
    let rocker_omega_dot_by_coupler_inertia = (-(t14 * t193))
        .add_product(t13, t194)
        .sub_product(t13, t192)
        .add_product(t14, t191);
    let rocker_v_y_dot_by_coupler_inertia = (-(inverse_rocker_mass * t191))
        .sub_product(inverse_rocker_mass, t193);
    let rocker_v_x_dot_by_coupler_inertia = (-(inverse_rocker_mass * t192))
        .sub_product(inverse_rocker_mass, t194);
    let coupler_omega_dot_by_coupler_inertia = (-(coupler_omega_dot
        * inverse_coupler_inertia))
        .sub_product(t11, t196)
        .add_product(t12, t195)
        .sub_product(t11, t194)
        .add_product(t12, t193);
    let coupler_v_y_dot_by_coupler_inertia = (inverse_coupler_mass * t193)
        .sub_product(inverse_coupler_mass, t195);
    let coupler_v_x_dot_by_coupler_inertia = (inverse_coupler_mass * t194)
        .sub_product(inverse_coupler_mass, t196);
    let crank_omega_dot_by_coupler_inertia = (t10 * t197)
        .sub_product(t9, t198)
        .sub_product(t9, t196)
        .add_product(t10, t195);
    let crank_v_y_dot_by_coupler_inertia = (inverse_crank_mass * t195)
        .sub_product(inverse_crank_mass, t197);
    let crank_v_x_dot_by_coupler_inertia = (inverse_crank_mass * t196)
        .sub_product(inverse_crank_mass, t198);
    let t199 = inverse_coupler_mass * p.coupler_mass;
    let t200 = -t199;
    let t201 = t41 * t199;
    let t202 = t200.sub_product(t43, t199).add_product(t48, t201);
    let t203 = (t50 * t201).sub_product(t55, t202);
    let t204 = (-(t51 * t201)).sub_product(t57, t202).sub_product(t60, t203) * t61;
    let t205 = (t203 * t58).sub_product(t60, t204);
    let t206 = (t202 * t53).sub_product(t55, t205).sub_product(t57, t204);
    let t207 = (-(t201 * t45))
        .sub_product(t48, t206)
        .sub_product(t50, t205)
        .add_product(t51, t204);
    let t208 = (t199 * t39).sub_product(t41, t207).sub_product(t43, t206);
    let t209 = (-(t36 * t207)).sub_product(t34, t208).sub_product(t37, t206);
    let t210 = (-(t29 * t208)).sub_product(t27, t209);
    let t211 = (-(t21 * t209)).sub_product(t19, t210).sub_product(t19, t208);
    let rocker_omega_dot_by_coupler_gravity = (-(t14 * t206))
        .add_product(t13, t207)
        .sub_product(t13, t205)
        .add_product(t14, t204);
    let rocker_v_y_dot_by_coupler_gravity = (-(inverse_rocker_mass * t204))
        .sub_product(inverse_rocker_mass, t206);
    let rocker_v_x_dot_by_coupler_gravity = (-(inverse_rocker_mass * t205))
        .sub_product(inverse_rocker_mass, t207);
    let coupler_omega_dot_by_coupler_gravity = (t12 * t208)
        .sub_product(t11, t209)
        .sub_product(t11, t207)
        .add_product(t12, t206);
    let coupler_v_y_dot_by_coupler_gravity = t200
        .sub_product(inverse_coupler_mass, t208)
        .add_product(inverse_coupler_mass, t206);
    let coupler_v_x_dot_by_coupler_gravity = (inverse_coupler_mass * t207)
        .sub_product(inverse_coupler_mass, t209);
    let crank_omega_dot_by_coupler_gravity = (t10 * t210)
        .sub_product(t9, t211)
        .sub_product(t9, t209)
        .add_product(t10, t208);
    let crank_v_y_dot_by_coupler_gravity = (inverse_crank_mass * t208)
        .sub_product(inverse_crank_mass, t210);
    let crank_v_x_dot_by_coupler_gravity = (inverse_crank_mass * t209)
        .sub_product(inverse_crank_mass, t211);
    let t212 = R::literal(0.5) * rocker_omega_squared;
    let t213 = t212 * cos_rocker_phi;
    let t214 = t212 * sin_rocker_phi;
    let t215 = R::literal(0.5) * sin_rocker_phi;
    let t216 = t215 * rocker_omega_dot;
    let t217 = R::literal(0.5) * cos_rocker_phi;
    let t218 = t217 * rocker_omega_dot;
    let t219 = (-(t217 * t82))
        .add_product(t215, t83)
        .sub_product(t215, t81)
        .add_product(t217, t80);
    let t220 = t13 * t219;
    let t221 = t213 + t216 + t220;
    let t222 = t14 * t219;
    let t223 = (t214 - t218 - t222).sub_product(t48, t221);
    let t224 = (-t213 - t216 - t220).sub_product(t50, t221).sub_product(t55, t223);
    let t225 = (t218 - t214 + t222)
        .add_product(t51, t221)
        .sub_product(t57, t223)
        .sub_product(t60, t224) * t61;
    let t226 = (t224 * t58).sub_product(t60, t225);
    let t227 = (t223 * t53).sub_product(t55, t226).sub_product(t57, t225);
    let t228 = (t221 * t45)
        .sub_product(t48, t227)
        .sub_product(t50, t226)
        .add_product(t51, t225);
    let t229 = (-(t43 * t227)).sub_product(t41, t228);
    let t230 = (-(t36 * t228)).sub_product(t34, t229).sub_product(t37, t227);
    let t231 = (-(t29 * t229)).sub_product(t27, t230);
    let t232 = (-(t21 * t230)).sub_product(t19, t231).sub_product(t19, t229);
    let rocker_omega_dot_by_rocker_length = (t219 * inverse_rocker_inertia)
        .add_product(t13, t228)
        .sub_product(t14, t227)
        .sub_product(t13, t226)
        .add_product(t14, t225);
    let rocker_v_y_dot_by_rocker_length = (-(inverse_rocker_mass * t225))
        .sub_product(inverse_rocker_mass, t227);
    let rocker_v_x_dot_by_rocker_length = (-(inverse_rocker_mass * t226))
        .sub_product(inverse_rocker_mass, t228);
    let coupler_omega_dot_by_rocker_length = (t12 * t229)
        .sub_product(t11, t230)
        .sub_product(t11, t228)
        .add_product(t12, t227);
    let coupler_v_y_dot_by_rocker_length = (inverse_coupler_mass * t227)
        .sub_product(inverse_coupler_mass, t229);
    let coupler_v_x_dot_by_rocker_length = (inverse_coupler_mass * t228)
        .sub_product(inverse_coupler_mass, t230);
    let crank_omega_dot_by_rocker_length = (t10 * t231)
        .sub_product(t9, t232)
        .sub_product(t9, t230)
        .add_product(t10, t229);
    let crank_v_y_dot_by_rocker_length = (inverse_crank_mass * t229)
        .sub_product(inverse_crank_mass, t231);
    let crank_v_x_dot_by_rocker_length = (inverse_crank_mass * t230)
        .sub_product(inverse_crank_mass, t232);
    let t233 = inverse_rocker_mass
        * (inverse_rocker_mass * t81).add_product(inverse_rocker_mass, t83);
    let t234 = inverse_rocker_mass * (-p.rocker_gravity - rocker_v_y_dot);
    let t235 = (-t234).add_product(t48, t233);
    let t236 = (-t233).add_product(t50, t233).sub_product(t55, t235);
    let t237 = (-t234)
        .sub_product(t51, t233)
        .sub_product(t57, t235)
        .sub_product(t60, t236) * t61;
    let t238 = (t236 * t58).sub_product(t60, t237);
    let t239 = (t235 * t53).sub_product(t55, t238).sub_product(t57, t237);
    let t240 = (-(t233 * t45))
        .sub_product(t48, t239)
        .sub_product(t50, t238)
        .add_product(t51, t237);
    let t241 = (-(t43 * t239)).sub_product(t41, t240);
    let t242 = (-(t36 * t240)).sub_product(t34, t241).sub_product(t37, t239);
    let t243 = (-(t29 * t241)).sub_product(t27, t242);
    let t244 = (-(t21 * t242)).sub_product(t19, t243).sub_product(t19, t241);
    let rocker_omega_dot_by_rocker_mass = (-(t14 * t239))
        .add_product(t13, t240)
        .sub_product(t13, t238)
        .add_product(t14, t237);
    let rocker_v_y_dot_by_rocker_mass = t234
        .sub_product(inverse_rocker_mass, t239)
        .sub_product(inverse_rocker_mass, t237);
    let rocker_v_x_dot_by_rocker_mass = t233
        .sub_product(inverse_rocker_mass, t240)
        .sub_product(inverse_rocker_mass, t238);
    let coupler_omega_dot_by_rocker_mass = (t12 * t241)
        .sub_product(t11, t242)
        .sub_product(t11, t240)
        .add_product(t12, t239);
    let coupler_v_y_dot_by_rocker_mass = (inverse_coupler_mass * t239)
        .sub_product(inverse_coupler_mass, t241);
    let coupler_v_x_dot_by_rocker_mass = (inverse_coupler_mass * t240)
        .sub_product(inverse_coupler_mass, t242);
    let crank_omega_dot_by_rocker_mass = (t10 * t243)
        .sub_product(t9, t244)
        .sub_product(t9, t242)
        .add_product(t10, t241);
    let crank_v_y_dot_by_rocker_mass = (inverse_crank_mass * t241)
        .sub_product(inverse_crank_mass, t243);
    let crank_v_x_dot_by_rocker_mass = (inverse_crank_mass * t242)
        .sub_product(inverse_crank_mass, t244);
    let t245 = t13 * rocker_omega_dot;
    let t246 = t14 * rocker_omega_dot;
    let t247 = t246.add_product(t48, t245);
    let t248 = t245.add_product(t50, t245).sub_product(t55, t247);
    let t249 = (-t246)
        .sub_product(t51, t245)
        .sub_product(t57, t247)
        .sub_product(t60, t248) * t61;
    let t250 = (t248 * t58).sub_product(t60, t249);
    let t251 = (t247 * t53).sub_product(t55, t250).sub_product(t57, t249);
    let t252 = (-(t245 * t45))
        .sub_product(t48, t251)
        .sub_product(t50, t250)
        .add_product(t51, t249);
    let t253 = (-(t43 * t251)).sub_product(t41, t252);
    let t254 = (-(t36 * t252)).sub_product(t34, t253).sub_product(t37, t251);
    let t255 = (-(t29 * t253)).sub_product(t27, t254);
    let t256 = (-(t21 * t254)).sub_product(t19, t255).sub_product(t19, t253);
    let rocker_omega_dot_by_rocker_inertia = (-(rocker_omega_dot
        * inverse_rocker_inertia))
        .add_product(t13, t252)
        .sub_product(t14, t251)
        .sub_product(t13, t250)
        .add_product(t14, t249);
    let rocker_v_y_dot_by_rocker_inertia = (-(inverse_rocker_mass * t249))
        .sub_product(inverse_rocker_mass, t251);
    let rocker_v_x_dot_by_rocker_inertia = (-(inverse_rocker_mass * t250))
        .sub_product(inverse_rocker_mass, t252);
    let coupler_omega_dot_by_rocker_inertia = (t12 * t253)
        .sub_product(t11, t254)
        .sub_product(t11, t252)
        .add_product(t12, t251);
    let coupler_v_y_dot_by_rocker_inertia = (inverse_coupler_mass * t251)
        .sub_product(inverse_coupler_mass, t253);
    let coupler_v_x_dot_by_rocker_inertia = (inverse_coupler_mass * t252)
        .sub_product(inverse_coupler_mass, t254);
    let crank_omega_dot_by_rocker_inertia = (t10 * t255)
        .sub_product(t9, t256)
        .sub_product(t9, t254)
        .add_product(t10, t253);
    let crank_v_y_dot_by_rocker_inertia = (inverse_crank_mass * t253)
        .sub_product(inverse_crank_mass, t255);
    let crank_v_x_dot_by_rocker_inertia = (inverse_crank_mass * t254)
        .sub_product(inverse_crank_mass, t256);
    let t257 = inverse_rocker_mass * p.rocker_mass;
    let t258 = t55 * t257;
    let t259 = t257.sub_product(t57, t257).add_product(t60, t258) * t61;
    let t260 = (-(t258 * t58)).sub_product(t60, t259);
    let t261 = (t257 * t53).sub_product(t55, t260).sub_product(t57, t259);
    let t262 = (-(t50 * t260)).sub_product(t48, t261).add_product(t51, t259);
    let t263 = (-(t43 * t261)).sub_product(t41, t262);
    let t264 = (-(t36 * t262)).sub_product(t34, t263).sub_product(t37, t261);
    let t265 = (-(t29 * t263)).sub_product(t27, t264);
    let t266 = (-(t21 * t264)).sub_product(t19, t265).sub_product(t19, t263);
    let rocker_omega_dot_by_rocker_gravity = (-(t14 * t261))
        .add_product(t13, t262)
        .sub_product(t13, t260)
        .add_product(t14, t259);
    let rocker_v_y_dot_by_rocker_gravity = (-t257)
        .sub_product(inverse_rocker_mass, t261)
        .sub_product(inverse_rocker_mass, t259);
    let rocker_v_x_dot_by_rocker_gravity = (-(inverse_rocker_mass * t260))
        .sub_product(inverse_rocker_mass, t262);
    let coupler_omega_dot_by_rocker_gravity = (t12 * t263)
        .sub_product(t11, t264)
        .sub_product(t11, t262)
        .add_product(t12, t261);
    let coupler_v_y_dot_by_rocker_gravity = (inverse_coupler_mass * t261)
        .sub_product(inverse_coupler_mass, t263);
    let coupler_v_x_dot_by_rocker_gravity = (inverse_coupler_mass * t262)
        .sub_product(inverse_coupler_mass, t264);
    let crank_omega_dot_by_rocker_gravity = (t10 * t265)
        .sub_product(t9, t266)
        .sub_product(t9, t264)
        .add_product(t10, t263);
    let crank_v_y_dot_by_rocker_gravity = (inverse_crank_mass * t263)
        .sub_product(inverse_crank_mass, t265);
    let crank_v_x_dot_by_rocker_gravity = (inverse_crank_mass * t264)
        .sub_product(inverse_crank_mass, t266);
    [
        crank_v_x_dot_by_crank_length,
        crank_v_x_dot_by_crank_mass,
        crank_v_x_dot_by_crank_inertia,
        crank_v_x_dot_by_crank_gravity,
        crank_v_x_dot_by_coupler_length,
        crank_v_x_dot_by_coupler_mass,
        crank_v_x_dot_by_coupler_inertia,
        crank_v_x_dot_by_coupler_gravity,
        crank_v_x_dot_by_rocker_length,
        crank_v_x_dot_by_rocker_mass,
        crank_v_x_dot_by_rocker_inertia,
        crank_v_x_dot_by_rocker_gravity,
        crank_v_y_dot_by_crank_length,
        crank_v_y_dot_by_crank_mass,
        crank_v_y_dot_by_crank_inertia,
        crank_v_y_dot_by_crank_gravity,
        crank_v_y_dot_by_coupler_length,
        crank_v_y_dot_by_coupler_mass,
        crank_v_y_dot_by_coupler_inertia,
        crank_v_y_dot_by_coupler_gravity,
        crank_v_y_dot_by_rocker_length,
        crank_v_y_dot_by_rocker_mass,
        crank_v_y_dot_by_rocker_inertia,
        crank_v_y_dot_by_rocker_gravity,
        crank_omega_dot_by_crank_length,
        crank_omega_dot_by_crank_mass,
        crank_omega_dot_by_crank_inertia,
        crank_omega_dot_by_crank_gravity,
        crank_omega_dot_by_coupler_length,
        crank_omega_dot_by_coupler_mass,
        crank_omega_dot_by_coupler_inertia,
        crank_omega_dot_by_coupler_gravity,
        crank_omega_dot_by_rocker_length,
        crank_omega_dot_by_rocker_mass,
        crank_omega_dot_by_rocker_inertia,
        crank_omega_dot_by_rocker_gravity,
        coupler_v_x_dot_by_crank_length,
        coupler_v_x_dot_by_crank_mass,
        coupler_v_x_dot_by_crank_inertia,
        coupler_v_x_dot_by_crank_gravity,
        coupler_v_x_dot_by_coupler_length,
        coupler_v_x_dot_by_coupler_mass,
        coupler_v_x_dot_by_coupler_inertia,
        coupler_v_x_dot_by_coupler_gravity,
        coupler_v_x_dot_by_rocker_length,
        coupler_v_x_dot_by_rocker_mass,
        coupler_v_x_dot_by_rocker_inertia,
        coupler_v_x_dot_by_rocker_gravity,
        coupler_v_y_dot_by_crank_length,
        coupler_v_y_dot_by_crank_mass,
        coupler_v_y_dot_by_crank_inertia,
        coupler_v_y_dot_by_crank_gravity,
        coupler_v_y_dot_by_coupler_length,
        coupler_v_y_dot_by_coupler_mass,
        coupler_v_y_dot_by_coupler_inertia,
        coupler_v_y_dot_by_coupler_gravity,
        coupler_v_y_dot_by_rocker_length,
        coupler_v_y_dot_by_rocker_mass,
        coupler_v_y_dot_by_rocker_inertia,
        coupler_v_y_dot_by_rocker_gravity,
        coupler_omega_dot_by_crank_length,
        coupler_omega_dot_by_crank_mass,
        coupler_omega_dot_by_crank_inertia,
        coupler_omega_dot_by_crank_gravity,
        coupler_omega_dot_by_coupler_length,
        coupler_omega_dot_by_coupler_mass,
        coupler_omega_dot_by_coupler_inertia,
        coupler_omega_dot_by_coupler_gravity,
        coupler_omega_dot_by_rocker_length,
        coupler_omega_dot_by_rocker_mass,
        coupler_omega_dot_by_rocker_inertia,
        coupler_omega_dot_by_rocker_gravity,
        rocker_v_x_dot_by_crank_length,
        rocker_v_x_dot_by_crank_mass,
        rocker_v_x_dot_by_crank_inertia,
        rocker_v_x_dot_by_crank_gravity,
        rocker_v_x_dot_by_coupler_length,
        rocker_v_x_dot_by_coupler_mass,
        rocker_v_x_dot_by_coupler_inertia,
        rocker_v_x_dot_by_coupler_gravity,
        rocker_v_x_dot_by_rocker_length,
        rocker_v_x_dot_by_rocker_mass,
        rocker_v_x_dot_by_rocker_inertia,
        rocker_v_x_dot_by_rocker_gravity,
        rocker_v_y_dot_by_crank_length,
        rocker_v_y_dot_by_crank_mass,
        rocker_v_y_dot_by_crank_inertia,
        rocker_v_y_dot_by_crank_gravity,
        rocker_v_y_dot_by_coupler_length,
        rocker_v_y_dot_by_coupler_mass,
        rocker_v_y_dot_by_coupler_inertia,
        rocker_v_y_dot_by_coupler_gravity,
        rocker_v_y_dot_by_rocker_length,
        rocker_v_y_dot_by_rocker_mass,
        rocker_v_y_dot_by_rocker_inertia,
        rocker_v_y_dot_by_rocker_gravity,
        rocker_omega_dot_by_crank_length,
        rocker_omega_dot_by_crank_mass,
        rocker_omega_dot_by_crank_inertia,
        rocker_omega_dot_by_crank_gravity,
        rocker_omega_dot_by_coupler_length,
        rocker_omega_dot_by_coupler_mass,
        rocker_omega_dot_by_coupler_inertia,
        rocker_omega_dot_by_coupler_gravity,
        rocker_omega_dot_by_rocker_length,
        rocker_omega_dot_by_rocker_mass,
        rocker_omega_dot_by_rocker_inertia,
        rocker_omega_dot_by_rocker_gravity,
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
        R::literal(0.0),
        R::literal(0.0),
    ]
}

/// Wanted outputs.
///
/// 253 operations.
#[must_use]
pub fn outputs<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>) -> Outputs<R> {
    let [_, _, crank_phi, _, _, coupler_phi, _, _, rocker_phi, _, _, crank_omega, _, _,
    coupler_omega, _, _, rocker_omega] = *state;
    let [(sin_crank_phi, cos_crank_phi), (sin_coupler_phi, cos_coupler_phi),
    (sin_rocker_phi, cos_rocker_phi)] = R::sin_cos_each([
        crank_phi,
        coupler_phi,
        rocker_phi,
    ]);
    let t0 = R::literal(0.5) * p.crank_length;
    let t1 = t0 * cos_crank_phi;
    let t2 = t0 * sin_crank_phi;
    let t3 = R::literal(0.5) * p.coupler_length;
    let t4 = t3 * cos_coupler_phi;
    let t5 = t3 * sin_coupler_phi;
    let t6 = R::literal(0.5) * p.rocker_length;
    let t7 = t6 * cos_rocker_phi;
    let t8 = t6 * sin_rocker_phi;
    let inverse_crank_mass = R::literal(1.0) / p.crank_mass;
    let minus_inverse_crank_mass = -inverse_crank_mass;
    let inverse_crank_inertia = R::literal(1.0) / p.crank_inertia;
    let t9 = t2 * inverse_crank_inertia;
    let t10 = t1 * inverse_crank_inertia;
    let inverse_coupler_mass = R::literal(1.0) / p.coupler_mass;
    let minus_inverse_coupler_mass = -inverse_coupler_mass;
    let inverse_coupler_inertia = R::literal(1.0) / p.coupler_inertia;
    let t11 = t5 * inverse_coupler_inertia;
    let t12 = t4 * inverse_coupler_inertia;
    let inverse_rocker_mass = R::literal(1.0) / p.rocker_mass;
    let inverse_rocker_inertia = R::literal(1.0) / p.rocker_inertia;
    let t13 = t8 * inverse_rocker_inertia;
    let t14 = t7 * inverse_rocker_inertia;
    let t15 = t9 * t2;
    let t16 = minus_inverse_crank_mass - t15;
    let t17 = R::literal(1.0) / t16;
    let t18 = t10 * t2;
    let t19 = t18 * t17;
    let t20 = inverse_crank_mass - t15;
    let t21 = t20 * t17;
    let t22 = t10 * t1;
    let t23 = minus_inverse_crank_mass - t22;
    let t24 = t19 * t18;
    let t25 = R::literal(1.0) / (t23 - t24);
    let t26 = (t9 * t1).sub_product(t21, t18);
    let t27 = t26 * t25;
    let t28 = inverse_crank_mass - t22 - t24;
    let t29 = t28 * t25;
    let t30 = t11 * t5;
    let t31 = R::literal(1.0)
        / (t16 - inverse_coupler_mass - t30).sub_product(t21, t20).sub_product(t27, t26);
    let t32 = t12 * t5;
    let t33 = (t18 + t32).sub_product(t19, t20).sub_product(t29, t26);
    let t34 = t33 * t31;
    let t35 = inverse_coupler_mass - t30;
    let t36 = t35 * t31;
    let t37 = t32 * t31;
    let t38 = t12 * t4;
    let t39 = R::literal(1.0)
        / (t23 - inverse_coupler_mass - t38 - t24)
            .sub_product(t29, t28)
            .sub_product(t34, t33);
    let t40 = (t11 * t4).sub_product(t36, t33);
    let t41 = t40 * t39;
    let t42 = (inverse_coupler_mass - t38).sub_product(t37, t33);
    let t43 = t42 * t39;
    let t44 = t13 * t8;
    let t45 = R::literal(1.0)
        / (minus_inverse_coupler_mass - t30 - inverse_rocker_mass - t44)
            .sub_product(t36, t35)
            .sub_product(t41, t40);
    let t46 = t14 * t8;
    let t47 = (t32 + t46).sub_product(t37, t35).sub_product(t43, t40);
    let t48 = t47 * t45;
    let minus_inverse_rocker_mass = -inverse_rocker_mass;
    let t49 = t44 - inverse_rocker_mass;
    let t50 = t49 * t45;
    let t51 = t46 * t45;
    let t52 = t14 * t7;
    let t53 = R::literal(1.0)
        / (minus_inverse_coupler_mass - t38 - inverse_rocker_mass - t52)
            .sub_product(t37, t32)
            .sub_product(t43, t42)
            .sub_product(t48, t47);
    let t54 = (-(t13 * t7)).sub_product(t50, t47);
    let t55 = t54 * t53;
    let t56 = (t52 - inverse_rocker_mass).add_product(t51, t47);
    let t57 = t56 * t53;
    let t58 = R::literal(1.0)
        / (minus_inverse_rocker_mass - t44).sub_product(t50, t49).sub_product(t55, t54);
    let t59 = t46.add_product(t51, t49).sub_product(t57, t54);
    let t60 = t59 * t58;
    let crank_omega_squared = crank_omega * crank_omega;
    let t61 = t0 * crank_omega_squared;
    let t62 = t61 * cos_crank_phi;
    let t63 = p.crank_length * crank_omega_squared;
    let coupler_omega_squared = coupler_omega * coupler_omega;
    let t64 = p.coupler_length * coupler_omega_squared;
    let t65 = t6 * (rocker_omega * rocker_omega);
    let t66 = t65 * cos_rocker_phi;
    let t67 = t3 * coupler_omega_squared;
    let t68 = t65 * sin_rocker_phi;
    let t69 = inverse_crank_mass * (p.crank_mass * p.crank_gravity);
    let t70 = t19 * t62;
    let t71 = t69.sub_product(t61, sin_crank_phi) + t70;
    let t72 = (-(R::literal(0.5)
        * (t63 * cos_crank_phi).add_product(t64, cos_coupler_phi)))
        .add_product(t21, t62)
        .sub_product(t27, t71);
    let t73 = inverse_coupler_mass * (p.coupler_mass * p.coupler_gravity);
    let t74 = ((-t69)
        .sub_product(
            R::literal(0.5),
            (t63 * sin_crank_phi).add_product(t64, sin_coupler_phi),
        ) + t73 + t70)
        .sub_product(t29, t71)
        .sub_product(t34, t72);
    let t75 = t66
        .sub_product(t67, cos_coupler_phi)
        .sub_product(t36, t72)
        .sub_product(t41, t74);
    let t76 = inverse_rocker_mass * (p.rocker_mass * p.rocker_gravity);
    let t77 = (t68.sub_product(t67, sin_coupler_phi) - t73 + t76)
        .sub_product(t37, t72)
        .sub_product(t43, t74)
        .sub_product(t48, t75);
    let t78 = (-t66).sub_product(t50, t75).sub_product(t55, t77);
    let t79 = (t76 - t68)
        .add_product(t51, t75)
        .sub_product(t57, t77)
        .sub_product(t60, t78)
        * (R::literal(1.0)
            / (minus_inverse_rocker_mass - t52)
                .sub_product(t51, t46)
                .sub_product(t57, t56)
                .sub_product(t60, t59));
    let t80 = (t78 * t58).sub_product(t60, t79);
    let t81 = (t77 * t53).sub_product(t55, t80).sub_product(t57, t79);
    let t82 = (t75 * t45)
        .sub_product(t48, t81)
        .sub_product(t50, t80)
        .add_product(t51, t79);
    let t83 = (t74 * t39).sub_product(t41, t82).sub_product(t43, t81);
    let t84 = (t72 * t31)
        .sub_product(t34, t83)
        .sub_product(t36, t82)
        .sub_product(t37, t81);
    let t85 = (t71 * t25).sub_product(t27, t84);
    let t86 = t29 * t83;
    let pin_o_x = (-(-(t62 * t17)).sub_product(t19, t85 - t86).sub_product(t21, t84))
        .add_product(t19, t83);
    let pin_o_y = t86 - t85;
    Outputs {
        crank_angle: crank_phi,
        coupler_angle: coupler_phi,
        rocker_angle: rocker_phi,
        crank_speed: crank_omega,
        pin_force_x: pin_o_x,
        pin_force_y: pin_o_y,
    }
}

/// T, V and the energy of first-order states \[J\].
///
/// 37 operations.
#[must_use]
pub fn energy<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>) -> Energy<R> {
    let [_, crank_y, _, _, coupler_y, _, _, rocker_y, _, crank_v_x, crank_v_y,
    crank_omega, coupler_v_x, coupler_v_y, coupler_omega, rocker_v_x, rocker_v_y,
    rocker_omega] = *state;
    Energy {
        kinetic: (R::literal(0.5) * p.crank_inertia * (crank_omega * crank_omega))
            .add_product(
                R::literal(0.5) * p.crank_mass,
                (crank_v_x * crank_v_x).add_product(crank_v_y, crank_v_y),
            )
            .add_product(
                R::literal(0.5) * p.coupler_mass,
                (coupler_v_x * coupler_v_x).add_product(coupler_v_y, coupler_v_y),
            )
            .add_product(
                R::literal(0.5) * p.coupler_inertia,
                coupler_omega * coupler_omega,
            )
            .add_product(
                R::literal(0.5) * p.rocker_mass,
                (rocker_v_x * rocker_v_x).add_product(rocker_v_y, rocker_v_y),
            )
            .add_product(
                R::literal(0.5) * p.rocker_inertia,
                rocker_omega * rocker_omega,
            ),
        potential: (p.crank_mass * p.crank_gravity * crank_y)
            .add_product(p.coupler_mass * p.coupler_gravity, coupler_y)
            .add_product(p.rocker_mass * p.rocker_gravity, rocker_y),
        stored: R::literal(0.0),
    }
}

/// `dE/dt`, power supplied and power dissipated \[W\].
///
/// 330 operations.
#[must_use]
pub fn power_balance<R: Real>(
    _time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
) -> PowerBalance<R> {
    let [_, _, crank_phi, _, _, coupler_phi, _, _, rocker_phi, crank_v_x, crank_v_y,
    crank_omega, coupler_v_x, coupler_v_y, coupler_omega, rocker_v_x, rocker_v_y,
    rocker_omega] = *state;
    let [(sin_crank_phi, cos_crank_phi), (sin_coupler_phi, cos_coupler_phi),
    (sin_rocker_phi, cos_rocker_phi)] = R::sin_cos_each([
        crank_phi,
        coupler_phi,
        rocker_phi,
    ]);
    let t0 = R::literal(0.5) * p.crank_length;
    let t1 = t0 * cos_crank_phi;
    let t2 = t0 * sin_crank_phi;
    let t3 = R::literal(0.5) * p.coupler_length;
    let t4 = t3 * cos_coupler_phi;
    let t5 = t3 * sin_coupler_phi;
    let t6 = R::literal(0.5) * p.rocker_length;
    let t7 = t6 * cos_rocker_phi;
    let t8 = t6 * sin_rocker_phi;
    let inverse_crank_mass = R::literal(1.0) / p.crank_mass;
    let minus_inverse_crank_mass = -inverse_crank_mass;
    let inverse_crank_inertia = R::literal(1.0) / p.crank_inertia;
    let t9 = t2 * inverse_crank_inertia;
    let t10 = t1 * inverse_crank_inertia;
    let inverse_coupler_mass = R::literal(1.0) / p.coupler_mass;
    let minus_inverse_coupler_mass = -inverse_coupler_mass;
    let inverse_coupler_inertia = R::literal(1.0) / p.coupler_inertia;
    let t11 = t5 * inverse_coupler_inertia;
    let t12 = t4 * inverse_coupler_inertia;
    let inverse_rocker_mass = R::literal(1.0) / p.rocker_mass;
    let inverse_rocker_inertia = R::literal(1.0) / p.rocker_inertia;
    let t13 = t8 * inverse_rocker_inertia;
    let t14 = t7 * inverse_rocker_inertia;
    let t15 = t9 * t2;
    let t16 = minus_inverse_crank_mass - t15;
    let t17 = R::literal(1.0) / t16;
    let t18 = t10 * t2;
    let t19 = t18 * t17;
    let t20 = inverse_crank_mass - t15;
    let t21 = t20 * t17;
    let t22 = t10 * t1;
    let t23 = minus_inverse_crank_mass - t22;
    let t24 = t19 * t18;
    let t25 = R::literal(1.0) / (t23 - t24);
    let t26 = (t9 * t1).sub_product(t21, t18);
    let t27 = t26 * t25;
    let t28 = inverse_crank_mass - t22 - t24;
    let t29 = t28 * t25;
    let t30 = t11 * t5;
    let t31 = R::literal(1.0)
        / (t16 - inverse_coupler_mass - t30).sub_product(t21, t20).sub_product(t27, t26);
    let t32 = t12 * t5;
    let t33 = (t18 + t32).sub_product(t19, t20).sub_product(t29, t26);
    let t34 = t33 * t31;
    let t35 = inverse_coupler_mass - t30;
    let t36 = t35 * t31;
    let t37 = t32 * t31;
    let t38 = t12 * t4;
    let t39 = R::literal(1.0)
        / (t23 - inverse_coupler_mass - t38 - t24)
            .sub_product(t29, t28)
            .sub_product(t34, t33);
    let t40 = (t11 * t4).sub_product(t36, t33);
    let t41 = t40 * t39;
    let t42 = (inverse_coupler_mass - t38).sub_product(t37, t33);
    let t43 = t42 * t39;
    let t44 = t13 * t8;
    let t45 = R::literal(1.0)
        / (minus_inverse_coupler_mass - t30 - inverse_rocker_mass - t44)
            .sub_product(t36, t35)
            .sub_product(t41, t40);
    let t46 = t14 * t8;
    let t47 = (t32 + t46).sub_product(t37, t35).sub_product(t43, t40);
    let t48 = t47 * t45;
    let minus_inverse_rocker_mass = -inverse_rocker_mass;
    let t49 = t44 - inverse_rocker_mass;
    let t50 = t49 * t45;
    let t51 = t46 * t45;
    let t52 = t14 * t7;
    let t53 = R::literal(1.0)
        / (minus_inverse_coupler_mass - t38 - inverse_rocker_mass - t52)
            .sub_product(t37, t32)
            .sub_product(t43, t42)
            .sub_product(t48, t47);
    let t54 = (-(t13 * t7)).sub_product(t50, t47);
    let t55 = t54 * t53;
    let t56 = (t52 - inverse_rocker_mass).add_product(t51, t47);
    let t57 = t56 * t53;
    let t58 = R::literal(1.0)
        / (minus_inverse_rocker_mass - t44).sub_product(t50, t49).sub_product(t55, t54);
    let t59 = t46.add_product(t51, t49).sub_product(t57, t54);
    let t60 = t59 * t58;
    let crank_mass_times_crank_gravity = p.crank_mass * p.crank_gravity;
    let coupler_mass_times_coupler_gravity = p.coupler_mass * p.coupler_gravity;
    let rocker_mass_times_rocker_gravity = p.rocker_mass * p.rocker_gravity;
    let crank_omega_squared = crank_omega * crank_omega;
    let t61 = t0 * crank_omega_squared;
    let t62 = t61 * cos_crank_phi;
    let t63 = p.crank_length * crank_omega_squared;
    let coupler_omega_squared = coupler_omega * coupler_omega;
    let t64 = p.coupler_length * coupler_omega_squared;
    let t65 = t6 * (rocker_omega * rocker_omega);
    let t66 = t65 * cos_rocker_phi;
    let t67 = t3 * coupler_omega_squared;
    let t68 = t65 * sin_rocker_phi;
    let t69 = inverse_crank_mass * crank_mass_times_crank_gravity;
    let t70 = t19 * t62;
    let t71 = t69.sub_product(t61, sin_crank_phi) + t70;
    let t72 = (-(R::literal(0.5)
        * (t63 * cos_crank_phi).add_product(t64, cos_coupler_phi)))
        .add_product(t21, t62)
        .sub_product(t27, t71);
    let t73 = inverse_coupler_mass * coupler_mass_times_coupler_gravity;
    let t74 = ((-t69)
        .sub_product(
            R::literal(0.5),
            (t63 * sin_crank_phi).add_product(t64, sin_coupler_phi),
        ) + t73 + t70)
        .sub_product(t29, t71)
        .sub_product(t34, t72);
    let t75 = t66
        .sub_product(t67, cos_coupler_phi)
        .sub_product(t36, t72)
        .sub_product(t41, t74);
    let t76 = inverse_rocker_mass * rocker_mass_times_rocker_gravity;
    let t77 = (t68.sub_product(t67, sin_coupler_phi) - t73 + t76)
        .sub_product(t37, t72)
        .sub_product(t43, t74)
        .sub_product(t48, t75);
    let t78 = (-t66).sub_product(t50, t75).sub_product(t55, t77);
    let t79 = (t76 - t68)
        .add_product(t51, t75)
        .sub_product(t57, t77)
        .sub_product(t60, t78)
        * (R::literal(1.0)
            / (minus_inverse_rocker_mass - t52)
                .sub_product(t51, t46)
                .sub_product(t57, t56)
                .sub_product(t60, t59));
    let t80 = (t78 * t58).sub_product(t60, t79);
    let t81 = (t77 * t53).sub_product(t55, t80).sub_product(t57, t79);
    let t82 = (t75 * t45)
        .sub_product(t48, t81)
        .sub_product(t50, t80)
        .add_product(t51, t79);
    let t83 = (t74 * t39).sub_product(t41, t82).sub_product(t43, t81);
    let t84 = (t72 * t31)
        .sub_product(t34, t83)
        .sub_product(t36, t82)
        .sub_product(t37, t81);
    let t85 = (t71 * t25).sub_product(t27, t84).sub_product(t29, t83);
    let t86 = (-(t62 * t17))
        .sub_product(t19, t85)
        .sub_product(t21, t84)
        .sub_product(t19, t83);
    let rocker_omega_dot = (-(t14 * t81))
        .add_product(t13, t82)
        .sub_product(t13, t80)
        .add_product(t14, t79);
    let rocker_v_y_dot = (-t76)
        .sub_product(inverse_rocker_mass, t81)
        .sub_product(inverse_rocker_mass, t79);
    let rocker_v_x_dot = (-(inverse_rocker_mass * t80))
        .sub_product(inverse_rocker_mass, t82);
    let coupler_omega_dot = (t12 * t83)
        .sub_product(t11, t84)
        .sub_product(t11, t82)
        .add_product(t12, t81);
    let coupler_v_y_dot = (-t73)
        .sub_product(inverse_coupler_mass, t83)
        .add_product(inverse_coupler_mass, t81);
    let coupler_v_x_dot = (inverse_coupler_mass * t82)
        .sub_product(inverse_coupler_mass, t84);
    let crank_omega_dot = (t10 * t85)
        .sub_product(t9, t86)
        .sub_product(t9, t84)
        .add_product(t10, t83);
    let crank_v_y_dot = (-t69)
        .sub_product(inverse_crank_mass, t85)
        .add_product(inverse_crank_mass, t83);
    let crank_v_x_dot = (inverse_crank_mass * t84).sub_product(inverse_crank_mass, t86);
    PowerBalance {
        stored_rate: (crank_mass_times_crank_gravity * crank_v_y)
            .add_product(coupler_mass_times_coupler_gravity, coupler_v_y)
            .add_product(rocker_mass_times_rocker_gravity, rocker_v_y)
            .add_product(p.crank_mass * crank_v_x, crank_v_x_dot)
            .add_product(p.crank_mass * crank_v_y, crank_v_y_dot)
            .add_product(p.crank_inertia * crank_omega, crank_omega_dot)
            .add_product(p.coupler_mass * coupler_v_x, coupler_v_x_dot)
            .add_product(p.coupler_mass * coupler_v_y, coupler_v_y_dot)
            .add_product(p.coupler_inertia * coupler_omega, coupler_omega_dot)
            .add_product(p.rocker_mass * rocker_v_x, rocker_v_x_dot)
            .add_product(p.rocker_mass * rocker_v_y, rocker_v_y_dot)
            .add_product(p.rocker_inertia * rocker_omega, rocker_omega_dot),
        supplied: R::literal(0.0),
        dissipated: R::literal(0.0),
    }
}

/// `g`, zero on the constraints, in the order of `CONSTRAINT_SHAPES`.
///
/// 32 operations.
#[must_use]
pub fn constraint_values<R: Real>(
    _time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
) -> [R; CONSTRAINTS] {
    let [crank_x, crank_y, crank_phi, coupler_x, coupler_y, coupler_phi, rocker_x,
    rocker_y, rocker_phi, ..] = *state;
    let [(sin_crank_phi, cos_crank_phi), (sin_coupler_phi, cos_coupler_phi),
    (sin_rocker_phi, cos_rocker_phi)] = R::sin_cos_each([
        crank_phi,
        coupler_phi,
        rocker_phi,
    ]);
    let t0 = R::literal(0.5) * p.crank_length;
    let t1 = t0 * cos_crank_phi;
    let crank_start_x = crank_x - t1;
    let t2 = t0 * sin_crank_phi;
    let crank_start_y = crank_y - t2;
    let crank_end_x = crank_x + t1;
    let crank_end_y = crank_y + t2;
    let t3 = R::literal(0.5) * p.coupler_length;
    let t4 = t3 * cos_coupler_phi;
    let coupler_start_x = coupler_x - t4;
    let t5 = t3 * sin_coupler_phi;
    let coupler_start_y = coupler_y - t5;
    let coupler_end_x = coupler_x + t4;
    let coupler_end_y = coupler_y + t5;
    let t6 = R::literal(0.5) * p.rocker_length;
    let t7 = t6 * cos_rocker_phi;
    let rocker_start_x = rocker_x - t7;
    let t8 = t6 * sin_rocker_phi;
    let rocker_start_y = rocker_y - t8;
    let rocker_end_x = rocker_x + t7;
    let rocker_end_y = rocker_y + t8;
    let pin_a_x_value = coupler_start_x - crank_end_x;
    let pin_a_y_value = coupler_start_y - crank_end_y;
    let pin_b_x_value = rocker_end_x - coupler_end_x;
    let pin_b_y_value = rocker_end_y - coupler_end_y;
    let pin_c_x_value = rocker_start_x - p.base;
    [
        crank_start_x,
        crank_start_y,
        pin_a_x_value,
        pin_a_y_value,
        pin_b_x_value,
        pin_b_y_value,
        pin_c_x_value,
        rocker_start_y,
    ]
}

/// `g'`, zero on the constraints too.
///
/// 34 operations.
#[must_use]
pub fn constraint_rates<R: Real>(
    _time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
) -> [R; CONSTRAINTS] {
    let [_, _, crank_phi, _, _, coupler_phi, _, _, rocker_phi, crank_v_x, crank_v_y,
    crank_omega, coupler_v_x, coupler_v_y, coupler_omega, rocker_v_x, rocker_v_y,
    rocker_omega] = *state;
    let [(sin_crank_phi, cos_crank_phi), (sin_coupler_phi, cos_coupler_phi),
    (sin_rocker_phi, cos_rocker_phi)] = R::sin_cos_each([
        crank_phi,
        coupler_phi,
        rocker_phi,
    ]);
    let t0 = R::literal(0.5) * p.crank_length * crank_omega;
    let t1 = t0 * sin_crank_phi;
    let pin_o_x_rate = crank_v_x + t1;
    let t2 = t0 * cos_crank_phi;
    let pin_o_y_rate = crank_v_y - t2;
    let t3 = R::literal(0.5) * p.coupler_length * coupler_omega;
    let t4 = t3 * sin_coupler_phi;
    let pin_a_x_rate = coupler_v_x + t1 + t4 - crank_v_x;
    let t5 = t3 * cos_coupler_phi;
    let pin_a_y_rate = coupler_v_y - crank_v_y - t2 - t5;
    let t6 = R::literal(0.5) * p.rocker_length * rocker_omega;
    let t7 = t6 * sin_rocker_phi;
    let pin_b_x_rate = rocker_v_x + t4 - coupler_v_x - t7;
    let t8 = t6 * cos_rocker_phi;
    let pin_b_y_rate = rocker_v_y + t8 - coupler_v_y - t5;
    let pin_c_x_rate = rocker_v_x + t7;
    let pin_c_y_rate = rocker_v_y - t8;
    [
        pin_o_x_rate,
        pin_o_y_rate,
        pin_a_x_rate,
        pin_a_y_rate,
        pin_b_x_rate,
        pin_b_y_rate,
        pin_c_x_rate,
        pin_c_y_rate,
    ]
}

/// `G = dg'/dq'`, values in the order of `CONSTRAINT_MATRIX_PATTERN`.
///
/// 19 operations.
#[must_use]
pub fn constraint_matrix<R: Real>(
    _time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
) -> [R; 24] {
    let [_, _, crank_phi, _, _, coupler_phi, _, _, rocker_phi, ..] = *state;
    let [(sin_crank_phi, cos_crank_phi), (sin_coupler_phi, cos_coupler_phi),
    (sin_rocker_phi, cos_rocker_phi)] = R::sin_cos_each([
        crank_phi,
        coupler_phi,
        rocker_phi,
    ]);
    let t0 = R::literal(0.5) * p.crank_length;
    let t1 = t0 * sin_crank_phi;
    let t2 = R::literal(0.5) * p.coupler_length;
    let t3 = t2 * sin_coupler_phi;
    let t4 = R::literal(0.5) * p.rocker_length;
    let t5 = t4 * cos_rocker_phi;
    let t6 = t4 * sin_rocker_phi;
    let t7 = -(t0 * cos_crank_phi);
    let t8 = -(t2 * cos_coupler_phi);
    [
        R::literal(1.0),
        t1,
        R::literal(1.0),
        t7,
        R::literal(-1.0),
        t1,
        R::literal(1.0),
        t3,
        R::literal(-1.0),
        t7,
        R::literal(1.0),
        t8,
        R::literal(-1.0),
        t3,
        R::literal(1.0),
        -t6,
        R::literal(-1.0),
        t8,
        R::literal(1.0),
        t5,
        R::literal(1.0),
        t6,
        R::literal(1.0),
        -t5,
    ]
}

impl Describe for FourBar {
    fn name(&self) -> &'static str {
        "four_bar"
    }
    fn title(&self) -> &'static str {
        "Four-bar linkage under gravity"
    }
    fn shape(&self) -> Shape {
        Shape {
            coordinates: COORDINATES,
            positions: 9,
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
    fn constraints(&self) -> usize {
        CONSTRAINTS
    }
    fn constraint(&self, index: usize) -> Constraint<'_> {
        CONSTRAINT_SHAPES[index]
    }
    fn constraint_matrix_pattern(&self) -> SparsityPattern<'_> {
        CONSTRAINT_MATRIX_PATTERN
    }
    fn is_given(&self, index: usize) -> bool {
        matches!(index, 2 | 11)
    }
}

impl<R: Real> Simulator<R> for FourBar {
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
    fn constraint_values(
        &self,
        time: R,
        state: &[R],
        parameters: &[R],
        values: &mut [R],
    ) {
        *array_of(values) = constraint_values(
            time,
            state_of(state),
            &parameters_of(parameters),
        );
    }
    fn constraint_rates(
        &self,
        time: R,
        state: &[R],
        parameters: &[R],
        values: &mut [R],
    ) {
        *array_of(values) = constraint_rates(
            time,
            state_of(state),
            &parameters_of(parameters),
        );
    }
    fn constraint_matrix(
        &self,
        time: R,
        state: &[R],
        parameters: &[R],
        values: &mut [R],
    ) {
        *array_of(values) = constraint_matrix(
            time,
            state_of(state),
            &parameters_of(parameters),
        );
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
        name: "crank.x",
        unit: "m",
        doc: "centre of mass, sideways",
    },
    Quantity {
        name: "crank.y",
        unit: "m",
        doc: "centre of mass, upwards",
    },
    Quantity {
        name: "crank.phi",
        unit: "rad",
        doc: "angle of the bar from sideways",
    },
    Quantity {
        name: "coupler.x",
        unit: "m",
        doc: "centre of mass, sideways",
    },
    Quantity {
        name: "coupler.y",
        unit: "m",
        doc: "centre of mass, upwards",
    },
    Quantity {
        name: "coupler.phi",
        unit: "rad",
        doc: "angle of the bar from sideways",
    },
    Quantity {
        name: "rocker.x",
        unit: "m",
        doc: "centre of mass, sideways",
    },
    Quantity {
        name: "rocker.y",
        unit: "m",
        doc: "centre of mass, upwards",
    },
    Quantity {
        name: "rocker.phi",
        unit: "rad",
        doc: "angle of the bar from sideways",
    },
    Quantity {
        name: "crank.v_x",
        unit: "m/s",
        doc: "rate of centre of mass, sideways",
    },
    Quantity {
        name: "crank.v_y",
        unit: "m/s",
        doc: "rate of centre of mass, upwards",
    },
    Quantity {
        name: "crank.omega",
        unit: "rad/s",
        doc: "rate of angle of the bar from sideways",
    },
    Quantity {
        name: "coupler.v_x",
        unit: "m/s",
        doc: "rate of centre of mass, sideways",
    },
    Quantity {
        name: "coupler.v_y",
        unit: "m/s",
        doc: "rate of centre of mass, upwards",
    },
    Quantity {
        name: "coupler.omega",
        unit: "rad/s",
        doc: "rate of angle of the bar from sideways",
    },
    Quantity {
        name: "rocker.v_x",
        unit: "m/s",
        doc: "rate of centre of mass, sideways",
    },
    Quantity {
        name: "rocker.v_y",
        unit: "m/s",
        doc: "rate of centre of mass, upwards",
    },
    Quantity {
        name: "rocker.omega",
        unit: "rad/s",
        doc: "rate of angle of the bar from sideways",
    },
];

static STATE_SCALES: [f64; STATES] = [
    0.1,
    0.1,
    1.0,
    0.1,
    0.1,
    1.0,
    0.1,
    0.1,
    1.0,
    1.0,
    1.0,
    10.0,
    1.0,
    1.0,
    10.0,
    1.0,
    1.0,
    10.0,
];

static PARAMETER_QUANTITIES: [Quantity<'static>; PARAMETERS] = [
    Quantity {
        name: "base",
        unit: "m",
        doc: "distance of the two pins in the frame",
    },
    Quantity {
        name: "angle",
        unit: "rad",
        doc: "angle of the crank at the start",
    },
    Quantity {
        name: "speed",
        unit: "rad/s",
        doc: "speed of the crank at the start",
    },
    Quantity {
        name: "crank.length",
        unit: "m",
        doc: "length of the bar",
    },
    Quantity {
        name: "crank.mass",
        unit: "kg",
        doc: "the mass",
    },
    Quantity {
        name: "crank.inertia",
        unit: "kg m^2",
        doc: "moment of inertia about the centre of mass",
    },
    Quantity {
        name: "crank.gravity",
        unit: "m/s^2",
        doc: "acceleration of free fall",
    },
    Quantity {
        name: "coupler.length",
        unit: "m",
        doc: "length of the bar",
    },
    Quantity {
        name: "coupler.mass",
        unit: "kg",
        doc: "the mass",
    },
    Quantity {
        name: "coupler.inertia",
        unit: "kg m^2",
        doc: "moment of inertia about the centre of mass",
    },
    Quantity {
        name: "coupler.gravity",
        unit: "m/s^2",
        doc: "acceleration of free fall",
    },
    Quantity {
        name: "rocker.length",
        unit: "m",
        doc: "length of the bar",
    },
    Quantity {
        name: "rocker.mass",
        unit: "kg",
        doc: "the mass",
    },
    Quantity {
        name: "rocker.inertia",
        unit: "kg m^2",
        doc: "moment of inertia about the centre of mass",
    },
    Quantity {
        name: "rocker.gravity",
        unit: "m/s^2",
        doc: "acceleration of free fall",
    },
];

static PARAMETER_DEFAULTS: [f64; PARAMETERS] = [
    0.22,
    1.5,
    25.0,
    0.1,
    0.5,
    0.00045,
    9.81,
    0.25,
    0.9,
    0.0047,
    9.81,
    0.2,
    0.7,
    0.0024,
    9.81,
];

static OUTPUT_QUANTITIES: [Quantity<'static>; OUTPUTS] = [
    Quantity {
        name: "crank_angle",
        unit: "rad",
        doc: "angle of the bar from sideways",
    },
    Quantity {
        name: "coupler_angle",
        unit: "rad",
        doc: "angle of the bar from sideways",
    },
    Quantity {
        name: "rocker_angle",
        unit: "rad",
        doc: "angle of the bar from sideways",
    },
    Quantity {
        name: "crank_speed",
        unit: "rad/s",
        doc: "rate of angle of the bar from sideways",
    },
    Quantity {
        name: "pin_force_x",
        unit: "N",
        doc: "force of the frame on the crank, sideways",
    },
    Quantity {
        name: "pin_force_y",
        unit: "N",
        doc: "force of the frame on the crank, upwards",
    },
];

/// The run the spec asks for.
pub const RUN_DEFAULTS: RunDefaults<'static> = RunDefaults {
    from: 0.0,
    until: 2.0,
    points: 2001,
    rtol: 1e-8,
    method: "dop853",
};

/// What coordinates must fulfil.
pub static CONSTRAINT_SHAPES: [Constraint<'static>; CONSTRAINTS] = [
    Constraint {
        name: "pin_o_x",
        unit: "m",
        doc: "the crank's pin in the frame, sideways",
        is_of_positions: true,
    },
    Constraint {
        name: "pin_o_y",
        unit: "m",
        doc: "the crank's pin in the frame, upwards",
        is_of_positions: true,
    },
    Constraint {
        name: "pin_a_x",
        unit: "m",
        doc: "pin between crank and coupler, sideways",
        is_of_positions: true,
    },
    Constraint {
        name: "pin_a_y",
        unit: "m",
        doc: "pin between crank and coupler, upwards",
        is_of_positions: true,
    },
    Constraint {
        name: "pin_b_x",
        unit: "m",
        doc: "pin between coupler and rocker, sideways",
        is_of_positions: true,
    },
    Constraint {
        name: "pin_b_y",
        unit: "m",
        doc: "pin between coupler and rocker, upwards",
        is_of_positions: true,
    },
    Constraint {
        name: "pin_c_x",
        unit: "m",
        doc: "the rocker's pin in the frame, sideways",
        is_of_positions: true,
    },
    Constraint {
        name: "pin_c_y",
        unit: "m",
        doc: "the rocker's pin in the frame, upwards",
        is_of_positions: true,
    },
];
